//! Motions as tables of comma-separated values.

use std::path::{Path, PathBuf};

use dynamics_codegen::description::Place;
use dynamics_codegen::files;
use dynamics_runtime::nalgebra::Dyn;
use dynamics_simulation::simulation::{CsvMistake, SizedModel, SizedTrajectory};
use dynamics_symbolic::robot::Robot;

use crate::failure::Failure;
use crate::state::note_degrees;
use crate::write::write;

pub(crate) use dynamics_simulation::simulation::shortest;

/// Bytes of a file that is read: 100,000 rows of seven joints have about 15 million.
const MOST_BYTES: usize = 100_000_000;

/// The motion as a table. It is drawn as well, into the file of `--plot`, if there is one.
pub(crate) fn put(
    motion: &SizedTrajectory<Dyn>,
    columns: &impl SizedModel<Dyn>,
    robot: &Robot,
    plot: Option<&PathBuf>,
) -> Result<String, Failure> {
    let text = written(motion, columns)?;
    if let Some(path) = plot {
        let svg = motion.figure(columns).title(&robot.name).svg();
        let svg =
            svg.map_err(|error| Failure::after(String::new(), format!("`--plot`: {error}")))?;
        write(&[(path.clone(), svg)])?;
    }
    Ok(text)
}

/// The motion as a table. A number that is not finite is a failure, which names its time and its column.
fn written(motion: &SizedTrajectory<Dyn>, robot: &impl SizedModel<Dyn>) -> Result<String, Failure> {
    let names = robot.names();
    let energies = motion.both_energies(robot);
    for (sample, energies) in motion.samples().zip(energies) {
        let is_finite = |x: &f64| x.is_finite();
        let quantities = [
            ("q", &sample.q),
            ("qd", &sample.qd),
            ("qdd", &sample.qdd),
            ("tau", &sample.tau),
        ];
        let overflow = quantities.iter().find_map(|(symbol, vector)| {
            let place = vector.iter().position(|x| !x.is_finite())?;
            // The numbers of a base that moves come first.
            let joint = place.checked_sub(vector.len() - names.len());
            let of = joint.map_or(" of the base".to_owned(), |joint| {
                format!(".{}", names[joint])
            });
            Some(format!("{symbol}{of}"))
        });
        let is_energy = !energies.iter().flatten().all(is_finite);
        if let Some(column) = overflow.or_else(|| is_energy.then(|| "energy".to_owned())) {
            let message = too_large(&column, sample.t);
            return Err(Failure::after(String::new(), message));
        }
    }
    let mut text = Vec::new();
    motion.write_csv(robot, &mut text)?;
    Ok(String::from_utf8(text)?)
}

/// The reason why a motion is no table.
fn too_large(column: &str, t: f64) -> String {
    format!(
        "`{column}` at t = {} s is beyond the largest number that a computer holds: the motion is too fast, its positions \
         are too large, or the numbers of the robot are",
        shortest(t)
    )
}

/// The points of a file: rows of a time and a position of every joint, with velocities where the file has them. On a base that
/// moves they have places of the base, velocities and accelerations.
pub(crate) fn read(path: &Path, robot: &Robot) -> Result<SizedTrajectory<Dyn>, Failure> {
    let joints: Vec<_> = robot.joints().map(|row| row.name.as_str()).collect();
    let wrong = |line: usize, column: usize, message: String| {
        let place = format!("{}:{line}:{column}", path.display());
        Failure::after(String::new(), format!("{place}: {message}"))
    };
    let bytes = files::bytes_of_any(path, MOST_BYTES)
        .map_err(|error| wrong(1, 1, format!("cannot be read: {error}")))?;
    let text = files::text(bytes).map_err(|error| match error.place {
        Place::File { line, column } => wrong(line, column, error.message),
        Place::Tokens { .. } => wrong(1, 1, error.message),
    })?;
    let moves = robot.freedoms().has_base();
    let points = SizedTrajectory::read_points(&joints, moves, text.as_bytes());
    let points = points.map_err(|error| {
        let hint = hint(&error.mistake, robot);
        wrong(error.line, error.letter, format!("{}{hint}", error.mistake))
    })?;
    for q in &points.q {
        if note_degrees(&path.display().to_string(), robot, q.as_slice()) {
            break;
        }
    }
    Ok(points)
}

/// The columns that are expected, behind a mistake in them.
fn hint(mistake: &CsvMistake, robot: &Robot) -> &'static str {
    let freedoms = robot.freedoms();
    match mistake {
        CsvMistake::Header { .. } | CsvMistake::Joint { .. } if freedoms.has_base() => {
            ": the base moves, and the columns are those that `simulate` writes, with velocities and accelerations"
        }
        CsvMistake::Cells { expected, .. }
            if !freedoms.has_base() && *expected == freedoms.joints + 1 =>
        {
            ": a time, and a position of each joint"
        }
        _ => "",
    }
}
