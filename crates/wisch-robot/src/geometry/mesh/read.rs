//! Mesh files from bytes in memory: STL, OBJ, COLLADA, PLY, and height fields.
//!
//! STL is parsed by the `mesh-loader` crate, after checks that limit its allocations. COLLADA is read here
//! (`collada.rs`): mesh-loader 0.1.13 does not return from a `<Name_array>`, panics or aborts on inconsistent counts,
//! ignores node transforms under 1 cm and misplaces nested nodes. OBJ is read in `obj.rs`: mesh-loader refuses comments at the
//! end of a line, continued lines, and faces with texture coordinates after faces without, and cuts every face into a fan. PLY
//! is read in `ply.rs`, height fields in `height_field.rs`.

use super::{MAX_TRIANGLES, Mesh, MeshError, Point3, collada, height_field, obj, ply};
use std::io;
use std::path::Path;

/// Largest number of solids of one file; each costs the parser about a kilobyte.
const MAX_PARTS: usize = 100_000;

/// Length of a binary STL's header including the triangle count [bytes], and of one triangle.
const STL_HEADER: usize = 84;
const STL_TRIANGLE: usize = 50;

/// The mesh formats that [`Mesh::parse`] reads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MeshFormat {
    /// STL, ASCII or binary.
    Stl,
    /// Wavefront OBJ; materials are ignored.
    Obj,
    /// COLLADA 1.4 and 1.5.
    Collada,
    /// PLY, text or binary; only vertices and faces are read.
    Ply,
    /// Height field over x and y: Esri ASCII raster.
    HeightField,
}

impl MeshFormat {
    /// The extensions of mesh files, as messages name them.
    pub const EXTENSIONS: &str = ".stl, .obj, .dae, .ply or .asc";

    /// Returns the format for the extension of a file name, in any case: stl, obj, dae, ply or asc.
    ///
    /// ```
    /// use wisch_robot::geometry::MeshFormat;
    /// assert_eq!(MeshFormat::from_file_name("tools/Sponge.STL"), Some(MeshFormat::Stl));
    /// assert_eq!(MeshFormat::from_file_name("sponge.step"), None);
    /// ```
    pub fn from_file_name(name: &str) -> Option<Self> {
        let extension = Path::new(name).extension()?.to_str()?.to_ascii_lowercase();
        match extension.as_str() {
            "stl" => Some(Self::Stl),
            "obj" => Some(Self::Obj),
            "dae" => Some(Self::Collada),
            "ply" => Some(Self::Ply),
            "asc" => Some(Self::HeightField),
            _ => None,
        }
    }
}

impl Mesh {
    /// Reads a mesh from the bytes of a file; `name` is used in error messages only. Several meshes in one file are
    /// merged, and so are coincident vertices.
    ///
    /// STL, OBJ, PLY and height fields have no unit and are read in metres. COLLADA's unit and node transforms are applied. As in ROS, its
    /// `up_axis` is not: coordinates stay in their original axes.
    ///
    /// # Errors
    /// If the bytes do not follow the format, or their mesh violates the rules of [`Mesh::new`].
    pub fn parse(bytes: &[u8], format: MeshFormat, name: &str) -> Result<Self, MeshError> {
        let mesh = match format {
            MeshFormat::Stl => parse_stl(bytes),
            MeshFormat::Obj => obj::parse(bytes),
            MeshFormat::Collada => collada::parse(bytes),
            MeshFormat::Ply => ply::parse(bytes),
            MeshFormat::HeightField => height_field::parse(bytes),
        };
        mesh.map(|mesh| mesh.weld())
            .map_err(|fault| MeshError::InMesh {
                name: name.to_owned(),
                fault: Box::new(fault),
            })
    }
}

fn parse_stl(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let scene = if is_ascii_stl(bytes) {
        mesh_loader::stl::from_slice(&with_plain_solids(bytes)?)
    } else {
        mesh_loader::stl::from_slice(&exact_binary_stl(bytes)?)
    };
    from_scene(scene)
}

