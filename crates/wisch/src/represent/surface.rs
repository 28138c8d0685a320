//! The target surface: a polygon in a chart, with the chart's shape and pose, and the edges over which a skim may push.

use super::{ChartPoint, Cone, HALF_ANGLE_RANGE, LeastRadii, MAX_ROLL, RADIUS_RANGE, SurfaceShape};
use crate::geometry::{Edge, Mesh, MeshError, Point2, Point3, Polygon, Pose, Vector3, prism_below};
use nalgebra::Matrix2;
use std::f64::consts::PI;

/// A target surface: an outline in a chart, and the place of the chart in space. The z axis of its
/// frame points out of the surface at the chart's origin.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    /// Name in the knowledge base and in PDDL goals.
    pub name: String,
    /// Outline in the chart \[m\]; of a plane, in the surface frame.
    pub outline: Polygon,
    /// Pose of the surface in the world.
    pub world_from_surface: Pose,
    /// Indices of the outline's edges over which a skim may push particles.
    pub skim_edges: Vec<usize>,
    /// The shape onto which the chart is rolled.
    pub shape: SurfaceShape,
}

impl Surface {
    /// Returns a plane without edges over which dirt may be skimmed.
    ///
    /// # Parameters
    /// - `outline`: its outline in the surface frame \[m\].
    /// - `world_from_surface`: the pose of its frame in the world; z is the outward normal.
    pub fn new(name: impl Into<String>, outline: Polygon, world_from_surface: Pose) -> Self {
        Self {
            name: name.into(),
            outline,
            world_from_surface,
            skim_edges: Vec::new(),
            shape: SurfaceShape::Plane,
        }
    }

    /// Returns the pose in the world of a frame over a place of the chart, see [`SurfaceShape::place`].
    pub fn world_from_place(&self, place: Point2, height: f64) -> Pose {
        self.world_from_surface * self.shape.place(place, height)
    }

    /// Returns the place in the chart and the height over the surface of a point in the world \[m\].
    pub fn chart(&self, point_in_world: Point3) -> ChartPoint {
        self.shape
            .chart(self.world_from_surface.inverse() * point_in_world)
    }

    /// Returns the outward normal over a place of the chart, in the world.
    pub fn normal(&self, place: Point2) -> Vector3 {
        self.world_from_surface * (self.shape.orientation(place) * Vector3::z())
    }

    /// Returns the pose of the tool in the axes of the chart, over its place in the chart: x, y and z are its place and
    /// its height \[m\], and the rotation is relative to the surface there.
    pub fn chart_from_tool(&self, world_from_tool: &Pose) -> Pose {
        let surface_from_tool = self.world_from_surface.inverse() * world_from_tool;
        if self.shape.is_plane() {
            return surface_from_tool;
        }
        let ChartPoint { place, height } = self
            .shape
            .chart(surface_from_tool.translation.vector.into());
        let turn = self.shape.orientation(place).inverse() * surface_from_tool.rotation;
        Pose::from_parts(nalgebra::Translation3::new(place.x, place.y, height), turn)
    }

    /// Returns places with their second fundamental forms, in the axes of the chart \[1/m\]. A
    /// plane has none, a cylinder one, a cone the strongest and the weakest. A mesh has those of
    /// places about half a tool's radius apart.
    pub fn bends(&self) -> Vec<(Point2, Matrix2<f64>)> {
        let with_bend = |place: Point2| (place, self.shape.bend(place));
        match &self.shape {
            SurfaceShape::Plane => Vec::new(),
            SurfaceShape::Cylinder { .. } => vec![with_bend(Point2::origin())],
            SurfaceShape::Cone(cone) => {
                let apex = cone.apex();
                let distance = |place: &Point2| (place - apex).norm();
                let corners = self.outline.outer().iter().copied();
                let farthest = corners.max_by(|a, b| distance(a).total_cmp(&distance(b)));
                let nearest = nearest_on_border(&self.outline, apex);
                nearest.into_iter().chain(farthest).map(with_bend).collect()
            }
            SurfaceShape::Mesh(mesh) => mesh.bends().collect(),
        }
    }

    /// Returns the bend to which a tool fits worst, in the axes of the chart \[1/m\]: a bulge
    /// counts as much as a hollow of half its radius.
    pub fn tightest_bend(&self) -> Matrix2<f64> {
        match &self.shape {
            SurfaceShape::Mesh(mesh) => mesh.tightest_bend(),
            _ => (self.bends().first()).map_or_else(Matrix2::zeros, |(_, bend)| *bend),
        }
    }

