//! What synthetic logs tell, held against what was put into them.

#[path = "interpret/log.rs"]
mod log;

use log::{DEPTH, Hand, PRESS, STEEP, Script, task};
use proptest::prelude::*;
use wisch::geometry::{Point2, Point3, Pose, Vector3};
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

/// The board rises to one side by `degrees`, and the sponge loses it on the other.
fn tilted() -> Script {
    fn rise(place: Point2) -> f64 {
        2.0_f64.to_radians().tan() * place.x - 0.001
    }
    Script {
        surface: rise,
        // The controller's spring reaches less deep where the surface is low.
        press: |place| {
            let short = -rise(place) - 0.002;
            if short > 0.0 {
                (PRESS - short * 5000.0).max(0.0)
            } else {
                PRESS
            }
        },
        ..Script::default()
    }
}

#[test]
fn a_tilted_board_is_found_and_the_side_out_of_reach_not_wiped() {
    let told = told(&tilted());
    let task = task(80, STEEP);
    let plane = told.plane.unwrap();
    assert!((plane.tilt.to_degrees() - 2.0).abs() < 0.3, "{plane:?}");
    assert!((plane.offset + 0.001).abs() < 5e-4, "{plane:?}");
    let Diagnosis::Relocalize { world_from_surface } = told.diagnosis else {
        panic!("{:?}", told.diagnosis);
    };
    // Where the real surface is, point by point.
    for place in [
        Point2::new(0.2, 0.14),
        Point2::new(-0.2, 0.14),
        Point2::new(0.0, -0.14),
    ] {
        let real = task.surface.world_from_surface.inverse()
            * (world_from_surface * Point3::new(place.x, place.y, 0.0));
        let surface = (tilted().surface)(Point2::new(real.x, real.y));
        assert!(
            (real.z - surface).abs() < 2e-3,
            "{place}: {} {surface}",
            real.z
        );
    }
    // No force where the surface lies more than 4 mm too low.
    let lost_below = -0.003 / 2.0_f64.to_radians().tan();
    assert!((-0.09..-0.08).contains(&lost_below));
    for replay in told.belief.replays() {
        for (i, (_, fate)) in replay.iter().enumerate() {
            let place = task.particles.position(i);
            if place.x < lost_below - 0.036 {
                assert_eq!(fate, Fate::OnSurface);
            } else if place.x > 0.0 && place.x < 0.18 && place.y.abs() < 0.13 {
                assert!(
                    fate == Fate::Absorbed || (place.y.abs() - 0.055).abs() < 0.04,
                    "{place}"
                );
            }
        }
    }
}

