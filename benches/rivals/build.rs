//! Has symplex derive the equations of motion of the arms and write them as Rust.

#[cfg(feature = "symplex")]
#[path = "build/equations.rs"]
mod equations;
#[cfg(feature = "symplex")]
#[path = "build/generate.rs"]
mod generate;
#[cfg(feature = "symplex")]
#[path = "build/vector.rs"]
mod vector;

fn main() {
    println!("cargo::rerun-if-changed=build");
    #[cfg(feature = "symplex")]
    generate::all();
}
