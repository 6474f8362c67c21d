//! Items that the numeric algorithms and the simulation share with this crate, and no user needs.

pub use crate::closed_form::{is_homogeneous, is_rotation, nearest_turn};
#[cfg(feature = "std")]
pub use crate::equations_of_motion::inverse_columns;
#[cfg(feature = "std")]
pub use crate::evaluation::{FORMS, Numbers, flat};
pub use crate::exact::two_sum;
#[cfg(feature = "std")]
pub use crate::exact::two_sums;
pub use crate::factorisation::{JointFactors, factor, solve, substitute};
pub use crate::float::{Float, first_non_finite, sin_cos};
pub use crate::friction::DryFriction;
#[cfg(feature = "std")]
pub use crate::friction::JointFriction;
#[cfg(feature = "std")]
pub use crate::fused::{Fused, is_worth_it, with_best_instructions};
pub use crate::joint_name::JointName;
#[cfg(feature = "std")]
pub use crate::place::{Velocities, moves};
pub use crate::random::SplitMix64;
#[cfg(feature = "serde")]
pub use crate::sequences::vectors;
pub use crate::table::Moving;
pub use crate::taylor::Expansion;
#[cfg(feature = "std")]
pub use crate::taylor::mass_matrix;

/// The geometry of a table.
pub mod geometry {
    pub use crate::geometry::*;
}

/// Rotations as quaternions w, x, y, z.
pub mod quaternion {
    pub use crate::quaternion::*;
}
