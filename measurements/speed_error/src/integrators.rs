//! Integrators: the error at the end of a motion against the work that it took.

use std::hint::black_box;

use measuring::{median_of_runs, power};
use robot_dynamics::nalgebra::SVector;
use robot_dynamics::{
    DoubleDouble, ForwardDynamics, Method, Simulation, SimulationError, TaylorSimulation,
    Trajectory,
    simulation::{Dop853, DormandPrince, Radau5, Taylor, TaylorDynamics},
};

use crate::reference_motion::{Phase, motion};

/// A family of methods: by the number of steps, or by the tolerance.
#[derive(Clone, Copy)]
pub(crate) struct Family {
    pub(crate) name: &'static str,
    kind: Kind,
}

#[derive(Clone, Copy)]
enum Kind {
    /// Powers of two of steps, from and to, and the method of a step.
    Fixed(u32, u32, fn(f64) -> Method),
    /// By powers of ten of the tolerance, from 1e-2 down to 1e-14.
    Adaptive(fn(f64) -> Method),
}

/// Every method that the runtime has.
pub(crate) const FAMILIES: [Family; 10] = [
    fixed("Euler", 6, 17, |step| Method::ExplicitEuler { step }),
    fixed("Craig's Euler", 6, 17, |step| Method::CraigEuler { step }),
    fixed("semi-implicit Euler", 6, 17, |step| {
        Method::SemiImplicitEuler { step }
    }),
    fixed("RK4", 5, 15, |step| Method::RungeKutta4 { step }),
    fixed("implicit midpoint", 5, 14, |step| {
        Method::ImplicitMidpoint { step }
    }),
    fixed("Gauss-Legendre 4", 4, 12, |step| Method::GaussLegendre4 {
        step,
    }),
    fixed("Gauss-Legendre 6", 4, 11, |step| Method::GaussLegendre6 {
        step,
    }),
    adaptive("Dormand-Prince 5(4)", |tolerance| {
        DormandPrince::with_tolerance(tolerance).into()
    }),
    adaptive("DOP853", |tolerance| {
        Dop853::with_tolerance(tolerance).into()
    }),
    adaptive("Radau IIA 5", |tolerance| {
        Radau5::with_tolerance(tolerance).into()
    }),
];

const fn fixed(name: &'static str, from: u32, to: u32, method: fn(f64) -> Method) -> Family {
    Family {
        name,
        kind: Kind::Fixed(from, to, method),
    }
}

const fn adaptive(name: &'static str, method: fn(f64) -> Method) -> Family {
    Family {
        name,
        kind: Kind::Adaptive(method),
    }
}

impl Family {
    /// The methods that are run, with what distinguishes them: the step or the tolerance.
    pub(crate) fn methods(&self, duration: f64, quick: bool) -> Vec<(f64, Method)> {
        let by = if quick { 3 } else { 1 };
        match self.kind {
            Kind::Fixed(from, to, method) => {
                let to = if quick { to.min(12) } else { to };
                let steps = (from..=to).step_by(by);
                let lengths = steps.map(|power| duration / f64::from(1_u32 << power));
                lengths.map(|step| (step, method(step))).collect()
            }
            Kind::Adaptive(method) => {
                let tolerances = (2..=14).step_by(by).map(|power| 10_f64.powi(-power));
                tolerances
                    .map(|tolerance| (tolerance, method(tolerance)))
                    .collect()
            }
        }
    }

    /// The method of this family that makes steps of `step`, or whose tolerance is `tolerance`.
    pub(crate) fn method(&self, step: f64, tolerance: f64) -> (Method, String) {
        match self.kind {
            Kind::Fixed(_, _, method) => (method(step), format!("step {step} s")),
            Kind::Adaptive(method) => (method(tolerance), format!("tolerance {tolerance:.0e}")),
        }
    }
}

/// One run of a method.
#[derive(Clone, Debug)]
pub(crate) struct Run {
    /// The longest step, s, or the tolerance.
    pub(crate) parameter: f64,
    pub(crate) nanoseconds: f64,
    pub(crate) evaluations: u64,
    /// The largest error of a position at the end, or why the end was not reached.
    pub(crate) error: Result<f64, String>,
}

impl Run {
    /// The error, where it is one: a run that ended beyond a radian from the truth has none.
    pub(crate) fn small_error(&self) -> Option<f64> {
        let error = self.error.as_ref().ok().copied()?;
        (error < 1.0).then_some(error)
    }
}

/// The runs of a method on a problem.
pub(crate) struct Curve {
    pub(crate) method: &'static str,
    pub(crate) runs: Vec<Run>,
    /// The order that fits the errors between the largest and the floor.
    pub(crate) order: Option<f64>,
}

/// A problem with the runs of all methods.
pub(crate) struct Problem {
    pub(crate) name: &'static str,
    pub(crate) text: String,
    /// The rounding of the initial state, as the motion makes it grow.
    pub(crate) floor: f64,
    pub(crate) curves: Vec<Curve>,
}

/// A motion, and where it ends.
pub(crate) struct Setting<'a, R, const N: usize> {
    pub(crate) name: &'static str,
    pub(crate) arm: &'a R,
    pub(crate) q: SVector<f64, N>,
    pub(crate) qd: SVector<f64, N>,
    pub(crate) duration: f64,
}

/// The name of the Taylor method, which has a simulation of its own.
pub(crate) const TAYLOR: &str = "Taylor";

