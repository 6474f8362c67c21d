//! The rows of a table as they are read: cells by their places, and the mistakes of a header.

use super::columns::{QUANTITIES, of_base};
use super::mistake::{CsvError, CsvMistake};

/// The rows of a text.
pub(super) struct Rows<'t> {
    pub(super) text: &'t str,
    pub(super) reader: csv::Reader<&'t [u8]>,
    pub(super) row: csv::StringRecord,
}

impl<'t> Rows<'t> {
    pub(super) fn new(text: &'t str) -> Self {
        let mut settings = csv::ReaderBuilder::new();
        settings
            .has_headers(false)
            .flexible(true)
            .trim(csv::Trim::All);
        Rows {
            text,
            reader: settings.from_reader(text.as_bytes()),
            row: csv::StringRecord::new(),
        }
    }

    /// Goes on to the next row that is not empty; whether there is one.
    pub(super) fn advance(&mut self) -> bool {
        // A text in memory can be read to its end.
        while self.reader.read_record(&mut self.row).unwrap_or(false) {
            if self.row.len() > 1 || !self.row[0].is_empty() {
                return true;
            }
        }
        false
    }

    /// A mistake in a cell, counted from 0.
    ///
    /// The reader tells the byte at which a row begins, or the end of the line before or an empty line before. The lines
    /// that it counts are others where lines end in `\r\n` or are empty.
    pub(super) fn mistake(&self, cell: usize, mistake: CsvMistake) -> CsvError {
        let byte = self.row.position().map_or(0, |place| place.byte() as usize);
        let rest = self.text[byte..].trim_start_matches(['\r', '\n']);
        let before = &self.text[..self.text.len() - rest.len()];
        let row = rest.lines().next().unwrap_or_default();
        let mut is_quoted = false;
        let mut ends = row.chars().enumerate().filter(|(_, letter)| {
            is_quoted ^= *letter == '"';
            *letter == ',' && !is_quoted
        });
        let end_before = cell.checked_sub(1).map(|end| ends.nth(end));
        CsvError {
            line: 1 + before.matches('\n').count(),
            column: cell + 1,
            letter: end_before.map_or(1, |end| {
                end.map_or_else(|| row.chars().count() + 1, |(comma, _)| comma + 2)
            }),
            mistake,
        }
    }

    /// How many quantities a header has: places and velocities at least. Where names of joints are given, these are places
    /// alone, or accelerations too if the base moves.
    pub(super) fn quantities(
        &self,
        joints: usize,
        moves: bool,
        names: Option<&[&str]>,
    ) -> Result<usize, CsvError> {
        let word = |cell: &str| cell.split([' ', '[']).next().unwrap_or_default().to_owned();
        let found = |index: usize| word(self.row.get(index).unwrap_or_default());
        let has =
            |index: usize, symbol: &str| found(index).split(['.', '_']).next() == Some(symbol);
        let expected = |index: usize, column: &str| {
            let expected = word(column);
            Err(self.mistake(index, CsvMistake::Header { expected }))
        };
        let least = match names {
            None => 2,
            Some(_) if moves => 3,
            Some(_) => 1,
        };
        if (names.is_none() || moves) && !has(0, "t") {
            return expected(0, "t");
        }
        let mut first = 1;
        for (k, (symbol, _)) in QUANTITIES.iter().enumerate() {
            let of_base = of_base(moves, k);
            for (i, name) in of_base.iter().enumerate() {
                match found(first + i) == word(name) {
                    true => {}
                    // The last quantities may be missing, as a whole.
                    false if i == 0 && k >= least => return Ok(k),
                    false => return expected(first + i, name),
                }
            }
            first += of_base.len();
            if let (0, Some(names)) = (k, names) {
                self.in_order(first, names)?;
                self.in_units(first, joints)?;
            }
            // Columns of positions may have other names in points.
            let is_free = names.is_some() && k == 0 && !moves;
            match (0..joints).find(|i| !is_free && !has(first + i, symbol)) {
                Some(0) if k >= least && !moves => return Ok(k),
                Some(i) => return expected(first + i, symbol),
                None => {}
            }
            first += joints;
            if has(first, symbol) {
                let next = QUANTITIES.get(k + 1).map_or("", |next| next.0);
                return expected(first, self::of_base(moves, k + 1).first().unwrap_or(&next));
            }
        }
        Ok(QUANTITIES.len())
    }

    /// Refuses a header that has another joint in the place of one, from a column on.
    pub(super) fn in_order(&self, first: usize, names: &[&str]) -> Result<(), CsvError> {
        let names_joint = |cell: &str, name: &str| {
            let word = cell.split(" [").next().unwrap_or_default();
            let [dotted, joined] = ["q.", "q_"].map(|symbol| word.strip_prefix(symbol));
            word == name || dotted.or(joined) == Some(name)
        };
        for (i, (cell, expected)) in self.row.iter().skip(first).zip(names).enumerate() {
            let is_right = names_joint(cell, expected);
            let other = names.iter().find(|name| names_joint(cell, name));
            if let Some(found) = other.filter(|_| !is_right) {
                let [found, expected] = [found, expected].map(|name| (*name).to_owned());
                return Err(self.mistake(i + first, CsvMistake::Joint { found, expected }));
            }
        }
        Ok(())
    }

    /// Refuses a header that says another unit of the time, or of positions, from a column on.
    pub(super) fn in_units(&self, first: usize, joints: usize) -> Result<(), CsvError> {
        let columns = (first..first + joints).map(|column| (column, "rad, or m"));
        for (column, expected) in [(0, "s")].into_iter().chain(columns) {
            let cell = self.row.get(column).unwrap_or_default();
            let unit = cell
                .strip_suffix(']')
                .and_then(|cell| cell.rsplit_once('['));
            if let Some((_, found)) = unit
                && !expected.split(", or ").any(|word| word == found)
            {
                let found = found.to_owned();
                return Err(self.mistake(column, CsvMistake::Unit { found, expected }));
            }
        }
        Ok(())
    }

    pub(super) fn number(&self, cell: usize, is_finite: bool) -> Result<f64, CsvError> {
        let text = &self.row[cell];
        let number = text.parse::<f64>().ok();
        // Digits that overflow are no infinity.
        let has_digits = text.contains(|c: char| c.is_ascii_digit());
        let number = number.filter(|x| x.is_finite() || !(is_finite || has_digits));
        number.ok_or_else(|| self.mistake(cell, CsvMistake::Number(self.row[cell].to_owned())))
    }
}
