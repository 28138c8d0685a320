//! Samples a particle density: `density POINTS.csv BANDWIDTH_M`, with `x,y` [m] on each line.
//!
//! Prints `x,y,density` for every sample of the map; the milliseconds taken go to standard error.

mod points;

use std::time::Instant;
use wisch::geometry::Bounds2;
use wisch::plan::CoverageDensity;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let [path, bandwidth] = std::env::args()
        .skip(1)
        .collect::<Vec<_>>()
        .try_into()
        .map_err(|_| "usage: density POINTS.csv BANDWIDTH_M")?;
    let points = points::read(&path)?;
    let bounds = Bounds2::from_points(points.iter().copied()).ok_or("no points")?;
    let begin = Instant::now();
    let map = CoverageDensity::new(&points, bounds, bandwidth.parse()?);
    eprintln!("{:.3}", begin.elapsed().as_secs_f64() * 1e3);
    let (columns, rows) = map.shape();
    for row in 0..rows {
        for column in 0..columns {
            let at = map.sample_position(column, row);
            println!("{},{},{}", at.x, at.y, map.sample(column, row));
        }
    }
    Ok(())
}
