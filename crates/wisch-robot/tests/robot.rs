//! The shipped robots: files, golden poses, and kinematics and dynamics as Pinocchio computes them.

#[path = "../examples/robots/arms.rs"]
mod arms;
#[path = "../examples/robots/humanoid.rs"]
mod humanoid;
#[path = "../examples/robots/urdf.rs"]
mod urdf;

use nalgebra::{DMatrix, Matrix4};
use wisch_robot::geometry::{Point3, Pose, Vector3};
use wisch_robot::{RobotModel, Severity, Shape};

const GRAVITY: Vector3 = Vector3::new(0.0, 0.0, -9.81);

/// Largest difference from Pinocchio, relative to the greatest entry of a quantity but at least 1.
const TOLERANCE: f64 = 1e-9;

fn path(folder: &str, file: &str) -> String {
    format!("{}/{folder}/{file}", env!("CARGO_MANIFEST_DIR"))
}

fn committed(file: &str) -> String {
    let path = path("../../robots", file);
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"))
}

fn robot(file: &str) -> RobotModel {
    let no_meshes = &mut |_: &str| Err("the shipped robots have no meshes".to_owned());
    RobotModel::from_urdf(file, &committed(file), no_meshes).unwrap()
}

#[test]
fn committed_files_are_what_the_generator_writes() {
    assert!(committed("humanoid.urdf") == humanoid::humanoid());
    assert!(committed("arm7.urdf") == arms::arm7());
    assert!(committed("arm6.urdf") == arms::arm6());
}

#[test]
fn the_shipped_robots_have_nothing_that_matters_to_report() {
    for (file, dof) in [
        ("humanoid.urdf", 3 + 3 + 7 + 7 + 2),
        ("arm7.urdf", 7),
        ("arm6.urdf", 6),
    ] {
        let robot = robot(file);
        assert_eq!(robot.dof(), dof);
        let matter: Vec<_> = robot
            .diagnostics()
            .iter()
            .filter(|f| f.severity > Severity::Note)
            .collect();
        assert!(matter.is_empty(), "{matter:?}");
        robot.dynamics().unwrap();
    }
}

#[test]
fn cylinders_with_balls_at_their_ends_are_capsules() {
    for file in ["humanoid.urdf", "arm7.urdf", "arm6.urdf"] {
        for link in robot(file).links() {
            for collision in &link.collision {
                let whole = matches!(
                    collision.shape,
                    Shape::Capsule { .. } | Shape::Sphere { .. }
                );
                assert!(whole, "{}: {:?}", link.name, collision.shape);
            }
        }
    }
    let robot = robot("humanoid.urdf");
    let forearm = &robot.links()[robot.link("right_arm_4_link").unwrap().index()];
    let [collision] = &forearm.collision[..] else {
        panic!("{:?}", forearm.collision);
    };
    // From 0.01 to 0.36 m along y.
    assert!(
        matches!(collision.shape, Shape::Capsule { radius, length } if radius == 0.12 && (length - 0.35).abs() < 1e-12)
    );
    let end = collision.link_from_shape * Point3::new(0.0, 0.0, 0.175);
    assert!((end - Point3::new(0.0, 0.36, 0.0)).norm() < 1e-12);
}

/// Positions of the humanoid's variables by name [deg]; all others are zero.
fn humanoid_at(robot: &RobotModel, degrees: &[(&str, f64)]) -> Vec<f64> {
    let mut q = vec![0.0; robot.dof()];
    for (name, value) in degrees {
        let joint = robot.joint(name).unwrap();
        let variable = robot.variables().iter().position(|v| *v == joint);
        q[variable.unwrap()] = value.to_radians();
    }
    q
}

const READY: [(&str, f64); 10] = [
    ("torso_1", 0.0),
    ("torso_2", -48.527),
    ("torso_3", 97.386),
    ("right_arm_1", -60.532),
    ("right_arm_2", -107.672),
    ("right_arm_3", -26.066),
    ("right_arm_4", 106.409),
    ("right_arm_5", -5.171),
    ("right_arm_6", -41.724),
    ("right_arm_7", 9.236),
];

fn platform_from(robot: &RobotModel, q: &[f64], link: &str) -> Pose {
    let kinematics = robot.forward_kinematics(q).unwrap();
    let world_from_platform = kinematics.world_from_link(robot.link("platform").unwrap());
    world_from_platform.inv_mul(&kinematics.world_from_link(robot.link(link).unwrap()))
}

/// Published positions of the right TCP in the frame of the platform, to the digits printed.
#[test]
fn the_humanoid_reaches_where_it_is_known_to() {
    let robot = robot("humanoid.urdf");
    let golden = [
        (humanoid_at(&robot, &[]), [0.0880, -1.0423, 1.9379]),
        (humanoid_at(&robot, &READY), [0.1731, -0.2228, 0.8110]),
    ];
    for (q, expected) in golden {
        let tcp = platform_from(&robot, &q, "right_tcp").translation.vector;
        let apart = (tcp - Vector3::from(expected)).amax();
        // Half a unit of the last digit, and 3e-5 m by which the published models differ.
        assert!(apart < 5e-5 + 3e-5, "{tcp:?} is {apart} m off {expected:?}");
    }
}

