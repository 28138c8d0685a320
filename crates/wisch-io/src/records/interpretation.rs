//! The interpretation of a log, in `interpretation.json` and the output of `wisch interpret --json`.

use super::plan::PoseRecord;
use serde::Serialize;
use wisch::interpret::{
    ContactResidual, Diagnosis, Event, EventKind, FittedPlane, Interpretation, ShapeFit,
};
use wisch::recover::{Claim, Verdict, assess_log, find_excess_passes, limit_verdict};

/// Value of `format` in the record.
pub const INTERPRETATION_FORMAT: &str = "wisch-interpretation";
/// Schema number of the record.
const SCHEMA: u32 = 1;

/// The contents of `interpretation.json`: what a log shows.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct InterpretationRecord {
    /// Always [`INTERPRETATION_FORMAT`].
    pub format: &'static str,
    /// The schema of this record.
    pub schema: u32,
    /// Name of the task.
    pub task: String,
    /// absorb, collect, skim, polish or dispense.
    pub action: String,
    /// Estimated performance: share of the particles that have reached the goal, mean over the replays.
    pub estimated: f64,
    /// Its 5th percentile; 0 if the log may lack a part of the wiping, which may have undone the goal.
    pub estimated_low: f64,
    /// Its 95th percentile; 1 if the log may lack a part of the wiping, because more may have been wiped.
    pub estimated_high: f64,
    /// Share that meets the goal.
    pub target_performance: f64,
    /// Whether the verdict is "met": the mean reaches the target, the probability of a performance
    /// more than ten percentage points below it is at most 0.2 %, the log allows an estimate, and
    /// not too many points have more passes than is allowed.
    pub goal_met: bool,
    /// "met", "not met", or "unknown": the log allows no estimate, or touch alone cannot decide
    /// whether the target is reached. If the log allows no estimate, the interval covers all
    /// possible values.
    pub verdict: &'static str,
    /// Whether the log, or an observation after it, allows an estimate.
    pub is_conclusive: bool,
    /// The deciding rule with its numbers, or the reason why no estimate is possible.
    pub reason: String,
    /// Number of detections of an observation after the log; null without an observation.
    pub detections: Option<usize>,
    /// Number of replays.
    pub replays: usize,
    /// Time in contact over the time that the tool was on or near the surface; null if it never was.
    pub contact_share: Option<f64>,
    /// Number of collisions.
    pub collisions: usize,
    /// Angle between the fitted plane and the believed surface; null without a plane.
    pub plane_tilt_rad: Option<f64>,
    /// Height of the fitted plane above the centre of the believed surface; null without a plane.
    pub plane_offset_m: Option<f64>,
    /// Details of that plane; null without a plane.
    pub plane: Option<PlaneRecord>,
    /// Pose at which a curved surface fits the contacts; null for a plane.
    pub registration: Option<RegistrationRecord>,
    /// Distances of the contacts from the fitted surface, in square cells of 2 cm; empty without a fitted surface.
    pub contact_residuals: Vec<ContactResidualRecord>,
    /// Doubts whether the log is wiping of this surface, one sentence each.
    pub doubts: Vec<String>,
    /// localized, relocalize, no contact or hovering.
    pub diagnosis: &'static str,
    /// Estimated pose of the surface, if it differs from the believed pose; else null.
    pub world_from_surface: Option<PoseRecord>,
    /// Bias of the force along the surface's outward normal, which was subtracted; null if the log shows no free motion, so
    /// that it is unknown and nothing was subtracted.
    pub force_bias_n: Option<f64>,
    /// Typical press force of the tool while it slid over the plane; null without a plane.
    pub pressed_force_n: Option<f64>,
    /// Estimated stiffness of the tool; null for a rigid tool.
    pub tool_stiffness: Option<ToolStiffnessRecord>,
    /// Events, by start time.
    pub events: Vec<EventRecord>,
    /// The log.
    pub log: LogRecord,
}

/// The estimated stiffness of a tool.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ToolStiffnessRecord {
    /// Most likely value.
    pub n_per_m: f64,
    /// Standard deviation of its logarithm.
    pub ln_deviation: f64,
    /// Whether it is the declared one, because no log shows another.
    pub assumed: bool,
}

