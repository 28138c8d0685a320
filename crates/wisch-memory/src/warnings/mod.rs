//! Warnings while a robot wipes: the running stroke against comparable earlier episodes, by conformal prediction.
//!
//! [`find_basis`] reads the newest comparable episodes of a memory: the same robot, tool, surface, dirt, press force, action,
//! executor and strategy, complete, and without a push, hand guiding, overload or protective stop. [`MemoryWatch`] compares a run with
//! them, sample by sample.
//!
//! - **Windows**: the samples of a stroke in contact are averaged over a tenth of a second. A window belongs to an eighth of
//!   the stroke, by the elapsed share of its duration.
//! - **Scores**: for each channel, the largest distance of a window from the median of its eighth over the median absolute
//!   deviation; and the largest mean distance of the run so far. Each is divided by its 90 % quantile over the episodes. The
//!   score of a run is the largest of these quotients.
//! - **p-value**: (1 + number of episodes with a score of at least that of the run) / (1 + number of episodes). Each episode is
//!   scored against the others. Episodes, not strokes, are assumed to be exchangeable. The score of a run only grows, so the
//!   p-value holds at any time of the run, and over all channels together.
//! - **Resolution**: a deviation below the resolution of a channel gives no warning, whatever its p-value.

mod bands;
mod basis;
mod gauge;
mod profile;
mod run_watch;
mod watch;

pub use bands::{BandDeviation, BandError, ConformalBands, RunScore};
pub use basis::{ComparableRun, WarningBasis, find_basis};
pub use profile::{EpisodeProfile, PhaseWindow, ProfileBuilder, StrokeSample};
pub use run_watch::watch_run;
pub use watch::MemoryWatch;
