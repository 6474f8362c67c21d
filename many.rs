// Generated from many.toml by `robot-dynamics generate --lang rust`: what the macro `robot_dynamics!` expands to
// for this arm. The crate that it stands in depends on `robot-dynamics`.

#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(clippy::derive_partial_eq_without_eq)]
/// The arm of `many.toml`, with its equations of motion.
///
/// Joints that move: `a`.
pub struct Many;

#[allow(
    dead_code,
    deprecated,
    unused_variables,
    unused_parens,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl Many {
    /// Number of joints.
    pub const DOF: usize = 1;

    /// Names of the joints, from the base outwards.
    pub const JOINT_NAMES: [&'static str; 1] = ["a"];

    /// Ranges of the joints' positions, lower ends first, rad or m, where the table has them.
    pub const JOINT_LIMITS: [::core::option::Option<[f64; 2]>; 1] = [
        ::core::option::Option::None,
    ];

    /// Greatest torques or forces of the joints in either direction, N m or N, where the table has them.
    pub const TORQUE_LIMITS: [::core::option::Option<f64>; 1] = [
        ::core::option::Option::None,
    ];

    /// Greatest velocities of the joints in either direction, rad/s or m/s, where the table has them.
    pub const VELOCITY_LIMITS: [::core::option::Option<f64>; 1] = [
        ::core::option::Option::None,
    ];

    /// Operations of each generated method, by the method's name.
    pub const OPERATIONS: [(&'static str, ::robot_dynamics::Operations); 1] = [
        (
            "mass_matrix",
            ::robot_dynamics::Operations {
                multiplications: 0,
                additions: 0,
                divisions: 0,
                sin_cos: 0,
                exponentials: 0,
            },
        ),
    ];

    /// The table in numbers, as it was written: what the numeric checks read.
    pub fn table(&self) -> ::robot_dynamics::Table<1> {
        ::robot_dynamics::Table::with_frames(
            ::robot_dynamics::Convention::Modified,
            [0f64, 0f64, (-9.81f64)],
            [
                ::robot_dynamics::Row {
                    a: 0f64,
                    alpha: 0f64,
                    d: 0f64,
                    theta: 0f64,
                    mass: 1f64,
                    com: [0.1f64, 0f64, 0f64],
                    inertia: [0f64, 0f64, 0f64, 0f64, 0f64, 0f64],
                    motor_inertia: 0f64,
                    gear_ratio: 0f64,
                    viscous: 0f64,
                    coulomb: [0f64, 0f64],
                    limits: ::core::option::Option::None,
                    ..::robot_dynamics::Row::new(::robot_dynamics::JointType::Revolute)
                },
            ],
            [::robot_dynamics::JointMotion::Free],
            [
                ::robot_dynamics::FixedFrame {
                    ..::robot_dynamics::FixedFrame::new(
                        ::core::option::Option::Some(0),
                        ::robot_dynamics::Placement::of_frames(
                            &[
                                ::robot_dynamics::Frame {
                                    xyz: [0.1f64, 0f64, 0f64],
                                    rpy: [0f64, 0f64, 0f64],
                                },
                            ],
                        ),
                    )
                },
                ::robot_dynamics::FixedFrame {
                    ..::robot_dynamics::FixedFrame::new(
                        ::core::option::Option::Some(0),
                        ::robot_dynamics::Placement::of_frames(
                            &[
                                ::robot_dynamics::Frame {
                                    xyz: [0.1f64, 0f64, 0.01f64],
                                    rpy: [0f64, 0f64, 0f64],
                                },
                            ],
                        ),
                    )
                },
                ::robot_dynamics::FixedFrame {
                    ..::robot_dynamics::FixedFrame::new(
                        ::core::option::Option::Some(0),
                        ::robot_dynamics::Placement::of_frames(
                            &[
                                ::robot_dynamics::Frame {
                                    xyz: [0.1f64, 0f64, 0.02f64],
                                    rpy: [0f64, 0f64, 0f64],
                                },
                            ],
                        ),
                    )
                },
                ::robot_dynamics::FixedFrame {
                    ..::robot_dynamics::FixedFrame::new(
                        ::core::option::Option::Some(0),
                        ::robot_dynamics::Placement::of_frames(
                            &[
                                ::robot_dynamics::Frame {
                                    xyz: [0.1f64, 0f64, 0.03f64],
                                    rpy: [0f64, 0f64, 0f64],
                                },
                            ],
                        ),
                    )
                },
                ::robot_dynamics::FixedFrame {
                    ..::robot_dynamics::FixedFrame::new(
                        ::core::option::Option::Some(0),
                        ::robot_dynamics::Placement::of_frames(
                            &[
                                ::robot_dynamics::Frame {
                                    xyz: [0.1f64, 0f64, 0.04f64],
                                    rpy: [0f64, 0f64, 0f64],
                                },
                            ],
                        ),
                    )
                },
                ::robot_dynamics::FixedFrame {
                    ..::robot_dynamics::FixedFrame::new(
                        ::core::option::Option::Some(0),
                        ::robot_dynamics::Placement::of_frames(
                            &[
                                ::robot_dynamics::Frame {
                                    xyz: [0.1f64, 0f64, 0.05f64],
                                    rpy: [0f64, 0f64, 0f64],
                                },
                            ],
                        ),
                    )
                },
                ::robot_dynamics::FixedFrame {
                    ..::robot_dynamics::FixedFrame::new(
                        ::core::option::Option::Some(0),
                        ::robot_dynamics::Placement::of_frames(
                            &[
                                ::robot_dynamics::Frame {
                                    xyz: [0.1f64, 0f64, 0.06f64],
                                    rpy: [0f64, 0f64, 0f64],
                                },
                            ],
                        ),
                    )
                },
                ::robot_dynamics::FixedFrame {
                    ..::robot_dynamics::FixedFrame::new(
                        ::core::option::Option::Some(0),
                        ::robot_dynamics::Placement::of_frames(
                            &[
                                ::robot_dynamics::Frame {
                                    xyz: [0.1f64, 0f64, 0.07f64],
                                    rpy: [0f64, 0f64, 0f64],
                                },
                            ],
                        ),
                    )
                },
                ::robot_dynamics::FixedFrame {
                    ..::robot_dynamics::FixedFrame::new(
                        ::core::option::Option::Some(0),
                        ::robot_dynamics::Placement::of_frames(
                            &[
                                ::robot_dynamics::Frame {
                                    xyz: [0.1f64, 0f64, 0.08f64],
                                    rpy: [0f64, 0f64, 0f64],
                                },
                            ],
                        ),
                    )
                },
                ::robot_dynamics::FixedFrame {
                    ..::robot_dynamics::FixedFrame::new(
                        ::core::option::Option::Some(0),
                        ::robot_dynamics::Placement::of_frames(
                            &[
                                ::robot_dynamics::Frame {
                                    xyz: [0.1f64, 0f64, 0.09f64],
                                    rpy: [0f64, 0f64, 0f64],
                                },
                            ],
                        ),
                    )
                },
                ::robot_dynamics::FixedFrame {
                    ..::robot_dynamics::FixedFrame::new(
                        ::core::option::Option::Some(0),
                        ::robot_dynamics::Placement::of_frames(
                            &[
                                ::robot_dynamics::Frame {
                                    xyz: [0.1f64, 0f64, 0.1f64],
                                    rpy: [0f64, 0f64, 0f64],
                                },
                            ],
                        ),
                    )
                },
                ::robot_dynamics::FixedFrame {
                    ..::robot_dynamics::FixedFrame::new(
                        ::core::option::Option::Some(0),
                        ::robot_dynamics::Placement::of_frames(
                            &[
                                ::robot_dynamics::Frame {
                                    xyz: [0.1f64, 0f64, 0.11f64],
                                    rpy: [0f64, 0f64, 0f64],
                                },
                            ],
                        ),
                    )
                },
                ::robot_dynamics::FixedFrame {
                    ..::robot_dynamics::FixedFrame::new(
                        ::core::option::Option::Some(0),
                        ::robot_dynamics::Placement::of_frames(
                            &[
                                ::robot_dynamics::Frame {
                                    xyz: [0.1f64, 0f64, 0.12f64],
                                    rpy: [0f64, 0f64, 0f64],
                                },
                            ],
                        ),
                    )
                },
                ::robot_dynamics::FixedFrame {
                    ..::robot_dynamics::FixedFrame::new(
                        ::core::option::Option::Some(0),
                        ::robot_dynamics::Placement::of_frames(
                            &[
                                ::robot_dynamics::Frame {
                                    xyz: [0.1f64, 0f64, 0.13f64],
                                    rpy: [0f64, 0f64, 0f64],
                                },
                            ],
                        ),
                    )
                },
                ::robot_dynamics::FixedFrame {
                    ..::robot_dynamics::FixedFrame::new(
                        ::core::option::Option::Some(0),
                        ::robot_dynamics::Placement::of_frames(
                            &[
                                ::robot_dynamics::Frame {
                                    xyz: [0.1f64, 0f64, 0.14f64],
                                    rpy: [0f64, 0f64, 0f64],
                                },
                            ],
                        ),
                    )
                },
                ::robot_dynamics::FixedFrame {
                    ..::robot_dynamics::FixedFrame::new(
                        ::core::option::Option::Some(0),
                        ::robot_dynamics::Placement::of_frames(
                            &[
                                ::robot_dynamics::Frame {
                                    xyz: [0.1f64, 0f64, 0.15f64],
                                    rpy: [0f64, 0f64, 0f64],
                                },
                            ],
                        ),
                    )
                },
                ::robot_dynamics::FixedFrame {
                    ..::robot_dynamics::FixedFrame::new(
                        ::core::option::Option::Some(0),
                        ::robot_dynamics::Placement::of_frames(
                            &[
                                ::robot_dynamics::Frame {
                                    xyz: [0.1f64, 0f64, 0.16f64],
                                    rpy: [0f64, 0f64, 0f64],
                                },
                            ],
                        ),
                    )
                },
                ::robot_dynamics::FixedFrame {
                    ..::robot_dynamics::FixedFrame::new(
                        ::core::option::Option::Some(0),
                        ::robot_dynamics::Placement::of_frames(
                            &[
                                ::robot_dynamics::Frame {
                                    xyz: [0.1f64, 0f64, 0.17f64],
                                    rpy: [0f64, 0f64, 0f64],
                                },
                            ],
                        ),
                    )
                },
                ::robot_dynamics::FixedFrame {
                    ..::robot_dynamics::FixedFrame::new(
                        ::core::option::Option::Some(0),
                        ::robot_dynamics::Placement::of_frames(
                            &[
                                ::robot_dynamics::Frame {
                                    xyz: [0.1f64, 0f64, 0.18f64],
                                    rpy: [0f64, 0f64, 0f64],
                                },
                            ],
                        ),
                    )
                },
                ::robot_dynamics::FixedFrame {
                    ..::robot_dynamics::FixedFrame::new(
                        ::core::option::Option::Some(0),
                        ::robot_dynamics::Placement::of_frames(
                            &[
                                ::robot_dynamics::Frame {
                                    xyz: [0.1f64, 0f64, 0.19f64],
                                    rpy: [0f64, 0f64, 0f64],
                                },
                            ],
                        ),
                    )
                },
            ],
        )
    }

    /// The formulas of the generated methods, value by value, where they are short enough to
    /// read: at most 24 terms, of arms of up to three joints.
    pub fn formulas() -> &'static [::robot_dynamics::Formula] {
        &[
            ::robot_dynamics::Formula {
                function: "mass_matrix",
                value: "M11",
                text: "M11 = 0.01",
                latex: "M_{11} = 0.01",
                mathml: "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow><msub><mi>M</mi><mn>11</mn></msub><mo>=</mo><mn>0.01</mn></mrow></math>",
            },
        ]
    }

    /// Mass matrix M(q), N x N, both triangles, reflected motor inertias included (kg m^2, kg m or kg). Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong).
    ///
    /// `q`: joint positions, rad.
    ///
    /// Operations: 0 multiplications, 0 additions.
    ///
    /// ```text
    /// M11 = 0.01
    /// ```
    ///
    /// Never panics, never allocates; what depends on an input that is not finite is not finite.
    #[inline]
    #[allow(unused_variables, clippy::all)]
    pub fn mass_matrix<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 1>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 1, 1> {
        <Self as ::robot_dynamics::MassMatrix<
            1,
        >>::mass_matrix_at(self, &::robot_dynamics::Evaluated, q)
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::MassMatrix<1> for Many {
    const WORK: u32 = 0;

    #[inline]
    fn mass_matrix<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 1>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 1, 1> {
        Self::mass_matrix(self, q)
    }

    #[inline(always)]
    fn mass_matrix_at<T: ::robot_dynamics::Scalar>(
        &self,
        sines: &impl ::robot_dynamics::Inputs<T>,
        q: &::robot_dynamics::nalgebra::SVector<T, 1>,
    ) -> ::robot_dynamics::nalgebra::SMatrix<T, 1, 1> {
        let real = |x: f64| ::robot_dynamics::Scalar::constant(q.data.0[0][0], x);
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[real(0.01)]]),
        )
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::Model<1> for Many {
    const JOINT_NAMES: [&'static str; 1] = Self::JOINT_NAMES;
    const READS_ANGLE: [bool; 1] = [false];

    #[inline]
    fn table(&self) -> ::robot_dynamics::Table<1> {
        Self::table(self)
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
    impl ::robot_dynamics::Evaluate<1> for Many {
        fn evaluate_in<T: ::robot_dynamics::Scalar>(
            &self,
            state: &::robot_dynamics::State<1>,
            tau: &::robot_dynamics::nalgebra::SVector<f64, 1>,
            real: fn(f64) -> T,
        ) -> ::robot_dynamics::Evaluation<T> {
            let at_state = ::robot_dynamics::Arguments::new(state, tau, real);
            let mut found_values: ::robot_dynamics::Evaluation<_> = ::core::default::Default::default();
            ::robot_dynamics::Evaluation::set(
                &mut found_values,
                "mass_matrix",
                Self::mass_matrix::<T>(self, &at_state.q),
            );
            ::robot_dynamics::Evaluation::combined(
                found_values,
                ::robot_dynamics::nalgebra::Matrix::as_slice(&at_state.qd),
            )
        }
    }
}
