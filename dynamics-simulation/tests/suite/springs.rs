//! Springs at joints: in motion, beside Newton-Euler, and where they do nothing.

use robot_dynamics::nalgebra::{Vector1, Vector2};
use robot_dynamics::{
    DoubleDouble, Method, Simulation, TaylorSimulation, check_against_rnea, robot_dynamics,
    simulation::{Dop853, Radau5},
};

robot_dynamics! {
    /// A cart on a level rail, between the wall and a spring.
    struct Cart { mass: f64, stiffness: f64, rest: f64 }

    convention: standard,
    gravity: [0, 0, 0],
    joints: [slide: prismatic { mass: mass, spring: { stiffness: stiffness, rest: rest } }],
    functions: [
        mass_matrix, inverse_dynamics, forward_dynamics, kinetic_energy, potential_energy,
        spring_vector, taylor_series,
    ],
}

robot_dynamics! {
    /// Two rods in a vertical plane, one on a slide; a spring at each joint.
    struct Rods { mass: f64, stiffness: f64 }

    convention: modified,
    gravity: [-9.81, 0, 0],
    joints: [
        slide: prismatic {
            mass: 1.5, com: [0.1, 0, 0], inertia: cuboid(0.2, 0.1, 0.3),
            spring: { stiffness: stiffness, rest: 0.2 },
        },
        swing: revolute {
            alpha: PI/2, a: 0.1, mass: mass, com: [0.4, 0, 0], inertia: rod(0.8),
            spring: { stiffness: 3, rest: -PI/3 },
        },
    ],
    functions: [
        mass_matrix, coriolis_vector, gravity_vector, friction_vector, spring_vector,
        inverse_dynamics, forward_dynamics, kinetic_energy, potential_energy, bias_force,
        coriolis_matrix, inverse_dynamics_derivatives, forward_dynamics_derivatives, regressor,
        base_parameters, forward_dynamics_aba, taylor_series,
    ],
}

robot_dynamics! {
    /// The rods with their slide locked, away from where its spring is slack.
    struct LockedRods { mass: f64 }

    convention: modified,
    gravity: [-9.81, 0, 0],
    joints: [
        slide: prismatic {
            mass: 1.5, com: [0.1, 0, 0], inertia: cuboid(0.2, 0.1, 0.3),
            spring: { stiffness: 80, rest: 0.2 },
        },
        swing: revolute {
            alpha: PI/2, a: 0.1, mass: mass, com: [0.4, 0, 0], inertia: rod(0.8),
            spring: { stiffness: 3, rest: -PI/3 },
        },
    ],
    lock: [slide = 0.5],
}

const RODS: Rods = Rods {
    mass: 0.9,
    stiffness: 80.0,
};

/// x = rest + x0 cos(w t), w^2 = stiffness / mass: by every kind of method, in momenta and in series.
#[test]
fn a_cart_on_a_spring_swings_as_a_cosine() {
    let cart = Cart {
        mass: 2.0,
        stiffness: 18.0,
        rest: 0.25,
    };
    let at = |t: f64| 0.25 + 0.5 * (3.0 * t).cos();
    let [start, rest] = [at(0.0), 0.0].map(Vector1::new);
    let methods: [(Method, f64); 4] = [
        (Dop853::with_tolerance(1e-13).into(), 1e-10),
        (Radau5::with_tolerance(1e-12).into(), 1e-8),
        (Method::GaussLegendre6 { step: 0.02 }, 1e-9),
        (Method::RungeKutta4 { step: 0.002 }, 1e-9),
    ];
    for (method, bound) in methods {
        let swing = Simulation::new(&cart).initial(start, rest).duration(10.0);
        let swing = swing.method(method).run().unwrap();
        for (t, q) in swing.t.iter().zip(&swing.q) {
            let error = (q[0] - at(*t)).abs();
            assert!(error < bound, "{method:?} at {t}: {error:e}");
        }
        assert!(swing.energy_drift(&cart) < 10.0 * bound, "{method:?}");
    }
    let swing = TaylorSimulation::new(&cart).initial(start, rest);
    let swing = swing.duration(10.0).run().unwrap();
    for (t, q) in swing.t.iter().zip(&swing.q) {
        assert!((q[0] - at(*t)).abs() < 1e-12, "{t}");
    }
}

/// Energy of a motion that no closed form has, in long runs by a method that keeps it.
#[test]
fn swinging_rods_keep_their_energy() {
    let fall = Simulation::new(&RODS).initial(Vector2::new(0.3, 1.0), Vector2::new(-1.0, 2.0));
    let fall = fall.method(Method::GaussLegendre6 { step: 0.01 });
    let run = fall.duration(100.0).samples(1001).run().unwrap();
    assert!((run.q[1000] - run.q[0]).amax() > 0.01);
    let drift = run.energy_drift(&RODS);
    assert!(drift < 1e-7, "{drift:e} J");
}

#[test]
fn every_function_agrees_with_newton_euler() {
    for mass in [0.9, 3.0] {
        let rods = Rods { mass, ..RODS };
        check_against_rnea(&rods).assert_ok();
        check_against_rnea(&LockedRods { mass }).assert_ok();
    }
}

/// A spring whose joint is locked is as if it were not: its energy is none of the arm's either.
#[test]
fn the_spring_of_a_locked_joint_does_nothing() {
    let arm = LockedRods { mass: 0.9 };
    let (q, zero) = (Vector1::new(0.4), Vector1::zeros());
    let weight = 0.4 * 0.9 * 9.81;
    let tau = arm.inverse_dynamics(&q, &zero, &zero)[0];
    let own = 3.0 * (0.4 + core::f64::consts::PI / 3.0);
    assert!((tau - arm.gravity_vector(&q)[0] - own).abs() < 1e-14);
    assert!((arm.gravity_vector(&q)[0].abs() - weight * 0.4_f64.sin()).abs() < 1e-14);
    let slack = Vector1::new(-core::f64::consts::PI / 3.0);
    let energies = [q, slack].map(|q| arm.potential_energy(&q));
    let heights = [q, slack].map(|q| weight * q[0].cos());
    let stretched = energies[0] - energies[1] - (heights[0] - heights[1]);
    let expected = 0.5 * own * own / 3.0;
    assert!((stretched - expected).abs() < 1e-13, "{stretched}");
}

/// Far from rest K loses nothing: the difference q - rest is taken first.
#[test]
fn a_spring_that_is_nearly_slack_keeps_its_digits() {
    let rest = 1e6 + 1.0 / 3.0;
    let cart = Cart {
        mass: 2.0,
        stiffness: 18.0,
        rest,
    };
    let q = rest + 1e-9;
    let found = cart.spring_vector(&Vector1::new(q))[0];
    let q = Vector1::new(DoubleDouble::from(q));
    let exact = cart.spring_vector(&q)[0].high();
    assert!(exact != 0.0 && (found - exact).abs() <= 1e-15 * exact);
}
