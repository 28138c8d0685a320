//! Detection of surfaces that are not planes.
//!
//! A quadric z = c + b·p + ½ pᵀ K p is fitted to the heights of the contacts over the believed surface, by least
//! squares with Huber weights. The eigenvalues of K are the principal curvatures. For a cylinder, a circle in the section
//! across its axis gives the radius of a deep arc (Kåsa, 1976). For a shallow arc the quadric gives
//! the radius, because noise makes the circle too small.
//!
//! Few strokes do not determine all of K: one stroke, or two parallel ones, give the curvature along the strokes alone.
//! Components of K that the contacts do not determine are those in which a unit of curvature hardly changes the heights.

use super::downsampling::MeasuredPiece;
use crate::geometry::{Point2, Vector2, Vector3};
use crate::interpret::config::InterpretConfig;
use crate::represent::Surface;
use nalgebra::{Matrix2, Matrix3, Matrix6, SMatrix, SymmetricEigen, Vector6};

/// Least f′ at which a contact shows the height of the surface [1].
const PRESSING: f64 = 0.85;
/// Least distance between two contacts that both count [m].
const TRAVEL: f64 = 2e-3;
/// Contacts farther apart belong to different slides [m, and multiples of their median distance], and least number of contacts
/// of a slide that count.
const APART: [f64; 2] = [0.02, 2.5];
const SLIDE: usize = 5;
/// Least number of contacts that show a curvature.
const FEWEST: usize = 30;
/// Least range of the heights of the quadric over the plane, at the contacts, at which the surface
/// counts as curved [m]. For an arc, this range is its sagitta.
const LEAST_RISE: f64 = 1.5e-3;
/// Largest residual of the quadric over that of the plane [1].
const LEAST_BETTER: f64 = 0.6;
/// Largest residual of the quadric over that of the plane if the residual of the quadric is the
/// noise of the contacts; and the largest ratio of residual to noise for this case [1].
const LEAST_BETTER_THAN_NOISE: f64 = 0.85;
const LIKE_NOISE: f64 = 1.3;
/// Least rise over its standard deviation by noise, for such a quadric [1].
const SIGNIFICANT: f64 = 5.0;
/// A quadric explains contacts whose median distance from it is below this [m], or below these multiples of the noise and
/// of their distance from the plane [1].
const EXPLAINED: f64 = 3e-4;
const EXPLAINED_NOISE: f64 = 2.0;
const EXPLAINED_SHARE: f64 = 0.15;
/// Least second principal curvature over the first [1], and least sagitta that it makes [m], of a shape that is no cylinder.
const DOUBLY: [f64; 2] = [0.25, 4e-4];
/// Least variance of the heights per unit of curvature at which it is determined, in units of the contacts' spread to the
/// fourth power [1]; and least variance of a place along a direction, in units of the spread squared [1].
const DETERMINED: [f64; 2] = [1e-3, 1e-3];
/// Largest part of an undetermined component of K, each a unit vector, along a direction whose curvature counts as
/// determined [1].
const MOST_FREE: f64 = 0.1;
/// Extent of an arc over its radius from which a circle gives the radius [1].
const DEEP: f64 = 0.8;
/// Iterations of reweighted least squares, and the residual beyond which a contact gets less weight [m].
const ROUNDS: usize = 8;
const OUTLIER: f64 = 1e-3;

/// A shape other than a plane that fits the contacts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::interpret) enum ContactShape {
    /// A cylinder.
    Cylinder {
        /// Radius [m].
        radius: f64,
        /// Angle of the axis from the surface's x, from 0 to π [rad].
        axis: f64,
        /// Whether it bulges towards the tool.
        is_convex: bool,
    },
    /// A section along one direction is an arc; the contacts do not show the rest.
    Arc {
        /// Radius [m].
        radius: f64,
        /// Angle of the section from the surface's x, from 0 to π [rad].
        direction: f64,
        /// Whether it bulges towards the tool.
        is_convex: bool,
    },
    /// Curved in two directions.
    Doubly {
        /// Principal radii, the smaller first; positive where the surface bulges towards the tool [m].
        radii: [f64; 2],
        /// Angle of the section with the first radius from the surface's x, from 0 to π [rad].
        direction: f64,
    },
    /// Neither a plane nor a quadric.
    Other,
}

