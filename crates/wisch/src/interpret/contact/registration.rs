//! Registration of measured contacts against the believed shape of a surface, in those of its six
//! degrees of freedom that the contacts determine.
//!
//! A small motion of the surface by t and ω changes the distance of a contact p with the normal n by n·t + (p × n)·ω.
//! Contacts on a plane determine three of these six numbers, on a cylinder four, on a sphere three,
//! on a cone five. Motions that hardly change the distances keep their believed values. Robust
//! hypotheses (MSAC; Torr and Zisserman, 2000) start a Gauss–Newton iteration on the distances of
//! the inliers.

use super::plane::{fit_plane, hypotheses};
use crate::geometry::{Point3, Pose, Vector3};
use crate::interpret::config::PlaneConfig;
use crate::represent::SurfaceShape;
use nalgebra::{DMatrix, DVector, Matrix6, SymmetricEigen, Translation3, UnitQuaternion, Vector6};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

/// Motion of a point by a rotation, per radian, that counts as much as a translation [m].
const LEVER: f64 = 0.2;
/// Least mean square change of the distances per unit of a motion at which contacts determine it [1]: errors
/// of 0.1 mm that a whole stroke has in common then move the surface along itself by a centimetre at most.
const LEAST_EFFECT: f64 = 1e-4;
/// Largest number of points on which a hypothesis is scored.
const MOST_SCORED: usize = 1000;
/// Least share of the contacts on the surface at a pose with which no other start is tried [1], and distances of the other
/// starts from the believed pose [m].
const ENOUGH: f64 = 0.5;
const BESIDE: [f64; 2] = [0.025, 0.05];
/// Largest number of Gauss–Newton iterations, and the step at which they end [m].
const ROUNDS: usize = 20;
const SETTLED: f64 = 1e-10;

/// The pose at which the believed shape of a surface fits measured contacts best.
#[derive(Debug, Clone, PartialEq)]
pub struct ShapeFit {
    /// Pose of the real surface in the frame of the believed one.
    pub believed_from_real: Pose,
    /// Number of the six degrees of freedom that the contacts determine; in the others, the believed pose is kept.
    pub determined: usize,
    /// Number of contacts within the inlier distance.
    pub inliers: usize,
    /// Root mean square distance of the inliers \[m\].
    pub rms: f64,
}

impl ShapeFit {
    /// Returns the height of a point over the fitted surface \[m\]; `point` is in the frame of the believed surface.
    pub fn height(&self, shape: &SurfaceShape, point: Point3) -> f64 {
        shape
            .chart(self.believed_from_real.inverse() * point)
            .height
    }
}

/// Returns a point of the chart in the frame of the believed surface.
pub(super) fn in_space(shape: &SurfaceShape, point: &Point3) -> Point3 {
    shape.place(point.xy(), point.z).translation.vector.into()
}

/// A contact, linearised: its distance from the surface, and how a motion of the surface changes it.
#[derive(Debug, Clone, Copy)]
struct LinearContact {
    distance: f64,
    effect: Vector6<f64>,
}

/// Fits the pose of a shape to contacts; `None` if too few of them lie on it. On a plane the fit is that of [`fit_plane`].
///
/// # Parameters
/// - `points`: contacts in the frame of the believed surface, in space \[m\].
/// - `config`: the inlier distance, the largest rotation (`cone`), and the limits of the search.
///
/// ```
/// use std::f64::consts::FRAC_PI_2;
/// use wisch::geometry::{Point2, Point3, Pose};
/// use wisch::interpret::{PlaneConfig, fit_shape};
/// use wisch::represent::SurfaceShape;
/// // A pipe that lies 3 mm higher than believed, and 2 mm beside.
/// let pipe = SurfaceShape::Cylinder { radius: 0.3, axis: FRAC_PI_2 };
/// let moved = Pose::translation(0.002, 0.0, 0.003);
/// let contacts: Vec<Point3> = (0..400).map(|i| {
///     let place = Point2::new(0.01 * f64::from(i % 20) - 0.1, 0.02 * f64::from(i / 20) - 0.2);
///     moved * Point3::from(pipe.place(place, 0.0).translation.vector)
/// }).collect();
/// let found = fit_shape(&contacts, &pipe, &PlaneConfig::default(), 1).unwrap();
/// assert_eq!((found.determined, found.inliers), (4, 400));
/// // A turn about the axis of the pipe changes nothing, so the heights are compared, and not the poses.
/// assert!(contacts.iter().all(|at| found.height(&pipe, *at).abs() < 1e-6));
/// ```
pub fn fit_shape(
    points: &[Point3],
    shape: &SurfaceShape,
    config: &PlaneConfig,
    seed: u64,
) -> Option<ShapeFit> {
    if shape.is_plane() {
        let plane = fit_plane(points, config, seed)?;
        let turn = UnitQuaternion::rotation_between(&Vector3::z(), &plane.normal());
        return Some(ShapeFit {
            believed_from_real: Pose::from_parts(
                Translation3::new(0.0, 0.0, plane.height),
                turn.unwrap_or_default(),
            ),
            determined: 1 + plane.directions,
            inliers: plane.inliers,
            rms: plane.rms,
        });
    }
    if points.len() < config.min_points.max(6) {
        return None;
    }
    let sum: Vector3 = points.iter().map(|point| point.coords).sum();
    let registration = Registration {
        points,
        shape,
        middle: Point3::from(sum / points.len() as f64),
        config,
    };
    let fit = registration.fit(seed)?;
    let least = (config.min_share * points.len() as f64).max(config.min_points as f64);
    (fit.inliers as f64 >= least).then_some(fit)
}

