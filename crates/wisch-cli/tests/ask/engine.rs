//! Where `wisch ask` finds its engine. The engines are scripts, which say that every query holds.

use super::{memory, program, run};
use assert_cmd::Command;
use std::fs;
use std::path::{Path, PathBuf};
use std::process;
use tempfile::TempDir;

/// What speaks as an engine does.
const ENGINE: &str = "#!/bin/sh
read -r query
echo 'names([]).'
echo 'rows([row]).'
echo 'done(all).'
";
const INSTALL: &str = "cargo install --path crates/wisch-prolog --locked";

/// A folder with a copy of the program in `at`, a memory, and an empty folder that is all of `PATH`.
struct Place {
    folder: TempDir,
    program: PathBuf,
}

impl Place {
    fn new(at: &str) -> Self {
        let folder = memory();
        let place = folder.path().join(at);
        fs::create_dir_all(&place).unwrap();
        fs::create_dir(folder.path().join("path")).unwrap();
        // By a process of its own: what this one holds open for writing, one that another test starts at that moment
        // holds open too, and then it cannot be run.
        let copied = process::Command::new("cp")
            .args([program().as_path(), &place.join("wisch")])
            .status();
        assert!(copied.unwrap().success());
        Self {
            program: place.join("wisch"),
            folder,
        }
    }

    fn script(&self, file: &str, text: &str) {
        let written = process::Command::new("sh")
            .args([
                "-c",
                "printf %s \"$1\" > \"$0\" && chmod 755 \"$0\"",
                file,
                text,
            ])
            .current_dir(self.folder.path())
            .status();
        assert!(written.unwrap().success());
    }

    /// Asks whether truth holds.
    fn ask(&self, args: &[&str]) -> (i32, String, String) {
        let folder = self.folder.path();
        let mut command = Command::new(&self.program);
        command.current_dir(folder).args(["ask", "true"]).args(args);
        command.env("PATH", folder.join("path"));
        run(command.env("CARGO", Path::new("path/cargo")))
    }
}

#[test]
fn without_an_engine_it_is_said_what_installs_one() {
    let place = Place::new("bin");
    let (code, out, err) = place.ask(&[]);
    assert_eq!((code, out.as_str()), (2, ""));
    assert!(
        err.contains("wisch-prolog") && err.contains(INSTALL),
        "{err}"
    );
    let (code, _, err) = place.ask(&["--engine", "swi"]);
    assert_eq!(code, 2);
    assert!(err.contains("swipl"), "{err}");
}

#[test]
fn the_json_of_an_answer_states_the_episodes_that_are_left_out() {
    let place = Place::new("bin");
    place.script("bin/wisch-prolog", ENGINE);
    let damaged = place.folder.path().join("episodes/damaged");
    fs::create_dir(&damaged).unwrap();
    fs::write(damaged.join("episode.json"), "").unwrap();
    let (code, out, _) = place.ask(&["--json", "--quiet"]);
    assert_eq!(code, 0, "{out}");
    let answers: serde_json::Value = serde_json::from_str(&out).unwrap();
    let remark = answers["remarks"][0].as_str().expect("a remark");
    assert!(
        remark.contains("episode damaged: ") && remark.contains("left out"),
        "{remark}"
    );
}

#[test]
fn an_engine_beside_the_program_or_in_the_path_answers() {
    for file in ["bin/wisch-prolog", "path/wisch-prolog"] {
        let place = Place::new("bin");
        place.script(file, ENGINE);
        let answer = (0, "true\n".to_owned(), String::new());
        assert_eq!(place.ask(&[]), answer, "{file}");
        assert_eq!(place.ask(&["--engine", "scryer"]), answer, "{file}");
    }
}

#[test]
fn swi_prolog_answers_where_there_is_no_other() {
    let place = Place::new("bin");
    place.script("path/swipl", ENGINE);
    let (code, out, err) = place.ask(&[]);
    assert_eq!((code, out.as_str()), (0, "true\n"), "{err}");
    assert!(
        err.starts_with("note: using SWI-Prolog") && err.contains(INSTALL),
        "{err}"
    );
    let (code, out, err) = place.ask(&["--engine", "swi"]);
    assert_eq!((code, out.as_str(), err.as_str()), (0, "true\n", ""));
    let (code, _, err) = place.ask(&["--engine", "scryer"]);
    assert_eq!(code, 2, "what is asked for is not replaced");
    assert!(err.contains(INSTALL), "{err}");
}

#[test]
fn in_a_checkout_the_engine_is_built_once() {
    for (profile, flag) in [("release", "--release"), ("debug", "")] {
        let place = Place::new(&format!("target/{profile}"));
        let folder = place.folder.path();
        fs::create_dir_all(folder.join("crates/wisch-prolog")).unwrap();
        fs::write(folder.join("crates/wisch-prolog/Cargo.toml"), "").unwrap();
        // Cargo, as far as this goes: the arguments are kept, and the program appears.
        let cargo = format!(
            "#!/bin/sh\necho \"$@\" >> asked\n/bin/cp path/engine target/{profile}/wisch-prolog\n"
        );
        place.script("path/cargo", &cargo);
        place.script("path/engine", ENGINE);
        place.script("path/swipl", ENGINE);
        let (code, out, err) = place.ask(&[]);
        assert_eq!((code, out.as_str()), (0, "true\n"), "{err}");
        assert!(
            err.starts_with("note: building the Prolog engine; this happens once"),
            "{err}"
        );
        let (code, _, err) = place.ask(&[]);
        assert_eq!((code, err.as_str()), (0, ""), "it is there now");
        let asked = fs::read_to_string(folder.join("asked")).unwrap();
        assert_eq!(asked.lines().count(), 1, "{asked}");
        assert!(
            asked.starts_with("build --locked --package wisch-prolog"),
            "{asked}"
        );
        assert_eq!(
            asked.trim().ends_with("--release"),
            !flag.is_empty(),
            "{asked}"
        );
    }
}

#[test]
fn an_engine_that_cannot_be_built_is_an_error() {
    let place = Place::new("target/release");
    let folder = place.folder.path();
    fs::create_dir_all(folder.join("crates/wisch-prolog")).unwrap();
    fs::write(folder.join("crates/wisch-prolog/Cargo.toml"), "").unwrap();
    place.script("path/cargo", "#!/bin/sh\nexit 101\n");
    let (code, out, err) = place.ask(&["--quiet"]);
    assert_eq!((code, out.as_str()), (2, ""));
    assert!(
        err.starts_with("error: ") && err.contains("101") && err.contains(INSTALL),
        "{err}"
    );
}
