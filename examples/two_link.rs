//! Two slender rods in a vertical plane: formulas, inverse dynamics, free fall, and a misprint.
//!
//! After Saha's lecture slides *Robot Dynamics: Euler-Lagrange Formulation*; angles from the
//! horizontal. i_11, i_12, i_22 are the entries of M, h is V, gamma is G.
//!
//! ```text
//! cargo run --release --example two_link
//! ```

mod compare;

use std::{
    error::Error,
    f64::consts::{FRAC_PI_2, PI},
};

use robot_dynamics::plot::{Curve, Figure, joints};
use robot_dynamics::{
    Cycloidal, Simulation,
    nalgebra::{Matrix2, Vector2},
    robot_dynamics,
};

robot_dynamics! {
    /// Two slender rods of masses m1, m2 and lengths a1, a2.
    struct TwoLink { m1: f64, m2: f64, a1: f64, a2: f64, g: f64 }

    convention: standard,
    gravity: [0, -g, 0],
    joints: [
        shoulder: revolute { a: a1, mass: m1, com: [-a1 / 2, 0, 0], inertia: rod(a1) },
        elbow:    revolute { a: a2, mass: m2, com: [-a2 / 2, 0, 0], inertia: rod(a2) },
    ],
}

/// The slides' numbers.
const ARM: TwoLink = TwoLink {
    m1: 3.0,
    m2: 1.0,
    a1: 2.0,
    a2: 1.0,
    g: 9.81,
};

fn main() -> Result<(), Box<dyn Error>> {
    let (q, qd) = (Vector2::new(0.4, 0.9), Vector2::new(1.5, -0.8));
    equations_of_motion(&ARM, &q, &qd);
    from_the_jacobians(&ARM, &q);
    inverse_dynamics()?;
    free_fall()
}

/// The generated functions beside the slides' formulas.
fn equations_of_motion(arm: &TwoLink, q: &Vector2<f64>, qd: &Vector2<f64>) {
    let TwoLink { m1, m2, a1, a2, g } = *arm;
    let (i1, i2) = (m1 * a1 * a1 / 12.0, m2 * a2 * a2 / 12.0);
    let (s2, c2) = q[1].sin_cos();
    let (c1, c12) = (q[0].cos(), (q[0] + q[1]).cos());
    let (mass, coriolis, gravity) = (
        arm.mass_matrix(q),
        arm.coriolis_vector(q, qd),
        arm.gravity_vector(q),
    );

    compare::heading("Two-link arm, m = (3, 1), a = (2, 1), th = (0.4, 0.9), thd = (1.5, -0.8)");
    compare::row(
        "i11 = m1 a1^2/4 + I1 + m2 (a1^2 + a2^2/4 + a1 a2 c2) + I2",
        mass[(0, 0)],
        m1 * a1 * a1 / 4.0 + i1 + m2 * (a1 * a1 + a2 * a2 / 4.0 + a1 * a2 * c2) + i2,
    );
    compare::row(
        "i12 = m2 (a2^2/4 + a1 a2 c2/2) + I2",
        mass[(0, 1)],
        m2 * (a2 * a2 / 4.0 + a1 * a2 * c2 / 2.0) + i2,
    );
    compare::row(
        "i22 = m2 a2^2/4 + I2",
        mass[(1, 1)],
        m2 * a2 * a2 / 4.0 + i2,
    );
    compare::row(
        "h1 = -m2 a1 a2 s2 thd1 thd2 - m2 (a1 a2/2) s2 thd2^2",
        coriolis[0],
        -m2 * a1 * a2 * s2 * qd[0] * qd[1] - m2 * a1 * a2 / 2.0 * s2 * qd[1] * qd[1],
    );
    compare::row(
        "h2 = m2 (a1 a2/2) s2 thd1^2",
        coriolis[1],
        m2 / 2.0 * a1 * a2 * s2 * qd[0] * qd[0],
    );
    compare::row(
        "gamma1 = m1 g (a1/2) c1 + m2 g (a1 c1 + (a2/2) c12)",
        gravity[0],
        m1 * g * a1 / 2.0 * c1 + m2 * g * (a1 * c1 + a2 / 2.0 * c12),
    );
    compare::row(
        "gamma2 = m2 g (a2/2) c12",
        gravity[1],
        m2 * g * a2 / 2.0 * c12,
    );
    let printed = printed_gamma2(arm, q);
    println!("  (the slides print m1 in gamma2, which gives {printed:.9}: a misprint)");
}

/// gamma_2 as the slides print it, with m1 in place of m2.
fn printed_gamma2(arm: &TwoLink, q: &Vector2<f64>) -> f64 {
    arm.m1 * arm.g * arm.a2 / 2.0 * (q[0] + q[1]).cos()
}

