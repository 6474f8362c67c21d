//! Accelerations satisfy the equations that they solve.
//!
//! Where M is nearly singular, accelerations lose digits, whatever computes them. A backward stable
//! solution still satisfies M qdd = tau - V - G - F to rounding: the errors of its entries belong
//! together. A definition that is equal, shorter, and reads something else breaks that bond.

mod arithmetic;
mod graded;

use arithmetic::{Bits, Float, Joint, State, emitted, thousandths};
use arms::generic_chain;
use dynamics_symbolic::Function;
use dynamics_symbolic::derive::derive;
use dynamics_symbolic::derive::functions::Form;
use dynamics_symbolic::derive::functions::Part;
use dynamics_symbolic::derive::gauge::Gauge;
use dynamics_symbolic::derive::symbols::Symbols;
use dynamics_symbolic::exact::{Rational, SplitMix64};
use dynamics_symbolic::expr::Graph;
use dynamics_symbolic::mechanism::Mechanism;
use dynamics_symbolic::program::{Arithmetic, Program};
use dynamics_symbolic::robot::Robot;
use graded::{Arms, antiparallel};

/// Bits of the significand of `f32`, of `f64`, and about those of `DoubleDouble`.
const BITS: [usize; 3] = [24, 53, 106];

/// The bits in which nothing is lost.
const EXACT: usize = 400;

/// The largest residual, in roundings of one entry: 7e-15 in `f64`. It may be larger where entries of
/// M are small differences of base parameters: then that of the factorisation as it is derived, not
/// shortened, is no smaller than half of it.
const BOUND: f64 = 64.0;

/// The forward dynamics of an arm beside what judges it.
struct Case {
    dof: usize,
    mass_matrix: Program,
    inverse_dynamics: Program,
    forward_dynamics: Program,
    emitted: Program,
}

impl Case {
    fn new(robot: &Robot, forward_dynamics: Program) -> Self {
        Case {
            dof: robot.dof(),
            mass_matrix: derive(robot, Function::MassMatrix),
            inverse_dynamics: derive(robot, Function::InverseDynamics),
            emitted: emitted(&forward_dynamics),
            forward_dynamics,
        }
    }

    /// The state with the forces of its accelerations, so that these are no larger than they are told.
    fn with_forces(&self, state: &State) -> State {
        let mut state = state.clone();
        let forces = self
            .inverse_dynamics
            .evaluate(&mut Bits::new(EXACT, &state));
        for (joint, force) in state.joints.iter_mut().zip(forces) {
            joint.force = Rational::try_from(force).expect("finite");
        }
        state
    }

    /// The largest |M (qdd - exact)|_i / sqrt(M_ii), over the largest of all sqrt(M_jj) |qdd_j| and
    /// |tau_j| / sqrt(M_jj), in units of 2^-bits: no measure of length or mass matters. `None` where a
    /// pivot is hardly above the rounding of its diagonal entry.
    fn residual(&self, state: &State, bits: usize) -> Option<f64> {
        let (n, unit) = (self.dof, 0.5_f64.powi(bits as i32));
        let state = &self.with_forces(state);
        let exact = &mut Bits::new(EXACT, state);
        // The constants of a program are doubles: in more digits its value is that of the doubles.
        let program = match bits > 53 {
            true => &self.emitted,
            false => &self.forward_dynamics,
        };
        let x = program.evaluate(exact);
        let m = self.mass_matrix.evaluate(exact);
        let mut relative_pivots = (0..n).map(|i| number(&x[n + i]) / number(&x[2 * n + i]));
        // A diagonal entry of zero makes a pivot that is no number.
        let is_regular = relative_pivots.all(|pivot| pivot > 1e3 * unit);
        if !is_regular {
            return None;
        }
        let found = self.emitted.evaluate(&mut Bits::new(bits, state));
        let weight = |i: usize| number(&m[i * n + i]).sqrt();
        let (mut residual, mut scale) = (0.0_f64, 0.0_f64);
        for (i, joint) in state.joints.iter().enumerate() {
            let mut row = Float::ZERO;
            for j in 0..n {
                let difference = exact.add(found[j].clone(), -x[j].clone());
                let term = exact.mul(m[i * n + j].clone(), difference);
                row = exact.add(row, term);
            }
            let force = joint.force.to_f64().value();
            residual = residual.max(number(&row).abs() / weight(i));
            scale = scale.max(weight(i) * number(&x[i]).abs());
            scale = scale.max(force.abs() / weight(i));
        }
        Some(residual / scale / unit)
    }
}

fn number(x: &Float) -> f64 {
    x.to_f64().value()
}

