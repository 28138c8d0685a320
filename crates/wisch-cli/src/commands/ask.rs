//! `wisch ask`: answers Prolog queries of a memory, from the command line, a pipe or a prompt.

use super::interrupt::leave_ctrl_c;
use super::{answer_page, engine, fleet};
use crate::args::{AskArgs, DEFAULT_MEMORY, GlobalArgs};
use crate::failure::Failure;
use crate::terminal::{Outcome, print, print_error, remark};
use rustyline::completion::{Completer, Pair};
use rustyline::error::ReadlineError;
use rustyline::highlight::Highlighter;
use rustyline::hint::Hinter;
use rustyline::history::DefaultHistory;
use rustyline::validate::Validator;
use rustyline::{Context, Editor, Helper};
use serde_json::{Map, Value, json};
use signal_hook::consts::SIGINT;
use signal_hook::flag::register;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;
use tempfile::TempDir;
use wisch_memory::ask::{
    Answers, AskError, AskLimits, Assertions, Predicate, QueryFault, QuerySession,
    TelemetryPredicates, Term, builtins, locate_fault, predicates,
};
use wisch_memory::{Catalogue, Memory};

/// Version of what `--json` prints.
const ANSWERS_SCHEMA: &str = "wisch.answers/1";
/// File in the memory's folder with the history of the prompt.
const HISTORY_FILE: &str = ".history";

/// Answers the query of the arguments, or the queries of standard input.
pub fn ask(args: &AskArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    if args.list {
        print(&format_listing(&predicates()))?;
        return Ok(Outcome::Done);
    }
    let place = Place::of(args, global)?;
    let mut asked = Asked::open(place.folder(), args, global)?;
    match &args.query {
        Some(query) => answer(&mut asked, query, args, global),
        None if std::io::stdin().is_terminal() => interactive(&mut asked, args, global),
        None => answer_lines(&mut asked, args, global),
    }
}

/// The folder of the queried memory.
enum Place {
    Folder(PathBuf),
    /// A temporary folder with episodes of a fleet.
    Pulled(TempDir),
}

impl Place {
    fn of(args: &AskArgs, global: &GlobalArgs) -> Result<Self, Failure> {
        let folder = args.memory.clone();
        let Some(url) = &args.fleet else {
            if !args.selection.to_arguments().is_empty() {
                return Err(Failure::new("options that select episodes need --fleet")
                    .with_help("name the fleet with --fleet, or select episodes in the query"));
            }
            return Ok(Self::Folder(
                folder.unwrap_or_else(|| DEFAULT_MEMORY.into()),
            ));
        };
        let place = match folder {
            Some(folder) => Self::Folder(folder),
            None => Self::Pulled(tempfile::tempdir().map_err(|error| {
                Failure::new(format!("cannot create a temporary folder: {error}"))
            })?),
        };
        fleet::fetch(url, &args.selection, place.folder(), global)?;
        Ok(place)
    }

    fn folder(&self) -> &Path {
        match self {
            Self::Folder(folder) => folder,
            Self::Pulled(folder) => folder.path(),
        }
    }
}

/// A memory with its query engine.
struct Asked {
    memory: Memory,
    catalogue: Arc<Catalogue>,
    asker: QuerySession,
}

impl Asked {
    fn open(folder: &Path, args: &AskArgs, global: &GlobalArgs) -> Result<Self, Failure> {
        let memory = Memory::open(folder).map_err(|error| {
            Failure::new(error)
                .with_help("wisch run creates a memory; choose another folder with --memory DIR")
        })?;
        let catalogue = Arc::new(memory.catalogue().map_err(Failure::new)?);
        let asker = open_query_session(args, global, memory.clone(), Arc::clone(&catalogue))?;
        if !global.quiet {
            asker
                .remarks_on_memory()
                .iter()
                .for_each(|what| remark(what));
        }
        Ok(Self {
            asker,
            memory,
            catalogue,
        })
    }
}

fn open_query_session(
    args: &AskArgs,
    global: &GlobalArgs,
    memory: Memory,
    catalogue: Arc<Catalogue>,
) -> Result<QuerySession, Failure> {
    let command = engine::find(args.engine, global)?;
    let limits = AskLimits {
        time: Duration::from_secs(args.timeout.into()),
        memory: u64::from(args.memory_limit) << 20,
        answers: args.limit as usize,
    };
    let assertions = Assertions::read(memory.folder()).map_err(Failure::new)?;
    let telemetry = TelemetryPredicates::new(memory);
    Ok(QuerySession::new(
        command, limits, catalogue, telemetry, assertions,
    ))
}

