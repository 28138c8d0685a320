//! Frames on demand: telemetry stores joints, from which the poses of links, tool and surface are computed.

use crate::telemetry::{Telemetry, TelemetryError, TelemetryHead};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::PathBuf;
use wisch::geometry::{Pose, restore_pose};
use wisch::robot::{LinkId, RobotError, RobotModel};
use wisch::run::PlannedRound;

/// Version of the schema of [`RoundScene`].
pub const SCENE_SCHEMA: u32 = 1;
/// Key of the telemetry's note that holds the scene.
const SCENE_NOTE: &str = "scene";
/// Frames that every episode has beside the robot's links.
const OWN_FRAMES: [&str; 6] = ["tool", "tcp", "robot", "base", "surface", "world"];
/// Columns of a log's telemetry: pose of the tool (position \[m\], then quaternion x, y, z, w), then force on it \[N\].
pub const LOG_COLUMNS: [&str; 10] = [
    "measured/x",
    "measured/y",
    "measured/z",
    "measured/qx",
    "measured/qy",
    "measured/qz",
    "measured/qw",
    "external/fx",
    "external/fy",
    "external/fz",
];
/// Number of [`LOG_COLUMNS`] that hold the pose.
const POSE_COLUMNS: usize = 7;
/// Name of the surface where its pose is unknown.
const NO_SURFACE: &str = "";
/// Longest time between a requested pose and the sample that represents it [s].
const LONGEST_GAP: f64 = 0.5;
/// Largest number of poses in a trajectory: an hour at 1 kHz.
const MAX_SAMPLES: usize = 4_000_000;

/// Poses of a round that joints do not determine.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RoundScene {
    /// [`SCENE_SCHEMA`].
    pub schema: u32,
    /// Name of the robot.
    pub robot: String,
    /// Pose of its root link in the world.
    pub world_from_root: StoredPose,
    /// Link that stands on the floor and moves over it; `None` if this is the root.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub base: Option<String>,
    /// Link that holds the tool.
    pub tip: String,
    /// Pose of the tool in the frame of that link.
    pub tip_from_tool: StoredPose,
    /// Name of the tool.
    pub tool: String,
    /// Name of the surface.
    pub surface: String,
    /// Believed pose of the surface.
    pub world_from_surface: StoredPose,
}

/// A pose in its stored form.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct StoredPose {
    /// Position \[m\].
    pub position: [f64; 3],
    /// Unit quaternion x, y, z, w.
    pub quaternion: [f64; 4],
}

impl From<&Pose> for StoredPose {
    fn from(pose: &Pose) -> Self {
        Self {
            position: pose.translation.vector.into(),
            quaternion: pose.rotation.coords.into(),
        }
    }
}

impl From<StoredPose> for Pose {
    fn from(stored: StoredPose) -> Self {
        let ([x, y, z], [i, j, k, w]) = (stored.position, stored.quaternion);
        restore_pose(&[x, y, z, i, j, k, w])
    }
}

impl RoundScene {
    /// Returns the scene of a round.
    pub fn from_motion(motion: &PlannedRound) -> Self {
        let cell = &motion.cell;
        let robot = cell.robot();
        Self {
            schema: SCENE_SCHEMA,
            robot: robot.name().to_owned(),
            world_from_root: cell.world_from_root().into(),
            base: cell.base().map(|base| {
                let carried = robot.variable(base.yaw).child;
                robot.links()[carried.index()].name.clone()
            }),
            tip: robot.links()[cell.tip().index()].name.clone(),
            tip_from_tool: cell.tip_from_tool().into(),
            tool: motion.task.tool.name.clone(),
            surface: motion.task.surface.name.clone(),
            world_from_surface: (&motion.task.surface.world_from_surface).into(),
        }
    }

