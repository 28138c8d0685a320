//! `wisch interpret` in a real temporary directory.

#[path = "../../wisch-telemetry/examples/demo_bag/wiping.rs"]
mod wiping;

use crate::program::wisch;
use serde_json::Value;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use tempfile::TempDir;
use wiping::Wiping;
use wisch::geometry::{Pose, Vector3};
use wisch::interpret::TouchSample;
use wisch_telemetry::{BagHead, BagWriter, LogOptions, active_path, read};

/// A board to be wiped with a sponge; the crumbs lie where the made-up tool passes, and one where it does not.
const TASK: &str = r#"
schema = 1
name = "board"
seed = 1
action = "absorb"
target_performance = 0.7

[tool]
name = "sponge"
start_m = [0.0, -0.3]

[medium]
name = "breadcrumbs"

[surface]
name = "chopping_board"
size_m = [0.4, 0.28]
position_m = [0.6, 0.1, 0.75]

[interaction]
mu_spread = 0.0
ln_sigma_spread = 0.0

[particles]
source = "csv"
file = "crumbs.csv"
"#;

const CRUMBS: &str = "0.0,0.05\n0.05,0.05\n-0.05,-0.05\n0.0,-0.05\n-0.18,0.12\n";

pub fn believed() -> Pose {
    Pose::translation(0.6, 0.1, 0.75)
}

fn wipe(world_from_surface: Pose) -> Wiping {
    Wiping {
        world_from_surface,
        extent: [0.2, 0.1],
        rows: 2,
        speed: 0.1,
        press: 10.0,
        rate: 500.0,
    }
}

fn write_bag(path: &Path, wipe: &Wiping) {
    let head = BagHead {
        joints: wiping::JOINTS.map(str::to_owned).to_vec(),
        world_from_surface: believed(),
        start: 0,
        notes: [("task".to_owned(), "board".to_owned())].into(),
    };
    let mut bag = BagWriter::create(path, head).unwrap();
    wipe.write(&mut bag).unwrap();
    bag.finish().unwrap();
}

/// A folder with the task and a bag of the tool wiping where the surface really is.
pub fn folder(world_from_real: Pose) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("task.toml"), TASK).unwrap();
    fs::write(folder.path().join("crumbs.csv"), CRUMBS).unwrap();
    write_bag(&folder.path().join("log.mcap"), &wipe(world_from_real));
    folder
}

fn interpreted(folder: &Path, log: &str, more: &[&str]) -> (i32, Value) {
    let args = [&["interpret", log, "--task", "task.toml", "--json"], more].concat();
    let (code, out, err) = wisch(folder, &args);
    assert_eq!(err, "", "{args:?}");
    (
        code,
        serde_json::from_str(&out).expect("exactly one JSON object"),
    )
}

fn refused(folder: &Path, log: &str, more: &[&str]) -> String {
    let args = [&["interpret", log, "--task", "task.toml"], more].concat();
    let (code, out, err) = wisch(folder, &args);
    assert_eq!((code, out.as_str()), (2, ""), "{args:?}: {err}");
    assert!(err.starts_with("error: "), "{err}");
    assert!(!folder.join("out").exists(), "nothing is left behind");
    err
}

#[test]
fn a_log_of_a_wiped_board_says_so() {
    let folder = folder(believed());
    let (code, record) = interpreted(folder.path(), "log.mcap", &[]);
    assert_eq!(code, 0, "{record}");
    assert_eq!(record["format"], "wisch-interpretation");
    // Four of five crumbs are under the tool.
    // Hardly a member holds the tool so that it misses one.
    assert!((record["estimated"].as_f64().unwrap() - 0.8).abs() < 0.01);
    assert_eq!(
        (&record["diagnosis"], &record["collisions"]),
        (&"localized".into(), &0.into())
    );
    assert_eq!(record["log"]["wrench_frame"], "world");
    assert!(record["plane_tilt_rad"].as_f64().unwrap() < 1e-6);
    let kinds: Vec<&Value> = record["events"]
        .as_array()
        .unwrap()
        .iter()
        .map(|e| &e["kind"])
        .collect();
    assert_eq!(kinds, ["approach", "contact", "stroke", "retreat"]);

    let out = folder.path().join("out/board-interpreted");
    let written = fs::read_to_string(out.join("interpretation.json")).unwrap();
    assert_eq!(serde_json::from_str::<Value>(&written).unwrap(), record);
    let particles = fs::read_to_string(out.join("particles/particles-estimated.csv")).unwrap();
    assert_eq!(particles.matches("absorbed").count(), 4, "{particles}");

    // Once more, in words, over the results of the first time.
    let (code, words, _) = wisch(
        folder.path(),
        &["interpret", "log.mcap", "--task", "task.toml"],
    );
    assert_eq!(code, 0);
    for part in [
        "80.0 % estimated",
        "at its believed pose",
        "N/m ± 20.0 %, assumed as declared",
        "1 contact",
        "axes of the world",
    ] {
        assert!(words.contains(part), "{part} in {words}");
    }
}

