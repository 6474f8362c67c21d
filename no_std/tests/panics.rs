//! The programs of `without_panics` are linked as a controller's would be: no function of theirs can panic, and that of
//! singles has no operation in double precision.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const CONTROLLER: &str = "thumbv7em-none-eabihf";

/// The folder of the programs for this machine, or for another one.
fn linked(target: Option<&str>) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"))
        .parent()
        .expect("the target's folder");
    let manifest = concat!(env!("CARGO_MANIFEST_DIR"), "/without_panics/Cargo.toml");
    let mut command = Command::new(env!("CARGO"));
    command
        .args([
            "build",
            "--quiet",
            "--release",
            "--manifest-path",
            manifest,
            "--target-dir",
        ])
        .arg(folder);
    if let Some(target) = target {
        command.args(["--target", target]);
    }
    let output = command.output().expect("cargo");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{errors}");
    folder.join(target.unwrap_or_default()).join("release")
}

/// Whether the name of a function of the compiler's library begins so, as far as a program calls one.
fn calls(program: &Path, function: &str) -> bool {
    let bytes = fs::read(program).expect("a program");
    bytes
        .windows(function.len())
        .any(|name| name == function.as_bytes())
}

#[test]
fn nothing_can_panic_on_this_machine() {
    if cfg!(not(target_os = "linux")) {
        return println!("left out: programs begin elsewhere than on Linux");
    }
    linked(None);
}

#[test]
fn nothing_can_panic_on_a_cortex_m4f_and_singles_need_no_doubles() {
    let installed = Command::new("rustup")
        .args(["target", "list", "--installed"])
        .output();
    let has_target =
        |output: std::process::Output| String::from_utf8_lossy(&output.stdout).contains(CONTROLLER);
    if !installed.is_ok_and(has_target) {
        assert!(
            std::env::var_os("CI").is_none(),
            "the target {CONTROLLER} is not installed"
        );
        return println!("left out: the target {CONTROLLER} is not installed");
    }
    let folder = linked(Some(CONTROLLER));
    for (program, has_doubles) in [("single", false), ("double", true)] {
        let program = folder.join(program);
        assert_eq!(
            calls(&program, "__aeabi_d"),
            has_doubles,
            "{}",
            program.display()
        );
    }
}
