//! Draws the stages of an operation on three polygons as SVG.

use std::fmt::Write;

use phidl_boolean::{
    Operation,
    grid::{Contours, GridPoint},
    stages::{Stages, record},
};

/// Grid steps per panel, and pixels per step.
const SIDE: i64 = 30;
const SCALE: i64 = 8;

const TITLES: [&str; 5] = ["1 input", "2 segments, strips", "3 snap chains", "4 boundary edges", "5 region"];

fn contours(outlines: &[&[(i64, i64)]]) -> Contours {
    outlines.iter().map(|outline| outline.iter().copied().map(GridPoint::from)).collect()
}

/// The picture of all stages.
pub(crate) fn picture() -> String {
    let a = contours(&[&[(2, 3), (20, 6), (15, 22), (4, 18)], &[(23, 23), (28, 23), (28, 28), (23, 28)]]);
    let b = contours(&[&[(10, 2), (27, 11), (9, 16)]]);
    let stages = record(&a, &b, Operation::Or, 2).expect("three polygons");
    let (width, height) = (5 * SIDE * SCALE, SIDE * SCALE + 20);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" \
         font-size=\"13\" stroke-linejoin=\"round\">\n"
    );
    for (panel, title) in (0..).zip(TITLES) {
        let _ = writeln!(svg, "<g transform=\"translate({} 20)\">", panel * SIDE * SCALE);
        let _ = writeln!(svg, "<text x=\"8\" y=\"-6\" fill=\"currentColor\">{title}</text>");
        match panel {
            0 => input(&mut svg, &a, &b),
            1 => segments(&mut svg, &stages),
            2 => chains(&mut svg, &stages),
            3 => boundary(&mut svg, &stages),
            _ => region(&mut svg, &stages),
        }
        svg.push_str("</g>\n");
    }
    svg.push_str("</svg>\n");
    svg
}

/// A point in half pixels, so that seams between grid points are whole numbers.
fn at(p: GridPoint) -> (i64, i64) {
    (p.x * SCALE, (SIDE - p.y) * SCALE)
}

fn rings<'a>(svg: &mut String, rings: impl Iterator<Item = &'a [GridPoint]>, style: &str) {
    svg.push_str("<path d=\"");
    for ring in rings {
        for (i, &p) in ring.iter().enumerate() {
            let (x, y) = at(p);
            let _ = write!(svg, "{}{x} {y}", if i == 0 { 'M' } else { 'L' });
        }
        svg.push('Z');
    }
    let _ = writeln!(svg, "\" {style}/>");
}

fn lines(svg: &mut String, lines: &[[GridPoint; 2]], style: &str) {
    svg.push_str("<path d=\"");
    for line in lines {
        let [(x0, y0), (x1, y1)] = line.map(at);
        let _ = write!(svg, "M{x0} {y0}L{x1} {y1}");
    }
    let _ = writeln!(svg, "\" {style}/>");
}

fn seams(svg: &mut String, stages: &Stages) {
    for &column in &stages.seams {
        let x = column * SCALE - SCALE / 2;
        let (top, bottom) = (0, SIDE * SCALE);
        let _ = writeln!(
            svg,
            "<path d=\"M{x} {top}V{bottom}\" stroke=\"currentColor\" stroke-dasharray=\"4 3\" opacity=\"0.6\"/>"
        );
    }
}

fn input(svg: &mut String, a: &Contours, b: &Contours) {
    rings(svg, a.iter(), "fill=\"#3b82f6\" fill-opacity=\"0.35\" stroke=\"#3b82f6\"");
    rings(svg, b.iter(), "fill=\"#f59e0b\" fill-opacity=\"0.35\" stroke=\"#f59e0b\"");
}

fn segments(svg: &mut String, stages: &Stages) {
    seams(svg, stages);
    lines(svg, &stages.segments, "stroke=\"currentColor\" stroke-width=\"1.2\" fill=\"none\"");
}

fn chains(svg: &mut String, stages: &Stages) {
    let mut hot: Vec<GridPoint> = stages.chains.iter().flatten().copied().collect();
    hot.sort_unstable();
    hot.dedup();
    for (x, y) in hot.into_iter().map(at) {
        let (x, y) = (x - SCALE / 2, y - SCALE / 2);
        let _ = writeln!(
            svg,
            "<rect x=\"{x}\" y=\"{y}\" width=\"{SCALE}\" height=\"{SCALE}\" fill=\"#ef4444\" opacity=\"0.5\"/>"
        );
    }
    seams(svg, stages);
    lines(svg, &stages.chains, "stroke=\"currentColor\" stroke-width=\"1.2\" fill=\"none\"");
}

fn boundary(svg: &mut String, stages: &Stages) {
    seams(svg, stages);
    lines(svg, &stages.boundary, "stroke=\"#16a34a\" stroke-width=\"2\" fill=\"none\"");
    for &[from, to] in &stages.boundary {
        let [(x0, y0), (x1, y1)] = [at(from), at(to)];
        let _ = writeln!(
            svg,
            "<circle cx=\"{}\" cy=\"{}\" r=\"2.5\" fill=\"#16a34a\"/>",
            (x0 + 3 * x1) / 4,
            (y0 + 3 * y1) / 4
        );
    }
}

fn region(svg: &mut String, stages: &Stages) {
    let style = "fill=\"#16a34a\" fill-opacity=\"0.4\" stroke=\"#16a34a\" stroke-width=\"1.5\" fill-rule=\"evenodd\"";
    rings(svg, stages.region.contours().iter(), style);
}
