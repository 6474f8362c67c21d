//! Rows of numbers, separated by commas.

use std::fmt::Write as _;
use std::path::Path;

use dynamics_codegen::description::Place;
use dynamics_codegen::files;

use crate::failure::Failure;

/// Bytes of a file that is read: 100,000 rows of seven joints have some 15 million.
const MOST_BYTES: usize = 100_000_000;

/// A table that is being written: a header, and rows of numbers that read back as the same ones.
pub(crate) struct Csv(String);

impl Csv {
    /// With names of columns: `time` by itself, and each of the others for every joint.
    pub(crate) fn new<'n>(
        time: &str,
        quantities: &[&str],
        joints: impl Iterator<Item = &'n str>,
    ) -> Self {
        let joints: Vec<_> = joints.map(field).collect();
        let mut text = time.to_owned();
        for quantity in quantities {
            for joint in &joints {
                let _ = write!(text, ",{quantity}_{joint}");
            }
        }
        text.push('\n');
        Csv(text)
    }

    /// The table with another column.
    pub(crate) fn with(mut self, column: &str) -> Self {
        self.0.pop();
        let _ = writeln!(self.0, ",{column}");
        self
    }

    /// Adds a row, which begins with a time. A number that is not finite is a failure, which says when and of which joint.
    pub(crate) fn row(&mut self, numbers: impl IntoIterator<Item = f64>) -> Result<(), Failure> {
        let numbers: Vec<f64> = numbers.into_iter().collect();
        if let Some(column) = numbers.iter().position(|x| !x.is_finite()) {
            let names = self.0.lines().next().unwrap_or_default();
            let message = format!(
                "`{}` at t = {} s is beyond the largest number that a computer holds: the motion is too fast, its \
                 positions are too large, or the numbers of the robot are",
                names.split(',').nth(column).unwrap_or_default(),
                shortest(numbers[0])
            );
            return Err(Failure::after(String::new(), message));
        }
        let numbers: Vec<_> = numbers.into_iter().map(shortest).collect();
        self.0.push_str(&numbers.join(","));
        self.0.push('\n');
        Ok(())
    }

    /// The text.
    pub(crate) fn text(self) -> String {
        self.0
    }
}

/// A number in as few letters as it takes: `0.5`, `1e-17`.
pub(crate) fn shortest(x: f64) -> String {
    let (decimal, scientific) = (x.to_string(), format!("{x:e}"));
    match decimal.len() <= scientific.len() {
        true => decimal,
        false => scientific,
    }
}

/// So many numbers.
pub(crate) fn numbers(count: usize) -> String {
    match count {
        1 => "1 number".to_owned(),
        _ => format!("{count} numbers"),
    }
}

/// The name of a joint as a part of a name of a column: what parts columns and lines is left out.
fn field(name: &str) -> String {
    let is_separator = |letter: char| letter.is_control() || ",\";".contains(letter);
    name.replace(is_separator, "_")
}

/// A word of a row, in quotes or without them.
fn unquoted(word: &str) -> &str {
    word.trim().trim_matches('"')
}

/// Which word of a header names another joint than the one whose positions stand there, and both of them.
fn misplaced<'j>(words: &[&str], joints: &[&'j str]) -> Option<(usize, &'j str, &'j str)> {
    let is_of = |word: &str, joint: &str| {
        let word = unquoted(word);
        let name = field(joint);
        word == name || word.strip_prefix("q_") == Some(&name)
    };
    let columns = words.iter().skip(1).zip(joints).enumerate();
    columns
        .filter(|(_, (word, joint))| !is_of(word, joint))
        .find_map(|(index, (word, expected))| {
            let found = joints.iter().find(|joint| is_of(word, joint))?;
            Some((index + 1, *found, *expected))
        })
}

/// The rows of a file, each of a time and a position of every joint; a first row of words is passed over, unless it
/// has the joints in another order.
pub(crate) fn read(path: &Path, joints: &[&str]) -> Result<Vec<Vec<f64>>, Failure> {
    let columns = joints.len() + 1;
    let wrong = |line: usize, column: usize, message: String| {
        Failure::after(
            String::new(),
            format!("{}:{line}:{column}: {message}", path.display()),
        )
    };
    let bytes = files::bytes_of_any(path, MOST_BYTES)
        .map_err(|error| wrong(1, 1, format!("cannot be read: {error}")))?;
    let text = files::text(bytes).map_err(|error| match error.place {
        Place::File { line, column } => wrong(line, column, error.message),
        Place::Tokens { .. } => wrong(1, 1, error.message),
    })?;
    let mut rows: Vec<Vec<f64>> = Vec::new();
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
    for (index, line) in text.lines().enumerate() {
        let words: Vec<_> = line.split(',').collect();
        let is_header = index == 0
            && words
                .iter()
                .all(|word| unquoted(word).parse::<f64>().is_err());
        let misplaced = misplaced(&words, joints).filter(|_| is_header);
        if let Some((word, found, expected)) = misplaced {
            let before = words[..word].iter().map(|word| word.chars().count() + 1);
            let message = format!(
                "a column of `{found}`, expected one of `{expected}`: columns are in the order of the joints"
            );
            return Err(wrong(index + 1, 1 + before.sum::<usize>(), message));
        }
        if line.trim().is_empty() || is_header {
            continue;
        }
        if words.len() != columns {
            let message = format!(
                "found {}, expected {columns} separated by commas: a time, and a position of each joint",
                numbers(words.len())
            );
            return Err(wrong(index + 1, 1, message));
        }
        let mut column = 1;
        let mut row = Vec::with_capacity(columns);
        for word in words {
            match unquoted(word).parse::<f64>() {
                Ok(x) if x.is_finite() => row.push(x),
                _ => {
                    return Err(wrong(
                        index + 1,
                        column,
                        format!("`{}`: expected a number", word.trim()),
                    ));
                }
            }
            column += word.chars().count() + 1;
        }
        if rows.last().is_some_and(|last| last[0] >= row[0]) {
            return Err(wrong(
                index + 1,
                1,
                "times must grow from row to row".to_owned(),
            ));
        }
        rows.push(row);
    }
    match rows.len() {
        0 | 1 => Err(wrong(
            1,
            1,
            "expected two rows of numbers or more".to_owned(),
        )),
        _ => Ok(rows),
    }
}
