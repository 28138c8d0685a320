//! Writes the meshes of the shipped scenarios as binary STL files into `scenarios/meshes`:
//!
//! ```sh
//! cargo run -p wisch-testkit --example scenario_meshes
//! ```

use wisch_testkit::{AnyError, curved_meshes::scenario_meshes, root};

fn main() -> Result<(), AnyError> {
    let folder = root().join("scenarios/meshes");
    std::fs::create_dir_all(&folder)?;
    for made in scenario_meshes() {
        std::fs::write(folder.join(made.file_name), made.mesh.to_binary_stl())?;
        println!(
            "{} {} triangles",
            made.file_name,
            made.mesh.triangles().len()
        );
    }
    Ok(())
}
