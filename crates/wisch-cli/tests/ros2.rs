//! Robots that speak ROS 2 are another program's task, for which a script stands in here: it writes down its arguments.

use crate::program::{command, ended, path, wisch};
use std::env::{join_paths, split_paths, var_os};
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;

/// Writes its arguments down. As an executor, it refuses its robot.
const SCRIPT: &str = r#"#!/bin/sh
echo "$@" >>asked
[ "$1" = execute ] && echo '{"error": "the speed scaling is 0: the robot is paused"}'
exit "${CODE:-0}"
"#;

/// The program in a folder, with the script in place of `wisch-ros2`; `None` where that was built beside it.
fn with_script(folder: &Path) -> Option<assert_cmd::Command> {
    if path().with_file_name("wisch-ros2").exists() {
        return None;
    }
    let bin = folder.join("bin");
    fs::create_dir_all(&bin).unwrap();
    let script = bin.join("wisch-ros2");
    fs::write(&script, SCRIPT).unwrap();
    fs::set_permissions(&script, fs::Permissions::from_mode(0o755)).unwrap();
    let paths = var_os("PATH").unwrap_or_default();
    let paths = join_paths([bin].into_iter().chain(split_paths(&paths))).unwrap();
    let mut program = command(folder);
    program.env("PATH", paths);
    Some(program)
}

/// The arguments of the last start of the script.
fn last_asked(folder: &Path) -> String {
    let asked = fs::read_to_string(folder.join("asked")).unwrap();
    asked.lines().last().unwrap_or_default().to_owned()
}

#[test]
fn commands_about_a_robot_pass_their_arguments_and_exit_codes_on() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let rows: [(&[&str], &str); 3] = [
        (&["robot", "doctor", "ur.toml"], "doctor ur.toml"),
        (
            &["robot", "push-test", "ur.toml", "--yes"],
            "push-test ur.toml --yes",
        ),
        (
            &[
                "robot",
                "fake",
                "arm-board",
                "--as",
                "ur.toml",
                "--set",
                "a=1",
                "--seed",
                "7",
            ],
            "fake arm-board --as ur.toml --set a=1 --seed 7",
        ),
    ];
    for (args, asked) in rows {
        for code in [0, 1, 2] {
            let Some(mut program) = with_script(folder) else {
                return;
            };
            let (found, _, err) = ended(program.env("CODE", code.to_string()).args(args));
            assert_eq!(found, code, "{err}");
            assert_eq!(err.contains("wisch-ros2 ended"), code == 2, "{err}");
            assert_eq!(last_asked(folder), asked);
        }
    }
}

#[test]
fn a_robot_that_is_refused_ends_the_run_with_its_reason() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let run = [
        "run",
        "arm-board",
        "--no-memory",
        "--on",
        "ur.toml",
        "--yes-every-round",
    ];
    let rows: [(&[&str], &str); 2] = [
        (&[], "execute ur.toml --speed 1"),
        (
            &["--speed", "0.25", "--air", "0.05"],
            "execute ur.toml --speed 0.25 --air",
        ),
    ];
    for (more, asked) in rows {
        let Some(mut program) = with_script(folder) else {
            return;
        };
        let (code, _, err) = ended(program.args(run).args(more));
        assert_eq!(code, 2, "{err}");
        assert!(err.contains("the speed scaling is 0"), "{err}");
        assert_eq!(last_asked(folder), asked);
    }
}

#[test]
fn a_robot_moves_only_after_a_question_unless_that_is_waived() {
    let folder = tempfile::tempdir().unwrap();
    let args = ["run", "arm-board", "--no-memory", "--on", "ur.toml"];
    let (code, _, err) = wisch(folder.path(), &args);
    assert_eq!(code, 2, "{err}");
    assert!(err.contains("standard input is not a terminal"), "{err}");
    assert!(err.contains("--yes-every-round"), "{err}");
}

#[test]
fn options_of_a_robot_have_limits_and_need_it() {
    let folder = tempfile::tempdir().unwrap();
    for (args, part) in [
        (
            &["--on", "a", "--speed", "1.5"][..],
            "above 0 and at most 1",
        ),
        (&["--on", "a", "--air", "2"], "0.005 to 0.5 m"),
        (&["--on", "a", "--executor", "b"], "cannot be used with"),
        (
            &["--on", "a", "--robot", "none", "--yes-every-round"],
            "--on needs a robot",
        ),
        (&["--air", "0.05"], "--on"),
    ] {
        let (code, _, err) = wisch(folder.path(), &[&["run", "arm-board"], args].concat());
        assert_eq!(code, 2, "{args:?}: {err}");
        assert!(err.contains(part), "{args:?}: {err}");
    }
}
