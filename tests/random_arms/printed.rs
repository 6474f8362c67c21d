//! Arms with PI/2 as books and files print it, through the macro.
#![allow(
    clippy::approx_constant,
    reason = "tables print constants with so many digits"
)]

use robot_dynamics::nalgebra::{SMatrix, SVector, Vector3, Vector4};
use robot_dynamics::{
    CoriolisVector, DoubleDouble, GravityVector, InverseDynamics, MassMatrix, Model, NewtonEuler,
    Scalar, robot_dynamics,
};
use testkit::exact::Exact;

macro_rules! three_axes {
    ($name:ident, $right:literal) => {
        robot_dynamics! {
            struct $name;
            convention: modified,
            gravity: [0, 0, -9.81],
            joints: [
                j0: revolute { mass: 1.1, com: [-0.17, 0.1866, 0], inertia: { yy: 0.01 }, allow: [unphysical_inertia] },
                j1: revolute {
                    a: -0.1, alpha: $right, theta: $right,
                    mass: 2.2364, com: [-0.2729, -0.248, -0.1], inertia: { xx: 0.0155, yy: 0.0157 },
                    allow: [unphysical_inertia],
                },
                j2: revolute {
                    a: -0.4035, alpha: PI/2,
                    mass: 4.25, com: [-0.24, -0.3574, -0.5], inertia: { yy: 0.0114, zz: 0.01 },
                    allow: [unphysical_inertia],
                    motor: { inertia: 0.00132, gear_ratio: 46 },
                },
            ],
            functions: [mass_matrix, coriolis_vector, gravity_vector, inverse_dynamics],
            allow: [odd_angle],
        }
    };
}

three_axes!(FourDecimals, 1.5708);
three_axes!(SixDecimals, 1.570796);
three_axes!(SevenDecimals, 1.5707963);
three_axes!(EightDecimals, 1.57079633);

macro_rules! panda {
    ($name:ident, $right:literal) => {
        robot_dynamics! {
            struct $name;
            convention: modified,
            gravity: [0, 0, -9.81],
            joints: [
                joint1: revolute {
                    d: 0.333, mass: 4.970684, com: [0.003875, 0.002081, -0.04762],
                    inertia: { xx: 0.70337, yy: 0.70661, zz: 0.009117, xy: -0.000139, yz: 0.019169, xz: 0.006772 },
                },
                joint2: revolute {
                    alpha: -$right, mass: 0.646926, com: [-0.003141, -0.02872, 0.003495],
                    inertia: { xx: 0.007962, yy: 0.02811, zz: 0.025995, xy: -0.003925, yz: 0.000704, xz: 0.010254 },
                },
                joint3: revolute {
                    alpha: $right, d: 0.316, mass: 3.228604, com: [0.027518, 0.039252, -0.066502],
                    inertia: { xx: 0.037242, yy: 0.036155, zz: 0.01083, xy: -0.004761, yz: -0.012805, xz: -0.011396 },
                },
                joint4: revolute {
                    a: 0.0825, alpha: $right, mass: 3.587895, com: [-0.05317, 0.104419, 0.027454],
                    inertia: { xx: 0.025853, yy: 0.019552, zz: 0.028323, xy: 0.007796, yz: 0.008641, xz: -0.001332 },
                },
                joint5: revolute {
                    a: -0.0825, alpha: -$right, d: 0.384, mass: 1.225946, com: [-0.011953, 0.041065, -0.038437],
                    inertia: { xx: 0.035549, yy: 0.029474, zz: 0.008627, xy: -0.002117, yz: 0.000229, xz: -0.004037 },
                },
                joint6: revolute {
                    alpha: $right, mass: 1.666555, com: [0.060149, -0.014117, -0.010517],
                    inertia: { xx: 0.001964, yy: 0.004354, zz: 0.005433, xy: 0.000109, yz: 0.000341, xz: -0.001158 },
                },
                joint7: revolute {
                    a: 0.088, alpha: $right, d: 0.107, mass: 0.735522, com: [0.010517, -0.004252, -0.045403],
                    inertia: { xx: 0.012516, yy: 0.010027, zz: 0.004815, xy: -0.000428, yz: -0.000741, xz: -0.001196 },
                },
            ],
            functions: [mass_matrix, coriolis_vector, gravity_vector, inverse_dynamics],
            allow: [odd_angle],
        }
    };
}

panda!(PandaFour, 1.5708);
panda!(PandaEight, 1.57079633);

/// The largest entry of a difference.
fn distance<const R: usize, const C: usize>(
    generated: SMatrix<f64, R, C>,
    exact: SMatrix<DoubleDouble, R, C>,
) -> f64 {
    (generated - exact.map(DoubleDouble::to_f64)).amax()
}

