//! Conformal prediction bands of the windows of a run.

use super::profile::{CHANNELS, EpisodeProfile, PHASES, PhaseWindow};
use std::thread;
use wisch::run::{AlikeEpisode, WarningChannel, WarningSpan};

/// Factor by which the median absolute deviation of normal values is smaller than their standard deviation.
const MAD_TO_DEVIATION: f64 = 1.4826;
/// Least number of windows of an eighth of the strokes in which runs are compared.
const LEAST_WINDOWS: usize = 8;
/// Quantile of the scores of the episodes by which those of a channel are divided [1].
const SCALE_QUANTILE: f64 = 0.9;
/// Number of windows from which the mean of a run counts half.
const SETTLING_WINDOWS: f64 = 10.0;
/// Number of the most similar episodes that a warning names.
const ALIKE: usize = 3;
/// Scores of a run: for each channel the largest momentary one [1], and that of the mean, in the channel's unit.
const PARTS: usize = 2 * CHANNELS;

/// Returns the least deviation of a channel that is distinguished from none, in the channel's unit.
const fn resolution(channel: usize) -> f64 {
    match WarningChannel::ALL[channel] {
        WarningChannel::Force => 0.05,
        WarningChannel::Height | WarningChannel::TrackingError => 2e-4,
        WarningChannel::ContactShare => 0.02,
    }
}

/// The reason why the episodes of a memory give no bands.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum BandError {
    /// The rate is not between 0 and 1.
    #[error("the rate of false warnings is {rate}; expected more than 0 and less than 1")]
    Rate {
        /// The rate \[1\].
        rate: f64,
    },
    /// There are too few episodes for the rate.
    #[error("{found} comparable episodes are too few; {needed} are needed")]
    TooFew {
        /// Number of episodes.
        found: usize,
        /// Least number of episodes.
        needed: usize,
    },
}

/// Median and spread of the windows of one channel in one eighth of the strokes.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Cell {
    median: f64,
    /// Estimated standard deviation plus the resolution of the channel.
    spread: f64,
}

/// The cells by channel and part of the stroke; `None` for a part with too few windows.
type Cells = [[Option<Cell>; PHASES]; CHANNELS];

/// Prediction bands of a run, and the scores of the episodes from which they were computed.
#[derive(Debug, Clone, PartialEq)]
pub struct ConformalBands {
    cells: Cells,
    /// Quantile of each part of the scores, by which it is divided.
    scales: [f64; PARTS],
    /// Score that a run without a change exceeds at the rate at most.
    threshold: f64,
    episodes: Vec<ScoredEpisode>,
}

/// An episode with its scores against the other episodes.
#[derive(Debug, Clone, PartialEq)]
struct ScoredEpisode {
    episode: AlikeEpisode,
    /// Parts over their scales.
    parts: [f64; PARTS],
    score: f64,
}

/// The scores of a run so far, by [`ConformalBands::compare`].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RunScore {
    /// Sums over all windows in which a channel is compared: values, medians of their cells, and the number.
    values: [f64; CHANNELS],
    medians: [f64; CHANNELS],
    counts: [f64; CHANNELS],
    /// Largest scores so far.
    parts: [f64; PARTS],
}

/// A channel whose value is outside its band.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BandDeviation {
    /// The channel.
    pub channel: WarningChannel,
    /// The windows that the value is a mean of.
    pub span: WarningSpan,
    /// The value, in the channel's unit.
    pub value: f64,
    /// Lower and upper end of its band, in the channel's unit.
    pub band: [f64; 2],
}

impl RunScore {
    /// Adds a channel of a window, and returns the momentary score and that of the mean so far.
    fn add(&mut self, channel: usize, value: f64, cell: Cell) -> [f64; 2] {
        self.values[channel] += value;
        self.medians[channel] += cell.median;
        self.counts[channel] += 1.0;
        let count = self.counts[channel];
        let mean = (self.values[channel] - self.medians[channel]) / count;
        let scores = [
            (value - cell.median).abs() / cell.spread,
            mean.abs() * settled(count),
        ];
        for (part, score) in [channel, CHANNELS + channel].into_iter().zip(scores) {
            self.parts[part] = self.parts[part].max(score);
        }
        scores
    }

