//! COLLADA: the triangles of the instanced visual scene, in metres.

use super::{MAX_TRIANGLES, Mesh, MeshError, Point3};
use crate::geometry::triangulation::cut_face;
use nalgebra::{Matrix4, Rotation3, Translation3, Unit, Vector3};
use roxmltree::{Document, Error, Node, ParsingOptions};
use std::collections::HashMap;
use std::str::FromStr;

/// Deepest nesting of nodes and instanced nodes, which stops a node that instances itself.
const MAX_DEPTH: usize = 64;

/// Largest number of visited nodes, as instances of instances multiply.
const MAX_VISITS: usize = 100_000;

/// Largest number of numbers per vertex of a primitive, and per element of an array.
const MAX_STRIDE: usize = 64;

/// Largest number of nodes (elements, texts, comments) of the XML; it limits the memory that a
/// small file can demand.
const MAX_XML_NODES: u32 = 2_000_000;

/// Largest number of attributes of one element, as the parser compares each with all others.
pub(crate) const MAX_ATTRIBUTES: usize = 5_000;

type Element<'d> = Node<'d, 'd>;

/// Triangles of one `<geometry>`, in its own frame and unit.
type Soup = Vec<[Point3; 3]>;

/// Reads a document from UTF-8 bytes.
pub(super) fn parse(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let text = std::str::from_utf8(bytes).map_err(|e| MeshError::Syntax {
        reason: format!("it is not UTF-8 at byte {}", e.valid_up_to()),
    })?;
    let document = &read_xml(text)?;
    let root = document.root_element();
    if name(root) != "COLLADA" {
        return Err(fault(root, "the root element is not <COLLADA>"));
    }
    let scene = Scene::new(document)?;
    let metres_from_file = Matrix4::new_scaling(metres_per_unit(root)?);
    let mut soup = Soup::new();
    match scene.root_nodes()? {
        Some(nodes) => scene.place(nodes, metres_from_file, &mut soup)?,
        // Without a scene, nothing places the geometries, so all of them are read as they are.
        None => {
            for own in &scene.geometries {
                append(&mut soup, own, &metres_from_file)?;
            }
        }
    }
    let triangles = (0..soup.len() as u32)
        .map(|i| [3 * i, 3 * i + 1, 3 * i + 2])
        .collect();
    Mesh::new(soup.into_flattened(), triangles)
}

/// Parses the XML, within the limits.
fn read_xml(text: &str) -> Result<Document<'_>, MeshError> {
    let too_many = |what, count, limit| MeshError::TooManyParts { what, count, limit };
    let attributes = most_attributes(text);
    if attributes > MAX_ATTRIBUTES {
        return Err(too_many(
            "attributes of an element",
            attributes,
            MAX_ATTRIBUTES,
        ));
    }
    let options = ParsingOptions {
        nodes_limit: MAX_XML_NODES,
        ..ParsingOptions::default()
    };
    let text = text.trim_start_matches('\u{feff}');
    Document::parse_with_options(text, options).map_err(|error| match error {
        Error::NodesLimitReached => {
            let limit = MAX_XML_NODES as usize;
            too_many("XML nodes", limit + 1, limit)
        }
        Error::NoRootNode => MeshError::SyntaxAt {
            line: 1,
            reason: "there is no XML element".to_owned(),
        },
        error => MeshError::SyntaxAt {
            line: error.pos().row as usize,
            reason: error.to_string(),
        },
    })
}

/// Returns an upper bound on the attributes of any element, from the quotes between angle brackets.
pub(crate) fn most_attributes(text: &str) -> usize {
    let between = text.split(['<', '>']);
    let quotes = between.map(|piece| piece.bytes().filter(|b| matches!(b, b'"' | b'\'')).count());
    quotes.max().unwrap_or(0) / 2
}

/// Returns the name of an element without its namespace; empty for other nodes.
fn name<'d>(node: Element<'d>) -> &'d str {
    node.tag_name().name()
}

/// Iterates over all elements of a name, in document order.
fn named<'d>(
    document: &'d Document<'d>,
    wanted: &'static str,
) -> impl Iterator<Item = Element<'d>> {
    document.descendants().filter(move |&e| name(e) == wanted)
}

fn children<'d>(parent: Element<'d>, wanted: &'static str) -> impl Iterator<Item = Element<'d>> {
    parent.children().filter(move |&e| name(e) == wanted)
}

fn child<'d>(parent: Element<'d>, wanted: &'static str) -> Option<Element<'d>> {
    children(parent, wanted).next()
}

