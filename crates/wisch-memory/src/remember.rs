//! Records of episodes from rounds of wiping.

mod goal;
mod log;
mod logged;

pub use goal::{
    GoalOutcome, RememberedGoal, RememberedPart, RememberedStep, StepKind, remember_goal,
};
pub use log::RoundLog;
pub use logged::remember_log;

use crate::id::episode_id;
use crate::record::{EPISODE_SCHEMA, EpisodeRecord, Individual, Origin, Value};
use log::Span;
use std::collections::BTreeMap;
use wisch::geometry::{Point2, Polygon};
use wisch::interpret::{
    Diagnosis, Doubt, Event, EventKind, InterpretConfig, Interpretation, PathPiece,
};
use wisch::recover::{Verdict, assess_goal};
use wisch::represent::{Action, GoalState, Task};
use wisch::run::{Ending, PlannedRound, RunWarning};

/// Shortest time at the surface after which missing contact is a measurement, not an absence of one [s].
const LEAST_NEAR: f64 = 0.5;

/// Header of an episode, beside its rounds.
#[derive(Debug, Clone, PartialEq)]
pub struct EpisodeHeader {
    /// Name of the episode, as [`episode_id`](crate::episode_id) returns it.
    pub id: String,
    /// Name of the task.
    pub task: String,
    /// Start of the run by the clock of its machine [s since 1970].
    pub start: f64,
    /// Estimated performance at which the goal counts as met \[1\].
    pub target: f64,
    /// Seed of the run.
    pub seed: u64,
    /// Program and version.
    pub program: String,
}

impl EpisodeHeader {
    /// Returns the header of an episode of a task that begins at a time [s since 1970], which also gives its name.
    ///
    /// ```
    /// # use wisch::prelude::*;
    /// # let outline = Polygon::rectangle(Vector2::new(0.4, 0.3));
    /// # let surface = Surface::new("tray", outline, Pose::identity());
    /// # let sponge = Tool::pad("sponge", Vector3::new(0.07, 0.11, 0.05))?;
    /// # let crumbs = ParticleDistribution::new(&[Point2::new(-0.1, 0.05)])?;
    /// # let task = Task::new(Action::Absorb, surface, sponge, "crumbs", crumbs);
    /// use wisch_memory::EpisodeHeader;
    /// let header = EpisodeHeader::new(1_795_309_772.5, &task, 0.95, "my program 1.0");
    /// assert_eq!(header.id, "20261122-010932-0000");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(start: f64, task: &Task, target: f64, program: &str) -> Self {
        Self {
            id: episode_id(start, 0),
            task: task.name.clone(),
            start,
            target,
            seed: task.seed,
            program: program.to_owned(),
        }
    }
}

/// Data of a round for its episode.
#[derive(Debug, Clone)]
pub struct EpisodeRound<'a> {
    /// Task, plan and motion of the round.
    pub motion: &'a PlannedRound,
    /// Times of its motions, from its telemetry.
    pub log: &'a RoundLog,
    /// Duration of the execution, in the robot's time \[s\].
    pub duration: f64,
    /// How the execution ended.
    pub ending: &'a Ending,
    /// Result of the interpretation.
    pub interpretation: &'a Interpretation,
    /// Warnings during the execution.
    pub warnings: &'a [RunWarning],
    /// Verdict on the round.
    pub verdict: Verdict,
    /// Performance by ground truth \[1\]; `None` outside simulation.
    pub simulated_performance: Option<f64>,
}

