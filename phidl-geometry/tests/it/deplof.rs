//! The built-in font: its metrics against those of PHIDL, and that no part of it can fall out or close up.
//!
//! The second engine judges: what offsetting inwards and outwards again removes from the ink (or from what is around it)
//! was narrower than twice the offset, but for what any corner loses.

use clipper2_rust::{
    EndType, FillRule, JoinType, Path64, Paths64, Point64, area, area_paths, difference_64, inflate_paths_64,
    union_subjects_64,
};
use phidl_core::prelude::*;
use phidl_geometry::text::deplof::{self, GAP, Glyph, STROKE};

/// Steps of the judging grid in a unit of the font.
const STEPS: f64 = 1000.0;
/// The sharpest corner in either tone, in degrees.
const SHARPEST: f64 = 55.0;

/// Character, indent, width, ink along x and y, polygons.
type Metrics = (char, i32, i32, [i32; 2], [i32; 2], usize);

/// The table of PHIDL.
#[rustfmt::skip]
const METRICS: [Metrics; 95] = [
    ('!', 100, 400, [100, 300], [-100, 1100], 2),
    ('"', 200, 500, [300, 800], [800, 1200], 2),
    ('#', 100, 800, [50, 950], [0, 1000], 2),
    ('$', 100, 800, [100, 900], [-200, 1200], 1),
    ('%', 100, 800, [100, 900], [0, 1000], 3),
    ('&', 0, 900, [0, 900], [0, 900], 2),
    ('\'', 300, 200, [300, 500], [800, 1200], 1),
    ('(', 100, 450, [100, 450], [-100, 1100], 1),
    (')', 100, 450, [100, 450], [-100, 1100], 1),
    ('*', 200, 600, [200, 800], [400, 1000], 5),
    ('+', 100, 800, [100, 900], [100, 900], 1),
    (',', 100, 200, [100, 300], [-200, 200], 1),
    ('-', 100, 800, [100, 900], [350, 550], 1),
    ('.', 100, 200, [100, 300], [0, 200], 1),
    ('/', 100, 400, [100, 500], [-200, 1200], 1),
    ('0', 100, 800, [100, 900], [0, 1000], 2),
    ('1', 100, 400, [100, 500], [0, 1000], 1),
    ('2', 100, 700, [100, 800], [0, 1000], 1),
    ('3', 100, 700, [100, 800], [0, 1000], 1),
    ('4', 100, 700, [100, 800], [0, 1000], 1),
    ('5', 100, 700, [100, 800], [0, 1000], 1),
    ('6', 100, 700, [100, 800], [0, 1000], 1),
    ('7', 100, 700, [100, 800], [0, 1000], 1),
    ('8', 100, 700, [100, 800], [0, 1000], 1),
    ('9', 100, 700, [100, 800], [0, 1000], 1),
    (':', 100, 200, [100, 300], [0, 600], 2),
    (';', 100, 200, [100, 300], [-200, 600], 2),
    ('<', 100, 600, [100, 700], [100, 900], 1),
    ('=', 100, 800, [100, 900], [200, 800], 2),
    ('>', 100, 600, [100, 700], [100, 900], 1),
    ('?', 100, 800, [100, 900], [-150, 1100], 2),
    ('@', 100, 800, [100, 900], [0, 1000], 1),
    ('A', 100, 700, [99, 800], [0, 1000], 1),
    ('B', 100, 700, [100, 800], [0, 1000], 1),
    ('C', 100, 700, [100, 800], [0, 1000], 1),
    ('D', 100, 700, [100, 800], [0, 1000], 1),
    ('E', 100, 600, [100, 700], [0, 1000], 1),
    ('F', 100, 600, [100, 700], [0, 1000], 1),
    ('G', 100, 700, [100, 800], [0, 1000], 1),
    ('H', 100, 700, [100, 800], [0, 1000], 1),
    ('I', 100, 600, [100, 700], [0, 1000], 1),
    ('J', 100, 600, [100, 700], [0, 1000], 1),
    ('K', 100, 700, [100, 800], [0, 1000], 1),
    ('L', 100, 700, [100, 800], [0, 1000], 1),
    ('M', 100, 800, [100, 900], [0, 1000], 1),
    ('N', 100, 800, [100, 900], [0, 1000], 1),
    ('O', 100, 800, [100, 900], [0, 1000], 1),
    ('P', 100, 800, [100, 900], [0, 1000], 1),
    ('Q', 100, 800, [100, 900], [0, 1000], 1),
    ('R', 100, 800, [100, 900], [0, 1000], 1),
    ('S', 100, 800, [100, 900], [0, 1000], 1),
    ('T', 100, 800, [100, 900], [0, 1000], 1),
    ('U', 100, 700, [100, 800], [0, 1000], 1),
    ('V', 100, 800, [100, 900], [0, 1000], 1),
    ('W', 100, 800, [100, 900], [0, 1000], 1),
    ('X', 100, 800, [100, 900], [0, 1000], 1),
    ('Y', 100, 800, [100, 900], [0, 1000], 1),
    ('Z', 100, 800, [100, 900], [0, 1000], 1),
    ('[', 100, 300, [100, 400], [-200, 1200], 1),
    ('\\', 100, 400, [100, 500], [-200, 1200], 1),
    (']', 100, 300, [100, 400], [-200, 1200], 1),
    ('^', 0, 800, [0, 800], [500, 900], 1),
    ('_', 100, 800, [100, 900], [0, 200], 1),
    ('`', 300, 200, [300, 500], [800, 1200], 1),
    ('a', 100, 700, [100, 800], [0, 775], 1),
    ('b', 100, 700, [100, 800], [0, 1000], 1),
    ('c', 100, 700, [100, 800], [0, 700], 1),
    ('d', 100, 700, [100, 800], [0, 1000], 1),
    ('e', 100, 700, [100, 800], [0, 800], 1),
    ('f', 100, 500, [100, 600], [0, 1000], 1),
    ('g', 100, 700, [100, 800], [-300, 700], 1),
    ('h', 100, 700, [100, 800], [0, 1100], 1),
    ('i', 100, 200, [100, 300], [0, 1000], 2),
    ('j', 100, 400, [100, 500], [-200, 1000], 2),
    ('k', 100, 700, [100, 800], [0, 1100], 1),
    ('l', 100, 400, [100, 500], [0, 1000], 1),
    ('m', 100, 1000, [100, 1100], [0, 700], 1),
    ('n', 100, 700, [100, 800], [0, 700], 1),
    ('o', 100, 700, [100, 800], [0, 700], 1),
    ('p', 100, 700, [100, 800], [-300, 700], 1),
    ('q', 100, 700, [100, 800], [-300, 700], 1),
    ('r', 100, 700, [100, 800], [0, 700], 1),
    ('s', 100, 700, [100, 800], [0, 800], 1),
    ('t', 100, 600, [100, 700], [0, 1000], 1),
    ('u', 100, 700, [100, 800], [0, 700], 1),
    ('v', 100, 600, [100, 700], [0, 700], 1),
    ('w', 100, 1000, [100, 1100], [0, 700], 1),
    ('x', 100, 700, [100, 800], [0, 700], 1),
    ('y', 100, 600, [100, 700], [-300, 700], 1),
    ('z', 100, 600, [100, 700], [0, 700], 1),
    ('{', 100, 500, [100, 500], [-200, 1200], 1),
    ('|', 100, 400, [100, 300], [-100, 1100], 1),
    ('}', 100, 500, [100, 500], [-200, 1200], 1),
    ('~', 100, 800, [100, 900], [400, 800], 1),
    ('µ', 100, 700, [100, 800], [-300, 700], 1),
];

