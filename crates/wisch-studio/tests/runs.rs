//! Runs that the studio starts and stops.

use crate::place::{Place, wait_until};
use serde_json::Value;
use std::fs;

fn waiting() -> Place {
    let place = Place::new();
    fs::write(place.folder.path().join("waits"), "").unwrap();
    fs::write(place.folder.path().join("lines"), "3").unwrap();
    place
}

fn runs(place: &Place) -> Vec<Value> {
    place.get("api/overview").json()["runs"]
        .as_array()
        .unwrap()
        .clone()
}

#[test]
fn a_run_is_started_with_its_options_and_stopped() {
    let place = waiting();
    let order = r#"{"task":"board","seed":7,"strategy":"grid"}"#;
    let begun = place.post("api/runs", order);
    assert_eq!(begun.status, 201, "{}", begun.text());
    let id = begun.json()["run"].as_str().unwrap().to_owned();
    let calls = fs::read_to_string(place.folder.path().join("calls")).unwrap();
    assert!(calls.starts_with("run --live --quiet"), "{calls}");
    assert!(
        calls
            .trim_end()
            .ends_with("--seed 7 --strategy grid -- board"),
        "{calls}"
    );
    let run = &runs(&place)[0];
    assert_eq!(
        (&run["id"], &run["state"], &run["own"]),
        (&Value::from(id.as_str()), &"running".into(), &true.into())
    );
    assert_eq!(
        place.post(&format!("api/runs/{id}/clear"), "{}").status,
        409,
        "the run is live"
    );
    assert_eq!(place.post(&format!("api/runs/{id}/stop"), "{}").status, 202);
    wait_until("the run ends", || runs(&place).is_empty());
    assert_eq!(place.post(&format!("api/runs/{id}/stop"), "{}").status, 404);
}

#[test]
fn invalid_tasks_are_refused_with_a_reason() {
    let place = waiting();
    let file = place.folder.path().join("text.txt");
    fs::write(&file, "").unwrap();
    for (task, words) in [
        ("fails".to_owned(), "there is no task fails"),
        (
            "nothing".to_owned(),
            "neither a shipped task nor a task file",
        ),
        (
            file.display().to_string(),
            "neither a shipped task nor a task file",
        ),
        ("/nowhere/task.toml".to_owned(), "/nowhere/task.toml"),
        (
            "--help".to_owned(),
            "neither a shipped task nor a task file",
        ),
    ] {
        let order = serde_json::json!({ "task": task }).to_string();
        let answer = place.post("api/runs", &order);
        assert_eq!(answer.status, 422, "{task}");
        assert!(
            answer.message().contains(words),
            "{task}: {}",
            answer.message()
        );
    }
    let strategy = place.post("api/runs", r#"{"task":"board","strategy":"--resume"}"#);
    assert_eq!(strategy.status, 422);
    for body in ["{", r#"{"task":1}"#, r#"{"task":"board","more":1}"#, ""] {
        let status = place.post("api/runs", body).status;
        assert!([400, 422].contains(&status), "{body}: {status}");
    }
    let long = format!("{{\"task\":\"{}\"}}", "x".repeat(100_000));
    assert_eq!(place.post("api/runs", &long).status, 413);
    assert_eq!(place.get("api/runs").status, 405);
}

#[test]
fn the_number_of_runs_is_limited() {
    let place = waiting();
    for _ in 0..4 {
        assert_eq!(place.post("api/runs", r#"{"task":"board"}"#).status, 201);
    }
    let refused = place.post("api/runs", r#"{"task":"board"}"#);
    assert_eq!(refused.status, 429);
    assert!(refused.message().contains('4'), "{}", refused.message());
}

#[test]
fn the_studio_stops_its_runs_when_it_ends() {
    let mut place = waiting();
    let begun = place.post("api/runs", r#"{"task":"board"}"#).json();
    let id = begun["run"].as_str().unwrap();
    let lines = place.live().join(format!("{id}.jsonl"));
    assert!(lines.is_file());
    place.end();
    // The run has removed its files, as after a termination signal.
    assert!(!lines.exists());
}

#[test]
fn a_process_of_another_program_is_not_stopped() {
    let place = waiting();
    let mut sleeping = std::process::Command::new("sleep")
        .arg("60")
        .spawn()
        .unwrap();
    fs::create_dir_all(place.live()).unwrap();
    fs::write(place.live().join("odd.jsonl"), "{}\n").unwrap();
    let sidecar = format!("{{\"pid\":{},\"task\":\"odd\"}}", sleeping.id());
    fs::write(place.live().join("odd.json"), sidecar).unwrap();
    assert_eq!(place.post("api/runs/odd/stop", "{}").status, 409);
    assert!(
        sleeping.try_wait().unwrap().is_none(),
        "the process is still running"
    );
    sleeping.kill().unwrap();
    sleeping.wait().unwrap();
}
