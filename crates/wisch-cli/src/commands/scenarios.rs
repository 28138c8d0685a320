//! `wisch scenarios`: the shipped task files.

use crate::args::ScenariosArgs;
use crate::failure::Failure;
use crate::terminal::{Outcome, print};
use wisch::source_location::UnknownName;
use wisch_io::shipped_scenarios;

/// Lists the scenarios with the sentence that each begins with, or prints one.
pub fn scenarios(args: &ScenariosArgs) -> Result<Outcome, Failure> {
    if let Some(name) = &args.name {
        let found = shipped_scenarios().find(|(known, _)| known == name);
        let (_, text) = found.ok_or_else(|| {
            let known = shipped_scenarios().map(|(name, _)| name);
            Failure::new(UnknownName::new("scenario", name, known))
        })?;
        print(text)?;
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

/// The first sentence of the comment that a file begins with, without what it has in brackets.
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
    let end = sentence.find(['.', ';']).unwrap_or(sentence.len());
    sentence.truncate(end);
    sentence
}
