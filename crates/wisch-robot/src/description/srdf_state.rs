//! The postures of an SRDF: elements `<group_state>`.

use super::diagnostics::{Words, words};
use super::srdf::{GroupState, HOME_STATE, READY_STATE, Srdf, finding};
use super::urdf::{Reader, elements};
use crate::{JointKind, RobotError, RobotModel, Severity};
use roxmltree::Node;
use std::collections::BTreeSet;

/// Largest number of notes and warnings about postures; further notes are left out, and further
/// warnings are an error.
const MAX_WARNINGS: usize = 1000;

impl Srdf {
    /// Reads the postures, and returns their faults. `groups`: names of all groups.
    pub(super) fn read_states(
        &mut self,
        reader: &Reader,
        root: Node,
        groups: &BTreeSet<String>,
        robot: &RobotModel,
    ) -> Vec<RobotError> {
        let mut faults = Vec::new();
        let mut known = BTreeSet::new();
        for node in elements(root, "group_state") {
            if let Some(why) = self.why_no_posture(node, groups, robot) {
                let name = node.attribute("name").unwrap_or_default();
                let w = words(
                    format!("posture {name:?}: {why}"),
                    "joints that move, of a group",
                    "fine if it is for other programs: it is ignored here",
                );
                if self.passed_over.len() < MAX_WARNINGS {
                    let found = finding(Severity::Note, reader.place(node), w);
                    self.passed_over.push(found);
                }
                continue;
            }
            match self.read_state(reader, node, groups, robot) {
                Ok(state) if known.insert((state.group.clone(), state.name.clone())) => {
                    self.states.push(state);
                }
                Ok(GroupState { name, group, .. }) => {
                    let w = words(
                        format!("state {name:?} of group {group:?} is defined twice"),
                        "one definition",
                        "the first is used; remove the other",
                    );
                    faults.extend(self.warn_at(reader, node, w).err());
                }
                Err(fault) => faults.push(fault),
            }
        }
        faults
    }

    /// Keeps a warning about an element. Beyond the limit it is an error, because no change may go
    /// unreported.
    fn warn_at(&mut self, reader: &Reader, node: Node, words: Words) -> Result<(), RobotError> {
        let warnings = self.passed_over.iter();
        let count = warnings
            .filter(|found| found.severity == Severity::Warning)
            .count();
        if count >= MAX_WARNINGS {
            return Err(reader.too_large("faulty postures", count + 1, MAX_WARNINGS));
        }
        let found = finding(Severity::Warning, reader.place(node), words);
        self.passed_over.push(found);
        Ok(())
    }

    /// Returns why a posture that belongs to no wiping group is ignored; `None` if it must be read. A wrong name
    /// in a chain's posture, the ready one or "home" remains an error, as the robot would start in another posture.
    fn why_no_posture(
        &self,
        node: Node,
        groups: &BTreeSet<String>,
        robot: &RobotModel,
    ) -> Option<String> {
        let name = node.attribute("name").map_or("", str::trim);
        let group = node.attribute("group").map_or("", str::trim);
        if name.starts_with(READY_STATE) || name == HOME_STATE {
            return None;
        }
        if group.is_empty() {
            return Some("it belongs to no group".to_owned());
        }
        if !groups.contains(group) {
            return Some(format!("there is no group {group:?}"));
        }
        if self.groups.iter().any(|known| known.name == group) {
            return None;
        }
        elements(node, "joint").find_map(|joint| {
            let name = joint.attribute("name")?.trim();
            match robot.joint(name) {
                Ok(id) if robot.joints()[id.index()].kind == JointKind::Fixed => {
                    Some(format!("joint {name:?} is fixed"))
                }
                Ok(_) => None,
                Err(_) => Some(format!("the robot has no joint {name:?}")),
            }
        })
    }

    /// Reads a posture. A position beyond a limit becomes the limit, with a warning.
    fn read_state(
        &mut self,
        reader: &Reader,
        node: Node,
        groups: &BTreeSet<String>,
        robot: &RobotModel,
    ) -> Result<GroupState, RobotError> {
        let name = reader.name(node, "name")?;
        let group = reader.name(node, "group")?;
        if !groups.contains(&group) {
            let known = groups.iter().map(String::as_str);
            return Err(reader.unknown_at(node, "group", &group, known));
        }
        let mut positions: Vec<(usize, f64)> = Vec::new();
        for joint in elements(node, "joint") {
            let joint_name = reader.name(joint, "name")?;
            let mut position = reader.require(joint, "value")?;
            let Some(variable) = reader.variable_of(joint, &joint_name, robot)? else {
                continue;
            };
            if positions.iter().any(|&(known, _)| known == variable) {
                let w = words(
                    format!("posture {name:?}: joint {joint_name:?} is set twice"),
                    "one value for each joint",
                    "the first value is used; remove the other",
                );
                self.warn_at(reader, joint, w)?;
                continue;
            }
            let limits = robot.variable(variable).limits.position;
            if let Some(limits) = limits
                && !(limits.lower..=limits.upper).contains(&position)
            {
                let within = position.clamp(limits.lower, limits.upper);
                let unit = robot.variable(variable).kind.unit();
                let [at, lower, upper, used] = [position, limits.lower, limits.upper, within]
                    .map(|position| (position * 1e6).round() / 1e6);
                let w = words(
                    format!("posture {name:?}: joint {joint_name:?} is at {at} {unit}"),
                    format!("a position from {lower} to {upper} {unit}"),
                    format!("{used} {unit} is used instead; correct the value"),
                );
                self.warn_at(reader, joint, w)?;
                position = within;
            }
            positions.push((variable, position));
        }
        Ok(GroupState {
            name,
            group,
            positions,
        })
    }
}

impl Reader<'_> {
    /// Returns the variable of a joint; `None` if it follows others.
    fn variable_of(
        &self,
        node: Node,
        name: &str,
        robot: &RobotModel,
    ) -> Result<Option<usize>, RobotError> {
        let joint = robot.joint(name).ok();
        if let Some(id) = joint {
            let variable = robot.variables().iter().position(|known| *known == id);
            let follows = !robot.joints()[id.index()].drive.terms.is_empty();
            if variable.is_some() || follows {
                return Ok(variable);
            }
        }
        let variables = (0..robot.dof()).map(|i| robot.variable(i).name.as_str());
        Err(self.unknown_at(node, "variable joint", name, variables))
    }
}
