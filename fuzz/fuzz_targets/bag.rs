//! Bags of any robot (MCAP), read as `wisch interpret` reads them; short ones are also interpreted.
#![no_main]

use libfuzzer_sys::fuzz_target;
use std::path::PathBuf;
use std::sync::LazyLock;
use wisch::interpret::{Belief, InterpretConfig, interpret};
use wisch::represent::{Action, Task};
use wisch::robot::joint_transforms;
use wisch_telemetry::{LogOptions, read};
use wisch_testkit::board;

/// More samples than this take too long [1].
const MOST_SAMPLES: usize = 200;

static TASK: LazyLock<Task> = LazyLock::new(|| board(Action::Absorb, [0.45, 0.0, 0.3]));

static BAG: LazyLock<PathBuf> = LazyLock::new(|| {
    let name = format!("wisch-fuzz-{}.mcap", std::process::id());
    let shared_memory = PathBuf::from("/dev/shm");
    let folder = if shared_memory.is_dir() {
        shared_memory
    } else {
        std::env::temp_dir()
    };
    folder.join(name)
});

static OPTIONS: LazyLock<LogOptions> = LazyLock::new(|| LogOptions {
    joints: joint_transforms("arm6.urdf", include_str!("../../robots/arm6.urdf"))
        .expect("is shipped"),
    world_from_surface: TASK.surface.world_from_surface,
    ..LogOptions::default()
});

fuzz_target!(|bytes: &[u8]| {
    std::fs::write(&*BAG, bytes).expect("there is room");
    let Ok(log) = read(&BAG, &OPTIONS) else {
        return;
    };
    assert!(
        log.samples
            .windows(2)
            .all(|pair| pair[0].time < pair[1].time),
        "times that do not ascend"
    );
    if log.samples.len() <= MOST_SAMPLES {
        let goal = TASK.goal().expect("to absorb leaves nothing open");
        let believed = Belief::from_particles(TASK.particles.clone());
        let _ = interpret(
            &log.samples,
            &TASK,
            &believed,
            &goal,
            &InterpretConfig::from_task(&TASK),
        );
    }
});
