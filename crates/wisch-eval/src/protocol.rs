//! Which seeds serve what.

/// First and last seed of each use.
const DEMONSTRATION: [u64; 2] = [1, 999];
const CHOICE: [u64; 2] = [1_000, 4_999];
const PUBLICATION: u64 = 10_000;

/// What this project uses seeds for. A figure that it publishes comes from seeds on which nothing was chosen.
///
/// ```
/// use wisch_eval::SeedUse;
/// assert_eq!(SeedUse::of(1_000, 500), SeedUse::Choice);
/// assert_eq!(SeedUse::of(4_900, 200), SeedUse::Mixed);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SeedUse {
    /// 1 to 999: tests and demonstrations.
    Demonstration,
    /// 1,000 to 4,999: choosing constants.
    Choice,
    /// From 10,000 on: published figures, each block once.
    Publication,
    /// Other seeds, or seeds of several uses.
    Mixed,
}

impl SeedUse {
    /// What `count` seeds from `first` on are for.
    pub fn of(first: u64, count: u64) -> Self {
        let last = first.saturating_add(count.saturating_sub(1));
        let within = |[least, most]: [u64; 2]| first >= least && last <= most;
        if within(DEMONSTRATION) {
            Self::Demonstration
        } else if within(CHOICE) {
            Self::Choice
        } else if within([PUBLICATION, u64::MAX]) {
            Self::Publication
        } else {
            Self::Mixed
        }
    }

    /// The use in words.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Demonstration => "demonstration",
            Self::Choice => "choice of constants",
            Self::Publication => "publication",
            Self::Mixed => "of no single use",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_block_has_one_use() {
        assert_eq!(SeedUse::of(1, 999), SeedUse::Demonstration);
        assert_eq!(SeedUse::of(4_999, 1), SeedUse::Choice);
        assert_eq!(SeedUse::of(10_000, 1_000), SeedUse::Publication);
        for (first, count) in [(0, 1), (999, 2), (4_999, 2), (9_999, 2), (5_000, 10)] {
            assert_eq!(SeedUse::of(first, count), SeedUse::Mixed, "{first}");
        }
    }
}
