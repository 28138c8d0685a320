//! Builds the crate anew when the knowledge or the robots that it carries change.

fn main() {
    println!("cargo::rerun-if-changed=../../knowledge");
    println!("cargo::rerun-if-changed=../../robots");
}
