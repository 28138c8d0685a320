//! Which parts of a robot, its tools and its surroundings touch, and how far they are apart.

mod allowed;
mod frames;
mod mesh;
mod segment;
mod solid;
#[cfg(test)]
mod tests;

pub use allowed::Reason;
pub use segment::SEGMENT_RESOLUTION;

use super::frame::Frame;
use super::{LinkId, RobotError, RobotModel, Srdf};
use crate::geometry::{Mesh, Pose};
use crate::source_location::UnknownName;
use frames::{LinkFrames, Mount};
use mesh::Placed;
use segment::Span;
use solid::Solid;
use std::cell::Cell;
use std::collections::BTreeMap;
use std::ops::Range;

/// Everything that may touch: the shapes of the links, bodies fixed to links (tools), obstacles.
///
/// It is constant while queried, and every thread may query it. Queries allocate nothing once the
/// scratch space of the thread has its size. The world is the frame of the root link.
///
/// Checked are the pairs of links, bodies and obstacles that can move against each other and are not
/// allowed to touch, see [`allowed_pairs`](Self::allowed_pairs): two obstacles are never a pair, nor
/// an obstacle and a link that no variable moves (the robot stands on its table), nor two links
/// that fixed joints connect.
///
/// Spheres, capsules and boxes are themselves. The mesh of a link or a body becomes its convex hull;
/// of more than 256 vertices those farthest in 256 directions are kept, and the hull grows by as much
/// as any other is outside. Distances among spheres and capsules, and from them to boxes, are exact
/// to rounding. Others are found by the method of Gilbert, Johnson and Keerthi, which is at most 1e-7
/// of its value above the distance, and 1e-5 m where a cylinder is involved.
///
/// Every pair is looked at: some hundred obstacles are fine, thousands are not.
///
/// ```
/// # use wisch::robot::RobotModel;
/// use wisch::geometry::{Mesh, Pose, Vector3};
/// use wisch::robot::CollisionModel;
/// let text = r#"<robot name="r">
///   <link name="rail"/>
///   <link name="cart"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>
///   <joint name="slide" type="prismatic">
///     <parent link="rail"/><child link="cart"/><axis xyz="1 0 0"/><limit lower="0" upper="2"/>
///   </joint>
/// </robot>"#;
/// let robot = RobotModel::from_urdf("cart.urdf", text, &mut |_| Err("no meshes".into()))?;
/// let mut model = CollisionModel::new(&robot, None)?;
/// let wall = Mesh::cuboid(Vector3::new(0.2, 1.0, 1.0))?;
/// model.add_obstacle("wall", Pose::translation(1.0, 0.0, 0.0), &wall)?;
///
/// let clearance = model.clearance(&[0.5], f64::INFINITY)?;
/// assert!((clearance.distance - 0.3).abs() < 1e-12);
/// let contact = model.collision(&[0.85], 0.0)?.unwrap();
/// assert_eq!(model.describe(&contact), "\"cart\" and \"wall\" overlap by at least 0.0500 m");
/// assert!(model.segment_contact(&[0.0], &[2.0], 0.0)?.is_some());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct CollisionModel {
    frames: LinkFrames,
    /// Names of the variables.
    variables: Vec<String>,
    /// Whether each variable moves; pairs that none of them moves are left out.
    is_moved: Vec<bool>,
    /// Of each link.
    mounts: Vec<Mount>,
    /// Of each link: itself and the links with shapes next to it along the tree.
    neighbours: Vec<Vec<BodyId>>,
    /// The links, then bodies and obstacles.
    bodies: Vec<Body>,
    solids: Vec<PlacedSolid>,
    /// The lower number first.
    allowed: BTreeMap<[BodyId; 2], Reason>,
    /// What follows from all that: the pairs to check, and what must be placed for it.
    pairs: Vec<[BodyId; 2]>,
    placed_frames: Vec<usize>,
    placed_solids: Vec<usize>,
}

/// A link, body or obstacle of one [`CollisionModel`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BodyId(usize);

#[derive(Debug, Clone)]
struct Body {
    name: String,
    frame: usize,
    solids: Range<usize>,
    /// Farthest that any of its points is from the origin of its frame [m].
    reach: f64,
}

#[derive(Debug, Clone)]
struct PlacedSolid {
    frame: usize,
    frame_from_solid: Frame,
    solid: Solid,
}

