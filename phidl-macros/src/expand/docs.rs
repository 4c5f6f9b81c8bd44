//! Documentation that is made of what the attributes say.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::ext::IdentExt;
use syn::{Expr, ExprLit, Lit};

use crate::model::{Generator, Parameter};
use crate::unit;

/// Lines of documentation as attributes.
pub(super) fn attributes(docs: &[Expr]) -> TokenStream {
    docs.iter().map(|line| quote!(#[doc = #line])).collect()
}

/// The documentation of the function: its lines, and its drawing under the first paragraph.
///
/// The drawing is inline HTML, so that it needs no server and takes the colors of the page. The registry does without.
pub(super) fn of_function(generator: &Generator) -> TokenStream {
    let docs = &generator.attributes.docs;
    let Some(file) = &generator.options.picture else { return attributes(docs) };
    let blank = |doc: &Expr| matches!(doc, Expr::Lit(ExprLit { lit: Lit::Str(line), .. }) if line.value().is_empty());
    let (summary, rest) = docs.split_at(docs.iter().position(blank).unwrap_or(docs.len()));
    let (summary, rest) = (attributes(summary), attributes(rest));
    quote! {
        #summary
        #[doc = "\n<div>"]
        #[doc = ::core::include_str!(::core::concat!(::core::env!("CARGO_MANIFEST_DIR"), "/", #file))]
        #[doc = "</div>\n"]
        #rest
    }
}

/// The call that draws the example, as it would be written: `RingParams::default()`. Empty if there is no example.
pub(super) fn example(generator: &Generator) -> String {
    match &generator.options.example {
        Some(example) => source(example),
        None if generator.required().next().is_none() => format!("{}::default()", generator.struct_name),
        None => String::new(),
    }
}

/// Documentation as one text, for the registry. Lines may be macros, such as `include_str!`.
pub(super) fn text(docs: &[Expr]) -> TokenStream {
    match literal(docs) {
        Some(text) => text.to_token_stream(),
        None => quote!(::core::concat!(#(#docs, "\n"),*)),
    }
}

fn literal(docs: &[Expr]) -> Option<String> {
    let line = |doc: &Expr| match doc {
        Expr::Lit(ExprLit { lit: Lit::Str(line), .. }) => Some(line.value()),
        _ => None,
    };
    Some(docs.iter().map(line).collect::<Option<Vec<_>>>()?.join("\n"))
}

/// The list of parameters that is appended to the documentation of the function, unless the user wrote one.
pub(super) fn parameter_list(generator: &Generator) -> Option<String> {
    let heading = "\n# Parameters\n";
    let written = literal(&generator.attributes.docs).is_some_and(|text| format!("\n{text}").contains(heading));
    if generator.params.is_empty() || written {
        return None;
    }
    let mut list = format!(
        "{heading}They are the fields of [`{}`]. A number that is not finite or out of its bounds is refused.\n",
        generator.struct_name
    );
    for param in &generator.params {
        let text = literal(&param.docs).unwrap_or_default();
        let text = text.split("\n\n").next().unwrap_or_default().trim().replace('\n', " ");
        let separator = if text.is_empty() { "" } else { ": " };
        let note = if param.named.is_some() { " (a field only)" } else { "" };
        list += &format!("- `{}`{note}{separator}{text}{}\n", param.name, in_brackets(&notes(param)));
    }
    Some(list)
}

/// What is appended to the documentation of a field.
pub(super) fn field_notes(param: &Parameter) -> String {
    let mut notes = notes(param);
    if param.name.unraw() != param.registered.value() {
        notes.push(format!("registered as `{}`", param.registered.value()));
    }
    let line = notes.join("; ");
    if param.docs.is_empty() {
        return format!("The parameter `{}`{}.", param.name, in_brackets(&notes));
    }
    if line.is_empty() { line } else { format!("\n*{line}*") }
}

fn in_brackets(notes: &[String]) -> String {
    if notes.is_empty() { String::new() } else { format!(" ({})", notes.join("; ")) }
}

/// Unit, bounds and default as text.
fn notes(param: &Parameter) -> Vec<String> {
    let mut notes = Vec::new();
    if let Some(sign) = param.unit.as_ref().and_then(|unit| unit::sign(&unit.value())) {
        notes.push(format!("in {}", if sign == "°" { "degrees" } else { sign }));
    }
    let sides = [("min", "at least"), ("above", "more than"), ("max", "at most"), ("below", "less than")];
    let bounds = sides.iter().filter_map(|(side, words)| Some(format!("{words} {}", param.bound(side)?)));
    notes.extend(bounds.reduce(|a, b| format!("{a}, {b}")));
    notes.extend(param.default.as_ref().map(|default| format!("default `{}`", source(default))));
    notes
}

/// An expression about as it was written.
fn source(default: &Expr) -> String {
    // Long expressions come in several lines.
    let text = default.to_token_stream().to_string().split_whitespace().collect::<Vec<_>>().join(" ");
    let mut source = String::new();
    for (i, c) in text.char_indices() {
        let rest = &text[i + c.len_utf8()..];
        let closed = c == ' '
            && (source.ends_with(['(', '[', '.', ':', '!', '-'])
                || rest.starts_with([')', ']', '(', ',', '.', ':', '!', '?']) && !source.ends_with(','));
        if !closed {
            source.push(c);
        }
    }
    source
}

#[cfg(test)]
mod tests {
    use super::*;
    use syn::parse_quote;

    #[test]
    fn a_picture_is_under_the_first_paragraph_with_blank_lines_around() {
        let source = quote! {
            /// Draws a pad,
            /// a square one.
            ///
            /// It has no ports.
            #[device]
            fn pad() -> Result<Device> { body }
        };
        let code = crate::device_impl(quote!(picture = "docs/pad.svg"), source).to_string();
        let position = |text: &str| code.find(text).unwrap_or_else(|| panic!("{text} is not in {code}"));
        let order =
            ["a square one.", r#""\n<div>""#, "docs/pad.svg", r#""</div>\n""#, "It has no ports."].map(position);
        assert!(order.is_sorted(), "{code}");
    }

    #[test]
    fn defaults_are_shown_as_they_were_written() {
        let shown = |default: Expr| source(&default);
        assert_eq!(shown(parse_quote!((4, 2))), "(4, 2)");
        assert_eq!(shown(parse_quote!([1, 2, 4])), "[1, 2, 4]");
        assert_eq!(shown(parse_quote!(-0.5)), "-0.5");
        assert_eq!(shown(parse_quote!(Shape::Round)), "Shape::Round");
        assert_eq!(shown(parse_quote!(Some(Size::new(1.0, (2.0))))), "Some(Size::new(1.0, (2.0)))");
        assert_eq!(
            shown(parse_quote!(Params::new(disc(1, 2)?, "not").x(3))),
            r#"Params::new(disc(1, 2)?, "not").x(3)"#
        );
    }
}
