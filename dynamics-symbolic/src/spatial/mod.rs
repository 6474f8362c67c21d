//! Rigid bodies and the joints between them, in spatial vectors (Featherstone 2008, chapter 2), over
//! any commutative ring: the same formulas serve expressions on the graph, doubles, intervals and the
//! prime field.
//!
//! All vectors are those of frames whose z axis is the axis of their own joint: what a joint does, it
//! does along z. The proof has mechanics of its own, the textbook's, and uses nothing of this.

mod acceleration;
mod body;
mod joint;
mod place;
mod turn;
mod vectors;
mod writing;

pub use acceleration::Acceleration;
pub use body::{Body, Central, Keep};
pub use joint::Joint;
pub use place::{Place, Turns};
pub use turn::{Axis, Turn, enter_about, leave_about, tensor_leave_about};
pub use vectors::{AxisMotion, Force, Motion};
pub use writing::{Along, Spread, Writing};
