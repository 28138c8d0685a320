//! Writer of telemetry as a ROS 2 bag: MCAP with CDR messages, written as the samples arrive.

use super::links::{BagRobot, LinkFrames};
use super::observation::{ObservationTime, point_cloud, polygon_stamped};
use super::scene::{self, BagScene};
use super::status::{to_message, to_text};
use super::topic::{FRAME_SURFACE, FRAME_TOOL, FRAME_WORLD, NOTES, Topic};
use crate::error::WriteError;
use crate::ros2::full_definition;
use crate::ros2::messages::{
    Color, Header, JointState, MARKER_DELETE, Marker, MarkerArray, MarkerKind,
    NANOSECONDS_PER_SECOND, PoseStamped, Text, TfMessage, Time, TransformStamped, Vector3,
    WrenchStamped,
};
use cdr::{CdrLe, Infinite};
use mcap::records::MessageHeader;
use mcap::write::NoSeek;
use mcap::{Compression, WriteOptions, Writer};
use serde::Serialize;
use std::collections::BTreeMap;
use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};
use wisch::follow::Phase;
use wisch::geometry::{Point3, Pose};
use wisch::plan::Stroke;
use wisch::represent::{Observation, SurfaceShape};
use wisch::run::{SampleStatus, TelemetrySample};

/// Longest time that a killed program loses [ns]: a chunk is written when it covers this time.
const CHUNK_TIME: u64 = NANOSECONDS_PER_SECOND;
/// Length from which a chunk is written before that time [bytes].
const CHUNK_LEN: u64 = 1 << 20;
/// Least time between two messages of `/tf` [ns]: 50 Hz, enough for displays.
const TF_PERIOD: u64 = NANOSECONDS_PER_SECOND / 50;
/// Least time between two messages with the robot's links on `/tf`, and of `/force` [ns]: 25 Hz.
const SHOW_PERIOD: u64 = NANOSECONDS_PER_SECOND / 25;
/// Time after which the status of samples is stated again [ns].
const STATUS_PERIOD: u64 = NANOSECONDS_PER_SECOND;
/// Least time between two messages of `/particles` [ns].
const PARTICLES_PERIOD: u64 = NANOSECONDS_PER_SECOND / 2;
/// Side of a drawn particle [m].
const PARTICLE_SIZE: f64 = 0.004;
/// Brown, like crumbs.
const PARTICLE_COLOR: Color = Color {
    r: 0.55,
    g: 0.35,
    b: 0.15,
    a: 1.0,
};

/// Returns the path of a bag while it is being written.
pub fn active_path(bag: &Path) -> PathBuf {
    let mut name = bag.as_os_str().to_owned();
    name.push(".active");
    PathBuf::from(name)
}

/// The constant data of a bag, which its writer needs first.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BagHead {
    /// Names of the robot's variables, in the order of the samples' arrays.
    pub joints: Vec<String>,
    /// Believed pose of the target surface.
    pub world_from_surface: Pose,
    /// The log's time at which a sample's time is 0 \[ns\]; may be 0.
    pub start: u64,
    /// Further notes, for example the task's name and the seed.
    pub notes: BTreeMap<String, String>,
}

impl BagHead {
    /// Head of a log without joints, with the surface believed at this pose.
    pub fn from_surface_pose(world_from_surface: Pose) -> Self {
        Self {
            world_from_surface,
            ..Self::default()
        }
    }
}