fn paths(glyph: &Glyph) -> Paths64 {
    #[expect(clippy::cast_possible_truncation, reason = "a few thousand units")]
    let step = |units: f64| (units * STEPS).round() as i64;
    let path =
        |outline: &Vec<Point>| -> Path64 { outline.iter().map(|p| Point64::new(step(p.x), step(p.y))).collect() };
    // Clipper counts counter-clockwise outlines as positive.
    glyph.outlines.iter().map(|outline| path(outline).into_iter().rev().collect()).collect()
}

/// What is around a glyph, with a margin.
fn background(glyph: &Glyph) -> Paths64 {
    let frame = Glyph {
        outlines: vec![
            vec![(-500, -800), (-500, 1700), (1700, 1700), (1700, -800)].into_iter().map(Point::from).collect(),
        ],
        ..glyph.clone()
    };
    difference_64(&paths(&frame), &paths(glyph), FillRule::NonZero)
}

fn grown(region: &Paths64, by: f64) -> Paths64 {
    inflate_paths_64(region, by * STEPS, JoinType::Round, EndType::Polygon, 2.0, 0.05 * STEPS)
}

/// Area (square units) of what is narrower than a limit, beyond what corners lose.
fn narrower_than(region: &Paths64, limit: f64) -> f64 {
    let radius = limit / 2.0;
    let opened = grown(&grown(region, -radius), radius);
    // A disc that touches both sides of a corner leaves its tip this far outside.
    let corner = radius * (1.0 / (SHARPEST / 2.0).to_radians().sin() - 1.0);
    area_paths(&difference_64(region, &grown(&opened, corner + 0.5), FillRule::NonZero)) / (STEPS * STEPS)
}

#[test]
fn every_glyph_has_the_metrics_of_the_specification() {
    assert_eq!(deplof::glyphs().len(), METRICS.len());
    for (glyph, (character, indent, width, x, y, polygons)) in deplof::glyphs().iter().zip(METRICS) {
        let ink = Rect::around(glyph.outlines.iter().flatten().copied()).unwrap();
        assert_eq!(glyph.character, character);
        assert_eq!((glyph.indent, glyph.width), (indent.into(), width.into()), "{character}");
        assert_eq!(ink, Rect::new((x[0], y[0]), (x[1], y[1])), "{character}");
        assert_eq!(glyph.outlines.len(), polygons, "{character}");
    }
}

