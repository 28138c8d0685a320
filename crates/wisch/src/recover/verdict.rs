//! The verdict on a round: whether the goal is met, and what happens next.

use crate::interpret::{Belief, Diagnosis, Doubt, Interpretation, PerformanceDistribution};
use crate::represent::Task;
use std::fmt;

/// Smallest rise of the estimate that counts as progress \[1\].
pub const MIN_PROGRESS: f64 = 0.005;
/// Number of consecutive strokes without progress after which the next stroke is predicted not to
/// help.
const STALLED_STROKES: usize = 4;
/// Distance of the performance below the target at which a claim is false \[1\].
pub const FALSE_CLAIM_MARGIN: f64 = 0.1;
/// Largest accepted probability of a false claim \[1\].
pub const MAX_FALSE_CLAIM_PROBABILITY: f64 = 0.002;

/// Least probability of a statement that is certain \[1\].
const CERTAIN: f64 = 0.95;

/// Amount of work in one round, before its result is interpreted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Pace {
    /// All strokes, then the interpretation.
    #[default]
    Whole,
    /// One segment of a plan, the one with the largest predicted gain, then the interpretation.
    Greedy,
}

/// The verdict on a round: [`Verdict::Again`] continues the session, all other verdicts end it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// The expected performance reaches the target, a performance far below it is improbable, and contact or a
    /// camera gives evidence for it.
    GoalMet,
    /// Wipe again.
    Again,
    /// Neither the mean of the estimate nor its lower end rises any more.
    NoProgress,
    /// No plan has a predicted gain: the remaining dirt has left the surface, or would leave it; or too many points are
    /// polished more often than the task allows, see [`exceeds_max_passes`].
    NothingToGain,
    /// The robot cannot wipe again: no plan or no motion was found for the surface at its measured pose.
    NoWay,
    /// The motion for the next round fails its audit, and is not executed.
    UnsafeMotion,
    /// The log does not show what was wiped: it has no contact, or its doubts contradict the result. Or an observation
    /// neither shows nor excludes that the goal is met. This is neither success nor failure.
    Undecidable,
    /// Whether the goal is met is undecided: further wiping is predicted to change nothing, and
    /// contact forces cannot decide. For a tool that hovers, they never can.
    UnknowableByTouch,
}

impl Verdict {
    /// The verdict in the words of results and reports, for example "goal met".
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::GoalMet => "goal met",
            Self::Again => "wipe again",
            Self::NoProgress => "no progress",
            Self::NoWay => "no way to wipe again",
            Self::NothingToGain => "nothing to gain",
            Self::UnsafeMotion => "unsafe motion",
            Self::Undecidable => "performance unknown",
            Self::UnknowableByTouch => "undecided by touch",
        }
    }
}

/// Whether the goal may be claimed: the expected performance reaches the target, and a performance more than
/// [`FALSE_CLAIM_MARGIN`] below the target is improbable.
pub fn is_claimable(believed: &PerformanceDistribution, target: f64) -> bool {
    Claim::assess(believed, target).holds()
}

/// The rule by which a goal is claimed, with the decisive numbers.
///
/// ```
/// use wisch::interpret::PerformanceDistribution;
/// use wisch::recover::Claim;
/// let believed = PerformanceDistribution::from_shares([(0.7, 1.0), (0.98, 19.0)], 0.0);
/// let claim = Claim::assess(&believed, 0.95);
/// assert!(!claim.holds());
/// assert_eq!(
///     claim.to_string(),
///     "the expected performance of 96.6 % reaches the target of 95.0 %, but the probability of less than 85.0 % is 5.0 %; a claim allows 0.2 %"
/// );
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Claim {
    expected: f64,
    target: f64,
    /// Probability that the performance is more than [`FALSE_CLAIM_MARGIN`] below the target [1].
    far_below: f64,
}

impl Claim {
    /// Returns the claim for a belief about the performance and a target \[1\].
    pub fn assess(believed: &PerformanceDistribution, target: f64) -> Self {
        Self {
            expected: believed.mean(),
            target,
            far_below: believed.probability_below(target - FALSE_CLAIM_MARGIN),
        }
    }

