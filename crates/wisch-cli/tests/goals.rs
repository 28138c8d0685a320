//! Goals of several parts: steps in the order of their expected time, and what remains if one fails.

use crate::ask::ask;
use crate::program::{root, wisch};
use serde_json::Value;
use std::fs;
use std::path::Path;

/// Crumbs and water on a board before an arm that holds a sponge.
pub fn write_board(folder: &Path) {
    let task = r#"
        schema = 1
        name = "board"
        seed = 1
        goal = "(and (collected breadcrumbs chopping_board) (absorbed water chopping_board) (not (wet chopping_board)))"
        strategy = "kde"
        target_performance = 0.85
        [tool]
        in_hand = "sponge"
        [surface]
        name = "chopping_board"
        size_m = [0.28, 0.20]
        position_m = [0.0, 0.0, 0.77]
        [[medium]]
        name = "water"
        particles = { source = "clusters", count = 40, clusters = [{ center_m = [-0.08, 0.04], sigma_m = 0.02 }] }
        execution = { dirt = { source = "clusters", clusters = [{ center_m = [-0.08, 0.04], sigma_m = 0.02 }] } }
        [[medium]]
        name = "breadcrumbs"
        particles = { source = "uniform", count = 40 }
        collect = { goal_m = [0.06, -0.03] }
        [perception]
        senses = ["touch", "sight"]
        [robot]
        name = "arm7"
        position_m = [0.0, -0.45, 0.75]
        rpy_rad = [0.0, 0.0, 1.5707963267948966]
    "#;
    fs::write(folder.join("board.toml"), task).unwrap();
}

fn summary_of(folder: &Path, args: &[&str]) -> (i32, Value, String) {
    let (code, out, err) = wisch(folder, args);
    let value = serde_json::from_str(&out).unwrap_or_else(|_| panic!("{code}: {out}\n{err}"));
    (code, value, err)
}

fn steps(summary: &Value) -> Vec<String> {
    let steps = summary["steps"].as_array().unwrap().iter();
    steps
        .map(|step| step["step"].as_str().unwrap().to_owned())
        .collect()
}

#[test]
fn a_board_is_wiped_step_by_step() {
    let folder = tempfile::tempdir().unwrap();
    write_board(folder.path());
    let args = ["run", "board.toml", "--json", "--no-memory"];
    let (code, summary, err) = summary_of(folder.path(), &args);
    assert_eq!(summary["format"], "wisch-steps");
    let taken = steps(&summary);
    assert_eq!(
        taken[0], "(collect sponge breadcrumbs chopping_board)",
        "{taken:?}"
    );
    assert!(err.contains("2 steps, "), "{err}");
    let is_met = summary["goal_met"].as_bool().unwrap();
    assert_eq!(code, i32::from(!is_met));
    let parts = summary["parts"].as_array().unwrap();
    assert_eq!(
        is_met,
        parts.iter().all(|part| part["holds"] == true),
        "{summary}"
    );
    assert!(is_met, "{summary:#}");
    assert_eq!(
        taken.last().unwrap(),
        "(absorb sponge water chopping_board)"
    );
    let clock: f64 = summary["steps"]
        .as_array()
        .unwrap()
        .iter()
        .map(|step| step["took_s"].as_f64().unwrap())
        .sum();
    assert!((clock - summary["took_s"].as_f64().unwrap()).abs() < 1e-9);
    let out = folder.path().join("out/board");
    for file in [
        "steps.json",
        "report.html",
        "step-1/report.html",
        "step-2/rounds.json",
    ] {
        assert!(out.join(file).exists(), "{file}");
    }
    let page = fs::read_to_string(out.join("report.html")).unwrap();
    assert!(page.contains("href=\"step-1/report.html\""));
}

/// Answers of a query.
fn answers(folder: &Path, query: &str) -> Vec<Value> {
    let (code, out, err) = ask(folder, &[query, "--json"]);
    assert_eq!(code, 0, "{query}: {out}{err}");
    let found: Value = serde_json::from_str(&out).unwrap();
    found["answers"].as_array().unwrap().clone()
}

