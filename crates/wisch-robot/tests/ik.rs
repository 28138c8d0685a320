//! Inverse kinematics of the shipped robots, compared with the kinematics of the whole robot.

use nalgebra::UnitQuaternion;
use proptest::prelude::*;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::PI;
use wisch_robot::geometry::{Pose, Vector3};
use wisch_robot::{
    IkConfig, IkOutcome, IkSolver, JointKind, JointPositions, LinkId, RobotModel, RotationGoal,
};

const HUMANOID: &str = include_str!("../../../robots/humanoid.urdf");
const ARM7: &str = include_str!("../../../robots/arm7.urdf");
const ARM6: &str = include_str!("../../../robots/arm6.urdf");
const GOALS: [RotationGoal; 2] = [RotationGoal::Full, RotationGoal::AboutToolZFree];

/// Largest difference of the kinematics of chain and robot, from rounding [m, rad].
const ROUNDING: f64 = 1e-12;

fn no_meshes(_: &str) -> Result<Vec<u8>, String> {
    Err("there are no meshes".to_owned())
}

/// A robot with a solver for one of its chains.
struct Bench {
    robot: RobotModel,
    solver: IkSolver,
    base: LinkId,
    tip: LinkId,
    tip_from_tool: Pose,
}

impl Bench {
    fn new(text: &str, base: &str, tip: &str) -> Self {
        let robot = RobotModel::from_urdf("test", text, &mut no_meshes).unwrap();
        let (base, tip) = (robot.link(base).unwrap(), robot.link(tip).unwrap());
        // A tool off all axes, so that a wrong order of frames is detected.
        let turn = UnitQuaternion::from_euler_angles(0.3, -0.2, 0.5);
        let tip_from_tool = Pose::from_parts([0.02, -0.03, 0.11].into(), turn);
        let solver = IkSolver::new(&robot, base, tip, tip_from_tool).unwrap();
        Self {
            robot,
            solver,
            base,
            tip,
            tip_from_tool,
        }
    }

    fn all() -> [Self; 5] {
        [
            Self::new(HUMANOID, "platform", "right_tcp"),
            Self::new(HUMANOID, "world", "right_tcp"),
            Self::new(ARM7, "link_0", "tcp"),
            Self::new(ARM6, "link_0", "tcp"),
            // Five joints for six dimensions.
            Self::new(ARM6, "link_0", "link_5"),
        ]
    }

    /// Positions of the whole robot; variables outside of the chain are zero.
    fn whole(&self, q: &[f64]) -> Vec<f64> {
        let mut all = vec![0.0; self.robot.dof()];
        for (&i, value) in self.solver.chain().variables().iter().zip(q) {
            all[i] = *value;
        }
        all
    }

    fn within_limits(&self, q: &[f64]) -> bool {
        self.robot.limit_faults(&self.whole(q)).unwrap().is_empty()
    }

    fn base_from_tool(&self, q: &[f64]) -> Pose {
        let kinematics = self.robot.forward_kinematics(&self.whole(q)).unwrap();
        let world_from_base = kinematics.world_from_link(self.base);
        world_from_base.inv_mul(&(kinematics.world_from_link(self.tip) * self.tip_from_tool))
    }

    /// Random positions within the limits, the base within 1 m.
    fn sample(&self, random: &mut ChaCha8Rng) -> Vec<f64> {
        loop {
            let position = |&i: &usize| {
                let joint = self.robot.variable(i);
                let (lower, upper) = match (joint.kind, joint.limits.position) {
                    (JointKind::Prismatic, _) => (-1.0, 1.0),
                    (_, Some(range)) => (range.lower, range.upper),
                    (_, None) => (-PI, PI),
                };
                random.random_range(lower..upper)
            };
            let q: Vec<f64> = self
                .solver
                .chain()
                .variables()
                .iter()
                .map(position)
                .collect();
            if self.within_limits(&q) {
                return q;
            }
        }
    }

