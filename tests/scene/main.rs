//! Only what a scene needs: accurate forward dynamics on request, joints that are locked, terms that
//! are neglected.

mod articulated;
mod frames;
mod limits;
mod lock;
mod neglect;
