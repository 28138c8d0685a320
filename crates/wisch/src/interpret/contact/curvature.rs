//! Detection of a cylindrical surface.
//!
//! A quadric z = c + b·p + ½ pᵀ K p is fitted to the heights of the contacts over the believed surface, by least
//! squares with Huber weights. The eigenvector of K with the smaller curvature is the axis of the cylinder. A circle in
//! the section across the axis gives the radius (Kåsa, 1976), as the quadric alone gives it for shallow arcs only.

use super::downsampling::MeasuredPiece;
use crate::geometry::{Point2, Vector2};
use crate::interpret::config::InterpretConfig;
use crate::represent::Surface;
use nalgebra::{Matrix2, Matrix3, SMatrix, SVector, Vector3};

/// Least f′ at which a contact shows the height of the surface [1].
const PRESSING: f64 = 0.85;
/// Least distance between two contacts that both count [m].
const TRAVEL: f64 = 2e-3;
/// Least number of contacts that show a curvature.
const FEWEST: usize = 60;
/// Least standard deviation of the contacts in every direction [m].
const LEAST_SPREAD: f64 = 0.02;
/// Least sagitta of the arc over the contacts' extent at which a plane is wrong [m].
const LEAST_RISE: f64 = 1.5e-3;
/// Largest residual of the cylinder over that of the plane [1].
const LEAST_BETTER: f64 = 0.6;
/// Iterations of reweighted least squares, and the residual beyond which a contact gets less weight [m].
const ROUNDS: usize = 8;
const OUTLIER: f64 = 1e-3;

/// A cylinder through the contacts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::interpret) struct Curvature {
    /// Radius [m].
    pub(in crate::interpret) radius: f64,
    /// Angle of the axis from the surface's x, from 0 to π [rad].
    pub(in crate::interpret) axis: f64,
    /// Whether it bulges towards the tool.
    pub(in crate::interpret) is_convex: bool,
}

impl Curvature {
    /// Fits a cylinder to the contacts among the pieces, whose forces are as read; `None` where a plane fits as well.
    pub(in crate::interpret) fn of(
        pieces: &[MeasuredPiece],
        surface: &Surface,
        config: &InterpretConfig,
    ) -> Option<Self> {
        let contacts = contacts(pieces, surface, config);
        if contacts.len() < FEWEST {
            return None;
        }
        let quadric = Quadric::fit(&contacts)?;
        let plane = Quadric::fit_plane(&contacts)?;
        let eigen = quadric.curvature.symmetric_eigen();
        let strongest = eigen.eigenvalues.iamax();
        let across: Vector2 = eigen.eigenvectors.column(strongest).into_owned();
        let along = Vector2::new(-across.y, across.x);
        let curvature = eigen.eigenvalues[strongest];
        let (radius, extent) = circle(&contacts, &across, &along, &quadric)?;
        let rise = extent * extent / (8.0 * radius);
        let [bent, flat] = [&quadric, &plane].map(|fit| fit.residual(&contacts));
        let mut axis = libm::atan2(along.y, along.x);
        if axis < 0.0 {
            axis += std::f64::consts::PI;
        }
        (rise >= LEAST_RISE && bent <= LEAST_BETTER * flat).then_some(Self {
            radius,
            axis,
            is_convex: curvature < 0.0,
        })
    }
}

/// Returns the places of contact, with the height of the underside at nominal force. Contacts near the border are left
/// out, as the tool tips there.
fn contacts(
    pieces: &[MeasuredPiece],
    surface: &Surface,
    config: &InterpretConfig,
) -> Vec<(Point2, f64)> {
    let border = |place: Point2| {
        let edges = surface.outline.edges().map(|edge| edge.distance(place));
        edges.fold(f64::INFINITY, f64::min)
    };
    let stiffness = config.stiffness().unwrap_or(f64::INFINITY);
    let mut contacts: Vec<(Point2, f64)> = Vec::new();
    for piece in pieces {
        let place = piece.position.xy();
        let is_new = (contacts.last()).is_none_or(|(last, _)| (place - last).norm() >= TRAVEL);
        let is_within =
            surface.outline.contains(place) && border(place) >= config.redraw_length_m / 2.0;
        if is_new && is_within && config.normalized(-piece.force.z) >= PRESSING {
            let spring_back = (piece.force.z - config.nominal_force()) / stiffness;
            contacts.push((place, piece.mean_height + spring_back));
        }
    }
    contacts
}

