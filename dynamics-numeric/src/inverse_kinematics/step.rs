//! One step of Levenberg and Marquardt between the limits of the joints.

use dynamics_runtime::internal::JointFactors;
use dynamics_runtime::{JointVector as _, Size};

use super::joints::Joints;
use super::normal::Normal;

/// How often joints are set on their limits and the others are solved for again, in one step.
const MOST_PASSES: usize = 4;

impl<D: Size> Normal<D> {
    /// The position within the limits after the step dq with (J'J + damping) dq = J'e + pull.
    ///
    /// Joints that would pass a limit are put on it, and the others make up for it: their step is solved for anew. `None`
    /// where no joint moves any target.
    #[inline(always)]
    pub(super) fn stepped(
        &self,
        joints: &Joints<D>,
        damping: f64,
        pull: Option<&D::Vector>,
        q: &D::Vector,
    ) -> Option<D::Vector> {
        let size = joints.size;
        let mut held = size.each(|_| false);
        let mut step = size.vector();
        for pass in 1..=MOST_PASSES {
            let free = self.solve(damping, pull, &held, &step)?;
            let mut is_within = true;
            for joint in size.joints() {
                if held[joint] {
                    continue;
                }
                let [low, high] = joints.range(joint).map(|limit| limit - q[joint]);
                step[joint] = free[joint].max(low).min(high);
                held[joint] = step[joint] != free[joint];
                is_within &= !held[joint];
            }
            if is_within || pass == MOST_PASSES {
                break;
            }
        }
        Some(joints.within(&q.plus(1.0, &step)))
    }

    /// The step of the joints that are not held, beside that of those that are.
    #[inline(always)]
    fn solve(
        &self,
        damping: f64,
        pull: Option<&D::Vector>,
        held: &D::Each<bool>,
        step: &D::Vector,
    ) -> Option<D::Vector> {
        let size = D::of(step);
        let (mut matrix, mut right) = (self.matrix.clone(), self.descent.clone());
        if let Some(pull) = pull {
            right = right + pull.clone();
        }
        for joint in size.joints() {
            matrix[(joint, joint)] += damping;
        }
        for joint in size.joints().filter(|joint| held[*joint]) {
            hold(size, joint, step[joint], &mut matrix, &mut right);
        }
        let factors = JointFactors::new(size.value(), matrix).ok()?;
        Some(factors.solve(&right))
    }
}

/// Makes the unknown of a joint a known number: its column goes to the right side, its row becomes that of the unit matrix.
fn hold<D: Size>(size: D, joint: usize, step: f64, matrix: &mut D::Matrix, right: &mut D::Vector) {
    for other in size.joints().filter(|other| *other != joint) {
        // The upper triangle is all there is.
        let entry = &mut matrix[(joint.min(other), joint.max(other))];
        right[other] -= *entry * step;
        *entry = 0.0;
    }
    matrix[(joint, joint)] = 1.0;
    right[joint] = step;
}