#[test]
fn the_steps_of_a_run_are_one_episode_that_queries_answer() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    write_board(folder);
    let text = fs::read_to_string(folder.join("board.toml")).unwrap();
    let text = text.replace("in_hand = \"sponge\"", "rack = [{ name = \"sponge\" }]");
    fs::write(folder.join("board.toml"), text).unwrap();
    let (_, summary, err) = summary_of(folder, &["run", "board.toml", "--json"]);
    let taken = steps(&summary);
    assert_eq!(taken[0], "(grasp sponge)", "{err}");
    let wiped = taken.iter().filter(|step| step.contains("chopping_board"));
    let wiped = wiped.count();

    let (code, out, err) = wisch(folder, &["memory", "list", "--json"]);
    assert_eq!(code, 0, "{err}");
    let listed: Vec<Value> = (out.lines())
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert_eq!(listed.len(), 1 + wiped, "{out}");
    let goal = &listed[0];
    assert_eq!(
        (
            &goal["task"],
            &goal["steps"],
            &goal["rounds"],
            &goal["succeeded"]
        ),
        (
            &"board".into(),
            &taken.len().into(),
            &0.into(),
            &summary["goal_met"]
        )
    );
    let duration = goal["duration_s"].as_f64().unwrap();
    assert!((duration - summary["took_s"].as_f64().unwrap()).abs() < 1e-5);
    let (_, table, _) = wisch(folder, &["memory", "list"]);
    assert!(table.contains(&format!("{} steps", taken.len())), "{table}");

    let found = answers(
        folder,
        "goal_step(G, N, S, E, T), triple(S, semco:words, W)",
    );
    let words: Vec<&str> = found.iter().map(|row| row["W"].as_str().unwrap()).collect();
    let expected = summary["steps"].as_array().unwrap().iter();
    let expected: Vec<&str> = expected
        .map(|step| step["words"].as_str().unwrap())
        .collect();
    assert_eq!(words, expected);
    let why =
        "has_type(S, 'FetchingStep'), triple(S, semco:usesTool, semco:sponge), step_serves(S, P)";
    let parts: Vec<Value> = answers(folder, why)
        .iter()
        .map(|row| row["P"].clone())
        .collect();
    let all = summary["parts"].as_array().unwrap().iter();
    let all: Vec<Value> = all.map(|part| part["part"].clone()).collect();
    assert_eq!(parts, all);
    let query = "goal_step(_, 2, S, _, _), step_episode(S, E), final_performance(E, P)";
    assert_eq!(answers(folder, query).len(), 1);
    assert_eq!(answers(folder, "costliest_step(_, S, T)").len(), 1);

    // An episode without rounds is no reason to fail.
    let id = goal["id"].as_str().unwrap();
    for args in [
        &["memory", "verify"][..],
        &["memory", "show", id],
        &["memory", "health"],
        &["memory", "export", "--neem", "neem"],
        &["memory", "forget", id],
        &["memory", "verify"],
    ] {
        let (code, out, err) = wisch(folder, args);
        assert_eq!(code, 0, "{args:?}: {out}{err}");
    }
    let (_, out, _) = wisch(folder, &["memory", "list"]);
    assert!(!out.contains(" steps"), "{out}");
}

#[test]
fn a_step_that_fails_twice_is_ruled_out_and_nothing_loops() {
    let folder = tempfile::tempdir().unwrap();
    write_board(folder.path());
    // The true crumbs hardly react, and one round is not enough for them.
    let hard = [
        "--set",
        "execution.mu=3.0",
        "--set",
        "execution.max_rounds=1",
    ];
    let args = [&["run", "board.toml", "--json", "--no-memory"][..], &hard].concat();
    let (code, summary, err) = summary_of(folder.path(), &args);
    assert_eq!(
        (code, &summary["goal_met"]),
        (1, &Value::Bool(false)),
        "{summary:#}"
    );
    let collected = "(collect sponge breadcrumbs chopping_board)";
    let taken = steps(&summary);
    assert_eq!(
        taken.iter().filter(|step| *step == collected).count(),
        2,
        "{taken:?}"
    );
    assert!(
        err.contains("ruled out; the other steps are planned anew"),
        "{err}"
    );
    let part = &summary["parts"][0];
    assert_eq!(part["holds"], false);
    assert!(
        part["left_out"]
            .as_str()
            .unwrap()
            .contains("its goal was not reached"),
        "{part}"
    );
    // The second attempt begins with what the first one has left.
    let second = &summary["steps"][1];
    assert_eq!(second["earlier_tries"], 1);
}

#[test]
fn by_touch_alone_a_step_that_fails_is_not_tried_again() {
    let folder = tempfile::tempdir().unwrap();
    write_board(folder.path());
    let hard = [
        "--set",
        "execution.mu=3.0",
        "--set",
        "execution.max_rounds=1",
        "--set",
        "target_performance=0.99",
    ];
    let args = [
        &["run", "board.toml", "--json", "--no-memory", "--touch-only"][..],
        &hard,
    ]
    .concat();
    let (code, summary, err) = summary_of(folder.path(), &args);
    assert_eq!(code, 1, "{summary:#}");
    assert_eq!(summary["goal_met"], false);
    let taken = steps(&summary);
    let collected = taken.iter().filter(|step| step.starts_with("(collect"));
    assert_eq!(collected.count(), 1, "{taken:?}");
    assert!(err.contains("would not know what is left to wipe"), "{err}");
}

