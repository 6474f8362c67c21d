//! The body of the base, in the base's own frame.

use nalgebra::{Matrix3, Matrix6, Vector3};

use crate::Row;
use crate::newton_euler::inertia::{Inertia, tensor};

/// The body of the base with what is fixed to it, in frame 0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Body {
    pub(super) mass: f64,
    pub(super) com: Vector3<f64>,
    /// About the centre of mass.
    pub(super) tensor: Matrix3<f64>,
    /// About the origin of the frame.
    pub(super) inertia: Inertia,
}

impl From<&Row> for Body {
    fn from(row: &Row) -> Self {
        let (com, tensor) = (Vector3::from(row.com), tensor(row));
        Body {
            mass: row.mass,
            com,
            tensor,
            inertia: Inertia::new(row.mass, &com, &tensor),
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
