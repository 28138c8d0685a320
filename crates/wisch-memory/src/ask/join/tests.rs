//! Goals on two small episodes, solved without an engine.

use super::{Indices, Joins, Solutions, SolverBudget};
use crate::ask::assertions::Assertions;
use crate::ask::error::AskError;
use crate::ask::names::Names;
use crate::ask::streams::Knowledge;
use crate::ask::telemetry_predicates::TelemetryPredicates;
use crate::ask::term::Term;
use crate::catalogue::Catalogue;
use crate::ontology::Ontology;
use crate::record::{EPISODE_SCHEMA, EpisodeRecord, Individual, Origin, Value};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

/// An episode with an action, a round, three strokes, and a push during the second.
fn episode(number: usize) -> EpisodeRecord {
    let start = 100.0 * (number as f64 + 1.0);
    let individual = |class: &str, parent, from: f64, to: f64, values: &[(&str, f64)]| Individual {
        class: format!("semco:{class}"),
        interval: Some([start + from, start + to]),
        parent,
        relations: [].into(),
        values: (values.iter())
            .map(|(name, value)| (format!("semco:{name}"), Value::Number(*value)))
            .collect(),
    };
    let performance = 0.5 + 0.25 * number as f64;
    let mut individuals = vec![
        individual("WipingEpisode", None, 0.0, 40.0, &[]),
        individual(
            "WipingAction",
            Some(0),
            0.0,
            40.0,
            &[("performance", performance)],
        ),
        individual(
            "WipingRound",
            Some(1),
            0.0,
            40.0,
            &[("performance", performance), ("round", 1.0)],
        ),
        individual("Stroke", Some(2), 1.0, 10.0, &[("meanNormalForce", -9.0)]),
        individual("Stroke", Some(2), 11.0, 20.0, &[("meanNormalForce", -7.0)]),
        individual("Stroke", Some(2), 21.0, 30.0, &[("meanNormalForce", -9.5)]),
        individual(
            "HumanCollision",
            Some(4),
            12.0,
            13.0,
            &[("peakForce", 20.0 + number as f64)],
        ),
    ];
    individuals[1]
        .relations
        .insert("semco:usesTool".into(), vec!["semco:sponge".into()]);
    EpisodeRecord {
        schema: EPISODE_SCHEMA,
        id: format!("e{number}"),
        task: "board".into(),
        interval: [start, start + 40.0],
        origin: Origin::Simulated,
        program: "wisch".into(),
        seed: 0,
        rounds: vec![start],
        individuals,
    }
}

fn knowledge() -> Knowledge {
    let catalogue = Arc::new(Catalogue::from_records(&[episode(0), episode(1)]));
    Knowledge {
        names: Names::new(Arc::clone(&catalogue), Ontology::load()),
        catalogue,
        assertions: Assertions::default(),
    }
}

fn solve_within(
    goals: &str,
    wanted: &str,
    most: usize,
    time: Duration,
) -> Result<Option<Solutions>, AskError> {
    let terms = |text: &str| match Term::parse(text).unwrap() {
        Term::List(items) => items,
        other => vec![other],
    };
    let known = knowledge();
    let joins = Joins {
        known: &known,
        indices: &mut Indices::default(),
        telemetry: &mut TelemetryPredicates::default(),
    };
    let budget = SolverBudget {
        deadline: Instant::now() + time,
        time,
        interrupt: &AtomicBool::new(false),
        candidates: u64::MAX,
    };
    joins.solve(&Term::List(terms(goals)), &terms(wanted), most, budget)
}

/// Returns the solutions as text; `None` if the engine must find them.
fn solve(goals: &str, wanted: &str) -> Option<Vec<String>> {
    let solved = solve_within(goals, wanted, 100, Duration::from_secs(10)).unwrap()?;
    let row = |row: Vec<Term>| {
        row.iter()
            .map(ToString::to_string)
            .collect::<Vec<_>>()
            .join(" ")
    };
    Some(solved.rows.into_iter().map(row).collect())
}

#[test]
fn facts_are_joined_in_any_order_of_goals() {
    let pushed = "semco:'Stroke_e0-4' semco:'HumanCollision_e0-6'|semco:'Stroke_e1-4' semco:'HumanCollision_e1-6'";
    for goals in [
        "[instance_of(C,'HumanCollision'),part(S,C)]",
        "[instance_of(S,'Stroke'),part(S,C)]",
        "[part(S,C),of_class(C,'semco:HumanCollision')]",
        "[instance_of(S,'Stroke'),instance_of(C,'HumanCollision'),related(contains,S,C)]",
        "[has_data_value(C,'>'(peakForce,19)),instance_of(S,'Stroke'),related(during,C,S)]",
    ] {
        assert_eq!(solve(goals, "[S,C]").unwrap().join("|"), pushed, "{goals}");
    }
}

