//! One stroke from touching down to lifting off, at one base pose.

use super::arm::Arm;
use super::edge::follow_edge;
use super::free_motion::free_motion;
use super::global::Leg;
use super::tool_redundancy::{ToolOrientation, rank, turn_pose};
use crate::follow::{AllowedContact, Attempt, Obstruction, Phase, SearchScope, ToolPose};
use crate::geometry::PlanarPose;
use crate::plan::Stroke;
use crate::robot::JointPositions;
use std::ops::RangeInclusive;

/// Starts for each orientation of the tool at the start of a stroke: the lifted tool moves on over the surface, or free motion
/// leads to a configuration near the current one or near the ready posture.
const NEAR_STARTS: RangeInclusive<u64> = 0..=2;
/// Further starts, anywhere.
const RANDOM_STARTS: RangeInclusive<u64> = 3..=8;
/// Number of orientations for random starts where the orientation does not matter.
const RANDOM_ORIENTATIONS: usize = 4;
/// Number of configurations that are checked for one without collision.
const FREE_TRIES: u64 = 4;
/// Rotation from the plan per node below which a stroke counts as planned [rad].
const TURNED: f64 = 0.2;

/// State of the arm between strokes.
#[derive(Debug, Clone, Copy)]
pub(in crate::follow) struct Now {
    pub q: JointPositions,
    /// Pose of the lifted tool above the surface; `None` away from it.
    pub tool: Option<ToolPose>,
}

/// A motion of the arm without times.
#[derive(Debug, Clone)]
pub(in crate::follow) struct UntimedMotion {
    pub phase: UntimedPhase,
    /// Configurations; the first is where the last piece ended.
    pub path: Vec<JointPositions>,
    /// Corners of the tool's line; empty in free motion.
    pub line: Vec<ToolPose>,
}

/// Purpose of a piece; strokes get their numbers once all are known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::follow) enum UntimedPhase {
    Plain(Phase),
    Wipe,
}

/// A corner of a stroke.
#[derive(Debug, Clone, Copy)]
pub(in crate::follow) struct Corner {
    /// Planned pose of the tool.
    pub pose: PlanarPose,
    /// A known configuration of the arm at this corner from which the stroke continues well.
    pub near: Option<JointPositions>,
}

/// The result of following a stroke.
#[derive(Debug, Clone)]
pub(in crate::follow) struct Run {
    pub pieces: Vec<UntimedMotion>,
    /// Index of the last given node that was reached.
    pub last: usize,
    /// Poses of the tool at every corner of the wiped line.
    pub wiped: Vec<ToolPose>,
    /// Rotation of the tool from its planned orientation, summed over the nodes [rad].
    pub turned: f64,
    /// State of the arm after the stroke, lifted.
    pub now: Now,
    /// Why the stroke did not continue; empty if it is complete.
    pub stopped: Vec<Attempt>,
}

impl Run {
    /// Returns the executed stroke through these nodes of the graph.
    pub fn stroke(&self, nodes: &[usize]) -> Stroke {
        Stroke {
            nodes: nodes.to_vec(),
            poses: self
                .wiped
                .iter()
                .map(|pose| pose.surface_from_tool)
                .collect(),
        }
    }
}

/// The part of a stroke in contact.
struct Contact {
    legs: Vec<Leg>,
    end: JointPositions,
    end_pose: ToolPose,
    stopped: Vec<Attempt>,
}

/// Follows the longest possible part of a stroke through its `planned` corners, from any of several configurations.
///
/// The known configuration at the first corner is tried before all others. The tool first keeps the planned
/// orientation exactly; only if no configuration can do that, all its orientations are tried, and only then random
/// configurations.
///
/// # Errors
/// The failed attempts, if the tool cannot even touch down at the first corner.
pub(in crate::follow) fn run(
    arm: &Arm,
    now: &Now,
    planned: &[Corner],
    lift_height: f64,
    orientations: &[ToolOrientation],
    seed: u64,
) -> Result<Run, Vec<Attempt>> {
    let symmetric = arm.task.tool.is_half_turn_symmetric();
    let exact: Vec<ToolOrientation> = (orientations.iter().copied())
        .filter(|orientation| rank(orientation, symmetric) == 0.0)
        .collect();
    let mut search = Search {
        arm,
        now,
        planned,
        lift_height,
        seed,
        attempts: Vec::new(),
        best: None,
    };
    let stride = orientations.len().div_ceil(RANDOM_ORIENTATIONS).max(1);
    let few: Vec<ToolOrientation> = orientations.iter().copied().step_by(stride).collect();
    // If the orientation does not matter, it need not be kept.
    let of_random = if arm.keeps_heading { &exact } else { &few };
    let is_whole = arm.keeps_heading && search.try_any(&exact, NEAR_STARTS)
        || search.try_any(orientations, NEAR_STARTS)
        || search.try_any(of_random, RANDOM_STARTS);
    if !is_whole && arm.config.search == SearchScope::Global {
        search.repeat_globally(orientations);
    }
    search.best.map(|(run, ..)| run).ok_or(search.attempts)
}