/// The fitted plane, in the frame of the believed surface.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlaneRecord {
    /// A point of the plane.
    pub point_m: [f64; 3],
    /// Its outward unit normal.
    pub normal: [f64; 3],
    /// Number of directions along the surface in which its tilt is known: 2, 1 or 0.
    pub tilt_directions: usize,
    /// Number of confident positions on the plane.
    pub inliers: usize,
    /// Total number of confident positions.
    pub confident: usize,
    /// Root mean square distance of the fitted contacts, including weak ones.
    pub rms_m: f64,
}

/// The pose of a curved surface that fits the contacts best.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RegistrationRecord {
    /// Pose of the real surface in the frame of the believed one.
    pub believed_from_real: PoseRecord,
    /// Number of the six degrees of freedom that the contacts determine; in the others, the believed pose is kept.
    pub determined: usize,
    /// Number of contacts on the fitted surface.
    pub inliers: usize,
    /// Root mean square distance of these contacts.
    pub rms_m: f64,
}

/// Distance of the contacts in a cell from the fitted surface.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ContactResidualRecord {
    /// Middle of the cell in the chart.
    pub x_m: f64,
    /// Middle of the cell in the chart.
    pub y_m: f64,
    /// Median height of the contacts over the fitted surface.
    pub height_m: f64,
    /// Number of contacts.
    pub contacts: usize,
}

/// An event that the interpretation detected.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EventRecord {
    /// contact, contact_loss, collision (a person's push), hand_guiding, landing, overload, vibration or stick_slip;
    /// or a phase: approach, stroke, lift or retreat.
    pub kind: &'static str,
    /// Start time.
    pub start_s: f64,
    /// End time.
    pub end_s: f64,
    /// Number of samples.
    pub samples: usize,
    /// Mean normal force, negative where the tool presses.
    pub mean_normal_force_n: f64,
    /// Largest magnitude of the force.
    pub peak_force_n: f64,
    /// Largest distance from the fitted plane.
    pub peak_height_m: f64,
}

/// The data that were read from a log.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LogRecord {
    /// The file or folder.
    pub file: String,
    /// Source of the poses.
    pub pose: String,
    /// Source of the forces.
    pub wrench: String,
    /// Axes of the forces.
    pub wrench_frame: &'static str,
    /// Whether these axes are assumed by default.
    pub wrench_frame_assumed: bool,
    /// Number of poses with forces.
    pub samples: usize,
    /// Duration from the first to the last sample.
    pub duration_s: f64,
    /// Time of the log at which the events' times are zero.
    pub start_ns: i64,
    /// Number of poses or forces that were left out because they had the time of the one before; of a table, number of rows.
    pub repeated: usize,
    /// Number of poses or forces that were left out without a partner.
    pub unpaired: usize,
    /// Whether the log is incomplete because its writer was killed or is still writing.
    pub unfinished: bool,
    /// Number of invalid poses or forces that were left out.
    pub skipped: usize,
    /// Gaps that are too long for interpolation: start, end.
    pub gaps_s: Vec<[f64; 2]>,
    /// Remarks on the log.
    pub remarks: Vec<String>,
}

impl InterpretationRecord {
    /// Makes the record of an interpretation.
    pub fn new(
        task: &wisch::represent::Task,
        interpretation: &Interpretation,
        target_performance: f64,
        log: LogRecord,
    ) -> Self {
        let [low, high] = interpretation.range(task.action);
        let is_collision = |event: &&Event| event.kind == EventKind::Push;
        let (verdict, reason) = verdict(task, interpretation, target_performance);
        Self {
            format: INTERPRETATION_FORMAT,
            schema: SCHEMA,
            task: task.name.clone(),
            action: task.action.to_string(),
            estimated: interpretation.performance.mean,
            estimated_low: low,
            estimated_high: high,
            target_performance,
            goal_met: verdict == "met",
            verdict,
            is_conclusive: interpretation.is_conclusive(),
            reason,
            detections: interpretation
                .observation
                .as_ref()
                .map(|observation| observation.detections.len()),
            replays: interpretation.belief.members().len(),
            contact_share: interpretation.contact_share,
            collisions: interpretation.events.iter().filter(is_collision).count(),
            plane_tilt_rad: interpretation.plane.map(|plane| plane.tilt),
            plane_offset_m: interpretation.plane.map(|plane| plane.offset),
            plane: interpretation.plane.as_ref().map(PlaneRecord::new),
            registration: (interpretation.registration.as_ref()).map(RegistrationRecord::new),
            contact_residuals: (interpretation.residuals.iter())
                .map(ContactResidualRecord::new)
                .collect(),
            doubts: (interpretation.doubts.iter())
                .map(ToString::to_string)
                .collect(),
            diagnosis: interpretation.diagnosis.as_str(),
            world_from_surface: match &interpretation.diagnosis {
                Diagnosis::Relocalize { world_from_surface } => Some(world_from_surface.into()),
                Diagnosis::Localized
                | Diagnosis::NoContact
                | Diagnosis::Unfitted
                | Diagnosis::Hovering => None,
            },
            // Avoid -0.0.
            force_bias_n: interpretation.force_bias.map(|bias| bias + 0.0),
            pressed_force_n: interpretation.pressed_force,
            tool_stiffness: interpretation
                .tool_stiffness
                .map(|stiffness| ToolStiffnessRecord {
                    n_per_m: stiffness.n_per_m,
                    ln_deviation: stiffness.ln_deviation,
                    assumed: stiffness.is_assumed,
                }),
            events: interpretation.events.iter().map(EventRecord::new).collect(),
            log,
        }
    }
}

