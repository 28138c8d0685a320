//! The program in a real temporary directory: what it writes, prints, and how it ends.

use crate::program::{command, contents, path, wisch as output};
use serde_json::Value;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// A folder with the template as board.toml.
fn folder_with_template() -> TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    command(folder.path())
        .args(["new", "board.toml"])
        .assert()
        .code(0);
    let schema = folder.path().join("wisch-task.schema.json");
    fs::remove_file(schema).expect("the schema beside it");
    folder
}

/// A folder with the template as board.toml, for a quarter of its board, planned by one strategy and without variants, which
/// is much faster.
fn folder_with_task() -> TempDir {
    let folder = folder_with_template();
    let file = folder.path().join("board.toml");
    let mut text = fs::read_to_string(&file).expect("the template");
    for (slow, fast) in [
        ("strategy = \"best\"", "strategy = \"kde\""),
        ("variants = 8", "variants = 1"),
        ("size_m = [0.40, 0.28]", "size_m = [0.20, 0.14]"),
    ] {
        assert!(text.contains(slow), "{slow}");
        text = text.replace(slow, fast);
    }
    fs::write(&file, text).expect("written");
    folder
}

fn json(text: &str) -> Value {
    serde_json::from_str(text).expect("exactly one JSON object")
}

/// The names in a folder, hidden ones included.
fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .expect("a folder")
        .map(|entry| {
            entry
                .expect("an entry")
                .file_name()
                .into_string()
                .expect("text")
        })
        .collect();
    names.sort();
    names
}

#[test]
fn run_writes_everything_and_says_where() {
    let folder = folder_with_task();
    let (code, out, err) = output(
        folder.path(),
        &["run", "board.toml", "--rounds", "1", "--out", "result"],
    );
    assert!(code == 0 || code == 1, "{code}: {err}");
    assert_eq!(err, "", "nothing of the progress reaches a pipe");
    assert!(out.contains("performance"), "{out}");
    assert!(out.contains("result/report.html"), "{out}");
    let written: Vec<String> = (contents(&folder.path().join("result")).into_iter())
        .map(|(name, _)| name)
        .collect();
    for name in [
        "plan.json",
        "particles/particles-before.csv",
        "particles/particles-after.csv",
        "report.html",
    ] {
        assert!(written.iter().any(|n| n == name), "{name} in {written:?}");
    }
    assert!(
        (written.iter()).any(|n| n.starts_with("figures/") && n.ends_with(".svg")),
        "{written:?}"
    );
    assert_eq!(
        names(folder.path()),
        ["board.toml", "episodes", "result"],
        "nothing is left behind"
    );
}

#[test]
fn the_json_summary_is_one_object_with_its_keys() {
    let folder = folder_with_task();
    let (_, out, _) = output(
        folder.path(),
        &["run", "board.toml", "--json", "--rounds", "1"],
    );
    let summary = json(&out);
    for key in [
        "schema",
        "task",
        "action",
        "strategy",
        "seed",
        "particles",
        "nodes",
        "edges",
        "strokes",
        "unreachable_share",
        "distance_in_contact_m",
        "distance_total_m",
        "predicted_performance",
        "target_performance",
        "goal_met",
        "lost_share",
        "planning_time_s",
        "out",
    ] {
        assert!(
            summary.get(key).is_some_and(|v| !v.is_null()),
            "{key} in {out}"
        );
    }
    let default_out = folder.path().join(summary["out"].as_str().expect("a path"));
    assert!(default_out.starts_with(folder.path().join("out")));
    assert!(default_out.join("report.html").is_file());
}