/// Whether bytes that begin with "solid" are text. A binary header may begin so too, but only in a binary file do bytes
/// 80 to 84 hold a triangle count that fits: as text they would announce at least 9e9 bytes.
fn is_ascii_stl(bytes: &[u8]) -> bool {
    let room = bytes.len().saturating_sub(STL_HEADER) / STL_TRIANGLE;
    starts_with(bytes.trim_ascii_start(), b"solid")
        && declared_triangles(bytes).is_none_or(|declared| declared as usize > room)
}

/// Whether bytes begin with a keyword, in any case.
fn starts_with(bytes: &[u8], keyword: &[u8]) -> bool {
    (bytes.get(..keyword.len())).is_some_and(|begin| begin.eq_ignore_ascii_case(keyword))
}

fn declared_triangles(bytes: &[u8]) -> Option<u32> {
    Some(u32::from_le_bytes(bytes.get(80..84)?.try_into().ok()?))
}

/// Returns the header and exactly the announced triangles: mesh-loader ignores the count, and takes a header that
/// begins with "solid" for text.
fn exact_binary_stl(bytes: &[u8]) -> Result<Vec<u8>, MeshError> {
    let Some(declared) = declared_triangles(bytes) else {
        let reason = format!(
            "neither text that begins with \"solid\" nor a binary STL: {} bytes, a header has {STL_HEADER}",
            bytes.len()
        );
        return Err(MeshError::Syntax { reason });
    };
    let body = &bytes[STL_HEADER..];
    let room = body.len() / STL_TRIANGLE;
    let rest = body.get((declared as usize).saturating_mul(STL_TRIANGLE)..);
    // Some programs append other bytes; whole triangles that are not empty were announced by mistake.
    let is_longer = rest
        .is_some_and(|rest| rest.len() % STL_TRIANGLE == 0 && rest.iter().any(|byte| *byte != 0));
    if declared as usize > room || is_longer {
        return Err(MeshError::TriangleCount {
            declared,
            bytes: bytes.len(),
            room,
        });
    }
    if declared as usize > MAX_TRIANGLES {
        return Err(MeshError::TooManyTriangles {
            count: declared as usize,
        });
    }
    let mut exact = vec![b' '; 80];
    exact.extend(&bytes[80..STL_HEADER + declared as usize * STL_TRIANGLE]);
    Ok(exact)
}

/// Returns the text with plain solid lines. For a solid without a name, or with a name that is not ASCII, mesh-loader
/// would read the text as binary triangles.
fn with_plain_solids(bytes: &[u8]) -> Result<Vec<u8>, MeshError> {
    let mut plain = Vec::with_capacity(bytes.len() + 16);
    let mut solids = 0;
    for line in bytes.split_inclusive(|b| matches!(b, b'\n' | b'\r')) {
        let trimmed = line.trim_ascii_start();
        if starts_with(trimmed, b"solid") {
            solids += 1;
            plain.extend(b"solid -\n");
        } else if starts_with(trimmed, b"endsolid") {
            plain.extend(b"endsolid\n");
        } else {
            // mesh-loader knows the keywords in lower case only. Numbers read the same in lower case.
            plain.extend(line.to_ascii_lowercase());
        }
    }
    check_parts("solids", solids)?;
    Ok(plain)
}

fn check_parts(what: &'static str, count: usize) -> Result<(), MeshError> {
    if count > MAX_PARTS {
        let limit = MAX_PARTS;
        return Err(MeshError::TooManyParts { what, count, limit });
    }
    Ok(())
}

fn from_scene(scene: io::Result<mesh_loader::Scene>) -> Result<Mesh, MeshError> {
    let scene = scene.map_err(|e| MeshError::Syntax {
        reason: e.to_string(),
    })?;
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for mesh in scene.meshes {
        let first = vertices.len() as u32;
        vertices.extend(
            mesh.vertices
                .iter()
                .map(|&v| Point3::from(v.map(f64::from))),
        );
        triangles.extend(mesh.faces.iter().map(|face| face.map(|i| i + first)));
    }
    Mesh::new(vertices, triangles)
}
