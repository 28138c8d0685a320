//! SRDF as text: what [`Srdf::parse`] reads back as the same groups, postures and pairs.

use super::srdf::Srdf;
use super::virtual_joint::VirtualJoint;
use super::xml::escape;
use crate::{LinkId, RobotModel};
use std::fmt::Write;

/// Comments of an SRDF that [`Srdf::to_xml`] writes. An empty one is left out.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct SrdfComments {
    /// Comment before the first element.
    pub head: String,
    /// Comments before the groups, in their order.
    pub groups: Vec<String>,
    /// Comments before the postures, in their order.
    pub states: Vec<String>,
    /// Comment before the joints that springs or weights carry.
    pub counterbalanced: String,
    /// Comment before the pairs.
    pub pairs: String,
}

impl Srdf {
    /// Returns the SRDF as text, which [`Srdf::parse`] reads back with the same groups, postures and pairs. All groups
    /// are written as chains. Numbers keep every digit.
    ///
    /// A posture of a group that is no chain gets a group that lists the posture's joints.
    ///
    /// ```
    /// # use wisch_robot::RobotModel;
    /// # let urdf = r#"<robot name="r"><link name="wall"/><link name="rod"/>
    /// #   <joint name="pivot" type="continuous"><parent link="wall"/><child link="rod"/></joint>
    /// # </robot>"#;
    /// # let robot = RobotModel::from_urdf("r", urdf, &mut |_| Err(String::new()))?;
    /// use wisch_robot::{Group, Srdf, SrdfComments};
    /// let arm = Group { name: "arm".into(), base: robot.link("wall")?, tip: robot.link("rod")? };
    /// let srdf = Srdf::new(vec![arm], Vec::new(), Vec::new());
    /// let text = srdf.to_xml(&robot, &SrdfComments::default());
    /// assert!(text.contains(r#"<chain base_link="wall" tip_link="rod"/>"#));
    /// assert_eq!(Srdf::parse("r.srdf", &text, &robot)?.groups, srdf.groups);
    /// # Ok::<(), wisch_robot::RobotError>(())
    /// ```
    ///
    /// # Panics
    /// If a link or a variable belongs to another, larger robot.
    pub fn to_xml(&self, robot: &RobotModel, comments: &SrdfComments) -> String {
        let mut text = String::from("<?xml version=\"1.0\"?>\n");
        push_comment(&mut text, "", &comments.head);
        push_line(
            &mut text,
            format_args!("<robot name=\"{}\">", escape(robot.name())),
        );
        for joint in &self.virtual_joints {
            let VirtualJoint {
                name,
                kind,
                parent_frame,
                child_link,
            } = joint;
            let [name, kind, parent, child] =
                [name, kind, parent_frame, child_link].map(|text| escape(text));
            push_line(
                &mut text,
                format_args!(
                    "  <virtual_joint name=\"{name}\" type=\"{kind}\" parent_frame=\"{parent}\" child_link=\"{child}\"/>"
                ),
            );
        }
        let of = |comments: &[String], i: usize| comments.get(i).cloned().unwrap_or_default();
        let name = |link: LinkId| escape(&robot.links()[link.index()].name);
        for (i, group) in self.groups.iter().enumerate() {
            push_comment(&mut text, "  ", &of(&comments.groups, i));
            let (base, tip) = (name(group.base), name(group.tip));
            push_line(
                &mut text,
                format_args!(
                    "  <group name=\"{}\">\n    <chain base_link=\"{base}\" tip_link=\"{tip}\"/>\n  </group>",
                    escape(&group.name)
                ),
            );
        }
        self.push_other_groups(&mut text, robot);
        for holder in &self.tool_holders {
            let lean = holder
                .hand_lean
                .map_or_else(String::new, |lean| format!(" hand_lean_rad=\"{lean}\""));
            let (link, axis) = (name(holder.link), holder.axis);
            push_line(
                &mut text,
                format_args!("  <tool_holder link=\"{link}\" axis=\"{axis}\"{lean}/>"),
            );
        }
        if !self.counterbalanced.is_empty() {
            push_comment(&mut text, "  ", &comments.counterbalanced);
        }
        for joint in &self.counterbalanced {
            let joint = escape(&robot.joints()[joint.index()].name);
            push_line(
                &mut text,
                format_args!("  <counterbalance joint=\"{joint}\"/>"),
            );
        }
        for (i, state) in self.states.iter().enumerate() {
            push_comment(&mut text, "  ", &of(&comments.states, i));
            let (state_name, group) = (escape(&state.name), escape(&state.group));
            push_line(
                &mut text,
                format_args!("  <group_state name=\"{state_name}\" group=\"{group}\">"),
            );
            for &(variable, position) in &state.positions {
                let joint = escape(&robot.variable(variable).name);
                push_line(
                    &mut text,
                    format_args!("    <joint name=\"{joint}\" value=\"{position}\"/>"),
                );
            }
            text += "  </group_state>\n";
        }
        push_comment(&mut text, "  ", &comments.pairs);
        for pair in &self.disabled {
            let (a, b, reason) = (name(pair.a), name(pair.b), escape(&pair.reason));
            push_line(
                &mut text,
                format_args!(
                    "  <disable_collisions link1=\"{a}\" link2=\"{b}\" reason=\"{reason}\"/>"
                ),
            );
        }
        text += "</robot>\n";
        text
    }

    /// Writes the groups of postures that are no chains, as lists of joints.
    fn push_other_groups(&self, text: &mut String, robot: &RobotModel) {
        let mut written: Vec<&str> = self
            .groups
            .iter()
            .map(|group| group.name.as_str())
            .collect();
        for state in &self.states {
            if written.contains(&state.group.as_str()) {
                continue;
            }
            written.push(&state.group);
            push_line(
                text,
                format_args!("  <group name=\"{}\">", escape(&state.group)),
            );
            for &(variable, _) in &state.positions {
                let joint = escape(&robot.variable(variable).name);
                push_line(text, format_args!("    <joint name=\"{joint}\"/>"));
            }
            *text += "  </group>\n";
        }
    }
}

/// Appends a comment; XML forbids two hyphens in it.
fn push_comment(text: &mut String, indent: &str, comment: &str) {
    if comment.is_empty() {
        return;
    }
    let plain = |c: char| if c.is_control() && c != '\n' { ' ' } else { c };
    let mut comment: String = comment.trim_end().chars().map(plain).collect();
    while comment.contains("--") {
        comment = comment.replace("--", "- -");
    }
    let comment = comment.replace('\n', &format!("\n{indent}     "));
    push_line(text, format_args!("{indent}<!-- {comment} -->"));
}

fn push_line(text: &mut String, line: std::fmt::Arguments<'_>) {
    // Writing to a string cannot fail.
    let _ = writeln!(text, "{line}");
}
