//! Whether a definition keeps the digits.
//!
//! Definitions that are equal as rational functions are not equal in doubles: a sum may cancel terms that the present
//! definition never adds. So bounds on the errors of the outputs, at some points ([`Running`]), decide.
//!
//! Operations are not all that is counted: the prime field knows 1/cos(1.5708) = 272241.8 as a number like any other.
//! With PI/2 typed as 1.5708, one program in a hundred multiplied by such a number and subtracted what it had added,
//! and lost up to six digits.
//!
//! Errors are compared with those of the plain recursion (the plain gauge, nothing simplified), which are the natural
//! scale of each output. Outputs of one row of a matrix whose columns have the same unit are measured by the largest
//! among them (`derive::units`), and two states of a pair by the worse one. Rows of different joints are never
//! compared. At four states, two of them with unlucky values of the fields, no redefinition may lead an output beyond
//! 8 times that error. One that raises no error of its own node passes at once. A network with other multiples is
//! judged as a whole, and multiples stay between 2^-30 and 2^30: multiples of multiples came to 1e266.

use super::Network;
use super::survey::Survey;
use crate::expr::NodeId;
use crate::rounding::{POINTS, Running};

/// The errors of a network's nodes, and those that its outputs may have.
pub struct Judge<'g> {
    running: Running<'g>,
    /// By output.
    allowed: Vec<[f64; POINTS]>,
}

impl<'g> Judge<'g> {
    /// Allows the outputs of a network the errors that are given, and at least those that they have.
    pub fn new(
        network: &Network<'g>,
        mut running: Running<'g>,
        mut allowed: Vec<[f64; POINTS]>,
    ) -> Self {
        for (output, allowed) in network.outputs().iter().zip(&mut allowed) {
            for (present, allowed) in running.node(output.node()).iter().zip(allowed) {
                *allowed = allowed.max(present.error);
            }
        }
        Judge { running, allowed }
    }

    /// About what a constant is.
    pub(super) fn constant(&mut self, id: NodeId) -> f64 {
        self.running.constant(id)
    }

    /// Whether the outputs keep within what is allowed now that the last of some nodes has another definition, which
    /// reads the others, new ones. The survey is that before. A change that is not accepted has to be taken back.
    pub(super) fn accepts(
        &mut self,
        network: &Network<'_>,
        survey: &Survey,
        redefined: &[NodeId],
    ) -> bool {
        let mut old = Vec::new();
        let mut last = ([0.0; POINTS], [0.0; POINTS]);
        for &id in redefined {
            let new = self.running.errors(network.definition(id));
            last = (self.running.set_errors(id, new), new);
            old.push((id, last.0));
        }
        if is_within(&last.1, &last.0) {
            return true;
        }
        let Some(&id) = redefined.last() else {
            return true;
        };
        let mut is_changed = vec![false; network.len()];
        is_changed[id.index()] = true;
        for &reader in survey.readers_after(id) {
            let operation = network.definition(reader);
            let mut operands = operation.operands();
            if operands.any(|operand| is_changed[operand.index()]) {
                let new = self.running.errors(operation);
                old.push((reader, self.running.set_errors(reader, new)));
                is_changed[reader.index()] = true;
            }
        }
        let accepted = self.allows(network, |id| is_changed[id.index()]);
        if !accepted {
            for (id, errors) in old.into_iter().rev() {
                self.running.set_errors(id, errors);
            }
        }
        accepted
    }

    /// Whether a network may take the place of another one.
    pub(super) fn accepts_all(&mut self, network: &Network<'_>, present: &Network<'_>) -> bool {
        self.evaluate(network);
        let accepted = self.allows(network, |_| true);
        if !accepted {
            self.evaluate(present);
        }
        accepted
    }

    /// Takes the errors of all nodes from their definitions.
    fn evaluate(&mut self, network: &Network<'_>) {
        for id in network.order() {
            let errors = self.running.errors(network.definition(id));
            self.running.set_errors(id, errors);
        }
    }

    /// Whether the errors of those outputs that are looked at are allowed.
    fn allows(&mut self, network: &Network<'_>, is_looked_at: impl Fn(NodeId) -> bool) -> bool {
        let mut outputs = network.outputs().iter().zip(&self.allowed);
        let running = &mut self.running;
        outputs.all(|(output, allowed)| {
            let id = output.node();
            !is_looked_at(id) || is_within(&running.node(id).map(|x| x.error), allowed)
        })
    }
}

fn is_within(errors: &[f64; POINTS], allowed: &[f64; POINTS]) -> bool {
    let mut errors = errors.iter().zip(allowed);
    errors.all(|(error, allowed)| error <= allowed)
}
