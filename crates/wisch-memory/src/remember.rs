//! From rounds of wiping to the record of an episode.

mod log;
mod logged;

pub use log::RoundLog;
pub use logged::remember_log;

use crate::record::{EPISODE_SCHEMA, EpisodeRecord, Individual, Origin, Value};
use log::Span;
use std::collections::BTreeMap;
use wisch::geometry::{Point2, Polygon};
use wisch::interpret::{Diagnosis, Event, EventKind, Interpretation, PathPiece, Touch};
use wisch::recover::Verdict;
use wisch::represent::{Action, GoalState, Task};
use wisch::run::Ending;
use wisch::run::Round;

/// What an episode is besides its rounds.
#[derive(Debug, Clone, PartialEq)]
pub struct Occasion {
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

/// The record of an episode: what was done in each round, what was felt, and how well it went.
///
/// One round follows the other without a pause: their times are those of the robot, not of who computes.
///
/// `logs` are what was seen of each round while it was executed, in the same order.
pub fn remember(occasion: &Occasion, rounds: &[(&Round, &RoundLog)]) -> EpisodeRecord {
    let mut memory = Remembering {
        individuals: Vec::new(),
        time: occasion.start,
        starts: Vec::new(),
    };
    let task = rounds.first().map(|(round, _)| &round.motion.task);
    let name = task.map_or_else(String::new, |task| task.name.clone());
    memory.add("semco:WipingEpisode", None);
    if let (Some(task), Some((last, _))) = (task, rounds.last()) {
        let action = memory.add("semco:WipingAction", Some(0));
        memory.add(class_of(task.action), None);
        for (round, log) in rounds {
            memory.round(action, round, log);
        }
        let interval = [occasion.start, memory.time];
        let first = rounds[0].0;
        let individual = &mut memory.individuals[action];
        individual.interval = Some(interval);
        individual.values = action_values(occasion, first, last, rounds.len());
        individual.relations = participants(first);
        individual.relate("dul:executesTask", "#2".to_owned());
        individual.relate("soma:hasExecutionState", state(last.verdict));
    }
    let interval = [occasion.start, memory.time];
    let episode = &mut memory.individuals[0];
    episode.interval = Some(interval);
    episode.tell("semco:taskName", &name);
    episode.set("semco:seed", occasion.seed as f64);
    EpisodeRecord {
        schema: EPISODE_SCHEMA,
        id: occasion.id.clone(),
        task: name,
        interval,
        origin: Origin::Simulated,
        program: occasion.program.clone(),
        seed: occasion.seed,
        rounds: memory.starts,
        individuals: memory.individuals,
    }
}

const fn class_of(action: Action) -> &'static str {
    match action {
        Action::Absorb => "semco:Absorbing",
        Action::Collect => "semco:Collecting",
        Action::Skim => "semco:Skimming",
    }
}

fn action_values(
    occasion: &Occasion,
    first: &Round,
    last: &Round,
    rounds: usize,
) -> BTreeMap<String, Value> {
    let mut about = Individual::new("semco:WipingAction", None);
    about.estimate(&last.interpretation);
    if let Some(truth) = None::<f64> {
        about.set("semco:simulatedPerformance", truth);
    }
    about.set(
        "semco:predictedPerformance",
        first.motion.prediction.performance.ratio(),
    );
    about.set("semco:target", occasion.target);
    about.set("semco:rounds", rounds as f64);
    about.tell("semco:strategy", first.motion.plan.strategy.as_str());
    let goal = &first.motion.plan.graph.goal;
    about.tell("semco:goal", &goal_of(&first.motion.task, goal));
    about.values
}

/// The goal as PDDL says it.
fn goal_of(task: &Task, goal: &GoalState) -> String {
    let predicate = match goal {
        GoalState::Absorbed => "absorbed",
        GoalState::Collected { .. } => "collected",
        GoalState::Skimmed => "skimmed",
    };
    format!("({predicate} {} {})", task.medium, task.surface.name)
}

/// The graph in the making.
struct Remembering {
    individuals: Vec<Individual>,
    /// The robot's time [s since 1970].
    time: f64,
    starts: Vec<f64>,
}

impl Remembering {
    fn add(&mut self, class: &str, parent: Option<usize>) -> usize {
        self.individuals.push(Individual::new(class, parent));
        self.individuals.len() - 1
    }

    fn round(&mut self, action: usize, round: &Round, log: &RoundLog) {
        let start = self.time;
        let end = start + round.execution.duration;
        self.starts.push(start);
        self.time = end;
        let number = self.add("semco:WipingRound", Some(action));
        let told = &round.interpretation;
        let individual = &mut self.individuals[number];
        individual.interval = Some([start, end]);
        describe(individual, round);
        let spans = log.spans();
        let first = self.individuals.len();
        for span in &spans {
            let motion = self.add(span.class(), Some(number));
            let individual = &mut self.individuals[motion];
            // Rounding must not let a part outlast the whole.
            individual.interval = Some([start + span.start, (start + span.end).min(end)]);
            if let Some(stroke) = span.stroke {
                describe_stroke(individual, stroke, span, told);
            }
        }
        let parent_at =
            |time: f64| first_during(&spans, time).map_or(number, |place| first + place);
        for event in &told.events {
            let individual = Happening {
                task: &round.motion.task,
                told,
                robot: Some(round.motion.cell.robot().name()),
                during: [start, end],
            };
            let parent = parent_at(event.start);
            self.individuals.extend(individual.of(event, parent));
        }
        if let Ending::ProtectiveStop { time, .. } = round.execution.ending {
            let parent = parent_at(time);
            let stop = self.add("semco:ProtectiveStop", Some(parent));
            let at = (start + time).min(end);
            self.individuals[stop].interval = Some([at, at]);
        }
        if let Diagnosis::Relocalize { .. } = told.diagnosis {
            let found = self.add("semco:Relocalization", Some(number));
            self.individuals[found].interval = Some([end, end]);
        }
    }
}

