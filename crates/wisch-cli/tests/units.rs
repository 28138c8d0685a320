//! Tools, objects and robots in other units, and values that are assumed: always reported.

use crate::program::{folder_with, wisch};
use std::fs;
use std::path::Path;
use wisch::geometry::{Mesh, Pose, Vector3};

/// An arm of six joints: lengths over a metre, masses over a kilogram, the attributes of its limits, and more in its last link.
struct Arm {
    length: f64,
    mass: f64,
    rates: &'static str,
    tip: &'static str,
}

const ARM: Arm = Arm {
    length: 1.0,
    mass: 1.0,
    rates: "velocity=\"2\" acceleration=\"10\" effort=\"100\"",
    tip: "",
};

impl Arm {
    fn urdf(&self) -> String {
        let Self {
            length,
            mass,
            rates,
            tip,
        } = self;
        let inertia = 0.01 * mass;
        let mut text = "<robot name=\"arm\"><link name=\"l0\"/>".to_owned();
        for i in 1..=6 {
            let more = if i == 6 { tip } else { &"" };
            let axis = if i % 2 == 1 { "0 0 1" } else { "0 1 0" };
            text += &format!(
                "<link name=\"l{i}\"><inertial><mass value=\"{}\"/><inertia ixx=\"{inertia}\" iyy=\"{inertia}\" izz=\"{inertia}\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>\
                 <collision><geometry><sphere radius=\"{}\"/></geometry></collision>{more}</link>\
                 <joint name=\"a{i}\" type=\"revolute\"><parent link=\"l{}\"/><child link=\"l{i}\"/><origin xyz=\"0 0 {}\"/><axis xyz=\"{axis}\"/>\
                 <limit lower=\"-2.5\" upper=\"2.5\" {rates}/></joint>",
                3.0 * mass,
                0.04 * length,
                i - 1,
                0.15 * length
            );
        }
        text + "</robot>"
    }
}

const READY: &str = "<robot name=\"arm\"><group name=\"arm\"><chain base_link=\"l0\" tip_link=\"l6\"/></group>\
    <group_state name=\"ready\" group=\"arm\"><joint name=\"a1\" value=\"0\"/>\
    <joint name=\"a2\" value=\"0.5\"/><joint name=\"a3\" value=\"0\"/><joint name=\"a4\" value=\"0\"/>\
    <joint name=\"a5\" value=\"0\"/><joint name=\"a6\" value=\"0\"/></group_state></robot>";

/// What `wisch check` says of the shipped board with this robot, and what `wisch robot check` does.
fn told(arm: &Arm, srdf: &str) -> (String, String) {
    let folder = folder_with("arm-board.toml");
    for (name, length) in [("nut.stl", 150.0), ("pin.stl", 3.937)] {
        let mesh = Mesh::cuboid(Vector3::new(length, 1.0, 1.0)).unwrap();
        fs::write(folder.path().join(name), mesh.to_binary_stl()).unwrap();
    }
    fs::write(folder.path().join("arm.urdf"), arm.urdf()).unwrap();
    fs::write(folder.path().join("arm.srdf"), srdf).unwrap();
    let (_, _, check) = wisch(
        folder.path(),
        &["check", "task.toml", "--robot", "arm.urdf"],
    );
    let (_, report, error) = wisch(folder.path(), &["robot", "check", "arm.urdf"]);
    (check, report + &error)
}

#[test]
fn an_arm_in_metres_kilograms_and_radians_raises_no_remark() {
    let (check, report) = told(&ARM, READY);
    assert!(!check.contains("note:"), "{check}");
    assert!(report.contains("no findings"), "{report}");
}

