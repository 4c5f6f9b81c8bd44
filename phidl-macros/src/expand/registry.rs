//! The `Generator` implementation with the body in it, and the entry in the registry.

use proc_macro2::{Ident, TokenStream};
use quote::{quote, quote_spanned};
use syn::spanned::Spanned;

use super::docs;
use super::params::default_name;
use crate::model::{CHECK, Generator, Parameter};
use crate::{root, unit};

pub(super) fn expand(generator: &Generator) -> TokenStream {
    let (cfgs, struct_name, root) = (&generator.attributes.cfgs, &generator.struct_name, &generator.root);
    let (entry, record, read) = (entry(generator), record(generator), read(generator));
    let (defaults, options, draw) = (defaults(generator), options(generator), draw(generator));
    quote! {
        #(#cfgs)*
        impl #root::__private::Generator for #struct_name {
            #entry
            #record
            #read
            #defaults
            #options
            #draw
        }
        #(#cfgs)*
        #root::__private::inventory::submit! {
            #root::__private::Registered(<#struct_name as #root::__private::Generator>::entry)
        }
    }
}

fn entry(generator: &Generator) -> TokenStream {
    let Generator { registered, struct_name, attributes, params, options, root, .. } = generator;
    let docs = docs::text(&attributes.docs);
    let rows = params.iter().map(|param| row(param, root));
    let example = docs::example(generator);
    let picture = options.picture.as_ref().map(|file| quote!(.pictured(#file)));
    let naming = options.cell_name.as_ref().map(|template| quote!(.naming_cells(#template)));
    let uncached = options.no_cache.then(|| quote!(.uncached()));
    quote! {
        fn entry() -> &'static #root::__private::GeneratorInfo {
            static __ENTRY: #root::__private::GeneratorInfo = #root::__private::GeneratorInfo::new::<#struct_name>(
                #registered,
                ::core::module_path!(),
                ::core::env!("CARGO_PKG_VERSION"),
                #docs,
                &[#(#rows),*],
            )
            .called(#example) #picture #naming #uncached;
            &__ENTRY
        }
    }
}

fn row(param: &Parameter, root: &TokenStream) -> TokenStream {
    let Parameter { registered, ty, .. } = param;
    let docs = docs::text(&param.docs);
    let unit = match &param.unit {
        None => quote!(#root::__private::Unit::NONE),
        Some(name) => {
            let sign = unit::sign(&name.value());
            quote!(#root::__private::Unit::new(#name, #sign))
        }
    };
    let sides = param.bounds.iter().map(|bound| {
        let (side, limit) = (&bound.side, bound.limit);
        quote!(#side: ::core::option::Option::Some(#limit))
    });
    // At the type, where it says that it cannot be a parameter, if so.
    let at_type = root::at(root, ty.span());
    let new = quote_spanned!(ty.span()=> #at_type::__private::ParamSpec::new::<#ty>);
    quote! {
        #new(#registered, #docs, #unit, #root::__private::Bounds { #(#sides,)* ..#root::__private::Bounds::NONE })
    }
}

fn record(generator: &Generator) -> TokenStream {
    let root = &generator.root;
    let entries = generator.params.iter().map(|param| {
        let Parameter { name, registered, ty, .. } = param;
        let root = root::at(root, ty.span());
        let value = quote_spanned!(ty.span()=> #root::__private::Param::to_value(&self.#name));
        quote!((#registered, #value))
    });
    quote! {
        fn record(&self) -> #root::__private::ParamValues {
            #root::__private::ParamValues::of::<Self, _>([#(#entries),*])
        }
    }
}

fn read(generator: &Generator) -> TokenStream {
    let root = &generator.root;
    let fields = generator.params.iter().enumerate().map(|(i, param)| {
        let (name, default, ty) = (&param.name, default_name(param), &param.ty);
        match &param.default {
            Some(_) => quote_spanned!(ty.span()=> #name: __from.or(#i, Self::#default)?),
            None => quote_spanned!(ty.span()=> #name: __from.required(#i)?),
        }
    });
    quote! {
        fn read(__from: &#root::__private::ParamReader<'_>) -> #root::__private::Result<Self> {
            ::core::result::Result::Ok(Self { #(#fields),* })
        }
    }
}

fn defaults(generator: &Generator) -> TokenStream {
    let root = &generator.root;
    let defaults = generator.params.iter().map(|param| {
        let (default, ty) = (default_name(param), &param.ty);
        match &param.default {
            Some(_) => {
                let root = root::at(root, ty.span());
                let value = quote_spanned!(ty.span()=> #root::__private::Param::to_value(&Self::#default()));
                quote!(::core::option::Option::Some(#value))
            }
            None => quote!(::core::option::Option::None),
        }
    });
    quote! {
        fn defaults() -> ::std::vec::Vec<::core::option::Option<#root::__private::Value>> {
            ::std::vec![#(#defaults),*]
        }
    }
}

fn options(generator: &Generator) -> TokenStream {
    let root = &generator.root;
    let example = generator.options.example.as_ref().map(|example| {
        quote! {
            fn example() -> #root::__private::Result<Self> {
                ::core::result::Result::Ok(#example)
            }
        }
    });
    quote!(#example)
}

/// The body, as a function of its own: `return` and `?` mean what they mean in the source. The one name that it sees
/// and that the user did not write is `check`, as if it stood between the braces of the body.
fn draw(generator: &Generator) -> TokenStream {
    let Generator { attributes, params, output, body, root, .. } = generator;
    let lints = &attributes.lints;
    let check = Ident::new(CHECK, body.span());
    let arguments = params.iter().map(|param| {
        let Parameter { lints, mutability, name, ty, .. } = param;
        quote!(#(#lints)* #mutability #name: #ty)
    });
    let values = params.iter().map(|param| {
        let name = &param.name;
        quote!(self.#name)
    });
    let at_output = root::at(root, output.span());
    let call = quote_spanned!(output.span()=> __draw(#at_output::__private::check::<Self>(), #(#values),*));
    quote! {
        fn draw(self) -> #root::__private::Result<#root::__private::Device> {
            #(#lints)*
            #[allow(clippy::too_many_arguments, reason = "they have names in the struct")]
            #[allow(clippy::needless_pass_by_value, reason = "the body owns its parameters")]
            fn __draw(
                #[allow(unused_variables, reason = "not every body has rules")] #check: #root::__private::Check<'_>,
                #(#arguments),*
            ) -> #output #body
            #call
        }
    }
}
