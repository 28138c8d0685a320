//! A URDF as typed, before its checks.
//!
//! It is read with `roxmltree` rather than `urdf-rs`, which fills in missing values (so that an absent limit looks like
//! 0), drops unknown elements (`<wisch>` below) and keeps no places for messages.
//!
//! Beyond URDF, `<limit acceleration="…">` of URDF 1.2 and `<capsule>` are supported, as well as an extension for
//! joints that follow several others, which other readers skip:
//!
//! ```xml
//! <wisch>
//!   <mimic joint="torso_4" offset="0">
//!     <term joint="torso_2" multiplier="-1"/>
//!     <term joint="torso_3" multiplier="-1"/>
//!   </mimic>
//! </wisch>
//! ```
//!
//! The limits of such a joint apply to the sum, which expresses coupled limits.

use super::diagnostics::{Words, words};
use super::elements::{
    Urdf, UrdfGeometry, UrdfInertial, UrdfJoint, UrdfLimit, UrdfLink, UrdfMimic, UrdfShape,
};
use super::planar;
use super::repair::Repaired;
use super::xml::{MAX_URDF_BYTES, parsing_options};
use crate::geometry::{MAX_ATTRIBUTES, Pose, Vector3, most_attributes};
use crate::source_location::Place;
use crate::{Diagnostic, DiagnosticKind, RobotError, Severity, Subject};
use nalgebra::{Matrix3, Translation3, UnitQuaternion};
use roxmltree::{Document, Node};
use std::cell::RefCell;
use std::collections::BTreeSet;

/// Largest number of links of a robot.
pub const MAX_LINKS: usize = 1000;
/// Largest number of collision shapes of a robot.
pub const MAX_SHAPES: usize = 10_000;
/// Largest number of elements that deviate from the format.
const MAX_DEVIATIONS: usize = 1000;
/// Largest number of terms of all followers.
const MAX_TERMS: usize = 10_000;
/// Elements of shapes; `<capsule>` is an extension.
const SHAPES: [&str; 5] = ["box", "cylinder", "capsule", "sphere", "mesh"];
/// Elements of xacro that only its sources have.
const XACRO_SOURCE: [&str; 8] = [
    "include",
    "macro",
    "property",
    "arg",
    "if",
    "unless",
    "insert_block",
    "call",
];
/// Start of the names of xacro's elements in a text that does not declare its prefix, after the repair.
const UNDECLARED_XACRO: &str = "xacro_";
/// Largest usual angle of an origin [rad]: a full turn.
const MOST_TURN: f64 = 6.3;
/// Largest absolute number, in any unit.
const MAX_NUMBER: f64 = 1e9;

/// Text of a file, for messages with places.
pub(crate) struct Reader<'a> {
    file: &'a str,
    text: &'a str,
    /// Deviations from the format whose meaning is clear.
    findings: RefCell<Vec<Diagnostic>>,
}

impl Urdf {
    pub fn read(file: &str, text: &str) -> Result<Self, RobotError> {
        let repaired = Repaired::new(text);
        let mut urdf = Self::read_xml(file, &repaired.text)?;
        urdf.findings.extend(repaired.findings(file));
        Ok(urdf)
    }

