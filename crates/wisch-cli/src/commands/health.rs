//! `wisch memory health`: drifts and sudden changes over the episodes of a memory.

use super::memory::{memory_failure, open};
use crate::args::{MemoryHealthArgs, suggest};
use crate::failure::Failure;
use crate::terminal::{Outcome, print, print_json, remark};
use std::collections::BTreeSet;
use wisch_memory::health::{
    ChannelWords, DescribedHealth, GroupWords, HealthWords, RunGroup, TrendWords, assess_groups,
    gather_groups,
};

/// Maximum number of columns of the table.
const WIDTH: usize = 100;

/// Assesses the runs of a memory and prints what was found.
pub fn health(args: &MemoryHealthArgs) -> Result<Outcome, Failure> {
    let catalogue = open(&args.memory)?.catalogue().map_err(memory_failure)?;
    for why in catalogue.omitted_episodes() {
        let verify = suggest("memory verify");
        remark(&format!("{why}: left out; {verify} lists damaged files"));
    }
    let groups = select(gather_groups(&catalogue), args)?;
    let described = DescribedHealth::from(assess_groups(&groups));
    if args.json {
        print_json(&described)?;
    } else {
        print(&lay_out(&described.words))?;
    }
    Ok(if described.report.needs_attention {
        Outcome::GoalNotMet
    } else {
        Outcome::Done
    })
}

/// Returns the groups with the requested robot, tool and surface.
fn select(groups: Vec<RunGroup>, args: &MemoryHealthArgs) -> Result<Vec<RunGroup>, Failure> {
    type NameOf = fn(&RunGroup) -> Option<&str>;
    let options: [(&str, &Option<String>, NameOf); 3] = [
        ("robot", &args.robot, |group| group.robot.as_deref()),
        ("tool", &args.tool, |group| group.tool.as_deref()),
        ("surface", &args.surface, |group| group.surface.as_deref()),
    ];
    let mut selected = groups.clone();
    for (option, asked, name_of) in options {
        let Some(asked) = asked else {
            continue;
        };
        let asked = asked.strip_prefix("semco:").unwrap_or(asked);
        let known: BTreeSet<&str> = groups.iter().filter_map(name_of).collect();
        if !known.contains(asked) {
            let known: Vec<&str> = known.into_iter().collect();
            let help = if known.is_empty() {
                format!("no episode of the memory names a {option}")
            } else {
                format!("the episodes name: {}", known.join(", "))
            };
            let error = format!("--{option} {asked:?}: no episode of the memory has this {option}");
            return Err(Failure::new(error).with_help(help));
        }
        selected.retain(|group| name_of(group) == Some(asked));
    }
    if selected.is_empty() && !groups.is_empty() {
        let error = "no episode has all of the names that --robot, --tool and --surface state";
        return Err(Failure::new(error).with_help("leave one of them out"));
    }
    Ok(selected)
}

/// Lays the words of a report out as tables.
fn lay_out(words: &HealthWords) -> String {
    let groups = words.groups.iter().map(lay_out_group);
    let mut text: String = groups.collect();
    text += &format!("{}\n", words.summary);
    for remark in &words.remarks {
        text += &wrap(0, remark);
    }
    text
}

fn lay_out_group(group: &GroupWords) -> String {
    let mut text = wrap(0, &group.things) + &wrap(2, &group.runs);
    if let Some(too_few) = &group.too_few {
        return text + &format!("  {too_few}\n\n");
    }
    text += &format!(
        "  {:<14}  {:>5}  {:>11}  {:<34}  {:>8}  finding\n",
        "channel", "runs", "now", "per run (95 % interval)", "p"
    );
    for channel in &group.channels {
        text += &lay_out_channel(channel);
    }
    text + "\n"
}

fn lay_out_channel(channel: &ChannelWords) -> String {
    let begin = format!("  {:<14}  {:>5}", channel.channel, channel.recorded);
    let finding = channel.finding.unwrap_or_default();
    let mut text = match &channel.trend {
        TrendWords::Line { now, per_run, p } => {
            format!("{begin}  {now:>11}  {per_run:<34}  {p:>8}  {finding}\n")
        }
        TrendWords::Unknown { unknown } if channel.finding.is_none() => {
            format!("{begin}  {unknown}\n")
        }
        TrendWords::Unknown { unknown } => format!("{begin}  {unknown:<57}  {finding}\n"),
    };
    for sentence in &channel.sentences {
        text += &wrap(4, sentence);
    }
    text
}

/// Breaks a sentence into lines of [`WIDTH`] columns at most, where its words allow it.
fn wrap(indent: usize, sentence: &str) -> String {
    let mut text = String::new();
    let mut column = 0;
    for word in sentence.split_whitespace() {
        let width = word.chars().count();
        if column == 0 || column + 1 + width > WIDTH {
            let is_first = text.is_empty();
            let indent = if is_first { indent } else { indent + 2 };
            text += if is_first { "" } else { "\n" };
            text += &" ".repeat(indent);
            column = indent;
        } else {
            text.push(' ');
            column += 1;
        }
        text += word;
        column += width;
    }
    text + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_broken_between_words() {
        let text = wrap(4, &"word ".repeat(60));
        assert!(text.lines().count() > 2);
        assert!(
            text.lines()
                .all(|line| line.starts_with("    word") && line.len() <= WIDTH
                    || line.starts_with("      word"))
        );
        assert_eq!(wrap(2, "a  b"), "  a b\n");
    }
}