/// The search for a good run of one stroke.
struct Search<'a> {
    arm: &'a Arm<'a>,
    now: &'a Now,
    planned: &'a [Corner],
    lift_height: f64,
    seed: u64,
    attempts: Vec<Attempt>,
    /// The best run so far, with its orientation and start.
    best: Option<(Run, ToolOrientation, u64)>,
}

impl Search<'_> {
    /// Tries configurations until a run completes the stroke about as planned; returns whether one does.
    ///
    /// The lifted tool first moves on over the surface; then configurations reached by free motion are tried.
    fn try_any(&mut self, orientations: &[ToolOrientation], starts: RangeInclusive<u64>) -> bool {
        let mut tried = 0;
        for start in starts {
            if start == 0 && self.now.tool.is_none() {
                continue;
            }
            for orientation in orientations {
                if tried == self.arm.config.start_configurations {
                    return self.is_whole();
                }
                let Some(is_new_best) =
                    self.try_one(orientation, start, orientations, SearchScope::Local)
                else {
                    continue;
                };
                tried += 1;
                if is_new_best && self.is_as_planned() {
                    return true;
                }
            }
        }
        self.is_whole()
    }

    /// Repeats the best run, with the global search where it stopped.
    fn repeat_globally(&mut self, orientations: &[ToolOrientation]) {
        if let Some((_, orientation, start)) = self.best {
            self.try_one(&orientation, start, orientations, SearchScope::Global);
        }
    }

    fn is_whole(&self) -> bool {
        (self.best.as_ref()).is_some_and(|(run, ..)| run.last + 1 == self.planned.len())
    }

    fn is_as_planned(&self) -> bool {
        let most = TURNED * self.planned.len() as f64;
        self.is_whole() && (self.best.as_ref()).is_some_and(|(run, ..)| run.turned <= most)
    }

    /// Whether a contact is longer than the best run, or as long with less rotation from the plan.
    fn is_better(&self, contact: &Contact, touch_down: &TouchDown) -> bool {
        let (length, turned) = (contact.legs.len(), contact.turned(touch_down, self.arm));
        self.best.as_ref().is_none_or(|(best, ..)| {
            length > best.last || length == best.last && turned < best.turned
        })
    }

    /// Puts the tool down at the first pose, in an orientation.
    fn begin(&self, orientation: &ToolOrientation, start: u64) -> Result<TouchDown, Attempt> {
        let (
            arm,
            now,
            Corner {
                pose: planned,
                near,
            },
        ) = (self.arm, self.now, &self.planned[0]);
        let (known, lift_height, seed) = (near.as_ref(), self.lift_height, self.seed);
        let heading = now
            .tool
            .map_or(planned.heading, |tool| tool.surface_from_tool.heading);
        let pose = turn_pose(planned, orientation, heading);
        let lifted = pose.with_height(lift_height);
        let failed = |progress: f64, obstruction| Attempt {
            rotation: orientation.rotation,
            tilt: orientation.tilt,
            progress,
            obstruction,
        };
        let (over, above) = match (start, now.tool) {
            (0, Some(tool)) => {
                let path = arm
                    .follow_line(&now.q, &tool, &lifted, None, AllowedContact::None)
                    .map_err(|broken| failed(broken.progress, broken.obstruction))?;
                let above = *path.last().unwrap_or(&now.q);
                (Some(path), above)
            }
            _ => {
                let ready = arm.ready_posture();
                let near: Vec<&[f64]> = (known.into_iter().chain([&now.q, &ready]))
                    .map(|q| &q[..])
                    .collect();
                // The first start searches near the current configuration, the second near the ready posture, the
                // others anywhere: from one posture, a search always ends in the same branch.
                let mut found = match start {
                    1 => arm.reach_free(&lifted, &near, seed ^ start),
                    2 => arm.reach_free(&lifted, &[], seed ^ start),
                    _ => reach_from_random(arm, &lifted, seed ^ start),
                };
                for i in 1..FREE_TRIES {
                    if !matches!(
                        found,
                        Err(Obstruction::SelfCollision { .. }
                            | Obstruction::SceneCollision { .. }
                            | Obstruction::SecondHand { .. })
                    ) {
                        break;
                    }
                    found = reach_from_random(arm, &lifted, seed ^ start ^ (i << 16));
                }
                (None, found.map_err(|obstruction| failed(0.0, obstruction))?)
            }
        };
        let down = arm
            .follow_line(&above, &lifted, &pose, None, AllowedContact::Surface)
            .map_err(|broken| failed(broken.progress, broken.obstruction))?;
        Ok(TouchDown {
            over,
            above,
            down,
            pose,
            orientation: *orientation,
        })
    }

    /// Tries one configuration; returns whether it gives the best run so far, or an error if the tool cannot
    /// touch down.
    fn try_one(
        &mut self,
        orientation: &ToolOrientation,
        start: u64,
        orientations: &[ToolOrientation],
        search: SearchScope,
    ) -> Option<bool> {
        let (arm, now, planned) = (self.arm, self.now, self.planned);
        let touch_down = match self.begin(orientation, start) {
            Ok(touch_down) => touch_down,
            Err(attempt) => {
                self.attempts.push(attempt);
                return None;
            }
        };
        let contact = wipe(arm, &touch_down, planned, orientations, search);
        if !self.is_better(&contact, &touch_down) {
            return Some(false);
        }
        let (contact, up) = lift_off(arm, &touch_down, contact, self.lift_height);
        if !self.is_better(&contact, &touch_down) {
            return Some(false);
        }
        match finish(
            arm,
            now,
            touch_down,
            contact,
            up,
            self.lift_height,
            self.seed,
        ) {
            Ok(run) => {
                self.best = Some((run, *orientation, start));
                Some(true)
            }
            Err(attempt) => {
                self.attempts.push(attempt);
                Some(false)
            }
        }
    }
}