#[test]
fn the_plans_of_all_strategies_are_listed_with_why_one_is_taken() {
    let folder = folder_with_template();
    let few = ["--set", "plan.evaluations=2000"];
    let plan = |more: &[&str]| {
        let arguments = [&["plan", "board.toml"], &few[..], more].concat();
        let (code, out, err) = output(folder.path(), &arguments);
        assert_eq!((code, err.as_str()), (0, ""));
        out
    };
    let listed = json(&plan(&["--explain", "--json"]));
    let candidates = listed["candidates"].as_array().expect("a list");
    let names: Vec<_> = candidates
        .iter()
        .map(|one| one["strategy"].as_str())
        .collect();
    let all = ["grid", "rrt", "kde", "adaptive"].map(Some);
    assert_eq!(names, all);
    let score = |one: &Value| one["score"].as_f64().expect("a number");
    let most = candidates
        .iter()
        .map(score)
        .fold(f64::NEG_INFINITY, f64::max);
    for one in candidates {
        assert_eq!(one["chosen"], score(one) == most, "{one}");
        assert!(one["execution_time_s"].as_f64() > Some(5.0), "{one}");
        assert!(one["covered_share"].as_f64() <= Some(1.0), "{one}");
        assert!(one["error"].is_null(), "{one}");
        if one["chosen"] == true {
            assert_eq!(one["strategy"], listed["strategy"]);
            assert_eq!(
                one["distance_in_contact_m"],
                listed["distance_in_contact_m"]
            );
        }
    }
    assert!(plan(&["--explain"]).contains(" has the highest score, 0."));
    // A requested plan that is not the best is marked as requested.
    let grid = plan(&["--explain", "--strategy", "grid"]);
    assert!(grid.contains("  * grid "), "{grid}");
    assert!(
        grid.contains("grid was requested; --strategy best would choose"),
        "{grid}"
    );
    // Nobody asked.
    assert!(json(&plan(&["--json"])).get("candidates").is_none());
}

#[test]
fn the_exit_code_follows_the_target() {
    let folder = folder_with_task();
    let run = |target: &str| {
        let setting = format!("target_performance={target}");
        // The memory of the first run would be stated to be too small for warnings of the second.
        let one_round = [
            "run",
            "board.toml",
            "--json",
            "--rounds",
            "1",
            "--no-memory",
            "--set",
        ];
        let (code, out, err) = output(folder.path(), &[&one_round[..], &[&setting]].concat());
        assert_eq!(err, "");
        let summary = json(&out);
        // The template's plan leaves something: otherwise a target of all would say nothing.
        let predicted = summary["predicted_performance"].as_f64();
        assert!(predicted < Some(1.0), "{predicted:?}");
        (code, summary["goal_met"].as_bool().expect("a truth"))
    };
    assert_eq!(run("0.0"), (0, true));
    assert_eq!(run("1.0"), (1, false));
}

#[test]
fn a_plan_can_be_predicted_later_with_the_same_result() {
    let folder = folder_with_task();
    for action in ["absorb", "collect", "skim"] {
        // Which plan is the best is a question of the robot; which the search finds is not.
        let adaptive = "strategy=\"adaptive\"";
        // Of several strokes.
        let size = "surface.size_m=[0.40, 0.28]";
        let set = ["--set", adaptive, "--set", size];
        let task = [&["board.toml", "--action", action], &set[..]].concat();
        let (code, _, err) = output(
            folder.path(),
            &[&["plan"], &task[..], &["--out", "planned"]].concat(),
        );
        assert_eq!((code, err.as_str()), (0, ""));
        let planned = folder.path().join("planned");
        let written: Vec<String> = contents(&planned)
            .into_iter()
            .map(|(name, _)| name)
            .collect();
        let files = [
            "particles/particles-before.csv",
            "plan.json",
            "trajectories/tcp-path.csv",
        ];
        assert_eq!(written, files);
        let path = fs::read_to_string(planned.join("trajectories/tcp-path.csv")).expect("a table");
        let (mut time, mut phases) = (0.0, Vec::new());
        for line in path.lines().skip(1) {
            let fields: Vec<&str> = line.split(',').collect();
            let [at, height]: [f64; 2] =
                [fields[0], fields[5]].map(|f| f.parse().expect("a number"));
            assert!(at >= time, "{line}");
            time = at;
            // The board's face is 0.75 m up.
            assert!(fields[1] != "wipe" || height == 0.75, "{line}");
            assert!(fields[1] != "lifted" || height > 0.79, "{line}");
            if phases.last() != Some(&fields[1]) {
                phases.push(fields[1]);
            }
        }
        assert_eq!(phases[..5], ["lifted", "lower", "wipe", "lift", "lifted"]);
        let (_, direct, _) = output(
            folder.path(),
            // A prediction of the plan itself, not of how a robot follows it.
            &[
                &["run", "--robot", "none"],
                &task[..],
                &["--json", "--out", "direct"],
            ]
            .concat(),
        );
        let (_, later, err) = output(
            folder.path(),
            &[
                &["predict"],
                &task[..],
                &["--json", "--out", "later", "--plan", "planned/plan.json"],
            ]
            .concat(),
        );
        // Strokes of a plan from a file are checked, and a skim leaves the surface as it may.
        let told = "leave the surface by at most 0.055 m over a skim edge, as a skim does\n";
        assert!(
            err.is_empty() || err.ends_with(told) && err.lines().count() == 1,
            "{err}"
        );
        let (direct, later) = (json(&direct), json(&later));
        assert_eq!(
            direct["predicted_performance"],
            later["predicted_performance"]
        );
        assert!(later["planning_time_s"].is_null());
        assert!(
            contents(&folder.path().join("direct")) == contents(&folder.path().join("later")),
            "{action}: other bytes"
        );
    }
}

