impl Arm {
    /// Forward kinematics: the homogeneous transform of the frame `Right tip` in the base frame, m.
    ///
    /// `q`: joint positions, rad.
    ///
    /// Operations: 2 multiplications, 1 addition, sine and cosine of one angle.
    ///
    /// T13, T23, T31, T32, T34, T41, T42, T43 are zero; T33, T44 are constant; T11, T12, T14, T21, T22, T24 depend on q2.
    ///
    /// ```text
    /// T11 = c2
    /// T12 = -s2
    /// T13 = 0
    /// T14 = width + length c2
    /// T21 = s2
    /// T22 = c2
    /// T23 = 0
    /// T24 = length s2
    /// T31 = 0
    /// T32 = 0
    /// T33 = 1
    /// T34 = 0
    /// T41 = 0
    /// T42 = 0
    /// T43 = 0
    /// T44 = 1
    /// with c2 = cos(q2), s2 = sin(q2)
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn forward_kinematics_right_tip<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::Matrix4<T> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::Fused<0>,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::Fused::<0>,
            &::robot_dynamics::Evaluated,
            &(*q,),
        );
        all_values
    }
    /// Geometric Jacobian of the frame `Left tip`'s origin, 6 x N, rows vx vy vz wx wy wz, in the base frame.
    ///
    /// `q`: joint positions, rad.
    ///
    /// Operations: 2 multiplications, 0 additions, sine and cosine of one angle.
    ///
    /// J12, J22, J31, J32, J41, J42, J51, J52, J62 are zero; J61 is constant; J11, J21 depend on q1.
    ///
    /// ```text
    /// J11 = -length s1
    /// J12 = 0
    /// J21 = length c1
    /// J22 = 0
    /// J31 = 0
    /// J32 = 0
    /// J41 = 0
    /// J42 = 0
    /// J51 = 0
    /// J52 = 0
    /// J61 = 1
    /// J62 = 0
    /// with c1 = cos(q1), s1 = sin(q1)
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn jacobian_left_tip<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 6, 2> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::Fused<1>,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::Fused::<1>,
            &::robot_dynamics::Evaluated,
            &(*q,),
        );
        all_values
    }
    /// Joint torques J(q)^T w of a wrench at the frame `Right tip`, N m or N, without J: M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau + J(q)^T w.
    ///
    /// `q`: joint positions, rad; `wrench`: force (N) on the frame `Right tip` and moment (N m) about its origin, fx fy fz nx ny nz in the axes of `jacobian`, that the surroundings apply.
    ///
    /// Operations: 3 multiplications, 2 additions, sine and cosine of one angle.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn wrench_torques_right_tip<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        wrench: &::robot_dynamics::nalgebra::Vector6<T>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::Fused<2>,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::Fused::<2>,
            &::robot_dynamics::Evaluated,
            &(*q, *wrench),
        );
        all_values
    }
    /// (`mass_matrix`, `jacobian_left_tip`, `jacobian_right_tip`) at one state, as one program.
    ///
    /// - `0`: Mass matrix M(q), N x N, both triangles, reflected motor inertias included (kg m^2, kg m or kg). Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong).
    /// - `1`: Geometric Jacobian of the frame `Left tip`'s origin, 6 x N, rows vx vy vz wx wy wz, in the base frame.
    /// - `2`: Geometric Jacobian of the frame `Right tip`'s origin, 6 x N, rows vx vy vz wx wy wz, in the base frame.
    ///
    /// `q`: joint positions, rad.
    ///
    /// A call of each function takes 5 multiplications, additions and divisions in all, and sines and cosines 2 times: nothing is saved here.
    ///
    /// Operations: 5 multiplications, 0 additions, sines and cosines of 2 angles.
    ///
    /// M11, M12 are zero; M22 is constant.
    ///
    /// `jacobian_left_tip`: J12, J22, J31, J32, J41, J42, J51, J52, J62 are zero; J61 is constant; J11, J21 depend on q1.
    ///
    /// `jacobian_right_tip`: J11, J21, J31, J32, J41, J42, J51, J52, J61 are zero; J62 is constant; J12, J22 depend on q2.
    ///
    /// ```text
    /// M11 = 0
    /// M12 = 0
    /// M21 = 0
    /// M22 = length^2
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn pinch<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> (
        ::robot_dynamics::nalgebra::SMatrix<T, 2, 2>,
        ::robot_dynamics::nalgebra::SMatrix<T, 6, 2>,
        ::robot_dynamics::nalgebra::SMatrix<T, 6, 2>,
    ) {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::Fused<3>,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::Fused::<3>,
            &::robot_dynamics::Evaluated,
            &(*q,),
        );
        all_values
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::Fused<0>, 2> for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>,);
    type Values = ::robot_dynamics::Entries<4, 4>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q"];
    const RESULT: &'static str = "forward_kinematics_right_tip";
    const WORK: u32 = 43;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::Fused<0>,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (q,): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
    ) -> ::core::result::Result<
        <Self::Values as ::robot_dynamics::Arrangement>::Of<T>,
        Self::Error,
    > {
        ::core::result::Result::Ok({
            let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
            let [(s_2_, c_2_)] = ::robot_dynamics::Inputs::sin_cos(
                sines,
                [1],
                [q.data.0[0][1]],
            );
            let p_width_ = ::robot_dynamics::Inputs::field(
                sines,
                0,
                self.width,
                q.data.0[0][0],
            );
            let p_length_ = ::robot_dynamics::Inputs::field(
                sines,
                1,
                self.length,
                q.data.0[0][0],
            );
            let t_1_ = p_length_.mul_add(c_2_, p_width_);
            let t_2_ = p_length_ * s_2_;
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [c_2_, s_2_, real(0.0), real(0.0)],
                    [-s_2_, c_2_, real(0.0), real(0.0)],
                    [real(0.0), real(0.0), real(1.0), real(0.0)],
                    [t_1_, t_2_, real(0.0), real(1.0)],
                ]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::Fused<1>, 2> for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>,);
    type Values = ::robot_dynamics::Entries<6, 2>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q"];
    const RESULT: &'static str = "jacobian_left_tip";
    const WORK: u32 = 42;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::Fused<1>,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (q,): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
    ) -> ::core::result::Result<
        <Self::Values as ::robot_dynamics::Arrangement>::Of<T>,
        Self::Error,
    > {
        ::core::result::Result::Ok({
            let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
            let [(s_1_, c_1_)] = ::robot_dynamics::Inputs::sin_cos(
                sines,
                [0],
                [q.data.0[0][0]],
            );
            let p_length_ = ::robot_dynamics::Inputs::field(
                sines,
                1,
                self.length,
                q.data.0[0][0],
            );
            let t_1_ = p_length_ * s_1_;
            let t_2_ = p_length_ * c_1_;
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [-t_1_, t_2_, real(0.0), real(0.0), real(0.0), real(1.0)],
                    [real(0.0), real(0.0), real(0.0), real(0.0), real(0.0), real(0.0)],
                ]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::Fused<2>, 2> for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>, ::robot_dynamics::Entries<6, 1>);
    type Values = ::robot_dynamics::Entries<2, 1>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "wrench"];
    const RESULT: &'static str = "wrench_torques_right_tip";
    const WORK: u32 = 45;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::Fused<2>,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (q, wrench): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
    ) -> ::core::result::Result<
        <Self::Values as ::robot_dynamics::Arrangement>::Of<T>,
        Self::Error,
    > {
        ::core::result::Result::Ok({
            let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
            let [(s_2_, c_2_)] = ::robot_dynamics::Inputs::sin_cos(
                sines,
                [1],
                [q.data.0[0][1]],
            );
            let p_length_ = ::robot_dynamics::Inputs::field(
                sines,
                1,
                self.length,
                q.data.0[0][0],
            );
            let wrench_1_ = wrench.data.0[0][0];
            let wrench_2_ = wrench.data.0[0][1];
            let wrench_6_ = wrench.data.0[0][5];
            let t_1_ = (-s_2_).mul_add(wrench_1_, c_2_ * wrench_2_);
            let t_2_ = p_length_.mul_add(t_1_, wrench_6_);
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[real(0.0), t_2_]]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::Fused<3>, 2> for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>,);
    type Values = (
        ::robot_dynamics::Entries<2, 2>,
        ::robot_dynamics::Entries<6, 2>,
        ::robot_dynamics::Entries<6, 2>,
    );
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q"];
    const RESULT: &'static str = "pinch";
    const WORK: u32 = 85;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::Fused<3>,
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
            let p_length_ = ::robot_dynamics::Inputs::field(
                sines,
                1,
                self.length,
                q.data.0[0][0],
            );
            let t_1_ = p_length_ * p_length_;
            let t_2_ = p_length_ * s_1_;
            let t_3_ = p_length_ * c_1_;
            let t_4_ = p_length_ * s_2_;
            let t_5_ = p_length_ * c_2_;
            (
                ::robot_dynamics::nalgebra::SMatrix::from_data(
                    ::robot_dynamics::nalgebra::ArrayStorage([
                        [real(0.0), real(0.0)],
                        [real(0.0), t_1_],
                    ]),
                ),
                ::robot_dynamics::nalgebra::SMatrix::from_data(
                    ::robot_dynamics::nalgebra::ArrayStorage([
                        [-t_2_, t_3_, real(0.0), real(0.0), real(0.0), real(1.0)],
                        [
                            real(0.0),
                            real(0.0),
                            real(0.0),
                            real(0.0),
                            real(0.0),
                            real(0.0),
                        ],
                    ]),
                ),
                ::robot_dynamics::nalgebra::SMatrix::from_data(
                    ::robot_dynamics::nalgebra::ArrayStorage([
                        [
                            real(0.0),
                            real(0.0),
                            real(0.0),
                            real(0.0),
                            real(0.0),
                            real(0.0),
                        ],
                        [-t_4_, t_5_, real(0.0), real(0.0), real(0.0), real(1.0)],
                    ]),
                ),
            )
        })
    }
}
