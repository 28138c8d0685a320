//! Tasks over the patches of a divided mesh.

use crate::executor::has_python;
use crate::program::{root, wisch};
use crate::surfaces::write_grid;
use serde_json::Value;
use std::fs;
use std::path::Path;

/// Writes a saddle that needs two patches, and a task that polishes it.
fn write_task(folder: &Path, patch: &str) {
    let saddle = |x: f64, y: f64| [0.6 * x, 0.667 * y, 0.36 * x * x - 0.444 * y * y];
    write_grid(&folder.join("saddle.ply"), saddle, 0);
    let task = format!(
        "schema = 1\nname = \"saddle\"\naction = \"polish\"\ntool = {{ name = \"sponge\" }}\n\
         medium = {{ name = \"polishing_paste\" }}\npolish = {{ passes = 1 }}\n\
         particles = {{ source = \"surface\", count = 400 }}\n\
         surface = {{ name = \"saddle\", friction = 0.3, mesh = {{ file = \"saddle.ply\"{patch} }} }}\n"
    );
    fs::write(folder.join("saddle.toml"), task).unwrap();
}

#[test]
fn a_task_over_all_patches_is_one_result() {
    let folder = tempfile::tempdir().unwrap();
    write_task(folder.path(), ", patch = \"all\"");
    let args = ["predict", "saddle.toml", "--out", "all", "--json"];
    let (code, out, err) = wisch(folder.path(), &args);
    assert_eq!(code, 0, "{out}\n{err}");
    let all: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(all["format"], "wisch-patches");
    let patches = all["patches"].as_array().unwrap();
    assert_eq!(patches.len(), 2, "{err}");
    assert!(
        err.contains("surface \"saddle\" is patch 2 of 2 of its mesh"),
        "{err}"
    );
    // The particles are shared.
    let particles: u64 = patches
        .iter()
        .map(|patch| patch["particles"].as_u64().unwrap())
        .sum();
    assert!((380..=420).contains(&particles), "{particles}");
    assert_eq!(all["particles"], particles);
    let performance = all["predicted_performance"].as_f64().unwrap();
    assert!(performance > 0.97, "{performance}");
    // Strokes reach over the seam, and no patch counts those of its neighbour.
    let note = all["seam_note"].as_str().unwrap();
    assert!(
        note.contains("strokes of neighbouring patches overlap at seams"),
        "{note}"
    );
    assert!(err.contains("strokes reach over the seams"), "{err}");
    let page = fs::read_to_string(folder.path().join("all/report.html")).unwrap();
    for (number, patch) in (1..).zip(patches) {
        assert_eq!(patch["task"], format!("saddle-patch-{number}"));
        let report = format!("all/patch-{number}/report.html");
        assert!(folder.path().join(&report).exists());
        let link = format!("href=\"patch-{number}/report.html\"");
        assert!(page.contains(&link), "{page}");
    }
    assert!(
        page.contains("predicted 100.0 %") || page.contains("predicted 9"),
        "{page}"
    );
    // A patch alone gives the same plan.
    let shared = patches[1]["particles"].to_string();
    let count = format!("particles.count={shared}");
    let args = [
        "predict",
        "saddle.toml",
        "--set",
        "surface.mesh.patch=2",
        "--set",
        &count,
        "--set",
        "name=saddle-patch-2",
        "--out",
        "second",
    ];
    let (code, out, _) = wisch(folder.path(), &args);
    assert_eq!(code, 0, "{out}");
    let plan = |folder_of: &str| fs::read(folder.path().join(folder_of).join("plan.json")).unwrap();
    assert_eq!(plan("all/patch-2"), plan("second"));
    assert_ne!(plan("all/patch-1"), plan("second"));
    // The plan of a patch is refused on another.
    let args = [
        "predict",
        "saddle.toml",
        "--set",
        "surface.mesh.patch=1",
        "--plan",
        "second/plan.json",
    ];
    let (code, _, err) = wisch(folder.path(), &args);
    assert!(code == 2 && err.contains("surface"), "{err}");
}

#[test]
fn patches_that_are_finished_are_summed_up_after_an_error() {
    let folder = tempfile::tempdir().unwrap();
    write_task(folder.path(), ", patch = \"all\"");
    let out = folder.path().join("all");
    fs::create_dir(&out).unwrap();
    fs::write(out.join("patch-2"), "no folder").unwrap();
    let args = ["predict", "saddle.toml", "--out", "all", "--json"];
    let (code, printed, err) = wisch(folder.path(), &args);
    assert_eq!(code, 2, "{err}");
    assert!(err.contains("patch 2 of 2"), "{err}");
    let earlier = "all holds results of an earlier command too: patch-2";
    assert!(err.contains(earlier), "{err}");
    let all: Value = serde_json::from_str(&printed).unwrap();
    assert_eq!(all["patches"].as_array().unwrap().len(), 1);
    assert_eq!(
        (&all["patch_count"], &all["goal_met"]),
        (&2.into(), &false.into())
    );
    let page = fs::read_to_string(out.join("report.html")).unwrap();
    assert!(page.contains("href=\"patch-1/report.html\""), "{page}");
    assert!(!page.contains("href=\"patch-2/report.html\""), "{page}");
    // An error on the first patch leaves nothing to sum up.
    fs::remove_dir_all(out.join("patch-1")).unwrap();
    fs::remove_file(out.join("report.html")).unwrap();
    fs::write(out.join("patch-1"), "no folder").unwrap();
    let (code, printed, err) = wisch(folder.path(), &args);
    assert_eq!(code, 2, "{err}");
    assert!(
        printed.starts_with("{\"error\":\"patch 1 of 2: "),
        "{printed}"
    );
    assert!(!out.join("report.html").exists());
}

