//! The robot file: how a robot is reached over ROS 2, how it moves and presses, and its limits.

use ros2_client::Name;
use serde::Deserialize;
use std::fmt::Display;
use std::path::{Path, PathBuf};

/// The schema that this version reads.
const SCHEMA: u32 = 1;
/// The highest DDS domain.
const MAX_DOMAIN: u16 = 232;
/// The largest range of a force sensor [N].
const MOST_RANGE_N: f64 = 1e5;

/// A commented robot file, which `wisch-ros2 template` prints. A test reads it and compares its values with the defaults.
pub(crate) const TEMPLATE: &str = include_str!("template.toml");

/// A robot file as read, with the text from which its hash is computed.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RobotFile {
    pub path: PathBuf,
    pub text: String,
    pub urdf: String,
    /// Link in whose axes frames of force mode are given; `None` is the root link.
    pub base_frame: Option<String>,
    pub link: LinkTable,
    pub motion: MotionTable,
    pub force: ForceTable,
    pub limits: LimitTable,
    pub stop: StopTable,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Record {
    schema: u32,
    urdf: String,
    base_frame: Option<String>,
    #[serde(default)]
    link: LinkTable,
    motion: MotionTable,
    force: ForceTable,
    #[serde(default)]
    limits: LimitTable,
    #[serde(default)]
    stop: StopTable,
}

/// Table `[link]`.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct LinkTable {
    pub domain: Domain,
    /// Addresses of this computer's network interfaces; empty takes those that the environment permits.
    pub interfaces: Vec<std::net::IpAddr>,
    pub service_mapping: MappingChoice,
    pub ros_distro: Distro,
    /// Longest wait for the robot's topics and services [s].
    pub discovery_s: f64,
}

/// The DDS domain.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(untagged)]
pub(crate) enum Domain {
    Number(u16),
    /// "env": that of `ROS_DOMAIN_ID`.
    Word(String),
}

/// How services are mapped to topics.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum MappingChoice {
    /// By the vendor of the server.
    Auto,
    FastDds,
    CycloneDds,
}

/// The ROS 2 distribution of the robot, which decides the layout of some messages.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Distro {
    Humble,
    Jazzy,
}

impl Default for LinkTable {
    fn default() -> Self {
        Self {
            domain: Domain::Word("env".to_owned()),
            interfaces: Vec::new(),
            service_mapping: MappingChoice::Auto,
            ros_distro: Distro::Jazzy,
            discovery_s: 10.0,
        }
    }
}

/// Table `[motion]`.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct MotionTable {
    #[serde(default = "trajectory")]
    pub kind: String,
    pub action: String,
    pub controllers: Vec<String>,
    #[serde(default = "controller_manager")]
    pub controller_manager: String,
    #[serde(default = "joint_states")]
    pub joint_states: String,
    /// Topic with the controller's state, for the time on the trajectory.
    pub progress: Option<String>,
    /// Topic with the speed scaling.
    pub scaling: Option<String>,
    /// Its value at full speed.
    #[serde(default = "full_scaling")]
    pub full_scaling: f64,
    #[serde(default = "knot_error")]
    pub knot_error_rad: f64,
    #[serde(default = "most_bytes")]
    pub most_bytes: usize,
    #[serde(default = "path_tolerance")]
    pub path_tolerance_rad: f64,
}

fn trajectory() -> String {
    "trajectory".to_owned()
}
fn controller_manager() -> String {
    "/controller_manager".to_owned()
}
fn joint_states() -> String {
    "/joint_states".to_owned()
}
const fn full_scaling() -> f64 {
    100.0
}
const fn knot_error() -> f64 {
    1e-4
}
const fn most_bytes() -> usize {
    100_000
}
const fn path_tolerance() -> f64 {
    0.05
}

/// Table `[force]`.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ForceTable {
    pub kind: ForceKind,
    /// Topic with the measured wrench.
    pub topic: Option<String>,
    /// Link in whose axes the wrench is expressed, if the frame of its header is not a link of the URDF.
    pub link: Option<String>,
    /// Largest force along an axis that the sensor measures [N]; `None` if it is not known.
    pub range_n: Option<f64>,
    /// Service that tares the sensor.
    pub tare: Option<String>,
    #[serde(default = "start_force_mode")]
    pub start: String,
    #[serde(default = "stop_force_mode")]
    pub stop: String,
    #[serde(default = "press_speed")]
    pub press_speed_m_s: f64,
}

