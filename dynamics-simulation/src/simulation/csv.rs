//! Trajectories as tables of comma-separated values.

use core::fmt;
use std::io::{self, Read, Write};

use dynamics_runtime::internal::{is_rotation, moves};
use dynamics_runtime::table::{AsArm as _, JointType};
use dynamics_runtime::{JointVector as _, Place, Pose, Size as _, Sizes};
use nalgebra::{Dim as _, DimName, Dyn};

use super::trajectory::SizedTrajectory;
use crate::simulation::SizedModel;

/// The columns of a joint: the symbol, and the unit of a revolute and of a prismatic one.
const QUANTITIES: [(&str, [&str; 2]); 4] = [
    ("q", ["rad", "m"]),
    ("qd", ["rad/s", "m/s"]),
    ("qdd", ["rad/s^2", "m/s^2"]),
    ("tau", ["N m", "N"]),
];

/// The columns of the base before those of the joints: the place, then velocities, accelerations and forces.
const BASE_COLUMNS: [&[&str]; 4] = [
    &[
        "base.r11",
        "base.r12",
        "base.r13",
        "base.r21",
        "base.r22",
        "base.r23",
        "base.r31",
        "base.r32",
        "base.r33",
        "base.x [m]",
        "base.y [m]",
        "base.z [m]",
    ],
    &[
        "base.vx [m/s]",
        "base.vy [m/s]",
        "base.vz [m/s]",
        "base.wx [rad/s]",
        "base.wy [rad/s]",
        "base.wz [rad/s]",
    ],
    &[
        "base.vxd [m/s^2]",
        "base.vyd [m/s^2]",
        "base.vzd [m/s^2]",
        "base.wxd [rad/s^2]",
        "base.wyd [rad/s^2]",
        "base.wzd [rad/s^2]",
    ],
    &[
        "base.fx [N]",
        "base.fy [N]",
        "base.fz [N]",
        "base.nx [N m]",
        "base.ny [N m]",
        "base.nz [N m]",
    ],
];

/// The columns of the base before those of the joints: none of a base that stands.
fn of_base(moves: bool, quantity: usize) -> &'static [&'static str] {
    let columns = BASE_COLUMNS.get(quantity).filter(|_| moves);
    columns.copied().unwrap_or_default()
}