#[test]
fn the_same_task_and_seed_give_the_same_bytes_on_any_number_of_threads() {
    let folder = folder_with_task();
    let run = |threads: &str, more: &[&str]| {
        let args = ["run", "board.toml", "--threads", threads, "--out", "result"];
        output(folder.path(), &[&args[..], more].concat());
        let contents = contents(&folder.path().join("result"));
        assert!(!contents.is_empty());
        contents
    };
    for strategy in ["grid", "rrt", "kde"] {
        let planned = ["--strategy", strategy, "--robot", "none"];
        let one = run("1", &planned);
        for threads in ["1", "2", "4"] {
            let is_same = one == run(threads, &planned);
            assert!(is_same, "{strategy} on {threads} threads");
        }
    }
    // With the robot, once: following and interpreting are parallel too.
    let executed = ["--rounds", "1"];
    assert!(run("1", &executed) == run("4", &executed));
}

#[test]
fn another_seed_gives_other_particles() {
    let folder = folder_with_task();
    let before = |seed: &str| {
        output(
            folder.path(),
            &["plan", "board.toml", "--seed", seed, "--out", "result"],
        );
        fs::read(folder.path().join("result/particles/particles-before.csv")).expect("particles")
    };
    assert_ne!(before("1"), before("2"));
}

#[test]
fn particles_are_conserved_in_the_files() {
    let folder = folder_with_task();
    for action in ["absorb", "collect", "skim"] {
        output(
            folder.path(),
            &[
                "run",
                "board.toml",
                "--robot",
                "none",
                "--action",
                action,
                "--out",
                "result",
            ],
        );
        let rows = |name: &str| {
            let mut csv =
                csv::Reader::from_path(folder.path().join("result").join(name)).expect("a file");
            assert_eq!(
                csv.headers().expect("headers"),
                ["particle", "x_m", "y_m", "fate", "edge"].as_slice()
            );
            csv.records()
                .map(|row| row.expect("a row"))
                .collect::<Vec<_>>()
        };
        let (before, after) = (
            rows("particles/particles-before.csv"),
            rows("particles/particles-after.csv"),
        );
        assert_eq!(before.len(), after.len());
        assert!(before.iter().all(|row| &row[3] == "on_surface"));
        for (index, row) in after.iter().enumerate() {
            assert_eq!(row[0], index.to_string());
            assert_eq!(&row[3] == "off_surface", !row[4].is_empty());
            assert!(row[1].parse::<f64>().is_ok() && row[2].parse::<f64>().is_ok());
        }
    }
}

#[test]
fn results_of_an_earlier_run_are_replaced_and_nothing_else() {
    let folder = folder_with_task();
    let args = ["run", "board.toml", "--robot", "none", "--out", "result"];
    let run = || output(folder.path(), &args);
    let result = folder.path().join("result");
    run();
    assert_ne!(run().0, 2, "our own results are replaced");

    fs::write(result.join("notes.txt"), "mine").expect("a note");
    let (code, _, err) = run();
    assert_eq!(code, 2);
    assert!(err.contains("notes.txt"), "{err}");
    assert_eq!(
        fs::read_to_string(result.join("notes.txt")).expect("a note"),
        "mine"
    );

    fs::remove_dir_all(&result).expect("removed");
    fs::create_dir(&result).expect("a folder");
    assert_ne!(run().0, 2, "an empty folder is filled");

    fs::write(result.join("plan.json"), "{\"format\": \"other\"}").expect("a plan of others");
    let (code, _, err) = run();
    assert_eq!(code, 2);
    assert!(err.contains("contains no plan.json of wisch"), "{err}");

    fs::remove_dir_all(&result).expect("removed");
    fs::write(&result, "a file").expect("a file");
    let (code, _, err) = run();
    assert_eq!(code, 2);
    assert!(err.contains("but this is a file"), "{err}");
    assert_eq!(
        names(folder.path()),
        ["board.toml", "result"],
        "nothing is left behind"
    );
}