#[test]
fn without_any_tool_nothing_is_done_and_every_part_says_why() {
    let folder = tempfile::tempdir().unwrap();
    write_board(folder.path());
    let args = ["run", "board.toml", "--json", "--set", "tool.in_hand=brush"];
    let (code, summary, _) = summary_of(folder.path(), &args);
    assert_eq!(code, 1);
    let parts = summary["parts"].as_array().unwrap();
    assert!(parts[1]["left_out"].as_str().is_some(), "{summary:#}");
    let args = ["run", "board.toml", "--json", "--set", "tool.in_hand=broom"];
    let (code, summary, _) = summary_of(folder.path(), &args);
    assert_eq!((code, steps(&summary)), (1, vec![]));
    let mut parts = summary["parts"].as_array().unwrap().iter();
    assert!(
        parts.all(|part| part["left_out"].is_string()),
        "{summary:#}"
    );
}

#[test]
fn without_a_tool_its_part_is_left_out_and_the_rest_is_predicted() {
    let folder = tempfile::tempdir().unwrap();
    let task = root().join("scenarios/kitchen.toml");
    let task = task.to_str().unwrap();
    let args = [
        "run",
        task,
        "--json",
        "--robot",
        "none",
        "--strategy",
        "kde",
        "--out",
        "kitchen",
        "--set",
        "tool.rack=[{ name = \"brush\" }]",
    ];
    let (code, summary, _) = summary_of(folder.path(), &args);
    assert_eq!((code, &summary["is_executed"]), (1, &Value::Bool(false)));
    let parts = summary["parts"].as_array().unwrap();
    let reason = |index: usize| {
        parts[index]["left_out"]
            .as_str()
            .unwrap_or_default()
            .to_owned()
    };
    assert!(
        reason(2).contains("absorb needs (can-absorb"),
        "{}",
        reason(2)
    );
    assert!(
        reason(3).contains("polish needs (can-polish"),
        "{}",
        reason(3)
    );
    assert!(steps(&summary).contains(&"(collect brush breadcrumbs table)".to_owned()));
    // A step whose prediction misses the target does not count as reached.
    let step = summary["steps"].as_array().unwrap().last().unwrap();
    assert_eq!(parts[1]["holds"], step["goal_met"], "{summary:#}");
}

#[test]
fn what_needs_one_part_says_how_to_choose_it() {
    let folder = tempfile::tempdir().unwrap();
    write_board(folder.path());
    let advice = "--set goal='(collected breadcrumbs chopping_board)'";
    for args in [
        &["run", "board.toml", "--plan", "plan.json"][..],
        &["run", "board.toml", "--executor", "true"],
        &["interpret", "--task", "board.toml", "log.csv"],
    ] {
        let (code, out, err) = wisch(folder.path(), args);
        assert_eq!(code, 2, "{args:?}");
        assert!((out + &err).contains(advice), "{args:?}: {err}");
    }
    let (code, out, err) = wisch(folder.path(), &["check", "board.toml"]);
    assert_eq!(code, 0, "{err}");
    assert!(out.contains("(absorbed water chopping_board): "), "{out}");
}

#[test]
fn a_check_of_several_parts_is_one_object() {
    let folder = tempfile::tempdir().unwrap();
    write_board(folder.path());
    let (code, found, err) = summary_of(folder.path(), &["check", "board.toml", "--json"]);
    assert_eq!(code, 0, "{err}");
    assert_eq!(found["format"], "wisch-goal-check");
    let parts = found["parts"].as_array().unwrap();
    assert_eq!(parts.len(), 3);
    assert!(
        parts.iter().all(|part| part["left_out"].is_null()),
        "{found:#}"
    );
    assert_eq!(found["surfaces"], serde_json::json!(["chopping_board"]));
    assert_eq!(found["media"][0]["medium"], "water");
    assert_eq!(found["tool_in_hand"], "sponge");
    let steps = found["steps"].as_array().unwrap();
    assert_eq!(steps.len(), 2, "{found:#}");
    // The checks of single parts print the same objects.
    for step in steps {
        let goal = format!("goal={}", step["part"]);
        let args = ["check", "board.toml", "--json", "--set", &goal];
        let (_, alone, _) = summary_of(folder.path(), &args);
        let mut step = step.clone();
        step.as_object_mut().unwrap().remove("part");
        assert_eq!(step, alone);
    }
    let goal = "goal=\"(and (absorbed water chopping_board) (polished water chopping_board))\"";
    let args = ["check", "board.toml", "--json", "--set", goal];
    let (code, found, _) = summary_of(folder.path(), &args);
    assert_eq!(code, 1);
    assert!(found["parts"][1]["left_out"].is_string(), "{found:#}");
}

