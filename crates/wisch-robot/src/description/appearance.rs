//! Visual geometry of a robot, from the `<visual>` elements of its URDF. It is for display only.

use super::collision::{MAX_MESH_EXTENT, Shape, load};
use super::diagnostics::Diagnostics;
use super::repair::Repaired;
use super::urdf::{MAX_SHAPES, Reader, element, elements};
use crate::geometry::Pose;
use crate::source_location::Place;
use crate::{Diagnostic, DiagnosticKind, LinkId, RobotError, RobotModel, Severity, Subject};
use roxmltree::Node;
use std::collections::BTreeMap;

/// A `<visual>` element of a URDF: a shape fixed to a link.
#[derive(Debug, Clone, PartialEq)]
pub struct Visual {
    /// Pose of the shape in the link frame.
    pub link_from_shape: Pose,
    /// The shape in its own frame.
    pub shape: Shape,
    /// Red, green, blue and opacity of its `<material>`, in [0, 1]; `None` if the URDF has none.
    pub color: Option<[f64; 4]>,
}

/// The visual geometry of a robot, by link.
#[derive(Debug, Clone, PartialEq)]
pub struct Appearance {
    links: Vec<Option<Vec<Visual>>>,
    diagnostics: Vec<Diagnostic>,
}

impl Appearance {
    /// Reads the visual geometry of a URDF. `name` identifies the text in messages. `meshes` returns the bytes of a
    /// mesh, given its file name in the URDF, or an error text. A link has no visual geometry if any of it is invalid,
    /// cannot be read, or is longer than [`MAX_MESH_EXTENT`]; a diagnostic reports it.
    ///
    /// # Errors
    /// If the text is no URDF or exceeds a limit.
    ///
    /// ```
    /// use wisch_robot::{Appearance, RobotModel, Shape};
    /// let text = r#"<robot name="r">
    ///   <material name="steel"><color rgba="0.6 0.6 0.7 1"/></material>
    ///   <link name="base"><visual><geometry><sphere radius="0.1"/></geometry><material name="steel"/></visual></link>
    /// </robot>"#;
    /// let robot = RobotModel::from_urdf("r.urdf", text, &mut |_| Err("no meshes".into()))?;
    /// let looks = Appearance::from_urdf("r.urdf", text, &robot, &mut |_| Err("no meshes".into()))?;
    /// let base = looks.visuals(robot.root()).ok_or("the base has visual geometry")?;
    /// assert_eq!(base[0].shape, Shape::Sphere { radius: 0.1 });
    /// assert_eq!(base[0].color, Some([0.6, 0.6, 0.7, 1.0]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_urdf(
        name: &str,
        text: &str,
        robot: &RobotModel,
        meshes: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
    ) -> Result<Self, RobotError> {
        let repaired = Repaired::new(text);
        let reader = Reader::new(name, &repaired.text);
        let document = reader.document()?;
        let root = reader.robot(&document)?;
        let mut report = Diagnostics {
            file: name,
            text,
            diagnostics: Vec::new(),
        };
        let materials = materials(&reader, root, &mut report);
        let mut of_name = BTreeMap::new();
        let mut count = 0;
        for link in elements(root, "link") {
            count += elements(link, "visual").count();
            if count > MAX_SHAPES {
                return Err(reader.too_large("visual shapes", count, MAX_SHAPES));
            }
            let name = reader.name(link, "name")?;
            let visuals = visuals(&reader, &name, link, &materials, meshes, &mut report);
            of_name.insert(name, visuals);
        }
        let links = robot.links().iter();
        Ok(Self {
            links: links
                // The links between the parts of a planar joint have no element.
                .map(|link| of_name.remove(&link.name).unwrap_or(Some(Vec::new())))
                .collect(),
            diagnostics: report.diagnostics,
        })
    }

    /// Whether no link has visual geometry.
    pub fn is_empty(&self) -> bool {
        self.links.iter().flatten().all(Vec::is_empty)
    }

    /// Returns the visual geometry of a link, empty if the URDF has none; `None` if it cannot be read or the robot has
    /// no such link.
    pub fn visuals(&self, link: LinkId) -> Option<&[Visual]> {
        self.links.get(link.index())?.as_deref()
    }

    /// Notes on visual geometry that could not be read; none is an error.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.diagnostics
    }
}

