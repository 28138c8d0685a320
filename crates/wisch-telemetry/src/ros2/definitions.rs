//! ROS 2 message definitions that a bag carries, as of Humble and later.

/// A message type and its own fields, without the definitions of nested types.
type Definition = (&'static str, &'static str);

const DEFINITIONS: &[Definition] = &[
    ("builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"),
    ("builtin_interfaces/Duration", "int32 sec\nuint32 nanosec\n"),
    (
        "std_msgs/Header",
        "builtin_interfaces/Time stamp\nstring frame_id\n",
    ),
    ("std_msgs/String", "string data\n"),
    (
        "sensor_msgs/TimeReference",
        "std_msgs/Header header\nbuiltin_interfaces/Time time_ref\nstring source\n",
    ),
    (
        "std_msgs/ColorRGBA",
        "float32 r\nfloat32 g\nfloat32 b\nfloat32 a\n",
    ),
    ("geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"),
    ("geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n"),
    (
        "geometry_msgs/Quaternion",
        "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n",
    ),
    (
        "geometry_msgs/Pose",
        "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n",
    ),
    (
        "geometry_msgs/PoseStamped",
        "std_msgs/Header header\ngeometry_msgs/Pose pose\n",
    ),
    (
        "geometry_msgs/Transform",
        "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n",
    ),
    (
        "geometry_msgs/TransformStamped",
        "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n",
    ),
    (
        "geometry_msgs/Wrench",
        "geometry_msgs/Vector3 force\ngeometry_msgs/Vector3 torque\n",
    ),
    (
        "geometry_msgs/WrenchStamped",
        "std_msgs/Header header\ngeometry_msgs/Wrench wrench\n",
    ),
    (
        "tf2_msgs/TFMessage",
        "geometry_msgs/TransformStamped[] transforms\n",
    ),
    (
        "sensor_msgs/JointState",
        "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n",
    ),
    (
        "sensor_msgs/PointField",
        "uint8 INT8=1\nuint8 UINT8=2\nuint8 INT16=3\nuint8 UINT16=4\nuint8 INT32=5\nuint8 UINT32=6\nuint8 FLOAT32=7\nuint8 FLOAT64=8\nstring name\nuint32 offset\nuint8 datatype\nuint32 count\n",
    ),
    (
        "sensor_msgs/PointCloud2",
        "std_msgs/Header header\nuint32 height\nuint32 width\nsensor_msgs/PointField[] fields\nbool is_bigendian\nuint32 point_step\nuint32 row_step\nuint8[] data\nbool is_dense\n",
    ),
    ("geometry_msgs/Point32", "float32 x\nfloat32 y\nfloat32 z\n"),
    ("geometry_msgs/Polygon", "geometry_msgs/Point32[] points\n"),
    (
        "geometry_msgs/PolygonStamped",
        "std_msgs/Header header\ngeometry_msgs/Polygon polygon\n",
    ),
    (
        "sensor_msgs/CompressedImage",
        "std_msgs/Header header\nstring format\nuint8[] data\n",
    ),
    ("visualization_msgs/UVCoordinate", "float32 u\nfloat32 v\n"),
    (
        "visualization_msgs/MeshFile",
        "string filename\nuint8[] data\n",
    ),
    (
        "visualization_msgs/Marker",
        "\
int32 ARROW=0
int32 CUBE=1
int32 SPHERE=2
int32 CYLINDER=3
int32 LINE_STRIP=4
int32 LINE_LIST=5
int32 CUBE_LIST=6
int32 SPHERE_LIST=7
int32 POINTS=8
int32 TEXT_VIEW_FACING=9
int32 MESH_RESOURCE=10
int32 TRIANGLE_LIST=11
int32 ADD=0
int32 MODIFY=0
int32 DELETE=2
int32 DELETEALL=3
std_msgs/Header header
string ns
int32 id
int32 type
int32 action
geometry_msgs/Pose pose
geometry_msgs/Vector3 scale
std_msgs/ColorRGBA color
builtin_interfaces/Duration lifetime
bool frame_locked
geometry_msgs/Point[] points
std_msgs/ColorRGBA[] colors
string texture_resource
sensor_msgs/CompressedImage texture
visualization_msgs/UVCoordinate[] uv_coordinates
string text
string mesh_resource
visualization_msgs/MeshFile mesh_file
bool mesh_use_embedded_materials
",
    ),
    (
        "visualization_msgs/MarkerArray",
        "visualization_msgs/Marker[] markers\n",
    ),
];

/// Separator between the definitions of a type and of its nested types.
const SEPARATOR: &str =
    "================================================================================\n";

/// Whether a line separates definitions.
pub(crate) fn is_separator(line: &str) -> bool {
    line.starts_with("===") && line.bytes().all(|byte| byte == b'=')
}

/// Returns the text of a schema with encoding `ros2msg`: the type's fields, then those of every nested type, each once.
///
/// A type outside the table above has no fields.
pub(crate) fn full_definition(name: &str) -> String {
    let mut text = own_fields(name).to_owned();
    let mut written = vec![name];
    let mut open = nested_types(own_fields(name));
    while !open.is_empty() {
        let name = open.remove(0);
        if written.contains(&name) {
            continue;
        }
        text += &format!("{SEPARATOR}MSG: {name}\n{}", own_fields(name));
        written.push(name);
        open.extend(nested_types(own_fields(name)));
    }
    text
}

fn own_fields(name: &str) -> &'static str {
    DEFINITIONS
        .iter()
        .find(|(known, _)| *known == name)
        .map_or("", |(_, fields)| fields)
}

/// Returns the nested types with a package in some fields, in order.
fn nested_types(fields: &'static str) -> Vec<&'static str> {
    fields
        .lines()
        .filter_map(|line| line.split(' ').next())
        .map(|kind| kind.trim_end_matches("[]"))
        .filter(|kind| kind.contains('/'))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_nested_types_are_in_the_table() {
        for (name, fields) in DEFINITIONS {
            assert!(!fields.is_empty(), "{name}");
            for part in nested_types(fields) {
                assert!(!own_fields(part).is_empty(), "{part} in {name}");
            }
        }
    }

    #[test]
    fn a_type_that_is_used_twice_is_defined_once() {
        let text = full_definition("geometry_msgs/WrenchStamped");
        assert_eq!(text.matches("MSG: geometry_msgs/Vector3\n").count(), 1);
        assert_eq!(text.matches("MSG: ").count(), 4);
        assert!(text.starts_with("std_msgs/Header header\ngeometry_msgs/Wrench wrench\n==="));
    }
}
