//! States of an arm, and values of its fields, at which rounding is counted.

use crate::exact::{SplitMix64, sin_cos};
use crate::function::Argument;
use crate::mechanism::Mechanism;
use crate::robot::{Symbol, Value};
use crate::rounding::Bounded;
use core::f64::consts::{FRAC_PI_2, PI};

/// The values of an arm's symbols at one state. Positions and velocities of the joints are followed by
/// those of the followers, less their offsets.
pub(crate) struct State {
    q: Vec<f64>,
    qd: Vec<f64>,
    qdd: Vec<f64>,
    tau: Vec<f64>,
    /// The seed of all other arguments.
    entries: u64,
    fields: Fields,
}

/// States of an arm: positions over the joints' ranges, the rest from -1 to 1.
///
/// Two states each have the same values of the fields. Every other pair has ordinary values, the pairs
/// between have unlucky ones: magnitudes that differ by up to nine powers of ten, and angles that
/// nearly vanish or are nearly right.
pub(crate) fn states(arm: &Mechanism, seed: u64, pairs: usize) -> Vec<[State; 2]> {
    let mut random = SplitMix64::new(seed);
    let pair = |number| {
        let fields = Fields::new(arm, &mut random, number % 2 == 1);
        [(); 2].map(|()| State::new(arm, &mut random, fields.clone()))
    };
    (0..pairs).map(pair).collect()
}

/// Values of the fields.
#[derive(Clone)]
struct Fields {
    values: Vec<f64>,
    /// Where it is not zero, angles of the table that depend on fields are so near to a right angle.
    near: f64,
}

impl Fields {
    fn new(arm: &Mechanism, random: &mut SplitMix64, unlucky: bool) -> Self {
        let values = (0..arm.fields).map(|_| {
            if unlucky {
                graded(random, -4, 4)
            } else {
                0.5 + 1.5 * random.unit()
            }
        });
        let values = values.collect();
        let near = if unlucky { graded(random, -8, -2) } else { 0.0 };
        Fields { values, near }
    }

    /// Sine and cosine of an angle of the table. Sines and fields are symbols that know nothing of
    /// one another: an angle may be moved next to a right one.
    fn sin_cos(&self, angle: &Value) -> (f64, f64) {
        let angle = angle.to_f64(&self.values);
        if self.near == 0.0 {
            return sin_cos(angle);
        }
        let quarters = (angle / FRAC_PI_2).round();
        let rest = angle - quarters * FRAC_PI_2;
        sin_cos(quarters.rem_euclid(4.0) * FRAC_PI_2 + self.near * (1.0 + rest))
    }
}

impl State {
    fn new(arm: &Mechanism, random: &mut SplitMix64, fields: Fields) -> Self {
        let along = |i: usize| {
            let [lower, upper] = arm.joints[i].range(&fields.values);
            lower + random.unit() * (upper - lower)
        };
        let q: Vec<f64> = arm.free().map(along).collect();
        let mut symmetric = || q.iter().map(|_| 2.0 * random.unit() - 1.0).collect();
        let (qd, qdd, tau): (Vec<f64>, _, _) = (symmetric(), symmetric(), symmetric());
        State {
            qd: arm.with_followers(&qd, &fields.values),
            qdd,
            tau,
            entries: q.first().map_or(0, |q| q.to_bits()),
            q: arm.with_followers(&q, &fields.values),
            fields,
        }
    }

    /// An entry of another argument, from -1 to 1.
    fn entry(&self, argument: Argument, index: usize) -> f64 {
        let seed = [argument as u64, index as u64]
            .into_iter()
            .fold(self.entries, |seed, k| SplitMix64::new(seed ^ k).next_u64());
        2.0 * SplitMix64::new(seed).unit() - 1.0
    }

    /// The value of a symbol: rounded where the program computes it.
    pub(crate) fn symbol(&self, symbol: &Symbol) -> Bounded {
        match symbol {
            Symbol::Pi => Bounded::rounded(PI),
            Symbol::Field(i) => Bounded::exact(self.fields.values[*i]),
            Symbol::AngleSine(angle) => Bounded::rounded(self.fields.sin_cos(angle).0),
            Symbol::AngleCosine(angle) => Bounded::rounded(self.fields.sin_cos(angle).1),
            Symbol::Sine(i) => Bounded::rounded(sin_cos(self.q[*i]).0),
            Symbol::Cosine(i) => Bounded::rounded(sin_cos(self.q[*i]).1),
            Symbol::Position(i) => Bounded::exact(self.q[*i]),
            Symbol::Velocity(i) => Bounded::exact(self.qd[*i]),
            Symbol::Acceleration(i) => Bounded::exact(self.qdd[*i]),
            Symbol::Force(i) => Bounded::exact(self.tau[*i]),
            Symbol::VelocitySign(i) => Bounded::exact(self.qd[*i].signum()),
            // Any number from 0 to 1: it is a symbol that knows nothing of the velocity.
            Symbol::Stribeck(i) => Bounded::rounded(1.0 / (1.0 + self.qd[*i] * self.qd[*i])),
            Symbol::Entry(argument, i) => Bounded::exact(self.entry(*argument, *i)),
        }
    }
}

/// A number from 10^lowest to 10^highest, every power of ten as likely as another.
fn graded(random: &mut SplitMix64, lowest: i32, highest: i32) -> f64 {
    let count = (highest - lowest) as u64;
    let exponent = lowest + (random.next_u64() % count) as i32;
    let digits = 1.0 + 9.0 * random.unit();
    (0..exponent.abs()).fold(
        digits,
        |x, _| if exponent < 0 { x / 10.0 } else { x * 10.0 },
    )
}
