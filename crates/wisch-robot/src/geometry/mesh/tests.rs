use super::*;
use proptest::prelude::*;
use std::fmt::Write;

/// Enclosed volume by the divergence theorem [m³]; positive if the triangles face outwards.
fn volume(mesh: &Mesh) -> f64 {
    mesh.corners()
        .map(|[a, b, c]| a.coords.dot(&b.coords.cross(&c.coords)) / 6.0)
        .sum()
}

fn box_mesh() -> Mesh {
    Mesh::cuboid(Vector3::new(0.5, 0.25, 2.0)).expect("sizes are positive")
}

fn ascii_stl(mesh: &Mesh) -> String {
    let mut text = String::from("solid\n");
    for corners in mesh.corners() {
        text += "facet normal 0 0 0\nouter loop\n";
        for p in corners {
            writeln!(text, "vertex {} {} {}", p.x, p.y, p.z).expect("strings take all");
        }
        text += "endloop\nendfacet\n";
    }
    text + "endsolid\n"
}

fn obj(mesh: &Mesh) -> String {
    let mut text = String::from("mtllib no.mtl\no box\n");
    for p in mesh.vertices() {
        writeln!(text, "v {} {} {}", p.x, p.y, p.z).expect("strings take all");
    }
    for [a, b, c] in mesh.triangles() {
        writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1).expect("strings take all");
    }
    text
}

/// Returns a document whose mesh is instanced by the nodes given as XML.
fn collada(mesh: &Mesh, metres_per_unit: f64, nodes: &str) -> String {
    let positions: String = mesh
        .vertices()
        .iter()
        .map(|p| format!("{} {} {} ", p.x, p.y, p.z))
        .collect();
    let indices: String = mesh
        .triangles()
        .iter()
        .flatten()
        .map(|i| format!("{i} 7 "))
        .collect();
    format!(
        r##"<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit name="u" meter="{metres_per_unit}"/><up_axis>Z_UP</up_axis></asset>
  <library_geometries><geometry id="g"><mesh>
    <source id="p"><float_array id="a" count="{}">{positions}</float_array>
      <technique_common><accessor source="#a" count="{}" stride="3">
        <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
      </accessor></technique_common></source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
    <triangles count="{}"><input semantic="VERTEX" source="#v" offset="0"/>
      <input semantic="NORMAL" source="#n" offset="1"/><p>{indices}</p></triangles>
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="s">{nodes}</visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>"##,
        3 * mesh.vertices().len(),
        mesh.vertices().len(),
        mesh.triangles().len(),
    )
}

const PLAIN_NODE: &str = r##"<node><instance_geometry url="#g"/></node>"##;

fn parse(bytes: impl AsRef<[u8]>, format: MeshFormat) -> Result<Mesh, MeshError> {
    Mesh::parse(bytes.as_ref(), format, "box")
}

#[test]
fn primitives_are_closed_and_face_outwards() {
    let (radius, height) = (0.2_f64, 0.7);
    let ball = 4.0 / 3.0 * PI * radius.powi(3);
    let tube = PI * radius * radius * height;
    // Inscribed facets of 256 segments lose about π²/256² of a disc, three times that of a ball.
    for (mesh, expected) in [
        (Mesh::cuboid(Vector3::new(0.2, 0.3, 0.4)), 0.2 * 0.3 * 0.4),
        (Mesh::cylinder(radius, height, 256), tube),
        (Mesh::sphere(radius, 256), ball),
        (Mesh::capsule(radius, height, 256), ball + tube),
    ] {
        let mesh = mesh.expect("sizes are in range");
        assert!(mesh.is_watertight());
        assert!(
            (volume(&mesh) / expected - 1.0).abs() < 1e-3,
            "{} {expected}",
            volume(&mesh)
        );
    }
}

