//! A motion as numbers for the page's 3-D view.

use super::mesh::{Thinned, thinned};
use super::tempo::Frames;
use super::{Contact, MotionInput};
use serde::Serialize;
use std::collections::BTreeMap;
use wisch::geometry::{Mesh, Point2, Pose, Vector3};
use wisch::represent::ScenePart;
use wisch::robot::{Collision, Joint, JointKind, LinkId, RobotModel, Shape};

/// Most triangles of all meshes together, and of one.
const MAX_TRIANGLES: usize = 12_000;
const MAX_TRIANGLES_OF_ONE: usize = 4_000;
/// Most particles of a frame, frames of particles, and changes of particles over all frames.
const MAX_PARTICLES: usize = 1_500;
const MAX_PARTICLE_FRAMES: usize = 120;
const MAX_CHANGES: usize = 30_000;

/// What the view's script reads. Lengths in metres but for meshes, outlines and particles, which come
/// in tenths of a millimetre; positions of variables in 1e-5 rad or m; times since the first frame [s].
#[derive(Debug, Serialize)]
pub(super) struct ViewerRecord<'a> {
    period: f64,
    /// Number of frames.
    count: usize,
    /// Positions of all variables in the first frame.
    start: Vec<i64>,
    /// Variables that change, each with its steps from frame to frame.
    changes: Vec<(usize, Vec<i64>)>,
    /// Pose of the root link in the world, as all poses: x, y, z, quaternion x, y, z, w.
    root: [f64; 7],
    /// Joint i holds link i + 1.
    joints: Vec<JointRecord<'a>>,
    links: Vec<LinkRecord>,
    tool: ToolRecord,
    scene: Vec<ObjectRecord>,
    surface: SurfaceRecord,
    phases: Vec<PhaseRecord<'a>>,
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
    shapes: Vec<ShapeRecord>,
}

#[derive(Debug, Serialize)]
struct ShapeRecord {
    pose: [f64; 7],
    #[serde(flatten)]
    solid: SolidRecord,
}

#[derive(Debug, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
enum SolidRecord {
    Box { size: [f64; 3] },
    Cylinder { radius: f64, length: f64 },
    Capsule { radius: f64, length: f64 },
    Sphere { radius: f64 },
    Mesh { mesh: MeshRecord },
}

#[derive(Debug, Serialize)]
struct MeshRecord {
    /// x, y, z of all vertices in turn.
    vertices: Vec<i64>,
    /// Three vertices each.
    triangles: Vec<u32>,
}

#[derive(Debug, Serialize)]
struct ToolRecord {
    link: usize,
    pose: [f64; 7],
    mesh: MeshRecord,
}

#[derive(Debug, Serialize)]
struct ObjectRecord {
    part: &'static str,
    pose: [f64; 7],
    mesh: MeshRecord,
}

#[derive(Debug, Serialize)]
struct SurfaceRecord {
    pose: [f64; 7],
    rings: Vec<Vec<[i64; 2]>>,
}

#[derive(Debug, Serialize)]
struct PhaseRecord<'a> {
    name: &'a str,
    start: f64,
    end: f64,
    contact: bool,
}

impl<'a> ViewerRecord<'a> {
    /// The record, and what was left out of it for the sake of the page's size, in sentences.
    pub(super) fn new(input: &MotionInput<'a>, frames: &Frames) -> (Self, Vec<String>) {
        let (robot, task) = (input.robot, input.task);
        let mut meshes = MeshBudget::new(input);
        let units = |q: &[f64]| -> Vec<i64> { q.iter().map(|&q| scaled(q, 1e5)).collect() };
        let q: Vec<Vec<i64>> = frames.q.iter().map(|q| units(q)).collect();
        let steps = |variable: usize| -> Vec<i64> {
            let pairs = q.windows(2);
            pairs
                .map(|two| two[1][variable] - two[0][variable])
                .collect()
        };
        let changes = (0..robot.dof())
            .map(|variable| (variable, steps(variable)))
            .filter(|(_, steps)| steps.iter().any(|&step| step != 0));
        let arm = arm(robot, input.tool_link);
        let links = robot
            .links()
            .iter()
            .enumerate()
            .map(|(i, link)| LinkRecord {
                arm: arm.contains(&i),
                shapes: link.collision.iter().map(|c| meshes.shape(c)).collect(),
            });
        let scene = (task.scene.iter()).filter_map(|object| {
            let part = match object.part {
                ScenePart::Obstacle => "obstacle",
                ScenePart::Carrier => "carrier",
                ScenePart::Robot | ScenePart::Tool => return None,
            };
            let pose = pose(&object.world_from_object);
            Some((part, pose, &object.mesh))
        });
        let links = links.collect();
        let scene = scene
            .map(|(part, pose, mesh)| ObjectRecord {
                part,
                pose,
                mesh: meshes.mesh(mesh),
            })
            .collect();
        let rings = task.surface.outline.rings();
        let (particles, particle_cuts) = particles(input, frames.start);
        let record = Self {
            period: frames.period,
            count: q.len(),
            start: q.first().cloned().unwrap_or_default(),
            changes: changes.collect(),
            root: pose(&input.world_from_root),
            joints: robot.joints().iter().map(JointRecord::new).collect(),
            links,
            tool: ToolRecord {
                link: input.tool_link.index(),
                pose: pose(&input.link_from_tool),
                mesh: meshes.mesh(&task.tool.mesh),
            },
            scene,
            surface: SurfaceRecord {
                pose: pose(&task.surface.world_from_surface),
                rings: rings
                    .map(|ring| ring.iter().map(tenths).collect())
                    .collect(),
            },
            phases: (input.phases.iter())
                .map(|phase| PhaseRecord {
                    name: &phase.name,
                    start: rounded(phase.start - frames.start),
                    end: rounded(phase.end - frames.start),
                    contact: phase.contact == Contact::Wiping,
                })
                .collect(),
            particles,
        };
        let cuts = meshes.cut().into_iter().chain(particle_cuts).collect();
        (record, cuts)
    }
}

