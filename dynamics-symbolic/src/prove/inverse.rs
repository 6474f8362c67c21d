//! The proof of a plan of inverse kinematics: each of its branches leads to the pose from which it starts.
//!
//! The pose is that of the textbook definition at random joints in the prime field. Roots are those of the field, each with both
//! signs; a branch whose roots are not all in the field is tried at other joints. At the end of a branch the
//! definition gives the pose at the joints that were found.

use super::assignment::{Assignment, Number};
use super::definition::Definition;
use crate::exact::{SplitMix64, circle_point};
use crate::inverse::{ELBOW, Plan, Rule, Step, Target};
use crate::robot::Robot;

/// At so many joints the branches are tried. The root of a random number is in the field for every second one, and a branch
/// has six at most.
const MOST_DRAWS: u64 = 2_000;

/// A solution of one step.
#[derive(Clone, Copy)]
struct Solution {
    sin_cos: (Number, Number),
    q: Number,
}

/// The branches of a plan at one pose.
struct Branches<'p> {
    robot: &'p Robot,
    plan: &'p Plan,
    frame: Option<usize>,
    pose: [Number; 12],
    constants: Vec<Option<Number>>,
    /// Whether each branch has been seen to lead to its pose.
    are_right: Vec<bool>,
    is_wrong: bool,
}

/// Whether every branch of a plan, for a frame or for the tip, leads to the pose from which it starts.
pub fn prove_inverse(robot: &Robot, frame: Option<usize>, plan: &Plan) -> bool {
    let mut fixed = Assignment::new(robot, 0);
    Definition::read(&mut fixed, robot);
    fixed.note_program(&plan.program);
    let digest = fixed.digest();
    let mut are_right = vec![false; plan.branches()];
    for draw in 0..MOST_DRAWS {
        let mut point = Assignment::new(robot, SplitMix64::number(digest, draw));
        let definition = Definition::new(&mut point, robot);
        let Some(pose) = definition.pose_of(frame) else {
            return false;
        };
        if point.is_unfaithful() {
            return false;
        }
        let (s, c) = circle_point(&mut SplitMix64::new(draw));
        point.set_pose(pose);
        point.set_behind_pose(ELBOW, &[s, c]);
        let mut branches = Branches {
            robot,
            plan,
            frame,
            pose,
            constants: plan.program.constants.evaluate(&mut point),
            are_right,
            is_wrong: false,
        };
        branches.follow(&mut point, 0, 0);
        if branches.is_wrong {
            return false;
        }
        are_right = branches.are_right;
        // The joints from which the pose was made meet a condition; other branches of such an arm need not.
        let has_condition = plan.steps.contains(&Step::Condition);
        if !are_right.contains(&false) || has_condition && are_right.contains(&true) {
            return true;
        }
    }
    false
}

impl Branches<'_> {
    /// Takes the steps from this one on, in the branch of that number among those that the steps before make.
    fn follow(&mut self, point: &mut Assignment, step: usize, branch: usize) {
        let Some(&current) = self.plan.steps.get(step) else {
            self.compare(point, branch);
            return;
        };
        let (plan, constants) = (self.plan, self.constants.clone());
        let outputs = plan.program.evaluate_with(constants, point);
        let coefficients = outputs[plan.outputs_of(step)].iter().copied();
        let coefficients: Option<Vec<Number>> = coefficients.collect();
        let Some(coefficients) = coefficients else {
            return;
        };
        match current {
            // Branches that do not meet the condition have no solution.
            Step::Condition => {
                if coefficients[..3].iter().all(|x| x.is_zero()) {
                    self.follow(point, step + 1, branch);
                }
            }
            Step::Direction(place) => {
                if let Some(numbers) = direction(&coefficients[..3]) {
                    point.set_behind_pose(place, &numbers);
                    self.follow(point, step + 1, branch);
                }
            }
            Step::Joint(joint, rule) => {
                let solutions = solutions(rule, &coefficients).into_iter().flatten();
                for (k, Solution { sin_cos: (s, c), q }) in solutions.enumerate() {
                    if s * s + c * c != Number::ONE {
                        self.is_wrong = true;
                        return;
                    }
                    point.move_joint(joint, (s, c), q);
                    self.follow(point, step + 1, branch * current.solutions() + k);
                }
            }
        }
    }

    /// Whether the joints of a branch lead to the pose, as far as it is read.
    fn compare(&mut self, point: &mut Assignment, branch: usize) {
        let definition = Definition::new(point, self.robot);
        let from = match self.plan.target {
            Target::Position => 9,
            Target::Pose | Target::PoseAndElbow | Target::PositionAndAngle => 0,
        };
        let reached = definition.pose_of(self.frame);
        let is_right = reached.is_some_and(|reached| reached[from..] == self.pose[from..]);
        self.are_right[branch] |= is_right;
        self.is_wrong |= !is_right;
    }
}

/// The direction of a vector; none if its length is not in the field. Two vectors of the same length take the same of
/// both roots.
fn direction(vector: &[Number]) -> Option<Vec<Number>> {
    let square = vector.iter().fold(Number::ZERO, |sum, x| sum + *x * *x);
    let by = square.square_root()?.inverse()?;
    Some(vector.iter().map(|x| *x * by).collect())
}

/// The solutions of a step; none if a root is not in the field.
fn solutions(rule: Rule, coefficients: &[Number]) -> Option<Vec<Solution>> {
    let turn = |s: Number, c: Number| Solution {
        sin_cos: (s, c),
        q: Number::ZERO,
    };
    let slide = |q: Number| Solution {
        sin_cos: (Number::ZERO, Number::ONE),
        q,
    };
    match (rule, coefficients) {
        (Rule::Turn, &[cosine, sine, length, _]) => {
            let by = length.inverse()?;
            Some(vec![turn(sine * by, cosine * by)])
        }
        (Rule::Turns, &[a, b, c, discriminant, _]) => {
            let (root, by) = (discriminant.square_root()?, (a * a + b * b).inverse()?);
            let with = |root: Number| turn((b * c + a * root) * by, (a * c - b * root) * by);
            Some(vec![with(root), with(-root)])
        }
        (Rule::Slide, &[d]) => Some(vec![slide(d)]),
        (Rule::Slides, &[b, discriminant, _]) => {
            let root = discriminant.square_root()?;
            Some(vec![slide(b + root), slide(b - root)])
        }
        _ => None,
    }
}
