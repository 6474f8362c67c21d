//! Where the base is in the world and the tool on the last link, in any ring.
//!
//! T(xyz) Rz(yaw) Ry(pitch) Rx(roll), the order of URDF.

use crate::linear::{Ring, Symmetric3, Vector3};
use crate::mechanism::Mechanism;
use crate::robot::{Interpretation, Placement, Tool, Value};
use crate::spatial::{
    Central, Turn, enter_x, enter_y, enter_z, leave_x, leave_y, leave_z, tensor_leave_x,
    tensor_leave_y, tensor_leave_z,
};

/// A frame in another one.
pub(super) struct Placed<R> {
    /// Its origin there.
    pub(super) origin: Vector3<R>,
    roll: Turn<R>,
    pitch: Turn<R>,
    yaw: Turn<R>,
}

impl<R: Ring> Placed<R> {
    /// Reads a placement.
    pub(super) fn new<I>(cells: &mut I, placement: &Placement) -> Self
    where
        I: Interpretation<Number = R>,
    {
        let [roll, pitch, yaw] = placement.rpy.each_ref().map(|angle| {
            let (s, c) = cells.sin_cos(angle);
            Turn { s, c }
        });
        Placed {
            origin: vector(cells, &placement.xyz),
            roll,
            pitch,
            yaw,
        }
    }

    /// A vector of the outer frame, in the placed one.
    pub(super) fn enter(&self, v: Vector3<R>) -> Vector3<R> {
        enter_x(self.roll, enter_y(self.pitch, enter_z(self.yaw, v)))
    }

    /// A vector of the placed frame, in the outer one.
    pub(super) fn leave(&self, v: Vector3<R>) -> Vector3<R> {
        leave_z(self.yaw, leave_y(self.pitch, leave_x(self.roll, v)))
    }

    /// A point of the placed frame, in the outer one.
    pub(super) fn leave_point(&self, p: Vector3<R>) -> Vector3<R> {
        self.origin + self.leave(p)
    }

    /// A body of the placed frame, in the outer one.
    pub(super) fn leave_body(&self, body: Central<R>) -> Central<R> {
        let about_y = tensor_leave_y(self.pitch, tensor_leave_x(self.roll, body.inertia));
        Central {
            mass: body.mass,
            com: self.leave_point(body.com),
            inertia: tensor_leave_z(self.yaw, about_y),
        }
    }
}

/// The acceleration of gravity in the axes of frame 0.
pub(crate) fn gravity<I: Interpretation>(cells: &mut I, arm: &Mechanism) -> Vector3<I::Number> {
    let gravity = vector(cells, &arm.gravity);
    match &arm.base {
        Some(base) => Placed::new(cells, base).enter(gravity),
        None => gravity,
    }
}

/// g.p with p the origin of frame 0 in the world: what a mass there has of potential energy, times -1
/// and over the mass. `None` where the two origins are one.
pub(super) fn datum<I: Interpretation>(cells: &mut I, arm: &Mechanism) -> Option<I::Number> {
    let base = arm.base.as_ref()?;
    let gravity = vector(cells, &arm.gravity);
    Some(gravity.dot(vector(cells, &base.xyz)))
}

/// The tool's body, in the last link frame of the table.
pub(super) fn body<I: Interpretation>(cells: &mut I, tool: &Tool) -> Central<I::Number> {
    let body = central(cells, &tool.mass, &tool.com, &tool.inertia);
    Placed::new(cells, &tool.placement).leave_body(body)
}

/// A rigid body, from its cells.
pub(super) fn central<I: Interpretation>(
    cells: &mut I,
    mass: &Value,
    com: &[Value; 3],
    inertia: &[Value; 6],
) -> Central<I::Number> {
    Central {
        mass: cells.value(mass),
        com: vector(cells, com),
        inertia: Symmetric3::from_entries(inertia.each_ref().map(|entry| cells.value(entry))),
    }
}

fn vector<I: Interpretation>(cells: &mut I, vector: &[Value; 3]) -> Vector3<I::Number> {
    Vector3(vector.each_ref().map(|value| cells.value(value)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{Residue, SplitMix64, circle_point};
    use crate::linear::Matrix3;

    type Number = Residue<{ (1 << 61) - 1 }>;

    fn place(random: &mut SplitMix64) -> Placed<Number> {
        let [roll, pitch, yaw] = [(); 3].map(|()| {
            let (s, c) = circle_point(random);
            Turn { s, c }
        });
        Placed {
            origin: numbers(random),
            roll,
            pitch,
            yaw,
        }
    }

    fn numbers(random: &mut SplitMix64) -> Vector3<Number> {
        Vector3([(); 3].map(|()| Number::random(random)))
    }

    /// Rz Ry Rx multiplied out.
    fn rotation(place: &Placed<Number>) -> Matrix3<Number> {
        let (zero, one) = (Number::ZERO, Number::ONE);
        let Turn { s, c } = place.roll;
        let x = Matrix3([[one, zero, zero], [zero, c, -s], [zero, s, c]]);
        let Turn { s, c } = place.pitch;
        let y = Matrix3([[c, zero, s], [zero, one, zero], [-s, zero, c]]);
        let Turn { s, c } = place.yaw;
        let z = Matrix3([[c, -s, zero], [s, c, zero], [zero, zero, one]]);
        z.product(&y).product(&x)
    }

    #[test]
    fn vectors_pass_by_the_product_of_three_rotations() {
        let random = &mut SplitMix64::new(1);
        let (place, v) = (place(random), numbers(random));
        let rotation = rotation(&place);
        assert_eq!(place.leave(v), rotation.apply(v));
        assert_eq!(place.enter(v), rotation.transpose().apply(v));
    }

    #[test]
    fn a_body_passes_with_its_centre_of_mass() {
        let random = &mut SplitMix64::new(2);
        let (place, com, mass) = (place(random), numbers(random), Number::random(random));
        let inertia = Symmetric3::from_upper(&Matrix3([(); 3].map(|()| numbers(random).0)));
        let rotation = rotation(&place);
        let moved = place.leave_body(Central { mass, com, inertia });
        assert_eq!(moved.mass, mass);
        assert_eq!(moved.com, rotation.apply(com) + place.origin);
        assert_eq!(moved.inertia, inertia.rotated(&rotation));
    }
}