/// Writer of telemetry during an execution.
///
/// Until [`finish`](Self::finish), the file name has the additional ending `.active`. If the program is killed, the
/// file is readable up to its last second; if the writer is dropped, the file is complete. In both cases it keeps that
/// ending. All times come from the samples, so the same samples give the same bytes.
///
/// | topic | type | how often |
/// |---|---|---|
/// | `/joint_states` | `sensor_msgs/JointState` | every sample |
/// | `/tcp/commanded`, `/tcp/measured` | `geometry_msgs/PoseStamped`, in the world | every sample |
/// | `/wrench/controller`, `/wrench/external` | `geometry_msgs/WrenchStamped`, axes of the world, about the tool centre point | every sample |
/// | `/tf` | `tf2_msgs/TFMessage`: world to tool, world to surface | at most 50 Hz |
/// | `/tf`, with a robot | `tf2_msgs/TFMessage`: its moving joints, link to link | at most 25 Hz |
/// | `/tf_static` | `tf2_msgs/TFMessage`: world to the robot's root, and its fixed joints, link to link | once, with a robot |
/// | `/robot_description` | `std_msgs/String`: its URDF | once, with a robot |
/// | `/particles` | `visualization_msgs/Marker`, points in the world | at most 2 Hz |
/// | `/phase` | `std_msgs/String` | when it changes |
/// | `/scene` | `visualization_msgs/MarkerArray`: surface and outline, goal area, objects around the surface | once, if given |
/// | `/plan/strokes` | `visualization_msgs/MarkerArray`: a line for each, in the frame of the surface | once, if given |
/// | `/tool` | `visualization_msgs/Marker`: triangles in the frame of the tool | once, if given |
/// | `/force` | `visualization_msgs/Marker`: an arrow from the tool centre point, 1 cm/N, in the world | at most 25 Hz while it is 1 N or more |
/// | `/wisch/sample_status` | `std_msgs/String`: quality of the external wrench from this sample on, and whether the motion is paused | when it changes |
/// | `/wisch/stamp` | `sensor_msgs/TimeReference`: absolute time of a sample, on the clock of the driver that the source names | every sample, if stated |
/// | `/wisch/dirt_before`, `/wisch/dirt_after` | `sensor_msgs/PointCloud2`, in the frame of the believed surface; of a curved surface in its chart, unrolled | once each, with a camera |
/// | `/wisch/hidden_before`, `/wisch/hidden_after` | `geometry_msgs/PolygonStamped`, in that frame | one for each part of the surface that the camera could not see |
///
/// ```
/// use wisch::run::{SampleStatus, TelemetrySample, Wrench};
/// use wisch::follow::Phase;
/// use wisch::geometry::{Pose, Vector3};
/// use wisch_telemetry::{BagHead, BagWriter, LogOptions, read};
///
/// # let folder = tempfile::tempdir()?;
/// # let path = folder.path().join("wipe.mcap");
/// let head = BagHead {
///     joints: vec!["slide".into()],
///     world_from_surface: Pose::translation(0.6, 0.0, 0.75),
///     start: 0,
///     notes: [("task".into(), "board".into())].into(),
/// };
/// let mut bag = BagWriter::create(&path, head)?;
/// for index in 0..100 {
///     let time = f64::from(index) * 1e-3;
///     bag.write(&TelemetrySample {
///         time,
///         positions: &[0.1 * time],
///         velocities: &[0.1],
///         efforts: &[3.0],
///         world_from_commanded: Pose::translation(0.6 + 0.1 * time, 0.0, 0.74),
///         world_from_tool: Pose::translation(0.6 + 0.1 * time, 0.0, 0.75),
///         controller: Wrench::default(),
///         external: Wrench { force: Vector3::new(0.0, 0.0, 10.0), moment: Vector3::zeros() },
///         motion: 0,
///         phase: Phase::Wipe(0),
///         status: SampleStatus::default(),
///     })?;
/// }
/// bag.finish()?;
///
/// let log = read(&path, &LogOptions::default())?;
/// assert_eq!(log.samples.len(), 100);
/// assert_eq!(log.samples[0].force.z, 10.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct BagWriter {
    target: PathBuf,
    active: PathBuf,
    mcap: Writer<NoSeek<BufWriter<File>>>,
    head: BagHead,
    /// Channels of the topics; `None` before the first message of an optional one.
    channels: [Option<u16>; Topic::ALL.len()],
    sequences: [u32; Topic::ALL.len()],
    /// Time of the last sample, if any [ns].
    last: Option<u64>,
    /// Time at which the current chunk began [ns].
    chunk_start: u64,
    last_transforms: Option<u64>,
    last_particles: Option<u64>,
    links: LinkFrames,
    /// Shape of the surface in the scene.
    shape: SurfaceShape,
    last_shown: Option<u64>,
    last_status: Option<u64>,
    /// Whether the last message of `/force` draws an arrow.
    force_drawn: bool,
    phase: Option<Phase>,
    /// Status of the last sample, without its stamp.
    status: SampleStatus,
    /// Particles that wait until the next message is due.
    particles: Vec<Vector3>,
    particles_wait: bool,
    message: Vec<u8>,
}