    /// Returns a scene with the robot at the world's origin, the tool's frame at that of its link, and the surface at
    /// the world's origin. It serves tests and examples without wiping.
    pub fn with_upright_tool(robot: &str, tip: &str, tool: &str, surface: &str) -> Self {
        let nowhere = StoredPose::from(&Pose::identity());
        Self {
            schema: SCENE_SCHEMA,
            robot: robot.to_owned(),
            world_from_root: nowhere,
            base: None,
            tip: tip.to_owned(),
            tip_from_tool: nowhere,
            tool: tool.to_owned(),
            surface: surface.to_owned(),
            world_from_surface: nowhere,
        }
    }

    /// Returns the scene of a log with the tool's poses but without a robot.
    pub fn from_log(tool: &str, surface: &str, world_from_surface: &Pose) -> Self {
        Self {
            world_from_surface: world_from_surface.into(),
            ..Self::with_upright_tool("", "", tool, surface)
        }
    }

    /// Returns the head of a round's telemetry, with this scene in it.
    pub fn head(&self, joints: Vec<String>) -> TelemetryHead {
        // Finite numbers and texts always serialise to JSON.
        let scene = serde_json::to_string(self).unwrap_or_default();
        TelemetryHead {
            joints,
            notes: [(SCENE_NOTE.to_owned(), scene)].into(),
        }
    }
}

/// The reason why the pose of a frame cannot be computed.
#[derive(Debug, thiserror::Error)]
pub enum FrameError {
    /// The frame does not exist.
    #[error("there is no frame {name:?}; the nearest is {nearest:?}")]
    Unknown {
        /// The requested name.
        name: String,
        /// The most similar name.
        nearest: String,
    },
    /// The telemetry has no scene, or an unreadable one.
    #[error("{}: scene: {what}", path.display())]
    Scene {
        /// Path of the file.
        path: PathBuf,
        /// Description of the fault.
        what: String,
    },
    /// The telemetry belongs to another robot.
    #[error("{}: joint {index} is {found:?}, but the robot's is {expected:?}", path.display())]
    Joint {
        /// Path of the file.
        path: PathBuf,
        /// Index of the joint among the variables.
        index: usize,
        /// Name in the telemetry; empty if it has fewer joints.
        found: String,
        /// Name in the robot; empty if it has fewer joints.
        expected: String,
    },
    /// Nothing was recorded around this time.
    #[error("time: nothing was recorded within {limit} s of {time} s")]
    Gap {
        /// The time \[s\].
        time: f64,
        /// The longest time to the nearest sample \[s\].
        limit: f64,
    },
    /// The time is outside the telemetry.
    #[error("time: {time} s is not between {first} and {last} s")]
    Time {
        /// The time \[s\].
        time: f64,
        /// Time of the first sample \[s\].
        first: f64,
        /// Time of the last sample \[s\].
        last: f64,
    },
    /// The telemetry has no sample.
    #[error("{}: it holds no sample", path.display())]
    Empty {
        /// Path of the file.
        path: PathBuf,
    },
    /// A period or number gives no sample, or too many.
    #[error("{what}: {value} does not give 1 to {limit} samples")]
    Sampling {
        /// `dt` or `n`.
        what: &'static str,
        /// Its value.
        value: f64,
        /// Largest number of samples.
        limit: usize,
    },
    /// Error of the robot model.
    #[error(transparent)]
    Robot(#[from] RobotError),
    /// Error of the telemetry.
    #[error(transparent)]
    Telemetry(#[from] TelemetryError),
}

/// The times at which a trajectory is sampled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sampling {
    /// A sample per period \[s\], from the first time on.
    Every(f64),
    /// This number of samples, first and last time included.
    Count(usize),
}

/// The pose of a frame at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PoseAt {
    /// Time since the round began \[s\].
    pub time: f64,
    /// Pose of the frame in the world.
    pub world_from_frame: Pose,
}

/// The body to which a frame is attached.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Carrier {
    World,
    Link(LinkId),
    /// The tool, with its logged poses.
    Logged,
}

