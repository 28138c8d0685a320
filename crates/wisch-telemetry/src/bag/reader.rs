//! ROS 2 bags: finds the poses and forces in an MCAP file of whatever topics.

use super::container::{Ending, Entry, entries};
use super::joint_states::JointStates;
use super::locator::{Found, Locator};
use super::observation::{Looks, is_look};
use super::topic::{
    AXES_KEY, NOTES, ROLE_KEY, ROLE_POSE, ROLE_WRENCH, ROUND_NOTE, START_KEY, TASK_NOTE,
};
use crate::error::ReadFault;
use crate::frames::Frames;
use crate::options::TopicChoice;
use crate::quantity::Quantity;
use crate::ros2::{MessageError, Schema, Value, decode};
use crate::track::{JointPositions, RawLog, Track};
use mcap::Channel;
use std::collections::{BTreeMap, HashMap};
use std::fs::File;
use std::io::BufReader;
use std::path::Path;
use std::rc::Rc;
use wisch::geometry::{Pose, Vector3};
use wisch::represent::UnknownName;
use wisch::robot::JointTransform;

/// Gathers what the parts of a bag say.
pub(crate) struct BagReader {
    poses: Search<Pose>,
    wrenches: Search<Vector3>,
    /// Every topic with its type.
    topics: BTreeMap<String, String>,
    channels: HashMap<u16, Reading>,
    frames: Frames,
    joints: JointPositions,
    /// The task's name, where the writer says it.
    task: Option<String>,
    /// Which round of its run it was, where the writer says it.
    round: Option<usize>,
    looks: Looks,
    unfinished: bool,
}

/// What is made of a channel's messages.
enum Reading {
    /// It holds nothing that is looked for.
    Nothing,
    Messages {
        schema: Rc<Schema>,
        pose: Option<Rc<Locator<Pose>>>,
        wrench: Option<Rc<Locator<Vector3>>>,
        transforms: Option<Rc<Locator<Pose>>>,
        joints: Option<Rc<JointStates>>,
    },
}

/// Type of messages that hold transforms between frames.
const TRANSFORMS: &str = "TFMessage";
/// How a topic's name ends whose transforms hold for good.
const STATIC_TOPIC: &str = "tf_static";

impl BagReader {
    /// Looks for a pose, a wrench, and positions of joints.
    pub fn new(pose: &TopicChoice, wrench: &TopicChoice, joints: &[JointTransform]) -> Self {
        Self {
            poses: Search::new(pose, ROLE_POSE),
            wrenches: Search::new(wrench, ROLE_WRENCH),
            topics: BTreeMap::new(),
            channels: HashMap::new(),
            frames: Frames::default(),
            joints: JointPositions::of(joints),
            task: None,
            round: None,
            looks: Looks::default(),
            unfinished: false,
        }
    }

    /// Reads a file. One that is being written may end where it likes; of one that is finished that is an error.
    pub fn read(&mut self, path: &Path) -> Result<(), ReadFault> {
        let file = BufReader::new(File::open(path).map_err(ReadFault::System)?);
        // Each file numbers its channels anew.
        self.channels.clear();
        let ending = entries(file, &mut |entry| match entry {
            Entry::Message(channel, log_time, data) => self.message(channel, log_time, data),
            Entry::Notes(NOTES, notes) => {
                self.task = notes.get(TASK_NOTE).cloned();
                self.round = notes.get(ROUND_NOTE).and_then(|round| round.parse().ok());
                Ok(())
            }
            Entry::Notes(..) => Ok(()),
        })?;
        let is_active = path.extension().is_some_and(|ending| ending == "active");
        match ending {
            Ending::Footer => {}
            Ending::CutOff { .. } if is_active => self.unfinished = true,
            Ending::CutOff { byte } => return Err(ReadFault::Truncated { byte }),
        }
        Ok(())
    }

    /// What was found.
    pub fn finish(mut self) -> Result<RawLog, ReadFault> {
        self.frames.sort();
        let (poses, says) = self.poses.choose(&self.topics)?;
        let (wrenches, wrench_says) = self.wrenches.choose(&self.topics)?;
        Ok(RawLog {
            poses: poses.filled()?,
            wrenches: wrenches.filled()?,
            axes: wrench_says.axes,
            start: says.start,
            unfinished: self.unfinished,
            frames: self.frames,
            joints: self.joints,
            task: self.task,
            round: self.round,
            looks: self.looks.finish(),
            units: None,
        })
    }

