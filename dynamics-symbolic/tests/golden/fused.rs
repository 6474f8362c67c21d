impl Arm {
    /// (`mass_matrix`, `coriolis_vector`, `gravity_vector`) at one state, as one program.
    ///
    /// - `0`: Mass matrix M(q), N x N, both triangles, reflected motor inertias included (kg m^2, kg m or kg). Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong).
    /// - `1`: Coriolis and centrifugal vector V(q, qd), N m or N: inverse dynamics without gravity, springs, friction and acceleration.
    /// - `2`: Gravity vector G(q), N m or N: the gradient of the potential energy of gravity, inverse dynamics at rest without springs.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s.
    ///
    /// A call of each function takes 15 multiplications, additions and divisions in all, and sines and cosines 4 times: nothing but sines and cosines is saved here.
    ///
    /// Operations: 9 multiplications, 6 additions, sines and cosines of 2 angles.
    ///
    /// M22 is constant; M11, M12 depend on q2.
    ///
    /// V2 depends on q2, qd1; V1 depends on q2, qd1, qd2.
    ///
    /// G1, G2 depend on q1, q2.
    ///
    /// ```text
    /// M11 = 8.333333333333334 + 2 c2
    /// M12 = 0.33333333333333333 + c2
    /// M21 = 0.33333333333333333 + c2
    /// M22 = 0.33333333333333333
    /// V1 = -2 s2 qd1 qd2 - s2 qd2^2
    /// V2 = s2 qd1^2
    /// G1 = 49.05 c1 + 4.905 c12
    /// G2 = 4.905 c12
    /// with c1 = cos(q1), c12 = cos(q1 + q2), c2 = cos(q2), s2 = sin(q2)
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn control_terms<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> (
        ::robot_dynamics::nalgebra::SMatrix<T, 2, 2>,
        ::robot_dynamics::nalgebra::SVector<T, 2>,
        ::robot_dynamics::nalgebra::SVector<T, 2>,
    ) {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::Fused<0>,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::Fused::<0>,
            &::robot_dynamics::Evaluated,
            &(*q, *qd),
        );
        all_values
    }
    /// (`forward_dynamics`, `kinetic_energy`) at one state, as one program.
    ///
    /// - `0`: Forward dynamics: the accelerations qdd with M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau, rad/s^2 or m/s^2; K is of springs, F of friction.
    /// - `1`: Kinetic energy T(q, qd) = 1/2 qd^T M(q) qd, reflected motor inertias included, J.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s; `tau`: joint forces and torques, N m.
    ///
    /// A call of each function takes 37 multiplications, additions and divisions in all, and sines and cosines 3 times; 3 operations are saved here.
    ///
    /// Operations: 19 multiplications, 14 additions, 1 division, sines and cosines of 2 angles.
    ///
    /// ```text
    /// T = (4.166666666666667 + c2) qd1^2 + (0.33333333333333333 + c2) qd1 qd2 + 0.16666666666666666 qd2^2
    /// with c2 = cos(q2)
    /// ```
    ///
    /** # Errors

 `SingularMassMatrix` where M(q) is not positive definite to working precision, or not finite: it names the joint whose pivot failed.*/
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn motion<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
        tau: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::core::result::Result<
        (::robot_dynamics::nalgebra::SVector<T, 2>, T),
        ::robot_dynamics::SingularMassMatrix,
    > {
        <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::Fused<1>,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::Fused::<1>,
            &::robot_dynamics::Evaluated,
            &(*q, *qd, *tau),
        )
    }
    /// (`friction_vector`, `potential_energy`) at one state, as one program.
    ///
    /// - `0`: Friction vector F(qd) = viscous qd + sign(qd) (C + (S - C) exp(-(qd/v)^2)), N m or N, with sign(0) = 0: C is the Coulomb friction of the direction, S static friction that falls to it over the velocity v, where the table has one, else C.
    /// - `1`: Potential energy U(q) = -sum m g.c, zero at the origin of the base frame, and that of springs, 1/2 stiffness (q - rest)^2, J.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s.
    ///
    /// A call of each function takes 5 multiplications, additions and divisions in all, and sines and cosines 2 times: nothing is saved here.
    ///
    /// Operations: 3 multiplications, 2 additions, sines and cosines of 2 angles.
    ///
    /// F1, F2 are zero.
    ///
    /// ```text
    /// F1 = 0
    /// F2 = 0
    /// U = 49.05 s1 + 4.905 s12
    /// with s1 = sin(q1), s12 = sin(q1 + q2)
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn apart<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> (::robot_dynamics::nalgebra::SVector<T, 2>, T) {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::Fused<2>,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::Fused::<2>,
            &::robot_dynamics::Evaluated,
            &(*q, *qd),
        );
        all_values
    }
}
impl Function for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>, ::robot_dynamics::Entries<2, 1>);
    type Values = (
        ::robot_dynamics::Entries<2, 2>,
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
    );
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd"];
    const RESULT: &'static str = "control_terms";
    const WORK: u32 = 95;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::Fused<0>,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (q, qd): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
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
            let qd_1_ = qd.data.0[0][0];
            let qd_2_ = qd.data.0[0][1];
            let t_1_ = real(4.166666666666667) + c_2_;
            let t_2_ = real(2.0) * t_1_;
            let t_3_ = real(0.3333333333333333) + c_2_;
            let t_4_ = qd_1_ * s_2_;
            let t_5_ = s_2_.mul_add(qd_2_, t_4_);
            let t_6_ = t_4_ + t_5_;
            let t_7_ = qd_2_ * t_6_;
            let t_8_ = qd_1_ * t_4_;
            let t_9_ = (-s_1_).mul_add(s_2_, c_1_ * c_2_);
            let t_10_ = real(4.905) * t_9_;
            let t_11_ = real(49.05).mul_add(c_1_, t_10_);
            (
                ::robot_dynamics::nalgebra::SMatrix::from_data(
                    ::robot_dynamics::nalgebra::ArrayStorage([
                        [t_2_, t_3_],
                        [t_3_, real(0.3333333333333333)],
                    ]),
                ),
                ::robot_dynamics::nalgebra::SMatrix::from_data(
                    ::robot_dynamics::nalgebra::ArrayStorage([[-t_7_, t_8_]]),
                ),
                ::robot_dynamics::nalgebra::SMatrix::from_data(
                    ::robot_dynamics::nalgebra::ArrayStorage([[t_11_, t_10_]]),
                ),
            )
        })
    }
}
impl Function for Arm {
    type Arguments = (
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
    );
    type Values = (::robot_dynamics::Entries<2, 1>, ::robot_dynamics::Number);
    type Error = ::robot_dynamics::SingularMassMatrix;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd", "tau"];
    const RESULT: &'static str = "motion";
    const WORK: u32 = 114;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::Fused<1>,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (q, qd, tau): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
    ) -> ::core::result::Result<
        <Self::Values as ::robot_dynamics::Arrangement>::Of<T>,
        Self::Error,
    > {
        let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
        let [(s_1_, c_1_), (s_2_, c_2_)] = ::robot_dynamics::Inputs::sin_cos(
            sines,
            [0, 1],
            [q.data.0[0][0], q.data.0[0][1]],
        );
        let qd_1_ = qd.data.0[0][0];
        let qd_2_ = qd.data.0[0][1];
        let tau_1_ = tau.data.0[0][0];
        let tau_2_ = tau.data.0[0][1];
        let t_1_ = qd_1_ + qd_2_;
        let t_2_ = t_1_ * t_1_;
        let t_3_ = c_1_ * c_2_;
        let t_4_ = qd_1_ * qd_1_;
        let t_5_ = real(-4.905).mul_add(s_1_, t_4_);
        let t_6_ = s_2_.mul_add(t_5_, real(4.905) * t_3_);
        let t_7_ = t_6_ - tau_2_;
        let t_8_ = real(0.3333333333333333) + c_2_;
        let t_9_ = real(3.0) * t_8_;
        let t_10_ = real(49.05).mul_add(c_1_, -tau_1_);
        let t_11_ = (-s_2_).mul_add(t_2_, t_10_);
        let t_12_ = t_11_ + t_6_;
        let t_13_ = (-t_7_).mul_add(t_9_, t_12_);
        let t_14_ = real(2.0).mul_add(c_2_, real(8.333333333333334));
        let t_15_ = (-t_8_).mul_add(t_9_, t_14_);
        let t_16_ = real(1.0) / t_15_;
        let t_17_ = t_13_ * t_16_;
        let t_18_ = real(-3.0).mul_add(t_7_, t_9_ * t_17_);
        let t_19_ = qd_1_ * t_1_;
        let t_20_ = real(0.041666666666666664).mul_add(t_2_, t_4_);
        let t_21_ = c_2_.mul_add(t_19_, real(4.0) * t_20_);
        ::robot_dynamics::SingularMassMatrix::test_joint(
            1,
            "joint2",
            real(0.3333333333333333),
            real(0.3333333333333333),
        )?;
        ::robot_dynamics::SingularMassMatrix::test_joint(0, "joint1", t_15_, t_14_)?;
        ::core::result::Result::Ok((
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[-t_17_, t_18_]]),
            ),
            t_21_,
        ))
    }
}
impl Function for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>, ::robot_dynamics::Entries<2, 1>);
    type Values = (::robot_dynamics::Entries<2, 1>, ::robot_dynamics::Number);
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd"];
    const RESULT: &'static str = "apart";
    const WORK: u32 = 85;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::Fused<2>,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (q, qd): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
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
            let t_1_ = real(10.0) + c_2_;
            let t_2_ = s_1_.mul_add(t_1_, c_1_ * s_2_);
            let t_3_ = real(4.905) * t_2_;
            (
                ::robot_dynamics::nalgebra::SMatrix::from_data(
                    ::robot_dynamics::nalgebra::ArrayStorage([[real(0.0), real(0.0)]]),
                ),
                t_3_,
            )
        })
    }
}
