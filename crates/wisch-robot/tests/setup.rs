//! Groups, pairs and ready postures that are proposed for a URDF without an SRDF.

use crate::clearance::{committed, robot};
use wisch_robot::setup::{
    ArmChain, LinkPairs, ReadyPosture, ReadyRequest, SINGULAR, SetupConfig, SetupError,
    WipingRegion, find_arms, find_ready, manipulability, middle_posture, sample_pairs,
};
use wisch_robot::{
    CollisionModel, DisabledPair, Group, GroupState, LinkAxis, LinkId, RobotModel, Srdf,
    SrdfComments,
};

/// Settings for tests: fewer postures than the default.
fn quick() -> SetupConfig {
    SetupConfig {
        pair_samples: 2000,
        posture_samples: 400,
        ..SetupConfig::default()
    }
}

fn read(urdf: &str) -> RobotModel {
    RobotModel::from_urdf("made.urdf", urdf, &mut |file| Err(file.to_owned())).unwrap()
}

/// The URDF of a shipped robot.
fn urdf(name: &str) -> String {
    committed(&format!("{name}.urdf"))
}

/// The URDF of the arm of six joints with more links and joints at its end.
fn arm6_with(more: &str) -> String {
    urdf("arm6").replace("</robot>", &format!("{more}</robot>"))
}

/// The arm of six joints on a lift, a prismatic joint along z.
fn arm6_on_lift() -> RobotModel {
    read(&arm6_with(
        r#"<link name="floor"/>
        <joint name="lift" type="prismatic"><parent link="floor"/><child link="link_0"/>
          <origin xyz="0 0 0.4"/><axis xyz="0 0 1"/>
          <limit lower="0" upper="0.5" velocity="0.2" acceleration="1" effort="1000"/></joint>"#,
    ))
}

/// A joint and the link that it moves.
fn joint(kind: &str, parent: &str, child: &str, xyz: &str, more: &str) -> String {
    format!(
        r#"<link name="{child}"><collision><geometry><sphere radius="0.01"/></geometry></collision></link>
        <joint name="{child}_joint" type="{kind}"><parent link="{parent}"/><child link="{child}"/>
          <origin xyz="{xyz}"/><axis xyz="0 1 0"/>{more}</joint>"#
    )
}

const FINGER: &str = r#"<limit lower="0" upper="0.04" velocity="0.2" effort="20"/>"#;

/// Names of all groups, with base and tip.
fn group_names<'a>(robot: &'a RobotModel, arms: &'a [ArmChain]) -> Vec<[&'a str; 3]> {
    let name = |link: LinkId| robot.links()[link.index()].name.as_str();
    let groups = arms.iter().flat_map(|arm| &arm.groups);
    groups
        .map(|proposed| {
            let Group {
                name: own,
                base,
                tip,
            } = &proposed.group;
            [own.as_str(), name(*base), name(*tip)]
        })
        .collect()
}

fn groups_of(robot: &RobotModel) -> Vec<[String; 3]> {
    let arms = find_arms(robot, &[]).unwrap();
    let names = group_names(robot, &arms).into_iter();
    names.map(|names| names.map(str::to_owned)).collect()
}

#[test]
fn the_shipped_robots_get_the_groups_of_their_srdf_files() {
    for name in ["arm6", "arm7"] {
        let robot = robot(name);
        assert_eq!(groups_of(&robot), [["arm", "link_0", "tcp"]], "{name}");
    }
    // Its base slides and turns, so that the groups begin at the platform. Its head is no arm.
    let found = groups_of(&robot("humanoid"));
    let ends: Vec<[&str; 2]> = found
        .iter()
        .map(|[name, _, tip]| [name.as_str(), tip])
        .collect();
    let expected = [
        ["right_arm_with_torso", "right_tcp"],
        ["right_arm", "right_tcp"],
        ["left_arm_with_torso", "left_tcp"],
        ["left_arm", "left_tcp"],
    ];
    assert_eq!(ends, expected);
    let begins_at_platform: Vec<bool> = found
        .iter()
        .map(|[_, base, _]| base == "platform")
        .collect();
    assert_eq!(begins_at_platform, [true, false, true, false]);
}

