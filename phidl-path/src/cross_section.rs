//! [`CrossSection`]: the bands that are drawn along a path.
//!
//! A cross-section is a value, and a copy is independent. (PHIDL's copies share their sections, so that a change of one
//! changes the other.) `add` chains and does not fail; an invalid section is the error of the extrusion or the transition.

use std::ops::{Index, IndexMut};

use phidl_core::layer::Layers;
use phidl_core::scene::Device;
use phidl_core::{Error, Result};

use crate::section::Beside;
use crate::{Path, Profile, Section, rule};

/// An ordered set of [`Section`]s.
///
/// ```
/// # use phidl_path::{CrossSection, Path, Section};
/// let rib = CrossSection::new()
///     .add(Section::new(0.5).layer(1).ports("in", "out").named("core"))
///     .add(Section::new(6).layer(2).named("slab"));
/// let wide = Path::straight(20)?.extrude(&rib)?;
/// assert_eq!(wide.port("out")?.width(), 0.5);
///
/// let mut narrow = rib.clone();
/// narrow.get_mut("slab")?.width = 4.into();
/// assert_eq!(rib["slab"].width.constant(), Some(6.0));
/// # Ok::<(), phidl_core::Error>(())
/// ```
///
/// # Panics
/// `x["name"]` panics like a map when there is no section of this name; [`CrossSection::get`] returns an error instead.
#[derive(Debug, Clone, Default)]
pub struct CrossSection {
    sections: Vec<Section>,
}

impl CrossSection {
    /// A cross-section without sections.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// One band in the middle of the path.
    pub fn of_width(width: impl Into<Profile>, layers: impl Into<Layers>) -> Self {
        Self::new().add(Section::new(width).layer(layers))
    }

    /// The same with one more section.
    ///
    /// A name or a port name that is taken and an invalid width are errors of the extrusion or the transition.
    #[must_use]
    #[expect(clippy::should_implement_trait, reason = "PHIDL's name; `+` joins two cross-sections")]
    pub fn add(mut self, section: Section) -> Self {
        self.sections.push(section);
        self
    }

    /// The sections, in the order in which they were added.
    #[must_use]
    pub fn sections(&self) -> &[Section] {
        &self.sections
    }

    /// The section of a name.
    ///
    /// # Errors
    /// [`Error::Custom`] with the names of the sections.
    pub fn get(&self, name: &str) -> Result<&Section> {
        self.index_of(name).map(|index| &self.sections[index])
    }

    /// The section of a name, for a change.
    ///
    /// # Errors
    /// As for [`CrossSection::get`].
    pub fn get_mut(&mut self, name: &str) -> Result<&mut Section> {
        self.index_of(name).map(|index| &mut self.sections[index])
    }

