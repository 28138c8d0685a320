//! Record of a run for a goal of several parts: its steps, and the parts that they serve.

use super::{EpisodeHeader, FAILED, SUCCEEDED, shared_name};
use crate::record::{EPISODE_SCHEMA, EpisodeRecord, GOAL_EPISODE, Individual, Origin};

/// Kind of a step towards a goal of several parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StepKind {
    /// A wiping action.
    Wipe,
    /// The robot fetches a tool.
    Fetch,
    /// The robot puts its tool back.
    PutBack,
    /// The robot empties its tool.
    Empty,
    /// Another action of the domain.
    Other,
}

/// Whether a goal, or a part of it, is met as far as is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GoalOutcome {
    /// It is met.
    Met,
    /// It is not met.
    NotMet,
    /// Nothing shows whether it is met.
    Unknown,
}

/// A step that a run has taken.
#[derive(Debug, Clone, PartialEq)]
pub struct RememberedStep {
    /// What the robot does.
    pub kind: StepKind,
    /// The step in words, such as `collect breadcrumbs on table with brush`.
    pub words: String,
    /// Names of tool, medium and surface, as far as the step has them.
    pub things: [Option<String>; 3],
    /// Begin after the first step began, expected duration, and duration \[s\], in the robot's time.
    pub times: [f64; 3],
    /// Whether the goal of a wiping step is met; `None` for other steps.
    pub is_met: Option<GoalOutcome>,
    /// Indices of the parts of the goal that it serves.
    pub serves: Vec<usize>,
    /// Name of the episode of a wiping step, if the memory keeps one.
    pub episode: Option<String>,
}

/// A part of a goal after the last step.
#[derive(Debug, Clone, PartialEq)]
pub struct RememberedPart {
    /// The part in PDDL, such as `(collected breadcrumbs table)`.
    pub part: String,
    /// Whether it holds after the last step.
    pub outcome: GoalOutcome,
    /// Why it does not hold, if that is known.
    pub why: Option<String>,
}

/// A run for a goal of several parts.
#[derive(Debug, Clone, PartialEq)]
pub struct RememberedGoal {
    /// The goal in PDDL.
    pub goal: String,
    /// Name of the robot, if known.
    pub robot: Option<String>,
    /// Expected time of the sequence that was planned before the first step \[s\].
    pub expected: f64,
    /// Duration of the program by the clock of its machine \[s\].
    pub clock_duration: f64,
    /// The parts of the goal.
    pub parts: Vec<RememberedPart>,
    /// The steps, in order.
    pub steps: Vec<RememberedStep>,
}

impl RememberedGoal {
    /// Whether all parts are met.
    fn outcome(&self) -> GoalOutcome {
        let has = |outcome| self.parts.iter().any(|part| part.outcome == outcome);
        match (has(GoalOutcome::NotMet), has(GoalOutcome::Unknown)) {
            (true, _) => GoalOutcome::NotMet,
            (false, true) => GoalOutcome::Unknown,
            (false, false) => GoalOutcome::Met,
        }
    }

    /// Duration of all steps in the robot's time [s].
    fn taken(&self) -> f64 {
        (self.steps.last()).map_or(0.0, |step| step.times[0] + step.times[2])
    }
}

/// Returns the record of a run for a goal of several parts: an action whose parts are the steps, and the parts of the goal.
///
/// The episode begins when the run began. From there, steps follow each other without pauses: times are the robot's, not the
/// computer's. The episode has no rounds; those of its wiping steps are in episodes of their own. The target of `header` is
/// not used, because each wiping step has its own.
pub fn remember_goal(header: &EpisodeHeader, goal: &RememberedGoal) -> EpisodeRecord {
    let interval = [header.start, header.start + goal.taken()];
    let performer = goal.robot.as_deref().map(shared_name);
    let mut episode = Individual::new(GOAL_EPISODE, None);
    episode.interval = Some(interval);
    episode.set_text("semco:taskName", &header.task);
    episode.set_number("semco:seed", header.seed as f64);
    episode.set_number("semco:clockBegin", header.start);
    episode.set_number("semco:clockDuration", goal.clock_duration);
    let mut action = Individual::new("semco:GoalAction", Some(0));
    action.interval = Some(interval);
    action.set_text("semco:goal", &goal.goal);
    action.set_number("semco:expectedTime", goal.expected);
    action.set_number("semco:takenTime", goal.taken());
    action.end_in(execution_state(goal.outcome()));
    if let Some(name) = &performer {
        action.relate("soma:isPerformedBy", name.clone());
    }
    // The parts follow the episode and its action.
    let place = |part: usize| format!("#{}", part + 2);
    for part in 0..goal.parts.len() {
        action.relate("semco:hasGoalPart", place(part));
    }
    let mut individuals = vec![episode, action];
    individuals.extend(goal.parts.iter().map(describe_part));
    for (step, number) in goal.steps.iter().zip(1_u32..) {
        let mut individual = describe_step(step, number, interval);
        for &part in step.serves.iter().filter(|part| **part < goal.parts.len()) {
            individual.relate("semco:servesPart", place(part));
        }
        if let Some(name) = &performer {
            individual.relate("soma:isPerformedBy", name.clone());
        }
        individuals.push(individual);
    }
    EpisodeRecord {
        schema: EPISODE_SCHEMA,
        id: header.id.clone(),
        task: header.task.clone(),
        interval,
        origin: Origin::Simulated,
        program: header.program.clone(),
        seed: header.seed,
        rounds: Vec::new(),
        individuals,
    }
}

fn describe_part(part: &RememberedPart) -> Individual {
    let mut individual = Individual::new("semco:GoalPart", None);
    individual.set_text("semco:goal", &part.part);
    let state = match part.outcome {
        GoalOutcome::Met => "holds",
        GoalOutcome::NotMet => "open",
        GoalOutcome::Unknown => "unknown",
    };
    individual.set_text("semco:partState", state);
    if let Some(why) = &part.why {
        individual.set_text("semco:openReason", why);
    }
    individual
}

fn describe_step(step: &RememberedStep, number: u32, [start, end]: [f64; 2]) -> Individual {
    let class = match step.kind {
        StepKind::Wipe => "semco:WipingStep",
        StepKind::Fetch => "semco:FetchingStep",
        StepKind::PutBack => "semco:PuttingBackStep",
        StepKind::Empty => "semco:EmptyingStep",
        StepKind::Other => "semco:GoalStep",
    };
    let [began, expected, taken] = step.times;
    let mut individual = Individual::new(class, Some(1));
    // Rounding must not let a part outlast the whole.
    let from = (start + began).min(end);
    individual.interval = Some([from, (from + taken).min(end)]);
    individual.set_number("semco:step", f64::from(number));
    individual.set_text("semco:words", &step.words);
    individual.set_number("semco:expectedTime", expected);
    individual.set_number("semco:takenTime", taken);
    let roles = [
        "semco:usesTool",
        "semco:removesMedium",
        "semco:actsOnSurface",
    ];
    for (role, name) in roles.into_iter().zip(&step.things) {
        if let Some(name) = name {
            individual.relate(role, shared_name(name));
        }
    }
    individual.end_in(step.is_met.and_then(execution_state));
    if let Some(episode) = &step.episode {
        individual.set_text("semco:stepEpisode", episode);
    }
    individual
}

const fn execution_state(outcome: GoalOutcome) -> Option<&'static str> {
    match outcome {
        GoalOutcome::Met => Some(SUCCEEDED),
        GoalOutcome::NotMet => Some(FAILED),
        GoalOutcome::Unknown => None,
    }
}
