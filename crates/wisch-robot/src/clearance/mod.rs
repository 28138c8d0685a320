//! Collisions and distances between a robot, its tools and its surroundings.

mod allowed;
mod broad_phase;
mod frames;
mod mesh;
mod pair_distances;
mod segment;
mod solid;
#[cfg(test)]
mod tests;

pub use allowed::AllowedReason;
pub(crate) use allowed::draw_posture;
pub(crate) use pair_distances::PairDistance;
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
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// Collision model of the links, bodies fixed to links (tools) and obstacles.
///
/// Queries do not change the model, and every thread may query it. They allocate nothing once the scratch memory of the
/// thread has its size. The world is the frame of the root link.
///
/// A pair of links, bodies or obstacles is checked if it can move against each other and is not allowed to touch; see
/// [`allowed_pairs`](Self::allowed_pairs). Two obstacles are never a pair. Neither are an obstacle and a link that no
/// variable moves (the robot stands on its table), nor two links connected by fixed joints.
///
/// Spheres, capsules and boxes are exact. The mesh of a link or body becomes its convex hull. Of more than 256
/// vertices, those farthest in 256 directions are kept, and the hull is inflated by the largest distance of a dropped
/// vertex. Distances between spheres and capsules, and from them to boxes, are exact up to rounding. Other distances
/// come from the algorithm of Gilbert, Johnson and Keerthi, with a relative error of at most 1e-7, or 1e-5 m if a
/// cylinder is involved.
///
/// A spatial index finds nearby obstacles, so that thousands of distant ones cost little.
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
    /// Whether each variable moves; pairs that no variable moves are left out.
    is_moved: Vec<bool>,
    /// Mount of each link.
    mounts: Vec<Mount>,
    /// For each link, itself and the adjacent links with shapes.
    neighbours: Vec<Vec<BodyId>>,
    /// Links first, then bodies and obstacles.
    bodies: Vec<Body>,
    by_name: BTreeMap<String, BodyId>,
    solids: Vec<PlacedSolid>,
    /// Allowed pairs, the lower index first.
    allowed: BTreeMap<[BodyId; 2], AllowedReason>,
    obstacles: Obstacles,
    /// Pairs to check, and solids to place for them; derived from the fields above.
    rows: Vec<Row>,
    /// Pairs of links and bodies, row by row.
    pairs: Vec<[BodyId; 2]>,
    placed_frames: Vec<usize>,
    placed_solids: Vec<usize>,
}

/// Pairs of a link or body.
#[derive(Debug, Clone)]
struct Row {
    body: BodyId,
    /// Range of its pairs with later links and bodies.
    pairs: Range<usize>,
    /// Whether it moves against the obstacles.
    meets_obstacles: bool,
}

/// Index of a link, body or obstacle of one [`CollisionModel`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BodyId(usize);

#[derive(Debug, Clone)]
struct Body {
    name: String,
    frame: usize,
    is_obstacle: bool,
    solids: Range<usize>,
    /// Largest distance of its points from the origin of its frame [m].
    reach: f64,
}

#[derive(Debug, Clone)]
struct PlacedSolid {
    frame: usize,
    frame_from_solid: Frame,
    solid: Solid,
}

/// Distances that pairs must keep; a number stands for the same distance for all pairs.
///
/// ```
/// use wisch_robot::Margins;
/// // Obstacles may be misplaced.
/// let roomy = Margins { obstacles: 0.03, ..0.005.into() };
/// assert_eq!(roomy.own, 0.005);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Margins {
    /// Distance between two bodies of the robot \[m\].
    pub own: f64,
    /// Distance between the robot's bodies and obstacles \[m\].
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
    fn check(self) -> Result<(), RobotError> {
        check_distance("margin", self.own)?;
        check_distance("margin to obstacles", self.obstacles)
    }
}

/// The nearest pair of bodies with its distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clearance {
    /// Distance of the nearest pair, at most the searched one \[m\]. If the pair overlaps, a value of at most 0 that is a
    /// lower bound on the depth.
    pub distance: f64,
    /// The nearest pair; `None` if no pair is closer than the searched distance.
    pub pair: Option<Contact>,
}

/// Two bodies that are close to each other; [`CollisionModel::describe`] states it in words.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// First body; links come before bodies and obstacles.
    pub a: BodyId,
    /// Second body.
    pub b: BodyId,
    /// Distance \[m\]. If they overlap, a value of at most 0 that is a lower bound on the depth.
    pub distance: f64,
}

