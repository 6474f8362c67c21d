//! The standard inertial parameters of the links, in which T and U are linear.
//!
//! In the frame on joint i's axis, with w and v its angular velocity and the velocity of its
//! origin p in the frame's own axes, link i has
//!
//!   T = 1/2 w.J w + h.(v x w) + 1/2 m v.v + 1/2 I qd_i^2,   U = -m g.p - g.R h.
//!
//! The columns of a list over all parameters are, link by link, the six entries of J, the three of h, m, and I if
//! the link has a motor that moves. The moments h of some prismatic joints' links are written in other axes. A base that
//! moves is the first link, with its parameters in frame 0.

use super::super::assignment::Number;
use super::super::dual::Dual;
use super::configuration::Configuration;
use super::pose::{Lift, Pose};
use super::{Definition, Vector};
use crate::linear::{Matrix3, Ring, Vector3};
use crate::robot::Parameter;

/// The velocities of a link: of its frame, in the frame's own axes, and of its joint.
#[derive(Clone, Copy)]
pub(super) struct Twist<R> {
    pub(super) w: Vector3<R>,
    pub(super) v: Vector3<R>,
    pub(super) speed: R,
}

/// The polar form of 2 T, for a unit of each of the parameters.
pub(super) fn polar<R: Ring>(a: &Twist<R>, b: &Twist<R>) -> [R; 11] {
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
    /// The rows of the links, `None` for a base that moves.
    fn links(&self) -> impl Iterator<Item = Option<usize>> {
        let base = self.floating.iter().map(|_| None);
        base.chain((0..self.rows.len()).map(Some))
    }

    /// The frames in which the parameters of the links are.
    fn parameter_frames<R: Lift>(&self, q: &Configuration<R>) -> Vec<Pose<R>> {
        let frames = self.frames(q);
        let frame = |row: Option<usize>| row.map_or(q.base, |row| frames[row].parameters);
        self.links().map(frame).collect()
    }

    /// The velocities of all links, if the degrees of freedom have these speeds.
    pub(super) fn twists<R: Lift>(&self, q: &Configuration<R>, speeds: &[R]) -> Vec<Twist<R>> {
        let frames = self.parameter_frames(&self.moving(q, speeds));
        let zero = R::lift(Number::ZERO);
        let twist = |(row, frame): (Option<usize>, Pose<Dual<R>>)| Twist {
            w: frame.angular_velocity(),
            v: frame.axes().transpose().apply(frame.velocity()),
            speed: row.map_or(zero, |row| self.rows[row].joint.speed(speeds)),
        };
        self.links().zip(frames).map(twist).collect()
    }

    /// x' M y of a unit of each parameter: M is its mass matrix, x and y are the speeds of these twists.
    pub(super) fn inertia_forms<R: Lift>(&self, x: &[Twist<R>], y: &[Twist<R>]) -> Vec<R> {
        self.columns(|i| polar(&x[i], &y[i]))
    }

    /// U of a unit of each parameter.
    pub(super) fn unit_potentials<R: Lift>(&self, q: &Configuration<R>) -> Vec<R> {
        let frames = self.parameter_frames(q);
        let gravity = Vector3(self.gravity.0.map(R::lift));
        self.columns(|link| {
            let Pose { rotation, origin } = &frames[link];
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
        let links: Vec<_> = self.links().collect();
        self.columns(|link| {
            let row = links[link].map(|row| &self.rows[row]);
            let here = row.map_or(Pose::identity(), |row| row.place.link_in_parameters());
            let own = row.map(|row| &row.body).or(self.floating.as_ref());
            let own = own.map(|body| body.parameters(&here));
            let fixed = self.parameters_fixed_to(links[link], &here);
            let none = [Number::ZERO; 11];
            let mut parameters = own.into_iter().chain(fixed).fold(none, |sum, fixed| {
                core::array::from_fn(|k| sum[k] + fixed[k])
            });
            parameters[10] = row.map_or(Number::ZERO, |row| row.reflected);
            parameters
        })
    }

    /// The first column of the link of a row.
    pub(super) fn first_column(&self, row: usize) -> usize {
        let before = self.links().take_while(|link| *link != Some(row));
        before.map(|link| self.parameters_of(link)).sum()
    }

    /// The number of parameters of a link.
    fn parameters_of(&self, link: Option<usize>) -> usize {
        Parameter::of_link(link.is_some_and(|row| self.rows[row].has_motor)).len()
    }

    /// A list over all parameters, from the values of each link and its motor; the links are counted with a base that moves.
    pub(super) fn columns<R: Lift>(&self, values: impl Fn(usize) -> [R; 11]) -> Vec<R> {
        let mut columns = Vec::with_capacity(self.first_column(self.rows.len()));
        for (number, link) in self.links().enumerate() {
            let mut own = values(number);
            if let Some(rotation) = link.and_then(|row| self.moment_axes[row].as_ref()) {
                let rotation = Matrix3(rotation.0.map(|row| row.map(R::lift)));
                let moment = Vector3::new(own[6], own[7], own[8]);
                own[6..9].copy_from_slice(&rotation.apply(moment).0);
            }
            columns.extend(&own[..self.parameters_of(link)]);
        }
        columns
    }

    /// For a prismatic joint whose last revolute joint before it has its axis along none of the
    /// link's own: the rotation to that joint's frame.
    pub(super) fn moment_axes(&self) -> Vec<Option<Matrix3<Number>>> {
        let frames = self.frames(&self.q);
        let rotation = |i: usize| {
            let is_prismatic = !self.rows[i].joint.is_revolute;
            let carrier = self.turning_carrier(i).filter(|_| is_prismatic)?;
            let [own, before] = [i, carrier].map(|k| frames[k].parameters.rotation);
            let rotation = before.transpose().product(&own);
            let along = rotation.0[2].iter().filter(|x| !x.is_zero()).count();
            (along > 1).then_some(rotation)
        };
        (0..self.rows.len()).map(rotation).collect()
    }
}