impl<K: Sizes> SizedTrajectory<K> {
    /// Writes the samples as comma-separated values: a header, then a line for each sample.
    ///
    /// The columns are `t [s]`; `q.NAME [rad]` of each joint, in m where it is prismatic; `qd.NAME`,
    /// `qdd.NAME` and `tau.NAME` with their units; and `kinetic energy [J]`, `potential energy [J]` where
    /// the robot knows them ([`Model::energies`](dynamics_runtime::Model::energies)). Numbers have as many digits as it takes to read the same
    /// ones back, with a decimal point whatever the language; a number that is not finite is `NaN`, `inf` or `-inf`.
    /// Velocities, accelerations or torques have no columns where the trajectory does not have one for each time. Energies have
    /// none without velocities.
    ///
    /// On a base that moves, its columns come first among those of a quantity. Before `q.NAME` these are the rotation by rows,
    /// `base.r11` to `base.r33`, and the position, `base.x [m]` to `base.z`. Then they are the velocities, `base.vx [m/s]` to
    /// `base.wz`; the accelerations, `base.vxd` to `base.wzd`; and the forces, `base.fx` to `base.nz`.
    ///
    /// It needs the feature `csv`.
    ///
    /// ```
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
    /// The errors of the writer.
    pub fn write_csv<R: SizedModel<K>>(&self, robot: &R, out: impl Write) -> io::Result<()> {
        let (names, table) = (robot.names(), robot.sized_table());
        let (names, moves) = (names.as_ref(), self.base_moves());
        let rates = [&self.qd, &self.qdd, &self.tau];
        let is_there = |k: &usize| *k == 0 || rates[k - 1].len() == self.len();
        let mut header = vec!["t [s]".to_owned()];
        for k in (0..QUANTITIES.len()).filter(is_there) {
            header.extend(of_base(moves, k).iter().map(|name| (*name).to_owned()));
            let (symbol, units) = QUANTITIES[k];
            for (name, row) in names.iter().zip(table.arm().rows) {
                let unit = units[usize::from(row.joint_type == JointType::Prismatic)];
                header.push(format!("{symbol}.{name} [{unit}]"));
            }
        }
        let start = Place {
            base: moves.then(Pose::identity),
            q: K::Joints::from_usize(names.len()).vector(),
        };
        let rest = K::Freedoms::from_usize(of_base(moves, 1).len() + names.len()).vector();
        let has_velocities = is_there(&1);
        if has_velocities && robot.sized_energies(&start, &rest).is_some() {
            header.extend(["kinetic", "potential"].map(|kind| format!("{kind} energy [J]")));
        }
        let mut writer = csv::Writer::from_writer(out);
        writer.write_record(header)?;
        for (k, (t, place)) in self.t.iter().zip(self.places()).enumerate() {
            let qd = self.qd.get(k).filter(|_| has_velocities);
            let energies = qd.and_then(|qd| robot.sized_energies(&place, qd));
            let base = place.base.as_ref().map(Pose::entries);
            let place = [t]
                .into_iter()
                .chain(base.iter().flatten())
                .chain(place.q.entries());
            let of_rates = (1..QUANTITIES.len()).filter(is_there);
            let of_rates = of_rates.flat_map(|quantity| rates[quantity - 1][k].entries());
            let numbers = place.chain(of_rates).chain(energies.iter().flatten());
            writer.write_record(numbers.copied().map(shortest))?;
        }
        writer.flush()
    }
}

/// A number in as few letters as it takes: `0.5`, `1e-17`.
#[doc(hidden)]
pub fn shortest(x: f64) -> String {
    let (decimal, scientific) = (x.to_string(), format!("{x:e}"));
    if decimal.len() <= scientific.len() {
        decimal
    } else {
        scientific
    }
}

impl<K: Sizes<Joints: DimName>> SizedTrajectory<K> {
    /// Reads what [`write_csv`](SizedTrajectory::write_csv) writes: `t`, then places, velocities, and, where the header has
    /// them, accelerations and torques. Columns after these are passed over, and so are empty lines. The work of the
    /// run is not in the table.
    ///
    /// It needs the feature `csv`.
    ///
    /// # Errors
    ///
    /// [`CsvError`] with the line and the column, where the header is not that of a trajectory of as many joints, on a base
    /// that stands or moves. The same holds if a line has too few or too many cells, or a cell holds no number. A
    /// [`CsvError`] is also returned if the reader fails.
    pub fn read_csv(input: impl Read) -> Result<Self, CsvError> {
        read(K::Joints::name(), moves::<K>(), None, input)
    }
}

impl SizedTrajectory<Dyn> {
    /// Reads points for a robot to pass: rows of a time in s and a position of each of the `joints`, in rad or m.
    ///
    /// A first row without numbers is a header. It may be that of [`write_csv`](SizedTrajectory::write_csv): velocities,
    /// accelerations and torques are read where they follow, and columns after these are passed over.
    /// Otherwise the lists `qd`, `qdd` and `tau` are empty. If `base_moves`, the header has to be that one, with poses,
    /// velocities and accelerations.
    ///
    /// It needs the feature `csv`.
    ///
    /// # Errors
    ///
    /// [`CsvError`] with the line and the column, if the header has the joints in another order, or a line has too
    /// few or too many cells. The same holds if a cell holds no finite number, a rotation is none within 1e-6, times do not
    /// grow, or there are fewer than two rows. A [`CsvError`] is also returned if the reader fails.
    pub fn read_points(
        joints: &[&str],
        base_moves: bool,
        input: impl Read,
    ) -> Result<Self, CsvError> {
        read(Dyn(joints.len()), base_moves, Some(joints), input)
    }
}

