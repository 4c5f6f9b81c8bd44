//! Trapezoids: from a few numbers to corners.
//!
//! All corners run clockwise from the lower left of the bounding box.

/// The corners of a TRAPEZOID: `a` and `b` say how far the second of two parallel sides is moved against the first at
/// either end. `None` if a side would have a negative length.
pub(super) fn corners(vertical: bool, [w, h]: [i64; 2], a: i64, b: i64) -> Option<[[i64; 2]; 4]> {
    let (forward, back) = ([a.max(0), b.max(0)], [(-a).max(0), (-b).max(0)]);
    let length = if vertical { h } else { w };
    let first = length.checked_sub(forward[0])?.checked_sub(back[1])?;
    let second = length.checked_sub(back[0])?.checked_sub(forward[1])?;
    if first < 0 || second < 0 {
        return None;
    }
    Some(if vertical {
        [[0, forward[0]], [0, h - back[1]], [w, h - forward[1]], [w, back[0]]]
    } else {
        [[forward[0], h], [w - back[1], h], [w - forward[1], 0], [back[0], 0]]
    })
}

/// Which of width and height a type of CTRAPEZOID takes from its record; the other one follows from it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sides {
    Both,
    Width,
    Height,
}

/// The sides that a type of CTRAPEZOID has. `None` if there is no such type.
pub(super) fn sides(kind: u64) -> Option<Sides> {
    match kind {
        16..=19 | 22 | 23 | 25 => Some(Sides::Width),
        20 | 21 => Some(Sides::Height),
        0..=25 => Some(Sides::Both),
        _ => None,
    }
}

