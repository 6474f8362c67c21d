//! Formulas: equal to the books, and what is shown is what is computed.

use dynamics_symbolic::Function;
use dynamics_symbolic::derive::derive;
use dynamics_symbolic::formula::{Budget, Format, Formulas, Structure};
use dynamics_symbolic::robot::{Base, Robot, Symbol, Value};
use interpreter::At;

const BUDGET: Budget = Budget {
    terms: 400,
    products: 20_000,
};

/// Saha's: two uniform rods, with the centres of mass in their middles.
fn two_link_saha() -> Robot {
    let mut robot = arms::robot("two_link_saha");
    robot.fields = ["m1", "m2", "a1", "a2", "g"].map(str::to_owned).to_vec();
    let over = |n: i64, value: Value| value.checked_div(Value::integer(n)).expect("a number");
    for (row, (mass, length)) in robot.rows.iter_mut().zip([(0, 2), (1, 3)]) {
        let (m, a) = (Value::field(mass), Value::field(length));
        let moment = over(12, m.clone() * a.clone() * a.clone());
        row.mass = m;
        row.com[0] = -over(2, a.clone());
        row.a = a;
        row.inertia[1] = moment.clone();
        row.inertia[2] = moment;
    }
    robot.gravity[1] = -Value::field(4);
    robot
}

fn lines(robot: &Robot, functions: &[Function], format: Format) -> Vec<String> {
    let of = |&function: &Function| {
        let program = derive(robot, function);
        let formulas = Formulas::new(robot, &[function.into()], &program, BUDGET);
        let shown = formulas.shown(format, usize::MAX);
        shown
            .into_iter()
            .map(|shown| format!("{} = {}", shown.name, shown.formula.expect("short")))
    };
    functions.iter().flat_map(of).collect()
}

const TERMS: [Function; 3] = [
    Function::MassMatrix,
    Function::CoriolisVector,
    Function::GravityVector,
];

#[test]
fn equations_of_craig() {
    let expected = [
        "M11 = l1^2 (m1 + m2) + m2 l2^2 + 2 m2 l1 l2 c2",
        "M12 = m2 l2^2 + m2 l1 l2 c2",
        "M21 = m2 l2^2 + m2 l1 l2 c2",
        "M22 = m2 l2^2",
        "V1 = -2 m2 l1 l2 s2 qd1 qd2 - m2 l1 l2 s2 qd2^2",
        "V2 = m2 l1 l2 s2 qd1^2",
        "G1 = l1 g (m1 + m2) c1 + m2 l2 g c12",
        "G2 = m2 l2 g c12",
    ];
    assert_eq!(
        lines(&arms::two_link_craig(), &TERMS, Format::Text),
        expected
    );
}

/// With i = 1/12 m a^2 about the centres of mass: 1/4 + 1/12 = 1/3.
#[test]
fn equations_of_saha() {
    let expected = [
        "M11 = a1^2 (1/3 m1 + m2) + 1/3 m2 a2^2 + m2 a1 a2 c2",
        "M12 = 1/3 m2 a2^2 + 1/2 m2 a1 a2 c2",
        "M21 = 1/3 m2 a2^2 + 1/2 m2 a1 a2 c2",
        "M22 = 1/3 m2 a2^2",
        "V1 = -m2 a1 a2 s2 qd1 qd2 - 1/2 m2 a1 a2 s2 qd2^2",
        "V2 = 1/2 m2 a1 a2 s2 qd1^2",
        "G1 = a1 g (1/2 m1 + m2) c1 + 1/2 m2 a2 g c12",
        "G2 = 1/2 m2 a2 g c12",
    ];
    assert_eq!(lines(&two_link_saha(), &TERMS, Format::Text), expected);
}

