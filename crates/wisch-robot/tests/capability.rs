//! The capability map: against closed form, forward kinematics, threads and damaged files.

use proptest::prelude::*;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::{FRAC_PI_3, PI};
use std::sync::LazyLock;
use std::sync::atomic::{AtomicU64, Ordering};
use wisch_robot::geometry::{Point3, Pose, Vector3};
use wisch_robot::{
    CapabilityMap, CollisionModel, IkConfig, IkOutcome, IkSolver, MapConfig, MapError, MapRequest,
    MapStage, RobotHash, RobotModel, RotationGoal,
};

fn read(text: &str) -> RobotModel {
    RobotModel::from_urdf("test.urdf", text, &mut |_| Err("no meshes".into())).unwrap()
}

/// Lengths of the telescope [m].
const SHORT: f64 = 0.3;
const LONG: f64 = 0.6;

/// A telescope that points anywhere from the origin, with a tool at its end that bends away from it:
/// the tool is reached where it is [`SHORT`] to [`LONG`] from the origin and its axis is within `bend`
/// of the direction from the origin to it.
fn telescope(bend: f64) -> RobotModel {
    let joint = |name: &str, kind: &str, child: &str, parent: &str, axis: &str, limits: &str| {
        format!(
            r#"<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>
               <axis xyz="{axis}"/>{limits}</joint><link name="{child}"/>"#
        )
    };
    let between = |lower, upper| format!(r#"<limit lower="{lower}" upper="{upper}"/>"#);
    let turn = PI / 2.0;
    read(&format!(
        r#"<robot name="telescope"><link name="floor"/>{}{}{}{}{}{}</robot>"#,
        joint(
            "lamp",
            "revolute",
            "bulb",
            "floor",
            "0 0 1",
            &between(-1.0, 1.0)
        ),
        joint("yaw", "continuous", "turret", "floor", "0 0 1", ""),
        joint(
            "pitch",
            "revolute",
            "tube",
            "turret",
            "0 1 0",
            &between(-turn, turn)
        ),
        joint(
            "slide",
            "prismatic",
            "rod",
            "tube",
            "1 0 0",
            &between(SHORT, LONG)
        ),
        joint("roll", "continuous", "wrist", "rod", "1 0 0", ""),
        joint(
            "bend",
            "revolute",
            "tool",
            "wrist",
            "0 1 0",
            &between(-bend, bend)
        ),
    ))
}

/// The tool of the telescope points along x of its last link.
fn tip_from_tool() -> Pose {
    Pose::rotation(Vector3::y() * (PI / 2.0))
}

fn is_in_reach(base_from_tool: &Pose, bend: f64) -> bool {
    let radius = base_from_tool.translation.vector;
    let axis = base_from_tool.rotation * Vector3::z();
    (SHORT..=LONG).contains(&radius.norm()) && axis.angle(&radius) <= bend
}

const CONFIG: MapConfig = MapConfig {
    voxel: 0.075,
    frequency: 4,
    samples: 20_000,
    seed: 7,
    starts: 3,
    refinements: 4,
};

fn tool<'a>(robot: &'a RobotModel, posture: &'a [f64]) -> MapRequest<'a> {
    MapRequest {
        robot,
        base: robot.root(),
        tip: robot.link("tool").unwrap(),
        tip_from_tool: tip_from_tool(),
        posture,
    }
}

fn build(robot: &RobotModel, config: &MapConfig) -> Result<CapabilityMap, MapError> {
    let posture = vec![0.0; robot.dof()];
    CapabilityMap::build(&tool(robot, &posture), |_| true, config, |_, _, _| {})
}

/// Coarse, so that the map takes little time.
const COARSE: MapConfig = MapConfig {
    voxel: 0.12,
    frequency: 2,
    samples: 5_000,
    ..CONFIG
};

static TELESCOPE: LazyLock<(RobotModel, CapabilityMap)> = LazyLock::new(|| {
    let robot = telescope(FRAC_PI_3);
    let map = build(&robot, &CONFIG).unwrap();
    (robot, map)
});

/// Place uniform in a ball, direction uniform on the sphere.
fn random_pose(random: &mut ChaCha8Rng, radius: f64) -> Pose {
    let mut in_ball = || loop {
        let v = Vector3::from_fn(|_, _| 2.0 * random.random::<f64>() - 1.0);
        if v.norm() <= 1.0 {
            return v;
        }
    };
    let place = radius * in_ball();
    pose(&place, &in_ball())
}

fn pose(place: &Vector3, axis: &Vector3) -> Pose {
    let rotation = nalgebra::UnitQuaternion::rotation_between(&Vector3::z(), axis);
    let over = nalgebra::UnitQuaternion::from_axis_angle(&Vector3::x_axis(), PI);
    Pose::from_parts((*place).into(), rotation.unwrap_or(over))
}

/// Share of poses in a ball of 0.7 m for which a map and the closed form agree.
fn agreement(map: &CapabilityMap, bend: f64) -> f64 {
    const POSES: usize = 20_000;
    let mut random = ChaCha8Rng::seed_from_u64(1);
    let agrees = |_: &usize| {
        let pose = random_pose(&mut random, 0.7);
        map.is_reachable(&pose) == is_in_reach(&pose, bend)
    };
    (0..POSES).filter(agrees).count() as f64 / POSES as f64
}

#[test]
fn a_telescope_reaches_a_shell_and_a_cone() {
    let (_, map) = &*TELESCOPE;
    let share = agreement(map, FRAC_PI_3);
    assert!(share > 0.985, "{share}");
    // The comparison detects the map of another telescope.
    let share = agreement(map, FRAC_PI_3 + 0.2);
    assert!(share < 0.97, "{share}");
}

proptest! {
    #[test]
    fn well_inside_it_is_reached_and_well_outside_it_is_not(seed in any::<u64>()) {
        let (_, map) = &*TELESCOPE;
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let pose = random_pose(&mut random, 0.75);
        let radius = pose.translation.vector;
        let angle = (pose.rotation * Vector3::z()).angle(&radius);
        // Distances to the boundary in cells: voxels, and directions 18 degrees apart. At the centre
        // of the sphere of places the cone turns within a cell, as it does for the inner radius.
        let spacing = 2.0 * (4.0_f64 / 162.0).sqrt() * 0.9;
        let inside = ((radius.norm() - SHORT).min(LONG - radius.norm()) / CONFIG.voxel)
            .min((FRAC_PI_3 - angle) / spacing);
        let reachability = map.reachability(&pose);
        prop_assert!((0.0..=1.0).contains(&reachability));
        prop_assert!(inside < 1.0 || map.is_reachable(&pose), "{inside} cells inside: {reachability}");
        prop_assert!(inside > -1.0 || !map.is_reachable(&pose), "{inside} cells outside: {reachability}");
    }

    #[test]
    fn the_tool_may_turn_about_its_axis(seed in any::<u64>(), angle in -PI..PI) {
        let (_, map) = &*TELESCOPE;
        let pose = random_pose(&mut ChaCha8Rng::seed_from_u64(seed), 0.6);
        let turned = pose * Pose::rotation(Vector3::z() * angle);
        prop_assert!((map.reachability(&pose) - map.reachability(&turned)).abs() < 1e-9);
    }

    #[test]
    fn odd_poses_are_out_of_reach(x in odd(), y in odd(), z in odd()) {
        prop_assume!(!x.is_finite() || !y.is_finite() || !z.is_finite() || x.abs() + y.abs() + z.abs() > 1e3);
        let (_, map) = &*TELESCOPE;
        prop_assert_eq!(map.reachability(&Pose::translation(x, y, z)), 0.0);
        prop_assert_eq!(map.index(&Point3::new(x, y, z)), 0.0);
    }
}

fn odd() -> impl Strategy<Value = f64> {
    prop::sample::select(vec![
        0.0,
        0.5,
        1e4,
        -1e300,
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
    ])
}

#[test]
fn the_index_is_the_share_of_the_sphere_that_the_cone_has() {
    let (_, map) = &*TELESCOPE;
    let expected = (1.0 - FRAC_PI_3.cos()) / 2.0;
    let mut random = ChaCha8Rng::seed_from_u64(3);
    const POINTS: u32 = 100;
    let mut mean = 0.0;
    for _ in 0..POINTS {
        let axis = random_pose(&mut random, 1.0).rotation * Vector3::z();
        let index = map.index(&Point3::from(0.45 * axis));
        mean += index / f64::from(POINTS);
        // The edge of the cone passes through some 30 directions, each known to one part in five.
        assert!(
            (index - expected).abs() < 0.03,
            "{index}, expected {expected}"
        );
        assert_eq!(map.index(&Point3::from(0.8 * axis)), 0.0);
    }
    assert!(
        (mean - expected).abs() < 0.01,
        "{mean}, expected {expected}"
    );
}

#[test]
fn what_forward_kinematics_reaches_is_in_the_map() {
    let (robot, map) = &*TELESCOPE;
    let tool = robot.link("tool").unwrap();
    let mut random = ChaCha8Rng::seed_from_u64(4);
    let mut found = 0;
    const POSES: u32 = 5_000;
    for _ in 0..POSES {
        let q: Vec<f64> = (0..robot.dof())
            .map(|i| {
                let range = robot.variable(i).limits.position;
                let (lower, upper) = range.map_or((-PI, PI), |r| (r.lower, r.upper));
                lower + (upper - lower) * random.random::<f64>()
            })
            .collect();
        let kinematics = robot.forward_kinematics(&q).unwrap();
        let base_from_tool = kinematics.world_from_link(tool) * tip_from_tool();
        found += u32::from(map.is_reachable(&base_from_tool));
        // Even at the boundary, half of the cell of a pose can be reached.
        assert!(map.reachability(&base_from_tool) > 0.1);
    }
    // A sample within a tenth of a cell of the boundary may be missed. The range of the slide is four
    // cells wide and has two ends, that of the bend three and one: 5 % and 3 %.
    assert!(f64::from(found) > 0.92 * f64::from(POSES), "{found}");
}

#[test]
fn what_collides_is_not_reached() {
    let robot = telescope(FRAC_PI_3);
    let pitch = 2;
    assert_eq!(robot.variable(pitch).name, "pitch");
    let lamp = 0.25;
    let mut posture = vec![0.0; robot.dof()];
    posture[0] = lamp;
    // Pitching down is a collision, unless the joint outside of the chain has another position.
    let is_free = |q: &[f64]| q[0] == lamp && q[pitch] < 0.0;
    let map =
        CapabilityMap::build(&tool(&robot, &posture), is_free, &COARSE, |_, _, _| {}).unwrap();
    let mut random = ChaCha8Rng::seed_from_u64(5);
    for _ in 0..2_000 {
        let pose = random_pose(&mut random, 0.7);
        if pose.translation.z < -COARSE.voxel {
            assert!(!map.is_reachable(&pose));
        }
    }
    assert!(map.is_reachable(&pose(&(Vector3::z() * 0.45), &Vector3::z())));
    let nowhere = CapabilityMap::build(&tool(&robot, &posture), |_| false, &COARSE, |_, _, _| {});
    assert_eq!(
        nowhere,
        Err(MapError::NothingReached {
            samples: COARSE.samples
        })
    );
}

/// Share of poses in the ball that arm6 could reach at most for which its map agrees with inverse
/// kinematics from many starts, checked for collision.
#[test]
fn the_map_of_an_arm_agrees_with_inverse_kinematics() {
    let text = include_str!("../../../robots/arm6.urdf");
    let robot = read(text);
    let posture = vec![0.0; robot.dof()];
    let tool = MapRequest {
        robot: &robot,
        base: robot.root(),
        tip: robot.link("tcp").unwrap(),
        tip_from_tool: Pose::identity(),
        posture: &posture,
    };
    let collisions = CollisionModel::new(&robot, None).unwrap();
    let is_free = |q: &[f64]| collisions.collision(q, 0.0).unwrap().is_none();
    let config = MapConfig {
        voxel: 0.12,
        frequency: 3,
        samples: 20_000,
        ..CONFIG
    };
    let map = CapabilityMap::build(&tool, is_free, &config, |_, _, _| {}).unwrap();
    let solver = IkSolver::new(&robot, tool.base, tool.tip, tool.tip_from_tool).unwrap();
    let mut random = ChaCha8Rng::seed_from_u64(6);
    const POSES: usize = 200;
    const STARTS: usize = 30;
    let (mut agree, mut solved) = (0, 0);
    for _ in 0..POSES {
        let pose = Pose::translation(0.0, 0.0, 0.089) * random_pose(&mut random, 1.1);
        let is_solved = (0..STARTS).any(|_| {
            let q: Vec<f64> = (0..6)
                .map(|_| PI * (2.0 * random.random::<f64>() - 1.0))
                .collect();
            let free = RotationGoal::AboutToolZFree;
            let outcome = solver.solve_from(&pose, free, &q, &IkConfig::default());
            matches!(outcome.unwrap(), IkOutcome::Solved(q) if is_free(&q))
        });
        agree += usize::from(map.is_reachable(&pose) == is_solved);
        solved += usize::from(is_solved);
    }
    // More than twice as coarse as by default. Some poses are solved, and some are not.
    assert!(agree * 100 > 95 * POSES, "{agree} of {POSES} agree");
    assert!(
        (POSES / 5..4 * POSES / 5).contains(&solved),
        "{solved} of {POSES} are solved"
    );
}

#[test]
fn the_map_is_the_same_on_any_number_of_threads() {
    let robot = telescope(FRAC_PI_3);
    let maps = [1, 3].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.unwrap()
            .install(|| build(&robot, &COARSE).unwrap().to_bytes())
    });
    assert!(maps[0] == maps[1]);
    let other = build(&robot, &MapConfig { seed: 8, ..COARSE }).unwrap();
    assert!(maps[0] != other.to_bytes());
}

