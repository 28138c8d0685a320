//! A circular cone, which unrolls without stretch.
//!
//! In the chart, the cone is a sector about its apex: ρ is the distance of a place from the apex, θ the angle from the
//! line through the chart's origin. Rolled onto a cone of half angle α, the place lies at ρ along its line, turned by
//! φ = θ / sin α about the axis. The normal curvature across that line is cos α / ρ sin α.
//!
//! All terms stay exact while α → 0, where the apex moves away and the cone becomes a cylinder.

use super::{ChartPoint, RADIUS_RANGE};
use crate::geometry::{Point2, Point3, Pose, Vector2, Vector3};
use nalgebra::{Matrix2, Translation3, Unit, UnitQuaternion};

/// Range of the half angle of a cone \[rad\]: a narrower cone is a cylinder, and a wider one nearly a plane.
pub const HALF_ANGLE_RANGE: [f64; 2] = [1e-3, 1.5];

/// A circular cone onto which the chart of a surface is rolled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    /// Distance of the chart's origin from the axis \[m\], positive where the surface bulges towards the tool, negative
    /// where it is hollow.
    pub radius: f64,
    /// Angle between the axis and the surface \[rad\].
    pub half_angle: f64,
    /// Direction from the chart's x in which the cone widens \[rad\].
    pub axis: f64,
}

/// Directions in the chart and in space. The sine of the half angle has the sign of the radius.
struct ConeAxes {
    along: Vector2,
    across: Vector2,
    sine: f64,
    cosine: f64,
    /// Distance of the chart's origin from the apex [m].
    slant: f64,
}

/// A place in polar coordinates about the apex.
struct SectorPlace {
    /// Distance of the place from the apex, minus that of the chart's origin [m].
    beyond: f64,
    /// Angle θ from the line through the chart's origin [rad].
    turn: f64,
}

impl Cone {
    /// Place of the apex \[m\].
    pub fn apex(&self) -> Point2 {
        let own = self.axes();
        Point2::origin() - own.along * own.slant
    }

