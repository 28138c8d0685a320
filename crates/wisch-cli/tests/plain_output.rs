//! Output that programs and terminals can rely on: one JSON object, no control characters, the place that is meant.

use crate::program::{folder_with, wisch};
use serde_json::Value;
use std::fs;

const FLOATING: &str = "<robot name=\"arm\"><link name=\"odom\"/><link name=\"base\"/>\
    <joint name=\"j\" type=\"floating\"><parent link=\"odom\"/><child link=\"base\"/></joint></robot>";

#[test]
fn a_report_with_an_error_is_one_object() {
    let folder = tempfile::tempdir().unwrap();
    let ball = FLOATING.replace("floating", "ball");
    fs::write(folder.path().join("arm.urdf"), ball).unwrap();
    let (code, out, error) = wisch(folder.path(), &["robot", "check", "arm.urdf", "--json"]);
    assert_eq!(code, 2, "{error}");
    let report: Value = serde_json::from_str(&out).expect("one object");
    assert_eq!(report["errors"], 1);
    let findings = report["findings"].as_array().expect("an array");
    assert!(findings.iter().any(|found| found["fault"] == "joint-type"));
    assert!(error.contains("the robot cannot be loaded"), "{error}");
}

#[test]
fn control_characters_of_a_file_reach_neither_stream() {
    // A terminal's "control sequence introducer", and a mark that turns the direction of writing.
    let folder = folder_with("arm-board.toml");
    let bad = FLOATING
        .replace("name=\"arm\"", "name=\"arm\u{9b}31m\u{202e}\"")
        .replace("floating", "continuous");
    fs::write(folder.path().join("arm.urdf"), bad).unwrap();
    let path = folder.path().join("bad.toml");
    let text = fs::read_to_string(folder.path().join("task.toml")).unwrap();
    fs::write(&path, format!("\"\\u001b[2Jx\\u009b\\u202e\" = 1\n{text}")).unwrap();
    let lines: [&[&str]; 5] = [
        &["run", "task.toml", "--json", "--events", "-"],
        &["robot", "check", "arm.urdf"],
        &["robot", "check", "arm.urdf", "--json"],
        &["check", "bad.toml"],
        &["run", "bad.toml", "--json"],
    ];
    for args in lines {
        let (code, out, error) = wisch(folder.path(), args);
        assert_ne!(code, 0, "{args:?}: {error}");
        for text in [&out, &error] {
            let is_control = |c: char| c.is_control() && c != '\n' || c == '\u{202e}';
            assert!(!text.contains(is_control), "{args:?}: {text:?}");
        }
        if args.contains(&"--json") {
            serde_json::from_str::<Value>(&out).expect("one object");
        }
    }
}

#[test]
fn what_the_knowledge_lacks_is_named_where_it_stands_with_what_would_do() {
    let folder = tempfile::tempdir().unwrap();
    let task = |medium: &str, surface: &str| {
        format!(
            "schema = 1\nname = \"whiteboard\"\naction = \"absorb\"\n\n[tool]\nname = \"eraser\"\nfootprint_m = [0.06, 0.12]\n\n\
             [medium]\nname = \"marker\"\n{medium}\n[surface]\nname = \"whiteboard\"\n{surface}\nsize_m = [0.6, 0.4]\n\n\
             [particles]\nsource = \"uniform\"\ncount = 20\n"
        )
    };
    for (text, expected) in [
        (
            task("", "friction = 0.3"),
            ["task.toml:10:8: unknown medium \"marker\"", "or give kind"],
        ),
        (
            task("kind = \"powder\"", ""),
            [
                "task.toml:13:8: unknown surface \"whiteboard\"",
                "or give friction",
            ],
        ),
        (
            task("kind = \"powder\"", "friction = 0.3").replace("footprint_m = [0.06, 0.12]", ""),
            [
                "task.toml:6:8: unknown tool \"eraser\"",
                "or give footprint_m or mesh",
            ],
        ),
    ] {
        fs::write(folder.path().join("task.toml"), text).unwrap();
        let (code, _, error) = wisch(folder.path(), &["check", "task.toml"]);
        assert_eq!(code, 2, "{error}");
        for part in expected {
            assert!(error.contains(part), "{part}: {error}");
        }
    }
}
