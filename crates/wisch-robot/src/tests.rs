//! Tests of properties that hold for any robot, and of faults in descriptions.

use super::*;
use crate::geometry::{Point3, Pose, Vector3};
use nalgebra::{DVector, UnitQuaternion};
use proptest::prelude::*;
use proptest::sample::Index;

const HUMANOID: &str = include_str!("../../../robots/humanoid.urdf");
const ARM6: &str = include_str!("../../../robots/arm6.urdf");
const GRAVITY: Vector3 = Vector3::new(0.0, 0.0, -9.81);

fn no_meshes(_: &str) -> Result<Vec<u8>, String> {
    Err("there are no meshes".to_owned())
}

fn robot(text: &str) -> RobotModel {
    RobotModel::from_urdf("test.urdf", text, &mut no_meshes).unwrap()
}

/// Returns the URDF of a robot of two links, with `between` between them.
fn two_links(between: &str) -> String {
    format!(
        r#"<robot name="r"><link name="a"/><link name="b"><inertial><mass value="1"/>
        <inertia ixx="1" iyy="1" izz="1"/></inertial>
        <collision><geometry><sphere radius="0.1"/></geometry></collision></link>{between}</robot>"#
    )
}

const HINGE: &str = r#"<joint name="j" type="revolute"><parent link="a"/><child link="b"/>
    <axis xyz="0 0 1"/><limit lower="-1" upper="1" velocity="1" effort="1" acceleration="1"/></joint>"#;

fn found(text: &str) -> Vec<Diagnostic> {
    check("test.urdf", text, &mut no_meshes).unwrap()
}

fn faults(text: &str) -> Vec<(Severity, DiagnosticKind)> {
    found(text).iter().map(|f| (f.severity, f.kind)).collect()
}

#[test]
fn a_sound_robot_has_no_findings() {
    assert_eq!(faults(&two_links(HINGE)), []);
}

