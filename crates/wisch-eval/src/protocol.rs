//! The ranges of seeds and their uses.

/// First and last seed of each range.
const DEMONSTRATION: [u64; 2] = [1, 999];
const CHOICE: [u64; 2] = [1_000, 4_999];
const PUBLICATION: u64 = 10_000;

/// The use of a seed in this project. Published figures come from seeds that were not used to tune constants.
///
/// ```
/// use wisch_eval::SeedUse;
/// assert_eq!(SeedUse::classify(1_000, 500), SeedUse::Choice);
/// assert_eq!(SeedUse::classify(4_900, 200), SeedUse::Mixed);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SeedUse {
    /// 1 to 999: tests and demonstrations.
    Demonstration,
    /// 1,000 to 4,999: tuning of constants.
    Choice,
    /// 10,000 and above: published figures, each block of seeds once.
    Publication,
    /// Other seeds, or seeds of several uses.
    Mixed,
}

impl SeedUse {
    /// Returns the use of `count` seeds that start at `first`.
    pub fn classify(first: u64, count: u64) -> Self {
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

    /// Name of the use in tables and files.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Demonstration => "demonstration",
            Self::Choice => "choice of constants",
            Self::Publication => "publication",
            Self::Mixed => "mixed uses",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_block_has_one_use() {
        assert_eq!(SeedUse::classify(1, 999), SeedUse::Demonstration);
        assert_eq!(SeedUse::classify(4_999, 1), SeedUse::Choice);
        assert_eq!(SeedUse::classify(10_000, 1_000), SeedUse::Publication);
        for (first, count) in [(0, 1), (999, 2), (4_999, 2), (9_999, 2), (5_000, 10)] {
            assert_eq!(SeedUse::classify(first, count), SeedUse::Mixed, "{first}");
        }
    }
}
