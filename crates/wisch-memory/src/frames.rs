//! Frames on demand: joints are stored, and where links, tool and surface were follows from them.

use crate::telemetry::{Telemetry, TelemetryError, TelemetryHead};
use nalgebra::{Quaternion, Translation3, UnitQuaternion};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::PathBuf;
use wisch::geometry::Pose;
use wisch::robot::{LinkId, RobotError, RobotModel};
use wisch::run::PlannedRound;

/// Version of [`RoundScene`].
pub const SCENE_SCHEMA: u32 = 1;
/// The telemetry's note that holds the scene.
const SCENE_NOTE: &str = "scene";
/// Frames that every episode has besides the robot's links.
const OWN_FRAMES: [&str; 6] = ["tool", "tcp", "robot", "base", "surface", "world"];
/// Columns of the logged pose of the tool: position [m], then quaternion.
const LOGGED_POSE: [&str; 7] = [
    "measured/x",
    "measured/y",
    "measured/z",
    "measured/qx",
    "measured/qy",
    "measured/qz",
    "measured/qw",
];
/// What the surface is called where nothing says where it was.
const NO_SURFACE: &str = "";
/// Longest time between a pose that is asked for and the sample that stands for it [s].
const LONGEST_GAP: f64 = 0.5;
/// Most poses of one trajectory: an hour at 1 kHz.
const MAX_SAMPLES: usize = 4_000_000;

/// Where things were in a round that its joints do not tell.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RoundScene {
    /// [`SCENE_SCHEMA`].
    pub schema: u32,
    /// The robot's name.
    pub robot: String,
    /// Where its root link stood.
    pub world_from_root: StoredPose,
    /// The link that stands on the floor and moves over it; `None` where that is the root.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub base: Option<String>,
    /// The link that held the tool.
    pub tip: String,
    /// The tool in that link's frame.
    pub tip_from_tool: StoredPose,
    /// The tool's name.
    pub tool: String,
    /// The surface's name.
    pub surface: String,
    /// Where the surface was believed to be.
    pub world_from_surface: StoredPose,
}

/// A pose as it is stored.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct StoredPose {
    /// Position [m].
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
        let [x, y, z] = stored.position;
        let quaternion = Quaternion::from(stored.quaternion);
        Self::from_parts(
            Translation3::new(x, y, z),
            UnitQuaternion::from_quaternion(quaternion),
        )
    }
}

