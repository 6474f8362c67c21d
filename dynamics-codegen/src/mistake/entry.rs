//! Mistakes in the entries of the table.

use std::fmt::Display;

use dynamics_symbolic::function::frame_in_methods;

use super::Mistake;
use crate::audience::AT_THE_END;
use crate::description::{Name, Wanted};
use crate::words::{number, shortened};

mistakes! {
    /// A word that is no convention.
    unknown_convention(word: &str => shortened)
        "unknown convention `{word}`: `standard` is Rz(theta) Tz(d) Tx(a) Rx(alpha), `modified` (Craig's) is \
         Rx(alpha) Tx(a) Rz(theta) Tz(d)";
    /// A word of `allow` that belongs to the whole table.
    allowed_for_the_table(word: &str) [allow: allow(word, AT_THE_END)]
        "`{word}` is about the whole table: write {allow}";
    no_function() "no function is requested: name one, or leave `functions` out for the default set";
    function_twice(name: &str) "`{name}` is requested twice";
    /// `default` and one of its functions.
    /// `(a, b)` in the list of functions, as it is written.
    tuple_without_name(shown: &str) "functions that are computed together have a name: write `name = {shown}`";
    /// `name: (a, b)`
    tuple_by_colon(name: &impl Display) "functions are put together by `=`: write `{name} = (...)`";
    default_for_one() "`default` stands for several functions: name each of them";
    /// The name of the method where the function is requested at a frame.
    method_of_frame(function: &str, frame: &str => shortened)
        {method: frame_in_methods(&frame)}
        "a function at a frame is written `{function}({frame})`: its method is `{function}_{method}`, in lower case";
    tuple_named_as_function(name: &str) "`{name}` is the name of a function: a tuple has another one";
    /// `name = ()`
    no_parts(name: &impl Display)
        "`{name}` has no functions: write `{name} = (mass_matrix, gravity_vector)`, for example";
    /// `name = (a)`
    one_part(name: &impl Display, wanted: &Wanted)
        {function: wanted.name(), frame: wanted.frame.as_ref().map(Name::plain)} [asked: wanted(function, frame)]
        "`{name}` has one function alone, which is requested by its own name: write {asked}";
    part_twice(name: &impl Display, function: &str) "`{function}` is in `{name}` twice";
    /// A function whose program is its own.
    never_a_part(function: &str) "`{function}` shares nothing with other functions: request it outside the tuple";
    /// The reason, as the end of a sentence.
    no_closed_form(why: &impl Display)
        "the inverse kinematics of this arm have no closed form, because {why}; `InverseKinematics` of the runtime solves \
         numerically, for any arm";
    /// A function that divides by the mass of all links.
    no_mass(function: &str)
        "`{function}` of an arm without mass: there is no centre of mass, write `mass` in a row that moves";
    /// A model in which nothing resists a motion.
    no_inertia() [functions: functions("forward_kinematics", "jacobian"), allow: allow("no_inertia", AT_THE_END)]
        "no link of this arm has a mass, a tensor or a motor with inertia: write `mass` in its rows, or request \
         functions of its geometry alone, {functions} ({allow} takes it as massless)";
    /// Gravity, m/s^2, as it is nowhere.
    odd_gravity(magnitude: f64 => number) [allow: allow("odd_gravity", AT_THE_END)]
        "gravity of {magnitude} m/s^2: Earth's is 9.81; write [0, 0, 0] for no gravity ({allow} accepts it)";
    /// The same along each axis, m/s^2, and the magnitude of all.
    gravity_along_all(component: f64 => number, magnitude: f64) [allow: allow("odd_gravity", AT_THE_END)]
        "gravity of {component} m/s^2 along each axis is {magnitude:.2} m/s^2 in all: write `[0, 0, -9.81]` where z \
         points up ({allow} accepts it)";
    no_lock() "no joint is locked: name one, `[joint = position]`, or leave `lock` out";
    /// `joint: position`, or `follower: leader`
    joint_by_colon(name: &Name, is_follower: bool)
        "a joint follows another one by `=`: write `{name} = factor * leader + offset`" if is_follower
        else "a joint is locked by `=`: write `{name} = position`";
    locked_twice(name: &str) "`{name}` is locked twice";
    all_locked() "all joints are locked: an arm has at least one that moves";
    share_with_field() "a share is a number: it does not depend on a field";
    share_of_nothing() "the share must be above 0: `1%`, for example";
    neglect_and_tests()
        "`tests: true` compares with the whole table, of which `neglect` leaves a part out: remove one of the two";
    neglect_and_identification(function: &str)
        "`{function}` is about all base parameters, some of which `neglect` leaves out: remove one of the two";
    neglect_and_field(name: &impl Display)
        "what may be neglected depends on numbers: the value of the field `{name}` is not known here";
    neglect_without_limits(name: &impl Display) [limits: cell("limits: [lower, upper]")]
        "`neglect` needs to know how far `{name}` slides: write {limits}, in m";
    tests_of_one_factor(function: &str, other: &str)
        "`tests: true` has nothing to compare: `{function}` is tested together with `{other}`, request both";
    /// In a call, or in a file, of either format.
    missing_convention(is_of_file: bool)
        "missing `convention`: expected \"standard\" or \"modified\"" if is_of_file
        else "missing `convention`: write `convention: standard` or `convention: modified`";
    missing_gravity(is_of_file: bool) [example: gravity(is_of_file)]
        "missing `gravity`, the acceleration of gravity in the axes of the world, those of the base frame where there \
         is no `base`: {example}, for example";
    missing_joints(is_of_file: bool)
        "missing joints: expected a table for each, with `name`, `type` and its cells" if is_of_file
        else "missing `joints`: write `joints: [name: revolute {{ ... }}, ...]`";
    /// A joint that the file and the entries beside it lock at different positions.
    locked_at_two(name: &str, one: Option<f64> => known, other: Option<f64> => known)
        "`{name}` is locked at {one} in one place and at {other} in another: remove one of the two";
    locked_out_of_limits(value: f64 => number, name: &str, lower: f64 => number, upper: f64 => number)
        "{value} is outside of the limits of `{name}`, {lower} to {upper}";
    /// 1 or more, in percent or not.
    share_of_more_than_all(size: f64 => number, is_percent: bool)
        "a share is below 100%" if is_percent else "a share is below 1: `{size}%` is {size} parts of a hundred";
}

/// A position, if it is a number.
fn known(position: Option<f64>) -> String {
    position.map_or("the value of a formula".to_owned(), number)
}
