//! The scoreboard of the numerical hard cases, as the program of that name prints it.

use std::process::Command;

use crate::page::{Part, Section};

pub(crate) fn section() -> Section {
    let mut section = Section::new("Hard cases");
    section.text(
        "What was measured, the bound it is held to, what a naive implementation gets: the output of \
         cargo run --release -p hard_cases. tests/hard_cases holds the same scores; the entries \
         are those of tests/data/hard_cases.json.",
    );
    let output = Command::new(env!("CARGO"))
        .args(["run", "--release", "--quiet", "-p", "hard_cases"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output();
    let lines = match output {
        Ok(output) if !output.stdout.is_empty() => {
            String::from_utf8_lossy(&output.stdout).into_owned()
        }
        _ => "cargo could not run it here".to_owned(),
    };
    section.parts.push(Part::Lines(lines));
    section
}
