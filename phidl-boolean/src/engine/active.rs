//! The pieces over the present point of a sweep, from bottom to top.
//!
//! Kept in short blocks, and each piece knows its block. Nine of ten points of a sweep are where a piece ends, and that
//! piece says where we are; only the others need a search. (One long sorted list spends a fifth of an operation on
//! searching it, since each step of the search waits for another piece from memory.)

use std::ops::Range;

/// Pieces per block at most; 256 bytes, which are scanned in no time.
const BLOCK: usize = 64;

const NONE: u32 = u32::MAX;

/// A place between two active pieces: before the item at `index` of a block.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    block: u32,
    index: usize,
}

#[derive(Debug)]
struct Block {
    pieces: Vec<u32>,
    below: u32,
    above: u32,
}

#[derive(Debug)]
pub(super) struct Active {
    blocks: Vec<Block>,
    /// Blocks from bottom to top. None is empty, unless it is the only one.
    order: Vec<u32>,
    unused: Vec<u32>,
    /// Block of each piece that is active.
    block_of: Vec<u32>,
}

impl Active {
    /// No active pieces, out of `pieces` that can become active.
    pub(super) fn new(pieces: usize) -> Self {
        let first = Block { pieces: Vec::with_capacity(BLOCK + 1), below: NONE, above: NONE };
        Self { blocks: vec![first], order: vec![0], unused: Vec::new(), block_of: vec![NONE; pieces] }
    }

    /// The place above all active pieces.
    pub(super) fn top(&self) -> Place {
        let block = self.order[self.order.len() - 1];
        Place { block, index: self.blocks[block as usize].pieces.len() }
    }

    /// The place below an active piece.
    pub(super) fn place_of(&self, piece: u32) -> Place {
        let block = self.block_of[piece as usize];
        let index = self.blocks[block as usize].pieces.iter().position(|&other| other == piece);
        Place { block, index: index.expect("invariant: a piece is in its block") }
    }

    /// The place above all pieces for which `is_below` holds.
    pub(super) fn search(&self, is_below: impl Fn(u32) -> bool) -> Place {
        let pieces = |block: u32| &self.blocks[block as usize].pieces;
        let above = self.order.partition_point(|&block| pieces(block).first().is_some_and(|&piece| is_below(piece)));
        let block = self.order[above.saturating_sub(1)];
        Place { block, index: pieces(block).partition_point(|&piece| is_below(piece)) }
    }

    /// The piece right below a place.
    pub(super) fn below(&self, place: Place) -> Option<u32> {
        match place.index.checked_sub(1) {
            Some(index) => Some(self.blocks[place.block as usize].pieces[index]),
            None => {
                let below = self.blocks[place.block as usize].below;
                (below != NONE).then(|| self.blocks[below as usize].pieces.last().copied()).flatten()
            }
        }
    }

    /// The pieces below a place, from top to bottom.
    pub(super) fn all_below(&self, mut place: Place) -> impl Iterator<Item = u32> {
        std::iter::from_fn(move || {
            let piece = self.below(place)?;
            place = self.step_down(place);
            Some(piece)
        })
    }

    /// The place below the piece right below a place.
    pub(super) fn step_down(&self, place: Place) -> Place {
        match place.index.checked_sub(1) {
            Some(index) => Place { index, ..place },
            None => {
                let block = self.blocks[place.block as usize].below;
                Place { block, index: self.blocks[block as usize].pieces.len() - 1 }
            }
        }
    }

    /// Removes pieces upward from a place while `ends` holds, which is asked once for each piece up to the first that
    /// stays. Returns the place that is left.
    pub(super) fn remove_while(&mut self, mut place: Place, mut ends: impl FnMut(u32) -> bool) -> Place {
        loop {
            let block = &mut self.blocks[place.block as usize];
            let count = block.pieces[place.index..].iter().take_while(|&&piece| ends(piece)).count();
            let reaches_end = place.index + count == block.pieces.len();
            block.pieces.drain(place.index..place.index + count);
            let (above, is_empty) = (block.above, block.pieces.is_empty());
            if !reaches_end || above == NONE {
                return if is_empty { self.drop_block(place) } else { place };
            }
            if is_empty {
                self.drop_block(place);
            }
            place = Place { block: above, index: 0 };
        }
    }