    fn read_xml(file: &str, text: &str) -> Result<Self, RobotError> {
        let reader = Reader::new(file, text);
        let document = reader.document()?;
        let root = reader.robot(&document)?;
        let too_large = |what, value, limit| reader.too_large(what, value, limit);
        let mut urdf = Self {
            robot: root.attribute("name").unwrap_or_default().to_owned(),
            links: Vec::new(),
            joints: Vec::new(),
            mimics: Vec::new(),
            findings: Vec::new(),
        };
        reader.check_xacro(root)?;
        for node in root.children().filter(Node::is_element) {
            match node.tag_name().name() {
                "link" => urdf.links.push(reader.link(node)?),
                "joint" => {
                    let (joint, mimic) = reader.joint(node)?;
                    let (joints, links) = planar::split(joint);
                    urdf.joints.extend(joints);
                    urdf.links.extend(links);
                    urdf.mimics.extend(mimic);
                }
                "wisch" => {
                    for mimic in elements(node, "mimic") {
                        urdf.mimics.push(reader.sum_mimic(mimic)?);
                    }
                }
                _ => {}
            }
            if urdf.links.len() > MAX_LINKS {
                return Err(too_large("links", urdf.links.len(), MAX_LINKS));
            }
            if urdf.joints.len() > MAX_LINKS {
                return Err(too_large("joints", urdf.joints.len(), MAX_LINKS));
            }
        }
        let shapes = urdf.links.iter().map(|link| link.shapes.len()).sum();
        let terms = urdf.mimics.iter().map(|mimic| mimic.terms.len()).sum();
        if terms > MAX_TERMS {
            return Err(too_large("terms of mimics", terms, MAX_TERMS));
        }
        if urdf.mimics.len() > MAX_LINKS {
            return Err(too_large("mimics", urdf.mimics.len(), MAX_LINKS));
        }
        if shapes > MAX_SHAPES {
            return Err(too_large("collision shapes", shapes, MAX_SHAPES));
        }
        if urdf.links.is_empty() {
            return Err(reader.fault(
                root,
                "there is no <link>: this is no URDF of a robot, but perhaps its SRDF".to_owned(),
            ));
        }
        let deviations = reader.findings.borrow().len();
        if deviations > MAX_DEVIATIONS {
            let what = "elements that deviate from the format";
            return Err(reader.too_large(what, deviations, MAX_DEVIATIONS));
        }
        urdf.findings = reader.findings.into_inner();
        Ok(urdf)
    }
}

pub(crate) fn elements<'a, 'i>(
    node: Node<'a, 'i>,
    name: &'static str,
) -> impl Iterator<Item = Node<'a, 'i>> {
    node.children()
        .filter(move |child| child.has_tag_name(name))
}

pub(crate) fn element<'a, 'i>(node: Node<'a, 'i>, name: &'static str) -> Option<Node<'a, 'i>> {
    elements(node, name).next()
}

impl<'a> Reader<'a> {
    pub fn new(file: &'a str, text: &'a str) -> Self {
        Self {
            file,
            text,
            findings: RefCell::default(),
        }
    }

    /// Keeps a warning about an element that deviates from the format, up to the limit.
    pub fn warn(&self, node: Node, subject: Subject, words: Words) {
        self.warn_of(DiagnosticKind::Syntax, node, subject, words);
    }

    /// Keeps a warning of a kind about an element.
    pub fn warn_of(&self, kind: DiagnosticKind, node: Node, subject: Subject, words: Words) {
        let mut findings = self.findings.borrow_mut();
        if findings.len() > MAX_DEVIATIONS {
            return;
        }
        findings.push(Diagnostic {
            severity: Severity::Warning,
            at: self.place(node),
            subject,
            kind,
            value: words.value,
            limit: words.limit,
            advice: words.advice,
        });
    }