    /// Returns the faults of a solution.
    fn faults(
        &self,
        q: &[f64],
        target: &Pose,
        goal: RotationGoal,
        config: &IkConfig,
    ) -> Vec<String> {
        let mut faults = Vec::new();
        for fault in self.robot.limit_faults(&self.whole(q)).unwrap() {
            faults.push(fault.to_string());
        }
        let (position, rotation) = apart(&self.base_from_tool(q), target, goal);
        if position > config.position_tolerance + ROUNDING {
            faults.push(format!("{position} m off"));
        }
        if rotation > config.rotation_tolerance + ROUNDING {
            faults.push(format!("turned by {rotation} rad"));
        }
        faults
    }
}

/// Distance [m] and angle [rad] of two poses, the angle from the differences of their axes.
fn apart(a: &Pose, b: &Pose, goal: RotationGoal) -> (f64, f64) {
    let position = (a.translation.vector - b.translation.vector).norm();
    let chord = |axis: Vector3| (a.rotation * axis - b.rotation * axis).norm();
    let (x, y, z) = (
        chord(Vector3::x()),
        chord(Vector3::y()),
        chord(Vector3::z()),
    );
    let rotation = match goal {
        // Σ |Δaxis|² = 8 sin²(θ/2).
        RotationGoal::Full => 2.0 * ((x * x + y * y + z * z) / 8.0).sqrt().min(1.0).asin(),
        RotationGoal::AboutToolZFree => 2.0 * (0.5 * z).min(1.0).asin(),
    };
    (position, rotation)
}

fn solved(outcome: IkOutcome) -> JointPositions {
    match outcome {
        IkOutcome::Solved(q) => q,
        stuck @ IkOutcome::Stuck { .. } => panic!("{stuck:?}"),
    }
}

#[test]
fn poses_in_reach_are_solved_within_the_limits() {
    const COUNT: usize = 500;
    let config = IkConfig::default();
    for bench in Bench::all() {
        for goal in GOALS {
            let mut random = ChaCha8Rng::seed_from_u64(3);
            let mut count = 0;
            for seed in 0..COUNT as u64 {
                let target = bench.base_from_tool(&bench.sample(&mut random));
                let outcome = bench
                    .solver
                    .solve(&target, goal, &[], seed, &config)
                    .unwrap();
                if let IkOutcome::Solved(q) = outcome {
                    assert_eq!(bench.faults(&q, &target, goal, &config), [""; 0]);
                    count += 1;
                }
            }
            assert!(
                count as f64 >= 0.995 * COUNT as f64,
                "{} {goal:?}: {count}",
                bench.robot.name()
            );
        }
    }
}

#[test]
fn the_checker_sees_a_tool_that_is_off_and_a_broken_coupled_limit() {
    let bench = Bench::new(HUMANOID, "platform", "right_tcp");
    let config = IkConfig::default();
    let mut q = bench.sample(&mut ChaCha8Rng::seed_from_u64(1));
    let target = bench.base_from_tool(&q);
    let faults = |q: &[f64], goal| bench.faults(q, &target, goal, &config);
    assert_eq!(faults(&q, RotationGoal::Full), [""; 0]);
    let mut turned = target;
    turned.rotation *= UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 2e-6);
    let found = |goal| bench.faults(&q, &turned, goal, &config).len();
    assert_eq!(
        (
            found(RotationGoal::Full),
            found(RotationGoal::AboutToolZFree)
        ),
        (1, 0)
    );
    q[9] += 1e-4;
    assert_eq!(faults(&q, RotationGoal::Full).len(), 2);
    // torso_2 and torso_3 each within their own limits, their sum not.
    q[1..3].copy_from_slice(&[0.5, 2.3]);
    assert!(faults(&q, RotationGoal::Full)[0].contains("torso_4"));
}

