//! Classification of pieces as contact: normalised force (9), confident contacts (10) and the fitted plane (11).

use super::downsampling::MeasuredPiece;
use super::levels::ContactLevels;
use super::path::{FittedPlane, PathPiece, Touch};
use super::plane::{PlaneFit, fit_near, fit_plane};
use super::registration::{ShapeFit, fit_shape, in_space};
use super::residuals::{ContactResidual, map_residuals};
use crate::geometry::{Bounds2, Point2, Point3, Vector2, Vector3};
use crate::interpret::config::{InterpretConfig, PlaneConfig, ToolCompliance};
use crate::represent::Surface;

/// Travel after which the next confident contact counts for the plane [m] ...
const POINT_TRAVEL: f64 = 5e-4;
/// ... or time after which it counts [s], so that a standing tool does not outvote a wiping one.
const POINT_PERIOD: f64 = 0.05;
/// Least f′ at which a weak contact shows the height of the surface [1].
const TOUCHING_SHARE: f64 = 0.3;
/// Registered surface against plane [1]: the surface lies at the registered pose above the first ratio
/// of contacts on the two, or below the second ratio of root mean square distances. A yawed surface
/// bends the chart.
const LEAST_MORE: f64 = 1.02;
const MUCH_NEARER: f64 = 0.5;
/// Largest number of contacts against which a curved surface is registered.
const MOST_REGISTERED: usize = 5000;
/// Least share of the tool that the surface must support for a contact with the surface [1].
const LEAST_SUPPORT: f64 = 0.3;
/// Least cosine of the angle between tool axis and plane normal at which the underside faces the plane [1].
const LEAST_FACING: f64 = 0.5;
/// Steepest plane that is reported as a plane [rad].
const STEEPEST: f64 = 1.0;
/// Least share of the confident contacts that a plane must hold if it is steeper than the searched
/// planes [1].
const LEAST_ON_STEEP: f64 = 0.8;
/// Least f′ at which a hovering tool is close enough to act [1]; at five times its gap.
const NEAR_SHARE: f64 = 0.2;
/// Least f′ off the plane that counts as a contact-like force [1].
const FALSE_POSITIVE_SHARE: f64 = 0.2;

/// A path whose pieces are classified as contact or free.
#[derive(Debug, Clone)]
pub(in crate::interpret) struct ClassifiedPath {
    pub(in crate::interpret) path: Vec<PathPiece>,
    /// Distance of the tool's underside from the plane beyond the tolerance of contact [m]; at most 0 in contact.
    pub(in crate::interpret) off: Vec<f64>,
    /// The same under the assumption that the tool compresses exactly as its spring says [m].
    pub(in crate::interpret) off_spring: Vec<f64>,
    pub(in crate::interpret) plane: Option<(PlaneFit, FittedPlane)>,
    /// The pose at which the shape of a curved surface fits the contacts.
    pub(in crate::interpret) registration: Option<ShapeFit>,
    /// Whether the contacts lie on the registered surface rather than on a plane in the chart.
    pub(in crate::interpret) is_moved: bool,
    /// Distances of the contacts from the fitted surface, by place.
    pub(in crate::interpret) residuals: Vec<ContactResidual>,
}

/// Classifies measured pieces.
#[derive(Debug, Clone, Copy)]
pub(in crate::interpret) struct ContactClassifier<'a> {
    pub(in crate::interpret) surface: &'a Surface,
    /// Largest distance of the footprint from the tool centre point [m].
    pub(in crate::interpret) reach: f64,
    pub(in crate::interpret) config: &'a InterpretConfig,
    /// Upper limit of f′ [1]: that of the declared force, if the nominal force of the log is smaller.
    pub(in crate::interpret) most_share: f64,
    /// The planes at different heights on which the contacts lie; the main one of them then counts.
    pub(in crate::interpret) levels: Option<ContactLevels>,
}

