//! Fits a plane: `plane POINTS.csv INLIER_DISTANCE_M`, with `x,y,z` [m] on each line.
//!
//! Prints height, both slopes and the number of inliers; the milliseconds taken go to standard error.

use std::time::Instant;
use wisch::geometry::Point3;
use wisch::interpret::{PlaneConfig, fit_plane};

/// Fits that are timed; the fastest is printed.
const RUNS: usize = 20;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let [path, inlier_distance] = std::env::args()
        .skip(1)
        .collect::<Vec<_>>()
        .try_into()
        .map_err(|_| "usage: plane POINTS.csv INLIER_DISTANCE_M")?;
    let points = read(&path)?;
    let config = PlaneConfig {
        inlier_distance_m: inlier_distance.parse()?,
        ..PlaneConfig::default()
    };
    let mut fastest = f64::INFINITY;
    let mut plane = None;
    for _ in 0..RUNS {
        let begin = Instant::now();
        plane = fit_plane(std::hint::black_box(&points), &config, 1);
        fastest = fastest.min(begin.elapsed().as_secs_f64());
    }
    let plane = plane.ok_or("no plane")?;
    eprintln!("{:.4}", fastest * 1e3);
    println!(
        "{},{},{},{}",
        plane.height, plane.slope.x, plane.slope.y, plane.inliers
    );
    Ok(())
}

fn read(path: &str) -> Result<Vec<Point3>, csv::Error> {
    csv::ReaderBuilder::new()
        .has_headers(false)
        .from_path(path)?
        .deserialize()
        .map(|row| row.map(|(x, y, z)| Point3::new(x, y, z)))
        .collect()
}