/// How near the nearest pair is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clearance {
    /// The distance of the nearest pair, at most as far as was looked [m]. At most 0 if it overlaps,
    /// and then no deeper than it does.
    pub distance: f64,
    /// That pair; `None` if all are as far apart as was looked.
    pub pair: Option<Contact>,
}

/// Two bodies that are near each other; [`CollisionModel::describe`] says it in words.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// One, links before bodies and obstacles.
    pub a: BodyId,
    /// The other.
    pub b: BodyId,
    /// Their distance [m]. At most 0 if they overlap, and then no deeper than they do.
    pub distance: f64,
}

/// What queries write to.
#[derive(Default)]
struct Scratch {
    world_from_frame: Vec<Frame>,
    world_from_solid: Vec<Frame>,
    q: Vec<f64>,
    motions: Vec<f64>,
    open: Vec<usize>,
    spans: Vec<Span>,
}

thread_local! {
    static SCRATCH: Cell<Scratch> = Cell::new(Scratch::default());
}

fn with_scratch<T>(query: impl FnOnce(&mut Scratch) -> T) -> T {
    let mut scratch = SCRATCH.take();
    let answer = query(&mut scratch);
    SCRATCH.set(scratch);
    answer
}

impl CollisionModel {
    /// The links of a robot. Pairs that are neighbours, that the SRDF disables, or that overlap in
    /// 95 of 100 random postures may touch.
    ///
    /// # Errors
    /// If the SRDF is one of another, larger robot.
    pub fn new(robot: &RobotModel, srdf: Option<&Srdf>) -> Result<Self, RobotError> {
        let (frames, mounts) = LinkFrames::new(robot);
        let variables = robot.variables().iter();
        let mut model = Self {
            frames,
            variables: variables
                .map(|id| robot.joints()[id.index()].name.clone())
                .collect(),
            is_moved: vec![true; robot.dof()],
            neighbours: allowed::neighbours(robot),
            bodies: Vec::new(),
            solids: Vec::new(),
            allowed: BTreeMap::new(),
            pairs: Vec::new(),
            placed_frames: Vec::new(),
            placed_solids: Vec::new(),
            mounts,
        };
        for (link, mount) in robot.links().iter().zip(model.mounts.clone()) {
            let solids = link.collision.iter().map(mesh::of_shape);
            model.push(&link.name, mount, solids);
        }
        model.allow_neighbours();
        for pair in srdf.map_or(&[][..], |srdf| &srdf.disabled) {
            let [a, b] = [model.checked_link(pair.a)?, model.checked_link(pair.b)?];
            model.permit(a, b, Reason::Disabled);
        }
        model.list_pairs();
        model.allow_always_colliding(robot);
        Ok(model)
    }

    /// Fixes a body to a link, such as a tool. It becomes its convex hull, and is checked neither
    /// against the link nor the links with shapes next to it along the tree.
    ///
    /// # Errors
    /// If the name is taken, the pose is not finite, or the link is one of another, larger robot.
    pub fn attach(
        &mut self,
        name: &str,
        link: LinkId,
        link_from_body: Pose,
        mesh: &Mesh,
    ) -> Result<(), RobotError> {
        let link = self.checked_link(link)?;
        self.check_new(name, &link_from_body)?;
        let Mount {
            frame,
            frame_from_link,
        } = self.mounts[link.0];
        let mount = Mount {
            frame,
            frame_from_link: frame_from_link * link_from_body,
        };
        let body = self.push(name, mount, std::iter::once(mesh::hull(mesh)));
        for neighbour in self.neighbours[link.0].clone() {
            self.permit(neighbour, body, Reason::Neighbours);
        }
        self.list_pairs();
        Ok(())
    }

    /// Adds something that stands still, in the frame of the root link. A convex mesh is kept as its
    /// hull, any other as a surface: if that is closed, what is wholly inside touches it, otherwise
    /// only what meets its triangles does. A mesh whose parts overlap should be added part by part.
    ///
    /// # Errors
    /// If the name is taken, the pose is not finite, or the collision library refuses the mesh.
    pub fn add_obstacle(
        &mut self,
        name: &str,
        root_from_object: Pose,
        mesh: &Mesh,
    ) -> Result<(), RobotError> {
        self.check_new(name, &root_from_object)?;
        let mount = Mount {
            frame: 0,
            frame_from_link: root_from_object,
        };
        let obstacle = mesh::obstacle(name, mesh)?;
        self.push(name, mount, std::iter::once(obstacle));
        self.list_pairs();
        Ok(())
    }

