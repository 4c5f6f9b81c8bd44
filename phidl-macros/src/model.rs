//! What a generator is, as plain data: parsed, and not yet expanded.

use proc_macro2::{Ident, TokenStream};
use syn::{Attribute, Expr, LitStr, Token, Type, Visibility};

use crate::widen::Widen;

/// The name under which the body finds the rules of its generator.
pub(crate) const CHECK: &str = "check";

/// A function under `#[device]`.
pub(crate) struct Generator {
    pub(crate) attributes: Attributes,
    pub(crate) visibility: Visibility,
    pub(crate) name: Ident,
    /// The name under which it is registered.
    pub(crate) registered: LitStr,
    /// The crate that generated code calls.
    pub(crate) root: TokenStream,
    /// `<Name>Params`.
    pub(crate) struct_name: Ident,
    pub(crate) params: Vec<Parameter>,
    /// None if it is missing in the source.
    pub(crate) output: Option<Type>,
    /// With its braces.
    pub(crate) body: TokenStream,
    pub(crate) options: Options,
}

/// What stands in `#[device(…)]`, the name aside.
#[derive(Default)]
pub(crate) struct Options {
    pub(crate) no_cache: bool,
    /// The parameters with which galleries and tests draw it.
    pub(crate) example: Option<Expr>,
    /// The template of the names of its cells in files.
    pub(crate) cell_name: Option<LitStr>,
    /// The file of its drawing, from the folder of the crate.
    pub(crate) picture: Option<LitStr>,
}

/// The attributes of the function, by where they go.
#[derive(Default)]
pub(crate) struct Attributes {
    /// The texts of the documentation: literals or macros that make one.
    pub(crate) docs: Vec<Expr>,
    /// `cfg`: to everything that is generated.
    pub(crate) cfgs: Vec<Attribute>,
    /// Levels of lints: to the body, and all but `expect` to the function that is called.
    pub(crate) lints: Vec<Attribute>,
    /// All others: to the function that is called.
    pub(crate) others: Vec<Attribute>,
}

/// A parameter of a generator.
pub(crate) struct Parameter {
    pub(crate) name: Ident,
    pub(crate) mutability: Option<Token![mut]>,
    pub(crate) ty: Type,
    pub(crate) widen: Widen,
    pub(crate) docs: Vec<Expr>,
    /// Levels of lints: to the parameter of the body.
    pub(crate) lints: Vec<Attribute>,
    pub(crate) default: Option<Expr>,
    /// The name under which it is registered.
    pub(crate) registered: LitStr,
    pub(crate) unit: Option<LitStr>,
    pub(crate) bounds: Vec<Bound>,
    /// `named`: in the struct only. The token that says so.
    pub(crate) named: Option<Ident>,
}

/// One limit of `#[param]`.
pub(crate) struct Bound {
    /// `min`, `above`, `max` or `below`.
    pub(crate) side: Ident,
    pub(crate) limit: f64,
}

impl Generator {
    /// The parameters that the function takes.
    pub(crate) fn arguments(&self) -> impl Iterator<Item = &Parameter> {
        self.params.iter().filter(|param| param.named.is_none())
    }

    /// The parameters that must be given.
    pub(crate) fn required(&self) -> impl Iterator<Item = &Parameter> {
        self.params.iter().filter(|param| param.default.is_none())
    }
}

impl Parameter {
    /// The limit on one side.
    pub(crate) fn bound(&self, side: &str) -> Option<f64> {
        self.bounds.iter().find(|bound| bound.side == side).map(|bound| bound.limit)
    }
}
