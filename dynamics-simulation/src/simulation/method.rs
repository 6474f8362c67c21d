//! The methods of integration.

use dynamics_runtime::Size;

use super::by_margins::ByMargins;
use super::drive::drive;
use super::motion::{InMomenta, Motion};
use super::settings::{Dop853, DormandPrince, ErrorControl, Radau5, validate_step};

use super::error::{Cause, InvalidSetting};
use super::plan::Plan;
use super::recorder::Recorder;
use crate::integrate::{
    Adaptive, Dop853Method, DormandPrince54, Euler, FixedStep, GaussLegendre, OneStep, Phase,
    Radau, Rk4, StepRange, Stepper, Tolerance,
};

/// A method of integration.
///
/// The methods of fixed step divide the interval between two samples into the least number of equal steps that are no
/// longer than `step`: every sample is the end of a step. An infinite `step` is an error, because it says nothing of
/// accuracy. So is one that makes more than 100 000 steps between two samples, or 10 million in a run of fewer than 101
/// samples; periods at which laws are sampled count too.
///
/// On a base that moves, the explicit methods follow its rotation in charts, as H. Munthe-Kaas did (1999); those of this
/// list from the implicit midpoint rule to Gauss-Legendre, and Radau IIA, refuse it.
///
/// # Structure-preserving methods
///
/// [`ImplicitMidpoint`](Method::ImplicitMidpoint) and the Gauss-Legendre methods keep the energy of a
/// frictionless motion near its value for as long as it lasts: their error does not grow. They are
/// symplectic in positions and momenta, so that they carry p = M(q) qd and solve
///
/// `q' = M^-1 p`, `p' = dT/dq - G - F + tau`, `dT/dq = C' qd`,
///
/// by iteration to rounding, with compensated sums. The arm must be known in momenta
/// ([`ForwardDynamics::momenta`](dynamics_runtime::ForwardDynamics::momenta)). The step must be short beside the fastest of the motion's time
/// constants, or the iteration does not converge ([`Cause::NoConvergence`]).
///
/// The same methods in (q, qd) would need no momenta, and are not enough. Over 10^6 steps of 10 ms the energy of a
/// two-link arm in free fall, which exchanges 54 J, stayed within 1e-5 J by Gauss-Legendre of order 4 in (q, p),
/// averaged over each 500 s. In (q, qd) it walked away by 2e-4 J. By semi-implicit Euler, which is symplectic for a
/// constant M alone, the same arm lost 80 % of its energy within 100 s, or flew away.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub enum Method {
    /// Euler's explicit method: `qd+ = qd + qdd h`, `q+ = q + qd h`. First order.
    ///
    /// It is here to be compared with: a swing without friction gains energy at every step.
    ExplicitEuler {
        /// The longest step, s: positive and finite.
        step: f64,
    },
    /// Euler's scheme as Craig has it, (6.117): `qd+ = qd + qdd h`, `q+ = q + qd h + qdd h^2 / 2`
    /// with the old velocity in the second equation. First order.
    CraigEuler {
        /// The longest step, s: positive and finite.
        step: f64,
    },
    /// The semi-implicit Euler scheme: `qd+ = qd + qdd h`, `q+ = q + qd+ h`. First order; symplectic
    /// only where the mass matrix does not depend on q.
    SemiImplicitEuler {
        /// The longest step, s: positive and finite.
        step: f64,
    },
    /// The classical Runge-Kutta method. Fourth order.
    RungeKutta4 {
        /// The longest step, s: positive and finite.
        step: f64,
    },
    /// The implicit midpoint rule in positions and momenta. Second order, symplectic.
    ImplicitMidpoint {
        /// The longest step, s: positive and finite.
        step: f64,
    },
    /// The Gauss-Legendre method of two stages in positions and momenta. Fourth order, symplectic.
    GaussLegendre4 {
        /// The longest step, s: positive and finite.
        step: f64,
    },
    /// The Gauss-Legendre method of three stages in positions and momenta. Sixth order, symplectic.
    GaussLegendre6 {
        /// The longest step, s: positive and finite.
        step: f64,
    },
    /// The Dormand-Prince method of order 5(4) with error control and dense output.
    DormandPrince(DormandPrince),
    /// DOP853, the method of order 8(5,3) of Dormand and Prince, with error control and dense
    /// output.
    Dop853(Dop853),
    /// The Radau IIA method of order 5, implicit, for stiff arms, with error control and dense
    /// output.
    Radau5(Radau5),
}

