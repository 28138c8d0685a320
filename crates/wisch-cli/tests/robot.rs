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
    let (code, out, _) = check(folder.path(), &["arm.urdf"]);
    assert_eq!(code, 1);
    assert_eq!(out.matches("add --package rods=DIR").count(), 1, "{out}");
    assert!(out.contains("not checked for collisions"), "{out}");
    assert!(!out.contains("note "), "{out}");

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
    assert!(!out.contains("note "), "{out}");
}

#[test]
fn packages_are_found_above_the_urdf_and_by_the_task() {
    let sponge = include_bytes!("../../../knowledge/meshes/sponge.stl");
    // As ROS lays a workspace out: the meshes are in the package of the URDF, or in one beside it.
    for (urdf, mesh, manifest) in [
        ("rods/urdf/arm.urdf", "rods/rod.stl", "rods/package.xml"),
        (
            "arm_description/urdf/arm.urdf",
            "rods/rod.stl",
            "rods/package.xml",
        ),
    ] {
        let folder = tempfile::tempdir().expect("a temporary folder");
        for (file, content) in [
            (urdf, ARM.as_bytes()),
            (mesh, sponge),
            (manifest, b"<package/>"),
        ] {
            let path = folder.path().join(file);
            fs::create_dir_all(path.parent().expect("a folder")).expect("made");
            fs::write(path, content).expect("written");
        }
        let (code, out, err) = check(folder.path(), &[urdf]);
        assert_eq!(code, 0, "{urdf}: {out}{err}");
        // A copy without its manifest, from another working directory.
        fs::remove_file(folder.path().join(manifest)).expect("removed");
        let path = folder.path().join(urdf).display().to_string();
        let (code, out, err) = check(&root(), &[&path]);
        assert_eq!(code, 0, "{urdf}: {out}{err}");
    }

    let folder = folder_with(&ARM.replace("package://", "package:///"));
    let meshes = folder.path().join("elsewhere");
    fs::create_dir(&meshes).expect("made");
    fs::write(meshes.join("rod.stl"), sponge).expect("written");
    let task = fs::read_to_string(root().join("scenarios/arm-board.toml")).expect("shipped");
    let own = "urdf = \"arm.urdf\"\npackages = { rods = \"elsewhere\" }";
    fs::write(
        folder.path().join("own.toml"),
        task.replace("name = \"arm7\"", own),
    )
    .expect("written");
    let (_, out, err) = wisch(folder.path(), &["check", "own.toml"]);
    assert!(!err.contains("package"), "{out}{err}");
    fs::write(
        folder.path().join("bare.toml"),
        task.replace("name = \"arm7\"", "urdf = \"arm.urdf\""),
    )
    .expect("written");
    let (_, _, err) = wisch(folder.path(), &["check", "bare.toml"]);
    let told = "collision meshes of rod cannot be read, and are not checked for collisions: \
                mesh \"package:///rods/rod.stl\": the package rods is unknown; add --package rods=DIR";
    assert!(err.contains(told), "{err}");
    // The tool would be held somewhere inside the rod.
    assert!(
        err.contains("the outermost point of the hand, which is unknown"),
        "{err}"
    );
    // A sweep with an invalid value ends before its first run.
    let sweep = ["eval", "sweep", "bare.toml", "--set", "strategy=none"];
    for args in [&sweep[..], &["robot", "map", "arm.urdf", "--samples", "10"]] {
        let (_, _, err) = wisch(folder.path(), args);
        assert!(err.contains(told), "{args:?}: {err}");
    }
}

