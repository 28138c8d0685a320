//! Masses of links whose URDF has none, as in many URDFs of industrial arms.

use crate::geometry::{Point3, Pose, Vector3};
use crate::{Body, JointKind, LinkId, RobotModel};
use nalgebra::Matrix3;

/// Density of the box around a link's collision shapes [kg/m³]: industrial arms have 300 to 900.
pub const ASSUMED_DENSITY: f64 = 500.0;
/// Edge of the box of a link without collision shapes [m].
const LEAST_EDGE: f64 = 0.05;

impl RobotModel {
    /// Gives a mass to each moved link that has none and carries no link with a mass. It is the
    /// mass of the box around the collision shapes of the link and of the links fixed to it, at
    /// [`ASSUMED_DENSITY`]. Returns these links.
    ///
    /// ```
    /// use wisch_robot::{ASSUMED_DENSITY, RobotModel};
    /// let text = r#"<robot name="pendulum"><link name="wall"/>
    ///   <link name="rod"><collision><origin xyz="0.5 0 0"/><geometry><box size="1 0.1 0.1"/></geometry></collision></link>
    ///   <joint name="pivot" type="continuous"><parent link="wall"/><child link="rod"/><axis xyz="0 1 0"/></joint>
    /// </robot>"#;
    /// let mut robot = RobotModel::from_urdf("pendulum", text, &mut |_| Err(String::new()))?;
    /// assert!(robot.dynamics().is_err());
    /// assert_eq!(robot.assume_masses(), [robot.link("rod")?]);
    /// assert!((robot.dynamics()?.mass_matrix(&[0.0])?[(0, 0)] - ASSUMED_DENSITY * 0.01 * (0.25 + 1.01 / 12.0)).abs() < 1e-9);
    /// # Ok::<(), wisch_robot::RobotError>(())
    /// ```
    pub fn assume_masses(&mut self) -> Vec<LinkId> {
        let has_mass = |link: LinkId| self.links()[link.index()].body.is_some();
        let moved = self
            .joints()
            .iter()
            .filter(|joint| joint.kind != JointKind::Fixed);
        let massless: Vec<LinkId> = moved
            .map(|joint| joint.child)
            .filter(|&link| !self.carried_links(link).into_iter().any(has_mass))
            .collect();
        let bodies: Vec<Body> = massless.iter().map(|&link| self.solid_body(link)).collect();
        for (link, body) in massless.iter().zip(bodies) {
            self.replace_body(*link, body);
        }
        massless
    }

    /// Returns the body of the box around the shapes of a link and of the links fixed to it.
    fn solid_body(&self, link: LinkId) -> Body {
        let mut fixed = vec![(link, Pose::identity())];
        for joint in self.joints() {
            let holder = fixed.iter().find(|(known, _)| *known == joint.parent);
            if let (JointKind::Fixed, Some((_, link_from_holder))) = (joint.kind, holder) {
                fixed.push((joint.child, link_from_holder * joint.parent_from_joint));
            }
        }
        let half = Vector3::repeat(LEAST_EDGE / 2.0);
        let points = fixed.iter().flat_map(|(part, link_from_part)| {
            let shapes = self.links()[part.index()].collision.iter();
            let meshes = shapes.filter_map(|shape| shape.mesh_in_link());
            meshes.flat_map(move |mesh| {
                let points = mesh.vertices().iter().map(|point| link_from_part * point);
                points.collect::<Vec<_>>()
            })
        });
        let bounds = points.fold(None, |bounds: Option<(Point3, Point3)>, point| {
            Some(bounds.map_or((point, point), |(low, high)| {
                (low.inf(&point), high.sup(&point))
            }))
        });
        let (low, high) = bounds.unwrap_or_else(|| (Point3::from(-half), Point3::from(half)));
        let size = (high - low).sup(&(half / 5.0));
        let mass = ASSUMED_DENSITY * size.product();
        let [x, y, z] = size.component_mul(&size).into();
        let about = Vector3::new(y + z, x + z, x + y) * (mass / 12.0);
        Body {
            mass,
            center_in_link: nalgebra::center(&low, &high),
            inertia_about_center: Matrix3::from_diagonal(&about),
        }
    }
}
