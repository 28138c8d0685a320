//! From rounds of wiping to the record of an episode.

mod log;
mod logged;

pub use log::RoundLog;
pub use logged::remember_log;

use crate::id::episode_id;
use crate::record::{EPISODE_SCHEMA, EpisodeRecord, Individual, Origin, Value};
use log::Span;
use std::collections::BTreeMap;
use wisch::geometry::{Point2, Polygon};
use wisch::interpret::{Diagnosis, Event, EventKind, Interpretation, PathPiece, Touch};
use wisch::recover::Verdict;
use wisch::represent::{Action, GoalState, Task};
use wisch::run::{Ending, PlannedRound};

/// What an episode is besides its rounds.
#[derive(Debug, Clone, PartialEq)]
pub struct EpisodeHeader {
    /// Its name, as [`episode_id`](crate::episode_id) makes them.
    pub id: String,
    /// When it began [s since 1970].
    pub start: f64,
    /// Estimated performance at which the goal was to count as met.
    pub target: f64,
    /// Seed of the run.
    pub seed: u64,
    /// Program and version.
    pub program: String,
}

impl EpisodeHeader {
    /// Of an episode that began at a time [s since 1970], from which it has its name.
    pub fn new(start: f64, target: f64, seed: u64, program: &str) -> Self {
        Self {
            id: episode_id(start, 0),
            start,
            target,
            seed,
            program: program.to_owned(),
        }
    }
}

/// What an episode holds of a round.
#[derive(Debug, Clone)]
pub struct EpisodeRound<'a> {
    /// What was to be done: task, plan and motion.
    pub motion: &'a PlannedRound,
    /// Which motions were when, as seen while they were executed.
    pub log: &'a RoundLog,
    /// How long the execution took, in the robot's time [s].
    pub duration: f64,
    /// How it ended.
    pub ending: &'a Ending,
    /// What was inferred from touch.
    pub interpretation: &'a Interpretation,
    /// What follows from it.
    pub verdict: Verdict,
    /// Performance as a simulated world knows it; `None` of a real one.
    pub simulated_performance: Option<f64>,
}

/// The record of an episode: what was done in each round, what was felt, and how well it went.
///
/// One round follows the other without a pause: their times are those of the robot, not of who computes.
pub fn remember(header: &EpisodeHeader, rounds: &[EpisodeRound<'_>]) -> EpisodeRecord {
    let mut record = RecordBuilder {
        individuals: Vec::new(),
        time: header.start,
        starts: Vec::new(),
    };
    let task = rounds.first().map(|round| &round.motion.task);
    let name = task.map_or_else(String::new, |task| task.name.clone());
    record.add("semco:WipingEpisode", None);
    if let (Some(first), Some(last)) = (rounds.first(), rounds.last()) {
        let action = record.add("semco:WipingAction", Some(0));
        record.add(class_of(first.motion.task.action), None);
        for round in rounds {
            record.round(action, round);
        }
        let interval = [header.start, record.time];
        let individual = &mut record.individuals[action];
        individual.interval = Some(interval);
        individual.values = action_values(header, first, last, rounds.len());
        individual.relations = participants(first);
        individual.relate("dul:executesTask", "#2".to_owned());
        individual.end_in(state(last.verdict));
    }
    let interval = [header.start, record.time];
    let episode = &mut record.individuals[0];
    episode.interval = Some(interval);
    episode.set_text("semco:taskName", &name);
    episode.set_number("semco:seed", header.seed as f64);
    EpisodeRecord {
        schema: EPISODE_SCHEMA,
        id: header.id.clone(),
        task: name,
        interval,
        origin: Origin::Simulated,
        program: header.program.clone(),
        seed: header.seed,
        rounds: record.starts,
        individuals: record.individuals,
    }
}

const fn class_of(action: Action) -> &'static str {
    match action {
        Action::Absorb => "semco:Absorbing",
        Action::Collect => "semco:Collecting",
        Action::Skim => "semco:Skimming",
        Action::Polish => "semco:Polishing",
        Action::Emit => "semco:Painting",
    }
}

