//! A file for CMake, and a program that tests what a compiler has made of the source.

use core::fmt::Write as _;

use super::{Writer, Written, is_number};
use crate::arguments::argument_sizes;
use crate::syntax::indented;
use dynamics_symbolic::function::Request;
use dynamics_symbolic::program::Proven;

/// States of the test: more than a block of them, and no whole number of lanes.
const STATES: usize = 131;

impl Writer<'_> {
    /// The text of `CMakeLists.txt`.
    pub(super) fn cmake(&self) -> String {
        let name = &self.name;
        let text = include_str!("CMakeLists.txt").replace("NAME", name);
        // The keyword of CMake.
        text.replace("UPPER", &name.to_uppercase())
            .replace('@', "NAME")
    }

    /// The text of `NAME_test.c`.
    pub(super) fn test(&self, functions: &[(Request, Proven)]) -> String {
        let (name, word) = (&self.name, self.precision.word);
        let mut text = include_str!("test.c")
            .replace("NAME", name)
            .replace("REAL", word);
        text = text.replace("STATES", &STATES.to_string());
        for (request, proven) in functions {
            text.push_str(&self.test_of(request, proven));
        }
        text.push_str("\nint main(void)\n{\n    int failures = 0;\n");
        if !self.robot.fields.is_empty() {
            let ones = vec!["1"; self.robot.fields.len()].join(", ");
            let _ = writeln!(text, "    const {name}_fields arm = {{{ones}}};");
        }
        let arm = if self.robot.fields.is_empty() {
            ""
        } else {
            "&arm"
        };
        for (request, _) in functions {
            let _ = writeln!(text, "    failures += test_{}({arm});", request.name());
        }
        text + "    return failures != 0;\n}\n"
    }

    /// A function that compares a batch with single calls, to the last bit.
    fn test_of(&self, request: &Request, proven: &Proven) -> String {
        let (name, word, function) = (&self.name, self.precision.word, request.name());
        let sizes = proven.sizes(request, self.robot.freedoms());
        let fields = !self.robot.fields.is_empty();
        let (mut one, mut all): (Vec<String>, Vec<String>) = (Vec::new(), Vec::new());
        let parameter = if fields {
            one.push("arm".to_owned());
            all.push("arm".to_owned());
            format!("const {name}_fields *arm")
        } else {
            "void".to_owned()
        };
        let mut lines = Vec::new();
        let mut gather = Vec::new();
        for (argument, entries) in argument_sizes(request, sizes) {
            let argument = argument.name();
            // No array of C is without entries.
            let size = entries.max(1);
            lines.push(format!(
                "static {word} {argument}_columns[{size}][{STATES}];"
            ));
            lines.push(format!("const {word} *{argument}_all[{size}];"));
            lines.push(format!("{word} {argument}[{size}];"));
            gather.push(format!(
                "fill(&{argument}_columns[0][0], {argument}_all, {entries});"
            ));
            one.push(argument.to_owned());
            all.push(format!("{argument}_all"));
        }
        let mut compared = Vec::new();
        for written in self.written(request, proven) {
            let (value, entries) = (&written.name, written.entries_in_all());
            lines.push(format!(
                "static {word} {value}_columns[{entries}][{STATES}];"
            ));
            lines.push(format!("{word} *{value}_all[{entries}];"));
            lines.push(format!("{word} {value}_value{};", written.sizes()));
            gather.push(format!(
                "place(&{value}_columns[0][0], {value}_all, {entries});"
            ));
            let star = if written.dimensions.is_empty() {
                "*"
            } else {
                ""
            };
            let first = if written.dimensions.is_empty() {
                "&"
            } else {
                ""
            };
            one.extend((!is_number(request)).then(|| format!("{first}{value}_value")));
            all.push(format!("{star}{value}_all"));
            compared.push((
                value.clone(),
                format!("(const {word} *){first}{value}_value"),
                entries,
            ));
        }
        all.push(STATES.to_string());
        let call = format!("{name}_{function}({})", one.join(", "));
        lines.push("int k, failures = 0;".to_owned());
        lines.extend(gather);
        lines.push(format!("{name}_{function}_batch({});", all.join(", ")));
        lines.push(format!("for (k = 0; k < {STATES}; ++k) {{"));
        for (argument, entries) in argument_sizes(request, sizes) {
            let argument = argument.name();
            lines.push(format!(
                "    pick({argument}_all, {entries}, k, {argument});"
            ));
        }
        lines.push(match (is_number(request), request.refuses()) {
            (true, _) => format!("    {function}_value = {call};"),
            (_, true) => format!("    if ({call} != 0) continue;"),
            _ => format!("    {call};"),
        });
        for (value, place, entries) in &compared {
            lines.push(format!(
                "    failures += differ({place}, {value}_all, {entries}, k);"
            ));
        }
        lines.push("}".to_owned());
        lines.push(format!("return report(\"{function}\", failures);"));
        format!(
            "\nstatic int test_{function}({parameter})\n{{\n{}}}\n",
            indented(&lines, 4)
        )
    }
}

impl Written {
    /// The sizes of the array.
    fn sizes(&self) -> String {
        self.dimensions
            .iter()
            .map(|size| format!("[{size}]"))
            .collect()
    }
}
