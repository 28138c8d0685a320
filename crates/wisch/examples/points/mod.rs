//! Points from a CSV file, for the examples.

use wisch::geometry::Point2;

/// Reads `x,y` [m] from each line.
pub fn read(path: &str) -> Result<Vec<Point2>, csv::Error> {
    csv::ReaderBuilder::new()
        .has_headers(false)
        .from_path(path)?
        .deserialize()
        .map(|row| row.map(|(x, y)| Point2::new(x, y)))
        .collect()
}
