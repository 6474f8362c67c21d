//! The numeric algorithms against the reference data of `tests/data`, and the checks: one program, which is linked once.

mod check;
mod inverse_kinematics;
mod reference;
mod trees;
