//! Calls of functions whose outputs are put one behind the other, for sums of products of their entries.

use super::interface::Output;

/// Calls, as statements.
#[derive(Default)]
pub(super) struct Calls {
    pub(super) statements: Vec<String>,
    /// The entries of the outputs, for which CasADi has room.
    pub(super) room: usize,
}

impl Calls {
    /// Whether an array of that name is there.
    pub(super) fn has(&self, name: &str) -> bool {
        let start = format!("double *{name} = ");
        self.statements.iter().any(|line| line.starts_with(&start))
    }

    /// Adds the call of a function, whose inputs are the first ones of the caller. Each output is an array of its name.
    pub(super) fn add(mut self, function: &str, outputs: &[Output]) -> Self {
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
            format!("double *{function}_places[] = {{{pointers}}};"),
            format!("if ({function}(arg, {function}_places, iw, w, mem)) return 1;"),
        ]);
        self
    }
}
