//! Robots with branches: the recursions agree with the textbook, which differentiates.

use super::functions::{Form, Part, outputs};
use super::gauge::Gauge;
use super::symbols::Symbols;
use super::textbook::Textbook;
use crate::exact::Rational;
use crate::expr::{Direction, Expr, Graph};
use crate::function::{Argument, Function};
use crate::mechanism::{Frame, Mechanism};
use crate::robot::{Carrier, Convention, Coupling, JointType, Robot, Row, Value};

fn number(thousandths: i64) -> Value {
    Value::Rational(Rational::from_parts_signed(
        thousandths.into(),
        1_000_u16.into(),
    ))
}

/// Joints 1 and 2 stand on link 0, joint 3 on link 2, which carries the tip.
fn branched() -> Mechanism {
    let quarter = Value::Pi * number(500);
    let row = |i: i64, joint_type, alpha: &Value| Row {
        a: number(100 + 30 * i),
        alpha: alpha.clone(),
        d: number(70 * i),
        theta: number(0),
        mass: number(1_000 + 300 * i),
        com: [number(50 + 7 * i), number(-20 * i), number(90)],
        inertia: [110, 90, 70, 5, -3, 2].map(|entry| number(entry + 10 * i)),
        gear_ratio: number(3_000),
        motor_inertia: number(2 + i),
        ..Row::new(format!("joint{i}"), joint_type)
    };
    let robot = Robot {
        name: "Branched".to_owned(),
        fields: Vec::new(),
        convention: Convention::Modified,
        gravity: [number(1_000), number(0), number(-9_810)],
        base: None,
        rows: vec![
            row(0, JointType::Revolute, &Value::zero()),
            row(1, JointType::Revolute, &quarter),
            Row {
                on: Carrier::Row(0),
                ..row(2, JointType::Prismatic, &quarter)
            },
            row(3, JointType::Revolute, &-quarter.clone()),
        ],
        tool: None,
        frames: Vec::new(),
        neglected: None,
        bounds: Default::default(),
    };
    let tip = Frame {
        link: Some(3),
        places: Vec::new(),
    };
    Mechanism {
        tip,
        ..Mechanism::from(&robot)
    }
}

/// The outputs of a function in all its forms and in two gauges.
fn of_all_forms<'g>(symbols: &mut Symbols<'g>, function: Function) -> Vec<Vec<Expr<'g>>> {
    let arm = symbols.arm();
    let forms = [Form::Recursive, Form::Assembled, Form::Columns];
    let parts = forms.map(|form| Part::new(function, form));
    let mut all = Vec::new();
    for part in parts {
        for gauge in [Gauge::plain(arm.joints.len()), Gauge::search(arm, &[part])] {
            let chain = gauge.chain(symbols);
            all.push(outputs(symbols, &chain, part));
        }
    }
    all
}

fn dot<'g>(zero: Expr<'g>, a: &[Expr<'g>], b: &[Expr<'g>]) -> Expr<'g> {
    a.iter().zip(b).fold(zero, |sum, (&a, &b)| sum + a * b)
}

