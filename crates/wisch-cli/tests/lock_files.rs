//! Every lock file of the repository is held against `deny.toml`.

use crate::program::root;
use std::fs;

#[test]
fn every_lock_file_is_checked() {
    let crates = fs::read_dir(root().join("crates")).expect("crates");
    let crates = crates.map(|entry| entry.expect("an entry").file_name());
    let crates = crates.map(|name| format!("crates/{}/", name.to_string_lossy()));
    let folders = crates.chain([String::new(), "fuzz/".to_owned()]);
    let locked: Vec<String> = folders
        .filter(|folder| root().join(folder).join("Cargo.lock").is_file())
        .map(|folder| format!("{folder}Cargo.toml"))
        .collect();
    assert!(locked.len() >= 4, "{locked:?}");
    let checks = fs::read_to_string(root().join(".ci/run")).expect("text");
    let listed = checks
        .lines()
        .find_map(|line| line.strip_prefix("manifests=("));
    let listed = listed.expect("a list").trim_end_matches(')');
    let listed: Vec<&str> = listed.split(' ').collect();
    for manifest in &locked {
        assert!(
            listed.contains(&manifest.as_str()),
            "{manifest} is not in .ci/run"
        );
    }
}
