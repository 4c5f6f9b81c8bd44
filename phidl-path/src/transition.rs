//! [`transition`]: a cross-section that turns into another one along the way.

use std::f64::consts::PI;

use phidl_core::Result;

use crate::{CrossSection, Profile, Section, rule};

/// How the width changes in a [`transition`]. Offsets always change as a raised cosine, which leaves both ends straight.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum WidthChange {
    /// As a raised cosine: without a kink at either end.
    #[default]
    Sine,
    /// In proportion to the length.
    Linear,
}

/// The cross-section that starts as `from` and ends as `to`, for a taper along any path.
///
/// Sections are paired by name; those without a name, or without a partner, are left out. Where width or offset of a
/// section changes along its own path, the end that meets the taper counts. At its start the taper has the start port of
/// `to`, and at its end the end port of `from`: in connecting, `in2` meets `out1`, and `out1` meets `in2`.
///
/// ```
/// # use phidl_path::{CrossSection, Path, Section, WidthChange, transition};
/// let narrow = CrossSection::new().add(Section::new(1.2).ports("in1", "out1").named("wg"));
/// let wide = CrossSection::new().add(Section::new(3.0).ports("in2", "out2").named("wg"));
/// let taper = Path::straight(15)?.extrude(&transition(&narrow, &wide, WidthChange::Sine)?)?;
/// assert_eq!((taper.port("in2")?.width(), taper.port("out1")?.width()), (1.2, 3.0));
/// # Ok::<(), phidl_core::Error>(())
/// ```
///
/// # Errors
/// [`Error::Param`](phidl_core::Error::Param) if no name is common to both, if a width or an offset is a list of values
/// for the points of a path, or if one of the cross-sections cannot be drawn.
pub fn transition(from: &CrossSection, to: &CrossSection, change: WidthChange) -> Result<CrossSection> {
    from.check()?;
    to.check()?;
    let mut taper = CrossSection::new();
    for first in from.sections() {
        let partner = to.sections().iter().find(|second| first.name.is_some() && first.name == second.name);
        if let Some(second) = partner {
            taper = taper.add(between(first, second, change)?);
        }
    }
    match taper.sections().is_empty() {
        false => Ok(taper),
        true => Err(rule::refused("transition", "names of the sections", named(from, to), "have one in common")),
    }
}

/// The section that starts as one and ends as another.
fn between(first: &Section, second: &Section, change: WidthChange) -> Result<Section> {
    let title = first.title(0);
    let at = |profile: &Profile, t: f64, param: &str| {
        profile.at(t).filter(|v| v.is_finite()).ok_or_else(|| {
            rule::refused(&title, param, format!("{profile:?}"), "be a number or a function, to end in a transition")
        })
    };
    let (width_1, width_2) = (at(&first.width, 1.0, "width")?, at(&second.width, 0.0, "width")?);
    let (offset_1, offset_2) = (at(&first.offset, 1.0, "offset")?, at(&second.offset, 0.0, "offset")?);
    let width = match change {
        WidthChange::Sine => raised_cosine(width_1, width_2),
        WidthChange::Linear => Profile::Linear(width_1, width_2),
    };
    Ok(Section {
        width,
        offset: raised_cosine(offset_1, offset_2),
        layers: first.layers.clone(),
        start_port: second.start_port.clone(),
        end_port: first.end_port.clone(),
        name: first.name.clone(),
    })
}

fn raised_cosine(from: f64, to: f64) -> Profile {
    if from == to {
        return Profile::Constant(from);
    }
    Profile::from(move |t: f64| from + (1.0 - (PI * t).cos()) / 2.0 * (to - from))
}

fn named(from: &CrossSection, to: &CrossSection) -> String {
    let names = |x: &CrossSection| {
        let names: Vec<&str> = x.sections().iter().filter_map(|section| section.name.as_deref()).collect();
        if names.is_empty() { "none".to_owned() } else { names.join(", ") }
    };
    format!("{} and {}", names(from), names(to))
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
    fn values_on_the_way_are_those_of_the_specification() {
        let (first, second) = waveguides();
        let taper = transition(&first, &second, WidthChange::Sine).unwrap();
        let close = |profile: &Profile, value: f64| (profile.at(0.25).unwrap() - value).abs() < 1e-6;
        assert!(close(&taper["wg2"].width, 1.378_249) && close(&taper["wg2"].offset, 3.292_893));
        let taper = transition(&first, &second, WidthChange::Linear).unwrap();
        assert!(close(&taper["wg2"].width, 1.575) && close(&taper["wg2"].offset, 3.292_893));
        assert_eq!(taper["wg"].start_port.as_deref(), Some("in2"));
        assert_eq!(taper["wg"].end_port.as_deref(), Some("out1"));
    }

    #[test]
    fn of_a_section_that_changes_the_end_that_meets_counts() {
        let first = CrossSection::new().add(Section::new((1, 4)).named("wg"));
        let second = CrossSection::new().add(Section::new(|t: f64| 6.0 + t).named("wg"));
        let taper = transition(&first, &second, WidthChange::Linear).unwrap();
        assert_eq!((taper["wg"].width.at(0.0), taper["wg"].width.at(1.0)), (Some(4.0), Some(6.0)));
    }

    #[test]
    fn without_a_common_name_there_is_no_transition() {
        let (first, _) = waveguides();
        let other = CrossSection::new().add(Section::new(1).named("rib"));
        let error = transition(&first, &other, WidthChange::Sine).unwrap_err();
        assert_eq!(
            error.to_string(),
            "transition: names of the sections is wg, etch, wg2 and rib, but it must have one in common"
        );
        assert!(transition(&first, &CrossSection::of_width(1, 0), WidthChange::Sine).is_err());
        let listed = CrossSection::new().add(Section::new(vec![1.0, 2.0]).named("wg"));
        assert!(transition(&listed, &first, WidthChange::Sine).is_err());
    }
}
