//! Mistakes in the entries of the table.

use std::fmt::Display;

use super::Mistake;
use crate::audience::{AT_THE_END, Audience};
use crate::description::Name;
use crate::words::{either, number, shortened};

mistakes! {
    /// A word that is no convention.
    unknown_convention(word: &str => shortened)
        "unknown convention `{word}`: `standard` is Rz(theta) Tz(d) Tx(a) Rx(alpha), `modified` (Craig's) is \
         Rx(alpha) Tx(a) Rz(theta) Tz(d)";
    /// A word of `allow` that belongs to the whole table.
    allowed_for_the_table(word: &str) [allow: allow(word, AT_THE_END)]
        "`{word}` is about the whole table: write {allow}";
    no_function() "no function is asked for: name one, or leave `functions` out for the default set";
    function_twice(name: &str) "`{name}` is asked for twice";
    /// `default` and one of its functions.
    in_default_set(name: &str) "`{name}` is in the default set already";
    /// `(a, b)` in the list of functions, as it is written.
    tuple_without_name(shown: &str) "functions that are computed together have a name: write `name = {shown}`";
    /// `name: (a, b)`
    tuple_by_colon(name: &impl Display) "functions are put together by `=`: write `{name} = (...)`";
    default_in_tuple() "`default` stands for several functions: a tuple names each of its own";
    tuple_named_as_function(name: &str) "`{name}` is the name of a function: a tuple has another one";
    /// `name = ()`
    no_parts(name: &impl Display)
        "`{name}` has no functions: write `{name} = (mass_matrix, gravity_vector)`, for example";
    /// `name = (a)`
    one_part(name: &impl Display, function: &str)
        "`{name}` is one function alone, which is asked for by its own name: write `{function}`";
    part_twice(name: &impl Display, function: &str) "`{function}` is in `{name}` twice";
    /// A function whose program is its own.
    never_a_part(function: &str) "`{function}` shares nothing with other functions: ask for it apart from the tuple";
    /// A function that divides by the mass of all links.
    no_mass(function: &str)
        "`{function}` of an arm without mass: there is no centre of mass, write `mass` in a row that moves";
    /// A model in which nothing resists a motion.
    no_inertia() [functions: functions("forward_kinematics", "jacobian"), allow: allow("no_inertia", AT_THE_END)]
        "no link of this arm has a mass, a tensor or a motor with inertia: write `mass` in its rows, or ask for \
         functions of its geometry alone, {functions} ({allow} takes it as massless)";
    /// Gravity, m/s^2, as it is nowhere.
    odd_gravity(magnitude: f64 => number) [allow: allow("odd_gravity", AT_THE_END)]
        "gravity of {magnitude} m/s^2: on Earth it is 9.81, and [0, 0, 0] is none ({allow} accepts it)";
    no_lock() "no joint is locked: name one, `[joint = position]`, or leave `lock` out";
    /// `joint: position`
    lock_by_colon(name: &Name) "a joint is locked by `=`: write `{name} = position`";
    locked_twice(name: &str) "`{name}` is locked twice";
    all_locked() "all joints are locked: an arm has at least one that moves";
    share_with_field() "a share is a number: it does not depend on a field";
    share_of_nothing() "a share is above 0, `1%` for example";
    neglect_and_tests()
        "`tests: true` compares with the whole table, of which `neglect` leaves a part out: remove one of the two";
    neglect_and_identification(function: &str)
        "`{function}` is about all base parameters, some of which `neglect` leaves out: remove one of the two";
    neglect_and_field(name: &impl Display)
        "what may be neglected depends on numbers: the value of the field `{name}` is not known here";
    neglect_without_limits(name: &impl Display)
        "`neglect` needs to know how far `{name}` slides: write `limits: [lower, upper]`, in m";
    tests_of_one_factor(function: &str, other: &str)
        "`tests: true` has nothing to compare: `{function}` is tested together with `{other}`, ask for both";
}

/// In a call, or in a file, of either format.
pub(crate) fn missing_convention(is_of_file: bool) -> Mistake {
    Mistake::new(match is_of_file {
        true => "missing `convention`: expected \"standard\" or \"modified\"",
        false => "missing `convention`: write `convention: standard` or `convention: modified`",
    })
}

pub(crate) fn missing_gravity(is_of_file: bool) -> Mistake {
    Mistake::advice(|audience| {
        let example = match (audience, is_of_file) {
            (Audience::Call, false) => "write `gravity: [0, 0, -9.81]`",
            (Audience::Call, true) | (Audience::File, _) => "expected [0, 0, -9.81]",
            (Audience::Command, _) => "expected [0, 0, -9.81], or `--gravity 0,0,-9.81`",
        };
        format!(
            "missing `gravity`, the acceleration of gravity in the axes of the world, those of the base frame \
             where there is no `base`: {example}, for example"
        )
    })
}

pub(crate) fn missing_joints(is_of_file: bool) -> Mistake {
    Mistake::new(match is_of_file {
        true => "missing joints: expected a table for each, with `name`, `type` and its cells",
        false => "missing `joints`: write `joints: [name: revolute { ... }, ...]`",
    })
}

/// A joint that the file and the entries beside it lock at different positions; one that is no number is none here.
pub(crate) fn locked_at_two(name: &str, positions: [Option<f64>; 2]) -> Mistake {
    let shown =
        |position: Option<f64>| position.map_or("the value of a formula".to_owned(), number);
    let [one, other] = positions.map(shown);
    Mistake::new(format!(
        "`{name}` is locked at {one} in one place and at {other} in another: remove one of the two"
    ))
}

/// A name that no joint has.
pub(crate) fn unknown_joint(word: &str, meant: Option<&str>, known: &[&str]) -> Mistake {
    let hint = match meant {
        Some(right) => format!("did you mean `{right}`?"),
        None => format!("expected {}", either(known)),
    };
    Mistake::new(format!("unknown joint `{}`: {hint}", shortened(word)))
}

pub(crate) fn locked_out_of_limits(value: f64, name: &str, [lower, upper]: [f64; 2]) -> Mistake {
    let [value, lower, upper] = [value, lower, upper].map(number);
    Mistake::new(format!(
        "{value} is outside of the limits of `{name}`, {lower} to {upper}"
    ))
}

/// 1 or more, in percent or not.
pub(crate) fn share_of_more_than_all(size: f64, percent: bool) -> Mistake {
    Mistake::new(match percent {
        true => "a share is below 100%".to_owned(),
        false => format!(
            "a share is below 1: `{0}%` is {0} parts of a hundred",
            number(size)
        ),
    })
}
