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
            let [(s_1, c_1), (s_2, c_2)] = ::robot_dynamics::Inputs::sin_cos(
                sines,
                [0, 1],
                [q.data.0[0][0], q.data.0[0][1]],
            );
            let qd_1 = qd.data.0[0][0];
            let qd_2 = qd.data.0[0][1];
            let t_1 = real(4.166666666666667) + c_2;
            let t_2 = real(2.0) * t_1;
            let t_3 = real(0.3333333333333333) + c_2;
            let t_4 = qd_1 * s_2;
            let t_5 = s_2.mul_add(qd_2, t_4);
            let t_6 = t_4 + t_5;
            let t_7 = qd_2 * t_6;
            let t_8 = qd_1 * t_4;
            let t_9 = (-s_1).mul_add(s_2, c_1 * c_2);
            let t_10 = real(4.905) * t_9;
            let t_11 = real(49.05).mul_add(c_1, t_10);
            (
                ::robot_dynamics::nalgebra::SMatrix::from_data(
                    ::robot_dynamics::nalgebra::ArrayStorage([
                        [t_2, t_3],
                        [t_3, real(0.3333333333333333)],
                    ]),
                ),
                ::robot_dynamics::nalgebra::SMatrix::from_data(
                    ::robot_dynamics::nalgebra::ArrayStorage([[-t_7, t_8]]),
                ),
                ::robot_dynamics::nalgebra::SMatrix::from_data(
                    ::robot_dynamics::nalgebra::ArrayStorage([[t_11, t_10]]),
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
        let [(s_1, c_1), (s_2, c_2)] = ::robot_dynamics::Inputs::sin_cos(
            sines,
            [0, 1],
            [q.data.0[0][0], q.data.0[0][1]],
        );
        let qd_1 = qd.data.0[0][0];
        let qd_2 = qd.data.0[0][1];
        let tau_1 = tau.data.0[0][0];
        let tau_2 = tau.data.0[0][1];
        let t_1 = qd_1 + qd_2;
        let t_2 = t_1 * t_1;
        let t_3 = c_1 * c_2;
        let t_4 = qd_1 * qd_1;
        let t_5 = real(-4.905).mul_add(s_1, t_4);
        let t_6 = s_2.mul_add(t_5, real(4.905) * t_3);
        let t_7 = t_6 - tau_2;
        let t_8 = real(0.3333333333333333) + c_2;
        let t_9 = real(3.0) * t_8;
        let t_10 = real(49.05).mul_add(c_1, -tau_1);
        let t_11 = (-s_2).mul_add(t_2, t_10);
        let t_12 = t_11 + t_6;
        let t_13 = (-t_7).mul_add(t_9, t_12);
        let t_14 = real(2.0).mul_add(c_2, real(8.333333333333334));
        let t_15 = (-t_8).mul_add(t_9, t_14);
        let t_16 = real(1.0) / t_15;
        let t_17 = t_13 * t_16;
        let t_18 = real(-3.0).mul_add(t_7, t_9 * t_17);
        let t_19 = qd_1 * t_1;
        let t_20 = real(0.041666666666666664).mul_add(t_2, t_4);
        let t_21 = c_2.mul_add(t_19, real(4.0) * t_20);
        ::robot_dynamics::SingularMassMatrix::test_joint(
            1,
            "joint2",
            real(0.3333333333333333),
            real(0.3333333333333333),
        )?;
        ::robot_dynamics::SingularMassMatrix::test_joint(0, "joint1", t_15, t_14)?;
        ::core::result::Result::Ok((
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[-t_17, t_18]]),
            ),
            t_21,
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
            let [(s_1, c_1), (s_2, c_2)] = ::robot_dynamics::Inputs::sin_cos(
                sines,
                [0, 1],
                [q.data.0[0][0], q.data.0[0][1]],
            );
            let t_1 = real(10.0) + c_2;
            let t_2 = s_1.mul_add(t_1, c_1 * s_2);
            let t_3 = real(4.905) * t_2;
            (
                ::robot_dynamics::nalgebra::SMatrix::from_data(
                    ::robot_dynamics::nalgebra::ArrayStorage([[real(0.0), real(0.0)]]),
                ),
                t_3,
            )
        })
    }
}