#[test]
fn the_estimate_is_what_the_next_log_begins_with() {
    let folder = folder(believed());
    interpreted(folder.path(), "log.mcap", &["--out", "first"]);
    let next = [
        "--set",
        "particles.file=first/particles/particles-estimated.csv",
    ];
    let (_, record) = interpreted(folder.path(), "log.mcap", &next);
    // Hardly a member holds the tool so that it misses one.
    assert!((record["estimated"].as_f64().unwrap() - 0.8).abs() < 0.01);
}

#[test]
fn a_goal_that_is_not_reached_is_no_error() {
    let folder = folder(believed());
    let target = ["--set", "target_performance=0.9", "--out", "mine"];
    let (code, record) = interpreted(folder.path(), "log.mcap", &target);
    assert_eq!((code, &record["goal_met"]), (1, &false.into()));
    assert!(folder.path().join("mine/interpretation.json").exists());
}

#[test]
fn a_surface_that_is_elsewhere_is_found() {
    let tilt = 0.03;
    let folder = folder(believed() * Pose::new(Vector3::new(0.0, 0.0, 0.006), Vector3::y() * tilt));
    let (_, record) = interpreted(folder.path(), "log.mcap", &[]);
    assert_eq!(record["diagnosis"], "relocalize");
    let near = |value: &Value, expected: f64, tolerance: f64| {
        let value = value.as_f64().unwrap();
        assert!(
            (value - expected).abs() < tolerance,
            "{value} is not {expected}"
        );
    };
    near(&record["plane_tilt_rad"], tilt, 1e-3);
    near(&record["plane_offset_m"], 0.006, 1e-3);
    near(
        &record["world_from_surface"]["translation_m"][2],
        0.756,
        1e-3,
    );
}

#[test]
fn a_bag_that_a_killed_run_left_is_interpreted_as_far_as_it_goes() {
    let folder = folder(believed());
    let whole = folder.path().join("log.mcap");
    let bytes = fs::read(&whole).unwrap();
    fs::remove_file(&whole).unwrap();
    fs::write(active_path(&whole), &bytes[..bytes.len() / 2]).unwrap();
    let (_, record) = interpreted(folder.path(), "log.mcap", &[]);
    assert_eq!(record["log"]["unfinished"], true);
    let duration = record["log"]["duration_s"].as_f64().unwrap();
    assert!(duration > 1.0 && duration < 4.0, "{duration}");
}

