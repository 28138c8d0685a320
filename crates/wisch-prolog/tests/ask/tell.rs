//! What queries add to a memory: all that a query tells that ends well, nothing of another.

use super::{asker, engines, memory, shown};
use std::fs;
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;
use wisch_memory::Catalogue;
use wisch_memory::ask::{
    AskError, Asker, Assertions, EngineCommand, Limits, QueryFault, TelemetryPredicates,
};

const COMMENT: &str = "tell(holds('Stroke_e0-5', semco:recordLog, pushed))";

fn asker_of(folder: &Path, command: EngineCommand, limits: Limits) -> Asker {
    Asker::new(
        command,
        limits,
        Arc::new(Catalogue::of(&memory::episodes())),
        TelemetryPredicates::default(),
        Assertions::read(folder).unwrap(),
    )
}

/// How many statements a memory keeps.
fn kept(folder: &Path) -> usize {
    fs::read_to_string(folder.join("told.jsonl")).map_or(0, |text| text.lines().count())
}

#[test]
fn what_is_told_is_kept_when_the_query_has_ended_well() {
    for command in engines() {
        let folder = tempfile::tempdir().unwrap();
        let mut asker = asker_of(folder.path(), command.clone(), Limits::default());
        let query = format!("{COMMENT}, holds('Stroke_e0-5', semco:recordLog, X)");
        assert_eq!(shown(&asker.ask(&query).unwrap()), ["pushed"]);
        assert_eq!(kept(folder.path()), 1);
        assert!(asker.ask(COMMENT).unwrap().holds(), "it is known already");
        assert_eq!(kept(folder.path()), 1);
        let mut later = asker_of(folder.path(), command, Limits::default());
        let told = later.ask("holds(S, semco:recordLog, pushed)").unwrap();
        assert_eq!(shown(&told), ["semco:'Stroke_e0-5'"]);
    }
}

#[test]
fn a_query_that_does_not_end_well_tells_nothing() {
    let limits = Limits {
        time: Duration::from_secs(5),
        ..Limits::default()
    };
    for command in engines() {
        let folder = tempfile::tempdir().unwrap();
        let mut asker = asker_of(folder.path(), command, limits);
        for query in [
            format!("{COMMENT}, fail"),
            format!("{COMMENT}, X is foo + 1"),
            format!("{COMMENT}, has_type(_, 'Colision')"),
            format!("{COMMENT}, forall(between(1, 1000000000000, X), X > 0)"),
        ] {
            let holds = asker.ask(&query).is_ok_and(|answers| answers.holds());
            assert!(!holds, "{query}");
            assert_eq!(kept(folder.path()), 0, "{query}");
            let told = asker.ask("holds(_, semco:recordLog, X)").unwrap();
            assert_eq!(shown(&told), [""; 0], "{query}");
        }
    }
}

#[test]
fn a_query_tells_no_more_than_it_may_answer() {
    let limits = Limits {
        answers: 5,
        ..Limits::default()
    };
    for command in engines() {
        let folder = tempfile::tempdir().unwrap();
        let mut asker = asker_of(folder.path(), command, limits);
        let tell = |count| {
            format!("forall(between(1, {count}, X), tell(holds('Stroke_e0-5', semco:samples, X)))")
        };
        let error = asker.ask(&tell(6)).expect_err("six are too many");
        assert!(
            matches!(&error, AskError::Fault(QueryFault::Prolog { what }) if what.contains("more than 5")),
            "{error}"
        );
        assert_eq!(kept(folder.path()), 0);
        assert!(asker.ask(&tell(5)).unwrap().holds());
        assert_eq!(kept(folder.path()), 5);
    }
}

#[test]
fn what_would_not_be_seen_is_refused() {
    for command in engines() {
        let mut asker = asker(command);
        for query in [
            "tell(holds('Stroke_e0-5', rdf:type, semco:'Collision'))",
            "tell(has_type('Stroke_e0-5', semco:'Collision'))",
            "tell(holds('Stroke_e0-5', dul:hasConstituent, 'Stroke_e0-5'))",
            "tell(holds('Stroke_e0-5', semco:recordLog, _))",
            "tell(holds('Stroke_e0-5', semco:recordLog, f(x)))",
        ] {
            let result = asker.ask(query);
            assert!(
                matches!(result, Err(AskError::Fault(_))),
                "{query}: {result:?}"
            );
        }
    }
}

#[test]
fn a_line_that_was_cut_off_is_passed_over_and_replaced() {
    for command in engines() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("told.jsonl");
        let whole = "[\"semco:Stroke_e0-5\",\"semco:recordLog\",\"first\"]\n";
        fs::write(&file, format!("{whole}[\"semco:Stroke_e0-5\",\"rdfs:co")).unwrap();
        let mut asker = asker_of(folder.path(), command, Limits::default());
        assert!(asker.ask(COMMENT).unwrap().holds());
        let told = asker.ask("holds(_, semco:recordLog, X)").unwrap();
        assert_eq!(shown(&told), ["first", "pushed"]);
        let text = fs::read_to_string(&file).unwrap();
        assert!(
            text.starts_with(whole) && text.lines().count() == 2,
            "{text}"
        );
    }
}
