// Generated from panda.urdf by `robot-dynamics generate --lang rust`: what the macro `robot_dynamics!` expands to
// for this arm. The crate that it stands in depends on `robot-dynamics`.

#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(clippy::derive_partial_eq_without_eq)]
/// The arm of `panda.urdf`, with its equations of motion.
///
/// Joints that move: `panda_joint1`, `panda_joint2`, `panda_joint3`, `panda_joint4`, `panda_joint5`, `panda_joint6`, `panda_joint7`.
pub struct Panda;

#[allow(
    dead_code,
    deprecated,
    unused_variables,
    unused_parens,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl Panda {
    /// Number of joints.
    pub const DOF: usize = 7;

    /// Names of the joints, from the base outwards.
    pub const JOINT_NAMES: [&'static str; 7] = [
        "panda_joint1",
        "panda_joint2",
        "panda_joint3",
        "panda_joint4",
        "panda_joint5",
        "panda_joint6",
        "panda_joint7",
    ];

    /// Ranges of the joints' positions, lower ends first, rad or m, where the table has them.
    pub const JOINT_LIMITS: [::core::option::Option<[f64; 2]>; 7] = [
        ::core::option::Option::Some([(-2.8973f64), 2.8973f64]),
        ::core::option::Option::Some([(-1.7628f64), 1.7628f64]),
        ::core::option::Option::Some([(-2.8973f64), 2.8973f64]),
        ::core::option::Option::Some([(-3.0718f64), (-0.0698f64)]),
        ::core::option::Option::Some([(-2.8973f64), 2.8973f64]),
        ::core::option::Option::Some([(-0.0175f64), 3.7525f64]),
        ::core::option::Option::Some([(-2.8973f64), 2.8973f64]),
    ];

    /// Operations of each generated method, by the method's name.
    pub const OPERATIONS: [(&'static str, ::robot_dynamics::Operations); 8] = [
        (
            "mass_matrix",
            ::robot_dynamics::Operations {
                multiplications: 165,
                additions: 146,
                divisions: 0,
                sin_cos: 6,
                exponentials: 0,
            },
        ),
        (
            "coriolis_vector",
            ::robot_dynamics::Operations {
                multiplications: 270,
                additions: 244,
                divisions: 0,
                sin_cos: 6,
                exponentials: 0,
            },
        ),
        (
            "gravity_vector",
            ::robot_dynamics::Operations {
                multiplications: 44,
                additions: 30,
                divisions: 0,
                sin_cos: 6,
                exponentials: 0,
            },
        ),
        (
            "friction_vector",
            ::robot_dynamics::Operations {
                multiplications: 7,
                additions: 0,
                divisions: 0,
                sin_cos: 0,
                exponentials: 0,
            },
        ),
        (
            "inverse_dynamics",
            ::robot_dynamics::Operations {
                multiplications: 299,
                additions: 276,
                divisions: 0,
                sin_cos: 6,
                exponentials: 0,
            },
        ),
        (
            "forward_dynamics",
            ::robot_dynamics::Operations {
                multiplications: 570,
                additions: 503,
                divisions: 6,
                sin_cos: 6,
                exponentials: 0,
            },
        ),
        (
            "kinetic_energy",
            ::robot_dynamics::Operations {
                multiplications: 135,
                additions: 92,
                divisions: 0,
                sin_cos: 6,
                exponentials: 0,
            },
        ),
        (
            "potential_energy",
            ::robot_dynamics::Operations {
                multiplications: 19,
                additions: 20,
                divisions: 0,
                sin_cos: 6,
                exponentials: 0,
            },
        ),
    ];

    /// The table in numbers, as it was written: what the numeric checks read.
    pub fn table(&self) -> ::robot_dynamics::Table<7> {
        ::robot_dynamics::Table::lock(
            ::robot_dynamics::Convention::Modified,
            [0f64, 0f64, (-9.81f64)],
            [
                ::robot_dynamics::Row {
                    a: 0f64,
                    alpha: 0f64,
                    d: 0.333f64,
                    theta: 0f64,
                    mass: 4.970684f64,
                    com: [0.003875f64, 0.002081f64, (-0.04762f64)],
                    inertia: [
                        0.70337f64,
                        0.70661f64,
                        0.009117f64,
                        (-0.000139f64),
                        0.019169f64,
                        0.006772f64,
                    ],
                    motor_inertia: 0f64,
                    gear_ratio: 0f64,
                    viscous: 0.003f64,
                    coulomb: [0f64, 0f64],
                    limits: ::core::option::Option::Some([(-2.8973f64), 2.8973f64]),
                    ..::robot_dynamics::Row::new(::robot_dynamics::JointType::Revolute)
                },
                ::robot_dynamics::Row {
                    a: 0f64,
                    alpha: (-1.5707963267948966f64),
                    d: 0f64,
                    theta: 0f64,
                    mass: 0.646926f64,
                    com: [(-0.003141f64), (-0.02872f64), 0.003495f64],
                    inertia: [
                        0.007962f64,
                        0.02811f64,
                        0.025995f64,
                        (-0.003925f64),
                        0.000704f64,
                        0.010254f64,
                    ],
                    motor_inertia: 0f64,
                    gear_ratio: 0f64,
                    viscous: 0.003f64,
                    coulomb: [0f64, 0f64],
                    limits: ::core::option::Option::Some([(-1.7628f64), 1.7628f64]),
                    ..::robot_dynamics::Row::new(::robot_dynamics::JointType::Revolute)
                },
                ::robot_dynamics::Row {
                    a: 0f64,
                    alpha: 1.5707963267948966f64,
                    d: 0.316f64,
                    theta: 0f64,
                    mass: 3.228604f64,
                    com: [0.027518f64, 0.039252f64, (-0.066502f64)],
                    inertia: [
                        0.037242f64,
                        0.036155f64,
                        0.01083f64,
                        (-0.004761f64),
                        (-0.012805f64),
                        (-0.011396f64),
                    ],
                    motor_inertia: 0f64,
                    gear_ratio: 0f64,
                    viscous: 0.003f64,
                    coulomb: [0f64, 0f64],
                    limits: ::core::option::Option::Some([(-2.8973f64), 2.8973f64]),
                    ..::robot_dynamics::Row::new(::robot_dynamics::JointType::Revolute)
                },
                ::robot_dynamics::Row {
                    a: 0.0825f64,
                    alpha: 1.5707963267948966f64,
                    d: 0f64,
                    theta: 0f64,
                    mass: 3.587895f64,
                    com: [(-0.05317f64), 0.104419f64, 0.027454f64],
                    inertia: [
                        0.025853f64,
                        0.019552f64,
                        0.028323f64,
                        0.007796f64,
                        0.008641f64,
                        (-0.001332f64),
                    ],
                    motor_inertia: 0f64,
                    gear_ratio: 0f64,
                    viscous: 0.003f64,
                    coulomb: [0f64, 0f64],
                    limits: ::core::option::Option::Some([(-3.0718f64), (-0.0698f64)]),
                    ..::robot_dynamics::Row::new(::robot_dynamics::JointType::Revolute)
                },
                ::robot_dynamics::Row {
                    a: (-0.0825f64),
                    alpha: (-1.5707963267948966f64),
                    d: 0.384f64,
                    theta: 0f64,
                    mass: 1.225946f64,
                    com: [(-0.011953f64), 0.041065f64, (-0.038437f64)],
                    inertia: [
                        0.035549f64,
                        0.029474f64,
                        0.008627f64,
                        (-0.002117f64),
                        0.000229f64,
                        (-0.004037f64),
                    ],
                    motor_inertia: 0f64,
                    gear_ratio: 0f64,
                    viscous: 0.003f64,
                    coulomb: [0f64, 0f64],
                    limits: ::core::option::Option::Some([(-2.8973f64), 2.8973f64]),
                    ..::robot_dynamics::Row::new(::robot_dynamics::JointType::Revolute)
                },
                ::robot_dynamics::Row {
                    a: 0f64,
                    alpha: 1.5707963267948966f64,
                    d: 0f64,
                    theta: 0f64,
                    mass: 1.666555f64,
                    com: [0.060149f64, (-0.014117f64), (-0.010517f64)],
                    inertia: [
                        0.001964f64,
                        0.004354f64,
                        0.005433f64,
                        0.000109f64,
                        0.000341f64,
                        (-0.001158f64),
                    ],
                    motor_inertia: 0f64,
                    gear_ratio: 0f64,
                    viscous: 0.003f64,
                    coulomb: [0f64, 0f64],
                    limits: ::core::option::Option::Some([(-0.0175f64), 3.7525f64]),
                    ..::robot_dynamics::Row::new(::robot_dynamics::JointType::Revolute)
                },
                ::robot_dynamics::Row {
                    a: 0.088f64,
                    alpha: 1.5707963267948966f64,
                    d: 0f64,
                    theta: 0f64,
                    mass: 1.495522f64,
                    com: [
                        0.0017208742976286562f64,
                        0.0013603544171612299f64,
                        0.10048528114865579f64,
                    ],
                    inertia: [
                        0.01652985371263463f64,
                        0.014107248642161839f64,
                        0.0066769555566409565f64,
                        0.00039489229711917777f64,
                        (-0.001051105327046708f64),
                        (-0.0007066957106145018f64),
                    ],
                    motor_inertia: 0f64,
                    gear_ratio: 0f64,
                    viscous: 0.003f64,
                    coulomb: [0f64, 0f64],
                    limits: ::core::option::Option::Some([(-2.8973f64), 2.8973f64]),
                    ..::robot_dynamics::Row::new(::robot_dynamics::JointType::Revolute)
                },
                ::robot_dynamics::Row {
                    a: 0f64,
                    alpha: 0f64,
                    d: 0f64,
                    theta: 0f64,
                    mass: 0f64,
                    com: [0f64, 0f64, 0f64],
                    inertia: [0f64, 0f64, 0f64, 0f64, 0f64, 0f64],
                    motor_inertia: 0f64,
                    gear_ratio: 0f64,
                    viscous: 0f64,
                    coulomb: [0f64, 0f64],
                    limits: ::core::option::Option::None,
                    link_frame: ::robot_dynamics::Placement::of_frames(
                        &[
                            ::robot_dynamics::Frame {
                                xyz: [0f64, 0f64, 0.107f64],
                                rpy: [0f64, 0f64, 0f64],
                            },
                        ],
                    ),
                    ..::robot_dynamics::Row::new(::robot_dynamics::JointType::Revolute)
                },
            ],
            [
                ::core::option::Option::None,
                ::core::option::Option::None,
                ::core::option::Option::None,
                ::core::option::Option::None,
                ::core::option::Option::None,
                ::core::option::Option::None,
                ::core::option::Option::None,
                ::core::option::Option::Some(0f64),
            ],
        )
    }

    /// What the generated methods compute, value by value, where that is short enough to
    /// read: formulas of at most 24 terms of arms of up to three joints.
    pub fn formulas() -> &'static [::robot_dynamics::Formula] {
        &[]
    }

    /// Mass matrix M(q), N x N, both triangles, reflected motor inertias included (kg m^2, kg m or kg). Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong).
    ///
    /// `q`: joint positions, rad.
    ///
    /// Rounding error in `f64` (SI units): at most 4.8e-14, proven for joints within their limits.
    ///
    /// Operations: 165 multiplications, 146 additions, sines and cosines of 6 angles.
    ///
    /// M77 is constant; M11, M12, M13, M14, M15, M16, M17 depend on q2 to q7; M22, M23, M24, M25, M26, M27 depend on q3 to q7; M33, M34, M35, M36, M37 depend on q4 to q7; M44, M45, M46, M47 depend on q5 to q7; M55, M56, M57 depend on q6, q7; M66, M67 depend on q7.
    ///
    /// Formulas of arms of more than 3 joints: `robot-dynamics show`, with `--format text`.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn mass_matrix<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 7>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 7, 7> {
        <Self as ::robot_dynamics::MassMatrix<
            7,
        >>::mass_matrix_at(self, &::robot_dynamics::Evaluated, q)
    }

    /// Coriolis and centrifugal vector V(q, qd), N m or N: inverse dynamics without gravity, springs, friction and acceleration.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s.
    ///
    /// Rounding error in `f64` (SI units): at most 8.2e-13, proven for joints within their limits and entries of `qd` up to 1; it grows with the square of `qd`.
    ///
    /// Operations: 270 multiplications, 244 additions, sines and cosines of 6 angles.
    ///
    /// V7 depends on q2 to q7, qd1 to qd6; V1, V2, V3, V4, V5, V6 depend on q2 to q7, qd1 to qd7.
    ///
    /// Formulas of arms of more than 3 joints: `robot-dynamics show`, with `--format text`.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn coriolis_vector<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 7>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 7>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 7> {
        <Self as ::robot_dynamics::CoriolisVector<
            7,
        >>::coriolis_vector_at(self, &::robot_dynamics::Evaluated, q, qd)
    }

    /// Gravity vector G(q), N m or N: the gradient of the potential energy of gravity, inverse dynamics at rest without springs.
    ///
    /// `q`: joint positions, rad.
    ///
    /// Rounding error in `f64` (SI units): at most 9.5e-14, proven for joints within their limits.
    ///
    /// Operations: 44 multiplications, 30 additions, sines and cosines of 6 angles.
    ///
    /// G1 is zero; G2, G3, G4, G5, G6, G7 depend on q2 to q7.
    ///
    /// Formulas of arms of more than 3 joints: `robot-dynamics show`, with `--format text`.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn gravity_vector<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 7>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 7> {
        <Self as ::robot_dynamics::GravityVector<
            7,
        >>::gravity_vector_at(self, &::robot_dynamics::Evaluated, q)
    }

    /// Friction vector F(qd) = viscous qd + sign(qd) (C + (S - C) exp(-(qd/v)^2)), N m or N, with sign(0) = 0: C is the Coulomb friction of the direction, S static friction that falls to it over the velocity v, where the table has one, else C.
    ///
    /// `qd`: joint velocities, rad per s.
    ///
    /// Rounding error in `f64` (SI units): at most 6.7e-19, proven for entries of `qd` up to 1; it grows in proportion to `qd`.
    ///
    /// Operations: 7 multiplications, 0 additions.
    ///
    /// F1 depends on qd1; F2 depends on qd2; F3 depends on qd3; F4 depends on qd4; F5 depends on qd5; F6 depends on qd6; F7 depends on qd7.
    ///
    /// Formulas of arms of more than 3 joints: `robot-dynamics show`, with `--format text`.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn friction_vector<T: ::robot_dynamics::Scalar>(
        &self,
        qd: &::robot_dynamics::nalgebra::SVector<T, 7>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 7> {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::FrictionVector,
            7,
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
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s; `qdd`: joint accelerations, rad per s^2.
    ///
    /// Rounding error in `f64` (SI units): at most 1.4e-12, proven for joints within their limits and entries of `qd` and `qdd` up to 1.
    ///
    /// Operations: 299 multiplications, 276 additions, sines and cosines of 6 angles.
    ///
    /// tau1, tau2, tau3, tau4, tau5, tau6, tau7 depend on q2 to q7, qd1 to qd7, qdd1 to qdd7.
    ///
    /// Formulas of arms of more than 3 joints: `robot-dynamics show`, with `--format text`.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn inverse_dynamics<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 7>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 7>,
        qdd: &::robot_dynamics::nalgebra::SVector<T, 7>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 7> {
        <Self as ::robot_dynamics::InverseDynamics<
            7,
        >>::inverse_dynamics_at(self, &::robot_dynamics::Evaluated, q, qd, qdd)
    }

    /// Forward dynamics: the accelerations qdd with M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau, rad/s^2 or m/s^2; K is of springs, F of friction.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s; `tau`: joint forces and torques, N m.
    ///
    /// Rounding error: no bound over the joint limits is of use; `Certified` bounds it at a state.
    ///
    /// Operations: 570 multiplications, 503 additions, 6 divisions, sines and cosines of 6 angles.
    ///
    /** # Errors

 `SingularMassMatrix` where M(q) is not positive definite to working precision, or not finite: it names the joint whose pivot failed.*/

    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn forward_dynamics<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 7>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 7>,
        tau: &::robot_dynamics::nalgebra::SVector<T, 7>,
    ) -> ::core::result::Result<
        ::robot_dynamics::nalgebra::SVector<T, 7>,
        ::robot_dynamics::SingularMassMatrix,
    > {
        <Self as ::robot_dynamics::ForwardDynamics<
            7,
        >>::forward_dynamics_at(self, &::robot_dynamics::Evaluated, q, qd, tau)
    }

    /// Kinetic energy T(q, qd) = 1/2 qd^T M(q) qd, reflected motor inertias included, J.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s.
    ///
    /// Rounding error in `f64` (SI units): at most 8.4e-14, proven for joints within their limits and entries of `qd` up to 1; it grows with the square of `qd`.
    ///
    /// Operations: 135 multiplications, 92 additions, sines and cosines of 6 angles.
    ///
    /// Formulas of arms of more than 3 joints: `robot-dynamics show`, with `--format text`.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn kinetic_energy<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 7>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 7>,
    ) -> T {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::KineticEnergy,
            7,
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
    /// Rounding error in `f64` (SI units): at most 2.0e-13, proven for joints within their limits.
    ///
    /// Operations: 19 multiplications, 20 additions, sines and cosines of 6 angles.
    ///
    /// Formulas of arms of more than 3 joints: `robot-dynamics show`, with `--format text`.
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline(never)]
    #[allow(unused_variables, clippy::all)]
    pub fn potential_energy<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 7>,
    ) -> T {
        let ::core::result::Result::Ok(all_values) = <Self as ::robot_dynamics::Function<
            ::robot_dynamics::functions::PotentialEnergy,
            7,
        >>::at(
            self,
            ::robot_dynamics::functions::PotentialEnergy,
            &::robot_dynamics::Evaluated,
            &(*q,),
        );
        all_values
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::MassMatrix<7> for Panda {
    const WORK: u32 = 551;

    #[inline]
    fn mass_matrix<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 7>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 7, 7> {
        Self::mass_matrix(self, q)
    }

    #[inline(always)]
    fn mass_matrix_at<T: ::robot_dynamics::Scalar>(
        &self,
        sines: &impl ::robot_dynamics::Inputs<T>,
        q: &::robot_dynamics::nalgebra::SVector<T, 7>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 7, 7> {
        let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
        let [(s_2, c_2), (s_3, c_3), (s_4, c_4), (s_5, c_5), (s_6, c_6), (s_7, c_7)] = ::robot_dynamics::Inputs::sin_cos(
            sines,
            [1, 2, 3, 4, 5, 6],
            [
                q.data.0[0][1],
                q.data.0[0][2],
                q.data.0[0][3],
                q.data.0[0][4],
                q.data.0[0][5],
                q.data.0[0][6],
            ],
        );
        let t_1 = real(-0.002573605371338203)
            .mul_add(c_7, real(0.002034439958661797) * s_7);
        let t_2 = t_1 - real(0.231847552695);
        let t_3 = s_6.mul_add(t_2, real(0.173804705569) * c_6);
        let t_4 = t_3 - real(2.012523553603);
        let t_5 = real(0.002573605371338203)
            .mul_add(s_7, real(0.002034439958661797) * c_7);
        let t_6 = real(0.067870631425) - t_5;
        let t_7 = (-c_6).mul_add(t_2, real(0.173804705569) * s_6);
        let t_8 = t_7 - real(0.014653732538);
        let t_9 = (-s_5).mul_add(t_6, c_5 * t_8);
        let t_10 = t_9 - real(0.55278027465);
        let t_11 = (-c_4).mul_add(t_4, s_4 * t_10);
        let t_12 = real(0.316) * t_11;
        let t_13 = c_4.mul_add(t_10, s_4 * t_4);
        let t_14 = real(0.0825) * t_13;
        let t_15 = t_12 + t_14;
        let t_16 = real(0.0825) * t_9;
        let t_17 = real(2.0) * t_16;
        let t_18 = real(0.088) * t_1;
        let t_19 = real(2.0) * t_18;
        let t_20 = real(0.000782782563368496)
            .mul_add(c_7, real(0.00242094377852123) * s_7);
        let t_21 = s_7 * t_20;
        let t_22 = real(0.05258828201066731) + t_21;
        let t_23 = t_22 - t_19;
        let t_24 = real(0.384) * t_3;
        let t_25 = real(2.0) * t_24;
        let t_26 = t_23 - t_25;
        let t_27 = real(0.006684151967360946) - t_19;
        let t_28 = t_21 - real(0.011964715048013426);
        let t_29 = t_28 + t_27;
        let t_30 = real(-0.0012555365982728983)
            .mul_add(s_7, real(0.0009653051699191118) * c_7);
        let t_31 = real(0.014748570382675316) + t_30;
        let t_32 = real(2.0) * t_31;
        let t_33 = (-c_6).mul_add(t_32, s_6 * t_29);
        let t_34 = s_6 * t_33;
        let t_35 = real(0.030116287133882085) - t_28;
        let t_36 = t_35 - t_25;
        let t_37 = t_36 + t_34;
        let t_38 = t_26 - t_37;
        let t_39 = real(0.088).mul_add(t_5, real(0.000495150198902933));
        let t_40 = (-c_7).mul_add(t_20, t_39);
        let t_41 = real(0.0012555365982728983)
            .mul_add(c_7, real(0.0009653051699191118) * s_7);
        let t_42 = real(0.000093569097314605) + t_41;
        let t_43 = c_6.mul_add(t_40, s_6 * t_42);
        let t_44 = t_43 - real(0.00151524447332703);
        let t_45 = real(2.0) * t_44;
        let t_46 = (-c_5).mul_add(t_45, s_5 * t_38);
        let t_47 = s_5 * t_46;
        let t_48 = real(0.749763367252814) + t_26;
        let t_49 = t_17 - t_48;
        let t_50 = t_49 + t_47;
        let t_51 = t_15 - t_50;
        let t_52 = t_15 + t_51;
        let t_53 = real(0.033018599263935515) + t_27;
        let t_54 = t_53 - t_34;
        let t_55 = t_17 - t_54;
        let t_56 = real(0.647723094939183) + t_37;
        let t_57 = t_56 + t_47;
        let t_58 = t_55 + t_57;
        let t_59 = t_31 - real(0.001026787777028894);
        let t_60 = real(0.384).mul_add(t_7, t_59);
        let t_61 = c_6.mul_add(t_33, t_60);
        let t_62 = (-s_6).mul_add(t_40, c_6 * t_42);
        let t_63 = real(0.384).mul_add(t_5, -real(0.02389827041510187));
        let t_64 = t_63 - t_62;
        let t_65 = c_5.mul_add(t_61, s_5 * t_64);
        let t_66 = real(0.0825).mul_add(t_3, -real(0.16284087268546085));
        let t_67 = t_66 + t_65;
        let t_68 = real(2.0) * t_67;
        let t_69 = (-c_4).mul_add(t_68, s_4 * t_58);
        let t_70 = s_4 * t_69;
        let t_71 = real(2.0).mul_add(t_12, real(0.01159586409516604));
        let t_72 = t_71 + t_57;
        let t_73 = t_70 - t_72;
        let t_74 = t_52 + t_73;
        let t_75 = s_5.mul_add(t_8, c_5 * t_6);
        let t_76 = real(0.0825) * t_75;
        let t_77 = real(0.0039053550262761) + t_44;
        let t_78 = t_77 - t_76;
        let t_79 = c_5.mul_add(t_46, t_78);
        let t_80 = (-c_5).mul_add(t_64, s_5 * t_61);
        let t_81 = t_80 - real(0.00164448757736927);
        let t_82 = (-s_4).mul_add(t_81, c_4 * t_79);
        let t_83 = real(0.000121912420950744) + t_76;
        let t_84 = t_83 + t_82;
        let t_85 = real(2.0) * t_84;
        let t_86 = s_3.mul_add(t_74, c_3 * t_85);
        let t_87 = s_3 * t_86;
        let t_88 = real(2.0).mul_add(t_14, real(0.13480070614822143));
        let t_89 = t_88 - t_55;
        let t_90 = t_89 + t_70;
        let t_91 = real(1.0706865997634767) - t_73;
        let t_92 = t_91 - t_90;
        let t_93 = t_92 + t_87;
        let t_94 = real(0.0825).mul_add(t_11, real(0.24149476342611426));
        let t_95 = real(0.316).mul_add(t_13, t_94);
        let t_96 = t_95 - t_67;
        let t_97 = (-c_4).mul_add(t_69, t_96);
        let t_98 = real(0.316) * t_75;
        let t_99 = s_4.mul_add(t_79, c_4 * t_81);
        let t_100 = real(0.013297019103287584) + t_98;
        let t_101 = t_100 + t_99;
        let t_102 = (-s_3).mul_add(t_101, c_3 * t_97);
        let t_103 = real(0.00398335888393552) - t_102;
        let t_104 = real(2.0) * t_103;
        let t_105 = (-c_2).mul_add(t_104, s_2 * t_93);
        let t_106 = real(0.03733744848940618) + t_90;
        let t_107 = s_2.mul_add(t_105, t_106);
        let t_108 = real(0.01026110182100817) + t_84;
        let t_109 = (-c_3).mul_add(t_86, t_108);
        let t_110 = s_3.mul_add(t_97, c_3 * t_101);
        let t_111 = real(0.0007689361029464) + t_110;
        let t_112 = s_2.mul_add(t_109, c_2 * t_111);
        let t_113 = s_2.mul_add(t_102, c_2 * t_90);
        let t_114 = s_3.mul_add(t_51, c_3 * t_82);
        let t_115 = (-s_2).mul_add(t_114, c_2 * t_99);
        let t_116 = t_16 - t_54;
        let t_117 = c_4.mul_add(t_65, real(0.316) * t_9);
        let t_118 = s_4.mul_add(t_116, -t_117);
        let t_119 = (-s_4).mul_add(t_76, c_4 * t_98);
        let t_120 = t_80 + t_119;
        let t_121 = c_3.mul_add(t_118, s_3 * t_120);
        let t_122 = (-s_4).mul_add(t_65, t_16);
        let t_123 = (-c_4).mul_add(t_116, t_122);
        let t_124 = (-s_2).mul_add(t_121, c_2 * t_123);
        let t_125 = t_23 - t_24;
        let t_126 = (-s_5).mul_add(t_125, c_5 * t_43);
        let t_127 = s_5 * t_3;
        let t_128 = real(0.0825) * t_127;
        let t_129 = t_128 - t_62;
        let t_130 = (-s_4).mul_add(t_129, real(0.316) * t_127);
        let t_131 = c_4.mul_add(t_126, t_130);
        let t_132 = c_5 * t_3;
        let t_133 = s_4.mul_add(t_132, c_4 * t_7);
        let t_134 = real(-0.0825).mul_add(t_7, s_5 * t_43);
        let t_135 = c_5.mul_add(t_125, t_134);
        let t_136 = (-c_4).mul_add(t_132, s_4 * t_7);
        let t_137 = real(0.316).mul_add(t_136, real(0.0825) * t_133);
        let t_138 = t_135 + t_137;
        let t_139 = (-s_3).mul_add(t_138, c_3 * t_131);
        let t_140 = (-c_4).mul_add(t_129, t_128);
        let t_141 = (-s_4).mul_add(t_126, t_140);
        let t_142 = s_2.mul_add(t_139, c_2 * t_141);
        let t_143 = real(0.006684151967360946) - t_18;
        let t_144 = real(0.384).mul_add(t_1, c_6 * t_30);
        let t_145 = s_6.mul_add(t_143, -t_144);
        let t_146 = c_6 * t_5;
        let t_147 = real(0.384).mul_add(t_146, -t_41);
        let t_148 = c_5.mul_add(t_145, s_5 * t_147);
        let t_149 = c_6.mul_add(t_143, s_6 * t_30);
        let t_150 = (-s_5).mul_add(t_146, c_5 * t_1);
        let t_151 = real(0.0825) * t_150;
        let t_152 = t_149 + t_151;
        let t_153 = (-s_4).mul_add(t_152, real(0.316) * t_150);
        let t_154 = (-c_4).mul_add(t_148, t_153);
        let t_155 = c_5.mul_add(t_146, s_5 * t_1);
        let t_156 = s_6 * t_5;
        let t_157 = s_4.mul_add(t_155, c_4 * t_156);
        let t_158 = c_5.mul_add(t_147, real(0.0825) * t_156);
        let t_159 = (-s_5).mul_add(t_145, t_158);
        let t_160 = (-s_4).mul_add(t_156, c_4 * t_155);
        let t_161 = real(-0.0825).mul_add(t_157, real(0.316) * t_160);
        let t_162 = t_159 + t_161;
        let t_163 = (-s_3).mul_add(t_162, c_3 * t_154);
        let t_164 = (-c_4).mul_add(t_152, t_151);
        let t_165 = s_4.mul_add(t_148, t_164);
        let t_166 = s_2.mul_add(t_163, c_2 * t_165);
        let t_167 = real(1.1168423647533403) + t_52;
        let t_168 = t_167 - t_87;
        let t_169 = (-c_3).mul_add(t_51, s_3 * t_82);
        let t_170 = (-c_3).mul_add(t_120, s_3 * t_118);
        let t_171 = c_3.mul_add(t_138, s_3 * t_131);
        let t_172 = c_3.mul_add(t_162, s_3 * t_154);
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([
                [t_107, -t_112, t_113, t_115, t_124, t_142, t_166],
                [-t_112, t_168, -t_110, t_169, t_170, -t_171, -t_172],
                [t_113, -t_110, t_90, t_99, t_123, t_141, t_165],
                [t_115, t_169, t_99, -t_50, t_80, t_135, t_159],
                [t_124, t_170, t_123, t_80, t_54, t_62, -t_149],
                [t_142, -t_171, t_141, t_135, t_62, t_23, -t_41],
                [t_166, -t_172, t_165, t_159, -t_149, -t_41, real(0.006684151967360946)],
            ]),
        )
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::CoriolisVector<7> for Panda {
    const WORK: u32 = 754;

    #[inline]
    fn coriolis_vector<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 7>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 7>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 7> {
        Self::coriolis_vector(self, q, qd)
    }

    #[inline(always)]
    fn coriolis_vector_at<T: ::robot_dynamics::Scalar>(
        &self,
        sines: &impl ::robot_dynamics::Inputs<T>,
        q: &::robot_dynamics::nalgebra::SVector<T, 7>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 7>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 7> {
        let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
        let [(s_2, c_2), (s_3, c_3), (s_4, c_4), (s_5, c_5), (s_6, c_6), (s_7, c_7)] = ::robot_dynamics::Inputs::sin_cos(
            sines,
            [1, 2, 3, 4, 5, 6],
            [
                q.data.0[0][1],
                q.data.0[0][2],
                q.data.0[0][3],
                q.data.0[0][4],
                q.data.0[0][5],
                q.data.0[0][6],
            ],
        );
        let qd_1 = qd.data.0[0][0];
        let qd_2 = qd.data.0[0][1];
        let qd_3 = qd.data.0[0][2];
        let qd_4 = qd.data.0[0][3];
        let qd_5 = qd.data.0[0][4];
        let qd_6 = qd.data.0[0][5];
        let qd_7 = qd.data.0[0][6];
        let t_1 = real(-0.00796671776787104)
            .mul_add(c_2, real(1.0706865997634767) * s_2);
        let t_2 = c_2.mul_add(t_1, real(0.00398335888393552));
        let t_3 = qd_1 * qd_2;
        let t_4 = t_3 + t_3;
        let t_5 = real(-0.01026110182100817)
            .mul_add(c_2, real(0.0007689361029464) * s_2);
        let t_6 = qd_2 * qd_2;
        let t_7 = c_2 * t_3;
        let t_8 = qd_1 * s_2;
        let t_9 = s_3.mul_add(t_8, qd_2 * c_3);
        let t_10 = (-c_3).mul_add(t_7, qd_3 * t_9);
        let t_11 = qd_1.mul_add(c_2, qd_3);
        let t_12 = t_9 * t_11;
        let t_13 = (-qd_2).mul_add(s_3, c_3 * t_8);
        let t_14 = qd_3.mul_add(t_13, s_3 * t_7);
        let t_15 = t_13 * t_11;
        let t_16 = t_15 + t_14;
        let t_17 = s_2 * t_3;
        let t_18 = t_13 * t_9;
        let t_19 = t_17 + t_18;
        let t_20 = t_9 * t_9;
        let t_21 = t_11 * t_11;
        let t_22 = t_21 - t_20;
        let t_23 = s_4.mul_add(t_13, c_4 * t_11);
        let t_24 = (-s_4).mul_add(t_17, c_4 * t_10);
        let t_25 = qd_4.mul_add(t_23, t_24);
        let t_26 = t_9 - qd_4;
        let t_27 = t_23 * t_26;
        let t_28 = (-c_4).mul_add(t_13, s_4 * t_11);
        let t_29 = s_4.mul_add(t_10, c_4 * t_17);
        let t_30 = qd_4.mul_add(t_28, t_29);
        let t_31 = t_28 * t_26;
        let t_32 = t_31 - t_30;
        let t_33 = t_28 * t_23;
        let t_34 = t_14 - t_33;
        let t_35 = t_23 * t_23;
        let t_36 = t_26 * t_26;
        let t_37 = t_35 - t_36;
        let t_38 = t_12 - t_10;
        let t_39 = real(-0.316).mul_add(t_38, real(0.0825) * t_19);
        let t_40 = (-s_5).mul_add(t_28, c_5 * t_26);
        let t_41 = qd_5.mul_add(t_40, s_5 * t_14);
        let t_42 = c_5.mul_add(t_25, t_41);
        let t_43 = qd_5 + t_23;
        let t_44 = t_40 * t_43;
        let t_45 = c_5.mul_add(t_28, s_5 * t_26);
        let t_46 = (-c_5).mul_add(t_14, qd_5 * t_45);
        let t_47 = s_5.mul_add(t_25, t_46);
        let t_48 = t_45 * t_43;
        let t_49 = t_48 + t_47;
        let t_50 = t_45 * t_40;
        let t_51 = t_50 - t_30;
        let t_52 = t_40 * t_40;
        let t_53 = t_43 * t_43;
        let t_54 = t_52 - t_53;
        let t_55 = t_13 * t_13;
        let t_56 = t_55 + t_20;
        let t_57 = real(0.0825).mul_add(t_16, real(0.316) * t_56);
        let t_58 = t_21 + t_20;
        let t_59 = t_14 - t_15;
        let t_60 = real(-0.316).mul_add(t_59, real(0.0825) * t_58);
        let t_61 = (-s_4).mul_add(t_60, c_4 * t_57);
        let t_62 = real(0.0825).mul_add(t_34, -t_61);
        let t_63 = (-c_6).mul_add(t_43, s_6 * t_45);
        let t_64 = qd_6.mul_add(t_63, s_6 * t_30);
        let t_65 = (-c_6).mul_add(t_42, t_64);
        let t_66 = t_40 - qd_6;
        let t_67 = t_63 * t_66;
        let t_68 = c_6.mul_add(t_45, s_6 * t_43);
        let t_69 = qd_6.mul_add(t_68, c_6 * t_30);
        let t_70 = s_6.mul_add(t_42, t_69);
        let t_71 = t_68 * t_66;
        let t_72 = t_70 - t_71;
        let t_73 = t_68 * t_63;
        let t_74 = t_73 - t_47;
        let t_75 = t_63 * t_63;
        let t_76 = t_66 * t_66;
        let t_77 = t_75 - t_76;
        let t_78 = real(0.0825).mul_add(t_32, t_39);
        let t_79 = s_4.mul_add(t_57, c_4 * t_60);
        let t_80 = t_36 + t_35;
        let t_81 = real(-0.0825).mul_add(t_80, t_79);
        let t_82 = (-c_5).mul_add(t_78, s_5 * t_81);
        let t_83 = t_42 - t_44;
        let t_84 = real(-0.384).mul_add(t_83, t_82);
        let t_85 = real(0.000782782563368496)
            .mul_add(c_7, real(0.00242094377852123) * s_7);
        let t_86 = s_7 * t_85;
        let t_87 = real(0.00242094377852123) - t_86;
        let t_88 = t_67 - t_65;
        let t_89 = qd_7 + t_63;
        let t_90 = t_66 * t_89;
        let t_91 = t_90 - t_88;
        let t_92 = t_86 - real(0.006684151967360946);
        let t_93 = c_7.mul_add(t_85, -real(0.000391391281684248));
        let t_94 = t_68 * t_89;
        let t_95 = t_73 + t_47;
        let t_96 = t_94 - t_95;
        let t_97 = t_94 + t_96;
        let t_98 = real(-0.0012555365982728983)
            .mul_add(s_7, real(0.0009653051699191118) * c_7);
        let t_99 = real(0.0012555365982728983)
            .mul_add(c_7, real(0.0009653051699191118) * s_7);
        let t_100 = t_89 * t_89;
        let t_101 = t_76 - t_100;
        let t_102 = real(0.002034439958661797)
            .mul_add(c_7, real(0.002573605371338203) * s_7);
        let t_103 = t_28 * t_28;
        let t_104 = t_36 + t_103;
        let t_105 = real(0.384).mul_add(t_104, -t_62);
        let t_106 = c_5.mul_add(t_81, s_5 * t_78);
        let t_107 = t_47 - t_48;
        let t_108 = real(0.384).mul_add(t_107, t_106);
        let t_109 = (-c_6).mul_add(t_105, s_6 * t_108);
        let t_110 = real(0.088).mul_add(t_74, -t_109);
        let t_111 = real(0.000093569097314605)
            .mul_add(t_77, real(0.05258828201066731) * t_67);
        let t_112 = real(0.000103758917218685).mul_add(t_74, t_90 * t_92);
        let t_113 = real(-0.009543771269492195).mul_add(t_65, t_111);
        let t_114 = real(0.014748570382675316).mul_add(t_72, t_99 * t_101);
        let t_115 = (-t_98).mul_add(t_72, t_112);
        let t_116 = (-t_93).mul_add(t_97, t_113);
        let t_117 = t_87.mul_add(t_91, t_114);
        let t_118 = real(0.173804705569).mul_add(t_84, t_115);
        let t_119 = t_116 - t_117;
        let t_120 = t_118 + t_119;
        let t_121 = t_102.mul_add(t_110, t_120);
        let t_122 = t_68 * t_68;
        let t_123 = t_122 - t_76;
        let t_124 = t_86 - t_87;
        let t_125 = real(-0.002573605371338203)
            .mul_add(c_7, real(0.002034439958661797) * s_7);
        let t_126 = real(-0.088).mul_add(t_72, t_84);
        let t_127 = c_6.mul_add(t_108, s_6 * t_105);
        let t_128 = t_76 + t_75;
        let t_129 = real(0.088).mul_add(t_128, t_127);
        let t_130 = (-t_71).mul_add(t_124, t_93 * t_123);
        let t_131 = (-t_99).mul_add(t_95, t_130);
        let t_132 = (-t_98).mul_add(t_88, real(0.006684151967360946) * t_70);
        let t_133 = t_131 + t_132;
        let t_134 = t_125.mul_add(t_126, t_133);
        let t_135 = t_102.mul_add(t_129, t_134);
        let t_136 = t_122 + t_100;
        let t_137 = t_125.mul_add(t_72, t_102 * t_136);
        let t_138 = real(0.000103758917218685)
            .mul_add(t_123, real(0.04304451074117511) * t_71);
        let t_139 = real(0.000093569097314605).mul_add(t_95, t_138);
        let t_140 = real(0.014748570382675316).mul_add(t_88, t_139);
        let t_141 = real(0.088).mul_add(t_137, t_140);
        let t_142 = real(0.231847552695).mul_add(t_84, t_141);
        let t_143 = t_142 - t_135;
        let t_144 = real(-0.231847552695).mul_add(t_72, real(0.173804705569) * t_88);
        let t_145 = t_137 + t_144;
        let t_146 = real(0.001026787777028894)
            .mul_add(t_51, real(0.033018599263935515) * t_44);
        let t_147 = real(-0.02389827041510187)
            .mul_add(t_54, real(0.030116287133882085) * t_42);
        let t_148 = real(0.00151524447332703).mul_add(t_49, t_146);
        let t_149 = real(0.067870631425).mul_add(t_62, t_147);
        let t_150 = t_148 + t_149;
        let t_151 = real(-0.384).mul_add(t_145, t_150);
        let t_152 = c_6.mul_add(t_121, t_151);
        let t_153 = (-s_6).mul_add(t_143, t_152);
        let t_154 = t_30 + t_50;
        let t_155 = t_44 + t_42;
        let t_156 = t_45 * t_45;
        let t_157 = t_53 - t_156;
        let t_158 = t_67 + t_65;
        let t_159 = t_71 + t_70;
        let t_160 = t_122 - t_75;
        let t_161 = real(0.004263208188839716) + t_86;
        let t_162 = t_90 + t_91;
        let t_163 = t_100 - t_122;
        let t_164 = t_102.mul_add(t_162, t_125 * t_97);
        let t_165 = real(0.05258828201066731)
            .mul_add(t_47, real(0.009543771269492195) * t_73);
        let t_166 = (-t_94).mul_add(t_161, real(0.014748570382675316) * t_160);
        let t_167 = (-t_98).mul_add(t_163, t_165);
        let t_168 = (-t_86).mul_add(t_96, t_166);
        let t_169 = (-t_99).mul_add(t_159, t_167);
        let t_170 = real(-0.000093569097314605)
            .mul_add(t_159, real(0.000103758917218685) * t_158);
        let t_171 = (-t_93).mul_add(t_162, t_168);
        let t_172 = t_169 + t_170;
        let t_173 = real(0.088).mul_add(t_164, t_171);
        let t_174 = real(-0.173804705569).mul_add(t_127, t_172);
        let t_175 = real(0.231847552695).mul_add(t_109, t_173);
        let t_176 = t_125.mul_add(t_110, t_174);
        let t_177 = t_175 + t_176;
        let t_178 = t_76 + t_100;
        let t_179 = real(-0.173804705569).mul_add(t_95, real(0.231847552695) * t_128);
        let t_180 = (-t_125).mul_add(t_178, t_102 * t_159);
        let t_181 = t_179 + t_180;
        let t_182 = t_76 + t_122;
        let t_183 = real(-0.231847552695).mul_add(t_74, real(0.173804705569) * t_182);
        let t_184 = t_183 + t_164;
        let t_185 = s_6.mul_add(t_184, c_6 * t_181);
        let t_186 = real(-0.02389827041510187)
            .mul_add(t_154, real(0.002902312130053428) * t_48);
        let t_187 = real(-0.001026787777028894).mul_add(t_157, t_186);
        let t_188 = real(0.00151524447332703).mul_add(t_155, t_187);
        let t_189 = real(-0.014653732538).mul_add(t_62, t_188);
        let t_190 = real(0.384).mul_add(t_185, t_189);
        let t_191 = t_177 + t_190;
        let t_192 = real(0.0039053550262761)
            .mul_add(t_34, real(0.749763367252814) * t_27);
        let t_193 = real(-0.00164448757736927)
            .mul_add(t_37, real(0.647723094939183) * t_25);
        let t_194 = real(2.012523553603).mul_add(t_39, -t_192);
        let t_195 = real(0.16284087268546085).mul_add(t_32, t_193);
        let t_196 = t_194 + t_195;
        let t_197 = s_5.mul_add(t_191, t_196);
        let t_198 = c_5.mul_add(t_153, t_197);
        let t_199 = t_14 + t_33;
        let t_200 = t_27 - t_25;
        let t_201 = t_36 - t_103;
        let t_202 = t_52 - t_156;
        let t_203 = real(0.030116287133882085)
            .mul_add(t_50, real(0.033018599263935515) * t_30);
        let t_204 = real(0.00151524447332703).mul_add(t_202, -t_203);
        let t_205 = real(0.001026787777028894).mul_add(t_83, t_204);
        let t_206 = real(0.02389827041510187).mul_add(t_107, t_205);
        let t_207 = real(-0.014653732538).mul_add(t_82, t_206);
        let t_208 = real(0.067870631425).mul_add(t_106, t_207);
        let t_209 = s_6.mul_add(t_121, t_208);
        let t_210 = c_6.mul_add(t_143, t_209);
        let t_211 = t_53 + t_52;
        let t_212 = real(0.067870631425).mul_add(t_154, real(0.014653732538) * t_211);
        let t_213 = t_185 - t_212;
        let t_214 = t_53 + t_156;
        let t_215 = real(0.067870631425).mul_add(t_214, real(0.014653732538) * t_51);
        let t_216 = t_215 - t_145;
        let t_217 = s_5.mul_add(t_213, c_5 * t_216);
        let t_218 = real(0.00164448757736927)
            .mul_add(t_199, real(0.102040272313631) * t_31);
        let t_219 = real(0.55278027465).mul_add(t_39, real(0.0039053550262761) * t_201);
        let t_220 = real(0.16284087268546085).mul_add(t_200, -t_218);
        let t_221 = t_220 - t_219;
        let t_222 = real(-0.0825).mul_add(t_217, t_221);
        let t_223 = t_222 - t_210;
        let t_224 = real(-2.012523553603).mul_add(t_200, real(0.55278027465) * t_32);
        let t_225 = t_224 + t_217;
        let t_226 = real(0.01159586409516604)
            .mul_add(t_10, real(0.13480070614822143) * t_12);
        let t_227 = real(0.013297019103287584)
            .mul_add(t_22, real(0.24149476342611426) * t_19);
        let t_228 = real(-0.000121912420950744).mul_add(t_16, t_226);
        let t_229 = t_227 + t_228;
        let t_230 = real(0.316).mul_add(t_225, t_229);
        let t_231 = s_4.mul_add(t_223, t_230);
        let t_232 = c_4.mul_add(t_198, t_231);
        let t_233 = t_18 - t_17;
        let t_234 = t_12 + t_10;
        let t_235 = t_55 - t_21;
        let t_236 = t_27 + t_25;
        let t_237 = t_31 + t_30;
        let t_238 = t_35 - t_103;
        let t_239 = real(-0.014653732538).mul_add(t_49, real(0.067870631425) * t_155);
        let t_240 = (-s_6).mul_add(t_181, t_239);
        let t_241 = c_6.mul_add(t_184, t_240);
        let t_242 = real(0.647723094939183)
            .mul_add(t_33, real(0.749763367252814) * t_14);
        let t_243 = real(0.16284087268546085).mul_add(t_238, t_242);
        let t_244 = real(-0.0039053550262761).mul_add(t_236, t_243);
        let t_245 = real(-0.00164448757736927).mul_add(t_237, t_244);
        let t_246 = real(-0.55278027465).mul_add(t_61, t_245);
        let t_247 = real(-2.012523553603).mul_add(t_79, t_246);
        let t_248 = real(0.0825).mul_add(t_241, t_247);
        let t_249 = (-c_5).mul_add(t_191, t_248);
        let t_250 = s_5.mul_add(t_153, t_249);
        let t_251 = real(2.012523553603).mul_add(t_199, real(0.55278027465) * t_80);
        let t_252 = s_5.mul_add(t_216, t_251);
        let t_253 = (-c_5).mul_add(t_213, t_252);
        let t_254 = real(-2.012523553603).mul_add(t_104, real(0.55278027465) * t_34);
        let t_255 = t_254 + t_241;
        let t_256 = (-s_4).mul_add(t_255, c_4 * t_253);
        let t_257 = s_4.mul_add(t_253, c_4 * t_255);
        let t_258 = real(0.24149476342611426)
            .mul_add(t_235, real(0.12320484205305539) * t_15);
        let t_259 = real(0.000121912420950744)
            .mul_add(t_234, real(0.013297019103287584) * t_233);
        let t_260 = t_258 - t_259;
        let t_261 = real(0.316).mul_add(t_256, t_260);
        let t_262 = real(-0.0825).mul_add(t_257, t_250);
        let t_263 = t_261 + t_262;
        let t_264 = (-s_3).mul_add(t_263, c_3 * t_232);
        let t_265 = t_55 - t_20;
        let t_266 = real(-0.01159586409516604)
            .mul_add(t_18, real(0.13480070614822143) * t_17);
        let t_267 = real(0.000121912420950744).mul_add(t_265, t_266);
        let t_268 = real(-0.24149476342611426)
            .mul_add(t_38, real(0.013297019103287584) * t_59);
        let t_269 = t_267 + t_268;
        let t_270 = real(0.0825).mul_add(t_225, t_269);
        let t_271 = c_4.mul_add(t_223, t_270);
        let t_272 = s_4.mul_add(t_198, -t_271);
        let t_273 = t_2.mul_add(t_4, t_5 * t_6);
        let t_274 = c_2.mul_add(t_272, t_273);
        let t_275 = (-s_2).mul_add(t_264, t_274);
        let t_276 = qd_1 * qd_1;
        let t_277 = (-t_2).mul_add(t_276, s_3 * t_232);
        let t_278 = c_3.mul_add(t_263, t_277);
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([
                [t_275, t_278, t_272, -t_250, t_210, t_177, t_135],
            ]),
        )
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::GravityVector<7> for Panda {
    const WORK: u32 = 314;

    #[inline]
    fn gravity_vector<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 7>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 7> {
        Self::gravity_vector(self, q)
    }

    #[inline(always)]
    fn gravity_vector_at<T: ::robot_dynamics::Scalar>(
        &self,
        sines: &impl ::robot_dynamics::Inputs<T>,
        q: &::robot_dynamics::nalgebra::SVector<T, 7>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 7> {
        let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
        let [(s_2, c_2), (s_3, c_3), (s_4, c_4), (s_5, c_5), (s_6, c_6), (s_7, c_7)] = ::robot_dynamics::Inputs::sin_cos(
            sines,
            [1, 2, 3, 4, 5, 6],
            [
                q.data.0[0][1],
                q.data.0[0][2],
                q.data.0[0][3],
                q.data.0[0][4],
                q.data.0[0][5],
                q.data.0[0][6],
            ],
        );
        let t_1 = real(-0.7905019088470214).mul_add(s_7, c_7);
        let t_2 = real(0.025247068692827772) * t_1;
        let t_3 = real(2.27442449193795) + t_2;
        let t_4 = real(-1.70502416163189).mul_add(s_6, real(0.14375311619778));
        let t_5 = (-c_6).mul_add(t_3, t_4);
        let t_6 = real(0.7905019088470214).mul_add(c_7, s_7);
        let t_7 = real(0.025247068692827772) * t_6;
        let t_8 = t_7 - real(0.66581089427925);
        let t_9 = s_5.mul_add(t_8, -real(5.4227744943165));
        let t_10 = (-c_5).mul_add(t_5, t_9);
        let t_11 = real(-1.70502416163189).mul_add(c_6, real(19.74285606084543));
        let t_12 = s_6.mul_add(t_3, t_11);
        let t_13 = s_4.mul_add(t_12, -real(7.32667658634432));
        let t_14 = (-c_4).mul_add(t_10, t_13);
        let t_15 = (-c_5).mul_add(t_8, real(0.27690780075318));
        let t_16 = (-s_5).mul_add(t_5, t_15);
        let t_17 = s_3.mul_add(t_16, real(0.01993386669246));
        let t_18 = c_3.mul_add(t_14, t_17);
        let t_19 = c_4.mul_add(t_12, real(32.80954542685272));
        let t_20 = s_4.mul_add(t_10, t_19);
        let t_21 = (-s_2).mul_add(t_20, c_2 * t_18);
        let t_22 = s_2 * c_3;
        let t_23 = s_2 * s_3;
        let t_24 = (-t_14).mul_add(t_23, t_16 * t_22);
        let t_25 = (-c_2).mul_add(s_4, c_4 * t_22);
        let t_26 = s_4.mul_add(t_22, c_2 * c_4);
        let t_27 = t_10.mul_add(t_26, t_12 * t_25);
        let t_28 = (-c_5).mul_add(t_25, s_5 * t_23);
        let t_29 = s_5.mul_add(t_25, c_5 * t_23);
        let t_30 = (-t_5).mul_add(t_29, t_8 * t_28);
        let t_31 = c_6.mul_add(t_28, s_6 * t_26);
        let t_32 = (-s_6).mul_add(t_28, c_6 * t_26);
        let t_33 = t_3.mul_add(t_32, real(1.70502416163189) * t_31);
        let t_34 = t_7.mul_add(t_31, t_2 * t_29);
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([
                [real(0.0), t_21, t_24, t_27, t_30, t_33, -t_34],
            ]),
        )
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::InverseDynamics<7> for Panda {
    const WORK: u32 = 815;

    #[inline]
    fn inverse_dynamics<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 7>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 7>,
        qdd: &::robot_dynamics::nalgebra::SVector<T, 7>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 7> {
        Self::inverse_dynamics(self, q, qd, qdd)
    }

    #[inline(always)]
    fn inverse_dynamics_at<T: ::robot_dynamics::Scalar>(
        &self,
        sines: &impl ::robot_dynamics::Inputs<T>,
        q: &::robot_dynamics::nalgebra::SVector<T, 7>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 7>,
        qdd: &::robot_dynamics::nalgebra::SVector<T, 7>,
    ) -> ::robot_dynamics::nalgebra::SVector<T, 7> {
        let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
        let [(s_2, c_2), (s_3, c_3), (s_4, c_4), (s_5, c_5), (s_6, c_6), (s_7, c_7)] = ::robot_dynamics::Inputs::sin_cos(
            sines,
            [1, 2, 3, 4, 5, 6],
            [
                q.data.0[0][1],
                q.data.0[0][2],
                q.data.0[0][3],
                q.data.0[0][4],
                q.data.0[0][5],
                q.data.0[0][6],
            ],
        );
        let qd_1 = qd.data.0[0][0];
        let qd_2 = qd.data.0[0][1];
        let qd_3 = qd.data.0[0][2];
        let qd_4 = qd.data.0[0][3];
        let qd_5 = qd.data.0[0][4];
        let qd_6 = qd.data.0[0][5];
        let qd_7 = qd.data.0[0][6];
        let qdd_1 = qdd.data.0[0][0];
        let qdd_2 = qdd.data.0[0][1];
        let qdd_3 = qdd.data.0[0][2];
        let qdd_4 = qdd.data.0[0][3];
        let qdd_5 = qdd.data.0[0][4];
        let qdd_6 = qdd.data.0[0][5];
        let qdd_7 = qdd.data.0[0][6];
        let t_1 = qd_1 * qd_2;
        let t_2 = s_2.mul_add(t_1, -qdd_3);
        let t_3 = (-qdd_1).mul_add(c_2, t_2);
        let t_4 = qdd_1 * s_2;
        let t_5 = c_2.mul_add(t_1, t_4);
        let t_6 = qd_1 * s_2;
        let t_7 = s_3.mul_add(t_6, qd_2 * c_3);
        let t_8 = (-c_3).mul_add(t_5, qdd_2 * s_3);
        let t_9 = qd_3.mul_add(t_7, t_8);
        let t_10 = (-qd_2).mul_add(s_3, c_3 * t_6);
        let t_11 = qd_1.mul_add(c_2, qd_3);
        let t_12 = (-c_4).mul_add(t_10, s_4 * t_11);
        let t_13 = qd_4.mul_add(t_12, c_4 * t_3);
        let t_14 = s_4.mul_add(t_9, t_13);
        let t_15 = t_7 - qd_4;
        let t_16 = t_12 * t_15;
        let t_17 = t_16 - t_14;
        let t_18 = s_4.mul_add(t_10, c_4 * t_11);
        let t_19 = (-qd_4).mul_add(t_18, s_4 * t_3);
        let t_20 = (-c_4).mul_add(t_9, t_19);
        let t_21 = t_18 * t_15;
        let t_22 = t_21 + t_20;
        let t_23 = (-s_5).mul_add(t_12, c_5 * t_15);
        let t_24 = t_23 * t_23;
        let t_25 = qd_5 + t_18;
        let t_26 = t_25 * t_25;
        let t_27 = t_26 + t_24;
        let t_28 = t_14 - qdd_5;
        let t_29 = c_5.mul_add(t_12, s_5 * t_15);
        let t_30 = t_29 * t_23;
        let t_31 = t_30 + t_28;
        let t_32 = real(0.002034439958661797)
            .mul_add(c_7, real(0.002573605371338203) * s_7);
        let t_33 = c_6.mul_add(t_29, s_6 * t_25);
        let t_34 = t_23 - qd_6;
        let t_35 = t_33 * t_34;
        let t_36 = s_3.mul_add(t_5, qdd_2 * c_3);
        let t_37 = qd_3.mul_add(t_10, t_36);
        let t_38 = t_37 - qdd_4;
        let t_39 = s_5.mul_add(t_38, qd_5 * t_23);
        let t_40 = (-c_5).mul_add(t_20, t_39);
        let t_41 = c_6.mul_add(t_28, qd_6 * t_33);
        let t_42 = s_6.mul_add(t_40, t_41);
        let t_43 = qdd_7 + t_42;
        let t_44 = t_35 + t_43;
        let t_45 = (-c_6).mul_add(t_25, s_6 * t_29);
        let t_46 = t_45 * t_45;
        let t_47 = t_34 * t_34;
        let t_48 = t_47 + t_46;
        let t_49 = (-c_5).mul_add(t_38, qd_5 * t_29);
        let t_50 = (-s_5).mul_add(t_20, t_49);
        let t_51 = qdd_6 + t_50;
        let t_52 = t_33 * t_45;
        let t_53 = t_52 + t_51;
        let t_54 = real(-0.002573605371338203)
            .mul_add(c_7, real(0.002034439958661797) * s_7);
        let t_55 = qd_7 + t_45;
        let t_56 = t_55 * t_55;
        let t_57 = t_47 + t_56;
        let t_58 = (-t_54).mul_add(t_57, real(0.231847552695) * t_48);
        let t_59 = real(-0.173804705569).mul_add(t_53, t_58);
        let t_60 = t_32.mul_add(t_44, t_59);
        let t_61 = t_51 - t_52;
        let t_62 = t_33 * t_33;
        let t_63 = t_47 + t_62;
        let t_64 = t_33 * t_55;
        let t_65 = t_64 - t_53;
        let t_66 = t_64 + t_65;
        let t_67 = s_6.mul_add(t_28, qd_6 * t_45);
        let t_68 = (-c_6).mul_add(t_40, t_67);
        let t_69 = t_45 * t_34;
        let t_70 = t_69 - t_68;
        let t_71 = t_34 * t_55;
        let t_72 = t_71 - t_70;
        let t_73 = t_71 + t_72;
        let t_74 = t_32.mul_add(t_73, t_54 * t_66);
        let t_75 = real(0.231847552695).mul_add(t_61, real(0.173804705569) * t_63);
        let t_76 = t_75 + t_74;
        let t_77 = s_6.mul_add(t_76, c_6 * t_60);
        let t_78 = real(0.067870631425).mul_add(t_31, real(0.014653732538) * t_27);
        let t_79 = t_77 - t_78;
        let t_80 = t_28 - t_30;
        let t_81 = t_29 * t_29;
        let t_82 = t_26 + t_81;
        let t_83 = t_42 - t_35;
        let t_84 = t_35 - t_43;
        let t_85 = t_62 + t_56;
        let t_86 = (-t_54).mul_add(t_84, t_32 * t_85);
        let t_87 = real(-0.231847552695).mul_add(t_83, real(0.173804705569) * t_70);
        let t_88 = t_86 + t_87;
        let t_89 = real(-0.067870631425).mul_add(t_82, real(0.014653732538) * t_80);
        let t_90 = t_89 + t_88;
        let t_91 = (-s_5).mul_add(t_79, c_5 * t_90);
        let t_92 = real(-0.55278027465).mul_add(t_17, real(2.012523553603) * t_22);
        let t_93 = t_92 + t_91;
        let t_94 = t_12 * t_18;
        let t_95 = t_94 + t_38;
        let t_96 = t_12 * t_12;
        let t_97 = t_15 * t_15;
        let t_98 = t_97 - t_96;
        let t_99 = t_7 * t_11;
        let t_100 = t_9 - t_99;
        let t_101 = real(9.81) * s_2;
        let t_102 = s_3 * t_101;
        let t_103 = t_10 * t_7;
        let t_104 = t_3 + t_103;
        let t_105 = real(-0.0825).mul_add(t_104, t_102);
        let t_106 = real(-0.316).mul_add(t_100, t_105);
        let t_107 = t_62 - t_47;
        let t_108 = real(-0.0825).mul_add(t_17, t_106);
        let t_109 = t_10 * t_11;
        let t_110 = t_37 - t_109;
        let t_111 = c_3 * t_101;
        let t_112 = t_7 * t_7;
        let t_113 = t_11 * t_11;
        let t_114 = t_113 + t_112;
        let t_115 = real(0.0825).mul_add(t_114, t_111);
        let t_116 = real(0.316).mul_add(t_110, -t_115);
        let t_117 = t_10 * t_10;
        let t_118 = t_117 + t_112;
        let t_119 = t_109 + t_37;
        let t_120 = real(-9.81).mul_add(c_2, real(0.316) * t_118);
        let t_121 = real(0.0825).mul_add(t_119, t_120);
        let t_122 = (-c_4).mul_add(t_116, s_4 * t_121);
        let t_123 = t_18 * t_18;
        let t_124 = t_97 + t_123;
        let t_125 = real(-0.0825).mul_add(t_124, t_122);
        let t_126 = s_5.mul_add(t_125, c_5 * t_108);
        let t_127 = t_23 * t_25;
        let t_128 = t_40 - t_127;
        let t_129 = real(0.384).mul_add(t_128, -t_126);
        let t_130 = (-c_5).mul_add(t_125, s_5 * t_108);
        let t_131 = t_29 * t_25;
        let t_132 = t_50 - t_131;
        let t_133 = real(-0.384).mul_add(t_132, t_130);
        let t_134 = s_4.mul_add(t_116, c_4 * t_121);
        let t_135 = t_38 - t_94;
        let t_136 = real(-0.0825).mul_add(t_135, t_134);
        let t_137 = t_97 + t_96;
        let t_138 = real(0.384).mul_add(t_137, t_136);
        let t_139 = (-s_6).mul_add(t_138, c_6 * t_133);
        let t_140 = real(-0.088).mul_add(t_48, t_139);
        let t_141 = real(0.000782782563368496)
            .mul_add(c_7, real(0.00242094377852123) * s_7);
        let t_142 = s_7 * t_141;
        let t_143 = real(0.00242094377852123) - t_142;
        let t_144 = t_142 - t_143;
        let t_145 = real(-0.0012555365982728983)
            .mul_add(s_7, real(0.0009653051699191118) * c_7);
        let t_146 = real(0.0012555365982728983)
            .mul_add(c_7, real(0.0009653051699191118) * s_7);
        let t_147 = c_7.mul_add(t_141, -real(0.000391391281684248));
        let t_148 = real(0.088).mul_add(t_83, t_129);
        let t_149 = (-t_147).mul_add(t_107, t_35 * t_144);
        let t_150 = t_146.mul_add(t_53, t_149);
        let t_151 = real(-0.006684151967360946).mul_add(t_43, t_150);
        let t_152 = t_145.mul_add(t_70, t_151);
        let t_153 = t_54.mul_add(t_148, t_152);
        let t_154 = t_32.mul_add(t_140, t_153);
        let t_155 = real(0.000103758917218685)
            .mul_add(t_107, real(0.04304451074117511) * t_35);
        let t_156 = real(0.000093569097314605).mul_add(t_53, t_155);
        let t_157 = real(0.014748570382675316).mul_add(t_70, t_156);
        let t_158 = real(-0.231847552695).mul_add(t_129, t_157);
        let t_159 = real(0.088).mul_add(t_86, t_158);
        let t_160 = t_159 + t_154;
        let t_161 = t_24 - t_81;
        let t_162 = s_6.mul_add(t_133, c_6 * t_138);
        let t_163 = real(0.088).mul_add(t_61, -t_162);
        let t_164 = t_47 - t_56;
        let t_165 = t_142 - real(0.006684151967360946);
        let t_166 = t_46 - t_47;
        let t_167 = t_71.mul_add(t_165, real(0.05258828201066731) * t_69);
        let t_168 = real(-0.000093569097314605).mul_add(t_166, t_146 * t_164);
        let t_169 = real(0.009543771269492195).mul_add(t_68, -t_167);
        let t_170 = real(0.000103758917218685).mul_add(t_61, t_168);
        let t_171 = real(0.014748570382675316).mul_add(t_83, t_169);
        let t_172 = (-t_145).mul_add(t_84, t_170);
        let t_173 = t_143.mul_add(t_72, t_171);
        let t_174 = t_147.mul_add(t_66, t_172);
        let t_175 = real(0.173804705569).mul_add(t_129, t_173);
        let t_176 = t_174 + t_175;
        let t_177 = t_32.mul_add(t_163, t_176);
        let t_178 = real(0.033018599263935515)
            .mul_add(t_28, real(0.030116287133882085) * t_30);
        let t_179 = real(-0.00151524447332703).mul_add(t_161, t_178);
        let t_180 = real(-0.001026787777028894).mul_add(t_128, t_179);
        let t_181 = real(-0.02389827041510187).mul_add(t_132, t_180);
        let t_182 = real(0.067870631425).mul_add(t_130, t_181);
        let t_183 = real(0.014653732538).mul_add(t_126, t_182);
        let t_184 = s_6.mul_add(t_177, t_183);
        let t_185 = (-c_6).mul_add(t_160, t_184);
        let t_186 = real(0.0039053550262761)
            .mul_add(t_98, real(0.102040272313631) * t_16);
        let t_187 = real(0.00164448757736927).mul_add(t_95, t_186);
        let t_188 = real(0.55278027465).mul_add(t_106, -t_187);
        let t_189 = real(0.16284087268546085).mul_add(t_22, t_188);
        let t_190 = real(0.0825).mul_add(t_91, t_189);
        let t_191 = t_185 + t_190;
        let t_192 = t_117 - t_112;
        let t_193 = t_127 + t_40;
        let t_194 = t_26 - t_81;
        let t_195 = t_56 - t_62;
        let t_196 = real(0.004263208188839716) + t_142;
        let t_197 = t_69 + t_68;
        let t_198 = t_35 + t_42;
        let t_199 = t_62 - t_46;
        let t_200 = real(-0.009543771269492195).mul_add(t_52, t_64 * t_196);
        let t_201 = real(-0.014748570382675316).mul_add(t_199, t_145 * t_195);
        let t_202 = real(-0.05258828201066731).mul_add(t_51, t_200);
        let t_203 = real(-0.000103758917218685).mul_add(t_197, t_201);
        let t_204 = real(0.000093569097314605).mul_add(t_198, t_202);
        let t_205 = t_142.mul_add(t_65, t_203);
        let t_206 = t_146.mul_add(t_44, t_204);
        let t_207 = t_147.mul_add(t_73, t_205);
        let t_208 = real(-0.173804705569).mul_add(t_139, t_206);
        let t_209 = real(0.231847552695).mul_add(t_162, t_207);
        let t_210 = real(-0.088).mul_add(t_74, t_208);
        let t_211 = t_54.mul_add(t_163, t_209);
        let t_212 = t_210 + t_211;
        let t_213 = real(-0.001026787777028894)
            .mul_add(t_194, real(0.002902312130053428) * t_131);
        let t_214 = real(-0.02389827041510187).mul_add(t_31, t_213);
        let t_215 = real(0.00151524447332703).mul_add(t_193, t_214);
        let t_216 = real(0.014653732538).mul_add(t_136, t_215);
        let t_217 = real(0.384).mul_add(t_77, t_216);
        let t_218 = t_217 - t_212;
        let t_219 = t_123 - t_97;
        let t_220 = t_131 + t_50;
        let t_221 = t_24 - t_26;
        let t_222 = real(-0.033018599263935515)
            .mul_add(t_127, real(0.02389827041510187) * t_221);
        let t_223 = real(0.001026787777028894).mul_add(t_80, t_222);
        let t_224 = real(-0.030116287133882085).mul_add(t_40, t_223);
        let t_225 = real(-0.00151524447332703)
            .mul_add(t_220, real(0.067870631425) * t_136);
        let t_226 = t_224 + t_225;
        let t_227 = real(0.384).mul_add(t_88, t_226);
        let t_228 = c_6.mul_add(t_177, t_227);
        let t_229 = s_6.mul_add(t_160, t_228);
        let t_230 = real(0.00164448757736927)
            .mul_add(t_219, real(0.749763367252814) * t_21);
        let t_231 = real(0.647723094939183).mul_add(t_20, t_230);
        let t_232 = real(-0.0039053550262761)
            .mul_add(t_135, real(0.16284087268546085) * t_17);
        let t_233 = real(2.012523553603).mul_add(t_106, t_231);
        let t_234 = t_232 - t_233;
        let t_235 = s_5.mul_add(t_218, t_234);
        let t_236 = (-c_5).mul_add(t_229, t_235);
        let t_237 = real(0.746857959872).mul_add(t_102, real(0.028227094878) * t_111);
        let t_238 = real(-0.01159586409516604)
            .mul_add(t_103, real(0.13480070614822143) * t_3);
        let t_239 = real(0.000121912420950744).mul_add(t_192, -t_237);
        let t_240 = t_238 + t_239;
        let t_241 = real(0.24149476342611426).mul_add(t_100, t_240);
        let t_242 = real(0.013297019103287584).mul_add(t_110, t_241);
        let t_243 = real(-0.0825).mul_add(t_93, t_242);
        let t_244 = c_4.mul_add(t_191, t_243);
        let t_245 = (-s_4).mul_add(t_236, t_244);
        let t_246 = t_113 - t_112;
        let t_247 = real(0.13480070614822143)
            .mul_add(t_99, real(0.27690780075318) * c_2);
        let t_248 = real(0.24149476342611426).mul_add(t_104, t_247);
        let t_249 = real(0.01159586409516604)
            .mul_add(t_9, real(0.013297019103287584) * t_246);
        let t_250 = real(0.000121912420950744).mul_add(t_119, -t_248);
        let t_251 = t_250 - t_249;
        let t_252 = real(0.316).mul_add(t_93, t_251);
        let t_253 = (-s_4).mul_add(t_191, t_252);
        let t_254 = (-c_4).mul_add(t_236, t_253);
        let t_255 = real(2.012523553603).mul_add(t_95, real(0.55278027465) * t_124);
        let t_256 = s_5.mul_add(t_90, -t_255);
        let t_257 = c_5.mul_add(t_79, t_256);
        let t_258 = real(-0.067870631425).mul_add(t_193, real(0.014653732538) * t_220);
        let t_259 = s_6.mul_add(t_60, t_258);
        let t_260 = (-c_6).mul_add(t_76, t_259);
        let t_261 = real(-0.55278027465).mul_add(t_135, real(2.012523553603) * t_137);
        let t_262 = t_261 + t_260;
        let t_263 = s_4.mul_add(t_257, c_4 * t_262);
        let t_264 = (-s_4).mul_add(t_262, c_4 * t_257);
        let t_265 = t_103 - t_3;
        let t_266 = t_99 + t_9;
        let t_267 = t_117 - t_113;
        let t_268 = t_20 - t_21;
        let t_269 = t_16 + t_14;
        let t_270 = t_123 - t_96;
        let t_271 = real(0.16284087268546085)
            .mul_add(t_270, real(0.647723094939183) * t_94);
        let t_272 = real(0.749763367252814).mul_add(t_38, t_271);
        let t_273 = real(0.0039053550262761).mul_add(t_268, t_272);
        let t_274 = real(0.00164448757736927).mul_add(t_269, -t_273);
        let t_275 = real(2.012523553603).mul_add(t_122, real(0.55278027465) * t_134);
        let t_276 = t_274 + t_275;
        let t_277 = real(0.0825).mul_add(t_260, t_276);
        let t_278 = c_5.mul_add(t_218, t_277);
        let t_279 = s_5.mul_add(t_229, t_278);
        let t_280 = real(-0.12320484205305539)
            .mul_add(t_109, real(7.32667658634432) * c_2);
        let t_281 = real(0.013297019103287584).mul_add(t_265, t_280);
        let t_282 = real(-0.24149476342611426).mul_add(t_267, t_281);
        let t_283 = real(0.000121912420950744).mul_add(t_266, t_282);
        let t_284 = real(0.316).mul_add(t_264, t_283);
        let t_285 = real(-0.0825).mul_add(t_263, t_279);
        let t_286 = t_284 + t_285;
        let t_287 = (-c_3).mul_add(t_254, s_3 * t_286);
        let t_288 = real(-0.01026110182100817)
            .mul_add(c_2, real(0.0007689361029464) * s_2);
        let t_289 = qd_2 * qd_2;
        let t_290 = real(-0.00796671776787104)
            .mul_add(c_2, real(1.0706865997634767) * s_2);
        let t_291 = c_2.mul_add(t_290, real(0.00398335888393552));
        let t_292 = real(2.0) * t_1;
        let t_293 = real(0.0007689361029464)
            .mul_add(c_2, real(0.01026110182100817) * s_2);
        let t_294 = real(0.03733744848940618).mul_add(qdd_1, real(0.003) * qd_1);
        let t_295 = t_288.mul_add(t_289, t_294);
        let t_296 = (-qdd_2).mul_add(t_293, t_290 * t_4);
        let t_297 = t_291.mul_add(t_292, t_295);
        let t_298 = t_296 + t_297;
        let t_299 = (-c_2).mul_add(t_245, t_298);
        let t_300 = (-s_2).mul_add(t_287, t_299);
        let t_301 = qd_1 * qd_1;
        let t_302 = real(1645.919777283499).mul_add(s_2, -c_2);
        let t_303 = real(1.1168423647533403).mul_add(qdd_2, real(0.003) * qd_2);
        let t_304 = real(-0.01993386669246).mul_add(t_302, t_303);
        let t_305 = (-qdd_1).mul_add(t_293, t_304);
        let t_306 = (-t_291).mul_add(t_301, t_305);
        let t_307 = (-c_3).mul_add(t_286, t_306);
        let t_308 = (-s_3).mul_add(t_254, t_307);
        let t_309 = real(0.003).mul_add(qd_3, -t_245);
        let t_310 = real(0.003).mul_add(qd_4, t_279);
        let t_311 = real(0.003).mul_add(qd_5, -t_185);
        let t_312 = real(0.003).mul_add(qd_6, -t_212);
        let t_313 = real(0.003).mul_add(qd_7, -t_154);
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([
                [t_300, t_308, t_309, t_310, t_311, t_312, t_313],
            ]),
        )
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::ForwardDynamics<7> for Panda {
    const WORK: u32 = 1319;

    #[inline]
    fn forward_dynamics<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 7>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 7>,
        tau: &::robot_dynamics::nalgebra::SVector<T, 7>,
    ) -> ::core::result::Result<
        ::robot_dynamics::nalgebra::SVector<T, 7>,
        ::robot_dynamics::SingularMassMatrix,
    > {
        Self::forward_dynamics(self, q, qd, tau)
    }

    #[inline(always)]
    fn forward_dynamics_at<T: ::robot_dynamics::Scalar>(
        &self,
        sines: &impl ::robot_dynamics::Inputs<T>,
        q: &::robot_dynamics::nalgebra::SVector<T, 7>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 7>,
        tau: &::robot_dynamics::nalgebra::SVector<T, 7>,
    ) -> ::core::result::Result<
        ::robot_dynamics::nalgebra::SVector<T, 7>,
        ::robot_dynamics::SingularMassMatrix,
    > {
        let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
        let [(s_2, c_2), (s_3, c_3), (s_4, c_4), (s_5, c_5), (s_6, c_6), (s_7, c_7)] = ::robot_dynamics::Inputs::sin_cos(
            sines,
            [1, 2, 3, 4, 5, 6],
            [
                q.data.0[0][1],
                q.data.0[0][2],
                q.data.0[0][3],
                q.data.0[0][4],
                q.data.0[0][5],
                q.data.0[0][6],
            ],
        );
        let qd_1 = qd.data.0[0][0];
        let qd_2 = qd.data.0[0][1];
        let qd_3 = qd.data.0[0][2];
        let qd_4 = qd.data.0[0][3];
        let qd_5 = qd.data.0[0][4];
        let qd_6 = qd.data.0[0][5];
        let qd_7 = qd.data.0[0][6];
        let tau_1 = tau.data.0[0][0];
        let tau_2 = tau.data.0[0][1];
        let tau_3 = tau.data.0[0][2];
        let tau_4 = tau.data.0[0][3];
        let tau_5 = tau.data.0[0][4];
        let tau_6 = tau.data.0[0][5];
        let tau_7 = tau.data.0[0][6];
        let (
            t_1,
            t_2,
            t_3,
            t_4,
            t_5,
            t_6,
            t_7,
            t_8,
            t_9,
            t_10,
            t_11,
            t_12,
            t_13,
            t_14,
            t_15,
            t_16,
            t_17,
            t_18,
            t_19,
            t_20,
            t_21,
            t_22,
            t_23,
            t_24,
            t_25,
            t_26,
            t_27,
            t_28,
            t_29,
            t_30,
            t_31,
            t_32,
            t_33,
            t_34,
            t_35,
            t_36,
            t_37,
            t_38,
            t_39,
            t_40,
            t_41,
            t_42,
            t_43,
            t_44,
            t_45,
            t_46,
            t_47,
            t_48,
            t_49,
            t_50,
            t_51,
            t_52,
            t_53,
            t_54,
            t_55,
            t_56,
            t_57,
            t_58,
            t_59,
            t_60,
            t_61,
            t_62,
            t_63,
            t_64,
            t_65,
            t_66,
            t_67,
            t_68,
            t_69,
            t_70,
            t_71,
            t_72,
            t_73,
            t_74,
            t_75,
            t_76,
            t_77,
            t_78,
            t_79,
            t_80,
            t_81,
            t_82,
            t_83,
            t_84,
            t_85,
            t_86,
            t_87,
            t_88,
            t_89,
            t_90,
            t_91,
            t_92,
            t_93,
            t_94,
            t_95,
            t_96,
            t_97,
            t_98,
            t_99,
            t_100,
            t_101,
            t_102,
            t_103,
            t_104,
            t_105,
            t_106,
            t_107,
            t_108,
            t_109,
            t_110,
            t_111,
            t_112,
            t_113,
            t_114,
            t_115,
            t_116,
            t_117,
            t_118,
            t_119,
            t_120,
            t_121,
            t_122,
            t_123,
            t_124,
            t_125,
            t_126,
            t_127,
            t_128,
            t_129,
            t_130,
            t_131,
            t_132,
            t_133,
            t_134,
            t_135,
            t_136,
            t_137,
            t_138,
            t_139,
            t_140,
            t_141,
            t_142,
            t_143,
            t_144,
            t_145,
            t_146,
            t_147,
            t_148,
            t_149,
            t_150,
            t_151,
            t_152,
            t_153,
            t_154,
            t_155,
            t_156,
            t_157,
            t_158,
            t_159,
            t_160,
            t_161,
            t_162,
            t_163,
            t_164,
            t_165,
            t_166,
            t_167,
            t_168,
            t_169,
            t_170,
            t_171,
            t_172,
            t_173,
            t_174,
            t_175,
            t_176,
            t_177,
            t_178,
            t_179,
            t_180,
            t_181,
            t_182,
            t_183,
            t_184,
            t_185,
            t_186,
            t_187,
            t_188,
            t_189,
            t_190,
            t_191,
            t_192,
            t_193,
            t_194,
            t_195,
            t_196,
            t_197,
            t_198,
            t_199,
            t_200,
        ): (
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
        );
        let (
            t_201,
            t_202,
            t_203,
            t_204,
            t_205,
            t_206,
            t_207,
            t_208,
            t_209,
            t_210,
            t_211,
            t_212,
            t_213,
            t_214,
            t_215,
            t_216,
            t_217,
            t_218,
            t_219,
            t_220,
            t_221,
            t_222,
            t_223,
            t_224,
            t_225,
            t_226,
            t_227,
            t_228,
            t_229,
            t_230,
            t_231,
            t_232,
            t_233,
            t_234,
            t_235,
            t_236,
            t_237,
            t_238,
            t_239,
            t_240,
            t_241,
            t_242,
            t_243,
            t_244,
            t_245,
            t_246,
            t_247,
            t_248,
            t_249,
            t_250,
            t_251,
            t_252,
            t_253,
            t_254,
            t_255,
            t_256,
            t_257,
            t_258,
            t_259,
            t_260,
            t_261,
            t_262,
            t_263,
            t_264,
            t_265,
            t_266,
            t_267,
            t_268,
            t_269,
            t_270,
            t_271,
            t_272,
            t_273,
            t_274,
            t_275,
            t_276,
            t_277,
            t_278,
            t_279,
            t_280,
            t_281,
            t_282,
            t_283,
            t_284,
            t_285,
            t_286,
            t_287,
            t_288,
            t_289,
            t_290,
            t_291,
            t_292,
            t_293,
            t_294,
            t_295,
            t_296,
            t_297,
            t_298,
            t_299,
            t_300,
            t_301,
            t_302,
            t_303,
            t_304,
            t_305,
            t_306,
            t_307,
            t_308,
            t_309,
            t_310,
            t_311,
            t_312,
            t_313,
            t_314,
            t_315,
            t_316,
            t_317,
            t_318,
            t_319,
            t_320,
            t_321,
            t_322,
            t_323,
            t_324,
            t_325,
            t_326,
            t_327,
            t_328,
            t_329,
            t_330,
            t_331,
            t_332,
            t_333,
            t_334,
            t_335,
            t_336,
            t_337,
            t_338,
            t_339,
            t_340,
            t_341,
            t_342,
            t_343,
            t_344,
            t_345,
            t_346,
            t_347,
            t_348,
            t_349,
            t_350,
            t_351,
            t_352,
            t_353,
            t_354,
            t_355,
            t_356,
            t_357,
            t_358,
            t_359,
            t_360,
            t_361,
            t_362,
            t_363,
            t_364,
            t_365,
            t_366,
            t_367,
            t_368,
            t_369,
            t_370,
            t_371,
            t_372,
            t_373,
            t_374,
            t_375,
            t_376,
            t_377,
            t_378,
            t_379,
            t_380,
            t_381,
            t_382,
            t_383,
            t_384,
            t_385,
            t_386,
            t_387,
            t_388,
            t_389,
            t_390,
            t_391,
            t_392,
            t_393,
            t_394,
            t_395,
            t_396,
            t_397,
            t_398,
            t_399,
            t_400,
        ): (
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
        );
        let (
            t_401,
            t_402,
            t_403,
            t_404,
            t_405,
            t_406,
            t_407,
            t_408,
            t_409,
            t_410,
            t_411,
            t_412,
            t_413,
            t_414,
            t_415,
            t_416,
            t_417,
            t_418,
            t_419,
            t_420,
            t_421,
            t_422,
            t_423,
            t_424,
            t_425,
            t_426,
            t_427,
            t_428,
            t_429,
            t_430,
            t_431,
            t_432,
            t_433,
            t_434,
            t_435,
            t_436,
            t_437,
            t_438,
            t_439,
            t_440,
            t_441,
            t_442,
            t_443,
            t_444,
            t_445,
            t_446,
            t_447,
            t_448,
            t_449,
            t_450,
            t_451,
            t_452,
            t_453,
            t_454,
            t_455,
            t_456,
            t_457,
            t_458,
            t_459,
            t_460,
            t_461,
            t_462,
            t_463,
            t_464,
            t_465,
            t_466,
            t_467,
            t_468,
            t_469,
            t_470,
            t_471,
            t_472,
            t_473,
            t_474,
            t_475,
            t_476,
            t_477,
            t_478,
            t_479,
            t_480,
            t_481,
            t_482,
            t_483,
            t_484,
            t_485,
            t_486,
            t_487,
            t_488,
            t_489,
            t_490,
            t_491,
            t_492,
            t_493,
            t_494,
            t_495,
            t_496,
            t_497,
            t_498,
            t_499,
            t_500,
            t_501,
            t_502,
            t_503,
            t_504,
            t_505,
            t_506,
            t_507,
            t_508,
            t_509,
            t_510,
            t_511,
            t_512,
            t_513,
            t_514,
            t_515,
            t_516,
            t_517,
            t_518,
            t_519,
            t_520,
            t_521,
            t_522,
            t_523,
            t_524,
            t_525,
            t_526,
            t_527,
            t_528,
            t_529,
            t_530,
            t_531,
            t_532,
            t_533,
            t_534,
            t_535,
            t_536,
            t_537,
            t_538,
            t_539,
            t_540,
            t_541,
            t_542,
            t_543,
            t_544,
            t_545,
            t_546,
            t_547,
            t_548,
            t_549,
            t_550,
            t_551,
            t_552,
            t_553,
            t_554,
            t_555,
            t_556,
            t_557,
            t_558,
            t_559,
            t_560,
            t_561,
            t_562,
            t_563,
            t_564,
            t_565,
            t_566,
            t_567,
            t_568,
            t_569,
            t_570,
            t_571,
            t_572,
            t_573,
            t_574,
            t_575,
            t_576,
            t_577,
            t_578,
            t_579,
            t_580,
            t_581,
            t_582,
            t_583,
            t_584,
            t_585,
            t_586,
            t_587,
            t_588,
            t_589,
            t_590,
            t_591,
            t_592,
            t_593,
            t_594,
        ): (
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
            T,
        );
        t_1 = qd_1 * qd_2;
        t_2 = s_2 * t_1;
        t_3 = c_2 * t_1;
        t_4 = qd_1 * s_2;
        t_5 = s_3.mul_add(t_4, qd_2 * c_3);
        t_6 = (-c_3).mul_add(t_3, qd_3 * t_5);
        t_7 = (-qd_2).mul_add(s_3, c_3 * t_4);
        t_8 = qd_1.mul_add(c_2, qd_3);
        t_9 = (-c_4).mul_add(t_7, s_4 * t_8);
        t_10 = s_4.mul_add(t_6, c_4 * t_2);
        t_11 = qd_4.mul_add(t_9, t_10);
        t_12 = t_5 - qd_4;
        t_13 = t_9 * t_12;
        t_14 = t_13 - t_11;
        t_15 = s_4.mul_add(t_7, c_4 * t_8);
        t_16 = (-s_4).mul_add(t_2, c_4 * t_6);
        t_17 = qd_4.mul_add(t_15, t_16);
        t_18 = t_15 * t_12;
        t_19 = t_18 - t_17;
        t_20 = (-s_5).mul_add(t_9, c_5 * t_12);
        t_21 = t_20 * t_20;
        t_22 = qd_5 + t_15;
        t_23 = t_22 * t_22;
        t_24 = t_23 + t_21;
        t_25 = c_5.mul_add(t_9, s_5 * t_12);
        t_26 = t_25 * t_20;
        t_27 = t_11 + t_26;
        t_28 = real(0.002034439958661797).mul_add(c_7, real(0.002573605371338203) * s_7);
        t_29 = qd_3.mul_add(t_7, s_3 * t_3);
        t_30 = qd_5.mul_add(t_20, s_5 * t_29);
        t_31 = c_5.mul_add(t_17, t_30);
        t_32 = c_6.mul_add(t_25, s_6 * t_22);
        t_33 = qd_6.mul_add(t_32, c_6 * t_11);
        t_34 = s_6.mul_add(t_31, t_33);
        t_35 = t_20 - qd_6;
        t_36 = t_32 * t_35;
        t_37 = t_36 + t_34;
        t_38 = (-c_6).mul_add(t_22, s_6 * t_25);
        t_39 = t_38 * t_38;
        t_40 = t_35 * t_35;
        t_41 = t_40 + t_39;
        t_42 = (-c_5).mul_add(t_29, qd_5 * t_25);
        t_43 = s_5.mul_add(t_17, t_42);
        t_44 = t_32 * t_38;
        t_45 = t_44 + t_43;
        t_46 = real(-0.002573605371338203)
            .mul_add(c_7, real(0.002034439958661797) * s_7);
        t_47 = qd_7 + t_38;
        t_48 = t_47 * t_47;
        t_49 = t_40 + t_48;
        t_50 = real(-0.231847552695).mul_add(t_41, real(0.173804705569) * t_45);
        t_51 = (-t_28).mul_add(t_37, t_46 * t_49);
        t_52 = t_50 + t_51;
        t_53 = t_44 - t_43;
        t_54 = t_32 * t_32;
        t_55 = t_40 + t_54;
        t_56 = t_32 * t_47;
        t_57 = t_56 - t_45;
        t_58 = t_56 + t_57;
        t_59 = qd_6.mul_add(t_38, s_6 * t_11);
        t_60 = (-c_6).mul_add(t_31, t_59);
        t_61 = t_38 * t_35;
        t_62 = t_61 - t_60;
        t_63 = t_35 * t_47;
        t_64 = t_63 - t_62;
        t_65 = t_63 + t_64;
        t_66 = t_28.mul_add(t_65, t_46 * t_58);
        t_67 = real(-0.231847552695).mul_add(t_53, real(0.173804705569) * t_55);
        t_68 = t_67 + t_66;
        t_69 = (-s_6).mul_add(t_68, c_6 * t_52);
        t_70 = real(0.067870631425).mul_add(t_27, real(0.014653732538) * t_24);
        t_71 = t_70 + t_69;
        t_72 = t_26 - t_11;
        t_73 = t_25 * t_25;
        t_74 = t_23 + t_73;
        t_75 = t_34 - t_36;
        t_76 = t_54 + t_48;
        t_77 = t_46.mul_add(t_75, t_28 * t_76);
        t_78 = real(-0.231847552695).mul_add(t_75, real(0.173804705569) * t_62);
        t_79 = t_77 + t_78;
        t_80 = real(0.067870631425).mul_add(t_74, real(0.014653732538) * t_72);
        t_81 = t_80 - t_79;
        t_82 = (-c_5).mul_add(t_81, s_5 * t_71);
        t_83 = real(-0.55278027465).mul_add(t_14, real(2.012523553603) * t_19);
        t_84 = t_83 + t_82;
        t_85 = t_9 * t_15;
        t_86 = t_29 + t_85;
        t_87 = t_9 * t_9;
        t_88 = t_12 * t_12;
        t_89 = t_88 - t_87;
        t_90 = t_5 * t_8;
        t_91 = t_90 - t_6;
        t_92 = real(9.81) * s_2;
        t_93 = s_3 * t_92;
        t_94 = t_7 * t_5;
        t_95 = t_2 + t_94;
        t_96 = real(-0.0825).mul_add(t_95, t_93);
        t_97 = real(0.316).mul_add(t_91, t_96);
        t_98 = t_54 - t_40;
        t_99 = real(-0.0825).mul_add(t_14, t_97);
        t_100 = t_7 * t_8;
        t_101 = t_29 - t_100;
        t_102 = c_3 * t_92;
        t_103 = t_5 * t_5;
        t_104 = t_8 * t_8;
        t_105 = t_104 + t_103;
        t_106 = real(0.0825).mul_add(t_105, t_102);
        t_107 = real(-0.316).mul_add(t_101, t_106);
        t_108 = t_7 * t_7;
        t_109 = t_108 + t_103;
        t_110 = t_100 + t_29;
        t_111 = real(-9.81).mul_add(c_2, real(0.316) * t_109);
        t_112 = real(0.0825).mul_add(t_110, t_111);
        t_113 = s_4.mul_add(t_112, c_4 * t_107);
        t_114 = t_15 * t_15;
        t_115 = t_88 + t_114;
        t_116 = real(-0.0825).mul_add(t_115, t_113);
        t_117 = s_5.mul_add(t_116, c_5 * t_99);
        t_118 = t_20 * t_22;
        t_119 = t_31 - t_118;
        t_120 = real(-0.384).mul_add(t_119, t_117);
        t_121 = (-s_5).mul_add(t_99, c_5 * t_116);
        t_122 = t_25 * t_22;
        t_123 = t_43 - t_122;
        t_124 = real(0.384).mul_add(t_123, t_121);
        t_125 = (-s_4).mul_add(t_107, c_4 * t_112);
        t_126 = t_29 - t_85;
        t_127 = real(0.0825).mul_add(t_126, -t_125);
        t_128 = t_88 + t_87;
        t_129 = real(0.384).mul_add(t_128, -t_127);
        t_130 = c_6.mul_add(t_124, s_6 * t_129);
        t_131 = real(0.088).mul_add(t_41, t_130);
        t_132 = real(0.000782782563368496).mul_add(c_7, real(0.00242094377852123) * s_7);
        t_133 = s_7 * t_132;
        t_134 = real(0.00242094377852123) - t_133;
        t_135 = t_133 - t_134;
        t_136 = real(-0.0012555365982728983)
            .mul_add(s_7, real(0.0009653051699191118) * c_7);
        t_137 = real(0.0012555365982728983)
            .mul_add(c_7, real(0.0009653051699191118) * s_7);
        t_138 = c_7.mul_add(t_132, -real(0.000391391281684248));
        t_139 = real(-0.088).mul_add(t_75, t_120);
        t_140 = (-t_36).mul_add(t_135, t_138 * t_98);
        t_141 = (-t_137).mul_add(t_45, t_140);
        t_142 = (-t_136).mul_add(t_62, real(0.006684151967360946) * t_34);
        t_143 = t_141 + t_142;
        t_144 = t_46.mul_add(t_139, t_143);
        t_145 = t_28.mul_add(t_131, t_144);
        t_146 = real(0.000103758917218685)
            .mul_add(t_98, real(0.05258828201066731) * t_36);
        t_147 = real(0.000093569097314605).mul_add(t_45, t_146);
        t_148 = real(0.014748570382675316)
            .mul_add(t_62, real(0.009543771269492195) * t_34);
        t_149 = real(0.088).mul_add(t_77, t_147);
        t_150 = real(0.231847552695).mul_add(t_120, t_148);
        t_151 = t_149 + t_150;
        t_152 = t_151 - t_145;
        t_153 = t_21 - t_73;
        t_154 = (-c_6).mul_add(t_129, s_6 * t_124);
        t_155 = real(0.088).mul_add(t_53, -t_154);
        t_156 = t_40 - t_48;
        t_157 = t_133 - real(0.006684151967360946);
        t_158 = t_39 - t_40;
        t_159 = t_63.mul_add(t_157, real(0.0621320532801595) * t_61);
        t_160 = real(0.000103758917218685)
            .mul_add(t_53, real(0.000093569097314605) * t_158);
        t_161 = t_137.mul_add(t_156, -t_159);
        t_162 = t_136.mul_add(t_75, -t_160);
        t_163 = real(0.014748570382675316).mul_add(t_75, t_161);
        t_164 = t_134.mul_add(t_64, t_138 * t_58);
        t_165 = t_162 + t_163;
        t_166 = real(-0.173804705569).mul_add(t_120, t_164);
        t_167 = t_165 + t_166;
        t_168 = (-t_28).mul_add(t_155, t_167);
        t_169 = real(0.03966005840337428)
            .mul_add(t_26, real(0.04256237053342771) * t_11);
        t_170 = real(0.00151524447332703).mul_add(t_153, -t_169);
        t_171 = real(0.02389827041510187).mul_add(t_123, t_170);
        t_172 = real(0.001026787777028894).mul_add(t_119, t_171);
        t_173 = real(0.067870631425).mul_add(t_121, t_172);
        t_174 = real(-0.014653732538).mul_add(t_117, t_173);
        t_175 = (-s_6).mul_add(t_168, t_174);
        t_176 = c_6.mul_add(t_152, t_175);
        t_177 = real(0.00164448757736927).mul_add(t_86, real(0.102040272313631) * t_13);
        t_178 = real(0.0039053550262761).mul_add(t_89, t_177);
        t_179 = real(0.16284087268546085).mul_add(t_19, real(0.55278027465) * t_97);
        t_180 = t_178 - t_179;
        t_181 = real(-0.0825).mul_add(t_82, t_180);
        t_182 = t_176 + t_181;
        t_183 = t_108 - t_103;
        t_184 = t_118 + t_31;
        t_185 = t_23 - t_73;
        t_186 = t_48 - t_54;
        t_187 = real(0.004263208188839716) + t_133;
        t_188 = t_61 + t_60;
        t_189 = t_54 - t_39;
        t_190 = real(0.05258828201066731)
            .mul_add(t_43, real(0.009543771269492195) * t_44);
        t_191 = real(-0.014748570382675316).mul_add(t_189, t_56 * t_187);
        t_192 = t_136.mul_add(t_186, -t_190);
        t_193 = t_133.mul_add(t_57, t_191);
        t_194 = t_137.mul_add(t_37, t_192);
        t_195 = real(-0.000103758917218685)
            .mul_add(t_188, real(0.000093569097314605) * t_37);
        t_196 = t_138.mul_add(t_65, t_193);
        t_197 = t_194 + t_195;
        t_198 = real(-0.088).mul_add(t_66, t_196);
        t_199 = real(-0.231847552695).mul_add(t_154, t_197);
        t_200 = real(0.173804705569).mul_add(t_130, t_198);
        t_201 = (-t_46).mul_add(t_155, t_199);
        t_202 = t_200 + t_201;
        t_203 = real(-0.002902312130053428)
            .mul_add(t_122, real(0.02389827041510187) * t_27);
        t_204 = real(0.001026787777028894).mul_add(t_185, t_203);
        t_205 = real(-0.00151524447332703).mul_add(t_184, t_204);
        t_206 = real(0.014653732538).mul_add(t_127, t_205);
        t_207 = real(0.384).mul_add(t_69, t_206);
        t_208 = t_207 + t_202;
        t_209 = t_114 - t_88;
        t_210 = t_122 + t_43;
        t_211 = t_21 - t_23;
        t_212 = real(-0.04256237053342771)
            .mul_add(t_118, real(0.02389827041510187) * t_211);
        t_213 = real(0.03966005840337428)
            .mul_add(t_31, real(0.001026787777028894) * t_72);
        t_214 = real(-0.00151524447332703).mul_add(t_210, t_212);
        t_215 = real(0.067870631425).mul_add(t_127, t_213);
        t_216 = t_214 - t_215;
        t_217 = real(0.384).mul_add(t_79, t_216);
        t_218 = c_6.mul_add(t_168, t_217);
        t_219 = s_6.mul_add(t_152, t_218);
        t_220 = real(0.0039053550262761).mul_add(t_126, real(0.749763367252814) * t_18);
        t_221 = real(-0.647723094939183)
            .mul_add(t_17, real(0.00164448757736927) * t_209);
        t_222 = real(2.012523553603).mul_add(t_97, t_220);
        t_223 = real(-0.16284087268546085).mul_add(t_14, t_221);
        t_224 = t_222 + t_223;
        t_225 = s_5.mul_add(t_208, t_224);
        t_226 = c_5.mul_add(t_219, t_225);
        t_227 = real(-0.028227094878).mul_add(t_102, real(0.13480070614822143) * t_2);
        t_228 = real(-0.746857959872).mul_add(t_93, t_227);
        t_229 = real(-0.01159586409516604)
            .mul_add(t_94, real(0.000121912420950744) * t_183);
        t_230 = real(0.013297019103287584).mul_add(t_101, t_228);
        t_231 = real(-0.24149476342611426).mul_add(t_91, t_229);
        t_232 = t_230 + t_231;
        t_233 = real(-0.0825).mul_add(t_84, t_232);
        t_234 = (-c_4).mul_add(t_182, t_233);
        t_235 = s_4.mul_add(t_226, t_234);
        t_236 = t_104 - t_103;
        t_237 = real(0.13480070614822143).mul_add(t_90, real(0.27690780075318) * c_2);
        t_238 = real(0.01159586409516604).mul_add(t_6, t_237);
        t_239 = real(0.013297019103287584)
            .mul_add(t_236, real(0.24149476342611426) * t_95);
        t_240 = real(0.000121912420950744).mul_add(t_110, -t_238);
        t_241 = t_240 - t_239;
        t_242 = real(0.316).mul_add(t_84, t_241);
        t_243 = s_4.mul_add(t_182, t_242);
        t_244 = c_4.mul_add(t_226, t_243);
        t_245 = real(2.012523553603).mul_add(t_86, real(0.55278027465) * t_115);
        t_246 = s_5.mul_add(t_81, t_245);
        t_247 = c_5.mul_add(t_71, t_246);
        t_248 = real(-0.014653732538).mul_add(t_210, real(0.067870631425) * t_184);
        t_249 = s_6.mul_add(t_52, t_248);
        t_250 = c_6.mul_add(t_68, t_249);
        t_251 = real(-2.012523553603).mul_add(t_128, real(0.55278027465) * t_126);
        t_252 = t_251 + t_250;
        t_253 = s_4.mul_add(t_247, c_4 * t_252);
        t_254 = (-s_4).mul_add(t_252, c_4 * t_247);
        t_255 = t_94 - t_2;
        t_256 = t_90 + t_6;
        t_257 = t_108 - t_104;
        t_258 = t_18 + t_17;
        t_259 = t_13 + t_11;
        t_260 = t_114 - t_87;
        t_261 = real(0.647723094939183).mul_add(t_85, real(0.749763367252814) * t_29);
        t_262 = real(0.16284087268546085).mul_add(t_260, t_261);
        t_263 = real(-0.0039053550262761).mul_add(t_258, t_262);
        t_264 = real(-0.00164448757736927).mul_add(t_259, t_263);
        t_265 = real(-2.012523553603).mul_add(t_113, t_264);
        t_266 = real(-0.55278027465).mul_add(t_125, t_265);
        t_267 = real(0.0825).mul_add(t_250, t_266);
        t_268 = c_5.mul_add(t_208, t_267);
        t_269 = (-s_5).mul_add(t_219, t_268);
        t_270 = real(-7.32667658634432).mul_add(c_2, real(0.12320484205305539) * t_100);
        t_271 = real(0.24149476342611426).mul_add(t_257, t_270);
        t_272 = real(0.000121912420950744)
            .mul_add(t_256, real(0.013297019103287584) * t_255);
        t_273 = t_271 - t_272;
        t_274 = real(0.316).mul_add(t_254, t_273);
        t_275 = real(-0.0825).mul_add(t_253, t_274);
        t_276 = t_269 + t_275;
        t_277 = s_3.mul_add(t_276, c_3 * t_244);
        t_278 = real(-0.01026110182100817).mul_add(c_2, real(0.0007689361029464) * s_2);
        t_279 = qd_2 * qd_2;
        t_280 = real(-0.00796671776787104).mul_add(c_2, real(1.0706865997634767) * s_2);
        t_281 = c_2.mul_add(t_280, real(0.00398335888393552));
        t_282 = real(2.0) * t_1;
        t_283 = real(-0.003).mul_add(qd_7, tau_7);
        t_284 = t_283 - t_145;
        t_285 = real(0.088) * t_46;
        t_286 = real(0.006684151967360946) - t_285;
        t_287 = real(0.384).mul_add(t_46, c_6 * t_136);
        t_288 = s_6.mul_add(t_286, -t_287);
        t_289 = c_6 * t_28;
        t_290 = real(0.384).mul_add(t_289, -t_137);
        t_291 = c_5.mul_add(t_288, s_5 * t_290);
        t_292 = c_6.mul_add(t_286, s_6 * t_136);
        t_293 = (-s_5).mul_add(t_289, c_5 * t_46);
        t_294 = real(0.0825) * t_293;
        t_295 = t_292 + t_294;
        t_296 = (-s_4).mul_add(t_295, real(0.316) * t_293);
        t_297 = (-c_4).mul_add(t_291, t_296);
        t_298 = c_5.mul_add(t_289, s_5 * t_46);
        t_299 = s_6 * t_28;
        t_300 = s_4.mul_add(t_298, c_4 * t_299);
        t_301 = c_5.mul_add(t_290, real(0.0825) * t_299);
        t_302 = (-s_5).mul_add(t_288, t_301);
        t_303 = (-s_4).mul_add(t_299, c_4 * t_298);
        t_304 = real(-0.0825).mul_add(t_300, real(0.316) * t_303);
        t_305 = t_302 + t_304;
        t_306 = (-s_3).mul_add(t_305, c_3 * t_297);
        t_307 = c_4.mul_add(t_295, -t_294);
        t_308 = (-s_4).mul_add(t_291, t_307);
        t_309 = (-c_2).mul_add(t_308, s_2 * t_306);
        t_310 = real(149.60760989322966) * t_309;
        t_311 = real(149.60760989322966) * t_137;
        t_312 = real(-0.003).mul_add(qd_6, tau_6);
        t_313 = t_312 + t_202;
        t_314 = t_284.mul_add(t_311, t_313);
        t_315 = real(0.088).mul_add(t_28, real(0.000103758917218685));
        t_316 = t_315 - t_138;
        t_317 = real(0.000093569097314605) + t_137;
        t_318 = c_6.mul_add(t_316, s_6 * t_317);
        t_319 = real(2.0) * t_285;
        t_320 = real(0.05258828201066731) + t_133;
        t_321 = t_320 - t_319;
        t_322 = t_46 - real(0.231847552695);
        t_323 = s_6.mul_add(t_322, real(0.173804705569) * c_6);
        t_324 = real(0.384) * t_323;
        t_325 = t_321 - t_324;
        t_326 = (-s_5).mul_add(t_325, c_5 * t_318);
        t_327 = (-s_6).mul_add(t_316, c_6 * t_317);
        t_328 = s_5 * t_323;
        t_329 = real(0.0825) * t_328;
        t_330 = t_329 - t_327;
        t_331 = (-s_4).mul_add(t_330, real(0.316) * t_328);
        t_332 = c_4.mul_add(t_326, t_331);
        t_333 = c_5 * t_323;
        t_334 = (-c_6).mul_add(t_322, real(0.173804705569) * s_6);
        t_335 = s_4.mul_add(t_333, c_4 * t_334);
        t_336 = (-s_5).mul_add(t_318, real(0.0825) * t_334);
        t_337 = (-c_5).mul_add(t_325, t_336);
        t_338 = (-c_4).mul_add(t_333, s_4 * t_334);
        t_339 = real(0.316).mul_add(t_338, real(0.0825) * t_335);
        t_340 = t_339 - t_337;
        t_341 = (-s_3).mul_add(t_340, c_3 * t_332);
        t_342 = (-c_4).mul_add(t_330, t_329);
        t_343 = (-s_4).mul_add(t_326, t_342);
        t_344 = s_2.mul_add(t_341, c_2 * t_343);
        t_345 = t_309.mul_add(t_311, t_344);
        t_346 = (-t_137).mul_add(t_311, t_321);
        t_347 = real(1.0) / t_346;
        t_348 = t_345 * t_347;
        t_349 = real(149.60760989322966) * t_292;
        t_350 = (-t_292).mul_add(t_311, t_327);
        t_351 = t_350 * t_347;
        t_352 = real(0.003).mul_add(qd_5, -tau_5);
        t_353 = (-t_284).mul_add(t_349, t_352);
        t_354 = t_353 + t_176;
        t_355 = t_314.mul_add(t_351, t_354);
        t_356 = real(0.00285961930213125) + t_319;
        t_357 = t_134 + t_356;
        t_358 = real(0.014748570382675316) + t_136;
        t_359 = real(2.0) * t_358;
        t_360 = s_6.mul_add(t_357, c_6 * t_359);
        t_361 = real(0.001026787777028894) - t_358;
        t_362 = real(-0.384).mul_add(t_334, t_361);
        t_363 = c_6.mul_add(t_360, t_362);
        t_364 = real(0.384).mul_add(t_28, -real(0.02389827041510187));
        t_365 = t_364 - t_327;
        t_366 = (-c_5).mul_add(t_363, s_5 * t_365);
        t_367 = s_6 * t_360;
        t_368 = real(0.04256237053342771) - t_356;
        t_369 = t_368 + t_367;
        t_370 = real(0.067870631425) - t_28;
        t_371 = t_334 - real(0.014653732538);
        t_372 = (-s_5).mul_add(t_370, c_5 * t_371);
        t_373 = real(0.0825) * t_372;
        t_374 = t_373 - t_369;
        t_375 = c_4.mul_add(t_366, real(0.316) * t_372);
        t_376 = s_4.mul_add(t_374, -t_375);
        t_377 = s_5.mul_add(t_371, c_5 * t_370);
        t_378 = real(0.0825) * t_377;
        t_379 = s_5.mul_add(t_363, c_5 * t_365);
        t_380 = real(0.316) * t_377;
        t_381 = (-c_4).mul_add(t_380, s_4 * t_378);
        t_382 = t_379 + t_381;
        t_383 = (-c_3).mul_add(t_376, s_3 * t_382);
        t_384 = (-s_4).mul_add(t_366, t_373);
        t_385 = (-c_4).mul_add(t_374, t_384);
        t_386 = t_309.mul_add(t_349, c_2 * t_385);
        t_387 = s_2.mul_add(t_383, t_386);
        t_388 = t_345.mul_add(t_351, -t_387);
        t_389 = t_292.mul_add(t_349, -t_369);
        t_390 = t_350.mul_add(t_351, t_389);
        t_391 = real(1.0) / t_390;
        t_392 = t_388 * t_391;
        t_393 = real(149.60760989322966) * t_302;
        t_394 = t_302.mul_add(t_311, -t_337);
        t_395 = t_394 * t_347;
        t_396 = t_302.mul_add(t_349, -t_379);
        t_397 = (-t_394).mul_add(t_351, t_396);
        t_398 = t_397 * t_391;
        t_399 = real(0.003).mul_add(qd_4, -tau_4);
        t_400 = t_284.mul_add(t_393, t_399);
        t_401 = t_314.mul_add(t_395, t_400);
        t_402 = t_401 - t_269;
        t_403 = t_355.mul_add(t_398, t_402);
        t_404 = real(2.0) * t_324;
        t_405 = t_321 - t_404;
        t_406 = real(0.03966005840337428) + t_134;
        t_407 = t_406 - t_404;
        t_408 = t_407 - t_367;
        t_409 = t_405 - t_408;
        t_410 = t_318 - real(0.00151524447332703);
        t_411 = real(2.0) * t_410;
        t_412 = (-c_5).mul_add(t_411, s_5 * t_409);
        t_413 = real(0.0039053550262761) + t_410;
        t_414 = t_413 - t_378;
        t_415 = c_5.mul_add(t_412, t_414);
        t_416 = real(0.00164448757736927) + t_379;
        t_417 = c_4.mul_add(t_415, s_4 * t_416);
        t_418 = real(2.0) * t_373;
        t_419 = s_5 * t_412;
        t_420 = real(0.749763367252814) + t_405;
        t_421 = t_418 - t_420;
        t_422 = t_421 + t_419;
        t_423 = t_323 - real(2.012523553603);
        t_424 = t_372 - real(0.55278027465);
        t_425 = (-c_4).mul_add(t_423, s_4 * t_424);
        t_426 = real(0.316) * t_425;
        t_427 = c_4.mul_add(t_424, s_4 * t_423);
        t_428 = real(0.0825) * t_427;
        t_429 = t_426 + t_428;
        t_430 = t_429 - t_422;
        t_431 = s_3.mul_add(t_430, c_3 * t_417);
        t_432 = (-c_4).mul_add(t_416, s_4 * t_415);
        t_433 = (-c_2).mul_add(t_432, t_309 * t_393);
        t_434 = t_345.mul_add(t_395, t_433);
        t_435 = s_2.mul_add(t_431, t_434);
        t_436 = t_388.mul_add(t_398, t_435);
        t_437 = t_394.mul_add(t_395, t_302 * t_393);
        t_438 = t_437 + t_422;
        t_439 = t_397.mul_add(t_398, -t_438);
        t_440 = real(1.0) / t_439;
        t_441 = t_436 * t_440;
        t_442 = real(149.60760989322966) * t_308;
        t_443 = t_308.mul_add(t_311, -t_343);
        t_444 = t_443 * t_347;
        t_445 = (-t_308).mul_add(t_349, t_443 * t_351);
        t_446 = t_385 + t_445;
        t_447 = t_446 * t_391;
        t_448 = t_443.mul_add(t_395, t_308 * t_393);
        t_449 = t_448 + t_432;
        t_450 = t_446.mul_add(t_398, t_449);
        t_451 = t_450 * t_440;
        t_452 = real(-0.003).mul_add(qd_3, tau_3);
        t_453 = t_284.mul_add(t_442, t_452);
        t_454 = t_314.mul_add(t_444, t_453);
        t_455 = (-t_355).mul_add(t_447, t_454);
        t_456 = t_455 + t_235;
        t_457 = t_403.mul_add(t_451, t_456);
        t_458 = t_418 - t_369;
        t_459 = real(0.647723094939183) + t_408;
        t_460 = t_459 + t_419;
        t_461 = t_458 + t_460;
        t_462 = real(0.0825).mul_add(t_323, -real(0.16284087268546085));
        t_463 = t_462 + t_366;
        t_464 = real(2.0) * t_463;
        t_465 = (-c_4).mul_add(t_464, s_4 * t_461);
        t_466 = real(0.0825).mul_add(t_425, real(0.24149476342611426));
        t_467 = real(0.316).mul_add(t_427, t_466);
        t_468 = t_467 - t_463;
        t_469 = (-c_4).mul_add(t_465, t_468);
        t_470 = real(0.013297019103287584) + t_380;
        t_471 = t_470 + t_432;
        t_472 = (-s_3).mul_add(t_471, c_3 * t_469);
        t_473 = s_4 * t_465;
        t_474 = real(2.0).mul_add(t_428, real(0.13480070614822143));
        t_475 = t_474 - t_458;
        t_476 = t_475 + t_473;
        t_477 = t_345.mul_add(t_444, t_309 * t_442);
        t_478 = c_2.mul_add(t_476, t_477);
        t_479 = (-t_388).mul_add(t_447, t_478);
        t_480 = s_2.mul_add(t_472, t_479);
        t_481 = t_436.mul_add(t_451, t_480);
        t_482 = t_443.mul_add(t_444, t_308 * t_442);
        t_483 = t_482 - t_476;
        t_484 = (-t_446).mul_add(t_447, t_483);
        t_485 = t_450.mul_add(t_451, t_484);
        t_486 = real(1.0) / t_485;
        t_487 = t_481 * t_486;
        t_488 = real(1645.919777283499).mul_add(s_2, -c_2);
        t_489 = qd_1 * qd_1;
        t_490 = c_3.mul_add(t_305, s_3 * t_297);
        t_491 = real(149.60760989322966) * t_490;
        t_492 = c_3.mul_add(t_340, s_3 * t_332);
        t_493 = t_490.mul_add(t_311, t_492);
        t_494 = t_493 * t_347;
        t_495 = (-c_3).mul_add(t_382, t_490 * t_349);
        t_496 = (-s_3).mul_add(t_376, t_495);
        t_497 = (-t_493).mul_add(t_351, t_496);
        t_498 = t_497 * t_391;
        t_499 = t_493.mul_add(t_395, t_490 * t_393);
        t_500 = s_3.mul_add(t_417, t_499);
        t_501 = (-c_3).mul_add(t_430, t_500);
        t_502 = (-t_497).mul_add(t_398, t_501);
        t_503 = t_502 * t_440;
        t_504 = s_3.mul_add(t_469, c_3 * t_471);
        t_505 = t_493.mul_add(t_444, t_490 * t_442);
        t_506 = t_497.mul_add(t_447, t_505);
        t_507 = t_504 + t_506;
        t_508 = t_502.mul_add(t_451, t_507);
        t_509 = t_508 * t_486;
        t_510 = real(-0.003).mul_add(qd_2, tau_2);
        t_511 = real(0.01993386669246).mul_add(t_488, t_510);
        t_512 = t_281.mul_add(t_489, t_511);
        t_513 = t_284.mul_add(t_491, t_512);
        t_514 = t_314.mul_add(t_494, t_513);
        t_515 = t_355.mul_add(t_498, t_514);
        t_516 = s_3.mul_add(t_244, t_515);
        t_517 = (-c_3).mul_add(t_276, t_516);
        t_518 = t_403.mul_add(t_503, t_517);
        t_519 = (-t_457).mul_add(t_509, t_518);
        t_520 = real(0.000121912420950744) + t_378;
        t_521 = t_520 + t_417;
        t_522 = t_429 + t_430;
        t_523 = real(2.0).mul_add(t_426, real(0.01159586409516604));
        t_524 = t_523 + t_460;
        t_525 = t_473 - t_524;
        t_526 = t_522 + t_525;
        t_527 = real(2.0) * t_521;
        t_528 = s_3.mul_add(t_526, c_3 * t_527);
        t_529 = (-c_3).mul_add(t_528, t_521);
        t_530 = real(0.0007689361029464).mul_add(c_2, real(0.01026110182100817) * s_2);
        t_531 = t_309.mul_add(t_491, -t_530);
        t_532 = t_345.mul_add(t_494, t_531);
        t_533 = t_388.mul_add(t_498, t_532);
        t_534 = (-c_2).mul_add(t_504, t_533);
        t_535 = (-s_2).mul_add(t_529, t_534);
        t_536 = t_436.mul_add(t_503, t_535);
        t_537 = (-t_481).mul_add(t_509, t_536);
        t_538 = s_3 * t_528;
        t_539 = real(1.1168423647533403) + t_522;
        t_540 = t_539 - t_538;
        t_541 = t_493.mul_add(t_494, t_490 * t_491);
        t_542 = t_497.mul_add(t_498, -t_541);
        t_543 = t_542 + t_540;
        t_544 = (-t_502).mul_add(t_503, t_543);
        t_545 = t_508.mul_add(t_509, t_544);
        t_546 = real(1.0) / t_545;
        t_547 = t_537 * t_546;
        t_548 = real(-0.003).mul_add(qd_1, tau_1);
        t_549 = (-t_278).mul_add(t_279, t_548);
        t_550 = (-t_281).mul_add(t_282, t_549);
        t_551 = (-t_284).mul_add(t_310, t_550);
        t_552 = (-t_314).mul_add(t_348, t_551);
        t_553 = t_355.mul_add(t_392, t_552);
        t_554 = c_2.mul_add(t_235, t_553);
        t_555 = (-t_403).mul_add(t_441, t_554);
        t_556 = (-s_2).mul_add(t_277, t_555);
        t_557 = t_457.mul_add(t_487, t_556);
        t_558 = (-t_519).mul_add(t_547, t_557);
        t_559 = t_525 + t_476;
        t_560 = t_538 - t_559;
        t_561 = real(2.0) * t_472;
        t_562 = s_2.mul_add(t_560, c_2 * t_561);
        t_563 = s_2.mul_add(t_280, real(0.03733744848940618));
        t_564 = t_563 + t_476;
        t_565 = s_2.mul_add(t_562, t_564);
        t_566 = t_345.mul_add(t_348, t_309 * t_310);
        t_567 = t_388.mul_add(t_392, -t_566);
        t_568 = t_567 + t_565;
        t_569 = (-t_436).mul_add(t_441, t_568);
        t_570 = t_481.mul_add(t_487, t_569);
        t_571 = (-t_537).mul_add(t_547, t_570);
        t_572 = real(1.0) / t_571;
        t_573 = t_558 * t_572;
        t_574 = (-t_547).mul_add(t_573, t_519 * t_546);
        t_575 = (-t_487).mul_add(t_573, t_457 * t_486);
        t_576 = t_509.mul_add(t_574, t_575);
        t_577 = (-t_403).mul_add(t_440, t_441 * t_573);
        t_578 = (-t_503).mul_add(t_574, t_577);
        t_579 = t_451.mul_add(t_576, t_578);
        t_580 = (-t_392).mul_add(t_573, t_355 * t_391);
        t_581 = (-t_498).mul_add(t_574, t_580);
        t_582 = (-t_447).mul_add(t_576, t_581);
        t_583 = t_398.mul_add(t_579, t_582);
        t_584 = (-t_348).mul_add(t_573, t_314 * t_347);
        t_585 = t_494.mul_add(t_574, t_584);
        t_586 = (-t_444).mul_add(t_576, t_585);
        t_587 = (-t_395).mul_add(t_579, t_586);
        t_588 = (-t_351).mul_add(t_583, t_587);
        t_589 = (-t_310).mul_add(t_573, real(149.60760989322966) * t_284);
        t_590 = t_491.mul_add(t_574, t_589);
        t_591 = (-t_442).mul_add(t_576, t_590);
        t_592 = (-t_393).mul_add(t_579, t_591);
        t_593 = t_349.mul_add(t_583, t_592);
        t_594 = t_311.mul_add(t_588, t_593);
        ::robot_dynamics::SingularMassMatrix::test_joint(
            6,
            "panda_joint7",
            real(0.006684151967360946),
            real(0.006684151967360946),
        )?;
        ::robot_dynamics::SingularMassMatrix::test_joint(
            5,
            "panda_joint6",
            t_346,
            t_321,
        )?;
        ::robot_dynamics::SingularMassMatrix::test_joint(
            4,
            "panda_joint5",
            -t_390,
            t_369,
        )?;
        ::robot_dynamics::SingularMassMatrix::test_joint(
            3,
            "panda_joint4",
            t_439,
            -t_422,
        )?;
        ::robot_dynamics::SingularMassMatrix::test_joint(
            2,
            "panda_joint3",
            -t_485,
            t_476,
        )?;
        ::robot_dynamics::SingularMassMatrix::test_joint(
            1,
            "panda_joint2",
            t_545,
            t_540,
        )?;
        ::robot_dynamics::SingularMassMatrix::test_joint(
            0,
            "panda_joint1",
            t_571,
            t_565,
        )?;
        ::core::result::Result::Ok(
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [t_573, t_574, -t_576, t_579, t_583, t_588, t_594],
                ]),
            ),
        )
    }

    #[inline]
    fn momenta(&self) -> ::core::option::Option<&dyn ::robot_dynamics::Momenta<7>> {
        ::core::option::Option::Some(self)
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::Function<::robot_dynamics::functions::FrictionVector, 7>
for Panda {
    type Arguments = (::robot_dynamics::Entries<7, 1>,);
    type Values = ::robot_dynamics::Entries<7, 1>;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["qd"];
    const RESULT: &'static str = "friction_vector";
    const WORK: u32 = 7;
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
            let qd_1 = qd.data.0[0][0];
            let qd_2 = qd.data.0[0][1];
            let qd_3 = qd.data.0[0][2];
            let qd_4 = qd.data.0[0][3];
            let qd_5 = qd.data.0[0][4];
            let qd_6 = qd.data.0[0][5];
            let qd_7 = qd.data.0[0][6];
            let t_1 = real(0.003) * qd_1;
            let t_2 = real(0.003) * qd_2;
            let t_3 = real(0.003) * qd_3;
            let t_4 = real(0.003) * qd_4;
            let t_5 = real(0.003) * qd_5;
            let t_6 = real(0.003) * qd_6;
            let t_7 = real(0.003) * qd_7;
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([
                    [t_1, t_2, t_3, t_4, t_5, t_6, t_7],
                ]),
            )
        })
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::Function<::robot_dynamics::functions::KineticEnergy, 7>
for Panda {
    type Arguments = (::robot_dynamics::Entries<7, 1>, ::robot_dynamics::Entries<7, 1>);
    type Values = ::robot_dynamics::Number;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd"];
    const RESULT: &'static str = "kinetic_energy";
    const WORK: u32 = 467;
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
            let [(s_2, c_2), (s_3, c_3), (s_4, c_4), (s_5, c_5), (s_6, c_6), (s_7, c_7),
            ] = ::robot_dynamics::Inputs::sin_cos(
                sines,
                [1, 2, 3, 4, 5, 6],
                [
                    q.data.0[0][1],
                    q.data.0[0][2],
                    q.data.0[0][3],
                    q.data.0[0][4],
                    q.data.0[0][5],
                    q.data.0[0][6],
                ],
            );
            let qd_1 = qd.data.0[0][0];
            let qd_2 = qd.data.0[0][1];
            let qd_3 = qd.data.0[0][2];
            let qd_4 = qd.data.0[0][3];
            let qd_5 = qd.data.0[0][4];
            let qd_6 = qd.data.0[0][5];
            let qd_7 = qd.data.0[0][6];
            let t_1 = qd_1.mul_add(c_2, qd_3);
            let t_2 = qd_1 * s_2;
            let t_3 = (-qd_2).mul_add(s_3, c_3 * t_2);
            let t_4 = s_4.mul_add(t_3, c_4 * t_1);
            let t_5 = real(3.83030303030303).mul_add(t_3, t_1);
            let t_6 = s_3.mul_add(t_2, qd_2 * c_3);
            let t_7 = t_6 - qd_4;
            let t_8 = real(3.83030303030303) * t_6;
            let t_9 = s_4.mul_add(t_8, c_4 * t_6);
            let t_10 = (-s_4).mul_add(t_6, c_4 * t_8);
            let t_11 = (-c_4).mul_add(t_3, s_4 * t_1);
            let t_12 = (-t_11).mul_add(t_5, t_7 * t_10);
            let t_13 = (-s_5).mul_add(t_11, c_5 * t_7);
            let t_14 = t_9 - t_7;
            let t_15 = qd_5 + t_4;
            let t_16 = t_5 - t_4;
            let t_17 = (-c_5).mul_add(t_16, s_5 * t_10);
            let t_18 = (-t_13).mul_add(t_14, t_15 * t_17);
            let t_19 = c_5.mul_add(t_10, s_5 * t_16);
            let t_20 = c_5.mul_add(t_11, s_5 * t_7);
            let t_21 = t_15.mul_add(t_19, t_20 * t_14);
            let t_22 = (-c_6).mul_add(t_15, s_6 * t_20);
            let t_23 = real(4.654545454545454).mul_add(t_20, t_17);
            let t_24 = t_13 - qd_6;
            let t_25 = real(4.654545454545454).mul_add(t_13, t_19);
            let t_26 = s_6.mul_add(t_25, c_6 * t_14);
            let t_27 = t_24.mul_add(t_26, t_22 * t_23);
            let t_28 = (-c_6).mul_add(t_25, s_6 * t_14);
            let t_29 = c_6.mul_add(t_20, s_6 * t_15);
            let t_30 = (-t_29).mul_add(t_23, t_24 * t_28);
            let t_31 = s_7.mul_add(t_29, c_7 * t_24);
            let t_32 = real(1.0666666666666667).mul_add(t_24, t_26);
            let t_33 = qd_7 + t_22;
            let t_34 = real(1.0666666666666667).mul_add(t_22, t_23);
            let t_35 = c_7.mul_add(t_34, s_7 * t_28);
            let t_36 = t_33.mul_add(t_35, t_31 * t_32);
            let t_37 = (-c_7).mul_add(t_28, s_7 * t_34);
            let t_38 = (-c_7).mul_add(t_29, s_7 * t_24);
            let t_39 = t_33.mul_add(t_37, t_38 * t_32);
            let t_40 = real(0.07493699179284148).mul_add(c_2, s_2);
            let t_41 = real(-108.84234307730597).mul_add(qd_2, qd_1 * t_40);
            let t_42 = real(0.0074407560248077745).mul_add(c_2, -s_2);
            let t_43 = t_2 * t_42;
            let t_44 = real(104.34421355915168).mul_add(t_43, qd_2 * t_40);
            let t_45 = qd_1 * qd_1;
            let t_46 = real(20.82593944221768).mul_add(t_1, t_3);
            let t_47 = real(0.010513439960163516).mul_add(t_6, t_46);
            let t_48 = t_3 * t_47;
            let t_49 = real(109.07025715337036).mul_add(t_1, -t_3);
            let t_50 = t_6 * t_49;
            let t_51 = real(0.5581930814390679).mul_add(t_1, t_3);
            let t_52 = real(-0.05506131443448806).mul_add(t_6, t_51);
            let t_53 = t_1 * t_52;
            let t_54 = real(-0.006029358929440037).mul_add(t_7, t_11);
            let t_55 = real(0.2514050741092543).mul_add(t_4, t_54);
            let t_56 = t_11 * t_55;
            let t_57 = real(0.010098739648403377).mul_add(t_7, t_11);
            let t_58 = t_4 * t_57;
            let t_59 = real(191.98340796374177).mul_add(t_7, -t_11);
            let t_60 = real(0.4210852960370544).mul_add(t_4, t_59);
            let t_61 = t_7 * t_60;
            let t_62 = real(0.03409410238600477).mul_add(t_15, t_20);
            let t_63 = real(-0.0503131234800294).mul_add(t_13, t_62);
            let t_64 = t_20 * t_63;
            let t_65 = real(15.77189083067785).mul_add(t_15, t_20);
            let t_66 = t_13 * t_65;
            let t_67 = real(32.15717989892508).mul_add(t_15, t_20);
            let t_68 = real(-23.274790516355523).mul_add(t_13, t_67);
            let t_69 = t_15 * t_68;
            let t_70 = real(0.010871898989277201).mul_add(t_24, t_29);
            let t_71 = real(-1.5453608396736078).mul_add(t_22, t_70);
            let t_72 = t_29 * t_71;
            let t_73 = real(-0.006344282522766932).mul_add(t_24, t_29);
            let t_74 = t_22 * t_73;
            let t_75 = real(506.83144562727915).mul_add(t_24, t_29);
            let t_76 = real(0.9017933091706839).mul_add(t_22, t_75);
            let t_77 = t_24 * t_76;
            let t_78 = real(0.3987309323262117).mul_add(t_33, t_38);
            let t_79 = real(0.16166888514995548).mul_add(t_31, t_78);
            let t_80 = t_38 * t_79;
            let t_81 = real(3.2078808523021545).mul_add(t_33, t_38);
            let t_82 = t_31 * t_81;
            let t_83 = real(6.924392591744896).mul_add(t_33, t_38);
            let t_84 = real(1.3006628757391887).mul_add(t_31, t_83);
            let t_85 = t_33 * t_84;
            let t_86 = (-qd_2).mul_add(t_41, real(3.6387367692778354) * t_45);
            let t_87 = (-qd_1).mul_add(t_44, t_86);
            let t_88 = real(-0.011881026333950355).mul_add(t_50, t_87);
            let t_89 = real(1.1300798196374127).mul_add(t_48, t_88);
            let t_90 = real(15.869725837050652)
                .mul_add(t_58, real(23.534973888641034) * t_53);
            let t_91 = real(63.1241270418992).mul_add(t_56, t_89);
            let t_92 = real(0.3805980190431823).mul_add(t_61, t_90);
            let t_93 = real(-0.14766878837755795).mul_add(t_66, t_91);
            let t_94 = real(2.934995447781563).mul_add(t_64, t_92);
            let t_95 = real(-1.4373281388242032)
                .mul_add(t_74, real(0.10006603529912253) * t_69);
            let t_96 = real(0.010111868981384936).mul_add(t_77, t_93);
            let t_97 = real(0.9300922489583584).mul_add(t_72, t_94);
            let t_98 = real(0.038143202212741825).mul_add(t_82, t_95);
            let t_99 = t_96 + t_97;
            let t_100 = real(0.23593409565088677).mul_add(t_80, t_98);
            let t_101 = real(0.09407422192641969).mul_add(t_85, t_99);
            let t_102 = t_100 + t_101;
            let t_103 = t_7.mul_add(t_9, t_4 * t_5);
            let t_104 = real(-3.640729682109687).mul_add(t_12, t_103);
            let t_105 = real(-0.026509145152254575).mul_add(t_18, t_104);
            let t_106 = real(0.12278048717996164).mul_add(t_21, t_105);
            let t_107 = real(-0.41942081388811725).mul_add(t_27, t_106);
            let t_108 = real(-0.3144191526715506).mul_add(t_30, t_107);
            let t_109 = real(0.0036803772709688835).mul_add(t_39, t_108);
            let t_110 = real(-0.004655747481162772).mul_add(t_36, t_109);
            let t_111 = real(-0.11250129343756604).mul_add(t_102, t_110);
            let t_112 = real(-0.045604372658625) * t_111;
            t_112
        })
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::Function<::robot_dynamics::functions::PotentialEnergy, 7>
for Panda {
    type Arguments = (::robot_dynamics::Entries<7, 1>,);
    type Values = ::robot_dynamics::Number;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q"];
    const RESULT: &'static str = "potential_energy";
    const WORK: u32 = 279;
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
            let [(s_2, c_2), (s_3, c_3), (s_4, c_4), (s_5, c_5), (s_6, c_6), (s_7, c_7),
            ] = ::robot_dynamics::Inputs::sin_cos(
                sines,
                [1, 2, 3, 4, 5, 6],
                [
                    q.data.0[0][1],
                    q.data.0[0][2],
                    q.data.0[0][3],
                    q.data.0[0][4],
                    q.data.0[0][5],
                    q.data.0[0][6],
                ],
            );
            let t_1 = real(0.7905019088470214).mul_add(s_7, -real(90.08667578838855));
            let t_2 = t_1 - c_7;
            let t_3 = real(67.533549434048).mul_add(c_6, -real(781.9860713752489));
            let t_4 = s_6.mul_add(t_2, t_3);
            let t_5 = real(26.3718098279027) - s_7;
            let t_6 = real(-0.7905019088470214).mul_add(c_7, t_5);
            let t_7 = real(67.533549434048).mul_add(s_6, -real(5.693853728002001));
            let t_8 = (-c_6).mul_add(t_2, t_7);
            let t_9 = s_5.mul_add(t_6, real(214.78828137608747));
            let t_10 = (-c_5).mul_add(t_8, t_9);
            let t_11 = (-c_4).mul_add(t_4, real(1299.5388029412425));
            let t_12 = (-s_4).mul_add(t_10, t_11);
            let t_13 = c_5.mul_add(t_6, real(10.96791885514394));
            let t_14 = s_5.mul_add(t_8, t_13);
            let t_15 = s_4.mul_add(t_4, real(290.19909897205986));
            let t_16 = (-c_4).mul_add(t_10, t_15);
            let t_17 = s_3.mul_add(t_14, real(0.7895517271723052));
            let t_18 = (-c_3).mul_add(t_16, t_17);
            let t_19 = c_2.mul_add(t_12, real(2084.6498238113));
            let t_20 = s_2.mul_add(t_18, t_19);
            let t_21 = real(0.025247068692827772) * t_20;
            t_21
        })
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::Model<7> for Panda {
    const JOINT_NAMES: [&'static str; 7] = Self::JOINT_NAMES;
    const READS_ANGLE: [bool; 7] = [false, true, true, true, true, true, true];

    #[inline]
    fn table(&self) -> ::robot_dynamics::Table<7> {
        Self::table(self)
    }

    #[inline]
    fn energies(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<f64, 7>,
        qd: &::robot_dynamics::nalgebra::SVector<f64, 7>,
    ) -> ::core::option::Option<[f64; 2]> {
        ::core::option::Option::Some([
            Self::kinetic_energy(self, q, qd),
            Self::potential_energy(self, q),
        ])
    }
}

::robot_dynamics::__with_std! {
    #[automatically_derived]
    #[allow(
        deprecated,
        unused_variables,
        clippy::all,
        clippy::pedantic,
        clippy::nursery
    )]
    impl ::robot_dynamics::Evaluate<7> for Panda {
        fn evaluate_in<T: ::robot_dynamics::Scalar>(
            &self,
            state: &::robot_dynamics::State<7>,
            tau: &::robot_dynamics::nalgebra::SVector<f64, 7>,
            real: fn(f64) -> T,
        ) -> ::robot_dynamics::Evaluation<T> {
            let at_state = ::robot_dynamics::Arguments::new(state, tau, real);
            let mut found_values: ::robot_dynamics::Evaluation<_> = ::core::default::Default::default();
            ::robot_dynamics::Evaluation::set(
                &mut found_values,
                "mass_matrix",
                Self::mass_matrix::<T>(self, &at_state.q),
            );
            ::robot_dynamics::Evaluation::set(
                &mut found_values,
                "coriolis_vector",
                Self::coriolis_vector::<T>(self, &at_state.q, &at_state.qd),
            );
            ::robot_dynamics::Evaluation::set(
                &mut found_values,
                "gravity_vector",
                Self::gravity_vector::<T>(self, &at_state.q),
            );
            ::robot_dynamics::Evaluation::set(
                &mut found_values,
                "friction_vector",
                Self::friction_vector::<T>(self, &at_state.qd),
            );
            ::robot_dynamics::Evaluation::set(
                &mut found_values,
                "inverse_dynamics",
                Self::inverse_dynamics::<
                    T,
                >(self, &at_state.q, &at_state.qd, &at_state.qdd),
            );
            ::robot_dynamics::Evaluation::set(
                &mut found_values,
                "forward_dynamics",
                Self::forward_dynamics::<
                    T,
                >(self, &at_state.q, &at_state.qd, &at_state.tau),
            );
            ::robot_dynamics::Evaluation::set(
                &mut found_values,
                "kinetic_energy",
                Self::kinetic_energy::<T>(self, &at_state.q, &at_state.qd),
            );
            ::robot_dynamics::Evaluation::set(
                &mut found_values,
                "potential_energy",
                Self::potential_energy::<T>(self, &at_state.q),
            );
            ::robot_dynamics::Evaluation::combined(
                found_values,
                ::robot_dynamics::nalgebra::Matrix::as_slice(&at_state.qd),
            )
        }
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::Energy<7> for Panda {
    #[inline]
    fn kinetic_energy<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 7>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 7>,
    ) -> T {
        Self::kinetic_energy(self, q, qd)
    }

    #[inline]
    fn potential_energy<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 7>,
    ) -> T {
        Self::potential_energy(self, q)
    }
}