#[test]
fn a_failed_run_leaves_earlier_results_alone() {
    let folder = folder_with_task();
    let run = ["run", "board.toml", "--robot", "none", "--out", "result"];
    output(folder.path(), &run);
    let before = contents(&folder.path().join("result"));
    let wrong = ["--set", "no.such.key=1"];
    let (code, ..) = output(folder.path(), &[&run[..], &wrong].concat());
    assert_eq!(code, 2);
    assert!(before == contents(&folder.path().join("result")));
    assert_eq!(names(folder.path()), ["board.toml", "result"]);
}

#[test]
fn new_does_not_overwrite_unless_forced() {
    let folder = folder_with_template();
    let task = folder.path().join("board.toml");
    let template = fs::read_to_string(&task).expect("a task");
    let (code, printed, _) = output(folder.path(), &["new"]);
    assert_eq!((code, printed.as_str()), (0, template.as_str()));
    fs::write(&task, "mine").expect("a file");
    let (code, _, err) = output(folder.path(), &["new", "board.toml"]);
    assert_eq!(code, 2);
    assert!(
        err.contains("board.toml") && err.contains("--force"),
        "{err}"
    );
    assert_eq!(fs::read_to_string(&task).expect("a file"), "mine");
    assert_eq!(
        output(folder.path(), &["new", "board.toml", "--force"]).0,
        0
    );
    assert_eq!(fs::read_to_string(&task).expect("a task"), template);
}

#[test]
fn check_explains_the_task() {
    let folder = folder_with_task();
    let (code, out, err) = output(folder.path(), &["check", "board.toml"]);
    assert_eq!((code, err.as_str()), (0, ""));
    for word in [
        "surface",
        "tool",
        "r_s",
        "particles",
        "obstacles",
        "free",
        "nodes",
        "goal       all particles lie within",
        "% of the particles reach the goal",
        "target",
    ] {
        assert!(out.contains(word), "{word} in {out}");
    }
    assert_eq!(names(folder.path()), ["board.toml"], "it writes nothing");
}

#[test]
fn footprints_of_every_tool_are_measured_and_drawn() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for tool in ["sponge", "broom", "window_wiper", "brush", "vacuum_nozzle"] {
        let svg = format!("{tool}.svg");
        let (code, out, err) = output(folder.path(), &["footprint", tool, "--svg", &svg]);
        assert_eq!((code, err.as_str()), (0, ""));
        for word in ["pieces", "holes", "area", "area of effect", "r_s", "d_s"] {
            assert!(out.contains(word), "{word} in {out}");
        }
        assert!(
            fs::read_to_string(folder.path().join(svg))
                .expect("a drawing")
                .starts_with("<svg")
        );
    }
    // 0.07 m x 0.11 m, whose diagonal is 0.1304 m.
    let (_, out, _) = output(folder.path(), &["footprint", "sponge"]);
    assert!(
        out.contains("0.007700 m2") && out.contains("0.1304 m"),
        "{out}"
    );
}

#[test]
fn a_mesh_file_has_a_footprint_once_its_depth_is_known() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let wedge = "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    fs::write(folder.path().join("wedge.obj"), wedge).expect("a mesh");
    let (code, _, err) = output(folder.path(), &["footprint", "wedge.obj"]);
    assert_eq!(code, 2);
    assert!(
        err.contains("wedge.obj") && err.contains("--compression-depth-m"),
        "{err}"
    );
    let (code, out, _) = output(
        folder.path(),
        &["footprint", "wedge.obj", "--compression-depth-m", "0.002"],
    );
    assert_eq!(code, 0);
    // Half of 0.1 m x 0.1 m.
    assert!(out.contains("0.005000 m2"), "{out}");
}

#[test]
fn knowledge_may_come_from_a_folder() {
    let folder = folder_with_task();
    let knowledge = concat!(env!("CARGO_MANIFEST_DIR"), "/../../knowledge");
    let run = |extra: &[&str]| {
        output(
            folder.path(),
            &[
                &["run", "board.toml", "--robot", "none", "--out", "result"],
                extra,
            ]
            .concat(),
        );
        contents(&folder.path().join("result"))
    };
    assert!(run(&[]) == run(&["--knowledge", knowledge]));
    let (code, _, err) = output(
        folder.path(),
        &["run", "board.toml", "--knowledge", "nowhere"],
    );
    assert_eq!(code, 2);
    assert!(err.contains("nowhere"), "{err}");
    fs::create_dir(folder.path().join("empty")).expect("a folder");
    let (code, _, err) = output(
        folder.path(),
        &["check", "board.toml", "--knowledge", "empty"],
    );
    assert_eq!(code, 2);
    assert!(
        err.contains("empty: the folder holds no .toml file"),
        "{err}"
    );
}

