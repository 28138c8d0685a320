//! Compact coding of a map's rows and values: a byte for each voxel that states whether it has a
//! row, then the values row by row, one byte each, compressed by Zstandard.

use super::{CapabilityMap, Grid};
use std::io::Read;

/// Compression level; 19 halves the size of level 3, in seconds.
const LEVEL: i32 = 19;

pub(super) fn pack(map: &CapabilityMap) -> Vec<u8> {
    let count = map.directions.count();
    let mut cells: Vec<u8> = map.rows.iter().map(|row| u8::from(*row != 0)).collect();
    cells.extend_from_slice(&map.values[count..]);
    zstd::encode_all(&cells[..], LEVEL).expect("neither slice nor vector fails")
}

/// Returns the rows of the voxels and the values of the rows; a row has `count` directions, and the number of non-empty
/// rows must be the expected one.
pub(super) fn unpack(
    bytes: &[u8],
    grid: &Grid,
    count: usize,
    expected: usize,
    full: u8,
) -> Result<(Vec<u32>, Vec<u8>), String> {
    let damaged = |error: std::io::Error| format!("its rows cannot be unpacked: {error}");
    let mut packed = zstd::Decoder::with_buffer(bytes).map_err(damaged)?;
    let mut filled = Vec::new();
    let voxels = grid.voxels();
    let mut of_voxels = packed.by_ref().take(voxels as u64);
    of_voxels.read_to_end(&mut filled).map_err(damaged)?;
    let mut found = 0;
    let rows: Vec<u32> = (filled.iter())
        .map(|is_filled| {
            found += u32::from(*is_filled != 0);
            if *is_filled != 0 { found } else { 0 }
        })
        .collect();
    if rows.len() != voxels || found as usize != expected {
        return Err(format!(
            "{found} non-empty rows in {} voxels, expected {expected} in {voxels}",
            rows.len()
        ));
    }
    let mut values = vec![0; count];
    let cells = (expected * count) as u64;
    let read = packed.take(cells + 1).read_to_end(&mut values);
    if read.map_err(damaged)? as u64 != cells {
        return Err(format!("not {cells} values"));
    }
    if let Some(value) = values.iter().find(|value| **value > full) {
        return Err(format!("a value of {value} exceeds {full}"));
    }
    Ok((rows, values))
}