#[test]
fn both_checks_report_odd_and_assumed_values_of_a_robot() {
    let nut = "<collision><geometry><mesh filename=\"nut.stl\"/></geometry></collision>";
    let pin = "<collision><geometry><mesh filename=\"pin.stl\"/></geometry></collision>";
    let partial = READY.replace("<joint name=\"a3\" value=\"0\"/>", "");
    let missing = "<collision><geometry><mesh filename=\"bolt.stl\"/></geometry></collision>";
    let no_ready = READY.replace("\"ready\"", "\"home\"");
    let stale = READY.replace(
        "</robot>",
        "<disable_collisions link1=\"l6\" link2=\"gripper_base\"/></robot>",
    );
    let cases = [
        (
            Arm {
                length: 1000.0,
                ..ARM
            },
            READY,
            "probably in millimetres: multiply by 0.001",
        ),
        (
            Arm { length: 1e6, ..ARM },
            READY,
            "probably in micrometres: multiply by 0.000001",
        ),
        (
            Arm {
                mass: 1000.0,
                ..ARM
            },
            READY,
            "probably in grams: multiply masses and inertias by 0.001",
        ),
        (
            Arm {
                tip: missing,
                ..ARM
            },
            READY,
            "not checked for collisions",
        ),
        (
            Arm { tip: nut, ..ARM },
            READY,
            "in millimetres: use scale=\"0.001 0.001 0.001\"",
        ),
        (
            Arm { tip: pin, ..ARM },
            READY,
            "in centimetres or inches: use scale=\"0.01 0.01 0.01\" or scale=\"0.0254 0.0254 0.0254\"",
        ),
        (
            ARM,
            &*partial,
            "motions begin with a3 = 0 rad (middle of the limits)",
        ),
        (
            Arm {
                rates: "velocity=\"2\" effort=\"100\"",
                ..ARM
            },
            READY,
            "10 rad/s2 is assumed",
        ),
        (
            Arm {
                rates: "effort=\"100\"",
                ..ARM
            },
            READY,
            "1 rad/s is assumed",
        ),
        (ARM, &*no_ready, "\"ready\""),
        (ARM, &*stale, "unknown link \"gripper_base\""),
    ];
    for (arm, srdf, expected) in cases {
        let (check, report) = told(&arm, srdf);
        assert!(check.contains(expected), "{expected}: check: {check}");
        assert!(
            report.contains(expected),
            "{expected}: robot check: {report}"
        );
    }
}

#[test]
fn the_start_of_a_robot_without_srdf_is_stated() {
    let folder = folder_with("arm-board.toml");
    fs::write(folder.path().join("arm.urdf"), ARM.urdf()).unwrap();
    let begins = "motions begin with a1 = 0 rad, a2 = 0 rad, a3 = 0 rad, a4 = 0 rad, a5 = 0 rad, a6 = 0 rad (middle of the limits)";
    let args = ["check", "task.toml", "--robot", "arm.urdf"];
    let (_, _, notes) = wisch(folder.path(), &args);
    assert!(notes.contains(begins), "{notes}");
    let (_, report, _) = wisch(folder.path(), &["robot", "check", "arm.urdf"]);
    assert!(report.contains(begins), "{report}");
}

#[test]
fn a_rail_in_millimetres_is_reported() {
    let folder = folder_with("arm-board.toml");
    let rail = |lower: &str, upper: &str, velocity: &str, acceleration: &str| {
        let arm = ARM.urdf().replacen("revolute", "prismatic", 1);
        let limit = "lower=\"-2.5\" upper=\"2.5\" velocity=\"2\" acceleration=\"10\"";
        let other = format!(
            "lower=\"{lower}\" upper=\"{upper}\" velocity=\"{velocity}\" acceleration=\"{acceleration}\""
        );
        fs::write(
            folder.path().join("arm.urdf"),
            arm.replacen(limit, &other, 1),
        )
        .unwrap();
        fs::write(folder.path().join("arm.srdf"), READY).unwrap();
        let (_, report, _) = wisch(folder.path(), &["robot", "check", "arm.urdf"]);
        let args = ["check", "task.toml", "--robot", "arm.urdf"];
        (report, wisch(folder.path(), &args).2)
    };
    let (report, notes) = rail("-1.2", "1.2", "0.5", "2");
    assert!(!report.contains("millimetres"), "{report}");
    assert!(!notes.contains("millimetres"), "{notes}");
    for (rail, expected) in [
        (
            rail("-1200", "1200", "0.5", "2"),
            "joint \"a1\": it slides from -1200 to 1200 m, expected within 20 m; it is probably in millimetres: multiply by 0.001",
        ),
        (
            rail("0", "1", "500", "2"),
            "joint \"a1\": its velocity limit is 500 m/s, expected at most 10 m/s; it is probably in millimetres per second: multiply by 0.001",
        ),
        (
            rail("0", "1", "1", "2000"),
            "joint \"a1\": its acceleration limit is 2000 m/s2, expected at most 100 m/s2; it is probably in millimetres per second squared",
        ),
    ] {
        for text in [rail.0, rail.1] {
            assert!(text.contains(expected), "{text}");
        }
    }
}

