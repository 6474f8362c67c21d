//! Mistakes in the struct item.

use std::fmt::Display;

use super::Mistake;

mistakes! {
    /// Another struct behind the first one's table.
    second() "one robot in a call: write a second `robot_dynamics! {{ ... }}` for this struct";
    generic() "the struct has no generic parameters: its fields are `f64`, its methods are generic";
    tuple() "fields need names, by which the table refers to them: `{{ name: f64 }}`";
    field_without_type(name: &impl Display) "the field `{name}` has no type: write `{name}: f64`";
    field_with_cfg() "a field that the table refers to cannot be switched off by `cfg`";
    field_of_other_type(name: &impl Display) "the field `{name}` is an `f64`, as every field of a robot";
    field_with_default(name: &impl Display)
        "a field has no default: `{name}` gets its value where the struct is built";
    unused_field(name: &str) "the field `{name}` is never used";
    /// A keyword in place of a name. Some of them can be names all the same.
    keyword(what: &impl Display, word: &impl Display, can_be_raw: bool)
        "expected {what}, found the keyword `{word}`: write `r#{word}`, or another name" if can_be_raw
        else "expected {what}, found the keyword `{word}`";
}
