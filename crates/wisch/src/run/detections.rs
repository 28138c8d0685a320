//! Detections of a camera that lie beside the surface, or that repeat another one.

use super::RunError;
use crate::geometry::{Bounds2, Point2};
use crate::interpret::Doubt;
use crate::represent::{Observation, Surface};

/// Largest distance from the outline at which a detection beside the surface counts as dirt at the
/// edge [m]: the error of the surface's pose. The error of the camera is added if it is larger.
const AT_EDGE: f64 = 0.03;
/// Largest such distance in a first observation without a detection on the surface [m].
const ALL_AT_EDGE: f64 = 0.01;
/// Largest usual error of a detection, in standard deviations [1].
const DEVIATIONS: f64 = 5.0;
/// Distance from which most detections show a wrong unit or frame, over the diagonal of the surface [1].
const FAR_OFF: f64 = 10.0;

/// Returns an observation without the detections that repeat another one
/// ([`Observation::merge_repeated`]) or lie beside the surface, and a remark for each of the two reasons.
///
/// A detection counts as dirt at the edge if it lies at most 30 mm or five standard deviations beside the surface.
///
/// # Parameters
/// - `observation`: detections in the chart of the believed surface.
/// - `surface`: the believed surface.
/// - `error`: standard deviation of a detection's position, along x and along y \[m\].
/// - `is_first`: whether no observation precedes this one, so that most of the dirt should be on the surface.
///
/// # Errors
/// If all detections of a first observation are beside the surface, or most of any observation are farther from it than
/// ten times its diagonal: their unit or frame is wrong.
pub fn check_detections(
    mut observation: Observation,
    surface: &Surface,
    error: f64,
    is_first: bool,
) -> Result<(Observation, Vec<Doubt>), RunError> {
    let mut doubts: Vec<Doubt> = leave_out_beside(&mut observation, surface, error, is_first)?
        .into_iter()
        .collect();
    let of = observation.detections.len();
    let repeated = observation.merge_repeated(error);
    if repeated > 0 {
        doubts.push(Doubt::DetectionsRepeated { repeated, of });
    }
    Ok((observation, doubts))
}

/// Leaves out the detections beside the surface, and returns a remark on them if there are any; see [`check_detections`].
fn leave_out_beside(
    observation: &mut Observation,
    surface: &Surface,
    error: f64,
    is_first: bool,
) -> Result<Option<Doubt>, RunError> {
    let outline = &surface.outline;
    let distance = |place: &Point2| {
        if outline.contains(*place) {
            return 0.0;
        }
        let edges = outline.edges().map(|edge| edge.distance(*place));
        edges.fold(f64::INFINITY, f64::min)
    };
    let distances: Vec<f64> = observation.detections.iter().map(distance).collect();
    let beyond = |limit: f64| distances.iter().filter(|off| **off > limit).count();
    let of = distances.len();
    let at_edge = if is_first && beyond(0.0) == of {
        ALL_AT_EDGE
    } else {
        AT_EDGE
    };
    let most = at_edge.max(DEVIATIONS * error);
    let left_out = beyond(most);
    if left_out == 0 {
        return Ok(None);
    }
    let farthest = distances.iter().copied().fold(0.0, f64::max);
    let bounds = Bounds2::from_points(outline.outer().iter().copied());
    let width = bounds.map_or(0.0, |bounds| bounds.size().norm());
    // Dirt that was swept off lies near the surface, and a table around it has dirt of its own.
    let far = if is_first && beyond(most) == of {
        most
    } else {
        (FAR_OFF * width).max(most)
    };
    if 2 * beyond(far) > of {
        return Err(RunError::DetectionsElsewhere {
            surface: surface.name.clone(),
            count: beyond(far),
            of,
            farthest,
        });
    }
    let mut places = distances.iter();
    let mut is_kept = || places.next().is_none_or(|off| *off <= most);
    observation.detections.retain(|_| is_kept());
    Ok(Some(Doubt::DetectionsBeside {
        left_out,
        of,
        farthest,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Polygon, Pose, Vector2};

    /// Applies [`check_detections`] to detections around a surface of 0.32 m by 0.24 m.
    fn kept(places: &[[f64; 2]], is_first: bool) -> Result<(usize, Option<Doubt>), RunError> {
        let outline = Polygon::rectangle(Vector2::new(0.32, 0.24));
        let surface = Surface::new("board", outline, Pose::identity());
        let seen = Observation {
            detections: places.iter().copied().map(Point2::from).collect(),
            ..Observation::default()
        };
        let kept = check_detections(seen, &surface, 2e-3, is_first);
        kept.map(|(seen, doubts)| (seen.detections.len(), doubts.into_iter().next()))
    }

    #[test]
    fn detections_beside_the_surface_are_left_out() {
        assert_eq!(kept(&[[0.0, 0.0], [0.17, 0.0]], true), Ok((2, None)));
        let (count, doubt) = kept(&[[0.0, 0.0], [0.05, 0.05], [0.26, 0.0]], true).unwrap();
        assert_eq!(count, 2);
        let expected = "1 of 3 detections of the camera is beside the surface, up to 0.100 m from its edge, and is left out";
        assert_eq!(doubt.unwrap().to_string(), expected);
        // Dirt that was wiped off the surface may lie beside it.
        let (count, doubt) = kept(&[[0.20, 0.0]], false).unwrap();
        assert_eq!(count, 0);
        let doubt = doubt.unwrap().to_string();
        assert!(doubt.ends_with("expected metres in the frame of the believed surface, unless the dirt was wiped off it"), "{doubt}");
        assert_eq!(kept(&[], true), Ok((0, None)));
        // On the floor beside a clean board, and on the table around a board with dirt of its own.
        assert_eq!(kept(&[[0.66, 0.0]], false).unwrap().0, 0);
        let around = [[0.0, 0.0], [0.1, 0.0], [0.3, 0.0], [0.0, 0.4], [-0.4, 0.1]];
        assert_eq!(kept(&around, true).unwrap().0, 2);
    }

    #[test]
    fn detections_in_another_unit_or_frame_are_an_error() {
        for (places, is_first) in [
            (&[[-100.0, 50.0], [20.0, 30.0], [60.0, -80.0]][..], true),
            (&[[-100.0, 50.0], [20.0, 30.0], [60.0, -80.0]][..], false),
            (&[[0.20, 0.0]][..], true),
        ] {
            let error = kept(places, is_first).unwrap_err().to_string();
            assert!(error.contains("are beside surface \"board\""), "{error}");
            assert!(error.contains("unit or frame"), "{error}");
        }
    }
}
