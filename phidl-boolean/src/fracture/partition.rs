//! Joins triangles to parts with a limited number of points.

use super::{
    corners::Corners,
    triangulate::{NONE, Triangles},
};
use crate::{contours::Contours, point::GridPoint};

/// The triangles as a forest.
struct Forest<'a> {
    corners: &'a Corners,
    triangles: &'a Triangles,
    parent: Vec<u32>,
    /// Each triangle after its parent.
    order: Vec<u32>,
}

/// Joins triangles to few parts, by a greedy walk.
pub(super) fn parts(corners: &Corners, triangles: &Triangles, max_points: usize) -> Contours {
    let mut forest = Forest::new(corners, triangles);
    forest.cut(max_points - 2);
    let mut parts = Contours::new();
    let mut outline = Vec::new();
    for &root in &forest.order {
        if forest.parent[root as usize] == NONE {
            outline.clear();
            forest.walk_around(root, &mut outline);
            parts.push(outline.iter().copied());
        }
    }
    parts
}

impl<'a> Forest<'a> {
    #[expect(clippy::cast_possible_truncation, reason = "a region has fewer than 2^31 points")]
    fn new(corners: &'a Corners, triangles: &'a Triangles) -> Self {
        let count = triangles.corners.len();
        let mut forest = Self { corners, triangles, parent: vec![NONE; count], order: Vec::with_capacity(count) };
        let mut is_reached = vec![false; count];
        let mut stack = Vec::new();
        for root in 0..count {
            if is_reached[root] {
                continue;
            }
            is_reached[root] = true;
            stack.push(root as u32);
            while let Some(triangle) = stack.pop() {
                forest.order.push(triangle);
                for other in triangles.across[triangle as usize] {
                    if other != NONE && !is_reached[other as usize] {
                        is_reached[other as usize] = true;
                        forest.parent[other as usize] = triangle;
                        stack.push(other);
                    }
                }
            }
        }
        forest
    }

    /// Cuts branches off so that no tree has more than `limit` triangles; `t` triangles have `t + 2` points around.
    fn cut(&mut self, limit: usize) {
        let mut size = vec![1; self.triangles.corners.len()];
        for &triangle in self.order.iter().rev() {
            let across = self.triangles.across[triangle as usize];
            let mut branches = across;
            let mut count = 0;
            for branch in across.into_iter().filter(|&b| b != NONE && self.parent[b as usize] == triangle) {
                branches[count] = branch;
                count += 1;
            }
            let branches = &mut branches[..count];
            branches.sort_unstable_by_key(|&branch| size[branch as usize]);
            let mut total = 1 + branches.iter().map(|&branch| size[branch as usize]).sum::<usize>();
            for &largest in branches.iter().rev() {
                if total <= limit {
                    break;
                }
                total -= size[largest as usize];
                self.parent[largest as usize] = NONE;
            }
            size[triangle as usize] = total;
        }
    }

    /// Writes the corners around the tree of `root`, counter-clockwise.
    fn walk_around(&self, root: u32, outline: &mut Vec<GridPoint>) {
        let mut todo = vec![(root, 0, 3)];
        while let Some((triangle, edge, left)) = todo.pop() {
            if left == 0 {
                continue;
            }
            todo.push((triangle, (edge + 1) % 3, left - 1));
            let other = self.triangles.across[triangle as usize][edge];
            if other != NONE && self.parent[other as usize] == triangle {
                // Around the branch instead of over the edge: all its edges but the one it is reached over.
                let across = self.triangles.across[other as usize];
                let entry = across.iter().position(|&back| back == triangle).unwrap_or(0);
                todo.push((other, (entry + 1) % 3, 2));
            } else {
                outline.push(self.corners.point(self.triangles.corners[triangle as usize][edge]));
            }
        }
    }
}