/// A hand that lifts the sponge on the second stroke by 2 cm, with the force of contact.
fn lifted() -> Script {
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
fn a_hand_that_lifts_the_tool_is_a_collision_and_what_lies_under_it_stays() {
    let script = lifted();
    let told = told(&script);
    let collisions = events(&told, EventKind::Collision);
    let hand = script.hands[0];
    assert_eq!(collisions.len(), 1, "{collisions:?}");
    assert_near_times(&collisions[0], [hand.start, hand.end]);
    assert!((collisions[0].peak_height - 0.02).abs() < 2e-3);
    assert_eq!(events(&told, EventKind::ContactLoss), []);
    assert_eq!(events(&told, EventKind::Contact).len(), 4);
    let false_positives = (told.path.iter()).filter(|piece| piece.touch == Touch::FalsePositive);
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
    let told = told_with(&script.samples(&task), &task, &InterpretConfig::of(&task));
    let under: Vec<usize> = (0..task.particles.len())
        .filter(|&i| {
            let place = task.particles.position(i);
            place.x.abs() < 0.003 && place.y.abs() < 0.028
        })
        .collect();
    assert!(under.len() > 2);
    for replay in told.belief.replays() {
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
        // Aside: the saturated controller gives way and presses less.
        (Vector3::new(0.0, 0.03, 0.0), Vector3::new(0.0, 15.0, 5.0)),
        // Down: the sponge gives way beyond its nominal compression.
        (
            Vector3::new(0.0, 0.0, -0.0075),
            Vector3::new(0.0, 0.0, 10.0),
        ),
        // Down where the sensor sees it.
        (
            Vector3::new(0.0, 0.0, -0.0075),
            Vector3::new(0.0, 0.0, 25.0),
        ),
    ];
    for (off, force) in pushes {
        let hand = Hand {
            start: start + 1.0,
            end: start + 1.5,
            off,
            force,
        };
        let told = told(&Script {
            hands: vec![hand],
            ..script.clone()
        });
        let collisions = events(&told, EventKind::Collision);
        assert_eq!(collisions.len(), 1, "{force}: {collisions:?}");
        assert_near_times(&collisions[0], [hand.start, hand.end]);
    }
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
    let told = told(&script);
    let losses = events(&told, EventKind::ContactLoss);
    assert_eq!(losses.len(), 1, "{:?}", told.events);
    let [start, _] = script.contacts()[1];
    assert_near_times(&losses[0], [start + 1.3, start + 1.9]);
    assert_eq!(events(&told, EventKind::Collision), []);
    let whole = told_with(
        &Script::default().samples(&task(80, STEEP)),
        &task(80, STEEP),
        &InterpretConfig::of(&task(80, STEEP)),
    );
    assert!(told.contact_share < whole.contact_share - 0.03);
}

#[test]
fn without_contact_nothing_is_said_and_nothing_wiped() {
    let script = Script {
        surface: |_| -0.1,
        press: |_| 0.0,
        ..Script::default()
    };
    let told = told(&script);
    assert_eq!(told.diagnosis, Diagnosis::NoContact);
    assert_eq!(told.plane, None);
    assert_eq!(told.events, []);
    assert_eq!(told.performance.high, 0.0);
    let task = task(80, STEEP);
    let few = &script.samples(&task)[..3];
    let none: &[TouchSample] = &[];
    for samples in [few, none] {
        let told = told_with(samples, &task, &InterpretConfig::of(&task));
        assert_eq!(told.diagnosis, Diagnosis::NoContact);
        assert_eq!(told.performance.mean, 0.0);
    }
}

#[test]
fn a_bias_of_the_sensor_is_found_and_taken_off() {
    let plain = told(&Script::default());
    for bias in [-1.0, 1.0] {
        let told = told(&Script {
            bias,
            ..Script::default()
        });
        // f_ext,n is negative where the tool presses: what pushes it up counts as negative.
        assert!((told.force_bias + bias).abs() < 0.1, "{}", told.force_bias);
        assert!((told.performance.mean - plain.performance.mean).abs() < 0.01);
        assert_eq!(told.events.len(), plain.events.len());
    }
    // Never free: nothing tells a bias.
    let task = task(80, STEEP);
    let script = Script {
        bias: 1.0,
        ..Script::default()
    };
    let [start, end] = script.contacts()[0];
    let samples: Vec<TouchSample> = (script.samples(&task).into_iter())
        .filter(|sample| (start..end).contains(&sample.time))
        .collect();
    let told = told_with(&samples, &task, &InterpretConfig::of(&task));
    assert_eq!(told.force_bias, 0.0);
}

#[test]
fn one_stroke_tells_height_and_slope_along_itself() {
    let script = Script {
        strokes: vec![[Point2::new(-0.16, 0.05), Point2::new(0.16, 0.05)]],
        surface: |place| 0.02 * place.x + 0.005,
        ..Script::default()
    };
    let plane = told(&script).plane.unwrap();
    assert!(
        (plane.normal.x / -plane.normal.z - 0.02).abs() < 2e-3,
        "{plane:?}"
    );
    assert!(plane.normal.y.abs() < 1e-4);
    assert!((plane.offset - 0.005).abs() < 5e-4);
}

#[test]
fn a_log_at_100_hz_tells_what_one_at_1_khz_does() {
    let task = task(2000, STEEP);
    let config = InterpretConfig::of(&task);
    for script in [Script::default(), tilted(), lifted()] {
        let fast = script.samples(&task);
        let slow: Vec<TouchSample> = fast.iter().copied().step_by(10).collect();
        let (fast, slow) = (
            told_with(&fast, &task, &config),
            told_with(&slow, &task, &config),
        );
        let apart = (fast.performance.mean - slow.performance.mean).abs();
        assert!(
            apart <= 0.02,
            "{} {}",
            fast.performance.mean,
            slow.performance.mean
        );
        let kinds = |told: &Interpretation| told.events.iter().map(|e| e.kind).collect::<Vec<_>>();
        assert_eq!(kinds(&fast), kinds(&slow));
    }
}

/// One stroke at a share of the force that reaches the board's whole height: what is wiped is P(X ≤ f′).
fn share_affected(likelihood: LogNormal, press: fn(Point2) -> f64) -> f64 {
    let task = task(4000, likelihood);
    let script = Script {
        strokes: vec![
            // In full contact far off the particles, so that the plane is known.
            [Point2::new(-0.5, -0.5), Point2::new(-0.3, -0.5)],
            [Point2::new(0.0, 0.0), Point2::new(0.05, 0.0)],
        ],
        press,
        force_noise: 0.0,
        position_noise: 0.0,
        ..Script::default()
    };
    let config = InterpretConfig {
        redraw_length_m: 1.0,
        replays: 16,
        ..InterpretConfig::of(&task)
    };
    let told = told_with(&script.samples(&task), &task, &config);
    let inside = |p: Point2| p.x > -0.03 && p.x < 0.08 && p.y.abs() < 0.05;
    let (mut under, mut affected) = (0.0, 0.0);
    for replay in told.belief.replays() {
        for i in (0..replay.len()).filter(|&i| inside(task.particles.position(i))) {
            under += 1.0;
            affected += f64::from(u8::from(replay.fate(i) == Fate::Absorbed));
        }
    }
    assert!(under > 5000.0);
    affected / under
}

#[test]
fn the_share_that_is_wiped_is_that_of_the_curve() {
    let flat = LogNormal {
        mu: -0.3,
        sigma: 0.9,
    };
    let half: fn(Point2) -> f64 = |p| if p.y < -0.2 { PRESS } else { 0.5 * PRESS };
    let third: fn(Point2) -> f64 = |p| if p.y < -0.2 { PRESS } else { 0.3 * PRESS };
    let full: fn(Point2) -> f64 = |_| PRESS;
    for likelihood in [STEEP, flat] {
        for (press, share) in [(third, 0.3), (half, 0.5), (full, 1.0)] {
            let expected = likelihood.probability(share);
            let found = share_affected(likelihood, press);
            // Four standard errors of at least 5000 draws.
            let error = 4.0 * (0.25_f64 / 5000.0).sqrt();
            assert!(
                (found - expected).abs() < error,
                "{share}: {found}, expected {expected}"
            );
        }
    }
    // Fig. 11: a steep curve lets weak contact work, a flat one lets strong contact fail.
    assert!(STEEP.probability(0.5) > 0.9 && flat.probability(1.0) < 0.7);
}

#[test]
fn a_threshold_is_drawn_again_after_some_travel() {
    let flat = LogNormal {
        mu: 0.0,
        sigma: 1.0,
    };
    let task = task(4000, flat);
    // Half of them respond at once; the sponge is 7 cm deep, so with l = 2 cm the rest get three more draws.
    let script = Script {
        strokes: vec![[Point2::new(-0.2, 0.0), Point2::new(0.2, 0.0)]],
        ..Script::default()
    };
    let share = |redraw_length_m: f64| {
        let config = InterpretConfig {
            redraw_length_m,
            replays: 8,
            ..InterpretConfig::of(&task)
        };
        let told = told_with(&script.samples(&task), &task, &config);
        let inside = |i: &usize| {
            task.particles.position(*i).x.abs() < 0.1 && task.particles.position(*i).y.abs() < 0.05
        };
        let all: Vec<usize> = (0..task.particles.len()).filter(inside).collect();
        let wiped = told
            .belief
            .replays()
            .iter()
            .flat_map(|replay| all.iter().map(|&i| replay.fate(i)));
        wiped.filter(|fate| *fate == Fate::Absorbed).count() as f64 / (all.len() * 8) as f64
    };
    assert!((share(1.0) - 0.5).abs() < 0.02, "{}", share(1.0));
    assert!(
        (share(0.02) - (1.0 - 0.5_f64.powi(4))).abs() < 0.02,
        "{}",
        share(0.02)
    );
}

#[test]
fn the_seed_decides_and_the_number_of_threads_does_not() {
    let task = task(
        300,
        LogNormal {
            mu: -0.5,
            sigma: 0.5,
        },
    );
    let samples = Script::default().samples(&task);
    let config = InterpretConfig {
        replays: 8,
        ..InterpretConfig::of(&task)
    };
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| told_with(&samples, &task, &config))
    };
    let (one, three) = (on(1), on(3));
    assert_eq!(one.belief, three.belief);
    assert_eq!(one.plane, three.plane);
    let other = told_with(
        &samples,
        &task,
        &InterpretConfig {
            seed: 8,
            ..config.clone()
        },
    );
    assert_ne!(one.belief, other.belief);
    // Replays differ from one another, particles too.
    let first = &one.belief.replays()[0];
    assert!(
        one.belief.replays()[1..]
            .iter()
            .all(|replay| replay != first)
    );
}

