//! Whether the goal is met, and what follows if it is not.

use crate::interpret::{Diagnosis, Interpretation};

/// An estimate that rises by less than this is no progress [1].
pub const LEAST_PROGRESS: f64 = 0.005;
/// After so many strokes in a row that brought nothing, the next one is not expected to.
const STALLED_STROKES: usize = 4;
/// After a push, how far the lower end of the estimate may lie below the target for it to be claimed; half of what a
/// claim may be wrong by.
const DOUBT_TOLERATED: f64 = 0.05;

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
    /// The estimated performance reaches the target, and there was contact to show for it.
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
    /// The surface was not felt, and nobody was in the way: nothing is known of the effect.
    NoContact,
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
            Self::NoContact => "no contact",
        }
    }
}

/// Judges a round. `before` is the estimate that it began with; a round that found the surface elsewhere
/// gets another one whatever it achieved.
///
/// The goal counts as met where the estimate reaches the target and confident contacts show it; an
/// estimate alone, such as that of a surface that was clean from the start, is no evidence.
pub fn judge(interpretation: &Interpretation, before: f64, target: f64) -> Verdict {
    let estimate = &interpretation.performance;
    let is_elsewhere = matches!(interpretation.diagnosis, Diagnosis::Relocalize { .. });
    if interpretation.plane.is_none() {
        Verdict::NoContact
    } else if estimate.mean >= target {
        Verdict::GoalMet
    } else if estimate.mean < before + LEAST_PROGRESS && !is_elsewhere {
        Verdict::NoProgress
    } else {
        Verdict::Again
    }
}

/// What matters beside the estimate for what follows a round.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Circumstances {
    /// Nothing is believed to lie elsewhere than where it belongs, but for what is lost.
    pub is_done: bool,
    /// Somebody pushed, or the robot stopped itself.
    pub is_disturbed: bool,
    /// Somebody pushed in an earlier round, and by the lower end of the estimate too little may be done.
    pub is_doubtful: bool,
    /// The estimate is higher than before the round.
    pub is_rising: bool,
    /// Nothing gained so far is no reason to stop.
    pub is_patient: bool,
}

/// What follows a round that was judged so.
///
/// What happens while somebody pushes is felt badly: only a calm round shows that the goal is met. Nor is it
/// known where the dirt went that was carried then: the doubt must have been wiped away. But that somebody or
/// something was in the way says nothing against another try.
pub const fn decide(judged: Verdict, circumstances: &Circumstances) -> Verdict {
    let Circumstances {
        is_done,
        is_disturbed,
        is_doubtful,
        is_rising,
        is_patient,
    } = *circumstances;
    match judged {
        Verdict::GoalMet if !is_disturbed && !is_doubtful => Verdict::GoalMet,
        Verdict::GoalMet | Verdict::Again if is_done => Verdict::NothingToGain,
        Verdict::GoalMet if !is_disturbed && !is_rising => Verdict::NoProgress,
        Verdict::GoalMet => Verdict::Again,
        Verdict::NoProgress if is_disturbed || is_patient => Verdict::Again,
        Verdict::NoContact if is_disturbed => Verdict::Again,
        verdict => verdict,
    }
}

/// What is known of a round when it is judged.
#[derive(Debug, Clone, Copy)]
pub struct RoundOutcome<'a> {
    /// What was felt.
    pub interpretation: &'a Interpretation,
    /// Estimated performance before the round [1].
    pub performance_before: f64,
    /// Nothing is believed to lie elsewhere than where it belongs, but for what is lost; see
    /// [`is_done`](super::is_done).
    pub is_done: bool,
    /// The robot stopped itself to protect somebody or something.
    pub is_protective_stop: bool,
}

/// Judges one round after the other: it remembers whether the robot was disturbed before, and for how long nothing
/// was gained.
#[derive(Debug, Clone)]
pub struct RoundJudge {
    target: f64,
    pace: Pace,
    /// In any round so far.
    was_disturbed: bool,
    /// Rounds in a row without progress.
    stalled: usize,
}

impl RoundJudge {
    /// No round so far; `target` is the estimated performance at which the goal is met [1].
    pub const fn new(target: f64, pace: Pace) -> Self {
        Self {
            target,
            pace,
            was_disturbed: false,
            stalled: 0,
        }
    }

    /// Judges the round that has just been interpreted, and remembers it for those to come.
    pub fn verdict(&mut self, outcome: &RoundOutcome<'_>) -> Verdict {
        let interpretation = outcome.interpretation;
        let estimate = &interpretation.performance;
        let judged = judge(interpretation, outcome.performance_before, self.target);
        self.stalled = if judged == Verdict::NoProgress {
            self.stalled + 1
        } else {
            0
        };
        let mut events = interpretation.events.iter();
        let is_pushed = events.any(|event| event.kind.is_by_hand());
        let is_disturbed = outcome.is_protective_stop || is_pushed;
        let circumstances = Circumstances {
            is_done: outcome.is_done,
            is_disturbed,
            is_doubtful: self.was_disturbed && estimate.low < self.target - DOUBT_TOLERATED,
            is_rising: estimate.mean >= outcome.performance_before + LEAST_PROGRESS,
            // A single stroke says little: the next best one is another.
            is_patient: self.pace == Pace::Greedy && self.stalled < STALLED_STROKES,
        };
        self.was_disturbed |= is_disturbed;
        decide(judged, &circumstances)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Point3, Vector3};
    use crate::interpret::{Belief, Estimate, Event, EventKind, FittedPlane};
    use crate::represent::ParticleDistribution;

