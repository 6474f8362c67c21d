//! A robot as a trait object, on a base that stands or on one that moves: what holds for it is compiled once, not once
//! for each robot or for each number of joints.

use num_dual::Dual64;
use robot_dynamics::nalgebra::{DMatrix, DVector, Matrix4, SVector};
use robot_dynamics::{
    DoubleDouble, Scalar, State as SizedState,
    check::{Evaluation, Numbers},
    table::RuntimeTable,
};
use robots::Arm;

use super::moving::Moving;
use super::place::{Argument, Place, State};

/// A value of its numbers, matrices by columns, of a robot with `n` degrees of freedom.
pub(super) trait Value<T> {
    fn of(numbers: &[T], n: usize) -> Self;
}

impl<T: Scalar> Value<T> for T {
    fn of(numbers: &[T], _: usize) -> Self {
        numbers[0]
    }
}

impl<T: Scalar> Value<T> for DVector<T> {
    fn of(numbers: &[T], _: usize) -> Self {
        DVector::from_column_slice(numbers)
    }
}

/// With a column for each degree of freedom.
impl<T: Scalar> Value<T> for DMatrix<T> {
    fn of(numbers: &[T], n: usize) -> Self {
        DMatrix::from_column_slice(numbers.len() / n, n, numbers)
    }
}

impl<T: Scalar> Value<T> for Matrix4<T> {
    fn of(numbers: &[T], _: usize) -> Self {
        Matrix4::from_column_slice(numbers)
    }
}

impl<T: Scalar> Value<T> for Vec<Matrix4<T>> {
    fn of(numbers: &[T], _: usize) -> Self {
        numbers.chunks(16).map(Matrix4::from_column_slice).collect()
    }
}

impl<T: Scalar, const K: usize> Value<T> for [DMatrix<T>; K] {
    fn of(numbers: &[T], n: usize) -> Self {
        let each = numbers.len() / K;
        std::array::from_fn(|k| DMatrix::of(&numbers[k * each..(k + 1) * each], n))
    }
}

/// Without numbers where M is singular.
impl<T: Scalar> Value<T> for Option<DVector<T>> {
    fn of(numbers: &[T], n: usize) -> Self {
        (!numbers.is_empty()).then(|| DVector::of(numbers, n))
    }
}

impl<T: Scalar, const K: usize> Value<T> for Option<[DMatrix<T>; K]> {
    fn of(numbers: &[T], n: usize) -> Self {
        (!numbers.is_empty()).then(|| Value::of(numbers, n))
    }
}

/// An arm of N joints, with P = N(N-1)/2 pairs of joints, by its generated methods.
pub(super) struct Generated<R, const N: usize, const P: usize>(pub(super) R);

macro_rules! argument {
    (q) => { Place<T> };
    ($other:ident) => { DVector<T> };
}

/// A trait for each function at one kind of number, so that a robot has those kinds of it that the
/// identities ask for, and the compiler writes no others.
macro_rules! functions {
    ($($trait:ident: $function:ident($($argument:ident),*) -> $value:ty;)*) => {$(
        pub(super) trait $trait<T: Scalar> {
            fn $function(&self, $($argument: &argument!($argument)),*) -> $value;
        }

        impl<T: Scalar, R: Arm<N, P>, const N: usize, const P: usize> $trait<T> for Generated<R, N, P> {
            fn $function(&self, $($argument: &argument!($argument)),*) -> $value {
                let mut numbers = Vec::new();
                R::$function(&self.0, $(&$argument.sized()),*).write(&mut numbers);
                Value::of(&numbers, N)
            }
        }

        impl<T: Scalar> $trait<T> for Moving {
            fn $function(&self, $($argument: &argument!($argument)),*) -> $value {
                let mut arguments = Vec::new();
                $($argument.name(stringify!($argument), &mut arguments);)*
                Value::of(&self.numbers(stringify!($function), &arguments), self.freedoms())
            }
        }
    )*};
}

