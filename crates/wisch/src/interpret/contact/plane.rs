//! RANSAC fit of the plane of confident contacts (Fischler and Bolles, 1981), equation (11).
//!
//! A plane is a height and a slope over the believed surface. Contacts that do not spread along a direction do not
//! determine the slope along it, so a single straight stroke gives no full plane. In such a direction the believed
//! slope is kept, and a stroke still gives the height and the slope along itself.

use crate::geometry::{Point3, Vector2, Vector3};
use crate::interpret::config::PlaneConfig;
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};

/// Largest number of points on which a hypothesis is scored; more points would not change the
/// choice.
const MAX_SCORED: usize = 5000;
/// Largest number of iterations of least squares; the inliers settle after two or three.
const MAX_REFINEMENTS: usize = 10;

/// A plane over the xy plane, z = height + slope · (x, y).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlaneFit {
    /// Height at the origin \[m\].
    pub height: f64,
    /// Rise along x and along y \[1\].
    pub slope: Vector2,
    /// Number of points within the inlier distance.
    pub inliers: usize,
    /// Root mean square distance of the inliers \[m\].
    pub rms: f64,
    /// Number of directions in which the inliers spread far enough to determine the slope; the slope is 0 in the
    /// remaining ones.
    pub directions: usize,
}

impl PlaneFit {
    /// Unit normal with positive z, in the frame of the fitted points.
    pub fn normal(&self) -> Vector3 {
        Vector3::new(-self.slope.x, -self.slope.y, 1.0).normalize()
    }

    /// Angle between the normal and the z axis \[rad\].
    pub fn tilt(&self) -> f64 {
        libm::atan(self.slope.norm())
    }

    /// Returns the height of the plane \[m\] at a place in the xy plane \[m\].
    pub fn height_at(&self, place: Vector2) -> f64 {
        self.height + self.slope.dot(&place)
    }

    /// Returns the signed distance of a point from the plane, positive above \[m\].
    pub fn distance(&self, point: Point3) -> f64 {
        (point.z - self.height_at(point.coords.xy())) * self.cosine()
    }

    fn cosine(&self) -> f64 {
        1.0 / (1.0 + self.slope.norm_squared()).sqrt()
    }
}

/// Fits the plane that holds most points, with its normal within a cone about z, and refines it by least squares on its
/// inliers. `None` if too few points lie on a common plane.
///
/// The result depends on the points, the settings and the seed only. The cost is proportional to the number of points.
///
/// ```
/// use wisch::geometry::Point3;
/// use wisch::interpret::{PlaneConfig, fit_plane};
/// // Strokes on a surface that rises by 2 % along x, and a hand that lifts the tool in between.
/// let strokes = (0..200).map(|i| {
///     let (x, y) = (f64::from(i % 20) * 0.01, f64::from(i / 20) * 0.02);
///     let lifted = if i % 7 == 0 { 0.03 } else { 0.0 };
///     Point3::new(x, y, 0.02 * x + lifted)
/// });
/// let plane = fit_plane(&strokes.collect::<Vec<_>>(), &PlaneConfig::default(), 1).unwrap();
/// assert!((plane.slope.x - 0.02).abs() < 1e-9);
/// assert_eq!(plane.inliers, 171);
/// ```
pub fn fit_plane(points: &[Point3], config: &PlaneConfig, seed: u64) -> Option<PlaneFit> {
    if points.len() < config.min_points.max(3) {
        return None;
    }
    let axes = Spread::of(points.iter()).axes(config.min_spread_m);
    let stride = points.len().div_ceil(MAX_SCORED);
    let scored: Vec<Point3> = points.iter().step_by(stride).copied().collect();
    let best = search(&scored, &axes, config, seed)?;
    let refined = refine(points, best, config);
    let least = (config.min_share * points.len() as f64).max(config.min_points as f64);
    (refined.inliers as f64 >= least).then_some(refined)
}