/// What is said of a round.
fn describe(individual: &mut Individual, round: &Round) {
    let motion = &round.motion;
    describe_felt(individual, &round.interpretation);
    individual.set("semco:round", motion.number as f64);
    individual.set("semco:strokes", motion.followed.strokes.len() as f64);
    individual.set(
        "semco:predictedPerformance",
        motion.prediction.performance.ratio(),
    );
    if let Some(truth) = None::<f64> {
        individual.set("semco:simulatedPerformance", truth);
    }
    individual.tell("semco:verdict", round.verdict.as_str());
    individual.tell(
        "semco:ending",
        match round.execution.ending {
            Ending::Complete => "complete",
            Ending::Stopped => "stopped",
            Ending::ProtectiveStop { .. } => "protective stop",
        },
    );
    individual.relations = participants(round);
    individual.relate("soma:hasExecutionState", state(round.verdict));
}

/// What the touch of a round tells.
fn describe_felt(individual: &mut Individual, told: &Interpretation) {
    individual.estimate(told);
    individual.set("semco:contactShare", told.contact_share);
    individual.set("semco:forceBias", told.force_bias);
    let Felt { mean_force, .. } = Felt::of(told.path.iter());
    if let Some(force) = mean_force {
        individual.set("semco:meanNormalForce", force);
    }
    if let Some(plane) = &told.plane {
        individual.set("semco:planeTilt", plane.tilt);
        individual.set("semco:planeOffset", plane.offset);
    }
    individual.tell(
        "semco:diagnosis",
        match told.diagnosis {
            Diagnosis::Localized => "localized",
            Diagnosis::Relocalize { .. } => "relocalize",
            Diagnosis::NoContact => "no contact",
        },
    );
}

/// The motion during which a time [s since the round began] lies.
fn first_during(spans: &[Span], time: f64) -> Option<usize> {
    let during = |span: &Span| span.start <= time && time < span.end;
    spans.iter().position(during)
}

fn describe_stroke(individual: &mut Individual, stroke: usize, span: &Span, told: &Interpretation) {
    let during = told.path.iter().filter(|piece| {
        let middle = 0.5 * (piece.time[0] + piece.time[1]);
        (span.start..span.end).contains(&middle)
    });
    let felt = Felt::of(during);
    individual.set("semco:stroke", stroke as f64);
    individual.set("semco:peakForce", span.peak_force);
    if let Some(share) = felt.contact_share {
        individual.set("semco:contactShare", share);
    }
    if let Some(force) = felt.mean_force {
        individual.set("semco:meanNormalForce", force);
    }
}

/// What was felt over some pieces of the path, each as long as it lasts.
struct Felt {
    /// Share of the time in contact, if there is any time.
    contact_share: Option<f64>,
    /// Mean normal force over contact [N], if there is any.
    mean_force: Option<f64>,
}

impl Felt {
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

/// What happened in a round, and who was there.
struct Happening<'a> {
    task: &'a Task,
    told: &'a Interpretation,
    /// The robot's name, if it is known.
    robot: Option<&'a str>,
    /// When the round began and ended [s since 1970].
    during: [f64; 2],
}

impl Happening<'_> {
    /// `None` of what the robot itself was about, which its motions tell.
    fn of(&self, event: &Event, parent: usize) -> Option<Individual> {
        let class = match event.kind {
            EventKind::Contact => "semco:ToolContact",
            EventKind::ContactLoss => "semco:ContactLoss",
            EventKind::Collision => "semco:HumanCollision",
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
        individual.set("semco:samples", event.samples as f64);
        individual.set("semco:meanNormalForce", event.mean_normal_force);
        individual.set("semco:peakForce", event.peak_force);
        individual.set("semco:peakHeight", event.peak_height);
        let path = &self.told.path;
        let at = path.partition_point(|piece| piece.time[1] < event.start);
        if let Some(piece) = path.get(at).or(path.last()) {
            let point = Point2::new(piece.position.x, piece.position.y);
            let outline = &self.task.surface.outline;
            individual.set("semco:edgeDistance", edge_distance(outline, point));
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

fn participants(round: &Round) -> BTreeMap<String, Vec<String>> {
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

fn state(verdict: Verdict) -> String {
    let name = match verdict {
        Verdict::GoalMet => "Succeeded",
        _ => "Failed",
    };
    format!("soma:ExecutionState_{name}")
}

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
    fn set(&mut self, property: &str, value: f64) {
        if value.is_finite() {
            self.values
                .insert(property.to_owned(), Value::Number(value));
        }
    }

    fn tell(&mut self, property: &str, text: &str) {
        let text = Value::Text(text.to_owned());
        self.values.insert(property.to_owned(), text);
    }

    fn relate(&mut self, property: &str, object: String) {
        let objects = self.relations.entry(property.to_owned()).or_default();
        objects.push(object);
    }

    fn estimate(&mut self, told: &Interpretation) {
        let estimate = &told.performance;
        self.set("semco:performance", estimate.mean);
        self.set("semco:performanceLow", estimate.low);
        self.set("semco:performanceHigh", estimate.high);
    }
}
