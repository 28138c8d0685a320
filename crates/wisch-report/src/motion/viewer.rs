//! A motion as numbers for the page's 3-D view.

use super::input::{Contact, MotionInput};
use super::track::{MarkKind, SampledTrack};
use crate::scene::{Meshes, Solid, seven, tenth, vector};
use serde::Serialize;
use std::collections::BTreeMap;
use wisch::geometry::Point2;
use wisch::represent::ScenePart;
use wisch::robot::{Joint, JointKind, Link, LinkId, RobotModel, Shape};

/// Most triangles of all meshes together, and of one.
const MAX_TRIANGLES: usize = 12_000;
const MAX_TRIANGLES_OF_ONE: usize = 4_000;
/// Most particles of a frame, and of a frame of each track together.
const MAX_PARTICLES: usize = 1_500;
const MAX_PARTICLES_OF_ALL: usize = 9_000;
/// Most frames of particles in a track, and changes of particles over all frames of all tracks.
const MAX_PARTICLE_FRAMES: usize = 120;
const MAX_CHANGES: usize = 30_000;

/// What the view's script reads: the robot once, and each of its motions. Lengths in metres but for meshes, outlines
/// and particles, which come in tenths of a millimetre; positions of variables in 1e-5 rad or m; times since the
/// track's first frame [s]. Poses are written as in [`crate::scene`].
#[derive(Debug, Serialize)]
pub(crate) struct ViewerRecord<'a> {
    /// Joint i holds link i + 1.
    joints: Vec<JointRecord<'a>>,
    meshes: Meshes,
    links: Vec<LinkRecord>,
    tool: ToolRecord,
    tracks: Vec<TrackRecord<'a>>,
}

/// One motion, and where things are meanwhile.
#[derive(Debug, Serialize)]
struct TrackRecord<'a> {
    round: Option<usize>,
    period: f64,
    /// Number of frames.
    count: usize,
    /// Positions of all variables in the first frame.
    start: Vec<i64>,
    /// Variables that change, each with its steps from frame to frame.
    changes: Vec<(usize, Vec<i64>)>,
    /// Pose of the root link in the world.
    root: [f64; 7],
    scene: Vec<ObjectRecord>,
    surface: SurfaceRecord,
    phases: Vec<PhaseRecord<'a>>,
    marks: Vec<MarkRecord>,
    particles: Vec<ParticleStep>,
}

/// Time; indices in the frame before of particles that are gone; x, y of those that are new.
type ParticleStep = (f64, Vec<usize>, Vec<i64>);

#[derive(Debug, Serialize)]
struct JointRecord<'a> {
    parent: usize,
    pose: [f64; 7],
    axis: [f64; 3],
    kind: &'static str,
    offset: f64,
    terms: &'a [(usize, f64)],
}

#[derive(Debug, Serialize)]
struct LinkRecord {
    /// Whether it is of the arm that holds the tool.
    arm: bool,
    shapes: Vec<Solid>,
}

#[derive(Debug, Serialize)]
struct ToolRecord {
    link: usize,
    #[serde(flatten)]
    solid: Solid,
}

#[derive(Debug, Serialize)]
struct ObjectRecord {
    part: &'static str,
    #[serde(flatten)]
    solid: Solid,
}

#[derive(Debug, Serialize)]
struct SurfaceRecord {
    pose: [f64; 7],
    /// Where it was believed in the first track, if it is elsewhere.
    first: Option<[f64; 7]>,
    rings: Vec<Vec<[i64; 2]>>,
}

#[derive(Debug, Serialize)]
struct PhaseRecord<'a> {
    name: &'a str,
    start: f64,
    end: f64,
    contact: bool,
}

#[derive(Debug, Serialize)]
struct MarkRecord {
    name: &'static str,
    start: f64,
    end: f64,
    felt: bool,
}

