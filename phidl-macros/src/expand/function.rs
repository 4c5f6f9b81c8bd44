//! The function that is called: a thin shell that fills the parameter struct and has it built.

use proc_macro2::TokenStream;
use quote::quote;

use super::docs;
use super::params::default_name;
use crate::model::Generator;

pub(super) fn expand(generator: &Generator) -> TokenStream {
    let Generator { attributes, visibility, name, struct_name, output, .. } = generator;
    let (cfgs, others) = (&attributes.cfgs, &attributes.others);
    // An expectation is about the body; the shell would not fulfill it.
    let lints = attributes.lints.iter().filter(|lint| !lint.path().is_ident("expect"));
    let lines = docs::attributes(&attributes.docs);
    let list =
        (!generator.params.is_empty()).then(|| docs::parameter_list(generator)).map(|list| quote!(#[doc = #list]));
    let arguments = generator.arguments().map(|param| {
        let (name, ty) = (&param.name, param.widen.argument(&param.ty));
        quote!(#name: #ty)
    });
    let fields = generator.params.iter().map(|param| {
        let name = &param.name;
        let value = match param.named {
            None => param.widen.convert(quote!(#name)),
            Some(_) => {
                let default = default_name(param);
                quote!(#struct_name::#default())
            }
        };
        quote!(#name: #value)
    });
    quote! {
        #lines
        #list
        #(#cfgs)*
        #(#others)*
        #(#lints)*
        #[allow(dead_code, reason = "the registry calls the generator")]
        #[allow(clippy::too_many_arguments, reason = "they have names in the struct")]
        #visibility fn #name(#(#arguments),*) -> #output {
            ::phidl_core::__private::Generator::build(&#struct_name { #(#fields),* })
        }
    }
}