/// Returns an error at an element.
fn fault(element: Element<'_>, reason: impl std::fmt::Display) -> MeshError {
    let at = element.document().text_pos_at(element.range().start);
    MeshError::SyntaxAt {
        line: at.row as usize,
        reason: format!("<{}>: {reason}", name(element)),
    }
}

/// Appends triangles, mapped by an affine transform.
fn append(
    soup: &mut Soup,
    more: &[[Point3; 3]],
    soup_from_more: &Matrix4<f64>,
) -> Result<(), MeshError> {
    let count = soup.len() + more.len();
    if count > MAX_TRIANGLES {
        return Err(MeshError::TooManyTriangles { count });
    }
    soup.extend(
        more.iter()
            .map(|t| t.map(|p| soup_from_more.transform_point(&p))),
    );
    Ok(())
}

fn metres_per_unit(root: Element) -> Result<f64, MeshError> {
    let asset = child(root, "asset");
    let Some(unit) = asset.and_then(|asset| child(asset, "unit")) else {
        return Ok(1.0);
    };
    match unit.attribute("meter").map_or(Ok(1.0), f64::from_str) {
        Ok(metres) if metres > 0.0 && metres.is_finite() => Ok(metres),
        _ => Err(fault(
            unit,
            format!(
                "meter={:?} is not a length above 0",
                unit.attribute("meter").unwrap_or_default()
            ),
        )),
    }
}

struct Scene<'d> {
    document: &'d Document<'d>,
    /// In document order, so that results do not depend on hashing.
    geometries: Vec<Soup>,
    geometry_by_id: HashMap<&'d str, usize>,
    node_by_id: HashMap<&'d str, Element<'d>>,
}

impl<'d> Scene<'d> {
    fn new(document: &'d Document<'d>) -> Result<Self, MeshError> {
        let by_id = |name| {
            named(document, name)
                .filter_map(|e| Some((e.attribute("id")?, e)))
                .collect()
        };
        let sources: HashMap<&str, Element> = by_id("source");
        let arrays: HashMap<&str, Element> = by_id("float_array");
        let mut scene = Self {
            document,
            geometries: Vec::new(),
            geometry_by_id: HashMap::new(),
            node_by_id: by_id("node"),
        };
        let mut count = 0;
        for (index, geometry) in named(document, "geometry").enumerate() {
            let mut soup = Soup::new();
            for mesh in children(geometry, "mesh") {
                read_mesh(mesh, &sources, &arrays, &mut soup)?;
            }
            count += soup.len();
            if count > MAX_TRIANGLES {
                return Err(MeshError::TooManyTriangles { count });
            }
            scene.geometries.push(soup);
            if let Some(id) = geometry.attribute("id") {
                scene.geometry_by_id.insert(id, index);
            }
        }
        Ok(scene)
    }