/// Reports a fault of visual geometry as a note.
fn note(report: &mut Diagnostics<'_>, subject: Subject, fault: &RobotError) {
    let (at, value, limit) = fault.parts("visual geometry");
    report.diagnostics.push(Diagnostic {
        severity: Severity::Note,
        at: at
            .cloned()
            .unwrap_or_else(|| Place::from_offset(report.file, "", 0)),
        subject,
        kind: DiagnosticKind::Visual,
        value,
        limit,
        advice: ADVICE.to_owned(),
    });
}

const ADVICE: &str = "until it is corrected, collision geometry is shown instead";

/// Colours by the name of their materials.
type Colors = BTreeMap<String, Option<[f64; 4]>>;

/// Returns the colours of the robot's `<material>` elements.
fn materials(reader: &Reader<'_>, root: Node<'_, '_>, report: &mut Diagnostics<'_>) -> Colors {
    let mut colors = BTreeMap::new();
    for material in elements(root, "material") {
        let read = reader
            .name(material, "name")
            .and_then(|name| Ok((name, color(reader, material)?)));
        match read {
            Ok((name, color)) => {
                colors.insert(name, color);
            }
            Err(fault) => note(report, Subject::Robot, &fault),
        }
    }
    colors
}

fn color(reader: &Reader<'_>, material: Node<'_, '_>) -> Result<Option<[f64; 4]>, RobotError> {
    let Some(color) = element(material, "color") else {
        return Ok(None);
    };
    let rgba: Option<[f64; 4]> = reader.numbers(color, "rgba")?;
    match rgba {
        Some(rgba) if rgba.iter().all(|part| (0.0..=1.0).contains(part)) => Ok(Some(rgba)),
        _ => Err(reader.attribute_fault(color, "rgba", "four numbers in [0, 1]")),
    }
}

/// Returns the visual geometry of a link; `None` if part of it cannot be read.
fn visuals(
    reader: &Reader<'_>,
    link: &str,
    node: Node<'_, '_>,
    materials: &Colors,
    meshes: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
    report: &mut Diagnostics<'_>,
) -> Option<Vec<Visual>> {
    let elements: Vec<_> = elements(node, "visual").collect();
    let visuals = elements.into_iter().map(|element| {
        let read = reader.shape(element).and_then(|shape| {
            let color = color_of(reader, element, materials)?;
            Ok((shape, color))
        });
        let (shape, color) = match read {
            Ok(read) => read,
            Err(fault) => {
                note(report, Subject::Link(link.to_owned()), &fault);
                return None;
            }
        };
        let known = report.diagnostics.len();
        // The reach limit of collision meshes does not apply, as the robot's motions do not depend on it.
        let loaded = load(link, &shape, 0.0, meshes, report);
        // As it is for display only, every fault is a note.
        for diagnostic in &mut report.diagnostics[known..] {
            diagnostic.severity = Severity::Note;
            diagnostic.advice += "; ";
            diagnostic.advice += ADVICE;
        }
        let loaded = loaded.filter(
            |part| !matches!(&part.shape, Shape::Mesh(mesh) if mesh.extent() > MAX_MESH_EXTENT),
        )?;
        Some(Visual {
            link_from_shape: loaded.link_from_shape,
            shape: loaded.shape,
            color,
        })
    });
    // All elements are read, so that all faults are reported.
    let visuals: Vec<Option<Visual>> = visuals.collect();
    visuals.into_iter().collect()
}