#[test]
fn pieces_are_joined_beyond_the_limit_and_tell_nearly_the_same() {
    let task = task(500, STEEP);
    let samples = Script::default().samples(&task);
    let config = InterpretConfig::of(&task);
    let fine = told_with(&samples, &task, &config);
    let coarse = told_with(
        &samples,
        &task,
        &InterpretConfig {
            max_pieces: 400,
            ..config
        },
    );
    assert!(fine.path.len() > 1000);
    assert!(
        (200..=400).contains(&coarse.path.len()),
        "{}",
        coarse.path.len()
    );
    assert!((fine.performance.mean - coarse.performance.mean).abs() < 0.02);
    assert_eq!(fine.events.len(), coarse.events.len());
}

#[test]
fn a_belief_of_several_is_continued_member_by_member() {
    let task = task(80, STEEP);
    let script = Script::default();
    let config = InterpretConfig {
        replays: 4,
        ..InterpretConfig::of(&task)
    };
    let samples = script.samples(&task);
    let before = told_with(&samples, &task, &config).belief;
    let after = interpret(&samples, &task, &before, &GoalState::Absorbed, &config)
        .unwrap()
        .belief;
    assert_eq!(after.replays().len(), 4);
    for (one, next) in before.replays().iter().zip(after.replays()) {
        assert!(next.tally().absorbed >= one.tally().absorbed);
    }
    let few = ParticleDistribution::new(&[]).unwrap();
    assert_eq!(
        Belief::of(vec![task.particles.clone(), few]).unwrap_err(),
        InterpretError::UnequalReplays {
            replay: 1,
            count: 0,
            expected: 80
        }
    );
    assert_eq!(Belief::of(vec![]).unwrap_err(), InterpretError::NoReplays);
}

