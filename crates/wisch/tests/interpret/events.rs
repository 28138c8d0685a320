//! Collisions, losses of contact, stick-slip: their times, and no event where nothing happens.

use super::log::{DEPTH, Hand, PRESS, STEEP, Script, task};
use super::{assert_near_times, events, exact, interpreted, interpreted_with};
use wisch::geometry::{Point2, Vector3};
use wisch::interpret::{
    Belief, Diagnosis, Doubt, Event, EventKind, InterpretConfig, Interpreter, Touch, TouchSample,
    Uncertainty,
};
use wisch::recover::{Verdict, limit_verdict};
use wisch::represent::{Action, Fate, GoalState, Task};

/// A hand that lifts the sponge on the second stroke by 2 cm, with the force of contact.
pub fn lifted() -> Script {
    let script = Script::default();
    let [start, _] = script.contacts()[1];
    Script {
        hands: vec![Hand {
            start: start + 1.2,
            end: start + 2.0,
            off: Vector3::new(0.0, 0.0, 0.02),
            force: Vector3::new(0.0, 0.0, PRESS),
        }],
        ..script
    }
}

#[test]
fn steady_friction_is_no_push() {
    let by_hand = |script: &Script| -> Vec<Event> {
        let events = interpreted(script).events;
        events
            .into_iter()
            .filter(|event| event.kind.is_by_hand())
            .collect()
    };
    for (friction, speed) in [(0.4, 0.1), (1.0, 0.1), (1.6, 0.1), (2.0, 0.02)] {
        let script = Script {
            friction,
            speed,
            ..Script::default()
        };
        let found = by_hand(&script);
        assert!(found.is_empty(), "at {friction}: {found:?}");
        // A hand that drags the tool harder than friction does is still found.
        let [start, end] = script.contacts()[1];
        let middle = 0.5 * (start + end);
        let hand = Hand {
            start: middle - 0.3,
            end: middle + 0.3,
            off: Vector3::zeros(),
            force: Vector3::new(-45.0, 0.0, PRESS),
        };
        let pushed = by_hand(&Script {
            hands: vec![hand],
            ..script
        });
        assert_eq!(pushed.len(), 1, "at {friction}: {pushed:?}");
    }
}

#[test]
fn friction_that_vanishes_with_the_normal_force_is_no_push() {
    // The tool sticks and slips, and presses with 0 to 12 N.
    let hopping = Script {
        press: |place| 6.0 + 6.0 * (60.0 * place.x).sin(),
        friction: 1.4,
        stick_slip: 8.0,
        ..Script::default()
    };
    assert_eq!(events(&interpreted(&hopping), EventKind::Push), []);
    let [start, _] = hopping.contacts()[1];
    let pulled = Script {
        hands: vec![Hand {
            start: start + 1.2,
            end: start + 2.0,
            off: Vector3::zeros(),
            force: Vector3::new(0.0, 16.0, 6.0),
        }],
        ..hopping
    };
    assert_eq!(events(&interpreted(&pulled), EventKind::Push).len(), 1);
}

/// The force sensor stops within the second stroke, and the poses go on.
#[test]
fn sliding_without_forces_leaves_a_lower_bound_and_no_claim_of_a_collect() {
    let mut task = task(80, STEEP);
    let config = InterpretConfig::from_task(&task);
    let script = Script::default();
    let [_, end] = script.contacts()[0];
    let samples = script.samples(&task);
    let (logged, alone): (Vec<TouchSample>, Vec<TouchSample>) =
        (samples.into_iter()).partition(|sample| sample.time < end + 0.5);
    let conclude = |poses: &[TouchSample]| {
        let mut interpreter = Interpreter::new(&task, &config).unwrap();
        for sample in &logged {
            interpreter.push(sample).unwrap();
        }
        for sample in poses {
            interpreter.note_pose(sample.time, &sample.world_from_tool);
        }
        let believed = Belief::from_particles(task.particles.clone());
        interpreter
            .conclude(&believed, &GoalState::Absorbed)
            .unwrap()
    };
    assert!(!conclude(&[]).is_lower_bound());
    let found = conclude(&alone);
    assert!(found.is_lower_bound(), "{:?}", found.doubts);
    // Two strokes at full contact.
    let [[start, _], [_, last]] = [script.contacts()[1], script.contacts()[2]];
    let [Doubt::Incomplete { missing, .. }] = found.doubts[..] else {
        panic!("{:?}", found.doubts);
    };
    assert!(
        missing > 0.5 * (last - start) && missing < last - start,
        "{missing}"
    );
    let claimed = |task: &Task| limit_verdict(Verdict::GoalMet, task, &found, 0.9);
    assert_eq!(found.range(Action::Absorb), [found.performance.low, 1.0]);
    assert_eq!(found.range(Action::Collect), [0.0, 1.0]);
    task.action = Action::Absorb;
    assert_eq!(claimed(&task), Verdict::GoalMet);
    for action in [Action::Collect, Action::Polish, Action::Dispense] {
        task.action = action;
        assert_eq!(claimed(&task), Verdict::Undecidable);
    }
}

