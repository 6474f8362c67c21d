//! The table of functions.

use super::Argument::{
    Acceleration, Force, Jerk, Order, Position, ReferenceAcceleration, ReferenceVelocity, Snap,
    Velocity, Wrench,
};
use super::Size::{Fixed, Joints, One, Pairs, Parameters};
use super::{Form, Growth, Masses, Row, Search, Second, Set, Shape, Trial};

const VECTOR: Shape = Shape::Matrix(Joints, One);
const SQUARE: Shape = Shape::Matrix(Joints, Joints);
/// For each joint a square matrix.
const SQUARES: Shape = Shape::Each(&SQUARE);
/// A homogeneous transform.
const POSE: Shape = Shape::Matrix(Fixed(4), Fixed(4));
/// Velocities of the tip's origin and of its rotation, or their rates.
const TWIST: Shape = Shape::Matrix(Fixed(6), One);

/// Any number of joints.
const ANY: usize = usize::MAX;
const ASSEMBLED: Option<Second> = Some(Second {
    form: Form::Assembled,
    up_to: ANY,
    trial: Trial::Whole,
});
const OF_SMALL_ARMS: Option<Second> = Some(Second {
    form: Form::Assembled,
    up_to: 3,
    trial: Trial::Whole,
});

/// What most functions do not have: a row says where its function differs.
const USUAL: Row = Row {
    name: "",
    arguments: &[],
    shape: VECTOR,
    refuses: false,
    description: "",
    symbol: None,
    set: Set::ByName,
    provided: None,
    second: None,
    search: Search::Own,
    growth: Growth::Moderate,
    masses: Masses::Inertia,
    compared_with: None,
};

