//! Random tables: every function of every arm is derived and proven.

use dynamics_symbolic::Function;
use dynamics_symbolic::derive::functions::Form;
use dynamics_symbolic::derive::{derive, derive_form};
use dynamics_symbolic::exact::{Rational, SplitMix64};
use dynamics_symbolic::program::Instruction;
use dynamics_symbolic::prove::prove;
use dynamics_symbolic::robot::{Convention, JointType, Robot, Row, Value};

/// Cells as they occur: mostly zero, round numbers, right angles, parameters.
struct Tables {
    random: SplitMix64,
    fields: usize,
    /// Arms in free space, most of their axes meeting: where rare parameters are grouped.
    meeting: bool,
}

impl Tables {
    fn below(&mut self, n: u64) -> u64 {
        self.random.next_u64() % n
    }

    fn number(&mut self) -> Value {
        let numerator = self.below(2001) as i64 - 1000;
        Value::Rational(Rational::from_parts(numerator.into(), 500_u32.into()))
    }

    fn cell(&mut self) -> Value {
        match self.below(8) {
            0..=3 => Value::zero(),
            4 | 5 => self.number(),
            6 => Value::integer(self.below(3) as i64 - 1),
            _ => self.parameter(),
        }
    }

    /// A new parameter, one that is there, or an expression of it.
    fn parameter(&mut self) -> Value {
        if self.fields == 0 || (self.fields < 4 && self.below(2) == 0) {
            self.fields += 1;
        }
        let field = Value::field(self.below(self.fields as u64) as usize);
        match self.below(4) {
            0 => field * self.number(),
            1 => -field + self.number(),
            2 => (field * self.number())
                .checked_div(Value::integer(7))
                .expect("not zero"),
            _ => field,
        }
    }

    fn angle(&mut self) -> Value {
        let quarter = Value::Pi * Value::Rational(Rational::ONE / Rational::from(2));
        match self.below(8) {
            0..=2 => Value::zero(),
            3..=5 => quarter * Value::integer(self.below(7) as i64 - 3),
            6 => self.number(),
            _ => self.parameter() + quarter,
        }
    }

    fn row(&mut self, i: usize) -> Row {
        let joint_type = match self.below(if self.meeting { 7 } else { 3 }) {
            0 => JointType::Prismatic,
            _ => JointType::Revolute,
        };
        Row {
            name: format!("joint{i}"),
            joint_type,
            a: match self.meeting && self.below(6) > 0 {
                true => Value::zero(),
                false => self.cell(),
            },
            alpha: self.angle(),
            d: self.cell(),
            theta: self.angle(),
            mass: self.cell(),
            com: [(); 3].map(|()| self.cell()),
            inertia: [(); 6].map(|()| self.cell()),
            motor_inertia: self.cell(),
            gear_ratio: self.cell(),
            viscous: self.cell(),
            coulomb: self.cell(),
            limits: None,
            locked: None,
        }
    }

    /// An arm some of whose joints are locked, at least one, and not all of them.
    fn locked_robot(&mut self) -> Robot {
        let mut robot = self.robot();
        while robot.rows.len() < 2 {
            robot = self.robot();
        }
        self.fields = robot.fields.len();
        let free = self.below(robot.rows.len() as u64) as usize;
        let sure = (free + 1) % robot.rows.len();
        for i in (0..robot.rows.len()).filter(|&i| i != free) {
            if i == sure || self.below(2) == 0 {
                robot.rows[i].locked = Some(self.angle());
            }
        }
        robot.fields = (0..self.fields).map(|i| format!("p{i}")).collect();
        robot
    }

    fn robot(&mut self) -> Robot {
        self.fields = 0;
        let dof = 1 + self.below(4) as usize;
        let rows = (0..dof).map(|i| self.row(i)).collect();
        let gravity = match self.meeting {
            true => [(); 3].map(|()| Value::zero()),
            false => [(); 3].map(|()| self.cell()),
        };
        let convention = match self.below(2) {
            0 => Convention::Standard,
            _ => Convention::Modified,
        };
        let fields = (0..self.fields).map(|i| format!("p{i}")).collect();
        Robot {
            name: "random".to_owned(),
            fields,
            convention,
            gravity,
            rows,
            neglected: None,
        }
    }
}

#[test]
fn every_function_of_random_arms_is_proven() {
    prove_tables(7, 200, false, &Function::ALL);
}

/// Joints anywhere locked at a number, an angle or a parameter.
#[test]
fn every_function_of_random_arms_with_locked_joints_is_proven() {
    let mut tables = Tables {
        random: SplitMix64::new(9),
        fields: 0,
        meeting: false,
    };
    for count in 0..60 {
        let robot = tables.locked_robot();
        prove_table(&robot, count, &Function::ALL);
    }
}

#[test]
fn regressors_of_arms_whose_axes_meet_are_proven() {
    let functions = [Function::Regressor, Function::BaseParameters];
    prove_tables(8, 300, true, &functions);
}

/// Many more: `cargo test --release -p dynamics-symbolic --test random_tables -- --ignored`.
#[test]
#[ignore = "takes minutes"]
fn every_function_of_many_random_arms_is_proven() {
    for seed in 100..110 {
        prove_tables(seed, 400, false, &Function::ALL);
        prove_tables(seed, 400, true, &Function::ALL);
    }
}

fn prove_tables(seed: u64, tables_in_all: usize, meeting: bool, functions: &[Function]) {
    let mut tables = Tables {
        random: SplitMix64::new(seed),
        fields: 0,
        meeting,
    };
    for count in 0..tables_in_all {
        prove_table(&tables.robot(), count, functions);
    }
}

fn prove_table(robot: &Robot, count: usize, functions: &[Function]) {
    let programs = functions.iter().map(|&f| (f, derive(robot, f)));
    let articulated = (
        Function::ForwardDynamics,
        derive_form(robot, Function::ForwardDynamics, Form::Articulated),
    );
    for (function, program) in programs.chain([articulated]) {
        let proof = prove(robot, function, &program);
        assert_eq!(proof, Ok(()), "table {count}: {robot:#?}");
        let divides = program
            .instructions
            .iter()
            .any(|i| matches!(i, Instruction::Div(..)));
        let solves = [
            Function::ForwardDynamics,
            Function::ForwardDynamicsDerivatives,
            Function::ForwardDynamicsAba,
        ];
        assert!(
            solves.contains(&function) || !divides,
            "table {count}: {robot:#?}"
        );
        let constants = program.rounded_constants();
        assert!(constants.iter().all(|x| !x.is_infinite()), "table {count}");
    }
}
