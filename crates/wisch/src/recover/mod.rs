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
    /// The surface was not felt: nothing is known of the effect.
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
