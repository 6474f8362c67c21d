//! The two-link arm with point masses at the ends of its links (Craig, figure 6.6), symbolic in m1, m2, l1, l2 and g,
//! in both conventions. M, V, G are compared with (6.60) to (6.62), and the coefficients B and C with the
//! configuration-space equation (6.63).

use robot_dynamics::nalgebra::{Matrix2, Vector1, Vector2};
use robot_dynamics::robot_dynamics;
use testkit::random::Random;

use crate::assert_all_near;

robot_dynamics! {
    /// Frames on the joints, as Craig places them: the masses are l1 and l2 away from them.
    #[derive(Clone, Copy)]
    struct Modified { m1: f64, m2: f64, l1: f64, l2: f64, g: f64 }

    convention: modified,
    gravity: [0, -g, 0],
    joints: [
        shoulder: revolute { mass: m1, com: [l1, 0, 0] },
        elbow: revolute { a: l1, mass: m2, com: [l2, 0, 0] },
    ],
    functions: [
        mass_matrix, coriolis_vector, gravity_vector, coriolis_matrix,
        coriolis_coefficients, centrifugal_coefficients,
    ],
}

robot_dynamics! {
    /// Frames at the ends of the links, where the masses are.
    #[derive(Clone, Copy)]
    struct Standard { m1: f64, m2: f64, l1: f64, l2: f64, g: f64 }

    convention: standard,
    gravity: [0, -g, 0],
    joints: [
        shoulder: revolute { a: l1, mass: m1 },
        elbow: revolute { a: l2, mass: m2 },
    ],
    functions: [
        mass_matrix, coriolis_vector, gravity_vector, coriolis_matrix,
        coriolis_coefficients, centrifugal_coefficients,
    ],
}

/// `formulas()` hands out the printed ones, and those of all frames and conventions are the same.
#[test]
fn formulas_as_they_are_printed() {
    let of = |function: &str, formulas: &[robot_dynamics::Formula]| {
        let own = formulas
            .iter()
            .filter(|formula| formula.function == function);
        own.map(|formula| formula.text).collect::<Vec<_>>()
    };
    let printed = [
        "M11 = l1^2 (m1 + m2) + m2 l2^2 + 2 m2 l1 l2 c2",
        "M12 = m2 l2^2 + m2 l1 l2 c2",
        "M21 = m2 l2^2 + m2 l1 l2 c2",
        "M22 = m2 l2^2",
    ];
    assert_eq!(of("mass_matrix", Modified::formulas()), printed);
    let texts = |formulas: &[robot_dynamics::Formula]| -> Vec<&str> {
        formulas.iter().map(|formula| formula.text).collect()
    };
    assert_eq!(texts(Modified::formulas()), texts(Standard::formulas()));
    let corner = Modified::formulas()[3];
    assert_eq!(
        (corner.value, corner.latex),
        ("M22", "M_{22} = m_{2} \\, l_{2}^{2}")
    );
    assert!(corner.mathml.starts_with("<math"));
    assert_eq!(corner.to_string(), corner.text);
}

/// The printed formulas.
struct Printed {
    m1: f64,
    m2: f64,
    l1: f64,
    l2: f64,
    g: f64,
}

impl Printed {
    /// (6.60)
    fn mass_matrix(&self, [_, q2]: [f64; 2]) -> [[f64; 2]; 2] {
        let &Printed { m1, m2, l1, l2, .. } = self;
        let c2 = q2.cos();
        let corner = l2 * l2 * m2;
        let side = l2 * l2 * m2 + l1 * l2 * m2 * c2;
        let first = l2 * l2 * m2 + 2.0 * l1 * l2 * m2 * c2 + l1 * l1 * (m1 + m2);
        [[first, side], [side, corner]]
    }

    /// m2 l1 l2 s2, of which all of (6.61) is made.
    fn k(&self, [_, q2]: [f64; 2]) -> f64 {
        self.m2 * self.l1 * self.l2 * q2.sin()
    }

    /// (6.61)
    fn coriolis_vector(&self, q: [f64; 2], [v1, v2]: [f64; 2]) -> [f64; 2] {
        let k = self.k(q);
        [-k * v2 * v2 - 2.0 * k * v1 * v2, k * v1 * v1]
    }

