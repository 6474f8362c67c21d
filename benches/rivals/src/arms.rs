//! The arms that are measured.

pub(crate) use robots::{Elbow3r, Panda, Puma560, Stanford, TwoLinkSaha, Ur5};

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