#[test]
fn many_short_gaps_leave_a_lower_bound() {
    let task = task(80, STEEP);
    let config = InterpretConfig::from_task(&task);
    let mut samples = Script::default().samples(&task);
    let whole = interpreted_with(&samples, &task, &config);
    assert!(!whole.is_lower_bound());
    // The log keeps a sixth of each second.
    samples.retain(|sample| sample.time.fract() < 1.0 / 6.0);
    let part = interpreted_with(&samples, &task, &config);
    assert!(part.is_lower_bound(), "{:?}", part.doubts);
    // A gap of 1.2 s within the second stroke.
    let script = Script::default();
    let [start, _] = script.contacts()[1];
    let mut samples = script.samples(&task);
    samples.retain(|sample| !(start + 1.0..start + 2.2).contains(&sample.time));
    let contacts = events(
        &interpreted_with(&samples, &task, &config),
        EventKind::Contact,
    );
    assert_eq!(contacts.len(), 4, "{contacts:?}");
}

#[test]
fn a_force_that_varies_about_the_declared_one_presses_with_it() {
    let script = Script {
        press: |at| PRESS + 5.0 * (60.0 * at.x).sin(),
        ..Script::default()
    };
    let pressed = interpreted(&script).pressed_force.unwrap();
    assert!((pressed - PRESS).abs() < 1.0, "{pressed} N");
}

#[test]
fn a_hand_that_lifts_the_tool_is_a_collision_and_what_lies_under_it_stays() {
    let script = lifted();
    let interpretation = interpreted(&script);
    let collisions = events(&interpretation, EventKind::Push);
    let hand = script.hands[0];
    assert_eq!(collisions.len(), 1, "{collisions:?}");
    assert_near_times(&collisions[0], [hand.start, hand.end]);
    assert!((collisions[0].peak_height - 0.02).abs() < 2e-3);
    assert_eq!(events(&interpretation, EventKind::ContactLoss), []);
    assert_eq!(events(&interpretation, EventKind::Contact).len(), 4);
    let false_positives =
        (interpretation.path.iter()).filter(|piece| piece.touch == Touch::FalsePositive);
    let times: Vec<f64> = false_positives.map(|piece| piece.time[1]).collect();
    assert!(times.len() > 70);
    assert!(
        times
            .iter()
            .all(|time| (hand.start..hand.end + 0.01).contains(time)),
        "{times:?}"
    );
    // The stroke runs from +0.16 at 0.1 m/s: lifted between 0.04 and -0.04, of which the sponge covers
    // from either side all but 1 cm. Nothing there is wiped.
    let task = task(2000, STEEP);
    let interpretation = interpreted_with(&script.samples(&task), &task, &exact(&task));
    let under: Vec<usize> = (0..task.particles.len())
        .filter(|&i| {
            let place = task.particles.position(i);
            place.x.abs() < 0.003 && place.y.abs() < 0.028
        })
        .collect();
    assert!(under.len() > 2);
    for replay in interpretation.belief.members() {
        assert!(under.iter().all(|&i| replay.fate(i) == Fate::OnSurface));
    }
}

#[test]
fn pushes_from_every_side_are_collisions_with_start_and_end() {
    let script = Script::default();
    let [start, _] = script.contacts()[1];
    let pushes = [
        // Up, off the surface.
        (Vector3::new(0.0, 0.0, 0.015), Vector3::new(0.0, 0.0, 15.0)),
        // To the side: the saturating controller yields and presses less.
        (Vector3::new(0.0, 0.03, 0.0), Vector3::new(0.0, 15.0, 5.0)),
        // Down: the sponge gives way beyond its nominal compression.
        (
            Vector3::new(0.0, 0.0, -0.0075),
            Vector3::new(0.0, 0.0, 10.0),
        ),
    ];
    for (off, force) in pushes {
        let hand = Hand {
            start: start + 1.0,
            end: start + 1.5,
            off,
            force,
        };
        let interpretation = interpreted(&Script {
            hands: vec![hand],
            ..script.clone()
        });
        let collisions = events(&interpretation, EventKind::Push);
        assert_eq!(collisions.len(), 1, "{force}: {collisions:?}");
        assert_near_times(&collisions[0], [hand.start, hand.end]);
    }
}

