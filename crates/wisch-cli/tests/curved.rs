//! Surfaces that are rolled onto a cylinder or a cone.

use crate::program::command;
use std::fs;
use std::path::Path;
use std::process::Output;

/// Runs a command on the template's task, on a cylinder of a radius \[m\] unless it is a plane.
fn wisch(folder: &Path, words: &[&str], radius: Option<&str>) -> Output {
    let mut command = command(folder);
    command.arg(words[0]).arg("task.toml").args(&words[1..]);
    match radius {
        Some(radius) => command
            .args(["--set", "surface.shape=cylinder", "--set"])
            .arg(format!("surface.radius_m={radius}")),
        None => command.args(["--set", "surface.shape=plane"]),
    };
    command.output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let made = command(folder.path()).args(["new", "task.toml"]).output();
    assert!(made.unwrap().status.success());
    // A cup stands on the template's board.
    let path = folder.path().join("task.toml");
    let text = fs::read_to_string(&path).unwrap();
    let (text, _) = text.split_once("\n[[scene]]").unwrap();
    let lines = text.lines().filter(|line| !line.starts_with("carried_by"));
    fs::write(&path, lines.collect::<Vec<_>>().join("\n")).unwrap();
    folder
}

#[test]
fn a_plan_on_a_cylinder_is_that_of_the_plane_and_names_the_shape() {
    let folder = folder();
    let plan = |out: &str, radius: Option<&str>| {
        let words = ["plan", "--strategy", "grid", "--out", out];
        let done = wisch(folder.path(), &words, radius);
        assert!(done.status.success(), "{}", text(&done.stderr));
        fs::read_to_string(folder.path().join(out).join("plan.json")).unwrap()
    };
    let (flat, bent) = (plan("flat", None), plan("bent", Some("2.0")));
    assert!(!flat.contains("surface_shape"));
    let start = bent.find("  \"surface_shape\"").expect("the shape");
    let contact = start + bent[start..].find("\"bend_contact\"").unwrap();
    let end = contact + bent[contact..].find("},").unwrap() + 3;
    for key in ["\"radius_m\": 2.0", "\"touched_share_least\": 1.0"] {
        assert!(bent[start..end].contains(key), "{bent}");
    }
    assert_eq!([&bent[..start], &bent[end..]].concat(), flat);
}

#[test]
fn a_plan_for_a_cylinder_is_refused_on_a_plane() {
    let folder = folder();
    let words = ["plan", "--strategy", "grid", "--out", "bent"];
    let done = wisch(folder.path(), &words, Some("2.0"));
    assert!(done.status.success(), "{}", text(&done.stderr));
    let done = wisch(
        folder.path(),
        &["predict", "--plan", "bent/plan.json"],
        None,
    );
    assert_eq!(done.status.code(), Some(2));
    let err = text(&done.stderr);
    assert!(err.contains("surface shape"), "{err}");
}

#[test]
fn a_check_names_the_cylinder() {
    let folder = folder();
    let done = wisch(folder.path(), &["check"], Some("-2.0"));
    let found = text(&done.stdout);
    assert!(
        found.contains("cylinder of radius -2 m whose axis is at 0° to x"),
        "{found}"
    );
}

/// A hard tool touches a part of a bend. What it cannot touch counts as wiped nowhere.
#[test]
fn check_and_plan_state_which_share_of_a_rigid_tool_touches() {
    let folder = folder();
    let rigid = [
        "--strategy",
        "grid",
        "--set",
        "interaction.compression_depth_m=0",
    ];
    let done = wisch(
        folder.path(),
        &[&["check"][..], &rigid].concat(),
        Some("0.5"),
    );
    let found = text(&done.stdout);
    for part in [
        "% of the tool touches the bend, depending on its yaw",
        "for a compression of 0.1 mm",
        "a tool square to the bend and at most 0.024 m long across it would touch everywhere",
    ] {
        assert!(found.contains(part), "{found}{}", text(&done.stderr));
    }
    let words = [&["plan", "--json", "--out", "rigid"][..], &rigid].concat();
    let done = wisch(folder.path(), &words, Some("0.5"));
    let summary: serde_json::Value = serde_json::from_slice(&done.stdout).expect("a summary");
    let share = |key: &str| summary["bend_contact"][key].as_f64().expect("a number");
    assert!(share("touched_share_least") < 0.5 && share("touched_share_most") < 0.7);
    let done = wisch(
        folder.path(),
        &["plan", "--strategy", "grid", "--out", "soft"],
        Some("2.0"),
    );
    assert!(text(&done.stdout).contains("the whole tool touches the bend at every yaw"));
}