    /// Parses the XML, within the limits.
    pub fn document(&self) -> Result<Document<'a>, RobotError> {
        if self.text.len() > MAX_URDF_BYTES {
            return Err(self.too_large("bytes", self.text.len(), MAX_URDF_BYTES));
        }
        let attributes = most_attributes(self.text);
        if attributes > MAX_ATTRIBUTES {
            let what = "attributes of an element";
            return Err(self.too_large(what, attributes, MAX_ATTRIBUTES));
        }
        Document::parse_with_options(self.text, parsing_options()).map_err(|error| {
            let at = Place {
                file: self.file.to_owned(),
                line: error.pos().row as usize,
                column: error.pos().col as usize,
            };
            if matches!(error, roxmltree::Error::DtdDetected) {
                let offset = self.text.find("<!DOCTYPE").unwrap_or(0);
                let problem = "a document type declaration (DTD) is not read; remove <!DOCTYPE ...> and write its entities out";
                return RobotError::Syntax {
                    at: Place::from_offset(self.file, self.text, offset),
                    problem: problem.to_owned(),
                };
            }
            // The place is named already.
            let text = error.to_string();
            let text = text.strip_suffix(&format!(" at {}", error.pos()));
            let text = text.map_or_else(|| error.to_string(), str::to_owned);
            let problem = format!("this is not XML: {text}");
            RobotError::Syntax { at, problem }
        })
    }

    /// Returns the root element, which is `<robot>` in URDF and SRDF.
    pub fn robot<'d>(&self, document: &'d Document<'a>) -> Result<Node<'d, 'a>, RobotError> {
        let root = document.root_element();
        if root.tag_name().name() == "robot" {
            return Ok(root);
        }
        let problem = format!("expected <robot>, found <{}>", root.tag_name().name());
        Err(self.fault(root, problem))
    }

    /// Warns of elements that xacro has left in a URDF, each name once.
    ///
    /// # Errors
    /// If the text is a source of xacro: it defines or includes something, or has no link.
    fn check_xacro(&self, root: Node) -> Result<(), RobotError> {
        let is_xacro = |node: &Node| {
            let namespace = node.tag_name().namespace();
            let is_named = node.tag_name().name().starts_with(UNDECLARED_XACRO);
            is_named || namespace.is_some_and(|namespace| namespace.contains("xacro"))
        };
        let has_links = element(root, "link").is_some();
        let mut known = BTreeSet::new();
        for node in root.descendants().filter(Node::is_element).filter(is_xacro) {
            let name = node.tag_name().name();
            let name = name.strip_prefix(UNDECLARED_XACRO).unwrap_or(name);
            if XACRO_SOURCE.contains(&name) || !has_links {
                return Err(self.not_expanded(node, &format!("<xacro:{name}>")));
            }
            if known.insert(name) {
                let w = words(
                    format!("<xacro:{name}> is not expanded"),
                    "plain URDF",
                    "it is ignored, as other programs do; expand the source of this file again if it stands for links or joints",
                );
                self.warn(node, Subject::Robot, w);
            }
        }
        Ok(())
    }

    /// Returns the error about a text that must be expanded first.
    fn not_expanded(&self, node: Node, what: &str) -> RobotError {
        let file = self.file;
        let problem = format!(
            "{what} is not expanded; expected plain URDF: make it with `xacrodoc {file} -o robot.urdf` (pip install xacrodoc), or in ROS with `xacro {file} > robot.urdf`"
        );
        self.fault(node, problem)
    }

    pub fn too_large(&self, what: &'static str, value: usize, limit: usize) -> RobotError {
        let file = self.file.to_owned();
        RobotError::TooLarge {
            file,
            what,
            value,
            limit,
        }
    }

    pub fn place(&self, node: Node) -> Place {
        Place::from_offset(self.file, self.text, node.range().start)
    }

    pub fn fault(&self, node: Node, problem: String) -> RobotError {
        RobotError::Syntax {
            at: self.place(node),
            problem,
        }
    }

    pub fn attribute_fault(
        &self,
        node: Node,
        attribute: &'static str,
        expected: &'static str,
    ) -> RobotError {
        RobotError::Attribute {
            at: self.place(node),
            element: node.tag_name().name().to_owned(),
            attribute,
            text: node.attribute(attribute).unwrap_or_default().to_owned(),
            expected,
        }
    }

    pub fn name(&self, node: Node, attribute: &'static str) -> Result<String, RobotError> {
        match node.attribute(attribute).map(str::trim) {
            Some(name) if !name.is_empty() => Ok(name.to_owned()),
            _ => Err(self.attribute_fault(node, attribute, "a name")),
        }
    }

    /// Reads N numbers; `None` if the attribute is missing.
    pub fn numbers<const N: usize>(
        &self,
        node: Node,
        attribute: &'static str,
    ) -> Result<Option<[f64; N]>, RobotError> {
        let Some(text) = node.attribute(attribute) else {
            return Ok(None);
        };
        if text.contains("${") || text.contains("$(") {
            let element = node.tag_name().name();
            return Err(self.not_expanded(node, &format!("<{element} {attribute}={text:?}>")));
        }
        let mut numbers = [0.0; N];
        let is_separator = |c: char| c.is_ascii_whitespace() || c == ',';
        let mut words = text.split(is_separator).filter(|word| !word.is_empty());
        for number in &mut numbers {
            *number = words
                .next()
                .and_then(|word| word.parse().ok())
                .filter(|value: &f64| value.abs() <= MAX_NUMBER)
                .ok_or_else(|| self.attribute_fault(node, attribute, expected(N)))?;
        }
        match words.next() {
            None => {
                self.warn_of_commas(node, attribute, text);
                Ok(Some(numbers))
            }
            Some(_) => Err(self.attribute_fault(node, attribute, expected(N))),
        }
    }

    fn warn_of_commas(&self, node: Node, attribute: &str, text: &str) {
        if text.contains(',') {
            let element = node.tag_name().name();
            let w = words(
                format!("<{element} {attribute}={text:?}> has commas"),
                "spaces between the numbers",
                "the commas are read as spaces; remove them for other programs",
            );
            self.warn(node, Subject::Robot, w);
        }
    }

    pub fn number(&self, node: Node, attribute: &'static str) -> Result<Option<f64>, RobotError> {
        Ok(self.numbers::<1>(node, attribute)?.map(|[value]| value))
    }

    /// Reads a limit; `None` if it is missing or infinite.
    fn limit(&self, node: Node, attribute: &'static str) -> Result<Option<f64>, RobotError> {
        let infinite = node
            .attribute(attribute)
            .and_then(|text| text.trim().parse::<f64>().ok())
            .is_some_and(|value| value.is_infinite() || value.abs() > MAX_NUMBER);
        if infinite {
            Ok(None)
        } else {
            self.number(node, attribute)
        }
    }

    pub fn require(&self, node: Node, attribute: &'static str) -> Result<f64, RobotError> {
        self.number(node, attribute)?
            .ok_or_else(|| self.attribute_fault(node, attribute, expected(1)))
    }

    /// Reads a size of at least 0.
    fn size(&self, node: Node, attribute: &'static str) -> Result<f64, RobotError> {
        let value = self.require(node, attribute)?;
        if value >= 0.0 {
            Ok(value)
        } else {
            Err(self.attribute_fault(node, attribute, "a length of at least 0 m"))
        }
    }

    fn origin(&self, node: Node) -> Result<Pose, RobotError> {
        let Some(origin) = element(node, "origin") else {
            return Ok(Pose::identity());
        };
        let [x, y, z] = self.numbers(origin, "xyz")?.unwrap_or_default();
        let rpy: [f64; 3] = self.numbers(origin, "rpy")?.unwrap_or_default();
        if rpy.iter().any(|angle| angle.abs() > MOST_TURN) {
            self.warn_of_degrees(origin, rpy);
        }
        let [roll, pitch, yaw] = rpy;
        Ok(Pose::from_parts(
            Translation3::new(x, y, z),
            UnitQuaternion::from_euler_angles(roll, pitch, yaw),
        ))
    }

    /// Warns of an origin with angles above a full turn, of the joint or the link to which it belongs.
    fn warn_of_degrees(&self, origin: Node, [roll, pitch, yaw]: [f64; 3]) {
        let owner =
            (origin.ancestors()).find(|node| matches!(node.tag_name().name(), "joint" | "link"));
        let name = owner.and_then(|owner| owner.attribute("name"));
        let name = name.unwrap_or_default().to_owned();
        let subject = match owner {
            Some(owner) if owner.tag_name().name() == "joint" => Subject::Joint(name),
            Some(_) => Subject::Link(name),
            None => Subject::Robot,
        };
        let w = words(
            format!("its origin turns by rpy = {roll} {pitch} {yaw} rad"),
            format!("each within {MOST_TURN} rad"),
            "they are probably in degrees: multiply by 0.0174533",
        );
        self.warn_of(DiagnosticKind::Units, origin, subject, w);
    }

    fn link(&self, node: Node) -> Result<UrdfLink, RobotError> {
        let mut link = UrdfLink {
            name: self.name(node, "name")?,
            at: node.range().start,
            inertial: element(node, "inertial")
                .map(|inertial| self.inertial(inertial))
                .transpose()?,
            shapes: Vec::new(),
        };
        for collision in elements(node, "collision") {
            match self.geometry(collision) {
                Ok(geometry) => link.shapes.push(self.shape_of(collision, geometry)?),
                Err(problem) => {
                    let w = words(
                        problem,
                        "<geometry> with a box, cylinder, capsule, sphere or mesh",
                        "the element is ignored, so collisions of this part of the link are not checked",
                    );
                    let kind = DiagnosticKind::CollisionMissing;
                    self.warn_of(kind, collision, Subject::Link(link.name.clone()), w);
                }
            }
        }
        Ok(link)
    }

    fn inertial(&self, node: Node) -> Result<UrdfInertial, RobotError> {
        let mass = match element(node, "mass") {
            Some(mass) => self.require(mass, "value")?,
            None => 0.0,
        };
        let mut about_center = Matrix3::zeros();
        if let Some(inertia) = element(node, "inertia") {
            let entry = |name| Ok(self.number(inertia, name)?.unwrap_or(0.0));
            let (xx, yy, zz) = (entry("ixx")?, entry("iyy")?, entry("izz")?);
            let (xy, xz, yz) = (entry("ixy")?, entry("ixz")?, entry("iyz")?);
            about_center = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        }
        Ok(UrdfInertial {
            at: node.range().start,
            mass,
            link_from_inertia: self.origin(node)?,
            about_center,
        })
    }

    /// Reads the shape of a `<visual>`.
    pub fn shape(&self, node: Node) -> Result<UrdfShape, RobotError> {
        let geometry = self.geometry(node);
        self.shape_of(node, geometry.map_err(|problem| self.fault(node, problem))?)
    }

    /// Returns the element of a known shape in a `<collision>` or a `<visual>`.
    fn geometry<'n, 'i>(&self, node: Node<'n, 'i>) -> Result<Node<'n, 'i>, String> {
        let geometry = element(node, "geometry")
            .and_then(|geometry| geometry.children().find(Node::is_element))
            .ok_or_else(|| format!("<{}> has no <geometry>", node.tag_name().name()))?;
        match geometry.tag_name().name() {
            known if SHAPES.contains(&known) => Ok(geometry),
            other => Err(format!(
                "unknown shape <{other}>; known: {}",
                SHAPES.join(", ")
            )),
        }
    }

    fn shape_of(&self, node: Node, geometry: Node) -> Result<UrdfShape, RobotError> {
        let shape = match geometry.tag_name().name() {
            "box" => {
                let [x, y, z] = self
                    .numbers(geometry, "size")?
                    .filter(|size| size.iter().all(|side| *side >= 0.0))
                    .ok_or_else(|| {
                        self.attribute_fault(geometry, "size", "three lengths of at least 0 m")
                    })?;
                UrdfGeometry::Box(Vector3::new(x, y, z))
            }
            "cylinder" => UrdfGeometry::Cylinder {
                radius: self.size(geometry, "radius")?,
                length: self.size(geometry, "length")?,
            },
            "capsule" => UrdfGeometry::Capsule {
                radius: self.size(geometry, "radius")?,
                length: self.size(geometry, "length")?,
            },
            "sphere" => UrdfGeometry::Sphere(self.size(geometry, "radius")?),
            // A mesh.
            _ => {
                let [x, y, z] = self.numbers(geometry, "scale")?.unwrap_or([1.0; 3]);
                UrdfGeometry::Mesh {
                    file: self.name(geometry, "filename")?,
                    scale: Vector3::new(x, y, z),
                }
            }
        };
        Ok(UrdfShape {
            at: geometry.range().start,
            link_from_shape: self.origin(node)?,
            geometry: shape,
        })
    }

    fn joint(&self, node: Node) -> Result<(UrdfJoint, Option<UrdfMimic>), RobotError> {
        let name = self.name(node, "name")?;
        let end = |tag: &'static str| match element(node, tag) {
            Some(end) => self.name(end, "link"),
            None => Err(self.fault(node, format!("joint {name:?} has no <{tag}>"))),
        };
        let kind = self.name(node, "type")?;
        // Where there is no motion, urdfdom reads no axis either.
        let axis = element(node, "axis").filter(|_| !matches!(kind.as_str(), "fixed" | "floating"));
        let axis = match axis {
            Some(axis) => self
                .numbers(axis, "xyz")?
                .ok_or_else(|| self.attribute_fault(axis, "xyz", expected(3)))?,
            None => [1.0, 0.0, 0.0],
        };
        let limit = |limit| {
            Ok(UrdfLimit {
                lower: self.limit(limit, "lower")?,
                upper: self.limit(limit, "upper")?,
                velocity: self.limit(limit, "velocity")?,
                effort: self.limit(limit, "effort")?,
                acceleration: self.limit(limit, "acceleration")?,
            })
        };
        let mimic = |mimic| {
            let multiplier = self.number(mimic, "multiplier")?.unwrap_or(1.0);
            Ok(UrdfMimic {
                at: mimic.range().start,
                joint: name.clone(),
                offset: self.number(mimic, "offset")?.unwrap_or(0.0),
                terms: vec![(self.name(mimic, "joint")?, multiplier)],
            })
        };
        let mimic = element(node, "mimic").map(mimic).transpose()?;
        let mut limit = element(node, "limit").map(limit).transpose()?;
        let is_limited = matches!(kind.as_str(), "revolute" | "prismatic");
        let assumed_limit = match (&mut limit, element(node, "limit")) {
            (Some(limit), Some(stated)) if is_limited => assume_limit(limit, stated),
            _ => None,
        };
        let soft_limits = match (&mut limit, element(node, "safety_controller")) {
            (Some(limit), Some(soft)) if is_limited => self.narrow(limit, soft, &name)?,
            _ => None,
        };
        let joint = UrdfJoint {
            at: node.range().start,
            kind,
            parent: end("parent")?,
            child: end("child")?,
            parent_from_joint: self.origin(node)?,
            axis: Vector3::from(axis),
            limit,
            soft_limits,
            assumed_limit,
            name,
        };
        Ok((joint, mimic))
    }

    /// Narrows position limits to the soft ones of a safety controller, and returns those if they are narrower. Warns of
    /// soft limits that are reversed, outside the hard ones, or stated on one side only.
    fn narrow(
        &self,
        limit: &mut UrdfLimit,
        soft: Node,
        joint: &str,
    ) -> Result<Option<[f64; 2]>, RobotError> {
        let Some([lower, upper]) = self.soft_limits(soft, joint)? else {
            return Ok(None);
        };
        // Reversed hard limits are exchanged later, with a warning; the soft ones count within them.
        let is_reversed =
            matches!((limit.lower, limit.upper), (Some(low), Some(high)) if low > high);
        let (low, high) = if is_reversed {
            (limit.upper, limit.lower)
        } else {
            (limit.lower, limit.upper)
        };
        let narrowed = [
            low.map_or(lower, |hard| hard.max(lower)),
            high.map_or(upper, |hard| hard.min(upper)),
        ];
        if narrowed[0] >= narrowed[1] {
            let value = format!("soft limits {lower} to {upper}, outside those of <limit>");
            let advice = "the soft limits are ignored: correct them, or remove <safety_controller>";
            self.warn_of_soft_limits(soft, joint, value, advice);
            return Ok(None);
        }
        if low == Some(narrowed[0]) && high == Some(narrowed[1]) {
            return Ok(None);
        }
        let [least, most] = narrowed.map(Some);
        (limit.lower, limit.upper) = if is_reversed {
            (most, least)
        } else {
            (least, most)
        };
        Ok(Some(narrowed))
    }

    /// Returns the soft limits of a safety controller in their order. A limit that is not stated is 0, the default of URDF,
    /// or infinite where 0 leaves no range; a controller that states none has none.
    fn soft_limits(&self, soft: Node, joint: &str) -> Result<Option<[f64; 2]>, RobotError> {
        let lower = self.limit(soft, "soft_lower_limit")?;
        let upper = self.limit(soft, "soft_upper_limit")?;
        let (range, absent) = match (lower, upper) {
            (Some(lower), Some(upper)) if lower > upper => {
                let value = format!("reversed soft limits, {lower} and {upper}");
                let advice = "they are exchanged; correct them";
                self.warn_of_soft_limits(soft, joint, value, advice);
                return Ok(Some([upper, lower]));
            }
            // Absent soft limits are often written as 0 and 0.
            (Some(lower), Some(upper)) => return Ok((lower < upper).then_some([lower, upper])),
            (Some(lower), None) if lower < 0.0 => ([lower, 0.0], "soft_upper_limit"),
            (Some(lower), None) => ([lower, f64::INFINITY], "soft_upper_limit"),
            (None, Some(upper)) if upper > 0.0 => ([0.0, upper], "soft_lower_limit"),
            (None, Some(upper)) => ([f64::NEG_INFINITY, upper], "soft_lower_limit"),
            (None, None) => return Ok(None),
        };
        let advice = if range.iter().all(|limit| limit.is_finite()) {
            "add it; without it 0 is assumed, the default of URDF"
        } else {
            "add it; without it the hard limit counts on this side"
        };
        self.warn_of_soft_limits(
            soft,
            joint,
            format!("no {absent}, but the other one"),
            advice,
        );
        Ok(Some(range))
    }

    fn warn_of_soft_limits(&self, soft: Node, joint: &str, value: String, advice: &str) {
        let value = format!("its safety controller has {value}");
        let w = words(value, "soft_lower_limit < soft_upper_limit", advice);
        let subject = Subject::Joint(joint.to_owned());
        self.warn_of(DiagnosticKind::Limit, soft, subject, w);
    }

    fn sum_mimic(&self, node: Node) -> Result<UrdfMimic, RobotError> {
        let term = |term| {
            let multiplier = self.number(term, "multiplier")?.unwrap_or(1.0);
            Ok((self.name(term, "joint")?, multiplier))
        };
        Ok(UrdfMimic {
            at: node.range().start,
            joint: self.name(node, "joint")?,
            offset: self.number(node, "offset")?.unwrap_or(0.0),
            terms: elements(node, "term").map(term).collect::<Result<_, _>>()?,
        })
    }
}

/// Sets a position limit that is absent beside the other one to 0, its default in the format, if that leaves a range;
/// returns the name of its attribute.
fn assume_limit(limit: &mut UrdfLimit, stated: Node) -> Option<&'static str> {
    let is_absent = |attribute: &str| stated.attribute(attribute).is_none();
    match (limit.lower, limit.upper) {
        (None, Some(upper)) if upper > 0.0 && is_absent("lower") => {
            limit.lower = Some(0.0);
            Some("lower")
        }
        (Some(lower), None) if lower < 0.0 && is_absent("upper") => {
            limit.upper = Some(0.0);
            Some("upper")
        }
        _ => None,
    }
}

const fn expected(count: usize) -> &'static str {
    match count {
        1 => "a number within 1e9",
        3 => "three numbers within 1e9, with spaces between them",
        _ => "four numbers within 1e9, with spaces between them",
    }
}
