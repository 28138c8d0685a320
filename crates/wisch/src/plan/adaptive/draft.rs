//! Drafts of plans, and the random moves that change them.

use super::ways::KnownWays;
use crate::geometry::{Bounds2, Edge, PlanarPose, Point2, Vector2, wrap_angle};
use crate::plan::{FreeSpace, Plan};
use crate::random::normal;
use crate::represent::{Action, GoalState, Task};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// Standard deviations of small, medium and large steps of a position, over the tool's size [1], and of a
/// heading [rad].
const STEPS: [f64; 3] = [0.03, 0.12, 0.5];
const TURN: f64 = 0.15;
/// Probability that a changed stroke is turned so that the tool's broad side is across its motion [1].
const ALIGNED: f64 = 0.6;
/// Probability that a new push ends on another stroke, which takes its dirt along [1], and the number of
/// strokes considered for that.
const ENDING_ON_STROKE: f64 = 0.4;
const TRIED_STROKES: usize = 3;
/// Length of a stroke at a place that no existing stroke can pass [m], and the number of strokes considered for
/// a detour.
const DAB: f64 = 0.01;
const TRIED_DETOURS: usize = 3;
/// Probability that a new push begins with a corner of the tool just over the dirt; and, of the
/// remaining pushes, the probability that it begins with the tool over the dirt at a random yaw
/// [1].
const WITH_CORNER: f64 = 0.25;
const WITH_TOOL_OVER: f64 = 0.25;
/// Probability that a push with a corner of the tool ends within the tool's size, in any direction [1].
const SHORT_PUSH: f64 = 0.3;
/// Search for a free pose with a corner of the tool over a place: number of steps towards the
/// place, the largest share of the corner's reach, and the number of directions.
const REACHES: i32 = 13;
const FARTHEST: f64 = 0.99;
const TRIED_DIRECTIONS: usize = 12;
/// Distance that the tool keeps from places to avoid [m].
const AVOIDED: f64 = 0.03;
/// A skimming stroke ends at most this far beyond the border, over the radius of the collision sphere [1].
const BEYOND: f64 = 1.0;

/// The strokes of a plan, in the form that the search changes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Draft {
    /// For each stroke the tool's poses from touching down to lifting off, at least one.
    pub(super) strokes: Vec<Vec<PlanarPose>>,
    pub(super) goal: GoalState,
}

impl Draft {
    /// Returns a plan's strokes as the search changes them: every push is straight.
    pub(super) fn of(plan: &Plan) -> Self {
        let strokes = plan.strokes.iter().map(|stroke| stroke.poses.clone());
        let strokes = if plan.graph.goal == GoalState::Absorbed {
            strokes.collect()
        } else {
            strokes.flat_map(|poses| split_into_edges(&poses)).collect()
        };
        Self {
            strokes,
            goal: plan.graph.goal,
        }
    }
}

impl Draft {
    /// Returns a plan's strokes unchanged.
    pub(super) fn exactly(plan: &Plan) -> Self {
        Self {
            strokes: plan
                .strokes
                .iter()
                .map(|stroke| stroke.poses.clone())
                .collect(),
            goal: plan.graph.goal,
        }
    }

    /// Returns the draft without poses near places to avoid: of strokes that absorb the poses, of pushes the
    /// whole stroke.
    pub(super) fn without(mut self, avoid: &[Point2]) -> Self {
        if self.goal == GoalState::Absorbed {
            for poses in &mut self.strokes {
                poses.retain(|pose| !is_near(avoid, pose.position));
            }
            self.strokes.retain(|poses| !poses.is_empty());
        } else {
            let is_kept =
                |poses: &Vec<PlanarPose>| !poses.iter().any(|pose| is_near(avoid, pose.position));
            self.strokes.retain(is_kept);
        }
        self
    }

    /// Length of the path in contact [m].
    pub(super) fn distance(&self) -> f64 {
        let legs = self.strokes.iter().flat_map(|stroke| stroke.windows(2));
        legs.map(|leg| (leg[1].position - leg[0].position).norm())
            .sum()
    }
}

