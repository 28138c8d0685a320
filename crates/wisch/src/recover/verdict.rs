//! Whether the goal is met, and what follows if it is not.

use crate::interpret::{Diagnosis, Doubt, Interpretation, PerformanceDistribution};
use std::fmt;

/// An estimate that rises by less than this is no progress [1].
pub const LEAST_PROGRESS: f64 = 0.005;
/// After so many strokes in a row that brought nothing, the next one is not expected to.
const STALLED_STROKES: usize = 4;
/// A claim is false if the performance is farther than this below the target [1].
pub const FALSE_BY: f64 = 0.1;
/// How likely a claim may be false [1].
pub const FALSE_CLAIMS: f64 = 0.002;

/// How far a round is executed before its outcome is looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Pace {
    /// All strokes, then the interpretation.
    #[default]
    Whole,
    /// One segment of a plan, that which is predicted to gain most, then the interpretation.
    Greedy,
}

/// What follows from a round: [`Verdict::Again`] goes on, any other ends the session.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// The expected performance reaches the target, it is hardly possible that it is far below, and there was contact, or
    /// sight, to show for it.
    GoalMet,
    /// Wipe again.
    Again,
    /// The estimate no longer rises.
    NoProgress,
    /// No plan is predicted to do any better: what is not where it belongs has left the surface, or would.
    NothingToGain,
    /// The robot cannot wipe again: no plan or no motion was found for the surface where it was felt.
    NoWay,
    /// The motion that was found for the next round fails its audit, and is not executed.
    UnsafeMotion,
    /// The log does not say what was wiped: no contact was found in it, or its doubts speak against what was found. It is
    /// neither success nor failure.
    CannotBeTold,
    /// The goal may be met or not: wiping again is expected to change nothing, and touch cannot tell. Of a tool that hovers it
    /// never can.
    UnknowableByTouch,
}

impl Verdict {
    /// The verdict in the words of results and reports, such as "goal met".
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::GoalMet => "goal met",
            Self::Again => "wipe again",
            Self::NoProgress => "no progress",
            Self::NoWay => "no way to wipe again",
            Self::NothingToGain => "nothing to gain",
            Self::UnsafeMotion => "unsafe motion",
            Self::CannotBeTold => "cannot be told",
            Self::UnknowableByTouch => "unknowable by touch",
        }
    }
}

/// Whether the goal may be claimed: it is expected to be met, and the performance is hardly farther than [`FALSE_BY`] below
/// the target.
pub fn is_claimable(believed: &PerformanceDistribution, target: f64) -> bool {
    Claim::of(believed, target).holds()
}

/// The rule by which a goal is claimed, with the numbers that decide.
///
/// ```
/// use wisch::interpret::PerformanceDistribution;
/// use wisch::recover::Claim;
/// let believed = PerformanceDistribution::of_shares([(0.7, 1.0), (0.98, 19.0)], 0.0);
/// let claim = Claim::of(&believed, 0.95);
/// assert!(!claim.holds());
/// assert_eq!(
///     claim.to_string(),
///     "96.6 % expected reaches the target of 95.0 %, but less than 85.0 % has a probability of 5.0 %, and a claim allows 0.2 %"
/// );
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Claim {
    expected: f64,
    target: f64,
    /// Probability that the performance is farther than [`FALSE_BY`] below the target [1].
    far_below: f64,
}

impl Claim {
    /// Of a belief about the performance and a target [1].
    pub fn of(believed: &PerformanceDistribution, target: f64) -> Self {
        Self {
            expected: believed.mean(),
            target,
            far_below: believed.probability_below(target - FALSE_BY),
        }
    }

    /// Whether the goal may be claimed.
    pub fn holds(&self) -> bool {
        self.expected >= self.target && self.far_below <= FALSE_CLAIMS
    }
}

