//! Every command that plans makes the same plan, whatever it does with it.

use crate::program::{command, root, wisch};
use std::fs;
use std::path::{Path, PathBuf};

fn scenarios() -> Vec<PathBuf> {
    let mut found: Vec<PathBuf> = fs::read_dir(root().join("scenarios"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        // Each step of a goal of several parts has a plan of its own.
        .filter(|path| !fs::read_to_string(path).unwrap().contains("(and "))
        .collect();
    found.sort();
    assert!(found.len() >= 10, "{found:?}");
    found
}

/// The plan that a command writes.
fn plan(words: &[&str], scenario: &Path, out: &Path) -> String {
    let mut command = command(out.parent().unwrap());
    command.arg(words[0]).arg(scenario).args(&words[1..]);
    let done = command
        .arg("--quiet")
        .arg("--out")
        .arg(out)
        .output()
        .unwrap();
    let code = done.status.code();
    let errors = String::from_utf8_lossy(&done.stderr);
    assert!(
        matches!(code, Some(0 | 1)),
        "{words:?} {scenario:?}: {errors}"
    );
    fs::read_to_string(out.join("plan.json")).unwrap()
}

#[test]
fn all_commands_make_the_same_plan_of_every_scenario() {
    let folder = tempfile::tempdir().unwrap();
    for scenario in scenarios() {
        let name = scenario.file_stem().unwrap().to_string_lossy().into_owned();
        let out = |command: &str| folder.path().join(format!("{name}-{command}"));
        let planned = plan(&["plan"], &scenario, &out("plan"));
        assert_eq!(
            plan(&["predict"], &scenario, &out("predict")),
            planned,
            "{name}"
        );
        let blind = ["run", "--robot", "none"];
        assert_eq!(plan(&blind, &scenario, &out("run")), planned, "{name}");
    }
}

#[test]
fn following_and_running_make_the_same_plan_too() {
    let folder = tempfile::tempdir().unwrap();
    // With one candidate, and with several of which the predicted effect chooses.
    for name in ["arm-board", "failure-human-push"] {
        let scenario = root().join(format!("scenarios/{name}.toml"));
        let out = |command: &str| folder.path().join(format!("{name}-{command}"));
        let few = ["--set", "plan.evaluations=3000"];
        let planned = plan(&[&["plan"], &few[..]].concat(), &scenario, &out("plan"));
        let followed = plan(&[&["follow"], &few[..]].concat(), &scenario, &out("follow"));
        assert_eq!(followed, planned, "{name}");
        // A run that looks first plans for what it sees.
        let once = ["run", "--rounds", "1", "--no-memory", "--touch-only"];
        let run = plan(&[&once[..], &few].concat(), &scenario, &out("run"));
        assert_eq!(run, planned, "{name}");
    }
}

#[test]
fn a_search_tries_as_many_plans_as_its_budget_says() {
    let folder = tempfile::tempdir().unwrap();
    let board = Path::new("chopping-board");
    let planned = |words: &[&str], to: &str| {
        let words = [&["plan", "--strategy", "adaptive"], words].concat();
        plan(&words, board, &folder.path().join(to))
    };
    let few = planned(&["--budget", "3000"], "few");
    assert_eq!(planned(&["--set", "plan.evaluations=3000"], "set"), few);
    assert_ne!(planned(&["--budget", "9000"], "more"), few);

    // With a time, the message states the number of tried plans; that number gives the same plan.
    let mut timed = command(folder.path());
    timed.args(["plan", "chopping-board", "--strategy", "adaptive"]);
    let timed = timed
        .args(["--budget", "400ms", "--out", "timed"])
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&timed.stderr);
    assert_eq!(timed.status.code(), Some(0), "{said}");
    let number = said
        .split("--budget ")
        .nth(1)
        .and_then(|rest| rest.split(' ').next());
    let again = planned(&["--budget", number.expect("a number of plans")], "again");
    let timed = fs::read_to_string(folder.path().join("timed/plan.json")).unwrap();
    assert_eq!(again, timed, "{said}");

    for (strategy, budget) in [("kde", "3000"), ("adaptive", "2h"), ("adaptive", "0")] {
        let mut refused = command(folder.path());
        refused.args(["plan", "chopping-board", "--strategy", strategy]);
        let refused = refused.args(["--budget", budget]).output().unwrap();
        let said = String::from_utf8_lossy(&refused.stderr);
        assert_eq!(refused.status.code(), Some(2), "{said}");
        assert!(
            said.contains("budget") || said.contains("evaluations"),
            "{said}"
        );
    }
}

/// A board of 0.6 x 0.4 m with a hole in its middle that leans by an angle [rad], and 60 particles on it.
fn leaning_board(folder: &Path, slope: f64, kind: &str) {
    let text = format!(
        r#"
schema = 1
name = "leaning"
seed = 1
action = "absorb"

[tool]
name = "eraser"
footprint_m = [0.06, 0.12]

[medium]
name = "chalk"
kind = "{kind}"

[surface]
name = "whiteboard"
friction = 0.3
size_m = [0.60, 0.40]
holes_m = [[[-0.1, -0.1], [0.1, -0.1], [0.1, 0.1], [-0.1, 0.1]]]
position_m = [0.5, 0.0, 0.3]
rpy_rad = [0.0, -{slope}, 0.0]

[robot]
name = "arm7"

[particles]
source = "uniform"
count = 60
"#
    );
    fs::write(folder.join("task.toml"), text).unwrap();
}

#[test]
fn powder_that_slides_off_a_slope_is_reported_before_anything_is_wiped() {
    let folder = tempfile::tempdir().unwrap();
    // tan(0.7) = 0.84 exceeds the 0.8 up to which grains are taken to hold.
    leaning_board(folder.path(), 0.7, "powder");
    let (code, out, err) = wisch(folder.path(), &["check", "task.toml"]);
    assert_eq!(code, 1, "{err}");
    let slides = "tan(40.1°) = 0.84 exceeds the friction of the dirt on it, 0.8: 60 of 60 particles slide off before the first round";
    assert!(
        out.contains(slides) && out.contains("score of -3.00"),
        "{out}"
    );
    assert!(!out.contains("is valid"), "{out}");
    let (code, out, _) = wisch(
        folder.path(),
        &["predict", "task.toml", "--json", "--out", "p"],
    );
    let summary: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(
        (code, &summary["predicted_performance"]),
        (1, &0.0.into()),
        "{out}"
    );
    let (code, _, err) = wisch(folder.path(), &["run", "task.toml", "--out", "r"]);
    assert_eq!(code, 2, "{err}");
    assert!(
        err.contains("to lose 100.0 %, a score of -3.00") && err.contains("min_score"),
        "{err}"
    );

    // What is wet holds up to 1.5, and grains to 0.8.
    for (slope, kind, degrees) in [(0.7, "liquid", 40), (0.6, "powder", 34)] {
        leaning_board(folder.path(), slope, kind);
        for command in ["check", "plan"] {
            let (code, out, err) = wisch(folder.path(), &[command, "task.toml"]);
            let stays = format!(
                "note: gravity: chalk is assumed to stay in place on a surface that leans by {degrees}°; "
            );
            assert!(code != 2 && err.contains(&stays), "{out}{err}");
        }
    }
    // A level board, and one on which grains rest by every usual friction.
    for (slope, kind) in [(0.01, "liquid"), (0.19, "powder")] {
        leaning_board(folder.path(), slope, kind);
        let (_, _, err) = wisch(folder.path(), &["check", "task.toml"]);
        assert!(!err.contains("gravity:"), "{err}");
    }
}

#[test]
fn dirt_of_a_declared_friction_slides_on_a_leaning_board_and_in_a_gutter() {
    let folder = tempfile::tempdir().unwrap();
    leaning_board(folder.path(), 0.5, "powder");
    let run = |command: &str, settings: &[&str]| {
        let settings = settings.iter().flat_map(|setting| ["--set", setting]);
        let args: Vec<&str> = [command, "task.toml"].into_iter().chain(settings).collect();
        wisch(folder.path(), &args)
    };
    // tan(0.5) = 0.55.
    let (_, out, err) = run("check", &["medium.static_friction=0.6"]);
    assert!(
        out.contains("is valid") && !err.contains("gravity"),
        "{out}{err}"
    );
    let (_, out, err) = run("check", &["medium.static_friction=0.5"]);
    let slides = "tan(28.6°) = 0.55 exceeds the friction of the dirt on it, 0.5: 60 of 60 particles slide off";
    assert!(out.contains(slides) && err.contains(slides), "{out}{err}");
    let gutter = [
        "surface.shape=cylinder",
        "surface.radius_m=-0.25",
        "surface.axis_rad=1.5707963",
        "surface.rpy_rad=[0, 0, 0]",
        "surface.holes_m=[]",
    ];
    let refused = run("check", &gutter);
    assert!(
        refused.0 == 2
            && refused
                .2
                .contains("grains need a declared friction (medium.static_friction)"),
        "{refused:?}"
    );
    let declared = ["medium.static_friction=0.6", "medium.kinetic_friction=0.4"];
    let (_, out, err) = run("check", &[&gutter[..], &declared].concat());
    assert!(
        err.contains("particles slide down and come to rest, and 0 of 60"),
        "{out}{err}"
    );
    for (settings, problem) in [
        (
            &["medium.kinetic_friction=0.4"][..],
            "this key needs static_friction",
        ),
        (
            &["medium.static_friction=0.4", "medium.kinetic_friction=0.5"],
            "0.5 exceeds static_friction, which is 0.4",
        ),
        (
            &["medium.kind=liquid", "medium.static_friction=0.4"],
            "a liquid has no friction",
        ),
        (&["medium.static_friction=3"], "2"),
    ] {
        let (code, _, err) = run("check", settings);
        assert!(
            code == 2 && err.contains(problem) && err.contains("friction"),
            "{err}"
        );
    }
}

#[test]
fn a_liquid_of_a_declared_viscosity_runs_down_a_leaning_board() {
    let folder = tempfile::tempdir().unwrap();
    leaning_board(folder.path(), 0.5, "liquid");
    let check = |settings: &[&str]| {
        let settings = settings.iter().flat_map(|setting| ["--set", setting]);
        let args: Vec<&str> = ["check", "task.toml"].into_iter().chain(settings).collect();
        let (code, out, err) = wisch(folder.path(), &args);
        (code, format!("{out}{err}"))
    };
    // 0.1 mm over 0.2 m², and 1 mm.
    let thin = ["medium.viscosity_pa_s=0.005", "medium.volume_m3=0.00002"];
    let thick = ["medium.viscosity_pa_s=0.001", "medium.volume_m3=0.0002"];
    let gutter = [
        &thin[..],
        &["surface.shape=cylinder", "surface.radius_m=-2.0"],
        &["surface.holes_m=[]"],
    ];
    for (settings, note) in [
        (
            &thin[..],
            "gravity: chalk runs down the surface, which leans by 29°: a film of 0.100 mm at 3.1 mm/s\n",
        ),
        (&thick, "; waves carry part of a film thicker than 0.26"),
        (
            &[&thin[..], &["medium.adhering_thickness_m=0.0002"]].concat(),
            "gravity: chalk adheres to the surface, which leans by 29°: a film of 0.100 mm is not thicker than the 0.200 mm",
        ),
        (
            &[],
            "by 29°; declare medium.viscosity_pa_s and medium.volume_m3 to let it run down",
        ),
        (&gutter.concat(), "liquids run on planes that face up only"),
        (
            &thin[..1],
            "by 29°; declare medium.viscosity_pa_s and medium.volume_m3",
        ),
    ] {
        let (code, text) = check(settings);
        assert!(code != 2 && text.contains(note), "{text}");
    }
    for (settings, problem) in [
        (&thin[1..], "volume_m3 needs the viscosity of the liquid"),
        (
            &["medium.density_kg_per_m3=900"],
            "density_kg_per_m3 needs viscosity_pa_s",
        ),
        (
            &["medium.kind=powder", "medium.viscosity_pa_s=0.1"],
            "only a liquid has a viscosity",
        ),
        (&["medium.viscosity_pa_s=0"], "0.0001"),
    ] {
        let (code, text) = check(settings);
        assert!(code == 2 && text.contains(problem), "{text}");
    }
}

#[test]
fn strokes_of_an_edited_plan_over_a_hole_or_off_the_surface_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    leaning_board(folder.path(), 0.2, "liquid");
    let args = ["plan", "task.toml", "--out", "planned", "--quiet"];
    assert_eq!(wisch(folder.path(), &args).0, 0);
    let file = folder.path().join("planned/plan.json");
    let plan: serde_json::Value = serde_json::from_str(&fs::read_to_string(file).unwrap()).unwrap();
    let refused = |stroke: [[f64; 2]; 2]| {
        let mut plan = plan.clone();
        plan["strategy"] = "own".into();
        plan["nodes"] = serde_json::json!(
            stroke.map(|at| serde_json::json!({"role": "coverage", "in_surface_m": at}))
        );
        plan["edges"] = serde_json::json!([[0, 1]]);
        let poses =
            stroke.map(|[x, y]| serde_json::json!({"x_m": x, "y_m": y, "heading_rad": 0.0}));
        plan["strokes"] = serde_json::json!([{"nodes": [0, 1], "surface_from_tool": poses}]);
        fs::write(folder.path().join("own.json"), plan.to_string()).unwrap();
        wisch(
            folder.path(),
            &[
                "predict",
                "task.toml",
                "--plan",
                "own.json",
                "--out",
                "predicted",
            ],
        )
    };
    let (code, _, err) = refused([[-0.25, 0.0], [0.25, 0.0]]);
    assert_eq!(code, 2, "{err}");
    assert!(
        err.contains("own.json: strokes[0] presses the tool over a hole"),
        "{err}"
    );
    assert!(err.contains("for 0.200 m about (0.000, 0.000) m"), "{err}");
    let (code, _, err) = refused([[-0.25, 0.15], [0.45, 0.15]]);
    assert_eq!(code, 2, "{err}");
    assert!(err.contains("leaves the surface by 0.150 m"), "{err}");
    let (code, _, err) = refused([[-0.25, 0.15], [0.25, 0.15]]);
    assert_eq!(code, 1, "{err}");
}

