//! Cache of decoded chunks of columns, within a budget.

use std::collections::HashMap;
use std::sync::Arc;

/// Row group and column of a chunk.
pub(super) type Place = (usize, usize);

/// Decoded values of a column in a row group.
#[derive(Debug, Clone)]
pub(super) enum Piece {
    /// Times; a negative one is not stated.
    Times(Arc<[i64]>),
    Codes(Arc<[i32]>),
    Singles(Arc<[f32]>),
}

impl Piece {
    fn bytes(&self) -> usize {
        match self {
            Self::Times(values) => size_of_val::<[i64]>(values),
            Self::Codes(values) => size_of_val::<[i32]>(values),
            Self::Singles(values) => size_of_val::<[f32]>(values),
        }
    }
}

/// Chunks by row group and column; the least recently used ones are evicted first.
#[derive(Debug)]
pub(super) struct PieceCache {
    budget: usize,
    bytes: usize,
    clock: u64,
    pieces: HashMap<Place, (u64, Piece)>,
}

impl PieceCache {
    pub(super) fn new(budget: usize) -> Self {
        Self {
            budget,
            bytes: 0,
            clock: 0,
            pieces: HashMap::new(),
        }
    }

    pub(super) fn get(&mut self, place: Place) -> Option<Piece> {
        self.clock += 1;
        let (used, piece) = self.pieces.get_mut(&place)?;
        *used = self.clock;
        Some(piece.clone())
    }

    pub(super) fn put(&mut self, place: Place, piece: Piece) {
        self.clock += 1;
        self.bytes += piece.bytes();
        if let Some((_, old)) = self.pieces.insert(place, (self.clock, piece)) {
            self.bytes -= old.bytes();
        }
        if self.bytes > self.budget {
            self.shrink();
        }
    }

    /// Evicts down to half the budget at once, so that this happens seldom.
    fn shrink(&mut self) {
        let mut by_age: Vec<(u64, Place)> = self
            .pieces
            .iter()
            .map(|(&place, (used, _))| (*used, place))
            .collect();
        by_age.sort_unstable();
        for (_, place) in by_age {
            if self.bytes <= self.budget / 2 {
                break;
            }
            if let Some((_, piece)) = self.pieces.remove(&place) {
                self.bytes -= piece.bytes();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn least_recently_used_chunks_are_evicted_first() {
        let piece = || Piece::Singles(vec![0.0; 25].into());
        let mut cache = PieceCache::new(400);
        for group in 0..4 {
            cache.put((group, 0), piece());
        }
        assert!(cache.get((0, 0)).is_some());
        cache.put((4, 0), piece());
        assert!(cache.bytes <= 400, "{} bytes are kept", cache.bytes);
        assert!(cache.get((0, 0)).is_some() && cache.get((4, 0)).is_some());
        assert!(cache.get((1, 0)).is_none() && cache.get((2, 0)).is_none());
    }
}
