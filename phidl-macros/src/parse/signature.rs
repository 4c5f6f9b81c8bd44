//! The function: its signature, its parameters and its body, which is kept as it is.

use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::format_ident;
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream};
use syn::{Attribute, FnArg, LitStr, Pat, PatType, Path, ReturnType, Signature, Visibility};

use super::{attributes, options};
use crate::model::{Generator, Options, Parameter};
use crate::problems::Problems;
use crate::root;
use crate::widen::Widen;

/// The function under the attribute. Its body is not parsed: the compiler will do that once, where it ends up.
#[derive(Clone)]
pub(crate) struct Function {
    pub(crate) attributes: Vec<Attribute>,
    pub(crate) visibility: Visibility,
    pub(crate) signature: Signature,
    pub(crate) body: TokenStream,
}

impl Parse for Function {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let attributes = input.call(Attribute::parse_outer)?;
        let visibility = input.parse()?;
        let signature = input.parse()?;
        let body: TokenTree = input.parse()?;
        Ok(Self { attributes, visibility, signature, body: body.into() })
    }
}

impl Function {
    /// The function without the attributes that only `#[device]` understands, so that editors still know it.
    pub(crate) fn plain(mut self) -> TokenStream {
        self.signature.constness = None; // refused already; the body would only be refused once more
        for input in &mut self.signature.inputs {
            if let FnArg::Typed(typed) = input {
                typed.attrs.clear();
            }
        }
        let Self { attributes, visibility, signature, body } = self;
        // What the parser threw away with the mistakes is not to be reported as unused.
        quote::quote!(#(#attributes)* #[allow(unused, reason = "there are mistakes above")] #visibility #signature #body)
    }
}

/// The generator that a function declares, as far as it can be understood; the rest is noted.
pub(crate) fn generator(options: TokenStream, function: Function, problems: &mut Problems) -> Generator {
    let Function { attributes, visibility, signature, body } = function;
    let Said { registered, root, options } = device_options(options, problems);
    let name = signature.ident.clone();
    let params = signature.inputs.into_iter().filter_map(|input| parameter(input, problems)).collect();
    Generator {
        attributes: attributes::of_function(attributes),
        visibility,
        registered: registered.unwrap_or_else(|| text_of(&name)),
        root: root::path(root.as_ref()),
        struct_name: struct_name(&name),
        name,
        params,
        output: match signature.output {
            ReturnType::Default => None,
            ReturnType::Type(_, ty) => Some(*ty),
        },
        body,
        options,
    }
}

/// What stands in `#[device(…)]`.
#[derive(Default)]
struct Said {
    registered: Option<LitStr>,
    /// The crate that generated code calls.
    root: Option<Path>,
    options: Options,
}

fn device_options(tokens: TokenStream, problems: &mut Problems) -> Said {
    let list = problems.keep(syn::parse::Parser::parse2(options::list, tokens)).unwrap_or_default();
    let mut said = Said::default();
    for item in options::items(list, &["name", "crate", "cell_name", "no_cache", "example", "picture"], problems) {
        match item.name.to_string().as_str() {
            "name" => said.registered = item.text(problems),
            "crate" => said.root = item.path(problems),
            "cell_name" => said.options.cell_name = item.text(problems),
            "example" => said.options.example = item.value(problems),
            "picture" => said.options.picture = item.text(problems),
            _ => {
                item.flag(problems);
                said.options.no_cache = true;
            }
        }
    }
    said
}

fn parameter(input: FnArg, problems: &mut Problems) -> Option<Parameter> {
    let FnArg::Typed(PatType { attrs, pat, ty, .. }) = input else {
        return None; // `self`: noted by the check of the signature
    };
    let said = attributes::of_parameter(attrs, problems);
    let (name, mutability) = match *pat {
        Pat::Ident(pat) if pat.by_ref.is_none() && pat.subpat.is_none() => (pat.ident, pat.mutability),
        other => {
            problems.at(other, "a parameter of a device generator must be a simple name, since it becomes a field");
            return None;
        }
    };
    Some(Parameter {
        registered: said.registered.unwrap_or_else(|| text_of(&name)),
        name,
        mutability,
        widen: Widen::of(&ty),
        ty: *ty,
        docs: said.docs,
        lints: said.lints,
        default: said.default,
        unit: said.unit,
        bounds: said.bounds,
        named: said.named,
    })
}

fn text_of(name: &Ident) -> LitStr {
    LitStr::new(&name.unraw().to_string(), name.span())
}

/// `RingFilterParams` for `ring_filter`.
fn struct_name(function: &Ident) -> Ident {
    let mut camel = String::new();
    for word in function.unraw().to_string().split('_') {
        let mut letters = word.chars();
        camel.extend(letters.next().into_iter().flat_map(char::to_uppercase));
        camel.push_str(letters.as_str());
    }
    format_ident!("{camel}Params", span = function.span())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn structs_are_named_after_their_function() {
        for (function, name) in [("ring", "RingParams"), ("optimal_90deg", "Optimal90degParams"), ("C", "CParams")] {
            assert_eq!(struct_name(&format_ident!("{function}")), name);
        }
    }
}
