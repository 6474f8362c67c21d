//! Calls that ask for too much: see [`limits`](crate::limits).

use super::Mistake;
#[cfg(feature = "files")]
use crate::limits::MOST_PLACES;
use crate::limits::{
    DEEPEST_DELIMITERS, DEEPEST_VALUE, MOST_JOINTS, MOST_LETTERS, MOST_PARTS, MOST_TERMS,
    MOST_TERMS_IN_ALL, MOST_TOKENS,
};
use crate::words::{all, shortened};

mistakes! {
    tokens() "more than {MOST_TOKENS} words, numbers and signs in one call";
    /// Delimiters inside of each other.
    delimiters(what: &str) "{what} nested more than {DEEPEST_DELIMITERS} deep";
    /// Links of a file that are fixed to each other, many in a row.
    #[cfg(feature = "files")]
    places()
        "more than {MOST_PLACES} fixed joints on the ways to all links from those that move them: join links that are \
         fixed to each other";
    joints() "more than {MOST_JOINTS} joints";
    long_function(name: &str, most_joints: usize) "`{name}` of more than {most_joints} joints would be too long";
    /// A long function besides others.
    long_functions(name: &str, others: &[&str] => all, joints: usize)
        "`{name}` besides {others} would be too long for one call with {joints} joints: ask for it in a call of its \
         own, for a second struct with this table";
    terms_written() "a value has at most {MOST_TERMS} terms: name parts of it by `let`";
    nested_value() "nested more than {DEEPEST_VALUE} deep: name parts of it by `let`";
    terms() "more than {MOST_TERMS} terms, the `let`s in it written out";
    terms_in_all()
        "the values of this call have more than {MOST_TERMS_IN_ALL} terms in all, the `let`s in them written out";
    digits() "the exact value of this is a fraction of more than 1,200 digits: write a decimal number";
    digits_in_all() "the exact fractions of this table have more than 50,000 digits in all: write decimal numbers";
    name(name: &str) {start: shortened(name), letters: name.chars().count()}
        "a name has at most {MOST_LETTERS} letters: `{start}` has {letters}";
    /// A function of a frame besides others.
    of_frames(name: &str, joints: usize)
        "`{name}` besides the other functions of frames would be too long for one call with {joints} joints: ask for it in a \
         call of its own, for a second struct with this table";
    /// Tuples of functions with too many functions in all.
    parts(joints: usize) {most: MOST_PARTS / joints.max(1)}
        "the tuples of one call have at most {most} functions in all with {joints} joints";
}
