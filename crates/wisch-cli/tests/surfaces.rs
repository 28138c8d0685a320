//! `wisch surface check`: meshes that are usable, and meshes that are not.

use crate::program::wisch;
use std::fmt::Write;
use std::fs;
use std::path::Path;

/// Writes a grid of 40 × 30 squares over 1.0 × 0.6 m as PLY, mapped into space; some faces are flipped.
pub fn write_grid(path: &Path, map: impl Fn(f64, f64) -> [f64; 3], flipped: usize) {
    let (columns, rows) = (40, 30);
    let mut text = format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        (columns + 1) * (rows + 1),
        columns * rows
    );
    for j in 0..=rows {
        for i in 0..=columns {
            let [x, y, z] = map(
                f64::from(i) / f64::from(columns) - 0.5,
                0.6 * f64::from(j) / f64::from(rows) - 0.3,
            );
            writeln!(text, "{x} {y} {z}").unwrap();
        }
    }
    for face in 0..columns * rows {
        let a = face / columns * (columns + 1) + face % columns;
        let mut corners = [a, a + 1, a + columns + 2, a + columns + 1];
        if (face as usize) < flipped {
            corners.reverse();
        }
        let [a, b, c, d] = corners;
        writeln!(text, "4 {a} {b} {c} {d}").unwrap();
    }
    fs::write(path, text).unwrap();
}

fn door(x: f64, y: f64) -> [f64; 3] {
    [x, y, -x * x / 8.0 - y * y / 2.4]
}

#[test]
fn a_door_is_usable_and_drawn() {
    let folder = tempfile::tempdir().unwrap();
    write_grid(&folder.path().join("door.ply"), door, 0);
    let (code, out, err) = wisch(
        folder.path(),
        &["surface", "check", "door.ply", "--picture", "door.svg"],
    );
    assert_eq!((code, err.as_str()), (0, ""));
    for line in [
        "door.ply: 2400 triangles, 1.000 x 0.600 x ",
        "part        the whole mesh; 0.60",
        "borders     3.2",
        "usable      yes, in one chart",
        "picture     door.svg",
    ] {
        assert!(out.contains(line), "{line}\n{out}");
    }
    let picture = fs::read_to_string(folder.path().join("door.svg")).unwrap();
    assert!(picture.starts_with("<svg") && picture.contains("Stretch of lengths"));
    let (code, out, _) = wisch(folder.path(), &["surface", "check", "door.ply", "--json"]);
    assert_eq!(code, 0);
    let record: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(record["format"], "wisch-surface-check");
    assert_eq!(record["usable"], true);
    assert!(record["problem"].is_null());
    // The barrel of 1.2 m radius, seen from above.
    let bulge = record["chart"]["largest_bulge"]["value"].as_f64().unwrap();
    assert!((bulge - 1.0 / 1.2).abs() < 0.02, "{bulge}");
    assert_eq!(record["chart"]["touched_share"], 1.0);
}

#[test]
fn a_mesh_with_deep_ripples_is_not_touched_everywhere() {
    let folder = tempfile::tempdir().unwrap();
    // Ripples of ±6 mm with a pitch of 0.1 m, finer than the tool of 0.12 m radius.
    let ripples = |x: f64, y: f64| [x, y, 0.006 * (62.83 * x).sin()];
    write_grid(&folder.path().join("ripples.ply"), ripples, 0);
    let check = |depth: &str| {
        let words = ["surface", "check", "ripples.ply", "--tool-radius", "0.12"];
        let words = [&words[..], &["--compression-depth-m", depth]].concat();
        wisch(folder.path(), &words).1
    };
    let hard = check("0.001");
    assert!(
        hard.contains("of the smoothed area (on the mesh as given, less"),
        "{hard}"
    );
    assert!(
        hard.contains("contact with these shapes is not predicted"),
        "{hard}"
    );
    let soft = check("0.02");
    assert!(!soft.contains("smoothed area"), "{soft}");
    assert!(!soft.contains("is not predicted"), "{soft}");
    let task = |depth: &str| {
        let text = format!(
            "schema = 1\nname = \"plate\"\naction = \"polish\"\n\
             tool = {{ name = \"pad\", footprint_m = [0.14, 0.19], height_m = 0.05, compression_depth_m = {depth} }}\n\
             medium = {{ name = \"polishing_paste\" }}\npolish = {{ passes = 1 }}\n\
             particles = {{ source = \"surface\", count = 400 }}\n\
             surface = {{ name = \"plate\", friction = 0.3, mesh = {{ file = \"ripples.ply\" }} }}\n"
        );
        fs::write(folder.path().join("task.toml"), text).unwrap();
        wisch(folder.path(), &["check", "task.toml"]).2
    };
    let expected = "contact with the grooves or ridges of the mesh is not predicted";
    let hard = task("0.001");
    assert!(hard.contains(expected), "{hard}");
    let soft = task("0.02");
    assert!(!soft.contains(expected), "{soft}");
}

