//! `interpretation.json`, and what `wisch interpret --json` prints: what a log says.

use super::plan::PoseRecord;
use serde::Serialize;
use wisch::interpret::{Diagnosis, Doubt, Event, EventKind, FittedPlane, Interpretation};
use wisch::recover::{Claim, Verdict, judge_log};

/// The format's name.
pub const INTERPRETATION_FORMAT: &str = "wisch-interpretation";
/// The schema of the record.
const SCHEMA: u32 = 1;

/// What a log says.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct InterpretationRecord {
    /// Always [`INTERPRETATION_FORMAT`].
    pub format: &'static str,
    /// The schema of this record.
    pub schema: u32,
    /// Name of the task.
    pub task: String,
    /// absorb, collect, skim, polish or emit.
    pub action: String,
    /// Share of the particles that are estimated to be where the action wants them, mean over the replays.
    pub estimated: f64,
    /// Its 5th percentile.
    pub estimated_low: f64,
    /// Its 95th percentile; 1 where the log begins or ends while the tool presses, as more may have been wiped.
    pub estimated_high: f64,
    /// Share from which on the goal is met.
    pub target_performance: f64,
    /// Whether the goal may be claimed: the mean reaches the target, and that less than ten points below it are reached is
    /// improbable (0.2 % at most).
    pub goal_met: bool,
    /// "met", "not met", or "cannot be told": the log does not say what was wiped, or touch alone cannot tell whether the
    /// target is reached. Where the log does not say it, the interval is that of not knowing.
    pub verdict: &'static str,
    /// Whether the log, or what was seen afterwards, says what was wiped.
    pub can_be_told: bool,
    /// The rule that decides, with its numbers, or why nothing can be told.
    pub reason: String,
    /// How many detections there were where dirt was looked for after the log; null where nothing looked.
    pub seen: Option<usize>,
    /// How many replays were made.
    pub replays: usize,
    /// Time in contact over the time that the tool was on or near the surface.
    pub contact_share: f64,
    /// How many collisions there were.
    pub collisions: usize,
    /// Angle between the plane that was touched and the believed surface; null where no plane was found.
    pub plane_tilt_rad: Option<f64>,
    /// Height of the plane that was touched over the middle of the believed surface; null as above.
    pub plane_offset_m: Option<f64>,
    /// More about that plane; null as above.
    pub plane: Option<PlaneRecord>,
    /// Why the log does not look like wiping of this surface, in words; none where it does.
    pub doubts: Vec<String>,
    /// localized, relocalize or no_contact.
    pub diagnosis: &'static str,
    /// Where the surface is, if it is not where it was believed; else null.
    pub world_from_surface: Option<PoseRecord>,
    /// What the sensor adds to the force on the tool along the surface's outward normal, which was taken off.
    pub force_bias_n: f64,
    /// Force with which the tool mostly pressed while it slid over one plane; null where no such plane was found.
    pub pressed_force_n: Option<f64>,
    /// What is believed of the tool's stiffness by now; null of a tool that does not give way.
    pub tool_stiffness: Option<ToolStiffnessRecord>,
    /// What happened, by start.
    pub events: Vec<EventRecord>,
    /// What was read.
    pub log: LogRecord,
}

/// The stiffness of a tool.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ToolStiffnessRecord {
    /// The most likely one.
    pub n_per_m: f64,
    /// Standard deviation of its logarithm.
    pub ln_deviation: f64,
}

/// The plane that was touched, in the frame of the believed surface.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlaneRecord {
    /// A point of it.
    pub point_m: [f64; 3],
    /// Its outward unit normal.
    pub normal: [f64; 3],
    /// In how many directions along the surface its tilt could be told: 2, 1 or 0.
    pub tilt_directions: usize,
    /// Confident positions on it.
    pub inliers: usize,
    /// Confident positions in all.
    pub confident: usize,
    /// Root mean square distance of the contacts that it was fitted to, weaker ones included.
    pub rms_m: f64,
}

/// Something that happened.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EventRecord {
    /// contact, contact_loss, collision (a person's push), hand_guiding, landing, overload, vibration or stick_slip;
    /// or a phase: approach, stroke, lift or retreat.
    pub kind: &'static str,
    /// From.
    pub start_s: f64,
    /// To.
    pub end_s: f64,
    /// How many samples show it.
    pub samples: usize,
    /// Mean normal force, negative where the tool presses.
    pub mean_normal_force_n: f64,
    /// Largest size of the force.
    pub peak_force_n: f64,
    /// Largest distance from the plane that was touched.
    pub peak_height_m: f64,
}

