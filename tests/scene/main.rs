//! Only what a scene needs: accurate forward dynamics on request, joints that are locked, terms that
//! are neglected.

#[path = "../support/double_double.rs"]
mod double_double;

mod articulated;
mod limits;
mod lock;
mod neglect;