    /// Returns the least radii of curvature that occur, see [`Self::bends`].
    pub fn least_radii(&self) -> LeastRadii {
        match self.shape {
            SurfaceShape::Cylinder { radius, .. } if radius > 0.0 => LeastRadii {
                bulge: radius,
                ..LeastRadii::NONE
            },
            SurfaceShape::Cylinder { radius, .. } => LeastRadii {
                hollow: -radius,
                ..LeastRadii::NONE
            },
            _ => LeastRadii::from_bends(self.bends().into_iter().map(|(_, bend)| bend)),
        }
    }

    /// Returns the largest angle between the normal and the vertical \[rad\], over the outline and within it.
    pub fn steepest_slope(&self) -> f64 {
        let edges = || self.outline.edges();
        // Every line of a cylinder or a cone, along which the normal is constant, leaves the outline over an edge.
        let places: Vec<Point2> = match &self.shape {
            SurfaceShape::Plane => self.outline.outer().to_vec(),
            SurfaceShape::Cylinder { .. } | SurfaceShape::Cone(_) => edges()
                .flat_map(|edge| {
                    (0..=SLOPES_OF_EDGE).map(move |i| {
                        let share = f64::from(i) / f64::from(SLOPES_OF_EDGE);
                        edge.start + (edge.end - edge.start) * share
                    })
                })
                .collect(),
            SurfaceShape::Mesh(mesh) => {
                let within = mesh.bends().map(|(place, _)| place);
                self.outline.outer().iter().copied().chain(within).collect()
            }
        };
        let angle = |place: Point2| self.normal(place).angle(&Vector3::z());
        places.into_iter().map(angle).fold(0.0, f64::max)
    }

    /// Returns the reason why the chart does not fit its shape, if there is one.
    pub fn shape_fault(&self) -> Option<ShapeFault> {
        let (shape, radius, axis) = match self.shape {
            SurfaceShape::Plane | SurfaceShape::Mesh(_) => return None,
            SurfaceShape::Cylinder { radius, axis } => ("cylinder", radius, axis),
            SurfaceShape::Cone(cone) => ("cone", cone.radius, cone.axis),
        };
        let [least, most] = RADIUS_RANGE;
        if !(least..=most).contains(&radius.abs()) || !axis.is_finite() {
            return Some(ShapeFault::Radius { shape, radius });
        }
        if let SurfaceShape::Cone(cone) = &self.shape
            && let Some(fault) = self.cone_fault(cone)
        {
            return Some(fault);
        }
        let roll = |place: &Point2| self.shape.roll(*place).abs();
        let angle = self.outline.outer().iter().map(roll).fold(0.0, f64::max);
        (angle > MAX_ROLL).then_some(ShapeFault::Roll {
            shape,
            radius,
            angle,
        })
    }

    /// Returns the reason why the chart does not fit a cone, except for the angle of its corners
    /// about the axis.
    fn cone_fault(&self, cone: &Cone) -> Option<ShapeFault> {
        let [least, most] = HALF_ANGLE_RANGE;
        let half_angle = cone.half_angle;
        if !(least..=most).contains(&half_angle) {
            return Some(ShapeFault::HalfAngle { half_angle });
        }
        let apex = cone.apex();
        let nearest = nearest_on_border(&self.outline, apex)?;
        let sine = libm::sin(half_angle);
        let narrowest = if self.outline.contains(apex) {
            0.0
        } else {
            (nearest - apex).norm() * sine
        };
        if narrowest < RADIUS_RANGE[0] {
            // In micrometres, without a negative zero.
            let apex = apex.map(|at| (at * 1e6).round() / 1e6 + 0.0);
            return Some(ShapeFault::Apex { apex, narrowest });
        }
        // An edge that passes behind the apex goes half round it.
        (self.outline.edges()).find_map(|edge| {
            let [from, to] = [edge.start, edge.end].map(|place| cone.past_roll(place, 0.0));
            let at = edge.start + (edge.end - edge.start) * (from / (from - to));
            let is_behind = (at - apex).dot(&apex.coords) > 0.0;
            ((from < 0.0) != (to < 0.0) && is_behind).then_some(ShapeFault::Roll {
                shape: "cone",
                radius: cone.radius,
                angle: PI / sine,
            })
        })
    }
}

/// Returns the place on the border of a polygon that is nearest to a point; `None` without a border.
fn nearest_on_border(outline: &Polygon, point: Point2) -> Option<Point2> {
    let feet = outline.edges().map(|edge| {
        let along = edge.end - edge.start;
        let squared = along.norm_squared();
        let share = if squared > 0.0 {
            ((point - edge.start).dot(&along) / squared).clamp(0.0, 1.0)
        } else {
            0.0
        };
        edge.start + along * share
    });
    feet.min_by(|a, b| {
        (a - point)
            .norm_squared()
            .total_cmp(&(b - point).norm_squared())
    })
}

