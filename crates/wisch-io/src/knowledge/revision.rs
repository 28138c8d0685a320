//! Revisions of knowledge files with learned interactions, as text and as a diff.

use super::parse_knowledge;
use crate::error::Error;
use serde::Deserialize;
use std::collections::BTreeSet;
use std::path::Path;
use wisch::represent::{Interaction, LogNormal};

/// A learned interaction, with which an entry of the knowledge base is revised.
#[derive(Debug, Clone, PartialEq)]
pub struct InteractionRevision {
    /// The interaction with the new values of μ, σ and the redraw length ℓ, and their spreads; its
    /// other values are unchanged.
    pub interaction: Interaction,
    /// Source of the new values, one sentence per line.
    pub source: Vec<String>,
    /// Digests of the rounds from which the new values were learned; the entry keeps them beside those of earlier revisions.
    pub rounds: Vec<String>,
}

/// A knowledge file before and after a revision.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RevisedFile {
    /// Its name within the folder.
    pub name: String,
    /// Text before.
    pub before: String,
    /// Text after.
    pub after: String,
    /// The changed entries.
    entries: Vec<String>,
}

/// Prefix of comment lines that the next revision replaces.
const LEARNED: &str = "# learned: ";
/// Prefix of comment lines with the digests of rounds, which revisions add and never replace.
const LEARNED_ROUNDS: &str = "# learned: rounds ";
/// Number of digests in a line.
const ROUNDS_PER_LINE: usize = 6;
/// First line of an entry.
const HEADER: &str = "[[interaction]]";
/// Number of context lines in a diff.
const CONTEXT: usize = 3;
/// Number of changed lines above which a diff shows them as one block.
const MOST_COMPARED: usize = 4000;

/// The keys that identify an entry.
#[derive(Deserialize)]
struct Names {
    interaction: Vec<NamesOfOne>,
}

#[derive(Deserialize)]
struct NamesOfOne {
    tool: String,
    medium: String,
    surface: String,
}

/// Returns the digests of the rounds from which entries of knowledge files were learned.
pub(crate) fn list_learned_rounds(files: &[(String, String)]) -> BTreeSet<String> {
    let lines = files.iter().flat_map(|(_, text)| text.lines());
    let rounds = lines.filter_map(|line| line.trim_start().strip_prefix(LEARNED_ROUNDS));
    let digests = rounds.flat_map(str::split_whitespace);
    digests.map(str::to_owned).collect()
}

/// Applies revisions to knowledge files (name and text), and returns the changed files.
///
/// # Errors
/// If no file has an interaction as a table `[[interaction]]`, or a revised file would be invalid.
pub(crate) fn revise_knowledge(
    files: &[(String, String)],
    revisions: &[InteractionRevision],
) -> Result<Vec<RevisedFile>, Error> {
    let mut found = vec![false; revisions.len()];
    let mut changed = Vec::new();
    for (name, text) in files {
        let mut lines: Vec<String> = Vec::new();
        let mut entries = Vec::new();
        for block in blocks(text) {
            let names = names(&block);
            let which = revisions.iter().position(|revision| {
                let Interaction {
                    tool,
                    medium,
                    surface,
                    ..
                } = &revision.interaction;
                let is_it = |names: &NamesOfOne| {
                    (&names.tool, &names.medium) == (tool, medium)
                        && names.surface == surface.to_string()
                };
                names.as_ref().is_some_and(is_it)
            });
            match which {
                Some(index) => {
                    found[index] = true;
                    let block = with_revision(&block, &revisions[index]);
                    entries.push(block.join("\n").trim_end().to_owned() + "\n");
                    lines.extend(block);
                }
                None => lines.extend(block.into_iter().map(str::to_owned)),
            }
        }
        if !entries.is_empty() {
            let mut after = lines.join("\n");
            if text.ends_with('\n') {
                after.push('\n');
            }
            changed.push(RevisedFile {
                name: name.clone(),
                before: text.clone(),
                after,
                entries,
            });
        }
    }
    if let Some(missing) = found.iter().position(|found| !found) {
        let Interaction {
            tool,
            medium,
            surface,
            ..
        } = &revisions[missing].interaction;
        return Err(Error::Unusable {
            path: Path::new(files.first().map_or("", |(name, _)| name)).to_owned(),
            problem: format!(
                "no table {HEADER} has tool = {tool:?}, medium = {medium:?} and surface = \"{surface}\""
            ),
        });
    }
    let texts: Vec<(&str, &str)> = (files.iter())
        .map(|(name, text)| {
            let revised = changed.iter().find(|file| file.name == *name);
            (
                name.as_str(),
                revised.map_or(text.as_str(), |file| &file.after),
            )
        })
        .collect();
    parse_knowledge(&texts)?;
    Ok(changed)
}

