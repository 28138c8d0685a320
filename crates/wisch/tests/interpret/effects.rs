//! Beliefs about the effect of wiping: shares in closed form, seeds, samples and densities.

use super::log::{PRESS, STEEP, Script, task};
use super::{exact, interpreted_with};
use wisch::geometry::{Point2, Pose, Vector3};
use wisch::interpret::{Belief, InterpretConfig, InterpretError, TouchSample, interpret};
use wisch::represent::{Fate, GoalState, LogNormal, ParticleDistribution};

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
        ..exact(&task)
    };
    let interpretation = interpreted_with(&script.samples(&task), &task, &config);
    let inside = |p: Point2| p.x > -0.03 && p.x < 0.08 && p.y.abs() < 0.05;
    let (mut under, mut affected) = (0.0, 0.0);
    for replay in interpretation.belief.members() {
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
            ..exact(&task)
        };
        let interpretation = interpreted_with(&script.samples(&task), &task, &config);
        let inside = |i: &usize| {
            task.particles.position(*i).x.abs() < 0.1 && task.particles.position(*i).y.abs() < 0.05
        };
        let all: Vec<usize> = (0..task.particles.len()).filter(inside).collect();
        let wiped = interpretation
            .belief
            .members()
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
        ..InterpretConfig::from_task(&task)
    };
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| interpreted_with(&samples, &task, &config))
    };
    let (one, three) = (on(1), on(3));
    assert_eq!(one.belief, three.belief);
    assert_eq!(one.plane, three.plane);
    let other = interpreted_with(
        &samples,
        &task,
        &InterpretConfig {
            seed: 8,
            ..config.clone()
        },
    );
    assert_ne!(one.belief, other.belief);
    // Replays differ from one another, particles too.
    let first = &one.belief.members()[0];
    assert!(
        one.belief.members()[1..]
            .iter()
            .all(|replay| replay != first)
    );
}

#[test]
fn a_belief_of_several_is_continued_member_by_member() {
    let task = task(80, STEEP);
    let script = Script::default();
    let config = InterpretConfig {
        replays: 4,
        ..InterpretConfig::from_task(&task)
    };
    let samples = script.samples(&task);
    let before = interpreted_with(&samples, &task, &config).belief;
    let after = interpret(&samples, &task, &before, &GoalState::Absorbed, &config)
        .unwrap()
        .belief;
    assert_eq!(after.members().len(), 4);
    for (one, next) in before.members().iter().zip(after.members()) {
        let is_kept = |i: usize| one.fate(i) == Fate::OnSurface || next.fate(i) == one.fate(i);
        assert!((0..80).all(is_kept));
        assert!(one.tally().absorbed > 40);
    }
    // Members need not hold as many particles.
    let few = ParticleDistribution::new(&[]).unwrap();
    let unequal = Belief::from_members(vec![task.particles.clone(), few]).unwrap();
    let after = interpret(&samples, &task, &unequal, &GoalState::Absorbed, &config).unwrap();
    let counts: Vec<usize> = after
        .belief
        .members()
        .iter()
        .map(ParticleDistribution::len)
        .collect();
    assert_eq!(counts, [80, 0]);
    assert_eq!(
        Belief::from_members(vec![]).unwrap_err(),
        InterpretError::NoMembers
    );
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
    let interpretation = interpreted_with(
        &Script::default().samples(&task),
        &task,
        &InterpretConfig::from_task(&task),
    );
    let belief = &interpretation.belief;
    let remaining = |p: &ParticleDistribution| p.tally().remaining as f64;
    let members = belief.members().len() as f64;
    let mean = belief.members().iter().map(remaining).sum::<f64>() / members;
    let sample = belief.sample(1).unwrap();
    assert_eq!(sample, belief.sample(1).unwrap());
    assert_ne!(sample, belief.sample(2).unwrap());
    assert!(belief.members().contains(&sample));
    let map = belief.density(&task.surface, 0.02).unwrap();
    assert_eq!(map.shape(), (20, 14));
    let cells = (0..14).flat_map(|row| (0..20).map(move |column| (column, row)));
    let sum: f64 = cells.map(|(column, row)| map.mean(column, row)).sum();
    assert!((sum - mean).abs() < 1e-6);
    // Draws for a plan are members one on top of the other, each about as often as its weight says.
    let draws = belief.draw_mixture(4 * belief.members().len(), 5).unwrap();
    let expected = mean * 4.0 * members;
    assert!((remaining(&draws) - expected).abs() < 0.01 * expected);
}

#[test]
fn a_density_is_the_mean_and_the_spread_of_the_counts() {
    let surface = task(0, STEEP).surface;
    let particles = |count: usize, fate: Fate| {
        let mut places = vec![(Point2::new(0.05, -0.13), Fate::OnSurface); count];
        // Further particles at another place, on the surface or absorbed.
        places.resize(4, (Point2::new(-0.15, 0.13), fate));
        ParticleDistribution::with_fates(&places).unwrap()
    };
    let replays = vec![particles(3, Fate::OnSurface), particles(1, Fate::Absorbed)];
    let belief = Belief::from_members(replays).unwrap();
    let map = belief.density(&surface, 0.1).unwrap();
    assert_eq!((map.shape(), map.cell_size()), ((4, 3), 0.1));
    assert!((map.center(2, 0) - Point2::new(0.05, -0.09)).norm() < 1e-12);
    for row in 0..3 {
        for column in 0..4 {
            let expected = match (column, row) {
                (2, 0) => [2.0, 1.0],
                (0, 2) => [0.5, 0.5],
                _ => [0.0, 0.0],
            };
            let found = [map.mean(column, row), map.standard_deviation(column, row)];
            assert_eq!(found, expected, "cell ({column}, {row})");
        }
    }
    for size in [0.0, -1.0, f64::NAN, 1e-9] {
        let refused = belief.density(&surface, size).unwrap_err();
        assert!(matches!(refused, InterpretError::Cells { .. }), "{refused}");
    }
}

/// A tool that trembles, settles and turns before its stroke still carries the particles under it
/// along with the stroke.
#[test]
fn trembling_before_a_stroke_pushes_nothing_away() {
    let mut task = task(0, STEEP);
    let under: Vec<Point2> = (0..9)
        .map(|i| {
            Point2::new(
                f64::from(i % 3) * 0.02 - 0.02,
                f64::from(i / 3) * 0.03 - 0.03,
            )
        })
        .collect();
    task.particles = ParticleDistribution::new(&under).unwrap();
    let samples: Vec<TouchSample> = (0..3000)
        .map(|i| {
            let time = f64::from(i) * 1e-3;
            let trembling = -0.003 * (time * 3.0).min(1.0) + 0.0005 * (40.0 * time).sin();
            let turned = -0.15 * (time * 2.0).min(1.0);
            let x = trembling + 0.05 * (time - 1.0).max(0.0);
            let surface_from_tool = Pose::new(Vector3::new(x, 0.0, 0.0), Vector3::z() * turned);
            TouchSample {
                time,
                world_from_tool: task.surface.world_from_surface * surface_from_tool,
                force: task.surface.world_from_surface * Vector3::z() * 10.0,
            }
        })
        .collect();
    let goal = GoalState::Collected {
        center: Point2::new(0.14, 0.0),
        radius: 0.065,
    };
    let believed = Belief::from_particles(task.particles.clone());
    let interpretation = interpret(&samples, &task, &believed, &goal, &exact(&task)).unwrap();
    assert_eq!(
        interpretation.performance.low, 1.0,
        "{:?}",
        interpretation.performance
    );
}
