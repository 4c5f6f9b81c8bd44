//! Algorithms of the `geo` crate on a layer of a mask: a field of dots gets its convex hull, and
//! outlines with fewer corners.
//!
//! `cargo run -p phidl --example geo_bridge`
#![expect(clippy::print_stdout, reason = "an example shows what it draws")]

use geo::{Area, Centroid, ConvexHull, SimplifyVw};
use phidl::boolean::{Region, RunOptions};
use phidl::prelude::*;
use phidl::shapes as pg;

const DOTS: Layer = Layer::new(1, 0);
const HULL: Layer = Layer::new(2, 0);
const COARSE: Layer = Layer::new(3, 0);

/// Grid step of the region (µm).
const STEP: f64 = 0.001;

pub(crate) fn main() -> std::result::Result<(), Box<dyn std::error::Error>> {
    let mut d = Device::builder("field");
    d.add(pg::CircleParams::default().radius(10).layer(DOTS).build()?.array(5, 3, (30, 30)));
    let field = d.build()?;

    // As drawn, for algorithms that do not mind overlaps.
    let dots = field.to_multi_polygon(DOTS);
    let hull = dots.convex_hull();
    println!("{} dots around {:?}", dots.0.len(), dots.centroid());

    // Merged, with holes, for algorithms that do.
    let region = Region::from_multi_polygon(&dots, STEP, &RunOptions::default())?;
    let coarse = region.to_multi_polygon(STEP).simplify_vw(5.0);
    println!("{} µm² of {} µm² are left", coarse.unsigned_area(), dots.unsigned_area());

    let mut d = field.edit();
    d.add_polygon(hull.exterior(), HULL)?;
    for polygon in &coarse {
        d.add_polygon(polygon.exterior(), COARSE)?;
    }
    println!("{}", d.build()?);
    Ok(())
}
