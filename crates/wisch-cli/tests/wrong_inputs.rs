//! Wrong input of every kind ends in exit code 2 and a sentence that names the file and the fault.

mod robots;

use crate::program::{command, root};
use std::fs;

/// One wrong input.
struct Case {
    /// What is wrong.
    name: &'static str,
    /// Replacements in the template, each of a text that it holds.
    edits: Vec<(&'static str, String)>,
    /// Files beside the task.
    files: Vec<(&'static str, Vec<u8>)>,
    /// The command line.
    args: Vec<&'static str>,
    /// What standard error says, the file's name among it.
    says: Vec<&'static str>,
}

/// The task template with one edit, checked.
fn task(name: &'static str, from: &'static str, to: &str, says: &[&'static str]) -> Case {
    Case {
        name,
        edits: vec![(from, to.to_owned())],
        files: Vec::new(),
        args: vec!["check", "task.toml"],
        says: [&["task.toml"], says].concat(),
    }
}

/// A task whose cup is a mesh file of this content.
fn mesh(name: &'static str, file: &'static str, bytes: &[u8], says: &[&'static str]) -> Case {
    let shape = format!("mesh = {{ file = \"{file}\" }}");
    Case {
        files: vec![(file, bytes.to_vec())],
        ..task(name, CUP, &shape, &[&[file], says].concat())
    }
}

/// A task whose particles are a CSV file of this content.
fn list(name: &'static str, text: &str, says: &[&'static str]) -> Case {
    Case {
        edits: vec![
            (
                "source = \"uniform\"",
                "source = \"csv\"\nfile = \"crumbs.csv\"".to_owned(),
            ),
            ("\ncount = 80", "\n#".to_owned()),
        ],
        files: vec![("crumbs.csv", text.as_bytes().to_vec())],
        ..task(name, "", "", &[&["crumbs.csv"], says].concat())
    }
}

/// A task whose particles are read off an image.
fn image(name: &'static str, bytes: &[u8], corners: &str, says: &[&'static str]) -> Case {
    let source = format!(
        "source = \"image\"\nfile = \"photo.png\"\ncorners_px = {corners}\ncolor = [0, 0, 0]\ntolerance = 10"
    );
    Case {
        edits: vec![("source = \"uniform\"", source)],
        files: vec![("photo.png", bytes.to_vec())],
        ..task(name, "", "", says)
    }
}

/// A command line without a shipped task.
fn line(name: &'static str, args: &[&'static str], says: &[&'static str]) -> Case {
    Case {
        name,
        edits: Vec::new(),
        files: Vec::new(),
        args: args.to_vec(),
        says: says.to_vec(),
    }
}

/// A knowledge folder in which one file is replaced.
fn knowledge(name: &'static str, file: &'static str, text: &str, says: &[&'static str]) -> Case {
    Case {
        files: vec![(file, text.as_bytes().to_vec())],
        ..line(
            name,
            &["check", "task.toml", "--knowledge", "knowledge"],
            &[&[file], says].concat(),
        )
    }
}

/// A plan file in place of a plan.
fn plan(name: &'static str, text: &str, says: &[&'static str]) -> Case {
    Case {
        files: vec![("given.json", text.as_bytes().to_vec())],
        ..line(
            name,
            &[
                "predict",
                "task.toml",
                "--plan",
                "given.json",
                "--out",
                "result",
            ],
            &[&["given.json"], says].concat(),
        )
    }
}

const CUP: &str = "cylinder = { radius_m = 0.04, height_m = 0.10 }";
const OUTLINE: &str = "size_m = [0.40, 0.28]";
const SKIM_EDGES: &str = "skim_edges = [\"y_min\"]";
const ACTION: &str = "action = \"collect\"";
const CORNERS: &str = "[[0, 9], [9, 9], [9, 0], [0, 0]]";

fn toml_cases() -> Vec<Case> {
    vec![
        task("not TOML", "seed = 1", "seed = = 1", &["task.toml:9:8"]),
        task(
            "a key twice",
            "seed = 1",
            "seed = 1\nseed = 2",
            &["duplicate key"],
        ),
        task(
            "unknown key",
            "seed = 1",
            "sede = 1",
            &["unknown key \"sede\"", "seed"],
        ),
        task(
            "unknown table",
            "[medium]",
            "[medum]",
            &["unknown key \"medum\"", "nearest: medium"],
        ),
        task(
            "wrong schema",
            "schema = 1 ",
            "schema = 7 ",
            &["schema 7 is not supported; this version reads schema 1"],
        ),
        task("no schema", "schema = 1 ", "# ", &["\"schema\" is missing"]),
        task(
            "a text for a number",
            "seed = 1",
            "seed = \"one\"",
            &["seed: expected a whole number"],
        ),
        task(
            "a negative seed",
            "seed = 1",
            "seed = -1",
            &["seed = -1 is outside its limits"],
        ),
        task(
            "NaN",
            OUTLINE,
            "size_m = [nan, 0.28]",
            &["size_m", "NaN", "outside its limits"],
        ),
        task(
            "infinite",
            OUTLINE,
            "size_m = [inf, 0.28]",
            &["size_m", "inf", "outside its limits"],
        ),
        task(
            "zero-size surface",
            OUTLINE,
            "size_m = [0.0, 0.28]",
            &["size_m", "= 0 is outside its limits: at least 0.001"],
        ),
        task(
            "a surface in millimetres",
            OUTLINE,
            "size_m = [400, 280]",
            &["= 400 is outside its limits", "at most 100"],
        ),
        task(
            "10^9 particles",
            "count = 80",
            "count = 1000000000",
            &["count = 1000000000 is outside its limits", "5000000"],
        ),
        task(
            "no particles",
            "count = 80",
            "count = 0",
            &["count = 0 is outside its limits"],
        ),
        task(
            "a target beyond 1",
            "target_performance = 0.85",
            "target_performance = 95",
            &["target_performance = 95 is outside its limits"],
        ),
        task(
            "unknown action",
            ACTION,
            "action = \"colect\"",
            &["unknown action \"colect\"", "nearest: collect"],
        ),
        task(
            "unknown strategy",
            "strategy = \"best\"",
            "strategy = \"gird\"",
            &["unknown strategy \"gird\"", "nearest: grid"],
        ),
        task(
            "action and goal",
            ACTION,
            "action = \"collect\"\ngoal = \"(collected breadcrumbs chopping_board)\"",
            &["goal", "exactly one of"],
        ),
        task("neither action nor goal", ACTION, "", &["action", "goal"]),
        task(
            "a self-intersecting outline",
            OUTLINE,
            "outline_m = [[0, 0], [0.4, 0.4], [0.4, 0], [0, 0.4]]",
            &["outline_m", "cross"],
        ),
        task(
            "an outline of two points",
            OUTLINE,
            "outline_m = [[0, 0], [0.4, 0.4]]",
            &["outline_m", "3"],
        ),
        task(
            "size and outline",
            OUTLINE,
            "size_m = [0.4, 0.28]\noutline_m = [[0, 0], [0.4, 0], [0, 0.4]]",
            &["size_m", "outline_m", "exactly one of"],
        ),
        task(
            "a non-unit quaternion",
            "rpy_rad = [0.0, 0.0, 0.0]        # roll",
            "quaternion_xyzw = [0.0, 0.0, 0.0, 0.5] # roll",
            &["quaternion_xyzw", "norm is 0.5"],
        ),
        task(
            "a name twice",
            "name = \"cup\"",
            "name = \"board\"",
            &["\"board\" is already defined at"],
        ),
        task(
            "unknown carrier",
            "carried_by = \"board\"",
            "carried_by = \"bord\"",
            &["\"bord\"", "nearest: board"],
        ),
        task(
            "an edge that is none",
            SKIM_EDGES,
            "skim_edges = [4]",
            &["skim_edges[0] = 4 is outside its limits"],
        ),
        task(
            "an edge of no name",
            SKIM_EDGES,
            "skim_edges = [\"ymin\"]",
            &["unknown edge \"ymin\"", "nearest: y_min"],
        ),
        task(
            "two shapes",
            CUP,
            "box_m = [1, 1, 1]\nsphere = { radius_m = 1 }",
            &["box_m", "sphere", "exactly one of"],
        ),
    ]
}

fn meaning_cases() -> Vec<Case> {
    vec![
        task(
            "unknown tool",
            "name = \"sponge\"",
            "name = \"spong\"",
            &["unknown tool \"spong\"", "nearest: sponge"],
        ),
        task(
            "unknown medium",
            "name = \"breadcrumbs\"",
            "name = \"breadcrumb\"",
            &["unknown medium \"breadcrumb\"", "nearest: breadcrumbs"],
        ),
        task(
            "unknown surface",
            "name = \"chopping_board\"",
            "name = \"choping_board\"",
            &[
                "unknown surface \"choping_board\"",
                "nearest: chopping_board",
            ],
        ),
        task(
            "a tool that does not fit",
            "name = \"sponge\"",
            "name = \"vacuum_nozzle\"",
            &["vacuum_nozzle", "only absorb"],
        ),
        task(
            "an unreachable collect goal",
            "goal_m = [0.03, 0.0]",
            "goal_m = [-0.15, 0.09]",
            &[
                "the goal (collect.goal_m) at (-0.150, 0.090) m",
                "the tool needs 0.065 m",
            ],
        ),
        task(
            "a collect goal off the surface",
            "goal_m = [0.03, 0.0]",
            "goal_m = [1.0, 0.0]",
            &[
                "the goal (collect.goal_m) at (1.000, 0.000) m",
                "off the surface",
            ],
        ),
        task(
            "no free node",
            CUP,
            "box_m = [0.75, 0.45, 0.10] # ",
            &["surface \"chopping_board\": no free place"],
        ),
        Case {
            args: vec![
                "check",
                "task.toml",
                "--set",
                "interaction.compression_depth_m=0.06",
            ],
            ..task(
                "a tool pressed flat",
                "",
                "",
                &[
                    "interaction.compression_depth_m is 0.06 m, but must be less than the height of the tool",
                ],
            )
        },
        Case {
            args: vec![
                "follow",
                "task.toml",
                "--strategy",
                "kde",
                "--set",
                "plan.lift_height_m=0.01",
            ],
            ..task(
                "a lift that is too low",
                "",
                "",
                &["plan.lift_height_m is 0.01 m, but must exceed 0.01 m"],
            )
        },
        Case {
            edits: vec![
                (ACTION, "action = \"skim\"".to_owned()),
                (SKIM_EDGES, "#".to_owned()),
            ],
            ..task("skim without edges", "", "", &["skim_edges"])
        },
        task(
            "a mesh that is not there",
            CUP,
            "mesh = { file = \"tap.stl\" }",
            &["tap.stl", "there is no such file"],
        ),
        task(
            "a mesh of no format",
            CUP,
            "mesh = { file = \"tap.step\" }",
            &["tap.step", "must end in .stl, .obj, .dae, .ply or .asc"],
        ),
        task(
            "a goal that is no PDDL",
            ACTION,
            "goal = \"(collected breadcrumbs\"",
            &["goal", "expected `)`"],
        ),
        task(
            "a goal of no predicate",
            ACTION,
            "goal = \"(colected breadcrumbs chopping_board)\"",
            &["unknown predicate \"colected\"", "nearest: collected"],
        ),
        task(
            "a goal of too few",
            ACTION,
            "goal = \"(collected breadcrumbs)\"",
            &["predicate collected takes 2 arguments, found 1"],
        ),
        task(
            "a goal of no medium",
            ACTION,
            "goal = \"(collected crumbs chopping_board)\"",
            &["unknown medium \"crumbs\"", "nearest: breadcrumbs"],
        ),
        task(
            "a goal with or",
            ACTION,
            "goal = \"(or (collected breadcrumbs chopping_board))\"",
            &["`or`", "not supported"],
        ),
    ]
}

fn file_cases() -> Vec<Case> {
    let binary_stl = [&[0u8; 80][..], &9u32.to_le_bytes(), &[0; 50]].concat();
    let in_millimetres =
        "v 0 0 0\nv 80 0 0\nv 0 80 0\nv 0 0 100\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    vec![
        mesh("an empty STL", "cup.stl", b"", &["binary STL"]),
        mesh(
            "an STL cut short",
            "cup.stl",
            &binary_stl,
            &["announces 9 triangles", "room for 1"],
        ),
        mesh(
            "an STL without triangles",
            "cup.stl",
            b"solid cup\nendsolid cup\n",
            &["no triangle"],
        ),
        mesh(
            "an OBJ of missing vertices",
            "cup.obj",
            b"v 0 0 0\nf 1 2 3\n",
            &["cup.obj"],
        ),
        mesh(
            "an OBJ of words",
            "cup.obj",
            b"v a b c\nf 1 2 3\n",
            &["cup.obj"],
        ),
        mesh(
            "an OBJ in millimetres",
            "cup.obj",
            in_millimetres.as_bytes(),
            &["probably in millimetres", "scale = 0.001"],
        ),
        mesh("a DAE that is no XML", "cup.dae", b"<COLLADA", &["cup.dae"]),
        mesh(
            "a DAE without geometry",
            "cup.dae",
            b"<COLLADA></COLLADA>",
            &["cup.dae"],
        ),
        list("an empty list", "", &["neither a row nor a header"]),
        list(
            "a list of words",
            "x,y\n0.1,abc\n",
            &["crumbs.csv:2", "y = \"abc\" is not a number"],
        ),
        list(
            "a list with NaN",
            "x,y\nnan,0\n",
            &["x = NaN m is outside its limits"],
        ),
        list(
            "a list of one column",
            "x,y\n0.1\n",
            &["1 columns, expected 2"],
        ),
        list(
            "a list off the surface",
            "x,y\n0.1,0\n3,0\n",
            &["crumbs.csv:3", "is outside the surface's outline"],
        ),
        image(
            "no PNG",
            b"not a picture",
            CORNERS,
            &["photo.png", "not a readable PNG or JPEG"],
        ),
        image(
            "corners that are none",
            b"",
            "[[0, 9], [9, 9]]",
            &["corners_px"],
        ),
        knowledge(
            "knowledge of another schema",
            "knowledge/tools.toml",
            "schema = 2\n",
            &["schema 2 is not supported"],
        ),
        knowledge(
            "knowledge that is no TOML",
            "knowledge/media.toml",
            "schema =\n",
            &[":1:"],
        ),
        knowledge(
            "knowledge without names",
            "knowledge/media.toml",
            "schema = 1\n[[medium]]\nkind = \"solid\"\n",
            &["name"],
        ),
        plan("a plan that is no JSON", "{", &["line 1"]),
        plan(
            "a plan of others",
            "{\"format\": \"map\", \"schema\": 1}",
            &["this is not a plan of wisch"],
        ),
        plan(
            "a plan of the future",
            "{\"format\": \"wisch-plan\", \"schema\": 9}",
            &["schema 9 is not supported; this version reads schema 1"],
        ),
        plan(
            "half a plan",
            "{\"format\": \"wisch-plan\", \"schema\": 1}",
            &["missing field `task`"],
        ),
    ]
}

fn line_cases() -> Vec<Case> {
    vec![
        line(
            "a task that is not there",
            &["run", "tusk.toml"],
            &[
                "tusk.toml: there is no such file",
                "did you mean task.toml?",
            ],
        ),
        line(
            "a folder for a task",
            &["run", "knowledge"],
            &["knowledge: this is a folder"],
        ),
        Case {
            files: vec![("bytes.toml", b"name = \"\xff\"".to_vec())],
            ..line(
                "a task that is no UTF-8",
                &["run", "bytes.toml"],
                &["bytes.toml:1", "not UTF-8"],
            )
        },
        Case {
            files: vec![("empty.toml", Vec::new())],
            ..line(
                "an empty task",
                &["run", "empty.toml"],
                &["empty.toml", "missing"],
            )
        },
        line(
            "an unknown strategy",
            &["run", "task.toml", "--strategy", "gird"],
            &["--strategy", "gird", "'grid'"],
        ),
        line(
            "an unknown action",
            &["run", "task.toml", "--action", "wipe"],
            &["--action", "wipe"],
        ),
        line(
            "a setting without value",
            &["run", "task.toml", "--set", "seed"],
            &["--set", "\"=\" is missing"],
        ),
        line(
            "a setting of no key",
            &["run", "task.toml", "--set", "sede=1"],
            &["sede", "seed"],
        ),
        line(
            "a setting of no type",
            &["run", "task.toml", "--set", "seed=abc"],
            &["setting seed", "whole number"],
        ),
        line(
            "a seed below 0",
            &["run", "task.toml", "--seed=-1"],
            &["--seed"],
        ),
        line(
            "no threads",
            &["run", "task.toml", "--threads", "0"],
            &["--threads", "1..=1024"],
        ),
        line(
            "no such knowledge",
            &["run", "task.toml", "--knowledge", "nowhere"],
            &["nowhere"],
        ),
        line(
            "a plan that is not there",
            &["predict", "task.toml", "--plan", "none.json"],
            &["none.json: there is no such file"],
        ),
        line(
            "results in a file",
            &["run", "task.toml", "--out", "task.toml"],
            &["task.toml", "but this is a file"],
        ),
        line(
            "results below a file",
            &["run", "task.toml", "--out", "task.toml/result"],
            &["task.toml/result"],
        ),
        line(
            "results in a folder of others",
            &["run", "task.toml", "--out", "knowledge"],
            &["knowledge", "it is not replaced"],
        ),
        line(
            "a file for a shipped scenario",
            &[
                "check",
                "arm-board",
                "--set",
                "tool={ name = \"pad\", mesh = \"pad.stl\" }",
            ],
            &[
                "pad.stl: the shipped scenarios have no such file",
                "wisch scenarios arm-board --out FOLDER",
            ],
        ),
        line(
            "a tool that is unknown",
            &["footprint", "spunge"],
            &["unknown tool \"spunge\"", "nearest: sponge"],
        ),
        line(
            "no depth",
            &["footprint", "sponge", "--compression-depth-m", "0"],
            &["sponge", "compression depth 0 m"],
        ),
        line(
            "a depth of NaN",
            &["footprint", "sponge", "--compression-depth-m", "nan"],
            &["NaN m is outside 0 (rigid) to 0.1 m"],
        ),
        line(
            "a drawing of no format",
            &["footprint", "sponge", "--svg", "task.toml"],
            &["task.toml", ".svg"],
        ),
        line(
            "writing over a task",
            &["new", "task.toml"],
            &["task.toml", "--force"],
        ),
        line("no command", &["wipe"], &["wipe"]),
    ]
}

/// Runs a case; `None` if it ends as it should.
fn fault_of(case: &Case) -> Option<String> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let beside = |name: &str| folder.path().join(name);
    let shipped = root().join("knowledge");
    fs::create_dir(beside("knowledge")).expect("a folder");
    for name in [
        "tools.toml",
        "media.toml",
        "surfaces.toml",
        "interactions.toml",
        "wiping.pddl",
    ] {
        fs::copy(shipped.join(name), beside("knowledge").join(name)).expect("a copy");
    }
    let mut text = wisch_io::TaskFile::TEMPLATE.to_owned();
    for (from, to) in &case.edits {
        if !text.contains(from) {
            return Some(format!("the template holds no {from:?}"));
        }
        text = text.replacen(from, to, 1);
    }
    fs::write(beside("task.toml"), text).expect("a task");
    for (name, bytes) in &case.files {
        fs::write(beside(name), bytes).expect("a file");
    }
    let output = command(folder.path())
        .args(&case.args)
        .output()
        .expect("it runs");
    let said = String::from_utf8_lossy(&output.stderr);
    let missing: Vec<_> = case
        .says
        .iter()
        .filter(|phrase| !said.contains(**phrase))
        .collect();
    let code = output.status.code();
    let result_left = beside("result").exists() || beside("out").exists();
    let sound = code == Some(2)
        && missing.is_empty()
        && output.stdout.is_empty()
        && !result_left
        && !said.contains("internal error");
    (!sound).then(|| {
        format!(
            "exit code {code:?}, missing {missing:?}, results left: {result_left}, said:\n{said}"
        )
    })
}

#[test]
fn wrong_input_is_named_with_its_place_and_fault() {
    let cases: Vec<Case> = [
        toml_cases(),
        meaning_cases(),
        file_cases(),
        line_cases(),
        robots::cases(),
    ]
    .into_iter()
    .flatten()
    .collect();
    assert!(cases.len() >= 115, "{} cases", cases.len());
    let faults: Vec<String> = cases
        .iter()
        .filter_map(|case| Some(format!("{}: {}", case.name, fault_of(case)?)))
        .collect();
    assert!(
        faults.is_empty(),
        "{} of {}:\n{}",
        faults.len(),
        cases.len(),
        faults.join("\n")
    );
}

#[test]
fn the_template_itself_is_not_wrong() {
    let sound = line("nothing", &["check", "task.toml"], &[]);
    let fault = fault_of(&sound).expect("a sound task does not end like a wrong one");
    assert!(fault.contains("exit code Some(0)"), "{fault}");
}
