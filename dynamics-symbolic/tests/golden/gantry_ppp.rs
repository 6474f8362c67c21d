impl Arm {
    /// Mass matrix M(q), N x N, both triangles, reflected motor inertias included (kg m^2, kg m or kg). Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong).
    ///
    /// `q`: joint positions, m.
    ///
    /// Operations: 0 multiplications, 0 additions.
    ///
    /// M12, M13, M23 are zero; M11, M22, M33 are constant.
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
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn mass_matrix<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 3, 3> {
        <Self as ::robot_dynamics::MassMatrix<
            3,
        >>::mass_matrix_at(self, &::robot_dynamics::Evaluated, q)
    }
    /// Coriolis and centrifugal vector V(q, qd), N m or N: inverse dynamics without gravity, springs, friction and acceleration.
    ///
    /// `q`: joint positions, m; `qd`: joint velocities, m per s.
    ///
    /// Operations: 0 multiplications, 0 additions.
    ///
    /// V1, V2, V3 are zero.
    ///
    /// ```text
    /// V1 = 0
    /// V2 = 0
    /// V3 = 0
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn coriolis_vector<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 3> {
        <Self as ::robot_dynamics::CoriolisVector<
            3,
        >>::coriolis_vector_at(self, &::robot_dynamics::Evaluated, q, qd)
    }
    /// Gravity vector G(q), N m or N: the gradient of the potential energy of gravity, inverse dynamics at rest without springs.
    ///
    /// `q`: joint positions, m.
    ///
    /// Operations: 0 multiplications, 0 additions.
    ///
    /// G2, G3 are zero; G1 is constant.
    ///
    /// ```text
    /// G1 = 215.82
    /// G2 = 0
    /// G3 = 0
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn gravity_vector<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 3> {
        <Self as ::robot_dynamics::GravityVector<
            3,
        >>::gravity_vector_at(self, &::robot_dynamics::Evaluated, q)
    }
    /// Friction vector F(qd) = viscous qd + sign(qd) (C + (S - C) exp(-(qd/v)^2)), N m or N, with sign(0) = 0: C is the Coulomb friction of the direction, S static friction that falls to it over the velocity v, where the table has one, else C.
    ///
    /// `qd`: joint velocities, m per s.
    ///
    /// Operations: 6 multiplications, 3 additions.
    ///
    /// F1 depends on qd1; F2 depends on qd2; F3 depends on qd3.
    ///
    /// ```text
    /// F1 = 5 qd1 + 8 sign(qd1)
    /// F2 = 4 qd2 + 6 sign(qd2)
    /// F3 = 3 qd3 + 4 sign(qd3)
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn friction_vector<T: ::robot_dynamics::Scalar>(
        &self,
        qd: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 3> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::FrictionVector,
            3,
        >>::at(
            self,
            ::robot_dynamics::functions::FrictionVector,
            &::robot_dynamics::Evaluated,
            &(*qd,),
        );
        all_values
    }
    /// Inverse dynamics tau = M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd), N m or N, as one program; K is of springs, F of friction.
    ///
    /// `q`: joint positions, m; `qd`: joint velocities, m per s; `qdd`: joint accelerations, m per s^2.
    ///
    /// Operations: 8 multiplications, 7 additions.
    ///
    /// tau1 depends on qd1, qdd1; tau2 depends on qd2, qdd2; tau3 depends on qd3, qdd3.
    ///
    /// ```text
    /// tau1 = 215.82 + 5 qd1 + 8 sign(qd1) + 22 qdd1
    /// tau2 = 4 qd2 + 6 sign(qd2) + 10 qdd2
    /// tau3 = 3 qd3 + 4 sign(qd3) + 3 qdd3
    /// ```
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
        <Self as ::robot_dynamics::InverseDynamics<
            3,
        >>::inverse_dynamics_at(self, &::robot_dynamics::Evaluated, q, qd, qdd)
    }
    /// Forward dynamics: the accelerations qdd with M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau, rad/s^2 or m/s^2; K is of springs, F of friction.
    ///
    /// `q`: joint positions, m; `qd`: joint velocities, m per s; `tau`: joint forces and torques, N.
    ///
    /// Operations: 8 multiplications, 7 additions.
    ///
    /** # Errors

 `SingularMassMatrix` where M(q) is not positive definite to working precision, or not finite: it names the joint whose pivot failed.*/
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
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
        <Self as ::robot_dynamics::ForwardDynamics<
            3,
        >>::forward_dynamics_at(self, &::robot_dynamics::Evaluated, q, qd, tau)
    }
    /// Kinetic energy T(q, qd) = 1/2 qd^T M(q) qd, reflected motor inertias included, J.
    ///
    /// `q`: joint positions, m; `qd`: joint velocities, m per s.
    ///
    /// Operations: 6 multiplications, 4 additions.
    ///
    /// ```text
    /// T = 11 qd1^2 + 5 qd2^2 + 3/2 qd3^2
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn kinetic_energy<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> T {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::KineticEnergy,
            3,
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
    /// `q`: joint positions, m.
    ///
    /// Operations: 1 multiplication, 1 addition.
    ///
    /// ```text
    /// U = -8.7309 + 215.82 q1
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn potential_energy<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> T {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::PotentialEnergy,
            3,
        >>::at(
            self,
            ::robot_dynamics::functions::PotentialEnergy,
            &::robot_dynamics::Evaluated,
            &(*q,),
        );
        all_values
    }
}
impl ::robot_dynamics::MassMatrix<3> for Arm {
    const WORK: u32 = 0;
    #[inline]
    fn mass_matrix<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 3, 3> {
        Self::mass_matrix(self, q)
    }
    #[inline(always)]
    fn mass_matrix_at<T: ::robot_dynamics::Scalar>(
        &self,
        sines: &impl ::robot_dynamics::Inputs<T>,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 3, 3> {
        let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([
                [real(22.0), real(0.0), real(0.0)],
                [real(0.0), real(10.0), real(0.0)],
                [real(0.0), real(0.0), real(3.0)],
            ]),
        )
    }
}
impl ::robot_dynamics::CoriolisVector<3> for Arm {
    const WORK: u32 = 0;
    #[inline]
    fn coriolis_vector<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 3> {
        Self::coriolis_vector(self, q, qd)
    }
    #[inline(always)]
    fn coriolis_vector_at<T: ::robot_dynamics::Scalar>(
        &self,
        sines: &impl ::robot_dynamics::Inputs<T>,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 3> {
        let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[real(0.0), real(0.0), real(0.0)]]),
        )
    }
}
impl ::robot_dynamics::GravityVector<3> for Arm {
    const WORK: u32 = 0;
    #[inline]
    fn gravity_vector<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 3> {
        Self::gravity_vector(self, q)
    }
    #[inline(always)]
    fn gravity_vector_at<T: ::robot_dynamics::Scalar>(
        &self,
        sines: &impl ::robot_dynamics::Inputs<T>,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 3> {
        let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([
                [real(215.82), real(0.0), real(0.0)],
            ]),
        )
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::FrictionVector, 3> for Arm {
    type Arguments = (::robot_dynamics::Entries<3, 1>,);
    type Values = ::robot_dynamics::Entries<3, 1>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["qd"];
    const RESULT: &'static str = "friction_vector";
    const WORK: u32 = 9;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::FrictionVector,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (qd,): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
    ) -> ::core::result::Result<
        <Self::Values as ::robot_dynamics::Arrangement>::Of<T>,
        Self::Error,
    > {
        ::core::result::Result::Ok({
            let real = |x: f64| ::robot_dynamics::Scalar::constant(qd.data.0[0][0], x);
            let qd_1_ = qd.data.0[0][0];
            let qd_2_ = qd.data.0[0][1];
            let qd_3_ = qd.data.0[0][2];
            let sign_1_ = ::robot_dynamics::Scalar::sign(qd.data.0[0][0]);
            let sign_2_ = ::robot_dynamics::Scalar::sign(qd.data.0[0][1]);
            let sign_3_ = ::robot_dynamics::Scalar::sign(qd.data.0[0][2]);
            let t_1_ = real(8.0).mul_add(sign_1_, real(5.0) * qd_1_);
            let t_2_ = real(6.0).mul_add(sign_2_, real(4.0) * qd_2_);
            let t_3_ = real(4.0).mul_add(sign_3_, real(3.0) * qd_3_);
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[t_1_, t_2_, t_3_]]),
            )
        })
    }
}
impl ::robot_dynamics::InverseDynamics<3> for Arm {
    const WORK: u32 = 15;
    #[inline]
    fn inverse_dynamics<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 3>,
        qdd: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 3> {
        Self::inverse_dynamics(self, q, qd, qdd)
    }
    #[inline(always)]
    fn inverse_dynamics_at<T: ::robot_dynamics::Scalar>(
        &self,
        sines: &impl ::robot_dynamics::Inputs<T>,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 3>,
        qdd: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 3> {
        let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
        let qd_1_ = qd.data.0[0][0];
        let qd_2_ = qd.data.0[0][1];
        let qd_3_ = qd.data.0[0][2];
        let sign_1_ = ::robot_dynamics::Scalar::sign(qd.data.0[0][0]);
        let sign_2_ = ::robot_dynamics::Scalar::sign(qd.data.0[0][1]);
        let sign_3_ = ::robot_dynamics::Scalar::sign(qd.data.0[0][2]);
        let qdd_1_ = qdd.data.0[0][0];
        let qdd_2_ = qdd.data.0[0][1];
        let qdd_3_ = qdd.data.0[0][2];
        let t_1_ = qdd_1_ + real(9.81);
        let t_2_ = real(22.0).mul_add(t_1_, real(5.0) * qd_1_);
        let t_3_ = real(8.0).mul_add(sign_1_, t_2_);
        let t_4_ = real(4.0).mul_add(qd_2_, real(10.0) * qdd_2_);
        let t_5_ = real(6.0).mul_add(sign_2_, t_4_);
        let t_6_ = qd_3_ + qdd_3_;
        let t_7_ = real(1.3333333333333333).mul_add(sign_3_, t_6_);
        let t_8_ = real(3.0) * t_7_;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t_3_, t_5_, t_8_]]),
        )
    }
}
impl ::robot_dynamics::ForwardDynamics<3> for Arm {
    const WORK: u32 = 15;
    #[inline]
    fn forward_dynamics<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 3>,
        tau: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> ::core::result::Result<
        ::robot_dynamics::nalgebra::SVector<T, 3>,
        ::robot_dynamics::SingularMassMatrix,
    > {
        Self::forward_dynamics(self, q, qd, tau)
    }
    #[inline(always)]
    fn forward_dynamics_at<T: ::robot_dynamics::Scalar>(
        &self,
        sines: &impl ::robot_dynamics::Inputs<T>,
        q: &::robot_dynamics::nalgebra::SVector<T, 3>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 3>,
        tau: &::robot_dynamics::nalgebra::SVector<T, 3>,
    ) -> ::core::result::Result<
        ::robot_dynamics::nalgebra::SVector<T, 3>,
        ::robot_dynamics::SingularMassMatrix,
    > {
        let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
        let qd_1_ = qd.data.0[0][0];
        let qd_2_ = qd.data.0[0][1];
        let qd_3_ = qd.data.0[0][2];
        let sign_1_ = ::robot_dynamics::Scalar::sign(qd.data.0[0][0]);
        let sign_2_ = ::robot_dynamics::Scalar::sign(qd.data.0[0][1]);
        let sign_3_ = ::robot_dynamics::Scalar::sign(qd.data.0[0][2]);
        let tau_1_ = tau.data.0[0][0];
        let tau_2_ = tau.data.0[0][1];
        let tau_3_ = tau.data.0[0][2];
        let t_1_ = real(5.0).mul_add(qd_1_, -tau_1_);
        let t_2_ = real(215.82) + t_1_;
        let t_3_ = real(8.0).mul_add(sign_1_, t_2_);
        let t_4_ = real(0.045454545454545456) * t_3_;
        let t_5_ = real(-4.0).mul_add(qd_2_, tau_2_);
        let t_6_ = real(-6.0).mul_add(sign_2_, t_5_);
        let t_7_ = real(0.1) * t_6_;
        let t_8_ = real(-0.3333333333333333).mul_add(tau_3_, qd_3_);
        let t_9_ = real(1.3333333333333333).mul_add(sign_3_, t_8_);
        ::robot_dynamics::SingularMassMatrix::test_joint(
            2,
            "joint3",
            real(3.0),
            real(3.0),
        )?;
        ::robot_dynamics::SingularMassMatrix::test_joint(
            1,
            "joint2",
            real(10.0),
            real(10.0),
        )?;
        ::robot_dynamics::SingularMassMatrix::test_joint(
            0,
            "joint1",
            real(22.0),
            real(22.0),
        )?;
        ::core::result::Result::Ok(
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[-t_4_, t_7_, -t_9_]]),
            ),
        )
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::KineticEnergy, 3> for Arm {
    type Arguments = (::robot_dynamics::Entries<3, 1>, ::robot_dynamics::Entries<3, 1>);
    type Values = ::robot_dynamics::Number;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd"];
    const RESULT: &'static str = "kinetic_energy";
    const WORK: u32 = 10;
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
            let qd_1_ = qd.data.0[0][0];
            let qd_2_ = qd.data.0[0][1];
            let qd_3_ = qd.data.0[0][2];
            let t_1_ = qd_1_ * qd_1_;
            let t_2_ = qd_2_.mul_add(qd_2_, t_1_);
            let t_3_ = qd_3_.mul_add(qd_3_, t_2_);
            let t_4_ = real(0.5833333333333334).mul_add(t_2_, t_1_);
            let t_5_ = real(0.25).mul_add(t_3_, t_4_);
            let t_6_ = real(6.0) * t_5_;
            t_6_
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::PotentialEnergy, 3>
for Arm {
    type Arguments = (::robot_dynamics::Entries<3, 1>,);
    type Values = ::robot_dynamics::Number;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q"];
    const RESULT: &'static str = "potential_energy";
    const WORK: u32 = 2;
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
            let q_1_ = q.data.0[0][0];
            let t_1_ = real(0.04045454545454545) - q_1_;
            let t_2_ = real(-215.82) * t_1_;
            t_2_
        })
    }
}