    fn add_all(&mut self, window: &PhaseWindow, cells: &Cells) {
        for (channel, cells) in cells.iter().enumerate() {
            if let Some(cell) = cells[window.part()] {
                self.add(channel, window.values[channel], cell);
            }
        }
    }
}

/// Returns the weight of a mean over this number of windows [1].
fn settled(count: f64) -> f64 {
    (count / (count + SETTLING_WINDOWS)).sqrt()
}

impl ConformalBands {
    /// Returns the least number of episodes for a rate of false warnings \[1\].
    pub fn least_episodes(rate: f64) -> usize {
        // p = 1 / (n + 1) is the least p-value.
        ((1.0 / rate - 1e-9).ceil() - 1.0).max(1.0) as usize
    }

    /// Computes the bands of comparable episodes.
    ///
    /// # Parameters
    /// - `profiles`: the episodes; their order does not matter, except among equal scores.
    /// - `rate`: largest probability of a warning in a run without a change \[1\].
    ///
    /// # Errors
    /// If the rate is not between 0 and 1, or there are too few episodes for it.
    pub fn fit(profiles: &[EpisodeProfile], rate: f64) -> Result<Self, BandError> {
        if !(rate > 0.0 && rate < 1.0) {
            return Err(BandError::Rate { rate });
        }
        let (found, needed) = (profiles.len(), Self::least_episodes(rate));
        if found < needed {
            return Err(BandError::TooFew { found, needed });
        }
        let pool = WindowPool::new(profiles);
        let all_parts = score_against_others(profiles, &pool);
        let mut scales = [0.0; PARTS];
        for (part, scale) in scales.iter_mut().enumerate() {
            let mut scores: Vec<f64> = all_parts.iter().map(|parts| parts[part]).collect();
            scores.sort_by(f64::total_cmp);
            let quantile = scores[(SCALE_QUANTILE * (scores.len() - 1) as f64).round() as usize];
            let least = match part.checked_sub(CHANNELS) {
                None => 1.0,
                Some(channel) => resolution(channel),
            };
            *scale = quantile.max(least);
        }
        let episodes: Vec<ScoredEpisode> = (profiles.iter().zip(all_parts))
            .map(|(profile, parts)| {
                let parts = divide(&parts, &scales);
                ScoredEpisode {
                    episode: profile.episode.clone(),
                    score: largest(&parts),
                    parts,
                }
            })
            .collect();
        let mut scores: Vec<f64> = episodes.iter().map(|episode| episode.score).collect();
        scores.sort_by(|a, b| b.total_cmp(a));
        // (1 + #{scores ≥ s}) / (n + 1) ≤ rate exactly for s above the k-th largest score.
        let kth = ((rate * (found + 1) as f64) + 1e-9).floor() as usize;
        Ok(Self {
            cells: pool.cells(None),
            scales,
            threshold: scores[kth.clamp(1, found) - 1],
            episodes,
        })
    }

    /// Number of episodes.
    pub const fn episodes(&self) -> usize {
        self.episodes.len()
    }

    /// Returns the p-value of a run so far \[1\]. It never grows while the run goes on.
    pub fn p_value(&self, run: &RunScore) -> f64 {
        let score = largest(&divide(&run.parts, &self.scales));
        let above = self.episodes.iter().filter(|other| other.score >= score);
        (1 + above.count()) as f64 / (self.episodes.len() + 1) as f64
    }

    /// Adds a window to a run, and returns the channels that are beyond their bands in it, each at most once.
    pub fn compare(&self, run: &mut RunScore, window: &PhaseWindow) -> Vec<BandDeviation> {
        let mut beyond = Vec::new();
        for (channel, named) in WarningChannel::ALL.into_iter().enumerate() {
            let Some(cell) = self.cells[channel][window.part()] else {
                continue;
            };
            let value = window.values[channel];
            run.add(channel, value, cell);
            let count = run.counts[channel];
            let widths = [
                self.scales[channel] * cell.spread,
                self.scales[CHANNELS + channel] / settled(count),
            ];
            let spans = [
                (WarningSpan::Moment, value, cell.median),
                (
                    WarningSpan::Run,
                    run.values[channel] / count,
                    run.medians[channel] / count,
                ),
            ];
            let deviation = spans.into_iter().zip(widths);
            let mut deviation = deviation.filter_map(|((span, value, middle), width)| {
                let half = (self.threshold * width).max(resolution(channel));
                ((value - middle).abs() > half).then_some(BandDeviation {
                    channel: named,
                    span,
                    value,
                    band: [middle - half, middle + half],
                })
            });
            beyond.extend(deviation.next());
        }
        beyond
    }