#[test]
fn faults_of_parts_name_their_place() {
    let folder = tempfile::tempdir().unwrap();
    for (piece, by, expected) in [
        (
            "name = \"water\"",
            "name = \"water\"\n on = \"tabel\"",
            "task.toml:16:7: unknown surface \"tabel\"",
        ),
        (
            "name = \"water\"",
            "name = \"water\"\n colour = 3",
            "task.toml:16:2: medium: unknown key \"colour\"",
        ),
        (
            "(absorbed water chopping_board)",
            "(absorbed oil floor)",
            "names no medium and no surface of this file",
        ),
        (
            "in_hand = \"sponge\"",
            "rack = [{ name = \"sponge\", position_m = [0, 0] }]",
            "tool.rack.position_m: expected three numbers",
        ),
        (
            "in_hand = \"sponge\"",
            "rack = [{ name = \"sponge\", position_m = [0, 0, 200] }]",
            "is outside its limits",
        ),
    ] {
        write_board(folder.path());
        let text = fs::read_to_string(folder.path().join("board.toml")).unwrap();
        fs::write(folder.path().join("task.toml"), text.replacen(piece, by, 1)).unwrap();
        let (code, _, err) = wisch(folder.path(), &["predict", "task.toml"]);
        assert_eq!(code, 2, "{err}");
        assert!(err.contains(expected), "{expected}: {err}");
    }
}

#[test]
fn runs_over_seeds_count_what_is_claimed_and_what_is_true() {
    let folder = tempfile::tempdir().unwrap();
    write_board(folder.path());
    let args = ["eval", "goals", "board.toml", "--worlds", "1", "--json"];
    let (code, record, err) = summary_of(folder.path(), &args);
    assert_eq!(code, 0, "{err}");
    assert_eq!(err, "", "notes of single runs are not shown");
    let run = &record["runs"][0];
    let parts = run["parts"].as_array().unwrap();
    assert_eq!(parts.len(), 3);
    for part in parts.iter().filter(|part| part["is_claimed"] == true) {
        // A part with `not` is no effect of a step, so that no true performance belongs to it.
        let is_effect = !part["part"].as_str().unwrap().starts_with("(not");
        assert_eq!(part["truth"].is_number(), is_effect, "{part}");
    }
    let times = ["took_s", "best_order_s"].map(|name| run[name].as_f64().unwrap());
    assert!(times[0] >= times[1] - 1e-9, "{times:?}");
    let left: Vec<_> = fs::read_dir(folder.path().join("out/goals"))
        .unwrap()
        .collect();
    assert_eq!(
        left.len(),
        3,
        "goals.json, goals.md and the journal: {left:?}"
    );
    let again = wisch(
        folder.path(),
        &["eval", "goals", "board.toml", "--worlds", "1"],
    );
    assert_eq!(again.0, 2, "{}", again.2);
    let (code, _, err) = wisch(folder.path(), &["eval", "goals", "table"]);
    assert_eq!(code, 2, "{err}");
    assert!(err.contains("wisch eval scenarios"), "{err}");
}

#[test]
fn what_would_pass_over_collected_dirt_is_left_out() {
    let folder = tempfile::tempdir().unwrap();
    write_board(folder.path());
    // The crumbs are to be collected where the water lies.
    let args = [
        "plan",
        "board.toml",
        "--json",
        "--set",
        "collect.goal_m=[-0.08, 0.04]",
    ];
    let (code, summary, _) = summary_of(folder.path(), &args);
    assert_eq!(code, 1, "{summary:#}");
    assert_eq!(
        steps(&summary),
        ["(collect sponge breadcrumbs chopping_board)"]
    );
    let reason = summary["parts"][1]["left_out"].as_str().unwrap();
    assert!(
        reason.contains("would pass over the heap of breadcrumbs"),
        "{reason}"
    );
    assert_eq!(summary["is_predicted"], false);
    assert_eq!(summary["steps"][0]["goal_met"], Value::Null);
}

