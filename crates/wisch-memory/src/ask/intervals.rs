//! Index of intervals by Allen's relations.

use crate::catalogue::{Catalogue, IndividualId};

/// One of Allen's relations (1983), or a union of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    /// Ends before the other begins.
    Before,
    /// Begins after the other ends.
    After,
    /// Ends when the other begins.
    Meets,
    /// Begins when the other ends.
    MetBy,
    /// Begins before the other, and ends during it.
    Overlaps,
    /// Begins during the other, and ends after it.
    OverlappedBy,
    /// Begins with the other, and ends before it.
    Starts,
    /// Begins with the other, and ends after it.
    StartedBy,
    /// Ends with the other, and begins after it.
    Finishes,
    /// Ends with the other, and begins before it.
    FinishedBy,
    /// Lies within the other, with different ends.
    During,
    /// The other lies within it, with different ends.
    Contains,
    /// Has the same ends.
    Equals,
    /// Shares a time with the other.
    Intersects,
    /// Lies within the other, or equals it.
    DuringOrEqual,
    /// The other lies within it, or equals it.
    ContainsOrEquals,
}

impl Relation {
    /// Returns the relation with this name.
    pub fn from_name(name: &str) -> Option<Self> {
        Some(match name {
            "before" => Self::Before,
            "after" => Self::After,
            "meets" => Self::Meets,
            "met_by" => Self::MetBy,
            "overlaps" => Self::Overlaps,
            "overlapped_by" => Self::OverlappedBy,
            "starts" => Self::Starts,
            "started_by" => Self::StartedBy,
            "finishes" => Self::Finishes,
            "finished_by" => Self::FinishedBy,
            "during" => Self::During,
            "contains" => Self::Contains,
            "equals" => Self::Equals,
            "intersects" => Self::Intersects,
            "during_or_equal" => Self::DuringOrEqual,
            _ => return None,
        })
    }

    /// Returns the inverse: the relation of the second interval to the first.
    pub fn inverse(self) -> Self {
        match self {
            Self::Before => Self::After,
            Self::After => Self::Before,
            Self::Meets => Self::MetBy,
            Self::MetBy => Self::Meets,
            Self::Overlaps => Self::OverlappedBy,
            Self::OverlappedBy => Self::Overlaps,
            Self::Starts => Self::StartedBy,
            Self::StartedBy => Self::Starts,
            Self::Finishes => Self::FinishedBy,
            Self::FinishedBy => Self::Finishes,
            Self::During => Self::Contains,
            Self::Contains => Self::During,
            Self::Equals => Self::Equals,
            Self::Intersects => Self::Intersects,
            Self::DuringOrEqual => Self::ContainsOrEquals,
            Self::ContainsOrEquals => Self::DuringOrEqual,
        }
    }

    /// Whether the first interval has this relation to the second.
    #[allow(
        clippy::float_cmp,
        reason = "intervals meet where they have the very same time"
    )]
    pub fn holds(self, [s1, e1]: [f64; 2], [s2, e2]: [f64; 2]) -> bool {
        match self {
            Self::Before => e1 < s2,
            Self::After => s1 > e2,
            Self::Meets => e1 == s2,
            Self::MetBy => s1 == e2,
            Self::Overlaps => s1 < s2 && e1 > s2 && e1 < e2,
            Self::OverlappedBy => s2 < s1 && e2 > s1 && e2 < e1,
            Self::Starts => s1 == s2 && e1 < e2,
            Self::StartedBy => s1 == s2 && e1 > e2,
            Self::Finishes => e1 == e2 && s1 > s2,
            Self::FinishedBy => e1 == e2 && s1 < s2,
            Self::During => s1 > s2 && e1 < e2,
            Self::Contains => s1 < s2 && e1 > e2,
            Self::Equals => s1 == s2 && e1 == e2,
            Self::Intersects => s1 <= e2 && s2 <= e1,
            Self::DuringOrEqual => s1 >= s2 && e1 <= e2,
            Self::ContainsOrEquals => s1 <= s2 && e1 >= e2,
        }
    }
}

/// Intervals sorted by their start, with a tree of latest ends, so that intervals that touch a given time are found
/// without scanning the others.
#[derive(Debug, Clone, Default)]
pub struct IntervalIndex {
    entries: Vec<(f64, f64, IndividualId)>,
    /// Latest ends as a binary tree over the entries: node `n` has children `2n` and `2n + 1`.
    latest: Vec<f64>,
    leaves: usize,
}

impl IntervalIndex {
    /// Returns the index of all individuals with a time.
    pub fn from_catalogue(catalogue: &Catalogue) -> Self {
        let ids = 0..u32::try_from(catalogue.len()).unwrap_or(u32::MAX);
        let timed = ids.filter_map(|id| catalogue.interval(id).map(|[s, e]| (s, e, id)));
        Self::new(timed.collect())
    }

