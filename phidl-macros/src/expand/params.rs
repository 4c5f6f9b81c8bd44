//! The parameter struct with its constructor, its setters and its defaults.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote, quote_spanned};
use syn::ext::IdentExt;
use syn::spanned::Spanned;

use super::docs;
use crate::model::{Generator, Parameter};
use crate::widen::Widen;

/// Names that mean something else on a parameter struct: such a parameter has a field, but no setter.
const TAKEN: [&str; 10] =
    ["new", "default", "clone", "build", "entry", "record", "example", "read", "defaults", "draw"];

pub(super) fn expand(generator: &Generator) -> TokenStream {
    let declared = declare(generator);
    let constructor = constructor(generator);
    let (cfgs, struct_name, visibility) = (&generator.attributes.cfgs, &generator.struct_name, &generator.visibility);
    let root = &generator.root;
    let with_setter = generator.params.iter().filter(|p| !TAKEN.contains(&p.name.unraw().to_string().as_str()));
    let setters = with_setter.map(|param| setter(param, root));
    let defaults = generator.params.iter().filter_map(|param| default(param, root));
    quote! {
        #declared
        #constructor
        #(#cfgs)*
        #[allow(dead_code, reason = "not every caller needs every form")]
        #[automatically_derived]
        impl #struct_name {
            #(#setters)*
            /// The cell with these parameters: drawn when first asked for, then from the cache.
            ///
            /// # Errors
            /// A bound that a parameter breaks, and what the generator says.
            #visibility fn build(&self) -> #root::__private::Result<#root::__private::Device> {
                #root::__private::Generator::build(self)
            }
            #(#defaults)*
        }
    }
}

fn declare(generator: &Generator) -> TokenStream {
    let (cfgs, struct_name, visibility) = (&generator.attributes.cfgs, &generator.struct_name, &generator.visibility);
    let summary = format!("The parameters of [`{0}`]({0}()).", generator.name.unraw());
    let fields = generator.params.iter().map(|param| {
        let Parameter { name, ty, .. } = param;
        let lines = docs::attributes(&param.docs);
        let notes = docs::field_notes(param);
        quote!(#lines #[doc = #notes] #visibility #name: #ty)
    });
    quote! {
        #[doc = #summary]
        #(#cfgs)*
        #[derive(::core::clone::Clone, ::core::fmt::Debug, ::core::cmp::PartialEq)]
        #[allow(unreachable_pub, dead_code, reason = "as visible as its function")]
        #[allow(clippy::struct_excessive_bools, reason = "they have names")]
        #visibility struct #struct_name { #(#fields),* }
    }
}

/// `Default` if every parameter has one, otherwise `new` with those that have none.
fn constructor(generator: &Generator) -> TokenStream {
    let root = &generator.root;
    let (cfgs, struct_name, visibility) = (&generator.attributes.cfgs, &generator.struct_name, &generator.visibility);
    let fields = generator.params.iter().map(|param| match &param.default {
        None => field_from_argument(param, root),
        Some(_) => {
            let (name, default) = (&param.name, default_name(param));
            quote!(#name: Self::#default())
        }
    });
    if generator.required().next().is_none() {
        return quote! {
            #(#cfgs)*
            #[automatically_derived]
            impl ::core::default::Default for #struct_name {
                fn default() -> Self {
                    Self { #(#fields),* }
                }
            }
        };
    }
    let arguments = generator.required().map(|param| {
        let (name, ty) = (&param.name, param.widen.argument(&param.ty, root));
        quote!(#name: #ty)
    });
    quote! {
        #(#cfgs)*
        #[automatically_derived]
        impl #struct_name {
            /// The parameters that have no default; the others at theirs.
            #[allow(dead_code, clippy::too_many_arguments, reason = "not every caller needs every form")]
            #[must_use]
            #visibility fn new(#(#arguments),*) -> Self {
                Self { #(#fields),* }
            }
        }
    }
}

fn setter(param: &Parameter, root: &TokenStream) -> TokenStream {
    let (name, ty) = (&param.name, param.widen.argument(&param.ty, root));
    let value = param.widen.convert(quote!(#name), root);
    let doc = format!("The same with another `{}`.", name.unraw());
    quote! {
        #[doc = #doc]
        #[must_use]
        pub fn #name(mut self, #name: #ty) -> Self {
            self.#name = #value;
            self
        }
    }
}

/// The default of a parameter as a function, so that its expression stands in the code once.
fn default(param: &Parameter, root: &TokenStream) -> Option<TokenStream> {
    let default = param.default.as_ref()?;
    let (name, ty) = (default_name(param), &param.ty);
    let value = param.widen.convert_default(default, root);
    Some(quote_spanned! {default.span()=>
        fn #name() -> #ty {
            #value
        }
    })
}

pub(super) fn default_name(param: &Parameter) -> Ident {
    format_ident!("__default_{}", param.name.unraw())
}

/// The field in the making of a struct, from an argument of the same name.
pub(super) fn field_from_argument(param: &Parameter, root: &TokenStream) -> TokenStream {
    let name = &param.name;
    match param.widen {
        Widen::Same => quote!(#name),
        _ => {
            let value = param.widen.convert(quote!(#name), root);
            quote!(#name: #value)
        }
    }
}
