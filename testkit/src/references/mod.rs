//! The files of `tests/data`: robots, reference values of 25 digits, motions.

mod data;
mod decimal;
mod states;
mod trajectory;

pub use data::read;
pub use decimal::Decimal;
pub use states::{
    JointRow, PlacementFile, ReferenceFile, ReferenceState, RobotFile, Scale, ToolFile,
};
pub use trajectory::{MotionFile, TorqueFile};