/// Makes the enumeration, the list of its variants and the way to their rows out of the table.
macro_rules! functions {
    ($($(#[$meaning:meta])* $function:ident: $row:expr,)*) => {
        /// A function of the generated model, by its contract name.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Function {
            $($(#[$meaning])* $function,)*
        }

        impl Function {
            /// Every function, in the order in which they are generated and documented.
            pub const ALL: [Function; [$(Function::$function),*].len()] =
                [$(Function::$function),*];

            /// The function's row of the table.
            pub const fn row(self) -> &'static Row {
                match self {
                    $(Function::$function => const { &$row },)*
                }
            }
        }
    };
}

functions! {
    /// M(q), kg m^2 (revolute) or kg (prismatic).
    MassMatrix: Row {
        name: "mass_matrix",
        arguments: &[Position],
        shape: SQUARE,
        description: "Mass matrix M(q), N x N, both triangles, reflected motor inertias included \
            (kg m^2, kg m or kg). Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong).",
        symbol: Some("M"),
        set: Set::Default,
        provided: Some("MassMatrix"),
        ..USUAL
    },

    /// V(q, qd), Coriolis and centrifugal terms.
    CoriolisVector: Row {
        name: "coriolis_vector",
        arguments: &[Position, Velocity],
        description: "Coriolis and centrifugal vector V(q, qd), N m or N: inverse dynamics without gravity, springs, \
            friction and acceleration.",
        symbol: Some("V"),
        set: Set::Default,
        provided: Some("CoriolisVector"),
        second: OF_SMALL_ARMS,
        ..USUAL
    },

    /// G(q), the gradient of the potential energy of gravity.
    GravityVector: Row {
        name: "gravity_vector",
        arguments: &[Position],
        description: "Gravity vector G(q), N m or N: the gradient of the potential energy of gravity, inverse dynamics at \
            rest without springs.",
        symbol: Some("G"),
        set: Set::Default,
        provided: Some("GravityVector"),
        second: ASSEMBLED,
        ..USUAL
    },

    /// F(qd), viscous and dry friction.
    FrictionVector: Row {
        name: "friction_vector",
        arguments: &[Velocity],
        description: "Friction vector F(qd) = viscous qd + sign(qd) (C + (S - C) exp(-(qd/v)^2)), N m or N, with sign(0) = 0: \
            C is the Coulomb friction of the direction, S static friction that falls to it over the velocity v, where \
            the table has one, else C.",
        symbol: Some("F"),
        set: Set::WithFriction,
        masses: Masses::Unread,
        ..USUAL
    },

    /// K(q), the forces of the springs.
    SpringVector: Row {
        name: "spring_vector",
        arguments: &[Position],
        description: "Spring vector K(q) = stiffness (q - rest), N m or N: the gradient of the energy in the springs at the \
            joints, zero where a joint has none.",
        symbol: Some("K"),
        search: Search::None,
        masses: Masses::Unread,
        ..USUAL
    },

    /// tau = M qdd + V + G + K + F.
    InverseDynamics: Row {
        name: "inverse_dynamics",
        arguments: &[Position, Velocity, Acceleration],
        description: "Inverse dynamics tau = M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd), N m or N, as one program; K is of \
            springs, F of friction.",
        symbol: Some("tau"),
        set: Set::Default,
        provided: Some("InverseDynamics"),
        second: OF_SMALL_ARMS,
        ..USUAL
    },

    /// qdd from tau.
    ForwardDynamics: Row {
        name: "forward_dynamics",
        arguments: &[Position, Velocity, Force],
        refuses: true,
        description: "Forward dynamics: the accelerations qdd with M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau, rad/s^2 \
            or m/s^2; K is of springs, F of friction.",
        set: Set::Default,
        provided: Some("ForwardDynamics"),
        second: Some(Second { form: Form::Articulated, up_to: ANY, trial: Trial::Promising }),
        ..USUAL
    },

    /// T(q, qd), with reflected inertias.
    KineticEnergy: Row {
        name: "kinetic_energy",
        arguments: &[Position, Velocity],
        shape: Shape::Number,
        description: "Kinetic energy T(q, qd) = 1/2 qd^T M(q) qd, reflected motor inertias included, J.",
        symbol: Some("T"),
        set: Set::Default,
        ..USUAL
    },

    /// U(q), of gravity, zero at the origin of the world, and of springs.
    PotentialEnergy: Row {
        name: "potential_energy",
        arguments: &[Position],
        shape: Shape::Number,
        description: "Potential energy U(q) = -sum m g.c, zero at the origin of the {frame}, and that of springs, \
            1/2 stiffness (q - rest)^2, J.",
        symbol: Some("U"),
        set: Set::Default,
        ..USUAL
    },

    /// V + G + K + F.
    BiasForce: Row {
        name: "bias_force",
        arguments: &[Position, Velocity],
        description: "Bias force V(q, qd) + G(q) + K(q) + F(qd), N m or N: inverse dynamics without acceleration; K is of \
            springs, F of friction.",
        second: OF_SMALL_ARMS,
        ..USUAL
    },

    /// C(q, qd) from the Christoffel symbols of the first kind.
    CoriolisMatrix: Row {
        name: "coriolis_matrix",
        arguments: &[Position, Velocity],
        shape: SQUARE,
        description: "Coriolis matrix C(q, qd), N x N, from the Christoffel symbols of the first kind: C qd = V, and \
            dM/dt - 2 C is skew-symmetric.",
        symbol: Some("C"),
        // All Christoffel symbols are shorter than a recursion for up to six joints.
        second: Some(Second { form: Form::Assembled, up_to: 8, trial: Trial::Promising }),
        growth: Growth::Steep,
        ..USUAL
    },

    /// B(q) of the configuration-space form.
    CoriolisCoefficients: Row {
        name: "coriolis_coefficients",
        arguments: &[Position],
        shape: Shape::Matrix(Joints, Pairs),
        description: "Coriolis coefficients B(q), N x N(N-1)/2, columns in the order (1,2), (1,3), ..., (N-1,N), of the \
            configuration-space form tau = M qdd + B [qd qd] + C [qd^2] + G.",
        symbol: Some("B"),
        growth: Growth::Steep,
        ..USUAL
    },

    /// C(q) of the configuration-space form.
    CentrifugalCoefficients: Row {
        name: "centrifugal_coefficients",
        arguments: &[Position],
        shape: SQUARE,
        description: "Centrifugal coefficients C(q), N x N, of the configuration-space form \
            tau = M qdd + B [qd qd] + C [qd^2] + G.",
        symbol: Some("C"),
        growth: Growth::Steep,
        ..USUAL
    },

    /// Homogeneous transform of the tip in the world.
    ForwardKinematics: Row {
        name: "forward_kinematics",
        arguments: &[Position],
        shape: POSE,
        description: "Forward kinematics: the homogeneous transform of the {tip} in the {frame}, m.",
        symbol: Some("T"),
        masses: Masses::Unread,
        ..USUAL
    },

    /// Homogeneous transforms of every link frame in the world.
    LinkPoses: Row {
        name: "link_poses",
        arguments: &[Position],
        shape: Shape::Each(&POSE),
        description: "Homogeneous transforms in the {frame} of every link frame whose joint moves, from the base outwards, m.",
        masses: Masses::Unread,
        ..USUAL
    },

    /// Geometric Jacobian of the tip's origin.
    Jacobian: Row {
        name: "jacobian",
        arguments: &[Position],
        shape: Shape::Matrix(Fixed(6), Joints),
        description: "Geometric Jacobian of the {tip}'s origin, 6 x N, rows vx vy vz wx wy wz, in the {frame}.",
        symbol: Some("J"),
        masses: Masses::Unread,
        ..USUAL
    },

    /// d tau/dq and d tau/dqd.
    InverseDynamicsDerivatives: Row {
        name: "inverse_dynamics_derivatives",
        arguments: &[Position, Velocity, Acceleration],
        shape: Shape::Tuple(&[SQUARE, SQUARE]),
        description: "Derivatives of the inverse dynamics, exact: (d tau/dq, d tau/dqd), each N x N, entry (i, j) the derivative of \
            tau_i by joint j. d tau/dqdd is M(q). The stiffness of springs is on the diagonal of d tau/dq, viscous \
            friction on that of d tau/dqd; Coulomb friction counts as constant: its derivative is zero wherever it has \
            one.",
        second: OF_SMALL_ARMS,
        growth: Growth::Steep,
        ..USUAL
    },

    /// d qdd/dq, d qdd/dqd and M^-1.
    ForwardDynamicsDerivatives: Row {
        name: "forward_dynamics_derivatives",
        arguments: &[Position, Velocity, Force],
        shape: Shape::Tuple(&[SQUARE, SQUARE, SQUARE]),
        refuses: true,
        description: "Derivatives of the forward dynamics at qdd = forward_dynamics(q, qd, tau), exact: \
            (d qdd/dq, d qdd/dqd, d qdd/d tau), each N x N, entry (i, j) the derivative of qdd_i by joint j. \
            d qdd/d tau is the inverse of M(q). Coulomb friction counts as constant: its derivative is zero wherever \
            it has one.",
        second: Some(Second { form: Form::Assembled, up_to: ANY, trial: Trial::Unsimplified }),
        search: Search::By(Function::InverseDynamicsDerivatives),
        growth: Growth::Steep,
        ..USUAL
    },

    /// Y(q, qd, qdd), the coefficients of the base inertial parameters in tau - K - F.
    Regressor: Row {
        name: "regressor",
        arguments: &[Position, Velocity, Acceleration],
        shape: Shape::Matrix(Joints, Parameters),
        description: "Regressor Y(q, qd, qdd), N x P, of the P base inertial parameters: \
            Y * base_parameters = tau - K - F, the joint forces without springs and friction.",
        second: ASSEMBLED,
        growth: Growth::Steep,
        compared_with: Some(Function::BaseParameters),
        ..USUAL
    },

    /// The base inertial parameters.
    BaseParameters: Row {
        name: "base_parameters",
        arguments: &[],
        shape: Shape::Matrix(Parameters, One),
        description: "The P base inertial parameters: the smallest set by which the joint forces of every motion are \
            determined, regressor * base_parameters = tau - K - F.",
        search: Search::None,
        compared_with: Some(Function::Regressor),
        ..USUAL
    },

    /// qdd from tau by articulated bodies, without M: accurate where M is nearly singular.
    ForwardDynamicsAba: Row {
        name: "forward_dynamics_aba",
        arguments: &[Position, Velocity, Force],
        refuses: true,
        description: "Forward dynamics by articulated bodies (Featherstone), without M(q): the accelerations qdd with \
            M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau, rad/s^2 or m/s^2. Longer than `forward_dynamics`, and accurate \
            where M(q) is nearly singular: about as many digits are right as the data determine.",
        search: Search::Accuracy,
        ..USUAL
    },

    /// The Taylor coefficients of a motion q(t), from the inverse dynamics over series.
    TaylorSeries: Row {
        name: "taylor_series",
        arguments: &[Position, Velocity, Force, Order],
        shape: Shape::Series,
        refuses: true,
        description: "Taylor coefficients q_0, q_1, ... of the motion q(t) = sum q_k t^k that starts at t = 0 from `q` and `qd` \
            under the constant `tau`, up to `order` (2 to 30); zero beyond. Coulomb friction keeps the sign that it \
            has at the start: the series ends where a joint reverses.",
        provided: Some("TaylorDynamics"),
        second: OF_SMALL_ARMS,
        ..USUAL
    },

    /// J' w
    WrenchTorques: Row {
        name: "wrench_torques",
        arguments: &[Position, Wrench],
        description: "Joint torques J(q)^T w of a wrench at the tip, N m or N, without J: M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau + J(q)^T w.",
        masses: Masses::Unread,
        ..USUAL
    },

    /// J qd
    ToolVelocity: Row {
        name: "tool_velocity",
        arguments: &[Position, Velocity],
        shape: TWIST,
        description: "Velocity of the tip J(q) qd, vx vy vz wx wy wz, in the {frame}, m/s and rad/s, without J.",
        masses: Masses::Unread,
        ..USUAL
    },

    /// J qdd + Jdot qd
    ToolAcceleration: Row {
        name: "tool_acceleration",
        arguments: &[Position, Velocity, Acceleration],
        shape: TWIST,
        description: "Acceleration of the tip J(q) qdd + dJ/dt qd: of its origin and of its rotation, in the {frame}, m/s^2 and \
            rad/s^2, without J and its rate.",
        masses: Masses::Unread,
        ..USUAL
    },

    /// dJ/dt
    JacobianRate: Row {
        name: "jacobian_rate",
        arguments: &[Position, Velocity],
        shape: Shape::Matrix(Fixed(6), Joints),
        description: "Rate dJ/dt of the geometric Jacobian along a motion, 6 x N, rows as in `jacobian`: the acceleration of the \
            tip is J qdd + dJ/dt qd.",
        search: Search::None,
        masses: Masses::Unread,
        ..USUAL
    },

    /// Geometric Jacobian of every link frame's origin.
    LinkJacobians: Row {
        name: "link_jacobians",
        arguments: &[Position],
        shape: Shape::Each(&Shape::Matrix(Fixed(6), Joints)),
        description: "Geometric Jacobians of the origins of all link frames whose joint moves, from the base outwards, each 6 x N, \
            rows vx vy vz wx wy wz, in the {frame}. Columns of joints beyond a link are zero.",
        search: Search::None,
        masses: Masses::Unread,
        ..USUAL
    },

    /// The centre of mass of all links.
    CenterOfMass: Row {
        name: "center_of_mass",
        arguments: &[Position],
        shape: Shape::Matrix(Fixed(3), One),
        description: "Centre of mass of the tool and of all links but those that are locked to the base, in the {frame}, m: that \
            of the complete arm where parameters are neglected.",
        symbol: Some("r"),
        masses: Masses::Center,
        ..USUAL
    },

    /// Its derivative by the joint positions.
    CenterOfMassJacobian: Row {
        name: "center_of_mass_jacobian",
        arguments: &[Position],
        shape: Shape::Matrix(Fixed(3), Joints),
        description: "Jacobian of `center_of_mass`, 3 x N, by rows x y z: its velocity in the {frame} is this times qd.",
        masses: Masses::Center,
        ..USUAL
    },

    /// J M^-1 J'
    OperationalInertiaInverse: Row {
        name: "operational_inertia_inverse",
        arguments: &[Position],
        shape: Shape::Matrix(Fixed(6), Fixed(6)),
        refuses: true,
        description: "Inverse of the inertia that the tip has in task space, J(q) M(q)^-1 J(q)^T, 6 x 6, rows and columns as those of \
            `jacobian`: the acceleration of the tip by a wrench on it. It exists for every arm whose M is regular; where it is \
            regular itself, its inverse is the operational-space inertia (Khatib).",
        search: Search::By(Function::MassMatrix),
        ..USUAL
    },

    /// M qd
    GeneralizedMomentum: Row {
        name: "generalized_momentum",
        arguments: &[Position, Velocity],
        description: "Generalized momentum p = M(q) qd = dT/dqd, N m s or N s, without M.",
        symbol: Some("p"),
        second: OF_SMALL_ARMS,
        ..USUAL
    },

    /// C' qd - G - K - F
    MomentumBias: Row {
        name: "momentum_bias",
        arguments: &[Position, Velocity],
        description: "Rate of the generalized momentum without applied forces, C(q, qd)^T qd - G(q) - K(q) - F(qd), N m or N, with C from the Christoffel symbols: \
            d/dt (M qd) = tau + J^T w + momentum_bias, by which a momentum observer finds the forces that nobody has told it of.",
        second: OF_SMALL_ARMS,
        ..USUAL
    },

    /// M qdd_r + C qd_r + G + K + F
    PassivityTorque: Row {
        name: "passivity_torque",
        arguments: &[Position, Velocity, ReferenceVelocity, ReferenceAcceleration],
        description: "Torque of a passivity-based controller, M(q) qdd_r + C(q, qd) qd_r + G(q) + K(q) + F(qd), N m or N, with C from the \
            Christoffel symbols and without forming it. Also: the control of Slotine and Li.",
        second: OF_SMALL_ARMS,
        ..USUAL
    },

    /// Y_r(q, qd, qd_r, qdd_r), the coefficients of the base inertial parameters in it.
    PassivityRegressor: Row {
        name: "passivity_regressor",
        arguments: &[Position, Velocity, ReferenceVelocity, ReferenceAcceleration],
        shape: Shape::Matrix(Joints, Parameters),
        description: "Regressor Y_r(q, qd, qd_r, qdd_r), N x P, of the P base inertial parameters: \
            Y_r * base_parameters = M qdd_r + C qd_r + G, the `passivity_torque` without springs and friction, from which adaptive control \
            learns (Slotine and Li).",
        search: Search::By(Function::Regressor),
        growth: Growth::Steep,
        compared_with: Some(Function::BaseParameters),
        ..USUAL
    },

    /// The coefficients of the base inertial parameters in T and U.
    EnergyRegressors: Row {
        name: "energy_regressors",
        arguments: &[Position, Velocity],
        shape: Shape::Tuple(&[
            Shape::Matrix(Parameters, One),
            Shape::Matrix(Parameters, One),
        ]),
        description: "Regressors of the energies, two vectors of P numbers, J for a unit of each of the P base inertial parameters: \
            the kinetic energy is the first one times base_parameters, the potential energy of gravity the second one up to a \
            constant.",
        compared_with: Some(Function::BaseParameters),
        ..USUAL
    },

    /// The first and the second derivative of tau by time.
    InverseDynamicsRates: Row {
        name: "inverse_dynamics_rates",
        arguments: &[Position, Velocity, Acceleration, Jerk, Snap],
        shape: Shape::Tuple(&[VECTOR, VECTOR]),
        description: "First and second derivative by time of the inverse dynamics along a motion, (d tau/dt, d2 tau/dt2), N m/s and \
            N m/s^2 (N/s and N/s^2). Viscous friction counts; Coulomb friction counts as constant.",
        second: OF_SMALL_ARMS,
        ..USUAL
    },

    /// The second derivatives of tau, and dM/dq.
    InverseDynamicsSecondDerivatives: Row {
        name: "inverse_dynamics_second_derivatives",
        arguments: &[Position, Velocity, Acceleration],
        shape: Shape::Tuple(&[SQUARES, SQUARES, SQUARES, SQUARES]),
        description: "Second derivatives of the inverse dynamics, exact: (d2 tau/dq dq, d2 tau/dqd dqd, d2 tau/dq dqd, dM/dq), each an \
            array of N matrices N x N. Entry `[i][(j, k)]` is that of tau_i by q_j and q_k, by qd_j and qd_k, by q_j (row) and qd_k \
            (column), and the derivative of M_ij by q_k, which is that of tau_i by qdd_j and q_k. The first two are symmetric in j and k, the \
            last one in i and j. Friction that falls with the velocity is in d2 tau/dqd dqd; that of other friction \
            and of springs is zero.",
        second: OF_SMALL_ARMS,
        search: Search::By(Function::InverseDynamicsDerivatives),
        growth: Growth::Cubic,
        ..USUAL
    },
}
