//! Mistakes in values.

use std::fmt::Display;

use super::Mistake;
use crate::audience::Audience;
use crate::limits::MOST_LISTED;
use crate::words::{self, either, is_raw_name, shortened};

mistakes! {
    /// Something that is no part of a value, such as a path or a method call.
    foreign(what: &str)
        "{what} does not belong in a value, which is made of numbers, `PI`, `deg(x)`, `sqrt(x)`, `sin(x)`, `cos(x)`, \
         fields, `let` names, `+ - * /` and parentheses";
    /// A power, by that sign.
    power(sign: &str, base: &str)
        "`{sign}` does not belong in a value: a power is a product, `{base} * {base}`";
    /// `2 x`
    #[cfg(feature = "files")]
    sign_missing(first: &str => shortened, second: &str => shortened)
        {product: format!("{first} * {second}")}
        "no sign stands between `{first}` and `{second}`: a product is `{product}`";
    /// `rod(0.5`, and the same closed.
    #[cfg(feature = "files")]
    parenthesis_missing(closed: &str => shortened) "a `)` is missing: `{closed}`";
    #[cfg(feature = "files")]
    parenthesis_too_many() "this `)` closes nothing: remove it, or write a `(` before";
    with_self() "a field is written by its name alone, without `self`";
    path_to_pi() "write `PI` alone, without a path";
    /// A constant of Rust's standard library, which is written otherwise here.
    constant_of_std(name: &str, ours: &str) "constants of Rust cannot be read here: write `{ours}` for `{name}`";
    /// A function of what depends on a field.
    function_of_field(name: &str)
        "`{name}` takes a number: a field has its value where the struct is built, and constants are exact here. \
         Make the result a field";
    /// `sqrt(PI)`
    root_of_pi() "`sqrt` takes a number without `PI`: write its value in decimals";
    root_of_negative() "`sqrt` of a negative number";
    /// An angle so huge that nothing is known of its sine.
    sine_unknown() "the sine of so large an angle is not known";
    degrees_of_nothing() "`deg` takes an angle in degrees: `deg(90)`";
    empty_parentheses() "expected a value between the parentheses";
    division_by_zero() "division by zero";
    too_large() "this value is larger than the largest `f64`";
    /// A value that is read before its `let`.
    bound_below(name: &str) "`{name}` is bound further down: move its `let` above this line";
    /// A name that means something already, whatever it is to be given to.
    reserved(what: &str, name: &str) "a {what} cannot be named `{name}`, which means something already";
    field_twice(name: &str) "there is a field `{name}` already";
    let_twice(name: &str) "there is a `let {name}` already";
    let_mut() "no `mut` here: the value of a `let` does not change";
    /// A path to a constant of that name.
    constant_by_path(name: &impl Display)
        {is_finite: !["NAN", "INFINITY", "NEG_INFINITY"].contains(&name.to_string().as_str())}
        "constants of Rust cannot be read here: write its value, `let {name} = ...;` at the top of the table, or make \
         it a field of the struct" if is_finite else "{FINITE}";
    other_function(name: &str)
        {is_angle: ["degree", "degrees", "radians", "to_radians", "deg2rad"].contains(&name)}
        "`{name}(...)` is not known: write `deg(90)` for an angle in degrees; an angle in rad is a number" if is_angle
        else "`{name}(...)` is not known: the functions are `deg(x)`, `sqrt(x)`, `sin(x)` and `cos(x)`";
    /// A list of the wrong length.
    other_count(shown: &str, found: usize => values) "expected `{shown}`, found {found}";
    /// A Rust constant in place of a `let`.
    constant(name: &impl Display, value: Option<&str>) {value: value.unwrap_or("...")}
        "a value is named by `let`: write `let {name} = {value};`";
}

/// So many values.
fn values(count: usize) -> String {
    match count {
        0 => "no value".to_owned(),
        1 => "1 value".to_owned(),
        n => format!("{n} values"),
    }
}

/// A name that means nothing. `variable` is the cell to which the joint's own variable is added, which
/// may be what was meant.
pub(crate) fn unknown_name(
    name: &str,
    meant: Option<&str>,
    known: &[&str],
    variable: Option<&str>,
) -> Mistake {
    let hint = match meant {
        Some(right) => format!("did you mean `{right}`?"),
        None if !is_free(name) => FINITE.to_owned(),
        None if is_constant(name) => format!(
            "constants of Rust cannot be read here: write `let {} = ...;` above, \
             or make it a field of the struct",
            shortened(name)
        ),
        None if known.is_empty() => {
            "expected numbers, for there are no fields, and no `let` is above".to_owned()
        }
        None if known.len() > MOST_LISTED => "expected a field or a `let`".to_owned(),
        None => format!("expected a field or a `let`: {}", either(known)),
    };
    let variable = variable.map_or(String::new(), |cell| {
        format!(" (the joint's own variable is not written: it is added to `{cell}`)")
    });
    let name = shortened(name);
    Mistake::advice(rule!(unknown_name), |audience| {
        let hint = match audience {
            Audience::Command if meant.is_none() && is_free(&name) => {
                format!(
                    "`--field {name}=2`, for example, says what it stands for, or `[let]` in the file"
                )
            }
            _ => hint.clone(),
        };
        format!("unknown name `{name}`: {hint}{variable}")
    })
}

mistakes! {
    /// A name that the file's own list of fields does not have.
    unlisted_name(name: &str => shortened) "unknown name `{name}`: `fields` of the file does not list it";
}

/// Whether the name may be that of a field: it is none of what is infinite, or of a constant that is written otherwise.
pub(crate) fn may_be_a_field(name: &str) -> bool {
    is_free(name)
        && is_raw_name(name)
        && words::constant_of_std(name).is_none()
        && name.to_lowercase() != "pi"
}

/// Whether the name may stand for a number: `inf` stands for none.
fn is_free(name: &str) -> bool {
    !["nan", "inf", "infinity"].contains(&name.to_lowercase().as_str())
}

const FINITE: &str = "every number of a table is finite";

/// Whether the name is written as those of Rust's constants are.
fn is_constant(name: &str) -> bool {
    let is_upper = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '_';
    name.len() > 1 && name.chars().all(is_upper) && name.starts_with(|c| c != '_')
}
