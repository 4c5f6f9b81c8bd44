//! [`Section`]: one band of a cross-section.

use phidl_core::Result;
use phidl_core::layer::Layers;

use crate::{Profile, Side, rule};

/// A band along a path: its width, its offset to the right, its layers and its ports.
///
/// ```
/// # use phidl_path::Section;
/// let slot = Section::new(0.5).offset(-2).layer((3, 1)).ports("in", "out").named("slot");
/// assert_eq!(slot.offset.constant(), Some(-2.0));
/// ```
#[derive(Debug, Clone)]
pub struct Section {
    /// Width (µm): greater than 0, or at least 0 where it changes along the path.
    pub width: Profile,
    /// Distance from the path to the middle of the band (µm): to the right, or to the left if negative.
    pub offset: Profile,
    /// The edge of another section at which the band begins, instead of an offset.
    pub beside: Option<Beside>,
    /// Where it is drawn. A section without a layer draws nothing, but has ports.
    pub layers: Layers,
    /// Name of the port at the start of the path.
    pub start_port: Option<String>,
    /// Name of the port at the end of the path.
    pub end_port: Option<String>,
    /// Name of the section, for [`CrossSection::get`](crate::CrossSection::get), [`Section::right_of`] and
    /// [`transition`](crate::transition).
    pub name: Option<String>,
}

/// An edge of a section that another section begins at.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Beside {
    /// Name of the section with the edge.
    pub section: String,
    /// Which of its edges it is.
    pub side: Side,
}

impl Section {
    /// A band of a width (a number, a pair, a function or a list, see [`Profile`]) in the middle of the path, on layer 0.
    pub fn new(width: impl Into<Profile>) -> Self {
        Self {
            width: width.into(),
            offset: Profile::Constant(0.0),
            beside: None,
            layers: Layers::default(),
            start_port: None,
            end_port: None,
            name: None,
        }
    }

    /// The same band at an offset (µm) to the right.
    ///
    /// A number, a pair and [`Profile::Sine`] are measured square to the path, so that sections whose edges meet at both
    /// ends meet all along. A function or a list moves the middle line itself, and the width is measured square to that
    /// line.
    #[must_use]
    pub fn offset(self, offset: impl Into<Profile>) -> Self {
        Self { offset: offset.into(), ..self }
    }

    /// The same band with its left edge on the right edge of a section that is added before: a gap beside a strip.
    ///
    /// ```
    /// # use phidl_path::{CrossSection, Path, Section};
    /// let cpw = CrossSection::new()
    ///     .add(Section::new(10).layer(1).named("strip").ports("in", "out"))
    ///     .add(Section::new(6).left_of("strip").layer(2))
    ///     .add(Section::new(6).right_of("strip").layer(2));
    /// let line = Path::arc(100, 90)?.extrude(&cpw)?;
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    #[must_use]
    pub fn right_of(self, section: impl Into<String>) -> Self {
        Self { beside: Some(Beside { section: section.into(), side: Side::Right }), ..self }
    }

    /// The same band with its right edge on the left edge of a section that is added before.
    #[must_use]
    pub fn left_of(self, section: impl Into<String>) -> Self {
        Self { beside: Some(Beside { section: section.into(), side: Side::Left }), ..self }
    }

    /// The same band on other layers.
    #[must_use]
    pub fn layer(self, layers: impl Into<Layers>) -> Self {
        Self { layers: layers.into(), ..self }
    }

    /// The same band with ports at the start and at the end of the path.
    #[must_use]
    pub fn ports(self, start: impl Into<String>, end: impl Into<String>) -> Self {
        Self { start_port: Some(start.into()), end_port: Some(end.into()), ..self }
    }

    /// The same band with a port at the start of the path.
    #[must_use]
    pub fn start_port(self, name: impl Into<String>) -> Self {
        Self { start_port: Some(name.into()), ..self }
    }

    /// The same band with a port at the end of the path.
    #[must_use]
    pub fn end_port(self, name: impl Into<String>) -> Self {
        Self { end_port: Some(name.into()), ..self }
    }

    /// The same band with a name.
    #[must_use]
    pub fn named(self, name: impl Into<String>) -> Self {
        Self { name: Some(name.into()), ..self }
    }

    /// Its port names, the start port first.
    pub(crate) fn port_names(&self) -> impl Iterator<Item = &str> {
        [&self.start_port, &self.end_port].into_iter().flatten().map(String::as_str)
    }

    /// Its title in messages.
    pub(crate) fn title(&self, index: usize) -> String {
        match &self.name {
            Some(name) => format!("section \"{name}\""),
            None => format!("section {index}"),
        }
    }

    /// Refuses an invalid width or offset, as far as it can be seen without a path.
    pub(crate) fn check(&self, title: &str) -> Result<()> {
        self.width.check(title, "width")?;
        self.offset.check(title, "offset")?;
        if let Some(beside) = &self.beside
            && self.offset.constant() != Some(0.0)
        {
            let rule = format!("be left out, since the section begins at an edge of \"{}\"", beside.section);
            return Err(rule::refused(title, "offset", format!("{:?} µm", self.offset), rule));
        }
        match self.width {
            Profile::Constant(width) => rule::positive_length(title, "width", width),
            _ => Ok(()),
        }
    }

    /// The widths at all points of a path.
    pub(crate) fn widths(&self, title: &str, fractions: &[f64]) -> Result<Vec<f64>> {
        let widths = self.width.sampled(title, "width", fractions)?;
        match widths.iter().position(|width| *width < 0.0) {
            None => Ok(widths),
            Some(i) => {
                let given = format!("{} µm at t = {}", widths[i], fractions[i]);
                Err(rule::refused(title, "width", given, "be at least 0 µm everywhere"))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_invalid_width_is_refused_with_the_name_of_the_section() {
        let error = Section::new(-1).named("wg").check("section \"wg\"").unwrap_err();
        assert_eq!(error.to_string(), "section \"wg\": width is -1 µm, but it must be greater than 0 µm and finite");
        assert!(Section::new(0).check("section 0").is_err());
        assert!(Section::new(1).offset(f64::INFINITY).check("section 0").is_err());
        let error = Section::new((-1, 2)).widths("section 0", &[0.0, 1.0]).unwrap_err();
        assert_eq!(error.to_string(), "section 0: width is -1 µm at t = 0, but it must be at least 0 µm everywhere");
    }

    #[test]
    fn a_tip_may_be_sharp() {
        assert_eq!(Section::new((2, 0)).widths("section 0", &[0.0, 1.0]).unwrap(), [2.0, 0.0]);
    }
}