#[test]
fn a_sample_of_a_belief_and_its_density_hold_the_mean() {
    let task = task(
        2000,
        LogNormal {
            mu: -0.5,
            sigma: 0.6,
        },
    );
    let told = told_with(
        &Script::default().samples(&task),
        &task,
        &InterpretConfig::of(&task),
    );
    let belief = &told.belief;
    let remaining = |p: &ParticleDistribution| p.tally().remaining as f64;
    let mean = belief.replays().iter().map(remaining).sum::<f64>() / 64.0;
    let sample = belief.sample(1).unwrap();
    assert_eq!(sample, belief.sample(1).unwrap());
    assert_ne!(sample, belief.sample(2).unwrap());
    // Four standard deviations of a binomial count.
    assert!((remaining(&sample) - mean).abs() < 4.0 * (2000.0_f64 * 0.25).sqrt());
    let map = belief.density(&task.surface, 0.02).unwrap();
    assert_eq!(map.shape(), (20, 14));
    let cells = || (0..14).flat_map(|row| (0..20).map(move |column| (column, row)));
    let sum: f64 = cells().map(|(column, row)| map.mean(column, row)).sum();
    assert!((sum - mean).abs() < 1e-6);
    assert!(cells().any(|(column, row)| map.standard_deviation(column, row) > 0.1));
    for cell_size in [0.0, -1.0, f64::NAN, 1e-9] {
        assert!(belief.density(&task.surface, cell_size).is_err());
    }
}