/// Finds a configuration without collision from random ones.
fn reach_from_random(arm: &Arm, pose: &ToolPose, seed: u64) -> Result<JointPositions, Obstruction> {
    let start = arm.random_start(seed);
    arm.reach_free(pose, &[&start], seed)
}

/// The tool put down at the start of a stroke.
struct TouchDown {
    /// Path over the surface and down; the first is `None` if free motion has to reach it.
    over: Option<Vec<JointPositions>>,
    above: JointPositions,
    down: Vec<JointPositions>,
    pose: ToolPose,
    orientation: ToolOrientation,
}

impl TouchDown {
    fn start(&self) -> JointPositions {
        *self.down.last().unwrap_or(&self.above)
    }
}

impl Contact {
    /// Returns the rotation of the tool from the plan, summed over the nodes [rad]; 0 where it does not matter.
    fn turned(&self, touch_down: &TouchDown, arm: &Arm) -> f64 {
        if !arm.keeps_heading {
            return 0.0;
        }
        let symmetric = arm.task.tool.is_half_turn_symmetric();
        let legs = self.legs.iter().map(|leg| leg.turned);
        rank(&touch_down.orientation, symmetric) + legs.sum::<f64>()
    }
}

/// Follows the stroke in contact from the touch-down as far as possible.
fn wipe(
    arm: &Arm,
    touch_down: &TouchDown,
    planned: &[Corner],
    orientations: &[ToolOrientation],
    search: SearchScope,
) -> Contact {
    let mut contact = Contact {
        legs: Vec::new(),
        end: touch_down.start(),
        end_pose: touch_down.pose,
        stopped: Vec::new(),
    };
    for edge in planned.windows(2) {
        let (begin, goal) = (&edge[0], &edge[1]);
        match follow_edge(
            arm,
            &contact.end,
            &contact.end_pose,
            [&begin.pose, &goal.pose],
            goal.near.as_ref(),
            orientations,
            search,
        ) {
            Ok(leg) => {
                contact.end = *leg.configurations.last().unwrap_or(&contact.end);
                contact.end_pose = *leg.line.last().unwrap_or(&contact.end_pose);
                contact.legs.push(leg);
            }
            Err(attempts) => {
                contact.stopped = attempts;
                break;
            }
        }
    }
    contact
}

