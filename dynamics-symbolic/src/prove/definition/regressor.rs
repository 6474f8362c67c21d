//! The regressor of the standard inertial parameters, and the base parameters among them.
//!
//! In the frame on joint i's axis, with w and v its angular velocity and the velocity of its
//! origin p in the frame's own axes, link i has
//!
//!   T = 1/2 w.J w + h.(v x w) + 1/2 m v.v + 1/2 I qd_i^2,   U = -m g.p - g.R h.
//!
//! The column of a parameter is d/dt (dT/dqd_j) - dT/dq_j + dU/dq_j where it is 1 and the others are
//! 0. A parameter is a base parameter where its column, at enough random states, is no combination
//! of the columns before it. That gives the columns of Y, and, with tau - F at the same states,
//! the only values that the base parameters can have.
//!
//! Of an arm whose joints follow others it is one of the base parameters of the arm in which nothing is
//! coupled whose column is no combination of those before it: of the links that move by themselves, then
//! of the followers' links.

use super::super::assignment::Number;
use super::super::dual::Dual;
use super::body::Body;
use super::pose::{Lift, Pose, Position};
use super::row::Row;
use super::state::State;
use super::twist::{Twist, polar, twist};
use super::{Definition, Matrix, Parameters, Vector};
use crate::exact::SplitMix64;
use crate::linear::{Matrix3, Symmetric3, Vector3};
use crate::robot::{Convention, JointType, Parameter};

impl Definition {
    /// Y by rows, or `None` where the table's forces are not those of its parameters.
    pub(super) fn regressor(&self) -> Option<Vector> {
        let kept = self.base()?.0;
        let here = self.standard_regressor(&self.state());
        let row = |row: &Vector| -> Vector { kept.iter().map(|&k| row[k]).collect() };
        Some(here.iter().flat_map(row).collect())
    }

    /// The base parameters.
    pub(super) fn base_parameters(&self) -> Option<Vector> {
        self.base().map(|(_, values)| values)
    }

    /// The values of some base parameters, each in its place among the parameters of its link, the
    /// moments in the link's own axes; `None` where one of them is no base parameter of the arm in which
    /// nothing is coupled.
    pub(super) fn values_of(&self, columns: &[(usize, Parameter)]) -> Option<Vec<Parameters>> {
        let (kept, values) = self.uncoupled.as_deref().unwrap_or(self).base()?;
        let rotations = self.moment_axes();
        let start = |i: usize| self.first_column(i);
        let mut links = vec![[Number::ZERO; 11]; self.rows.len()];
        for &(i, parameter) in columns {
            let column = start(i) + parameter.index();
            let place = kept.iter().position(|&k| k == column)?;
            links[i][parameter.index()] = values[place];
        }
        for (link, rotation) in links.iter_mut().zip(rotations) {
            if let Some(rotation) = rotation {
                let moment = Vector3::new(link[6], link[7], link[8]);
                let moment = rotation.transpose().apply(moment);
                link[6..9].copy_from_slice(&moment.0);
            }
        }
        Some(links)
    }

    /// The base parameters: columns of the standard regressor, and values.
    fn base(&self) -> Option<(Vec<usize>, Vector)> {
        let parameters = self.standard_parameters();
        let forces = |regressor: &Matrix| -> Vector {
            regressor.iter().map(|row| dot(row, &parameters)).collect()
        };
        if forces(&self.standard_regressor(&self.state())) != self.forces_of_links() {
            return None;
        }
        let candidates = self.candidates()?;
        let mut random = SplitMix64::new(self.states);
        let multiples = self.multiples();
        let mut equations = Equations::default();
        loop {
            let regressor = self.standard_regressor(&self.random_state(&multiples, &mut random));
            let forces = forces(&regressor);
            let before = equations.0.len();
            for (row, force) in regressor.into_iter().zip(forces) {
                let row = candidates.iter().map(|&k| row[k]).collect();
                // Where all base parameters are accounted for nothing must be left of the force.
                equations.add(row, force)?;
            }
            // A state that adds nothing might have been any: no state does.
            if equations.0.len() == before {
                break;
            }
        }
        let solved = equations.0.into_iter();
        let mut base: Vec<_> = solved
            .map(|equation| (candidates[equation.column], equation.value))
            .collect();
        base.sort_unstable_by_key(|(column, _)| *column);
        Some(base.into_iter().unzip())
    }

