//! The documentation of the generated methods.

use super::formula::formulas;
use super::signature::{Shape, arguments, shape};
use crate::function::Function;
use crate::program::{Operand, Output, Program};
use crate::robot::{JointType, Robot};

/// What a function is, in a line, its shapes, units and other names.
fn description(function: Function) -> &'static str {
    match function {
        Function::MassMatrix => {
            "Mass matrix M(q), N x N, both triangles, reflected motor inertias included \
             (kg m^2, kg m or kg). Also: joint-space inertia matrix, H (Featherstone), B (Siciliano), D (Spong)."
        }
        Function::CoriolisVector => {
            "Coriolis and centrifugal vector V(q, qd), N m or N: inverse dynamics without gravity, friction and \
             acceleration."
        }
        Function::GravityVector => {
            "Gravity vector G(q) = dU/dq, N m or N: inverse dynamics at rest."
        }
        Function::FrictionVector => {
            "Friction vector F(qd) = viscous qd + coulomb sign(qd), N m or N, with sign(0) = 0."
        }
        Function::InverseDynamics => {
            "Inverse dynamics tau = M(q) qdd + V(q, qd) + G(q) + F(qd), N m or N, as one program."
        }
        Function::ForwardDynamics => {
            "Forward dynamics: the accelerations qdd with M(q) qdd + V(q, qd) + G(q) + F(qd) = tau, rad/s^2 or m/s^2."
        }
        Function::ForwardDynamicsAba => {
            "Forward dynamics by articulated bodies (Featherstone), without M(q): the accelerations qdd with \
             M(q) qdd + V(q, qd) + G(q) + F(qd) = tau, rad/s^2 or m/s^2. Longer than `forward_dynamics`, and accurate \
             where M(q) is nearly singular: about as many digits are right as the data determine."
        }
        Function::KineticEnergy => {
            "Kinetic energy T(q, qd) = 1/2 qd^T M(q) qd, reflected motor inertias included, J."
        }
        Function::PotentialEnergy => {
            "Potential energy U(q) = -sum m g.c, zero at the origin of the base frame, J."
        }
        Function::BiasForce => {
            "Bias force V(q, qd) + G(q) + F(qd), N m or N: inverse dynamics without acceleration."
        }
        Function::CoriolisMatrix => {
            "Coriolis matrix C(q, qd), N x N, from the Christoffel symbols of the first kind: C qd = V, and \
             dM/dt - 2 C is skew-symmetric."
        }
        Function::CoriolisCoefficients => {
            "Coriolis coefficients B(q), N x N(N-1)/2, columns in the order (1,2), (1,3), ..., (N-1,N), of the \
             configuration-space form tau = M qdd + B [qd qd] + C [qd^2] + G."
        }
        Function::CentrifugalCoefficients => {
            "Centrifugal coefficients C(q), N x N, of the configuration-space form \
             tau = M qdd + B [qd qd] + C [qd^2] + G."
        }
        Function::ForwardKinematics => {
            "Forward kinematics: the homogeneous transform of the last link frame in the base frame, m."
        }
        Function::LinkPoses => {
            "Homogeneous transforms in the base frame of every link frame whose joint moves, from the base outwards, m."
        }
        Function::Jacobian => {
            "Geometric Jacobian of the last link frame's origin, 6 x N, rows vx vy vz wx wy wz, in the base frame."
        }
        Function::InverseDynamicsDerivatives => {
            "Derivatives of the inverse dynamics, exact: (d tau/dq, d tau/dqd), each N x N, entry (i, j) the derivative of \
             tau_i by joint j. d tau/dqdd is M(q). Viscous friction is on the diagonal of d tau/dqd; Coulomb friction \
             counts as constant: its derivative is zero wherever it has one."
        }
        Function::ForwardDynamicsDerivatives => {
            "Derivatives of the forward dynamics at qdd = forward_dynamics(q, qd, tau), exact: \
             (d qdd/dq, d qdd/dqd, d qdd/d tau), each N x N, entry (i, j) the derivative of qdd_i by joint j. \
             d qdd/d tau is the inverse of M(q). Coulomb friction counts as constant: its derivative is zero wherever \
             it has one."
        }
        Function::Regressor => {
            "Regressor Y(q, qd, qdd), N x P, of the P base inertial parameters: \
             Y * base_parameters = tau - F, the joint forces without friction."
        }
        Function::BaseParameters => {
            "The P base inertial parameters: the smallest set by which the joint forces of every motion are \
             determined, regressor * base_parameters = tau - F."
        }
        Function::TaylorSeries => {
            "Taylor coefficients q_0, q_1, ... of the motion q(t) = sum q_k t^k that starts at t = 0 from `q` and `qd` \
             under the constant `tau`, up to `order` (2 to 30); zero beyond. Coulomb friction keeps the sign that it \
             has at the start: the series ends where a joint reverses."
        }
    }
}

