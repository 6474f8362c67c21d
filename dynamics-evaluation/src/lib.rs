//! Robots at run time: the equations of motion of an arm that is not known when a program is compiled.
//!
//! [`RuntimeRobot`] derives and proves the functions of a robot as the macro `robot_dynamics!` does, and
//! evaluates their programs without a compiler: at one state, or at many in the lanes of vector
//! registers. Checks take it as it is, simulations its [`dynamics`](RuntimeRobot::dynamics).
#![forbid(unsafe_code)]

mod at;
mod block;
mod bounds;
mod checked;
mod closed_form;
mod compiled;
mod error;
mod file;
mod identified;
mod layout;
mod methods;
mod possible;
mod reach;
mod read;
mod robot;
mod rows;
mod simulated;
mod single;
mod table;
mod tape;
mod validate;
mod value;

pub use dynamics_numeric;
pub use dynamics_runtime;
pub use dynamics_simulation;

pub use closed_form::{ClosedForm, ClosedSolution};
pub use error::{BuildError, EvaluationError, UnknownField};
pub use file::{FileError, FileMistake, ReadOptions};
#[doc(hidden)]
pub use file::{read_file, read_source, read_text, text_of_joints};
pub use identified::{IdentificationError, ImpossibleLink, JointFriction, NearestPossible};
pub use reach::RuntimePlace;
pub use robot::RuntimeRobot;
pub use rows::Arrangement;
pub use simulated::RuntimeDynamics;
pub use value::Value;