impl BagWriter {
    /// Begins a bag that [`Self::finish`] moves to `path`.
    ///
    /// # Errors
    /// If the file cannot be created or written.
    pub fn create(path: &Path, head: BagHead) -> Result<Self, WriteError> {
        let active = active_path(path);
        let file = File::create(&active).map_err(|error| WriteError::File {
            path: active.clone(),
            error,
        })?;
        let failed = |error| WriteError::of_mcap(&active, error);
        // Without seeking, each chunk reaches the file as a whole or not at all, which keeps the file of a killed
        // program readable.
        let mut mcap = WriteOptions::new()
            .profile("ros2")
            .library(concat!("wisch/", env!("CARGO_PKG_VERSION")))
            .compression(Some(Compression::Lz4))
            .chunk_size(Some(CHUNK_LEN))
            .disable_seeking(true)
            .create(NoSeek::new(BufWriter::new(file)))
            .map_err(failed)?;
        mcap.write_metadata(&mcap::records::Metadata {
            name: NOTES.to_owned(),
            metadata: head.notes.clone(),
        })
        .map_err(failed)?;
        let mut channels = [None; Topic::ALL.len()];
        let topics = Topic::ALL.into_iter().zip(&mut channels);
        for (topic, channel) in topics.filter(|(topic, _)| !topic.is_optional()) {
            *channel = Some(add_channel(&mut mcap, topic, head.start).map_err(failed)?);
        }
        Ok(Self {
            target: path.to_path_buf(),
            chunk_start: head.start,
            active,
            mcap,
            head,
            channels,
            sequences: [0; Topic::ALL.len()],
            last: None,
            last_transforms: None,
            last_particles: None,
            links: LinkFrames::default(),
            shape: SurfaceShape::default(),
            last_shown: None,
            last_status: None,
            force_drawn: false,
            phase: None,
            status: SampleStatus::default(),
            particles: Vec::new(),
            particles_wait: false,
            message: Vec::new(),
        })
    }

    /// Path of the file while it is being written.
    pub fn active_path(&self) -> &Path {
        &self.active
    }

    /// Adds a sample to the bag's topics.
    ///
    /// # Errors
    /// If the time is not finite, is negative or is not later than the previous one, if an array does not have one
    /// value per joint, or if the file cannot be written.
    pub fn write(&mut self, sample: &TelemetrySample<'_>) -> Result<(), WriteError> {
        let time = self.check(sample)?;
        if time.saturating_sub(self.chunk_start) >= CHUNK_TIME {
            self.mcap.flush().map_err(|error| self.failed(error))?;
            self.chunk_start = time;
        }
        self.last = Some(time);
        self.write_status(time, sample.status)?;
        self.write_joints(time, sample)?;
        for (topic, pose) in [
            (Topic::Commanded, &sample.world_from_commanded),
            (Topic::Measured, &sample.world_from_tool),
        ] {
            let (header, pose) = (in_world(time), pose.into());
            self.put(topic, time, &PoseStamped { header, pose })?;
        }
        for (topic, wrench) in [
            (Topic::Controller, &sample.controller),
            (Topic::External, &sample.external),
        ] {
            let (header, wrench) = (in_world(time), wrench.into());
            self.put(topic, time, &WrenchStamped { header, wrench })?;
        }
        if is_due(self.last_transforms, time, TF_PERIOD) {
            self.last_transforms = Some(time);
            self.write_transforms(time, sample)?;
        }
        if is_due(self.last_shown, time, SHOW_PERIOD) {
            self.last_shown = Some(time);
            if !sample.positions.is_empty() {
                self.write_links(time, sample.positions)?;
            }
            self.write_force(time, sample)?;
        }
        if self.phase != Some(sample.phase) {
            self.phase = Some(sample.phase);
            self.write_phase(time, sample.phase)?;
        }
        if self.particles_wait && is_due(self.last_particles, time, PARTICLES_PERIOD) {
            self.write_waiting_particles(time)?;
        }
        Ok(())
    }