#[test]
fn the_next_pose_of_a_motion_is_near_the_last_positions() {
    let config = IkConfig::default();
    for bench in Bench::all() {
        let mut random = ChaCha8Rng::seed_from_u64(5);
        let (mut count, mut tried) = (0, 0);
        for _ in 0..200 {
            let start = bench.sample(&mut random);
            // A reachable pose: a move of some joints takes the tool about 5 mm further.
            let there: Vec<f64> = start
                .iter()
                .map(|q| q + random.random_range(-0.004..0.004))
                .collect();
            if !bench.within_limits(&there) {
                continue;
            }
            tried += 1;
            let target = bench.base_from_tool(&there);
            let outcome = bench
                .solver
                .solve_from(&target, RotationGoal::Full, &start, &config);
            if let IkOutcome::Solved(q) = outcome.unwrap() {
                let moved = q
                    .iter()
                    .zip(&start)
                    .map(|(a, b)| (a - b).abs())
                    .fold(0.0, f64::max);
                count += usize::from(moved < 0.1);
            }
        }
        // The others are at singularities.
        assert!(
            count as f64 > 0.97 * f64::from(tried),
            "{}: {count} of {tried}",
            bench.robot.name()
        );
    }
}

#[test]
fn a_target_out_of_reach_ends_within_the_limits_and_says_how_far_off() {
    let bench = Bench::new(ARM7, "link_0", "tcp");
    let config = IkConfig::default();
    let target = Pose::from_parts([3.0, 0.0, 0.3].into(), UnitQuaternion::identity());
    let outcome = bench
        .solver
        .solve(&target, RotationGoal::Full, &[], 1, &config)
        .unwrap();
    let IkOutcome::Stuck {
        best,
        position_error,
        rotation_error,
    } = outcome
    else {
        panic!("{outcome:?}");
    };
    assert!(bench.within_limits(&best));
    let (position, rotation) = apart(&bench.base_from_tool(&best), &target, RotationGoal::Full);
    assert!((position - position_error).abs() < 1e-9 && (rotation - rotation_error).abs() < 1e-9);
    // The arm is about a metre long.
    assert!(
        position_error > 1.5 && position_error < 2.5,
        "{position_error}"
    );
}

#[test]
fn the_same_seed_gives_the_same_bytes() {
    let bench = Bench::new(ARM6, "link_0", "tcp");
    let config = IkConfig::default();
    let bits = |outcome| {
        solved(outcome)
            .iter()
            .map(|q| q.to_bits())
            .collect::<Vec<_>>()
    };
    let mut random = ChaCha8Rng::seed_from_u64(9);
    for seed in 0..50 {
        let target = bench.base_from_tool(&bench.sample(&mut random));
        let solve = || {
            bench
                .solver
                .solve(&target, RotationGoal::Full, &[], seed, &config)
                .unwrap()
        };
        let here = solve();
        let elsewhere = std::thread::scope(|scope| scope.spawn(solve).join().unwrap());
        assert_eq!(bits(here), bits(elsewhere));
    }
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter()
        .zip(b)
        .map(|(a, b)| (a - b) * (a - b))
        .sum::<f64>()
        .sqrt()
}

#[test]
fn self_motion_nears_the_posture_while_the_tool_stays() {
    let config = IkConfig {
        limit_gain: 0.0,
        max_iterations: 1000,
        ..IkConfig::default()
    };
    for mut bench in [
        Bench::new(HUMANOID, "platform", "right_tcp"),
        Bench::new(ARM7, "link_0", "tcp"),
    ] {
        let mut random = ChaCha8Rng::seed_from_u64(11);
        for goal in GOALS {
            for _ in 0..20 {
                let posture = bench.sample(&mut random);
                bench.solver = bench.solver.clone().with_posture(&posture).unwrap();
                let start = bench.sample(&mut random);
                let target = bench.base_from_tool(&start);
                let relaxed = bench.solver.relax(goal, &start, &config).unwrap();
                assert_eq!(bench.faults(&relaxed, &target, goal, &config), [""; 0]);
                assert!(distance(&relaxed, &posture) < distance(&start, &posture));
                // A second relaxation changes almost nothing.
                let again = bench.solver.relax(goal, &relaxed, &config).unwrap();
                let (first, second) = (distance(&start, &relaxed), distance(&relaxed, &again));
                assert!(second < 0.01 * first, "{first} rad, then {second} rad");
            }
        }
    }
}

