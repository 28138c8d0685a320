//! Shipped tasks, as the program lists them.

use serde::{Deserialize, Serialize};
use std::path::Path;
use std::process::{Command, Stdio};

/// A shipped task.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Scenario {
    /// Name, as an argument of `wisch run`.
    pub name: String,
    /// Description in one sentence.
    #[serde(default)]
    pub about: String,
}

/// Reads the tasks from a JSON file.
pub fn read(file: &Path) -> Result<Vec<Scenario>, String> {
    let text =
        std::fs::read_to_string(file).map_err(|error| format!("{}: {error}", file.display()))?;
    serde_json::from_str(&text).map_err(|error| format!("{}: {error}", file.display()))
}

/// Returns the tasks that `wisch scenarios` lists; none if it cannot be called.
pub fn listed_by(wisch: &Path) -> Vec<Scenario> {
    let mut command = Command::new(wisch);
    command.arg("scenarios");
    let output = command.stdin(Stdio::null()).stderr(Stdio::null()).output();
    let text = output.map(|output| output.stdout).unwrap_or_default();
    parse(&String::from_utf8_lossy(&text))
}

/// Parses lines with a name, at least two spaces and a sentence.
fn parse(text: &str) -> Vec<Scenario> {
    let lines = text.lines().filter_map(|line| line.split_once("  "));
    lines
        .map(|(name, about)| Scenario {
            name: name.trim().to_owned(),
            about: about.trim().to_owned(),
        })
        .filter(|scenario| !scenario.name.is_empty())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_is_parsed() {
        let found = parse("table       Crumbs on a table\nlong-name   With  spaces\n\nnothing\n");
        let names: Vec<&str> = found.iter().map(|one| one.name.as_str()).collect();
        assert_eq!(names, ["table", "long-name"]);
        assert_eq!(found[1].about, "With  spaces");
    }
}
