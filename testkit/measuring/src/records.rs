//! Lines that programs write while they measure: kind, arm, function, candidate and numbers, such as
//! `time puma560 mass_matrix generated 23.1`; and remarks behind `#`.

use std::fs;

use crate::median;

/// The lines of many runs.
pub struct Records {
    remarks: Vec<String>,
    lines: Vec<Record>,
}

struct Record {
    /// Kind, arm, function, candidate.
    words: [String; 4],
    numbers: Vec<f64>,
}

impl Records {
    /// Reads a file.
    ///
    /// # Panics
    ///
    /// If there is no such file, or a line of it is another one.
    pub fn read(file: &str) -> Self {
        let text = fs::read_to_string(file).unwrap_or_else(|error| panic!("{file}: {error}"));
        let (remarks, lines): (Vec<&str>, Vec<&str>) =
            text.lines().partition(|line| line.starts_with('#'));
        Records {
            remarks: remarks.iter().map(|line| line[1..].trim().into()).collect(),
            lines: lines.into_iter().map(record).collect(),
        }
    }

    /// The remarks, a line each.
    pub fn remarks(&self) -> String {
        self.remarks.join("\n") + "\n"
    }

    /// The words at one place of the lines of a kind, in the order of their first lines: 1 the arms, 2 the functions,
    /// 3 the candidates.
    pub fn names(&self, kind: &str, place: usize) -> Vec<&str> {
        let mut names: Vec<&str> = Vec::new();
        for record in self.lines.iter().filter(|record| record.words[0] == kind) {
            let name = record.words[place].as_str();
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
    }

    /// The median of the first numbers of all runs.
    pub fn median(&self, words: [&str; 4]) -> Option<f64> {
        let numbers: Vec<f64> = self.of(words).map(|record| record.numbers[0]).collect();
        (!numbers.is_empty()).then(|| median(numbers))
    }

    /// The least of the first numbers of all runs.
    pub fn least(&self, words: [&str; 4]) -> Option<f64> {
        let numbers = self.of(words).map(|record| record.numbers[0]);
        numbers.min_by(f64::total_cmp)
    }

    /// The largest error of a function, and the root of the mean square.
    pub fn errors(&self, arm: &str, function: &str, candidate: &str) -> Option<[f64; 2]> {
        let record = self.of(["error", arm, function, candidate]).next()?;
        Some([record.numbers[0], record.numbers[1]])
    }

    fn of<'a>(&'a self, words: [&'a str; 4]) -> impl Iterator<Item = &'a Record> {
        self.lines
            .iter()
            .filter(move |record| record.words == words)
    }
}

fn record(line: &str) -> Record {
    let mut words = line.split(' ');
    Record {
        words: std::array::from_fn(|_| words.next().expect(line).into()),
        numbers: words.map(|word| word.parse().expect(line)).collect(),
    }
}
