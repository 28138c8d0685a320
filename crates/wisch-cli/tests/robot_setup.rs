//! `wisch robot setup` in a real temporary directory, and following with what it wrote.

use crate::program::{contents, folder_with, root, wisch};
use serde_json::Value;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// A folder with the URDF of a shipped robot, without its SRDF.
fn folder_of(robot: &str) -> TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    copy_urdf(robot, folder.path());
    folder
}

fn copy_urdf(robot: &str, folder: &Path) {
    let file = format!("{robot}.urdf");
    fs::copy(root().join("robots").join(&file), folder.join(file)).expect("a URDF");
}

fn setup(folder: &Path, args: &[&str]) -> (i32, String, String) {
    wisch(folder, &[&["robot", "setup"], args].concat())
}

/// The object that a command prints with `--json`.
fn object(out: &str) -> Value {
    serde_json::from_str(out).expect("exactly one JSON object")
}

/// Follows the task of a folder with a robot; returns the summary.
fn follow(folder: &Path, robot: &str) -> Value {
    let options = [
        "--strategy",
        "kde",
        "--robot",
        robot,
        "--out",
        "done",
        "--json",
    ];
    let args = [&["follow", "task.toml"][..], &options].concat();
    let (code, out, err) = wisch(folder, &args);
    assert_eq!(code, 0, "{err}");
    object(&out)
}

#[test]
fn an_arm_without_an_srdf_is_set_up_and_wipes() {
    let folder = folder_with("arm-board.toml");
    copy_urdf("arm7", folder.path());
    let (code, out, err) = setup(folder.path(), &["arm7.urdf"]);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(
        out.contains("  group        arm: 7 joints, link_0 to tcp\n"),
        "{out}"
    );
    assert!(out.contains("  SRDF         arm7.srdf\n"), "{out}");
    let next = "next: wisch robot check arm7.urdf, then wisch follow arm-board --robot arm7.urdf\n";
    assert!(out.ends_with(next), "{out}");

    let (code, out, err) = wisch(folder.path(), &["robot", "check", "arm7.urdf"]);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(out.contains("no findings"), "{out}");

    let summary = follow(folder.path(), "arm7.urdf");
    assert_eq!(summary["abandoned_nodes"], 0);
    assert_eq!(summary["faults"], 0);
}

/// A robot of four axes whose root is the frame from which it hangs.
const GANTRY: &str = r#"<robot name="gantry">
  <link name="frame"><inertial><mass value="20"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><origin xyz="0 0.6 0.1"/><geometry><box size="1.2 0.1 0.1"/></geometry></collision></link>
  <link name="bridge"><inertial><mass value="5"/><inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="carriage"><inertial><mass value="3"/><inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <link name="ram"><inertial><mass value="2"/><inertia ixx="0.05" iyy="0.05" izz="0.05" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><origin xyz="0 0 0.3"/><geometry><box size="0.06 0.06 0.5"/></geometry></collision></link>
  <link name="tool0"><inertial><mass value="0.5"/><inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="x" type="prismatic"><parent link="frame"/><child link="bridge"/><axis xyz="1 0 0"/><limit lower="-0.5" upper="0.5" velocity="1" effort="500"/></joint>
  <joint name="y" type="prismatic"><parent link="bridge"/><child link="carriage"/><axis xyz="0 1 0"/><limit lower="-0.5" upper="0.5" velocity="1" effort="500"/></joint>
  <joint name="z" type="prismatic"><parent link="carriage"/><child link="ram"/><axis xyz="0 0 -1"/><limit lower="0.1" upper="0.8" velocity="0.5" effort="500"/></joint>
  <joint name="yaw" type="revolute"><parent link="ram"/><child link="tool0"/><origin xyz="0 0 0" rpy="3.14159265358979 0 0"/><axis xyz="0 0 1"/><limit lower="-3" upper="3" velocity="2" effort="50"/></joint>
</robot>
"#;

