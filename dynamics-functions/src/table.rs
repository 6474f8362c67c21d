//! The table of functions.

use super::Argument::{
    Acceleration, Force, Jerk, Order, Position, ReferenceAcceleration, ReferenceVelocity, Snap,
    Velocity, Wrench,
};
use super::Size::{Fixed, Freedoms, Joints, One, Pairs, Parameters};
use super::{Form, Growth, Masses, Row, Search, Second, Set, Shape, Trial};

const VECTOR: Shape = Shape::Matrix(Freedoms, One);
const SQUARE: Shape = Shape::Matrix(Freedoms, Freedoms);
/// For each degree of freedom a square matrix.
const SQUARES: Shape = Shape::Each(Freedoms, &SQUARE);
/// A number for each base parameter.
const PARAMETERS: Shape = Shape::Matrix(Parameters, One);
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

const TORQUE: Option<[&str; 2]> = Some(["N m", "N"]);
const ACCELERATION: Option<[&str; 2]> = Some(["rad/s^2", "m/s^2"]);
const ENERGY: Option<[&str; 2]> = Some(["J", "J"]);
const LENGTH: Option<[&str; 2]> = Some(["m", "m"]);

/// The columns of most functions: a row says where its function differs.
const USUAL: Row = Row {
    name: "",
    arguments: &[],
    shape: VECTOR,
    refuses: false,
    description: "",
    unit: None,
    symbol: None,
    set: Set::ByName,
    provided: None,
    second: None,
    search: Search::Own,
    growth: Growth::Linear(150),
    masses: Masses::Inertia,
    of_tip: false,
    compared_with: None,
    reads_base: true,
};

/// Makes the enumeration, the list of its variants and the way to their rows out of the table. The table has for
/// each function the name with its arguments and the arrangement of its values, the description, and the columns
/// in which it differs from [`USUAL`].
macro_rules! functions {
    ($(
        $(#[$meaning:meta])*
        $function:ident: $name:ident($($argument:ident),*) -> $shape:expr => {
            $description:literal,
            $($column:ident: $value:expr,)*
        }
    )*) => {
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
                    $(Function::$function => const {
                        &Row {
                            name: stringify!($name),
                            arguments: &[$($argument),*],
                            shape: $shape,
                            description: $description,
                            $($column: $value,)*
                            ..USUAL
                        }
                    },)*
                }
            }
        }
    };
}

