//! Triangulation of a polygon that diagonals cut into monotone mountains.

use super::{corners::Corners, diagonals::Diagonal, half_edges::HalfEdges};
use crate::point::cross;

/// No triangle.
pub(super) const NONE: u32 = u32::MAX;

/// The triangles of a polygon.
#[derive(Default)]
pub(super) struct Triangles {
    /// Corners counter-clockwise; edge `i` runs from corner `i` to the next.
    pub(super) corners: Vec<[u32; 3]>,
    /// The triangle across each edge; [`NONE`] across rings and bridges.
    pub(super) across: Vec<[u32; 3]>,
}

/// An edge of a triangle.
#[derive(Clone, Copy)]
struct TriangleEdge {
    triangle: u32,
    edge: u8,
}

/// An edge of what is left of a face: a half-edge, or the edge of a triangle that was cut off.
#[derive(Clone, Copy)]
enum ChainEdge {
    Half(u32),
    Cut(TriangleEdge),
}

/// Cuts a polygon into triangles that have all diagonals among their edges.
pub(super) fn triangles(corners: &Corners, diagonals: &[Diagonal]) -> Triangles {
    let halves = HalfEdges::new(corners, diagonals.iter());
    let mut cutter = Cutter {
        corners,
        triangles: Triangles::default(),
        owners: vec![TriangleEdge { triangle: NONE, edge: 0 }; halves.len()],
        chain: Vec::new(),
    };
    halves.for_each_face(|face, halves| cutter.cut_mountain(face, halves));
    let twins = cutter.owners[corners.edges()..].chunks_exact(2).zip(diagonals);
    for (twins, _) in twins.filter(|(_, diagonal)| !diagonal.is_bridge) {
        cutter.triangles.link(twins[0], twins[1]);
    }
    cutter.triangles
}

struct Cutter<'a> {
    corners: &'a Corners,
    triangles: Triangles,
    /// The edge of a triangle on each half-edge.
    owners: Vec<TriangleEdge>,
    /// Corners, and the edge that ends at each.
    chain: Vec<(u32, ChainEdge)>,
}

impl Cutter<'_> {
    /// A monotone mountain has one edge from its leftmost to its rightmost corner, so each convex corner of the chain is an
    /// ear.
    fn cut_mountain(&mut self, face: &[u32], halves: &[u32]) {
        let Some(chain_start) = base_end(face) else { return };
        let n = face.len();
        let base = halves[(chain_start + n - 1) % n];
        self.chain.clear();
        for step in 0..n {
            let corner = face[(chain_start + step) % n];
            let mut arriving = ChainEdge::Half(halves[(chain_start + step + n - 1) % n]);
            while let [.., (a, _), (b, before)] = self.chain[..] {
                let [p, q, r] = [a, b, corner].map(|corner| self.corners.point(corner));
                if cross(p, q, r) <= 0 {
                    break;
                }
                arriving = self.cut_ear([a, b, corner], before, arriving);
                self.chain.pop();
            }
            self.chain.push((corner, arriving));
        }
        debug_assert_eq!(self.chain.len(), 2, "a face is no mountain: {face:?}");
        if let Some(&(_, ChainEdge::Cut(last))) = self.chain.last() {
            self.owners[base as usize] = last;
        }
    }

    /// Adds a triangle with two edges of the chain; its third edge takes their place.
    #[expect(clippy::cast_possible_truncation, reason = "a region has fewer than 2^31 points")]
    fn cut_ear(&mut self, corners: [u32; 3], first: ChainEdge, second: ChainEdge) -> ChainEdge {
        let triangle = self.triangles.corners.len() as u32;
        self.triangles.corners.push(corners);
        self.triangles.across.push([NONE; 3]);
        for (edge, neighbor) in [(0, first), (1, second)] {
            let own = TriangleEdge { triangle, edge };
            match neighbor {
                ChainEdge::Half(half) => self.owners[half as usize] = own,
                ChainEdge::Cut(other) => self.triangles.link(own, other),
            }
        }
        ChainEdge::Cut(TriangleEdge { triangle, edge: 2 })
    }
}

impl Triangles {
    fn link(&mut self, a: TriangleEdge, b: TriangleEdge) {
        if a.triangle != NONE && b.triangle != NONE {
            self.across[a.triangle as usize][usize::from(a.edge)] = b.triangle;
            self.across[b.triangle as usize][usize::from(b.edge)] = a.triangle;
        }
    }
}

/// Index of the corner at which the base edge ends and the chain begins.
fn base_end(face: &[u32]) -> Option<usize> {
    let (low, high) = (*face.iter().min()?, *face.iter().max()?);
    (0..face.len()).find(|&end| {
        let (a, b) = (face[(end + face.len() - 1) % face.len()], face[end]);
        (a == low && b == high) || (a == high && b == low)
    })
}