#[test]
fn progress_reaches_its_end() {
    let robot = telescope(FRAC_PI_3);
    let most = [(); 3].map(|()| AtomicU64::new(0));
    let progress = |stage: MapStage, done: u64, total: u64| {
        assert!(done <= total);
        most[stage as usize].fetch_max(done, Ordering::Relaxed);
    };
    let posture = vec![0.0; robot.dof()];
    CapabilityMap::build(&tool(&robot, &posture), |_| true, &COARSE, progress).unwrap();
    let [sampled, spread, refined] = most.map(AtomicU64::into_inner);
    assert_eq!(sampled, COARSE.samples);
    assert!(spread > 0 && refined > 0);
}

#[test]
fn bytes_come_back_as_the_same_map() {
    let (robot, map) = &*TELESCOPE;
    let bytes = map.to_bytes();
    let hash = RobotHash::from_robot(robot);
    let back = CapabilityMap::from_bytes("telescope.map", &bytes, hash).unwrap();
    assert!(&back == map);
    assert_eq!(back.origin().config, CONFIG);
    assert_eq!(back.origin().base, "floor");
    assert_eq!(back.origin().tip, "tool");
    let cells = map.shape().0.iter().product::<usize>() * map.shape().1;
    assert!(
        bytes.len() * 16 < cells,
        "{} bytes for {cells} cells",
        bytes.len()
    );
}

