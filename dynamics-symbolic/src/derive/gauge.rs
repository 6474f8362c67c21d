//! The freedom in writing the equations: where frames are, what they turn
//! with, which of two equal parameters remains. The functions are the same
//! whatever is chosen; the number of operations is not.
//!
//! Frames that stay behind. A link's equations may be written in any orientation. If frame i keeps the orientation
//! that it has before joint i turns, the few constant parameters of the link turn instead of the many variable
//! vectors of motion and force. For parallel axes these frames are all alike and the angles add up: s23 and c23 come
//! from this, by four multiplications and two additions. Which frames stay is decided by counting, joint by joint and
//! in neighbouring pairs. On the arms on which all choices were tried the descent found the best one. It also chooses
//! where a frame's origin sits on its axis, which of J_xx and J_yy is kept or whether the link is a lamina, whether
//! columns of U are turned ([`crate::spatial::Writing`]), and about which point the moment of a wrench is computed:
//! outwards as far as axes pass through the point, inwards to the base.
//!
//! Searches have budgets (nodes of trial graphs, look-ups of values): long programs are searched less thoroughly. A
//! step that moves all origins at once is what a long chain can afford.

use std::collections::HashMap;

use super::chain::{Chain, Given};
use super::functions::{Part, outputs};
use super::symbols::Symbols;
use crate::exact::Rational;
use crate::expr::{Edge, Expr, Graph, Level, Operation};
use crate::function::{Function, Search};
use crate::mechanism::{Mechanism, Origin, Tree};
use crate::spatial::Keep;

/// One choice for every joint.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Gauge {
    /// Where the frame's origin is on the axis.
    pub origins: Vec<Origin>,
    /// Whether the frame stays behind its joint: see [`Chain::stay_behind`].
    pub stays: Vec<bool>,
    /// The moment of inertia that is kept.
    pub keep: Vec<Keep>,
    /// Whether U times the joint's axis is turned in place of the angular acceleration: see [`Chain::turn_columns`].
    pub turns_columns: Vec<bool>,
    /// Whether inertial parameters move inwards to the base parameters: see
    /// [`Chain::group_parameters`].
    pub grouped: bool,
    /// The joint about whose origin the moment of a wrench on a frame is taken: see [`Chain::pivot`].
    pub pivot: Option<usize>,
}

/// How many nodes of trial graphs one search may make for each function and each tip of the tree: the search of an arm
/// ends within a fraction of a second where the engine runs unoptimised.
const MOST_NODES: usize = 150_000;

impl Gauge {
    /// Origins at the next common normal, frames that turn with their links.
    pub fn plain(dof: usize) -> Self {
        Gauge {
            origins: vec![Origin::AfterOffset; dof],
            stays: vec![false; dof],
            keep: vec![Keep::Xx; dof],
            turns_columns: vec![false; dof],
            grouped: true,
            pivot: None,
        }
    }

    /// The plain gauge with every link's own parameters. Grouping moves a heavy payload to the links
    /// before it, where what is left of it is a difference of large numbers.
    pub fn physical(dof: usize) -> Self {
        Gauge {
            grouped: false,
            ..Gauge::plain(dof)
        }
    }

