//! The search for a plan: depth first, equations with one solution before those with two.

use super::chain::{Link, between, chain, joints};
use super::moves::{Move, Path};
use super::plan::{BranchNames, Plan, Step, Target};
use super::rules::{Equation, equations};
use super::view::{Unknown, View};
use super::why::{Unsolved, class, is_waist};
use super::{branch, redundant};
use crate::derive::symbols::Symbols;
use crate::expr::{Edge, Expr, Graph, NodeId};
use crate::linear::{Matrix3, Vector3};
use crate::mechanism::Mechanism;
use crate::program::Program;
use crate::robot::Robot;
use std::collections::BTreeSet;

/// More solutions than this have no room among the results.
const MOST_BRANCHES: usize = 8;

/// A part of the pose that is compared at the end.
#[derive(Clone, Copy)]
enum Condition {
    Position,
    Pose,
}

/// A search, with all that it reads.
struct Search<'g, 'a> {
    graph: &'g Graph,
    chain: Vec<Link<'g>>,
    pose: Path<'g>,
    /// The symbols of the rotation, if it is not to be read.
    forbidden: BTreeSet<NodeId>,
    /// The condition at the end, of arms that reach a part of all poses.
    condition: Option<Condition>,
    /// The part of the arm that is solved first, if there is one: how many links of the chain there are up to its last joint, and
    /// where the frame behind that is.
    part: Option<(usize, Path<'g>)>,
    /// The plan of these steps, if it is right.
    accept: &'a dyn Fn(&[Equation<'g>]) -> Option<Plan>,
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
    let pose = Path(vec![Move {
        rotation: Matrix3(rotation),
        origin: Vector3(position),
    }]);
    write_squares(&chain);
    let mut found = Vec::new();
    let all = views(&graph, &chain, &pose, &BTreeSet::new(), &BTreeSet::new());
    let [view, _] = all.ok_or(Unsolved::Undetermined)?;
    let (target, why) = class(&view)?;
    let mut elbow = None;
    let part = match target {
        Target::PoseAndElbow => {
            let shoulder = redundant::shoulder(&mut symbols, &chain, &view, &mut found);
            let (part, outputs) = shoulder.ok_or(why.clone())?;
            elbow = Some(outputs);
            Some(part)
        }
        Target::Pose | Target::Position | Target::PositionAndAngle => None,
    };
    let forbidden = match target {
        Target::Position => rotation.iter().flatten().map(|x| x.edge().node()).collect(),
        _ => BTreeSet::new(),
    };
    let joints = view.joints.len();
    let meanings = symbols.meanings().to_vec();
    let program = |outputs: &mut dyn Iterator<Item = Expr<'_>>| {
        let outputs: Vec<Edge> = outputs.map(|x| x.edge()).collect();
        Program::new(&graph, &meanings, &outputs, &|id| graph.operation(id))
    };
    let elbow = elbow.map(|outputs| program(&mut outputs.into_iter()));
    let accept = |found: &[Equation<'_>]| {
        let mut outputs = found.iter().flat_map(|found| found.coefficients.clone());
        let plan = Plan {
            steps: found.iter().map(|found| found.step).collect(),
            program: program(&mut outputs),
            joints,
            target,
            branches: BranchNames::default(),
            elbow: elbow.clone(),
        };
        is_right(&plan).then_some(plan)
    };
    let search = Search {
        graph: &graph,
        pose,
        condition: match (target, joints) {
            (Target::PositionAndAngle, _) | (Target::Position, ..3) => Some(Condition::Position),
            (Target::Pose, _) if is_waist(&view) => Some(Condition::Pose),
            _ => None,
        },
        chain,
        forbidden,
        part,
        accept: &accept,
    };
    let plan = search.solve(&mut found).ok_or(why)?;
    let names = branch::names(&graph, &meanings, &search.chain, arm.fields, &plan);
    Ok(Plan {
        branches: names,
        ..plan
    })
}

/// The equation of those joints of a chain that are not known, and its inverse; `None` if all are.
fn views<'g>(
    graph: &'g Graph,
    chain: &[Link<'g>],
    pose: &Path<'g>,
    known: &BTreeSet<usize>,
    forbidden: &BTreeSet<NodeId>,
) -> Option<[View<'g>; 2]> {
    let unknown: Vec<Unknown> = joints(chain)
        .filter(|joint| !known.contains(&joint.number))
        .collect();
    let ways = between(chain, known);
    let [first, links @ .., last] = &ways[..] else {
        return None;
    };
    let target = first.inverse().then(pose).then(&last.inverse());
    let view = |joints, links, target, is_inverse, behind: &Path<'g>| View {
        graph,
        joints,
        links,
        target,
        is_inverse,
        span: span(graph, chain),
        tip: behind.point(Vector3::splat(graph.zero())),
        forbidden: forbidden.clone(),
    };
    let opposite = unknown.iter().rev().copied().collect();
    let back = links.iter().rev().map(Path::inverse).collect();
    let inverse = view(opposite, back, target.inverse(), true, &first.inverse());
    let view = view(unknown, links.to_vec(), target, false, last);
    Some([view, inverse])
}

