//! Command-line arguments of the program.

use crate::Config;
use std::ffi::OsString;
use std::net::{IpAddr, Ipv4Addr};
use std::path::PathBuf;

/// Usage text.
pub const USAGE: &str = "usage: wisch-studio --memory DIR --wisch PROGRAM [--engine PROGRAM] [--scenarios FILE]
                    [--host ADDRESS] [--port N] [--open]
Server of wisch studio. The command `wisch studio` starts it.

  --memory DIR       folder of the memory, created if necessary
  --wisch PROGRAM    the program wisch, which runs tasks
  --engine PROGRAM   Prolog system: wisch-prolog or swipl [default: the first that is installed]
  --scenarios FILE   shipped tasks as JSON: [{\"name\": ..., \"about\": ...}] [default: as wisch scenarios lists them]
  --host ADDRESS     address to listen at [default: 127.0.0.1]
  --port N           port; 0 for any free port [default: 0]
  --open             open the page in the browser";

/// Parsed command-line arguments.
#[derive(Debug, Clone)]
pub struct Arguments {
    /// Configuration of the server.
    pub config: Config,
    /// Whether to open the page in the browser.
    pub open: bool,
}

impl Arguments {
    /// Parses the arguments as typed, without the program's name; `None` asks for help.
    ///
    /// # Errors
    /// A message for the user.
    pub fn parse(typed: impl IntoIterator<Item = OsString>) -> Result<Option<Self>, String> {
        let mut typed = typed.into_iter();
        let (mut memory, mut wisch, mut engine, mut scenarios) = (None, None, None, None);
        let (mut host, mut port) = (IpAddr::V4(Ipv4Addr::LOCALHOST), 0);
        let mut open = false;
        while let Some(option) = typed.next() {
            let option = option.to_string_lossy().into_owned();
            match option.as_str() {
                "--help" | "-h" => return Ok(None),
                "--open" => {
                    open = true;
                    continue;
                }
                "--memory" | "--wisch" | "--engine" | "--scenarios" | "--host" | "--port" => {}
                _ => return Err(format!("unexpected argument {option:?}\n{USAGE}")),
            }
            let value = typed.next();
            let value = value.ok_or_else(|| format!("{option} needs a value\n{USAGE}"))?;
            let text = value.to_string_lossy().into_owned();
            match option.as_str() {
                "--memory" => memory = Some(PathBuf::from(value)),
                "--wisch" => wisch = Some(PathBuf::from(value)),
                "--engine" => engine = Some(PathBuf::from(value)),
                "--scenarios" => scenarios = Some(PathBuf::from(value)),
                "--host" => {
                    let found = if text == "localhost" {
                        Ok(host)
                    } else {
                        text.parse()
                    };
                    host = found.map_err(|_| {
                        format!("--host is {text:?}; expected an IP address or localhost")
                    })?;
                }
                _ => {
                    let found = text.parse();
                    port = found.map_err(|_| {
                        format!("--port is {text:?}; expected a number from 0 to 65535")
                    })?;
                }
            }
        }
        let needed = |option: &str| format!("{option} is missing\n{USAGE}");
        Ok(Some(Self {
            config: Config {
                memory: memory.ok_or_else(|| needed("--memory"))?,
                wisch: wisch.ok_or_else(|| needed("--wisch"))?,
                engine,
                scenarios,
                host,
                port,
            },
            open,
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(typed: &str) -> Result<Option<Arguments>, String> {
        Arguments::parse(typed.split_whitespace().map(OsString::from))
    }

    #[test]
    fn all_options_are_parsed() {
        let typed = "--memory m --wisch w --engine e --scenarios s --host ::1 --port 8080 --open";
        let arguments = parse(typed).unwrap().unwrap();
        assert!(arguments.open);
        let config = arguments.config;
        assert_eq!(config.memory, PathBuf::from("m"));
        assert_eq!(config.engine, Some(PathBuf::from("e")));
        assert_eq!(config.host.to_string(), "::1");
        assert_eq!(config.port, 8080);
    }

    #[test]
    fn errors_name_the_wrong_option() {
        for (typed, named) in [
            ("--memory m", "--wisch"),
            ("--wisch w", "--memory"),
            ("--memory m --wisch w --port 70000", "70000"),
            ("--memory m --wisch w --host example.org", "example.org"),
            ("--memory m --wisch w --what", "--what"),
            ("--memory m --wisch", "--wisch"),
        ] {
            let what = parse(typed).unwrap_err();
            assert!(what.contains(named), "{typed}: {what}");
        }
        assert!(parse("--help").unwrap().is_none());
    }
}