    /// Lets two links, bodies or obstacles touch.
    ///
    /// # Errors
    /// If there is none of a name; the error has the nearest names.
    pub fn allow(&mut self, a: &str, b: &str) -> Result<(), RobotError> {
        let [a, b] = [self.body(a)?, self.body(b)?];
        self.permit(a, b, Reason::Asked);
        self.list_pairs();
        Ok(())
    }

    /// The pairs that may touch, and why. Each is there once, with the first reason that it had.
    pub fn allowed_pairs(&self) -> impl Iterator<Item = (&str, &str, Reason)> {
        let pairs = self.allowed.iter();
        pairs.map(|(&[a, b], &reason)| (self.name(a), self.name(b), reason))
    }

    /// The pairs that are checked.
    pub fn checked_pairs(&self) -> impl Iterator<Item = (&str, &str)> {
        self.pairs
            .iter()
            .map(|&[a, b]| (self.name(a), self.name(b)))
    }

    /// The link, body or obstacle of a name.
    ///
    /// # Errors
    /// If there is none; the error has the nearest names.
    pub fn body(&self, name: &str) -> Result<BodyId, RobotError> {
        let found = self.bodies.iter().position(|body| body.name == name);
        found.map(BodyId).ok_or_else(|| {
            let known = self.bodies.iter().map(|body| body.name.as_str());
            RobotError::NoSuch(Box::new(UnknownName::new(
                "link, body or obstacle",
                name,
                known,
            )))
        })
    }

    /// The name of a link, body or obstacle.
    ///
    /// # Panics
    /// If it is one of another, larger model.
    pub fn name(&self, body: BodyId) -> &str {
        &self.bodies[body.0].name
    }

    /// A contact in words.
    ///
    /// # Panics
    /// If it is one of another, larger model.
    pub fn describe(&self, contact: &Contact) -> String {
        let (a, b) = (self.name(contact.a), self.name(contact.b));
        match contact.distance {
            apart if apart > 0.0 => format!("{a:?} and {b:?} are {apart:.4} m apart"),
            depth => format!("{a:?} and {b:?} overlap by at least {:.4} m", -depth),
        }
    }

    /// The same model for a loop that moves only these variables: without the pairs that they do not
    /// move against each other. Positions are still those of all n variables.
    #[must_use]
    pub fn for_variables(&self, variables: &[usize]) -> Self {
        let mut model = self.clone();
        for (i, is_moved) in model.is_moved.iter_mut().enumerate() {
            *is_moved &= variables.contains(&i);
        }
        model.list_pairs();
        model
    }

    /// The smallest distance of all checked pairs at the positions `q` (n) [rad or m]; pairs further
    /// apart than `up_to` [m] are skipped, which is cheap.
    ///
    /// # Errors
    /// If `q` is of another length or not finite, or `up_to` below 0 m.
    pub fn clearance(&self, q: &[f64], up_to: f64) -> Result<Clearance, RobotError> {
        self.checked(q)?;
        checked_distance("distance to look up to", up_to)?;
        Ok(with_scratch(|scratch| {
            self.place(q, scratch);
            let mut nearest = Clearance {
                distance: up_to,
                pair: None,
            };
            for &[a, b] in &self.pairs {
                let distance = self.distance([a, b], scratch, nearest.distance);
                if distance < nearest.distance {
                    let pair = Some(Contact { a, b, distance });
                    nearest = Clearance { distance, pair };
                }
            }
            nearest
        }))
    }

    /// The first pair found at most `margin` [m] apart at the positions `q` (n) [rad or m].
    ///
    /// # Errors
    /// If `q` is of another length or not finite, or `margin` below 0 m.
    pub fn collision(&self, q: &[f64], margin: f64) -> Result<Option<Contact>, RobotError> {
        self.checked(q)?;
        checked_distance("margin", margin)?;
        Ok(with_scratch(|scratch| {
            self.place(q, scratch);
            let contact = |&[a, b]: &[BodyId; 2]| {
                // Zero is below the next greater number.
                let distance = self.distance([a, b], scratch, margin.next_up());
                (distance <= margin).then_some(Contact { a, b, distance })
            };
            self.pairs.iter().find_map(contact)
        }))
    }

