//! `wisch eval table1` and `wisch eval sweep`.

use crate::program::{contents, wisch};
use serde_json::Value;
use std::fs;
use std::path::Path;

/// One cell by two strategies, twice.
const TABLE: [&str; 8] = [
    "eval",
    "table1",
    "--cells",
    "board/absorb",
    "--strategies",
    "grid,kde",
    "--seeds",
    "2",
];

/// Two values by two, each once.
const SWEEP: [&str; 9] = [
    "eval",
    "sweep",
    "chopping-board",
    "--set",
    "strategy=grid,kde",
    "--set",
    "particles.count=20:40:20",
    "--seeds",
    "1",
];

fn run(folder: &Path, args: &[&[&str]]) -> (i32, String, String) {
    wisch(folder, &args.concat())
}

fn text(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The rows of a table without its last column, the time that it took.
fn without_time(table: &str) -> Vec<&str> {
    let first = table.lines().next().expect("a header");
    assert!(first.ends_with(",computation_s"), "{first}");
    (table.lines())
        .filter_map(|line| line.rsplit_once(','))
        .map(|(rest, _)| rest)
        .collect()
}

#[test]
fn a_cell_of_table_1_stands_beside_the_papers() {
    let folder = tempfile::tempdir().expect("a folder");
    let (code, out, err) = run(folder.path(), &[&TABLE, &["--out", "out", "--json"]]);
    assert_eq!((code, &*err), (0, ""));
    let record: Value = serde_json::from_str(&out).expect("one object");
    let row = &record["rows"][0];
    assert_eq!(
        (&row["action"], &row["surface"]),
        (&"absorb".into(), &"board".into())
    );
    assert_eq!(row["paper"]["performance_percent"], 84.25);
    let runs = record["runs"].as_array().expect("runs");
    let of = |run: &Value, key: &str| run["score"][key].as_f64().expect("a number");
    let mean = (of(&runs[0], "predicted") + of(&runs[1], "predicted")) / 2.0;
    let ours = row["ours"]["predicted"]["mean"].as_f64().expect("a mean");
    assert!((ours - mean).abs() < 1e-12 && mean > 0.8, "{row}");
    let distance = of(&runs[0], "distance_m");
    assert!(
        (distance / 1.52 - 1.0).abs() < 0.05,
        "{distance} m, paper 1.52 m"
    );
    assert!(
        runs[0]["score"]["picture"].is_null(),
        "pictures are not for the record"
    );

    let out = folder.path().join("out");
    let table = text(&out, "table1.md");
    assert!(
        table.contains("| absorb | board | grid | 2 | **"),
        "{table}"
    );
    assert!(
        table.contains("| 84.25 |") && table.contains("2 of 2 of the paper's cells"),
        "{table}"
    );
    assert_eq!(text(&out, "runs.csv").lines().count(), 5);
    assert_eq!(text(&out, "table1.csv").lines().count(), 3);
    let page = text(&out, "table1.html");
    assert!(page.contains("<small>84.25</small>"), "the paper's figure");
    assert_eq!(
        page.matches("<figcaption>").count(),
        3,
        "before, grid and kde"
    );
}

#[test]
fn parts_and_threads_and_a_killed_run_change_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let here = folder.path();
    for (args, kept) in [
        (&TABLE[..], &["runs.csv", "table1.csv"][..]),
        (&SWEEP, &["runs.csv"]),
    ] {
        let name = args[1];
        let [whole, parts] = ["whole", "parts"].map(|what| format!("{name}-{what}"));
        let (code, _, err) = run(here, &[args, &["--out", &whole, "--threads", "2"]]);
        assert_eq!((code, &*err), (0, ""));
        let (code, out, err) = run(
            here,
            &[args, &["--out", &parts, "--shard", "2/2", "--threads", "1"]],
        );
        assert_eq!((code, &*err), (0, ""));
        assert!(out.contains(": 2 runs"), "{out}");
        // What a killed evaluation left of a line is done again.
        let path = here.join(&parts).join("runs-2-of-2.jsonl");
        let lines = fs::read_to_string(&path).expect("lines");
        fs::write(&path, &lines[..lines.len() - 40]).expect("written");
        let (code, _, err) = run(here, &[args, &["--out", &parts]]);
        assert_eq!(code, 2, "{err}");
        assert!(err.contains("already holds 1 run"), "{err}");
        let (code, _, err) = run(
            here,
            &[args, &["--out", &parts, "--resume", "--shard", "1/2"]],
        );
        assert_eq!((code, &*err), (0, ""));
        let (code, _, err) = run(
            here,
            &[args, &["--out", &parts, "--resume", "--shard", "2/2"]],
        );
        assert_eq!((code, &*err), (0, ""));
        for table in kept {
            let [whole, parts] = [&whole, &parts].map(|out| text(&here.join(out), table));
            assert_eq!(without_time(&parts), without_time(&whole));
        }
        // Nothing is left to do, and nothing changes.
        let before = contents(&here.join(&parts));
        let (code, _, err) = run(here, &[args, &["--out", &parts, "--resume"]]);
        assert_eq!((code, &*err), (0, ""));
        let after = contents(&here.join(&parts));
        let names = |all: &[(String, Vec<u8>)]| -> Vec<_> {
            (all.iter())
                .filter(|(name, bytes)| !(name.ends_with(".jsonl") && bytes.is_empty()))
                .cloned()
                .collect()
        };
        assert_eq!(names(&after), names(&before));
    }
}

