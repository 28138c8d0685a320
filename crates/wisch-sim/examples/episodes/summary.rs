//! What came of the episodes.

use std::fmt;
use wisch::recover::Verdict;
use wisch::run::Ending;

/// A claim is false if the truth is below the target by more than this [1].
const FALSE_BY: f64 = 0.10;
/// Sizes of errors of the estimate that are told, as shares of all errors [1].
const QUANTILES: [f64; 4] = [0.5, 0.9, 0.95, 1.0];
/// Pushes with less time between them are one [s].
const PUSH_GAP: f64 = 0.35;
/// An end of a push is found if it is felt no more than this apart [s].
const PUSH_TOLERANCE: f64 = 0.05;
/// Rounding of a force that is saturated at a limit [N].
const FORCE_ROUNDING: f64 = 1e-9;

/// One episode.
pub struct Episode {
    pub seed: u64,
    pub disturbances: String,
    /// From when to when somebody pushed in the first round [s].
    pub pushes: Vec<[f64; 2]>,
    /// Samples in which something is not a number.
    pub bad_samples: usize,
    pub fate: Fate,
}

/// How an episode went.
pub enum Fate {
    /// Through these rounds.
    Ended(Vec<Pass>),
    /// With an error.
    Failed(String),
    /// With a panic.
    Panicked(String),
}

impl Episode {
    /// The pushes that were over when the first round was, those soon after each other as one.
    fn whole_pushes(&self, duration: f64) -> Vec<[f64; 2]> {
        let mut pushes = self.pushes.clone();
        pushes.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut whole: Vec<[f64; 2]> = Vec::new();
        for [start, end] in pushes {
            match whole.last_mut() {
                Some(before) if start <= before[1] + PUSH_GAP => before[1] = before[1].max(end),
                _ => whole.push([start, end]),
            }
        }
        whole.retain(|push| push[1] < duration);
        whole
    }
}

/// How pushes were felt.
#[derive(Default)]
struct Pushes {
    count: usize,
    found: usize,
    /// How far starts and ends are off, of those found [s].
    off: [Vec<f64>; 2],
}

impl Pushes {
    fn add(&mut self, pushes: &[[f64; 2]], collisions: &[[f64; 2]]) {
        for [start, end] in pushes {
            self.count += 1;
            let felt = (collisions.iter()).filter(|felt| felt[0] < *end && felt[1] > *start);
            let whole = felt
                .copied()
                .reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]);
            if let Some(felt) = whole {
                self.found += 1;
                self.off[0].push((felt[0] - start).abs());
                self.off[1].push((felt[1] - end).abs());
            }
        }
    }
}

/// One round.
pub struct Pass {
    pub estimated: f64,
    /// 90 % interval of the estimate.
    pub interval: [f64; 2],
    /// The true performance, where dirt was simulated.
    pub truth: Option<f64>,
    /// From when to when a collision was felt [s].
    pub collisions: Vec<[f64; 2]>,
    pub verdict: Verdict,
    pub ending: Ending,
    /// How long it took [s].
    pub duration: f64,
    /// Greatest force of the controller, and what it is limited to [N].
    pub controller_force: f64,
    pub force_limit: f64,
    /// Mean true force of the surface on the tool [N].
    pub contact_force: f64,
}

impl Pass {
    fn is_stopped(&self) -> bool {
        matches!(self.ending, Ending::ProtectiveStop { .. })
    }

    fn is_finite(&self) -> bool {
        let values = [
            self.estimated,
            self.interval[0],
            self.interval[1],
            self.truth.unwrap_or(0.0),
            self.controller_force,
            self.contact_force,
        ];
        values.iter().all(|value| value.is_finite())
    }

    /// Whether the goal is claimed while the truth is far below the target.
    fn is_false_claim(&self, target: f64) -> bool {
        let truth = self.truth.unwrap_or(f64::INFINITY);
        self.verdict == Verdict::GoalMet && truth < target - FALSE_BY
    }
}