#[test]
fn invalid_sizes_are_refused() {
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 2.0 * MAX_COORDINATE] {
        assert!(Mesh::cuboid(Vector3::new(1.0, bad, 1.0)).is_err());
        assert!(Mesh::sphere(bad, 8).is_err());
        assert!(Mesh::cylinder(1.0, bad, 8).is_err());
        assert!(Mesh::capsule(bad, 1.0, 8).is_err());
    }
    assert_eq!(
        Mesh::sphere(1.0, 2),
        Err(MeshError::Segments { segments: 2 })
    );
    assert_eq!(
        Mesh::sphere(-2.0, 8).unwrap_err().to_string(),
        "radius = -2 m is not above 0 m and at most 10000 m"
    );
}

#[test]
fn a_mesh_says_where_it_is_broken() {
    let point = |x| Point3::new(x, 0.0, 0.0);
    assert_eq!(Mesh::new(vec![point(0.0)], vec![]), Err(MeshError::Empty));
    assert_eq!(
        Mesh::new(vec![point(0.0)], vec![[0, 0, 0], [0, 3, 0]])
            .unwrap_err()
            .to_string(),
        "triangle 1 names vertex 3, but there are 1 vertices (counted from 0)"
    );
    for bad in [f64::NAN, f64::NEG_INFINITY, 1e5] {
        let error = Mesh::new(vec![point(0.0), point(bad)], vec![[0, 1, 0]]).unwrap_err();
        assert_eq!(
            error.to_string(),
            format!("vertex 1: x = {bad} m exceeds the limit of ±10000 m")
        );
    }
}

#[test]
fn moving_and_merging_keep_shape_and_count() {
    let other_from_mesh = Pose::new(Vector3::new(3.0, 0.0, 0.0), Vector3::z() * FRAC_PI_2);
    let both =
        Mesh::merge([box_mesh(), box_mesh().transform(&other_from_mesh)]).expect("few triangles");
    assert!((volume(&both) - 2.0 * volume(&box_mesh())).abs() < 1e-12);
    let (min, max) = both.bounds();
    assert!((min - Point3::new(-0.25, -0.25, -1.0)).norm() < 1e-12);
    assert!((max - Point3::new(3.125, 0.25, 1.0)).norm() < 1e-12);
    assert_eq!(box_mesh().extent(), 2.0);
    assert_eq!(Mesh::merge([]), Err(MeshError::Empty));
}

#[test]
fn clipping_keeps_the_part_above() {
    let area = |soup: &[[Point3; 3]]| -> f64 {
        soup.iter()
            .map(|[a, b, c]| (b - a).cross(&(c - a)).norm() / 2.0)
            .sum()
    };
    let mesh = box_mesh();
    // The walls from 0.5 to 1, and the lid.
    let expected = 0.5 * 2.0 * (0.5 + 0.25) + 0.5 * 0.25;
    assert!((area(&mesh.clip_above(0.5)) - expected).abs() < 1e-12);
    assert_eq!(mesh.clip_above(-1.0).len(), mesh.triangles().len());
    assert!(mesh.clip_above(1.1).is_empty());
}

#[test]
fn an_open_box_is_not_watertight() {
    let mesh = box_mesh();
    let open = Mesh::new(mesh.vertices().to_vec(), mesh.triangles()[1..].to_vec()).expect("valid");
    assert!(!open.is_watertight());
    let mut turned = mesh.triangles().to_vec();
    turned[0].reverse();
    assert!(
        !Mesh::new(mesh.vertices().to_vec(), turned)
            .expect("valid")
            .is_watertight()
    );
}

#[test]
fn all_formats_give_the_same_box() {
    let mesh = box_mesh();
    let mut binary_named_solid = mesh.to_binary_stl();
    binary_named_solid[..6].copy_from_slice(b"solid ");
    let mut with_trailer = mesh.to_binary_stl();
    with_trailer.extend([0; 50]);
    for (bytes, format) in [
        (mesh.to_binary_stl(), MeshFormat::Stl),
        (binary_named_solid, MeshFormat::Stl),
        (with_trailer, MeshFormat::Stl),
        (ascii_stl(&mesh).into_bytes(), MeshFormat::Stl),
        (
            ascii_stl(&mesh)
                .replace("solid", "solid Bürste")
                .into_bytes(),
            MeshFormat::Stl,
        ),
        (
            ascii_stl(&mesh).replace('\n', "\r\n").into_bytes(),
            MeshFormat::Stl,
        ),
        (obj(&mesh).into_bytes(), MeshFormat::Obj),
        (
            collada(&mesh, 1.0, PLAIN_NODE).into_bytes(),
            MeshFormat::Collada,
        ),
    ] {
        let read = parse(bytes, format).expect("the file is valid");
        assert_eq!(read.vertices().len(), 8, "{format:?}");
        assert_eq!(read.triangles().len(), 12);
        assert!(read.is_watertight());
        // All coordinates of this box are exact in f32.
        assert!(read.corners().eq(mesh.corners()), "{format:?}");
    }
}

