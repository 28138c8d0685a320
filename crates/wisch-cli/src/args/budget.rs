//! The limit of the search for strokes.

use std::str::FromStr;
use std::time::Duration;

/// Longest time limit of a search [s].
const MAX_SECONDS: f64 = 3600.0;
/// Units of time, longer names first, in seconds [s].
const UNITS: [(&str, f64); 3] = [("min", 60.0), ("ms", 1e-3), ("s", 1.0)];

/// Limit of the search for strokes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Budget {
    /// Number of plans to try. The resulting plan is the same on every machine.
    Evaluations(u64),
    /// Time to search. The resulting plan depends on the machine's speed.
    Time(Duration),
}

impl FromStr for Budget {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let text = text.trim();
        let Some((number, unit)) = UNITS
            .iter()
            .find_map(|(name, unit)| Some((text.strip_suffix(name)?, unit)))
        else {
            let evaluations = text.parse();
            return evaluations.map(Self::Evaluations).map_err(|_| {
                "write the number of plans to try, such as 60000, or a time with its unit, such as 2s, 500ms or 1min".to_owned()
            });
        };
        let seconds = number.trim().parse::<f64>().map(|number| number * unit);
        match seconds {
            Ok(seconds) if seconds > 0.0 && seconds <= MAX_SECONDS => {
                Ok(Self::Time(Duration::from_secs_f64(seconds)))
            }
            Ok(seconds) => Err(format!(
                "{seconds} s is outside the limits of a search: above 0 s and at most {MAX_SECONDS} s"
            )),
            Err(_) => Err(format!("{number:?} is not a number")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plans_and_times_are_distinguished() {
        assert_eq!("60000".parse(), Ok(Budget::Evaluations(60_000)));
        for (text, milliseconds) in [("2s", 2_000), ("500 ms", 500), ("1.5min", 90_000)] {
            let time = Duration::from_millis(milliseconds);
            assert_eq!(text.parse(), Ok(Budget::Time(time)), "{text}");
        }
    }

    #[test]
    fn text_without_a_budget_is_refused() {
        for text in [
            "", "2", "-2s", "0s", "NaNs", "infs", "2h", "s", "2 hours", "-1", "2h5min", "61min",
        ] {
            let is_plans = text == "2";
            assert_eq!(text.parse::<Budget>().is_ok(), is_plans, "{text}");
        }
    }
}
