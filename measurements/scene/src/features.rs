//! The cost of each piece of the PUMA 560 and the Panda, and the effect of leaving it out.

use super::arms::*;
use super::measure::{errors, operations, times};
use testkit::five::Five;

/// An arm with a piece left out.
pub struct Feature {
    /// The arm.
    pub arm: &'static str,
    /// The piece that is left out.
    pub without: &'static str,
    /// Multiplications, additions and divisions, in the order of
    /// [`NAMES`](testkit::five::NAMES).
    pub operations: [u32; 5],
    /// Nanoseconds of a call.
    pub nanoseconds: [f64; 5],
    /// The largest difference from the whole arm over its largest value.
    pub errors: [f64; 5],
}

/// Each piece; the arms as they are stand first.
pub fn features() -> Vec<Feature> {
    macro_rules! feature {
        ($name:literal, $without:literal, $part:ident, $whole:ident) => {
            feature(
                $name,
                $without,
                &$part,
                &$whole,
                operations(&$part::OPERATIONS),
            )
        };
    }
    vec![
        feature!("PUMA 560", "nothing", Puma, Puma),
        feature!("PUMA 560", "gravity", PumaWithoutGravity, Puma),
        feature!("PUMA 560", "friction", PumaWithoutFriction, Puma),
        feature!("PUMA 560", "motor inertia", PumaWithoutMotors, Puma),
        feature!("PUMA 560", "what is below 0.1 %", PumaAtTenthPercent, Puma),
        feature!("PUMA 560", "what is below 1 %", PumaAtOnePercent, Puma),
        feature!("PUMA 560", "what is below 5 %", PumaAtFivePercent, Puma),
        feature!("Panda", "nothing", Panda, Panda),
        feature!("Panda", "products of inertia", PandaWithoutProducts, Panda),
        feature!("Panda", "what is below 1 %", PandaAtOnePercent, Panda),
    ]
}

fn feature<const N: usize>(
    arm: &'static str,
    without: &'static str,
    part: &impl Five<N>,
    whole: &impl Five<N>,
    operations: [u32; 5],
) -> Feature {
    Feature {
        arm,
        without,
        operations,
        nanoseconds: times(part),
        errors: errors(part, whole),
    }
}
