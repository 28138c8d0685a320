//! Synthetic episodes, for measurements and for trying queries.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::collections::BTreeMap;
use wisch_memory::{EPISODE_SCHEMA, EpisodeRecord, Individual, Origin, Value, episode_id};

/// Start of the first episode: 2026-01-01, 8:00 UTC [s since 1970].
pub const FIRST_START: f64 = 1_767_254_400.0;
/// Time between the starts of two episodes [s].
const SPACING: f64 = 1200.0;
/// Pause between two motions [s].
const PAUSE: f64 = 0.2;
/// Normal force in contact without a localisation error [N].
const PRESS: f64 = -9.5;
/// Number of episodes over which the contact force falls to half, by a growing localisation error.
const DRIFT_PERIOD: usize = 250;
/// Probability that a person pushes the robot during a stroke [1].
const COLLISION_CHANCE: f64 = 0.03;
/// Probability of a contact loss during a stroke [1].
const LOSS_CHANCE: f64 = 0.08;

/// A task with its tool, medium and surface.
struct Kind {
    task: &'static str,
    class: &'static str,
    tool: &'static str,
    medium: &'static str,
    surface: &'static str,
    goal: &'static str,
    /// Size of the surface [m].
    size: [f64; 2],
}

const KINDS: [Kind; 4] = [
    Kind {
        task: "chopping-board",
        class: "semco:Absorbing",
        tool: "semco:sponge",
        medium: "semco:breadcrumbs",
        surface: "semco:chopping_board",
        goal: "(absorbed breadcrumbs chopping_board)",
        size: [0.4, 0.3],
    },
    Kind {
        task: "broom-chippings",
        class: "semco:Collecting",
        tool: "semco:broom",
        medium: "semco:glass_chippings",
        surface: "semco:floor",
        goal: "(collected glass_chippings floor)",
        size: [2.0, 1.5],
    },
    Kind {
        task: "table-brush",
        class: "semco:Collecting",
        tool: "semco:brush",
        medium: "semco:breadcrumbs",
        surface: "semco:table",
        goal: "(collected breadcrumbs table)",
        size: [1.2, 0.8],
    },
    Kind {
        task: "windshield",
        class: "semco:Skimming",
        tool: "semco:window_wiper",
        medium: "semco:detergent",
        surface: "semco:windshield",
        goal: "(skimmed detergent windshield)",
        size: [1.2, 0.7],
    },
];

/// Returns the record of an episode; the same seed and number give the same record.
pub fn record(seed: u64, number: usize) -> EpisodeRecord {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    rng.set_stream(number as u64);
    let kind = &KINDS[rng.random_range(0..KINDS.len())];
    let start = FIRST_START + SPACING * number as f64;
    let fade = 1.0 - 0.5 * (number % DRIFT_PERIOD) as f64 / DRIFT_PERIOD as f64;
    let mut episode = Draft {
        rng,
        kind,
        fade,
        time: start,
        individuals: Vec::new(),
        rounds: Vec::new(),
    };
    episode.wipe();
    let end = episode.time;
    let task = kind.task.to_owned();
    episode.individuals[0].interval = Some([start, end]);
    episode.individuals[0].values = values([("semco:seed", number as f64)]);
    episode.individuals[0]
        .values
        .insert("semco:taskName".into(), Value::Text(task.clone()));
    EpisodeRecord {
        schema: EPISODE_SCHEMA,
        id: episode_id(start, number as u16),
        task,
        interval: [start, end],
        origin: Origin::Simulated,
        program: "synthetic".into(),
        seed: number as u64,
        rounds: episode.rounds,
        individuals: episode.individuals,
    }
}

/// Builder of an episode.
struct Draft {
    rng: ChaCha8Rng,
    kind: &'static Kind,
    /// Remaining share of the contact force [1].
    fade: f64,
    time: f64,
    individuals: Vec<Individual>,
    rounds: Vec<f64>,
}

impl Draft {
    fn wipe(&mut self) {
        let start = self.time;
        self.add("semco:WipingEpisode", None);
        let action = self.add("semco:WipingAction", Some(0));
        self.add(self.kind.class, None);
        self.individuals[2].parent = None;
        let predicted = self.between(0.85, 0.99);
        let mut performance = 0.0;
        let rounds = self.rng.random_range(1..=3);
        for number in 1..=rounds {
            performance = self.round(action, number, performance);
            if performance > 0.9 {
                break;
            }
        }
        let succeeded = performance > 0.8;
        let end = self.time;
        let task = self.kind;
        let mut found = values([
            ("semco:performance", performance),
            ("semco:performanceLow", (performance - 0.06).max(0.0)),
            ("semco:performanceHigh", (performance + 0.06).min(1.0)),
            ("semco:predictedPerformance", predicted),
            ("semco:target", 0.9),
            ("semco:rounds", self.rounds.len() as f64),
        ]);
        found.insert("semco:strategy".into(), Value::Text("grid".into()));
        found.insert("semco:goal".into(), Value::Text(task.goal.into()));
        let mut relations = self.participants();
        relations.insert("dul:executesTask".into(), vec!["#2".into()]);
        relations.insert("soma:hasExecutionState".into(), vec![state(succeeded)]);
        let individual = &mut self.individuals[action];
        individual.interval = Some([start, end]);
        individual.values = found;
        individual.relations = relations;
    }

