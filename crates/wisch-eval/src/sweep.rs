//! Sweeps: a task with every combination of given values of its keys, over seeds.

use crate::quantity::{QuantitySummary, summarise_quantities};
use crate::wiping::{WipingExtent, WipingOptions, WipingScore};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::path::Path;
use std::str::FromStr;
use wisch_io::LoadOptions;

/// Maximum number of values of a range, and of combinations of a sweep.
const MAX_COUNT: usize = 100_000;

/// A key of a task with the values of a sweep.
///
/// ```
/// use wisch_eval::Axis;
/// let values = |text: &str| text.parse().map(|axis: Axis| axis.values);
/// assert_eq!(values("plan.strategy=grid,kde")?, ["grid", "kde"]);
/// assert_eq!(values("particles.count=50:200:50")?, ["50", "100", "150", "200"]);
/// assert_eq!(values("plan.bandwidth_m=0.02:0.03:0.005")?, ["0.020", "0.025", "0.030"]);
/// assert_eq!(values("collect.goal_m=[0.1, 0],[0, 0]")?, ["[0.1, 0]", "[0, 0]"]);
/// # Ok::<(), wisch_eval::AxisError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Axis {
    /// Dotted key, as in `--set`.
    pub key: String,
    /// Values, as in a task file.
    pub values: Vec<String>,
}

/// An error in the text of an axis.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum AxisError {
    /// The equals sign is missing.
    #[error(
        "\"=\" is missing; write a key of the task file, \"=\" and its values, such as particles.count=50,100 or 50:200:50"
    )]
    NoValues,
    /// The key is missing.
    #[error("the key before \"=\" is missing")]
    NoKey,
    /// A value is empty.
    #[error("{key}: value {number} is empty")]
    EmptyValue {
        /// The key.
        key: String,
        /// Number of the value, from 1.
        number: usize,
    },
    /// A value is given twice.
    #[error("{key}: {value} is given twice")]
    Twice {
        /// The key.
        key: String,
        /// The value.
        value: String,
    },
    /// A range without a valid step.
    #[error(
        "{key}: the range {range} does not lead from its beginning to its end in at most {MAX_COUNT} steps"
    )]
    Range {
        /// The key.
        key: String,
        /// The range as typed: beginning, end, step.
        range: String,
    },
}

impl FromStr for Axis {
    type Err = AxisError;

    fn from_str(text: &str) -> Result<Self, AxisError> {
        let (key, list) = text.split_once('=').ok_or(AxisError::NoValues)?;
        let key = key.trim().to_owned();
        if key.is_empty() {
            return Err(AxisError::NoKey);
        }
        let mut values = Vec::new();
        for (index, value) in split(list).into_iter().enumerate() {
            let value = value.trim();
            if value.is_empty() {
                let number = index + 1;
                return Err(AxisError::EmptyValue { key, number });
            }
            match parse_range(value) {
                None => values.push(value.to_owned()),
                Some(Some(range)) => values.extend(range),
                Some(None) => {
                    let range = value.to_owned();
                    return Err(AxisError::Range { key, range });
                }
            }
        }
        let twice = (1..values.len()).find(|&i| values[..i].contains(&values[i]));
        if let Some(twice) = twice {
            let value = values.swap_remove(twice);
            return Err(AxisError::Twice { key, value });
        }
        Ok(Self { key, values })
    }
}

/// Splits a list at commas outside of brackets and quotes.
fn split(list: &str) -> Vec<&str> {
    let (mut depth, mut quote, mut from) = (0_usize, None, 0);
    let mut parts = Vec::new();
    for (at, letter) in list.char_indices() {
        match (quote, letter) {
            (Some(open), _) => quote = (letter != open).then_some(open),
            (None, '"' | '\'') => quote = Some(letter),
            (None, '[' | '{') => depth += 1,
            (None, ']' | '}') => depth = depth.saturating_sub(1),
            (None, ',') if depth == 0 => {
                parts.push(&list[from..at]);
                from = at + 1;
            }
            _ => {}
        }
    }
    parts.push(&list[from..]);
    parts
}

/// Returns the values of a range beginning:end:step; `None` if the text is not a range, `Some(None)` if the range is invalid.
/// Values have as many decimals as beginning and step, so that no value is 0.30000000000000004.
fn parse_range(text: &str) -> Option<Option<Vec<String>>> {
    let parts: Vec<&str> = text.split(':').map(str::trim).collect();
    let [begin, end, step] = parts[..] else {
        return None;
    };
    let numbers: Option<Vec<f64>> = parts.iter().map(|part| part.parse().ok()).collect();
    let [first, last, by] = numbers?[..] else {
        return None;
    };
    let _ = end;
    let decimals = |part: &str| part.split_once('.').map_or(0, |(_, after)| after.len());
    let decimals = decimals(begin).max(decimals(step));
    // steps = floor((end - beginning) / step + ε), where ε compensates rounding
    let steps = ((last - first) / by + 1e-9).floor();
    if !(by > 0.0 && (0.0..MAX_COUNT as f64).contains(&steps)) {
        return Some(None);
    }
    let at = |i: usize| format!("{:.decimals$}", first + i as f64 * by);
    Some(Some((0..=steps as usize).map(at).collect()))
}

