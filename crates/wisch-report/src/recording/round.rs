//! The piece of a planned round, or of a plan that is not executed.

use super::considered::ConsideredRecord;
use super::logged::{self, Log, LoggedRound};
use super::particles::{Moment, ParticleStep, line, steps};
use super::phases::{PhaseRecord, phases};
use super::reasons::{Reasons, find_lost_share};
use super::samples::{NOMINAL_SPEED, round_share, round_to, seconds_at};
use super::surface::SurfaceRecord;
use super::treated::{TreatedPlaces, TreatmentRecord};
use super::{UnexecutedPlan, words};
use crate::prediction::frames::EffectFrames;
use crate::scene::{MeshRecord, Meshes, Solid, to_seven_numbers};
use serde::Serialize;
use wisch::follow::Followed;
use wisch::plan::{Plan, Prediction, Strategy};
use wisch::represent::{GoalState, ScenePart, Task};
use wisch::run::PlannedRound;

#[derive(Serialize)]
pub(super) struct RoundPiece {
    piece: &'static str,
    round: usize,
    kind: &'static str,
    duration: f64,
    root: Option<[f64; 7]>,
    surface: SurfaceRecord,
    scene: Vec<ObjectRecord>,
    meshes: Vec<MeshRecord>,
    goal: Option<GoalRecord>,
    strokes: Vec<Vec<i64>>,
    phases: Vec<PhaseRecord>,
    /// Planned normal force of an executed round [N].
    #[serde(skip_serializing_if = "Option::is_none")]
    press_force: Option<f64>,
    predicted: Option<f64>,
    /// Predicted share of lost dirt [1].
    #[serde(skip_serializing_if = "Option::is_none")]
    lost: Option<f64>,
    growth: Vec<[f64; 2]>,
    particles: Vec<ParticleStep>,
    #[serde(skip_serializing_if = "Option::is_none")]
    treatment: Option<TreatmentRecord>,
    why: Vec<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    considered: Vec<ConsideredRecord>,
    #[serde(flatten)]
    reasons: Reasons,
    #[serde(flatten)]
    log: Option<Log>,
}

#[derive(Serialize)]
struct ObjectRecord {
    part: &'static str,
    #[serde(flatten)]
    solid: Solid,
}

/// A goal, with its area if the dirt is collected.
#[derive(Serialize)]
struct GoalRecord {
    kind: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    place: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    radius: Option<f64>,
}

impl RoundPiece {
    /// Makes the piece of a round before its execution.
    pub(super) fn executed(
        planned: &PlannedRound,
        frames: Option<&EffectFrames>,
        audited: Option<String>,
        meshes: &mut Meshes,
        written: usize,
    ) -> Self {
        let wiped = planned.executable_plan();
        let unwatched;
        let frames = match frames {
            Some(frames) => frames,
            None => {
                unwatched = EffectFrames::new(&planned.task, &wiped);
                &unwatched
            }
        };
        let followed = Some(&planned.followed);
        let mut why = words::explain_plan(&planned.plan, &wiped, followed);
        why.extend(audited);
        Shown {
            round: planned.number,
            kind: "executed",
            root: Some(to_seven_numbers(planned.cell.world_from_root())),
            task: &planned.task,
            plan: &planned.plan,
            wiped: &wiped,
            followed,
            frames,
            predicted: &planned.prediction,
            why,
        }
        .piece(meshes, written)
    }

    /// Makes the piece of a plan that is not executed.
    pub(super) fn planned(
        planned: &UnexecutedPlan<'_>,
        audited: Option<String>,
        meshes: &mut Meshes,
        written: usize,
    ) -> Self {
        let followed = planned.followed.map(|(_, followed, _)| followed);
        let mut why = words::explain_plan(planned.plan, planned.plan, followed);
        why.extend(audited);
        Shown {
            round: 1,
            kind: "planned",
            root: (planned.followed).map(|(cell, ..)| to_seven_numbers(cell.world_from_root())),
            task: planned.task,
            plan: planned.plan,
            wiped: planned.plan,
            followed,
            frames: planned.frames,
            predicted: planned.prediction,
            why,
        }
        .piece(meshes, written)
    }

    /// Makes the piece of a round of which only a log is known.
    pub(super) fn logged(round: &LoggedRound<'_>, meshes: &mut Meshes, written: usize) -> Self {
        let scene = round
            .task
            .map_or_else(Vec::new, |task| list_objects(task, meshes));
        let (phases, log) = logged::lanes(&round.occurrences);
        Self {
            piece: "round",
            round: round.number,
            kind: "logged",
            duration: round_to(round.duration, 1e3),
            root: round.world_from_root.as_ref().map(to_seven_numbers),
            surface: SurfaceRecord::new(&round.surface()),
            scene,
            meshes: meshes.since(written),
            goal: None,
            strokes: Vec::new(),
            phases,
            press_force: None,
            predicted: None,
            lost: None,
            growth: Vec::new(),
            particles: Vec::new(),
            treatment: None,
            why: Vec::new(),
            considered: Vec::new(),
            reasons: Reasons::default(),
            log: Some(log),
        }
    }

