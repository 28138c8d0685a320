//! Lanes: a surface is treated in parallel strips as wide as the tool, gone over to and fro; the policy of actions that treat.
//!
//! The tool keeps its heading: its broad side stays across the lanes. Where a lane ends at the surface's border, the tool
//! goes on over it as far as it stays carried. Before a hole it stops with its centre on the border: nothing is pressed over a
//! hole.

use super::objective::objective;
use super::{
    FreeSpace, MAX_NODES, Node, NodeRole, Plan, PlanConfig, PlanError, SemanticDirectedGraph,
    Strategy, Stroke,
};
use crate::geometry::{PlanarPose, Point2, Vector2};
use crate::represent::{Action, Fate, GoalState, Ground, Task, Treatment};
use std::f64::consts::FRAC_PI_2;

/// How far beyond the border the tool centre point may go, over the tool's length along the lane [1]: a quarter of the tool
/// still lies on the surface, and keeps it from tipping.
const OVERHANG: f64 = 0.25;
/// Nodes of a lane are no farther apart than this, over the radius of the collision sphere [1].
const NODE_PITCH: f64 = 2.0;
/// A pass is left out if it would give more passes than are allowed to more places than this share of those that it mends
/// [1]: what lies in the overlap with a lane beside it.
const MOST_EXCEEDED: f64 = 0.25;
/// Strips that are missing by rounding alone [1].
const ROUNDING: f64 = 1e-9;
/// How far before the border of a hole a lane ends [m].
const HOLE_MARGIN: f64 = 1e-5;
/// Halvings until the end of a lane is as exact as is of use: to a micrometre.
const HALVINGS: usize = 20;

/// Lanes along x or y of the surface, whichever are predicted to do better, or else are shorter, over all places of the task's
/// dirt that are not done.
pub(super) fn lanes(
    task: &Task,
    space: &FreeSpace,
    config: &PlanConfig,
) -> Result<Plan, PlanError> {
    let Some(goal) = task.goal() else {
        return Err(PlanError::NoTreatment {
            action: task.action,
        });
    };
    let directions = [0.0, FRAC_PI_2]
        .map(|heading| Lanes::new(task, space, goal, heading, config.search.margin_m));
    if let Some(count) = (directions.iter().map(Lanes::most_nodes)).find(|&most| most > MAX_NODES) {
        return Err(PlanError::TooManyNodes {
            surface: task.surface.name.clone(),
            count,
            pitch: NODE_PITCH * space.radius(),
            advice: "take a wider tool, fewer passes or a part of the surface",
        });
    }
    let plans = directions.map(|lanes| assembled(task, space, goal, config, lanes.strokes()));
    let [along_x, along_y] = plans;
    let [x, y] = [&along_x, &along_y].map(|plan| (objective(task, plan), plan.contact_distance()));
    let is_along_y = y.0 > x.0 || y.0 == x.0 && y.1 < x.1;
    let best = if is_along_y { along_y } else { along_x };
    if best.strokes.is_empty() && !task.particles.is_empty() {
        return Err(PlanError::NoFreeNode {
            surface: task.surface.name.clone(),
            diameter: 2.0 * space.radius(),
        });
    }
    Ok(best)
}

/// A place that is not done, in the frame of the lanes.
#[derive(Debug, Clone, Copy)]
struct Open {
    along: f64,
    across: f64,
    /// Passes that it needs.
    missing: u32,
}

/// Lanes of one direction.
struct Lanes<'a> {
    space: &'a FreeSpace,
    heading: f64,
    /// Length and width of the tool [m].
    tool: Vector2,
    /// Distance between lanes at most, and whether they fill it exactly.
    strip: f64,
    /// Whether places may have more passes than they need: then lanes overlap, and their ends are gone over again.
    is_lenient: bool,
    open: Vec<Open>,
    /// All places of the surface: along and across, and the passes that each may still have.
    room: Vec<([f64; 2], f64)>,
    start: Point2,
}

