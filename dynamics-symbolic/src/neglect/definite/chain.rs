//! Kinetic energy, joint by joint.

use super::matrix::{Matrix, identity, product, transpose};
use crate::derive::base::{LinkGeometry, base_parameters, columns, geometry, unit};
use crate::exact::Rational;
use crate::linear::{Matrix3, Ring, Vector3};
use crate::robot::{Grouping, Interpretation, JointType, Parameter, Robot};
use crate::spatial::{Body, Motion, enter_x, enter_z};

/// A joint that moves, and the link behind it. Motions are (w, v), of a frame's origin.
pub(super) struct MovingJoint<R> {
    pub(super) joint_type: JointType,
    /// From a motion of the link before to that motion in the joint's axes, before the joint moves.
    pub(super) enter: Matrix<R>,
    /// What the joint's ends make of a motion; of a revolute joint, whose forms no turn changes, one
    /// that does nothing.
    pub(super) ends: Vec<Matrix<R>>,
    /// T of the link is half the value of this form.
    pub(super) inertia: Matrix<R>,
    /// The reflected inertia.
    pub(super) reflected: R,
}

/// The joints that move, of an arm without the base parameters that are left out.
pub(super) fn joints<I: Interpretation>(
    cells: &mut I,
    robot: &Robot,
    grouping: &Grouping,
    is_left: &[bool],
) -> Vec<MovingJoint<I::Number>> {
    let zero = cells.rational(&Rational::ZERO);
    let one = cells.rational(&Rational::ONE);
    let links = geometry(cells, robot);
    let values = base_parameters(cells, robot, grouping);
    let mut parts = vec![(Body::splat(zero), zero); links.len()];
    let left = columns(grouping).into_iter().zip(values).zip(is_left);
    for (((i, parameter), value), _) in left.filter(|(_, is_left)| **is_left) {
        add(
            &mut parts[i],
            grouping,
            &links,
            (i, parameter),
            value,
            (zero, one),
        );
    }
    let mut joints = Vec::new();
    let mut fixed = identity(6, zero, one);
    for (i, row) in robot.rows.iter().enumerate() {
        let changes = Changes {
            zero,
            link: &links[i],
        };
        fixed = product(&changes.before(one), &fixed);
        if row.locked.is_some() {
            // Its parameters are those of the link before.
            fixed = product(&changes.turned(one), &fixed);
            continue;
        }
        let ends = match row.joint_type {
            JointType::Revolute => vec![identity(6, zero, one)],
            JointType::Prismatic => {
                let ends = match &row.limits {
                    Some(limits) => limits.each_ref().map(|limit| cells.value(limit)),
                    None => [-one, one],
                };
                let slid = |q| product(&changes.turned(one), &changes.slid(q, one));
                ends.map(slid).to_vec()
            }
        };
        joints.push(MovingJoint {
            joint_type: row.joint_type,
            enter: fixed,
            ends,
            inertia: form(&parts[i].0, zero),
            reflected: parts[i].1,
        });
        fixed = identity(6, zero, one);
    }
    joints
}

fn add<R: Ring>(
    (body, reflected): &mut (Body<R>, R),
    grouping: &Grouping,
    links: &[LinkGeometry<R>],
    (i, parameter): (usize, Parameter),
    value: R,
    constants: (R, R),
) {
    match unit(grouping, links, i, parameter, constants) {
        Some(unit) => *body = body.joined(unit.times(value)),
        None => *reflected = *reflected + value,
    }
}

/// w.J w + 2 v.(w x h) + m v.v
fn form<R: Ring>(body: &Body<R>, zero: R) -> Matrix<R> {
    let (j, m) = (body.inertia.full().0, body.mass);
    // w.(h x v)
    let h = Matrix3::cross(body.moment, zero).0;
    let entry = |i: usize, k: usize| match (i / 3, k / 3) {
        (0, 0) => j[i][k],
        (0, _) => h[i][k - 3],
        (_, 0) => h[k][i - 3],
        _ if i == k => m,
        _ => zero,
    };
    (0..6)
        .map(|i| (0..6).map(|k| entry(i, k)).collect())
        .collect()
}

/// Changes of motions between the frames of two links.
struct Changes<'a, R> {
    zero: R,
    link: &'a LinkGeometry<R>,
}

impl<R: Ring> Changes<'_, R> {
    /// To the joint's axes and origin.
    fn before(&self, one: R) -> Matrix<R> {
        let (r, twist) = (self.link.offset(self.zero), self.link.twist);
        self.motions(one, |motion| motion.at(r).turned(|v| enter_x(twist, v)))
    }

    /// Along the joint's axis by q.
    fn slid(&self, q: R, one: R) -> Matrix<R> {
        let r = Vector3::new(self.zero, self.zero, q);
        self.motions(one, |motion| motion.at(r))
    }

    /// The constant turn of the row.
    fn turned(&self, one: R) -> Matrix<R> {
        let turn = self.link.turn;
        self.motions(one, |motion| motion.turned(|v| enter_z(turn, v)))
    }

    /// The matrix of a linear map of motions.
    fn motions(&self, one: R, map: impl Fn(Motion<R>) -> Motion<R>) -> Matrix<R> {
        let column = |k: usize| {
            let mut unit = [[self.zero; 3]; 2];
            unit[k / 3][k % 3] = one;
            let [w, v] = unit.map(Vector3);
            let Motion { w, v } = map(Motion { w, v });
            [w.0, v.0].concat()
        };
        let columns: Vec<_> = (0..6).map(column).collect();
        transpose(&columns)
    }
}
