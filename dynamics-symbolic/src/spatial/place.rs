//! Constant places of frames in other frames.

use super::turn::{Axis, Turn, enter_about, leave_about, tensor_leave_about};
use super::{Body, Central};
use crate::linear::{Ring, Vector3};

/// Rotations about coordinate axes, the outermost first, each in the frame that the ones before it turned.
#[derive(Clone, Debug)]
pub struct Turns<R>(pub Vec<(Axis, Turn<R>)>);

impl<R: Ring> Turns<R> {
    /// A vector of the outer frame, in the turned one.
    pub fn enter(&self, v: Vector3<R>) -> Vector3<R> {
        let turns = self.0.iter();
        turns.fold(v, |v, (axis, turn)| enter_about(*axis, *turn, v))
    }

    /// A vector of the turned frame, in the outer one.
    pub fn leave(&self, v: Vector3<R>) -> Vector3<R> {
        self.fold(v, |v, axis, turn| leave_about(axis, turn, v))
    }

    /// A body of the turned frame, in the outer one.
    pub fn leave_body(&self, body: Body<R>) -> Body<R> {
        self.fold(body, |body, axis, turn| body.left(axis, turn))
    }

    /// Takes a quantity from the turned frame to the outer one: `leave` takes it out of one turn.
    pub fn fold<T>(&self, inner: T, mut leave: impl FnMut(T, Axis, Turn<R>) -> T) -> T {
        let turns = self.0.iter().rev();
        turns.fold(inner, |inner, (axis, turn)| leave(inner, *axis, *turn))
    }

    /// The same in other numbers.
    pub fn map<S>(&self, mut turn: impl FnMut(Turn<R>) -> Turn<S>) -> Turns<S> {
        let turns = self.0.iter();
        Turns(turns.map(|&(axis, old)| (axis, turn(old))).collect())
    }
}

/// A frame in another one.
#[derive(Clone, Debug)]
pub struct Place<R> {
    /// Its origin there.
    pub origin: Vector3<R>,
    /// Its axes there.
    pub turns: Turns<R>,
}

impl<R: Ring> Place<R> {
    /// A point of the placed frame, in the outer one.
    pub fn leave_point(&self, p: Vector3<R>) -> Vector3<R> {
        self.origin + self.turns.leave(p)
    }

    /// A body of the placed frame, in the outer one.
    pub fn leave_body(&self, body: Central<R>) -> Central<R> {
        let leave = |inertia, axis, turn| tensor_leave_about(axis, turn, inertia);
        Central {
            mass: body.mass,
            com: self.leave_point(body.com),
            inertia: self.turns.fold(body.inertia, leave),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::{Residue, SplitMix64, circle_point};
    use crate::linear::{Matrix3, Symmetric3};

    type Number = Residue<{ (1 << 61) - 1 }>;

    fn place(random: &mut SplitMix64) -> Place<Number> {
        let turns = [Axis::Z, Axis::Y, Axis::X];
        Place {
            origin: numbers(random),
            turns: Turns(
                turns
                    .map(|axis| (axis, circle_point(random).into()))
                    .to_vec(),
            ),
        }
    }

    fn numbers(random: &mut SplitMix64) -> Vector3<Number> {
        Vector3([(); 3].map(|()| Number::random(random)))
    }

    /// Rz Ry Rx multiplied out.
    fn rotation(place: &Place<Number>) -> Matrix3<Number> {
        let (zero, one) = (Number::ZERO, Number::ONE);
        let [yaw, pitch, roll] = [0, 1, 2].map(|k| place.turns.0[k].1);
        let Turn { s, c } = roll;
        let x = Matrix3([[one, zero, zero], [zero, c, -s], [zero, s, c]]);
        let Turn { s, c } = pitch;
        let y = Matrix3([[c, zero, s], [zero, one, zero], [-s, zero, c]]);
        let Turn { s, c } = yaw;
        let z = Matrix3([[c, -s, zero], [s, c, zero], [zero, zero, one]]);
        z.product(&y).product(&x)
    }

    #[test]
    fn vectors_pass_by_the_product_of_three_rotations() {
        let random = &mut SplitMix64::new(1);
        let (place, v) = (place(random), numbers(random));
        let rotation = rotation(&place);
        assert_eq!(place.turns.leave(v), rotation.apply(v));
        assert_eq!(place.turns.enter(v), rotation.transpose().apply(v));
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