#[test]
fn a_table_says_the_same_as_the_bag() {
    let folder = folder(believed());
    let (_, from_bag) = interpreted(folder.path(), "log.mcap", &[]);
    let log = read(&folder.path().join("log.mcap"), &LogOptions::default()).unwrap();
    // Other names, other units, other order, other sign, and a line of units.
    let mut table = "fz;fy;fx;time;px;y;z;qw;qx;qy;qz\nkp;kp;kp;ms;mm;mm;mm;;;;\n".to_owned();
    let kilopond = 9.80665;
    for sample in &log.samples {
        let (p, q, f) = (
            sample.world_from_tool.translation.vector * 1e3,
            sample.world_from_tool.rotation.coords,
            sample.force / -kilopond,
        );
        let time = sample.time * 1e3;
        writeln!(
            table,
            "{};{};{};{time};{};{};{};{};{};{};{}",
            f.z, f.y, f.x, p.x, p.y, p.z, q.w, q.x, q.y, q.z
        )
        .unwrap();
    }
    fs::write(folder.path().join("log.csv"), table).unwrap();
    let understood = [
        "--csv-columns",
        "t=time,x=px",
        "--time-unit-s",
        "0.001",
        "--length-unit-m",
        "0.001",
        "--force-unit-n",
        "9.80665",
        "--wrench-sign",
        "by-tool",
        "--wrench-frame",
        "log",
    ];
    let (_, from_table) = interpreted(folder.path(), "log.csv", &understood);
    let same = |from_table: &Value| {
        for key in ["estimated", "diagnosis", "collisions"] {
            assert_eq!(from_table[key], from_bag[key], "{key}");
        }
        assert_eq!(from_table["log"]["samples"], from_bag["log"]["samples"]);
    };
    same(&from_table);
    let remarks = from_table["log"]["remarks"].to_string();
    assert!(remarks.contains("the log names no frame"), "{remarks}");
    assert!(!remarks.contains("states no unit"), "{remarks}");
    // The line of units says the same as the options.
    let said = [&understood[..2], &understood[8..]].concat();
    let (_, from_table) = interpreted(folder.path(), "log.csv", &said);
    same(&from_table);
    assert_eq!(
        from_table["log"]["remarks"][1],
        "from its line of units: t in ms, x in mm, y in mm, z in mm, fx in kp, fy in kp, fz in kp"
    );
}

#[test]
fn what_is_odd_about_a_log_is_said() {
    let folder = folder(believed());
    let path = folder.path();
    let log = read(&path.join("log.mcap"), &LogOptions::default()).unwrap();
    let mut table = "t,x,y,z,qx,qy,qz,qw,fx,fy,fz\n".to_owned();
    for (index, sample) in log.samples.iter().enumerate() {
        let (p, q, f) = (
            sample.world_from_tool.translation.vector,
            sample.world_from_tool.rotation.coords,
            sample.force,
        );
        // Two seconds are missing, and one number is NaN.
        if (2.0..4.0).contains(&sample.time) {
            continue;
        }
        let z = if index == 100 { f64::NAN } else { p.z };
        writeln!(
            table,
            "{},{},{},{z},{},{},{},{},{},{},{}",
            sample.time, p.x, p.y, q.x, q.y, q.z, q.w, f.x, f.y, f.z
        )
        .unwrap();
    }
    fs::write(path.join("log.csv"), table).unwrap();
    let frame = ["--wrench-frame", "log"];
    let (_, record) = interpreted(path, "log.csv", &frame);
    let log = &record["log"];
    assert_eq!(log["skipped"], 1);
    let gap = &log["gaps_s"][0];
    assert!((gap[1].as_f64().unwrap() - gap[0].as_f64().unwrap() - 2.0).abs() < 0.01);
    let (_, words, _) = wisch(
        path,
        &[&["interpret", "log.csv", "--task", "task.toml"], &frame[..]].concat(),
    );
    for part in [
        "left out: 1 sample; the first: line 102: z is NaN",
        "gaps in the log: 2.0",
    ] {
        assert!(words.contains(part), "{part} in {words}");
    }

    let (_, record) = interpreted(path, "log.csv", &[]);
    assert_eq!(record["log"]["wrench_frame"], "tool");
    assert_eq!(record["log"]["wrench_frame_assumed"], true);

    // The bag of another task, whose surface is 0.2 m lower: the message states where the tool pressed.
    let elsewhere = "surface.position_m=[0.6, 0.1, 0.95]";
    let args = [
        "interpret",
        "log.mcap",
        "--task",
        "task.toml",
        "--set",
        elsewhere,
    ];
    let (code, words, _) = wisch(path, &args);
    assert_eq!(code, 1);
    for part in [
        "the log's surface is 0.200 m and 0.0° away from the task's surface: is --task the task of this log?",
        "the tool pressed 0.200 m below the believed surface",
        "check surface.position_m and --world-from-log",
    ] {
        assert!(words.contains(part), "{part} in {words}");
    }
    assert!(!words.contains("--wrench-sign"), "{words}");
    assert!(words.contains("the log shows no contact"), "{words}");
    let (_, record) = interpreted(path, "log.mcap", &["--set", elsewhere]);
    assert!(record["contact_share"].is_null(), "{record}");
    let (_, record) = interpreted(path, "log.mcap", &["--set", "name='table'"]);
    assert_eq!(
        record["log"]["remarks"][0],
        "the log is of the task \"board\", not of \"table\""
    );
    let (_, record) = interpreted(path, "log.mcap", &[]);
    assert_eq!(record["log"]["remarks"], Value::Array(vec![]));
}