#[test]
fn an_arm_on_a_lift_has_a_group_with_the_lift_and_one_without() {
    let robot = arm6_on_lift();
    assert_eq!(
        groups_of(&robot),
        [["arm_with_lift", "floor", "tcp"], ["arm", "link_0", "tcp"]]
    );
    let rail = urdf("arm6").replace(
        "</robot>",
        r#"<link name="floor"/><joint name="slide" type="prismatic"><parent link="floor"/><child link="link_0"/>
        <axis xyz="0 1 0"/><limit lower="-1" upper="1" velocity="1" effort="9"/></joint></robot>"#,
    );
    assert_eq!(groups_of(&read(&rail))[0][0], "arm_with_rail");
}

#[test]
fn a_gripper_stays_out_of_the_chain() {
    let fingers = joint("prismatic", "hand", "left_part", "0 0 0.1", FINGER)
        + &joint(
            "prismatic",
            "hand",
            "right_part",
            "0 0 0.1",
            &format!("{FINGER}<mimic joint=\"left_part_joint\"/>"),
        );
    let hand = r#"<link name="hand"><collision><geometry><sphere radius="0.03"/></geometry></collision></link>
        <joint name="hand_joint" type="fixed"><parent link="tcp"/><child link="hand"/></joint>"#;
    // The flange before the hand is named; no link is; a frame between the fingers is.
    let named = arm6_with(&format!("{hand}{fingers}")).replace("\"tcp\"", "\"tool0\"");
    let plain = named.replace("\"tool0\"", "\"end\"");
    let grasp = r#"<link name="grasp_tcp"/><joint name="g" type="fixed"><parent link="hand"/><child link="grasp_tcp"/></joint>"#;
    let between = named
        .replace("</robot>", &format!("{grasp}</robot>"))
        .replace("\"tool0\"", "\"end\"");
    for (text, tip, has_gripper) in [
        (&named, "tool0", true),
        (&plain, "end", true),
        (&between, "grasp_tcp", false),
    ] {
        let robot = read(text);
        let arms = find_arms(&robot, &[]).unwrap();
        assert_eq!(group_names(&robot, &arms), [["arm", "link_0", tip]]);
        assert_eq!(arms[0].gripper.is_some(), has_gripper, "{tip}");
        assert_eq!(arms[0].groups[0].joints, 6);
    }
    // A single jaw that turns is recognised by its name.
    let jaw =
        arm6_with(&joint("continuous", "tcp", "jaw", "0 0 0.05", "")).replace("\"tcp\"", "\"end\"");
    let robot = read(&jaw);
    assert_eq!(groups_of(&robot), [["arm", "link_0", "link_6"]]);
}

#[test]
fn a_tip_that_is_named_is_taken() {
    let robot = robot("arm7");
    let link_6 = robot.link("link_6").unwrap();
    let arms = find_arms(&robot, &[link_6]).unwrap();
    assert_eq!(group_names(&robot, &arms), [["arm", "link_0", "link_6"]]);
    let fault = find_arms(&robot, &[robot.root()]).unwrap_err();
    assert_eq!(
        fault.to_string(),
        "link \"link_0\": no joint moves it, but the tip of an arm moves"
    );
}

#[test]
fn a_flange_whose_shape_lies_behind_its_frame_points_away_from_the_arm() {
    // The frame lies on the face of the flange, 0.11 m beyond the joint before, and the shape reaches back to it.
    let turned = |roll: &str| {
        arm6_with(&format!(
            r#"<link name="flange"><collision><origin xyz="0 0 {behind}"/>
              <geometry><cylinder radius="0.03" length="0.03"/></geometry></collision></link>
            <joint name="flange_joint" type="revolute"><parent link="link_6"/><child link="flange"/>
              <origin xyz="0 0 0.11" rpy="{roll} 0 0"/><axis xyz="0 0 1"/>
              <limit lower="-3" upper="3" velocity="2" effort="50"/></joint>"#,
            behind = if roll == "0" { -0.015 } else { 0.015 }
        ))
    };
    for (roll, axis) in [("0", LinkAxis::Z), ("3.14159265", LinkAxis::NegativeZ)] {
        let robot = read(&turned(roll));
        let arms = find_arms(&robot, &[robot.link("flange").unwrap()]).unwrap();
        assert_eq!(arms[0].tip_axis, axis, "{roll}");
    }
}