impl RoundScene {
    /// The scene of a round.
    pub fn of(motion: &PlannedRound) -> Self {
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

    /// A robot that stands at the world's origin, with the tool's frame that of its link, and the surface in the
    /// world's own frame: for what was not wiped, such as examples.
    pub fn upright(robot: &str, tip: &str, tool: &str, surface: &str) -> Self {
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

    /// The scene of a log that tells where the tool was, and nothing of the robot.
    pub fn of_log(tool: &str, surface: &str, world_from_surface: &Pose) -> Self {
        Self {
            world_from_surface: world_from_surface.into(),
            ..Self::upright("", "", tool, surface)
        }
    }

    /// The head of a round's telemetry, with this scene in it.
    pub fn head(&self, joints: Vec<String>) -> TelemetryHead {
        // Finite numbers and texts always have a form in JSON.
        let scene = serde_json::to_string(self).unwrap_or_default();
        TelemetryHead {
            joints,
            notes: [(SCENE_NOTE.to_owned(), scene)].into(),
        }
    }
}

/// Why there is no such pose.
#[derive(Debug, thiserror::Error)]
pub enum FrameError {
    /// No such frame.
    #[error("there is no frame {name:?}; the nearest is {nearest:?}")]
    Unknown {
        /// The name.
        name: String,
        /// The most similar one.
        nearest: String,
    },
    /// Telemetry without a scene, or with one that cannot be read.
    #[error("{}: scene: {what}", path.display())]
    Scene {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        what: String,
    },
    /// The telemetry is that of another robot.
    #[error("{}: joint {index} is {found:?}, but the robot's is {expected:?}", path.display())]
    Joint {
        /// The file.
        path: PathBuf,
        /// Place of the joint among the variables.
        index: usize,
        /// What the telemetry has; empty if it has no more.
        found: String,
        /// What the robot has; empty if it has no more.
        expected: String,
    },
    /// A time at which nothing was recorded.
    #[error("time: nothing was recorded within {limit} s of {time} s")]
    Gap {
        /// The time [s].
        time: f64,
        /// The longest time to the nearest sample [s].
        limit: f64,
    },
    /// A time outside the telemetry.
    #[error("time: {time} s is not between {first} and {last} s")]
    Time {
        /// The time [s].
        time: f64,
        /// The first sample's [s].
        first: f64,
        /// The last sample's [s].
        last: f64,
    },
    /// No sample at all.
    #[error("{}: there is no sample", path.display())]
    Empty {
        /// The file.
        path: PathBuf,
    },
    /// A period or number that gives no samples, or too many.
    #[error("{what}: {value} gives no 1 to {limit} samples")]
    Sampling {
        /// `dt` or `n`.
        what: &'static str,
        /// What it is.
        value: f64,
        /// Most samples.
        limit: usize,
    },
    /// What the robot says.
    #[error(transparent)]
    Robot(#[from] RobotError),
    /// What the telemetry says.
    #[error(transparent)]
    Telemetry(#[from] TelemetryError),
}

/// How often a trajectory is sampled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sampling {
    /// Every so many seconds, from the first time on.
    Every(f64),
    /// So many times, first and last included.
    Count(usize),
}

/// A pose at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PoseAt {
    /// Since the round began [s].
    pub time: f64,
    /// The frame in the world.
    pub world_from_frame: Pose,
}

/// What a frame hangs on.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Carrier {
    World,
    Link(LinkId),
    /// The tool, by its logged poses.
    Logged,
}

/// The frames of one round.
///
/// Frames are the robot's links by name, `tool` and `tcp` (the tool centre point) or the tool's name, `robot` and
/// `base` or the robot's name (the link that moves over the floor, else the root), `surface` or the
/// surface's name, and `world`.
#[derive(Debug)]
pub struct Frames<'a> {
    /// The robot whose joints were recorded; none of a log of poses.
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
    /// The frames of a round of this robot.
    ///
    /// # Errors
    /// Telemetry of another robot, or without a scene.
    pub fn new(robot: &'a RobotModel, telemetry: &'a Telemetry) -> Result<Self, FrameError> {
        let path = || telemetry.path().to_path_buf();
        let scene = scene_of(telemetry)?.ok_or_else(|| FrameError::Scene {
            path: path(),
            what: "there is none".to_owned(),
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
                // The first of the links, of which a robot has one at least.
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

    /// The frames of a log that holds poses of the tool: `tool`, `tcp` or the tool's name, `surface` or the surface's name,
    /// and `world`. Older episodes do not say where the surface was; their tool has the name `tool`.
    ///
    /// # Errors
    /// Telemetry without poses of the tool, or with a scene that cannot be read.
    pub fn of_log(telemetry: &'a Telemetry, tool: &str) -> Result<Self, FrameError> {
        let columns = telemetry.columns();
        if let Some(missing) = LOGGED_POSE.iter().find(|name| !columns.contains(name)) {
            return Err(FrameError::Scene {
                path: telemetry.path().to_path_buf(),
                what: format!(
                    "the episode has no robot.urdf, and its telemetry no column {missing}: where things were is not known"
                ),
            });
        }
        let scene = scene_of(telemetry)?;
        Ok(Self {
            robot: None,
            telemetry,
            scene: scene.unwrap_or_else(|| RoundScene::of_log(tool, NO_SURFACE, &Pose::identity())),
        })
    }

    /// The robot; `None` of a log of poses.
    pub fn robot(&self) -> Option<&'a RobotModel> {
        self.robot.as_ref().map(|robot| robot.model)
    }

    /// Where things were that the joints do not tell.
    pub const fn scene(&self) -> &RoundScene {
        &self.scene
    }

    /// The names of all frames.
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

    /// A frame in the world at the sample nearest to a time [s since the round began].
    ///
    /// # Errors
    /// No such frame, a time outside the telemetry, or a broken file.
    pub fn pose(&self, frame: &str, time: f64) -> Result<PoseAt, FrameError> {
        let (carrier, offset) = self.carrier(frame)?;
        let row = self.row_at(time)?;
        if (self.telemetry.time(row)? - time).abs() > self.longest_gap() {
            let limit = self.longest_gap();
            return Err(FrameError::Gap { time, limit });
        }
        self.pose_at(carrier, &offset, row)
    }

    /// Logs may be sampled more coarsely than half a second.
    fn longest_gap(&self) -> f64 {
        let [first, last] = self.telemetry.interval().unwrap_or_default();
        let period = (last - first) / self.telemetry.rows().max(1) as f64;
        LONGEST_GAP.max(2.0 * period)
    }

    /// All links in the world at the sample nearest to a time [s since the round began], in the robot's order.
    ///
    /// # Errors
    /// A time outside the telemetry, or a broken file.
    pub fn links(&self, time: f64) -> Result<Vec<Pose>, FrameError> {
        let row = self.row_at(time)?;
        let Some(robot) = &self.robot else {
            return Ok(Vec::new());
        };
        let positions = robot.positions(self.telemetry, row)?;
        let kinematics = robot.model.forward_kinematics(&positions)?;
        let world_from_root = Pose::from(self.scene.world_from_root);
        let links = robot.model.links().iter().map(|link| {
            let link = robot.model.link(&link.name)?;
            Ok(world_from_root * kinematics.world_from_link(link))
        });
        links.collect()
    }

    /// A frame in the world at several times between two [s], each at the nearest sample.
    ///
    /// # Errors
    /// No such frame, a time outside the telemetry, a period or number that makes no sense, or a broken file.
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
        let gap = self.longest_gap();
        for time in times {
            let row = self.row_at(time)?;
            // Finer than the telemetry there is nothing to tell, and in a gap nothing was recorded.
            let is_recorded = (self.telemetry.time(row)? - time).abs() <= gap;
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
            // Links have frames where there is a robot only.
            (Carrier::Logged | Carrier::Link(_), _) => {
                let [x, y, z, qx, qy, qz, qw] =
                    <[f64; 7]>::try_from(self.telemetry.row(&LOGGED_POSE, row)?)
                        .unwrap_or([f64::NAN; 7]);
                Pose::from(StoredPose {
                    position: [x, y, z],
                    quaternion: [qx, qy, qz, qw],
                })
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
        // A period beyond the ends is forgiven: intervals of events end between samples.
        let slack = (last - first) / self.telemetry.rows() as f64;
        if !(first - slack..=last + slack).contains(&time) {
            return Err(FrameError::Time { time, first, last });
        }
        Ok(self.telemetry.nearest_row(time)?.unwrap_or(0))
    }

    /// What a frame hangs on, and where on it.
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
                what: format!("the episode does not say where {name} was: import its log again"),
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

/// The scene that a round's telemetry holds, if it holds one.
fn scene_of(telemetry: &Telemetry) -> Result<Option<RoundScene>, FrameError> {
    let Some(said) = telemetry.notes().get(SCENE_NOTE) else {
        return Ok(None);
    };
    let path = || telemetry.path().to_path_buf();
    let scene: RoundScene = serde_json::from_str(said).map_err(|error| FrameError::Scene {
        path: path(),
        what: error.to_string(),
    })?;
    if scene.schema != SCENE_SCHEMA {
        return Err(FrameError::Scene {
            path: path(),
            what: format!(
                "schema {} is not supported, this program reads {SCENE_SCHEMA}",
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
            // A hair more than whole, as 1.5 / 0.5 may come out below 3.
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