/// Answers one query; `Done` if it has an answer.
fn answer(
    asked: &mut Asked,
    query: &str,
    args: &AskArgs,
    global: &GlobalArgs,
) -> Result<Outcome, Failure> {
    let page = args.view.as_deref().map(answer_page::begin).transpose()?;
    let answers = asked
        .asker
        .ask(query)
        .map_err(|error| failure(&error, query))?;
    if args.json {
        let on_memory = asked.asker.remarks_on_memory();
        print(&format!("{}\n", in_json(query, &answers, &on_memory)))?;
    } else if args.csv {
        print(&in_csv(&answers))?;
        if answers.is_cut {
            // A table that lacks rows must not pass for the whole, even with --quiet.
            remark(&format!("the answers are cut: {}", format_cut(&answers)));
        }
    } else if !global.quiet {
        print(&answers.printed)?;
        print(&in_words(&answers))?;
    }
    let mut remarks = answers.remarks.clone();
    if let Some(page) = page {
        let not_shown = answer_page::draw(page, query, &answers, &asked.memory, &asked.catalogue)?;
        remarks.extend(not_shown);
    } else if !answers.views.is_empty() && !global.quiet {
        remark("the query requests a plot; draw it with --view FILE");
    }
    if !global.quiet {
        remarks.iter().for_each(|what| remark(what));
    }
    Ok(if answers.holds() {
        Outcome::Done
    } else {
        Outcome::GoalNotMet
    })
}

fn failure(error: &AskError, query: &str) -> Failure {
    let failure = Failure::new(error);
    match error {
        AskError::Fault(fault @ QueryFault::Syntax { what }) => {
            let place = syntax_place(fault, query);
            Failure::new(format!("the query is not valid Prolog{place} ({what})")).with_help(
                "join goals by commas, close every bracket and quote, and begin variables with a capital letter",
            )
        }
        AskError::Fault(QueryFault::Unknown { kind, .. }) if kind == "predicate" => {
            failure.with_help("wisch ask --list lists the predicates that queries may call")
        }
        AskError::Time(_) => failure.with_help("raise the limit with --timeout"),
        AskError::EngineEnded { .. } => {
            failure.with_help("raise the memory limit with --memory-limit")
        }
        _ => failure,
    }
}

/// Number of characters that an error shows of a faulty query.
const QUERY_SHOWN: usize = 20;

/// Returns where a query cannot be read, as a part of a sentence.
fn syntax_place(fault: &QueryFault, query: &str) -> String {
    let Some(place) = locate_fault(fault, query) else {
        return String::new();
    };
    let line = query.lines().nth(place.line - 1).unwrap_or_default();
    let rest = line.chars().skip(place.column - 1);
    let shown: String = rest.take(QUERY_SHOWN).collect();
    let column = match query.trim_end().contains('\n') {
        true => format!("line {}, column {}", place.line, place.column),
        false => format!("column {}", place.column),
    };
    match shown.trim_end() {
        "" => format!(" at its end, {column}"),
        shown => format!(" from {column} on, at {shown:?}"),
    }
}

/// Answers queries from standard input, one per line.
fn answer_lines(
    asked: &mut Asked,
    args: &AskArgs,
    global: &GlobalArgs,
) -> Result<Outcome, Failure> {
    let mut outcome = Outcome::Done;
    for line in std::io::stdin().lines() {
        let line = line.map_err(|error| Failure::new(format!("standard input: {error}")))?;
        let query = line.trim();
        if query.is_empty() || query.starts_with('%') {
            continue;
        }
        if answer(asked, query, args, global)? == Outcome::GoalNotMet {
            outcome = Outcome::GoalNotMet;
        }
    }
    Ok(outcome)
}

/// Completes names of predicates.
struct Typing {
    predicates: Vec<Predicate>,
}

impl Helper for Typing {}

impl Highlighter for Typing {}

impl Hinter for Typing {
    type Hint = String;
}

impl Validator for Typing {}

impl Completer for Typing {
    type Candidate = Pair;

    fn complete(
        &self,
        line: &str,
        at: usize,
        _: &Context<'_>,
    ) -> rustyline::Result<(usize, Vec<Pair>)> {
        let before = &line[..at];
        let word = |c: char| c.is_alphanumeric() || c == '_';
        let start = before.rfind(|c| !word(c)).map_or(0, |place| {
            place + before[place..].chars().next().map_or(1, char::len_utf8)
        });
        let typed = &before[start..];
        let fitting =
            (self.predicates.iter()).filter(|p| !typed.is_empty() && p.name.starts_with(typed));
        let mut pairs: Vec<Pair> = fitting
            .map(|predicate| Pair {
                display: predicate.meaning.clone(),
                replacement: predicate.name.clone(),
            })
            .collect();
        pairs.dedup_by(|a, b| a.replacement == b.replacement);
        Ok((start, pairs))
    }
}

