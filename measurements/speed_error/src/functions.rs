//! Every function of an arm in every variant: time and errors.

use measuring::Effort;
use robot_dynamics::nalgebra::{SMatrix, SVector};
use robot_dynamics::{
    Batch, Certified, CoriolisVector, DoubleDouble, ForwardDynamics, GravityVector,
    InverseDynamics, MassMatrix, Model, NewtonEuler, SingularMassMatrix, certified, table::Table,
};
use testkit::exact::Exact;
use testkit::five::Five;

use crate::errors::{AtState, Errors};
use crate::number::{BUILT_FUSED, Number, Otherwise, can_fuse, with_fused_instructions};
use crate::samples::{Samples, State, Values};

/// The functions that are measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Function {
    M,
    V,
    G,
    Tau,
    Qdd,
}

impl Function {
    pub(crate) const ALL: [Function; 5] = [
        Function::M,
        Function::V,
        Function::G,
        Function::Tau,
        Function::Qdd,
    ];

    /// The symbol of the quantity.
    pub(crate) fn symbol(self) -> &'static str {
        match self {
            Function::M => "M",
            Function::V => "V",
            Function::G => "G",
            Function::Tau => "tau",
            Function::Qdd => "qdd",
        }
    }

    fn exact<const N: usize>(self, values: &Values<N>) -> Vec<DoubleDouble> {
        let all = |x: &[DoubleDouble]| x.to_vec();
        match self {
            Function::M => all(values.mass_matrix.as_slice()),
            Function::V => all(values.coriolis_vector.as_slice()),
            Function::G => all(values.gravity_vector.as_slice()),
            Function::Tau => all(values.inverse_dynamics.as_slice()),
            Function::Qdd => all(values.forward_dynamics.as_slice()),
        }
    }

    fn scale<const N: usize>(self, values: &Values<N>) -> f64 {
        match self {
            Function::M => values.scale.inertia,
            Function::V => values.scale.coriolis,
            Function::G => values.scale.gravity,
            Function::Tau | Function::Qdd => values.scale.torque,
        }
    }

    /// Bounds of errors as errors are judged: those of accelerations by the torques that they take at most.
    fn judged_bounds<const N: usize>(self, bounds: &[f64], values: &Values<N>) -> Vec<f64> {
        match self {
            Function::Qdd => {
                let m = values.mass_matrix.map(|x| x.high().abs());
                (m * SVector::<_, N>::from_column_slice(bounds))
                    .as_slice()
                    .to_vec()
            }
            _ => bounds.to_vec(),
        }
    }

    /// Computed values beside exact ones. Accelerations are judged by the torques that
    /// their errors take, M (qdd - exact qdd).
    fn at_state<const N: usize>(self, computed: Vec<DoubleDouble>, values: &Values<N>) -> AtState {
        let exact = self.exact(values);
        let errors: Vec<_> = computed.iter().zip(&exact).map(|(x, y)| *x - *y).collect();
        let judged = match self {
            Function::Qdd => (values.mass_matrix * SVector::<_, N>::from_column_slice(&errors))
                .iter()
                .map(|x| x.high())
                .collect(),
            _ => errors.iter().map(|x| x.high()).collect(),
        };
        AtState {
            computed,
            exact,
            judged,
            scale: self.scale(values),
        }
    }
}

/// A way to compute the functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Variant {
    /// The generated function in doubles, as this program was built.
    F64,
    /// The same with sums of products fused where they were apart, and apart where they were fused.
    F64Otherwise,
    F32,
    /// The generated function at many states in the lanes of vectors.
    Lanes,
    /// Recursive Newton-Euler for torques, composite bodies for M, both and a factorisation for
    /// accelerations, from the table.
    Numeric,
    /// Articulated bodies, from the table.
    Articulated,
    /// The textbook's formulas, as they come from the Lagrangian.
    Textbook,
}

impl Variant {
    pub(crate) const ALL: [Variant; 7] = [
        Variant::F64,
        Variant::F64Otherwise,
        Variant::F32,
        Variant::Lanes,
        Variant::Numeric,
        Variant::Articulated,
        Variant::Textbook,
    ];

