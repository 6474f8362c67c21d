//! Calls that ask for too much: see [`limits`](crate::limits).

use super::Mistake;
use crate::limits::{
    DEEPEST_DELIMITERS, DEEPEST_VALUE, MOST_JOINTS, MOST_LETTERS, MOST_PARTS, MOST_TERMS,
    MOST_TERMS_IN_ALL, MOST_TOKENS,
};
use crate::words::{all, shortened};

pub(crate) fn tokens() -> Mistake {
    Mistake::new(format!(
        "more than {MOST_TOKENS} words, numbers and signs in one call"
    ))
}

/// Delimiters inside of each other.
pub(crate) fn delimiters(what: &str) -> Mistake {
    Mistake::new(format!("{what} nested more than {DEEPEST_DELIMITERS} deep"))
}

pub(crate) fn name(name: &str) -> Mistake {
    let (start, letters) = (shortened(name), name.chars().count());
    Mistake::new(format!(
        "a name has at most {MOST_LETTERS} letters: `{start}` has {letters}"
    ))
}

pub(crate) fn joints() -> Mistake {
    Mistake::new(format!("more than {MOST_JOINTS} joints"))
}

pub(crate) fn long_function(name: &str, most_joints: usize) -> Mistake {
    Mistake::new(format!(
        "`{name}` of more than {most_joints} joints would be too long"
    ))
}

/// A long function besides others.
pub(crate) fn long_functions(name: &str, others: &[&str], joints: usize) -> Mistake {
    Mistake::new(format!(
        "`{name}` besides {} would be too long for one call with {joints} joints: \
         ask for it in a call of its own, for a second struct with this table",
        all(others)
    ))
}

/// Tuples of functions with too many functions in all.
pub(crate) fn parts(joints: usize) -> Mistake {
    let most = MOST_PARTS / joints.max(1);
    Mistake::new(format!(
        "the tuples of one call have at most {most} functions in all with {joints} joints"
    ))
}

pub(crate) fn terms_written() -> Mistake {
    Mistake::new(format!(
        "a value has at most {MOST_TERMS} terms: name parts of it by `let`"
    ))
}

pub(crate) fn nested_value() -> Mistake {
    Mistake::new(format!(
        "nested more than {DEEPEST_VALUE} deep: name parts of it by `let`"
    ))
}

pub(crate) fn terms() -> Mistake {
    Mistake::new(format!(
        "more than {MOST_TERMS} terms, the `let`s in it written out"
    ))
}

pub(crate) fn terms_in_all() -> Mistake {
    Mistake::new(format!(
        "the values of this call have more than {MOST_TERMS_IN_ALL} terms in all, \
         the `let`s in them written out"
    ))
}

pub(crate) fn digits() -> Mistake {
    Mistake::new(
        "the exact value of this is a fraction of more than 1,200 digits: write a decimal number",
    )
}

pub(crate) fn digits_in_all() -> Mistake {
    Mistake::new(
        "the exact fractions of this table have more than 50,000 digits in all: \
         write decimal numbers",
    )
}
