//! Says where the knowledge, robots and scenarios lie that the crate carries: in the repository, or in a package, into which
//! `.ci/package` puts them.

use std::path::PathBuf;

fn main() {
    let manifest = PathBuf::from(std::env::var_os("CARGO_MANIFEST_DIR").expect("Cargo sets it"));
    let packaged = manifest.join("shipped");
    let shipped = if packaged.is_dir() {
        packaged
    } else {
        manifest.join("../..")
    };
    println!("cargo::rustc-env=WISCH_SHIPPED={}", shipped.display());
    for folder in ["knowledge", "robots", "scenarios"] {
        let folder = shipped.join(folder);
        println!("cargo::rerun-if-changed={}", folder.display());
    }
}
