//! The function that is called: a thin shell that fills the parameter struct and builds it.

use proc_macro2::TokenStream;
use quote::{quote, quote_spanned};
use syn::spanned::Spanned;

use super::docs;
use super::params::{default_name, field_from_argument};
use crate::model::Generator;
use crate::root;

pub(super) fn expand(generator: &Generator) -> TokenStream {
    let Generator { attributes, visibility, name, struct_name, output, root, .. } = generator;
    let (cfgs, others) = (&attributes.cfgs, &attributes.others);
    // An expectation is about the body; the shell would not fulfill it.
    let lints = attributes.lints.iter().filter(|lint| !lint.path().is_ident("expect"));
    let lines = docs::of_function(generator);
    let list = docs::parameter_list(generator).map(|list| quote!(#[doc = #list]));
    let arguments = generator.arguments().map(|param| {
        let (name, ty) = (&param.name, param.widen.argument(&param.ty, root));
        quote!(#name: #ty)
    });
    let fields = generator.params.iter().map(|param| match param.named {
        None => field_from_argument(param, root),
        Some(_) => {
            let (name, default) = (&param.name, default_name(param));
            quote!(#name: #struct_name::#default())
        }
    });
    // At the result, which may be another `Result`.
    let root = root::at(root, output.span());
    let build = quote_spanned!(output.span()=> #root::__private::Generator::build(&#struct_name { #(#fields),* }));
    quote! {
        #lines
        #list
        #(#cfgs)*
        #(#others)*
        #(#lints)*
        #[allow(dead_code, reason = "the registry calls the generator")]
        #[allow(clippy::too_many_arguments, reason = "they have names in the struct")]
        #visibility fn #name(#(#arguments),*) -> #output {
            #build
        }
    }
}
