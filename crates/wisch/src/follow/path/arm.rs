//! The arm at one base pose: it follows lines of the tool by the local method (7) of paper §3.3.
//!
//! Where a second hand holds the tool, a configuration has the variables of the leading arm, then those of the
//! second arm, and every configuration keeps both hands on the tool.

use crate::follow::workcell::second_arm::{GRIP_TOLERANCE, LEAN_TOLERANCE};
use crate::follow::{AllowedContact, FollowConfig, Obstruction, ToolPose, Workcell};
use crate::geometry::{PlanarPose, Point2, Pose, Vector3};
use crate::plan::Plan;
use crate::represent::{Action, SurfaceShape, Task};
use crate::robot::{
    Contact, IkConfig, IkOutcome, Joint, JointKind, JointPositions, Margins, RobotError,
    RotationGoal,
};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::{PI, TAU};

/// Distance from its limit at which a joint counts as at its limit [rad or m].
const AT_LIMIT: f64 = 1e-4;
/// Share of the tolerance that the middle between two solved poses may use up [1].
const SHARE_BETWEEN: f64 = 0.25;
/// Number of random starts of the inverse kinematics for one pose.
const RESTARTS: usize = 6;
/// Largest step of a joint between configurations at which the second hand is brought to the tool [rad or m].
const HELD_STEP: f64 = 0.1;
/// Remaining share of a vector below which it counts as linearly dependent [1].
const DEPENDENT: f64 = 1e-6;
/// Largest turn of the surface's normal over a step along the line [rad].
const MAX_BEND: f64 = 0.05;
/// Largest number of halvings of a step to stay on the line.
const MAX_HALVINGS: u32 = 6;

/// The variables of the planning group at one base pose.
pub(in crate::follow) struct Arm<'a> {
    pub cell: &'a Workcell,
    pub task: &'a Task,
    pub config: &'a FollowConfig,
    /// Whether the yaw of the tool matters: it pushes, or the plan turned it on purpose.
    pub keeps_heading: bool,
    /// All n variables; those of the group are overwritten.
    template: Vec<f64>,
    base_from_world: Pose,
    ik: IkConfig,
    margins: Margins,
}

/// Where and why a line could not be followed further.
#[derive(Debug, Clone)]
pub(in crate::follow) struct BrokenLine {
    /// Followed share of the line, 0 to 1.
    pub progress: f64,
    pub obstruction: Obstruction,
}

impl<'a> Arm<'a> {
    pub fn new(
        cell: &'a Workcell,
        task: &'a Task,
        config: &'a FollowConfig,
        world_from_base: &PlanarPose,
    ) -> Result<Self, RobotError> {
        let template = cell.standing(cell.ready_posture(), world_from_base);
        let base = cell.ik().chain().base();
        let root_from_base = cell
            .robot()
            .forward_kinematics(&template)?
            .world_from_link(base);
        Ok(Self {
            base_from_world: (cell.world_from_root() * root_from_base).inverse(),
            cell,
            task,
            config,
            keeps_heading: task.action != Action::Absorb && !task.tool.is_round(),
            template,
            ik: IkConfig::default(),
            margins: config.margin.into(),
        })
    }

    /// Returns the arm for a plan, which may turn the tool on purpose even where it does not push.
    pub fn with_plan(self, plan: &Plan) -> Self {
        Self {
            keeps_heading: self.keeps_heading || plan.strategy.turns_tool(),
            ..self
        }
    }

    /// Returns the arm with the larger clearance of free motion.
    pub fn with_free_clearance(&self) -> Self {
        let obstacles = self.config.free_clearance.max(self.config.margin);
        Self {
            margins: Margins {
                obstacles,
                ..self.margins
            },
            template: self.template.clone(),
            ..*self
        }
    }

    /// Returns the group's variables out of the robot's.
    pub fn group_variables(&self, q: &[f64]) -> JointPositions {
        let variables = self.cell.arm_variables();
        variables.iter().map(|&i| q[i]).collect()
    }

    /// Returns the robot's variables with those of the group.
    pub fn to_robot(&self, arm: &JointPositions) -> Vec<f64> {
        let mut q = self.template.clone();
        for (&variable, &value) in self.cell.arm_variables().iter().zip(arm.iter()) {
            q[variable] = value;
        }
        q
    }