fn action_values(
    header: &EpisodeHeader,
    first: &EpisodeRound<'_>,
    last: &EpisodeRound<'_>,
    rounds: usize,
) -> BTreeMap<String, Value> {
    let mut about = Individual::new("semco:WipingAction", None);
    about.estimate(last.interpretation);
    if let Some(truth) = last.simulated_performance {
        about.set_number("semco:simulatedPerformance", truth);
    }
    about.set_number(
        "semco:predictedPerformance",
        first.motion.prediction.performance.ratio(),
    );
    about.set_number("semco:target", header.target);
    about.set_number("semco:rounds", rounds as f64);
    about.set_text("semco:strategy", first.motion.plan.strategy.as_str());
    let goal = &first.motion.plan.graph.goal;
    about.set_text("semco:goal", &goal_of(&first.motion.task, goal));
    about.values
}

/// The goal as PDDL says it.
fn goal_of(task: &Task, goal: &GoalState) -> String {
    let predicate = match goal {
        GoalState::Absorbed => "absorbed",
        GoalState::Collected { .. } => "collected",
        GoalState::Skimmed => "skimmed",
        GoalState::Polished { .. } => "polished",
        GoalState::Emitted { .. } => "emitted",
    };
    format!("({predicate} {} {})", task.medium, task.surface.name)
}

/// The record in the making.
struct RecordBuilder {
    individuals: Vec<Individual>,
    /// The robot's time [s since 1970].
    time: f64,
    starts: Vec<f64>,
}

impl RecordBuilder {
    fn add(&mut self, class: &str, parent: Option<usize>) -> usize {
        self.individuals.push(Individual::new(class, parent));
        self.individuals.len() - 1
    }

    fn round(&mut self, action: usize, round: &EpisodeRound<'_>) {
        let start = self.time;
        let end = start + round.duration;
        self.starts.push(start);
        self.time = end;
        let number = self.add("semco:WipingRound", Some(action));
        let individual = &mut self.individuals[number];
        individual.interval = Some([start, end]);
        describe(individual, round);
        let context = RoundContext {
            task: &round.motion.task,
            interpretation: round.interpretation,
            robot: Some(round.motion.cell.robot().name()),
            during: [start, end],
            stopped: match round.ending {
                Ending::ProtectiveStop { time, .. } => Some(*time),
                Ending::Complete | Ending::Stopped | Ending::Early { .. } => None,
            },
        };
        context.add_parts(&mut self.individuals, number, &round.log.spans());
    }
}

/// What is said of a round.
fn describe(individual: &mut Individual, round: &EpisodeRound<'_>) {
    let motion = &round.motion;
    describe_touch(individual, round.interpretation);
    individual.set_number("semco:round", motion.number as f64);
    individual.set_number("semco:strokes", motion.followed.strokes.len() as f64);
    individual.set_number(
        "semco:predictedPerformance",
        motion.prediction.performance.ratio(),
    );
    if let Some(truth) = round.simulated_performance {
        individual.set_number("semco:simulatedPerformance", truth);
    }
    individual.set_text("semco:verdict", round.verdict.as_str());
    individual.set_text("semco:ending", round.ending.as_str());
    individual.relations = participants(round);
    individual.end_in(state(round.verdict));
}

/// What the touch of a round tells.
fn describe_touch(individual: &mut Individual, interpretation: &Interpretation) {
    individual.estimate(interpretation);
    individual.set_number("semco:contactShare", interpretation.contact_share);
    individual.set_number("semco:forceBias", interpretation.force_bias);
    let ContactStatistics { mean_force, .. } = ContactStatistics::of(interpretation.path.iter());
    if let Some(force) = mean_force {
        individual.set_number("semco:meanNormalForce", force);
    }
    if let Some(plane) = &interpretation.plane {
        individual.set_number("semco:planeTilt", plane.tilt);
        individual.set_number("semco:planeOffset", plane.offset);
    }
    if let Some(stiffness) = &interpretation.tool_stiffness {
        individual.set_number("semco:toolStiffness", stiffness.n_per_m);
        individual.set_number("semco:toolStiffnessDeviation", stiffness.ln_deviation);
    }
    if !interpretation.doubts.is_empty() {
        let doubts: Vec<String> = (interpretation.doubts.iter())
            .map(ToString::to_string)
            .collect();
        individual.set_text("semco:doubt", &doubts.join("; "));
    }
    individual.set_text(
        "semco:diagnosis",
        match interpretation.diagnosis {
            Diagnosis::Localized => "localized",
            Diagnosis::Relocalize { .. } => "relocalize",
            Diagnosis::NoContact => "no contact",
            Diagnosis::Hovering => "hovering",
        },
    );
}

