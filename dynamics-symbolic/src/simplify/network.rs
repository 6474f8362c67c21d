//! The part of a graph that a program computes, with one definition for each node.

use crate::expr::{Edge, Fingerprint, Graph, Level, NodeId, Operation};
use crate::program::Program;
use crate::robot::Symbol;
use core::cell::Cell;

/// The nodes that the outputs need, and the definition of each.
pub struct Network<'g> {
    graph: &'g Graph,
    outputs: Vec<Edge>,
    /// The definition of each node; meaningful where the node is active or constant.
    definitions: Vec<Operation>,
    values: Vec<Fingerprint>,
    /// Inverses of values, found when they are requested: most never are.
    inverses: Vec<Cell<Option<Option<Fingerprint>>>>,
    free: Vec<bool>,
    /// Whether the definition of each node is held: see [`Graph::holding`].
    held: Vec<bool>,
    /// How many active nodes and outputs read each node: active where positive.
    readers: Vec<u32>,
    cost: usize,
}

impl<'g> Network<'g> {
    /// The network of some outputs, every node by the graph's own operation.
    pub fn new(graph: &'g Graph, outputs: &[Edge]) -> Self {
        let mut network = Network {
            graph,
            outputs: outputs.to_vec(),
            definitions: Vec::new(),
            values: Vec::new(),
            inverses: Vec::new(),
            free: Vec::new(),
            held: Vec::new(),
            readers: Vec::new(),
            cost: 0,
        };
        network.grow();
        for output in outputs {
            network.activate(output.node());
        }
        network
    }

    /// The network of some outputs with the definitions that are given, the
    /// first of each node, and else the graph's own; those of `held` are held.
    pub(super) fn with_definitions(
        graph: &'g Graph,
        outputs: &[Edge],
        definitions: Vec<(NodeId, Operation)>,
        held: &[NodeId],
    ) -> Self {
        let mut network = Network::new(graph, &[]);
        for &id in held {
            network.held[id.index()] = !network.is_free(id);
        }
        for (id, operation) in definitions.into_iter().rev() {
            // A sum may come out equal to a symbol or a constant, which need no definition.
            if !network.is_free(id) {
                network.definitions[id.index()] = operation;
            }
        }
        network.outputs = outputs.to_vec();
        for output in outputs {
            network.activate(output.node());
        }
        network
    }

