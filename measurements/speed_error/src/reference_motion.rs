//! Motions in numbers of 31 digits, for problems that have no other reference.
//!
//! W. B. Gragg, *On extrapolation algorithms for ordinary initial value problems*, SIAM J. Numer. Anal. 2
//! (1965), 384-403; Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*, section
//! II.9.

use robot_dynamics::nalgebra::SVector;
use robot_dynamics::{DoubleDouble, ForwardDynamics};

/// Columns of the extrapolation: order 16.
const COLUMNS: usize = 8;

/// Positions and velocities.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Phase<const N: usize> {
    pub(crate) q: SVector<DoubleDouble, N>,
    pub(crate) qd: SVector<DoubleDouble, N>,
}

impl<const N: usize> Phase<N> {
    pub(crate) fn new(q: SVector<f64, N>, qd: SVector<f64, N>) -> Self {
        Phase {
            q: q.map(DoubleDouble::from),
            qd: qd.map(DoubleDouble::from),
        }
    }

    fn plus(&self, other: &Phase<N>, factor: DoubleDouble) -> Self {
        Phase {
            q: self.q + other.q * factor,
            qd: self.qd + other.qd * factor,
        }
    }

    /// The largest difference of the positions.
    pub(crate) fn distance(&self, other: &Phase<N>) -> f64 {
        let difference = self.q - other.q;
        difference
            .iter()
            .fold(0.0, |largest, x| x.high().abs().max(largest))
    }
}

/// The end of a free motion, by so many steps.
pub(crate) fn motion<const N: usize>(
    arm: &impl ForwardDynamics<N>,
    start: Phase<N>,
    duration: f64,
    steps: u32,
) -> Phase<N> {
    let length = DoubleDouble::from(duration) / DoubleDouble::from(f64::from(steps));
    (0..steps).fold(start, |phase, _| step(arm, &phase, length))
}

fn rate<const N: usize>(arm: &impl ForwardDynamics<N>, phase: &Phase<N>) -> Phase<N> {
    let qdd = arm.forward_dynamics(&phase.q, &phase.qd, &SVector::zeros());
    Phase {
        q: phase.qd,
        qd: qdd.unwrap_or_else(|_| SVector::repeat(DoubleDouble::from(f64::NAN))),
    }
}

/// The values of the modified midpoint rule with 2, 4, 6, ... parts, extrapolated to infinitely
/// many (Aitken and Neville):
/// `T_jk = T_j,k-1 + (T_j,k-1 - T_j-1,k-1) / ((n_j / n_j-k)^2 - 1)`.
fn step<const N: usize>(
    arm: &impl ForwardDynamics<N>,
    start: &Phase<N>,
    length: DoubleDouble,
) -> Phase<N> {
    let slope = rate(arm, start);
    let one = DoubleDouble::from(1.0);
    let mut before: Vec<Phase<N>> = Vec::new();
    for j in 0..COLUMNS {
        let mut row = vec![midpoint(arm, start, &slope, length, 2 * (j + 1))];
        for k in 1..=j {
            let ratio = DoubleDouble::from((j + 1) as f64) / DoubleDouble::from((j + 1 - k) as f64);
            let difference = row[k - 1].plus(&before[k - 1], -one);
            row.push(row[k - 1].plus(&difference, one / (ratio * ratio - one)));
        }
        before = row;
    }
    before[COLUMNS - 1]
}

/// The modified midpoint rule, with Gragg's smoothing at its end.
fn midpoint<const N: usize>(
    arm: &impl ForwardDynamics<N>,
    start: &Phase<N>,
    slope: &Phase<N>,
    length: DoubleDouble,
    parts: usize,
) -> Phase<N> {
    let h = length / DoubleDouble::from(parts as f64);
    let (mut before, mut here) = (*start, start.plus(slope, h));
    for _ in 1..parts {
        let next = before.plus(&rate(arm, &here), h + h);
        before = here;
        here = next;
    }
    let half = DoubleDouble::from(0.5);
    let last = before.plus(&rate(arm, &here), h);
    let sum = here.plus(&last, DoubleDouble::from(1.0));
    Phase {
        q: sum.q * half,
        qd: sum.qd * half,
    }
}