/// A trajectory of samples; or of points to pass, for the joints with these names.
fn read<K: Sizes>(
    joints: K::Joints,
    moves: bool,
    points_of: Option<&[&str]>,
    input: impl Read,
) -> Result<SizedTrajectory<K>, CsvError> {
    let text = text_of(input)?;
    let mut rows = Rows::new(&text);
    let (n, of_pose) = (joints.value(), of_base(moves, 0).len());
    let freedoms = K::Freedoms::from_usize(of_base(moves, 1).len() + n);
    let (mut is_row, are_points) = (rows.advance(), points_of.is_some());
    let (mut quantities, mut width) = (1, 1 + n);
    let may_lack_header = are_points && of_pose == 0;
    if !may_lack_header || rows.row.iter().all(|cell| cell.parse::<f64>().is_err()) {
        quantities = rows.quantities(n, moves, points_of)?;
        width = rows.row.len();
        let (found, expected) = (width, 1 + of_pose + n);
        if found < expected {
            return Err(rows.mistake(0, CsvMistake::Cells { found, expected }));
        }
        is_row = rows.advance();
    }
    let of_place = 1 + of_pose + n;
    let least = of_place + (quantities - 1) * freedoms.value();
    let mut trajectory = SizedTrajectory::<K>::default();
    while is_row {
        let found = rows.row.len();
        let number = |cell: usize| rows.number(cell, are_points);
        if found < least || found > width {
            // Cells between other separators are one that is no number.
            number(0)?;
            let (expected, end) = (width, found.min(width));
            let place = if may_lack_header { 0 } else { end };
            return Err(rows.mistake(place, CsvMistake::Cells { found, expected }));
        }
        let numbers = (0..least).map(number).collect::<Result<Vec<f64>, _>>()?;
        let (t, last) = (numbers[0], trajectory.t.last());
        if are_points && last.is_some_and(|last| *last >= t) {
            return Err(rows.mistake(0, CsvMistake::Order));
        }
        // There are twelve of a base that moves, and none of one that stands.
        if let Ok(entries) = numbers[1..=of_pose].try_into() {
            let base = Pose::of_entries(entries);
            if are_points && !is_rotation(&base.rotation) {
                return Err(rows.mistake(1, CsvMistake::Rotation));
            }
            trajectory.base.push(base);
        }
        trajectory.t.push(t);
        let q = joints.vector_of(|i| numbers[1 + of_pose + i]);
        trajectory.q.push(q);
        let lists = [&mut trajectory.qd, &mut trajectory.qdd, &mut trajectory.tau];
        for (k, list) in lists.into_iter().take(quantities - 1).enumerate() {
            let first = of_place + k * freedoms.value();
            list.push(freedoms.vector_of(|i| numbers[first + i]));
        }
        is_row = rows.advance();
    }
    if are_points && trajectory.len() < 2 {
        return Err(Rows::new("").mistake(0, CsvMistake::TooFew));
    }
    Ok(trajectory)
}

/// The text of a file.
fn text_of(mut input: impl Read) -> Result<String, CsvError> {
    let mut bytes = Vec::new();
    let unread = |good: &[u8], reason: String| CsvError {
        line: 1 + good.iter().filter(|byte| **byte == b'\n').count(),
        column: 1,
        letter: 1,
        mistake: CsvMistake::Reader(reason),
    };
    if let Err(error) = input.read_to_end(&mut bytes) {
        return Err(unread(&bytes, error.to_string()));
    }
    let text = core::str::from_utf8(&bytes)
        .map_err(|error| unread(&bytes[..error.valid_up_to()], error.to_string()))?;
    Ok(text.trim_start_matches('\u{feff}').to_owned())
}

/// The rows of a text.
struct Rows<'t> {
    text: &'t str,
    reader: csv::Reader<&'t [u8]>,
    row: csv::StringRecord,
}

