//! A long program as functions inside of its method, of some hundred results each.
//!
//! The memory and the time of the compiler's borrow checker grow with the square of a function's length: it keeps a set
//! of all variables for each operation, which may end in a panic of a user's scalar. 115,000 results in one function
//! took 6.7 GB, 75 s of 98 s; in parts 1.0 GB, 15 s of 33 s.

use std::collections::BTreeSet;

use proc_macro2::TokenStream;
use quote::quote;

use super::body::Writer;
use super::inputs::constants_like;
use super::names::ident;
use crate::program::Operand;

/// The results of one part: so many may be declared by a `let` each.
const PART: usize = 500;

impl Writer<'_> {
    /// The functions that make up the program and their calls. Each reads what it needs of inputs and
    /// earlier results from an array, and returns what is read later.
    pub(super) fn parts(&self, results: &[usize], path: &TokenStream) -> TokenStream {
        let parts: Vec<&[usize]> = results.chunks(PART).collect();
        let reads: Vec<BTreeSet<Operand>> =
            parts.iter().map(|part| self.reads_of_part(part)).collect();
        let mut later = BTreeSet::new();
        for output in &self.program.outputs {
            self.reads_of(output.operand, &mut later);
        }
        let mut tokens = Vec::new();
        for (number, (part, reads)) in parts.iter().zip(&reads).enumerate().rev() {
            let mut returned = part.to_vec();
            returned.retain(|i| later.contains(&Operand::Result(*i as u32)));
            tokens.push(self.part(number + 1, part, reads, &returned, path));
            later.extend(reads);
        }
        tokens.into_iter().rev().collect()
    }

    fn part(
        &self,
        number: usize,
        results: &[usize],
        reads: &BTreeSet<Operand>,
        returned: &[usize],
        path: &TokenStream,
    ) -> TokenStream {
        let name = ident(&format!("part_{number}"));
        let arguments: Vec<_> = reads.iter().map(|read| self.operand(*read)).collect();
        let values: Vec<_> = returned.iter().map(|i| &self.names[*i]).collect();
        let (m, n) = (arguments.len(), values.len());
        let real = arguments.first().map(|like| constants_like(like, path));
        let assignments = self.lets(results);
        quote! {
            #[inline(always)]
            fn #name<T: #path::Scalar>([#(#arguments),*]: [T; #m]) -> [T; #n] {
                #real
                #assignments
                [#(#values),*]
            }
            let [#(#values),*] = #name([#(#arguments),*]);
        }
    }

    /// The inputs, and the results of earlier parts, that a part reads.
    fn reads_of_part(&self, part: &[usize]) -> BTreeSet<Operand> {
        let mut reads = BTreeSet::new();
        for index in part {
            self.add_reads(*index, &mut reads);
        }
        for index in part {
            reads.remove(&Operand::Result(*index as u32));
        }
        reads
    }

    /// The variables that stand in the text of an operand.
    fn reads_of(&self, operand: Operand, reads: &mut BTreeSet<Operand>) {
        match operand {
            Operand::Constant(_) => {}
            Operand::Result(index) if self.names[index as usize].is_none() => {
                self.add_reads(index as usize, reads);
            }
            Operand::Input(_) | Operand::Result(_) => {
                reads.insert(operand);
            }
        }
    }

    /// The variables that stand in the text of an instruction.
    fn add_reads(&self, index: usize, reads: &mut BTreeSet<Operand>) {
        for operand in self.program.instructions[index].operands() {
            self.reads_of(operand, reads);
        }
    }
}