    /// Whether the goal may be claimed.
    pub fn holds(&self) -> bool {
        self.expected >= self.target && self.far_below <= MAX_FALSE_CLAIM_PROBABILITY
    }
}

impl fmt::Display for Claim {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = |share: f64| format!("{:.1} %", 100.0 * share);
        let [expected, target] = [self.expected, self.target].map(percent);
        if self.expected < self.target {
            return write!(
                f,
                "the expected performance of {expected} is below the target of {target}"
            );
        }
        let tail = percent((self.target - FALSE_CLAIM_MARGIN).max(0.0));
        let allowed = percent(MAX_FALSE_CLAIM_PROBABILITY);
        if self.holds() {
            return write!(
                f,
                "the expected performance of {expected} reaches the target of {target}, and the probability of less than {tail} is at most {allowed}"
            );
        }
        // Never print the allowed probability itself: the value found is larger.
        let found = (1e3 * self.far_below)
            .ceil()
            .max(1e3 * MAX_FALSE_CLAIM_PROBABILITY + 1.0)
            / 10.0;
        write!(
            f,
            "the expected performance of {expected} reaches the target of {target}, but the probability of less than {tail} is {found:.1} %; a claim allows {allowed}"
        )
    }
}

/// Assesses a log without earlier rounds. Returns [`Verdict::GoalMet`], [`Verdict::Undecidable`],
/// [`Verdict::UnknowableByTouch`], or [`Verdict::Again`] where the goal is not met.
pub fn assess_log(interpretation: &Interpretation, target: f64) -> Verdict {
    let is_seen = interpretation.observation.is_some();
    // The missing dirt may have been wiped before the log begins, or after it ends.
    let is_cut = interpretation.is_lower_bound();
    if !interpretation.is_conclusive() {
        Verdict::Undecidable
    } else if is_claimable(&interpretation.distribution, target)
        && (is_seen || interpretation.diagnosis != Diagnosis::Hovering)
    {
        Verdict::GoalMet
    } else if is_cut {
        Verdict::Undecidable
    } else if interpretation.performance.high < target {
        Verdict::Again
    } else if is_seen {
        // Nothing shows that the goal is met, and nothing excludes it.
        Verdict::Undecidable
    } else {
        Verdict::UnknowableByTouch
    }
}

/// Whether the expected share of points that are polished more often than the task allows exceeds 1 − `target`. Then the
/// goal is not shown to be met, and further passes cannot change that.
pub fn exceeds_max_passes(task: &Task, belief: &Belief, target: f64) -> bool {
    let weights = belief.weights().iter().copied();
    (task.treatment)
        .is_some_and(|polish| polish.exceeds_limit(belief.members().iter().zip(weights), target))
}

/// Returns the share of points that are polished more often than the task allows \[1\], if this share certainly exceeds
/// 1 − `target`: the log shows what was polished, and in the belief the probability of such a share is at least
/// 95 %. The share is the mean over the belief.
pub fn find_excess_passes(
    task: &Task,
    interpretation: &Interpretation,
    target: f64,
) -> Option<f64> {
    let (polish, belief) = (task.treatment?, &interpretation.belief);
    let (mut mean, mut probability) = (0.0, 0.0);
    for (places, weight) in belief.members().iter().zip(belief.weights()) {
        mean += weight * polish.share_above_limit(places)?;
        if polish.exceeds_limit([(places, 1.0)], target) {
            probability += weight;
        }
    }
    (interpretation.is_conclusive() && probability >= CERTAIN).then_some(mean)
}

/// Whether too many points may be polished more often than the task allows, although the belief does not expect it: the
/// share of these points is more than [`FALSE_CLAIM_MARGIN`] above 1 − `target` with a probability above
/// [`MAX_FALSE_CLAIM_PROBABILITY`]. So it is after a round whose effect is unknown.
pub fn may_exceed_max_passes(task: &Task, belief: &Belief, target: f64) -> bool {
    let Some(polish) = task.treatment else {
        return false;
    };
    let members = belief.members().iter().zip(belief.weights());
    let far_above = members
        .filter(|(places, _)| polish.exceeds_limit([(*places, 1.0)], target - FALSE_CLAIM_MARGIN));
    far_above.map(|(_, weight)| weight).sum::<f64>() > MAX_FALSE_CLAIM_PROBABILITY
}