/// A place at which the tool pressed, with the height of its underside at nominal force.
#[derive(Debug, Clone, Copy)]
pub(super) struct PressedPlace {
    pub(super) place: Point2,
    pub(super) height: f64,
    /// Height of the tool centre point as measured [m].
    pub(super) measured: f64,
    /// Force on the tool [N].
    pub(super) force: Vector3,
    /// Number of the contact in the log.
    pub(super) index: usize,
}

impl ContactShape {
    /// Fits the shape to the contacts among the pieces, whose forces are as read; `None` where a plane fits as well. Also
    /// returns the distance from the best plane that a tenth of the contacts exceeds [m].
    ///
    /// In the chart of a curved surface, a plane is the surface itself.
    pub(in crate::interpret) fn of(
        pieces: &[MeasuredPiece],
        surface: &Surface,
        config: &InterpretConfig,
    ) -> Option<(Self, f64)> {
        let first = pressed_places(pieces, surface, config, |_| Vector3::z());
        let quadric = Quadric::fit(&first)?;
        // Friction has no part along the real normal.
        let contacts = pressed_places(pieces, surface, config, |place| quadric.normal(place));
        let quadric = Quadric::fit(&contacts)?;
        let plane = Quadric::fit_plane(&contacts)?;
        let [bent, flat] = [&quadric, &plane].map(|fit| fit.residual(&contacts, 0.5));
        let noise = quadric.noise(&contacts);
        // Of a parabola through n places with errors σ, the sagitta has the standard deviation √720/8 σ/√n = 3.35 σ/√n. The
        // median of a normal error is 0.674 σ.
        let deviation = 3.35 * noise / 0.674 / (contacts.len() as f64).sqrt();
        let rise = quadric.rise_over(&plane, &contacts);
        let is_noise = bent <= LIKE_NOISE * noise && rise >= SIGNIFICANT * deviation;
        let better = if is_noise {
            LEAST_BETTER_THAN_NOISE
        } else {
            LEAST_BETTER
        };
        if rise < LEAST_RISE || bent > better * flat {
            return None;
        }
        let explained = (EXPLAINED.max(EXPLAINED_NOISE * noise)).max(EXPLAINED_SHARE * flat);
        let shape = (bent <= explained).then(|| quadric.classify(&contacts));
        let shape = shape.flatten().unwrap_or(Self::Other);
        Some((shape, plane.residual(&contacts, 0.9)))
    }
}

/// Returns the places of contact. Contacts near the border are left out, as the tool tips there. `normal` is that of the
/// real surface at a place.
pub(super) fn pressed_places(
    pieces: &[MeasuredPiece],
    surface: &Surface,
    config: &InterpretConfig,
    normal: impl Fn(Point2) -> Vector3,
) -> Vec<PressedPlace> {
    let stiffness = config.stiffness().unwrap_or(f64::INFINITY);
    let mut contacts: Vec<PressedPlace> = Vec::new();
    for piece in pieces {
        let place = piece.position.xy();
        let is_new = (contacts.last()).is_none_or(|last| (place - last.place).norm() >= TRAVEL);
        let force = piece.force.dot(&normal(place));
        if is_new && is_inland(place, surface, config) && config.normalized(-force) >= PRESSING {
            let spring_back = (force - config.level_force()) / stiffness;
            contacts.push(PressedPlace {
                place,
                height: piece.mean_height + spring_back,
                measured: piece.mean_height,
                force: piece.force,
                index: contacts.len(),
            });
        }
    }
    // Separate touches without sliding show no shape.
    let mut steps: Vec<f64> = (contacts.windows(2))
        .map(|pair| (pair[1].place - pair[0].place).norm())
        .collect();
    steps.sort_unstable_by(f64::total_cmp);
    let median = steps.get(steps.len() / 2).copied().unwrap_or(0.0);
    let apart = APART[0].max(APART[1] * median);
    let slides = contacts.chunk_by(|one, next| (next.place - one.place).norm() <= apart);
    slides
        .filter(|slide| slide.len() >= SLIDE)
        .flatten()
        .copied()
        .collect()
}

