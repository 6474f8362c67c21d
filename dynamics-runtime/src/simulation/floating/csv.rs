//! Motions on a base that moves as tables of comma-separated values.

use std::io::{self, Read, Write};

use nalgebra::{Const, Dyn};

use super::{FloatingTrajectory, SizedFloatingTrajectory};
use crate::Pose;
use crate::closed_form::is_rotation;
use crate::simulation::SizedModel;
use crate::simulation::csv::{CsvError, CsvMistake, QUANTITIES, Rows, text_of, write_rows};
use crate::size::{JointVector as _, Size};
use crate::stand::OnBase;
use crate::table::{AsArm as _, JointType};

/// The columns of the base before those of the joints: the place, then velocities, accelerations and forces.
const OF_BASE: [&[&str]; 4] = [
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

impl<D: Size, V: Size> SizedFloatingTrajectory<D, V> {
    /// Writes the samples as comma-separated values: a header, then a line for each sample.
    ///
    /// The columns are `t [s]`; the rotation of the base by rows, `base.r11` to `base.r33`, and its position, `base.x [m]` to
    /// `base.z`; `q.NAME [rad]` of each joint. Then the velocities, `base.vx [m/s]` to `base.wz` and `qd.NAME`; the accelerations,
    /// `base.vxd` to `base.wzd` and `qdd.NAME`; the forces, `base.fx` to `base.nz` and `tau.NAME`; and energies as
    /// [`SizedTrajectory::write_csv`](crate::simulation::SizedTrajectory::write_csv) has them. Numbers are read back to the last
    /// digit.
    ///
    /// It needs the feature `csv`.
    ///
    /// # Errors
    ///
    /// The errors of the writer.
    pub fn write_csv<R>(&self, robot: &R, out: impl Write) -> io::Result<()>
    where
        R: SizedModel<OnBase<D, V>>,
    {
        let (names, table) = (robot.names(), robot.sized_table());
        let lists = [&self.v, &self.a, &self.tau];
        let is_there = |k: &usize| *k == 0 || lists[k - 1].len() == self.len();
        let mut header = vec!["t [s]".to_owned()];
        for k in (0..4).filter(is_there) {
            header.extend(OF_BASE[k].iter().map(|name| (*name).to_owned()));
            let (symbol, units) = QUANTITIES[k];
            for (name, row) in names.as_ref().iter().zip(table.arm().rows) {
                let unit = units[usize::from(row.joint_type == JointType::Prismatic)];
                header.push(format!("{symbol}.{name} [{unit}]"));
            }
        }
        let rows = (0..self.len()).map(|k| {
            let (base, q) = (self.base[k].entries(), self.q[k].entries());
            let vectors = (1..4)
                .filter(is_there)
                .flat_map(|list| lists[list - 1][k].entries());
            let place = [&self.t[k]].into_iter().chain(base.as_slice()).chain(q);
            let energies = robot.sized_energies((&self.base[k], &self.q[k]), &self.v[k]);
            (place.chain(vectors).copied().collect(), energies)
        });
        let (base, joints) = (Pose::identity(), names.as_ref().len());
        let rest = (
            D::from_usize(joints).vector(),
            V::from_usize(6 + joints).vector(),
        );
        let at_rest = robot.sized_energies((&base, &rest.0), &rest.1);
        write_rows(out, header, at_rest, rows)
    }
}

impl<const N: usize, const V: usize> FloatingTrajectory<N, V> {
    /// Reads what [`write_csv`](SizedFloatingTrajectory::write_csv) writes. Accelerations and forces may be missing; columns after
    /// these are passed over, and so are empty lines. The work of the run is not in the table.
    ///
    /// It needs the feature `csv`.
    ///
    /// # Errors
    ///
    /// [`CsvError`] with the line and the column, if the header is not that of a motion of `N` joints on a base that
    /// moves. The same holds if a line has too few or too many cells, or a cell holds no number. A [`CsvError`] is also
    /// returned if the reader fails.
    pub fn read_csv(input: impl Read) -> Result<Self, CsvError> {
        read(Const, Const, None, input)
    }
}

impl SizedFloatingTrajectory<Dyn, Dyn> {
    /// Reads a motion for a robot with these `joints` to follow, as [`write_csv`](SizedFloatingTrajectory::write_csv) writes it, with
    /// its accelerations. Forces may be missing; columns after these are passed over, and so are empty lines.
    ///
    /// It needs the feature `csv`.
    ///
    /// # Errors
    ///
    /// [`CsvError`] with the line and the column, if the header is not that of a motion of these joints, in this order,
    /// on a base that moves. The same holds if a line has too few or too many cells, a cell holds no finite number, a
    /// rotation is none within 1e-6, times do not grow, or there are fewer than two rows. A [`CsvError`] is also
    /// returned if the reader fails.
    pub fn read_points(joints: &[&str], input: impl Read) -> Result<Self, CsvError> {
        read(
            Dyn(joints.len()),
            Dyn(6 + joints.len()),
            Some(joints),
            input,
        )
    }
}

/// A trajectory of samples; or of points to pass, for the joints with these names.
fn read<D: Size, V: Size>(
    joints: D,
    freedoms: V,
    points_of: Option<&[&str]>,
    input: impl Read,
) -> Result<SizedFloatingTrajectory<D, V>, CsvError> {
    let text = text_of(input)?;
    let mut rows = Rows::new(&text);
    rows.advance();
    let (n, v) = (joints.value(), freedoms.value());
    let quantities = quantities(&rows, n, points_of)?;
    let (width, least) = (rows.row.len(), 1 + 12 + n + (quantities - 1) * v);
    let mut read = SizedFloatingTrajectory::default();
    while rows.advance() {
        let found = rows.row.len();
        let number = |cell: usize| rows.number(cell, points_of.is_some());
        if found < least || found > width {
            // Cells between other separators are one that is no number.
            number(0)?;
            let expected = width;
            return Err(rows.mistake(found.min(width), CsvMistake::Cells { found, expected }));
        }
        let numbers = (0..least).map(number).collect::<Result<Vec<f64>, _>>()?;
        let base = Pose::of_entries(core::array::from_fn(|k| numbers[1 + k]));
        if points_of.is_some() {
            if read.t.last().is_some_and(|last| *last >= numbers[0]) {
                return Err(rows.mistake(0, CsvMistake::Order));
            }
            if !is_rotation(&base.rotation) {
                return Err(rows.mistake(1, CsvMistake::Rotation));
            }
        }
        read.t.push(numbers[0]);
        read.base.push(base);
        read.q.push(joints.vector_of(|i| numbers[13 + i]));
        let lists = [&mut read.v, &mut read.a, &mut read.tau];
        for (k, list) in lists.into_iter().take(quantities - 1).enumerate() {
            let first = 13 + n + k * v;
            list.push(freedoms.vector_of(|i| numbers[first + i]));
        }
    }
    if points_of.is_some() && read.len() < 2 {
        return Err(Rows::new("").mistake(0, CsvMistake::TooFew));
    }
    Ok(read)
}

/// How many quantities a header has: places and velocities at least, and accelerations where names of joints are given.
fn quantities(rows: &Rows<'_>, joints: usize, names: Option<&[&str]>) -> Result<usize, CsvError> {
    let least = if names.is_some() { 3 } else { 2 };
    let word = |cell: &str| cell.split([' ', '[']).next().unwrap_or_default().to_owned();
    let found = |index: usize| word(rows.row.get(index).unwrap_or_default());
    let expected =
        |index: usize, expected: String| Err(rows.mistake(index, CsvMistake::Header { expected }));
    if found(0) != "t" {
        return expected(0, "t".to_owned());
    }
    let mut first = 1;
    for (k, of_base) in OF_BASE.iter().enumerate() {
        let symbol = QUANTITIES[k].0;
        for (i, name) in of_base.iter().enumerate() {
            match found(first + i) == word(name) {
                true => {}
                // The last quantities may be missing, as a whole.
                false if i == 0 && k >= least => return Ok(k),
                false => return expected(first + i, word(name)),
            }
        }
        first += of_base.len();
        if let (0, Some(names)) = (k, names) {
            rows.in_order(first, names)?;
        }
        let is_of_joint = |i: &usize| found(first + i).split(['.', '_']).next() == Some(symbol);
        if let Some(i) = (0..joints).find(|i| !is_of_joint(i)) {
            return expected(first + i, symbol.to_owned());
        }
        if is_of_joint(&joints) {
            let next = OF_BASE
                .get(k + 1)
                .map_or(String::new(), |next| word(next[0]));
            return expected(first + joints, next);
        }
        first += joints;
    }
    Ok(OF_BASE.len())
}
