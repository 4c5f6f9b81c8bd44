//! From the [model](crate::model) to code; nothing can fail here.
//!
//! The code is short and calls `__private` of phidl-core, where ordinary functions with tests of their own do the work. Every path starts at the root, and every name that a body could see either is the user's or starts with
//! two underscores.

mod docs;
mod function;
mod params;
mod registry;

use proc_macro2::TokenStream;

use crate::model::Generator;

/// The function, its parameter struct, and its entry in the registry.
pub(crate) fn expand(generator: &Generator) -> TokenStream {
    let mut code = function::expand(generator);
    code.extend(params::expand(generator));
    code.extend(registry::expand(generator));
    code
}
