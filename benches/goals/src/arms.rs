//! The arms of `testkit/robots`, with the functions that are measured alone.

macro_rules! every_function {
    ($($table:tt)*) => {
        robot_dynamics::robot_dynamics! {
            $($table)*
            functions: [default, inverse_dynamics_derivatives, forward_dynamics_derivatives],
        }
    };
}
macro_rules! every_function_and_tuples {
    ($($table:tt)*) => { every_function! { $($table)* } };
}
macro_rules! every_function_of_a_long_arm {
    ($($table:tt)*) => { every_function! { $($table)* } };
}

#[path = "../../../testkit/robots/src/industrial.rs"]
mod industrial;
#[macro_use]
#[path = "../../../testkit/robots/src/measured.rs"]
mod measured;
#[path = "../../../testkit/robots/src/textbook.rs"]
mod textbook;
#[path = "../../../testkit/robots/src/three_axis.rs"]
mod three_axis;

pub(crate) use industrial::{Panda, Puma560, Stanford, Ur5};
pub(crate) use textbook::TwoLinkSaha;
pub(crate) use three_axis::Elbow3r;

pub(crate) use for_each_measured_arm as for_each_arm;
