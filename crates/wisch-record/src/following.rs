//! The robot's motion in a run, with its summary and facts.

use crate::words::percent;
use std::sync::Arc;
use wisch::follow::{AbandonedNode, Audit, Followed, Workcell};
use wisch::plan::Plan;
use wisch::run::{PlannedRound, Round, Session};
use wisch_io::FollowingSummary;
use wisch_report::RunFact;

/// A plan with the robot that followed it.
#[derive(Debug, Clone)]
pub struct FollowedPlan {
    /// The robot's name.
    pub robot: String,
    /// Robot, tool and scene.
    pub cell: Arc<Workcell>,
    /// The motion.
    pub followed: Followed,
    /// Result of the independent check of the motion.
    pub audit: Audit,
    /// Share of the particles lost to abandoned nodes \[1\].
    pub abandoned_share: f64,
    /// Time for planning and checking the motion \[s\].
    pub time_s: f64,
    /// Round whose motion was not executed because of its faults, with its audit.
    pub refused: Option<(usize, Audit)>,
    /// Totals over all executed rounds, or of this motion if no round was executed.
    pub total: MotionTotal,
}

/// Facts about the motion of the first round; the others are about all rounds.
const OF_FIRST_ROUND: [&str; 4] = [
    "Abandoned nodes",
    "Base poses",
    "Maximum grip error of the second hand",
    "Faults of the motion",
];
/// Text about the missing check of a robot whose links have no collision shapes.
pub const NO_SHAPES: &str = "have no collision shapes: only the tool is checked for collisions, with its holder if it has one";

/// Describes the movement of joints in contact and in total: of revolute ones \[rad\], and of prismatic ones \[m\] if there are any.
pub fn joint_movement_in_words(turned: [f64; 2], slid: Option<[f64; 2]>) -> String {
    let turns = match (turned, slid) {
        ([_, all], Some(_)) if all <= 0.0 => None,
        ([contact, all], _) => Some(format!("{contact:.1} rad in contact, {all:.1} rad total")),
    };
    let slides = slid.map(|[contact, all]| format!("{contact:.2} m in contact, {all:.2} m total"));
    turns
        .into_iter()
        .chain(slides)
        .collect::<Vec<_>>()
        .join("; ")
}

/// Totals over the motions of several rounds.
#[derive(Debug, Clone, Copy, Default)]
pub struct MotionTotal {
    /// Number of rounds; 0 for a motion that is not executed.
    pub rounds: usize,
    /// Total duration, and duration of contact \[s\].
    pub time: [f64; 2],
    /// Movement of the arm's revolute joints in contact, and in total \[rad\].
    pub joint_movement: [f64; 2],
    /// Movement of the arm's prismatic joints in contact, and in total \[m\]; `None` for an arm without any.
    pub slide_movement: Option<[f64; 2]>,
    /// Path length of the tool in contact, and in total, as in [`wisch::run::ExecutedMotion`] \[m\].
    pub distance: [f64; 2],
    /// Maximum deviation of the tool from its path \[m\], \[rad\].
    pub off_line: [f64; 2],
    /// Minimum clearance between bodies that must not touch \[m\].
    pub clearance: f64,
}

impl MotionTotal {
    /// Sums up executed rounds.
    fn of_rounds(rounds: &[Round]) -> Self {
        let mut total = Self {
            rounds: rounds.len(),
            clearance: f64::INFINITY,
            ..Self::default()
        };
        let add = |sum: &mut [f64; 2], more: [f64; 2]| {
            sum[0] += more[0];
            sum[1] += more[1];
        };
        for round in rounds {
            let executed = round.executed_motion();
            let duration = round.execution.duration;
            add(&mut total.time, [duration, executed.contact_time]);
            add(&mut total.joint_movement, executed.joint_movement);
            if let Some(movement) = executed.slide_movement {
                add(total.slide_movement.get_or_insert_default(), movement);
            }
            add(&mut total.distance, executed.distance);
            total.add_audit(&round.audit);
        }
        total
    }

    /// Sums up a motion that is not executed.
    fn of_motion(planned: &PlannedRound, audit: &Audit) -> Self {
        let motion = planned.motion_until(f64::INFINITY);
        let mut total = Self {
            rounds: 0,
            time: [planned.followed.duration(), motion.contact_time],
            joint_movement: motion.joint_movement,
            slide_movement: motion.slide_movement,
            distance: motion.distance,
            off_line: [0.0; 2],
            clearance: f64::INFINITY,
        };
        total.add_audit(audit);
        total
    }

    /// Takes the extremes of these totals and a check.
    fn add_audit(&mut self, audit: &Audit) {
        self.off_line[0] = self.off_line[0].max(audit.line.position);
        self.off_line[1] = self.off_line[1].max(audit.line.rotation);
        self.clearance = self.clearance.min(audit.min_clearance);
    }

    /// Suffix for texts with the number of rounds; empty for a single motion.
    pub(crate) fn in_words(&self) -> String {
        match self.rounds {
            0 | 1 => String::new(),
            rounds => format!(" in {rounds} rounds"),
        }
    }
}

