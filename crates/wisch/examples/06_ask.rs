//! Store a log as an episode in a memory, and query the memory in Prolog.
//!
//! The query engine is the companion program `wisch-prolog`; `cargo build -p wisch-prolog` builds
//! it in some minutes. SWI-Prolog is an alternative.
//!
//! ```text
//! cargo run -p wisch --example 06_ask
//! ```

use std::error::Error;
use wisch::geometry::Pose;
use wisch::interpret::{Belief, InterpretConfig, TouchSample, interpret};
use wisch_io::{LoadOptions, load_task};
use wisch_memory::ask::{EngineCommand, QuerySession};
use wisch_memory::{EpisodeHeader, Memory, remember_log};

const TASK: &str = concat!(
    env!("CARGO_MANIFEST_DIR"),
    "/../../scenarios/arm-board.toml"
);
const HOW: &str = "there is no Prolog engine: cargo build -p wisch-prolog makes one";

pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let loaded = load_task(TASK.as_ref(), &LoadOptions::default())?;
    let (task, board) = (&loaded.task, loaded.task.surface.world_from_surface);
    // A second in the air, which shows the bias of the force, two along the board, and one in the air.
    let touches: [TouchSample; 400] = std::array::from_fn(|i| {
        let down = f64::from(u8::from((100..300).contains(&i)));
        let tool = board * Pose::translation(1e-3 * i as f64 - 0.2, -0.06, 0.05 * (1.0 - down));
        TouchSample::new(0.01 * i as f64, tool, task.surface_reaction() * down)
    });
    let goal = task.goal().ok_or("the task leaves its goal open")?;
    let believed = Belief::from_particles(task.particles.clone());
    let config = InterpretConfig::from_task(task);
    let estimate = interpret(&touches, task, &believed, &goal, &config)?;

    let folder = tempfile::tempdir()?;
    let memory = Memory::create(folder.path())?;
    let header = EpisodeHeader::new(0.0, task, 0.85, "tutorial");
    let record = remember_log(&header, "a log", 4.0, task, &goal, &estimate);
    memory.begin(&header.id)?.commit(&record)?;

    let engine = EngineCommand::find().ok_or(HOW)?;
    let mut asker = QuerySession::open(memory, engine)?;
    let answers = asker.ask("low_performance_round(Round, Performance)")?;
    for row in &answers.rows {
        println!("{} of round {}", row[1], row[0]);
    }
    Ok(())
}