    /// Inserts pieces, from bottom to top, at a place.
    pub(super) fn insert(&mut self, place: Place, pieces: Range<u32>) {
        for piece in pieces.clone() {
            self.block_of[piece as usize] = place.block;
        }
        let block = &mut self.blocks[place.block as usize].pieces;
        block.splice(place.index..place.index, pieces);
        if block.len() > BLOCK {
            self.split(place.block);
        }
    }

    /// Moves what a block has too much into new blocks above it.
    #[expect(clippy::cast_possible_truncation, reason = "there are fewer blocks than pieces")]
    fn split(&mut self, block: u32) {
        let mut position = self.position(block);
        let mut rest = self.blocks[block as usize].pieces.split_off(BLOCK / 2);
        let mut below = block;
        while !rest.is_empty() {
            let tail = rest.split_off(rest.len().min(BLOCK / 2));
            let above = self.blocks[below as usize].above;
            let fresh = self.unused.pop().unwrap_or(self.blocks.len() as u32);
            for &piece in &rest {
                self.block_of[piece as usize] = fresh;
            }
            let content = Block { pieces: rest, below, above };
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

    /// Takes an empty block away, unless it is the only one; returns the same place in a neighbor.
    fn drop_block(&mut self, place: Place) -> Place {
        if self.order.len() == 1 {
            return place;
        }
        let Block { below, above, .. } = self.blocks[place.block as usize];
        if below != NONE {
            self.blocks[below as usize].above = above;
        }
        if above != NONE {
            self.blocks[above as usize].below = below;
        }
        let position = self.position(place.block);
        self.order.remove(position);
        self.unused.push(place.block);
        if below == NONE {
            Place { block: above, index: 0 }
        } else {
            Place { block: below, index: self.blocks[below as usize].pieces.len() }
        }
    }

    fn position(&self, block: u32) -> usize {
        self.order.iter().position(|&other| other == block).expect("invariant: blocks in use are in order")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pieces are numbers that are active in ascending order; the model is a sorted list.
    #[test]
    fn blocks_behave_like_one_sorted_list() {
        let (mut active, mut model) = (Active::new(4000), Vec::<u32>::new());
        for round in 0..4000u32 {
            let piece = round * 1237 % 4000;
            let place = active.search(|other| other < piece);
            let index = model.partition_point(|&other| other < piece);
            assert_eq!(active.below(place), index.checked_sub(1).map(|below| model[below]));
            active.insert(place, piece..piece + 1);
            model.insert(index, piece);
            if round % 5 == 4 {
                let (first, last) = (model[model.len() / 3], model[model.len() / 3 + round as usize % 4]);
                let mut asked = Vec::new();
                let left = active.remove_while(active.place_of(first), |other| {
                    asked.push(other);
                    other <= last
                });
                assert!(asked.is_sorted() && asked.windows(2).all(|pair| pair[0] != pair[1]), "{asked:?}");
                model.retain(|&other| other < first || other > last);
                assert_eq!(active.below(left), model.iter().copied().filter(|&other| other < first).max());
            }
        }
        let all: Vec<u32> = active.all_below(active.top()).collect();
        model.reverse();
        assert_eq!(all, model);
        active.remove_while(active.search(|_| false), |_| true);
        assert_eq!(active.below(active.top()), None);
    }

    #[test]
    fn many_pieces_may_begin_in_one_place() {
        let mut active = Active::new(1000);
        active.insert(active.top(), 0..1);
        active.insert(active.top(), 900..1000);
        active.insert(active.search(|piece| piece < 500), 1..900);
        assert_eq!(active.all_below(active.top()).collect::<Vec<_>>(), (0..1000).rev().collect::<Vec<_>>());
    }
}