/// A waist and two parallel joints: (l2 c2 + l3 c23)^2 in what the waist feels.
#[test]
fn squares_of_sums_of_angles() {
    let robot = arms::robot("elbow_3r");
    let of_mass = lines(&robot, &[Function::MassMatrix], Format::Text);
    expect_test::expect![[r#"
        M11 = 2.1212275 + 1.2383125 c2^2 + 0.6048 c2 c23 - 0.062 c2 s2 + 0.0288 c2 s23 + 0.1768 c23^2 + 0.01584 c23 s23
        M12 = -0.00375 c2 - 0.00032 c23 - 0.1236 s2 - 0.00918 s23
        M13 = -0.00032 c23 - 0.00918 s23
        M21 = -0.00375 c2 - 0.00032 c23 - 0.1236 s2 - 0.00918 s23
        M22 = 4.3711275 + 0.6048 c3 + 0.0288 s3
        M23 = 0.18944 + 0.3024 c3 + 0.0144 s3
        M31 = -0.00032 c23 - 0.00918 s23
        M32 = 0.18944 + 0.3024 c3 + 0.0144 s3
        M33 = 0.82944"#]].assert_eq(&of_mass.join("\n"));
}

/// The formulas are read back and evaluated beside the program.
#[test]
fn formulas_are_what_is_computed() {
    let mut robots = vec![arms::two_link_craig(), two_link_saha()];
    robots.extend(
        arms::NAMES
            .iter()
            .map(|name| arms::robot(name))
            .filter(|robot| robot.dof() <= 3),
    );
    let mut checked = 0;
    for robot in &robots {
        let have_letters = |function: &Function| function.row().symbol.is_some();
        for function in Function::ALL.into_iter().filter(have_letters) {
            let program = derive(robot, function);
            let formulas = Formulas::new(robot, &[function.into()], &program, BUDGET);
            let expected = program.evaluate(&mut point(robot));
            for (shown, expected) in formulas
                .shown(Format::Text, usize::MAX)
                .iter()
                .zip(expected)
            {
                let Ok(text) = &shown.formula else { continue };
                let value = Reader::value(text);
                let error = (value - expected).abs();
                assert!(
                    error <= 1e-12 * expected.abs().max(1.0),
                    "{} {}: {value} and {expected} of {text}",
                    robot.name,
                    shown.name
                );
                checked += 1;
            }
        }
    }
    assert!(checked > 400, "{checked}");
}

#[test]
fn latex_compiles() {
    for robot in [
        arms::two_link_craig(),
        two_link_saha(),
        arms::robot("elbow_3r"),
    ] {
        for line in lines(&robot, &TERMS, Format::Latex) {
            let storage = pulldown_latex::Storage::new();
            let parser = pulldown_latex::Parser::new(&line, &storage);
            let mut html = String::new();
            pulldown_latex::push_mathml(&mut html, parser, pulldown_latex::RenderConfig::default())
                .expect("a string");
            assert!(!html.contains("merror"), "{line}\n{html}");
        }
    }
}

/// Every element that is opened is closed, in order.
#[test]
fn mathml_is_well_formed() {
    for line in lines(&arms::two_link_craig(), &TERMS, Format::MathMl) {
        let mut open = Vec::new();
        for tag in line.split('<').skip(1) {
            let tag = tag.split_once('>').expect("a tag ends").0;
            match tag.strip_prefix('/') {
                Some(name) => assert_eq!(open.pop().as_deref(), Some(name), "{line}"),
                None => open.push(tag.split(' ').next().unwrap_or(tag).to_owned()),
            }
        }
        assert!(open.is_empty() && line.contains("<math"), "{line}");
    }
}

#[test]
fn a_formula_that_is_too_long_says_how_long() {
    let robot = arms::two_link_craig();
    let program = derive(&robot, Function::MassMatrix);
    let formulas = Formulas::new(&robot, &[Function::MassMatrix.into()], &program, BUDGET);
    let shown = formulas.shown(Format::Text, 2);
    let too_long = shown[0].formula.clone().unwrap_err();
    assert_eq!(
        too_long.to_string(),
        "too long: 4 terms; `robot-dynamics show`"
    );
    assert_eq!(shown[3].formula.as_deref(), Ok("m2 l2^2"));
    let small = Budget {
        terms: 3,
        products: 20,
    };
    let formulas = Formulas::new(&robot, &[Function::MassMatrix.into()], &program, small);
    let too_long = formulas.shown(Format::Text, 9)[0].formula.clone();
    let too_long = too_long.unwrap_err().to_string();
    assert_eq!(
        too_long,
        "too long: more than 3 terms; `robot-dynamics show`"
    );
}

/// Constants of odd angles are one number each, whatever the program divided by, and numbers stand in
/// the sums that they belong to.
#[test]
fn odd_constant_angles() {
    let mut robot = arms::two_link_craig();
    robot.rows[0].alpha = arms::decimal(0.3);
    robot.rows[1].mass = Value::integer(2);
    let of_mass = lines(&robot, &[Function::MassMatrix], Format::Text);
    expect_test::expect![[r#"
        M11 = l1^2 (m1 + 2) + 1.8253356149096782 l2^2 + 0.1746643850903217 l2^2 c2^2 + 4 l1 l2 c2
        M12 = 1.910672978251212 l2^2 + 1.910672978251212 l1 l2 c2
        M21 = 1.910672978251212 l2^2 + 1.910672978251212 l1 l2 c2
        M22 = 2 l2^2"#]]
    .assert_eq(&of_mass.join("\n"));
    for line in lines(&robot, &TERMS, Format::Text) {
        assert!(!line.contains('/') || line.contains("1/2"), "{line}");
    }
}

/// Fields that look like short names keep theirs: sines are then written out.
#[test]
fn a_field_that_is_called_as_a_sine() {
    let mut robot = arms::two_link_craig();
    robot.fields[0] = "c1".to_owned();
    let of_gravity = lines(&robot, &[Function::GravityVector], Format::Text);
    let expected = "G1 = l1 g (c1 + m2) cos(q1) + m2 l2 g cos(q1 + q2)";
    assert_eq!(of_gravity[0], expected);
}

/// Fields that are called as an input is are written with `self.` in front: positions and velocities of joints, and the
/// pose of a base that moves.
#[test]
fn a_field_that_is_called_as_an_input() {
    let mut robot = arms::two_link_craig();
    robot.fields[2] = "qd1".to_owned();
    let of_velocity = lines(&robot, &[Function::CoriolisVector], Format::Text);
    let expected = "V2 = m2 self.qd1 l2 sin(q2) qd1^2";
    assert_eq!(of_velocity[1], expected);
    let mut robot = arms::floating("free_body");
    robot.fields = ["r31", "vx"].map(str::to_owned).into();
    if let Some(Base::Floating(body)) = &mut robot.base {
        body.mass = Value::Field(0);
        body.com = [0, 0, 0].map(Value::integer);
    }
    let of_gravity = lines(&robot, &[Function::GravityVector], Format::Text);
    assert_eq!(of_gravity[0], "G1 = 9.81 self.r31 r31");
    // An arm's formulas have no such number.
    let mut robot = arms::two_link_craig();
    robot.fields[0] = "r31".to_owned();
    let of_gravity = lines(&robot, &[Function::GravityVector], Format::Text);
    assert_eq!(of_gravity[0], "G1 = l1 g (r31 + m2) c1 + m2 l2 g c12");
}

#[test]
fn structure_of_short_and_long_arms() {
    let sentence = |name, function| {
        let robot = arms::robot(name);
        let program = derive(&robot, function);
        let span = 0..program.outputs.len();
        Structure::new(&robot, function, &program, span).map(|structure| structure.sentence())
    };
    let of_mass = sentence("two_link_craig", Function::MassMatrix);
    let expected = "M22 is constant; M11, M12 depend on q2.";
    assert_eq!(of_mass.as_deref(), Some(expected));
    let of_gravity = sentence("puma560", Function::GravityVector);
    let expected = "G1, G6 are zero; G2, G3, G4, G5 depend on q2 to q5.";
    assert_eq!(of_gravity.as_deref(), Some(expected));
    assert_eq!(sentence("puma560", Function::KineticEnergy), None);
}

/// The value of a name.
fn named(name: &str) -> f64 {
    let sum: u64 = name.bytes().fold(7, |sum, byte| 31 * sum + u64::from(byte));
    0.5 + (sum % 997) as f64 / 1_000.0
}

fn of_joint(name: &str, index: usize) -> f64 {
    named(&format!("{name}{}", index + 1))
}

/// Some value of every symbol, by its name in formulas.
fn point(robot: &Robot) -> At<impl Fn(&Symbol) -> f64> {
    let fields: Vec<f64> = robot.fields.iter().map(|field| named(field)).collect();
    At(move |symbol: &Symbol| match symbol {
        Symbol::Pi => core::f64::consts::PI,
        Symbol::Field(i) => fields[*i],
        Symbol::AngleSine(angle) => angle.to_f64(&fields).sin(),
        Symbol::AngleCosine(angle) => angle.to_f64(&fields).cos(),
        Symbol::Sine(i) => of_joint("q", *i).sin(),
        Symbol::Cosine(i) => of_joint("q", *i).cos(),
        Symbol::Position(i) => of_joint("q", *i),
        Symbol::Velocity(i) => of_joint("qd", *i),
        Symbol::Acceleration(i) => of_joint("qdd", *i),
        Symbol::Force(i) => of_joint("tau", *i),
        Symbol::VelocitySign(i) => of_joint("qd", *i).signum(),
        Symbol::Stribeck(i) => {
            let row = robot.joints().nth(*i).expect("a joint");
            let velocity = &row.stribeck.as_ref().expect("it has one").velocity;
            let ratio = of_joint("qd", *i) / velocity.to_f64(&fields);
            (-ratio * ratio).exp()
        }
        Symbol::Entry(argument, i) => of_joint(argument.name(), *i),
    })
}

/// Evaluates the text of a formula: sums of products by juxtaposition, over at most one divisor.
struct Reader<'t>(&'t str);

impl Reader<'_> {
    fn value(text: &str) -> f64 {
        let mut reader = Reader(text);
        let value = reader.sum();
        assert_eq!(reader.0, "", "{text}");
        value
    }

    fn takes(&mut self, word: &str) -> bool {
        let rest = self.0.strip_prefix(word);
        self.0 = rest.unwrap_or(self.0);
        rest.is_some()
    }

    fn word(&mut self, is_of_word: impl Fn(char) -> bool) -> &str {
        let end = self.0.find(|c| !is_of_word(c)).unwrap_or(self.0.len());
        let (word, rest) = self.0.split_at(end);
        self.0 = rest;
        word
    }

    fn sum(&mut self) -> f64 {
        let is_negative = self.takes("-");
        let first = self.quotient();
        let mut sum = if is_negative { -first } else { first };
        loop {
            if self.takes(" + ") {
                sum += self.quotient();
            } else if self.takes(" - ") {
                sum -= self.quotient();
            } else {
                return sum;
            }
        }
    }

    fn quotient(&mut self) -> f64 {
        let mut product = self.power();
        loop {
            if self.takes(" / ") {
                return product / self.power();
            }
            if self.0.starts_with(" + ") || self.0.starts_with(" - ") || !self.takes(" ") {
                return product;
            }
            product *= self.power();
        }
    }

    fn power(&mut self) -> f64 {
        let base = self.base();
        match self.takes("^") {
            true => base.powi(self.word(|c| c.is_ascii_digit()).parse().expect("digits")),
            false => base,
        }
    }

    fn base(&mut self) -> f64 {
        if self.takes("(") {
            let sum = self.sum();
            assert!(self.takes(")"), "{}", self.0);
            return sum;
        }
        if self.0.starts_with(|c: char| c.is_ascii_digit()) {
            return self.number();
        }
        let name = self.word(|c| c.is_alphanumeric() || c == '_').to_owned();
        if self.0.starts_with('(') {
            let argument = self.base();
            return match name.as_str() {
                "sin" => argument.sin(),
                "cos" => argument.cos(),
                "exp" => argument.exp(),
                "sign" => argument.signum(),
                other => panic!("{other}"),
            };
        }
        let digits = name[1..].bytes().all(|byte| byte.is_ascii_digit());
        let angle = || {
            name[1..]
                .bytes()
                .map(|byte| of_joint("q", usize::from(byte - b'1')))
        };
        match name.as_bytes()[0] {
            _ if name == "pi" => core::f64::consts::PI,
            b's' if digits => angle().sum::<f64>().sin(),
            b'c' if digits => angle().sum::<f64>().cos(),
            _ => named(&name),
        }
    }

    fn number(&mut self) -> f64 {
        let digits = |reader: &mut Self| -> f64 {
            let mut text = reader.word(|c| c.is_ascii_digit() || c == '.').to_owned();
            if reader.takes("e") {
                let sign = if reader.takes("-") { "-" } else { "" };
                text = format!("{text}e{sign}{}", reader.word(|c| c.is_ascii_digit()));
            }
            text.parse().expect("a number")
        };
        let numerator = digits(self);
        match self.takes("/") {
            true => numerator / digits(self),
            false => numerator,
        }
    }
}
