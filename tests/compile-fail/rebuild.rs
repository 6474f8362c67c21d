//! A change of a robot's file compiles the crate again that names it.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::{LIBRARY, library_flags};

/// A program that prints the weight of the robot in its file.
const PROGRAM: &str = "\
robot_dynamics::robot_dynamics! { struct Lift; file: \"robot.toml\", functions: [gravity_vector] }
fn main() {
    let weight: robot_dynamics::nalgebra::Vector1<f64> = Lift.gravity_vector(&Default::default());
    println!(\"{}\", weight[0]);
}
";

fn robot(mass: u8) -> String {
    format!(
        "convention = \"modified\"\ngravity = [0, 0, -10]\n\
         [[joint]]\nname = \"lift\"\ntype = \"prismatic\"\nmass = {mass}\n"
    )
}

/// A package of its own. It depends on nothing: the library is that of this test, given to the compiler.
fn package() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("rebuild");
    std::fs::create_dir_all(folder.join("src")).expect("a folder");
    let manifest = "[package]\nname = \"rebuild\"\nedition = \"2024\"\n[workspace]\n";
    write(&folder, "Cargo.toml", manifest);
    write(&folder, "src/main.rs", PROGRAM);
    folder
}

fn write(folder: &Path, name: &str, text: &str) {
    std::fs::write(folder.join(name), text).expect("a file");
}

/// The output of the program under `cargo run`.
fn printed(folder: &Path, library: &Path) -> String {
    let flags = library_flags(library).join("\x1f");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["run", "--quiet", "--offline", "--target-dir", "target"]);
    cargo.env("CARGO_ENCODED_RUSTFLAGS", flags);
    let output = cargo.current_dir(folder).output().expect("cargo");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{errors}");
    String::from_utf8_lossy(&output.stdout).trim().to_owned()
}

#[test]
fn a_change_of_the_file_compiles_its_crate_again() {
    let (folder, library) = (package(), &*LIBRARY);
    for mass in [1, 2] {
        write(&folder, "robot.toml", &robot(mass));
        let weight = format!("{}", 10 * u32::from(mass));
        assert_eq!(printed(&folder, library), weight);
        // Not compiled again, and the same.
        assert_eq!(printed(&folder, library), weight);
    }
}
