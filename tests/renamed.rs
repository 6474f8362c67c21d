//! The macro in crates that know robot-dynamics under another name, or only through a third crate.

use std::path::{Path, PathBuf};
use std::process::Command;

/// The root of this project.
const PROJECT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// The workspace of `tests/fixtures`, copied to where cargo may write, with this project's path
/// and its lock file, so that nothing is resolved anew and no network is needed.
fn workspace() -> PathBuf {
    let project = Path::new(PROJECT);
    let copy = Path::new(env!("CARGO_TARGET_TMPDIR")).join("renamed");
    for package in ["renamed", "reexport", "downstream"] {
        let source = project.join("tests/fixtures").join(package);
        let target = copy.join(package);
        std::fs::create_dir_all(target.join("src")).expect("a folder for the package");
        copy_manifest(&source, &target);
        for code in std::fs::read_dir(source.join("src")).expect("the sources") {
            let code = code.expect("a source").path();
            let name = code.file_name().expect("a file");
            std::fs::copy(&code, target.join("src").join(name)).expect("a copy");
        }
    }
    copy_manifest(&project.join("tests/fixtures"), &copy);
    std::fs::copy(project.join("Cargo.lock"), copy.join("Cargo.lock")).expect("the lock file");
    copy
}

/// Copies a manifest, with this project's path in place of `ROBOT_DYNAMICS`.
fn copy_manifest(from: &Path, to: &Path) {
    let manifest = std::fs::read_to_string(from.join("Cargo.toml")).expect("a manifest");
    let path = PROJECT.replace('\\', "/");
    let manifest = manifest.replace("ROBOT_DYNAMICS", &path);
    std::fs::write(to.join("Cargo.toml"), manifest).expect("a copy of the manifest");
}

/// What `cargo` with these arguments prints in the workspace.
fn cargo(workspace: &Path, arguments: &[&str]) -> String {
    let run = Command::new(env!("CARGO"))
        .args(arguments)
        .args(["--quiet", "--offline"])
        .current_dir(workspace)
        .env("CARGO_TARGET_DIR", workspace.join("target"))
        .output()
        .expect("cargo runs");
    let errors = String::from_utf8_lossy(&run.stderr);
    assert!(run.status.success(), "cargo {arguments:?}: {errors}");
    String::from_utf8_lossy(&run.stdout).into_owned()
}

#[test]
fn renamed_and_reexported_dependencies_work() {
    let workspace = workspace();
    let torque = 2.0 * 9.81 * 0.5 * 0.3_f64.sin();
    for package in ["renamed", "downstream"] {
        let printed = cargo(&workspace, &["run", "--package", package]);
        let found: f64 = printed.trim().parse().expect("a number");
        assert!((found - torque).abs() < 4e-15 * 9.81, "{package}: {found}");
    }
    let tested = cargo(&workspace, &["test", "--package", "renamed"]);
    assert!(
        tested.contains("1 passed"),
        "the generated test did not run: {tested}"
    );
}
