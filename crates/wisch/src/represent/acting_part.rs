//! The part of a footprint that acts on a curved surface: the part whose pressure is high enough.

use super::{ElasticFoundation, LocalPressure, Surface, SurfaceShape, principal_curvatures};
use crate::geometry::{Edge, Point2, Polygon, Region, Vector2};
use nalgebra::{Matrix2, Rotation2};
use std::f64::consts::PI;

/// Number of yaws at which the tool is tried.
const YAWS: usize = 90;
/// Number of sides of the polygon that replaces a disc.
const SIDES: usize = 32;

/// The part of a tool's footprint that acts.
#[derive(Debug, Clone)]
pub(super) struct ActingPart {
    foundation: ElasticFoundation,
    /// Least pressure over the nominal one at which the tool acts [1].
    least: f64,
    /// Curvature up to which the whole tool acts, at every yaw [1/m].
    harmless: f64,
    /// Known values for the bend that was examined last.
    known: Option<KnownBend>,
    /// The last yaw over a mesh, and its rotation.
    turn: (f64, Rotation2<f64>),
}

/// The contact of a tool with one bend.
#[derive(Debug, Clone)]
struct KnownBend {
    bend: Matrix2<f64>,
    /// Radius about the tool centre point within which the tool acts at every yaw [m]; infinite if
    /// the whole tool acts. `None` until it is needed.
    radius: Option<f64>,
    /// Boundary of the part within the radius.
    edges: Option<Vec<Edge>>,
    /// The pressure at the last yaw; `None` for the pressure if the whole tool acts there.
    upright: Option<(f64, Option<LocalPressure>)>,
}

impl ActingPart {
    /// Returns the part of a tool that acts if the tool acts at pressures of at least `least` over
    /// the nominal pressure [1].
    pub(super) fn new(foundation: ElasticFoundation, least: f64) -> Self {
        Self {
            harmless: foundation.harmless_bend(least),
            foundation,
            least,
            known: None,
            turn: (0.0, Rotation2::identity()),
        }
    }

    /// Whether only a part of the tool acts at a yaw [rad], somewhere on the surface.
    pub(super) fn is_partial(&mut self, surface: &Surface, heading: f64) -> bool {
        match &surface.shape {
            SurfaceShape::Plane => false,
            SurfaceShape::Cylinder { .. } => {
                (self.pressure(surface, Point2::origin(), heading)).is_some()
            }
            // [`Self::pressure`] decides for the place of each particle.
            SurfaceShape::Cone(_) | SurfaceShape::Mesh(_) => {
                self.radius_at_every_yaw(surface) < f64::INFINITY
            }
        }
    }

    /// Returns the pressure of the tool at a yaw [rad], on the bend at a place of the chart, and
    /// the least pressure at which the tool acts. `None` if the whole tool acts.
    pub(super) fn pressure(
        &mut self,
        surface: &Surface,
        place: Point2,
        heading: f64,
    ) -> Option<(LocalPressure, f64)> {
        let least = self.least;
        if let SurfaceShape::Cone(_) | SurfaceShape::Mesh(_) = &surface.shape {
            let bend = surface.shape.bend(place);
            if bend.norm_squared() < self.harmless * self.harmless {
                return None;
            }
            if self.turn.0 != heading {
                self.turn = (heading, Rotation2::new(heading));
            }
            let (pressure, lowest) = self.foundation.press_turned(&bend, &self.turn.1);
            return (lowest < least).then_some((pressure, least));
        }
        let (foundation, known) = self.meet(surface.shape.bend(place));
        let pressure = match known.upright {
            Some((yaw, pressure)) if yaw == heading => pressure,
            _ => {
                let pressure = foundation.press_upright(&known.bend, heading);
                let is_partial = foundation.range(&pressure)[0] < least;
                let pressure = is_partial.then_some(pressure);
                known.upright = Some((heading, pressure));
                pressure
            }
        };
        pressure.map(|pressure| (pressure, least))
    }