    /// The columns among which base parameters are, in the order in which they are chosen.
    fn candidates(&self) -> Option<Vec<usize>> {
        let Some(uncoupled) = &self.uncoupled else {
            return Some((0..self.first_column(self.rows.len())).collect());
        };
        let mut columns = uncoupled.base()?.0;
        let follows = |column: usize| {
            let row = (0..self.rows.len()).rfind(|&i| self.first_column(i) <= column);
            row.is_some_and(|i| !self.rows[i].is_free)
        };
        columns.sort_by_key(|&column| follows(column));
        Some(columns)
    }

    /// The first column of the standard regressor that belongs to a link.
    fn first_column(&self, link: usize) -> usize {
        let columns = |row: &Row| 10 + usize::from(row.has_motor && row.locked.is_none());
        self.rows[..link].iter().map(columns).sum()
    }

    /// Which of the standard parameters are base parameters.
    pub(super) fn kept_parameters(&self) -> Option<Vec<usize>> {
        self.base().map(|(kept, _)| kept)
    }

    /// What belongs to the ten parameters of a link, where the moments are written in the axes of
    /// [`Definition::moment_axes`], and what belongs to its motor where it has one.
    pub(super) fn in_moment_axes(&self, link: usize, mut values: Vector, motor: Number) -> Vector {
        if let Some(rotation) = &self.moment_axes()[link] {
            let moment = Vector3::new(values[6], values[7], values[8]);
            values[6..9].copy_from_slice(&rotation.apply(moment).0);
        }
        let row = &self.rows[link];
        values.extend((row.has_motor && row.locked.is_none()).then_some(motor));
        values
    }

    /// M qdd + V + G by the definition of inverse dynamics.
    fn forces_of_links(&self) -> Vector {
        let forces = self.inverse_dynamics(&self.qdd);
        let others = self.joint_forces();
        forces.iter().zip(&others).map(|(&f, &r)| f - r).collect()
    }

    fn state(&self) -> State<Number> {
        State {
            q: self.q.clone(),
            qd: self.qd.clone(),
            qdd: self.qdd.clone(),
        }
    }

    fn random_state(&self, multiples: &[Vec<i64>], random: &mut SplitMix64) -> State<Number> {
        let q = self.random_positions(multiples, random);
        let mut numbers = || (0..self.dof()).map(|_| Number::random(random)).collect();
        State {
            q,
            qd: numbers(),
            qdd: numbers(),
        }
    }

    /// Every link's parameters in the frame on its joint's axis, the moments in the link's own axes
    /// or in those of [`Definition::moment_axes`]. The tool is a part of the last link.
    fn standard_parameters(&self) -> Vector {
        let rotations = self.moment_axes();
        let mut values = Vec::new();
        for (i, row) in self.rows.iter().enumerate() {
            let link = match self.convention {
                Convention::Modified => row
                    .mount
                    .as_ref()
                    .map_or(Pose::identity(), |mount| mount.frame()),
                Convention::Standard => Pose::screw_x(row.twist, row.a),
            };
            let mut parameters = parameters(&row.body, &link);
            if let Some(tool) = self.tool.as_ref().filter(|_| i + 1 == self.rows.len()) {
                let tip = link.then(&tool.placement.pose());
                let of_tool = self::parameters(&tool.body, &tip);
                parameters = core::array::from_fn(|k| parameters[k] + of_tool[k]);
            }
            if let Some(rotation) = &rotations[i] {
                let moment = Vector3::new(parameters[6], parameters[7], parameters[8]);
                parameters[6..9].copy_from_slice(&rotation.apply(moment).0);
            }
            values.extend(parameters);
            if row.has_motor && row.locked.is_none() {
                values.push(row.reflected);
            }
        }
        values
    }

