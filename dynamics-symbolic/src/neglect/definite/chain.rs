//! Kinetic energy, joint by joint.

use super::matrix::{Matrix, identity, product, transpose};
use crate::derive::base::{Geometry, base_parameters, columns, geometry, unit};
use crate::linear::{Matrix3, Ring, Vector3};
use crate::mechanism::{Mechanism, Tree};
use crate::robot::{Grouping, Interpretation};
use crate::spatial::{Axis, AxisMotion, Body, Motion, enter_about};

/// A joint that moves, and the link behind it. Motions are (w, v), of a frame's origin.
pub(super) struct MovingJoint<R> {
    pub(super) axis_motion: AxisMotion,
    /// From a motion of the link before to that motion in the joint's axes, before the joint moves.
    pub(super) enter: Matrix<R>,
    /// The changes of a motion at both ends of the joint's range. A revolute joint, whose forms no turn changes, has one
    /// that changes nothing.
    pub(super) ends: Vec<Matrix<R>>,
    /// T of the link is half the value of this form.
    pub(super) inertia: Matrix<R>,
    /// The reflected inertia.
    pub(super) reflected: R,
}

/// The joints that move.
pub(super) struct MovingJoints<R> {
    /// From the base outwards.
    pub(super) joints: Vec<MovingJoint<R>>,
    /// The joint on whose link each of them stands, or on a link that is fixed to that one.
    pub(super) tree: Tree,
}

/// The joints that move, for the base parameters for which `is_kept` is true: all others are left out.
pub(super) fn moving_joints<I: Interpretation>(
    cells: &mut I,
    arm: &Mechanism,
    grouping: &Grouping,
    is_kept: &[bool],
) -> MovingJoints<I::Number> {
    let geometry = geometry(cells, arm);
    let (zero, one) = (geometry.zero, geometry.one);
    let values = base_parameters(cells, arm, grouping);
    let mut parts = vec![(Body::splat(zero), zero); geometry.tree.len()];
    let columns = columns(grouping).into_iter().zip(values).zip(is_kept);
    for (((i, parameter), value), _) in columns.filter(|(_, is_kept)| **is_kept) {
        let (body, reflected) = &mut parts[i];
        match unit(grouping, &geometry, i, parameter) {
            Some(unit) => *body = body.joined(unit.times(value)),
            None => *reflected = *reflected + value,
        }
    }
    let (mut joints, mut parents) = (Vec::new(), Vec::new());
    let base = (None, identity(6, zero, one));
    geometry.tree.outward(base, |i, (carrier, fixed)| {
        let joint = &arm.joints[i];
        let changes = Changes {
            geometry: &geometry,
            i,
        };
        let fixed = product(&changes.before(), fixed);
        if joint.stands() {
            // Its parameters are those of the link before.
            return (*carrier, product(&changes.turned(), &fixed));
        }
        let ends = match joint.axis_motion {
            AxisMotion::Turns => vec![identity(6, zero, one)],
            AxisMotion::Slides => {
                let ends = match &joint.limits {
                    Some(limits) => limits.each_ref().map(|limit| cells.value(limit)),
                    None => [-one, one],
                };
                let slid = |q| product(&changes.turned(), &changes.slid(q));
                ends.map(slid).to_vec()
            }
        };
        joints.push(MovingJoint {
            axis_motion: joint.axis_motion,
            enter: fixed,
            ends,
            inertia: form(&parts[i].0, zero),
            reflected: parts[i].1,
        });
        parents.push(*carrier);
        (Some(joints.len() - 1), identity(6, zero, one))
    });
    MovingJoints {
        joints,
        tree: Tree::new(parents),
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

/// Changes of motions between the frames of link i and the link before.
struct Changes<'a, R> {
    geometry: &'a Geometry<R>,
    i: usize,
}

impl<R: Ring> Changes<'_, R> {
    /// To the joint's axes and origin.
    fn before(&self) -> Matrix<R> {
        let r = self.geometry.offset(self.i);
        let turns = &self.geometry.links[self.i].before.turns;
        self.motions(|motion| motion.at(r).turned(|v| turns.enter(v)))
    }

    /// Along the joint's axis by q.
    fn slid(&self, q: R) -> Matrix<R> {
        let zero = self.geometry.zero;
        let r = Vector3::new(zero, zero, q);
        self.motions(|motion| motion.at(r))
    }

    /// The constant turn about the joint's axis.
    fn turned(&self) -> Matrix<R> {
        let turn = self.geometry.links[self.i].turn;
        self.motions(|motion| motion.turned(|v| enter_about(Axis::Z, turn, v)))
    }

    /// The matrix of a linear map of motions.
    fn motions(&self, map: impl Fn(Motion<R>) -> Motion<R>) -> Matrix<R> {
        let column = |k: usize| {
            let mut unit = [[self.geometry.zero; 3]; 2];
            unit[k / 3][k % 3] = self.geometry.one;
            let [w, v] = unit.map(Vector3);
            let Motion { w, v } = map(Motion { w, v });
            [w.0, v.0].concat()
        };
        let columns: Vec<_> = (0..6).map(column).collect();
        transpose(&columns)
    }
}