    /// Returns the pose of a frame over a place, as [`super::SurfaceShape::place`].
    pub(super) fn place(&self, place: Point2, height: f64) -> Pose {
        let own = self.axes();
        let SectorPlace { beyond, turn } = own.sector_place(place);
        let angle = turn / own.sine;
        let (sine, cosine, half) = (libm::sin(angle), libm::cos(angle), libm::sin(0.5 * angle));
        let [axis, radial] = own.in_space();
        let across = Vector3::new(own.across.x, own.across.y, 0.0);
        let out = radial * cosine + across * sine;
        let line = axis * own.cosine + out * own.sine;
        let normal = out * own.cosine - axis * own.sine;
        // ρ g(φ) − s g(0) with g = cos α a + sin α e(φ), s sin α = R and ρ = s + δ:
        // δ g(φ) + R (e(φ) − e(0)).
        let round = across * sine - radial * (2.0 * half * half);
        let point = line * beyond + round * self.radius + normal * height;
        let unturned = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), -turn);
        // The normal turns towards `across`, which is a negative turn about the axis.
        let rolled = UnitQuaternion::from_axis_angle(&Unit::new_unchecked(axis), -angle);
        Pose::from_parts(Translation3::from(point), rolled * unturned)
    }

    /// Returns the place and the height of a point, as [`super::SurfaceShape::chart`]. Beyond the apex, the place is the
    /// apex.
    pub(super) fn chart(&self, point: Point3) -> ChartPoint {
        let own = self.axes();
        let [axis, radial] = own.in_space();
        let along = axis.dot(&point.coords);
        let up = radial.dot(&point.coords);
        let side = own.across.dot(&point.coords.xy());
        let sign = self.radius.signum();
        let angle = libm::atan2(sign * side, sign * (up + self.radius));
        let distance = libm::hypot(side, up + self.radius);
        // Distance from the axis minus |R|, in a form without cancellation.
        let off = (side * side + up * (up + 2.0 * self.radius)) / (distance + self.radius.abs());
        let height = sign * (off * own.cosine - along * own.sine.abs());
        let beyond = (along * own.cosine + off * own.sine.abs()).max(-own.slant);
        let turn = angle * own.sine;
        let half = libm::sin(0.5 * turn);
        let v = beyond * libm::cos(turn) - 2.0 * own.slant * half * half;
        let u = (own.slant + beyond) * libm::sin(turn);
        ChartPoint {
            place: Point2::from(own.along * v + own.across * u),
            height,
        }
    }

    /// Returns the place below a point along the z axis of the frame, as
    /// [`super::SurfaceShape::place_below`].
    pub(super) fn place_below(&self, point: Point2) -> Option<Point2> {
        let own = self.axes();
        let (v, u) = (own.along.dot(&point.coords), own.across.dot(&point.coords));
        let sign = self.radius.signum();
        // With A = R + v sin α and z = w cos α, the cone is cos 2α w² + 2 A w + u² = 0.
        let radius = self.radius + own.sine * v;
        let doubled = own.cosine * own.cosine - own.sine * own.sine;
        let root = radius * radius - doubled * u * u;
        (sign * radius > 0.0 && root >= 0.0).then(|| {
            let w = -u * u / (radius + sign * root.sqrt());
            self.chart(Point3::new(point.x, point.y, own.cosine * w))
                .place
        })
    }

    /// Returns the second fundamental form at a place, as [`super::SurfaceShape::bend`]. Near the
    /// apex, it is that of the narrowest permitted place.
    pub(super) fn bend(&self, place: Point2) -> Matrix2<f64> {
        let own = self.axes();
        let SectorPlace { beyond, turn } = own.sector_place(place);
        let across = own.across * libm::cos(turn) - own.along * libm::sin(turn);
        let radius = ((own.slant + beyond) * own.sine.abs()).max(RADIUS_RANGE[0]);
        across * across.transpose() * (own.cosine / (radius * self.radius.signum()))
    }

    /// Returns the angle about the axis from the chart's origin to a place \[rad\].
    pub(super) fn roll(&self, place: Point2) -> f64 {
        let own = self.axes();
        own.sector_place(place).turn / own.sine
    }

    /// Returns the angle by which the normal turns on the path between two places \[rad\].
    pub(super) fn turn_between(&self, from: Point2, to: Point2) -> f64 {
        // The normals are on a circle of the radius cos α.
        (self.axes().cosine * (self.roll(to) - self.roll(from))).abs()
    }

    /// Returns a linear function of the place that is positive where the angle about the axis is larger than `roll`
    /// \[rad\], up to half a turn about the apex in the chart.
    pub fn past_roll(&self, place: Point2, roll: f64) -> f64 {
        let own = self.axes();
        let turn = roll * own.sine;
        let across = own.across * libm::cos(turn) - own.along * libm::sin(turn);
        // The line of the cone at this angle goes through the apex.
        let from_apex = across.dot(&place.coords) - own.slant * libm::sin(turn);
        from_apex * own.sine.signum()
    }

    fn axes(&self) -> ConeAxes {
        let along = Vector2::new(libm::cos(self.axis), libm::sin(self.axis));
        let sine = libm::sin(self.half_angle).copysign(self.radius);
        ConeAxes {
            along,
            across: Vector2::new(-along.y, along.x),
            sine,
            cosine: libm::cos(self.half_angle),
            slant: self.radius / sine,
        }
    }
}

impl ConeAxes {
    /// Returns the direction in which the axis widens, and the direction across it at the origin towards the tool.
    fn in_space(&self) -> [Vector3; 2] {
        let (s, c) = (self.sine, self.cosine);
        [
            Vector3::new(c * self.along.x, c * self.along.y, -s),
            Vector3::new(s * self.along.x, s * self.along.y, c),
        ]
    }

    fn sector_place(&self, place: Point2) -> SectorPlace {
        let (v, u) = (
            self.along.dot(&place.coords),
            self.across.dot(&place.coords),
        );
        let distance = libm::hypot(self.slant + v, u);
        SectorPlace {
            // ρ − s, in a form without cancellation: ρ² − s² = v² + 2 s v + u².
            beyond: (v * (2.0 * self.slant + v) + u * u) / (distance + self.slant),
            turn: libm::atan2(u, self.slant + v),
        }
    }
}