impl RevisedFile {
    /// The changed entries alone, as TOML.
    pub fn entries(&self) -> &[String] {
        &self.entries
    }

    /// Returns the changes in the format of `diff -u`; `patch -p1` in the knowledge folder applies them.
    pub fn diff(&self) -> String {
        let name = Path::new(&self.name).file_name().unwrap_or_default();
        let name = name.to_string_lossy();
        let before: Vec<&str> = self.before.lines().collect();
        let after: Vec<&str> = self.after.lines().collect();
        format!("--- a/{name}\n+++ b/{name}\n") + &hunks(&before, &after)
    }
}

/// Splits a text into the lines before the first entry and the lines of each entry.
fn blocks(text: &str) -> Vec<Vec<&str>> {
    let mut blocks = vec![Vec::new()];
    for line in text.lines() {
        if line.trim_start().starts_with('[') && line.trim_end().ends_with("]]") {
            blocks.push(Vec::new());
        }
        if let Some(block) = blocks.last_mut() {
            block.push(line);
        }
    }
    blocks
}

fn names(block: &[&str]) -> Option<NamesOfOne> {
    if block.first()?.trim() != HEADER {
        return None;
    }
    let mut names: Names = toml::from_str(&block.join("\n")).ok()?;
    names.interaction.pop()
}

fn with_revision(block: &[&str], revision: &InteractionRevision) -> Vec<String> {
    let values = values(&revision.interaction);
    let key_of = |line: &str| {
        let (key, _) = line.split_once('=')?;
        values.iter().position(|(known, ..)| *known == key.trim())
    };
    let mut lines: Vec<String> = Vec::new();
    // Rounds of earlier revisions.
    let mut kept: Vec<String> = Vec::new();
    let mut place = None;
    for line in block {
        let comment = line.trim_start();
        let is_kept = comment.starts_with(LEARNED_ROUNDS);
        if is_kept || comment.starts_with(LEARNED) || key_of(line).is_some() {
            place.get_or_insert(lines.len());
            kept.extend(is_kept.then(|| (*line).to_owned()));
        } else {
            lines.push((*line).to_owned());
        }
    }
    let place = place.unwrap_or(1);
    let comment = revision
        .source
        .iter()
        .map(|line| format!("{LEARNED}{line}"));
    let told = values.iter().map(|(key, value, meaning)| {
        if meaning.is_empty() {
            format!("{key} = {value}")
        } else {
            format!("{key} = {value}  # {meaning}")
        }
    });
    let rounds = revision.rounds.chunks(ROUNDS_PER_LINE);
    let rounds = rounds.map(|digests| LEARNED_ROUNDS.to_owned() + &digests.join(" "));
    let new: Vec<String> = (comment.chain(kept).chain(rounds).chain(told)).collect();
    lines.splice(place..place, new);
    lines
}

/// Returns the changed keys with values and comments.
fn values(interaction: &Interaction) -> Vec<(&'static str, String, String)> {
    let number = |value: f64| {
        let text = format!("{value:.4}");
        let short = text.trim_end_matches('0');
        if short.ends_with('.') {
            format!("{short}0")
        } else {
            short.to_owned()
        }
    };
    let law: &LogNormal = &interaction.likelihood;
    let (spread, redraw) = (&interaction.likelihood_spread, &interaction.redraw);
    let percent = |share: f64| format!("{:.0} %", 100.0 * law.probability(share));
    let half = format!("half are affected at f' = {:.2}", law.mu.exp());
    let curve = format!("{} at full force, {} at half", percent(1.0), percent(0.5));
    let none = String::new;
    let mut values = vec![
        ("mu", number(law.mu), half),
        ("sigma", number(law.sigma.max(1e-4)), curve),
        ("mu_spread", number(spread.mu), none()),
        ("ln_sigma_spread", number(spread.ln_sigma), none()),
    ];
    if let Some(length) = redraw.length_m {
        values.push(("redraw_length_m", number(length.max(1e-4)), none()));
    }
    let kept = format!(
        "{:.1} % that thresholds are kept for good",
        100.0 * redraw.kept_share
    );
    values.push((
        "ln_redraw_length_spread",
        number(redraw.ln_length_spread),
        none(),
    ));
    values.push(("kept_share", number(redraw.kept_share), kept));
    values
}