/// Writes the samples of the folder's bag as `log.csv`: those that `keep` accepts, with positions in a unit [m].
fn write_table(folder: &Path, unit: f64, keep: impl Fn(&TouchSample) -> bool) {
    let log = read(&folder.join("log.mcap"), &LogOptions::default()).unwrap();
    let mut table = "t,x,y,z,qx,qy,qz,qw,fx,fy,fz\n".to_owned();
    for sample in log.samples.iter().filter(|sample| keep(sample)) {
        let (p, q, f) = (
            sample.world_from_tool.translation.vector / unit,
            sample.world_from_tool.rotation.coords,
            sample.force,
        );
        writeln!(
            table,
            "{},{},{},{},{},{},{},{},{},{},{}",
            sample.time, p.x, p.y, p.z, q.x, q.y, q.z, q.w, f.x, f.y, f.z
        )
        .unwrap();
    }
    fs::write(folder.join("log.csv"), table).unwrap();
}

#[test]
fn a_summary_states_what_is_unknown_and_the_most_fundamental_fault_first() {
    let folder = folder(believed());
    let path = folder.path();
    let args = [
        "interpret",
        "log.csv",
        "--task",
        "task.toml",
        "--wrench-frame",
        "world",
    ];

    write_table(path, 1.0, |sample| sample.force.z > 5.0);
    let (_, words, _) = wisch(path, &args);
    let unknown = "bias unknown, because the log shows no calm free motion on this side of the surface: 0 N assumed";
    assert!(
        words.contains(unknown) && !words.contains("subtracted"),
        "{words}"
    );
    let (_, record) = interpreted(path, "log.csv", &args[4..]);
    assert_eq!(record["force_bias_n"], Value::Null);

    write_table(path, 1.0, |_| true);
    let mut doubled = String::new();
    for line in fs::read_to_string(path.join("log.csv")).unwrap().lines() {
        let again = if line.starts_with('t') { "" } else { line };
        write!(doubled, "{line}\n{again}\n").unwrap();
    }
    fs::write(path.join("log.csv"), doubled).unwrap();
    let (_, words, _) = wisch(path, &args);
    let left_out = words
        .lines()
        .find(|line| line.contains("left out"))
        .unwrap();
    assert!(
        left_out.ends_with("samples with the time of the sample before"),
        "{left_out}"
    );

    write_table(path, 1e-3, |_| true);
    let (_, words, _) = wisch(path, &args);
    assert!(
        words.contains("in millimetres (--length-unit-m 0.001) it would be"),
        "{words}"
    );
    assert!(words.contains("unknown: the tool is"), "{words}");
    assert!(
        !words.contains("jumps") && !words.contains("a sample every"),
        "{words}"
    );
    write_table(path, 1e-6, |_| true);
    let (code, _, err) = wisch(path, &args);
    let unit = "in micrometres (--length-unit-m 0.000001)";
    assert!(code == 2 && err.contains(unit), "{err}");
}

#[test]
fn an_observation_of_dirt_is_refused_where_there_is_none() {
    let folder = folder(believed());
    let polish = [
        "--action",
        "polish",
        "--set",
        "interaction.actions=['polish']",
        "--set",
        "polish.passes=1",
        "--set",
        "particles={source='surface',count=500}",
        "--observation",
        "crumbs.csv",
    ];
    let shown = refused(folder.path(), "log.mcap", &polish);
    for part in ["--observation crumbs.csv", "the action polish", "omit"] {
        assert!(shown.contains(part), "{part} in {shown}");
    }
}

