//! Calls that need too much: see [`limits`](crate::limits).

use dynamics_symbolic::function::Freedoms;

use super::Mistake;
#[cfg(feature = "files")]
use crate::limits::MOST_PLACES;
use crate::limits::{
    DEEPEST_DELIMITERS, DEEPEST_VALUE, MOST_LETTERS, MOST_PARTS, MOST_TERMS, MOST_TERMS_IN_ALL,
    MOST_TOKENS,
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
    joints(most: usize, has_base: bool)
        "more than {most} joints on a base that moves" if has_base else "more than {most} joints";
    long_function(name: &str, most: Freedoms => more) "`{name}` of {most} would be too long";
    /// A long function besides others.
    long_functions(name: &str, others: &[&str] => all, freedoms: Freedoms => of)
        "`{name}` besides {others} would be too long for one call with {freedoms}: request it in a call of its \
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
    of_frames(name: &str, freedoms: Freedoms => of)
        "`{name}` besides the other functions of frames would be too long for one call with {freedoms}: request it in a \
         call of its own, for a second struct with this table";
    /// Tuples of functions with too many functions in all.
    parts(freedoms: Freedoms) {most: MOST_PARTS / freedoms.all().max(1), all: of(freedoms)}
        "the tuples of one call have at most {most} functions in all with {all}";
}

/// The degrees of freedom: of a base that stands the joints.
fn of(freedoms: Freedoms) -> String {
    if freedoms.has_base() {
        format!("{} degrees of freedom", freedoms.all())
    } else {
        format!("{} joints", freedoms.joints)
    }
}

fn more(most: Freedoms) -> String {
    format!("more than {}", of(most))
}
