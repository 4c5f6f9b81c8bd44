//! The status structure of a sweep: the segments over the event point, from bottom to top.
//!
//! It is an unrolled linked list of short blocks, and each segment knows its block. A segment ends at nine of ten event
//! points, and its block gives the slot without a search. Rejected: one sorted list, whose search took a fifth of an
//! operation, since each step of it waits for another segment from memory.

use std::ops::Range;

/// Segments per block at most: 256 bytes, a few cache lines.
const BLOCK: usize = 64;

const NONE: u32 = u32::MAX;

/// A gap between two neighbors in the status structure: before the segment at `index` of a block.
#[derive(Debug, Clone, Copy)]
pub(super) struct Slot {
    block: u32,
    index: usize,
}

#[derive(Debug)]
struct Block {
    segments: Vec<u32>,
    below: u32,
    above: u32,
}

#[derive(Debug)]
pub(super) struct Status {
    blocks: Vec<Block>,
    /// Blocks from bottom to top. None is empty, unless it is the only one.
    order: Vec<u32>,
    unused: Vec<u32>,
    /// Block of each segment in the structure.
    block_of: Vec<u32>,
}

impl Status {
    /// An empty structure for segments with numbers below `segments`.
    pub(super) fn new(segments: usize) -> Self {
        let first = Block { segments: Vec::with_capacity(BLOCK + 1), below: NONE, above: NONE };
        Self { blocks: vec![first], order: vec![0], unused: Vec::new(), block_of: vec![NONE; segments] }
    }

    /// The slot above all segments.
    pub(super) fn top(&self) -> Slot {
        let block = self.order[self.order.len() - 1];
        Slot { block, index: self.blocks[block as usize].segments.len() }
    }

    /// The slot right below a segment.
    pub(super) fn slot_of(&self, segment: u32) -> Slot {
        let block = self.block_of[segment as usize];
        let index = self.blocks[block as usize].segments.iter().position(|&other| other == segment);
        Slot { block, index: index.expect("invariant: a segment is in its block") }
    }

    /// The slot above all segments for which `is_below` holds.
    pub(super) fn search(&self, is_below: impl Fn(u32) -> bool) -> Slot {
        let segments = |block: u32| &self.blocks[block as usize].segments;
        let above =
            self.order.partition_point(|&block| segments(block).first().is_some_and(|&segment| is_below(segment)));
        let block = self.order[above.saturating_sub(1)];
        Slot { block, index: segments(block).partition_point(|&segment| is_below(segment)) }
    }

    /// The segment right below a slot.
    pub(super) fn below(&self, slot: Slot) -> Option<u32> {
        match slot.index.checked_sub(1) {
            Some(index) => Some(self.blocks[slot.block as usize].segments[index]),
            None => {
                let below = self.blocks[slot.block as usize].below;
                (below != NONE).then(|| self.blocks[below as usize].segments.last().copied()).flatten()
            }
        }
    }

    /// The segments below a slot, from top to bottom.
    pub(super) fn all_below(&self, mut slot: Slot) -> impl Iterator<Item = u32> {
        std::iter::from_fn(move || {
            let segment = self.below(slot)?;
            slot = self.step_down(slot);
            Some(segment)
        })
    }

    /// The slot below the segment right below a slot.
    pub(super) fn step_down(&self, slot: Slot) -> Slot {
        match slot.index.checked_sub(1) {
            Some(index) => Slot { index, ..slot },
            None => {
                let block = self.blocks[slot.block as usize].below;
                Slot { block, index: self.blocks[block as usize].segments.len() - 1 }
            }
        }
    }

    /// Removes segments upward from a slot while `ends` holds; it is called once for each segment up to the first that
    /// stays. Returns the slot of the removed segments.
    pub(super) fn remove_while(&mut self, mut slot: Slot, mut ends: impl FnMut(u32) -> bool) -> Slot {
        loop {
            let block = &mut self.blocks[slot.block as usize];
            let count = block.segments[slot.index..].iter().take_while(|&&segment| ends(segment)).count();
            let reaches_end = slot.index + count == block.segments.len();
            block.segments.drain(slot.index..slot.index + count);
            let (above, is_empty) = (block.above, block.segments.is_empty());
            if !reaches_end || above == NONE {
                return if is_empty { self.drop_block(slot) } else { slot };
            }
            if is_empty {
                self.drop_block(slot);
            }
            slot = Slot { block: above, index: 0 };
        }
    }