    /// The group in the robot's ready posture.
    pub fn ready_posture(&self) -> JointPositions {
        self.group_variables(&self.template)
    }

    /// Returns the ranges of the group's variables; one turn either way for joints without limits.
    pub fn ranges(&self) -> Vec<[f64; 2]> {
        let range = |&i: &usize| {
            let range = self.cell.range_kept(self.cell.robot().variable(i));
            range.map_or([-PI, PI], |range| [range.lower, range.upper])
        };
        self.cell.arm_variables().iter().map(range).collect()
    }

    /// Whether every joint that the group moves is within its range less the margin, mimic joints included.
    pub fn is_within_ranges(&self, arm: &JointPositions) -> bool {
        let q = self.to_robot(arm);
        self.moved_joints().all(|joint| {
            let position = joint.drive.position(&q);
            let range = self.cell.range_kept(joint);
            range.is_none_or(|range| (range.lower..=range.upper).contains(&position))
        })
    }

    /// Returns whole turns to add to the group's variables on a run, so that free motion from a configuration to the
    /// run's first one is shortest.
    ///
    /// A whole turn of a joint that drives no other joint changes no pose. The run stays within the joints' ranges.
    pub fn shortest_turns(&self, from: &JointPositions, run: &[&JointPositions]) -> JointPositions {
        let variables = self.cell.arm_variables().iter().enumerate();
        let turns = variables.map(|(i, &variable)| {
            let joint = self.cell.robot().variable(variable);
            let Some(first) = run.first().filter(|_| self.turns_alone(variable)) else {
                return 0.0;
            };
            let fits = |turn: f64| {
                let range = self.cell.range_kept(joint);
                range.is_none_or(|range| {
                    let mut positions = run.iter().map(|q| q[i] + turn);
                    positions.all(|position| (range.lower..=range.upper).contains(&position))
                })
            };
            // From the largest number of turns towards 0.
            let nearest = ((from[i] - first[i]) / TAU).round();
            let counts = (0..=nearest.abs() as usize).rev();
            let mut turns = counts.map(|count| count as f64 * TAU.copysign(nearest));
            turns.find(|&turn| turn == 0.0 || fits(turn)).unwrap_or(0.0)
        });
        turns.collect()
    }

    /// Whether a variable is the angle of a joint and moves no other joint.
    fn turns_alone(&self, variable: usize) -> bool {
        let robot = self.cell.robot();
        let mut driven = robot.joints().iter().filter_map(|joint| {
            let mut terms = joint.drive.terms.iter();
            let term = terms.find(|(index, _)| *index == variable)?;
            Some((joint.kind, term.1))
        });
        driven.next() == Some((JointKind::Revolute, 1.0)) && driven.next().is_none()
    }

    /// The joints that the group's variables move.
    fn moved_joints(&self) -> impl Iterator<Item = &Joint> {
        let ours = self.cell.arm_variables();
        let is_moved = move |joint: &&Joint| {
            let mut terms = joint.drive.terms.iter();
            terms.any(|(variable, _)| ours.contains(variable))
        };
        self.cell.robot().joints().iter().filter(is_moved)
    }

    /// Returns the pose of the tool from the group's base.
    pub fn base_from_tool(&self, pose: &ToolPose) -> Pose {
        self.base_from_world * Workcell::world_from_tool(self.task, pose)
    }

    /// Finds a configuration with the tool at a pose, near `start`.
    pub fn reach(
        &self,
        pose: &ToolPose,
        start: &JointPositions,
    ) -> Result<JointPositions, Obstruction> {
        let target = self.base_from_tool(pose);
        let (leading, second) = start.split_at(self.leading());
        let outcome = (self.cell.ik()).solve_from(&target, RotationGoal::Full, leading, &self.ik);
        self.hold_near(&self.to_configuration(outcome)?, second)
    }

    /// Finds a configuration with the tool at a position with any yaw, near `start`. For one arm alone: a
    /// second hand is not brought to the tool.
    pub fn reach_with_free_yaw(
        &self,
        pose: &ToolPose,
        start: &JointPositions,
    ) -> Option<JointPositions> {
        let target = self.base_from_tool(pose);
        let goal = RotationGoal::AboutToolZFree;
        match self.cell.ik().solve_from(&target, goal, start, &self.ik) {
            Ok(IkOutcome::Solved(q)) => Some(q),
            _ => None,
        }
    }

