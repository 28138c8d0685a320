//! Logs in which the tool presses on two boards of different heights, or for a part of its strokes only.

use super::log::{DEPTH, Hand, PRESS, STEEP, Script, task};
use super::{events, interpreted, interpreted_with};
use wisch::geometry::{Point2, Vector3};
use wisch::interpret::{Diagnosis, Doubt, EventKind, InterpretConfig, Interpretation, TouchSample};

/// Travel over which the tool rises to a higher board [m].
const RAMP: f64 = 0.01;

/// Four strokes along x.
fn four_strokes() -> Script {
    let stroke = |row: i32| {
        let (y, x) = (
            0.06 * (f64::from(row) - 1.5),
            if row % 2 == 0 { 0.16 } else { -0.16 },
        );
        [Point2::new(-x, y), Point2::new(x, y)]
    };
    Script {
        strokes: (0..4).map(stroke).collect(),
        rate: 200.0,
        force_noise: 0.1,
        ..Script::default()
    }
}

/// Share of a step at a distance behind its edge [1].
fn risen(distance: f64) -> f64 {
    (distance / RAMP + 0.5).clamp(0.0, 1.0)
}

/// The log of a script whose tool is raised by a height at places [m].
fn raised(script: &Script, by: impl Fn(Point2) -> f64) -> Vec<TouchSample> {
    let task = task(80, STEEP);
    let surface = task.surface.world_from_surface;
    let raise = |mut sample: TouchSample| {
        let place = (surface.inverse() * sample.world_from_tool)
            .translation
            .vector
            .xy();
        let up = surface.rotation * Vector3::z() * by(place.into());
        sample.world_from_tool.translation.vector += up;
        sample
    };
    script.samples(&task).into_iter().map(raise).collect()
}

fn read(samples: &[TouchSample]) -> Interpretation {
    let task = task(80, STEEP);
    interpreted_with(samples, &task, &InterpretConfig::from_task(&task))
}

fn by_hand(found: &Interpretation) -> usize {
    let events = found.events.iter();
    events.filter(|event| event.kind.is_by_hand()).count()
}

/// Asserts that contacts are reported at the heights 0 and `step` [m], half of them at each.
fn assert_two_heights(found: &Interpretation, step: f64, what: &str) {
    let is_heights = |doubt: &&Doubt| matches!(doubt, Doubt::SeveralHeights { .. });
    let Some(doubt) = found.doubts.iter().find(is_heights) else {
        panic!("{what}: {:?}", found.doubts);
    };
    let Doubt::SeveralHeights { levels, contacts } = doubt else {
        unreachable!();
    };
    for (level, expected) in levels.iter().zip([step.min(0.0), step.max(0.0)]) {
        assert!((level.height - expected).abs() < 3e-4, "{what}: {levels:?}");
        let share = level.contacts as f64 / *contacts as f64;
        assert!(
            (0.4..0.6).contains(&share),
            "{what}: {levels:?} of {contacts}"
        );
    }
    assert_eq!(levels[2].contacts, 0, "{what}");
    assert!(doubt.is_decisive() && !found.is_conclusive(), "{what}");
    assert_eq!(
        found.diagnosis,
        Diagnosis::Localized,
        "{what}: {:?}",
        found.plane
    );
    assert_eq!(by_hand(found), 0, "{what}: {:?}", found.events);
    let text = doubt.to_string();
    let expected = format!("at {:+.1} mm", 1e3 * levels[1].height);
    assert!(
        text.starts_with("the contacts lie at two heights") && text.contains(&expected),
        "{text}"
    );
}

#[test]
fn two_boards_of_different_heights_are_named_and_nobody_pushes() {
    for rate in [50.0, 200.0] {
        let script = Script {
            rate,
            ..four_strokes()
        };
        for step in [0.002, 0.003, 0.006, 0.015, 0.03, -0.006] {
            let between = read(&raised(&script, |place| step * risen(place.y)));
            assert_two_heights(
                &between,
                step,
                &format!("between strokes, {step} m, {rate} Hz"),
            );
            let along = read(&raised(&script, |place| step * risen(place.x)));
            assert_two_heights(&along, step, &format!("along strokes, {step} m, {rate} Hz"));
        }
    }
}