#[test]
fn solutions_keep_the_order_of_the_query() {
    // By the collision first: it has fewer solutions, and strokes are then found by their times.
    let goals = "[instance_of(S,'Stroke'),instance_of(C,'HumanCollision'),related(before,S,C)]";
    let found = solve(goals, "[S,C]").unwrap();
    let strokes = ["e0-3", "e0-3", "e0-4", "e0-5", "e1-3"];
    let collisions = ["e0-6", "e1-6", "e1-6", "e1-6", "e1-6"];
    let expected = strokes.iter().zip(collisions);
    let expected: Vec<String> = expected
        .map(|(s, c)| format!("semco:'Stroke_{s}' semco:'HumanCollision_{c}'"))
        .collect();
    assert_eq!(found, expected);
}

#[test]
fn aggregates_are_computed() {
    for (goals, wanted, expected) in [
        (
            "[aggregate_all(count,[instance_of(S,'Stroke')],N)]",
            "[N]",
            "6",
        ),
        (
            "[aggregate_all(max(F,C),[value(C,'semco:peakForce',F)],M)]",
            "[M]",
            "max(21.0, semco:'HumanCollision_e1-6')",
        ),
        (
            "[aggregate_all(sum('-'(E,S)),[of_class(A,'semco:WipingAction'),timed(A,S,E)],T)]",
            "[T]",
            "80.0",
        ),
        (
            "[findall(N,[value(R,'semco:round',N)],L),length(L,K)]",
            "[L,K]",
            "[1.0, 1.0] 2",
        ),
        (
            "[mean_by(T,P,[relation(A,'semco:usesTool',T),value(A,'semco:performance',P)],T2,M,N)]",
            "[T2,M,N]",
            "semco:sponge 0.625 2",
        ),
        (
            "[last_episode(E,T),part_below(E,C,'semco:Collision'),above(C,R,'semco:WipingRound')]",
            "[R,T]",
            "semco:'WipingRound_e1-2' 240.0",
        ),
    ] {
        assert_eq!(solve(goals, wanted).unwrap().join("|"), expected, "{goals}");
    }
}

#[test]
fn negations_and_alternatives_are_solved() {
    let goals = "[instance_of(S,'Stroke'),'\\\\+'([part(S,_C)]),value(S,'semco:meanNormalForce',F),either([['<'(F,-9.2)],['>'(F,-8.0)]])]";
    assert_eq!(
        solve(goals, "[S,F]").unwrap(),
        ["semco:'Stroke_e0-5' -9.5", "semco:'Stroke_e1-5' -9.5"]
    );
    let once = "[once([instance_of(S,'Stroke')])]";
    assert_eq!(solve(once, "[S]").unwrap(), ["semco:'Stroke_e0-3'"]);
}

#[test]
fn errors_and_unsupported_goals_are_left_to_the_engine() {
    for goals in [
        "[instance_of(A,'Stroek')]",
        "[instance_of(A,B)]",
        "[instance_of(A,'Stroke'),is(X,'+'(A,1))]",
        "[instance_of(A,'Stroke'),'<'(N,1)]",
        "[is(X,'/'(7,2))]",
        "[triple(A,'dul:isConstituentOf',B)]",
        "['='(A,f(A))]",
        "[format(A)]",
    ] {
        assert_eq!(solve(goals, "[A]"), None, "{goals}");
    }
}

#[test]
fn number_of_solutions_and_time_are_limited() {
    let cut = solve_within(
        "[instance_of(S,'Stroke')]",
        "[S]",
        4,
        Duration::from_secs(10),
    );
    let cut = cut.unwrap().unwrap();
    assert_eq!((cut.rows.len(), cut.is_cut), (4, true));
    let many: Vec<String> = (0..8)
        .map(|n| format!("instance_of(S{n},'Stroke')"))
        .collect();
    let all = format!("[aggregate_all(count,[{}],N)]", many.join(","));
    let late = solve_within(&all, "[N]", 1, Duration::from_millis(20));
    assert!(matches!(late, Err(AskError::Time(_))), "{late:?}");
}