/// The lines of a method's documentation.
pub(super) fn documentation(
    robot: &Robot,
    function: Function,
    program: &Program,
    constants: &[f64],
    notes: &[String],
) -> Vec<String> {
    let mut lines = vec![format!(" {}", description(function)), String::new()];
    if !arguments(function).is_empty() {
        lines.push(format!(" {}", units(robot, function)));
        lines.push(String::new());
    }
    if matches!(function, Function::Regressor | Function::BaseParameters) {
        lines.extend(super::parameters::lines(robot));
    }
    for note in notes {
        lines.extend([note.clone(), String::new()]);
    }
    let each = match function {
        Function::TaylorSeries => {
            " of the equations of motion at each order, inner sums of products apart"
        }
        _ => "",
    };
    lines.push(format!(" Operations{each}: {}.", program.operations()));
    if let Some(formulas) = formulas(robot, program, constants).filter(|_| robot.dof() <= 3) {
        lines.extend(formula_lines(function, robot.dof(), &formulas));
    }
    lines.push(String::new());
    let solves = matches!(
        function,
        Function::ForwardDynamics
            | Function::ForwardDynamicsAba
            | Function::ForwardDynamicsDerivatives
            | Function::TaylorSeries
    );
    if solves {
        lines.push(errors(&unresisted(robot, function, program, constants)));
        lines.push(String::new());
    }
    lines.push(
        " Never panics, never allocates; what depends on an input that is not finite is not finite."
            .to_owned(),
    );
    lines
}

/// When a function that solves with M fails.
fn errors(unresisted: &[&str]) -> String {
    match unresisted {
        [] => " # Errors\n\n `SingularMassMatrix` where M(q) is not positive definite to working precision, or not \
               finite: it names the joint whose pivot failed."
            .to_owned(),
        names => format!(
            " # Errors\n\n `SingularMassMatrix`, at every state of this arm: nothing resists `{}`. It takes a link with \
             inertia about the joint's axis, or a motor.",
            names.join("` and `")
        ),
    }
}

/// The joints whose pivot is the constant 0, whatever the state.
fn unresisted<'r>(
    robot: &'r Robot,
    function: Function,
    program: &Program,
    constants: &[f64],
) -> Vec<&'r str> {
    let n = robot.dof();
    let first = match function {
        // Its pivots are those of the runtime's factorisation.
        Function::TaylorSeries => return Vec::new(),
        Function::ForwardDynamicsDerivatives => 3 * n * n,
        _ => n,
    };
    let pivots = &program.outputs[first..first + n];
    let is_zero = |pivot: &Output| match pivot.operand {
        Operand::Constant(id) => constants[id.index()] == 0.0,
        _ => false,
    };
    let joints = robot.joints().zip(pivots);
    let unresisted = joints.filter(|(_, pivot)| is_zero(pivot));
    unresisted.map(|(row, _)| row.name.as_str()).collect()
}

/// The units of the arguments.
fn units(robot: &Robot, function: Function) -> String {
    let is = |joint_type| robot.joints().all(|row| row.joint_type == joint_type);
    let (position, force) = match (is(JointType::Revolute), is(JointType::Prismatic)) {
        (true, _) => ("rad", "N m"),
        (_, true) => ("m", "N"),
        _ => ("rad or m", "N m or N"),
    };
    let unit = |argument: &&str| match *argument {
        "q" => format!("`q`: joint positions, {position}"),
        "qd" => format!("`qd`: joint velocities, {position} per s"),
        "qdd" => format!("`qdd`: joint accelerations, {position} per s^2"),
        _ => format!("`tau`: joint forces and torques, {force}"),
    };
    let units: Vec<_> = arguments(function).iter().map(unit).collect();
    format!("{}.", units.join("; "))
}

/// The formulas, each behind the name of its entry.
fn formula_lines(function: Function, dof: usize, formulas: &[String]) -> Vec<String> {
    let (symbol, columns) = match (shape(function, dof), function) {
        (Shape::Number, Function::KineticEnergy) => ("T", 1),
        (Shape::Number, _) => ("U", 1),
        (Shape::Matrix(_, columns), Function::MassMatrix) => ("M", columns),
        (Shape::Matrix(_, 1), Function::CoriolisVector) => ("V", 1),
        (Shape::Matrix(_, 1), Function::GravityVector) => ("G", 1),
        (Shape::Matrix(_, 1), Function::FrictionVector) => ("F", 1),
        (Shape::Matrix(_, 1), Function::InverseDynamics) => ("tau", 1),
        (Shape::Matrix(_, columns), Function::CoriolisCoefficients) => ("B", columns),
        (
            Shape::Matrix(_, columns),
            Function::CoriolisMatrix | Function::CentrifugalCoefficients,
        ) => ("C", columns),
        _ => return Vec::new(),
    };
    let name = |index: usize| match shape(function, dof) {
        Shape::Number => symbol.to_owned(),
        _ if columns == 1 && symbol != "M" && symbol != "C" && symbol != "B" => {
            format!("{symbol}{}", index + 1)
        }
        _ => format!("{symbol}{}{}", index / columns + 1, index % columns + 1),
    };
    let mut lines = vec![String::new(), " ```text".to_owned()];
    lines.extend(
        formulas
            .iter()
            .enumerate()
            .map(|(index, formula)| format!(" {} = {formula}", name(index))),
    );
    lines.push(" ```".to_owned());
    lines
}
