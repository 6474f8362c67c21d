// Generated from named_rods.toml by `robot-dynamics generate --lang rust`: what the macro `robot_dynamics!` expands to
// for this arm. The crate that it stands in depends on `robot-dynamics`.

#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(clippy::derive_partial_eq_without_eq)]
/// The arm of `named_rods.toml`, with its equations of motion.
///
/// Joints that move: `shoulder`, `elbow`.
pub struct NamedRods {
    /// A symbolic parameter of the table.
    pub g: ::core::primitive::f64,

    /// A symbolic parameter of the table.
    pub l1: ::core::primitive::f64,

    /// A symbolic parameter of the table.
    pub m1: ::core::primitive::f64,

    /// A symbolic parameter of the table.
    pub l2: ::core::primitive::f64,

    /// A symbolic parameter of the table.
    pub m2: ::core::primitive::f64,

    /// A symbolic parameter of the table.
    pub load: ::core::primitive::f64,
}

#[allow(
    dead_code,
    deprecated,
    unused_variables,
    unused_parens,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl NamedRods {
    /// Number of joints.
    pub const DOF: usize = 2;

    /// Names of the joints, from the base outwards.
    pub const JOINT_NAMES: [&'static str; 2] = ["shoulder", "elbow"];

    /// Ranges of the joints' positions, lower ends first, rad or m, where the table has them.
    pub const JOINT_LIMITS: [::core::option::Option<[f64; 2]>; 2] = [
        ::core::option::Option::None,
        ::core::option::Option::None,
    ];

    /// Greatest torques or forces of the joints in either direction, N m or N, where the table has them.
    pub const TORQUE_LIMITS: [::core::option::Option<f64>; 2] = [
        ::core::option::Option::None,
        ::core::option::Option::None,
    ];

    /// Greatest velocities of the joints in either direction, rad/s or m/s, where the table has them.
    pub const VELOCITY_LIMITS: [::core::option::Option<f64>; 2] = [
        ::core::option::Option::None,
        ::core::option::Option::None,
    ];

    /// Operations of each generated method, by the method's name.
    pub const OPERATIONS: [(&'static str, ::robot_dynamics::Operations); 2] = [
        (
            "mass_matrix",
            ::robot_dynamics::Operations {
                multiplications: 7,
                additions: 5,
                divisions: 0,
                sin_cos: 1,
                exponentials: 0,
            },
        ),
        (
            "gravity_vector",
            ::robot_dynamics::Operations {
                multiplications: 9,
                additions: 4,
                divisions: 0,
                sin_cos: 2,
                exponentials: 0,
            },
        ),
    ];

    /// The largest rounding error of each generated method's values in double and in single precision, SI units: proven
    /// for all positions within the limits, all other arguments up to 1, and any rotation of a moving base. Infinite if
    /// there is no bound: without limits, with fields, or if a divisor may vanish.
    pub const ROUNDING: [(&'static str, f64, f64); 2] = [
        ("mass_matrix", f64::INFINITY, f64::INFINITY),
        ("gravity_vector", f64::INFINITY, f64::INFINITY),
    ];

    /// The table in numbers, as it was written: what the numeric checks read.
    pub fn table(&self) -> ::robot_dynamics::Table<2> {
        ::robot_dynamics::Table::new(
            ::robot_dynamics::Convention::Standard,
            [0f64, (-self.g), 0f64],
            [
                ::robot_dynamics::Row {
                    a: self.l1,
                    alpha: 0f64,
                    d: 0f64,
                    theta: 0f64,
                    mass: self.m1,
                    com: [0f64, 0f64, 0f64],
                    inertia: [0f64, 0f64, 0f64, 0f64, 0f64, 0f64],
                    motor_inertia: 0f64,
                    gear_ratio: 0f64,
                    viscous: 0f64,
                    coulomb: [0f64, 0f64],
                    limits: ::core::option::Option::None,
                    ..::robot_dynamics::Row::new(::robot_dynamics::JointType::Revolute)
                },
                ::robot_dynamics::Row {
                    a: (0.5f64 * self.l2),
                    alpha: 0f64,
                    d: 0f64,
                    theta: 0f64,
                    mass: (self.m2 + self.load),
                    com: [0f64, 0f64, 0f64],
                    inertia: [0f64, 0f64, 0f64, 0f64, 0f64, 0f64],
                    motor_inertia: 0f64,
                    gear_ratio: 0f64,
                    viscous: 0f64,
                    coulomb: [0f64, 0f64],
                    limits: ::core::option::Option::None,
                    ..::robot_dynamics::Row::new(::robot_dynamics::JointType::Revolute)
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
                text: "M11 = l1^2 (m1 + m2 + load) + 1/4 l2^2 (m2 + load) + l1 l2 (m2 + load) c2",
                latex: "M_{11} = l_{1}^{2} \\, \\left(m_{1} + m_{2} + \\mathrm{load}\\right) + \\tfrac{1}{4} \\, l_{2}^{2} \\, \\left(m_{2} + \\mathrm{load}\\right) + l_{1} \\, l_{2} \\, \\left(m_{2} + \\mathrm{load}\\right) \\, c_{2}",
                mathml: "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow><msub><mi>M</mi><mn>11</mn></msub><mo>=</mo><msup><mrow><msub><mi>l</mi><mn>1</mn></msub></mrow><mn>2</mn></msup><mo>&#x2062;</mo><mrow><mo>(</mo><msub><mi>m</mi><mn>1</mn></msub><mo>+</mo><msub><mi>m</mi><mn>2</mn></msub><mo>+</mo><mi>load</mi><mo>)</mo></mrow><mo>+</mo><mfrac><mn>1</mn><mn>4</mn></mfrac><mo>&#x2062;</mo><msup><mrow><msub><mi>l</mi><mn>2</mn></msub></mrow><mn>2</mn></msup><mo>&#x2062;</mo><mrow><mo>(</mo><msub><mi>m</mi><mn>2</mn></msub><mo>+</mo><mi>load</mi><mo>)</mo></mrow><mo>+</mo><msub><mi>l</mi><mn>1</mn></msub><mo>&#x2062;</mo><msub><mi>l</mi><mn>2</mn></msub><mo>&#x2062;</mo><mrow><mo>(</mo><msub><mi>m</mi><mn>2</mn></msub><mo>+</mo><mi>load</mi><mo>)</mo></mrow><mo>&#x2062;</mo><msub><mi>c</mi><mn>2</mn></msub></mrow></math>",
            },
            ::robot_dynamics::Formula {
                function: "mass_matrix",
                value: "M12",
                text: "M12 = 1/4 l2^2 (m2 + load) + 1/2 l1 l2 (m2 + load) c2",
                latex: "M_{12} = \\tfrac{1}{4} \\, l_{2}^{2} \\, \\left(m_{2} + \\mathrm{load}\\right) + \\tfrac{1}{2} \\, l_{1} \\, l_{2} \\, \\left(m_{2} + \\mathrm{load}\\right) \\, c_{2}",
                mathml: "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow><msub><mi>M</mi><mn>12</mn></msub><mo>=</mo><mfrac><mn>1</mn><mn>4</mn></mfrac><mo>&#x2062;</mo><msup><mrow><msub><mi>l</mi><mn>2</mn></msub></mrow><mn>2</mn></msup><mo>&#x2062;</mo><mrow><mo>(</mo><msub><mi>m</mi><mn>2</mn></msub><mo>+</mo><mi>load</mi><mo>)</mo></mrow><mo>+</mo><mfrac><mn>1</mn><mn>2</mn></mfrac><mo>&#x2062;</mo><msub><mi>l</mi><mn>1</mn></msub><mo>&#x2062;</mo><msub><mi>l</mi><mn>2</mn></msub><mo>&#x2062;</mo><mrow><mo>(</mo><msub><mi>m</mi><mn>2</mn></msub><mo>+</mo><mi>load</mi><mo>)</mo></mrow><mo>&#x2062;</mo><msub><mi>c</mi><mn>2</mn></msub></mrow></math>",
            },
            ::robot_dynamics::Formula {
                function: "mass_matrix",
                value: "M21",
                text: "M21 = 1/4 l2^2 (m2 + load) + 1/2 l1 l2 (m2 + load) c2",
                latex: "M_{21} = \\tfrac{1}{4} \\, l_{2}^{2} \\, \\left(m_{2} + \\mathrm{load}\\right) + \\tfrac{1}{2} \\, l_{1} \\, l_{2} \\, \\left(m_{2} + \\mathrm{load}\\right) \\, c_{2}",
                mathml: "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow><msub><mi>M</mi><mn>21</mn></msub><mo>=</mo><mfrac><mn>1</mn><mn>4</mn></mfrac><mo>&#x2062;</mo><msup><mrow><msub><mi>l</mi><mn>2</mn></msub></mrow><mn>2</mn></msup><mo>&#x2062;</mo><mrow><mo>(</mo><msub><mi>m</mi><mn>2</mn></msub><mo>+</mo><mi>load</mi><mo>)</mo></mrow><mo>+</mo><mfrac><mn>1</mn><mn>2</mn></mfrac><mo>&#x2062;</mo><msub><mi>l</mi><mn>1</mn></msub><mo>&#x2062;</mo><msub><mi>l</mi><mn>2</mn></msub><mo>&#x2062;</mo><mrow><mo>(</mo><msub><mi>m</mi><mn>2</mn></msub><mo>+</mo><mi>load</mi><mo>)</mo></mrow><mo>&#x2062;</mo><msub><mi>c</mi><mn>2</mn></msub></mrow></math>",
            },
            ::robot_dynamics::Formula {
                function: "mass_matrix",
                value: "M22",
                text: "M22 = 1/4 l2^2 (m2 + load)",
                latex: "M_{22} = \\tfrac{1}{4} \\, l_{2}^{2} \\, \\left(m_{2} + \\mathrm{load}\\right)",
                mathml: "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow><msub><mi>M</mi><mn>22</mn></msub><mo>=</mo><mfrac><mn>1</mn><mn>4</mn></mfrac><mo>&#x2062;</mo><msup><mrow><msub><mi>l</mi><mn>2</mn></msub></mrow><mn>2</mn></msup><mo>&#x2062;</mo><mrow><mo>(</mo><msub><mi>m</mi><mn>2</mn></msub><mo>+</mo><mi>load</mi><mo>)</mo></mrow></mrow></math>",
            },
            ::robot_dynamics::Formula {
                function: "gravity_vector",
                value: "G1",
                text: "G1 = g l1 (m1 + m2 + load) c1 + 1/2 g l2 (m2 + load) c12",
                latex: "G_{1} = g \\, l_{1} \\, \\left(m_{1} + m_{2} + \\mathrm{load}\\right) \\, c_{1} + \\tfrac{1}{2} \\, g \\, l_{2} \\, \\left(m_{2} + \\mathrm{load}\\right) \\, c_{12}",
                mathml: "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow><msub><mi>G</mi><mn>1</mn></msub><mo>=</mo><mi>g</mi><mo>&#x2062;</mo><msub><mi>l</mi><mn>1</mn></msub><mo>&#x2062;</mo><mrow><mo>(</mo><msub><mi>m</mi><mn>1</mn></msub><mo>+</mo><msub><mi>m</mi><mn>2</mn></msub><mo>+</mo><mi>load</mi><mo>)</mo></mrow><mo>&#x2062;</mo><msub><mi>c</mi><mn>1</mn></msub><mo>+</mo><mfrac><mn>1</mn><mn>2</mn></mfrac><mo>&#x2062;</mo><mi>g</mi><mo>&#x2062;</mo><msub><mi>l</mi><mn>2</mn></msub><mo>&#x2062;</mo><mrow><mo>(</mo><msub><mi>m</mi><mn>2</mn></msub><mo>+</mo><mi>load</mi><mo>)</mo></mrow><mo>&#x2062;</mo><msub><mi>c</mi><mn>12</mn></msub></mrow></math>",
            },
            ::robot_dynamics::Formula {
                function: "gravity_vector",
                value: "G2",
                text: "G2 = 1/2 g l2 (m2 + load) c12",
                latex: "G_{2} = \\tfrac{1}{2} \\, g \\, l_{2} \\, \\left(m_{2} + \\mathrm{load}\\right) \\, c_{12}",
                mathml: "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow><msub><mi>G</mi><mn>2</mn></msub><mo>=</mo><mfrac><mn>1</mn><mn>2</mn></mfrac><mo>&#x2062;</mo><mi>g</mi><mo>&#x2062;</mo><msub><mi>l</mi><mn>2</mn></msub><mo>&#x2062;</mo><mrow><mo>(</mo><msub><mi>m</mi><mn>2</mn></msub><mo>+</mo><mi>load</mi><mo>)</mo></mrow><mo>&#x2062;</mo><msub><mi>c</mi><mn>12</mn></msub></mrow></math>",
            },
        ]
    }

    /// Mass matrix M(q), N x N, both triangles, reflected motor inertias included (kg m^2, kg m or kg). Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong).
    ///
    /// `q`: joint positions, rad.
    ///
    /// Operations: 7 multiplications, 5 additions, sine and cosine of one angle.
    ///
    /// M22 is constant; M11, M12 depend on q2.
    ///
    /// ```text
    /// M11 = l1^2 (m1 + m2 + load) + 1/4 l2^2 (m2 + load) + l1 l2 (m2 + load) c2
    /// M12 = 1/4 l2^2 (m2 + load) + 1/2 l1 l2 (m2 + load) c2
    /// M21 = 1/4 l2^2 (m2 + load) + 1/2 l1 l2 (m2 + load) c2
    /// M22 = 1/4 l2^2 (m2 + load)
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

    /// Gravity vector G(q), N m or N: the gradient of the potential energy of gravity, inverse dynamics at rest without springs.
    ///
    /// `q`: joint positions, rad.
    ///
    /// Operations: 9 multiplications, 4 additions, sines and cosines of 2 angles.
    ///
    /// G1, G2 depend on q1, q2.
    ///
    /// ```text
    /// G1 = g l1 (m1 + m2 + load) c1 + 1/2 g l2 (m2 + load) c12
    /// G2 = 1/2 g l2 (m2 + load) c12
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
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::MassMatrix<2> for NamedRods {
    const WORK: u32 = 52;

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
        let p_l1_ = ::robot_dynamics::Inputs::field(sines, 1, self.l1, q.data.0[0][0]);
        let p_m1_ = ::robot_dynamics::Inputs::field(sines, 2, self.m1, q.data.0[0][0]);
        let p_l2_ = ::robot_dynamics::Inputs::field(sines, 3, self.l2, q.data.0[0][0]);
        let p_m2_ = ::robot_dynamics::Inputs::field(sines, 4, self.m2, q.data.0[0][0]);
        let p_load_ = ::robot_dynamics::Inputs::field(
            sines,
            5,
            self.load,
            q.data.0[0][0],
        );
        let t_1_ = real(0.5) * p_l2_;
        let t_2_ = p_m2_ + p_load_;
        let t_3_ = t_1_ * t_2_;
        let t_4_ = c_2_ * t_3_;
        let t_5_ = p_l1_ * t_4_;
        let t_6_ = p_m1_ + t_2_;
        let t_7_ = p_l1_ * t_6_;
        let t_8_ = t_1_ * t_3_;
        let t_9_ = t_8_ + t_5_;
        let t_10_ = p_l1_.mul_add(t_7_, t_5_);
        let t_11_ = t_9_ + t_10_;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t_11_, t_9_], [t_9_, t_8_]]),
        )
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::GravityVector<2> for NamedRods {
    const WORK: u32 = 93;

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
        let p_g_ = ::robot_dynamics::Inputs::field(sines, 0, self.g, q.data.0[0][0]);
        let p_l1_ = ::robot_dynamics::Inputs::field(sines, 1, self.l1, q.data.0[0][0]);
        let p_m1_ = ::robot_dynamics::Inputs::field(sines, 2, self.m1, q.data.0[0][0]);
        let p_l2_ = ::robot_dynamics::Inputs::field(sines, 3, self.l2, q.data.0[0][0]);
        let p_m2_ = ::robot_dynamics::Inputs::field(sines, 4, self.m2, q.data.0[0][0]);
        let p_load_ = ::robot_dynamics::Inputs::field(
            sines,
            5,
            self.load,
            q.data.0[0][0],
        );
        let t_1_ = p_m2_ + p_load_;
        let t_2_ = p_m1_ + t_1_;
        let t_3_ = p_l1_ * t_2_;
        let t_4_ = real(0.5) * p_l2_;
        let t_5_ = t_4_ * t_1_;
        let t_6_ = (-c_1_).mul_add(c_2_, s_1_ * s_2_);
        let t_7_ = t_5_ * t_6_;
        let t_8_ = (-c_1_).mul_add(t_3_, t_7_);
        let t_9_ = p_g_ * t_8_;
        let t_10_ = p_g_ * t_7_;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[-t_9_, -t_10_]]),
        )
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
    impl ::robot_dynamics::Fields for NamedRods {
        type OfEach<'a> = ::robot_dynamics::WithParameters<'a, Self>;

        #[inline(always)]
        fn field(&self, index: usize) -> f64 {
            match index {
                0 => self.g,
                1 => self.l1,
                2 => self.m1,
                3 => self.l2,
                4 => self.m2,
                5 => self.load,
                _ => 0.0,
            }
        }
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::Model<2> for NamedRods {
    const JOINT_NAMES: [&'static str; 2] = Self::JOINT_NAMES;
    const READS_ANGLE: [bool; 2] = [true, true];

    #[inline]
    fn table(&self) -> ::robot_dynamics::Table<2> {
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
    impl ::robot_dynamics::Evaluate<2> for NamedRods {
        fn evaluate_in<T: ::robot_dynamics::Scalar>(
            &self,
            state: &::robot_dynamics::State<2>,
            tau: &::robot_dynamics::nalgebra::SVector<f64, 2>,
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
                "gravity_vector",
                Self::gravity_vector::<T>(self, &at_state.q),
            );
            ::robot_dynamics::Evaluation::combined(
                found_values,
                ::robot_dynamics::nalgebra::Matrix::as_slice(&at_state.qd),
            )
        }
    }
}