#[test]
fn a_gantry_that_reaches_only_below_its_root_is_set_up_and_wipes() {
    let folder = folder_with("arm-board.toml");
    fs::write(folder.path().join("gantry.urdf"), GANTRY).expect("a URDF");
    let (code, out, err) = setup(folder.path(), &["gantry.urdf"]);
    assert_eq!((code, err.as_str()), (0, ""), "{out}");
    let place = "below the robot (assumed to hang)";
    assert!(out.contains(place), "{out}");
    assert!(
        out.contains("then put it above the surface of a task"),
        "{out}"
    );
    let task = fs::read_to_string(folder.path().join("task.toml")).expect("a task");
    let hung = task.replace(
        "position_m = [0.0, -0.45, 0.75]",
        "position_m = [0.0, 0.0, 1.4]",
    );
    assert_ne!(hung, task);
    fs::write(folder.path().join("task.toml"), hung).expect("a task");
    let summary = follow(folder.path(), "gantry.urdf");
    assert_eq!(summary["abandoned_nodes"], 0);
    assert_eq!(summary["faults"], 0);

    // Without the rotation, no joint direction moves the tool in yaw alone, and the tool keeps its heading.
    let yaw = r#"<joint name="yaw" type="revolute">"#;
    let rigid = GANTRY.replace(yaw, &yaw.replace("revolute", "fixed"));
    fs::write(folder.path().join("rigid.urdf"), rigid).expect("a URDF");
    let args = ["follow", "task.toml", "--robot", "rigid.urdf", "--json"];
    let (code, _, err) = wisch(folder.path(), &args);
    assert!(
        code != 2 && !err.contains("internal error"),
        "{code}: {err}"
    );
}

#[test]
fn a_robot_that_drives_is_set_up_and_wipes_with_its_first_group() {
    let folder = folder_with("chopping-board.toml");
    copy_urdf("humanoid", folder.path());
    let (code, out, err) = setup(folder.path(), &["humanoid.urdf", "--json"]);
    assert_eq!((code, err.as_str()), (0, ""));
    let record = object(&out);
    let names = record["groups"].as_array().expect("a list").iter();
    let names: Vec<&str> = names
        .map(|group| group["name"].as_str().expect("a name"))
        .collect();
    let expected = [
        "right_arm_with_torso",
        "right_arm",
        "left_arm_with_torso",
        "left_arm",
    ];
    assert_eq!(names, expected);
    // Its URDF has notes, its SRDF only that of the joints that are in no group.
    let (code, out, _) = wisch(folder.path(), &["robot", "check", "humanoid.urdf"]);
    assert_eq!(code, 0, "{out}");
    let of_srdf: Vec<&str> = (out.lines())
        .filter(|line| line.contains("humanoid.srdf:"))
        .collect();
    assert_eq!(of_srdf.len(), 1, "{out}");
    assert!(
        of_srdf[0].contains("begin with head_1 = 0 rad, head_2 = 0.175 rad ("),
        "{out}"
    );

    let followed = follow(folder.path(), "humanoid.urdf");
    assert_eq!(followed["faults"], 0);
}

/// Most URDFs of mobile robots begin at the platform, without the joints that move it.
#[test]
fn a_base_that_only_the_srdf_declares_drives() {
    let folder = folder_with("chopping-board.toml");
    let urdf = fs::read_to_string(root().join("robots/humanoid.urdf")).expect("a URDF");
    let (links, rest) = urdf.split_once("<joint name=\"base_x\"").expect("a base");
    let (_, rest) = rest
        .split_once("<joint name=\"platform_torso\"")
        .expect("a torso");
    let mut standing = format!("{links}<joint name=\"platform_torso\"{rest}");
    for link in ["world", "base_x_link", "base_y_link"] {
        standing = standing.replace(&format!("<link name=\"{link}\"/>"), "<!-- a wheel -->");
    }
    fs::write(folder.path().join("humanoid.urdf"), standing).expect("a URDF");

    let (code, out, err) = setup(folder.path(), &["humanoid.urdf", "--mobile"]);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(
        out.contains("  base         platform drives in the plane of odom\n"),
        "{out}"
    );
    assert!(out.contains("then wisch follow chopping-board"), "{out}");
    let srdf = fs::read_to_string(folder.path().join("humanoid.srdf")).expect("an SRDF");
    let declared =
        r#"<virtual_joint name="base" type="planar" parent_frame="odom" child_link="platform"/>"#;
    assert!(srdf.contains(declared), "{srdf}");

    let (_, out, _) = wisch(
        folder.path(),
        &["robot", "check", "humanoid.urdf", "--json"],
    );
    assert_eq!(
        (&object(&out)["errors"], &object(&out)["warnings"]),
        (&Value::from(0), &Value::from(0)),
        "{out}"
    );
    let followed = follow(folder.path(), "humanoid.urdf");
    assert_eq!(followed["faults"], 0);
    assert_eq!(
        followed["placements"].as_array().map(Vec::len),
        Some(1),
        "{out}"
    );

    let whole = root().join("robots/humanoid.urdf").display().to_string();
    let (code, _, err) = setup(folder.path(), &[&whole, "--mobile", "--out", "other.srdf"]);
    assert_eq!(code, 2);
    assert!(
        err.contains("the robot has a base that drives already"),
        "{err}"
    );
}

