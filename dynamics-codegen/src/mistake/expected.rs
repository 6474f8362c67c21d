//! What was expected where something else stands.

use std::fmt;

use crate::description::Name;
use crate::words::either;

/// What was expected, as it follows the word "expected".
pub(crate) struct Expected(String);

impl fmt::Display for Expected {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.0)
    }
}

fn expected(what: impl Into<String>) -> Expected {
    Expected(what.into())
}

/// The struct item.
pub(crate) fn structure() -> Expected {
    expected("`struct Name;` or `struct Name { field: f64 }`, then the robot's table")
}

pub(crate) fn struct_name() -> Expected {
    expected("the struct's name")
}

pub(crate) fn struct_body(name: &impl fmt::Display) -> Expected {
    expected(format!("`;` or `{{ field: f64 }}` after `struct {name}`"))
}

pub(crate) fn field() -> Expected {
    expected("a field: `name: f64`")
}

pub(crate) fn field_type(name: &impl fmt::Display) -> Expected {
    expected(format!("`f64`, the type of the field `{name}`"))
}

pub(crate) fn comma_after_field(name: &impl fmt::Display) -> Expected {
    expected(format!("`,` after the field `{name}`"))
}

pub(crate) fn attribute() -> Expected {
    expected("an attribute after `#`")
}

/// The separator behind an item, which `what` names.
pub(crate) fn separator(separator: char, what: &str) -> Expected {
    expected(format!("`{separator}` after {what}"))
}

pub(crate) fn colon_after(name: &impl fmt::Display) -> Expected {
    expected(format!("`:` after `{name}`"))
}

/// A key of that kind.
pub(crate) fn key(what: &str, known: &[&str]) -> Expected {
    expected(format!("a {what}: {}", either(known)))
}

/// One of some words.
pub(crate) fn one_of(known: &[&str]) -> Expected {
    expected(either(known))
}

pub(crate) fn let_in_front() -> Expected {
    expected("`let` in front of a name that is bound")
}

pub(crate) fn name_of_constant() -> Expected {
    expected("a name: `let name = value;`")
}

pub(crate) fn name_after_let() -> Expected {
    expected("a name after `let`: `let name = value;`")
}

pub(crate) fn equals_after_let(name: &impl fmt::Display) -> Expected {
    expected(format!("`=` after `let {name}`"))
}

pub(crate) fn rows() -> Expected {
    expected("`[name: revolute { ... }, ...]`")
}

pub(crate) fn locks() -> Expected {
    expected("`[joint = position, ...]`")
}

pub(crate) fn locked_joint() -> Expected {
    expected("the name of a joint: `joint = position`")
}

pub(crate) fn position_after(name: &Name) -> Expected {
    expected(format!("`=` and a position after `{name}`"))
}

pub(crate) fn couplings() -> Expected {
    expected("`[follower = factor * leader + offset, ...]`")
}

pub(crate) fn follower() -> Expected {
    expected("the name of a joint: `follower = factor * leader + offset`")
}

pub(crate) fn leader_after(name: &Name) -> Expected {
    expected(format!(
        "`=` and the joint that it follows after `{name}`: `{name} = factor * leader + offset`"
    ))
}

pub(crate) fn functions() -> Expected {
    expected("`[function, ...]`")
}

pub(crate) fn function() -> Expected {
    expected("the name of a function")
}

pub(crate) fn name_of_tuple() -> Expected {
    expected("a name for the tuple: `name = (function, function)`")
}

pub(crate) fn parts_of(name: &impl fmt::Display) -> Expected {
    expected(format!(
        "the functions of `{name}`: `{name} = (function, function)`"
    ))
}

pub(crate) fn joint() -> Expected {
    expected("a joint: `name: revolute { ... }` or `name: prismatic { ... }`")
}

pub(crate) fn joint_type(name: &impl fmt::Display, known: &[&str]) -> Expected {
    expected(format!("the type of joint `{name}`: {}", either(known)))
}

pub(crate) fn cells(joint: &str) -> Expected {
    expected(format!("the cells of {joint}: `{{ ... }}`"))
}

/// What may be allowed.
pub(crate) fn allowances(known: &[&str]) -> Expected {
    expected(format!("`[...]` with {}", either(known)))
}

pub(crate) fn inertia() -> Expected {
    expected(
        "a tensor of named entries, `{ xx, yy, zz, xy, yz, xz }`, or a solid: \
         `cuboid(x, y, z)`, `cylinder(radius, length)`, `rod(length)` or `sphere(radius)`",
    )
}

/// The axis along which a solid lies.
pub(crate) fn axis() -> Expected {
    expected("`axis = x`, `axis = y` or `axis = z`")
}

/// A solid with its arguments.
pub(crate) fn solid(shown: &str) -> Expected {
    expected(format!("`{shown}`"))
}

/// A part of the table as a call writes it.
pub(crate) fn shape(shape: &str) -> Expected {
    expected(shape)
}

/// A part of the table as a file writes it.
pub(crate) fn of_file(what: &str) -> Expected {
    expected(what)
}

pub(crate) fn number() -> Expected {
    expected("a number")
}

/// Values in brackets.
pub(crate) fn array(shown: &str) -> Expected {
    expected(format!("`{shown}`"))
}

/// The acceleration of gravity.
pub(crate) fn gravity(shown: &str) -> Expected {
    expected(format!(
        "`{shown}`, for example `[0, 0, -9.81]` where z points up"
    ))
}

pub(crate) fn value() -> Expected {
    expected("a value")
}

pub(crate) fn end_of_parentheses() -> Expected {
    expected("one value and `)`")
}

#[cfg(feature = "files")]
pub(crate) fn end_of_text() -> Expected {
    expected("one value")
}

pub(crate) fn file_name() -> Expected {
    expected("the path of a file, from the crate's Cargo.toml on: `\"robots/arm.urdf\"`")
}

pub(crate) fn chain() -> Expected {
    expected("the first and the last link: `[\"base_link\", \"tool0\"]`")
}

pub(crate) fn ignored() -> Expected {
    expected("`[joint, ...]`, or `rest`")
}

pub(crate) fn ignored_joint() -> Expected {
    expected("the name of a joint")
}