#[test]
fn a_robot_without_an_arm_is_an_error_that_names_its_longest_chain() {
    let two = joint("continuous", "base", "upper", "0 0 0.1", "")
        + &joint("continuous", "upper", "lower", "0 0 0.3", "");
    let robot = read(&format!(
        "<robot name=\"two\"><link name=\"base\"/>{two}</robot>"
    ));
    let fault = find_arms(&robot, &[]).unwrap_err();
    assert_eq!(
        fault.to_string(),
        "robot \"two\": no arm found: the longest chain that is no leg, head or hand has 2 independent joints (it ends in \"lower\"), expected at least 4"
    );
    // A leg of six joints is no arm either.
    let leg = urdf("arm6").replace("joint_4", "left_knee_joint");
    assert!(matches!(
        find_arms(&read(&leg), &[]),
        Err(SetupError::NoArm { joints: 0, .. })
    ));
}

fn pairs_of(robot: &RobotModel, config: &SetupConfig) -> LinkPairs {
    let arms = find_arms(robot, &[]).unwrap();
    sample_pairs(robot, &arms, config, |_, _, _| {}).unwrap()
}

/// Names of the pairs with a reason.
fn names_of<'a>(robot: &'a RobotModel, pairs: &LinkPairs, reason: &str) -> Vec<[&'a str; 2]> {
    let name = |link: LinkId| robot.links()[link.index()].name.as_str();
    let wanted = pairs.disabled.iter().filter(|pair| pair.reason == reason);
    wanted.map(|pair| [name(pair.a), name(pair.b)]).collect()
}

#[test]
fn pairs_that_never_collide_stay_apart_in_other_random_postures() {
    let robot = robot("arm7");
    let pairs = pairs_of(&robot, &quick());
    assert_eq!(pairs.count("Adjacent"), 7);
    assert!(pairs.count("Never") > 0, "{pairs:?}");
    assert_eq!(pairs.total, 28, "eight links with shapes");
    assert_eq!(pairs.samples, 2000);
    // A model with only these pairs finds no contact in postures of another seed.
    let never = |pair: &DisabledPair| pair.reason == "Never";
    let others = pairs.disabled.iter().filter(|pair| !never(pair));
    let all = Srdf::new(Vec::new(), Vec::new(), others.cloned().collect());
    let model = CollisionModel::new(&robot, Some(&all)).unwrap();
    let named = names_of(&robot, &pairs, "Never");
    let mut random = 1_u64;
    let mut share = || {
        // Knuth's linear congruential generator.
        random = random
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (random >> 11) as f64 / (1_u64 << 53) as f64
    };
    for _ in 0..3000 {
        let q: Vec<f64> = (0..robot.dof())
            .map(|i| {
                let limits = robot.variable(i).limits.position.unwrap();
                limits.lower + share() * (limits.upper - limits.lower)
            })
            .collect();
        if let Some(contact) = model.collision(&q, 0.0).unwrap() {
            let pair = [model.name(contact.a), model.name(contact.b)];
            assert!(!named.contains(&pair), "{pair:?}");
        }
    }
}

/// An arm of four joints about y, with spheres.
fn links_of_spheres(radii: [f64; 5], limit: f64) -> String {
    let range = format!(
        r#"<limit lower="-{limit}" upper="{limit}" velocity="1" effort="9" acceleration="9"/>"#
    );
    let mut text = format!(
        r#"<robot name="spheres"><link name="l0"><collision><geometry><sphere radius="{}"/></geometry></collision></link>"#,
        radii[0]
    );
    for (i, radius) in radii.iter().enumerate().skip(1) {
        let own = joint(
            "revolute",
            &format!("l{}", i - 1),
            &format!("l{i}"),
            "0 0 0.2",
            &range,
        );
        text += &own.replace("radius=\"0.01\"", &format!("radius=\"{radius}\""));
    }
    text + "</robot>"
}