/// The slides' general formulas: M = sum_j m_j Jc_j' Jc_j + Jw_j' I_j Jw_j, and
/// gamma_i = -sum_j m_j g . (column i of Jc_j).
fn from_the_jacobians(arm: &TwoLink, q: &Vector2<f64>) {
    let TwoLink { m1, m2, a1, a2, g } = *arm;
    let jc = centre_jacobians(arm, q);
    let (jw1, jw2) = (Vector2::new(1.0, 0.0), Vector2::new(1.0, 1.0));
    let mass = m1 * jc[0].transpose() * jc[0]
        + m1 * a1 * a1 / 12.0 * jw1 * jw1.transpose()
        + m2 * jc[1].transpose() * jc[1]
        + m2 * a2 * a2 / 12.0 * jw2 * jw2.transpose();
    let weight = [Vector2::new(0.0, -m1 * g), Vector2::new(0.0, -m2 * g)];
    let gamma = |i: usize| -(0..2).map(|j| jc[j].column(i).dot(&weight[j])).sum::<f64>();
    let printed = |i: usize| -(0..2).map(|j| jc[i].column(j).dot(&weight[j])).sum::<f64>();

    let generated = arm.mass_matrix(q);
    compare::heading("The same from the Jacobians of the centres of mass");
    compare::row("i11", generated[(0, 0)], mass[(0, 0)]);
    compare::row("i12", generated[(0, 1)], mass[(0, 1)]);
    compare::row("i22", generated[(1, 1)], mass[(1, 1)]);
    compare::row(
        "gamma1 = -sum_j m_j g . (column 1 of Jc_j)",
        arm.gravity_vector(q)[0],
        gamma(0),
    );
    compare::row(
        "gamma2 = -sum_j m_j g . (column 2 of Jc_j)",
        arm.gravity_vector(q)[1],
        gamma(1),
    );
    println!(
        "  (with i and j interchanged, as printed: {:.4} and {:.4})",
        printed(0),
        printed(1)
    );
}

/// Velocities of the two centres of mass per unit joint rates, in the plane.
fn centre_jacobians(arm: &TwoLink, q: &Vector2<f64>) -> [Matrix2<f64>; 2] {
    let (s1, c1) = q[0].sin_cos();
    let (s12, c12) = (q[0] + q[1]).sin_cos();
    let (a1, half1, half2) = (arm.a1, arm.a1 / 2.0, arm.a2 / 2.0);
    [
        Matrix2::new(-half1 * s1, 0.0, half1 * c1, 0.0),
        Matrix2::new(
            -a1 * s1 - half2 * s12,
            -half2 * s12,
            a1 * c1 + half2 * c12,
            half2 * c12,
        ),
    ]
}

/// Torques along the cycloidal law from rest at (0, 0) to rest at (pi, pi/2) in 10 s. (The slides
/// show the curves without their end values; these are ours.)
fn inverse_dynamics() -> Result<(), Box<dyn Error>> {
    let law = Cycloidal::new(Vector2::zeros(), Vector2::new(PI, FRAC_PI_2), 10.0)?;
    let t: Vec<f64> = (0..=50).map(|k| 0.2 * k as f64).collect();
    let points: Vec<_> = t.iter().map(|&t| law.at(t)).collect();
    let tau: Vec<Vector2<f64>> = points
        .iter()
        .map(|p| ARM.inverse_dynamics(&p.q, &p.qd, &p.qdd))
        .collect();

    println!("\nInverse dynamics on the cycloidal law");
    println!(
        "  {:>4} {:>10} {:>10} {:>12} {:>12}",
        "t, s", "th1, rad", "th2, rad", "tau1, N m", "tau2, N m"
    );
    for k in (0..=50).step_by(10) {
        let (q, tau) = (points[k].q, tau[k]);
        println!(
            "  {:4.0} {:10.6} {:10.6} {:12.6} {:12.6}",
            t[k], q[0], q[1], tau[0], tau[1]
        );
    }

    let names = TwoLink::JOINT_NAMES;
    Figure::new("Two-link arm: inverse dynamics on the cycloidal law")
        .panel("angles, rad", joints(names, &t, points.iter().map(|p| p.q)))
        .panel(
            "rates, rad/s",
            joints(names, &t, points.iter().map(|p| p.qd)),
        )
        .panel(
            "accelerations, rad/s^2",
            joints(names, &t, points.iter().map(|p| p.qdd)),
        )
        .panel("torques, N m", joints(names, &t, tau))
        .save("examples/output/two_link_inverse_dynamics.svg")
}

/// Ten seconds of free fall from rest in the horizontal position, with gamma_2 right and as
/// printed. The misprint acts as a torque (0, gamma_2 - printed gamma_2) on the right arm.
fn free_fall() -> Result<(), Box<dyn Error>> {
    let from_rest = || {
        Simulation::new(&ARM)
            .initial(Vector2::zeros(), Vector2::zeros())
            .duration(10.0)
            .samples(1001)
    };
    let right = from_rest().run()?;
    let misprinted = from_rest()
        .torque(|_, q, _| Vector2::new(0.0, ARM.gravity_vector(q)[1] - printed_gamma2(&ARM, q)))
        .run()?;
    println!("\nFree fall from the horizontal, 10 s");
    println!(
        "  th(10 s) = ({:.6}, {:.6}) rad",
        right.q[1000][0], right.q[1000][1]
    );
    println!(
        "  largest energy error                        {:8.1e} J",
        right.energy_drift(&ARM)
    );
    println!(
        "  the same with gamma2 as printed, m1 for m2  {:8.1e} J",
        misprinted.energy_drift(&ARM)
    );

    let energies = [
        Curve::new("gamma2 with m2", &right.t, right.energies(&ARM)),
        Curve::new("as printed, m1", &misprinted.t, misprinted.energies(&ARM)),
    ];
    Figure::new("Two-link arm: free fall from the horizontal")
        .panel(
            "angles, rad",
            joints(TwoLink::JOINT_NAMES, &right.t, right.q),
        )
        .panel(
            "rates, rad/s",
            joints(TwoLink::JOINT_NAMES, &right.t, right.qd),
        )
        .save("examples/output/two_link_free_fall.svg")?;
    Figure::new("Two-link arm in free fall: the energy shows the misprint")
        .panel("T + U, J", energies)
        .save("examples/output/two_link_misprint.svg")
}
