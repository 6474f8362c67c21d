impl Arm {
    /// Mass matrix M(q), N x N, both triangles, reflected motor inertias included (kg m^2, kg m or kg). Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong).
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 0 multiplications, 0 additions.
    ///
    /// ```text
    /// M11 = 22
    /// M12 = 0
    /// M13 = 0
    /// M21 = 0
    /// M22 = 10
    /// M23 = 0
    /// M31 = 0
    /// M32 = 0
    /// M33 = 3
    /// ```
    /// with si, ci the sine and cosine of qi.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn mass_matrix<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 3, 3> {
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([
                [k(22.0), k(0.0), k(0.0)],
                [k(0.0), k(10.0), k(0.0)],
                [k(0.0), k(0.0), k(3.0)],
            ]),
        )
    }
    /// Coriolis and centrifugal vector V(q, qd), N m or N: inverse dynamics without gravity, friction and acceleration.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 0 multiplications, 0 additions.
    ///
    /// ```text
    /// V1 = 0
    /// V2 = 0
    /// V3 = 0
    /// ```
    /// with si, ci the sine and cosine of qi.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn coriolis_vector<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 3> {
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[k(0.0), k(0.0), k(0.0)]]),
        )
    }
    /// Gravity vector G(q) = dU/dq, N m or N: inverse dynamics at rest.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 0 multiplications, 0 additions.
    ///
    /// ```text
    /// G1 = 215.82
    /// G2 = 0
    /// G3 = 0
    /// ```
    /// with si, ci the sine and cosine of qi.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn gravity_vector<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 3> {
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[k(215.82), k(0.0), k(0.0)]]),
        )
    }
    /// Friction vector F(qd) = viscous qd + coulomb sign(qd), N m or N, with sign(0) = 0.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 6 multiplications, 3 additions.
    ///
    /// ```text
    /// F1 = 5 qd1 + 8 sign(qd1)
    /// F2 = 4 qd2 + 6 sign(qd2)
    /// F3 = 3 qd3 + 4 sign(qd3)
    /// ```
    /// with si, ci the sine and cosine of qi.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn friction_vector<T: ::robot_dynamics::Scalar>(
        &self,
        qd: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 3> {
        let qd1 = qd.data.0[0][0];
        let qd2 = qd.data.0[0][1];
        let qd3 = qd.data.0[0][2];
        let sgn1 = ::robot_dynamics::Scalar::sign(qd.data.0[0][0]);
        let sgn2 = ::robot_dynamics::Scalar::sign(qd.data.0[0][1]);
        let sgn3 = ::robot_dynamics::Scalar::sign(qd.data.0[0][2]);
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        let t1 = k(5.0) * qd1 + k(8.0) * sgn1;
        let t2 = k(4.0) * qd2 + k(6.0) * sgn2;
        let t3 = k(3.0) * qd3 + k(4.0) * sgn3;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t1, t2, t3]]),
        )
    }
    /// Inverse dynamics tau = M(q) qdd + V(q, qd) + G(q) + F(qd), N m or N, as one program.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 8 multiplications, 7 additions.
    ///
    /// ```text
    /// tau1 = 8 sign(qd1) + 22 (qdd1 + 9.81) + 5 qd1
    /// tau2 = 6 sign(qd2) + 10 qdd2 + 4 qd2
    /// tau3 = 3 (qd3 + qdd3 + 1.3333333333333333 sign(qd3))
    /// ```
    /// with si, ci the sine and cosine of qi.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn inverse_dynamics<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 3>,
        qdd: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 3> {
        let qd1 = qd.data.0[0][0];
        let qd2 = qd.data.0[0][1];
        let qd3 = qd.data.0[0][2];
        let sgn1 = ::robot_dynamics::Scalar::sign(qd.data.0[0][0]);
        let sgn2 = ::robot_dynamics::Scalar::sign(qd.data.0[0][1]);
        let sgn3 = ::robot_dynamics::Scalar::sign(qd.data.0[0][2]);
        let qdd1 = qdd.data.0[0][0];
        let qdd2 = qdd.data.0[0][1];
        let qdd3 = qdd.data.0[0][2];
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        let t1 = qdd1 + k(9.81);
        let t2 = k(22.0) * t1 + k(5.0) * qd1;
        let t3 = k(8.0) * sgn1 + t2;
        let t4 = k(10.0) * qdd2 + k(4.0) * qd2;
        let t5 = k(6.0) * sgn2 + t4;
        let t6 = qd3 + qdd3;
        let t7 = t6 + k(1.3333333333333333) * sgn3;
        let t8 = k(3.0) * t7;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t3, t5, t8]]),
        )
    }
    /// Forward dynamics: the accelerations qdd with M(q) qdd + V(q, qd) + G(q) + F(qd) = tau, rad/s^2 or m/s^2.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 8 multiplications, 7 additions.
    ///
    /** # Errors

 `SingularMassMatrix` where M(q) is not positive definite, or an input is not finite: it names the joint whose pivot failed.*/
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn forward_dynamics<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 3>,
        tau: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> ::core::result::Result<
        ::robot_dynamics::nalgebra::SVector<T, 3>,
        ::robot_dynamics::SingularMassMatrix,
    > {
        let qd1 = qd.data.0[0][0];
        let qd2 = qd.data.0[0][1];
        let qd3 = qd.data.0[0][2];
        let sgn1 = ::robot_dynamics::Scalar::sign(qd.data.0[0][0]);
        let sgn2 = ::robot_dynamics::Scalar::sign(qd.data.0[0][1]);
        let sgn3 = ::robot_dynamics::Scalar::sign(qd.data.0[0][2]);
        let tau1 = tau.data.0[0][0];
        let tau2 = tau.data.0[0][1];
        let tau3 = tau.data.0[0][2];
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        let t1 = tau1 - k(215.82);
        let t2 = k(5.0) * qd1 - t1;
        let t3 = k(8.0) * sgn1 + t2;
        let t4 = k(0.045454545454545456) * t3;
        let t5 = tau2 - k(4.0) * qd2;
        let t6 = t5 - k(6.0) * sgn2;
        let t7 = k(0.1) * t6;
        let t8 = qd3 - k(0.3333333333333333) * tau3;
        let t9 = t8 + k(1.3333333333333333) * sgn3;
        ::robot_dynamics::SingularMassMatrix::test(2, k(3.0), k(3.0))?;
        ::robot_dynamics::SingularMassMatrix::test(1, k(10.0), k(10.0))?;
        ::robot_dynamics::SingularMassMatrix::test(0, k(22.0), k(22.0))?;
        ::core::result::Result::Ok(
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[-t4, t7, -t9]]),
            ),
        )
    }
    /// Kinetic energy T(q, qd) = 1/2 qd^T M(q) qd, reflected motor inertias included, J.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 6 multiplications, 4 additions.
    ///
    /// ```text
    /// T = 6 (qd1 qd1 + 0.5833333333333334 (qd1 qd1 + qd2 qd2) + 0.25 (qd1 qd1 + qd2 qd2 + qd3 qd3))
    /// ```
    /// with si, ci the sine and cosine of qi.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn kinetic_energy<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> T {
        let qd1 = qd.data.0[0][0];
        let qd2 = qd.data.0[0][1];
        let qd3 = qd.data.0[0][2];
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        let t1 = qd1 * qd1;
        let t2 = t1 + qd2 * qd2;
        let t3 = t1 + k(0.5833333333333334) * t2;
        let t4 = t2 + qd3 * qd3;
        let t5 = t3 + k(0.25) * t4;
        let t6 = k(6.0) * t5;
        t6
    }
    /// Potential energy U(q) = -sum m g.c, zero at the origin of the base frame, J.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 1 multiplications, 1 additions.
    ///
    /// ```text
    /// U = (-215.82) (0.04045454545454545 - q1)
    /// ```
    /// with si, ci the sine and cosine of qi.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn potential_energy<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> T {
        let q1 = q.data.0[0][0];
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        let t1 = k(0.04045454545454545) - q1;
        let t2 = k(-215.82) * t1;
        t2
    }
}
