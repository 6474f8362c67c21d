//! Programs as C99 and as JavaScript: the same lines as the Rust method, without a dependency.
//!
//! Products and sums are rounded one by one: where a compiler does not fuse them by itself, values are
//! those of a Rust build without fused instructions, but for sines and exponentials, which are those of
//! the language's library.

mod body;
mod c;
mod comments;
mod javascript;

pub use c::{CSource, c_source};
pub use comments::description;
pub use javascript::javascript_module;

use super::inputs::{input_name, place};
use super::names::plain;
use super::{documentation, parameters};

/// How a language says what differs between C and JavaScript.
struct Language {
    /// What stands in front of the name of a number that is computed.
    declaration: &'static str,
    /// How a field of the robot is read.
    field: fn(&str) -> String,
    /// The functions of a number.
    sine: &'static str,
    cosine: &'static str,
    exponential: &'static str,
    sign: &'static str,
}

/// The name, changed if it is a reserved word of the language.
fn free_name(name: &str, words: &[&str]) -> String {
    let name = plain(name);
    match words.contains(&name) {
        true => format!("{name}_"),
        false => name.to_owned(),
    }
}

/// A name in the letters of a variable and of a file: `TwoLink` as `two_link`.
pub fn snake_case(name: &str) -> String {
    let mut snake = String::new();
    let mut after_lower = false;
    for letter in plain(name).chars() {
        if letter.is_uppercase() && after_lower {
            snake.push('_');
        }
        after_lower = letter.is_lowercase() || letter.is_ascii_digit();
        match letter.is_alphanumeric() || letter == '_' {
            true => snake.extend(letter.to_lowercase()),
            false => snake.push('_'),
        }
    }
    match snake.starts_with(|letter: char| letter.is_ascii_digit()) || snake.is_empty() {
        true => format!("_{snake}"),
        false => snake,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_c() {
        assert_eq!(snake_case("TwoLink"), "two_link");
        assert_eq!(snake_case("Puma560"), "puma560");
        assert_eq!(snake_case("UR5e"), "ur5e");
        assert_eq!(snake_case("my arm.2"), "my_arm_2");
        assert_eq!(snake_case("7bot"), "_7bot");
        assert_eq!(free_name("r#double", &["double"]), "double_");
    }
}
