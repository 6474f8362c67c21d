impl Arm {
    /// Mass matrix M(q), N x N, both triangles, reflected motor inertias included (kg m^2, kg m or kg). Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong).
    ///
    /// `q`: joint positions, rad.
    ///
    /// Operations: 0 multiplications, 3 additions, sine and cosine of one angle.
    ///
    /// M22 is constant; M11, M12 depend on q2.
    ///
    /// ```text
    /// M11 = 8.333333333333334 + 2 c2
    /// M12 = 0.33333333333333333 + c2
    /// M21 = 0.33333333333333333 + c2
    /// M22 = 0.33333333333333333
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
    /// Operations: 4 multiplications, 2 additions, sine and cosine of one angle.
    ///
    /// V2 depends on q2, qd1; V1 depends on q2, qd1, qd2.
    ///
    /// ```text
    /// V1 = -2 s2 qd1 qd2 - s2 qd2^2
    /// V2 = s2 qd1^2
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
    /// Operations: 4 multiplications, 2 additions, sines and cosines of 2 angles.
    ///
    /// G1, G2 depend on q1, q2.
    ///
    /// ```text
    /// G1 = 49.05 c1 + 4.905 c12
    /// G2 = 4.905 c12
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
    /// Friction vector F(qd) = viscous qd + sign(qd) (C + (S - C) exp(-(qd/v)^2)), N m or N, with sign(0) = 0: C is the Coulomb friction of the direction, S static friction that falls to it over the velocity v, where the table has one, else C.
    ///
    /// `qd`: joint velocities, rad per s.
    ///
    /// Operations: 0 multiplications, 0 additions.
    ///
    /// F1, F2 are zero.
    ///
    /// ```text
    /// F1 = 0
    /// F2 = 0
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn friction_vector<T: ::robot_dynamics::Scalar>(
        &self,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::FrictionVector,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::FrictionVector,
            &::robot_dynamics::Evaluated,
            &(*qd,),
        );
        all_values
    }
    /// Spring vector K(q) = stiffness (q - rest), N m or N: the gradient of the energy in the springs at the joints, zero where a joint has none.
    ///
    /// `q`: joint positions, rad.
    ///
    /// Operations: 0 multiplications, 0 additions.
    ///
    /// K1, K2 are zero.
    ///
    /// ```text
    /// K1 = 0
    /// K2 = 0
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn spring_vector<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::SpringVector,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::SpringVector,
            &::robot_dynamics::Evaluated,
            &(*q,),
        );
        all_values
    }
    /// Inverse dynamics tau = M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd), N m or N, as one program; K is of springs, F of friction.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s; `qdd`: joint accelerations, rad per s^2.
    ///
    /// Operations: 11 multiplications, 10 additions, sines and cosines of 2 angles.
    ///
    /// tau1 depends on q1, q2, qd1, qd2, qdd1, qdd2; tau2 depends on q1, q2, qd1, qdd1, qdd2.
    ///
    /// ```text
    /// tau1 = 49.05 c1 + 4.905 c12 - 2 s2 qd1 qd2 - s2 qd2^2 + (8.333333333333334 + 2 c2) qdd1 + (0.33333333333333333 + c2) qdd2
    /// tau2 = 4.905 c12 + s2 qd1^2 + (0.33333333333333333 + c2) qdd1 + 0.33333333333333333 qdd2
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
    /// Operations: 15 multiplications, 12 additions, 1 division, sines and cosines of 2 angles.
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
    /// Operations: 6 multiplications, 3 additions, sine and cosine of one angle.
    ///
    /// ```text
    /// T = (4.166666666666667 + c2) qd1^2 + (0.33333333333333333 + c2) qd1 qd2 + 0.16666666666666666 qd2^2
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
    /// Operations: 3 multiplications, 2 additions, sines and cosines of 2 angles.
    ///
    /// ```text
    /// U = 49.05 s1 + 4.905 s12
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
    /// Bias force V(q, qd) + G(q) + K(q) + F(qd), N m or N: inverse dynamics without acceleration; K is of springs, F of friction.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s.
    ///
    /// Operations: 8 multiplications, 5 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn bias_force<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::BiasForce,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::BiasForce,
            &::robot_dynamics::Evaluated,
            &(*q, *qd),
        );
        all_values
    }
    /// Coriolis matrix C(q, qd), N x N, from the Christoffel symbols of the first kind: C qd = V, and dM/dt - 2 C is skew-symmetric.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s.
    ///
    /// Operations: 2 multiplications, 1 addition, sine and cosine of one angle.
    ///
    /// C22 is zero; C21 depends on q2, qd1; C12 depends on q2, qd1, qd2; C11 depends on q2, qd2.
    ///
    /// ```text
    /// C11 = -s2 qd2
    /// C12 = -s2 qd1 - s2 qd2
    /// C21 = s2 qd1
    /// C22 = 0
    /// with s2 = sin(q2)
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn coriolis_matrix<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 2, 2> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::CoriolisMatrix,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::CoriolisMatrix,
            &::robot_dynamics::Evaluated,
            &(*q, *qd),
        );
        all_values
    }
    /// Coriolis coefficients B(q), N x N(N-1)/2, columns in the order (1,2), (1,3), ..., (N-1,N), of the configuration-space form tau = M qdd + B [qd qd] + C [qd^2] + G.
    ///
    /// `q`: joint positions, rad.
    ///
    /// Operations: 1 multiplication, 0 additions, sine and cosine of one angle.
    ///
    /// B21 is zero; B11 depends on q2.
    ///
    /// ```text
    /// B11 = -2 s2
    /// B21 = 0
    /// with s2 = sin(q2)
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn coriolis_coefficients<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 2, 1> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::CoriolisCoefficients,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::CoriolisCoefficients,
            &::robot_dynamics::Evaluated,
            &(*q,),
        );
        all_values
    }
    /// Centrifugal coefficients C(q), N x N, of the configuration-space form tau = M qdd + B [qd qd] + C [qd^2] + G.
    ///
    /// `q`: joint positions, rad.
    ///
    /// Operations: 0 multiplications, 0 additions, sine and cosine of one angle.
    ///
    /// C11, C22 are zero; C12, C21 depend on q2.
    ///
    /// ```text
    /// C11 = 0
    /// C12 = -s2
    /// C21 = s2
    /// C22 = 0
    /// with s2 = sin(q2)
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn centrifugal_coefficients<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 2, 2> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::CentrifugalCoefficients,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::CentrifugalCoefficients,
            &::robot_dynamics::Evaluated,
            &(*q,),
        );
        all_values
    }
    /// Forward kinematics: the homogeneous transform of the last link frame in the base frame, m.
    ///
    /// `q`: joint positions, rad.
    ///
    /// Operations: 6 multiplications, 4 additions, sines and cosines of 2 angles.
    ///
    /// T13, T23, T31, T32, T34, T41, T42, T43 are zero; T33, T44 are constant; T11, T12, T14, T21, T22, T24 depend on q1, q2.
    ///
    /// ```text
    /// T11 = c12
    /// T12 = -s12
    /// T13 = 0
    /// T14 = 2 c1 + c12
    /// T21 = s12
    /// T22 = c12
    /// T23 = 0
    /// T24 = 2 s1 + s12
    /// T31 = 0
    /// T32 = 0
    /// T33 = 1
    /// T34 = 0
    /// T41 = 0
    /// T42 = 0
    /// T43 = 0
    /// T44 = 1
    /// with c1 = cos(q1), s1 = sin(q1), c12 = cos(q1 + q2), s12 = sin(q1 + q2)
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn forward_kinematics<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::Matrix4<T> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::ForwardKinematics,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::ForwardKinematics,
            &::robot_dynamics::Evaluated,
            &(*q,),
        );
        all_values
    }
    /// Homogeneous transforms in the base frame of every link frame whose joint moves, from the base outwards, m.
    ///
    /// `q`: joint positions, rad.
    ///
    /// Operations: 6 multiplications, 4 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn link_poses<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> [::robot_dynamics::nalgebra::Matrix4<T>; 2] {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::LinkPoses,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::LinkPoses,
            &::robot_dynamics::Evaluated,
            &(*q,),
        );
        all_values
    }
    /// Geometric Jacobian of the last link frame's origin, 6 x N, rows vx vy vz wx wy wz, in the base frame.
    ///
    /// `q`: joint positions, rad.
    ///
    /// Operations: 6 multiplications, 4 additions, sines and cosines of 2 angles.
    ///
    /// J31, J32, J41, J42, J51, J52 are zero; J61, J62 are constant; J11, J12, J21, J22 depend on q1, q2.
    ///
    /// ```text
    /// J11 = -2 s1 - s12
    /// J12 = -s12
    /// J21 = 2 c1 + c12
    /// J22 = c12
    /// J31 = 0
    /// J32 = 0
    /// J41 = 0
    /// J42 = 0
    /// J51 = 0
    /// J52 = 0
    /// J61 = 1
    /// J62 = 1
    /// with c1 = cos(q1), s1 = sin(q1), c12 = cos(q1 + q2), s12 = sin(q1 + q2)
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn jacobian<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 6, 2> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::Jacobian,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::Jacobian,
            &::robot_dynamics::Evaluated,
            &(*q,),
        );
        all_values
    }
    /// Derivatives of the inverse dynamics, exact: (d tau/dq, d tau/dqd), each N x N, entry (i, j) the derivative of tau_i by joint j. d tau/dqdd is M(q). The stiffness of springs is on the diagonal of d tau/dq, viscous friction on that of d tau/dqd; Coulomb friction counts as constant: its derivative is zero wherever it has one.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s; `qdd`: joint accelerations, rad per s^2.
    ///
    /// Operations: 16 multiplications, 10 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn inverse_dynamics_derivatives<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qdd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> (
        ::robot_dynamics::nalgebra::SMatrix<T, 2, 2>,
        ::robot_dynamics::nalgebra::SMatrix<T, 2, 2>,
    ) {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::InverseDynamicsDerivatives,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::InverseDynamicsDerivatives,
            &::robot_dynamics::Evaluated,
            &(*q, *qd, *qdd),
        );
        all_values
    }
    /// Derivatives of the forward dynamics at qdd = forward_dynamics(q, qd, tau), exact: (d qdd/dq, d qdd/dqd, d qdd/d tau), each N x N, entry (i, j) the derivative of qdd_i by joint j. d qdd/d tau is the inverse of M(q). Coulomb friction counts as constant: its derivative is zero wherever it has one.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s; `tau`: joint forces and torques, N m.
    ///
    /// Operations: 42 multiplications, 27 additions, 1 division, sines and cosines of 2 angles.
    ///
    /** # Errors

 `SingularMassMatrix` where M(q) is not positive definite to working precision, or not finite: it names the joint whose pivot failed.*/
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn forward_dynamics_derivatives<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
        tau: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::core::result::Result<
        (
            ::robot_dynamics::nalgebra::SMatrix<T, 2, 2>,
            ::robot_dynamics::nalgebra::SMatrix<T, 2, 2>,
            ::robot_dynamics::nalgebra::SMatrix<T, 2, 2>,
        ),
        ::robot_dynamics::SingularMassMatrix,
    > {
        <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::ForwardDynamicsDerivatives,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::ForwardDynamicsDerivatives,
            &::robot_dynamics::Evaluated,
            &(*q, *qd, *tau),
        )
    }
    /// Regressor Y(q, qd, qdd), N x P, of the P base inertial parameters: Y * base_parameters = tau - K - F, the joint forces without springs and friction.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s; `qdd`: joint accelerations, rad per s^2.
    ///
    /// The base parameters:
    ///
    /// ```text
    ///   1  J1zz + a1^2 m2
    ///   2  h1x + a1 m2
    ///   3  h1y
    ///   4  J2zz
    ///   5  h2x
    ///   6  h2y
    /// ```
    ///
    /// Jixx to Jizz (kg m^2) are the entries of link i's inertia tensor about the origin of frame i, hix to hiz (kg m) its first moments mass * com from there, mi (kg) its mass. Frame i is the link frame i of the table before its factors Tx(a) Rx(alpha): its origin and its z axis are on the axis of joint i. ai, di are cells of row i, sai, cai sine and cosine of its alpha.
    ///
    /// Operations: 16 multiplications, 10 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn regressor<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qdd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 2, 6> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::Regressor,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::Regressor,
            &::robot_dynamics::Evaluated,
            &(*q, *qd, *qdd),
        );
        all_values
    }
    /// The P base inertial parameters: the smallest set by which the joint forces of every motion are determined, regressor * base_parameters = tau - K - F.
    ///
    /// The base parameters:
    ///
    /// ```text
    ///   1  J1zz + a1^2 m2
    ///   2  h1x + a1 m2
    ///   3  h1y
    ///   4  J2zz
    ///   5  h2x
    ///   6  h2y
    /// ```
    ///
    /// Jixx to Jizz (kg m^2) are the entries of link i's inertia tensor about the origin of frame i, hix to hiz (kg m) its first moments mass * com from there, mi (kg) its mass. Frame i is the link frame i of the table before its factors Tx(a) Rx(alpha): its origin and its z axis are on the axis of joint i. ai, di are cells of row i, sai, cai sine and cosine of its alpha.
    ///
    /// Operations: 0 multiplications, 0 additions.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn base_parameters<T: ::robot_dynamics::Scalar>(
        &self,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 6> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::BaseParameters,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::BaseParameters,
            &::robot_dynamics::Evaluated,
            &(),
        );
        all_values
    }
    /// Forward dynamics by articulated bodies (Featherstone), without M(q): the accelerations qdd with M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau, rad/s^2 or m/s^2. Longer than `forward_dynamics`, and accurate where M(q) is nearly singular: about as many digits are right as the data determine.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s; `tau`: joint forces and torques, N m.
    ///
    /// Operations: 30 multiplications, 19 additions, 1 division, sines and cosines of 2 angles.
    ///
    /** # Errors

 `SingularMassMatrix` where M(q) is not positive definite to working precision, or not finite: it names the joint whose pivot failed.*/
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn forward_dynamics_aba<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
        tau: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::core::result::Result<
        ::robot_dynamics::nalgebra::SVector<T, 2>,
        ::robot_dynamics::SingularMassMatrix,
    > {
        <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::ForwardDynamicsAba,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::ForwardDynamicsAba,
            &::robot_dynamics::Evaluated,
            &(*q, *qd, *tau),
        )
    }
    /// Taylor coefficients q_0, q_1, ... of the motion q(t) = sum q_k t^k that starts at t = 0 from `q` and `qd` under the constant `tau`, up to `order` (2 to 30); zero beyond. Coulomb friction keeps the sign that it has at the start: the series ends where a joint reverses.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s; `tau`: joint forces and torques, N m.
    ///
    /// Operations of the equations of motion at each order, inner sums of products apart: 11 multiplications, 10 additions, sines and cosines of 2 angles.
    ///
    /** # Errors

 `SingularMassMatrix` where M(q) is not positive definite to working precision, or not finite: it names the joint whose pivot failed.*/
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn taylor_series<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
        tau: &::robot_dynamics::nalgebra::SVector<T, 2>,
        order: usize,
    ) -> ::core::result::Result<
        ::robot_dynamics::TaylorCoefficients<T, 2>,
        ::robot_dynamics::SingularMassMatrix,
    > {
        <Self as ::robot_dynamics::TaylorDynamics<
            2,
        >>::taylor_series(self, q, qd, tau, order)
    }
    /// Joint torques J(q)^T w of a wrench at the tip, N m or N, without J: M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau + J(q)^T w.
    ///
    /// `q`: joint positions, rad; `wrench`: force (N) on the tip and moment (N m) about its origin, fx fy fz nx ny nz in the axes of `jacobian`, that the surroundings apply.
    ///
    /// Operations: 7 multiplications, 5 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn wrench_torques<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        wrench: &::robot_dynamics::nalgebra::Vector6<T>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::WrenchTorques,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::WrenchTorques,
            &::robot_dynamics::Evaluated,
            &(*q, *wrench),
        );
        all_values
    }
    /// Velocity of the tip J(q) qd, vx vy vz wx wy wz, in the base frame, m/s and rad/s, without J.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s.
    ///
    /// Operations: 7 multiplications, 5 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn tool_velocity<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::Vector6<T> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::ToolVelocity,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::ToolVelocity,
            &::robot_dynamics::Evaluated,
            &(*q, *qd),
        );
        all_values
    }
    /// Acceleration of the tip J(q) qdd + dJ/dt qd: of its origin and of its rotation, in the base frame, m/s^2 and rad/s^2, without J and its rate.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s; `qdd`: joint accelerations, rad per s^2.
    ///
    /// Operations: 17 multiplications, 11 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn tool_acceleration<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qdd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::Vector6<T> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::ToolAcceleration,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::ToolAcceleration,
            &::robot_dynamics::Evaluated,
            &(*q, *qd, *qdd),
        );
        all_values
    }
    /// Rate dJ/dt of the geometric Jacobian along a motion, 6 x N, rows as in `jacobian`: the acceleration of the tip is J qdd + dJ/dt qd.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s.
    ///
    /// Operations: 10 multiplications, 5 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn jacobian_rate<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 6, 2> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::JacobianRate,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::JacobianRate,
            &::robot_dynamics::Evaluated,
            &(*q, *qd),
        );
        all_values
    }
    /// Geometric Jacobians of the origins of all link frames whose joint moves, from the base outwards, each 6 x N, rows vx vy vz wx wy wz, in the base frame. Columns of joints beyond a link are zero.
    ///
    /// `q`: joint positions, rad.
    ///
    /// Operations: 6 multiplications, 4 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn link_jacobians<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> [::robot_dynamics::nalgebra::SMatrix<T, 6, 2>; 2] {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::LinkJacobians,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::LinkJacobians,
            &::robot_dynamics::Evaluated,
            &(*q,),
        );
        all_values
    }
    /// Centre of mass of the tool and of all links but those that are locked to the base, in the base frame, m: that of the complete arm where parameters are neglected.
    ///
    /// `q`: joint positions, rad.
    ///
    /// Operations: 6 multiplications, 3 additions, sines and cosines of 2 angles.
    ///
    /// r3 is zero; r1, r2 depend on q1, q2.
    ///
    /// ```text
    /// r1 = 5/4 c1 + 1/8 c12
    /// r2 = 5/4 s1 + 1/8 s12
    /// r3 = 0
    /// with c1 = cos(q1), s1 = sin(q1), c12 = cos(q1 + q2), s12 = sin(q1 + q2)
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn center_of_mass<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::Vector3<T> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::CenterOfMass,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::CenterOfMass,
            &::robot_dynamics::Evaluated,
            &(*q,),
        );
        all_values
    }
    /// Jacobian of `center_of_mass`, 3 x N, by rows x y z: its velocity in the base frame is this times qd.
    ///
    /// `q`: joint positions, rad.
    ///
    /// Operations: 8 multiplications, 4 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn center_of_mass_jacobian<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 3, 2> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::CenterOfMassJacobian,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::CenterOfMassJacobian,
            &::robot_dynamics::Evaluated,
            &(*q,),
        );
        all_values
    }
    /// Centroidal momentum matrix A, 6 x N: A qd is the linear momentum px py pz, kg m/s, then the angular momentum lx ly lz about the centre of mass, kg m^2/s, of what `center_of_mass` counts, in the axes of the base frame. Rotors have no part in it, and nothing is neglected.
    ///
    /// `q`: joint positions, rad.
    ///
    /// Operations: 16 multiplications, 13 additions, sines and cosines of 2 angles.
    ///
    /// A31, A32, A41, A42, A51, A52 are zero; A11, A12, A21, A22, A61, A62 depend on q1, q2.
    ///
    /// ```text
    /// A11 = -5 s1 - 1/2 s12
    /// A12 = -1/2 s12
    /// A21 = 5 c1 + 1/2 c12
    /// A22 = 1/2 c12
    /// A31 = 0
    /// A32 = 0
    /// A41 = 0
    /// A42 = 0
    /// A51 = 0
    /// A52 = 0
    /// A61 = 2.0208333333333335 + 3/4 c2
    /// A62 = 0.27083333333333333 + 3/8 c2
    /// with c1 = cos(q1), s1 = sin(q1), c12 = cos(q1 + q2), s12 = sin(q1 + q2), c2 = cos(q2)
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn centroidal_momentum_matrix<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 6, 2> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::CentroidalMomentumMatrix,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::CentroidalMomentumMatrix,
            &::robot_dynamics::Evaluated,
            &(*q,),
        );
        all_values
    }
    /// Rate of the centroidal momentum at constant velocities, dA/dt qd with A of `centroidal_momentum_matrix`, N and N m: A qdd + dA/dt qd is the sum of all outer forces, gravity among them, then their moment about the centre of mass.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s.
    ///
    /// Operations: 12 multiplications, 5 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn centroidal_momentum_bias<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::Vector6<T> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::CentroidalMomentumBias,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::CentroidalMomentumBias,
            &::robot_dynamics::Evaluated,
            &(*q, *qd),
        );
        all_values
    }
    /// Inverse of the inertia that the tip has in task space, J(q) M(q)^-1 J(q)^T, 6 x 6, rows and columns as those of `jacobian`: the acceleration of the tip by a wrench on it. It exists for every arm whose M is regular; where it is regular itself, its inverse is the operational-space inertia (Khatib).
    ///
    /// `q`: joint positions, rad.
    ///
    /// Operations: 24 multiplications, 16 additions, 1 division, sines and cosines of 2 angles.
    ///
    /** # Errors

 `SingularMassMatrix` where M(q) is not positive definite to working precision, or not finite: it names the joint whose pivot failed.*/
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn operational_inertia_inverse<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::core::result::Result<
        ::robot_dynamics::nalgebra::Matrix6<T>,
        ::robot_dynamics::SingularMassMatrix,
    > {
        <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::OperationalInertiaInverse,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::OperationalInertiaInverse,
            &::robot_dynamics::Evaluated,
            &(*q,),
        )
    }
    /// Generalized momentum p = M(q) qd = dT/dqd, N m s or N s, without M.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s.
    ///
    /// Operations: 4 multiplications, 4 additions, sine and cosine of one angle.
    ///
    /// p1, p2 depend on q2, qd1, qd2.
    ///
    /// ```text
    /// p1 = (8.333333333333334 + 2 c2) qd1 + (0.33333333333333333 + c2) qd2
    /// p2 = (0.33333333333333333 + c2) qd1 + 0.33333333333333333 qd2
    /// with c2 = cos(q2)
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn generalized_momentum<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::GeneralizedMomentum,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::GeneralizedMomentum,
            &::robot_dynamics::Evaluated,
            &(*q, *qd),
        );
        all_values
    }
    /// Rate of the generalized momentum without applied forces, C(q, qd)^T qd - G(q) - K(q) - F(qd), N m or N, with C from the Christoffel symbols: d/dt (M qd) = tau + J^T w + momentum_bias, by which a momentum observer finds unknown forces.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s.
    ///
    /// Operations: 6 multiplications, 4 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn momentum_bias<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::MomentumBias,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::MomentumBias,
            &::robot_dynamics::Evaluated,
            &(*q, *qd),
        );
        all_values
    }
    /// Torque of a passivity-based controller, M(q) qdd_r + C(q, qd) qd_r + G(q) + K(q) + F(qd), N m or N, with C from the Christoffel symbols and without forming it. Also: the control of Slotine and Li.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s; `qd_r`: reference velocities, rad per s; `qdd_r`: reference accelerations, rad per s^2.
    ///
    /// Operations: 12 multiplications, 11 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn passivity_torque<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd_r: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qdd_r: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 2> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::PassivityTorque,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::PassivityTorque,
            &::robot_dynamics::Evaluated,
            &(*q, *qd, *qd_r, *qdd_r),
        );
        all_values
    }
    /// Regressor Y_r(q, qd, qd_r, qdd_r), N x P, of the P base inertial parameters: Y_r * base_parameters = M qdd_r + C qd_r + G, the `passivity_torque` without springs and friction, from which adaptive control learns (Slotine and Li).
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s; `qd_r`: reference velocities, rad per s; `qdd_r`: reference accelerations, rad per s^2.
    ///
    /// The base parameters:
    ///
    /// ```text
    ///   1  J1zz + a1^2 m2
    ///   2  h1x + a1 m2
    ///   3  h1y
    ///   4  J2zz
    ///   5  h2x
    ///   6  h2y
    /// ```
    ///
    /// Jixx to Jizz (kg m^2) are the entries of link i's inertia tensor about the origin of frame i, hix to hiz (kg m) its first moments mass * com from there, mi (kg) its mass. Frame i is the link frame i of the table before its factors Tx(a) Rx(alpha): its origin and its z axis are on the axis of joint i. ai, di are cells of row i, sai, cai sine and cosine of its alpha.
    ///
    /// Operations: 16 multiplications, 11 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn passivity_regressor<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd_r: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qdd_r: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 2, 6> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::PassivityRegressor,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::PassivityRegressor,
            &::robot_dynamics::Evaluated,
            &(*q, *qd, *qd_r, *qdd_r),
        );
        all_values
    }
    /// Regressors of the energies, two vectors of P numbers, J for a unit of each of the P base inertial parameters: the kinetic energy is the first one times base_parameters, the potential energy of gravity the second one up to a constant.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s.
    ///
    /// The base parameters:
    ///
    /// ```text
    ///   1  J1zz + a1^2 m2
    ///   2  h1x + a1 m2
    ///   3  h1y
    ///   4  J2zz
    ///   5  h2x
    ///   6  h2y
    /// ```
    ///
    /// Jixx to Jizz (kg m^2) are the entries of link i's inertia tensor about the origin of frame i, hix to hiz (kg m) its first moments mass * com from there, mi (kg) its mass. Frame i is the link frame i of the table before its factors Tx(a) Rx(alpha): its origin and its z axis are on the axis of joint i. ai, di are cells of row i, sai, cai sine and cosine of its alpha.
    ///
    /// Operations: 14 multiplications, 3 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn energy_regressors<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> (
        ::robot_dynamics::nalgebra::SVector<T, 6>,
        ::robot_dynamics::nalgebra::SVector<T, 6>,
    ) {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::EnergyRegressors,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::EnergyRegressors,
            &::robot_dynamics::Evaluated,
            &(*q, *qd),
        );
        all_values
    }
    /// First and second derivative by time of the inverse dynamics along a motion, (d tau/dt, d2 tau/dt2), N m/s and N m/s^2 (N/s and N/s^2). Viscous friction counts; Coulomb friction counts as constant.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s; `qdd`: joint accelerations, rad per s^2; `jerk`: rates of the accelerations, rad per s^3; `snap`: rates of `jerk`, rad per s^4.
    ///
    /// Operations: 57 multiplications, 40 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn inverse_dynamics_rates<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qdd: &::robot_dynamics::nalgebra::SVector<T, 2>,
        jerk: &::robot_dynamics::nalgebra::SVector<T, 2>,
        snap: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> (
        ::robot_dynamics::nalgebra::SVector<T, 2>,
        ::robot_dynamics::nalgebra::SVector<T, 2>,
    ) {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::InverseDynamicsRates,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::InverseDynamicsRates,
            &::robot_dynamics::Evaluated,
            &(*q, *qd, *qdd, *jerk, *snap),
        );
        all_values
    }
    /// Second derivatives of the inverse dynamics, exact: (d2 tau/dq dq, d2 tau/dqd dqd, d2 tau/dq dqd, dM/dq), each an array of N matrices N x N. Entry `[i][(j, k)]` is that of tau_i by q_j and q_k, by qd_j and qd_k, by q_j (row) and qd_k (column), and the derivative of M_ij by q_k, which is that of tau_i by qdd_j and q_k. The first two are symmetric in j and k, the last one in i and j. Friction that falls with the velocity is in d2 tau/dqd dqd; that of other friction and of springs is zero.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s; `qdd`: joint accelerations, rad per s^2.
    ///
    /// Operations: 17 multiplications, 10 additions, sines and cosines of 2 angles.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn inverse_dynamics_second_derivatives<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qdd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> (
        [::robot_dynamics::nalgebra::SMatrix<T, 2, 2>; 2],
        [::robot_dynamics::nalgebra::SMatrix<T, 2, 2>; 2],
        [::robot_dynamics::nalgebra::SMatrix<T, 2, 2>; 2],
        [::robot_dynamics::nalgebra::SMatrix<T, 2, 2>; 2],
    ) {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::InverseDynamicsSecondDerivatives,
            2,
        >>::at(
            self,
            ::robot_dynamics::functions::InverseDynamicsSecondDerivatives,
            &::robot_dynamics::Evaluated,
            &(*q, *qd, *qdd),
        );
        all_values
    }
}
impl ::robot_dynamics::MassMatrix<2> for Arm {
    const WORK: u32 = 43;
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
        let t_1_ = c_2_ + c_2_;
        let t_2_ = real(8.333333333333334) + t_1_;
        let t_3_ = real(0.3333333333333333) + c_2_;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([
                [t_2_, t_3_],
                [t_3_, real(0.3333333333333333)],
            ]),
        )
    }
}
impl ::robot_dynamics::CoriolisVector<2> for Arm {
    const WORK: u32 = 46;
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
        let [(s_2_, _)] = ::robot_dynamics::Inputs::sin_cos_parts(
            sines,
            [1],
            [::robot_dynamics::Part::Sine],
            [q.data.0[0][1]],
        );
        let qd_1_ = qd.data.0[0][0];
        let qd_2_ = qd.data.0[0][1];
        let t_1_ = qd_1_ * qd_1_;
        let t_2_ = s_2_ * t_1_;
        let t_3_ = qd_1_ + qd_2_;
        let t_4_ = t_3_ * t_3_;
        let t_5_ = (-s_2_).mul_add(t_4_, t_2_);
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t_5_, t_2_]]),
        )
    }
}
impl ::robot_dynamics::GravityVector<2> for Arm {
    const WORK: u32 = 86;
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
        let t_1_ = (-s_1_).mul_add(s_2_, c_1_ * c_2_);
        let t_2_ = real(4.905) * t_1_;
        let t_3_ = real(49.05).mul_add(c_1_, t_2_);
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t_3_, t_2_]]),
        )
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::FrictionVector, 2> for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>,);
    type Values = ::robot_dynamics::Entries<2, 1>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["qd"];
    const RESULT: &'static str = "friction_vector";
    const WORK: u32 = 0;
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
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[real(0.0), real(0.0)]]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::SpringVector, 2> for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>,);
    type Values = ::robot_dynamics::Entries<2, 1>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q"];
    const RESULT: &'static str = "spring_vector";
    const WORK: u32 = 0;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::SpringVector,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (q,): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
    ) -> ::core::result::Result<
        <Self::Values as ::robot_dynamics::Arrangement>::Of<T>,
        Self::Error,
    > {
        ::core::result::Result::Ok({
            let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[real(0.0), real(0.0)]]),
            )
        })
    }
}
impl ::robot_dynamics::InverseDynamics<2> for Arm {
    const WORK: u32 = 101;
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
        let qd_1_ = qd.data.0[0][0];
        let qd_2_ = qd.data.0[0][1];
        let qdd_1_ = qdd.data.0[0][0];
        let qdd_2_ = qdd.data.0[0][1];
        let t_1_ = qd_1_ + qd_2_;
        let t_2_ = t_1_ * t_1_;
        let t_3_ = qdd_1_ + qdd_2_;
        let t_4_ = real(-4.905).mul_add(s_1_, qd_1_ * qd_1_);
        let t_5_ = real(4.905).mul_add(c_1_, qdd_1_);
        let t_6_ = s_2_.mul_add(t_4_, real(0.3333333333333333) * t_3_);
        let t_7_ = c_2_.mul_add(t_5_, t_6_);
        let t_8_ = real(49.05).mul_add(c_1_, real(8.0) * qdd_1_);
        let t_9_ = (-s_2_).mul_add(t_2_, c_2_ * t_3_);
        let t_10_ = t_8_ + t_9_;
        let t_11_ = t_10_ + t_7_;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t_11_, t_7_]]),
        )
    }
}
impl ::robot_dynamics::ForwardDynamics<2> for Arm {
    const WORK: u32 = 108;
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
        let qd_1_ = qd.data.0[0][0];
        let qd_2_ = qd.data.0[0][1];
        let tau_1_ = tau.data.0[0][0];
        let tau_2_ = tau.data.0[0][1];
        let t_1_ = qd_1_ + qd_2_;
        let t_2_ = t_1_ * t_1_;
        let t_3_ = qd_1_ * qd_1_;
        let t_4_ = real(0.2038735983690112).mul_add(t_3_, -s_1_);
        let t_5_ = s_2_.mul_add(t_4_, c_1_ * c_2_);
        let t_6_ = real(4.905) * t_5_;
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
        ::robot_dynamics::SingularMassMatrix::test_joint(
            1,
            "joint2",
            real(0.3333333333333333),
            real(0.3333333333333333),
        )?;
        ::robot_dynamics::SingularMassMatrix::test_joint(0, "joint1", t_15_, t_14_)?;
        ::core::result::Result::Ok(
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[-t_17_, t_18_]]),
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
    const WORK: u32 = 49;
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
            let qd_1_ = qd.data.0[0][0];
            let qd_2_ = qd.data.0[0][1];
            let t_1_ = qd_1_ + qd_2_;
            let t_2_ = qd_1_ * c_2_;
            let t_3_ = t_1_ * t_1_;
            let t_4_ = real(0.041666666666666664).mul_add(t_3_, qd_1_ * qd_1_);
            let t_5_ = t_1_.mul_add(t_2_, real(4.0) * t_4_);
            t_5_
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
    const WORK: u32 = 85;
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
            let t_1_ = real(10.0) + c_2_;
            let t_2_ = s_1_.mul_add(t_1_, c_1_ * s_2_);
            let t_3_ = real(4.905) * t_2_;
            t_3_
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::BiasForce, 2> for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>, ::robot_dynamics::Entries<2, 1>);
    type Values = ::robot_dynamics::Entries<2, 1>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd"];
    const RESULT: &'static str = "bias_force";
    const WORK: u32 = 93;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::BiasForce,
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
            let t_1_ = qd_1_ + qd_2_;
            let t_2_ = t_1_ * t_1_;
            let t_3_ = qd_1_ * qd_1_;
            let t_4_ = real(0.2038735983690112).mul_add(t_3_, -s_1_);
            let t_5_ = s_2_.mul_add(t_4_, c_1_ * c_2_);
            let t_6_ = real(4.905) * t_5_;
            let t_7_ = (-s_2_).mul_add(t_2_, real(49.05) * c_1_);
            let t_8_ = t_7_ + t_6_;
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[t_8_, t_6_]]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::CoriolisMatrix, 2> for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>, ::robot_dynamics::Entries<2, 1>);
    type Values = ::robot_dynamics::Entries<2, 2>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd"];
    const RESULT: &'static str = "coriolis_matrix";
    const WORK: u32 = 43;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::CoriolisMatrix,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (q, qd): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
    ) -> ::core::result::Result<
        <Self::Values as ::robot_dynamics::Arrangement>::Of<T>,
        Self::Error,
    > {
        ::core::result::Result::Ok({
            let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
            let [(s_2_, _)] = ::robot_dynamics::Inputs::sin_cos_parts(
                sines,
                [1],
                [::robot_dynamics::Part::Sine],
                [q.data.0[0][1]],
            );
            let qd_1_ = qd.data.0[0][0];
            let qd_2_ = qd.data.0[0][1];
            let t_1_ = s_2_ * qd_2_;
            let t_2_ = qd_1_ * s_2_;
            let t_3_ = t_1_ + t_2_;
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [-t_1_, t_2_],
                    [-t_3_, real(0.0)],
                ]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::CoriolisCoefficients, 2>
for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>,);
    type Values = ::robot_dynamics::Entries<2, 1>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q"];
    const RESULT: &'static str = "coriolis_coefficients";
    const WORK: u32 = 41;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::CoriolisCoefficients,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (q,): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
    ) -> ::core::result::Result<
        <Self::Values as ::robot_dynamics::Arrangement>::Of<T>,
        Self::Error,
    > {
        ::core::result::Result::Ok({
            let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
            let [(s_2_, _)] = ::robot_dynamics::Inputs::sin_cos_parts(
                sines,
                [1],
                [::robot_dynamics::Part::Sine],
                [q.data.0[0][1]],
            );
            let t_1_ = real(2.0) * s_2_;
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[-t_1_, real(0.0)]]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::CentrifugalCoefficients, 2>
for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>,);
    type Values = ::robot_dynamics::Entries<2, 2>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q"];
    const RESULT: &'static str = "centrifugal_coefficients";
    const WORK: u32 = 40;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::CentrifugalCoefficients,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (q,): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
    ) -> ::core::result::Result<
        <Self::Values as ::robot_dynamics::Arrangement>::Of<T>,
        Self::Error,
    > {
        ::core::result::Result::Ok({
            let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
            let [(s_2_, _)] = ::robot_dynamics::Inputs::sin_cos_parts(
                sines,
                [1],
                [::robot_dynamics::Part::Sine],
                [q.data.0[0][1]],
            );
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [real(0.0), s_2_],
                    [-s_2_, real(0.0)],
                ]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::ForwardKinematics, 2>
for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>,);
    type Values = ::robot_dynamics::Entries<4, 4>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q"];
    const RESULT: &'static str = "forward_kinematics";
    const WORK: u32 = 90;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::ForwardKinematics,
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
            let t_1_ = (-s_1_).mul_add(s_2_, c_1_ * c_2_);
            let t_2_ = c_1_.mul_add(s_2_, s_1_ * c_2_);
            let t_3_ = real(2.0).mul_add(c_1_, t_1_);
            let t_4_ = real(2.0).mul_add(s_1_, t_2_);
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [t_1_, t_2_, real(0.0), real(0.0)],
                    [-t_2_, t_1_, real(0.0), real(0.0)],
                    [real(0.0), real(0.0), real(1.0), real(0.0)],
                    [t_3_, t_4_, real(0.0), real(1.0)],
                ]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::LinkPoses, 2> for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>,);
    type Values = [::robot_dynamics::Entries<4, 4>; 2];
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q"];
    const RESULT: &'static str = "link_poses";
    const WORK: u32 = 90;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::LinkPoses,
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
            let t_1_ = real(2.0) * c_1_;
            let t_2_ = real(2.0) * s_1_;
            let t_3_ = (-s_1_).mul_add(s_2_, c_1_ * c_2_);
            let t_4_ = c_1_.mul_add(s_2_, s_1_ * c_2_);
            let t_5_ = t_1_ + t_3_;
            let t_6_ = t_2_ + t_4_;
            [
                ::robot_dynamics::nalgebra::SMatrix::from_data(
                    ::robot_dynamics::nalgebra::ArrayStorage([
                        [c_1_, s_1_, real(0.0), real(0.0)],
                        [-s_1_, c_1_, real(0.0), real(0.0)],
                        [real(0.0), real(0.0), real(1.0), real(0.0)],
                        [t_1_, t_2_, real(0.0), real(1.0)],
                    ]),
                ),
                ::robot_dynamics::nalgebra::SMatrix::from_data(
                    ::robot_dynamics::nalgebra::ArrayStorage([
                        [t_3_, t_4_, real(0.0), real(0.0)],
                        [-t_4_, t_3_, real(0.0), real(0.0)],
                        [real(0.0), real(0.0), real(1.0), real(0.0)],
                        [t_5_, t_6_, real(0.0), real(1.0)],
                    ]),
                ),
            ]
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::Jacobian, 2> for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>,);
    type Values = ::robot_dynamics::Entries<6, 2>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q"];
    const RESULT: &'static str = "jacobian";
    const WORK: u32 = 90;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::Jacobian,
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
            let t_1_ = c_1_.mul_add(s_2_, s_1_ * c_2_);
            let t_2_ = real(2.0).mul_add(s_1_, t_1_);
            let t_3_ = (-s_1_).mul_add(s_2_, c_1_ * c_2_);
            let t_4_ = real(2.0).mul_add(c_1_, t_3_);
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [-t_2_, t_4_, real(0.0), real(0.0), real(0.0), real(1.0)],
                    [-t_1_, t_3_, real(0.0), real(0.0), real(0.0), real(1.0)],
                ]),
            )
        })
    }
}
impl ::robot_dynamics::Function<
    ::robot_dynamics::functions::InverseDynamicsDerivatives,
    2,
