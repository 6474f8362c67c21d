//! The functions that have a trait of their own.

use core::convert::Infallible;

use super::{Entries, Function, Of, functions};
use crate::model::{
    CoriolisVector, ForwardDynamics, GravityVector, InverseDynamics, MassMatrix, UNKNOWN_WORK,
};
use crate::{Inputs, MAX_TAYLOR_ORDER, Scalar, SingularMassMatrix, TaylorDynamics};

macro_rules! provided {
    ($($name:ident: [$($argument:ident),*] -> $result:literal, $columns:tt, $error:ty,
        |$robot:ident, $inputs:ident| $value:expr;)*) => {$(
        impl<A: $name<N>, const N: usize> Function<functions::$name, N> for A {
            type Arguments = ($(provided!(@vector $argument),)*);
            type Values = Entries<N, $columns>;
            type Error = $error;

            const ARGUMENTS: &'static [&'static str] = &[$(stringify!($argument)),*];
            const RESULT: &'static str = $result;
            const WORK: u32 = <A as $name<N>>::WORK;

            #[inline(always)]
            fn at<T: Scalar>(
                &self,
                _: functions::$name,
                $inputs: &impl Inputs<T>,
                ($($argument,)*): &Of<Self::Arguments, T>,
            ) -> Result<Of<Self::Values, T>, $error> {
                let $robot = self;
                $value
            }
        }
    )*};
    (@vector $argument:ident) => { Entries<N, 1> };
}

provided! {
    MassMatrix: [q] -> "mass_matrix", N, Infallible,
        |robot, inputs| Ok(robot.mass_matrix_at(inputs, q));
    CoriolisVector: [q, qd] -> "coriolis_vector", 1, Infallible,
        |robot, inputs| Ok(robot.coriolis_vector_at(inputs, q, qd));
    GravityVector: [q] -> "gravity_vector", 1, Infallible,
        |robot, inputs| Ok(robot.gravity_vector_at(inputs, q));
    InverseDynamics: [q, qd, qdd] -> "tau", 1, Infallible,
        |robot, inputs| Ok(robot.inverse_dynamics_at(inputs, q, qd, qdd));
    ForwardDynamics: [q, qd, tau] -> "qdd", 1, SingularMassMatrix,
        |robot, inputs| robot.forward_dynamics_at(inputs, q, qd, tau);
}

/// In lanes already, those of its products.
impl<A: TaylorDynamics<N>, const N: usize> Function<functions::TaylorSeries, N> for A {
    type Arguments = (Entries<N, 1>, Entries<N, 1>, Entries<N, 1>);
    type Values = [Entries<N, 1>; MAX_TAYLOR_ORDER + 1];
    type Error = SingularMassMatrix;

    const ARGUMENTS: &'static [&'static str] = &["q", "qd", "tau"];
    const RESULT: &'static str = "taylor_series";
    // Some thirty orders of the inverse dynamics.
    const WORK: u32 = 30 * UNKNOWN_WORK;
    const IN_LANES: bool = false;

    #[inline(always)]
    fn at<T: Scalar>(
        &self,
        functions::TaylorSeries { order }: functions::TaylorSeries,
        _: &impl Inputs<T>,
        (q, qd, tau): &Of<Self::Arguments, T>,
    ) -> Result<Of<Self::Values, T>, SingularMassMatrix> {
        self.taylor_series(q, qd, tau, order)
    }
}
