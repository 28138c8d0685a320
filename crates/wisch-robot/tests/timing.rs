//! Timed motions against closed forms, laws and an independent checker, and that checker against planted faults.

use proptest::prelude::*;
use wisch_robot::timing::{
    JointLimit, JointLimits, JointPath, RateKind, SAMPLE_PERIOD, TimingConfig, TimingError,
    Trajectory, TrajectoryCheckConfig, TrajectoryFault, TrajectorySample, time_path,
    trajectory_faults,
};

fn limits(joints: &[(f64, f64)]) -> JointLimits {
    let joint = |(index, &(velocity, acceleration))| JointLimit {
        name: format!("joint {index}"),
        lower: -10.0,
        upper: 10.0,
        velocity,
        acceleration,
    };
    JointLimits::new(joints.iter().enumerate().map(joint).collect()).unwrap()
}

/// Limits of a mobile robot: the first two of six or more joints are those of the paper's base.
fn robot(joints: usize) -> JointLimits {
    let base = if joints >= 6 { 2 } else { 0 };
    let rows: Vec<(f64, f64)> = (0..joints)
        .map(|j| if j < base { (0.5, 1.0) } else { (1.0, 10.0) })
        .collect();
    limits(&rows)
}

fn timed(path: &JointPath, limits: &JointLimits) -> Trajectory {
    time_path(path, limits, &TimingConfig::default()).unwrap()
}

fn faults(
    trajectory: &Trajectory,
    period: f64,
    path: &JointPath,
    limits: &JointLimits,
) -> Vec<TrajectoryFault> {
    let samples: Vec<_> = trajectory.samples(period).collect();
    trajectory_faults(&samples, path, limits, &TrajectoryCheckConfig::default())
}

/// Shortest time over a way from rest to rest with a velocity and an acceleration limit.
fn rest_to_rest(way: f64, velocity: f64, acceleration: f64) -> f64 {
    if way * acceleration >= velocity * velocity {
        way / velocity + velocity / acceleration
    } else {
        2.0 * (way / acceleration).sqrt()
    }
}

#[test]
fn one_joint_takes_the_time_of_a_trapezoid_or_a_triangle() {
    for way in [1e-4, 0.01, 0.05, 0.1, 0.123, 0.5, 1.0, 7.7] {
        for (velocity, acceleration) in [(1.0, 10.0), (0.5, 1.0), (3.0, 2.0)] {
            let path = JointPath::new(&[[-way / 2.0], [way / 2.0]]).unwrap();
            let limits = limits(&[(velocity, acceleration)]);
            let duration = timed(&path, &limits).duration();
            let expected = rest_to_rest(way, velocity, acceleration);
            // At the switch to cruising the grid may cost a fraction of an interval.
            assert!(
                (0.0..1e-3 * expected.max(1.0)).contains(&(duration - expected + 1e-7 * expected)),
                "way {way}, limits {velocity} and {acceleration}: {duration} s instead of {expected} s"
            );
        }
    }
}

#[test]
fn the_slower_joint_decides() {
    let limits = limits(&[(1.0, 10.0), (0.5, 1.0)]);
    for (ways, expected) in [
        ([0.9, 0.6], rest_to_rest(0.6, 0.5, 1.0)),
        ([0.9, 0.01], rest_to_rest(0.9, 1.0, 10.0)),
        // Velocity of the first, acceleration of the second, over the way of the first.
        ([0.9, 0.2], rest_to_rest(0.9, 1.0, 0.9 / 0.2)),
    ] {
        let path = JointPath::new(&[[0.0, 0.0], ways]).unwrap();
        let duration = timed(&path, &limits).duration();
        assert!(
            (duration - expected).abs() < 1e-3,
            "{duration} instead of {expected}"
        );
    }
}

#[test]
fn a_joint_that_turns_back_loses_no_more_than_braking_and_speeding_up() {
    let path = JointPath::new(&[[0.0], [1.0], [0.2]]).unwrap();
    let duration = timed(&path, &limits(&[(1.0, 10.0)])).duration();
    let tolerance = TimingConfig::default().blend_tolerance;
    let bound = rest_to_rest(1.0 - tolerance, 1.0, 10.0) + rest_to_rest(0.8 - tolerance, 1.0, 10.0);
    assert!(duration >= bound, "{duration} beats the optimum {bound}");
    assert!(duration <= 1.05 * bound, "{duration} against {bound}");
}

