//! The same functions in C++, with arrays of the standard library: a header over that of C.

use super::{WORDS, Writer, Written, is_number};
use crate::arguments::argument_sizes;
use crate::comments::comment;
use crate::names::free_name;
use crate::syntax::indented;
use dynamics_symbolic::bounds::rounding;
use dynamics_symbolic::function::Request;
use dynamics_symbolic::program::Proven;

impl Writer<'_> {
    /// The text of `NAME.hpp`.
    pub(super) fn cpp(&self, functions: &[(Request, Proven)]) -> String {
        let (name, upper) = (&self.name, self.name.to_uppercase());
        let space = free_name(name, WORDS);
        let title = comment(&[
            format!("The functions of `{name}.h` in C++ (from C++11 on), documented there."),
            String::new(),
            "A function returns its value, or it writes into its last arguments: where it may refuse a state it returns 0 or"
                .to_owned(),
            "the number of a joint, as in C. Matrices are arrays of rows.".to_owned(),
        ]);
        let functions = functions.iter();
        let functions: String = functions
            .map(|(request, proven)| self.cpp_function(request, proven))
            .collect();
        let fields = if self.robot.fields.is_empty() {
            String::new()
        } else {
            format!("\nusing fields = ::{name}_fields;\n")
        };
        format!(
            "{title}#ifndef {upper}_HPP\n#define {upper}_HPP\n\n#include <array>\n\n#include \"{name}.h\"\n\n\
             namespace {space} {{\n{fields}{functions}\n}}\n\n#endif\n"
        )
    }

    fn cpp_function(&self, request: &Request, proven: &Proven) -> String {
        let (name, word, function) = (&self.name, self.precision.word, request.name());
        let sizes = proven.sizes(request, self.robot.freedoms());
        let written = self.written(request, proven);
        let (mut parameters, mut arguments) = (Vec::new(), Vec::new());
        if !self.robot.fields.is_empty() {
            parameters.push("const fields &arm".to_owned());
            arguments.push("&arm".to_owned());
        }
        for (argument, entries) in argument_sizes(request, sizes) {
            let argument = argument.name();
            parameters.push(format!("const std::array<{word}, {entries}> &{argument}"));
            arguments.push(format!("{argument}.data()"));
        }
        if !is_number(request) {
            arguments.extend(written.iter().map(|written| written.in_cpp(word)));
        }
        let call = |arguments: &[String]| format!("::{name}_{function}({})", arguments.join(", "));
        let (result, lines) = match &written[..] {
            _ if is_number(request) => (
                word.to_owned(),
                vec![format!("return {};", call(&arguments))],
            ),
            [one] if !request.refuses() => {
                let value = format!("{} {};", one.cpp_type(word), one.name);
                let lines = vec![
                    value,
                    format!("{};", call(&arguments)),
                    format!("return {};", one.name),
                ];
                (one.cpp_type(word), lines)
            }
            several => {
                let references = several.iter();
                parameters
                    .extend(references.map(|one| format!("{} &{}", one.cpp_type(word), one.name)));
                match request.refuses() {
                    true => (
                        "int".to_owned(),
                        vec![format!("return {};", call(&arguments))],
                    ),
                    false => ("void".to_owned(), vec![format!("{};", call(&arguments))]),
                }
            }
        };
        let rounding = rounding(self.robot, request, proven);
        let rounding = rounding.map(|rounding| comment(&[rounding.line()]));
        format!(
            "\n{}inline {result} {function}({})\n{{\n{}}}\n",
            rounding.unwrap_or_default(),
            parameters.join(", "),
            indented(&lines, 4)
        )
    }
}

impl Written {
    fn cpp_type(&self, word: &str) -> String {
        let sizes = self.dimensions.iter().rev();
        sizes.fold(word.to_owned(), |inner, size| {
            format!("std::array<{inner}, {size}>")
        })
    }

    /// The place as C takes it: arrays of arrays lie as those of C.
    fn in_cpp(&self, word: &str) -> String {
        let name = &self.name;
        match &self.dimensions[..] {
            [] => format!("&{name}"),
            [_] => format!("{name}.data()"),
            [_, inner @ ..] => {
                let inner: String = inner.iter().map(|size| format!("[{size}]")).collect();
                format!("reinterpret_cast<{word} (*){inner}>({name}.data())")
            }
        }
    }
}
