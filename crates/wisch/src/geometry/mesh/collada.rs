//! COLLADA: the triangles of the instanced visual scene, in metres.

use super::xml::{Document, Element};
use super::{MAX_TRIANGLES, Mesh, MeshError, Point3};
use nalgebra::{Matrix4, Rotation3, Translation3, Unit, Vector3};
use std::collections::HashMap;
use std::str::FromStr;

/// Deepest nesting of nodes and instanced nodes: a node that instances itself ends here.
const MAX_DEPTH: usize = 64;

/// Most nodes visited: instances of instances multiply.
const MAX_VISITS: usize = 100_000;

/// Most numbers per vertex of a primitive, and per element of an array.
const MAX_STRIDE: usize = 64;

/// The triangles of one `<geometry>`, in its own frame and unit.
type Soup = Vec<[Point3; 3]>;

/// Reads a document from UTF-8 bytes.
pub(super) fn parse(bytes: &[u8]) -> Result<Mesh, MeshError> {
    let text = std::str::from_utf8(bytes).map_err(|e| MeshError::Syntax {
        reason: format!("it is not UTF-8 at byte {}", e.valid_up_to()),
    })?;
    let document = Document::scan(text.trim_start_matches('\u{feff}'))?;
    let root = document.root();
    if root.name != "COLLADA" {
        return Err(root.fault("the root element is not <COLLADA>"));
    }
    let scene = Scene::new(&document)?;
    let metres_from_file = Matrix4::new_scaling(metres_per_unit(&document)?);
    let mut soup = Soup::new();
    match scene.root_nodes()? {
        Some(nodes) => scene.place(nodes, metres_from_file, &mut soup)?,
        // Without a scene there is nothing to place the geometries with.
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

/// Appends triangles mapped through an affine transform.
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

fn metres_per_unit(document: &Document) -> Result<f64, MeshError> {
    let asset = document.child(document.root(), "asset");
    let Some(unit) = asset.and_then(|asset| document.child(asset, "unit")) else {
        return Ok(1.0);
    };
    match unit.attribute("meter").map_or(Ok(1.0), f64::from_str) {
        Ok(metres) if metres > 0.0 && metres.is_finite() => Ok(metres),
        _ => Err(unit.fault(format!(
            "meter={:?} is no length above 0",
            unit.attribute("meter").unwrap_or_default()
        ))),
    }
}

struct Scene<'d, 'a> {
    document: &'d Document<'a>,
    /// In document order, so that results do not depend on hashing.
    geometries: Vec<Soup>,
    geometry_by_id: HashMap<&'a str, usize>,
    node_by_id: HashMap<&'a str, &'d Element<'a>>,
}

impl<'d, 'a> Scene<'d, 'a> {
    fn new(document: &'d Document<'a>) -> Result<Self, MeshError> {
        let by_id = |name| {
            document
                .named(name)
                .filter_map(|e| Some((e.attribute("id")?, e)))
                .collect()
        };
        let sources: HashMap<&str, &Element> = by_id("source");
        let arrays: HashMap<&str, &Element> = by_id("float_array");
        let mut scene = Self {
            document,
            geometries: Vec::new(),
            geometry_by_id: HashMap::new(),
            node_by_id: by_id("node"),
        };
        let mut count = 0;
        for (index, geometry) in document.named("geometry").enumerate() {
            let mut soup = Soup::new();
            for mesh in document.children(geometry).filter(|e| e.name == "mesh") {
                read_mesh(document, mesh, &sources, &arrays, &mut soup)?;
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

    /// The nodes of the visual scene that `<scene>` names, else of the first; `None` without any.
    fn root_nodes(&self) -> Result<Option<&'d Element<'a>>, MeshError> {
        let named = self.document.child(self.document.root(), "scene");
        let instance = named.and_then(|scene| self.document.child(scene, "instance_visual_scene"));
        let mut scenes = self.document.named("visual_scene");
        let Some(instance) = instance else {
            return Ok(scenes.next());
        };
        let id = reference(instance, "url")?;
        match scenes.find(|scene| scene.attribute("id") == Some(id)) {
            Some(scene) => Ok(Some(scene)),
            None => Err(instance.fault(format!("there is no visual scene {id:?}"))),
        }
    }

    /// Appends every geometry instanced below a visual scene.
    fn place(
        &self,
        scene: &'d Element<'a>,
        metres_from_scene: Matrix4<f64>,
        soup: &mut Soup,
    ) -> Result<(), MeshError> {
        // Last in, first out: children are pushed in reverse to come out in document order.
        let mut waiting = vec![(scene, metres_from_scene, 0)];
        let mut visits = 0;
        while let Some((parent, metres_from_parent, depth)) = waiting.pop() {
            visits += 1;
            if visits > MAX_VISITS {
                let (what, count, limit) = ("nodes", visits, MAX_VISITS);
                return Err(MeshError::TooManyParts { what, count, limit });
            }
            if depth > MAX_DEPTH {
                return Err(parent.fault(format!("nodes are nested more than {MAX_DEPTH} deep")));
            }
            let mut nodes = Vec::new();
            for child in self.document.children(parent) {
                let id = || reference(child, "url");
                match child.name {
                    "node" => nodes.push(child),
                    "instance_node" => {
                        let node = self.node_by_id.get(id()?);
                        nodes.push(node.ok_or_else(|| {
                            child.fault(format!("there is no node {:?}", id().unwrap_or_default()))
                        })?);
                    }
                    "instance_geometry" => {
                        let index = self.geometry_by_id.get(id()?);
                        let index = index.ok_or_else(|| {
                            child.fault(format!(
                                "there is no geometry {:?}",
                                id().unwrap_or_default()
                            ))
                        })?;
                        append(soup, &self.geometries[*index], &metres_from_parent)?;
                    }
                    _ => {}
                }
            }
            for node in nodes.into_iter().rev() {
                waiting.push((
                    node,
                    metres_from_parent * self.parent_from_node(node)?,
                    depth + 1,
                ));
            }
        }
        Ok(())
    }

    /// The product of a node's transforms in document order.
    fn parent_from_node(&self, node: &Element) -> Result<Matrix4<f64>, MeshError> {
        let mut product = Matrix4::identity();
        for step in self.document.children(node) {
            product *= match step.name {
                "matrix" => Matrix4::from_row_slice(&exactly::<16>(step)?),
                "translate" => Translation3::from(exactly::<3>(step)?).to_homogeneous(),
                "scale" => Matrix4::new_nonuniform_scaling(&Vector3::from(exactly::<3>(step)?)),
                "rotate" => {
                    let [x, y, z, degrees] = exactly::<4>(step)?;
                    let axis = Unit::try_new(Vector3::new(x, y, z), 0.0);
                    let axis = axis.ok_or_else(|| step.fault("the axis has no length"))?;
                    Rotation3::from_axis_angle(&axis, degrees.to_radians()).to_homogeneous()
                }
                "lookat" | "skew" => return Err(step.fault("this transform is not read")),
                _ => continue,
            };
        }
        Ok(product)
    }
}

/// Appends the triangles of a `<mesh>`.
fn read_mesh(
    document: &Document,
    mesh: &Element,
    sources: &HashMap<&str, &Element>,
    arrays: &HashMap<&str, &Element>,
    soup: &mut Soup,
) -> Result<(), MeshError> {
    let primitives = ["triangles", "polylist", "polygons", "tristrips", "trifans"];
    if !document
        .children(mesh)
        .any(|e| primitives.contains(&e.name))
    {
        return Ok(());
    }
    let Some(vertices) = document.child(mesh, "vertices") else {
        return Err(mesh.fault("it has no <vertices>"));
    };
    let mut inputs = document.children(vertices).filter(|e| e.name == "input");
    let Some(input) = inputs.find(|e| e.attribute("semantic") == Some("POSITION")) else {
        return Err(vertices.fault("it has no <input> with semantic=\"POSITION\""));
    };
    let id = reference(input, "source")?;
    let Some(source) = sources.get(id) else {
        return Err(input.fault(format!("there is no source {id:?}")));
    };
    let positions = read_positions(document, source, arrays)?;
    for primitive in document
        .children(mesh)
        .filter(|e| primitives.contains(&e.name))
    {
        read_primitive(document, primitive, &positions, soup)?;
    }
    Ok(())
}

fn read_positions(
    document: &Document,
    source: &Element,
    arrays: &HashMap<&str, &Element>,
) -> Result<Vec<Point3>, MeshError> {
    let technique = document.child(source, "technique_common");
    let Some(accessor) = technique.and_then(|t| document.child(t, "accessor")) else {
        return Err(source.fault("it has no <accessor>"));
    };
    let id = reference(accessor, "source")?;
    let Some(array) = arrays.get(id) else {
        return Err(accessor.fault(format!("there is no float_array {id:?}")));
    };
    let offset: usize = number_attribute(accessor, "offset")?.unwrap_or(0);
    let count: usize = number_attribute(accessor, "count")?.unwrap_or(0);
    let stride: usize = number_attribute(accessor, "stride")?.unwrap_or(1);
    if !(3..=MAX_STRIDE).contains(&stride) {
        return Err(accessor.fault(format!("stride {stride} is not within 3 to {MAX_STRIDE}")));
    }
    let numbers = numbers::<f64>(array)?;
    let room = numbers.len().saturating_sub(offset) / stride;
    if count > room {
        return Err(accessor.fault(format!(
            "it counts {count} positions, but the array has room for {room}"
        )));
    }
    let positions = numbers.iter().skip(offset).copied().collect::<Vec<_>>();
    Ok(positions
        .chunks_exact(stride)
        .take(count)
        .map(|p| Point3::new(p[0], p[1], p[2]))
        .collect())
}

fn read_primitive(
    document: &Document,
    primitive: &Element,
    positions: &[Point3],
    soup: &mut Soup,
) -> Result<(), MeshError> {
    let (mut stride, mut vertex_offset) = (1, None);
    for input in document.children(primitive).filter(|e| e.name == "input") {
        let offset: usize = number_attribute(input, "offset")?.unwrap_or(0);
        if offset >= MAX_STRIDE {
            return Err(input.fault(format!("offset {offset} is not below {MAX_STRIDE}")));
        }
        stride = stride.max(offset + 1);
        if input.attribute("semantic") == Some("VERTEX") {
            vertex_offset = Some(offset);
        }
    }
    let Some(vertex_offset) = vertex_offset else {
        return Err(primitive.fault("it has no <input> with semantic=\"VERTEX\""));
    };
    let mut sizes = match document.child(primitive, "vcount") {
        Some(vcount) if primitive.name == "polylist" => numbers::<usize>(vcount)?.into_iter(),
        _ => Vec::new().into_iter(),
    };
    for p in document.children(primitive).filter(|e| e.name == "p") {
        let indices = numbers::<u32>(p)?;
        let corners = indices.chunks_exact(stride).map(|tuple| {
            let index = tuple[vertex_offset];
            let corner = positions.get(index as usize).copied();
            corner.ok_or_else(|| {
                p.fault(format!("position {index} is not below {}", positions.len()))
            })
        });
        let corners: Vec<Point3> = corners.collect::<Result<_, _>>()?;
        let mut rest = corners.as_slice();
        match primitive.name {
            "triangles" => soup.extend(rest.as_chunks().0),
            "tristrips" => soup.extend(rest.windows(3).enumerate().map(|(i, w)| {
                // Every second triangle of a strip runs the other way.
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
                        .ok_or_else(|| p.fault("it has fewer indices than <vcount> counts"))?;
                    add_fan(soup, polygon);
                    rest = after;
                }
            }
            _ => add_fan(soup, rest),
        }
        if soup.len() > MAX_TRIANGLES {
            return Err(MeshError::TooManyTriangles { count: soup.len() });
        }
    }
    Ok(())
}

/// Appends a convex polygon as triangles about its first corner.
fn add_fan(soup: &mut Soup, polygon: &[Point3]) {
    soup.extend((2..polygon.len()).map(|i| [polygon[0], polygon[i - 1], polygon[i]]));
}

/// The target of a reference within the document.
fn reference<'a>(element: &Element<'a>, attribute: &str) -> Result<&'a str, MeshError> {
    let target = element
        .attribute(attribute)
        .and_then(|url| url.strip_prefix('#'));
    target.ok_or_else(|| element.fault(format!("{attribute} is not \"#\" and an id of this file")))
}

fn number_attribute<T: FromStr>(element: &Element, name: &str) -> Result<Option<T>, MeshError> {
    let parse = |text: &str| {
        text.trim()
            .parse()
            .map_err(|_| element.fault(format!("{name}={text:?} is not a count")))
    };
    element.attribute(name).map(parse).transpose()
}

fn numbers<T: FromStr>(element: &Element) -> Result<Vec<T>, MeshError> {
    element
        .text
        .split_ascii_whitespace()
        .map(|word| {
            word.parse()
                .map_err(|_| element.fault(format!("{word:?} is no number that fits here")))
        })
        .collect()
}

fn exactly<const N: usize>(element: &Element) -> Result<[f64; N], MeshError> {
    let found = numbers::<f64>(element)?;
    let count = found.len();
    found
        .try_into()
        .map_err(|_| element.fault(format!("{count} numbers where {N} belong")))
}
