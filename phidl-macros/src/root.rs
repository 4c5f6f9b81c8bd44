//! The crate that generated code calls: `phidl-core`, or `phidl`, which passes it on.

use proc_macro_crate::{FoundCrate, crate_name};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use syn::Path;

/// The path in `crate = …`, or the one that the dependencies of the calling crate decide.
///
/// `phidl-core` comes first, since the libraries of this workspace depend on it alone. Where neither is found (a crate
/// that renames the one which it depends on through another), the path is `::phidl_core`, and the compiler says that it
/// is missing.
pub(crate) fn path(given: Option<&Path>) -> TokenStream {
    given.map_or_else(by_dependencies, |path| quote!(#path))
}

/// The path, so that an error in code which begins with it is shown at other tokens.
pub(crate) fn at(root: &TokenStream, span: Span) -> TokenStream {
    let moved = root.clone().into_iter().map(|mut token| {
        token.set_span(span.resolved_at(token.span()));
        token
    });
    moved.collect()
}

fn by_dependencies() -> TokenStream {
    for package in ["phidl-core", "phidl"] {
        match crate_name(package) {
            Ok(FoundCrate::Name(name)) => {
                let name = Ident::new(&name, Span::call_site());
                return quote!(::#name);
            }
            // Its own tests, examples and documentation see it under its name.
            Ok(FoundCrate::Itself) => break,
            Err(_) => {}
        }
    }
    quote!(::phidl_core)
}
