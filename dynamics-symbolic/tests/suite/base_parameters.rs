//! Base inertial parameters: how many there are, and that the programs hold for any inertia.

use dynamics_symbolic::derive::base::columns;
use dynamics_symbolic::derive::derive;
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::program::{Instruction, Program};
use dynamics_symbolic::prove::prove;
use dynamics_symbolic::robot::{Base, Body, Convention, JointType, Parameter, Robot, Row, Value};
use dynamics_symbolic::robot::{Coefficient, Grouping};
use dynamics_symbolic::{Function, expand};
use std::collections::HashMap;

const FUNCTIONS: [Function; 2] = [Function::Regressor, Function::BaseParameters];

fn count(robot: &Robot) -> usize {
    Grouping::of(robot).count()
}

fn without_motors(name: &str) -> Robot {
    let mut robot = arms::robot(name);
    for row in &mut robot.rows {
        row.motor_inertia = Value::zero();
        row.gear_ratio = Value::zero();
    }
    robot
}

/// PUMA 560: Mayeda, Yoshida and Osuka 1990. Panda: Gaz et al. 2019. Revolute joints in general
/// position on a vertical first axis: 1 + 7 (n - 1), Gautier and Khalil 1990.
#[test]
fn as_many_as_in_the_literature() {
    for (name, expected) in [
        ("puma560", 36),
        ("panda", 43),
        ("ur5", 36),
        ("aristo", 36),
        ("generic_chain_n3", 15),
        ("generic_chain_n7", 43),
        ("generic_chain_n12", 78),
        // J_zz, h_x and h_y of each link: planar, in a vertical plane.
        ("rrr_planar", 9),
        ("two_link_saha", 6),
        // J_zz of two links, h of the second, the mass that is lifted, J_zz and h of the hand.
        ("scara", 8),
        // Masses and the one inertia about the vertical axis; h_z of the arm that slides.
        ("cylindrical_rpp", 5),
        // M1 + M2 + M3, M2 + M3, M3.
        ("gantry_ppp", 3),
        ("one_link", 3),
        ("moving_mass", 1),
    ] {
        assert_eq!(count(&without_motors(name)), expected, "{name}");
    }
}

/// The motor of a joint whose axis cannot turn by itself is grouped with J_zz: joints 1 and 2 of an
/// elbow arm.
#[test]
fn motors_are_parameters_where_the_forces_tell_them_apart() {
    for (name, expected) in [("puma560", 36 + 4), ("elbow_3r", 15 + 1), ("scara", 8 + 1)] {
        assert_eq!(count(&arms::robot(name)), expected, "{name}");
    }
    let grouping = Grouping::of(&arms::robot("puma560"));
    let motors = columns(&grouping).into_iter();
    let motors = motors.filter(|&(_, parameter)| parameter == Parameter::Motor);
    assert_eq!(
        motors.map(|(link, _)| link).collect::<Vec<_>>(),
        [2, 3, 4, 5]
    );
}

/// Without gravity, or with gravity along the axis, the first link has J_zz alone.
#[test]
fn gravity_shows_moments() {
    let mut arm = arms::robot("rrr_planar");
    arm.gravity = [(); 3].map(|()| Value::zero());
    assert_eq!(count(&arm), 9 - 2);
    arm.gravity[2] = Value::integer(-10);
    assert_eq!(count(&arm), 9 - 2);
    // A field may point anywhere.
    arm.gravity[0] = Value::field(0);
    arm.fields = vec!["g".to_owned()];
    assert_eq!(count(&arm), 9);
}

/// Values of masses and inertias in the table do not change the structure.
#[test]
fn a_parameter_that_is_zero_keeps_its_column() {
    for name in ["puma560", "stanford", "scara", "panda"] {
        let robot = arms::robot(name);
        let mut empty = robot.clone();
        for row in &mut empty.rows {
            row.mass = Value::zero();
            row.com = [(); 3].map(|()| Value::zero());
            row.inertia = [(); 6].map(|()| Value::zero());
            row.motor_inertia = Value::zero();
        }
        assert_eq!(
            columns(&Grouping::of(&empty)),
            columns(&Grouping::of(&robot))
        );
        // The forces of nothing are zero, and the regressor is that of the arm.
        let [regressor, parameters] = FUNCTIONS.map(|f| derive(&empty, f));
        assert_eq!(prove(&robot, FUNCTIONS[0], &regressor), Ok(()), "{name}");
        assert_eq!(prove(&empty, FUNCTIONS[1], &parameters), Ok(()), "{name}");
        assert!(
            parameters
                .rounded_constants()
                .iter()
                .all(|&x| x == 0.0 || x.is_nan())
        );
    }
}

