//! One outline, welded: members take their class point, edges through seam points get a vertex there.

use phidl_core::geom::Point;
use phidl_core::layer::Layer;

use super::classes::Class;
use super::corner::{Corner, cross, distance_squared, dot, is_on, sub};

/// A corner of the wide side nearer to an inserted vertex than this may be overtaken by it (steps).
const OVERTAKEN_WITHIN: i64 = 4;

/// What became of an outline.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Welded {
    /// No class point moves it or adds a vertex to it.
    Unchanged,
    /// The outline with its class points, and how many vertices were inserted.
    Changed(Vec<Corner>, u64),
    /// With its class points the outline would cross itself.
    Squeezed,
}

/// A vertex on its way.
#[derive(Clone, Copy)]
struct Vertex {
    at: Corner,
    moved: bool,
    inserted: bool,
}

/// The outline with its class points. `truth` are its corners before rounding (µm, in the frame of the anchor), `rounded`
/// the same on the grid.
pub(super) fn weld(truth: &[Point], rounded: &[Corner], layer: Layer, classes: &[&Class], reach: f64) -> Welded {
    let class_at = |p: Point| classes.iter().find(|class| class.truth.distance(p) <= reach);
    let mut outline = Vec::with_capacity(rounded.len() + 4);
    let mut inserted = 0;
    let corner = |i: usize| class_at(truth[i]).map_or(rounded[i], |class| class.corner);
    for i in 0..truth.len() {
        let next = (i + 1) % truth.len();
        let (from, to) = (corner(i), corner(next));
        outline.push(Vertex { at: from, moved: from != rounded[i], inserted: false });
        for class in along(truth[i], truth[next], layer, classes, reach) {
            if !is_on(from, to, class.corner) {
                outline.push(Vertex { at: class.corner, moved: true, inserted: true });
                inserted += 1;
            }
        }
    }
    if !outline.iter().any(|vertex| vertex.moved) {
        return Welded::Unchanged;
    }
    drop_overtaken(&mut outline);
    let folds = |outline: &[Vertex]| crosses_itself_near(outline) || turns_over(outline, rounded);
    let before: Vec<Vertex> = rounded.iter().map(|at| Vertex { at: *at, moved: true, inserted: false }).collect();
    if folds(&outline) && !crosses_itself_near(&before) {
        return Welded::Squeezed;
    }
    Welded::Changed(outline.into_iter().map(|vertex| vertex.at).collect(), inserted)
}

/// The classes of a layer that lie inside an edge, in the order in which it meets them.
fn along<'c>(a: Point, b: Point, layer: Layer, classes: &[&'c Class], reach: f64) -> Vec<&'c Class> {
    let length = a.distance(b);
    if length <= 2.0 * reach {
        return Vec::new();
    }
    let direction = (b - a) / length;
    let inside = |class: &&&'c Class| {
        let offset = class.truth - a;
        let position = offset.dot(direction);
        let on_layer = class.layers.contains(&layer);
        on_layer && position > reach && position < length - reach && offset.cross(direction).abs() <= reach
    };
    let mut found: Vec<&Class> = classes.iter().filter(inside).copied().collect();
    found.sort_by(|p, q| (p.truth - a).dot(direction).total_cmp(&(q.truth - a).dot(direction)));
    found
}

/// Drops corners of a wide edge that an inserted vertex has overtaken by rounding the other way.
fn drop_overtaken(outline: &mut Vec<Vertex>) {
    let counter_clockwise = doubled_area(outline) > 0;
    let mut i = 0;
    while i < outline.len() && outline.len() > 3 {
        let n = outline.len();
        let at = |k: usize| outline[k % n].at;
        let q = outline[i];
        let (before, after) = (outline[(i + n - 1) % n], outline[(i + 1) % n]);
        let convex = (cross(before.at, q.at, after.at) > 0) == counter_clockwise;
        let overtaken = |a: Vertex, b: Corner, c: Corner, material_left: bool| {
            let near = distance_squared(a.at, q.at) < i128::from(OVERTAKEN_WITHIN * OVERTAKEN_WITHIN);
            let backwards = dot(sub(a.at, q.at), sub(b, a.at)) <= 0;
            let side = cross(c, q.at, a.at);
            let outside = if material_left { side <= 0 } else { side >= 0 };
            a.inserted && near && (backwards || (convex && outside))
        };
        // With the inserted vertex after it, the line c–q runs with the outline; before it, against it.
        let drop = !q.inserted
            && (overtaken(after, at(i + 2), before.at, counter_clockwise)
                || overtaken(before, at(i + n - 2), after.at, !counter_clockwise));
        if drop {
            outline.remove(i);
        } else {
            i += 1;
        }
    }
}