#[test]
fn the_same_mesh_gives_the_same_bytes_on_any_number_of_threads() {
    let folder = tempfile::tempdir().unwrap();
    write_grid(&folder.path().join("door.ply"), door, 0);
    let report = |threads| {
        let args = [
            "surface",
            "check",
            "door.ply",
            "--json",
            "--threads",
            threads,
        ];
        wisch(folder.path(), &args)
    };
    assert_eq!(report("1"), report("16"));
}

#[test]
fn flipped_triangles_and_a_hard_tool_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    let bent = |x: f64, y: f64| [x, y, -y * y];
    write_grid(&folder.path().join("bent.ply"), bent, 17);
    let args = [
        "surface",
        "check",
        "bent.ply",
        "--compression-depth-m",
        "0.0001",
        "--tool-size",
        "0.1,0.1",
    ];
    let (code, out, _) = wisch(folder.path(), &args);
    assert_eq!(code, 0, "{out}");
    assert!(
        out.contains("turned 34 of 2400 triangles to the side of the other ones"),
        "{out}"
    );
    assert!(out.contains("on 0.0 % of the area"), "{out}");
    // From the other side it is hollow.
    let args = ["surface", "check", "bent.ply", "--towards", "0,0,-1"];
    let (_, out, _) = wisch(folder.path(), &args);
    assert!(
        out.contains("its triangles were turned towards the tool"),
        "{out}"
    );
    assert!(
        out.contains("no bulges; hollows to a radius of 0.5"),
        "{out}"
    );
}

