//! Commands on the fake robot's standard input: faults and disturbances.

use std::io::BufRead;
use std::sync::mpsc::{Receiver, channel};

/// The commands, for the program's help.
pub(crate) const COMMANDS: &str = "\
Commands on standard input, one per line:
  push X Y Z SECONDS     a force on the tool, in the axes of the world [N]
  scaling SHARE          speed scaling, 0 to 1; 0 is a pause
  safety NUMBER          safety mode; 1 is NORMAL, 3 a protective stop, 7 an emergency stop
  program true|false     whether the program on the robot runs
  silence joints|wrench|progress    stop sending joint states, wrenches, or the controller's state
  speak                  send all messages again
  shuffle                reverse the order of the joints in joint states
  move JOINT RADIANS     displace a joint, named by its number from 0
  jump JOINT RADIANS     state a joint's position too large from now on, while the arm stays
  clock SECONDS          shift the stamps of messages
  sign 1|-1              sign of the measured wrench
  reject true|false      reject goals
  delay SECONDS          begin goals late, as if their transmission took this long
  refuse true|false      refuse to end force mode
  quit                   end

The program prints one line for each request, with the time of this computer's clock.";

/// A command.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Command {
    Push([f64; 3], f64),
    Scaling(f64),
    Safety(u8),
    Program(bool),
    /// Joint states, wrenches, or states of the controller.
    Silence(usize),
    Speak,
    Shuffle,
    Move(usize, f64),
    Jump(usize, f64),
    Clock(f64),
    Sign(f64),
    Reject(bool),
    Delay(f64),
    Refuse(bool),
    Quit,
}

/// Commands that a thread reads.
pub(super) struct Commands(Receiver<Command>);

impl Commands {
    /// Starts to read standard input. Its end changes nothing.
    pub fn start() -> Self {
        let (send, receive) = channel();
        std::thread::spawn(move || {
            for line in std::io::stdin().lock().lines().map_while(Result::ok) {
                match parse(&line) {
                    Ok(Some(command)) => {
                        if send.send(command).is_err() {
                            return;
                        }
                    }
                    Ok(None) => {}
                    Err(text) => eprintln!("{line:?}: {text}"),
                }
            }
        });
        Self(receive)
    }

    pub fn poll(&self) -> Option<Command> {
        self.0.try_recv().ok()
    }
}

/// Reads a command; `None` for an empty line.
fn parse(line: &str) -> Result<Option<Command>, String> {
    let words: Vec<&str> = line.split_whitespace().collect();
    let number = |text: &str| -> Result<f64, String> {
        let number = text.parse::<f64>().ok().filter(|number| number.is_finite());
        number.ok_or_else(|| format!("{text} is not a finite number"))
    };
    let index = |text: &str| {
        text.parse()
            .map_err(|_| format!("{text} is not a joint's number"))
    };
    let flag = |text: &str| {
        text.parse()
            .map_err(|_| format!("{text}: expected true or false"))
    };
    Ok(Some(match words[..] {
        [] => return Ok(None),
        ["push", x, y, z, seconds] => {
            let seconds = number(seconds)?.clamp(0.0, 3600.0);
            Command::Push([number(x)?, number(y)?, number(z)?], seconds)
        }
        ["scaling", share] => Command::Scaling(number(share)?.clamp(0.0, 1.0)),
        ["safety", mode] => Command::Safety(
            mode.parse()
                .map_err(|_| format!("{mode}: expected 0 to 255"))?,
        ),
        ["program", runs] => Command::Program(flag(runs)?),
        ["silence", "joints"] => Command::Silence(0),
        ["silence", "wrench"] => Command::Silence(1),
        ["silence", "progress"] => Command::Silence(2),
        ["speak"] => Command::Speak,
        ["shuffle"] => Command::Shuffle,
        ["move", joint, distance] => Command::Move(index(joint)?, number(distance)?),
        ["jump", joint, distance] => Command::Jump(index(joint)?, number(distance)?),
        ["clock", seconds] => Command::Clock(number(seconds)?),
        ["sign", "1"] => Command::Sign(1.0),
        ["sign", "-1"] => Command::Sign(-1.0),
        ["reject", rejects] => Command::Reject(flag(rejects)?),
        ["delay", seconds] => Command::Delay(number(seconds)?.clamp(0.0, 3600.0)),
        ["refuse", refuses] => Command::Refuse(flag(refuses)?),
        ["quit"] => Command::Quit,
        _ => return Err("unknown command; see wisch-ros2 fake --help".to_owned()),
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_are_read_and_others_are_refused() {
        let push = Command::Push([1.0, 0.0, -2.5], 3.0);
        assert_eq!(parse("push 1 0 -2.5 3"), Ok(Some(push)));
        assert_eq!(parse("jump 6 0.1"), Ok(Some(Command::Jump(6, 0.1))));
        assert_eq!(parse("silence wrench"), Ok(Some(Command::Silence(1))));
        assert_eq!(parse("  "), Ok(None));
        for line in ["push 1 2 3", "scaling nan", "move x 1", "silence nobody"] {
            assert!(parse(line).is_err(), "{line}");
        }
    }
}