/// A friction that is a little higher than usual for a while is no push.
#[test]
fn a_push_begins_where_its_force_rises() {
    let script = Script::default();
    let [start, _] = script.contacts()[1];
    let hand = |start: f64, end: f64, off: f64, force: [f64; 2]| Hand {
        start,
        end,
        off: Vector3::new(0.0, off, 0.0),
        force: Vector3::new(0.0, force[0], force[1]),
    };
    let push = hand(start + 1.3, start + 1.8, 0.03, [15.0, 5.0]);
    let drag = hand(start + 0.5, push.start, 0.0, [3.0, 0.0]);
    let interpretation = interpreted(&Script {
        hands: vec![drag, push],
        ..script
    });
    let collisions = events(&interpretation, EventKind::Push);
    assert_eq!(collisions.len(), 1, "{collisions:?}");
    assert_near_times(&collisions[0], [push.start, push.end]);
}

#[test]
fn a_gap_in_the_press_is_a_loss_of_contact() {
    let script = Script {
        press: |place| {
            if place.x.abs() < 0.03 && place.y.abs() < 0.01 {
                0.0
            } else {
                PRESS
            }
        },
        ..Script::default()
    };
    let interpretation = interpreted(&script);
    let losses = events(&interpretation, EventKind::ContactLoss);
    assert_eq!(losses.len(), 1, "{:?}", interpretation.events);
    let [start, _] = script.contacts()[1];
    assert_near_times(&losses[0], [start + 1.3, start + 1.9]);
    assert_eq!(events(&interpretation, EventKind::Push), []);
    let whole = interpreted(&Script::default());
    assert!(interpretation.contact_share.unwrap() < whole.contact_share.unwrap() - 0.03);
}

/// Forces estimated from drives lag; then the sponge seems to be pressed while it already lifts off.
#[test]
fn forces_that_lag_raise_no_alarm_and_hide_none() {
    for force_lag in [0.01, 0.02, 0.04] {
        let calm = interpreted(&Script {
            force_lag,
            ..Script::default()
        });
        assert_eq!(events(&calm, EventKind::Push), [], "{force_lag}");
        assert_eq!(events(&calm, EventKind::Contact).len(), 3);
        assert_eq!(calm.diagnosis, Diagnosis::Localized);
    }
    let script = Script {
        force_lag: 0.02,
        ..lifted()
    };
    let collisions = events(&interpreted(&script), EventKind::Push);
    assert_eq!(collisions.len(), 1);
    assert_near_times(&collisions[0], [script.hands[0].start, script.hands[0].end]);
}

/// The force decays after each contact, while the tool already rises.
#[test]
fn the_tail_of_a_slow_filter_is_no_push() {
    for force_lag in [0.1, 0.2, 0.3, 0.5] {
        let calm = interpreted(&Script {
            force_lag,
            ..Script::default()
        });
        let by_hand = calm.events.iter().filter(|event| event.kind.is_by_hand());
        assert_eq!(by_hand.count(), 0, "{force_lag}: {:?}", calm.events);
        assert_eq!(events(&calm, EventKind::Contact).len(), 3, "{force_lag}");
    }
    // A hand that holds the tool after a stroke gives no such tail.
    let script = Script {
        force_lag: 0.1,
        ..Script::default()
    };
    let [_, end] = script.contacts()[0];
    let held = interpreted(&Script {
        hands: vec![Hand {
            start: end + 0.2,
            end: end + 0.8,
            off: Vector3::new(0.0, 0.0, 0.02),
            force: Vector3::new(0.0, 0.0, PRESS),
        }],
        ..script
    });
    let by_hand = held.events.iter().filter(|event| event.kind.is_by_hand());
    assert_eq!(by_hand.count(), 1, "{:?}", held.events);
}

