//! Bends in numbers: curvature, length, and how many points they need.

use phidl_core::prelude::*;
use phidl_path::{ArcBend, CrossSection, EulerBend, Extrusion, Path, Spiral};

/// One line about a bend.
#[expect(clippy::print_stdout, reason = "an example shows what it did")]
fn describe(name: &str, path: &Path) -> Result<()> {
    let (_, curvature) = path.curvature()?;
    let tightest = curvature.iter().fold(0.0, |most: f64, k| most.max(k.abs()));
    let few = path.with_tolerance(0.001)?.points().len();
    let (points, length) = (path.points().len(), path.length());
    println!("{name:<24} {length:8.3} µm long, radius {:6.3} µm, {points} points, {few} within 1 nm", 1.0 / tightest);
    Ok(())
}

/// Prints a table of bends, and where a strip that is too wide overlaps itself.
#[expect(clippy::print_stdout, reason = "an example shows what it did")]
pub(crate) fn main() -> Result<()> {
    describe("arc", &ArcBend::new().path(10, 90)?)?;
    describe("Euler bend", &EulerBend::new().use_eff().path(10, 90)?)?;
    describe("half Euler bend", &EulerBend::new().p(0.5).use_eff().path(10, 90)?)?;
    describe("spiral", &Spiral { num_turns: 4.0, gap: 3.0, inner_gap: 9.0, num_pts: 4000.0 }.path()?)?;

    let (path, wide) = (Path::arc(5, 90)?, CrossSection::of_width(12, 1));
    for overlap in Extrusion::new(&path, &wide).self_overlaps()? {
        println!("a strip of 12 µm overlaps itself from {:.2} to {:.2} µm", overlap.from, overlap.to);
    }
    match path.extrude(&wide) {
        Ok(_) => println!("it can be drawn"),
        Err(error) => println!("refused: {error}"),
    }
    Ok(())
}
