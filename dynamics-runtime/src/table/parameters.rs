//! The standard parameters of the links, in which torques are linear.

use nalgebra::{SVector, Vector3};

#[cfg(feature = "std")]
use super::RuntimeTable;
use super::{Arm, AsArm as _, Row, Table};

/// The standard parameters of a link, in its frame of the table and about that frame's origin. They are the mass m in
/// kg, the first moments m c_x, m c_y, m c_z in kg m, and the inertia tensor's J_xx, J_yy, J_zz, J_xy, J_yz, J_xz in kg
/// m^2.
pub type StandardParameters = SVector<f64, 10>;

impl<const N: usize> Table<N> {
    /// The ten standard inertial parameters of the link of each joint, those of the tool and of the bodies of frames among
    /// those of the links that carry them.
    ///
    /// They do not include motors, springs and friction. The links of joints that follow others are in
    /// [`standard_parameters_of_followers`](Table::standard_parameters_of_followers).
    pub fn standard_parameters(&self) -> [StandardParameters; N] {
        let mut own = standard_parameters(self.arm(), false);
        core::array::from_fn(|_| own.next().expect("a row for each joint"))
    }

    /// The same of the links of the joints that follow others, in the order of [`Table::followers`].
    pub fn standard_parameters_of_followers(&self) -> impl Iterator<Item = StandardParameters> {
        standard_parameters(self.arm(), true)
    }

    /// The ten standard inertial parameters of a base that moves, with those of the bodies that are fixed to it; `None` if it
    /// stands.
    pub fn standard_parameters_of_base(&self) -> Option<StandardParameters> {
        self.arm().base_body().map(|body| parameters(&body))
    }
}

#[cfg(feature = "std")]
impl RuntimeTable {
    /// The ten standard inertial parameters of the link of each joint, as [`Table::standard_parameters`], then those of
    /// the links of followers.
    pub fn standard_parameters(&self) -> Vec<StandardParameters> {
        let links = [false, true].map(|of_followers| standard_parameters(self.arm(), of_followers));
        links.into_iter().flatten().collect()
    }

    /// As [`Table::standard_parameters_of_base`].
    pub fn standard_parameters_of_base(&self) -> Option<StandardParameters> {
        self.arm().base_body().map(|body| parameters(&body))
    }
}

/// The parameters of the links of followers, or of the others.
fn standard_parameters(
    arm: Arm<'_>,
    of_followers: bool,
) -> impl Iterator<Item = StandardParameters> {
    let rows = arm.chain().enumerate();
    let asked_for = rows.filter(move |(_, moving)| moving.is_follower == of_followers);
    asked_for.map(move |(k, moving)| parameters(&arm.with_bodies(k, moving.row)))
}

/// The standard parameters of a row's link.
fn parameters(row: &Row) -> StandardParameters {
    let (m, c) = (row.mass, Vector3::from(row.com));
    let [xx, yy, zz, xy, yz, xz] = row.inertia;
    SVector::from([
        m,
        m * c.x,
        m * c.y,
        m * c.z,
        xx + m * (c.y * c.y + c.z * c.z),
        yy + m * (c.z * c.z + c.x * c.x),
        zz + m * (c.x * c.x + c.y * c.y),
        xy - m * c.x * c.y,
        yz - m * c.y * c.z,
        xz - m * c.z * c.x,
    ])
}
