//! Functions over columns of states: a loop without branches, which compilers turn into lanes.
//!
//! Sines come first, a column of states at a time, because an angle that has to be reduced in integers would be a branch in
//! the loop. Values have the digits that the function of one state has.

use super::{WORDS, Writer, Written};
use crate::arguments::argument_sizes;
use crate::body::Body;
use crate::comments::comment;
use crate::names::free_name;
use crate::syntax::{Angle, OfAngles, Syntax, indented};
use dynamics_symbolic::function::Request;
use dynamics_symbolic::program::Proven;

/// States whose sines are held at a time.
const BLOCK: usize = 64;

/// The beginnings of the names of functions of the C library.
const LIBRARY: [&str; 3] = [
    "ROBOT_DYNAMICS_SIN",
    "ROBOT_DYNAMICS_COS",
    "ROBOT_DYNAMICS_EXP",
];

/// The sentences about a function that refuses states.
const REFUSAL: &str = "Returns 0; or the number of the first state, counted from 1, that the function of one state refuses. \
                       All values of such a state are NaN.";

impl Writer<'_> {
    pub(super) fn batch_declaration(&self, request: &Request, proven: &Proven) -> String {
        let sizes = proven.sizes(request, self.robot.freedoms());
        let mut lines =
            vec!["The same at `n` states, in columns with one number for each state.".to_owned()];
        for (argument, entries) in argument_sizes(request, sizes) {
            let name = argument.name();
            lines.push(format!(
                "`{name}[i]`: entry i of `{name}`, one of {entries}."
            ));
        }
        for written in self.written(request, proven) {
            lines.push(written.column());
        }
        if request.refuses() {
            lines.push(REFUSAL.to_owned());
        }
        let comment = comment(&lines);
        format!("\n{comment}{};\n", self.batch_signature(request, proven))
    }

    fn batch_signature(&self, request: &Request, proven: &Proven) -> String {
        let (name, word, function) = (&self.name, self.precision.word, request.name());
        let result = if request.refuses() { "size_t" } else { "void" };
        let mut parameters: Vec<String> = Vec::new();
        if !self.robot.fields.is_empty() {
            parameters.push(format!("const {name}_fields *arm"));
        }
        let arguments = request.arguments().into_iter();
        parameters.extend(arguments.map(|x| format!("const {word} *const *{}", x.name())));
        let written = self.written(request, proven).into_iter();
        parameters.extend(written.map(|written| {
            let pointers = if written.dimensions.is_empty() {
                "*"
            } else {
                "*const *"
            };
            format!("{word} {pointers}{}", written.name)
        }));
        parameters.push("size_t n".to_owned());
        format!(
            "ROBOT_DYNAMICS_DEVICE {result} {name}_{function}_batch({})",
            parameters.join(", ")
        )
    }

    pub(super) fn batch(&self, request: &Request, proven: &Proven) -> String {
        let syntax = self.batch_syntax();
        let body = Body::new(self.robot, proven, &syntax);
        let angles = if self.precision.sines.is_some() {
            body.angles()
        } else {
            Vec::new()
        };
        let (of_states, fixed): (Vec<_>, Vec<_>) = angles
            .into_iter()
            .partition(|angle| angle.value.contains("[start + k]"));
        let mut state = self.batch_sines(&of_states);
        state.extend(request.refuses().then(|| "int is_regular = 1;".to_owned()));
        state.extend(body.statements(request));
        state.extend(self.batch_writes(request, proven, &body));
        let mut block = vec![format!(
            "const size_t count = n - start < {BLOCK} ? n - start : {BLOCK};"
        )];
        block.extend(batch_columns(&of_states));
        // A function of the C library has no lanes, and clang would warn that there are none.
        let calls_library = |line: &String| LIBRARY.iter().any(|name| line.contains(name));
        let has_lanes = !state.iter().any(calls_library);
        block.extend(has_lanes.then(|| "ROBOT_DYNAMICS_LANES".to_owned()));
        block.push("for (k = 0; k < count; ++k) {".to_owned());
        block.extend(state.iter().map(|line| format!("    {line}")));
        block.push("}".to_owned());
        if request.refuses() {
            block.push("for (k = 0; first == 0 && refused && k < count; ++k) {".to_owned());
            block.push("    if (!(regular[k] > 0)) first = start + k + 1;".to_owned());
            block.push("}".to_owned());
        }
        let mut lines = self.batch_variables(request, &block, &of_states, &fixed);
        lines.push(format!("for (start = 0; start < n; start += {BLOCK}) {{"));
        lines.extend(block.iter().map(|line| format!("    {line}")));
        lines.push("}".to_owned());
        lines.extend(request.refuses().then(|| "return first;".to_owned()));
        let signature = self.batch_signature(request, proven);
        format!("\n{signature}\n{{\n{}}}\n", indented(&lines, 4))
    }

    /// The lines of one state, in a loop over `k` without branches.
    fn batch_syntax(&self) -> Syntax {
        Syntax {
            entry: |argument, i| format!("{argument}[{i}][start + k]"),
            field: |field| format!("own.{}", free_name(field, WORDS)),
            of_angles: self.precision.sines.map(|_| no_statements as OfAngles),
            test_pivot: |_, pivot, diagonal| {
                format!("is_regular &= robot_dynamics_is_pivot({pivot}, {diagonal});")
            },
            ..self.precision.syntax
        }
    }

    fn batch_variables(
        &self,
        request: &Request,
        block: &[String],
        of_states: &[Angle],
        fixed: &[Angle],
    ) -> Vec<String> {
        let word = self.precision.word;
        let mut lines = Vec::new();
        if !of_states.is_empty() {
            let angles = of_states.len();
            let computed = of_states.iter().any(|angle| column(angle).is_none());
            lines.extend(computed.then(|| format!("{word} angles[{BLOCK}];")));
            lines.push(format!(
                "{word} sines[{angles}][{BLOCK}], cosines[{angles}][{BLOCK}];"
            ));
        }
        if request.refuses() {
            let unsigned = self.precision.unsigned;
            lines.push(format!("{word} regular[{BLOCK}];"));
            lines.push(format!("{unsigned} refused = 0u;"));
            lines.push("size_t first = 0;".to_owned());
        }
        lines.push("size_t start, k;".to_owned());
        let mut reads = block.to_vec();
        if let (Some(sines), false) = (self.precision.sines, fixed.is_empty()) {
            lines.extend(sines.statements(fixed));
            reads.extend(lines.iter().cloned());
        }
        // A copy, which no column can be a part of. For the whole struct at once a compiler would call `memcpy`.
        if reads.iter().any(|line| line.contains("own.")) {
            let fields = self.robot.fields.iter();
            let fields: Vec<_> = fields
                .map(|field| format!("arm->{}", free_name(field, WORDS)))
                .collect();
            let (name, fields) = (&self.name, fields.join(", "));
            lines.insert(0, format!("const {name}_fields own = {{{fields}}};"));
            reads.push("arm->".to_owned());
        }
        let unread = self.unread(request, &reads).into_iter();
        lines.extend(unread.map(|argument| format!("(void){argument};")));
        lines
    }

    /// The sine and the cosine of each angle at a state.
    fn batch_sines(&self, angles: &[Angle]) -> Vec<String> {
        let word = self.precision.word;
        let lines = angles.iter().enumerate().flat_map(|(i, angle)| {
            let named = [("sines", &angle.sine), ("cosines", &angle.cosine)];
            named.map(|(of, name)| {
                let name = name.as_ref()?;
                Some(format!("const {word} {name} = {of}[{i}][k];"))
            })
        });
        lines.flatten().collect()
    }

    /// The statements that write the values of a state, NaN where it is refused.
    fn batch_writes(&self, request: &Request, proven: &Proven, body: &Body<'_>) -> Vec<String> {
        let mut lines = Vec::new();
        let factor = if request.refuses() {
            let one = if self.precision.word == "float" {
                "1.0f"
            } else {
                "1.0"
            };
            lines.push(format!(
                "regular[k] = is_regular ? {one} : robot_dynamics_nan();"
            ));
            lines.push("refused |= !is_regular;".to_owned());
            " * regular[k]"
        } else {
            ""
        };
        let written = self.written(request, proven);
        let places = written.iter().flat_map(Written::columns);
        let values = body.values(request).into_iter().flatten();
        lines.extend(
            places
                .zip(values)
                .map(|(place, value)| format!("{place}[start + k] = {value}{factor};")),
        );
        lines
    }
}

