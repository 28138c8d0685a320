//! Descriptions that break a rule, but that other programs read.

use wisch_robot::{Diagnostic, DiagnosticKind, RobotModel, Severity, check};

fn no_meshes(_: &str) -> Result<Vec<u8>, String> {
    Err("there are no meshes".to_owned())
}

fn robot(text: &str) -> RobotModel {
    RobotModel::from_urdf("test.urdf", text, &mut no_meshes).unwrap()
}

fn found(text: &str) -> Vec<Diagnostic> {
    check("test.urdf", text, &mut no_meshes).unwrap()
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

#[test]
fn deviations_from_the_format_are_warnings() {
    let sphere = r#"<sphere radius="0.1"/>"#;
    let sound = two_links(HINGE);
    assert_eq!(found(&sound), []);
    for (from, to, kind, expected) in [
        (
            sphere,
            r#"<mesh filename="a.stl"/>"#,
            DiagnosticKind::CollisionMissing,
            "none of the collision shapes can be used",
        ),
        (
            sphere,
            "<plane/>",
            DiagnosticKind::CollisionMissing,
            "unknown shape <plane>; known: box, cylinder, capsule, sphere, mesh",
        ),
        (
            r#"<geometry><sphere radius="0.1"/></geometry>"#,
            "",
            DiagnosticKind::CollisionMissing,
            "<collision> has no <geometry>",
        ),
        (
            r#"xyz="0 0 1""#,
            r#"xyz="0, 0, 1""#,
            DiagnosticKind::Syntax,
            "<axis xyz=\"0, 0, 1\"> has commas",
        ),
        (
            "<axis",
            "<!-- a -- b --><axis",
            DiagnosticKind::Syntax,
            "a comment contains two hyphens",
        ),
        (
            "<axis",
            "<xacro:grey/><axis",
            DiagnosticKind::Syntax,
            "<xacro:grey> is not expanded",
        ),
    ] {
        let text = sound.replacen(from, to, 1);
        let found = found(&text);
        let it = found.iter().find(|found| found.value == expected);
        let it = it.unwrap_or_else(|| panic!("{expected}: {found:?}"));
        assert_eq!((it.severity, it.kind), (Severity::Warning, kind));
        RobotModel::from_urdf("test.urdf", &text, &mut no_meshes).unwrap();
    }
}

#[test]
fn deviations_are_limited() {
    let text = |count| {
        let shapes = "<collision/>".repeat(count);
        two_links(HINGE).replacen("<collision>", &format!("{shapes}<collision>"), 1)
    };
    assert_eq!(found(&text(1000)).len(), 1000);
    let refused = check("test.urdf", &text(1001), &mut no_meshes).unwrap_err();
    let expected =
        "test.urdf: elements that deviate from the format: 1001 exceeds the limit of 1000";
    assert_eq!(refused.to_string(), expected);
}

#[test]
fn what_is_tolerated_has_one_reading() {
    // A floating joint counts as fixed, and its axis is not read.
    let floating = HINGE.replace("revolute", "floating").replace("0 0 1", "");
    assert_eq!(robot(&two_links(&floating)).dof(), 0);
    // Limits in the wrong order keep the joint between them.
    let turned = HINGE.replace("lower=\"-1\" upper=\"1\"", "lower=\"2\" upper=\"-1\"");
    let limits = robot(&two_links(&turned)).variable(0).limits.position;
    assert_eq!(limits.map(|l| [l.lower, l.upper]), Some([-1.0, 2.0]));
    // The link "world" need not be defined.
    let on_world = two_links(&format!(
        "{HINGE}<joint name=\"w\" type=\"fixed\"><parent link=\"world\"/><child link=\"a\"/></joint>"
    ));
    let on_world = robot(&on_world);
    assert_eq!(on_world.links()[on_world.root().index()].name, "world");
    // A joint that mimics a missing joint is independent.
    let alone = HINGE.replace("</joint>", "<mimic joint=\"k\"/></joint>");
    assert_eq!(robot(&two_links(&alone)).dof(), 1);
    // A link keeps the shapes that can be read.
    let two = two_links(HINGE).replace(
        "<collision>",
        "<collision><geometry><mesh filename=\"a.stl\"/></geometry></collision><collision>",
    );
    let (body, found) = (robot(&two), found(&two));
    let shapes: usize = body.links().iter().map(|l| l.collision.len()).sum();
    assert_eq!(shapes, 1);
    let advice = "until it is corrected, this shape is not checked for collisions";
    assert!(found[0].advice.ends_with(advice), "{}", found[0]);
}

#[test]
fn angles_and_velocities_in_degrees_are_warnings() {
    let sound = two_links(HINGE);
    let axis = "<axis xyz=\"0 0 1\"/>";
    for (from, to, expected) in [
        (
            axis,
            "<axis xyz=\"0 0 1\"/><origin rpy=\"90 0 -90\"/>",
            "its origin turns by rpy = 90 0 -90 rad",
        ),
        (
            "<geometry>",
            "<origin rpy=\"0 45 0\"/><geometry>",
            "its origin turns by rpy = 0 45 0 rad",
        ),
        (
            "velocity=\"1\"",
            "velocity=\"180\"",
            "its velocity limit is 180 rad/s",
        ),
    ] {
        let found = found(&sound.replacen(from, to, 1));
        assert_eq!(found.len(), 1, "{to}: {found:?}");
        let kind = (found[0].severity, found[0].kind, found[0].value.as_str());
        assert_eq!(kind, (Severity::Warning, DiagnosticKind::Units, expected));
        assert!(
            found[0].advice.contains("probably in degrees"),
            "{}",
            found[0]
        );
    }
    for (from, to) in [
        (
            axis,
            "<axis xyz=\"0 0 1\"/><origin rpy=\"6.2831853 0 -3.1416\"/>",
        ),
        ("velocity=\"1\"", "velocity=\"20\""),
    ] {
        assert_eq!(found(&sound.replacen(from, to, 1)), []);
    }
}

#[test]
fn a_position_limit_that_is_absent_beside_the_other_is_0() {
    let both = "lower=\"-1\" upper=\"1\"";
    for (stated, expected, told) in [
        ("lower=\"-1\"", Some([-1.0, 0.0]), "0 rad is assumed"),
        ("upper=\"2.8\"", Some([0.0, 2.8]), "0 rad is assumed"),
        // These leave no range with 0.
        ("lower=\"1\"", None, "without position limits"),
        ("upper=\"-1\"", None, "without position limits"),
        ("lower=\"0\"", None, "without position limits"),
        (
            "lower=\"-inf\" upper=\"1\"",
            None,
            "without position limits",
        ),
        ("", None, "without position limits"),
    ] {
        let text = two_links(&HINGE.replace(both, stated));
        let limits = robot(&text).variable(0).limits.position;
        let limits = limits.map(|limits| [limits.lower, limits.upper]);
        assert_eq!(limits, expected, "{stated}");
        let found = found(&text);
        assert_eq!(found.len(), 1, "{stated}: {found:?}");
        let kind = (found[0].severity, found[0].kind);
        assert_eq!(kind, (Severity::Warning, DiagnosticKind::Limit));
        assert!(found[0].advice.contains(told), "{stated}: {}", found[0]);
    }
    // A safety controller counts within them.
    let soft = "upper=\"1\" velocity=\"1\" effort=\"1\" acceleration=\"1\"/>\
        <safety_controller soft_lower_limit=\"-1\" soft_upper_limit=\"0.5\"/></joint>";
    let begin = HINGE.split(both).next().unwrap();
    let limits = robot(&two_links(&format!("{begin}{soft}")));
    let limits = limits.variable(0).limits.position.unwrap();
    assert_eq!([limits.lower, limits.upper], [0.0, 0.5]);
}

#[test]
fn soft_limits_on_one_side_or_reversed_count_with_a_warning() {
    let with = |soft: &str| {
        let limit =
            "<limit lower=\"-2\" upper=\"2\" velocity=\"1\" effort=\"1\" acceleration=\"1\"/>";
        let begin = HINGE.split("<limit").next().unwrap();
        two_links(&format!(
            "{begin}{limit}<safety_controller {soft}/></joint>"
        ))
    };
    for (soft, expected, told) in [
        (
            "soft_upper_limit=\"1\"",
            [0.0, 1.0],
            "without it 0 is assumed",
        ),
        (
            "soft_lower_limit=\"-1\"",
            [-1.0, 0.0],
            "without it 0 is assumed",
        ),
        (
            "soft_lower_limit=\"1\"",
            [1.0, 2.0],
            "the hard limit counts",
        ),
        (
            "soft_upper_limit=\"-1\"",
            [-2.0, -1.0],
            "the hard limit counts",
        ),
        (
            "soft_lower_limit=\"1\" soft_upper_limit=\"-1\"",
            [-1.0, 1.0],
            "they are exchanged",
        ),
        (
            "soft_lower_limit=\"3\" soft_upper_limit=\"4\"",
            [-2.0, 2.0],
            "the soft limits are ignored",
        ),
    ] {
        let text = with(soft);
        let limits = robot(&text).variable(0).limits.position.unwrap();
        assert_eq!([limits.lower, limits.upper], expected, "{soft}");
        let found = found(&text);
        let warned = (found.iter()).find(|found| found.severity == Severity::Warning);
        let warned = warned.unwrap_or_else(|| panic!("{soft}: no warning"));
        assert!(warned.advice.contains(told), "{soft}: {warned}");
    }
    // A controller without limits has none.
    for soft in [
        "k_velocity=\"10\"",
        "soft_lower_limit=\"0\" soft_upper_limit=\"0\"",
    ] {
        let text = with(soft);
        let limits = robot(&text).variable(0).limits.position.unwrap();
        assert_eq!([limits.lower, limits.upper], [-2.0, 2.0], "{soft}");
        assert_eq!(found(&text), [], "{soft}");
    }
}

#[test]
fn a_source_of_xacro_is_refused_with_the_command_that_expands_it() {
    let expand = "make it with `xacrodoc test.urdf -o robot.urdf` (pip install xacrodoc), or in ROS with `xacro test.urdf > robot.urdf`";
    for (text, place) in [
        (
            two_links("<xacro:macro name=\"m\"/>"),
            "test.urdf:3:82: <xacro:macro>",
        ),
        (
            "<robot name=\"r\"><xacro:arm/></robot>".to_owned(),
            "test.urdf:1:17: <xacro:arm>",
        ),
        (
            two_links(
                "<joint name=\"j\" type=\"fixed\"><origin xyz=\"${x} 0 0\"/><parent link=\"a\"/><child link=\"b\"/></joint>",
            ),
            "test.urdf:3:111: <origin xyz=\"${x} 0 0\">",
        ),
    ] {
        let message = check("test.urdf", &text, &mut no_meshes).unwrap_err();
        let expected = format!("{place} is not expanded; expected plain URDF: {expand}");
        assert_eq!(message.to_string(), expected);
    }
}