/// A quadric z = height + slope · p + ½ pᵀ K p, with p relative to the middle of the contacts.
struct Quadric {
    middle: Point2,
    height: f64,
    slope: Vector2,
    curvature: Matrix2<f64>,
}

impl Quadric {
    fn fit(contacts: &[(Point2, f64)]) -> Option<Self> {
        Self::fit_terms(contacts, |p| {
            SVector::<f64, 6>::from([1.0, p.x, p.y, 0.5 * p.x * p.x, p.x * p.y, 0.5 * p.y * p.y])
        })
        .map(|(middle, c)| Self {
            middle,
            height: c[0],
            slope: Vector2::new(c[1], c[2]),
            curvature: Matrix2::new(c[3], c[4], c[4], c[5]),
        })
    }

    fn fit_plane(contacts: &[(Point2, f64)]) -> Option<Self> {
        Self::fit_terms(contacts, |p| SVector::<f64, 3>::from([1.0, p.x, p.y])).map(
            |(middle, c)| Self {
                middle,
                height: c[0],
                slope: Vector2::new(c[1], c[2]),
                curvature: Matrix2::zeros(),
            },
        )
    }

    /// Fits the coefficients of `terms` by iteratively reweighted least squares.
    fn fit_terms<const N: usize>(
        contacts: &[(Point2, f64)],
        terms: impl Fn(Vector2) -> SVector<f64, N>,
    ) -> Option<(Point2, SVector<f64, N>)> {
        let count = contacts.len() as f64;
        let sum: Vector2 = contacts.iter().map(|(place, _)| place.coords).sum();
        let middle = Point2::from(sum / count);
        let spread = contacts
            .iter()
            .fold(Matrix2::zeros(), |spread, (place, _)| {
                let d = place - middle;
                spread + d * d.transpose() / count
            });
        if spread.symmetric_eigen().eigenvalues.min() < LEAST_SPREAD * LEAST_SPREAD {
            return None;
        }
        let mut found = SVector::<f64, N>::zeros();
        for round in 0..ROUNDS {
            let mut normal = SMatrix::<f64, N, N>::zeros();
            let mut right = SVector::<f64, N>::zeros();
            for (place, height) in contacts {
                let terms = terms(place - middle);
                let residual = (height - terms.dot(&found)).abs();
                let weight = if round == 0 {
                    1.0
                } else {
                    OUTLIER / residual.max(OUTLIER)
                };
                normal += terms * terms.transpose() * weight;
                right += terms * (*height * weight);
            }
            found = normal.cholesky()?.solve(&right);
        }
        Some((middle, found))
    }

    fn height_at(&self, place: Point2) -> f64 {
        let p = place - self.middle;
        self.height + self.slope.dot(&p) + 0.5 * p.dot(&(self.curvature * p))
    }

    /// Median distance of the contacts from the quadric [m].
    fn residual(&self, contacts: &[(Point2, f64)]) -> f64 {
        let mut distances: Vec<f64> = (contacts.iter())
            .map(|(place, height)| (height - self.height_at(*place)).abs())
            .collect();
        let middle = distances.len() / 2;
        *distances.select_nth_unstable_by(middle, f64::total_cmp).1
    }
}

/// Returns the radius of the circle through the contacts in the section across the axis, and their extent there [m].
fn circle(
    contacts: &[(Point2, f64)],
    across: &Vector2,
    along: &Vector2,
    quadric: &Quadric,
) -> Option<(f64, f64)> {
    let rise = quadric.slope.dot(along);
    let (mut normal, mut right) = (Matrix3::zeros(), Vector3::zeros());
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for (place, height) in contacts {
        // An algebraic fit is not robust, so outliers are left out.
        if (height - quadric.height_at(*place)).abs() > 3.0 * OUTLIER {
            continue;
        }
        let p = place - quadric.middle;
        let (u, z) = (p.dot(across), height - quadric.height - rise * p.dot(along));
        (least, most) = (least.min(u), most.max(u));
        let row = Vector3::new(u, z, 1.0);
        normal += row * row.transpose();
        right -= row * (u * u + z * z);
    }
    // Circle u² + z² + d u + e z + f = 0 by linear least squares; radius² = (d² + e²)/4 − f.
    let [d, e, f]: [f64; 3] = normal.try_inverse().map(|inverse| inverse * right)?.into();
    let square = 0.25 * (d * d + e * e) - f;
    (square > 0.0 && most > least).then(|| (square.sqrt(), most - least))
}