/// The angles are read by columns.
fn no_statements(_: &[Angle]) -> Vec<String> {
    Vec::new()
}

/// The column of an argument that an angle is, from the first state of a block on.
fn column(angle: &Angle) -> Option<String> {
    let column = angle.value.strip_suffix("[start + k]")?;
    let is_plain = column
        .chars()
        .all(|c| c.is_alphanumeric() || "_[]".contains(c));
    is_plain.then(|| format!("&{column}[start]"))
}

/// The statements that evaluate the columns of sines of a block.
fn batch_columns(angles: &[Angle]) -> Vec<String> {
    let mut lines = Vec::new();
    for (i, angle) in angles.iter().enumerate() {
        let column = column(angle).unwrap_or_else(|| {
            let value = &angle.value;
            lines.push(format!("for (k = 0; k < count; ++k) angles[k] = {value};"));
            "angles".to_owned()
        });
        lines.push(format!(
            "robot_dynamics_sin_cos_column({column}, sines[{i}], cosines[{i}], count);"
        ));
    }
    lines
}

impl Written {
    pub(super) fn entries_in_all(&self) -> usize {
        self.dimensions.iter().product()
    }

    /// The column of each entry, by rows.
    fn columns(&self) -> Vec<String> {
        let name = &self.name;
        if self.dimensions.is_empty() {
            return vec![name.clone()];
        }
        let entries = 0..self.entries_in_all();
        entries.map(|i| format!("{name}[{i}]")).collect()
    }

    fn column(&self) -> String {
        let (name, entries) = (&self.name, self.entries_in_all());
        match &self.dimensions[..] {
            [] => format!("`{name}`: the value."),
            [_] => format!("`{name}[i]`: entry i of `{name}`, one of {entries}."),
            [.., columns] => {
                format!("`{name}[i]`: entry i of `{name}` by rows of {columns}, one of {entries}.")
            }
        }
    }
}
