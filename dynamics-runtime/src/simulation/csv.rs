//! Trajectories as tables of comma-separated values.

use core::fmt;
use std::io::{self, BufRead, BufReader, Read, Write};

use nalgebra::SVector;

use super::trajectory::{SizedTrajectory, Trajectory};
use crate::size::{JointVector as _, Size};
use crate::table::AsArm as _;
use crate::{simulation::SizedModel, table::JointType};

/// What stands in the columns of a joint: the symbol, and the unit of a revolute and of a prismatic one.
const QUANTITIES: [(&str, [&str; 2]); 4] = [
    ("q", ["rad", "m"]),
    ("qd", ["rad/s", "m/s"]),
    ("qdd", ["rad/s^2", "m/s^2"]),
    ("tau", ["N m", "N"]),
];

impl<D: Size> SizedTrajectory<D> {
    /// Writes the samples as comma-separated values: a header, then a line for each sample.
    ///
    /// The columns are `t [s]`; `q.NAME [rad]` of each joint, in m where it is prismatic; `qd.NAME`,
    /// `qdd.NAME` and `tau.NAME` with their units; and `kinetic energy [J]`, `potential energy [J]` where
    /// the robot knows them ([`Model::energies`](crate::Model::energies)). Numbers have as many digits as it takes to read the same
    /// ones back, with a decimal point whatever the language; a number that is not finite is `NaN`, `inf` or `-inf`.
    /// Accelerations or torques have no columns where the trajectory does not have one for each time.
    ///
    /// ```
    /// # extern crate dynamics_runtime as robot_dynamics;
    /// use robot_dynamics::{Simulation, nalgebra::SVector, robot_dynamics};
    ///
    /// robot_dynamics! {
    ///     /// A stone that falls along z.
    ///     struct Stone;
    ///     convention: modified,
    ///     gravity: [0, 0, -8],
    ///     joints: [height: prismatic { mass: 2 }],
    /// }
    ///
    /// let fall = Simulation::new(&Stone).samples(3).run()?;
    /// let mut text = Vec::new();
    /// fall.write_csv(&Stone, &mut text)?;
    /// let text = String::from_utf8(text)?;
    /// let mut lines = text.lines();
    /// assert_eq!(
    ///     lines.next(),
    ///     Some("t [s],q.height [m],qd.height [m/s],qdd.height [m/s^2],tau.height [N],\
    ///           kinetic energy [J],potential energy [J]"),
    /// );
    /// assert!(lines.next().unwrap().starts_with("0,0,0,-8,0,0,"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// Those of the writer. Writes in small pieces: hand over a buffered one.
    pub fn write_csv<R: SizedModel<D>>(&self, robot: &R, mut out: impl Write) -> io::Result<()> {
        let (names, table) = (robot.names(), robot.sized_table());
        let kinds = table.arm().rows.iter().map(|row| row.joint_type);
        let joints: Vec<_> = names
            .as_ref()
            .iter()
            .map(String::as_str)
            .zip(kinds)
            .collect();
        let rest = D::from_usize(joints.len()).vector();
        let has_energies = robot.sized_energies(&rest, &rest).is_some();
        let lists = [&self.q, &self.qd, &self.qdd, &self.tau];
        let has = |list: &&&Vec<D::Vector>| list.len() == self.len();
        let quantities = lists.each_ref().map(|list| has(&list));
        self.write_header(&joints, &quantities, has_energies, &mut out)?;
        for k in 0..self.len() {
            write!(out, "{}", self.t[k])?;
            for vector in lists.iter().filter(has).map(|list| &list[k]) {
                for entry in vector.entries() {
                    write!(out, ",{entry}")?;
                }
            }
            if let Some(energies) = robot.sized_energies(&self.q[k], &self.qd[k]) {
                write!(out, ",{},{}", energies[0], energies[1])?;
            }
            writeln!(out)?;
        }
        out.flush()
    }

    fn write_header(
        &self,
        joints: &[(&str, JointType)],
        quantities: &[bool; 4],
        has_energies: bool,
        out: &mut impl Write,
    ) -> io::Result<()> {
        write!(out, "t [s]")?;
        let there = QUANTITIES
            .iter()
            .zip(quantities)
            .filter(|(_, there)| **there);
        for ((symbol, [of_angle, of_length]), _) in there {
            for (name, joint_type) in joints {
                let unit = match joint_type {
                    JointType::Revolute => of_angle,
                    JointType::Prismatic => of_length,
                };
                write!(out, ",{symbol}.{} [{unit}]", plain(name))?;
            }
        }
        if has_energies {
            write!(out, ",kinetic energy [J],potential energy [J]")?;
        }
        writeln!(out)
    }
}