/// What was read of a log.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LogRecord {
    /// The file or folder.
    pub file: String,
    /// Where the poses come from.
    pub pose: String,
    /// Where the forces come from.
    pub wrench: String,
    /// In whose axes they are given.
    pub wrench_frame: &'static str,
    /// Whether nothing but habit says so.
    pub wrench_frame_assumed: bool,
    /// Poses with forces.
    pub samples: usize,
    /// From the first to the last.
    pub duration_s: f64,
    /// The log's time that the events' times count from.
    pub start_ns: i64,
    /// Poses or forces left out, as they bore the time of the one before.
    pub repeated: usize,
    /// Poses or forces left out, as the other was not known then.
    pub unpaired: usize,
    /// Whether the log ends where its writer was killed, or is still writing.
    pub unfinished: bool,
    /// Poses or forces left out, as they are none.
    pub skipped: usize,
    /// From when to when nothing was recorded for longer than is interpolated.
    pub gaps_s: Vec<[f64; 2]>,
    /// What is odd about the log, in words.
    pub remarks: Vec<String>,
}

impl InterpretationRecord {
    /// What is written of an interpretation.
    pub fn new(
        task: &wisch::represent::Task,
        interpretation: &Interpretation,
        target_performance: f64,
        log: LogRecord,
    ) -> Self {
        let performance = interpretation.performance;
        let is_collision = |event: &&Event| event.kind == EventKind::Collision;
        let is_cut =
            interpretation.observation.is_none() && interpretation.doubts.iter().any(Doubt::is_cut);
        let (verdict, reason) = verdict(interpretation, target_performance);
        Self {
            format: INTERPRETATION_FORMAT,
            schema: SCHEMA,
            task: task.name.clone(),
            action: task.action.to_string(),
            estimated: performance.mean,
            estimated_low: performance.low,
            estimated_high: if is_cut { 1.0 } else { performance.high },
            target_performance,
            goal_met: verdict == "met",
            verdict,
            can_be_told: interpretation.can_be_told(),
            reason,
            seen: interpretation
                .observation
                .as_ref()
                .map(|seen| seen.detections.len()),
            replays: interpretation.belief.replays().len(),
            contact_share: interpretation.contact_share,
            collisions: interpretation.events.iter().filter(is_collision).count(),
            plane_tilt_rad: interpretation.plane.map(|plane| plane.tilt),
            plane_offset_m: interpretation.plane.map(|plane| plane.offset),
            plane: interpretation.plane.as_ref().map(PlaneRecord::new),
            doubts: (interpretation.doubts.iter())
                .map(ToString::to_string)
                .collect(),
            diagnosis: diagnosis(&interpretation.diagnosis),
            world_from_surface: match &interpretation.diagnosis {
                Diagnosis::Relocalize { world_from_surface } => Some(world_from_surface.into()),
                Diagnosis::Localized | Diagnosis::NoContact | Diagnosis::Hovering => None,
            },
            // No bias is 0, not -0.
            force_bias_n: interpretation.force_bias + 0.0,
            pressed_force_n: interpretation.pressed_force,
            tool_stiffness: interpretation
                .tool_stiffness
                .map(|stiffness| ToolStiffnessRecord {
                    n_per_m: stiffness.n_per_m,
                    ln_deviation: stiffness.ln_deviation,
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

/// Whether the target is reached, and why.
fn verdict(interpretation: &Interpretation, target: f64) -> (&'static str, String) {
    let claim = Claim::of(&interpretation.distribution, target).to_string();
    match judge_log(interpretation, target) {
        Verdict::GoalMet => ("met", claim),
        Verdict::CannotBeTold => {
            let decisive = (interpretation.doubts.iter())
                .filter(|doubt| doubt.is_decisive() || doubt.is_cut());
            let causes: Vec<String> = decisive.map(ToString::to_string).collect();
            ("cannot be told", causes.join("; "))
        }
        Verdict::UnknowableByTouch => ("cannot be told", claim),
        _ => ("not met", claim),
    }
}

fn diagnosis(diagnosis: &Diagnosis) -> &'static str {
    match diagnosis {
        Diagnosis::Localized => "localized",
        Diagnosis::Relocalize { .. } => "relocalize",
        Diagnosis::NoContact => "no_contact",
        Diagnosis::Hovering => "hovering",
    }
}
