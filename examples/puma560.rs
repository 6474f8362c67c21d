//! The main job: from the PUMA 560's Denavit-Hartenberg table to proven functions, a check against
//! recursive Newton-Euler, and a simulation.
//!
//! ```text
//! cargo run --release --example puma560
//! ```

use std::{
    error::Error,
    f64::consts::{FRAC_PI_4, PI},
};

use robot_dynamics::plot::{Curve, Figure, joints};
use robot_dynamics::{
    Method, Simulation, Trajectory, check_against_rnea, nalgebra::Vector6, robot_dynamics,
    simulation::DormandPrince,
};

robot_dynamics! {
    /// Unimation PUMA 560.
    ///
    /// Numbers of P. I. Corke and B. Armstrong-Helouvry, A search for consensus among model
    /// parameters reported for the PUMA 560 robot, ICRA 1994, as tabulated in the Robotics Toolbox
    /// for Python (`models/DH/Puma560.py`). Friction is brought to the joint's side; the toolbox's
    /// two Coulomb torques of each joint are averaged. The tensors of links 1 and 3 are published
    /// as they stand here, though no distribution of mass has them.
    struct Puma560;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute {
            d: 0.67183, alpha: PI/2,
            inertia: { yy: 0.35 },
            motor: { inertia: 200e-6, gear_ratio: -62.6111 },
            friction: { viscous: 5.80182176795, coulomb: 25.9836065 },
            allow: [unphysical_inertia],
        },
        shoulder: revolute {
            a: 0.4318,
            mass: 17.4, com: [-0.3638, 0.006, 0.2275],
            inertia: { xx: 0.13, yy: 0.524, zz: 0.539 },
            motor: { inertia: 200e-6, gear_ratio: 107.815 },
            friction: { viscous: 9.49686864183, coulomb: 10.6197775 },
        },
        elbow: revolute {
            d: 0.15005, a: 0.0203, alpha: -PI/2,
            mass: 4.8, com: [-0.0203, -0.0141, 0.07],
            inertia: { xx: 0.066, yy: 0.086, zz: 0.0125 },
            motor: { inertia: 200e-6, gear_ratio: -53.7063 },
            friction: { viscous: 3.98042599037, coulomb: 6.36419655 },
            allow: [unphysical_inertia],
        },
        wrist_roll: revolute {
            d: 0.4318, alpha: PI/2,
            mass: 0.82, com: [0, 0.019, 0],
            inertia: { xx: 1.8e-3, yy: 1.3e-3, zz: 1.8e-3 },
            motor: { inertia: 33e-6, gear_ratio: 76.0364 },
            friction: { viscous: 0.411645229697, coulomb: 1.06831142 },
        },
        wrist_pitch: revolute {
            alpha: -PI/2,
            mass: 0.34,
            inertia: { xx: 0.3e-3, yy: 0.4e-3, zz: 0.3e-3 },
            motor: { inertia: 33e-6, gear_ratio: 71.923 },
            friction: { viscous: 0.427283020935, coulomb: 0.85444524 },
        },
        flange: revolute {
            mass: 0.09, com: [0, 0, 0.032],
            inertia: { xx: 0.15e-3, yy: 0.15e-3, zz: 0.04e-3 },
            motor: { inertia: 33e-6, gear_ratio: 76.686 },
            friction: { viscous: 0.215823253273, coulomb: 0.55443978 },
        },
    ],
}

fn main() -> Result<(), Box<dyn Error>> {
    at_one_pose();
    operation_counts();
    let report = check_against_rnea(&Puma560);
    println!("\n{report}");
    report.assert_ok();
    free_fall()
}

/// M, V, G, F and tau at the toolbox's nominal pose, all joints moving at 1 rad/s.
fn at_one_pose() {
    let q = Vector6::new(0.0, FRAC_PI_4, PI, 0.0, FRAC_PI_4, 0.0);
    let (qd, qdd) = (Vector6::repeat(1.0), Vector6::zeros());
    println!(
        "PUMA 560 at q = {:.4?} rad, qd = 1 rad/s, qdd = 0",
        q.as_slice()
    );
    println!("\nM(q), kg m^2:{:9.4}", Puma560.mass_matrix(&q));
    let names = Puma560::JOINT_NAMES.map(|name| format!("{name:>12}"));
    println!("{:<18}{}", "N m", names.concat());
    for (name, value) in [
        ("V(q, qd)", Puma560.coriolis_vector(&q, &qd)),
        ("G(q)", Puma560.gravity_vector(&q)),
        ("F(qd)", Puma560.friction_vector(&qd)),
        ("tau(q, qd, qdd)", Puma560.inverse_dynamics(&q, &qd, &qdd)),
    ] {
        let entries: String = value.iter().map(|x| format!("{x:>12.4}")).collect();
        println!("{name:<18}{entries}");
    }
}

/// The cost of each generated function.
fn operation_counts() {
    println!(
        "\n{:<20}{:>8}{:>8}{:>8}{:>16}",
        "operations", "mul", "add", "div", "sin and cos"
    );
    for (name, count) in Puma560::OPERATIONS {
        println!(
            "{name:<20}{:>8}{:>8}{:>8}{:>16}",
            count.multiplications, count.additions, count.divisions, count.sin_cos
        );
    }
}

/// Two seconds of free fall with the arm stretched out horizontally. The motors cancel the
/// friction, so that the energy must stay, to the tolerance of the integrator. (The samples lie
/// between its steps: most of the error is that of the interpolation.)
fn free_fall() -> Result<(), Box<dyn Error>> {
    println!("\nFree fall of 2 s by Dormand-Prince 5(4)");
    println!("{:>12}{:>26}", "tolerance", "largest energy error, J");
    for tolerance in [1e-6, 1e-9, 1e-12] {
        let drift = fall(tolerance)?.energy_drift(&Puma560);
        println!("{tolerance:>12.0e}{drift:>26.1e}");
    }

    let run = fall(1e-12)?;
    let names = Puma560::JOINT_NAMES;
    let energies = run.energies(&Puma560);
    let errors = energies.iter().map(|energy| energy - energies[0]);
    let energy_error = Curve::new("T + U", &run.t, errors);
    Figure::new("PUMA 560: free fall from the stretched arm, friction cancelled")
        .panel("joint angles, rad", joints(names, &run.t, run.q))
        .panel("joint rates, rad/s", joints(names, &run.t, run.qd))
        .panel("energy error, J", [energy_error])
        .save("examples/output/puma560_free_fall.svg")
}

fn fall(tolerance: f64) -> Result<Trajectory<6>, Box<dyn Error>> {
    let method = DormandPrince::with_tolerance(tolerance);
    let run = Simulation::new(&Puma560)
        .torque(|_, _, qd| Puma560.friction_vector(qd))
        .method(Method::DormandPrince(method))
        .duration(2.0)
        .samples(401)
        .run()?;
    Ok(run)
}
