//! Functions of one state use no registers of 512 bits on Intel's processors.
//!
//! While an instruction on them is under way, one of the two units that multiply doubles is shut, and the operations
//! behind the sines take up to twice as long.

use std::path::Path;
use std::process::Command;

use crate::machine_code::Listing;

/// The architecture whose instructions the listing knows, and a processor of Intel's that has AVX-512.
const TARGET: &str = "x86_64-unknown-linux-gnu";
const PROCESSOR: &str = "-C target-cpu=sapphirerapids";

#[test]
#[ignore = "compiles the library for another processor: .ci/run runs it"]
fn one_state_needs_no_register_of_512_bits_on_intel() {
    if !cfg!(all(
        target_arch = "x86_64",
        target_os = "linux",
        target_env = "gnu"
    )) {
        return println!("left out: the program is compiled for {TARGET} alone");
    }
    // The folder of all that is built: libraries of the macro are shared.
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("..");
    let built = Command::new(env!("CARGO"))
        .args(["build", "--quiet", "--release", "--bin", "seven_joints"])
        .args(["--target", TARGET, "--target-dir"])
        .arg(&folder)
        .env("RUSTFLAGS", PROCESSOR)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .status();
    assert!(built.is_ok_and(|status| status.success()));
    let program = folder.join(TARGET).join("release/seven_joints");
    let Some(listing) = Listing::of_program(&program) else {
        return;
    };
    for function in [
        "torques_of_seven_joints",
        "inertia_of_seven_joints",
        "weight_of_seven_joints",
    ] {
        let reached = listing.reached_from(function);
        let mut all = reached.iter().flat_map(|(_, instructions)| *instructions);
        assert!(
            all.any(|line| line.contains("%ymm")),
            "{function} evaluates its sines"
        );
        listing.assert_free(function, |line| line.contains("%zmm"));
    }
}