> for Arm {
    type Arguments = (
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
    );
    type Values = (::robot_dynamics::Entries<2, 2>, ::robot_dynamics::Entries<2, 2>);
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd", "qdd"];
    const RESULT: &'static str = "inverse_dynamics_derivatives";
    const WORK: u32 = 106;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::InverseDynamicsDerivatives,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (q, qd, qdd): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
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
            let qdd_1_ = qdd.data.0[0][0];
            let qdd_2_ = qdd.data.0[0][1];
            let t_1_ = real(4.905) * c_1_;
            let t_2_ = real(0.5) * c_2_;
            let t_3_ = real(9.81) * s_1_;
            let t_4_ = t_2_.mul_add(t_3_, s_2_ * t_1_);
            let t_5_ = real(5.0).mul_add(t_3_, t_4_);
            let t_6_ = real(2.0) * qd_1_;
            let t_7_ = (-qd_1_).mul_add(t_6_, t_3_);
            let t_8_ = qdd_1_ + t_1_;
            let t_9_ = t_2_.mul_add(t_7_, s_2_ * t_8_);
            let t_10_ = qdd_1_ + qdd_2_;
            let t_11_ = qd_1_ + qd_2_;
            let t_12_ = t_11_ * t_11_;
            let t_13_ = c_2_.mul_add(t_12_, s_2_ * t_10_);
            let t_14_ = t_13_ + t_9_;
            let t_15_ = s_2_ * t_6_;
            let t_16_ = s_2_ * t_11_;
            let t_17_ = real(2.0) * t_16_;
            let t_18_ = t_15_ - t_17_;
            (
                ::robot_dynamics::nalgebra::SMatrix::from_data(
                    ::robot_dynamics::nalgebra::ArrayStorage([
                        [-t_5_, -t_4_],
                        [-t_14_, -t_9_],
                    ]),
                ),
                ::robot_dynamics::nalgebra::SMatrix::from_data(
                    ::robot_dynamics::nalgebra::ArrayStorage([
                        [t_18_, t_15_],
                        [-t_17_, real(0.0)],
                    ]),
                ),
            )
        })
    }
}
impl ::robot_dynamics::Function<
    ::robot_dynamics::functions::ForwardDynamicsDerivatives,
    2,