#[test]
fn pairs_get_the_reasons_of_moveit() {
    // 0.2 m between neighbours and little motion: l0 and l2 overlap always, as their radii sum to more than 0.4 m.
    let robot = read(&links_of_spheres([0.21, 0.01, 0.21, 0.01, 0.01], 0.3));
    let pairs = pairs_of(&robot, &quick());
    assert_eq!(names_of(&robot, &pairs, "Adjacent").len(), 4);
    assert_eq!(names_of(&robot, &pairs, "Always"), [["l0", "l2"]]);
    assert_eq!(names_of(&robot, &pairs, "Default"), [[""; 2]; 0]);
    // l0 and l3, 0.6 m apart, cannot bend to within their radii of 0.22 m.
    assert!(names_of(&robot, &pairs, "Never").contains(&["l0", "l3"]));

    // They overlap in about a fifth of the postures, and not in the straight one: checked.
    let robot = read(&links_of_spheres([0.18, 0.01, 0.18, 0.01, 0.01], 1.0));
    let pairs = pairs_of(&robot, &quick());
    for reason in ["Always", "Default"] {
        assert_eq!(names_of(&robot, &pairs, reason), [[""; 2]; 0], "{pairs:?}");
    }
    assert!(!names_of(&robot, &pairs, "Never").contains(&["l0", "l2"]));
    let fold = read(&links_of_spheres([0.05, 0.01, 0.05, 0.01, 0.01], 3.0));
    assert!(!names_of(&fold, &pairs_of(&fold, &quick()), "Never").contains(&["l0", "l2"]));
}

#[test]
fn a_pair_that_no_group_moves_is_disabled_where_it_overlaps() {
    // Two parts on separate joints beside the arm, which overlap in the middle of their ranges only.
    let part = |name: &str, x: &str| {
        joint(
            "revolute",
            "link_0",
            name,
            x,
            r#"<limit lower="-3" upper="3" velocity="1" effort="9"/>"#,
        )
        .replace(
            "<geometry><sphere radius=\"0.01\"/>",
            "<origin xyz=\"0 0 0.3\"/><geometry><sphere radius=\"0.05\"/>",
        )
    };
    let robot = read(&arm6_with(
        &(part("flag_a", "-1 0 0") + &part("flag_b", "-1.05 0 0")),
    ));
    let pairs = pairs_of(&robot, &quick());
    assert_eq!(names_of(&robot, &pairs, "Default"), [["flag_a", "flag_b"]]);
}

fn ready_of(robot: &RobotModel, arm: &ArmChain, config: &SetupConfig) -> (Srdf, ReadyPosture) {
    let pairs = sample_pairs(robot, std::slice::from_ref(arm), config, |_, _, _| {}).unwrap();
    let srdf = Srdf::new(Vec::new(), Vec::new(), pairs.disabled);
    let held = middle_posture(robot);
    let request = ReadyRequest {
        robot,
        group: &arm.groups[0].group,
        axis: arm.tip_axis,
        held: &held,
        collisions: &CollisionModel::new(robot, Some(&srdf)).unwrap(),
        regions: &WipingRegion::around(robot, arm, &held).unwrap(),
    };
    let ready = find_ready(&request, config, |_, _, _| {}).unwrap();
    (srdf, ready)
}

