//! The status structure: heights at which the winding numbers change, from bottom to top, in short blocks.

use super::rings::NONE;

/// Heights per block at most, after which it is split in two.
const BLOCK: usize = 128;

/// A height at which the winding numbers change.
#[derive(Debug, Clone, Copy)]
pub(super) struct Height {
    pub(super) y: i64,
    /// The winding numbers above.
    pub(super) above: [i32; 2],
    /// The corner at the left end of the boundary at this height; [`NONE`] if it is no boundary.
    pub(super) corner: u32,
}

/// A gap between two heights: before the height at `index` of a block. A slot at the end of a block is not used unless it is
/// the last block.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Slot {
    block: usize,
    index: usize,
}

#[derive(Debug)]
pub(super) struct Status {
    /// None is empty, unless it is the only one.
    blocks: Vec<Vec<Height>>,
}

impl Default for Status {
    fn default() -> Self {
        Self { blocks: vec![Vec::new()] }
    }
}

impl Status {
    /// The slot below all heights from `y` on.
    pub(super) fn search(&self, y: i64) -> Slot {
        let block = self.blocks.partition_point(|block| block.last().is_some_and(|height| height.y < y));
        let block = block.min(self.blocks.len() - 1);
        Slot { block, index: self.blocks[block].partition_point(|height| height.y < y) }
    }

    /// The height right above a slot.
    #[inline]
    pub(super) fn get(&self, slot: Slot) -> Option<&Height> {
        self.blocks[slot.block].get(slot.index)
    }

    /// The slot above the height right above a slot.
    #[inline]
    pub(super) fn step_up(&self, slot: Slot) -> Slot {
        let Slot { block, index } = slot;
        if index + 1 == self.blocks[block].len() && block + 1 < self.blocks.len() {
            Slot { block: block + 1, index: 0 }
        } else {
            Slot { block, index: index + 1 }
        }
    }

    /// The heights below a slot, from top to bottom.
    fn below(&self, slot: Slot) -> impl Iterator<Item = &Height> {
        let own = self.blocks[slot.block][..slot.index].iter().rev();
        own.chain(self.blocks[..slot.block].iter().rev().flat_map(|block| block.iter().rev()))
    }

    /// The winding numbers right below a slot.
    pub(super) fn winding_below(&self, slot: Slot) -> [i32; 2] {
        self.below(slot).next().map_or([0, 0], |height| height.above)
    }

    /// A corner of the first boundary below a slot.
    pub(super) fn boundary_below(&self, slot: Slot) -> u32 {
        self.below(slot).find(|height| height.corner != NONE).map_or(NONE, |height| height.corner)
    }

    /// Replaces the heights between two slots.
    pub(super) fn replace(&mut self, from: Slot, to: Slot, heights: &[Height]) {
        if from.block == to.block {
            let block = &mut self.blocks[from.block];
            if to.index - from.index == heights.len() {
                block[from.index..to.index].copy_from_slice(heights);
            } else {
                block.splice(from.index..to.index, heights.iter().copied());
            }
        } else {
            self.blocks[to.block].drain(..to.index);
            let first = &mut self.blocks[from.block];
            first.truncate(from.index);
            first.extend_from_slice(heights);
            self.blocks.drain(from.block + 1..to.block);
            if self.blocks[from.block + 1].is_empty() {
                self.blocks.remove(from.block + 1);
            }
        }
        if self.blocks[from.block].len() > BLOCK {
            self.split(from.block);
        } else if self.blocks[from.block].is_empty() && self.blocks.len() > 1 {
            self.blocks.remove(from.block);
        }
    }

    fn split(&mut self, block: usize) {
        let all = std::mem::take(&mut self.blocks[block]);
        self.blocks.splice(block..=block, all.chunks(BLOCK / 2).map(<[_]>::to_vec));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The model is a sorted list.
    #[test]
    fn blocks_behave_like_one_sorted_list() {
        let (mut status, mut model) = (Status::default(), Vec::<i64>::new());
        for round in 0..3000i64 {
            let (low, count) = (round * 7919 % 5000, round * 31 % 40);
            let high = low + round * 17 % 300;
            let (from, to) = (status.search(low), status.search(high));
            let fresh: Vec<i64> = (0..count.min(high - low)).map(|i| low + i).collect();
            let heights: Vec<Height> = fresh.iter().map(|&y| Height { y, above: [1, 0], corner: NONE }).collect();
            status.replace(from, to, &heights);
            let range = model.partition_point(|&y| y < low)..model.partition_point(|&y| y < high);
            model.splice(range, fresh);
            let mut slot = status.search(i64::MIN);
            let mut found = Vec::new();
            while let Some(height) = status.get(slot) {
                found.push(height.y);
                slot = status.step_up(slot);
            }
            assert_eq!(found, model, "round {round}");
        }
    }
}