/// The moving frames of one round, from its telemetry.
///
/// Frames are the robot's links by name, `tool` and `tcp` (the tool centre point) or the tool's name, `robot` and
/// `base` or the robot's name (the link that moves over the floor, else the root), `surface` or the
/// surface's name, and `world`.
#[derive(Debug)]
pub struct Frames<'a> {
    /// Robot with recorded joints; `None` for a log of poses.
    robot: Option<JointFrames<'a>>,
    telemetry: &'a Telemetry,
    scene: RoundScene,
}

/// The robot of a round.
#[derive(Debug)]
struct JointFrames<'a> {
    model: &'a RobotModel,
    tip: LinkId,
    base: LinkId,
    columns: Vec<String>,
}

impl JointFrames<'_> {
    fn positions(&self, telemetry: &Telemetry, row: usize) -> Result<Vec<f64>, TelemetryError> {
        let columns: Vec<&str> = self.columns.iter().map(String::as_str).collect();
        telemetry.row(&columns, row)
    }
}

impl<'a> Frames<'a> {
    /// Returns the frames of a round of this robot.
    ///
    /// # Errors
    /// If the telemetry belongs to another robot, or has no scene.
    pub fn new(robot: &'a RobotModel, telemetry: &'a Telemetry) -> Result<Self, FrameError> {
        let path = || telemetry.path().to_path_buf();
        let scene = scene_of(telemetry)?.ok_or_else(|| FrameError::Scene {
            path: path(),
            what: "it is missing".to_owned(),
        })?;
        let joints = telemetry.joints();
        for index in 0..joints.len().max(robot.dof()) {
            let found = joints.get(index).map_or("", String::as_str);
            let expected = if index < robot.dof() {
                robot.variable(index).name.as_str()
            } else {
                ""
            };
            if found != expected {
                return Err(FrameError::Joint {
                    path: path(),
                    index,
                    found: found.to_owned(),
                    expected: expected.to_owned(),
                });
            }
        }
        let robot = JointFrames {
            tip: robot.link(&scene.tip)?,
            base: match &scene.base {
                Some(base) => robot.link(base)?,
                // The first of the links; every robot has at least one.
                None => robot.link(&robot.links()[0].name)?,
            },
            columns: joints
                .iter()
                .map(|joint| format!("position/{joint}"))
                .collect(),
            model: robot,
        };
        Ok(Self {
            robot: Some(robot),
            telemetry,
            scene,
        })
    }

    /// Returns the frames of a log with the tool's poses: `tool`, `tcp` or the tool's name, `surface` or the surface's
    /// name, and `world`. Older episodes do not hold the surface's pose; their tool has the name `tool`.
    ///
    /// # Errors
    /// If the telemetry lacks poses of the tool, or its scene cannot be read.
    pub fn from_log(telemetry: &'a Telemetry, tool: &str) -> Result<Self, FrameError> {
        let columns = telemetry.columns();
        if let Some(missing) = LOG_COLUMNS[..POSE_COLUMNS]
            .iter()
            .find(|name| !columns.contains(name))
        {
            return Err(FrameError::Scene {
                path: telemetry.path().to_path_buf(),
                what: format!(
                    "the episode has no robot.urdf, and its telemetry has no column {missing}, so no pose can be computed"
                ),
            });
        }
        let scene = scene_of(telemetry)?;
        Ok(Self {
            robot: None,
            telemetry,
            scene: scene
                .unwrap_or_else(|| RoundScene::from_log(tool, NO_SURFACE, &Pose::identity())),
        })
    }