#[test]
fn several_meshes_in_a_file_become_one() {
    let two = ascii_stl(&box_mesh()) + &ascii_stl(&box_mesh());
    assert_eq!(
        parse(two, MeshFormat::Stl)
            .expect("valid")
            .triangles()
            .len(),
        24
    );
    let nodes = [
        PLAIN_NODE,
        r##"<node><translate>9 0 0</translate><instance_geometry url="#g"/></node>"##,
    ];
    let two = collada(&box_mesh(), 1.0, &nodes.concat());
    let mesh = parse(two, MeshFormat::Collada).expect("valid");
    assert_eq!(mesh.triangles().len(), 24);
    assert_eq!(mesh.bounds().1.x, 9.25);
}

#[test]
fn collada_places_nested_nodes_in_metres() {
    let nodes = r##"
        <node><translate>5 0 1000</translate>
          <node><rotate>0 0 1 90</rotate><scale>2 1 1</scale><instance_node url="#n"/></node>
        </node>
        <node id="n"><matrix>1 0 0 3  0 1 0 0  0 0 1 0  0 0 0 1</matrix>
          <instance_geometry url="#g"/>
        </node>"##;
    let mesh = parse(collada(&box_mesh(), 0.001, nodes), MeshFormat::Collada).expect("valid");
    // The nested box: x within 3 ± 0.25 doubled and turned to y, raised by 1000 mm.
    let nested =
        Mesh::new(mesh.vertices().to_vec(), mesh.triangles()[..12].to_vec()).expect("valid");
    let (min, max) = nested.bounds();
    assert!(
        (min - Point3::new(0.004_875, 0.005_5, 0.999)).norm() < 1e-12,
        "{min}"
    );
    assert!(
        (max - Point3::new(0.005_125, 0.006_5, 1.001)).norm() < 1e-12,
        "{max}"
    );
}

