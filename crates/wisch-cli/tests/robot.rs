//! `wisch robot check` in a real temporary directory.

use crate::program::{root, wisch};
use serde_json::Value;
use std::fs;
use std::path::Path;

const ARM: &str = r#"<robot name="arm">
  <link name="base"/>
  <link name="rod">
    <inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1"/></inertial>
    <collision><geometry><mesh filename="package://rods/rod.stl"/></geometry></collision>
  </link>
  <joint name="pivot" type="revolute"><parent link="base"/><child link="rod"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" velocity="1" effort="1" acceleration="1"/></joint>
</robot>"#;

/// Exit code, standard output and standard error.
fn check(folder: &Path, args: &[&str]) -> (i32, String, String) {
    wisch(folder, &[&["robot", "check"], args].concat())
}

fn folder_with(text: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("arm.urdf"), text).expect("written");
    folder
}

#[test]
fn the_shipped_robots_are_fine() {
    let robots = root().join("robots");
    for file in ["humanoid.urdf", "arm7.urdf", "arm6.urdf"] {
        let (code, out, err) = check(&robots, &[file]);
        assert_eq!(code, 0, "{out}{err}");
    }
    let (code, out, _) = check(&robots, &["humanoid.urdf", "--json"]);
    let record: Value = serde_json::from_str(&out).expect("one JSON object");
    assert_eq!(code, 0);
    assert_eq!(
        record["robot"]["variables"].as_array().map(Vec::len),
        Some(22)
    );
    assert_eq!(record["warnings"], 0);
}

#[test]
fn packages_are_resolved_where_they_are_named() {
    let folder = folder_with(ARM);
    let (code, out, err) = check(folder.path(), &["arm.urdf"]);
    assert_eq!(code, 2);
    assert!(out.contains("add --package rods=DIR"), "{out}");
    assert!(err.contains("no robot can be made of it: 1 error"), "{err}");

    let meshes = folder.path().join("elsewhere");
    fs::create_dir(&meshes).expect("made");
    let sponge = include_bytes!("../../../knowledge/meshes/sponge.stl");
    fs::write(meshes.join("rod.stl"), sponge).expect("written");
    let (code, out, err) = check(folder.path(), &["arm.urdf", "--package", "rods=elsewhere"]);
    assert_eq!(code, 0, "{out}{err}");
    assert!(
        out.starts_with("arm: 2 links, 1 joint, 1 variable, 1.0 kg\n"),
        "{out}"
    );
}

#[test]
fn warnings_are_told_by_the_exit_code_and_in_json() {
    let text = ARM.replace("velocity=\"1\"", "velocity=\"0\"").replace(
        "<mesh filename=\"package://rods/rod.stl\"/>",
        "<sphere radius=\"1\"/>",
    );
    let folder = folder_with(&text);
    let (code, out, _) = check(folder.path(), &["arm.urdf", "--json"]);
    assert_eq!(code, 1);
    let record: Value = serde_json::from_str(&out).expect("one JSON object");
    assert_eq!(record["findings"][0]["joint"], "pivot");
    assert_eq!(record["findings"][0]["fault"], "limit");
    assert_eq!(record["findings"][0]["line"], 7);
    let (code, out, _) = check(folder.path(), &["arm.urdf"]);
    assert_eq!(code, 1);
    assert!(
        out.contains("warning  arm.urdf:7:3: joint \"pivot\": its velocity limit is 0 rad/s"),
        "{out}"
    );
}

#[test]
fn what_is_no_urdf_is_an_error() {
    for (text, expected) in [
        ("name = 3", "arm.urdf:1:1: "),
        ("<sdf/>", "arm.urdf:1:1: expected <robot>, found <sdf>"),
    ] {
        let (code, out, err) = check(folder_with(text).path(), &["arm.urdf", "--json"]);
        assert_eq!(code, 2);
        assert_eq!(out, "");
        assert!(err.contains(expected), "{err}");
    }
    let (code, _, err) = check(folder_with(ARM).path(), &["arn.urdf"]);
    assert_eq!(code, 2);
    assert!(err.contains("did you mean arm.urdf?"), "{err}");
}
