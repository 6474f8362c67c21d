//! The states at which functions are measured, and their exact values there.

use robot_dynamics::nalgebra::{SMatrix, SVector};
use robot_dynamics::{
    DoubleDouble, Scalar,
    table::{JointType, Row, Table},
};
use testkit::exact::Exact;
use testkit::random::Random;

use crate::number::Number;

/// States at which functions are timed and measured.
const ORDINARY: usize = 48;

/// More states, at rest and at angles of up to 10^6 rad, at which functions are measured but not timed.
const SPECIAL: usize = 16;

/// A state, and torques there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct State<T, const N: usize> {
    pub(crate) q: SVector<T, N>,
    pub(crate) qd: SVector<T, N>,
    pub(crate) qdd: SVector<T, N>,
    pub(crate) tau: SVector<T, N>,
}

/// The exact values at a state, and their natural magnitudes.
pub(crate) struct Values<const N: usize> {
    pub(crate) mass_matrix: SMatrix<DoubleDouble, N, N>,
    pub(crate) coriolis_vector: SVector<DoubleDouble, N>,
    pub(crate) gravity_vector: SVector<DoubleDouble, N>,
    pub(crate) inverse_dynamics: SVector<DoubleDouble, N>,
    pub(crate) forward_dynamics: SVector<DoubleDouble, N>,
    pub(crate) scale: Scale,
}

/// The denominators of relative errors: max |M|, max |M| max |qd|^2, sum m |g| reach (at least 1 m
/// where a joint slides), and for torques max |M| max |qdd| with the two others and friction.
pub(crate) struct Scale {
    pub(crate) inertia: f64,
    pub(crate) coriolis: f64,
    pub(crate) gravity: f64,
    pub(crate) torque: f64,
}

/// The states of an arm with their exact values.
pub(crate) struct Samples<const N: usize> {
    table: Table<N>,
    states: Vec<State<f64, N>>,
    pub(crate) values: Vec<Values<N>>,
}

impl<const N: usize> Samples<N> {
    pub(crate) fn of(table: &Table<N>) -> Self {
        let mut random = Random::seeded(560);
        let exact = Exact(table);
        let mut samples = Samples {
            table: table.clone(),
            states: Vec::new(),
            values: Vec::new(),
        };
        for i in 0..ORDINARY + SPECIAL {
            let (turn, speed) = match i.checked_sub(ORDINARY) {
                None => (std::f64::consts::PI, 3.0),
                Some(k) if k % 2 == 0 => (std::f64::consts::PI, 0.0),
                Some(_) => (1e6, 3.0),
            };
            let range = |row: &Row| match row.joint_type {
                JointType::Revolute => turn,
                JointType::Prismatic => 1.0,
            };
            let q = SVector::from_fn(|i, _| random.between(-1.0, 1.0) * range(&table.rows[i]));
            let qd = random.vector(1.0) * speed;
            samples.add(&exact, short(&q), short(&qd), short(&random.vector(10.0)));
        }
        samples
    }

    fn add(
        &mut self,
        exact: &Exact<N>,
        q: SVector<f64, N>,
        qd: SVector<f64, N>,
        qdd: SVector<f64, N>,
    ) {
        let [at_q, at_qd, at_qdd] = [q, qd, qdd].map(|x| x.map(DoubleDouble::from));
        let inverse_dynamics = exact.inverse_dynamics(&at_q, &at_qd, &at_qdd);
        let tau = short(&inverse_dynamics.map(DoubleDouble::to_f64));
        let mass_matrix = exact.mass_matrix(&at_q);
        let inertia = largest(&mass_matrix);
        let coriolis = inertia * qd.amax() * qd.amax();
        let gravity = weight_by_reach(exact.0, &q);
        let torque = inertia * qdd.amax() + coriolis + gravity;
        self.values.push(Values {
            mass_matrix,
            coriolis_vector: exact.coriolis_vector(&at_q, &at_qd),
            gravity_vector: exact.gravity_vector(&at_q),
            inverse_dynamics,
            forward_dynamics: exact.forward_dynamics(&at_q, &at_qd, &tau.map(DoubleDouble::from)),
            scale: Scale {
                inertia,
                coriolis,
                gravity,
                torque: torque.max(largest(&inverse_dynamics)),
            },
        });
        self.states.push(State { q, qd, qdd, tau });
    }

