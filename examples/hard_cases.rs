//! The scoreboard of the numerical hard cases: what was measured, the bound, pass or fail.
//!
//! ```text
//! cargo run --release --example hard_cases
//! ```
//!
//! `tests/hard_cases` holds the same scores; in a build that is not optimised the long runs are shorter.

use std::process::ExitCode;

#[path = "../tests/hard_cases/cases/mod.rs"]
mod cases;

use cases::{Effort, Score, THEMES};

fn main() -> ExitCode {
    let measured = THEMES
        .iter()
        .flat_map(|theme| (theme.measure)(Effort::of_this_build()));
    let scores: Vec<Score> = measured.collect();
    print!("{}", cases::table(&scores));
    let passed = scores
        .iter()
        .filter(|s| s.is_passed() && s.is_sharp())
        .count();
    let entries = cases::all_entries();
    let is_measured = |id: &str| scores.iter().any(|score| score.case == id);
    let on_the_board = entries
        .iter()
        .filter(|entry| is_measured(entry.id()))
        .count();
    println!(
        "{passed} of {} quantities of {on_the_board} entries pass",
        scores.len()
    );
    println!(
        "the other {} entries: tests/hard_cases/elsewhere.rs",
        entries.len() - on_the_board
    );
    match passed == scores.len() {
        true => ExitCode::SUCCESS,
        false => ExitCode::FAILURE,
    }
}
