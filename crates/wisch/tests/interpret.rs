//! What synthetic logs tell, held against what was put into them.

#[path = "interpret/log.rs"]
mod log;

use log::{BOARD, DEPTH, Hand, PRESS, STEEP, Script, task};
use proptest::prelude::*;
use wisch::geometry::{Point2, Pose, Vector3};
use wisch::interpret::{
    Belief, Diagnosis, Event, EventKind, InterpretConfig, InterpretError, Interpretation,
    Interpreter, ToolCompliance, Touch, TouchSample, interpret,
};
use wisch::represent::{Fate, GoalState, LogNormal, ParticleDistribution, Task};

/// How exactly events are to be found [s].
const EVENT_TOLERANCE: f64 = 0.05;

fn told_with(samples: &[TouchSample], task: &Task, config: &InterpretConfig) -> Interpretation {
    let believed = Belief::certain(task.particles.clone());
    interpret(samples, task, &believed, &GoalState::Absorbed, config).unwrap()
}

fn told(script: &Script) -> Interpretation {
    let task = task(80, STEEP);
    told_with(&script.samples(&task), &task, &InterpretConfig::of(&task))
}

fn events(told: &Interpretation, kind: EventKind) -> Vec<Event> {
    (told.events.iter().filter(|event| event.kind == kind))
        .copied()
        .collect()
}

fn assert_near_times(event: &Event, [start, end]: [f64; 2]) {
    assert!(
        (event.start - start).abs() <= EVENT_TOLERANCE
            && (event.end - end).abs() <= EVENT_TOLERANCE,
        "{start} to {end} s: {event:?}"
    );
}

/// Share of the particles that three strokes of the sponge pass over.
fn swept(task: &Task) -> f64 {
    let inside = |p: &Point2| {
        p.x.abs() <= 0.16 + 0.035
            && [-0.085, 0.0, 0.085_f64]
                .iter()
                .any(|y| (p.y - y).abs() <= 0.055)
    };
    let particles: Vec<Point2> = task.particles.remaining().collect();
    particles.iter().filter(|p| inside(p)).count() as f64 / particles.len() as f64
}

#[test]
fn an_undisturbed_log_tells_three_contacts_and_nothing_else() {
    let script = Script::default();
    let told = told(&script);
    let plane = told.plane.unwrap();
    assert_eq!(told.diagnosis, Diagnosis::Localized);
    assert!(plane.tilt.to_degrees() < 0.1, "{plane:?}");
    assert!(plane.offset.abs() < 3e-4, "{plane:?}");
    let contacts = events(&told, EventKind::Contact);
    assert_eq!(contacts.len(), told.events.len(), "{:?}", told.events);
    assert_eq!(contacts.len(), 3);
    for (contact, [start, end]) in contacts.iter().zip(script.contacts()) {
        // The sponge touches a tenth of a second before it is fully compressed.
        assert_near_times(contact, [start - DEPTH / 0.05, end + DEPTH / 0.05]);
        assert!(
            (contact.mean_normal_force + PRESS).abs() < 0.6,
            "{contact:?}"
        );
    }
    assert!(
        (told.performance.mean - swept(&task(80, STEEP))).abs() < 0.02,
        "{:?}",
        told.performance
    );
    assert!(told.force_bias.abs() < 0.1);
}
