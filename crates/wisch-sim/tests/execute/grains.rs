//! Real dirt under a real tool.

use super::wiping::{Log, Wiping};
use nalgebra::{Translation3, UnitQuaternion};
use proptest::prelude::*;
use wisch::geometry::{Point2, Pose, Vector3};
use wisch::represent::{
    Action, DirtFriction, DirtMobility, Fate, Liquid, LiquidFilm, Mount, ParticleDistribution,
    ToolPace, mean_distance,
};
use wisch_sim::Dirt;
use wisch_testkit::board;

/// How far a grain that nothing touches may creep [m].
const CREEP: f64 = 1e-4;
/// Nearer than this to the side of the tool, it may or may not touch a grain [m].
const UNCERTAIN: f64 = 6e-3;

/// A wipe over the board's grains.
fn dirty(action: Action) -> Wiping {
    let mut wiping = Wiping::of_one_stroke(action);
    wiping.dirt = Dirt::scatter(&wiping.task.particles, &wiping.settings, 1);
    wiping
}

/// How far inside the tool's swept area a place comes at most [m]; negative: how far outside it stays.
fn depth_in_swept_area(log: &Log, wiping: &Wiping, place: Point2) -> f64 {
    let surface_from_world = wiping.task.surface.world_from_surface.inverse();
    let on_surface = nalgebra::Point3::new(place.x, place.y, 0.0);
    let wiped = log.rows.iter().filter(|row| row.phase.is_contact());
    let depths = wiped.step_by(5).map(|row| {
        let tool_from_surface = (surface_from_world * row.world_from_tool).inverse();
        let under = (tool_from_surface * on_surface).xy();
        let sides = wiping.task.tool.footprint.edges();
        let distance = sides.map(|side| side.distance(under));
        let distance = distance.fold(f64::INFINITY, f64::min);
        if wiping.task.tool.footprint.contains(under) {
            distance
        } else {
            -distance
        }
    });
    depths.fold(f64::NEG_INFINITY, f64::max)
}

/// The declared friction counts, although that between tool and surface is 0.4.
#[test]
fn grains_rest_up_to_their_declared_friction_and_slide_beyond_it() {
    let lean: f64 = 0.06;
    for (share, slides) in [(1.1, false), (0.8, true)] {
        let mut task = board(Action::Skim, [0.5, 0.0, 0.2]);
        task.tool.mount = Some(Mount::Hand { lean: 0.8 });
        // The board's y points up its slope.
        task.surface.world_from_surface *= Pose::new(Vector3::zeros(), Vector3::x() * lean);
        task.scene.clear();
        task.mobility = DirtMobility::Slides(DirtFriction::constant(share * lean.tan()));
        let mut wiping = Wiping::of_first_stroke(task);
        wiping.settings.mobility = wiping.task.mobility;
        wiping.dirt = Dirt::scatter(&wiping.task.particles, &wiping.settings, 1);
        let log = wiping.execute();
        let (mut beside, mut fallen) = (0, 0);
        let grains = wiping.dirt.grains().iter();
        for (before, after) in grains.zip(log.truth.dirt.grains()) {
            if depth_in_swept_area(&log, &wiping, before.position) > -0.02 {
                continue;
            }
            beside += 1;
            fallen += usize::from(after.fate == Fate::OffSurface { edge: 0 });
            let down = before.position.y - after.position.y;
            if slides {
                assert!(down > 0.02, "slid {down} m");
            } else {
                assert!(
                    down.abs() < 1e-3 && after.fate == Fate::OnSurface,
                    "crept {down} m"
                );
            }
        }
        assert!(beside >= 6, "{beside}");
        assert_eq!(fallen > 0, slides, "{fallen} of {beside}");
    }
}