impl fmt::Display for Episode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:4} ", self.seed)?;
        match &self.fate {
            Fate::Failed(error) => write!(f, "ERROR {error}")?,
            Fate::Panicked(message) => write!(f, "PANIC {message}")?,
            Fate::Ended(passes) => {
                for pass in passes {
                    let truth = pass
                        .truth
                        .map_or("-".to_owned(), |t| format!("{:.1}", 100.0 * t));
                    write!(
                        f,
                        "| est {:5.1} ({:.1} to {:.1}) true {truth:>5} {:4.1} N {:4.0} s ",
                        100.0 * pass.estimated,
                        100.0 * pass.interval[0],
                        100.0 * pass.interval[1],
                        pass.contact_force,
                        pass.duration,
                    )?;
                    for [start, end] in &pass.collisions {
                        write!(f, "coll {start:.2}-{end:.2} ")?;
                    }
                    write!(f, "{} ", pass.verdict.as_str())?;
                    if let Ending::ProtectiveStop { time, cause } = &pass.ending {
                        write!(f, "STOP at {time:.1} s: {cause} ")?;
                    }
                }
            }
        }
        write!(f, "| {}", self.disturbances)
    }
}

/// All episodes together.
pub struct Summary {
    episodes: usize,
    target: f64,
    /// One line per error and per panic.
    failures: Vec<String>,
    bad_numbers: usize,
    stops: Vec<String>,
    over_force: usize,
    /// Episodes by their number of rounds.
    rounds: Vec<usize>,
    claimed: usize,
    /// Claims whose truth is below the target at all.
    below_target: usize,
    /// Episodes whose truth reaches the target at the end, and those of them that claim it.
    reached: usize,
    reached_and_claimed: usize,
    false_claims: Vec<String>,
    /// Sizes of estimated − true over all rounds, in order.
    errors: Vec<f64>,
    held: usize,
    /// Estimated − true, all together.
    drift: f64,
    last_truths: Vec<f64>,
    pushes: Pushes,
}

impl Summary {
    /// Counts.
    pub fn of(episodes: &[Episode], target: f64) -> Self {
        let mut all = Self {
            episodes: episodes.len(),
            target,
            failures: Vec::new(),
            bad_numbers: 0,
            stops: Vec::new(),
            over_force: 0,
            rounds: Vec::new(),
            claimed: 0,
            below_target: 0,
            reached: 0,
            reached_and_claimed: 0,
            false_claims: Vec::new(),
            errors: Vec::new(),
            held: 0,
            drift: 0.0,
            last_truths: Vec::new(),
            pushes: Pushes::default(),
        };
        for episode in episodes {
            all.add(episode);
        }
        all.errors.sort_by(f64::total_cmp);
        all.last_truths.sort_by(f64::total_cmp);
        all
    }

    fn add(&mut self, episode: &Episode) {
        let seed = episode.seed;
        let passes = match &episode.fate {
            Fate::Ended(passes) => passes,
            Fate::Failed(error) => {
                self.failures.push(format!("seed {seed}: error: {error}"));
                return;
            }
            Fate::Panicked(message) => {
                self.failures.push(format!("seed {seed}: panic: {message}"));
                return;
            }
        };
        if let Some(first) = passes.first() {
            let whole = episode.whole_pushes(first.duration);
            self.pushes.add(&whole, &first.collisions);
        }
        if self.rounds.len() <= passes.len() {
            self.rounds.resize(passes.len() + 1, 0);
        }
        self.rounds[passes.len()] += 1;
        let is_bad = episode.bad_samples > 0 || passes.iter().any(|pass| !pass.is_finite());
        self.bad_numbers += usize::from(is_bad);
        for (pass, number) in passes.iter().zip(1..) {
            if let Ending::ProtectiveStop { time, cause } = &pass.ending {
                let line = format!("seed {seed} round {number} at {time:.1} s: {cause}");
                self.stops.push(line);
            }
            self.over_force +=
                usize::from(pass.controller_force > pass.force_limit + FORCE_ROUNDING);
            if let Some(truth) = pass.truth {
                let error = pass.estimated - truth;
                self.errors.push(error.abs());
                self.drift += error;
                let [low, high] = pass.interval;
                self.held += usize::from((low..=high).contains(&truth));
            }
            if pass.is_false_claim(self.target) {
                self.false_claims.push(format!(
                    "seed {seed} round {number}: estimated {:.1} %, true {:.1} %{}",
                    100.0 * pass.estimated,
                    100.0 * pass.truth.unwrap_or(f64::NAN),
                    if pass.is_stopped() { ", stopped" } else { "" },
                ));
            }
        }
        let Some(last) = passes.last() else {
            return;
        };
        let is_reached = last.truth.is_some_and(|truth| truth >= self.target);
        self.reached += usize::from(is_reached);
        if last.verdict == Verdict::GoalMet {
            self.reached_and_claimed += usize::from(is_reached);
            self.claimed += 1;
            self.below_target += usize::from(last.truth.is_some_and(|t| t < self.target));
        }
        self.last_truths.extend(last.truth);
    }

