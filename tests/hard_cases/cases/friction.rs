//! Dry friction.

use robot_dynamics::nalgebra::Vector1;

use super::arms::*;
use super::score::Score;

pub(crate) fn scores() -> Vec<Score> {
    vec![sign_of_zero()]
}

/// sign(0) = 0, of either zero; a velocity that is not a number stays one.
fn sign_of_zero() -> Score {
    let friction = |speed: f64| DryJoint.friction_vector(&Vector1::new(speed))[0];
    let wrong = [
        friction(0.0) != 0.0,
        friction(-0.0) != 0.0,
        !friction(f64::NAN).is_nan(),
        friction(1e-300) != 1.0,
        friction(-1e-300) != -1.0,
    ];
    let wrong = wrong.iter().filter(|wrong| **wrong).count();
    Score::at_most("HC24", "wrong signs of 5", wrong as f64, 0.0).naive(2.0)
}
