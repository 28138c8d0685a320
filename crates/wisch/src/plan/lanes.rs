//! Lanes: the tool treats a surface in parallel strips of its own width, to and fro. This is the policy of
//! actions that treat the surface.
//!
//! The tool keeps its heading: its broad side stays across the lanes. Where a lane ends at the surface's
//! border, the tool moves over the border while the surface still carries it. Before a hole it stops with its
//! centre on the border, so that its centre is never pressed over a hole.

use super::bend::partial_contact;
use super::objective::objective;
use super::{
    FreeSpace, MAX_NODES, Node, NodeRole, Plan, PlanConfig, PlanError, SemanticDirectedGraph,
    Strategy, Stroke,
};
use crate::geometry::{PlanarPose, Point2, Vector2};
use crate::represent::{Action, Fate, GoalState, SurfaceShape, Task, Treatment};
use std::f64::consts::FRAC_PI_2;

/// Distance of the tool centre point beyond the border at most, over the tool's length along the lane [1]. A
/// quarter of the tool then still lies on the surface and keeps it from tipping.
const OVERHANG: f64 = 0.25;
/// Largest distance between nodes of a lane, over the radius of the collision sphere [1].
const NODE_PITCH: f64 = 2.0;
/// A pass is left out if the number of places to which it gives too many passes exceeds this share
/// of the places that need it [1]. Such places lie in the overlap with a neighbouring lane.
const MOST_EXCEEDED: f64 = 0.25;
/// Lanes that only rounding would add [1].
const ROUNDING: f64 = 1e-9;
/// Distance from the border of a hole at which a lane ends [m].
const HOLE_MARGIN: f64 = 1e-5;
/// Sine of the angle below which two directions of lanes are the same [1].
const SAME_DIRECTION: f64 = 1e-9;
/// Distances by which a lane is shifted to reach places beside a slanted border, over half of the tool's width [1].
const SHIFTS_INSIDE: [f64; 6] = [0.25, -0.25, 0.5, -0.5, 0.75, -0.75];
/// Number of halvings in the search for the end of a lane: exact to a micrometre.
const HALVINGS: usize = 20;

/// Plans lanes over all places that still need treatment, along x or y of the surface. If only a
/// part of the tool acts on a bend, lanes along the bend and across it are also tried. The
/// direction with the best predicted effect is taken; of equal directions, the one with the
/// shortest path.
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
    if let GoalState::Dispensed {
        thickness,
        per_pass,
    } = goal
        && goal.missing_passes(0.0) == 0
    {
        return Err(PlanError::CoatTooThin {
            thickness,
            per_pass,
        });
    }
    let directions: Vec<Lanes<'_>> = (headings(task).into_iter())
        .map(|heading| Lanes::new(task, space, goal, heading, config.search.margin_m))
        .collect();
    if let Some(count) = (directions.iter().map(Lanes::max_nodes)).find(|&most| most > MAX_NODES) {
        return Err(PlanError::TooManyNodes {
            surface: task.surface.name.clone(),
            count,
            pitch: NODE_PITCH * space.radius(),
            advice: "take a wider tool, fewer passes or a smaller surface",
        });
    }
    let plans = directions.into_iter().map(|lanes| {
        let plan = assemble_plan(task, space, goal, config, lanes.strokes());
        (objective(task, &plan), plan.contact_distance(), plan)
    });
    let best = plans.reduce(|best, next| {
        let is_better = next.0 > best.0 || next.0 == best.0 && next.1 < best.1;
        if is_better { next } else { best }
    });
    let (_, _, best) = best.expect("there are two directions");
    if best.strokes.is_empty() && !task.particles.is_empty() {
        return Err(space.explain_no_free_node());
    }
    Ok(best)
}

/// The headings along which lanes may run [rad].
fn headings(task: &Task) -> Vec<f64> {
    let mut headings = vec![0.0, FRAC_PI_2];
    let axis = match &task.surface.shape {
        SurfaceShape::Plane => None,
        SurfaceShape::Cylinder { axis, .. } => Some(*axis),
        // Across the largest curvature of the tightest bend.
        SurfaceShape::Cone(_) | SurfaceShape::Mesh(_) => {
            let bend = task.surface.tightest_bend();
            Some(0.5 * libm::atan2(-2.0 * bend[(0, 1)], bend[(1, 1)] - bend[(0, 0)]))
        }
    };
    if let Some(axis) = axis {
        for heading in [axis, axis + FRAC_PI_2] {
            let is_new =
                (headings.iter()).all(|one| libm::sin(heading - one).abs() > SAME_DIRECTION);
            let is_partial = (headings.iter().chain([&heading]))
                .any(|&heading| partial_contact(task, heading).is_some());
            if is_new && is_partial {
                headings.push(heading);
            }
        }
    }
    headings
}

