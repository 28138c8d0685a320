//! Robot semantics beyond the URDF, in MoveIt's SRDF: groups, named postures, and links that may touch.

use super::diagnostics::{Diagnostics, Words, words};
use super::link_axis::LinkAxis;
use super::repair::Repaired;
use super::urdf::{Reader, elements};
use super::virtual_joint::{VirtualJoint, virtual_joints};
use crate::source_location::{Place, UnknownName};
use crate::{
    Diagnostic, DiagnosticKind, Joint, JointId, JointKind, LinkId, RobotError, RobotModel,
    Severity, Subject,
};
use roxmltree::Node;
use std::collections::BTreeSet;

/// Name of the posture in which the arm waits and travels. A posture named `ready_` plus the tool's name takes
/// precedence, for tools that need their own.
pub const READY_STATE: &str = "ready";

/// Name of the posture of variables that no ready posture sets.
pub const HOME_STATE: &str = "home";

/// Range of the lean of a hand over its tool [rad]: from upright to flat.
const MAX_LEAN: std::ops::RangeInclusive<f64> = 0.0..=std::f64::consts::FRAC_PI_2;
/// Number of unknown links that a warning names.
const LINKS_SHOWN: usize = 12;
/// Largest number of groups.
const MAX_GROUPS: usize = 1000;

/// The semantic description (SRDF) of one robot: groups, postures and disabled pairs.
///
/// ```
/// # use wisch_robot::RobotModel;
/// # let urdf = r#"<robot name="r"><link name="wall"/><link name="rod"/>
/// #   <joint name="pivot" type="continuous"><parent link="wall"/><child link="rod"/></joint>
/// # </robot>"#;
/// # let robot = RobotModel::from_urdf("r", urdf, &mut |_| Err(String::new()))?;
/// use wisch_robot::Srdf;
/// let text = r#"<robot name="r">
///   <group name="arm"><chain base_link="wall" tip_link="rod"/></group>
///   <group_state name="ready" group="arm"><joint name="pivot" value="0.5"/></group_state>
/// </robot>"#;
/// let srdf = Srdf::parse("r.srdf", text, &robot)?;
/// let ready = srdf.state("ready")?;
/// assert_eq!(ready.apply_to(&[0.0]), [0.5]);
///
/// let fault = Srdf::parse("r.srdf", &text.replace("pivot", "pivto"), &robot).unwrap_err();
/// assert_eq!(fault.to_string(), "r.srdf:3:41: unknown variable joint \"pivto\"; nearest: pivot");
/// # Ok::<(), wisch_robot::RobotError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Srdf {
    /// Groups that are chains, in the order of the text: first those with a `<chain>`, then those whose joints form a
    /// chain with at least two independent joints.
    pub groups: Vec<Group>,
    /// Named postures of groups.
    pub states: Vec<GroupState>,
    /// Pairs of links that are not checked against each other.
    pub disabled: Vec<DisabledPair>,
    /// How the root link is joined to the world. A planar one is a base that drives, if the URDF was read with
    /// [`urdf_on_base`](crate::urdf_on_base).
    pub virtual_joints: Vec<VirtualJoint>,
    /// How links hold tools: elements `<tool_holder>`, an extension of the format that other programs ignore.
    pub tool_holders: Vec<ToolHolder>,
    /// Joints that springs or weights carry, so that they hold more than the effort limits of the
    /// URDF: elements `<counterbalance>`, an extension of the format.
    pub counterbalanced: Vec<JointId>,
    /// Groups that are ignored: those of links, of other groups, or of joints that form no chain. Passive joints and end
    /// effectors are ignored silently.
    pub ignored: Vec<IgnoredElement>,
    /// Diagnostics of elements that are ignored without harm to the groups that wipe: pairs with a link that the robot
    /// does not have (a warning), and postures of joints that are fixed, absent or in no group (a note).
    pub passed_over: Vec<Diagnostic>,
    /// Name of the robot in the text, if it is another one, and its place [byte].
    other_robot: Option<(usize, String)>,
}

/// A chain of joints from a base link to a tip link.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Group {
    /// Name of the group.
    pub name: String,
    /// Base link, to which poses are relative.
    pub base: LinkId,
    /// Tip link.
    pub tip: LinkId,
}

