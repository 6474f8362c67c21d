//! Named places on links and on the base.

use super::{Body, Placement, Robot, Value};
use crate::function::Part;

/// A frame that is fixed to a link or to the base, with a body if there is one.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame<C = Value> {
    /// The frame's name.
    pub name: String,
    /// The row whose link carries it; `None` for the base.
    pub on: Option<usize>,
    /// The frame in that link frame, or in frame 0: each place in the one before it.
    pub places: Vec<Placement<C>>,
    /// The body that is fixed there. A body on the base counts nowhere, because the base stands.
    pub body: Option<Body<C>>,
}

impl Robot {
    /// The name of the method that returns the values of a part alone.
    pub fn name_of(&self, part: Part) -> String {
        let frame = part.frame.and_then(|frame| self.frames.get(frame));
        match frame {
            Some(frame) => part.function.name_of_frame(&frame.name),
            None => part.function.name().to_owned(),
        }
    }
}
