//! [`Section`]: one strip of a cross-section.

use phidl_core::Result;
use phidl_core::layer::Layers;

use crate::{Profile, rule};

/// A strip along a path: how wide, how far to the right, on which layers, with which ports.
///
/// ```
/// # use phidl_path::Section;
/// let slot = Section::new(0.5).offset(-2).layer((3, 1)).ports("in", "out").named("slot");
/// assert_eq!(slot.offset.constant(), Some(-2.0));
/// ```
#[derive(Debug, Clone)]
pub struct Section {
    /// Width (µm): greater than 0, or not negative where it changes along the path.
    pub width: Profile,
    /// Distance from the path to the middle of the strip (µm): to the right, or to the left if negative.
    pub offset: Profile,
    /// Where it is drawn. Without a layer, nothing is drawn, but there are ports.
    pub layers: Layers,
    /// Name of the port at the start of the path, if there is one.
    pub start_port: Option<String>,
    /// Name of the port at the end of the path, if there is one.
    pub end_port: Option<String>,
    /// Name of the section, by which it is found again and paired by [`transition`](crate::transition).
    pub name: Option<String>,
}

impl Section {
    /// A strip of a width (a number, a pair, a function, a list: see [`Profile`]) in the middle of the path on layer 0.
    pub fn new(width: impl Into<Profile>) -> Self {
        Self {
            width: width.into(),
            offset: Profile::Constant(0.0),
            layers: Layers::default(),
            start_port: None,
            end_port: None,
            name: None,
        }
    }

    /// The same strip further to the right.
    #[must_use]
    pub fn offset(self, offset: impl Into<Profile>) -> Self {
        Self { offset: offset.into(), ..self }
    }

    /// The same strip on other layers.
    #[must_use]
    pub fn layer(self, layers: impl Into<Layers>) -> Self {
        Self { layers: layers.into(), ..self }
    }

    /// The same strip with ports at the start and at the end of the path.
    #[must_use]
    pub fn ports(self, start: impl Into<String>, end: impl Into<String>) -> Self {
        Self { start_port: Some(start.into()), end_port: Some(end.into()), ..self }
    }

    /// The same strip with a port at the start of the path.
    #[must_use]
    pub fn start_port(self, name: impl Into<String>) -> Self {
        Self { start_port: Some(name.into()), ..self }
    }

    /// The same strip with a port at the end of the path.
    #[must_use]
    pub fn end_port(self, name: impl Into<String>) -> Self {
        Self { end_port: Some(name.into()), ..self }
    }

    /// The same strip under a name.
    #[must_use]
    pub fn named(self, name: impl Into<String>) -> Self {
        Self { name: Some(name.into()), ..self }
    }

    /// Its port names, at the start first.
    pub(crate) fn port_names(&self) -> impl Iterator<Item = &str> {
        [&self.start_port, &self.end_port].into_iter().flatten().map(String::as_str)
    }

    /// What messages call it.
    pub(crate) fn title(&self, place: usize) -> String {
        match &self.name {
            Some(name) => format!("section \"{name}\""),
            None => format!("section {place}"),
        }
    }

    /// Refuses a width or an offset that cannot be, as far as that shows without a path.
    pub(crate) fn check(&self, title: &str) -> Result<()> {
        self.width.check(title, "width")?;
        self.offset.check(title, "offset")?;
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
    fn widths_that_cannot_be_are_refused_by_the_name_of_the_section() {
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