#[test]
fn a_mesh_that_needs_several_charts_says_so_and_is_divided() {
    let folder = tempfile::tempdir().unwrap();
    let bowl = |x: f64, y: f64| {
        let (u, v) = (2.0 * x, 2.0 * y);
        let norm = (1.0 + u * u + v * v).sqrt();
        [0.3 * u / norm, 0.3 * v / norm, 0.3 - 0.3 / norm]
    };
    write_grid(&folder.path().join("bowl.ply"), bowl, 0);
    let (code, out, err) = wisch(folder.path(), &["surface", "check", "bowl.ply"]);
    assert_eq!((code, err.as_str()), (1, ""));
    assert!(
        out.contains("problem     unrolling stretches the surface by up to"),
        "{out}"
    );
    assert!(
        out.contains(
            "advice      divide the surface into patches with wisch surface split bowl.ply"
        ),
        "{out}"
    );
    let args = ["surface", "split", "bowl.ply", "--out", "patches"];
    let (code, out, err) = wisch(folder.path(), &args);
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    assert!(
        out.contains("patch 2") && out.contains("seams with 1 ("),
        "{out}"
    );
    let (code, out, _) = wisch(folder.path(), &["surface", "split", "bowl.ply", "--json"]);
    assert_eq!(code, 0);
    let record: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(record["format"], "wisch-surface-split");
    let patches = record["patches"].as_array().unwrap();
    assert!((2..=8).contains(&patches.len()), "{}", patches.len());
    let area = |patch: &serde_json::Value| patch["area_m2"].as_f64().unwrap();
    // The solid angle of a rectangle of 2 × 1.2 at the distance 1, on a sphere of 0.3 m radius.
    let expected = 0.09 * 4.0 * (0.6 / (2.0_f64 * 1.36).sqrt()).asin();
    let whole: f64 = patches.iter().map(area).sum();
    assert!((whole / expected - 1.0).abs() < 0.005, "{whole}");
    for (number, patch) in (1..).zip(patches) {
        assert_eq!(patch["number"], number);
        assert!(patch["stretch"]["p99"].as_f64().unwrap() <= 0.03);
        // Each patch is a mesh that one chart covers.
        let file = format!("patches/patch-{number}.stl");
        let (code, out, _) = wisch(folder.path(), &["surface", "check", &file, "--json"]);
        let checked: serde_json::Value = serde_json::from_str(&out).unwrap();
        assert_eq!(code, 0, "{out}");
        let found = checked["chart"]["area_m2"].as_f64().unwrap();
        assert!((found / area(patch) - 1.0).abs() < 0.02, "{found}");
        let picture = fs::read_to_string(folder.path().join(format!("patches/patch-{number}.svg")));
        assert!(picture.unwrap().starts_with("<svg"));
    }
    assert!(folder.path().join("patches/patches.svg").exists());
    let seams = record["seams"].as_array().unwrap();
    assert!(seams.len() + 1 >= patches.len(), "{seams:?}");
    // Nothing is replaced, and what is refused writes nothing.
    let (code, _, err) = wisch(folder.path(), &args);
    assert!(
        code == 2 && err.contains("patches: the folder exists already"),
        "{err}"
    );
    let (code, out, _) = wisch(
        folder.path(),
        &[
            "surface",
            "split",
            "bowl.ply",
            "--max-patches",
            "1",
            "--out",
            "one",
        ],
    );
    assert!(
        code == 1 && out.contains("advice      allow more patches"),
        "{out}"
    );
    assert!(!folder.path().join("one").exists());
}

#[test]
fn a_divided_mesh_is_the_same_on_any_number_of_threads() {
    let folder = tempfile::tempdir().unwrap();
    let saddle = |x: f64, y: f64| [x, y, x * x - y * y];
    write_grid(&folder.path().join("saddle.ply"), saddle, 0);
    let split = |threads| {
        let args = [
            "surface",
            "split",
            "saddle.ply",
            "--json",
            "--threads",
            threads,
        ];
        wisch(folder.path(), &args)
    };
    let (code, out, _) = split("1");
    assert!(code == 0 && out.contains("\"number\":2"), "{out}");
    assert_eq!(split("16").1, out);
}

#[test]
fn units_closed_bodies_and_parts_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let millimetres = |x: f64, y: f64| door(x, y).map(|c| 1000.0 * c);
    write_grid(&folder.path().join("mm.ply"), millimetres, 0);
    let (code, out, _) = wisch(folder.path(), &["surface", "check", "mm.ply"]);
    assert_eq!(code, 1, "{out}");
    assert!(
        out.contains("it is probably in millimetres: multiply by 0.001 with --scale 0.001"),
        "{out}"
    );
    let inches = |x: f64, y: f64| door(x, y).map(|c| c / 0.0254);
    write_grid(&folder.path().join("in.ply"), inches, 0);
    let (_, out, _) = wisch(folder.path(), &["surface", "check", "in.ply"]);
    assert!(
        out.contains(
            "in centimetres or inches: multiply by 0.01 or 0.0254 with --scale 0.01 or 0.0254"
        ),
        "{out}"
    );
    let args = ["surface", "check", "mm.ply", "--scale", "0.001"];
    let (code, out, _) = wisch(folder.path(), &args);
    assert!(code == 0 && out.contains("1.000 x 0.600 x"), "{out}");
    let wedge = "v 0 0 0\nv 0.4 0 0\nv 0 0.4 0\nv 0 0 0.4\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    fs::write(folder.path().join("wedge.obj"), wedge).unwrap();
    let (code, out, _) = wisch(folder.path(), &["surface", "check", "wedge.obj"]);
    assert_eq!(code, 1);
    assert!(
        out.contains("problem     this mesh is closed: 4 triangles without a border"),
        "{out}"
    );
    let args = ["surface", "check", "wedge.obj", "--towards", "1,1,1"];
    let (code, out, _) = wisch(folder.path(), &args);
    assert_eq!(code, 0, "{out}");
    assert!(
        out.contains("the side towards the tool has 1 of 4 triangles"),
        "{out}"
    );
}

