//! Rebuilds the program when the knowledge that it carries changes.

fn main() {
    println!("cargo::rerun-if-changed=../../knowledge");
}