/// How the robot presses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum ForceKind {
    /// Force mode of Universal Robots.
    UrForceMode,
    /// Not at all: the tool has a spring.
    None,
    /// Not supported yet.
    PressedPose,
    /// Not supported yet.
    TargetWrench,
}

fn start_force_mode() -> String {
    "/force_mode_controller/start_force_mode".to_owned()
}
fn stop_force_mode() -> String {
    "/force_mode_controller/stop_force_mode".to_owned()
}
const fn press_speed() -> f64 {
    0.03
}

/// Table `[limits]`.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct LimitTable {
    pub tool_speed_m_s: f64,
    pub force_n: f64,
    pub start_rad: f64,
    pub state_age_ms: f64,
    pub wrench_age_ms: f64,
    /// Age from which samples state a wrench as stale; `None` is half of `wrench_age_ms`.
    pub wrench_stale_ms: Option<f64>,
    pub lag_m: f64,
    pub depth_m: f64,
}

impl Default for LimitTable {
    fn default() -> Self {
        Self {
            tool_speed_m_s: 0.25,
            force_n: 30.0,
            start_rad: 0.02,
            state_age_ms: 50.0,
            wrench_age_ms: 20.0,
            wrench_stale_ms: None,
            lag_m: 0.03,
            depth_m: 0.02,
        }
    }
}

impl LimitTable {
    /// Age from which samples state a wrench as stale [ms].
    pub fn stale_ms(&self) -> f64 {
        self.wrench_stale_ms.unwrap_or(self.wrench_age_ms)
    }
}

/// Table `[stop]`: topics that say whether the robot may move.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct StopTable {
    /// Topic of type `ur_dashboard_msgs/SafetyMode`.
    pub safety: Option<String>,
    /// Topic of type `std_msgs/Bool`: whether the program on the robot runs.
    pub program: Option<String>,
}

/// An error of a robot file, with file, line, key, value and limit.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub(crate) struct RobotFileError(String);

impl RobotFile {
    /// Reads a robot file.
    ///
    /// # Errors
    /// If the file cannot be read, has unknown or missing keys, or has values outside their limits.
    pub fn read(path: &Path) -> Result<Self, RobotFileError> {
        let text = std::fs::read_to_string(path);
        let text = text.map_err(|error| RobotFileError(format!("{}: {error}", path.display())))?;
        Self::parse(path, text)
    }

    /// Reads the text of a robot file. `path` is its name in errors.
    pub fn parse(path: &Path, text: String) -> Result<Self, RobotFileError> {
        let record: Record = toml::from_str(&text).map_err(|error| {
            let offset = error.span().map_or(0, |span| span.start);
            let message = with_suggestion(error.message());
            let [line, column] = line_and_column(&text, offset);
            RobotFileError(format!("{}:{line}:{column}: {message}", path.display()))
        })?;
        let file = Self {
            path: path.to_owned(),
            urdf: record.urdf,
            base_frame: record.base_frame,
            link: record.link,
            motion: record.motion,
            force: record.force,
            limits: record.limits,
            stop: record.stop,
            text,
        };
        file.check(record.schema)?;
        Ok(file)
    }

    /// Makes the error of a value.
    fn fault(&self, table: &str, key: &str, value: impl Display, limits: &str) -> RobotFileError {
        let line = line_of(&self.text, table, key);
        let name = if table.is_empty() {
            key.to_owned()
        } else {
            format!("{table}.{key}")
        };
        RobotFileError(format!(
            "{}:{line}: {name} = {value}: expected {limits}",
            self.path.display()
        ))
    }