#[test]
fn what_is_no_measurement_is_refused_with_number_field_and_value() {
    let task = task(80, STEEP);
    let config = InterpretConfig::of(&task);
    let mut interpreter = Interpreter::new(&task, &config).unwrap();
    let sample = TouchSample {
        time: 1.0,
        world_from_tool: Pose::identity(),
        force: Vector3::zeros(),
    };
    interpreter.push(&sample).unwrap();
    assert_eq!(
        interpreter.push(&sample).unwrap_err().to_string(),
        "sample 1: time 1 s is not after 1 s, the time of the one before"
    );
    let mut deaf = TouchSample {
        time: 2.0,
        ..sample
    };
    deaf.force.y = f64::NAN;
    assert_eq!(
        interpreter.push(&deaf).unwrap_err().to_string(),
        "sample 1: force y [N] = NaN exceeds the limit of ±1e6"
    );
    let far = TouchSample {
        time: 2.0,
        world_from_tool: Pose::translation(0.0, 0.0, 2e4),
        ..sample
    };
    let refused = interpreter.push(&far).unwrap_err();
    assert!(matches!(
        refused,
        InterpretError::Measurement {
            field: "position z [m]",
            value: 2e4,
            ..
        }
    ));
    interpreter
        .push(&TouchSample {
            time: 1.5,
            ..sample
        })
        .unwrap();
    for wrong in [
        InterpretConfig {
            min_normal_force_n: 1.0,
            ..config.clone()
        },
        InterpretConfig {
            replays: 0,
            ..config.clone()
        },
        InterpretConfig {
            max_normal_force_n: -20.0,
            ..config.clone()
        },
        InterpretConfig {
            redraw_length_m: f64::NAN,
            ..config
        },
    ] {
        assert!(matches!(
            Interpreter::new(&task, &wrong),
            Err(InterpretError::Config { .. })
        ));
    }
}

/// The compression of the tool is what tells weak contact from a tool off the plane.
#[test]
fn a_tool_believed_rigid_is_thought_off_the_plane_where_it_presses_less() {
    let task = task(500, STEEP);
    let script = Script {
        press: |place| if place.x > 0.0 { 0.6 * PRESS } else { PRESS },
        ..Script::default()
    };
    let samples = script.samples(&task);
    let config = InterpretConfig::of(&task);
    let soft = told_with(&samples, &task, &config);
    let rigid = InterpretConfig {
        compliance: ToolCompliance::Rigid,
        ..config
    };
    let rigid = told_with(&samples, &task, &rigid);
    assert_eq!(events(&soft, EventKind::Collision), []);
    assert!(soft.performance.mean > rigid.performance.mean + 0.2);
}

fn any_log() -> impl Strategy<Value = Vec<TouchSample>> {
    let number =
        || prop_oneof![4 => -0.3..0.3_f64, 1 => -40.0..40.0_f64, 1 => proptest::num::f64::NORMAL];
    let one = (
        1e-6..0.2_f64,
        [number(), number(), number()],
        [number(), number(), number()],
        [number(), number(), number()],
    );
    prop::collection::vec(one, 0..120).prop_map(|rows| {
        let mut time = 0.0;
        rows.into_iter()
            .map(|(step, place, turn, force)| {
                time += step;
                let turn = turn.map(|angle| angle.rem_euclid(7.0));
                TouchSample {
                    time,
                    world_from_tool: Pose::new(place.into(), turn.into()),
                    force: force.into(),
                }
            })
            .collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn any_log_of_numbers_is_told_or_refused(samples in any_log(), collect: bool, max_pieces in 16_usize..200) {
        let mut task = task(60, STEEP);
        task.surface.world_from_surface = Pose::identity();
        let config = InterpretConfig { replays: 2, max_pieces, ..InterpretConfig::of(&task) };
        let mut interpreter = Interpreter::new(&task, &config).unwrap();
        for sample in &samples {
            let _ = interpreter.push(sample);
        }
        let goal = if collect {
            GoalState::Collected { center: Point2::origin(), radius: 0.06 }
        } else {
            GoalState::Absorbed
        };
        let told = interpreter.conclude(&Belief::certain(task.particles.clone()), &goal).unwrap();
        prop_assert!(told.path.len() <= max_pieces);
        prop_assert!((0.0..=1.0).contains(&told.contact_share));
        for replay in told.belief.replays() {
            let tally = replay.tally();
            prop_assert_eq!(tally.initial, tally.remaining + tally.absorbed + tally.off_surface);
        }
        for event in &told.events {
            prop_assert!(event.start <= event.end && event.samples > 0);
        }
        let last = told.events.windows(2).all(|pair| pair[0].start <= pair[1].start);
        prop_assert!(last);
    }
}