/// Returns the colour of a `<visual>`: its own, or that of the material it names.
fn color_of(
    reader: &Reader<'_>,
    visual: Node<'_, '_>,
    materials: &Colors,
) -> Result<Option<[f64; 4]>, RobotError> {
    let Some(material) = element(visual, "material") else {
        return Ok(None);
    };
    let named = material.attribute("name").map(str::trim);
    let named = named.and_then(|name| materials.get(name));
    Ok(color(reader, material)?.or(named.copied().flatten()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Mesh, Vector3};

    const ARM: &str = r#"<robot name="arm">
  <material name="orange"><color rgba="1 0.5 0 1"/></material>
  <link name="base">
    <visual><origin xyz="0 0 0.1"/><geometry><box size="0.2 0.2 0.2"/></geometry><material name="orange"/></visual>
    <visual><geometry><mesh filename="package://arm/base.obj" scale="0.001 0.001 0.001"/></geometry></visual>
    <collision><geometry><box size="0.3 0.3 0.3"/></geometry></collision>
  </link>
  <link name="rod"/>
  <joint name="j" type="fixed"><parent link="base"/><child link="rod"/></joint>
</robot>"#;

    /// Reads a URDF in which every mesh is a cube with edges of this length.
    fn looks(urdf: &str, cube: Option<f64>) -> (RobotModel, Result<Appearance, RobotError>) {
        let robot = RobotModel::from_urdf("arm.urdf", urdf, &mut |_| Err(String::new()))
            .expect("visual geometry keeps no robot from being made");
        let mut meshes = |_: &str| {
            let edge = cube.ok_or("no such file")?;
            let cube = Mesh::cuboid(Vector3::repeat(edge)).unwrap();
            let corners = cube.vertices().iter();
            let corners = corners.map(|p| format!("v {} {} {}\n", p.x, p.y, p.z));
            let faces = cube.triangles().iter();
            let faces = faces.map(|[a, b, c]| format!("f {} {} {}\n", a + 1, b + 1, c + 1));
            Ok(corners.chain(faces).collect::<String>().into_bytes())
        };
        let looks = Appearance::from_urdf("arm.urdf", urdf, &robot, &mut meshes);
        (robot, looks)
    }

    #[test]
    fn shapes_places_and_colors_are_read() {
        let (robot, looks) = looks(ARM, Some(100.0));
        let looks = looks.unwrap();
        assert!(!looks.is_empty() && looks.diagnostics().is_empty());
        let [cube, mesh] = looks.visuals(robot.root()).unwrap() else {
            panic!("two visual elements");
        };
        assert_eq!(cube.link_from_shape.translation.z, 0.1);
        assert_eq!(cube.color, Some([1.0, 0.5, 0.0, 1.0]));
        assert_eq!(mesh.color, None);
        let Shape::Mesh(mesh) = &mesh.shape else {
            panic!("the second is a mesh");
        };
        assert!((mesh.extent() - 0.1).abs() < 1e-6, "{}", mesh.extent());
        assert_eq!(looks.visuals(robot.link("rod").unwrap()), Some(&[][..]));
    }

    #[test]
    fn a_missing_mesh_removes_the_appearance_of_its_link_only() {
        let (robot, looks) = looks(ARM, None);
        let looks = looks.unwrap();
        assert_eq!(looks.visuals(robot.root()), None);
        let [note] = looks.diagnostics() else {
            panic!("{:?}", looks.diagnostics());
        };
        let note = (note.severity, note.at.line, note.to_string());
        assert_eq!((note.0, note.1), (Severity::Note, 5));
        assert!(
            note.2.contains("no such file") && note.2.contains("collision geometry"),
            "{}",
            note.2
        );
    }

    #[test]
    fn a_mesh_in_millimetres_is_not_drawn_a_thousand_times_too_large() {
        let (robot, looks) = looks(&ARM.replace("0.001 0.001 0.001", "1 1 1"), Some(100.0));
        let looks = looks.unwrap();
        assert_eq!(looks.visuals(robot.root()), None);
        assert_eq!(looks.diagnostics()[0].kind, DiagnosticKind::MeshScale);
    }

    #[test]
    fn faults_name_their_place() {
        let note = |from: &str, to: &str| {
            let (robot, looks) = looks(&ARM.replace(from, to), Some(1.0));
            let looks = looks.unwrap();
            let [note] = looks.diagnostics() else {
                panic!("{:?}", looks.diagnostics());
            };
            (note.to_string(), looks.visuals(robot.root()).is_some())
        };
        let (text, _) = note("<geometry><box size=\"0.2 0.2 0.2\"/></geometry>", "");
        assert!(
            text.starts_with("arm.urdf:4:") && text.contains("<visual> has no <geometry>"),
            "{text}"
        );
        let (text, is_shown) = note("1 0.5 0 1", "1 50 0 1");
        assert!(
            text.starts_with("arm.urdf:2:") && text.contains("1 50 0 1"),
            "{text}"
        );
        assert!(is_shown, "without that colour");
        let (text, is_shown) = note("0.001 0.001 0.001", "1 NaN 1");
        assert!(text.starts_with("arm.urdf:5:") && !is_shown, "{text}");
    }
}