/// Scratch memory of a query.
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
    /// Returns the collision model of a robot's links. Pairs may touch that are neighbours, that the SRDF disables, or
    /// that overlap in 95 of 100 random postures.
    ///
    /// # Errors
    /// If the SRDF is that of another, larger robot.
    pub fn new(robot: &RobotModel, srdf: Option<&Srdf>) -> Result<Self, RobotError> {
        let mut model = Self::of_links(robot);
        for pair in srdf.map_or(&[][..], |srdf| &srdf.disabled) {
            let [a, b] = [model.body_of_link(pair.a)?, model.body_of_link(pair.b)?];
            model.permit(a, b, AllowedReason::Disabled);
        }
        model.list_pairs();
        model.allow_always_colliding(robot);
        Ok(model)
    }

    /// Returns the collision model of a robot's links in which only neighbours may touch.
    pub(crate) fn of_links(robot: &RobotModel) -> Self {
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
        model.list_pairs();
        model
    }

    /// Fixes a body, such as a tool, to a link. The body becomes its convex hull. It is not checked against the link,
    /// the adjacent links with shapes, links fixed to that link, or what these carry: the fingers of a hand hold the
    /// tool, to their tips.
    ///
    /// # Errors
    /// If the name exists already, the pose is not finite, or the link belongs to another, larger robot.
    pub fn attach(
        &mut self,
        name: &str,
        link: LinkId,
        link_from_body: Pose,
        mesh: &Mesh,
    ) -> Result<(), RobotError> {
        let link = self.body_of_link(link)?;
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
        let mut near: BTreeSet<BodyId> = self.neighbours[link.0].iter().copied().collect();
        // Links that are fixed to each other share a frame; the root's frame does not move and neither do obstacles.
        let fixed = (0..self.mounts.len()).filter(|&i| frame > 0 && self.mounts[i].frame == frame);
        let mut carriers: Vec<BodyId> = fixed.map(BodyId).collect();
        near.extend(&carriers);
        while let Some(carrier) = carriers.pop() {
            // A child has a greater index than its parent.
            let carried = self.neighbours[carrier.0].iter();
            carriers.extend(carried.filter(|&&held| held > carrier && near.insert(held)));
        }
        for neighbour in near {
            self.permit(neighbour, body, AllowedReason::Neighbours);
        }
        self.list_pairs();
        Ok(())
    }

    /// Adds an obstacle, with its pose in the frame of the root link. A convex mesh is kept as its hull, any other mesh
    /// as a surface. If the surface is closed, bodies inside it collide; otherwise only bodies that
    /// touch its triangles do. Overlapping parts of a mesh should be added one by one.
    ///
    /// # Errors
    /// If the name exists already, the pose is not finite, or the collision library rejects the mesh.
    pub fn add_obstacle(
        &mut self,
        name: &str,
        root_from_object: Pose,
        mesh: &Mesh,
    ) -> Result<(), RobotError> {
        self.add_obstacles([(name, root_from_object, mesh)])
    }

    /// Adds several obstacles, each with name, pose and mesh; for many obstacles this is much faster than one by one.
    /// Obstacles before a rejected one are added.
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
                .reduce(AxisAlignedBox::merge)?;
            body.is_obstacle.then_some((BodyId(i), bounds))
        };
        self.obstacles = Obstacles::new(self.bodies.iter().enumerate().filter_map(stands));
        added
    }

    /// Allows two links, bodies or obstacles to touch.
    ///
    /// # Errors
    /// If a name does not exist; the error has the nearest names.
    pub fn allow(&mut self, a: &str, b: &str) -> Result<(), RobotError> {
        let pair = [self.body(a)?, self.body(b)?];
        self.permit(pair[0], pair[1], AllowedReason::Asked);
        // Pairs with obstacles are not stored.
        if pair.iter().all(|id| !self.bodies[id.0].is_obstacle) {
            self.list_pairs();
        }
        Ok(())
    }

    /// Iterates over the pairs that may touch, each once, with the first reason for it.
    pub fn allowed_pairs(&self) -> impl Iterator<Item = (&str, &str, AllowedReason)> {
        let pairs = self.allowed.iter();
        pairs.map(|(&[a, b], &reason)| (self.name(a), self.name(b), reason))
    }

    /// Iterates over the pairs that are checked.
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

    /// Returns the link, body or obstacle of this name.
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

    /// Returns the name of a link, body or obstacle.
    ///
    /// # Panics
    /// If it belongs to another, larger model.
    pub fn name(&self, body: BodyId) -> &str {
        &self.bodies[body.0].name
    }

    /// Describes a contact in words, with the names of both bodies and their distance.
    ///
    /// # Panics
    /// If it belongs to another, larger model.
    pub fn describe(&self, contact: &Contact) -> String {
        let (a, b) = (self.name(contact.a), self.name(contact.b));
        match contact.distance {
            apart if apart > 0.0 => format!("{a:?} and {b:?} are {apart:.4} m apart"),
            depth => format!("{a:?} and {b:?} overlap by at least {:.4} m", -depth),
        }
    }

    /// Returns the model for queries that move only these variables, without the pairs that they do not move against
    /// each other. Positions are still those of all n variables.
    #[must_use]
    pub fn with_variables(&self, variables: &[usize]) -> Self {
        let mut model = self.clone();
        for (i, is_moved) in model.is_moved.iter_mut().enumerate() {
            *is_moved &= variables.contains(&i);
        }
        model.list_pairs();
        model
    }

    /// Returns the smallest distance of all checked pairs at positions `q` (n) [rad or m]. Pairs farther apart than
    /// `up_to` \[m\] are skipped, which is cheap.
    ///
    /// # Errors
    /// If `q` does not have n finite values, or `up_to` is below 0 m.
    pub fn clearance(&self, q: &[f64], up_to: f64) -> Result<Clearance, RobotError> {
        self.check_positions(q)?;
        check_distance("distance to look up to", up_to)?;
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

    /// Returns a pair that is not farther apart than its margin \[m\] at positions `q` (n) [rad or m], if there is one.
    ///
    /// # Errors
    /// If `q` does not have n finite values, or a margin is below 0 m.
    pub fn collision(
        &self,
        q: &[f64],
        margins: impl Into<Margins>,
    ) -> Result<Option<Contact>, RobotError> {
        let margins = margins.into();
        self.check_positions(q)?;
        margins.check()?;
        Ok(with_scratch(|scratch| {
            self.place(q, scratch);
            for row in &self.rows {
                let contact = |[a, b]: [BodyId; 2], margin: f64, scratch: &Scratch| {
                    // At a margin of 0, a distance of exactly 0 must count as well.
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

    /// Whether a pair of bodies may touch.
    fn may_touch(&self, [a, b]: [BodyId; 2]) -> bool {
        self.allowed.contains_key(&[a.min(b), a.max(b)])
    }

    /// Finds the obstacles that a placed body may be closer to than `up_to` [m], sorted.
    fn find_obstacles_near(&self, row: &Row, up_to: f64, scratch: &mut Scratch) {
        scratch.near.clear();
        if !row.meets_obstacles || self.obstacles.is_empty() {
            return;
        }
        let placed = |i: usize| self.solids[i].solid.bounds(self.frame_of(i, scratch));
        let solids = self.bodies[row.body.0].solids.clone();
        let Some(bounds) = solids.map(placed).reduce(AxisAlignedBox::merge) else {
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

    fn body_of_link(&self, link: LinkId) -> Result<BodyId, RobotError> {
        let (link, links) = (link.index(), self.mounts.len());
        if link < links {
            Ok(BodyId(link))
        } else {
            Err(RobotError::ForeignLink { link, links })
        }
    }

    fn check_positions(&self, q: &[f64]) -> Result<(), RobotError> {
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

    /// Lists the pairs to check and the solids to place for them.
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

    /// Places the checked and moving solids in the world.
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

    /// Returns the frame of a solid in the world; moving solids must be placed before.
    #[inline]
    fn frame_of<'a>(&'a self, solid: usize, scratch: &'a Scratch) -> &'a Frame {
        match self.solids[solid].frame {
            0 => &self.solids[solid].frame_from_solid,
            _ => &scratch.world_from_solid[solid],
        }
    }

    /// Returns the distance of two placed bodies if it is below `up_to`, and infinity otherwise.
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

fn check_distance(what: &'static str, value: f64) -> Result<(), RobotError> {
    if value >= 0.0 {
        Ok(())
    } else {
        Err(RobotError::Distance { what, value })
    }
}
