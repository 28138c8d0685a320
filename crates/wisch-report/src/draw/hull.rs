//! Outlines of shapes, seen from above.

use std::f64::consts::TAU;
use wisch::geometry::{Point2, Point3, Pose};
use wisch::robot::Shape;

/// Number of corners of a circle.
const CORNERS: usize = 32;

/// Returns the convex hull of points, counter-clockwise (Andrew's monotone chain); fewer than three corners for
/// collinear points.
pub(crate) fn hull(points: impl IntoIterator<Item = Point2>) -> Vec<Point2> {
    let mut points: Vec<Point2> = points.into_iter().collect();
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    let mut lower = build_half_hull(points.iter());
    let mut upper = build_half_hull(points.iter().rev());
    // Each half ends where the other begins.
    lower.pop();
    upper.pop();
    lower.extend(upper);
    if lower.is_empty() { points } else { lower }
}

fn build_half_hull<'a>(points: impl Iterator<Item = &'a Point2>) -> Vec<Point2> {
    let mut chain: Vec<Point2> = Vec::new();
    for &point in points {
        while let [.., a, b] = chain[..] {
            if (b - a).perp(&(point - a)) > 0.0 {
                break;
            }
            chain.pop();
        }
        chain.push(point);
    }
    chain
}

/// Returns points whose hull is the outline of a shape from above; circles become polygons.
pub(crate) fn outline(shape: &Shape, frame_from_shape: &Pose) -> Vec<Point2> {
    let place = |p: Point3| (frame_from_shape * p).xy();
    let ends = |length: f64| [-0.5, 0.5].map(|s| Point3::new(0.0, 0.0, s * length));
    let disc = |center: Point2, radius: f64| {
        (0..CORNERS).map(move |i| {
            let (sin, cos) = (TAU * i as f64 / CORNERS as f64).sin_cos();
            Point2::new(center.x + radius * cos, center.y + radius * sin)
        })
    };
    match shape {
        Shape::Box { size } => (0..8)
            .map(|i| {
                let side = |bit: usize| if i & bit == 0 { -0.5 } else { 0.5 };
                place(Point3::new(
                    side(1) * size.x,
                    side(2) * size.y,
                    side(4) * size.z,
                ))
            })
            .collect(),
        &Shape::Sphere { radius } => disc(place(Point3::origin()), radius).collect(),
        &Shape::Capsule { radius, length } => ends(length)
            .into_iter()
            .flat_map(|end| disc(place(end), radius))
            .collect(),
        &Shape::Cylinder { radius, length } => ends(length)
            .into_iter()
            .flat_map(|end| disc(Point2::origin(), radius).map(move |p| (p, end)))
            .map(|(p, end)| place(Point3::new(p.x, p.y, end.z)))
            .collect(),
        Shape::Mesh(mesh) => mesh.vertices().iter().map(|&p| place(p)).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use wisch::geometry::{Polygon, Vector3};

    #[test]
    fn the_hull_of_a_lying_capsule_is_a_stadium() {
        let capsule = Shape::Capsule {
            radius: 0.1,
            length: 0.4,
        };
        let lying = Pose::new(
            Vector3::new(1.0, 2.0, 3.0),
            Vector3::new(0.0, std::f64::consts::FRAC_PI_2, 0.0),
        );
        let outline = Polygon::new(hull(super::outline(&capsule, &lying)), vec![]);
        // The 32-gons at its ends are slightly smaller than circles.
        let stadium = 0.4 * 0.2 + std::f64::consts::PI * 0.01;
        assert!(
            (outline.area() - stadium).abs() < 0.01 * stadium,
            "{}",
            outline.area()
        );
        assert!(
            outline.contains(Point2::new(1.28, 2.0)) && !outline.contains(Point2::new(1.31, 2.0))
        );
        let dots = [0.0, 0.5, 1.0].map(|x| Point2::new(x, x));
        assert!(hull(dots).len() <= 2, "a line has no inside");
    }
}