    /// The chain of a robot in this gauge.
    pub fn chain<'g>(&self, symbols: &mut Symbols<'g>) -> Chain<Expr<'g>> {
        let given = Given::new(symbols);
        self.chain_of(symbols, &given)
    }

    /// As [`Gauge::chain`], of a table that has been read.
    fn chain_of<'g>(&self, symbols: &Symbols<'g>, given: &Given<Expr<'g>>) -> Chain<Expr<'g>> {
        let mut chain = Chain::new(symbols, given, &self.origins);
        if self.grouped {
            let half = symbols
                .graph()
                .rational(&Rational::from_parts(1.into(), 2_u8.into()));
            chain.group_parameters(half, &self.keep);
        }
        chain.stay_behind(&self.stays);
        chain.turn_columns(&self.turns_columns);
        chain.pivot = self.pivot;
        chain
    }

    /// The gauge for the shortest program of some functions that a descent finds:
    /// single choices and neighbouring pairs are reversed for as long as the
    /// work of the operations falls.
    pub fn search(arm: &Mechanism, parts: &[Part]) -> Self {
        let dof = arm.joints.len();
        let mut gauge = Gauge::plain(dof);
        if let [part] = parts
            && part.function.row().search == Search::Accuracy
        {
            return Gauge::physical(dof);
        }
        let parts: Vec<Part> = parts.iter().filter_map(searched_by).collect();
        if parts.is_empty() {
            return gauge;
        }
        // No choice in one group changes the work of the operations of another one.
        for group in arm.groups() {
            // Joints of the base stand: nothing about them can be chosen.
            let moves = |i: &usize| !arm.joints[*i].is_of_base();
            let joints: Vec<_> = group.iter().copied().filter(moves).collect();
            gauge.search_group(&arm.only(&group), &parts, &joints);
        }
        gauge
    }

    /// The shorter of the gauges that descents from two starts find for a group of joints. From the first one, links as
    /// laminae and columns of U turned, functions that read accelerations of links are the shortest as a rule. The
    /// second one is plain; it is left out where the first descent ran out of nodes.
    fn search_group(&mut self, arm: &Mechanism, parts: &[Part], joints: &[usize]) {
        let graph = Graph::new();
        let mut trials = Trials::new(&graph, arm, parts);
        let columns = self.after(&columns(joints));
        let mut laminar = columns.clone();
        for &i in joints {
            laminar.keep[i] = Keep::Lamina;
        }
        let [plain, columns, lamina] = [&*self, &columns, &laminar].map(|g| trials.cost(g));
        if columns == plain && lamina >= plain {
            self.descend(&mut trials, joints, &[Keep::Xx, Keep::Yy]);
            return;
        }
        let keeps = [Keep::Xx, Keep::Yy, Keep::Lamina];
        let (of_laminar, has_ended) = laminar.descend(&mut trials, joints, &keeps);
        let is_shorter = has_ended && {
            let (cost, _) = self.descend(&mut trials, joints, &keeps);
            cost < of_laminar
        };
        if !is_shorter {
            *self = laminar;
        }
    }

    /// Reverses choices of a group of joints for as long as the work of the operations falls: the work in the end, and
    /// whether there was time for all steps.
    fn descend(
        &mut self,
        trials: &mut Trials<'_>,
        joints: &[usize],
        keeps: &[Keep],
    ) -> (usize, bool) {
        let tree = &trials.symbols.arm().tree;
        let tips = tree.tips().filter(|tip| joints.contains(tip)).count();
        let most = trials.nodes + MOST_NODES * trials.parts.len() * tips;
        let mut steps = steps(tree, joints, keeps);
        let has_pivot = |part: &Part| part.function == Function::WrenchTorques;
        if trials.parts.iter().any(has_pivot) {
            let pivots = joints.iter().map(|&joint| vec![Choice::Pivot(joint)]);
            steps.splice(0..0, pivots);
        }
        let mut cost = trials.cost(self);
        loop {
            let before = cost;
            for step in &steps {
                if trials.nodes > most {
                    return (cost, false);
                }
                let trial = self.after(step);
                let of_trial = trials.cost(&trial);
                if of_trial < cost {
                    (*self, cost) = (trial, of_trial);
                }
            }
            if cost == before {
                return (cost, true);
            }
        }
    }

    /// The work of some functions in this gauge, before any simplification.
    pub fn length(&self, arm: &Mechanism, parts: &[Part]) -> usize {
        Trials::new(&Graph::new(), arm, parts).cost(self)
    }

    /// The outputs of some functions in this gauge, one function after the other.
    pub fn outputs<'g>(&self, symbols: &mut Symbols<'g>, parts: &[Part]) -> Vec<Edge> {
        let chain = self.chain(symbols);
        outputs_of(symbols, &chain, parts)
    }

    /// The gauge with some choices made the other way.
    fn after(&self, step: &[Choice]) -> Self {
        let mut gauge = self.clone();
        for choice in step {
            match *choice {
                Choice::Origin(i) => {
                    gauge.origins[i] = match gauge.origins[i] {
                        Origin::AfterOffset => Origin::BeforeOffset,
                        Origin::BeforeOffset => Origin::AfterOffset,
                    }
                }
                Choice::Stay(i) => gauge.stays[i] = !gauge.stays[i],
                Choice::Keep(i, keep) => gauge.keep[i] = keep,
                Choice::Column(i) => gauge.turns_columns[i] = !gauge.turns_columns[i],
                Choice::Pivot(i) => gauge.pivot = Some(i),
            }
        }
        gauge
    }
}

/// The trials of a search. The last round of a descent comes back to gauges of the round before it: each
/// is tried once, and counted as often as it is requested.
struct Trials<'g> {
    graph: &'g Graph,
    symbols: Symbols<'g>,
    given: Given<Expr<'g>>,
    parts: &'g [Part],
    /// The work and the nodes of each gauge that was tried.
    known: HashMap<Gauge, (usize, usize)>,
    /// The nodes of all trial graphs.
    nodes: usize,
}

