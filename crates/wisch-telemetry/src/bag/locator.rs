//! Locators: the fields of a topic's messages that hold a pose or a force.

use crate::quantity::{Quantity, QuantityError};
use crate::ros2::{Field, Kind, NANOSECONDS_PER_SECOND, Schema, Shape, Value};
use std::marker::PhantomData;

/// Largest depth in a message, and largest number of nested messages, in which an unnamed quantity is searched.
const MAX_FIELD_DEPTH: usize = 3;
const MAX_FIELDS: usize = 1000;

/// Locator of a quantity in messages of one schema.
#[derive(Debug, Clone)]
pub(crate) struct Locator<Q> {
    place: Place,
    /// Path of the list, for messages with many quantities, as in `/tf`.
    list: Option<Vec<usize>>,
    quantity: PhantomData<Q>,
}

/// Paths in a message; see [`Schema::find`].
#[derive(Debug, Clone)]
struct Place {
    numbers: Vec<Vec<usize>>,
    /// Paths of seconds and nanoseconds in the header's stamp.
    stamp: Option<[Vec<usize>; 2]>,
    /// Path of the header's frame.
    frame: Option<Vec<usize>>,
    /// Path of a transform's child frame.
    child: Option<Vec<usize>>,
}

/// A quantity found in a message.
#[derive(Debug)]
pub(crate) struct Found<'a, Q> {
    /// Child frame, in messages with many quantities.
    pub child: &'a str,
    /// Frame of the header; empty without a header.
    pub frame: &'a str,
    /// Stamp of the header [ns]; 0 stands for none.
    pub stamp: i64,
    /// The quantity, or why its numbers are invalid.
    pub value: Result<Q, QuantityError>,
}

impl<Q: Quantity> Locator<Q> {
    /// Finds the quantity in messages of a schema, or in their field `field` if that is not empty.
    pub fn find(schema: &Schema, field: &str) -> Option<Self> {
        let single = |place| Self {
            place,
            list: None,
            quantity: PhantomData,
        };
        Place::find::<Q>(schema, schema.root(), field).map(single)
    }

    /// Finds the quantity in the fields of a larger message and of the messages in it. Returns the path of each field
    /// with its locator.
    pub fn find_within(schema: &Schema) -> Vec<(String, Self)> {
        let mut found: Vec<(String, Self)> = Vec::new();
        let mut paths = vec![(String::new(), schema.root(), 0)];
        while let Some((path, fields, depth)) = paths.pop() {
            for field in fields {
                let (Kind::Message(definition), Shape::One) = (field.kind, field.shape) else {
                    continue;
                };
                let path = match path.as_str() {
                    "" => field.name.clone(),
                    path => format!("{path}.{}", field.name),
                };
                if let Some(locator) = Self::find(schema, &path) {
                    found.push((path, locator));
                } else if depth < MAX_FIELD_DEPTH && paths.len() < MAX_FIELDS {
                    paths.push((path, schema.fields(definition), depth + 1));
                }
            }
        }
        found.sort_by(|a, b| a.0.cmp(&b.0));
        found
    }

    /// Finds a list of transforms, which their child frames distinguish.
    pub fn find_list(schema: &Schema) -> Option<Self> {
        schema.root().iter().enumerate().find_map(|(index, list)| {
            let (Kind::Message(definition), Shape::Sequence) = (list.kind, list.shape) else {
                return None;
            };
            let place = Place::find::<Q>(schema, schema.fields(definition), "")?;
            place.child.as_ref()?;
            Some(Self {
                place,
                list: Some(vec![index]),
                quantity: PhantomData,
            })
        })
    }

    /// Reads the quantities of a message.
    pub fn read<'a>(&'a self, message: &'a Value) -> impl Iterator<Item = Found<'a, Q>> {
        let (one, many) = match &self.list {
            None => (Some(message), &[][..]),
            Some(list) => match message.field(list) {
                Some(Value::List(values)) => (None, values.as_slice()),
                _ => (None, &[][..]),
            },
        };
        one.into_iter()
            .chain(many)
            .map(|value| self.place.read(value))
    }
}

