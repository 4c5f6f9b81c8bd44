//! [`Widen`]: which arguments a parameter of a type accepts, decided by the tokens of the type.
//!
//! Types are all that a macro sees, so a type alias for `Vec<f64>` widens like any other type: through `Into`.

use proc_macro2::{Span, TokenStream};
use quote::{quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{Expr, GenericArgument, PathArguments, PathSegment, Type};

use crate::root;

/// How an argument becomes a parameter.
pub(crate) enum Widen {
    /// As it is: an integer literal could not decide its type otherwise.
    Same,
    /// Through `Into`.
    Into,
    /// Through `IntoOption`.
    Option(Type),
    /// From any iterator.
    List(Type, Box<Widen>),
    /// From pairs of a name and a value.
    Map(Type, Box<Widen>),
}

const SAME: [&str; 12] = ["i8", "i16", "i32", "i64", "u8", "u16", "u32", "u64", "usize", "isize", "bool", "char"];

impl Widen {
    pub(crate) fn of(ty: &Type) -> Self {
        let Some(segment) = last_segment(ty) else { return Self::Into };
        let arguments = type_arguments(segment);
        match (segment.ident.to_string().as_str(), &arguments[..]) {
            (name, []) if SAME.contains(&name) => Self::Same,
            ("Option", [inner]) => Self::Option((*inner).clone()),
            ("Vec", [item]) => Self::List((*item).clone(), Box::new(Self::of(item))),
            ("BTreeMap", [_, item]) => Self::Map((*item).clone(), Box::new(Self::of(item))),
            _ => Self::Into,
        }
    }

    /// The type of an argument that is taken for a parameter of type `ty`.
    pub(crate) fn argument(&self, ty: &Type, root: &TokenStream) -> TokenStream {
        match self {
            Self::Same => quote!(#ty),
            Self::Into => quote!(impl ::core::convert::Into<#ty>),
            Self::Option(inner) => quote!(impl #root::__private::IntoOption<#inner>),
            Self::List(item, widen) => {
                let item = widen.argument(item, root);
                quote!(impl ::core::iter::IntoIterator<Item = #item>)
            }
            Self::Map(item, widen) => {
                let item = widen.argument(item, root);
                quote!(impl ::core::iter::IntoIterator<Item = (impl ::core::convert::Into<::std::string::String>, #item)>)
            }
        }
    }

    /// The parameter made of an argument.
    pub(crate) fn convert(&self, argument: TokenStream, root: &TokenStream) -> TokenStream {
        let span = argument.span();
        let (function, root) = (self.function(span, root), &root::at(root, span));
        match self {
            Self::Same => argument,
            Self::Into | Self::Option(_) => quote_spanned!(span=> #function(#argument)),
            Self::List(_, item) => {
                let item = item.function(span, root);
                quote_spanned!(span=> #root::__private::list(#argument, #item))
            }
            Self::Map(_, item) => {
                let item = item.function(span, root);
                quote_spanned!(span=> #root::__private::map(#argument, #item))
            }
        }
    }

    /// The default made of its expression.
    pub(crate) fn convert_default(&self, default: &Expr, root: &TokenStream) -> TokenStream {
        match self {
            // An empty list has no element type to convert from.
            Self::List(..) | Self::Map(..) if is_empty(default) => quote!(::core::default::Default::default()),
            _ => self.convert(quote!(#default), root),
        }
    }

    /// A function of one argument that converts it.
    fn function(&self, span: Span, root: &TokenStream) -> TokenStream {
        let root = &root::at(root, span);
        match self {
            Self::Same => quote_spanned!(span=> ::core::convert::identity),
            Self::Into => quote_spanned!(span=> #root::__private::widen),
            Self::Option(_) => quote_spanned!(span=> #root::__private::option),
            Self::List(_, item) => {
                let item = item.function(span, root);
                quote_spanned!(span=> |items| #root::__private::list(items, #item))
            }
            Self::Map(_, item) => {
                let item = item.function(span, root);
                quote_spanned!(span=> |items| #root::__private::map(items, #item))
            }
        }
    }
}

/// The name at the end of a type: `Vec<f64>` of `std::vec::Vec<f64>`.
pub(crate) fn last_segment(ty: &Type) -> Option<&PathSegment> {
    match ty {
        Type::Path(path) if path.qself.is_none() => path.path.segments.last(),
        Type::Group(group) => last_segment(&group.elem),
        Type::Paren(paren) => last_segment(&paren.elem),
        _ => None,
    }
}

/// The types in angle brackets.
pub(crate) fn type_arguments(segment: &PathSegment) -> Vec<&Type> {
    let PathArguments::AngleBracketed(arguments) = &segment.arguments else { return Vec::new() };
    let types = arguments.args.iter().filter_map(|argument| match argument {
        GenericArgument::Type(ty) => Some(ty),
        _ => None,
    });
    types.collect()
}

fn is_empty(default: &Expr) -> bool {
    match default {
        Expr::Array(array) => array.elems.is_empty(),
        Expr::Macro(call) => call.mac.path.is_ident("vec") && call.mac.tokens.is_empty(),
        Expr::Call(call) => {
            let Expr::Path(path) = &*call.func else { return false };
            call.args.is_empty() && path.path.segments.last().is_some_and(|last| last.ident == "new")
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use syn::parse_quote;

    fn argument(ty: &Type) -> String {
        Widen::of(ty).argument(ty, &quote!(::phidl_core)).to_string().replace(' ', "").replace("::core::convert::", "")
    }

    #[test]
    fn integers_stay_what_they_are_and_numbers_widen() {
        assert_eq!(argument(&parse_quote!(usize)), "usize");
        assert_eq!(argument(&parse_quote!(f64)), "implInto<f64>");
        assert_eq!(argument(&parse_quote!(pg::Shape)), "implInto<pg::Shape>");
    }

    #[test]
    fn options_and_lists_are_seen_by_their_last_name() {
        assert_eq!(argument(&parse_quote!(std::option::Option<f64>)), "impl::phidl_core::__private::IntoOption<f64>");
        assert_eq!(argument(&parse_quote!(Vec<usize>)), "impl::core::iter::IntoIterator<Item=usize>");
        assert_eq!(argument(&parse_quote!(Vec<Point>)), "impl::core::iter::IntoIterator<Item=implInto<Point>>");
    }
}
