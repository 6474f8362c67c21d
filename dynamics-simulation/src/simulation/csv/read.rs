//! Trajectories and points to pass are read.

use std::io::Read;

use dynamics_runtime::internal::{is_rotation, moves};
use dynamics_runtime::{Pose, Size as _, Sizes};
use nalgebra::{Dim as _, DimName, Dyn};

use super::super::trajectory::SizedTrajectory;
use super::columns::of_base;
use super::mistake::{CsvError, CsvMistake};
use super::rows::Rows;

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