    #[test]
    fn the_goal_is_claimed_in_calm_only_and_a_push_is_no_reason_to_give_up() {
        let calm = Circumstances {
            is_rising: true,
            ..Circumstances::default()
        };
        let disturbed = Circumstances {
            is_disturbed: true,
            ..calm
        };
        let doubtful = Circumstances {
            is_doubtful: true,
            ..calm
        };
        let done = |circumstances| Circumstances {
            is_done: true,
            ..circumstances
        };
        for (judged, circumstances, expected) in [
            (Verdict::GoalMet, calm, Verdict::GoalMet),
            (Verdict::GoalMet, done(calm), Verdict::GoalMet),
            (Verdict::GoalMet, disturbed, Verdict::Again),
            (Verdict::GoalMet, doubtful, Verdict::Again),
            (Verdict::GoalMet, done(disturbed), Verdict::NothingToGain),
            (Verdict::GoalMet, done(doubtful), Verdict::NothingToGain),
            (Verdict::Again, calm, Verdict::Again),
            (Verdict::Again, done(calm), Verdict::NothingToGain),
            (Verdict::NoProgress, calm, Verdict::NoProgress),
            (Verdict::NoProgress, disturbed, Verdict::Again),
            (Verdict::NoContact, calm, Verdict::NoContact),
            (Verdict::NoContact, disturbed, Verdict::Again),
            (Verdict::NoWay, disturbed, Verdict::NoWay),
        ] {
            assert_eq!(
                decide(judged, &circumstances),
                expected,
                "{circumstances:?}"
            );
        }
        let stalled = Circumstances {
            is_rising: false,
            ..doubtful
        };
        assert_eq!(decide(Verdict::GoalMet, &stalled), Verdict::NoProgress);
        let patient = Circumstances {
            is_patient: true,
            ..calm
        };
        assert_eq!(decide(Verdict::NoProgress, &patient), Verdict::Again);
    }

    /// A round that found a plane, with this estimate, and with a push or without.
    fn felt(mean: f64, low: f64, is_pushed: bool) -> Interpretation {
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
            events: if is_pushed { vec![push] } else { vec![] },
            force_bias: 0.0,
            contact_share: 1.0,
            belief: Belief::certain(ParticleDistribution::default()),
            performance: Estimate {
                mean,
                low,
                high: 1.0,
            },
        }
    }

    /// The verdicts on rounds that were felt so, one after the other.
    fn verdicts(pace: Pace, rounds: &[Interpretation]) -> Vec<Verdict> {
        let mut judge = RoundJudge::new(0.9, pace);
        let mut before = 0.0;
        let verdict = |interpretation| {
            let outcome = RoundOutcome {
                interpretation,
                performance_before: before,
                is_done: false,
                is_protective_stop: false,
            };
            before = interpretation.performance.mean;
            judge.verdict(&outcome)
        };
        rounds.iter().map(verdict).collect()
    }

    #[test]
    fn after_a_push_the_lower_end_of_the_estimate_counts() {
        use Verdict::{Again, GoalMet};
        let pushed = felt(0.5, 0.4, true);
        let [wide, narrow] = [felt(0.95, 0.84, false), felt(0.97, 0.86, false)];
        assert_eq!(
            verdicts(Pace::Whole, std::slice::from_ref(&wide)),
            [GoalMet]
        );
        let rounds = [pushed, wide, narrow];
        assert_eq!(verdicts(Pace::Whole, &rounds), [Again, Again, GoalMet]);
        // The round of the push itself is no evidence.
        assert_eq!(verdicts(Pace::Whole, &[felt(0.95, 0.9, true)]), [Again]);
        let mut judge = RoundJudge::new(0.9, Pace::Whole);
        let stopped = RoundOutcome {
            interpretation: &felt(0.95, 0.9, false),
            performance_before: 0.0,
            is_done: false,
            is_protective_stop: true,
        };
        assert_eq!(judge.verdict(&stopped), Again);
    }

    #[test]
    fn a_single_stroke_may_bring_nothing_and_four_in_a_row_may_not() {
        use Verdict::{Again, NoProgress};
        let still = felt(0.5, 0.4, false);
        let risen = felt(0.6, 0.5, false);
        assert_eq!(
            verdicts(Pace::Whole, &[still.clone(), still.clone()]),
            [Again, NoProgress]
        );
        let mut rounds = vec![still; 4];
        rounds.extend(vec![risen; 5]);
        let mut expected = [Again; 9];
        expected[8] = NoProgress;
        assert_eq!(verdicts(Pace::Greedy, &rounds), expected);
    }
}
