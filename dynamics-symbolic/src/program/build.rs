//! From expressions on a graph to a program.

use super::{Constant, ConstantId, ConstantPool, Instruction, Operand, Program, UpToSign};
use crate::expr::{Edge, Graph, Level, NodeId, Operation};
use crate::robot::Symbol;

struct Builder<'g> {
    graph: &'g Graph,
    meanings: &'g [Symbol],
    /// The operation by which a node is computed: its own, or an equal one.
    definition: &'g dyn Fn(NodeId) -> Operation,
    /// How a node of the graph appears in the program.
    places: Vec<Option<UpToSign>>,
    constants: Vec<Option<ConstantId>>,
    preferred_negative: Vec<bool>,
    program: Program,
}

impl Program {
    /// The program that computes `outputs`, each node by the operation that `definition` gives.
    pub fn new(
        graph: &Graph,
        meanings: &[Symbol],
        outputs: &[Edge],
        definition: &dyn Fn(NodeId) -> Operation,
    ) -> Program {
        let mut builder = Builder {
            graph,
            meanings,
            definition,
            places: vec![None; graph.len()],
            constants: vec![None; graph.len()],
            preferred_negative: vec![false; graph.len()],
            program: Program {
                inputs: Vec::new(),
                constants: ConstantPool::default(),
                instructions: Vec::new(),
                outputs: Vec::new(),
                is_plain: false,
            },
        };
        for output in outputs.iter().rev() {
            builder.preferred_negative[output.node().index()] = output.is_negative();
        }
        for &output in outputs {
            let output = builder.output(output);
            builder.program.outputs.push(output);
        }
        builder.program
    }
}

impl Builder<'_> {
    fn output(&mut self, edge: Edge) -> UpToSign {
        if self.graph.level_of(edge.node()) == Level::Constant {
            return UpToSign::positive(self.constant_operand(edge));
        }
        self.place(edge.node()).negate_if(edge.is_negative())
    }

    /// Places a node and all that it needs; on an explicit stack, for chains are long.
    fn place(&mut self, root: NodeId) -> UpToSign {
        let mut stack = vec![(root, false)];
        while let Some((id, operands_placed)) = stack.pop() {
            assert!(
                stack.len() <= 3 * self.graph.len(),
                "the definitions of a program form a cycle"
            );
            if self.places[id.index()].is_some() || self.graph.level_of(id) == Level::Constant {
                continue;
            }
            let operation = (self.definition)(id);
            if operands_placed {
                let place = self.emit(id, operation);
                self.places[id.index()] = Some(place);
            } else {
                stack.push((id, true));
                let end = stack.len();
                stack.extend(operation.operands().map(|id| (id, false)));
                stack[end..].reverse();
            }
        }
        self.places[root.index()].expect("the root was placed")
    }

    fn emit(&mut self, id: NodeId, operation: Operation) -> UpToSign {
        match operation {
            Operation::Rational(_) => unreachable!("numbers are constants"),
            Operation::Symbol(index) => {
                let inputs = &mut self.program.inputs;
                inputs.push(self.meanings[index as usize].clone());
                UpToSign::positive(Operand::Input(inputs.len() as u32 - 1))
            }
            Operation::Add(a, b) => {
                let (a, b) = (self.read(a), self.read(b));
                self.push(UpToSign::sum(a, b, self.preferred_negative[id.index()]))
            }
            Operation::Mul(a, b) => self.emit_product(id, a, b),
            Operation::Div(a, b) => {
                let (a, b) = (self.read(a.edge(false)), self.read(b.edge(false)));
                let flipped = self.graph.is_flipped(id, operation);
                self.push(UpToSign::quotient(a, b)).negate_if(flipped)
            }
        }
    }

    fn push(&mut self, (instruction, negative): (Instruction, bool)) -> UpToSign {
        self.program.instructions.push(instruction);
        UpToSign {
            operand: Operand::Result(self.program.instructions.len() as u32 - 1),
            negative,
        }
    }

    /// The operand of an edge, and whether it must still be negated.
    fn read(&mut self, edge: Edge) -> UpToSign {
        if self.graph.level_of(edge.node()) == Level::Constant {
            // A positive literal, its sign in the instruction.
            let negative = self.is_negative_constant(edge);
            return UpToSign {
                operand: self.constant_operand(edge.negate_if(negative)),
                negative,
            };
        }
        let place = self.places[edge.node().index()].expect("operands are placed first");
        place.negate_if(edge.is_negative())
    }

    fn emit_product(&mut self, id: NodeId, a: NodeId, b: NodeId) -> UpToSign {
        let flipped = self.graph.is_flipped(id, Operation::Mul(a, b));
        let (mut a, mut b) = (self.read(a.edge(false)), self.read(b.edge(false)));
        if matches!(b.operand, Operand::Constant(_)) {
            (a, b) = (b, a);
        }
        let (_, negative) = UpToSign::product(a, b);
        if let Operand::Constant(constant) = a.operand
            && (negative != flipped) != self.preferred_negative[id.index()]
            && self.preferred_negative[id.index()]
        {
            a = UpToSign {
                operand: Operand::Constant(self.negate_if(constant, true)),
                negative: !a.negative,
            };
        }
        self.push(UpToSign::product(a, b)).negate_if(flipped)
    }

    fn constant_operand(&mut self, edge: Edge) -> Operand {
        let id = self.constant(edge.node());
        Operand::Constant(self.negate_if(id, edge.is_negative()))
    }

    /// The constant, or minus the constant where `negate` holds.
    fn negate_if(&mut self, id: ConstantId, negate: bool) -> ConstantId {
        if !negate {
            return id;
        }
        match self.program.constants.get(id).clone() {
            Constant::Neg(inner) => inner,
            Constant::Rational(x) => self.program.constants.push(Constant::Rational(-x)),
            _ => self.program.constants.push(Constant::Neg(id)),
        }
    }

    /// The pool's entry of a constant node.
    fn constant(&mut self, root: NodeId) -> ConstantId {
        self.graph.visit_operands_first(
            self,
            root,
            |this, id| this.constants[id.index()].is_some(),
            |this, id, operation| {
                this.constants[id.index()] = Some(this.define_constant(id, operation));
            },
        );
        self.known(root)
    }

    /// The node as a constant: its operation, negated where that is minus the node.
    fn define_constant(&mut self, id: NodeId, operation: Operation) -> ConstantId {
        let constant = match operation {
            Operation::Rational(index) => Constant::Rational(self.graph.rational_of(index)),
            Operation::Symbol(index) => Constant::Symbol(self.meanings[index as usize].clone()),
            Operation::Add(a, b) => {
                let [a, b] =
                    [a, b].map(|edge| self.negate_if(self.known(edge.node()), edge.is_negative()));
                Constant::Add(a, b)
            }
            Operation::Mul(a, b) => Constant::Mul(self.known(a), self.known(b)),
            Operation::Div(a, b) => Constant::Div(self.known(a), self.known(b)),
        };
        let constant = self.program.constants.push(constant);
        self.negate_if(constant, self.graph.is_flipped(id, operation))
    }

    /// The entry of a constant that was defined before.
    fn known(&self, id: NodeId) -> ConstantId {
        self.constants[id.index()].expect("operands come first")
    }

    /// Whether a rational constant is negative; other constants keep the sign that they have.
    fn is_negative_constant(&self, edge: Edge) -> bool {
        match self.graph.operation(edge.node()) {
            Operation::Rational(index) => {
                let positive = self.graph.rational_of(index).sign() == dashu_int::Sign::Positive;
                positive == edge.is_negative()
            }
            _ => edge.is_negative(),
        }
    }
}