impl Default for Method {
    /// [`DormandPrince`] with its default settings.
    fn default() -> Self {
        Method::DormandPrince(DormandPrince::default())
    }
}

impl Method {
    /// Whether its steps need no equations solved.
    fn is_explicit(&self) -> bool {
        match self {
            Method::ExplicitEuler { .. }
            | Method::CraigEuler { .. }
            | Method::SemiImplicitEuler { .. }
            | Method::RungeKutta4 { .. }
            | Method::DormandPrince(_)
            | Method::Dop853(_) => true,
            Method::ImplicitMidpoint { .. }
            | Method::GaussLegendre4 { .. }
            | Method::GaussLegendre6 { .. }
            | Method::Radau5(_) => false,
        }
    }
}

macro_rules! from_settings {
    ($($name:ident)*) => {$(
        impl From<$name> for Method {
            fn from(settings: $name) -> Self {
                Method::$name(settings)
            }
        }
    )*};
}

from_settings! { DormandPrince Dop853 Radau5 }

/// The integration of a motion by a method.
type Integrate<D> = fn(&Method, &Motion<D>, &mut Recorder<D>) -> Result<(), Cause>;

/// A method, and the integration by it: that of the default method is compiled without all others.
#[derive(Clone, Debug)]
pub(super) struct Chosen<D: Size> {
    method: Method,
    integrate: Integrate<D>,
}

impl<D: Size> Chosen<D> {
    /// The default method, with its default settings.
    pub(super) fn by_default() -> Self {
        Chosen {
            method: Method::default(),
            integrate: |_, motion, recorder| {
                by_dormand_prince(DormandPrince::default(), motion, recorder)
            },
        }
    }

    /// A method that is known at run time.
    pub(super) fn new(method: Method) -> Self {
        Chosen {
            method,
            integrate: |method, motion, recorder| method.integrate(motion, recorder),
        }
    }
}

impl<D: Size> Integrator<D> for Chosen<D> {
    fn validate(&self, motion: &Motion<D>, plan: &Plan) -> Result<(), InvalidSetting> {
        self.method.validate(motion, plan)
    }

    fn straight_step(&self) -> f64 {
        match self.method {
            Method::ExplicitEuler { step } => step,
            _ => 0.0,
        }
    }

    fn integrate(&self, motion: &Motion<D>, recorder: &mut Recorder<D>) -> Result<(), Cause> {
        (self.integrate)(&self.method, motion, recorder)
    }
}

/// A method, and its settings, as a run needs them.
pub(super) trait Integrator<D: Size> {
    /// Whether the settings make sense for a run.
    fn validate(&self, motion: &Motion<D>, plan: &Plan) -> Result<(), InvalidSetting>;

    /// The step of a method whose positions are straight lines within a step; 0 of the others.
    fn straight_step(&self) -> f64 {
        0.0
    }

    /// Makes the run from where it begins.
    fn integrate(&self, motion: &Motion<D>, recorder: &mut Recorder<D>) -> Result<(), Cause>;
}