#[test]
fn quiet_prints_nothing_and_color_is_obeyed() {
    let folder = folder_with_task();
    for args in [
        &["run", "board.toml", "--quiet", "--rounds", "1"][..],
        &["check", "board.toml", "-q"],
        &["footprint", "sponge", "-q"],
    ] {
        let (_, out, err) = output(folder.path(), args);
        assert_eq!((out.as_str(), err.as_str()), ("", ""), "{args:?}");
    }
    let colored = |args: &[&str]| output(folder.path(), args).2.contains('\x1b');
    for wrong in [["check", "nope.toml"], ["check", "--nope"]] {
        assert!(!colored(&wrong), "{wrong:?}");
        assert!(
            colored(&[&wrong[..], &["--color", "always"]].concat()),
            "{wrong:?}"
        );
        assert!(
            !colored(&[&wrong[..], &["--color=never"]].concat()),
            "{wrong:?}"
        );
    }
}

#[test]
fn every_help_ends_with_examples() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for command in [
        "run",
        "plan",
        "predict",
        "footprint",
        "new",
        "check",
        "scenarios",
        "schema",
        "man",
        "completions",
    ] {
        let (code, out, _) = output(folder.path(), &[command, "--help"]);
        assert_eq!(code, 0);
        let (_, examples) = out.split_once("Examples:").expect("examples");
        assert!(examples.contains(&format!("wisch {command}")), "{examples}");
    }
    assert!(output(folder.path(), &["--help"]).1.contains("Examples:"));
}

#[test]
#[cfg(unix)]
fn a_reader_that_goes_away_is_no_error() {
    let folder = folder_with_task();
    let program = path();
    for args in [
        "new",
        "check board.toml",
        "run board.toml --json --robot none --set target_performance=0.0",
        "--help",
    ] {
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        let output = std::process::Command::new(&program)
            .args(args.split(' '))
            .current_dir(folder.path())
            .stdout(writer)
            .output()
            .expect("it runs");
        assert_eq!(output.status.code(), Some(0), "{args}");
        assert_eq!(String::from_utf8_lossy(&output.stderr), "", "{args}");
    }
}

#[test]
fn a_new_task_meets_its_goal() {
    let folder = folder_with_task();
    let (code, out, err) = output(folder.path(), &["run", "board.toml", "--json"]);
    assert_eq!(code, 0, "{out}{err}");
}

#[test]
fn scenarios_are_found_anywhere_by_name() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (code, list, _) = output(folder.path(), &["scenarios"]);
    assert_eq!(code, 0);
    assert!(list.contains("\nchopping-board "), "{list}");
    let (code, text, _) = output(folder.path(), &["scenarios", "chopping-board"]);
    assert_eq!(code, 0);
    fs::write(folder.path().join("copy.toml"), text).expect("a file");
    let plan = |task: &str| {
        let (code, out, err) = output(folder.path(), &["plan", task, "--out", task, "--quiet"]);
        assert_eq!(code, 0, "{out}{err}");
        fs::read(folder.path().join(task).join("plan.json")).expect("a plan")
    };
    let by_name = plan("chopping-board");
    fs::rename(
        folder.path().join("copy.toml"),
        folder.path().join("it.toml"),
    )
    .expect("renamed");
    let (code, _, _) = output(
        folder.path(),
        &["plan", "it.toml", "--out", "it", "--quiet"],
    );
    assert_eq!(code, 0);
    assert!(by_name == fs::read(folder.path().join("it/plan.json")).expect("a plan"));
    let (code, _, err) = output(folder.path(), &["plan", "chopping-bord"]);
    assert_eq!(code, 2);
    assert!(err.contains("did you mean chopping-board?"), "{err}");
}