#[test]
fn a_ready_posture_is_free_and_inside_limits_with_the_tool_down() {
    for robot in [robot("arm6"), robot("arm7"), arm6_on_lift()] {
        let arms = find_arms(&robot, &[]).unwrap();
        let (srdf, ready) = ready_of(&robot, &arms[0], &quick());
        let name = robot.name();
        assert_eq!(robot.limit_faults(&ready.q).unwrap(), [], "{name}");
        let model = CollisionModel::new(&robot, Some(&srdf)).unwrap();
        let clearance = model.clearance(&ready.q, 1.0).unwrap().distance;
        assert!(
            clearance >= 0.005 && (clearance - ready.clearance).abs() < 1e-9,
            "{name}: {clearance}"
        );
        let tip = arms[0].groups[0].group.tip;
        let world_from_tip = robot
            .forward_kinematics(&ready.q)
            .unwrap()
            .world_from_link(tip);
        let down = -(world_from_tip.rotation * nalgebra::Vector3::z()).z;
        assert!(down > 0.9999, "{name}: {down}");
        assert!(
            ready.tip.x > 0.2 && ready.tip.z > 0.1,
            "{name}: {}",
            ready.tip
        );
        assert!(ready.limit_share > 0.1, "{name}: {}", ready.limit_share);
        assert_eq!(ready.place, "in front of the robot");
        // The result depends on the seed only.
        assert_eq!(ready_of(&robot, &arms[0], &quick()), (srdf, ready));
    }
}

#[test]
fn limits_of_a_thousand_kilometres_do_not_lead_a_slide_away() {
    let rail = r#"<link name="floor"/>
        <joint name="rail" type="prismatic"><parent link="floor"/><child link="link_0"/><axis xyz="1 0 0"/>
          <limit lower="-1e6" upper="1e6" velocity="1" acceleration="1" effort="1000"/></joint>"#;
    let robot = read(&arm6_with(rail));
    let arms = find_arms(&robot, &[]).unwrap();
    let (_, ready) = ready_of(&robot, &arms[0], &quick());
    assert_eq!(ready.place, "in front of the robot");
    assert!(ready.tip.coords.norm() < 2.5, "{}", ready.tip);
}

#[test]
fn an_arm_that_is_singular_everywhere_still_keeps_from_its_limits() {
    // Seven parallel axes move the tip in a plane only.
    let range = r#"<limit lower="-2" upper="2" velocity="1" effort="50"/>"#;
    let links: Vec<String> = (0..8).map(|i| format!("link_{i}")).collect();
    let joints: String = links
        .windows(2)
        .map(|pair| joint("revolute", &pair[0], &pair[1], "0 0 0.2", range))
        .collect();
    let robot = read(&format!(
        "<robot name=\"flat\"><link name=\"link_0\"/>{joints}</robot>"
    ));
    let arms = find_arms(&robot, &[]).unwrap();
    let (_, ready) = ready_of(&robot, &arms[0], &quick());
    assert!(ready.manipulability <= SINGULAR, "{}", ready.manipulability);
    assert!(ready.limit_share > 0.15, "{}", ready.limit_share);
}

#[test]
fn manipulability_agrees_with_the_closed_form_of_two_links() {
    // Yoshikawa 1985: l1 l2 |sin q2| for the position of a planar arm. With its rotation, the Gram determinant of both
    // columns is that of (linear, angular): computed here from the columns by hand.
    let two = joint("continuous", "base", "upper", "0 0 0", "")
        + &joint("continuous", "upper", "lower", "0.5 0 0", "")
        + r#"<link name="end"/><joint name="end_joint" type="fixed"><parent link="lower"/><child link="end"/><origin xyz="0.3 0 0"/></joint>"#;
    let robot = read(&format!(
        "<robot name=\"two\"><link name=\"base\"/>{two}</robot>"
    ));
    let chain = robot
        .chain(robot.root(), robot.link("end").unwrap())
        .unwrap();
    for bend in [0.3_f64, 1.0, 2.0] {
        // Positions of the end seen from both joints.
        let second = [0.3 * bend.cos(), 0.3 * bend.sin()];
        let first = [0.5 + second[0], second[1]];
        let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1] + 1.0;
        let gram = dot(first, first) * dot(second, second) - dot(first, second).powi(2);
        let found = manipulability(&chain, &[0.4, bend]).unwrap();
        assert!((found - gram.sqrt()).abs() < 1e-9, "{found}");
    }
}

