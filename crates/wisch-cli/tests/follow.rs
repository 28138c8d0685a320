//! `wisch run` and `wisch follow` with a robot, and `wisch robot map`, in a real temporary directory.

use crate::program::{contents, folder_with, root, wisch};
use serde_json::Value;
use std::fs;
use std::path::Path;

/// The JSON object of a run that works, whether or not its goal is met.
fn summary(folder: &Path, args: &[&str]) -> Value {
    let (code, out, err) = wisch(folder, &[args, &["--json"]].concat());
    assert!(code == 0 || code == 1, "{args:?}: {code}: {err}");
    assert_eq!(err, "", "nothing of the progress reaches a pipe");
    serde_json::from_str(&out).expect("exactly one JSON object")
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).expect("a text file")
}

fn json(path: &Path) -> Value {
    serde_json::from_str(&read(path)).expect("JSON")
}

/// Compares the lengths of a run with those of the rounds, and the total with the tool's path.
fn check_distances(result: &Path, in_contact: f64, total: f64) {
    let rounds = json(&result.join("rounds.json"));
    let rounds = rounds.as_array().expect("a list");
    let sum = |key: &str| {
        rounds
            .iter()
            .filter_map(|round| round[key].as_f64())
            .sum::<f64>()
    };
    assert!((sum("distance_in_contact_m") - in_contact).abs() < 1e-9);
    assert!((sum("distance_total_m") - total).abs() < 1e-9);
    let path = read(&result.join("trajectories/tcp-path.csv"));
    let place = |row: &str| -> Vec<f64> {
        let cells = row.split(',').skip(3).take(3);
        cells.map(|cell| cell.parse().expect("a number")).collect()
    };
    let places: Vec<Vec<f64>> = path.lines().skip(1).map(place).collect();
    let steps = places.windows(2).map(|pair| {
        let squares = pair[0].iter().zip(&pair[1]).map(|(a, b)| (b - a).powi(2));
        squares.sum::<f64>().sqrt()
    });
    let of_first: f64 = steps.sum();
    let first = rounds[0]["distance_total_m"].as_f64().expect("a number");
    assert!(
        (first - of_first).abs() < 0.01 * of_first,
        "{first} m, {of_first} m"
    );
}

/// The number before a per cent sign in the first line that contains a word.
fn percent_of<'a>(text: &'a str, word: &str) -> &'a str {
    let line = text
        .lines()
        .find(|line| line.contains(word))
        .expect("a line");
    let (before, _) = line.split_once(" %").expect("a share");
    before.rsplit(' ').next().expect("a number")
}

#[test]
fn check_and_follow_state_the_same_performance_of_what_the_robot_reaches() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("task.toml"), WALL).expect("written");
    let (code, checked, err) = wisch(folder.path(), &["check", "task.toml"]);
    assert_eq!(code, 0, "{checked}{err}");
    assert!(checked.contains("the robot abandons"), "{checked}");
    assert!(
        checked.contains("with the strokes that the robot follows"),
        "{checked}"
    );
    let (_, followed, _) = wisch(folder.path(), &["follow", "task.toml", "--out", "result"]);
    assert_eq!(
        percent_of(&checked, "  predicted"),
        percent_of(&followed, "  performance"),
        "{checked}{followed}"
    );
    assert!(followed.contains("; holder 0."), "{followed}");
}

/// A wall of which the arm cannot polish the lower part.
const WALL: &str = r#"
schema = 1
name = "wall"
seed = 3
action = "polish"
target_performance = 0.9
tool = { name = "pad", footprint_m = [0.05, 0.08], compression_depth_m = 0.004, mount = { on = "flange", distance_m = 0.1 } }
medium = { name = "polishing_paste" }
robot = { name = "arm7" }
polish = { passes = 1 }
particles = { source = "surface", count = 600 }
[surface]
name = "plate"
friction = 0.3
size_m = [0.30, 0.20]
position_m = [0.55, 0.0, 0.45]
rpy_rad = [1.5707963267948966, 0, -1.5707963267948966]
"#;

