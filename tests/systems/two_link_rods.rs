//! The two-link arm with slender rods (Saha), m1 = 3, m2 = 1, a1 = 2, a2 = 1 and symbolic.

use std::f64::consts::{FRAC_PI_2, PI};

use robot_dynamics::nalgebra::Vector2;
use robot_dynamics::{Cycloidal, Method, Simulation, Trajectory, robot_dynamics};
use testkit::random::Random;
use testkit::references::{MotionFile, TorqueFile, read};

use crate::{assert_all_near, assert_near, assert_same_motion, largest, precise, within};

robot_dynamics! {
    /// Angles from the horizontal, centres of mass in the middle of the links.
    #[derive(Clone, Copy)]
    struct Symbolic { m1: f64, m2: f64, a1: f64, a2: f64, g: f64 }

    convention: standard,
    gravity: [0, -g, 0],
    joints: [
        shoulder: revolute { a: a1, mass: m1, com: [-a1/2, 0, 0], inertia: rod(a1) },
        elbow: revolute { a: a2, mass: m2, com: [-a2/2, 0, 0], inertia: rod(a2) },
    ],
    tests: true,
}

robot_dynamics! {
    /// The same arm with the numbers of the slides.
    struct Numeric;

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 2, mass: 3, com: [-1, 0, 0], inertia: rod(2) },
        elbow: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) },
    ],
    tests: true,
}

const SLIDES: Symbolic = Symbolic {
    m1: 3.0,
    m2: 1.0,
    a1: 2.0,
    a2: 1.0,
    g: 9.81,
};

/// The printed formulas, with the one misprint put right: gamma_2 has m2, not m1.
impl Symbolic {
    /// i11, i12, i22 with I_zz = m a^2/12.
    fn printed_inertia(&self, q: &Vector2<f64>) -> [f64; 3] {
        let &Symbolic { m1, m2, a1, a2, .. } = self;
        let c2 = q[1].cos();
        let (inertia1, inertia2) = (m1 * a1 * a1 / 12.0, m2 * a2 * a2 / 12.0);
        let i11 = m1 / 4.0 * a1 * a1
            + inertia1
            + m2 * (a1 * a1 + a2 * a2 / 4.0 + a1 * a2 * c2)
            + inertia2;
        let i12 = m2 * (a2 * a2 / 4.0 + a1 * a2 * c2 / 2.0) + inertia2;
        let i22 = m2 * a2 * a2 / 4.0 + inertia2;
        [i11, i12, i22]
    }

    /// h1, h2
    fn printed_coriolis(&self, q: &Vector2<f64>, qd: &Vector2<f64>) -> [f64; 2] {
        let &Symbolic { m2, a1, a2, .. } = self;
        let s2 = q[1].sin();
        let h1 = -m2 * a1 * a2 * s2 * qd[0] * qd[1] - m2 * a1 * a2 / 2.0 * s2 * qd[1] * qd[1];
        let h2 = m2 / 2.0 * a1 * a2 * s2 * qd[0] * qd[0];
        [h1, h2]
    }

    /// gamma_1, gamma_2
    fn printed_gravity(&self, q: &Vector2<f64>) -> [f64; 2] {
        let &Symbolic { m1, m2, a1, a2, g } = self;
        let (c1, c12) = (q[0].cos(), (q[0] + q[1]).cos());
        let gamma1 = m1 * g * a1 / 2.0 * c1 + m2 * g * (a1 * c1 + a2 / 2.0 * c12);
        let gamma2 = m2 * g * a2 / 2.0 * c12;
        [gamma1, gamma2]
    }

    fn largest_inertia(&self) -> f64 {
        let reach = self.a1 + self.a2;
        self.m1 * self.a1 * self.a1 + self.m2 * reach * reach
    }

    fn largest_weight(&self) -> f64 {
        let reach = self.a1 + self.a2;
        self.g.abs() * (self.m1 * self.a1 + self.m2 * reach)
    }
}

#[test]
fn the_symbolic_arm_has_the_printed_terms() {
    let mut random = Random::seeded(17);
    for _ in 0..200 {
        let [m1, m2, a1, a2] = [(); 4].map(|()| random.between(0.1, 5.0));
        let g = random.between(-10.0, 10.0);
        let arm = Symbolic { m1, m2, a1, a2, g };
        let [q, qd]: [Vector2<f64>; 2] = [3.2, 5.0].map(|limit| random.vector(limit));
        let inertia = arm.largest_inertia();

        let [i11, i12, i22] = arm.printed_inertia(&q);
        let m = arm.mass_matrix(&q);
        assert_near(m[(0, 0)], i11, 2.0 * inertia);
        assert_near(m[(0, 1)], i12, 2.0 * inertia);
        assert_near(m[(1, 0)], i12, 2.0 * inertia);
        assert_near(m[(1, 1)], i22, 2.0 * inertia);
        let coriolis = inertia * qd.norm_squared();
        assert_all_near(
            arm.coriolis_vector(&q, &qd),
            arm.printed_coriolis(&q, &qd),
            coriolis,
        );
        assert_all_near(
            arm.gravity_vector(&q),
            arm.printed_gravity(&q),
            arm.largest_weight(),
        );
    }
}

