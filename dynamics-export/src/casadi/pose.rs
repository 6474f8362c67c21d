//! Derivatives by the pose of a base that moves: twelve numbers, its rotation R by rows, then its position p.
//!
//! Gravity is all that forces know of the pose. In axes of the base it is R^T g, and acts as an acceleration of the base
//! by the opposite. With M_l the column of M that belongs to the linear velocity along axis l of the base, the parts of
//! forces and accelerations that depend on R are
//!
//!   tau = .. - sum_l M_l (R^T g)_l,          so that  d tau / d R_kl = -M_l g_k
//!   qdd = .. + sum_l e_l (R^T g)_l,          so that  d qdd / d R_kl = e_l g_k
//!
//! The centre of mass is p + R c. The derivative by a turn exp(phi) in axes of the base is -R [c]x, whose product with R^T
//! has the entries of c.

use crate::body::{Body, opposite};
use dynamics_symbolic::function::Function;
use dynamics_symbolic::robot::Robot;

/// The numbers of a rotation, which come before those of the position.
const OF_ROTATION: usize = 9;

/// Derivatives of a function by the pose: gravity, and where the rest stands among the values of programs.
pub(super) struct OfPose {
    function: Function,
    /// The degrees of freedom.
    freedoms: usize,
    /// Gravity along the axes of the world, without a text where it is zero.
    gravity: [Option<String>; 3],
}

impl OfPose {
    pub(super) fn new(robot: &Robot, function: Function, body: &Body<'_>) -> Self {
        let gravity = robot.gravity.each_ref();
        OfPose {
            function,
            freedoms: robot.freedoms().all(),
            gravity: gravity.map(|along| (!along.is_zero()).then(|| body.cell(along))),
        }
    }

    /// The derivative of a value by a number of the pose. `values` are those of the first derivatives' program.
    pub(super) fn first(
        &self,
        values: &[Option<String>],
        row: usize,
        number: usize,
    ) -> Option<String> {
        if self.function == Function::CenterOfMass {
            return self.center_of_mass(values, row, number);
        }
        let (gravity, axis) = self.gravity(number)?;
        if matches!(
            self.function,
            Function::ForwardDynamics | Function::ForwardDynamicsAba
        ) {
            return (row == axis).then(|| gravity.clone());
        }
        // Behind the derivatives by q and qd.
        let mass = 2 * self.freedoms * self.freedoms;
        by_gravity(&values[mass + row * self.freedoms + axis], gravity)
    }

    /// The derivative of a force by a number of the pose and a position. `values` are those of second derivatives.
    pub(super) fn second(
        &self,
        values: &[Option<String>],
        force: usize,
        number: usize,
        position: usize,
    ) -> Option<String> {
        let (gravity, axis) = self.gravity(number)?;
        // dM/dq is the last of four arrays.
        let matrix = 3 * self.freedoms + force;
        let row = matrix * self.freedoms + axis;
        by_gravity(&values[row * self.freedoms + position], gravity)
    }

    /// Gravity along the row of R in which a number of the pose stands, and the number's column.
    fn gravity(&self, number: usize) -> Option<(&String, usize)> {
        let along = self.gravity.get(number / 3)?;
        Some((along.as_ref()?, number % 3))
    }

    /// The derivative of a coordinate of the centre of mass c = p + R s by a number of the pose. That by R_ij is s_j for c_i.
    /// `values` are the entries of the Jacobian, whose column of a turn about axis k of the base is R (e_k x s).
    fn center_of_mass(
        &self,
        values: &[Option<String>],
        row: usize,
        number: usize,
    ) -> Option<String> {
        let (along, axis) = (number / 3, number % 3);
        if number >= OF_ROTATION {
            return (row == number - OF_ROTATION).then(|| "1.0".to_owned());
        }
        if row != along {
            return None;
        }
        let (of_base, turn) = ((axis + 1) % 3, (axis + 2) % 3);
        let term = |of_world: usize| {
            let by_turn = values[of_world * self.freedoms + 3 + turn].as_ref()?;
            Some(format!("base[{}] * {by_turn}", 3 * of_world + of_base))
        };
        let terms: Vec<_> = (0..3).filter_map(term).collect();
        (!terms.is_empty()).then(|| terms.join(" + "))
    }
}

/// Minus the product of an entry of M, or of its derivative, and gravity.
fn by_gravity(entry: &Option<String>, gravity: &str) -> Option<String> {
    let entry = entry.as_ref()?;
    Some(format!("{entry} * {}", opposite(gravity)))
}