    /// Inserts segments, from bottom to top, at a slot.
    pub(super) fn insert(&mut self, slot: Slot, segments: Range<u32>) {
        for segment in segments.clone() {
            self.block_of[segment as usize] = slot.block;
        }
        let block = &mut self.blocks[slot.block as usize].segments;
        block.splice(slot.index..slot.index, segments);
        if block.len() > BLOCK {
            self.split(slot.block);
        }
    }

    /// Moves the excess of a block into new blocks above it.
    #[expect(clippy::cast_possible_truncation, reason = "there are fewer blocks than segments")]
    fn split(&mut self, block: u32) {
        let mut position = self.position(block);
        let mut rest = self.blocks[block as usize].segments.split_off(BLOCK / 2);
        let mut below = block;
        while !rest.is_empty() {
            let tail = rest.split_off(rest.len().min(BLOCK / 2));
            let above = self.blocks[below as usize].above;
            let fresh = self.unused.pop().unwrap_or(self.blocks.len() as u32);
            for &segment in &rest {
                self.block_of[segment as usize] = fresh;
            }
            let content = Block { segments: rest, below, above };
            match self.blocks.get_mut(fresh as usize) {
                Some(slot) => *slot = content,
                None => self.blocks.push(content),
            }
            self.blocks[below as usize].above = fresh;
            if above != NONE {
                self.blocks[above as usize].below = fresh;
            }
            position += 1;
            self.order.insert(position, fresh);
            (below, rest) = (fresh, tail);
        }
    }

    /// Removes an empty block unless it is the only one; returns the same slot in a neighbor.
    fn drop_block(&mut self, slot: Slot) -> Slot {
        if self.order.len() == 1 {
            return slot;
        }
        let Block { below, above, .. } = self.blocks[slot.block as usize];
        if below != NONE {
            self.blocks[below as usize].above = above;
        }
        if above != NONE {
            self.blocks[above as usize].below = below;
        }
        let position = self.position(slot.block);
        self.order.remove(position);
        self.unused.push(slot.block);
        if below == NONE {
            Slot { block: above, index: 0 }
        } else {
            Slot { block: below, index: self.blocks[below as usize].segments.len() }
        }
    }

    fn position(&self, block: u32) -> usize {
        self.order.iter().position(|&other| other == block).expect("invariant: blocks in use are in order")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Segments are numbers in ascending order; the model is a sorted list.
    #[test]
    fn blocks_behave_like_one_sorted_list() {
        let (mut status, mut model) = (Status::new(4000), Vec::<u32>::new());
        for round in 0..4000u32 {
            let segment = round * 1237 % 4000;
            let slot = status.search(|other| other < segment);
            let index = model.partition_point(|&other| other < segment);
            assert_eq!(status.below(slot), index.checked_sub(1).map(|below| model[below]));
            status.insert(slot, segment..segment + 1);
            model.insert(index, segment);
            if round % 5 == 4 {
                let (first, last) = (model[model.len() / 3], model[model.len() / 3 + round as usize % 4]);
                let mut asked = Vec::new();
                let left = status.remove_while(status.slot_of(first), |other| {
                    asked.push(other);
                    other <= last
                });
                assert!(asked.is_sorted() && asked.windows(2).all(|pair| pair[0] != pair[1]), "{asked:?}");
                model.retain(|&other| other < first || other > last);
                assert_eq!(status.below(left), model.iter().copied().filter(|&other| other < first).max());
            }
        }
        let all: Vec<u32> = status.all_below(status.top()).collect();
        model.reverse();
        assert_eq!(all, model);
        status.remove_while(status.search(|_| false), |_| true);
        assert_eq!(status.below(status.top()), None);
    }

    #[test]
    fn many_segments_may_begin_in_one_slot() {
        let mut status = Status::new(1000);
        status.insert(status.top(), 0..1);
        status.insert(status.top(), 900..1000);
        status.insert(status.search(|segment| segment < 500), 1..900);
        assert_eq!(status.all_below(status.top()).collect::<Vec<_>>(), (0..1000).rev().collect::<Vec<_>>());
    }
}