impl Method {
    fn integrate<D: Size>(
        &self,
        motion: &Motion<D>,
        recorder: &mut Recorder<D>,
    ) -> Result<(), Cause> {
        match *self {
            Method::ExplicitEuler { step } => {
                fixed(Euler::Explicit, step, motion, motion, recorder)
            }
            Method::CraigEuler { step } => fixed(Euler::Craig, step, motion, motion, recorder),
            Method::SemiImplicitEuler { step } => {
                fixed(Euler::SemiImplicit, step, motion, motion, recorder)
            }
            Method::RungeKutta4 { step } => fixed(Rk4, step, motion, motion, recorder),
            Method::ImplicitMidpoint { step } => {
                canonical(GaussLegendre::order_2(), step, motion, recorder)
            }
            Method::GaussLegendre4 { step } => {
                canonical(GaussLegendre::order_4(), step, motion, recorder)
            }
            Method::GaussLegendre6 { step } => {
                canonical(GaussLegendre::order_6(), step, motion, recorder)
            }
            Method::DormandPrince(settings) => by_dormand_prince(settings, motion, recorder),
            Method::Dop853(settings) => {
                let start = Adaptive::<Dop853Method, D>::start;
                controlled(settings.control(), motion, recorder, start)
            }
            Method::Radau5(settings) => {
                controlled(settings.control(), motion, recorder, Radau::start)
            }
        }
    }

    fn validate<D: Size>(&self, motion: &Motion<D>, plan: &Plan) -> Result<(), InvalidSetting> {
        if motion.moves && !self.is_explicit() {
            return Err(InvalidSetting::MovingBase);
        }
        match self {
            Method::ExplicitEuler { step }
            | Method::CraigEuler { step }
            | Method::SemiImplicitEuler { step }
            | Method::RungeKutta4 { step }
            | Method::ImplicitMidpoint { step }
            | Method::GaussLegendre4 { step }
            | Method::GaussLegendre6 { step } => {
                validate_step(*step, plan.duration)?;
                plan.validate_steps(*step, motion.torque.period())
            }
            Method::DormandPrince(settings) => settings.control().validate(plan.duration),
            Method::Dop853(settings) => settings.control().validate(plan.duration),
            Method::Radau5(settings) => settings.control().validate(plan.duration),
        }
    }
}

fn fixed<S, D: Size>(
    method: impl OneStep<S, Cause, D>,
    step: f64,
    motion: &Motion<D>,
    system: &S,
    recorder: &mut Recorder<D>,
) -> Result<(), Cause> {
    let mut run = FixedStep::start(method, recorder.grid(step), recorder.phase.clone());
    follow(motion, system, &mut run, recorder, None)
}

fn canonical<const STAGES: usize, D: Size>(
    method: GaussLegendre<STAGES, D>,
    step: f64,
    motion: &Motion<D>,
    recorder: &mut Recorder<D>,
) -> Result<(), Cause> {
    let system = InMomenta::new(motion).ok_or(InvalidSetting::NoMomenta)?;
    fixed(method, step, motion, &system, recorder)
}

fn by_dormand_prince<D: Size>(
    settings: DormandPrince,
    motion: &Motion<D>,
    recorder: &mut Recorder<D>,
) -> Result<(), Cause> {
    let start = Adaptive::<DormandPrince54, D>::start;
    controlled(settings.control(), motion, recorder, start)
}

/// A run under error control, by the stepper that `start` makes.
fn controlled<'m, K, D: Size>(
    control: ErrorControl,
    motion: &Motion<'m, D>,
    recorder: &mut Recorder<D>,
    start: impl FnOnce(&Motion<'m, D>, Phase<D>, Tolerance, StepRange) -> Result<K, Cause>,
) -> Result<(), Cause>
where
    K: Stepper<Motion<'m, D>, Cause, D>,
{
    let (range, phase) = (control.range(recorder.duration), recorder.phase.clone());
    let mut run = start(motion, phase, control.tolerance, range)?;
    follow(motion, motion, &mut run, recorder, Some(control)).map_err(Cause::of_long_steps)
}

/// Follows a motion by a stepper that is known at run time alone.
fn follow<S, D: Size>(
    motion: &Motion<D>,
    system: &S,
    stepper: &mut dyn Stepper<S, Cause, D>,
    recorder: &mut Recorder<D>,
    control: Option<ErrorControl>,
) -> Result<(), Cause> {
    drive::<ByMargins, _, _, _>(motion, system, stepper, recorder, control)
}