#[test]
fn waypoints_on_a_line_cost_nothing() {
    let rows: Vec<[f64; 2]> = (0..=100)
        .map(|i| [0.01 * i as f64, -0.005 * i as f64])
        .collect();
    let limits = limits(&[(1.0, 10.0), (1.0, 10.0)]);
    let duration = timed(&JointPath::new(&rows).unwrap(), &limits).duration();
    let expected = rest_to_rest(1.0, 1.0, 10.0);
    assert!(
        (duration - expected).abs() < 1e-3,
        "{duration} instead of {expected}"
    );
}

#[test]
fn segments_take_their_shortest_times() {
    let path = JointPath::new(&[[0.0, 0.0], [0.4, 0.0], [0.4, 0.5]])
        .unwrap()
        .with_segment_times(vec![4.0, 0.0])
        .unwrap();
    let limits = robot(2);
    let trajectory = timed(&path, &limits);
    assert_eq!(faults(&trajectory, SAMPLE_PERIOD, &path, &limits), []);
    let first_leg = trajectory
        .samples(SAMPLE_PERIOD)
        .filter(|state| state.q[1] == 0.0);
    let fastest = first_leg.map(|state| state.qd[0]).fold(0.0, f64::max);
    assert!((0.0999..=0.1).contains(&fastest), "{fastest}");
    // A first leg at 0.1 rad/s, then one with 1 rad/s and 10 rad/s²; the corner belongs to the slow one, and
    // reaches at most 4 tolerances into the next.
    let legs = 0.4 / 0.1 + 0.01 + rest_to_rest(0.5, 1.0, 10.0);
    let corner = 4.0 * TimingConfig::default().blend_tolerance / 0.1;
    let duration = trajectory.duration();
    assert!(duration < legs + corner, "{duration}");
}

#[test]
fn repeated_waypoints_change_nothing_and_a_path_that_stays_takes_no_time() {
    let limits = robot(1);
    let once = timed(&JointPath::new(&[[0.0], [1.0], [0.5]]).unwrap(), &limits);
    let twice = JointPath::new(&[[0.0], [0.0], [1.0], [1.0], [1.0], [0.5], [0.5]]).unwrap();
    assert_eq!(timed(&twice, &limits).duration(), once.duration());
    assert_eq!(
        faults(&timed(&twice, &limits), SAMPLE_PERIOD, &twice, &limits),
        []
    );

    let still = JointPath::new(&[[0.3], [0.3]]).unwrap();
    let trajectory = timed(&still, &limits);
    assert_eq!(trajectory.duration(), 0.0);
    assert_eq!(trajectory.sample(-1.0).q, [0.3]);
    assert_eq!(faults(&trajectory, SAMPLE_PERIOD, &still, &limits), []);

    let hardly = JointPath::new(&[[0.3], [0.3 + 1e-5], [0.3 + 2e-5]]).unwrap();
    let expected = rest_to_rest(2e-5, 1.0, 10.0);
    assert!((timed(&hardly, &limits).duration() - expected).abs() < 1e-5);
    assert_eq!(
        faults(&timed(&hardly, &limits), SAMPLE_PERIOD, &hardly, &limits),
        []
    );
}

fn smooth_rows(joints: usize) -> impl Strategy<Value = Vec<Vec<f64>>> {
    let waves = prop::collection::vec((0.1..1.0, 0.5..4.0, 0.0..6.0), joints);
    (waves, 20..120_usize).prop_map(|(waves, count)| {
        let at = |i: usize| {
            let along = i as f64 / count as f64;
            let wave = |&(size, rate, phase): &(f64, f64, f64)| size * (rate * along + phase).sin();
            waves.iter().map(wave).collect()
        };
        (0..count).map(at).collect()
    })
}

fn cornered_rows(joints: usize) -> impl Strategy<Value = Vec<Vec<f64>>> {
    prop::collection::vec(prop::collection::vec(-1.0..1.0, joints), 2..30)
}

/// Sharp and dull corners, steps of very different lengths.
fn uneven_rows(joints: usize) -> impl Strategy<Value = Vec<Vec<f64>>> {
    let step = (prop::collection::vec(-1.0..1.0_f64, joints), -7.0..-0.5_f64);
    prop::collection::vec(step, 2..30).prop_map(move |steps| {
        let mut row = vec![0.0; joints];
        let mut rows = vec![row.clone()];
        for (direction, magnitude) in steps {
            let size = 10_f64.powf(magnitude);
            row.iter_mut()
                .zip(direction)
                .for_each(|(q, d)| *q += size * d);
            rows.push(row.clone());
        }
        rows
    })
}