    /// Adds the particle positions in the world \[m\]. They are written at most twice a second; the last positions are
    /// always written.
    ///
    /// # Errors
    /// If the time is not finite or is negative, or if the file cannot be written.
    pub fn write_particles(&mut self, time: f64, particles: &[Point3]) -> Result<(), WriteError> {
        let time = self.nanoseconds(time)?;
        self.particles.clear();
        self.particles
            .extend(particles.iter().map(|p| Vector3::from(p.coords)));
        self.particles_wait = true;
        if is_due(self.last_particles, time, PARTICLES_PERIOD) {
            self.write_waiting_particles(time)?;
        }
        Ok(())
    }

    /// Adds the robot: its description, and from now on the poses of its links.
    ///
    /// A link's frame has the link's name, with the prefix `robot/` if the name is `world`, `tool` or `surface`. A root
    /// link called `world` at the world's origin is the frame `world` itself.
    ///
    /// # Errors
    /// If the number of the robot's variables differs from the number of joints in the bag, or if the file cannot be
    /// written.
    pub fn write_robot(&mut self, robot: &BagRobot<'_>) -> Result<(), WriteError> {
        let (variables, joints) = (robot.model.dof(), self.head.joints.len());
        if variables != joints {
            return Err(WriteError::Robot {
                name: robot.model.name().to_owned(),
                variables,
                joints,
            });
        }
        let time = self.now();
        self.put(Topic::Robot, time, &Text { data: robot.urdf })?;
        self.links = LinkFrames::new(robot);
        let standing = std::mem::take(&mut self.links.standing);
        let transforms: Vec<_> = (standing.iter())
            .map(|(parent, child, pose)| transform(time, parent, child, pose))
            .collect();
        let transforms = &transforms;
        self.put(Topic::StaticTransforms, time, &TfMessage { transforms })
    }