> for Arm {
    type Arguments = (
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
    );
    type Values = (
        ::robot_dynamics::Entries<2, 2>,
        ::robot_dynamics::Entries<2, 2>,
        ::robot_dynamics::Entries<2, 2>,
    );
    type Error = ::robot_dynamics::SingularMassMatrix;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd", "tau"];
    const RESULT: &'static str = "forward_dynamics_derivatives";
    const WORK: u32 = 150;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::ForwardDynamicsDerivatives,
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
        let t_1_ = real(2.0).mul_add(c_2_, real(8.333333333333334));
        let t_2_ = real(0.3333333333333333) + c_2_;
        let t_3_ = real(3.0) * t_2_;
        let t_4_ = (-t_2_).mul_add(t_3_, t_1_);
        let t_5_ = real(1.0) / t_4_;
        let t_6_ = real(4.905) * c_1_;
        let t_7_ = real(4.905) * s_1_;
        let t_8_ = c_2_.mul_add(t_7_, s_2_ * t_6_);
        let t_9_ = real(49.05).mul_add(s_1_, t_8_);
        let t_10_ = t_3_.mul_add(t_8_, -t_9_);
        let t_11_ = t_5_ * t_10_;
        let t_12_ = qd_1_.mul_add(qd_1_, -t_7_);
        let t_13_ = qd_1_ + qd_2_;
        let t_14_ = t_13_ * t_13_;
        let t_15_ = s_2_.mul_add(t_12_, c_2_ * t_6_);
        let t_16_ = t_15_ - tau_2_;
        let t_17_ = real(49.05).mul_add(c_1_, -tau_1_);
        let t_18_ = (-s_2_).mul_add(t_14_, t_17_);
        let t_19_ = t_18_ + t_15_;
        let t_20_ = (-t_16_).mul_add(t_3_, t_19_);
        let t_21_ = t_20_ * t_5_;
        let t_22_ = t_6_ - t_21_;
        let t_23_ = (-c_2_).mul_add(t_12_, s_2_ * t_22_);
        let t_24_ = real(3.0).mul_add(t_16_, t_21_);
        let t_25_ = (-t_3_).mul_add(t_21_, t_24_);
        let t_26_ = c_2_.mul_add(t_14_, t_23_);
        let t_27_ = s_2_.mul_add(t_25_, t_3_ * t_23_);
        let t_28_ = t_26_ - t_27_;
        let t_29_ = t_5_ * t_28_;
        let t_30_ = t_3_.mul_add(t_11_, real(3.0) * t_8_);
        let t_31_ = (-t_3_).mul_add(t_29_, real(3.0) * t_23_);
        let t_32_ = real(2.0) * qd_1_;
        let t_33_ = s_2_ * t_32_;
        let t_34_ = s_2_ * t_13_;
        let t_35_ = real(2.0) * t_34_;
        let t_36_ = t_3_.mul_add(t_33_, -t_33_);
        let t_37_ = t_35_ + t_36_;
        let t_38_ = t_5_ * t_37_;
        let t_39_ = t_5_ * t_35_;
        let t_40_ = t_3_.mul_add(t_38_, real(3.0) * t_33_);
        let t_41_ = t_3_ * t_39_;
        let t_42_ = t_3_ * t_5_;
        let t_43_ = t_3_.mul_add(t_42_, real(3.0));
        ::robot_dynamics::SingularMassMatrix::test_joint(
            1,
            "joint2",
            real(0.3333333333333333),
            real(0.3333333333333333),
        )?;
        ::robot_dynamics::SingularMassMatrix::test_joint(0, "joint1", t_4_, t_1_)?;
        ::core::result::Result::Ok((
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [-t_11_, t_30_],
                    [t_29_, t_31_],
                ]),
            ),
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [t_38_, -t_40_],
                    [t_39_, -t_41_],
                ]),
            ),
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [t_5_, -t_42_],
                    [-t_42_, t_43_],
                ]),
            ),
        ))
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::Regressor, 2> for Arm {
    type Arguments = (
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
    );
    type Values = ::robot_dynamics::Entries<2, 6>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd", "qdd"];
    const RESULT: &'static str = "regressor";
    const WORK: u32 = 106;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::Regressor,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (q, qd, qdd): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
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
            let qdd_1_ = qdd.data.0[0][0];
            let qdd_2_ = qdd.data.0[0][1];
            let t_1_ = real(9.81) * c_1_;
            let t_2_ = real(-9.81) * s_1_;
            let t_3_ = qdd_1_ + qdd_2_;
            let t_4_ = real(2.0).mul_add(qdd_1_, t_1_);
            let t_5_ = qd_1_ * qd_1_;
            let t_6_ = real(2.0).mul_add(t_5_, t_2_);
            let t_7_ = s_2_.mul_add(t_6_, c_2_ * t_4_);
            let t_8_ = qd_1_ + qd_2_;
            let t_9_ = t_8_ * t_8_;
            let t_10_ = (-c_2_).mul_add(t_3_, s_2_ * t_9_);
            let t_11_ = real(-2.0).mul_add(t_10_, t_7_);
            let t_12_ = (-s_2_).mul_add(t_4_, c_2_ * t_6_);
            let t_13_ = s_2_.mul_add(t_3_, c_2_ * t_9_);
            let t_14_ = real(-2.0).mul_add(t_13_, t_12_);
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [qdd_1_, real(0.0)],
                    [t_1_, real(0.0)],
                    [t_2_, real(0.0)],
                    [t_3_, t_3_],
                    [t_11_, t_7_],
                    [t_14_, t_12_],
                ]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::BaseParameters, 2> for Arm {
    type Arguments = ();
    type Values = ::robot_dynamics::Entries<6, 1>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &[];
    const RESULT: &'static str = "base_parameters";
    const WORK: u32 = 0;
    const IN_LANES: bool = false;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::BaseParameters,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
    ) -> ::core::result::Result<
        <Self::Values as ::robot_dynamics::Arrangement>::Of<T>,
        Self::Error,
    > {
        ::core::result::Result::Ok({
            let real = <T as ::robot_dynamics::Scalar>::from_f64;
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [
                        real(8.0),
                        real(5.0),
                        real(0.0),
                        real(0.3333333333333333),
                        real(0.5),
                        real(0.0),
                    ],
                ]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::ForwardDynamicsAba, 2>
for Arm {
    type Arguments = (
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
    );
    type Values = ::robot_dynamics::Entries<2, 1>;
    type Error = ::robot_dynamics::SingularMassMatrix;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd", "tau"];
    const RESULT: &'static str = "qdd";
    const WORK: u32 = 130;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::ForwardDynamicsAba,
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
        let t_1_ = s_2_ * c_2_;
        let t_2_ = real(0.75) * t_1_;
        let t_3_ = t_2_ + t_2_;
        let t_4_ = c_2_ * c_2_;
        let t_5_ = real(0.25).mul_add(t_4_, s_2_ * s_2_);
        let t_6_ = real(4.0).mul_add(t_5_, real(4.0));
        let t_7_ = real(1.0) / t_6_;
        let t_8_ = t_3_ * t_7_;
        let t_9_ = real(9.81) * s_1_;
        let t_10_ = real(2.0).mul_add(t_5_, real(3.0));
        let t_11_ = t_10_ * t_7_;
        let t_12_ = real(9.81) * c_1_;
        let t_13_ = qd_1_ * qd_1_;
        let t_14_ = real(2.0) * t_13_;
        let t_15_ = qd_1_ + qd_2_;
        let t_16_ = t_15_ * t_15_;
        let t_17_ = c_2_.mul_add(t_14_, real(0.5) * t_16_);
        let t_18_ = s_2_ * t_14_;
        let t_19_ = real(0.25).mul_add(t_18_, real(1.5) * tau_2_);
        let t_20_ = (-c_2_).mul_add(t_19_, s_2_ * t_17_);
        let t_21_ = tau_1_ - tau_2_;
        let t_22_ = real(2.0).mul_add(t_20_, t_21_);
        let t_23_ = (-t_8_).mul_add(t_9_, t_22_ * t_7_);
        let t_24_ = (-t_11_).mul_add(t_12_, t_23_);
        let t_25_ = real(2.0).mul_add(t_24_, t_12_);
        let t_26_ = (-s_2_).mul_add(t_9_, t_18_);
        let t_27_ = c_2_.mul_add(t_25_, t_26_);
        let t_28_ = real(-3.0).mul_add(tau_2_, t_24_);
        let t_29_ = real(1.5).mul_add(t_27_, t_28_);
        let t_30_ = c_2_ + c_2_;
        let t_31_ = real(8.333333333333334) + t_30_;
        ::robot_dynamics::SingularMassMatrix::test_joint(
            1,
            "joint2",
            real(0.3333333333333333),
            real(0.3333333333333333),
        )?;
        ::robot_dynamics::SingularMassMatrix::test_joint(0, "joint1", t_6_, t_31_)?;
        ::core::result::Result::Ok(
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[t_24_, -t_29_]]),
            ),
        )
    }
}
impl ::robot_dynamics::TaylorDynamics<2> for Arm {
    type Products<T: ::robot_dynamics::Scalar> = ::robot_dynamics::ProductTable<
        T,
        0,
        2,
        0,
    >;
    #[inline(always)]
    fn series_term<T: ::robot_dynamics::Scalar>(
        &self,
        term: &mut impl ::robot_dynamics::SeriesTerm<T, 2>,
    ) {
        let real = {
            let a_number = ::robot_dynamics::SeriesTerm::like(term);
            move |x: f64| ::robot_dynamics::Scalar::constant(a_number, x)
        };
        let c_1_ = ::robot_dynamics::SeriesTerm::cosine(term, 0);
        let s_1_ = ::robot_dynamics::SeriesTerm::sine(term, 0);
        let s_2_ = ::robot_dynamics::SeriesTerm::sine(term, 1);
        let c_2_ = ::robot_dynamics::SeriesTerm::cosine(term, 1);
        let qd_1_ = ::robot_dynamics::SeriesTerm::velocity(term, 0);
        let qd_2_ = ::robot_dynamics::SeriesTerm::velocity(term, 1);
        ::robot_dynamics::SeriesTerm::turn(term, 0, 6);
        ::robot_dynamics::SeriesTerm::turn(term, 1, 8);
        let t_1_ = qd_1_ + qd_2_;
        let t_2_ = ::robot_dynamics::SeriesTerm::product(term, 0, t_1_, t_1_);
        let t_4_ = ::robot_dynamics::SeriesTerm::product(term, 1, qd_1_, qd_1_);
        let t_6_ = (-real(4.905)).mul_add(s_1_, t_4_);
        let t_10_ = ::robot_dynamics::SeriesTerm::product(term, 2, s_2_, t_6_);
        let t_17_ = ::robot_dynamics::SeriesTerm::product(term, 4, s_2_, t_2_);
        let forces = {
            let qdd_1_ = ::robot_dynamics::SeriesTerm::acceleration(term, 0);
            let qdd_2_ = ::robot_dynamics::SeriesTerm::acceleration(term, 1);
            let t_3_ = qdd_1_ + qdd_2_;
            let t_8_ = real(4.905).mul_add(c_1_, qdd_1_);
            let t_11_ = real(0.3333333333333333).mul_add(t_3_, t_10_);
            let t_12_ = ::robot_dynamics::SeriesTerm::trial(term, 3, c_2_, t_8_);
            let t_13_ = t_12_ + t_11_;
            let t_16_ = real(49.05).mul_add(c_1_, real(8.0) * qdd_1_);
            let t_18_ = ::robot_dynamics::SeriesTerm::trial(term, 5, c_2_, t_3_);
            let t_19_ = t_18_ - t_17_;
            let t_20_ = t_16_ + t_19_;
            let t_21_ = t_20_ + t_13_;
            [t_21_, t_13_]
        };
        ::robot_dynamics::SeriesTerm::solve(term, forces);
        let qdd_1_ = ::robot_dynamics::SeriesTerm::acceleration(term, 0);
        let qdd_2_ = ::robot_dynamics::SeriesTerm::acceleration(term, 1);
        let t_3_ = qdd_1_ + qdd_2_;
        let t_8_ = real(4.905).mul_add(c_1_, qdd_1_);
        let t_12_ = ::robot_dynamics::SeriesTerm::product(term, 3, c_2_, t_8_);
        let t_18_ = ::robot_dynamics::SeriesTerm::product(term, 5, c_2_, t_3_);
    }
    #[inline(always)]
    fn leading_matrix<T: ::robot_dynamics::Scalar>(
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
        let t_1_ = c_2_ + c_2_;
        let t_2_ = real(8.333333333333334) + t_1_;
        let t_3_ = real(0.3333333333333333) + c_2_;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([
                [t_2_, t_3_],
                [t_3_, real(0.3333333333333333)],
            ]),
        )
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::WrenchTorques, 2> for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>, ::robot_dynamics::Entries<6, 1>);
    type Values = ::robot_dynamics::Entries<2, 1>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "wrench"];
    const RESULT: &'static str = "wrench_torques";
    const WORK: u32 = 92;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::WrenchTorques,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (q, wrench): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
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
            let wrench_1_ = wrench.data.0[0][0];
            let wrench_2_ = wrench.data.0[0][1];
            let wrench_6_ = wrench.data.0[0][5];
            let t_1_ = (-c_1_).mul_add(wrench_2_, s_1_ * wrench_1_);
            let t_2_ = s_1_.mul_add(wrench_2_, c_1_ * wrench_1_);
            let t_3_ = (-c_2_).mul_add(t_1_, wrench_6_);
            let t_4_ = (-s_2_).mul_add(t_2_, t_3_);
            let t_5_ = real(-2.0).mul_add(t_1_, t_4_);
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[t_5_, t_4_]]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::ToolVelocity, 2> for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>, ::robot_dynamics::Entries<2, 1>);
    type Values = ::robot_dynamics::Entries<6, 1>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd"];
    const RESULT: &'static str = "tool_velocity";
    const WORK: u32 = 92;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::ToolVelocity,
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
            let t_1_ = qd_1_ + qd_2_;
            let t_2_ = s_2_ * t_1_;
            let t_3_ = real(2.0) + c_2_;
            let t_4_ = qd_1_.mul_add(t_3_, c_2_ * qd_2_);
            let t_5_ = s_1_.mul_add(t_4_, c_1_ * t_2_);
            let t_6_ = (-s_1_).mul_add(t_2_, c_1_ * t_4_);
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [-t_5_, t_6_, real(0.0), real(0.0), real(0.0), t_1_],
                ]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::ToolAcceleration, 2>
