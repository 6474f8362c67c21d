//! The states at which terms are weighed.

use crate::exact::SplitMix64;
use crate::mechanism::Mechanism;

/// Positions, and numbers from -1 to 1 for velocities and accelerations.
pub(super) struct Samples {
    pub(super) q: Vec<Vec<f64>>,
    pub(super) u: Vec<Vec<f64>>,
    pub(super) ud: Vec<Vec<f64>>,
}

impl Samples {
    /// The first half uniform over the ranges, the others with joints at the ends, in the middle or
    /// at the quarters of theirs. Equal tables give equal samples.
    pub(super) fn new(arm: &Mechanism, count: usize) -> Self {
        let mut random = SplitMix64::new(0x006e_6567_6c65_6374);
        let ranges = ranges(arm);
        let mut samples = Samples {
            q: Vec::new(),
            u: Vec::new(),
            ud: Vec::new(),
        };
        for state in 0..count {
            let mut along = || {
                if state < count / 2 {
                    random.unit()
                } else {
                    (random.next_u64() % 5) as f64 / 4.0
                }
            };
            let position = |[lower, upper]: &[f64; 2]| lower + along() * (upper - lower);
            samples.q.push(ranges.iter().map(position).collect());
            let mut both = || ranges.iter().map(|_| 2.0 * random.unit() - 1.0).collect();
            samples.u.push(both());
            samples.ud.push(both());
        }
        samples
    }
}

/// The ranges over which the free joints are sampled.
pub(super) fn ranges(arm: &Mechanism) -> Vec<[f64; 2]> {
    arm.free().map(|i| arm.joints[i].range(&[])).collect()
}
