//! Pushes particles with one straight stroke of 0.4 m along x: `stroke POINTS.csv [REPEATS]`.
//!
//! The tool is a sponge of 0.07 × 0.11 m that starts at x = −0.2 on one square metre. Prints `x,y` of
//! every particle afterwards; the median microseconds of a stroke go to standard error.

mod points;

use std::time::Instant;
use wisch::geometry::{PlanarPose, Point2, Polygon, Region, Vector2};
use wisch::represent::{Effect, EffectModel, ParticleDistribution, ParticleField, ToolMotion};
use wisch_testkit::surface;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let path = arguments
        .next()
        .ok_or("usage: stroke POINTS.csv [REPEATS]")?;
    let repeats: usize = arguments.next().map_or(Ok(1), |text| text.parse())?;
    let points = points::read(&path)?;
    let sponge = Region::new(vec![Polygon::rectangle(Vector2::new(0.07, 0.11))]);
    let surface = surface([1.0; 2]);
    let motion = ToolMotion {
        from: PlanarPose::new(Point2::new(-0.2, 0.0), 0.0),
        to: PlanarPose::new(Point2::new(0.2, 0.0), 0.0),
    };
    let before = ParticleField::new(&ParticleDistribution::new(&points)?);
    let mut model = EffectModel::new(&sponge, Effect::Push);
    let mut after = before.clone();
    let mut times: Vec<f64> = (0..repeats.max(1))
        .map(|_| {
            after = before.clone();
            let begin = Instant::now();
            model.apply(&mut after, &surface, &motion);
            begin.elapsed().as_secs_f64() * 1e6
        })
        .collect();
    times.sort_by(f64::total_cmp);
    eprintln!("{:.3}", times[times.len() / 2]);
    for (at, _) in after.distribution().iter() {
        println!("{},{}", at.x, at.y);
    }
    Ok(())
}