    pub(crate) fn name(self) -> &'static str {
        match (self, BUILT_FUSED) {
            (Variant::F64, false) => "f64",
            (Variant::F64, true) => "f64, fused",
            (Variant::F64Otherwise, false) => "f64, fused",
            (Variant::F64Otherwise, true) => "f64, not fused",
            (Variant::F32, _) => "f32",
            (Variant::Lanes, _) => "f64 in lanes",
            (Variant::Numeric, _) => "numeric RNEA, CRBA",
            (Variant::Articulated, _) => "numeric ABA",
            (Variant::Textbook, _) => "textbook expansion",
        }
    }
}

/// One measurement.
#[derive(Clone, Debug)]
pub(crate) struct Measured {
    pub(crate) robot: &'static str,
    pub(crate) joints: usize,
    pub(crate) function: Function,
    pub(crate) variant: Variant,
    pub(crate) nanoseconds: f64,
    pub(crate) errors: Errors,
    /// The largest proven bound of an error, as the largest error is judged; where it was asked for.
    pub(crate) bound: Option<f64>,
    /// In single precision, what half a unit in the last place of the arguments changes at the state of the largest
    /// error, over the same magnitude.
    pub(crate) conditioning: Option<f64>,
}

/// An arm that is measured.
pub(crate) trait Arm<const N: usize>: Model<N> + Five<N> {}

impl<R: Model<N> + Five<N>, const N: usize> Arm<N> for R {}

/// The measurements of an arm.
pub(crate) struct Measurements<const N: usize> {
    pub(crate) robot: &'static str,
    pub(crate) effort: Effort,
    pub(crate) samples: Samples<N>,
    pub(crate) all: Vec<Measured>,
}

impl<const N: usize> Measurements<N> {
    /// Every variant that every arm has, but for lanes.
    pub(crate) fn of<R: Arm<N>>(robot: &'static str, arm: &R, effort: Effort) -> Self {
        let mut measurements = Measurements {
            robot,
            effort,
            samples: Samples::of(&arm.table()),
            all: Vec::new(),
        };
        measurements.generated::<f64, R>(Variant::F64, arm);
        measurements.generated_otherwise(arm);
        measurements.generated::<f32, R>(Variant::F32, arm);
        measurements.proven(arm);
        measurements.numeric(&NewtonEuler::new(&arm.table()));
        measurements
    }

    fn generated<T: Number, R: Arm<N>>(&mut self, variant: Variant, arm: &R) {
        self.measure(Function::M, variant, |s: &State<T, N>| {
            arm.mass_matrix(&s.q)
        });
        self.measure(Function::V, variant, |s: &State<T, N>| {
            arm.coriolis_vector(&s.q, &s.qd)
        });
        self.measure(Function::G, variant, |s: &State<T, N>| {
            arm.gravity_vector(&s.q)
        });
        self.measure(Function::Tau, variant, |s: &State<T, N>| {
            arm.inverse_dynamics(&s.q, &s.qd, &s.qdd)
        });
        self.measure(Function::Qdd, variant, |s: &State<T, N>| {
            or_nan(arm.forward_dynamics(&s.q, &s.qd, &s.tau))
        });
    }

    /// The proven bounds of the errors in doubles.
    fn proven<R: Arm<N>>(&mut self, arm: &R) {
        self.bound(Function::M, |s| arm.mass_matrix(&s.q));
        self.bound(Function::V, |s| arm.coriolis_vector(&s.q, &s.qd));
        self.bound(Function::G, |s| arm.gravity_vector(&s.q));
        self.bound(Function::Tau, |s| arm.inverse_dynamics(&s.q, &s.qd, &s.qdd));
        self.bound(Function::Qdd, |s| {
            let qdd = certified::forward_dynamics(arm, &s.q, &s.qd, &s.tau);
            qdd.unwrap_or_else(|_| SVector::repeat(Certified::exact(f64::NAN)))
        });
    }

    /// The largest bound at all states, beside the errors that were measured in doubles.
    fn bound<const C: usize>(
        &mut self,
        function: Function,
        value: impl Fn(&State<Certified, N>) -> SMatrix<Certified, N, C>,
    ) {
        let states = self.samples.states_as(Certified::exact);
        let bounds = states
            .iter()
            .zip(&self.samples.values)
            .map(|(state, values)| {
                let bounds = value(state).map(|x| x.bound());
                let judged = function.judged_bounds(bounds.as_slice(), values);
                let over = |bound: f64| {
                    if bound == 0.0 {
                        0.0
                    } else {
                        bound / function.scale(values)
                    }
                };
                judged.into_iter().map(over).fold(0.0, f64::max)
            });
        let largest = bounds.fold(0.0, f64::max);
        let is_beside = |m: &&mut Measured| (m.function, m.variant) == (function, Variant::F64);
        for measured in self.all.iter_mut().filter(is_beside) {
            measured.bound = Some(largest);
        }
    }

