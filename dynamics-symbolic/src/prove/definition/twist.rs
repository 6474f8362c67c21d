//! Velocities of frames, and what the kinetic energy makes of them.

use super::super::dual::Dual;
use super::pose::Pose;
use crate::linear::{Matrix3, Ring, Vector3};

/// Velocities of a frame in its own axes.
#[derive(Clone, Copy)]
pub(super) struct Twist<R> {
    pub(super) w: Vector3<R>,
    pub(super) v: Vector3<R>,
}

/// The velocities of a frame whose pose has a derivative.
pub(super) fn twist<R: Ring>(frame: &Pose<Dual<R>>) -> Twist<R> {
    let axes = Matrix3(frame.rotation.0.map(|row| row.map(|x| x.value)));
    let velocity = Vector3(frame.origin.0.map(|x| x.derivative));
    Twist {
        w: angular_velocity(&frame.rotation),
        v: axes.transpose().apply(velocity),
    }
}

/// The polar form of 2 T, for a unit of each of the ten parameters: dT/dqd_j is that of the whole
/// twist and the one by a unit velocity of joint j.
pub(super) fn polar<R: Ring>(a: Twist<R>, b: Twist<R>) -> [R; 10] {
    let (u, w) = (a.w, b.w);
    let [hx, hy, hz] = (a.v.cross(w) + b.v.cross(u)).0;
    [
        u[0] * w[0],
        u[0] * w[1] + u[1] * w[0],
        u[0] * w[2] + u[2] * w[0],
        u[1] * w[1],
        u[1] * w[2] + u[2] * w[1],
        u[2] * w[2],
        hx,
        hy,
        hz,
        a.v.dot(b.v),
    ]
}

/// w of [w]x = R^T R', in the axes of the turned frame.
pub(super) fn angular_velocity<R: Ring>(rotation: &Matrix3<Dual<R>>) -> Vector3<R> {
    let value = Matrix3(rotation.0.map(|row| row.map(|x| x.value)));
    let rate = Matrix3(rotation.0.map(|row| row.map(|x| x.derivative)));
    let entry = |i: usize, j: usize| value.column(i).dot(rate.column(j));
    Vector3::new(entry(2, 1), entry(0, 2), entry(1, 0))
}
