//! [`CrossSection`]: the strips that are drawn along a path.
//!
//! A cross-section is a plain value: a copy is a copy. (PHIDL's copies share their sections, so that a change of one
//! changes the other.) Adding chains, so what is wrong comes out when the cross-section is used.

use std::ops::{Index, IndexMut};

use phidl_core::Result;
use phidl_core::layer::Layers;
use phidl_core::scene::Device;

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

    /// A single strip in the middle of the path.
    pub fn of_width(width: impl Into<Profile>, layers: impl Into<Layers>) -> Self {
        Self::new().add(Section::new(width).layer(layers))
    }

    /// The same with one more section.
    ///
    /// A name or a port name that is taken, or a width that cannot be, comes back as the error of the extrusion or the
    /// transition.
    #[must_use]
    #[expect(clippy::should_implement_trait, reason = "the reference's word; `+` joins two cross-sections")]
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
    /// [`Error::Param`](phidl_core::Error::Param) with the names that are there.
    pub fn get(&self, name: &str) -> Result<&Section> {
        self.find(name).map(|place| &self.sections[place])
    }

    /// The section of a name, to be changed.
    ///
    /// # Errors
    /// As for [`CrossSection::get`].
    pub fn get_mut(&mut self, name: &str) -> Result<&mut Section> {
        self.find(name).map(|place| &mut self.sections[place])
    }

    /// The cross-section as it looks from the other end: left and right change places.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        let mirrored = |section: &Section| Section { offset: section.offset.negated(), ..section.clone() };
        Self { sections: self.sections.iter().map(mirrored).collect() }
    }

    /// The sections of this one, then those of another. `a + b` is the same.
    #[must_use]
    pub fn combined(&self, other: &Self) -> Self {
        Self { sections: [&self.sections[..], &other.sections].concat() }
    }

    /// The device that is drawn along a path: the same as [`Path::extrude`].
    ///
    /// # Errors
    /// As for [`Path::extrude`].
    pub fn extrude(&self, path: &Path) -> Result<Device> {
        path.extrude(self)
    }

    fn find(&self, name: &str) -> Result<usize> {
        let named = |section: &Section| section.name.as_deref() == Some(name);
        self.sections.iter().position(named).ok_or_else(|| {
            let known: Vec<&str> = self.sections.iter().filter_map(|section| section.name.as_deref()).collect();
            let known = if known.is_empty() { "there are none".to_owned() } else { known.join(", ") };
            rule::refused("cross-section", "name", format!("\"{name}\""), format!("be known; known are: {known}"))
        })
    }

    /// Refuses what cannot be drawn along any path.
    pub(crate) fn check(&self) -> Result<()> {
        let mut names: Vec<&str> = Vec::new();
        let mut ports: Vec<&str> = Vec::new();
        for (place, section) in self.sections.iter().enumerate() {
            let title = section.title(place);
            section.check(&title)?;
            section.name.iter().try_for_each(|name| unique(&mut names, name, &title, "name"))?;
            section.port_names().try_for_each(|port| unique(&mut ports, port, &title, "port"))?;
        }
        Ok(())
    }
}

/// Notes a name and refuses it if it is taken.
fn unique<'a>(taken: &mut Vec<&'a str>, name: &'a str, title: &str, kind: &str) -> Result<()> {
    if taken.contains(&name) {
        let rule = "be the only one of this name in the cross-section";
        return Err(rule::refused(title, kind, format!("\"{name}\""), rule));
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
    fn a_copy_is_changed_on_its_own() {
        let original = CrossSection::new().add(Section::new(2).named("wg"));
        let mut copy = original.clone();
        copy["wg"].width = 9.into();
        assert_eq!(original["wg"].width.constant(), Some(2.0));
    }

    #[test]
    fn names_and_ports_must_differ() {
        let twice = CrossSection::new().add(Section::new(1).named("a")).add(Section::new(1).named("a"));
        assert!(twice.check().is_err());
        let error = CrossSection::from(Section::new(1).ports("p", "p")).check().unwrap_err();
        assert_eq!(
            error.to_string(),
            "section 0: port is \"p\", but it must be the only one of this name in the cross-section"
        );
    }

    #[test]
    fn an_unknown_name_lists_the_known_ones() {
        let x = CrossSection::new().add(Section::new(1).named("wg")).add(Section::new(1).named("etch"));
        let error = x.get("gw").unwrap_err();
        assert_eq!(error.to_string(), "cross-section: name is \"gw\", but it must be known; known are: wg, etch");
    }

    #[test]
    fn a_mirrored_cross_section_is_on_the_other_side() {
        let x = CrossSection::new().add(Section::new(1).offset(2)).add(Section::new(1).offset((1, 3)));
        let mirrored = x.mirrored();
        assert_eq!(mirrored.sections()[0].offset.constant(), Some(-2.0));
        assert_eq!(mirrored.sections()[1].offset.at(1.0), Some(-3.0));
        assert_eq!((x.clone() + mirrored).sections().len(), 4);
    }
}
