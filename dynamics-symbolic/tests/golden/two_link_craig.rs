impl Arm {
    /// Mass matrix M(q), N x N, both triangles, reflected motor inertias included (kg m^2, kg m or kg). Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong).
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 6 multiplications, 4 additions, sine and cosine of one angle.
    ///
    /// ```text
    /// M11 = l1 l1 (m2 + m1) + l1 c2 m2 l2 + l2 m2 l2 + l1 c2 m2 l2
    /// M12 = l2 m2 l2 + l1 c2 m2 l2
    /// M21 = l2 m2 l2 + l1 c2 m2 l2
    /// M22 = l2 m2 l2
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
        let p_m1 = <T as ::robot_dynamics::Scalar>::from_f64(self.m1);
        let p_m2 = <T as ::robot_dynamics::Scalar>::from_f64(self.m2);
        let p_l1 = <T as ::robot_dynamics::Scalar>::from_f64(self.l1);
        let p_l2 = <T as ::robot_dynamics::Scalar>::from_f64(self.l2);
        let t1 = p_m2 + p_m1;
        let t2 = p_l1 * t1;
        let t3 = p_m2 * p_l2;
        let t4 = c2 * t3;
        let t5 = p_l1 * t4;
        let t6 = p_l2 * t3;
        let t7 = t6 + t5;
        let t8 = t5 + t7;
        let t9 = p_l1 * t2 + t8;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t9, t7], [t7, t6]]),
        )
    }
    /// Coriolis and centrifugal vector V(q, qd), N m or N: inverse dynamics without gravity, friction and acceleration.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 7 multiplications, 2 additions, sine and cosine of one angle.
    ///
    /// ```text
    /// V1 = -qd2 (qd2 m2 l2 l1 s2 + qd1 m2 l2 l1 s2 + qd1 m2 l2 l1 s2)
    /// V2 = qd1 qd1 m2 l2 l1 s2
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
        let p_m2 = <T as ::robot_dynamics::Scalar>::from_f64(self.m2);
        let p_l1 = <T as ::robot_dynamics::Scalar>::from_f64(self.l1);
        let p_l2 = <T as ::robot_dynamics::Scalar>::from_f64(self.l2);
        let qd1 = qd.data.0[0][0];
        let qd2 = qd.data.0[0][1];
        let t1 = p_m2 * p_l2;
        let t2 = p_l1 * s2;
        let t3 = t1 * t2;
        let t4 = qd1 * t3;
        let t5 = qd2 * t3 + t4;
        let t6 = t5 + t4;
        let t7 = qd2 * t6;
        let t8 = qd1 * t4;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[-t7, t8]]),
        )
    }
    /// Gravity vector G(q) = dU/dq, N m or N: inverse dynamics at rest.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 8 multiplications, 3 additions, sines and cosines of 2 angles.
    ///
    /// ```text
    /// G1 = g m2 l2 (c1 c2 - s1 s2) + g c1 l1 (m2 + m1)
    /// G2 = g m2 l2 (c1 c2 - s1 s2)
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
        let p_m1 = <T as ::robot_dynamics::Scalar>::from_f64(self.m1);
        let p_m2 = <T as ::robot_dynamics::Scalar>::from_f64(self.m2);
        let p_l1 = <T as ::robot_dynamics::Scalar>::from_f64(self.l1);
        let p_l2 = <T as ::robot_dynamics::Scalar>::from_f64(self.l2);
        let p_g = <T as ::robot_dynamics::Scalar>::from_f64(self.g);
        let t1 = p_m2 * p_l2;
        let t2 = c1 * c2 - s1 * s2;
        let t3 = t1 * t2;
        let t4 = p_g * t3;
        let t5 = p_m2 + p_m1;
        let t6 = p_l1 * t5;
        let t7 = c1 * t6;
        let t8 = t4 + p_g * t7;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t8, t4]]),
        )
    }
    /// Inverse dynamics tau = M(q) qdd + V(q, qd) + G(q) + F(qd), N m or N, as one program.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 18 multiplications, 10 additions, sines and cosines of 2 angles.
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
        let [(s1, c1), (s2, c2)] = ::robot_dynamics::Scalar::sin_cos_array([
            q.data.0[0][0],
            q.data.0[0][1],
        ]);
        let p_m1 = <T as ::robot_dynamics::Scalar>::from_f64(self.m1);
        let p_m2 = <T as ::robot_dynamics::Scalar>::from_f64(self.m2);
        let p_l1 = <T as ::robot_dynamics::Scalar>::from_f64(self.l1);
        let p_l2 = <T as ::robot_dynamics::Scalar>::from_f64(self.l2);
        let p_g = <T as ::robot_dynamics::Scalar>::from_f64(self.g);
        let qd1 = qd.data.0[0][0];
        let qd2 = qd.data.0[0][1];
        let qdd1 = qdd.data.0[0][0];
        let qdd2 = qdd.data.0[0][1];
        let t1 = p_g * c1 + p_l1 * qdd1;
        let t2 = p_m2 + p_m1;
        let t3 = p_l1 * t2;
        let t4 = p_m2 * p_l2;
        let t5 = p_l2 * t4;
        let t6 = qdd1 + qdd2;
        let t7 = c2 * t4;
        let t8 = s2 * t4;
        let t9 = qd1 * qd1;
        let t10 = p_g * s1 - p_l1 * t9;
        let t11 = t8 * t10 - t7 * t1;
        let t12 = t5 * t6 - t11;
        let t13 = qd1 + qd2;
        let t14 = t13 * t13;
        let t15 = t7 * t6 - t8 * t14;
        let t16 = t12 + p_l1 * t15;
        let t17 = t1 * t3 + t16;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t17, t12]]),
        )
    }
    /// Forward dynamics: the accelerations qdd with M(q) qdd + V(q, qd) + G(q) + F(qd) = tau, rad/s^2 or m/s^2.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 23 multiplications, 14 additions, 2 divisions, sines and cosines of 2 angles.
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
        let [(s1, c1), (s2, c2)] = ::robot_dynamics::Scalar::sin_cos_array([
            q.data.0[0][0],
            q.data.0[0][1],
        ]);
        let p_m1 = <T as ::robot_dynamics::Scalar>::from_f64(self.m1);
        let p_m2 = <T as ::robot_dynamics::Scalar>::from_f64(self.m2);
        let p_l1 = <T as ::robot_dynamics::Scalar>::from_f64(self.l1);
        let p_l2 = <T as ::robot_dynamics::Scalar>::from_f64(self.l2);
        let p_g = <T as ::robot_dynamics::Scalar>::from_f64(self.g);
        let qd1 = qd.data.0[0][0];
        let qd2 = qd.data.0[0][1];
        let tau1 = tau.data.0[0][0];
        let tau2 = tau.data.0[0][1];
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        let t1 = p_m2 + p_m1;
        let t2 = p_l1 * t1;
        let t3 = p_g * c1;
        let t4 = p_m2 * p_l2;
        let t5 = c2 * t4;
        let t6 = s2 * t4;
        let t7 = qd1 * qd1;
        let t8 = p_g * s1 - p_l1 * t7;
        let t9 = t5 * t3 - t6 * t8;
        let t10 = qd1 + qd2;
        let t11 = t10 * t10;
        let t12 = t6 * t11;
        let t13 = p_l1 * t12 - t9;
        let t14 = t2 * t3 - t13;
        let t15 = t14 - tau1;
        let t16 = t9 - tau2;
        let t17 = p_l2 * t4;
        let t18 = p_l1 * t5;
        let t19 = t17 + t18;
        let t20 = k(1.0) / t17;
        let t21 = t19 * t20;
        let t22 = t16 * t21 - t15;
        let t23 = t18 + t19;
        let t24 = p_l1 * t2 + t23;
        let t25 = t24 - t19 * t21;
        let t26 = k(1.0) / t25;
        let t27 = t22 * t26;
        let t28 = t16 * t20 + t21 * t27;
        ::robot_dynamics::SingularMassMatrix::test(1, t17, t17)?;
        ::robot_dynamics::SingularMassMatrix::test(0, t25, t24)?;
        ::core::result::Result::Ok(
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[t27, -t28]]),
            ),
        )
    }
    /// Kinetic energy T(q, qd) = 1/2 qd^T M(q) qd, reflected motor inertias included, J.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 11 multiplications, 4 additions, sine and cosine of one angle.
    ///
    /// ```text
    /// T = m2 l2 c2 l1 qd1 (qd1 + qd2) + 0.5 ((m2 + m1) l1 qd1 l1 qd1 + (qd1 + qd2) l2 m2 l2 (qd1 + qd2))
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
        let p_m1 = <T as ::robot_dynamics::Scalar>::from_f64(self.m1);
        let p_m2 = <T as ::robot_dynamics::Scalar>::from_f64(self.m2);
        let p_l1 = <T as ::robot_dynamics::Scalar>::from_f64(self.l1);
        let p_l2 = <T as ::robot_dynamics::Scalar>::from_f64(self.l2);
        let qd1 = qd.data.0[0][0];
        let qd2 = qd.data.0[0][1];
        let k = <T as ::robot_dynamics::Scalar>::from_f64;
        let t1 = p_m2 * p_l2;
        let t2 = p_l1 * qd1;
        let t3 = c2 * t2;
        let t4 = qd1 + qd2;
        let t5 = t3 * t4;
        let t6 = p_m2 + p_m1;
        let t7 = t2 * t2;
        let t8 = p_l2 * t1;
        let t9 = t8 * t4;
        let t10 = t6 * t7 + t4 * t9;
        let t11 = t1 * t5 + k(0.5) * t10;
        t11
    }
    /// Potential energy U(q) = -sum m g.c, zero at the origin of the base frame, J.
    ///
    /// `q` in rad (revolute) or m (prismatic), `qd` and `qdd` per second and second squared.
    ///
    /// Operations: 7 multiplications, 3 additions, sines and cosines of 2 angles.
    ///
    /// ```text
    /// U = g (s1 (l1 (m2 + m1) + c2 m2 l2) + c1 s2 m2 l2)
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
        let p_m1 = <T as ::robot_dynamics::Scalar>::from_f64(self.m1);
        let p_m2 = <T as ::robot_dynamics::Scalar>::from_f64(self.m2);
        let p_l1 = <T as ::robot_dynamics::Scalar>::from_f64(self.l1);
        let p_l2 = <T as ::robot_dynamics::Scalar>::from_f64(self.l2);
        let p_g = <T as ::robot_dynamics::Scalar>::from_f64(self.g);
        let t1 = p_m2 + p_m1;
        let t2 = p_m2 * p_l2;
        let t3 = p_l1 * t1 + c2 * t2;
        let t4 = s2 * t2;
        let t5 = s1 * t3 + c1 * t4;
        let t6 = p_g * t5;
        t6
    }
}