    /// Returns a configuration about as near to `start` as possible, with the tool at a position
    /// and at any yaw. For one arm alone.
    pub fn nearest_with_free_yaw(
        &self,
        pose: &ToolPose,
        start: &JointPositions,
    ) -> Option<JointPositions> {
        let target = self.base_from_tool(pose);
        let config = IkConfig {
            posture_gain: 0.0,
            limit_gain: 0.0,
            ..self.ik
        };
        let goal = RotationGoal::AboutToolZFree;
        match self.cell.ik().solve_from(&target, goal, start, &config) {
            Ok(IkOutcome::Solved(q)) => Some(q),
            _ => None,
        }
    }

    /// Returns the joint directions that move the tool only in yaw: orthonormal columns. For one arm alone.
    pub fn null_space(&self, q: &JointPositions) -> DMatrix<f64> {
        let n = q.len();
        let Ok(kinematics) = self.cell.ik().chain().forward_kinematics(q) else {
            return DMatrix::zeros(n, 0);
        };
        let tip_from_tool = self.cell.tip_from_tool();
        let jacobian = kinematics.jacobian(tip_from_tool.translation.vector.into());
        let axis = (kinematics.base_from_tip() * tip_from_tool).rotation * Vector3::z();
        let (linear, angular) = (jacobian.view(), jacobian.view());
        let (linear, angular) = (linear.fixed_rows::<3>(0), angular.fixed_rows::<3>(3));
        // Constrained rows of the Jacobian: the linear part, and the angular part without the tool's axis a,
        // (I − a aᵀ) J_ω.
        let mut tied = DMatrix::zeros(6, n);
        tied.rows_mut(0, 3).copy_from(&linear);
        (tied.rows_mut(3, 3)).copy_from(&(angular - axis * (axis.transpose() * angular)));
        let mut basis: Vec<DVector<f64>> = Vec::new();
        let mut add = |vector: DVector<f64>| {
            let mut rest = vector;
            // Gram-Schmidt orthogonalisation, twice, because the first pass leaves rounding errors.
            for known in basis.iter().chain(&basis) {
                rest -= known * known.dot(&rest);
            }
            let length = rest.norm();
            let is_new = length > DEPENDENT;
            if is_new {
                basis.push(rest / length);
            }
            is_new
        };
        let rank = (tied.row_iter().map(|row| row.transpose()))
            .filter(|row| add(row.clone_owned()))
            .count();
        // The unit vectors complete the row space; the added directions span the null space.
        for i in 0..n {
            let mut unit = DVector::zeros(n);
            unit[i] = 1.0;
            add(unit);
        }
        let free = &basis[rank..];
        DMatrix::from_fn(n, free.len(), |row, column| free[column][row])
    }

    /// Returns the tool centre point projected onto the surface, in the surface frame.
    pub fn tool_on_surface(&self, q: &JointPositions) -> Option<Point2> {
        let kinematics = self.cell.ik().chain().forward_kinematics(q).ok()?;
        let base_from_tool = kinematics.base_from_tip() * self.cell.tip_from_tool();
        let tool = self.chart_from_tool(&base_from_tool).translation.vector;
        Some(Point2::new(tool.x, tool.y))
    }

    /// Height of the tool centre point above the surface [m].
    pub fn height(&self, q: &JointPositions) -> Option<f64> {
        let leading = &q[..self.leading()];
        let kinematics = (self.cell.ik().chain()).forward_kinematics(leading).ok()?;
        let base_from_tool = kinematics.base_from_tip() * self.cell.tip_from_tool();
        Some(self.chart_from_tool(&base_from_tool).translation.z)
    }

    /// Returns the pose of the tool in the axes of the surface's chart, see [`Surface::chart_from_tool`].
    fn chart_from_tool(&self, base_from_tool: &Pose) -> Pose {
        let surface = &self.task.surface;
        if surface.shape.is_plane() {
            let surface_from_base =
                surface.world_from_surface.inverse() * self.base_from_world.inverse();
            return surface_from_base * base_from_tool;
        }
        surface.chart_from_tool(&(self.base_from_world.inverse() * base_from_tool))
    }