functions! {
    MassMatrix: mass_matrix(q) -> DMatrix<T>;
    CoriolisVector: coriolis_vector(q, qd) -> DVector<T>;
    GravityVector: gravity_vector(q) -> DVector<T>;
    FrictionVector: friction_vector(qd) -> DVector<T>;
    SpringVector: spring_vector(q) -> DVector<T>;
    BiasForce: bias_force(q, qd) -> DVector<T>;
    InverseDynamics: inverse_dynamics(q, qd, qdd) -> DVector<T>;
    ForwardDynamics: forward_dynamics(q, qd, tau) -> Option<DVector<T>>;
    CoriolisMatrix: coriolis_matrix(q, qd) -> DMatrix<T>;
    // A column for each pair, one after the other.
    CoriolisCoefficients: coriolis_coefficients(q) -> DVector<T>;
    CentrifugalCoefficients: centrifugal_coefficients(q) -> DMatrix<T>;
    ForwardKinematics: forward_kinematics(q) -> Matrix4<T>;
    LinkPoses: link_poses(q) -> Vec<Matrix4<T>>;
    Jacobian: jacobian(q) -> DMatrix<T>;
    KineticEnergy: kinetic_energy(q, qd) -> T;
    PotentialEnergy: potential_energy(q) -> T;
    ForceDerivatives: inverse_dynamics_derivatives(q, qd, qdd) -> [DMatrix<T>; 2];
    MotionDerivatives: forward_dynamics_derivatives(q, qd, tau) -> Option<[DMatrix<T>; 3]>;
}

/// A trait for functions in several kinds of numbers.
macro_rules! kinds {
    ($($(#[$doc:meta])* $kind:ident: $($function:ident)+ => $number:ty;)*) => {$(
        $(#[$doc])*
        pub(super) trait $kind: $($function<$number> +)+ {}
        impl<R: $($function<$number> +)+> $kind for R {}
    )*};
}

kinds! {
    /// All functions in doubles.
    Doubles: MassMatrix CoriolisVector GravityVector FrictionVector SpringVector BiasForce InverseDynamics ForwardDynamics
        CoriolisMatrix CoriolisCoefficients CentrifugalCoefficients ForwardKinematics LinkPoses Jacobian KineticEnergy
        PotentialEnergy ForceDerivatives MotionDerivatives => f64;
    /// The functions that are differentiated.
    Duals: MassMatrix InverseDynamics ForwardDynamics ForwardKinematics LinkPoses KineticEnergy PotentialEnergy => Dual64;
    /// The functions that are compared in single precision.
    Singles: MassMatrix CoriolisVector GravityVector FrictionVector SpringVector InverseDynamics ForwardDynamics
        ForwardKinematics ForceDerivatives => f32;
}

pub(super) trait AnyRobot:
    Doubles + Duals + Singles + InverseDynamics<DoubleDouble>
{
    /// The name of its files in `tests/data`.
    fn file(&self) -> &str;
    fn table(&self) -> RuntimeTable;
    /// The end of the names of functions of the tip.
    fn tip(&self) -> &str {
        ""
    }
    /// The number of its degrees of freedom.
    fn freedoms(&self) -> usize;
    /// The values of all functions.
    fn evaluate(&self, state: &State, tau: &DVector<f64>) -> Evaluation;
    /// The rates of the momenta under the torques `tau`.
    fn force_on_momenta(&self, state: &State, tau: &DVector<f64>) -> DVector<f64>;
    /// M qd, and M^-1 of it.
    fn momentum_and_back(&self, state: &State) -> Option<[DVector<f64>; 2]>;
}

fn dynamic<const N: usize>(x: SVector<f64, N>) -> DVector<f64> {
    DVector::from_column_slice(x.as_slice())
}

impl<R: Arm<N, P>, const N: usize, const P: usize> AnyRobot for Generated<R, N, P> {
    fn file(&self) -> &str {
        R::FILE
    }

    fn table(&self) -> RuntimeTable {
        RuntimeTable::from(&self.0.table())
    }

    fn freedoms(&self) -> usize {
        N
    }

    fn evaluate(&self, state: &State, tau: &DVector<f64>) -> Evaluation {
        let [q, qd, qdd] = [state.q.sized(), state.qd.sized(), state.qdd.sized()];
        self.0.evaluate(&SizedState { q, qd, qdd }, &tau.sized())
    }

    fn force_on_momenta(&self, state: &State, tau: &DVector<f64>) -> DVector<f64> {
        let arm = self.0.momenta().expect("mass_matrix and inverse_dynamics");
        dynamic(arm.force(&state.q.sized(), &state.qd.sized(), &tau.sized()))
    }

    fn momentum_and_back(&self, state: &State) -> Option<[DVector<f64>; 2]> {
        let arm = self.0.momenta().expect("mass_matrix and inverse_dynamics");
        let q = state.q.sized();
        let momentum = arm.momentum(&q, &state.qd.sized());
        let velocity = arm.velocity(&q, &momentum).ok()?;
        Some([momentum, velocity].map(dynamic))
    }
}