/// A named posture: positions of some variables.
#[derive(Debug, Clone, PartialEq)]
pub struct GroupState {
    /// Name of the posture.
    pub name: String,
    /// Name of its group, which need not be a chain.
    pub group: String,
    /// Pairs of a variable and its position [rad or m]; followers are left out, as the variables determine them.
    pub positions: Vec<(usize, f64)>,
}

/// How a link holds a tool: a `<tool_holder>` element, with the attributes `link`, `axis` and `hand_lean_rad`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToolHolder {
    /// The link.
    pub link: LinkId,
    /// The link's axis that points out of the hand; z if the element does not say.
    pub axis: LinkAxis,
    /// Angle by which the hand leans back over a tool that it holds at the rear edge \[rad\]; `None` for a flange or
    /// gripper that holds a tool square.
    pub hand_lean: Option<f64>,
}

/// Two links that may touch: a `<disable_collisions>` element of an SRDF.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DisabledPair {
    /// First link.
    pub a: LinkId,
    /// Second link.
    pub b: LinkId,
    /// Reason as in the text, such as "Adjacent"; empty if it has none.
    pub reason: String,
}

/// An element of an SRDF that is ignored, with the reason.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct IgnoredElement {
    /// Place in the text.
    pub at: Place,
    /// Description, such as `group "hand" of a joint, not a chain`.
    pub what: String,
}

impl GroupState {
    /// Returns the positions `q` (n) with those of this posture inserted; variables beyond the length of `q` are
    /// skipped.
    pub fn apply_to(&self, q: &[f64]) -> Vec<f64> {
        let mut q = q.to_vec();
        for &(variable, position) in &self.positions {
            if let Some(entry) = q.get_mut(variable) {
                *entry = position;
            }
        }
        q
    }
}

impl Srdf {
    /// Returns the SRDF with these groups, postures and pairs, without a text.
    pub const fn new(
        groups: Vec<Group>,
        states: Vec<GroupState>,
        disabled: Vec<DisabledPair>,
    ) -> Self {
        Self {
            groups,
            states,
            disabled,
            virtual_joints: Vec::new(),
            tool_holders: Vec::new(),
            counterbalanced: Vec::new(),
            ignored: Vec::new(),
            passed_over: Vec::new(),
            other_robot: None,
        }
    }

    /// Reads the SRDF of a robot; `name` identifies the text in messages.
    ///
    /// # Errors
    /// If the text is no SRDF or exceeds a limit. If a group names an unknown link, a posture of a chain an unknown
    /// joint, or a posture an unknown group. If a chain's tip is no descendant of its base. If two groups, or two
    /// postures of a group, have the same name. If a posture is outside the position limits.
    pub fn parse(name: &str, text: &str, robot: &RobotModel) -> Result<Self, RobotError> {
        let (srdf, faults) = Self::read(name, text, robot)?;
        faults.into_iter().next().map_or(Ok(srdf), Err)
    }