fn along<'g>(values: &[Expr<'g>], directions: &[Direction<'g>]) -> Vec<Expr<'g>> {
    let slopes = |x: &Expr<'g>| -> Vec<_> { directions.iter().map(|d| x.derivative(d)).collect() };
    values.iter().flat_map(slopes).collect()
}

#[test]
fn recursions_on_branches_are_the_textbook() {
    let (graph, arm) = (Graph::new(), branched());
    let mut symbols = Symbols::new(&graph, &arm);
    let (zero, one, n) = (graph.zero(), graph.one(), arm.joints.len());
    let textbook = Textbook::new(&mut symbols);
    let inertia = textbook.mass_matrix.clone();
    assert!(inertia[1][2].is_zero() && inertia[1][3].is_zero());
    let [qd, qdd] = [
        symbols.all(|joint| joint.qd),
        symbols.all(|joint| joint.qdd),
    ];
    let rest = textbook
        .coriolis_vector
        .iter()
        .zip(&textbook.gravity_vector);
    let forces = inertia.iter().zip(rest);
    let forces: Vec<_> = forces
        .map(|(row, (&v, &g))| dot(v + g, row, &qdd))
        .collect();
    let along_q = |j| symbols.along_position(Direction::new(), j, one);
    let along_qd = |j: usize| Direction::new().with(qd[j], one);
    let directions = [
        (0..n).map(along_q).collect::<Vec<_>>(),
        (0..n).map(along_qd).collect(),
    ];
    let [positions, velocities] = &directions;
    let [by_position, by_velocity] = [along(&forces, positions), along(&forces, velocities)];
    let second = [
        along(&by_position, positions),
        along(&by_velocity, velocities),
        along(&by_position, velocities),
        along(&inertia.concat(), positions),
    ];
    let momentum = inertia.iter().map(|row| dot(zero, row, &qd)).collect();
    let expected = [
        (Function::MassMatrix, inertia.concat()),
        (Function::CoriolisVector, textbook.coriolis_vector),
        (Function::GravityVector, textbook.gravity_vector),
        (Function::KineticEnergy, vec![textbook.kinetic_energy]),
        (Function::PotentialEnergy, vec![textbook.potential_energy]),
        (Function::InverseDynamics, forces),
        (Function::GeneralizedMomentum, momentum),
        (
            Function::InverseDynamicsDerivatives,
            [by_position, by_velocity].concat(),
        ),
        (Function::InverseDynamicsSecondDerivatives, second.concat()),
    ];
    for (function, expected) in expected {
        for found in of_all_forms(&mut symbols, function) {
            assert_eq!(found, expected, "{}", function.name());
        }
    }
}

/// tau = M qdd + V + G for the accelerations of both algorithms, and by the regressor.
#[test]
fn accelerations_and_regressors_on_branches_fit_the_forces() {
    let (graph, arm) = (Graph::new(), branched());
    let mut symbols = Symbols::new(&graph, &arm);
    let (zero, n) = (graph.zero(), arm.joints.len());
    let plain = Gauge::plain(n).chain(&mut symbols);
    let mut of = |function, form| outputs(&mut symbols, &plain, Part::new(function, form));
    let inertia = of(Function::MassMatrix, Form::Recursive);
    let bias = of(Function::BiasForce, Form::Recursive);
    let accelerations = [
        of(Function::ForwardDynamics, Form::Recursive),
        of(Function::ForwardDynamics, Form::Articulated),
        of(Function::ForwardDynamicsAba, Form::Recursive),
    ];
    let parameters = of(Function::BaseParameters, Form::Recursive);
    let regressors = [Form::Recursive, Form::Assembled].map(|form| of(Function::Regressor, form));
    let forces = of(Function::InverseDynamics, Form::Recursive);
    let rates =
        [Form::Recursive, Form::Assembled].map(|form| of(Function::InverseDynamicsRates, form));
    assert_eq!(rates[0], rates[1]);
    for qdd in accelerations {
        for (i, row) in inertia.chunks(n).enumerate() {
            let force = dot(bias[i], row, &qdd[..n]);
            assert_eq!(force, symbols.joint(i).tau);
        }
    }
    for regressor in regressors {
        let rows = regressor.chunks(parameters.len());
        let found: Vec<_> = rows.map(|row| dot(zero, row, &parameters)).collect();
        assert_eq!(found, forces);
    }
}

/// Joint 1 does not move the tip.
#[test]
fn the_tip_on_a_branch_moves_by_its_jacobian() {
    let (graph, arm) = (Graph::new(), branched());
    let mut symbols = Symbols::new(&graph, &arm);
    let (zero, n) = (graph.zero(), arm.joints.len());
    let [qd, qdd] = [
        symbols.all(|joint| joint.qd),
        symbols.all(|joint| joint.qdd),
    ];
    let wrench: Vec<_> = (0..6).map(|k| symbols.entry(Argument::Wrench, k)).collect();
    let plain = Gauge::plain(n).chain(&mut symbols);
    let [jacobian, rate] = [Function::Jacobian, Function::JacobianRate]
        .map(|function| outputs(&mut symbols, &plain, Part::recursive(function)));
    assert!(jacobian.chunks(n).all(|row| row[1].is_zero()));
    let velocity: Vec<_> = jacobian.chunks(n).map(|row| dot(zero, row, &qd)).collect();
    let rows = jacobian.chunks(n).zip(rate.chunks(n));
    let acceleration: Vec<_> = rows
        .map(|(row, rate)| dot(dot(zero, row, &qdd), rate, &qd))
        .collect();
    let column = |j: usize| jacobian.chunks(n).map(|row| row[j]).collect::<Vec<_>>();
    let torques: Vec<_> = (0..n).map(|j| dot(zero, &column(j), &wrench)).collect();
    for (function, expected) in [
        (Function::ToolVelocity, velocity),
        (Function::ToolAcceleration, acceleration),
        (Function::WrenchTorques, torques),
    ] {
        for found in of_all_forms(&mut symbols, function) {
            assert_eq!(found, expected, "{}", function.name());
        }
    }
}

/// Joint 0 on the base, joints 1 and 2 on link 0, joint 3 on link 1 and joint 4 on link 2. Joint 0 is locked, and joint 4
/// follows joint 3, where that is said.
fn two_arms(is_locked: bool, is_coupled: bool) -> Mechanism {
    let row = |on| Row {
        on,
        mass: number(1_000),
        com: [number(100), number(0), number(50)],
        a: number(300),
        ..Row::new("joint", JointType::Revolute)
    };
    let carriers = [
        Carrier::Base,
        Carrier::Row(0),
        Carrier::Row(0),
        Carrier::Row(1),
        Carrier::Row(2),
    ];
    let mut rows = carriers.map(row).to_vec();
    rows[0].locked = is_locked.then(|| number(500));
    rows[4].follows = is_coupled.then(|| Coupling {
        leader: 3,
        factor: number(-1_000),
        offset: number(0),
    });
    Mechanism::from(&Robot {
        name: "TwoArms".to_owned(),
        fields: Vec::new(),
        convention: Convention::Modified,
        gravity: [number(0), number(-9_810), number(0)],
        base: None,
        rows,
        tool: None,
        frames: Vec::new(),
        neglected: None,
        bounds: Default::default(),
    })
}

#[test]
fn arms_on_one_base_are_groups_unless_one_follows_the_other() {
    assert_eq!(two_arms(false, false).groups(), [[0, 1, 2, 3, 4]]);
    assert_eq!(two_arms(true, false).groups(), [vec![0, 1, 3], vec![2, 4]]);
    assert_eq!(two_arms(true, true).groups(), [[0, 1, 2, 3, 4]]);
}

/// Half of two equal arms takes half the work.
#[test]
fn a_group_moves_as_if_it_were_alone() {
    let whole = two_arms(true, false);
    let part = whole.only(&[2, 4]);
    assert_eq!((part.dof(), part.free().collect()), (2, vec![2, 4]));
    let [both, one] = [&whole, &part].map(|arm| {
        let part = Part::recursive(Function::InverseDynamics);
        Gauge::plain(5).length(arm, &[part])
    });
    assert_eq!(both, 2 * one);
}
