//! The arms whose times are measured.

/// Hands every arm that is measured to the macro `$then`: the name of its files in `tests/data`, its type, its
/// number of joints.
#[macro_export]
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