#[test]
fn collada_reads_polygons_strips_and_fans() {
    let square = Mesh::new(
        [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
            .map(|(x, y)| Point3::new(x, y, 0.0))
            .to_vec(),
        vec![[0, 1, 2]],
    )
    .expect("valid");
    let document = collada(&square, 1.0, PLAIN_NODE);
    let normal = r##"<input semantic="NORMAL" source="#n" offset="1"/><p>0 7 1 7 2 7 </p>"##;
    for (element, body) in [
        ("polylist", "<vcount>2 4</vcount><p>0 1 0 1 2 3</p>"),
        ("polygons", "<p>0 1 2 3</p>"),
        ("trifans", "<p>0 1 2 3</p>"),
        ("tristrips", "<p>0 1 3 2</p>"),
    ] {
        let document = document.replace(normal, body).replace("triangles", element);
        let mesh = parse(document, MeshFormat::Collada).expect(element);
        let up: f64 = mesh
            .corners()
            .map(|[a, b, c]| (b - a).cross(&(c - a)).z / 2.0)
            .sum();
        assert_eq!((mesh.triangles().len(), up), (2, 1.0), "{element}");
    }
}

/// The corners of an L, 0.1 m less 0.05 m square [m], from one of them on.
fn l_from(first: usize) -> Vec<[f64; 2]> {
    let l = [[-1, -1], [1, -1], [1, 0], [0, 0], [0, 1], [-1, 1]];
    let turned = (0..6).map(|i| l[(first + i) % 6]);
    turned
        .map(|corner| corner.map(|c| 0.05 * f64::from(c)))
        .collect()
}

/// A pad with a face of six corners below and above, in an OBJ with absolute or relative indices.
fn l_obj(first: usize, is_relative: bool) -> String {
    let mut text = String::from("o pad\n");
    for z in [0.0, 0.03] {
        for [x, y] in l_from(first) {
            writeln!(text, "v {x} {y} {z}").expect("strings take all");
        }
    }
    let index = |i: i32| if is_relative { i - 12 } else { i + 1 };
    let face = |corners: &[i32]| {
        let words = corners.iter().map(|&i| format!(" {}//", index(i)));
        format!("f{}\n", words.collect::<String>())
    };
    text += &face(&[5, 4, 3, 2, 1, 0]);
    text += &face(&[6, 7, 8, 9, 10, 11]);
    for i in 0..6 {
        let next = (i + 1) % 6;
        text += &face(&[i, next, next + 6, i + 6]);
    }
    text
}

/// Returns the pad in COLLADA, as a list of polygons or as single polygons.
fn l_collada(first: usize, element: &str) -> String {
    let flat = l_from(first);
    let vertices = [0.0, 0.03]
        .iter()
        .flat_map(|&z| flat.iter().map(move |&[x, y]| Point3::new(x, y, z)));
    let pad = Mesh::new(vertices.collect(), vec![[0, 1, 2]]).expect("valid");
    let sides = (0..6).map(|i| vec![i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6]);
    let faces: Vec<Vec<usize>> = [vec![5, 4, 3, 2, 1, 0], vec![6, 7, 8, 9, 10, 11]]
        .into_iter()
        .chain(sides)
        .collect();
    let words = |face: &Vec<usize>| face.iter().map(|i| format!("{i} ")).collect::<String>();
    let body = if element == "polygons" {
        let faces = faces.iter().map(|face| format!("<p>{}</p>", words(face)));
        faces.collect::<String>()
    } else {
        let counts: String = faces
            .iter()
            .map(|face| format!("{} ", face.len()))
            .collect();
        let words: String = faces.iter().map(words).collect();
        format!("<vcount>{counts}</vcount><p>{words}</p>")
    };
    let document = collada(&pad, 1.0, PLAIN_NODE);
    let begin = document.find("<triangles").expect("it has triangles");
    let end = document.find("</triangles>").expect("they end") + "</triangles>".len();
    let element = format!(
        r##"<{element} count="8"><input semantic="VERTEX" source="#v" offset="0"/>{body}</{element}>"##
    );
    format!("{}{element}{}", &document[..begin], &document[end..])
}

#[test]
fn a_concave_face_is_the_same_pad_whichever_corner_its_file_begins_with() {
    for first in 0..6 {
        let objs = [false, true].map(|is_relative| (l_obj(first, is_relative), MeshFormat::Obj));
        let colladas = ["polylist", "polygons"]
            .map(|element| (l_collada(first, element), MeshFormat::Collada));
        for (text, format) in objs.into_iter().chain(colladas) {
            let mesh = parse(text, format).expect("valid");
            assert!(mesh.is_watertight());
            // OBJ is read in single precision.
            assert!(
                (volume(&mesh) - 0.000_225).abs() < 1e-9,
                "{}",
                volume(&mesh)
            );
            let footprint = crate::geometry::footprint(&mesh, 0.005).expect("it has one");
            assert!(
                (footprint.area() - 0.0075).abs() < 1e-8,
                "{first} {format:?}"
            );
        }
    }
}

#[test]
fn faults_name_mesh_place_and_limit() {
    let stl = box_mesh().to_binary_stl();
    let mut endless = stl.clone();
    endless[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    let document = collada(&box_mesh(), 1.0, PLAIN_NODE);
    let cyclic = r##"<node id="n"><instance_node url="#n"/></node>"##;
    let doubling: String = (0..60)
        .map(|i| format!(r##"<node id="n{i}"><instance_node url="#n{0}"/><instance_node url="#n{0}"/></node>"##, i + 1))
        .chain([r##"<node id="n60"/>"##.to_owned()])
        .collect();
    let names = r##"<source id="w"><Name_array id="x" count="4000000000">a b</Name_array></source><vertices"##;
    let mut fewer = stl.clone();
    fewer[80..84].copy_from_slice(&10_u32.to_le_bytes());
    let cases: [(Vec<u8>, MeshFormat, &str); 17] = [
        (
            stl[..300].to_vec(),
            MeshFormat::Stl,
            "announces 12 triangles, but its 300 bytes have room for 4",
        ),
        (endless, MeshFormat::Stl, "announces 4294967295 triangles"),
        (
            fewer,
            MeshFormat::Stl,
            "announces 10 triangles, but its 684 bytes have room for 12",
        ),
        (b"solid".to_vec(), MeshFormat::Stl, ""),
        (vec![], MeshFormat::Stl, "0 bytes"),
        (b"\xff\xfef\0".to_vec(), MeshFormat::Obj, "UTF-16"),
        (
            b"solid\nfacet normal 0 0 x".to_vec(),
            MeshFormat::Stl,
            "(2:18)",
        ),
        (
            b"v 0 0 0\nf 1 2 3".to_vec(),
            MeshFormat::Obj,
            "line 2: vertex 3 is not among the 1 of the file",
        ),
        (b"v 0 nan 0\nf 1 1 1".to_vec(), MeshFormat::Obj, "y = NaN m"),
        (
            b"v 0 0 0\nv 1 0\n".to_vec(),
            MeshFormat::Obj,
            "line 2: a vertex has at least 3 numbers, and this one has 2",
        ),
        (
            b"v 0 0 0 \\\n 1\nf 1 x 1\n".to_vec(),
            MeshFormat::Obj,
            "line 3: \"x\" is no corner of a face",
        ),
        (
            b"# a log\ntime,x,y,z\n".to_vec(),
            MeshFormat::Obj,
            "line 2: \"time,x,y,z\" is no keyword of OBJ",
        ),
        (
            b"".to_vec(),
            MeshFormat::Collada,
            "line 1: there is no XML element",
        ),
        (
            document.replace("count=\"8\"", "count=\"9\"").into(),
            MeshFormat::Collada,
            "room for 8",
        ),
        (
            collada(&box_mesh(), -1.0, PLAIN_NODE).into(),
            MeshFormat::Collada,
            "line 3: <unit>: meter=\"-1\"",
        ),
        (
            collada(&box_mesh(), 1.0, cyclic).into(),
            MeshFormat::Collada,
            "64 deep",
        ),
        (
            collada(&box_mesh(), 1.0, &doubling).into(),
            MeshFormat::Collada,
            "100001 nodes exceed the limit of 100000",
        ),
    ];
    for (bytes, format, expected) in cases {
        let message = parse(&bytes, format).unwrap_err().to_string();
        assert!(message.starts_with("mesh \"box\": "), "{message}");
        assert!(message.contains(expected), "{message}\nlacks {expected}");
    }
    // mesh-loader 0.1.13 would not return from this one; positions do not need the names.
    assert!(parse(document.replace("<vertices", names), MeshFormat::Collada).is_ok());
}

/// Two triangles of a square in valid files that some readers refuse.
#[test]
fn valid_files_of_any_writer_are_read() {
    let square = [
        "v 0 0 0\nv 2 0 0 # origin\nv 2 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1//1 2//1 3//1\nf 1/1/1 3/1/1 4/1/1\n",
        "v 0 0 0\r\nv 2 0 0\r\nv 2 1 0\r\nv 0 1 0\r\nf 1 2 \\\r\n  3 4 # quad\r\n",
        "f 1 2 3\nv 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 3 4 \\",
        "\u{feff}o a\nv 0 0 0\nv 2 0 0\nv 2 1 0\no b\nv 0 1 0\nf -4 -3 -2\nf 1 3 4\n",
    ];
    for text in square {
        let mesh = parse(text.as_bytes(), MeshFormat::Obj).unwrap();
        assert_eq!((mesh.vertices().len(), mesh.triangles().len()), (4, 2));
    }
    let stl = ascii_stl(&box_mesh());
    let upper = parse(stl.to_uppercase().as_bytes(), MeshFormat::Stl).unwrap();
    assert_eq!(upper, parse(stl.as_bytes(), MeshFormat::Stl).unwrap());
}

/// Bytes that resemble a file: a valid one with some bytes replaced, cut out or doubled.
fn mutated() -> impl Strategy<Value = (Vec<u8>, MeshFormat)> {
    let mesh = box_mesh();
    let files = vec![
        (mesh.to_binary_stl(), MeshFormat::Stl),
        (ascii_stl(&mesh).into_bytes(), MeshFormat::Stl),
        (obj(&mesh).into_bytes(), MeshFormat::Obj),
        (b"v 1 2 3 1 0 0\nv 1 2 4 .5\nvt 0 0\nvn 0 0 1\ng a b\nusemtl c\nf 1/1/1 -1//1 2/1\nf 1 2 1 2 1\n".to_vec(), MeshFormat::Obj),
        (collada(&mesh, 1.0, PLAIN_NODE).into_bytes(), MeshFormat::Collada),
        (b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0 1 0 0 0 1 0\n3 0 1 2\n".to_vec(), MeshFormat::Ply),
        ([&b"ply\nformat binary_big_endian 1.0\nelement vertex 1\nproperty uchar x\nproperty uchar y\nproperty char z\nelement face 1\nproperty list uchar uchar vertex_index\nend_header\n"[..], &[1, 2, 3, 3, 0, 0, 0]].concat(), MeshFormat::Ply),
    ];
    let edit = (
        any::<prop::sample::Index>(),
        0..24usize,
        prop_oneof![
            prop::collection::vec(any::<u8>(), 0..4),
            prop::collection::vec(
                prop::sample::select(b"0123456789 -+.eE/<>=\"#\n\rvfgnsolid".to_vec()),
                0..12
            ),
            Just(b"4294967295".to_vec()),
            Just(b"-2147483648".to_vec()),
        ],
    );
    (
        prop::sample::select(files),
        prop::collection::vec(edit, 0..6),
    )
        .prop_map(|((mut bytes, format), edits)| {
            for (at, removed, inserted) in edits {
                let start = at.index(bytes.len() + 1);
                let end = (start + removed).min(bytes.len());
                bytes.splice(start..end, inserted);
            }
            (bytes, format)
        })
}

proptest! {
    #[test]
    fn no_bytes_make_the_reader_panic(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        for format in [MeshFormat::Stl, MeshFormat::Obj, MeshFormat::Collada, MeshFormat::Ply] {
            let _ = parse(&bytes, format);
            let _ = parse([b"solid a\nfacet normal ", &bytes[..]].concat(), format);
            let _ = parse([b"v 0 0 0\nf 1 ", &bytes[..]].concat(), format);
            let _ = parse([b"<COLLADA><a b='", &bytes[..]].concat(), format);
        }
    }

    #[test]
    fn no_damage_makes_the_reader_panic((bytes, format) in mutated()) {
        if let Ok(mesh) = parse(&bytes, format) {
            let (vertices, triangles) = (mesh.vertices().to_vec(), mesh.triangles().to_vec());
            prop_assert!(Mesh::new(vertices, triangles).is_ok());
            prop_assert!(triangles_fit(&mesh, bytes.len()));
        }
    }

    #[test]
    fn a_mesh_survives_its_own_stl(x in 0.01..9.0f32, y in 0.01..9.0f32, z in 0.01..9.0f32) {
        let size = Vector3::new(x.into(), y.into(), z.into());
        let mesh = Mesh::cuboid(size).expect("sizes are positive");
        let read = parse(mesh.to_binary_stl(), MeshFormat::Stl).expect("our own file");
        prop_assert!(read.corners().eq(mesh.corners()));
    }
}

/// Every valid file above takes at least two bytes per triangle (only nodes that are instanced repeatedly in COLLADA
/// could take less), so memory stays in proportion to the file.
fn triangles_fit(mesh: &Mesh, bytes: usize) -> bool {
    2 * mesh.triangles().len() <= bytes
}