    fn message(
        &mut self,
        channel: &Channel<'_>,
        log_time: u64,
        data: &[u8],
    ) -> Result<(), ReadFault> {
        if is_look(&channel.topic) {
            return self.looks.take(channel, data);
        }
        if !self.channels.contains_key(&channel.id) {
            let reading = self.channel(channel)?;
            self.channels.insert(channel.id, reading);
        }
        let Some(Reading::Messages {
            schema,
            pose,
            wrench,
            transforms,
            joints,
        }) = self.channels.get(&channel.id)
        else {
            return Ok(());
        };
        let value = decode(schema, data);
        let log_time = i64::try_from(log_time).unwrap_or(i64::MAX);
        if let Some(locator) = pose {
            self.poses.take(channel, locator, &value, log_time);
        }
        if let Some(locator) = wrench {
            self.wrenches.take(channel, locator, &value, log_time);
        }
        if let (Some(locator), Ok(message)) = (transforms, &value) {
            let is_static = channel.topic.ends_with(STATIC_TOPIC);
            for found in locator.read(message) {
                let time = if found.stamp == 0 {
                    log_time
                } else {
                    found.stamp
                };
                if let Ok(pose) = found.value {
                    (self.frames).insert(found.frame, found.child, time, pose, is_static);
                }
            }
        }
        if let (Some(places), Ok(message)) = (joints, &value) {
            places.read(message, log_time, &mut self.joints);
        }
        Ok(())
    }

    /// Sees a channel for the first time.
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
            // Bags hold topics of all kinds, and this is not the one that was asked for.
            Err(_) => return Ok(Reading::Nothing),
        };
        let pose = self.poses.locator(channel, &schema)?;
        let wrench = self.wrenches.locator(channel, &schema)?;
        let transforms = (holds_transforms
            .then(|| Locator::find(&schema, ""))
            .flatten())
        .filter(Locator::is_list)
        .map(Rc::new);
        let joints = holds_joints.then(|| JointStates::find(&schema)).flatten();
        let holds = pose.is_some() || wrench.is_some() || transforms.is_some() || joints.is_some();
        Ok(if holds {
            Reading::Messages {
                schema,
                pose,
                wrench,
                transforms,
                joints: joints.map(Rc::new),
            }
        } else {
            Reading::Nothing
        })
    }
}

/// The layout of a channel's messages.
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

/// Which time a topic's messages go by.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Clock {
    /// That of their headers.
    Stamp,
    /// That at which they were recorded, as their headers bear none.
    Log,
}

/// Something that may be what is looked for.
struct Candidate<Q> {
    topic: String,
    /// The child frame, in a topic that holds many.
    child: String,
    clock: Clock,
    says: Says,
    track: Track<Q>,
}

/// What the writer says about a channel.
#[derive(Debug, Clone, Default)]
struct Says {
    is_meant: bool,
    axes: Option<String>,
    start: Option<i64>,
}

/// Looks for one quantity.
struct Search<Q> {
    /// A topic and a field of it, or nothing.
    named: Option<(String, String)>,
    role: &'static str,
    candidates: Vec<Candidate<Q>>,
    /// How many messages of each topic were seen.
    seen: HashMap<String, usize>,
    /// The first fault of each topic; it matters only if the topic is chosen.
    faults: BTreeMap<String, ReadFault>,
}

impl<Q: Quantity> Search<Q> {
    fn new(choice: &TopicChoice, role: &'static str) -> Self {
        let named = match choice {
            TopicChoice::Sole => None,
            TopicChoice::Named(name) => {
                let (topic, field) = name.split_once(':').unwrap_or((name, ""));
                Some((topic.to_owned(), field.to_owned()))
            }
        };
        Self {
            named,
            role,
            candidates: Vec::new(),
            seen: HashMap::new(),
            faults: BTreeMap::new(),
        }
    }

    /// Whether this channel was asked for by name.
    fn names(&self, channel: &Channel<'_>) -> bool {
        (self.named.as_ref()).is_some_and(|(topic, _)| *topic == channel.topic)
    }

    /// Whether this channel may be it.
    fn wants(&self, channel: &Channel<'_>) -> bool {
        match self.named {
            Some(_) => self.names(channel),
            // What never moves wipes nothing.
            None => !channel.topic.ends_with(STATIC_TOPIC),
        }
    }

    /// How to read a channel, if it holds the quantity.
    fn locator(
        &self,
        channel: &Channel<'_>,
        schema: &Schema,
    ) -> Result<Option<Rc<Locator<Q>>>, ReadFault> {
        if !self.wants(channel) {
            return Ok(None);
        }
        let field = self.named.as_ref().map_or("", |(_, field)| field);
        let locator = Locator::find(schema, field);
        if locator.is_none() && self.names(channel) {
            let kind = channel.schema.as_ref().map(|schema| schema.name.clone());
            return Err(ReadFault::NotThere {
                topic: channel.topic.clone(),
                kind: kind.unwrap_or_default(),
                field: field.to_owned(),
                what: Q::NAME,
            });
        }
        Ok(locator.map(Rc::new))
    }

    fn take(
        &mut self,
        channel: &Channel<'_>,
        locator: &Locator<Q>,
        message: &Result<Value, MessageError>,
        log_time: i64,
    ) {
        if self.faults.contains_key(&channel.topic) {
            return;
        }
        let number = self.count(&channel.topic);
        let taken = match message {
            Ok(message) => (locator.read(message))
                .try_for_each(|found| self.push(channel, locator, found, number, log_time)),
            Err(error) => Err(ReadFault::Message {
                topic: channel.topic.clone(),
                number,
                error: error.clone(),
            }),
        };
        if let Err(fault) = taken {
            self.faults.insert(channel.topic.clone(), fault);
        }
    }