/// Whether a place is so far from the border that the tool does not tip there.
pub(in crate::interpret) fn is_inland(
    place: Point2,
    surface: &Surface,
    config: &InterpretConfig,
) -> bool {
    let edges = surface.outline.edges().map(|edge| edge.distance(place));
    surface.outline.contains(place)
        && edges.fold(f64::INFINITY, f64::min) >= config.redraw_length_m / 2.0
}

/// A quadric z = height + slope · p + ½ pᵀ K p, with p relative to the middle of the contacts.
pub(super) struct Quadric {
    middle: Point2,
    height: f64,
    slope: Vector2,
    curvature: Matrix2<f64>,
    /// Components of K that the contacts do not determine, each a unit vector of (K_xx, K_xy, K_yy).
    free: Vec<nalgebra::Vector3<f64>>,
}

impl Quadric {
    /// `None` if the contacts are too few.
    pub(super) fn fit(contacts: &[PressedPlace]) -> Option<Self> {
        Self::fit_terms(contacts, 3)
    }

    pub(super) fn fit_plane(contacts: &[PressedPlace]) -> Option<Self> {
        Self::fit_terms(contacts, 0)
    }

    /// Fits a plane and `terms` components of K by iteratively reweighted least squares, in units of the spread.
    fn fit_terms(contacts: &[PressedPlace], terms: usize) -> Option<Self> {
        if contacts.len() < FEWEST {
            return None;
        }
        let count = contacts.len() as f64;
        let sum: Vector2 = contacts.iter().map(|contact| contact.place.coords).sum();
        let middle = Point2::from(sum / count);
        let squares = contacts
            .iter()
            .map(|contact| (contact.place - middle).norm_squared());
        let spread = (squares.sum::<f64>() / count).sqrt();
        if spread <= 0.0 {
            return None;
        }
        let row = |place: Point2| {
            let p = (place - middle) / spread;
            Vector6::new(1.0, p.x, p.y, 0.5 * p.x * p.x, p.x * p.y, 0.5 * p.y * p.y)
        };
        let mut found = Vector6::zeros();
        let mut free = Vec::new();
        for round in 0..ROUNDS {
            let (mut normal, mut right, mut weights) = (Matrix6::zeros(), Vector6::zeros(), 0.0);
            for contact in contacts {
                let row = row(contact.place);
                let residual = (contact.height - row.dot(&found)).abs();
                let weight = if round == 0 {
                    1.0
                } else {
                    OUTLIER / residual.max(OUTLIER)
                };
                normal += row * row.transpose() * weight;
                right += row * (contact.height * weight);
                weights += weight;
            }
            (found, free) = solve(&(normal / weights), &(right / weights), terms);
        }
        let scale = spread * spread;
        Some(Self {
            middle,
            height: found[0],
            slope: Vector2::new(found[1], found[2]) / spread,
            curvature: Matrix2::new(found[3], found[4], found[4], found[5]) / scale,
            free,
        })
    }

    pub(super) fn height_at(&self, place: Point2) -> f64 {
        let p = place - self.middle;
        self.height + self.slope.dot(&p) + 0.5 * p.dot(&(self.curvature * p))
    }

    /// Unit normal over a place.
    pub(super) fn normal(&self, place: Point2) -> Vector3 {
        let slope = self.slope + self.curvature * (place - self.middle);
        Vector3::new(-slope.x, -slope.y, 1.0).normalize()
    }

    /// Distance from the quadric that this share of the contacts stays below [m].
    fn residual(&self, contacts: &[PressedPlace], share: f64) -> f64 {
        let distances = contacts
            .iter()
            .map(|one| (one.height - self.height_at(one.place)).abs());
        quantile(distances.collect(), share)
    }

