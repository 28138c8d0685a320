//! ROS 2 messages that a bag is written with, in CDR layout: fields are in the order of their definitions.

use serde::{Deserialize, Serialize};
use wisch::control;
use wisch::geometry::{self, Vector3 as Vector};

/// `builtin_interfaces/Time`, also used for a duration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Time {
    pub sec: i32,
    pub nanosec: u32,
}

impl Time {
    /// Zero; as the lifetime of a marker, for ever.
    pub const ZERO: Self = Self { sec: 0, nanosec: 0 };

    /// Converts nanoseconds; times beyond the range of a message (2038) are clamped.
    pub fn from_nanoseconds(time: u64) -> Self {
        Self {
            sec: i32::try_from(time / NANOSECONDS_PER_SECOND).unwrap_or(i32::MAX),
            nanosec: (time % NANOSECONDS_PER_SECOND) as u32,
        }
    }
}

/// Nanoseconds in a second.
pub(crate) const NANOSECONDS_PER_SECOND: u64 = 1_000_000_000;

/// `std_msgs/Header`.
#[derive(Debug, Clone, Copy, Serialize)]
pub(crate) struct Header<'a> {
    pub stamp: Time,
    pub frame_id: &'a str,
}

/// `sensor_msgs/JointState`.
#[derive(Debug, Serialize)]
pub(crate) struct JointState<'a> {
    pub header: Header<'a>,
    pub name: &'a [String],
    pub position: &'a [f64],
    pub velocity: &'a [f64],
    pub effort: &'a [f64],
}

/// `geometry_msgs/Vector3`; a point has the same layout.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct Vector3 {
    pub x: f64,
    pub y: f64,
    pub z: f64,
}

impl From<Vector> for Vector3 {
    fn from(v: Vector) -> Self {
        Self {
            x: v.x,
            y: v.y,
            z: v.z,
        }
    }
}

/// `geometry_msgs/Quaternion`.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct Quaternion {
    pub x: f64,
    pub y: f64,
    pub z: f64,
    pub w: f64,
}

/// `geometry_msgs/Pose`; a transform has the same layout.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct Pose {
    pub position: Vector3,
    pub orientation: Quaternion,
}

impl From<&geometry::Pose> for Pose {
    fn from(pose: &geometry::Pose) -> Self {
        let q = pose.rotation.coords;
        Self {
            position: pose.translation.vector.into(),
            orientation: Quaternion {
                x: q.x,
                y: q.y,
                z: q.z,
                w: q.w,
            },
        }
    }
}

/// `geometry_msgs/PoseStamped`.
#[derive(Debug, Serialize)]
pub(crate) struct PoseStamped<'a> {
    pub header: Header<'a>,
    pub pose: Pose,
}

/// `geometry_msgs/Wrench`.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(crate) struct Wrench {
    pub force: Vector3,
    pub torque: Vector3,
}

impl From<&control::Wrench> for Wrench {
    fn from(wrench: &control::Wrench) -> Self {
        Self {
            force: wrench.force.into(),
            torque: wrench.moment.into(),
        }
    }
}

impl From<Vector3> for Vector {
    fn from(v: Vector3) -> Self {
        Self::new(v.x, v.y, v.z)
    }
}

impl From<Pose> for geometry::Pose {
    /// Takes the quaternion as it is: normalisation would change its bits.
    fn from(pose: Pose) -> Self {
        let q = pose.orientation;
        let rotation = nalgebra::Quaternion::new(q.w, q.x, q.y, q.z);
        Self::from_parts(
            Vector::from(pose.position).into(),
            nalgebra::UnitQuaternion::new_unchecked(rotation),
        )
    }
}

impl From<Wrench> for control::Wrench {
    fn from(wrench: Wrench) -> Self {
        Self {
            force: wrench.force.into(),
            moment: wrench.torque.into(),
        }
    }
}

/// `geometry_msgs/WrenchStamped`.
#[derive(Debug, Serialize)]
pub(crate) struct WrenchStamped<'a> {
    pub header: Header<'a>,
    pub wrench: Wrench,
}

/// `geometry_msgs/TransformStamped`.
#[derive(Debug, Serialize)]
pub(crate) struct TransformStamped<'a> {
    pub header: Header<'a>,
    pub child_frame_id: &'a str,
    pub transform: Pose,
}

/// `tf2_msgs/TFMessage`.
#[derive(Debug, Serialize)]
pub(crate) struct TfMessage<'a> {
    pub transforms: &'a [TransformStamped<'a>],
}

/// `sensor_msgs/TimeReference`.
#[derive(Debug, Serialize)]
pub(crate) struct TimeReference<'a> {
    pub header: Header<'a>,
    pub time_ref: Time,
    pub source: &'a str,
}

/// `sensor_msgs/TimeReference`, as it is read.
#[derive(Debug, Deserialize)]
pub(crate) struct RecordedTimeReference {
    #[serde(rename = "header")]
    _header: OwnedHeader,
    pub time_ref: Time,
    pub source: String,
}

/// `std_msgs/String`, as it is read.
#[derive(Debug, Deserialize)]
pub(crate) struct RecordedText {
    pub data: String,
}

/// `std_msgs/String`.
#[derive(Debug, Serialize)]
pub(crate) struct Text<'a> {
    pub data: &'a str,
}

