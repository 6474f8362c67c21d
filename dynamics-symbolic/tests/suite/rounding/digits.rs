//! How many digits the programs of an arm have, in doubles and in single precision.
//!
//! The measure is the plain recursion in 31 digits, constants included: every program is proven equal to
//! it. Errors are relative to the natural scale of an output: the size of what the plain recursion adds
//! on the way to it, the largest of the sampled states and of the entries that are measured together
//! (`derive::units`). Solutions of equations are measured state by state, for the size of what is added
//! grows as the inertia of a joint vanishes, and only where the function does not refuse them.

use std::f64::consts::{FRAC_PI_2, PI};

use arms::{Arm, Arms};
use dynamics_symbolic::Function;
use dynamics_symbolic::derive::units::groups;
use dynamics_symbolic::derive::{derive, derive_plain};
use dynamics_symbolic::robot::{JointType, Robot};
use interpreter::{Inputs, Rounded, is_refused};

/// The largest error in doubles.
const DOUBLE: f64 = 1e-13;

/// The largest error in single precision.
const SINGLE: f64 = 4e-6;

/// States of one arm.
const STATES: usize = 6;

/// Positions, velocities, accelerations and forces, in numbers that single precision has.
struct State([Vec<f64>; 4]);

impl State {
    /// At every fourth state, on average, all positions are multiples of a right angle.
    fn new(robot: &Robot, arms: &mut Arms) -> Self {
        let is_special = arms.below(4) == 0;
        let joints: Vec<_> = robot.joints().map(|row| row.joint_type).collect();
        let single = |x: f64| f64::from(x as f32);
        let position = |joint: &JointType| match joint {
            _ if is_special => single(FRAC_PI_2) * (arms.below(5) as f64 - 2.0),
            JointType::Revolute => single(PI * (2.0 * arms.unit() - 1.0)),
            JointType::Prismatic => single(2.0 * arms.unit() - 1.0),
        };
        let q = joints.iter().map(position).collect();
        let mut vector = || {
            let entry = |_: &JointType| single(4.0 * arms.unit() - 2.0);
            joints.iter().map(entry).collect()
        };
        State([q, vector(), vector(), vector()])
    }

    fn inputs<'a>(&'a self, fields: &'a [f64]) -> Inputs<'a> {
        let [q, qd, qdd, tau] = &self.0;
        Inputs {
            fields,
            q,
            qd,
            qdd,
            tau,
            // No arm in here has one.
            stribeck: &[],
            // Any numbers do, and these are as random.
            qd_r: qdd,
            qdd_r: tau,
            jerk: tau,
            snap: qdd,
            wrench: &[0.75, -1.25, 2.0, 0.5, -0.375, 1.0],
        }
    }
}

/// How many programs were measured, and the largest errors with their functions.
#[derive(Default)]
pub(crate) struct Digits {
    programs: usize,
    /// Programs that no search has shortened.
    plain: usize,
    double: (f64, String),
    single: (f64, String),
}

impl Digits {
    /// The functions of random arms.
    pub(crate) fn of_arms(seed: u64, count: usize) -> Self {
        let mut arms = Arms::new(seed);
        let mut digits = Digits::default();
        for number in 0..count {
            let arm = arms.arm();
            let label = format!("arm {number} of seed {seed}");
            digits.add(&arm, &Function::ALL, &mut arms, &label);
        }
        digits
    }

    /// Some functions of one arm.
    pub(crate) fn add(&mut self, arm: &Arm, functions: &[Function], arms: &mut Arms, label: &str) {
        let states: Vec<State> = (0..STATES).map(|_| State::new(&arm.robot, arms)).collect();
        for &function in functions {
            let label = format!("{} of {label}", function.name());
            self.measure(arm, function, &states, &label);
        }
    }

