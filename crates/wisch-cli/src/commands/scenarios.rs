//! `wisch scenarios`: the shipped task files.

use crate::args::ScenariosArgs;
use crate::failure::Failure;
use crate::terminal::{Outcome, print, print_json, remark};
use std::path::{Path, PathBuf};
use wisch::source_location::UnknownName;
use wisch_io::{OutputFile, scenario_files, shipped_scenarios};

/// Lists the scenarios with their first sentences, or prints or writes the task file of one scenario.
pub fn scenarios(args: &ScenariosArgs) -> Result<Outcome, Failure> {
    if let Some(name) = &args.name {
        let found = shipped_scenarios().find(|(known, _)| known == name);
        let (_, text) = found.ok_or_else(|| {
            let known = shipped_scenarios().map(|(name, _)| name);
            Failure::new(UnknownName::new("scenario", name, known))
        })?;
        match &args.out {
            Some(folder) => {
                let written = write(folder, name, text)?;
                if args.json {
                    print_json(&serde_json::json!({ "name": name, "written": written }))?;
                } else {
                    let lines = written.iter().map(|path| format!("wrote {path}\n"));
                    print(&lines.collect::<String>())?;
                }
            }
            None if args.json => {
                let files: Vec<&str> = scenario_files(text).map(|(path, _)| path).collect();
                let scenario =
                    serde_json::json!({ "name": name, "task_file": text, "files": files });
                print_json(&scenario)?;
            }
            None => {
                print(text)?;
                if let Some((path, _)) = scenario_files(text).next() {
                    remark(&format!(
                        "the task needs the file {path}: wisch scenarios {name} --out FOLDER writes both"
                    ));
                }
            }
        }
        return Ok(Outcome::Done);
    }
    if args.json {
        let scenarios: Vec<_> = shipped_scenarios()
            .map(
                |(name, text)| serde_json::json!({ "name": name, "summary": first_sentence(text) }),
            )
            .collect();
        print_json(&serde_json::json!({ "scenarios": scenarios }))?;
        return Ok(Outcome::Done);
    }
    let width = shipped_scenarios().map(|(name, _)| name.len()).max();
    let width = width.unwrap_or(0);
    let list: String = shipped_scenarios()
        .map(|(name, text)| format!("{name:width$}  {}\n", first_sentence(text)))
        .collect();
    print(&list)?;
    Ok(Outcome::Done)
}

/// Writes a scenario and the files that it names to a folder, and returns their paths; existing files stay.
fn write(folder: &Path, name: &str, text: &str) -> Result<Vec<String>, Failure> {
    let task = (format!("{name}.toml"), text.as_bytes());
    let named = scenario_files(text).map(|(path, contents)| (path.to_owned(), contents));
    let files: Vec<(PathBuf, &[u8])> = std::iter::once(task)
        .chain(named)
        .map(|(path, contents)| (folder.join(path), contents))
        .collect();
    if let Some((path, _)) = files.iter().find(|(path, _)| path.exists()) {
        return Err(Failure::new("the file exists already")
            .within(path)
            .with_help("choose another folder with --out"));
    }
    let mut written = Vec::new();
    for (path, contents) in files {
        let parent = path.parent().unwrap_or(folder);
        std::fs::create_dir_all(parent)
            .map_err(|error| Failure::new(format!("cannot write there: {error}")).within(&path))?;
        OutputFile::begin(&path)?.finish(contents)?;
        written.push(path.display().to_string());
    }
    Ok(written)
}

/// Returns the first sentence of a file's leading comment, without text in brackets.
fn first_sentence(text: &str) -> String {
    let comment: Vec<&str> = text
        .lines()
        .map_while(|line| line.strip_prefix('#'))
        .map(str::trim)
        .collect();
    let mut sentence = comment.join(" ");
    while let (Some(start), Some(end)) = (sentence.find(" ("), sentence.find(')')) {
        if start >= end {
            break;
        }
        sentence.replace_range(start..=end, "");
    }
    // The decimal point of 0.1 does not end a sentence.
    let ends = |(i, c): &(usize, char)| match c {
        '.' => !sentence[i + 1..].starts_with(|c: char| !c.is_whitespace()),
        c => *c == ';',
    };
    let end = sentence.char_indices().find(ends);
    let end = end.map_or(sentence.len(), |(i, _)| i);
    sentence.truncate(end);
    sentence
}

#[cfg(test)]
mod tests {
    use super::first_sentence;

    #[test]
    fn a_number_ends_no_sentence() {
        let text = "# Painted: 0.1 mm everywhere (in\n# lanes). World: z up.\nname = \"x\"";
        assert_eq!(first_sentence(text), "Painted: 0.1 mm everywhere");
        assert_eq!(first_sentence("# All of it; and more"), "All of it");
        assert_eq!(first_sentence("# The end."), "The end");
    }
}
