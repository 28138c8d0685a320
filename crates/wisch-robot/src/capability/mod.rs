//! Capability map: poses that a tool can reach around the base of its chain.
//!
//! After Zacharias, Borst, Hirzinger: *Capturing robot workspace structure: representing robot capabilities*, IROS 2007
//! (the paper, §3.3, reference 40). Space around the base is divided into voxels. At the centre of each, the map stores
//! for a fixed grid of directions whether the tool can be there with its z axis in that direction, free to rotate about
//! it. Between centres and directions the map is interpolated. Near its boundary it stores the share of a cell's poses
//! that can be reached, which makes the boundary sharper than the voxels.
//!
//! | step | what | where |
//! |---|---|---|
//! | sample | random joint positions find poses that the tool can reach | `build.rs` |
//! | spread | from every reached cell, inverse kinematics tries the neighbours until none is new | `build.rs` |
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

pub use config::{MapConfig, MapRequest, MapStage};
pub use error::MapError;
pub use file::MAX_MAP_BYTES;
pub use hash::RobotHash;

use crate::geometry::{Point3, Pose, Vector3};
use directions::Directions;

/// Value of a cell of which all poses can be reached; 0 stands for none.
const FULL: u8 = 15;

/// Poses that the tool of a chain can reach, with the tool free to rotate about its z axis.
///
/// [`CapabilityMap::build`] builds it, which takes a while; [`to_bytes`](Self::to_bytes) and
/// [`from_bytes`](Self::from_bytes) store it.
#[derive(Debug, Clone, PartialEq)]
pub struct CapabilityMap {
    about: MapOrigin,
    grid: Grid,
    directions: Directions,
    /// For each voxel, the row of its values; row 0 has only zeros.
    rows: Vec<u32>,
    /// Values from 0 to [`FULL`], one per direction, row by row.
    values: Vec<u8>,
}

/// Robot, chain and settings of a map.
#[derive(Debug, Clone, PartialEq)]
pub struct MapOrigin {
    /// Hash of the robot.
    pub robot: RobotHash,
    /// Base link, around which space is divided into voxels.
    pub base: String,
    /// Tip link, which carries the tool.
    pub tip: String,
    /// Pose of the tool in the tip.
    pub tip_from_tool: Pose,
    /// Settings of the map.
    pub config: MapConfig,
}

/// A box of voxels, whose centres are at whole multiples of the voxel's edge in the base frame.
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

    /// Index distance between neighbours along each axis.
    fn strides(&self) -> [usize; 3] {
        let [_, y, z] = self.counts;
        [y * z, z, 1]
    }

    /// Returns the voxel that holds a point [m].
    fn at(&self, point_in_base: &Point3) -> Option<usize> {
        let mut voxel = 0;
        for axis in 0..3 {
            let along = (point_in_base[axis] / self.voxel).round() - f64::from(self.lowest[axis]);
            // NaN is in no voxel.
            if !(0.0..self.counts[axis] as f64).contains(&along) {
                return None;
            }
            voxel = voxel * self.counts[axis] + along as usize;
        }
        Some(voxel)
    }

    /// Returns the index of a voxel along each axis.
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

    /// Returns the eight voxels whose centres surround a point, with weights that sum to 1; `None` outside the grid.
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
    /// Returns the reachability of a pose in the base frame, with the tool free to rotate about its
    /// z axis, from 0 to 1 \[1\]: the share of nearby poses that can be reached. The boundary of
    /// the reachable space is at 1/2. Outside the map, the reachability is 0.
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

    /// Whether the tool can reach a pose in the base frame, free to rotate about its z axis: whether its
    /// [`reachability`](Self::reachability) exceeds 1/2.
    pub fn is_reachable(&self, base_from_tool: &Pose) -> bool {
        self.reachability(base_from_tool) > 0.5
    }

    /// Returns the share of directions of the tool's z axis that can be reached at a point \[m\] of the base frame, in
    /// [0, 1]: Zacharias' reachability index.
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

    /// Robot, chain and settings of the map.
    pub const fn origin(&self) -> &MapOrigin {
        &self.about
    }

    /// Returns two corners of the box \[m\] in the base frame outside which nothing can be reached.
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
