//! The robot of the robot file: joints, tool and frames.

use nalgebra::Vector3;
use std::path::Path;
use wisch::geometry::Pose;
use wisch::robot::{LinkId, RobotModel};
use wisch_io::Robot;

/// The robot's model.
pub(crate) struct Frames {
    pub model: RobotModel,
    /// Link in whose axes frames of force mode are given, with its name.
    pub base: (LinkId, String),
    /// The text of the URDF.
    pub urdf: String,
    /// Path of the URDF, or the name of a shipped robot.
    pub source: String,
}

impl Frames {
    /// Reads the URDF of a robot file. `urdf`: path relative to the file's folder, or the name of a shipped robot.
    ///
    /// # Errors
    /// If the URDF cannot be read, or has no such base frame.
    pub fn read(file: &Path, urdf: &str, base_frame: Option<&str>) -> Result<Self, String> {
        let beside = file.parent().unwrap_or(Path::new("")).join(urdf);
        let name = if urdf.contains(['.', '/']) {
            beside.display().to_string()
        } else {
            urdf.to_owned()
        };
        let robot = Robot::load(&name).map_err(|error| error.to_string())?;
        let links = robot.model.links();
        let base = match base_frame {
            Some(name) => {
                let link = robot.model.link(name);
                (
                    link.map_err(|error| format!("base_frame: {error}"))?,
                    name.to_owned(),
                )
            }
            None => {
                let root = robot.model.root();
                (root, links[root.index()].name.clone())
            }
        };
        Ok(Self {
            urdf: robot.files.urdf,
            model: robot.model,
            base,
            source: name,
        })
    }

    /// Names of the joints, in the order of the URDF.
    pub fn joint_names(&self) -> Vec<String> {
        (0..self.model.dof())
            .map(|i| self.model.variable(i).name.clone())
            .collect()
    }

    /// Largest velocity of each joint by the URDF [rad/s or m/s]; `None` where it states none.
    pub fn velocity_limits(&self) -> Vec<Option<f64>> {
        (0..self.model.dof())
            .map(|i| self.model.variable(i).limits.velocity)
            .collect()
    }

    /// Unit of the positions of each joint: "rad" or "m".
    pub fn units(&self) -> Vec<&'static str> {
        (0..self.model.dof())
            .map(|i| self.model.variable(i).kind.unit())
            .collect()
    }

    /// The link of this name.
    pub fn link(&self, name: &str) -> Option<LinkId> {
        // Some drivers send names with a slash in front, as ROS 1 did.
        self.model.link(name.trim_start_matches('/')).ok()
    }

    /// Returns the pose of a link in the root link.
    pub fn root_from_link(&self, positions: &[f64], link: LinkId) -> Option<Pose> {
        let kinematics = self.model.forward_kinematics(positions).ok()?;
        Some(kinematics.world_from_link(link))
    }

    /// Returns a force in the axes of a link, turned into the axes of the base frame.
    pub fn turn_to_base(
        &self,
        positions: &[f64],
        link: LinkId,
        force: Vector3<f64>,
    ) -> Option<Vector3<f64>> {
        let root_from_base = self.root_from_link(positions, self.base.0)?;
        let root_from_link = self.root_from_link(positions, link)?;
        Some(root_from_base.rotation.inverse() * (root_from_link.rotation * force))
    }
}