#[test]
fn no_glyph_has_an_island_in_either_tone() {
    for glyph in deplof::glyphs() {
        let ink = union_subjects_64(&paths(glyph), FillRule::NonZero);
        assert_eq!(ink.len(), glyph.outlines.len(), "{}: polygons overlap or enclose something", glyph.character);
        assert!(ink.iter().all(|path| area(path) > 0.0), "{} encloses a counter", glyph.character);
        let pieces = background(glyph).iter().filter(|path| area(path) > 0.0).count();
        assert_eq!(pieces, 1, "the area around {} is in several parts", glyph.character);
    }
}

#[test]
fn no_stroke_is_narrower_than_the_limit() {
    for glyph in deplof::glyphs() {
        // Slanted edges are on whole units, and off by up to one.
        let lost = narrower_than(&paths(glyph), STROKE - 1.5);
        assert!(lost < 1.0, "{}: {lost} square units are narrower than a stroke", glyph.character);
    }
}

/// An edge of a clockwise outline, with the direction out of the ink.
struct Side {
    ends: [Point; 2],
    out: Point,
}

fn sides(glyph: &Glyph) -> Vec<Side> {
    let side = |(a, b): (&Point, &Point)| {
        let along = (*b - *a) / a.distance(*b);
        Side { ends: [*a, *b], out: Point::new(-along.y, along.x) }
    };
    glyph.outlines.iter().flat_map(|outline| outline.iter().zip(outline.iter().cycle().skip(1)).map(side)).collect()
}

/// The shortest way from a point to an edge.
fn way(from: Point, to: &Side) -> Point {
    let [a, b] = to.ends;
    let share = (from - a).dot(b - a) / (b - a).dot(b - a);
    a + (b - a) * share.clamp(0.0, 1.0) - from
}

/// The shortest way, outside the ink, between two edges that face each other.
fn narrowest_gap(glyph: &Glyph) -> f64 {
    /// Edges at right angles do not face each other; vertices on whole units turn short ones by a few degrees.
    const FACING: f64 = -0.1;
    let sides = sides(glyph);
    let mut narrowest = f64::INFINITY;
    for a in &sides {
        for b in sides.iter().filter(|b| a.out.dot(b.out) < FACING) {
            // The shortest segment between two disjoint edges starts at an end of one of them.
            let ways = a.ends.map(|p| way(p, b)).into_iter().chain(b.ends.map(|p| -way(p, a)));
            let outside = ways.filter(|way| way.dot(a.out) > 1e-6 && way.dot(b.out) < -1e-6);
            narrowest = outside.map(Point::norm).fold(narrowest, f64::min);
        }
    }
    narrowest
}

#[test]
fn no_gap_is_narrower_than_the_limit() {
    for glyph in deplof::glyphs() {
        let gap = narrowest_gap(glyph);
        assert!(gap >= GAP, "{} has a gap of {gap} units", glyph.character);
        let lost = narrower_than(&background(glyph), GAP - 0.5);
        assert!(lost < 1.0, "{}: {lost} square units are narrower than the smallest gap", glyph.character);
    }
}

#[test]
fn the_judge_finds_narrow_strokes_and_gaps() {
    let bars = |width: i32, gap: i32| {
        let bar = |x: i32| [(x, 0), (x, 900), (x + width, 900), (x + width, 0)].into_iter().map(Point::from).collect();
        Glyph { character: '?', indent: 0.0, width: 0.0, outlines: vec![bar(0), bar(width + gap)] }
    };
    let thin = bars(180, 100);
    assert!(
        narrower_than(&paths(&thin), STROKE - 1.5) > 100_000.0 && narrower_than(&background(&thin), GAP - 0.5) < 1.0
    );
    let near = bars(200, 75);
    assert!(
        narrower_than(&paths(&near), STROKE - 1.5) < 1.0 && narrower_than(&background(&near), GAP - 0.5) > 10_000.0
    );
}

#[test]
fn every_corner_is_blunt_on_both_sides_and_every_outline_clockwise() {
    for glyph in deplof::glyphs() {
        for outline in &glyph.outlines {
            assert!(phidl_core::geom::signed_area(outline) < 0.0, "{}", glyph.character);
            for i in 0..outline.len() {
                let at = |offset: usize| outline[(i + offset) % outline.len()];
                let (back, ahead) = (at(0) - at(1), at(2) - at(1));
                let angle = back.cross(ahead).atan2(back.dot(ahead)).to_degrees().abs();
                assert!(angle >= SHARPEST, "{} has a corner of {angle}° at {}", glyph.character, at(1));
                assert_eq!((at(0).x.fract(), at(0).y.fract()), (0.0, 0.0), "{}", glyph.character);
            }
        }
    }
}
