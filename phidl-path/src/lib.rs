//! Paths, cross-sections and extrusion.
//!
//! | word | is |
//! |---|---|
//! | [`Path`] | a centerline: points with a direction at each end |
//! | [`ArcBend`], [`EulerBend`], [`Spiral`], [`Path::straight`] | the pieces it is made of |
//! | [`Path::smooth`] | waypoints with bends at their corners |
//! | [`CrossSection`] of [`Section`]s | what is drawn along it: widths and offsets, layers, ports |
//! | [`Path::extrude`] | path × cross-section → [`Device`](phidl_core::scene::Device) |
//! | [`transition`] | a cross-section that changes into another one along the way |

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
