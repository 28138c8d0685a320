//! Where the chart of a surface lies in space: in a plane, rolled onto a cylinder or a cone, or over a mesh.
//!
//! Outline, dirt, nodes and strokes are given in the chart, in metres. Cylinders and cones unroll without stretch, so
//! lengths, angles and areas of the chart are those of the surface. The chart of a mesh is stretched by a few percent at
//! most.

use super::cone::Cone;
use super::mesh_shape::{MeshShape, principal_curvatures};
use crate::geometry::{Point2, Point3, Pose, Vector2, Vector3};
use nalgebra::{Matrix2, Translation3, Unit, UnitQuaternion};
use std::f64::consts::PI;
use std::sync::Arc;

/// Largest angle of a chart about the axis of its cylinder or cone, to either side of its origin \[rad\]: beyond it, the
/// surface would nearly close.
pub const MAX_ROLL: f64 = 0.8 * PI;
/// Range of the radius of a cylinder, and of the distance of a cone from its axis \[m\].
pub const RADIUS_RANGE: [f64; 2] = [0.01, 1e9];

/// The shape onto which the chart of a surface is rolled.
///
/// The frame of a surface touches it at the chart's origin: there, the axes of chart and frame agree.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum SurfaceShape {
    /// The chart is the xy plane of the surface's frame.
    #[default]
    Plane,
    /// The chart is rolled onto a circular cylinder.
    Cylinder {
        /// Radius \[m\], positive where the surface bulges towards the tool, negative where it is hollow.
        radius: f64,
        /// Angle of the cylinder's axis from the chart's x \[rad\].
        axis: f64,
    },
    /// The chart is rolled onto a circular cone.
    Cone(Cone),
    /// The chart is that of a mesh.
    Mesh(Arc<MeshShape>),
}

/// Least radii of a shape \[m\]; infinite where it has no such bend.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LeastRadii {
    /// Least radius of the bulges \[m\].
    pub bulge: f64,
    /// Least radius of the hollows \[m\].
    pub hollow: f64,
}

impl LeastRadii {
    pub(super) const NONE: Self = Self {
        bulge: f64::INFINITY,
        hollow: f64::INFINITY,
    };

    /// Returns the least radii of these second fundamental forms \[1/m\].
    pub(super) fn from_bends(bends: impl IntoIterator<Item = Matrix2<f64>>) -> Self {
        (bends.into_iter()).fold(Self::NONE, |least, bend| {
            let [larger, smaller] = principal_curvatures(&bend);
            Self {
                bulge: least.bulge.min(1.0 / larger.max(0.0)),
                hollow: least.hollow.min(1.0 / (-smaller).max(0.0)),
            }
        })
    }

    /// The smaller of the two \[m\].
    pub fn least(&self) -> f64 {
        self.bulge.min(self.hollow)
    }
}

/// A point in space relative to a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChartPoint {
    /// Foot of the perpendicular, in the chart \[m\].
    pub place: Point2,
    /// Height over the surface, along its normal \[m\].
    pub height: f64,
}

impl SurfaceShape {
    /// Whether the surface is a plane.
    pub const fn is_plane(&self) -> bool {
        matches!(self, Self::Plane)
    }

    /// Returns the pose of a frame whose origin is at a height \[m\] over a place of the chart \[m\], with z along the
    /// normal and x and y along those of the chart; in the frame of the surface.
    ///
    /// ```
    /// use std::f64::consts::FRAC_PI_2;
    /// use wisch::geometry::{Point2, Vector3};
    /// use wisch::represent::SurfaceShape;
    /// // A quarter turn about a pipe of 0.5 m that lies along y.
    /// let pipe = SurfaceShape::Cylinder { radius: 0.5, axis: FRAC_PI_2 };
    /// let pose = pipe.place(Point2::new(-0.5 * FRAC_PI_2, 0.3), 0.1);
    /// assert!((pose.translation.vector - Vector3::new(-0.6, 0.3, -0.5)).norm() < 1e-12);
    /// assert!((pose.rotation * Vector3::z() + Vector3::x()).norm() < 1e-12);
    /// ```
    pub fn place(&self, place: Point2, height: f64) -> Pose {
        match self {
            Self::Plane => Pose::translation(place.x, place.y, height),
            Self::Cone(cone) => cone.place(place, height),
            Self::Mesh(mesh) => mesh.place(place, height),
            &Self::Cylinder { radius, axis } => {
                let [along, across] = directions(axis);
                let angle = across.dot(&place.coords) / radius;
                let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
                let half = libm::sin(0.5 * angle);
                // (R + h) sin φ across the axis; (R + h) cos φ − R = h cos φ − 2 R sin²(φ/2) along z.
                let in_plane =
                    along * along.dot(&place.coords) + across * ((radius + height) * sine);
                let z = height * cosine - 2.0 * radius * half * half;
                // z turns towards `across`, which is a negative turn about the axis.
                let axis = Unit::new_unchecked(Vector3::new(along.x, along.y, 0.0));
                Pose::from_parts(
                    Translation3::new(in_plane.x, in_plane.y, z),
                    UnitQuaternion::from_axis_angle(&axis, -angle),
                )
            }
        }
    }

