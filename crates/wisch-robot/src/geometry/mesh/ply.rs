//! PLY files (Turk, *The PLY Polygon File Format*, 1994) in memory: text, and binary of both byte orders.

use super::{MAX_TRIANGLES, Mesh, MeshError, Point3, check_coordinates};
use crate::geometry::triangulation::cut_face;

/// Largest number of lines of a header.
const MAX_HEADER_LINES: usize = 10_000;
/// Largest number of corners of a face.
const MAX_CORNERS: usize = 10_000;

/// Order of the bytes of a number, or text.
#[derive(Clone, Copy, PartialEq)]
enum Encoding {
    Text,
    Little,
    Big,
}

/// A type of numbers.
#[derive(Clone, Copy, PartialEq)]
enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

/// A named value of each row of an element.
struct Property {
    name: String,
    /// Type of the length of a list; `None` for a single number.
    length: Option<Scalar>,
    scalar: Scalar,
}

/// A table of the file.
struct Element {
    name: String,
    rows: usize,
    properties: Vec<Property>,
}

/// Header of a file, before the rows.
struct Header<'a> {
    encoding: Encoding,
    elements: Vec<Element>,
    /// The bytes after the header.
    body: &'a [u8],
    lines: usize,
}

/// Reads vertices and faces; other elements and properties are skipped.
pub(super) fn parse(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let header = read_header(bytes)?;
    let mut input = Input {
        bytes: header.body,
        at: 0,
        encoding: header.encoding,
        line: header.lines + 1,
    };
    let (mut vertices, mut faces): (Vec<Point3>, Option<Vec<[u32; 3]>>) = (Vec::new(), None);
    for element in &header.elements {
        match element.name.as_str() {
            "vertex" => vertices = input.vertices(element)?,
            "face" => faces = Some(input.faces(element, &vertices)?),
            _ => input.skip(element)?,
        }
    }
    match faces {
        Some(faces) if !faces.is_empty() => Mesh::new(vertices, faces),
        _ if !vertices.is_empty() => Err(MeshError::PointCloud {
            points: vertices.len(),
        }),
        _ => Err(MeshError::Empty),
    }
}

fn read_header(bytes: &[u8]) -> Result<Header<'_>, MeshError> {
    let end = if bytes.starts_with(b"ply\r\n") {
        &b"\r\n"[..]
    } else if bytes.starts_with(b"ply\r") {
        b"\r"
    } else {
        b"\n"
    };
    let (mut encoding, mut elements) = (None, Vec::new());
    let (mut rest, mut number) = (bytes, 0);
    loop {
        number += 1;
        let fault = |reason: String| MeshError::SyntaxAt {
            line: number,
            reason,
        };
        let length = (rest.windows(end.len())).position(|found| found == end);
        let Some(length) = length.filter(|_| number <= MAX_HEADER_LINES) else {
            return Err(fault("the header has no line \"end_header\"".to_owned()));
        };
        let line = String::from_utf8_lossy(&rest[..length]);
        rest = &rest[length + end.len()..];
        let words: Vec<&str> = line.split_ascii_whitespace().collect();
        match words[..] {
            ["ply"] if number == 1 => {}
            _ if number == 1 => return Err(fault("the first line is not \"ply\"".to_owned())),
            ["end_header"] => break,
            ["format", name, _] => {
                encoding = Some(encoding_of(name).ok_or_else(|| {
                    fault(format!(
                        "format {name:?} is not ascii, binary_little_endian or binary_big_endian"
                    ))
                })?)
            }
            ["element", name, rows] => elements.push(Element {
                name: name.to_owned(),
                rows: rows
                    .parse()
                    .map_err(|_| fault(format!("{rows:?} is not a number of rows")))?,
                properties: Vec::new(),
            }),
            ["property", ref parts @ ..] => {
                let property = property_of(parts).map_err(fault)?;
                let last: Option<&mut Element> = elements.last_mut();
                last.ok_or_else(|| fault("a property comes before the first element".to_owned()))?
                    .properties
                    .push(property);
            }
            ["comment" | "obj_info", ..] | [] => {}
            _ => {
                return Err(fault(format!(
                    "{:?} is not a line of a header",
                    line.trim()
                )));
            }
        }
    }
    let missing = || MeshError::Syntax {
        reason: "the header has no line \"format\"".to_owned(),
    };
    Ok(Header {
        encoding: encoding.ok_or_else(missing)?,
        elements,
        body: rest,
        lines: number,
    })
}

