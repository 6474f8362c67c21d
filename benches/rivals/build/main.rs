//! Has symplex derive the equations of motion of the arms and write them as Rust.

#[cfg(feature = "symplex")]
mod equations;
#[cfg(feature = "symplex")]
mod generate;
#[cfg(feature = "symplex")]
mod vector;

fn main() {
    println!("cargo::rerun-if-changed=build");
    #[cfg(feature = "symplex")]
    generate::all();
}
