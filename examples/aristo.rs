//! The six-axis Aristo: forward kinematics, inverse dynamics on a joint trajectory, free fall.
//!
//! After Saha's lecture slides, which show it in RoboAnalyzer.
//!
//! ```text
//! cargo run --release --example aristo
//! ```

use std::{error::Error, f64::consts::PI};

use robot_dynamics::plot::{Curve, Figure, joints};
use robot_dynamics::{Cycloidal, Simulation, nalgebra::Vector6, robot_dynamics};

robot_dynamics! {
    /// MTAB Aristo. The Denavit-Hartenberg table is published; the mass properties are estimates
    /// (solid cylinders, 20.9 kg together), as the maker's are not.
    struct Aristo;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute {
            d: 0.322, alpha: PI/2,
            mass: 8, com: [0, -0.12, 0],
            inertia: { xx: 0.0482, yy: 0.0196, zz: 0.0482 },
        },
        shoulder: revolute {
            a: 0.3,
            mass: 6, com: [-0.15, 0, 0],
            inertia: { xx: 0.0075, yy: 0.0488, zz: 0.0488 },
        },
        elbow: revolute {
            alpha: PI/2,
            mass: 3.5, com: [0, 0, -0.1],
            inertia: { xx: 0.0139, yy: 0.0139, zz: 0.0044 },
        },
        forearm: revolute {
            d: -0.375, alpha: PI/2,
            mass: 2.2, com: [0, 0.12, 0],
            inertia: { xx: 0.0082, yy: 0.0018, zz: 0.0082 },
        },
        wrist: revolute {
            alpha: PI/2,
            mass: 0.9, com: [0, 0, 0.01],
            inertia: { xx: 0.0006, yy: 0.0006, zz: 0.0006 },
        },
        flange: revolute {
            d: 0.063,
            mass: 0.3, com: [0, 0, -0.02],
            inertia: { xx: 9e-5, yy: 9e-5, zz: 0.000135 },
        },
    ],
    functions: [
        forward_kinematics, inverse_dynamics, forward_dynamics, kinetic_energy, potential_energy,
    ],
}

/// Joint values at the start and at the end of the trajectory, degrees: those of joints 1 to 3 are
/// the slides', the wrist's are ours.
const START: [f64; 6] = [0.0, 90.0, 180.0, 0.0, 0.0, 0.0];
const END: [f64; 6] = [60.0, 60.0, 180.0, 30.0, -45.0, 90.0];

fn main() -> Result<(), Box<dyn Error>> {
    let start = Vector6::from(START) * (PI / 180.0);
    let end = Vector6::from(END) * (PI / 180.0);
    println!("Flange in the base at the start, joints at {START:?} degrees:");
    println!("{:9.4}", Aristo.forward_kinematics(&start));
    println!("and at the end, joints at {END:?} degrees:");
    println!("{:9.4}", Aristo.forward_kinematics(&end));
    inverse_dynamics(start, end)?;
    free_fall(end)
}

/// Joint torques along the cycloidal law from start to end in 3 s.
fn inverse_dynamics(start: Vector6<f64>, end: Vector6<f64>) -> Result<(), Box<dyn Error>> {
    let law = Cycloidal::new(start, end, 3.0)?;
    let t: Vec<f64> = (0..=300).map(|k| 0.01 * k as f64).collect();
    let points: Vec<_> = t.iter().map(|&t| law.at(t)).collect();
    let tau: Vec<Vector6<f64>> = points
        .iter()
        .map(|p| Aristo.inverse_dynamics(&p.q, &p.qd, &p.qdd))
        .collect();

    println!("Inverse dynamics: joint torques, N m");
    for k in (0..=300).step_by(50) {
        println!("  t = {:.1} s  {:8.3?}", t[k], tau[k].as_slice());
    }
    let names = Aristo::JOINT_NAMES;
    let positions = points.iter().map(|p| p.q);
    Figure::new("Aristo: inverse dynamics on the cycloidal law")
        .panel("joint angles, rad", joints(names, &t, positions))
        .panel("joint torques, N m", joints(names, &t, tau))
        .save("examples/output/aristo_inverse_dynamics.svg")
}

/// Three seconds of free fall from rest at the trajectory's end, without friction: the energy must
/// stay. The light wrist is whirled about.
fn free_fall(from: Vector6<f64>) -> Result<(), Box<dyn Error>> {
    let run = Simulation::new(&Aristo)
        .initial(from, Vector6::zeros())
        .duration(3.0)
        .samples(1201)
        .run()?;

    println!("\nFree fall from the trajectory's end: joint angles, rad");
    for k in [0, 400, 800, 1200] {
        println!("  t = {:.1} s  {:8.3?}", run.t[k], run.q[k].as_slice());
    }
    println!("  largest energy error {:.1e} J", run.energy_drift(&Aristo));

    let names = Aristo::JOINT_NAMES;
    let energies = run.energies(&Aristo);
    let errors = energies.iter().map(|energy| energy - energies[0]);
    let energy_error = Curve::new("T + U", &run.t, errors);
    Figure::new("Aristo: free fall from the trajectory's end")
        .panel("joint angles, rad", joints(names, &run.t, run.q))
        .panel("joint rates, rad/s", joints(names, &run.t, run.qd))
        .panel("energy error, J", [energy_error])
        .save("examples/output/aristo_free_fall.svg")
}
