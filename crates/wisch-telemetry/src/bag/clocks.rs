//! Clocks of a bag: the stamps in messages, and the recorder's clock.

/// Difference of two clocks above which they are aligned [ns]: recording delays a message by less.
const LEAST_APART: i64 = 100_000_000;

/// Offset of a topic's stamps ahead of the recorder's clock.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Offset {
    /// Median over the topic's messages [ns].
    pub median: i64,
    /// Interquartile range [ns].
    spread: i64,
}

impl Offset {
    /// Offset of messages that were recorded without stamps.
    pub const NONE: Self = Self {
        median: 0,
        spread: 0,
    };

    /// Returns the offset of messages whose stamps were `ahead` of the recorder [ns]; `None` without messages.
    pub fn from_lags(mut ahead: Vec<i64>) -> Option<Self> {
        if ahead.is_empty() {
            return None;
        }
        ahead.sort_unstable();
        let at = |share: usize| ahead[(ahead.len() - 1) * share / 4];
        Some(Self {
            median: at(2),
            spread: at(3).saturating_sub(at(1)),
        })
    }

    /// Returns the shift [ns] that converts times of this clock to those of `other`. `None` if the
    /// clocks differ by less than recording takes, or by less than the variation of their
    /// difference.
    pub fn shift_onto(self, other: Self) -> Option<i64> {
        let shift = other.median.saturating_sub(self.median);
        let varies = self.spread.saturating_add(other.spread).saturating_mul(2);
        (shift.saturating_abs() > LEAST_APART.max(varies)).then_some(shift)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clocks_are_aligned_only_where_they_clearly_differ() {
        let offset =
            |ahead: [i64; 4]| Offset::from_lags(ahead.map(|ms| ms * 1_000_000).to_vec()).unwrap();
        let recorder = offset([-3, -2, -2, -1]);
        assert_eq!(
            offset([-60, -50, -52, -40]).shift_onto(recorder),
            None,
            "recorded late"
        );
        let shift = offset([3200, 3198, 3199, 3205]).shift_onto(recorder);
        assert_eq!(shift, Some(-3_201_000_000));
        // The recorder did not write its own times, so the difference grows with the stamps.
        assert_eq!(
            offset([0, 500, 1000, 1500]).shift_onto(offset([900, 901, 902, 903])),
            None
        );
        assert_eq!(Offset::from_lags(vec![]), None);
    }
}
