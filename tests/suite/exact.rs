//! [`Exact`], the reference of errors, and programs that are evaluated in extended precision, both against 25 digits.

use robot_dynamics::nalgebra::{SMatrix, SVector};
use robot_dynamics::{CoriolisVector, GravityVector, MassMatrix, Model};
use robot_dynamics::{DoubleDouble, ForwardDynamics, InverseDynamics};
use robots::*;
use testkit::exact::Exact;
use testkit::random::Random;
use testkit::references::{Decimal, ReferenceFile, ReferenceState, read};

/// Relative to the natural magnitude: half a unit in the 25th digit of a number that begins with 1,
/// and as much for friction, which the references have apart.
const BOUND: f64 = 1e-24;

/// The functions of an arm in extended precision at one state.
struct Values<const N: usize> {
    mass_matrix: SMatrix<DoubleDouble, N, N>,
    coriolis_vector: SVector<DoubleDouble, N>,
    gravity_vector: SVector<DoubleDouble, N>,
    torque: SVector<DoubleDouble, N>,
    acceleration: SVector<DoubleDouble, N>,
}

/// A state, and the torques there: exact ones, to which friction is added.
struct At<const N: usize> {
    q: SVector<DoubleDouble, N>,
    qd: SVector<DoubleDouble, N>,
    qdd: SVector<DoubleDouble, N>,
    torque: SVector<DoubleDouble, N>,
}

impl<const N: usize> At<N> {
    fn new(reference: &ReferenceState) -> Self {
        let [q, qd, qdd] = [&reference.q, &reference.qd, &reference.qdd]
            .map(|x| SVector::from_fn(|i, _| DoubleDouble::from(x[i])));
        let torque = exact(&reference.tau) + exact(&reference.friction);
        At { q, qd, qdd, torque }
    }
}

fn exact<const N: usize>(x: &[Decimal]) -> SVector<DoubleDouble, N> {
    SVector::from_fn(|i, _| x[i].value())
}

fn of_table<const N: usize>(robot: &impl Model<N>, at: &At<N>) -> Values<N> {
    let table = robot.table();
    let exact = Exact(&table);
    Values {
        mass_matrix: exact.mass_matrix(&at.q),
        coriolis_vector: exact.coriolis_vector(&at.q, &at.qd),
        gravity_vector: exact.gravity_vector(&at.q),
        torque: exact.inverse_dynamics(&at.q, &at.qd, &at.qdd),
        acceleration: exact.forward_dynamics(&at.q, &at.qd, &at.torque),
    }
}

fn of_program<const N: usize, R>(robot: &R, at: &At<N>) -> Values<N>
where
    R: MassMatrix<N>
        + CoriolisVector<N>
        + GravityVector<N>
        + InverseDynamics<N>
        + ForwardDynamics<N>,
{
    let qdd = robot.forward_dynamics(&at.q, &at.qd, &at.torque);
    Values {
        mass_matrix: robot.mass_matrix(&at.q),
        coriolis_vector: robot.coriolis_vector(&at.q, &at.qd),
        gravity_vector: robot.gravity_vector(&at.q),
        torque: robot.inverse_dynamics(&at.q, &at.qd, &at.qdd),
        acceleration: qdd.expect("the mass matrix is positive definite"),
    }
}

/// The largest of the entries.
pub(super) fn largest<const R: usize, const C: usize>(
    difference: &SMatrix<DoubleDouble, R, C>,
) -> f64 {
    difference
        .iter()
        .map(|x| x.high().abs())
        .fold(0.0, f64::max)
}