    /// Checks an SRDF, and returns all findings. There is an error for each reason for which [`Srdf::parse`] rejects
    /// the text; an unknown name counts once. There is a warning if the SRDF is that of another robot, and one for
    /// links of pairs that the robot does not have. One note names the ignored groups, and each ignored posture gets a note. `name` identifies the
    /// text in messages.
    ///
    /// ```
    /// # use wisch_robot::RobotModel;
    /// # let urdf = r#"<robot name="r"><link name="wall"/></robot>"#;
    /// # let robot = RobotModel::from_urdf("r", urdf, &mut |_| Err(String::new()))?;
    /// use wisch_robot::Srdf;
    /// let text = r#"<robot name="r"><disable_collisions link1="wall" link2="wal"/></robot>"#;
    /// let found = Srdf::check("r.srdf", text, &robot);
    /// assert!(found[0].to_string().starts_with("r.srdf:1:17: robot: unknown link \"wal\"; nearest: wall"));
    /// # Ok::<(), wisch_robot::RobotError>(())
    /// ```
    pub fn check(name: &str, text: &str, robot: &RobotModel) -> Vec<Diagnostic> {
        let mut report = Diagnostics {
            file: name,
            text,
            diagnostics: Vec::new(),
        };
        let (srdf, faults) = match Self::read(name, text, robot) {
            Ok((srdf, faults)) => (srdf, faults),
            Err(fault) => (Self::default(), vec![fault]),
        };
        let mut unknown_names = BTreeSet::new();
        for fault in &faults {
            let is_new = match fault {
                RobotError::UnknownAt { unknown, .. } => {
                    unknown_names.insert((unknown.kind, &unknown.name))
                }
                _ => true,
            };
            if is_new {
                report.diagnostics.push(diagnostic(fault, name, robot));
            }
        }
        if let Some((at, other)) = srdf.other_robot {
            let w = words(
                format!("the SRDF is of robot {other:?}"),
                format!("robot {:?}", robot.name()),
                "give the SRDF of this robot, or correct its name",
            );
            let subject = Subject::Robot;
            report.add(Severity::Warning, DiagnosticKind::Srdf, subject, at, w);
        }
        report.diagnostics.extend(srdf.passed_over);
        report.diagnostics.extend(ignored_groups(&srdf.ignored));
        report.diagnostics.sort_by_key(|f| (f.at.line, f.at.column));
        report.diagnostics
    }

    /// Reads everything that is valid, and returns all faults: groups first, then postures, then pairs.
    ///
    /// # Errors
    /// If the text is no SRDF or exceeds a limit.
    fn read(
        name: &str,
        text: &str,
        robot: &RobotModel,
    ) -> Result<(Self, Vec<RobotError>), RobotError> {
        let repaired = Repaired::new(text);
        let reader = Reader::new(name, &repaired.text);
        let document = reader.document()?;
        let root = reader.robot(&document)?;
        let mut srdf = Self {
            other_robot: (root.attribute("name"))
                .filter(|name| *name != robot.name())
                .map(|name| (root.range().start, name.to_owned())),
            ..Self::default()
        };
        let mut faults = Vec::new();
        let mut groups = BTreeSet::new();
        let mut of_joints = Vec::new();
        // Postures may come before their groups.
        for node in elements(root, "group") {
            match srdf.read_group(&reader, node, &mut groups, robot) {
                Ok(group) => of_joints.extend(group),
                Err(fault) => faults.push(fault),
            }
            if groups.len() > MAX_GROUPS {
                return Err(reader.too_large("groups", groups.len(), MAX_GROUPS));
            }
        }
        srdf.groups.append(&mut of_joints);
        // MoveIt ignores such groups too. If none is left, the SRDF is that of another robot.
        if !srdf.groups.is_empty() {
            let ignored = faults.extract_if(.., |fault| fault.parts("").0.is_some());
            srdf.passed_over
                .extend(ignored.map(|fault| ignored_group(&fault)));
        }
        for (node, joint) in virtual_joints(&document) {
            srdf.passed_over
                .extend(not_driven(&reader, node, &joint, robot));
            srdf.virtual_joints.push(joint);
        }
        faults.extend(srdf.read_states(&reader, root, &groups, robot));
        faults.extend(srdf.read_extensions(&reader, root, robot));
        faults.extend(srdf.read_pairs(&reader, root, &faults, robot));
        srdf.passed_over.extend(repaired.findings(name));
        Ok((srdf, faults))
    }

    /// Reads the pairs of links that are not checked, and returns their faults, except for links that the robot does not
    /// have: one warning names those that no earlier fault names.
    fn read_pairs(
        &mut self,
        reader: &Reader,
        root: Node,
        earlier: &[RobotError],
        robot: &RobotModel,
    ) -> Vec<RobotError> {
        let mut faults = Vec::new();
        let mut stale: Vec<(Place, Box<UnknownName>)> = Vec::new();
        let mut seen: BTreeSet<String> = earlier.iter().filter_map(unknown_name).collect();
        for node in elements(root, "disable_collisions") {
            let link = |attribute| reader.link_of(node, attribute, robot);
            match (link("link1"), link("link2")) {
                (Ok(a), Ok(b)) => self.disabled.push(DisabledPair {
                    a,
                    b,
                    reason: node.attribute("reason").unwrap_or_default().to_owned(),
                }),
                (a, b) => {
                    for fault in a.err().into_iter().chain(b.err()) {
                        match fault {
                            RobotError::UnknownAt { at, unknown } => {
                                if seen.insert(unknown.name.clone()) {
                                    stale.push((at, unknown));
                                }
                            }
                            fault => faults.push(fault),
                        }
                    }
                }
            }
        }
        self.passed_over.extend(stale_links(&stale, robot));
        faults
    }