fn encoding_of(name: &str) -> Option<Encoding> {
    match name {
        "ascii" => Some(Encoding::Text),
        "binary_little_endian" => Some(Encoding::Little),
        "binary_big_endian" => Some(Encoding::Big),
        _ => None,
    }
}

fn property_of(words: &[&str]) -> Result<Property, String> {
    let scalar = |name: &str| Scalar::parse(name).ok_or(format!("{name:?} is not a type"));
    match *words {
        ["list", length, entry, name] => {
            let length = scalar(length)?;
            if matches!(length, Scalar::F32 | Scalar::F64) {
                return Err("the length of a list is not an integer type".to_owned());
            }
            Ok(Property {
                name: name.to_owned(),
                length: Some(length),
                scalar: scalar(entry)?,
            })
        }
        [kind, name] => Ok(Property {
            name: name.to_owned(),
            length: None,
            scalar: scalar(kind)?,
        }),
        _ => Err("a property is a type and a name, or a list of two types and a name".to_owned()),
    }
}

impl Scalar {
    fn parse(name: &str) -> Option<Self> {
        Some(match name {
            "char" | "int8" => Self::I8,
            "uchar" | "uint8" => Self::U8,
            "short" | "int16" => Self::I16,
            "ushort" | "uint16" => Self::U16,
            "int" | "int32" => Self::I32,
            "uint" | "uint32" => Self::U32,
            "float" | "float32" => Self::F32,
            "double" | "float64" => Self::F64,
            _ => return None,
        })
    }

    const fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// Returns the number in `size` bytes, the most significant last.
    fn decode(self, bytes: [u8; 8]) -> f64 {
        let [a, b, c, d, ..] = bytes;
        match self {
            Self::I8 => f64::from(i8::from_le_bytes([a])),
            Self::U8 => f64::from(a),
            Self::I16 => f64::from(i16::from_le_bytes([a, b])),
            Self::U16 => f64::from(u16::from_le_bytes([a, b])),
            Self::I32 => f64::from(i32::from_le_bytes([a, b, c, d])),
            Self::U32 => f64::from(u32::from_le_bytes([a, b, c, d])),
            Self::F32 => f64::from(f32::from_le_bytes([a, b, c, d])),
            Self::F64 => f64::from_le_bytes(bytes),
        }
    }
}

/// The rows after the header.
struct Input<'a> {
    bytes: &'a [u8],
    at: usize,
    encoding: Encoding,
    /// Number of the current line, in text.
    line: usize,
}

impl<'a> Input<'a> {
    /// Returns the next number.
    fn number(&mut self, scalar: Scalar, element: &Element, row: usize) -> Result<f64, MeshError> {
        let truncated = |line| {
            let reason = format!(
                "the file ends in row {row} of element {:?}, which has {} rows (counted from 0)",
                element.name, element.rows
            );
            match line {
                Some(line) => MeshError::SyntaxAt { line, reason },
                None => MeshError::Syntax { reason },
            }
        };
        if self.encoding == Encoding::Text {
            let word = self.word().ok_or_else(|| truncated(Some(self.line)))?;
            let number = std::str::from_utf8(word)
                .ok()
                .and_then(|word| word.parse().ok());
            return number.ok_or_else(|| MeshError::SyntaxAt {
                line: self.line,
                reason: format!(
                    "{:?} in row {row} of element {:?} is not a number",
                    String::from_utf8_lossy(&word[..word.len().min(40)]),
                    element.name
                ),
            });
        }
        let end = self.at + scalar.size();
        let found = self
            .bytes
            .get(self.at..end)
            .ok_or_else(|| truncated(None))?;
        self.at = end;
        let mut bytes = [0; 8];
        bytes[..found.len()].copy_from_slice(found);
        if self.encoding == Encoding::Big {
            bytes[..found.len()].reverse();
        }
        Ok(scalar.decode(bytes))
    }