for Arm {
    type Arguments = (
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
    );
    type Values = ::robot_dynamics::Entries<6, 1>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd", "qdd"];
    const RESULT: &'static str = "tool_acceleration";
    const WORK: u32 = 108;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::ToolAcceleration,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (q, qd, qdd): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
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
            let qdd_1_ = qdd.data.0[0][0];
            let qdd_2_ = qdd.data.0[0][1];
            let t_1_ = real(2.0) + c_2_;
            let t_2_ = c_2_ * qd_2_;
            let t_3_ = real(2.0).mul_add(t_2_, qd_1_ * t_1_);
            let t_4_ = qdd_1_ + qdd_2_;
            let t_5_ = qd_2_.mul_add(t_2_, s_2_ * t_4_);
            let t_6_ = qd_1_.mul_add(t_3_, t_5_);
            let t_7_ = s_2_ * qd_2_;
            let t_8_ = real(2.0).mul_add(t_7_, qd_1_ * s_2_);
            let t_9_ = (-c_2_).mul_add(qdd_2_, qd_2_ * t_7_);
            let t_10_ = (-qdd_1_).mul_add(t_1_, t_9_);
            let t_11_ = qd_1_.mul_add(t_8_, t_10_);
            let t_12_ = (-c_1_).mul_add(t_6_, s_1_ * t_11_);
            let t_13_ = c_1_.mul_add(t_11_, s_1_ * t_6_);
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [t_12_, -t_13_, real(0.0), real(0.0), real(0.0), t_4_],
                ]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::JacobianRate, 2> for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>, ::robot_dynamics::Entries<2, 1>);
    type Values = ::robot_dynamics::Entries<6, 2>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd"];
    const RESULT: &'static str = "jacobian_rate";
    const WORK: u32 = 95;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::JacobianRate,
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
            let t_1_ = (-s_1_).mul_add(s_2_, c_1_ * c_2_);
            let t_2_ = qd_2_ + qd_1_;
            let t_3_ = t_1_ * t_2_;
            let t_4_ = real(2.0) * c_1_;
            let t_5_ = t_4_.mul_add(qd_1_, t_3_);
            let t_6_ = c_1_.mul_add(s_2_, s_1_ * c_2_);
            let t_7_ = t_2_ * t_6_;
            let t_8_ = real(2.0) * s_1_;
            let t_9_ = t_8_.mul_add(qd_1_, t_7_);
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [-t_5_, -t_9_, real(0.0), real(0.0), real(0.0), real(0.0)],
                    [-t_3_, -t_7_, real(0.0), real(0.0), real(0.0), real(0.0)],
                ]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::LinkJacobians, 2> for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>,);
    type Values = [::robot_dynamics::Entries<6, 2>; 2];
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q"];
    const RESULT: &'static str = "link_jacobians";
    const WORK: u32 = 90;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::LinkJacobians,
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
            let t_1_ = real(-2.0) * s_1_;
            let t_2_ = real(2.0) * c_1_;
            let t_3_ = c_1_.mul_add(s_2_, s_1_ * c_2_);
            let t_4_ = t_1_ - t_3_;
            let t_5_ = (-s_1_).mul_add(s_2_, c_1_ * c_2_);
            let t_6_ = t_2_ + t_5_;
            [
                ::robot_dynamics::nalgebra::SMatrix::from_data(
                    ::robot_dynamics::nalgebra::ArrayStorage([
                        [t_1_, t_2_, real(0.0), real(0.0), real(0.0), real(1.0)],
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
                        [t_4_, t_6_, real(0.0), real(0.0), real(0.0), real(1.0)],
                        [-t_3_, t_5_, real(0.0), real(0.0), real(0.0), real(1.0)],
                    ]),
                ),
            ]
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::CenterOfMass, 2> for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>,);
    type Values = ::robot_dynamics::Entries<3, 1>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q"];
    const RESULT: &'static str = "center_of_mass";
    const WORK: u32 = 89;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::CenterOfMass,
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
            let t_1_ = real(0.125).mul_add(c_2_, real(1.25));
            let t_2_ = real(0.125) * s_2_;
            let t_3_ = (-s_1_).mul_add(t_2_, c_1_ * t_1_);
            let t_4_ = s_1_.mul_add(t_1_, c_1_ * t_2_);
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[t_3_, t_4_, real(0.0)]]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::CenterOfMassJacobian, 2>
for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>,);
    type Values = ::robot_dynamics::Entries<3, 2>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q"];
    const RESULT: &'static str = "center_of_mass_jacobian";
    const WORK: u32 = 92;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::CenterOfMassJacobian,
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
            let t_1_ = c_1_.mul_add(s_2_, s_1_ * c_2_);
            let t_2_ = real(0.125) * t_1_;
            let t_3_ = real(1.25).mul_add(s_1_, t_2_);
            let t_4_ = (-s_1_).mul_add(s_2_, c_1_ * c_2_);
            let t_5_ = real(0.125) * t_4_;
            let t_6_ = real(1.25).mul_add(c_1_, t_5_);
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [-t_3_, t_6_, real(0.0)],
                    [-t_2_, t_5_, real(0.0)],
                ]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::CentroidalMomentumMatrix, 2>
