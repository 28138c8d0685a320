//! The default folder of results.

use crate::args::ResultArgs;
use std::path::{Path, PathBuf};

/// Longest name of a folder that is derived from a task's [characters]; file systems take 255 bytes.
const MAX_NAME_LEN: usize = 60;

/// Returns the folder of `--out`, or by default `out/TASK` of a task with the suffix `done`, which names the command's last stage.
pub(super) fn out_folder(results: &ResultArgs, task: &str, done: &str) -> PathBuf {
    results.out.clone().unwrap_or_else(|| {
        let name = folder_name(task);
        Path::new("out").join(format!("{name}{done}"))
    })
}

/// Returns a task's name as a folder name: characters that are unsafe in paths become dashes.
pub(super) fn folder_name(task: &str) -> String {
    let plain = |c: char| {
        if c.is_alphanumeric() || "-_.".contains(c) {
            c
        } else {
            '-'
        }
    };
    let name: String = task.chars().map(plain).take(MAX_NAME_LEN).collect();
    match name.trim_start_matches('.') {
        "" => "task".to_owned(),
        name => name.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_cannot_lead_out_of_the_folder() {
        assert_eq!(folder_name("chopping-board"), "chopping-board");
        assert_eq!(folder_name("../../etc"), "-..-etc");
        assert_eq!(folder_name(".."), "task");
        assert_eq!(folder_name("my board/2"), "my-board-2");
    }
}
