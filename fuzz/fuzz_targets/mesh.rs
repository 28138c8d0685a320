//! Meshes of every format, then their footprint. The first byte chooses the format.
#![no_main]

use libfuzzer_sys::fuzz_target;
use wisch::geometry::{Mesh, MeshFormat, footprint};

fuzz_target!(|bytes: &[u8]| {
    let Some((&choice, rest)) = bytes.split_first() else {
        return;
    };
    let format = match choice % 5 {
        0 => MeshFormat::Stl,
        1 => MeshFormat::Obj,
        2 => MeshFormat::Collada,
        3 => MeshFormat::Ply,
        _ => MeshFormat::HeightField,
    };
    if let Ok(mesh) = Mesh::parse(rest, format, "fuzz") {
        let _ = footprint(&mesh, 0.005);
    }
});
