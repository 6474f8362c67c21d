//! Robots on a base that moves: the time of a state, one by one and in batches, as lines for `benches/trees.sh`.
//!
//! `cargo bench -p benches --bench legged` prints lines `time ROBOT FUNCTION CANDIDATE NS` and `error ROBOT FUNCTION
//! CANDIDATE LARGEST`, errors relative to the largest entry of a value. With `-- states` it prints the states and their
//! values in 31 digits, rounded, by which another program is compared.

use std::hint::black_box;

use measuring::Effort;
use robot_dynamics::nalgebra::{Rotation3, SMatrix, SVector, Vector3};
use robot_dynamics::{DoubleDouble, Pose, Scalar, robot_dynamics};
use testkit::five::largest_error;

robot_dynamics! {
    /// Four legs of three joints on a trunk.
    struct Hyq;
    file: "../tests/data/urdf/trees/hyq_no_sensors.urdf",
    base: floating,
    gravity: [0, 0, -9.81],
    allow: [unphysical_inertia],
    functions: [inverse_dynamics, mass_matrix, forward_dynamics],
}

robot_dynamics! {
    /// The same of another make.
    struct Anymal;
    file: "../tests/data/urdf/trees/anymal_erd.urdf",
    base: floating,
    gravity: [0, 0, -9.81],
    allow: [unphysical_inertia],
    functions: [inverse_dynamics, mass_matrix, forward_dynamics],
}

robot_dynamics! {
    /// A small quadruped, as many laboratories have one: twelve motors at the joints, 15 kg in all.
    struct Quadruped;
    convention: modified,
    gravity: [0, 0, -9.81],
    base: floating { mass: 7, com: [0.02, 0, -0.005], inertia: { xx: 0.03, yy: 0.11, zz: 0.12, xy: 1e-4, yz: -2e-5, xz: 2e-3 } },
    let hip = 0.7; let thigh = 1.2; let calf = 0.2;
    joints: [
        fl_hip:   revolute { on: base, at: { xyz: [0.19, 0.05, 0], rpy: [0, PI/2, 0] }, mass: hip, com: [0, 0.002, -0.005], inertia: { xx: 5e-4, yy: 9e-4, zz: 6e-4, xy: -8e-6 } },
        fl_thigh: revolute { a: 0.1, alpha: -PI/2, mass: thigh, com: [-0.004, -0.02, -0.03], inertia: { xx: 6e-3, yy: 6e-3, zz: 1e-3, xy: 5e-6, yz: 8e-4, xz: -3e-4 } },
        fl_calf:  revolute { a: 0.21, mass: calf, com: [0.006, 0.001, -0.12], inertia: { xx: 2e-3, yy: 2e-3, zz: 4e-5, xz: -1e-4 } },
        fr_hip:   revolute { on: base, at: { xyz: [0.19, -0.05, 0], rpy: [0, PI/2, 0] }, mass: hip, com: [0, -0.002, -0.005], inertia: { xx: 5e-4, yy: 9e-4, zz: 6e-4, xy: 8e-6 } },
        fr_thigh: revolute { a: -0.1, alpha: -PI/2, mass: thigh, com: [-0.004, 0.02, -0.03], inertia: { xx: 6e-3, yy: 6e-3, zz: 1e-3, xy: -5e-6, yz: -8e-4, xz: -3e-4 } },
        fr_calf:  revolute { a: 0.21, mass: calf, com: [0.006, -0.001, -0.12], inertia: { xx: 2e-3, yy: 2e-3, zz: 4e-5, xz: -1e-4 } },
        rl_hip:   revolute { on: base, at: { xyz: [-0.19, 0.05, 0], rpy: [0, PI/2, 0] }, mass: hip, com: [0, 0.002, 0.005], inertia: { xx: 5e-4, yy: 9e-4, zz: 6e-4, xy: 8e-6 } },
        rl_thigh: revolute { a: 0.1, alpha: -PI/2, mass: thigh, com: [-0.004, -0.02, -0.03], inertia: { xx: 6e-3, yy: 6e-3, zz: 1e-3, xy: 5e-6, yz: 8e-4, xz: -3e-4 } },
        rl_calf:  revolute { a: 0.21, mass: calf, com: [0.006, 0.001, -0.12], inertia: { xx: 2e-3, yy: 2e-3, zz: 4e-5, xz: -1e-4 } },
        rr_hip:   revolute { on: base, at: { xyz: [-0.19, -0.05, 0], rpy: [0, PI/2, 0] }, mass: hip, com: [0, -0.002, 0.005], inertia: { xx: 5e-4, yy: 9e-4, zz: 6e-4, xy: -8e-6 } },
        rr_thigh: revolute { a: -0.1, alpha: -PI/2, mass: thigh, com: [-0.004, 0.02, -0.03], inertia: { xx: 6e-3, yy: 6e-3, zz: 1e-3, xy: -5e-6, yz: -8e-4, xz: -3e-4 } },
        rr_calf:  revolute { a: 0.21, mass: calf, com: [0.006, -0.001, -0.12], inertia: { xx: 2e-3, yy: 2e-3, zz: 4e-5, xz: -1e-4 } },
    ],
    functions: [inverse_dynamics, mass_matrix, forward_dynamics, forward_dynamics_derivatives],
}

