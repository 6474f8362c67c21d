//! The arms that are measured.

/// `robot_dynamics!` for the given table, with the functions that are measured.
macro_rules! every_function {
    ($($table:tt)*) => {
        robot_dynamics::robot_dynamics! {
            $($table)*
            functions: [
                mass_matrix,
                coriolis_vector,
                gravity_vector,
                friction_vector,
                inverse_dynamics,
                forward_dynamics,
                kinetic_energy,
                potential_energy,
                bias_force,
                coriolis_matrix,
                forward_kinematics,
                jacobian,
                inverse_dynamics_derivatives,
                forward_dynamics_derivatives,
                regressor,
            ],
        }
    };
}

#[path = "../../../tests/robots/industrial.rs"]
#[allow(dead_code, unused_imports)]
mod industrial;
#[path = "../../../tests/robots/textbook.rs"]
#[allow(dead_code, unused_imports)]
mod textbook;
#[path = "../../../tests/robots/three_axis.rs"]
#[allow(dead_code, unused_imports)]
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