    /// With fused instructions, which a plain build has only where they are asked for.
    fn generated_otherwise<R: Arm<N>>(&mut self, arm: &R) {
        type Number = Otherwise;
        if !BUILT_FUSED && !can_fuse() {
            return;
        }
        let variant = Variant::F64Otherwise;
        macro_rules! measure {
            ($function:ident, |$s:ident| $value:expr) => {
                self.measure(Function::$function, variant, |$s: &State<Number, N>| {
                    with_fused_instructions(
                        #[inline(always)]
                        || $value,
                    )
                });
            };
        }
        measure!(M, |s| MassMatrix::mass_matrix(arm, &s.q));
        measure!(V, |s| CoriolisVector::coriolis_vector(arm, &s.q, &s.qd));
        measure!(G, |s| GravityVector::gravity_vector(arm, &s.q));
        measure!(Tau, |s| InverseDynamics::inverse_dynamics(
            arm, &s.q, &s.qd, &s.qdd
        ));
        measure!(Qdd, |s| or_nan(ForwardDynamics::forward_dynamics(
            arm, &s.q, &s.qd, &s.tau
        )));
    }

    fn numeric(&mut self, arm: &NewtonEuler<N>) {
        let variant = Variant::Numeric;
        self.measure(Function::M, variant, |s: &State<f64, N>| {
            arm.mass_matrix(&s.q)
        });
        self.measure(Function::V, variant, |s: &State<f64, N>| {
            arm.coriolis_vector(&s.q, &s.qd)
        });
        self.measure(Function::G, variant, |s: &State<f64, N>| {
            arm.gravity_vector(&s.q)
        });
        self.measure(Function::Tau, variant, |s: &State<f64, N>| {
            arm.inverse_dynamics(&s.q, &s.qd, &s.qdd)
        });
        self.measure(Function::Qdd, variant, |s: &State<f64, N>| {
            or_nan(arm.forward_dynamics(&s.q, &s.qd, &s.tau))
        });
        self.measure(Function::Qdd, Variant::Articulated, |s: &State<f64, N>| {
            or_nan(arm.forward_dynamics_aba(&s.q, &s.qd, &s.tau))
        });
    }

    /// The textbook's programs.
    pub(crate) fn textbook<R>(
        robot: &'static str,
        arm: &R,
        table: &Table<N>,
        effort: Effort,
    ) -> Vec<Measured>
    where
        R: MassMatrix<N> + CoriolisVector<N> + GravityVector<N>,
    {
        let mut measurements = Measurements {
            robot,
            effort,
            samples: Samples::of(table),
            all: Vec::new(),
        };
        let variant = Variant::Textbook;
        measurements.measure(Function::M, variant, |s: &State<f64, N>| {
            arm.mass_matrix(&s.q)
        });
        measurements.measure(Function::V, variant, |s: &State<f64, N>| {
            arm.coriolis_vector(&s.q, &s.qd)
        });
        measurements.measure(Function::G, variant, |s: &State<f64, N>| {
            arm.gravity_vector(&s.q)
        });
        measurements.all
    }

    /// Errors at all states, the time of one evaluation at the ordinary ones.
    pub(crate) fn measure<T: Number, const R: usize, const C: usize>(
        &mut self,
        function: Function,
        variant: Variant,
        value: impl Fn(&State<T, N>) -> SMatrix<T, R, C>,
    ) {
        let states = self.samples.states::<T>();
        let found = states.iter().map(|state| {
            let value = value(state);
            value.iter().map(|x| x.exactly()).collect()
        });
        let errors = self.errors(function, found);
        let nanoseconds = self
            .effort
            .nanoseconds(&states[..self.samples.timed()], &value);
        self.record(function, variant, nanoseconds, errors);
    }

    /// Not in lanes.
    pub(crate) fn alone<R>(&mut self, _: &R) {}