#[test]
fn every_fault_is_found() {
    use Severity::{Error, Note, Warning};
    let cases: &[(&str, &str, Severity, DiagnosticKind)] = &[
        (
            r#"xyz="0 0 1""#,
            r#"xyz="0 0 2""#,
            Warning,
            DiagnosticKind::Axis,
        ),
        (
            r#"xyz="0 0 1""#,
            r#"xyz="0 0 0""#,
            Error,
            DiagnosticKind::Axis,
        ),
        (r#"velocity="1""#, "", Warning, DiagnosticKind::LimitMissing),
        (
            r#"velocity="1""#,
            r#"velocity="inf""#,
            Warning,
            DiagnosticKind::LimitMissing,
        ),
        (
            r#"velocity="1""#,
            r#"velocity="0""#,
            Warning,
            DiagnosticKind::Limit,
        ),
        (
            r#"effort="1""#,
            r#"effort="-3""#,
            Warning,
            DiagnosticKind::Limit,
        ),
        (
            r#"acceleration="1""#,
            "",
            Note,
            DiagnosticKind::LimitMissing,
        ),
        (
            r#"lower="-1""#,
            r#"lower="2""#,
            Warning,
            DiagnosticKind::Limit,
        ),
        (
            r#"lower="-1""#,
            r#"lower="1""#,
            Warning,
            DiagnosticKind::Limit,
        ),
        (r#"lower="-1""#, "", Warning, DiagnosticKind::Limit),
        (
            r#"lower="-1" upper="1""#,
            "",
            Warning,
            DiagnosticKind::Limit,
        ),
        (
            r#"type="revolute""#,
            r#"type="floating""#,
            Warning,
            DiagnosticKind::JointType,
        ),
        (
            r#"type="revolute""#,
            r#"type="hinge""#,
            Error,
            DiagnosticKind::JointType,
        ),
        (
            r#"parent link="a""#,
            r#"parent link="c""#,
            Error,
            DiagnosticKind::UnknownName,
        ),
        (
            r#"parent link="a""#,
            r#"parent link="b""#,
            Error,
            DiagnosticKind::Cycle,
        ),
        (
            r#"link name="a""#,
            r#"link name="b""#,
            Error,
            DiagnosticKind::DuplicateName,
        ),
        (
            "</robot>",
            r#"<link name="c"/></robot>"#,
            Error,
            DiagnosticKind::UnreferencedLink,
        ),
        (
            "</joint>",
            r#"<mimic joint="k"/></joint>"#,
            Warning,
            DiagnosticKind::UnknownName,
        ),
        (
            "</joint>",
            r#"<mimic joint="j"/></joint>"#,
            Error,
            DiagnosticKind::Mimic,
        ),
        (
            "</robot>",
            r#"<wisch><mimic joint="j"/></wisch></robot>"#,
            Error,
            DiagnosticKind::Mimic,
        ),
        (r#"ixx="1""#, r#"ixx="3""#, Warning, DiagnosticKind::Inertia),
        (r#"ixx="1""#, r#"ixx="0""#, Warning, DiagnosticKind::Inertia),
        (
            r#"mass value="1""#,
            r#"mass value="-1""#,
            Warning,
            DiagnosticKind::Inertia,
        ),
        (
            r#"mass value="1""#,
            r#"mass value="0""#,
            Warning,
            DiagnosticKind::InertiaMissing,
        ),
        (
            r#"<sphere radius="0.1"/>"#,
            r#"<mesh filename="a.stl"/>"#,
            Warning,
            DiagnosticKind::Mesh,
        ),
        (
            r#"<sphere radius="0.1"/>"#,
            r#"<mesh filename="package://p/a.stl"/>"#,
            Warning,
            DiagnosticKind::Mesh,
        ),
        (
            r#"<collision><geometry><sphere radius="0.1"/></geometry></collision>"#,
            "",
            Warning,
            DiagnosticKind::CollisionMissing,
        ),
    ];
    let sound = two_links(HINGE);
    for (from, to, severity, fault) in cases {
        let text = sound.replacen(from, to, 1);
        assert_ne!(text, sound, "{from}");
        let found = faults(&text);
        assert!(found.contains(&(*severity, *fault)), "{to}: {found:?}");
        let read = RobotModel::from_urdf("test.urdf", &text, &mut no_meshes);
        let refused = found.iter().any(|(severity, _)| *severity == Error);
        assert_eq!(read.is_err(), refused, "{to}");
    }
}

#[test]
fn two_trees_a_second_parent_and_a_deep_tree_are_found() {
    let joint = |name: &str, parent: &str, child: &str| {
        format!(
            r#"<joint name="{name}" type="fixed"><parent link="{parent}"/><child link="{child}"/></joint>"#
        )
    };
    let inside = |more: String| two_links(HINGE).replace("</robot>", &(more + "</robot>"));
    let two = inside(r#"<link name="c"/><link name="d"/>"#.to_owned() + &joint("k", "c", "d"));
    assert!(faults(&two).contains(&(Severity::Error, DiagnosticKind::SeveralRoots)));
    let loops =
        inside(r#"<link name="c"/>"#.to_owned() + &joint("k", "a", "c") + &joint("l", "b", "c"));
    assert!(faults(&loops).contains(&(Severity::Error, DiagnosticKind::SeveralParents)));
    let chain = |n: usize| {
        let links: String = (0..=n).map(|i| format!(r#"<link name="l{i}"/>"#)).collect();
        let joints: String = (0..n)
            .map(|i| joint(&format!("j{i}"), &format!("l{i}"), &format!("l{}", i + 1)))
            .collect();
        format!(r#"<robot name="r">{links}{joints}</robot>"#)
    };
    assert!(!faults(&chain(MAX_DEPTH)).contains(&(Severity::Error, DiagnosticKind::Depth)));
    assert!(faults(&chain(MAX_DEPTH + 1)).contains(&(Severity::Error, DiagnosticKind::Depth)));
    let error = RobotModel::from_urdf("test.urdf", &chain(MAX_LINKS), &mut no_meshes).unwrap_err();
    assert_eq!(
        error.to_string(),
        format!(
            "test.urdf: links: {} exceeds the limit of {MAX_LINKS}",
            MAX_LINKS + 1
        )
    );
}

#[test]
fn a_mesh_in_millimetres_is_noticed() {
    let mesh = crate::geometry::Mesh::cuboid(Vector3::new(300.0, 100.0, 50.0)).unwrap();
    let bytes = mesh.to_binary_stl();
    let text = two_links(HINGE).replace(r#"<sphere radius="0.1"/>"#, r#"<mesh filename="b.stl"/>"#);
    let diagnostics = check("test.urdf", &text, &mut |_| Ok(bytes.clone())).unwrap();
    assert_eq!(diagnostics.len(), 1);
    assert_eq!(diagnostics[0].kind, DiagnosticKind::MeshScale);
    assert_eq!(diagnostics[0].value, "mesh \"b.stl\" is 300 m long");
    let scaled = text.replace("b.stl\"", "b.stl\" scale=\"0.001 0.001 -0.001\"");
    let robot = RobotModel::from_urdf("test.urdf", &scaled, &mut |_| Ok(bytes.clone())).unwrap();
    assert_eq!(robot.diagnostics(), []);
    let Shape::Mesh(mesh) = &robot.links()[1].collision[0].shape else {
        panic!("not a mesh");
    };
    assert!((mesh.extent() - 0.3).abs() < 1e-7);
}

#[test]
fn names_and_numbers_that_do_not_fit_are_named() {
    let robot = robot(HUMANOID);
    let message = robot.link("rigth_tcp").unwrap_err().to_string();
    assert!(
        message.contains("unknown link \"rigth_tcp\"; nearest: right_tcp"),
        "{message}"
    );
    let message = robot.forward_kinematics(&[0.0; 3]).unwrap_err().to_string();
    assert_eq!(
        message,
        "positions has 3 values, the robot has 22 variables"
    );
    let mut q = [0.0; 22];
    q[1] = f64::NAN;
    let message = robot.forward_kinematics(&q).unwrap_err().to_string();
    assert_eq!(message, "joint \"base_y\": positions NaN is not finite");
    let (left, right) = (
        robot.link("left_tcp").unwrap(),
        robot.link("right_tcp").unwrap(),
    );
    let message = robot.chain(left, right).unwrap_err().to_string();
    assert!(
        message.starts_with("link \"right_tcp\" is no descendant of link \"left_tcp\""),
        "{message}"
    );
    let text = two_links(HINGE).replace("lower=\"-1\"", "lower=\"-1 rad\"");
    let message = RobotModel::from_urdf("test.urdf", &text, &mut no_meshes)
        .unwrap_err()
        .to_string();
    assert_eq!(
        message,
        "test.urdf:4:24: <limit lower=\"-1 rad\">: expected a number within 1e9"
    );
}

#[test]
fn a_chain_that_does_not_fit_is_refused() {
    let slides = |n: usize| {
        let links: String = (0..=n).map(|i| format!(r#"<link name="l{i}"/>"#)).collect();
        let joints: String = (0..n)
            .map(|i| {
                format!(
                    r#"<joint name="j{i}" type="continuous"><parent link="l{i}"/><child link="l{}"/></joint>"#,
                    i + 1
                )
            })
            .collect();
        robot(&format!(r#"<robot name="r">{links}{joints}</robot>"#))
    };
    let chain_of = |n: usize| {
        let robot = slides(n);
        robot
            .chain(robot.root(), LinkId(n))
            .map(|chain| chain.dof())
    };
    assert_eq!(chain_of(MAX_CHAIN), Ok(MAX_CHAIN));
    let message = chain_of(MAX_CHAIN + 1).unwrap_err().to_string();
    assert_eq!(
        message,
        format!(
            "chain \"l0\" to \"l{0}\": {0} moving joints exceed the limit of {MAX_CHAIN}",
            MAX_CHAIN + 1
        )
    );
}

#[test]
fn dynamics_are_refused_where_a_joint_moves_nothing() {
    let text = two_links(HINGE).replace("mass value=\"1\"", "mass value=\"0\"");
    let message = robot(&text).dynamics().unwrap_err().to_string();
    assert!(
        message.starts_with("joint \"j\" moves an inertia of 0e0"),
        "{message}"
    );
}

#[test]
fn mimics_of_mimics_become_sums_of_variables() {
    let joint = |name: &str, child: &str, mimic: &str| {
        format!(
            r#"<joint name="{name}" type="prismatic"><parent link="a"/><child link="{child}"/>{mimic}</joint>"#
        )
    };
    let text = format!(
        r#"<robot name="r"><link name="a"/><link name="b"/><link name="c"/><link name="d"/>{}{}{}</robot>"#,
        joint(
            "last",
            "b",
            r#"<mimic joint="middle" multiplier="3" offset="1"/>"#
        ),
        joint(
            "middle",
            "c",
            r#"<mimic joint="first" multiplier="-2" offset="5"/>"#
        ),
        joint("first", "d", ""),
    );
    let robot = robot(&text);
    assert_eq!(robot.dof(), 1);
    let last = &robot.joints()[robot.joint("last").unwrap().index()];
    assert_eq!(
        last.drive,
        Drive {
            offset: 16.0,
            terms: vec![(0, -6.0)]
        }
    );
}

fn positions(n: usize) -> impl Strategy<Value = Vec<f64>> {
    proptest::collection::vec(-2.0..2.0, n)
}

/// The rotation vector of a small rotation [rad].
fn small_turn(rotation: UnitQuaternion<f64>) -> Vector3 {
    2.0 * rotation.imag() * rotation.w.signum()
}

#[test]
fn a_fixed_joint_may_keep_its_mimic() {
    let text = r#"<robot name="r"><link name="a"/><link name="b"/>
<joint name="j" type="fixed"><parent link="a"/><child link="b"/><mimic joint="gone"/></joint></robot>"#;
    let robot = RobotModel::from_urdf("r.urdf", text, &mut no_meshes).unwrap();
    assert_eq!(robot.dof(), 0);
    let note = (robot.diagnostics().iter()).find(|found| found.kind == DiagnosticKind::Mimic);
    assert_eq!(note.expect("it is reported").severity, Severity::Note);
}

proptest! {
    #[test]
    fn the_jacobian_is_the_derivative_of_the_pose(q in positions(22), point in [-0.5..0.5, -0.5..0.5, -0.5..0.5]) {
        let robot = robot(HUMANOID);
        let point_in_link = Point3::from(point);
        // Central differences: truncation of h² and rounding of 1e-16 / h.
        let h = 1e-5;
        for link in ["right_tcp", "left_tcp", "torso_4_link", "head_2_link"] {
            let link = robot.link(link).unwrap();
            let jacobian = robot.forward_kinematics(&q).unwrap().jacobian(link, point_in_link);
            for i in 0..robot.dof() {
                let at = |step: f64| -> Pose {
                    let mut q = q.clone();
                    q[i] += step;
                    robot.forward_kinematics(&q).unwrap().world_from_link(link)
                };
                let (after, before) = (at(h), at(-h));
                let linear = (after * point_in_link - before * point_in_link) / (2.0 * h);
                let angular = small_turn(after.rotation * before.rotation.inverse()) / (2.0 * h);
                let column = jacobian.column(i);
                prop_assert!((column.fixed_rows::<3>(0) - linear).amax() < 1e-8);
                prop_assert!((column.fixed_rows::<3>(3) - angular).amax() < 1e-8);
            }
        }
    }

    #[test]
    fn a_chain_is_the_model_from_link_to_link(q in positions(22), point in [-0.5..0.5, -0.5..0.5, -0.5..0.5]) {
        let robot = robot(HUMANOID);
        let point_in_tip = Point3::from(point);
        let all = robot.forward_kinematics(&q).unwrap();
        for (base, tip) in [("world", "right_tcp"), ("platform", "left_tcp"), ("torso_2_link", "head_2_link"), ("neck", "neck")] {
            let (base, tip) = (robot.link(base).unwrap(), robot.link(tip).unwrap());
            let chain = robot.chain(base, tip).unwrap();
            let own: Vec<f64> = chain.variables().iter().map(|&i| q[i]).collect();
            let kinematics = chain.forward_kinematics(&own).unwrap();
            let world_from_base = all.world_from_link(base);
            let base_from_tip = world_from_base.inv_mul(&all.world_from_link(tip));
            let apart = kinematics.base_from_tip().to_homogeneous() - base_from_tip.to_homogeneous();
            prop_assert!(apart.amax() < 1e-12);
            if base == robot.root() {
                let whole = all.jacobian(tip, point_in_tip);
                let jacobian = kinematics.jacobian(point_in_tip);
                for (column, &i) in jacobian.view().column_iter().zip(chain.variables()) {
                    prop_assert!((column - whole.column(i)).amax() < 1e-12);
                }
            }
        }
    }

    #[test]
    fn forces_are_mass_times_acceleration_plus_bias(q in positions(22), qd in positions(22), qdd in positions(22)) {
        let robot = robot(HUMANOID);
        let dynamics = robot.dynamics().unwrap();
        let mass = dynamics.mass_matrix(&q).unwrap();
        prop_assert!((&mass - mass.transpose()).amax() == 0.0);
        prop_assert!(mass.clone().cholesky().is_some(), "not positive definite");
        let bias = dynamics.bias(&q, &qd, GRAVITY).unwrap();
        let expected = &mass * DVector::from_vec(qdd.clone()) + bias;
        let effort = dynamics.inverse_dynamics(&q, &qd, &qdd, GRAVITY).unwrap();
        prop_assert!((effort - &expected).amax() < 1e-12 * expected.amax().max(mass.amax()));
    }

    #[test]
    fn weight_is_the_slope_of_the_potential_energy(q in positions(6)) {
        let robot = robot(ARM6);
        let energy = |q: &[f64]| -> f64 {
            let kinematics = robot.forward_kinematics(q).unwrap();
            let links = robot.links().iter().enumerate();
            links
                .filter_map(|(i, link)| Some((i, link.body?)))
                .map(|(i, body)| {
                    let center = kinematics.world_from_link(LinkId(i)) * body.center_in_link;
                    -body.mass * GRAVITY.dot(&center.coords)
                })
                .sum()
        };
        let gravity = robot.dynamics().unwrap().gravity(&q, GRAVITY).unwrap();
        let h = 1e-5;
        for i in 0..6 {
            let at = |step: f64| {
                let mut q = q.clone();
                q[i] += step;
                energy(&q)
            };
            // The energies of some 100 J are rounded.
            prop_assert!((gravity[i] - (at(h) - at(-h)) / (2.0 * h)).abs() < 1e-7);
        }
    }

    #[test]
    fn no_text_breaks_the_reader(text in ".{0,200}") {
        let _ = RobotModel::from_urdf("test.urdf", &text, &mut no_meshes);
    }

    #[test]
    fn no_change_of_a_urdf_breaks_the_reader(
        cuts in proptest::collection::vec((any::<Index>(), any::<Index>(), 0..6usize), 1..4)
    ) {
        let mut text = HUMANOID.to_owned();
        for (at, length, how) in cuts {
            let (start, length) = (at.index(text.len()), length.index(400));
            let start = text.floor_char_boundary(start);
            let end = text.floor_char_boundary((start + length).min(text.len()));
            let with = ["", "torso_1", "-1e9", "\"", "<link name=\"torso_1_link\"/>", "0"][how];
            let end = if how % 2 == 0 { end } else { start };
            text.replace_range(start..end, with);
        }
        let _ = use_all(&text);
        // Visual geometry is written as collision geometry is.
        let _ = use_all(&text.replace("collision", "visual"));
    }

    #[test]
    fn no_exchange_of_words_breaks_the_reader(swaps in proptest::collection::vec((any::<Index>(), any::<Index>()), 1..6)) {
        let mut words: Vec<&str> = HUMANOID.split('"').collect();
        for (a, b) in swaps {
            // Every second piece is the value of an attribute.
            let (a, b) = (a.index(words.len() / 2), b.index(words.len() / 2));
            words.swap(2 * a + 1, 2 * b + 1);
        }
        let _ = use_all(&words.join("\""));
    }
}

/// Reads a robot and computes everything that it has.
fn use_all(text: &str) -> Result<(), RobotError> {
    let robot = RobotModel::from_urdf("test.urdf", text, &mut no_meshes)?;
    Appearance::from_urdf("test.urdf", text, &robot, &mut no_meshes)?;
    let q = vec![0.5; robot.dof()];
    robot.limit_faults(&q)?;
    let kinematics = robot.forward_kinematics(&q)?;
    for i in 0..robot.links().len() {
        kinematics.jacobian(LinkId(i), Point3::origin());
        let chain = robot.chain(robot.root(), LinkId(i))?;
        chain.forward_kinematics(&q[..chain.dof()])?;
    }
    robot.dynamics()?.bias(&q, &q, GRAVITY)?;
    Ok(())
}

#[test]
fn deep_nesting_and_long_texts_are_survived() {
    let deep = format!("<robot name=\"r\">{}", "<a>".repeat(100_000));
    assert!(check("deep.urdf", &deep, &mut no_meshes).is_err());
    let closed = format!(
        "<robot name=\"r\">{}{}</robot>",
        "<a>".repeat(100_000),
        "</a>".repeat(100_000)
    );
    assert!(check("deep.urdf", &closed, &mut no_meshes).is_err());
    // The parser's time grows with the square of these: 15 s for 60,000.
    let wide: String = (0..60_000).map(|i| format!(" a{i}='1'")).collect();
    assert!(matches!(
        check("wide.urdf", &format!("<robot{wide}/>"), &mut no_meshes),
        Err(RobotError::TooLarge { .. })
    ));
    let long = " ".repeat(MAX_URDF_BYTES + 1);
    assert!(matches!(
        check("long.urdf", &long, &mut no_meshes),
        Err(RobotError::TooLarge { .. })
    ));
}

/// As placeholders of published URDFs have them.
#[test]
fn zeros_for_what_is_unknown_are_no_errors() {
    let shape = |geometry: &str| {
        let collision = format!("<collision><geometry>{geometry}</geometry></collision>");
        two_links(HINGE).replacen("<collision>", &format!("{collision}<collision>"), 1)
    };
    for (geometry, shapes) in [
        (r#"<sphere radius="0"/>"#, 1),
        (r#"<box size="0 0 0"/>"#, 1),
        (r#"<box size="0.1 0.1 0"/>"#, 2),
        (r#"<cylinder radius="0.1" length="0"/>"#, 2),
    ] {
        let model = robot(&shape(geometry));
        assert_eq!(model.links()[1].collision.len(), shapes, "{geometry}");
    }
    let negative = RobotModel::from_urdf("n", &shape(r#"<sphere radius="-1"/>"#), &mut no_meshes);
    assert!(
        negative
            .unwrap_err()
            .to_string()
            .contains("a length of at least 0 m")
    );
    let still =
        two_links(HINGE).replace(r#"velocity="1" effort="1""#, r#"velocity="0" effort="0""#);
    let limits = robot(&still).variable(0).limits;
    assert_eq!((limits.velocity, limits.effort), (None, None));
    let found = found(&still);
    let assumed = found
        .iter()
        .find(|found| found.value.contains("velocity limit is 0"));
    assert!(
        assumed.unwrap().advice.contains("1 rad/s is assumed"),
        "{found:?}"
    );
}

#[test]
fn counterbalanced_joints_are_named_and_lose_their_effort_limits() {
    let mut model = robot(ARM6);
    let names: Vec<String> = model
        .joints()
        .iter()
        .map(|joint| joint.name.clone())
        .collect();
    let text = format!(
        r#"<robot name="arm6"><counterbalance joint="{}"/></robot>"#,
        names[1]
    );
    let srdf = Srdf::parse("a.srdf", &text, &model).unwrap();
    let written = srdf.to_xml(&model, &SrdfComments::default());
    assert_eq!(
        Srdf::parse("a.srdf", &written, &model)
            .unwrap()
            .counterbalanced,
        srdf.counterbalanced
    );
    assert!(model.joints()[1].limits.effort.is_some());
    model.remove_effort_limits(&srdf.counterbalanced);
    let limits: Vec<bool> = model
        .joints()
        .iter()
        .map(|joint| joint.limits.effort.is_some())
        .collect();
    assert!(limits[0] && !limits[1] && limits[2]);
    let unknown = Srdf::parse("a.srdf", &text.replace(&names[1], "joint"), &model).unwrap_err();
    assert!(unknown.to_string().starts_with("a.srdf:1:"), "{unknown}");
}

/// As MoveIt has it: the base that drives is declared in the SRDF, and the URDF begins at the robot.
#[test]
fn a_planar_virtual_joint_is_a_base_that_drives() {
    let urdf = r#"<robot name="r"><link name="arm"/><link name="base_link"/>
        <joint name="lift" type="prismatic"><parent link="base_link"/><child link="arm"/><axis xyz="0 0 1"/>
            <limit lower="0" upper="1" velocity="1" effort="1"/></joint>
        </robot> <!-- the </robot> ends above -->"#;
    let srdf = |kind: &str, child: &str, frame: &str| {
        format!(
            r#"<robot name="r"><virtual_joint name="world" type="{kind}" parent_frame="{frame}" child_link="{child}"/></robot>"#
        )
    };
    let read = |srdf: &str| {
        let whole = urdf_on_base(urdf, srdf);
        assert_eq!(whole.lines().count(), urdf.lines().count());
        let model = robot(&whole);
        let found = Srdf::check("r.srdf", srdf, &model);
        let names: Vec<String> = (0..model.dof())
            .map(|i| model.variable(i).name.clone())
            .collect();
        (
            names,
            found.iter().map(|found| found.severity).collect::<Vec<_>>(),
        )
    };
    let (names, found) = read(&srdf("planar", "base_link", "odom"));
    assert_eq!(names, ["world/x", "world/y", "world/theta", "lift"]);
    assert_eq!(found, []);
    let fixed = |srdf: &str, expected: &[Severity]| {
        let (names, found) = read(srdf);
        assert_eq!(
            (names.as_slice(), found.as_slice()),
            (&["lift".to_owned()][..], expected),
            "{srdf}"
        );
    };
    fixed(&srdf("fixed", "base_link", "odom"), &[]);
    fixed(&srdf("floating", "base_link", "odom"), &[Severity::Note]);
    fixed(&srdf("planar", "arm", "odom"), &[Severity::Warning]);
    fixed(&srdf("planar", "base_link", "arm"), &[Severity::Warning]);
    // The SRDF that is written declares the same base.
    let text = srdf("planar", "base_link", "a &lt; b");
    let model = robot(&urdf_on_base(urdf, &text));
    assert_eq!(model.links()[0].name, "a < b");
    let parsed = Srdf::parse("r.srdf", &text, &model).unwrap();
    let again = parsed.to_xml(&model, &SrdfComments::default());
    let again = Srdf::parse("r.srdf", &again, &model).unwrap();
    assert_eq!(again.virtual_joints, parsed.virtual_joints);
}

#[test]
fn a_planar_joint_is_two_slides_and_a_turn_in_its_plane() {
    let text = |axis: &str| {
        format!(
            r#"<robot name="cart"><link name="floor"/><link name="cart"/>
            <joint name="drive" type="planar"><parent link="floor"/><child link="cart"/>
            <origin xyz="0 0 0.1"/><axis xyz="{axis}"/><limit velocity="0.5" effort="100"/></joint></robot>"#
        )
    };
    let mut no_meshes = |_: &str| Err(String::new());
    let model = RobotModel::from_urdf("cart.urdf", &text("0 0 1"), &mut no_meshes).unwrap();
    let names: Vec<&str> = (0..model.dof())
        .map(|i| model.variable(i).name.as_str())
        .collect();
    assert_eq!(names, ["drive/x", "drive/y", "drive/theta"]);
    assert_eq!(model.variable(0).limits.velocity, Some(0.5));
    assert_eq!(model.variable(2).limits.position, None);
    let cart = model.link("cart").unwrap();
    let at = |model: &RobotModel, q: [f64; 3]| {
        let kinematics = model.forward_kinematics(&q).unwrap();
        kinematics.world_from_link(cart)
    };
    let there = at(&model, [1.0, 2.0, 0.5]);
    let expected = Pose::new(Vector3::new(1.0, 2.0, 0.1), Vector3::z() * 0.5);
    assert!((there.to_homogeneous() - expected.to_homogeneous()).norm() < 1e-15);

    // On a wall the cart stays in the plane whose normal is the axis, and turns about it.
    let wall = RobotModel::from_urdf("cart.urdf", &text("1 0 0"), &mut no_meshes).unwrap();
    let there = at(&wall, [0.3, -0.7, 0.4]);
    assert!(there.translation.vector.x.abs() < 1e-15);
    let way = there.translation.vector - Vector3::z() * 0.1;
    assert!((way.norm() - 0.3_f64.hypot(0.7)).abs() < 1e-15);
    assert!((there.rotation.scaled_axis() - Vector3::x() * 0.4).norm() < 1e-12);

    let diagnostics = check("cart.urdf", &text("0 0 0"), &mut no_meshes).unwrap();
    assert!(
        diagnostics
            .iter()
            .any(|diagnostic| diagnostic.kind == DiagnosticKind::Axis)
    );
}