impl<const N: usize> Trajectory<N> {
    /// Reads what [`write_csv`](SizedTrajectory::write_csv) writes: `t`, then `q`, `qd`, and, where the header has
    /// them, `qdd` and `tau` of `N` joints. Columns after these are passed over, and so are empty lines. The
    /// work of the run is not in the table.
    ///
    /// # Errors
    ///
    /// [`CsvError`] with the line and the column, where the header is not that of a trajectory of `N` joints,
    /// a line is too short, or a cell holds no number; and where the reader fails.
    pub fn read_csv(input: impl Read) -> Result<Self, CsvError> {
        let mut lines = BufReader::new(input).lines().enumerate();
        let header = match lines.next() {
            Some((_, line)) => line.map_err(|error| CsvError::of_reader(1, error))?,
            None => {
                return Err(CsvError::new(
                    1,
                    1,
                    CsvMistake::Header {
                        expected: "t".into(),
                    },
                ));
            }
        };
        let quantities = quantities::<N>(&header)?;
        let mut trajectory = Trajectory::default();
        for (k, line) in lines {
            let line = line.map_err(|error| CsvError::of_reader(k + 1, error))?;
            if line.trim().is_empty() {
                continue;
            }
            let mut cells = Cells::new(&line, k + 1);
            trajectory.t.push(cells.number()?);
            let Trajectory {
                q, qd, qdd, tau, ..
            } = &mut trajectory;
            for list in [q, qd, qdd, tau].into_iter().take(quantities) {
                list.push(cells.vector()?);
            }
        }
        Ok(trajectory)
    }
}

/// A name without what means something in a table.
fn plain(name: &str) -> String {
    name.replace([',', '"', '\n', '\r'], "_")
}

/// How many quantities of `N` joints a header has, at least `q` and `qd`.
fn quantities<const N: usize>(header: &str) -> Result<usize, CsvError> {
    let mut cells = Cells::new(header.trim_start_matches('\u{feff}'), 1);
    cells.symbol("t")?;
    for (k, (symbol, _)) in QUANTITIES.iter().enumerate() {
        for i in 0..N {
            match cells.symbol(symbol) {
                // The last two may be missing, as a whole.
                Err(_) if k >= 2 && i == 0 => return Ok(k),
                found => found?,
            }
        }
        let mut beyond = cells.clone();
        if beyond.symbol(symbol).is_ok() {
            let expected = QUANTITIES.get(k + 1).map_or("", |next| next.0).into();
            return Err(beyond.mistake(CsvMistake::Header { expected }));
        }
    }
    Ok(QUANTITIES.len())
}

/// The cells of a line.
#[derive(Clone)]
struct Cells<'a> {
    cells: core::str::Split<'a, char>,
    line: usize,
    /// Cells read.
    column: usize,
}

impl<'a> Cells<'a> {
    fn new(line: &'a str, number: usize) -> Self {
        Cells {
            cells: line.split(','),
            line: number,
            column: 0,
        }
    }

    fn mistake(&self, mistake: CsvMistake) -> CsvError {
        CsvError::new(self.line, self.column.max(1), mistake)
    }

    fn next(&mut self) -> Option<&'a str> {
        self.column += 1;
        self.cells.next().map(str::trim)
    }

    /// A column of the header that begins with a symbol.
    fn symbol(&mut self, symbol: &str) -> Result<(), CsvError> {
        let found = self.next().unwrap_or_default();
        let name = found.split(['.', ' ', '[']).next();
        match name == Some(symbol) {
            true => Ok(()),
            false => Err(self.mistake(CsvMistake::Header {
                expected: symbol.into(),
            })),
        }
    }

    fn number(&mut self) -> Result<f64, CsvError> {
        let Some(cell) = self.next() else {
            return Err(self.mistake(CsvMistake::TooShort));
        };
        cell.parse()
            .map_err(|_| self.mistake(CsvMistake::Number(cell.into())))
    }

    fn vector<const N: usize>(&mut self) -> Result<SVector<f64, N>, CsvError> {
        let mut vector = SVector::zeros();
        for i in 0..N {
            vector[i] = self.number()?;
        }
        Ok(vector)
    }
}

/// Why a table could not be read as a trajectory.
#[derive(Clone, Debug, PartialEq)]
pub struct CsvError {
    /// The line, counted from 1.
    pub line: usize,
    /// The column, a cell, counted from 1.
    pub column: usize,
    /// What is wrong there.
    pub mistake: CsvMistake,
}

/// What is wrong with a cell.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum CsvMistake {
    /// The header has another column than the one that was expected.
    Header {
        /// The symbol expected: `t`, `q`, `qd`, ...
        expected: String,
    },
    /// The cell holds this, which is no number.
    Number(String),
    /// The line ends before the cell.
    TooShort,
    /// The line could not be read.
    Reader(String),
}

impl CsvError {
    fn new(line: usize, column: usize, mistake: CsvMistake) -> Self {
        CsvError {
            line,
            column,
            mistake,
        }
    }

    fn of_reader(line: usize, error: io::Error) -> Self {
        CsvError::new(line, 1, CsvMistake::Reader(error.to_string()))
    }
}