#[test]
fn another_evaluation_is_not_mixed_in() {
    let folder = tempfile::tempdir().expect("a folder");
    let here = folder.path();
    let one = [
        "eval",
        "table1",
        "--cells",
        "board/absorb",
        "--strategies",
        "grid",
    ];
    let begun = run(here, &[&one, &["--seeds", "1", "--out", "out"]]);
    assert_eq!(begun.0, 0, "{}", begun.2);
    for other in [
        &["--seeds", "1", "--follow"][..],
        &["--seeds", "1", "--first-seed", "2"],
        &["--seeds", "1", "--set", "particles.count=10"],
    ] {
        let (code, _, err) = run(here, &[&one, other, &["--out", "out", "--resume"]]);
        assert_eq!(code, 2, "{err}");
        let expected = "holds another evaluation, for example of absorb board by grid, seed 1";
        assert!(err.contains(expected), "{err}");
    }
    // More seeds are the same evaluation.
    let (code, out, err) = run(here, &[&one, &["--seeds", "2", "--out", "out", "--resume"]]);
    assert_eq!((code, &*err), (0, ""));
    assert!(out.contains("| absorb | board | grid | 2 |"), "{out}");
}

#[test]
fn a_sweep_has_a_row_for_each_run_and_a_median_for_each_cell() {
    let folder = tempfile::tempdir().expect("a folder");
    let (code, out, err) = run(folder.path(), &[&SWEEP, &["--out", "out", "--json"]]);
    assert_eq!((code, &*err), (0, ""));
    let record: Value = serde_json::from_str(&out).expect("one object");
    let values: Vec<&Value> = (record["cells"].as_array().expect("cells").iter())
        .map(|cell| &cell["values"])
        .collect();
    let expected = [["grid", "20"], ["grid", "40"], ["kde", "20"], ["kde", "40"]];
    assert_eq!(
        values,
        expected.map(|cell| Value::from(cell.to_vec())).each_ref()
    );
    let table = text(&folder.path().join("out"), "runs.csv");
    let mut rows = csv::Reader::from_reader(table.as_bytes());
    let header = rows.headers().expect("a header").clone();
    assert_eq!(
        header.iter().take(3).collect::<Vec<_>>(),
        ["strategy", "particles.count", "seed"]
    );
    let rows: Vec<csv::StringRecord> = rows.records().collect::<Result<_, _>>().expect("rows");
    assert_eq!(rows.len(), 4);
    // Half of the dirt is another share of one particle.
    let at = header
        .iter()
        .position(|name| name == "predicted")
        .expect("a column");
    let predicted = |row: usize| rows[row][at].parse::<f64>().expect("a number");
    for (row, count) in [(0, 20.0), (1, 40.0)] {
        let grains = predicted(row) * count;
        assert!((grains - grains.round()).abs() < 1e-9, "{}", predicted(row));
    }
    let words = text(&folder.path().join("out"), "sweep.md");
    assert!(
        words.contains("| strategy | particles.count | runs | predicted % |"),
        "{words}"
    );
}

