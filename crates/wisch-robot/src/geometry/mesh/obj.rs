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
    let mut mesh = Contents::default();
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
        mesh.read_line(first, &whole)?;
    }
    if let Some((first, whole)) = continued {
        mesh.read_line(first, &whole)?;
    }
    mesh.finish()
}

/// Vertices and faces of the lines so far.
#[derive(Default)]
struct Contents {
    vertices: Vec<Point3>,
    /// Numbers of the corners, all faces one after another. They may be those of later vertices.
    corners: Vec<usize>,
    /// For each face, its line and the number of its corners.
    faces: Vec<(usize, usize)>,
    triangles: usize,
}

impl Contents {
    fn read_line(&mut self, number: usize, line: &str) -> Result<(), MeshError> {
        let fault = |reason| fault_in(number, reason);
        let mut words = line.split_ascii_whitespace();
        match words.next() {
            None => {}
            Some("v") => self.vertices.push(read_vertex(words).map_err(fault)?),
            Some("f") => {
                let before = self.corners.len();
                for word in words {
                    let at = find_vertex(word, self.vertices.len()).map_err(fault)?;
                    self.corners.push(at);
                }
                let count = self.corners.len() - before;
                if count < 3 {
                    let reason = format!("a face has at least 3 corners, and this one has {count}");
                    return Err(fault(reason));
                }
                self.faces.push((number, count));
                self.triangles += count - 2;
                if self.triangles > MAX_TRIANGLES {
                    let count = self.triangles;
                    return Err(MeshError::TooManyTriangles { count });
                }
            }
            Some(other) if OTHER_KEYWORDS.contains(&other) => {}
            Some(other) => {
                let shown: String = other.chars().take(20).collect();
                return Err(fault(format!("{shown:?} is no keyword of OBJ")));
            }
        }
        Ok(())
    }

    fn finish(self) -> Result<Mesh, MeshError> {
        let mut triangles: Vec<[u32; 3]> = Vec::with_capacity(self.triangles);
        let mut rest = &self.corners[..];
        for (number, count) in self.faces {
            let (corners, after) = rest.split_at(count);
            rest = after;
            let places = corners.iter().map(|&at| self.vertices.get(at).copied());
            let Some(places) = places.collect::<Option<Vec<Point3>>>() else {
                let (all, most) = (self.vertices.len(), corners.iter().max().unwrap_or(&0) + 1);
                let reason = format!("vertex {most} is not among the {all} of the file");
                return Err(fault_in(number, reason));
            };
            let cut = cut_face(&places);
            triangles.extend(cut.iter().map(|three| three.map(|k| corners[k] as u32)));
        }
        Mesh::new(self.vertices, triangles)
    }
}

fn fault_in(line: usize, reason: String) -> MeshError {
    MeshError::Syntax {
        reason: format!("line {line}: {reason}"),
    }
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

/// Returns the number of the vertex of a corner such as 3, 3/1, 3//2 or -1, which counts backwards from the last vertex so far.
fn find_vertex(word: &str, count: usize) -> Result<usize, String> {
    let index = word.split('/').next().unwrap_or_default();
    let index: i64 = (index.parse()).map_err(|_| format!("{word:?} is no corner of a face"))?;
    let at = match index {
        0 => None,
        1.. => usize::try_from(index - 1).ok(),
        _ => (count as i64)
            .checked_add(index)
            .and_then(|at| usize::try_from(at).ok()),
    };
    at.ok_or_else(|| format!("vertex {index} is not among the {count} before it"))
}