#[test]
fn the_left_arm_mirrors_the_right_one() {
    let robot = robot("humanoid.urdf");
    let right = humanoid_at(&robot, &READY);
    let mut left = READY.map(|(name, value)| (name.replace("right", "left"), value));
    left.sort_by(|a, b| a.0.cmp(&b.0));
    let left: Vec<(&str, f64)> = left
        .iter()
        .map(|(name, value)| (name.as_str(), *value))
        .collect();
    let left = humanoid_at(&robot, &left);
    for i in 1..=7 {
        let center = |side: &str, q: &[f64]| {
            let name = format!("{side}_arm_{i}_link");
            let body = robot.links()[robot.link(&name).unwrap().index()]
                .body
                .unwrap();
            platform_from(&robot, q, &name) * body.center_in_link
        };
        let (right, left) = (center("right", &right), center("left", &left));
        let mirrored = Point3::new(left.x, -left.y, left.z);
        assert!(
            (right - mirrored).norm() < 1e-12,
            "link {i}: {right} and {left}"
        );
    }
    let right = platform_from(&robot, &right, "right_tcp")
        .translation
        .vector;
    let left = platform_from(&robot, &left, "left_tcp").translation.vector;
    assert!((right - Vector3::new(left.x, -left.y, left.z)).norm() < 1e-12);
}

/// If q2 < 0 then q3 is in [−q2, 135°], else in [0, 135° − q2].
#[test]
fn the_torso_is_coupled() {
    let robot = robot("humanoid.urdf");
    let free = |q2: f64, q3: f64| {
        let q = humanoid_at(&robot, &[("torso_2", q2), ("torso_3", q3)]);
        robot.limit_faults(&q).unwrap().is_empty()
    };
    for q2 in -90..=90 {
        for q3 in -10..=140 {
            let (q2, q3) = (f64::from(q2) + 0.5, f64::from(q3) + 0.25);
            let allowed = if q2 < 0.0 {
                (-q2..=135.0).contains(&q3)
            } else {
                (0.0..=135.0 - q2).contains(&q3)
            };
            let own = (-70.0..=30.0).contains(&q2) && (10.0..=134.0).contains(&q3);
            let allowed = allowed && own;
            assert_eq!(free(q2, q3), allowed, "{q2} {q3}");
        }
    }
    // The paper's robot turns further to one side than to the other; its successor's limits are symmetric.
    let torso_1 = robot.joints()[robot.joint("torso_1").unwrap().index()].limits;
    let range = torso_1.position.unwrap();
    assert!((range.lower.to_degrees() + 100.0).abs() < 1e-9);
    assert!((range.upper.to_degrees() - 190.0).abs() < 1e-9);
    let q = humanoid_at(&robot, &[("torso_2", -30.0), ("torso_3", 20.0)]);
    let faults = robot.limit_faults(&q).unwrap();
    assert_eq!(faults[0].joint, "torso_4");
}

/// Products of Denavit–Hartenberg matrices, apart from the generator's frames.
#[test]
fn the_arms_follow_their_published_tables() {
    let craig = |[a, alpha, d, theta]: [f64; 4]| -> Matrix4<f64> {
        let t = |x, y, z| Matrix4::new_translation(&Vector3::new(x, y, z));
        let rx = Matrix4::from_axis_angle(&Vector3::x_axis(), alpha);
        let rz = Matrix4::from_axis_angle(&Vector3::z_axis(), theta);
        rx * t(a, 0.0, 0.0) * rz * t(0.0, 0.0, d)
    };
    let standard = |[a, alpha, d, theta]: [f64; 4]| -> Matrix4<f64> {
        let t = |x, y, z| Matrix4::new_translation(&Vector3::new(x, y, z));
        let rx = Matrix4::from_axis_angle(&Vector3::x_axis(), alpha);
        let rz = Matrix4::from_axis_angle(&Vector3::z_axis(), theta);
        rz * t(0.0, 0.0, d) * t(a, 0.0, 0.0) * rx
    };
    let right = std::f64::consts::FRAC_PI_2;
    // a, alpha, d
    let panda = [
        [0.0, 0.0, 0.333],
        [0.0, -right, 0.0],
        [0.0, right, 0.316],
        [0.0825, right, 0.0],
        [-0.0825, -right, 0.384],
        [0.0, right, 0.0],
        [0.088, right, 0.0],
        [0.0, 0.0, 0.107],
    ];
    let ur5 = [
        [0.0, right, 0.089159],
        [-0.425, 0.0, 0.0],
        [-0.39225, 0.0, 0.0],
        [0.0, right, 0.10915],
        [0.0, -right, 0.09465],
        [0.0, 0.0, 0.0823],
    ];
    let q = [0.3, -0.7, 1.1, -1.9, 0.4, 2.2, -0.6, 0.0];
    let product = |table: &[[f64; 3]], link: &dyn Fn([f64; 4]) -> Matrix4<f64>| {
        table
            .iter()
            .zip(q)
            .fold(Matrix4::identity(), |m, (&[a, alpha, d], q)| {
                m * link([a, alpha, d, q])
            })
    };
    for (file, n, expected) in [
        ("arm7.urdf", 7, product(&panda, &craig)),
        ("arm6.urdf", 6, product(&ur5, &standard)),
    ] {
        let robot = robot(file);
        let tcp = robot.link("tcp").unwrap();
        let pose = robot
            .forward_kinematics(&q[..n])
            .unwrap()
            .world_from_link(tcp);
        let apart = (pose.to_homogeneous() - expected).amax();
        assert!(apart < 1e-12, "{file} is {apart} off");
    }
}

