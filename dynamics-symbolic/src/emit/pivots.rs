//! The pivots of M, by which functions that solve with M refuse.

use crate::function::{Request, spans};
use crate::program::{Output, Program};

/// The joint of each pivot, the pivot and the diagonal entry that it is tested against, from the tip inwards. Two
/// functions of one program may have the same pivots: they are tested once.
pub(super) fn pivots(
    joints: usize,
    request: &Request,
    program: &Program,
) -> Vec<(usize, [Output; 2])> {
    let mut pivots: Vec<(usize, [Output; 2])> = Vec::new();
    let spans = spans(request.parts(), joints, program.outputs.len());
    for (part, span) in request.parts().iter().zip(spans) {
        if !part.function.has_pivots() {
            continue;
        }
        let (first, diagonal) = (span.end - 2 * joints, span.end - joints);
        for joint in (0..joints).rev() {
            let outputs = [first, diagonal].map(|start| program.outputs[start + joint]);
            if !pivots.iter().any(|(_, known)| *known == outputs) {
                pivots.push((joint, outputs));
            }
        }
    }
    pivots
}
