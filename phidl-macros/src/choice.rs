//! `#[derive(Choice)]`: enums of words as parameters.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Data, DeriveInput, Fields, LitStr, Meta, Variant};

use crate::problems::Problems;

pub(crate) fn derive(input: TokenStream) -> TokenStream {
    let input: DeriveInput = match syn::parse2(input) {
        Ok(input) => input,
        Err(error) => return error.into_compile_error(),
    };
    let mut problems = Problems::default();
    let words = words(&input, &mut problems);
    problems.into_tokens().unwrap_or_else(|| expand(&input, &words))
}

/// The variants with their words.
fn words(input: &DeriveInput, problems: &mut Problems) -> Vec<(syn::Ident, LitStr)> {
    let Data::Enum(data) = &input.data else {
        problems.at(&input.ident, "a choice is an enum");
        return Vec::new();
    };
    if !input.generics.params.is_empty() {
        problems.at(&input.generics, "a choice cannot be generic");
    }
    if data.variants.is_empty() {
        problems.at(&input.ident, "a choice needs something to choose from");
    }
    let mut words: Vec<(syn::Ident, LitStr)> = Vec::new();
    for variant in &data.variants {
        if !matches!(variant.fields, Fields::Unit) {
            problems.at(&variant.fields, "a choice is made of bare words");
        }
        let word = word(variant, problems);
        if words.iter().any(|(_, other)| other.value().eq_ignore_ascii_case(&word.value())) {
            problems.at(&word, format_args!("two choices are named `{}`", word.value()));
        }
        words.push((variant.ident.clone(), word));
    }
    words
}

/// The text of `#[choice("…")]`, or the name of the variant in snake case.
fn word(variant: &Variant, problems: &mut Problems) -> LitStr {
    let mut given = None;
    for attribute in variant.attrs.iter().filter(|attribute| attribute.path().is_ident("choice")) {
        if given.is_some() {
            problems.at(attribute, "the word is given twice");
        }
        let text = match &attribute.meta {
            Meta::List(_) => attribute.parse_args(),
            other => Err(syn::Error::new_spanned(other, "a word stands in parentheses: `#[choice(\"x\")]`")),
        };
        given = problems.keep(text).or(given);
    }
    given.unwrap_or_else(|| LitStr::new(&snake_case(&variant.ident.to_string()), variant.ident.span()))
}

fn snake_case(name: &str) -> String {
    let mut snake = String::new();
    for (i, letter) in name.char_indices() {
        if letter.is_uppercase() && i > 0 {
            snake.push('_');
        }
        snake.extend(letter.to_lowercase());
    }
    snake
}

fn expand(input: &DeriveInput, words: &[(syn::Ident, LitStr)]) -> TokenStream {
    let name = &input.ident;
    let (variants, words): (Vec<_>, Vec<_>) = words.iter().map(|(variant, word)| (variant, word)).unzip();
    quote! {
        #[automatically_derived]
        impl ::phidl_core::param::Param for #name {
            fn param_type() -> ::phidl_core::__private::ParamType {
                ::phidl_core::__private::ParamType::Choice(&[#(#words),*])
            }

            fn to_value(&self) -> ::phidl_core::__private::Value {
                ::phidl_core::__private::choice_value(match self {
                    #(Self::#variants => #words),*
                })
            }

            fn from_value(
                value: &::phidl_core::__private::Value,
            ) -> ::core::result::Result<Self, ::phidl_core::__private::ConversionError> {
                let choices = [#(Self::#variants),*];
                let place = ::phidl_core::__private::choice_index(value, &[#(#words),*])?;
                ::core::result::Result::Ok(::core::clone::Clone::clone(&choices[place]))
            }
        }

        #[automatically_derived]
        impl ::phidl_core::param::IntoOption<#name> for #name {
            fn into_option(self) -> ::core::option::Option<#name> {
                ::core::option::Option::Some(self)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_variants_in_snake_case() {
        assert_eq!(snake_case("Fillet"), "fillet");
        assert_eq!(snake_case("AllAround"), "all_around");
    }
}
