//! Numeric values at a state, by the algorithm of the robot's kind of base.

use nalgebra::{Const, DMatrix, DVector, Dyn, Matrix4, Matrix6xX, OMatrix, Vector3, Vector6};

use super::at::At;
use super::numeric::Numeric;
use crate::size::SizedSecondDerivatives;

/// Methods of a state by those of both algorithms: of functions that do not read where the base stands, and of those that do.
macro_rules! values {
    (
        plain { $($plain:ident($($x:ident),*) -> $value:ty;)* }
        on_base { $($on_base:ident $([$frame:ident])? ($($y:ident),*) -> $other:ty;)* }
    ) => {
        impl At<'_> {
            $(pub(super) fn $plain(&self) -> $value {
                match self.numeric {
                    Numeric::Standing(arm) => arm.$plain($(self.$x),*),
                    Numeric::Floating(robot) => robot.$plain($(self.$x),*),
                }
            })*

            $(pub(super) fn $on_base(&self $(, $frame: usize)?) -> $other {
                match self.numeric {
                    Numeric::Standing(arm) => arm.$on_base($($frame,)? $(self.$y),*),
                    Numeric::Floating(robot) => robot.$on_base($($frame,)? self.base, $(self.$y),*),
                }
            })*
        }
    };
}

values! {
    plain {
    friction_vector(qd) -> DVector<f64>;
    spring_vector(q) -> DVector<f64>;
    kinetic_energy(q, qd) -> f64;
    coriolis_matrix(q, qd) -> DMatrix<f64>;
    }
    on_base {
    gravity_vector(q) -> DVector<f64>;
    bias_force(q, qd) -> DVector<f64>;
    potential_energy(q) -> f64;
    forward_kinematics(q) -> Matrix4<f64>;
    frame_pose[frame](q) -> Matrix4<f64>;
    jacobian(q) -> Matrix6xX<f64>;
    frame_jacobian[frame](q) -> Matrix6xX<f64>;
    jacobian_rate(q, qd) -> Matrix6xX<f64>;
    frame_jacobian_rate[frame](q, qd) -> Matrix6xX<f64>;
    link_poses(q) -> Vec<Matrix4<f64>>;
    link_jacobians(q) -> Vec<Matrix6xX<f64>>;
    center_of_mass(q) -> Vector3<f64>;
    center_of_mass_jacobian(q) -> OMatrix<f64, Const<3>, Dyn>;
    centroidal_momentum_matrix(q) -> Matrix6xX<f64>;
    centroidal_momentum_bias(q, qd) -> Vector6<f64>;
    inverse_dynamics_derivatives(q, qd, qdd) -> (DMatrix<f64>, DMatrix<f64>);
    inverse_dynamics_second_derivatives(q, qd, qdd) -> SizedSecondDerivatives<Dyn>;
    }
}

impl At<'_> {
    pub(super) fn coriolis_vector(&self) -> DVector<f64> {
        self.numeric.coriolis_vector(self.q, self.qd)
    }

    pub(super) fn rates(&self) -> (DVector<f64>, DVector<f64>) {
        let (jerk, snap) = (self.state.jerk(), self.state.snap());
        let (q, qd, qdd) = (self.q, self.qd, self.qdd);
        match self.numeric {
            Numeric::Standing(arm) => arm.inverse_dynamics_rates(q, qd, qdd, &jerk, &snap),
            Numeric::Floating(robot) => {
                robot.inverse_dynamics_rates(self.base, q, qd, qdd, &jerk, &snap)
            }
        }
    }

    /// d tau/dq and d tau/dqd at other accelerations.
    pub(super) fn derivatives_at(&self, qdd: &DVector<f64>) -> (DMatrix<f64>, DMatrix<f64>) {
        let at = At {
            qdd,
            mass_matrix: DMatrix::zeros(0, 0),
            ..*self
        };
        at.inverse_dynamics_derivatives()
    }
}