#[test]
fn sticking_and_slipping_is_noticed() {
    for (stick_slip, speed) in [(4.0, 0.1), (8.0, 0.1), (4.0, 0.02)] {
        let script = Script {
            stick_slip,
            speed,
            ..Script::default()
        };
        let interpretation = interpreted(&script);
        let found = events(&interpretation, EventKind::StickSlip);
        assert_eq!(found.len(), 3, "{found:?}");
        for (event, [start, end]) in found.iter().zip(script.contacts()) {
            assert!(
                event.start > start - 0.05 && event.start < start + 0.5,
                "{event:?}"
            );
            assert!(event.end < end + 0.05 && event.end > end - 0.5, "{event:?}");
        }
        assert_eq!(events(&interpretation, EventKind::Push), []);
    }
}

#[test]
fn a_slow_stroke_does_not_stick() {
    for speed in [0.01, 0.015, 0.02] {
        let calm = interpreted(&Script {
            speed,
            ..Script::default()
        });
        assert_eq!(events(&calm, EventKind::StickSlip), [], "{speed} m/s");
    }
}

/// Half over the edge the sponge gives way twice as far: that is wiping, not a push.
#[test]
fn a_tool_that_sinks_over_an_edge_is_still_in_contact() {
    let stroke = |x: f64| {
        vec![
            [Point2::new(-0.1, 0.0), Point2::new(0.1, 0.0)],
            [Point2::new(x, -0.1), Point2::new(x, 0.1)],
        ]
    };
    fn lower(by: f64, place: Point2) -> f64 {
        if place.y.abs() < 0.08 && place.y != 0.0 {
            -by
        } else {
            0.0
        }
    }
    let sunk = |x: f64, surface: fn(Point2) -> f64| Script {
        strokes: stroke(x),
        surface,
        ..Script::default()
    };
    let lowers: [fn(Point2) -> f64; 2] = [
        |place| lower(0.0045, place),
        // It tips over the edge.
        |place| lower(0.012, place),
    ];
    for lower in lowers {
        let at_edge = interpreted(&sunk(0.19, lower));
        assert_eq!(events(&at_edge, EventKind::Push), []);
        let inland = interpreted(&sunk(0.05, lower));
        assert_eq!(events(&inland, EventKind::Push).len(), 1);
    }
}

/// A hand that is at the tool while the robot lifts it, or from the surface on.
fn held(times: &[[f64; 2]], off: Vector3, force: Vector3) -> Script {
    let hand = |&[start, end]: &[f64; 2]| Hand {
        start,
        end,
        off,
        force,
    };
    Script {
        hands: times.iter().map(hand).collect(),
        ..Script::default()
    }
}

#[test]
fn any_force_in_free_motion_is_somebody() {
    let [_, end] = Script::default().contacts()[0];
    // Lifted for a second, moved aside, lowered.
    let free = [end + 0.7, end + 1.2];
    for force in [
        Vector3::new(0.0, 8.0, 0.0),
        Vector3::new(-6.0, 0.0, -6.0),
        Vector3::new(0.0, 0.0, 8.0),
        Vector3::new(0.0, 0.0, -8.0),
    ] {
        let interpretation = interpreted(&held(&[free], Vector3::new(0.0, 0.01, 0.0), force));
        let collisions = events(&interpretation, EventKind::Push);
        assert_eq!(collisions.len(), 1, "{force}: {collisions:?}");
        assert_near_times(&collisions[0], free);
    }
    // The inertia of the gripper and noise are no push.
    let faint = held(&[free], Vector3::zeros(), Vector3::new(0.0, 1.5, 0.0));
    assert_eq!(events(&interpreted(&faint), EventKind::Push), []);
}

#[test]
fn a_force_that_swings_is_nobody() {
    let [_, end] = Script::default().contacts()[0];
    // The inertia of a long tool in free motion: back and forth every 40 ms.
    let hand = |i: u32| {
        let start = end + 0.7 + 0.04 * f64::from(i);
        let size = if i.is_multiple_of(2) { 20.0 } else { -20.0 };
        Hand {
            start,
            end: start + 0.04,
            off: Vector3::zeros(),
            force: Vector3::new(0.0, 0.0, size),
        }
    };
    let mut swinging = Script {
        hands: (0..10).map(hand).collect(),
        ..Script::default()
    };
    assert_eq!(events(&interpreted(&swinging), EventKind::Push), []);
    assert_eq!(
        events(&interpreted(&swinging), EventKind::Vibration).len(),
        1
    );
    for hand in &mut swinging.hands {
        hand.force = Vector3::new(0.0, 0.0, 20.0);
    }
    assert_eq!(events(&interpreted(&swinging), EventKind::Push).len(), 1);
}

