//! Poses of a tool from a chain of transforms: which frame is the tool's, and where it was.

use super::error::ReadFault;
use super::frames::Frames;
use super::options::LogOptions;
use super::track::Track;
use wisch::geometry::Pose;
use wisch::represent::UnknownName;

/// What the frame of a tool is called among those below the last moving one, the likeliest first.
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
    /// The poses of a frame over time, in the task's world where the transforms lead there, else in the outermost frame.
    /// Without a name, the frame is the end of the only chain that moves. `topic` names where the transforms come from.
    /// Nothing where no transform is known.
    ///
    /// # Errors
    /// A frame that is unknown or that never moves, and several chains that move.
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
                "the pose is that of {frame:?}, the end of the only chain of frames that moves; --pose-topic {topic}:FRAME states another"
            ));
        }
        if chain.as_ref().is_some_and(|chain| chain.len() > 1) {
            remarks.push(format!(
                "{frame:?} is followed in {reference:?} by a chain of frames"
            ));
        }
        let mut track = Track::new(format!("{topic}:{frame}"), options.reorder_window);
        track.frame = reference.to_owned();
        for time in times {
            if let Some(pose) = chain
                .as_ref()
                .and_then(|chain| chain.at(time, options.max_gap))
            {
                track.push(time, Ok(pose), || frame.clone())?;
            }
        }
        track.child = frame.clone();
        Ok(Some(track.finish()?))
    }

    /// The frame at the end of each chain of frames that moves: the one that is called like a tool's among those below its
    /// last moving frame, or that frame itself.
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
