//! Closed forms of inverse kinematics: which arms have one, and that its proof refuses damage.

use std::fmt::Write;

use dynamics_symbolic::inverse::{Plan, Step, Target, plan};
use dynamics_symbolic::program::{Instruction, Program};
use dynamics_symbolic::prove::prove_inverse;
use dynamics_symbolic::robot::{Convention, JointType, Robot, Value};
use dynamics_symbolic::{inverse::Unsolved, proven_plan};
use expect_test::expect_file;

/// One line for each step.
fn shown(plan: &Plan) -> String {
    let operations = plan.program.operations();
    let mut text = format!(
        "{} solutions, {} operations, {:?}\n",
        plan.most(),
        operations.total(),
        plan.target
    );
    for step in &plan.steps {
        match step {
            Step::Joint(joint, rule) => writeln!(text, "    joint {}: {rule:?}", joint + 1),
            Step::Direction(place) => writeln!(text, "    numbers from {place}: Direction"),
            Step::Condition => writeln!(text, "    nothing: Condition"),
        }
        .expect("memory");
    }
    let names = &plan.branches.names;
    if let [first, .., last] = &names[..] {
        writeln!(text, "    {first}; ...; {last}").expect("memory");
    }
    text
}

/// The plans of the data files, or why there is none.
#[test]
fn plans_of_the_data_files() {
    let mut text = String::new();
    for name in arms::NAMES {
        let shown = match proven_plan(&arms::robot(name), None) {
            Ok(plan) => shown(&plan),
            Err(why) => format!("none, because {why}\n"),
        };
        writeln!(text, "{name}: {}", shown.trim_end()).expect("memory");
    }
    expect_file!["../golden/closed_forms.txt"].assert_eq(&text);
}

/// Lengths that are fields of the struct: the class does not depend on them.
#[test]
fn lengths_may_be_fields() {
    let mut robot = arms::robot("puma560");
    let numbers = proven_plan(&robot, None).expect("a spherical wrist");
    robot.fields = vec!["upper".to_owned(), "fore".to_owned()];
    robot.rows[1].a = Value::Field(0);
    robot.rows[3].d = Value::Field(1);
    let plan = proven_plan(&robot, None).expect("the same class");
    assert_eq!(plan.steps, numbers.steps);
}

/// A step that makes the axes of the wrist miss each other, however short, is no spherical wrist.
#[test]
fn axes_that_nearly_meet_do_not() {
    let mut robot = arms::robot("puma560");
    robot.rows[4].a = arms::decimal(1e-6);
    assert_eq!(proven_plan(&robot, None).err(), Some(Unsolved::NoThreeAxes));
}

/// The plan with another program.
fn with_program(plan: &Plan, program: Program) -> Plan {
    Plan {
        program,
        ..plan.clone()
    }
}

fn is_proven(robot: &Robot, plan: &Plan) -> bool {
    prove_inverse(robot, None, plan)
}

/// Another operation, and another sign of a coefficient, anywhere in the program.
#[test]
fn every_damage_is_found() {
    let named = ["puma560", "ur5", "stanford", "scara", "elbow_3r"];
    let named = named.map(|name| (name, arms::robot(name)));
    for (name, robot) in named.into_iter().chain([("so100", five_axes())]) {
        let right = proven_plan(&robot, None).expect(name);
        let program = &right.program;
        for index in 0..program.instructions.len() {
            let mut damaged = program.clone();
            damaged.instructions[index] = match damaged.instructions[index] {
                Instruction::Add(a, b) => Instruction::Sub(a, b),
                Instruction::Sub(a, b) => Instruction::Add(a, b),
                Instruction::Mul(a, b) => Instruction::Add(a, b),
                Instruction::Div(a, b) => Instruction::Mul(a, b),
            };
            let sizes = only_sizes(&right, index);
            let plan = with_program(&right, damaged);
            assert_eq!(is_proven(&robot, &plan), sizes, "{name}: operation {index}");
        }
    }
}

/// A waist and three parallel axes, and the same with a step between the tip and the last axis.
#[test]
fn waists_have_a_closed_form() {
    let mut robot = arms::robot("elbow_3r");
    let mut last = robot.rows[2].clone();
    last.name = "pitch".to_owned();
    robot.rows.push(last);
    let plan = proven_plan(&robot, None).expect("a waist");
    assert_eq!(plan.target, Target::Pose);
    assert_eq!(plan.branches.names, ["elbow down", "elbow up"]);
    robot.rows[0].a = arms::decimal(0.012);
    robot.rows[1].theta = arms::decimal(1.3854);
    proven_plan(&robot, None).expect("a waist with a step");
}