#[test]
fn a_tool_that_comes_down_hard_has_not_been_pushed() {
    let [start, _] = Script::default().contacts()[1];
    let blow = Vector3::new(0.0, 0.0, 25.0);
    let pressed = Vector3::new(0.0, 0.0, -0.0075);
    let landing = held(&[[start, start + 0.1]], pressed, blow);
    assert_eq!(events(&interpreted(&landing), EventKind::Push), []);
    let landing = interpreted(&landing);
    assert_eq!(events(&landing, EventKind::Landing).len(), 1);
    assert_eq!(events(&landing, EventKind::Overload), []);
}

/// The surface bears the force that compresses the sponge to this depth, with or without a person.
/// Normal force of a tool of another stiffness than declared, which is compressed by `depth` [m] at nominal force.
fn with_depth(script: &Script, depth: f64) -> Vec<TouchSample> {
    let task = task(80, STEEP);
    let surface = task.surface.world_from_surface;
    let real = (script.surface)(Point2::origin());
    let soften = |sample: TouchSample| {
        let height = (surface.inverse() * sample.world_from_tool).translation.z - real;
        let mut force = surface.rotation.inverse() * sample.force;
        let [declared, own] =
            [DEPTH, depth].map(|depth| PRESS * (1.0 - height / depth).clamp(0.0, 1.0));
        force.z += own - declared;
        TouchSample {
            force: surface.rotation * force,
            ..sample
        }
    };
    script.samples(&task).into_iter().map(soften).collect()
}

#[test]
fn a_softer_tool_touches_earlier_and_nobody_pushes() {
    let task = task(80, STEEP);
    let surfaces: [fn(Point2) -> f64; 2] = [|_| 0.0, |_| 0.006];
    for depth in [2.0 * DEPTH, 3.4 * DEPTH, 6.0 * DEPTH] {
        for surface in surfaces {
            let script = Script {
                surface,
                force_noise: 0.1,
                ..Script::default()
            };
            let config = InterpretConfig::from_task(&task);
            let found = interpreted_with(&with_depth(&script, depth), &task, &config);
            assert_eq!(events(&found, EventKind::Push), [], "{depth}");
            // A hand that holds the tool on its way down is found.
            let [start, _] = script.contacts()[1];
            let hand = Hand {
                start: start - 0.9,
                end: start - 0.5,
                off: Vector3::zeros(),
                force: Vector3::z() * 8.0,
            };
            let hands = vec![hand];
            let held = Script { hands, ..script };
            let found = interpreted_with(&with_depth(&held, depth), &task, &config);
            assert_eq!(events(&found, EventKind::Push).len(), 1, "{depth}");
        }
    }
}

#[test]
fn pressing_too_hard_is_an_overload_and_no_push() {
    let [start, _] = Script::default().contacts()[1];
    let stiff = Vector3::zeros();
    for (off, force) in [(-0.0075, 25.0), (-0.0125, 35.0)] {
        let off = Vector3::new(0.0, 0.0, off);
        for times in [[start, start + 0.8], [start + 1.0, start + 1.6]] {
            // A tool that compresses as its spring does, and one that compresses no further.
            for off in [off, stiff] {
                let script = held(&[times], off, Vector3::new(0.0, 0.0, force));
                let interpretation = interpreted(&script);
                assert_eq!(events(&interpretation, EventKind::Push), []);
                let overloads = events(&interpretation, EventKind::Overload);
                assert_eq!(overloads.len(), 1, "{off} {force}: {overloads:?}");
                assert_near_times(&overloads[0], times);
                let amid = 0.5 * (times[0] + times[1]);
                let piece = interpretation.path.iter().find(|p| p.time[1] > amid);
                assert_eq!(piece.unwrap().touch, Touch::Confident);
            }
        }
    }
}