    /// For a prismatic joint whose last revolute joint before it has its axis along none of the
    /// link's own: the rotation to that joint's frame.
    fn moment_axes(&self) -> Vec<Option<Matrix3<Number>>> {
        let frames = self.joint_frames(&self.q);
        let rotation = |i: usize| {
            let is_revolute = |&j: &usize| self.rows[j].joint_type == JointType::Revolute;
            let turns = |j: &usize| is_revolute(j) && self.rows[*j].locked.is_none();
            let before = (0..i).rev().find(turns)?;
            let rotation = frames[before].rotation.transpose();
            let rotation = rotation.product(&frames[i].rotation);
            let along = rotation.0[2].iter().filter(|x| !x.is_zero()).count();
            (!is_revolute(&i) && along > 1).then_some(rotation)
        };
        (0..self.rows.len()).map(rotation).collect()
    }

    /// Row j: the force of joint j by a unit of each standard parameter.
    fn standard_regressor(&self, state: &State<Number>) -> Matrix {
        let momenta = self.momentum_rates(state);
        let rotations = self.moment_axes();
        let row = |j: usize| {
            let slopes = self.slopes(state, j);
            let mut row = Vec::new();
            for i in 0..self.rows.len() {
                let mut column: Vector = (0..10).map(|k| momenta[j][i][k] - slopes[i][k]).collect();
                if let Some(rotation) = &rotations[i] {
                    let moment = Vector3::new(column[6], column[7], column[8]);
                    column[6..9].copy_from_slice(&rotation.apply(moment).0);
                }
                row.extend(column);
                if self.rows[i].has_motor && self.rows[i].locked.is_none() {
                    row.push(self.share_of_motor(i, j) * state.qdd[j]);
                }
            }
            row
        };
        (0..self.dof()).map(row).collect()
    }

    /// d/dt (dT/dqd_j), for each joint j, link i and parameter.
    fn momentum_rates(&self, state: &State<Number>) -> Vec<Vec<[Number; 10]>> {
        let n = self.dof();
        let zero = Number::ZERO;
        // Inner derivatives are rates in time, outer ones those of a unit velocity of one joint.
        let moving = |k: usize| {
            let along_motion = self.moving(&state.q, &state.qd);
            self.twists(&self.moving(&along_motion, &self.unit(k)))
        };
        let units: Vec<Vec<Twist<Dual<Number>>>> = (0..n).map(moving).collect();
        let rates: Vec<_> = state.qd.iter().zip(&state.qdd).collect();
        let whole = |i: usize| {
            let rest = Vector3::splat(Dual::new(zero, zero));
            let mut sum = Twist { w: rest, v: rest };
            for (unit, &(&qd, &qdd)) in units.iter().zip(&rates) {
                let rate = Dual::new(qd, qdd);
                sum.w = sum.w + unit[i].w * rate;
                sum.v = sum.v + unit[i].v * rate;
            }
            sum
        };
        let wholes: Vec<_> = (0..self.rows.len()).map(whole).collect();
        let rate = |j: usize, i: usize| polar(units[j][i], wholes[i]).map(|x| x.derivative);
        let of_joint = |j| (0..self.rows.len()).map(|i| rate(j, i)).collect();
        (0..n).map(of_joint).collect()
    }

    /// dT/dq_j - dU/dq_j, for each link and parameter.
    fn slopes(&self, state: &State<Number>, j: usize) -> Vec<[Number; 10]> {
        let speeds: Vec<_> = state.qd.iter().map(|&qd| Dual::lift(qd)).collect();
        let displaced = self.moving(&state.q, &self.unit(j));
        let frames = self.joint_frames(&self.moving(&displaced, &speeds));
        let slope = |frame: &Pose<Dual<Dual<Number>>>| {
            let twist = twist(frame);
            let mut slope = polar(twist, twist).map(|x| self.half * x.derivative);
            // -U = m g.p + g.R h
            let along = |v: [Dual<Dual<Number>>; 3]| {
                let rates = Vector3(v.map(|x| x.value.derivative));
                self.gravity.dot(rates)
            };
            for k in 0..3 {
                slope[6 + k] = slope[6 + k] + along(frame.rotation.column(k).0);
            }
            slope[9] = slope[9] + along(frame.origin.0);
            slope
        };
        frames.iter().map(slope).collect()
    }