#[test]
fn wrong_input_is_an_error_with_place_and_limit() {
    let folder = tempfile::tempdir().unwrap();
    let cloud = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n";
    fs::write(folder.path().join("cup.ply"), cloud).unwrap();
    fs::write(folder.path().join("cup.step"), "").unwrap();
    write_grid(&folder.path().join("door.ply"), door, 0);
    for (args, expected) in [
        (
            &["cup.ply"][..],
            "it has points and no face (number of points: 1): a point cloud has to be meshed first",
        ),
        (&["cup.step"], "must end in .stl, .obj, .dae, .ply or .asc"),
        (&["none.ply"], "none.ply"),
        (
            &["door.ply", "--tool-radius", "1e-9"],
            "outside 0.0001 to 5 m",
        ),
        (&["door.ply", "--towards", "0,0"], "2 numbers, expected 3"),
        (
            &["door.ply", "--towards", "0,0,0"],
            "length of the direction to the tool = 0",
        ),
        (
            &["door.ply", "--stretch-limit", "nan"],
            "limit of the stretch = NaN is outside 0.001 to 1",
        ),
        (
            &["door.ply", "--scale", "1e6"],
            "1000000 is outside 0.000001 to 1000",
        ),
        (&["door.ply", "--picture", "door.png"], "must end in .svg"),
    ] {
        let (code, out, err) = wisch(folder.path(), &[&["surface", "check"], args].concat());
        assert_eq!((code, out.as_str()), (2, ""), "{args:?}");
        assert!(err.contains(expected), "{args:?}: {err}");
    }
    let files = fs::read_dir(folder.path()).unwrap().count();
    assert_eq!(files, 3, "nothing is written");
}

#[test]
fn an_object_that_ends_at_the_surface_is_remarked_on_unless_it_carries_it() {
    let folder = crate::program::folder_with("arm-board.toml");
    let file = folder.path().join("task.toml");
    let (_, _, err) = wisch(folder.path(), &["check", "task.toml"]);
    assert_eq!(err, "");
    let text = fs::read_to_string(&file).unwrap();
    let alone = text.replace("carried_by = \"board\"\n", "");
    assert_ne!(alone, text);
    fs::write(file, alone).unwrap();
    let (_, _, err) = wisch(folder.path(), &["check", "task.toml"]);
    assert!(
        err.contains("\"board\" ends at the surface") && err.contains("add carried_by = \"board\""),
        "{err}"
    );
}

#[test]
fn a_surface_that_is_no_face_of_its_carrier_is_remarked_on() {
    let folder = crate::program::folder_with("arm-board.toml");
    for (setting, expected) in [
        (
            "surface.position_m=[0,0,0.76]",
            Some("it lies 10.0 mm inside it, below its face"),
        ),
        (
            "surface.position_m=[0,0,0.80]",
            Some("it lies 30.0 mm above its face"),
        ),
        (
            "surface.position_m=[0.05,0,0.77]",
            Some("it reaches up to 50 mm beyond that face"),
        ),
        (
            "surface.rpy_rad=[0.1,0,0]",
            Some("it leans by 5.7 degrees against the nearest face"),
        ),
        ("surface.position_m=[0,0,0.772]", None),
        ("surface.size_m=[0.3,0.2]", None),
    ] {
        let (_, _, notes) = wisch(folder.path(), &["check", "task.toml", "--set", setting]);
        let no_face = "surface \"chopping_board\" is no face of \"board\", which carries it: ";
        match expected {
            Some(expected) => assert!(
                notes.contains(&(no_face.to_owned() + expected)),
                "{setting}: {notes}"
            ),
            None => assert!(!notes.contains("is no face of"), "{setting}: {notes}"),
        }
    }
}