impl<'a> Lanes<'a> {
    fn new(task: &Task, space: &'a FreeSpace, goal: GoalState, heading: f64, margin: f64) -> Self {
        let size =
            (task.tool.footprint.bounds()).map_or(task.tool.area_of_effect, |bounds| bounds.size());
        let is_lenient = task.action == Action::Polish;
        // As wide as it is sure to be gone over if the tool is a little off its way.
        let strip = if is_lenient {
            (size.y - 2.0 * margin).max(size.y / 2.0)
        } else {
            size.y
        };
        let to_lanes = PlanarPose::new(Point2::origin(), heading);
        let open = places_of(task).map(|(place, fate)| {
            let there = to_lanes.inverse_transform(place);
            Open {
                along: there.x,
                across: there.y,
                missing: goal.missing_passes(fate.passes()),
            }
        });
        let most = match task.treatment {
            Some(Treatment::Polish { max_passes, .. }) => f64::from(max_passes),
            _ => f64::INFINITY,
        };
        let room = places_of(task).map(|(place, fate)| {
            let there = to_lanes.inverse_transform(place);
            ([there.x, there.y], most - fate.passes())
        });
        Self {
            space,
            heading,
            tool: size,
            strip,
            is_lenient,
            open: open.filter(|open| open.missing > 0).collect(),
            room: room.collect(),
            start: to_lanes.inverse_transform(task.tool_start),
        }
    }

