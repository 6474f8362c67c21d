//! One function of the file: what it reads of its inputs, its lines, and the outputs that it writes.

use super::calls::Calls;
use super::interface::{Input, Output, Values, interface};
use super::{FIELDS, File, Of, ZEROS};
use crate::arguments::argument_sizes;
use crate::c::reads_name;
use crate::comments::comment;
use crate::syntax::indented;

impl File<'_> {
    /// The statements by which the weights are found among the inputs.
    pub(super) fn weights(&mut self, inputs: &[Input]) -> Vec<String> {
        let weights = inputs.iter().enumerate();
        let weights = weights.filter(|(_, input)| input.name.starts_with("adj_"));
        let mut statements = Vec::new();
        for (place, Input { name, size, .. }) in weights {
            self.longest = self.longest.max(size.0 * size.1);
            statements.push(format!("const double *{name} = {};", read(place)));
        }
        statements
    }

    /// A function of that name whose values are those of a program.
    pub(super) fn function(
        &mut self,
        name: &str,
        documentation: &[String],
        program: Of<'_>,
        inputs: &[Input],
        outputs: &[Output],
    ) -> String {
        let (request, _) = program;
        let statements = self.body(program).statements(request);
        let values = outputs.iter().flat_map(Output::entries).flatten();
        let texts: Vec<_> = statements.iter().chain(values).cloned().collect();
        let mut lines = self.reads(program, inputs, &texts, &Calls::default());
        lines.extend(statements);
        self.defined(name, documentation, lines, inputs, outputs, 0)
    }

    /// A function of that name with these lines before its outputs are written, and room for so many numbers.
    pub(super) fn defined(
        &mut self,
        name: &str,
        documentation: &[String],
        mut lines: Vec<String>,
        inputs: &[Input],
        outputs: &[Output],
        room: usize,
    ) -> String {
        for (place, output) in outputs.iter().enumerate() {
            lines.extend(written(place, output));
        }
        lines.push("return 0;".to_owned());
        let shown = signature(inputs, outputs);
        let documentation = [documentation, &[String::new(), shown]].concat();
        let body = format!(
            "\n{}CASADI_SYMBOL_EXPORT int {name}(const double **arg, double **res, long long int *iw, double *w, int mem)\n{{\n{}}}\n",
            comment(&documentation),
            indented(&lines, 4)
        );
        body + &interface(name, inputs, outputs, room, &mut self.patterns)
    }

    /// The statements by which what texts of a program read is found among the inputs, unless calls give it; zeros where
    /// an input is not there.
    pub(super) fn reads(
        &mut self,
        program: Of<'_>,
        inputs: &[Input],
        texts: &[String],
        calls: &Calls,
    ) -> Vec<String> {
        let (request, proven) = program;
        let sizes = proven.sizes(request, self.robot.freedoms());
        let arguments = argument_sizes(request, sizes);
        let arguments: Vec<_> = arguments
            .map(|(argument, size)| (argument.name(), size))
            .collect();
        let is_read = |read: &str| texts.iter().any(|text| reads_name(text, read));
        let pointer = |name: &str| {
            let place = inputs.iter().position(|input| input.name == name);
            place.map_or(ZEROS.to_owned(), read)
        };
        let mut lines = Vec::new();
        if is_read(&format!("{FIELDS}->")) {
            let count = self.robot.fields.len();
            let entries: Vec<_> = (0..count).map(|i| format!("entries[{i}]")).collect();
            self.longest = self.longest.max(count);
            lines.push(format!("const double *entries = {};", pointer(FIELDS)));
            lines.push(format!(
                "const robot_dynamics_fields fields = {{{}}};",
                entries.join(", ")
            ));
            lines.push(format!("const robot_dynamics_fields *{FIELDS} = &fields;"));
        }
        for (name, size) in arguments {
            if is_read(&format!("{name}[")) && !calls.has(name) {
                self.longest = self.longest.max(size);
                lines.push(format!("const double *{name} = {};", pointer(name)));
            }
        }
        let unread = if lines.is_empty() { "(void)arg; " } else { "" };
        lines.push(format!("{unread}(void)res; (void)iw; (void)w; (void)mem;"));
        lines
    }
}

/// Inputs and outputs with their sizes.
fn signature(inputs: &[Input], outputs: &[Output]) -> String {
    let sized = |name: &str, (rows, columns): (usize, usize)| match columns {
        1 => format!("{name}[{rows}]"),
        _ => format!("{name}[{rows} x {columns}]"),
    };
    let inputs = inputs.iter().filter(|input| !input.is_empty);
    let inputs: Vec<_> = inputs.map(|input| sized(&input.name, input.size)).collect();
    let outputs = outputs
        .iter()
        .map(|output| sized(&output.name, output.size));
    let outputs: Vec<_> = outputs.collect();
    format!("({}) -> ({})", inputs.join(", "), outputs.join(", "))
}

/// The pointer to an input.
fn read(place: usize) -> String {
    format!("arg[{place}] ? arg[{place}] : {ZEROS}")
}

/// The statements that write an output where it is requested.
fn written(place: usize, output: &Output) -> Vec<String> {
    let entries = match &output.values {
        Values::Unknown => {
            let (rows, columns) = output.size;
            let count = rows * columns;
            return vec![format!(
                "if (res[{place}]) robot_dynamics_unknown(res[{place}], {count});"
            )];
        }
        Values::Entries(entries) => entries.iter().flatten(),
    };
    let values = entries.enumerate();
    let mut lines: Vec<_> = values
        .map(|(entry, value)| format!("    res[{place}][{entry}] = {value};"))
        .collect();
    if !lines.is_empty() {
        lines.insert(0, format!("if (res[{place}]) {{"));
        lines.push("}".to_owned());
    }
    lines
}