for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>,);
    type Values = ::robot_dynamics::Entries<6, 2>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q"];
    const RESULT: &'static str = "centroidal_momentum_matrix";
    const WORK: u32 = 109;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::CentroidalMomentumMatrix,
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
            let t_1_ = real(0.5) * c_2_;
            let t_2_ = real(5.0) + t_1_;
            let t_3_ = real(0.5) * s_2_;
            let t_4_ = c_1_ * t_3_;
            let t_5_ = s_1_.mul_add(t_2_, t_4_);
            let t_6_ = s_1_.mul_add(t_1_, t_4_);
            let t_7_ = s_1_ * t_3_;
            let t_8_ = c_1_.mul_add(t_2_, -t_7_);
            let t_9_ = c_1_.mul_add(t_1_, -t_7_);
            let t_10_ = c_2_ + c_2_;
            let t_11_ = real(0.25) * t_8_;
            let t_12_ = real(0.25) * t_5_;
            let t_13_ = real(8.333333333333334) + t_10_;
            let t_14_ = (-t_8_).mul_add(t_11_, t_13_);
            let t_15_ = (-t_5_).mul_add(t_12_, t_14_);
            let t_16_ = real(-2.0).mul_add(c_1_, t_11_);
            let t_17_ = real(2.0).mul_add(s_1_, -t_12_);
            let t_18_ = (-t_9_).mul_add(t_16_, real(0.3333333333333333));
            let t_19_ = t_6_.mul_add(t_17_, t_18_);
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [-t_5_, t_8_, real(0.0), real(0.0), real(0.0), t_15_],
                    [-t_6_, t_9_, real(0.0), real(0.0), real(0.0), t_19_],
                ]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::CentroidalMomentumBias, 2>
