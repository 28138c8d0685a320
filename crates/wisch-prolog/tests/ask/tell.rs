//! What queries add to a memory: all that a query tells that ends well, nothing of another.

use super::{asker, engines, memory, shown};
use std::fs;
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;
use wisch_memory::ask::{
    AskError, AskLimits, Assertions, EngineCommand, QueryFault, QuerySession, TelemetryPredicates,
};
use wisch_memory::{Catalogue, Memory};

const COMMENT: &str = "tell(holds('Stroke_e0-5', semco:recordLog, pushed))";

fn asker_of(folder: &Path, command: EngineCommand, limits: AskLimits) -> QuerySession {
    QuerySession::new(
        command,
        limits,
        Arc::new(Catalogue::from_records(&memory::episodes())),
        TelemetryPredicates::default(),
        Assertions::read(folder).unwrap(),
    )
}

/// How many statements a memory keeps.
fn kept(folder: &Path) -> usize {
    fs::read_to_string(folder.join("told.jsonl")).map_or(0, |text| text.lines().count())
}

#[test]
fn a_statement_of_tell_is_kept_if_the_query_succeeds() {
    for command in engines() {
        let folder = tempfile::tempdir().unwrap();
        let mut asker = asker_of(folder.path(), command.clone(), AskLimits::default());
        let query = format!("{COMMENT}, holds('Stroke_e0-5', semco:recordLog, X)");
        assert_eq!(shown(&asker.ask(&query).unwrap()), ["pushed"]);
        assert_eq!(kept(folder.path()), 1);
        assert!(asker.ask(COMMENT).unwrap().holds(), "it is known already");
        assert_eq!(kept(folder.path()), 1);
        let mut later = asker_of(folder.path(), command, AskLimits::default());
        let told = later.ask("holds(S, semco:recordLog, pushed)").unwrap();
        assert_eq!(shown(&told), ["semco:'Stroke_e0-5'"]);
    }
}