    /// Returns configurations that lift the tool along the surface's normal and keep its
    /// orientation; `from` is left out.
    ///
    /// `way`: height of the lift [m], more than 0.
    pub fn lift_path(
        &self,
        from: &JointPositions,
        way: f64,
    ) -> Result<Vec<JointPositions>, Obstruction> {
        let leading = &from[..self.leading()];
        let kinematics = (self.cell.ik().chain()).forward_kinematics(leading);
        let kinematics = kinematics.map_err(|_| Obstruction::unreachable())?;
        let base_from_tool = kinematics.base_from_tip() * self.cell.tip_from_tool();
        let base_from_surface =
            self.base_from_world.rotation * self.task.surface.world_from_surface.rotation;
        let place = self
            .chart_from_tool(&base_from_tool)
            .translation
            .vector
            .xy();
        let shape = &self.task.surface.shape;
        let up = base_from_surface * (shape.orientation(place.into()) * Vector3::z());
        let count = (way / self.config.step).ceil().max(1.0) as usize;
        let mut path = Vec::with_capacity(count);
        let mut at = *from;
        for i in 1..=count {
            let risen = up * (way * i as f64 / count as f64);
            let target = nalgebra::Translation3::from(risen) * base_from_tool;
            let (leading, second) = at.split_at(self.leading());
            let outcome =
                (self.cell.ik()).solve_from(&target, RotationGoal::Full, leading, &self.ik);
            let next = self.hold_near(&self.to_configuration(outcome)?, second)?;
            if self.is_jump(&at, &next) {
                return Err(self.jump(&at, &next));
            }
            path.push(next);
            at = next;
        }
        (self.is_free_along(from, &path, AllowedContact::Surface))
            .map_err(|broken| broken.obstruction)?;
        Ok(path)
    }

    /// Rotation of the tool about the surface's normal [rad].
    pub fn heading(&self, q: &JointPositions) -> f64 {
        let Ok(kinematics) = (self.cell.ik().chain()).forward_kinematics(&q[..self.leading()])
        else {
            return 0.0;
        };
        let base_from_tool = kinematics.base_from_tip() * self.cell.tip_from_tool();
        let x = self.chart_from_tool(&base_from_tool).rotation * Vector3::x();
        libm::atan2(x.y, x.x)
    }

    /// Finds a configuration with the tool at a pose, from `starts`, or from the ready posture if there are none, then
    /// from random ones.
    pub fn reach_anyhow(
        &self,
        pose: &ToolPose,
        starts: &[&[f64]],
        seed: u64,
        restarts: usize,
    ) -> Result<JointPositions, Obstruction> {
        let target = self.base_from_tool(pose);
        let config = IkConfig {
            max_restarts: restarts,
            ..self.ik
        };
        let n = self.leading();
        let leading: Vec<&[f64]> = starts.iter().map(|start| &start[..n]).collect();
        let outcome = (self.cell.ik()).solve(&target, RotationGoal::Full, &leading, seed, &config);
        let found = self.to_configuration(outcome)?;
        let Some(second) = self.cell.second_arm() else {
            return Ok(found);
        };
        let ready = self.ready_posture();
        let seconds: Vec<&[f64]> = (starts.iter().copied())
            .chain([&*ready])
            .map(|start| &start[n..])
            .collect();
        Ok(join_arms(
            &found,
            &second.hold_from_any_start(&found, &seconds, seed, &config)?,
        ))
    }

    /// Draws a configuration from the ranges of the leading arm's joints, from which a search may end in another
    /// branch of the inverse kinematics. A second arm stays at its ready posture.
    pub fn random_start(&self, seed: u64) -> JointPositions {
        let ready = self.ready_posture();
        let (leading, second) = ready.split_at(self.leading());
        match self.cell.ik().random_start(leading, seed) {
            Ok(drawn) => join_arms(&drawn, second),
            Err(_) => ready,
        }
    }

    /// Number of a configuration's values that belong to the leading arm.
    fn leading(&self) -> usize {
        self.cell.ik().chain().dof()
    }

