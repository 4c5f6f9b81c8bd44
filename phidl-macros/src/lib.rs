//! `#[device]`: an ordinary function becomes a generator that is cached, documented and registered.
//!
//! See [`macro@device`], and [`macro@Choice`] for enums as parameters. Generated code calls `phidl-core`, either
//! directly or through `phidl`, whichever the crate depends on.

mod check;
mod choice;
mod expand;
mod model;
mod parse;
mod problems;
mod root;
mod unit;
mod widen;

use proc_macro::TokenStream;

/// Turns a function that draws a cell into a generator: cached, registered, called by position or by name.
///
/// ```
/// use phidl_core::prelude::*;
/// use phidl_macros::device;
///
/// /// Draws a pad with a port on its right.
/// #[device]
/// pub fn pad(
///     /// Width and height.
///     #[default((40, 20))]
///     #[param(unit = "um", above = 0)]
///     size: Size,
///     /// Where it is drawn.
///     #[default(0)]
///     layer: Layers,
///     /// Width of the port, the height of the pad if not given.
///     #[default(None)]
///     #[param(unit = "um", min = 0, named)]
///     port_width: Option<f64>,
/// ) -> Result<Device> {
///     let (w, h) = (size.width, size.height);
///     let mut d = Device::builder("pad");
///     d.add_polygon([(0.0, 0.0), (w, 0.0), (w, h), (0.0, h)], layer)?;
///     d.add_port("e", ((w, h / 2.0), port_width.unwrap_or(h), 0))?;
///     d.build()
/// }
///
/// let a = pad((10, 5.5), 1)?; // by position; an argument may be anything that converts without loss
/// let b = PadParams { size: (10, 5.5).into(), layer: 1.into(), ..Default::default() }.build()?; // by name
/// let c = PadParams::default().size((10, 5.5)).layer(1).build()?; // by setters
/// assert!(a.same_cell(&b) && b.same_cell(&c)); // drawn once
///
/// let error = pad((10, 0), 1).unwrap_err();
/// assert_eq!(error.to_string(), "pad: size.height is 0 µm, but it must be greater than 0 µm");
/// # Ok::<(), phidl_core::Error>(())
/// ```
///
/// # What is generated
/// - the function itself, with its attributes, its visibility, its parameters in their order and a list of them
///   in its documentation. Each parameter takes what converts to it: `f64` any number that fits, `Layers` `7` or
///   `(7, 0)` or a set, `Option<T>` a bare `T` or `None`, `Vec<T>` any iterator. Integers, `bool`
///   and `char` stay as they are, since a literal could otherwise not tell its type;
/// - `<Name>Params`, with a public field for each parameter, one setter of the same name (unless the struct has a
///   method of this name, such as `build`), `build()`; with `Default` if every parameter has a
///   default, otherwise with `new(…)`, which takes those that have none;
/// - an entry in the registry of the program, under the name of the function.
///
/// # Options of the function: `#[device(…)]`
/// | option | meaning |
/// |---|---|
/// | `name = "L"` | another name in the registry |
/// | `cell_name = "W{width}_P{pitch}"` | the name of its cells in files, with the values of parameters in braces: `W0p08_P0p16` |
/// | `crate = my_crate::phidl_core` | the path of `phidl-core` for generated code. Needed only where the crate depends on neither `phidl-core` nor `phidl` under a name of its own |
/// | `no_cache` | the body runs at every call. A caller goes around the cache with `phidl_core::cache::bypass` |
/// | `example = TextParams::new("A")` | what galleries and tests draw; it may use `?`. Needed where there is no default |
/// | `picture = "docs/pad.svg"` | a drawing, shown under the first paragraph of the documentation: the path of an SVG file from the folder of the crate. No blank line may be in it, since that ends HTML in Markdown |
///
/// # Attributes of a parameter
/// | attribute | meaning |
/// |---|---|
/// | `#[default(10)]` | its default, converted like an argument |
/// | `#[param(unit = "um")]` | the unit of its numbers: shown in documentation, in errors and by the registry |
/// | `#[param(min = 0, max = 1)]` | the range of its numbers, both ends included: checked before the body runs, also inside lists, options and pairs |
/// | `#[param(above = 0, below = 1)]` | the same, both ends excluded |
/// | `#[param(name = "R")]` | another name in the registry |
/// | `#[param(named)]` | a field only, and no argument of the function; it needs a default |
///
/// Documentation and levels of lints are carried over. Numbers that are NaN or infinite are always refused.
///
/// # Rules that bounds cannot state
/// The body finds the rules of its generator under the name `check`, a `phidl_core::param::Check`. It knows the name
/// of the generator and the units of its parameters. A function that the body calls takes it as an argument.
///
/// ```
/// use phidl_core::prelude::*;
/// use phidl_macros::device;
///
/// #[device]
/// fn slot(
///     #[param(unit = "um", above = 0)] width: f64,
///     #[param(unit = "um", above = 0)] pitch: f64,
/// ) -> Result<Device> {
///     check.greater("pitch", pitch, ("width", width))?;
///     Device::builder("slot").build()
/// }
///
/// let error = slot(2, 1).unwrap_err();
/// assert_eq!(error.to_string(), "slot: pitch is 1 µm, but it must be greater than width, 2 µm");
/// ```
///
/// # What is refused
/// Methods, generics, `async`, `const`, `unsafe`, borrowed parameters, patterns, another result than `Result<Device>`,
/// options that are unknown or given twice, a default outside of its own bounds: all mistakes at once, each under its
/// own token.
///
/// # Calls that need a hint
/// An empty list has no type to be seen: write `Vec::<f64>::new()`. `Some(5)` for an `Option<f64>` is no float: write
/// `5` or `Some(5.0)`.
#[proc_macro_attribute]
pub fn device(options: TokenStream, function: TokenStream) -> TokenStream {
    device_impl(options.into(), function.into()).into()
}

/// Makes an enum whose variants have no fields a parameter.
///
/// In records and JSON a variant is written as its name in snake case, or as the text of `#[choice("…")]`. Capitals make
/// no difference when it is read. `#[choice(crate = my_crate::phidl_core)]` on the enum is the path of `phidl-core`, as in
/// [`macro@device`].
///
/// ```
/// use phidl_core::param::{Param, Value};
/// use phidl_macros::Choice;
///
/// #[derive(Debug, Clone, Copy, PartialEq, Choice)]
/// enum Corner {
///     Straight,
///     #[choice("fillet")]
///     Round,
/// }
///
/// assert_eq!(Corner::Round.to_value(), Value::from("fillet"));
/// assert_eq!(Corner::from_value(&Value::from("STRAIGHT")).unwrap(), Corner::Straight);
/// assert_eq!(Corner::param_type().to_string(), "one of straight, fillet");
/// ```
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
