//! The freedom in writing the equations: where frames are, what they turn
//! with, which of two equal parameters remains. The functions are the same
//! whatever is chosen; the number of operations is not.
//!
//! Frames that stay behind. A link's equations may be written in any orientation. If frame i keeps the orientation
//! that it has before joint i turns, the few constant parameters of the link turn instead of the many variable
//! vectors of motion and force. For parallel axes these frames are all alike and the angles add up: s23 and c23 come
//! from this, by four multiplications and two additions. Which frames stay is decided by counting, joint by joint and
//! in neighbouring pairs. On the arms on which all choices were tried the descent found the best one. It also chooses
//! where a frame's origin sits on its axis, which of J_xx and J_yy is kept, and about which point the moment of a
//! wrench is computed: outwards as far as axes pass through the point, inwards to the base.
//!
//! Searches have budgets (nodes of trial graphs, look-ups of values): long programs are searched less thoroughly. A
//! step that moves all origins at once is what a long chain can afford.

use std::collections::HashMap;

use super::chain::{Chain, Given};
use super::functions::{Part, outputs};
use super::symbols::Symbols;
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
    /// Whether inertial parameters move inwards to the base parameters: see
    /// [`Chain::group_parameters`].
    pub grouped: bool,
    /// The joint about whose origin the moment of a wrench on a frame is taken: see [`Chain::pivot`].
    pub pivot: Option<usize>,
}

/// How many nodes of trial graphs one search may make for each function and each tip of the tree: the search of an arm
/// ends within a fraction of a second where the engine runs unoptimised.
const MOST_NODES: usize = 100_000;

impl Gauge {
    /// Origins at the next common normal, frames that turn with their links.
    pub fn plain(dof: usize) -> Self {
        Gauge {
            origins: vec![Origin::AfterOffset; dof],
            stays: vec![false; dof],
            keep: vec![Keep::Xx; dof],
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
            chain.group_parameters(&self.keep);
        }
        chain.stay_behind(&self.stays);
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
            gauge.descend(&arm.only(&group), &parts, &joints);
        }
        gauge
    }

    /// Reverses choices of a group of joints for as long as the work of the operations falls.
    fn descend(&mut self, arm: &Mechanism, parts: &[Part], joints: &[usize]) {
        let tips = arm.tree.tips().filter(|tip| joints.contains(tip)).count();
        let most = MOST_NODES * parts.len() * tips;
        let graph = Graph::new();
        let mut trials = Trials::new(&graph, arm, parts);
        let mut cost = trials.cost(self);
        let has_pivot = |part: &Part| part.function == Function::WrenchTorques;
        let pivots = if parts.iter().any(has_pivot) {
            joints.len()
        } else {
            0
        };
        loop {
            let before = cost;
            for &pivot in &joints[..pivots] {
                let known = self.pivot.replace(pivot);
                let trial = trials.cost(self);
                if trial < cost {
                    cost = trial;
                } else {
                    self.pivot = known;
                }
            }
            for step in steps(&arm.tree, joints) {
                if trials.nodes > most {
                    return;
                }
                self.reverse(&step);
                let trial = trials.cost(self);
                if trial < cost {
                    cost = trial;
                } else {
                    self.reverse(&step);
                }
            }
            if cost == before {
                return;
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

    fn reverse(&mut self, step: &[Choice]) {
        for choice in step {
            match *choice {
                Choice::Origin(i) => {
                    self.origins[i] = match self.origins[i] {
                        Origin::AfterOffset => Origin::BeforeOffset,
                        Origin::BeforeOffset => Origin::AfterOffset,
                    }
                }
                Choice::Stay(i) => self.stays[i] = !self.stays[i],
                Choice::Keep(i) => {
                    self.keep[i] = match self.keep[i] {
                        Keep::Xx => Keep::Yy,
                        Keep::Yy => Keep::Xx,
                    }
                }
            }
        }
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

/// A choice that can be reversed.
#[derive(Clone, Copy, Debug)]
enum Choice {
    Origin(usize),
    Stay(usize),
    Keep(usize),
}

/// The steps of one round of the descent, the most promising first; neighbours are a joint and the one that carries
/// it. Where all origins move at once, a long chain takes the step for which its nodes would not suffice one by one.
fn steps(tree: &Tree, joints: &[usize]) -> Vec<Vec<Choice>> {
    use Choice::{Keep, Origin, Stay};
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
    let keep = outward().map(|i| vec![Keep(i)]);
    let all = core::iter::once(outward().map(Origin).collect());
    all.chain(single)
        .chain(pairs)
        .chain(mixed)
        .chain(keep)
        .collect()
}
