//! Comparison with an independent engine. Nothing else in this crate names `i_overlay`.

use i_overlay::{
    core::{fill_rule::FillRule, overlay::Overlay, overlay_rule::OverlayRule},
    i_float::int::point::IntPoint,
};
use phidl_boolean::{
    Division, Operation, Region, RunOptions,
    grid::{Contours, GridPoint, boolean},
};

use crate::support::confetti;

fn paths(contours: &Contours) -> Vec<Vec<IntPoint<i64>>> {
    contours.iter().map(|contour| contour.iter().map(|p| IntPoint::new(p.x, p.y)).collect()).collect()
}

fn from_oracle(a: &Contours, b: &Contours, rule: OverlayRule) -> Region {
    let shapes = Overlay::<i64>::from_subj_and_clip(&paths(a), &paths(b)).overlay(rule, FillRule::NonZero);
    let contours = shapes.iter().flatten().map(|contour| contour.iter().map(|p| GridPoint::new(p.x, p.y)));
    let contours: Contours = contours.map(Iterator::collect::<Vec<_>>).collect();
    // Its outlines are counter-clockwise and its holes clockwise, so they cover by winding; xor needs no more.
    holes_kept(&contours)
}

/// A region from outlines and holes, made of unions and differences of single outlines' signs.
fn holes_kept(contours: &Contours) -> Region {
    let run = RunOptions::default();
    let part = |sign: i128| -> Contours {
        let of_sign = |c: &&[GridPoint]| phidl_boolean::grid::signed_area2(c).signum() == sign;
        contours.iter().filter(of_sign).map(<[_]>::to_vec).collect()
    };
    boolean(&part(1), &part(-1), Operation::Not, &run).unwrap()
}

fn perimeter(region: &Region) -> f64 {
    let length = |(p, q): (&GridPoint, &GridPoint)| ((p.x - q.x) as f64).hypot((p.y - q.y) as f64);
    region.contours().iter().map(|c| c.iter().zip(c.iter().cycle().skip(1)).map(length).sum::<f64>()).sum()
}

#[test]
fn a_crowded_scene_agrees_with_an_independent_engine() {
    let (a, b) = (confetti(60, 1), confetti(60, 2));
    for (operation, rule) in [
        (Operation::Or, OverlayRule::Union),
        (Operation::And, OverlayRule::Intersect),
        (Operation::Not, OverlayRule::Difference),
        (Operation::NotReversed, OverlayRule::InverseDifference),
        (Operation::Xor, OverlayRule::Xor),
    ] {
        let ours =
            boolean(&a, &b, operation, &RunOptions { division: Division::Vertices(300), ..RunOptions::default() })
                .unwrap();
        let theirs = from_oracle(&a, &b, rule);
        let difference = &ours ^ &theirs;
        assert!(ours.area() > 1e8, "{operation:?} found next to nothing");
        assert!(difference.area() <= 0.5 * perimeter(&ours), "{operation:?}: {}", difference.area());
    }
}
