//! The hard cases of `tests/data/hard_cases.json`: what is measured, against what bound.
//!
//! Each theme returns its [`Score`]s; `tests/hard_cases` asserts that they pass, the program of this package
//! prints them.

#![forbid(unsafe_code)]

mod arguments;
mod arms;
mod conditioning;
mod constants;
mod effort;
mod entries;
mod friction;
mod integration;
mod long_runs;
mod motion;
mod robustness;
mod score;
mod singular;

pub use effort::Effort;
pub use entries::all as all_entries;
pub use score::{Score, table};

/// A theme of the hard cases.
pub struct Theme {
    /// The subject of its cases.
    pub name: &'static str,
    /// The entries that its scores belong to.
    pub cases: &'static [&'static str],
    /// Measures them.
    pub measure: fn(Effort) -> Vec<Score>,
}

/// All themes.
#[rustfmt::skip]
pub const THEMES: [Theme; 8] = [
    Theme {
        name: "conditioning",
        cases: &["HC01.10", "HC01.30", "HC02", "HC03", "HC04", "HC05", "HC08"],
        measure: |_| conditioning::scores(),
    },
    Theme {
        name: "singular",
        cases: &["HC06.0", "HC06.1", "HC06.2", "HC06.3", "HC07.1e-02", "HC07.1e-04", "HC07.1e-06"],
        measure: |_| singular::scores(),
    },
    Theme {
        name: "arguments",
        cases: &["HC09.1e+06", "HC09.1e+12", "HC09.1e+15", "HC11", "HC12", "HC13.1e-02", "HC13.1e-06",
                 "HC13.1e-10", "HC14", "HC15"],
        measure: |_| arguments::scores(),
    },
    Theme {
        name: "constants",
        cases: &["HC16", "HC17", "HC18"],
        measure: |_| constants::scores(),
    },
    Theme {
        name: "friction",
        cases: &["HC21", "HC22", "HC23", "HC24"],
        measure: |_| friction::scores(),
    },
    Theme {
        name: "robustness",
        cases: &["HC35", "HC37", "HC38", "HC40", "HC41"],
        measure: robustness::scores,
    },
    Theme {
        name: "integration",
        cases: &["HC25", "HC26", "HC27", "HC28.1", "HC28.2", "HC28.3", "HC28.3.14159", "HC29", "HC33", "HC34",
                 "HC39"],
        measure: |_| integration::scores(),
    },
    Theme {
        name: "long_runs",
        cases: &["HC30", "HC31", "HC32", "HC46"],
        measure: long_runs::scores,
    },
];