/// Forward dynamics by the factors of M, each result as the derivation defines it.
fn as_derived(robot: &Robot) -> Program {
    let (function, form) = (Function::ForwardDynamics, Form::Recursive);
    let gauge = Gauge::search(&robot.into(), &[Part::new(function, form)]);
    let graph = Graph::new();
    let arm = Mechanism::from(robot);
    let mut symbols = Symbols::new(&graph, &arm);
    let outputs = gauge.outputs(&mut symbols, &[Part::new(function, form)]);
    Program::new(&graph, symbols.meanings(), &outputs, &|id| {
        graph.operation(id)
    })
}

/// Positions near and far, at rest, without gravity: all forces are those of inertia.
fn at_rest(random: &mut SplitMix64, robot: &Robot) -> State {
    let mut joint = || {
        let far = match random.next_u64() % 2 {
            0 => 4_000,
            _ => 400_000,
        };
        Joint {
            acceleration: thousandths(random, 10_000),
            ..Joint::at(&thousandths(random, far))
        }
    };
    State {
        joints: (0..robot.dof()).map(|_| joint()).collect(),
        fields: vec![Rational::ZERO; robot.fields.len()],
    }
}

/// The far joints are 870 m and 1 m out; the inner pivot is 1e-5 of its diagonal entry.
#[test]
fn antiparallel_joints() {
    let robot = antiparallel();
    let rational = |x: f64| Rational::try_from(x).expect("finite");
    let joint = |[q, qd, qdd]: [f64; 3]| Joint {
        position: rational(q),
        velocity: rational(qd),
        acceleration: rational(qdd),
        ..Joint::at(&rational((0.5 * q).tan()))
    };
    let state = State {
        joints: vec![
            joint([940.105, 1.1206700290617295, -7.181797679551318]),
            joint([587.936, 2.3973424542544537, 5.690166822294216]),
            joint([1.250372113216713, -2.677266266533617, -7.248212665357309]),
            joint([-868.0705639181434, 0.2764713429969685, -7.1011753710508785]),
        ],
        fields: [-3.980_014_524, -8.071_749_503].map(rational).to_vec(),
    };
    for function in [Function::ForwardDynamics, Function::ForwardDynamicsAba] {
        let case = Case::new(&robot, derive(&robot, function));
        assert_eq!(
            case.residual(&state, 24),
            None,
            "singular in single precision"
        );
        for bits in [53, 106] {
            let residual = case.residual(&state, bits).expect("regular");
            println!("{}, {bits} bits: {residual:.1}", function.name());
            assert!(
                residual <= 8.0,
                "{}, {bits} bits: {residual:.1e}",
                function.name()
            );
        }
    }
}

/// The largest residuals of the forward dynamics of an arm, and at how many states it is regular.
#[derive(Default)]
struct Largest {
    residuals: [f64; 3],
    regular: [usize; 3],
}

impl Largest {
    fn measure(&mut self, robot: &Robot, random: &mut SplitMix64) {
        let case = Case::new(robot, derive(robot, Function::ForwardDynamics));
        let states = [(); 3].map(|()| at_rest(random, robot));
        for (k, bits) in BITS.into_iter().enumerate() {
            for state in &states {
                let Some(residual) = case.residual(state, bits) else {
                    continue;
                };
                let derived = || Case::new(robot, as_derived(robot)).residual(state, bits);
                let is_small = residual <= BOUND || Some(residual) <= derived().map(|r| 2.0 * r);
                assert!(is_small, "{bits} bits: {residual:.1e}\n{robot:#?}");
                self.residuals[k] = self.residuals[k].max(residual);
                self.regular[k] += 1;
            }
        }
    }
}

fn measure_random_arms(seed: u64, count: usize) {
    let (mut arms, random) = (Arms::new(seed), &mut SplitMix64::new(seed));
    let mut largest = Largest::default();
    for _ in 0..count {
        largest.measure(&arms.arm(), random);
    }
    let Largest { residuals, regular } = largest;
    println!("{count} arms, regular states {regular:?}, largest residuals {residuals:.1?}");
    assert!(regular.iter().all(|&regular| regular > count));
}

#[test]
fn random_arms() {
    measure_random_arms(7, 100);
}

/// `cargo test -p dynamics-symbolic --test suite residuals:: -- --ignored --nocapture`
#[test]
#[ignore = "takes a quarter of a minute: .ci/run runs it"]
fn many_random_arms() {
    measure_random_arms(8, 2_000);
}

/// Long chains are solved by articulated bodies.
#[test]
fn a_long_chain() {
    let mut largest = Largest::default();
    largest.measure(&generic_chain(12), &mut SplitMix64::new(9));
    println!("largest residuals {:.1?}", largest.residuals);
    assert_eq!(largest.regular, [3; 3]);
}