    /// Median distance from the quadric that independent errors of the contacts would give [m].
    fn noise(&self, contacts: &[PressedPlace]) -> f64 {
        let off = |one: &PressedPlace| one.height - self.height_at(one.place);
        let steps = contacts
            .windows(2)
            .map(|pair| (off(&pair[1]) - off(&pair[0])).abs());
        quantile(steps.collect(), 0.5) / std::f64::consts::SQRT_2
    }

    /// Extent of the contacts near the quadric along a direction [m].
    fn extent(&self, contacts: &[PressedPlace], along: Vector2) -> f64 {
        let places = self.near(contacts).map(|one| along.dot(&one.place.coords));
        let (least, most) = range(places);
        (most - least).max(0.0)
    }

    /// Range of the heights of the quadric over a plane at the contacts near the quadric [m].
    fn rise_over(&self, plane: &Self, contacts: &[PressedPlace]) -> f64 {
        let over = |place: Point2| self.height_at(place) - plane.height_at(place);
        let (least, most) = range(self.near(contacts).map(|one| over(one.place)));
        (most - least).max(0.0)
    }

    /// Returns the contacts near the quadric.
    fn near<'a>(&self, contacts: &'a [PressedPlace]) -> impl Iterator<Item = &'a PressedPlace> {
        let is_near =
            |one: &&PressedPlace| (one.height - self.height_at(one.place)).abs() <= 3.0 * OUTLIER;
        contacts.iter().filter(is_near)
    }

    /// Returns the shape whose curvature the quadric has.
    fn classify(&self, contacts: &[PressedPlace]) -> Option<ContactShape> {
        if !self.free.is_empty() {
            return self.arc(contacts);
        }
        let eigen = self.curvature.symmetric_eigen();
        let strongest = eigen.eigenvalues.iamax();
        let across: Vector2 = eigen.eigenvectors.column(strongest).into_owned();
        let along = Vector2::new(-across.y, across.x);
        let [strong, weak] = [strongest, 1 - strongest].map(|i| eigen.eigenvalues[i]);
        let [ratio, sagitta] = DOUBLY;
        let is_doubly = weak.abs() >= ratio * strong.abs()
            && weak.abs() * self.extent(contacts, along).powi(2) / 8.0 >= sagitta;
        if is_doubly {
            return Some(ContactShape::Doubly {
                radii: [-1.0 / strong, -1.0 / weak],
                direction: angle(across),
            });
        }
        Some(ContactShape::Cylinder {
            radius: self.radius(contacts, across)?,
            axis: angle(along),
            is_convex: strong < 0.0,
        })
    }

    /// Returns the section of the strongest curvature among those that the contacts determine.
    fn arc(&self, contacts: &[PressedPlace]) -> Option<ContactShape> {
        let unit = |degrees: i32| {
            let angle = f64::from(degrees).to_radians();
            Vector2::new(libm::cos(angle), libm::sin(angle))
        };
        let is_determined = |along: &Vector2| {
            let part = |free: &nalgebra::Vector3<f64>| {
                let free = Matrix2::new(free.x, free.y, free.y, free.z);
                along.dot(&(free * along)).abs()
            };
            self.free.iter().all(|free| part(free) <= MOST_FREE)
        };
        let curvature = |along: &Vector2| along.dot(&(self.curvature * along));
        let along = (0..180).map(unit).filter(is_determined);
        let along = along.max_by(|a, b| curvature(a).abs().total_cmp(&curvature(b).abs()))?;
        Some(ContactShape::Arc {
            radius: self.radius(contacts, along)?,
            direction: angle(along),
            is_convex: curvature(&along) < 0.0,
        })
    }

    /// Returns the radius of the section along a direction [m].
    fn radius(&self, contacts: &[PressedPlace], across: Vector2) -> Option<f64> {
        let rise = self.slope.dot(&across);
        let curvature = across.dot(&(self.curvature * across)).abs();
        // 1/R = |z″| / (1 + z′²)^(3/2).
        let shallow = (1.0 + rise * rise).powf(1.5) / curvature;
        if self.extent(contacts, across) < DEEP * shallow {
            Some(shallow)
        } else {
            self.circle(contacts, across)
        }
    }

    /// Returns the radius of the circle through the contacts in the section along `across` [m].
    fn circle(&self, contacts: &[PressedPlace], across: Vector2) -> Option<f64> {
        let along = Vector2::new(-across.y, across.x);
        let rise = self.slope.dot(&along);
        let (mut normal, mut right) = (Matrix3::zeros(), nalgebra::Vector3::zeros());
        // An algebraic fit is not robust, so outliers are left out.
        for one in self.near(contacts) {
            let p = one.place - self.middle;
            let (u, z) = (
                p.dot(&across),
                one.height - self.height - rise * p.dot(&along),
            );
            let row = nalgebra::Vector3::new(u, z, 1.0);
            normal += row * row.transpose();
            right -= row * (u * u + z * z);
        }
        // Circle u² + z² + d u + e z + f = 0 by linear least squares; radius² = (d² + e²)/4 − f.
        let [d, e, f]: [f64; 3] = normal.try_inverse().map(|inverse| inverse * right)?.into();
        let square = 0.25 * (d * d + e * e) - f;
        (square > 0.0).then(|| square.sqrt())
    }
}