    /// Whether nothing happened that must not.
    pub fn is_clean(&self) -> bool {
        self.failures.is_empty()
            && self.bad_numbers == 0
            && self.over_force == 0
            && self.false_claims.is_empty()
    }
}

/// The value below which a share of sorted values lies.
fn quantile(sorted: &[f64], share: f64) -> f64 {
    let last = sorted.len().saturating_sub(1);
    let at = (share * last as f64).round() as usize;
    sorted.get(at).copied().unwrap_or(f64::NAN)
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        writeln!(f, "episodes            {}", self.episodes)?;
        writeln!(f, "errors and panics   {}", self.failures.len())?;
        for line in &self.failures {
            writeln!(f, "  {line}")?;
        }
        writeln!(f, "numbers that are none in {} episodes", self.bad_numbers)?;
        writeln!(f, "controller over its limit in {} rounds", self.over_force)?;
        writeln!(f, "protective stops    {}", self.stops.len())?;
        for line in &self.stops {
            writeln!(f, "  {line}")?;
        }
        let counts: Vec<String> = (self.rounds.iter().enumerate())
            .filter(|(_, count)| **count > 0)
            .map(|(rounds, count)| format!("{rounds} in {count}"))
            .collect();
        writeln!(f, "rounds              {}", counts.join(", "))?;
        writeln!(
            f,
            "goal claimed        {} of {}, {} of them with a truth below the target of {:.0} %",
            self.claimed,
            self.episodes,
            self.below_target,
            100.0 * self.target
        )?;
        writeln!(
            f,
            "target reached      in {}, claimed in {} of these",
            self.reached, self.reached_and_claimed
        )?;
        writeln!(
            f,
            "false claims        {} ({:.1} % of claims): more than {:.0} points below the target",
            self.false_claims.len(),
            100.0 * self.false_claims.len() as f64 / self.claimed.max(1) as f64,
            100.0 * FALSE_BY
        )?;
        for line in &self.false_claims {
            writeln!(f, "  {line}")?;
        }
        writeln!(
            f,
            "true performance    {:.1} % at the median, {:.1} % on average, {:.1} % at worst",
            100.0 * quantile(&self.last_truths, 0.5),
            100.0 * mean(&self.last_truths),
            100.0 * quantile(&self.last_truths, 0.0)
        )?;
        let told: Vec<String> = (QUANTILES.iter())
            .map(|&share| {
                let error = 100.0 * quantile(&self.errors, share);
                format!("{:.0} %: {error:.1}", 100.0 * share)
            })
            .collect();
        writeln!(
            f,
            "|estimated − true|  {:.1} points on average over {} rounds, quantiles {}; mean error {:+.1}",
            100.0 * mean(&self.errors),
            self.errors.len(),
            told.join(", "),
            100.0 * self.drift / self.errors.len() as f64
        )?;
        writeln!(
            f,
            "90 % interval       holds the truth in {} of {} rounds",
            self.held,
            self.errors.len()
        )?;
        let near = |off: &Vec<f64>| off.iter().filter(|off| **off <= PUSH_TOLERANCE).count();
        let [starts, ends] = &self.pushes.off;
        writeln!(
            f,
            "pushes              {} of {} felt, {} starts and {} ends within {:.0} ms",
            self.pushes.found,
            self.pushes.count,
            near(starts),
            near(ends),
            1e3 * PUSH_TOLERANCE
        )
    }
}