impl ContactClassifier<'_> {
    /// Fits the plane and classifies each piece; the forces of the pieces are read already.
    pub(in crate::interpret) fn classify(&self, pieces: &[MeasuredPiece]) -> ClassifiedPath {
        let config = self.config;
        let confident = touching_points(pieces, config.confident_share, config);
        let level =
            (self.levels).and_then(|levels| fit_near(&confident, levels.main, &config.plane));
        let fit = level.or_else(|| fit_plane(&confident, &config.plane, config.seed));
        let plane = fit.filter(|_| config.gap_m == 0.0).map(|fit| {
            let touching = touching_points(pieces, TOUCHING_SHARE, config);
            let fit = level.unwrap_or_else(|| widen(fit, &confident, &touching, config));
            let described = describe(&fit, &confident, self.surface, config);
            (fit, described)
        });
        let fit = plane.as_ref().map(|(fit, _)| fit);
        let (registration, is_moved, residuals) =
            (fit.map(|fit| self.register(fit, pieces))).unwrap_or_default();
        let mut path = Vec::with_capacity(pieces.len());
        let (mut off, mut off_spring) = (Vec::new(), Vec::new());
        for piece in pieces {
            let (classified, [least, by_spring]) = self.classify_piece(piece, fit);
            path.push(classified);
            off.push(least);
            off_spring.push(by_spring);
        }
        ClassifiedPath {
            path,
            off,
            off_spring,
            plane,
            registration,
            is_moved,
            residuals,
        }
    }

    /// Returns the pose at which a curved surface fits the contacts, whether more contacts lie on it than on `fit`, and the
    /// distances of the contacts from the fitted surface by place. Without that pose, `fit` counts: a plane over the chart.
    fn register(
        &self,
        fit: &PlaneFit,
        pieces: &[MeasuredPiece],
    ) -> (Option<ShapeFit>, bool, Vec<ContactResidual>) {
        let (config, shape) = (self.config, &self.surface.shape);
        let mut contacts = touching_points(pieces, TOUCHING_SHARE, config);
        let stride = contacts.len().div_ceil(MOST_REGISTERED).max(1);
        contacts = contacts.into_iter().step_by(stride).collect();
        let points: Vec<Point3> = (contacts.iter())
            .map(|contact| in_space(shape, contact))
            .collect();
        let registration = (!shape.is_plane())
            .then(|| fit_shape(&points, shape, &config.plane, config.seed))
            .flatten();
        let height = |contact: &Point3, point: &Point3| match &registration {
            Some(registration) => registration.height(shape, *point),
            None => fit.distance(*contact),
        };
        let residuals = contacts.iter().zip(&points);
        let residuals = map_residuals(residuals.map(|(at, point)| (at.xy(), height(at, point))));
        let on_plane = contacts.iter().filter(|at| is_on(fit, at, config)).count() as f64;
        let is_moved = registration.as_ref().is_some_and(|found| {
            let inliers = found.inliers as f64;
            let is_nearer = found.rms < MUCH_NEARER * fit.rms && inliers >= on_plane;
            is_nearer || inliers > LEAST_MORE * on_plane
        });
        (registration, is_moved, residuals)
    }

    fn classify_piece(
        &self,
        piece: &MeasuredPiece,
        plane: Option<&PlaneFit>,
    ) -> (PathPiece, [f64; 2]) {
        let force = piece.force;
        let normal_force = -force.z;
        let center = Point3::new(piece.position.x, piece.position.y, piece.mean_height);
        let height = plane.map_or(center.z, |plane| plane.distance(center));
        let off = self.off(center.xy(), height, normal_force);
        let hovers = self.config.gap_m > 0.0;
        let share = if hovers {
            nearness(height, self.config.gap_m)
        } else {
            self.config.normalized(normal_force)
        };
        let on_plane = plane.is_some() && off[0] <= 0.0;
        let touch = match (on_plane, share) {
            (_, share) if hovers && share >= NEAR_SHARE => Touch::Weak,
            _ if hovers => Touch::Free,
            (true, share) if share >= self.config.confident_share => Touch::Confident,
            (true, _) => Touch::Weak,
            (false, share) if share >= FALSE_POSITIVE_SHARE => Touch::FalsePositive,
            (false, _) => Touch::Free,
        };
        let classified = PathPiece {
            time: piece.time,
            position: piece.position,
            heading: piece.heading,
            normal_force,
            tangential_force: force.xy().norm(),
            normalized_force: share.clamp(0.0, self.most_share),
            height,
            slope: plane.map_or_else(Vector2::zeros, |plane| slope(piece, &plane.normal())),
            touch,
        };
        (classified, off)
    }

    /// Returns the angle [rad] between the believed surface and a plane steeper than the searched
    /// planes, if nearly all confident contacts lie on this plane.
    pub(in crate::interpret) fn find_steep_plane(&self, pieces: &[MeasuredPiece]) -> Option<f64> {
        let config = self.config;
        let confident = touching_points(pieces, config.confident_share, config);
        let wide = PlaneConfig {
            cone: STEEPEST,
            min_share: LEAST_ON_STEEP,
            ..config.plane.clone()
        };
        let plane = fit_plane(&confident, &wide, config.seed)?;
        // Contacts along one line may be those of a tool that is lifted.
        (plane.directions == 2 && plane.tilt() > config.plane.cone).then(|| plane.tilt())
    }

    /// Returns the distance of the underside from the plane beyond the tolerance of contact [m]: the least possible
    /// one, and that of a tool that compresses exactly as its spring says. `height` is that of the tool centre point
    /// [m].
    fn off(&self, place: Point2, height: f64, normal_force: f64) -> [f64; 2] {
        let spring_back = spring_back(normal_force, self.config);
        let doubt = match self.config.compliance {
            ToolCompliance::Rigid => 0.0,
            ToolCompliance::Spring { uncertainty, .. } => uncertainty * spring_back.abs(),
        };
        let by_spring = height + spring_back;
        // Above nominal force a tool may not compress further: a sponge, for example, bottoms out.
        let least = if spring_back > 0.0 {
            height.max(0.0) + by_spring.min(0.0)
        } else {
            by_spring
        };
        [least, by_spring].map(|clearance| {
            let off = clearance.abs() - self.config.plane.inlier_distance_m - doubt;
            if clearance < 0.0 && off > 0.0 {
                off - self.config.nominal_compression() * (1.0 / self.support(place) - 1.0)
            } else {
                off
            }
        })
    }

    /// Share of the tool that the surface supports [1]: a half over an edge, where the tool compresses twice as far.
    fn support(&self, place: Point2) -> f64 {
        let outline = &self.surface.outline;
        let distances = outline.edges().map(|edge| edge.distance(place));
        let distance = distances.fold(f64::INFINITY, f64::min);
        let inside = if outline.contains(place) { 1.0 } else { -1.0 };
        (0.5 + 0.5 * inside * distance / self.reach.max(f64::MIN_POSITIVE))
            .clamp(LEAST_SUPPORT, 1.0)
    }
}