impl fmt::Display for CsvError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}, column {}: ", self.line, self.column)?;
        match &self.mistake {
            CsvMistake::Header { expected } if expected.is_empty() => {
                write!(f, "there are more joints than the trajectory has")
            }
            CsvMistake::Header { expected } => write!(f, "a column `{expected}` was expected"),
            CsvMistake::Number(found) => write!(f, "`{found}` is no number"),
            CsvMistake::TooShort => write!(f, "the line ends here"),
            CsvMistake::Reader(error) => write!(f, "{error}"),
        }
    }
}

impl core::error::Error for CsvError {}

#[cfg(test)]
mod tests {
    use nalgebra::Vector2;

    use super::{CsvError, CsvMistake, Trajectory};
    use crate::test_arms::CRAIG_ARM;

    fn trajectory() -> Trajectory<2> {
        let values = [
            1.0 / 3.0,
            -0.0,
            f64::MIN_POSITIVE / 3.0,
            1.7e308,
            f64::INFINITY,
        ];
        let list = |shift: f64| values.map(|x| Vector2::new(x, x - shift)).to_vec();
        Trajectory {
            t: values.to_vec(),
            q: list(0.1),
            qd: list(0.2),
            qdd: list(0.3),
            tau: list(0.4),
            ..Trajectory::default()
        }
    }

    fn written(trajectory: &Trajectory<2>) -> String {
        let mut text = Vec::new();
        trajectory.write_csv(&CRAIG_ARM, &mut text).unwrap();
        String::from_utf8(text).unwrap()
    }

    #[test]
    fn what_is_written_is_read_to_the_last_bit() {
        let (original, text) = (trajectory(), written(&trajectory()));
        let header = text.lines().next().unwrap();
        let first = "t [s],q.shoulder [rad],q.elbow [rad],qd.shoulder [rad/s],qd.elbow [rad/s],";
        assert!(header.starts_with(first), "{header}");
        assert!(header.ends_with("tau.elbow [N m],kinetic energy [J],potential energy [J]"));
        assert_eq!(
            Trajectory::<2>::read_csv(text.as_bytes()),
            Ok(original.clone())
        );
        // As other programs write it.
        let other = format!(
            "\u{feff}{}\r\n\r\n",
            text.replace('\n', "\r\n").replace(',', " , ")
        );
        assert_eq!(Trajectory::<2>::read_csv(other.as_bytes()), Ok(original));
        let nan = Trajectory {
            tau: vec![Vector2::repeat(f64::NAN); 5],
            ..trajectory()
        };
        let read = Trajectory::<2>::read_csv(written(&nan).as_bytes()).unwrap();
        assert!(read.tau.iter().all(|tau| tau[0].is_nan()));
    }

    #[test]
    fn positions_and_velocities_alone_are_a_trajectory() {
        let text = "t,q.a,q.b,qd.a,qd.b\n0,1,2,3,4\n";
        let read = Trajectory::<2>::read_csv(text.as_bytes()).unwrap();
        assert_eq!(
            (read.q[0], read.qd[0]),
            (Vector2::new(1.0, 2.0), Vector2::new(3.0, 4.0))
        );
        assert!(read.qdd.is_empty() && read.tau.is_empty());
        let without = Trajectory {
            qdd: vec![],
            tau: vec![],
            ..trajectory()
        };
        let read = Trajectory::<2>::read_csv(written(&without).as_bytes());
        assert_eq!(read, Ok(without));
    }

    #[test]
    fn mistakes_say_where_they_are() {
        let header = "t,q.a,q.b,qd.a,qd.b";
        let found = |text: &str| Trajectory::<2>::read_csv(text.as_bytes()).unwrap_err();
        let expected = |symbol: &str| CsvMistake::Header {
            expected: symbol.into(),
        };
        for (text, line, column, mistake) in [
            ("".into(), 1, 1, expected("t")),
            ("x,y".into(), 1, 1, expected("t")),
            ("t,q.a,qd.a".into(), 1, 3, expected("q")),
            ("t,q.a,q.b,q.c,qd.a,qd.b,qd.c".into(), 1, 4, expected("qd")),
            (
                format!("{header}\n0,1,2,3,4\n0,1,x,3,4"),
                3,
                3,
                CsvMistake::Number("x".into()),
            ),
            (
                format!("{header}\n0,1,2,3,"),
                2,
                5,
                CsvMistake::Number(String::new()),
            ),
            (format!("{header}\n0,1,2,3"), 2, 5, CsvMistake::TooShort),
            (
                format!("{header}\n0;1;2;3;4"),
                2,
                1,
                CsvMistake::Number("0;1;2;3;4".into()),
            ),
        ] {
            assert_eq!(found(&text), CsvError::new(line, column, mistake), "{text}");
        }
        assert_eq!(
            found("0").to_string(),
            "line 1, column 1: a column `t` was expected"
        );
    }
}
