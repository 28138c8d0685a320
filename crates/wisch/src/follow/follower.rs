//! The follower: from a plan to base poses, joint paths and times.

use super::path::arm::Arm;
use super::path::free_motion::free_motion;
use super::path::free_yaw::{configurations_with_free_yaw, poses_with_yaws};
use super::path::joint_tour::joint_tour;
use super::path::joint_travel::movement;
use super::path::stroke_run::{Corner, Now, Run, UntimedMotion, UntimedPhase, run};
use super::path::tool_redundancy::{ToolOrientation, orientations};
use super::pending_stroke::{
    PendingNode, PendingStroke, abandon_next, count_pending, split_by_touch,
};
use super::placement::{Candidate, Reachability, best, drive::drive};
use super::workcell::HandBelow;
use super::{
    AbandonedNode, Attempt, FollowConfig, FollowError, Followed, Motion, Phase, Placement,
    RatedBasePose, ToolPose, Workcell, schedule,
};
use crate::geometry::{PlanarPose, Point2};
use crate::plan::{Plan, predict, rejoin_nodes};
use crate::represent::{Action, Task};
use crate::robot::{CapabilityMap, JointPositions};
use rayon::prelude::*;
use std::cmp::Ordering;

/// Number of searches for a path back to the ready posture.
const RETURN_SEARCHES: u64 = 3;

/// Share of the planned effect above which no further base pose is tried [1].
const ENOUGH: f64 = 0.95;

/// Number of base poses that are tried in parallel; a constant, so that the result is the same for any number
/// of threads.
const AT_ONCE: usize = 2;

/// A base visit: the motions of the arm at one base pose.
struct BaseVisit {
    world_from_base: PlanarPose,
    runs: Vec<(Vec<usize>, Run)>,
    /// Path from the last stroke back to the ready posture.
    back: Vec<JointPositions>,
    open: Vec<PendingStroke>,
    /// Failed attempts, for which the visit did not follow more of the plan.
    stopped: Vec<Attempt>,
}

impl BaseVisit {
    /// Length of the joint path [rad].
    fn movement(&self) -> f64 {
        let runs = self.runs.iter().flat_map(|(_, run)| &run.pieces);
        let paths = runs.map(|piece| &piece.path).chain([&self.back]);
        paths.map(|path| movement(path)).sum()
    }
}

/// The drive to a base pose, the placement, and the visit.
type ReachedVisit = (Vec<PlanarPose>, Placement, BaseVisit);

/// The pending strokes after their nodes were rejoined, and the nodes that they no longer contain.
type Rejoined = (Vec<PendingStroke>, Vec<AbandonedNode>);

/// Predicted result of a base visit.
struct Outcome {
    /// Number of pending nodes.
    left: usize,
    /// Number of particles that meet the goal.
    achieved: usize,
}

/// Follows a plan with a robot. The base is placed so that much of the path is in reach, each stroke is
/// followed by Algorithm 1 of paper §3.3, and all motions are timed within the limits of the joints.
///
/// `map` rates base poses; without a map, each is rated by inverse kinematics, which is slower and coarser. A
/// robot with a fixed base needs no map. `progress` is called with the number of nodes followed so far.
///
/// A node that cannot be reached is abandoned and reported with the attempts to reach it; this is
/// no error. The same arguments give the same result, bit by bit, for any number of threads.
///
/// # Errors
/// [`FollowError::Config`] for a setting out of range, [`FollowError::StartBlocked`] for a
/// collision in the ready posture, [`FollowError::Timing`] for a path that cannot be timed, or
/// another [`FollowError`].
pub fn follow(
    task: &Task,
    plan: &Plan,
    cell: &Workcell,
    map: Option<&CapabilityMap>,
    config: &FollowConfig,
    progress: &mut dyn FnMut(usize),
) -> Result<Followed, FollowError> {
    config.check()?;
    check_touch(task, plan, cell)?;
    check_start(cell, config)?;
    check_lift(task, plan, config)?;
    let follower = Follower {
        task,
        plan,
        cell,
        config,
        map,
        orientations: orientations(&task.tool, config.orientation_increment),
        planned: predict(task, plan, |_| ()).performance.achieved,
    };
    follower.follow(progress)
}

