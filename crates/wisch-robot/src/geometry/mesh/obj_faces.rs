//! Triangulation of the concave faces of a Wavefront OBJ, in its text.

use super::Point3;
use crate::geometry::triangulation::cut_face;

/// Returns the text of a valid OBJ with each concave face replaced by its triangles; `None` if it has none.
pub(super) fn with_concave_faces_cut(bytes: &[u8]) -> Option<Vec<u8>> {
    let mut vertices: Vec<Point3> = Vec::new();
    let mut text: Vec<u8> = Vec::new();
    // End of the bytes that are in the text already.
    let (mut copied, mut at) = (0, 0);
    for line in bytes.split_inclusive(|b| matches!(b, b'\n' | b'\r')) {
        let begin = at;
        at += line.len();
        let words = || {
            let separated = line[1..].split(|b| b" \t\n\r".contains(b));
            separated.filter(|word| !word.is_empty())
        };
        match line {
            [b'v', b' ' | b'\t', ..] => vertices.push(position(words())?),
            [b'f', b' ' | b'\t', ..] => {
                let words: Vec<&[u8]> = words().collect();
                let Some(triangles) = concave(&words, &vertices) else {
                    continue;
                };
                text.extend(&bytes[copied..begin]);
                copied = at;
                for corners in triangles {
                    text.push(b'f');
                    for corner in corners {
                        text.push(b' ');
                        text.extend(words[corner]);
                    }
                    text.push(b'\n');
                }
            }
            _ => {}
        }
    }
    if copied == 0 {
        return None;
    }
    text.extend(&bytes[copied..]);
    Some(text)
}

/// Reads a vertex, which is homogeneous if it has four numbers.
fn position<'a>(words: impl Iterator<Item = &'a [u8]>) -> Option<Point3> {
    let number = |word: &[u8]| std::str::from_utf8(word).ok()?.parse::<f64>().ok();
    let numbers = words.map(number).collect::<Option<Vec<f64>>>()?;
    match numbers[..] {
        [x, y, z, w] => Some(Point3::new(x, y, z) / w),
        [x, y, z, ..] => Some(Point3::new(x, y, z)),
        _ => None,
    }
}

/// Returns the triangles of a concave face, as corner indices; `None` for a face that a fan about its first corner
/// triangulates.
fn concave(words: &[&[u8]], vertices: &[Point3]) -> Option<Vec<[usize; 3]>> {
    if words.len() < 4 {
        return None;
    }
    let corner = |word: &&[u8]| {
        let index = word.split(|&b| b == b'/').next()?;
        let index: i64 = std::str::from_utf8(index).ok()?.parse().ok()?;
        // Indices count from 1, or backwards from the last vertex so far.
        let index = match index {
            ..0 => vertices.len() as i64 + index,
            _ => index - 1,
        };
        vertices.get(usize::try_from(index).ok()?).copied()
    };
    let corners = words.iter().map(corner).collect::<Option<Vec<Point3>>>()?;
    let triangles = cut_face(&corners);
    let is_fan = (triangles.iter().zip(2..)).all(|(&triangle, i)| triangle == [0, i - 1, i]);
    (!is_fan).then_some(triangles)
}
