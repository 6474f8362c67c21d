//! The abbreviated model: what hardly matters is left out of the Lagrangian.
//!
//! The Lagrangian is linear in the base inertial parameters: each is a coefficient of terms of T and U. Parameters
//! whose terms stay below a share of the largest value of every function, M, V and G, over sampled states are left
//! out, as terms of the equations are in Armstrong, Khatib and Burdick (1986). There each equation is pruned by
//! itself, and what is left belongs to no Lagrangian: it makes and loses energy. Here all functions are derived
//! again from the Lagrangian that is left.
//!
//! Joints are measured by the inertia that they meet. With w_i the square root of the largest M_ii,
//! the entries of M are compared as M_ij / (w_i w_j), forces as tau_i / w_i, and V at the velocities
//! u_i / w_i, |u_i| <= 1. So the choice depends on no unit, and a wrist is not lost beside a shoulder.
//!
//! Decisions are made in double precision by operations that every processor rounds alike.
//!
//! Parameters are dropped, not monomials: the recursions stay, T stays quadratic and the arm a chain of bodies.
//! Dropped means that the parameter's value as a base parameter, an exact constant, is taken off the link that it is
//! written on. That M stays positive definite is proven (`definite`). Where the search for that fails, a descent
//! looks for a state to name in the error. One of 120 random arms at 10 to 30 % was neither proven nor found
//! indefinite, and it is refused. An arm whose complete M is not proven is judged at the samples, and the
//! documentation of its functions says so.

mod arm;
mod definite;
mod descent;
mod error;
mod reals;
mod sample;

pub use error::{LargestError, largest_error};

use crate::linear::eliminate;
use crate::mechanism::Mechanism;
use crate::robot::{Grouping, Neglected, Robot};
use arm::{Arm, Forces};
use core::fmt;
use sample::Samples;

/// States at which terms are weighed.
pub const STATES: usize = 200;

/// A share at which too much is left out.
#[derive(Clone, Debug, PartialEq)]
pub struct NotPositiveDefinite {
    /// Positions of the joints at which M, as it is left, is not positive definite; `None` where none
    /// were found, and it could not be shown that there are none.
    pub q: Option<Vec<f64>>,
    /// How many base parameters would be left out.
    pub count: usize,
}

impl fmt::Display for NotPositiveDefinite {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = self.count;
        write!(
            f,
            "without the {count} base inertial parameters below this share the mass matrix "
        )?;
        match &self.q {
            Some(q) => {
                let q: Vec<_> = q.iter().map(|q| format!("{q:.3}")).collect();
                write!(f, "is not positive definite at q = ({})", q.join(", "))?;
            }
            None => write!(
                f,
                "could not be shown to be positive definite at all positions"
            )?,
        }
        write!(f, ": choose a smaller share")
    }
}

impl std::error::Error for NotPositiveDefinite {}