/// Returns the hypothesis with the least truncated squared distances (MSAC; Torr and Zisserman, 2000).
fn search(
    points: &[Point3],
    axes: &[Vector2],
    config: &PlaneConfig,
    seed: u64,
) -> Option<PlaneFit> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut best: Option<(f64, PlaneFit)> = None;
    let mut needed = config.max_iterations;
    let mut drawn = 0;
    while drawn < needed {
        drawn += 1;
        let sample: [Point3; 3] =
            std::array::from_fn(|_| points[random.random_range(0..points.len())]);
        let Some(plane) = plane_through(&sample, axes, config.cone) else {
            continue;
        };
        let (cost, inliers) = score(points, &plane, config.inlier_distance_m);
        if best.is_none_or(|(least, _)| cost < least) {
            best = Some((cost, plane));
            let share = inliers as f64 / points.len() as f64;
            needed = needed.min(hypotheses(share, axes.len() + 1, config.confidence));
        }
    }
    best.map(|(_, plane)| plane)
}

/// Returns the number of hypotheses after which, with this confidence, at least one was drawn from inliers alone.
pub(super) fn hypotheses(inlier_share: f64, points: usize, confidence: f64) -> usize {
    // n = log(1 − confidence) / log(1 − wᵏ), with inlier share w and k points per hypothesis.
    let all_inliers = inlier_share.powi(points as i32);
    let needed = libm::log(1.0 - confidence) / libm::log(1.0 - all_inliers);
    // With inliers only, the logarithm is −∞ and the ratio 0; without inliers, no number is enough.
    if needed.is_finite() {
        (needed.ceil() as usize).max(1)
    } else {
        usize::MAX
    }
}

/// Returns the plane through one point more than there are free slopes; `None` if it lies outside the cone.
fn plane_through(points: &[Point3; 3], axes: &[Vector2], cone: f64) -> Option<PlaneFit> {
    let [a, b, c] = *points;
    let slope = match *axes {
        [] => Vector2::zeros(),
        [axis] => axis * ((b.z - a.z) / (b - a).xy().dot(&axis)),
        _ => {
            let (ab, ac) = (b - a, c - a);
            let area = ab.xy().perp(&ac.xy());
            Vector2::new(ab.z * ac.y - ac.z * ab.y, ac.z * ab.x - ab.z * ac.x) / area
        }
    };
    // Coincident or collinear points give a slope that is NaN or outside the cone.
    (slope.norm() <= libm::tan(cone)).then(|| PlaneFit {
        height: a.z - slope.dot(&a.coords.xy()),
        slope,
        inliers: 0,
        rms: 0.0,
        directions: axes.len(),
    })
}

/// Returns the sum of the squared distances over the inlier distance, each limited to 1, and the number of inliers.
fn score(points: &[Point3], plane: &PlaneFit, inlier_distance: f64) -> (f64, usize) {
    let scale = (plane.cosine() / inlier_distance).powi(2);
    let mut cost = 0.0;
    let mut outliers = 0.0;
    for point in points {
        let off = point.z - plane.height - plane.slope.x * point.x - plane.slope.y * point.y;
        let square = off * off * scale;
        cost += square.min(1.0);
        outliers += f64::from(u8::from(square > 1.0));
    }
    (cost, points.len() - outliers as usize)
}

/// Repeats least squares on the inliers until they no longer change.
fn refine(points: &[Point3], from: PlaneFit, config: &PlaneConfig) -> PlaneFit {
    let steepest = libm::tan(config.cone);
    let mut plane = count_inliers(points, from, config.inlier_distance_m);
    for _ in 0..MAX_REFINEMENTS {
        let near = |point: &&Point3| plane.distance(**point).abs() <= config.inlier_distance_m;
        let spread = Spread::of(points.iter().filter(near));
        let fitted = spread.least_squares(config.min_spread_m);
        if spread.count == 0.0 || fitted.slope.norm() > steepest {
            break;
        }
        let next = count_inliers(points, fitted, config.inlier_distance_m);
        let settled = next == plane;
        plane = next;
        if settled {
            break;
        }
    }
    plane
}