/// Detections at the edge of the board, repeated ones, and those on the table around it.
#[test]
fn a_list_of_dirt_is_read_as_the_detections_of_an_executor() {
    let folder = folder(believed());
    let observe = |rows: &str, name: &str| {
        fs::write(folder.path().join(name), rows).unwrap();
        let (code, record) = interpreted(folder.path(), "log.mcap", &["--observation", name]);
        assert!(code < 2, "{record}");
        (record["estimated"].clone(), record.to_string())
    };
    let (one, _) = observe("-0.1812,0.1207\n", "one.csv");
    let (at_edge, shown) = observe("-0.1812,0.1415\n", "edge.csv");
    let off = at_edge.as_f64().unwrap() - one.as_f64().unwrap();
    assert!(off.abs() < 0.05 && !shown.contains("left out"), "{shown}");
    let rows = "-0.1812,0.1207\n-0.15,0.02\n-0.17,-0.08\n-0.165,0.071\n-0.18,-0.03\n";
    let (five, _) = observe(rows, "five.csv");
    let (twice, shown) = observe(&rows.repeat(2), "twice.csv");
    let remark = "5 of 10 detections of the camera repeat other ones";
    assert!(twice == five && shown.contains(remark), "{shown}");
    let (around, shown) = observe("-0.1812,0.1207\n0.0,0.25\n", "around.csv");
    let remark =
        "1 of 2 detections of the camera is beside the surface, up to 0.110 m from its edge";
    assert!(around == one && shown.contains(remark), "{shown}");
    fs::remove_dir_all(folder.path().join("out")).unwrap();
    fs::write(folder.path().join("off.csv"), "0.0,0.25\n").unwrap();
    let shown = refused(folder.path(), "log.mcap", &["--observation", "off.csv"]);
    for part in ["--observation: off.csv: 1 of 1 detections", "unit or frame"] {
        assert!(shown.contains(part), "{part} in {shown}");
    }
    // Skimmed dirt lies beside the surface.
    let skim = ["action=skim", "surface.skim_edges=[\"y_max\"]"];
    let skim: Vec<&str> = skim.iter().flat_map(|set| ["--set", set]).collect();
    let args = [&["--observation", "off.csv"], &skim[..]].concat();
    let (code, record) = interpreted(folder.path(), "log.mcap", &args);
    assert!(code < 2, "{record}");
}

/// A plate to be polished twice, at most three times.
const PLATE: &str = r#"
schema = 1
name = "plate"
action = "polish"
target_performance = 0.9
tool = { name = "sponge" }
medium = { name = "polishing_paste" }
surface = { name = "plate", friction = 0.3, size_m = [0.32, 0.24], position_m = [0.0, 0.0, 0.77] }
polish = { passes = 2, max_passes = 3 }
particles = { source = "surface", count = 600 }
"#;

/// Writes a table of a pad that wipes the plate in two lanes of 0.11 m, each this number of times to and fro, with 10 N.
fn write_lanes(path: &Path, repeats: usize) {
    let (mut text, mut time) = ("t,x,y,z,qx,qy,qz,qw,fx,fy,fz\n".to_owned(), 0.0);
    let mut go = |from: [f64; 3], to: [f64; 3], force: f64| {
        let way = from
            .iter()
            .zip(to)
            .map(|(a, b)| (a - b).powi(2))
            .sum::<f64>();
        let steps = ((way.sqrt() / 0.15).max(0.6) / 0.02) as usize;
        for k in 0..steps {
            let share = k as f64 / steps as f64;
            let at = [0, 1, 2].map(|i| from[i] + share * (to[i] - from[i]));
            let noise = 0.05 * (time * 97.0_f64).sin();
            let [x, y, z] = at;
            let _ = writeln!(text, "{time:.3},{x},{y},{z},0,0,0,1,0,0,{}", force + noise);
            time += 0.02;
        }
    };
    for y in [-0.065, 0.045] {
        let place = |x: f64, z: f64| [x, y, z];
        go(place(-0.19, 0.82), place(-0.19, 0.82), 0.0);
        go(place(-0.19, 0.82), place(-0.19, 0.771), 0.0);
        for _ in 0..repeats {
            go(place(-0.19, 0.77), place(0.19, 0.77), 10.0);
            go(place(0.19, 0.77), place(-0.19, 0.77), 10.0);
        }
        go(place(-0.19, 0.771), place(-0.19, 0.82), 0.0);
        go(place(-0.19, 0.82), place(-0.19, 0.82), 0.0);
    }
    fs::write(path, text).unwrap();
}

