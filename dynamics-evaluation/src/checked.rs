//! A robot at run time as checks take it.

use dynamics_numeric::check::{Checked, Evaluation};
use dynamics_runtime::nalgebra::{DVector, Dyn};
use dynamics_runtime::{Certified, Pose, Scalar, SizedState, table::RuntimeTable};
use dynamics_symbolic::Function;
use dynamics_symbolic::function::{Argument, Part, frame_in_methods};

use crate::RuntimeRobot;

impl Checked for RuntimeRobot {
    fn names(&self) -> Vec<String> {
        self.joint_names().map(str::to_owned).collect()
    }

    fn runtime_table(&self) -> RuntimeTable {
        self.table()
    }

    fn values(&self, base: &Pose<f64>, state: &SizedState<Dyn>, tau: &DVector<f64>) -> Evaluation {
        self.evaluation(arguments(base, state, tau), &state.qd, |x| x)
    }

    fn certified_values(
        &self,
        base: &Pose<f64>,
        state: &SizedState<Dyn>,
        tau: &DVector<f64>,
    ) -> Evaluation<Certified> {
        self.evaluation(arguments(base, state, tau), &state.qd, Certified::exact)
    }

    /// Each method by its own program.
    fn values_of_parts(
        &self,
        base: &Pose<f64>,
        state: &SizedState<Dyn>,
        tau: &DVector<f64>,
        found: &mut dyn FnMut(&str, Evaluation),
    ) {
        let argument = arguments(base, state, tau);
        let tuples = self.functions().iter();
        for function in tuples.filter(|function| function.request.is_tuple()) {
            let mut values = self
                .values(function, &function.shared, &argument, &|x| x)
                .map(Vec::into_iter);
            let mut evaluation = Evaluation::default();
            for part in function.request.parts() {
                let row = part.function.row();
                let entries = row.shape.entries(function.layout.sizes);
                let evaluation = self.at_frame(&mut evaluation, *part);
                match &mut values {
                    Ok(values) => {
                        let of_part: Vec<f64> = values.take(entries).collect();
                        evaluation.set(row.name, of_part);
                    }
                    Err(error) if row.refuses => evaluation.set(row.name, Err::<f64, _>(*error)),
                    Err(_) => {}
                }
            }
            found(
                function.request.name(),
                evaluation.combined(state.qd.as_slice()),
            );
        }
    }
}

impl RuntimeRobot {
    /// The values of all functions that are evaluated by themselves, in numbers that `real` makes of the state's.
    fn evaluation<T: Scalar>(
        &self,
        double: impl Fn(Argument, usize) -> f64,
        qd: &DVector<f64>,
        real: fn(f64) -> T,
    ) -> Evaluation<T> {
        let argument = |argument, i| real(double(argument, i));
        let mut evaluation = Evaluation::default();
        for function in self.functions() {
            // A Taylor series is no program over numbers.
            if let [part] = *function.request.parts()
                && part.function != Function::TaylorSeries
            {
                let shared = function.tape.shared(self.fields(), &T::from_f64);
                let values = self.values(function, &shared, &argument, &T::from_f64);
                let at_frame = self.at_frame(&mut evaluation, part);
                at_frame.set(part.function.name(), values);
            }
        }
        let qd: Vec<T> = qd.iter().map(|x| real(*x)).collect();
        evaluation.combined(&qd)
    }

    /// The values at the frame that a function is about; without one, those of the whole robot.
    fn at_frame<'e, T: Scalar>(
        &self,
        evaluation: &'e mut Evaluation<T>,
        part: Part,
    ) -> &'e mut Evaluation<T> {
        match part.frame {
            Some(frame) => {
                let name = frame_in_methods(&self.robot().frames[frame].name);
                evaluation.at_frame(&name, frame)
            }
            None => evaluation,
        }
    }
}

/// The entries of all arguments at a state, of a robot whose base stands there if it moves.
fn arguments(
    base: &Pose<f64>,
    state: &SizedState<Dyn>,
    tau: &DVector<f64>,
) -> impl Fn(Argument, usize) -> f64 {
    let base = base.entries();
    let (SizedState { q, qd, qdd }, tau) = (state.clone(), tau.clone());
    let [qd_r, qdd_r] = [state.reference_velocity(), state.reference_acceleration()];
    let ([jerk, snap], wrench) = ([state.jerk(), state.snap()], SizedState::<Dyn>::wrench());
    move |argument, i| match argument {
        Argument::Position => q[i],
        Argument::Velocity => qd[i],
        Argument::Acceleration => qdd[i],
        Argument::Force => tau[i],
        Argument::ReferenceVelocity => qd_r[i],
        Argument::ReferenceAcceleration => qdd_r[i],
        Argument::Jerk => jerk[i],
        Argument::Snap => snap[i],
        Argument::Wrench => wrench[i],
        Argument::Base => base[i],
        Argument::Order | Argument::Pose => f64::NAN,
    }
}