#[test]
fn a_missed_step_fills_the_tool_and_truth_counts_all_dirt() {
    let folder = tempfile::tempdir().unwrap();
    write_board(folder.path());
    let args = [
        "run",
        "board.toml",
        "--json",
        "--no-memory",
        "--set",
        "goal=\"(and (absorbed breadcrumbs chopping_board))\"",
        "--set",
        "execution.mu=0.0",
        "--set",
        "execution.max_rounds=1",
    ];
    let (_, summary, err) = summary_of(folder.path(), &args);
    let taken = steps(&summary);
    let absorb = "(absorb sponge breadcrumbs chopping_board)";
    assert_eq!(taken[..3], [absorb, "(empty sponge)", absorb], "{err}");
    let truth = |index: usize| {
        summary["steps"][index]["summary"]["final_true"]
            .as_f64()
            .unwrap()
    };
    assert!(
        truth(0) > 0.0 && truth(2) >= truth(0),
        "{} {}",
        truth(0),
        truth(2)
    );
    let list = fs::read_to_string(
        folder
            .path()
            .join("out/board/step-3/particles/particles-true.csv"),
    );
    let absorbed = list
        .unwrap()
        .lines()
        .filter(|line| line.contains("absorbed"))
        .count();
    assert!(
        (absorbed as f64 / 40.0 - truth(2)).abs() < 0.1,
        "{absorbed} {}",
        truth(2)
    );
}

#[test]
fn goals_of_one_part_and_parts_that_follow_are_checked() {
    let folder = tempfile::tempdir().unwrap();
    write_board(folder.path());
    let check = |goal: &str| {
        let goal = format!("goal=\"{goal}\"");
        let (code, out, err) = wisch(folder.path(), &["check", "board.toml", "--set", &goal]);
        (code, out + &err)
    };
    let (code, text) = check("(not (wet chopping_board))");
    assert!(
        text.contains("(absorbed water chopping_board): "),
        "{code} {text}"
    );
    let (code, text) = check("(and (absorbed water chopping_board))");
    assert!(
        text.contains("(absorbed water chopping_board): "),
        "{code} {text}"
    );
    let (code, text) = check("(and (absorbed water chopping_board) (absorbed water tabel))");
    assert_eq!(code, 2, "{text}");
    assert!(text.contains("tabel"), "{text}");
    let (code, text) =
        check("(and (absorbed water chopping_board) (polished water chopping_board))");
    assert_eq!(code, 1, "{text}");
    assert!(
        text.contains("(polished water chopping_board): cannot be reached"),
        "{text}"
    );
}

#[test]
fn a_scene_of_several_surfaces_stands_in_the_world() {
    let folder = tempfile::tempdir().unwrap();
    let task = fs::read_to_string(root().join("scenarios/kitchen.toml")).unwrap();
    let cup = "\n[[scene]]\nname = \"cup\"\nframe = \"surface\"\nbox_m = [0.05, 0.05, 0.1]\n";
    fs::write(folder.path().join("cup.toml"), task + cup).unwrap();
    let (code, _, err) = wisch(folder.path(), &["check", "cup.toml"]);
    assert_eq!(code, 2, "{err}");
    assert!(
        err.contains("a different place for each of the surfaces"),
        "{err}"
    );
}

#[test]
fn a_medium_may_state_its_interaction_without_the_name_of_a_tool() {
    let folder = tempfile::tempdir().unwrap();
    write_board(folder.path());
    let task = fs::read_to_string(folder.path().join("board.toml")).unwrap();
    let rack = task.replace("in_hand = \"sponge\"", "rack = [{ name = \"sponge\" }]");
    let own = "name = \"water\"\n interaction = { press_force_n = 8.0 }";
    let task = rack.replace("name = \"water\"", own);
    fs::write(folder.path().join("own.toml"), task).unwrap();
    let (code, out, err) = wisch(folder.path(), &["check", "own.toml"]);
    assert_eq!(code, 0, "{out}{err}");
    let (code, summary, err) = summary_of(folder.path(), &["plan", "own.toml", "--json"]);
    assert_eq!(code, 0, "{err}");
    assert_eq!(steps(&summary)[0], "(grasp sponge)");
}

#[test]
fn a_shipped_scenario_reads_a_file_whose_path_is_absolute() {
    let folder = tempfile::tempdir().unwrap();
    let list = folder.path().join("dirt.csv");
    fs::write(&list, "x,y\n0.0,0.0\n0.01,0.02\n").unwrap();
    let particles = format!("particles={{ source = \"csv\", file = {list:?} }}");
    let args = ["check", "arm-board", "--set", &particles];
    let (code, out, err) = wisch(folder.path(), &args);
    assert_eq!(code, 0, "{out}{err}");
}