for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>, ::robot_dynamics::Entries<2, 1>);
    type Values = ::robot_dynamics::Entries<6, 1>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd"];
    const RESULT: &'static str = "centroidal_momentum_bias";
    const WORK: u32 = 97;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::CentroidalMomentumBias,
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
            let t_1_ = qd_1_ + qd_2_;
            let t_2_ = t_1_ * t_1_;
            let t_3_ = real(0.5) * t_2_;
            let t_4_ = qd_1_ * qd_1_;
            let t_5_ = c_2_.mul_add(t_3_, real(5.0) * t_4_);
            let t_6_ = s_2_ * t_3_;
            let t_7_ = (-c_1_).mul_add(t_5_, s_1_ * t_6_);
            let t_8_ = s_1_.mul_add(t_5_, c_1_ * t_6_);
            let t_9_ = t_2_ - t_4_;
            let t_10_ = s_2_ * t_9_;
            let t_11_ = real(-0.375) * t_10_;
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [t_7_, -t_8_, real(0.0), real(0.0), real(0.0), t_11_],
                ]),
            )
        })
    }
}
impl ::robot_dynamics::Function<
    ::robot_dynamics::functions::OperationalInertiaInverse,
    2,
> for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>,);
    type Values = ::robot_dynamics::Entries<6, 6>;
    type Error = ::robot_dynamics::SingularMassMatrix;
    const ARGUMENTS: &'static [&'static str] = &["q"];
    const RESULT: &'static str = "operational_inertia_inverse";
    const WORK: u32 = 121;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::OperationalInertiaInverse,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (q,): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
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
        let t_1_ = c_1_.mul_add(s_2_, s_1_ * c_2_);
        let t_2_ = real(3.0) * t_1_;
        let t_3_ = real(-2.0).mul_add(s_1_, t_2_ * c_2_);
        let t_4_ = c_2_ + c_2_;
        let t_5_ = real(8.333333333333334) + t_4_;
        let t_6_ = real(0.3333333333333333) + c_2_;
        let t_7_ = real(3.0) * t_6_;
        let t_8_ = (-t_6_).mul_add(t_7_, t_5_);
        let t_9_ = real(1.0) / t_8_;
        let t_10_ = t_9_ * t_3_;
        let t_11_ = t_3_.mul_add(t_10_, t_1_ * t_2_);
        let t_12_ = (-s_1_).mul_add(s_2_, c_1_ * c_2_);
        let t_13_ = real(2.0).mul_add(c_1_, t_12_);
        let t_14_ = t_7_.mul_add(t_12_, -t_13_);
        let t_15_ = t_14_.mul_add(t_10_, t_12_ * t_2_);
        let t_16_ = t_7_ - real(1.0);
        let t_17_ = t_16_.mul_add(t_10_, t_2_);
        let t_18_ = t_9_ * t_14_;
        let t_19_ = real(3.0) * t_12_;
        let t_20_ = t_14_.mul_add(t_18_, t_12_ * t_19_);
        let t_21_ = t_16_.mul_add(t_18_, t_19_);
        let t_22_ = t_9_ * t_16_;
        let t_23_ = t_16_.mul_add(t_22_, real(3.0));
        ::robot_dynamics::SingularMassMatrix::test_joint(
            1,
            "joint2",
            real(0.3333333333333333),
            real(0.3333333333333333),
        )?;
        ::robot_dynamics::SingularMassMatrix::test_joint(0, "joint1", t_8_, t_5_)?;
        ::core::result::Result::Ok(
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [t_11_, -t_15_, real(0.0), real(0.0), real(0.0), -t_17_],
                    [-t_15_, t_20_, real(0.0), real(0.0), real(0.0), t_21_],
                    [real(0.0), real(0.0), real(0.0), real(0.0), real(0.0), real(0.0)],
                    [real(0.0), real(0.0), real(0.0), real(0.0), real(0.0), real(0.0)],
                    [real(0.0), real(0.0), real(0.0), real(0.0), real(0.0), real(0.0)],
                    [-t_17_, t_21_, real(0.0), real(0.0), real(0.0), t_23_],
                ]),
            ),
        )
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::GeneralizedMomentum, 2>
for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>, ::robot_dynamics::Entries<2, 1>);
    type Values = ::robot_dynamics::Entries<2, 1>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd"];
    const RESULT: &'static str = "generalized_momentum";
    const WORK: u32 = 48;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::GeneralizedMomentum,
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
            let qd_1_ = qd.data.0[0][0];
            let qd_2_ = qd.data.0[0][1];
            let t_1_ = qd_1_ + qd_2_;
            let t_2_ = qd_1_.mul_add(c_2_, real(0.3333333333333333) * t_1_);
            let t_3_ = c_2_.mul_add(t_1_, real(8.0) * qd_1_);
            let t_4_ = t_2_ + t_3_;
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[t_4_, t_2_]]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::MomentumBias, 2> for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>, ::robot_dynamics::Entries<2, 1>);
    type Values = ::robot_dynamics::Entries<2, 1>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd"];
    const RESULT: &'static str = "momentum_bias";
    const WORK: u32 = 90;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::MomentumBias,
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
            let t_1_ = (-s_1_).mul_add(s_2_, c_1_ * c_2_);
            let t_2_ = real(4.905) * t_1_;
            let t_3_ = real(49.05).mul_add(c_1_, t_2_);
            let t_4_ = qd_1_ + qd_2_;
            let t_5_ = s_2_ * t_4_;
            let t_6_ = qd_1_.mul_add(t_5_, t_2_);
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[-t_3_, -t_6_]]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::PassivityTorque, 2>
for Arm {
    type Arguments = (
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
    );
    type Values = ::robot_dynamics::Entries<2, 1>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd", "qd_r", "qdd_r"];
    const RESULT: &'static str = "passivity_torque";
    const WORK: u32 = 103;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::PassivityTorque,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (q, qd, qd_r, qdd_r): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
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
            let qd_r_1_ = qd_r.data.0[0][0];
            let qd_r_2_ = qd_r.data.0[0][1];
            let qdd_r_1_ = qdd_r.data.0[0][0];
            let qdd_r_2_ = qdd_r.data.0[0][1];
            let t_1_ = qdd_r_1_ + qdd_r_2_;
            let t_2_ = qd_1_ + qd_2_;
            let t_3_ = qd_r_1_ + qd_r_2_;
            let t_4_ = t_2_ * t_3_;
            let t_5_ = qd_1_ * qd_r_1_;
            let t_6_ = real(-0.2038735983690112).mul_add(t_5_, s_1_);
            let t_7_ = real(0.2038735983690112).mul_add(qdd_r_1_, c_1_);
            let t_8_ = (-c_2_).mul_add(t_7_, s_2_ * t_6_);
            let t_9_ = real(-4.905).mul_add(t_8_, real(0.3333333333333333) * t_1_);
            let t_10_ = c_2_.mul_add(t_1_, real(8.0) * qdd_r_1_);
            let t_11_ = (-s_2_).mul_add(t_4_, real(49.05) * c_1_);
            let t_12_ = t_10_ + t_11_;
            let t_13_ = t_12_ + t_9_;
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[t_13_, t_9_]]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::PassivityRegressor, 2>
for Arm {
    type Arguments = (
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
    );
    type Values = ::robot_dynamics::Entries<2, 6>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd", "qd_r", "qdd_r"];
    const RESULT: &'static str = "passivity_regressor";
    const WORK: u32 = 107;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::PassivityRegressor,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (q, qd, qd_r, qdd_r): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
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
            let qd_r_1_ = qd_r.data.0[0][0];
            let qd_r_2_ = qd_r.data.0[0][1];
            let qdd_r_1_ = qdd_r.data.0[0][0];
            let qdd_r_2_ = qdd_r.data.0[0][1];
            let t_1_ = real(9.81) * c_1_;
            let t_2_ = real(-9.81) * s_1_;
            let t_3_ = qdd_r_1_ + qdd_r_2_;
            let t_4_ = real(2.0).mul_add(qdd_r_1_, t_1_);
            let t_5_ = qd_1_ * qd_r_1_;
            let t_6_ = real(2.0).mul_add(t_5_, t_2_);
            let t_7_ = s_2_.mul_add(t_6_, c_2_ * t_4_);
            let t_8_ = qd_1_ + qd_2_;
            let t_9_ = qd_r_1_ + qd_r_2_;
            let t_10_ = t_8_ * t_9_;
            let t_11_ = (-s_2_).mul_add(t_10_, c_2_ * t_3_);
            let t_12_ = real(2.0).mul_add(t_11_, t_7_);
            let t_13_ = (-s_2_).mul_add(t_4_, c_2_ * t_6_);
            let t_14_ = s_2_.mul_add(t_3_, c_2_ * t_10_);
            let t_15_ = real(-2.0).mul_add(t_14_, t_13_);
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [qdd_r_1_, real(0.0)],
                    [t_1_, real(0.0)],
                    [t_2_, real(0.0)],
                    [t_3_, t_3_],
                    [t_12_, t_7_],
                    [t_15_, t_13_],
                ]),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::EnergyRegressors, 2>