#[test]
fn an_arm_without_redundancy_has_no_self_motion() {
    let bench = Bench::new(ARM6, "link_0", "tcp");
    let start = [0.3, -1.2, 1.4, 0.5, 0.9, 0.2];
    assert!(bench.within_limits(&start));
    let relaxed = bench
        .solver
        .relax(RotationGoal::Full, &start, &IkConfig::default())
        .unwrap();
    assert!(distance(&relaxed, &start) < 1e-4);
}

#[test]
fn self_motion_leaves_the_outer_parts_of_the_limits() {
    let bench = Bench::new(ARM7, "link_0", "tcp");
    let config = IkConfig {
        posture_gain: 0.0,
        max_iterations: 500,
        ..IkConfig::default()
    };
    // Joint 1 is 0.02 rad from its limit of 2.8973 rad, all others are well inside.
    let start = [2.877, 0.6, 0.0, -1.5, 0.0, 1.6, 0.3];
    let relaxed = bench
        .solver
        .relax(RotationGoal::Full, &start, &config)
        .unwrap();
    let target = bench.base_from_tool(&start);
    assert_eq!(
        bench.faults(&relaxed, &target, RotationGoal::Full, &config),
        [""; 0]
    );
    assert!(relaxed[0] < 2.7, "{relaxed:?}");
}

/// Follows a circle of 0.1 m in steps of 5 mm with the local method, and ends at its start.
fn round_a_circle(bench: &Bench, start: &[f64], config: &IkConfig) -> JointPositions {
    let center = bench.base_from_tool(start);
    let steps = 126;
    let mut q = solved(
        bench
            .solver
            .solve_from(&center, RotationGoal::Full, start, config)
            .unwrap(),
    );
    for i in 1..=steps {
        let angle = 2.0 * PI * f64::from(i) / f64::from(steps);
        let mut target = center;
        target.translation.vector += 0.1 * Vector3::new(angle.cos() - 1.0, angle.sin(), 0.0);
        let next = bench
            .solver
            .solve_from(&target, RotationGoal::Full, &q, config)
            .unwrap();
        let next = solved(next);
        assert_eq!(
            bench.faults(&next, &target, RotationGoal::Full, config),
            [""; 0]
        );
        assert!(
            distance(&next, &q) < 0.1,
            "a leap of {} rad",
            distance(&next, &q)
        );
        q = next;
    }
    q
}

#[test]
fn the_null_space_term_draws_a_motion_to_the_posture_without_leaps() {
    let bench = Bench::new(HUMANOID, "platform", "right_tcp");
    let ready = [
        0.0, -48.527, 97.386, -60.532, -107.672, -26.066, 106.409, -5.171, -41.724, 9.236,
    ];
    let ready = ready.map(f64::to_radians);
    let drawn = IkConfig::default();
    let free = IkConfig {
        posture_gain: 0.0,
        limit_gain: 0.0,
        ..drawn
    };
    let posture = *bench.solver.posture();
    let [with, without] = [&drawn, &free].map(|config| {
        let once = round_a_circle(&bench, &ready, config);
        let twice = round_a_circle(&bench, &once, config);
        distance(&round_a_circle(&bench, &twice, config), &posture)
    });
    let relaxed = bench
        .solver
        .relax(RotationGoal::Full, &ready, &drawn)
        .unwrap();
    let nearest = distance(&relaxed, &posture);
    assert!(
        with < nearest + 0.05 && without > nearest + 0.4,
        "{with}, {without}, {nearest} rad"
    );
}