/// A line of a diff: in both texts, only before, or only after.
#[derive(Clone, Copy, PartialEq)]
enum Step {
    Both,
    Before,
    After,
}

/// Formats the changes between two texts as hunks with context lines.
fn hunks(before: &[&str], after: &[&str]) -> String {
    let steps = steps(before, after);
    let mut text = String::new();
    let mut next = 0;
    // Line numbers in each text before the first step of a hunk.
    let counts = |steps: &[Step]| {
        let count = |other: Step| steps.iter().filter(|step| **step != other).count();
        [count(Step::After), count(Step::Before)]
    };
    while let Some(first) = (next..steps.len()).find(|&i| steps[i] != Step::Both) {
        let start = first.saturating_sub(CONTEXT).max(next);
        let mut end = first;
        while let Some(change) =
            (end..steps.len().min(end + 2 * CONTEXT + 1)).find(|&i| steps[i] != Step::Both)
        {
            end = change + 1;
        }
        let end = (end + CONTEXT).min(steps.len());
        let [old_at, new_at] = counts(&steps[..start]);
        let [old, new] = counts(&steps[start..end]);
        let range =
            |at: usize, count: usize| format!("{},{count}", if count > 0 { at + 1 } else { at });
        text += &format!("@@ -{} +{} @@\n", range(old_at, old), range(new_at, new));
        let (mut i, mut j) = (old_at, new_at);
        for step in &steps[start..end] {
            let (sign, line) = match step {
                Step::Both => (' ', before[i]),
                Step::Before => ('-', before[i]),
                Step::After => ('+', after[j]),
            };
            i += usize::from(*step != Step::After);
            j += usize::from(*step != Step::Before);
            text += &format!("{sign}{line}\n");
        }
        next = end;
    }
    text
}