impl FollowedPlan {
    /// Returns the first motion of a session; `None` if no robot followed a plan.
    pub fn from_session(session: &Session<'_>, time_s: f64) -> Option<Self> {
        let (planned, audit) = session.first_motion()?;
        let total = match session.rounds() {
            [] => MotionTotal::of_motion(planned, audit),
            rounds => MotionTotal::of_rounds(rounds),
        };
        Some(Self {
            total,
            robot: planned.cell.robot().name().to_owned(),
            cell: planned.cell.clone(),
            followed: planned.followed.clone(),
            audit: audit.clone(),
            refused: session
                .refused_motion()
                .map(|(planned, audit)| (planned.number, audit.clone())),
            abandoned_share: planned.abandoned_share(),
            time_s,
        })
    }

    /// Whether any link of the robot has a collision shape.
    fn has_shapes(&self) -> bool {
        let mut links = self.cell.robot().links().iter();
        links.any(|link| !link.collision.is_empty())
    }

    /// Returns a plan without the nodes that the robot abandons.
    pub fn plan(&self, plan: &Plan) -> Plan {
        Plan {
            strokes: self.followed.strokes.clone(),
            ..plan.clone()
        }
    }

    /// Returns the summary of the motion for `--json`.
    pub fn summary(&self) -> FollowingSummary {
        let total = &self.total;
        let [in_contact, in_all] = total.joint_movement;
        let refused = self.refused.as_ref().map(|(_, audit)| audit);
        let faults = &refused.unwrap_or(&self.audit).faults;
        FollowingSummary {
            joint_movement_in_contact_rad: in_contact,
            joint_movement_rad: in_all,
            joint_movement_in_contact_m: total.slide_movement.map(|[in_contact, _]| in_contact),
            joint_movement_m: total.slide_movement.map(|[_, in_all]| in_all),
            has_shapes: self.has_shapes(),
            robot: self.robot.clone(),
            mount: self.cell.mount().to_string(),
            held_joints: self.cell.held_joints(),
            abandoned_nodes: self.followed.abandoned.len(),
            abandoned_share: self.abandoned_share,
            placements: (self.followed.placements.iter())
                .map(|placement| {
                    let at = placement.world_from_base;
                    [at.position.x, at.position.y, at.heading]
                })
                .collect(),
            execution_time_s: total.time[0],
            contact_time_s: total.time[1],
            first_obstruction: (self.followed.abandoned.first()).map(AbandonedNode::to_string),
            following_time_s: self.time_s,
            max_path_deviation_m: total.off_line[0],
            max_turn_deviation_rad: total.off_line[1],
            min_clearance_m: total.clearance,
            faults: faults.len(),
            first_fault: faults.first().map(ToString::to_string),
            refused_round: self.refused.as_ref().map(|(round, _)| *round),
        }
    }

    /// Returns the facts about the motion for the page.
    pub(crate) fn facts(&self) -> Vec<RunFact> {
        let followed = &self.followed;
        let total = &self.total;
        let [in_contact, in_all] = total.joint_movement;
        let rounds = total.in_words();
        let mut facts = vec![
            ("Robot", self.robot.clone()),
            ("Tool held", self.cell.mount().to_string()),
            (
                "Abandoned nodes",
                format!(
                    "{} ({} of the particles)",
                    followed.abandoned.len(),
                    percent(self.abandoned_share)
                ),
            ),
            ("Execution time", format!("{:.1} s{rounds}", total.time[0])),
            ("Time in contact", format!("{:.1} s{rounds}", total.time[1])),
            (
                "Joint movement",
                format!(
                    "{}{rounds}",
                    joint_movement_in_words([in_contact, in_all], total.slide_movement)
                ),
            ),
            (
                "Maximum path error",
                format!(
                    "{:.2} mm, {:.2}°",
                    1e3 * total.off_line[0],
                    total.off_line[1].to_degrees()
                ),
            ),
            (
                "Minimum clearance",
                format!("{:.1} mm", 1e3 * total.clearance),
            ),
        ];
        let held = self.cell.held_joints();
        if !held.is_empty() {
            facts.push(("Joints held at their ready positions", held.join(", ")));
        }
        if self.cell.base().is_some() {
            facts.push(("Base poses", followed.placements.len().to_string()));
        }
        if self.cell.second_arm().is_some() {
            let off = format!("{:.2} mm", 1e3 * self.audit.grip.position);
            facts.push(("Maximum grip error of the second hand", off));
        }
        if !self.has_shapes() {
            facts.push(("Links", NO_SHAPES.to_owned()));
        }
        if let Some((round, audit)) = &self.refused
            && let Some(first) = audit.faults.first()
        {
            let count = audit.faults.len();
            let found = format!("{count}, so it is not executed; the first: {first}");
            facts.push(match round {
                1 => ("Faults of the motion", found),
                _ => ("Faults of a motion", format!("in round {round}: {found}")),
            });
        }
        let of_first = |label: &str| OF_FIRST_ROUND.contains(&label).then_some(1);
        (facts.into_iter())
            .map(|(label, value)| (label.to_owned(), value, of_first(label)))
            .collect()
    }
}
