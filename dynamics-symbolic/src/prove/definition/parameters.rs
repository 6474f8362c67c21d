//! The standard inertial parameters of the links, in which T and U are linear.
//!
//! In the frame on joint i's axis, with w and v its angular velocity and the velocity of its
//! origin p in the frame's own axes, link i has
//!
//!   T = 1/2 w.J w + h.(v x w) + 1/2 m v.v + 1/2 I qd_i^2,   U = -m g.p - g.R h.
//!
//! The columns of a list over all parameters are, link by link, the six entries of J, the three of h, m, and I if
//! the link has a motor that moves. The moments h of some prismatic joints' links are written in other axes.

use super::super::assignment::Number;
use super::super::dual::Dual;
use super::place::Frames;
use super::pose::{Lift, Pose, Position};
use super::row::Row;
use super::{Definition, Vector};
use crate::linear::{Matrix3, Ring, Vector3};
use crate::robot::Parameter;

/// The velocities of a link: of its frame, in the frame's own axes, and of its joint.
#[derive(Clone, Copy)]
pub(super) struct Twist<R> {
    w: Vector3<R>,
    v: Vector3<R>,
    speed: R,
}

/// The polar form of 2 T, for a unit of each of the parameters.
fn polar<R: Ring>(a: &Twist<R>, b: &Twist<R>) -> [R; 11] {
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
        a.speed * b.speed,
    ]
}

impl Definition {
    /// The velocities of all links, if the free joints have these speeds.
    pub(super) fn twists<R: Lift>(&self, q: &[Position<R>], speeds: &[R]) -> Vec<Twist<R>> {
        let frames = self.frames(&self.moving(q, speeds));
        let twist = |(row, frames): (&Row, &Frames<Dual<R>>)| {
            let frame = &frames.parameters;
            Twist {
                w: frame.angular_velocity(),
                v: frame.axes().transpose().apply(frame.velocity()),
                speed: row.joint.speed(speeds),
            }
        };
        self.rows.iter().zip(&frames).map(twist).collect()
    }

    /// x' M y of a unit of each parameter: M is its mass matrix, x and y are the speeds of these twists.
    pub(super) fn inertia_forms<R: Lift>(&self, x: &[Twist<R>], y: &[Twist<R>]) -> Vec<R> {
        self.columns(|i| polar(&x[i], &y[i]))
    }

    /// U of a unit of each parameter.
    pub(super) fn unit_potentials<R: Lift>(&self, q: &[Position<R>]) -> Vec<R> {
        let frames = self.frames(q);
        let gravity = Vector3(self.gravity.0.map(R::lift));
        self.columns(|i| {
            let Pose { rotation, origin } = &frames[i].parameters;
            let mut weights = [R::lift(Number::ZERO); 11];
            for k in 0..3 {
                weights[6 + k] = -gravity.dot(rotation.column(k));
            }
            weights[9] = -gravity.dot(*origin);
            weights
        })
    }

    /// Every link's parameters. The tool and the bodies of frames are parts of the links that carry them.
    pub(super) fn standard_parameters(&self) -> Vector {
        self.columns(|i| {
            let row = &self.rows[i];
            let link = row.place.link_in_parameters();
            let own = row.body.parameters(&link);
            let fixed = self.parameters_fixed_to(i, &link);
            let mut parameters = fixed.fold(own, |sum, fixed| {
                core::array::from_fn(|k| sum[k] + fixed[k])
            });
            parameters[10] = row.reflected;
            parameters
        })
    }

    /// The first column of a link.
    pub(super) fn first_column(&self, link: usize) -> usize {
        let links = self.rows[..link].iter();
        let count = |row: &Row| Parameter::of_link(row.has_motor).len();
        links.map(count).sum()
    }

    /// A list over all parameters, from the values of each link and its motor.
    pub(super) fn columns<R: Lift>(&self, values: impl Fn(usize) -> [R; 11]) -> Vec<R> {
        let mut columns = Vec::with_capacity(self.first_column(self.rows.len()));
        for (i, row) in self.rows.iter().enumerate() {
            let mut own = values(i);
            if let Some(rotation) = &self.moment_axes[i] {
                let rotation = Matrix3(rotation.0.map(|row| row.map(R::lift)));
                let moment = Vector3::new(own[6], own[7], own[8]);
                own[6..9].copy_from_slice(&rotation.apply(moment).0);
            }
            columns.extend(&own[..Parameter::of_link(row.has_motor).len()]);
        }
        columns
    }

    /// For a prismatic joint whose last revolute joint before it has its axis along none of the
    /// link's own: the rotation to that joint's frame.
    pub(super) fn moment_axes(&self) -> Vec<Option<Matrix3<Number>>> {
        let frames = self.frames(&self.q);
        let rotation = |i: usize| {
            let is_prismatic = !self.rows[i].joint.is_revolute();
            let carrier = self.turning_carrier(i).filter(|_| is_prismatic)?;
            let [own, before] = [i, carrier].map(|k| frames[k].parameters.rotation);
            let rotation = before.transpose().product(&own);
            let along = rotation.0[2].iter().filter(|x| !x.is_zero()).count();
            (along > 1).then_some(rotation)
        };
        (0..self.rows.len()).map(rotation).collect()
    }
}
