//! Random arms that are hard on digits: angles next to right ones as tables print them, offsets that
//! are nearly zero, masses and inertias that differ by eight powers of ten, fields that happen to be so.

use dynamics_symbolic::exact::{Rational, SplitMix64};
use dynamics_symbolic::robot::{Convention, JointType, Robot, Row, Value};

/// An arm, and values of its fields.
pub struct Arm {
    /// The arm.
    pub robot: Robot,
    /// Values of its fields.
    pub fields: Vec<f64>,
}

/// PI/2, PI and 2 PI with fewer digits than a double has.
const PRINTED: [(i64, u64); 9] = [
    (157, 100),
    (15_708, 10_000),
    (1_570_796, 1_000_000),
    (15_707_963, 10_000_000),
    (157_079_633, 100_000_000),
    (31_416, 10_000),
    (3_141_593, 1_000_000),
    (47_124, 10_000),
    (628_319, 100_000),
];

/// A sequence of such arms.
pub struct Arms {
    random: SplitMix64,
    /// Whether masses and inertias differ by powers of ten.
    graded: bool,
    /// Whether some cells are fields.
    symbolic: bool,
    fields: Vec<f64>,
}

impl Arms {
    /// The sequence of a seed.
    pub fn new(seed: u64) -> Self {
        Arms {
            random: SplitMix64::new(seed),
            graded: false,
            symbolic: false,
            fields: Vec::new(),
        }
    }

    /// A number below `n`.
    pub fn below(&mut self, n: u64) -> u64 {
        self.random.next_u64() % n
    }

    /// Uniform from 0 to 1.
    pub fn unit(&mut self) -> f64 {
        self.random.next_u64() as f64 / u64::MAX as f64
    }

    fn sign(&mut self) -> i64 {
        1 - 2 * self.below(2) as i64
    }

    /// 0.001 to 1 by thousandths.
    fn thousandths(&mut self) -> Value {
        Value::Rational(fraction(self.below(1000) as i64 + 1, 1000))
    }

    fn power_of_ten(&mut self, lowest: i64, highest: i64) -> Value {
        let exponent = lowest + self.below((highest - lowest + 1) as u64) as i64;
        let ten = Rational::from(10);
        Value::Rational(match exponent < 0 {
            true => Rational::ONE / ten.pow(-exponent as isize),
            false => ten.pow(exponent as isize),
        })
    }

    /// A field in the place of a number, one time in four of an arm that has fields.
    fn or_field(&mut self, value: Value) -> Value {
        if !self.symbolic || self.fields.len() >= 6 || self.below(4) > 0 {
            return value;
        }
        self.fields.push(value.to_f64(&[]));
        Value::field(self.fields.len() - 1)
    }

    fn angle(&mut self) -> Value {
        let quarter = Value::Pi * Value::Rational(fraction(1, 2));
        let quarters = Value::integer(self.below(7) as i64 - 3);
        let angle = match self.below(10) {
            0..=2 => return Value::zero(),
            3 => return quarter * quarters,
            4 => Value::Rational(fraction(self.below(6001) as i64 - 3000, 1000)),
            5 => self.power_of_ten(-8, -2) * Value::integer(self.sign()),
            6 => {
                let offset = self.thousandths() * self.power_of_ten(-6, 0);
                quarter * quarters + offset * Value::integer(self.sign())
            }
            _ => {
                let (numerator, denominator) = PRINTED[self.below(9) as usize];
                Value::Rational(fraction(self.sign() * numerator, denominator))
            }
        };
        self.or_field(angle)
    }

    fn length(&mut self) -> Value {
        let length = match self.below(8) {
            0..=3 => return Value::zero(),
            4 => self.thousandths() * self.power_of_ten(-8, -2),
            _ => self.thousandths(),
        };
        let signed = length * Value::integer(self.sign());
        self.or_field(signed)
    }

    /// A mass or a moment: not negative.
    fn positive(&mut self) -> Value {
        if self.below(4) == 0 {
            return Value::zero();
        }
        let size = match self.graded {
            true => self.power_of_ten(-4, 4),
            false => Value::integer(1 + self.below(9) as i64),
        };
        let value = self.thousandths() * size;
        self.or_field(value)
    }

    fn row(&mut self, i: usize) -> Row {
        let joint_type = match self.below(4) {
            0 => JointType::Prismatic,
            _ => JointType::Revolute,
        };
        let [x, y, z] = [(); 3].map(|()| self.positive());
        let diagonal = [y.clone() + z.clone(), z + x.clone(), x + y];
        let [xx, yy, zz] = diagonal;
        let [xy, yz, xz] = [(); 3].map(|()| Value::zero());
        Row {
            a: self.length(),
            alpha: self.angle(),
            d: self.length(),
            theta: self.angle(),
            mass: self.positive(),
            com: [(); 3].map(|()| self.length()),
            inertia: [xx, yy, zz, xy, yz, xz],
            motor_inertia: self.positive(),
            gear_ratio: Value::integer(self.below(3) as i64 * 20),
            viscous: self.positive(),
            ..Row::new(format!("joint{i}"), joint_type)
        }
    }

    /// The next arm, of one to six joints, small ones more often.
    pub fn arm(&mut self) -> Arm {
        let joints = 1 + self.below(6).min(self.below(6)) as usize;
        self.graded = self.below(3) == 0;
        self.symbolic = self.below(4) == 0;
        self.fields.clear();
        let rows: Vec<Row> = (0..joints).map(|i| self.row(i)).collect();
        let down = Value::Rational(fraction(-981, 100));
        let gravity = match self.below(4) {
            0 => [(); 3].map(|()| self.length()),
            _ => [Value::zero(), Value::zero(), down],
        };
        let convention = match self.below(2) {
            0 => Convention::Standard,
            _ => Convention::Modified,
        };
        Arm {
            robot: Robot {
                name: "random".to_owned(),
                fields: (0..self.fields.len()).map(|i| format!("p{i}")).collect(),
                convention,
                gravity,
                rows,
                frames: Vec::new(),
                neglected: None,
                bounds: Default::default(),
                base: None,
                tool: None,
            },
            fields: self.fields.clone(),
        }
    }
}

/// An arm whose right angles are all `right` instead, as tables print them.
pub fn printed(mut robot: Robot, right: &Value) -> Robot {
    for row in &mut robot.rows {
        for angle in [&mut row.alpha, &mut row.theta] {
            let value = angle.to_f64(&[]);
            if value.abs() == core::f64::consts::FRAC_PI_2 {
                *angle = if value < 0.0 {
                    -right.clone()
                } else {
                    right.clone()
                };
            }
        }
    }
    robot
}

fn fraction(numerator: i64, denominator: u64) -> Rational {
    Rational::from_parts(numerator.into(), denominator.into())
}
