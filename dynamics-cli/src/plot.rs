//! Motions as figures.

use std::path::PathBuf;

use clap::ArgMatches;
use dynamics_runtime::nalgebra::{DVector, Dyn, Rotation3};
use dynamics_runtime::plot::{Curve, Figure};
use dynamics_runtime::simulation::{SizedFloatingTrajectory, SizedTrajectory};
use dynamics_symbolic::robot::{JointType, Robot};

use crate::failure::Failure;
use crate::write::write;

/// The labels of panels of joints that turn, and of those that slide: positions, velocities, accelerations and forces.
const LABELS: [[&str; 2]; 4] = [
    ["position, rad", "position, m"],
    ["velocity, rad/s", "velocity, m/s"],
    ["acceleration, rad/s²", "acceleration, m/s²"],
    ["torque, N m", "force, N"],
];

/// Writes the figure to the file that `--plot` names, if it names one.
pub(crate) fn put(given: &ArgMatches, figure: impl FnOnce() -> Figure) -> Result<(), Failure> {
    let Some(path) = given.get_one::<PathBuf>("plot") else {
        return Ok(());
    };
    let svg = figure().svg();
    let svg = svg.map_err(|error| Failure::after(String::new(), format!("`--plot`: {error}")))?;
    write(&[(path.clone(), svg)])
}

/// A motion of an arm, with its energies where they are known.
pub(crate) fn of_motion(
    robot: &Robot,
    motion: &SizedTrajectory<Dyn>,
    energies: Option<Vec<[f64; 2]>>,
) -> Figure {
    let lists = [&motion.q, &motion.qd, &motion.qdd, &motion.tau];
    let figure = of_joints(Figure::new(&robot.name), robot, &motion.t, lists, 0);
    with_energies(figure, &motion.t, energies)
}

/// A motion on a base that moves: where the base is, how it moves, then the joints.
pub(crate) fn on_base(
    robot: &Robot,
    motion: &SizedFloatingTrajectory<Dyn, Dyn>,
    energies: Vec<f64>,
) -> Figure {
    let t = &motion.t;
    let angles = motion.base.iter().map(|base| {
        let (roll, pitch, yaw) = Rotation3::from_matrix_unchecked(base.rotation).euler_angles();
        [roll, pitch, yaw]
    });
    let positions = motion.base.iter().map(|base| base.position.into());
    let rates = |first: usize| {
        motion
            .v
            .iter()
            .map(move |v| [0, 1, 2].map(|i| v[first + i]))
    };
    let figure = Figure::new(&robot.name)
        .panel("base, m", three(["x", "y", "z"], t, positions))
        .panel("base, rad", three(["roll", "pitch", "yaw"], t, angles))
        .panel("base, m/s", three(["vx", "vy", "vz"], t, rates(0)))
        .panel("base, rad/s", three(["wx", "wy", "wz"], t, rates(3)));
    let lists = [&motion.q, &motion.v, &motion.a, &motion.tau];
    let figure = of_joints(figure, robot, t, lists, robot.freedoms().base);
    figure.panel("energy, J", [Curve::new("total", t, energies)])
}

/// Three curves.
fn three(
    names: [&str; 3],
    t: &[f64],
    values: impl Iterator<Item = [f64; 3]> + Clone,
) -> [Curve; 3] {
    [0, 1, 2].map(|i| Curve::new(names[i], t, values.clone().map(|three| three[i])))
}

/// Panels of the joints, apart where they turn and where they slide. All vectors but the first begin with so many numbers
/// of the base.
fn of_joints(
    mut figure: Figure,
    robot: &Robot,
    t: &[f64],
    lists: [&Vec<DVector<f64>>; 4],
    of_base: usize,
) -> Figure {
    for (k, (list, labels)) in lists.into_iter().zip(LABELS).enumerate() {
        if list.len() != t.len() {
            continue;
        }
        let first = if k == 0 { 0 } else { of_base };
        for (kind, label) in [JointType::Revolute, JointType::Prismatic]
            .into_iter()
            .zip(labels)
        {
            let joints = robot.joints().enumerate();
            let joints = joints.filter(|(_, row)| row.joint_type == kind);
            let curve = |(joint, name): (usize, &str)| {
                Curve::new(name, t, list.iter().map(|vector| vector[first + joint]))
            };
            let curves = joints.map(|(joint, row)| curve((joint, &row.name)));
            let curves: Vec<_> = curves.collect();
            if !curves.is_empty() {
                figure = figure.panel(label, curves);
            }
        }
    }
    figure
}

/// A panel of kinetic, potential and total energy.
fn with_energies(figure: Figure, t: &[f64], energies: Option<Vec<[f64; 2]>>) -> Figure {
    let Some(energies) = energies else {
        return figure;
    };
    let curve = |name: &str, of: fn(&[f64; 2]) -> f64| Curve::new(name, t, energies.iter().map(of));
    let curves = [
        curve("kinetic", |e| e[0]),
        curve("potential", |e| e[1]),
        curve("total", |e| e[0] + e[1]),
    ];
    figure.panel("energy, J", curves)
}
