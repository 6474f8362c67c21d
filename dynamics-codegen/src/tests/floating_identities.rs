//! Identities between the functions of a robot on a base that moves. Its derivatives are those of displacements in the axes
//! of the base.

use dynamics_symbolic::Function;
use dynamics_symbolic::derive::derive_plain;
use dynamics_symbolic::function::{Argument, Part};
use dynamics_symbolic::robot::Robot;

use super::doubles::{Doubles, assert_near, differences, entries, largest, pose};
use super::*;

const ROBOT: &str = "
    struct Flyer;
    convention: modified, gravity: [1, 2, -9.81],
    base: floating {
        mass: 5, com: [0.1, -0.2, 0.3], inertia: { xx: 0.3, yy: 0.4, zz: 0.5, xy: 0.02, yz: -0.03, xz: 0.04 },
    },
    joints: [
        turn: revolute {
            alpha: 0.3, a: 0.2, d: 0.1, theta: 0.5, mass: 2, com: [0.1, 0.2, -0.1],
            inertia: { xx: 0.2, yy: 0.3, zz: 0.4, xy: 0.02, yz: 0.03, xz: -0.01 },
            motor: { inertia: 1e-4, gear_ratio: 50 }, spring: { stiffness: 3, rest: 0.2 }, friction: { viscous: 0.7 },
        },
        elbow: revolute { alpha: -0.7, a: 0.3, mass: 1, com: [0.2, 0, 0.1], inertia: sphere(0.1) },
        slide: prismatic {
            on: base, at: { xyz: [0.1, 0.2, 0.3], rpy: [0.4, 0.5, 0.6] }, mass: 1.5, com: [0.1, 0, 0.05],
            inertia: cuboid(0.1, 0.2, 0.3),
        },
    ],
    frames: {
        hand: { on: elbow, xyz: [0.3, 0.1, 0], rpy: [0.1, 0.2, 0.3], mass: 0.5, com: [0, 0, 0.1], inertia: sphere(0.1) },
        pack: { on: base, xyz: [0.2, 0, 0.1], rpy: [0.5, 0, 0], mass: 0.7, com: [0.1, 0, 0], inertia: sphere(0.05) },
    },
    functions: [jacobian(hand)],
";

/// The degrees of freedom.
const N: usize = 9;

struct Flyer {
    robot: Robot,
    at: Doubles,
}

impl Flyer {
    fn new() -> Flyer {
        let some = |argument: usize| move |i: usize| ((i * i + 5 * argument + 3) as f64).sin();
        let vector = |argument: usize| (0..N).map(some(argument)).collect();
        Flyer {
            robot: model(ROBOT).robot,
            at: Doubles {
                base: pose(&[0.3, -0.2, 0.5, 0.1, -0.5, 0.7, 0.5]),
                q: (0..N - 6).map(some(1)).collect(),
                v: vector(2),
                a: vector(3),
                tau: vector(4),
                jerk: vector(5),
            },
        }
    }

    /// A function, of the hand if it is about a frame.
    fn function(&self, function: Function) -> impl Fn(&Doubles) -> Vec<f64> + use<> {
        let frame = function.row().of_tip.then_some(0);
        let program = derive_plain(&self.robot, Part { function, frame });
        move |at: &Doubles| program.evaluate(&mut at.clone())
    }

    fn value(&self, function: Function) -> Vec<f64> {
        self.function(function)(&self.at)
    }

    /// Derivatives of values by displacements: column k along freedom k.
    fn by_position(&self, values: impl Fn(&Doubles) -> Vec<f64>) -> Vec<f64> {
        differences(N, |k, h| values(&self.at.displaced(&unit(k, h))))
    }

    fn by_velocity(&self, values: impl Fn(&Doubles) -> Vec<f64>) -> Vec<f64> {
        differences(N, |k, h| {
            let mut other = self.at.clone();
            other.v[k] += h;
            values(&other)
        })
    }

    /// The rate along the motion.
    fn by_time(&self, values: impl Fn(&Doubles) -> Vec<f64>) -> Vec<f64> {
        differences(1, |_, h| values(&self.at.later(h)))
    }
}

fn unit(k: usize, h: f64) -> Vec<f64> {
    (0..N).map(|i| if i == k { h } else { 0.0 }).collect()
}

/// A matrix by rows times a vector.
fn times(matrix: &[f64], v: &[f64]) -> Vec<f64> {
    let rows = matrix.chunks(v.len());
    let product = |row: &[f64]| row.iter().zip(v).map(|(m, v)| m * v).sum();
    rows.map(product).collect()
}