#[test]
fn a_robot_that_is_always_in_collision_has_no_ready_posture() {
    // A wall of the base around the whole reach.
    let text = urdf("arm6").replacen(
        "<link name=\"link_0\">",
        "<link name=\"link_0\"><collision><origin xyz=\"0.5 0 0.4\"/><geometry><box size=\"3 3 0.7\"/></geometry></collision>",
        1,
    );
    let robot = read(&text);
    let arms = find_arms(&robot, &[]).unwrap();
    let held = middle_posture(&robot);
    let mut model = CollisionModel::new(&robot, None).unwrap();
    let cube = wisch_robot::geometry::Mesh::cuboid(nalgebra::Vector3::new(5.0, 5.0, 5.0)).unwrap();
    model
        .add_obstacle("rock", nalgebra::Isometry3::identity(), &cube)
        .unwrap();
    let request = ReadyRequest {
        robot: &robot,
        group: &arms[0].groups[0].group,
        axis: arms[0].tip_axis,
        held: &held,
        collisions: &model,
        regions: &WipingRegion::around(&robot, &arms[0], &held).unwrap(),
    };
    let fault = find_ready(&request, &quick(), |_, _, _| {}).unwrap_err();
    assert!(
        fault
            .to_string()
            .starts_with("group \"arm\": no ready posture found from 400 random postures: "),
        "{fault}"
    );
}

#[test]
fn an_arm_without_ranges_is_no_arm() {
    let fixed = r#"<limit lower="0" upper="0" velocity="1" effort="10"/>"#;
    let names = ["base", "a", "b", "c", "d"];
    let joints: Vec<String> = (names.windows(2))
        .map(|pair| joint("revolute", pair[0], pair[1], "0 0 0.2", fixed))
        .collect();
    let text = format!(
        r#"<robot name="still"><link name="base"/>{}</robot>"#,
        joints.concat()
    );
    let fault = find_arms(&read(&text), &[]).unwrap_err();
    assert!(
        matches!(fault, SetupError::NoRange { joints: 4, .. }),
        "{fault}"
    );
}

#[test]
fn settings_outside_their_ranges_are_errors() {
    let robot = robot("arm6");
    let config = SetupConfig {
        pair_samples: 0,
        ..quick()
    };
    let fault = sample_pairs(&robot, &[], &config, |_, _, _| {}).unwrap_err();
    assert_eq!(
        fault.to_string(),
        "setup.pair_samples: 0 is outside 1 to 10000000"
    );
}

#[test]
fn an_srdf_is_read_back_as_it_was_written() {
    let odd = urdf("arm6").replace("\"tcp\"", "\"a &lt;&quot;b&quot; &amp; c\"");
    let robot = read(&odd);
    let arms = find_arms(&robot, &[]).unwrap();
    let pairs = pairs_of(&robot, &quick());
    let state = GroupState {
        name: "ready".to_owned(),
        group: "arm".to_owned(),
        positions: (0..6).map(|i| (i, 0.1 + i as f64 / 3.0)).collect(),
    };
    let group = arms[0].groups[0].group.clone();
    let srdf = Srdf::new(vec![group], vec![state], pairs.disabled);
    let comments = SrdfComments {
        head: "a -- b --- c\nd -".to_owned(),
        groups: vec!["<group>".to_owned()],
        states: vec!["of & for".to_owned()],
        counterbalanced: String::new(),
        pairs: "pairs".to_owned(),
    };
    let text = srdf.to_xml(&robot, &comments);
    let again = Srdf::parse("again.srdf", &text, &robot).unwrap();
    assert_eq!(again, srdf);
    assert_eq!(Srdf::check("again.srdf", &text, &robot), []);
    assert!(text.contains("<!-- a - - b"), "{text}");
}

#[test]
fn a_posture_of_a_group_that_is_no_chain_keeps_its_joints() {
    let robot = robot("humanoid");
    let shipped = crate::clearance::srdf("humanoid", &robot);
    let text = shipped.to_xml(&robot, &SrdfComments::default());
    let again = Srdf::parse("again.srdf", &text, &robot).unwrap();
    assert_eq!(again.groups, shipped.groups);
    assert_eq!(again.states, shipped.states);
    assert_eq!(again.disabled, shipped.disabled);
}
