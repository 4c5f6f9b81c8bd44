//! Paths, cross-sections and extrusion.
//!
//! <div>
#![doc = include_str!("../docs/pieces.svg")]
//! </div>
//!
//! | item | meaning |
//! |---|---|
//! | [`Path`] | a centerline: points with a direction at each end |
//! | [`Path::arc`], [`Path::euler`], [`Path::straight`], [`Spiral`] | the pieces of a path |
//! | [`ArcBend`], [`EulerBend`] | the shapes of bends, with options; [`Path::smooth`] draws them at corners |
//! | [`CrossSection`] of [`Section`]s | the bands along a path: widths and offsets, layers, ports |
//! | [`Path::extrude`] | path × cross-section → [`Device`](phidl_core::scene::Device) |
//! | [`transition`] | a cross-section that changes into another one along the path |
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
//! Lengths are in micrometers, angles in degrees counter-clockwise. An offset is positive to the right of the path. Points
//! are PHIDL's, or with [`Path::with_tolerance`] the fewest that keep a tolerance.

mod band;
mod bend;
mod cross_section;
mod curvature;
mod curve;
mod direction;
mod extrude;
mod hash;
mod interpolate;
mod normals;
mod offset;
mod overlap;
mod path;
mod piece;
mod profile;
mod rule;
mod sampling;
mod section;
mod side;
mod smooth;
mod transition;

pub use bend::{ArcBend, Bend, EulerBend};
pub use cross_section::CrossSection;
pub use curve::Spiral;
pub use extrude::{Extrusion, Overlaps};
pub use interpolate::PathPoint;
pub use overlap::{OverlapCause, SelfOverlap};
pub use path::Path;
pub use piece::Piece;
pub use profile::Profile;
pub use section::{Beside, Section};
pub use side::Side;
pub use transition::{TransitionShape, transition};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