/// Page, figures, bag and episode of a run on a cylinder show or state its shape.
#[test]
fn a_run_on_a_cylinder_keeps_its_shape() {
    let folder = folder();
    let words = [
        "run",
        "--strategy",
        "kde",
        "--rounds",
        "1",
        "--seed",
        "1",
        "--out",
        "out",
    ];
    let done = wisch(folder.path(), &words, Some("2.0"));
    assert!(
        matches!(done.status.code(), Some(0 | 1)),
        "{}",
        text(&done.stderr)
    );
    let read = |name: &str| fs::read(folder.path().join("out").join(name)).unwrap();
    let page = text(&read("report.html"));
    assert!(page.contains(r#""shape":{"kind":"cylinder","radius_m":2.0,"axis_rad":0.0}"#));
    assert!(text(&read("figures/graph.svg")).contains("unrolled surface"));
    assert!(text(&read("plan.json")).contains("\"radius_m\": 2.0"));
    // Its bag is read again, on the same surface.
    let words = ["interpret", "out/telemetry/round-1.mcap", "--task"];
    let again = command(folder.path())
        .args(words)
        .args([
            "task.toml",
            "--set",
            "surface.shape=cylinder",
            "--set",
            "surface.radius_m=2.0",
        ])
        .output()
        .unwrap();
    assert!(
        matches!(again.status.code(), Some(0 | 1)),
        "{}",
        text(&again.stderr)
    );
    let found = text(&again.stdout);
    assert!(!found.contains("curved"), "{found}");
}

/// Keys of a cone that widens away from the robot.
const CONE: [&str; 4] = [
    "surface.shape=cone",
    "surface.radius_m=0.6",
    "surface.half_angle_rad=0.3",
    "surface.axis_rad=1.5708",
];

/// Runs a command on the template's task on a cone.
fn on_cone(folder: &Path, words: &[&str]) -> Output {
    let mut command = command(folder);
    command.args(words);
    for key in CONE {
        command.args(["--set", key]);
    }
    command.output().unwrap()
}

#[test]
fn a_check_names_the_cone() {
    let folder = folder();
    let done = on_cone(folder.path(), &["check", "task.toml", "--strategy", "grid"]);
    let found = text(&done.stdout);
    assert!(
        found.contains("cone of radius 0.6 m and half angle 17° that widens at 90° to x"),
        "{found}{}",
        text(&done.stderr)
    );
}

/// A run on a cone reaches its goal; its page, plan and log are those of the cone.
#[test]
fn a_run_on_a_cone_reaches_its_goal() {
    let folder = folder();
    let words = [
        "run",
        "task.toml",
        "--seed",
        "1",
        "--strategy",
        "kde",
        "--out",
        "out",
    ];
    let done = on_cone(folder.path(), &words);
    let (found, errors) = (text(&done.stdout), text(&done.stderr));
    assert_eq!(done.status.code(), Some(0), "{found}{errors}");
    let read = |name: &str| text(&fs::read(folder.path().join("out").join(name)).unwrap());
    let shape = r#""shape":{"kind":"cone","radius_m":0.6,"half_angle_rad":0.3,"axis_rad":1.5708}"#;
    assert!(read("report.html").contains(shape));
    let plan: serde_json::Value = serde_json::from_str(&read("plan.json")).unwrap();
    assert_eq!(plan["surface_shape"]["kind"], "cone");
    let words = [
        "interpret",
        "out/telemetry/round-1.mcap",
        "--json",
        "--task",
        "task.toml",
    ];
    let again = on_cone(folder.path(), &words);
    let errors = text(&again.stderr);
    assert!(matches!(again.status.code(), Some(0 | 1)), "{errors}");
    let found: serde_json::Value = serde_json::from_slice(&again.stdout).expect("a summary");
    assert_eq!(found["diagnosis"], "localized", "{found}");
    assert_eq!(found["doubts"], serde_json::json!([]), "{found}");
    // The contacts determine the pose of the cone up to motions along itself, and lie on it.
    let fit = &found["registration"];
    let determined = fit["determined"].as_u64().expect("a fit");
    assert!((4..=5).contains(&determined), "{fit}");
    assert!(fit["rms_m"].as_f64().expect("a distance") < 1e-3, "{fit}");
    let cells = found["contact_residuals"].as_array().expect("a map");
    assert!(cells.len() > 20, "{cells:?}");
    for cell in cells {
        let height = cell["height_m"].as_f64().expect("a height");
        assert!(height.abs() < 3e-3, "{cell}");
    }
    // The log does not fit a plane.
    let words = [
        "interpret",
        "out/telemetry/round-1.mcap",
        "--json",
        "--task",
        "task.toml",
    ];
    let flat = command(folder.path()).args(words).output().unwrap();
    let found = text(&flat.stdout);
    assert!(
        found.contains("curved") || found.contains("the contacts lie on"),
        "{found}"
    );
}

#[test]
fn keys_of_a_cylinder_are_checked() {
    let folder = folder();
    let fails = |set: &[&str]| {
        let mut command = command(folder.path());
        command.args(["check", "task.toml"]);
        set.iter().for_each(|key| {
            command.args(["--set", key]);
        });
        let done = command.output().unwrap();
        assert_eq!(done.status.code(), Some(2), "{set:?}");
        text(&done.stderr)
    };
    let errors = fails(&["surface.shape=cylinder"]);
    assert!(
        errors.contains("radius_m") && errors.contains("missing"),
        "{errors}"
    );
    let errors = fails(&["surface.radius_m=1.0"]);
    assert!(errors.contains("that of a cylinder or a cone"), "{errors}");
    let errors = fails(&[
        "surface.shape=cylinder",
        "surface.radius_m=1",
        "surface.half_angle_rad=0.2",
    ]);
    assert!(
        errors.contains("surface.half_angle_rad") && errors.contains("that of a cone"),
        "{errors}"
    );
    let errors = fails(&["surface.shape=cone", "surface.radius_m=1"]);
    assert!(
        errors.contains("half_angle_rad") && errors.contains("missing"),
        "{errors}"
    );
    let errors = fails(&[
        "surface.shape=cone",
        "surface.radius_m=1",
        "surface.half_angle_rad=1.6",
    ]);
    assert!(
        errors.contains("half_angle_rad = 1.6 is outside"),
        "{errors}"
    );
    // The apex lies 0.1 m before the origin, on the board.
    let errors = fails(&[
        "surface.shape=cone",
        "surface.radius_m=0.05",
        "surface.half_angle_rad=0.5236",
    ]);
    assert!(
        errors.contains("apex is at (-0.100, 0.000) m") && errors.contains("the limit is 0.01 m"),
        "{errors}"
    );
    let errors = fails(&["execution.surface_half_angle_rad=0.2"]);
    assert!(errors.contains("set surface_radius_m"), "{errors}");
    let errors = fails(&["surface.shape=cylinder", "surface.radius_m=0.05"]);
    assert!(errors.contains("about the axis"), "{errors}");
    let errors = fails(&["execution.surface_axis_rad=1.0"]);
    assert!(errors.contains("set surface_radius_m"), "{errors}");
    let errors = fails(&["execution.surface_radius_m=0.05"]);
    assert!(
        errors.contains("execution.surface_radius_m") && errors.contains("about the axis"),
        "{errors}"
    );
    let errors = fails(&["surface.shape=sphere"]);
    assert!(
        errors.contains("cylinder") && errors.contains("cone"),
        "{errors}"
    );
}

/// The shipped scenarios over meshes, by name from anywhere, and as copies.
#[test]
fn scenarios_over_meshes_meet_their_goals() {
    let folder = tempfile::tempdir().unwrap();
    let run = |args: &[&str]| {
        let done = command(folder.path()).args(args).output().unwrap();
        assert!(done.status.success(), "{args:?}: {}", text(&done.stderr));
        text(&done.stdout)
    };
    let list = run(&["scenarios"]);
    for name in ["basin", "car-door"] {
        assert!(list.contains(&format!("\n{name} ")), "{list}");
        let found = run(&["run", name, "--out", &format!("{name}-run")]);
        assert!(found.contains(": goal met"), "{found}");
        let copy = format!("{name}-copy");
        let wrote = run(&["scenarios", name, "--out", &copy]);
        assert!(wrote.contains(&format!("meshes/{name}.stl")), "{wrote}");
        let task = format!("{copy}/{name}.toml");
        run(&["plan", &task, "--out", "copied"]);
        run(&["plan", name, "--out", "named"]);
        let [copied, named] = ["copied", "named"]
            .map(|out| fs::read(folder.path().join(out).join("plan.json")).unwrap());
        assert!(copied == named, "{name}");
    }
    // A copy without its mesh is announced, and existing files stay.
    let done = command(folder.path()).args(["scenarios", "basin"]).output();
    let err = text(&done.unwrap().stderr);
    assert!(
        err.contains("the task needs the file meshes/basin.stl"),
        "{err}"
    );
    let again = ["scenarios", "basin", "--out", "basin-copy"];
    let done = command(folder.path()).args(again).output().unwrap();
    assert_eq!(done.status.code(), Some(2));
    assert!(text(&done.stderr).contains("the file exists already"));
}