    /// The robot; `None` for a log of poses.
    pub fn robot(&self) -> Option<&'a RobotModel> {
        self.robot.as_ref().map(|robot| robot.model)
    }

    /// Poses that joints do not determine.
    pub const fn scene(&self) -> &RoundScene {
        &self.scene
    }

    /// Returns the names of all frames.
    pub fn names(&self) -> Vec<&str> {
        let mut names: Vec<&str> = OWN_FRAMES.to_vec();
        let scene = &self.scene;
        names.push(&scene.tool);
        match scene.surface.as_str() {
            NO_SURFACE => names.retain(|name| *name != "surface"),
            surface => names.push(surface),
        }
        match &self.robot {
            Some(robot) => {
                names.push(&scene.robot);
                names.extend(robot.model.links().iter().map(|link| link.name.as_str()));
            }
            None => names.retain(|name| !["robot", "base"].contains(name)),
        }
        names
    }

    /// Returns the pose of a frame in the world at the sample nearest to a time [s since the round began].
    ///
    /// # Errors
    /// If the frame does not exist, the time is outside the telemetry, or the file is damaged.
    pub fn pose(&self, frame: &str, time: f64) -> Result<PoseAt, FrameError> {
        let (carrier, offset) = self.carrier(frame)?;
        let row = self.row_at(time)?;
        let limit = self.longest_gap(row)?;
        if (self.telemetry.time(row)? - time).abs() > limit {
            return Err(FrameError::Gap { time, limit });
        }
        self.pose_at(carrier, &offset, row)
    }

    /// Returns the longest time \[s\] for which a row represents the pose: half a second, or twice the least period of the
    /// rows around it, because logs may have a sample period of more than half a second. A gap beside the row is no period.
    fn longest_gap(&self, row: usize) -> Result<f64, FrameError> {
        let around = row.saturating_sub(2)..(row + 3).min(self.telemetry.rows());
        let times = self.telemetry.times(around)?;
        let periods = times.windows(2).map(|pair| pair[1] - pair[0]);
        let period = periods.min_by(f64::total_cmp).unwrap_or(0.0);
        Ok(LONGEST_GAP.max(2.0 * period))
    }

    /// Returns the poses of a frame in the world at several times of an interval \[s\], each from the nearest sample.
    ///
    /// # Errors
    /// If the frame does not exist, a time is outside the telemetry, the sampling is invalid, or the file is damaged.
    pub fn trajectory(
        &self,
        frame: &str,
        [from, to]: [f64; 2],
        sampling: Sampling,
    ) -> Result<Vec<PoseAt>, FrameError> {
        let (carrier, offset) = self.carrier(frame)?;
        let times = times_between(from, to, sampling)?;
        let mut poses: Vec<PoseAt> = Vec::with_capacity(times.len());
        let mut last = None;
        for time in times {
            let row = self.row_at(time)?;
            // Repeated rows are dropped where the sampling is finer than the telemetry, and gaps in the recording are
            // left out.
            let distance = (self.telemetry.time(row)? - time).abs();
            let is_recorded = distance <= LONGEST_GAP || distance <= self.longest_gap(row)?;
            if is_recorded && last.replace(row) != Some(row) {
                poses.push(self.pose_at(carrier, &offset, row)?);
            }
        }
        Ok(poses)
    }

    fn pose_at(&self, carrier: Carrier, offset: &Pose, row: usize) -> Result<PoseAt, FrameError> {
        let time = self.telemetry.time(row)?;
        let world_from_frame = match (carrier, &self.robot) {
            (Carrier::World, _) => *offset,
            (Carrier::Link(link), Some(robot)) => {
                let positions = robot.positions(self.telemetry, row)?;
                let kinematics = robot.model.forward_kinematics(&positions)?;
                Pose::from(self.scene.world_from_root) * kinematics.world_from_link(link) * offset
            }
            // Links have frames only where there is a robot.
            (Carrier::Logged | Carrier::Link(_), _) => {
                let numbers = self.telemetry.row(&LOG_COLUMNS[..POSE_COLUMNS], row)?;
                restore_pose(&<[f64; 7]>::try_from(numbers).unwrap_or([f64::NAN; 7]))
            }
        };
        Ok(PoseAt {
            time,
            world_from_frame,
        })
    }

    fn row_at(&self, time: f64) -> Result<usize, FrameError> {
        let Some([first, last]) = self.telemetry.interval() else {
            return Err(FrameError::Empty {
                path: self.telemetry.path().to_path_buf(),
            });
        };
        // An interval may exceed the telemetry by one period, because events end between samples.
        let slack = (last - first) / self.telemetry.rows() as f64;
        if !(first - slack..=last + slack).contains(&time) {
            return Err(FrameError::Time { time, first, last });
        }
        Ok(self.telemetry.nearest_row(time)?.unwrap_or(0))
    }

    /// Returns the body to which a frame is attached, and the frame's pose on it.
    fn carrier(&self, frame: &str) -> Result<(Carrier, Pose), FrameError> {
        let scene = &self.scene;
        let at = |link| Ok((Carrier::Link(link), Pose::identity()));
        if let Some(robot) = &self.robot
            && let Ok(link) = robot.model.link(frame)
            && !OWN_FRAMES.contains(&frame)
        {
            return at(link);
        }
        match (frame, &self.robot) {
            ("world", _) => Ok((Carrier::World, Pose::identity())),
            ("tool" | "tcp", Some(robot)) => {
                Ok((Carrier::Link(robot.tip), scene.tip_from_tool.into()))
            }
            ("tool" | "tcp", None) => Ok((Carrier::Logged, Pose::identity())),
            ("surface", _) if scene.surface != NO_SURFACE => {
                Ok((Carrier::World, scene.world_from_surface.into()))
            }
            ("robot" | "base", Some(robot)) => at(robot.base),
            (name, _) if name == scene.tool => self.carrier("tcp"),
            (name, _) if name == scene.surface => self.carrier("surface"),
            (name, Some(_)) if name == scene.robot => self.carrier("robot"),
            (name, _) if scene.surface == NO_SURFACE => Err(FrameError::Scene {
                path: self.telemetry.path().to_path_buf(),
                what: format!("the episode does not hold the pose of {name}; import its log again"),
            }),
            (name, _) => Err(self.unknown(name)),
        }
    }

    fn unknown(&self, name: &str) -> FrameError {
        let by_name: BTreeMap<&str, f64> = (self.names().into_iter())
            .map(|known| (known, strsim::jaro_winkler(name, known)))
            .collect();
        let nearest = by_name.iter().max_by(|a, b| a.1.total_cmp(b.1));
        FrameError::Unknown {
            name: name.to_owned(),
            nearest: nearest.map_or_else(String::new, |(known, _)| (*known).to_owned()),
        }
    }
}