    /// All states, the ordinary ones first.
    pub(crate) fn states<T: Number>(&self) -> Vec<State<T, N>> {
        self.states_as(T::from_f64)
    }

    /// All states, in numbers that are made of doubles.
    pub(crate) fn states_as<T: Scalar>(&self, number: impl Fn(f64) -> T) -> Vec<State<T, N>> {
        let number = |x: &SVector<f64, N>| x.map(&number);
        let states = self.states.iter().map(|state| State {
            q: number(&state.q),
            qd: number(&state.qd),
            qdd: number(&state.qdd),
            tau: number(&state.tau),
        });
        states.collect()
    }

    /// The change of `value` at a state if an argument changes by half a unit in its last place, in single precision,
    /// added over all arguments. It is the largest sum of an entry.
    pub(crate) fn change_by_half_units(
        &self,
        state: usize,
        value: impl Fn(&Exact<N>, &State<DoubleDouble, N>) -> Vec<DoubleDouble>,
    ) -> f64 {
        let exact = Exact(&self.table);
        let at = self.states_as(DoubleDouble::from)[state];
        let here = value(&exact, &at);
        let mut changes = vec![0.0; here.len()];
        for joint in 0..N {
            let moved = [
                State {
                    q: moved(&at.q, joint),
                    ..at
                },
                State {
                    qd: moved(&at.qd, joint),
                    ..at
                },
                State {
                    qdd: moved(&at.qdd, joint),
                    ..at
                },
            ];
            for there in moved.map(|state| value(&exact, &state)) {
                let pairs = changes.iter_mut().zip(there.iter().zip(&here));
                pairs.for_each(|(change, (x, y))| *change += (*x - *y).high().abs());
            }
        }
        changes.into_iter().fold(0.0, f64::max)
    }

    /// How many of the states are ordinary: these are timed.
    pub(crate) fn timed(&self) -> usize {
        ORDINARY
    }
}

/// A vector with half a unit in the last place of single precision added to the number of a joint.
fn moved<const N: usize>(x: &SVector<DoubleDouble, N>, joint: usize) -> SVector<DoubleDouble, N> {
    let mut moved = *x;
    let single = x[joint].high() as f32;
    let unit = f64::from(single.abs().next_up()) - f64::from(single.abs());
    moved[joint] = x[joint] + DoubleDouble::from(0.5 * unit);
    moved
}

/// Rounded to single precision, so that every kind of number starts from the same values.
fn short<const N: usize>(x: &SVector<f64, N>) -> SVector<f64, N> {
    x.map(|x| f64::from(x as f32))
}

/// The largest absolute value.
pub(crate) fn largest<const R: usize, const C: usize>(x: &SMatrix<DoubleDouble, R, C>) -> f64 {
    x.iter().map(|x| x.high().abs()).fold(0.0, f64::max)
}

fn weight_by_reach<const N: usize>(table: &Table<N>, q: &SVector<f64, N>) -> f64 {
    let norm = |v: &[f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let link = |(row, q): (&Row, &f64)| {
        let travel = match row.joint_type {
            JointType::Revolute => 0.0,
            JointType::Prismatic => q.abs(),
        };
        row.a.abs() + row.d.abs() + travel + norm(&row.com)
    };
    let reach: f64 = table.rows.iter().zip(q.iter()).map(link).sum();
    // A joint that slides has a force, not a moment.
    let slides = |row: &Row| row.joint_type == JointType::Prismatic;
    let lever = if table.rows.iter().any(slides) {
        reach.max(1.0)
    } else {
        reach
    };
    table.total_mass() * norm(&table.gravity) * lever
}
