//! The search for a plan: depth first, equations with one solution before those with two.

use super::chain::{Link, between, chain, chain_view, joints};
use super::found::Found;
use super::moves::{Move, Path};
use super::plan::{Plan, Rule, Solved, Step, Target};
use super::redundant;
use super::rules::equations;
use super::view::{Unknown, View, are_parallel};
use super::why::{Unsolved, why_not};
use crate::derive::symbols::Symbols;
use crate::expr::{Edge, Graph, NodeId};
use crate::linear::{Matrix3, Vector3};
use crate::mechanism::Mechanism;
use crate::program::Program;
use crate::robot::{JointType, Robot};
use std::collections::BTreeSet;

/// More solutions than this have no room among the results.
const MOST_BRANCHES: usize = 8;

/// A search, with all that it reads.
struct Search<'g, 'a> {
    graph: &'g Graph,
    chain: Vec<Link<'g>>,
    pose: Path<'g>,
    /// The symbols of the rotation, if it is not to be read.
    forbidden: BTreeSet<NodeId>,
    /// The condition at the end, of arms that reach a part of all positions.
    is_conditional: bool,
    /// The shoulder of seven joints: how many links of the chain there are up to the third joint, and where the frame
    /// behind it is.
    shoulder: Option<(usize, Path<'g>)>,
    accept: &'a dyn Fn(&[Step], &[Edge]) -> bool,
}

/// The plan for a frame among the robot's `frames`, or for its tip, that `is_right` accepts.
///
/// # Errors
///
/// Why there is none.
pub fn plan(
    robot: &Robot,
    frame: Option<usize>,
    is_right: &dyn Fn(&Plan) -> bool,
) -> Result<Plan, Unsolved> {
    let arm = Mechanism::from(robot);
    let graph = Graph::new();
    let mut symbols = Symbols::new(&graph, &arm);
    let chain = chain(&mut symbols, &arm, frame)?;
    let (rotation, position) = symbols.target();
    let pose = Path(vec![Move::Fixed(Matrix3(rotation), Vector3(position))]);
    write_squares(&chain);
    let mut found = Vec::new();
    let why = why_not(&chain_view(&chain, &graph));
    let (target, shoulder) = match target(&chain, &graph) {
        Some(target) => (target, None),
        None => {
            let redundant = redundant::shoulder(&mut symbols, &chain, &pose, &mut found);
            (Target::PoseAndElbow, Some(redundant.ok_or(why.clone())?))
        }
    };
    let forbidden = match target {
        Target::Position => rotation.iter().flatten().map(|x| x.edge().node()).collect(),
        _ => BTreeSet::new(),
    };
    let joints = joints(&chain).count();
    let meanings = symbols.meanings().to_vec();
    let plan = |steps: &[Step], outputs: &[Edge]| {
        let definition = |id| graph.operation(id);
        Plan {
            steps: steps.to_vec(),
            program: Program::new(&graph, &meanings, outputs, &definition),
            joints,
            target,
        }
    };
    let search = Search {
        graph: &graph,
        pose,
        is_conditional: target == Target::PositionAndAngle || joints < 3,
        chain,
        forbidden,
        shoulder,
        accept: &|steps, outputs| is_right(&plan(steps, outputs)),
    };
    if !search.solve(&mut found) {
        return Err(why);
    }
    let (steps, outputs) = Search::parts(&found);
    Ok(plan(&steps, &outputs))
}

/// Writes the squares of all sines and cosines, so that no expression has 1 - c^2 in place of s^2, which keeps the digits of small
/// sines: a node has the first form in which it was written.
fn write_squares(chain: &[Link<'_>]) {
    for link in chain {
        if let Link::Joint(_, Move::Turn(s, c)) = link {
            let _ = (*s * *s, *c * *c);
        }
    }
}

/// The part of the pose that is read by arms that have closed forms; `None` of all others.
fn target<'g>(chain: &[Link<'g>], graph: &'g Graph) -> Option<Target> {
    let view = chain_view(chain, graph);
    let count = view.joints.len();
    let turning = view
        .joints
        .iter()
        .filter(|joint| joint.joint_type == JointType::Revolute);
    let turning = turning.count();
    let z = view.z();
    let is_parallel = |i: usize| are_parallel(view.way(0, i).direction(z), z);
    let are_all_parallel = (0..count).all(is_parallel);
    match count {
        3 if turning == 3 && are_all_parallel => Some(Target::PositionAndAngle),
        1..=3 => Some(Target::Position),
        4 if turning == 3 && are_all_parallel => Some(Target::Pose),
        6 => Some(Target::Pose),
        _ => None,
    }
}

