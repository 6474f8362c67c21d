//! Rigid bodies and the joints between them, in spatial vectors (Featherstone 2008, chapter 2), over
//! any commutative ring: the same formulas serve expressions on the graph, doubles, intervals and the
//! prime field.
//!
//! All vectors are those of frames whose z axis is the axis of their own joint: what a joint does, it
//! does along z. The proof has mechanics of its own, the textbook's, and uses nothing of this.

mod acceleration;
mod body;
mod joint;
mod turn;
mod vectors;

pub use acceleration::Acceleration;
pub use body::{Body, Central, Keep};
pub use joint::Joint;
pub use turn::{
    Turn, enter_x, enter_y, enter_z, leave_x, leave_y, leave_z, tensor_leave_x, tensor_leave_y,
    tensor_leave_z,
};
pub use vectors::{Force, Motion};
