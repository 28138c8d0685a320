//! The capability map: which poses a tool can be put to, round the base of the chain that carries it.
//!
//! After Zacharias, Borst, Hirzinger: *Capturing robot workspace structure: representing robot
//! capabilities*, IROS 2007 (the paper, §3.3, reference 40). Space round the base is cut into voxels;
//! at the centre of each the map keeps for a fixed grid of directions whether the tool can be there
//! with its z axis in that direction, free to turn about it. Between centres and directions the map is
//! interpolated, and near its boundary it keeps the share of poses of a cell that can be reached, so
//! that the boundary is sharper than the voxels are coarse.
//!
//! | step | what | where |
//! |---|---|---|
//! | sample | random positions of the joints say where the tool gets at all | `build.rs` |
//! | spread | from every pose reached, inverse kinematics tries the next cells, until none is new | `build.rs` |
//! | refine | at the boundary, inverse kinematics tries several poses of each cell | `build.rs` |

mod arm;
mod build;
mod cells;
mod config;
mod directions;
mod error;
mod file;
mod hash;
mod packing;

pub use config::{MapConfig, MapStage, MapTool};
pub use error::MapError;
pub use file::MAX_MAP_BYTES;
pub use hash::RobotHash;

use crate::geometry::{Point3, Pose, Vector3};
use directions::Directions;

/// The value of a cell all of whose poses can be reached; 0 is one of which none can.
const FULL: u8 = 15;

/// Which poses the tool of a chain can be put to, with the tool free to turn about its z axis.
///
/// Made by [`CapabilityMap::build`], which takes a while, and kept as bytes
/// ([`to_bytes`](Self::to_bytes), [`from_bytes`](Self::from_bytes)).
#[derive(Debug, Clone, PartialEq)]
pub struct CapabilityMap {
    about: MapOrigin,
    grid: Grid,
    directions: Directions,
    /// For each voxel the row of its values; row 0 has only zeros.
    rows: Vec<u32>,
    /// Values from 0 to [`FULL`], one per direction, row by row.
    values: Vec<u8>,
}

/// What a map was made from.
#[derive(Debug, Clone, PartialEq)]
pub struct MapOrigin {
    /// The robot's.
    pub robot: RobotHash,
    /// The link round which space is cut into voxels.
    pub base: String,
    /// The link that carries the tool.
    pub tip: String,
    /// The tool in the frame of the tip.
    pub tip_from_tool: Pose,
    /// How the map was made.
    pub config: MapConfig,
}

/// Voxels in a box. Their centres are at whole multiples of the voxel's edge in the base frame.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Grid {
    /// Edge of a voxel [m].
    voxel: f64,
    /// Centre of the first voxel, in voxels.
    lowest: [i32; 3],
    /// Number of voxels along each axis.
    counts: [usize; 3],
}

impl Grid {
    fn voxels(&self) -> usize {
        self.counts.iter().product()
    }

    /// Number of voxels from one to the next along each axis.
    fn strides(&self) -> [usize; 3] {
        let [_, y, z] = self.counts;
        [y * z, z, 1]
    }

    /// The voxel that a point [m] lies in.
    fn at(&self, point_in_base: &Point3) -> Option<usize> {
        let mut voxel = 0;
        for axis in 0..3 {
            let along = (point_in_base[axis] / self.voxel).round() - f64::from(self.lowest[axis]);
            // A number that is none is in no voxel either.
            if !(0.0..self.counts[axis] as f64).contains(&along) {
                return None;
            }
            voxel = voxel * self.counts[axis] + along as usize;
        }
        Some(voxel)
    }

    /// The numbers of a voxel along each axis.
    fn place(&self, voxel: usize) -> [usize; 3] {
        let [_, y, z] = self.counts;
        [voxel / (y * z), voxel / z % y, voxel % z]
    }

    /// Centre of a voxel [m].
    fn center(&self, voxel: usize) -> Point3 {
        let place = self.place(voxel);
        let along = |axis: usize| f64::from(self.lowest[axis]) + place[axis] as f64;
        Point3::new(along(0), along(1), along(2)) * self.voxel
    }

    /// The eight voxels whose centres are round a point, with weights that sum to one; a point
    /// outside has none.
    fn around(&self, point_in_base: &Point3) -> Option<[(usize, f64); 8]> {
        let mut first = 0;
        let mut far = [0.0; 3];
        for axis in 0..3 {
            let along = point_in_base[axis] / self.voxel - f64::from(self.lowest[axis]);
            if !(0.0..self.counts[axis] as f64 - 1.0).contains(&along) {
                return None;
            }
            far[axis] = along.fract();
            first = first * self.counts[axis] + along as usize;
        }
        let strides = self.strides();
        let mut corners = [(first, 1.0); 8];
        for (i, (voxel, weight)) in corners.iter_mut().enumerate() {
            for axis in 0..3 {
                if i >> axis & 1 == 1 {
                    *voxel += strides[axis];
                    *weight *= far[axis];
                } else {
                    *weight *= 1.0 - far[axis];
                }
            }
        }
        Some(corners)
    }
}

impl CapabilityMap {
    /// How surely the tool can be put to a pose in the base frame, free to turn about its z axis: 0,
    /// not at all, to 1, amply. It is the share of the poses nearby that can be reached, so that 1/2
    /// is the boundary. Outside the map it is 0.
    pub fn reachability(&self, base_from_tool: &Pose) -> f64 {
        let point = Point3::from(base_from_tool.translation.vector);
        let Some(voxels) = self.grid.around(&point) else {
            return 0.0;
        };
        let tool_axis = base_from_tool.rotation * Vector3::z();
        let directions = self.directions.locate(&tool_axis);
        let mut sum = 0.0;
        for (voxel, weight) in voxels {
            let row = self.row(voxel);
            for (direction, share) in directions {
                sum += weight * share * f64::from(row[direction]);
            }
        }
        (sum / f64::from(FULL)).clamp(0.0, 1.0)
    }

    /// Whether the tool can be put to a pose in the base frame, free to turn about its z axis:
    /// whether its [`reachability`](Self::reachability) is above one half.
    pub fn is_reachable(&self, base_from_tool: &Pose) -> bool {
        self.reachability(base_from_tool) > 0.5
    }

    /// The share of all directions of the tool's z axis, 0 to 1, that can be reached at a point [m] of
    /// the base frame: Zacharias' reachability index.
    pub fn index(&self, point_in_base: &Point3) -> f64 {
        let Some(voxels) = self.grid.around(point_in_base) else {
            return 0.0;
        };
        let of_voxel = |(voxel, weight): (usize, f64)| {
            let row = self.row(voxel).iter().zip(self.directions.shares());
            let sum: f64 = row.map(|(&value, share)| f64::from(value) * share).sum();
            weight * sum / f64::from(FULL)
        };
        voxels.map(of_voxel).iter().sum()
    }

    /// What the map was made from.
    pub const fn origin(&self) -> &MapOrigin {
        &self.about
    }

    /// The corners of the box [m] in the base frame outside of which nothing can be reached.
    pub fn bounds(&self) -> [Point3; 2] {
        let last = self.grid.voxels().saturating_sub(1);
        [self.grid.center(0), self.grid.center(last)]
    }

    /// Numbers of voxels along x, y and z, and of directions.
    pub fn shape(&self) -> ([usize; 3], usize) {
        (self.grid.counts, self.directions.count())
    }

    /// The values of a voxel.
    fn row(&self, voxel: usize) -> &[u8] {
        let count = self.directions.count();
        let first = self.rows[voxel] as usize * count;
        &self.values[first..first + count]
    }
}