#[test]
fn who_leads_the_tool_all_the_time_does_not_push_it() {
    let [_, end] = Script::default().contacts()[2];
    // A hand that circles, in alternating directions.
    let hand = |i: u32| {
        let start = 0.5 + 0.7 * f64::from(i);
        let (sin, cos) = (1.8 * f64::from(i)).sin_cos();
        Hand {
            start,
            end: start + 0.7,
            off: Vector3::new(0.0, 0.0, 0.03),
            force: Vector3::new(9.0 * cos, 9.0 * sin, 2.0),
        }
    };
    let script = Script {
        hands: (0..((end - 0.5) / 0.7) as u32).map(hand).collect(),
        ..Script::default()
    };
    let interpretation = interpreted(&script);
    assert_eq!(events(&interpretation, EventKind::Push), []);
    assert!(!events(&interpretation, EventKind::HandGuiding).is_empty());
    assert!(
        matches!(interpretation.doubts[0], Doubt::HandGuided { share } if share > 0.8),
        "{:?}",
        interpretation.doubts
    );
}

/// A tool at rest that no longer presses has lost contact, like a moving one.
#[test]
fn contact_that_is_lost_at_rest_is_detected() {
    let [start, _] = Script::default().contacts()[1];
    // Held still for half a second, a finger's breadth off the surface, without force.
    let times = [start + 1.0, start + 1.5];
    let mut script = held(&[times], Vector3::new(0.0, 0.0, 0.006), Vector3::zeros());
    script.rests = vec![times];
    let interpretation = interpreted(&script);
    let losses = events(&interpretation, EventKind::ContactLoss);
    assert_eq!(losses.len(), 1, "{:?}", interpretation.events);
    assert_near_times(&losses[0], times);
    script.hands.clear();
    assert_eq!(events(&interpreted(&script), EventKind::ContactLoss), []);
}

#[test]
fn a_push_that_lasts_into_free_motion_is_one() {
    let [_, end] = Script::default().contacts()[0];
    let up = (Vector3::new(0.0, 0.0, 0.03), Vector3::new(0.0, 0.0, 12.0));
    // The push begins on the surface and continues during the lift, in which the tool moves ahead
    // of the hand for a while.
    let whole = [end - 0.4, end + 1.2];
    let parts = [[whole[0], end + 0.4], [end + 0.55, whole[1]]];
    for times in [&[whole][..], &parts] {
        let interpretation = interpreted(&held(times, up.0, up.1));
        let collisions = events(&interpretation, EventKind::Push);
        assert_eq!(collisions.len(), 1, "{collisions:?}");
        assert_near_times(&collisions[0], whole);
    }
    // On the surface, two separate pushes are two events, unless they are less than a third of a
    // second apart.
    let start = end - 2.0;
    let soon = [[start, start + 0.4], [start + 0.55, start + 1.0]];
    let soon_after = interpreted(&held(&soon, up.0, up.1));
    let collisions = events(&soon_after, EventKind::Push);
    assert_eq!(collisions.len(), 1, "{collisions:?}");
    assert_near_times(&collisions[0], [start, start + 1.0]);
    let pair = [[start, start + 0.4], [start + 0.85, start + 1.3]];
    let interpretation = interpreted(&held(&pair, up.0, up.1));
    let collisions = events(&interpretation, EventKind::Push);
    assert_eq!(collisions.len(), 2, "{collisions:?}");
    for (collision, times) in collisions.iter().zip(pair) {
        assert_near_times(collision, times);
    }
}

#[test]
fn contact_of_a_pushed_tool_follows_from_its_place_or_its_force() {
    let task = task(400, STEEP);
    let [start, end] = Script::default().contacts()[1];
    // A hand pushes the tool and reduces its press force, but does not move it.
    let script = held(
        &[[start + 0.3, end - 0.3]],
        Vector3::zeros(),
        Vector3::new(12.0, 0.0, 1.0),
    );
    let share = |script: &Script, pushed_by_force: f64| {
        let config = InterpretConfig {
            uncertainty: Uncertainty {
                pushed_by_force,
                ..Uncertainty::NONE
            },
            ..InterpretConfig::from_task(&task)
        };
        interpreted_with(&script.samples(&task), &task, &config).performance
    };
    let calm = share(&Script::default(), 1.0).mean;
    let by_force = share(&script, 1.0).mean;
    let by_place = share(&script, 0.0).mean;
    assert!(by_force < calm - 0.06, "{by_force} of {calm}");
    assert!((by_place - calm).abs() < 0.03, "{by_place} of {calm}");
    // If both hypotheses are possible, the interval holds both values.
    let either = share(&script, 0.5);
    assert!(either.low < by_force + 0.02, "{either:?}: {by_force}");
    assert!(either.high > by_place - 0.02, "{either:?}: {by_place}");
}

