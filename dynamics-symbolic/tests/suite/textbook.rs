//! The short derivations are the textbook's, as expressions: on the graph,
//! equal rational functions are one node.

use arms::{Bodies, Tables};
use dynamics_symbolic::Function;
use dynamics_symbolic::derive::functions::{Form, Part, outputs};
use dynamics_symbolic::derive::gauge::Gauge;
use dynamics_symbolic::derive::symbols::Symbols;
use dynamics_symbolic::derive::textbook::Textbook;
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::expr::{Direction, Expr, Graph};
use dynamics_symbolic::mechanism::Mechanism;
use dynamics_symbolic::robot::{Convention, Interpretation, JointType, Robot, Row, Value};

/// Up to four joints, both conventions, revolute and prismatic.
const SMALL: [&str; 14] = [
    "cylindrical_rpp",
    "elbow_3r",
    "gantry_ppp",
    "geared_link",
    "generic_chain_n2",
    "generic_chain_n3",
    "moving_mass",
    "one_link",
    "rrr_planar",
    "scara",
    "spherical_wrist",
    "two_link_craig",
    "two_link_saha",
    "vertical_mass",
];

#[test]
fn recursions_equal_the_textbook_expression_by_expression() {
    let plain = SMALL.map(arms::robot);
    let mut tables = Tables::new(12, Bodies::Any);
    let mounted = (0..12).map(|_| tables.mounted_robot());
    let mut tables = Tables::new(13, Bodies::Any);
    let coupled = (0..20).map(|_| without_springs(tables.coupled_robot()));
    let mut tables = Tables::new(14, Bodies::Any);
    let trees = (0..12).map(|_| without_springs(tables.tree()));
    let arms = plain.into_iter().chain(mounted).chain(coupled);
    for robot in arms.chain(trees) {
        let name = &robot.name;
        let graph = Graph::new();
        let arm = Mechanism::from(&robot);
        let mut symbols = Symbols::new(&graph, &arm);
        let textbook = Textbook::new(&mut symbols);
        let expected = [
            (Function::MassMatrix, textbook.mass_matrix.concat()),
            (Function::CoriolisVector, textbook.coriolis_vector),
            (Function::GravityVector, textbook.gravity_vector),
            (Function::KineticEnergy, vec![textbook.kinetic_energy]),
            (Function::PotentialEnergy, vec![textbook.potential_energy]),
        ];
        let chain = Gauge::plain(robot.rows.len()).chain(&mut symbols);
        for (function, expected) in expected {
            for form in function.forms(robot.dof()) {
                let short = outputs(&mut symbols, &chain, Part::new(function, form));
                assert_eq!(short, expected, "{name} {} {form:?}", function.name());
            }
        }
    }
}

/// Springs are not in the textbook's energy.
fn without_springs(mut robot: Robot) -> Robot {
    for row in &mut robot.rows {
        row.spring = None;
    }
    robot
}

/// d tau/dq and d tau/dqd are derivatives of M qdd + V + G, as expressions.
#[test]
fn derivatives_are_those_of_the_textbook_s_torques() {
    for name in SMALL {
        let mut robot = arms::robot(name);
        for row in &mut robot.rows {
            row.viscous = Value::zero();
        }
        let graph = Graph::new();
        let arm = Mechanism::from(&robot);
        let mut symbols = Symbols::new(&graph, &arm);
        let textbook = Textbook::new(&mut symbols);
        let n = robot.rows.len();
        let forces: Vec<_> = (0..n)
            .map(|i| {
                let rest = textbook.coriolis_vector[i] + textbook.gravity_vector[i];
                (0..n).fold(rest, |force, j| {
                    force + textbook.mass_matrix[i][j] * symbols.joint(j).qdd
                })
            })
            .collect();
        let one = graph.one();
        let along_q = |j| symbols.along_position(Direction::new(), j, one);
        let along_qd = |j| Direction::new().with(symbols.joint(j).qd, one);
        let directions = (0..n).map(along_q).chain((0..n).map(along_qd));
        let directions: Vec<_> = directions.collect();
        let mut expected = Vec::new();
        for directions in directions.chunks(n) {
            for force in &forces {
                expected.extend(directions.iter().map(|d| force.derivative(d)));
            }
        }
        let chain = Gauge::plain(n).chain(&mut symbols);
        let function = Function::InverseDynamicsDerivatives;
        for form in [Form::Recursive, Form::Assembled] {
            let short = outputs(&mut symbols, &chain, Part::new(function, form));
            assert_eq!(short, expected, "{name} {form:?}");
        }
        // d2 tau/dq dq, d2 tau/dqd dqd and d2 tau/dq dqd from the first ones, dM/dq from M.
        let (by_position, by_velocity) = expected.split_at(n * n);
        let (positions, velocities) = directions.split_at(n);
        let inertia = textbook.mass_matrix.concat();
        let mut expected = Vec::new();
        for (values, directions) in [
            (by_position, positions),
            (by_velocity, velocities),
            (by_position, velocities),
            (&inertia, positions),
        ] {
            for value in values {
                expected.extend(directions.iter().map(|d| value.derivative(d)));
            }
        }
        let function = Function::InverseDynamicsSecondDerivatives;
        for form in [Form::Recursive, Form::Assembled] {
            let short = outputs(&mut symbols, &chain, Part::new(function, form));
            assert_eq!(short, expected, "{name} {form:?}");
        }
    }
}