impl PlaneRecord {
    fn new(plane: &FittedPlane) -> Self {
        Self {
            point_m: plane.point.coords.into(),
            normal: plane.normal.into(),
            tilt_directions: plane.directions,
            inliers: plane.inliers,
            confident: plane.confident,
            rms_m: plane.rms,
        }
    }
}

impl RegistrationRecord {
    fn new(fit: &ShapeFit) -> Self {
        Self {
            believed_from_real: (&fit.believed_from_real).into(),
            determined: fit.determined,
            inliers: fit.inliers,
            rms_m: fit.rms,
        }
    }
}

impl ContactResidualRecord {
    fn new(cell: &ContactResidual) -> Self {
        Self {
            x_m: rounded(cell.place.x, 1e3),
            y_m: rounded(cell.place.y, 1e3),
            height_m: rounded(cell.height, 1e6),
            contacts: cell.contacts,
        }
    }
}

/// Rounds a length to a number of steps per metre, without a negative zero.
fn rounded(length: f64, per_metre: f64) -> f64 {
    (length * per_metre).round() / per_metre + 0.0
}

impl EventRecord {
    fn new(event: &Event) -> Self {
        Self {
            kind: event.kind.as_str(),
            start_s: event.start,
            end_s: event.end,
            samples: event.samples,
            mean_normal_force_n: event.mean_normal_force,
            peak_force_n: event.peak_force,
            peak_height_m: event.peak_height,
        }
    }
}

/// Returns whether the target is reached, and the reason.
fn verdict(
    task: &wisch::represent::Task,
    interpretation: &Interpretation,
    target: f64,
) -> (&'static str, String) {
    let claim = Claim::assess(&interpretation.distribution, target).to_string();
    let assessed = assess_log(interpretation, target);
    match limit_verdict(assessed, task, interpretation, target) {
        Verdict::NothingToGain => {
            let certain = find_excess_passes(task, interpretation, target);
            let share = certain.map_or_else(
                || format!("more than {:.1} %", 100.0 * (1.0 - target)),
                |share| format!("{:.1} %", 100.0 * share),
            );
            let reason = format!(
                "{claim}; {share} of the points have more passes than polish.max_passes, and the target allows {:.1} %",
                100.0 * (1.0 - target)
            );
            ("not met", reason)
        }
        Verdict::GoalMet => ("met", claim),
        Verdict::Undecidable => {
            let decisive = (interpretation.doubts.iter())
                .filter(|doubt| doubt.is_decisive() || doubt.is_cut());
            let causes: Vec<String> = decisive.map(ToString::to_string).collect();
            let mut reason = if causes.is_empty() {
                claim
            } else {
                causes.join("; ")
            };
            if assessed == Verdict::GoalMet {
                reason += "; in this time the tool may have ";
                reason += match task.action {
                    wisch::represent::Action::Collect => "pushed dirt out of the goal",
                    wisch::represent::Action::Dispense => "coated points too thickly",
                    _ => "polished points too often",
                };
            }
            ("unknown", reason)
        }
        Verdict::UnknowableByTouch if assessed == Verdict::GoalMet => {
            let reason = format!(
                "{claim}; it is unknown whether more points have more passes than polish.max_passes than the target allows, {:.1} %",
                100.0 * (1.0 - target)
            );
            ("unknown", reason)
        }
        Verdict::UnknowableByTouch => ("unknown", claim),
        _ => ("not met", claim),
    }
}