#[test]
fn a_pushed_tool_may_drag_its_load_along_as_long_as_it_is_near_the_surface() {
    let task = task(400, STEEP);
    let [start, end] = Script::default().contacts()[1];
    let wiped = |lift: f64, pushed_dragging: f64| {
        // Off the plane, where neither place nor force tell of contact.
        let push = Vector3::new(12.0, 0.0, 1.0);
        let script = held(
            &[[start + 0.3, end - 0.3]],
            Vector3::new(0.0, 0.0, lift),
            push,
        );
        let config = InterpretConfig {
            uncertainty: Uncertainty {
                pushed_by_force: 0.0,
                pushed_dragging,
                ..Uncertainty::NONE
            },
            ..InterpretConfig::from_task(&task)
        };
        interpreted_with(&script.samples(&task), &task, &config)
            .performance
            .mean
    };
    assert!(wiped(0.010, 1.0) > wiped(0.010, 0.0) + 0.1);
    // Too high to drag anything.
    assert!((wiped(0.030, 1.0) - wiped(0.030, 0.0)).abs() < 0.02);
}

#[test]
fn a_log_without_wiping_has_doubts_with_reasons() {
    let doubts = |script: &Script| interpreted(script).doubts;
    assert_eq!(doubts(&Script::default()), []);
    // The surface is 0.2 m higher than believed.
    let high = interpreted(&Script {
        surface: |_| 0.2,
        ..Script::default()
    });
    assert!(!(high.events.iter()).any(|event| event.kind.is_by_hand()));
    let high = high.doubts;
    let [Doubt::ContactFarFromSurface { height, searched }] = high[..] else {
        panic!("{high:?}");
    };
    assert!((height - 0.2).abs() < 2e-3 && searched < 0.1, "{height}");
    assert!(
        high[0]
            .to_string()
            .starts_with("the tool pressed 0.200 m above")
    );
    // A slow log shows the same.
    for rate in [20.0, 50.0, 100.0, 125.0, 200.0] {
        let slow = doubts(&Script {
            surface: |_| 0.2,
            rate,
            ..Script::default()
        });
        let is_far = |doubt: &Doubt| matches!(doubt, Doubt::ContactFarFromSurface { .. });
        assert!(slow.iter().any(is_far), "{rate} Hz: {slow:?}");
    }
    // The tool presses at single places, at any height, and slides nowhere.
    let dab = |x: f64, y: f64| [Point2::new(x, y), Point2::new(x + 0.002, y)];
    let places = (0..12).map(|i| dab(-0.15 + 0.027 * f64::from(i), 0.02 * f64::from(i % 5)));
    let dabbing = doubts(&Script {
        strokes: places.collect(),
        surface: |place| 0.02 * (37.0 * place.x + 91.0 * place.y).sin(),
        ..Script::default()
    });
    let is_dabbing =
        |doubt: &Doubt| matches!(doubt, Doubt::LittleSliding { .. } | Doubt::Scattered { .. });
    assert!(dabbing.iter().any(is_dabbing), "{dabbing:?}");
    // Beside the board.
    let line = |y: f64| [Point2::new(-0.16, y), Point2::new(0.16, y)];
    let beside = doubts(&Script {
        strokes: vec![line(0.25), line(0.30)],
        ..Script::default()
    });
    assert!(
        matches!(beside[..], [Doubt::ContactBesideSurface { share }] if share > 0.99),
        "{beside:?}"
    );
}

#[test]
fn a_plane_counts_its_contacts_and_states_the_tilt_that_they_determine() {
    // Mostly pressed weakly: many contacts make the plane, few of them are confident.
    let weak = interpreted(&Script {
        press: |place| {
            if place.x.abs() < 0.12 {
                0.6 * PRESS
            } else {
                PRESS
            }
        },
        ..Script::default()
    });
    let plane = weak.plane.unwrap();
    assert!(plane.inliers <= plane.confident, "{plane:?}");
    assert_eq!(plane.directions, 2);
    let strokes = Script::default().strokes;
    let line = interpreted(&Script {
        strokes: vec![strokes[1]],
        ..Script::default()
    });
    assert_eq!(line.plane.unwrap().directions, 1);
    let spot = [Point2::new(0.0, 0.0), Point2::new(0.01, 0.0)];
    let spot = interpreted(&Script {
        strokes: vec![spot; 4],
        ..Script::default()
    });
    assert_eq!(spot.plane.unwrap().directions, 0);
}