fn describe_stroke(
    individual: &mut Individual,
    stroke: usize,
    span: &Span,
    interpretation: &Interpretation,
) {
    let during = interpretation.path.iter().filter(|piece| {
        let middle = 0.5 * (piece.time[0] + piece.time[1]);
        (span.start..span.end).contains(&middle)
    });
    let felt = ContactStatistics::of(during);
    individual.set_number("semco:stroke", stroke as f64);
    individual.set_number("semco:peakForce", span.peak_force);
    if let Some(share) = felt.contact_share {
        individual.set_number("semco:contactShare", share);
    }
    if let Some(force) = felt.mean_force {
        individual.set_number("semco:meanNormalForce", force);
    }
}

/// What was felt over some pieces of the path, each as long as it lasts.
struct ContactStatistics {
    /// Share of the time in contact, if there is any time.
    contact_share: Option<f64>,
    /// Mean normal force over contact [N], if there is any.
    mean_force: Option<f64>,
}

impl ContactStatistics {
    fn of<'a>(pieces: impl Iterator<Item = &'a PathPiece>) -> Self {
        let [mut all, mut contact, mut impulse] = [0.0; 3];
        for piece in pieces {
            let duration = piece.time[1] - piece.time[0];
            all += duration;
            if matches!(piece.touch, Touch::Weak | Touch::Confident) {
                contact += duration;
                impulse += duration * piece.normal_force;
            }
        }
        Self {
            contact_share: (all > 0.0).then(|| contact / all),
            mean_force: (contact > 0.0).then(|| impulse / contact),
        }
    }
}

/// What is to be known of a round to say what happened in it.
struct RoundContext<'a> {
    task: &'a Task,
    interpretation: &'a Interpretation,
    /// The robot's name, if it is known.
    robot: Option<&'a str>,
    /// When the round began and ended [s since 1970].
    during: [f64; 2],
    /// When the robot stopped itself [s since the round began], if it did.
    stopped: Option<f64>,
}

impl RoundContext<'_> {
    /// Adds the parts of the round that stands at this place: its motions, and what happened during them.
    fn add_parts(&self, individuals: &mut Vec<Individual>, round: usize, spans: &[Span]) {
        let [start, end] = self.during;
        let first = individuals.len();
        for span in spans {
            let mut motion = Individual::new(span.class(), Some(round));
            // Rounding must not let a part outlast the whole.
            motion.interval = Some([start + span.start, (start + span.end).min(end)]);
            if let Some(stroke) = span.stroke {
                describe_stroke(&mut motion, stroke, span, self.interpretation);
            }
            individuals.push(motion);
        }
        let parent_at = |time: f64| {
            let during = |span: &Span| span.start <= time && time < span.end;
            spans
                .iter()
                .position(during)
                .map_or(round, |place| first + place)
        };
        for event in &self.interpretation.events {
            individuals.extend(self.of(event, parent_at(event.start)));
        }
        let mut add_moment = |class, parent, at| {
            let mut moment = Individual::new(class, Some(parent));
            moment.interval = Some([at, at]);
            individuals.push(moment);
        };
        if let Some(time) = self.stopped {
            let at = (start + time).min(end);
            add_moment("semco:ProtectiveStop", parent_at(time), at);
        }
        if let Diagnosis::Relocalize { .. } = self.interpretation.diagnosis {
            add_moment("semco:Relocalization", round, end);
        }
    }

    /// `None` of what the robot itself was about, which its motions tell.
    fn of(&self, event: &Event, parent: usize) -> Option<Individual> {
        let class = match event.kind {
            EventKind::Contact => "semco:ToolContact",
            EventKind::ContactLoss => "semco:ContactLoss",
            EventKind::Collision => "semco:HumanCollision",
            EventKind::HandGuiding => "semco:HandGuiding",
            EventKind::Landing => "semco:Landing",
            EventKind::Overload => "semco:Overload",
            EventKind::Vibration => "semco:Vibration",
            EventKind::StickSlip => "semco:StickSlip",
            EventKind::Approach | EventKind::Stroke | EventKind::Lift | EventKind::Retreat => {
                return None;
            }
        };
        let [start, end] = self.during;
        let mut individual = Individual::new(class, Some(parent));
        // Rounding must not let a part outlast the whole.
        let from = (start + event.start).min(end);
        individual.interval = Some([from, (start + event.end).min(end).max(from)]);
        individual.set_number("semco:samples", event.samples as f64);
        individual.set_number("semco:meanNormalForce", event.mean_normal_force);
        individual.set_number("semco:peakForce", event.peak_force);
        individual.set_number("semco:peakHeight", event.peak_height);
        let path = &self.interpretation.path;
        let at = path.partition_point(|piece| piece.time[1] < event.start);
        if let Some(piece) = path.get(at).or(path.last()) {
            let point = Point2::new(piece.position.x, piece.position.y);
            let outline = &self.task.surface.outline;
            individual.set_number("semco:edgeDistance", edge_distance(outline, point));
        }
        if event.kind == EventKind::Collision {
            individual.relate("dul:isClassifiedBy", "semco:collision_concept".to_owned());
            let tool = self.task.tool.name.as_str();
            let who = ["human"].into_iter().chain(self.robot).chain([tool]);
            for name in who {
                individual.relate("dul:hasParticipant", shared(name));
            }
        }
        Some(individual)
    }
}