/// Solves the normal equations of a plane and of the last `terms` components of K, except for
/// undetermined components. Returns the coefficients and the undetermined components.
fn solve(
    normal: &Matrix6<f64>,
    right: &Vector6<f64>,
    terms: usize,
) -> (Vector6<f64>, Vec<nalgebra::Vector3<f64>>) {
    let [least_heights, least_places] = DETERMINED;
    let flat: Matrix3<f64> = normal.fixed_view::<3, 3>(0, 0).into_owned();
    let mixed: Matrix3<f64> = normal.fixed_view::<3, 3>(0, 3).into_owned();
    let bent: Matrix3<f64> = normal.fixed_view::<3, 3>(3, 3).into_owned();
    let [first, last] = [0, 3].map(|row| right.fixed_rows::<3>(row).into_owned());
    let inverse = |matrix: Matrix3<f64>, least: f64| {
        let SymmetricEigen {
            eigenvectors,
            eigenvalues,
        } = matrix.symmetric_eigen();
        let (mut inverse, mut free) = (Matrix3::zeros(), Vec::new());
        for (axis, value) in eigenvectors.column_iter().zip(eigenvalues.iter()) {
            if *value >= least {
                inverse += axis * axis.transpose() / *value;
            } else {
                free.push(axis.into_owned());
            }
        }
        (inverse, free)
    };
    let (of_plane, _) = inverse(flat, least_places);
    let mut curvature = nalgebra::Vector3::zeros();
    let mut free = Vec::new();
    if terms > 0 {
        // The Schur complement: what the curvature adds to the heights beyond a plane.
        let (of_bend, undetermined) =
            inverse(bent - mixed.transpose() * of_plane * mixed, least_heights);
        curvature = of_bend * (last - mixed.transpose() * of_plane * first);
        free = undetermined;
    }
    let plane = of_plane * (first - mixed * curvature);
    let mut found = SMatrix::<f64, 6, 1>::zeros();
    found.fixed_rows_mut::<3>(0).copy_from(&plane);
    found.fixed_rows_mut::<3>(3).copy_from(&curvature);
    (found, free)
}

/// Angle of a direction from x, from 0 to π [rad].
fn angle(direction: Vector2) -> f64 {
    let angle = libm::atan2(direction.y, direction.x);
    if angle < 0.0 {
        angle + std::f64::consts::PI
    } else {
        angle
    }
}

/// Least and largest of some values.
fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold(
        (f64::INFINITY, f64::NEG_INFINITY),
        |(least, most), value| (least.min(value), most.max(value)),
    )
}

/// Returns a quantile; 0 for an empty list.
fn quantile(mut values: Vec<f64>, share: f64) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let at = ((values.len() - 1) as f64 * share) as usize;
    *values.select_nth_unstable_by(at, f64::total_cmp).1
}
