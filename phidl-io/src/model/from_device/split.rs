//! Cutting outlines that have more corners than a record holds.
//!
//! The outline, already on the grid, is cut along a line of the grid through the middle of its corners, until every piece
//! is small enough. Both sides of a cut share its points, so no gap and no overlap arises. Cut points on level, upright
//! and 45° edges lie on the edge exactly; on other edges they are off by at most half a grid step, as every corner of such
//! a shape is. Several coordinate records for one outline, as gdspy writes them, would keep the edges, but most readers
//! refuse that or read the first record only.

use crate::model::Corner;

/// Pieces of at most `most` corners that cover what the outline covers. `most` is at least 16.
pub(super) fn split(outline: Vec<Corner>, most: usize) -> Vec<Vec<Corner>> {
    let mut small = Vec::new();
    let mut large = vec![outline];
    while let Some(piece) = large.pop() {
        if piece.len() <= most {
            small.push(piece);
            continue;
        }
        let halves = [wide_axis(&piece), 1 - wide_axis(&piece)].into_iter().find_map(|axis| halved(&piece, axis));
        match halves {
            Some(halves) => large.extend(halves.into_iter().rev()),
            // All corners on few points: no cut makes it smaller, and it covers nothing.
            None => small.push(without_repeats(piece, most)),
        }
    }
    small
}

/// The axis along which the outline is wider.
fn wide_axis(outline: &[Corner]) -> usize {
    let extent = |axis: usize| {
        let (min, max) = outline.iter().fold((i32::MAX, i32::MIN), |(a, b), p| (a.min(p[axis]), b.max(p[axis])));
        i64::from(max) - i64::from(min)
    };
    usize::from(extent(1) > extent(0))
}

/// The pieces on both sides of a cut across an axis, all smaller than the outline; `None` if no cut makes them so.
fn halved(outline: &[Corner], axis: usize) -> Option<Vec<Vec<Corner>>> {
    let mut positions: Vec<i32> = outline.iter().map(|p| p[axis]).collect();
    positions.sort_unstable();
    positions.dedup();
    let at = *positions.get(positions.len() / 2).filter(|_| positions.len() > 2)?;
    let pieces = cut(outline, axis, at);
    pieces.iter().all(|piece| piece.len() < outline.len()).then_some(pieces)
}

/// Cuts an outline along the line where the coordinate of an axis is `at`.
///
/// Corners on the line count as beyond it, so every edge either crosses the line once or not at all. Sorted along the
/// line, the crossings enclose the inside by pairs, also where the seam of a keyhole crosses twice at one point: there,
/// out and in alternate.
fn cut(outline: &[Corner], axis: usize, at: i32) -> Vec<Vec<Corner>> {
    let (chains, mut crossings) = chains(outline, axis, at);
    crossings.sort_by_key(|crossing| (crossing.along, crossing.chain_after));
    alternate(&mut crossings);
    // The partner of the crossing at which each chain ends is where the next chain of the piece begins.
    let mut next = vec![0; chains.len()];
    for pair in crossings.chunks_exact(2) {
        let [a, b] = [&pair[0], &pair[1]];
        next[a.chain_before] = b.chain_after;
        next[b.chain_before] = a.chain_after;
    }
    let mut pieces = Vec::new();
    let mut used = vec![false; chains.len()];
    for first in 0..chains.len() {
        let mut piece = Vec::new();
        let mut chain = first;
        while !used[chain] {
            used[chain] = true;
            piece.extend_from_slice(&chains[chain]);
            chain = next[chain];
        }
        piece.dedup();
        if piece.len() > 2 {
            pieces.push(piece);
        }
    }
    pieces
}

/// A point where the outline crosses the line.
struct Crossing {
    /// The position on the line, in steps.
    along: i64,
    outward: bool,
    /// The chain that ends here.
    chain_before: usize,
    /// The chain that begins here.
    chain_after: usize,
}

/// The parts of an outline between its crossings, each with the crossings at both ends, and the crossings.
fn chains(outline: &[Corner], axis: usize, at: i32) -> (Vec<Vec<Corner>>, Vec<Crossing>) {
    let beyond = |p: &Corner| p[axis] >= at;
    let edges = || outline.iter().zip(outline.iter().cycle().skip(1));
    let Some(start) = edges().position(|(p, q)| beyond(p) != beyond(q)) else {
        return (vec![outline.to_vec()], Vec::new());
    };
    let count = edges().filter(|(p, q)| beyond(p) != beyond(q)).count();
    let mut chains: Vec<Vec<Corner>> = vec![Vec::new(); count];
    let mut crossings = Vec::with_capacity(count);
    let mut chain = count - 1;
    for (p, q) in edges().cycle().skip(start).take(outline.len()) {
        if beyond(p) != beyond(q) {
            let along = crossing_position(p, q, axis, at);
            let mut corner = [at; 2];
            corner[1 - axis] = along;
            let after = (chain + 1) % count;
            chains[chain].push(corner);
            chains[after].push(corner);
            let along = i64::from(along);
            crossings.push(Crossing { along, outward: beyond(q), chain_before: chain, chain_after: after });
            chain = after;
        }
        chains[chain].push(*q);
    }
    // The first chain to be filled was the last one; its end was put in front.
    chains[count - 1].rotate_left(1);
    (chains, crossings)
}