    /// Reads the elements that extend the format, and returns their faults.
    fn read_extensions(
        &mut self,
        reader: &Reader,
        root: Node,
        robot: &RobotModel,
    ) -> Vec<RobotError> {
        let mut faults = Vec::new();
        for node in elements(root, "tool_holder") {
            match reader.tool_holder(node, robot) {
                Ok(holder) => self.tool_holders.push(holder),
                Err(fault) => faults.push(fault),
            }
        }
        for node in elements(root, "counterbalance") {
            match reader.counterbalanced(node, robot) {
                Ok(joint) => self.counterbalanced.push(joint),
                Err(fault) => faults.push(fault),
            }
        }
        faults
    }

    /// Returns how a link holds tools; `None` if the SRDF does not declare it.
    pub fn tool_holder(&self, link: LinkId) -> Option<&ToolHolder> {
        self.tool_holders.iter().find(|holder| holder.link == link)
    }

    /// Returns the group of this name.
    ///
    /// # Errors
    /// If there is none; the error has the nearest names.
    pub fn group(&self, name: &str) -> Result<&Group, RobotError> {
        let found = self.groups.iter().find(|group| group.name == name);
        let known = self.groups.iter().map(|group| group.name.as_str());
        found.ok_or_else(|| unknown("group that is a chain", name, known))
    }

    /// Returns the first posture of this name.
    ///
    /// # Errors
    /// If there is none; the error has the nearest names.
    pub fn state(&self, name: &str) -> Result<&GroupState, RobotError> {
        let found = self.states.iter().find(|state| state.name == name);
        let known = self.states.iter().map(|state| state.name.as_str());
        found.ok_or_else(|| unknown("group state", name, known))
    }

    fn ignore(&mut self, reader: &Reader, node: Node, what: String) {
        let at = reader.place(node);
        self.ignored.push(IgnoredElement { at, what });
    }

    /// Adds a chain to the groups; returns a group of joints that forms a chain.
    fn read_group(
        &mut self,
        reader: &Reader,
        node: Node,
        names: &mut BTreeSet<String>,
        robot: &RobotModel,
    ) -> Result<Option<Group>, RobotError> {
        let name = reader.name(node, "name")?;
        // Another definition of the name may be valid if the first is not.
        if !names.insert(name.clone()) && self.groups.iter().any(|known| known.name == name) {
            return Err(reader.fault(node, format!("group {name:?} is defined twice")));
        }
        if let Some((base, tip)) = joints_in_line(node, robot) {
            return Ok(Some(Group { name, base, tip }));
        }
        let mut members = node.children().filter(Node::is_element);
        let (Some(chain), None) = (members.next(), members.next()) else {
            self.ignore(reader, node, format!("group {name:?}: not one chain"));
            return Ok(None);
        };
        if !chain.has_tag_name("chain") {
            let what = chain.tag_name().name();
            self.ignore(
                reader,
                node,
                format!("group {name:?} of a {what}, not a chain"),
            );
            return Ok(None);
        }
        let [base, tip] = read_chain(reader, chain, &name, robot)?;
        self.groups.push(Group { name, base, tip });
        Ok(None)
    }
}

/// Returns base and tip of a group's chain.
fn read_chain(
    reader: &Reader,
    chain: Node,
    group: &str,
    robot: &RobotModel,
) -> Result<[LinkId; 2], RobotError> {
    let base = reader.link_of(chain, "base_link", robot)?;
    let tip = reader.link_of(chain, "tip_link", robot)?;
    if !robot.is_descendant(tip, base) {
        let [tip, base] = [tip, base].map(|link| &robot.links()[link.index()].name);
        let problem = format!("group {group:?}: link {tip:?} is no descendant of link {base:?}");
        return Err(reader.fault(chain, problem));
    }
    Ok([base, tip])
}

