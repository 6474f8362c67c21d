//! The functions by which CasADi asks a function what it takes and gives.

use crate::syntax::indented;

/// Rows and columns.
pub(super) type Size = (usize, usize);

/// An input, or the place of an output among the inputs of a derivative, which has no entries.
pub(super) struct Input {
    pub(super) name: String,
    pub(super) size: Size,
    pub(super) is_empty: bool,
}

/// An output.
pub(super) struct Output {
    pub(super) name: String,
    pub(super) size: Size,
    pub(super) values: Values,
}

/// The values of a matrix.
pub(super) enum Values {
    /// By columns: no text where one is zero always.
    Entries(Vec<Option<String>>),
    /// Not known: NaN everywhere.
    Unknown,
}

/// Patterns of entries in compressed column storage, each once.
#[derive(Default)]
pub(super) struct Patterns(Vec<Vec<usize>>);

impl Patterns {
    /// The place of a pattern, which is a new one or known.
    fn place(&mut self, pattern: Vec<usize>) -> usize {
        let known = self.0.iter().position(|known| *known == pattern);
        known.unwrap_or_else(|| {
            self.0.push(pattern);
            self.0.len() - 1
        })
    }

    /// The arrays of all patterns.
    pub(super) fn text(&self) -> String {
        let patterns = self.0.iter().enumerate();
        let array = |(place, pattern): (usize, &Vec<usize>)| {
            let numbers: Vec<_> = pattern.iter().map(usize::to_string).collect();
            let (count, numbers) = (numbers.len(), numbers.join(", "));
            format!(
                "static const long long int robot_dynamics_pattern_{place}[{count}] = {{{numbers}}};\n"
            )
        };
        patterns.map(array).collect()
    }
}

impl Input {
    fn pattern(&self) -> Vec<usize> {
        pattern(self.size, |_, _| !self.is_empty)
    }
}

impl Output {
    /// A matrix of the values that are found for rows and columns.
    pub(super) fn new(
        name: String,
        size: Size,
        value: impl Fn(usize, usize) -> Option<String>,
    ) -> Self {
        let (rows, columns) = size;
        let places = (0..columns).flat_map(|column| (0..rows).map(move |row| (row, column)));
        let entries = places.map(|(row, column)| value(row, column));
        let values = Values::Entries(entries.collect());
        Output { name, size, values }
    }

    /// A matrix of which nothing is known.
    pub(super) fn unknown(name: String, size: Size) -> Self {
        let values = Values::Unknown;
        Output { name, size, values }
    }

    /// The values by columns; none of a matrix of which nothing is known.
    pub(super) fn entries(&self) -> impl Iterator<Item = &Option<String>> {
        let entries = match &self.values {
            Values::Unknown => &[][..],
            Values::Entries(entries) => entries,
        };
        entries.iter()
    }

    /// The same by the name of the matrix, in which only values that are there have a place.
    pub(super) fn places(&self) -> Vec<Option<String>> {
        let mut count = 0;
        let places = self.entries().map(|entry| {
            entry.as_ref()?;
            count += 1;
            Some(format!("{}[{}]", self.name, count - 1))
        });
        places.collect()
    }

    pub(super) fn is_unknown(&self) -> bool {
        matches!(self.values, Values::Unknown)
    }

    fn pattern(&self) -> Vec<usize> {
        match &self.values {
            Values::Unknown => pattern(self.size, |_, _| true),
            Values::Entries(entries) => pattern(self.size, |row, column| {
                entries[column * self.size.0 + row].is_some()
            }),
        }
    }
}

/// Rows, columns and 1 of a full matrix; else rows, columns, where each column starts, and the row of each entry.
fn pattern((rows, columns): Size, is_there: impl Fn(usize, usize) -> bool) -> Vec<usize> {
    let mut starts = vec![0];
    let mut places = Vec::new();
    for column in 0..columns {
        places.extend((0..rows).filter(|&row| is_there(row, column)));
        starts.push(places.len());
    }
    if !places.is_empty() && places.len() == rows * columns {
        return vec![rows, columns, 1];
    }
    [vec![rows, columns], starts, places].concat()
}

/// The interface of a function of that name, which needs room for so many numbers.
pub(super) fn interface(
    name: &str,
    inputs: &[Input],
    outputs: &[Output],
    room: usize,
    patterns: &mut Patterns,
) -> String {
    let mut pattern =
        |pattern: Vec<usize>| format!("robot_dynamics_pattern_{}", patterns.place(pattern));
    let string = |name: &String| format!("\"{name}\"");
    let names_in = inputs.iter().map(|input| string(&input.name)).collect();
    let names_out = outputs.iter().map(|output| string(&output.name)).collect();
    let patterns_in = inputs.iter().map(|input| pattern(input.pattern()));
    let patterns_in = patterns_in.collect();
    let patterns_out = outputs.iter().map(|output| pattern(output.pattern()));
    let patterns_out = patterns_out.collect();
    let (count_in, count_out) = (inputs.len(), outputs.len());
    let export = "CASADI_SYMBOL_EXPORT";
    let (text, numbers) = ("const char *", "const long long int *");
    let asked = |result, question, answers| choice(result, &format!("{name}_{question}"), answers);
    [
        format!("\n{export} long long int {name}_n_in(void) {{ return {count_in}; }}\n"),
        format!("\n{export} long long int {name}_n_out(void) {{ return {count_out}; }}\n"),
        asked(text, "name_in", names_in),
        asked(text, "name_out", names_out),
        asked(numbers, "sparsity_in", patterns_in),
        asked(numbers, "sparsity_out", patterns_out),
        work(name, count_in, count_out, room),
    ]
    .concat()
}

/// A function that answers for each place, and with 0 beyond.
fn choice(result: &str, name: &str, answers: Vec<String>) -> String {
    let cases = answers.iter().enumerate();
    let mut cases: Vec<_> = cases
        .map(|(place, answer)| format!("case {place}: return {answer};"))
        .collect();
    cases.push("default: return 0;".to_owned());
    let cases = indented(&cases, 4);
    format!(
        "\nCASADI_SYMBOL_EXPORT {result}{name}(long long int i)\n{{\n    switch (i) {{\n{cases}    }}\n}}\n"
    )
}

/// The room that a function needs, beside pointers to inputs and outputs.
fn work(name: &str, count_in: usize, count_out: usize, room: usize) -> String {
    let lines = [
        format!("if (sz_arg) *sz_arg = {count_in};"),
        format!("if (sz_res) *sz_res = {count_out};"),
        "if (sz_iw) *sz_iw = 0;".to_owned(),
        format!("if (sz_w) *sz_w = {room};"),
        "return 0;".to_owned(),
    ];
    let int = "long long int *";
    format!(
        "\nCASADI_SYMBOL_EXPORT int {name}_work({int}sz_arg, {int}sz_res, {int}sz_iw, {int}sz_w)\n{{\n{}}}\n",
        indented(&lines, 4)
    )
}
