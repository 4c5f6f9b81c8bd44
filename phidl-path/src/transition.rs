//! [`transition`]: a cross-section that changes into another one along a path.
//!
//! Widths and offsets follow one law, measured square to the path, so both edges of every section follow it too. Sections
//! that meet at both ends then meet all along: a coplanar line keeps its gaps. (PHIDL moves offsets by a raised cosine
//! whatever the widths do, and measures widths square to the moved middle line. Strips and gaps then overlap or separate
//! by micrometers.)

use phidl_core::{Error, Result};

use crate::cross_section::SectionPosition;
use crate::{CrossSection, Profile, Section};

/// The law by which widths and offsets change in a [`transition`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum TransitionShape {
    /// A raised cosine: without a kink at either end.
    #[default]
    Sine,
    /// In proportion to the length.
    Linear,
}

impl TransitionShape {
    fn profile(self, from: f64, to: f64) -> Profile {
        match self {
            _ if from == to => Profile::Constant(from),
            Self::Sine => Profile::Sine(from, to),
            Self::Linear => Profile::Linear(from, to),
        }
    }
}

/// The cross-section that starts as `from` and ends as `to`, for a taper along any path.
///
/// Sections are paired by name; sections without a name or without a partner are left out. Where a width or offset
/// changes along its own path, the value at the end that meets the taper counts. The faces are square to the path.
///
/// The taper's start port is the start port of `to`, and its end port is the end port of `from`. So each port connects to
/// the port with the same number: `in2` to `out1`, and `out1` to `in2`.
///
/// ```
/// # use phidl_path::{CrossSection, Path, Section, TransitionShape, transition};
/// let narrow = CrossSection::new().add(Section::new(1.2).ports("in1", "out1").named("wg"));
/// let wide = CrossSection::new().add(Section::new(3.0).ports("in2", "out2").named("wg"));
/// let taper = Path::straight(15)?.extrude(&transition(&narrow, &wide, TransitionShape::Sine)?)?;
/// assert_eq!((taper.port("in2")?.width(), taper.port("out1")?.width()), (1.2, 3.0));
/// # Ok::<(), phidl_core::Error>(())
/// ```
///
/// # Errors
/// [`Error::Custom`] if no name is common to both; [`Error::Param`] if a width or an offset is a list of values for the
/// points of a path, or if one of the cross-sections cannot be drawn.
pub fn transition(from: &CrossSection, to: &CrossSection, shape: TransitionShape) -> Result<CrossSection> {
    let (starts, ends) = (from.positions_at(1.0)?, to.positions_at(0.0)?);
    let mut taper = CrossSection::new();
    for (first, start) in from.sections().iter().zip(&starts) {
        let partner = to.sections().iter().position(|second| first.name.is_some() && first.name == second.name);
        if let Some(index) = partner {
            taper = taper.add(between(first, &to.sections()[index], [*start, ends[index]], shape));
        }
    }
    match taper.sections().is_empty() {
        false => Ok(taper),
        true => Err(no_common_name(from, to)),
    }
}

/// The section that starts as one and ends as another.
fn between(first: &Section, second: &Section, [start, end]: [SectionPosition; 2], shape: TransitionShape) -> Section {
    let beside = first.beside.clone().filter(|beside| second.beside.as_ref() == Some(beside));
    let offset = match beside {
        Some(_) => Profile::Constant(0.0),
        None => shape.profile(start.offset, end.offset),
    };
    Section {
        width: shape.profile(start.width, end.width),
        offset,
        beside,
        layers: first.layers.clone(),
        start_port: second.start_port.clone(),
        end_port: first.end_port.clone(),
        name: first.name.clone(),
    }
}

fn no_common_name(from: &CrossSection, to: &CrossSection) -> Error {
    let names = |x: &CrossSection| {
        let names: Vec<&str> = x.sections().iter().filter_map(|section| section.name.as_deref()).collect();
        if names.is_empty() { "has no named section".to_owned() } else { format!("has {}", names.join(", ")) }
    };
    let (from, to) = (names(from), names(to));
    let message = format!("the cross-sections need a section name in common, but the first {from} and the second {to}");
    Error::custom("transition", message)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn waveguides() -> (CrossSection, CrossSection) {
        let first = CrossSection::new()
            .add(Section::new(1.2).layer(2).named("wg").ports("in1", "out1"))
            .add(Section::new(2.2).layer(3).named("etch"))
            .add(Section::new(1.1).offset(3).layer(1).named("wg2"));
        let second = CrossSection::new()
            .add(Section::new(1).layer(2).named("wg").ports("in2", "out2"))
            .add(Section::new(3.5).layer(3).named("etch"))
            .add(Section::new(3).offset(5).layer(1).named("wg2"));
        (first, second)
    }

    #[test]
    fn widths_and_offsets_follow_one_law() {
        let (first, second) = waveguides();
        let taper = transition(&first, &second, TransitionShape::Sine).unwrap();
        let close = |profile: &Profile, value: f64| (profile.at(0.25).unwrap() - value).abs() < 1e-6;
        // The reference's values for a raised cosine.
        assert!(close(&taper["wg2"].width, 1.378_249) && close(&taper["wg2"].offset, 3.292_893));
        let taper = transition(&first, &second, TransitionShape::Linear).unwrap();
        assert!(close(&taper["wg2"].width, 1.575) && close(&taper["wg2"].offset, 3.5));
        assert_eq!(taper["wg"].start_port.as_deref(), Some("in2"));
        assert_eq!(taper["wg"].end_port.as_deref(), Some("out1"));
    }

    #[test]
    fn the_end_of_a_changing_section_that_meets_the_taper_counts() {
        let first = CrossSection::new().add(Section::new((1, 4)).named("wg"));
        let second = CrossSection::new().add(Section::new(|t: f64| 6.0 + t).named("wg"));
        let taper = transition(&first, &second, TransitionShape::Linear).unwrap();
        assert_eq!((taper["wg"].width.at(0.0), taper["wg"].width.at(1.0)), (Some(4.0), Some(6.0)));
    }

    #[test]
    fn a_gap_stays_a_gap_or_becomes_an_offset() {
        let gap = |width: f64| {
            let strip = Section::new(width).named("strip");
            CrossSection::new().add(strip).add(Section::new(2).right_of("strip").named("gap"))
        };
        let taper = transition(&gap(1.0), &gap(5.0), TransitionShape::Linear).unwrap();
        assert_eq!(taper["gap"].beside.as_ref().map(|beside| beside.section.as_str()), Some("strip"));
        let by_offset =
            CrossSection::new().add(Section::new(5).named("strip")).add(Section::new(2).offset(3.5).named("gap"));
        let taper = transition(&gap(1.0), &by_offset, TransitionShape::Linear).unwrap();
        assert_eq!((taper["gap"].offset.at(0.0), taper["gap"].offset.at(1.0)), (Some(1.5), Some(3.5)));
    }

    #[test]
    fn a_transition_without_a_common_name_is_refused() {
        let (first, _) = waveguides();
        assert!(transition(&first, &CrossSection::of_width(1, 0), TransitionShape::Sine).is_err());
        let listed = CrossSection::new().add(Section::new(vec![1.0, 2.0]).named("wg"));
        assert!(transition(&listed, &first, TransitionShape::Sine).is_err());
    }
}