fn refusal(bytes: &[u8], robot: &RobotModel) -> String {
    let refused = CapabilityMap::from_bytes("a.map", bytes, RobotHash::from_robot(robot));
    refused.map(|_| ()).unwrap_err().to_string()
}

#[test]
fn wrong_files_are_refused_with_what_is_wrong() {
    let (robot, map) = &*TELESCOPE;
    let bytes = map.to_bytes();
    assert_eq!(
        refusal(b"solid cube and more", robot),
        r#"a.map: no capability map: it does not begin with "wischmap""#
    );
    assert_eq!(
        refusal(b"wisc", robot),
        "a.map: no capability map: it ends too early"
    );
    let mut newer = bytes.clone();
    newer[8] = 3;
    assert_eq!(
        refusal(&newer, robot),
        "a.map: capability map of format 3, this program reads format 2: build it again with `wisch robot map`"
    );
    assert_eq!(
        refusal(&bytes[..bytes.len() - 1], robot),
        "a.map: no capability map: its checksum is wrong: it is cut short or damaged"
    );
    let other = telescope(1.0);
    let (found, expected) = (RobotHash::from_robot(robot), RobotHash::from_robot(&other));
    assert_eq!(
        refusal(&bytes, &other),
        format!(
            "a.map: capability map of another robot (it has {found}, the robot is {expected}): build it again with `wisch robot map`"
        )
    );
}

