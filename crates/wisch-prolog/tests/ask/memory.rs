//! Seven episodes made by hand, small enough to answer every question by looking.
//!
//! | | rounds: estimated performance | what happened |
//! |---|---|---|
//! | e0 | 0.75, 0.96 | a person pushes during the stroke of round 1 |
//! | e1 | 0.92 | nothing |
//! | e2 | 0.70, surely below the target | contact lost near an edge, and stick-slip |
//! | e3 | 0.93 | the surface is found elsewhere; the robot stops itself |
//! | e4 | 0.60, 0.60 | the second round brings nothing |
//! | e5 | 0.95 | the broom on the table, a second stroke touches nothing |
//!
//! Between e1 and e2 lies g0, a goal of two parts: the sponge is fetched, and e1 is its wiping step.
//!
//! Each of e0 to e5 begins a thousand seconds after the one before and presses 0.4 N less on the board.

use wisch_memory::{
    EPISODE_SCHEMA, EpisodeHeader, EpisodeRecord, GoalOutcome, Individual, Origin, RememberedGoal,
    RememberedPart, RememberedStep, StepKind, Value, remember_goal,
};

/// An episode in the making.
struct Making {
    start: f64,
    individuals: Vec<Individual>,
}

impl Making {
    fn add(&mut self, class: &str, parent: usize, at: [f64; 2], numbers: &[(&str, f64)]) -> usize {
        let named = numbers.iter();
        self.individuals.push(Individual {
            class: format!("semco:{class}"),
            interval: Some(at.map(|time| self.start + time)),
            parent: (!self.individuals.is_empty()).then_some(parent),
            relations: [].into(),
            values: named
                .map(|(name, value)| (format!("semco:{name}"), Value::Number(*value)))
                .collect(),
        });
        self.individuals.len() - 1
    }

    fn tell(&mut self, place: usize, property: &str, text: &str) {
        let values = &mut self.individuals[place].values;
        values.insert(format!("semco:{property}"), Value::Text(text.to_owned()));
    }

    fn relate(&mut self, place: usize, property: &str, object: &str) {
        let relations = &mut self.individuals[place].relations;
        relations.insert(property.to_owned(), vec![object.to_owned()]);
    }
}

/// What differs between the episodes' rounds.
struct Round {
    performance: [f64; 3],
    predicted: f64,
    simulated: f64,
    contact: f64,
}

const fn round(low: f64, mean: f64, high: f64) -> Round {
    Round {
        performance: [low, mean, high],
        predicted: 0.95,
        simulated: mean,
        contact: 0.9,
    }
}

/// The seven episodes.
pub fn episodes() -> Vec<EpisodeRecord> {
    (0..6).map(episode).chain([goal_episode()]).collect()
}

fn goal_episode() -> EpisodeRecord {
    let header = EpisodeHeader {
        id: "g0".to_owned(),
        task: "kitchen".to_owned(),
        start: 2500.0,
        target: 0.9,
        seed: 1,
        program: "by hand".to_owned(),
    };
    let part = |part: &str, outcome, why: Option<&str>| RememberedPart {
        part: part.to_owned(),
        outcome,
        why: why.map(str::to_owned),
    };
    let step = |kind, words: &str, times, episode: Option<&str>| RememberedStep {
        kind,
        words: words.to_owned(),
        things: [Some("sponge".to_owned()), None, None],
        times,
        is_met: None,
        serves: vec![0],
        episode: episode.map(str::to_owned),
    };
    let goal = RememberedGoal {
        goal: "(and (absorbed breadcrumbs table) (absorbed water table))".to_owned(),
        robot: Some("humanoid".to_owned()),
        expected: 34.0,
        clock_duration: 90.0,
        parts: vec![
            part("(absorbed breadcrumbs table)", GoalOutcome::Met, None),
            part(
                "(absorbed water table)",
                GoalOutcome::NotMet,
                Some("no tool"),
            ),
        ],
        steps: vec![
            step(StepKind::Fetch, "fetch sponge", [0.0, 10.0, 12.0], None),
            RememberedStep {
                is_met: Some(GoalOutcome::Met),
                ..step(
                    StepKind::Wipe,
                    "absorb breadcrumbs on table with sponge",
                    [12.0, 24.0, 30.5],
                    Some("e1"),
                )
            },
            RememberedStep {
                is_met: Some(GoalOutcome::NotMet),
                serves: vec![1],
                ..step(
                    StepKind::Wipe,
                    "absorb water on table with sponge",
                    [42.5, 20.0, 8.5],
                    Some("lost"),
                )
            },
            step(
                StepKind::PutBack,
                "put sponge back",
                [51.0, 10.0, 10.0],
                None,
            ),
        ],
    };
    remember_goal(&header, &goal)
}