fn any_rows() -> impl Strategy<Value = Vec<Vec<f64>>> {
    prop::sample::select(vec![1_usize, 6, 7, 13]).prop_flat_map(|joints| {
        prop_oneof![
            smooth_rows(joints),
            cornered_rows(joints),
            uneven_rows(joints)
        ]
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn random_paths_have_no_faults(rows in any_rows(), slow in 0.0..2.0_f64) {
        let path = JointPath::new(&rows).unwrap();
        let limits = robot(path.joint_count());
        let trajectory = timed(&path, &limits);
        prop_assert_eq!(faults(&trajectory, SAMPLE_PERIOD, &path, &limits), vec![]);

        let times = (0..rows.len() - 1).map(|i| if i % 2 == 0 { slow } else { 0.0 }).collect();
        let path = path.with_segment_times(times).unwrap();
        let trajectory = timed(&path, &limits);
        prop_assert_eq!(faults(&trajectory, SAMPLE_PERIOD, &path, &limits), vec![]);
    }

    #[test]
    fn neither_tolerance_nor_grid_nor_uneven_limits_bring_faults(
        rows in any_rows(),
        magnitudes in prop::collection::vec((-2.0..2.0_f64, -2.0..3.0_f64), 13),
        tolerance in -6.0..0.0_f64,
        grid_intervals in 2..20_usize,
    ) {
        let path = JointPath::new(&rows).unwrap();
        let magnitudes = &magnitudes[..path.joint_count()];
        let rows: Vec<(f64, f64)> =
            magnitudes.iter().map(|(v, a)| (10_f64.powf(*v), 10_f64.powf(*a))).collect();
        let limits = limits(&rows);
        let blend_tolerance = 10_f64.powf(tolerance);
        let config = TimingConfig { blend_tolerance, grid_intervals };
        let trajectory = time_path(&path, &limits, &config).unwrap();
        prop_assert!(trajectory.duration().is_finite());
        let samples: Vec<_> = trajectory.samples((trajectory.duration() / 3000.0).max(1e-6)).collect();
        let check = TrajectoryCheckConfig { path_deviation: blend_tolerance, ..TrajectoryCheckConfig::default() };
        prop_assert_eq!(trajectory_faults(&samples, &path, &limits, &check), vec![]);
    }

    #[test]
    fn limits_hold_at_and_around_every_switch(rows in any_rows()) {
        let path = JointPath::new(&rows).unwrap();
        let limits = robot(path.joint_count());
        let trajectory = timed(&path, &limits);
        let switches: Vec<f64> = trajectory.switch_times().collect();
        for ends in switches.windows(2) {
            prop_assert!(ends[0] < ends[1]);
            for share in [0.0, 1e-6, 0.3, 0.5, 0.7, 1.0 - 1e-6] {
                let state = trajectory.sample(ends[0] + share * (ends[1] - ends[0]));
                for (j, limit) in limits.joints().iter().enumerate() {
                    prop_assert!(state.qd[j].abs() <= limit.velocity);
                    prop_assert!(state.qdd[j].abs() <= limit.acceleration);
                }
            }
        }
    }

    #[test]
    fn with_a_ramp_limits_hold_and_accelerations_change_slowly(
        rows in any_rows(),
        ramp in 1e-3..0.1_f64,
    ) {
        let path = JointPath::new(&rows).unwrap();
        let limits = robot(path.joint_count());
        let abrupt = timed(&path, &limits);
        let trajectory = abrupt.clone().with_acceleration_ramp(ramp);
        let moves = abrupt.duration() > 0.0;
        let longer = if moves { ramp } else { 0.0 };
        prop_assert_eq!(trajectory.duration(), abrupt.duration() + longer);
        let samples: Vec<_> = trajectory.samples(SAMPLE_PERIOD).collect();
        let fastest = limits.joints().iter().map(|limit| limit.acceleration).fold(0.0, f64::max);
        let config = TrajectoryCheckConfig {
            path_deviation: TimingConfig::default().blend_tolerance + fastest * ramp * ramp / 24.0,
            // Of differences over the ramp, of what is summed up over all of the duration.
            position_resolution: (4.0 * f64::EPSILON * trajectory.duration() / ramp).max(1e-12),
            ..TrajectoryCheckConfig::default()
        };
        prop_assert_eq!(trajectory_faults(&samples, &path, &limits, &config), vec![]);
        let last = abrupt.sample(abrupt.duration());
        prop_assert_eq!(trajectory.sample(trajectory.duration()).q, last.q);
        for pair in samples.windows(2).rev().skip(1) {
            let time = pair[1].time - pair[0].time;
            for (joint, limit) in limits.joints().iter().enumerate() {
                let jerk = (pair[1].qdd[joint] - pair[0].qdd[joint]).abs() / time;
                prop_assert!(jerk <= 2.0 * limit.acceleration / ramp * (1.0 + 1e-6), "{}", jerk);
            }
        }
    }

    #[test]
    fn some_limit_is_nearly_always_used_up(joints in prop::sample::select(vec![1_usize, 6, 7, 13]), seed in any::<u64>()) {
        use rand::RngExt;
        use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let rows: Vec<Vec<f64>> = (0..12)
            .map(|_| (0..joints).map(|_| 2.0 * random.random::<f64>() - 1.0).collect())
            .collect();
        let path = JointPath::new(&rows).unwrap();
        let limits = robot(joints);
        let (mut used, mut all) = (0, 0);
        for state in timed(&path, &limits).samples(SAMPLE_PERIOD) {
            let joints = limits.joints().iter().enumerate();
            let usage = joints.map(|(j, limit)| {
                (state.qd[j].abs() / limit.velocity).max(state.qdd[j].abs() / limit.acceleration)
            });
            all += 1;
            used += usize::from(usage.fold(0.0, f64::max) >= 0.95);
        }
        prop_assert!(used * 10 >= all * 8, "{used} of {all} samples");
    }

    #[test]
    fn a_finer_grid_gains_less_than_a_hundredth(rows in any_rows()) {
        let path = JointPath::new(&rows).unwrap();
        let limits = robot(path.joint_count());
        let coarse = timed(&path, &limits).duration();
        let fine = TimingConfig { grid_intervals: 192, ..TimingConfig::default() };
        let fine = time_path(&path, &limits, &fine).unwrap().duration();
        prop_assert!((coarse - fine).abs() <= 0.01 * fine, "{coarse} against {fine}");
    }

    #[test]
    fn twice_the_velocity_and_four_times_the_acceleration_halve_the_time(rows in any_rows()) {
        let path = JointPath::new(&rows).unwrap();
        let slow = robot(path.joint_count());
        let fast = slow.joints().iter().map(|joint| JointLimit {
            velocity: 2.0 * joint.velocity,
            acceleration: 4.0 * joint.acceleration,
            ..joint.clone()
        });
        let fast = timed(&path, &JointLimits::new(fast.collect()).unwrap()).duration();
        let slow = timed(&path, &slow).duration();
        prop_assert!((slow - 2.0 * fast).abs() <= 1e-6 * slow, "{slow} against {fast}");
    }

    #[test]
    fn the_same_path_gives_the_same_bytes(rows in any_rows()) {
        let path = JointPath::new(&rows).unwrap();
        let limits = robot(path.joint_count());
        let bits = || -> Vec<u64> {
            let trajectory = timed(&path, &limits);
            let samples = trajectory.samples(0.01);
            samples.flat_map(|s| [s.q, s.qd, s.qdd].concat()).map(f64::to_bits).collect()
        };
        prop_assert_eq!(bits(), bits());
    }
}

/// A motion along two segments, its path and limits.
fn sound() -> (Vec<TrajectorySample>, JointPath, JointLimits) {
    let path = JointPath::new(&[[0.0, 0.0], [0.5, 0.0], [0.5, 0.4]])
        .unwrap()
        .with_segment_times(vec![0.0, 1.0])
        .unwrap();
    let limits = robot(2);
    let samples = timed(&path, &limits).samples(SAMPLE_PERIOD).collect();
    (samples, path, limits)
}

#[test]
fn every_planted_fault_is_found() {
    type Plant = fn(&mut Vec<TrajectorySample>);
    type Sign = fn(&TrajectoryFault) -> bool;
    let planted: [(&str, Plant, Sign); 18] = [
        (
            "nothing",
            |s| s.clear(),
            |f| matches!(f, TrajectoryFault::Empty),
        ),
        (
            "shape",
            |s| s[3].qd.truncate(1),
            |f| matches!(f, TrajectoryFault::Shape { sample: 3, .. }),
        ),
        (
            "not a number",
            |s| s[3].qdd[1] = f64::NAN,
            |f| matches!(f, TrajectoryFault::NotFinite { sample: 3 }),
        ),
        (
            "time stands still",
            |s| s[5].time = s[4].time,
            |f| matches!(f, TrajectoryFault::TimeNotIncreasing { sample: 5, .. }),
        ),
        (
            "position",
            |s| s[200].q[0] = 10.1,
            |f| {
                matches!(
                    f,
                    TrajectoryFault::Position {
                        sample: 200,
                        joint: 0,
                        ..
                    }
                )
            },
        ),
        (
            "velocity",
            |s| s[200].qd[0] = -1.001,
            |f| {
                matches!(
                    f,
                    TrajectoryFault::TooFast {
                        rate: RateKind::Velocity,
                        sample: 200,
                        joint: 0,
                        ..
                    }
                )
            },
        ),
        (
            "acceleration",
            |s| s[200].qdd[1] = 10.001,
            |f| {
                matches!(
                    f,
                    TrajectoryFault::TooFast {
                        rate: RateKind::Acceleration,
                        sample: 200,
                        joint: 1,
                        ..
                    }
                )
            },
        ),
        // While cruising at 1 rad/s: 0.1 mrad more makes 1.1 rad/s, then 0.9.
        (
            "position jumps",
            |s| s[200].q[0] += 1e-4,
            |f| {
                matches!(
                    f,
                    TrajectoryFault::TooFast {
                        rate: RateKind::PositionStep,
                        sample: 199,
                        ..
                    }
                )
            },
        ),
        (
            "all later positions jump",
            |s| s[300..].iter_mut().for_each(|s| s.q[1] += 1e-5),
            |f| {
                matches!(
                    f,
                    TrajectoryFault::VelocityMismatch { joint: 1, .. }
                        | TrajectoryFault::TooFast {
                            rate: RateKind::PositionBend,
                            joint: 1,
                            ..
                        }
                )
            },
        ),
        (
            "positions bend",
            |s| s[200].q[0] -= 1e-5,
            |f| {
                matches!(
                    f,
                    TrajectoryFault::TooFast {
                        rate: RateKind::PositionBend,
                        sample: 200,
                        ..
                    }
                )
            },
        ),
        (
            "velocity jumps",
            |s| s[200..].iter_mut().for_each(|s| s.qd[0] -= 0.02),
            |f| {
                matches!(
                    f,
                    TrajectoryFault::TooFast {
                        rate: RateKind::VelocityStep,
                        sample: 199,
                        joint: 0,
                        ..
                    }
                )
            },
        ),
        (
            "velocities of another motion",
            |s| s.iter_mut().for_each(|s| s.qd[0] *= 0.9),
            |f| matches!(f, TrajectoryFault::VelocityMismatch { joint: 0, .. }),
        ),
        (
            "starts in motion",
            |s| drop(s.drain(..100)),
            |f| matches!(f, TrajectoryFault::NotAtRest { .. }),
        ),
        (
            "ends elsewhere",
            |s| s.truncate(400),
            |f| matches!(f, TrajectoryFault::WrongEnd { .. }),
        ),
        (
            "cut short",
            |s| s.truncate(400),
            |f| matches!(f, TrajectoryFault::WaypointMissed { waypoint: 1, .. }),
        ),
        (
            "off the path",
            |s| s[200].q[1] = 0.003,
            |f| matches!(f, TrajectoryFault::OffPath { sample: 200, .. }),
        ),
        (
            "everything off the path",
            |s| s.iter_mut().for_each(|s| s.q[1] += 0.0021),
            |f| matches!(f, TrajectoryFault::OffPath { .. }),
        ),
        (
            "segment too fast",
            |s| s.iter_mut().for_each(|s| s.qd[1] *= 1.01),
            |f| {
                matches!(
                    f,
                    TrajectoryFault::TooFast {
                        rate: RateKind::SegmentVelocity,
                        joint: 1,
                        ..
                    }
                )
            },
        ),
    ];
    let (samples, path, limits) = sound();
    let config = TrajectoryCheckConfig::default();
    assert_eq!(trajectory_faults(&samples, &path, &limits, &config), []);
    for (name, plant, sign) in planted {
        let mut samples = samples.clone();
        plant(&mut samples);
        let faults = trajectory_faults(&samples, &path, &limits, &config);
        assert!(
            faults.iter().any(sign),
            "{name}: {:?}",
            faults.iter().take(5).collect::<Vec<_>>()
        );
    }
}

#[test]
fn a_motion_within_looser_limits_breaks_tighter_ones() {
    let path = JointPath::new(&[[0.0, 0.0], [0.5, 0.1], [0.1, 0.6]]).unwrap();
    let loose = limits(&[(1.0, 10.0), (1.0, 10.0)]);
    let trajectory = timed(&path, &loose);
    for tight in [[(0.99, 10.0), (1.0, 10.0)], [(1.0, 10.0), (1.0, 9.9)]] {
        assert_ne!(
            faults(&trajectory, SAMPLE_PERIOD, &path, &limits(&tight)),
            []
        );
    }
    let strict = TrajectoryCheckConfig {
        path_deviation: 1e-3,
        ..TrajectoryCheckConfig::default()
    };
    let samples: Vec<_> = trajectory.samples(SAMPLE_PERIOD).collect();
    assert_ne!(trajectory_faults(&samples, &path, &loose, &strict), []);
}

#[test]
fn a_path_the_other_way_round_or_with_a_detour_is_not_followed() {
    let (samples, _, limits) = sound();
    let detour = JointPath::new(&[[0.0, 0.0], [0.5, 0.0], [0.7, 0.2], [0.5, 0.4]]).unwrap();
    let faults = trajectory_faults(
        &samples,
        &detour,
        &limits,
        &TrajectoryCheckConfig::default(),
    );
    assert!(
        faults
            .iter()
            .any(|f| matches!(f, TrajectoryFault::WaypointMissed { waypoint: 2, .. }))
    );
    let reverse = JointPath::new(&[[0.5, 0.4], [0.5, 0.0], [0.0, 0.0]]).unwrap();
    let faults = trajectory_faults(
        &samples,
        &reverse,
        &limits,
        &TrajectoryCheckConfig::default(),
    );
    assert!(
        faults
            .iter()
            .any(|f| matches!(f, TrajectoryFault::WrongEnd { .. }))
    );
}

#[test]
fn wrong_input_is_named() {
    let message = |result: Result<JointPath, TimingError>| result.unwrap_err().to_string();
    assert_eq!(
        message(JointPath::new(&[[0.0]])),
        "the path needs at least 2 waypoints, 1 given"
    );
    assert_eq!(
        message(JointPath::new(&vec![[0.0]; 1_000_001])),
        "1000001 waypoints exceed the limit of 1000000"
    );
    assert_eq!(
        message(JointPath::new(&[vec![], vec![]])),
        "waypoint 0 has no joint positions; expected at least one"
    );
    assert_eq!(
        message(JointPath::new(&[vec![0.0], vec![0.0, 1.0]])),
        "waypoint 1 has 2 joint positions, but waypoint 0 has 1"
    );
    assert_eq!(
        message(JointPath::new(&[[0.0, 0.0], [0.0, f64::NAN]])),
        "waypoint 1, joint 1: position NaN is not a finite number"
    );
    let path = JointPath::new(&[[0.0], [11.0]]).unwrap();
    assert_eq!(
        message(path.clone().with_segment_times(vec![])),
        "0 segment times are given for 1 segments"
    );
    assert_eq!(
        message(path.clone().with_segment_times(vec![-1.0])),
        "segment 0: shortest time -1 s is not a finite number of at least 0"
    );

    let timing = |limits: &JointLimits, config: &TimingConfig| {
        time_path(&path, limits, config).unwrap_err().to_string()
    };
    let config = TimingConfig::default();
    assert_eq!(
        timing(&robot(1), &config),
        "waypoint 1, joint \"joint 0\": position 11 is outside its range -10 to 10"
    );
    assert_eq!(
        timing(&robot(2), &config),
        "limits are given for 2 joints, but the path has 1"
    );
    assert_eq!(
        timing(
            &robot(1),
            &TimingConfig {
                blend_tolerance: f64::NAN,
                ..config.clone()
            }
        ),
        "blend tolerance NaN must be finite and at least 0.000001"
    );
    assert_eq!(
        timing(
            &robot(1),
            &TimingConfig {
                grid_intervals: 1,
                ..config
            }
        ),
        "1 grid intervals per piece are not between 2 and 4000000"
    );
    let elbow = JointLimit::arm("elbow", 1.0, -1.0);
    assert_eq!(
        JointLimits::new(vec![elbow.clone()])
            .unwrap_err()
            .to_string(),
        "joint \"elbow\": range 1 to -1 contains no position"
    );
    let elbow = JointLimit {
        acceleration: f64::INFINITY,
        lower: -2.0,
        ..elbow
    };
    let elbow = JointLimit {
        upper: 1.0,
        ..elbow
    };
    assert_eq!(
        JointLimits::new(vec![elbow]).unwrap_err().to_string(),
        "joint \"elbow\": acceleration limit inf is not a positive, finite number"
    );
}
