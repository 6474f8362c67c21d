//! The methods of integration, all of them.

use robot_dynamics::{
    Method,
    simulation::{Dop853, DormandPrince, Radau5},
};

/// The methods of fixed step.
pub(crate) fn fixed(step: f64) -> [Method; 7] {
    [
        Method::ExplicitEuler { step },
        Method::CraigEuler { step },
        Method::SemiImplicitEuler { step },
        Method::RungeKutta4 { step },
        Method::ImplicitMidpoint { step },
        Method::GaussLegendre4 { step },
        Method::GaussLegendre6 { step },
    ]
}

/// The methods with error control; the last one is implicit.
pub(crate) fn controlled(tolerance: f64) -> [Method; 3] {
    [
        DormandPrince::with_tolerance(tolerance).into(),
        Dop853::with_tolerance(tolerance).into(),
        Radau5::with_tolerance(tolerance).into(),
    ]
}