#[test]
fn an_unknown_package_is_one_line_and_each_mesh_a_finding() {
    let mesh = |name: &str| {
        format!(
            "<collision><geometry><mesh filename=\"package://rods/{name}.stl\"/></geometry></collision>"
        )
    };
    let text = ARM.replace(&mesh("rod"), &(mesh("rod") + "\n" + &mesh("end")));
    let folder = folder_with(&text);
    let (code, out, _) = check(folder.path(), &["arm.urdf"]);
    assert_eq!(code, 1);
    assert_eq!(out.matches("add --package rods=DIR").count(), 1, "{out}");
    assert!(out.contains("link \"rod\": 2 meshes: "), "{out}");
    let both = "(meshes \"package://rods/rod.stl\", \"package://rods/end.stl\")";
    assert!(out.contains(both), "{out}");
    let (_, out, _) = check(folder.path(), &["arm.urdf", "--json"]);
    let record: Value = serde_json::from_str(&out).expect("one JSON object");
    let findings = record["findings"].as_array().expect("findings");
    let meshes = findings.iter().filter(|found| found["fault"] == "mesh");
    assert_eq!(meshes.count(), 2);
}

#[test]
fn warnings_show_in_the_exit_code_and_in_json() {
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
        (
            "<?xml version=\"1.0\"?>\n<!DOCTYPE robot [<!ENTITY m \"1\">]>\n<robot name=\"arm\"><link name=\"a\"/></robot>",
            "arm.urdf:2:1: a document type declaration (DTD) is not read",
        ),
    ] {
        let (code, out, err) = check(folder_with(text).path(), &["arm.urdf", "--json"]);
        assert_eq!(code, 2);
        let said: serde_json::Value = serde_json::from_str(&out).expect("an object");
        assert!(
            said["error"]
                .as_str()
                .is_some_and(|text| text.starts_with(expected))
        );
        assert!(err.contains(expected), "{err}");
    }
    let (code, _, err) = check(folder_with(ARM).path(), &["arn.urdf"]);
    assert_eq!(code, 2);
    assert!(err.contains("did you mean arm.urdf?"), "{err}");
}

#[test]
fn a_chain_of_too_many_joints_and_a_limit_of_years_are_warnings() {
    let mut text = "<robot name=\"long\"><link name=\"l0\"/>".to_owned();
    for i in 1..=30 {
        let velocity = if i == 7 { "1e-9" } else { "1" };
        text += &format!(
            "<link name=\"l{i}\"/><joint name=\"j{i}\" type=\"revolute\"><parent link=\"l{}\"/><child link=\"l{i}\"/>\
             <origin xyz=\"0 0 0.1\"/><axis xyz=\"0 1 0\"/>\
             <limit lower=\"-1\" upper=\"1\" velocity=\"{velocity}\" effort=\"1\"/></joint>",
            i - 1
        );
    }
    let (code, out, err) = check(folder_with(&(text + "</robot>")).path(), &["arm.urdf"]);
    assert_eq!(code, 1, "{err}");
    assert!(
        out.contains("has 30 moving joints, expected at most 24"),
        "{out}"
    );
    assert!(
        out.contains(
            "joint \"j7\": its velocity limit is 0.000000001 rad/s, expected at least 0.001 rad/s"
        ),
        "{out}"
    );
}

#[test]
fn a_ready_posture_in_which_links_overlap_is_a_warning() {
    let link = |name: &str, length: f64| {
        format!(
            "<link name=\"{name}\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\"/></inertial>\
             <collision><origin xyz=\"0 0 {}\"/><geometry><box size=\"0.05 0.05 {length}\"/></geometry></collision></link>",
            length / 2.0
        )
    };
    let joint = |name: &str, parent: &str, child: &str| {
        format!(
            "<joint name=\"{name}\" type=\"revolute\"><parent link=\"{parent}\"/><child link=\"{child}\"/>\
             <origin xyz=\"0 0 0.3\"/><axis xyz=\"0 1 0\"/>\
             <limit lower=\"-3.2\" upper=\"3.2\" velocity=\"1\" effort=\"9\" acceleration=\"9\"/></joint>"
        )
    };
    let links = link("base", 0.1) + &link("upper", 0.2) + &link("lower", 0.6);
    let joints = joint("shoulder", "base", "upper") + &joint("elbow", "upper", "lower");
    let folder = folder_with(&format!("<robot name=\"arm\">{links}{joints}</robot>"));
    for (elbow, is_free) in [(0.5, true), (3.1, false)] {
        let srdf = format!(
            "<robot name=\"arm\"><group name=\"arm\"><chain base_link=\"base\" tip_link=\"lower\"/></group>\
             <group_state name=\"ready\" group=\"arm\"><joint name=\"elbow\" value=\"{elbow}\"/></group_state></robot>"
        );
        fs::write(folder.path().join("arm.srdf"), srdf).expect("written");
        let (_, out, err) = check(folder.path(), &["arm.urdf"]);
        let warning =
            "in the posture in which motions begin, \"base\" and \"lower\" have a clearance of";
        assert_eq!(out.contains(warning), !is_free, "{elbow}: {out}{err}");
    }
}