/// Returns the record of an episode: the actions of each round, the detected events, and the results.
///
/// The episode begins when the run began. From there, rounds follow each other without pauses: within the episode, times are
/// the robot's, not the computer's. An episode without a round lasts no time.
pub fn remember(header: &EpisodeHeader, rounds: &[EpisodeRound<'_>]) -> EpisodeRecord {
    let mut record = RecordBuilder {
        individuals: Vec::new(),
        time: header.start,
        starts: Vec::new(),
    };
    record.add("semco:WipingEpisode", None);
    if let (Some(first), Some(last)) = (rounds.first(), rounds.last()) {
        let action = record.add("semco:WipingAction", Some(0));
        record.add(class_of(first.motion.task.action), None);
        for round in rounds {
            record.round(action, round, header.target);
        }
        let interval = [header.start, record.time];
        let individual = &mut record.individuals[action];
        individual.interval = Some(interval);
        individual.values = action_values(header, first, last, rounds.len());
        individual.relations = participants(first);
        individual.relate("dul:executesTask", "#2".to_owned());
        individual.end_in(state(last, header.target));
    }
    let interval = [header.start, record.time];
    let episode = &mut record.individuals[0];
    episode.interval = Some(interval);
    episode.set_text("semco:taskName", &header.task);
    episode.set_number("semco:seed", header.seed as f64);
    EpisodeRecord {
        schema: EPISODE_SCHEMA,
        id: header.id.clone(),
        task: header.task.clone(),
        interval,
        origin: Origin::Simulated,
        program: header.program.clone(),
        seed: header.seed,
        rounds: record.starts,
        individuals: record.individuals,
    }
}

pub(crate) const fn class_of(action: Action) -> &'static str {
    match action {
        Action::Absorb => "semco:Absorbing",
        Action::Collect => "semco:Collecting",
        Action::Skim => "semco:Skimming",
        Action::Polish => "semco:Polishing",
        Action::Dispense => "semco:Painting",
    }
}