proptest! {
    #[test]
    fn a_damaged_or_truncated_file_is_an_error(at in any::<prop::sample::Index>(), bit in 0u8..8) {
        let (robot, map) = &*TELESCOPE;
        let hash = RobotHash::from_robot(robot);
        let bytes = map.to_bytes();
        let at = at.index(bytes.len());
        prop_assert!(CapabilityMap::from_bytes("a.map", &bytes[..at], hash).is_err());
        let mut damaged = bytes;
        damaged[at] ^= 1 << bit;
        prop_assert!(CapabilityMap::from_bytes("a.map", &damaged, hash).is_err());
    }
}

#[test]
fn settings_out_of_range_are_refused_by_name() {
    let robot = telescope(FRAC_PI_3);
    for (config, message) in [
        (
            MapConfig {
                voxel: 0.0,
                ..CONFIG
            },
            "map.voxel: 0 is outside 0.001 to 10",
        ),
        (
            MapConfig {
                voxel: f64::NAN,
                ..CONFIG
            },
            "map.voxel: NaN is outside 0.001 to 10",
        ),
        (
            MapConfig {
                frequency: 0,
                ..CONFIG
            },
            "map.frequency: 0 is outside 1 to 32",
        ),
        (
            MapConfig {
                samples: 0,
                ..CONFIG
            },
            "map.samples: 0 is outside 1 to 1000000000000",
        ),
        (
            MapConfig {
                starts: 0,
                ..CONFIG
            },
            "map.starts: 0 is outside 1 to 100",
        ),
        (
            MapConfig {
                refinements: 101,
                ..CONFIG
            },
            "map.refinements: 101 is outside 0 to 100",
        ),
        (
            MapConfig {
                voxel: 0.002,
                ..CONFIG
            },
            "map of 221445125 voxels of 0.002 m (reach 0.60 m) in 162 directions exceeds the limit of 1073741824 cells",
        ),
    ] {
        let refused = build(&robot, &config).map(|_| ());
        assert_eq!(refused.unwrap_err().to_string(), message);
    }
}

