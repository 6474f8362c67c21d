//! Descents from the start and from elsewhere, until one reaches the targets.

use dynamics_runtime::internal::{SplitMix64, first_non_finite};
use dynamics_runtime::{JointVector as _, Size};

use super::InverseKinematics;
use super::descent::{Descent, End};
use super::ending::{NotReached, Reached, Reason, Residual};
use super::joints::Joints;
use super::places::Places;
use super::problem::Problem;
use super::target::{Target, length};

impl<D: Size, P: Places<D>> InverseKinematics<D, P> {
    /// Joint positions at which the only frame, or the tip, reaches a target: a [`Target`], or a pose as a
    /// `&Matrix4<f64>`.
    ///
    /// The search begins at `start`; what further attempts find may be anywhere within the limits. Whole turns of joints are
    /// those nearest to `start`, as far as limits allow them.
    ///
    /// # Errors
    ///
    /// [`NotReached`], whose [`Reason`] has a variant for each cause.
    pub fn solve(
        &self,
        target: impl Into<Target>,
        start: &D::Vector,
    ) -> Result<Reached<D>, NotReached<D>> {
        self.solve_all(&[target.into()], start)
    }

    /// The same of several frames, with a target for each, in their order.
    ///
    /// # Errors
    ///
    /// As [`solve`](InverseKinematics::solve).
    pub fn solve_all(
        &self,
        targets: &[Target],
        start: &D::Vector,
    ) -> Result<Reached<D>, NotReached<D>> {
        let mut attempts = self.begin(targets, start)?;
        while let Some(descent) = attempts.next() {
            if descent.end == End::Reached {
                return Ok(attempts.reached(descent.q));
            }
        }
        attempts.finish()
    }

    /// How far the frames are from their targets at joint positions: the largest distance and the largest angle.
    pub fn residual(&self, targets: &[Target], q: &D::Vector) -> Residual {
        let indexed = targets.iter().enumerate();
        indexed.fold(Residual::default(), |all, (index, target)| {
            all.and(&target.error(&self.places.place(index, q).0))
        })
    }

    /// The attempts that may be made.
    pub(super) fn begin<'s>(
        &'s self,
        targets: &'s [Target],
        start: &'s D::Vector,
    ) -> Result<Attempts<'s, D, P>, NotReached<D>> {
        if let Some(reason) = self.refusal(targets, start) {
            let (position, rotation) = (f64::NAN, f64::NAN);
            return Err(NotReached {
                reason,
                q: start.clone(),
                residual: Residual { position, rotation },
                attempts: 0,
                iterations: 0,
                #[cfg(feature = "std")]
                joint_names: Vec::new(),
            });
        }
        let too_far = self.too_far(targets);
        let problem = Problem {
            solver: self,
            joints: &self.joints,
            targets,
        };
        Ok(Attempts {
            problem,
            start,
            random: SplitMix64(self.seed),
            // Positions near the start are as good as any.
            most: if too_far.is_some() { 1 } else { self.attempts },
            too_far,
            free: self.joints.without_limits(),
            moving: None,
            beyond: None,
            made: 0,
            iterations: 0,
            best: None,
        })
    }

    /// The reason why there can be no search, if there is one.
    fn refusal(&self, targets: &[Target], start: &D::Vector) -> Option<Reason> {
        let (frames, dof) = (self.places.count(), self.joints.size.value());
        let posture = self.posture.as_ref().unwrap_or(start);
        let lengths = [
            start.entries().len(),
            posture.entries().len(),
            self.joints.limits.as_ref().len(),
        ];
        if frames != targets.len() {
            let targets = targets.len();
            return Some(Reason::Count { targets, frames });
        }
        if lengths != [dof; 3] {
            return Some(Reason::Length);
        }
        let mut unknown = [start, posture].into_iter();
        let start = unknown.find_map(|q| first_non_finite(q.entries()));
        let target = targets.iter().position(|target| !target.is_possible());
        let of_target = target.map(|target| Reason::Target { target });
        let of_start = start.map(|joint| Reason::Start { joint });
        let range = self.joints.without_range();
        let of_range = range.map(|joint| Reason::Range { joint });
        let of_tolerance = (!self.tolerance.is_possible()).then_some(Reason::Tolerance);
        of_target.or(of_start).or(of_range).or(of_tolerance)
    }

    /// The first target that is farther away than the arm is long.
    fn too_far(&self, targets: &[Target]) -> Option<Reason> {
        // The lengths are added up with rounding errors.
        let reach = self.joints.reach * (1.0 + 1e-9);
        let mut indexed = targets.iter().enumerate();
        indexed.find_map(|(target, wanted)| {
            let distance = length(&(wanted.position? - self.joints.base));
            (distance > reach + self.tolerance.of_positions()).then_some(Reason::OutOfReach {
                target,
                distance,
                reach,
            })
        })
    }
}