#[test]
fn the_numbers_of_the_slides_give_the_same_arm() {
    let mut random = Random::seeded(18);
    for _ in 0..50 {
        let [q, qd, qdd]: [Vector2<f64>; 3] = [3.2, 5.0, 10.0].map(|limit| random.vector(limit));
        let inertia = SLIDES.largest_inertia();
        let torque = inertia * (qd.norm_squared() + qdd.norm()) + SLIDES.largest_weight();
        let symbolic = SLIDES.inverse_dynamics(&q, &qd, &qdd);
        assert_all_near(
            Numeric.inverse_dynamics(&q, &qd, &qdd),
            symbolic.into(),
            torque,
        );
    }
}

/// The slides print gamma_2 with m1: three times too much for these masses.
#[test]
fn the_misprinted_gravity_term_is_not_ours() {
    let q = Vector2::new(0.4, 0.9);
    let c12 = f64::cos(q[0] + q[1]);
    let found = Numeric.gravity_vector(&q)[1];
    assert_near(found, 1.0 * 9.81 * 0.5 * c12, 9.81);
    let misprinted = 3.0 * 9.81 * 0.5 * c12;
    assert_near(misprinted / found, 3.0, 3.0);
}

/// Half a turn and a quarter of a turn in 10 s by the cycloidal law.
#[test]
fn inverse_dynamics_on_the_cycloidal_law() {
    let file: TorqueFile = read("trajectories", "two_link_invdyn");
    let end = Vector2::new(PI, FRAC_PI_2);
    let law = Cycloidal::new(Vector2::zeros(), end, 10.0).expect("a duration");
    let mut furthest_from_misprint: f64 = 0.0;
    assert_eq!(file.rows.len(), 51);
    for (t, exact) in file.t.iter().zip(&file.rows) {
        let at = law.at(*t);
        let tau = Numeric.inverse_dynamics(&at.q, &at.qd, &at.qdd);
        let computed = [at.q, at.qd, at.qdd, tau];
        let magnitude = [PI, PI, PI, SLIDES.largest_weight()];
        for (i, x) in computed.iter().flatten().enumerate() {
            within(exact[i].error_of(*x), magnitude[i / 2]);
        }
        let misprinted = exact[8].nearest();
        furthest_from_misprint = furthest_from_misprint.max((tau[1] - misprinted).abs());
    }
    assert!(furthest_from_misprint > 5.0);
}

fn fall(method: Method) -> Trajectory<2> {
    let simulation = Simulation::new(&Numeric).method(method);
    let motion = simulation.duration(10.0).samples(51).run();
    motion.expect("a free fall")
}

/// From the horizontal, 10 s. The motion is chaotic: an error grows two thousand times.
#[test]
fn free_fall() {
    let motion = fall(precise());
    let exact: MotionFile = read("trajectories", "two_link_free");
    assert_same_motion(&motion, &exact);
    assert!(motion.energy_drift(&Numeric) < 1e-9 * SLIDES.largest_weight());
}

#[test]
fn free_fall_is_not_that_of_the_misprinted_gravity_term() {
    let motion = fall(precise());
    let misprinted: MotionFile = read("trajectories", "two_link_free_misprinted_gamma2");
    let errors = misprinted.errors(&motion);
    assert_eq!(errors[0], 0.0);
    assert!(errors[1] > 0.1, "after 0.2 s: {}", errors[1]);
}

/// (6.117) with the old velocity, 10,000 steps: the scheme's own value, not that of the motion. Its roundings of 1e-16
/// grow in as many steps, two thousand times amplified, to 2e-9.
#[test]
fn craigs_euler_scheme_value_for_value() {
    let motion = fall(Method::CraigEuler { step: 1e-3 });
    let scheme: MotionFile = read("trajectories", "two_link_craig_euler_dt1e-3");
    assert!(largest(&scheme.errors(&motion)) < 2e-9);
    let free: MotionFile = read("trajectories", "two_link_free");
    assert!(largest(&free.errors(&motion)) > 0.1);
}