    fn check_new(&self, name: &str, pose: &Pose) -> Result<(), RobotError> {
        let is_finite = pose.to_homogeneous().iter().all(|value| value.is_finite());
        if self.bodies.iter().any(|body| body.name == name) {
            let name = name.to_owned();
            return Err(RobotError::NameTaken { name });
        }
        if !is_finite {
            let (name, problem) = (name.to_owned(), "its pose is not finite".to_owned());
            return Err(RobotError::Obstacle { name, problem });
        }
        Ok(())
    }

    fn checked_link(&self, link: LinkId) -> Result<BodyId, RobotError> {
        let (link, links) = (link.index(), self.mounts.len());
        if link < links {
            Ok(BodyId(link))
        } else {
            Err(RobotError::ForeignLink { link, links })
        }
    }

    fn checked(&self, q: &[f64]) -> Result<(), RobotError> {
        if q.len() != self.variables.len() {
            return Err(RobotError::Length {
                what: "positions",
                found: q.len(),
                expected: self.variables.len(),
            });
        }
        match q.iter().position(|value| !value.is_finite()) {
            None => Ok(()),
            Some(i) => Err(RobotError::NotFinite {
                joint: self.variables[i].clone(),
                what: "positions",
                value: q[i],
            }),
        }
    }

    fn push(&mut self, name: &str, mount: Mount, solids: impl Iterator<Item = Placed>) -> BodyId {
        let first = self.solids.len();
        self.solids
            .extend(solids.map(|(link_from_solid, solid)| PlacedSolid {
                frame: mount.frame,
                frame_from_solid: Frame::from_pose(&(mount.frame_from_link * link_from_solid)),
                solid,
            }));
        let reach = |s: &PlacedSolid| s.frame_from_solid.translation.norm() + s.solid.reach();
        self.bodies.push(Body {
            name: name.to_owned(),
            frame: mount.frame,
            solids: first..self.solids.len(),
            reach: self.solids[first..].iter().map(reach).fold(0.0, f64::max),
        });
        BodyId(self.bodies.len() - 1)
    }

    /// Lists the pairs to check and what must be placed for them.
    fn list_pairs(&mut self) {
        let solid = |&i: &usize| !self.bodies[i].solids.is_empty();
        let solid: Vec<usize> = (0..self.bodies.len()).filter(solid).collect();
        let mut pairs = Vec::new();
        for (at, &a) in solid.iter().enumerate() {
            for &b in &solid[at + 1..] {
                let frames = [a, b].map(|i| self.bodies[i].frame);
                let pair = [BodyId(a), BodyId(b)];
                if self.frames.moves(frames[0], frames[1], &self.is_moved)
                    && !self.allowed.contains_key(&pair)
                {
                    pairs.push(pair);
                }
            }
        }
        let mut bodies: Vec<usize> = pairs.iter().flatten().map(|id| id.0).collect();
        bodies.sort_unstable();
        bodies.dedup();
        let above = |&i: &usize| self.frames.upward(self.bodies[i].frame);
        let mut frames: Vec<usize> = bodies.iter().flat_map(above).collect();
        frames.sort_unstable();
        frames.dedup();
        self.placed_frames = frames;
        self.placed_solids = bodies
            .iter()
            .flat_map(|&i| self.bodies[i].solids.clone())
            .collect();
        self.pairs = pairs;
    }

    /// Places what is checked in the world.
    fn place(&self, q: &[f64], scratch: &mut Scratch) {
        self.frames
            .place(&self.placed_frames, q, &mut scratch.world_from_frame);
        scratch
            .world_from_solid
            .resize(self.solids.len(), Frame::identity());
        for &i in &self.placed_solids {
            let solid = &self.solids[i];
            scratch.world_from_solid[i] = match solid.frame {
                0 => solid.frame_from_solid,
                frame => scratch.world_from_frame[frame].then(&solid.frame_from_solid),
            };
        }
    }

    /// Distance of two placed bodies if below `up_to`, infinite otherwise.
    #[inline]
    fn distance(&self, pair: [BodyId; 2], scratch: &Scratch, up_to: f64) -> f64 {
        let [a, b] = pair.map(|id| self.bodies[id.0].solids.clone());
        let placed = |i: usize| (&self.solids[i].solid, &scratch.world_from_solid[i]);
        let mut least = f64::INFINITY;
        for i in a {
            for j in b.clone() {
                least = least.min(solid::distance(placed(i), placed(j), up_to.min(least)));
            }
        }
        least
    }
}

fn checked_distance(what: &'static str, value: f64) -> Result<(), RobotError> {
    if value >= 0.0 {
        Ok(())
    } else {
        Err(RobotError::Distance { what, value })
    }
}
