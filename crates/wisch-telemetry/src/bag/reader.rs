//! Reader of ROS 2 bags: finds poses and forces in an MCAP file with any topics.

use super::clocks::Offset;
use super::container::{Ending, Entry, entries};
use super::joint_states::JointStates;
use super::locator::Locator;
use super::observation::{ObservationCollector, is_observation_topic};
use super::search::{Located, Search, alignment_remark};
use super::status::from_text;
use super::topic::{
    FORCE_NOTE, MESH_NOTE, NOTES, ROLE_POSE, ROLE_WRENCH, ROUND_NOTE, TASK_NOTE, Topic,
};
use super::unpack::{is_packed, unpack_message};
use crate::error::ReadFault;
use crate::frames::Frames;
use crate::options::{Clock, LogOptions, WrenchSign};
use crate::quantity::Quantity;
use crate::ros2::messages::RecordedText;
use crate::ros2::{Schema, Value, decode};
use crate::track::{JointPositions, RawLog, Track};
use mcap::Channel;
use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap};
use std::io::Read;
use std::path::Path;
use std::rc::Rc;
use wisch::geometry::{Pose, Vector3};
use wisch::interpret::WrenchQuality;

/// Collector of the contents of a bag's parts.
pub(crate) struct BagReader<'a> {
    options: &'a LogOptions,
    poses: Search<Pose>,
    wrenches: Search<Vector3>,
    /// Every topic with its type.
    topics: BTreeMap<String, String>,
    /// Topics that might hold the quantity but cannot be read, with the reason.
    unread: BTreeMap<String, String>,
    channels: HashMap<u16, Reading>,
    /// Number of the current file, from 1.
    part: usize,
    /// Transforms that hold for all times.
    fixed: Frames,
    /// Moving transforms, by topic.
    moving: BTreeMap<String, Moving>,
    joints: JointPositions,
    /// Offsets of the joint states' stamps ahead of the recorder [ns].
    joints_ahead: Vec<i64>,
    /// Name of the task, if the writer states it.
    task: Option<String>,
    surface_mesh: Option<String>,
    press_force_n: Option<f64>,
    /// Number of the round, if the writer states it.
    round: Option<usize>,
    looks: ObservationCollector,
    /// Times [ns] from which the wrench has a quality.
    qualities: Vec<(i64, WrenchQuality)>,
    /// Number of complete messages.
    messages: usize,
    /// Length of the file that ends in the middle of a record, if one does [bytes].
    cut_at: Option<u64>,
}

/// Transforms of a topic.
#[derive(Default)]
struct Moving {
    frames: Frames,
    /// Offsets of the stamps ahead of the recorder [ns].
    ahead: Vec<i64>,
}

/// Use of a channel's messages.
#[derive(Clone)]
enum Reading {
    /// None of the requested quantities.
    Nothing,
    Messages {
        schema: Rc<Schema>,
        poses: Rc<[Located<Pose>]>,
        wrenches: Rc<[Located<Vector3>]>,
        transforms: Option<Rc<Locator<Pose>>>,
        joints: Option<Rc<JointStates>>,
    },
}

/// Type of messages that hold transforms between frames.
const TRANSFORMS: &str = "TFMessage";
/// Ending of topics whose transforms hold for all times.
const STATIC_TOPIC: &str = "tf_static";
/// Fields of libfranka's state with the forces of the tool on its surroundings, not those on the tool.
const FORCES_BY_TOOL: [&str; 2] = ["o_f_ext_hat_k", "k_f_ext_hat_k"];

impl<'a> BagReader<'a> {
    /// Creates a reader that searches for a pose, a wrench, and joint positions.
    pub fn new(options: &'a LogOptions) -> Self {
        Self {
            options,
            poses: Search::new(&options.pose_topic, ROLE_POSE),
            wrenches: Search::new(&options.wrench_topic, ROLE_WRENCH),
            topics: BTreeMap::new(),
            unread: BTreeMap::new(),
            channels: HashMap::new(),
            part: 0,
            fixed: Frames::default(),
            moving: BTreeMap::new(),
            joints: JointPositions::new(&options.joints),
            joints_ahead: Vec::new(),
            task: None,
            surface_mesh: None,
            press_force_n: None,
            round: None,
            looks: ObservationCollector::default(),
            qualities: Vec::new(),
            messages: 0,
            cut_at: None,
        }
    }