/// A waist, three parallel axes and a roll, with a step beside the waist.
fn five_axes() -> Robot {
    let mut robot = arms::robot("elbow_3r");
    let [mut pitch, mut roll] = ["pitch", "roll"].map(|name| {
        let mut row = robot.rows[2].clone();
        row.name = name.to_owned();
        row.a = Value::zero();
        row
    });
    robot.rows[1].d = arms::decimal(0.01);
    (pitch.alpha, pitch.theta) = (
        arms::decimal(0.5) * Value::Pi,
        arms::decimal(0.5) * Value::Pi,
    );
    roll.d = arms::decimal(0.1);
    robot.rows.extend([pitch, roll]);
    robot
}

/// The geometry of a KUKA LBR iiwa 14.
fn seven_axes() -> Robot {
    let mut robot = arms::robot("panda");
    let rows = [
        (0.36, -1),
        (0.0, 1),
        (0.42, 1),
        (0.0, -1),
        (0.4, -1),
        (0.0, 1),
        (0.126, 0),
    ];
    robot.convention = Convention::Standard;
    for (row, (d, quarters)) in robot.rows.iter_mut().zip(rows) {
        (row.a, row.d) = (Value::zero(), arms::decimal(d));
        row.alpha = arms::decimal(0.5 * f64::from(quarters)) * Value::Pi;
    }
    robot
}

/// Another operation in the numbers of the elbow's angle.
#[test]
fn damaged_elbows_are_refused() {
    let robot = seven_axes();
    let right = proven_plan(&robot, None).expect("seven axes");
    let program = right.elbow.clone().expect("an elbow");
    for index in 0..program.instructions.len() {
        let mut damaged = program.clone();
        damaged.instructions[index] = match damaged.instructions[index] {
            Instruction::Add(a, b) => Instruction::Sub(a, b),
            Instruction::Sub(a, b) => Instruction::Add(a, b),
            Instruction::Mul(a, b) | Instruction::Div(a, b) => Instruction::Add(a, b),
        };
        let plan = Plan {
            elbow: Some(damaged),
            ..right.clone()
        };
        assert!(!is_proven(&robot, &plan), "operation {index}");
    }
}

/// Whether an operation serves nothing but the sizes by which rounding is judged, which no proof is about.
fn only_sizes(plan: &Plan, index: usize) -> bool {
    use dynamics_symbolic::inverse::Rule;
    use dynamics_symbolic::program::Operand;
    let steps = plan.steps.iter().enumerate();
    let proven = steps.flat_map(|(number, step)| {
        let first = plan.outputs_of(number).start;
        let count = match step {
            Step::Joint(_, Rule::TurnsOfLine) => 6,
            Step::Joint(_, Rule::Turns) => 4,
            Step::Joint(_, Rule::Turn) | Step::Direction(_) | Step::Condition => 3,
            Step::Joint(_, Rule::Slides) => 2,
            Step::Joint(_, Rule::Slide) => 1,
        };
        first..first + count
    });
    let mut needed = vec![false; plan.program.instructions.len()];
    let mut stack: Vec<Operand> = proven
        .map(|output| plan.program.outputs[output].operand)
        .collect();
    while let Some(operand) = stack.pop() {
        if let Operand::Result(result) = operand {
            let result = result as usize;
            if !needed[result] {
                needed[result] = true;
                stack.extend(plan.program.instructions[result].operands());
            }
        }
    }
    !needed[index]
}

/// A plan whose equation leaves out a solution, or takes one that is none, is not proven.
#[test]
fn steps_in_another_order_are_refused() {
    let robot = arms::robot("puma560");
    let right = proven_plan(&robot, None).expect("a spherical wrist");
    assert!(is_proven(&robot, &right));
    let other = arms::robot("ur5");
    assert!(!is_proven(&other, &right));
    let refused = plan(&robot, None, &|_| false);
    assert!(refused.is_err());
}

/// Random tables of quarter turns and short steps: each has a plan, or a reason why there is none.
#[test]
fn random_tables_end() {
    let mut random = arms::Tables::new(1, arms::Bodies::Any);
    let quarter = |k: u64| arms::decimal(0.5 * k as f64 - 0.5) * Value::Pi;
    let model = arms::robot("puma560");
    let mut plans = 0;
    for _ in 0..300 {
        let joints = [1, 2, 3, 3, 4, 6, 6, 6, 7][random.below(9) as usize];
        let mut robot = model.clone();
        robot.rows.resize(joints, model.rows[3].clone());
        for row in &mut robot.rows {
            let slides = random.below(4) == 0;
            row.joint_type = if slides {
                JointType::Prismatic
            } else {
                JointType::Revolute
            };
            row.alpha = quarter(random.below(3));
            let mut step = || arms::decimal(0.07 * random.below(6).saturating_sub(2) as f64);
            (row.a, row.d, row.theta) = (step(), step(), Value::zero());
        }
        plans += usize::from(proven_plan(&robot, None).is_ok());
    }
    assert!(plans > 40, "{plans}");
}
