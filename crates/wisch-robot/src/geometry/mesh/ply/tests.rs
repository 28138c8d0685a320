use super::super::{Mesh, MeshError, MeshFormat, Vector3};

fn box_mesh() -> Mesh {
    Mesh::cuboid(Vector3::new(0.5, 0.25, 2.0)).unwrap()
}

/// Returns a header and the rows of a mesh, with a colour and a normal of each vertex and an element between.
fn ply(mesh: &Mesh, format: &str, end: &str) -> Vec<u8> {
    let header = [
        "ply".to_owned(),
        format!("format {format} 1.0"),
        "comment made here".to_owned(),
        format!("element vertex {}", mesh.vertices().len()),
        "property uchar red".to_owned(),
        "property float x".to_owned(),
        "property double y".to_owned(),
        "property float32 z".to_owned(),
        "element camera 1".to_owned(),
        "property list uchar short view".to_owned(),
        format!("element face {}", mesh.triangles().len()),
        "property int flags".to_owned(),
        "property list uint8 int32 vertex_indices".to_owned(),
        "end_header".to_owned(),
    ];
    let mut bytes: Vec<u8> = header
        .iter()
        .flat_map(|line| format!("{line}{end}").into_bytes())
        .collect();
    let is_big = format == "binary_big_endian";
    let mut put = |mut little: Vec<u8>| {
        if is_big {
            little.reverse();
        }
        bytes.extend(little);
    };
    if format == "ascii" {
        let mut text = String::new();
        for p in mesh.vertices() {
            text += &format!("7 {} {} {}{end}", p.x, p.y, p.z);
        }
        text += &format!("2 -3 4{end}");
        for [a, b, c] in mesh.triangles() {
            text += &format!("-1 3 {a} {b} {c}{end}");
        }
        bytes.extend(text.into_bytes());
        return bytes;
    }
    for p in mesh.vertices() {
        put(vec![7]);
        put((p.x as f32).to_le_bytes().to_vec());
        put(p.y.to_le_bytes().to_vec());
        put((p.z as f32).to_le_bytes().to_vec());
    }
    put(vec![2]);
    put((-3i16).to_le_bytes().to_vec());
    put(4i16.to_le_bytes().to_vec());
    for triangle in mesh.triangles() {
        put((-1i32).to_le_bytes().to_vec());
        put(vec![3]);
        triangle.iter().for_each(|i| put(i.to_le_bytes().to_vec()));
    }
    bytes
}

fn parse(bytes: &[u8]) -> Result<Mesh, MeshError> {
    Mesh::parse(bytes, MeshFormat::Ply, "box")
}

#[test]
fn text_and_both_byte_orders_give_the_same_mesh() {
    // A later vertex of the cuboid may come first in a triangle: the reader numbers vertices by their first use.
    let expected = parse(&ply(&box_mesh(), "ascii", "\n")).unwrap();
    assert_eq!(expected.triangles().len(), 12);
    assert!(expected.is_watertight());
    for format in ["ascii", "binary_little_endian", "binary_big_endian"] {
        for end in ["\n", "\r\n", "\r"] {
            let found = parse(&ply(&box_mesh(), format, end)).unwrap();
            assert_eq!(found, expected, "{format} {end:?}");
        }
    }
}

#[test]
fn faces_of_more_corners_are_cut() {
    // An arrow with a notch at its second corner: a fan about the first would cover the notch.
    let text = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n\
        element face 1\nproperty list uchar int vertex_index\nend_header\n\
        0 0 0\n0.5 0.2 0\n1 0 0\n1 1 0\n0 1 0\n5 0 1 2 3 4\n";
    let mesh = parse(text.as_bytes()).unwrap();
    let area: f64 = mesh
        .corners()
        .map(|[a, b, c]| (b - a).cross(&(c - a)).z / 2.0)
        .sum();
    assert_eq!(mesh.triangles().len(), 3);
    assert!((area - 0.9).abs() < 1e-6, "{area}");
    assert!(
        mesh.corners()
            .all(|[a, b, c]| (b - a).cross(&(c - a)).z > 0.0)
    );
}

#[test]
fn a_broken_file_says_where() {
    let text = String::from_utf8(ply(&box_mesh(), "ascii", "\n")).unwrap();
    let binary = ply(&box_mesh(), "binary_little_endian", "\n");
    let cloud = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n1 1 1\n";
    let replaced = |from: &str, to: &str| text.replacen(from, to, 1).into_bytes();
    for (bytes, expected) in [
        (
            b"solid".to_vec(),
            "line 1: the header has no line \"end_header\"",
        ),
        (b"solid\n".to_vec(), "line 1: the first line is not \"ply\""),
        (
            replaced("format ascii 1.0", "format ascii2 1.0"),
            "line 2: format \"ascii2\" is not ascii",
        ),
        (
            replaced("format ascii 1.0\n", ""),
            "the header has no line \"format\"",
        ),
        (
            replaced("vertex 8", "vertex -8"),
            "line 4: \"-8\" is not a number of rows",
        ),
        (
            replaced("property float x", "property real x"),
            "line 6: \"real\" is not a type",
        ),
        (
            replaced("property float x", "property float u"),
            "element \"vertex\" has no property \"x\"",
        ),
        (
            replaced("vertex_indices", "corners"),
            "element \"face\" has no list \"vertex_indices\"",
        ),
        (
            replaced("list uint8 int32", "list float int32"),
            "line 13: the length of a list is not an integer type",
        ),
        (
            replaced("element face 12", "element face 99999999"),
            "announces 99999999 rows of element \"face\"",
        ),
        (
            replaced("element face 12", "element face 13"),
            "the file ends in row 12 of element \"face\"",
        ),
        (
            replaced("-1 3 0", "-1 3 8"),
            "face 0 names vertex 8, but there are 8 vertices",
        ),
        (replaced("-1 3 0", "-1 3 0.5"), "face 0 names vertex 0.5"),
        (
            replaced("-1 3 0", "-1 20000 0"),
            "has 20000 entries, the limit is 10000",
        ),
        (
            replaced("7 -0.25", "7 x"),
            "line 15: \"x\" in row 0 of element \"vertex\" is not a number",
        ),
        (replaced("7 -0.25", "7 nan"), "vertex 0: x = NaN m exceeds"),
        (
            cloud.into(),
            "it has points and no face (number of points: 2): a point cloud has to be meshed first",
        ),
        (
            binary[..binary.len() - 1].to_vec(),
            "the file ends in row 11 of element \"face\"",
        ),
    ] {
        let message = parse(&bytes).unwrap_err().to_string();
        assert!(message.contains(expected), "{message}\n{expected}");
    }
}
