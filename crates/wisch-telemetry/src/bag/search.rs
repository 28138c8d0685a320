//! Search for the topic of a bag that holds the poses or forces.

use super::clocks::Offset;
use super::locator::{Found, Locator};
use super::topic::{AXES_KEY, ROLE_KEY, START_KEY};
use crate::error::ReadFault;
use crate::options::{Clock, TopicChoice};
use crate::quantity::{Quantity, QuantityError};
use crate::ros2::{MessageError, NANOSECONDS_PER_SECOND, Schema, Value};
use crate::track::{Track, seconds};
use mcap::Channel;
use std::collections::{BTreeMap, HashMap};
use std::rc::Rc;
use wisch::represent::UnknownName;

/// Least difference of stamps and times of recording that makes a date wrong: a day [ns].
const LONGEST_DELAY: i64 = 86_400 * NANOSECONDS_PER_SECOND as i64;
/// Earliest time that is a date [ns since 1970]: the year 1990.
const EARLIEST_DATE: i64 = 630_000_000 * NANOSECONDS_PER_SECOND as i64;

/// Fields that are preferred where a larger message holds the quantity several times: the measured ones of libfranka's
/// state.
const MEASURED_FIELDS: [&str; 2] = ["o_t_ee", "o_f_ext_hat_k"];

/// A value of a message, with both of its times.
struct Stamped<Q> {
    stamp: i64,
    log_time: i64,
    number: usize,
    /// Number of the file that holds it.
    part: usize,
    value: Result<Q, QuantityError>,
}

/// A topic or field that may hold the quantity.
pub(super) struct Candidate<Q> {
    topic: String,
    /// Field of a larger message; empty if the topic's messages hold only the quantity.
    pub field: String,
    frame: String,
    child: String,
    /// Another frame that one of the messages is in.
    other_frame: Option<String>,
    pub says: Says,
    entries: Vec<Stamped<Q>>,
}

/// Metadata of a channel by the writer.
#[derive(Debug, Clone, Default)]
pub(super) struct Says {
    is_meant: bool,
    pub axes: Option<String>,
    pub start: Option<i64>,
}

/// A field of a channel's messages, and its locator.
pub(super) type Located<Q> = (String, Rc<Locator<Q>>);

/// Search for one quantity.
pub(super) struct Search<Q> {
    /// Topic and field that the options name.
    pub named: Option<(String, String)>,
    role: &'static str,
    candidates: Vec<Candidate<Q>>,
    /// Number of messages of each topic so far.
    seen: HashMap<String, usize>,
    /// First fault of each topic; it matters only if the topic is chosen.
    faults: BTreeMap<String, ReadFault>,
}

