//! Every message about a call, each in one place: what is wrong, what was expected, and what to write
//! instead where that is known.
//!
//! A [`Mistake`] can be made in this module alone, and nothing else can be reported.

pub(crate) mod couple;
pub(crate) mod entry;
pub(crate) mod expected;
// What is wrong in a file is said where files are read.
#[cfg_attr(not(feature = "files"), allow(dead_code))]
pub(crate) mod file;
pub(crate) mod joint;
pub(crate) mod number;
pub(crate) mod size;
pub(crate) mod structure;
#[cfg(feature = "files")]
pub(crate) mod urdf;
pub(crate) mod value;

use std::fmt;

use dynamics_symbolic::neglect::NotPositiveDefinite;

use crate::words::{either, shortened};

/// What is wrong, as it is shown.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Mistake {
    text: String,
}

impl Mistake {
    fn new(text: impl Into<String>) -> Mistake {
        Mistake { text: text.into() }
    }

    /// The last mistake that is shown.
    pub(crate) fn with_others(self) -> Mistake {
        Mistake::new(self.text + " (more errors than are shown)")
    }
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.text)
    }
}

/// Something else stands where `what` was expected; nothing does where the tokens end.
pub(crate) fn instead(what: &expected::Expected, found: Option<&str>) -> Mistake {
    Mistake::new(match found {
        Some(found) => format!("expected {what}, found {found}"),
        None => format!("expected {what}"),
    })
}

/// A word that is none of those known, of which one may have been meant.
pub(crate) fn unknown(what: &str, word: &str, meant: Option<&str>, known: &[&str]) -> Mistake {
    let word = shortened(word);
    Mistake::new(match meant {
        Some(right) => format!("unknown {what} `{word}`: did you mean `{right}`?"),
        None => format!("unknown {what} `{word}`: expected {}", either(known)),
    })
}

/// A key, cell or entry that stands there already.
pub(crate) fn given_twice(word: &str) -> Mistake {
    Mistake::new(format!("`{word}` is given twice"))
}

/// An attribute on an item of the table.
pub(crate) fn attribute() -> Mistake {
    Mistake::new("only doc comments are allowed here")
}

/// `#` and no attribute.
pub(crate) fn lonely_hash() -> Mistake {
    Mistake::new("expected a name, found `#`")
}

/// Too much is neglected.
pub(crate) fn neglected_too_much(refused: &NotPositiveDefinite) -> Mistake {
    Mistake::new(refused.to_string())
}

/// The engine could not prove a function.
pub(crate) fn not_proven(failure: &impl fmt::Display) -> Mistake {
    Mistake::new(failure.to_string())
}