    /// For each group of outputs that have no variable in common with others the network of these alone: the others are
    /// zero there.
    pub(super) fn apart(&self) -> Vec<Network<'g>> {
        let mut groups: Vec<usize> = (0..self.len()).collect();
        for id in self.order() {
            let is_variable = |&id: &NodeId| self.graph.level_of(id) == Level::Variable;
            for operand in self.definition(id).operands().filter(is_variable) {
                let (a, b) = (
                    group_of(&groups, id.index()),
                    group_of(&groups, operand.index()),
                );
                groups[a.max(b)] = a.min(b);
            }
        }
        let group = |output: &Edge| group_of(&groups, output.node().index());
        let computed = self.outputs.iter().filter(|e| !self.is_free(e.node()));
        let mut present: Vec<usize> = computed.map(group).collect();
        present.sort_unstable();
        present.dedup();
        let of_group = |number: usize| {
            let zero = NodeId::ZERO.edge(false);
            let kept = |output: &Edge| {
                if group(output) == number {
                    *output
                } else {
                    zero
                }
            };
            let outputs: Vec<_> = self.outputs.iter().map(kept).collect();
            Network::new(self.graph, &outputs)
        };
        present.into_iter().map(of_group).collect()
    }

    /// Takes the definitions of some networks, for each node those of the first one in which it is active.
    pub(super) fn join(&mut self, parts: &[Network<'g>]) {
        let of_part = |part: &Network<'g>| -> Vec<_> {
            let order = part.order().into_iter();
            order.map(|id| (id, part.definition(id))).collect()
        };
        let definitions = parts.iter().flat_map(of_part).collect();
        *self = Network::with_definitions(self.graph, &self.outputs, definitions, &[]);
    }

    /// The program of the network; `meanings` is what the graph's symbols stand for.
    pub fn program(&self, meanings: &[Symbol]) -> Program {
        Program::new(self.graph, meanings, &self.outputs, &|id| {
            self.definition(id)
        })
    }

    /// How many nodes and outputs read a node.
    pub(super) fn readers(&self, id: NodeId) -> u32 {
        self.readers[id.index()]
    }

    /// Takes note of nodes that are new in the graph.
    pub(super) fn grow(&mut self) {
        for index in self.definitions.len()..self.graph.len() {
            let node = self.graph.node(NodeId::from_index(index));
            let is_leaf = node.operation.operands().next().is_none();
            self.definitions.push(node.operation);
            self.values.push(node.value);
            self.inverses.push(Cell::new(None));
            let is_free = is_leaf || node.level == Level::Constant;
            self.free.push(is_free);
            // Constants are exact: there is nothing to hold.
            self.held.push(node.held && !is_free);
            self.readers.push(0);
        }
    }

    pub(super) fn graph(&self) -> &'g Graph {
        self.graph
    }

    /// The operations that the program takes.
    pub fn cost(&self) -> usize {
        self.cost
    }

    /// The definition of a node.
    pub fn definition(&self, id: NodeId) -> Operation {
        self.definitions[id.index()]
    }

    /// The outputs.
    pub fn outputs(&self) -> &[Edge] {
        &self.outputs
    }

    pub(super) fn value(&self, id: NodeId) -> Fingerprint {
        self.values[id.index()]
    }

    pub(super) fn inverse(&self, id: NodeId) -> Option<Fingerprint> {
        let known = &self.inverses[id.index()];
        known.get().unwrap_or_else(|| {
            let inverse = self.value(id).inverse();
            known.set(Some(inverse));
            inverse
        })
    }

    /// Whether a node takes no operation: a symbol or a constant.
    pub(super) fn is_free(&self, id: NodeId) -> bool {
        self.free[id.index()]
    }

    pub(super) fn is_constant(&self, id: NodeId) -> bool {
        self.graph.level_of(id) == Level::Constant
    }

    pub(super) fn is_active(&self, id: NodeId) -> bool {
        self.readers[id.index()] > 0
    }

    /// One more reader of a node.
    pub(super) fn activate(&mut self, root: NodeId) {
        let mut stack = vec![root];
        while let Some(id) = stack.pop() {
            self.readers[id.index()] += 1;
            if self.readers[id.index()] == 1 && !self.free[id.index()] {
                self.cost += 1;
                stack.extend(self.definitions[id.index()].operands());
            }
        }
    }

    /// One reader of a node less.
    fn release(&mut self, root: NodeId) {
        let mut stack = vec![root];
        while let Some(id) = stack.pop() {
            self.readers[id.index()] -= 1;
            if self.readers[id.index()] == 0 && !self.free[id.index()] {
                self.cost -= 1;
                stack.extend(self.definitions[id.index()].operands());
            }
        }
    }

    /// Gives an active node another definition.
    pub(super) fn redefine(&mut self, id: NodeId, operation: Operation) {
        let old = std::mem::replace(&mut self.definitions[id.index()], operation);
        for operand in operation.operands() {
            self.activate(operand);
        }
        for operand in old.operands() {
            self.release(operand);
        }
    }

    /// Defines a node that is not active.
    pub(super) fn define_inactive(&mut self, id: NodeId, operation: Operation) {
        debug_assert!(!self.is_active(id));
        self.definitions[id.index()] = operation;
    }

    /// How many operations only this node needs, itself included.
    pub(super) fn cone(&mut self, id: NodeId) -> usize {
        let before = self.cost;
        let operands: Vec<_> = self.definition(id).operands().collect();
        for &operand in &operands {
            self.release(operand);
        }
        let cone = before - self.cost + 1;
        for &operand in &operands {
            self.activate(operand);
        }
        cone
    }

    /// Active nodes that take an operation, operands before readers.
    pub(super) fn order(&self) -> Vec<NodeId> {
        let mut order = Vec::with_capacity(self.cost);
        let mut done = vec![false; self.definitions.len()];
        let outputs = self.outputs.iter().rev();
        let mut stack: Vec<_> = outputs.map(|edge| (edge.node(), false)).collect();
        while let Some((id, operands_done)) = stack.pop() {
            if done[id.index()] || self.free[id.index()] {
                continue;
            }
            if operands_done {
                done[id.index()] = true;
                order.push(id);
            } else {
                stack.push((id, true));
                stack.extend(self.definition(id).operands().map(|id| (id, false)));
            }
        }
        order
    }

    /// Whether the definition of a node is held.
    pub(super) fn is_held(&self, id: NodeId) -> bool {
        self.held[id.index()]
    }

    /// Whether each node is held, or reads one that is; `order` is [`Network::order`].
    pub(super) fn fixed(&self, order: &[NodeId]) -> Vec<bool> {
        let mut fixed = self.held.clone();
        for &id in order {
            let mut operands = self.definition(id).operands();
            fixed[id.index()] |= operands.any(|operand| fixed[operand.index()]);
        }
        fixed
    }

    /// Active nodes that are free.
    pub(super) fn leaves(&self) -> Vec<NodeId> {
        let nodes = (0..self.len()).map(NodeId::from_index);
        let leaves = nodes.filter(|&id| self.is_free(id) && self.is_active(id));
        leaves.collect()
    }

    /// How many nodes the graph has.
    pub(super) fn len(&self) -> usize {
        self.definitions.len()
    }
}

/// The group of a node: the first of the nodes that it is connected with.
fn group_of(groups: &[usize], mut node: usize) -> usize {
    while groups[node] != node {
        node = groups[node];
    }
    node
}