/// Random moves of the annealing, within the limits of the tool.
pub(super) struct Mutator<'a> {
    pub(super) task: &'a Task,
    pub(super) space: &'a FreeSpace,
    pub(super) allowed_edges: &'a [Edge],
    /// Places that the tool must avoid, for example places out of the robot's reach [m].
    pub(super) avoid: &'a [Point2],
    pub(super) ways: KnownWays<'a>,
    pub(super) footprint: Bounds2,
    pub(super) random: ChaCha8Rng,
}

impl Mutator<'_> {
    /// Returns a neighbour of a draft; `None` if the random move is not possible. `left`: places of dirt that
    /// the draft leaves [m].
    pub(super) fn neighbour(&mut self, draft: &Draft, left: &[Point2]) -> Option<Draft> {
        let mut next = draft.clone();
        let choice = self.random.random::<f64>();
        let is_pushing = draft.goal != GoalState::Absorbed;
        let changed = if is_pushing {
            match choice {
                ..0.30 => self.move_pose(&mut next),
                ..0.42 => self.move_stroke(&mut next),
                ..0.50 => self.turn(&mut next),
                ..0.64 => self.add_push(&mut next, left),
                ..0.74 => self.drop_stroke(&mut next),
                ..0.86 => self.reorder(&mut next),
                ..0.92 => self.straighten(&mut next),
                _ if self.is_goal_free() => self.move_goal(&mut next),
                _ => self.align(&mut next),
            }
        } else {
            match choice {
                ..0.30 => self.move_pose(&mut next),
                ..0.36 => self.move_stroke(&mut next),
                ..0.50 => self.turn(&mut next),
                ..0.68 => self.visit(&mut next, left),
                ..0.78 => self.drop_pose(&mut next),
                ..0.88 => self.reverse(&mut next),
                ..0.92 => self.cut(&mut next),
                ..0.96 => self.join(&mut next),
                _ => self.drop_stroke(&mut next),
            }
        };
        let strokes = changed?;
        let is_possible = strokes.into_iter().all(|stroke| {
            next.strokes
                .get(stroke)
                .is_none_or(|poses| self.is_possible(poses))
        });
        is_possible.then_some(next)
    }

    /// Whether the tool can make a stroke.
    pub(super) fn is_possible(&mut self, poses: &[PlanarPose]) -> bool {
        let ends_well = poses
            .last()
            .is_some_and(|pose| self.is_allowed(pose.position));
        let mut before = poses.iter().rev().skip(1);
        let ways = &mut self.ways;
        ends_well
            && !poses.iter().any(|pose| is_near(self.avoid, pose.position))
            && before.all(|pose| ways.is_free(pose.position))
            && poses
                .windows(2)
                .all(|pair| ways.is_clear_between(pair[0].position, pair[1].position))
    }

    /// Whether a stroke may end at a place: on the surface, or a little beyond an edge over which dirt may go.
    fn is_allowed(&mut self, place: Point2) -> bool {
        let beyond = BEYOND * self.space.radius() + 1e-9;
        let is_beyond = || {
            let edges = self.allowed_edges.iter();
            self.task.action == Action::Skim && { edges }.any(|edge| edge.distance(place) <= beyond)
        };
        (self.space.surface().outline.contains(place) || is_beyond()) && self.ways.is_clear(place)
    }

    fn is_goal_free(&self) -> bool {
        self.task.action == Action::Collect && self.task.collect_goal.is_none()
    }

    /// Returns a random index below `count`; `None` if `count` is 0.
    fn random_index(&mut self, count: usize) -> Option<usize> {
        (count > 0).then(|| self.random.random_range(0..count))
    }

    /// Draws a random step of a position [m], with one of the standard deviations [`STEPS`].
    fn step(&mut self) -> Vector2 {
        let size = self.footprint.size().max();
        let scale = STEPS[self.random.random_range(0..STEPS.len())] * size;
        Vector2::new(normal(&mut self.random), normal(&mut self.random)) * scale
    }

    /// Moves one pose of a stroke. Each move returns the indices of the strokes that it changed.
    fn move_pose(&mut self, draft: &mut Draft) -> Option<Vec<usize>> {
        let stroke = self.random_index(draft.strokes.len())?;
        let pose = self.random_index(draft.strokes[stroke].len())?;
        draft.strokes[stroke][pose].position += self.step();
        if draft.goal != GoalState::Absorbed && self.random.random::<f64>() < ALIGNED {
            align_to_motion(&mut draft.strokes[stroke]);
        }
        Some(vec![stroke])
    }

    /// Moves a whole stroke.
    fn move_stroke(&mut self, draft: &mut Draft) -> Option<Vec<usize>> {
        let stroke = self.random_index(draft.strokes.len())?;
        let step = self.step();
        for pose in &mut draft.strokes[stroke] {
            pose.position += step;
        }
        Some(vec![stroke])
    }

    /// Turns the tool at one pose, or along a whole stroke.
    fn turn(&mut self, draft: &mut Draft) -> Option<Vec<usize>> {
        let stroke = self.random_index(draft.strokes.len())?;
        let poses = &mut draft.strokes[stroke];
        let by = normal(&mut self.random) * TURN;
        match self.random.random_range(0..3) {
            0 if draft.goal == GoalState::Absorbed => {
                let pose = self.random.random_range(0..poses.len());
                poses[pose].heading += by;
            }
            0 | 1 => poses.iter_mut().for_each(|pose| pose.heading += by),
            _ => {
                let pose = self.random.random_range(0..poses.len());
                let heading = poses[pose].heading;
                poses.iter_mut().for_each(|pose| pose.heading = heading);
            }
        }
        Some(vec![stroke])
    }

    /// Turns the broad side of the tool across the motion again.
    fn align(&mut self, draft: &mut Draft) -> Option<Vec<usize>> {
        let stroke = self.random_index(draft.strokes.len())?;
        align_to_motion(&mut draft.strokes[stroke]);
        Some(vec![stroke])
    }

    /// Adds a stroke that pushes remaining dirt to where it belongs.
    fn add_push(&mut self, draft: &mut Draft, left: &[Point2]) -> Option<Vec<usize>> {
        let dirt = match self.random_index(left.len()) {
            Some(i) => left[i],
            None => {
                let places: Vec<Point2> = self.task.particles.remaining().collect();
                places[self.random_index(places.len())?]
            }
        };
        let landing = match self.random.random::<f64>() < WITH_CORNER {
            true => Some(self.pose_with_corner_over(dirt)?),
            false => None,
        };
        if let Some(landing) = landing
            && self.random.random::<f64>() < SHORT_PUSH
        {
            // The short push only leads dirt out of its corner, from where another stroke may take
            // it along.
            let angle = std::f64::consts::TAU * self.random.random::<f64>();
            let length = self.footprint.size().max() * self.random.random::<f64>();
            let by = Vector2::new(libm::cos(angle), libm::sin(angle)) * length;
            let out = PlanarPose::new(landing.position + by, landing.heading);
            let at = self.random.random_range(0..=draft.strokes.len());
            draft.strokes.insert(at, vec![landing, out]);
            return Some(vec![at]);
        }
        let leads_on = match self.random.random::<f64>() < ENDING_ON_STROKE {
            true => self.find_carrying_stroke(draft, dirt, landing.as_ref()),
            false => None,
        };
        let (target, taken_by) = match leads_on {
            Some((place, stroke)) => (place, Some(stroke)),
            None => (self.target(&draft.goal, dirt)?, None),
        };
        let along = (target - dirt).try_normalize(1e-9)?;
        let across = Vector2::new(-along.y, along.x);
        let size = self.footprint.size();
        let aside = across * (normal(&mut self.random) * 0.3 * size.y);
        let behind = (0.5 + 0.3 * self.random.random::<f64>()) * size.x;
        let before = match draft.goal {
            GoalState::Skimmed if taken_by.is_none() => 0.0,
            _ => size.x * self.random.random::<f64>(),
        };
        let from = dirt - along * behind + aside;
        let to = target - along * before + aside * self.random.random::<f64>();
        let mut poses = vec![PlanarPose::new(from, 0.0), PlanarPose::new(to, 0.0)];
        align_to_motion(&mut poses);
        let landing = match landing {
            None if self.random.random::<f64>() < WITH_TOOL_OVER => {
                let heading = poses[0].heading + 3.0 * TURN * normal(&mut self.random);
                Some(self.pose_over(dirt, heading))
            }
            landing => landing,
        };
        if let Some(landing) = landing {
            let towards = landing.position + (to - dirt);
            poses = vec![landing, PlanarPose::new(towards, landing.heading)];
        }
        // Most often last, because the remaining dirt reaches its place only then.
        let at = match taken_by {
            Some(stroke) => stroke,
            None if self.random.random::<f64>() < 0.6 => draft.strokes.len(),
            None => self.random.random_range(0..=draft.strokes.len()),
        };
        draft.strokes.insert(at, poses);
        Some(vec![at])
    }

    /// Returns a place near some dirt that a stroke passes, and the index of that stroke: the stroke takes dirt
    /// along that is pushed there. Of a few strokes the nearest is taken that the tool can reach straight from
    /// this landing pose.
    fn find_carrying_stroke(
        &mut self,
        draft: &Draft,
        dirt: Point2,
        landing: Option<&PlanarPose>,
    ) -> Option<(Point2, usize)> {
        let mut nearest: Option<(f64, Point2, usize)> = None;
        for _ in 0..TRIED_STROKES {
            let stroke = self.random_index(draft.strokes.len())?;
            for leg in draft.strokes[stroke].windows(2) {
                let (from, along) = (leg[0].position, leg[1].position - leg[0].position);
                let share = (dirt - from).dot(&along) / along.norm_squared().max(1e-12);
                let place = from + along * share.clamp(0.0, 1.0);
                let distance = (place - dirt).norm();
                let mut is_clear = || {
                    landing.is_none_or(|landing| {
                        let to = landing.position + (place - dirt);
                        self.ways.is_clear_between(landing.position, to)
                    })
                };
                if nearest.is_none_or(|(least, ..)| distance < least) && is_clear() {
                    nearest = Some((distance, place, stroke));
                }
            }
        }
        let (_, place, stroke) = nearest?;
        Some((place + self.step() * 0.5, stroke))
    }

    /// Returns the target of a push: the goal, or a place beyond a nearby edge over which dirt may go.
    fn target(&mut self, goal: &GoalState, dirt: Point2) -> Option<Point2> {
        match goal {
            GoalState::Absorbed | GoalState::Polished { .. } | GoalState::Dispensed { .. } => None,
            GoalState::Collected { center, .. } => Some(*center),
            GoalState::Skimmed => {
                let edge = self.allowed_edges[self.random_index(self.allowed_edges.len())?];
                let along = edge.end - edge.start;
                let share = (dirt - edge.start).dot(&along) / along.norm_squared();
                let share = (share + 0.15 * normal(&mut self.random)).clamp(0.0, 1.0);
                let outward = Vector2::new(along.y, -along.x).try_normalize(1e-12)?;
                Some(edge.start + along * share + outward * self.space.radius())
            }
        }
    }

    /// Returns a pose with this heading whose footprint covers a place, at a random position under the tool.
    fn pose_over(&mut self, place: Point2, heading: f64) -> PlanarPose {
        let Bounds2 { min, max } = self.footprint;
        let mut within = |min: f64, max: f64| min + (max - min) * self.random.random::<f64>();
        let under = Vector2::new(within(min.x, max.x), within(min.y, max.y));
        let turned = PlanarPose::new(Point2::origin(), heading).transform(Point2::from(under));
        PlanarPose::new(place - turned.coords, heading)
    }

    /// Returns a pose with a corner of the tool over a place, from a random direction, as near to the place as
    /// the scene allows.
    fn pose_with_corner_over(&mut self, place: Point2) -> Option<PlanarPose> {
        let Bounds2 { min, max } = self.footprint;
        let corners = Bounds2 { min, max }.corners();
        let corner = corners[self.random.random_range(0..corners.len())].coords;
        let farthest = FARTHEST * corner.norm();
        let (away, stands) = (0..TRIED_DIRECTIONS).find_map(|_| {
            let angle = std::f64::consts::TAU * self.random.random::<f64>();
            let away = Vector2::new(libm::cos(angle), libm::sin(angle));
            let steps = (0..=REACHES).map(|step| f64::from(step) / f64::from(REACHES));
            let mut steps = steps.map(|share| place + away * (farthest * share));
            let stands = steps.find(|&stands| self.is_allowed(stands))?;
            Some((away, stands))
        })?;
        // The corner lies a little beyond the place.
        let heading = libm::atan2(-away.y, -away.x) - libm::atan2(corner.y, corner.x);
        Some(PlanarPose::new(stands, heading))
    }

    /// Removes a stroke.
    fn drop_stroke(&mut self, draft: &mut Draft) -> Option<Vec<usize>> {
        let stroke = self.random_index(draft.strokes.len())?;
        draft.strokes.remove(stroke);
        Some(Vec::new())
    }

    /// Moves a stroke to another position in the order of execution.
    fn reorder(&mut self, draft: &mut Draft) -> Option<Vec<usize>> {
        let from = self.random_index(draft.strokes.len())?;
        let to = self.random_index(draft.strokes.len())?;
        if from == to {
            return None;
        }
        let stroke = draft.strokes.remove(from);
        draft.strokes.insert(to, stroke);
        Some(Vec::new())
    }

    /// Removes a pose from a stroke.
    fn drop_pose(&mut self, draft: &mut Draft) -> Option<Vec<usize>> {
        let stroke = self.random_index(draft.strokes.len())?;
        let poses = &mut draft.strokes[stroke];
        if poses.len() <= 2 {
            return None;
        }
        let pose = self.random.random_range(0..poses.len());
        poses.remove(pose);
        if draft.goal != GoalState::Absorbed {
            align_to_motion(&mut draft.strokes[stroke]);
        }
        Some(vec![stroke])
    }

    /// Inserts a place with remaining dirt into a stroke, where the detour is shortest.
    fn visit(&mut self, draft: &mut Draft, left: &[Point2]) -> Option<Vec<usize>> {
        let dirt = left[self.random_index(left.len())?];
        // With the current heading of the tool, or turned so that the tool reaches into a corner.
        let (place, turned) = if self.random.random::<f64>() < ALIGNED {
            (dirt + self.step(), None)
        } else if self.random.random::<bool>() {
            let pose = self.pose_with_corner_over(dirt)?;
            (pose.position, Some(pose.heading))
        } else {
            let heading = std::f64::consts::TAU * self.random.random::<f64>();
            (self.pose_over(dirt, heading).position, Some(heading))
        };
        let mut detours = Vec::new();
        for (s, poses) in draft.strokes.iter().enumerate() {
            for at in 0..=poses.len() {
                let before = at.checked_sub(1).map(|i| poses[i].position);
                let after = poses.get(at).map(|pose| pose.position);
                let to = |next: Option<Point2>| next.map_or(0.0, |next| (next - place).norm());
                let direct = match (before, after) {
                    (Some(before), Some(after)) => (after - before).norm(),
                    _ => 0.0,
                };
                detours.push((to(before) + to(after) - direct, s, at, [before, after]));
            }
        }
        detours.sort_by(|a, b| a.0.total_cmp(&b.0));
        let possible = detours
            .into_iter()
            .take(TRIED_DETOURS)
            .find(|(.., beside)| {
                let mut beside = beside.iter().flatten();
                beside.all(|&other| self.ways.is_clear_between(other, place))
            });
        let Some((_, stroke, at, _)) = possible else {
            let heading = turned.unwrap_or(0.0);
            let angle = std::f64::consts::TAU * self.random.random::<f64>();
            let aside = Vector2::new(libm::cos(angle), libm::sin(angle)) * DAB;
            let dab = [place, place + aside].map(|place| PlanarPose::new(place, heading));
            let at = self.random.random_range(0..=draft.strokes.len());
            draft.strokes.insert(at, dab.to_vec());
            return Some(vec![at]);
        };
        let poses = &mut draft.strokes[stroke];
        let beside = poses[at.min(poses.len() - 1)].heading;
        let heading = beside + turned.map_or(0.0, |turned| wrap_angle(turned - beside));
        poses.insert(at, PlanarPose::new(place, heading));
        Some(vec![stroke])
    }

    /// Reverses the order of some poses (2-opt).
    fn reverse(&mut self, draft: &mut Draft) -> Option<Vec<usize>> {
        let stroke = self.random_index(draft.strokes.len())?;
        let poses = &mut draft.strokes[stroke];
        let a = self.random.random_range(0..poses.len());
        let b = self.random.random_range(0..poses.len());
        let (first, last) = (a.min(b), a.max(b));
        if first == last {
            return None;
        }
        poses[first..=last].reverse();
        Some(vec![stroke])
    }

    /// Cuts a stroke in two.
    fn cut(&mut self, draft: &mut Draft) -> Option<Vec<usize>> {
        let stroke = self.random_index(draft.strokes.len())?;
        if draft.strokes[stroke].len() < 4 {
            return None;
        }
        let at = self.random.random_range(2..draft.strokes[stroke].len() - 1);
        let rest = draft.strokes[stroke].split_off(at);
        draft.strokes.insert(stroke + 1, rest);
        Some(Vec::new())
    }

    /// Joins two consecutive strokes.
    fn join(&mut self, draft: &mut Draft) -> Option<Vec<usize>> {
        let stroke = self.random_index(draft.strokes.len().saturating_sub(1))?;
        let mut next = draft.strokes.remove(stroke + 1);
        let poses = &mut draft.strokes[stroke];
        // The present heading, up to whole turns.
        let heading = poses.last()?.heading;
        let turns = heading + wrap_angle(next[0].heading - heading) - next[0].heading;
        next.iter_mut().for_each(|pose| pose.heading += turns);
        poses.extend(next);
        Some(vec![stroke])
    }

    /// Replaces two strokes by one straight stroke, from the start of the first to the end of the second.
    fn straighten(&mut self, draft: &mut Draft) -> Option<Vec<usize>> {
        let stroke = self.random_index(draft.strokes.len().saturating_sub(1))?;
        let next = draft.strokes.remove(stroke + 1);
        let mut poses = vec![*draft.strokes[stroke].first()?, *next.last()?];
        align_to_motion(&mut poses);
        draft.strokes[stroke] = poses;
        Some(vec![stroke])
    }

    /// Moves the goal of a collect whose goal the planner may choose.
    fn move_goal(&mut self, draft: &mut Draft) -> Option<Vec<usize>> {
        let step = self.step();
        let GoalState::Collected { center, .. } = &mut draft.goal else {
            return None;
        };
        *center += step;
        let center = *center;
        self.space.is_free(center).then(Vec::new)
    }
}

/// Whether a place is within [`AVOIDED`] of a place to avoid.
fn is_near(avoid: &[Point2], place: Point2) -> bool {
    avoid.iter().any(|other| (place - other).norm() < AVOIDED)
}

/// Returns a stroke's edges as separate strokes, each with the broad side of the tool across it.
fn split_into_edges(poses: &[PlanarPose]) -> Vec<Vec<PlanarPose>> {
    let edges = poses.windows(2).map(|pair| {
        let mut edge = pair.to_vec();
        align_to_motion(&mut edge);
        edge
    });
    edges.collect()
}

/// Turns every pose of a stroke towards the next pose; the last pose keeps the heading before it.
fn align_to_motion(poses: &mut [PlanarPose]) {
    let mut heading = None;
    for i in 0..poses.len() {
        if let Some(next) = poses.get(i + 1) {
            let along = next.position - poses[i].position;
            if along.norm() > 1e-9 {
                let wanted = libm::atan2(along.y, along.x);
                let near: f64 = heading.unwrap_or(wanted);
                heading = Some(near + wrap_angle(wanted - near));
            }
        }
        if let Some(heading) = heading {
            poses[i].heading = heading;
        }
    }
}
