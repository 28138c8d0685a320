//! The quality of measured wrenches, as samples state it, and what is assumed about them.

use crate::readings::WrenchReading;
use crate::robot_file::RobotFile;
use std::time::Instant;
use wisch::interpret::WrenchQuality;

/// Returns the quality of a sample's wrench; if several apply, the first of stale, saturated and untared.
///
/// - `wrench`: the latest wrench; `None` if the robot does not measure it, which is stated as stale.
/// - `at`: arrival of the joint state of the sample.
/// - `is_tared`: whether the force was tared in this motion.
pub(crate) fn assess_wrench(
    file: &RobotFile,
    wrench: Option<&WrenchReading>,
    at: Instant,
    is_tared: bool,
) -> WrenchQuality {
    let Some(wrench) = wrench else {
        return WrenchQuality::Stale;
    };
    let age_ms = 1e3 * at.saturating_duration_since(wrench.measured).as_secs_f64();
    let greatest = wrench
        .force
        .iter()
        .fold(0.0_f64, |most, f| most.max(f.abs()));
    if age_ms > file.limits.stale_ms() {
        WrenchQuality::Stale
    } else if file.force.range_n.is_some_and(|range| greatest >= range) {
        WrenchQuality::Saturated
    } else if !is_tared {
        WrenchQuality::Untared
    } else {
        WrenchQuality::Ok
    }
}

/// Returns what is assumed about the wrenches of a robot, one sentence each. `is_in_air`: the robot moves without force.
pub(crate) fn assumptions(file: &RobotFile, is_in_air: bool) -> Vec<String> {
    let Some(topic) = &file.force.topic else {
        return vec![
            "force.topic is missing: no force is measured, so samples state every wrench as stale"
                .to_owned(),
        ];
    };
    let mut assumed = Vec::new();
    if file.force.range_n.is_none() {
        assumed.push(format!(
            "force.range_n is missing: {topic} is assumed never to be at the end of the sensor's range"
        ));
    }
    if is_in_air {
        assumed.push(
            "--air: the force is never tared, so samples state every wrench as untared, and no overload is detected"
                .to_owned(),
        );
    }
    assumed
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;
    use std::time::Duration;

    const TEXT: &str = "schema = 1\nurdf = \"arm7\"\n[motion]\naction = \"/jtc/follow_joint_trajectory\"\n\
                        controllers = [\"jtc\"]\n[force]\nkind = \"none\"\ntopic = \"/ft\"\n";

    fn file(text: &str) -> RobotFile {
        RobotFile::parse(Path::new("R.toml"), text.to_owned()).unwrap()
    }

    #[test]
    fn a_wrench_is_stale_before_saturated_before_untared() {
        let file = file(&format!(
            "{TEXT}range_n = 60\n[limits]\nwrench_age_ms = 20\n"
        ));
        let measured = Instant::now();
        let wrench = |force| WrenchReading {
            arrival: measured,
            measured,
            stamp: 1.0,
            frame: "tool0".to_owned(),
            force,
        };
        let small = wrench([1.0, 0.0, 59.9]);
        let large = wrench([0.0, -60.0, 3.0]);
        for (wrench, age_ms, is_tared, expected) in [
            (Some(&small), 10, true, WrenchQuality::Ok),
            (Some(&small), 10, false, WrenchQuality::Untared),
            (Some(&large), 10, false, WrenchQuality::Saturated),
            // Stale from half of wrench_age_ms on.
            (Some(&large), 21, true, WrenchQuality::Stale),
            (Some(&small), 21, false, WrenchQuality::Stale),
            (None, 0, true, WrenchQuality::Stale),
        ] {
            let at = measured + Duration::from_millis(age_ms);
            let found = assess_wrench(&file, wrench, at, is_tared);
            assert_eq!(found, expected, "{age_ms} ms, {is_tared}");
        }
        // A wrench that is newer than the joint state is not stale.
        let earlier = measured.checked_sub(Duration::from_secs(1)).unwrap();
        assert_eq!(
            assess_wrench(&file, Some(&small), earlier, true),
            WrenchQuality::Ok
        );
    }

    #[test]
    fn what_is_not_known_of_the_wrench_is_said() {
        let known = file(&format!("{TEXT}range_n = 60\n"));
        assert!(assumptions(&known, false).is_empty());
        assert!(assumptions(&known, true)[0].contains("untared"));
        assert!(assumptions(&file(TEXT), false)[0].contains("force.range_n is missing"));
        let without = file(&TEXT.replace("topic = \"/ft\"\n", ""));
        assert!(assumptions(&without, true)[0].contains("stale"));
    }
}
