//! Mistakes in a table, and where they are.

use core::fmt;

/// Why a table could not be read as a trajectory.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct CsvError {
    /// The line, counted from 1.
    pub line: usize,
    /// The column, a cell, counted from 1.
    pub column: usize,
    /// The letter of the line at which the cell begins, counted from 1.
    pub letter: usize,
    /// The mistake there.
    pub mistake: CsvMistake,
}

/// A mistake in a cell.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum CsvMistake {
    /// The header has another column than the one that was expected.
    Header {
        /// The symbol expected: `t`, `q`, `qd`, ...
        expected: String,
    },
    /// The header has the joints in another order than the arm.
    Joint {
        /// The name of the joint in the header.
        found: String,
        /// The name of the arm's joint.
        expected: String,
    },
    /// The header has a column in another unit.
    Unit {
        /// The unit in the header.
        found: String,
        /// The units that a column may be in.
        expected: &'static str,
    },
    /// The cell holds this, which is no number, or no finite one in a point to pass.
    Number(String),
    /// The line has too few cells, or too many.
    Cells {
        /// The number of cells of the line.
        found: usize,
        /// The number of columns.
        expected: usize,
    },
    /// The time of a point to pass is not after the one before.
    Order,
    /// The nine numbers from this cell on are no rotation, in a point to pass.
    Rotation,
    /// There are fewer than two points to pass.
    TooFew,
    /// The line could not be read.
    Reader(String),
}

impl fmt::Display for CsvMistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CsvMistake::Header { expected } if expected.is_empty() => {
                write!(f, "there are more joints than the trajectory has")
            }
            CsvMistake::Header { expected } => write!(f, "a column `{expected}` was expected"),
            CsvMistake::Joint { found, expected } => write!(
                f,
                "a column of `{found}`, expected one of `{expected}`: columns are in the order of the joints"
            ),
            CsvMistake::Unit { found, expected } => {
                write!(f, "a column in `{found}`: expected one in {expected}")
            }
            CsvMistake::Number(found) => {
                let way_out = match found {
                    _ if found.contains([';', '\t']) => ", and commas between numbers",
                    _ if found.contains(',') => " with a decimal point",
                    _ => "",
                };
                write!(f, "`{found}`: expected a number{way_out}")
            }
            CsvMistake::Cells { found, expected } => {
                let plural = if *found == 1 { "" } else { "s" };
                write!(
                    f,
                    "found {found} number{plural}, expected {expected} separated by commas"
                )
            }
            CsvMistake::Order => write!(f, "times must grow from row to row"),
            CsvMistake::Rotation => write!(f, "`base.r11` to `base.r33` are no rotation"),
            CsvMistake::TooFew => write!(f, "expected two rows of numbers or more"),
            CsvMistake::Reader(error) => write!(f, "{error}"),
        }
    }
}

impl fmt::Display for CsvError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "line {}, column {}: {}",
            self.line, self.column, self.mistake
        )
    }
}

impl core::error::Error for CsvError {}