#[test]
fn a_robot_follows_and_executes_what_is_swept() {
    let folder = tempfile::tempdir().expect("a folder");
    let args = [
        "eval",
        "sweep",
        "arm-board",
        "--seeds",
        "1",
        "--set",
        "strategy=kde",
    ];
    let (code, out, err) = run(
        folder.path(),
        &[
            &args,
            &[
                "--execute",
                "--out",
                "out",
                "--set",
                "execution.max_rounds=1",
                "--json",
            ],
        ],
    );
    assert_eq!((code, &*err), (0, ""));
    let record: Value = serde_json::from_str(&out).expect("one object");
    let score = &record["runs"][0]["score"];
    let of = |group: &str, key: &str| score[group][key].as_f64().expect("a number");
    assert_eq!(of("execution", "rounds"), 1.0);
    assert!(
        of("execution", "truth") > of("execution", "before"),
        "{score}"
    );
    assert!(
        of("motion", "duration_s") > of("motion", "contact_s"),
        "{score}"
    );
    let summary = &record["cells"][0]["summary"];
    assert_eq!(summary["truth"]["mean"], score["execution"]["truth"]);
    assert_eq!(
        summary["execution_s"]["mean"],
        score["execution"]["duration_s"]
    );
}

#[test]
fn what_is_wrong_is_named_with_its_place() {
    let folder = tempfile::tempdir().expect("a folder");
    let sweep = |more: &[&'static str]| [&["eval", "sweep", "chopping-board"], more].concat();
    for (args, expected) in [
        (
            sweep(&["--set", "particles.count=20,x"]),
            "--set particles.count, value 2 of 2: setting particles.count:1:1: particles.count: expected a whole number",
        ),
        (
            sweep(&["--set", "particles.count=20", "--set", "surface.colour=3"]),
            "--set surface.colour, value 1 of 1: setting surface.colour:1:1: surface: unknown key \"colour\"",
        ),
        (
            sweep(&["--set", "strategy=grid,kd"]),
            "--set strategy, value 2 of 2: ",
        ),
        (
            sweep(&["--set", "seed=1,2"]),
            "--set seed: a sweep sets the seeds itself",
        ),
        (sweep(&["--set", "particles.count"]), "\"=\" is missing"),
        (
            sweep(&["--set", "particles.count=1:9:0"]),
            "particles.count: the range 1:9:0 does not lead from its beginning to its end",
        ),
        (
            sweep(&["--set", "particles.count=1", "--set", "particles.count=2"]),
            "--set particles.count: the key is given twice",
        ),
        (
            vec![
                "eval",
                "sweep",
                "no-such-task",
                "--set",
                "particles.count=1",
            ],
            "no-such-task: there is no such file",
        ),
        (
            vec!["eval", "table1", "--cells", "bord"],
            "\"bord\" is not a cell of Table 1",
        ),
        (vec!["eval", "table1", "--strategies", "gird"], "'gird'"),
        (
            vec!["eval", "table1", "--set", "particles.count=x"],
            "setting particles.count:1:1",
        ),
        (
            vec!["eval", "table1", "--shard", "3/2"],
            "expected I/N with 1 <= I <= N",
        ),
        (
            vec!["eval", "table1", "--execute", "--within-shortest"],
            "cannot be used with",
        ),
    ] {
        let (code, _, err) = wisch(folder.path(), &args);
        assert_eq!(code, 2, "{args:?}: {err}");
        assert!(err.contains(expected), "{args:?}: {err}");
        assert!(!folder.path().join("out").exists(), "{args:?}");
    }
}
