//! Things that are expected where something else stands.

use std::fmt;

use crate::description::Name;
use crate::words::either;

/// A thing that was expected.
pub(crate) struct Expected(String);

impl fmt::Display for Expected {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// Makes a function of each thing that may be expected: its name, its arguments, and the text.
macro_rules! expectations {
    ($(
        $(#[$about:meta])* $name:ident($($given:ident: $type:ty $(=> $shown:ident)?),*)
        $text:literal $(if $is_first:ident else $other:literal)?;
    )*) => {$(
        $(#[$about])*
        pub(crate) fn $name($($given: $type),*) -> Expected {
            $($(let $given = $shown($given);)?)*
            $(if !$is_first {
                return Expected(format!($other));
            })?
            Expected(format!($text))
        }
    )*};
}

expectations! {
    /// The struct item.
    structure() "`struct Name;` or `struct Name {{ field: f64 }}`, then the robot's table";
    struct_name() "the struct's name";
    struct_body(name: &impl fmt::Display) "`;` or `{{ field: f64 }}` after `struct {name}`";
    field() "a field: `name: f64`";
    field_type(name: &impl fmt::Display) "`f64`, the type of the field `{name}`";
    comma_after_field(name: &impl fmt::Display) "`,` after the field `{name}`";
    attribute() "an attribute after `#`";
    /// The separator behind an item, which `what` names.
    separator(separator: char, what: &str) "`{separator}` after {what}";
    colon_after(name: &impl fmt::Display) "`:` after `{name}`";
    /// A key of that kind.
    key(what: &str, known: &[&str] => either) "a {what}: {known}";
    /// One of some words.
    one_of(known: &[&str] => either) "{known}";
    let_in_front() "`let` in front of a name that is bound";
    name_of_constant() "a name: `let name = value;`";
    name_after_let() "a name after `let`: `let name = value;`";
    equals_after_let(name: &impl fmt::Display) "`=` after `let {name}`";
    rows() "`[name: revolute {{ ... }}, ...]`";
    /// The joints that are locked, or those that follow others.
    joints(are_followers: bool)
        "`[follower = factor * leader + offset, ...]`" if are_followers else "`[joint = position, ...]`";
    named_joint(are_followers: bool)
        "the name of a joint: `follower = factor * leader + offset`" if are_followers
        else "the name of a joint: `joint = position`";
    frames() "`{{ name: {{ on: joint, xyz: [x, y, z] }}, ... }}`";
    frame() "the name of a frame: `name: {{ on: joint, ... }}`";
    frame_of_function()
        "the name of a frame, in quotes if it is no word: `jacobian(left_hand)`, `jacobian(\"left-hand\")`";
    link() "the name of a joint, or `base`";
    joint_of_file() "the name of a joint: `joint: {{ ... }}`";
    link_of_file() "the name of a link: `link: {{ mass: 2 }}`";
    links()
        "a table with the cells of each link of a file, `{{ link: {{ mass: 2 }}, ... }}`: the rows of a table are `joints`";
    value_after(name: &Name, are_followers: bool)
        "`=` and the joint that it follows after `{name}`: `{name} = factor * leader + offset`" if are_followers
        else "`=` and a position after `{name}`";
    functions() "`[function, ...]`";
    function() "the name of a function";
    name_of_tuple() "a name for the tuple: `name = (function, function)`";
    parts_of(name: &impl fmt::Display) "the functions of `{name}`: `{name} = (function, function)`";
    joint() "a joint: `name: revolute {{ ... }}` or `name: prismatic {{ ... }}`";
    joint_type(name: &impl fmt::Display, known: &[&str] => either) "the type of joint `{name}`: {known}";
    cells(joint: &str) "the cells of {joint}: `{{ ... }}`";
    /// Words that may be allowed.
    allowances(known: &[&str] => either) "`[...]` with {known}";
    inertia()
        "a tensor of named entries, `{{ xx, yy, zz, xy, yz, xz }}`, or a solid: `cuboid(x, y, z)`, `cylinder(radius, \
         length)`, `rod(length)` or `sphere(radius)`";
    base()
        "`{{ xyz: [x, y, z], rpy: [roll, pitch, yaw] }}`, or `floating {{ mass: ..., inertia: ... }}` of a base that moves";
    /// The axis along which a solid lies.
    axis() "`axis = x`, `axis = y` or `axis = z`";
    /// Another thing, as it follows the word "expected".
    thing(what: &str) "{what}";
    number() "a number";
    /// Values in brackets, or a solid with its sizes.
    array(shown: &str) "`{shown}`";
    /// The acceleration of gravity.
    gravity(shown: &str) "`{shown}`, for example `[0, 0, -9.81]` where z points up";
    value() "a value";
    end_of_parentheses() "one value and `)`";
    #[cfg(feature = "files")]
    end_of_text() "one value";
    file_name() "the path of a file, from the crate's Cargo.toml on: `\"robots/arm.urdf\"`";
    chain() "the link at which the robot begins, and its tips: `[\"base_link\", \"tool0\"]`";
    ignored() "`[joint, ...]`, or `rest`";
    ignored_joint() "the name of a joint";
}