/// Returns the scene in a round's telemetry, if there is one.
pub(crate) fn scene_of(telemetry: &Telemetry) -> Result<Option<RoundScene>, FrameError> {
    let Some(note) = telemetry.notes().get(SCENE_NOTE) else {
        return Ok(None);
    };
    let path = || telemetry.path().to_path_buf();
    let scene: RoundScene = serde_json::from_str(note).map_err(|error| FrameError::Scene {
        path: path(),
        what: error.to_string(),
    })?;
    if scene.schema != SCENE_SCHEMA {
        return Err(FrameError::Scene {
            path: path(),
            what: format!(
                "schema {} is not supported; this program reads {SCENE_SCHEMA}",
                scene.schema
            ),
        });
    }
    Ok(Some(scene))
}

fn times_between(from: f64, to: f64, sampling: Sampling) -> Result<Vec<f64>, FrameError> {
    let length = to - from;
    let refused = |what, value| FrameError::Sampling {
        what,
        value,
        limit: MAX_SAMPLES,
    };
    match sampling {
        Sampling::Every(period) => {
            // Slightly above the quotient, because for example 1.5 / 0.5 may be just below 3.
            let steps = (length / period * (1.0 + 1e-12)).floor();
            if period.is_nan() || period <= 0.0 || !(0.0..MAX_SAMPLES as f64).contains(&steps) {
                return Err(refused("dt", period));
            }
            Ok((0..=steps as usize)
                .map(|k| (from + k as f64 * period).min(to))
                .collect())
        }
        Sampling::Count(count) if count == 0 || count > MAX_SAMPLES || length < 0.0 => {
            Err(refused("n", count as f64))
        }
        Sampling::Count(1) => Ok(vec![from]),
        Sampling::Count(count) => {
            let last = (count - 1) as f64;
            Ok((0..count)
                .map(|k| from + length * k as f64 / last)
                .collect())
        }
    }
}