impl<'a> ViewerRecord<'a> {
    /// The record of a robot's tracks, of which there is one at least, and what was left out of it for the sake of
    /// the page's size, in sentences. Robot and tool are those of the plan.
    pub(crate) fn new(
        plan: &MotionInput<'a>,
        tracks: &'a [SampledTrack<'a>],
    ) -> (Self, Vec<String>) {
        let robot = plan.robot;
        let mut meshes = Meshes::new(triangles_of_one(plan));
        let arm = arm(robot, plan.tool_link);
        let mut shapes = |link: &Link| {
            let shapes = link.collision.iter();
            let solids = shapes.map(|c| meshes.shape(&c.link_from_shape, &c.shape));
            solids.collect()
        };
        let links = (robot.links().iter().enumerate())
            .map(|(i, link)| LinkRecord {
                arm: arm.contains(&i),
                shapes: shapes(link),
            })
            .collect();
        let tool = ToolRecord {
            link: plan.tool_link.index(),
            solid: meshes.solid(&plan.link_from_tool, &plan.task.tool.mesh),
        };
        let share = ParticleShare::of(tracks);
        let first = &tracks[0];
        let tracks = tracks.iter();
        let record = Self {
            joints: robot.joints().iter().map(JointRecord::new).collect(),
            links,
            tool,
            tracks: tracks
                .map(|track| TrackRecord::new(track, first, &share, &mut meshes))
                .collect(),
            meshes,
        };
        let cuts = (record.meshes.cut().into_iter()).chain(share.cut());
        let cuts = cuts.collect();
        (record, cuts)
    }
}

impl<'a> TrackRecord<'a> {
    fn new(
        shown: &'a SampledTrack<'a>,
        first: &SampledTrack,
        share: &ParticleShare,
        meshes: &mut Meshes,
    ) -> Self {
        let (motion, frames) = (shown.track.motion, &shown.frames);
        let task = motion.task;
        let units = |q: &Vec<f64>| q.iter().map(|&q| (q * 1e5).round() as i64).collect();
        let q: Vec<Vec<i64>> = frames.q.iter().map(units).collect();
        let steps = |variable: usize| -> Vec<i64> {
            let pairs = q.windows(2).map(|two| two[1][variable] - two[0][variable]);
            pairs.collect()
        };
        let changes = (0..motion.robot.dof())
            .map(|variable| (variable, steps(variable)))
            .filter(|(_, steps)| steps.iter().any(|&step| step != 0));
        let scene = (task.scene.iter())
            .filter_map(|object| {
                let part = match object.part {
                    ScenePart::Obstacle => "obstacle",
                    ScenePart::Carrier => "carrier",
                    ScenePart::Robot | ScenePart::Tool => return None,
                };
                let solid = meshes.solid(&object.world_from_object, &object.mesh);
                Some(ObjectRecord { part, solid })
            })
            .collect();
        let since = |time: f64| rounded(time - frames.start);
        let rings = task.surface.outline.rings();
        let surface = SurfaceRecord {
            pose: seven(&task.surface.world_from_surface),
            first: (shown.surface_moved(first))
                .map(|_| seven(&first.track.motion.task.surface.world_from_surface)),
            rings: rings.map(|ring| ring.iter().map(flat).collect()).collect(),
        };
        Self {
            round: shown.track.round,
            period: frames.period,
            count: q.len(),
            start: q.first().cloned().unwrap_or_default(),
            changes: changes.collect(),
            root: seven(&motion.world_from_root),
            scene,
            surface,
            phases: (motion.phases.iter())
                .map(|phase| PhaseRecord {
                    name: &phase.name,
                    start: since(phase.start),
                    end: since(phase.end),
                    contact: phase.contact == Contact::Wiping,
                })
                .collect(),
            marks: (shown.track.marks.iter())
                .map(|mark| MarkRecord {
                    name: mark.name,
                    start: since(mark.times[0]),
                    end: since(mark.times[1]),
                    felt: mark.kind == MarkKind::Felt,
                })
                .collect(),
            particles: particles(motion, frames.start, share),
        }
    }
}

impl<'a> JointRecord<'a> {
    fn new(joint: &'a Joint) -> Self {
        Self {
            parent: joint.parent.index(),
            pose: seven(&joint.parent_from_joint),
            axis: vector(&joint.axis),
            kind: match joint.kind {
                JointKind::Fixed => "fixed",
                JointKind::Revolute => "revolute",
                JointKind::Prismatic => "prismatic",
            },
            offset: joint.drive.offset,
            terms: &joint.drive.terms,
        }
    }
}

/// The links of the arm: what hangs on the last fork before the tool, tool side. A fork is a link
/// that also carries something else that moves by itself.
fn arm(robot: &RobotModel, tool_link: LinkId) -> Vec<usize> {
    let holder = |link: usize| {
        robot.links()[link]
            .parent
            .map(|id| &robot.joints()[id.index()])
    };
    // Whether a variable moves something at or beyond a link.
    let mut moves = vec![false; robot.links().len()];
    for joint in robot.joints().iter().rev() {
        let child = joint.child.index();
        moves[joint.parent.index()] |= moves[child] || joint.kind != JointKind::Fixed;
    }
    let is_fork = |link: usize, way: usize| {
        let others =
            (robot.joints().iter()).filter(|j| j.parent.index() == link && j.child.index() != way);
        let mut moving = others.filter(|j| moves[j.child.index()] || j.kind != JointKind::Fixed);
        moving.next().is_some()
    };
    let mut root = tool_link.index();
    while let Some(joint) = holder(root) {
        let parent = joint.parent.index();
        if is_fork(parent, root) || holder(parent).is_none() {
            break;
        }
        root = parent;
    }
    let mut arm = vec![root];
    for joint in robot.joints() {
        if arm.contains(&joint.parent.index()) {
            arm.push(joint.child.index());
        }
    }
    arm
}