impl fmt::Display for Claim {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = |share: f64| format!("{:.1} %", 100.0 * share);
        let [expected, target] = [self.expected, self.target].map(percent);
        if self.expected < self.target {
            return write!(f, "{expected} expected is below the target of {target}");
        }
        let tail = percent((self.target - FALSE_BY).max(0.0));
        let allowed = percent(FALSE_CLAIMS);
        if self.holds() {
            return write!(
                f,
                "{expected} expected reaches the target of {target}, and less than {tail} has a probability of at most {allowed}"
            );
        }
        // Never as little as is allowed, which it is more than.
        let found = (1e3 * self.far_below).ceil().max(1e3 * FALSE_CLAIMS + 1.0) / 10.0;
        write!(
            f,
            "{expected} expected reaches the target of {target}, but less than {tail} has a probability of {found:.1} %, and a claim allows {allowed}"
        )
    }
}

/// Judges a log by itself, of which no round came before: [`Verdict::GoalMet`], [`Verdict::CannotBeTold`],
/// [`Verdict::UnknowableByTouch`], or [`Verdict::Again`] where the goal is not met.
pub fn judge_log(interpretation: &Interpretation, target: f64) -> Verdict {
    let is_seen = interpretation.observation.is_some();
    // What was wiped before a log begins, or after it ends, may be what is missing.
    let is_cut = !is_seen && interpretation.doubts.iter().any(Doubt::is_cut);
    if !interpretation.can_be_told() {
        Verdict::CannotBeTold
    } else if is_claimable(&interpretation.distribution, target)
        && (is_seen || interpretation.diagnosis != Diagnosis::Hovering)
    {
        Verdict::GoalMet
    } else if is_cut {
        Verdict::CannotBeTold
    } else if !is_seen && interpretation.performance.high >= target {
        Verdict::UnknowableByTouch
    } else {
        Verdict::Again
    }
}

/// What is known of a round when it is judged.
#[derive(Debug, Clone, Copy)]
pub struct RoundOutcome<'a> {
    /// What was felt, and seen.
    pub interpretation: &'a Interpretation,
    /// Expected performance before the round [1].
    pub performance_before: f64,
    /// Nothing is believed to lie elsewhere than where it belongs, but for what is lost; see
    /// [`is_done`](super::is_done).
    pub is_done: bool,
    /// The robot stopped itself to protect somebody or something.
    pub is_protective_stop: bool,
}

impl RoundOutcome<'_> {
    /// Somebody pushed, or the robot stopped itself.
    fn is_disturbed(&self) -> bool {
        let mut events = self.interpretation.events.iter();
        self.is_protective_stop || events.any(|event| event.kind.is_by_hand())
    }
}

/// Judges one round after the other: it remembers how sure it was, and for how long nothing was gained.
#[derive(Debug, Clone)]
pub struct RoundJudge {
    target: f64,
    pace: Pace,
    /// 5th percentile of the performance after the round before.
    low_before: f64,
    /// Rounds in a row without progress.
    stalled: usize,
    /// No round was judged so far.
    is_first: bool,
}

impl RoundJudge {
    /// No round so far; `target` is the performance at which the goal is met [1].
    pub const fn new(target: f64, pace: Pace) -> Self {
        Self {
            target,
            pace,
            low_before: 0.0,
            stalled: 0,
            is_first: true,
        }
    }

    /// Judges the round that has just been interpreted, and remembers it for those to come.
    ///
    /// What happens while somebody pushes is felt badly: only what is felt in a calm round, or seen, shows that the goal is
    /// met. But that somebody or something was in the way says nothing against another try, and neither does a surface
    /// that was found elsewhere.
    pub fn verdict(&mut self, outcome: &RoundOutcome<'_>) -> Verdict {
        let interpretation = outcome.interpretation;
        let is_seen = interpretation.observation.is_some();
        let is_disturbed = outcome.is_disturbed();
        let estimate = &interpretation.performance;
        let is_rising = estimate.mean >= outcome.performance_before + LEAST_PROGRESS
            || estimate.low >= self.low_before + LEAST_PROGRESS;
        let is_elsewhere = matches!(interpretation.diagnosis, Diagnosis::Relocalize { .. });
        self.low_before = estimate.low;
        let is_hovering = interpretation.diagnosis == Diagnosis::Hovering;
        let is_told = interpretation.can_be_told();
        let is_felt = is_seen || interpretation.diagnosis != Diagnosis::NoContact;
        if !is_felt && (is_disturbed || self.is_first) {
            self.is_first = false;
            return if is_disturbed {
                Verdict::Again
            } else {
                Verdict::CannotBeTold
            };
        }
        self.is_first = false;
        let is_shown = is_seen || (is_told && !is_disturbed);
        if is_shown && is_claimable(&interpretation.distribution, self.target) {
            return if is_seen || !is_hovering {
                Verdict::GoalMet
            } else {
                Verdict::UnknowableByTouch
            };
        }
        self.stalled = if is_rising { 0 } else { self.stalled + 1 };
        // A single stroke says little: the next best one is another.
        let is_patient = self.pace == Pace::Greedy && self.stalled < STALLED_STROKES;
        let ended = if outcome.is_done {
            Verdict::NothingToGain
        } else if is_rising || is_elsewhere || is_disturbed || is_patient {
            return Verdict::Again;
        } else {
            Verdict::NoProgress
        };
        self.known(interpretation, ended)
    }

