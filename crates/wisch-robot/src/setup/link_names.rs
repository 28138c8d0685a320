//! Parts of a robot, by the names of links and joints.

/// Names of a gripper's parts.
const GRIPPER: [&str; 11] = [
    "gripper", "finger", "fingers", "jaw", "claw", "thumb", "knuckle", "palm", "robotiq", "pinch",
    "pincer",
];
/// Names of the links that a gripper's joints move.
const FINGER: [&str; 8] = [
    "finger", "fingers", "jaw", "claw", "thumb", "knuckle", "pinch", "pincer",
];
/// Names of joints that turn a hand.
const WRIST: [&str; 5] = ["wrist", "yaw", "pitch", "roll", "flex"];
/// Names of parts of legs and wheels.
const LEG: [&str; 15] = [
    "leg", "foot", "ankle", "hip", "knee", "toe", "sole", "thigh", "calf", "shin", "tibia",
    "femur", "wheel", "hfe", "kfe",
];
/// Names of parts of a head.
const HEAD: [&str; 5] = ["head", "neck", "eye", "eyes", "eyelid"];
/// Names of sensors and of frames without a body.
const SENSOR: [&str; 22] = [
    "camera",
    "cam",
    "sensor",
    "range",
    "imu",
    "accelerometer",
    "gyro",
    "optical",
    "laser",
    "lidar",
    "sonar",
    "light",
    "led",
    "marker",
    "rgb",
    "depth",
    "ft",
    "force",
    "torque",
    "skin",
    "projector",
    "antenna",
];

/// Kinds of tips by their names, the best first.
pub(super) const TIP_KINDS: [&str; 6] = [
    "named as a tool frame (tool0)",
    "named as a tool centre point (tcp)",
    "named as a tool",
    "named as a flange",
    "named as an end effector",
    "the outermost link",
];

/// Returns the words of a name in lower case: `LHipYaw` and `l_hip-yaw` both are l, hip, yaw.
pub(super) fn split_words(name: &str) -> Vec<String> {
    let letters: Vec<char> = name.chars().collect();
    let mut words = vec![String::new()];
    for (i, &c) in letters.iter().enumerate() {
        let before = i.checked_sub(1).map(|i| letters[i]);
        let after = letters.get(i + 1);
        let begins_after_small = before.is_some_and(char::is_lowercase) && c.is_uppercase();
        let begins_before_small = before.is_some_and(char::is_uppercase)
            && c.is_uppercase()
            && after.is_some_and(|c| c.is_lowercase());
        let begins_number = before.is_some_and(char::is_alphabetic) && c.is_ascii_digit();
        if begins_after_small || begins_before_small || begins_number {
            words.push(String::new());
        }
        match (c.is_alphanumeric(), words.last_mut()) {
            (true, Some(word)) => word.extend(c.to_lowercase()),
            _ => words.push(String::new()),
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

fn has_word(name: &str, words: &[&str]) -> bool {
    let own = split_words(name);
    own.iter().any(|word| words.contains(&word.as_str()))
}

pub(super) fn is_gripper(name: &str) -> bool {
    has_word(name, &GRIPPER)
}

pub(super) fn is_finger(name: &str) -> bool {
    has_word(name, &FINGER)
}

pub(super) fn is_wrist(name: &str) -> bool {
    has_word(name, &WRIST)
}

pub(super) fn is_leg(name: &str) -> bool {
    has_word(name, &LEG)
}

pub(super) fn is_head(name: &str) -> bool {
    has_word(name, &HEAD)
}

pub(super) fn is_sensor(name: &str) -> bool {
    has_word(name, &SENSOR)
}

/// Returns the side of the body that a name states: "left" or "right".
pub(super) fn side(name: &str) -> Option<&'static str> {
    split_words(name)
        .iter()
        .find_map(|word| match word.as_str() {
            "left" | "l" => Some("left"),
            "right" | "r" => Some("right"),
            _ => None,
        })
}

/// Whether a kind of tip lies where a gripper holds a tool.
pub(super) const fn is_in_grasp(kind: usize) -> bool {
    matches!(kind, 1 | 4)
}

/// Returns the index of a name among [`TIP_KINDS`].
pub(super) fn tip_kind(name: &str) -> usize {
    let words = split_words(name);
    let has = |wanted: &[&str]| words.iter().any(|word| wanted.contains(&word.as_str()));
    let joined = words.concat();
    if joined.ends_with("tool0") {
        0
    } else if has(&["tcp"]) {
        1
    } else if has(&["tool", "tooltip"]) {
        2
    } else if has(&["flange"]) {
        3
    } else if has(&["ee", "eef", "endeffector"]) || joined.contains("endeffector") {
        4
    } else {
        5
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_begin_at_separators_capitals_and_numbers() {
        assert_eq!(split_words("LHipYaw"), ["l", "hip", "yaw"]);
        assert_eq!(split_words("l_hip-yaw"), ["l", "hip", "yaw"]);
        assert_eq!(split_words("panda_link8"), ["panda", "link", "8"]);
        assert_eq!(split_words("leftArmFT"), ["left", "arm", "ft"]);
        assert_eq!(split_words("__"), [""; 0]);
    }

    #[test]
    fn parts_are_recognised_by_whole_words() {
        assert!(is_leg("LHipYaw") && is_leg("left_ankle_roll_joint") && !is_leg("whip_chip"));
        assert!(is_gripper("panda_finger_joint1") && !is_gripper("fingerprint_reader"));
        assert!(is_head("HeadPitch") && !is_head("overhead_rail"));
        assert!(is_sensor("wrist_ft_link") && !is_sensor("forearm"));
        assert_eq!(
            (side("r_wrist"), side("LWrist")),
            (Some("right"), Some("left"))
        );
        assert_eq!(side("wrist_roll"), None);
    }

    #[test]
    fn a_tip_is_recognised_by_its_name() {
        let kinds = [
            "tool0",
            "robot_tool0",
            "panda_hand_tcp",
            "arm_tool_link",
            "link_flange",
            "ee_link",
        ];
        assert_eq!(kinds.map(tip_kind), [0, 0, 1, 2, 3, 4]);
        assert_eq!(
            ["j2s6s200_end_effector", "link_eef", "wrist_3_link"].map(tip_kind),
            [4, 4, 5]
        );
    }
}