    /// Reads a file from a source. Only a file that is still being written may end in the middle of a record.
    pub fn read(&mut self, path: &Path, source: impl Read) -> Result<(), ReadFault> {
        // Each file numbers its channels anew.
        self.channels.clear();
        self.part += 1;
        let ending = entries(source, &mut |entry| match entry {
            Entry::Message(channel, log_time, data) => {
                self.messages += 1;
                self.message(channel, log_time, data)
            }
            Entry::Notes(NOTES, notes) => {
                self.task = notes.get(TASK_NOTE).cloned();
                self.surface_mesh = notes.get(MESH_NOTE).cloned();
                self.press_force_n = notes.get(FORCE_NOTE).and_then(|force| force.parse().ok());
                self.round = notes.get(ROUND_NOTE).and_then(|round| round.parse().ok());
                Ok(())
            }
            Entry::Notes(..) => Ok(()),
        })?;
        let is_active = path.extension().is_some_and(|ending| ending == "active");
        match ending {
            Ending::Footer => {}
            Ending::CutOff { byte } if is_active => self.cut_at = Some(byte),
            Ending::CutOff { byte } if self.messages == 0 => {
                return Err(without_messages(Some(byte)));
            }
            Ending::CutOff { byte } => return Err(ReadFault::Truncated { byte }),
        }
        Ok(())
    }

    /// Returns the contents of all files.
    pub fn finish(mut self) -> Result<RawLog, ReadFault> {
        if self.messages == 0 {
            return Err(without_messages(self.cut_at));
        }
        let options = self.options;
        let (clock, window) = (options.clock, options.reorder_window);
        let mut remarks = Vec::new();
        let cut = self.cut_at.map(|byte| (byte, self.messages));
        let frame = self.named_frame();
        let pose = match frame {
            Some(_) => None,
            None => self.poses.choose(&self.topics)?,
        };
        // All clocks are shifted to that of the poses.
        let ahead = |ahead: &[i64]| Offset::from_lags(ahead.to_vec()).unwrap_or(Offset::NONE);
        let reference = match (
            &pose,
            self.moving.values().find(|moving| !moving.ahead.is_empty()),
        ) {
            (Some(pose), _) => pose.offset(clock),
            (None, Some(moving)) => ahead(&moving.ahead),
            (None, None) => ahead(&self.joints_ahead),
        };
        let mut frames = self.fixed;
        for (topic, moving) in self.moving {
            let shift = ahead(&moving.ahead).shift_onto(reference);
            remarks.extend(shift.map(|shift| alignment_remark(&topic, shift)));
            frames.absorb(moving.frames, shift.unwrap_or(0));
        }
        if self.joints.are_known() {
            let shift = ahead(&self.joints_ahead).shift_onto(reference);
            remarks.extend(shift.map(|shift| alignment_remark("the joints' positions", shift)));
            self.joints.shift(shift.unwrap_or(0));
        }
        self.joints.add_to(&mut frames, &options.joints);
        frames.sort();
        let says = pose
            .as_ref()
            .map(|pose| pose.says.clone())
            .unwrap_or_default();
        let poses = match pose {
            Some(pose) => pose.into_track(clock, 0, window, &mut remarks)?,
            None => {
                let topic = self.poses.named.as_ref().map(|(topic, _)| topic.as_str());
                let kinds = self
                    .topics
                    .iter()
                    .find(|(_, kind)| kind.ends_with(TRANSFORMS));
                let topic = topic.or(kinds.map(|(topic, _)| topic.as_str()));
                let topic = topic.unwrap_or("/joint_states");
                match frames.tool_track(frame.as_deref(), topic, options, &mut remarks)? {
                    Some(track) => track,
                    None => return Err(nothing::<Pose>(&self.topics, &self.unread, cut)),
                }
            }
        };
        let Some(wrench) = self.wrenches.choose(&self.topics)? else {
            return Err(nothing::<Vector3>(&self.topics, &self.unread, cut));
        };
        let shift = wrench.offset(clock).shift_onto(reference).unwrap_or(0);
        let axes = wrench.says.axes.clone();
        let is_by_tool = FORCES_BY_TOOL.contains(&wrench.field.as_str());
        if is_by_tool {
            let field = &wrench.field;
            remarks.push(format!(
                "forces of libfranka ({field}) are read as those of the tool on its surroundings; --wrench-sign overrides this"
            ));
        }
        let wrenches: Track<Vector3> = wrench.into_track(clock, shift, window, &mut remarks)?;
        let mut qualities = self.qualities;
        qualities.sort_by_key(|(time, _)| *time);
        Ok(RawLog {
            poses,
            wrenches,
            axes,
            sign: is_by_tool.then_some(WrenchSign::ByTool),
            start: says.start,
            unfinished: self.cut_at.is_some(),
            frames,
            joints: self.joints,
            task: self.task,
            surface_mesh: self.surface_mesh,
            press_force_n: self.press_force_n,
            round: self.round,
            looks: self.looks.finish(),
            qualities,
            assumed_units: None,
            remarks,
        })
    }

