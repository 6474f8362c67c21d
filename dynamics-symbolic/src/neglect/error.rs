//! How far the functions of an abbreviated model are from those of the complete one.

use super::arm::{Arm, Forces};
use super::reals::sin_cos;
use super::sample::Samples;
use super::{STATES, sum};
use crate::exact::Rational;
use crate::function::{Argument, Part, spans};
use crate::mechanism::Mechanism;
use crate::program::{Arithmetic, Program, by_operators};
use crate::robot::{Grouping, Robot, Symbol};
use core::f64::consts::PI;

/// Velocities are sampled up to 3 rad/s or m/s.
const VELOCITY: f64 = 3.0;

/// Accelerations up to 10 rad/s^2 or m/s^2.
const ACCELERATION: f64 = 10.0;

/// Functions of an abbreviated model that are one program, beside the complete ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LargestError {
    /// The largest difference of an entry over the largest size of any entry of its function, both over
    /// the sampled states.
    pub relative: f64,
    /// The operations that the complete functions take.
    pub complete: u32,
    /// How many fewer they take now.
    pub saved: u32,
}

/// The error of functions of the complete `robot` at [`STATES`] states: their complete program, and the
/// one that is left.
pub fn largest_error(
    robot: &Robot,
    parts: &[Part],
    complete: &Program,
    pruned: &Program,
) -> LargestError {
    let outputs = complete.outputs.len();
    let spans = spans(parts, robot.freedoms(), outputs);
    // Behind the values of a function there may be pivots and the diagonal.
    let values = parts.iter().zip(spans).map(|(part, span)| {
        let count = part.function.entries(robot.freedoms(), span.len());
        span.start..span.start + count
    });
    let mut errors: Vec<_> = values.map(|span| (span, 0.0_f64, 0.0_f64)).collect();
    for mut point in points(&robot.into()) {
        let whole = complete.evaluate(&mut point);
        let left = pruned.evaluate(&mut point);
        for (span, difference, size) in &mut errors {
            let entries = whole[span.clone()].iter().zip(&left[span.clone()]);
            for (whole, left) in entries {
                *difference = difference.max((whole - left).abs());
                *size = size.max(whole.abs());
            }
        }
    }
    let relative = errors.iter().filter(|(_, _, size)| *size > 0.0);
    let relative = relative.map(|(_, difference, size)| difference / size);
    let (before, after) = (complete.operations().total(), pruned.operations().total());
    LargestError {
        relative: relative.fold(0.0, f64::max),
        complete: before,
        saved: before.saturating_sub(after),
    }
}

/// A state, as the values of a program's symbols.
struct Point {
    q: Vec<f64>,
    qd: Vec<f64>,
    qdd: Vec<f64>,
    tau: Forces,
}

/// The sampled states; the joint forces are those of the complete arm, friction apart.
fn points(mechanism: &Mechanism) -> Vec<Point> {
    let arm = Arm::new(mechanism, &Grouping::of_mechanism(mechanism));
    let samples = Samples::new(mechanism, STATES);
    let states = samples.q.iter().zip(&samples.u).zip(&samples.ud);
    let point = |((q, u), ud): ((&Vec<f64>, &Vec<f64>), &Vec<f64>)| {
        let qd: Vec<f64> = u.iter().map(|u| VELOCITY * u).collect();
        let qdd: Vec<f64> = ud.iter().map(|u| ACCELERATION * u).collect();
        let tau = sum(&arm.forces(q, &qd, &qdd, true));
        Point {
            q: mechanism.with_followers(q, &[]),
            qd: mechanism.with_followers(&qd, &[]),
            qdd,
            tau,
        }
    };
    states.map(point).collect()
}

impl Point {
    /// An entry of an argument. A reference motion is as fast as the motion itself and another one; accelerations
    /// change within a tenth of a second.
    fn entry(&self, argument: Argument, i: usize) -> f64 {
        let speed = VELOCITY / ACCELERATION;
        match argument {
            Argument::ReferenceVelocity => speed * self.qdd[i],
            Argument::ReferenceAcceleration => self.qd[i] / speed,
            Argument::Jerk => -10.0 * self.qdd[i],
            Argument::Snap => 100.0 * self.qd[i] / speed,
            Argument::Wrench => 1.0,
            Argument::Position => self.q[i],
            Argument::Velocity => self.qd[i],
            Argument::Acceleration => self.qdd[i],
            Argument::Force => self.tau[i],
            Argument::Base | Argument::Order | Argument::Pose => f64::NAN,
        }
    }
}

impl Arithmetic for Point {
    type Number = f64;

    fn rational(&mut self, x: &Rational) -> f64 {
        x.to_f64().value()
    }

    fn symbol(&mut self, symbol: &Symbol) -> f64 {
        if let Some((argument, i)) = symbol.entry() {
            return self.entry(argument, i);
        }
        match symbol {
            Symbol::Pi => PI,
            Symbol::AngleSine(angle) => sin_cos(angle.to_f64(&[])).0,
            Symbol::AngleCosine(angle) => sin_cos(angle.to_f64(&[])).1,
            Symbol::Sine(i) => sin_cos(self.q[*i]).0,
            Symbol::Cosine(i) => sin_cos(self.q[*i]).1,
            Symbol::VelocitySign(i) => self.qd[*i].signum(),
            // The same in both models: how much it is does not matter to their difference.
            Symbol::Stribeck(_) => 0.0,
            _ => f64::NAN,
        }
    }

    by_operators!(f64);
}