fn episode(number: usize) -> EpisodeRecord {
    let start = 1000.0 * (number + 1) as f64;
    let rounds = match number {
        0 => vec![
            Round {
                simulated: 0.45,
                ..round(0.5, 0.75, 0.9)
            },
            round(0.9, 0.96, 1.0),
        ],
        1 => vec![round(0.85, 0.92, 0.97)],
        2 => vec![Round {
            contact: 0.7,
            ..round(0.65, 0.70, 0.75)
        }],
        3 => vec![round(0.88, 0.93, 0.98)],
        4 => vec![round(0.55, 0.60, 0.65), round(0.56, 0.60, 0.64)],
        _ => vec![round(0.9, 0.95, 0.99)],
    };
    let last = &rounds[rounds.len() - 1];
    let [low, mean, high] = last.performance;
    let length = 30.0 * rounds.len() as f64;
    let mut making = Making {
        start,
        individuals: Vec::new(),
    };
    making.add("WipingEpisode", 0, [0.0, length], &[("seed", 1.0)]);
    let action = making.add(
        "WipingAction",
        0,
        [0.0, length],
        &[
            ("performance", mean),
            ("performanceLow", low),
            ("performanceHigh", high),
            ("target", 0.9),
            ("rounds", rounds.len() as f64),
        ],
    );
    let strategy = if number == 5 { "grid" } else { "kde" };
    making.tell(action, "strategy", strategy);
    let task = making.add("Collecting", 0, [0.0, length], &[]);
    making.individuals[task].interval = None;
    making.individuals[task].parent = None;
    take_part(&mut making, action, number);
    making.relate(action, "dul:executesTask", "#2");
    let state = if mean >= 0.9 { "Succeeded" } else { "Failed" };
    let state = format!("soma:ExecutionState_{state}");
    making.relate(action, "soma:hasExecutionState", &state);
    for (index, round) in rounds.iter().enumerate() {
        add_round(&mut making, number, index, round);
    }
    EpisodeRecord {
        schema: EPISODE_SCHEMA,
        id: format!("e{number}"),
        task: "board".to_owned(),
        interval: [start, start + length],
        origin: Origin::Simulated,
        program: "by hand".to_owned(),
        seed: 1,
        rounds: (0..rounds.len()).map(|k| start + 30.0 * k as f64).collect(),
        individuals: making.individuals,
    }
}

fn take_part(making: &mut Making, place: usize, number: usize) {
    let [tool, medium, surface] = if number == 5 {
        ["broom", "sand", "table"]
    } else {
        ["sponge", "breadcrumbs", "chopping_board"]
    };
    making.relate(place, "semco:usesTool", &format!("semco:{tool}"));
    making.relate(place, "semco:removesMedium", &format!("semco:{medium}"));
    making.relate(place, "semco:actsOnSurface", &format!("semco:{surface}"));
    making.relate(place, "soma:isPerformedBy", "semco:humanoid");
}

fn add_round(making: &mut Making, number: usize, index: usize, round: &Round) {
    let from = 30.0 * index as f64;
    let [low, mean, high] = round.performance;
    let force = -(9.6 - 0.4 * number as f64);
    let place = making.add(
        "WipingRound",
        1,
        [from, from + 30.0],
        &[
            ("round", index as f64 + 1.0),
            ("performance", mean),
            ("performanceLow", low),
            ("performanceHigh", high),
            ("predictedPerformance", round.predicted),
            ("simulatedPerformance", round.simulated),
            ("contactShare", round.contact),
            ("meanNormalForce", force),
            ("planeTilt", if number == 3 { 0.05 } else { 0.001 }),
            ("planeOffset", if number == 3 { 0.004 } else { 0.0 }),
        ],
    );
    let diagnosis = if number == 3 {
        "relocalize"
    } else {
        "localized"
    };
    making.tell(place, "diagnosis", diagnosis);
    take_part(making, place, number);
    making.add("Approach", place, [from, from + 2.0], &[]);
    let stroke = making.add(
        "Stroke",
        place,
        [from + 2.0, from + 20.0],
        &[
            ("stroke", 0.0),
            ("meanNormalForce", force),
            ("contactShare", 0.9),
        ],
    );
    let contact = [from + 2.5, from + 18.0 + number as f64 / 10.0];
    making.add(
        "ToolContact",
        stroke,
        contact,
        &[("meanNormalForce", force)],
    );
    let event = |making: &mut Making, class: &str, at: [f64; 2], values: &[(&str, f64)]| {
        making.add(class, stroke, at.map(|time| from + time), values)
    };
    match (number, index) {
        (0, 0) => {
            let values = [("peakForce", 22.0), ("peakHeight", 0.05)];
            let collision = event(making, "HumanCollision", [10.0, 11.5], &values);
            making.relate(collision, "dul:isClassifiedBy", "semco:collision_concept");
            making.relate(collision, "dul:hasParticipant", "semco:human");
        }
        (2, _) => {
            event(making, "ContactLoss", [5.0, 5.2], &[("edgeDistance", 0.02)]);
            event(making, "ContactLoss", [8.0, 8.2], &[("edgeDistance", 0.10)]);
            event(making, "StickSlip", [6.0, 7.0], &[]);
        }
        (3, _) => {
            event(making, "ProtectiveStop", [12.0, 12.0], &[]);
        }
        (4, 1) => {
            event(making, "Landing", [2.5, 2.7], &[("peakForce", 31.0)]);
            event(making, "Overload", [6.0, 6.5], &[("peakForce", 28.0)]);
            event(making, "Vibration", [9.0, 9.4], &[("peakForce", 17.0)]);
            event(making, "HandGuiding", [12.0, 18.0], &[("peakForce", 12.0)]);
        }
        (5, _) => {
            let values = [("stroke", 1.0), ("contactShare", 0.0)];
            making.add("Stroke", place, [22.0, 28.0], &values);
        }
        _ => {}
    }
}