/// `std_msgs/ColorRGBA`.
#[derive(Debug, Clone, Copy, Serialize)]
pub(crate) struct Color {
    pub r: f32,
    pub g: f32,
    pub b: f32,
    pub a: f32,
}

/// `sensor_msgs/CompressedImage`, always empty: the texture of a marker without texture.
#[derive(Debug, Serialize)]
pub(crate) struct NoImage<'a> {
    pub header: Header<'a>,
    pub format: &'a str,
    pub data: &'a [u8],
}

/// `visualization_msgs/MeshFile`, always empty.
#[derive(Debug, Serialize)]
pub(crate) struct NoMesh<'a> {
    pub filename: &'a str,
    pub data: &'a [u8],
}

/// `visualization_msgs/Marker`.
#[derive(Debug, Serialize)]
pub(crate) struct Marker<'a> {
    pub header: Header<'a>,
    pub ns: &'a str,
    pub id: i32,
    pub kind: i32,
    pub action: i32,
    pub pose: Pose,
    pub scale: Vector3,
    pub color: Color,
    pub lifetime: Time,
    pub frame_locked: bool,
    pub points: &'a [Vector3],
    pub colors: &'a [Color],
    pub texture_resource: &'a str,
    pub texture: NoImage<'a>,
    pub uv_coordinates: &'a [[f32; 2]],
    pub text: &'a str,
    pub mesh_resource: &'a str,
    pub mesh_file: NoMesh<'a>,
    pub mesh_use_embedded_materials: bool,
}

/// `Marker::kind`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum MarkerKind {
    /// From the first point to the second.
    Arrow = 0,
    LineStrip = 4,
    Points = 8,
    /// Three points each.
    TriangleList = 11,
}

/// `Marker::action` that deletes a marker.
pub(crate) const MARKER_DELETE: i32 = 2;

impl<'a> Marker<'a> {
    /// Returns a permanent marker at the origin of its frame, with time, frame, name, scale, colour, and the points
    /// that draw it.
    pub fn new(
        (stamp, frame_id): (Time, &'a str),
        (ns, id): (&'a str, i32),
        kind: MarkerKind,
        (scale, color): (Vector3, Color),
        points: &'a [Vector3],
    ) -> Self {
        Self {
            header: Header { stamp, frame_id },
            ns,
            id,
            kind: kind as i32,
            action: 0,
            pose: (&geometry::Pose::identity()).into(),
            scale,
            color,
            lifetime: Time::ZERO,
            frame_locked: false,
            points,
            colors: &[],
            texture_resource: "",
            texture: NoImage {
                header: Header {
                    stamp: Time::ZERO,
                    frame_id: "",
                },
                format: "",
                data: &[],
            },
            uv_coordinates: &[],
            text: "",
            mesh_resource: "",
            mesh_file: NoMesh {
                filename: "",
                data: &[],
            },
            mesh_use_embedded_materials: false,
        }
    }
}

/// `visualization_msgs/MarkerArray`.
#[derive(Debug, Serialize)]
pub(crate) struct MarkerArray<'a> {
    pub markers: &'a [Marker<'a>],
}

/// `sensor_msgs/PointField`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct PointField {
    pub name: String,
    pub offset: u32,
    pub datatype: u8,
    pub count: u32,
}

/// `PointField::datatype` of numbers of four and of eight bytes.
pub(crate) const FIELD_FLOAT32: u8 = 7;
pub(crate) const FIELD_FLOAT64: u8 = 8;

/// `std_msgs/Header`, as it is read.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct OwnedHeader {
    pub stamp: Time,
    pub frame_id: String,
}

/// `sensor_msgs/JointState`, as it is read.
#[derive(Debug, Deserialize)]
pub(crate) struct RecordedJointState {
    #[serde(rename = "header")]
    _header: OwnedHeader,
    #[serde(rename = "name")]
    _name: Vec<String>,
    pub position: Vec<f64>,
    pub velocity: Vec<f64>,
    pub effort: Vec<f64>,
}

/// `geometry_msgs/PoseStamped`, as it is read.
#[derive(Debug, Deserialize)]
pub(crate) struct RecordedPose {
    #[serde(rename = "header")]
    _header: OwnedHeader,
    pub pose: Pose,
}

/// `geometry_msgs/WrenchStamped`, as it is read.
#[derive(Debug, Deserialize)]
pub(crate) struct RecordedWrench {
    #[serde(rename = "header")]
    _header: OwnedHeader,
    pub wrench: Wrench,
}

/// `sensor_msgs/PointCloud2`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct PointCloud2 {
    pub header: OwnedHeader,
    pub height: u32,
    pub width: u32,
    pub fields: Vec<PointField>,
    pub is_bigendian: bool,
    pub point_step: u32,
    pub row_step: u32,
    pub data: Vec<u8>,
    pub is_dense: bool,
}

/// `geometry_msgs/Point32`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct Point32 {
    pub x: f32,
    pub y: f32,
    pub z: f32,
}

/// `geometry_msgs/PolygonStamped`; the polygon has the layout of its list of points.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct PolygonStamped {
    pub header: OwnedHeader,
    pub points: Vec<Point32>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn time_is_split_into_seconds_and_the_rest() {
        let time = Time::from_nanoseconds(3_000_000_007);
        assert_eq!(time, Time { sec: 3, nanosec: 7 });
        assert_eq!(Time::from_nanoseconds(u64::MAX).sec, i32::MAX);
    }
}
