//! [`Corners`]: the corners that a sweep finds, and the rings that they form.

use crate::{contours::Contours, engine::MOST_RESULT_POINTS, error::BooleanError, point::GridPoint};

/// No corner.
pub(super) const NONE: u32 = u32::MAX;

/// Corners from left to right, and upward in each column.
#[derive(Debug, Default)]
pub(super) struct Corners {
    points: Vec<GridPoint>,
    /// The corner after each, along its ring.
    next: Vec<u32>,
    /// Corners that may be the first of a hole, ascending, and a corner of the boundary right below.
    holes: Vec<(u32, u32)>,
}

impl Corners {
    #[expect(clippy::cast_possible_truncation, reason = "the number of corners is checked after each few columns")]
    pub(super) fn push(&mut self, at: GridPoint) -> u32 {
        self.points.push(at);
        self.next.push(NONE);
        self.points.len() as u32 - 1
    }

    /// Links two corners: the second one follows the first.
    pub(super) fn link(&mut self, corner: u32, next: u32) {
        self.next[corner as usize] = next;
    }

    /// Notes a corner that may be the first of a hole.
    pub(super) fn begin_hole(&mut self, corner: u32, below: u32) {
        self.holes.push((corner, below));
    }

    /// The number of corners.
    ///
    /// # Errors
    /// [`BooleanError::TooLarge`] if there are more corners than a result may have.
    pub(super) fn check_size(&self) -> Result<usize, BooleanError> {
        match self.points.len() {
            edges if edges > MOST_RESULT_POINTS => Err(BooleanError::TooLarge { edges, limit: MOST_RESULT_POINTS }),
            corners => Ok(corners),
        }
    }

    /// All rings, each outer one followed by its holes, and the indices of the outer rings.
    pub(super) fn into_rings(self) -> (Contours, Vec<usize>) {
        let rings = self.trace();
        let mut holes: Vec<(u32, u32)> = (0u32..)
            .zip(&rings.owners)
            .filter(|&(ring, &owner)| owner != ring)
            .map(|(ring, &owner)| (owner, ring))
            .collect();
        holes.sort_unstable();
        let mut contours = Contours::with_capacity(rings.owners.len(), self.points.len());
        let mut polygons = Vec::with_capacity(rings.owners.len() - holes.len());
        let mut next_hole = 0;
        for (ring, _) in (0u32..).zip(&rings.owners).filter(|&(ring, &owner)| owner == ring) {
            polygons.push(contours.len());
            contours.push(self.ring(rings.firsts[ring as usize]));
            while let Some(&(_, hole)) = holes.get(next_hole).filter(|&&(owner, _)| owner == ring) {
                contours.push(self.ring(rings.firsts[hole as usize]));
                next_hole += 1;
            }
        }
        (contours, polygons)
    }

    fn ring(&self, first: u32) -> impl Iterator<Item = GridPoint> {
        let mut corner = Some(first);
        std::iter::from_fn(move || {
            let own = corner?;
            let next = self.next[own as usize];
            corner = (next != first).then_some(next);
            Some(self.points[own as usize])
        })
    }

    /// Finds the rings in the order of their leftmost corners, which are their first ones.
    #[expect(clippy::cast_possible_truncation, reason = "there are fewer rings than corners")]
    fn trace(&self) -> Rings {
        let mut ring_of = vec![NONE; self.points.len()];
        let mut rings = Rings { firsts: Vec::new(), owners: Vec::new() };
        let mut holes = self.holes.iter().peekable();
        for first in 0..self.points.len() as u32 {
            let hole = holes.next_if(|&&(corner, _)| corner == first);
            if ring_of[first as usize] != NONE {
                continue;
            }
            let ring = rings.firsts.len() as u32;
            let mut corner = first;
            while ring_of[corner as usize] == NONE {
                ring_of[corner as usize] = ring;
                corner = self.next[corner as usize];
            }
            rings.firsts.push(first);
            // The ring below began further left, so its owner is known.
            let owner = hole.map_or(ring, |&(_, below)| rings.owners[ring_of[below as usize] as usize]);
            rings.owners.push(owner);
        }
        rings
    }
}

struct Rings {
    /// The first corner of each ring; ascending.
    firsts: Vec<u32>,
    /// The outer ring of each ring: itself unless it is a hole.
    owners: Vec<u32>,
}
