//! The two arms of Saha's examples, by their closed forms.

use robot_dynamics::nalgebra::{Matrix1, Matrix2, SMatrix, SVector, Vector1, Vector2};
use robot_dynamics::{
    Energy, ForwardDynamics, InverseDynamics, MassMatrix, Scalar, SingularMassMatrix,
    simulation::Momenta,
};

const G: f64 = 9.81;

/// A slender rod of 1 kg and 1 m, hanging at q = 0: (1/3) qdd + (1/2) g sin q = tau.
pub(crate) struct OneLink;

impl ForwardDynamics<1> for OneLink {
    fn forward_dynamics<T: Scalar>(
        &self,
        q: &SVector<T, 1>,
        _qd: &SVector<T, 1>,
        tau: &SVector<T, 1>,
    ) -> Result<SVector<T, 1>, SingularMassMatrix> {
        let (sin, _) = q[0].sin_cos();
        let gravity = T::from_f64(G / 2.0) * sin;
        Ok(Vector1::new(T::from_f64(3.0) * (tau[0] - gravity)))
    }

    fn momenta(&self) -> Option<&dyn Momenta<1>> {
        Some(self)
    }
}

impl MassMatrix<1> for OneLink {
    fn mass_matrix<T: Scalar>(&self, _q: &SVector<T, 1>) -> SMatrix<T, 1, 1> {
        Matrix1::new(T::from_f64(1.0 / 3.0))
    }
}

impl InverseDynamics<1> for OneLink {
    fn inverse_dynamics<T: Scalar>(
        &self,
        q: &SVector<T, 1>,
        _qd: &SVector<T, 1>,
        qdd: &SVector<T, 1>,
    ) -> SVector<T, 1> {
        let (sin, _) = q[0].sin_cos();
        Vector1::new(T::from_f64(1.0 / 3.0) * qdd[0] + T::from_f64(G / 2.0) * sin)
    }
}

impl Energy<1> for OneLink {
    fn kinetic_energy<T: Scalar>(&self, _q: &SVector<T, 1>, qd: &SVector<T, 1>) -> T {
        qd[0] * qd[0] / T::from_f64(6.0)
    }

    fn potential_energy<T: Scalar>(&self, q: &SVector<T, 1>) -> T {
        let (_, cos) = q[0].sin_cos();
        T::from_f64(-G / 2.0) * cos
    }
}

/// Slender rods of 3 kg and 2 m, and of 1 kg and 1 m, the first horizontal at q = 0.
pub(crate) struct TwoLink;

const M1: f64 = 3.0;
const M2: f64 = 1.0;
const A1: f64 = 2.0;
const A2: f64 = 1.0;

impl TwoLink {
    /// i11, i12, i22.
    fn inertias<T: Scalar>(q: &SVector<T, 2>) -> [T; 3] {
        let (_, c2) = q[1].sin_cos();
        let mixed = T::from_f64(M2 * A1 * A2) * c2;
        let i22 = T::from_f64(M2 * A2 * A2 / 3.0);
        let i12 = i22 + mixed * T::from_f64(0.5);
        let i11 = T::from_f64(M1 * A1 * A1 / 3.0 + M2 * A1 * A1) + i22 + mixed;
        [i11, i12, i22]
    }
}

impl TwoLink {
    /// V + G.
    fn bias<T: Scalar>(q: &SVector<T, 2>, qd: &SVector<T, 2>) -> SVector<T, 2> {
        let (s2, _) = q[1].sin_cos();
        let (_, c1) = q[0].sin_cos();
        let (_, c12) = (q[0] + q[1]).sin_cos();
        let h = T::from_f64(M2 * A1 * A2 / 2.0) * s2;
        let gamma2 = T::from_f64(M2 * G * A2 / 2.0) * c12;
        let gamma1 = T::from_f64((M1 / 2.0 + M2) * G * A1) * c1 + gamma2;
        Vector2::new(
            gamma1 - h * (qd[0] + qd[0] + qd[1]) * qd[1],
            gamma2 + h * qd[0] * qd[0],
        )
    }
}

impl MassMatrix<2> for TwoLink {
    fn mass_matrix<T: Scalar>(&self, q: &SVector<T, 2>) -> SMatrix<T, 2, 2> {
        let [i11, i12, i22] = Self::inertias(q);
        Matrix2::new(i11, i12, i12, i22)
    }
}

impl InverseDynamics<2> for TwoLink {
    fn inverse_dynamics<T: Scalar>(
        &self,
        q: &SVector<T, 2>,
        qd: &SVector<T, 2>,
        qdd: &SVector<T, 2>,
    ) -> SVector<T, 2> {
        let [i11, i12, i22] = Self::inertias(q);
        let bias = Self::bias(q, qd);
        Vector2::new(
            i11 * qdd[0] + i12 * qdd[1] + bias[0],
            i12 * qdd[0] + i22 * qdd[1] + bias[1],
        )
    }
}

impl ForwardDynamics<2> for TwoLink {
    fn forward_dynamics<T: Scalar>(
        &self,
        q: &SVector<T, 2>,
        qd: &SVector<T, 2>,
        tau: &SVector<T, 2>,
    ) -> Result<SVector<T, 2>, SingularMassMatrix> {
        let [i11, i12, i22] = Self::inertias(q);
        let bias = Self::bias(q, qd);
        let (f1, f2) = (tau[0] - bias[0], tau[1] - bias[1]);
        let determinant = i11 * i22 - i12 * i12;
        Ok(Vector2::new(
            (i22 * f1 - i12 * f2) / determinant,
            (i11 * f2 - i12 * f1) / determinant,
        ))
    }

    fn momenta(&self) -> Option<&dyn Momenta<2>> {
        Some(self)
    }
}

impl Energy<2> for TwoLink {
    fn kinetic_energy<T: Scalar>(&self, q: &SVector<T, 2>, qd: &SVector<T, 2>) -> T {
        let [i11, i12, i22] = Self::inertias(q);
        let squares = i11 * qd[0] * qd[0] + i22 * qd[1] * qd[1];
        T::from_f64(0.5) * squares + i12 * qd[0] * qd[1]
    }

    fn potential_energy<T: Scalar>(&self, q: &SVector<T, 2>) -> T {
        let (s1, _) = q[0].sin_cos();
        let (s12, _) = (q[0] + q[1]).sin_cos();
        T::from_f64((M1 / 2.0 + M2) * G * A1) * s1 + T::from_f64(M2 * G * A2 / 2.0) * s12
    }
}