#[test]
fn wrong_input_is_an_error_with_name_value_and_limit() {
    let bench = Bench::new(ARM7, "link_0", "tcp");
    let config = IkConfig::default();
    let q = [0.0, 0.0, 0.0, -1.5, 0.0, 1.5, 0.0];
    let target = bench.base_from_tool(&q);
    let error = |target: &Pose, start: &[f64], config: &IkConfig| {
        let alone = bench
            .solver
            .solve_from(target, RotationGoal::Full, start, config);
        let starts: [&[f64]; 2] = [&q, start];
        let among = bench
            .solver
            .solve(target, RotationGoal::Full, &starts, 1, config);
        assert_eq!(format!("{alone:?}"), format!("{among:?}"));
        alone.unwrap_err().to_string()
    };
    assert_eq!(
        error(&target, &q[..6], &config),
        "positions of the chain has 6 values, the robot has 7 variables"
    );
    let mut odd = q;
    odd[2] = f64::NAN;
    let expected = "joint \"joint_3\": positions of the chain NaN is not finite";
    assert_eq!(error(&target, &odd, &config), expected);
    let mut far = target;
    far.translation.y = f64::INFINITY;
    let expected = "base_from_tool is inf: it must be finite, and no more than 1e6 m";
    assert_eq!(error(&far, &q, &config), expected);
    let none = IkConfig {
        position_tolerance: 0.0,
        ..config
    };
    let expected = "position_tolerance is 0: it must be greater than 0 m";
    assert_eq!(error(&target, &q, &none), expected);
    let much = IkConfig {
        posture_gain: 1.5,
        ..config
    };
    assert_eq!(
        error(&target, &q, &much),
        "posture_gain is 1.5: it must be from 0 to 1"
    );
    assert!(bench.solver.clone().with_posture(&odd).is_err());
    assert!(
        bench
            .solver
            .relax(RotationGoal::Full, &odd, &config)
            .is_err()
    );
    let (base, tip) = (bench.base, bench.tip);
    assert!(IkSolver::new(&bench.robot, base, tip, far).is_err());
    assert!(IkSolver::new(&bench.robot, tip, base, target).is_err());
}

/// A number of any size, sometimes not a number.
fn any_number() -> impl Strategy<Value = f64> {
    prop_oneof![4 => -10.0..10.0, 1 => -1e6..1e6, 1 => prop::num::f64::ANY]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, ..ProptestConfig::default() })]

    #[test]
    fn no_input_panics_and_no_answer_breaks_a_limit(
        which in 0..5_usize,
        position in [any_number(), any_number(), any_number()],
        turn in [-4.0..4.0, -4.0..4.0, -4.0..4.0],
        start in prop::collection::vec(any_number(), 13),
        max_step in any_number(),
        free in any::<bool>(),
    ) {
        let [a, b, c, d, e] = Bench::all();
        let bench = [&a, &b, &c, &d, &e][which];
        let start = &start[..bench.solver.chain().dof()];
        let goal = GOALS[usize::from(free)];
        let turn = UnitQuaternion::from_scaled_axis(Vector3::from(turn));
        let target = Pose::from_parts(position.into(), turn);
        let config = IkConfig { max_step, max_restarts: 3, ..IkConfig::default() };
        let found = bench.solver.solve(&target, goal, &[start], 1, &config);
        let again = bench.solver.solve(&target, goal, &[start], 1, &config);
        prop_assert_eq!(format!("{found:?}"), format!("{again:?}"));
        match found {
            Ok(IkOutcome::Solved(q)) => {
                prop_assert_eq!(bench.faults(&q, &target, goal, &config), [""; 0]);
            }
            Ok(IkOutcome::Stuck { best, position_error, rotation_error }) => {
                prop_assert!(bench.within_limits(&best));
                let (position, rotation) = (config.position_tolerance, config.rotation_tolerance);
                prop_assert!(position_error > position || rotation_error > rotation);
            }
            Err(_) => {}
        }
        if let Ok(relaxed) = bench.solver.relax(goal, start, &config) {
            prop_assert!(bench.within_limits(&relaxed));
        }
    }
}
