//! Arms of `testkit/robots` with those functions alone whose times are compared.

macro_rules! every_function {
    ($($table:tt)*) => {
        robot_dynamics::robot_dynamics! {
            $($table)*
            functions: [
                default, bias_force, coriolis_matrix, forward_kinematics, jacobian, regressor,
                inverse_dynamics_derivatives, forward_dynamics_derivatives,
            ],
        }
    };
}
macro_rules! every_function_and_tuples {
    ($($table:tt)*) => { every_function! { $($table)* } };
}
macro_rules! every_function_of_a_long_arm {
    ($($table:tt)*) => { every_function! { $($table)* } };
}

mod for_each;
#[path = "../../robots/src/industrial.rs"]
mod industrial;
#[path = "../../robots/src/textbook.rs"]
mod textbook;
#[path = "../../robots/src/three_axis.rs"]
mod three_axis;

pub use industrial::{Panda, Puma560, Stanford, Ur5};
pub use textbook::TwoLinkSaha;
pub use three_axis::Elbow3r;
