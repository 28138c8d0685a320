//! Writes the meshes of the shipped tools as binary STL files, into the directory given as first
//! argument or else `knowledge/meshes` of this workspace:
//!
//! ```sh
//! cargo run -p wisch-robot --example tool_meshes
//! ```

mod shapes;

use std::path::PathBuf;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let shipped = concat!(env!("CARGO_MANIFEST_DIR"), "/../../knowledge/meshes");
    let directory = PathBuf::from(std::env::args_os().nth(1).unwrap_or_else(|| shipped.into()));
    std::fs::create_dir_all(&directory)?;
    for tool in shapes::all()? {
        let bytes = tool.mesh.to_binary_stl();
        println!(
            "{} {} triangles, {} bytes",
            tool.file_name,
            tool.mesh.triangles().len(),
            bytes.len()
        );
        std::fs::write(directory.join(tool.file_name), bytes)?;
    }
    Ok(())
}