fn divides(program: &Program) -> bool {
    let divisions = |i: &&Instruction| matches!(i, Instruction::Div(..));
    program.instructions.iter().any(|i| divisions(&i))
}

/// For every mass distribution at once: the fields are random numbers to the proof.
#[test]
fn base_parameters_hold_for_any_inertia() {
    for name in ["puma560", "stanford", "scara", "generic_mixed_n6_standard"] {
        let robot = arms::with_inertial_fields(name);
        for function in FUNCTIONS {
            let program = derive(&robot, function);
            assert_eq!(prove(&robot, function, &program), Ok(()), "{name}");
            assert!(!divides(&program));
        }
    }
}

fn row(joint_type: JointType, [a, alpha, d, theta]: [Value; 4]) -> Row {
    Row {
        a,
        alpha,
        d,
        theta,
        mass: Value::integer(1),
        com: [1, 2, 3].map(Value::integer),
        inertia: [7, 8, 9, 1, 2, 3].map(Value::integer),
        ..Row::new("joint", joint_type)
    }
}

fn arm(convention: Convention, gravity: [i64; 3], fields: usize, rows: Vec<Row>) -> Robot {
    Robot {
        name: "arm".to_owned(),
        fields: (0..fields).map(|i| format!("p{i}")).collect(),
        convention,
        gravity: gravity.map(Value::integer),
        rows,
        frames: Vec::new(),
        neglected: None,
        bounds: Default::default(),
        base: None,
        tool: None,
    }
}

fn assert_proven(robot: &Robot, expected: usize) {
    assert_eq!(count(robot), expected);
    for function in FUNCTIONS {
        let program = derive(robot, function);
        assert_eq!(prove(robot, function, &program), Ok(()));
        assert!(!divides(&program), "a parameter may be zero at run time");
    }
}

/// A wrist in free space turns about one point, so that h_x of its hand, at the height d from there,
/// is d times a J_xz: the parameter d stays a factor, never a divisor.
#[test]
fn a_wrist_in_free_space() {
    let zero = Value::zero;
    for convention in [Convention::Standard, Convention::Modified] {
        let angle = || Value::field(1);
        let rows = [zero(), zero(), Value::field(0)]
            .map(|d| row(JointType::Revolute, [zero(), angle(), d, zero()]));
        let robot = arm(convention, [0, 0, 0], 2, rows.to_vec());
        let grouping = Grouping::of(&robot);
        let heights = grouping.links[2].ties.iter();
        let heights = heights.filter(|tie| tie.coefficient == Coefficient::Height);
        assert_eq!(heights.count(), 2);
        // J of the three links, as far as they are told apart.
        assert_proven(&robot, 1 + 5 + 5);
    }
}

/// A sliding link behind one revolute joint, at any angle to its axis: the first moment along the
/// axis has no effect but that of a link in front of it, whatever the parameters alpha and theta.
#[test]
fn a_rail_at_any_angle() {
    let zero = Value::zero;
    for (alpha, theta) in [
        (Value::field(0), Value::field(1)),
        (Value::integer(1), Value::integer(2)),
        (zero(), Value::integer(2)),
    ] {
        let mut rows = vec![
            row(JointType::Revolute, [zero(), zero(), zero(), zero()]),
            row(
                JointType::Prismatic,
                [Value::field(2), alpha.clone(), zero(), theta],
            ),
        ];
        rows[1].motor_inertia = Value::field(3);
        rows[1].gear_ratio = Value::integer(2);
        let robot = arm(Convention::Modified, [0, 0, -10], 4, rows);
        // J_zz, m and the motor; two first moments too, unless the rail is parallel to the axis.
        assert_proven(&robot, if alpha.is_zero() { 3 } else { 5 });
    }
}

