//! The functions that have a batch, under one signature.

use nalgebra::{SMatrix, SVector};

use crate::{
    CoriolisVector, ForwardDynamics, GravityVector, InverseDynamics, MassMatrix, Scalar,
    SingularMassMatrix,
};

/// A function of `K` vectors whose value has `C` columns.
pub(crate) trait Function<R, const N: usize, const K: usize, const C: usize> {
    /// The names of the arguments.
    const ARGUMENTS: [&'static str; K];

    /// The name of the results.
    const RESULT: &'static str;

    /// The value at a state. Only forward dynamics fails.
    fn at<T: Scalar>(
        robot: &R,
        arguments: &[SVector<T, N>; K],
    ) -> Result<SMatrix<T, N, C>, SingularMassMatrix>;
}

macro_rules! function {
    ($name:ident, $robot:ident: $of:ident, $arity:literal, $columns:tt, $result:literal, |$($argument:ident),*| $value:expr) => {
        /// The function of that name, for [`Function`].
        #[derive(Debug)]
        pub(crate) enum $name {}

        impl<R: $of<N>, const N: usize> Function<R, N, $arity, $columns> for $name {
            const ARGUMENTS: [&'static str; $arity] = [$(stringify!($argument)),*];
            const RESULT: &'static str = $result;

            #[inline(always)]
            fn at<T: Scalar>(
                $robot: &R,
                [$($argument),*]: &[SVector<T, N>; $arity],
            ) -> Result<SMatrix<T, N, $columns>, SingularMassMatrix> {
                $value
            }
        }
    };
}

function!(M, robot: MassMatrix, 1, N, "mass_matrix", |q| Ok(robot.mass_matrix(q)));
function!(V, robot: CoriolisVector, 2, 1, "coriolis_vector", |q, qd| Ok(
    robot.coriolis_vector(q, qd)
));
function!(G, robot: GravityVector, 1, 1, "gravity_vector", |q| Ok(
    robot.gravity_vector(q)
));
function!(Tau, robot: InverseDynamics, 3, 1, "tau", |q, qd, qdd| Ok(
    robot.inverse_dynamics(q, qd, qdd)
));
function!(Qdd, robot: ForwardDynamics, 3, 1, "qdd", |q, qd, tau| robot
    .forward_dynamics(q, qd, tau));
