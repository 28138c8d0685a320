//! Wrong robots, wrong places for them, and wrong maps.

use super::{Case, line, task};

/// A run of the template with a robot's file beside it.
fn robot(name: &'static str, file: &'static str, text: &str, says: &[&'static str]) -> Case {
    Case {
        files: vec![(file, text.as_bytes().to_vec())],
        ..line(name, &["run", "task.toml", "--robot", "arm.urdf"], says)
    }
}

/// A run of the template with one setting of its robot.
fn setting(name: &'static str, setting: &'static str, says: &[&'static str]) -> Case {
    line(name, &["run", "task.toml", "--set", setting], says)
}

/// `robot map` of the shipped arm with one more option and its value.
fn map(
    name: &'static str,
    option: &'static str,
    value: &'static str,
    says: &[&'static str],
) -> Case {
    // Coarse, in case it is taken for right.
    let args = ["robot", "map", "arm6", "--voxel-m", "1", "--samples", "9"];
    let at = args.iter().position(|arg| *arg == option);
    let mut args = args.to_vec();
    match at {
        Some(at) => args[at + 1] = value,
        None => args.extend([option, value]),
    }
    line(name, &args, says)
}

const HUMANOID_MAP: &[u8] = include_bytes!("../../../../robots/humanoid.reach");
const ARM_URDF: &str = include_str!("../../../../robots/arm6.urdf");

/// Robots, their files and their maps.
pub fn cases() -> Vec<Case> {
    let broken_srdf = |name, text: &str, says: &[&'static str]| {
        let srdf = ("arm.srdf", text.as_bytes().to_vec());
        let mut case = robot(name, "arm.urdf", ARM_URDF, says);
        case.files.push(srdf);
        case
    };
    vec![
        line(
            "a robot of no name",
            &["run", "task.toml", "--robot", "arm77"],
            &["unknown robot \"arm77\"", "nearest: arm7", "ends in .urdf"],
        ),
        setting(
            "a robot of no name in the task",
            "robot.name=humanoit",
            &[
                "task.toml",
                "unknown robot \"humanoit\"",
                "nearest: humanoid",
            ],
        ),
        setting(
            "a path as the name of a robot",
            "robot.name=robots/arm7.urdf",
            &["in [robot], write urdf = \"robots/arm7.urdf\" instead of name"],
        ),
        task(
            "the same in a check",
            "name = \"humanoid\"",
            "name = \"humanoit\"",
            &["unknown robot \"humanoit\"", "nearest: humanoid"],
        ),
        robot(
            "a URDF that is not there",
            "arn.urdf",
            "",
            &["arm.urdf: there is no such file", "did you mean arn.urdf?"],
        ),
        task(
            "a URDF of the task that is not there",
            "name = \"humanoid\"",
            "urdf = \"robots/none.urdf\"",
            &["robots/none.urdf: there is no such file"],
        ),
        task(
            "a robot by name and by file",
            "name = \"humanoid\"",
            "name = \"humanoid\"\nurdf = \"arm.urdf\"",
            &["robot: exactly one of name, urdf"],
        ),
        task(
            "an SRDF without a URDF",
            "name = \"humanoid\"",
            "name = \"humanoid\"\nsrdf = \"arm.srdf\"",
            &["srdf needs urdf"],
        ),
        line(
            "a folder for a robot",
            &["run", "task.toml", "--robot", "./knowledge"],
            &["knowledge: this is a folder, not a file"],
        ),
        robot(
            "an empty URDF",
            "arm.urdf",
            "",
            &["arm.urdf", "wisch robot check"],
        ),
        robot(
            "a URDF cut short",
            "arm.urdf",
            &ARM_URDF[..1000],
            &["arm.urdf:", "wisch robot check"],
        ),
        broken_srdf("an empty SRDF", "", &["arm.srdf"]),
        broken_srdf(
            "an SRDF of another robot",
            "<robot name=\"arm6\"><group name=\"arm\"><chain base_link=\"link_0\" tip_link=\"tpc\"/></group></robot>",
            &["arm.srdf:1:", "\"tpc\"", "nearest: tcp"],
        ),
        line(
            "a group of no name",
            &["run", "task.toml", "--group", "rigth_arm"],
            &[
                "task.toml: unknown group \"rigth_arm\"",
                "nearest: right_arm",
                "SRDF",
            ],
        ),
        setting(
            "a humanoid that floats",
            "robot.position_m=[0, -1.1, 0.1]",
            &["task.toml: robot: z_m is 0.1", "only x, y and yaw are free"],
        ),
        setting(
            "a humanoid that leans",
            "robot.rpy_rad=[0.2, 0, 0]",
            &[
                "task.toml: robot: roll_rad is 0.2",
                "only x, y and yaw are free",
            ],
        ),
        setting(
            "NaN in the robot's place",
            "robot.position_m=[0, nan, 0]",
            &["robot.position_m[1] = NaN is outside its limits"],
        ),
        setting(
            "a robot in the board",
            "robot.position_m=[0, -0.2, 0]",
            &[
                "task.toml: the robot cannot start",
                "\"board\"",
                "expected at least 0.005 m",
            ],
        ),
        Case {
            args: vec![
                "check",
                "task.toml",
                "--set",
                "robot.position_m=[0, -0.2, 0]",
            ],
            ..task(
                "the same in a check of the task",
                "",
                "",
                &["the robot cannot start", "\"board\""],
            )
        },
        line(
            "a map without a robot",
            &["run", "task.toml", "--robot", "none", "--map", "arm.reach"],
            &["--map: needs a robot"],
        ),
        line(
            "a map that is not there",
            &["run", "task.toml", "--map", "none.reach"],
            &["none.reach: there is no such file"],
        ),
        line(
            "a folder for a map",
            &["run", "task.toml", "--map", "knowledge"],
            &["knowledge: this is a folder"],
        ),
        Case {
            files: vec![("arm.reach", b"hello".to_vec())],
            ..line(
                "a map that is none",
                &["run", "task.toml", "--map", "arm.reach"],
                &["arm.reach: no capability map", "wisch robot map"],
            )
        },
        Case {
            files: vec![("arm.reach", HUMANOID_MAP[..HUMANOID_MAP.len() / 2].to_vec())],
            ..line(
                "half a map",
                &["run", "task.toml", "--map", "arm.reach"],
                &["arm.reach: no capability map", "cut short"],
            )
        },
        Case {
            files: vec![("arm.reach", HUMANOID_MAP.to_vec())],
            ..line(
                "a map of another robot",
                &["run", "task.toml", "--robot", "arm6", "--map", "arm.reach"],
                &[
                    "arm.reach: capability map of another robot",
                    "wisch robot map",
                ],
            )
        },
        map(
            "voxels of no size",
            "--voxel-m",
            "0",
            &["--voxel-m 0 is outside its limits: at least 0.001 and at most 10"],
        ),
        map(
            "voxels below no size",
            "--voxel-m",
            "-1",
            &["--voxel-m -1 is outside its limits: at least 0.001 and at most 10"],
        ),
        map(
            "voxels of NaN",
            "--voxel-m",
            "nan",
            &["--voxel-m NaN is outside"],
        ),
        map("voxels beyond memory", "--voxel-m", "0.001", &["voxel"]),
        map(
            "no samples",
            "--samples",
            "0",
            &["map.samples: 0 is outside 1 to 1000000000000"],
        ),
        map(
            "samples without end",
            "--samples",
            "99999999999999",
            &["map.samples: 99999999999999 is outside"],
        ),
        map(
            "a map of no group",
            "--group",
            "leg",
            &["arm6: unknown group \"leg\"", "known: arm"],
        ),
        map(
            "a map over a task",
            "--out",
            "task.toml",
            &["task.toml: the file name of a capability map must end in .reach"],
        ),
        map(
            "a map below nothing",
            "--out",
            "no/arm.reach",
            &["no/arm.reach: cannot write there"],
        ),
        line(
            "a map of no robot",
            &["robot", "map", "arm66"],
            &["unknown robot \"arm66\"", "nearest: arm6"],
        ),
        line(
            "a map of a folder",
            &["robot", "map", "./knowledge"],
            &["knowledge: this is a folder"],
        ),
    ]
}