#[test]
fn the_drops_of_a_film_run_down_by_its_law() {
    let mut task = board(Action::Absorb, [0.5, 0.0, 0.2]);
    task.tool.mount = Some(Mount::Hand { lean: 0.8 });
    task.surface.world_from_surface *= Pose::new(Vector3::zeros(), Vector3::x() * 0.06);
    task.scene.clear();
    let lattice = (0..108).map(|i| ((i % 12) as f64 - 5.5, (i / 12) as f64 - 4.0));
    let drops: Vec<Point2> = lattice
        .map(|(i, j)| Point2::new(0.02 * i, 0.02 * j))
        .collect();
    task.particles = ParticleDistribution::new(&drops).unwrap();
    let liquid = Liquid {
        viscosity: 0.005,
        ..Liquid::WATER
    };
    task.mobility = DirtMobility::Runs(LiquidFilm {
        liquid,
        // 0.2 mm on the board, which runs at 1.6 mm/s.
        particle_volume: 2e-4 * task.surface.outline.area() / 108.0,
        pace: ToolPace::default(),
    });
    let mut wiping = Wiping::of_first_stroke(task);
    wiping.settings.mobility = wiping.task.mobility;
    // No pressure takes a drop up.
    wiping.settings.likelihood.mu = 10.0;
    wiping.dirt = Dirt::scatter(&wiping.task.particles, &wiping.settings, 1);
    let log = wiping.execute();
    let time = log.rows.last().unwrap().time;
    let (task, before) = (&wiping.task, wiping.dirt.grains());
    let places: Vec<Point2> = before.iter().map(|grain| grain.position).collect();
    let spacing = mean_distance(&task.surface, places.len());
    let flow = task.film_flow().unwrap();
    let wanted = flow.displacements(&places, &task.surface, spacing, time);
    let (mut found_sum, mut wanted_sum) = (0.0, 0.0);
    for ((before, after), wanted) in before.iter().zip(log.truth.dirt.grains()).zip(wanted) {
        let down = before.position.y - after.position.y;
        assert!(down > -CREEP && (after.position.x - before.position.x).abs() < 1e-3);
        if after.fate == Fate::OnSurface && before.position.y - wanted.norm() > -0.09 {
            found_sum += down;
            wanted_sum += wanted.norm();
        }
    }
    // At the top, a film that is moved in many steps runs a little less far.
    assert!(wanted_sum > 0.01, "{wanted_sum}");
    assert!(
        (0.6..1.1).contains(&(found_sum / wanted_sum)),
        "{found_sum} {wanted_sum}"
    );
}

#[test]
fn a_grain_in_the_way_is_pushed_and_one_beside_it_lies_still() {
    let wiping = dirty(Action::Skim);
    let log = wiping.execute();
    let mut pushed = 0;
    let grains = wiping.dirt.grains().iter();
    for (before, after) in grains.zip(log.truth.dirt.grains()) {
        let depth = depth_in_swept_area(&log, &wiping, before.position);
        let moved = (after.position - before.position).norm();
        if depth > UNCERTAIN {
            assert!(
                moved > 1e-3,
                "{depth} m under the tool, and moved by {moved} m"
            );
            pushed += 1;
        } else if depth < -0.02 {
            // Nor does another grain come that far.
            assert!(moved < CREEP, "{depth} m beside, but moved by {moved} m");
            assert_eq!(after.fate, Fate::OnSurface);
        }
    }
    assert!(pushed > 2);
}

#[test]
fn what_is_absorbed_is_what_the_tool_went_over() {
    let wiping = dirty(Action::Absorb);
    let log = wiping.execute();
    let mut absorbed = 0;
    let grains = wiping.dirt.grains().iter();
    for (before, after) in grains.zip(log.truth.dirt.grains()) {
        let depth = depth_in_swept_area(&log, &wiping, before.position);
        let is_taken = after.fate == Fate::Absorbed;
        if depth > UNCERTAIN {
            assert!(
                is_taken,
                "{depth} m under the tool, threshold {}",
                before.threshold
            );
        } else if depth < -UNCERTAIN {
            assert!(!is_taken, "{depth} m beside the tool");
            assert!((after.position - before.position).norm() < CREEP);
        }
        absorbed += usize::from(is_taken);
    }
    assert!(absorbed > 2);
}

#[test]
fn a_tool_that_does_not_touch_the_surface_does_nothing_to_the_dirt() {
    for action in [Action::Skim, Action::Absorb] {
        let mut wiping = dirty(action);
        wiping.settings.believed_from_real.translation.z = -0.05;
        let log = wiping.execute();
        let grains = wiping.dirt.grains().iter();
        for (before, after) in grains.zip(log.truth.dirt.grains()) {
            assert_eq!(after.fate, Fate::OnSurface);
            assert!((after.position - before.position).norm() < CREEP);
        }
    }
}

