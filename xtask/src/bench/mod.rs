//! `cargo xtask bench`: shapes, paths, routes, cells and files of ours and of other tools, in one sitting.
//!
//! Ours runs in this process, the others in one Python process for each section, one after the other and never at the
//! same time. The inputs are those of the benches of the crates (`testkit::loads`). Booleans have a command of their own,
//! `cargo xtask compare`. Criterion was the alternative for our side; it needs a minute for what is a second here, and
//! the peers could not be measured by its rules.

mod cells;
mod clock;
mod files;
mod paths;
mod routes;
mod shapes;
mod table;
mod text;

use std::path::Path;

use anyhow::Context;

use crate::compare::script;
use crate::flags::{BenchFlags, BenchSection};
use crate::python::Python;
use table::{Section, Times};

/// Runs the sections that the flags name, and prints a table for each.
pub(crate) fn run(flags: &BenchFlags) -> anyhow::Result<()> {
    std::fs::create_dir_all(&flags.out).with_context(|| flags.out.display().to_string())?;
    let python = Python::with_peers(&flags.out.join("peers"))?;
    let wanted = |section: BenchSection| flags.sections.is_empty() || flags.sections.contains(&section);
    for section in BenchSection::ALL.into_iter().filter(|section| wanted(*section)) {
        let sitting = Sitting { python: python.as_ref(), folder: &flags.out, filter: flags.filter.as_deref() };
        println!("{}", sitting.section(section)?);
    }
    Ok(())
}

/// Who takes part, and where files are put.
struct Sitting<'a> {
    python: Option<&'a Python>,
    folder: &'a Path,
    filter: Option<&'a str>,
}

impl Sitting<'_> {
    fn section(&self, section: BenchSection) -> anyhow::Result<Section> {
        match section {
            BenchSection::Shapes => shapes::measure(self),
            BenchSection::Text => text::measure(self),
            BenchSection::Paths => paths::measure(self),
            BenchSection::Routes => routes::measure(self),
            BenchSection::Cells => cells::measure(self),
            BenchSection::Files => files::measure(self),
        }
    }

    /// What the others need for the works of a section, by work and tool.
    fn peers(&self, section: &str, argument: &Path) -> anyhow::Result<Times> {
        let Some(python) = self.python else { return Ok(Times::default()) };
        let argument = argument.to_str().context("the path is text")?;
        let printed = python.run(&script("peers.py"), &[section, argument])?;
        serde_json::from_str(&printed).with_context(|| format!("{section} printed {printed:?}"))
    }
}
