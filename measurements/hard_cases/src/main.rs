//! The scoreboard of the numerical hard cases: what was measured, the bound, pass or fail.
//!
//! ```text
//! cargo run --release -p hard_cases
//! ```
//!
//! `tests/hard_cases` holds the same scores; in a build that is not optimised the long runs are shorter.

use std::process::ExitCode;

use hard_cases::{Effort, THEMES, all_entries, table};

fn main() -> ExitCode {
    let mut passed = 0;
    let mut quantities = 0;
    for theme in THEMES {
        let scores = (theme.measure)(Effort::of_this_build());
        println!("{}\n{}", theme.name, table(&scores));
        quantities += scores.len();
        passed += scores
            .iter()
            .filter(|s| s.is_passed() && s.is_sharp())
            .count();
    }
    let on_the_board: usize = THEMES.iter().map(|theme| theme.cases.len()).sum();
    let elsewhere = all_entries().len() - on_the_board;
    println!("{passed} of {quantities} quantities of {on_the_board} entries pass");
    println!("the other {elsewhere} entries: tests/hard_cases/elsewhere.rs");
    match passed == quantities {
        true => ExitCode::SUCCESS,
        false => ExitCode::FAILURE,
    }
}