for Arm {
    type Arguments = (::robot_dynamics::Entries<2, 1>, ::robot_dynamics::Entries<2, 1>);
    type Values = (::robot_dynamics::Entries<6, 1>, ::robot_dynamics::Entries<6, 1>);
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd"];
    const RESULT: &'static str = "energy_regressors";
    const WORK: u32 = 97;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::EnergyRegressors,
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
            let t_1_ = qd_1_ * qd_1_;
            let t_2_ = real(0.5) * t_1_;
            let t_3_ = qd_1_ + qd_2_;
            let t_4_ = t_3_ * t_3_;
            let t_5_ = real(0.5) * t_4_;
            let t_6_ = real(2.0) * qd_1_;
            let t_7_ = t_6_ * t_3_;
            let t_8_ = c_2_ * t_7_;
            let t_9_ = s_2_ * t_7_;
            let t_10_ = real(9.81) * s_1_;
            let t_11_ = real(9.81) * c_1_;
            let t_12_ = s_2_.mul_add(t_11_, c_2_ * t_10_);
            let t_13_ = (-s_2_).mul_add(t_10_, c_2_ * t_11_);
            (
                ::robot_dynamics::nalgebra::SMatrix::from_data(
                    ::robot_dynamics::nalgebra::ArrayStorage([
                        [t_2_, real(0.0), real(0.0), t_5_, t_8_, -t_9_],
                    ]),
                ),
                ::robot_dynamics::nalgebra::SMatrix::from_data(
                    ::robot_dynamics::nalgebra::ArrayStorage([
                        [real(0.0), t_10_, t_11_, real(0.0), t_12_, t_13_],
                    ]),
                ),
            )
        })
    }
}
impl ::robot_dynamics::Function<::robot_dynamics::functions::InverseDynamicsRates, 2>
for Arm {
    type Arguments = (
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
    );
    type Values = (::robot_dynamics::Entries<2, 1>, ::robot_dynamics::Entries<2, 1>);
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd", "qdd", "jerk", "snap"];
    const RESULT: &'static str = "inverse_dynamics_rates";
    const WORK: u32 = 177;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::InverseDynamicsRates,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (
            q,
            qd,
            qdd,
            jerk,
            snap,
        ): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
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
            let qdd_1_ = qdd.data.0[0][0];
            let qdd_2_ = qdd.data.0[0][1];
            let jerk_1_ = jerk.data.0[0][0];
            let jerk_2_ = jerk.data.0[0][1];
            let snap_1_ = snap.data.0[0][0];
            let snap_2_ = snap.data.0[0][1];
            let t_1_ = s_1_ * qd_1_;
            let t_2_ = real(0.2038735983690112).mul_add(jerk_1_, -t_1_);
            let t_3_ = s_2_ * qd_2_;
            let t_4_ = real(0.2038735983690112).mul_add(qdd_1_, c_1_);
            let t_5_ = c_1_ * qd_1_;
            let t_6_ = qd_1_ * qdd_1_;
            let t_7_ = real(-0.4077471967380224).mul_add(t_6_, t_5_);
            let t_8_ = c_2_ * qd_2_;
            let t_9_ = qd_1_ * qd_1_;
            let t_10_ = real(0.2038735983690112).mul_add(t_9_, -s_1_);
            let t_11_ = jerk_1_ + jerk_2_;
            let t_12_ = (-t_3_).mul_add(t_4_, real(0.06795786612300374) * t_11_);
            let t_13_ = c_2_.mul_add(t_2_, t_8_ * t_10_);
            let t_14_ = (-s_2_).mul_add(t_7_, t_12_);
            let t_15_ = t_13_ + t_14_;
            let t_16_ = real(4.905) * t_15_;
            let t_17_ = qd_1_ + qd_2_;
            let t_18_ = t_17_ * t_17_;
            let t_19_ = qdd_1_ + qdd_2_;
            let t_20_ = t_17_ * t_19_;
            let t_21_ = real(2.0) * t_20_;
            let t_22_ = (-s_2_).mul_add(t_21_, real(8.0) * jerk_1_);
            let t_23_ = real(-49.05).mul_add(t_1_, c_2_ * t_11_);
            let t_24_ = (-t_8_).mul_add(t_18_, t_22_);
            let t_25_ = (-t_3_).mul_add(t_19_, t_23_);
            let t_26_ = t_24_ + t_25_;
            let t_27_ = t_26_ + t_16_;
            let t_28_ = qd_1_.mul_add(t_5_, s_1_ * qdd_1_);
            let t_29_ = real(0.2038735983690112).mul_add(snap_1_, -t_28_);
            let t_30_ = qd_2_.mul_add(t_8_, s_2_ * qdd_2_);
            let t_31_ = qd_1_.mul_add(jerk_1_, qdd_1_ * qdd_1_);
            let t_32_ = (-c_1_).mul_add(qdd_1_, real(0.4077471967380224) * t_31_);
            let t_33_ = qd_1_.mul_add(t_1_, t_32_);
            let t_34_ = (-c_2_).mul_add(qdd_2_, qd_2_ * t_3_);
            let t_35_ = snap_1_ + snap_2_;
            let t_36_ = t_3_.mul_add(t_2_, t_8_ * t_7_);
            let t_37_ = (-t_4_).mul_add(t_30_, real(0.06795786612300374) * t_35_);
            let t_38_ = (-t_10_).mul_add(t_34_, s_2_ * t_33_);
            let t_39_ = c_2_.mul_add(t_29_, t_37_);
            let t_40_ = real(-2.0).mul_add(t_36_, t_38_);
            let t_41_ = t_39_ + t_40_;
            let t_42_ = real(4.905) * t_41_;
            let t_43_ = t_17_.mul_add(t_11_, t_19_ * t_19_);
            let t_44_ = t_3_.mul_add(t_11_, s_2_ * t_43_);
            let t_45_ = t_8_.mul_add(t_21_, t_44_);
            let t_46_ = c_2_.mul_add(t_35_, real(8.0) * snap_1_);
            let t_47_ = real(-49.05).mul_add(t_28_, t_46_);
            let t_48_ = (-t_19_).mul_add(t_30_, t_18_ * t_34_);
            let t_49_ = real(-2.0).mul_add(t_45_, t_47_);
            let t_50_ = t_48_ + t_49_;
            let t_51_ = t_50_ + t_42_;
            (
                ::robot_dynamics::nalgebra::SMatrix::from_data(
                    ::robot_dynamics::nalgebra::ArrayStorage([[t_27_, t_16_]]),
                ),
                ::robot_dynamics::nalgebra::SMatrix::from_data(
                    ::robot_dynamics::nalgebra::ArrayStorage([[t_51_, t_42_]]),
                ),
            )
        })
    }
}
impl ::robot_dynamics::Function<
    ::robot_dynamics::functions::InverseDynamicsSecondDerivatives,
    2,
