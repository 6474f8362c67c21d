//! The base: where it is, and the body of one that moves, in its own frame.
//!
//! Source: R. Featherstone, *Rigid Body Dynamics Algorithms*, Springer 2008, chapter 9: the base is body 0, and gravity is an
//! acceleration of it.

use core::ops::IndexMut;

use dynamics_runtime::internal::geometry::Pose;
use dynamics_runtime::{NAMES_OF_BASE, Row, SingularMassMatrix};
use nalgebra::{Matrix3, Matrix6, Vector3};

use super::inertia::{Inertia, Solid, Wrench};

/// Where a base is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Footing {
    /// In the world.
    pub(super) place: Pose,
    /// In the axes of the base.
    pub(super) gravity: Vector3<f64>,
}

impl Footing {
    /// A base at this place under a gravity in the axes of the world.
    pub(super) fn new(place: Pose, gravity: &Vector3<f64>) -> Self {
        Footing {
            gravity: place.rotation.tr_mul(gravity),
            place,
        }
    }
}

/// The body of a base that moves with what is fixed to it, in frame 0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Body {
    pub(super) solid: Solid,
    /// The tip of a robot without joints.
    pub(super) tip: Pose,
}

impl From<&Row> for Body {
    fn from(row: &Row) -> Self {
        Body {
            solid: Solid::new(row, &Pose::IDENTITY),
            tip: row.tip_in_link(),
        }
    }
}

impl Inertia {
    /// The momenta of unit velocities, linear parts first: `[m 1, -[h]x; [h]x, J]` with `J = tr(S) 1 - S`.
    pub(super) fn matrix(&self) -> Matrix6<f64> {
        let (h, s) = (self.first_moment.cross_matrix(), &self.second_moment);
        let mut matrix = Matrix6::from_diagonal_element(self.mass);
        matrix.fixed_view_mut::<3, 3>(0, 3).copy_from(&-h);
        matrix.fixed_view_mut::<3, 3>(3, 0).copy_from(&h);
        let tensor = Matrix3::from_diagonal_element(s.trace()) - s;
        matrix.fixed_view_mut::<3, 3>(3, 3).copy_from(&tensor);
        matrix
    }
}

impl Wrench {
    /// Sets the six numbers of the base, the first of all forces.
    pub(super) fn set(&self, forces: &mut impl IndexMut<usize, Output = f64>) {
        let entries = self.entries().into_iter().enumerate();
        entries.for_each(|(i, entry)| forces[i] = entry);
    }
}

/// Linear and angular part of the six numbers of the base, the first of all velocities.
pub(super) fn twist(velocities: &impl IndexMut<usize, Output = f64>) -> [Vector3<f64>; 2] {
    [0, 3].map(|k| Vector3::new(velocities[k], velocities[k + 1], velocities[k + 2]))
}

/// Says which number of the base it is.
pub(super) fn named(error: SingularMassMatrix) -> SingularMassMatrix {
    match NAMES_OF_BASE.get(error.joint) {
        Some(name) => error.named(name),
        None => error,
    }
}