/// The reason why a chart does not fit its shape.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum ShapeFault {
    /// The radius is out of its range, or the axis not finite.
    #[error("radius {radius} m of the {shape} is outside {} to {} m in size", RADIUS_RANGE[0], RADIUS_RANGE[1])]
    Radius {
        /// Kind of the shape.
        shape: &'static str,
        /// Radius \[m\].
        radius: f64,
    },
    /// The half angle of a cone is out of its range.
    #[error("half angle {half_angle} rad of the cone is outside {} to {} rad", HALF_ANGLE_RANGE[0], HALF_ANGLE_RANGE[1])]
    HalfAngle {
        /// Half angle \[rad\].
        half_angle: f64,
    },
    /// The chart reaches the apex of its cone.
    #[error("the outline reaches to {narrowest:.3} m from the axis of the cone, whose apex is at ({:.3}, {:.3}) m of the chart; the limit is {} m", apex.x, apex.y, RADIUS_RANGE[0])]
    Apex {
        /// Place of the apex \[m\].
        apex: Point2,
        /// Least distance of the outline from the axis \[m\].
        narrowest: f64,
    },
    /// The chart would nearly close around the axis.
    #[error("the outline reaches {:.0}° about the axis of the {shape} of radius {radius} m; the limit is {:.0}° to either side of the origin", angle.to_degrees(), MAX_ROLL.to_degrees())]
    Roll {
        /// Kind of the shape.
        shape: &'static str,
        /// Radius \[m\].
        radius: f64,
        /// Largest angle of the outline from the origin \[rad\].
        angle: f64,
    },
}

/// The kind of place at a point of the surface's plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ground {
    /// The surface.
    Surface,
    /// A hole of the surface, by its index.
    Hole(usize),
    /// Nothing: the point is beyond the outer border.
    Beyond,
}

/// A part of a straight move over the plane of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MoveSegment {
    /// The kind of place under the part.
    pub ground: Ground,
    /// Begin and end of the part, as shares of the move \[1\].
    pub shares: [f64; 2],
}

/// Vertical component of a normal up to which a surface counts as upright and not as facing down [1]: a right angle that is
/// rounded in a task file.
pub(super) const UPRIGHT: f64 = 1e-3;
/// Least length of a part [m]: a move along a border stays on the surface.
const LEAST_PART: f64 = 1e-6;

impl Surface {
    /// Returns the kind of place at a point of the plane (surface frame \[m\]). A point on a border
    /// belongs to either side.
    pub fn ground(&self, point: Point2) -> Ground {
        let ring = |ring: &[Point2]| Polygon::new(ring.to_vec(), Vec::new()).contains(point);
        if self.outline.contains(point) {
            return Ground::Surface;
        }
        match self.outline.holes().iter().position(|hole| ring(hole)) {
            Some(hole) => Ground::Hole(hole),
            None => Ground::Beyond,
        }
    }

    /// Returns the parts of a straight move, in order; adjacent parts differ. A move of length 0 has one part.
    pub fn split_move(&self, from: Point2, to: Point2) -> Vec<MoveSegment> {
        let along = to - from;
        let length = along.norm();
        let mut shares = vec![0.0, 1.0];
        for edge in self.outline.edges() {
            let border = edge.end - edge.start;
            let divisor = along.perp(&border);
            if divisor == 0.0 {
                continue;
            }
            let share = (edge.start - from).perp(&border) / divisor;
            let on_border = (edge.start - from).perp(&along) / divisor;
            // A vertex belongs to both of its edges.
            if (0.0..=1.0).contains(&share) && (-1e-9..=1.0 + 1e-9).contains(&on_border) {
                shares.push(share);
            }
        }
        shares.sort_by(f64::total_cmp);
        let mut parts: Vec<MoveSegment> = Vec::new();
        for pair in shares.windows(2) {
            let &[begin, end] = pair else { continue };
            if (end - begin) * length <= LEAST_PART {
                continue;
            }
            let ground = self.ground(from + along * ((begin + end) / 2.0));
            match parts.last_mut() {
                Some(last) if last.ground == ground => last.shares[1] = end,
                _ => parts.push(MoveSegment {
                    ground,
                    shares: [begin, end],
                }),
            }
        }
        if parts.is_empty() {
            parts.push(MoveSegment {
                ground: self.ground(from),
                shares: [0.0, 1.0],
            });
        }
        parts
    }