    /// What follows where no plan is predicted to bring anything.
    pub fn without_gain(&self, interpretation: &Interpretation) -> Verdict {
        self.known(interpretation, Verdict::NothingToGain)
    }

    /// How it ends where wiping again brings nothing: touch may not tell whether the goal is met. A camera would.
    fn known(&self, interpretation: &Interpretation, ended: Verdict) -> Verdict {
        let is_seen = interpretation.observation.is_some();
        if !interpretation.can_be_told() {
            Verdict::CannotBeTold
        } else if !is_seen && interpretation.performance.high >= self.target {
            Verdict::UnknowableByTouch
        } else {
            ended
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Point3, Vector3};
    use crate::interpret::{Belief, Event, EventKind, FittedPlane};
    use crate::represent::{Observation, ParticleDistribution};

    const TARGET: f64 = 0.9;

    /// A round that found a plane, with these equally likely performances.
    fn felt(shares: &[f64]) -> Interpretation {
        let shares = shares.iter().map(|share| (*share, 1.0));
        let distribution = PerformanceDistribution::of_shares(shares, 0.0);
        Interpretation {
            path: vec![],
            plane: Some(FittedPlane {
                point: Point3::origin(),
                normal: Vector3::z(),
                tilt: 0.0,
                offset: 0.0,
                directions: 2,
                inliers: 100,
                confident: 100,
                rms: 0.0,
            }),
            diagnosis: Diagnosis::Localized,
            doubts: vec![],
            events: vec![],
            force_bias: 0.0,
            pressed_force: None,
            tool_stiffness: None,
            contact_share: 1.0,
            belief: Belief::certain(ParticleDistribution::default()),
            performance: distribution.estimate(),
            felt: distribution.estimate(),
            observation: None,
            distribution,
        }
    }

    fn pushed(shares: &[f64]) -> Interpretation {
        let push = Event {
            kind: EventKind::Collision,
            start: 1.0,
            end: 2.0,
            samples: 1000,
            mean_normal_force: 0.0,
            peak_force: 15.0,
            peak_height: 0.02,
        };
        Interpretation {
            events: vec![push],
            ..felt(shares)
        }
    }

    fn seen(interpretation: Interpretation) -> Interpretation {
        Interpretation {
            observation: Some(Observation::default()),
            ..interpretation
        }
    }

    /// The verdicts on rounds one after the other.
    fn verdicts(pace: Pace, is_done: bool, rounds: &[Interpretation]) -> Vec<Verdict> {
        let mut judge = RoundJudge::new(TARGET, pace);
        let mut before = 0.0;
        let verdict = |interpretation| {
            let outcome = RoundOutcome {
                interpretation,
                performance_before: before,
                is_done,
                is_protective_stop: false,
            };
            before = interpretation.performance.mean;
            judge.verdict(&outcome)
        };
        rounds.iter().map(verdict).collect()
    }

    fn of_one(interpretation: Interpretation) -> Verdict {
        verdicts(Pace::Whole, false, &[interpretation])[0]
    }

    #[test]
    fn a_goal_is_claimed_where_it_is_hardly_missed_by_far() {
        use Verdict::{Again, GoalMet};
        assert_eq!(of_one(felt(&[0.95; 8])), GoalMet);
        // Expected to be met, but one of eight says that it is not by far.
        let mut doubtful = [0.95; 8];
        doubtful[0] = 0.7;
        assert_eq!(of_one(felt(&doubtful)), Again);
        doubtful[0] = 0.81;
        assert_eq!(of_one(felt(&doubtful)), GoalMet);
        assert_eq!(of_one(felt(&[0.89; 8])), Again);
        assert_eq!(of_one(felt(&[TARGET; 7])), GoalMet, "exactly");
    }

    #[test]
    fn what_is_felt_while_somebody_pushes_shows_nothing_and_what_is_seen_does() {
        use Verdict::{Again, CannotBeTold, GoalMet};
        let done = [0.95; 8];
        assert_eq!(of_one(pushed(&done)), Again);
        assert_eq!(of_one(seen(pushed(&done))), GoalMet);
        let untouched = |interpretation| Interpretation {
            plane: None,
            diagnosis: Diagnosis::NoContact,
            ..interpretation
        };
        assert_eq!(of_one(untouched(felt(&done))), CannotBeTold);
        assert_eq!(of_one(untouched(pushed(&done))), Again);
        // Neither does a later round that finds nothing to touch.
        let rounds = [felt(&[0.6; 8]), untouched(felt(&[0.6; 8]))];
        let verdicts = verdicts(Pace::Whole, false, &rounds);
        assert_eq!(verdicts, [Again, CannotBeTold]);
        assert_eq!(of_one(untouched(seen(felt(&done)))), GoalMet);
        let mut judge = RoundJudge::new(TARGET, Pace::Whole);
        let stopped = RoundOutcome {
            interpretation: &felt(&done),
            performance_before: 0.0,
            is_done: false,
            is_protective_stop: true,
        };
        assert_eq!(judge.verdict(&stopped), Again);
    }

    #[test]
    fn what_hovers_feels_nothing_and_shows_its_goal_to_a_camera_only() {
        let hovering = |shares: &[f64]| Interpretation {
            plane: None,
            diagnosis: Diagnosis::Hovering,
            ..felt(shares)
        };
        assert_eq!(of_one(hovering(&[0.95; 8])), Verdict::UnknowableByTouch);
        assert_eq!(of_one(seen(hovering(&[0.95; 8]))), Verdict::GoalMet);
        assert_eq!(of_one(hovering(&[0.5; 8])), Verdict::Again);
    }

    #[test]
    fn where_wiping_ends_touch_may_not_tell_whether_the_goal_is_met() {
        use Verdict::{Again, NoProgress, NothingToGain, UnknowableByTouch};
        let mut wide = [0.95; 8];
        wide[0] = 0.5;
        let twice = |shares: &[f64]| [felt(shares), felt(shares)];
        let of_two = |rounds: &[Interpretation]| verdicts(Pace::Whole, false, rounds);
        assert_eq!(of_two(&twice(&wide)), [Again, UnknowableByTouch]);
        assert_eq!(of_two(&twice(&[0.6; 8])), [Again, NoProgress]);
        assert_eq!(of_two(&twice(&wide).map(seen)), [Again, NoProgress]);
        assert_eq!(of_two(&twice(&wide).map(|_| pushed(&wide))), [Again, Again]);
        let done = |shares| verdicts(Pace::Whole, true, &[felt(shares)])[0];
        assert_eq!(done(&[0.6; 8]), NothingToGain);
        assert_eq!(done(&wide), UnknowableByTouch);
        let judge = RoundJudge::new(TARGET, Pace::Whole);
        let without_gain = |interpretation| judge.without_gain(&interpretation);
        assert_eq!(without_gain(felt(&[0.6; 8])), NothingToGain);
        assert_eq!(without_gain(felt(&wide)), UnknowableByTouch);
        assert_eq!(without_gain(seen(felt(&wide))), NothingToGain);
        // To become surer is progress.
        let mut surer = wide;
        surer[0] = 0.7;
        assert_eq!(of_two(&[felt(&wide), felt(&surer)]), [Again, Again]);
    }

    #[test]
    fn a_single_stroke_may_bring_nothing_and_four_in_a_row_may_not() {
        use Verdict::{Again, NoProgress};
        let mut rounds = vec![felt(&[0.5; 8]); 4];
        rounds.extend(vec![felt(&[0.6; 8]); 5]);
        let mut expected = [Again; 9];
        expected[8] = NoProgress;
        assert_eq!(verdicts(Pace::Greedy, false, &rounds), expected);
    }
}