#[test]
fn degrees_and_square_millimetres_are_reported() {
    let text = ARM.urdf();
    for (from, to, expected) in [
        (
            "lower=\"-2.5\" upper=\"2.5\"",
            "lower=\"-170\" upper=\"170\"",
            "probably in degrees",
        ),
        (
            "ixx=\"0.01\" iyy=\"0.01\" izz=\"0.01\"",
            "ixx=\"1e4\" iyy=\"1e4\" izz=\"1e4\"",
            "kg mm2",
        ),
    ] {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("arm.urdf"), text.replace(from, to)).unwrap();
        let (code, report, _) = wisch(folder.path(), &["robot", "check", "arm.urdf"]);
        assert_eq!(code, 1, "{report}");
        assert!(report.contains(expected), "{report}");
    }
}

#[test]
fn soft_limits_are_kept_and_reported() {
    let text = ARM.urdf().replacen(
        "effort=\"100\"/></joint>",
        "effort=\"100\"/><safety_controller soft_lower_limit=\"-1\" soft_upper_limit=\"4\" k_velocity=\"1\"/></joint>",
        1,
    );
    let robot =
        wisch::robot::RobotModel::from_urdf(
            "arm.urdf",
            &text,
            &mut |_| Err("no meshes".to_owned()),
        );
    let robot = robot.unwrap();
    let limits = robot.variable(0).limits.position.unwrap();
    assert_eq!([limits.lower, limits.upper], [-1.0, 2.5]);
    let told = robot.diagnostics()[0].to_string();
    assert!(told.contains("keeps it within -1 and 2.5 rad"), "{told}");
}

#[test]
fn xacro_that_is_not_expanded_is_an_error_at_its_place() {
    let folder = folder_with("arm-board.toml");
    let text = "<?xml version=\"1.0\"?>\n<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\" name=\"cell\">\n  \
        <link name=\"world\"/>\n  <xacro:include filename=\"arm.xacro\"/>\n</robot>\n";
    fs::write(folder.path().join("cell.urdf"), text).unwrap();
    for args in [
        &["robot", "check", "cell.urdf"][..],
        &["check", "task.toml", "--robot", "cell.urdf"],
        &["robot", "map", "cell.urdf", "--samples", "100"],
    ] {
        let (code, _, error) = wisch(folder.path(), args);
        assert_eq!(code, 2, "{args:?}: {error}");
        assert!(
            error.contains("cell.urdf:4:3: <xacro:include> is not expanded"),
            "{error}"
        );
    }
}

#[test]
fn a_posture_of_a_finger_that_is_fixed_absent_or_of_no_group_is_a_note() {
    let fixed = "<link name=\"finger_link\"/><joint name=\"finger\" type=\"fixed\"><parent link=\"l6\"/><child link=\"finger_link\"/></joint></robot>";
    let of_group = "<group name=\"gripper\"><joint name=\"finger\"/></group><group_state name=\"open\" group=\"gripper\"><joint name=\"finger\" value=\"0\"/></group_state></robot>";
    let of_none = "<group_state name=\"folded\" group=\"\"><joint name=\"a2\" value=\"0\"/></group_state></robot>";
    for (text, state, expected) in [
        (
            ARM.urdf().replace("</robot>", fixed),
            of_group,
            "joint \"finger\" is fixed",
        ),
        (ARM.urdf(), of_group, "the robot has no joint \"finger\""),
        (ARM.urdf(), of_none, "it belongs to no group"),
    ] {
        let folder = folder_with("arm-board.toml");
        fs::write(folder.path().join("arm.urdf"), text).unwrap();
        fs::write(
            folder.path().join("arm.srdf"),
            READY.replace("</robot>", state),
        )
        .unwrap();
        let (code, report, error) = wisch(folder.path(), &["robot", "check", "arm.urdf"]);
        assert_eq!(code, 0, "{report}{error}");
        assert!(report.contains(expected), "{report}");
    }
}

/// The check of a task whose tool is a mesh of this size [m].
fn check_of_tool(folder: &Path, size: Vector3) -> (i32, String, String) {
    check_of_mesh(folder, &Mesh::cuboid(size).unwrap())
}

fn check_of_mesh(folder: &Path, mesh: &Mesh) -> (i32, String, String) {
    fs::write(folder.join("pad.stl"), mesh.to_binary_stl()).unwrap();
    let settings = ["tool.name=pad", "tool.mesh=pad.stl"];
    let args = [
        "check",
        "task.toml",
        "--robot",
        "none",
        "--set",
        settings[0],
        "--set",
        settings[1],
    ];
    wisch(folder, &args)
}