fn edge_distance(outline: &Polygon, point: Point2) -> f64 {
    let distances = outline.edges().map(|edge| edge.distance(point));
    distances.fold(f64::INFINITY, f64::min)
}

fn participants(round: &EpisodeRound<'_>) -> BTreeMap<String, Vec<String>> {
    let robot = round.motion.cell.robot().name();
    let mut relations = things_of(&round.motion.task);
    relations.insert("soma:isPerformedBy".to_owned(), vec![shared(robot)]);
    relations
}

/// What a task is done with, to what and where.
fn things_of(task: &Task) -> BTreeMap<String, Vec<String>> {
    [
        ("semco:usesTool", task.tool.name.as_str()),
        ("semco:removesMedium", &task.medium),
        ("semco:actsOnSurface", &task.surface.name),
    ]
    .map(|(property, name)| (property.to_owned(), vec![shared(name)]))
    .into()
}

/// The name of something that episodes share, as it may stand in an IRI.
fn shared(name: &str) -> String {
    let plain = |c: char| {
        if c.is_alphanumeric() || "-_.".contains(c) {
            c
        } else {
            '_'
        }
    };
    format!("semco:{}", name.chars().map(plain).collect::<String>())
}

/// How it ended; `None` where that cannot be told.
fn state(verdict: Verdict) -> Option<&'static str> {
    match verdict {
        Verdict::GoalMet => Some(SUCCEEDED),
        Verdict::UnknowableByTouch | Verdict::CannotBeTold => None,
        _ => Some(FAILED),
    }
}

const SUCCEEDED: &str = "soma:ExecutionState_Succeeded";
const FAILED: &str = "soma:ExecutionState_Failed";

impl Individual {
    fn new(class: &str, parent: Option<usize>) -> Self {
        Self {
            class: class.to_owned(),
            interval: None,
            parent,
            relations: BTreeMap::new(),
            values: BTreeMap::new(),
        }
    }

    /// A number; what is none is left out, as nothing can be asked about it.
    fn set_number(&mut self, property: &str, value: f64) {
        if value.is_finite() {
            self.values
                .insert(property.to_owned(), Value::Number(value));
        }
    }

    fn set_text(&mut self, property: &str, text: &str) {
        let text = Value::Text(text.to_owned());
        self.values.insert(property.to_owned(), text);
    }

    fn relate(&mut self, property: &str, object: String) {
        let objects = self.relations.entry(property.to_owned()).or_default();
        objects.push(object);
    }

    /// Sets how it ended, if that can be told.
    fn end_in(&mut self, state: Option<&str>) {
        if let Some(state) = state {
            self.relate("soma:hasExecutionState", state.to_owned());
        }
    }

    fn estimate(&mut self, interpretation: &Interpretation) {
        let estimate = &interpretation.performance;
        self.set_number("semco:performance", estimate.mean);
        self.set_number("semco:performanceLow", estimate.low);
        self.set_number("semco:performanceHigh", estimate.high);
    }
}
