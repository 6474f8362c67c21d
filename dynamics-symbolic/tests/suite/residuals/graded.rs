//! Small arms whose mass matrices are nearly singular at many states: joints on one axis, links
//! without inertia of their own, masses over ten powers of ten, small motors.

use super::arithmetic::thousandths;
use dynamics_symbolic::exact::{Rational, SplitMix64};
use dynamics_symbolic::robot::{Convention, JointType, Robot, Row, Value};

/// n / d
fn ratio(n: i64, d: u64) -> Value {
    Value::Rational(Rational::from_parts(n.into(), d.into()))
}

fn quarters(n: i64) -> Value {
    Value::Pi * ratio(n, 2)
}

/// Two antiparallel joints on one axis, and a motor that is all that tells their forces apart where
/// the sliding joints are far out.
pub(crate) fn antiparallel() -> Robot {
    use JointType::{Prismatic, Revolute};
    let tensor = |entries: [(usize, Value); 3]| {
        let mut tensor = [(); 6].map(|()| Value::zero());
        for (i, value) in entries {
            tensor[i] = value;
        }
        tensor
    };
    let none = Value::zero;
    Robot {
        name: "antiparallel".to_owned(),
        fields: vec!["f0".to_owned(), "t1".to_owned()],
        convention: Convention::Modified,
        gravity: [Value::field(0), Value::field(1), ratio(-634, 100)],
        rows: vec![
            Row {
                d: ratio(363, 1000),
                theta: quarters(1),
                coulomb: [(); 2].map(|()| ratio(31074618642011385, 10_000_000_000_000_000)),
                inertia: tensor([(1, ratio(167, 1000)), (0, none()), (2, none())]),
                alpha: quarters(1),
                ..Row::new("j0", Revolute)
            },
            Row {
                motor_inertia: ratio(43238972770729646, 10_000_000_000_000_000_000),
                gear_ratio: ratio(99517768541813695, 1_000_000_000_000_000),
                alpha: quarters(2),
                com: [ratio(261, 1000), ratio(-1, 1), ratio(-157, 1000)],
                inertia: tensor([
                    (0, ratio(10341646725333677, 100_000_000_000_000_000)),
                    (1, none()),
                    (2, none()),
                ]),
                ..Row::new("j1", Revolute)
            },
            Row {
                alpha: quarters(1),
                d: ratio(428, 1000),
                viscous: ratio(2023, 1000),
                mass: ratio(2038, 1000),
                ..Row::new("j2", Prismatic)
            },
            Row {
                inertia: tensor([
                    (0, ratio(108371, 100_000_000)),
                    (1, ratio(931516, 1_000_000_000)),
                    (2, ratio(102898, 100_000_000)),
                ]),
                com: [none(), ratio(-392, 1000), ratio(-275, 1000)],
                motor_inertia: ratio(1, 1),
                gear_ratio: ratio(52245, 1000),
                mass: ratio(43353853427694711, 10_000_000_000_000_000),
                theta: ratio(-11, 10),
                viscous: ratio(1073, 1000),
                ..Row::new("j3", Prismatic)
            },
        ],
        frames: Vec::new(),
        neglected: None,
        bounds: Default::default(),
        base: None,
        tool: None,
    }
}

/// Arms of two to four joints.
pub(crate) struct Arms(SplitMix64);

impl Arms {
    pub(crate) fn new(seed: u64) -> Self {
        Arms(SplitMix64::new(seed))
    }

    fn below(&mut self, n: u64) -> u64 {
        self.0.next_u64() % n
    }

    /// Zero more often than not.
    fn length(&mut self) -> Value {
        match self.below(3) {
            0 => Value::Rational(thousandths(&mut self.0, 1000)),
            _ => Value::zero(),
        }
    }

    /// Parallel and antiparallel axes, right angles, others.
    fn angle(&mut self) -> Value {
        match self.below(8) {
            0..=2 => Value::zero(),
            3..=5 => quarters(2),
            6 => quarters(1),
            _ => Value::Rational(thousandths(&mut self.0, 3000)),
        }
    }

    /// From 1e-4 to 1e4, or zero.
    fn graded(&mut self) -> Value {
        let digits = Value::Rational(Rational::from(self.below(900) + 100));
        match self.below(10) {
            0 => Value::zero(),
            power => digits * Value::Rational(Rational::from(10).pow(power as isize - 7)),
        }
    }

    /// The tensor of second moments x, y, z along the axes: yy + zz about x, and so on.
    fn tensor(&mut self) -> [Value; 6] {
        let [x, y, z] = [(); 3].map(|()| self.graded());
        let [xx, yy, zz] = [y.clone() + z.clone(), z + x.clone(), x + y];
        let [xy, yz, xz] = [(); 3].map(|()| Value::zero());
        [xx, yy, zz, xy, yz, xz]
    }

    fn row(&mut self, i: usize) -> Row {
        let joint_type = match self.below(4) {
            0 => JointType::Prismatic,
            _ => JointType::Revolute,
        };
        let is_light = self.below(2) == 0;
        let is_geared = self.below(2) == 0;
        Row {
            a: self.length(),
            alpha: self.angle(),
            d: self.length(),
            theta: self.angle(),
            mass: if is_light {
                Value::zero()
            } else {
                self.graded()
            },
            com: [(); 3].map(|()| self.length()),
            inertia: if is_light {
                [(); 6].map(|()| Value::zero())
            } else {
                self.tensor()
            },
            motor_inertia: if is_geared {
                self.graded()
            } else {
                Value::zero()
            },
            gear_ratio: Value::integer(i64::from(is_geared)),
            ..Row::new(format!("joint{i}"), joint_type)
        }
    }

    /// The next arm. Gravity is told at run time.
    pub(crate) fn arm(&mut self) -> Robot {
        let dof = 2 + self.below(2) as usize;
        Robot {
            name: "random".to_owned(),
            fields: (0..3).map(|i| format!("g{i}")).collect(),
            convention: match self.below(2) {
                0 => Convention::Standard,
                _ => Convention::Modified,
            },
            gravity: [0, 1, 2].map(Value::field),
            rows: (0..dof).map(|i| self.row(i)).collect(),
            frames: Vec::new(),
            neglected: None,
            bounds: Default::default(),
            base: None,
            tool: None,
        }
    }
}