    /// Whether the surface carries a tool that is pressed along a straight move (surface frame
    /// \[m\]). It does if the move crosses no hole, and is beyond the border only before it first
    /// reaches the surface and after it has finally left it.
    pub fn carries_between(&self, from: Point2, to: Point2) -> bool {
        if self.outline.is_convex() {
            return true;
        }
        let parts = self.split_move(from, to);
        let last = parts.len() - 1;
        parts.iter().enumerate().all(|(i, part)| match part.ground {
            Ground::Surface => true,
            Ground::Hole(_) => false,
            Ground::Beyond => i == 0 || i == last,
        })
    }

    /// Whether a point that moves straight (surface frame \[m\]) crosses no hole, and is never
    /// farther beyond the outer border than `overhang` \[m\]. During such a move of a tool's
    /// centre, the rest of its footprint supports the tool.
    ///
    /// ```
    /// use wisch::geometry::{Point2, Polygon, Pose, Vector2};
    /// use wisch::represent::Surface;
    /// let outline = Polygon::rectangle(Vector2::new(0.4, 0.2));
    /// let plate = Surface::new("plate", outline, Pose::identity());
    /// let [inside, beside] = [Point2::origin(), Point2::new(0.21, 0.0)];
    /// assert!(plate.supports_between(inside, beside, 0.02));
    /// assert!(!plate.supports_between(inside, beside, 0.005));
    /// ```
    pub fn supports_between(&self, from: Point2, to: Point2, overhang: f64) -> bool {
        let ends_inside = self.outline.contains(from) && self.outline.contains(to);
        if ends_inside && self.outline.is_convex() {
            return true;
        }
        let is_near = |place: Point2| {
            let mut edges = self.outline.edges();
            edges.any(|edge| edge.distance(place) <= overhang + LEAST_PART)
        };
        self.split_move(from, to).iter().all(|part| {
            let [begin, end] = part.shares;
            match part.ground {
                Ground::Surface => true,
                Ground::Hole(_) => false,
                // Beyond a convex border the distance is greatest at an end, in a notch perhaps in the middle.
                Ground::Beyond => {
                    let places = [begin, (begin + end) / 2.0, end];
                    places
                        .into_iter()
                        .all(|share| is_near(from + (to - from) * share))
                }
            }
        })
    }

    /// Returns the edge over which a straight move from `from` (on the surface) to `to` first
    /// leaves the surface (surface frame \[m\]).
    ///
    /// A move that ends inside but crosses a notch has left the surface.
    pub fn exit_edge(&self, from: Point2, to: Point2) -> Option<usize> {
        self.outline
            .edges()
            .enumerate()
            .filter_map(|(index, edge)| crossing(from, to, &edge).map(|share| (share, index)))
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map(|(_, index)| index)
    }

    /// Returns the body under the surface down to a depth \[m\], in the surface frame: the outline with its holes, as a
    /// closed mesh. Facets replace a curved surface.
    ///
    /// # Errors
    /// An outline without area.
    pub fn solid_below(&self, depth: f64) -> Result<Mesh, MeshError> {
        let prism = prism_below(&self.outline, depth)?;
        if self.shape.is_plane() {
            return Ok(prism);
        }
        let radii = self.least_radii();
        // A facet of length l lies off an arc of radius R by l²/8R.
        let longest = match &self.shape {
            SurfaceShape::Mesh(_) => (8.0 * radii.least() * MESH_FACET_ERROR)
                .sqrt()
                .clamp(LEAST_FACET, MOST_FACET),
            _ => (8.0 * radii.least() * FACET_ERROR).sqrt(),
        };
        let fine = match &self.shape {
            // A cone bends less the farther it is from its apex.
            SurfaceShape::Cone(cone) => {
                let longest = |at: &Point3| {
                    let bend = cone.bend(at.xy()).trace().abs();
                    (8.0 * FACET_ERROR / bend).sqrt()
                };
                let excess = |a: &Point3, b: &Point3| (a - b).norm() / longest(a).min(longest(b));
                prism.split_edges_by(excess, 1.0)
            }
            _ => prism.split_edges(longest),
        };
        // Under a bulge, nothing lies beyond the axis.
        let deepest = -0.9 * radii.bulge;
        let rolled = |p: &Point3| -> Point3 {
            let place = self.shape.place(p.xy(), p.z.max(deepest));
            place.translation.vector.into()
        };
        Mesh::new(
            fine.vertices().iter().map(rolled).collect(),
            fine.triangles().to_vec(),
        )
    }

    /// Whether a skim may push particles over edge `index`.
    pub fn is_skim_edge(&self, index: usize) -> bool {
        self.skim_edges.contains(&index)
    }
}

