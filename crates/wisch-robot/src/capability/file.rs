//! File format of a capability map.
//!
//! | bytes | content |
//! |---|---|
//! | 8 | `wischmap` |
//! | 4 | version of the format |
//! | 16 | hash of the robot |
//! | 2 + n, twice | names of base and tip: length, UTF-8 |
//! | 7 × 8 | tool in the tip: translation [m], quaternion x, y, z, w |
//! | 8, 4, 8, 8, 4, 4 | config: voxel [m], frequency, samples, seed, starts, refinements |
//! | 3 × 4, 3 × 4 | grid: first voxel, numbers of voxels |
//! | 4 | number of non-empty rows |
//! | rest | rows and values, packed |
//! | 16 | FNV-1a of all bytes before |
//!
//! Numbers are little-endian; `packing.rs` describes the coding of rows and values.

use super::build::MAX_CELLS;
use super::directions::Directions;
use super::packing::{pack, unpack};
use super::{CapabilityMap, FULL, Grid, MapConfig, MapError, MapOrigin, RobotHash};
use crate::fnv::Fnv;
use crate::geometry::{Pose, Vector3};
use nalgebra::{Quaternion, Translation3, UnitQuaternion};

const MAGIC: &[u8; 8] = b"wischmap";
const VERSION: u32 = 2;

/// Largest size of a capability map's file \[bytes\].
pub const MAX_MAP_BYTES: usize = 64 << 20;

/// Longest name that fits its two-byte length; a URDF has no longer ones.
const MAX_NAME: usize = u16::MAX as usize;

/// Tolerance of a quaternion's norm.
const QUATERNION_TOLERANCE: f64 = 1e-9;

const HASH_BYTES: usize = 16;

impl CapabilityMap {
    /// Returns the map as bytes, which are the same on every machine.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut bytes = MAGIC.to_vec();
        let about = &self.about;
        bytes.extend(VERSION.to_le_bytes());
        bytes.extend(about.robot.0);
        for name in [&about.base, &about.tip] {
            let name = &name.as_bytes()[..name.floor_char_boundary(MAX_NAME)];
            bytes.extend((name.len() as u16).to_le_bytes());
            bytes.extend(name);
        }
        let tool = about.tip_from_tool;
        for value in tool
            .translation
            .vector
            .iter()
            .chain(tool.rotation.coords.iter())
        {
            bytes.extend(value.to_le_bytes());
        }
        let config = &about.config;
        bytes.extend(config.voxel.to_le_bytes());
        bytes.extend(config.frequency.to_le_bytes());
        bytes.extend(config.samples.to_le_bytes());
        bytes.extend(config.seed.to_le_bytes());
        bytes.extend(config.starts.to_le_bytes());
        bytes.extend(config.refinements.to_le_bytes());
        for lowest in self.grid.lowest {
            bytes.extend(lowest.to_le_bytes());
        }
        for count in self.grid.counts {
            bytes.extend((count as u32).to_le_bytes());
        }
        let rows = self.values.len() / self.directions.count() - 1;
        bytes.extend((rows as u32).to_le_bytes());
        bytes.extend(pack(self));
        let mut hash = Fnv::new();
        hash.bytes(&bytes);
        bytes.extend(hash.sum());
        bytes
    }

    /// Reads the map that [`to_bytes`](Self::to_bytes) wrote for a robot. `name` identifies the bytes in messages. The
    /// posture of the other joints and the collision model, on which the map depends as well, are not checked;
    /// [`origin`](Self::origin) has base, tip and tool.
    ///
    /// # Errors
    /// If the bytes are no map, or one of another version or robot.
    pub fn from_bytes(name: &str, bytes: &[u8], robot: RobotHash) -> Result<Self, MapError> {
        let format = |problem: String| MapError::Format {
            file: name.to_owned(),
            problem,
        };
        if bytes.len() > MAX_MAP_BYTES {
            let size = bytes.len();
            return Err(format(format!(
                "{size} bytes exceed the limit of {MAX_MAP_BYTES} bytes"
            )));
        }
        let mut reader = Reader { bytes };
        let magic = reader.take().map_err(format)?;
        if &magic != MAGIC {
            return Err(format(format!("it does not begin with {:?}", "wischmap")));
        }
        let found = reader.u32().map_err(format)?;
        if found != VERSION {
            return Err(MapError::Version {
                file: name.to_owned(),
                found,
                expected: VERSION,
            });
        }
        let Some((content, sum)) = bytes.split_last_chunk::<HASH_BYTES>() else {
            return Err(format(TRUNCATED.to_owned()));
        };
        let mut hash = Fnv::new();
        hash.bytes(content);
        if hash.sum() != *sum {
            return Err(format(
                "its checksum is wrong: it is cut short or damaged".into(),
            ));
        }
        let found = RobotHash(reader.take().map_err(format)?);
        if found != robot {
            return Err(MapError::OtherRobot {
                file: name.to_owned(),
                found,
                expected: robot,
            });
        }
        let content = reader.bytes.len().saturating_sub(HASH_BYTES);
        reader.bytes = &reader.bytes[..content];
        let map = reader.map(robot).map_err(format)?;
        if map.values.iter().all(|&value| value == 0) {
            return Err(MapError::ReachesNothing {
                file: name.to_owned(),
            });
        }
        Ok(map)
    }
}