    /// Returns the nodes of the visual scene that `<scene>` names, else of the first; `None` if there is none.
    fn root_nodes(&self) -> Result<Option<Element<'d>>, MeshError> {
        let scene = child(self.document.root_element(), "scene");
        let instance = scene.and_then(|scene| child(scene, "instance_visual_scene"));
        let mut scenes = named(self.document, "visual_scene");
        let Some(instance) = instance else {
            return Ok(scenes.next());
        };
        let id = reference(instance, "url")?;
        match scenes.find(|scene| scene.attribute("id") == Some(id)) {
            Some(scene) => Ok(Some(scene)),
            None => Err(fault(
                instance,
                format!("visual scene {id:?} does not exist"),
            )),
        }
    }

    /// Appends every geometry instanced in a visual scene.
    fn place(
        &self,
        scene: Element<'d>,
        metres_from_scene: Matrix4<f64>,
        soup: &mut Soup,
    ) -> Result<(), MeshError> {
        // The stack is last in, first out: children are pushed in reverse to be visited in document order.
        let mut waiting = vec![(scene, metres_from_scene, 0)];
        let mut visits = 0;
        while let Some((parent, metres_from_parent, depth)) = waiting.pop() {
            visits += 1;
            if visits > MAX_VISITS {
                let (what, count, limit) = ("nodes", visits, MAX_VISITS);
                return Err(MeshError::TooManyParts { what, count, limit });
            }
            if depth > MAX_DEPTH {
                return Err(fault(
                    parent,
                    format!("nodes are nested more than {MAX_DEPTH} deep"),
                ));
            }
            let mut nodes = Vec::new();
            for child in parent.children() {
                let id = || reference(child, "url");
                match name(child) {
                    "node" => nodes.push(child),
                    "instance_node" => {
                        let node = self.node_by_id.get(id()?);
                        nodes.push(*node.ok_or_else(|| {
                            fault(
                                child,
                                format!("node {:?} does not exist", id().unwrap_or_default()),
                            )
                        })?);
                    }
                    "instance_geometry" => {
                        let index = self.geometry_by_id.get(id()?);
                        let index = index.ok_or_else(|| {
                            fault(
                                child,
                                format!("geometry {:?} does not exist", id().unwrap_or_default()),
                            )
                        })?;
                        append(soup, &self.geometries[*index], &metres_from_parent)?;
                    }
                    _ => {}
                }
            }
            for node in nodes.into_iter().rev() {
                waiting.push((
                    node,
                    metres_from_parent * Self::parent_from_node(node)?,
                    depth + 1,
                ));
            }
        }
        Ok(())
    }

    /// Returns the product of a node's transforms in document order.
    fn parent_from_node(node: Element) -> Result<Matrix4<f64>, MeshError> {
        let mut product = Matrix4::identity();
        for step in node.children() {
            product *= match name(step) {
                "matrix" => Matrix4::from_row_slice(&exactly::<16>(step)?),
                "translate" => Translation3::from(exactly::<3>(step)?).to_homogeneous(),
                "scale" => Matrix4::new_nonuniform_scaling(&Vector3::from(exactly::<3>(step)?)),
                "rotate" => {
                    let [x, y, z, degrees] = exactly::<4>(step)?;
                    let axis = Unit::try_new(Vector3::new(x, y, z), 0.0);
                    let axis = axis.ok_or_else(|| fault(step, "the axis has no length"))?;
                    Rotation3::from_axis_angle(&axis, degrees.to_radians()).to_homogeneous()
                }
                "lookat" | "skew" => return Err(fault(step, "this transform is not supported")),
                _ => continue,
            };
        }
        Ok(product)
    }
}

/// Appends the triangles of a `<mesh>`.
fn read_mesh(
    mesh: Element,
    sources: &HashMap<&str, Element>,
    arrays: &HashMap<&str, Element>,
    soup: &mut Soup,
) -> Result<(), MeshError> {
    let primitives = ["triangles", "polylist", "polygons", "tristrips", "trifans"];
    if !mesh.children().any(|e| primitives.contains(&name(e))) {
        return Ok(());
    }
    let Some(vertices) = child(mesh, "vertices") else {
        return Err(fault(mesh, "it has no <vertices>"));
    };
    let mut inputs = children(vertices, "input");
    let Some(input) = inputs.find(|e| e.attribute("semantic") == Some("POSITION")) else {
        return Err(fault(
            vertices,
            "it has no <input> with semantic=\"POSITION\"",
        ));
    };
    let id = reference(input, "source")?;
    let Some(&source) = sources.get(id) else {
        return Err(fault(input, format!("source {id:?} does not exist")));
    };
    let positions = read_positions(source, arrays)?;
    let primitives = mesh.children().filter(|&e| primitives.contains(&name(e)));
    for primitive in primitives {
        read_primitive(primitive, &positions, soup)?;
    }
    Ok(())
}

fn read_positions(
    source: Element,
    arrays: &HashMap<&str, Element>,
) -> Result<Vec<Point3>, MeshError> {
    let technique = child(source, "technique_common");
    let Some(accessor) = technique.and_then(|t| child(t, "accessor")) else {
        return Err(fault(source, "it has no <accessor>"));
    };
    let id = reference(accessor, "source")?;
    let Some(&array) = arrays.get(id) else {
        return Err(fault(
            accessor,
            format!("float_array {id:?} does not exist"),
        ));
    };
    let offset: usize = number_attribute(accessor, "offset")?.unwrap_or(0);
    let count: usize = number_attribute(accessor, "count")?.unwrap_or(0);
    let stride: usize = number_attribute(accessor, "stride")?.unwrap_or(1);
    if !(3..=MAX_STRIDE).contains(&stride) {
        return Err(fault(
            accessor,
            format!("stride {stride} is not within 3 to {MAX_STRIDE}"),
        ));
    }
    let numbers = numbers::<f64>(array)?;
    let room = numbers.len().saturating_sub(offset) / stride;
    if count > room {
        return Err(fault(
            accessor,
            format!("it counts {count} positions, but the array has room for {room}"),
        ));
    }
    let positions = numbers.iter().skip(offset).copied().collect::<Vec<_>>();
    Ok(positions
        .chunks_exact(stride)
        .take(count)
        .map(|p| Point3::new(p[0], p[1], p[2]))
        .collect())
}

