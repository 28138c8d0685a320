//! SRDF files: those that are shipped, their faults, and which groups are chains.

use crate::clearance::{HUMANOID, committed, robot, srdf};
use proptest::prelude::*;
use wisch_robot::{CollisionModel, Severity, Srdf};

#[test]
fn the_shipped_srdf_files_are_valid() {
    for (name, groups) in [
        ("humanoid", &["right_arm", "left_arm"][..]),
        ("arm7", &["arm"]),
        ("arm6", &["arm"]),
    ] {
        let robot = robot(name);
        let srdf = srdf(name, &robot);
        let found: Vec<_> = srdf
            .groups
            .iter()
            .map(|group| group.name.as_str())
            .collect();
        assert_eq!(found, groups);
        for group in &srdf.groups {
            robot.chain(group.base, group.tip).unwrap();
        }
        let ready = srdf.state("ready").unwrap();
        assert_eq!(ready.positions.len(), robot.dof());
        assert_eq!(
            robot
                .limit_faults(&ready.apply_to(&vec![0.0; robot.dof()]))
                .unwrap(),
            []
        );
    }
    let whole_body = &srdf("humanoid", &robot("humanoid")).ignored[0];
    assert_eq!(whole_body.what, "group \"whole_body\": not one chain");
}

const ARM: &str = r#"<robot name="arm">
  <group name="arm"><chain base_link="link_0" tip_link="tcp"/></group>
  <group_state name="home" group="arm"><joint name="joint_1" value="0.5"/></group_state>
  <disable_collisions link1="link_0" link2="link_2" reason="Never"/>
</robot>"#;

#[test]
fn faults_of_an_srdf_are_found_and_placed() {
    let robot = robot("arm7");
    Srdf::parse("arm.srdf", ARM, &robot).unwrap();
    let table = [
        ("<robot", "<robots", "arm.srdf:"),
        (
            "tip_link=\"tcp\"",
            "tip_link=\"tpc\"",
            "arm.srdf:2:21: unknown link \"tpc\"; nearest: tcp",
        ),
        (
            "tip_link=\"tcp\"",
            "",
            "arm.srdf:2:21: <chain tip_link=\"\">: expected a name",
        ),
        (
            "base_link=\"link_0\" tip_link=\"tcp\"",
            "base_link=\"tcp\" tip_link=\"link_0\"",
            "arm.srdf:2:21: group \"arm\": link \"link_0\" is no descendant of link \"tcp\"",
        ),
        (
            "joint_1",
            "joint_9",
            "arm.srdf:3:40: unknown variable joint \"joint_9\"; nearest: joint_",
        ),
        (
            "name=\"joint_1\"",
            "name=\"flange\"",
            "arm.srdf:3:40: unknown variable joint \"flange\"",
        ),
        (
            "0.5",
            "half",
            "arm.srdf:3:40: <joint value=\"half\">: expected a number",
        ),
        (
            "0.5",
            "NaN",
            "arm.srdf:3:40: <joint value=\"NaN\">: expected a number",
        ),
    ];
    for (good, bad, expected) in table {
        assert!(ARM.contains(good), "{good}");
        let message = Srdf::parse("arm.srdf", &ARM.replacen(good, bad, 1), &robot)
            .unwrap_err()
            .to_string();
        assert!(message.starts_with(expected), "{message}\n{expected}");
    }
}