fn action_values(
    header: &EpisodeHeader,
    first: &EpisodeRound<'_>,
    last: &EpisodeRound<'_>,
    rounds: usize,
) -> BTreeMap<String, Value> {
    let mut about = Individual::new("semco:WipingAction", None);
    about.estimate(last.interpretation, last.motion.task.action);
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

/// Returns the goal in PDDL.
fn goal_of(task: &Task, goal: &GoalState) -> String {
    let predicate = goal.as_str();
    format!("({predicate} {} {})", task.medium, task.surface.name)
}

/// Builder of a record.
struct RecordBuilder {
    individuals: Vec<Individual>,
    /// The robot's current time [s since 1970].
    time: f64,
    starts: Vec<f64>,
}

impl RecordBuilder {
    fn add(&mut self, class: &str, parent: Option<usize>) -> usize {
        self.individuals.push(Individual::new(class, parent));
        self.individuals.len() - 1
    }

    fn round(&mut self, action: usize, round: &EpisodeRound<'_>, target: f64) {
        let start = self.time;
        let end = start + round.duration;
        self.starts.push(start);
        self.time = end;
        let number = self.add("semco:WipingRound", Some(action));
        let individual = &mut self.individuals[number];
        individual.interval = Some([start, end]);
        describe(individual, round, target);
        let context = RoundContext {
            task: &round.motion.task,
            interpretation: round.interpretation,
            robot: Some(round.motion.cell.robot().name()),
            warnings: round.warnings,
            during: [start, end],
            stopped: match round.ending {
                Ending::ProtectiveStop { time, .. } => Some(*time),
                Ending::Complete | Ending::Stopped | Ending::Early { .. } => None,
            },
        };
        context.add_parts(&mut self.individuals, number, &round.log.spans());
    }
}

/// Adds the facts of a round.
fn describe(individual: &mut Individual, round: &EpisodeRound<'_>, target: f64) {
    let motion = &round.motion;
    describe_touch(individual, &motion.task, round.interpretation);
    individual.set_number("semco:round", motion.number as f64);
    individual.set_number("semco:strokes", motion.plan.strokes.len() as f64);
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
    individual.end_in(state(round, target));
}

/// Adds what the interpretation found.
fn describe_touch(individual: &mut Individual, task: &Task, interpretation: &Interpretation) {
    individual.estimate(interpretation, task.action);
    let asked = task.interaction.contact_force();
    // The press force of a tool that hovers is 0.
    if asked > 0.0 {
        individual.set_number("semco:pressForce", asked);
    }
    let share = interpretation.contact_share;
    if let Some(share) = share.or(shows_no_contact(interpretation).then_some(0.0)) {
        individual.set_number("semco:contactShare", share);
    }
    if let Some(bias) = interpretation.force_bias {
        individual.set_number("semco:forceBias", bias);
    }
    let always = [f64::NEG_INFINITY, f64::INFINITY];
    let least_share = least_contact(task);
    let contact = ContactStatistics::during(always, &interpretation.path, least_share);
    if let Some(force) = contact.mean_force {
        individual.set_number("semco:meanNormalForce", force);
    }
    if let Some(plane) = &interpretation.plane {
        individual.set_number("semco:planeTilt", plane.tilt);
        individual.set_number("semco:planeOffset", plane.offset);
    }
    let stiffness = interpretation.tool_stiffness.as_ref();
    if let Some(stiffness) = stiffness.filter(|stiffness| !stiffness.is_assumed) {
        individual.set_number("semco:toolStiffness", stiffness.n_per_m);
        individual.set_number("semco:toolStiffnessDeviation", stiffness.ln_deviation);
    }
    if !interpretation.doubts.is_empty() {
        let doubts: Vec<String> = (interpretation.doubts.iter())
            .map(ToString::to_string)
            .collect();
        individual.set_text("semco:doubt", &doubts.join("; "));
    }
    individual.set_text("semco:diagnosis", interpretation.diagnosis.as_str());
}

/// Whether the tool was at the surface for long enough to touch it, and the measured force shows no contact at all: the
/// force was not measured, or the tool did not press. Neither wrenches that are not usable nor misread ones show this.
fn shows_no_contact(interpretation: &Interpretation) -> bool {
    let mut doubts = interpretation
        .doubts
        .iter()
        .filter(|doubt| doubt.is_decisive() || matches!(doubt, Doubt::UnusableWrench { .. }));
    let is_missing = |doubt: &Doubt| match doubt {
        Doubt::NoContactForce {
            force,
            declared,
            lasts,
            ..
        } => force < declared && *lasts >= LEAST_NEAR,
        _ => false,
    };
    doubts.next().is_some_and(is_missing) && doubts.next().is_none()
}

fn describe_stroke(
    individual: &mut Individual,
    (stroke, span): (usize, &Span),
    interpretation: &Interpretation,
    least_share: f64,
) {
    let during = [span.start, span.end];
    let contact = ContactStatistics::during(during, &interpretation.path, least_share);
    individual.set_number("semco:stroke", stroke as f64);
    if let Some(force) = span.peak_force {
        individual.set_number("semco:peakForce", force);
    }
    if let Some(share) = contact.contact_share {
        individual.set_number("semco:contactShare", share);
    }
    if let Some(force) = contact.mean_force {
        individual.set_number("semco:meanNormalForce", force);
    }
}

/// Contact statistics over a part of the path, weighted by the time that each piece represents.
struct ContactStatistics {
    /// Share of the time in contact [1]; `None` for no time.
    contact_share: Option<f64>,
    /// Mean normal force during contact [N], negative where the tool presses; `None` without contact.
    mean_force: Option<f64>,
}

impl ContactStatistics {
    /// Computes the statistics from `start` to `end` [s]. `least_share`: least force over the nominal one of a piece in
    /// contact [1].
    fn during([start, end]: [f64; 2], path: &[PathPiece], least_share: f64) -> Self {
        // Share = Σ t_contact / Σ t; mean force = Σ F t / Σ t over the pieces in contact. A piece that the interval cuts
        // counts with the part inside, because a slow log has few pieces.
        let [mut all, mut contact, mut impulse] = [0.0; 3];
        for (i, piece) in path.iter().enumerate() {
            let [first, last] = PathPiece::span(path, i);
            let duration = (last.min(end) - first.max(start)).max(0.0);
            all += duration;
            if piece.is_in_contact(least_share) {
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

/// Returns the least force over the nominal one of a tool in contact [1], as the contact share of a round counts it.
fn least_contact(task: &Task) -> f64 {
    InterpretConfig::from_task(task).events.contact_share[1]
}

/// Context of a round, from which its motions and events are described.
struct RoundContext<'a> {
    task: &'a Task,
    interpretation: &'a Interpretation,
    /// Name of the robot, if known.
    robot: Option<&'a str>,
    /// Warnings during the execution.
    warnings: &'a [RunWarning],
    /// Begin and end of the round [s since 1970].
    during: [f64; 2],
    /// Time of a protective stop [s since the round began], if there was one.
    stopped: Option<f64>,
}

impl RoundContext<'_> {
    /// Adds the parts of the round at this index: its motions, and the events during them.
    fn add_parts(&self, individuals: &mut Vec<Individual>, round: usize, spans: &[Span]) {
        let [start, end] = self.during;
        let first = individuals.len();
        let least_share = least_contact(self.task);
        for span in spans {
            let mut motion = Individual::new(span.class(), Some(round));
            // Rounding must not let a part outlast the whole.
            motion.interval = Some([start + span.start, (start + span.end).min(end)]);
            if let Some(stroke) = span.stroke {
                describe_stroke(
                    &mut motion,
                    (stroke, span),
                    self.interpretation,
                    least_share,
                );
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
        for warning in self.warnings {
            let at = (start + warning.time).min(end);
            let parent = parent_at(warning.time);
            individuals.push(describe_warning(warning, at, parent));
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

    /// Returns the individual of an event; `None` for the robot's own phases, which its motions describe.
    fn of(&self, event: &Event, parent: usize) -> Option<Individual> {
        let class = match event.kind {
            EventKind::Contact => "semco:ToolContact",
            EventKind::ContactLoss => "semco:ContactLoss",
            EventKind::Push => "semco:HumanCollision",
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
        if event.kind == EventKind::Push {
            individual.relate("dul:isClassifiedBy", "semco:collision_concept".to_owned());
            let tool = self.task.tool.name.as_str();
            let who = ["human"].into_iter().chain(self.robot).chain([tool]);
            for name in who {
                individual.relate("dul:hasParticipant", shared_name(name));
            }
        }
        Some(individual)
    }
}

/// Class of a warning of the memory.
pub(crate) const WARNING_CLASS: &str = "semco:MemoryWarning";

/// Returns the individual of a warning at a time [s since 1970].
fn describe_warning(warning: &RunWarning, at: f64, parent: usize) -> Individual {
    let mut individual = Individual::new(WARNING_CLASS, Some(parent));
    individual.interval = Some([at, at]);
    individual.set_text("semco:warningChannel", warning.channel.as_str());
    individual.set_number("semco:warningValue", warning.value);
    individual.set_number("semco:bandLow", warning.band[0]);
    individual.set_number("semco:bandHigh", warning.band[1]);
    individual.set_number("semco:pValue", warning.p_value);
    let alike: Vec<&str> = (warning.alike.iter())
        .map(|episode| episode.id.as_str())
        .collect();
    individual.set_text("semco:alikeEpisodes", &alike.join(" "));
    individual
}

fn edge_distance(outline: &Polygon, point: Point2) -> f64 {
    let distances = outline.edges().map(|edge| edge.distance(point));
    distances.fold(f64::INFINITY, f64::min)
}

fn participants(round: &EpisodeRound<'_>) -> BTreeMap<String, Vec<String>> {
    let robot = round.motion.cell.robot().name();
    let mut relations = things_of(&round.motion.task);
    relations.insert("soma:isPerformedBy".to_owned(), vec![shared_name(robot)]);
    relations
}

/// Returns the participants of a task: tool, surface and substance.
fn things_of(task: &Task) -> BTreeMap<String, Vec<String>> {
    [
        ("semco:usesTool", task.tool.name.as_str()),
        ("semco:removesMedium", &task.medium),
        ("semco:actsOnSurface", &task.surface.name),
    ]
    .map(|(property, name)| (property.to_owned(), vec![shared_name(name)]))
    .into()
}

/// Returns the name of a shared thing in a form that an IRI allows.
pub(crate) fn shared_name(name: &str) -> String {
    let plain = |c: char| {
        if c.is_alphanumeric() || "-_.".contains(c) {
            c
        } else {
            '_'
        }
    };
    format!("semco:{}", name.chars().map(plain).collect::<String>())
}

/// Returns whether the goal was met after a round; `None` if that is unknown.
fn state(round: &EpisodeRound<'_>, target: f64) -> Option<&'static str> {
    state_of(assess_goal(
        round.verdict,
        &round.motion.task,
        round.interpretation,
        target,
    ))
}

/// Returns the state that a verdict implies; `None` if it is unknown.
fn state_of(verdict: Verdict) -> Option<&'static str> {
    match verdict {
        Verdict::GoalMet => Some(SUCCEEDED),
        Verdict::UnknowableByTouch | Verdict::Undecidable => None,
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

    /// Sets a number; a number that is not finite is left out, because queries could not use it.
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

    /// Sets the final state, if it is known.
    fn end_in(&mut self, state: Option<&str>) {
        if let Some(state) = state {
            self.relate("soma:hasExecutionState", state.to_owned());
        }
    }

    fn estimate(&mut self, interpretation: &Interpretation, action: Action) {
        let [low, high] = interpretation.range(action);
        // The mean from a misread log, or from a part of the wiping, would answer queries as if it were the performance, so
        // only its interval is stored.
        if interpretation.is_conclusive() && !interpretation.is_lower_bound() {
            self.set_number("semco:performance", interpretation.performance.mean);
        }
        self.set_number("semco:performanceLow", low);
        self.set_number("semco:performanceHigh", high);
    }
}
