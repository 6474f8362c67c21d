//! A change of a robot's file compiles the crate again that names it.

use std::path::{Path, PathBuf};
use std::process::Command;

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

/// A package of its own beside what was built for this test, with the workspace's versions.
fn package() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("rebuild");
    std::fs::create_dir_all(folder.join("src")).expect("a folder");
    let project = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let manifest = format!(
        "[package]\nname = \"rebuild\"\nedition = \"2024\"\n[workspace]\n\
         [dependencies]\nrobot-dynamics = {{ path = {project:?} }}\n"
    );
    write(&folder, "Cargo.toml", &manifest);
    write(&folder, "src/main.rs", PROGRAM);
    std::fs::copy(project.join("Cargo.lock"), folder.join("Cargo.lock")).expect("the lock file");
    folder
}

fn write(folder: &Path, name: &str, text: &str) {
    std::fs::write(folder.join(name), text).expect("a file");
}

/// What the program prints when cargo is told to run it.
fn printed(folder: &Path) -> String {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["run", "--quiet", "--offline", "--target-dir", "target"]);
    let output = cargo.current_dir(folder).output().expect("cargo");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{errors}");
    String::from_utf8_lossy(&output.stdout).trim().to_owned()
}

#[test]
#[ignore = "compiles the crate without features and twice a program with it: some 40 s the first time"]
fn a_change_of_the_file_compiles_its_crate_again() {
    let folder = package();
    for mass in [1, 2] {
        write(&folder, "robot.toml", &robot(mass));
        assert_eq!(printed(&folder), format!("{}", 10 * u32::from(mass)));
    }
}