    /// Returns the episodes whose scores resemble those of a run so far, the most similar one first.
    pub fn alike(&self, run: &RunScore) -> Vec<AlikeEpisode> {
        let parts = divide(&run.parts, &self.scales).map(f64::ln_1p);
        let distance = |other: &ScoredEpisode| {
            let pairs = parts.iter().zip(&other.parts);
            pairs.map(|(a, b)| (a - b.ln_1p()).powi(2)).sum::<f64>()
        };
        let mut order: Vec<(f64, usize)> = (self.episodes.iter().map(distance)).zip(0..).collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let alike = order.into_iter().take(ALIKE);
        alike
            .map(|(_, place)| self.episodes[place].episode.clone())
            .collect()
    }
}

fn divide(parts: &[f64; PARTS], scales: &[f64; PARTS]) -> [f64; PARTS] {
    std::array::from_fn(|part| parts[part] / scales[part])
}

fn largest(parts: &[f64; PARTS]) -> f64 {
    parts.iter().copied().fold(0.0, f64::max)
}

/// Returns the parts of the score of each episode against the others.
fn score_against_others(profiles: &[EpisodeProfile], pool: &WindowPool) -> Vec<[f64; PARTS]> {
    let score = |(number, profile): (usize, &EpisodeProfile)| {
        let cells = pool.cells(Some(number));
        let mut run = RunScore::default();
        for window in &profile.windows {
            run.add_all(window, &cells);
        }
        run.parts
    };
    let threads = thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let share = profiles.len().div_ceil(threads);
    let numbered: Vec<(usize, &EpisodeProfile)> = profiles.iter().enumerate().collect();
    thread::scope(|scope| {
        let parts = numbered.chunks(share);
        let running: Vec<_> = parts
            .map(|part| scope.spawn(move || part.iter().copied().map(score).collect::<Vec<_>>()))
            .collect();
        let done = running.into_iter().flat_map(|thread| match thread.join() {
            Ok(scores) => scores,
            Err(panic) => std::panic::resume_unwind(panic),
        });
        done.collect()
    })
}

/// The windows of all episodes by channel and part of the stroke: values with the numbers of their episodes, sorted.
struct WindowPool(Vec<Vec<(f64, usize)>>);

impl WindowPool {
    fn new(profiles: &[EpisodeProfile]) -> Self {
        let mut pool = vec![Vec::new(); CHANNELS * PHASES];
        for (number, profile) in profiles.iter().enumerate() {
            for window in &profile.windows {
                for (channel, value) in window.values.into_iter().enumerate() {
                    pool[channel * PHASES + window.part()].push((value, number));
                }
            }
        }
        for cell in &mut pool {
            cell.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        }
        Self(pool)
    }

    /// Returns the cells of all episodes but one.
    fn cells(&self, without: Option<usize>) -> Cells {
        let mut values = Vec::new();
        std::array::from_fn(|channel| {
            std::array::from_fn(|part| {
                let all = self.0[channel * PHASES + part].iter();
                values.clear();
                values.extend(
                    all.filter(|(_, number)| Some(*number) != without)
                        .map(|v| v.0),
                );
                if values.len() < LEAST_WINDOWS {
                    return None;
                }
                let middle = values.len() / 2;
                let median = values[middle];
                for value in &mut values {
                    *value = (*value - median).abs();
                }
                let (_, deviation, _) = values.select_nth_unstable_by(middle, f64::total_cmp);
                let spread = MAD_TO_DEVIATION * *deviation + resolution(channel);
                Some(Cell { median, spread })
            })
        })
    }
}
