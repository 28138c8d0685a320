//! Writes a bag of a synthetic tool that wipes the board of `scenarios/chopping-board.toml`:
//!
//! ```text
//! cargo run -p wisch-telemetry --example demo_bag -- demo.mcap
//! wisch interpret demo.mcap --task scenarios/chopping-board.toml --action absorb
//! ```

mod shown;
mod wiping;

use std::path::PathBuf;
use std::time::Instant;
use wisch::geometry::{Point3, Pose};
use wisch_telemetry::{BagHead, BagWriter};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = PathBuf::from(
        std::env::args()
            .nth(1)
            .unwrap_or_else(|| "demo.mcap".to_owned()),
    );
    let world_from_surface = Pose::translation(0.0, 0.0, 0.77);
    let wiping = wiping::Wiping {
        world_from_surface,
        extent: [0.3, 0.2],
        rows: 6,
        speed: 0.1,
        press: 10.0,
        rate: 1000.0,
    };
    let mut bag = BagWriter::create(
        &path,
        BagHead {
            joints: wiping::JOINTS.map(str::to_owned).to_vec(),
            world_from_surface,
            start: 0,
            notes: [("task".to_owned(), "demo".to_owned())].into(),
        },
    )?;
    let crumbs = [[0.1, 0.05], [-0.1, 0.0], [0.0, -0.05]]
        .map(|[x, y]| world_from_surface * Point3::new(x, y, 0.0));
    bag.write_particles(0.0, &crumbs)?;
    shown::write(&mut bag, &wiping)?;
    let start = Instant::now();
    let samples = wiping.write(&mut bag)?;
    bag.finish()?;
    let each = 1e6 * start.elapsed().as_secs_f64() / samples as f64;
    println!("{}: {samples} samples, {each:.1} us each", path.display());
    Ok(())
}