impl<'a> JointRecord<'a> {
    fn new(joint: &'a Joint) -> Self {
        Self {
            parent: joint.parent.index(),
            pose: pose(&joint.parent_from_joint),
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
struct MeshBudget {
    each: usize,
    thinned: usize,
}

impl MeshBudget {
    fn new(input: &MotionInput) -> Self {
        let of_links = input.robot.links().iter().flat_map(|link| &link.collision);
        let meshes = of_links
            .filter(|c| matches!(c.shape, Shape::Mesh(_)))
            .count();
        let count = 1 + meshes + input.task.scene.len();
        Self {
            each: (MAX_TRIANGLES / count).min(MAX_TRIANGLES_OF_ONE),
            thinned: 0,
        }
    }

    fn mesh(&mut self, mesh: &Mesh) -> MeshRecord {
        let Thinned {
            vertices,
            triangles,
        } = thinned(mesh, self.each);
        self.thinned += usize::from(triangles.len() < mesh.triangles().len());
        let vertices = vertices.iter();
        MeshRecord {
            vertices: vertices
                .flat_map(|v| [v.x, v.y, v.z].map(|v| scaled(v, 1e4)))
                .collect(),
            triangles: triangles.into_flattened(),
        }
    }

    fn shape(&mut self, collision: &Collision) -> ShapeRecord {
        let solid = match &collision.shape {
            Shape::Box { size } => SolidRecord::Box { size: vector(size) },
            &Shape::Cylinder { radius, length } => SolidRecord::Cylinder { radius, length },
            &Shape::Capsule { radius, length } => SolidRecord::Capsule { radius, length },
            &Shape::Sphere { radius } => SolidRecord::Sphere { radius },
            Shape::Mesh(mesh) => SolidRecord::Mesh {
                mesh: self.mesh(mesh),
            },
        };
        ShapeRecord {
            pose: pose(&collision.link_from_shape),
            solid,
        }
    }

    fn cut(&self) -> Option<String> {
        let (meshes, each) = (self.thinned, self.each);
        (meshes > 0).then(|| format!("Meshes are drawn with about {each} triangles at most, which coarsens {meshes} of them."))
    }
}

/// The frames of particles, each as what differs from the one before, and a sentence if not all are.
fn particles(input: &MotionInput, start: f64) -> (Vec<ParticleStep>, Option<String>) {
    let most = input.particles.iter().map(|f| f.positions.len()).max();
    let one_in = most.unwrap_or(0).div_ceil(MAX_PARTICLES).max(1);
    let step = input.particles.len().div_ceil(MAX_PARTICLE_FRAMES).max(1);
    let mut now: Vec<[i64; 2]> = Vec::new();
    let mut budget = MAX_CHANGES;
    let mut records = Vec::new();
    for (i, frame) in input.particles.iter().enumerate() {
        let is_last = i + 1 == input.particles.len();
        if i % step != 0 && !is_last {
            continue;
        }
        let places = frame.positions.iter().map(tenths);
        let mut wanted: BTreeMap<[i64; 2], usize> = BTreeMap::new();
        for place in places.filter(|place| is_drawn(*place, one_in)) {
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
    let cut =
        (one_in > 1).then(|| format!("The moving picture shows about one particle in {one_in}."));
    (records, cut)
}

/// Whether a particle is among the one in so many that are drawn: by its place, so that one that rests
/// is drawn in every frame or in none.
fn is_drawn([x, y]: [i64; 2], one_in: usize) -> bool {
    // Fibonacci hashing: multiples of 2^64 over the golden ratio spread evenly.
    const SPREAD: u64 = 0x9e37_79b9_7f4a_7c15;
    let mixed = (x as u64).wrapping_mul(SPREAD) ^ (y as u64).wrapping_mul(SPREAD.rotate_left(32));
    (mixed.wrapping_mul(SPREAD) >> 32).is_multiple_of(one_in as u64)
}

fn pose(pose: &Pose) -> [f64; 7] {
    let (t, r) = (pose.translation.vector, pose.rotation.coords);
    let [x, y, z] = vector(&t);
    // Seven decimals: a turn is amplified by the length of the robot.
    let turn = [r.x, r.y, r.z, r.w].map(|v| (v * 1e7).round() / 1e7 + 0.0);
    [x, y, z, turn[0], turn[1], turn[2], turn[3]]
}

fn vector(v: &Vector3) -> [f64; 3] {
    // Adding zero leaves no "-0.0".
    [v.x, v.y, v.z].map(|v| (v * 1e7).round() / 1e7 + 0.0)
}

fn rounded(time: f64) -> f64 {
    (time * 1e4).round() / 1e4 + 0.0
}

fn tenths(p: &Point2) -> [i64; 2] {
    [scaled(p.x, 1e4), scaled(p.y, 1e4)]
}

fn scaled(value: f64, per_unit: f64) -> i64 {
    (value * per_unit).round() as i64
}