#[test]
fn tools_in_other_units_are_refused_with_the_unit_and_the_factor() {
    let folder = folder_with("arm-board.toml");
    let size = Vector3::new(0.07, 0.11, 0.05);
    let (code, out, error) = check_of_tool(folder.path(), size);
    assert_eq!(code, 0, "{out}{error}");
    for (scale, expected) in [
        (1e3, "in millimetres: multiply by 0.001"),
        (1e2, "in centimetres or inches: multiply by 0.01 or 0.0254"),
        (1e-3, "scaled twice: multiply by 1000"),
    ] {
        let (code, _, error) = check_of_tool(folder.path(), size * scale);
        assert_eq!(code, 2, "{error}");
        assert!(error.contains(expected), "{error}");
        assert!(error.contains("mesh \"pad.stl\""), "{error}");
    }
}

#[test]
fn an_object_much_larger_than_the_surface_is_reported() {
    let folder = folder_with("arm-board.toml");
    let cup = Mesh::cuboid(Vector3::new(15.0, 15.0, 8.0)).unwrap();
    fs::write(folder.path().join("cup.stl"), cup.to_binary_stl()).unwrap();
    let path = folder.path().join("task.toml");
    let text = fs::read_to_string(&path).unwrap();
    let object = "\n[[scene]]\nname = \"nut\"\nmesh = { file = \"cup.stl\" }\nposition_m = [50.0, 50.0, 0.0]\n";
    fs::write(&path, text + object).unwrap();
    let (_, _, error) = wisch(folder.path(), &["check", "task.toml", "--robot", "none"]);
    assert!(
        error.contains("note: scene object \"nut\" is 15.0 m long"),
        "{error}"
    );
    assert!(
        error.contains(
            "in millimetres or centimetres or inches: multiply by 0.001 or 0.01 or 0.0254"
        ),
        "{error}"
    );
}

#[test]
fn a_tool_that_presses_beside_its_origin_is_reported() {
    let folder = folder_with("arm-board.toml");
    let pad = Mesh::cuboid(Vector3::new(0.07, 0.11, 0.05)).unwrap();
    let (_, _, centred) = check_of_mesh(folder.path(), &pad);
    assert!(!centred.contains("tool centre point"), "{centred}");
    let moved = pad.transform(&Pose::translation(0.08, 0.0, 0.0));
    let (_, _, error) = check_of_mesh(folder.path(), &moved);
    let expected = "the middle of its contact area lies at (80, 0) mm of its origin";
    assert!(error.contains(expected), "{error}");
}

#[test]
fn a_tool_whose_underside_is_off_its_contact_plane_is_reported() {
    let folder = folder_with("arm-board.toml");
    // The lowest point lies at -25 mm, and in turn at 0, 20 and 0.9 mm.
    let pad = Mesh::cuboid(Vector3::new(0.06, 0.10, 0.05)).unwrap();
    let check = |raised: f64| {
        let mesh = pad.transform(&Pose::translation(0.0, 0.0, raised));
        check_of_mesh(folder.path(), &mesh).2
    };
    for raised in [0.025, 0.0259, 0.0241] {
        let error = check(raised);
        assert!(!error.contains("the lowest point of its mesh"), "{error}");
    }
    for (raised, expected) in [
        (
            0.045,
            "tool \"pad\": the lowest point of its mesh lies 20.0 mm above z = 0 of the file, where at most 1.0 mm are expected",
        ),
        (0.045, "the tool stays 20.0 mm above the surface"),
        (
            0.0,
            "the lowest point of its mesh lies 25.0 mm below z = 0 of the file",
        ),
        (0.0, "the tool is pressed 25.0 mm too deep"),
    ] {
        let error = check(raised);
        assert!(error.contains(expected), "{error}");
    }
}