    /// Returns a configuration of the leading arm with the second hand on the tool, near `second`.
    fn hold_near(&self, leading: &[f64], second: &[f64]) -> Result<JointPositions, Obstruction> {
        match self.cell.second_arm() {
            None => Ok(leading.iter().copied().collect()),
            Some(arm) => Ok(join_arms(leading, &arm.hold(leading, second, &self.ik)?)),
        }
    }

    /// Returns the configuration with the second hand brought back to the tool; `None` if it does
    /// not reach the tool.
    pub fn hold(&self, q: &JointPositions) -> Option<JointPositions> {
        let (leading, second) = q.split_at(self.leading());
        self.hold_near(leading, second).ok()
    }

    /// Whether the second hand is near enough to its grip for a configuration between two solved poses.
    fn is_in_grip(&self, q: &JointPositions) -> bool {
        let Some(arm) = self.cell.second_arm() else {
            return true;
        };
        let (leading, second) = q.split_at(self.leading());
        arm.deviation(leading, second).is_ok_and(|off| {
            off.position <= SHARE_BETWEEN * GRIP_TOLERANCE
                && off.lean <= SHARE_BETWEEN * LEAN_TOLERANCE
        })
    }

    /// Returns a free path between two configurations that keeps both hands on the tool: straight for the
    /// leading arm. It leaves `from` out and includes the end.
    pub fn free_path(
        &self,
        from: &JointPositions,
        to: &JointPositions,
        allowed: AllowedContact,
    ) -> Result<Vec<JointPositions>, Obstruction> {
        if self.cell.second_arm().is_none() {
            self.is_free(from, to, allowed)?;
            return Ok(vec![*to]);
        }
        let count = ((widest_step(from, to) / HELD_STEP).ceil() as usize).max(1);
        let mut way = Vec::with_capacity(count);
        let mut at = *from;
        for i in 1..=count {
            let next = if i == count {
                *to
            } else {
                let straight = between(from, to, i as f64 / count as f64);
                let (leading, second) = straight.split_at(self.leading());
                self.hold_near(leading, second)?
            };
            self.halve(&at, &next, allowed, &mut way, MAX_HALVINGS)?;
            at = next;
        }
        Ok(way)
    }

    /// Adds the path between two configurations, halved until both hands stay on the tool.
    fn halve(
        &self,
        from: &JointPositions,
        to: &JointPositions,
        allowed: AllowedContact,
        way: &mut Vec<JointPositions>,
        halvings: u32,
    ) -> Result<(), Obstruction> {
        let middle = between(from, to, 0.5);
        if !self.is_jump(from, to) && self.is_in_grip(&middle) {
            self.is_free(from, to, allowed)?;
            way.push(*to);
            return Ok(());
        }
        if halvings == 0 {
            return Err(self.jump(from, to));
        }
        let (leading, second) = middle.split_at(self.leading());
        let middle = self.hold_near(leading, second)?;
        self.halve(from, &middle, allowed, way, halvings - 1)?;
        self.halve(&middle, to, allowed, way, halvings - 1)
    }

    /// Finds a configuration as [`Self::reach_anyhow`], without collision.
    pub fn reach_free(
        &self,
        pose: &ToolPose,
        starts: &[&[f64]],
        seed: u64,
    ) -> Result<JointPositions, Obstruction> {
        let q = self.reach_anyhow(pose, starts, seed, RESTARTS)?;
        self.is_free(&q, &q, AllowedContact::None).map(|()| q)
    }

    fn to_configuration(
        &self,
        outcome: Result<IkOutcome, RobotError>,
    ) -> Result<JointPositions, Obstruction> {
        match outcome {
            Ok(IkOutcome::Solved(q)) => Ok(q),
            Ok(IkOutcome::Stuck {
                best,
                position_error,
                rotation_error,
            }) => Err(self.at_limit(&best).unwrap_or(Obstruction::OutOfReach {
                position_error,
                rotation_error,
            })),
            // All poses and starts are computed here and finite.
            Err(_) => Err(Obstruction::unreachable()),
        }
    }

    fn at_limit(&self, arm: &JointPositions) -> Option<Obstruction> {
        let q = self.to_robot(arm);
        self.moved_joints().find_map(|joint| {
            let range = self.cell.range_kept(joint)?;
            let position = joint.drive.position(&q);
            let is_at = position < range.lower + AT_LIMIT || position > range.upper - AT_LIMIT;
            let limits = joint.limits.position.filter(|_| is_at)?;
            Some(Obstruction::JointLimit {
                joint: joint.name.clone(),
                limits,
                unit: joint.kind.unit(),
            })
        })
    }