/// One state as `peers/robot.py` recorded it.
struct Recorded(Vec<(String, Vec<f64>)>);

impl Recorded {
    fn get(&self, name: &str) -> &[f64] {
        &self.0.iter().find(|(n, _)| n == name).unwrap().1
    }

    fn matrix(&self, name: &str, rows: usize) -> DMatrix<f64> {
        let values = self.get(name);
        DMatrix::from_row_slice(rows, values.len() / rows, values)
    }

    #[track_caller]
    fn agrees(&self, name: &str, found: &DMatrix<f64>) {
        let expected = self.matrix(name, found.nrows());
        let scale = expected.amax().max(1.0);
        let apart = (found - expected).amax() / scale;
        assert!(apart < TOLERANCE, "{name} is {apart:e} off");
    }
}

fn recorded(file: &str) -> Vec<Recorded> {
    let text = std::fs::read_to_string(path("tests/data", file)).unwrap();
    let mut states: Vec<Recorded> = Vec::new();
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let mut words = line.split(',');
        let name = words.next().unwrap().to_owned();
        if name == "q" {
            states.push(Recorded(Vec::new()));
        }
        let values = words.map(|word| word.parse().unwrap()).collect();
        states.last_mut().unwrap().0.push((name, values));
    }
    states
}

fn agrees_with_pinocchio(file: &str, recording: &str, tcp: &str, n: usize) {
    let robot = robot(file);
    let dynamics = robot.dynamics().unwrap();
    let tcp = robot.link(tcp).unwrap();
    let chain = robot.chain(robot.root(), tcp).unwrap();
    assert_eq!(chain.dof(), n);
    let own = chain.variables();
    let whole = |values: &[f64]| {
        let mut q = vec![0.0; robot.dof()];
        own.iter().zip(values).for_each(|(&i, &value)| q[i] = value);
        q
    };
    let states = recorded(recording);
    assert_eq!(states.len(), 20);
    for state in &states {
        let [q, qd, qdd] = ["q", "qd", "qdd"].map(|name| whole(state.get(name)));
        let kinematics = robot.forward_kinematics(&q).unwrap();
        let rows = |pose: Pose| {
            let matrix = pose.to_homogeneous();
            DMatrix::from_fn(3, 4, |i, j| matrix[(i, j)])
        };
        let pose = rows(kinematics.world_from_link(tcp));
        let expected = state.matrix("world_from_tcp", 3);
        assert!((pose - expected).amax() < TOLERANCE);
        let picked = |vector: nalgebra::DVector<f64>| DMatrix::from_fn(1, n, |_, i| vector[own[i]]);

        let jacobian = kinematics.jacobian(tcp, Point3::origin());
        state.agrees(
            "jacobian",
            &DMatrix::from_fn(6, n, |i, j| jacobian[(i, own[j])]),
        );
        let mass = dynamics.mass_matrix(&q).unwrap();
        state.agrees(
            "mass_matrix",
            &DMatrix::from_fn(n, n, |i, j| mass[(own[i], own[j])]),
        );
        state.agrees("bias", &picked(dynamics.bias(&q, &qd, GRAVITY).unwrap()));
        state.agrees("gravity", &picked(dynamics.gravity(&q, GRAVITY).unwrap()));
        let effort = dynamics.inverse_dynamics(&q, &qd, &qdd, GRAVITY).unwrap();
        state.agrees("inverse_dynamics", &picked(effort));

        let quick = chain.forward_kinematics(state.get("q")).unwrap();
        let apart = rows(quick.base_from_tip()) - state.matrix("world_from_tcp", 3);
        assert!(apart.amax() < TOLERANCE);
        let jacobian = quick.jacobian(Point3::origin());
        state.agrees(
            "jacobian",
            &DMatrix::from_fn(6, n, |i, j| jacobian.view()[(i, j)]),
        );
    }
}

#[test]
fn six_joints_agree_with_pinocchio() {
    agrees_with_pinocchio("arm6.urdf", "pinocchio-arm6.csv", "tcp", 6);
}

#[test]
fn seven_joints_agree_with_pinocchio() {
    agrees_with_pinocchio("arm7.urdf", "pinocchio-arm7.csv", "tcp", 7);
}

#[test]
fn base_torso_and_arm_agree_with_pinocchio() {
    agrees_with_pinocchio("humanoid.urdf", "pinocchio-humanoid.csv", "right_tcp", 13);
}