#[test]
fn the_humanoid_follows_the_board() {
    let folder = folder_with("chopping-board.toml");
    let run = ["run", "task.toml", "--budget", "3000", "--out", "result"];
    let summary_of = summary(folder.path(), &run);
    let number = |key: &str| summary_of[key].as_f64().expect("a number");
    assert_eq!(summary_of["robot"], "humanoid");
    assert_eq!(summary_of["abandoned_nodes"], 0);
    assert!(summary_of["first_obstruction"].is_null());
    assert_eq!(summary_of["faults"], 0);
    let placements = summary_of["placements"].as_array().expect("a list");
    assert!(
        !placements.is_empty()
            && placements
                .iter()
                .all(|p| p.as_array().map(Vec::len) == Some(3))
    );
    assert!(number("contact_time_s") > 0.0);
    // A tool that wipes turns seven joints by about a radian each, and comes from somewhere and goes back.
    assert!(number("joint_movement_in_contact_rad") > 1.0);
    assert!(number("joint_movement_rad") > number("joint_movement_in_contact_rad") + 1.0);
    assert!(number("execution_time_s") > number("contact_time_s"));
    assert!(number("following_time_s") > 0.0);
    // The tolerance of the line and the clearance that following is asked to keep.
    assert!(number("max_path_deviation_m") <= 1e-3);
    assert!(number("min_clearance_m") >= 5e-3);

    let result = folder.path().join("result");
    check_distances(
        &result,
        number("distance_in_contact_m"),
        number("distance_total_m"),
    );
    let following = json(&result.join("trajectories/following.json"));
    assert_eq!(following["format"], "wisch-following");
    assert_eq!(following["faults"], serde_json::json!([]));
    // Each node that is passed is in reach by the capability map as well.
    let nodes = json(&result.join("plan.json"))["nodes"]
        .as_array()
        .map(Vec::len);
    let ample = following["node_reachability"].as_array().expect("a list");
    assert_eq!(Some(ample.len()), nodes);
    assert!(
        ample
            .iter()
            .all(|ample| (0.05..=1.0).contains(&ample.as_f64().unwrap())),
        "{ample:?}"
    );
    let motions = following["motions"].as_array().expect("a list");
    let ends = motions.last().expect("a motion")["end_s"].as_f64();
    // What is executed lasts to the end of the controller's period.
    assert!((ends.unwrap() - number("execution_time_s")).abs() < 2e-3);

    let message = json(&result.join("trajectories/trajectory.json"));
    // YAML 1.1 would take 6e-6 for a text.
    let text = read(&result.join("trajectories/trajectory.json"));
    let exponent = |w: &[u8]| w[0].is_ascii_digit() && w[1] == b'e';
    assert!(!text.as_bytes().windows(2).any(exponent));
    let point = &message["multi_dof_joint_trajectory"]["points"][0];
    assert!(point["transforms"][0]["rotation"]["w"].is_f64());

    let mut path =
        csv::Reader::from_path(result.join("trajectories/tcp-path.csv")).expect("a table");
    let rows: Vec<csv::StringRecord> = path.records().map(|row| row.expect("a row")).collect();
    let column = |row: &csv::StringRecord, i: usize| row[i].parse::<f64>().expect("a number");
    assert!(rows.windows(2).all(|w| column(&w[0], 0) < column(&w[1], 0)));
    // On the board while it wipes, which is 0.77 m high, and nowhere else is there force.
    for row in &rows {
        let wipes = &row[1] == "wipe";
        assert_eq!(wipes, column(row, 11) > 0.0);
        assert!(!wipes || (column(row, 5) - 0.77).abs() < 2e-3, "{row:?}");
    }

    // Results of an earlier run give way, those of the robot among them, where it is forced
    // also to a run without.
    let again = ["run", "task.toml", "--strategy", "kde", "--out", "result"];
    assert_eq!(summary(folder.path(), &again)["faults"], 0);
    let plain = summary(
        folder.path(),
        &[&again[..], &["--robot", "none", "--force"]].concat(),
    );
    assert!(plain.get("robot").is_none() && plain.get("abandoned_nodes").is_none());
    assert!(plain["predicted_performance"].is_number());
    assert!(!result.join("trajectories/trajectory.json").exists());
}