    /// Returns the frame that the options name, alone or in a topic of transforms.
    fn named_frame(&self) -> Option<String> {
        match &self.poses.named {
            Some((topic, field)) => {
                let kind = self.topics.get(topic)?;
                // Without a field, the only moving frame is meant.
                kind.ends_with(TRANSFORMS).then(|| field.clone())
            }
            None => None,
        }
    }

    fn message(
        &mut self,
        channel: &Channel<'_>,
        log_time: u64,
        data: &[u8],
    ) -> Result<(), ReadFault> {
        let data = if is_packed(data) {
            Cow::Owned(unpack_message(&channel.topic, data)?)
        } else {
            Cow::Borrowed(data)
        };
        let data = &*data;
        if is_observation_topic(&channel.topic) {
            return self.looks.take(channel, data);
        }
        if channel.topic == Topic::Status.names().0 {
            return self.take_quality(channel, log_time, data);
        }
        if !self.channels.contains_key(&channel.id) {
            let reading = self.channel(channel)?;
            self.channels.insert(channel.id, reading);
        }
        let Some(Reading::Messages {
            schema,
            poses,
            wrenches,
            transforms,
            joints,
        }) = self.channels.get(&channel.id).cloned()
        else {
            return Ok(());
        };
        let value = decode(&schema, data);
        let log_time = i64::try_from(log_time).unwrap_or(i64::MAX);
        let part = self.part;
        self.poses.take(channel, &poses, &value, log_time, part);
        self.wrenches
            .take(channel, &wrenches, &value, log_time, part);
        if let Some(locator) = transforms {
            match &value {
                Ok(message) => self.transforms(channel, &locator, message, log_time),
                Err(error) => {
                    let entry = self.unread.entry(channel.topic.clone());
                    entry.or_insert_with(|| error.to_string());
                }
            }
        }
        if let (Some(places), Ok(message)) = (joints, &value) {
            let is_recorded = self.options.clock == Clock::Log;
            let stamp = Some(places.stamp(message)).filter(|stamp| *stamp != 0 && !is_recorded);
            if let Some(stamp) = stamp {
                self.joints_ahead.push(stamp.saturating_sub(log_time));
            }
            places.read(message, stamp.unwrap_or(log_time), &mut self.joints);
        }
        Ok(())
    }

    /// Notes the quality that the wrench has from a time on [ns].
    fn take_quality(
        &mut self,
        channel: &Channel<'_>,
        log_time: u64,
        data: &[u8],
    ) -> Result<(), ReadFault> {
        let text = cdr::deserialize::<RecordedText>(data).map_err(|error| error.to_string());
        let status = text.and_then(|text| from_text(&text.data));
        let status = status.map_err(|problem| ReadFault::Sample {
            topic: channel.topic.clone(),
            problem,
        })?;
        let time = i64::try_from(log_time).unwrap_or(i64::MAX);
        self.qualities.push((time, status.wrench));
        Ok(())
    }

    /// Adds the transforms of a message.
    fn transforms(
        &mut self,
        channel: &Channel<'_>,
        locator: &Locator<Pose>,
        message: &Value,
        log_time: i64,
    ) {
        let is_static = channel.topic.ends_with(STATIC_TOPIC);
        let is_recorded = self.options.clock == Clock::Log;
        for found in locator.read(message) {
            let stamp = Some(found.stamp).filter(|stamp| *stamp != 0 && !is_recorded);
            let time = stamp.unwrap_or(log_time);
            let Ok(pose) = found.value else {
                continue;
            };
            let (frame, child) = (found.frame, found.child);
            if is_static {
                self.fixed.insert(frame, child, time, pose, true);
                continue;
            }
            if !self.moving.contains_key(&channel.topic) {
                self.moving.insert(channel.topic.clone(), Moving::default());
            }
            if let Some(moving) = self.moving.get_mut(&channel.topic) {
                moving
                    .ahead
                    .extend(stamp.map(|stamp| stamp.saturating_sub(log_time)));
                moving.frames.insert(frame, child, time, pose, false);
            }
        }
    }

