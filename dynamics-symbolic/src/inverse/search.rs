//! The search for a plan: depth first, equations with one solution before those with two.

use super::moves::{Move, Path};
use super::plan::{Plan, Rule, Step, Target};
use super::rules::{Equation, equations};
use super::view::{Unknown, View, are_parallel};
use super::why::{Unsolved, why_not};
use crate::derive::place;
use crate::derive::symbols::Symbols;
use crate::expr::{Edge, Expr, Graph, NodeId};
use crate::linear::{Matrix3, Vector3};
use crate::mechanism::{Joint, Law, Mechanism};
use crate::program::Program;
use crate::robot::{Interpretation, JointType, Placement, Robot};
use std::collections::BTreeSet;

/// More solutions than this have no room among the results.
const MOST_BRANCHES: usize = 8;

/// The arm from the world to a frame: fixed steps and joints.
pub(super) enum Link<'g> {
    Fixed(Matrix3<Expr<'g>>, Vector3<Expr<'g>>),
    Joint(Unknown, Move<'g>),
}

/// What a search knows.
struct Search<'g, 'a> {
    graph: &'g Graph,
    chain: Vec<Link<'g>>,
    pose: Move<'g>,
    /// The symbols of the rotation, if it is not to be read.
    forbidden: BTreeSet<NodeId>,
    /// The condition at the end, of arms that reach a part of all positions.
    is_conditional: bool,
    accept: &'a dyn Fn(&[(Option<usize>, Rule)], &[Edge]) -> bool,
}

/// A step of the search, with its coefficients.
struct Found<'g> {
    joint: Option<usize>,
    rule: Rule,
    coefficients: Vec<Expr<'g>>,
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
    let unknowns: Vec<Unknown> = joints(&chain).collect();
    let target = target(&chain, &graph);
    let Some(target) = target else {
        return Err(why_not(&chain_view(&chain, &graph)));
    };
    let forbidden = match target {
        Target::Position => rotation.iter().flatten().map(|x| x.edge().node()).collect(),
        Target::Pose | Target::PositionAndAngle => BTreeSet::new(),
    };
    let meanings = symbols.meanings().to_vec();
    let program = |steps: &[(Option<usize>, Rule)], outputs: &[Edge]| {
        let definition = |id| graph.operation(id);
        let program = Program::new(&graph, &meanings, outputs, &definition);
        let steps = steps.iter().map(|&(joint, rule)| Step { joint, rule });
        Plan {
            steps: steps.collect(),
            program,
            joints: unknowns.len(),
            target,
        }
    };
    let accept = |steps: &[(Option<usize>, Rule)], outputs: &[Edge]| is_right(&program(steps, outputs));
    let search = Search {
        graph: &graph,
        pose: Move::Fixed(Matrix3(rotation), Vector3(position)),
        is_conditional: target == Target::PositionAndAngle || unknowns.len() < 3,
        chain,
        forbidden,
        accept: &accept,
    };
    let mut found = Vec::new();
    if !search.solve(&mut found) {
        return Err(why_not(&chain_view(&search.chain, &graph)));
    }
    let (steps, outputs) = Search::parts(&found);
    Ok(program(&steps, &outputs))
}

/// What is read of the pose by arms that have closed forms; `None` of all others.
fn target<'g>(chain: &[Link<'g>], graph: &'g Graph) -> Option<Target> {
    let view = chain_view(chain, graph);
    let count = view.joints.len();
    let turning = view.joints.iter().filter(|joint| joint.joint_type == JointType::Revolute);
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

/// The joints of a chain with all of them unknown.
fn chain_view<'g>(chain: &[Link<'g>], graph: &'g Graph) -> View<'g> {
    let (first, links, last) = between(chain, &BTreeSet::new());
    View {
        graph,
        joints: joints(chain).collect(),
        links,
        target: first.then(&last),
        is_inverse: false,
        tip: Vector3::splat(graph.zero()),
        forbidden: BTreeSet::new(),
    }
}

fn joints<'g>(chain: &[Link<'g>]) -> impl Iterator<Item = Unknown> {
    chain.iter().filter_map(|link| match link {
        Link::Fixed(..) => None,
        Link::Joint(joint, _) => Some(*joint),
    })
}

/// The way to the first joint that is not known, those between such joints, and the one behind the last.
fn between<'g>(
    chain: &[Link<'g>],
    known: &BTreeSet<usize>,
) -> (Path<'g>, Vec<Path<'g>>, Path<'g>) {
    let mut paths = vec![Path::default()];
    for link in chain {
        let here = paths.last_mut().expect("never empty");
        match link {
            Link::Fixed(rotation, origin) => here.0.push(Move::Fixed(*rotation, *origin)),
            Link::Joint(joint, motion) if known.contains(&joint.number) => here.0.push(*motion),
            Link::Joint(..) => paths.push(Path::default()),
        }
    }
    let last = paths.pop().expect("never empty");
    if paths.is_empty() {
        return (last, Vec::new(), Path::default());
    }
    let first = paths.remove(0);
    (first, paths, last)
}

