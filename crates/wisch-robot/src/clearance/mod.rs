//! Which parts of a robot, its tools and its surroundings touch, and how far they are apart.

mod allowed;
mod broad_phase;
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
use broad_phase::Obstacles;
use frames::{LinkFrames, Mount};
use mesh::Placed;
use segment::{OpenPair, Span};
use solid::{AxisAlignedBox, Solid};
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
/// Obstacles are looked up by where they are, so that thousands of them cost little more than those that are near.
///
/// ```
/// # use wisch_robot::RobotModel;
/// use wisch_robot::geometry::{Mesh, Pose, Vector3};
/// use wisch_robot::CollisionModel;
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
    by_name: BTreeMap<String, BodyId>,
    solids: Vec<PlacedSolid>,
    /// The lower number first.
    allowed: BTreeMap<[BodyId; 2], Reason>,
    obstacles: Obstacles,
    /// What follows from all that: what to check, and what must be placed for it.
    rows: Vec<Row>,
    /// Of links and bodies, row by row.
    pairs: Vec<[BodyId; 2]>,
    placed_frames: Vec<usize>,
    placed_solids: Vec<usize>,
}

/// What a link or body is checked against.
#[derive(Debug, Clone)]
struct Row {
    body: BodyId,
    /// Where its pairs with later links and bodies are.
    pairs: Range<usize>,
    /// Whether it moves against the obstacles.
    meets_obstacles: bool,
}

/// A link, body or obstacle of one [`CollisionModel`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BodyId(usize);

#[derive(Debug, Clone)]
struct Body {
    name: String,
    frame: usize,
    is_obstacle: bool,
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

/// How far apart pairs are to stay; a number stands for the same distance for all of them.
///
/// ```
/// use wisch_robot::Margins;
/// // Obstacles may not be where they are believed to be.
/// let roomy = Margins { obstacles: 0.03, ..0.005.into() };
/// assert_eq!(roomy.own, 0.005);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Margins {
    /// Of two bodies of the robot [m].
    pub own: f64,
    /// Of the robot's bodies and obstacles [m].
    pub obstacles: f64,
}

impl From<f64> for Margins {
    fn from(margin: f64) -> Self {
        Self {
            own: margin,
            obstacles: margin,
        }
    }
}

impl Margins {
    fn checked(self) -> Result<(), RobotError> {
        checked_distance("margin", self.own)?;
        checked_distance("margin to obstacles", self.obstacles)
    }
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
    near: Vec<BodyId>,
    open: Vec<OpenPair>,
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
            by_name: BTreeMap::new(),
            solids: Vec::new(),
            allowed: BTreeMap::new(),
            obstacles: Obstacles::default(),
            rows: Vec::new(),
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
    /// against the link nor the links with shapes next to it along the tree, nor against links that are fixed to the
    /// link, directly or not, and what those hold: the fingers of a hand hold the tool.
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
        let mut near = self.neighbours[link.0].clone();
        // A frame is that of all links that are fixed to each other; the root's stands still, as obstacles do.
        let fixed = (0..self.mounts.len()).filter(|&i| frame > 0 && self.mounts[i].frame == frame);
        for part in fixed.map(BodyId) {
            // Links come after those that hold them.
            near.extend((self.neighbours[part.0].iter()).filter(|&&held| held >= part));
        }
        for neighbour in near {
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
        self.add_obstacles([(name, root_from_object, mesh)])
    }

