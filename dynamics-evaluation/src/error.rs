//! Errors of robots at run time, and of calls of their functions.

use core::fmt;

use dynamics_runtime::SingularMassMatrix;

/// Why there is no robot.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BuildError {
    /// No joint of the table moves.
    NoJoints,
    /// A cell of the table refers to a field that the robot does not have, by this index.
    NoSuchField(usize),
    /// Two of the functions that are requested have this name.
    Repeated(String),
    /// No program was found for a function, with the reason.
    Failure(String),
    /// The arm has no inverse kinematics in closed form, with the reason.
    NoClosedForm(String),
    /// The program of this function has more than 65,536 numbers of one kind, which have no room in its tape.
    TooLong(String),
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BuildError::NoJoints => {
                write!(
                    f,
                    "no joint moves: expected a table with one joint at least that is not locked"
                )
            }
            BuildError::NoSuchField(index) => {
                write!(
                    f,
                    "a cell holds field {index}, which is not among the robot's fields"
                )
            }
            BuildError::Repeated(name) => write!(f, "`{name}` is requested twice"),
            BuildError::Failure(reason) => f.write_str(reason),
            BuildError::NoClosedForm(why) => write!(
                f,
                "there is no `inverse_kinematics` in closed form, because {why}; numeric inverse kinematics serves every arm"
            ),
            BuildError::TooLong(name) => write!(
                f,
                "the program of `{name}` is too long to be evaluated: let the macro `robot_dynamics!` generate it"
            ),
        }
    }
}

impl core::error::Error for BuildError {}

/// Why a call has no value.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum EvaluationError {
    /// The function of that name was not requested when the robot was made.
    NotDerived(String),
    /// The same of a function that a simulation needs.
    NotSimulated(String),
    /// An argument, or the results, have another length than they must.
    Length {
        /// The argument by its name, or `results`.
        argument: &'static str,
        /// Its length.
        found: usize,
        /// The length that was expected.
        expected: usize,
    },
    /// As many arguments were expected as the function has.
    Arguments {
        /// How many there were.
        found: usize,
        /// The names of those that were expected.
        expected: Vec<&'static str>,
    },
    /// The mass matrix of a state cannot be solved with.
    Singular {
        /// The state in a batch, counted from 0.
        state: Option<usize>,
        /// The name of the joint whose pivot failed.
        joint: String,
        /// The error of generated code there.
        error: SingularMassMatrix,
    },
}

impl fmt::Display for EvaluationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            EvaluationError::NotDerived(function) => {
                write!(
                    f,
                    "`{function}` was not derived: request it when the robot is made"
                )
            }
            EvaluationError::NotSimulated(function) => write!(
                f,
                "a simulation needs `{function}`, which was not derived: request all of \
                 `RuntimeRobot::simulation_functions()` when the robot is made"
            ),
            EvaluationError::Length {
                argument,
                found,
                expected,
            } => write!(
                f,
                "`{argument}` has {found} entries where {expected} are expected"
            ),
            EvaluationError::Arguments { found, expected } => write!(
                f,
                "{found} arguments where {} are expected: {}",
                expected.len(),
                expected.join(", ")
            ),
            EvaluationError::Singular {
                state,
                joint,
                error,
            } => {
                if let Some(state) = state {
                    write!(f, "state {state}: ")?;
                }
                write!(f, "joint `{joint}`: {error}")
            }
        }
    }
}

impl core::error::Error for EvaluationError {}

/// A field of that name is not among the robot's.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct UnknownField {
    /// The name.
    pub name: String,
    /// The fields that there are.
    pub fields: Vec<String>,
}

impl fmt::Display for UnknownField {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let UnknownField { name, fields } = self;
        match &fields[..] {
            [] => write!(f, "no field `{name}`: the robot has none"),
            _ => write!(
                f,
                "no field `{name}`: expected one of {}",
                fields.join(", ")
            ),
        }
    }
}

impl core::error::Error for UnknownField {}
