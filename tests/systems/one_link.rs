//! The one-link arm, a slender rod that hangs at th = 0 (Saha):
//! (1/3) m a^2 thdd + (1/2) m g a sin th = tau.

use std::f64::consts::PI;

use robot_dynamics::nalgebra::Vector1;
use robot_dynamics::{Cycloidal, Method, Simulation, Trajectory, robot_dynamics};
use testkit::random::Random;
use testkit::references::{MotionFile, TorqueFile, read};

use crate::{assert_near, assert_same_motion, largest, precise, within};

robot_dynamics! {
    /// Symbolic in its mass, its length and the acceleration of gravity.
    #[derive(Clone, Copy)]
    struct OneLink { m: f64, a: f64, g: f64 }

    convention: standard,
    gravity: [g, 0, 0],
    joints: [
        joint: revolute { a: a, mass: m, com: [-a/2, 0, 0], inertia: rod(a) },
    ],
}

/// The numbers of the slides.
const SLIDES: OneLink = OneLink {
    m: 1.0,
    a: 1.0,
    g: 9.81,
};

#[test]
fn the_closed_form_holds_for_every_rod() {
    let mut random = Random::seeded(1);
    for _ in 0..200 {
        let [m, a, g] = [(); 3].map(|()| random.between(0.1, 10.0));
        let rod = OneLink { m, a, g };
        let [th, thd, thdd] = [(); 3].map(|()| random.between(-10.0, 10.0));
        let [q, qd, qdd] = [th, thd, thdd].map(Vector1::new);

        let inertia = m * a * a / 3.0;
        let gravity = 0.5 * m * g * a * th.sin();
        assert_near(rod.mass_matrix(&q)[0], inertia, inertia);
        assert_eq!(rod.coriolis_vector(&q, &qd)[0], 0.0);
        assert_near(rod.gravity_vector(&q)[0], gravity, m * g * a);
        let tau = inertia * thdd + gravity;
        let magnitude = inertia * thdd.abs() + m * g * a;
        assert_near(rod.inverse_dynamics(&q, &qd, &qdd)[0], tau, magnitude);

        let kinetic = inertia * thd * thd / 2.0;
        assert_near(rod.kinetic_energy(&q, &qd), kinetic, kinetic);
        let potential = -0.5 * m * g * a * th.cos();
        assert_near(rod.potential_energy(&q), potential, m * g * a);
    }
}

/// thdd = 3/(m a^2) (tau - (1/2) m g a sin th); the slides print 2/(m a^2).
#[test]
fn the_state_space_form_has_a_three_where_the_slides_print_a_two() {
    let (th, tau) = (0.7_f64, 0.3);
    let driving = tau - 0.5 * 9.81 * th.sin();
    let found = SLIDES.forward_dynamics(&Vector1::new(th), &Vector1::zeros(), &Vector1::new(tau));
    let thdd = found.expect("a rod has inertia")[0];
    assert_near(thdd, 3.0 * driving, 10.0);
    assert_near(thdd / (2.0 * driving), 1.5, 1.5);
}

/// Half a turn in 10 s by the cycloidal law.
#[test]
fn inverse_dynamics_on_the_cycloidal_law() {
    let file: TorqueFile = read("trajectories", "one_link_invdyn");
    let law = Cycloidal::new(Vector1::zeros(), Vector1::new(PI), 10.0).expect("a duration");
    assert_eq!(file.rows.len(), 51);
    for (t, exact) in file.t.iter().zip(&file.rows) {
        let at = law.at(*t);
        let tau = SLIDES.inverse_dynamics(&at.q, &at.qd, &at.qdd)[0];
        let computed = [at.q[0], at.qd[0], at.qdd[0], tau];
        let magnitude = [PI, 0.2 * PI, 0.2 * PI, 5.0];
        for ((x, exact), magnitude) in computed.into_iter().zip(exact).zip(magnitude) {
            within(exact.error_of(x), magnitude);
        }
    }
}

fn swing(method: Method) -> (Trajectory<1>, MotionFile, MotionFile) {
    let [free, euler] = ["one_link_free", "one_link_craig_euler_dt1e-3"]
        .map(|name| read::<MotionFile>("trajectories", name));
    let (q, qd) = free.initial();
    let simulation = Simulation::new(&SLIDES).initial(q, qd).method(method);
    let motion = simulation.duration(10.0).samples(51).run();
    (motion.expect("a free swing"), free, euler)
}

/// From the horizontal, 10 s: five periods and a bit.
#[test]
fn free_swing() {
    let (motion, exact, _) = swing(precise());
    assert_same_motion(&motion, &exact);
    assert!(motion.energy_drift(&SLIDES) < 1e-9);
}

/// (6.117) with the old velocity, 10,000 steps: the scheme's own value, not that of the motion. Its roundings of 1e-16
/// grow in as many steps, thirty times amplified, to 3e-11.
#[test]
fn craigs_euler_scheme_value_for_value() {
    let (motion, free, scheme) = swing(Method::CraigEuler { step: 1e-3 });
    assert!(largest(&scheme.errors(&motion)) < 3e-11);
    // The scheme itself is off by 0.3 rad after 10 s.
    assert!(largest(&free.errors(&motion)) > 0.2);
}