/// Whether wiping that the log does not show may have undone the goal: see
/// [`Action::is_lasting`](crate::represent::Action::is_lasting).
pub fn may_be_undone(task: &Task, interpretation: &Interpretation) -> bool {
    // No camera shows how often a point was polished.
    let is_unseen = interpretation.observation.is_none() || task.treatment.is_some();
    is_unseen && !task.action.is_lasting() && interpretation.doubts.iter().any(Doubt::is_cut)
}

/// Returns `verdict`, limited by what the log does not show and by the number of passes over each point, which further rounds
/// cannot lower.
///
/// [`Verdict::GoalMet`] becomes [`Verdict::Undecidable`] if wiping outside the log may have undone the goal
/// ([`may_be_undone`]).
///
/// If too many points are certainly polished too often, as [`find_excess_passes`] states, it is
/// [`Verdict::NothingToGain`] instead of any verdict that leaves the goal open or calls it met. If this is only expected
/// ([`exceeds_max_passes`]) or possible ([`may_exceed_max_passes`]), it is [`Verdict::UnknowableByTouch`] instead of
/// [`Verdict::GoalMet`].
pub fn limit_verdict(
    verdict: Verdict,
    task: &Task,
    interpretation: &Interpretation,
    target: f64,
) -> Verdict {
    let belief = &interpretation.belief;
    match verdict {
        Verdict::NoWay | Verdict::UnsafeMotion => verdict,
        _ if find_excess_passes(task, interpretation, target).is_some() => Verdict::NothingToGain,
        Verdict::GoalMet if may_be_undone(task, interpretation) => Verdict::Undecidable,
        Verdict::GoalMet
            if exceeds_max_passes(task, belief, target)
                || may_exceed_max_passes(task, belief, target) =>
        {
            Verdict::UnknowableByTouch
        }
        _ => verdict,
    }
}

/// Returns what is known about the goal after the last round of a run, which ended with `verdict`:
/// [`Verdict::GoalMet`], [`Verdict::Undecidable`], [`Verdict::UnknowableByTouch`], or `verdict`
/// itself if the goal is missed. `task`: the task of the round.
pub fn assess_goal(
    verdict: Verdict,
    task: &Task,
    interpretation: &Interpretation,
    target: f64,
) -> Verdict {
    if verdict == Verdict::NothingToGain
        && find_excess_passes(task, interpretation, target).is_some()
    {
        return verdict;
    }
    match (verdict, assess_log(interpretation, target)) {
        (Verdict::GoalMet, _) => Verdict::GoalMet,
        (_, Verdict::Undecidable) => Verdict::Undecidable,
        // The estimate reaches the target, but too many points are polished too often.
        (Verdict::NothingToGain, Verdict::GoalMet) => Verdict::NothingToGain,
        (_, Verdict::UnknowableByTouch | Verdict::GoalMet) => Verdict::UnknowableByTouch,
        (ended, _) => ended,
    }
}

/// The data by which the termination policy decides on a round.
#[derive(Debug, Clone, Copy)]
pub struct RoundOutcome<'a> {
    /// Interpretation of the measurements and of the camera's observation.
    pub interpretation: &'a Interpretation,
    /// Expected performance before the round \[1\].
    pub performance_before: f64,
    /// Whether, by the belief, all dirt meets the goal, except for lost dirt; see
    /// [`is_done`](super::is_done).
    pub is_done: bool,
    /// Whether the robot stopped itself to protect a person or an object.
    pub is_protective_stop: bool,
}

impl RoundOutcome<'_> {
    /// Whether a person pushed the robot, or the robot stopped itself.
    fn is_disturbed(&self) -> bool {
        let mut events = self.interpretation.events.iter();
        self.is_protective_stop || events.any(|event| event.kind.is_by_hand())
    }
}

