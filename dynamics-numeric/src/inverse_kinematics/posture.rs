//! The secondary aim: of all positions of the joints that reach the targets, one near a preferred posture.

use dynamics_runtime::{JointVector as _, Size};

use super::descent::End;
use super::places::Places;
use super::problem::Problem;

/// The damping that pulls, as a share of the greatest diagonal entry of J'J.
const PULL: f64 = 1e-7;

/// The longest step of a joint, rad, or as a share of the arm's length.
const LONGEST_STEP: f64 = 0.3;

/// Steps that are shorter end the search.
const SHORTEST_STEP: f64 = 1e-7;

const MOST_STEPS: usize = 200;

/// The iterations of the descent that brings the joints back to the targets after a step.
const RETURN: usize = 10;

impl<D: Size, P: Places<D>> Problem<'_, D, P> {
    /// Moves from `reached`, where all targets are reached, towards `posture`, on positions where they are.
    ///
    /// A step d along the difference to the posture becomes the one that minimises |J dq - e|^2 + mu |dq -
    /// d|^2. For small mu it is the projection of d on the null space of J. Joints that are on their limits
    /// are held there.
    pub(super) fn approach(&self, reached: D::Vector, posture: &D::Vector) -> D::Vector {
        let joints = self.joints;
        let far = |q: &D::Vector| {
            let square = |joint: usize| (posture[joint] - q[joint]) * (posture[joint] - q[joint]);
            joints.size.joints().map(square).sum::<f64>()
        };
        let (mut q, mut longest) = (reached, LONGEST_STEP);
        for _ in 0..MOST_STEPS {
            let wish = posture.clone() - q.clone();
            let share = (longest / wish.largest()).min(1.0);
            let normal = self.normal_at(&q);
            let mu = PULL * normal.greatest();
            let pull = wish * (share * mu);
            let Some(next) = normal.stepped(joints, mu, Some(&pull), &q) else {
                break;
            };
            let next = self.descend(next, RETURN);
            let gain = far(&q) - far(&next.q);
            if next.end == End::Reached && gain > 0.0 {
                q = next.q;
            } else {
                longest = 0.25 * longest.min((next.q - q.clone()).largest());
            }
            if longest < SHORTEST_STEP || (0.0..SHORTEST_STEP * SHORTEST_STEP).contains(&gain) {
                break;
            }
        }
        q
    }
}