#[test]
fn what_lies_on_a_slope_stays_there() {
    let mut wiping = dirty(Action::Skim);
    // As a windshield is raked; far below the tool.
    let raked = UnitQuaternion::from_scaled_axis(Vector3::new(30_f64.to_radians(), 0.0, 0.0));
    wiping.settings.believed_from_real = Pose::from_parts(Translation3::new(0.0, 0.0, -0.3), raked);
    // As near to each other as they can be.
    let apart = wiping.settings.grain_size.max_m + 1e-4;
    let places: Vec<Point2> = (0..100)
        .map(|i| apart * Point2::new(f64::from(i % 10), f64::from(i / 10)))
        .collect();
    let places = ParticleDistribution::new(&places).unwrap();
    wiping.dirt = Dirt::scatter(&places, &wiping.settings, 1);
    let log = wiping.execute();
    for (before, after) in wiping.dirt.grains().iter().zip(log.truth.dirt.grains()) {
        let moved = (after.position - before.position).norm();
        assert!(
            moved < CREEP,
            "creeps by {moved} m in {} s",
            log.executed.duration
        );
    }
}

#[test]
fn what_no_pressure_moves_is_neither_absorbed_nor_pushed() {
    for action in [Action::Skim, Action::Absorb] {
        let mut wiping = dirty(action);
        wiping.settings.likelihood.mu = 3.0;
        wiping.dirt = Dirt::scatter(&wiping.task.particles, &wiping.settings, 1);
        let log = wiping.execute();
        let grains = wiping.dirt.grains().iter();
        for (before, after) in grains.zip(log.truth.dirt.grains()) {
            assert_eq!(after.fate, Fate::OnSurface);
            assert!((after.position - before.position).norm() < CREEP);
        }
    }
}

#[test]
fn no_grain_is_lost_and_thresholds_are_for_good() {
    let wiping = dirty(Action::Skim);
    let after = wiping.execute().truth.dirt;
    assert_eq!(after.grains().len(), wiping.dirt.grains().len());
    assert_eq!(after.particles().unwrap().len(), after.grains().len());
    for (before, after) in wiping.dirt.grains().iter().zip(after.grains()) {
        assert_eq!(before.threshold, after.threshold);
        assert_eq!(before.radius, after.radius);
        match after.fate {
            Fate::OnSurface => {
                assert!(wiping.task.surface.outline.contains(after.position));
            }
            Fate::OffSurface { edge } => assert!(edge < 4),
            Fate::Absorbed | Fate::Treated { .. } => panic!("a skim absorbs and treats nothing"),
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn grains_are_as_large_and_as_stubborn_as_reality_says(seed in any::<u64>()) {
        let reality = super::wiping::as_believed();
        let points: Vec<Point2> = (0..800).map(|i| Point2::new(f64::from(i), 0.0)).collect();
        let particles = ParticleDistribution::new(&points).unwrap();
        let dirt = Dirt::scatter(&particles, &reality, seed);
        let count = dirt.grains().len() as f64;
        let logs = || dirt.grains().iter().map(|grain| grain.threshold.ln());
        let mean = logs().sum::<f64>() / count;
        let deviation = (logs().map(|l| (l - mean).powi(2)).sum::<f64>() / count).sqrt();
        // Six standard errors.
        prop_assert!((mean - reality.likelihood.mu).abs() < 6.0 * 0.25 / count.sqrt());
        prop_assert!((deviation - 0.25).abs() < 6.0 * 0.25 / (2.0 * count).sqrt());
        for grain in dirt.grains() {
            let diameter = 2.0 * grain.radius;
            prop_assert!((reality.grain_size.min_m..=reality.grain_size.max_m).contains(&diameter));
        }
        // A grain's nature does not depend on what else lies there.
        let fewer = ParticleDistribution::new(&points[..100]).unwrap();
        let fewer = Dirt::scatter(&fewer, &reality, seed);
        prop_assert_eq!(fewer.grains(), &dirt.grains()[..100]);
    }
}