/// The descents of one search.
pub(super) struct Attempts<'s, D: Size, P> {
    problem: Problem<'s, D, P>,
    start: &'s D::Vector,
    random: SplitMix64,
    most: usize,
    too_far: Option<Reason>,
    /// The joints without limits, if they have some.
    free: Option<Joints<D>>,
    /// The joints that move a frame, once they are known.
    moving: Option<D::Each<bool>>,
    /// The joint that is beyond its limit where the targets were reached beyond limits, and by how much: the least.
    beyond: Option<(usize, f64)>,
    made: usize,
    iterations: usize,
    /// The descent that came nearest without reaching the targets.
    best: Option<Descent<D>>,
}

impl<D: Size, P: Places<D>> Attempts<'_, D, P> {
    /// Makes the next one: the first from the start, others from anywhere, every second of them without limits at first.
    pub(super) fn next(&mut self) -> Option<Descent<D>> {
        let solver = self.problem.solver;
        if self.made == self.most {
            return None;
        }
        let start = match self.made {
            0 => solver.joints.within(self.start),
            // Ways around limits, and turns that end within them, reach what is cut off by limits.
            made if made % 2 == 1 => {
                let start = self.elsewhere();
                self.beyond_limits(start)
            }
            _ => self.elsewhere(),
        };
        self.made += 1;
        // Towards a target out of reach nothing goes but the last descent.
        let most = self.too_far.map_or(solver.iterations, |_| 0);
        let descent = self.problem.descend(start, most);
        self.iterations += descent.iterations;
        let best = self.best.as_ref();
        let is_nearer = best.is_none_or(|best| descent.error < best.error || best.error.is_nan());
        if descent.end != End::Reached && is_nearer {
            self.best = Some(descent.clone());
        }
        Some(descent)
    }

    /// Positions from anywhere. Joints that move no frame are where they began.
    fn elsewhere(&mut self) -> D::Vector {
        let Problem { joints, .. } = self.problem;
        let (start, q) = (
            joints.within(self.start),
            joints.anywhere(&mut self.random, self.start),
        );
        let moving = self
            .moving
            .get_or_insert_with(|| self.problem.moving(&start));
        let position = |joint: usize| {
            if moving[joint] {
                q[joint]
            } else {
                start[joint]
            }
        };
        joints.size.vector_of(position)
    }

    /// Where a descent without limits ends, put within them: whole turns bring some joints there.
    fn beyond_limits(&mut self, start: D::Vector) -> D::Vector {
        let Some(free) = &self.free else {
            return start;
        };
        let problem = Problem {
            joints: free,
            ..self.problem
        };
        let descent = problem.descend(start, problem.solver.iterations);
        self.iterations += descent.iterations;
        let joints = self.problem.joints;
        let q = joints.nearest(&descent.q, self.start);
        let reached = (descent.end == End::Reached).then(|| joints.farthest_beyond(&q));
        if let Some(beyond) = reached.flatten() {
            let is_less = self.beyond.is_none_or(|(_, least)| beyond.1 < least);
            self.beyond = if is_less { Some(beyond) } else { self.beyond };
        }
        joints.within(&q)
    }

    /// The end of a search that found nothing: what came nearest, which may be a target after all.
    pub(super) fn finish(mut self) -> Result<Reached<D>, NotReached<D>> {
        let nearest = self.best.take().expect("an attempt");
        let last = self.problem.settle(nearest.q);
        self.iterations += last.iterations;
        match last.end {
            End::Reached => Ok(self.reached(last.q)),
            _ => {
                if self.beyond.is_none() && self.too_far.is_none() {
                    self.beyond_limits(last.q.clone());
                }
                Err(self.not_reached(last))
            }
        }
    }

    pub(super) fn reached(&self, q: D::Vector) -> Reached<D> {
        let q = self.arranged(q);
        Reached {
            residual: self.problem.solver.residual(self.problem.targets, &q),
            q,
            attempts: self.made,
            iterations: self.iterations,
        }
    }

    /// Near the preferred posture, or else with those whole turns that are nearest to the start.
    fn arranged(&self, q: D::Vector) -> D::Vector {
        let (problem, solver) = (&self.problem, self.problem.solver);
        let near = solver.posture.as_ref().unwrap_or(self.start);
        let turned = solver.joints.nearest(&q, near);
        let is_within = solver.joints.within(&turned) == turned;
        let holds = is_within && problem.normal_at(&turned).is_reached;
        let q = if holds { turned } else { q };
        match &solver.posture {
            Some(posture) => problem.approach(q, posture),
            None => q,
        }
    }

    fn not_reached(&self, last: Descent<D>) -> NotReached<D> {
        let reason = match (self.too_far, last.end) {
            (Some(too_far), _) => too_far,
            (None, End::NonFinite) => Reason::NonFinite,
            (None, End::Iterations) => Reason::Iterations,
            (None, _) => self
                .beyond
                .map_or(Reason::Minimum, |(joint, _)| Reason::Limits { joint }),
        };
        NotReached {
            reason,
            residual: self.problem.solver.residual(self.problem.targets, &last.q),
            q: last.q,
            attempts: self.made,
            iterations: self.iterations,
            #[cfg(feature = "std")]
            joint_names: Vec::new(),
        }
    }
}