/// A place that still needs passes, in the frame of the lanes.
#[derive(Debug, Clone, Copy)]
struct UntreatedPlace {
    along: f64,
    across: f64,
    /// Number of passes that it still needs.
    missing: u32,
}

/// Lanes of one direction.
struct Lanes<'a> {
    space: &'a FreeSpace,
    heading: f64,
    /// Length and width of the tool, along and across the lanes [m].
    tool: Vector2,
    /// Largest distance between lanes [m].
    strip: f64,
    /// Whether places may have more passes than they need: then lanes overlap, and the tool repeats their ends.
    is_lenient: bool,
    open: Vec<UntreatedPlace>,
    /// All places of the surface: along and across [m], and the number of passes that each may still have.
    passes_left: Vec<([f64; 2], f64)>,
    start: Point2,
}

impl<'a> Lanes<'a> {
    fn new(task: &Task, space: &'a FreeSpace, goal: GoalState, heading: f64, margin: f64) -> Self {
        let mut size =
            (task.tool.footprint.bounds()).map_or(task.tool.area_of_effect, |bounds| bounds.size());
        // In a hollow, the tool acts with its ends: each end treats a strip as wide as a lane,
        // beside the lane.
        let acting = partial_contact(task, heading)
            .map(|(tool, pressure, least)| tool.acting_width(&pressure, least));
        if let Some(width) = acting.filter(|&width| width > 0.0) {
            size.y = size.y.min(width);
        }
        let is_lenient = task.action == Action::Polish;
        // The strip that the tool covers even with a lateral error of `margin`: w − 2 m, at least w / 2.
        let strip = if is_lenient {
            (size.y - 2.0 * margin).max(size.y / 2.0)
        } else {
            size.y
        };
        let to_lanes = PlanarPose::new(Point2::origin(), heading);
        let open = places_of(task).map(|(place, fate)| {
            let there = to_lanes.inverse_transform(place);
            UntreatedPlace {
                along: there.x,
                across: there.y,
                missing: goal.missing_passes(fate.passes()),
            }
        });
        let most = match task.treatment {
            Some(Treatment::Polish { max_passes, .. }) => f64::from(max_passes),
            _ => f64::INFINITY,
        };
        let passes_left = places_of(task).map(|(place, fate)| {
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
            passes_left: passes_left.collect(),
            start: to_lanes.inverse_transform(task.tool_start),
        }
    }

    /// Returns the coordinates of the lanes across their direction, in the order of execution [m].
    fn middles(&self) -> Vec<f64> {
        let across = self.open.iter().map(|open| open.across);
        let (low, high) = across.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| {
            (low.min(at), high.max(at))
        });
        if low > high {
            return Vec::new();
        }
        let most = self.open.iter().map(|open| open.missing).max().unwrap_or(0);
        // Overlapping lanes shift from pass to pass, and must still cover the borders.
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

    /// Upper bound of the number of nodes of all lanes.
    fn max_nodes(&self) -> usize {
        let extent = |of: fn(&UntreatedPlace) -> f64| {
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

    /// Returns for each lane its places: each place belongs to the nearest lane, of two equally near lanes to
    /// the first.
    fn places_by_lane(&self, middles: &[f64]) -> Vec<Vec<UntreatedPlace>> {
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

    /// Lateral shift of a pass [m]: the width by which lanes overlap. A place that one pass covers
    /// twice is then covered once by the next pass.
    fn shift(&self, pass: u32, passes: u32) -> f64 {
        let overlap = self.tool.y - self.strip;
        if !self.is_lenient || overlap <= 0.0 {
            return 0.0;
        }
        // As many shifts as fit into a strip.
        let many = (self.strip / overlap).floor().max(1.0) as u32;
        let last = passes.min(many).saturating_sub(1);
        overlap * (f64::from((pass.max(1) - 1) % many) - f64::from(last) / 2.0)
    }

    /// Returns the tool's poses, stroke by stroke.
    fn strokes(mut self) -> Vec<Vec<PlanarPose>> {
        let middles = self.middles();
        let places = self.places_by_lane(&middles);
        let mut strokes: Vec<Vec<PlanarPose>> = Vec::new();
        let mut at = self.start.x;
        for (&across, of_lane) in middles.iter().zip(places) {
            let is_carried = |open: &UntreatedPlace| self.supports([open.along, across]);
            let (of_lane, beside): (Vec<_>, Vec<_>) = of_lane.into_iter().partition(is_carried);
            self.treat(of_lane, across, &mut at, &mut strokes);
            // Beside a slanted border, the middle of the lane is beyond it: the tool passes farther inside.
            if let Some((across, of_lane)) = self.lane_inside(&beside, across) {
                self.treat(of_lane, across, &mut at, &mut strokes);
            }
        }
        strokes
    }

    /// Returns a lane beside the one at `across` that reaches most of these places, with them; `None` if none is reached.
    fn lane_inside(
        &self,
        places: &[UntreatedPlace],
        across: f64,
    ) -> Option<(f64, Vec<UntreatedPlace>)> {
        let half = self.tool.y / 2.0;
        let shifted = SHIFTS_INSIDE.map(|shift| {
            let across = across + shift * half;
            let is_reached = |open: &&UntreatedPlace| {
                (open.across - across).abs() <= half && self.supports([open.along, across])
            };
            (across, places.iter().filter(is_reached).copied().collect())
        });
        let reached = |lane: &(f64, Vec<UntreatedPlace>)| lane.1.len();
        let best = shifted.into_iter().rev().max_by_key(reached)?;
        (!best.1.is_empty()).then_some(best)
    }

    /// Adds the strokes of the lane at `across` over these places. `at`: the tool's coordinate along the lanes [m].
    fn treat(
        &mut self,
        mut of_lane: Vec<UntreatedPlace>,
        across: f64,
        at: &mut f64,
        strokes: &mut Vec<Vec<PlanarPose>>,
    ) {
        of_lane.retain(|open| self.space.is_clear(self.in_surface(open.along, across)));
        of_lane.sort_by(|a, b| a.along.total_cmp(&b.along));
        let mut runs: Vec<&[UntreatedPlace]> = of_lane
            .chunk_by(|a, b| self.is_continuous(a.along, b.along, across))
            .collect();
        let (Some(first), Some(last)) = (of_lane.first(), of_lane.last()) else {
            return;
        };
        let is_backward = (*at - first.along).abs() > (*at - last.along).abs();
        if is_backward {
            runs.reverse();
        }
        for run in runs {
            for way in self.turning_points(run, across, is_backward) {
                *at = way.last().map_or(*at, |turn| turn[0]);
                strokes.push(self.poses(&way));
            }
        }
    }

    /// Whether a lane continues from one place to the next.
    fn is_continuous(&self, from: f64, to: f64, across: f64) -> bool {
        to - from <= 2.0 * self.space.radius() && self.may_move([from, across], [to, across])
    }

    /// Whether the tool may be pressed with its centre at these coordinates along and across the lanes [m], as far as
    /// the surface carries it.
    fn supports(&self, [along, across]: [f64; 2]) -> bool {
        let at = self.in_surface(along, across);
        let surface = self.space.surface();
        surface.supports_between(at, at, OVERHANG * self.tool.x)
    }

    /// Whether the tool may move straight between these coordinates along and across the lanes [m]: the surface carries
    /// it, and it touches nothing.
    fn may_move(&self, from: [f64; 2], to: [f64; 2]) -> bool {
        let [from, to] = [from, to].map(|[along, across]| self.in_surface(along, across));
        let surface = self.space.surface();
        self.space.is_clear_between(from, to)
            && surface.supports_between(from, to, OVERHANG * self.tool.x)
    }

    /// Returns the turning points of the tool, along and across [m], stroke by stroke. The tool moves to and
    /// fro until no place of the run needs more passes, or until a place would have more than it may.
    fn turning_points(
        &mut self,
        run: &[UntreatedPlace],
        across: f64,
        is_backward: bool,
    ) -> Vec<Vec<[f64; 2]>> {
        let most = run.iter().map(|open| open.missing).max().unwrap_or(0);
        let mut ways: Vec<Vec<[f64; 2]>> = Vec::new();
        let mut whole: Vec<[f64; 2]> = Vec::new();
        for pass in 1..=most {
            let mut needy = run.iter().filter(|open| open.missing >= pass);
            let mended = needy.clone().count();
            let Some(first) = needy.next() else { break };
            let last = needy.next_back().unwrap_or(first);
            let across = self.pass_coordinate(run, across, pass, most);
            let mut ends = [
                self.end(first.along, across, -1.0),
                self.end(last.along, across, 1.0),
            ];
            if !self.count_pass([ends[0].place, ends[1].place], across, mended) {
                break;
            }
            if is_backward != (pass % 2 == 0) {
                ends.reverse();
            }
            let [begin, end] = ends;
            if self.is_lenient {
                let [again, anew] = [begin, end].map(|end| self.repeat_end(end, across));
                let turns = [again, begin.place, end.place, anew];
                let turns = turns.map(|along| [along, across]);
                // Lifted where it cannot slide over to the next pass.
                if (whole.last()).is_some_and(|&last| !self.may_move(last, turns[0])) {
                    whole.dedup();
                    ways.push(std::mem::take(&mut whole));
                }
                whole.extend(turns);
            } else {
                ways.push(vec![[begin.place, across], [end.place, across]]);
            }
        }
        whole.dedup();
        ways.extend((!whole.is_empty()).then_some(whole));
        ways
    }

    /// Returns the coordinate of a pass across the lane [m]: shifted, unless the shifted pass would meet an
    /// obstacle or leave the surface.
    fn pass_coordinate(&self, run: &[UntreatedPlace], across: f64, pass: u32, passes: u32) -> f64 {
        let shifted = across + self.shift(pass, passes);
        let at = |open: &UntreatedPlace| [open.along, shifted];
        let is_possible = run.iter().all(|open| self.may_move(at(open), at(open)))
            && (run.windows(2)).all(|pair| self.may_move(at(&pair[0]), at(&pair[1])));
        if is_possible { shifted } else { across }
    }

    /// Counts a pass over the places under the tool. If the pass serves few places and gives too
    /// many passes to others, it is not counted, and the result is false.
    fn count_pass(&mut self, [from, to]: [f64; 2], across: f64, mended: usize) -> bool {
        let half = self.tool / 2.0;
        let is_under = |[x, y]: [f64; 2]| {
            (y - across).abs() < half.y && (from - half.x..=to + half.x).contains(&x)
        };
        // Sliding over half of the tool counts as a pass.
        let is_full =
            |(place, passes_left): &([f64; 2], f64)| is_under(*place) && *passes_left < 0.5;
        let full = self
            .passes_left
            .iter()
            .filter(|place| is_full(place))
            .count();
        if full as f64 > MOST_EXCEEDED * mended as f64 {
            return false;
        }
        for (place, passes_left) in &mut self.passes_left {
            if is_under(*place) {
                *passes_left -= 1.0;
            }
        }
        true
    }

    /// Returns the end of a lane whose last place is at `last`, on one side (1 or −1): where the tool has left
    /// that place, or at the limit of its motion.
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

    /// Returns the coordinate along the lane to which the tool moves back at an end, to repeat it [m]: no farther than the
    /// surface and the obstacles permit.
    fn repeat_end(&self, end: LaneEnd, across: f64) -> f64 {
        let at = |share: f64| end.place + share * end.again;
        let may_go = |share: f64| self.may_move([end.place, across], [at(share), across]);
        if may_go(1.0) {
            return at(1.0);
        }
        let (mut least, mut most) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = (least + most) / 2.0;
            if may_go(middle) {
                least = middle;
            } else {
                most = middle;
            }
        }
        at(least)
    }

    /// Returns the tool's poses along the turning points, in the surface frame, no farther apart than the node pitch.
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

    /// Transforms a point of the lanes' frame to the surface frame [m].
    fn in_surface(&self, along: f64, across: f64) -> Point2 {
        PlanarPose::new(Point2::origin(), self.heading).transform(Point2::new(along, across))
    }
}

/// Returns the places of the task's surface, with the treatment that each has had.
fn places_of(task: &Task) -> impl Iterator<Item = (Point2, Fate)> + '_ {
    let places = task.particles.iter();
    places.filter(|(_, fate)| fate.is_on_surface())
}

/// The end of a lane.
#[derive(Debug, Clone, Copy)]
struct LaneEnd {
    place: f64,
    /// Distance by which the tool moves back and forth again [m], so that it slides over the last
    /// place for as long as over any other place.
    again: f64,
}

/// Returns the plan of strokes with these poses; each pose becomes one node.
fn assemble_plan(
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
