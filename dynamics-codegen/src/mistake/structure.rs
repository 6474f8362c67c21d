//! Mistakes in the struct item.

use std::fmt::Display;

use super::Mistake;

/// A keyword in place of a name. Some of them can be names all the same.
pub(crate) fn keyword(what: &impl Display, word: &impl Display, can_be_raw: bool) -> Mistake {
    let hint = match can_be_raw {
        true => format!(": write `r#{word}`, or another name"),
        false => String::new(),
    };
    Mistake::new(format!("expected {what}, found the keyword `{word}`{hint}"))
}

/// Another struct behind the first one's table.
pub(crate) fn second() -> Mistake {
    Mistake::new("one robot in a call: write a second `robot_dynamics! { ... }` for this struct")
}

pub(crate) fn generic() -> Mistake {
    Mistake::new(
        "the struct has no generic parameters: its fields are `f64`, its methods are generic",
    )
}

pub(crate) fn tuple() -> Mistake {
    Mistake::new("fields need names, by which the table refers to them: `{ name: f64 }`")
}

pub(crate) fn field_without_type(name: &impl Display) -> Mistake {
    Mistake::new(format!(
        "the field `{name}` has no type: write `{name}: f64`"
    ))
}

pub(crate) fn field_with_cfg() -> Mistake {
    Mistake::new("a field that the table refers to cannot be switched off by `cfg`")
}

pub(crate) fn field_of_other_type(name: &impl Display) -> Mistake {
    Mistake::new(format!(
        "the field `{name}` is an `f64`, as every field of a robot"
    ))
}

pub(crate) fn field_with_default(name: &impl Display) -> Mistake {
    Mistake::new(format!(
        "a field has no default: `{name}` gets its value where the struct is built"
    ))
}

pub(crate) fn unused_field(name: &str) -> Mistake {
    Mistake::new(format!("no value uses the field `{name}`"))
}
