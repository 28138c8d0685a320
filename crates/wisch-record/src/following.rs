//! The motion of a run, and what is said of it.

use crate::words::percent;
use wisch::follow::{AbandonedNode, Audit, Followed, Workcell};
use wisch::plan::Plan;
use wisch::run::{PlannedRound, Round, Session};
use wisch_io::FollowingSummary;

/// A plan with the robot that followed it.
#[derive(Debug, Clone)]
pub struct Following {
    /// The robot's name.
    pub robot: String,
    /// Robot, tool and scene.
    pub cell: Workcell,
    /// The motion.
    pub followed: Followed,
    /// What an independent check says of it.
    pub audit: Audit,
    /// Share of the particles that abandoned nodes cost [1].
    pub abandoned_share: f64,
    /// How long finding and checking it took [s].
    pub time_s: f64,
    /// Of the motions of all rounds that were executed, or else of this one.
    pub total: MotionTotal,
}

/// Of the motions of all rounds together.
#[derive(Debug, Clone, Copy, Default)]
pub struct MotionTotal {
    /// How many there are.
    pub rounds: usize,
    /// How long they last, and how long of it the tool wipes [s].
    pub time: [f64; 2],
    /// How far the arm's joints move while the tool wipes, and in all [rad].
    pub joint_movement: [f64; 2],
    /// Way of the tool in contact, and in all [m].
    pub distance: [f64; 2],
    /// How far the tool leaves its line at most [m], [rad].
    pub off_line: [f64; 2],
    /// How near bodies that must not touch come at least [m].
    pub clearance: f64,
}

impl MotionTotal {
    /// Of rounds that were executed.
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
            let executed = round.executed();
            let duration = round.execution.duration;
            add(&mut total.time, [duration, executed.contact_time]);
            add(&mut total.joint_movement, executed.joint_movement);
            add(&mut total.distance, executed.distance);
            total.audited(&round.audit);
        }
        total
    }

    /// Of a motion that is not executed.
    fn of_motion(planned: &PlannedRound, audit: &Audit) -> Self {
        let PlannedRound { cell, followed, .. } = planned;
        let wiped = planned.wiped();
        let mut total = Self {
            rounds: 0,
            // The sum of nothing is -0.
            time: [followed.duration(), followed.contact_time() + 0.0],
            joint_movement: followed.joint_movement(cell.arm_variables()),
            distance: [wiped.contact_distance(), wiped.total_distance()],
            off_line: [0.0; 2],
            clearance: f64::INFINITY,
        };
        total.audited(audit);
        total
    }

    fn audited(&mut self, audit: &Audit) {
        self.off_line[0] = self.off_line[0].max(audit.line.position);
        self.off_line[1] = self.off_line[1].max(audit.line.rotation);
        self.clearance = self.clearance.min(audit.min_clearance);
    }

    /// What they are of, in words: nothing of a single motion.
    pub(crate) fn in_words(&self) -> String {
        match self.rounds {
            0 | 1 => String::new(),
            rounds => format!(" in {rounds} rounds"),
        }
    }
}

/// What was in the way of a node when it was last tried.
fn first_obstruction(abandoned: &AbandonedNode) -> String {
    let why = match abandoned.attempts.first() {
        Some(attempt) => attempt.obstruction.to_string(),
        None => "no place for the base leads there".to_owned(),
    };
    format!("node {}: {why}", abandoned.node)
}

impl Following {
    /// The first motion of a session; `None` if no robot followed a plan.
    pub fn of(session: &Session<'_>, time_s: f64) -> Option<Self> {
        let (planned, audit) = session.first()?;
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
            abandoned_share: planned.abandoned_share(),
            time_s,
        })
    }

    /// The plan as the robot wipes it.
    pub fn plan(&self, plan: &Plan) -> Plan {
        Plan {
            strokes: self.followed.strokes.clone(),
            ..plan.clone()
        }
    }

    /// The summary.
    pub fn summary(&self) -> FollowingSummary {
        let total = &self.total;
        let [in_contact, in_all] = total.joint_movement;
        FollowingSummary {
            joint_movement_in_contact_rad: in_contact,
            joint_movement_rad: in_all,
            robot: self.robot.clone(),
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
            first_obstruction: (self.followed.abandoned.first()).map(first_obstruction),
            following_time_s: self.time_s,
            max_path_deviation_m: total.off_line[0],
            max_turn_deviation_rad: total.off_line[1],
            min_clearance_m: total.clearance,
            faults: self.audit.faults.len(),
        }
    }

    /// What it keeps to, for people.
    pub(crate) fn facts(&self) -> Vec<(String, String)> {
        let followed = &self.followed;
        let total = &self.total;
        let [in_contact, in_all] = total.joint_movement;
        let rounds = total.in_words();
        let mut facts = vec![
            ("Robot", self.robot.clone()),
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
                format!("{in_contact:.1} rad in contact, {in_all:.1} rad in all{rounds}"),
            ),
            (
                "Off the line at most",
                format!(
                    "{:.2} mm, {:.2}°",
                    1e3 * total.off_line[0],
                    total.off_line[1].to_degrees()
                ),
            ),
            (
                "Clearance at least",
                format!("{:.1} mm", 1e3 * total.clearance),
            ),
        ];
        if self.cell.base().is_some() {
            facts.push((
                "Placements of the base",
                followed.placements.len().to_string(),
            ));
        }
        if self.cell.second().is_some() {
            let off = format!("{:.2} mm", 1e3 * self.audit.grip.position);
            facts.push(("Second hand off its grip at most", off));
        }
        if !self.audit.faults.is_empty() {
            facts.push((
                "Faults found by the check",
                self.audit.faults.len().to_string(),
            ));
        }
        (facts.into_iter())
            .map(|(label, value)| (label.to_owned(), value))
            .collect()
    }
}