/// A matrix by rows, with so many columns, the other way round.
fn transposed(matrix: &[f64], columns: usize) -> Vec<f64> {
    let column = |k: usize| matrix.iter().skip(k).step_by(columns).copied();
    (0..columns).flat_map(column).collect()
}

fn sum(terms: &[&[f64]]) -> Vec<f64> {
    let entry = |i: usize| terms.iter().map(|term| term[i]).sum();
    (0..terms[0].len()).map(entry).collect()
}

/// Equal except for rounding.
#[track_caller]
fn same(what: &str, found: &[f64], expected: &[f64]) {
    assert_near(what, found, expected, 100.0 * largest(expected));
}

/// Equal except for what central differences lose.
#[track_caller]
fn near(what: &str, found: &[f64], expected: &[f64]) {
    assert_near(what, found, expected, 1e6 * largest(expected));
}

#[test]
fn derivatives_are_those_of_displacements() {
    let flyer = &Flyer::new();
    let square = N * N;
    for (derivatives, function) in [
        (
            Function::InverseDynamicsDerivatives,
            Function::InverseDynamics,
        ),
        (
            Function::ForwardDynamicsDerivatives,
            Function::ForwardDynamics,
        ),
    ] {
        let of = flyer.function(function);
        // Pivots follow the accelerations.
        let of = |at: &Doubles| of(at)[..N].to_vec();
        let found = flyer.value(derivatives);
        near("by q", &found[..square], &flyer.by_position(of));
        near("by v", &found[square..2 * square], &flyer.by_velocity(of));
    }
    let gravity = flyer.function(Function::PotentialEnergy);
    let springs = flyer.value(Function::SpringVector);
    let forces = sum(&[&flyer.value(Function::GravityVector), &springs]);
    near("G", &forces, &flyer.by_position(gravity));
    let center = flyer.function(Function::CenterOfMass);
    let jacobian = flyer.value(Function::CenterOfMassJacobian);
    near("d com", &jacobian, &flyer.by_position(center));
    let hand = flyer.function(Function::ForwardKinematics);
    let origin = |at: &Doubles| [3, 7, 11].map(|i| hand(at)[i]).to_vec();
    let jacobian = flyer.value(Function::Jacobian);
    near("J", &jacobian[..3 * N], &flyer.by_position(origin));
    let energy = flyer.function(Function::KineticEnergy);
    let momentum = flyer.value(Function::GeneralizedMomentum);
    near("M v", &momentum, &flyer.by_velocity(energy));
}

/// The second derivatives by positions are the symmetric ones of f(p + R d, R exp(phi), q).
#[test]
fn second_derivatives_are_those_of_displacements() {
    let flyer = &Flyer::new();
    let found = flyer.value(Function::InverseDynamicsSecondDerivatives);
    let cube = N.pow(3);
    let [by_q, by_v, mixed, of_m] = [0, 1, 2, 3].map(|i| &found[i * cube..(i + 1) * cube]);
    let torques = flyer.function(Function::InverseDynamics);
    let step = 1e-3;
    let mut expected = vec![0.0; cube];
    for j in 0..N {
        for k in 0..N {
            let at = |a: f64, b: f64| {
                let by = sum(&[&unit(j, a * step), &unit(k, b * step)]);
                torques(&flyer.at.displaced(&by))
            };
            let (up, down) = (
                sum(&[&at(1.0, 1.0), &at(-1.0, -1.0)]),
                sum(&[&at(1.0, -1.0), &at(-1.0, 1.0)]),
            );
            for i in 0..N {
                expected[(i * N + j) * N + k] = (up[i] - down[i]) / (4.0 * step * step);
            }
        }
    }
    // Second differences lose more.
    assert_near("by q and q", by_q, &expected, 1e8 * largest(&expected));
    let first = flyer.function(Function::InverseDynamicsDerivatives);
    let by_velocity = |at: &Doubles| first(at)[N * N..].to_vec();
    near("by v and v", by_v, &flyer.by_velocity(by_velocity));
    // Rows are those of q.
    let columns = flyer.by_position(by_velocity);
    let turned: Vec<f64> = columns
        .chunks(N * N)
        .flat_map(|of_one| transposed(of_one, N))
        .collect();
    near("by q and v", mixed, &turned);
    let matrix = flyer.function(Function::MassMatrix);
    near("dM", of_m, &flyer.by_position(matrix));
}