    /// Whether the straight path between two configurations is free.
    pub fn is_free(
        &self,
        from: &JointPositions,
        to: &JointPositions,
        allowed: AllowedContact,
    ) -> Result<(), Obstruction> {
        let (from, to) = (self.to_robot(from), self.to_robot(to));
        let model = self.cell.arm_collisions(allowed);
        match model.segment_contact(&from, &to, self.margins) {
            Ok(None) => Ok(()),
            Ok(Some(contact)) => Err(self.obstruction(&contact, allowed)),
            Err(_) => Err(Obstruction::unreachable()),
        }
    }

    /// Whether a configuration is free.
    pub fn is_free_at(&self, at: &JointPositions, allowed: AllowedContact) -> bool {
        let model = self.cell.arm_collisions(allowed);
        let contact = model.collision(&self.to_robot(at), self.margins);
        matches!(contact, Ok(None))
    }

    fn obstruction(&self, contact: &Contact, allowed: AllowedContact) -> Obstruction {
        let model = self.cell.arm_collisions(allowed);
        let (a, b) = (model.name(contact.a), model.name(contact.b));
        // The distance of a pair that is not proven to be clear is at most the limit.
        let within = |limit: f64| contact.distance.min(limit);
        let Margins { own, obstacles } = self.margins;
        match (self.cell.is_obstacle(a), self.cell.is_obstacle(b)) {
            (false, false) => Obstruction::SelfCollision {
                a: a.to_owned(),
                b: b.to_owned(),
                distance: within(own),
                limit: own,
            },
            (a_is_obstacle, _) => {
                let (body, object) = if a_is_obstacle { (b, a) } else { (a, b) };
                Obstruction::SceneCollision {
                    body: body.to_owned(),
                    object: object.to_owned(),
                    distance: within(obstacles),
                    limit: obstacles,
                }
            }
        }
    }

    /// Returns the configurations along the tool's line from `start`, which is left out; the end is
    /// included. Redundant joints move towards `near`, if given.
    ///
    /// Collisions are checked only after all poses have been reached, at the most likely places first. Most
    /// lines that cannot be followed end out of reach, which is cheap to detect.
    pub fn follow_line(
        &self,
        start: &JointPositions,
        from: &ToolPose,
        to: &ToolPose,
        near: Option<&JointPositions>,
        allowed: AllowedContact,
    ) -> Result<Vec<JointPositions>, BrokenLine> {
        let count = steps(from, to, &self.task.surface.shape, self.config);
        let mut path = Vec::with_capacity(count);
        let mut at = *start;
        for i in 1..=count {
            let (s0, s1) = ((i - 1) as f64 / count as f64, i as f64 / count as f64);
            let near = near.map(|near| between(&at, near, 1.0 / (count - i + 1) as f64));
            let near = near.as_ref();
            self.step(&mut at, [from, to], [s0, s1], near, &mut path, MAX_HALVINGS)
                .map_err(|obstruction| BrokenLine {
                    progress: s0,
                    obstruction,
                })?;
        }
        self.is_free_along(start, &path, allowed)?;
        Ok(path)
    }

    /// Whether the straight paths from each configuration to the next are free.
    fn is_free_along(
        &self,
        start: &JointPositions,
        path: &[JointPositions],
        allowed: AllowedContact,
    ) -> Result<(), BrokenLine> {
        let broken = |i: usize, obstruction| BrokenLine {
            progress: i as f64 / path.len() as f64,
            obstruction,
        };
        // A configuration is cheaper to check than the path between two.
        for i in [path.len() - 1, path.len() / 2] {
            self.is_free(&path[i], &path[i], allowed)
                .map_err(|obstruction| broken(i, obstruction))?;
        }
        let mut at = start;
        for (i, next) in path.iter().enumerate() {
            self.is_free(at, next, allowed)
                .map_err(|obstruction| broken(i, obstruction))?;
            at = next;
        }
        Ok(())
    }

