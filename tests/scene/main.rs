//! Only what a scene needs: accurate forward dynamics on request, joints that are locked or follow others, terms that
//! are neglected.

mod articulated;
mod couple;
mod frames;
mod limits;
mod lock;
mod neglect;