#[test]
fn rates_are_those_along_the_motion() {
    let flyer = &Flyer::new();
    let (v, a) = (&flyer.at.v, &flyer.at.a);
    let jacobian = flyer.value(Function::Jacobian);
    let rate = flyer.value(Function::JacobianRate);
    near(
        "dJ/dt",
        &rate,
        &flyer.by_time(flyer.function(Function::Jacobian)),
    );
    same(
        "J v",
        &flyer.value(Function::ToolVelocity),
        &times(&jacobian, v),
    );
    let expected = sum(&[&times(&jacobian, a), &times(&rate, v)]);
    same(
        "J a + dJ/dt v",
        &flyer.value(Function::ToolAcceleration),
        &expected,
    );
    // dM/dt = C + C', because dM/dt - 2 C is skew.
    let coriolis = flyer.value(Function::CoriolisMatrix);
    let both = sum(&[&coriolis, &transposed(&coriolis, N)]);
    near(
        "C + C'",
        &both,
        &flyer.by_time(flyer.function(Function::MassMatrix)),
    );
    same(
        "C v",
        &times(&coriolis, v),
        &flyer.value(Function::CoriolisVector),
    );
    let forces = flyer.value(Function::InverseDynamics);
    let bias = flyer.value(Function::MomentumBias);
    let momentum = flyer.by_time(flyer.function(Function::GeneralizedMomentum));
    near("d(M v)/dt", &sum(&[&forces, &bias]), &momentum);
    let rates = flyer.value(Function::InverseDynamicsRates);
    near(
        "d tau/dt",
        &rates[..N],
        &flyer.by_time(flyer.function(Function::InverseDynamics)),
    );
    let first = flyer.function(Function::InverseDynamicsRates);
    near(
        "d2 tau/dt2",
        &rates[N..],
        &flyer.by_time(|at| first(at)[..N].to_vec()),
    );
}

#[test]
fn functions_are_made_of_each_other() {
    let flyer = &Flyer::new();
    let (v, a) = (&flyer.at.v, &flyer.at.a);
    let matrix = flyer.value(Function::MassMatrix);
    let [coriolis, gravity] =
        [Function::CoriolisVector, Function::GravityVector].map(|f| flyer.value(f));
    let [spring, friction] =
        [Function::SpringVector, Function::FrictionVector].map(|f| flyer.value(f));
    let bias = flyer.value(Function::BiasForce);
    same(
        "bias",
        &bias,
        &sum(&[&coriolis, &gravity, &spring, &friction]),
    );
    let forces = flyer.value(Function::InverseDynamics);
    same("tau", &forces, &sum(&[&times(&matrix, a), &bias]));
    let energy: f64 = times(&matrix, v)
        .iter()
        .zip(v)
        .map(|(p, v)| p * v / 2.0)
        .sum();
    same("T", &flyer.value(Function::KineticEnergy), &[energy]);
    let parameters = flyer.value(Function::BaseParameters);
    let regressor = flyer.value(Function::Regressor);
    let of_regressor = sum(&[&times(&regressor, &parameters), &spring, &friction]);
    same("Y b", &of_regressor, &forces);
    let energies = flyer.value(Function::EnergyRegressors);
    same(
        "T b",
        &times(&energies[..parameters.len()], &parameters),
        &[energy],
    );
    // A controller, with another velocity and another acceleration.
    let [v_r, a_r] = [Argument::ReferenceVelocity, Argument::ReferenceAcceleration]
        .map(|argument| entries(argument, N));
    let matrix_c = flyer.value(Function::CoriolisMatrix);
    let expected = sum(&[
        &times(&matrix, &a_r),
        &times(&matrix_c, &v_r),
        &gravity,
        &spring,
        &friction,
    ]);
    same(
        "passivity",
        &flyer.value(Function::PassivityTorque),
        &expected,
    );
    let regressor = flyer.value(Function::PassivityRegressor);
    let of_regressor = sum(&[&times(&regressor, &parameters), &spring, &friction]);
    same("Y_r b", &of_regressor, &expected);
    // M a is what is left of the forces.
    let accelerations = flyer.value(Function::ForwardDynamics);
    let found = sum(&[&times(&matrix, &accelerations[..N]), &bias]);
    same("M a", &found, &flyer.at.tau);
    // J' w, and J M^-1 J'.
    let jacobian = flyer.value(Function::Jacobian);
    let outwards = transposed(&jacobian, N);
    let wrench = entries(Argument::Wrench, 6);
    same(
        "J' w",
        &flyer.value(Function::WrenchTorques),
        &times(&outwards, &wrench),
    );
    let derivatives = flyer.value(Function::ForwardDynamicsDerivatives);
    let inverse = &derivatives[2 * N * N..3 * N * N];
    let column = |k: usize| {
        let column: Vec<f64> = outwards.iter().skip(k).step_by(6).copied().collect();
        times(&jacobian, &times(inverse, &column))
    };
    let expected: Vec<f64> = (0..6).flat_map(column).collect();
    same(
        "J M^-1 J'",
        &flyer.value(Function::OperationalInertiaInverse)[..36],
        &expected,
    );
}