#[test]
fn a_plan_for_known_dirt_is_another_than_one_for_all_that_is_believed() {
    let folder = tempfile::tempdir().unwrap();
    let settings = ["--strategy", "adaptive", "--set", "plan.evaluations=3000"];
    let scenario = root().join("scenarios/arm-board.toml");
    let out = |name: &str| folder.path().join(name);
    let believed = plan(
        &[&["plan"], &settings[..]].concat(),
        &scenario,
        &out("believed"),
    );
    let known = [&["plan", "--known-dirt"], &settings[..]].concat();
    let known = plan(&known, &scenario, &out("known"));
    assert_ne!(believed, known);
}

#[test]
fn a_plan_for_another_pose_tool_or_goal_is_used_with_a_remark() {
    let folder = tempfile::tempdir().unwrap();
    let (code, _, errors) = wisch(
        folder.path(),
        &["plan", "chopping-board", "--out", "p", "--quiet"],
    );
    assert_eq!(code, 0, "{errors}");
    let predict = |set: &[&str]| {
        let words = ["predict", "chopping-board", "--plan", "p/plan.json"];
        let words = [&words[..], &["--out", "o"], set].concat();
        wisch(folder.path(), &words).2
    };
    let same = predict(&[]);
    assert!(!same.contains("the plan "), "{same}");
    let goal = predict(&["--set", "collect.goal_m=[0.1, 0.0]"]);
    let needed = "the plan collects at (0.130, -0.080) m, the task collects at (0.100, 0.000) m";
    assert!(goal.contains(needed), "{goal}");
    let tool = predict(&["--set", "tool.footprint_m=[0.06, 0.10]"]);
    assert!(tool.contains("has 58.3 mm"), "{tool}");

    // What follows from strokes and task is made anew, whatever the file says of it.
    let file = folder.path().join("p/plan.json");
    let mut plan: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(&file).unwrap()).unwrap();
    plan["unreachable_share"] = 0.7.into();
    plan["tcp_path"][0]["height_m"] = 3.0.into();
    let predict_file = || {
        let words = ["predict", "chopping-board", "--plan", "p/plan.json"];
        wisch(folder.path(), &[&words[..], &["--out", "o"]].concat())
    };
    let predict = |plan: &serde_json::Value| {
        fs::write(&file, plan.to_string()).unwrap();
        predict_file()
    };
    let (_, out, errors) = predict(&plan);
    assert!(errors.contains("tcp_path differs"), "{errors}");
    assert!(out.contains("out of reach       0.0 %"), "{out}");
    plan.as_object_mut().unwrap().remove("tcp_path");
    let (_, _, errors) = predict(&plan);
    assert!(!errors.contains("tcp_path"), "{errors}");
    plan["strokes"][0]["surface_from_tool"][0]["heading_rad"] = 164.7.into();
    let (_, _, errors) = predict(&plan);
    let degrees = "a heading_rad of 164.7 is 26 turns; headings are read in radians";
    assert!(errors.contains(degrees), "{errors}");
    // An editor of Windows.
    fs::write(&file, format!("\u{feff}{plan}")).unwrap();
    assert!(predict_file().0 < 2);
}

