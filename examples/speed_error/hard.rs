//! The scoreboard of the numerical hard cases.

use crate::cases::{Effort, Score, THEMES};
use crate::page::{Part, Section};
use crate::table::Table;

pub(crate) fn section() -> Section {
    let mut section = Section::new("Hard cases");
    section.text(
        "What was measured, the bound it is held to, what a naive implementation gets. \
         `tests/hard_cases` holds the same scores; the entries are those of tests/data/hard_cases.json.",
    );
    let measured = |theme: &crate::cases::Theme| (theme.measure)(Effort::of_this_build());
    let scores: Vec<Score> = THEMES.iter().flat_map(measured).collect();
    let passed = scores.iter().filter(|score| score.is_passed()).count();
    let heads = ["case", "quantity", "measured", "bound", "naive", "result"];
    let title = format!("{passed} of {} quantities pass", scores.len());
    let mut table = Table::new(title, &heads);
    for score in &scores {
        table.row(score.cells());
    }
    section.parts.push(Part::Table(table));
    section
}
