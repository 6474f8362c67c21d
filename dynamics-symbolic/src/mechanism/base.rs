//! A base that moves: six joints that stand at zero and have velocities.
//!
//! Three joints slide along the axes x, y and z of the base, and three turn about them, in this order. All are at zero, so
//! that their axes are those of the base, and the last one carries its body. The mass matrix, Jacobians and the forces
//! of a given acceleration are then those of the base itself.
//!
//! The accelerations are not. A joint carries the axes of those behind it, while the six velocities of the base, v and w, are
//! written in axes that turn with the base. If the base has dv/dt and dw/dt in its own axes and w = (x, y, z), the joints have
//!
//!   dv/dt + w x v   and   dw/dt - (y z, -x z, x y).
//!
//! The added term is D(w) u of the velocity u itself. Column j of D is what the joints k > j, which turn with joint j,
//! do to its axis: the sum of w_k e_k x e_j. If C and dJ/dt are those of the six joints, those of the base are
//!
//!   C + M D   and   dJ/dt + J D.
//!
//! The first is the matrix of Echeandia and Wensing (2021), the sum of J' (I dJ/dt + B J) over all bodies, with the rate of
//! each column of J against a frame at rest, written in the axes of the body.
//!
//! How a base that moves differs from a joint:
//!
//! - The velocities of the base are in axes that turn with it, so that its accelerations are du/dt + D(w) u.
//!   `Symbols` adds the second term. C, the rate of J and momenta take D from `BaseRate`. `derive::displacement`
//!   turns derivatives by these joints into those by displacements.
//! - The rotation is nine symbols whose values at the graph's point are a rotation (`Graph::rotation`): orthogonality
//!   cancels by value.
//! - All ten parameters stay on the base (`Chain::group_parameters`, `base::observe`).
//! - The proof has Hamel's equations, with T and U from poses in the world at a random rational rotation
//!   (`definition/configuration`).

use super::{Aligned, Forces, Joint, Law, Origin};
use crate::exact::Rational;
use crate::linear::Ring;
use crate::robot::{Base, Body, Placement, Value};
use crate::spatial::AxisMotion;

/// The joints of a base with this body.
pub(super) fn joints(body: &Body) -> Vec<Joint> {
    let motions = [AxisMotion::Slides, AxisMotion::Turns].into_iter();
    let joints = motions.flat_map(|motion| (0..3).map(move |axis| (motion, axis)));
    let mut joints: Vec<_> = joints.enumerate().map(joint).collect();
    if let Some(last) = joints.last_mut() {
        last.body = body.clone();
    }
    joints
}

/// The joint of that number, about or along a coordinate axis of the base.
fn joint((number, (axis_motion, axis)): (usize, (AxisMotion, usize))) -> Joint {
    // From the frame of the joint before, whose z axis is another one, by way of the axes of the base.
    let back = if number == 0 { 2 } else { (axis + 2) % 3 };
    let before = vec![turned(back, -1), turned(axis, 1)];
    Joint {
        name: "base".to_owned(),
        axis_motion,
        aligned: Aligned {
            before: before.clone(),
            turn: vec![Value::zero()],
            d: Value::zero(),
            own: Vec::new(),
        },
        before,
        turn: vec![Value::zero()],
        d: Value::zero(),
        origin: Origin::AfterOffset,
        law: Law::Base { number },
        link_frame: Vec::new(),
        body: Body {
            mass: Value::zero(),
            com: [0; 3].map(Value::integer),
            inertia: [0; 6].map(Value::integer),
        },
        forces: Forces::none(),
        limits: None,
    }
}

/// The turn by which the z axis becomes a coordinate axis, or back: by a quarter about y, about -x, or none.
fn turned(axis: usize, sign: i64) -> Placement {
    let quarters = [[0, sign, 0], [-sign, 0, 0], [0, 0, 0]][axis];
    let quarter = |n: i64| Value::Pi * Value::Rational(Rational::from(n) / Rational::from(2));
    Placement {
        xyz: [0; 3].map(Value::integer),
        rpy: quarters.map(quarter),
    }
}

/// D of an angular velocity of the base.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BaseRate<R>(pub(crate) [R; 3]);

impl<R: Ring> BaseRate<R> {
    /// D u
    pub(crate) fn times(&self, u: [R; Base::FREEDOMS]) -> [R; Base::FREEDOMS] {
        let [x, y, z] = self.0;
        let [vx, vy, vz, wx, wy, _] = u;
        [
            y * vz - z * vy,
            z * vx - x * vz,
            x * vy - y * vx,
            -(z * wy),
            z * wx,
            -(y * wx),
        ]
    }

    /// D' p, of which the last entry is zero.
    pub(crate) fn transposed_times(&self, p: [R; Base::FREEDOMS]) -> [R; 5] {
        let [x, y, z] = self.0;
        let [fx, fy, fz, nx, ny, nz] = p;
        [
            z * fy - y * fz,
            x * fz - z * fx,
            y * fx - x * fy,
            z * ny - y * nz,
            -(z * nx),
        ]
    }
}