    fn measure(&mut self, arm: &Arm, function: Function, states: &[State], label: &str) {
        let (program, plain) = (
            derive(&arm.robot, function),
            derive_plain(&arm.robot, function),
        );
        self.programs += 1;
        self.plain += usize::from(program.is_plain);
        let (emitted, plain) = (Rounded::new(&program), Rounded::new(&plain));
        let precise = plain.with_all_digits();
        let joints = arm.robot.joints().map(|row| row.joint_type.into());
        let joints: Vec<_> = joints.collect();
        let groups = groups(
            arm.robot.freedoms(),
            &joints,
            function,
            program.outputs.len(),
        );
        let inputs: Vec<_> = states
            .iter()
            .map(|state| state.inputs(&arm.fields))
            .collect();
        let sizes = inputs
            .iter()
            .map(|inputs| largest_of(&groups, &plain.sizes(inputs)));
        let sizes: Vec<_> = sizes.collect();
        let entries = function.entries(joints.len(), program.outputs.len());
        for (inputs, own) in inputs.iter().zip(&sizes) {
            let exact = precise.run(inputs);
            let exact: Vec<f64> = exact
                .into_iter()
                .take(entries)
                .map(|x| x.to_f64())
                .collect();
            let scale = match function.has_pivots() {
                true => own.clone(),
                false => largest(&sizes),
            };
            let double: Vec<f64> = emitted.run(inputs);
            let single: Vec<f32> = emitted.run(inputs);
            let double_refused = is_refused(&double[entries..]);
            let single_refused = is_refused(&single[entries..]);
            let single: Vec<f64> = single.into_iter().map(f64::from).collect();
            let double = error(&double, &exact, &scale, double_refused);
            let single = error(&single, &exact, &scale, single_refused);
            for (worst, error) in [(&mut self.double, double), (&mut self.single, single)] {
                if error > worst.0 {
                    *worst = (error, label.to_owned());
                }
            }
        }
    }

    pub(crate) fn join(mut self, other: Digits) -> Digits {
        self.programs += other.programs;
        self.plain += other.plain;
        let worse = |a: (f64, String), b: (f64, String)| if b.0 > a.0 { b } else { a };
        Digits {
            double: worse(self.double, other.double),
            single: worse(self.single, other.single),
            ..self
        }
    }

    #[track_caller]
    pub(crate) fn assert_none_lost(&self) {
        let Digits {
            programs,
            plain,
            double,
            single,
        } = self;
        println!("{programs} programs, {plain} of them as the recursion is written");
        println!("largest error in doubles {:.1e}: {}", double.0, double.1);
        println!(
            "largest error in single precision {:.1e}: {}",
            single.0, single.1
        );
        assert!(double.0 <= DOUBLE && single.0 <= SINGLE);
    }

    pub(crate) fn programs(&self) -> usize {
        self.programs
    }
}

/// The largest error of the entries over their scale; none where the function refuses.
fn error(outputs: &[f64], exact: &[f64], scale: &[f64], is_refused: bool) -> f64 {
    if is_refused {
        return 0.0;
    }
    let entries = outputs.iter().zip(exact).zip(scale);
    let relative = |((output, exact), scale): ((&f64, &f64), &f64)| {
        let difference = (output - exact).abs();
        match difference == 0.0 {
            true => 0.0,
            false => difference / scale,
        }
    };
    let worst = |worst: f64, error: f64| {
        if error.is_nan() {
            f64::INFINITY
        } else {
            worst.max(error)
        }
    };
    entries.map(relative).fold(0.0, worst)
}

/// For each output the largest size in its group.
fn largest_of(groups: &[usize], sizes: &[f64]) -> Vec<f64> {
    let mut largest = vec![0.0_f64; groups.len()];
    for (&group, &size) in groups.iter().zip(sizes) {
        largest[group] = largest[group].max(size);
    }
    groups.iter().map(|&group| largest[group]).collect()
}

/// The largest size of each output at any state.
fn largest(sizes: &[Vec<f64>]) -> Vec<f64> {
    let largest = |output: usize| sizes.iter().map(|sizes| sizes[output]).fold(0.0, f64::max);
    (0..sizes[0].len()).map(largest).collect()
}
