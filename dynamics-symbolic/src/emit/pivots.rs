//! The pivots of M, by which functions that solve with M refuse.

use crate::function::{Freedoms, Request, spans};
use crate::program::{Output, Program};

/// The degree of freedom of each pivot, the pivot and the diagonal entry that it is tested against, from the tip inwards. Two
/// functions of one program may have the same pivots: they are tested once.
pub fn pivots(
    freedoms: Freedoms,
    request: &Request,
    program: &Program,
) -> Vec<(usize, [Output; 2])> {
    let mut pivots: Vec<(usize, [Output; 2])> = Vec::new();
    let spans = spans(request.parts(), freedoms, program.outputs.len());
    let count = freedoms.all();
    for (part, span) in request.parts().iter().zip(spans) {
        if !part.function.has_pivots() {
            continue;
        }
        let (first, diagonal) = (span.end - 2 * count, span.end - count);
        for joint in (0..count).rev() {
            let outputs = [first, diagonal].map(|start| program.outputs[start + joint]);
            if !pivots.iter().any(|(_, known)| *known == outputs) {
                pivots.push((joint, outputs));
            }
        }
    }
    pivots
}