#[test]
fn pairs_and_postures_that_harm_no_group_are_passed_over() {
    let robot = robot("arm7");
    for (good, bad, expected, severity) in [
        (
            "link_2\"",
            "link_99\"",
            "arm.srdf:4:3: robot: unknown link \"link_99\"; nearest: link_",
            Severity::Warning,
        ),
        (
            "  <disable",
            "<group name=\"hand\"><joint name=\"finger\"/></group><group_state name=\"open\" group=\"hand\"><joint name=\"finger\" value=\"0\"/></group_state>  <disable",
            "arm.srdf:4:50: robot: posture \"open\": the robot has no joint \"finger\"",
            Severity::Note,
        ),
        (
            "  <disable",
            "<group_state name=\"folded\" group=\"\"/>  <disable",
            "arm.srdf:4:1: robot: posture \"folded\": it belongs to no group",
            Severity::Note,
        ),
        (
            "  <disable",
            "<group_state name=\"folded\" group=\"amr\"/>  <disable",
            "arm.srdf:4:1: robot: posture \"folded\": there is no group \"amr\"",
            Severity::Note,
        ),
    ] {
        let text = ARM.replacen(good, bad, 1);
        let srdf = Srdf::parse("arm.srdf", &text, &robot).unwrap();
        assert_eq!(srdf.states.len(), 1);
        let [found] = &srdf.passed_over[..] else {
            panic!("{:?}", srdf.passed_over);
        };
        assert!(found.to_string().starts_with(expected), "{found}");
        assert_eq!(found.severity, severity);
        assert!(Srdf::check("arm.srdf", &text, &robot).contains(found));
    }
    // The ready posture is read as written, or not at all.
    let ready = ARM.replace("\"home\" group=\"arm\"", "\"ready\" group=\"arm\"");
    Srdf::parse("arm.srdf", &ready.replace("joint_1", "joint_9"), &robot).unwrap_err();
}

#[test]
fn what_other_programs_read_is_read_with_a_warning() {
    let robot = robot("arm7");
    let second = "<group name=\"hand\"><chain base_link=\"tcp\" tip_link=\"tpc\"/></group>";
    for (good, bad, expected) in [
        (
            "0.5",
            "5.0",
            "arm.srdf:3:40: robot: posture \"home\": joint \"joint_1\" is at 5 rad, expected a position from -2.8973 to 2.8973 rad; 2.8973 rad is used instead",
        ),
        (
            "</group_state>",
            "<joint name=\"joint_1\" value=\"0\"/></group_state>",
            "arm.srdf:3:75: robot: posture \"home\": joint \"joint_1\" is set twice",
        ),
        (
            "  <disable",
            "<group name=\"arm\"/>  <disable",
            "arm.srdf:4:1: robot: group \"arm\" is defined twice",
        ),
        (
            "  <disable",
            &format!("{second}  <disable"),
            "arm.srdf:4:20: robot: unknown link \"tpc\"; nearest: tcp",
        ),
        (
            "  <disable",
            "<group_state name=\"home\" group=\"arm\"/>  <disable",
            "arm.srdf:4:1: robot: state \"home\" of group \"arm\" is defined twice",
        ),
        (
            "  <disable",
            "<!-- a--b -->  <disable",
            "arm.srdf:4:1: robot: a comment contains two hyphens",
        ),
    ] {
        let text = ARM.replacen(good, bad, 1);
        let srdf = Srdf::parse("arm.srdf", &text, &robot).unwrap();
        assert_eq!((srdf.groups.len(), srdf.states.len()), (1, 1), "{bad}");
        assert_eq!(srdf.states[0].positions.len(), 1, "{bad}");
        let [found] = &srdf.passed_over[..] else {
            panic!("{:?}", srdf.passed_over);
        };
        assert!(found.to_string().starts_with(expected), "{found}");
        assert_eq!(found.severity, Severity::Warning);
    }
    // Links of pairs that the robot does not have share a warning.
    let pair = "<disable_collisions link1=\"f_1\" link2=\"f_2\"/>";
    let text = ARM.replace("</robot>", &format!("{pair}</robot>"));
    let srdf = Srdf::parse("arm.srdf", &text, &robot).unwrap();
    assert_eq!(
        srdf.passed_over[0].value,
        "2 unknown links: \"f_1\", \"f_2\""
    );
    assert_eq!(srdf.passed_over.len(), 1);
}