/// Returns all combinations of the axes' values, with the last axis varying fastest; `None` if there are too many.
pub fn list_combinations(axes: &[Axis]) -> Option<Vec<Vec<String>>> {
    let mut cells = vec![Vec::new()];
    for axis in axes {
        if cells.len().checked_mul(axis.values.len())? > MAX_COUNT {
            return None;
        }
        let with =
            |cell: &Vec<String>, value: &String| [&cell[..], std::slice::from_ref(value)].concat();
        cells = (cells.iter())
            .flat_map(|cell| axis.values.iter().map(move |value| with(cell, value)))
            .collect();
    }
    Some(cells)
}

/// The common setup of all runs of a sweep.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct SweepSetup {
    /// Name of a shipped scenario, or path of a task file.
    pub task: String,
    /// Digest of all its inputs.
    pub inputs: String,
    /// Keys whose values vary.
    pub keys: Vec<String>,
    /// Last stage of each run.
    pub extent: WipingExtent,
}

/// A case of a sweep: values and a seed.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct SweepCase {
    /// The values of the keys.
    pub values: Vec<String>,
    /// The seed.
    pub seed: u64,
}

/// A run of a sweep with its score.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SweepRun {
    /// The case.
    pub case: SweepCase,
    /// The common setup.
    pub setup: SweepSetup,
    /// The score.
    pub score: WipingScore,
}

impl SweepCase {
    /// Returns the options to load the task with these keys.
    pub fn load_options(&self, keys: &[String]) -> LoadOptions {
        LoadOptions {
            settings: keys
                .iter()
                .cloned()
                .zip(self.values.iter().cloned())
                .collect(),
            seed: Some(self.seed),
            ..LoadOptions::default()
        }
    }

    /// Runs the task of the case once.
    ///
    /// # Errors
    /// A message if a stage fails.
    pub fn evaluate(&self, setup: &SweepSetup) -> Result<SweepRun, String> {
        let options = WipingOptions {
            extent: setup.extent,
            is_certain: false,
            limit: None,
            is_pictured: false,
        };
        let load = self.load_options(&setup.keys);
        Ok(SweepRun {
            case: self.clone(),
            setup: setup.clone(),
            score: WipingScore::evaluate(Path::new(&setup.task), &load, options)?,
        })
    }
}

/// A combination of values with its statistics over the seeds.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SweepCell {
    /// The values of the keys.
    pub values: Vec<String>,
    /// Number of runs.
    pub runs: usize,
    /// Number of runs that claimed the goal; `None` without execution.
    pub claimed: Option<usize>,
    /// Statistics of the runs.
    pub summary: QuantitySummary,
}

/// Groups runs by combination; combinations without runs are left out.
pub fn group_sweep_runs(cells: &[Vec<String>], runs: &[SweepRun]) -> Vec<SweepCell> {
    let mut by_values: HashMap<&[String], Vec<&WipingScore>> = HashMap::new();
    for run in runs {
        by_values
            .entry(&run.case.values)
            .or_default()
            .push(&run.score);
    }
    let cell = |values: &Vec<String>| {
        let own = by_values.get(&values[..])?;
        Some(SweepCell {
            values: values.clone(),
            runs: own.len(),
            claimed: WipingScore::count_claimed(own),
            summary: summarise_quantities(own.iter().copied()),
        })
    };
    cells.iter().filter_map(cell).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(text: &str) -> Axis {
        text.parse()
            .unwrap_or_else(|error| panic!("{text}: {error}"))
    }

    #[test]
    fn a_range_ends_at_its_end_and_has_round_values() {
        assert_eq!(axis("a=0:0.3:0.1").values, ["0.0", "0.1", "0.2", "0.3"]);
        assert_eq!(axis("a=1:2:0.75").values, ["1.00", "1.75"]);
        assert_eq!(axis("a=-2:2:2,7").values, ["-2", "0", "2", "7"]);
        // Neither is a range: that of a string, and one of two parts.
        assert_eq!(axis("a=x:y:z,1:2").values, ["x:y:z", "1:2"]);
    }

    #[test]
    fn commas_in_brackets_and_quotes_part_nothing() {
        let values = axis(r#"a=["touch", "sight"],['touch'],"x,y",{ a = 1, b = [2, 3] }"#).values;
        let expected = [
            r#"["touch", "sight"]"#,
            "['touch']",
            r#""x,y""#,
            "{ a = 1, b = [2, 3] }",
        ];
        assert_eq!(values, expected);
    }

    #[test]
    fn what_is_no_axis_says_why() {
        for (text, expected) in [
            ("a", "\"=\" is missing"),
            ("=3", "the key before"),
            ("a=", "a: value 1 is empty"),
            ("a=1,,2", "a: value 2 is empty"),
            ("a=1,2,1", "a: 1 is given twice"),
            ("a=1:2:0", "a: the range 1:2:0 does not lead"),
            ("a=2:1:1", "a: the range 2:1:1 does not lead"),
            ("a=0:1:1e-9", "a: the range 0:1:1e-9 does not lead"),
        ] {
            let error = text.parse::<Axis>().expect_err(text).to_string();
            assert!(error.starts_with(expected), "{text}: {error}");
        }
    }

    #[test]
    fn cells_are_the_cross_product_in_order() {
        let all = list_combinations(&[axis("a=1,2"), axis("b=x,y,z")]).expect("few");
        let joined: Vec<String> = all.iter().map(|cell| cell.join("")).collect();
        assert_eq!(joined, ["1x", "1y", "1z", "2x", "2y", "2z"]);
        assert_eq!(list_combinations(&[]), Some(vec![vec![]]));
        let many = axis("a=1:1000:1");
        assert_eq!(list_combinations(&[many.clone(), many]), None);
    }
}