fn interactive(asked: &mut Asked, args: &AskArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let terminal = |error: ReadlineError| Failure::new(format!("terminal: {error}"));
    let mut editor: Editor<Typing, DefaultHistory> = Editor::new().map_err(terminal)?;
    editor.set_helper(Some(Typing {
        predicates: predicates(),
    }));
    let history = asked.memory.folder().join(HISTORY_FILE);
    // A missing or unreadable history counts as empty.
    let _ = editor.load_history(&history);
    if !global.quiet {
        print("Type a Prolog query, help or quit; Ctrl-C ends a query.\n")?;
    }
    // While the user types a line, the editor handles Ctrl-C.
    leave_ctrl_c();
    register(SIGINT, asked.asker.interrupt())
        .map_err(|error| Failure::new(format!("Ctrl-C: {error}")))?;
    loop {
        let line = match editor.readline("?- ") {
            Ok(line) => line,
            Err(ReadlineError::Eof) => break,
            Err(ReadlineError::Interrupted) => continue,
            Err(error) => return Err(terminal(error)),
        };
        let query = line.trim().trim_end_matches('.');
        let _ = editor.add_history_entry(line.trim());
        match query {
            "" => {}
            "quit" | "exit" | "halt" => break,
            "help" => print(&format_listing(&predicates()))?,
            _ => {
                if let Err(failure) = answer(asked, query, args, global) {
                    print_error(&failure);
                }
            }
        }
    }
    save_history(&mut editor, &history);
    Ok(Outcome::Done)
}

fn save_history(editor: &mut Editor<Typing, DefaultHistory>, file: &Path) {
    // A failure is ignored: only the history is lost.
    let _ = editor.save_history(file);
}

fn in_words(answers: &Answers) -> String {
    if !answers.holds() {
        return "false\n".to_owned();
    }
    let mut text = String::new();
    for row in &answers.rows {
        let bound = answers.names.iter().zip(row);
        let bound = bound.filter(|(_, term)| !matches!(term, Term::Variable(_)));
        let bound: Vec<_> = bound
            .map(|(name, term)| format!("{name} = {term}"))
            .collect();
        if bound.is_empty() {
            text.push_str("true\n");
        } else {
            text.push_str(&bound.join(", "));
            text.push('\n');
        }
    }
    if answers.is_cut {
        text.push_str(&format!("… {}\n", format_cut(answers)));
    }
    text
}

/// States that the limit cut the answers.
fn format_cut(answers: &Answers) -> String {
    let count = answers.rows.len();
    format!("the first {count} answers; raise the limit with --limit")
}

fn in_json(query: &str, answers: &Answers, on_memory: &[String]) -> Value {
    let remarks: Vec<&String> = on_memory.iter().chain(&answers.remarks).collect();
    let rows = answers.rows.iter().map(|row| {
        let bound = answers.names.iter().zip(row);
        let bound: Map<String, Value> = bound
            .map(|(name, term)| (name.clone(), term.to_json()))
            .collect();
        Value::Object(bound)
    });
    json!({
        "schema": ANSWERS_SCHEMA,
        "query": query,
        "answers": rows.collect::<Vec<_>>(),
        "is_cut": answers.is_cut,
        "printed": answers.printed,
        "remarks": remarks,
    })
}

fn in_csv(answers: &Answers) -> String {
    let mut text = answers.names.join(",") + "\n";
    for row in &answers.rows {
        let cells = row.iter().map(|term| {
            let cell = match term {
                Term::Variable(_) => String::new(),
                Term::Atom(name) => name.clone(),
                other => other.to_string(),
            };
            if cell.contains([',', '"', '\n']) {
                format!("\"{}\"", cell.replace('"', "\"\""))
            } else {
                cell
            }
        });
        text.push_str(&cells.collect::<Vec<_>>().join(","));
        text.push('\n');
    }
    text
}

fn format_listing(predicates: &[Predicate]) -> String {
    let lines = predicates.iter().map(|predicate| {
        let meaning = &predicate.meaning;
        // A colon within arguments does not end the head.
        let end = meaning
            .find("): ")
            .map_or_else(|| meaning.find(": "), |end| Some(end + 1));
        match end.map(|end| (&meaning[..end], &meaning[end + 2..])) {
            Some((call, says)) => format!("  {call}\n      {says}\n"),
            None => format!("  {meaning}\n"),
        }
    });
    let own = lines.collect::<String>();
    own + &format!("  Prolog built-ins\n      {}\n", builtins().join(" "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_listed_call_keeps_a_colon_in_its_arguments() {
        let predicate = |meaning: &str| Predicate {
            name: String::new(),
            arity: 0,
            meaning: meaning.to_owned(),
        };
        let text = format_listing(&[
            predicate("data_vis(Id, [data: [X, Y]]): draws: a chart"),
            predicate("show: shows the scene"),
        ]);
        assert!(
            text.starts_with("  data_vis(Id, [data: [X, Y]])\n      draws: a chart\n  show\n      shows the scene\n"),
            "{text}"
        );
    }

    #[test]
    fn a_query_that_is_no_prolog_is_refused_with_the_place() {
        let what = "incomplete reduction".to_owned();
        let error = AskError::Fault(QueryFault::Syntax { what });
        for (query, place) in [
            ("low_performance(A P)", "from column 19 on, at \"P)\""),
            (
                "true,\n foo(A,, B)",
                "from line 2, column 8 on, at \", B)\"",
            ),
            ("foo(A), ", "at its end, column 8"),
        ] {
            let shown = failure(&error, query).to_string();
            let expected = format!("the query is not valid Prolog {place} (incomplete reduction)");
            assert!(shown.contains(&expected), "{shown}");
        }
    }
}