    /// Adds a round; returns the performance after it.
    fn round(&mut self, action: usize, number: usize, before: f64) -> f64 {
        let start = self.time;
        self.rounds.push(start);
        let round = self.add("semco:WipingRound", Some(action));
        let strokes = self.rng.random_range(3..=8);
        if self.kind.surface == "semco:floor" {
            self.motion("semco:Drive", round, 3.0);
        }
        self.motion("semco:Approach", round, 1.5);
        let mut forces = 0.0;
        for stroke in 0..strokes {
            if stroke > 0 {
                self.motion("semco:Transfer", round, 0.8);
            }
            forces += self.stroke(round, stroke);
        }
        self.motion("semco:Retreat", round, 1.0);
        let gain = self.between(0.5, 1.0) * self.fade.sqrt();
        let performance = before + (1.0 - before) * gain;
        let end = self.time;
        let tilt = self.between(0.0, 0.01) + (1.0 - self.fade) * 0.02;
        let mut found = values([
            ("semco:round", number as f64),
            ("semco:strokes", strokes as f64),
            ("semco:predictedPerformance", (performance + 0.03).min(1.0)),
            ("semco:performance", performance),
            ("semco:performanceLow", (performance - 0.06).max(0.0)),
            ("semco:performanceHigh", (performance + 0.06).min(1.0)),
            ("semco:contactShare", 0.9 * self.fade),
            ("semco:meanNormalForce", forces / strokes as f64),
            ("semco:planeTilt", tilt),
            ("semco:planeOffset", -0.004 * (1.0 - self.fade)),
            ("semco:forceBias", self.between(-0.2, 0.2)),
        ]);
        let verdict = if performance > 0.9 {
            "goal met"
        } else {
            "wipe again"
        };
        for (property, text) in [
            ("semco:verdict", verdict),
            ("semco:diagnosis", "localized"),
            ("semco:ending", "complete"),
        ] {
            found.insert(property.into(), Value::Text(text.into()));
        }
        let mut relations = self.participants();
        let good = state(performance > 0.9);
        relations.insert("soma:hasExecutionState".into(), vec![good]);
        let individual = &mut self.individuals[round];
        individual.interval = Some([start, end]);
        individual.values = found;
        individual.relations = relations;
        performance
    }

    /// Adds a stroke with its events; returns its mean normal force [N].
    fn stroke(&mut self, round: usize, number: usize) -> f64 {
        let start = self.time;
        let length = self.between(2.0, 5.0);
        let stroke = self.motion("semco:Stroke", round, length);
        let force = PRESS * self.fade * self.between(0.9, 1.1);
        self.individuals[stroke].values = values([
            ("semco:stroke", number as f64),
            ("semco:meanNormalForce", force),
            ("semco:peakForce", 1.3 * force.abs()),
            ("semco:contactShare", 0.95 * self.fade),
        ]);
        self.event("semco:ToolContact", stroke, [start, start + length], force);
        if self.rng.random_bool(LOSS_CHANCE) {
            let from = start + 0.7 * length;
            self.event("semco:ContactLoss", stroke, [from, from + 0.3], 0.0);
        }
        if self.rng.random_bool(COLLISION_CHANCE) {
            let from = start + 0.4 * length;
            let event = self.event("semco:HumanCollision", stroke, [from, from + 0.6], -25.0);
            let tool = self.kind.tool.to_owned();
            self.individuals[event].relations = [
                (
                    "dul:isClassifiedBy".to_owned(),
                    vec!["semco:collision_concept".to_owned()],
                ),
                (
                    "dul:hasParticipant".to_owned(),
                    vec!["semco:human".to_owned(), "semco:humanoid".to_owned(), tool],
                ),
            ]
            .into();
        }
        force
    }

    fn event(&mut self, class: &str, parent: usize, interval: [f64; 2], force: f64) -> usize {
        let event = self.add(class, Some(parent));
        let duration = interval[1] - interval[0];
        let edge = self.between(0.0, 0.5 * self.kind.size[1]);
        let height = self.between(0.0, 0.004);
        self.individuals[event].interval = Some(interval);
        self.individuals[event].values = values([
            ("semco:samples", (duration * 1e3).round()),
            ("semco:meanNormalForce", force),
            ("semco:peakForce", 1.4 * force.abs()),
            ("semco:peakHeight", height),
            ("semco:edgeDistance", edge),
        ]);
        event
    }

    fn motion(&mut self, class: &str, parent: usize, duration: f64) -> usize {
        let start = self.time;
        let motion = self.add(class, Some(parent));
        self.individuals[motion].interval = Some([start, start + duration]);
        self.time = start + duration + PAUSE;
        motion
    }

    fn add(&mut self, class: &str, parent: Option<usize>) -> usize {
        self.individuals.push(Individual {
            class: class.to_owned(),
            interval: None,
            parent,
            relations: BTreeMap::new(),
            values: BTreeMap::new(),
        });
        self.individuals.len() - 1
    }

    fn participants(&self) -> BTreeMap<String, Vec<String>> {
        let kind = self.kind;
        [
            ("semco:usesTool", kind.tool),
            ("semco:removesMedium", kind.medium),
            ("semco:actsOnSurface", kind.surface),
            ("soma:isPerformedBy", "semco:humanoid"),
        ]
        .map(|(property, object)| (property.to_owned(), vec![object.to_owned()]))
        .into()
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.rng.random_range(low..high)
    }
}

fn state(succeeded: bool) -> String {
    let name = if succeeded { "Succeeded" } else { "Failed" };
    format!("soma:ExecutionState_{name}")
}

fn values<const N: usize>(values: [(&str, f64); N]) -> BTreeMap<String, Value> {
    values
        .map(|(property, value)| (property.to_owned(), Value::Number(value)))
        .into()
}