/// Other columns than the base parameters', or the same in another order, are not proven.
#[test]
fn other_columns_are_refused() {
    let robot = arms::robot("scara");
    let sound = derive(&robot, Function::Regressor);
    let parameters = derive(&robot, Function::BaseParameters);
    let columns = sound.outputs.len() / 4;
    let refused = |program: &Program, function| prove(&robot, function, program).is_err();
    let mut swapped = sound.clone();
    for row in 0..4 {
        swapped.outputs.swap(row * columns, row * columns + 1);
    }
    assert!(refused(&swapped, Function::Regressor));
    let mut repeated = sound.clone();
    for row in (1..=4).rev() {
        let last = repeated.outputs[row * columns - 1];
        repeated.outputs.insert(row * columns, last);
    }
    assert!(refused(&repeated, Function::Regressor));
    let mut short = parameters.clone();
    short.outputs.pop();
    assert!(refused(&short, Function::BaseParameters));
    let mut other = robot.clone();
    other.rows[3].com[0] = arms::decimal(0.123);
    let other = derive(&other, Function::BaseParameters);
    assert!(refused(&other, Function::BaseParameters));
}

/// The formulas in the documentation are the values: each is worked out from the table.
#[test]
fn formulas_in_the_documentation_are_right() {
    for name in arms::NAMES {
        assert_documented(&arms::robot(name));
    }
}

/// The ten parameters of the base's body have the number 0.
#[test]
fn formulas_on_a_base_that_moves_are_right() {
    let ratio = |a: i64, b: i64| Value::Rational(Rational::from(a) / Rational::from(b));
    let body = Body {
        mass: ratio(7, 2),
        com: [ratio(1, 5), ratio(-3, 7), ratio(2, 9)],
        inertia: [(5, 2), (7, 3), (9, 4), (1, 5), (-1, 6), (1, 7)].map(|(a, b)| ratio(a, b)),
    };
    for name in [
        "elbow_3r",
        "stanford",
        "puma560",
        "generic_mixed_n6_standard",
    ] {
        let base = Some(Base::Floating(body.clone()));
        let robot = Robot {
            base,
            ..arms::robot(name)
        };
        assert_documented(&robot);
        // A body alone.
        assert_documented(&Robot {
            rows: Vec::new(),
            tool: None,
            ..robot
        });
    }
}

