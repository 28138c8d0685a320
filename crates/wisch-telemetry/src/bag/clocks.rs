//! Clocks of a bag: those of the stamps in messages, and that of the recorder.

/// Difference of two clocks from which on they are aligned [ns]: messages are recorded sooner after their stamp.
const LEAST_APART: i64 = 100_000_000;

/// By how much the stamps of a topic are ahead of the recorder's clock.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Offset {
    /// The median over its messages [ns].
    pub median: i64,
    /// Between which the middle half of them lies [ns].
    spread: i64,
}

impl Offset {
    /// Of what was recorded without stamps.
    pub const NONE: Self = Self {
        median: 0,
        spread: 0,
    };

    /// Of messages whose stamps were that much ahead when they were recorded [ns]; nothing without messages.
    pub fn of(mut ahead: Vec<i64>) -> Option<Self> {
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

    /// What is to be added to times by this clock to bring them onto another [ns], if the two differ by more than
    /// recording takes and by more than their difference varies.
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
        let offset = |ahead: [i64; 4]| Offset::of(ahead.map(|ms| ms * 1_000_000).to_vec()).unwrap();
        let recorder = offset([-3, -2, -2, -1]);
        assert_eq!(
            offset([-60, -50, -52, -40]).shift_onto(recorder),
            None,
            "recorded late"
        );
        let shift = offset([3200, 3198, 3199, 3205]).shift_onto(recorder);
        assert_eq!(shift, Some(-3_201_000_000));
        // The recorder wrote no times of its own: the difference grows with the stamps.
        assert_eq!(
            offset([0, 500, 1000, 1500]).shift_onto(offset([900, 901, 902, 903])),
            None
        );
        assert_eq!(Offset::of(vec![]), None);
    }
}