/// Slope of the plane against the tool's underside, in the tool frame [1]; `normal` is in the believed surface frame.
/// A frame whose z axis points into the surface is turned about its x axis, which keeps the heading. Zero where tool and
/// surface are nearly perpendicular, which does not occur in contact.
pub(super) fn slope(piece: &MeasuredPiece, normal: &Vector3) -> Vector2 {
    let mut normal_in_tool = piece.surface_from_tool.inverse() * normal;
    if normal_in_tool.z < 0.0 {
        normal_in_tool = Vector3::new(normal_in_tool.x, -normal_in_tool.y, -normal_in_tool.z);
    }
    if normal_in_tool.z < LEAST_FACING {
        return Vector2::zeros();
    }
    -normal_in_tool.xy() / normal_in_tool.z
}

/// f′ of a hovering tool [1]: its gap over the clearance of its outlet, which is `gap + height`.
fn nearness(height: f64, gap: f64) -> f64 {
    gap / (gap + height).max(gap)
}

/// Height of the tool's underside above its tool centre point at a normal force [m].
fn spring_back(normal_force: f64, config: &InterpretConfig) -> f64 {
    match config.compliance {
        ToolCompliance::Rigid => 0.0,
        // Linear spring: more force compresses it further, and without contact it has its full length.
        ToolCompliance::Spring {
            stiffness_n_per_m, ..
        } => (-normal_force.min(0.0) - config.level_force()) / stiffness_n_per_m,
    }
}

/// Refits the plane with weaker contacts. On a falling surface, confident contacts are few and
/// close together, and determine the slope poorly; the spring-back of the tool shows further points
/// of contact. The wider fit is used if most of the confident contacts of the first plane lie on
/// it.
fn widen(
    first: PlaneFit,
    confident: &[Point3],
    touching: &[Point3],
    config: &InterpretConfig,
) -> PlaneFit {
    let Some(wide) = fit_plane(touching, &config.plane, config.seed) else {
        return first;
    };
    let own = (confident.iter()).filter(|point| is_on(&first, point, config));
    let (count, shared) = own.fold((0_usize, 0_usize), |(count, shared), point| {
        (count + 1, shared + usize::from(is_on(&wide, point, config)))
    });
    if 2 * shared >= count { wide } else { first }
}

fn is_on(plane: &PlaneFit, point: &Point3, config: &InterpretConfig) -> bool {
    plane.distance(*point).abs() <= config.plane.inlier_distance_m
}

/// Returns the points of contact with at least this f′ (10), in the frame of the believed surface.
fn touching_points(
    pieces: &[MeasuredPiece],
    least_share: f64,
    config: &InterpretConfig,
) -> Vec<Point3> {
    let mut points = Vec::new();
    let mut last: Option<(f64, Point3)> = None;
    for piece in pieces {
        let normal_force = -piece.force.z;
        let share = config.normalized(normal_force);
        if !(least_share..=config.confident_limit()).contains(&share) {
            continue;
        }
        let height = piece.mean_height + spring_back(normal_force, config);
        if height.abs() > config.search_height_m {
            continue;
        }
        let point = Point3::new(piece.position.x, piece.position.y, height);
        let is_new = last.is_none_or(|(time, place)| {
            (point - place).norm() >= POINT_TRAVEL || piece.time[1] - time >= POINT_PERIOD
        });
        if is_new {
            last = Some((piece.time[1], point));
            points.push(point);
        }
    }
    points
}

/// Middle of the bounds of a surface [m].
pub(in crate::interpret) fn middle(surface: &Surface) -> Point2 {
    let outline = surface.outline.outer().iter().copied();
    Bounds2::from_points(outline).map_or_else(Point2::origin, |bounds| bounds.center())
}

fn describe(
    fit: &PlaneFit,
    confident: &[Point3],
    surface: &Surface,
    config: &InterpretConfig,
) -> FittedPlane {
    let middle: Vector2 = middle(surface).coords;
    let offset = fit.height_at(middle);
    FittedPlane {
        point: Point3::new(middle.x, middle.y, offset),
        normal: fit.normal(),
        tilt: fit.tilt(),
        offset,
        directions: fit.directions,
        inliers: (confident.iter())
            .filter(|point| is_on(fit, point, config))
            .count(),
        confident: confident.len(),
        rms: fit.rms,
    }
}