/// A planar link along x: its mass, centre, inertia about z, length.
fn planar_link(name: &str, a: Value, mass: Value, com_x: Value, inertia_zz: Value) -> Row {
    let zero = Value::zero;
    Row {
        a,
        mass,
        com: [com_x, zero(), zero()],
        inertia: [
            zero(),
            inertia_zz.clone(),
            inertia_zz,
            zero(),
            zero(),
            zero(),
        ],
        gear_ratio: Value::integer(1),
        ..Row::new(name, JointType::Revolute)
    }
}

fn planar_robot(
    convention: Convention,
    fields: &[&str],
    gravity: [Value; 3],
    rows: Vec<Row>,
) -> Robot {
    let fields = fields.iter().map(|&field| field.to_owned()).collect();
    Robot {
        name: "planar".to_owned(),
        fields,
        convention,
        gravity,
        rows,
        frames: Vec::new(),
        neglected: None,
        bounds: Default::default(),
        base: None,
        tool: None,
    }
}

fn number(numerator: i64, denominator: u64) -> Rational {
    Rational::from_parts(numerator.into(), denominator.into())
}

/// Craig, Introduction to Robotics, 3rd edition, (6.60) to (6.62): point masses at the ends of the links.
#[test]
fn two_link_arm_of_craig_as_printed() {
    let [m1, m2, l1, l2, g] = [0, 1, 2, 3, 4].map(Value::field);
    let standard = vec![
        planar_link(
            "shoulder",
            l1.clone(),
            m1.clone(),
            Value::zero(),
            Value::zero(),
        ),
        planar_link(
            "elbow",
            l2.clone(),
            m2.clone(),
            Value::zero(),
            Value::zero(),
        ),
    ];
    let modified = vec![
        planar_link("shoulder", Value::zero(), m1, l1.clone(), Value::zero()),
        planar_link("elbow", l1, m2, l2, Value::zero()),
    ];
    for (convention, rows) in [
        (Convention::Standard, standard),
        (Convention::Modified, modified),
    ] {
        let gravity = [Value::zero(), -g.clone(), Value::zero()];
        let robot = planar_robot(convention, &["m1", "m2", "l1", "l2", "g"], gravity, rows);
        let graph = Graph::new();
        let arm = Mechanism::from(&robot);
        let mut symbols = Symbols::new(&graph, &arm);
        let [m1, m2, l1, l2, g] = [0, 1, 2, 3, 4].map(|i| symbols.field(i));
        let two = graph.rational(&Rational::from(2));
        let (s1, c1) = symbols.joint(0).sin_cos;
        let (s2, c2) = symbols.joint(1).sin_cos;
        let c12 = c1 * c2 - s1 * s2;
        let (qd1, qd2) = (symbols.joint(0).qd, symbols.joint(1).qd);
        let coupled = l2 * l2 * m2 + l1 * l2 * m2 * c2;
        let mass_matrix = [
            l2 * l2 * m2 + two * l1 * l2 * m2 * c2 + l1 * l1 * (m1 + m2),
            coupled,
            coupled,
            l2 * l2 * m2,
        ];
        let coriolis_vector = [
            -(m2 * l1 * l2 * s2 * qd2 * qd2) - two * m2 * l1 * l2 * s2 * qd1 * qd2,
            m2 * l1 * l2 * s2 * qd1 * qd1,
        ];
        let gravity_vector = [
            m2 * l2 * g * c12 + (m1 + m2) * l1 * g * c1,
            m2 * l2 * g * c12,
        ];
        let b = -(two * m2 * l1 * l2 * s2);
        let c = m2 * l1 * l2 * s2;
        let zero = graph.zero();
        let chain = Gauge::plain(2).chain(&mut symbols);
        let mut check = |function: Function, expected: &[Expr<'_>]| {
            let computed = outputs(&mut symbols, &chain, Part::recursive(function));
            assert_eq!(computed, expected, "{convention:?} {}", function.name());
        };
        check(Function::MassMatrix, &mass_matrix);
        check(Function::CoriolisVector, &coriolis_vector);
        check(Function::GravityVector, &gravity_vector);
        // (6.63): B [qd1 qd2] and C [qd1^2 qd2^2]
        check(Function::CoriolisCoefficients, &[b, zero]);
        check(Function::CentrifugalCoefficients, &[zero, -c, c, zero]);
    }
}

