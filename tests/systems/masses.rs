//! One degree of freedom: a moving mass, a mass that is lifted, a link behind a gear.

use robot_dynamics::nalgebra::Vector1;
use robot_dynamics::{Method, Simulation, robot_dynamics};
use testkit::random::Random;
use testkit::references::{MotionFile, read};

use crate::{assert_near, largest, precise};

robot_dynamics! {
    /// A mass that slides across gravity (Saha): m xdd = f.
    struct MovingMass { m: f64 }

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [slider: prismatic { mass: m }],
}

robot_dynamics! {
    /// A mass that is lifted (Flores): m ydd = f - m g.
    struct VerticalMass { m: f64, g: f64 }

    convention: standard,
    gravity: [0, 0, -g],
    joints: [lift: prismatic { mass: m }],
}

robot_dynamics! {
    /// A link behind a gear (Flores): J thdd + m g l sin th = tau with J = r^2 Jm + Jl, where Jl
    /// is about the joint's axis.
    struct GearedLink { m: f64, l: f64, i: f64, jm: f64, r: f64, g: f64 }

    convention: modified,
    gravity: [g, 0, 0],
    joints: [
        joint: revolute {
            mass: m, com: [l, 0, 0],
            inertia: { zz: i },
            motor: { inertia: jm, gear_ratio: r },
        },
    ],
}

#[test]
fn the_moving_mass_obeys_newton() {
    let mass = MovingMass { m: 2.0 };
    let [x, xd, xdd] = [7.0, 3.0, -1.5].map(Vector1::new);
    assert_eq!(mass.mass_matrix(&x)[0], 2.0);
    assert_eq!(mass.coriolis_vector(&x, &xd)[0], 0.0);
    assert_eq!(mass.gravity_vector(&x)[0], 0.0);
    assert_eq!(mass.potential_energy(&x), 0.0);
    assert_eq!(mass.kinetic_energy(&x, &xd), 9.0);
    assert_eq!(mass.inverse_dynamics(&x, &xd, &xdd)[0], -3.0);
    let found = mass.forward_dynamics(&x, &xd, &Vector1::new(5.0));
    assert_eq!(found.expect("a mass")[0], 2.5);
}

#[test]
fn the_vertical_mass_obeys_newton() {
    let mass = VerticalMass { m: 1.5, g: 9.81 };
    let [y, yd] = [5.0, 8.0].map(Vector1::new);
    let force = Vector1::new(10.0);
    let found = mass.forward_dynamics(&y, &yd, &force).expect("a mass")[0];
    assert_near(found, (10.0 - 1.5 * 9.81) / 1.5, 10.0);
    assert_near(mass.potential_energy(&y), 1.5 * 9.81 * 5.0, 75.0);
}

/// f = 10, y0 = 5, v0 = 8, 10 s. Both methods integrate a constant acceleration without error, so
/// that roundings remain: those of a thousand steps at 90 m.
#[test]
fn the_vertical_mass_rises_under_a_constant_force() {
    let mass = VerticalMass { m: 1.0, g: 9.81 };
    let exact: MotionFile = read("trajectories", "vertical_mass_f10");
    let (y, v) = exact.initial();
    assert_eq!((y[0], v[0]), (5.0, 8.0));
    for method in [precise(), Method::CraigEuler { step: 1e-2 }] {
        let simulation = Simulation::new(&mass).initial(y, v).method(method);
        let pushed = simulation.torque(|_, _, _| Vector1::new(10.0));
        let motion = pushed.duration(10.0).samples(51).run().expect("a motion");
        assert!(largest(&exact.errors(&motion)) < 1e-11);
    }
}

/// f = m g - 10 y - 7 v brings the mass to rest at 0: y = 11 e^(-2t) - 6 e^(-5t) from y0 = 5,
/// v0 = 8. The slides have -m g, which doubles gravity: the mass hangs at -m g/5.
#[test]
fn the_controlled_mass_settles_where_gravity_is_cancelled() {
    let mass = VerticalMass { m: 1.0, g: 9.81 };
    let settle = |feed_forward: f64| {
        let law = move |_, y: &Vector1<f64>, v: &Vector1<f64>| {
            Vector1::new(feed_forward - 10.0 * y[0] - 7.0 * v[0])
        };
        let simulation = Simulation::new(&mass).torque(law).method(precise());
        let started = simulation.initial(Vector1::new(5.0), Vector1::new(8.0));
        started.duration(10.0).samples(51).run().expect("a motion")
    };
    let motion = settle(9.81);
    for (t, y) in motion.t.iter().zip(&motion.q) {
        let expected = 11.0 * (-2.0 * t).exp() - 6.0 * (-5.0 * t).exp();
        assert!((y[0] - expected).abs() < 1e-9, "t = {t}: {}", y[0]);
    }
    let misprinted = settle(-9.81);
    assert!((misprinted.q[50][0] + 1.962).abs() < 1e-6);
}

#[test]
fn the_inertia_of_the_rotor_is_reflected_by_the_square_of_the_gear_ratio() {
    let mut random = Random::seeded(50);
    for _ in 0..100 {
        let [m, l, i, jm, g] = [(); 5].map(|()| random.between(0.01, 5.0));
        let r = random.between(-100.0, 100.0);
        let link = GearedLink { m, l, i, jm, r, g };
        let [th, thdd] = [(); 2].map(|()| random.between(-5.0, 5.0));

        let link_side = i + m * l * l;
        let inertia = r * r * jm + link_side;
        let q = Vector1::new(th);
        assert_near(link.mass_matrix(&q)[0], inertia, inertia);
        let tau = inertia * thdd + m * g * l * th.sin();
        let found = link.inverse_dynamics(&q, &Vector1::new(1.0), &Vector1::new(thdd))[0];
        assert_near(found, tau, inertia * thdd.abs() + m * g * l);
        // The motor's own kinetic energy belongs to the arm's.
        let kinetic = link.kinetic_energy(&q, &Vector1::new(2.0));
        assert_near(kinetic, 2.0 * inertia, 2.0 * inertia);
    }
}
