//! `#[device]`: an ordinary function becomes a generator that is cached, documented and registered.
//!
//! See [`macro@device`], and [`macro@Choice`] for enums as parameters. What generated code calls lives in `phidl_core`,
//! so a crate that uses the attribute depends on both.

mod check;
mod choice;
mod expand;
mod model;
mod parse;
mod problems;
mod widen;

use proc_macro::TokenStream;

/// Makes a generator of a function that draws a cell.
#[proc_macro_attribute]
pub fn device(options: TokenStream, function: TokenStream) -> TokenStream {
    device_impl(options.into(), function.into()).into()
}

/// Lets an enum of bare words be a parameter.
#[proc_macro_derive(Choice, attributes(choice))]
pub fn choice(input: TokenStream) -> TokenStream {
    choice::derive(input.into()).into()
}

fn device_impl(options: proc_macro2::TokenStream, function: proc_macro2::TokenStream) -> proc_macro2::TokenStream {
    let function: parse::Function = match syn::parse2(function.clone()) {
        Ok(function) => function,
        Err(error) => return [error.into_compile_error(), function].into_iter().collect(),
    };
    let mut problems = problems::Problems::default();
    check::signature(&function.signature, &mut problems);
    let generator = parse::generator(options, function.clone(), &mut problems);
    check::generator(&generator, &mut problems);
    match problems.into_tokens() {
        Some(errors) => [errors, function.plain()].into_iter().collect(),
        None => expand::expand(&generator),
    }
}