const STATES: usize = 64;

/// States of a batch beside those of a processor of graphics.
const MANY: usize = 1_024;

type Joints<T> = SVector<T, 12>;
type Vector<T> = SVector<T, 18>;

/// Where the base stands, positions, velocities, and accelerations or forces.
struct State<T: Scalar> {
    base: Pose<T>,
    q: Joints<T>,
    v: Vector<T>,
    x: Vector<T>,
}

/// States spread over the joints' circles, in numbers that single precision holds; rotations in all of their digits, because
/// rounded ones are none.
fn states<T: Scalar>(count: usize) -> Vec<State<T>> {
    states_turned(count, |x| x)
}

/// The same with rotations rounded to single precision.
fn single_states<T: Scalar>(count: usize) -> Vec<State<T>> {
    states_turned(count, |x| f64::from(x as f32))
}

fn states_turned<T: Scalar>(count: usize, rounded: fn(f64) -> f64) -> Vec<State<T>> {
    let number = |phase: f64, state: usize, entry: usize| {
        f64::from(((phase + 1.7 * state as f64 + 2.3 * entry as f64).sin() * 3.0) as f32)
    };
    let given = |x: f64| T::from_f64(f64::from(x as f32));
    let state = |state: usize| {
        let turn = Rotation3::new(Vector3::from_fn(|i, _| number(2.9, state, i)));
        State {
            base: Pose {
                rotation: turn.into_inner().map(|x| T::from_f64(rounded(x))),
                position: Vector3::from_fn(|i, _| given(number(4.1, state, i))),
            },
            q: SVector::from_fn(|i, _| given(number(0.1, state, i))),
            v: SVector::from_fn(|i, _| given(number(0.7, state, i))),
            x: SVector::from_fn(|i, _| given(number(1.9, state, i))),
        }
    };
    (0..count).map(state).collect()
}

/// Arguments and values of a batch, a column for each entry.
struct Columns<T> {
    base: [Vec<T>; 12],
    q: [Vec<T>; 12],
    v: [Vec<T>; 18],
    x: [Vec<T>; 18],
    vector: [Vec<T>; 18],
    matrices: [[[Vec<T>; 18]; 18]; 3],
}

impl<T: Scalar> Columns<T> {
    fn new(states: &[State<T>]) -> Self {
        let column = |of: &dyn Fn(&State<T>) -> T| states.iter().map(of).collect::<Vec<T>>();
        let zeros = || vec![T::from_f64(0.0); states.len()];
        Columns {
            base: std::array::from_fn(|k| column(&|state| state.base.entries()[k])),
            q: std::array::from_fn(|k| column(&|state| state.q[k])),
            v: std::array::from_fn(|k| column(&|state| state.v[k])),
            x: std::array::from_fn(|k| column(&|state| state.x[k])),
            vector: std::array::from_fn(|_| zeros()),
            matrices: std::array::from_fn(|_| {
                std::array::from_fn(|_| std::array::from_fn(|_| zeros()))
            }),
        }
    }

    /// The values of a vector or of the first so many matrices at every state.
    fn values(&self, matrices: usize) -> Vec<Vec<f64>> {
        let double = |x: &T| x.ratio_to_f64(T::from_f64(1.0));
        let of_matrices = self.matrices[..matrices].iter().flatten().flatten();
        let columns: Vec<&Vec<T>> = match matrices {
            0 => self.vector.iter().collect(),
            _ => of_matrices.collect(),
        };
        let at = |state: usize| {
            columns
                .iter()
                .map(|column| double(&column[state]))
                .collect()
        };
        (0..columns[0].len()).map(at).collect()
    }
}

fn print(name: &str, function: &str, candidate: &str, error: f64, time: f64) {
    println!("error {name} {function} {candidate} {error:e}");
    println!("time {name} {function} {candidate} {time:.2}");
}

/// The numbers of a value, matrices by columns.
trait Numbers {
    fn numbers(&self) -> Vec<f64>;
}

impl<T: Scalar, const C: usize> Numbers for SMatrix<T, 18, C> {
    fn numbers(&self) -> Vec<f64> {
        let double = |x: &T| x.ratio_to_f64(T::from_f64(1.0));
        self.iter().map(double).collect()
    }
}

/// No value is one that is not a number.
impl<V: Numbers, E> Numbers for Result<V, E> {
    fn numbers(&self) -> Vec<f64> {
        self.as_ref().map_or(vec![f64::NAN], Numbers::numbers)
    }
}

impl<V: Numbers> Numbers for (V, V, V) {
    fn numbers(&self) -> Vec<f64> {
        [&self.0, &self.1, &self.2].map(Numbers::numbers).concat()
    }
}