/// Whether an edge at a moved vertex properly crosses another edge.
fn crosses_itself_near(outline: &[Vertex]) -> bool {
    let n = outline.len();
    let edge = |i: usize| (outline[i].at, outline[(i + 1) % n].at);
    let moved = (0..n).filter(|i| outline[*i].moved || outline[(*i + 1) % n].moved);
    // Outlines without moved vertices beyond a handful are asked about as a whole only if they are small.
    moved.take(64).any(|i| (0..n).any(|j| i != j && cross_properly(edge(i), edge(j))))
}

fn turns_over(outline: &[Vertex], rounded: &[Corner]) -> bool {
    let before: Vec<Vertex> = rounded.iter().map(|at| Vertex { at: *at, moved: false, inserted: false }).collect();
    doubled_area(outline).signum() * doubled_area(&before).signum() < 0
}

fn cross_properly((a, b): (Corner, Corner), (c, d): (Corner, Corner)) -> bool {
    let sides = |p, q, r, s| cross(p, q, r).signum() * cross(p, q, s).signum() < 0;
    sides(a, b, c, d) && sides(c, d, a, b)
}

fn doubled_area(outline: &[Vertex]) -> i128 {
    let Some(first) = outline.first() else { return 0 };
    outline.windows(2).map(|pair| cross(first.at, pair[0].at, pair[1].at)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn class(x: f64, y: f64, corner: Corner) -> Class {
        Class { truth: Point::new(x, y), corner, layers: vec![Layer::new(1, 0)] }
    }

    fn square() -> (Vec<Point>, Vec<Corner>) {
        let rounded = vec![[0, 0], [1000, 0], [1000, 1000], [0, 1000]];
        let truth = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(x, y)| Point::from((x, y)));
        (truth.to_vec(), rounded)
    }

    #[test]
    fn members_move_and_edges_get_vertices() {
        let (truth, rounded) = square();
        let (corner, inside) = (class(1.0, 0.0, [1001, 0]), class(1.0, 0.4, [1001, 400]));
        let other_layer = Class { layers: vec![Layer::new(2, 0)], ..class(0.0, 0.5, [-1, 500]) };
        let welded = weld(&truth, &rounded, Layer::new(1, 0), &[&corner, &inside, &other_layer], 1e-6);
        assert_eq!(welded, Welded::Changed(vec![[0, 0], [1001, 0], [1001, 400], [1000, 1000], [0, 1000]], 1));
    }

    #[test]
    fn nothing_changes_where_the_class_points_are_on_the_outline_already() {
        let (truth, rounded) = square();
        let (corner, inside) = (class(1.0, 0.0, [1000, 0]), class(1.0, 0.4, [1000, 400]));
        assert_eq!(weld(&truth, &rounded, Layer::new(1, 0), &[&corner, &inside], 1e-6), Welded::Unchanged);
    }

    #[test]
    fn a_corner_that_is_overtaken_gives_way() {
        // The edge runs up; the inserted vertex lies a step beyond the corner where the edge ends.
        let truth = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(|(x, y)| Point::new(x, y));
        let rounded = [[0, 0], [1000, 0], [1000, 1000], [0, 1000]];
        let near_end = class(1.0, 0.9995, [1000, 1001]);
        let welded = weld(&truth, &rounded, Layer::new(1, 0), &[&near_end], 1e-6);
        assert_eq!(welded, Welded::Changed(vec![[0, 0], [1000, 0], [1000, 1001], [0, 1000]], 1));
    }

    #[test]
    fn an_outline_that_would_turn_over_is_squeezed() {
        let truth = [(0.0, 0.0), (1.0, 0.0), (1.0, 0.001), (0.0, 0.001)].map(|(x, y)| Point::new(x, y));
        let rounded = [[0, 0], [1000, 0], [1000, 1], [0, 1]];
        let (low, high) = (class(1.0, 0.0, [1000, 2]), class(0.0, 0.0, [0, 2]));
        assert_eq!(weld(&truth, &rounded, Layer::new(1, 0), &[&low, &high], 1e-6), Welded::Squeezed);
    }
}
