//! Conversion between NumPy arrays and the library's types.

use crate::error::refused;
use nalgebra::Quaternion;
use numpy::ndarray::{Array1, Array2};
use numpy::{AllowTypeChange, IntoPyArray, PyArray1, PyArray2, PyArrayLike1, PyArrayLike2};
use pyo3::prelude::*;
use wisch::geometry::{Mesh, Point2, Pose, Region, flatten_pose, restore_pose};
use wisch::represent::{Fate, ParticleDistribution};

/// An array of numbers.
pub type Vector<'py> = Bound<'py, PyArray1<f64>>;
/// An array with rows of numbers.
pub type Matrix<'py> = Bound<'py, PyArray2<f64>>;

/// Returns the array that owns these numbers.
pub fn vector(py: Python<'_>, numbers: Vec<f64>) -> Vector<'_> {
    numbers.into_pyarray(py)
}

/// Returns the two-dimensional array that owns these numbers, in row-major order.
pub fn matrix(py: Python<'_>, numbers: Vec<f64>, columns: usize) -> Matrix<'_> {
    let rows = numbers.len().checked_div(columns).unwrap_or_default();
    let array = Array2::from_shape_vec((rows, columns), numbers);
    array
        .unwrap_or_else(|_| Array2::zeros((0, columns)))
        .into_pyarray(py)
}

/// Returns a pose as an array (7).
pub fn pose_array<'py>(py: Python<'py>, pose: &Pose) -> Vector<'py> {
    vector(py, flatten_pose(pose).to_vec())
}

/// Parses a pose from an array (7), and normalises its quaternion.
pub fn pose(name: &str, given: &Bound<'_, PyAny>) -> PyResult<Pose> {
    let numbers = to_array::<7>(name, given)?;
    let [_, _, _, i, j, k, w] = numbers;
    let norm = Quaternion::new(w, i, j, k).norm();
    if (norm - 1.0).abs() > 1e-3 {
        let limit = "1 within 0.001";
        return Err(refused(name, format!("a quaternion of norm {norm}"), limit));
    }
    Ok(restore_pose(&numbers))
}

/// Parses numbers from an array or a list.
pub fn list(name: &str, given: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    let array: PyArrayLike1<'_, f64, AllowTypeChange> = (given.extract())
        .map_err(|_| refused(name, kind_of(given), "a list or an array of numbers"))?;
    Ok(array.as_array().to_vec())
}

/// Parses an array of `N` finite numbers.
pub fn to_array<const N: usize>(name: &str, given: &Bound<'_, PyAny>) -> PyResult<[f64; N]> {
    let numbers = finite(name, list(name, given)?)?;
    let count = numbers.len();
    numbers
        .try_into()
        .map_err(|_| refused(name, format!("{count} numbers"), format!("{N} numbers")))
}

/// Parses an array of finite numbers, one per joint.
pub fn of_joints(name: &str, given: &Bound<'_, PyAny>, dof: usize) -> PyResult<Vec<f64>> {
    let numbers = finite(name, list(name, given)?)?;
    if numbers.len() == dof {
        return Ok(numbers);
    }
    let found = format!("{} numbers", numbers.len());
    Err(refused(name, found, format!("{dof}, one per joint")))
}

fn finite(name: &str, numbers: Vec<f64>) -> PyResult<Vec<f64>> {
    match numbers.iter().position(|number| !number.is_finite()) {
        None => Ok(numbers),
        Some(i) => {
            let place = format!("{name}[{i}]");
            Err(refused(&place, numbers[i], "a finite number"))
        }
    }
}

/// Parses rows of `N` finite numbers each.
pub fn rows<const N: usize>(name: &str, given: &Bound<'_, PyAny>) -> PyResult<Vec<[f64; N]>> {
    let wanted = format!("an array of shape (rows, {N})");
    if given.len().is_ok_and(|len| len == 0) {
        return Ok(Vec::new());
    }
    let array: PyArrayLike2<'_, f64, AllowTypeChange> =
        (given.extract()).map_err(|_| refused(name, kind_of(given), wanted.as_str()))?;
    let array = array.as_array();
    if array.ncols() != N {
        let found = format!("an array of shape ({}, {})", array.nrows(), array.ncols());
        return Err(refused(name, found, wanted));
    }
    Ok((array.rows().into_iter())
        .map(|row| std::array::from_fn(|i| row[i]))
        .collect())
}

/// Describes a value of the wrong type.
pub fn kind_of(given: &Bound<'_, PyAny>) -> String {
    let name = given.get_type().name();
    let kind = name.map_or_else(|_| "something".to_owned(), |name| name.to_string());
    match given.getattr("shape").and_then(|shape| shape.str()) {
        Ok(shape) => format!("{kind} of shape {shape}"),
        Err(_) => kind,
    }
}

/// Returns points (N, 2) [m].
pub fn points<'py>(py: Python<'py>, points: impl Iterator<Item = Point2>) -> Matrix<'py> {
    matrix(py, points.flat_map(|p| [p.x, p.y]).collect(), 2)
}

/// Returns the positions of particles, or where they left the surface, (N, 2) [m].
pub fn places<'py>(py: Python<'py>, particles: &ParticleDistribution) -> Matrix<'py> {
    points(py, particles.iter().map(|(place, _)| place))
}

/// Returns the fates of particles: 0 on the surface, 1 absorbed, 2 off the surface.
pub fn fates<'py>(py: Python<'py>, particles: &ParticleDistribution) -> Bound<'py, PyArray1<i8>> {
    let fates = particles.iter().map(|(_, fate)| match fate {
        Fate::OnSurface | Fate::Treated { .. } => 0,
        Fate::Absorbed => 1,
        Fate::OffSurface { .. } => 2,
    });
    Array1::from_iter(fates).into_pyarray(py)
}

/// Returns the outer rings of a region, each (corners, 2) [m].
pub fn rings<'py>(py: Python<'py>, region: &Region) -> Vec<Matrix<'py>> {
    let polygons = region.polygons().iter();
    polygons
        .map(|polygon| points(py, polygon.outer().iter().copied()))
        .collect()
}

/// Returns vertices (V, 3) [m] and triangles (T, 3) of a mesh.
pub fn mesh<'py>(py: Python<'py>, mesh: &Mesh) -> (Matrix<'py>, Bound<'py, PyArray2<u32>>) {
    let corners = mesh.vertices().iter().flat_map(|p| [p.x, p.y, p.z]);
    let triangles = mesh.triangles();
    let indices = triangles.iter().flatten().copied().collect();
    let triangles = Array2::from_shape_vec((triangles.len(), 3), indices);
    let triangles = triangles.unwrap_or_else(|_| Array2::zeros((0, 3)));
    (matrix(py, corners.collect(), 3), triangles.into_pyarray(py))
}
