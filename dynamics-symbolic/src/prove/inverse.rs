//! The proof of a plan of inverse kinematics: each of its branches leads to the pose from which it starts.
//!
//! The pose is that of the textbook definition at random joints in the prime field. Roots are those of the field, each with both
//! signs; a branch whose roots are not all in the field is tried at other joints. At the end of a branch the
//! definition gives the pose at the joints that were found. One branch is that of the joints from which the pose was made. Each of
//! the others, told apart by the roots in which it differs from that one, has to be seen at some joints.

use super::assignment::{Assignment, Number};
use super::definition::Definition;
use crate::exact::{SplitMix64, circle_point};
use crate::function::Argument;
use crate::inverse::{ELBOW, Plan, Rule, Step, Target};
use crate::linear::Vector3;
use crate::robot::Robot;

/// At so many joints the branches are tried. The root of a random number is in the field for every second one, and a branch
/// has six at most.
const MOST_DRAWS: u64 = 4_000;

/// A branch of seven joints has to be right so often: which root of the field is which is random, so that a wrong one is missed with
/// a probability of 2^-16 at most.
const OFTEN: usize = 16;

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
    /// The positions from which the pose was made, and the number of the branch on which they were found.
    drawn: Vec<(Number, Number, Number)>,
    own: Option<usize>,
    /// The branches that led to the pose.
    right: Vec<usize>,
    is_wrong: bool,
}

/// Whether every branch of a plan, for a frame or for the tip, leads to the pose from which it starts.
pub fn prove_inverse(robot: &Robot, frame: Option<usize>, plan: &Plan) -> bool {
    let mut fixed = Assignment::new(robot, 0);
    Definition::read(&mut fixed, robot);
    fixed.note_program(&plan.program);
    let digest = fixed.digest();
    // How often each branch has been seen to lead to its pose: those of other roots than the pose was made of, by which roots differ.
    // Without a branch of its own a pose has roots of either sign on all branches.
    let has_own = plan.target != Target::PoseAndElbow;
    let mut seen = vec![0; plan.most()];
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
            drawn: (0..plan.joints).map(|i| point.position(i)).collect(),
            own: None,
            right: Vec::new(),
            is_wrong: false,
        };
        branches.follow(&mut point, 0, 0);
        if branches.is_wrong {
            return false;
        }
        let own = match (has_own, branches.own) {
            (true, None) => continue,
            (_, own) => own.unwrap_or(0),
        };
        for branch in branches.right {
            seen[branch ^ own] += 1;
        }
        let often = if has_own { 1 } else { OFTEN };
        // The joints from which the pose was made meet a condition; other branches of such an arm need not.
        let has_condition = plan.steps.contains(&Step::Condition);
        if has_condition && seen[0] > 0 || seen.iter().all(|count| *count >= often) {
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
                        // A pose that is out of reach on this branch, which the condition finds.
                        self.is_wrong |= !plan.steps.contains(&Step::Condition);
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
        let is_right = reached.is_some_and(|reached| reached[from..] == self.pose[from..])
            && self.has_elbow(point);
        // An angle by its sine and cosine, a displacement by itself.
        let is_drawn = |(i, (s, c, q)): (usize, &(Number, Number, Number))| {
            let found = point.position(i);
            (found.0, found.1) == (*s, *c) || found.2 == *q
        };
        if self.drawn.iter().enumerate().all(is_drawn) {
            self.own = Some(branch);
        }
        self.right.push(branch);
        self.is_wrong |= !is_right;
    }
}

impl Branches<'_> {
    /// Whether the numbers of `Plan::elbow` are along the line of the pose, and across it along the direction of the elbow's angle:
    /// w x line = 0 and (w x elbow) x (w x (cos start + sin w x start)) = 0. The direction of axis 4 is at right angles to the elbow's.
    fn has_elbow(&self, point: &mut Assignment) -> bool {
        let Some(program) = &self.plan.elbow else {
            return true;
        };
        let outputs = program.evaluate(point);
        let vector = |k: usize| [outputs[k], outputs[k + 1], outputs[k + 2]];
        let known = |[x, y, z]: [Option<Number>; 3]| Some(Vector3([x?, y?, z?]));
        let [Some(line), Some(elbow), Some(axis)] = [0, 3, 6].map(|k| known(vector(k))) else {
            return false;
        };
        let [sine, cosine, x, y, z, i, j, k] =
            core::array::from_fn(|place| point.entry(Argument::Pose, ELBOW + place));
        let (w, start) = (Vector3([x, y, z]), Vector3([i, j, k]));
        let asked = start * cosine + w.cross(start) * sine;
        let vanishes = |v: Vector3<Number>| v.0.iter().all(|x| x.is_zero());
        let is_axis = axis.dot(elbow).is_zero() && axis.dot(axis) == Number::ONE;
        is_axis && vanishes(w.cross(line)) && vanishes(w.cross(elbow).cross(w.cross(asked)))
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
        // The sum of both with a factor that has nothing to do with them.
        (Rule::TurnsOfLine, &[a, b, c, u, v, w, size]) => {
            let [a, b, c] = [a + size * u, b + size * v, c + size * w];
            solutions(Rule::Turns, &[a, b, c, a * a + b * b - c * c, size])
        }
        (Rule::Slide, &[d]) => Some(vec![slide(d)]),
        (Rule::Slides, &[b, discriminant, _]) => {
            let root = discriminant.square_root()?;
            Some(vec![slide(b + root), slide(b - root)])
        }
        _ => None,
    }
}