    /// Takes one step of the line; halves it if the straight joint path leaves the line.
    fn step(
        &self,
        at: &mut JointPositions,
        line: [&ToolPose; 2],
        [s0, s1]: [f64; 2],
        near: Option<&JointPositions>,
        path: &mut Vec<JointPositions>,
        halvings: u32,
    ) -> Result<(), Obstruction> {
        let [from, to] = line;
        let next = self.reach(&from.interpolate(to, s1), near.unwrap_or(at))?;
        let middle_s = 0.5 * (s0 + s1);
        let on_line =
            !self.is_jump(at, &next) && self.is_on_line(at, &next, &from.interpolate(to, middle_s));
        if on_line {
            path.push(next);
            *at = next;
            return Ok(());
        }
        if halvings == 0 {
            return Err(self.jump(at, &next));
        }
        let half = near.map(|near| between(at, near, 0.5));
        let (first, second) = ([s0, middle_s], [middle_s, s1]);
        self.step(at, line, first, half.as_ref(), path, halvings - 1)?;
        self.step(at, line, second, near, path, halvings - 1)
    }

    /// Whether a joint moves more than allowed between two neighbouring poses.
    pub fn is_jump(&self, from: &JointPositions, to: &JointPositions) -> bool {
        widest_step(from, to) > self.config.max_joint_step
    }

    fn jump(&self, from: &JointPositions, to: &JointPositions) -> Obstruction {
        let steps = from.iter().zip(to.iter()).map(|(a, b)| (b - a).abs());
        let (widest, step) = steps
            .enumerate()
            .max_by(|a, b| a.1.total_cmp(&b.1))
            .unwrap_or_default();
        let variable = self.cell.arm_variables()[widest];
        let joint = self.cell.robot().variable(variable);
        Obstruction::Jump {
            joint: joint.name.clone(),
            step,
            unit: joint.kind.unit(),
        }
    }

    /// Whether the tool is at the right pose half way between two configurations.
    pub fn is_on_line(
        &self,
        from: &JointPositions,
        to: &JointPositions,
        middle: &ToolPose,
    ) -> bool {
        let q: JointPositions = from
            .iter()
            .zip(to.iter())
            .map(|(a, b)| 0.5 * (a + b))
            .collect();
        let leading = &q[..self.leading()];
        let Ok(kinematics) = self.cell.ik().chain().forward_kinematics(leading) else {
            return false;
        };
        let base_from_tool = kinematics.base_from_tip() * self.cell.tip_from_tool();
        let wanted = self.base_from_tool(middle);
        let off = (base_from_tool.translation.vector - wanted.translation.vector).norm();
        let turned = base_from_tool.rotation.angle_to(&wanted.rotation);
        off <= SHARE_BETWEEN * self.config.line_tolerance
            && turned <= SHARE_BETWEEN * self.config.turn_tolerance
            && self.is_in_grip(&q)
    }
}

/// Joins the positions of the leading arm and of the second.
fn join_arms(leading: &[f64], second: &[f64]) -> JointPositions {
    leading.iter().chain(second).copied().collect()
}

/// Returns the configuration at share `s` between two; at 1 exactly `b`.
pub(in crate::follow) fn between(a: &JointPositions, b: &JointPositions, s: f64) -> JointPositions {
    if s >= 1.0 {
        return *b;
    }
    a.iter()
        .zip(b.iter())
        .map(|(a, b)| a + s * (b - a))
        .collect()
}

/// Largest step of a joint between two configurations [rad or m].
pub(in crate::follow) fn widest_step(from: &JointPositions, to: &JointPositions) -> f64 {
    let steps = from.iter().zip(to.iter()).map(|(a, b)| (b - a).abs());
    steps.fold(0.0, f64::max)
}

/// Number of steps into which the line between two poses of the tool is cut.
fn steps(from: &ToolPose, to: &ToolPose, shape: &SurfaceShape, config: &FollowConfig) -> usize {
    let turn = (to.surface_from_tool.heading - from.surface_from_tool.heading).abs();
    let lean = (to.tilt - from.tilt).abs();
    let steps = (from.distance(to) / config.step).max(turn.max(lean) / config.turn);
    let [begin, end] = [from, to].map(|pose| pose.surface_from_tool.position);
    let bend = shape.turn_between(begin, end);
    (steps.max(bend / MAX_BEND).ceil() as usize).max(1)
}
