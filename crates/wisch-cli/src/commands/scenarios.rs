//! `wisch scenarios`: the shipped task files.

use crate::args::ScenariosArgs;
use crate::failure::Failure;
use crate::terminal::{Outcome, print};
use wisch::source_location::UnknownName;
use wisch_io::shipped_scenarios;

/// Lists the scenarios with their first sentences, or prints the task file of one scenario.
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