    /// Adds the surface, the objects around it, the tool and the goal.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write_scene(&mut self, scene: &BagScene<'_>) -> Result<(), WriteError> {
        self.shape = scene.surface.shape.clone();
        self.put_markers(Topic::Scene, &scene::scene(scene))?;
        let time = self.now();
        self.put(Topic::Tool, time, &scene::tool(scene.tool).marker(time))
    }

    /// Adds the planned strokes, in their order.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write_strokes(&mut self, strokes: &[Stroke]) -> Result<(), WriteError> {
        self.put_markers(Topic::Strokes, &scene::strokes(strokes, &self.shape))
    }

    /// Adds a camera observation of the dirt, in the frame of the believed surface: before the round, or after its last
    /// sample.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write_observation(
        &mut self,
        look: ObservationTime,
        observation: &Observation,
    ) -> Result<(), WriteError> {
        let (time, [dirt, hidden]) = match look {
            ObservationTime::Before => (self.head.start, [Topic::DirtBefore, Topic::HiddenBefore]),
            ObservationTime::After => (self.now(), [Topic::DirtAfter, Topic::HiddenAfter]),
        };
        self.put(dirt, time, &point_cloud(time, &observation.detections))?;
        for polygon in observation.hidden.polygons() {
            self.put(hidden, time, &polygon_stamped(time, polygon.outer()))?;
        }
        Ok(())
    }

    /// Finishes the bag and moves it to its path, replacing an older file.
    ///
    /// # Errors
    /// If the file cannot be written or moved; the bag then keeps the ending `.active`.
    pub fn finish(mut self) -> Result<(), WriteError> {
        if self.particles_wait {
            self.write_waiting_particles(self.now())?;
        }
        self.mcap.finish().map_err(|error| self.failed(error))?;
        std::fs::rename(&self.active, &self.target).map_err(|error| WriteError::File {
            path: self.target.clone(),
            error,
        })
    }

    fn check(&self, sample: &TelemetrySample<'_>) -> Result<u64, WriteError> {
        let joints = self.head.joints.len();
        for (what, values) in [
            ("positions", sample.positions),
            ("velocities", sample.velocities),
            ("efforts", sample.efforts),
        ] {
            // As in a JointState, an empty array is a quantity that is not measured.
            if values.len() != joints && !values.is_empty() {
                return Err(WriteError::Joints {
                    what,
                    count: values.len(),
                    joints,
                });
            }
        }
        let time = self.nanoseconds(sample.time)?;
        match self.last {
            Some(last) if time <= last => Err(WriteError::Backwards {
                time: sample.time,
                last: (last - self.head.start) as f64 / NANOSECONDS_PER_SECOND as f64,
            }),
            _ => Ok(time),
        }
    }

    /// Converts a sample's time [s] to the log's time [ns].
    fn nanoseconds(&self, time: f64) -> Result<u64, WriteError> {
        if !(time.is_finite() && (0.0..MAX_TIME).contains(&time)) {
            return Err(WriteError::Time {
                time,
                limit: MAX_TIME,
            });
        }
        Ok(self.head.start + (time * NANOSECONDS_PER_SECOND as f64).round() as u64)
    }

    /// Writes the driver's statements about a sample, if they differ from those about the last
    /// sample, and its stamp.
    fn write_status(&mut self, time: u64, status: SampleStatus) -> Result<(), WriteError> {
        if let Some(stamp) = status.stamp {
            self.put(Topic::Stamp, time, &to_message(time, stamp))?;
        }
        let status = SampleStatus {
            stamp: None,
            ..status
        };
        // The status is repeated, so that a part that is cut from the bag holds it as well.
        let is_repeated =
            self.last_status.is_some() && is_due(self.last_status, time, STATUS_PERIOD);
        if status == self.status && !is_repeated {
            return Ok(());
        }
        self.status = status;
        self.last_status = Some(time);
        let text = to_text(&status);
        self.put(Topic::Status, time, &Text { data: &text })
    }

    fn write_joints(&mut self, time: u64, sample: &TelemetrySample<'_>) -> Result<(), WriteError> {
        // The buffer borrows from `self`, and so do the names; take the names out while both are in use.
        let joints = std::mem::take(&mut self.head.joints);
        let header = Header {
            stamp: Time::from_nanoseconds(time),
            frame_id: "",
        };
        let written = self.put(
            Topic::Joints,
            time,
            &JointState {
                header,
                name: &joints,
                position: sample.positions,
                velocity: sample.velocities,
                effort: sample.efforts,
            },
        );
        self.head.joints = joints;
        written
    }

    fn write_transforms(
        &mut self,
        time: u64,
        sample: &TelemetrySample<'_>,
    ) -> Result<(), WriteError> {
        let transforms = &[
            transform(time, FRAME_WORLD, FRAME_TOOL, &sample.world_from_tool),
            transform(
                time,
                FRAME_WORLD,
                FRAME_SURFACE,
                &self.head.world_from_surface,
            ),
        ];
        self.put(Topic::Transforms, time, &TfMessage { transforms })
    }

    fn write_links(&mut self, time: u64, q: &[f64]) -> Result<(), WriteError> {
        // The buffer borrows from `self`, and so do the names; take the names out while both are in use.
        let links = std::mem::take(&mut self.links);
        let transforms: Vec<_> = (links.poses(q))
            .map(|(parent, child, pose)| transform(time, parent, child, &pose))
            .collect();
        let written = if transforms.is_empty() {
            Ok(())
        } else {
            let transforms = &transforms;
            self.put(Topic::Transforms, time, &TfMessage { transforms })
        };
        self.links = links;
        written
    }

    fn write_force(&mut self, time: u64, sample: &TelemetrySample<'_>) -> Result<(), WriteError> {
        let was_drawn = self.force_drawn;
        let force = scene::force(sample);
        self.force_drawn = force.is_some();
        match force {
            Some(force) => self.put(Topic::Force, time, &force.marker(time)),
            None if was_drawn => {
                let deletion = scene::no_force();
                let deletion = Marker {
                    action: MARKER_DELETE,
                    ..deletion.marker(time)
                };
                self.put(Topic::Force, time, &deletion)
            }
            None => Ok(()),
        }
    }

    fn put_markers(&mut self, topic: Topic, drawn: &[scene::Drawn]) -> Result<(), WriteError> {
        let time = self.now();
        let markers: Vec<_> = drawn.iter().map(|drawn| drawn.marker(time)).collect();
        self.put(topic, time, &MarkerArray { markers: &markers })
    }

    /// Time of the last sample, or of the first one before it arrives [ns].
    fn now(&self) -> u64 {
        self.last.unwrap_or(self.head.start)
    }

    fn write_phase(&mut self, time: u64, phase: Phase) -> Result<(), WriteError> {
        let wipe;
        let data = match phase {
            Phase::Drive => "drive",
            Phase::FreeMotion => "transfer",
            Phase::Lifted => "lifted",
            Phase::Lower => "lower",
            Phase::Wipe(stroke) => {
                wipe = format!("wipe {stroke}");
                &wipe
            }
            Phase::Lift => "lift",
        };
        self.put(Topic::Phase, time, &Text { data })
    }

    fn write_waiting_particles(&mut self, time: u64) -> Result<(), WriteError> {
        self.particles_wait = false;
        self.last_particles = Some(time);
        let points = std::mem::take(&mut self.particles);
        let size = PARTICLE_SIZE;
        let marker = Marker::new(
            (Time::from_nanoseconds(time), FRAME_WORLD),
            ("particles", 0),
            MarkerKind::Points,
            (
                Vector3 {
                    x: size,
                    y: size,
                    z: size,
                },
                PARTICLE_COLOR,
            ),
            &points,
        );
        let written = self.put(Topic::Particles, time, &marker);
        self.particles = points;
        written
    }

    fn put(&mut self, topic: Topic, time: u64, message: &impl Serialize) -> Result<(), WriteError> {
        self.message.clear();
        cdr::serialize_into::<_, _, _, CdrLe>(&mut self.message, message, Infinite).map_err(
            |error| WriteError::Message {
                topic: topic.names().0,
                error,
            },
        )?;
        let channel_id = match self.channels[topic as usize] {
            Some(channel) => channel,
            None => {
                let added = add_channel(&mut self.mcap, topic, self.head.start);
                let channel = added.map_err(|error| self.failed(error))?;
                *self.channels[topic as usize].insert(channel)
            }
        };
        let header = MessageHeader {
            channel_id,
            sequence: self.sequences[topic as usize],
            log_time: time,
            publish_time: time,
        };
        self.sequences[topic as usize] = header.sequence.wrapping_add(1);
        self.mcap
            .write_to_known_channel(&header, &self.message)
            .map_err(|error| self.failed(error))
    }

    fn failed(&self, error: mcap::McapError) -> WriteError {
        WriteError::of_mcap(&self.active, error)
    }
}