    /// Returns the next word of the text.
    fn word(&mut self) -> Option<&'a [u8]> {
        while let Some(byte) = self.bytes.get(self.at).filter(|b| b.is_ascii_whitespace()) {
            self.line += usize::from(*byte == b'\n');
            self.at += 1;
        }
        let rest = &self.bytes[self.at..];
        let length = (rest.iter().position(u8::is_ascii_whitespace)).unwrap_or(rest.len());
        self.at += length;
        (length > 0).then(|| &rest[..length])
    }

    /// Reads one row: `take` gets each number with the index of its property.
    fn row(
        &mut self,
        element: &Element,
        row: usize,
        mut take: impl FnMut(usize, f64) -> Result<(), MeshError>,
    ) -> Result<(), MeshError> {
        for (index, property) in element.properties.iter().enumerate() {
            let length = match property.length {
                None => 1.0,
                Some(length) => self.number(length, element, row)?,
            };
            if !(0.0..=MAX_CORNERS as f64).contains(&length) {
                let reason = format!(
                    "row {row} of element {:?}: list {:?} has {length} entries, the limit is {MAX_CORNERS}",
                    element.name, property.name
                );
                return Err(MeshError::Syntax { reason });
            }
            for _ in 0..length as usize {
                let number = self.number(property.scalar, element, row)?;
                take(index, number)?;
            }
        }
        Ok(())
    }

    /// Checks that the file may have all rows of the element, before memory is reserved for them.
    fn check_room(&self, element: &Element) -> Result<(), MeshError> {
        // In text, a number takes two bytes with its separator; the last has none.
        let least: usize = (element.properties.iter())
            .map(|property| match self.encoding {
                Encoding::Text => 2,
                _ => property.length.unwrap_or(property.scalar).size(),
            })
            .sum();
        let room = (self.bytes.len() + 1 - self.at) / least.max(1);
        if element.rows > room {
            let reason = format!(
                "its header announces {} rows of element {:?}, but its {} bytes have room for {room}",
                element.rows,
                element.name,
                self.bytes.len()
            );
            return Err(MeshError::Syntax { reason });
        }
        Ok(())
    }

    fn vertices(&mut self, element: &Element) -> Result<Vec<Point3>, MeshError> {
        let column = |name: &str| {
            (element.properties.iter())
                .position(|property| property.name == name && property.length.is_none())
                .ok_or_else(|| MeshError::Syntax {
                    reason: format!("element \"vertex\" has no property {name:?}"),
                })
        };
        let columns = [column("x")?, column("y")?, column("z")?];
        self.check_room(element)?;
        let mut vertices = Vec::with_capacity(element.rows);
        for row in 0..element.rows {
            let mut point = Point3::origin();
            self.row(element, row, |index, number| {
                if let Some(axis) = columns.iter().position(|&column| column == index) {
                    point[axis] = number;
                }
                Ok(())
            })?;
            vertices.push(point);
        }
        check_coordinates(&vertices)?;
        Ok(vertices)
    }

    fn faces(
        &mut self,
        element: &Element,
        vertices: &[Point3],
    ) -> Result<Vec<[u32; 3]>, MeshError> {
        let is_corners = |property: &Property| {
            property.length.is_some()
                && matches!(property.name.as_str(), "vertex_indices" | "vertex_index")
        };
        let Some(column) = element.properties.iter().position(is_corners) else {
            if element.rows == 0 {
                return Ok(Vec::new());
            }
            let reason = "element \"face\" has no list \"vertex_indices\"".to_owned();
            return Err(MeshError::Syntax { reason });
        };
        self.check_room(element)?;
        let mut triangles = Vec::with_capacity(element.rows.min(MAX_TRIANGLES));
        let mut corners: Vec<u32> = Vec::new();
        for row in 0..element.rows {
            corners.clear();
            self.row(element, row, |index, number| {
                if index != column {
                    return Ok(());
                }
                if !(0.0..vertices.len() as f64).contains(&number) || number.fract() != 0.0 {
                    let reason = format!(
                        "face {row} names vertex {number}, but there are {} vertices (counted from 0)",
                        vertices.len()
                    );
                    return Err(MeshError::Syntax { reason });
                }
                corners.push(number as u32);
                Ok(())
            })?;
            match corners[..] {
                [a, b, c] => triangles.push([a, b, c]),
                [] | [_] | [_, _] => {}
                _ => {
                    let places: Vec<Point3> =
                        corners.iter().map(|&i| vertices[i as usize]).collect();
                    let cut = cut_face(&places).into_iter();
                    triangles.extend(cut.map(|triangle| triangle.map(|i| corners[i])));
                }
            }
            if triangles.len() > MAX_TRIANGLES {
                let count = triangles.len();
                return Err(MeshError::TooManyTriangles { count });
            }
        }
        Ok(triangles)
    }

    fn skip(&mut self, element: &Element) -> Result<(), MeshError> {
        if element.properties.is_empty() {
            return Ok(());
        }
        self.check_room(element)?;
        (0..element.rows).try_for_each(|row| self.row(element, row, |_, _| Ok(())))
    }
}

#[cfg(test)]
mod tests;