/// Saha's slides: two slender rods; h and gamma as there, gamma_2 with m2 (see docs/ERRATA.md).
#[test]
fn two_link_arm_with_slender_rods() {
    let [m1, m2, a1, a2, g] = [0, 1, 2, 3, 4].map(Value::field);
    let twelfth = || Value::Rational(number(1, 12));
    let minus_half = || Value::Rational(number(-1, 2));
    let rod = |name, a: Value, m: Value| {
        let inertia = twelfth() * m.clone() * a.clone() * a.clone();
        planar_link(name, a.clone(), m, minus_half() * a, inertia)
    };
    let rows = vec![rod("shoulder", a1, m1), rod("elbow", a2, m2)];
    let gravity = [Value::zero(), -g, Value::zero()];
    let robot = planar_robot(
        Convention::Standard,
        &["m1", "m2", "a1", "a2", "g"],
        gravity,
        rows,
    );
    let graph = Graph::new();
    let arm = Mechanism::from(&robot);
    let mut symbols = Symbols::new(&graph, &arm);
    let [m1, m2, a1, a2, g] = [0, 1, 2, 3, 4].map(|i| symbols.field(i));
    let constant = |n, d| graph.rational(&number(n, d));
    let (half, quarter, twelfth) = (constant(1, 2), constant(1, 4), constant(1, 12));
    let (s1, c1) = symbols.joint(0).sin_cos;
    let (s2, c2) = symbols.joint(1).sin_cos;
    let c12 = c1 * c2 - s1 * s2;
    let (qd1, qd2) = (symbols.joint(0).qd, symbols.joint(1).qd);
    let (izz1, izz2) = (twelfth * m1 * a1 * a1, twelfth * m2 * a2 * a2);
    let i11 =
        quarter * m1 * a1 * a1 + izz1 + m2 * (a1 * a1 + quarter * a2 * a2 + a1 * a2 * c2) + izz2;
    let i22 = quarter * m2 * a2 * a2 + izz2;
    let i12 = m2 * (quarter * a2 * a2 + half * a1 * a2 * c2) + izz2;
    let h1 = -(m2 * a1 * a2 * s2 * qd1 * qd2) - half * m2 * a1 * a2 * s2 * qd2 * qd2;
    let h2 = half * m2 * a1 * a2 * s2 * qd1 * qd1;
    let gamma1 = half * m1 * g * a1 * c1 + m2 * g * (a1 * c1 + half * a2 * c12);
    let gamma2 = half * m2 * g * a2 * c12;
    let chain = Gauge::plain(2).chain(&mut symbols);
    let mut check = |function: Function, expected: &[Expr<'_>]| {
        let computed = outputs(&mut symbols, &chain, Part::recursive(function));
        assert_eq!(computed, expected, "{}", function.name());
    };
    check(Function::MassMatrix, &[i11, i12, i12, i22]);
    check(Function::CoriolisVector, &[h1, h2]);
    check(Function::GravityVector, &[gamma1, gamma2]);
}
