//! From the log of some other robot to the record of an episode.

use super::log::Span;
use super::{
    Happening, Occasion, class_of, describe_felt, describe_stroke, first_during, goal_of, state,
    things_of,
};
use crate::record::{EPISODE_SCHEMA, EpisodeRecord, Individual, Origin};
use wisch::interpret::{Diagnosis, Interpretation};
use wisch::recover::Verdict;
use wisch::represent::{GoalState, Task};

/// Place of the one round in the record.
const ROUND: usize = 3;

/// The record of a log of some other robot: one round, of which only the touch is known.
///
/// `name` is that of the log, `duration` how long it is [s].
pub fn remember_log(
    occasion: &Occasion,
    name: &str,
    duration: f64,
    task: &Task,
    goal: &GoalState,
    told: &Interpretation,
) -> EpisodeRecord {
    let during = [occasion.start, occasion.start + duration];
    let is_met = told.plane.is_some() && told.performance.mean >= occasion.target;
    let verdict = if is_met {
        Verdict::GoalMet
    } else {
        Verdict::Again
    };
    let mut episode = Individual::new("semco:WipingEpisode", None);
    episode.tell("semco:taskName", &task.name);
    episode.set("semco:seed", occasion.seed as f64);
    let mut action = Individual::new("semco:WipingAction", Some(0));
    action.estimate(told);
    action.set("semco:target", occasion.target);
    action.set("semco:rounds", 1.0);
    action.tell("semco:goal", &goal_of(task, goal));
    action.relations = things_of(task);
    action.relate("dul:executesTask", "#2".to_owned());
    action.relate("soma:hasExecutionState", state(verdict));
    let mut round = Individual::new("semco:WipingRound", Some(1));
    describe_felt(&mut round, told);
    round.set("semco:round", 1.0);
    round.relations = things_of(task);
    round.relate("soma:hasExecutionState", state(verdict));
    let mut individuals = vec![
        episode,
        action,
        Individual::new(class_of(task.action), None),
        round,
    ];
    for place in [0, 1, ROUND] {
        individuals[place].interval = Some(during);
    }
    let happening = Happening {
        task,
        told,
        robot: None,
        during,
    };
    let spans = phases(told);
    let first = individuals.len();
    for span in &spans {
        let mut motion = Individual::new(span.class(), Some(ROUND));
        motion.interval = Some([
            during[0] + span.start,
            (during[0] + span.end).min(during[1]),
        ]);
        if let Some(stroke) = span.stroke {
            describe_stroke(&mut motion, stroke, span, told);
        }
        individuals.push(motion);
    }
    for event in &told.events {
        let parent = first_during(&spans, event.start).map_or(ROUND, |place| first + place);
        individuals.extend(happening.of(event, parent));
    }
    if let Diagnosis::Relocalize { .. } = told.diagnosis {
        let mut found = Individual::new("semco:Relocalization", Some(ROUND));
        found.interval = Some([during[1]; 2]);
        individuals.push(found);
    }
    EpisodeRecord {
        schema: EPISODE_SCHEMA,
        id: occasion.id.clone(),
        task: task.name.clone(),
        interval: during,
        origin: Origin::Imported(name.to_owned()),
        program: occasion.program.clone(),
        seed: occasion.seed,
        rounds: vec![occasion.start],
        individuals,
    }
}

/// The motions, as far as touch tells them.
fn phases(told: &Interpretation) -> Vec<Span> {
    let mut strokes = 0;
    let mut spans = Vec::new();
    for event in &told.events {
        let span = Span::of_phase(event, strokes);
        strokes += usize::from(span.as_ref().is_some_and(|span| span.stroke.is_some()));
        spans.extend(span);
    }
    spans
}