/// Generated functions in one scalar beside Newton-Euler in 31 digits on the doubles of the table.
#[track_caller]
fn compare<T: Scalar, R, const N: usize>(robot: &R, double: fn(T) -> f64, bound: f64)
where
    R: Model<N> + MassMatrix<N> + CoriolisVector<N> + GravityVector<N> + InverseDynamics<N>,
{
    let table = robot.table();
    let exact = Exact(&table);
    for state in 0..40 {
        let vector = |shift: f64| {
            let entry = |i, _| 3.0 * (1.7 * (state * N + i) as f64 + shift).sin();
            SVector::<f64, N>::from_fn(entry).map(|x| f64::from(x as f32))
        };
        let [q, qd, qdd] = [0.1, 0.5, 0.9].map(vector);
        let [p, pd, pdd] = [q, qd, qdd].map(|x| x.map(T::from_f64));
        let [e, ed, edd] = [q, qd, qdd].map(|x| x.map(DoubleDouble::from));
        let m = exact.mass_matrix(&e);
        let gravity = exact.gravity_vector(&e);
        let size = m.map(DoubleDouble::to_f64).amax();
        let speed = size * qd.amax() * qd.amax();
        let weight = gravity.map(DoubleDouble::to_f64).amax().max(size);
        let mass_matrix = distance(robot.mass_matrix(&p).map(double), m);
        let coriolis = robot.coriolis_vector(&p, &pd).map(double);
        let coriolis = distance(coriolis, exact.coriolis_vector(&e, &ed));
        let gravity = distance(robot.gravity_vector(&p).map(double), gravity);
        let tau = robot.inverse_dynamics(&p, &pd, &pdd).map(double);
        let tau = distance(tau, exact.inverse_dynamics(&e, &ed, &edd));
        let errors = [
            mass_matrix / size,
            coriolis / speed,
            gravity / weight,
            tau / (speed + weight + size * qdd.amax()),
        ];
        assert!(errors.iter().all(|error| *error <= bound), "{errors:?}");
    }
}

#[test]
fn generated_functions_agree_with_newton_euler_in_31_digits() {
    compare::<f64, _, 3>(&FourDecimals, f64::from, 1e-13);
    compare::<f64, _, 3>(&SixDecimals, f64::from, 1e-13);
    compare::<f64, _, 3>(&SevenDecimals, f64::from, 1e-13);
    compare::<f64, _, 3>(&EightDecimals, f64::from, 1e-13);
    compare::<f64, _, 7>(&PandaFour, f64::from, 1e-13);
    compare::<f64, _, 7>(&PandaEight, f64::from, 1e-13);
}

#[test]
fn generated_functions_agree_in_single_precision() {
    compare::<f32, _, 3>(&FourDecimals, f64::from, 4e-6);
    compare::<f32, _, 3>(&SixDecimals, f64::from, 4e-6);
    compare::<f32, _, 3>(&SevenDecimals, f64::from, 4e-6);
    compare::<f32, _, 3>(&EightDecimals, f64::from, 4e-6);
    compare::<f32, _, 7>(&PandaFour, f64::from, 4e-6);
    compare::<f32, _, 7>(&PandaEight, f64::from, 4e-6);
}

robot_dynamics! {
    /// Its mass matrix was wrong by 8.9e-12.
    struct Graded;
    convention: modified,
    gravity: [0, 0, 0],
    joints: [
        j0: revolute { alpha: PI/2, d: -0.22, mass: 2.4, inertia: { zz: 0.02 }, allow: [unphysical_inertia] },
        j1: revolute {
            a: 0.7927, alpha: -1.5708, theta: 1.5708,
            mass: 2.192, com: [0, 0, -0.4072], inertia: { xx: 0.0117, yy: 0.0199, zz: 0.0116 },
        },
        j2: revolute {
            a: -0.4, alpha: 1.5708, d: 0.8316, theta: 1.5708,
            mass: 3.59, com: [0, -0.3, 0], inertia: { yy: 0.0132 }, allow: [unphysical_inertia],
        },
    ],
    functions: [mass_matrix],
    allow: [odd_angle],
}

robot_dynamics! {
    /// Its Jacobian was wrong by 8.0e-11.
    struct Slanted;
    convention: standard,
    gravity: [0, 0, 0],
    joints: [
        j0: prismatic { a: -0.5257, theta: 1.5708 },
        j1: revolute { d: 0.2154, theta: 1.5708 },
        j2: revolute {},
        j3: revolute { alpha: PI/2 },
    ],
    functions: [jacobian],
    allow: [odd_angle],
}

robot_dynamics! {
    /// One of its coefficients was 1e266.
    struct Massless;
    convention: modified,
    gravity: [0, 0, 0],
    joints: [
        j0: revolute {
            a: 0.6708, d: 0.88, com: [0, 0, 0.49], inertia: { xx: 0.0144, yy: 0.0158 }, allow: [unphysical_inertia],
        },
        j1: revolute { alpha: -1.5708, com: [0, 0, 0.2], inertia: { yy: 0.0185 }, allow: [unphysical_inertia] },
    ],
    functions: [coriolis_coefficients],
    allow: [odd_angle, odd_mass],
}

#[test]
fn three_small_arms_lose_no_digits() {
    let q = Vector3::new(2.028, 2.822, -3.140);
    let table = Graded.table();
    let exact = Exact(&table).mass_matrix(&q.map(DoubleDouble::from));
    let size = exact.map(DoubleDouble::to_f64).amax();
    assert!(distance(Graded.mass_matrix(&q), exact) <= 1e-15 * size);

    let q = Vector4::zeros();
    let numeric = NewtonEuler::new(&Slanted.table()).jacobian(&q);
    assert!((Slanted.jacobian(&q) - numeric).amax() <= 1e-15);

    let table = Massless.table();
    let exact = Exact(&table);
    for q in [[0.3, 0.7], [2.0, -1.1], [0.0, 0.0]].map(SVector::from) {
        let at = q.map(DoubleDouble::from);
        let along = |qd: [f64; 2]| {
            let qd = SVector::from(qd).map(DoubleDouble::from);
            exact.coriolis_vector(&at, &qd).map(DoubleDouble::to_f64)
        };
        let expected = along([1.0, 1.0]) - along([1.0, 0.0]) - along([0.0, 1.0]);
        let generated = Massless.coriolis_coefficients(&q);
        assert!((generated - expected).amax() <= 1e-16, "{generated:?}");
    }
}
