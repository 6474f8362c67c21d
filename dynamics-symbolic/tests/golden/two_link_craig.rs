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
        let [(_, c_2_)] = ::robot_dynamics::Inputs::sin_cos_parts(
            sines,
            [1],
            [::robot_dynamics::Part::Cosine],
            [q.data.0[0][1]],
        );
        let p_m1_ = ::robot_dynamics::Inputs::field(sines, 0, self.m1, q.data.0[0][0]);
        let p_m2_ = ::robot_dynamics::Inputs::field(sines, 1, self.m2, q.data.0[0][0]);
        let p_l1_ = ::robot_dynamics::Inputs::field(sines, 2, self.l1, q.data.0[0][0]);
        let p_l2_ = ::robot_dynamics::Inputs::field(sines, 3, self.l2, q.data.0[0][0]);
        let t_1_ = p_m2_ * p_l2_;
        let t_2_ = c_2_ * t_1_;
        let t_3_ = p_l1_ * t_2_;
        let t_4_ = p_m1_ + p_m2_;
        let t_5_ = p_l1_ * t_4_;
        let t_6_ = p_l2_ * t_1_;
        let t_7_ = t_6_ + t_3_;
        let t_8_ = p_l1_.mul_add(t_5_, t_3_);
        let t_9_ = t_7_ + t_8_;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t_9_, t_7_], [t_7_, t_6_]]),
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
        let [(s_2_, _)] = ::robot_dynamics::Inputs::sin_cos_parts(
            sines,
            [1],
            [::robot_dynamics::Part::Sine],
            [q.data.0[0][1]],
        );
        let p_m2_ = ::robot_dynamics::Inputs::field(sines, 1, self.m2, q.data.0[0][0]);
        let p_l1_ = ::robot_dynamics::Inputs::field(sines, 2, self.l1, q.data.0[0][0]);
        let p_l2_ = ::robot_dynamics::Inputs::field(sines, 3, self.l2, q.data.0[0][0]);
        let qd_1_ = qd.data.0[0][0];
        let qd_2_ = qd.data.0[0][1];
        let t_1_ = p_m2_ * p_l2_;
        let t_2_ = p_l1_ * s_2_;
        let t_3_ = t_1_ * t_2_;
        let t_4_ = qd_1_ * t_3_;
        let t_5_ = qd_2_.mul_add(t_3_, t_4_);
        let t_6_ = t_4_ + t_5_;
        let t_7_ = qd_2_ * t_6_;
        let t_8_ = qd_1_ * t_4_;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[-t_7_, t_8_]]),
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
        let [(s_1_, c_1_), (s_2_, c_2_)] = ::robot_dynamics::Inputs::sin_cos(
            sines,
            [0, 1],
            [q.data.0[0][0], q.data.0[0][1]],
        );
        let p_m1_ = ::robot_dynamics::Inputs::field(sines, 0, self.m1, q.data.0[0][0]);
        let p_m2_ = ::robot_dynamics::Inputs::field(sines, 1, self.m2, q.data.0[0][0]);
        let p_l1_ = ::robot_dynamics::Inputs::field(sines, 2, self.l1, q.data.0[0][0]);
        let p_l2_ = ::robot_dynamics::Inputs::field(sines, 3, self.l2, q.data.0[0][0]);
        let p_g_ = ::robot_dynamics::Inputs::field(sines, 4, self.g, q.data.0[0][0]);
        let t_1_ = p_m1_ + p_m2_;
        let t_2_ = p_l1_ * t_1_;
        let t_3_ = p_m2_ * p_l2_;
        let t_4_ = (-s_1_).mul_add(s_2_, c_1_ * c_2_);
        let t_5_ = t_3_ * t_4_;
        let t_6_ = c_1_.mul_add(t_2_, t_5_);
        let t_7_ = p_g_ * t_6_;
        let t_8_ = p_g_ * t_5_;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t_7_, t_8_]]),
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
        let [(s_1_, c_1_), (s_2_, c_2_)] = ::robot_dynamics::Inputs::sin_cos(
            sines,
            [0, 1],
            [q.data.0[0][0], q.data.0[0][1]],
        );
        let p_m1_ = ::robot_dynamics::Inputs::field(sines, 0, self.m1, q.data.0[0][0]);
        let p_m2_ = ::robot_dynamics::Inputs::field(sines, 1, self.m2, q.data.0[0][0]);
        let p_l1_ = ::robot_dynamics::Inputs::field(sines, 2, self.l1, q.data.0[0][0]);
        let p_l2_ = ::robot_dynamics::Inputs::field(sines, 3, self.l2, q.data.0[0][0]);
        let p_g_ = ::robot_dynamics::Inputs::field(sines, 4, self.g, q.data.0[0][0]);
        let qd_1_ = qd.data.0[0][0];
        let qd_2_ = qd.data.0[0][1];
        let qdd_1_ = qdd.data.0[0][0];
        let qdd_2_ = qdd.data.0[0][1];
        let t_1_ = p_m2_ * p_l2_;
        let t_2_ = c_2_ * t_1_;
        let t_3_ = qdd_1_ + qdd_2_;
        let t_4_ = s_2_ * t_1_;
        let t_5_ = qd_1_ + qd_2_;
        let t_6_ = t_5_ * t_5_;
        let t_7_ = (-t_4_).mul_add(t_6_, t_2_ * t_3_);
        let t_8_ = p_m1_ + p_m2_;
        let t_9_ = p_l1_ * t_8_;
        let t_10_ = p_g_.mul_add(c_1_, p_l1_ * qdd_1_);
        let t_11_ = qd_1_ * qd_1_;
        let t_12_ = (-p_l1_).mul_add(t_11_, p_g_ * s_1_);
        let t_13_ = p_l2_ * t_1_;
        let t_14_ = t_2_.mul_add(t_10_, t_13_ * t_3_);
        let t_15_ = (-t_4_).mul_add(t_12_, t_14_);
        let t_16_ = p_l1_.mul_add(t_7_, t_9_ * t_10_);
        let t_17_ = t_15_ + t_16_;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t_17_, t_15_]]),
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
        let [(s_1_, c_1_), (s_2_, c_2_)] = ::robot_dynamics::Inputs::sin_cos(
            sines,
            [0, 1],
            [q.data.0[0][0], q.data.0[0][1]],
        );
        let p_m1_ = ::robot_dynamics::Inputs::field(sines, 0, self.m1, q.data.0[0][0]);
        let p_m2_ = ::robot_dynamics::Inputs::field(sines, 1, self.m2, q.data.0[0][0]);
        let p_l1_ = ::robot_dynamics::Inputs::field(sines, 2, self.l1, q.data.0[0][0]);
        let p_l2_ = ::robot_dynamics::Inputs::field(sines, 3, self.l2, q.data.0[0][0]);
        let p_g_ = ::robot_dynamics::Inputs::field(sines, 4, self.g, q.data.0[0][0]);
        let qd_1_ = qd.data.0[0][0];
        let qd_2_ = qd.data.0[0][1];
        let tau_1_ = tau.data.0[0][0];
        let tau_2_ = tau.data.0[0][1];
        let t_1_ = p_m2_ * p_l2_;
        let t_2_ = s_2_ * t_1_;
        let t_3_ = qd_1_ + qd_2_;
        let t_4_ = t_3_ * t_3_;
        let t_5_ = t_2_ * t_4_;
        let t_6_ = c_2_ * t_1_;
        let t_7_ = p_g_ * c_1_;
        let t_8_ = qd_1_ * qd_1_;
        let t_9_ = (-p_l1_).mul_add(t_8_, p_g_ * s_1_);
        let t_10_ = (-t_2_).mul_add(t_9_, t_6_ * t_7_);
        let t_11_ = p_m1_ + p_m2_;
        let t_12_ = p_l1_ * t_11_;
        let t_13_ = t_10_ - tau_2_;
        let t_14_ = p_l2_ * t_1_;
        let t_15_ = p_l1_ * t_6_;
        let t_16_ = t_14_ + t_15_;
        let t_17_ = real(1.0) / t_14_;
        let t_18_ = t_16_ * t_17_;
        let t_19_ = (-t_12_).mul_add(t_7_, tau_1_);
        let t_20_ = p_l1_.mul_add(t_5_, t_19_);
        let t_21_ = t_20_ - t_10_;
        let t_22_ = t_13_.mul_add(t_18_, t_21_);
        let t_23_ = p_l1_.mul_add(t_12_, t_15_);
        let t_24_ = t_16_ + t_23_;
        let t_25_ = (-t_16_).mul_add(t_18_, t_24_);
        let t_26_ = real(1.0) / t_25_;
        let t_27_ = t_22_ * t_26_;
        let t_28_ = t_18_.mul_add(t_27_, t_13_ * t_17_);
        ::robot_dynamics::SingularMassMatrix::test_joint(1, "joint2", t_14_, t_14_)?;
        ::robot_dynamics::SingularMassMatrix::test_joint(0, "joint1", t_25_, t_24_)?;
        ::core::result::Result::Ok(
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[t_27_, -t_28_]]),
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
            let [(_, c_2_)] = ::robot_dynamics::Inputs::sin_cos_parts(
                sines,
                [1],
                [::robot_dynamics::Part::Cosine],
                [q.data.0[0][1]],
            );
            let p_m1_ = ::robot_dynamics::Inputs::field(
                sines,
                0,
                self.m1,
                q.data.0[0][0],
            );
            let p_m2_ = ::robot_dynamics::Inputs::field(
                sines,
                1,
                self.m2,
                q.data.0[0][0],
            );
            let p_l1_ = ::robot_dynamics::Inputs::field(
                sines,
                2,
                self.l1,
                q.data.0[0][0],
            );
            let p_l2_ = ::robot_dynamics::Inputs::field(
                sines,
                3,
                self.l2,
                q.data.0[0][0],
            );
            let qd_1_ = qd.data.0[0][0];
            let qd_2_ = qd.data.0[0][1];
            let t_1_ = p_m2_ * p_l2_;
            let t_2_ = p_l1_ * qd_1_;
            let t_3_ = c_2_ * t_2_;
            let t_4_ = qd_1_ + qd_2_;
            let t_5_ = t_3_ * t_4_;
            let t_6_ = p_m1_ + p_m2_;
            let t_7_ = t_6_ * t_2_;
            let t_8_ = p_l2_ * t_1_;
            let t_9_ = t_8_ * t_4_;
            let t_10_ = t_4_.mul_add(t_9_, t_2_ * t_7_);
            let t_11_ = t_1_.mul_add(t_5_, real(0.5) * t_10_);
            t_11_
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
            let [(s_1_, c_1_), (s_2_, c_2_)] = ::robot_dynamics::Inputs::sin_cos(
                sines,
                [0, 1],
                [q.data.0[0][0], q.data.0[0][1]],
            );
            let p_m1_ = ::robot_dynamics::Inputs::field(
                sines,
                0,
                self.m1,
                q.data.0[0][0],
            );
            let p_m2_ = ::robot_dynamics::Inputs::field(
                sines,
                1,
                self.m2,
                q.data.0[0][0],
            );
            let p_l1_ = ::robot_dynamics::Inputs::field(
                sines,
                2,
                self.l1,
                q.data.0[0][0],
            );
            let p_l2_ = ::robot_dynamics::Inputs::field(
                sines,
                3,
                self.l2,
                q.data.0[0][0],
            );
            let p_g_ = ::robot_dynamics::Inputs::field(sines, 4, self.g, q.data.0[0][0]);
            let t_1_ = p_m1_ + p_m2_;
            let t_2_ = p_m2_ * p_l2_;
            let t_3_ = c_2_.mul_add(t_2_, p_l1_ * t_1_);
            let t_4_ = s_2_ * t_2_;
            let t_5_ = s_1_.mul_add(t_3_, c_1_ * t_4_);
            let t_6_ = p_g_ * t_5_;
            t_6_
        })
    }
}