impl<R: ForwardDynamics<N> + TaylorDynamics<N>, const N: usize> Setting<'_, R, N> {
    /// Runs every method; the motion's end is known, and how much the motion makes of a unit
    /// change of its start.
    pub(crate) fn problem(
        &self,
        text: String,
        end: &SVector<DoubleDouble, N>,
        growth: f64,
        quick: bool,
    ) -> Problem {
        let start = self.q.iter().chain(&self.qd);
        let size = start.fold(1.0, |size: f64, x| size.max(x.abs()));
        let floor = growth * size * f64::EPSILON / 2.0;
        let mut curves: Vec<_> = (FAMILIES.iter())
            .map(|family| {
                let methods = family.methods(self.duration, quick).into_iter();
                let runs = methods.map(|(parameter, method)| self.run(parameter, method, end));
                curve(family.name, runs.collect(), floor)
            })
            .collect();
        let by = if quick { 3 } else { 1 };
        let tolerances = (2..=16).step_by(by).map(|power| 10_f64.powi(-power));
        let runs = tolerances.map(|tolerance| self.taylor(tolerance, end));
        curves.push(curve(TAYLOR, runs.collect(), floor));
        Problem {
            name: self.name,
            floor,
            curves,
            text,
        }
    }

    fn run(&self, parameter: f64, method: Method, end: &SVector<DoubleDouble, N>) -> Run {
        let simulation = Simulation::new(self.arm)
            .method(method)
            .initial(self.q, self.qd)
            .duration(self.duration)
            .samples(2);
        timed(parameter, end, || black_box(&simulation).run())
    }

    fn taylor(&self, tolerance: f64, end: &SVector<DoubleDouble, N>) -> Run {
        let simulation = TaylorSimulation::new(self.arm)
            .settings(Taylor::with_tolerance(tolerance))
            .initial(self.q, self.qd)
            .duration(self.duration)
            .samples(2);
        timed(tolerance, end, || black_box(&simulation).run())
    }

    /// The end of the motion in 31 digits, its error as the difference to half as many steps, and
    /// the growth of a unit change of the start, from changes of 1e-12 in every coordinate.
    pub(crate) fn reference(&self, steps: u32) -> (SVector<DoubleDouble, N>, f64, f64) {
        let start = Phase::new(self.q, self.qd);
        let end = motion(self.arm, start, self.duration, steps);
        let half = motion(self.arm, start, self.duration, steps / 2);
        let error = end.distance(&half);
        let change = DoubleDouble::from(1e-12);
        let growth = (0..2 * N).map(|i| {
            let mut changed = start;
            match i.checked_sub(N) {
                None => changed.q[i] += change,
                Some(i) => changed.qd[i] += change,
            }
            let end_of_changed = motion(self.arm, changed, self.duration, steps / 2);
            end_of_changed.distance(&half) / 1e-12
        });
        (end.q, error, growth.fold(0.0, f64::max))
    }
}

fn curve(method: &'static str, runs: Vec<Run>, floor: f64) -> Curve {
    let order = fitted_order(&runs, floor);
    Curve {
        method,
        runs,
        order,
    }
}

/// Runs a simulation until the median of its times means something.
fn timed<const N: usize>(
    parameter: f64,
    end: &SVector<DoubleDouble, N>,
    simulate: impl Fn() -> Result<Trajectory<N>, Box<SimulationError<N>>>,
) -> Run {
    let (outcome, seconds) = median_of_runs(simulate);
    let (evaluations, error) = match outcome {
        Ok(trajectory) => {
            let found = trajectory.q.last().map(|q| q.map(DoubleDouble::from) - end);
            let error = found.map_or(f64::NAN, |error| {
                let largest = |largest: f64, x: &DoubleDouble| x.high().abs().max(largest);
                error.iter().fold(0.0, largest)
            });
            (trajectory.work.evaluations, Ok(error))
        }
        Err(stopped) => {
            let evaluations = stopped.trajectory.work.evaluations;
            (
                evaluations,
                Err(format!("at {:.3} s: {:?}", stopped.time, stopped.cause)),
            )
        }
    };
    Run {
        parameter,
        nanoseconds: 1e9 * seconds,
        evaluations,
        error,
    }
}

/// The slope of log error over log evaluations, by least squares over the errors that are
/// neither of the size of the motion nor near the floor.
fn fitted_order(runs: &[Run], floor: f64) -> Option<f64> {
    let points: Vec<_> = (runs.iter())
        .filter_map(|run| {
            let error = run.small_error()?;
            let usable = error < 3e-2 && error > 100.0 * floor.max(1e-15);
            usable.then_some((run.evaluations as f64, error))
        })
        .collect();
    power(&points).map(|power| -power)
}

/// The work at which a method reaches an error, between the runs on both sides of it:
/// ns and evaluations.
pub(crate) fn work_at(curve: &Curve, error: f64) -> Option<(f64, f64)> {
    let points: Vec<_> = (curve.runs.iter())
        .filter_map(|run| Some((run.small_error()?, run.nanoseconds, run.evaluations as f64)))
        .collect();
    let last = points.iter().position(|point| point.0 <= error)?;
    let (e1, t1, n1) = points[last];
    let Some((e0, t0, n0)) = last.checked_sub(1).map(|before| points[before]) else {
        return Some((t1, n1));
    };
    if e1 == 0.0 || e0 <= error {
        return Some((t1, n1));
    }
    let share = (e0 / error).ln() / (e0 / e1).ln();
    let between = |a: f64, b: f64| a * (b / a).powf(share);
    Some((between(t0, t1), between(n0, n1)))
}
