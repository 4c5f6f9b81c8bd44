//! The attributes of the function and of its parameters.

use proc_macro2::Ident;
use syn::{Attribute, Expr, ExprLit, Lit, LitStr, Meta};

use super::options::{self, Item};
use crate::model::{Attributes, Bound};
use crate::problems::Problems;

/// The levels of lints.
const LEVELS: [&str; 5] = ["allow", "expect", "warn", "deny", "forbid"];

/// Sorts the attributes of the function by where they go.
pub(crate) fn of_function(attributes: Vec<Attribute>) -> Attributes {
    let mut sorted = Attributes::default();
    for attribute in attributes {
        if let Some(text) = doc_text(&attribute) {
            sorted.docs.push(text);
        } else if attribute.path().is_ident("cfg") {
            sorted.cfgs.push(attribute);
        } else if is_lint(&attribute) {
            sorted.lints.push(attribute);
        } else {
            sorted.others.push(attribute);
        }
    }
    sorted
}

/// What the attributes of a parameter say.
#[derive(Default)]
pub(crate) struct OfParameter {
    pub(crate) docs: Vec<Expr>,
    pub(crate) lints: Vec<Attribute>,
    pub(crate) default: Option<Expr>,
    pub(crate) registered: Option<LitStr>,
    pub(crate) unit: Option<LitStr>,
    pub(crate) bounds: Vec<Bound>,
    pub(crate) named: Option<Ident>,
}

/// Reads the attributes of a parameter.
pub(crate) fn of_parameter(attributes: Vec<Attribute>, problems: &mut Problems) -> OfParameter {
    let mut said = OfParameter::default();
    let mut params = syn::punctuated::Punctuated::new();
    for attribute in attributes {
        if let Some(text) = doc_text(&attribute) {
            said.docs.push(text);
        } else if is_lint(&attribute) {
            said.lints.push(attribute);
        } else if attribute.path().is_ident("default") {
            default(&mut said, &attribute, problems);
        } else if attribute.path().is_ident("param") {
            let list = problems.keep(attribute.parse_args_with(options::list));
            params.extend(list.into_iter().flatten());
        } else {
            problems.at(
                &attribute,
                "a parameter can have documentation, `#[default(…)]`, `#[param(…)]` and lint levels only",
            );
        }
    }
    let known = ["name", "unit", "min", "above", "max", "below", "named"];
    for item in options::items(params, &known, problems) {
        option(&mut said, item, problems);
    }
    said
}

fn default(said: &mut OfParameter, attribute: &Attribute, problems: &mut Problems) {
    if said.default.is_some() {
        problems.at(attribute, "the default is given twice");
    }
    match &attribute.meta {
        Meta::List(list) if !list.tokens.is_empty() => {
            let expression = attribute.parse_args();
            let expression =
                expression.map_err(|e| syn::Error::new(e.span(), format_args!("a default is one expression: {e}")));
            said.default = problems.keep(expression);
        }
        other => problems.at(other, "a default stands in parentheses: `#[default(10.0)]`"),
    }
}

fn option(said: &mut OfParameter, item: Item, problems: &mut Problems) {
    match item.name.to_string().as_str() {
        "name" => said.registered = item.text(problems),
        "unit" => said.unit = item.text(problems),
        "named" => said.named = Some(item.flag(problems)),
        _ => {
            let side = item.name.clone();
            said.bounds.extend(item.number(problems).map(|limit| Bound { side, limit }));
        }
    }
}

/// The text of a line of documentation, without the blank that `///` leaves in front.
fn doc_text(attribute: &Attribute) -> Option<Expr> {
    let Meta::NameValue(pair) = &attribute.meta else { return None };
    if !pair.path.is_ident("doc") {
        return None;
    }
    match &pair.value {
        Expr::Lit(ExprLit { attrs, lit: Lit::Str(line) }) => {
            let text = line.value();
            let text = LitStr::new(text.strip_prefix(' ').unwrap_or(&text), line.span());
            Some(Expr::Lit(ExprLit { attrs: attrs.clone(), lit: Lit::Str(text) }))
        }
        other => Some(other.clone()),
    }
}

fn is_lint(attribute: &Attribute) -> bool {
    LEVELS.iter().any(|level| attribute.path().is_ident(level))
}