/// The robot without the base parameters whose effects stay below the share. It must be known in
/// numbers. Revolute joints without limits are sampled over a turn, prismatic ones over +-1 m.
///
/// # Errors
///
/// Where M is not positive definite any more at some state, though it was, or where it cannot be shown
/// that it is at all positions, though the complete one's is.
pub fn neglect(robot: &Robot, share: f64) -> Result<Robot, NotPositiveDefinite> {
    let mechanism = Mechanism::from(robot);
    let grouping = Grouping::of_mechanism(&mechanism);
    let arm = Arm::new(&mechanism, &grouping);
    let samples = Samples::new(&mechanism, STATES);
    let effects = Effects::new(&arm, &samples);
    // A parameter without any effect costs nothing as it is.
    let is_small = |x: &f64| *x > 0.0 && *x < share;
    let small: Vec<bool> = effects.shares().iter().map(is_small).collect();
    let is_kept: Vec<bool> = small.iter().map(|small| !small).collect();
    let count = small.iter().filter(|small| **small).count();
    let refused = |q| Err(NotPositiveDefinite { q, count });
    if let Some(q) = effects.indefinite(&samples, &is_kept) {
        return refused(Some(q));
    }
    let is_coupled = mechanism.is_coupled();
    let free = is_coupled.then(|| mechanism.uncoupled());
    let sizes = match &free {
        Some(free) => sizes(&Arm::new(free, &grouping), &Samples::new(free, STATES)),
        None => effects.sizes(),
    };
    let free = free.as_ref().unwrap_or(&mechanism);
    let shown = |is_kept: &[bool]| definite::is_positive_definite(free, &grouping, is_kept, &sizes);
    let is_definite = shown(&is_kept);
    // The free arm of a coupled one may lose its definiteness alone.
    if !is_definite && !is_coupled && shown(&vec![true; small.len()]) {
        return refused(descent::indefinite(&mechanism, &arm, &samples, &is_kept));
    }
    let columns = arm.columns.iter().zip(&small);
    let columns = columns.filter(|(_, small)| **small);
    let mut pruned = robot.clone();
    pruned.neglected = Some(Neglected {
        columns: columns.map(|(column, _)| *column).collect(),
        grouping,
        share,
        is_definite,
    });
    Ok(pruned)
}

/// The parts of each base parameter in M, V and G at the samples.
struct Effects {
    /// By sample, parameter, row and column.
    mass_matrix: Vec<Vec<Vec<Forces>>>,
    /// By sample, parameter and joint.
    coriolis: Vec<Vec<Forces>>,
    gravity: Vec<Vec<Forces>>,
    /// w
    weights: Vec<f64>,
}

impl Effects {
    fn new(arm: &Arm, samples: &Samples) -> Self {
        let at = |q: &Vec<f64>| arm.mass_matrix(q);
        let mass_matrix: Vec<_> = samples.q.iter().map(at).collect();
        let weights = weights(&mass_matrix, arm.dof());
        let still = vec![0.0; arm.dof()];
        let states = samples.q.iter().zip(&samples.u);
        let coriolis = states.map(|(q, u)| {
            let qd: Vec<_> = u.iter().zip(&weights).map(|(u, w)| u / w).collect();
            arm.forces(q, &qd, &still, false)
        });
        let gravity = samples
            .q
            .iter()
            .map(|q| arm.forces(q, &still, &still, true));
        Effects {
            coriolis: coriolis.collect(),
            gravity: gravity.collect(),
            mass_matrix,
            weights,
        }
    }

    /// The largest M_ii.
    fn sizes(&self) -> Vec<f64> {
        self.weights.iter().map(|w| w * w).collect()
    }

    /// The largest share of each parameter in any of the functions.
    fn shares(&self) -> Vec<f64> {
        let columns = self.mass_matrix.iter().map(|parameters| {
            let flat = |columns: &Vec<Forces>| -> Forces {
                let scaled = columns.iter().zip(&self.weights);
                scaled
                    .flat_map(|(column, w)| column.iter().map(move |x| x / w))
                    .collect()
            };
            parameters.iter().map(flat).collect()
        });
        let functions = [
            columns.collect::<Vec<Vec<Forces>>>(),
            self.coriolis.clone(),
            self.gravity.clone(),
        ];
        let mut shares = vec![0.0; self.gravity.first().map_or(0, Vec::len)];
        for function in functions {
            let largest = |parts: &mut dyn Iterator<Item = &Forces>| {
                parts.fold(0.0, |largest: f64, part| largest.max(self.size(part)))
            };
            let whole = function.iter().map(|parts| self.size(&sum(parts)));
            let whole = whole.fold(0.0, f64::max);
            for (k, share) in shares.iter_mut().enumerate() {
                let part = largest(&mut function.iter().map(|parts| &parts[k]));
                if whole > 0.0 {
                    *share = f64::max(*share, part / whole);
                }
            }
        }
        shares
    }