/// Lifts the tool at the end of a stroke. If that fails, the tool is lifted at the last earlier
/// node at which that is possible, and the rest continues in another configuration. At the first
/// node, the tool goes up the way that it came down.
fn lift_off(
    arm: &Arm,
    touch_down: &TouchDown,
    mut contact: Contact,
    lift_height: f64,
) -> (Contact, Vec<JointPositions>) {
    let mut stuck = Vec::new();
    while !contact.legs.is_empty() {
        let lifted = contact.end_pose.with_height(lift_height);
        let (end, pose) = (&contact.end, &contact.end_pose);
        match arm.follow_line(end, pose, &lifted, None, AllowedContact::Surface) {
            Ok(up) => {
                contact.stopped.extend(stuck);
                return (contact, up);
            }
            Err(broken) => stuck.push(Attempt {
                rotation: touch_down.orientation.rotation,
                tilt: touch_down.orientation.tilt,
                progress: 1.0,
                obstruction: broken.obstruction,
            }),
        }
        contact.legs.pop();
        let last = contact.legs.last();
        let end = last.and_then(|leg| leg.configurations.last());
        contact.end = end.copied().unwrap_or_else(|| touch_down.start());
        let pose = last.and_then(|leg| leg.line.last());
        contact.end_pose = pose.copied().unwrap_or(touch_down.pose);
    }
    contact.stopped.extend(stuck);
    let down = touch_down.down.iter().rev().skip(1);
    let up = down.chain([&touch_down.above]).copied().collect();
    (contact, up)
}

/// Finds the path to where the tool touches down, and assembles all pieces.
fn finish(
    arm: &Arm,
    now: &Now,
    mut touch_down: TouchDown,
    mut contact: Contact,
    mut up: Vec<JointPositions>,
    lift_height: f64,
    seed: u64,
) -> Result<Run, Attempt> {
    if touch_down.over.is_none() {
        let run: Vec<&JointPositions> = std::iter::once(&touch_down.above)
            .chain(&touch_down.down)
            .chain(contact.legs.iter().flat_map(|leg| &leg.configurations))
            .chain(&up)
            .collect();
        let turns = arm.shortest_turns(&now.q, &run);
        let legs = (contact.legs.iter_mut()).flat_map(|leg| &mut leg.configurations);
        std::iter::once(&mut touch_down.above)
            .chain(&mut touch_down.down)
            .chain(legs)
            .chain([&mut contact.end])
            .chain(&mut up)
            .for_each(|q| {
                q.iter_mut()
                    .zip(turns.iter())
                    .for_each(|(q, turn)| *q += turn)
            });
    }
    let failed = |obstruction| Attempt {
        rotation: touch_down.orientation.rotation,
        tilt: touch_down.orientation.tilt,
        progress: 1.0,
        obstruction,
    };
    let lifted = contact.end_pose.with_height(lift_height);
    let above_start = touch_down.pose.with_height(lift_height);
    let mut pieces = Vec::new();
    match (&touch_down.over, now.tool) {
        (Some(path), Some(tool)) => pieces.push(UntimedMotion {
            phase: UntimedPhase::Plain(Phase::Lifted),
            path: with_start(now.q, path),
            line: vec![tool, above_start],
        }),
        _ => {
            let path = free_motion(arm, &now.q, &touch_down.above, seed).ok_or_else(|| {
                let blocked = arm.free_path(&now.q, &touch_down.above, AllowedContact::None);
                failed(blocked.err().unwrap_or(Obstruction::OutOfReach {
                    position_error: 0.0,
                    rotation_error: 0.0,
                }))
            })?;
            pieces.push(UntimedMotion {
                phase: UntimedPhase::Plain(Phase::FreeMotion),
                path,
                line: Vec::new(),
            });
        }
    }
    let start = touch_down.start();
    pieces.push(UntimedMotion {
        phase: UntimedPhase::Plain(Phase::Lower),
        path: with_start(touch_down.above, &touch_down.down),
        line: vec![above_start, touch_down.pose],
    });
    let last = contact.legs.len();
    let turned = contact.turned(&touch_down, arm);
    let mut wiped = vec![touch_down.pose];
    let mut path = vec![start];
    for leg in contact.legs {
        wiped.extend(leg.line);
        path.extend(leg.configurations);
    }
    pieces.push(UntimedMotion {
        phase: UntimedPhase::Wipe,
        path,
        line: wiped.clone(),
    });
    let end = *up.last().unwrap_or(&contact.end);
    pieces.push(UntimedMotion {
        phase: UntimedPhase::Plain(Phase::Lift),
        path: with_start(contact.end, &up),
        line: vec![contact.end_pose, lifted],
    });
    Ok(Run {
        pieces,
        last,
        wiped,
        turned,
        now: Now {
            q: end,
            tool: Some(lifted),
        },
        stopped: contact.stopped,
    })
}

fn with_start(start: JointPositions, path: &[JointPositions]) -> Vec<JointPositions> {
    let mut whole = vec![start];
    whole.extend_from_slice(path);
    whole
}