#[test]
fn the_footprint_of_a_mesh_in_millimetres_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let footprint = |scale: f64| {
        let pad = Mesh::cuboid(Vector3::new(70.0, 110.0, 50.0) * scale).unwrap();
        fs::write(folder.path().join("pad.stl"), pad.to_binary_stl()).unwrap();
        let words = ["footprint", "pad.stl", "--compression-depth-m", "0.005"];
        wisch(folder.path(), &words)
    };
    let (code, out, error) = footprint(1.0);
    assert_eq!((code, out.as_str()), (2, ""), "{error}");
    let expected = "pad.stl: the mesh is 110 m long, expected 0.005 m to 3 m: it is probably in millimetres: multiply by 0.001";
    assert!(error.contains(expected), "{error}");
    let (_, _, error) = footprint(0.03937);
    let expected = "it is probably in centimetres or inches: multiply by 0.01 or 0.0254";
    assert!(error.contains(expected), "{error}");
    let (code, out, error) = footprint(0.001);
    assert_eq!(code, 0, "{error}");
    assert!(
        out.contains("the lowest point of the mesh lies at z = -25.0 mm"),
        "{out}"
    );
}

#[test]
fn an_axis_of_a_dae_file_that_is_not_applied_is_reported() {
    let folder = folder_with("arm-board.toml");
    let dae = |axis: &str| {
        format!(
            r##"<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="metre" meter="1"/><up_axis>{axis}</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="a" count="12">0 0 0 0.1 0 0 0 0.1 0 0 0 0.1</float_array>
<technique_common><accessor source="#a" count="4" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 1 2 3 2 0 3</p></triangles>
</mesh></geometry></library_geometries></COLLADA>"##
        )
    };
    for (axis, is_noted) in [("Y_UP", true), ("Z_UP", false)] {
        fs::write(folder.path().join("pad.dae"), dae(axis)).unwrap();
        let settings = ["tool.name=pad", "tool.mesh=pad.dae"];
        let words = ["check", "task.toml", "--robot", "none"];
        let words = [&words[..], &["--set", settings[0], "--set", settings[1]]].concat();
        let (_, _, error) = wisch(folder.path(), &words);
        let expected = "note: mesh \"pad.dae\": <up_axis> is Y_UP, which is not applied";
        assert_eq!(error.contains(expected), is_noted, "{error}");
    }
}

#[test]
fn what_is_assumed_of_a_pad_of_edges_and_of_points_is_reported() {
    let folder = folder_with("polish-plate.toml");
    let check = |settings: &[&str]| {
        let mut words = vec!["check", "task.toml", "--robot", "none"];
        words.extend(settings.iter().flat_map(|setting| ["--set", setting]));
        wisch(folder.path(), &words).2
    };
    let pad = ["tool.name=felt", "tool.footprint_m=[0.05, 0.08]"];
    let assumed = check(&pad);
    let height = "tool \"felt\" is taken to be 0.05 m high";
    assert!(assumed.contains(height), "{assumed}");
    assert!(!assumed.contains("points, which lie"), "{assumed}");
    let given = check(&[&pad[..], &["tool.height_m=0.01", "particles.count=7"]].concat());
    assert!(!given.contains(height), "{given}");
    assert!(given.contains("6 points, which lie"), "{given}");
    // 0.155 m2 over 625 points: 15.7 mm apart; a fifth of the sponge's 110 mm is 22 mm.
    let sponge = check(&["particles.count=625"]);
    assert!(!sponge.contains("points, which lie"), "{sponge}");
    // A fifth of the pad's 80 mm is 16 mm, and 0.155 m2 / 400 = (19.7 mm)2: 1.2 (19.7 / 16)2 = 1.8.
    let few = check(&[&pad[..], &["particles.count=400"]].concat());
    let expected = "along the borders may stay untreated. The tool is 0.080 m wide: multiply particles.count by at least 1.8";
    assert!(few.contains(expected), "{few}");

    let outline = "surface.outline_m=[[0,0],[0,0.3],[0.4,0.3],[0.4,0]]";
    let path = folder.path().join("task.toml");
    let text = fs::read_to_string(&path).unwrap();
    let without_size: Vec<&str> = text
        .lines()
        .filter(|line| !line.starts_with("size_m"))
        .collect();
    fs::write(&path, without_size.join("\n")).unwrap();
    let clockwise = check(&[outline]);
    let expected = "its edges 0, 1, 2, … are numbered 2, 1, 0, 3 in all results";
    assert!(clockwise.contains(expected), "{clockwise}");
}

#[test]
fn a_film_of_too_many_particles_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let words = ["check", "solar-panel", "--set", "particles.count=60000"];
    let (code, _, error) = wisch(folder.path(), &words);
    assert_eq!(code, 2, "{error}");
    let expected = "60000 particles exceed the limit of 50000 for a film that runs down";
    assert!(error.contains(expected), "{error}");
}