    /// The largest of some forces, each over its joint's weight.
    fn size(&self, forces: &Forces) -> f64 {
        let scaled = forces.iter().zip(self.weights.iter().cycle());
        scaled.fold(0.0, |largest, (x, w)| f64::max(largest, (x / w).abs()))
    }

    /// A sample at which the whole M is positive definite, but not what is left of it.
    fn indefinite(&self, samples: &Samples, is_kept: &[bool]) -> Option<Vec<f64>> {
        let all = vec![true; is_kept.len()];
        let is_definite = |parts: &[Vec<Forces>], is_kept: &[bool]| {
            least_relative_pivot(sum_of(parts, is_kept)) > SMALLEST_PIVOT
        };
        let mut states = samples.q.iter().zip(&self.mass_matrix);
        let found =
            states.find(|(_, parts)| is_definite(parts, &all) && !is_definite(parts, is_kept));
        found.map(|(q, _)| q.clone())
    }
}

/// The largest M_ii of an arm at the samples.
fn sizes(arm: &Arm, samples: &Samples) -> Vec<f64> {
    let mass_matrix: Vec<_> = samples.q.iter().map(|q| arm.mass_matrix(q)).collect();
    let weights = weights(&mass_matrix, arm.dof()).into_iter();
    weights.map(|w| w * w).collect()
}

/// M of some of the parameters.
fn sum_of(parts: &[Vec<Forces>], is_kept: &[bool]) -> Vec<Vec<f64>> {
    let dof = parts.first().map_or(0, Vec::len);
    let mut matrix = vec![vec![0.0; dof]; dof];
    for (part, _) in parts.iter().zip(is_kept).filter(|(_, is_kept)| **is_kept) {
        for (column, part) in matrix.iter_mut().zip(part) {
            for (x, part) in column.iter_mut().zip(part) {
                *x += part;
            }
        }
    }
    matrix
}

fn sum(parts: &[Forces]) -> Forces {
    let mut whole = vec![0.0; parts.first().map_or(0, Vec::len)];
    for part in parts {
        for (x, part) in whole.iter_mut().zip(part) {
            *x += part;
        }
    }
    whole
}

/// The square roots of the largest diagonal entries of M; 1 where there is no inertia at all.
fn weights(mass_matrix: &[Vec<Vec<Forces>>], dof: usize) -> Vec<f64> {
    let largest = |i: usize| {
        let entry = |parameters: &Vec<Vec<Forces>>| -> f64 {
            parameters.iter().map(|columns| columns[i][i]).sum()
        };
        let largest = mass_matrix.iter().map(entry).fold(0.0, f64::max);
        if largest > 0.0 { largest.sqrt() } else { 1.0 }
    };
    (0..dof).map(largest).collect()
}

/// Below that share of its diagonal entry a pivot is no more than rounding, as in forward dynamics.
const SMALLEST_PIVOT: f64 = 8.0 * f64::EPSILON;

/// The least pivot of the elimination over its diagonal entry, as far as they are positive.
fn least_relative_pivot(mut m: Vec<Vec<f64>>) -> f64 {
    let diagonal: Vec<f64> = (0..m.len()).map(|i| m[i][i]).collect();
    let mut least = f64::INFINITY;
    for j in (0..m.len()).rev() {
        let pivot = m[j][j];
        // An entry of zero makes it no number, which is not greater than anything.
        let relative = pivot / diagonal[j].abs();
        let is_positive = relative > SMALLEST_PIVOT;
        if !is_positive {
            return relative;
        }
        least = least.min(relative);
        eliminate(&mut m, j, |x| x / pivot);
    }
    least
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn definiteness_is_a_matter_of_pivots() {
        let matrix = |off: f64| vec![vec![2.0, off], vec![off, 2.0]];
        let is_definite = |m| least_relative_pivot(m) > SMALLEST_PIVOT;
        assert!(is_definite(matrix(1.999)));
        assert!(!is_definite(matrix(2.0)));
        assert!(!is_definite(matrix(2.001)));
        assert!(!is_definite(vec![vec![0.0]]));
    }
}