    pub(crate) fn in_lanes<R: Arm<N>>(&mut self, arm: &R) {
        let states = self.samples.states::<f64>();
        let all = |part: fn(&State<f64, N>) -> SVector<f64, N>| -> Vec<_> {
            states.iter().map(part).collect()
        };
        let (q, qd) = (all(|s| s.q), all(|s| s.qd));
        let (qdd, tau) = (all(|s| s.qdd), all(|s| s.tau));
        self.batch(Function::M, |n, out: &mut [SMatrix<f64, N, N>]| {
            arm.mass_matrix_batch(&q[..n], out).is_ok()
        });
        self.batch(Function::V, |n, out: &mut [SVector<f64, N>]| {
            arm.coriolis_vector_batch(&q[..n], &qd[..n], out).is_ok()
        });
        self.batch(Function::G, |n, out: &mut [SVector<f64, N>]| {
            arm.gravity_vector_batch(&q[..n], out).is_ok()
        });
        self.batch(Function::Tau, |n, out: &mut [SVector<f64, N>]| {
            let (q, qd, qdd) = (&q[..n], &qd[..n], &qdd[..n]);
            arm.inverse_dynamics_batch(q, qd, qdd, out).is_ok()
        });
        self.batch(Function::Qdd, |n, out: &mut [SVector<f64, N>]| {
            let (q, qd, tau) = (&q[..n], &qd[..n], &tau[..n]);
            arm.forward_dynamics_batch(q, qd, tau, out).is_ok()
        });
    }

    /// A batch of all states for the errors, and one of the ordinary states for the time.
    fn batch<const C: usize>(
        &mut self,
        function: Function,
        run: impl Fn(usize, &mut [SMatrix<f64, N, C>]) -> bool,
    ) {
        let count = self.samples.values.len();
        let mut out = vec![SMatrix::<f64, N, C>::repeat(f64::NAN); count];
        run(count, &mut out);
        let found = out.iter().map(|value| {
            let value = value.iter().map(|x| x.exactly());
            value.collect()
        });
        let errors = self.errors(function, found);
        let timed = self.samples.timed();
        let time = self
            .effort
            .nanoseconds(&[()], |()| run(timed, &mut out[..timed]));
        self.record(function, Variant::Lanes, time / timed as f64, errors);
    }

    fn errors(&self, function: Function, found: impl Iterator<Item = Vec<DoubleDouble>>) -> Errors {
        let states = found.zip(&self.samples.values);
        let states: Vec<_> = states
            .map(|(found, values)| function.at_state(found, values))
            .collect();
        Errors::of(&states)
    }

    fn record(&mut self, function: Function, variant: Variant, nanoseconds: f64, errors: Errors) {
        let conditioning = match variant {
            Variant::F32 => self.conditioning(function, errors.at),
            _ => None,
        };
        self.all.push(Measured {
            robot: self.robot,
            joints: N,
            function,
            variant,
            nanoseconds,
            errors,
            bound: None,
            conditioning,
        });
    }

    /// The conditioning of a value at a state. Accelerations have none: their errors are judged by torques.
    fn conditioning(&self, function: Function, state: usize) -> Option<f64> {
        let value: fn(&Exact<N>, &State<DoubleDouble, N>) -> Vec<DoubleDouble> = match function {
            Function::M => |exact, s| exact.mass_matrix(&s.q).as_slice().to_vec(),
            Function::V => |exact, s| exact.coriolis_vector(&s.q, &s.qd).as_slice().to_vec(),
            Function::G => |exact, s| exact.gravity_vector(&s.q).as_slice().to_vec(),
            Function::Tau => |exact, s| {
                let tau = exact.inverse_dynamics(&s.q, &s.qd, &s.qdd);
                tau.as_slice().to_vec()
            },
            Function::Qdd => return None,
        };
        let change = self.samples.change_by_half_units(state, value);
        Some(change / function.scale(&self.samples.values[state]))
    }
}

/// Where there are no accelerations, their errors are infinite.
fn or_nan<T: Number, const N: usize>(
    qdd: Result<SVector<T, N>, SingularMassMatrix>,
) -> SVector<T, N> {
    qdd.unwrap_or_else(|_| SVector::repeat(T::from_f64(f64::NAN)))
}
