//! Programs as C99, JavaScript, Python, MATLAB and functions of CasADi: the same lines as the Rust method.
//!
//! C has the digits of a Rust build for the same processor. In the other languages products and sums are rounded one by
//! one, and values are those of a Rust build without fused instructions, except for sines and exponentials, which are
//! those of the language's library.

mod arrangement;
mod body;
mod c;
mod casadi;
mod closed_form;
mod comments;
mod javascript;
mod matlab;
mod python;

pub use c::{CNumbers, CSource, c_project, c_source, c_source_in};
pub use casadi::{CasadiSource, casadi_requests, casadi_source};
pub use closed_form::{inverse_in_c, inverse_in_javascript};
pub use comments::description;
pub use javascript::javascript_module;
pub use matlab::matlab_files;
pub use python::{python_module, python_module_name};

use super::documentation;
use super::inputs::{in_order, input_names};
use super::names::{line_names, shown};
use super::pivots::pivots;
use crate::function::{Argument, Request, Sizes, plain};
use crate::robot::Robot;
use body::Angle;

/// Statements for all angles of a function.
type OfAngles = fn(&[Angle]) -> Vec<String>;

/// How a language says what differs between languages.
struct Language {
    /// The statement that gives a number that is computed its name.
    declare: fn(&str, &str) -> String,
    /// How an entry of an argument is read, counted from 0.
    entry: fn(&str, usize) -> String,
    /// The literal of a number.
    number: fn(f64) -> String,
    /// Whether numbers are of single precision.
    is_single: bool,
    /// The operators between two numbers, with the spaces around them.
    times: &'static str,
    over: &'static str,
    /// How a field of the robot is read.
    field: fn(&str) -> String,
    /// The functions of a number.
    sine: &'static str,
    cosine: &'static str,
    /// The statements that give the sines and cosines of all angles their names, where these are evaluated together.
    of_angles: Option<OfAngles>,
    /// The function that multiplies and adds, rounded once where the processor has an instruction for it.
    fused: Option<&'static str>,
    exponential: &'static str,
    sign: &'static str,
    /// The statement that ends a function unless the pivot of a joint is good beside the diagonal entry.
    test_pivot: fn(usize, &str, &str) -> String,
    /// How a call of an own function begins, and the text of that function. One that several calls need follows itself.
    own_functions: &'static [(&'static str, &'static str)],
}

impl Language {
    /// The own functions that some text calls.
    fn called(&self, text: &str) -> String {
        let own_functions = self.own_functions.iter();
        let called = own_functions.filter(|(call, _)| text.contains(call));
        let mut functions: Vec<&str> = called.map(|(_, function)| *function).collect();
        functions.dedup();
        functions.concat()
    }
}

/// The name, changed if it is one of the words, which a language reserves.
fn free_name(name: &str, words: &str) -> String {
    let name = plain(name);
    let is_reserved = words.split_whitespace().any(|word| word == name);
    let mark = if is_reserved { "_" } else { "" };
    format!("{name}{mark}")
}

/// The names of what a function reads: the fields of the arm together, if there are any, and the arguments.
fn argument_names(robot: &Robot, request: &Request) -> Vec<&'static str> {
    let fields = (!robot.fields.is_empty()).then_some("arm");
    let arguments = request.arguments();
    let names = arguments.iter().map(|argument| argument.name());
    fields.into_iter().chain(names).collect()
}

/// The arguments of a function, each with its number of entries.
fn argument_sizes(request: &Request, sizes: Sizes) -> impl Iterator<Item = (Argument, usize)> {
    let arguments = request.arguments().into_iter();
    arguments.map(move |argument| {
        let entries = argument.shape().map_or(0, |shape| shape.entries(sizes));
        (argument, entries)
    })
}

/// The first six pivots of M on a base that moves, in double quotes.
const PIVOTS_OF_BASE: &str =
    "\"base vx\", \"base vy\", \"base vz\", \"base wx\", \"base wy\", \"base wz\"";

/// Functions of a module, in which an error names the pivot of M that failed: those of a base that moves are counted before
/// the joints, by `all`.
fn with_pivots_of_base(robot: &Robot, functions: String, all: &str) -> String {
    match robot.freedoms().has_base() {
        true => functions.replace("JOINT_NAMES[joint]", &format!("{all}[joint]")),
        false => functions,
    }
}

/// Lines of text behind so many spaces each.
fn indented(lines: &[String], spaces: usize) -> String {
    let lines = lines.iter();
    lines
        .map(|line| format!("{:spaces$}{line}\n", ""))
        .collect()
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
        if letter.is_alphanumeric() {
            snake.extend(letter.to_lowercase());
        } else {
            snake.push('_');
        }
    }
    if snake.starts_with(|letter: char| letter.is_ascii_digit()) || snake.is_empty() {
        snake.insert(0, '_');
    }
    snake
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
        assert_eq!(free_name("r#double", "do double"), "double_");
        assert_eq!(free_name("M_PI", c::WORDS), "M_PI_");
    }
}