#[test]
fn an_arm_that_is_bolted_down_passes_every_node() {
    let folder = folder_with("arm-board.toml");
    let args = ["run", "task.toml", "--out", "result", "--no-memory"];
    let summary_of = summary(folder.path(), &args);
    assert_eq!(summary_of["robot"], "arm7");
    assert_eq!(summary_of["abandoned_nodes"], 0);
    assert_eq!(summary_of["faults"], 0);
    assert_eq!(summary_of["goal_met"], true);
    assert_eq!(summary_of["placements"], serde_json::json!([]));
    let message = json(&folder.path().join("result/trajectories/trajectory.json"));
    assert_eq!(
        message["multi_dof_joint_trajectory"]["points"],
        serde_json::json!([])
    );
    let points = &message["joint_trajectory"]["points"];
    assert_eq!(points[0]["positions"].as_array().map(Vec::len), Some(7));

    // The same bytes again on another number of threads.
    let before = contents(&folder.path().join("result"));
    summary(folder.path(), &[&args[..], &["--threads", "1"]].concat());
    assert!(before == contents(&folder.path().join("result")));

    // A plan of an earlier run leads to the same motion.
    let follow = ["follow", "task.toml", "--out", "again", "--plan"];
    summary(
        folder.path(),
        &[&follow[..], &["result/plan.json"]].concat(),
    );
    let motion = [
        "plan.json",
        "trajectories/following.json",
        "trajectories/trajectory.json",
        "trajectories/tcp-path.csv",
    ];
    for (name, bytes) in contents(&folder.path().join("again")) {
        if motion.contains(&name.as_str()) {
            assert!(before.contains(&(name.clone(), bytes)), "{name}");
        }
    }
}

#[test]
fn another_robot_takes_the_place_of_the_tasks() {
    let folder = folder_with("chopping-board.toml");
    let arm = [
        "run",
        "task.toml",
        "--budget",
        "3000",
        "--out",
        "result",
        "--robot",
        "arm7",
    ];
    let beside = ["--set", "robot.position_m=[0, -0.45, 0.75]"];
    let summary_of = summary(folder.path(), &[&arm[..], &beside].concat());
    assert_eq!(summary_of["robot"], "arm7");
    assert_eq!(summary_of["abandoned_nodes"], 0);
    assert_eq!(summary_of["faults"], 0);

    // Where the humanoid stands nothing is in the arm's reach: an outcome, with the reason.
    let (code, out, err) = wisch(folder.path(), &arm);
    assert_eq!((code, err.as_str()), (1, ""));
    assert!(out.contains("abandoned first"), "{out}");
    assert!(!out.contains("-0.0"), "{out}");
    let message = json(&folder.path().join("result/trajectories/trajectory.json"));
    let parts = message.as_object().expect("two trajectories").values();
    assert!(
        parts.clone().count() == 2
            && parts
                .clone()
                .all(|part| part["points"] == serde_json::json!([]))
    );
}