    fn check(&self, schema: u32) -> Result<(), RobotFileError> {
        if schema != SCHEMA {
            return Err(self.fault("", "schema", schema, &format!("{SCHEMA}")));
        }
        match &self.link.domain {
            Domain::Number(number) if *number > MAX_DOMAIN => {
                return Err(self.fault("link", "domain", number, "0 to 232, or \"env\""));
            }
            Domain::Word(word) if word != "env" => {
                let shown = format!("{word:?}");
                return Err(self.fault("link", "domain", shown, "0 to 232, or \"env\""));
            }
            _ => {}
        }
        if self.motion.kind != "trajectory" {
            let shown = format!("{:?}", self.motion.kind);
            let expected = "\"trajectory\"; motion by poses is not supported yet";
            return Err(self.fault("motion", "kind", shown, expected));
        }
        if let kind @ (ForceKind::PressedPose | ForceKind::TargetWrench) = self.force.kind {
            let expected =
                "\"ur_force_mode\" or \"none\"; pressing by poses or wrenches is not supported yet";
            return Err(self.fault("force", "kind", format!("{kind:?}"), expected));
        }
        if self.motion.controllers.is_empty() {
            let expected = "the names of the controllers that the motion needs";
            return Err(self.fault("motion", "controllers", "[]", expected));
        }
        if self.force.kind == ForceKind::UrForceMode && self.force.topic.is_none() {
            let expected =
                "the topic of the measured wrench, because the robot presses with a force";
            return Err(self.fault("force", "topic", "(missing)", expected));
        }
        self.check_ranges()?;
        self.check_names()
    }

    fn check_ranges(&self) -> Result<(), RobotFileError> {
        let Self {
            link,
            motion,
            force,
            limits,
            ..
        } = self;
        for (table, key, value, [least, most]) in [
            ("link", "discovery_s", link.discovery_s, [0.1, 120.0]),
            ("motion", "full_scaling", motion.full_scaling, [1e-3, 1e6]),
            (
                "motion",
                "knot_error_rad",
                motion.knot_error_rad,
                [1e-6, 0.1],
            ),
            ("motion", "most_bytes", motion.most_bytes as f64, [1e3, 1e7]),
            (
                "motion",
                "path_tolerance_rad",
                motion.path_tolerance_rad,
                [0.0, 1.0],
            ),
            (
                "force",
                "press_speed_m_s",
                force.press_speed_m_s,
                [1e-3, 0.25],
            ),
            (
                "limits",
                "tool_speed_m_s",
                limits.tool_speed_m_s,
                [1e-3, 3.0],
            ),
            ("limits", "force_n", limits.force_n, [0.1, 500.0]),
            ("limits", "start_rad", limits.start_rad, [1e-4, 0.2]),
            ("limits", "state_age_ms", limits.state_age_ms, [2.0, 500.0]),
            (
                "limits",
                "wrench_age_ms",
                limits.wrench_age_ms,
                [2.0, 500.0],
            ),
            ("limits", "lag_m", limits.lag_m, [1e-3, 0.5]),
            ("limits", "depth_m", limits.depth_m, [1e-3, 0.1]),
        ] {
            if !(least..=most).contains(&value) {
                return Err(self.fault(table, key, value, &format!("{least} to {most}")));
            }
        }
        if let Some(stale) = limits.wrench_stale_ms
            && !(1.0..=limits.wrench_age_ms).contains(&stale)
        {
            let expected = format!("1 to limits.wrench_age_ms = {}", limits.wrench_age_ms);
            return Err(self.fault("limits", "wrench_stale_ms", stale, &expected));
        }
        if let Some(range) = force.range_n
            && !(range > limits.force_n && range <= MOST_RANGE_N)
        {
            let expected = format!(
                "more than limits.force_n = {}, at most {MOST_RANGE_N}: a force beyond the sensor's range is no overload",
                limits.force_n
            );
            return Err(self.fault("force", "range_n", range, &expected));
        }
        Ok(())
    }

    /// Checks that every name of a topic, service or action is a full name.
    fn check_names(&self) -> Result<(), RobotFileError> {
        let Self {
            motion,
            force,
            stop,
            ..
        } = self;
        for (table, key, name) in [
            ("motion", "action", Some(&motion.action)),
            (
                "motion",
                "controller_manager",
                Some(&motion.controller_manager),
            ),
            ("motion", "joint_states", Some(&motion.joint_states)),
            ("motion", "progress", motion.progress.as_ref()),
            ("motion", "scaling", motion.scaling.as_ref()),
            ("force", "topic", force.topic.as_ref()),
            ("force", "tare", force.tare.as_ref()),
            ("force", "start", Some(&force.start)),
            ("force", "stop", Some(&force.stop)),
            ("stop", "safety", stop.safety.as_ref()),
            ("stop", "program", stop.program.as_ref()),
        ] {
            let Some(name) = name else {
                continue;
            };
            if !name.starts_with('/') || Name::parse(name).is_err() {
                let expected = "a full name of ROS 2, which begins with /";
                return Err(self.fault(table, key, format!("{name:?}"), expected));
            }
        }
        Ok(())
    }

