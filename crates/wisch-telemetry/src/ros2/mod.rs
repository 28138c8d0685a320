//! ROS 2 messages: their definitions, their CDR layout, and a decoder for messages of any type.

mod definitions;
pub(crate) mod messages;
mod schema;
mod walk;

pub(crate) use definitions::full_definition;
pub(crate) use messages::NANOSECONDS_PER_SECOND;
pub use schema::SchemaError;
pub(crate) use schema::{Field, Kind, Schema, Shape};
pub use walk::MessageError;
pub(crate) use walk::{Value, decode};