#[test]
fn more_passes_than_the_maximum_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    let plate = |words: &[&str]| {
        let words = [&words[..1], &["polish-plate", "--force"], &words[1..]].concat();
        wisch(folder.path(), &words)
    };
    let share_above = |text: &str| {
        let above = text.split("more than the maximum of 3 on ").nth(1);
        let above = above.and_then(|rest| rest.split(' ').next());
        above.map_or(0.0, |share| share.parse::<f64>().unwrap())
    };
    let (_, planned, errors) = plate(&["predict", "--out", "once"]);
    assert!(share_above(&planned) < 1.0, "{planned}{errors}");
    let path = folder.path().join("once/plan.json");
    let mut plan: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(&path).unwrap()).unwrap();
    let strokes = plan["strokes"].as_array_mut().unwrap();
    let again = strokes.clone();
    strokes.extend(again);
    fs::write(folder.path().join("twice.json"), plan.to_string()).unwrap();
    let (code, text, _) = plate(&["predict", "--plan", "twice.json", "--out", "twice"]);
    assert!(share_above(&text) > 90.0, "{text}");
    // The goal is not met where more points than the target leaves have too many passes.
    assert_eq!(code, 1, "{text}");
    let expected = "not met: too many points above max_passes";
    assert!(text.contains(expected), "{text}");
}
