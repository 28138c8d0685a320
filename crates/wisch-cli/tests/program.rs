//! The program `wisch`, as its tests run it, and folders for it.

use assert_cmd::Command;
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// Where the program is.
pub fn path() -> PathBuf {
    assert_cmd::cargo::cargo_bin!("wisch").to_path_buf()
}

/// The program in a folder.
pub fn command(folder: &Path) -> Command {
    let mut command = Command::new(path());
    command.current_dir(folder).env_remove("NO_COLOR");
    command
}

/// Exit code, standard output and standard error.
pub fn wisch(folder: &Path, args: &[&str]) -> (i32, String, String) {
    ended(command(folder).args(args))
}

/// The same, of a command that is ready.
pub fn ended(command: &mut Command) -> (i32, String, String) {
    let output = command.output().expect("it runs");
    (
        output.status.code().expect("it ends by itself"),
        String::from_utf8(output.stdout).expect("text"),
        String::from_utf8(output.stderr).expect("text"),
    )
}

/// The repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// A folder with a scenario as task.toml.
pub fn folder_with(scenario: &str) -> TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let from = root().join("scenarios").join(scenario);
    fs::copy(from, folder.path().join("task.toml")).expect("a task");
    folder
}

/// Every file of a folder and its rooms with its bytes, by path.
pub fn contents(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut contents = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path
            .file_name()
            .expect("a name")
            .to_string_lossy()
            .into_owned();
        if path.is_dir() {
            let inner = self::contents(&path).into_iter();
            contents.extend(inner.map(|(inner, bytes)| (format!("{name}/{inner}"), bytes)));
        } else {
            contents.push((name, fs::read(&path).expect("a file")));
        }
    }
    contents.sort();
    contents
}