#[test]
fn the_ready_posture_fits_a_task_and_the_same_seed_gives_the_same_file() {
    let folder = folder_of("arm7");
    let out_of = |file: &str, seed: &str| {
        let args = [
            "arm7.urdf",
            "--task",
            "arm-board",
            "--out",
            file,
            "--seed",
            seed,
        ];
        let (code, out, err) = setup(folder.path(), &args);
        assert_eq!((code, err.as_str()), (0, ""));
        assert!(out.contains("over chopping_board"), "{out}");
        assert!(out.contains("fewest nodes out of reach: 0 of "), "{out}");
        fs::read_to_string(folder.path().join(file)).expect("an SRDF")
    };
    let first = out_of("a.srdf", "0");
    assert_eq!(first, out_of("b.srdf", "0"));
    assert_ne!(first, out_of("c.srdf", "1"));
    for told in [
        "seed 0",
        "manipulability",
        "Clearance",
        "10000 random postures",
    ] {
        assert!(first.contains(told), "{told}: {first}");
    }
    let check = ["robot", "check", "arm7.urdf", "--srdf", "a.srdf"];
    let (code, out, _) = wisch(folder.path(), &check);
    assert_eq!(code, 0, "{out}");
}

#[test]
fn an_existing_file_is_kept_without_force() {
    let folder = folder_of("arm6");
    fs::write(folder.path().join("arm6.srdf"), "mine").expect("a file");
    let before = contents(folder.path());
    let (code, out, err) = setup(folder.path(), &["arm6.urdf"]);
    assert_eq!((code, out.as_str()), (2, ""));
    assert!(err.contains("arm6.srdf: the file exists already"), "{err}");
    assert!(err.contains("--force"), "{err}");
    assert_eq!(contents(folder.path()), before);
    let (code, _, err) = setup(folder.path(), &["arm6.urdf", "--force", "--quiet"]);
    assert_eq!((code, err.as_str()), (0, ""));
    assert_ne!(contents(folder.path()), before);
}

#[test]
fn wrong_arguments_are_errors_and_write_nothing() {
    let folder = folder_of("arm6");
    let before = contents(folder.path());
    for (args, expected) in [
        (&["arm66.urdf"][..], "arm66.urdf: there is no such file"),
        (
            &["arm6.urdf", "--tip", "tpc"],
            "unknown link \"tpc\"; nearest: tcp",
        ),
        (
            &["arm6.urdf", "--tip", "link_0"],
            "link \"link_0\": no joint moves it",
        ),
        (
            &["arm6.urdf", "--out", "arm6.urdf"],
            "arm6.urdf: the file name of an SRDF must end in .srdf",
        ),
        (&["arm6.urdf", "--out", "no/arm6.srdf"], "no/arm6.srdf"),
        (
            &["arm6.urdf", "--task", "arm-borad"],
            "arm-borad: there is no such file",
        ),
    ] {
        let (code, out, err) = setup(folder.path(), args);
        assert_eq!((code, out.as_str()), (2, ""), "{args:?}");
        assert!(err.contains(expected), "{args:?}: {err}");
        assert_eq!(contents(folder.path()), before, "{args:?}");
    }
}

#[test]
fn a_robot_without_an_arm_gets_no_file() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let urdf = r#"<robot name="rod"><link name="wall"/><link name="rod"/>
        <joint name="pivot" type="continuous"><parent link="wall"/><child link="rod"/></joint></robot>"#;
    fs::write(folder.path().join("rod.urdf"), urdf).expect("a URDF");
    let (code, out, err) = setup(folder.path(), &["rod.urdf"]);
    assert_eq!((code, err.as_str()), (1, ""));
    assert!(out.starts_with("rod: no SRDF written\n"), "{out}");
    assert!(
        out.contains("has 1 independent joint (it ends in \"rod\"), expected at least 4"),
        "{out}"
    );
    assert!(out.contains("--tip"), "{out}");
    let (code, out, _) = setup(folder.path(), &["rod.urdf", "--json"]);
    assert_eq!(code, 1);
    assert!(object(&out)["out"].is_null());
    assert_eq!(contents(folder.path()).len(), 1);
}