/// Computes the edit script that keeps the most lines (longest common subsequence).
fn steps(before: &[&str], after: &[&str]) -> Vec<Step> {
    let pairs = || before.iter().zip(after);
    let head = pairs().take_while(|(a, b)| a == b).count();
    let (a, b) = (&before[head..], &after[head..]);
    let tail = (a.iter().rev().zip(b.iter().rev())).take_while(|(a, b)| a == b);
    let tail = tail.count();
    let (a, b) = (&a[..a.len() - tail], &b[..b.len() - tail]);
    let mut steps = vec![Step::Both; head];
    if a.len() * b.len() > MOST_COMPARED * MOST_COMPARED {
        steps.extend(std::iter::repeat_n(Step::Before, a.len()));
        steps.extend(std::iter::repeat_n(Step::After, b.len()));
    } else {
        // common[i][j] = length of the longest common subsequence of before[i..] and after[j..]
        let width = b.len() + 1;
        let mut common = vec![0_u32; (a.len() + 1) * width];
        for i in (0..a.len()).rev() {
            for j in (0..b.len()).rev() {
                common[i * width + j] = if a[i] == b[j] {
                    common[(i + 1) * width + j + 1] + 1
                } else {
                    common[(i + 1) * width + j].max(common[i * width + j + 1])
                };
            }
        }
        let (mut i, mut j) = (0, 0);
        while i < a.len() || j < b.len() {
            let is_both = i < a.len() && j < b.len() && a[i] == b[j];
            if is_both {
                steps.push(Step::Both);
                (i, j) = (i + 1, j + 1);
            } else if j == b.len()
                || (i < a.len() && common[(i + 1) * width + j] >= common[i * width + j + 1])
            {
                steps.push(Step::Before);
                i += 1;
            } else {
                steps.push(Step::After);
                j += 1;
            }
        }
    }
    steps.extend(std::iter::repeat_n(Step::Both, tail));
    steps
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assets::KnowledgeSource;
    use wisch::represent::{LogNormalSpread, Redraw};

    fn revision(tool: &str, surface: &str, mu: f64) -> InteractionRevision {
        let base = KnowledgeSource::BuiltIn.base().unwrap();
        let known = base.interaction(tool, "breadcrumbs", surface).unwrap();
        InteractionRevision {
            interaction: Interaction {
                likelihood: LogNormal { mu, sigma: 0.31 },
                likelihood_spread: LogNormalSpread {
                    mu: 0.02,
                    ln_sigma: 0.05,
                },
                redraw: Redraw {
                    length_m: Some(0.04),
                    ln_length_spread: 0.1,
                    kept_share: 0.001,
                },
                ..known.clone()
            },
            source: vec!["from 20 rounds".to_owned()],
            rounds: vec![format!("{mu}a"), format!("{mu}b")],
        }
    }

    #[test]
    fn a_revision_changes_its_entry_and_nothing_else() {
        let revisions = [revision("sponge", "chopping_board", -0.8)];
        let files = KnowledgeSource::BuiltIn
            .revise_knowledge(&revisions)
            .unwrap();
        let [file] = &files[..] else {
            panic!("one file changes")
        };
        let again = parse_knowledge_with(file);
        let (base, changed) = (
            KnowledgeSource::BuiltIn.base().unwrap(),
            &revisions[0].interaction,
        );
        for (known, now) in base.interactions().zip(again.interactions()) {
            let is_it = (&known.tool, &known.medium, &known.surface)
                == (&changed.tool, &changed.medium, &changed.surface);
            assert_eq!(now, if is_it { changed } else { known });
        }
        let [entry] = file.entries() else {
            panic!("one entry changes")
        };
        assert!(
            entry.starts_with(HEADER) && entry.contains("# learned: from 20 rounds\n"),
            "{entry}"
        );
        assert!(
            entry.contains("mu = -0.8  # half are affected at f' = 0.45\n"),
            "{entry}"
        );

        // Once more over the same file: the old comment goes.
        let texts = [("interactions.toml".to_owned(), file.after.clone())];
        let block = blocks(&texts[0].1);
        let block = block
            .iter()
            .find(|block| names(block).is_some_and(|n| n.surface == "chopping_board"))
            .unwrap();
        let twice = with_revision(block, &revision("sponge", "chopping_board", -0.7));
        let from = twice.iter().filter(|line| line.ends_with("from 20 rounds"));
        assert_eq!(from.count(), 1);
        // The rounds of both revisions are known.
        let texts = [("interactions.toml".to_owned(), twice.join("\n"))];
        let rounds: Vec<String> = list_learned_rounds(&texts).into_iter().collect();
        assert_eq!(rounds, ["-0.7a", "-0.7b", "-0.8a", "-0.8b"]);
    }

    fn parse_knowledge_with(file: &RevisedFile) -> wisch::represent::KnowledgeBase {
        let texts = KnowledgeSource::BuiltIn.texts().unwrap();
        let texts: Vec<(&str, &str)> = (texts.iter())
            .map(|(name, text)| {
                (
                    name.as_str(),
                    if *name == file.name {
                        &file.after
                    } else {
                        text.as_str()
                    },
                )
            })
            .collect();
        parse_knowledge(&texts).unwrap()
    }

    #[test]
    fn a_diff_is_as_other_programs_write_it() {
        let lines = |text: &'static str| text.lines().collect::<Vec<_>>();
        let before = lines("a\nb\nc\nd\ne\nf\ng\nh\ni\nj\nk\nl\nm");
        let after = lines("a\nB\nc\nd\ne\nf\ng\nh\ni\nj\nk\nl\nnew\nm");
        let expected =
            "@@ -1,5 +1,5 @@\n a\n-b\n+B\n c\n d\n e\n@@ -10,4 +10,5 @@\n j\n k\n l\n+new\n m\n";
        assert_eq!(hunks(&before, &after), expected);
        assert_eq!(hunks(&before, &before), "");
    }
}
