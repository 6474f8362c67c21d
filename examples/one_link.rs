//! A slender rod that swings about its end: closed form, inverse dynamics, free swing.
//!
//! After Saha's lecture slides *Robot Dynamics: Euler-Lagrange Formulation*:
//! `(1/3) m a^2 thdd + (1/2) m g a sin th = tau`, th = 0 where the rod hangs.
//!
//! ```text
//! cargo run --release --example one_link
//! ```

mod compare;

use std::{
    error::Error,
    f64::consts::{FRAC_PI_2, PI},
};

use robot_dynamics::plot::{Figure, joints};
use robot_dynamics::{Cycloidal, Simulation, nalgebra::Vector1, robot_dynamics};

robot_dynamics! {
    /// A slender rod of mass m and length a; gravity points along x of the base.
    struct OneLink { m: f64, a: f64, g: f64 }

    convention: standard,
    gravity: [g, 0, 0],
    joints: [
        pivot: revolute { a: a, mass: m, com: [-a / 2, 0, 0], inertia: rod(a) },
    ],
}

/// The slides' numbers.
const ROD: OneLink = OneLink {
    m: 1.0,
    a: 1.0,
    g: 9.81,
};

fn main() -> Result<(), Box<dyn Error>> {
    closed_form(&OneLink {
        m: 1.7,
        a: 0.6,
        g: 9.81,
    })?;
    inverse_dynamics()?;
    free_swing()?;
    after_five_periods()
}

/// The generated functions beside the formulas, for a rod with other numbers than the slides'.
fn closed_form(rod: &OneLink) -> Result<(), Box<dyn Error>> {
    let OneLink { m, a, g } = *rod;
    let (th, thd, thdd, tau) = (0.7, 1.9, -1.3, 0.3);
    let (q, qd) = (Vector1::new(th), Vector1::new(thd));
    let torque = rod.inverse_dynamics(&q, &qd, &Vector1::new(thdd))[0];
    let acceleration = rod.forward_dynamics(&q, &qd, &Vector1::new(tau))?[0];

    compare::heading("One-link arm, m = 1.7, a = 0.6, th = 0.7");
    compare::row("M = m a^2/3", rod.mass_matrix(&q)[0], m * a * a / 3.0);
    compare::row("V = 0", rod.coriolis_vector(&q, &qd)[0], 0.0);
    compare::row(
        "G = m g (a/2) sin th",
        rod.gravity_vector(&q)[0],
        m * g * a / 2.0 * th.sin(),
    );
    compare::row(
        "T = m a^2 thd^2/6",
        rod.kinetic_energy(&q, &qd),
        m * a * a * thd * thd / 6.0,
    );
    compare::row(
        "U = -m g (a/2) cos th",
        rod.potential_energy(&q),
        -m * g * a / 2.0 * th.cos(),
    );
    compare::row(
        "tau = (1/3) m a^2 thdd + (1/2) m g a sin th",
        torque,
        m * a * a * thdd / 3.0 + m * g * a * th.sin() / 2.0,
    );
    compare::row(
        "thdd = 3/(m a^2) (tau - (1/2) m g a sin th)",
        acceleration,
        3.0 / (m * a * a) * (tau - m * g * a * th.sin() / 2.0),
    );
    let printed = 2.0 / (m * a * a) * (tau - m * g * a * th.sin() / 2.0);
    println!("  (the slides print 2/(m a^2), which gives {printed:.9}: a misprint)");
    Ok(())
}

/// The torque along the cycloidal law from th = 0 to th = pi in 10 s, at the slides' 51 instants.
fn inverse_dynamics() -> Result<(), Box<dyn Error>> {
    let law = Cycloidal::new(Vector1::new(0.0), Vector1::new(PI), 10.0)?;
    let t: Vec<f64> = (0..=50).map(|k| 0.2 * k as f64).collect();
    let points: Vec<_> = t.iter().map(|&t| law.at(t)).collect();
    let tau: Vec<f64> = points
        .iter()
        .map(|p| ROD.inverse_dynamics(&p.q, &p.qd, &p.qdd)[0])
        .collect();

    compare::heading("Inverse dynamics on the cycloidal law, m = a = 1");
    for k in [5, 15, 25, 40] {
        let (th, thdd) = (points[k].q[0], points[k].qdd[0]);
        compare::row(
            &format!("tau at t = {:.0} s, thdd/3 + (9.81/2) sin th", t[k]),
            tau[k],
            thdd / 3.0 + 9.81 / 2.0 * th.sin(),
        );
    }

    let torques = tau.into_iter().map(Vector1::new);
    Figure::new("One-link arm: inverse dynamics on the cycloidal law")
        .panel("th, rad", joints(["angle"], &t, points.iter().map(|p| p.q)))
        .panel(
            "thd, rad/s",
            joints(["rate"], &t, points.iter().map(|p| p.qd)),
        )
        .panel(
            "thdd, rad/s^2",
            joints(["acceleration"], &t, points.iter().map(|p| p.qdd)),
        )
        .panel("tau, N m", joints(["torque"], &t, torques))
        .save("examples/output/one_link_inverse_dynamics.svg")
}

/// Ten seconds from rest at 90 degrees, as in the slides' `ode45` run.
fn free_swing() -> Result<(), Box<dyn Error>> {
    let run = Simulation::new(&ROD)
        .initial(Vector1::new(FRAC_PI_2), Vector1::zeros())
        .duration(10.0)
        .samples(501)
        .run()?;

    println!("\nFree swing from 90 degrees, 10 s");
    println!("  th(10 s) = {:.6} rad", run.q[500][0]);
    println!(
        "  largest energy error {:.1e} J, of a swing of 4.905 J",
        run.energy_drift(&ROD)
    );

    Figure::new("One-link arm: free swing from 90 degrees")
        .panel("th, rad", joints(["angle"], &run.t, run.q))
        .panel("thd, rad/s", joints(["rate"], &run.t, run.qd))
        .save("examples/output/one_link_free_swing.svg")
}

/// A swing is periodic: the run that ends after five periods must end where it began.
fn after_five_periods() -> Result<(), Box<dyn Error>> {
    let period = period(&ROD, FRAC_PI_2);
    let run = Simulation::new(&ROD)
        .initial(Vector1::new(FRAC_PI_2), Vector1::zeros())
        .duration(5.0 * period)
        .samples(2)
        .run()?;
    let error = run.q[1][0] - FRAC_PI_2;
    println!("  period {period:.9} s; after five of them th is off by {error:.1e} rad");
    Ok(())
}

/// The period of a swing with amplitude `th0`: 2 pi/w over the arithmetic-geometric mean of 1 and
/// cos(th0/2), with w^2 = 3 g/(2 a) (Gauss's form of the complete elliptic integral).
fn period(rod: &OneLink, th0: f64) -> f64 {
    let w = (1.5 * rod.g / rod.a).sqrt();
    let (mut x, mut y) = (1.0, (th0 / 2.0).cos());
    while x - y > 1e-15 {
        (x, y) = ((x + y) / 2.0, f64::sqrt(x * y));
    }
    2.0 * PI / (w * x)
}
