//! Paths, cross-sections and extrusion.
//!
//! <div>
#![doc = include_str!("../docs/pieces.svg")]
//! </div>
//!
//! | word | is |
//! |---|---|
//! | [`Path`] | a centerline: points with a direction at each end |
//! | [`Path::arc`], [`Path::euler`], [`Path::straight`], [`Spiral`] | the pieces it is made of |
//! | [`ArcBend`], [`EulerBend`] | the shapes of bends, with options; what [`Path::smooth`] puts at corners |
//! | [`CrossSection`] of [`Section`]s | what is drawn along it: widths and offsets, layers, ports |
//! | [`Path::extrude`] | path × cross-section → [`Device`](phidl_core::scene::Device) |
//! | [`transition`] | a cross-section that changes into another one along the way |
//!
//! ```
//! use phidl_path::{CrossSection, Path, Section};
//!
//! let x = CrossSection::new()
//!     .add(Section::new(0.5).layer(1).ports("in", "out"))
//!     .add(Section::new(2).offset(3).layer(2));
//! let mut path = Path::arc(10, 90)?;
//! path.append(Path::straight(5)?);
//! let waveguide = path.extrude(&x)?;
//! assert_eq!(waveguide.port("in")?.orientation(), 180.0);
//! # Ok::<(), phidl_core::Error>(())
//! ```
//!
//! Lengths are micrometers, angles degrees counter-clockwise; an offset is positive to the right of the path. Points are
//! those of the specification, or with [`Path::with_tolerance`] the fewest that keep a tolerance.

mod bend;
mod cross_section;
mod curvature;
mod curve;
mod direction;
mod extrude;
mod fold;
mod hash;
mod interpolate;
mod miters;
mod offset;
mod path;
mod piece;
mod profile;
mod rule;
mod sampling;
mod section;
mod smooth;
mod transition;

pub use bend::{ArcBend, Bend, EulerBend};
pub use cross_section::CrossSection;
pub use curve::Spiral;
pub use extrude::Extrusion;
pub use fold::{Fold, Side};
pub use interpolate::Station;
pub use path::Path;
pub use piece::Piece;
pub use profile::Profile;
pub use section::Section;
pub use transition::{WidthChange, transition};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

#[cfg(doctest)]
#[doc = include_str!("../docs/waveguide_tutorial.md")]
struct Tutorial;
