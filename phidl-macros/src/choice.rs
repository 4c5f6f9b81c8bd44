//! `#[derive(Choice)]`: enums without data as parameters, each variant under a name.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Attribute, Data, DeriveInput, Fields, LitStr, Meta, Path, Variant};

use crate::problems::Problems;
use crate::root;

pub(crate) fn derive(input: TokenStream) -> TokenStream {
    let input: DeriveInput = match syn::parse2(input) {
        Ok(input) => input,
        Err(error) => return error.into_compile_error(),
    };
    let mut problems = Problems::default();
    let variants = named_variants(&input, &mut problems);
    let given = crate_option(&input.attrs, &mut problems);
    problems.into_tokens().unwrap_or_else(|| expand(&input, &variants, &root::path(given.as_ref())))
}

/// The variants with their names.
fn named_variants(input: &DeriveInput, problems: &mut Problems) -> Vec<(syn::Ident, LitStr)> {
    let Data::Enum(data) = &input.data else {
        problems.at(&input.ident, "only an enum can be a choice");
        return Vec::new();
    };
    if !input.generics.params.is_empty() {
        problems.at(&input.generics, "a choice cannot be generic");
    }
    if data.variants.is_empty() {
        problems.at(&input.ident, "a choice needs at least one variant");
    }
    let mut named: Vec<(syn::Ident, LitStr)> = Vec::new();
    for variant in &data.variants {
        if !matches!(variant.fields, Fields::Unit) {
            problems.at(&variant.fields, "a variant of a choice cannot have fields");
        }
        let name = name(variant, problems);
        if named.iter().any(|(_, other)| other.value().eq_ignore_ascii_case(&name.value())) {
            problems.at(&name, format_args!("two variants are named `{}`", name.value()));
        }
        named.push((variant.ident.clone(), name));
    }
    named
}

/// The text of `#[choice("…")]`, or the name of the variant in snake case.
fn name(variant: &Variant, problems: &mut Problems) -> LitStr {
    let mut given = None;
    for attribute in attributes(&variant.attrs) {
        if given.is_some() {
            problems.at(attribute, "the name of a variant is given twice");
        }
        let text = match &attribute.meta {
            Meta::List(_) => attribute.parse_args(),
            other => Err(syn::Error::new_spanned(other, "a name stands in parentheses: `#[choice(\"x\")]`")),
        };
        given = problems.keep(text).or(given);
    }
    given.unwrap_or_else(|| LitStr::new(&snake_case(&variant.ident.to_string()), variant.ident.span()))
}

/// The path of `#[choice(crate = …)]` on the enum.
fn crate_option(attrs: &[Attribute], problems: &mut Problems) -> Option<Path> {
    let mut given = None;
    for attribute in attributes(attrs) {
        let read = attribute.parse_nested_meta(|meta| {
            if !meta.path.is_ident("crate") {
                return Err(meta.error("an enum takes the option `crate = …`; a name stands at a variant"));
            }
            given = Some(meta.value()?.parse()?);
            Ok(())
        });
        let _noted = problems.keep(read);
    }
    given
}

fn attributes(attrs: &[Attribute]) -> impl Iterator<Item = &Attribute> {
    attrs.iter().filter(|attribute| attribute.path().is_ident("choice"))
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

fn expand(input: &DeriveInput, named: &[(syn::Ident, LitStr)], root: &TokenStream) -> TokenStream {
    let name = &input.ident;
    let (variants, names): (Vec<_>, Vec<_>) = named.iter().map(|(variant, name)| (variant, name)).unzip();
    quote! {
        #[automatically_derived]
        impl #root::__private::Param for #name {
            fn param_type() -> #root::__private::ParamType {
                #root::__private::ParamType::Choice(&[#(#names),*])
            }

            fn to_value(&self) -> #root::__private::Value {
                #root::__private::choice_value(match self {
                    #(Self::#variants => #names),*
                })
            }

            fn from_value(
                value: &#root::__private::Value,
            ) -> ::core::result::Result<Self, #root::__private::ConversionError> {
                let choices = [#(Self::#variants),*];
                let index = #root::__private::choice_index(value, &[#(#names),*])?;
                ::core::result::Result::Ok(::core::clone::Clone::clone(&choices[index]))
            }
        }

        #[automatically_derived]
        impl #root::__private::IntoOption<#name> for #name {
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
    fn names_are_variants_in_snake_case() {
        assert_eq!(snake_case("Fillet"), "fillet");
        assert_eq!(snake_case("AllAround"), "all_around");
    }
}