    /// (6.62)
    fn gravity_vector(&self, [q1, q2]: [f64; 2]) -> [f64; 2] {
        let &Printed { m1, m2, l1, l2, g } = self;
        let second = m2 * l2 * g * (q1 + q2).cos();
        [second + (m1 + m2) * l1 * g * q1.cos(), second]
    }

    /// (6.63)
    fn coriolis_coefficients(&self, q: [f64; 2]) -> [f64; 2] {
        [-2.0 * self.k(q), 0.0]
    }

    /// (6.63)
    fn centrifugal_coefficients(&self, q: [f64; 2]) -> [[f64; 2]; 2] {
        let k = self.k(q);
        [[0.0, -k], [k, 0.0]]
    }

    fn largest_inertia(&self) -> f64 {
        let reach = self.l1 + self.l2;
        self.m1 * self.l1 * self.l1 + self.m2 * reach * reach
    }

    fn largest_weight(&self) -> f64 {
        self.g * (self.m1 * self.l1 + self.m2 * (self.l1 + self.l2))
    }
}

fn assert_matrix_near(found: Matrix2<f64>, expected: [[f64; 2]; 2], magnitude: f64) {
    for (i, row) in expected.into_iter().enumerate() {
        assert_all_near(found.row(i).transpose(), row, magnitude);
    }
}

/// The same comparison for both conventions, at random parameters and states.
macro_rules! agrees_with_the_book {
    ($convention:ident) => {{
        let mut random = Random::seeded(663);
        for _ in 0..200 {
            let [m1, m2, l1, l2] = [(); 4].map(|()| random.between(0.1, 5.0));
            let g = random.between(-10.0, 10.0);
            let arm = $convention { m1, m2, l1, l2, g };
            let printed = Printed { m1, m2, l1, l2, g };
            let q: Vector2<f64> = random.vector(3.2);
            let qd: Vector2<f64> = random.vector(5.0);
            let (at, v) = ([q[0], q[1]], [qd[0], qd[1]]);
            let inertia = printed.largest_inertia();
            let coriolis = inertia * qd.norm_squared();

            assert_matrix_near(arm.mass_matrix(&q), printed.mass_matrix(at), inertia);
            let expected = printed.coriolis_vector(at, v);
            assert_all_near(arm.coriolis_vector(&q, &qd), expected, coriolis);
            let expected = printed.gravity_vector(at);
            assert_all_near(
                arm.gravity_vector(&q),
                expected,
                printed.largest_weight().abs(),
            );

            let b = arm.coriolis_coefficients(&q);
            assert_all_near(
                b.column(0).into_owned(),
                printed.coriolis_coefficients(at),
                inertia,
            );
            let c = arm.centrifugal_coefficients(&q);
            assert_matrix_near(c, printed.centrifugal_coefficients(at), inertia);

            // The entries that the book has as 0 are zero, not small.
            assert_eq!((b[1], c[(0, 0)], c[(1, 1)]), (0.0, 0.0, 0.0));
            let products = Vector1::new(qd[0] * qd[1]);
            let form = b * products + c * qd.component_mul(&qd);
            assert_all_near(form, printed.coriolis_vector(at, v), coriolis);
        }
    }};
}

#[test]
fn frames_on_the_joints_give_the_printed_equations() {
    agrees_with_the_book!(Modified);
}

#[test]
fn frames_at_the_ends_of_the_links_give_the_printed_equations() {
    agrees_with_the_book!(Standard);
}

/// C of the Christoffel symbols is another matrix than the centrifugal coefficients: with
/// k = m2 l1 l2 s2 it is [[-k qd2, -k (qd1 + qd2)], [k qd1, 0]].
#[test]
fn the_christoffel_matrix_is_not_the_matrix_of_centrifugal_coefficients() {
    let [m1, m2, l1, l2, g] = [4.6, 2.3, 0.5, 0.3, 9.81];
    let arm = Modified { m1, m2, l1, l2, g };
    let printed = Printed { m1, m2, l1, l2, g };
    let (q, qd) = (Vector2::new(0.4, 0.9), Vector2::new(1.5, -0.5));
    let k = printed.k([0.4, 0.9]);
    let expected = [[-k * qd[1], -k * (qd[0] + qd[1])], [k * qd[0], 0.0]];
    assert_matrix_near(
        arm.coriolis_matrix(&q, &qd),
        expected,
        printed.largest_inertia(),
    );
    assert!((arm.coriolis_matrix(&q, &qd) - arm.centrifugal_coefficients(&q)).norm() > 0.1);
}