/// The termination policy. It remembers the last lower end of the estimate and the number of rounds
/// without progress.
#[derive(Debug, Clone)]
pub struct TerminationPolicy {
    target: f64,
    pace: Pace,
    /// 5th percentile of the performance after the last round [1].
    low_before: f64,
    /// Number of consecutive rounds without progress.
    stalled: usize,
    /// Whether no round has a verdict so far.
    is_first: bool,
}

impl TerminationPolicy {
    /// Returns the policy before the first round; `target` is the performance at which the goal is met \[1\].
    pub const fn new(target: f64, pace: Pace) -> Self {
        Self {
            target,
            pace,
            low_before: 0.0,
            stalled: 0,
            is_first: true,
        }
    }

    /// Decides about the round that has just been interpreted, and remembers it for later rounds.
    ///
    /// Contact forces are unreliable while a person pushes. Only a round without disturbance, or a
    /// camera, shows that the goal is met. After a disturbance, or a localisation error of the
    /// surface, the robot wipes again.
    pub fn verdict(&mut self, outcome: &RoundOutcome<'_>) -> Verdict {
        let interpretation = outcome.interpretation;
        let is_seen = interpretation.observation.is_some();
        let is_disturbed = outcome.is_disturbed();
        let estimate = &interpretation.performance;
        let is_rising = estimate.mean >= outcome.performance_before + MIN_PROGRESS
            || estimate.low >= self.low_before + MIN_PROGRESS;
        let is_elsewhere = matches!(interpretation.diagnosis, Diagnosis::Relocalize { .. });
        self.low_before = estimate.low;
        let is_hovering = interpretation.diagnosis == Diagnosis::Hovering;
        let is_told = interpretation.is_conclusive();
        let is_felt = is_seen || interpretation.diagnosis != Diagnosis::NoContact;
        if !is_felt && (is_disturbed || self.is_first) {
            self.is_first = false;
            return if is_disturbed {
                Verdict::Again
            } else {
                Verdict::Undecidable
            };
        }
        self.is_first = false;
        let is_shown = is_told && (is_seen || !is_disturbed);
        if is_shown && is_claimable(&interpretation.distribution, self.target) {
            return if is_seen || !is_hovering {
                Verdict::GoalMet
            } else {
                Verdict::UnknowableByTouch
            };
        }
        self.stalled = if is_rising { 0 } else { self.stalled + 1 };
        // A single stroke without progress proves little, because the next stroke is a different one.
        let is_patient = self.pace == Pace::Greedy && self.stalled < STALLED_STROKES;
        let ended = if outcome.is_done {
            Verdict::NothingToGain
        } else if is_rising || is_elsewhere || is_disturbed || is_patient {
            return Verdict::Again;
        } else {
            Verdict::NoProgress
        };
        self.or_undecided(interpretation, ended)
    }

    /// Returns the verdict if no plan has a predicted gain.
    pub fn conclude_without_gain(&self, interpretation: &Interpretation) -> Verdict {
        self.or_undecided(interpretation, Verdict::NothingToGain)
    }