#[test]
fn a_query_that_does_not_end_well_tells_nothing() {
    let limits = AskLimits {
        time: Duration::from_secs(5),
        ..AskLimits::default()
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
    let limits = AskLimits {
        answers: 5,
        ..AskLimits::default()
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
fn statements_about_an_episode_are_deleted_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let memory = Memory::create(folder.path()).unwrap();
    for record in memory::episodes().into_iter().take(2) {
        memory.begin(&record.id).unwrap().commit(&record).unwrap();
    }
    let told =
        |asker: &mut QuerySession| shown(&asker.ask("holds(_, semco:recordLog, X)").unwrap());
    for command in engines() {
        let mut asker = QuerySession::open(memory.clone(), command.clone()).unwrap();
        asker
            .ask("tell(holds('Stroke_e0-5', semco:recordLog, first))")
            .unwrap();
        asker
            .ask("tell(holds('Stroke_e1-5', semco:recordLog, second))")
            .unwrap();
        asker
            .ask("tell(holds('Stroke_e1-5', dul:hasParticipant, 'HumanCollision_e0-7'))")
            .unwrap();
        assert_eq!(told(&mut asker), ["first", "second"]);
        memory.forget("e0").unwrap();
        assert_eq!(
            kept(folder.path()),
            1,
            "what was told of e0 is gone for good"
        );
        let mut asker = QuerySession::open(memory.clone(), command.clone()).unwrap();
        assert_eq!(told(&mut asker), ["second"]);
        // A killed program may have left it: it is answered no more.
        let path = folder.path().join("told.jsonl");
        let text = fs::read_to_string(&path).unwrap();
        fs::write(
            &path,
            text + "[\"semco:Stroke_e0-5\",\"semco:recordLog\",\"first\"]\n",
        )
        .unwrap();
        let mut asker = QuerySession::open(memory.clone(), command).unwrap();
        assert_eq!(told(&mut asker), ["second"]);
        memory
            .begin("e0")
            .unwrap()
            .commit(&memory::episodes()[0])
            .unwrap();
        fs::remove_file(&path).unwrap();
    }
}

#[test]
fn tell_refuses_numbers_that_are_not_finite() {
    for command in engines() {
        let folder = tempfile::tempdir().unwrap();
        let mut asker = asker_of(folder.path(), command, AskLimits::default());
        for number in ["inf", "nan", "'1.5NaN'", "'-inf'", "infinite"] {
            let query = format!("tell(holds('Stroke_e0-5', semco:peakForce, {number}))");
            let error = asker.ask(&query).expect_err(&query).to_string();
            assert!(error.contains("must be finite"), "{query}: {error}");
        }
        let computed = asker.ask("X is inf, tell(holds('Stroke_e0-5', semco:peakForce, X))");
        assert!(computed.is_err(), "{computed:?}");
        assert_eq!(kept(folder.path()), 0);
        // A file that another program wrote.
        fs::write(
            folder.path().join("told.jsonl"),
            "[\"semco:Stroke_e0-5\",\"semco:peakForce\",null]\n",
        )
        .unwrap();
        let error = Assertions::read(folder.path()).unwrap_err().to_string();
        assert!(
            error.contains("line 1") && error.contains("finite number"),
            "{error}"
        );
    }
}

#[test]
fn an_added_value_stands_beside_the_recorded_one() {
    for command in engines() {
        let folder = tempfile::tempdir().unwrap();
        let mut asker = asker_of(folder.path(), command.clone(), AskLimits::default());
        let in_words = "tell(holds('WipingRound_e0-3', semco:performance, bad))";
        let error = asker.ask(in_words).expect_err(in_words).to_string();
        assert!(error.contains("semco:performance is a number"), "{error}");
        let both = "performance_by_round('WipingAction_e0-1', 1, P)";
        let told = "tell(holds('WipingRound_e0-3', semco:performance, 0.99))";
        let told = asker.ask(&format!("{told}, {both}")).unwrap();
        assert_eq!(shown(&told), ["0.75", "0.99"]);
        let mut later = asker_of(folder.path(), command.clone(), AskLimits::default());
        assert_eq!(shown(&later.ask(both).unwrap()), ["0.75", "0.99"]);
        // A neighbour of what a query reads first.
        let other = "tell(holds('WipingRound_e3-3', semco:performance, 0.3))";
        assert!(later.ask(other).unwrap().holds());
        let mut later = asker_of(folder.path(), command, AskLimits::default());
        let low = later.ask("low_performance_round(R, P)").unwrap();
        let low = shown(&low);
        assert_eq!(low.len(), 5, "{low:?}");
        assert!(
            low.contains(&"semco:'WipingRound_e3-3' 0.3".to_owned()),
            "{low:?}"
        );
        let low = later.ask("low_performance_round('WipingRound_e0-3', P)");
        assert_eq!(shown(&low.unwrap()), ["0.75"], "99 % is not low");
        let remarks = later.remarks_on_memory().join("\n");
        let besides = "semco:performance of semco:WipingRound_e0-3 is 0.99, recorded 0.75";
        assert!(remarks.contains(besides), "{remarks}");
        let timed = later.ask("last_episode(E, T)").unwrap().remarks.join("\n");
        let undated = "the dates of these episodes are unknown";
        assert!(timed.contains(undated), "{timed}");
    }
}

#[test]
fn what_would_not_be_seen_is_refused() {
    for command in engines() {
        let mut asker = asker(command);
        for query in [
            "tell(holds('Stroke_e0-5', rdf:type, semco:'Collision'))",
            "tell(has_type('Stroke_e0-5', semco:'Collision'))",
            "tell(holds(semco:'Sponge', rdfs:subClassOf, semco:'Collision'))",
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

/// A text with a colon and the name of a thing.
const NOTE: &str = "at 10:30, a visitor leaned on the arm";

#[test]
fn notes_on_an_event_are_texts_that_queries_find() {
    for command in engines() {
        let folder = tempfile::tempdir().unwrap();
        let mut asker = asker_of(folder.path(), command.clone(), AskLimits::default());
        let query = format!(
            "tell([holds('HumanCollision_e0-7', rdfs:comment, '{NOTE}'), \
             holds('HumanCollision_e0-7', rdfs:label, sponge)])"
        );
        assert!(asker.ask(&query).unwrap().holds());
        assert!(asker.ask(&query).unwrap().holds(), "they are known already");
        assert_eq!(kept(folder.path()), 2);
        let mut later = asker_of(folder.path(), command, AskLimits::default());
        for asker in [&mut asker, &mut later] {
            let event = "semco:'HumanCollision_e0-7'";
            for query in [
                "holds(E, rdfs:label, sponge)".to_owned(),
                format!("holds(E, rdfs:comment, '{NOTE}')"),
                "human_collision(_, E, _), holds(E, rdfs:comment, _)".to_owned(),
                "triple(E, P, O), P == 'rdfs:label', O == sponge".to_owned(),
            ] {
                let found = asker.ask(&query).unwrap();
                let found: Vec<String> = found.rows.iter().map(|row| row[0].to_string()).collect();
                assert!(found.contains(&event.to_owned()), "{query}: {found:?}");
            }
            let text = asker.ask(&format!("holds({event}, rdfs:comment, Text)"));
            assert_eq!(shown(&text.unwrap()), [format!("'{NOTE}'")]);
        }
    }
}

#[test]
fn a_new_individual_has_its_class_and_statements() {
    for command in engines() {
        let folder = tempfile::tempdir().unwrap();
        let mut asker = asker_of(folder.path(), command.clone(), AskLimits::default());
        let tools = "findall(T, has_type(T, semco:'Sponge'), Ts), member(semco:blue_sponge, Ts)";
        let tools = tools.replace("semco:blue_sponge", "'semco:blue_sponge'");
        assert!(!asker.ask(&tools).unwrap().holds());
        let tell = "tell([has_type(semco:blue_sponge, semco:'Sponge'), holds(blue_sponge, rdfs:comment, 'bought in May')])";
        // A query without an answer adds nothing.
        assert!(!asker.ask(&format!("{tell}, fail")).unwrap().holds());
        assert!(asker.ask("holds(blue_sponge, rdfs:comment, _)").is_err());
        assert!(asker.ask(&format!("{tell}, {tools}")).unwrap().holds());
        assert!(asker.ask(tell).unwrap().holds(), "it is known already");
        assert_eq!(kept(folder.path()), 2);
        let mut later = asker_of(folder.path(), command, AskLimits::default());
        for asker in [&mut asker, &mut later] {
            assert!(asker.ask(&tools).unwrap().holds());
            let of_class = asker.ask("has_type(semco:blue_sponge, semco:'WipingTool')");
            assert!(of_class.unwrap().holds());
            let note = asker.ask("has_type(T, semco:'Sponge'), holds(T, rdfs:comment, Text)");
            assert_eq!(shown(&note.unwrap()), ["semco:blue_sponge 'bought in May'"]);
            let statements =
                asker.ask("triple(semco:blue_sponge, P, O), P == 'rdf:type', O == 'semco:Sponge'");
            assert_eq!(statements.unwrap().rows.len(), 1);
        }
    }
}

#[test]
fn errors_of_tell_name_the_limit() {
    for command in engines() {
        let folder = tempfile::tempdir().unwrap();
        let mut asker = asker_of(folder.path(), command, AskLimits::default());
        let long = "x".repeat(2001);
        for (query, part) in [
            (
                format!("tell(holds('Stroke_e0-5', rdfs:comment, '{long}'))"),
                "has 2001 characters, but tell stores at most 2000",
            ),
            (
                format!("tell(has_type(semco:{}, semco:'Sponge'))", &long[..101]),
                "has 101 characters, but a new individual has at most 100",
            ),
            (
                "tell(has_type(semco:'blue sponge', semco:'Sponge'))".to_owned(),
                "letters, digits, _, - and .",
            ),
            (
                "tell(has_type(dul:blue, semco:'Sponge'))".to_owned(),
                "have the prefix semco",
            ),
            (
                "tell(has_type(semco:'Sponge_e9-1', semco:'Sponge'))".to_owned(),
                "belong to episodes",
            ),
            (
                "tell(has_type(semco:visit, semco:'HumanCollision'))".to_owned(),
                "class of events, which only episodes add",
            ),
            (
                "tell(has_type(semco:sponge, semco:'WipingRobot'))".to_owned(),
                "tell cannot make it a semco:WipingRobot",
            ),
            (
                "tell(has_type(semco:'Sponge', semco:'Sponge'))".to_owned(),
                "is a class or a property",
            ),
            (
                "tell(has_type(semco:blue, semco:'Spong'))".to_owned(),
                "Sponge",
            ),
        ] {
            let error = asker.ask(&query).expect_err(&query).to_string();
            assert!(error.contains(part), "{query}: {error}");
        }
        assert_eq!(kept(folder.path()), 0);
        let file = folder.path().join("told.jsonl");
        fs::write(&file, "[\"semco:blue\",\"rdf:type\",\"semco:Spong\"]\n").unwrap();
        let error = Assertions::read(folder.path()).unwrap_err().to_string();
        assert!(
            error.contains("line 1") && error.contains("which is no class"),
            "{error}"
        );
    }
}

#[test]
fn a_line_that_was_cut_off_is_passed_over_and_replaced() {
    for command in engines() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("told.jsonl");
        let whole = "[\"semco:Stroke_e0-5\",\"semco:recordLog\",\"first\"]\n";
        fs::write(&file, format!("{whole}[\"semco:Stroke_e0-5\",\"rdfs:co")).unwrap();
        let mut asker = asker_of(folder.path(), command, AskLimits::default());
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