impl<'g> Search<'g, '_> {
    /// Adds equations of the joints that are not known, until all are and the plan is accepted.
    fn solve(&self, found: &mut Vec<Found<'g>>) -> bool {
        let known: BTreeSet<usize> = found.iter().filter_map(|found| found.joint).collect();
        let views = self.views(&known);
        let Some([view, inverse]) = views else {
            return self.ends(found);
        };
        let mut candidates = equations(&view);
        candidates.extend(equations(&inverse));
        candidates.sort_by_key(|equation| equation.rule.solutions());
        // One equation with one solution is as good as another.
        let has_single = candidates.first().is_some_and(|first| first.rule.solutions() == 1);
        let tried = if has_single { 1 } else { candidates.len() };
        let joint_of = |equation: &Equation<'g>, is_inverse: bool| {
            let view = if is_inverse { &inverse } else { &view };
            view.joints[equation.joint].number
        };
        for equation in candidates.into_iter().take(tried) {
            let joint = joint_of(&equation, equation.is_inverse);
            found.push(Found {
                joint: Some(joint),
                rule: equation.rule,
                coefficients: equation.coefficients,
            });
            let branches: usize = found.iter().map(|found| found.rule.solutions()).product();
            if branches <= MOST_BRANCHES && self.solve(found) {
                return true;
            }
            found.pop();
        }
        false
    }

    /// The equation of the joints that are not known, and its inverse; `None` if all are.
    fn views(&self, known: &BTreeSet<usize>) -> Option<[View<'g>; 2]> {
        let unknown: Vec<Unknown> = joints(&self.chain)
            .filter(|joint| !known.contains(&joint.number))
            .collect();
        if unknown.is_empty() {
            return None;
        }
        let (first, links, last) = between(&self.chain, known);
        let origin = Vector3::splat(self.graph.zero());
        let pose = Path(vec![self.pose]);
        let target = first.inverse().then(&pose).then(&last.inverse());
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

    /// The position that is reached is the one that was asked for.
    fn condition(&self) -> Found<'g> {
        let all: BTreeSet<usize> = joints(&self.chain).map(|joint| joint.number).collect();
        let (way, ..) = between(&self.chain, &all);
        let origin = Vector3::splat(self.graph.zero());
        let reached = way.point(origin);
        let asked = Path(vec![self.pose]).point(origin);
        let [x, y, z] = (reached - asked).0;
        Found {
            joint: None,
            rule: Rule::Condition,
            coefficients: vec![x, y, z, reached.dot(reached) + asked.dot(asked)],
        }
    }

    fn parts(found: &[Found<'g>]) -> (Vec<(Option<usize>, Rule)>, Vec<Edge>) {
        let steps = found.iter().map(|found| (found.joint, found.rule));
        let outputs = found.iter().flat_map(|found| &found.coefficients);
        (steps.collect(), outputs.map(|x| x.edge()).collect())
    }
}

/// The arm from the world to a frame. All joints that move must carry the frame.
fn chain<'g>(
    symbols: &mut Symbols<'g>,
    arm: &'g Mechanism,
    frame: Option<usize>,
) -> Result<Vec<Link<'g>>, Unsolved> {
    if arm.freedoms().has_base() {
        return Err(Unsolved::MovingBase);
    }
    let frame = arm.frame(frame);
    let mut carriers: Vec<usize> = arm.tree.carriers_of(frame.link).collect();
    carriers.sort_unstable();
    let others = (0..arm.joints.len()).filter(|i| !carriers.contains(i));
    if let Some(other) = others.map(|i| &arm.joints[i]).find(|joint| !joint.stands()) {
        return Err(Unsolved::OtherJoint(other.name.clone()));
    }
    let mut chain = Vec::new();
    if let Some(base) = place::base(symbols, arm) {
        let columns = units(symbols).map(|axis| base.leave(axis).0);
        chain.push(Link::Fixed(Matrix3(columns).transpose(), base.origin));
    }
    for &i in &carriers {
        let joint = &arm.joints[i];
        chain.push(fixed(symbols, &joint.aligned.before));
        joint_links(symbols, joint, i, &mut chain)?;
    }
    let behind = match frame.link {
        Some(link) => {
            let joint = &arm.joints[link];
            [&joint.aligned.own[..], &joint.link_frame, &frame.places].concat()
        }
        None => frame.places.clone(),
    };
    chain.push(fixed(symbols, &behind));
    Ok(chain)
}

/// The constant turn and step along a joint's axis, and its motion.
fn joint_links<'g>(
    symbols: &mut Symbols<'g>,
    joint: &Joint,
    i: usize,
    chain: &mut Vec<Link<'g>>,
) -> Result<(), Unsolved> {
    let graph = symbols.graph();
    let d = symbols.value(&joint.aligned.d);
    let turn = symbols.constant_turn(i);
    let variables = *symbols.joint(i);
    let joint_type = joint.joint_type;
    let turning = (joint_type == JointType::Revolute).then_some(variables.sin_cos);
    let motion = match turning {
        Some((s, c)) => Move::Turn(s, c),
        None => Move::Slide(variables.q),
    };
    let mut constant = Path(vec![Move::Turn(turn.s, turn.c), Move::Slide(d)]);
    let moving = match joint.law {
        Law::Free { number } => Some(Unknown { number, joint_type }),
        Law::Standing { .. } | Law::Base { .. } => {
            constant.0.push(motion);
            None
        }
        Law::Following { .. } => return Err(Unsolved::Follower(joint.name.clone())),
    };
    let columns = units(symbols).map(|axis| constant.direction(axis).0);
    let origin = constant.point(Vector3::splat(graph.zero()));
    chain.push(Link::Fixed(Matrix3(columns).transpose(), origin));
    chain.extend(moving.map(|unknown| Link::Joint(unknown, motion)));
    Ok(())
}

fn fixed<'g>(symbols: &mut Symbols<'g>, places: &[Placement]) -> Link<'g> {
    let place = place::place(symbols, places);
    let columns = units(symbols).map(|axis| place.turns.leave(axis).0);
    Link::Fixed(Matrix3(columns).transpose(), place.origin)
}

fn units<'g>(symbols: &Symbols<'g>) -> [Vector3<Expr<'g>>; 3] {
    let (zero, one) = (symbols.graph().zero(), symbols.graph().one());
    [[one, zero, zero], [zero, one, zero], [zero, zero, one]].map(Vector3)
}
