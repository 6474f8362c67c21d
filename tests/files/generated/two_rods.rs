// Generated from two_rods.toml by `robot-dynamics generate --lang rust`: what the macro `robot_dynamics!` expands to
// for this arm. The crate that it stands in depends on `robot-dynamics`.

#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(clippy::derive_partial_eq_without_eq)]
/// The arm of `two_rods.toml`, with its equations of motion.
///
/// Joints that move: `pivot`, `knee`.
pub struct TwoRods;

#[allow(
    dead_code,
    deprecated,
    unused_variables,
    unused_parens,
    clippy::all,
    clippy::pedantic,
    clippy::nursery
)]
impl TwoRods {
    /// Number of joints.
    pub const DOF: usize = 2;

    /// Names of the joints, from the base outwards.
    pub const JOINT_NAMES: [&'static str; 2] = ["pivot", "knee"];

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
    pub const OPERATIONS: [(&'static str, ::robot_dynamics::Operations); 8] = [
        (
            "mass_matrix",
            ::robot_dynamics::Operations {
                multiplications: 1,
                additions: 3,
                divisions: 0,
                sin_cos: 1,
                exponentials: 0,
            },
        ),
        (
            "coriolis_vector",
            ::robot_dynamics::Operations {
                multiplications: 5,
                additions: 2,
                divisions: 0,
                sin_cos: 1,
                exponentials: 0,
            },
        ),
        (
            "gravity_vector",
            ::robot_dynamics::Operations {
                multiplications: 4,
                additions: 2,
                divisions: 0,
                sin_cos: 2,
                exponentials: 0,
            },
        ),
        (
            "inverse_dynamics",
            ::robot_dynamics::Operations {
                multiplications: 13,
                additions: 10,
                divisions: 0,
                sin_cos: 2,
                exponentials: 0,
            },
        ),
        (
            "forward_dynamics",
            ::robot_dynamics::Operations {
                multiplications: 16,
                additions: 13,
                divisions: 1,
                sin_cos: 2,
                exponentials: 0,
            },
        ),
        (
            "kinetic_energy",
            ::robot_dynamics::Operations {
                multiplications: 7,
                additions: 3,
                divisions: 0,
                sin_cos: 1,
                exponentials: 0,
            },
        ),
        (
            "potential_energy",
            ::robot_dynamics::Operations {
                multiplications: 3,
                additions: 2,
                divisions: 0,
                sin_cos: 2,
                exponentials: 0,
            },
        ),
        (
            "taylor_series",
            ::robot_dynamics::Operations {
                multiplications: 13,
                additions: 10,
                divisions: 0,
                sin_cos: 2,
                exponentials: 0,
            },
        ),
    ];

    /// The largest rounding error of each generated method's values in double and in single precision, SI units: proven
    /// for all positions within the limits, all other arguments up to 1, and any rotation of a moving base. Infinite if
    /// there is no bound: without limits, with fields, or if a divisor may vanish.
    pub const ROUNDING: [(&'static str, f64, f64); 8] = [
        ("mass_matrix", f64::INFINITY, f64::INFINITY),
        ("coriolis_vector", f64::INFINITY, f64::INFINITY),
        ("gravity_vector", f64::INFINITY, f64::INFINITY),
        ("inverse_dynamics", f64::INFINITY, f64::INFINITY),
        ("forward_dynamics", f64::INFINITY, f64::INFINITY),
        ("kinetic_energy", f64::INFINITY, f64::INFINITY),
        ("potential_energy", f64::INFINITY, f64::INFINITY),
        ("taylor_series", f64::INFINITY, f64::INFINITY),
    ];

    /// The table in numbers, as it was written: what the numeric checks read.
    pub fn table(&self) -> ::robot_dynamics::Table<2> {
        ::robot_dynamics::Table::new(
            ::robot_dynamics::Convention::Modified,
            [9.81f64, 0f64, 0f64],
            [
                ::robot_dynamics::Row {
                    a: 0f64,
                    alpha: 0f64,
                    d: 0f64,
                    theta: 0f64,
                    mass: 2f64,
                    com: [0.5f64, 0f64, 0f64],
                    inertia: [0f64, 0f64, 0f64, 0f64, 0f64, 0f64],
                    motor_inertia: 0f64,
                    gear_ratio: 0f64,
                    viscous: 0f64,
                    coulomb: [0f64, 0f64],
                    limits: ::core::option::Option::None,
                    ..::robot_dynamics::Row::new(::robot_dynamics::JointType::Revolute)
                },
                ::robot_dynamics::Row {
                    a: 1f64,
                    alpha: 0f64,
                    d: 0f64,
                    theta: 0f64,
                    mass: 1f64,
                    com: [0.25f64, 0f64, 0f64],
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
                text: "M11 = 1.5625 + 1/2 c2",
                latex: "M_{11} = 1.5625 + \\tfrac{1}{2} \\, c_{2}",
                mathml: "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow><msub><mi>M</mi><mn>11</mn></msub><mo>=</mo><mn>1.5625</mn><mo>+</mo><mfrac><mn>1</mn><mn>2</mn></mfrac><mo>&#x2062;</mo><msub><mi>c</mi><mn>2</mn></msub></mrow></math>",
            },
            ::robot_dynamics::Formula {
                function: "mass_matrix",
                value: "M12",
                text: "M12 = 0.0625 + 1/4 c2",
                latex: "M_{12} = 0.0625 + \\tfrac{1}{4} \\, c_{2}",
                mathml: "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow><msub><mi>M</mi><mn>12</mn></msub><mo>=</mo><mn>0.0625</mn><mo>+</mo><mfrac><mn>1</mn><mn>4</mn></mfrac><mo>&#x2062;</mo><msub><mi>c</mi><mn>2</mn></msub></mrow></math>",
            },
            ::robot_dynamics::Formula {
                function: "mass_matrix",
                value: "M21",
                text: "M21 = 0.0625 + 1/4 c2",
                latex: "M_{21} = 0.0625 + \\tfrac{1}{4} \\, c_{2}",
                mathml: "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow><msub><mi>M</mi><mn>21</mn></msub><mo>=</mo><mn>0.0625</mn><mo>+</mo><mfrac><mn>1</mn><mn>4</mn></mfrac><mo>&#x2062;</mo><msub><mi>c</mi><mn>2</mn></msub></mrow></math>",
            },
            ::robot_dynamics::Formula {
                function: "mass_matrix",
                value: "M22",
                text: "M22 = 0.0625",
                latex: "M_{22} = 0.0625",
                mathml: "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow><msub><mi>M</mi><mn>22</mn></msub><mo>=</mo><mn>0.0625</mn></mrow></math>",
            },
            ::robot_dynamics::Formula {
                function: "coriolis_vector",
                value: "V1",
                text: "V1 = -1/2 s2 qd1 qd2 - 1/4 s2 qd2^2",
                latex: "V_{1} = -\\tfrac{1}{2} \\, s_{2} \\, \\dot{q}_{1} \\, \\dot{q}_{2} - \\tfrac{1}{4} \\, s_{2} \\, \\dot{q}_{2}^{2}",
                mathml: "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow><msub><mi>V</mi><mn>1</mn></msub><mo>=</mo><mo>&#x2212;</mo><mfrac><mn>1</mn><mn>2</mn></mfrac><mo>&#x2062;</mo><msub><mi>s</mi><mn>2</mn></msub><mo>&#x2062;</mo><msub><mover accent=\"true\"><mi>q</mi><mo>&#x2D9;</mo></mover><mn>1</mn></msub><mo>&#x2062;</mo><msub><mover accent=\"true\"><mi>q</mi><mo>&#x2D9;</mo></mover><mn>2</mn></msub><mo>&#x2212;</mo><mfrac><mn>1</mn><mn>4</mn></mfrac><mo>&#x2062;</mo><msub><mi>s</mi><mn>2</mn></msub><mo>&#x2062;</mo><msup><mrow><msub><mover accent=\"true\"><mi>q</mi><mo>&#x2D9;</mo></mover><mn>2</mn></msub></mrow><mn>2</mn></msup></mrow></math>",
            },
            ::robot_dynamics::Formula {
                function: "coriolis_vector",
                value: "V2",
                text: "V2 = 1/4 s2 qd1^2",
                latex: "V_{2} = \\tfrac{1}{4} \\, s_{2} \\, \\dot{q}_{1}^{2}",
                mathml: "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow><msub><mi>V</mi><mn>2</mn></msub><mo>=</mo><mfrac><mn>1</mn><mn>4</mn></mfrac><mo>&#x2062;</mo><msub><mi>s</mi><mn>2</mn></msub><mo>&#x2062;</mo><msup><mrow><msub><mover accent=\"true\"><mi>q</mi><mo>&#x2D9;</mo></mover><mn>1</mn></msub></mrow><mn>2</mn></msup></mrow></math>",
            },
            ::robot_dynamics::Formula {
                function: "gravity_vector",
                value: "G1",
                text: "G1 = 19.62 s1 + 2.4525 s12",
                latex: "G_{1} = 19.62 \\, s_{1} + 2.4525 \\, s_{12}",
                mathml: "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow><msub><mi>G</mi><mn>1</mn></msub><mo>=</mo><mn>19.62</mn><mo>&#x2062;</mo><msub><mi>s</mi><mn>1</mn></msub><mo>+</mo><mn>2.4525</mn><mo>&#x2062;</mo><msub><mi>s</mi><mn>12</mn></msub></mrow></math>",
            },
            ::robot_dynamics::Formula {
                function: "gravity_vector",
                value: "G2",
                text: "G2 = 2.4525 s12",
                latex: "G_{2} = 2.4525 \\, s_{12}",
                mathml: "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow><msub><mi>G</mi><mn>2</mn></msub><mo>=</mo><mn>2.4525</mn><mo>&#x2062;</mo><msub><mi>s</mi><mn>12</mn></msub></mrow></math>",
            },
            ::robot_dynamics::Formula {
                function: "inverse_dynamics",
                value: "tau1",
                text: "tau1 = 19.62 s1 + 2.4525 s12 - 1/2 s2 qd1 qd2 - 1/4 s2 qd2^2 + (1.5625 + 1/2 c2) qdd1 + (0.0625 + 1/4 c2) qdd2",
                latex: "\\tau_{1} = 19.62 \\, s_{1} + 2.4525 \\, s_{12} - \\tfrac{1}{2} \\, s_{2} \\, \\dot{q}_{1} \\, \\dot{q}_{2} - \\tfrac{1}{4} \\, s_{2} \\, \\dot{q}_{2}^{2} + \\left(1.5625 + \\tfrac{1}{2} \\, c_{2}\\right) \\, \\ddot{q}_{1} + \\left(0.0625 + \\tfrac{1}{4} \\, c_{2}\\right) \\, \\ddot{q}_{2}",
                mathml: "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow><msub><mi>τ</mi><mn>1</mn></msub><mo>=</mo><mn>19.62</mn><mo>&#x2062;</mo><msub><mi>s</mi><mn>1</mn></msub><mo>+</mo><mn>2.4525</mn><mo>&#x2062;</mo><msub><mi>s</mi><mn>12</mn></msub><mo>&#x2212;</mo><mfrac><mn>1</mn><mn>2</mn></mfrac><mo>&#x2062;</mo><msub><mi>s</mi><mn>2</mn></msub><mo>&#x2062;</mo><msub><mover accent=\"true\"><mi>q</mi><mo>&#x2D9;</mo></mover><mn>1</mn></msub><mo>&#x2062;</mo><msub><mover accent=\"true\"><mi>q</mi><mo>&#x2D9;</mo></mover><mn>2</mn></msub><mo>&#x2212;</mo><mfrac><mn>1</mn><mn>4</mn></mfrac><mo>&#x2062;</mo><msub><mi>s</mi><mn>2</mn></msub><mo>&#x2062;</mo><msup><mrow><msub><mover accent=\"true\"><mi>q</mi><mo>&#x2D9;</mo></mover><mn>2</mn></msub></mrow><mn>2</mn></msup><mo>+</mo><mrow><mo>(</mo><mn>1.5625</mn><mo>+</mo><mfrac><mn>1</mn><mn>2</mn></mfrac><mo>&#x2062;</mo><msub><mi>c</mi><mn>2</mn></msub><mo>)</mo></mrow><mo>&#x2062;</mo><msub><mover accent=\"true\"><mi>q</mi><mo>&#xA8;</mo></mover><mn>1</mn></msub><mo>+</mo><mrow><mo>(</mo><mn>0.0625</mn><mo>+</mo><mfrac><mn>1</mn><mn>4</mn></mfrac><mo>&#x2062;</mo><msub><mi>c</mi><mn>2</mn></msub><mo>)</mo></mrow><mo>&#x2062;</mo><msub><mover accent=\"true\"><mi>q</mi><mo>&#xA8;</mo></mover><mn>2</mn></msub></mrow></math>",
            },
            ::robot_dynamics::Formula {
                function: "inverse_dynamics",
                value: "tau2",
                text: "tau2 = 2.4525 s12 + 1/4 s2 qd1^2 + (0.0625 + 1/4 c2) qdd1 + 0.0625 qdd2",
                latex: "\\tau_{2} = 2.4525 \\, s_{12} + \\tfrac{1}{4} \\, s_{2} \\, \\dot{q}_{1}^{2} + \\left(0.0625 + \\tfrac{1}{4} \\, c_{2}\\right) \\, \\ddot{q}_{1} + 0.0625 \\, \\ddot{q}_{2}",
                mathml: "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow><msub><mi>τ</mi><mn>2</mn></msub><mo>=</mo><mn>2.4525</mn><mo>&#x2062;</mo><msub><mi>s</mi><mn>12</mn></msub><mo>+</mo><mfrac><mn>1</mn><mn>4</mn></mfrac><mo>&#x2062;</mo><msub><mi>s</mi><mn>2</mn></msub><mo>&#x2062;</mo><msup><mrow><msub><mover accent=\"true\"><mi>q</mi><mo>&#x2D9;</mo></mover><mn>1</mn></msub></mrow><mn>2</mn></msup><mo>+</mo><mrow><mo>(</mo><mn>0.0625</mn><mo>+</mo><mfrac><mn>1</mn><mn>4</mn></mfrac><mo>&#x2062;</mo><msub><mi>c</mi><mn>2</mn></msub><mo>)</mo></mrow><mo>&#x2062;</mo><msub><mover accent=\"true\"><mi>q</mi><mo>&#xA8;</mo></mover><mn>1</mn></msub><mo>+</mo><mn>0.0625</mn><mo>&#x2062;</mo><msub><mover accent=\"true\"><mi>q</mi><mo>&#xA8;</mo></mover><mn>2</mn></msub></mrow></math>",
            },
            ::robot_dynamics::Formula {
                function: "kinetic_energy",
                value: "T",
                text: "T = (0.78125 + 1/4 c2) qd1^2 + (0.0625 + 1/4 c2) qd1 qd2 + 0.03125 qd2^2",
                latex: "T = \\left(0.78125 + \\tfrac{1}{4} \\, c_{2}\\right) \\, \\dot{q}_{1}^{2} + \\left(0.0625 + \\tfrac{1}{4} \\, c_{2}\\right) \\, \\dot{q}_{1} \\, \\dot{q}_{2} + 0.03125 \\, \\dot{q}_{2}^{2}",
                mathml: "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow><mi>T</mi><mo>=</mo><mrow><mo>(</mo><mn>0.78125</mn><mo>+</mo><mfrac><mn>1</mn><mn>4</mn></mfrac><mo>&#x2062;</mo><msub><mi>c</mi><mn>2</mn></msub><mo>)</mo></mrow><mo>&#x2062;</mo><msup><mrow><msub><mover accent=\"true\"><mi>q</mi><mo>&#x2D9;</mo></mover><mn>1</mn></msub></mrow><mn>2</mn></msup><mo>+</mo><mrow><mo>(</mo><mn>0.0625</mn><mo>+</mo><mfrac><mn>1</mn><mn>4</mn></mfrac><mo>&#x2062;</mo><msub><mi>c</mi><mn>2</mn></msub><mo>)</mo></mrow><mo>&#x2062;</mo><msub><mover accent=\"true\"><mi>q</mi><mo>&#x2D9;</mo></mover><mn>1</mn></msub><mo>&#x2062;</mo><msub><mover accent=\"true\"><mi>q</mi><mo>&#x2D9;</mo></mover><mn>2</mn></msub><mo>+</mo><mn>0.03125</mn><mo>&#x2062;</mo><msup><mrow><msub><mover accent=\"true\"><mi>q</mi><mo>&#x2D9;</mo></mover><mn>2</mn></msub></mrow><mn>2</mn></msup></mrow></math>",
            },
            ::robot_dynamics::Formula {
                function: "potential_energy",
                value: "U",
                text: "U = -19.62 c1 - 2.4525 c12",
                latex: "U = -19.62 \\, c_{1} - 2.4525 \\, c_{12}",
                mathml: "<math xmlns=\"http://www.w3.org/1998/Math/MathML\"><mrow><mi>U</mi><mo>=</mo><mo>&#x2212;</mo><mn>19.62</mn><mo>&#x2062;</mo><msub><mi>c</mi><mn>1</mn></msub><mo>&#x2212;</mo><mn>2.4525</mn><mo>&#x2062;</mo><msub><mi>c</mi><mn>12</mn></msub></mrow></math>",
            },
        ]
    }

    /// Mass matrix M(q), N x N, both triangles, reflected motor inertias included (kg m^2, kg m or kg). Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong).
    ///
    /// `q`: joint positions, rad.
    ///
    /// Operations: 1 multiplication, 3 additions, sine and cosine of one angle.
    ///
    /// M22 is constant; M11, M12 depend on q2.
    ///
    /// ```text
    /// M11 = 1.5625 + 1/2 c2
    /// M12 = 0.0625 + 1/4 c2
    /// M21 = 0.0625 + 1/4 c2
    /// M22 = 0.0625
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
    /// Operations: 5 multiplications, 2 additions, sine and cosine of one angle.
    ///
    /// V2 depends on q2, qd1; V1 depends on q2, qd1, qd2.
    ///
    /// ```text
    /// V1 = -1/2 s2 qd1 qd2 - 1/4 s2 qd2^2
    /// V2 = 1/4 s2 qd1^2
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
    /// G1 = 19.62 s1 + 2.4525 s12
    /// G2 = 2.4525 s12
    /// with s1 = sin(q1), s12 = sin(q1 + q2)
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
    /// Operations: 13 multiplications, 10 additions, sines and cosines of 2 angles.
    ///
    /// tau1 depends on q1, q2, qd1, qd2, qdd1, qdd2; tau2 depends on q1, q2, qd1, qdd1, qdd2.
    ///
    /// ```text
    /// tau1 = 19.62 s1 + 2.4525 s12 - 1/2 s2 qd1 qd2 - 1/4 s2 qd2^2 + (1.5625 + 1/2 c2) qdd1 + (0.0625 + 1/4 c2) qdd2
    /// tau2 = 2.4525 s12 + 1/4 s2 qd1^2 + (0.0625 + 1/4 c2) qdd1 + 0.0625 qdd2
    /// with s1 = sin(q1), s12 = sin(q1 + q2), c2 = cos(q2), s2 = sin(q2)
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
    /// Operations: 16 multiplications, 13 additions, 1 division, sines and cosines of 2 angles.
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
    /// Operations: 7 multiplications, 3 additions, sine and cosine of one angle.
    ///
    /// ```text
    /// T = (0.78125 + 1/4 c2) qd1^2 + (0.0625 + 1/4 c2) qd1 qd2 + 0.03125 qd2^2
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
    /// U = -19.62 c1 - 2.4525 c12
    /// with c1 = cos(q1), c12 = cos(q1 + q2)
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

    /// Taylor coefficients q_0, q_1, ... of the motion q(t) = sum q_k t^k that starts at t = 0 from `q` and `qd` under the constant `tau`, up to `order` (2 to 30); zero beyond. Coulomb friction keeps the sign that it has at the start: the series ends where a joint reverses.
    ///
    /// `q`: joint positions, rad; `qd`: joint velocities, rad per s; `tau`: joint forces and torques, N m.
    ///
    /// Operations of the equations of motion at each order, inner sums of products apart: 13 multiplications, 10 additions, sines and cosines of 2 angles.
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
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::MassMatrix<2> for TwoRods {
    const WORK: u32 = 44;

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
        let t_1_ = real(0.25) * c_2_;
        let t_2_ = t_1_ + t_1_;
        let t_3_ = real(1.5625) + t_2_;
        let t_4_ = real(0.0625) + t_1_;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([
                [t_3_, t_4_],
                [t_4_, real(0.0625)],
            ]),
        )
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::CoriolisVector<2> for TwoRods {
    const WORK: u32 = 47;

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
        let qd_1_ = qd.data.0[0][0];
        let qd_2_ = qd.data.0[0][1];
        let t_1_ = real(0.25) * s_2_;
        let t_2_ = qd_1_ * qd_1_;
        let t_3_ = t_1_ * t_2_;
        let t_4_ = qd_1_ + qd_2_;
        let t_5_ = t_4_ * t_4_;
        let t_6_ = (-t_1_).mul_add(t_5_, t_3_);
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t_6_, t_3_]]),
        )
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::GravityVector<2> for TwoRods {
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
        let t_1_ = c_1_.mul_add(s_2_, s_1_ * c_2_);
        let t_2_ = real(2.4525) * t_1_;
        let t_3_ = real(19.62).mul_add(s_1_, t_2_);
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t_3_, t_2_]]),
        )
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::InverseDynamics<2> for TwoRods {
    const WORK: u32 = 103;

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
        let t_1_ = qdd_1_ + qdd_2_;
        let t_2_ = real(0.25) * c_2_;
        let t_3_ = real(9.81).mul_add(s_1_, qdd_1_);
        let t_4_ = real(0.25) * s_2_;
        let t_5_ = real(9.81).mul_add(c_1_, qd_1_ * qd_1_);
        let t_6_ = t_2_.mul_add(t_3_, real(0.0625) * t_1_);
        let t_7_ = t_4_.mul_add(t_5_, t_6_);
        let t_8_ = qd_1_ + qd_2_;
        let t_9_ = t_8_ * t_8_;
        let t_10_ = real(19.62).mul_add(s_1_, real(1.5) * qdd_1_);
        let t_11_ = (-t_4_).mul_add(t_9_, t_10_);
        let t_12_ = t_2_.mul_add(t_1_, t_11_);
        let t_13_ = t_7_ + t_12_;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([[t_13_, t_7_]]),
        )
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::ForwardDynamics<2> for TwoRods {
    const WORK: u32 = 110;

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
        let t_1_ = real(0.25) * c_2_;
        let t_2_ = real(9.81) * s_1_;
        let t_3_ = real(0.25) * s_2_;
        let t_4_ = real(9.81).mul_add(c_1_, qd_1_ * qd_1_);
        let t_5_ = t_3_.mul_add(t_4_, t_1_ * t_2_);
        let t_6_ = qd_1_ + qd_2_;
        let t_7_ = t_6_ * t_6_;
        let t_8_ = t_5_ - tau_2_;
        let t_9_ = real(0.0625) + t_1_;
        let t_10_ = real(16.0) * t_9_;
        let t_11_ = real(-19.62).mul_add(s_1_, tau_1_);
        let t_12_ = t_3_.mul_add(t_7_, t_11_);
        let t_13_ = t_12_ - t_5_;
        let t_14_ = t_8_.mul_add(t_10_, t_13_);
        let t_15_ = t_1_ + t_1_;
        let t_16_ = real(1.5625) + t_15_;
        let t_17_ = (-t_9_).mul_add(t_10_, t_16_);
        let t_18_ = real(1.0) / t_17_;
        let t_19_ = t_14_ * t_18_;
        let t_20_ = t_10_.mul_add(t_19_, real(16.0) * t_8_);
        ::robot_dynamics::SingularMassMatrix::test_joint(
            1,
            "knee",
            real(0.0625),
            real(0.0625),
        )?;
        ::robot_dynamics::SingularMassMatrix::test_joint(0, "pivot", t_17_, t_16_)?;
        ::core::result::Result::Ok(
            ::robot_dynamics::nalgebra::SMatrix::from_data(
                ::robot_dynamics::nalgebra::ArrayStorage([[t_19_, -t_20_]]),
            ),
        )
    }

    #[inline]
    fn momenta(&self) -> ::core::option::Option<&dyn ::robot_dynamics::Momenta<2>> {
        ::core::option::Option::Some(self)
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::TaylorDynamics<2> for TwoRods {
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
        let s_1_ = ::robot_dynamics::SeriesTerm::sine(term, 0);
        let c_1_ = ::robot_dynamics::SeriesTerm::cosine(term, 0);
        let c_2_ = ::robot_dynamics::SeriesTerm::cosine(term, 1);
        let s_2_ = ::robot_dynamics::SeriesTerm::sine(term, 1);
        let qd_1_ = ::robot_dynamics::SeriesTerm::velocity(term, 0);
        let qd_2_ = ::robot_dynamics::SeriesTerm::velocity(term, 1);
        ::robot_dynamics::SeriesTerm::turn(term, 0, 6);
        ::robot_dynamics::SeriesTerm::turn(term, 1, 8);
        let t_2_ = real(0.25) * c_2_;
        let t_5_ = real(0.25) * s_2_;
        let t_6_ = ::robot_dynamics::SeriesTerm::product(term, 0, qd_1_, qd_1_);
        let t_8_ = real(9.81).mul_add(c_1_, t_6_);
        let t_12_ = ::robot_dynamics::SeriesTerm::product(term, 2, t_5_, t_8_);
        let t_14_ = qd_1_ + qd_2_;
        let t_15_ = ::robot_dynamics::SeriesTerm::product(term, 3, t_14_, t_14_);
        let t_19_ = ::robot_dynamics::SeriesTerm::product(term, 4, t_5_, t_15_);
        let forces = {
            let qdd_1_ = ::robot_dynamics::SeriesTerm::acceleration(term, 0);
            let qdd_2_ = ::robot_dynamics::SeriesTerm::acceleration(term, 1);
            let t_1_ = qdd_1_ + qdd_2_;
            let t_4_ = real(9.81).mul_add(s_1_, qdd_1_);
            let t_10_ = ::robot_dynamics::SeriesTerm::trial(term, 1, t_2_, t_4_);
            let t_11_ = real(0.0625).mul_add(t_1_, t_10_);
            let t_13_ = t_12_ + t_11_;
            let t_18_ = real(19.62).mul_add(s_1_, real(1.5) * qdd_1_);
            let t_20_ = t_18_ - t_19_;
            let t_21_ = ::robot_dynamics::SeriesTerm::trial(term, 5, t_2_, t_1_);
            let t_22_ = t_21_ + t_20_;
            let t_23_ = t_13_ + t_22_;
            [t_23_, t_13_]
        };
        ::robot_dynamics::SeriesTerm::solve(term, forces);
        let qdd_1_ = ::robot_dynamics::SeriesTerm::acceleration(term, 0);
        let qdd_2_ = ::robot_dynamics::SeriesTerm::acceleration(term, 1);
        let t_1_ = qdd_1_ + qdd_2_;
        let t_4_ = real(9.81).mul_add(s_1_, qdd_1_);
        let t_10_ = ::robot_dynamics::SeriesTerm::product(term, 1, t_2_, t_4_);
        let t_21_ = ::robot_dynamics::SeriesTerm::product(term, 5, t_2_, t_1_);
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
        let t_1_ = real(0.25) * c_2_;
        let t_2_ = t_1_ + t_1_;
        let t_3_ = real(1.5625) + t_2_;
        let t_4_ = real(0.0625) + t_1_;
        ::robot_dynamics::nalgebra::SMatrix::from_data(
            ::robot_dynamics::nalgebra::ArrayStorage([
                [t_3_, t_4_],
                [t_4_, real(0.0625)],
            ]),
        )
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::Function<::robot_dynamics::functions::KineticEnergy, 2>
for TwoRods {
    type Arguments = (::robot_dynamics::Entries<2, 1>, ::robot_dynamics::Entries<2, 1>);
    type Values = ::robot_dynamics::Number;
    type Error = ::core::convert::Infallible;
    const ARGUMENTS: &'static [&'static str] = &["q", "qd"];
    const RESULT: &'static str = "kinetic_energy";
    const WORK: u32 = 50;
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
            let t_1_ = qd_1_ * c_2_;
            let t_2_ = qd_1_ + qd_2_;
            let t_3_ = t_2_ * t_2_;
            let t_4_ = real(0.041666666666666664).mul_add(t_3_, qd_1_ * qd_1_);
            let t_5_ = t_1_.mul_add(t_2_, real(3.0) * t_4_);
            let t_6_ = real(0.25) * t_5_;
            t_6_
        })
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::Function<::robot_dynamics::functions::PotentialEnergy, 2>
for TwoRods {
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
            let t_1_ = real(8.0) + c_2_;
            let t_2_ = (-c_1_).mul_add(t_1_, s_1_ * s_2_);
            let t_3_ = real(2.4525) * t_2_;
            t_3_
        })
    }
}

