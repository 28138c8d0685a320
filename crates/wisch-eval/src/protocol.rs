//! Which seeds serve what.

/// First and last seed of each use.
const DEMONSTRATION: [u64; 2] = [1, 999];
const CHOICE: [u64; 2] = [1_000, 4_999];
const PUBLICATION: u64 = 10_000;

/// What seeds are for. A figure that is published comes from seeds on which nothing was chosen.
///
/// ```
/// use wisch_eval::SeedUse;
/// assert_eq!(SeedUse::of(1_000, 500), Ok(SeedUse::Choice));
/// assert!(SeedUse::of(4_900, 200).is_err());
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SeedUse {
    /// 1 to 999: tests and demonstrations.
    Demonstration,
    /// 1,000 to 4,999: choosing constants.
    Choice,
    /// From 10,000 on: published figures, each block once.
    Publication,
}

/// Seeds that serve no use, or several.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ProtocolError {
    /// A block that reaches beyond its use.
    #[error(
        "seeds {first} to {last} serve no single use: 1 to 999 are for tests and demonstrations, 1000 to 4999 for choosing constants, those from 10000 on for published figures"
    )]
    Mixed {
        /// The first seed.
        first: u64,
        /// The last one.
        last: u64,
    },
    /// No world at all.
    #[error("an evaluation needs at least 1 world, not 0")]
    Nothing,
}

impl SeedUse {
    /// What a block of seeds is for.
    ///
    /// # Errors
    /// A block that reaches beyond one use, or an empty one.
    pub fn of(first: u64, count: u64) -> Result<Self, ProtocolError> {
        let Some(more) = count.checked_sub(1) else {
            return Err(ProtocolError::Nothing);
        };
        let last = first.saturating_add(more);
        let within = |[least, most]: [u64; 2]| first >= least && last <= most;
        if within(DEMONSTRATION) {
            Ok(Self::Demonstration)
        } else if within(CHOICE) {
            Ok(Self::Choice)
        } else if within([PUBLICATION, u64::MAX]) {
            Ok(Self::Publication)
        } else {
            Err(ProtocolError::Mixed { first, last })
        }
    }

    /// The use in words.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Demonstration => "demonstration",
            Self::Choice => "choice of constants",
            Self::Publication => "publication",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_block_has_one_use() {
        assert_eq!(SeedUse::of(1, 999), Ok(SeedUse::Demonstration));
        assert_eq!(SeedUse::of(4_999, 1), Ok(SeedUse::Choice));
        assert_eq!(SeedUse::of(10_000, 1_000), Ok(SeedUse::Publication));
        assert_eq!(SeedUse::of(1_000, 0), Err(ProtocolError::Nothing));
        for (first, count) in [(0, 1), (999, 2), (4_999, 2), (9_999, 2), (5_000, 10)] {
            let refused = SeedUse::of(first, count);
            assert!(
                matches!(refused, Err(ProtocolError::Mixed { .. })),
                "{first}"
            );
        }
    }
}