    /// The same for several at once, each a name, a pose and a mesh: with many, much faster than one by one. Those
    /// before one that is refused are added.
    ///
    /// # Errors
    /// As [`CollisionModel::add_obstacle`].
    pub fn add_obstacles<'a>(
        &mut self,
        obstacles: impl IntoIterator<Item = (&'a str, Pose, &'a Mesh)>,
    ) -> Result<(), RobotError> {
        let added = obstacles
            .into_iter()
            .try_for_each(|(name, root_from_object, mesh)| {
                self.check_new(name, &root_from_object)?;
                let mount = Mount {
                    frame: 0,
                    frame_from_link: root_from_object,
                };
                let obstacle = mesh::obstacle(name, mesh)?;
                let body = self.push(name, mount, std::iter::once(obstacle));
                self.bodies[body.0].is_obstacle = true;
                Ok(())
            });
        let stands = |(i, body): (usize, &Body)| {
            let bounds = self.solids[body.solids.clone()]
                .iter()
                .map(|solid| solid.solid.bounds(&solid.frame_from_solid))
                .reduce(AxisAlignedBox::merged)?;
            body.is_obstacle.then_some((BodyId(i), bounds))
        };
        self.obstacles = Obstacles::new(self.bodies.iter().enumerate().filter_map(stands));
        added
    }

    /// Lets two links, bodies or obstacles touch.
    ///
    /// # Errors
    /// If there is none of a name; the error has the nearest names.
    pub fn allow(&mut self, a: &str, b: &str) -> Result<(), RobotError> {
        let pair = [self.body(a)?, self.body(b)?];
        self.permit(pair[0], pair[1], Reason::Asked);
        // Pairs with obstacles are not listed.
        if pair.iter().all(|id| !self.bodies[id.0].is_obstacle) {
            self.list_pairs();
        }
        Ok(())
    }

    /// The pairs that may touch, and why. Each is there once, with the first reason that it had.
    pub fn allowed_pairs(&self) -> impl Iterator<Item = (&str, &str, Reason)> {
        let pairs = self.allowed.iter();
        pairs.map(|(&[a, b], &reason)| (self.name(a), self.name(b), reason))
    }

    /// The pairs that are checked.
    pub fn checked_pairs(&self) -> impl Iterator<Item = (&str, &str)> {
        let all = (0..self.bodies.len()).map(BodyId);
        let obstacles: Vec<BodyId> = all.filter(|id| self.bodies[id.0].is_obstacle).collect();
        let mut checked = Vec::new();
        for row in &self.rows {
            checked.extend_from_slice(&self.pairs[row.pairs.clone()]);
            let met = obstacles.iter().filter(|_| row.meets_obstacles);
            let pairs = met.map(|&obstacle| [row.body, obstacle]);
            checked.extend(pairs.filter(|&pair| !self.may_touch(pair)));
        }
        let named = |[a, b]: [BodyId; 2]| (self.name(a), self.name(b));
        checked.into_iter().map(named)
    }

    /// The link, body or obstacle of a name.
    ///
    /// # Errors
    /// If there is none; the error has the nearest names.
    pub fn body(&self, name: &str) -> Result<BodyId, RobotError> {
        self.by_name.get(name).copied().ok_or_else(|| {
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
            let look = |[a, b]: [BodyId; 2], nearest: &mut Clearance, scratch: &Scratch| {
                let distance = self.distance([a, b], scratch, nearest.distance);
                if distance < nearest.distance {
                    let pair = Some(Contact { a, b, distance });
                    *nearest = Clearance { distance, pair };
                }
            };
            for row in &self.rows {
                for &pair in &self.pairs[row.pairs.clone()] {
                    look(pair, &mut nearest, scratch);
                }
                self.find_obstacles_near(row, nearest.distance, scratch);
                for &obstacle in &scratch.near {
                    look([row.body, obstacle], &mut nearest, scratch);
                }
            }
            nearest
        }))
    }

    /// The first pair found no farther apart than its margin [m] at the positions `q` (n) [rad or m].
    ///
    /// # Errors
    /// If `q` is of another length or not finite, or a margin below 0 m.
    pub fn collision(
        &self,
        q: &[f64],
        margins: impl Into<Margins>,
    ) -> Result<Option<Contact>, RobotError> {
        let margins = margins.into();
        self.checked(q)?;
        margins.checked()?;
        Ok(with_scratch(|scratch| {
            self.place(q, scratch);
            for row in &self.rows {
                let contact = |[a, b]: [BodyId; 2], margin: f64, scratch: &Scratch| {
                    // Zero is below the next greater number.
                    let distance = self.distance([a, b], scratch, margin.next_up());
                    (distance <= margin).then_some(Contact { a, b, distance })
                };
                let mut listed = self.pairs[row.pairs.clone()].iter();
                if let Some(found) = listed.find_map(|&pair| contact(pair, margins.own, scratch)) {
                    return Some(found);
                }
                let margin = margins.obstacles;
                self.find_obstacles_near(row, margin, scratch);
                let mut near = scratch.near.iter();
                if let Some(found) = near.find_map(|&b| contact([row.body, b], margin, scratch)) {
                    return Some(found);
                }
            }
            None
        }))
    }

    /// Whether a pair of bodies is allowed to touch.
    fn may_touch(&self, [a, b]: [BodyId; 2]) -> bool {
        self.allowed.contains_key(&[a.min(b), a.max(b)])
    }

    /// Finds the obstacles that a placed body might be nearer to than `up_to` [m], in their order.
    fn find_obstacles_near(&self, row: &Row, up_to: f64, scratch: &mut Scratch) {
        scratch.near.clear();
        if !row.meets_obstacles || self.obstacles.is_empty() {
            return;
        }
        let placed = |i: usize| self.solids[i].solid.bounds(self.frame_of(i, scratch));
        let solids = self.bodies[row.body.0].solids.clone();
        let Some(bounds) = solids.map(placed).reduce(AxisAlignedBox::merged) else {
            return;
        };
        let mut near = std::mem::take(&mut scratch.near);
        self.obstacles.find_near(&bounds, up_to, &mut near);
        near.retain(|&obstacle| !self.may_touch([row.body, obstacle]));
        scratch.near = near;
    }

    fn check_new(&self, name: &str, pose: &Pose) -> Result<(), RobotError> {
        let is_finite = pose.to_homogeneous().iter().all(|value| value.is_finite());
        if self.by_name.contains_key(name) {
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
        let id = BodyId(self.bodies.len());
        self.by_name.entry(name.to_owned()).or_insert(id);
        self.bodies.push(Body {
            name: name.to_owned(),
            frame: mount.frame,
            is_obstacle: false,
            solids: first..self.solids.len(),
            reach: self.solids[first..].iter().map(reach).fold(0.0, f64::max),
        });
        id
    }

    /// Lists what to check and what must be placed for it.
    fn list_pairs(&mut self) {
        let is_checked =
            |&i: &usize| !self.bodies[i].is_obstacle && !self.bodies[i].solids.is_empty();
        let solid: Vec<usize> = (0..self.bodies.len()).filter(is_checked).collect();
        let moves = |a: usize, b: usize| self.frames.moves(a, b, &self.is_moved);
        let (mut rows, mut pairs) = (Vec::new(), Vec::new());
        for (at, &a) in solid.iter().enumerate() {
            let first = pairs.len();
            let frame = self.bodies[a].frame;
            for &b in &solid[at + 1..] {
                let pair = [BodyId(a), BodyId(b)];
                if moves(frame, self.bodies[b].frame) && !self.may_touch(pair) {
                    pairs.push(pair);
                }
            }
            let row = Row {
                body: BodyId(a),
                pairs: first..pairs.len(),
                meets_obstacles: moves(frame, 0),
            };
            if row.meets_obstacles || !row.pairs.is_empty() {
                rows.push(row);
            }
        }
        let listed = pairs.iter().flatten().map(|id: &BodyId| id.0);
        let mut bodies: Vec<usize> = listed.chain(rows.iter().map(|row| row.body.0)).collect();
        bodies.sort_unstable();
        bodies.dedup();
        let above = |&i: &usize| self.frames.upward(self.bodies[i].frame);
        let mut frames: Vec<usize> = bodies.iter().flat_map(above).collect();
        frames.sort_unstable();
        frames.dedup();
        self.placed_frames = frames;
        self.placed_solids = (bodies.iter())
            .flat_map(|&i| self.bodies[i].solids.clone())
            .filter(|&i| self.solids[i].frame != 0)
            .collect();
        self.rows = rows;
        self.pairs = pairs;
    }

    /// Places what is checked and moves in the world.
    fn place(&self, q: &[f64], scratch: &mut Scratch) {
        self.frames
            .place(&self.placed_frames, q, &mut scratch.world_from_frame);
        let count = self.placed_solids.last().map_or(0, |last| last + 1);
        if scratch.world_from_solid.len() < count {
            scratch.world_from_solid.resize(count, Frame::identity());
        }
        for &i in &self.placed_solids {
            let solid = &self.solids[i];
            scratch.world_from_solid[i] =
                scratch.world_from_frame[solid.frame].then(&solid.frame_from_solid);
        }
    }

    /// Where a solid is in the world; those that move once they are placed.
    #[inline]
    fn frame_of<'a>(&'a self, solid: usize, scratch: &'a Scratch) -> &'a Frame {
        match self.solids[solid].frame {
            0 => &self.solids[solid].frame_from_solid,
            _ => &scratch.world_from_solid[solid],
        }
    }

    /// Distance of two placed bodies if below `up_to`, infinite otherwise.
    #[inline]
    fn distance(&self, pair: [BodyId; 2], scratch: &Scratch, up_to: f64) -> f64 {
        let [a, b] = pair.map(|id| self.bodies[id.0].solids.clone());
        let placed = |i: usize| (&self.solids[i].solid, self.frame_of(i, scratch));
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