/// Number of parts of an edge at whose ends the slope is examined.
const SLOPES_OF_EDGE: u32 = 64;
/// Largest distance of a facet from the surface that it replaces [m].
const FACET_ERROR: f64 = 1e-4;
/// Largest distance of a facet from a mesh, where the tightest bend counts everywhere [m], and the
/// range of the facets' lengths [m].
const MESH_FACET_ERROR: f64 = 5e-4;
const LEAST_FACET: f64 = 0.03;
const MOST_FACET: f64 = 0.1;
/// Share of the move `from → to` (0..1) at which it crosses the edge outwards; `None` if it does not.
fn crossing(from: Point2, to: Point2, edge: &Edge) -> Option<f64> {
    let along = edge.end - edge.start;
    // The interior lies left of an edge, so a positive side is inside.
    let side_from = along.perp(&(from - edge.start));
    let side_to = along.perp(&(to - edge.start));
    if side_from < 0.0 || side_to >= 0.0 {
        return None;
    }
    let s = side_from / (side_from - side_to);
    let at = from + (to - from) * s;
    let t = (at - edge.start).dot(&along) / along.norm_squared();
    (0.0..=1.0).contains(&t).then_some(s)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Vector2;

    #[test]
    fn a_way_over_a_hole_or_through_a_notch_is_not_carried() {
        let point = |[x, y]: [f64; 2]| Point2::new(x, y);
        let ring = |corners: &[[f64; 2]]| corners.iter().copied().map(point).collect::<Vec<_>>();
        // A U of 0.6 x 0.4 m, open upwards between x = -0.1 and 0.1, with a square hole about (0.2, -0.1).
        let outer = ring(&[
            [-0.3, -0.2],
            [0.3, -0.2],
            [0.3, 0.2],
            [0.1, 0.2],
            [0.1, 0.0],
            [-0.1, 0.0],
            [-0.1, 0.2],
            [-0.3, 0.2],
        ]);
        let hole = ring(&[[0.17, -0.13], [0.23, -0.13], [0.23, -0.07], [0.17, -0.07]]);
        let surface = Surface {
            name: "u".into(),
            outline: Polygon::new(outer, vec![hole]),
            world_from_surface: Pose::identity(),
            skim_edges: vec![0],
            shape: Default::default(),
        };
        let carries = |from, to| surface.carries_between(point(from), point(to));
        assert!(carries([-0.2, 0.1], [-0.2, -0.1]));
        assert!(carries([-0.2, -0.15], [0.28, -0.15]));
        // From one leg to the other, and along the bottom of the notch.
        assert!(!carries([-0.2, 0.1], [0.2, 0.1]));
        assert!(carries([-0.2, -0.01], [0.2, -0.01]));
        // Over the hole: straight, from corner to corner, and to its middle.
        assert!(!carries([0.2, 0.0], [0.2, -0.18]));
        assert!(!carries([0.15, -0.15], [0.25, -0.05]));
        assert!(!carries([0.2, 0.0], [0.2, -0.1]));
        // Off the border for good, or onto the surface.
        assert!(carries([0.0, -0.1], [0.0, -0.3]) && carries([0.0, -0.3], [0.0, -0.1]));
        let parts = surface.split_move(point([0.1, -0.1]), point([0.3, -0.1]));
        let grounds: Vec<Ground> = parts.iter().map(|part| part.ground).collect();
        assert_eq!(grounds, [Ground::Surface, Ground::Hole(0), Ground::Surface]);
        assert!(
            (parts[1].shares[0] - 0.35).abs() < 1e-9 && (parts[1].shares[1] - 0.65).abs() < 1e-9
        );
    }

    #[test]
    fn a_move_leaves_over_the_first_edge_it_crosses() {
        let surface = Surface {
            name: "board".into(),
            outline: Polygon::rectangle(Vector2::new(0.4, 0.2)),
            world_from_surface: Pose::identity(),
            skim_edges: vec![0],
            shape: Default::default(),
        };
        let from = Point2::new(0.15, 0.05);
        assert_eq!(surface.exit_edge(from, Point2::new(0.19, 0.09)), None);
        assert_eq!(surface.exit_edge(from, Point2::new(0.15, -0.2)), Some(0));
        assert_eq!(surface.exit_edge(from, Point2::new(0.5, 0.2)), Some(1));
        assert_eq!(surface.exit_edge(from, Point2::new(0.15, 0.4)), Some(2));
        assert_eq!(surface.exit_edge(from, Point2::new(-1.0, 0.05)), Some(3));
    }
}
