//! The ends of the joints' ranges, as a simulation has them.

use dynamics_runtime::Size;
use dynamics_runtime::table::Arm;

use super::error::InvalidSetting;
use crate::integrate::Phase;

/// The fate of a joint that reaches an end of its range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum AtLimit {
    /// Nothing: it goes on.
    Passes,
    /// The run ends in an error.
    Ends,
    /// A stop throws it back.
    Rebounds {
        /// Speed after over speed before.
        restitution: f64,
    },
}

/// The ranges of the joints, infinite where the table has none, and what happens at their ends.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Limits<D: Size> {
    pub(super) kind: AtLimit,
    pub(super) ranges: D::Each<[f64; 2]>,
    /// The step of a method whose positions are straight lines within a step, s; 0 of the other methods.
    pub(super) straight: f64,
}

/// An end of a joint's range where the joint is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct End {
    /// The position of the end.
    pub(super) at: f64,
    /// The way into the range: 1 from the lower end, -1 from the upper one.
    pub(super) inwards: f64,
}

/// How near to an end a joint is at it, relative to the size of the position and to 1 rad or 1 m.
const RESOLUTION: f64 = 1e-13;

impl End {
    /// How near to it a joint is at it, rad or m.
    pub(super) fn resolution(&self) -> f64 {
        RESOLUTION * (1.0 + self.at.abs())
    }

    /// The way left to it, negative beyond.
    pub(super) fn gap(&self, q: f64) -> f64 {
        self.inwards * (q - self.at)
    }
}

/// The range of a joint without ends.
const ENDLESS: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

impl<D: Size> Limits<D> {
    /// Joints without ends.
    pub(super) fn none(size: D) -> Self {
        Limits {
            kind: AtLimit::Passes,
            ranges: size.each(|_| ENDLESS),
            straight: 0.0,
        }
    }

    /// The limits of a table.
    pub(super) fn of(arm: Arm<'_>, kind: AtLimit) -> Self {
        let size = D::from_usize(arm.freedoms());
        let of_joint = |i: usize| arm.rows[i].limits;
        Limits {
            kind,
            ranges: size.each(|k| arm.joint_of(k).and_then(of_joint).unwrap_or(ENDLESS)),
            straight: 0.0,
        }
    }

    /// Whether they have a say in the motion.
    pub(super) fn matter(&self) -> bool {
        self.kind != AtLimit::Passes
    }

    /// The ends of joint `i`'s range that there are.
    pub(super) fn ends(&self, i: usize) -> impl Iterator<Item = End> {
        let [lower, upper] = self.ranges[i];
        let ends = [(lower, 1.0), (upper, -1.0)].map(|(at, inwards)| End { at, inwards });
        let there = self.matter();
        ends.into_iter()
            .filter(move |end| there && end.at.is_finite())
    }

    /// The end of its range where joint `i` is.
    pub(super) fn end(&self, i: usize, q: f64) -> Option<End> {
        self.ends(i).find(|end| end.gap(q) <= end.resolution())
    }

    /// How far joint `i` is from an event at the end. Where it is an error, the joint may be at it.
    pub(super) fn margin(&self, end: &End, q: f64) -> f64 {
        match self.kind {
            AtLimit::Ends => end.gap(q) + end.resolution(),
            _ => end.gap(q),
        }
    }

    /// The least rise of a bounce under an acceleration a back to the stop, rad or m: the resolution of positions, and
    /// `a h^2 / 2`. By so much steps of Euler's explicit method throw each bounce too high, so that it would never end.
    pub(super) fn least_rise(&self, end: &End, acceleration: f64) -> f64 {
        end.resolution() + 0.5 * acceleration * self.straight.powi(2)
    }

    pub(super) fn validate(&self, initial: &Phase<D>) -> Result<(), InvalidSetting> {
        if !self.matter() {
            return Ok(());
        }
        if let AtLimit::Rebounds { restitution } = self.kind
            && !(0.0..=1.0).contains(&restitution)
        {
            return Err(InvalidSetting::Restitution(restitution));
        }
        for (joint, [lower, upper]) in self.ranges.as_ref().iter().copied().enumerate() {
            // False also where one is not a number.
            let is_range = lower < upper && lower < f64::INFINITY && upper > f64::NEG_INFINITY;
            if !is_range {
                return Err(InvalidSetting::Limits { joint });
            }
            let q = initial.q[joint];
            if self.ends(joint).any(|end| end.gap(q) < -end.resolution()) {
                let limits = [lower, upper];
                return Err(InvalidSetting::OutsideLimits { joint, q, limits });
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Const, Vector2};

    use super::{AtLimit, Limits};
    use crate::integrate::Phase;
    use crate::simulation::InvalidSetting;

    fn verdict(range: [f64; 2], q: f64) -> Result<(), InvalidSetting> {
        let limits = Limits::<Const<2>> {
            kind: AtLimit::Ends,
            ranges: [[-1.0, 1.0], range],
            straight: 0.0,
        };
        limits.validate(&Phase {
            q: Vector2::new(0.0, q),
            qd: Vector2::zeros(),
        })
    }

    #[test]
    fn ranges_that_are_none_are_refused() {
        let (nan, inf) = (f64::NAN, f64::INFINITY);
        for range in [
            [1.0, -1.0],
            [1.0, 1.0],
            [nan, 1.0],
            [-1.0, nan],
            [inf, inf],
            [-inf, -inf],
        ] {
            let refused = Err(InvalidSetting::Limits { joint: 1 });
            assert_eq!(verdict(range, 0.0), refused, "{range:?}");
        }
        assert_eq!(verdict([-inf, inf], 1e9), Ok(()));
        assert_eq!(verdict([-inf, 1.0], 1.0), Ok(()));
        for q in [1.0 + 1e-9, -2.0] {
            let (joint, limits) = (1, [-1.0, 1.0]);
            let outside = Err(InvalidSetting::OutsideLimits { joint, q, limits });
            assert_eq!(verdict(limits, q), outside);
        }
    }
}
