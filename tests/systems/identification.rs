//! Identification: the base parameters of an arm from its torques alone.

use robot_dynamics::nalgebra::{DMatrix, DVector, SMatrix, SVector};
use robot_dynamics::robot_dynamics;
use testkit::random::Random;

robot_dynamics! {
    /// An elbow arm with a telescopic hand, whose masses and inertias are fields.
    struct Crane {
        m1: f64, m2: f64, m3: f64, x2: f64, y2: f64, z2: f64, x3: f64, z3: f64,
        j1: f64, j2: f64, j3: f64, rotor: f64,
    }

    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        slew: revolute { d: 0.5, mass: m1, com: [0.1, 0, 0.2], inertia: { zz: j1 } },
        luff: revolute {
            a: 0.2, alpha: PI/2,
            mass: m2, com: [x2, y2, z2], inertia: { xx: j2, yy: j1, zz: j2, xy: 0.01, xz: -0.02 },
            motor: { inertia: rotor, gear_ratio: 40 },
        },
        boom: prismatic {
            a: 0.1, alpha: deg(60), theta: deg(25), d: 0.3,
            mass: m3, com: [x3, 0.05, z3], inertia: { xx: j3, yy: j3, zz: j1, yz: 0.003 },
            motor: { inertia: 2e-4, gear_ratio: 100 },
            friction: { viscous: 3, coulomb: 2 },
        },
    ],
    functions: [regressor, base_parameters, inverse_dynamics, friction_vector],
    tests: true,
}

/// A field is 0 that would be a divisor in another choice of base parameters.
const CRANE: Crane = Crane {
    m1: 20.0,
    m2: 12.0,
    m3: 7.5,
    x2: 0.4,
    y2: -0.05,
    z2: 0.0,
    x3: 0.0,
    z3: 0.6,
    j1: 0.8,
    j2: 0.5,
    j3: 0.25,
    rotor: 3e-4,
};

type Vector = SVector<f64, 3>;

fn states() -> impl Iterator<Item = [Vector; 3]> {
    let mut random = Random::seeded(21);
    (0..60).map(move |_| [random.vector(2.0), random.vector(2.0), random.vector(5.0)])
}

#[test]
fn the_signatures_are_those_of_the_contract() {
    const P: usize = Crane::BASE_PARAMETERS;
    let [q, qd, qdd] = states().next().expect("a state");
    let regressor: SMatrix<f64, 3, P> = CRANE.regressor(&q, &qd, &qdd);
    let parameters: SVector<f64, P> = CRANE.base_parameters();
    let single: SVector<f32, P> = CRANE.base_parameters();
    assert!((single.cast::<f64>() - parameters).amax() <= 1e-6 * parameters.amax());
    let tau = regressor * parameters + CRANE.friction_vector(&qd);
    let expected = CRANE.inverse_dynamics(&q, &qd, &qdd);
    assert!((tau - expected).amax() <= 1e-14 * expected.amax());
}

/// J_zz of the slew, seven parameters of the luff, mass, motor and first moments of the boom.
#[test]
fn the_parameters_have_names() {
    let expected = [
        "J1zz", "J2xx", "J2xy", "J2xz", "J2yz", "J2zz", "h2x", "h2y", "h3x", "h3y", "h3z", "m3",
        "I3",
    ];
    assert_eq!(Crane::BASE_PARAMETER_NAMES, expected);
}

/// Torques of one arm, the regressor of another one of the same geometry: least squares finds the
/// base parameters of the first.
#[test]
fn least_squares_recovers_the_base_parameters() {
    let another = Crane {
        m1: 1.0,
        m2: 1.0,
        m3: 1.0,
        j1: 0.1,
        rotor: 0.0,
        ..CRANE
    };
    let states: Vec<_> = states().collect();
    let rows = 3 * states.len();
    let mut regressors = DMatrix::zeros(rows, Crane::BASE_PARAMETERS);
    let mut torques = DVector::zeros(rows);
    for (k, [q, qd, qdd]) in states.iter().enumerate() {
        let torque = CRANE.inverse_dynamics(q, qd, qdd) - CRANE.friction_vector(qd);
        regressors
            .rows_mut(3 * k, 3)
            .copy_from(&another.regressor(q, qd, qdd));
        torques.rows_mut(3 * k, 3).copy_from(&torque);
    }
    let identified = regressors
        .svd(true, true)
        .solve(&torques, 0.0)
        .expect("both factors");
    let exact: SVector<f64, _> = CRANE.base_parameters();
    for (found, exact) in identified.iter().zip(exact.iter()) {
        assert!((found - exact).abs() < 1e-11, "{found} instead of {exact}");
    }
}
