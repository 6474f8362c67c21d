//! The lines that the programs print: `time ARM FUNCTION CANDIDATE NS` and
//! `error ARM FUNCTION CANDIDATE LARGEST RMS`, many runs of each, and remarks behind `#`.

use std::fs;

pub(crate) struct Records {
    remarks: Vec<String>,
    lines: Vec<Record>,
}

struct Record {
    /// Kind, arm, function, candidate.
    words: [String; 4],
    numbers: Vec<f64>,
}

impl Records {
    pub(crate) fn read(file: &str) -> Self {
        let text = fs::read_to_string(file).unwrap_or_else(|error| panic!("{file}: {error}"));
        let (remarks, lines): (Vec<&str>, Vec<&str>) =
            text.lines().partition(|line| line.starts_with('#'));
        Records {
            remarks: remarks.iter().map(|line| line[1..].trim().into()).collect(),
            lines: lines.into_iter().map(record).collect(),
        }
    }

    pub(crate) fn remarks(&self) -> String {
        self.remarks.join("\n") + "\n"
    }

    /// The candidates, in the order of their first lines.
    pub(crate) fn candidates(&self) -> Vec<&str> {
        let mut names: Vec<&str> = Vec::new();
        for record in &self.lines {
            let name = record.words[3].as_str();
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
    }

    /// The median time of all runs, ns.
    pub(crate) fn time(&self, arm: &str, function: &str, candidate: &str) -> Option<f64> {
        let mut times: Vec<f64> = self
            .of(["time", arm, function, candidate])
            .map(|record| record.numbers[0])
            .collect();
        times.sort_by(f64::total_cmp);
        times.get(times.len() / 2).copied()
    }

    /// The largest error and the root of the mean square.
    pub(crate) fn errors(&self, arm: &str, function: &str, candidate: &str) -> Option<[f64; 2]> {
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
