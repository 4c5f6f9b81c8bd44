//! Joins triangles to parts with a limited number of points.

use super::{diagonals::Diagonal, triangulate::Triangle};
use crate::{contours::Contours, point::GridPoint};

const NONE: usize = usize::MAX;

/// The triangles as a forest.
struct Forest<'a> {
    triangles: &'a [Triangle],
    /// The triangle across each edge; none across rings and bridges.
    across: Vec<[usize; 3]>,
    parent: Vec<usize>,
    /// Each triangle after its parent.
    order: Vec<usize>,
}

/// Joins triangles to few parts, by a greedy walk.
pub(super) fn parts(triangles: &[Triangle], diagonals: &[Diagonal], max_points: usize) -> Contours {
    let mut forest = Forest::new(triangles, diagonals);
    forest.cut(max_points - 2);
    let mut parts = Contours::new();
    let mut outline = Vec::new();
    for &root in &forest.order {
        if forest.parent[root] == NONE {
            outline.clear();
            forest.walk_around(root, &mut outline);
            parts.push(outline.iter().copied());
        }
    }
    parts
}

impl<'a> Forest<'a> {
    fn new(triangles: &'a [Triangle], diagonals: &[Diagonal]) -> Self {
        let across = neighbors(triangles, diagonals);
        let mut forest = Self { triangles, across, parent: vec![NONE; triangles.len()], order: Vec::new() };
        let mut is_reached = vec![false; triangles.len()];
        let mut stack = Vec::new();
        for root in 0..triangles.len() {
            if is_reached[root] {
                continue;
            }
            is_reached[root] = true;
            stack.push(root);
            while let Some(triangle) = stack.pop() {
                forest.order.push(triangle);
                for other in forest.across[triangle] {
                    if other != NONE && !is_reached[other] {
                        is_reached[other] = true;
                        forest.parent[other] = triangle;
                        stack.push(other);
                    }
                }
            }
        }
        forest
    }

    /// Cuts branches off so that no tree has more than `limit` triangles; `t` triangles have `t + 2` points around.
    fn cut(&mut self, limit: usize) {
        let mut size = vec![1; self.triangles.len()];
        for &triangle in self.order.iter().rev() {
            let mut branches: Vec<usize> =
                self.across[triangle].into_iter().filter(|&b| b != NONE && self.parent[b] == triangle).collect();
            branches.sort_unstable_by_key(|&branch| size[branch]);
            size[triangle] += branches.iter().map(|&branch| size[branch]).sum::<usize>();
            while size[triangle] > limit {
                let Some(largest) = branches.pop() else { break };
                size[triangle] -= size[largest];
                self.parent[largest] = NONE;
            }
        }
    }

    /// Writes the corners around the tree of `root`, counter-clockwise.
    fn walk_around(&self, root: usize, outline: &mut Vec<GridPoint>) {
        let mut todo = vec![(root, 0, 3)];
        while let Some((triangle, edge, left)) = todo.pop() {
            if left == 0 {
                continue;
            }
            todo.push((triangle, (edge + 1) % 3, left - 1));
            let other = self.across[triangle][edge];
            if other != NONE && self.parent[other] == triangle {
                // Around the branch instead of over the edge: all its edges but the one it is reached over.
                let entry = self.across[other].iter().position(|&back| back == triangle).unwrap_or(0);
                todo.push((other, (entry + 1) % 3, 2));
            } else {
                outline.push(self.triangles[triangle][edge]);
            }
        }
    }
}

/// The triangle across each edge of each triangle.
fn neighbors(triangles: &[Triangle], diagonals: &[Diagonal]) -> Vec<[usize; 3]> {
    let mut edges: Vec<(GridPoint, GridPoint, usize, usize)> = Vec::with_capacity(3 * triangles.len());
    for (number, triangle) in triangles.iter().enumerate() {
        for edge in 0..3 {
            edges.push((triangle[edge], triangle[(edge + 1) % 3], number, edge));
        }
    }
    edges.sort_unstable();
    let mut bridges: Vec<(GridPoint, GridPoint)> =
        diagonals.iter().filter(|c| c.is_bridge).map(|c| (c.from, c.to)).collect();
    bridges.sort_unstable();

    let mut across = vec![[NONE; 3]; triangles.len()];
    for &(from, to, number, edge) in &edges {
        let twin = edges.partition_point(|other| (other.0, other.1) < (to, from));
        let is_open = bridges.binary_search(&(from.min(to), from.max(to))).is_err();
        if let Some(&(a, b, other, _)) = edges.get(twin)
            && (a, b) == (to, from)
            && is_open
        {
            across[number][edge] = other;
        }
    }
    across
}
