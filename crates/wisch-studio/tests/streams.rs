//! Streams of live runs.

use crate::client::{Event, Events};
use crate::place::{ID, Place, packed, wait_until};
use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::PathBuf;

const LINES: usize = 400;

fn begin(place: &Place) -> String {
    fs::write(place.folder.path().join("lines"), LINES.to_string()).unwrap();
    let begun = place.post("api/runs", r#"{"task":"board"}"#);
    assert_eq!(begun.status, 201, "{}", begun.text());
    begun.json()["run"].as_str().unwrap().to_owned()
}

fn stream(place: &Place, id: &str, query: &str, headers: &[(&str, &str)]) -> Events {
    let path = format!("{}api/runs/{id}/stream{query}", place.base);
    Events::open(&place.address, &path, headers)
}

/// Checks that the events are all lines in order, each once, and then the end.
fn check(events: &[Event], from: usize) {
    let (last, lines) = events.split_last().unwrap();
    assert_eq!(last.kind, "end");
    assert!(last.data.contains("\"ended\""), "{}", last.data);
    let ids: Vec<usize> = lines
        .iter()
        .map(|event| event.id.parse().unwrap())
        .collect();
    // The head, the samples and the end.
    assert_eq!(ids, (from + 1..=LINES + 2).collect::<Vec<_>>());
    for event in lines.iter().filter(|event| event.data.contains("samples")) {
        let number: usize = event.id.parse().unwrap();
        assert_eq!(
            event.data,
            format!("{{\"piece\":\"samples\",\"n\":{}}}", number - 1)
        );
    }
}

#[test]
fn ten_readers_get_a_whole_run_and_one_that_reconnects_misses_nothing() {
    let place = Place::new();
    let id = begin(&place);
    std::thread::scope(|scope| {
        for _ in 0..10 {
            scope.spawn(|| {
                let events: Vec<Event> = stream(&place, &id, "", &[]).collect();
                check(&events, 0);
            });
        }
        scope.spawn(|| {
            let mut seen: Vec<Event> = Vec::new();
            // The connection breaks three times; the browser states the last line that it has.
            for part in [1, 57, 100] {
                let last = seen.last().map_or("0".to_owned(), |event| event.id.clone());
                let broken = stream(&place, &id, "?after=0", &[("Last-Event-ID", &last)]);
                seen.extend(broken.take(part));
            }
            let after = format!("?after={}", seen.len());
            seen.extend(stream(&place, &id, &after, &[]));
            check(&seen, 0);
        });
    });
}

#[test]
fn a_late_reader_gets_the_stored_recording() {
    let place = Place::new();
    let lines: String = (0..5)
        .map(|n| format!("{{\"piece\":\"samples\",\"n\":{n}}}\n"))
        .collect();
    let recording = packed(&(lines + "{\"piece\":\"ended\",\"met\":true}\n"));
    place.keep(ID, Some(&recording));
    let events: Vec<Event> = stream(&place, ID, "?after=4", &[]).collect();
    let ids: Vec<&str> = events.iter().map(|event| event.id.as_str()).collect();
    assert_eq!(ids, ["5", "6", ""]);
    assert!(events[2].data.contains("\"ended\""));
}

#[test]
fn a_line_is_sent_when_it_is_complete() {
    let place = Place::new();
    fs::create_dir_all(place.live()).unwrap();
    let file = place.live().join("odd.jsonl");
    fs::write(&file, "one\ntw").unwrap();
    // The process of this test stands for the run.
    let name = fs::read_to_string("/proc/self/comm").unwrap_or_default();
    let is_known = name.trim() == "wisch";
    let sidecar = format!("{{\"pid\":{},\"task\":\"odd\"}}", std::process::id());
    fs::write(place.live().join("odd.json"), sidecar).unwrap();
    let mut events = stream(&place, "odd", "", &[]);
    assert_eq!(events.next().unwrap().data, "one");
    let mut growing = OpenOptions::new().append(true).open(&file).unwrap();
    growing.write_all(b"o\nthree\r\n").unwrap();
    assert_eq!(events.next().unwrap().data, "two");
    assert_eq!(events.next().unwrap().data.trim_end(), "three");
    assert!(!is_known);
    // A process of another program is not a run.
    assert!(events.next().unwrap().data.contains("\"lost\""));
}

#[test]
fn a_run_that_breaks_off_is_reported_and_stays_readable() {
    let place = Place::new();
    fs::write(place.folder.path().join("dies"), "").unwrap();
    let id = begin(&place);
    let events: Vec<Event> = stream(&place, &id, "", &[]).collect();
    assert_eq!(events.len(), LINES + 2);
    assert!(events.last().unwrap().data.contains("\"lost\""));
    let run = || place.get("api/overview").json()["runs"][0].clone();
    wait_until("the run is lost", || {
        run()["state"] == "lost" && run()["own"] == false
    });
    assert_eq!(run()["message"], "error: out of luck");
    assert_eq!(stream(&place, &id, "", &[]).count(), LINES + 2);
    assert_eq!(
        place.post(&format!("api/runs/{id}/clear"), "{}").status,
        200
    );
    assert!(run().is_null());
    assert_eq!(stream(&place, &id, "", &[]).status, 404);
}

#[test]
fn the_number_of_streams_is_limited() {
    let place = Place::new();
    fs::write(place.folder.path().join("waits"), "").unwrap();
    let id = begin(&place);
    let open: Vec<Events> = (0..64).map(|_| stream(&place, &id, "", &[])).collect();
    assert!(open.iter().all(|events| events.status == 200));
    assert_eq!(stream(&place, &id, "", &[]).status, 503);
    drop(open);
    wait_until("streams are released", || {
        stream(&place, &id, "", &[]).status == 200
    });
    assert_eq!(place.post(&format!("api/runs/{id}/stop"), "{}").status, 202);
}

#[test]
fn the_overview_streams_changes() {
    let place = Place::new();
    let path = format!("{}api/overview/events", place.base);
    let mut events = Events::open(&place.address, &path, &[]);
    // The initial state counts as a change.
    assert_eq!(events.next().unwrap().kind, "changed");
    place.keep(ID, None);
    assert_eq!(events.next().unwrap().kind, "changed");
    let live: PathBuf = place.live();
    fs::create_dir_all(&live).unwrap();
    fs::write(live.join("one.jsonl"), "{}\n").unwrap();
    assert_eq!(events.next().unwrap().kind, "changed");
}