    fn new(mut entries: Vec<(f64, f64, IndividualId)>) -> Self {
        entries.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.2.cmp(&b.2)));
        let leaves = entries.len().next_power_of_two();
        let mut latest = vec![f64::NEG_INFINITY; 2 * leaves];
        for (place, entry) in entries.iter().enumerate() {
            latest[leaves + place] = entry.1;
        }
        for node in (1..leaves).rev() {
            latest[node] = latest[2 * node].max(latest[2 * node + 1]);
        }
        Self {
            entries,
            latest,
            leaves,
        }
    }

    /// Number of intervals in the index.
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Returns an interval by its index in the order of starts.
    pub fn entry(&self, place: usize) -> ([f64; 2], IndividualId) {
        let (start, end, id) = self.entries[place];
        ([start, end], id)
    }

    /// Returns the intervals with a relation to an interval, sorted by their start.
    pub fn find_related(&self, relation: Relation, to: [f64; 2]) -> Vec<IndividualId> {
        let fits = |entry: &&(f64, f64, IndividualId)| relation.holds([entry.0, entry.1], to);
        match relation {
            Relation::Before => {
                let begun = self.entries.partition_point(|entry| entry.0 < to[0]);
                let before = self.entries[..begun].iter().filter(fits);
                before.map(|entry| entry.2).collect()
            }
            Relation::After => {
                let from = self.entries.partition_point(|entry| entry.0 <= to[1]);
                self.entries[from..].iter().map(|entry| entry.2).collect()
            }
            _ => {
                let end = self.entries.partition_point(|entry| entry.0 <= to[1]);
                let mut found = Vec::new();
                self.touching(1, 0, self.leaves, end, to[0], &mut found);
                let touching = found.iter().map(|&place| &self.entries[place]);
                touching.filter(fits).map(|entry| entry.2).collect()
            }
        }
    }

    /// Returns indices below `end` of intervals that last until `start` or longer.
    fn touching(
        &self,
        node: usize,
        from: usize,
        len: usize,
        end: usize,
        start: f64,
        found: &mut Vec<usize>,
    ) {
        if from >= end || self.latest.get(node).is_none_or(|&latest| latest < start) {
            return;
        }
        if len == 1 {
            found.push(from);
            return;
        }
        let half = len / 2;
        self.touching(2 * node, from, half, end, start, found);
        self.touching(2 * node + 1, from + half, half, end, start, found);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const ALL: [Relation; 16] = [
        Relation::Before,
        Relation::After,
        Relation::Meets,
        Relation::MetBy,
        Relation::Overlaps,
        Relation::OverlappedBy,
        Relation::Starts,
        Relation::StartedBy,
        Relation::Finishes,
        Relation::FinishedBy,
        Relation::During,
        Relation::Contains,
        Relation::Equals,
        Relation::Intersects,
        Relation::DuringOrEqual,
        Relation::ContainsOrEquals,
    ];

    proptest! {
        #[test]
        fn the_index_agrees_with_a_linear_search(
            intervals in prop::collection::vec((0_u8..20, 0_u8..6), 0..40),
            to in (0_u8..20, 0_u8..6),
        ) {
            let interval = |(start, len): (u8, u8)| [f64::from(start), f64::from(start + len)];
            let entries: Vec<_> = (0..).zip(&intervals).map(|(id, &i)| {
                let [s, e] = interval(i);
                (s, e, id)
            }).collect();
            let index = IntervalIndex::new(entries.clone());
            let to = interval(to);
            for relation in ALL {
                let mut found = index.find_related(relation, to);
                found.sort_unstable();
                let all: Vec<_> = entries.iter().filter(|e| relation.holds([e.0, e.1], to)).map(|e| e.2).collect();
                prop_assert_eq!(found, all, "{:?}", relation);
            }
        }

        #[test]
        fn a_relation_holds_if_its_inverse_holds_for_swapped_intervals(
            a in (0_u8..9, 0_u8..6), b in (0_u8..9, 0_u8..6),
        ) {
            let [a, b] = [a, b].map(|(s, l)| [f64::from(s), f64::from(s + l)]);
            for relation in ALL {
                prop_assert_eq!(relation.holds(a, b), relation.inverse().holds(b, a), "{:?}", relation);
            }
        }

        #[test]
        fn proper_intervals_have_exactly_one_of_allens_relations(
            a in (0_u8..9, 1_u8..6), b in (0_u8..9, 1_u8..6),
        ) {
            let [a, b] = [a, b].map(|(s, l)| [f64::from(s), f64::from(s + l)]);
            let count = ALL[..13].iter().filter(|relation| relation.holds(a, b)).count();
            prop_assert_eq!(count, 1);
        }
    }
}