#[test]
fn a_slide_without_end_is_refused() {
    let robot = read(
        r#"<robot name="rail"><link name="floor"/><link name="tool"/>
           <joint name="rail" type="prismatic"><parent link="floor"/><child link="tool"/></joint></robot>"#,
    );
    let refused = build(&robot, &CONFIG).map(|_| ());
    assert_eq!(
        refused.unwrap_err().to_string(),
        r#"joint "rail" slides without limits, so its reach is unbounded: give it position limits"#
    );
}

#[test]
fn a_chain_without_joints_reaches_one_pose() {
    let robot = read(
        r#"<robot name="post"><link name="floor"/><link name="tool"/>
           <joint name="post" type="fixed"><parent link="floor"/><child link="tool"/></joint></robot>"#,
    );
    let map = build(&robot, &COARSE).unwrap();
    assert!(map.reachability(&tip_from_tool()) > 0.0);
    assert_eq!(map.reachability(&Pose::translation(0.0, 0.0, 0.3)), 0.0);
}

/// The directions of a map are never exactly down for this frequency, and no joint tilts the tool.
#[test]
fn an_arm_that_cannot_tilt_its_tool_has_no_map() {
    let joint = |kind: &str, parent: &str, child: &str, x: f64, limits: [f64; 2]| {
        let [lower, upper] = limits;
        format!(
            r#"<link name="{child}"/><joint name="{child}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>
               <origin xyz="{x} 0 0"/><axis xyz="0 0 1"/><limit lower="{lower}" upper="{upper}"/></joint>"#
        )
    };
    let scara = read(&format!(
        r#"<robot name="scara"><link name="floor"/>{}{}{}{}</robot>"#,
        joint("revolute", "floor", "upper", 0.0, [-2.0, 2.0]),
        joint("revolute", "upper", "lower", 0.35, [-2.0, 2.0]),
        joint("prismatic", "lower", "quill", 0.3, [-0.2, 0.0]),
        joint("revolute", "quill", "tool", 0.0, [-3.0, 3.0]),
    ));
    let posture = vec![0.0; scara.dof()];
    let down = MapRequest {
        tip_from_tool: Pose::rotation(Vector3::x() * PI),
        ..tool(&scara, &posture)
    };
    let config = MapConfig {
        frequency: 3,
        ..COARSE
    };
    let map = CapabilityMap::build(&down, |_| true, &config, |_, _, _| {});
    let error = map.map(|_| ()).unwrap_err();
    assert!(
        matches!(error, MapError::NoCenterReached { cells } if cells > 10),
        "{error}"
    );
    assert!(error.to_string().ends_with("work without a map"), "{error}");
}

#[test]
fn the_hash_tells_reach_apart_and_nothing_else() {
    let hash = |text: &str| RobotHash::from_robot(&read(text));
    let arm = r#"<robot name="r"><link name="wall"/><link name="rod">
        <inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
        <collision><geometry><sphere radius="0.1"/></geometry></collision></link>
        <joint name="pivot" type="revolute"><origin xyz="0 0 1" rpy="0 3.141592653589793 0"/>
        <parent link="wall"/><child link="rod"/><limit lower="-1" upper="1" velocity="2" effort="3"/></joint></robot>"#;
    for same in [
        ("\n", "\n\n  "),
        ("mass value=\"1\"", "mass value=\"2\""),
        ("velocity=\"2\"", "velocity=\"1\""),
        ("3.141592653589793", "3.1415926535897"),
        ("3.141592653589793", "-3.141592653589793"),
    ] {
        assert!(arm.contains(same.0));
        assert_eq!(hash(arm), hash(&arm.replace(same.0, same.1)), "{same:?}");
    }
    for other in [
        ("0 0 1\"", "0 0 1.001\""),
        ("upper=\"1\"", "upper=\"1.1\""),
        ("radius=\"0.1\"", "radius=\"0.2\""),
        ("\"revolute\"", "\"prismatic\""),
        ("pivot", "hinge"),
    ] {
        assert!(arm.contains(other.0));
        assert_ne!(hash(arm), hash(&arm.replace(other.0, other.1)), "{other:?}");
    }
}
