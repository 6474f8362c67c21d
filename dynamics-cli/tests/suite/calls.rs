//! Calls of the command, and files for them.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A file of `tests/data`.
pub(crate) fn data(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data");
    folder.join(name).to_string_lossy().into_owned()
}

/// A folder for what a test writes.
pub(crate) fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// A file with that text.
pub(crate) fn file(name: &str, text: impl AsRef<[u8]>) -> String {
    let path = folder("files").join(name);
    std::fs::write(&path, text).expect("a file");
    path.to_string_lossy().into_owned()
}

/// The arguments of a call, in a list or in one text with spaces between them.
pub(crate) trait Arguments {
    fn arguments(&self) -> Vec<&str>;
}

impl Arguments for &str {
    fn arguments(&self) -> Vec<&str> {
        self.split_whitespace().collect()
    }
}

impl Arguments for &String {
    fn arguments(&self) -> Vec<&str> {
        self.split_whitespace().collect()
    }
}

impl Arguments for String {
    fn arguments(&self) -> Vec<&str> {
        self.split_whitespace().collect()
    }
}

impl Arguments for &[&str] {
    fn arguments(&self) -> Vec<&str> {
        self.to_vec()
    }
}

impl<const K: usize> Arguments for &[&str; K] {
    fn arguments(&self) -> Vec<&str> {
        self.to_vec()
    }
}

impl Arguments for &Vec<&str> {
    fn arguments(&self) -> Vec<&str> {
        self.to_vec()
    }
}

pub(crate) fn run(arguments: impl Arguments) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_robot-dynamics"));
    let arguments = arguments.arguments();
    command.args(arguments).output().expect("the command")
}

pub(crate) use arms::is_installed as has;

/// The output of another program that succeeds.
#[track_caller]
pub(crate) fn succeed(command: &mut Command) -> String {
    let output = command.output().expect("a program that runs");
    let text = String::from_utf8(output.stdout).expect("text");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}: {text}{errors}");
    text
}

/// The output of a call that succeeds.
#[track_caller]
pub(crate) fn output(arguments: impl Arguments) -> String {
    let arguments = arguments.arguments();
    let output = run(&arguments);
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {errors}");
    String::from_utf8(output.stdout).expect("text")
}

/// The message of a call that fails.
#[track_caller]
pub(crate) fn errors(arguments: impl Arguments, status: i32) -> String {
    let arguments = arguments.arguments();
    let output = run(&arguments);
    let errors = String::from_utf8(output.stderr).expect("text");
    let found = output.status.code();
    assert_eq!(found, Some(status), "{arguments:?}: {errors}");
    assert!(!errors.contains("panicked"), "{errors}");
    errors
}

/// Asserts that all of these stand in a text.
#[track_caller]
pub(crate) fn assert_has<const K: usize>(text: &str, parts: [&str; K]) {
    for part in parts {
        assert!(text.contains(part), "no `{part}` in: {text}");
    }
}

/// Asserts that a call fails with a message in which all of these stand.
#[track_caller]
pub(crate) fn refused<const K: usize>(call: impl Arguments, status: i32, parts: [&str; K]) {
    assert_has(&errors(call, status), parts);
}

/// Two rods that hang from each other.
pub(crate) const PENDULUM: &str = r#"
convention = "modified"
gravity = ["9.81", 0, 0]

[[joint]]
name = "pivot"
type = "revolute"
mass = 2
com = [0.5, 0, 0]

[[joint]]
name = "knee"
type = "revolute"
a = 1
mass = 1
com = [0.25, 0, 0]
"#;
