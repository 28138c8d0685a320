//! Poses of a tool from a chain of transforms: which frame is the tool's, and its pose over time.

use super::error::ReadFault;
use super::frames::Frames;
use super::options::LogOptions;
use super::track::Track;
use wisch::geometry::Pose;
use wisch::represent::UnknownName;

/// Likely names of the tool's frame below the last moving frame, the likeliest first.
const TOOL_NAMES: [&str; 9] = [
    "tcp",
    "tool_center_point",
    "tool0",
    "tool",
    "ee_link",
    "ee",
    "end_effector",
    "flange",
    "hand",
];

impl Frames {
    /// Returns the poses of a frame over time, in the task's world if transforms lead there, else in the outermost
    /// frame.
    ///
    /// Without a name, the frame is the end of the only moving chain. `topic` names the source of the transforms.
    /// Returns `None` without transforms.
    ///
    /// # Errors
    /// If the frame is unknown or never moves, or if several chains move.
    pub fn tool_track(
        &self,
        named: Option<&str>,
        topic: &str,
        options: &LogOptions,
        remarks: &mut Vec<String>,
    ) -> Result<Option<Track<Pose>>, ReadFault> {
        let stated = named.filter(|name| !name.is_empty());
        let stated = stated.or(options.pose_frame.as_deref());
        let frame = match stated {
            Some(name) if self.knows(name) => name.to_owned(),
            Some(name) => {
                let known = self.names();
                return Err(ReadFault::Unknown(UnknownName::new("frame", name, known)));
            }
            None => {
                let ends = self.ends_of_motion();
                match &ends[..] {
                    [] => return Ok(None),
                    [one] => one.clone(),
                    many => {
                        return Err(ReadFault::Several {
                            what: "pose",
                            topics: many.iter().map(|end| format!("{topic}:{end}")).collect(),
                        });
                    }
                }
            }
        };
        let root = self.root_of(&frame);
        let world = options.world_frame.as_str();
        let leads_to_world =
            options.world_from_log.is_none() && self.between(world, &frame).is_some();
        let reference = if leads_to_world { world } else { root };
        let chain = self.between(reference, &frame);
        let times = chain
            .as_ref()
            .map(|chain| chain.busiest_times())
            .unwrap_or_default();
        if times.is_empty() {
            return Err(ReadFault::StillFrame {
                frame: frame.clone(),
                reference: reference.to_owned(),
            });
        }
        if stated.is_none() {
            remarks.push(format!(
                "the pose is that of {frame:?}, the end of the only moving chain of frames; --pose-topic {topic}:FRAME selects another frame"
            ));
        }
        if chain.as_ref().is_some_and(|chain| chain.len() > 1) {
            remarks.push(format!(
                "the pose of {frame:?} in {reference:?} comes from a chain of transforms"
            ));
        }
        let mut track = Track::new(format!("{topic}:{frame}"), options.reorder_window);
        track.frame = reference.to_owned();
        for time in times {
            if let Some(pose) = chain
                .as_ref()
                .and_then(|chain| chain.pose_at(time, options.max_gap))
            {
                track.push(time, Ok(pose), || frame.clone())?;
            }
        }
        track.child = frame.clone();
        Ok(Some(track.finish()?))
    }

    /// Returns the frame at the end of each moving chain: the frame with a tool's name below its last moving frame, or
    /// else that moving frame.
    fn ends_of_motion(&self) -> Vec<String> {
        let moving = self.moving();
        let is_above = |frame: &str, other: &str| self.ancestors(other).any(|above| above == frame);
        let last = moving
            .iter()
            .filter(|frame| !moving.iter().any(|other| is_above(frame, other)));
        let end = |frame: &&str| {
            let names = self.names();
            let below = names.iter().copied().filter(|name| is_above(frame, name));
            let group: Vec<&str> = std::iter::once(*frame).chain(below).collect();
            let is_called = |name: &str, tool: &str| {
                let own = name.rsplit('/').next().unwrap_or(name).to_lowercase();
                own == tool || own.ends_with(&format!("_{tool}"))
            };
            let called = TOOL_NAMES
                .iter()
                .find_map(|tool| group.iter().find(|name| is_called(name, tool)));
            (*called.unwrap_or(frame)).to_owned()
        };
        last.map(end).collect()
    }
}
