//! Two files of one arm.

use std::fmt::Write as _;

use dynamics_evaluation::RuntimeRobot;
use dynamics_runtime::NAMES_OF_BASE;
use dynamics_symbolic::exact::SplitMix64;

use crate::failure::Failure;
use crate::state::poses_of;

/// Compares the functions of two arms of as many joints at random states; whether no difference is too large.
pub(crate) fn compare(
    one: &RuntimeRobot,
    other: &RuntimeRobot,
    samples: usize,
    tolerance: f64,
    text: &mut String,
) -> Result<bool, Failure> {
    let _ = writeln!(
        text,
        "\nagainst the other file: largest difference over the largest entry"
    );
    let mut is_same = true;
    for name in one.function_names() {
        let found = Difference::between(name, one, other, samples)?;
        let is_good = found.relative <= tolerance;
        is_same &= is_good;
        let at = if is_good {
            String::new()
        } else {
            format!(", most at {}", found.place(one))
        };
        let _ = writeln!(text, "{name:<20} {:.1e}{at}", found.relative);
    }
    Ok(is_same)
}

/// The largest difference of a function's entries.
struct Difference {
    /// Over the largest entry.
    relative: f64,
    /// Which of the entries.
    entry: usize,
    entries: usize,
}

impl Difference {
    fn between(
        name: &str,
        one: &RuntimeRobot,
        other: &RuntimeRobot,
        samples: usize,
    ) -> Result<Difference, Failure> {
        let mut random = SplitMix64::new(1);
        let mut drawn: Vec<Vec<f64>> = Vec::new();
        for (argument, width) in one.arguments(name)? {
            let mut draw = |count: usize, range: f64| -> Vec<f64> {
                (0..count)
                    .map(|_| range * (2.0 * random.unit() - 1.0))
                    .collect()
            };
            drawn.push(match argument {
                "base" => poses_of(&draw(3 * samples, 3.0)),
                _ => draw(samples * width, range(argument)),
            });
        }
        let arguments: Vec<&[f64]> = drawn.iter().map(Vec::as_slice).collect();
        let entries = one.entries(name)?;
        let [mut mine, mut others] = [(); 2].map(|()| vec![0.0; samples * entries]);
        one.batch(name, &arguments, &mut mine)?;
        other.batch(name, &arguments, &mut others)?;
        let size = mine.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let differences = mine.iter().zip(&others).map(|(a, b)| (a - b).abs());
        let worst = |worst: (usize, f64), (place, x): (usize, f64)| {
            let is_worse = x > worst.1 || x.is_nan();
            if is_worse { (place, x) } else { worst }
        };
        let (place, difference) = differences.enumerate().fold((0, 0.0), worst);
        Ok(Difference {
            relative: if size > 0.0 {
                difference / size
            } else {
                difference
            },
            entry: place.checked_rem(entries).unwrap_or(0),
            entries,
        })
    }

    /// The joint of the entry, where there is one for each joint or pair of joints.
    fn place(&self, arm: &RuntimeRobot) -> String {
        let dof = arm.dof();
        let is_of_joints = self.entries == dof || self.entries == dof * dof;
        // The numbers of a base that moves come first.
        let of_base = dof - arm.joint_names().count();
        match (self.entry % dof.max(1)).checked_sub(of_base) {
            _ if !is_of_joints => format!("entry {}", self.entry + 1),
            None => format!("`{}`", NAMES_OF_BASE[self.entry % dof]),
            Some(joint) => format!(
                "joint `{}`",
                arm.joint_names().nth(joint).unwrap_or_default()
            ),
        }
    }
}

/// Up to which size the entries of an argument are.
fn range(argument: &str) -> f64 {
    match argument {
        "q" | "qd" => 3.0,
        _ => 10.0,
    }
}
