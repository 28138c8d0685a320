//! What concerns a fleet is done by a program of its own, for which a script stands in here: it says what it was asked for.

use crate::program::{command, ended, path, wisch};
use std::env::{join_paths, split_paths, var_os};
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;

/// Writes its arguments down, and begins a memory where it is to pull to; its exit code is in CODE.
const SCRIPT: &str = r#"#!/bin/sh
echo "$@" >>asked
[ "$1" = pull ] && mkdir -p "$3"
echo '{"selected": 2, "of": 9, "episodes": 1, "bytes": 2500000, "left_out": ["episode x: cut off"]}'
exit "${CODE:-0}"
"#;

/// The program in a folder, with the script in place of `wisch-fleet`; `None` where that was built beside it.
fn with_script(folder: &Path) -> Option<assert_cmd::Command> {
    if path().with_file_name("wisch-fleet").exists() {
        return None;
    }
    let bin = folder.join("bin");
    fs::create_dir_all(&bin).unwrap();
    fs::write(bin.join("wisch-fleet"), SCRIPT).unwrap();
    let executable = fs::Permissions::from_mode(0o755);
    fs::set_permissions(bin.join("wisch-fleet"), executable).unwrap();
    let paths = var_os("PATH").unwrap_or_default();
    let paths = join_paths([bin].into_iter().chain(split_paths(&paths))).unwrap();
    let mut program = command(folder);
    program.env("PATH", paths);
    Some(program)
}

#[test]
fn what_is_pushed_and_pulled_is_handed_over() {
    let folder = tempfile::tempdir().unwrap();
    let rows: [(&[&str], &str); 3] = [
        (
            &[
                "memory",
                "push",
                "s3://robots/fleet",
                "--robot",
                "kitchen-7",
            ],
            "push episodes s3://robots/fleet --robot kitchen-7",
        ),
        (
            &[
                "memory",
                "pull",
                "/mnt/fleet",
                "--memory",
                "mine",
                "--since",
                "2026-11-01",
                "--json",
            ],
            "pull /mnt/fleet mine --since 2026-11-01 --json",
        ),
        (
            &[
                "memory",
                "pull",
                "f",
                "--class",
                "Stroke",
                "--class",
                "StickSlip",
                "--where",
                "a < 1",
            ],
            "pull f episodes --class Stroke --class StickSlip --where a < 1",
        ),
    ];
    for (args, asked) in rows {
        let Some(mut program) = with_script(folder.path()) else {
            return;
        };
        let (code, out, err) = ended(program.args(args));
        assert_eq!((code, err.as_str()), (0, ""), "{args:?}");
        assert!(out.contains("selected"), "{out}");
        let said = fs::read_to_string(folder.path().join("asked")).unwrap();
        assert_eq!(said.lines().last(), Some(asked));
    }
}

#[test]
fn what_a_fleet_refuses_ends_the_program() {
    let folder = tempfile::tempdir().unwrap();
    for (code, expected) in [("1", 1), ("2", 2)] {
        let Some(mut program) = with_script(folder.path()) else {
            return;
        };
        let (found, _, err) = ended(program.env("CODE", code).args(["memory", "push", "f"]));
        assert_eq!(found, expected, "{err}");
        assert_eq!(err.contains("wisch-fleet ended"), code == "2", "{err}");
    }
}

#[test]
fn a_fleet_is_asked_for_what_is_selected() {
    let folder = tempfile::tempdir().unwrap();
    let Some(mut program) = with_script(folder.path()) else {
        return;
    };
    let args = [
        "ask", "--fleet", "f", "--robot", "arm", "--memory", "mine", "--engine", "swi", "true",
    ];
    // An episode that is left out is no reason to answer nothing.
    let (_, _, err) = ended(program.env("CODE", "1").args(args));
    assert!(
        err.contains("2 of 9 episodes of f are selected; 1 were pulled now (2.5 MB)"),
        "{err}"
    );
    assert!(
        err.contains("1 of the selected episodes cannot be read"),
        "{err}"
    );
    assert!(!err.contains("wisch-fleet ended"), "{err}");
    let said = fs::read_to_string(folder.path().join("asked")).unwrap();
    assert_eq!(said, "pull f mine --robot arm --json\n");
}

#[test]
fn episodes_are_selected_of_a_fleet_only() {
    let folder = tempfile::tempdir().unwrap();
    let (code, _, err) = wisch(folder.path(), &["ask", "--since", "2026-11-01", "true"]);
    assert_eq!(code, 2);
    assert!(
        err.contains("options that select episodes need --fleet") && err.contains("--fleet"),
        "{err}"
    );
}