/// Measures functions in double precision, and prints their lines. Each has the number of its matrices, a call at a state
/// and one for columns.
macro_rules! measure {
    ($name:literal, $($function:ident, $matrices:literal, |$s:ident| $call:expr, |$c:ident| $batch:expr;)*) => {$({
        let exact: Vec<Vec<f64>> = states::<DoubleDouble>(STATES).iter().map(|$s| $call.numbers()).collect();
        let given = states::<f64>(STATES);
        let found: Vec<Vec<f64>> = given.iter().map(|$s| $call.numbers()).collect();
        let mut columns = Columns::new(&given);
        let mut batch = || { let $c = &mut columns; $batch };
        batch();
        let calls = || for $s in &given { let $s = black_box($s); black_box(&$call); };
        let times = Effort::FULL.in_turns([&mut { calls }, &mut batch]);
        let [single, in_batch] = times.map(|time| time / STATES as f64);
        let function = stringify!($function);
        print($name, function, "generated", largest_error(&found, &exact), single);
        print($name, function, "generated,batch", largest_error(&columns.values($matrices), &exact), in_batch);
    })*};
}

/// The same in batches of single precision, beside double precision.
macro_rules! measure_single {
    ($name:literal, $($function:ident, $matrices:literal, |$s:ident| $call:expr, |$c:ident| $batch:expr;)*) => {$({
        let exact: Vec<Vec<f64>> = single_states::<f64>(MANY).iter().map(|$s| $call.numbers()).collect();
        let mut columns = Columns::new(&single_states::<f32>(MANY));
        let mut batch = || { let $c = &mut columns; $batch };
        batch();
        let [time] = Effort::FULL.in_turns([&mut batch]);
        let found = largest_error(&columns.values($matrices), &exact);
        print($name, stringify!($function), "generated,f32", found, time / MANY as f64);
    })*};
}

/// The three functions that every robot here has.
macro_rules! measure_robot {
    ($measure:ident, $robot:ident, $name:literal) => {
        $measure! { $name,
            inverse_dynamics, 0,
                |s| $robot.inverse_dynamics(&s.base, &s.q, &s.v, &s.x),
                |c| $robot.inverse_dynamics_batch(&c.base, &c.q, &c.v, &c.x, &mut c.vector).expect("columns of one length");
            mass_matrix, 1,
                |s| $robot.mass_matrix(&s.q),
                |c| $robot.mass_matrix_batch(&c.q, &mut c.matrices[0]).expect("columns of one length");
            forward_dynamics, 0,
                |s| $robot.forward_dynamics(&s.base, &s.q, &s.v, &s.x),
                |c| $robot.forward_dynamics_batch(&c.base, &c.q, &c.v, &c.x, &mut c.vector).expect("M is definite");
        }
    };
}

/// Derivatives of forward dynamics, of the quadruped alone.
macro_rules! measure_derivatives {
    ($measure:ident) => {
        $measure! { "quadruped",
            forward_dynamics_derivatives, 3,
                |s| Quadruped.forward_dynamics_derivatives(&s.base, &s.q, &s.v, &s.x),
                |c| {
                    let [by_position, by_velocity, by_force] = &mut c.matrices;
                    let sinks = (by_position, by_velocity, by_force);
                    Quadruped.forward_dynamics_derivatives_batch(&c.base, &c.q, &c.v, &c.x, sinks).expect("M is definite")
                };
        }
    };
}

/// A line `ROBOT N`, then for each state its numbers, tau, M and the accelerations.
macro_rules! print_states {
    ($robot:ident, $name:literal) => {
        println!("{} 12", $name);
        let exact = states::<DoubleDouble>(STATES);
        for (s, given) in exact.iter().zip(states::<f64>(STATES)) {
            let values = [
                given.base.entries().as_slice().to_vec(),
                given.q.as_slice().to_vec(),
                given.v.as_slice().to_vec(),
                given.x.as_slice().to_vec(),
                $robot.inverse_dynamics(&s.base, &s.q, &s.v, &s.x).numbers(),
                $robot.mass_matrix(&s.q).numbers(),
                $robot.forward_dynamics(&s.base, &s.q, &s.v, &s.x).numbers(),
            ];
            let words: Vec<_> = values.iter().flatten().map(|x| format!("{x:e}")).collect();
            println!("{}", words.join(" "));
        }
    };
}

fn print_lines() {
    measure_robot!(measure, Hyq, "hyq_no_sensors");
    measure_robot!(measure, Anymal, "anymal_erd");
    measure_robot!(measure, Quadruped, "quadruped");
    measure_derivatives!(measure);
    measure_robot!(measure_single, Quadruped, "quadruped");
    measure_derivatives!(measure_single);
}

fn main() {
    if std::env::args().any(|argument| argument == "states") {
        print_states!(Hyq, "hyq_no_sensors");
        print_states!(Anymal, "anymal_erd");
    } else {
        print_lines();
    }
}