    /// Returns `ended`, or [`Verdict::UnknowableByTouch`] if contact forces cannot decide whether
    /// the goal is met, although a camera could.
    fn or_undecided(&self, interpretation: &Interpretation, ended: Verdict) -> Verdict {
        let is_seen = interpretation.observation.is_some();
        if !interpretation.is_conclusive() {
            Verdict::Undecidable
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

    /// Returns the interpretation of a round that found a plane, with these equally likely performances.
    fn touched_round(shares: &[f64]) -> Interpretation {
        let shares = shares.iter().map(|share| (*share, 1.0));
        let distribution = PerformanceDistribution::from_shares(shares, 0.0);
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
            registration: None,
            residuals: vec![],
            diagnosis: Diagnosis::Localized,
            doubts: vec![],
            events: vec![],
            force_bias: Some(0.0),
            pressed_force: None,
            tool_stiffness: None,
            contact_share: Some(1.0),
            belief: Belief::from_particles(ParticleDistribution::default()),
            performance: distribution.estimate(),
            by_touch: distribution.estimate(),
            observation: None,
            distribution,
        }
    }

    fn pushed(shares: &[f64]) -> Interpretation {
        let push = Event {
            kind: EventKind::Push,
            start: 1.0,
            end: 2.0,
            samples: 1000,
            mean_normal_force: 0.0,
            peak_force: 15.0,
            peak_height: 0.02,
        };
        Interpretation {
            events: vec![push],
            ..touched_round(shares)
        }
    }

    fn seen(interpretation: Interpretation) -> Interpretation {
        Interpretation {
            observation: Some(Observation::default()),
            ..interpretation
        }
    }

    /// Returns the verdicts on consecutive rounds.
    fn verdicts(pace: Pace, is_done: bool, rounds: &[Interpretation]) -> Vec<Verdict> {
        let mut judge = TerminationPolicy::new(TARGET, pace);
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
        assert_eq!(of_one(touched_round(&[0.95; 8])), GoalMet);
        // The expected performance meets the target, but one of eight draws is far below it.
        let mut doubtful = [0.95; 8];
        doubtful[0] = 0.7;
        assert_eq!(of_one(touched_round(&doubtful)), Again);
        doubtful[0] = 0.81;
        assert_eq!(of_one(touched_round(&doubtful)), GoalMet);
        assert_eq!(of_one(touched_round(&[0.89; 8])), Again);
        assert_eq!(of_one(touched_round(&[TARGET; 7])), GoalMet, "exactly");
    }

    #[test]
    fn touch_during_a_push_shows_nothing_and_an_observation_does() {
        use Verdict::{Again, GoalMet, Undecidable};
        let done = [0.95; 8];
        assert_eq!(of_one(pushed(&done)), Again);
        assert_eq!(of_one(seen(pushed(&done))), GoalMet);
        let untouched = |interpretation| Interpretation {
            plane: None,
            diagnosis: Diagnosis::NoContact,
            ..interpretation
        };
        assert_eq!(of_one(untouched(touched_round(&done))), Undecidable);
        assert_eq!(of_one(untouched(pushed(&done))), Again);
        // A later round without contact shows nothing either.
        let rounds = [
            touched_round(&[0.6; 8]),
            untouched(touched_round(&[0.6; 8])),
        ];
        let verdicts = verdicts(Pace::Whole, false, &rounds);
        assert_eq!(verdicts, [Again, Undecidable]);
        assert_eq!(of_one(untouched(seen(touched_round(&done)))), GoalMet);
        let mut judge = TerminationPolicy::new(TARGET, Pace::Whole);
        let stopped = RoundOutcome {
            interpretation: &touched_round(&done),
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
            ..touched_round(shares)
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
        let twice = |shares: &[f64]| [touched_round(shares), touched_round(shares)];
        let of_two = |rounds: &[Interpretation]| verdicts(Pace::Whole, false, rounds);
        assert_eq!(of_two(&twice(&wide)), [Again, UnknowableByTouch]);
        assert_eq!(of_two(&twice(&[0.6; 8])), [Again, NoProgress]);
        assert_eq!(of_two(&twice(&wide).map(seen)), [Again, NoProgress]);
        assert_eq!(of_two(&twice(&wide).map(|_| pushed(&wide))), [Again, Again]);
        let done = |shares| verdicts(Pace::Whole, true, &[touched_round(shares)])[0];
        assert_eq!(done(&[0.6; 8]), NothingToGain);
        assert_eq!(done(&wide), UnknowableByTouch);
        let judge = TerminationPolicy::new(TARGET, Pace::Whole);
        let without_gain = |interpretation| judge.conclude_without_gain(&interpretation);
        assert_eq!(without_gain(touched_round(&[0.6; 8])), NothingToGain);
        assert_eq!(without_gain(touched_round(&wide)), UnknowableByTouch);
        assert_eq!(without_gain(seen(touched_round(&wide))), NothingToGain);
        // A narrower interval is progress.
        let mut surer = wide;
        surer[0] = 0.7;
        assert_eq!(
            of_two(&[touched_round(&wide), touched_round(&surer)]),
            [Again, Again]
        );
    }

    #[test]
    fn a_goal_is_not_met_where_too_many_points_are_polished_too_often() {
        use crate::geometry::{Point2, Polygon, Pose, Vector2};
        use crate::represent::{Action, Fate, Surface, Tool, Treatment};
        let at = |passes| (Point2::origin(), Fate::Treated { passes });
        // One of five points has more passes than the maximum.
        let places = [at(1.0), at(1.0), at(1.0), at(2.0), at(4.0)];
        let places = ParticleDistribution::with_fates(&places).unwrap();
        let outline = Polygon::rectangle(Vector2::new(0.4, 0.3));
        let surface = Surface::new("plate", outline, Pose::identity());
        let pad = Tool::pad("pad", Vector3::new(0.07, 0.11, 0.05)).unwrap();
        let mut task = Task::new(Action::Polish, surface, pad, "paste", places.clone());
        let belief = Belief::from_particles(places);
        let polished = |shares: &[f64]| Interpretation {
            belief: belief.clone(),
            ..touched_round(shares)
        };
        // The estimate alone reaches the target, cannot decide, or does not reach it.
        let [reaching, wide, low] = [0.95, 0.5, 0.2].map(|first| {
            let mut shares = [0.95; 8];
            shares[0] = first;
            polished(if first < 0.5 { &[0.2; 8] } else { &shares })
        });
        let limited =
            |task: &Task, target| limit_verdict(Verdict::GoalMet, task, &reaching, target);
        assert_eq!(limited(&task, TARGET), Verdict::GoalMet, "no treatment");
        task.treatment = Some(Treatment::Polish {
            passes: 1,
            max_passes: 2,
            preston: None,
        });
        assert_eq!(limited(&task, 0.9), Verdict::NothingToGain);
        assert_eq!(limited(&task, 0.8), Verdict::GoalMet);
        // Another round cannot remove passes, whatever the estimate is.
        for estimated in [&reaching, &wide, &low] {
            for verdict in [
                Verdict::Again,
                Verdict::UnknowableByTouch,
                Verdict::NoProgress,
            ] {
                let limited = |target| limit_verdict(verdict, &task, estimated, target);
                assert_eq!(limited(0.9), Verdict::NothingToGain);
                assert_eq!(limited(0.8), verdict);
            }
            let ended = assess_goal(Verdict::NothingToGain, &task, estimated, TARGET);
            assert_eq!(ended, Verdict::NothingToGain);
            let share = find_excess_passes(&task, estimated, 0.9);
            assert_eq!(share, Some(0.2));
        }
        // After a round whose effect is unknown, one of four worlds has too many passes.
        let fine = ParticleDistribution::with_fates(&[at(1.0); 5]).unwrap();
        let many = ParticleDistribution::with_fates(&[at(4.0); 5]).unwrap();
        let open = Interpretation {
            belief: Belief::from_members(vec![fine.clone(), fine.clone(), fine, many]).unwrap(),
            ..reaching.clone()
        };
        for target in [0.6, 0.8] {
            assert_eq!(
                limit_verdict(Verdict::GoalMet, &task, &open, target),
                Verdict::UnknowableByTouch
            );
        }
        // A log that shows nothing does not show too many passes either.
        let doubtful = Interpretation {
            plane: None,
            diagnosis: Diagnosis::NoContact,
            ..reaching.clone()
        };
        assert_eq!(find_excess_passes(&task, &doubtful, 0.9), None);
    }

    #[test]
    fn a_single_stroke_may_bring_nothing_and_four_in_a_row_may_not() {
        use Verdict::{Again, NoProgress};
        let mut rounds = vec![touched_round(&[0.5; 8]); 4];
        rounds.extend(vec![touched_round(&[0.6; 8]); 5]);
        let mut expected = [Again; 9];
        expected[8] = NoProgress;
        assert_eq!(verdicts(Pace::Greedy, false, &rounds), expected);
    }
}