#[test]
fn groups_that_are_no_chains_are_listed_as_not_read() {
    let text = ARM.replace(
        "<group name=\"arm\"><chain base_link=\"link_0\" tip_link=\"tcp\"/></group>",
        "<group name=\"arm\"><joint name=\"joint_1\"/></group><group name=\"hand\"><link name=\"tcp\"/><link name=\"link_7\"/></group>",
    );
    let srdf = Srdf::parse("arm.srdf", &text, &robot("arm7")).unwrap();
    assert!(srdf.groups.is_empty());
    assert_eq!(srdf.states[0].positions, [(0, 0.5)]);
    let ignored: Vec<_> = srdf.ignored.iter().map(|i| i.what.as_str()).collect();
    assert_eq!(
        ignored,
        [
            "group \"arm\" of a joint, not a chain",
            "group \"hand\": not one chain"
        ]
    );
    let found = Srdf::check("arm.srdf", &text, &robot("arm7"));
    let notes = found
        .iter()
        .filter(|found| found.severity == Severity::Note);
    let notes: Vec<_> = notes.map(|found| found.value.as_str()).collect();
    let expected = "2 groups are not one chain each, and are ignored: \"arm\", \"hand\"";
    assert_eq!(notes, [expected]);
    let message = srdf.group("arm").unwrap_err().to_string();
    assert_eq!(
        message,
        "unknown group that is a chain \"arm\"; no group that is a chain is known"
    );
}

#[test]
fn joints_one_behind_the_other_are_a_chain() {
    let robot = robot("arm7");
    let parse = |joints: &[usize]| {
        let members: String = (joints.iter())
            .map(|i| format!("<joint name=\"joint_{i}\"/>"))
            .collect();
        let text = ARM.replace(
            "  <disable",
            &format!("<group name=\"listed\">{members}</group>  <disable"),
        );
        Srdf::parse("arm.srdf", &text, &robot).unwrap()
    };
    let whole = parse(&[1, 2, 3, 4, 5, 6, 7]);
    // Without a name, the first group wipes: the one that is declared as a chain.
    assert_eq!(whole.groups[0].name, "arm");
    let listed = whole.group("listed").unwrap();
    let chain = robot.chain(listed.base, listed.tip).unwrap();
    assert_eq!(chain.variables().len(), 7);
    assert_eq!(robot.links()[listed.tip.index()].name, "link_7");
    // The order in which they are listed has no meaning.
    let shuffled = parse(&[7, 2, 3, 6, 5, 4, 1]);
    assert_eq!(shuffled.group("listed").unwrap(), listed);
    // With a gap, or a single joint, such as that of a gripper.
    for joints in [&[1, 2, 4, 5][..], &[4, 1, 3], &[7]] {
        let srdf = parse(joints);
        assert_eq!(srdf.groups.len(), 1, "{joints:?}");
        assert_eq!(srdf.ignored.len(), 1, "{joints:?}");
    }
}

proptest! {
    #[test]
    fn no_change_of_an_srdf_breaks_the_reader(
        cuts in prop::collection::vec((any::<prop::sample::Index>(), 0..60usize, 0..6usize), 1..4)
    ) {
        let (robot, ..) = &*HUMANOID;
        let mut text = committed("humanoid.srdf");
        for (at, length, how) in cuts {
            let start = text.floor_char_boundary(at.index(text.len()));
            let end = text.floor_char_boundary((start + length).min(text.len()));
            let with = ["", "torso_4", "-1e9", "\"", "<group name=\"right_arm\"/>", "0"][how];
            text.replace_range(start..if how % 2 == 0 { end } else { start }, with);
        }
        if let Ok(srdf) = Srdf::parse("humanoid.srdf", &text, robot) {
            for group in &srdf.groups {
                robot.chain(group.base, group.tip).unwrap();
            }
            CollisionModel::new(robot, Some(&srdf)).unwrap();
        }
    }
}
