//! Calls that need too much: see [`limits`](crate::limits).

use dynamics_symbolic::function::Freedoms;

use super::Mistake;
#[cfg(feature = "files")]
use crate::limits::MOST_PLACES;
use crate::limits::{
    DEEPEST_DELIMITERS, DEEPEST_VALUE, MOST_LETTERS, MOST_OPERATIONS, MOST_TERMS,
    MOST_TERMS_IN_ALL, MOST_TOKENS, OPERATIONS_IN_A_SECOND,
};
use crate::words::{all, quoted, shortened};

/// Functions that a message lists.
const MOST_NAMED: usize = 6;

mistakes! {
    tokens() "more than {MOST_TOKENS} words, numbers and signs in one call";
    /// Delimiters inside of each other.
    delimiters(what: &str) "{what} nested more than {DEEPEST_DELIMITERS} deep";
    /// Links of a file that are fixed to each other, many in a row.
    #[cfg(feature = "files")]
    places()
        "more than {MOST_PLACES} fixed joints on the ways to all links from those that move them: join links that are \
         fixed to each other";
    /// A function, or the default set, that is too long by itself.
    long_function(name: &str, operations: usize, freedoms: Freedoms => of)
        {most: thousands(MOST_OPERATIONS), time: operations / OPERATIONS_IN_A_SECOND, operations: thousands(operations)}
        "`{name}` of {freedoms} has about {operations} operations, which take about {time} s to derive: one call has at most \
         {most}. Request fewer functions, lock joints or leave them out, or evaluate the table numerically by `NewtonEuler`";
    /// A function that is too long besides others.
    long_functions(name: &str, others: &[String] => first, operations: usize, freedoms: Freedoms => of)
        {most: thousands(MOST_OPERATIONS), time: operations / OPERATIONS_IN_A_SECOND, operations: thousands(operations)}
        "`{name}` besides {others} makes about {operations} operations with {freedoms}, which take about {time} s to derive: \
         one call has at most {most}. Request it in a call of its own, for a second struct with this table";
    terms_written() "a value has at most {MOST_TERMS} terms: name parts of it by `let`";
    nested_value() "nested more than {DEEPEST_VALUE} deep: name parts of it by `let`";
    terms() "more than {MOST_TERMS} terms, the `let`s in it written out";
    terms_in_all()
        "the values of this call have more than {MOST_TERMS_IN_ALL} terms in all, the `let`s in them written out";
    digits() "the exact value of this is a fraction of more than 1,200 digits: write a decimal number";
    digits_in_all() "the exact fractions of this table have more than 75,000 digits in all: write decimal numbers";
    name(name: &str) {start: shortened(name), letters: name.chars().count()}
        "a name has at most {MOST_LETTERS} letters: `{start}` has {letters}";
}

/// The degrees of freedom: of a base that stands the joints.
fn of(freedoms: Freedoms) -> String {
    if freedoms.has_base() {
        format!("{} degrees of freedom", freedoms.all())
    } else {
        format!("{} joints", freedoms.joints)
    }
}

/// A large number, rounded to thousands.
fn thousands(number: usize) -> String {
    match number / 1000 {
        thousands @ 0..1000 => format!("{thousands},000"),
        thousands => format!("{},{:03},000", thousands / 1000, thousands % 1000),
    }
}

/// The first of some names.
fn first(names: &[String]) -> String {
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    match names.len().saturating_sub(MOST_NAMED) {
        0 => all(&names),
        more => format!("{} and {more} more", quoted(&names[..MOST_NAMED], ", ")),
    }
}
