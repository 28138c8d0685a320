//! What to wipe again: from an interpretation to the next task; paper §4.3.

use crate::geometry::Pose;
use crate::interpret::{Belief, Diagnosis, Interpretation};
use crate::represent::{
    Fate, GoalState, ParticleDistribution, ParticleError, ScenePart, Surface, Task,
};

/// An estimate that rises by less than this is no progress [1].
pub const LEAST_PROGRESS: f64 = 0.005;

/// How far a round is executed before its outcome is looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Pace {
    /// All strokes, then the interpretation.
    #[default]
    Whole,
    /// One segment of a plan, that which is predicted to gain most, then the interpretation.
    Greedy,
}

/// What follows from an interpretation.
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
    /// In words.
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

/// The task of the next round: the surface where it was found to be, and the dirt as it is believed to lie
/// now, one draw from the ensemble.
///
/// # Errors
/// If the belief holds positions that are none.
pub fn next_task(
    task: &Task,
    goal: &GoalState,
    interpretation: &Interpretation,
    seed: u64,
) -> Result<Task, ParticleError> {
    let mut next = match interpretation.diagnosis {
        Diagnosis::Relocalize { world_from_surface } => relocalized(task, world_from_surface),
        Diagnosis::Localized | Diagnosis::NoContact => task.clone(),
    };
    if let GoalState::Collected { center, .. } = goal {
        next.collect_goal = Some(*center);
    }
    next.particles = interpretation.belief.sample(seed)?;
    next.seed = seed;
    Ok(next)
}

/// The task with its surface elsewhere, and with it everything round it: what was mislocated is the robot
/// before the scene.
pub fn relocalized(task: &Task, world_from_surface: Pose) -> Task {
    let moved = world_from_surface * task.surface.world_from_surface.inverse();
    let mut next = task.clone();
    next.surface.world_from_surface = world_from_surface;
    for object in &mut next.scene {
        if matches!(object.part, ScenePart::Carrier | ScenePart::Obstacle) {
            object.world_from_object = moved * object.world_from_object;
        }
    }
    next
}

/// The task with only the dirt that is not yet where it belongs, to be planned on: what has been collected
/// is not to attract another stroke.
///
/// # Errors
/// If a position is none.
pub fn unfinished(task: &Task, goal: &GoalState) -> Result<ParticleDistribution, ParticleError> {
    let open: Vec<_> = (task.particles.iter())
        .filter(|(position, fate)| {
            *fate == Fate::OnSurface && !goal.is_met_by(*position, *fate, &task.surface)
        })
        .collect();
    ParticleDistribution::with_fates(&open)
}

/// Mean share of the particles that a belief has where the goal wants them.
pub fn believed_performance(belief: &Belief, goal: &GoalState, surface: &Surface) -> f64 {
    belief.performance(goal, surface).mean
}

#[cfg(test)]
mod tests {
    use super::*;

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
}
