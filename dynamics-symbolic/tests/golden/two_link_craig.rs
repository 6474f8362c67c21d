impl Arm {
    /// Mass matrix M(q), N x N, both triangles, reflected motor inertias included (kg m^2, kg m or kg). Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong).
    ///
    /// `q`: joint positions, rad.
    ///
    /// Operations: 6 multiplications, 4 additions, sine and cosine of one angle.
    ///
    /// M22 is constant; M11, M12 depend on q2.
    ///
    /// ```text
    /// M11 = l1^2 (m1 + m2) + m2 l2^2 + 2 m2 l1 l2 c2
    /// M12 = m2 l2^2 + m2 l1 l2 c2
    /// M21 = m2 l2^2 + m2 l1 l2 c2
    /// M22 = m2 l2^2
    /// with c2 = cos(q2)
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn mass_matrix<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 2, 2> {
        <Self as ::robot_dynamics::MassMatrix<
            2,
        >>::mass_matrix_at(self, &::robot_dynamics::Evaluated, q)
    }
    /// Coriolis and centrifugal vector V(q, qd), N m or N: inverse dynamics without gravity, springs, friction and acceleration.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s.
    ///
    /// Operations: 7 multiplications, 2 additions, sine and cosine of one angle.
    ///
    /// V2 depends on q2, qd1; V1 depends on q2, qd1, qd2.
    ///
    /// ```text
    /// V1 = -2 m2 l1 l2 s2 qd1 qd2 - m2 l1 l2 s2 qd2^2
    /// V2 = m2 l1 l2 s2 qd1^2
    /// with s2 = sin(q2)
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn coriolis_vector<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        <Self as ::robot_dynamics::CoriolisVector<
            2,
        >>::coriolis_vector_at(self, &::robot_dynamics::Evaluated, q, qd)
    }
    /// Gravity vector G(q), N m or N: the gradient of the potential energy of gravity, inverse dynamics at rest without springs.
    ///
    /// `q`: joint positions, rad.
    ///
    /// Operations: 8 multiplications, 3 additions, sines and cosines of 2 angles.
    ///
    /// G1, G2 depend on q1, q2.
    ///
    /// ```text
    /// G1 = l1 g (m1 + m2) c1 + m2 l2 g c12
    /// G2 = m2 l2 g c12
    /// with c1 = cos(q1), c12 = cos(q1 + q2)
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn gravity_vector<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        <Self as ::robot_dynamics::GravityVector<
            2,
        >>::gravity_vector_at(self, &::robot_dynamics::Evaluated, q)
    }
    /// Inverse dynamics tau = M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd), N m or N, as one program; K is of springs, F of friction.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s; `qdd`: joint accelerations, rad per s^2.
    ///
    /// Operations: 18 multiplications, 10 additions, sines and cosines of 2 angles.
    ///
    /// tau1 depends on q1, q2, qd1, qd2, qdd1, qdd2; tau2 depends on q1, q2, qd1, qdd1, qdd2.
    ///
    /// ```text
    /// tau1 = l1 g (m1 + m2) c1 + m2 l2 g c12 - 2 m2 l1 l2 s2 qd1 qd2 - m2 l1 l2 s2 qd2^2 + (l1^2 (m1 + m2) + m2 l2^2 + 2 m2 l1 l2 c2) qdd1 + (m2 l2^2 + m2 l1 l2 c2) qdd2
    /// tau2 = m2 l2 g c12 + m2 l1 l2 s2 qd1^2 + (m2 l2^2 + m2 l1 l2 c2) qdd1 + m2 l2^2 qdd2
    /// with c1 = cos(q1), c12 = cos(q1 + q2), c2 = cos(q2), s2 = sin(q2)
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn inverse_dynamics<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qdd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        <Self as ::robot_dynamics::InverseDynamics<
            2,
        >>::inverse_dynamics_at(self, &::robot_dynamics::Evaluated, q, qd, qdd)
    }
    /// Forward dynamics: the accelerations qdd with M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau, rad/s^2 or m/s^2; K is of springs, F of friction.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s; `tau`: joint forces and torques, N m.
    ///
    /// Operations: 23 multiplications, 14 additions, 2 divisions, sines and cosines of 2 angles.
    ///
    /** # Errors

 `SingularMassMatrix` where M(q) is not positive definite to working precision, or not finite: it names the joint whose pivot failed.*/
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
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
        <Self as ::robot_dynamics::ForwardDynamics<
            2,
        >>::forward_dynamics_at(self, &::robot_dynamics::Evaluated, q, qd, tau)
    }
    /// Kinetic energy T(q, qd) = 1/2 qd^T M(q) qd, reflected motor inertias included, J.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s.
    ///
    /// Operations: 11 multiplications, 4 additions, sine and cosine of one angle.
    ///
    /// ```text
    /// T = (1/2 l1^2 (m1 + m2) + 1/2 m2 l2^2 + m2 l1 l2 c2) qd1^2 + (m2 l2^2 + m2 l1 l2 c2) qd1 qd2 + 1/2 m2 l2^2 qd2^2
    /// with c2 = cos(q2)
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn kinetic_energy<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> T {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::KineticEnergy,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::KineticEnergy,
            &::robot_dynamics::Evaluated,
            &(*q, *qd),
        );
        all_values
    }
    /// Potential energy U(q) = -sum m g.c, zero at the origin of the base frame, and that of springs, 1/2 stiffness (q - rest)^2, J.
    ///
    /// `q`: joint positions, rad.
    ///
    /// Operations: 7 multiplications, 3 additions, sines and cosines of 2 angles.
    ///
    /// ```text
    /// U = l1 g (m1 + m2) s1 + m2 l2 g s12
    /// with s1 = sin(q1), s12 = sin(q1 + q2)
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn potential_energy<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> T {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::PotentialEnergy,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::PotentialEnergy,
            &::robot_dynamics::Evaluated,
            &(*q,),
        );
        all_values
    }
}
impl ::robot_dynamics::MassMatrix<2> for Arm {
    const WORK: u32 = 50;
    #[inline]
    fn mass_matrix<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 2, 2> {
        Self::mass_matrix(self, q)
    }
    #[inline(always)]
    fn mass_matrix_at<T: ::robot_dynamics::Scalar>(
        &self,
        sines: &impl ::robot_dynamics::Inputs<T>,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 2, 2> {
        let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
        let [(_, c_2)] = ::robot_dynamics::Inputs::sin_cos_parts(
            sines,
            [1],
            [::robot_dynamics::Part::Cosine],
            [q.data.0[0][1]],
        );
        let p_m1 = ::robot_dynamics::Inputs::field(sines, 0, self.m1, q.data.0[0][0]);
        let p_m2 = ::robot_dynamics::Inputs::field(sines, 1, self.m2, q.data.0[0][0]);
        let p_l1 = ::robot_dynamics::Inputs::field(sines, 2, self.l1, q.data.0[0][0]);
        let p_l2 = ::robot_dynamics::Inputs::field(sines, 3, self.l2, q.data.0[0][0]);
        let t_1 = p_m2 * p_l2;
        let t_2 = c_2 * t_1;
        let t_3 = p_l1 * t_2;
        let t_4 = p_m1 + p_m2;
        let t_5 = p_l1 * t_4;
        let t_6 = p_l2 * t_1;
        let t_7 = t_6 + t_3;
        let t_8 = p_l1.mul_add(t_5, t_3);
        let t_9 = t_7 + t_8;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t_9, t_7], [t_7, t_6]]),
        )
    }
}
impl ::robot_dynamics::CoriolisVector<2> for Arm {
    const WORK: u32 = 49;
    #[inline]
    fn coriolis_vector<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        Self::coriolis_vector(self, q, qd)
    }
    #[inline(always)]
    fn coriolis_vector_at<T: ::robot_dynamics::Scalar>(
        &self,
        sines: &impl ::robot_dynamics::Inputs<T>,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
        let [(s_2, _)] = ::robot_dynamics::Inputs::sin_cos_parts(
            sines,
            [1],
            [::robot_dynamics::Part::Sine],
            [q.data.0[0][1]],
        );
        let p_m2 = ::robot_dynamics::Inputs::field(sines, 1, self.m2, q.data.0[0][0]);
        let p_l1 = ::robot_dynamics::Inputs::field(sines, 2, self.l1, q.data.0[0][0]);
        let p_l2 = ::robot_dynamics::Inputs::field(sines, 3, self.l2, q.data.0[0][0]);
        let qd_1 = qd.data.0[0][0];
        let qd_2 = qd.data.0[0][1];
        let t_1 = p_m2 * p_l2;
        let t_2 = p_l1 * s_2;
        let t_3 = t_1 * t_2;
        let t_4 = qd_1 * t_3;
        let t_5 = qd_2.mul_add(t_3, t_4);
        let t_6 = t_4 + t_5;
        let t_7 = qd_2 * t_6;
        let t_8 = qd_1 * t_4;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[-t_7, t_8]]),
        )
    }
}
impl ::robot_dynamics::GravityVector<2> for Arm {
    const WORK: u32 = 91;
    #[inline]
    fn gravity_vector<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        Self::gravity_vector(self, q)
    }
    #[inline(always)]
    fn gravity_vector_at<T: ::robot_dynamics::Scalar>(
        &self,
        sines: &impl ::robot_dynamics::Inputs<T>,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
        let [(s_1, c_1), (s_2, c_2)] = ::robot_dynamics::Inputs::sin_cos(
            sines,
            [0, 1],
            [q.data.0[0][0], q.data.0[0][1]],
        );
        let p_m1 = ::robot_dynamics::Inputs::field(sines, 0, self.m1, q.data.0[0][0]);
        let p_m2 = ::robot_dynamics::Inputs::field(sines, 1, self.m2, q.data.0[0][0]);
        let p_l1 = ::robot_dynamics::Inputs::field(sines, 2, self.l1, q.data.0[0][0]);
        let p_l2 = ::robot_dynamics::Inputs::field(sines, 3, self.l2, q.data.0[0][0]);
        let p_g = ::robot_dynamics::Inputs::field(sines, 4, self.g, q.data.0[0][0]);
        let t_1 = p_m1 + p_m2;
        let t_2 = p_l1 * t_1;
        let t_3 = p_m2 * p_l2;
        let t_4 = (-s_1).mul_add(s_2, c_1 * c_2);
        let t_5 = t_3 * t_4;
        let t_6 = c_1.mul_add(t_2, t_5);
        let t_7 = p_g * t_6;
        let t_8 = p_g * t_5;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t_7, t_8]]),
        )
    }
}
impl ::robot_dynamics::InverseDynamics<2> for Arm {
    const WORK: u32 = 108;
    #[inline]
    fn inverse_dynamics<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qdd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        Self::inverse_dynamics(self, q, qd, qdd)
    }
    #[inline(always)]
    fn inverse_dynamics_at<T: ::robot_dynamics::Scalar>(
        &self,
        sines: &impl ::robot_dynamics::Inputs<T>,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qdd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
        let [(s_1, c_1), (s_2, c_2)] = ::robot_dynamics::Inputs::sin_cos(
            sines,
            [0, 1],
            [q.data.0[0][0], q.data.0[0][1]],
        );
        let p_m1 = ::robot_dynamics::Inputs::field(sines, 0, self.m1, q.data.0[0][0]);
        let p_m2 = ::robot_dynamics::Inputs::field(sines, 1, self.m2, q.data.0[0][0]);
        let p_l1 = ::robot_dynamics::Inputs::field(sines, 2, self.l1, q.data.0[0][0]);
        let p_l2 = ::robot_dynamics::Inputs::field(sines, 3, self.l2, q.data.0[0][0]);
        let p_g = ::robot_dynamics::Inputs::field(sines, 4, self.g, q.data.0[0][0]);
        let qd_1 = qd.data.0[0][0];
        let qd_2 = qd.data.0[0][1];
        let qdd_1 = qdd.data.0[0][0];
        let qdd_2 = qdd.data.0[0][1];
        let t_1 = p_m2 * p_l2;
        let t_2 = c_2 * t_1;
        let t_3 = qdd_1 + qdd_2;
        let t_4 = s_2 * t_1;
        let t_5 = qd_1 + qd_2;
        let t_6 = t_5 * t_5;
        let t_7 = (-t_4).mul_add(t_6, t_2 * t_3);
        let t_8 = p_m1 + p_m2;
        let t_9 = p_l1 * t_8;
        let t_10 = p_g.mul_add(c_1, p_l1 * qdd_1);
        let t_11 = qd_1 * qd_1;
        let t_12 = (-p_l1).mul_add(t_11, p_g * s_1);
        let t_13 = p_l2 * t_1;
        let t_14 = t_2.mul_add(t_10, t_13 * t_3);
        let t_15 = (-t_4).mul_add(t_12, t_14);
        let t_16 = p_l1.mul_add(t_7, t_9 * t_10);
        let t_17 = t_15 + t_16;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t_17, t_15]]),
        )
    }
}
impl ::robot_dynamics::ForwardDynamics<2> for Arm {
    const WORK: u32 = 119;
    #[inline]
    fn forward_dynamics<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
        tau: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::core::result::Result<
        ::robot_dynamics::nalgebra::SVector<T, 2>,
        ::robot_dynamics::SingularMassMatrix,
    > {
        Self::forward_dynamics(self, q, qd, tau)
    }
    #[inline(always)]
    fn forward_dynamics_at<T: ::robot_dynamics::Scalar>(
        &self,
        sines: &impl ::robot_dynamics::Inputs<T>,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
        tau: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::core::result::Result<
        ::robot_dynamics::nalgebra::SVector<T, 2>,
        ::robot_dynamics::SingularMassMatrix,
    > {
        let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
        let [(s_1, c_1), (s_2, c_2)] = ::robot_dynamics::Inputs::sin_cos(
            sines,
            [0, 1],
            [q.data.0[0][0], q.data.0[0][1]],
        );
        let p_m1 = ::robot_dynamics::Inputs::field(sines, 0, self.m1, q.data.0[0][0]);
        let p_m2 = ::robot_dynamics::Inputs::field(sines, 1, self.m2, q.data.0[0][0]);
        let p_l1 = ::robot_dynamics::Inputs::field(sines, 2, self.l1, q.data.0[0][0]);
        let p_l2 = ::robot_dynamics::Inputs::field(sines, 3, self.l2, q.data.0[0][0]);
        let p_g = ::robot_dynamics::Inputs::field(sines, 4, self.g, q.data.0[0][0]);
        let qd_1 = qd.data.0[0][0];
        let qd_2 = qd.data.0[0][1];
        let tau_1 = tau.data.0[0][0];
        let tau_2 = tau.data.0[0][1];
        let t_1 = p_m2 * p_l2;
        let t_2 = s_2 * t_1;
        let t_3 = qd_1 + qd_2;
        let t_4 = t_3 * t_3;
        let t_5 = t_2 * t_4;
        let t_6 = c_2 * t_1;
        let t_7 = p_g * c_1;
        let t_8 = qd_1 * qd_1;
        let t_9 = (-p_l1).mul_add(t_8, p_g * s_1);
        let t_10 = (-t_2).mul_add(t_9, t_6 * t_7);
        let t_11 = p_m1 + p_m2;
        let t_12 = p_l1 * t_11;
        let t_13 = t_10 - tau_2;
        let t_14 = p_l2 * t_1;
        let t_15 = p_l1 * t_6;
        let t_16 = t_14 + t_15;
        let t_17 = real(1.0) / t_14;
        let t_18 = t_16 * t_17;
        let t_19 = (-t_12).mul_add(t_7, tau_1);
        let t_20 = p_l1.mul_add(t_5, t_19);
        let t_21 = t_20 - t_10;
        let t_22 = t_13.mul_add(t_18, t_21);
        let t_23 = p_l1.mul_add(t_12, t_15);
        let t_24 = t_16 + t_23;
        let t_25 = (-t_16).mul_add(t_18, t_24);
        let t_26 = real(1.0) / t_25;
        let t_27 = t_22 * t_26;
        let t_28 = t_18.mul_add(t_27, t_13 * t_17);
        ::robot_dynamics::SingularMassMatrix::test_joint(1, "joint2", t_14, t_14)?;
        ::robot_dynamics::SingularMassMatrix::test_joint(0, "joint1", t_25, t_24)?;
        ::core::result::Result::Ok(
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[t_27, -t_28]]),
            ),
        )
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::KineticEnergy, 2> for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>, ::robot_dynamics::Entries<2, 1>);
    type Values = ::robot_dynamics::Number;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd"];
    const RESULT: &'static str = "kinetic_energy";
    const WORK: u32 = 55;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::KineticEnergy,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (q, qd): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
    ) -> ::core::result::Result<
        <Self::Values as ::robot_dynamics::Arrangement>::Of<T>,
        Self::Error,
    > {
        ::core::result::Result::Ok({
            let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
            let [(_, c_2)] = ::robot_dynamics::Inputs::sin_cos_parts(
                sines,
                [1],
                [::robot_dynamics::Part::Cosine],
                [q.data.0[0][1]],
            );
            let p_m1 = ::robot_dynamics::Inputs::field(
                sines,
                0,
                self.m1,
                q.data.0[0][0],
            );
            let p_m2 = ::robot_dynamics::Inputs::field(
                sines,
                1,
                self.m2,
                q.data.0[0][0],
            );
            let p_l1 = ::robot_dynamics::Inputs::field(
                sines,
                2,
                self.l1,
                q.data.0[0][0],
            );
            let p_l2 = ::robot_dynamics::Inputs::field(
                sines,
                3,
                self.l2,
                q.data.0[0][0],
            );
            let qd_1 = qd.data.0[0][0];
            let qd_2 = qd.data.0[0][1];
            let t_1 = p_m2 * p_l2;
            let t_2 = p_l1 * qd_1;
            let t_3 = c_2 * t_2;
            let t_4 = qd_1 + qd_2;
            let t_5 = t_3 * t_4;
            let t_6 = p_m1 + p_m2;
            let t_7 = t_6 * t_2;
            let t_8 = p_l2 * t_1;
            let t_9 = t_8 * t_4;
            let t_10 = t_4.mul_add(t_9, t_2 * t_7);
            let t_11 = t_1.mul_add(t_5, real(0.5) * t_10);
            t_11
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::PotentialEnergy, 2>
for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>,);
    type Values = ::robot_dynamics::Number;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q"];
    const RESULT: &'static str = "potential_energy";
    const WORK: u32 = 90;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::PotentialEnergy,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (q,): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
    ) -> ::core::result::Result<
        <Self::Values as ::robot_dynamics::Arrangement>::Of<T>,
        Self::Error,
    > {
        ::core::result::Result::Ok({
            let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
            let [(s_1, c_1), (s_2, c_2)] = ::robot_dynamics::Inputs::sin_cos(
                sines,
                [0, 1],
                [q.data.0[0][0], q.data.0[0][1]],
            );
            let p_m1 = ::robot_dynamics::Inputs::field(
                sines,
                0,
                self.m1,
                q.data.0[0][0],
            );
            let p_m2 = ::robot_dynamics::Inputs::field(
                sines,
                1,
                self.m2,
                q.data.0[0][0],
            );
            let p_l1 = ::robot_dynamics::Inputs::field(
                sines,
                2,
                self.l1,
                q.data.0[0][0],
            );
            let p_l2 = ::robot_dynamics::Inputs::field(
                sines,
                3,
                self.l2,
                q.data.0[0][0],
            );
            let p_g = ::robot_dynamics::Inputs::field(sines, 4, self.g, q.data.0[0][0]);
            let t_1 = p_m1 + p_m2;
            let t_2 = p_m2 * p_l2;
            let t_3 = c_2.mul_add(t_2, p_l1 * t_1);
            let t_4 = s_2 * t_2;
            let t_5 = s_1.mul_add(t_3, c_1 * t_4);
            let t_6 = p_g * t_5;
            t_6
        })
    }
}
