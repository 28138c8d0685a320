//! The commands, one file each.

mod answer_page;
mod ask;
mod budget;
mod check;
mod companion;
mod engine;
mod eval;
mod explain;
mod export;
mod extent;
mod film;
mod fleet;
mod follow;
mod footprint;
mod goal;
mod health;
mod import;
mod interpret;
mod interrupt;
mod job;
mod learn;
mod log_advice;
mod log_observation;
mod log_report;
mod map;
mod memory;
mod new;
mod out_folder;
mod patches;
mod prepare;
mod replaceable;
mod report;
mod robot;
mod ros2;
mod round_views;
mod rounds;
mod run;
mod scenarios;
mod setup;
mod shell;
mod studio;
mod summary;
mod surface;
mod swept;
mod warnings;
mod watch;
mod wipe;
mod words;

use crate::args::{Cli, Command, EvalCommand, MemoryCommand, RobotCommand, SurfaceCommand};
use crate::failure::Failure;
use crate::terminal::Outcome;

/// Name and version of this program, as results and episodes state it.
const PROGRAM: &str = concat!("wisch ", env!("CARGO_PKG_VERSION"));

/// Runs the command of the command line.
pub fn run(cli: &Cli) -> Result<Outcome, Failure> {
    // Before any file is written, so that a signal leaves no files behind.
    interrupt::listen()?;
    match &cli.command {
        Command::Run(args) => run::run(args, &cli.global),
        Command::Studio(args) => studio::studio(args, &cli.global),
        Command::Report(args) => report::report(args, &cli.global),
        Command::Film(args) => film::film(args, &cli.global),
        Command::Ask(args) => ask::ask(args, &cli.global),
        Command::Follow(args) => run::follow_only(args, &cli.global),
        Command::Plan(args) => run::plan_only(args, &cli.global),
        Command::Predict(args) => run::predict_only(args, &cli.global),
        Command::Interpret(args) => interpret::interpret(args, &cli.global),
        Command::Learn(args) => learn::learn(args, &cli.global),
        Command::Footprint(args) => footprint::footprint(args, &cli.global),
        Command::New(args) => new::new(args, &cli.global),
        Command::Scenarios(args) => scenarios::scenarios(args),
        Command::Schema(args) => new::schema(args),
        Command::Completions(args) => shell::completions(args),
        Command::Man(args) => shell::man(args),
        Command::Check(args) => check::check(args, &cli.global),
        Command::Eval(EvalCommand::Calibration(args)) => eval::calibration(args, &cli.global),
        Command::Eval(EvalCommand::Scenarios(args)) => eval::scenarios(args, &cli.global),
        Command::Eval(EvalCommand::Goals(args)) => eval::goals(args, &cli.global),
        Command::Eval(EvalCommand::Table1(args)) => eval::table1(args, &cli.global),
        Command::Eval(EvalCommand::Sweep(args)) => eval::sweep(args, &cli.global),
        Command::Memory(MemoryCommand::List(args)) => memory::list(args),
        Command::Memory(MemoryCommand::Show(args)) => memory::show(args),
        Command::Memory(MemoryCommand::Verify(args)) => memory::verify(args, &cli.global),
        Command::Memory(MemoryCommand::Health(args)) => health::health(args),
        Command::Memory(MemoryCommand::Forget(args)) => memory::forget(args, &cli.global),
        Command::Memory(MemoryCommand::Import(args)) => import::import(args, &cli.global),
        Command::Memory(MemoryCommand::Export(args)) => export::export(args, &cli.global),
        Command::Memory(MemoryCommand::Push(args)) => fleet::push(args, &cli.global),
        Command::Memory(MemoryCommand::Pull(args)) => fleet::pull(args, &cli.global),
        Command::Surface(SurfaceCommand::Check(args)) => surface::check_surface(args, &cli.global),
        Command::Surface(SurfaceCommand::Split(args)) => surface::split_surface(args, &cli.global),
        Command::Robot(RobotCommand::Check(args)) => robot::check_robot(args, &cli.global),
        Command::Robot(RobotCommand::Map(args)) => map::map(args, &cli.global),
        Command::Robot(RobotCommand::Setup(args)) => setup::set_up(args, &cli.global),
        Command::Robot(RobotCommand::Doctor(args)) => ros2::doctor(args, &cli.global),
        Command::Robot(RobotCommand::PushTest(args)) => ros2::push_test(args, &cli.global),
        Command::Robot(RobotCommand::Fake(args)) => ros2::fake(args, &cli.global),
    }
}