/// Adds a channel for the messages of a topic.
fn add_channel(
    mcap: &mut Writer<NoSeek<BufWriter<File>>>,
    topic: Topic,
    start: u64,
) -> Result<u16, mcap::McapError> {
    let (name, [package, kind]) = topic.names();
    let definition = full_definition(&format!("{package}/{kind}"));
    let kind = format!("{package}/msg/{kind}");
    let schema = mcap.add_schema(&kind, "ros2msg", definition.as_bytes())?;
    mcap.add_channel(schema, name, "cdr", &topic.metadata(start))
}

/// Largest time of a sample [s]: thirty years, well within the range of a message.
const MAX_TIME: f64 = 1e9;

fn in_world(time: u64) -> Header<'static> {
    Header {
        stamp: Time::from_nanoseconds(time),
        frame_id: FRAME_WORLD,
    }
}

fn transform<'a>(
    time: u64,
    parent: &'a str,
    child_frame_id: &'a str,
    pose: &Pose,
) -> TransformStamped<'a> {
    TransformStamped {
        header: Header {
            stamp: Time::from_nanoseconds(time),
            frame_id: parent,
        },
        child_frame_id,
        transform: pose.into(),
    }
}

fn is_due(last: Option<u64>, now: u64, period: u64) -> bool {
    last.is_none_or(|last| now >= last.saturating_add(period))
}
