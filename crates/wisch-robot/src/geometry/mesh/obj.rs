//! Wavefront OBJ: its vertices and faces. Texture coordinates, normals, groups, materials, lines and curves are left out.

use super::{MAX_TRIANGLES, Mesh, MeshError, Point3};
use crate::geometry::triangulation::cut_face;

/// Keywords of the format whose lines hold neither vertices nor faces.
const OTHER_KEYWORDS: [&str; 44] = [
    "vt",
    "vn",
    "vp",
    "g",
    "o",
    "s",
    "mg",
    "usemtl",
    "mtllib",
    "p",
    "l",
    "deg",
    "bmat",
    "step",
    "cstype",
    "curv",
    "curv2",
    "surf",
    "parm",
    "trim",
    "hole",
    "scrv",
    "sp",
    "end",
    "con",
    "bevel",
    "c_interp",
    "d_interp",
    "lod",
    "maplib",
    "usemap",
    "shadow_obj",
    "trace_obj",
    "ctech",
    "stech",
    "call",
    "csh",
    "fo",
    "vw",
    "bsp",
    "bzp",
    "cdc",
    "cdp",
    "res",
];

/// Reads a mesh, in the unit of the file. Faces of more than three corners are cut into triangles.
pub(super) fn parse(bytes: &[u8]) -> Result<Mesh, MeshError> {
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        let reason = "UTF-16 is not supported, save it as UTF-8".to_owned();
        return Err(MeshError::Syntax { reason });
    }
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let mut vertices: Vec<Point3> = Vec::new();
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    // Text of a line that continues on the next one, and the number of its first line.
    let mut continued: Option<(usize, String)> = None;
    let lines = bytes.split(|byte| *byte == b'\n').enumerate();
    for (number, line) in lines.flat_map(|(i, line)| {
        let line = line.strip_suffix(b"\r").unwrap_or(line);
        // Some programs end lines with a carriage return alone.
        line.split(|byte| *byte == b'\r')
            .map(move |line| (i + 1, line))
    }) {
        let line = String::from_utf8_lossy(line);
        let text = line.split('#').next().unwrap_or_default().trim_end();
        let (first, mut whole) = continued.take().unwrap_or((number, String::new()));
        if let Some(begin) = text.strip_suffix('\\') {
            whole.push_str(begin);
            whole.push(' ');
            continued = Some((first, whole));
            continue;
        }
        whole.push_str(text);
        read_line(&whole, &mut vertices, &mut triangles).map_err(|fault| match fault {
            LineFault::Syntax(reason) => MeshError::Syntax {
                reason: format!("line {first}: {reason}"),
            },
            LineFault::TooMany(count) => MeshError::TooManyTriangles { count },
        })?;
    }
    Mesh::new(vertices, triangles)
}

/// Why a line cannot be read.
enum LineFault {
    Syntax(String),
    /// The triangles so far exceed the limit; their number.
    TooMany(usize),
}

fn read_line(
    line: &str,
    vertices: &mut Vec<Point3>,
    triangles: &mut Vec<[u32; 3]>,
) -> Result<(), LineFault> {
    let mut words = line.split_ascii_whitespace();
    match words.next() {
        None => {}
        Some("v") => vertices.push(read_vertex(words).map_err(LineFault::Syntax)?),
        Some("f") => {
            let corners = words.map(|word| find_vertex(word, vertices.len()));
            let corners: Vec<usize> = corners
                .collect::<Result<_, _>>()
                .map_err(LineFault::Syntax)?;
            if corners.len() < 3 {
                let count = corners.len();
                let reason = format!("a face has at least 3 corners, and this one has {count}");
                return Err(LineFault::Syntax(reason));
            }
            let count = triangles.len() + corners.len() - 2;
            if count > MAX_TRIANGLES {
                return Err(LineFault::TooMany(count));
            }
            let places: Vec<Point3> = corners.iter().map(|&at| vertices[at]).collect();
            let cut = cut_face(&places);
            triangles.extend(cut.iter().map(|three| three.map(|k| corners[k] as u32)));
        }
        Some(other) if OTHER_KEYWORDS.contains(&other) => {}
        Some(other) => {
            let shown: String = other.chars().take(20).collect();
            return Err(LineFault::Syntax(format!("{shown:?} is no keyword of OBJ")));
        }
    }
    Ok(())
}

/// Reads a vertex, which is homogeneous if it has four numbers. More numbers are its colour.
fn read_vertex<'a>(words: impl Iterator<Item = &'a str>) -> Result<Point3, String> {
    let number = |word: &str| {
        let number = word.parse::<f64>();
        number.map_err(|_| format!("{word:?} is not a number"))
    };
    let numbers: Vec<f64> = words.map(number).collect::<Result<_, _>>()?;
    match numbers[..] {
        [x, y, z, w] if w != 0.0 => Ok(Point3::new(x, y, z) / w),
        [x, y, z, ..] => Ok(Point3::new(x, y, z)),
        _ => Err(format!(
            "a vertex has at least 3 numbers, and this one has {}",
            numbers.len()
        )),
    }
}

/// Returns the number of the vertex of a corner such as 3, 3/1, 3//2 or -1, which counts backwards from the last vertex.
fn find_vertex(word: &str, count: usize) -> Result<usize, String> {
    let index = word.split('/').next().unwrap_or_default();
    let index: i64 = (index.parse()).map_err(|_| format!("{word:?} is no corner of a face"))?;
    let at = if index < 0 {
        count as i64 + index
    } else {
        index - 1
    };
    (usize::try_from(at).ok().filter(|at| *at < count))
        .ok_or_else(|| format!("vertex {index} is not among the {count} before it"))
}