impl<'g> Search<'g, '_> {
    /// Adds equations of the joints that are not known, until all are and the plan is accepted.
    fn solve(&self, found: &mut Vec<Found<'g>>) -> bool {
        let known = found.iter().filter_map(|found| found.step.joint());
        let known: BTreeSet<usize> = known.collect();
        let views = self.views(&known);
        let Some([view, inverse]) = views else {
            return self.ends(found);
        };
        let mut candidates = equations(&view);
        candidates.extend(equations(&inverse));
        candidates.sort_by_key(|equation| equation.rule.solutions());
        // One equation with one solution is as good as another.
        let has_single = candidates
            .first()
            .is_some_and(|first| first.rule.solutions() == 1);
        let tried = if has_single { 1 } else { candidates.len() };
        for equation in candidates.into_iter().take(tried) {
            let step = Step {
                solved: Solved::Joint(equation.joint),
                rule: equation.rule,
            };
            found.push(Found {
                step,
                coefficients: equation.coefficients,
            });
            let solutions = found.iter().map(|found| found.step.rule.solutions());
            let branches: usize = solutions.product();
            if branches <= MOST_BRANCHES && self.solve(found) {
                return true;
            }
            found.pop();
        }
        false
    }

    /// The equation of the joints that are not known, and its inverse; `None` if all are.
    fn views(&self, known: &BTreeSet<usize>) -> Option<[View<'g>; 2]> {
        let of = |chain: &[Link<'g>]| {
            let joints = joints(chain).filter(|joint| !known.contains(&joint.number));
            joints.collect::<Vec<Unknown>>()
        };
        let shoulder = self
            .shoulder
            .as_ref()
            .map(|(links, pose)| (&self.chain[..*links], pose));
        let shoulder = shoulder.filter(|(chain, _)| !of(chain).is_empty());
        let (chain, pose) = shoulder.unwrap_or((&self.chain, &self.pose));
        let unknown = of(chain);
        if unknown.is_empty() {
            return None;
        }
        let (first, links, last) = between(chain, known);
        let origin = Vector3::splat(self.graph.zero());
        let target = first.inverse().then(pose).then(&last.inverse());
        let inverse = View {
            graph: self.graph,
            joints: unknown.iter().rev().copied().collect(),
            links: links.iter().rev().map(Path::inverse).collect(),
            target: target.inverse(),
            is_inverse: true,
            tip: first.inverse().point(origin),
            forbidden: self.forbidden.clone(),
        };
        let view = View {
            graph: self.graph,
            joints: unknown,
            links,
            target,
            is_inverse: false,
            tip: last.point(origin),
            forbidden: self.forbidden.clone(),
        };
        Some([view, inverse])
    }

    /// Adds the condition of arms that do not reach all positions, and asks whether the plan is right.
    fn ends(&self, found: &mut Vec<Found<'g>>) -> bool {
        if self.is_conditional {
            found.push(self.condition());
        }
        let (steps, outputs) = Search::parts(found);
        if (self.accept)(&steps, &outputs) {
            return true;
        }
        if self.is_conditional {
            found.pop();
        }
        false
    }

    /// The position that is reached is the one that was requested.
    fn condition(&self) -> Found<'g> {
        let all: BTreeSet<usize> = joints(&self.chain).map(|joint| joint.number).collect();
        let (way, ..) = between(&self.chain, &all);
        let origin = Vector3::splat(self.graph.zero());
        let reached = way.point(origin);
        let asked = self.pose.point(origin);
        let [x, y, z] = (reached - asked).0;
        Found {
            step: Step {
                solved: Solved::Nothing,
                rule: Rule::Condition,
            },
            coefficients: vec![x, y, z, reached.dot(reached) + asked.dot(asked)],
        }
    }

    fn parts(found: &[Found<'g>]) -> (Vec<Step>, Vec<Edge>) {
        let steps = found.iter().map(|found| found.step);
        let outputs = found.iter().flat_map(|found| &found.coefficients);
        (steps.collect(), outputs.map(|x| x.edge()).collect())
    }
}