    /// The cross-section seen from the other end of the path: left and right are exchanged.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let mirrored = |section: &Section| {
            let beside = section.beside.clone().map(|beside| Beside { side: beside.side.opposite(), ..beside });
            Section { offset: section.offset.negated(), beside, ..section.clone() }
        };
        Self { sections: self.sections.iter().map(mirrored).collect() }
    }

    /// The sections of this one, then those of another. `a + b` is the same.
    #[must_use]
    pub fn combined(&self, other: &Self) -> Self {
        Self { sections: [&self.sections[..], &other.sections].concat() }
    }

    /// The largest distances (µm) of an edge to the left and to the right of the path; functions are evaluated at 257
    /// values of t. A distance is 0 if all edges are on the other side.
    ///
    /// ```
    /// # use phidl_path::{CrossSection, Section};
    /// let x = CrossSection::new().add(Section::new(1)).add(Section::new(2).offset(3));
    /// assert_eq!(x.reach()?, [0.5, 4.0]);
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Path::extrude`]; and [`Error::Param`] if a width or an offset is a list, which belongs to the points of one
    /// path.
    pub fn reach(&self) -> Result<[f64; 2]> {
        const STEPS: u32 = 256;
        let (mut left, mut right) = (0.0_f64, 0.0_f64);
        for i in 0..=STEPS {
            for section in self.positions_at(f64::from(i) / f64::from(STEPS))? {
                left = left.max(section.width / 2.0 - section.offset);
                right = right.max(section.width / 2.0 + section.offset);
            }
        }
        Ok([left, right])
    }

    /// The sections at a fraction of the length of a path.
    pub(crate) fn positions_at(&self, t: f64) -> Result<Vec<SectionPosition>> {
        self.check()?;
        let mut positions: Vec<SectionPosition> = Vec::with_capacity(self.sections.len());
        for (index, section) in self.sections.iter().enumerate() {
            let title = section.title(index);
            let at = |profile: &Profile, param: &str| {
                let value = profile.at(t).filter(|v| v.is_finite());
                let rule = || format!("be a number or a function, and finite at t = {t}");
                value.ok_or_else(|| rule::refused(&title, param, format!("{profile:?}"), rule()))
            };
            let width = at(&section.width, "width")?;
            let offset = match &section.beside {
                None => at(&section.offset, "offset")?,
                Some(beside) => {
                    let other = positions[self.index_of(&beside.section)?];
                    other.offset + beside.side.sign() * (other.width + width) / 2.0
                }
            };
            positions.push(SectionPosition { width, offset });
        }
        Ok(positions)
    }

    /// The device along a path, as [`Path::extrude`] draws it.
    ///
    /// # Errors
    /// As for [`Path::extrude`].
    pub fn extrude(&self, path: &Path) -> Result<Device> {
        path.extrude(self)
    }

    /// The number of the section of a name.
    pub(crate) fn index_of(&self, name: &str) -> Result<usize> {
        let named = |section: &Section| section.name.as_deref() == Some(name);
        self.sections.iter().position(named).ok_or_else(|| {
            let known: Vec<&str> = self.sections.iter().filter_map(|section| section.name.as_deref()).collect();
            let known = if known.is_empty() {
                "no section has a name".to_owned()
            } else {
                format!("known are {}", known.join(", "))
            };
            Error::custom("cross-section", format!("there is no section \"{name}\"; {known}"))
        })
    }

    /// Refuses a cross-section that can be drawn along no path.
    pub(crate) fn check(&self) -> Result<()> {
        let mut names: Vec<&str> = Vec::new();
        let mut ports: Vec<&str> = Vec::new();
        for (index, section) in self.sections.iter().enumerate() {
            let title = section.title(index);
            section.check(&title)?;
            if let Some(beside) = &section.beside
                && !names.contains(&beside.section.as_str())
            {
                let other = &beside.section;
                let message =
                    format!("it begins at an edge of \"{other}\", so a section \"{other}\" must be added before it");
                return Err(Error::custom(title, message));
            }
            section.name.iter().try_for_each(|name| unique(&mut names, name, "name"))?;
            section.port_names().try_for_each(|port| unique(&mut ports, port, "port name"))?;
        }
        Ok(())
    }
}

/// A section at one position of a path.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SectionPosition {
    pub(crate) width: f64,
    pub(crate) offset: f64,
}

/// Adds a name and refuses it if it is taken.
fn unique<'a>(taken: &mut Vec<&'a str>, name: &'a str, kind: &str) -> Result<()> {
    if taken.contains(&name) {
        return Err(Error::custom("cross-section", format!("the {kind} \"{name}\" is used twice")));
    }
    taken.push(name);
    Ok(())
}

impl std::ops::Add for CrossSection {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.combined(&other)
    }
}

impl From<Section> for CrossSection {
    fn from(section: Section) -> Self {
        Self { sections: vec![section] }
    }
}

impl Index<&str> for CrossSection {
    type Output = Section;

    fn index(&self, name: &str) -> &Section {
        match self.get(name) {
            Ok(section) => section,
            Err(error) => panic!("{error}"),
        }
    }
}

impl IndexMut<&str> for CrossSection {
    fn index_mut(&mut self, name: &str) -> &mut Section {
        match self.get_mut(name) {
            Ok(section) => section,
            Err(error) => panic!("{error}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_copy_is_independent() {
        let original = CrossSection::new().add(Section::new(2).named("wg"));
        let mut copy = original.clone();
        copy["wg"].width = 9.into();
        assert_eq!(original["wg"].width.constant(), Some(2.0));
    }

    #[test]
    fn names_and_ports_must_differ() {
        let twice = CrossSection::new().add(Section::new(1).named("a")).add(Section::new(1).named("a"));
        assert!(twice.check().is_err());
        assert!(CrossSection::from(Section::new(1).ports("p", "p")).check().is_err());
    }

    #[test]
    fn a_section_begins_at_an_edge_of_an_earlier_one() {
        let strip = || Section::new(4).named("strip");
        let gap = || Section::new(2).right_of("strip").named("gap");
        assert!(CrossSection::new().add(strip()).add(gap()).check().is_ok());
        assert!(CrossSection::new().add(gap()).add(strip()).check().is_err(), "the strip must come first");
        assert!(CrossSection::new().add(strip()).add(gap().offset(1)).check().is_err(), "one position, not two");
    }

    #[test]
    fn a_mirrored_cross_section_lies_on_the_other_side() {
        let x = CrossSection::new().add(Section::new(1).offset(2)).add(Section::new(1).offset((1, 3)));
        let mirrored = x.mirrored();
        assert_eq!(mirrored.sections()[0].offset.constant(), Some(-2.0));
        assert_eq!(mirrored.sections()[1].offset.at(1.0), Some(-3.0));
        assert_eq!((x.clone() + mirrored).sections().len(), 4);
    }
}
