//! Records of episodes from logs of other robots.

use super::log::Span;
use super::{EpisodeHeader, RoundContext, class_of, describe_touch, goal_of, state_of, things_of};
use crate::record::{EPISODE_SCHEMA, EpisodeRecord, Individual, Origin};
use wisch::interpret::Interpretation;
use wisch::recover::{Verdict, assess_log, limit_verdict};
use wisch::represent::{GoalState, Task};

/// Index of the only round in the record.
const ROUND: usize = 3;

/// Returns the record of another robot's log: one round, of which only poses and forces are known.
///
/// `name` is the name of the log, `duration` its duration \[s\].
///
/// ```
/// use wisch::interpret::{Belief, InterpretConfig, TouchSample, interpret};
/// use wisch_memory::{EpisodeHeader, remember_log};
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
/// let header = EpisodeHeader::new(1_795_309_772.5, &task, 0.95, "my program 1.0");
/// let record = remember_log(&header, "log.csv", 1.0, &task, &goal, &estimate);
/// assert_eq!(record.rounds.len(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn remember_log(
    header: &EpisodeHeader,
    name: &str,
    duration: f64,
    task: &Task,
    goal: &GoalState,
    interpretation: &Interpretation,
) -> EpisodeRecord {
    let during = [header.start, header.start + duration];
    let verdict = assess_log(interpretation, header.target);
    let verdict = limit_verdict(verdict, task, interpretation, header.target);
    let mut episode = Individual::new("semco:WipingEpisode", None);
    episode.set_text("semco:taskName", &task.name);
    episode.set_number("semco:seed", header.seed as f64);
    let mut action = Individual::new("semco:WipingAction", Some(0));
    action.estimate(interpretation, task.action);
    action.set_text("semco:verdict", verdict_text(verdict));
    action.set_number("semco:target", header.target);
    action.set_number("semco:rounds", 1.0);
    action.set_text("semco:goal", &goal_of(task, goal));
    action.relations = things_of(task);
    action.relate("dul:executesTask", "#2".to_owned());
    action.end_in(state_of(verdict));
    let mut round = Individual::new("semco:WipingRound", Some(1));
    describe_touch(&mut round, task, interpretation);
    round.set_number("semco:round", 1.0);
    round.relations = things_of(task);
    round.set_text("semco:verdict", verdict_text(verdict));
    round.end_in(state_of(verdict));
    let mut individuals = vec![
        episode,
        action,
        Individual::new(class_of(task.action), None),
        round,
    ];
    for place in [0, 1, ROUND] {
        individuals[place].interval = Some(during);
    }
    let context = RoundContext {
        task,
        interpretation,
        robot: None,
        warnings: &[],
        during,
        stopped: None,
    };
    context.add_parts(&mut individuals, ROUND, &phases(interpretation));
    EpisodeRecord {
        schema: EPISODE_SCHEMA,
        id: header.id.clone(),
        task: task.name.clone(),
        interval: during,
        origin: Origin::Imported(name.to_owned()),
        program: header.program.clone(),
        seed: header.seed,
        rounds: vec![header.start],
        individuals,
    }
}

/// Describes the verdict on a log, for which no further round follows.
const fn verdict_text(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Again => "goal not met",
        _ => verdict.as_str(),
    }
}

/// Returns the motions that contact reveals.
fn phases(interpretation: &Interpretation) -> Vec<Span> {
    let mut strokes = 0;
    let mut spans = Vec::new();
    for event in &interpretation.events {
        let span = Span::of_phase(event, strokes);
        strokes += usize::from(span.as_ref().is_some_and(|span| span.stroke.is_some()));
        spans.extend(span);
    }
    spans
}