/// Through two or three strokes there is always a smooth surface, but the force on an inclined one has a part across the strokes.
#[test]
fn one_of_few_strokes_on_another_board_is_no_push() {
    for count in [2, 3] {
        let strokes = Script::default().strokes;
        let script = Script {
            strokes: strokes[..count].to_vec(),
            rate: 200.0,
            force_noise: 0.1,
            ..Script::default()
        };
        for row in 0..count {
            for step in [0.01, 0.03, 0.05, -0.04] {
                let y = script.strokes[row][0].y;
                let by = |place: Point2| step * risen(0.04 - (place.y - y).abs());
                let found = read(&raised(&script, by));
                let what = format!("stroke {row} of {count}, {step} m: {:?}", found.doubts);
                assert_eq!(by_hand(&found), 0, "{what}");
                assert!(!found.is_conclusive(), "{what}");
                let Some(Doubt::SeveralHeights { levels, .. }) = found.doubts.first() else {
                    panic!("{what}");
                };
                let apart = levels[1].height - levels[0].height;
                assert!((apart - step.abs()).abs() < 6e-4, "{what}");
                let is_bias = |doubt: &Doubt| matches!(doubt, Doubt::BiasChange { .. });
                assert!(!found.doubts.iter().any(is_bias), "{what}");
            }
        }
    }
}

/// A person who lifts the tool for a part of a stroke makes no second board, and a level board has one height.
#[test]
fn one_board_has_one_height() {
    let plain = four_strokes();
    let contacts = plain.contacts();
    let hand = |row: usize| Hand {
        start: contacts[row][0] + 0.8,
        end: contacts[row][0] + 1.6,
        off: Vector3::z() * 0.02,
        force: Vector3::z() * PRESS,
    };
    let is_heights = |doubt: &Doubt| matches!(doubt, Doubt::SeveralHeights { .. });
    let lifted = interpreted(&Script {
        hands: vec![hand(1)],
        ..plain.clone()
    });
    assert!(!lifted.doubts.iter().any(is_heights), "{:?}", lifted.doubts);
    assert_eq!(events(&lifted, EventKind::Push).len(), 1);
    let tilted = read(&raised(&plain, |place| 0.03 * place.y - 0.02 * place.x));
    assert_eq!(tilted.doubts, []);
    // The force differs, and the stiffness is not known well: the heights that follow from both differ.
    let pressed = interpreted(&Script {
        press: |place| PRESS * (1.0 - 0.12 * risen(place.x)),
        ..plain
    });
    assert!(
        !pressed.doubts.iter().any(is_heights),
        "{:?}",
        pressed.doubts
    );
}

/// The tool presses with a force where x is negative, and hovers over the rest without force. It compresses by `depth` under the
/// nominal force.
fn read_hovering(force: f64, clearance: f64, depth: f64) -> Interpretation {
    let press: fn(Point2) -> f64 = match force {
        6.0 => |place| if place.x < 0.0 { 6.0 } else { 0.0 },
        8.0 => |place| if place.x < 0.0 { 8.0 } else { 0.0 },
        _ => |place| if place.x < 0.0 { PRESS } else { 0.0 },
    };
    let script = Script {
        press,
        ..four_strokes()
    };
    // The script's tool compresses by `DEPTH`.
    let shorter = DEPTH - depth;
    let samples = raised(&script, |place| {
        if place.x < 0.0 {
            -shorter * (1.0 - force / PRESS)
        } else {
            clearance - shorter
        }
    });
    let mut task = task(80, STEEP);
    task.interaction.compression_depth_m = depth;
    interpreted_with(&samples, &task, &InterpretConfig::from_task(&task))
}

#[test]
fn contact_of_a_tool_that_hovers_for_half_of_each_stroke_is_found() {
    for depth in [DEPTH, 0.0005] {
        for force in [6.0, 8.0, PRESS] {
            for clearance in [0.001, 0.003, 0.006] {
                let what = format!("{force} N, {clearance} m, depth {depth} m");
                let found = read_hovering(force, clearance, depth);
                let doubts = &found.doubts;
                let share = found.contact_share.unwrap_or(0.0);
                assert!((0.35..0.6).contains(&share), "{what}: {share}, {doubts:?}");
                let pressed = found.pressed_force.unwrap_or(0.0);
                assert!((pressed - force).abs() < 0.3, "{what}: {pressed}");
                assert_eq!(events(&found, EventKind::Contact).len(), 4, "{what}");
                assert_eq!(by_hand(&found), 0, "{what}");
                let is_missing = |doubt: &Doubt| matches!(doubt, Doubt::NoContactForce { .. });
                assert!(!doubts.iter().any(is_missing), "{what}: {doubts:?}");
            }
        }
    }
}
