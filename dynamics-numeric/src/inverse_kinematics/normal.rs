//! The normal equations of all targets at one position of the joints.

use dynamics_runtime::Size;
use nalgebra::Vector3;

use super::joints::Joints;
use super::places::Places;
use super::problem::Problem;
use super::target::{Missing, Target};

/// The sum over targets of half of their squared errors, and its derivatives.
///
/// With the weighted errors e of all targets and the weighted Jacobian J, whose columns say how much of e each joint takes
/// away: E = 1/2 e'e, and the normal equations of Gauss and Newton are J'J dq = J'e.
#[derive(Clone, Debug)]
pub(super) struct Normal<D: Size> {
    /// E.
    pub(super) error: f64,
    /// J'e.
    pub(super) descent: D::Vector,
    /// J'J.
    pub(super) matrix: D::Matrix,
    /// Whether all targets are reached within the tolerance.
    pub(super) is_reached: bool,
}

impl<D: Size, P: Places<D>> Problem<'_, D, P> {
    #[inline(always)]
    pub(super) fn normal_at(&self, q: &D::Vector) -> Normal<D> {
        let (solver, joints) = (self.solver, self.joints);
        let mut all = Normal {
            error: 0.0,
            descent: joints.size.vector(),
            matrix: joints.size.matrix(),
            is_reached: true,
        };
        for (index, target) in self.targets.iter().enumerate() {
            let (pose, jacobian) = solver.places.place(index, q);
            let missing = target.error(&pose);
            all.is_reached &= solver.tolerance.holds(&missing);
            all.add(joints, target, &missing, &jacobian);
        }
        all
    }

    /// The joints that move a frame.
    pub(super) fn moving(&self, q: &D::Vector) -> D::Each<bool> {
        let size = self.joints.size;
        let mut moving = size.each(|_| false);
        for index in 0..self.targets.len() {
            let (_, jacobian) = self.solver.places.place(index, q);
            for joint in size.joints() {
                moving[joint] |= (0..6).any(|row| jacobian[(row, joint)] != 0.0);
            }
        }
        moving
    }
}

impl<D: Size> Normal<D> {
    /// The greatest diagonal entry of J'J.
    #[inline(always)]
    pub(super) fn greatest(&self) -> f64 {
        let entry = |joint: usize| self.matrix[(joint, joint)];
        let joints = D::of(&self.descent).joints();
        joints.map(entry).fold(0.0, f64::max)
    }

    #[inline(always)]
    fn add(
        &mut self,
        joints: &Joints<D>,
        target: &Target,
        missing: &Missing,
        jacobian: &D::Columns<6>,
    ) {
        let column = |joint: usize, first: usize| {
            Vector3::new(
                jacobian[(first, joint)],
                jacobian[(first + 1, joint)],
                jacobian[(first + 2, joint)],
            )
        };
        if let Some(error) = missing.position {
            let weight = target.position_weight / joints.length;
            self.add_rows(joints.size, weight, &error, |joint| column(joint, 0));
        }
        if let Some(error) = missing.rotation {
            let weight = target.rotation_weight;
            match missing.about {
                None => self.add_rows(joints.size, weight, &error, |joint| column(joint, 3)),
                // The turn about the direction itself is free.
                Some(about) => self.add_rows(joints.size, weight, &error, |joint| {
                    let turn = column(joint, 3);
                    turn - about * about.dot(&turn)
                }),
            }
        }
    }

    /// Adds three rows.
    #[inline(always)]
    fn add_rows(
        &mut self,
        size: D,
        weight: f64,
        error: &Vector3<f64>,
        column: impl Fn(usize) -> Vector3<f64>,
    ) {
        let weight = weight * weight;
        self.error += weight * error.norm_squared() / 2.0;
        for j in size.joints() {
            let right = column(j) * weight;
            self.descent[j] += right.dot(error);
            for i in 0..=j {
                self.matrix[(i, j)] += column(i).dot(&right);
            }
        }
    }
}
