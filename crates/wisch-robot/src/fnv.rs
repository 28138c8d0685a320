//! The hash FNV-1a with 128 bits (Fowler, Noll, Vo; IETF draft-eastlake-fnv). It does not protect against deliberate collisions.

use crate::geometry::Mesh;

/// FNV-1a of 128 bits.
pub(crate) struct Fnv(u128);

impl Fnv {
    pub const fn new() -> Self {
        Self(0x6c62_272e_07bb_0142_62b8_2175_6295_c58d)
    }

    pub fn bytes(&mut self, bytes: &[u8]) {
        const PRIME: u128 = 0x0000_0000_0100_0000_0000_0000_0000_013b;
        for &byte in bytes {
            self.0 = (self.0 ^ u128::from(byte)).wrapping_mul(PRIME);
        }
    }

    pub const fn sum(&self) -> [u8; 16] {
        self.0.to_le_bytes()
    }

    pub fn count(&mut self, value: usize) {
        self.bytes(&(value as u64).to_le_bytes());
    }

    /// Hashes a number rounded to 1e-9, so that sines that differ in the last place on another machine do not matter.
    pub fn number(&mut self, value: f64) {
        self.bytes(&((value * 1e9).round() as i64).to_le_bytes());
    }

    pub fn mesh(&mut self, mesh: &Mesh) {
        self.count(mesh.vertices().len());
        for vertex in mesh.vertices() {
            vertex.iter().for_each(|&v| self.number(v));
        }
        for triangle in mesh.triangles() {
            triangle.iter().for_each(|&i| self.bytes(&i.to_le_bytes()));
        }
    }
}