fn read_primitive(
    primitive: Element,
    positions: &[Point3],
    soup: &mut Soup,
) -> Result<(), MeshError> {
    let (mut stride, mut vertex_offset) = (1, None);
    for input in children(primitive, "input") {
        let offset: usize = number_attribute(input, "offset")?.unwrap_or(0);
        if offset >= MAX_STRIDE {
            return Err(fault(
                input,
                format!("offset {offset} is not below {MAX_STRIDE}"),
            ));
        }
        stride = stride.max(offset + 1);
        if input.attribute("semantic") == Some("VERTEX") {
            vertex_offset = Some(offset);
        }
    }
    let Some(vertex_offset) = vertex_offset else {
        return Err(fault(
            primitive,
            "it has no <input> with semantic=\"VERTEX\"",
        ));
    };
    let mut sizes = match child(primitive, "vcount") {
        Some(vcount) if name(primitive) == "polylist" => numbers::<usize>(vcount)?.into_iter(),
        _ => Vec::new().into_iter(),
    };
    for p in children(primitive, "p") {
        let indices = numbers::<u32>(p)?;
        let corners = indices.chunks_exact(stride).map(|tuple| {
            let index = tuple[vertex_offset];
            let corner = positions.get(index as usize).copied();
            corner.ok_or_else(|| {
                fault(
                    p,
                    format!("position {index} is not below {}", positions.len()),
                )
            })
        });
        let corners: Vec<Point3> = corners.collect::<Result<_, _>>()?;
        let mut rest = corners.as_slice();
        match name(primitive) {
            "triangles" => soup.extend(rest.as_chunks().0),
            "tristrips" => soup.extend(rest.windows(3).enumerate().map(|(i, w)| {
                // Every second triangle of a strip has the opposite orientation.
                if i % 2 == 0 {
                    [w[0], w[1], w[2]]
                } else {
                    [w[1], w[0], w[2]]
                }
            })),
            "polylist" => {
                for size in sizes.by_ref() {
                    let polygon = rest.split_at_checked(size);
                    let (polygon, after) = polygon
                        .ok_or_else(|| fault(p, "it has fewer indices than <vcount> counts"))?;
                    add_face(soup, polygon);
                    rest = after;
                }
            }
            "trifans" => soup.extend((2..rest.len()).map(|i| [rest[0], rest[i - 1], rest[i]])),
            _ => add_face(soup, rest),
        }
        if soup.len() > MAX_TRIANGLES {
            return Err(MeshError::TooManyTriangles { count: soup.len() });
        }
    }
    Ok(())
}

/// Appends a plane polygon, convex or not, as triangles.
fn add_face(soup: &mut Soup, polygon: &[Point3]) {
    let triangles = cut_face(polygon);
    soup.extend(triangles.iter().map(|t| t.map(|i| polygon[i])));
}

/// Returns the target of a reference within the document.
fn reference<'d>(element: Element<'d>, attribute: &str) -> Result<&'d str, MeshError> {
    let target = element
        .attribute(attribute)
        .and_then(|url| url.strip_prefix('#'));
    target.ok_or_else(|| {
        fault(
            element,
            format!("{attribute} is not \"#\" and an id of this file"),
        )
    })
}

fn number_attribute<T: FromStr>(element: Element, name: &str) -> Result<Option<T>, MeshError> {
    let parse = |text: &str| {
        text.trim()
            .parse()
            .map_err(|_| fault(element, format!("{name}={text:?} is not a count")))
    };
    element.attribute(name).map(parse).transpose()
}

fn numbers<T: FromStr>(element: Element) -> Result<Vec<T>, MeshError> {
    let texts = element.children().filter(Node::is_text);
    texts
        .filter_map(|text| text.text())
        .flat_map(str::split_ascii_whitespace)
        .map(|word| {
            word.parse()
                .map_err(|_| fault(element, format!("{word:?} is not a valid number here")))
        })
        .collect()
}

fn exactly<const N: usize>(element: Element) -> Result<[f64; N], MeshError> {
    let found = numbers::<f64>(element)?;
    let count = found.len();
    found
        .try_into()
        .map_err(|_| fault(element, format!("{count} numbers, expected {N}")))
}