#[test]
fn what_is_for_one_patch_is_refused_for_all() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |args: &[&str], expected: &str| {
        let (code, out, err) = wisch(folder.path(), args);
        assert_eq!((code, out.as_str()), (2, ""), "{args:?}");
        assert!(err.contains(expected), "{args:?}: {err}");
    };
    write_task(folder.path(), "");
    refused(
        &["predict", "saddle.toml"],
        "surface.mesh.patch takes a part of it, see wisch surface split ",
    );
    write_task(folder.path(), ", patch = \"all\"");
    refused(
        &["check", "saddle.toml"],
        "only wisch run, follow, predict and plan take \"all\"; choose the number of a patch, of which the mesh has 2",
    );
    refused(
        &["predict", "saddle.toml", "--plan", "plan.json"],
        "--plan is for one patch, but surface.mesh.patch = \"all\"",
    );
    refused(
        &["run", "saddle.toml", "--resume"],
        "--resume is for one patch",
    );
    refused(
        &["predict", "saddle.toml", "--set", "surface.mesh.patch=3"],
        "there is no patch 3: the mesh has 2 patches",
    );
    refused(
        &[
            "predict",
            "saddle.toml",
            "--action",
            "dispense",
            "--set",
            "medium.name=paint",
            "--set",
            "tool={ name = \"roller\", footprint_m = [0.07, 0.11], height_m = 0.05 }",
            "--set",
            "dispense={ thickness_m = 0.0001, volume_m3_per_m = 0.000011 }",
        ],
        "surface.mesh.patch = \"all\" does not work with the action dispense",
    );
    fs::write(folder.path().join("places.csv"), "x_m,y_m\n0,0\n").unwrap();
    refused(
        &[
            "predict",
            "saddle.toml",
            "--action",
            "absorb",
            "--set",
            "medium.name=breadcrumbs",
            "--set",
            "particles={ source = \"csv\", file = \"places.csv\" }",
        ],
        "surface.mesh.patch = \"all\" needs particles.source = \"uniform\" or \"surface\"",
    );
    assert_eq!(
        fs::read_dir(folder.path()).unwrap().count(),
        3,
        "nothing is written"
    );
}

#[test]
fn no_patch_is_wiped_after_a_stop_whatever_the_verdict() {
    if !has_python() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let saddle = |x: f64, y: f64| [0.3 * x, 0.33 * y, 0.18 * x * x - 0.222 * y * y];
    write_grid(&folder.path().join("saddle.ply"), saddle, 0);
    let task = r#"
schema = 1
name = "saddle"
action = "polish"
polish = { passes = 1 }
tool = { name = "pad", footprint_m = [0.03, 0.04], height_m = 0.05, compression_depth_m = 0.01 }
medium = { name = "polishing_paste" }
particles = { source = "surface", count = 400 }
surface = { name = "saddle", friction = 0.3, position_m = [0.5, 0.0, 0.3], mesh = { file = "saddle.ply", patch = "all" } }
robot = { name = "arm7" }
"#;
    fs::write(folder.path().join("saddle.toml"), task).unwrap();
    // Stopped on the way to the surface: whether the goal is met cannot be told.
    let robot = fs::read_to_string(root().join("docs/echo_robot.py")).unwrap();
    let robot = [
        (
            "{\"version\": 1}",
            "{\"version\": 2, \"accepts_curved\": True}",
        ),
        ("for point in points:", "for point in points[:20]:"),
        (
            "motion[\"duration_s\"], \"ending\": \"complete\"",
            "points[19][\"time_s\"], \"ending\": \"stopped\"",
        ),
        ("points[-1][\"positions\"]", "points[19][\"positions\"]"),
    ]
    .iter()
    .fold(robot, |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    });
    fs::write(folder.path().join("robot.py"), robot).unwrap();
    let args = [
        "run",
        "saddle.toml",
        "--executor",
        "python3 robot.py",
        "--rounds",
        "1",
        "--no-memory",
        "--json",
        "--out",
        "out",
    ];
    let (code, out, err) = wisch(folder.path(), &args);
    assert_eq!(code, 1, "{out}\n{err}");
    assert!(err.contains("stopped on patch 1 of 2"), "{err}");
    let all: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(all["patch_count"], 2);
    assert_eq!(all["is_conclusive"], false);
    assert_eq!(all["patches"].as_array().unwrap().len(), 1);
    assert_eq!(all["goal_met"], false);
    assert!(!folder.path().join("out/patch-2").exists());
}