struct Registration<'a> {
    points: &'a [Point3],
    shape: &'a SurfaceShape,
    /// Point about which the surface turns.
    middle: Point3,
    config: &'a PlaneConfig,
}

impl Registration<'_> {
    /// Returns the best fit from several starts: the believed pose and, if it leads to few contacts on the surface, others
    /// beside it.
    fn fit(&self, seed: u64) -> Option<ShapeFit> {
        let enough = ENOUGH * self.points.len() as f64;
        let mut best: Option<ShapeFit> = None;
        for start in std::iter::once(Pose::identity()).chain(self.starts_beside()) {
            let Some(found) = self.search(&start, seed) else {
                continue;
            };
            let fit = self.refine(found);
            if best.as_ref().is_none_or(|best| fit.inliers > best.inliers) {
                best = Some(fit);
            }
            if (best.as_ref()).is_some_and(|best| best.inliers as f64 >= enough) {
                break;
            }
        }
        best
    }

    /// Poses of the real surface that are shifted along the tangents in the middle of the contacts.
    fn starts_beside(&self) -> impl Iterator<Item = Pose> {
        let tangents = (self.shape).orientation(self.shape.chart(self.middle).place);
        let directions = [Vector3::x(), -Vector3::x(), Vector3::y(), -Vector3::y()];
        BESIDE.into_iter().flat_map(move |distance| {
            directions.map(|direction| {
                let shift = tangents * direction * distance;
                Pose::translation(shift.x, shift.y, shift.z)
            })
        })
    }

    /// Linearises a contact about a pose of the real surface in the frame of the believed one.
    fn linearise(&self, real_from_believed: &Pose, point: &Point3) -> LinearContact {
        let point = real_from_believed * point;
        let at = self.shape.chart(point);
        let normal = self.shape.orientation(at.place) * Vector3::z();
        let turned = (point - self.middle).cross(&normal) / LEVER;
        LinearContact {
            distance: at.height,
            effect: Vector6::new(normal.x, normal.y, normal.z, turned.x, turned.y, turned.z),
        }
    }

    /// Returns the motion for six numbers, of which the rotation is in units of the lever.
    fn motion(&self, step: &Vector6<f64>) -> Pose {
        let turn = UnitQuaternion::from_scaled_axis(step.fixed_rows::<3>(3).into_owned() / LEVER);
        let shift = step.fixed_rows::<3>(0).into_owned();
        let about = Translation3::from(self.middle.coords);
        about * Pose::from_parts(Translation3::from(shift), turn) * about.inverse()
    }

    /// Returns the pose of the hypothesis with the least truncated squared distances, which are linearised about a start;
    /// `None` if each hypothesis turns the surface too far.
    fn search(&self, start: &Pose, seed: u64) -> Option<Pose> {
        let real_from_believed = start.inverse();
        let stride = self.points.len().div_ceil(MOST_SCORED);
        let scored: Vec<LinearContact> = (self.points.iter().step_by(stride))
            .map(|point| self.linearise(&real_from_believed, point))
            .collect();
        let determined = determined_motions(&scored);
        let count = determined.len();
        if count == 0 {
            return None;
        }
        let reduced: Vec<DVector<f64>> = (scored.iter())
            .map(|contact| {
                DVector::from_iterator(
                    count,
                    determined.iter().map(|(axis, _)| axis.dot(&contact.effect)),
                )
            })
            .collect();
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut best: Option<(f64, DVector<f64>)> = None;
        let (mut needed, mut drawn) = (self.config.max_iterations, 0);
        while drawn < needed {
            drawn += 1;
            let sample: Vec<usize> = (0..count)
                .map(|_| random.random_range(0..scored.len()))
                .collect();
            let matrix = DMatrix::from_fn(count, count, |i, j| reduced[sample[i]][j]);
            let right = DVector::from_fn(count, |i, _| scored[sample[i]].distance);
            let Some(step) = matrix.lu().solve(&right) else {
                continue;
            };
            let motion = combine(&determined, &step);
            let turn = motion.fixed_rows::<3>(3).norm() / LEVER;
            if turn.is_nan() || turn > self.config.cone {
                continue;
            }
            let (mut cost, mut inliers) = (0.0, 0_usize);
            for (contact, row) in scored.iter().zip(&reduced) {
                let off = (contact.distance - row.dot(&step)) / self.config.inlier_distance_m;
                cost += (off * off).min(1.0);
                inliers += usize::from(off.abs() <= 1.0);
            }
            if best.as_ref().is_none_or(|(least, _)| cost < *least) {
                let share = inliers as f64 / scored.len() as f64;
                needed = needed.min(hypotheses(share, count, self.config.confidence));
                best = Some((cost, step));
            }
        }
        best.map(|(_, step)| start * self.motion(&combine(&determined, &step)))
    }

    /// Repeats least squares on the distances of the inliers until they no longer change.
    fn refine(&self, start: Pose) -> ShapeFit {
        let mut believed_from_real = start;
        let mut determined = 0;
        for _ in 0..ROUNDS {
            let inliers = self.inliers(&believed_from_real);
            let motions = determined_motions(&inliers);
            determined = motions.len();
            let count = inliers.len().max(1) as f64;
            let right: Vector6<f64> = (inliers.iter())
                .map(|contact| contact.effect * contact.distance)
                .sum();
            let step: Vector6<f64> = (motions.iter())
                .map(|(axis, effect)| axis * (axis.dot(&right) / count / effect))
                .sum();
            let next = believed_from_real * self.motion(&step);
            let turn = next.rotation.angle();
            if turn.is_nan() || turn > self.config.cone {
                break;
            }
            believed_from_real = next;
            if step.norm() < SETTLED {
                break;
            }
        }
        let inliers = self.inliers(&believed_from_real);
        let squares: f64 = inliers.iter().map(|contact| contact.distance.powi(2)).sum();
        ShapeFit {
            believed_from_real,
            determined,
            inliers: inliers.len(),
            rms: (squares / inliers.len().max(1) as f64).sqrt(),
        }
    }

    /// Returns the contacts near the surface at a pose, linearised about it.
    fn inliers(&self, believed_from_real: &Pose) -> Vec<LinearContact> {
        let real_from_believed = believed_from_real.inverse();
        let all = self
            .points
            .iter()
            .map(|point| self.linearise(&real_from_believed, point));
        all.filter(|contact| contact.distance.abs() <= self.config.inlier_distance_m)
            .collect()
    }
}

/// Returns the motions that contacts determine, as unit vectors with the mean square change of the distances per unit.
fn determined_motions(contacts: &[LinearContact]) -> Vec<(Vector6<f64>, f64)> {
    let sum: Matrix6<f64> = (contacts.iter())
        .map(|contact| contact.effect * contact.effect.transpose())
        .sum();
    let SymmetricEigen {
        eigenvectors,
        eigenvalues,
    } = (sum / contacts.len().max(1) as f64).symmetric_eigen();
    let axes = eigenvectors.column_iter().map(|axis| axis.into_owned());
    axes.zip(eigenvalues.iter().copied())
        .filter(|(_, effect)| *effect >= LEAST_EFFECT)
        .collect()
}

fn combine(motions: &[(Vector6<f64>, f64)], step: &DVector<f64>) -> Vector6<f64> {
    let parts = motions.iter().zip(step.iter());
    parts.map(|((axis, _), part)| axis * *part).sum()
}
