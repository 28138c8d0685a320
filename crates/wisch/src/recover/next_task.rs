//! The task of the next round, and the dirt for which its plan is made.

use crate::geometry::{Point2, Pose, Region};
use crate::interpret::{Belief, Diagnosis, Interpretation};
use crate::represent::{
    Fate, GoalState, ParticleDistribution, ParticleError, ScenePart, Surface, Task,
};

/// Number of draws from the belief for which later rounds are planned, by [`Belief::draw_mixture`] with the seed of
/// the task.
pub const PLANNING_DRAWS: usize = 8;
/// Largest and smallest number of plans that are tried for remaining dirt. The density of a few
/// scattered grains says little, so the prediction is the best criterion.
const RECOVERY_CANDIDATES: [usize; 2] = [50, 3];
/// Budget of prediction work: edges of the tool's footprint times plans.
const RECOVERY_EDGES: usize = 2000;

/// Returns the task of the next round: the surface at its estimated pose, and the dirt at its estimated places,
/// one draw from the ensemble.
///
/// ```
/// use wisch::interpret::{Belief, InterpretConfig, TouchSample, interpret};
/// use wisch::recover::next_task;
/// # use wisch::prelude::*;
/// # let outline = Polygon::rectangle(Vector2::new(0.4, 0.3));
/// # let surface = Surface::new("tray", outline, Pose::translation(0.5, 0.0, 0.8));
/// # let sponge = Tool::pad("sponge", Vector3::new(0.07, 0.11, 0.05))?;
/// # let crumbs = ParticleDistribution::new(&[Point2::new(-0.1, 0.05), Point2::new(0.12, 0.1)])?;
/// # let task = Task::new(Action::Absorb, surface, sponge, "crumbs", crumbs);
/// // A second in contact along the middle of the tray.
/// let touches: Vec<TouchSample> = (0..100)
///     .map(|i| {
///         let tool = task.surface.world_from_surface * Pose::translation(2e-3 * f64::from(i) - 0.1, 0.05, 0.0);
///         TouchSample::new(0.01 * f64::from(i), tool, task.surface_reaction())
///     })
///     .collect();
/// let goal = task.goal().ok_or("the goal is open")?;
/// let believed = Belief::from_particles(task.particles.clone());
/// let config = InterpretConfig::from_task(&task);
/// let estimate = interpret(&touches, &task, &believed, &goal, &config)?;
/// let next = next_task(&task, &goal, &estimate, task.seed + 1)?;
/// assert_eq!(next.action, task.action);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ParticleError::NotFinite`] if the belief holds a position that is not finite.
pub fn next_task(
    task: &Task,
    goal: &GoalState,
    interpretation: &Interpretation,
    seed: u64,
) -> Result<Task, ParticleError> {
    let mut next = match interpretation.diagnosis {
        Diagnosis::Relocalize { world_from_surface } => relocate(task, world_from_surface),
        Diagnosis::Localized | Diagnosis::NoContact | Diagnosis::Unfitted | Diagnosis::Hovering => {
            task.clone()
        }
    };
    if let GoalState::Collected { center, .. } = goal {
        next.collect_goal = Some(*center);
    }
    next.particles = interpretation.belief.sample(seed)?;
    next.seed = seed;
    Ok(next)
}

/// Returns the task with its surface at another pose. The object that carries the surface and the
/// obstacles move with it, because a localisation error is an error of the robot's pose relative to
/// the scene.
pub fn relocate(task: &Task, world_from_surface: Pose) -> Task {
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

/// Returns the dirt to plan for: only the dirt that does not yet meet the goal, so that collected
/// dirt attracts no further stroke.
///
/// # Errors
/// [`ParticleError::NotFinite`] for a position that is not finite.
pub fn remaining_dirt(
    task: &Task,
    goal: &GoalState,
) -> Result<ParticleDistribution, ParticleError> {
    let open: Vec<_> = remaining_particles(&task.particles, goal, &task.surface).collect();
    ParticleDistribution::with_fates(&open)
}

/// Returns the particles on the surface that do not meet the goal.
fn remaining_particles<'a>(
    particles: &'a ParticleDistribution,
    goal: &'a GoalState,
    surface: &'a Surface,
) -> impl Iterator<Item = (Point2, Fate)> + 'a {
    particles.iter().filter(|(position, fate)| {
        fate.is_on_surface() && !goal.is_met_by(*position, *fate, surface)
    })
}

/// Whether, by the belief, all dirt meets the goal, except for lost dirt. With the seed of the next
/// task it uses the same draws as the plan. For an action that treats the surface, it uses the
/// median number of passes of each place.
///
/// # Errors
/// [`ParticleError::NotFinite`] if the belief holds a position that is not finite.
pub fn is_done(
    belief: &Belief,
    goal: &GoalState,
    surface: &Surface,
    seed: u64,
) -> Result<bool, ParticleError> {
    let treats = matches!(
        goal,
        GoalState::Polished { .. } | GoalState::Dispensed { .. }
    );
    let median = treats.then(|| belief.median_passes()).flatten();
    let draws = match median {
        Some(places) => places,
        None => belief.draw_mixture(PLANNING_DRAWS, seed)?,
    };
    Ok(remaining_particles(&draws, goal, surface).next().is_none())
}

/// Number of candidate plans for remaining dirt. Prediction time grows with the edges of the tool's footprint,
/// so a brush of a thousand tufts gets few plans.
pub fn recovery_candidate_count(footprint: &Region) -> usize {
    let [most, least] = RECOVERY_CANDIDATES;
    let edges = footprint.edges().count().max(1);
    (RECOVERY_EDGES / edges).clamp(least, most)
}

/// Expected share of the particles that meet the goal under a belief \[1\].
pub fn expected_performance(belief: &Belief, goal: &GoalState, surface: &Surface) -> f64 {
    belief.performance(goal, surface, 0.0).mean()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Polygon, Vector2};

    #[test]
    fn it_is_done_where_no_replay_has_anything_left_but_what_is_lost() {
        let board = Surface {
            name: "board".into(),
            outline: Polygon::rectangle(Vector2::new(0.4, 0.4)),
            world_from_surface: Pose::identity(),
            skim_edges: vec![],
            shape: Default::default(),
        };
        let goal = GoalState::Collected {
            center: Point2::origin(),
            radius: 0.05,
        };
        let replay = |x: f64, fate: Fate| {
            let collected = (Point2::origin(), Fate::OnSurface);
            ParticleDistribution::with_fates(&[collected, (Point2::new(x, 0.0), fate)]).unwrap()
        };
        let lost = replay(0.3, Fate::OffSurface { edge: 1 });
        let near = replay(0.04, Fate::OnSurface);
        let far = replay(0.1, Fate::OnSurface);
        for (replays, expected) in [
            (vec![lost.clone()], true),
            (vec![near.clone(), lost.clone()], true),
            (vec![far.clone()], false),
            // Eight draws of either order contain the replay that has dirt left.
            (vec![near, far], false),
        ] {
            let belief = Belief::from_members(replays).unwrap();
            let found = is_done(&belief, &goal, &board, 1).unwrap();
            assert_eq!(found, expected, "{belief:?}");
        }
    }

    #[test]
    fn a_tool_of_many_edges_tries_few_plans_and_a_sponge_many() {
        let tufts =
            |count: usize| Region::new(vec![Polygon::rectangle(Vector2::new(0.01, 0.01)); count]);
        assert_eq!(recovery_candidate_count(&tufts(1)), 50);
        assert_eq!(recovery_candidate_count(&tufts(50)), 10);
        assert_eq!(recovery_candidate_count(&tufts(1000)), 3);
    }
}
