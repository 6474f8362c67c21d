//! All joint positions that a search finds.

use dynamics_runtime::{JointVector as _, Size};

use super::InverseKinematics;
use super::descent::End;
use super::ending::{NotReached, Reached};
use super::places::Places;
use super::target::Target;

/// Positions of which no joint differs by more, rad or m, are one solution.
const SAME: f64 = 1e-3;

impl<D: Size, P: Places<D>> InverseKinematics<D, P> {
    /// Distinct joint positions that reach the targets, at most so many, those nearest to `start` first.
    ///
    /// All attempts are made, or as many as it takes to find `most`. It proves nothing: a solution that few starts lead to may be
    /// missed, and the more `attempts` the less likely. Where the targets leave the joints a freedom, solutions are
    /// families without end, of which some members are returned.
    ///
    /// # Errors
    ///
    /// As [`solve`](InverseKinematics::solve), if there are none.
    pub fn solutions(
        &self,
        targets: &[Target],
        start: &D::Vector,
        most: usize,
    ) -> Result<Vec<Reached<D>>, NotReached<D>> {
        let mut attempts = self.begin(targets, start)?;
        let mut found: Vec<Reached<D>> = Vec::new();
        while let Some(descent) = attempts.next() {
            if descent.end != End::Reached {
                continue;
            }
            let reached = attempts.reached(descent.q);
            let differs = |known: &Reached<D>| self.joints.distance(&known.q, &reached.q) > SAME;
            if found.iter().all(differs) {
                found.push(reached);
            }
            if found.len() >= most {
                break;
            }
        }
        if found.is_empty() {
            found.push(attempts.finish()?);
        }
        let distance = |reached: &Reached<D>| (reached.q.clone() - start.clone()).largest();
        found.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
        Ok(found)
    }
}
