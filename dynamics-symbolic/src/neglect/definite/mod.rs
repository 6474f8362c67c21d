//! Whether M is positive definite at all positions.
//!
//! Samples cannot show it, and it would take too many boxes of positions. But the kinetic energy can be written as a
//! sum of quadratic forms of few variables, one for each joint. Let a_j be the motion (w, v) of the link before joint j, in
//! the axes of the joint before it moves, P(q_j) the change of axes by the joint's position, S the joint's direction, I_j
//! the form of link j (T = 1/2 xi.I xi), L_j any quadratic form of a_j, and L_(n+1) = 0. Then
//!
//!   2 T = sum_j [ xi_j.I_j xi_j + r_j qd_j^2 + L_(j+1)(a_(j+1)) - L_j(a_j) ],
//!   xi_j = P(q_j) a_j + S qd_j,   a_(j+1) = X_(j+1) xi_j,   a_1 = 0,
//!
//! because each L_j is added in one bracket and subtracted in the next. Each bracket is a form of a_j and qd_j. If there are
//! L_j with which all brackets are positive definite at every q_j, then M is positive definite: T = 0 implies qd_1 = 0,
//! hence a_2 = 0, and so on.
//!
//! The bracket of a revolute joint does not depend on its position if a turn about its axis does not change L_j; such a
//! form has seven coefficients. The bracket of a prismatic joint is concave in q_j if L_j does not
//! take away from the energy of a sideways motion: then both ends of the range decide for all
//! positions between. (The parameters that a base parameter moves to the link before are such an L_j: m, h_z and
//! J_xx + J_yy of a revolute joint. For bodies that can exist, these make all brackets positive if no
//! parameter is left out.)
//!
//! The L_j are found in doubles ([`search`]); [intervals](crate::interval), from the table's exact numbers, then show that
//! they make all brackets positive. Where none are found, nothing is known.

mod chain;
mod energy;
mod matrix;
mod search;

use super::reals::Reals;
use crate::interval::{Interval, Intervals};
use crate::linear::eliminate;
use crate::mechanism::Mechanism;
use crate::robot::Grouping;
use crate::spatial::AxisMotion;
use chain::{MovingJoints, moving_joints};
use energy::{forms, handed_on, unknowns};
use matrix::{Matrix, combined};
use search::{Affine, search};

/// Shows that M of an arm with some of its base parameters is positive definite, revolute joints at any
/// angle and prismatic ones within their ranges. `sizes` are those of the diagonal entries of M.
pub(super) fn is_positive_definite(
    arm: &Mechanism,
    grouping: &Grouping,
    is_kept: &[bool],
    sizes: &[f64],
) -> bool {
    let real = moving_joints(&mut Reals, arm, grouping, is_kept);
    let exact = moving_joints(&mut Intervals, arm, grouping, is_kept);
    let scales = Scales::new(arm, &real, sizes);
    let shown = |y: &[f64]| {
        let x = y
            .iter()
            .zip(&scales.unknowns)
            .map(|(y, scale)| Interval::exact(y * scale));
        let (zero, one) = (Interval::exact(0.0), Interval::exact(1.0));
        let forms = forms(&exact, &x.collect::<Vec<_>>(), zero, one);
        forms.into_iter().all(has_positive_pivots)
    };
    search(&scales.affine(&real), scales.unknowns.len(), shown).is_some()
}

/// Sizes of what is compared, so that no choice of units matters.
struct Scales {
    /// The sizes of the unknown numbers.
    unknowns: Vec<f64>,
    /// The square roots of the sizes of the diagonal entries of each form.
    forms: Vec<Vec<f64>>,
}

impl Scales {
    fn new(arm: &Mechanism, moving: &MovingJoints<f64>, sizes: &[f64]) -> Self {
        let masses = arm.joints.iter().map(|joint| &joint.body.mass);
        let masses = masses.chain(arm.fixed_bodies.iter().map(|fixed| &fixed.body.mass));
        let mass: f64 = masses.map(|mass| mass.to_f64(&[])).sum();
        let mut scales = Scales {
            unknowns: Vec::new(),
            forms: Vec::new(),
        };
        for (j, (joint, &size)) in moving.joints.iter().zip(sizes).enumerate().rev() {
            if moving.tree.parent(j).is_none() {
                scales.forms.push(vec![size.sqrt()]);
                continue;
            }
            let mass = if mass > 0.0 { mass } else { size };
            let (angular, linear) = match joint.axis_motion {
                AxisMotion::Turns => (size, mass),
                AxisMotion::Slides => (mass, mass),
            };
            let motion = [angular.sqrt(), linear.sqrt()].map(|x| [x; 3]).concat();
            let count = unknowns(joint.axis_motion);
            for k in 0..count {
                let mut unit = vec![0.0; count];
                unit[k] = 1.0;
                let form = handed_on(joint.axis_motion, &unit, 0.0);
                let at = (0..36).find(|at| form[at / 6][at % 6] != 0.0).unwrap_or(0);
                scales.unknowns.push(motion[at / 6] * motion[at % 6]);
            }
            for _ in &joint.ends {
                scales.forms.push([&motion[..], &[size.sqrt()]].concat());
            }
            if joint.axis_motion == AxisMotion::Slides {
                scales.forms.push(vec![linear.sqrt(); 2]);
            }
        }
        scales
    }

    /// The forms and their rates in the unknowns, all in proportion to their scales.
    fn affine(&self, moving: &MovingJoints<f64>) -> Vec<Affine> {
        let n = self.unknowns.len();
        let at = |x: &[f64]| {
            let mut forms = forms(moving, x, 0.0, 1.0);
            for (form, scales) in forms.iter_mut().zip(&self.forms) {
                for (row, a) in form.iter_mut().zip(scales) {
                    for (x, b) in row.iter_mut().zip(scales) {
                        *x /= a * b;
                    }
                }
            }
            forms
        };
        let constant = at(&vec![0.0; n]);
        let affine = constant.into_iter().map(|constant| Affine {
            constant,
            slopes: Vec::new(),
        });
        let mut affine: Vec<Affine> = affine.collect();
        for k in 0..n {
            let mut unit = vec![0.0; n];
            unit[k] = self.unknowns[k];
            for (form, moved) in affine.iter_mut().zip(at(&unit)) {
                let slope = combined(moved, &form.constant, |moved, constant| moved - constant);
                if slope.iter().flatten().any(|x| *x != 0.0) {
                    form.slopes.push((k, slope));
                }
            }
        }
        affine
    }
}

/// Whether a symmetric matrix is positive definite, by the pivots of its elimination.
fn has_positive_pivots(mut m: Matrix<Interval>) -> bool {
    for j in (0..m.len()).rev() {
        let pivot = m[j][j];
        if !pivot.is_positive() {
            return false;
        }
        eliminate(&mut m, j, |x| x.over(pivot));
    }
    true
}
