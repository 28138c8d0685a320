//! Writes the shipped robots as URDF files, into the directory given as first argument or else
//! `robots` of this workspace:
//!
//! ```sh
//! cargo run -p wisch-robot --example robots
//! ```

mod arms;
mod humanoid;
mod urdf;

use std::path::PathBuf;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let shipped = concat!(env!("CARGO_MANIFEST_DIR"), "/../../robots");
    let directory = PathBuf::from(std::env::args_os().nth(1).unwrap_or_else(|| shipped.into()));
    std::fs::create_dir_all(&directory)?;
    let robots = [
        ("humanoid.urdf", humanoid::humanoid()),
        ("arm7.urdf", arms::arm7()),
        ("arm6.urdf", arms::arm6()),
    ];
    for (file_name, text) in robots {
        println!("{file_name} {} bytes", text.len());
        std::fs::write(directory.join(file_name), text)?;
    }
    Ok(())
}
