//! The commands, each in its file.

mod ask;
mod check;
mod checkpoint;
mod checkpoint_record;
mod episode;
mod export;
mod follow;
mod footprint;
mod import;
mod interpret;
mod look;
mod map;
mod memory;
mod new;
mod prepare;
mod results;
mod robot;
mod rounds;
mod run;
mod summary;
mod words;

use crate::args::{Cli, Command, RobotCommand};
use crate::failure::Failure;
use crate::terminal::Outcome;

/// Does what the command line says.
pub fn run(cli: &Cli) -> Result<Outcome, Failure> {
    match &cli.command {
        Command::Run(args) => run::run(args, &cli.global),
        Command::Ask(args) => ask::ask(args, &cli.global),
        Command::PrologEngine(args) => ask::engine(args),
        Command::Follow(args) => run::follow_only(args, &cli.global),
        Command::Plan(args) => run::plan_only(args, &cli.global),
        Command::Predict(args) => run::predict_only(args, &cli.global),
        Command::Interpret(args) => interpret::interpret(args, &cli.global),
        Command::Footprint(args) => footprint::footprint(args, &cli.global),
        Command::New(args) => new::new(args, &cli.global),
        Command::Check(args) => check::check(args, &cli.global),
        Command::Memory(command) => memory::memory(command, &cli.global),
        Command::Robot(RobotCommand::Check(args)) => robot::check_robot(args, &cli.global),
        Command::Robot(RobotCommand::Map(args)) => map::map(args, &cli.global),
    }
}
