use std::process::Command;

/// Whether another program is installed; if it is not, a line says that it is left out.
///
/// Panics where the environment has `CI`: nothing is left out there.
#[track_caller]
pub fn is_installed(program: &str) -> bool {
    let is_found = Command::new(program).arg("--version").output().is_ok();
    is_found || is_left_out(&format!("{program} is not installed"))
}

/// False, and a line that says why something is left out. Panics where the environment has `CI`.
#[track_caller]
pub fn is_left_out(why: &str) -> bool {
    assert!(std::env::var_os("CI").is_none(), "{why}, and CI is set");
    println!("left out: {why}");
    false
}