    /// The number of a topic's next message, from 1.
    fn count(&mut self, topic: &str) -> usize {
        if let Some(count) = self.seen.get_mut(topic) {
            *count += 1;
            return *count;
        }
        self.seen.insert(topic.to_owned(), 1);
        1
    }

    fn push(
        &mut self,
        channel: &Channel<'_>,
        locator: &Locator<Q>,
        found: Found<'_, Q>,
        number: usize,
        log_time: i64,
    ) -> Result<(), ReadFault> {
        let child = if locator.is_list() { found.child } else { "" };
        let known = (self.candidates.iter())
            .position(|known| known.topic == channel.topic && known.child == child);
        let index = known.unwrap_or_else(|| {
            let candidate = Candidate::new(channel, child, &found, log_time, self.role);
            self.candidates.push(candidate);
            self.candidates.len() - 1
        });
        let candidate = &mut self.candidates[index];
        let time = match candidate.clock {
            Clock::Stamp => found.stamp,
            Clock::Log => log_time,
        };
        let place = || format!("topic {}, message {number}", channel.topic);
        candidate.track.push(time, found.value, place)
    }

    /// The one that is meant.
    fn choose(mut self, topics: &BTreeMap<String, String>) -> Result<(Track<Q>, Says), ReadFault> {
        let index = match &self.named {
            Some((topic, field)) => self.by_name(topic, field, topics)?,
            None => self.by_content()?,
        };
        let Some(index) = index else {
            // The messages that might have been it may have been no messages.
            return Err((self.faults.pop_first()).map_or_else(
                || ReadFault::Nothing {
                    what: Q::NAME,
                    topics: (topics.iter())
                        .map(|(topic, kind)| format!("{topic} ({kind})"))
                        .collect(),
                },
                |(_, fault)| fault,
            ));
        };
        let chosen = self.candidates.swap_remove(index);
        match self.faults.remove(&chosen.topic) {
            Some(fault) => Err(fault),
            None => Ok((chosen.track, chosen.says)),
        }
    }

    fn by_name(
        &self,
        topic: &str,
        field: &str,
        topics: &BTreeMap<String, String>,
    ) -> Result<Option<usize>, ReadFault> {
        if !topics.contains_key(topic) {
            let known = topics.keys().map(String::as_str);
            return Err(ReadFault::Unknown(UnknownName::new("topic", topic, known)));
        }
        let children = || self.candidates.iter().map(|known| known.child.as_str());
        if field.is_empty() || children().all(str::is_empty) {
            return self.sole(|_| true);
        }
        let index = children().position(|child| child == field);
        index
            .map(Some)
            .ok_or_else(|| ReadFault::Unknown(UnknownName::new("child frame", field, children())))
    }

    fn by_content(&self) -> Result<Option<usize>, ReadFault> {
        // Transforms are of everything that moves: a topic of its own is the better guess.
        let preferences: [fn(&Candidate<Q>) -> bool; 4] = [
            |candidate| candidate.says.is_meant,
            |candidate| candidate.child.is_empty(),
            |candidate| candidate.track.changes(),
            |_| true,
        ];
        for preferred in preferences {
            if let Some(index) = self.sole(preferred)? {
                return Ok(Some(index));
            }
        }
        Ok(None)
    }

    /// The only candidate of some kind, if there is any.
    fn sole(&self, is_one: fn(&Candidate<Q>) -> bool) -> Result<Option<usize>, ReadFault> {
        let those: Vec<usize> = (0..self.candidates.len())
            .filter(|&index| is_one(&self.candidates[index]))
            .collect();
        match those.as_slice() {
            [] => Ok(None),
            [one] => Ok(Some(*one)),
            many => Err(ReadFault::Several {
                what: Q::NAME,
                topics: (many.iter())
                    .map(|&index| self.candidates[index].track.name.clone())
                    .collect(),
            }),
        }
    }
}

impl<Q: Quantity> Candidate<Q> {
    fn new(
        channel: &Channel<'_>,
        child: &str,
        found: &Found<'_, Q>,
        log_time: i64,
        role: &str,
    ) -> Self {
        let mut track = Track::new(match child {
            "" => channel.topic.clone(),
            child => format!("{}:{child}", channel.topic),
        });
        track.frame = found.frame.to_owned();
        track.child = found.child.to_owned();
        let says = |key| channel.metadata.get(key).cloned();
        Self {
            topic: channel.topic.clone(),
            child: child.to_owned(),
            clock: match (found.stamp, log_time) {
                (0, 1..) => Clock::Log,
                _ => Clock::Stamp,
            },
            says: Says {
                is_meant: says(ROLE_KEY).as_deref() == Some(role),
                axes: says(AXES_KEY),
                start: says(START_KEY).and_then(|start| start.parse().ok()),
            },
            track,
        }
    }
}