    /// Adds the candidates, and marks the one with the strategy of the plan.
    pub(super) fn with_candidates(
        mut self,
        considered: Vec<ConsideredRecord>,
        chosen: Strategy,
    ) -> Self {
        self.considered = considered;
        for one in &mut self.considered {
            one.chosen = one.strategy == chosen.as_str();
            if one.chosen {
                one.lines.clear();
            }
        }
        self
    }
}

/// The inputs of a piece.
struct Shown<'a> {
    round: usize,
    kind: &'static str,
    root: Option<[f64; 7]>,
    task: &'a Task,
    plan: &'a Plan,
    wiped: &'a Plan,
    followed: Option<&'a Followed>,
    frames: &'a EffectFrames,
    predicted: &'a Prediction,
    why: Vec<String>,
}

impl Shown<'_> {
    fn piece(self, meshes: &mut Meshes, written: usize) -> RoundPiece {
        let Self {
            task,
            wiped,
            followed,
            frames,
            ..
        } = self;
        let scene = list_objects(task, meshes);
        let mut since = 0.0;
        let moments: Vec<(f64, usize)> = (frames.frames().iter().enumerate())
            .map(|(i, frame)| {
                since = seconds_at(followed, frame.stroke, frame.distance)
                    .unwrap_or(since)
                    .max(since);
                (since, i)
            })
            .collect();
        let treated = TreatedPlaces::new(task);
        let of_frame = |&(time, i): &(f64, usize)| Moment {
            time,
            places: (frames.frames()[i].particles.iter())
                .filter(|(_, fate)| fate.is_on_surface())
                .map(|(place, _)| *place)
                .collect(),
        };
        let growth = moments.iter().map(|&(time, i)| {
            [
                round_to(time, 1e3),
                round_to(frames.frames()[i].performance.ratio(), 1e4),
            ]
        });
        let duration = match followed {
            Some(followed) => followed.duration(),
            None => wiped.contact_distance() / NOMINAL_SPEED,
        };
        RoundPiece {
            piece: "round",
            round: self.round,
            kind: self.kind,
            duration: round_to(duration, 1e3),
            root: self.root,
            surface: SurfaceRecord::new(&task.surface),
            scene,
            goal: Some(GoalRecord::new(&wiped.graph.goal)),
            strokes: (wiped.strokes.iter())
                .map(|stroke| line(stroke.poses.iter().map(|pose| &pose.position)))
                .collect(),
            phases: followed.map_or_else(Vec::new, phases),
            press_force: (self.kind == "executed")
                .then(|| round_to(task.interaction.press_force_n, 1e3)),
            predicted: Some(round_share(self.predicted.performance.ratio())),
            lost: Some(find_lost_share(&self.predicted.performance)),
            growth: growth.collect(),
            // The places of a treated surface rest: their values change.
            particles: match treated {
                Some(_) => Vec::new(),
                None => steps(&moments.iter().map(of_frame).collect::<Vec<_>>()),
            },
            treatment: treated.map(|places| {
                let timed = (moments.iter()).map(|&(time, i)| (time, &frames.frames()[i]));
                places.record(task, timed)
            }),
            why: self.why,
            considered: Vec::new(),
            reasons: Reasons::new(task, self.plan, wiped, followed, self.predicted),
            log: None,
            meshes: meshes.since(written),
        }
    }
}

/// Returns the scene of a task around robot and tool.
fn list_objects(task: &Task, meshes: &mut Meshes) -> Vec<ObjectRecord> {
    let objects = task.scene.iter().filter_map(|object| {
        let part = match object.part {
            ScenePart::Obstacle => "obstacle",
            ScenePart::Carrier => "carrier",
            ScenePart::Robot | ScenePart::Tool => return None,
        };
        let solid = meshes.solid(&object.world_from_object, &object.mesh);
        Some(ObjectRecord { part, solid })
    });
    objects.collect()
}

impl GoalRecord {
    fn new(goal: &GoalState) -> Self {
        let area = match goal {
            GoalState::Collected { center, radius } => Some((center, radius)),
            _ => None,
        };
        Self {
            kind: goal.as_str(),
            place: area.map(|(center, _)| [center.x, center.y].map(|x| round_to(x, 1e4))),
            radius: area.map(|(_, radius)| round_to(*radius, 1e4)),
        }
    }
}
