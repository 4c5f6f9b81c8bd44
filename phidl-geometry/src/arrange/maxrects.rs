//! Packing boxes into one bin: maximal free rectangles.
//!
//! The bin starts as one free rectangle. A box goes into the lower left corner of the free rectangle that a rule
//! prefers; every free rectangle that it touches is replaced by the up to four largest ones that remain of it. Free
//! rectangles overlap each other, but never a box, so boxes cannot overlap.
//!
//! Packing crates (rectangle-pack, crunch, guillotiere, etagere) were looked at: they pack texture atlases, in 32-bit
//! integers, with other placement rules, and none grows a bin at a given aspect ratio. The hundred lines below keep the
//! rule of the reference among several.

/// A box or a free rectangle, in steps of the packing grid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PackedRect {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) width: f64,
    pub(super) height: f64,
}

impl PackedRect {
    fn right(&self) -> f64 {
        self.x + self.width
    }

    fn top(&self) -> f64 {
        self.y + self.height
    }

    fn overlaps(&self, other: &Self) -> bool {
        self.x < other.right() && other.x < self.right() && self.y < other.top() && other.y < self.top()
    }

    fn contains(&self, other: &Self) -> bool {
        self.x <= other.x && other.right() <= self.right() && self.y <= other.y && other.top() <= self.top()
    }
}

/// Which free rectangle a box goes to: the one where this is least, the first on ties.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Rule {
    /// What is left along the longer remaining side: the rule of the reference.
    LongSide,
    /// What is left along the shorter remaining side.
    ShortSide,
    /// The area that is left.
    Area,
    /// The upper edge of the box, then its left one.
    BottomLeft,
}

impl Rule {
    pub(super) const ALL: [Self; 4] = [Self::LongSide, Self::ShortSide, Self::Area, Self::BottomLeft];

    /// How badly a box of this size fits; pairs compare by their first number, then by their second.
    fn cost(self, free: &PackedRect, (width, height): (f64, f64)) -> (f64, f64) {
        let (x, y) = (free.width - width, free.height - height);
        match self {
            Self::LongSide => (x.max(y), 0.0),
            Self::ShortSide => (x.min(y), x.max(y)),
            Self::Area => (free.width * free.height - width * height, x.min(y)),
            Self::BottomLeft => (free.y + height, free.x),
        }
    }
}

/// Places boxes of these sizes, in this order, into a bin; one that does not fit any more is left out (`None`).
pub(super) fn pack(bin: (f64, f64), sizes: &[(f64, f64)], rule: Rule) -> Vec<Option<PackedRect>> {
    let mut free = vec![PackedRect { x: 0.0, y: 0.0, width: bin.0, height: bin.1 }];
    sizes.iter().map(|size| place(&mut free, *size, rule)).collect()
}

fn place(free: &mut Vec<PackedRect>, size: (f64, f64), rule: Rule) -> Option<PackedRect> {
    let (width, height) = size;
    let mut best: Option<((f64, f64), PackedRect)> = None;
    for room in free.iter().filter(|room| room.width >= width && room.height >= height) {
        let cost = rule.cost(room, size);
        if best.is_none_or(|(least, _)| cost < least) {
            best = Some((cost, *room));
        }
    }
    let (_, corner) = best?;
    let placed = PackedRect { width, height, ..corner };
    *free = rest_of(free, &placed);
    Some(placed)
}

/// The free rectangles beside a box, without those that lie in another one.
fn rest_of(free: &[PackedRect], placed: &PackedRect) -> Vec<PackedRect> {
    let mut rest: Vec<PackedRect> = Vec::with_capacity(free.len() + 4);
    let mut cut: Vec<bool> = Vec::with_capacity(free.len() + 4);
    for room in free {
        if room.overlaps(placed) {
            rest.extend(beside(room, placed));
            cut.resize(rest.len(), true);
        } else {
            rest.push(*room);
            cut.push(false);
        }
    }
    // Whole ones were maximal before and still are; of two equal rectangles the first one stays.
    let lies_in = |i: usize, j: usize| i != j && rest[j].contains(&rest[i]) && (rest[i] != rest[j] || j < i);
    let keep: Vec<bool> = (0..rest.len()).map(|i| !cut[i] || !(0..rest.len()).any(|j| lies_in(i, j))).collect();
    let mut keep = keep.into_iter();
    rest.retain(|_| keep.next().unwrap_or(true));
    rest
}

/// The maximal remainders of a free rectangle on the four sides of a box.
fn beside(room: &PackedRect, placed: &PackedRect) -> impl Iterator<Item = PackedRect> {
    let remainders = [
        PackedRect { width: placed.x - room.x, ..*room },
        PackedRect { x: placed.right(), width: room.right() - placed.right(), ..*room },
        PackedRect { y: placed.top(), height: room.top() - placed.top(), ..*room },
        PackedRect { height: placed.y - room.y, ..*room },
    ];
    remainders.into_iter().filter(|rest| rest.width > 0.0 && rest.height > 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_quarters_fill_a_square_whatever_the_rule() {
        for rule in Rule::ALL {
            let placed = pack((20.0, 20.0), &[(10.0, 10.0); 5], rule);
            assert_eq!(placed.iter().flatten().count(), 4, "{rule:?}");
            assert_eq!(placed[4], None);
        }
    }

    #[test]
    fn free_room_is_what_no_box_covers() {
        let bin = PackedRect { x: 0.0, y: 0.0, width: 10.0, height: 10.0 };
        let placed = PackedRect { x: 4.0, y: 4.0, width: 2.0, height: 2.0 };
        let rest = rest_of(&[bin], &placed);
        assert_eq!(rest.len(), 4);
        assert!(rest.iter().all(|room| !room.overlaps(&placed) && room.width * room.height == 40.0));
    }

    #[test]
    fn of_two_equal_free_rooms_one_stays() {
        let a = PackedRect { x: 0.0, y: 0.0, width: 10.0, height: 6.0 };
        let b = PackedRect { x: 0.0, y: 2.0, width: 10.0, height: 4.0 };
        let placed = PackedRect { x: 0.0, y: 0.0, width: 10.0, height: 3.0 };
        assert_eq!(rest_of(&[a, b], &placed), [PackedRect { x: 0.0, y: 3.0, width: 10.0, height: 3.0 }]);
    }
}
