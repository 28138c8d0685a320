//! Joint positions in messages of `/joint_states`.

use crate::ros2::{Kind, NANOSECONDS_PER_SECOND, Schema, Shape, Value};
use crate::track::JointPositions;
use mcap::Channel;

/// Type of messages that hold joint positions.
const JOINT_STATE: &str = "JointState";
/// Ending of topics with measured positions; other topics of the type hold targets.
const MEASURED_TOPIC: &str = "joint_states";

/// Locator of joint positions in messages of one schema.
#[derive(Debug, Clone)]
pub(super) struct JointStates {
    names: Vec<usize>,
    positions: Vec<usize>,
    /// Paths of seconds and nanoseconds in the header's stamp.
    stamp: Option<[Vec<usize>; 2]>,
}

impl JointStates {
    /// Whether a channel holds measured joint positions.
    pub fn are_in(channel: &Channel<'_>) -> bool {
        let is_one = |schema: &std::sync::Arc<mcap::Schema<'_>>| schema.name.ends_with(JOINT_STATE);
        channel.schema.as_ref().is_some_and(is_one) && channel.topic.ends_with(MEASURED_TOPIC)
    }

    /// Finds the fields of a message that hold joint positions.
    pub fn find(schema: &Schema) -> Option<Self> {
        let list = |name: &str, kind: Kind| {
            let (path, field) = schema.find(schema.root(), name)?;
            (field.shape == Shape::Sequence && field.kind == kind).then_some(path)
        };
        let stamp = |name: &str| {
            let (path, field) = schema.find(schema.root(), name)?;
            (field.shape == Shape::One).then_some(path)
        };
        Some(Self {
            names: list("name", Kind::Text)?,
            positions: list("position", Kind::Float64)?,
            stamp: stamp("header.stamp.sec")
                .zip(stamp("header.stamp.nanosec"))
                .map(|(sec, nanosec)| [sec, nanosec]),
        })
    }

    /// Returns the stamp of a message [ns]; 0 stands for none.
    pub fn stamp(&self, message: &Value) -> i64 {
        let whole = |path| (message.field(path).and_then(Value::number)).unwrap_or(0.0) as i64;
        self.stamp.as_ref().map_or(0, |[sec, nanosec]| {
            whole(sec)
                .saturating_mul(NANOSECONDS_PER_SECOND as i64)
                .saturating_add(whole(nanosec))
        })
    }

    /// Adds the positions of a message at a time [ns]; values that are not finite are skipped.
    pub fn read(&self, message: &Value, time: i64, positions: &mut JointPositions) {
        let (Some(Value::Texts(names)), Some(Value::Numbers(values))) =
            (message.field(&self.names), message.field(&self.positions))
        else {
            return;
        };
        for (name, value) in names
            .iter()
            .zip(values)
            .filter(|(_, value)| value.is_finite())
        {
            positions.push(name, time, *value);
        }
    }
}