    /// Returns the place and the height of a point in the frame of the surface: the inverse of [`Self::place`].
    ///
    /// A point on the axis of a cylinder or a cone has the foot φ = 0. Points beyond the apex of a
    /// cone have the apex as foot.
    pub fn chart(&self, point: Point3) -> ChartPoint {
        match self {
            Self::Plane => ChartPoint {
                place: point.xy(),
                height: point.z,
            },
            Self::Cone(cone) => cone.chart(point),
            Self::Mesh(mesh) => {
                let (place, height) = mesh.sheet().chart_extended(point);
                ChartPoint { place, height }
            }
            &Self::Cylinder { radius, axis } => {
                let [along, across] = directions(axis);
                let (v, u) = (
                    along.dot(&point.coords.xy()),
                    across.dot(&point.coords.xy()),
                );
                let side = radius.signum();
                let angle = libm::atan2(side * u, side * (point.z + radius));
                let distance = libm::hypot(u, point.z + radius);
                // ±(ρ − |R|), without cancellation: ρ² − R² = u² + z² + 2 z R.
                let height =
                    side * (u * u + point.z * (point.z + 2.0 * radius)) / (distance + radius.abs());
                ChartPoint {
                    place: Point2::from(along * v + across * (radius * angle)),
                    height,
                }
            }
        }
    }

    /// Returns the place of the surface below a point of the frame's xy plane \[m\], along the z
    /// axis of the frame; `None` if there is none. On a cylinder or a cone, the place lies on the
    /// side of the chart's origin.
    ///
    /// ```
    /// use std::f64::consts::FRAC_PI_2;
    /// use wisch::geometry::Point2;
    /// use wisch::represent::SurfaceShape;
    /// let pipe = SurfaceShape::Cylinder { radius: 0.5, axis: FRAC_PI_2 };
    /// let seen = pipe.place_below(Point2::new(0.25, 0.1)).ok_or("none")?;
    /// assert!((seen - Point2::new(0.5 * 0.5_f64.asin(), 0.1)).norm() < 1e-12);
    /// assert_eq!(pipe.place_below(Point2::new(0.6, 0.0)), None);
    /// # Ok::<(), &str>(())
    /// ```
    pub fn place_below(&self, point: Point2) -> Option<Point2> {
        match self {
            Self::Plane => Some(point),
            Self::Cone(cone) => cone.place_below(point),
            Self::Mesh(mesh) => mesh.sheet().place_below(point),
            &Self::Cylinder { radius, axis } => {
                let [along, across] = directions(axis);
                let sine = across.dot(&point.coords) / radius;
                (sine.abs() <= 1.0).then(|| {
                    let v = along.dot(&point.coords);
                    Point2::from(along * v + across * (radius * libm::asin(sine)))
                })
            }
        }
    }

    /// Returns the orientation of the frame of [`Self::place`] in the frame of the surface.
    pub fn orientation(&self, place: Point2) -> UnitQuaternion<f64> {
        match self {
            Self::Plane => UnitQuaternion::identity(),
            Self::Cylinder { .. } | Self::Cone(_) | Self::Mesh(_) => {
                self.place(place, 0.0).rotation
            }
        }
    }

    /// Returns the second fundamental form at a place, in the axes of the chart \[1/m\], positive
    /// where the surface bulges towards the tool; on a cylinder, it is the same everywhere.
    pub fn bend(&self, place: Point2) -> Matrix2<f64> {
        match self {
            Self::Plane => Matrix2::zeros(),
            Self::Cone(cone) => cone.bend(place),
            Self::Mesh(mesh) => mesh.sheet().bend(place),
            &Self::Cylinder { radius, axis } => {
                let [_, across] = directions(axis);
                across * across.transpose() / radius
            }
        }
    }

    /// Returns the angle about the axis of a cylinder or a cone from the chart's origin to a place
    /// \[rad\]; 0 on other shapes.
    pub fn roll(&self, place: Point2) -> f64 {
        match self {
            Self::Plane | Self::Mesh(_) => 0.0,
            Self::Cone(cone) => cone.roll(place),
            &Self::Cylinder { radius, axis } => {
                let [_, across] = directions(axis);
                across.dot(&place.coords) / radius
            }
        }
    }

    /// Returns the angle by which the normal turns on the straight path between two places of the
    /// chart \[rad\].
    pub fn turn_between(&self, from: Point2, to: Point2) -> f64 {
        match self {
            Self::Plane => 0.0,
            Self::Cone(cone) => cone.turn_between(from, to),
            Self::Mesh(mesh) => mesh.turn_between(from, to),
            &Self::Cylinder { radius, axis } => {
                let [_, across] = directions(axis);
                (across.dot(&(to - from)) / radius).abs()
            }
        }
    }
}

/// Directions along the axis of a cylinder and across it, in the chart.
fn directions(axis: f64) -> [Vector2; 2] {
    let along = Vector2::new(libm::cos(axis), libm::sin(axis));
    [along, Vector2::new(-along.y, along.x)]
}