#[automatically_derived]
#[allow(deprecated, unused_variables, clippy::all, clippy::pedantic, clippy::nursery)]
impl ::robot_dynamics::Model<2> for TwoRods {
    const JOINT_NAMES: [&'static str; 2] = Self::JOINT_NAMES;
    const READS_ANGLE: [bool; 2] = [true, true];

    #[inline]
    fn table(&self) -> ::robot_dynamics::Table<2> {
        Self::table(self)
    }

    #[inline]
    fn energies(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<f64, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<f64, 2>,
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
    impl ::robot_dynamics::Evaluate<2> for TwoRods {
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
            ::robot_dynamics::Evaluation::set(
                &mut found_values,
                "taylor_series",
                Self::taylor_series::<
                    T,
                >(self, &at_state.q, &at_state.qd, &at_state.tau, at_state.order),
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
impl ::robot_dynamics::Energy<2> for TwoRods {
    #[inline]
    fn kinetic_energy<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
        qd: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> T {
        Self::kinetic_energy(self, q, qd)
    }

    #[inline]
    fn potential_energy<T: ::robot_dynamics::Scalar>(
        &self,
        q: &::robot_dynamics::nalgebra::SVector<T, 2>,
    ) -> T {
        Self::potential_energy(self, q)
    }
}