    fn twists(&self, q: &[Position<Dual<Dual<Number>>>]) -> Vec<Twist<Dual<Number>>> {
        self.joint_frames(q).iter().map(twist).collect()
    }
}

/// The ten parameters about the origin of the frame in which the body's own frame is at `pose`:
/// J = I + m (c.c 1 - c c^T), h = m c.
fn parameters(body: &Body, pose: &Pose<Number>) -> [Number; 10] {
    let (m, center) = (body.mass, body.center(pose));
    let [x, y, z] = center.0;
    let tensor = body.inertia.rotated(&pose.rotation)
        + Symmetric3 {
            xx: y * y + z * z,
            yy: x * x + z * z,
            zz: x * x + y * y,
            xy: -(x * y),
            yz: -(y * z),
            xz: -(x * z),
        } * m;
    let [hx, hy, hz] = (center * m).0;
    let (jxx, jyy, jzz) = (tensor.xx, tensor.yy, tensor.zz);
    [
        jxx, tensor.xy, tensor.xz, jyy, tensor.yz, jzz, hx, hy, hz, m,
    ]
}

fn dot(a: &[Number], b: &[Number]) -> Number {
    let terms = a.iter().zip(b);
    terms.fold(Number::ZERO, |sum, (&a, &b)| sum + a * b)
}

/// Equations in reduced echelon form: the columns of their pivots are no combinations of those before them.
#[derive(Default)]
struct Equations(Vec<Equation>);

struct Equation {
    /// The first entry that is not zero: it is 1, and that of all others is 0 there.
    column: usize,
    row: Vector,
    value: Number,
}

impl Equations {
    /// Adds row . x = value; `None` where that contradicts the others.
    fn add(&mut self, mut row: Vector, mut value: Number) -> Option<()> {
        for known in &self.0 {
            let factor = row[known.column];
            subtract(&mut row, factor, &known.row);
            value = value - factor * known.value;
        }
        let Some(column) = row.iter().position(|x| !x.is_zero()) else {
            return value.is_zero().then_some(());
        };
        let inverse = row[column].inverse()?;
        let row: Vector = row.iter().map(|&x| x * inverse).collect();
        let value = value * inverse;
        for known in &mut self.0 {
            let factor = known.row[column];
            subtract(&mut known.row, factor, &row);
            known.value = known.value - factor * value;
        }
        self.0.push(Equation { column, row, value });
        Some(())
    }
}

/// row - factor other
fn subtract(row: &mut [Number], factor: Number, other: &[Number]) {
    if !factor.is_zero() {
        let terms = row.iter_mut().zip(other);
        terms.for_each(|(x, &y)| *x = *x - factor * y);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dependent_columns_are_left_out() {
        let row = |entries: [u64; 4]| entries.map(Number::new).to_vec();
        // The second column is twice the first, the fourth the sum of the first and the third: 5 times the
        // first and 2 times the third make the values.
        let mut equations = Equations::default();
        for (entries, value) in [([0, 0, 3, 3], 6), ([1, 2, 0, 1], 5), ([2, 4, 1, 3], 12)] {
            assert_eq!(equations.add(row(entries), Number::new(value)), Some(()));
        }
        let solved = equations.0.iter().map(|e| (e.column, e.value.get()));
        assert_eq!(solved.collect::<Vec<_>>(), [(2, 2), (0, 5)]);
        assert_eq!(equations.add(row([1, 2, 0, 1]), Number::new(4)), None);
    }
}