functions! {
    /// M(q), kg m^2 (revolute) or kg (prismatic).
    MassMatrix: mass_matrix(Position) -> SQUARE => {
        "Mass matrix M(q), N x N, both triangles, reflected motor inertias included \
            (kg m^2, kg m or kg). Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong).",
        unit: Some(["kg m^2", "kg"]),
        symbol: Some("M"), set: Set::Default, provided: Some("MassMatrix"),
        reads_base: false,
        growth: Growth::Square(18),
    }

    /// V(q, qd), Coriolis and centrifugal terms.
    CoriolisVector: coriolis_vector(Position, Velocity) -> VECTOR => {
        "Coriolis and centrifugal vector V(q, qd), N m or N: inverse dynamics without gravity, springs, \
            friction and acceleration.",
        unit: TORQUE,
        symbol: Some("V"), set: Set::Default, provided: Some("CoriolisVector"),
        second: OF_SMALL_ARMS,
        reads_base: false,
    }

    /// G(q), the gradient of the potential energy of gravity.
    GravityVector: gravity_vector(Position) -> VECTOR => {
        "Gravity vector G(q), N m or N: the gradient of the potential energy of gravity, inverse dynamics at \
            rest without springs.",
        unit: TORQUE,
        symbol: Some("G"), set: Set::Default, provided: Some("GravityVector"), second: ASSEMBLED,
        growth: Growth::Linear(35),
    }

    /// F(qd), viscous and dry friction.
    FrictionVector: friction_vector(Velocity) -> VECTOR => {
        "Friction vector F(qd) = viscous qd + sign(qd) (C + (S - C) exp(-(qd/v)^2)), N m or N, with sign(0) = 0: \
            C is the Coulomb friction of the direction, S static friction that falls to it over the velocity v, where \
            the table has one, else C.",
        unit: TORQUE,
        symbol: Some("F"), set: Set::WithFriction, masses: Masses::Unread,
        reads_base: false,
        growth: Growth::Linear(30),
    }

    /// K(q), the forces of the springs.
    SpringVector: spring_vector(Position) -> VECTOR => {
        "Spring vector K(q) = stiffness (q - rest), N m or N: the gradient of the energy in the springs at the \
            joints, zero where a joint has none.",
        unit: TORQUE,
        symbol: Some("K"), search: Search::None, masses: Masses::Unread,
        reads_base: false,
    }

    /// tau = M qdd + V + G + K + F.
    InverseDynamics: inverse_dynamics(Position, Velocity, Acceleration) -> VECTOR => {
        "Inverse dynamics tau = M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd), N m or N, as one program; K is of \
            springs, F of friction.",
        unit: TORQUE,
        symbol: Some("tau"), set: Set::Default, provided: Some("InverseDynamics"),
        second: OF_SMALL_ARMS,
    }

    /// qdd from tau.
    ForwardDynamics: forward_dynamics(Position, Velocity, Force) -> VECTOR => {
        "Forward dynamics: the accelerations qdd with M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau, rad/s^2 \
            or m/s^2; K is of springs, F of friction.",
        unit: ACCELERATION,
        refuses: true, set: Set::Default, provided: Some("ForwardDynamics"),
        second: Some(Second { form: Form::Articulated, up_to: ANY, trial: Trial::Promising }),
        growth: Growth::Linear(480),
    }

    /// T(q, qd), with reflected inertias.
    KineticEnergy: kinetic_energy(Position, Velocity) -> Shape::Number => {
        "Kinetic energy T(q, qd) = 1/2 qd^T M(q) qd, reflected motor inertias included, J.",
        unit: ENERGY,
        symbol: Some("T"), set: Set::Default,
        reads_base: false,
        growth: Growth::Linear(60),
    }

    /// U(q), of gravity, zero at the origin of the world, and of springs.
    PotentialEnergy: potential_energy(Position) -> Shape::Number => {
        "Potential energy U(q) = -sum m g.c, zero at the origin of the {frame}, and that of springs, \
            1/2 stiffness (q - rest)^2, J.",
        unit: ENERGY,
        symbol: Some("U"), set: Set::Default,
        growth: Growth::Linear(20),
    }

    /// V + G + K + F.
    BiasForce: bias_force(Position, Velocity) -> VECTOR => {
        "Bias force V(q, qd) + G(q) + K(q) + F(qd), N m or N: inverse dynamics without acceleration; K is of \
            springs, F of friction.",
        unit: TORQUE,
        second: OF_SMALL_ARMS,
    }

    /// C(q, qd) from the Christoffel symbols of the first kind.
    CoriolisMatrix: coriolis_matrix(Position, Velocity) -> SQUARE => {
        "Coriolis matrix C(q, qd), N x N, from the Christoffel symbols of the first kind: C qd = V, and \
            dM/dt - 2 C is skew-symmetric.",
        // All Christoffel symbols are shorter than a recursion for up to six joints.
        symbol: Some("C"),
        second: Some(Second { form: Form::Assembled, up_to: 8, trial: Trial::Promising }),
        growth: Growth::Square(48),
        reads_base: false,
    }

    /// B(q) of the configuration-space form.
    CoriolisCoefficients: coriolis_coefficients(Position) -> Shape::Matrix(Freedoms, Pairs) => {
        "Coriolis coefficients B(q), N x N(N-1)/2, columns in the order (1,2), (1,3), ..., (N-1,N), of the \
            configuration-space form tau = M qdd + B [qd qd] + C [qd^2] + G.",
        symbol: Some("B"), growth: Growth::Cube(4),
    }

    /// C(q) of the configuration-space form.
    CentrifugalCoefficients: centrifugal_coefficients(Position) -> SQUARE => {
        "Centrifugal coefficients C(q), N x N, of the configuration-space form \
            tau = M qdd + B [qd qd] + C [qd^2] + G.",
        symbol: Some("C"), growth: Growth::Square(31),
    }

    /// Homogeneous transform of the tip in the world.
    ForwardKinematics: forward_kinematics(Position) -> POSE => {
        "Forward kinematics: the homogeneous transform of the {tip} in the {frame}, m.",
        symbol: Some("T"), masses: Masses::Unread,
        of_tip: true,
        growth: Growth::Linear(60),
    }

    /// Homogeneous transforms of every link frame in the world.
    LinkPoses: link_poses(Position) -> Shape::Each(Joints, &POSE) => {
        "Homogeneous transforms in the {frame} of every link frame whose joint moves, from the base outwards, m.",
        masses: Masses::Unread,
    }

    /// Geometric Jacobian of the tip's origin.
    Jacobian: jacobian(Position) -> Shape::Matrix(Fixed(6), Freedoms) => {
        "Geometric Jacobian of the {tip}'s origin, 6 x N, rows vx vy vz wx wy wz, in the {frame}.",
        symbol: Some("J"), masses: Masses::Unread,
        of_tip: true,
        growth: Growth::Linear(60),
    }

    /// d tau/dq and d tau/dqd.
    InverseDynamicsDerivatives: inverse_dynamics_derivatives(Position, Velocity, Acceleration) -> Shape::Tuple(&[("dtau_dq", SQUARE), ("dtau_dqd", SQUARE)]) => {
        "Derivatives of the inverse dynamics, exact: (d tau/dq, d tau/dqd), each N x N, entry (i, j) the derivative of \
            tau_i by joint j. d tau/dqdd is M(q). The stiffness of springs is on the diagonal of d tau/dq, viscous \
            friction on that of d tau/dqd; Coulomb friction counts as constant: its derivative is zero wherever it has \
            one.",
        second: OF_SMALL_ARMS, growth: Growth::Square(80),
    }

    /// d qdd/dq, d qdd/dqd and M^-1.
    ForwardDynamicsDerivatives: forward_dynamics_derivatives(Position, Velocity, Force) -> Shape::Tuple(&[("dqdd_dq", SQUARE), ("dqdd_dqd", SQUARE), ("dqdd_dtau", SQUARE)]) => {
        "Derivatives of the forward dynamics at qdd = forward_dynamics(q, qd, tau), exact: \
            (d qdd/dq, d qdd/dqd, d qdd/d tau), each N x N, entry (i, j) the derivative of qdd_i by joint j. \
            d qdd/d tau is the inverse of M(q). Coulomb friction counts as constant: its derivative is zero wherever \
            it has one.",
        refuses: true,
        second: Some(Second { form: Form::Assembled, up_to: ANY, trial: Trial::Unsimplified }),
        search: Search::By(Function::InverseDynamicsDerivatives), growth: Growth::Cube(8),
    }

    /// Y(q, qd, qdd), the coefficients of the base inertial parameters in tau - K - F.
    Regressor: regressor(Position, Velocity, Acceleration) -> Shape::Matrix(Freedoms, Parameters) => {
        "Regressor Y(q, qd, qdd), N x P, of the P base inertial parameters: \
            Y * base_parameters = tau - K - F, the joint forces without springs and friction.",
        second: ASSEMBLED, growth: Growth::Square(40), compared_with: Some(Function::BaseParameters),
    }

    /// The base inertial parameters.
    BaseParameters: base_parameters() -> PARAMETERS => {
        "The P base inertial parameters: the smallest set by which the joint forces of every motion are \
            determined, regressor * base_parameters = tau - K - F.",
        search: Search::None, compared_with: Some(Function::Regressor),
        reads_base: false,
    }

    /// qdd from tau by articulated bodies, without M: accurate where M is nearly singular.
    ForwardDynamicsAba: forward_dynamics_aba(Position, Velocity, Force) -> VECTOR => {
        "Forward dynamics by articulated bodies (Featherstone), without M(q): the accelerations qdd with \
            M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau, rad/s^2 or m/s^2. Longer than `forward_dynamics`, and accurate \
            where M(q) is nearly singular: about as many digits are right as the data determine.",
        unit: ACCELERATION,
        refuses: true, search: Search::Accuracy,
        growth: Growth::Linear(480),
    }

    /// The Taylor coefficients of a motion q(t), from the inverse dynamics over series.
    TaylorSeries: taylor_series(Position, Velocity, Force, Order) -> Shape::Series => {
        "Taylor coefficients q_0, q_1, ... of the motion q(t) = sum q_k t^k that starts at t = 0 from `q` and `qd` \
            under the constant `tau`, up to `order` (2 to 30); zero beyond. Coulomb friction keeps the sign that it \
            has at the start: the series ends where a joint reverses.",
        refuses: true, provided: Some("TaylorDynamics"), second: OF_SMALL_ARMS,
    }

    /// J' w
    WrenchTorques: wrench_torques(Position, Wrench) -> VECTOR => {
        "Joint torques J(q)^T w of a wrench at the tip, N m or N, without J: M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau + J(q)^T w.",
        unit: TORQUE,
        masses: Masses::Unread,
        of_tip: true,
        growth: Growth::Linear(60),
    }

    /// J qd
    ToolVelocity: tool_velocity(Position, Velocity) -> TWIST => {
        "Velocity of the tip J(q) qd, vx vy vz wx wy wz, in the {frame}, m/s and rad/s, without J.",
        masses: Masses::Unread,
        of_tip: true,
        growth: Growth::Linear(60),
    }

    /// J qdd + Jdot qd
    ToolAcceleration: tool_acceleration(Position, Velocity, Acceleration) -> TWIST => {
        "Acceleration of the tip J(q) qdd + dJ/dt qd: of its origin and of its rotation, in the {frame}, m/s^2 and \
            rad/s^2, without J and its rate.",
        masses: Masses::Unread,
        of_tip: true,
        growth: Growth::Linear(90),
    }

    /// dJ/dt
    JacobianRate: jacobian_rate(Position, Velocity) -> Shape::Matrix(Fixed(6), Freedoms) => {
        "Rate dJ/dt of the geometric Jacobian along a motion, 6 x N, rows as in `jacobian`: the acceleration of the \
            tip is J qdd + dJ/dt qd.",
        search: Search::None, masses: Masses::Unread,
        of_tip: true,
        growth: Growth::Linear(95),
    }

    /// Geometric Jacobian of every link frame's origin.
    LinkJacobians: link_jacobians(Position) -> Shape::Each(Joints, &Shape::Matrix(Fixed(6), Freedoms)) => {
        "Geometric Jacobians of the origins of all link frames whose joint moves, from the base outwards, each 6 x N, \
            rows vx vy vz wx wy wz, in the {frame}. Columns of joints beyond a link are zero.",
        search: Search::None, masses: Masses::Unread,
        growth: Growth::Square(10),
    }

    /// The centre of mass of all links.
    CenterOfMass: center_of_mass(Position) -> Shape::Matrix(Fixed(3), One) => {
        "Centre of mass of the tool and of all links but those that are locked to the base, in the {frame}, m: that \
            of the complete arm where parameters are neglected.",
        unit: LENGTH,
        symbol: Some("r"), masses: Masses::Center,
    }

    /// Its derivative by the joint positions.
    CenterOfMassJacobian: center_of_mass_jacobian(Position) -> Shape::Matrix(Fixed(3), Freedoms) => {
        "Jacobian of `center_of_mass`, 3 x N, by rows x y z: its velocity in the {frame} is this times qd.",
        masses: Masses::Center,
    }

    /// A, with which A v is the momentum of all bodies.
    CentroidalMomentumMatrix: centroidal_momentum_matrix(Position) -> Shape::Matrix(Fixed(6), Freedoms) => {
        "Centroidal momentum matrix A, 6 x N: A qd is the linear momentum px py pz, kg m/s, then the angular momentum \
            lx ly lz about the centre of mass, kg m^2/s, of what `center_of_mass` counts, in the axes of the {frame}. Rotors \
            have no part in it, and nothing is neglected.",
        symbol: Some("A"), masses: Masses::Center,
    }

    /// dA/dt v
    CentroidalMomentumBias: centroidal_momentum_bias(Position, Velocity) -> Shape::Matrix(Fixed(6), One) => {
        "Rate of the centroidal momentum at constant velocities, dA/dt qd with A of `centroidal_momentum_matrix`, N and \
            N m: A qdd + dA/dt qd is the sum of all outer forces, gravity among them, then their moment about the centre of mass.",
        masses: Masses::Center,
    }

    /// J M^-1 J'
    OperationalInertiaInverse: operational_inertia_inverse(Position) -> Shape::Matrix(Fixed(6), Fixed(6)) => {
        "Inverse of the inertia that the tip has in task space, J(q) M(q)^-1 J(q)^T, 6 x 6, rows and columns as those of \
            `jacobian`: the acceleration of the tip by a wrench on it. It exists for every arm whose M is regular; where it is \
            regular itself, its inverse is the operational-space inertia (Khatib).",
        refuses: true, search: Search::By(Function::MassMatrix), growth: Growth::Square(45),
        of_tip: true,
    }

    /// M qd
    GeneralizedMomentum: generalized_momentum(Position, Velocity) -> VECTOR => {
        "Generalized momentum p = M(q) qd = dT/dqd, N m s or N s, without M.",
        symbol: Some("p"), second: OF_SMALL_ARMS,
        reads_base: false,
    }

    /// C' qd - G - K - F
    MomentumBias: momentum_bias(Position, Velocity) -> VECTOR => {
        "Rate of the generalized momentum without applied forces, C(q, qd)^T qd - G(q) - K(q) - F(qd), N m or N, with C from the Christoffel symbols: \
            d/dt (M qd) = tau + J^T w + momentum_bias, by which a momentum observer finds unknown forces.",
        unit: TORQUE,
        second: OF_SMALL_ARMS,
    }

    /// M qdd_r + C qd_r + G + K + F
    PassivityTorque: passivity_torque(Position, Velocity, ReferenceVelocity, ReferenceAcceleration) -> VECTOR => {
        "Torque of a passivity-based controller, M(q) qdd_r + C(q, qd) qd_r + G(q) + K(q) + F(qd), N m or N, with C from the \
            Christoffel symbols and without forming it. Also: the control of Slotine and Li.",
        unit: TORQUE,
        second: OF_SMALL_ARMS,
    }

    /// Y_r(q, qd, qd_r, qdd_r), the coefficients of the base inertial parameters in it.
    PassivityRegressor: passivity_regressor(Position, Velocity, ReferenceVelocity, ReferenceAcceleration) -> Shape::Matrix(Freedoms, Parameters) => {
        "Regressor Y_r(q, qd, qd_r, qdd_r), N x P, of the P base inertial parameters: \
            Y_r * base_parameters = M qdd_r + C qd_r + G, the `passivity_torque` without springs and friction, from which adaptive control \
            learns (Slotine and Li).",
        search: Search::By(Function::Regressor), growth: Growth::Square(60),
        compared_with: Some(Function::BaseParameters),
    }

    /// The coefficients of the base inertial parameters in T and U.
    EnergyRegressors: energy_regressors(Position, Velocity) -> Shape::Tuple(&[("kinetic_regressor", PARAMETERS), ("potential_regressor", PARAMETERS)]) => {
        "Regressors of the energies, two vectors of P numbers, J for a unit of each of the P base inertial parameters: \
            the kinetic energy is the first one times base_parameters, the potential energy of gravity the second one up to a \
            constant.",
        compared_with: Some(Function::BaseParameters),
    }

    /// The first and the second derivative of tau by time.
    InverseDynamicsRates: inverse_dynamics_rates(Position, Velocity, Acceleration, Jerk, Snap) -> Shape::Tuple(&[("dtau_dt", VECTOR), ("d2tau_dt2", VECTOR)]) => {
        "First and second derivative by time of the inverse dynamics along a motion, (d tau/dt, d2 tau/dt2), N m/s and \
            N m/s^2 (N/s and N/s^2). Viscous friction counts; Coulomb friction counts as constant.",
        second: OF_SMALL_ARMS,
        growth: Growth::Linear(460),
    }

    /// The second derivatives of tau, and dM/dq.
    InverseDynamicsSecondDerivatives: inverse_dynamics_second_derivatives(Position, Velocity, Acceleration) -> Shape::Tuple(&[("d2tau_dq_dq", SQUARES), ("d2tau_dqd_dqd", SQUARES), ("d2tau_dq_dqd", SQUARES), ("dM_dq", SQUARES)]) => {
        "Second derivatives of the inverse dynamics, exact: (d2 tau/dq dq, d2 tau/dqd dqd, d2 tau/dq dqd, dM/dq), each an \
            array of N matrices N x N. Entry `[i][(j, k)]` is that of tau_i by q_j and q_k, by qd_j and qd_k, by q_j (row) and qd_k \
            (column), and the derivative of M_ij by q_k, which is that of tau_i by qdd_j and q_k. The first two are symmetric in j and k, the \
            last one in i and j. Friction that falls with the velocity is in d2 tau/dqd dqd; that of other friction \
            and of springs is zero.",
        second: OF_SMALL_ARMS, search: Search::By(Function::InverseDynamicsDerivatives),
        growth: Growth::Cube(33),
    }
}
