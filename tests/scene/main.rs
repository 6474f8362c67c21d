//! Only what a scene needs: accurate forward dynamics on request, joints that are locked or follow others, terms that
//! are neglected.

mod articulated;
mod couple;
mod frames;
mod limits;
mod lock;
mod neglect;

use robot_dynamics::check::Check;

/// A comparison with the numeric algorithms at fewer states than it has by default, for arms that are long to
/// compute unoptimised.
fn check() -> Check {
    Check::new().samples(20)
}
