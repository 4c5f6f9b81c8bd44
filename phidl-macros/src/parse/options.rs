//! Lists of options: `name = "L", no_cache`.

use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Expr, ExprLit, Lit, LitStr, Path, Token, UnOp};

use crate::problems::Problems;

/// One option with its value, if it has one.
pub(crate) struct Item {
    pub(crate) name: Ident,
    value: Option<Expr>,
}

impl Parse for Item {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let name = input.call(Ident::parse_any)?;
        let value = if input.peek(Token![=]) {
            input.parse::<Token![=]>()?;
            Some(input.parse()?)
        } else {
            None
        };
        Ok(Self { name, value })
    }
}

impl Item {
    pub(crate) fn value(self, problems: &mut Problems) -> Option<Expr> {
        if self.value.is_none() {
            problems.at(&self.name, format_args!("option `{0}` needs a value: `{0} = …`", self.name));
        }
        self.value
    }

    /// Notes a value where none belongs.
    pub(crate) fn flag(self, problems: &mut Problems) -> Ident {
        if let Some(value) = &self.value {
            problems.at(value, format_args!("option `{}` takes no value", self.name));
        }
        self.name
    }

    pub(crate) fn text(self, problems: &mut Problems) -> Option<LitStr> {
        let name = self.name.clone();
        match self.value(problems)? {
            Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) if !text.value().trim().is_empty() => Some(text),
            other => {
                problems.at(other, format_args!("option `{name}` takes a text in quotes that is not empty"));
                None
            }
        }
    }

    /// The path of a crate.
    pub(crate) fn path(self, problems: &mut Problems) -> Option<Path> {
        let name = self.name.clone();
        match self.value(problems)? {
            Expr::Path(expr) if expr.qself.is_none() => Some(expr.path),
            other => {
                problems.at(other, format_args!("option `{name}` takes a path, such as `my_crate::phidl_core`"));
                None
            }
        }
    }

    pub(crate) fn number(self, problems: &mut Problems) -> Option<f64> {
        let name = self.name.clone();
        let value = self.value(problems)?;
        let number = number(&value);
        if number.is_none() {
            problems.at(value, format_args!("option `{name}` takes a number literal"));
        }
        number
    }
}

/// The number that an expression writes out, with or without a sign.
pub(crate) fn number(expr: &Expr) -> Option<f64> {
    match expr {
        Expr::Lit(ExprLit { lit: Lit::Float(v), .. }) => v.base10_parse().ok(),
        Expr::Lit(ExprLit { lit: Lit::Int(v), .. }) => v.base10_parse().ok(),
        Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => number(&unary.expr).map(|v| -v),
        Expr::Group(group) => number(&group.expr),
        Expr::Paren(paren) => number(&paren.expr),
        _ => None,
    }
}

/// The options of a list, without those that are unknown or come a second time: they are noted.
pub(crate) fn items(input: Punctuated<Item, Token![,]>, known: &[&str], problems: &mut Problems) -> Vec<Item> {
    let mut seen: Vec<Item> = Vec::new();
    for item in input {
        let name = item.name.to_string();
        if !known.contains(&name.as_str()) {
            problems.at(&item.name, format_args!("there is no option `{name}`; the options are {}", known.join(", ")));
        } else if seen.iter().any(|other| other.name == name) {
            problems.at(&item.name, format_args!("option `{name}` is given twice"));
        } else {
            seen.push(item);
        }
    }
    seen
}

/// The list between the parentheses.
pub(crate) fn list(input: ParseStream<'_>) -> syn::Result<Punctuated<Item, Token![,]>> {
    Punctuated::parse_terminated(input)
}