impl<'g> Trials<'g> {
    fn new(graph: &'g Graph, arm: &'g Mechanism, parts: &'g [Part]) -> Self {
        let mut symbols = Symbols::new(graph, arm);
        Trials {
            graph,
            given: Given::new(&mut symbols),
            symbols,
            parts,
            known: HashMap::new(),
            nodes: 0,
        }
    }

    /// The work of the functions in a gauge.
    fn cost(&mut self, gauge: &Gauge) -> usize {
        let known = self.known.get(gauge).copied();
        let (work, nodes) = known.unwrap_or_else(|| {
            let trial = self.graph.trying(|| self.tried(gauge));
            self.known.insert(gauge.clone(), trial);
            trial
        });
        self.nodes += nodes;
        work
    }

    /// The work before any simplification, and the nodes of the trial graph.
    fn tried(&self, gauge: &Gauge) -> (usize, usize) {
        let mut symbols = self.symbols.clone();
        let chain = gauge.chain_of(&symbols, &self.given);
        let outputs = outputs_of(&mut symbols, &chain, self.parts);
        (work(self.graph, &outputs), self.graph.len())
    }
}

/// The work of the operations that some outputs take: two for an addition, which may be fused with a product, and
/// three for a multiplication or a division.
fn work(graph: &Graph, outputs: &[Edge]) -> usize {
    let mut is_counted = vec![false; graph.len()];
    let mut stack: Vec<_> = outputs.iter().map(|output| output.node()).collect();
    let mut work = 0;
    while let Some(id) = stack.pop() {
        if core::mem::replace(&mut is_counted[id.index()], true)
            || graph.level_of(id) == Level::Constant
        {
            continue;
        }
        let operation = graph.operation(id);
        work += match operation {
            Operation::Add(..) => 2,
            Operation::Mul(..) | Operation::Div(..) => 3,
            Operation::Rational(_) | Operation::Symbol(_) => 0,
        };
        stack.extend(operation.operands());
    }
    work
}

/// The outputs of some functions on a chain, one function after the other.
fn outputs_of<'g>(symbols: &mut Symbols<'g>, chain: &Chain<Expr<'g>>, parts: &[Part]) -> Vec<Edge> {
    let of_part = |part: &Part| outputs(symbols, chain, *part);
    let outputs = parts.iter().flat_map(of_part);
    outputs.map(|e| e.edge()).collect()
}

/// The part whose operations the search counts for a function; `None` if no gauge matters.
fn searched_by(part: &Part) -> Option<Part> {
    match part.function.row().search {
        Search::Own | Search::Accuracy => Some(*part),
        Search::By(function) => Some(Part::recursive(function)),
        Search::None => None,
    }
}

/// A choice made another way.
#[derive(Clone, Copy, Debug)]
enum Choice {
    Origin(usize),
    Stay(usize),
    Keep(usize, Keep),
    Column(usize),
    Pivot(usize),
}

/// The step that turns columns of U at all joints, or none of them any more: nothing is gained joint by joint.
fn columns(joints: &[usize]) -> Vec<Choice> {
    joints.iter().copied().map(Choice::Column).collect()
}

/// The steps of one round of the descent, the most promising first; neighbours are a joint and the one that carries
/// it. Where all origins move at once, a long chain takes the step for which its nodes would not suffice one by one.
fn steps(tree: &Tree, joints: &[usize], keeps: &[Keep]) -> Vec<Vec<Choice>> {
    use Choice::{Origin, Stay};
    let outward = || joints.iter().copied();
    let single = outward()
        .rev()
        .map(|i| vec![Stay(i)])
        .chain(outward().map(|i| vec![Origin(i)]));
    let carried = outward().rev().filter_map(|i| Some((tree.parent(i)?, i)));
    let pairs = carried.flat_map(|(carrier, i)| {
        [
            vec![Stay(carrier), Stay(i)],
            vec![Origin(carrier), Origin(i)],
        ]
    });
    let mixed = outward().map(|i| vec![Stay(i), Origin(i)]);
    let keep = |i| keeps.iter().map(move |keep| vec![Choice::Keep(i, *keep)]);
    let all = core::iter::once(outward().map(Origin).collect());
    all.chain(single)
        .chain(pairs)
        .chain(mixed)
        .chain(outward().flat_map(keep))
        .chain([columns(joints)])
        .collect()
}