const TRUNCATED: &str = "it ends too early";

struct Reader<'a> {
    bytes: &'a [u8],
}

impl Reader<'_> {
    fn take<const N: usize>(&mut self) -> Result<[u8; N], String> {
        let (first, rest) = self.bytes.split_first_chunk().ok_or(TRUNCATED)?;
        self.bytes = rest;
        Ok(*first)
    }

    fn u32(&mut self) -> Result<u32, String> {
        self.take().map(u32::from_le_bytes)
    }

    fn u64(&mut self) -> Result<u64, String> {
        self.take().map(u64::from_le_bytes)
    }

    fn number(&mut self, what: &str) -> Result<f64, String> {
        let value = self.take().map(f64::from_le_bytes)?;
        if value.is_finite() {
            Ok(value)
        } else {
            Err(format!("{what} {value} is not finite"))
        }
    }

    fn name(&mut self) -> Result<String, String> {
        let length = usize::from(self.take().map(u16::from_le_bytes)?);
        let (name, rest) = self.bytes.split_at_checked(length).ok_or(TRUNCATED)?;
        self.bytes = rest;
        let name = std::str::from_utf8(name).map_err(|e| format!("name of a link: {e}"))?;
        Ok(name.to_owned())
    }

    /// Reads everything after the robot's hash.
    fn map(&mut self, robot: RobotHash) -> Result<CapabilityMap, String> {
        let (base, tip) = (self.name()?, self.name()?);
        let mut tool = [0.0; 7];
        for value in &mut tool {
            *value = self.number("pose of the tool:")?;
        }
        let [x, y, z, qx, qy, qz, qw] = tool;
        let quaternion = Quaternion::new(qw, qx, qy, qz);
        let norm = quaternion.norm();
        if (norm - 1.0).abs() > QUATERNION_TOLERANCE {
            return Err(format!(
                "pose of the tool: norm {norm} of the quaternion is not 1"
            ));
        }
        let config = MapConfig {
            voxel: self.number("voxel")?,
            frequency: self.u32()?,
            samples: self.u64()?,
            seed: self.u64()?,
            starts: self.u32()?,
            refinements: self.u32()?,
        };
        config.check().map_err(|e| e.to_string())?;
        let mut grid = Grid {
            voxel: config.voxel,
            lowest: [0; 3],
            counts: [0; 3],
        };
        for lowest in &mut grid.lowest {
            *lowest = self.take().map(i32::from_le_bytes)?;
        }
        for count in &mut grid.counts {
            *count = self.u32()? as usize;
        }
        let rows = self.u32()? as usize;
        let directions = Directions::new(config.frequency as usize);
        let voxels = grid
            .counts
            .iter()
            .fold(1_u64, |v, &c| v.saturating_mul(c as u64));
        let cells = (rows as u64).saturating_mul(directions.count() as u64);
        for (what, value) in [("voxels", voxels), ("cells", cells)] {
            if value > MAX_CELLS as u64 {
                return Err(format!("{value} {what} exceed the limit of {MAX_CELLS}"));
            }
        }
        if grid.counts.contains(&0) {
            return Err(format!("numbers of voxels {:?}", grid.counts));
        }
        let about = MapOrigin {
            robot,
            base,
            tip,
            tip_from_tool: Pose::from_parts(
                Translation3::from(Vector3::new(x, y, z)),
                UnitQuaternion::new_unchecked(quaternion),
            ),
            config,
        };
        let (rows, values) = unpack(self.bytes, &grid, directions.count(), rows, FULL)?;
        Ok(CapabilityMap {
            about,
            grid,
            directions,
            rows,
            values,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const ROBOT: RobotHash = RobotHash([42; 16]);

    /// Returns a map of three voxels in a row, the middle one of which has values.
    fn map() -> CapabilityMap {
        let directions = Directions::new(2);
        let count = directions.count();
        let row = (0..count).map(|i| (i * i % 16) as u8);
        CapabilityMap {
            about: MapOrigin {
                robot: ROBOT,
                base: "base".into(),
                tip: "tip".into(),
                tip_from_tool: Pose::translation(0.1, 0.2, 0.3),
                config: MapConfig {
                    frequency: 2,
                    ..MapConfig::default()
                },
            },
            grid: Grid {
                voxel: 0.05,
                lowest: [-1, 0, 0],
                counts: [3, 1, 1],
            },
            rows: vec![0, 1, 0],
            values: vec![0; count].into_iter().chain(row).collect(),
            directions,
        }
    }

    /// Appends a valid checksum to bytes.
    fn sealed(mut bytes: Vec<u8>) -> Vec<u8> {
        bytes.truncate(bytes.len() - HASH_BYTES);
        let mut hash = Fnv::new();
        hash.bytes(&bytes);
        bytes.extend(hash.sum());
        bytes
    }

    fn read(bytes: &[u8]) -> Result<CapabilityMap, MapError> {
        CapabilityMap::from_bytes("a.map", bytes, ROBOT)
    }

    #[test]
    fn a_map_comes_back() {
        assert_eq!(read(&map().to_bytes()), Ok(map()));
    }

    /// Offsets of the parts of [`map`]'s bytes.
    const TOOL: usize = 8 + 4 + 16 + (2 + 4) + (2 + 3);
    const CONFIG: usize = TOOL + 7 * 8;
    const GRID: usize = CONFIG + 8 + 4 + 8 + 8 + 4 + 4;
    const ROWS: usize = GRID + 6 * 4;

    #[test]
    fn values_that_make_no_sense_are_named() {
        let nan = f64::NAN.to_le_bytes();
        let many = u32::MAX.to_le_bytes();
        let cases: [(usize, &[u8], &str); 8] = [
            (28, &[255, 255], "it ends too early"),
            (
                30,
                &[255],
                "name of a link: invalid utf-8 sequence of 1 bytes from index 0",
            ),
            (TOOL, &nan, "pose of the tool: NaN is not finite"),
            (
                TOOL + 24,
                &1_f64.to_le_bytes(),
                "pose of the tool: norm 1.4142135623730951 of the quaternion is not 1",
            ),
            (CONFIG, &nan, "voxel NaN is not finite"),
            (
                CONFIG + 8,
                &many,
                "map.frequency: 4294967295 is outside 1 to 32",
            ),
            (
                GRID + 12,
                &0_u32.to_le_bytes(),
                "numbers of voxels [0, 1, 1]",
            ),
            (
                ROWS,
                &0_u32.to_le_bytes(),
                "1 non-empty rows in 3 voxels, expected 0 in 3",
            ),
        ];
        for (at, with, message) in cases {
            let mut bytes = map().to_bytes();
            bytes[at..at + with.len()].copy_from_slice(with);
            let refused = read(&sealed(bytes)).map(|_| ()).unwrap_err();
            assert_eq!(
                refused.to_string(),
                format!("a.map: no capability map: {message}")
            );
        }
    }

    #[test]
    fn a_map_of_more_cells_than_are_ever_made_is_refused() {
        for at in [GRID + 12, ROWS] {
            let mut bytes = map().to_bytes();
            bytes[at..at + 4].copy_from_slice(&u32::MAX.to_le_bytes());
            let refused = read(&sealed(bytes)).map(|_| ()).unwrap_err().to_string();
            assert!(refused.contains("exceed the limit of"), "{refused}");
        }
    }

    proptest! {
        #[test]
        fn damage_under_a_fitting_sum_is_no_panic(
            changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
            cut in 0usize..200,
        ) {
            let mut bytes = map().to_bytes();
            for (at, byte) in changes {
                let at = at.index(bytes.len());
                bytes[at] = byte;
            }
            bytes.truncate((bytes.len() - cut.min(bytes.len())).max(HASH_BYTES));
            if let Ok(map) = read(&sealed(bytes)) {
                prop_assert!((0.0..=1.0).contains(&map.reachability(&Pose::identity())));
                prop_assert!(map.index(&Default::default()).is_finite());
                prop_assert!(map.bounds()[0].x.is_finite());
            }
        }
    }
}