impl<Q: Quantity> Search<Q> {
    pub fn new(choice: &TopicChoice, role: &'static str) -> Self {
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

    /// Whether the options name this channel.
    pub fn names(&self, channel: &Channel<'_>) -> bool {
        (self.named.as_ref()).is_some_and(|(topic, _)| *topic == channel.topic)
    }

    /// Whether this channel may hold the quantity.
    pub fn wants(&self, channel: &Channel<'_>) -> bool {
        self.named.is_none() || self.names(channel)
    }

    /// Finds the fields of a channel's messages that hold the quantity.
    pub fn locators(
        &self,
        channel: &Channel<'_>,
        schema: &Schema,
    ) -> Result<Vec<Located<Q>>, ReadFault> {
        if !self.wants(channel) {
            return Ok(Vec::new());
        }
        let field = self.named.as_ref().map_or("", |(_, field)| field);
        let located = match Locator::find(schema, field) {
            Some(locator) => vec![(field.to_owned(), locator)],
            None if field.is_empty() => Locator::find_within(schema),
            None => Vec::new(),
        };
        if located.is_empty() && self.names(channel) {
            let schema_name = channel.schema.as_ref().map(|schema| schema.name.as_str());
            let fields = match Locator::<Q>::find(schema, "") {
                Some(_) => vec![String::new()],
                None => {
                    let found = Locator::<Q>::find_within(schema).into_iter();
                    found.map(|(field, _)| field).collect()
                }
            };
            return Err(ReadFault::NotThere {
                topic: channel.topic.clone(),
                kind: schema_name.unwrap_or("unknown").into(),
                field: field.to_owned(),
                what: Q::NAME,
                fields: fields.into(),
            });
        }
        let shared = |(field, locator)| (field, Rc::new(locator));
        Ok(located.into_iter().map(shared).collect())
    }

    /// Reads a message.
    pub fn take(
        &mut self,
        channel: &Channel<'_>,
        located: &[Located<Q>],
        message: &Result<Value, MessageError>,
        log_time: i64,
        part: usize,
    ) {
        if located.is_empty() || self.faults.contains_key(&channel.topic) {
            return;
        }
        let number = self.count(&channel.topic);
        let message = match message {
            Ok(message) => message,
            Err(error) => {
                let fault = ReadFault::Message {
                    topic: channel.topic.clone(),
                    number,
                    error: error.clone(),
                };
                self.faults.insert(channel.topic.clone(), fault);
                return;
            }
        };
        for (field, locator) in located {
            for found in locator.read(message) {
                let candidate = self.candidate(channel, field, &found);
                candidate.compare_frame(found.frame);
                candidate.entries.push(Stamped {
                    stamp: found.stamp,
                    log_time,
                    number,
                    part,
                    value: found.value,
                });
            }
        }
    }

    /// Returns the number of a topic's next message, from 1.
    fn count(&mut self, topic: &str) -> usize {
        if let Some(count) = self.seen.get_mut(topic) {
            *count += 1;
            return *count;
        }
        self.seen.insert(topic.to_owned(), 1);
        1
    }

    fn candidate(
        &mut self,
        channel: &Channel<'_>,
        field: &str,
        found: &Found<'_, Q>,
    ) -> &mut Candidate<Q> {
        let known = (self.candidates.iter())
            .position(|known| known.topic == channel.topic && known.field == field);
        let index = known.unwrap_or_else(|| {
            let says = |key| channel.metadata.get(key).cloned();
            self.candidates.push(Candidate {
                topic: channel.topic.clone(),
                field: field.to_owned(),
                frame: found.frame.to_owned(),
                child: found.child.to_owned(),
                other_frame: None,
                says: Says {
                    is_meant: says(ROLE_KEY).as_deref() == Some(self.role),
                    axes: says(AXES_KEY),
                    start: says(START_KEY).and_then(|start| start.parse().ok()),
                },
                entries: Vec::new(),
            });
            self.candidates.len() - 1
        });
        &mut self.candidates[index]
    }

    /// Returns the chosen candidate, or `None` if nothing holds the quantity.
    pub fn choose(
        &mut self,
        topics: &BTreeMap<String, String>,
    ) -> Result<Option<Candidate<Q>>, ReadFault> {
        let index = match &self.named {
            Some((topic, _)) if !topics.contains_key(topic) => {
                let known = topics.keys().map(String::as_str);
                return Err(ReadFault::Unknown(UnknownName::new("topic", topic, known)));
            }
            _ => self.find_preferred()?,
        };
        let Some(index) = index else {
            // If every message of a likely topic was faulty, its fault explains the absence.
            return match self.faults.pop_first() {
                Some((_, fault)) => Err(fault),
                None => Ok(None),
            };
        };
        let chosen = self.candidates.swap_remove(index);
        match self.faults.remove(&chosen.topic) {
            Some(fault) => Err(fault),
            None => Ok(Some(chosen)),
        }
    }

    fn find_preferred(&self) -> Result<Option<usize>, ReadFault> {
        let preferences: [fn(&Candidate<Q>) -> bool; 4] = [
            |candidate| candidate.says.is_meant,
            // A topic whose messages hold only the quantity is preferred to a field of a larger message.
            |candidate| candidate.field.is_empty(),
            |candidate| MEASURED_FIELDS.contains(&candidate.field.as_str()),
            |_| true,
        ];
        for preferred in preferences {
            if let Some(index) = self.sole(preferred)? {
                return Ok(Some(index));
            }
        }
        Ok(None)
    }

    /// Returns the only candidate that meets a condition, if any.
    fn sole(&self, is_one: fn(&Candidate<Q>) -> bool) -> Result<Option<usize>, ReadFault> {
        let those: Vec<usize> = (0..self.candidates.len())
            .filter(|&index| is_one(&self.candidates[index]))
            .collect();
        match those.as_slice() {
            [] => Ok(None),
            [one] => Ok(Some(*one)),
            many => Err(ReadFault::Several {
                what: Q::NAME,
                topics: many
                    .iter()
                    .map(|&index| self.candidates[index].name())
                    .collect(),
            }),
        }
    }
}

/// Returns the remark that a clock was aligned by adding `shift` [ns] to its times.
pub(super) fn alignment_remark(name: &str, shift: i64) -> String {
    format!(
        "the clock of {name} is {:+.3} s off that of the poses by the times of recording, and is aligned with it (--time log uses the times of recording instead)",
        -seconds(shift)
    )
}

impl<Q: Quantity> Candidate<Q> {
    /// Topic and field of the candidate.
    pub fn name(&self) -> String {
        match self.field.as_str() {
            "" => self.topic.clone(),
            field => format!("{}:{field}", self.topic),
        }
    }

