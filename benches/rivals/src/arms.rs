//! The arms that are measured.

pub(crate) use robots::for_each_measured_arm as for_each_arm;
pub(crate) use robots::{Elbow3r, Panda, Puma560, Stanford, TwoLinkSaha, Ur5};