fn count_inliers(points: &[Point3], plane: PlaneFit, inlier_distance: f64) -> PlaneFit {
    let distances = points.iter().map(|point| plane.distance(*point));
    let (inliers, squares) = distances
        .filter(|distance| distance.abs() <= inlier_distance)
        .fold((0_usize, 0.0), |(count, squares), d| {
            (count + 1, squares + d * d)
        });
    PlaneFit {
        inliers,
        rms: (squares / inliers.max(1) as f64).sqrt(),
        ..plane
    }
}

/// Fits a plane by least squares to the points near the plane with this height over the origin [m]
/// and this slope [1]. `None` if too few points lie near that plane.
pub(super) fn fit_near(
    points: &[Point3],
    (height, slope): (f64, Vector2),
    config: &PlaneConfig,
) -> Option<PlaneFit> {
    let start = PlaneFit {
        height,
        slope,
        inliers: 0,
        rms: 0.0,
        directions: 0,
    };
    let fit = refine(points, start, config);
    (fit.inliers >= config.min_points).then_some(fit)
}

/// Returns the slope of points by least squares [1]; 0 along directions in which their standard deviation is below
/// `min_spread` [m].
pub(super) fn slope_within(points: &[Point3], min_spread: f64) -> Vector2 {
    Spread::of(points.iter()).least_squares(min_spread).slope
}

/// Sums of a set of points, relative to the first of them.
#[derive(Debug, Clone, Copy, Default)]
struct Spread {
    count: f64,
    first: Point3,
    sum: Vector3,
    xx: f64,
    xy: f64,
    yy: f64,
    xz: f64,
    yz: f64,
}

impl Spread {
    fn of<'a>(points: impl Iterator<Item = &'a Point3>) -> Self {
        let mut spread = Self::default();
        for point in points {
            if spread.count == 0.0 {
                spread.first = *point;
            }
            let d = point - spread.first;
            spread.count += 1.0;
            spread.sum += d;
            spread.xx += d.x * d.x;
            spread.xy += d.x * d.y;
            spread.yy += d.y * d.y;
            spread.xz += d.x * d.z;
            spread.yz += d.y * d.z;
        }
        spread
    }

    /// Central moments: variances and covariances of x, y and z for the slopes.
    fn central(&self) -> (Vector3, [f64; 5]) {
        let mean = self.sum / self.count.max(1.0);
        let about = |raw: f64, a: f64, b: f64| raw / self.count.max(1.0) - a * b;
        let moments = [
            about(self.xx, mean.x, mean.x),
            about(self.xy, mean.x, mean.y),
            about(self.yy, mean.y, mean.y),
            about(self.xz, mean.x, mean.z),
            about(self.yz, mean.y, mean.z),
        ];
        (mean, moments)
    }

    /// Directions in which the points spread far enough, the widest first.
    fn axes(&self, min_spread: f64) -> Vec<Vector2> {
        let (_, [xx, xy, yy, ..]) = self.central();
        let half_angle = 0.5 * libm::atan2(2.0 * xy, xx - yy);
        let major = Vector2::new(libm::cos(half_angle), libm::sin(half_angle));
        let minor = Vector2::new(-major.y, major.x);
        let variance = |axis: &Vector2| {
            axis.x * axis.x * xx + 2.0 * axis.x * axis.y * xy + axis.y * axis.y * yy
        };
        let wide = |axis: &Vector2| variance(axis) >= min_spread * min_spread;
        [major, minor].into_iter().filter(wide).collect()
    }

    /// Fits z by least squares; the slope is 0 along directions in which the points do not spread.
    fn least_squares(&self, min_spread: f64) -> PlaneFit {
        let (mean, [xx, xy, yy, xz, yz]) = self.central();
        let axes = self.axes(min_spread);
        // The principal axes are uncorrelated, so the slope along each axis a is cov(a, z) / var(a).
        let slope = axes.iter().fold(Vector2::zeros(), |slope, axis| {
            let variance = axis.x * axis.x * xx + 2.0 * axis.x * axis.y * xy + axis.y * axis.y * yy;
            slope + axis * ((axis.x * xz + axis.y * yz) / variance)
        });
        let center = self.first + mean;
        PlaneFit {
            height: center.z - slope.dot(&center.coords.xy()),
            slope,
            inliers: 0,
            rms: 0.0,
            directions: axes.len(),
        }
    }
}
