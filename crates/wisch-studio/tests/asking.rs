//! Queries.

use crate::place::{ID, Place};
use serde_json::{Value, json};
use std::path::PathBuf;
use wisch_memory::ask::EngineCommand;
use wisch_studio::EXAMPLES;

/// Returns the installed engine, or `None`. With `CI=true` an engine must be installed.
fn engine() -> Option<PathBuf> {
    match EngineCommand::find() {
        Some(EngineCommand::Scryer(path) | EngineCommand::Swi(path)) => Some(path),
        None => {
            let is_needed = std::env::var("CI").is_ok_and(|set| set == "true");
            assert!(!is_needed, "neither wisch-prolog nor swipl is installed");
            eprintln!("NOT CHECKED: neither wisch-prolog nor swipl is installed");
            None
        }
    }
}

fn ask(place: &Place, query: &str) -> Value {
    let answer = place.post("api/ask", &json!({ "query": query }).to_string());
    assert_eq!(answer.status, 200, "{}", answer.text());
    answer.json()
}

#[test]
fn answers_list_the_intervals_that_they_mention() {
    let Some(engine) = engine() else { return };
    let place = Place::with_engine(Some(engine));
    let query = "owl_individual_of(C, semco:'Collision'), occurs(C, [S, E])";
    assert_eq!(ask(&place, query)["holds"], false);
    // The next query finds an episode that was stored in the meantime.
    place.keep(ID, None);
    let reply = ask(&place, query);
    assert_eq!(reply["columns"], json!(["C", "S", "E"]));
    assert_eq!(reply["rows"][0][1], 1003.0);
    assert_eq!(reply["about"][0][0]["episode"], ID);
    assert_eq!(reply["about"][0][0]["interval"], json!([1003.0, 1004.5]));
    assert_eq!(reply["view"]["episodes"][0]["rounds"], json!([1000.0]));
    assert_eq!(reply["more"], false);
}

#[test]
fn errors_of_a_query_have_a_position() {
    let Some(engine) = engine() else { return };
    let place = Place::with_engine(Some(engine));
    for (query, words, offset, length) in [
        ("low_performance(A P)", "not valid Prolog", 18, 1),
        ("occur(A, [S, E])", "unknown predicate occur/2", 0, 5),
        (
            "true,\n owl_individual_of(C, semco:'Colision')",
            "Colision",
            28,
            16,
        ),
    ] {
        let fault = &ask(&place, query)["error"];
        let message = fault["message"].as_str().unwrap_or_default();
        assert!(message.contains(words), "{query}: {fault}");
        assert_eq!(
            (&fault["offset"], &fault["length"]),
            (&json!(offset), &json!(length)),
            "{query}"
        );
    }
    // The next query is answered.
    assert_eq!(ask(&place, "X = 1")["rows"], json!([[1]]));
}

#[test]
fn forbidden_predicates_and_limits_are_enforced() {
    let Some(engine) = engine() else { return };
    let place = Place::with_engine(Some(engine));
    for query in [
        "shell('true')",
        "open('/etc/passwd', read, S)",
        "halt",
        "consult(user)",
    ] {
        let reply = ask(&place, query);
        assert!(reply["error"]["message"].is_string(), "{query}: {reply}");
    }
    let many = ask(&place, "between(1, 5000, X)");
    assert_eq!(many["rows"].as_array().unwrap().len(), 1000);
    assert_eq!(many["more"], true);
    let few = json!({ "query": "between(1, 5000, X)", "limit": 3 }).to_string();
    let few = place.post("api/ask", &few).json();
    assert_eq!(
        (few["rows"].as_array().unwrap().len(), &few["more"]),
        (3, &json!(true))
    );
    let long = json!({ "query": "x".repeat(30_000) }).to_string();
    assert_eq!(place.post("api/ask", &long).status, 413);
}

#[test]
fn every_example_query_is_valid() {
    let Some(engine) = engine() else { return };
    let place = Place::with_engine(Some(engine));
    for (title, query) in EXAMPLES {
        let reply = ask(&place, query);
        assert!(reply["error"].is_null(), "{title}: {reply}");
    }
    place.keep(ID, None);
    let paper = &ask(&place, EXAMPLES[0].1);
    assert_eq!(paper["rows"].as_array().unwrap().len(), 1, "{paper}");
}

#[test]
fn a_missing_engine_is_reported() {
    let place = Place::with_engine(Some(PathBuf::from("/nowhere/wisch-prolog")));
    let fault = &ask(&place, "true")["error"]["message"];
    assert!(fault.as_str().unwrap().contains("Prolog engine"), "{fault}");
}

#[test]
fn the_vocabulary_lists_classes_properties_and_predicates() {
    let words = Place::new().get("api/vocabulary").json();
    let has = |list: &str, name: &str| {
        let names = words[list].as_array().unwrap().iter();
        names.filter(|one| one["name"] == name).count() == 1
    };
    assert!(has("classes", "semco:HumanCollision"));
    assert!(has("properties", "semco:usesTool"));
    assert!(has("individuals", "semco:sponge"));
    assert!(has("predicates", "low_performance"));
}