    /// Returns the boundary of the part of a footprint that acts at every yaw, at the tightest
    /// bend; `None` if the whole footprint acts. A convex footprint is cut; of any other footprint,
    /// only the pieces count that lie wholly within the acting part.
    pub(super) fn at_every_yaw(
        &mut self,
        surface: &Surface,
        footprint: &Region,
    ) -> Option<&[Edge]> {
        if surface.shape.is_plane() {
            return None;
        }
        let radius = self.radius_at_every_yaw(surface);
        if radius == f64::INFINITY {
            return None;
        }
        let edges = self.known.as_mut()?.edges.get_or_insert_with(|| {
            let within =
                |piece: &&Polygon| piece.edges().all(|edge| edge.start.coords.norm() <= radius);
            match footprint.polygons() {
                [piece] if piece.is_convex() => clip_to_disc(piece, radius),
                pieces => pieces
                    .iter()
                    .filter(within)
                    .flat_map(Polygon::edges)
                    .collect(),
            }
        });
        Some(edges)
    }

    /// Returns the radius about the tool centre point within which the tool acts at every yaw [m];
    /// infinite if the whole tool acts.
    fn radius_at_every_yaw(&mut self, surface: &Surface) -> f64 {
        let (least, tightest) = (self.least, surface.tightest_bend());
        if let Some(KnownBend {
            bend,
            radius: Some(radius),
            ..
        }) = &self.known
            && *bend == tightest
        {
            return *radius;
        }
        let (foundation, known) = self.meet(tightest);
        let bend = known.bend;
        *(known.radius).get_or_insert_with(|| radius_at_every_yaw(foundation, &bend, least))
    }

    /// Returns the known values for a bend, and makes it the last one.
    fn meet(&mut self, bend: Matrix2<f64>) -> (&ElasticFoundation, &mut KnownBend) {
        let foundation = &self.foundation;
        let known = self.known.take().filter(|known| known.bend == bend);
        let known = known.unwrap_or(KnownBend {
            bend,
            radius: None,
            edges: None,
            upright: None,
        });
        (foundation, self.known.insert(known))
    }
}

/// Returns the radius about the tool centre point within which the pressure reaches `least` at
/// every yaw [m]; infinite if it does so under the whole tool, and 0 if it does so at no place.
fn radius_at_every_yaw(foundation: &ElasticFoundation, bend: &Matrix2<f64>, least: f64) -> f64 {
    let yaws = (0..YAWS).map(|i| i as f64 * PI / YAWS as f64);
    let (mut under_all, mut middle) = (f64::INFINITY, f64::INFINITY);
    for yaw in yaws {
        let pressure = foundation.press_upright(bend, yaw);
        under_all = under_all.min(foundation.range(&pressure)[0]);
        middle = middle.min(pressure.middle);
    }
    if under_all >= least {
        return f64::INFINITY;
    }
    // f′ is least in the direction of the largest curvature: m − κ r²/2δ ≥ least.
    let [curvature, _] = principal_curvatures(bend);
    if curvature > 0.0 && middle > least {
        libm::sqrt(2.0 * (middle - least) * foundation.compression() / curvature)
    } else {
        0.0
    }
}

/// Returns the boundary of the part of a convex polygon within a regular polygon that is inscribed in a disc about the
/// origin (Sutherland and Hodgman, 1974).
fn clip_to_disc(piece: &Polygon, radius: f64) -> Vec<Edge> {
    let distance = radius * libm::cos(PI / SIDES as f64);
    let mut corners = piece.outer().to_vec();
    for side in 0..SIDES {
        let angle = 2.0 * PI * side as f64 / SIDES as f64;
        let outward = Vector2::new(libm::cos(angle), libm::sin(angle));
        let inside = |corner: &Point2| distance - outward.dot(&corner.coords);
        let mut kept = Vec::with_capacity(corners.len() + 1);
        for (i, corner) in corners.iter().enumerate() {
            let next = &corners[(i + 1) % corners.len()];
            let (here, there) = (inside(corner), inside(next));
            if here >= 0.0 {
                kept.push(*corner);
            }
            if (here >= 0.0) != (there >= 0.0) {
                kept.push(corner + (next - corner) * (here / (here - there)));
            }
        }
        corners = kept;
    }
    let next = corners.iter().cycle().skip(1);
    let edges = corners
        .iter()
        .zip(next)
        .map(|(&start, &end)| Edge { start, end });
    edges.filter(|edge| edge.start != edge.end).collect()
}
