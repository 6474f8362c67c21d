//! The numerical hard cases of `tests/data/hard_cases.json`, against their reference digits.
//!
//! `cargo run --release -p hard_cases` prints the scoreboard, with the long runs at full length.

mod elsewhere;

use elsewhere::{ELSEWHERE, Place};
use hard_cases::{Effort, THEMES, all_entries, table};

/// Every score of a theme passes, and what a naive implementation gets does not.
#[track_caller]
fn hold(theme: &str) {
    let theme = THEMES.iter().find(|t| t.name == theme).expect(theme);
    let scores = (theme.measure)(Effort::of_this_build());
    print!("{}", table(&scores));
    let mut ids: Vec<_> = scores.iter().map(|score| score.case).collect();
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids, theme.cases);
    let failed: Vec<_> = scores.iter().filter(|s| !s.is_passed()).collect();
    assert!(failed.is_empty(), "{failed:#?}");
    let blunt: Vec<_> = scores.iter().filter(|s| !s.is_sharp()).collect();
    assert!(blunt.is_empty(), "a naive value passes: {blunt:#?}");
}

macro_rules! themes {
    ($($theme:ident)*) => {
        $(#[test]
        fn $theme() {
            hold(stringify!($theme));
        })*

        #[test]
        fn every_theme_has_its_test() {
            assert_eq!(THEMES.map(|theme| theme.name), [$(stringify!($theme)),*]);
        }
    };
}
themes!(conditioning singular arguments constants friction robustness integration long_runs);

/// An entry is on the scoreboard, or another test runs it, or it is said why none does.
#[test]
fn every_entry_has_its_place() {
    let on_the_board = THEMES.iter().flat_map(|theme| theme.cases);
    let elsewhere = ELSEWHERE.iter().map(|(id, _)| id);
    let mut places: Vec<&str> = on_the_board.chain(elsewhere).copied().collect();
    places.sort_unstable();
    let entries = all_entries();
    let mut ids: Vec<_> = entries.iter().map(|entry| entry.id()).collect();
    assert_eq!(ids.len(), 59);
    ids.sort_unstable();
    assert_eq!(places, ids);
}

/// The tests that `elsewhere` names exist.
#[test]
fn tests_elsewhere_exist() {
    for (id, place) in &ELSEWHERE {
        match place {
            Place::Test(file, test) => {
                let path = format!("{}/../{file}", env!("CARGO_MANIFEST_DIR"));
                let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
                assert!(text.contains(&format!("fn {test}")), "{id}: {file} {test}");
            }
            Place::NotOurs(reason) => assert!(!reason.is_empty(), "{id}"),
        }
    }
}