    /// Keeps the first frame of a message that is not that of the messages before it.
    fn compare_frame(&mut self, frame: &str) {
        if self.frame.is_empty() {
            frame.clone_into(&mut self.frame);
        }
        let [own, other] = [&self.frame, frame].map(|frame| frame.trim_start_matches('/'));
        if !other.is_empty() && own != other && self.other_frame.is_none() {
            self.other_frame = Some(frame.to_owned());
        }
    }

    /// Offset of its stamps ahead of the recorder's clock.
    pub fn offset(&self, clock: Clock) -> Offset {
        let stamped = self.entries.iter().filter(|entry| entry.stamp != 0);
        let ahead = stamped.map(|entry| entry.stamp.saturating_sub(entry.log_time));
        match clock {
            Clock::Log => Offset::NONE,
            Clock::Header => Offset::from_lags(ahead.collect()).unwrap_or(Offset::NONE),
        }
    }

    /// States that the date of its stamps is not that of its recording, if both are dates: a clock was wrong.
    fn describe_wrong_date(&self, offset: Offset) -> Option<String> {
        let stamped = self.entries.iter().find(|entry| entry.stamp != 0)?;
        let times = [stamped.stamp, stamped.log_time];
        if offset.median.saturating_abs() < LONGEST_DELAY
            || times.iter().any(|time| *time < EARLIEST_DATE)
        {
            return None;
        }
        let [stamp, recorded] = times.map(|time| {
            let time = jiff::Timestamp::from_nanosecond(time.into()).unwrap_or_default();
            time.strftime("%Y-%m-%d %H:%M:%S").to_string()
        });
        Some(format!(
            "the stamps of {} begin at {stamp} UTC, but were recorded at {recorded} UTC: one of the clocks was wrong (--time log uses the times of recording)",
            self.topic
        ))
    }

    /// Returns its values as a track, by the given clock and shifted by `shift` [ns].
    pub fn into_track(
        self,
        clock: Clock,
        shift: i64,
        window: f64,
        remarks: &mut Vec<String>,
    ) -> Result<Track<Q>, ReadFault> {
        if let Some(other) = self.other_frame {
            return Err(ReadFault::SeveralFrames {
                topic: self.topic,
                frames: [self.frame, other],
            });
        }
        let offset = self.offset(clock);
        remarks.extend(self.describe_wrong_date(offset));
        let mut track = Track::new(self.name(), window);
        track.frame = self.frame;
        track.child = self.child;
        let count = self.entries.len();
        let (mut unstamped, mut part) = (0, 0);
        for entry in self.entries {
            if entry.part != part {
                part = entry.part;
                track.begin_part();
            }
            let time = match clock {
                Clock::Header if entry.stamp != 0 => entry.stamp,
                _ => entry.log_time.saturating_add(offset.median),
            };
            unstamped += usize::from(entry.stamp == 0 && entry.log_time != 0);
            let place = || format!("topic {}, message {}", self.topic, entry.number);
            track.push(time.saturating_add(shift), entry.value, place)?;
        }
        if unstamped > 0 && clock == Clock::Header {
            remarks.push(format!(
                "{unstamped} of {count} messages of {} have no stamp: their time of recording is used",
                track.name
            ));
        }
        if shift != 0 {
            remarks.push(alignment_remark(&track.name, shift));
        }
        let track = track.finish()?;
        remarks.extend(track.reordering());
        Ok(track)
    }
}