/// Checks that the robot's ready posture is within its limits and free of collision.
fn check_start(cell: &Workcell, config: &FollowConfig) -> Result<(), FollowError> {
    if let Some(fault) = cell
        .robot()
        .limit_faults(cell.ready_posture())?
        .into_iter()
        .next()
    {
        return Err(FollowError::StartOutOfLimits(fault));
    }
    let model = cell.collisions();
    match model.collision(cell.ready_posture(), config.margin)? {
        None => Ok(()),
        Some(contact) => Err(FollowError::StartBlocked {
            a: model.name(contact.a).to_owned(),
            b: model.name(contact.b).to_owned(),
            distance: contact.distance,
            limit: config.margin,
        }),
    }
}

/// Checks that the lifted tool is as far from the surface as from other obstacles. A lift begins where the tool is pressed
/// into the surface.
fn check_lift(task: &Task, plan: &Plan, config: &FollowConfig) -> Result<(), FollowError> {
    let depth = task.interaction.compression_depth_m;
    let (low, _) = super::workcell::relax(&task.tool.mesh, depth)?.bounds();
    let pressed = (-low.z).max(0.0);
    let (lift, least) = (plan.lift_height, pressed + config.margin);
    if plan.strokes.is_empty() || task.interaction.hovers() || lift > least {
        return Ok(());
    }
    Err(FollowError::LowLift {
        lift,
        pressed,
        margin: config.margin,
    })
}

/// Checks that the hand is clear of the surface at some node where the tool touches it.
fn check_touch(task: &Task, plan: &Plan, cell: &Workcell) -> Result<(), FollowError> {
    match cell.hand_below(task, plan)? {
        None => Ok(()),
        Some(HandBelow { link, depth }) => Err(FollowError::HandBelowSurface {
            link,
            depth,
            surface: task.surface.name.clone(),
            tool: task.tool.name.clone(),
            tip: cell.robot().links()[cell.tip().index()].name.clone(),
        }),
    }
}

struct Follower<'a> {
    task: &'a Task,
    plan: &'a Plan,
    cell: &'a Workcell,
    config: &'a FollowConfig,
    map: Option<&'a CapabilityMap>,
    orientations: Vec<ToolOrientation>,
    /// Number of particles that meet the goal if the plan is followed exactly.
    planned: usize,
}