impl<'t> Rows<'t> {
    fn new(text: &'t str) -> Self {
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
    fn advance(&mut self) -> bool {
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
    fn mistake(&self, cell: usize, mistake: CsvMistake) -> CsvError {
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
    fn quantities(
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
    fn in_order(&self, first: usize, names: &[&str]) -> Result<(), CsvError> {
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
    fn in_units(&self, first: usize, joints: usize) -> Result<(), CsvError> {
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

    fn number(&self, cell: usize, is_finite: bool) -> Result<f64, CsvError> {
        let text = &self.row[cell];
        let number = text.parse::<f64>().ok();
        // Digits that overflow are no infinity.
        let has_digits = text.contains(|c: char| c.is_ascii_digit());
        let number = number.filter(|x| x.is_finite() || !(is_finite || has_digits));
        number.ok_or_else(|| self.mistake(cell, CsvMistake::Number(self.row[cell].to_owned())))
    }
}

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

#[cfg(test)]
mod tests {
    use nalgebra::{Dyn, Vector2};
    use tables::CRAIG_ARM;

    use super::{CsvMistake, SizedTrajectory};
    use crate::Trajectory;

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

    /// Digits beyond the largest number are a mistake, where an infinity may stand too.
    #[test]
    fn digits_that_overflow_are_no_infinity() {
        let text = written(&trajectory());
        let overflowing = text.replace("\ninf,inf,", "\ninf,1e999,");
        assert_ne!(text, overflowing);
        let error = Trajectory::<2>::read_csv(overflowing.as_bytes());
        let mistake = error.map_err(|error| error.mistake);
        assert_eq!(mistake, Err(CsvMistake::Number("1e999".to_owned())));
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

    /// Points that were read have no velocities, nor has a motion that a program made.
    #[test]
    fn positions_alone_are_written() {
        let without = Trajectory {
            qd: vec![],
            ..trajectory()
        };
        let text = written(&without);
        let header = text.lines().next().unwrap();
        let places = "t [s],q.shoulder [rad],q.elbow [rad]";
        assert!(
            header.starts_with(&format!("{places},qdd.shoulder")),
            "{header}"
        );
        assert!(header.ends_with("tau.elbow [N m]"), "{header}");
        let alone = Trajectory {
            qdd: vec![],
            tau: vec![],
            ..without
        };
        let text = written(&alone);
        assert!(
            text.starts_with(&format!("{places}\n0.3333333333333333,")),
            "{text}"
        );
        assert_eq!(text.lines().count(), 6);
        // A velocity that is missing is missing at all times.
        let mut short = trajectory();
        short.qd.pop();
        (short.qdd, short.tau) = (vec![], vec![]);
        assert_eq!(written(&short), text);
        let read = |joints: &[&str], text: &str| {
            SizedTrajectory::<Dyn>::read_points(joints, false, text.as_bytes()).unwrap()
        };
        let points = read(&["shoulder", "elbow"], "0,1,2\n1,3,4\n");
        let arm = CRAIG_ARM;
        let motion = Trajectory::<2> {
            t: points.t,
            q: points.q.iter().map(|q| Vector2::new(q[0], q[1])).collect(),
            ..Trajectory::default()
        };
        let mut text = Vec::new();
        motion.write_csv(&arm, &mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        assert_eq!(text, format!("{places}\n0,1,2\n1,3,4\n"));
        assert_eq!(motion.energy_drift(&arm), 0.0);
    }

    #[test]
    fn mistakes_say_where_they_are() {
        let header = "t,q.a,q.b,qd.a,qd.b";
        let found = |text: &str| Trajectory::<2>::read_csv(text.as_bytes()).unwrap_err();
        let expected = |symbol: &str| CsvMistake::Header {
            expected: symbol.into(),
        };
        let cells = |found: usize| CsvMistake::Cells { found, expected: 5 };
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
                format!("{header}\r\n\r\n0,1,2,3,4\r\n\"0\", 1,x,3,4"),
                4,
                3,
                CsvMistake::Number("x".into()),
            ),
            (
                format!("{header}\n0,1,2,3,"),
                2,
                5,
                CsvMistake::Number(String::new()),
            ),
            (format!("{header}\n0,1,2,3"), 2, 5, cells(4)),
            (format!("{header}\n0,1,2,3,4,5"), 2, 6, cells(6)),
            (
                format!("{header}\n0;1;2;3;4"),
                2,
                1,
                CsvMistake::Number("0;1;2;3;4".into()),
            ),
        ] {
            let error = found(&text);
            let place = (error.line, error.column);
            assert_eq!((place, error.mistake), ((line, column), mistake), "{text}");
        }
        assert_eq!(
            found("0").to_string(),
            "line 1, column 1: a column `t` was expected"
        );
    }

    #[test]
    fn points_have_a_header_or_none() {
        let read =
            |text: &str| SizedTrajectory::<Dyn>::read_points(&["a", "b,c"], false, text.as_bytes());
        for header in [
            "",
            "t,a,\"b,c\"\n",
            "time,q_a,x\n",
            "t [s],q.a [rad],\"q.b,c [m]\"\n",
        ] {
            let points = read(&format!("{header}0,1,2\n \n1,3,4\n")).unwrap();
            assert_eq!((points.len(), points.q[1][1], points.qd.len()), (2, 4.0, 0));
        }
        let points = read("t,q.a,q.b,qd.a,qd.b,energy\n0,1,2,3,4,no\n1,1,2,5,6,x\n").unwrap();
        assert_eq!((points.qd[1][1], points.qdd.len()), (6.0, 0));
        for (text, place, letter, message) in [
            (
                "0,1\n",
                (1, 1),
                1,
                "found 2 numbers, expected 3 separated by commas",
            ),
            ("\"0\",\"1\",fast\n", (1, 3), 9, "`fast`: expected a number"),
            ("0,1,2\n1,inf,2\n", (2, 2), 3, "`inf`: expected a number"),
            (
                "0,1,2\r\n\r\n0,1,2\n",
                (3, 1),
                1,
                "times must grow from row to row",
            ),
            (
                "t,a,b\n0,1,2\n",
                (1, 1),
                1,
                "expected two rows of numbers or more",
            ),
            ("t,q_a,q_b,qd_a\n", (1, 5), 15, "a column `qd` was expected"),
            (
                "t,q_a\n0,1\n",
                (1, 1),
                1,
                "found 2 numbers, expected 3 separated by commas",
            ),
            (
                "t;q_a;q_b\n0;1;2\n",
                (1, 1),
                1,
                "found 1 number, expected 3 separated by commas",
            ),
            (
                "t,x,y\n0,\"1,5\",2\n",
                (2, 2),
                3,
                "`1,5`: expected a number with a decimal point",
            ),
            (
                "t,x,y\n0;1;2\n",
                (2, 1),
                1,
                "`0;1;2`: expected a number, and commas between numbers",
            ),
            (
                "t [ms],x,y\n0,1,2\n",
                (1, 1),
                1,
                "a column in `ms`: expected one in s",
            ),
            (
                "t [s],q.a [rad],q.b [deg]\n0,1,2\n",
                (1, 3),
                17,
                "a column in `deg`: expected one in rad, or m",
            ),
        ] {
            let error = read(text).unwrap_err();
            let found = ((error.line, error.column), error.letter);
            assert_eq!(found, (place, letter), "{text}");
            assert_eq!(error.mistake.to_string(), message, "{text}");
        }
        let error = read("t,q.\u{e4},\"q.a [m]\"\n").unwrap_err();
        assert_eq!((error.line, error.column, error.letter), (1, 3, 7));
        let expected = "line 1, column 3: a column of `a`, expected one of `b,c`: columns are in the order of the joints";
        assert_eq!(error.to_string(), expected);
    }
}
