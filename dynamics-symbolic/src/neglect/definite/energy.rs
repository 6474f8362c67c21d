//! The forms whose signs make M positive definite.

use super::chain::MovingJoints;
use super::matrix::{Matrix, combined, congruent};
use crate::linear::Ring;
use crate::spatial::AxisMotion;

/// How many coefficients the form L_j of a joint has.
pub(super) fn unknowns(axis_motion: AxisMotion) -> usize {
    match axis_motion {
        AxisMotion::Turns => 7,
        AxisMotion::Slides => 21,
    }
}

/// L: of a revolute joint a form that no turn about z changes; of a prismatic one any form.
pub(super) fn handed_on<R: Ring>(axis_motion: AxisMotion, x: &[R], zero: R) -> Matrix<R> {
    let mut form = vec![vec![zero; 6]; 6];
    let mut set = |i: usize, k: usize, x: R| {
        form[i][k] = x;
        form[k][i] = x;
    };
    match axis_motion {
        AxisMotion::Turns => {
            set(2, 2, x[0]);
            set(5, 5, x[1]);
            set(2, 5, x[2]);
            for i in 0..2 {
                set(i, i, x[3]);
                set(3 + i, 3 + i, x[4]);
                set(i, 3 + i, x[5]);
            }
            set(0, 4, x[6]);
            set(1, 3, -x[6]);
        }
        AxisMotion::Slides => {
            let upper = (0..6).flat_map(|i| (i..6).map(move |k| (i, k)));
            for ((i, k), &x) in upper.zip(x) {
                set(i, k, x);
            }
        }
    }
    form
}

/// Forms that are positive definite for some `x` where M is at all positions: see the module.
pub(super) fn forms<R: Ring>(moving: &MovingJoints<R>, x: &[R], zero: R, one: R) -> Vec<Matrix<R>> {
    let mut forms = Vec::new();
    let mut rest = x;
    let add = |a: Matrix<R>, b: &Matrix<R>| combined(a, b, |a, b| a + b);
    let add_both = |a: Option<Matrix<R>>, b: Option<Matrix<R>>| Some(add(a?, &b?));
    // The form that the joints outside hand on is in the axes of this link.
    moving
        .tree
        .inward(None, add_both, |j, outer: Option<Matrix<R>>| {
            let joint = &moving.joints[j];
            let inertia = match &outer {
                Some(outer) => add(joint.inertia.clone(), outer),
                None => joint.inertia.clone(),
            };
            let axis = match joint.axis_motion {
                AxisMotion::Turns => 2,
                AxisMotion::Slides => 5,
            };
            if moving.tree.parent(j).is_none() {
                forms.push(vec![vec![inertia[axis][axis] + joint.reflected]]);
                return None;
            }
            let (own, others) = rest.split_at(unknowns(joint.axis_motion));
            rest = others;
            let handed = handed_on(joint.axis_motion, own, zero);
            for end in &joint.ends {
                let moved = |(i, row): (usize, &Vec<R>)| {
                    let along = if i == axis { one } else { zero };
                    row.iter().copied().chain([along]).collect()
                };
                let moved = end.iter().enumerate().map(moved).collect();
                let mut form = congruent(&inertia, &moved);
                form[6][6] = form[6][6] + joint.reflected;
                forms.push(combined(form, &handed, |a, b| a - b));
            }
            if joint.axis_motion == AxisMotion::Slides {
                forms.push([3, 4].map(|i| handed[i][3..5].to_vec()).to_vec());
            }
            Some(congruent(&handed, &joint.enter))
        });
    forms
}
