//! Text of a task file from objects of Python, with the files that stand for arrays.

use crate::arrays::{self, rows};
use crate::error::{plain, refused};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat, PyInt, PyMapping};
use std::collections::BTreeMap;
use wisch::geometry::{Mesh, Point3};
use wisch::represent::ParticleDistribution;
use wisch_io::particles_to_csv;

/// File name that stands for particles given as an array.
const GIVEN_PARTICLES: &str = "particles given as an array.csv";

/// Contents of the files that stand for arrays, by the names in the text.
pub type GivenFiles = BTreeMap<String, Vec<u8>>;

/// Writes the values of a task file.
#[derive(Default)]
pub struct TaskText {
    /// The files that stand for the arrays written so far.
    pub files: GivenFiles,
}

impl TaskText {
    /// Adds particles (N, 2) \[m\]. Returns the keys of the table `particles` that names them.
    pub fn particles(&mut self, particles: &Bound<'_, PyAny>) -> PyResult<[String; 2]> {
        let points = rows::<2>("particles", particles)?;
        let points: Vec<_> = points.into_iter().map(Into::into).collect();
        let particles = ParticleDistribution::new(&points).map_err(plain)?;
        let csv = particles_to_csv(&particles).into_bytes();
        self.files.insert(GIVEN_PARTICLES.to_owned(), csv);
        Ok([
            "source = \"csv\"".to_owned(),
            format!("file = {GIVEN_PARTICLES:?}"),
        ])
    }

    /// Returns the text of a task file with these keys: values first, then tables.
    pub fn keys(&mut self, keys: &Bound<'_, PyDict>) -> PyResult<String> {
        let (mut alone, mut tables) = (String::new(), String::new());
        for (key, value) in keys {
            let key: String = key.extract()?;
            let name = toml::Value::String(key.clone());
            let Ok(table) = value.cast::<PyMapping>() else {
                alone += &format!("{name} = {}\n", self.value(&key, &value)?);
                continue;
            };
            tables += &format!("\n[{name}]\n");
            for entry in table.keys()?.iter() {
                let inner: String = entry.extract()?;
                let value = self.value(&format!("{key}.{inner}"), &table.get_item(&entry)?)?;
                tables += &format!("{} = {value}\n", toml::Value::String(inner));
            }
        }
        Ok(alone + &tables)
    }

    /// Converts the value of a key to TOML. A mesh becomes the name of a file that stands for it.
    pub fn value(&mut self, key: &str, value: &Bound<'_, PyAny>) -> PyResult<String> {
        if let Some(mesh) = mesh_of(key, value)? {
            let file = format!("mesh {} given as arrays.stl", self.files.len() + 1);
            self.files.insert(file.clone(), mesh.to_binary_stl());
            let name = toml::Value::String(file).to_string();
            // The mesh of a tool is named alone, that of a surface or of an object in a table.
            let is_alone = key.ends_with(".file") || key == "tool.mesh";
            return Ok(if is_alone {
                name
            } else {
                format!("{{ file = {name} }}")
            });
        }
        if let Ok(list) = value.call_method0("tolist") {
            return self.value(key, &list);
        }
        if let Ok(is_true) = value.extract::<bool>() {
            return Ok(is_true.to_string());
        }
        if let Ok(text) = value.extract::<String>() {
            return Ok(toml::Value::String(text).to_string());
        }
        if let Ok(path) = value.call_method0("__fspath__") {
            return self.value(key, &path);
        }
        if let Ok(table) = value.cast::<PyMapping>() {
            let mut entries = Vec::new();
            for entry in table.keys()?.iter() {
                let inner: String = entry.extract()?;
                let value = self.value(&format!("{key}.{inner}"), &table.get_item(&entry)?)?;
                entries.push(format!("{} = {value}", toml::Value::String(inner)));
            }
            return Ok(format!("{{ {} }}", entries.join(", ")));
        }
        if value.is_instance_of::<PyInt>() || value.is_instance_of::<PyFloat>() {
            return value.str()?.extract();
        }
        let items = value.try_iter().map_err(|_| {
            let found = arrays::kind_of(value);
            refused(key, found, "numbers, words, lists and dicts")
        })?;
        let items: PyResult<Vec<String>> = items.map(|item| self.value(key, &item?)).collect();
        Ok(format!("[{}]", items?.join(", ")))
    }
}

/// Returns the mesh of a value: an object with `vertices` (V, 3) \[m\] and `faces` (T, 3), such as that of trimesh, or the
/// two arrays at a key of a mesh. `None` for other values.
fn mesh_of(key: &str, value: &Bound<'_, PyAny>) -> PyResult<Option<Mesh>> {
    let attributes = (value.getattr_opt("vertices")?, value.getattr_opt("faces")?);
    let (vertices, faces) = match attributes {
        (Some(vertices), Some(faces)) => (vertices, faces),
        _ if key.ends_with("mesh") || key.ends_with("mesh.file") => {
            match value.extract::<(Bound<'_, PyAny>, Bound<'_, PyAny>)>() {
                Ok(arrays) => arrays,
                Err(_) => return Ok(None),
            }
        }
        _ => return Ok(None),
    };
    let vertices: Vec<Point3> = rows::<3>(&format!("{key}: vertices"), &vertices)?
        .into_iter()
        .map(Point3::from)
        .collect();
    let name = format!("{key}: faces");
    let faces = rows::<3>(&name, &faces)?;
    let count = vertices.len();
    let corner = |index: f64| {
        if index >= 0.0 && index < count as f64 && index.fract() == 0.0 {
            return Ok(index as u32);
        }
        let wanted = format!("indices of {count} vertices, from 0");
        Err(refused(&name, index.to_string(), wanted))
    };
    let faces: PyResult<Vec<[u32; 3]>> = (faces.into_iter())
        .map(|[a, b, c]| Ok([corner(a)?, corner(b)?, corner(c)?]))
        .collect();
    let mesh = Mesh::new(vertices, faces?);
    Ok(Some(
        mesh.map_err(|error| plain(format!("{key}: {error}")))?,
    ))
}