/// Where the edge from `p` to `q` meets the line, to the nearest step.
fn crossing_position(p: &Corner, q: &Corner, axis: usize, at: i32) -> i32 {
    // From the same end for both directions of an edge, so that the two sides of a seam meet in one point.
    let (p, q) = if p[axis] < q[axis] { (p, q) } else { (q, p) };
    let wide = |v: i32| i128::from(v);
    let run = wide(q[axis]) - wide(p[axis]);
    let rise = wide(q[1 - axis]) - wide(p[1 - axis]);
    let part = (wide(at) - wide(p[axis])) * rise;
    let offset = (2 * part + run).div_euclid(2 * run);
    i32::try_from(wide(p[1 - axis]) + offset).expect("invariant: a point of an edge lies between its ends")
}

/// Orders crossings at one point so that out and in alternate along the line.
fn alternate(crossings: &mut [Crossing]) {
    for index in 1..crossings.len() {
        if crossings[index].outward != crossings[index - 1].outward {
            continue;
        }
        let here = crossings[index].along;
        let same_point = crossings[index..].iter().take_while(|crossing| crossing.along == here);
        let other = same_point.clone().position(|crossing| crossing.outward != crossings[index].outward);
        if let Some(other) = other {
            crossings.swap(index, index + other);
        }
    }
}

/// An outline that covers nothing, with at most `most` corners.
fn without_repeats(mut outline: Vec<Corner>, most: usize) -> Vec<Corner> {
    outline.dedup();
    outline.truncate(most);
    outline
}

#[cfg(test)]
mod tests {
    use super::*;

    fn twice_area(outline: &[Corner]) -> i128 {
        let edges = outline.iter().zip(outline.iter().cycle().skip(1));
        edges.map(|(p, q)| i128::from(p[0]) * i128::from(q[1]) - i128::from(p[1]) * i128::from(q[0])).sum()
    }

    /// A comb of upright teeth: 4 corners for each.
    fn comb(teeth: i32) -> Vec<Corner> {
        let mut outline = vec![[0, 0], [10 * teeth, 0]];
        for tooth in (0..teeth).rev() {
            outline.extend([[10 * tooth + 9, 5], [10 * tooth + 9, 100], [10 * tooth + 3, 100], [10 * tooth + 3, 5]]);
        }
        outline
    }

    /// A ring with a seam.
    fn ring(corners: i32) -> Vec<Corner> {
        let circle = |radius: f64, turn: f64| -> Vec<Corner> {
            let corner = |i: i32| {
                let angle = turn * f64::from(i) / f64::from(corners) * std::f64::consts::TAU;
                #[expect(clippy::cast_possible_truncation, reason = "small numbers")]
                let corner = [(radius * angle.cos()).round() as i32, (radius * angle.sin()).round() as i32];
                corner
            };
            (0..=corners).map(corner).collect()
        };
        [circle(100_000.0, 1.0), circle(70_000.0, -1.0)].concat()
    }

    #[test]
    fn pieces_of_upright_shapes_have_the_area_of_the_whole_exactly() {
        let outline = comb(1000);
        let pieces = split(outline.clone(), 100);
        assert!(pieces.iter().all(|piece| (4..=100).contains(&piece.len())));
        assert_eq!(pieces.iter().map(|piece| twice_area(piece)).sum::<i128>(), twice_area(&outline));
        assert!(pieces.iter().all(|piece| twice_area(piece) > 0));
    }

    #[test]
    fn rings_with_seams_keep_hole_and_area() {
        let outline = ring(2000);
        let pieces = split(outline.clone(), 199);
        assert!(pieces.iter().all(|piece| piece.len() <= 199));
        let (whole, parts) = (twice_area(&outline), pieces.iter().map(|piece| twice_area(piece)).sum::<i128>());
        // A cut point moves by half a step at most, which moves the area by less than the two edges at it are long.
        assert!((whole - parts).abs() < 2 * 1000 * i128::try_from(pieces.len()).unwrap(), "{whole} {parts}");
        assert!(pieces.iter().all(|piece| twice_area(piece).signum() == twice_area(&outline).signum()));
    }

    #[test]
    fn both_sides_of_a_cut_share_its_points() {
        let pieces = cut(&ring(360), 0, 12_345);
        let on_line = |piece: &Vec<Corner>| piece.iter().filter(|p| p[0] == 12_345).map(|p| p[1]).collect::<Vec<_>>();
        let (mut left, mut right) = (Vec::new(), Vec::new());
        for piece in &pieces {
            let side = if piece.iter().any(|p| p[0] < 12_345) { &mut left } else { &mut right };
            side.extend(on_line(piece));
        }
        left.sort_unstable();
        right.sort_unstable();
        assert_eq!(left, right);
        assert!(!left.is_empty());
    }

    #[test]
    fn an_outline_on_a_line_ends_without_a_cut() {
        let line: Vec<Corner> = (0..1000).map(|i| [i % 2, 0]).collect();
        assert!(split(line, 16).iter().all(|piece| piece.len() <= 16));
        let point = vec![[7, 7]; 100];
        assert_eq!(split(point, 16), [[[7, 7]]]);
    }

    #[test]
    fn corners_at_the_ends_of_the_grid_do_not_overflow() {
        let (a, b) = (i32::MIN + 1, i32::MAX);
        let outline: Vec<Corner> = (0..20).map(|i| [a + i, a]).chain((0..20).map(|i| [b - i, b])).collect();
        let pieces = split(outline.clone(), 16);
        assert!(pieces.iter().all(|piece| piece.len() <= 16));
    }
}