    /// Decides the use of a new channel.
    fn channel(&mut self, channel: &Channel<'_>) -> Result<Reading, ReadFault> {
        let kind = (channel.schema.as_ref()).map_or_else(String::new, |schema| schema.name.clone());
        let holds_transforms = kind.ends_with(TRANSFORMS);
        self.topics.insert(channel.topic.clone(), kind);
        let holds_joints = !self.joints.is_empty() && JointStates::are_in(channel);
        if !(holds_transforms
            || holds_joints
            || self.poses.wants(channel)
            || self.wrenches.wants(channel))
        {
            return Ok(Reading::Nothing);
        }
        let schema = match readable(channel) {
            Ok(schema) => Rc::new(schema),
            Err(fault) if self.poses.names(channel) || self.wrenches.names(channel) => {
                return Err(fault);
            }
            // Bags hold many topics, and the fault matters only if this one is chosen.
            Err(fault) => {
                self.unread.insert(channel.topic.clone(), fault.to_string());
                return Ok(Reading::Nothing);
            }
        };
        let transforms = (holds_transforms
            .then(|| Locator::find_list(&schema))
            .flatten())
        .map(Rc::new);
        let wrenches = self.wrenches.locators(channel, &schema)?;
        // A message of transforms holds only parts of the path, so `tool_track` composes them instead.
        let poses = match transforms {
            Some(_) => Vec::new(),
            None => self.poses.locators(channel, &schema)?,
        };
        let joints = holds_joints.then(|| JointStates::find(&schema)).flatten();
        let holds =
            !poses.is_empty() || !wrenches.is_empty() || transforms.is_some() || joints.is_some();
        Ok(if holds {
            Reading::Messages {
                schema,
                poses: poses.into(),
                wrenches: wrenches.into(),
                transforms,
                joints: joints.map(Rc::new),
            }
        } else {
            Reading::Nothing
        })
    }
}

/// Returns the error that a bag holds no complete message. `byte`: where it is cut, if it is [bytes].
const fn without_messages(byte: Option<u64>) -> ReadFault {
    ReadFault::TooEarly {
        what: "message",
        byte,
        messages: 0,
        topics: Vec::new(),
    }
}

/// Returns the error that no topic holds the quantity, with the list of topics. `cut`: length of a file that ends in the
/// middle of a record [bytes], and number of its complete messages.
fn nothing<Q: Quantity>(
    topics: &BTreeMap<String, String>,
    unread: &BTreeMap<String, String>,
    cut: Option<(u64, usize)>,
) -> ReadFault {
    if let Some((byte, messages)) = cut {
        return ReadFault::TooEarly {
            what: Q::NAME,
            byte: Some(byte),
            messages,
            topics: topics.keys().cloned().collect(),
        };
    }
    let topics = topics
        .iter()
        .filter(|(topic, _)| !unread.contains_key(*topic));
    ReadFault::Nothing {
        what: Q::NAME,
        topics: topics
            .map(|(topic, kind)| format!("{topic} ({kind})"))
            .collect(),
        unread: unread.values().cloned().collect(),
    }
}

/// Parses the schema of a channel's messages.
fn readable(channel: &Channel<'_>) -> Result<Schema, ReadFault> {
    let topic = channel.topic.clone();
    let encoding = |what, encoding: &str, limit| ReadFault::Encoding {
        topic: topic.clone(),
        what,
        encoding: encoding.to_owned(),
        limit,
    };
    if channel.message_encoding != "cdr" {
        return Err(encoding("message", &channel.message_encoding, "cdr"));
    }
    let Some(schema) = &channel.schema else {
        return Err(encoding("schema", "", "ros2msg"));
    };
    if schema.encoding != "ros2msg" {
        return Err(encoding("schema", &schema.encoding, "ros2msg"));
    }
    Schema::parse(&schema.name, &schema.data).map_err(|error| ReadFault::Schema { topic, error })
}
