//! The pictures of the tutorials of phidl-path and phidl-route: every chapter's drawings side by side.

use phidl_core::prelude::*;

use super::{Drawn, paths};

#[expect(dead_code, reason = "the chapters are drawn, and what the example prints is its own")]
#[path = "../../../phidl-route/examples/routing_tutorial.rs"]
mod routing_tutorial;
#[expect(dead_code, reason = "the chapters are drawn, and what the example prints is its own")]
#[path = "../../../phidl-path/examples/waveguide_tutorial.rs"]
mod waveguide_tutorial;

/// The gap between drawings, as a part of their total width.
const APART: f64 = 1.0 / 12.0;

/// The pictures of all chapters.
pub(super) fn all() -> anyhow::Result<Vec<Drawn>> {
    let tutorials = [
        ("docs/guide/waveguides", waveguide_tutorial::chapters()),
        ("docs/guide/routing", routing_tutorial::chapters()),
    ];
    let mut all = Vec::new();
    for (folder, chapters) in tutorials {
        for (chapter, drawings) in chapters.map_err(crate::report)? {
            let width: f64 = drawings.iter().map(|(_, device)| device.size().width).sum();
            let figure = paths::rows(APART * width, [drawings]).map_err(crate::report)?;
            all.push(paths::drawn(format!("{folder}/{chapter}.svg").into(), &figure)?);
        }
    }
    Ok(all)
}