const SRDF: &str = r#"<robot name="arm">
  <group name="manipulator"><chain base_link="base" tip_link="rod"/></group>
  <group_state name="ready" group="manipulator"><joint name="pivot" value="0.5"/></group_state>
  <disable_collisions link1="base" link2="rod" reason="Adjacent"/>
</robot>"#;

/// The arm without a mesh, and an SRDF beside it.
fn folder_with_srdf(srdf: &[u8]) -> tempfile::TempDir {
    let folder = folder_with(&ARM.replace(
        "<mesh filename=\"package://rods/rod.stl\"/>",
        "<sphere radius=\"1\"/>",
    ));
    fs::write(folder.path().join("arm.srdf"), srdf).expect("written");
    folder
}

#[test]
fn an_srdf_is_checked_with_its_urdf() {
    let (code, out, err) = check(folder_with_srdf(SRDF.as_bytes()).path(), &["arm.urdf"]);
    assert_eq!(code, 0, "{out}{err}");
    assert!(out.contains("with arm.srdf\n"), "{out}");
    for (text, expected) in [
        (
            "garbage".to_owned(),
            "arm.srdf:1:1: robot: this is not XML: unknown token",
        ),
        (
            SRDF.replace("</robot>", ""),
            "arm.srdf:1:1: robot: this is not XML: the root node was opened but never closed",
        ),
        (
            SRDF.replace("tip_link=\"rod\"", "tip_link=\"rdo\""),
            "arm.srdf:2:29: robot: unknown link \"rdo\"; nearest: rod",
        ),
        (
            SRDF.replace("0.5", "half"),
            "arm.srdf:3:49: robot: <joint value=\"half\">, expected a number within 1e9",
        ),
    ] {
        let folder = folder_with_srdf(text.as_bytes());
        let (code, out, err) = check(folder.path(), &["arm.urdf"]);
        assert_eq!(code, 2, "{out}{err}");
        assert!(out.contains(&format!("error    {expected}")), "{out}");
        assert!(
            err.contains("arm.srdf: the SRDF cannot be used: 1 error"),
            "{err}"
        );
        assert!(!out.contains("no findings"), "{out}");
    }
    let (code, _, err) = check(folder_with_srdf(&[0xff, 0xfe, 0]).path(), &["arm.urdf"]);
    assert_eq!(code, 2);
    assert!(err.contains("arm.srdf"), "{err}");
}

#[test]
fn an_srdf_of_another_robot_is_a_warning_and_what_it_names_are_errors() {
    let folder = folder_with_srdf(SRDF.replace("name=\"arm\"", "name=\"leg\"").as_bytes());
    let (code, out, _) = check(folder.path(), &["arm.urdf", "--json"]);
    assert_eq!(code, 1);
    let record: Value = serde_json::from_str(&out).expect("one JSON object");
    assert_eq!(record["srdf"], "arm.srdf");
    let finding = &record["findings"][0];
    assert_eq!(finding["severity"], "warning");
    assert_eq!(finding["fault"], "srdf");
    assert_eq!(finding["file"], "arm.srdf");
    assert_eq!(finding["line"], 1);
    assert_eq!(finding["value"], "the SRDF is of robot \"leg\"");

    let humanoid = root().join("robots").join("humanoid.srdf");
    let humanoid = humanoid.to_str().expect("a path");
    let (code, out, _) = check(folder.path(), &["arm.urdf", "--srdf", humanoid]);
    assert_eq!(code, 2);
    for name in ["link \"platform\"", "variable joint \"base_x\""] {
        assert_eq!(out.matches(&format!("unknown {name}")).count(), 1, "{out}");
    }
}