    /// Where the lanes run, across them, in the order in which they are gone over [m].
    fn middles(&self) -> Vec<f64> {
        let across = self.open.iter().map(|open| open.across);
        let (low, high) = across.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| {
            (low.min(at), high.max(at))
        });
        if low > high {
            return Vec::new();
        }
        let most = self.open.iter().map(|open| open.missing).max().unwrap_or(0);
        // Lanes that overlap are shifted from pass to pass, and cover the borders all the same.
        let reach = match self.is_lenient {
            true => 2.0 * self.shift(1, most).abs(),
            false => 0.0,
        };
        let lanes = (high - low + reach) / self.strip;
        let count = (lanes - ROUNDING).ceil().max(1.0);
        let pitch = self.strip;
        let first = (low + high) / 2.0 - pitch * (count - 1.0) / 2.0;
        let mut middles: Vec<f64> = (0..count as usize)
            .map(|i| first + pitch * i as f64)
            .collect();
        if (self.start.y - low).abs() > (self.start.y - high).abs() {
            middles.reverse();
        }
        middles
    }

    /// How many nodes the lanes have at most.
    fn most_nodes(&self) -> usize {
        let extent = |of: fn(&Open) -> f64| {
            let all = self.open.iter().map(of);
            let (low, high) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| {
                (low.min(at), high.max(at))
            });
            (high - low).max(0.0)
        };
        let lanes = (extent(|open| open.across) / self.strip).ceil().max(1.0);
        let length = extent(|open| open.along) + self.tool.x;
        let of_lane = (length / (NODE_PITCH * self.space.radius())).ceil() + 1.0;
        let passes = self.open.iter().map(|open| open.missing).max().unwrap_or(0);
        (lanes * of_lane * f64::from(passes)) as usize
    }

    /// For each lane the places that it goes over: a place belongs to the nearest lane, of two equally near ones to the first.
    fn places_by_lane(&self, middles: &[f64]) -> Vec<Vec<Open>> {
        let mut by_lane = vec![Vec::new(); middles.len()];
        let pitch = middles.get(1).map_or(1.0, |second| second - middles[0]);
        for open in &self.open {
            let about = ((open.across - middles[0]) / pitch).round() as usize;
            let near = about.saturating_sub(1)..(about + 2).min(middles.len());
            let distance = |lane: usize| (open.across - middles[lane]).abs();
            let nearest = near.min_by(|&a, &b| distance(a).total_cmp(&distance(b)));
            if let Some(lane) = nearest.filter(|&lane| distance(lane) <= self.tool.y / 2.0) {
                by_lane[lane].push(*open);
            }
        }
        by_lane
    }

    /// How far across its lane a pass of several is shifted [m]: by the width in which lanes overlap, so that what one pass
    /// goes over twice, the next goes over once.
    fn shift(&self, pass: u32, passes: u32) -> f64 {
        let overlap = self.tool.y - self.strip;
        if !self.is_lenient || overlap <= 0.0 {
            return 0.0;
        }
        // As many shifts as there is room for in a strip.
        let many = (self.strip / overlap).floor().max(1.0) as u32;
        let last = passes.min(many).saturating_sub(1);
        overlap * (f64::from((pass.max(1) - 1) % many) - f64::from(last) / 2.0)
    }

    /// The tool's poses, stroke by stroke.
    fn strokes(mut self) -> Vec<Vec<PlanarPose>> {
        let middles = self.middles();
        let places = self.places_by_lane(&middles);
        let mut strokes: Vec<Vec<PlanarPose>> = Vec::new();
        let mut at = self.start.x;
        for (&across, mut of_lane) in middles.iter().zip(places) {
            let surface = self.space.surface();
            let is_carried = |at| !matches!(surface.ground(at), Ground::Hole(_));
            of_lane.retain(|open| {
                let at = self.in_surface(open.along, across);
                self.space.is_clear(at) && is_carried(at)
            });
            of_lane.sort_by(|a, b| a.along.total_cmp(&b.along));
            let mut runs: Vec<&[Open]> = of_lane
                .chunk_by(|a, b| self.goes_on(a.along, b.along, across))
                .collect();
            let [first, last] = [of_lane.first(), of_lane.last()].map(|open| open.map(|o| o.along));
            let is_backward = match (first, last) {
                (Some(first), Some(last)) => (at - first).abs() > (at - last).abs(),
                _ => continue,
            };
            if is_backward {
                runs.reverse();
            }
            for run in runs {
                for way in self.ways(run, across, is_backward) {
                    at = way.last().map_or(at, |turn| turn[0]);
                    strokes.push(self.poses(&way));
                }
            }
        }
        strokes
    }

    /// Whether a lane goes on from one place to the next.
    fn goes_on(&self, from: f64, to: f64, across: f64) -> bool {
        let [a, b] = [from, to].map(|along| self.in_surface(along, across));
        to - from <= 2.0 * self.space.radius() && self.space.is_clear_between(a, b)
    }

    /// The turning points of the tool, along and across [m], stroke by stroke: to and fro until no place of the run needs more,
    /// or until one would have more than it may.
    fn ways(&mut self, run: &[Open], across: f64, is_backward: bool) -> Vec<Vec<[f64; 2]>> {
        let most = run.iter().map(|open| open.missing).max().unwrap_or(0);
        let mut ways: Vec<Vec<[f64; 2]>> = Vec::new();
        let mut whole: Vec<[f64; 2]> = Vec::new();
        for pass in 1..=most {
            let mut needy = run.iter().filter(|open| open.missing >= pass);
            let mended = needy.clone().count();
            let Some(first) = needy.next() else { break };
            let last = needy.next_back().unwrap_or(first);
            let across = self.shifted(run, across, pass, most);
            let mut ends = [
                self.end(first.along, across, -1.0),
                self.end(last.along, across, 1.0),
            ];
            if !self.passes_over([ends[0].place, ends[1].place], across, mended) {
                break;
            }
            if is_backward != (pass % 2 == 0) {
                ends.reverse();
            }
            let [begin, end] = ends;
            if self.is_lenient {
                let [again, anew] = [begin, end].map(|end| end.place + end.again);
                let turns = [again, begin.place, end.place, anew];
                whole.extend(turns.map(|along| [along, across]));
            } else {
                ways.push(vec![[begin.place, across], [end.place, across]]);
            }
        }
        whole.dedup();
        ways.extend((!whole.is_empty()).then_some(whole));
        ways
    }

    /// Where a pass goes across [m]: shifted, unless it would then meet what the lane itself keeps clear of.
    fn shifted(&self, run: &[Open], across: f64, pass: u32, passes: u32) -> f64 {
        let shifted = across + self.shift(pass, passes);
        let at = |open: &Open| self.in_surface(open.along, shifted);
        let is_clear = run.iter().all(|open| self.space.is_clear(at(open)))
            && (run.windows(2)).all(|pair| self.space.is_clear_between(at(&pair[0]), at(&pair[1])));
        if is_clear { shifted } else { across }
    }

    /// Counts a pass over what lies under the tool, unless it mends little for what would have more than it may; whether it
    /// is counted.
    fn passes_over(&mut self, [from, to]: [f64; 2], across: f64, mended: usize) -> bool {
        let half = self.tool / 2.0;
        let is_under = |[x, y]: [f64; 2]| {
            (y - across).abs() < half.y && (from - half.x..=to + half.x).contains(&x)
        };
        // What counts as a pass is slid over by half of one.
        let is_full = |(place, room): &([f64; 2], f64)| is_under(*place) && *room < 0.5;
        let full = self.room.iter().filter(|place| is_full(place)).count();
        if full as f64 > MOST_EXCEEDED * mended as f64 {
            return false;
        }
        for (place, room) in &mut self.room {
            if is_under(*place) {
                *room -= 1.0;
            }
        }
        true
    }

    /// Where a lane ends whose last place is here, towards one side (1 or -1): where the tool has left that place, or as far as
    /// it may go.
    fn end(&self, last: f64, across: f64, side: f64) -> LaneEnd {
        let half = self.tool.x / 2.0;
        let surface = &self.space.surface().outline;
        let may_go = |beyond: f64| {
            let carried = (beyond - OVERHANG * self.tool.x).max(0.0);
            let at = |way: f64| self.in_surface(last + side * way, across);
            surface.contains(at(carried)) && self.space.is_clear_between(at(0.0), at(beyond))
        };
        let (mut least, mut most) = (0.0, half);
        if may_go(half) {
            least = half;
        } else {
            for _ in 0..HALVINGS {
                let middle = (least + most) / 2.0;
                if may_go(middle) {
                    least = middle;
                } else {
                    most = middle;
                }
            }
        }
        if !surface.holes().is_empty() {
            least = (least - HOLE_MARGIN).max(0.0);
        }
        LaneEnd {
            place: last + side * least,
            again: -side * (half - least),
        }
    }

    fn poses(&self, way: &[[f64; 2]]) -> Vec<PlanarPose> {
        let pitch = NODE_PITCH * self.space.radius();
        let mut poses: Vec<PlanarPose> = Vec::new();
        let mut push = |[along, across]: [f64; 2]| {
            poses.push(PlanarPose::new(
                self.in_surface(along, across),
                self.heading,
            ));
        };
        way.iter().take(1).for_each(|&first| push(first));
        for leg in way.windows(2) {
            let change = [leg[1][0] - leg[0][0], leg[1][1] - leg[0][1]];
            let parts = (change[0].hypot(change[1]) / pitch).ceil().max(1.0);
            for part in 1..=parts as usize {
                let share = part as f64 / parts;
                push([leg[0][0] + change[0] * share, leg[0][1] + change[1] * share]);
            }
        }
        poses
    }

    fn in_surface(&self, along: f64, across: f64) -> Point2 {
        PlanarPose::new(Point2::origin(), self.heading).transform(Point2::new(along, across))
    }
}

