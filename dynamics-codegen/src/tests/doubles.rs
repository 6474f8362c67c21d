//! Programs of robots on a base that moves, evaluated in doubles.

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::function::Argument;
use dynamics_symbolic::program::Arithmetic;
use dynamics_symbolic::robot::Symbol;

/// Doubles at a state.
#[derive(Clone)]
pub(super) struct Doubles {
    /// By rows, then the position.
    pub(super) base: [f64; 12],
    pub(super) q: Vec<f64>,
    pub(super) v: Vec<f64>,
    pub(super) a: Vec<f64>,
    pub(super) tau: Vec<f64>,
    pub(super) jerk: Vec<f64>,
}

impl Doubles {
    /// The state displaced by so much along each degree of freedom: of the base by R d, and turned by R exp(phi).
    pub(super) fn displaced(&self, by: &[f64]) -> Doubles {
        let mut other = self.clone();
        let turn = exponential([by[3], by[4], by[5]]);
        for i in 0..3 {
            let row = [0, 1, 2].map(|k| self.base[3 * i + k]);
            other.base[9 + i] += dot(row, [by[0], by[1], by[2]]);
            for j in 0..3 {
                other.base[3 * i + j] = dot(row, turn.map(|row| row[j]));
            }
        }
        for (q, by) in other.q.iter_mut().zip(&by[6..]) {
            *q += by;
        }
        other
    }

    /// The state after a time, along the motion.
    pub(super) fn later(&self, time: f64) -> Doubles {
        let step = |values: &[f64], rates: &[f64]| -> Vec<f64> {
            let values = values.iter().zip(rates);
            values.map(|(x, rate)| x + time * rate).collect()
        };
        let mut other = self.displaced(&step(&vec![0.0; self.v.len()], &self.v));
        other.v = step(&self.v, &self.a);
        other.a = step(&self.a, &self.jerk);
        other.jerk = step(&self.jerk, &entries(Argument::Snap, self.v.len()));
        other
    }
}

/// An argument of a function that no test chooses.
pub(super) fn entries(argument: Argument, count: usize) -> Vec<f64> {
    (0..count).map(|k| entry(argument, k)).collect()
}

fn entry(argument: Argument, k: usize) -> f64 {
    (7.0 * argument as usize as f64 + (k * k + 1) as f64).sin()
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The rotation by a vector: 1 + sin(t)/t X + (1 - cos(t))/t^2 X^2 (Rodrigues).
fn exponential(phi: [f64; 3]) -> [[f64; 3]; 3] {
    let angle = dot(phi, phi).sqrt();
    let (first, second) = if angle < 1e-9 {
        (1.0, 0.5)
    } else {
        (angle.sin() / angle, (1.0 - angle.cos()) / (angle * angle))
    };
    let [x, y, z] = phi;
    let cross = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
    let entry = |i: usize, j: usize| {
        let unit = f64::from(u8::from(i == j));
        unit + first * cross[i][j] + second * dot(cross[i], [0, 1, 2].map(|k| cross[k][j]))
    };
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)))
}

impl Arithmetic for Doubles {
    type Number = f64;

    fn rational(&mut self, x: &Rational) -> f64 {
        x.to_f64().value()
    }

    fn symbol(&mut self, symbol: &Symbol) -> f64 {
        match symbol {
            Symbol::Pi => core::f64::consts::PI,
            Symbol::AngleSine(angle) => angle.to_f64(&[]).sin(),
            Symbol::AngleCosine(angle) => angle.to_f64(&[]).cos(),
            Symbol::Sine(i) => self.q[i - 6].sin(),
            Symbol::Cosine(i) => self.q[i - 6].cos(),
            Symbol::Velocity(i) => self.v[*i],
            Symbol::Acceleration(i) => self.a[*i],
            Symbol::Force(i) => self.tau[*i],
            Symbol::Position(i) => self.q[i - 6],
            Symbol::Entry(Argument::Base, k) => self.base[*k],
            Symbol::Entry(Argument::Jerk, k) => self.jerk[*k],
            Symbol::Entry(argument, k) => entry(*argument, *k),
            other => panic!("{other:?}"),
        }
    }

    fn neg(&mut self, a: f64) -> f64 {
        -a
    }

    fn add(&mut self, a: f64, b: f64) -> f64 {
        a + b
    }

    fn mul(&mut self, a: f64, b: f64) -> f64 {
        a * b
    }

    fn div(&mut self, a: f64, b: f64) -> f64 {
        a / b
    }
}

/// The rotation of a unit quaternion x, y, z, w by rows, and the position in front of it.
pub(super) fn pose(q: &[f64]) -> [f64; 12] {
    let [px, py, pz, x, y, z, w] = q[..7].try_into().expect("a pose");
    let entry = |one: f64, other: f64| 2.0 * (one + other);
    [
        1.0 - entry(y * y, z * z),
        entry(x * y, -z * w),
        entry(x * z, y * w),
        entry(x * y, z * w),
        1.0 - entry(x * x, z * z),
        entry(y * z, -x * w),
        entry(x * z, -y * w),
        entry(y * z, x * w),
        1.0 - entry(x * x, y * y),
        px,
        py,
        pz,
    ]
}

pub(super) fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest, x| largest.max(x.abs()))
}

#[track_caller]
pub(super) fn assert_near(what: &str, found: &[f64], expected: &[f64], scale: f64) {
    assert_eq!(found.len(), expected.len(), "{what}");
    for (found, expected) in found.iter().zip(expected) {
        let error = (found - expected).abs();
        assert!(error <= 1e-13 * scale, "{what}: {found} beside {expected}");
    }
}

/// Entry (i, k): the derivative of value i along freedom k, by central differences.
pub(super) fn differences(count: usize, values: impl Fn(usize, f64) -> Vec<f64>) -> Vec<f64> {
    const STEP: f64 = 1e-5;
    let columns = (0..count).map(|k| (values(k, STEP), values(k, -STEP)));
    let columns = columns.map(|(up, down)| {
        up.iter()
            .zip(down)
            .map(|(u, d)| (u - d) / (2.0 * STEP))
            .collect()
    });
    let columns: Vec<Vec<f64>> = columns.collect();
    (0..columns[0].len())
        .flat_map(|i| {
            columns
                .iter()
                .map(move |column| column[i])
                .collect::<Vec<_>>()
        })
        .collect()
}
