//! Options of the current command line, which messages add to the commands that they suggest.

use super::Cli;
use clap::parser::ValueSource;
use clap::{Arg, ArgAction, ArgMatches, Command, CommandFactory};
use std::sync::OnceLock;
use wisch_io::shell_word;

/// Options that belong to one command: its outputs, and how it shows them.
const OF_ONE_COMMAND: [&str; 9] = [
    "out", "force", "json", "events", "resume", "quiet", "threads", "color", "rounds",
];

/// The arguments of the present command line.
static PRESENT: OnceLock<ArgMatches> = OnceLock::new();

/// Keeps the arguments of the present command line.
pub(super) fn keep(matches: ArgMatches) {
    // A process has one command line.
    let _ = PRESENT.set(matches);
}

/// Returns a command of this program as a line of a shell, with the options of the present command that it accepts, too.
///
/// `command`: the command and its own arguments, such as `memory list`.
pub fn suggest(command: &str) -> String {
    let options = options_for(command, &[]);
    match options.as_str() {
        "" => format!("wisch {command}"),
        options => format!("wisch {command} {options}"),
    }
}

/// Returns the options of the present command that another command accepts, too, as words of a shell.
///
/// `command`: the other command, such as `memory list`; further words are ignored. `without`: names of options to leave out.
pub fn options_for(command: &str, without: &[&str]) -> String {
    let Some(present) = PRESENT.get() else {
        return String::new();
    };
    let program = Cli::command();
    let (mut here, mut source) = (&program, present);
    while let Some((name, inner)) = source.subcommand() {
        let Some(command) = here.find_subcommand(name) else {
            break;
        };
        (here, source) = (command, inner);
    }
    let mut target = &program;
    for word in command.split_whitespace() {
        let Some(inner) = target.find_subcommand(word) else {
            break;
        };
        target = inner;
    }
    let mut words = Vec::new();
    for option in target.get_arguments() {
        let Some(name) = option.get_long() else {
            continue;
        };
        if !OF_ONE_COMMAND.contains(&name) && !without.contains(&name) && has_option(here, option) {
            words.extend(format_option(source, option, name));
        }
    }
    words.join(" ")
}

/// Whether a command has the same option.
fn has_option(command: &Command, option: &Arg) -> bool {
    let mut own = command.get_arguments();
    own.any(|own| own.get_id() == option.get_id() && own.get_long() == option.get_long())
}

/// Returns an option as it was given; nothing if it was not given.
fn format_option(given: &ArgMatches, option: &Arg, name: &str) -> Vec<String> {
    let id = option.get_id().as_str();
    if !matches!(given.value_source(id), Some(ValueSource::CommandLine)) {
        return Vec::new();
    }
    let word = format!("--{name}");
    if matches!(option.get_action(), ArgAction::SetTrue) {
        return vec![word];
    }
    let values = given.get_raw(id).into_iter().flatten();
    values
        .flat_map(|value| [word.clone(), shell_word(&value.to_string_lossy())])
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_suggested_command_has_the_options_that_it_accepts() {
        let line = "wisch run board.toml --robot none --knowledge k --memory m --out o --rounds 2 --touch-only --json --set a=1";
        let matches = Cli::command().try_get_matches_from(line.split(' '));
        keep(matches.expect("a command line"));
        assert_eq!(suggest("memory list"), "wisch memory list --memory m");
        assert_eq!(suggest("scenarios"), "wisch scenarios");
        assert_eq!(
            options_for("run", &["set", "memory"]),
            "--knowledge k --robot none --touch-only"
        );
        assert_eq!(
            options_for("check board.toml", &[]),
            "--set a=1 --knowledge k --robot none"
        );
    }
}