#[test]
fn too_many_passes_are_stated_and_no_camera_is_advised_for_polish() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    fs::write(path.join("task.toml"), PLATE).unwrap();
    write_lanes(&path.join("often.csv"), 8);
    let (code, found) = interpreted(path, "often.csv", &["--out", "often"]);
    assert_eq!((code, &found["verdict"]), (1, &"not met".into()), "{found}");
    let reason = found["reason"].as_str().unwrap();
    let share = reason
        .split(" % of the points have more passes than polish.max_passes")
        .next();
    let share = share.and_then(|before| before.rsplit(' ').next()?.parse::<f64>().ok());
    // Two lanes of 0.11 m cover this share of 0.24 m.
    let covered = 100.0 * 0.22 / 0.24;
    assert!(
        share.is_some_and(|share| (share - covered).abs() < 5.0),
        "{reason}"
    );
    assert!(reason.contains("the target allows 10.0 %"), "{reason}");

    // Two passes are as many as the task asks for, and touch alone does not decide whether they cover enough.
    write_lanes(&path.join("twice.csv"), 1);
    let target = ["--set", "target_performance=0.92"];
    let args = [
        &["interpret", "twice.csv", "--task", "task.toml"],
        &target[..],
    ]
    .concat();
    let (_, words, _) = wisch(path, &args);
    assert!(words.contains("unknown; "), "{words}");
    assert!(!words.contains("--observation"), "{words}");
}

#[test]
fn where_to_collect_has_to_be_known() {
    let folder = folder(believed());
    let shown = refused(folder.path(), "log.mcap", &["--action", "collect"]);
    assert!(shown.contains("the task has no collection area"), "{shown}");
    assert!(shown.contains("--plan"), "{shown}");
    let goal = ["--action", "collect", "--set", "collect.goal_m=[0.1, 0.05]"];
    let (code, _) = interpreted(folder.path(), "log.mcap", &goal);
    assert!(code < 2);

    let (code, _, shown) = wisch(
        folder.path(),
        &[
            "plan",
            "task.toml",
            "--action",
            "collect",
            "--out",
            "planned",
            "--quiet",
        ],
    );
    assert_eq!(code, 0, "{shown}");
    let by_plan = ["--action", "collect", "--plan", "planned/plan.json"];
    let (_, record) = interpreted(folder.path(), "log.mcap", &by_plan);
    assert_eq!(record["action"], "collect");
}

