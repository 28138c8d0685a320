//! Which pieces of a path are contact: bias, normalised force (9), and the fitted plane (10), (11).

use super::pieces::Piece;
use super::plane::{PlaneFit, fit_plane};
use super::{FittedPlane, InterpretConfig, PathPiece, ToolCompliance, Touch};
use crate::geometry::{Bounds2, Point2, Point3, Vector2, Vector3};
use crate::represent::Surface;

/// Pieces on either side over which the speed is compared, about 50 ms: inertia of the hand is not bias.
const CALM_REACH: usize = 5;
/// Acceleration below which the tool moves calmly [m/s²]; half a newton for a hand of half a kilogram.
const CALM_ACCELERATION: f64 = 1.0;
/// Fewest pieces of free motion that tell a bias.
const MIN_CALM: usize = 5;
/// A confident contact counts for the plane once the tool has moved this far from the last that did [m] ...
const POINT_TRAVEL: f64 = 5e-4;
/// ... or this long afterwards [s], so that a tool held still does not outvote one that wipes.
const POINT_PERIOD: f64 = 0.05;
/// f′ from which on force off the plane is a force like that of contact [1].
const FALSE_POSITIVE_SHARE: f64 = 0.2;

/// What is known of a piece beyond what is told of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Clearance {
    /// Height of the tool's underside over the plane [m].
    pub(super) height: f64,
    /// Size up to which it is on the plane [m].
    pub(super) tolerance: f64,
}

/// A path with contact told apart.
#[derive(Debug, Clone)]
pub(super) struct Judged {
    pub(super) path: Vec<PathPiece>,
    pub(super) clearances: Vec<Clearance>,
    pub(super) plane: Option<(PlaneFit, FittedPlane)>,
    /// Mean of what is felt in free motion, in the axes of the believed surface [N].
    pub(super) bias: Vector3,
}

/// Tells contact apart.
pub(super) fn judge(pieces: &[Piece], surface: &Surface, config: &InterpretConfig) -> Judged {
    let bias = bias(pieces, config.free_height_m);
    let confident = confident_points(pieces, bias.z, config);
    let plane = fit_plane(&confident, &config.plane, config.seed).map(|fit| {
        let described = describe(&fit, confident.len(), surface);
        (fit, described)
    });
    let (path, clearances) = pieces
        .iter()
        .map(|piece| judge_piece(piece, bias, plane.as_ref().map(|(fit, _)| fit), config))
        .unzip();
    Judged {
        path,
        clearances,
        plane,
        bias,
    }
}

/// Median force in calm free motion, by component; zero where there is none.
fn bias(pieces: &[Piece], free_height: f64) -> Vector3 {
    let is_free = |piece: &Piece| piece.mean_height > free_height;
    let calm: Vec<Vector3> = (0..pieces.len())
        .filter(|&i| is_free(&pieces[i]) && is_calm(pieces, i))
        .map(|i| pieces[i].force)
        .collect();
    if calm.len() < MIN_CALM {
        return Vector3::zeros();
    }
    Vector3::from_fn(|row, _| median(calm.iter().map(|force| force[row]).collect()))
}

fn median(mut values: Vec<f64>) -> f64 {
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}

/// Whether the velocity is about the same before and after a piece.
fn is_calm(pieces: &[Piece], i: usize) -> bool {
    let (Some(before), Some(after)) = (i.checked_sub(CALM_REACH), pieces.get(i + CALM_REACH))
    else {
        return false;
    };
    let (before, here) = (&pieces[before], &pieces[i]);
    let first = here.time[1] - before.time[1];
    let second = after.time[1] - here.time[1];
    let change =
        (after.position - here.position) / second - (here.position - before.position) / first;
    change.norm() / (0.5 * (first + second)) < CALM_ACCELERATION
}

/// By how much the tool's underside is above its tool centre point at a normal force [m].
fn spring_back(normal_force: f64, config: &InterpretConfig) -> f64 {
    match config.compliance {
        ToolCompliance::Rigid => 0.0,
        // Pressed harder, it gives way further; not touching, it is as long as it gets.
        ToolCompliance::Spring {
            stiffness_n_per_m, ..
        } => (-normal_force.min(0.0) - config.nominal_force()) / stiffness_n_per_m,
    }
}

/// Where the underside touches with confidence (10), in the frame of the believed surface.
fn confident_points(pieces: &[Piece], bias: f64, config: &InterpretConfig) -> Vec<Point3> {
    let mut points = Vec::new();
    let mut last: Option<(f64, Point3)> = None;
    for piece in pieces {
        let normal_force = -(piece.force.z - bias);
        let share = config.normalized(normal_force);
        if !(config.confident_share..=config.confident_limit()).contains(&share) {
            continue;
        }
        let height = piece.mean_height + spring_back(normal_force, config);
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

/// The middle of a surface [m].
pub(super) fn middle(surface: &Surface) -> Point2 {
    let outline = surface.outline.outer().iter().copied();
    Bounds2::of(outline).map_or_else(Point2::origin, |bounds| bounds.center())
}

fn describe(fit: &PlaneFit, confident: usize, surface: &Surface) -> FittedPlane {
    let middle: Vector2 = middle(surface).coords;
    let offset = fit.height_at(middle);
    FittedPlane {
        point: Point3::new(middle.x, middle.y, offset),
        normal: fit.normal(),
        tilt: fit.tilt(),
        offset,
        inliers: fit.inliers,
        confident,
        rms: fit.rms,
    }
}

fn judge_piece(
    piece: &Piece,
    bias: Vector3,
    plane: Option<&PlaneFit>,
    config: &InterpretConfig,
) -> (PathPiece, Clearance) {
    let force = piece.force - bias;
    let normal_force = -force.z;
    let share = config.normalized(normal_force);
    let center = Point3::new(piece.position.x, piece.position.y, piece.mean_height);
    let height = plane.map_or(center.z, |plane| plane.distance(center));
    let spring_back = spring_back(normal_force, config);
    let doubt = match config.compliance {
        ToolCompliance::Rigid => 0.0,
        ToolCompliance::Spring { uncertainty, .. } => uncertainty * spring_back.abs(),
    };
    let clearance = Clearance {
        height: height + spring_back,
        tolerance: config.plane.inlier_distance_m + doubt,
    };
    let on_plane = plane.is_some() && clearance.height.abs() <= clearance.tolerance;
    let touch = match (on_plane, share) {
        (true, share) if share >= config.confident_share => Touch::Confident,
        (true, _) => Touch::Weak,
        (false, share) if share >= FALSE_POSITIVE_SHARE => Touch::FalsePositive,
        (false, _) => Touch::Free,
    };
    let judged = PathPiece {
        time: piece.time,
        position: piece.position,
        heading: piece.heading,
        normal_force,
        tangential_force: force.xy().norm(),
        normalized_force: share.clamp(0.0, 1.0),
        height,
        touch,
    };
    (judged, clearance)
}
