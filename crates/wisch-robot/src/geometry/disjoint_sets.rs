//! Connected components under pairwise unions.

/// Disjoint sets of the numbers from 0, each initially alone (Tarjan, *Efficiency of a Good But Not Linear Set Union
/// Algorithm*, 1975: union by rank, path halving).
#[derive(Debug, Clone)]
pub struct DisjointSets {
    parents: Vec<usize>,
    ranks: Vec<u8>,
}

impl DisjointSets {
    /// Returns `count` sets of one number each.
    pub fn new(count: usize) -> Self {
        Self {
            parents: (0..count).collect(),
            ranks: vec![0; count],
        }
    }

    /// Returns the representative of a number's set.
    pub fn find(&self, mut number: usize) -> usize {
        while self.parents[number] != number {
            number = self.parents[number];
        }
        number
    }

    /// Merges the sets of two numbers; returns whether they were different.
    pub fn union(&mut self, a: usize, b: usize) -> bool {
        let [a, b] = [a, b].map(|number| self.find_halving(number));
        if a == b {
            return false;
        }
        if self.ranks[a] < self.ranks[b] {
            self.parents[a] = b;
        } else {
            self.parents[b] = a;
            self.ranks[a] += u8::from(self.ranks[a] == self.ranks[b]);
        }
        true
    }

    fn find_halving(&mut self, mut number: usize) -> usize {
        while self.parents[number] != number {
            self.parents[number] = self.parents[self.parents[number]];
            number = self.parents[number];
        }
        number
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn numbers_hang_together_as_labels_that_are_overwritten_say(
            pairs in prop::collection::vec((0usize..40, 0usize..40), 0..80),
        ) {
            let mut sets = DisjointSets::new(40);
            let mut labels: Vec<usize> = (0..40).collect();
            for (a, b) in pairs {
                let [from, to] = [labels[a], labels[b]];
                prop_assert_eq!(sets.union(a, b), from != to);
                labels.iter_mut().filter(|label| **label == from).for_each(|label| *label = to);
            }
            for a in 0..40 {
                for b in 0..40 {
                    prop_assert_eq!(sets.find(a) == sets.find(b), labels[a] == labels[b]);
                }
            }
        }
    }
}