impl Place {
    fn find<Q: Quantity>(schema: &Schema, fields: &[Field], within: &str) -> Option<Self> {
        let path = |parts: [&str; 2]| {
            let parts: Vec<&str> = parts.into_iter().filter(|part| !part.is_empty()).collect();
            parts.join(".")
        };
        let leaf = |name: &str, is: fn(&Field) -> bool| {
            let (path, field) = schema.find(fields, name)?;
            (field.shape == Shape::One && is(field)).then_some(path)
        };
        let number = |name: &str| leaf(name, is_number);
        let numbers = Q::PLACES.iter().find_map(|(base, names)| {
            let base = path([within, base]);
            let paths = names.iter().map(|name| number(&path([&base, name])));
            paths.collect::<Option<Vec<_>>>()
        })?;
        // The header is the one of the innermost message around the quantity that has a header.
        let stamp = |header: &str| {
            let sec = number(&path([header, "stamp.sec"]))?;
            Some([sec, number(&path([header, "stamp.nanosec"]))?])
        };
        let headers = [path([within, "header"]), "header".to_owned()];
        let header = headers.iter().find(|header| stamp(header).is_some());
        Some(Self {
            numbers,
            stamp: header.and_then(|header| stamp(header)),
            frame: header.and_then(|header| leaf(&path([header, "frame_id"]), is_text)),
            child: leaf(&path([within, "child_frame_id"]), is_text),
        })
    }

    fn read<'a, Q: Quantity>(&self, message: &'a Value) -> Found<'a, Q> {
        let number = |path: &Vec<usize>| message.field(path).and_then(Value::number);
        // Every path was found in the schema by which the message was decoded.
        let numbers: Vec<f64> = (self.numbers.iter())
            .map(|path| number(path).unwrap_or(f64::NAN))
            .collect();
        let text = |path: &Option<Vec<usize>>| match path.as_ref().and_then(|p| message.field(p)) {
            Some(Value::Text(text)) => text.as_str(),
            _ => "",
        };
        let stamp = self.stamp.as_ref().map_or(0, |[sec, nanosec]| {
            let whole = |path| number(path).unwrap_or(0.0) as i64;
            whole(sec)
                .saturating_mul(NANOSECONDS_PER_SECOND as i64)
                .saturating_add(whole(nanosec))
        });
        Found {
            child: text(&self.child),
            frame: text(&self.frame),
            stamp,
            value: Q::from_numbers(&numbers),
        }
    }
}

fn is_number(field: &Field) -> bool {
    !matches!(
        field.kind,
        Kind::Text | Kind::WideText | Kind::Message(_) | Kind::Bool
    )
}

fn is_text(field: &Field) -> bool {
    field.kind == Kind::Text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ros2::full_definition;
    use wisch::geometry::{Pose, Vector3};

    fn schema(name: &str) -> Schema {
        Schema::parse(name, full_definition(name).as_bytes()).unwrap()
    }

    #[test]
    fn poses_and_wrenches_are_recognised_by_their_fields() {
        let cases = [
            ("geometry_msgs/PoseStamped", [true, false]),
            ("geometry_msgs/Pose", [true, false]),
            ("geometry_msgs/TransformStamped", [true, false]),
            ("tf2_msgs/TFMessage", [false, false]),
            ("geometry_msgs/WrenchStamped", [false, true]),
            ("geometry_msgs/Wrench", [false, true]),
            ("sensor_msgs/JointState", [false, false]),
            ("std_msgs/String", [false, false]),
        ];
        for (name, holds) in cases {
            let schema = schema(name);
            let pose = Locator::<Pose>::find(&schema, "").is_some();
            let wrench = Locator::<Vector3>::find(&schema, "").is_some();
            assert_eq!([pose, wrench], holds, "{name}");
        }
    }

    #[test]
    fn a_field_of_a_larger_message_may_be_named() {
        let text = full_definition("geometry_msgs/PoseStamped");
        let own = "std_msgs/Header header\nint8 mode\ngeometry_msgs/PoseStamped tool\n";
        let pose_part = "===\nMSG: geometry_msgs/PoseStamped\n";
        let schema =
            Schema::parse("a/State", format!("{own}{pose_part}{text}").as_bytes()).unwrap();
        assert!(Locator::<Pose>::find(&schema, "").is_none());
        let within = Locator::<Pose>::find_within(&schema);
        assert_eq!(
            within
                .iter()
                .map(|(path, _)| path.as_str())
                .collect::<Vec<_>>(),
            ["tool"]
        );
        let locator = Locator::<Pose>::find(&schema, "tool").unwrap();
        let [sec, _] = locator.place.stamp.unwrap();
        assert_eq!(sec, [2, 0, 0, 0], "the stamp is that of the field");
    }
}