/// The largest errors, relative to the magnitudes, of M, V, G, tau and qdd. Accelerations are judged
/// by the torques that their errors take.
fn errors<const N: usize>(found: &Values<N>, at: &At<N>, reference: &ReferenceState) -> [f64; 5] {
    let m = SMatrix::from_fn(|i, j| reference.mass_matrix[i][j].value());
    let v = exact(&reference.coriolis_vector);
    let g = exact(&reference.gravity_vector);
    let scale = &reference.scale;
    let torque = scale.tau.max(largest(&at.torque));
    let over = |error: f64, scale: f64| if error == 0.0 { 0.0 } else { error / scale };
    [
        over(largest(&(found.mass_matrix - m)), scale.M),
        over(
            largest(&(found.coriolis_vector - v)),
            scale.V.max(largest(&v)),
        ),
        over(largest(&(found.gravity_vector - g)), scale.G),
        over(largest(&(found.torque - at.torque)), torque),
        over(largest(&(m * (found.acceleration - at.qdd))), torque),
    ]
}

/// Asserts the bound at every state of a file, and prints the largest error.
fn check<const N: usize>(file: &str, values: impl Fn(&At<N>) -> Values<N>) {
    let states: ReferenceFile = read("reference", file);
    let mut worst = [0.0_f64; 5];
    for reference in &states.states {
        let at = At::new(reference);
        let errors = errors(&values(&at), &at, reference);
        for (error, worst) in errors.into_iter().zip(&mut worst) {
            assert!(error <= BOUND, "{file} {}: {errors:?}", reference.label);
            *worst = worst.max(error);
        }
    }
    println!(
        "{file:26} M, V, G, tau, qdd {}",
        worst.map(|x| format!("{x:.1e}")).join(" ")
    );
}

macro_rules! tables_of_all {
    ($($file:ident: $robot:ident, $n:literal, $p:literal;)*) => {
        $(check(stringify!($file), |at| of_table::<$n>(&$robot, at));)*
    };
}

#[test]
fn tables_in_31_digits_have_the_values_of_the_references() {
    for_each_robot!(tables_of_all);
}

/// Where every cell is a field, no constant of the program is rounded.
#[test]
fn programs_in_31_digits_have_the_values_of_the_references() {
    let puma = Puma560Fields::of_table();
    check("puma560", |at| of_program::<6, _>(&puma, at));
    let stanford = StanfordFields::of_table();
    check("stanford", |at| of_program::<6, _>(&stanford, at));
    let chain = GenericChain3Fields::of_table();
    check("generic_chain_n3", |at| of_program::<3, _>(&chain, at));
}

/// tau and qdd in doubles beside the table in 31 digits, relative to what is added up: friction in both
/// directions and at speeds at which it falls, springs on both sides of where they are slack.
fn joint_forces<const N: usize>(robot: &(impl Model<N> + InverseDynamics<N> + ForwardDynamics<N>)) {
    let table = robot.table();
    let exact = Exact(&table);
    let mut random = Random::seeded(11);
    let mut worst = 0.0_f64;
    for _ in 0..200 {
        let q: SVector<f64, N> = random.vector(3.0);
        let qd: SVector<f64, N> = random.vector(2.0);
        let qdd: SVector<f64, N> = random.vector(10.0);
        let [x, xd, xdd] = [q, qd, qdd].map(|x| x.map(DoubleDouble::from));
        let tau = exact.inverse_dynamics(&x, &xd, &xdd);
        let m = exact.mass_matrix(&x);
        let size = largest(&m) * qdd.amax()
            + largest(&exact.coriolis_vector(&x, &xd))
            + largest(&exact.gravity_vector(&x))
            + largest(&exact.springs(&x))
            + largest(&tau);
        let error = robot
            .inverse_dynamics(&q, &qd, &qdd)
            .map(DoubleDouble::from)
            - tau;
        let given = tau.map(DoubleDouble::high);
        let found = robot.forward_dynamics(&q, &qd, &given).expect("regular");
        let missing = m * (found.map(DoubleDouble::from) - xdd);
        worst = worst.max(largest(&error).max(largest(&missing)) / size);
    }
    println!("{worst:.1e} of the natural magnitude");
    assert!(worst <= 1e-15 * N as f64, "{worst:e}");
}

#[test]
fn springs_and_friction_have_the_digits_of_the_table() {
    joint_forces(&SprungArm);
    joint_forces(&StickyArm);
}