    /// Path of the file that `push-test` writes beside this file.
    pub fn commissioning_path(&self) -> PathBuf {
        self.path.with_extension("commissioned.toml")
    }
}

/// Line of a key in a table, from 1; the line of the table, or 1, if the key is not there.
fn line_of(text: &str, table: &str, key: &str) -> usize {
    let (mut current, mut table_line) = ("", 1);
    for (number, line) in text.lines().enumerate() {
        let line = line.trim();
        if let Some(name) = line.strip_prefix('[') {
            current = name.trim_end_matches(']').trim();
            if current == table {
                table_line = number + 1;
            }
        }
        let name = line.split('=').next().unwrap_or_default().trim();
        if current == table && name == key {
            return number + 1;
        }
    }
    table_line
}

/// Line and column of an offset, from 1.
fn line_and_column(text: &str, offset: usize) -> [usize; 2] {
    let before = text.get(..offset).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |at| at + 1);
    [
        before.matches('\n').count() + 1,
        before[line_start..].chars().count() + 1,
    ]
}

/// Adds the most similar known name to the message of an unknown one.
fn with_suggestion(message: &str) -> String {
    let mut quoted = message.split('`').skip(1).step_by(2);
    let is_unknown = message.starts_with("unknown field") || message.starts_with("unknown variant");
    let Some(given) = quoted.next().filter(|_| is_unknown) else {
        return message.to_owned();
    };
    let similar = quoted
        .map(|known| (strsim::jaro_winkler(given, known), known))
        .filter(|(similarity, _)| *similarity > 0.8)
        .max_by(|a, b| a.0.total_cmp(&b.0));
    match similar {
        Some((_, known)) => format!("{message}; similar: `{known}`"),
        None => message.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SMALL: &str = "schema = 1\nurdf = \"arm7\"\n[motion]\naction = \"/jtc/follow_joint_trajectory\"\n\
                         controllers = [\"jtc\"]\n[force]\nkind = \"none\"\n";

    fn error(text: &str) -> String {
        let read = RobotFile::parse(Path::new("R.toml"), text.to_owned());
        read.unwrap_err().to_string()
    }

    #[test]
    fn the_template_is_read_and_its_values_are_the_defaults() {
        let template = RobotFile::parse(Path::new("R.toml"), TEMPLATE.to_owned()).unwrap();
        let small = RobotFile::parse(Path::new("R.toml"), SMALL.to_owned()).unwrap();
        assert_eq!(template.limits, small.limits);
        assert_eq!(template.link, small.link);
        assert_eq!(template.motion.most_bytes, small.motion.most_bytes);
        assert_eq!(template.motion.knot_error_rad, small.motion.knot_error_rad);
        assert_eq!(template.force.press_speed_m_s, small.force.press_speed_m_s);
        assert_eq!(template.force.start, small.force.start);
    }

    #[test]
    fn an_unknown_key_is_refused_with_its_place_and_a_similar_key() {
        let text = SMALL.replace("controllers", "contollers");
        let error = error(&text);
        assert!(
            error.starts_with("R.toml:5:1: unknown field `contollers`"),
            "{error}"
        );
        assert!(error.ends_with("similar: `controllers`"), "{error}");
    }

    #[test]
    fn a_value_outside_its_limits_is_refused_with_its_line() {
        let text = format!("{SMALL}[limits]\n\nforce_n = 900\n");
        assert_eq!(
            error(&text),
            "R.toml:10: limits.force_n = 900: expected 0.1 to 500"
        );
        let text = SMALL.replace("\"/jtc/follow", "\"jtc/follow");
        assert!(
            error(&text).contains("R.toml:4: motion.action"),
            "{}",
            error(&text)
        );
        let text = SMALL.replace("\"none\"", "\"pressed_pose\"");
        assert!(error(&text).contains("not supported yet"));
        let text = format!("{SMALL}range_n = 30\n");
        assert!(
            error(&text).starts_with(
                "R.toml:8: force.range_n = 30: expected more than limits.force_n = 30"
            )
        );
        let text = format!("{SMALL}[limits]\nwrench_stale_ms = 21\n");
        assert_eq!(
            error(&text),
            "R.toml:9: limits.wrench_stale_ms = 21: expected 1 to limits.wrench_age_ms = 20"
        );
        let text = SMALL.replace("schema = 1", "schema = 7");
        assert_eq!(error(&text), "R.toml:1: schema = 7: expected 1");
    }
}