/// The places of the task's surface, with what was done to each.
fn places_of(task: &Task) -> impl Iterator<Item = (Point2, Fate)> + '_ {
    let places = task.particles.iter();
    places.filter(|(_, fate)| fate.is_on_surface())
}

/// Where a lane ends, along it [m].
#[derive(Debug, Clone, Copy)]
struct LaneEnd {
    place: f64,
    /// How far back, and forth again, the tool goes so that the last place is slid over as long as the others.
    again: f64,
}

/// The plan of strokes with these poses, each a node of its own.
fn assembled(
    task: &Task,
    space: &FreeSpace,
    goal: GoalState,
    config: &PlanConfig,
    strokes: Vec<Vec<PlanarPose>>,
) -> Plan {
    let mut nodes: Vec<Node> = Vec::new();
    let mut edges = Vec::new();
    let strokes = strokes.into_iter().map(|poses| {
        let first = nodes.len();
        nodes.extend(poses.iter().map(|pose| Node {
            position: pose.position,
            role: NodeRole::Coverage,
        }));
        edges.extend((first + 1..nodes.len()).map(|to| (to - 1, to)));
        Stroke {
            nodes: (first..nodes.len()).collect(),
            poses,
        }
    });
    let strokes = strokes.collect();
    Plan {
        strategy: Strategy::Lanes,
        strokes,
        graph: SemanticDirectedGraph {
            nodes,
            edges,
            goal,
            max_edge_length: None,
            unreachable: Vec::new(),
        },
        collision_radius: space.radius(),
        unreachable_share: 0.0,
        tool_start: task.tool_start,
        lift_height: config.lift_height,
    }
}
