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
#[path = "../../../testkit/robots/src/textbook.rs"]
mod textbook;
#[path = "../../../testkit/robots/src/three_axis.rs"]
mod three_axis;

pub(crate) use industrial::{Panda, Puma560, Stanford, Ur5};
pub(crate) use textbook::TwoLinkSaha;
pub(crate) use three_axis::Elbow3r;

/// Hands every arm to the macro `$then`: the name of its files in `tests/data`, its type, its
/// number of joints.
macro_rules! for_each_arm {
    ($then:ident) => {
        $then! {
            two_link_saha: TwoLinkSaha, 2;
            elbow_3r: Elbow3r, 3;
            stanford: Stanford, 6;
            puma560: Puma560, 6;
            ur5: Ur5, 6;
            panda: Panda, 7;
        }
    };
}
pub(crate) use for_each_arm;