#[test]
fn wrong_inputs_are_errors_that_say_what_to_do() {
    let folder = folder(believed());
    let path = folder.path();
    let good_names = "t,x,y,z,qx,qy,qz,qw,fx,fy,fz\n";
    let good_line = "0,0,0,0,0,0,0,1,0,0,0\n";
    let files = [
        ("empty.csv", String::new()),
        ("names.csv", good_names.to_owned()),
        (
            "column.csv",
            format!("{}{good_line}", good_names.replace("fz", "force_z")),
        ),
        ("short.csv", format!("{good_names}{good_line}1,0,0\n")),
        (
            "text.csv",
            format!("{good_names}{good_line}1,0,zero,0,0,0,0,1,0,0,0\n"),
        ),
        ("nan.csv", format!("{good_names}0,0,NaN,0,0,0,0,1,0,0,0\n")),
        ("old.bag", "#ROSBAG V2.0\n".to_owned()),
        ("log.db3", "SQLite format 3\0".to_owned()),
        ("back.csv", format!("{good_names}1{good_line}{good_line}",)),
        ("late.csv", format!("{good_names}1e300{}", &good_line[1..])),
        ("turn.csv", format!("{good_names}0,0,0,0,0,0,0,2,0,0,0\n")),
        (
            "still.csv",
            format!("{good_names}{good_line}{good_line}{good_line}"),
        ),
        ("cut.mcap", String::from("\u{89}MCAP")),
    ];
    for (name, contents) in files {
        fs::write(path.join(name), contents).unwrap();
    }
    fs::write(path.join("bytes.csv"), b"t,x\n\xff").unwrap();
    let cases: &[(&str, &[&str], &[&str])] = &[
        (
            "empty.csv",
            &[],
            &["empty.csv: the table has no line of numbers"],
        ),
        (
            "names.csv",
            &[],
            &["names.csv: the table has no line of numbers"],
        ),
        (
            "still.csv",
            &[],
            &["still.csv: all 3 samples have the same time, 0 s", "--rate"],
        ),
        (
            "column.csv",
            &[],
            &["unknown column \"fz\"; known: ", "--csv-columns"],
        ),
        (
            "column.csv",
            &["--csv-columns", "force=force_z"],
            &["unknown column \"force\"; known: "],
        ),
        (
            "short.csv",
            &[],
            &["short.csv: line 3: it has 3 values, but the table has 11 names"],
        ),
        (
            "text.csv",
            &[],
            &["text.csv: line 3, column \"y\": \"zero\" is not a number"],
        ),
        (
            "nan.csv",
            &[],
            &["nan.csv: line 2: y is NaN, which is not finite"],
        ),
        (
            "back.csv",
            &[],
            &[
                "back.csv: line 3: its time of 0 s is 10 s earlier than the latest earlier time, 10 s; the limit is 5 s",
                "--reorder-s",
            ],
        ),
        (
            "late.csv",
            &[],
            &[
                "late.csv: line 2: the time ",
                "is not within 9000000000 s of 0",
            ],
        ),
        (
            "turn.csv",
            &[],
            &["turn.csv: line 2: the quaternion has a length of 2"],
        ),
        (
            "bytes.csv",
            &[],
            &["bytes.csv: byte 4: the table is not UTF-8 text"],
        ),
        ("cut.mcap", &[], &["cut.mcap: this is not a bag"]),
        (
            "old.bag",
            &[],
            &[
                "a bag of ROS 1",
                "rosbags-convert --src old.bag --dst old.converted --dst-storage mcap",
            ],
        ),
        (
            "log.db3",
            &[],
            &[
                "(.db3)",
                "rosbags-convert --src log.db3 --dst log.converted --dst-storage mcap",
            ],
        ),
        ("none.mcap", &[], &["none.mcap: there is no such file"]),
        (
            "log.mcap",
            &["--pose-topic", "/tcp/measurd"],
            &["log.mcap: unknown topic \"/tcp/measurd\"; nearest: /tcp/measured"],
        ),
        (
            "log.mcap",
            &["--pose-topic", "/tf:tol"],
            &["unknown frame \"tol\"", "nearest: tool"],
        ),
        (
            "log.mcap",
            &["--out", "."],
            &["the results would replace this folder"],
        ),
        (
            "log.mcap",
            &["--force-unit-n", "0"],
            &["is outside 1e-9 to 1e9"],
        ),
        (
            "log.mcap",
            &["--force-scale", "-2"],
            &["--force-scale", "-2", "is not above 0"],
        ),
        (
            "log.mcap",
            &["--force-bias", "0", "inf", "0"],
            &["--force-bias", "is not finite"],
        ),
        (
            "log.mcap",
            &["--payload-mass", "-1"],
            &["--payload-mass", "is below 0"],
        ),
        (
            "log.mcap",
            &["--payload-centre", "0", "0", "0.1"],
            &["--payload-mass"],
        ),
        (
            "log.mcap",
            &["--pose-offset", "0", "0", "0", "0", "nan", "0"],
            &["is not finite"],
        ),
        (
            "log.mcap",
            &["--wrench-frame", "flange"],
            &["world, log, tool, surface"],
        ),
    ];
    for (log, more, parts) in cases {
        let shown = refused(path, log, more);
        for part in *parts {
            assert!(shown.contains(part), "{log} {more:?}: {part} in {shown}");
        }
    }
}