/// Returns the reason why a virtual joint moves nothing although its kind moves; `None` if it is
/// fixed, or part of the robot.
fn not_driven(
    reader: &Reader,
    node: Node,
    joint: &VirtualJoint,
    robot: &RobotModel,
) -> Option<Diagnostic> {
    let (name, kind) = (&joint.name, &joint.kind);
    if kind == "fixed" || robot.joint(&format!("{name}/x")).is_ok() {
        return None;
    }
    let severity = if joint.is_planar() {
        Severity::Warning
    } else {
        Severity::Note
    };
    let w = words(
        format!("virtual joint {name:?} of type {kind:?} moves nothing here"),
        "a planar joint from a new frame to the root link of the URDF, if the base drives",
        "the robot stands where the task puts it",
    );
    Some(finding(severity, reader.place(node), w))
}

/// Returns the warning about a group that the robot cannot have.
fn ignored_group(fault: &RobotError) -> Diagnostic {
    let (at, value, limit) = fault.parts("a group of this robot");
    let at = at.cloned().unwrap_or_else(|| Place::from_offset("", "", 0));
    let advice = "the group is ignored: correct it, or give the SRDF of this robot";
    finding(Severity::Warning, at, words(value, limit, advice))
}

/// Returns the note about the groups that are ignored.
fn ignored_groups(ignored: &[IgnoredElement]) -> Option<Diagnostic> {
    let first = ignored.first()?;
    let value = match ignored.len() {
        1 => format!("{}: it is ignored", first.what),
        count => {
            let names = ignored
                .iter()
                .filter_map(|group| group.what.split('"').nth(1));
            let names: Vec<String> = names.map(|name| format!("{name:?}")).collect();
            format!(
                "{count} groups are not one chain each, and are ignored: {}",
                names.join(", ")
            )
        }
    };
    let limit = "a group that is a single chain, if it is to wipe";
    let advice = "fine if it is for other programs or for postures only";
    let found = finding(
        Severity::Note,
        first.at.clone(),
        words(value, limit, advice),
    );
    Some(found)
}

/// Returns the unknown name of an error.
fn unknown_name(fault: &RobotError) -> Option<String> {
    match fault {
        RobotError::UnknownAt { unknown, .. } => Some(unknown.name.clone()),
        _ => None,
    }
}

/// Returns the warning about links of pairs that the robot does not have.
fn stale_links(stale: &[(Place, Box<UnknownName>)], robot: &RobotModel) -> Option<Diagnostic> {
    let (at, first) = stale.first()?;
    let value = match stale.len() {
        1 => first.to_string(),
        count => {
            let shown = stale.iter().take(LINKS_SHOWN);
            let names: Vec<String> = shown.map(|(_, link)| format!("{:?}", link.name)).collect();
            let more = match count.saturating_sub(LINKS_SHOWN) {
                0 => String::new(),
                more => format!(" and {more} more"),
            };
            format!("{count} unknown links: {}{more}", names.join(", "))
        }
    };
    let w = words(
        value,
        format!("links of robot {:?}", robot.name()),
        "pairs with them are ignored: remove them, or give the SRDF of this robot",
    );
    Some(finding(Severity::Warning, at.clone(), w))
}

/// Returns a diagnostic of an SRDF that is not an error.
pub(super) fn finding(severity: Severity, at: Place, words: Words) -> Diagnostic {
    Diagnostic {
        severity,
        at,
        subject: Subject::Robot,
        kind: DiagnosticKind::Srdf,
        value: words.value,
        limit: words.limit,
        advice: words.advice,
    }
}

