//! Episodes: listed and sent, even if others are damaged.

use crate::place::{ID, OTHER, Place, packed};
use serde_json::json;
use std::fs;
use wisch_memory::health::{DescribedHealth, assess_groups, gather_groups};

const LINES: &str =
    "{\"piece\":\"head\",\"title\":\"board\"}\n{\"piece\":\"ended\",\"met\":true}\n";

fn listed(place: &Place) -> Vec<String> {
    let overview = place.get("api/overview").json();
    let episodes = overview["list"]["episodes"].as_array().unwrap().iter();
    episodes
        .map(|one| one["id"].as_str().unwrap().to_owned())
        .collect()
}

#[test]
fn episodes_are_listed_with_their_results() {
    let place = Place::new();
    assert_eq!(listed(&place), [""; 0]);
    place.keep(ID, Some(&packed(LINES)));
    place.keep(OTHER, None);
    let overview = place.get("api/overview").json();
    let episodes = &overview["list"]["episodes"];
    assert_eq!(overview["list"]["total"], 2);
    let first = episodes
        .as_array()
        .unwrap()
        .iter()
        .find(|one| one["id"] == ID)
        .unwrap();
    assert_eq!(first["title"], "board");
    assert_eq!(first["performance"], 0.75);
    assert_eq!(first["met"], true);
    assert_eq!(first["round_starts"], json!([0.0]));
    let push = json!({"class": "HumanCollision", "start": 3.0, "end": 4.5, "count": 1});
    assert_eq!(first["events"], json!([push]));
    assert_eq!(first["has_recording"], true);
    assert_eq!(overview["scenarios"][0]["name"], "board");
    let found = place.get("api/overview?find=abcd%20BOARD").json();
    assert_eq!(found["list"]["total"], 1);
    assert_eq!(
        place.get("api/overview?find=nothing").json()["list"]["total"],
        0
    );
}

#[test]
fn a_recording_is_sent_as_it_is_stored() {
    let place = Place::new();
    let kept = packed(LINES);
    place.keep(ID, Some(&kept));
    let path = format!("api/episodes/{ID}/recording");
    let zipped = place.get_with(&path, &[("Accept-Encoding", "br, gzip")]);
    assert_eq!(zipped.headers["content-encoding"], "gzip");
    assert_eq!(zipped.body, kept);
    let plain = place.get(&path);
    assert!(!plain.headers.contains_key("content-encoding"));
    assert_eq!(plain.text(), LINES);
}

#[test]
fn a_damaged_episode_is_reported_and_affects_no_other() {
    let place = Place::new();
    place.keep(ID, Some(&packed(LINES)));
    place.keep(OTHER, Some(&packed(LINES)));
    let recording = |id: &str| place.memory().folder().join(id).join("recording.jsonl.gz");
    fs::write(recording(ID), b"these are no lines").unwrap();
    let broken = place.get(&format!("api/episodes/{ID}/recording"));
    assert_eq!(broken.status, 500);
    assert!(
        broken.message().contains("recording.jsonl.gz"),
        "{}",
        broken.message()
    );
    assert_eq!(
        place.get(&format!("api/episodes/{OTHER}/recording")).status,
        200
    );
    assert_eq!(listed(&place).len(), 2);
}

#[test]
fn an_invalid_recording_is_reported() {
    let place = Place::new();
    place.keep(ID, Some(b"this was never packed"));
    let broken = place.get(&format!("api/episodes/{ID}/recording"));
    assert_eq!(broken.status, 500);
    assert!(broken.message().contains(ID), "{}", broken.message());
}

#[test]
fn an_episode_without_a_record_is_listed_as_damaged() {
    let place = Place::new();
    place.keep(ID, Some(&packed(LINES)));
    place.keep(OTHER, None);
    fs::write(place.memory().folder().join(ID).join("episode.json"), b"{").unwrap();
    let overview = place.get("api/overview").json();
    let why = overview["list"]["broken"][0].as_str().unwrap();
    assert!(why.contains(ID), "{why}");
    assert_eq!(listed(&place), [OTHER]);
    let without = place.get(&format!("api/episodes/{OTHER}/recording"));
    assert_eq!(without.status, 404);
    assert!(
        without.message().contains("no recording"),
        "{}",
        without.message()
    );
}

#[test]
fn no_path_leads_out_of_the_memory() {
    let place = Place::new();
    place.keep(ID, Some(&packed(LINES)));
    let outside = place.folder.path().join("outside");
    fs::create_dir(&outside).unwrap();
    fs::write(outside.join("recording.jsonl.gz"), packed("secret")).unwrap();
    fs::write(place.folder.path().join("secret.jsonl"), "secret\n").unwrap();
    fs::create_dir_all(place.live()).unwrap();
    fs::write(place.live().join(".hidden.jsonl"), "secret\n").unwrap();
    fs::write(place.memory().folder().join("secret.jsonl"), "secret\n").unwrap();
    let absolute = outside.display().to_string().replace('/', "%2F");
    for id in [
        "..%2Foutside",
        "..%2foutside",
        "%2e%2e%2Foutside",
        "..",
        "../../outside",
        ".new",
        ".live",
        &absolute,
        "a%00b",
        "..%5Coutside",
        "",
    ] {
        let answer = place.get(&format!("api/episodes/{id}/recording"));
        assert!(
            [400, 404].contains(&answer.status),
            "{id}: {}",
            answer.status
        );
        assert!(!answer.text().contains("secret"), "{id}");
    }
    for id in [
        "..%2Fsecret",
        "..%2F..%2Fsecret",
        ".hidden",
        "..%2F.live%2F.hidden",
        "%2e%2e%2fsecret",
    ] {
        let answer = place.get(&format!("api/runs/{id}/stream"));
        assert_eq!(answer.status, 404, "{id}");
        for action in ["stop", "clear"] {
            let answer = place.post(&format!("api/runs/{id}/{action}"), "{}");
            assert!(
                [404, 409].contains(&answer.status),
                "{id}: {}",
                answer.status
            );
        }
    }
    assert!(place.folder.path().join("secret.jsonl").is_file());
    assert!(place.live().join(".hidden.jsonl").is_file());
}

#[test]
fn the_health_is_the_json_of_the_command() {
    let place = Place::new();
    let empty = place.get("api/health").json();
    let none = "the memory has no rounds; wisch run adds an episode";
    assert_eq!(empty["words"]["summary"], none);
    for run in 0..14 {
        place.keep_round(run, -4e-4 * f64::from(run));
    }
    let groups = gather_groups(&place.memory().catalogue().unwrap());
    let expected = DescribedHealth::from(assess_groups(&groups));
    assert!(expected.report.needs_attention);
    let expected = serde_json::to_value(expected).unwrap();
    assert_eq!(place.get("api/health").json(), expected);
}
