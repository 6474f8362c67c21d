//! Reverse mode: derivatives times a weight for each force, by calls of the functions that have the whole blocks.
//!
//! With weights l, adj_x = (d tau / d x)^T l, and d adj_x / d y is the sum of l_i d^2 tau_i / (d x d y). CasADi would multiply
//! by the same blocks, as matrices of its own.

use super::blocks::Blocks;
use super::interface::{Input, Output};

/// A function by its statements.
pub(super) struct Adjoint {
    pub(super) inputs: Vec<Input>,
    pub(super) outputs: Vec<Output>,
    pub(super) statements: Vec<String>,
    /// The entries of the blocks, for which CasADi has room.
    pub(super) room: usize,
}

/// `adj1_f` of a function `f` with these blocks of first derivatives.
pub(super) fn adjoint(name: &str, blocks: &Blocks, first: &[Output]) -> Adjoint {
    let mut adjoint = Adjoint::new(blocks.inputs_of_adjoint());
    adjoint.call(&format!("jac_{name}"), "first", first);
    adjoint.outputs = blocks.adjoint(first);
    adjoint
}

/// `jac_adj1_f`.
pub(super) fn derivatives(
    name: &str,
    blocks: &Blocks,
    first: &[Output],
    second: &[Output],
) -> Adjoint {
    let mut adjoint = Adjoint::new(blocks.inputs_of_derived_adjoint());
    adjoint.call(&format!("jac_{name}"), "first", first);
    adjoint.call(&format!("jac_jac_{name}"), "second", second);
    adjoint.outputs = blocks.derived_adjoint(first, second);
    adjoint
}

impl Adjoint {
    fn new(inputs: Vec<Input>) -> Self {
        Adjoint {
            inputs,
            outputs: Vec::new(),
            statements: Vec::new(),
            room: 0,
        }
    }

    /// Puts the outputs of a function, whose inputs are the first ones here, behind each other.
    fn call(&mut self, function: &str, places: &str, outputs: &[Output]) {
        let mut pointers = Vec::new();
        for output in outputs {
            let count = output.entries().flatten().count();
            if count == 0 {
                pointers.push("0");
                continue;
            }
            let name = &output.name;
            self.statements
                .push(format!("double *{name} = w + {};", self.room));
            self.room += count;
            pointers.push(name);
        }
        let pointers = pointers.join(", ");
        self.statements.extend([
            format!("double *{places}[] = {{{pointers}}};"),
            format!("if ({function}(arg, {places}, iw, w, mem)) return 1;"),
        ]);
    }
}