/// Returns the ends of a group that lists the joints of a chain in any order, as most SRDFs of arms do; fixed joints may
/// be left out.
fn joints_in_line(group: Node, robot: &RobotModel) -> Option<(LinkId, LinkId)> {
    let mut listed = Vec::new();
    for member in group.children().filter(Node::is_element) {
        let id = robot.joint(member.attribute("name")?.trim()).ok()?;
        if !member.has_tag_name("joint") {
            return None;
        }
        let joint = &robot.joints()[id.index()];
        let is_moving = robot.variables().contains(&id);
        listed.push((robot.joints_above(joint.child).count(), joint, is_moving));
    }
    // From the root outwards.
    listed.sort_by_key(|(depth, ..)| *depth);
    let mut line: Option<(LinkId, LinkId)> = None;
    for (_, joint, _) in &listed {
        let base = match line {
            None => joint.parent,
            Some((base, tip)) => {
                let fixed = |joint: &&Joint| joint.kind == JointKind::Fixed;
                let mut held = robot.joints_above(joint.parent).take_while(fixed);
                let follows = joint.parent == tip || held.any(|joint| joint.parent == tip);
                follows.then_some(base)?
            }
        };
        line = Some((base, joint.child));
    }
    let moving = listed.iter().filter(|(.., is_moving)| *is_moving).count();
    line.filter(|_| moving >= 2)
}

/// Converts a fault of an SRDF into a diagnostic.
fn diagnostic(fault: &RobotError, file: &str, robot: &RobotModel) -> Diagnostic {
    let (at, value, limit) = fault.parts("an SRDF of this robot");
    let limit = match fault {
        RobotError::UnknownAt { unknown, .. } => {
            format!("a {} of robot {:?}", unknown.kind, robot.name())
        }
        _ => limit,
    };
    let start = || Place::from_offset(file, "", 0);
    Diagnostic {
        severity: Severity::Error,
        at: at.cloned().unwrap_or_else(start),
        subject: Subject::Robot,
        kind: DiagnosticKind::Srdf,
        value,
        limit,
        advice: "correct it, or give the SRDF of this robot".to_owned(),
    }
}

fn unknown<'a>(kind: &'static str, name: &str, known: impl Iterator<Item = &'a str>) -> RobotError {
    RobotError::NoSuch(Box::new(UnknownName::new(kind, name, known)))
}

impl RobotModel {
    /// Whether `tip` is `base` or a descendant of it.
    fn is_descendant(&self, tip: LinkId, base: LinkId) -> bool {
        let mut at = tip;
        while at != base {
            let Some(joint) = self.links()[at.index()].parent else {
                return false;
            };
            at = self.joints()[joint.index()].parent;
        }
        true
    }
}

impl Reader<'_> {
    pub(super) fn unknown_at<'n>(
        &self,
        node: Node,
        kind: &'static str,
        name: &str,
        known: impl Iterator<Item = &'n str>,
    ) -> RobotError {
        RobotError::UnknownAt {
            at: self.place(node),
            unknown: Box::new(UnknownName::new(kind, name, known)),
        }
    }

    fn counterbalanced(&self, node: Node, robot: &RobotModel) -> Result<JointId, RobotError> {
        let name = self.name(node, "joint")?;
        robot.joint(&name).map_err(|_| {
            let known = robot.joints().iter().map(|joint| joint.name.as_str());
            self.unknown_at(node, "joint", &name, known)
        })
    }

    fn tool_holder(&self, node: Node, robot: &RobotModel) -> Result<ToolHolder, RobotError> {
        let link = self.link_of(node, "link", robot)?;
        let hand_lean = self.number(node, "hand_lean_rad")?;
        if hand_lean.is_some_and(|lean| !MAX_LEAN.contains(&lean)) {
            let expected = "a lean from 0 to 1.57 rad";
            return Err(self.attribute_fault(node, "hand_lean_rad", expected));
        }
        let axis = match node.attribute("axis") {
            None => LinkAxis::default(),
            Some(name) => LinkAxis::from_name(name.trim())
                .ok_or_else(|| self.attribute_fault(node, "axis", "x, -x, y, -y, z or -z"))?,
        };
        Ok(ToolHolder {
            link,
            axis,
            hand_lean,
        })
    }

    fn link_of(
        &self,
        node: Node,
        attribute: &'static str,
        robot: &RobotModel,
    ) -> Result<LinkId, RobotError> {
        let name = self.name(node, attribute)?;
        robot.link(&name).map_err(|_| {
            let known = robot.links().iter().map(|link| link.name.as_str());
            self.unknown_at(node, "link", &name, known)
        })
    }
}