#[test]
fn a_task_without_a_robot_is_predicted_and_not_followed() {
    let folder = folder_with("arm-board.toml");
    let task = folder.path().join("task.toml");
    let text = read(&task);
    let (before, after) = text.split_once("[robot]").expect("a robot");
    let (_, after) = after.split_once("\n\n").expect("more tables");
    fs::write(&task, format!("{before}{after}")).expect("a task");

    for args in [
        &["follow", "task.toml"][..],
        &["follow", "task.toml", "--robot", "none"],
    ] {
        let (code, out, err) = wisch(folder.path(), args);
        assert_eq!((code, out.as_str()), (2, ""));
        assert!(
            err.contains("task.toml: wisch follow needs a robot"),
            "{err}"
        );
        assert!(err.contains("--robot"), "{err}");
    }
    assert!(!folder.path().join("out").exists());
    let run = summary(folder.path(), &["run", "task.toml", "--out", "result"]);
    assert!(run["predicted_performance"].is_number());
    assert!(run.get("execution_time_s").is_none());
    let (_, out, _) = wisch(folder.path(), &["check", "task.toml"]);
    assert!(out.contains("robot      none"), "{out}");
}

#[test]
fn check_says_which_robot_stands_where() {
    for (scenario, expected) in [
        (
            "arm-board.toml",
            "arm7; it is fixed at (0.000, -0.450, 0.750) m",
        ),
        (
            "chopping-board.toml",
            "starts at (0.000, -1.100) m, heading 90.0°, and moves its base",
        ),
    ] {
        let (code, out, err) = wisch(folder_with(scenario).path(), &["check", "task.toml"]);
        assert_eq!((code, err.as_str()), (0, ""));
        assert!(out.contains(expected), "{out}");
    }
}

#[test]
fn a_map_is_built_found_and_used() {
    let folder = folder_with("arm-board.toml");
    for file in ["arm6.urdf", "arm6.srdf"] {
        let from = root().join("robots").join(file);
        fs::copy(from, folder.path().join(file)).expect("a robot");
    }
    let coarse = ["--voxel-m", "0.2", "--samples", "2000"];
    let build = [&["robot", "map", "arm6.urdf"], &coarse[..]].concat();
    let record = summary(folder.path(), &build);
    assert_eq!(record["format"], "wisch-robot-map");
    assert_eq!(record["robot"], "arm6");
    let map = folder.path().join("arm6.reach");
    let bytes = fs::read(&map).expect("beside the URDF");
    assert_eq!(record["bytes"], bytes.len());

    // This arm's first link hangs lower than that of the scene's arm.
    let raised = "robot.position_m=[0, -0.45, 0.8]";
    let follow = [
        "follow",
        "task.toml",
        "--out",
        "result",
        "--set",
        raised,
        "--robot",
    ];
    for robot in [&["arm6.urdf"][..], &["arm6", "--map", "arm6.reach"]] {
        let summary_of = summary(folder.path(), &[&follow[..], robot].concat());
        assert_eq!(summary_of["robot"], "arm6");
        assert_eq!(summary_of["abandoned_nodes"], 0);
    }

    // Beside its URDF a map is found by itself: a damaged map is reported.
    fs::write(&map, &bytes[..bytes.len() / 2]).expect("half a map");
    let (code, _, err) = wisch(folder.path(), &[&follow[..], &["arm6.urdf"]].concat());
    assert_eq!(code, 2);
    assert!(err.contains("arm6.reach: no capability map"), "{err}");
    // The shipped robot has none that could be damaged, and its map has the same bytes.
    let out = [
        &["robot", "map", "arm6", "--out", "other.reach"],
        &coarse[..],
    ]
    .concat();
    let (code, said, err) = wisch(folder.path(), &out);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(said.contains("other.reach"), "{said}");
    assert!(bytes == fs::read(folder.path().join("other.reach")).expect("a map"));
}

#[test]
fn the_help_of_the_robots_commands_ends_with_examples() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for command in ["follow", "robot map", "robot check", "robot setup"] {
        let args: Vec<&str> = command.split(' ').chain(["--help"]).collect();
        let (code, out, _) = wisch(folder.path(), &args);
        assert_eq!(code, 0);
        let (_, examples) = out.split_once("Examples:").expect("examples");
        assert!(examples.contains(&format!("wisch {command}")), "{examples}");
    }
}
