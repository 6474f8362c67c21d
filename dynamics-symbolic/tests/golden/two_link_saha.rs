impl Arm {
    /// Mass matrix M(q), N x N, both triangles, reflected motor inertias included (kg m^2, kg m or kg). Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong).
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 0 multiplications, 3 additions, sine and cosine of one angle.
    ///
    /// ```text
    /// M11 = 8.333333333333334 + c2 + c2
    /// M12 = c2 + 0.3333333333333333
    /// M21 = c2 + 0.3333333333333333
    /// M22 = 0.3333333333333333
    /// ```
    /// with si, ci the sine and cosine of qi.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn mass_matrix<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 2, 2> {
        let (s2, c2) = ::robot_dynamics::Scalar::sin_cos(q.data.0[0][1]);
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        let t1 = c2 + c2;
        let t2 = k(8.333333333333334) + t1;
        let t3 = c2 + k(0.3333333333333333);
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([
                [t2, t3],
                [t3, k(0.3333333333333333)],
            ]),
        )
    }
    /// Coriolis and centrifugal vector V(q, qd), N m or N: inverse dynamics without gravity, friction and acceleration.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 4 multiplications, 2 additions, sine and cosine of one angle.
    ///
    /// ```text
    /// V1 = s2 qd1 qd1 - s2 (qd1 + qd2) (qd1 + qd2)
    /// V2 = s2 qd1 qd1
    /// ```
    /// with si, ci the sine and cosine of qi.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn coriolis_vector<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        let (s2, c2) = ::robot_dynamics::Scalar::sin_cos(q.data.0[0][1]);
        let qd1 = qd.data.0[0][0];
        let qd2 = qd.data.0[0][1];
        let t1 = qd1 * qd1;
        let t2 = s2 * t1;
        let t3 = qd1 + qd2;
        let t4 = t3 * t3;
        let t5 = t2 - s2 * t4;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t5, t2]]),
        )
    }
    /// Gravity vector G(q) = dU/dq, N m or N: inverse dynamics at rest.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 4 multiplications, 2 additions, sines and cosines of 2 angles.
    ///
    /// ```text
    /// G1 = 4.905 (c1 c2 - s1 s2) + 49.05 c1
    /// G2 = 4.905 (c1 c2 - s1 s2)
    /// ```
    /// with si, ci the sine and cosine of qi.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn gravity_vector<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        let [(s1, c1), (s2, c2)] = ::robot_dynamics::Scalar::sin_cos_array([
            q.data.0[0][0],
            q.data.0[0][1],
        ]);
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        let t1 = c1 * c2 - s1 * s2;
        let t2 = k(4.905) * t1;
        let t3 = t2 + k(49.05) * c1;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t3, t2]]),
        )
    }
    /// Friction vector F(qd) = viscous qd + coulomb sign(qd), N m or N, with sign(0) = 0.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 0 multiplications, 0 additions.
    ///
    /// ```text
    /// F1 = 0
    /// F2 = 0
    /// ```
    /// with si, ci the sine and cosine of qi.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn friction_vector<T: ::robot_dynamics::Scalar>(
        &self,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[k(0.0), k(0.0)]]),
        )
    }
    /// Inverse dynamics tau = M(q) qdd + V(q, qd) + G(q) + F(qd), N m or N, as one program.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 11 multiplications, 10 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn inverse_dynamics<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qdd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        let [(s2, c2), (s1, c1)] = ::robot_dynamics::Scalar::sin_cos_array([
            q.data.0[0][1],
            q.data.0[0][0],
        ]);
        let qd1 = qd.data.0[0][0];
        let qd2 = qd.data.0[0][1];
        let qdd1 = qdd.data.0[0][0];
        let qdd2 = qdd.data.0[0][1];
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        let t1 = qd1 + qd2;
        let t2 = t1 * t1;
        let t3 = qdd1 + qdd2;
        let t4 = s2 * t2 - c2 * t3;
        let t5 = k(8.0) * qdd1 + k(49.05) * c1;
        let t6 = qd1 * qd1 - k(4.905) * s1;
        let t7 = qdd1 + k(4.905) * c1;
        let t8 = k(0.3333333333333333) * t3 + c2 * t7;
        let t9 = s2 * t6 + t8;
        let t10 = t5 + t9;
        let t11 = t10 - t4;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t11, t9]]),
        )
    }
    /// Forward dynamics: the accelerations qdd with M(q) qdd + V(q, qd) + G(q) + F(qd) = tau, rad/s^2 or m/s^2.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 15 multiplications, 12 additions, 1 divisions, sines and cosines of 2 angles.
    ///
    /** # Errors

 `SingularMassMatrix` where M(q) is not positive definite, or an input is not finite: it names the joint whose pivot failed.*/
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn forward_dynamics<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
        tau: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::core::result::Result<
        ::robot_dynamics::nalgebra::SVector<T, 2>,
        ::robot_dynamics::SingularMassMatrix,
    > {
        let [(s2, c2), (s1, c1)] = ::robot_dynamics::Scalar::sin_cos_array([
            q.data.0[0][1],
            q.data.0[0][0],
        ]);
        let qd1 = qd.data.0[0][0];
        let qd2 = qd.data.0[0][1];
        let tau1 = tau.data.0[0][0];
        let tau2 = tau.data.0[0][1];
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        let t1 = qd1 + qd2;
        let t2 = t1 * t1;
        let t3 = qd1 * qd1;
        let t4 = k(0.2038735983690112) * t3 - s1;
        let t5 = s2 * t4 + c1 * c2;
        let t6 = k(4.905) * t5;
        let t7 = tau1 - k(49.05) * c1;
        let t8 = t6 - t7;
        let t9 = t8 - s2 * t2;
        let t10 = t6 - tau2;
        let t11 = c2 + k(0.3333333333333333);
        let t12 = k(3.0) * t11;
        let t13 = t9 - t10 * t12;
        let t14 = k(8.333333333333334) + k(2.0) * c2;
        let t15 = t14 - t11 * t12;
        let t16 = k(1.0) / t15;
        let t17 = t13 * t16;
        let t18 = t12 * t17 - k(3.0) * t10;
        ::robot_dynamics::SingularMassMatrix::test(
            1,
            k(0.3333333333333333),
            k(0.3333333333333333),
        )?;
        ::robot_dynamics::SingularMassMatrix::test(0, t15, t14)?;
        ::core::result::Result::Ok(
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[-t17, t18]]),
            ),
        )
    }
    /// Kinetic energy T(q, qd) = 1/2 qd^T M(q) qd, reflected motor inertias included, J.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 6 multiplications, 3 additions, sine and cosine of one angle.
    ///
    /// ```text
    /// T = (qd1 + qd2) qd1 c2 + 4 (qd1 qd1 + 0.041666666666666664 (qd1 + qd2) (qd1 + qd2))
    /// ```
    /// with si, ci the sine and cosine of qi.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn kinetic_energy<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> T {
        let (s2, c2) = ::robot_dynamics::Scalar::sin_cos(q.data.0[0][1]);
        let qd1 = qd.data.0[0][0];
        let qd2 = qd.data.0[0][1];
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        let t1 = qd1 + qd2;
        let t2 = qd1 * c2;
        let t3 = t1 * t1;
        let t4 = qd1 * qd1 + k(0.041666666666666664) * t3;
        let t5 = t1 * t2 + k(4.0) * t4;
        t5
    }
    /// Potential energy U(q) = -sum m g.c, zero at the origin of the base frame, J.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 3 multiplications, 2 additions, sines and cosines of 2 angles.
    ///
    /// ```text
    /// U = 4.905 (c1 s2 + s1 (c2 + 10))
    /// ```
    /// with si, ci the sine and cosine of qi.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn potential_energy<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> T {
        let [(s1, c1), (s2, c2)] = ::robot_dynamics::Scalar::sin_cos_array([
            q.data.0[0][0],
            q.data.0[0][1],
        ]);
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        let t1 = c2 + k(10.0);
        let t2 = c1 * s2 + s1 * t1;
        let t3 = k(4.905) * t2;
        t3
    }
    /// Bias force V(q, qd) + G(q) + F(qd), N m or N: inverse dynamics without acceleration.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 8 multiplications, 5 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn bias_force<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        let [(s2, c2), (s1, c1)] = ::robot_dynamics::Scalar::sin_cos_array([
            q.data.0[0][1],
            q.data.0[0][0],
        ]);
        let qd1 = qd.data.0[0][0];
        let qd2 = qd.data.0[0][1];
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        let t1 = qd1 + qd2;
        let t2 = t1 * t1;
        let t3 = qd1 * qd1;
        let t4 = k(0.2038735983690112) * t3 - s1;
        let t5 = s2 * t4 + c1 * c2;
        let t6 = k(4.905) * t5;
        let t7 = k(49.05) * c1 + t6;
        let t8 = t7 - s2 * t2;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t8, t6]]),
        )
    }
    /// Coriolis matrix C(q, qd), N x N, from the Christoffel symbols of the first kind: C qd = V, and dM/dt - 2 C is skew-symmetric.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 2 multiplications, 1 additions, sine and cosine of one angle.
    ///
    /// ```text
    /// C11 = -s2 qd2
    /// C12 = -(s2 qd2 + qd1 s2)
    /// C21 = qd1 s2
    /// C22 = 0
    /// ```
    /// with si, ci the sine and cosine of qi.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn coriolis_matrix<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 2, 2> {
        let (s2, c2) = ::robot_dynamics::Scalar::sin_cos(q.data.0[0][1]);
        let qd1 = qd.data.0[0][0];
        let qd2 = qd.data.0[0][1];
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        let t1 = s2 * qd2;
        let t2 = qd1 * s2;
        let t3 = t1 + t2;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[-t1, t2], [-t3, k(0.0)]]),
        )
    }
    /// Coriolis coefficients B(q), N x N(N-1)/2, columns in the order (1,2), (1,3), ..., (N-1,N), of the configuration-space form tau = M qdd + B [qd qd] + C [qd^2] + G.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 1 multiplications, 0 additions, sine and cosine of one angle.
    ///
    /// ```text
    /// B11 = -2 s2
    /// B21 = 0
    /// ```
    /// with si, ci the sine and cosine of qi.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn coriolis_coefficients<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 2, 1> {
        let (s2, c2) = ::robot_dynamics::Scalar::sin_cos(q.data.0[0][1]);
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        let t1 = k(2.0) * s2;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[-t1, k(0.0)]]),
        )
    }
    /// Centrifugal coefficients C(q), N x N, of the configuration-space form tau = M qdd + B [qd qd] + C [qd^2] + G.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 0 multiplications, 0 additions, sine and cosine of one angle.
    ///
    /// ```text
    /// C11 = 0
    /// C12 = -s2
    /// C21 = s2
    /// C22 = 0
    /// ```
    /// with si, ci the sine and cosine of qi.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn centrifugal_coefficients<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 2, 2> {
        let (s2, c2) = ::robot_dynamics::Scalar::sin_cos(q.data.0[0][1]);
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[k(0.0), s2], [-s2, k(0.0)]]),
        )
    }
    /// Forward kinematics: the homogeneous transform of the last link frame in the base frame, m.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 6 multiplications, 4 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn forward_kinematics<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::Matrix4<T> {
        let [(s1, c1), (s2, c2)] = ::robot_dynamics::Scalar::sin_cos_array([
            q.data.0[0][0],
            q.data.0[0][1],
        ]);
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        let t1 = c1 * c2 - s1 * s2;
        let t2 = s1 * c2 + c1 * s2;
        let t3 = k(2.0) * c1 + t1;
        let t4 = k(2.0) * s1 + t2;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([
                [t1, t2, k(0.0), k(0.0)],
                [-t2, t1, k(0.0), k(0.0)],
                [k(0.0), k(0.0), k(1.0), k(0.0)],
                [t3, t4, k(0.0), k(1.0)],
            ]),
        )
    }
    /// Homogeneous transforms of every link frame in the base frame, from the base outwards, m.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 6 multiplications, 4 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn link_poses<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> [::robot_dynamics::nalgebra::Matrix4<T>; 2] {
        let [(s1, c1), (s2, c2)] = ::robot_dynamics::Scalar::sin_cos_array([
            q.data.0[0][0],
            q.data.0[0][1],
        ]);
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        let t1 = k(2.0) * c1;
        let t2 = k(2.0) * s1;
        let t3 = c1 * c2 - s1 * s2;
        let t4 = s1 * c2 + c1 * s2;
        let t5 = t1 + t3;
        let t6 = t2 + t4;
        [
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [c1, s1, k(0.0), k(0.0)],
                    [-s1, c1, k(0.0), k(0.0)],
                    [k(0.0), k(0.0), k(1.0), k(0.0)],
                    [t1, t2, k(0.0), k(1.0)],
                ]),
            ),
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [t3, t4, k(0.0), k(0.0)],
                    [-t4, t3, k(0.0), k(0.0)],
                    [k(0.0), k(0.0), k(1.0), k(0.0)],
                    [t5, t6, k(0.0), k(1.0)],
                ]),
            ),
        ]
    }
    /// Geometric Jacobian of the last link frame's origin, 6 x N, rows vx vy vz wx wy wz, in the base frame.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 6 multiplications, 4 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn jacobian<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 6, 2> {
        let [(s1, c1), (s2, c2)] = ::robot_dynamics::Scalar::sin_cos_array([
            q.data.0[0][0],
            q.data.0[0][1],
        ]);
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        let t1 = s1 * c2 + c1 * s2;
        let t2 = k(2.0) * s1 + t1;
        let t3 = c1 * c2 - s1 * s2;
        let t4 = k(2.0) * c1 + t3;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([
                [-t2, t4, k(0.0), k(0.0), k(0.0), k(1.0)],
                [-t1, t3, k(0.0), k(0.0), k(0.0), k(1.0)],
            ]),
        )
    }
}
