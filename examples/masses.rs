//! One degree of freedom: a moving mass, a mass that is lifted and controlled, a geared link.
//!
//! The moving mass is from Saha's slides *Robot Dynamics: Euler-Lagrange Formulation*, the others
//! from Flores's slides *Dynamics*.
//!
//! ```text
//! cargo run --release --example masses
//! ```

mod compare;

use std::error::Error;

use robot_dynamics::plot::{Figure, joints};
use robot_dynamics::{Simulation, Trajectory, nalgebra::Vector1, robot_dynamics};

robot_dynamics! {
    /// A mass on a horizontal rail: m xdd = f.
    struct MovingMass { m: f64 }

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [rail: prismatic { mass: m }],
    functions: [forward_dynamics, kinetic_energy, potential_energy],
}

robot_dynamics! {
    /// A mass on a vertical rail: m ydd = f - m g.
    struct VerticalMass { m: f64, g: f64 }

    convention: standard,
    gravity: [0, 0, -g],
    joints: [lift: prismatic { mass: m }],
}

robot_dynamics! {
    /// A link driven through a gear: (r^2 jm + jl) thdd + m g l sin th = tau, where jl is the
    /// link's inertia about the joint's axis. The table wants it about the centre of mass.
    struct GearedLink { m: f64, l: f64, jl: f64, jm: f64, r: f64, g: f64 }

    convention: modified,
    gravity: [g, 0, 0],
    joints: [
        pivot: revolute {
            mass: m, com: [l, 0, 0],
            inertia: { zz: jl - m * l * l },
            motor: { inertia: jm, gear_ratio: r },
        },
    ],
}

const LIFT: VerticalMass = VerticalMass { m: 1.0, g: 9.81 };

fn main() -> Result<(), Box<dyn Error>> {
    moving_mass()?;
    constant_force()?;
    position_control()?;
    geared_link()
}

/// m xdd = f.
fn moving_mass() -> Result<(), Box<dyn Error>> {
    let mass = MovingMass { m: 2.0 };
    let (x, xd, f) = (Vector1::new(0.4), Vector1::new(1.1), Vector1::new(3.0));
    compare::heading("Moving mass, m = 2, f = 3");
    compare::row("xdd = f/m", mass.forward_dynamics(&x, &xd, &f)?[0], 1.5);
    compare::row("T = m xd^2/2", mass.kinetic_energy(&x, &xd), 1.21);
    compare::row("U = 0", mass.potential_energy(&x), 0.0);
    Ok(())
}

/// The listing of the slides: f = 10 N on m = 1 kg from y = 5 m, v = 8 m/s, for 10 s.
fn constant_force() -> Result<(), Box<dyn Error>> {
    let run = lift(|_, _| 10.0)?;
    compare::heading("Vertical mass, f = 10, y0 = 5, v0 = 8, after 10 s");
    let (y, v) = (run.q[1000][0], run.qd[1000][0]);
    compare::row(
        "y = y0 + v0 t + (f/m - g) t^2/2",
        y,
        5.0 + 80.0 + (10.0 - 9.81) * 50.0,
    );
    compare::row("v = v0 + (f/m - g) t", v, 8.0 + (10.0 - 9.81) * 10.0);
    Figure::new("Vertical mass under a constant force of 10 N")
        .panel("position, m", joints(["y"], &run.t, run.q))
        .panel("velocity, m/s", joints(["v"], &run.t, run.qd))
        .save("examples/output/vertical_mass.svg")
}

/// A proportional-derivative law with gravity cancelled, f = m g - 10 y - 7 v, and the law as the
/// slides print it, f = -m g - 10 y - 7 v. With m = 1 the right one gives
/// y = 11 exp(-2 t) - 6 exp(-5 t) from y0 = 5, v0 = 8.
fn position_control() -> Result<(), Box<dyn Error>> {
    let weight = LIFT.m * LIFT.g;
    let right = lift(|y, v| weight - 10.0 * y - 7.0 * v)?;
    let printed = lift(|y, v| -weight - 10.0 * y - 7.0 * v)?;
    let exact = |t: f64| 11.0 * (-2.0 * t).exp() - 6.0 * (-5.0 * t).exp();
    let error = (0..right.t.len())
        .map(|k| (right.q[k][0] - exact(right.t[k])).abs())
        .fold(0.0, f64::max);

    println!("\nVertical mass held at y = 0");
    println!(
        "  f = +m g - 10 y - 7 v: largest distance to 11 exp(-2 t) - 6 exp(-5 t) {error:.0e} m"
    );
    println!(
        "  f = -m g - 10 y - 7 v (as printed) comes to rest at y = {:.4} m",
        printed.q[1000][0]
    );
    let right = joints(["+m g - 10 y - 7 v"], &right.t, right.q);
    let printed = joints(["-m g, as printed"], &printed.t, printed.q);
    Figure::new("Vertical mass held at y = 0: the sign of m g in the control law")
        .panel("position, m", right.into_iter().chain(printed))
        .save("examples/output/vertical_mass_control.svg")
}

/// (r^2 jm + jl) thdd + m g l sin th = tau.
fn geared_link() -> Result<(), Box<dyn Error>> {
    let link = GearedLink {
        m: 1.5,
        l: 0.4,
        jl: 0.32,
        jm: 1e-4,
        r: 50.0,
        g: 9.81,
    };
    let (th, thd, tau): (f64, f64, f64) = (0.7, 2.0, 5.0);
    let (q, qd) = (Vector1::new(th), Vector1::new(thd));
    let acceleration = link.forward_dynamics(&q, &qd, &Vector1::new(tau))?[0];
    let j = link.r * link.r * link.jm + link.jl;
    let weight = link.m * link.g * link.l * th.sin();

    compare::heading("Geared link, r = 50, th = 0.7");
    compare::row("M = J = r^2 Jm + Jl", link.mass_matrix(&q)[0], j);
    compare::row("G = m g l sin th", link.gravity_vector(&q)[0], weight);
    compare::row(
        "T = J thd^2/2",
        link.kinetic_energy(&q, &qd),
        j * thd * thd / 2.0,
    );
    compare::row(
        "thdd = (tau - m g l sin th)/J",
        acceleration,
        (tau - weight) / j,
    );
    Ok(())
}

/// Ten seconds of the vertical mass under the force `f(y, v)`.
fn lift(force: impl Fn(f64, f64) -> f64) -> Result<Trajectory<1>, Box<dyn Error>> {
    let run = Simulation::new(&LIFT)
        .torque(|_, y, v| Vector1::new(force(y[0], v[0])))
        .initial(Vector1::new(5.0), Vector1::new(8.0))
        .duration(10.0)
        .samples(1001)
        .run()?;
    Ok(run)
}