impl Follower<'_> {
    fn follow(&self, progress: &mut dyn FnMut(usize)) -> Result<Followed, FollowError> {
        let mut open: Vec<PendingStroke> = self.pending_strokes();
        let all = count_pending(&open);
        let mut at = self.cell.base_pose(self.cell.ready_posture());
        let mut visits: Vec<ReachedVisit> = Vec::new();
        let mut abandoned: Vec<AbandonedNode> = Vec::new();
        let mut rated: Vec<RatedBasePose> = Vec::new();
        while !open.is_empty() {
            let candidates = self.candidates(&open)?;
            if rated.is_empty() {
                rated = self.rated_places(&candidates);
            }
            let places = best_or_here(self.cell, &candidates, &at, self.config);
            let (chosen, stopped) = self.best_visit(&places, &at, &open, &visits)?;
            match chosen {
                Some(next) => {
                    open.clone_from(&next.2.open);
                    at = *next.0.last().unwrap_or(&at);
                    visits.push(next);
                }
                None => abandoned.extend(self.abandon(&mut open, &at, stopped)?),
            }
            // Rejoined strokes may visit a node more often, where branches meet.
            progress(all.saturating_sub(count_pending(&open)));
        }
        self.assemble(visits, abandoned, rated)
    }

    /// Tries the pending strokes from several base poses, and returns the visit with the fewest pending nodes;
    /// of equal visits the one with the best predicted effect. Also returns the attempts of the first visit
    /// that failed.
    fn best_visit(
        &self,
        places: &[Candidate],
        at: &PlanarPose,
        open: &[PendingStroke],
        before: &[ReachedVisit],
    ) -> Result<(Option<ReachedVisit>, Vec<Attempt>), FollowError> {
        let mut chosen: Option<(Outcome, ReachedVisit)> = None;
        let mut stopped = Vec::new();
        for some in places.chunks(AT_ONCE) {
            let visits = some.par_iter().map(|place| {
                let way = drive(self.cell, at, &place.world_from_base, self.config);
                way.map(|way| {
                    let visit = self.visit_base_pose(way.last().unwrap_or(at), open)?;
                    Ok((way, Placement::from(place), visit))
                })
                .transpose()
            });
            let visits = visits.collect::<Result<Vec<Option<ReachedVisit>>, FollowError>>()?;
            for reached in visits.into_iter().flatten() {
                if stopped.is_empty() {
                    stopped.clone_from(&reached.2.stopped);
                }
                if reached.2.runs.is_empty() {
                    continue;
                }
                let outcome = self.outcome(before, &reached.2);
                let is_better = (chosen.as_ref()).is_none_or(|(best, _)| {
                    (outcome.left, best.achieved) < (best.left, outcome.achieved)
                });
                if is_better {
                    chosen = Some((outcome, reached));
                }
            }
            let is_as_planned = |outcome: &Outcome| {
                outcome.left == 0 && outcome.achieved as f64 >= ENOUGH * self.planned as f64
            };
            if (chosen.as_ref()).is_some_and(|(outcome, _)| is_as_planned(outcome)) {
                break;
            }
        }
        let chosen = chosen.map(|(_, reached)| reached);
        Ok((chosen, stopped))
    }

    /// Predicts the result of a visit after the earlier visits.
    fn outcome(&self, before: &[ReachedVisit], visit: &BaseVisit) -> Outcome {
        let visits = before.iter().map(|(.., visit)| visit).chain([visit]);
        let strokes =
            visits.flat_map(|visit| visit.runs.iter().map(|(nodes, run)| run.stroke(nodes)));
        let wiped = Plan {
            strokes: strokes.collect(),
            ..self.plan.clone()
        };
        Outcome {
            left: count_pending(&visit.open),
            achieved: predict(self.task, &wiped, |_| ()).performance.achieved,
        }
    }

    /// Returns the pending strokes with the yaw chosen so that the joints move little: in another order in
    /// which they may move less, and in the planned order. Leaves out versions with a worse predicted effect.
    fn free_yaw_versions(&self, arm: &Arm, open: &[PendingStroke]) -> Vec<Vec<PendingStroke>> {
        if !self.config.free_yaw || arm.keeps_heading || self.cell.second_arm().is_some() {
            return Vec::new();
        }
        let achieved = self.predict_achieved(open);
        let (reordered, in_order) =
            rayon::join(|| self.reorder(arm, open), || self.choose_yaws(arm, open));
        let all = reordered.into_iter().chain([in_order]);
        all.filter(|eased| self.predict_achieved(eased) >= achieved)
            .collect()
    }

    /// Returns the pending strokes in their order, with the yaw chosen so that the joints move little.
    fn choose_yaws(&self, arm: &Arm, open: &[PendingStroke]) -> Vec<PendingStroke> {
        let mut at = arm.ready_posture();
        let mut turned = open.to_vec();
        for (i, open) in turned.iter_mut().enumerate() {
            let seed = self.config.seed ^ (i as u64) << 32;
            // The tool no longer turns on the spot.
            open.nodes.dedup_by_key(|waiting| waiting.node);
            let poses: Vec<PlanarPose> = open.nodes.iter().map(|w| w.corner.pose).collect();
            let line: Vec<Point2> = poses.iter().map(|pose| pose.position).collect();
            let near = configurations_with_free_yaw(arm, &at, &line, seed);
            if let Some(&last) = near.iter().flatten().last() {
                at = last;
            }
            let poses = poses_with_yaws(arm, &poses, &near);
            for (waiting, (pose, near)) in open.nodes.iter_mut().zip(poses.into_iter().zip(near)) {
                waiting.corner = Corner { pose, near };
            }
        }
        turned
    }

    /// Returns all pending nodes in an order in which the joints move less; `None` if there is none, or if the
    /// robot may not choose the order.
    fn reorder(&self, arm: &Arm, open: &[PendingStroke]) -> Option<Vec<PendingStroke>> {
        if !self.config.free_order || self.task.action != Action::Absorb {
            return None;
        }
        let mut left: Vec<PendingNode> = Vec::new();
        for waiting in open.iter().flat_map(PendingStroke::pending) {
            if left.iter().all(|known| known.node != waiting.node) {
                left.push(*waiting);
            }
        }
        let nodes: Vec<usize> = left.iter().map(|waiting| waiting.node).collect();
        let tour = joint_tour(
            arm,
            &arm.ready_posture(),
            self.plan,
            &nodes,
            self.config.seed,
        )?;
        let strokes = tour.strokes.iter().map(|stroke| {
            let poses: Vec<PlanarPose> = stroke.iter().map(|&i| left[i].corner.pose).collect();
            let at: Vec<_> = stroke.iter().map(|&i| Some(tour.at[i])).collect();
            let corners = poses_with_yaws(arm, &poses, &at).into_iter().zip(at);
            let nodes = stroke.iter().zip(corners);
            PendingStroke::from_nodes(nodes.map(|(&i, (pose, near))| PendingNode {
                corner: Corner { pose, near },
                ..left[i]
            }))
        });
        Some(strokes.collect())
    }

    /// Predicts the number of particles that meet the goal after the pending strokes.
    fn predict_achieved(&self, open: &[PendingStroke]) -> usize {
        let wiped = Plan {
            strokes: open.iter().map(PendingStroke::stroke).collect(),
            ..self.plan.clone()
        };
        predict(self.task, &wiped, |_| ()).performance.achieved
    }

    /// Returns all strokes of the plan as pending.
    fn pending_strokes(&self) -> Vec<PendingStroke> {
        let strokes = self.plan.strokes.iter().enumerate();
        strokes
            .filter(|(_, stroke)| !stroke.poses.is_empty())
            .map(|(number, stroke)| PendingStroke::from_stroke(stroke, |_| number))
            .collect()
    }

    /// Removes the nodes from the pending strokes that no base pose can reach, and returns them as abandoned.
    ///
    /// If the nodes are known at which the tool cannot touch down, only these are abandoned, and
    /// the remaining nodes are rejoined.
    fn abandon(
        &self,
        open: &mut Vec<PendingStroke>,
        at: &PlanarPose,
        attempts: Vec<Attempt>,
    ) -> Result<Vec<AbandonedNode>, FollowError> {
        if self.task.action.treats() {
            return Ok(abandon_next(open, attempts).into_iter().collect());
        }
        if self.task.action != Action::Absorb {
            return match self.rejoin_to_goals(open, at)? {
                Some((strokes, abandoned)) => {
                    *open = strokes;
                    Ok(abandoned)
                }
                None => Ok(abandon_next(open, attempts).into_iter().collect()),
            };
        }
        let first = &mut open[0];
        if first.begun && first.nodes.len() > 1 {
            first.touch_down_at_next();
            return Ok(Vec::new());
        }
        let mut left: Vec<PendingNode> = open
            .iter()
            .flat_map(PendingStroke::pending)
            .copied()
            .collect();
        left.dedup_by_key(|waiting| waiting.node);
        let mut untouched = self.find_untouchable(&left, at)?;
        // The first node is known to be out of reach, even if the base can move.
        if let Some(first) = untouched.first_mut() {
            *first = Some(attempts);
        }
        let (nodes, abandoned) = split_by_touch(&left, untouched);
        if let Some(strokes) = self.rejoin(&left, &nodes) {
            *open = strokes;
        } else {
            for open in &mut *open {
                open.nodes.retain(|waiting| nodes.contains(&waiting.node));
            }
            open.retain(|open| !open.nodes.is_empty());
        }
        Ok(abandoned)
    }

    /// Returns the pending branches without nodes at which the tool cannot touch down, and these nodes.
    ///
    /// Branches that only start at such nodes keep their way to the goal. Returns `None` in three cases: there
    /// are no such nodes; the base can move, so that another base pose may reach them; or the remaining nodes
    /// lead to no goal.
    fn rejoin_to_goals(
        &self,
        open: &[PendingStroke],
        at: &PlanarPose,
    ) -> Result<Option<Rejoined>, FollowError> {
        let mut left: Vec<PendingNode> = Vec::new();
        // A branch ends at a node of another branch.
        for waiting in open.iter().flat_map(PendingStroke::pending) {
            if left.iter().all(|known| known.node != waiting.node) {
                left.push(*waiting);
            }
        }
        let (mut nodes, abandoned) = split_by_touch(&left, self.find_untouchable(&left, at)?);
        let is_lost =
            |waiting: &PendingNode| abandoned.iter().any(|lost| lost.node == waiting.node);
        if abandoned.is_empty() {
            return Ok(None);
        }
        let cuts = (open.iter()).any(|open| open.nodes.iter().skip(1).any(is_lost));
        if !cuts {
            let mut open = open.to_vec();
            for open in &mut open {
                open.nodes.retain(|waiting| !is_lost(waiting));
            }
            open.retain(|open| !open.nodes.is_empty());
            return Ok(Some((open, abandoned)));
        }
        // Carried material still has to reach the goal.
        if let [
            PendingStroke {
                begun: true,
                nodes: first,
                ..
            },
            ..,
        ] = open
        {
            left.insert(0, first[0]);
            if !nodes.contains(&first[0].node) {
                nodes.insert(0, first[0].node);
            }
        }
        let joined = self.rejoin(&left, &nodes);
        let is_whole = |strokes: &Vec<PendingStroke>| {
            let is_in = |node: &usize| strokes.iter().any(|open| open.has(*node));
            nodes.iter().all(is_in)
        };
        Ok(joined.filter(is_whole).map(|strokes| (strokes, abandoned)))
    }

    /// Joins some of the pending nodes into new strokes, from the first pending node on.
    fn rejoin(&self, left: &[PendingNode], nodes: &[usize]) -> Option<Vec<PendingStroke>> {
        let from = left
            .first()
            .map_or(self.plan.tool_start, |w| w.corner.pose.position);
        let strokes = rejoin_nodes(self.task, self.plan, nodes, from, self.config.seed).ok()?;
        let stroke_of = |node: usize| {
            let planned = left.iter().find(|waiting| waiting.node == node);
            planned.map_or(0, |waiting| waiting.stroke)
        };
        let open = strokes
            .iter()
            .map(|stroke| PendingStroke::from_stroke(stroke, stroke_of));
        Some(open.collect())
    }

    /// Returns for each node the failed attempts, if the tool cannot touch down there. If the base can move,
    /// this is unknown and `None` for every node.
    fn find_untouchable(
        &self,
        nodes: &[PendingNode],
        at: &PlanarPose,
    ) -> Result<Vec<Option<Vec<Attempt>>>, FollowError> {
        if self.cell.base().is_some() {
            return Ok(vec![None; nodes.len()]);
        }
        let arm = Arm::new(self.cell, self.task, self.config, at)?.with_plan(self.plan);
        let now = Now {
            q: arm.ready_posture(),
            tool: None,
        };
        let (lift, seed) = (self.plan.lift_height, self.config.seed);
        let touch = |waiting: &PendingNode| {
            run(
                &arm,
                &now,
                &[waiting.corner],
                lift,
                &self.orientations,
                seed,
            )
            .err()
        };
        Ok(nodes.par_iter().map(touch).collect())
    }

    /// Returns rated base poses for the rest of the path; none for a robot without a planar base.
    fn candidates(&self, open: &[PendingStroke]) -> Result<Vec<Candidate>, FollowError> {
        if self.cell.base().is_none() {
            return Ok(Vec::new());
        }
        let reachability = Reachability::new(self.cell, self.task, self.map)?;
        let mut ahead: Vec<ToolPose> = Vec::new();
        let mut add = |position, heading| {
            ahead.push(ToolPose {
                surface_from_tool: PlanarPose::new(position, heading),
                height: 0.0,
                tilt: 0.0,
            });
        };
        for open in open {
            for (i, waiting) in open.nodes.iter().enumerate() {
                let pose = waiting.corner.pose;
                add(pose.position, pose.heading);
                if let Some(next) = open.nodes.get(i + 1) {
                    let middle = nalgebra::center(&pose.position, &next.corner.pose.position);
                    add(middle, pose.heading);
                }
            }
        }
        Ok(reachability.rate_base_poses(&ahead, self.config))
    }

    /// Returns for each position the base pose with the highest rating.
    fn rated_places(&self, candidates: &[Candidate]) -> Vec<RatedBasePose> {
        let mut places: Vec<RatedBasePose> = Vec::new();
        let mut sorted: Vec<RatedBasePose> = candidates.iter().map(RatedBasePose::from).collect();
        let key = |place: &RatedBasePose| {
            let at = place.world_from_base.position;
            ((at.x * 1e3).round() as i64, (at.y * 1e3).round() as i64)
        };
        sorted.sort_by(|a, b| {
            let rating = |place: &RatedBasePose| place.rating.unwrap_or(-1.0);
            key(a).cmp(&key(b)).then(rating(b).total_cmp(&rating(a)))
        });
        for place in sorted {
            if places.last().is_none_or(|last| key(last) != key(&place)) {
                places.push(place);
            }
        }
        places
    }

    /// Follows the pending strokes from one base pose, in several versions. Takes the version with the fewest
    /// pending nodes, of equal ones that with the shortest joint path. The planned version is tried if there is
    /// no other, or if a fixed arm leaves nodes pending in all others.
    fn visit_base_pose(
        &self,
        world_from_base: &PlanarPose,
        open: &[PendingStroke],
    ) -> Result<BaseVisit, FollowError> {
        let arm =
            Arm::new(self.cell, self.task, self.config, world_from_base)?.with_plan(self.plan);
        let eased = self.free_yaw_versions(&arm, open);
        let visits = eased
            .into_par_iter()
            .map(|open| self.follow_strokes(&arm, world_from_base, open));
        let mut visits: Vec<BaseVisit> = visits.collect();
        let is_whole = visits.iter().any(|visit| visit.open.is_empty());
        if visits.is_empty() || !is_whole && self.cell.base().is_none() {
            visits.push(self.follow_strokes(&arm, world_from_base, open.to_vec()));
        }
        let rank = |visit: &BaseVisit| (visit.runs.is_empty(), count_pending(&visit.open));
        let best = visits.into_iter().reduce(|best, visit| {
            let is_better = match rank(&visit).cmp(&rank(&best)) {
                Ordering::Equal => visit.movement() < best.movement(),
                order => order == Ordering::Less,
            };
            if is_better { visit } else { best }
        });
        Ok(best.expect("at least one way"))
    }

    /// Follows strokes from one base pose, in order, until one cannot be continued.
    fn follow_strokes(
        &self,
        arm: &Arm,
        world_from_base: &PlanarPose,
        open: Vec<PendingStroke>,
    ) -> BaseVisit {
        let mut now = Now {
            q: arm.ready_posture(),
            tool: None,
        };
        let mut visit = BaseVisit {
            world_from_base: *world_from_base,
            runs: Vec::new(),
            back: Vec::new(),
            open,
            stopped: Vec::new(),
        };
        while let Some(first) = visit.open.first_mut() {
            let planned: Vec<Corner> = first.nodes.iter().map(|w| w.corner).collect();
            let seed = self.config.seed ^ (visit.runs.len() as u64) << 32;
            let run = match run(
                arm,
                &now,
                &planned,
                self.plan.lift_height,
                &self.orientations,
                seed,
            ) {
                Ok(run) => run,
                Err(attempts) => {
                    visit.stopped = attempts;
                    break;
                }
            };
            // Touching down where the tool has wiped already is no progress.
            if run.last == 0 && first.begun && planned.len() > 1 {
                // If paths do not matter and no other base pose may be better, the next node is tried.
                if self.task.action == Action::Absorb && self.cell.base().is_none() {
                    first.touch_down_at_next();
                    continue;
                }
                visit.stopped = run.stopped;
                break;
            }
            let nodes: Vec<usize> = first.nodes[..=run.last].iter().map(|w| w.node).collect();
            now = run.now;
            first.nodes.drain(..run.last);
            first.begun = true;
            first.skipped &= run.last == 0;
            if first.nodes.len() == 1 {
                visit.open.remove(0);
            }
            visit.runs.push((nodes, run));
        }
        if !visit.runs.is_empty() {
            let ready = arm.ready_posture();
            let back = (0..RETURN_SEARCHES)
                .find_map(|i| free_motion(arm, &now.q, &ready, self.config.seed.wrapping_add(i)));
            match back {
                Some(path) => visit.back = path,
                // Without a path back to the ready posture the base could not drive on.
                None => visit.runs.clear(),
            }
        }
        visit
    }

    /// Returns for each node of the plan its reachability from the best base pose; empty without a map.
    fn node_reachability(&self, visits: &[ReachedVisit]) -> Result<Vec<f64>, FollowError> {
        if self.map.is_none() {
            return Ok(Vec::new());
        }
        let reachability = Reachability::new(self.cell, self.task, self.map)?;
        let mut places: Vec<PlanarPose> = visits
            .iter()
            .map(|(.., visit)| visit.world_from_base)
            .collect();
        if places.is_empty() {
            places.push(self.cell.base_pose(self.cell.ready_posture()));
        }
        let strokes = self.plan.strokes.iter();
        let mut poses: Vec<PlanarPose> = (self.plan.graph.nodes.iter())
            .map(|node| PlanarPose::new(node.position, 0.0))
            .collect();
        for (&node, &pose) in strokes.flat_map(|stroke| stroke.nodes.iter().zip(&stroke.poses)) {
            poses[node] = pose;
        }
        Ok(reachability.best_of_each(&poses, &places))
    }

    /// Assembles all motions in order and times them.
    fn assemble(
        &self,
        visits: Vec<ReachedVisit>,
        abandoned: Vec<AbandonedNode>,
        rated: Vec<RatedBasePose>,
    ) -> Result<Followed, FollowError> {
        let mut followed = Followed {
            node_reachability: self.node_reachability(&visits)?,
            rated,
            abandoned,
            ..Followed::new(*self.cell.tip_from_tool())
        };
        for (way, placement, visit) in visits {
            if self.cell.base().is_some() {
                followed.placements.push(placement);
                let path: Vec<Vec<f64>> = way
                    .iter()
                    .map(|pose| self.cell.standing(self.cell.ready_posture(), pose))
                    .collect();
                self.append(&mut followed, Phase::Drive, &path, Vec::new())?;
            }
            let arm = Arm::new(self.cell, self.task, self.config, &visit.world_from_base)?;
            for (nodes, run) in visit.runs {
                let stroke = followed.strokes.len();
                let wiped = run.stroke(&nodes);
                for UntimedMotion { phase, path, line } in run.pieces {
                    let phase = match phase {
                        UntimedPhase::Plain(phase) => phase,
                        UntimedPhase::Wipe => Phase::Wipe(stroke),
                    };
                    let path: Vec<Vec<f64>> = path.iter().map(|q| arm.to_robot(q)).collect();
                    self.append(&mut followed, phase, &path, line)?;
                }
                followed.strokes.push(wiped);
            }
            let back: Vec<Vec<f64>> = visit.back.iter().map(|q| arm.to_robot(q)).collect();
            self.append(&mut followed, Phase::FreeMotion, &back, Vec::new())?;
        }
        Ok(followed)
    }

    fn append(
        &self,
        followed: &mut Followed,
        phase: Phase,
        path: &[Vec<f64>],
        tool_line: Vec<ToolPose>,
    ) -> Result<(), FollowError> {
        let start = followed.duration();
        let trajectory =
            schedule::time_motion(self.cell, self.task, self.config, phase, path, &tool_line)?;
        if let Some(trajectory) = trajectory {
            followed.motions.push(Motion {
                phase,
                start,
                trajectory,
                tool_line,
            });
        }
        Ok(())
    }
}

/// Returns the base poses to try. If the robot has no planar base, or no base pose reaches the
/// path, the result is the current base pose, so that the obstruction is reported.
fn best_or_here(
    cell: &Workcell,
    candidates: &[Candidate],
    at: &PlanarPose,
    config: &FollowConfig,
) -> Vec<Candidate> {
    let places = best(candidates, at, config.placements);
    if cell.base().is_some() && !places.is_empty() {
        return places;
    }
    vec![Candidate {
        world_from_base: *at,
        in_reach: None,
        share: 0.0,
        rating: 0.0,
    }]
}