/// Shares the triangles that a page may have among meshes.
fn triangles_of_one(input: &MotionInput) -> usize {
    let of_links = input.robot.links().iter().flat_map(|link| &link.collision);
    let meshes = of_links.filter(|c| matches!(c.shape, Shape::Mesh(_)));
    let count = 1 + meshes.count() + input.task.scene.len();
    (MAX_TRIANGLES / count).min(MAX_TRIANGLES_OF_ONE)
}

/// What each track may show of its particles.
struct ParticleShare {
    /// One particle in so many is drawn.
    one_in: usize,
    /// Changes over all its frames.
    changes: usize,
}

impl ParticleShare {
    fn of(tracks: &[SampledTrack]) -> Self {
        let frames = tracks.iter().flat_map(|shown| shown.track.motion.particles);
        let most = frames.map(|frame| frame.positions.len()).max();
        let allowed = MAX_PARTICLES.min(MAX_PARTICLES_OF_ALL / tracks.len());
        Self {
            one_in: most.unwrap_or(0).div_ceil(allowed.max(1)).max(1),
            changes: MAX_CHANGES / tracks.len(),
        }
    }

    /// A sentence, if not all particles are drawn.
    fn cut(&self) -> Option<String> {
        let one_in = self.one_in;
        (one_in > 1).then(|| format!("The moving picture shows about one particle in {one_in}."))
    }
}

/// The frames of particles, each as what differs from the one before; times since `start` [s].
fn particles(input: &MotionInput, start: f64, share: &ParticleShare) -> Vec<ParticleStep> {
    let step = input.particles.len().div_ceil(MAX_PARTICLE_FRAMES).max(1);
    let mut now: Vec<[i64; 2]> = Vec::new();
    let mut budget = share.changes;
    let mut records = Vec::new();
    for (i, frame) in input.particles.iter().enumerate() {
        let is_last = i + 1 == input.particles.len();
        if i % step != 0 && !is_last {
            continue;
        }
        let places = frame.positions.iter().map(flat);
        let mut wanted: BTreeMap<[i64; 2], usize> = BTreeMap::new();
        for place in places.filter(|place| is_drawn(*place, share.one_in)) {
            *wanted.entry(place).or_default() += 1;
        }
        let mut removed = Vec::new();
        let mut next = Vec::new();
        for (index, place) in now.iter().enumerate() {
            match wanted.get_mut(place) {
                Some(count) if *count > 0 => {
                    *count -= 1;
                    next.push(*place);
                }
                _ => removed.push(index),
            }
        }
        let added: Vec<[i64; 2]> = wanted
            .into_iter()
            .flat_map(|(place, count)| std::iter::repeat_n(place, count))
            .collect();
        // Rather fewer moments than a page too large; the last one is always there.
        let changes = removed.len() + added.len();
        if changes > budget && !is_last {
            continue;
        }
        budget = budget.saturating_sub(changes);
        next.extend(&added);
        now = next;
        let time = rounded(frame.time - start);
        records.push((time, removed, added.into_flattened()));
    }
    records
}

/// Whether a particle is among the one in so many that are drawn: by its place, so that one that rests
/// is drawn in every frame or in none.
fn is_drawn([x, y]: [i64; 2], one_in: usize) -> bool {
    // Fibonacci hashing: multiples of 2^64 over the golden ratio spread evenly.
    const SPREAD: u64 = 0x9e37_79b9_7f4a_7c15;
    let mixed = (x as u64).wrapping_mul(SPREAD) ^ (y as u64).wrapping_mul(SPREAD.rotate_left(32));
    (mixed.wrapping_mul(SPREAD) >> 32).is_multiple_of(one_in as u64)
}

fn rounded(time: f64) -> f64 {
    (time * 1e4).round() / 1e4 + 0.0
}

fn flat(p: &Point2) -> [i64; 2] {
    [tenth(p.x), tenth(p.y)]
}