> for Arm {
    type Arguments = (
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
        ::robot_dynamics::Entries<2, 1>,
    );
    type Values = (
        [::robot_dynamics::Entries<2, 2>; 2],
        [::robot_dynamics::Entries<2, 2>; 2],
        [::robot_dynamics::Entries<2, 2>; 2],
        [::robot_dynamics::Entries<2, 2>; 2],
    );
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd", "qdd"];
    const RESULT: &'static str = "inverse_dynamics_second_derivatives";
    const WORK: u32 = 107;
    const IN_LANES: bool = true;
    #[inline(always)]
    fn at<T: ::robot_dynamics::Scalar>(
        &self,
        _: ::robot_dynamics::functions::InverseDynamicsSecondDerivatives,
        sines: &impl ::robot_dynamics::Inputs<T>,
        (q, qd, qdd): &<Self::Arguments as ::robot_dynamics::Arrangement>::Of<T>,
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
            let qdd_1_ = qdd.data.0[0][0];
            let qdd_2_ = qdd.data.0[0][1];
            let t_1_ = real(4.905) * c_1_;
            let t_2_ = c_2_ * t_1_;
            let t_3_ = real(0.5) * s_2_;
            let t_4_ = real(9.81) * s_1_;
            let t_5_ = t_3_.mul_add(t_4_, -t_2_);
            let t_6_ = real(-49.05).mul_add(c_1_, t_5_);
            let t_7_ = real(2.0) * qd_1_;
            let t_8_ = (-qd_1_).mul_add(t_7_, t_4_);
            let t_9_ = qdd_1_.mul_add(c_2_, t_2_);
            let t_10_ = t_3_.mul_add(t_8_, -t_9_);
            let t_11_ = qdd_1_ + qdd_2_;
            let t_12_ = qd_1_ + qd_2_;
            let t_13_ = t_12_ * t_12_;
            let t_14_ = (-c_2_).mul_add(t_11_, s_2_ * t_13_);
            let t_15_ = t_14_ + t_10_;
            let t_16_ = real(2.0) * s_2_;
            let t_17_ = c_2_ * t_7_;
            let t_18_ = c_2_ * t_12_;
            let t_19_ = real(2.0) * t_18_;
            let t_20_ = t_17_ - t_19_;
            (
                [
                    ::robot_dynamics::nalgebra::SMatrix::from_data(
                        ::robot_dynamics::nalgebra::ArrayStorage([
                            [t_6_, t_5_],
                            [t_5_, t_15_],
                        ]),
                    ),
                    ::robot_dynamics::nalgebra::SMatrix::from_data(
                        ::robot_dynamics::nalgebra::ArrayStorage([
                            [t_5_, t_5_],
                            [t_5_, t_10_],
                        ]),
                    ),
                ],
                [
                    ::robot_dynamics::nalgebra::SMatrix::from_data(
                        ::robot_dynamics::nalgebra::ArrayStorage([
                            [real(0.0), -t_16_],
                            [-t_16_, -t_16_],
                        ]),
                    ),
                    ::robot_dynamics::nalgebra::SMatrix::from_data(
                        ::robot_dynamics::nalgebra::ArrayStorage([
                            [t_16_, real(0.0)],
                            [real(0.0), real(0.0)],
                        ]),
                    ),
                ],
                [
                    ::robot_dynamics::nalgebra::SMatrix::from_data(
                        ::robot_dynamics::nalgebra::ArrayStorage([
                            [real(0.0), t_20_],
                            [real(0.0), -t_19_],
                        ]),
                    ),
                    ::robot_dynamics::nalgebra::SMatrix::from_data(
                        ::robot_dynamics::nalgebra::ArrayStorage([
                            [real(0.0), t_17_],
                            [real(0.0), real(0.0)],
                        ]),
                    ),
                ],
                [
                    ::robot_dynamics::nalgebra::SMatrix::from_data(
                        ::robot_dynamics::nalgebra::ArrayStorage([
                            [real(0.0), real(0.0)],
                            [-t_16_, -s_2_],
                        ]),
                    ),
                    ::robot_dynamics::nalgebra::SMatrix::from_data(
                        ::robot_dynamics::nalgebra::ArrayStorage([
                            [real(0.0), real(0.0)],
                            [-s_2_, real(0.0)],
                        ]),
                    ),
                ],
            )
        })
    }
}
