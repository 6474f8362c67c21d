//! Two point masses on massless links, parameters left as symbols; the configuration-space form;
//! and the Euler scheme of the book beside an integrator of fifth order.
//!
//! After J. J. Craig, *Introduction to Robotics*, chapter 6: (6.60) to (6.62) for M, V and G,
//! (6.63) for the configuration-space form, (6.117) for the Euler scheme.
//!
//! ```text
//! cargo run --release --example two_link_craig
//! ```

mod compare;

use std::error::Error;

use robot_dynamics::plot::{Curve, Figure, joints};
use robot_dynamics::{
    Method, Simulation, Trajectory, nalgebra::Vector2, robot_dynamics, simulation::DormandPrince,
};

robot_dynamics! {
    /// Two-link arm with point masses at the distal ends of its links, angles from the horizontal.
    struct TwoLink { m1: f64, m2: f64, l1: f64, l2: f64, g: f64 }

    convention: modified,
    gravity: [0, -g, 0],
    joints: [
        shoulder: revolute { mass: m1, com: [l1, 0, 0] },
        elbow:    revolute { a: l1, mass: m2, com: [l2, 0, 0] },
    ],
    functions: [
        mass_matrix, coriolis_vector, gravity_vector, forward_dynamics,
        kinetic_energy, potential_energy,
        coriolis_coefficients, centrifugal_coefficients,
    ],
}

const ARM: TwoLink = TwoLink {
    m1: 4.6,
    m2: 2.3,
    l1: 0.5,
    l2: 0.3,
    g: 9.81,
};

fn main() -> Result<(), Box<dyn Error>> {
    let (q, qd) = (Vector2::new(0.4, 0.9), Vector2::new(1.5, -0.8));
    state_space_form(&ARM, &q, &qd);
    configuration_space_form(&ARM, &q, &qd);
    order_of_the_euler_scheme()?;
    plot_the_euler_scheme()
}

/// (6.60) to (6.62).
fn state_space_form(arm: &TwoLink, q: &Vector2<f64>, qd: &Vector2<f64>) {
    let TwoLink { m1, m2, l1, l2, g } = *arm;
    let (s2, c2) = q[1].sin_cos();
    let (c1, c12) = (q[0].cos(), (q[0] + q[1]).cos());
    let (mass, coriolis, gravity) = (
        arm.mass_matrix(q),
        arm.coriolis_vector(q, qd),
        arm.gravity_vector(q),
    );

    compare::heading("State-space form, th = (0.4, 0.9), thd = (1.5, -0.8)");
    compare::row(
        "M11 = l2^2 m2 + 2 l1 l2 m2 c2 + l1^2 (m1 + m2)",
        mass[(0, 0)],
        l2 * l2 * m2 + 2.0 * l1 * l2 * m2 * c2 + l1 * l1 * (m1 + m2),
    );
    compare::row(
        "M12 = l2^2 m2 + l1 l2 m2 c2",
        mass[(0, 1)],
        l2 * l2 * m2 + l1 * l2 * m2 * c2,
    );
    compare::row("M22 = l2^2 m2", mass[(1, 1)], l2 * l2 * m2);
    compare::row(
        "V1 = -m2 l1 l2 s2 thd2^2 - 2 m2 l1 l2 s2 thd1 thd2",
        coriolis[0],
        -m2 * l1 * l2 * s2 * qd[1] * qd[1] - 2.0 * m2 * l1 * l2 * s2 * qd[0] * qd[1],
    );
    compare::row(
        "V2 = m2 l1 l2 s2 thd1^2",
        coriolis[1],
        m2 * l1 * l2 * s2 * qd[0] * qd[0],
    );
    compare::row(
        "G1 = m2 l2 g c12 + (m1 + m2) l1 g c1",
        gravity[0],
        m2 * l2 * g * c12 + (m1 + m2) * l1 * g * c1,
    );
    compare::row("G2 = m2 l2 g c12", gravity[1], m2 * l2 * g * c12);
}

/// (6.63): tau = M thdd + B [thd1 thd2] + C [thd1^2, thd2^2] + G.
fn configuration_space_form(arm: &TwoLink, q: &Vector2<f64>, qd: &Vector2<f64>) {
    let b = arm.coriolis_coefficients(q);
    let c = arm.centrifugal_coefficients(q);
    let h = arm.m2 * arm.l1 * arm.l2 * q[1].sin();

    compare::heading("Configuration-space form");
    compare::row("B1 = -2 m2 l1 l2 s2", b[(0, 0)], -2.0 * h);
    compare::row("B2 = 0", b[(1, 0)], 0.0);
    compare::row("C11 = 0", c[(0, 0)], 0.0);
    compare::row("C12 = -m2 l1 l2 s2", c[(0, 1)], -h);
    compare::row("C21 = m2 l1 l2 s2", c[(1, 0)], h);
    compare::row("C22 = 0", c[(1, 1)], 0.0);

    let v = arm.coriolis_vector(q, qd);
    let from_coefficients = b * (qd[0] * qd[1]) + c * qd.component_mul(qd);
    compare::row(
        "B [thd thd] + C [thd^2] = V, row 1",
        v[0],
        from_coefficients[0],
    );
    compare::row(
        "B [thd thd] + C [thd^2] = V, row 2",
        v[1],
        from_coefficients[1],
    );
}

/// Halving the step of (6.117) halves its error: the scheme is of first order.
fn order_of_the_euler_scheme() -> Result<(), Box<dyn Error>> {
    let exact = fall(
        Method::DormandPrince(DormandPrince::with_tolerance(1e-13)),
        1.0,
        2,
    )?
    .q[1];
    println!("\nFree fall from the horizontal: error of Craig's Euler scheme after 1 s");
    println!("  {:>9} {:>12} {:>7}", "step, s", "error, rad", "ratio");
    let mut previous = None;
    for step in [1e-3, 5e-4, 2.5e-4, 1.25e-4] {
        let error = (fall(Method::CraigEuler { step }, 1.0, 2)?.q[1] - exact).norm();
        let ratio = previous.map_or(String::new(), |p: f64| format!("{:.3}", p / error));
        println!("  {step:>9.2e} {error:>12.4e} {ratio:>7}");
        previous = Some(error);
    }
    Ok(())
}

/// The cost of first order: steps of 5 ms beside Dormand-Prince, angles and energy.
fn plot_the_euler_scheme() -> Result<(), Box<dyn Error>> {
    let euler = fall(Method::CraigEuler { step: 5e-3 }, 3.0, 301)?;
    let reference = fall(Method::default(), 3.0, 301)?;
    let energies = [
        Curve::new("Dormand-Prince", &reference.t, reference.energies(&ARM)),
        Curve::new("Euler", &euler.t, euler.energies(&ARM)),
    ];
    let dormand_prince = joints(
        ["shoulder, D.-P.", "elbow, D.-P."],
        &reference.t,
        reference.q,
    );
    let euler = joints(["shoulder, Euler", "elbow, Euler"], &euler.t, euler.q);
    Figure::new("Craig's Euler scheme, step 5 ms, beside Dormand-Prince")
        .panel("angles, rad", dormand_prince.into_iter().chain(euler))
        .panel("T + U, J", energies)
        .save("examples/output/two_link_craig_euler.svg")
}

/// Free fall from rest in the horizontal position.
fn fall(method: Method, duration: f64, samples: usize) -> Result<Trajectory<2>, Box<dyn Error>> {
    let run = Simulation::new(&ARM)
        .method(method)
        .initial(Vector2::zeros(), Vector2::zeros())
        .duration(duration)
        .samples(samples)
        .run()?;
    Ok(run)
}
