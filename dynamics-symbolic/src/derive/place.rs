//! Placements in any ring: T(xyz) Rz(yaw) Ry(pitch) Rx(roll), the order of URDF.
//!
//! A base is no link: it turns gravity, once and exactly, and shifts U. A wall costs no operation. Kinematics begin
//! in the world, because the first frame of a chain costs no more when it is turned. The tool's centre of mass and
//! tensor pass into the last link's frame before its mass enters, and are a part of that link from there on. G is
//! scaled by a component of the table's gravity before that is turned: seen from a turned base a component may vanish
//! by chance, such as sin 30 deg - 1/2, and nothing is divided by it.

use crate::exact::Rational;
use crate::linear::{Matrix3, Ring, Symmetric3, Vector3};
use crate::mechanism::Mechanism;
use crate::robot::{Body, Interpretation, Placement, Value};
use crate::spatial::{Axis, Central, Place, Turn, Turns};

/// The last of some frames, each placed in the one before it.
pub(crate) fn place<I: Interpretation>(
    cells: &mut I,
    placements: &[Placement],
) -> Place<I::Number> {
    let zero = cells.rational(&Rational::ZERO);
    let mut place = Place {
        origin: Vector3::splat(zero),
        turns: Turns(Vec::new()),
    };
    let mut angles: Vec<&Value> = Vec::new();
    for Placement { xyz, rpy } in placements {
        let mut turn = |angle: &Value| (!angle.is_zero()).then(|| Turn::from(cells.sin_cos(angle)));
        let turns = rpy.each_ref().map(&mut turn);
        place.origin = place.leave_point(vector(cells, xyz));
        let axes = [Axis::X, Axis::Y, Axis::Z].into_iter();
        for ((axis, turn), angle) in axes.zip(turns).zip(rpy).rev() {
            let Some(turn) = turn else { continue };
            // A turn and the same turn back are none.
            let last = place.turns.0.last().zip(angles.last().copied());
            let is_back = |((before, _), back): (&(Axis, _), &Value)| {
                *before == axis && *back == -angle.clone()
            };
            if last.is_some_and(is_back) {
                place.turns.0.pop();
                angles.pop();
            } else {
                place.turns.0.push((axis, turn));
                angles.push(angle);
            }
        }
    }
    place
}

/// Where frame 0 is in the world.
pub(super) struct BaseFrame<R> {
    pub(super) origin: Vector3<R>,
    axes: Axes<R>,
}

/// The axes of frame 0 in the world.
enum Axes<R> {
    /// Axes of a base that stands, turned by known angles.
    Turned(Turns<R>),
    /// Axes of a base that moves, any rotation, by rows.
    Moving(Matrix3<R>),
}

impl<R: Ring> BaseFrame<R> {
    /// A vector of the world in the axes of frame 0.
    pub(super) fn enter(&self, v: Vector3<R>) -> Vector3<R> {
        match &self.axes {
            Axes::Turned(turns) => turns.enter(v),
            Axes::Moving(rotation) => rotation.transpose().apply(v),
        }
    }

    /// A vector of frame 0 in the axes of the world.
    pub(super) fn leave(&self, v: Vector3<R>) -> Vector3<R> {
        match &self.axes {
            Axes::Turned(turns) => turns.leave(v),
            Axes::Moving(rotation) => rotation.apply(v),
        }
    }

    /// A point of frame 0 in the world.
    pub(super) fn leave_point(&self, p: Vector3<R>) -> Vector3<R> {
        self.origin + self.leave(p)
    }
}

/// Frame 0 in the world; `None` where they are the same.
pub(super) fn base<I: Interpretation>(
    cells: &mut I,
    arm: &Mechanism,
) -> Option<BaseFrame<I::Number>> {
    if let Some((rotation, position)) = cells.pose_of_base() {
        return Some(BaseFrame {
            origin: Vector3(position),
            axes: Axes::Moving(Matrix3(rotation)),
        });
    }
    let base = arm.base.as_ref()?;
    let Place { origin, turns } = place(cells, core::slice::from_ref(base));
    let axes = Axes::Turned(turns);
    Some(BaseFrame { origin, axes })
}

/// The acceleration of gravity in the axes of frame 0.
pub(crate) fn gravity<I: Interpretation>(cells: &mut I, arm: &Mechanism) -> Vector3<I::Number> {
    let gravity = vector(cells, &arm.gravity);
    let base = base(cells, arm);
    base.map_or(gravity, |base| base.enter(gravity))
}

/// g.p with p the origin of frame 0 in the world: what a mass there has of potential energy, times -1
/// and over the mass. `None` where the two origins are one.
pub(super) fn datum<I: Interpretation>(cells: &mut I, arm: &Mechanism) -> Option<I::Number> {
    let position = match (cells.pose_of_base(), &arm.base) {
        (Some((_, position)), _) => Vector3(position),
        (None, Some(base)) => vector(cells, &base.xyz),
        (None, None) => return None,
    };
    let gravity = vector(cells, &arm.gravity);
    Some(gravity.dot(position))
}

/// A rigid body, from its cells.
pub(super) fn central<I: Interpretation>(cells: &mut I, body: &Body) -> Central<I::Number> {
    Central {
        mass: cells.value(&body.mass),
        com: vector(cells, &body.com),
        inertia: Symmetric3::from_entries(body.inertia.each_ref().map(|entry| cells.value(entry))),
    }
}

fn vector<I: Interpretation>(cells: &mut I, vector: &[Value; 3]) -> Vector3<I::Number> {
    Vector3(vector.each_ref().map(|value| cells.value(value)))
}