fn assert_documented(robot: &Robot) {
    let name = &robot.name;
    let path = quote::quote!(robot_dynamics);
    let methods = expand(robot, &[Function::BaseParameters], &path).expect("proven");
    let file = syn::parse2(methods[0].tokens.clone()).expect("a method");
    let syn::ImplItem::Fn(method) = file else {
        panic!("a method")
    };
    let text = prettyplease::unparse(&syn::parse2(quote::quote!(impl R { #method })).unwrap());
    let mut values = Names::of(robot);
    let lines: Vec<_> = text
        .lines()
        .map(|line| line.trim().trim_start_matches("///"))
        .collect();
    // Steps are written from the base outwards, and read those further out.
    for (name, formula) in lines
        .iter()
        .rev()
        .filter_map(|line| line.split_once("' = "))
    {
        let value = values.evaluate(formula);
        values.0.insert(format!("{}'", name.trim()), value);
    }
    let columns = (1..).map_while(|k| {
        let start = format!(" {k:3}  ");
        lines.iter().find_map(|line| line.strip_prefix(&start))
    });
    let program = derive(robot, Function::BaseParameters);
    let constants = program.rounded_constants();
    let mut checked = 0;
    for (formula, output) in columns.zip(&program.outputs) {
        let dynamics_symbolic::program::Operand::Constant(id) = output.operand else {
            panic!("a number")
        };
        let expected = constants[id.index()] * if output.negative { -1.0 } else { 1.0 };
        let value = values.evaluate(formula);
        assert!(
            (value - expected).abs() < 1e-13 * (1.0 + expected.abs()),
            "{name} {formula}"
        );
        checked += 1;
    }
    assert_eq!(checked, count(robot), "{name}");
}

/// The values of the names in formulas.
struct Names(HashMap<String, f64>);

impl Names {
    /// Cells by their names, and every link's parameters about its frame's origin.
    fn of(robot: &Robot) -> Self {
        let mut names = Names(HashMap::new());
        let number = |value: &Value| value.to_f64(&[]);
        if let Some(Body { mass, com, inertia }) = robot.floating() {
            let [xx, yy, zz, xy, yz, xz] = inertia.each_ref().map(number);
            let tensor = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
            names.add_body(0, number(mass), com.each_ref().map(number), tensor);
        }
        for (i, row) in robot.rows.iter().enumerate() {
            let i = i + 1;
            let [a, d, alpha, theta] = [&row.a, &row.d, &row.alpha, &row.theta].map(number);
            let (sine, cosine) = alpha.sin_cos();
            for (key, value) in [("a_", a), ("d_", d), ("sa_", sine), ("ca_", cosine)] {
                names.add(i, key, value);
            }
            names.add(i, "st_", theta.sin());
            names.add(i, "ct_", theta.cos());
            let mass = number(&row.mass);
            let [x, y, z] = [0, 1, 2].map(|k| number(&row.com[k]));
            let [xx, yy, zz, xy, yz, xz] = [0, 1, 2, 3, 4, 5].map(|k| number(&row.inertia[k]));
            let mut tensor = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
            let mut com = [x, y, z];
            if robot.convention == Convention::Standard {
                let turn = [[1.0, 0.0, 0.0], [0.0, cosine, -sine], [0.0, sine, cosine]];
                com = [x + a, cosine * y - sine * z, sine * y + cosine * z];
                let old = tensor;
                for (i, j) in (0..9).map(|k| (k / 3, k % 3)) {
                    let pairs = (0..9).map(|k| (k / 3, k % 3));
                    tensor[i][j] = pairs
                        .map(|(k, l)| turn[i][k] * old[k][l] * turn[j][l])
                        .sum();
                }
            }
            names.add_body(i, mass, com, tensor);
            let ratio = number(&row.gear_ratio);
            names.add(i, "I_", ratio * ratio * number(&row.motor_inertia));
        }
        names
    }

    /// A name, the letters before and behind the number of its link.
    fn add(&mut self, i: usize, name: &str, value: f64) {
        let (letter, entry) = name.split_at(name.find('_').unwrap());
        self.0.insert(format!("{letter}{i}{}", &entry[1..]), value);
    }

    /// The parameters of a body with this tensor about its centre of mass.
    fn add_body(&mut self, i: usize, mass: f64, com: [f64; 3], tensor: [[f64; 3]; 3]) {
        let square: f64 = com.iter().map(|c| c * c).sum();
        for (k, l, entry) in [
            (0, 0, "J_xx"),
            (1, 1, "J_yy"),
            (2, 2, "J_zz"),
            (0, 1, "J_xy"),
            (1, 2, "J_yz"),
            (0, 2, "J_xz"),
        ] {
            let diagonal = if k == l { square } else { 0.0 };
            self.add(i, entry, tensor[k][l] + mass * (diagonal - com[k] * com[l]));
        }
        for (entry, c) in ["h_x", "h_y", "h_z"].into_iter().zip(com) {
            self.add(i, entry, mass * c);
        }
        self.add(i, "m_", mass);
    }

    /// A sum of products, the last factor of which may be a sum in parentheses.
    fn evaluate(&self, sum: &str) -> f64 {
        let (mut total, mut sign, mut product, mut depth) = (0.0, 1.0, String::new(), 0);
        let sum = match sum.trim().strip_prefix('-') {
            Some(rest) => format!("- {rest}"),
            None => format!("+ {}", sum.trim()),
        };
        for word in sum.split(' ') {
            match word {
                "+" | "-" if depth == 0 => {
                    total += sign * self.product(&product);
                    sign = if word == "+" { 1.0 } else { -1.0 };
                    product.clear();
                }
                _ => product = format!("{product} {word}"),
            }
            depth += word.matches('(').count();
            depth -= word.matches(')').count();
        }
        total + sign * self.product(&product)
    }

    fn product(&self, product: &str) -> f64 {
        let product = product.trim();
        if product.is_empty() {
            return 0.0;
        }
        if let Some((factors, sum)) = product.split_once('(') {
            let sum = self.evaluate(sum.trim_end_matches(')'));
            return sum
                * if factors.is_empty() {
                    1.0
                } else {
                    self.product(factors)
                };
        }
        let factor = |word: &str| {
            let (name, power) = word.split_once('^').unwrap_or((word, "1"));
            let value = name.parse().unwrap_or_else(|_| self.0[name]);
            f64::powi(value, power.parse().unwrap())
        };
        product.split(' ').map(factor).product()
    }
}

/// Links of the same length are links of any length.
#[test]
fn lengths_do_not_matter_to_the_structure() {
    let half = Value::Rational(Rational::from_parts(1.into(), 2_u32.into()));
    let mut robot = arms::robot("elbow_3r");
    let before = columns(&Grouping::of(&robot));
    robot.rows[1].a = half.clone();
    robot.rows[2].a = half;
    assert_eq!(columns(&Grouping::of(&robot)), before);
}