#[test]
fn the_schema_is_that_which_stands_beside_a_new_task() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    assert_eq!(output(folder.path(), &["new", "board.toml"]).0, 0);
    let task = fs::read_to_string(folder.path().join("board.toml")).expect("a task");
    let named = task
        .lines()
        .next()
        .and_then(|line| line.strip_prefix("#:schema "));
    let beside = folder
        .path()
        .join(named.expect("the schema in the first line"));
    let (code, printed, _) = output(folder.path(), &["schema"]);
    assert_eq!(code, 0);
    assert_eq!(printed, fs::read_to_string(beside).expect("a schema"));
    assert_eq!(
        json(&printed)["properties"]["target_performance"]["maximum"],
        1.0
    );
}

#[test]
fn shells_complete_the_commands_and_a_manual_shows_them() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let (code, script, _) = output(folder.path(), &["completions", shell]);
        assert_eq!(code, 0);
        assert!(script.contains("interpret"), "{shell}");
    }
    assert_eq!(output(folder.path(), &["man", "man1"]).0, 0);
    let page = fs::read_to_string(folder.path().join("man1/wisch-run.1")).expect("a page");
    assert!(page.contains("seed"), "{page}");
}

#[test]
fn what_a_run_measured_is_not_replaced_by_less() {
    let folder = folder_with_task();
    let run = [
        "run",
        "board.toml",
        "--rounds",
        "1",
        "--quiet",
        "--out",
        "here",
    ];
    assert!(output(folder.path(), &run).0 < 2);
    let bag = folder.path().join("here/telemetry/round-1.mcap");
    assert!(bag.is_file());
    for command in ["predict", "plan", "follow"] {
        let (code, _, err) = output(folder.path(), &[command, "board.toml", "--out", "here"]);
        assert_eq!(code, 2, "{command}");
        assert!(
            err.contains("a run's measurements") && err.contains("--force"),
            "{err}"
        );
        assert!(bag.is_file(), "{command}");
    }
    let forced = ["plan", "board.toml", "--out", "here", "--force", "--quiet"];
    assert_eq!(output(folder.path(), &forced).0, 0);
    assert!(!bag.exists());
}

#[test]
fn an_error_is_one_json_object_where_one_is_asked_for() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (args, expected) in [
        (
            &["run", "none.toml", "--json"][..],
            "none.toml: there is no such file",
        ),
        (
            &["run", "--json", "--bla"],
            "unexpected argument '--bla' found",
        ),
    ] {
        let (code, out, err) = output(folder.path(), args);
        assert_eq!(code, 2);
        assert_eq!(json(&out)["error"], expected);
        assert!(err.contains(expected), "{err}");
    }
    let (_, out, _) = output(folder.path(), &["run", "none.toml"]);
    assert_eq!(out, "");
}

#[test]
#[cfg(unix)]
fn a_pipe_that_nobody_writes_into_is_not_waited_for_for_ever() {
    let folder = folder_with_task();
    let task = fs::read(folder.path().join("board.toml")).expect("a task");
    let pipe = folder.path().join("pipe.toml");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    assert!(made.expect("mkfifo").success());
    let writer = std::thread::spawn({
        let pipe = pipe.clone();
        move || fs::write(pipe, task)
    });
    assert_eq!(
        output(folder.path(), &["plan", "pipe.toml", "--quiet"]).0,
        0
    );
    writer.join().expect("a writer").expect("written");
    let (code, _, err) = output(folder.path(), &["plan", "pipe.toml"]);
    assert_eq!(code, 2);
    assert!(
        err.contains("pipe.toml: no data arrived on this pipe"),
        "{err}"
    );
}

/// 3,000 boxes on a shelf above the board, which no pair by pair comparison gets through.
#[test]
fn a_task_with_thousands_of_boxes_is_checked() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut task = fs::read_to_string(crate::program::root().join("scenarios/chopping-board.toml"))
        .expect("read");
    for i in 0..3000 {
        let (x, y) = (0.1 * f64::from(i % 60) - 3.0, 0.1 * f64::from(i / 60) - 2.5);
        task += &format!(
            "\n[[scene]]\nname = \"box_{i}\"\nbox_m = [0.02, 0.02, 0.02]\nposition_m = [{x:.2}, {y:.2}, 2.6]\n"
        );
    }
    fs::write(folder.path().join("boxes.toml"), task).expect("written");
    let (code, out, err) = output(folder.path(), &["check", "boxes.toml"]);
    assert_eq!(code, 0, "{out}{err}");
    assert!(out.contains("the hand of link \"right_tcp\""), "{out}");
}