/// The sum of the squares of the fixed lengths of a chain.
fn span<'g>(graph: &'g Graph, chain: &[Link<'g>]) -> Expr<'g> {
    let fixed = chain.iter().filter(|link| link.joint.is_none());
    let squares = fixed.map(|link| link.motion.origin.dot(link.motion.origin));
    squares.fold(graph.zero(), |sum, square| sum + square)
}

/// Writes the squares of all sines and cosines, so that no expression has 1 - c^2 in place of s^2, which keeps the digits of small
/// sines: a node has the first form in which it was written.
fn write_squares(chain: &[Link<'_>]) {
    for link in chain.iter().filter(|link| link.joint.is_some()) {
        let [c, s, _] = link.motion.rotation.column(0).0;
        let _ = (s * s, c * c);
    }
}

impl<'g> Search<'g, '_> {
    /// Adds equations of the joints that are not known, until all are and the plan is accepted.
    fn solve(&self, found: &mut Vec<Equation<'g>>) -> Option<Plan> {
        let known = found.iter().filter_map(|found| match found.step {
            Step::Joint(joint, _) => Some(joint),
            Step::Direction(_) | Step::Condition => None,
        });
        let known: BTreeSet<usize> = known.collect();
        let Some([view, inverse]) = self.views(&known) else {
            return self.ends(found);
        };
        let mut candidates = equations(&view);
        candidates.extend(equations(&inverse));
        candidates.sort_by_key(|equation| (equation.step.solutions(), equation.loses_digits));
        // One equation with one solution is as good as another.
        let is_single = |first: &Equation<'_>| first.step.solutions() == 1;
        let has_single = candidates.first().is_some_and(is_single);
        let tried = if has_single { 1 } else { candidates.len() };
        for equation in candidates.into_iter().take(tried) {
            found.push(equation);
            let solutions = found.iter().map(|found| found.step.solutions());
            let branches: usize = solutions.product();
            let plan = (branches <= MOST_BRANCHES).then(|| self.solve(found));
            if let Some(Some(plan)) = plan {
                return Some(plan);
            }
            found.pop();
        }
        None
    }

    /// The equation of the joints that are not known, and its inverse; `None` if all are.
    fn views(&self, known: &BTreeSet<usize>) -> Option<[View<'g>; 2]> {
        let whole = (&self.chain[..], &self.pose);
        let part = self.part.iter();
        let part = part.map(|(links, pose)| (&self.chain[..*links], pose));
        let mut parts = part.chain([whole]);
        parts.find_map(|(chain, pose)| views(self.graph, chain, pose, known, &self.forbidden))
    }

    /// The plan, with the condition of arms that do not reach all positions.
    fn ends(&self, found: &mut Vec<Equation<'g>>) -> Option<Plan> {
        let steps = found.len();
        found.extend(self.conditions());
        let plan = (self.accept)(found);
        found.truncate(steps);
        plan
    }

    /// The position that is reached is the one that was requested, and so are the x and z axes where they are compared.
    fn conditions(&self) -> Vec<Equation<'g>> {
        let Some(condition) = self.condition else {
            return Vec::new();
        };
        let all: BTreeSet<usize> = joints(&self.chain).map(|joint| joint.number).collect();
        let way = &between(&self.chain, &all)[0];
        let (zero, one) = (self.graph.zero(), self.graph.one());
        let origin = Vector3::splat(zero);
        let [reached, asked] = [way, &self.pose].map(|way| way.point(origin));
        let size = reached.dot(reached) + asked.dot(asked) + span(self.graph, &self.chain);
        let mut conditions = vec![Self::is_reached(reached - asked, size)];
        if let Condition::Pose = condition {
            let axes = [[one, zero, zero], [zero, zero, one]].map(Vector3);
            let misses = axes.map(|axis| way.direction(axis) - self.pose.direction(axis));
            conditions.extend(misses.map(|miss| Self::is_reached(miss, one)));
        }
        conditions
    }

    fn is_reached(miss: Vector3<Expr<'g>>, size: Expr<'g>) -> Equation<'g> {
        Equation {
            step: Step::Condition,
            loses_digits: false,
            coefficients: [&miss.0[..], &[size]].concat(),
        }
    }
}