/// The corners of a CTRAPEZOID: three or four. `None` if there is no such type, or a side would have a negative length.
/// Width and height are below 2⁶¹.
pub(super) fn compact(kind: u64, [w, h]: [i64; 2]) -> Option<Vec<[i64; 2]>> {
    let (upright, flat) = (w - h, h - w);
    let shortest = match kind {
        0..=3 => upright,
        4..=7 => w - 2 * h,
        8..=11 => flat,
        12..=15 => h - 2 * w,
        _ => 0,
    };
    if shortest < 0 {
        return None;
    }
    let corners: &[[i64; 2]] = match kind {
        0 => &[[0, 0], [0, h], [upright, h], [w, 0]],
        1 => &[[0, 0], [0, h], [w, h], [upright, 0]],
        2 => &[[0, 0], [h, h], [w, h], [w, 0]],
        3 => &[[h, 0], [0, h], [w, h], [w, 0]],
        4 => &[[0, 0], [h, h], [upright, h], [w, 0]],
        5 => &[[h, 0], [0, h], [w, h], [upright, 0]],
        6 => &[[0, 0], [h, h], [w, h], [upright, 0]],
        7 => &[[h, 0], [0, h], [upright, h], [w, 0]],
        8 => &[[0, 0], [0, h], [w, flat], [w, 0]],
        9 => &[[0, 0], [0, flat], [w, h], [w, 0]],
        10 => &[[0, 0], [0, h], [w, h], [w, w]],
        11 => &[[0, w], [0, h], [w, h], [w, 0]],
        12 => &[[0, 0], [0, h], [w, flat], [w, w]],
        13 => &[[0, w], [0, flat], [w, h], [w, 0]],
        14 => &[[0, 0], [0, flat], [w, h], [w, w]],
        15 => &[[0, w], [0, h], [w, flat], [w, 0]],
        16 => &[[0, 0], [0, w], [w, 0]],
        17 => &[[0, 0], [0, w], [w, w]],
        18 => &[[0, 0], [w, w], [w, 0]],
        19 => &[[0, w], [w, w], [w, 0]],
        20 => &[[0, 0], [h, h], [2 * h, 0]],
        21 => &[[0, h], [2 * h, h], [h, 0]],
        22 => &[[0, 0], [0, 2 * w], [w, w]],
        23 => &[[w, 0], [0, w], [w, 2 * w]],
        24 => &[[0, 0], [0, h], [w, h], [w, 0]],
        25 => &[[0, 0], [0, w], [w, w], [w, 0]],
        _ => return None,
    };
    Some(corners.to_vec())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn doubled_area(corners: &[[i64; 2]]) -> i64 {
        let next = corners[1..].iter().chain(&corners[..1]);
        corners.iter().zip(next).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum::<i64>().abs()
    }

    /// The areas follow from the drawings of section 28 of SEMI P39: a rectangle, less one or two right triangles.
    #[test]
    fn compact_trapezoids_have_the_areas_of_the_standard() {
        let (w, h) = (30, 10);
        for kind in 0..=3 {
            assert_eq!(doubled_area(&compact(kind, [w, h]).unwrap()), 2 * w * h - h * h, "{kind}");
        }
        for kind in 4..=7 {
            assert_eq!(doubled_area(&compact(kind, [w, h]).unwrap()), 2 * w * h - 2 * h * h, "{kind}");
        }
        let (w, h) = (10, 30);
        for kind in 8..=11 {
            assert_eq!(doubled_area(&compact(kind, [w, h]).unwrap()), 2 * w * h - w * w, "{kind}");
        }
        for kind in 12..=15 {
            assert_eq!(doubled_area(&compact(kind, [w, h]).unwrap()), 2 * w * h - 2 * w * w, "{kind}");
        }
        let doubled = |kind, size| doubled_area(&compact(kind, size).unwrap());
        assert_eq!([16, 17, 18, 19].map(|kind| doubled(kind, [w, 0])), [w * w; 4]);
        assert_eq!([20, 21].map(|kind| doubled(kind, [0, h])), [2 * h * h; 2]);
        assert_eq!([22, 23].map(|kind| doubled(kind, [w, 0])), [2 * w * w; 2]);
        assert_eq!((doubled(24, [w, h]), doubled(25, [w, 0])), (2 * w * h, 2 * w * w));
    }

    #[test]
    fn every_compact_trapezoid_touches_all_sides_of_its_box() {
        for kind in 0..=25 {
            let size = if (8..16).contains(&kind) { [10, 30] } else { [30, 10] };
            let corners = compact(kind, size).unwrap();
            let box_of = match kind {
                16..=19 | 25 => [30, 30],
                20 | 21 => [20, 10],
                22 | 23 => [30, 60],
                _ => size,
            };
            for (axis, length) in box_of.into_iter().enumerate() {
                let along = || corners.iter().map(|corner| corner[axis]);
                assert_eq!((along().min(), along().max()), (Some(0), Some(length)), "{kind}");
            }
        }
    }

    #[test]
    fn trapezoids_lean_to_either_side() {
        let horizontal = corners(false, [30, 10], 4, -5).unwrap();
        assert_eq!(horizontal, [[4, 10], [25, 10], [30, 0], [0, 0]]);
        let horizontal = corners(false, [30, 10], -4, 5).unwrap();
        assert_eq!(horizontal, [[0, 10], [30, 10], [25, 0], [4, 0]]);
        let vertical = corners(true, [10, 30], 4, -5).unwrap();
        assert_eq!(vertical, [[0, 4], [0, 25], [10, 30], [10, 0]]);
    }

    #[test]
    fn sides_of_negative_length_are_refused() {
        assert_eq!(corners(false, [8, 10], 4, -5), None);
        assert_eq!(corners(true, [10, 8], -4, 5), None);
        assert!(compact(4, [19, 10]).is_none() && compact(4, [20, 10]).is_some());
        assert!(compact(0, [9, 10]).is_none() && compact(12, [10, 19]).is_none() && compact(26, [1, 1]).is_none());
        assert_eq!(
            (sides(26), sides(25), sides(21), sides(24)),
            (None, Some(Sides::Width), Some(Sides::Height), Some(Sides::Both))
        );
    }
}
