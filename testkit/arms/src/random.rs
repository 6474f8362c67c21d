//! Random tables: both conventions, mixed joints, symbolic cells anywhere.

use dynamics_symbolic::exact::{Rational, SplitMix64};
use dynamics_symbolic::robot::{
    Base, Body, Carrier, Convention, Coupling, Frame, JointType, Placement, Robot, Row, Spring,
    Stribeck, Tool, Value,
};

/// The kind of bodies that the links are.
#[derive(Clone, Copy, PartialEq)]
pub enum Bodies {
    /// Any numbers: equations of motion do not ask what they are.
    Any,
    /// Masses, tensors and motors that exist, where all fields are positive.
    Physical,
}

/// Cells as they occur: mostly zero, round numbers, right angles, parameters.
pub struct Tables {
    random: SplitMix64,
    fields: usize,
    /// Arms in free space, most of their axes meeting: where rare parameters are grouped.
    meeting: bool,
    bodies: Bodies,
}

impl Tables {
    /// The sequence of arms that begins at `seed`.
    pub fn new(seed: u64, bodies: Bodies) -> Self {
        Tables {
            random: SplitMix64::new(seed),
            fields: 0,
            meeting: false,
            bodies,
        }
    }

    /// Arms in free space, most of whose axes meet.
    pub fn with_meeting_axes(self) -> Self {
        Tables {
            meeting: true,
            ..self
        }
    }

    /// A random integer from 0 to n - 1.
    pub fn below(&mut self, n: u64) -> u64 {
        self.random.next_u64() % n
    }

    /// A random number between -2 and 2, exact in 500ths.
    pub fn number(&mut self) -> Value {
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

    /// A number that is not negative, or a parameter: a mass, a moment.
    fn positive(&mut self) -> Value {
        match self.below(8) {
            0 | 1 => Value::zero(),
            2..=5 => self.positive_number(),
            6 => Value::integer(1),
            _ => {
                self.fields = self.fields.max(1);
                Value::field(self.below(self.fields as u64) as usize) * self.positive_number()
            }
        }
    }

    fn positive_number(&mut self) -> Value {
        let numerator = self.below(1000) as i64 + 1;
        Value::Rational(Rational::from_parts(numerator.into(), 500_u32.into()))
    }

    /// The tensor of second moments x, y, z along the axes: yy + zz about x, and so on.
    fn tensor(&mut self) -> [Value; 6] {
        let [x, y, z] = [(); 3].map(|()| self.positive());
        let moments = [y.clone() + z.clone(), z + x.clone(), x + y];
        let [xx, yy, zz] = moments;
        let [xy, yz, xz] = [(); 3].map(|()| Value::zero());
        [xx, yy, zz, xy, yz, xz]
    }

    fn row(&mut self, i: usize) -> Row {
        let row = self.any_row(i);
        match self.bodies {
            Bodies::Any => row,
            Bodies::Physical => Row {
                mass: self.positive(),
                inertia: self.tensor(),
                motor_inertia: self.positive(),
                ..row
            },
        }
    }

    fn any_row(&mut self, i: usize) -> Row {
        let joint_type = match self.below(if self.meeting { 7 } else { 3 }) {
            0 => JointType::Prismatic,
            _ => JointType::Revolute,
        };
        Row {
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
            coulomb: {
                let coulomb = self.cell();
                [coulomb.clone(), coulomb]
            },
            ..Row::new(format!("joint{i}"), joint_type)
        }
    }

    /// An arm some of whose joints are locked, at least one, and not all of them.
    pub fn locked_robot(&mut self) -> Robot {
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

    /// An arm some of whose joints follow others, at least one, and not all of them; springs and friction
    /// at its joints, and one of the other joints may be locked.
    pub fn coupled_robot(&mut self) -> Robot {
        let mut robot = self.robot_with_joint_forces();
        while robot.rows.len() < 2 {
            robot = self.robot_with_joint_forces();
        }
        self.fields = robot.fields.len();
        let count = robot.rows.len() as u64;
        let leader = self.below(count) as usize;
        let sure = (leader + 1 + self.below(count - 1) as usize) % robot.rows.len();
        for i in (0..robot.rows.len()).filter(|&i| i != leader) {
            match self.below(4) {
                0 if i != sure => robot.rows[i].locked = Some(self.angle()),
                1 if i != sure => {}
                _ => {
                    robot.rows[i].follows = Some(Coupling {
                        leader,
                        factor: self.factor(),
                        offset: self.angle(),
                    });
                }
            }
        }
        robot.fields = (0..self.fields).map(|i| format!("p{i}")).collect();
        robot
    }

    /// The factor of a follower: a small whole number, a large one, a fraction, or a field.
    fn factor(&mut self) -> Value {
        let quotient = |a: i64, b: u64| Value::Rational(Rational::from_parts(a.into(), b.into()));
        match self.below(8) {
            0 | 1 => Value::integer(-1),
            2 => Value::integer(1),
            3 => Value::integer([2, -2, 3, -3][self.below(4) as usize]),
            4 => Value::integer([4, -5][self.below(2) as usize]),
            5 => quotient([1, -1, 3][self.below(3) as usize], 2),
            6 => self.number() + Value::integer(3),
            _ => self.positive() + Value::integer(1),
        }
    }

    /// An arm of two to seven joints in numbers alone, most of which follow others, some of them followers: factors of
    /// no more than six decimals in all, angles of all kinds.
    pub fn robot_with_decimal_couplings(&mut self) -> Robot {
        let mut robot = self.robot();
        let count = 2 + self.below(6) as usize;
        robot.fields.clear();
        robot.gravity = [(); 3].map(|()| self.decimal(2));
        robot.rows = (0..count).map(|i| self.decimal_row(i)).collect();
        for i in 1..count {
            let before = self.below(i as u64) as usize;
            if self.below(4) == 0 {
                continue;
            }
            let decimals = match robot.rows[before].follows {
                Some(_) => 3,
                None => self.below(4) as u32,
            };
            let factor = self.decimal(decimals) + Value::integer(3);
            let offset = self.angle_of_numbers();
            robot.rows[i].follows = Some(match robot.rows[before].follows.clone() {
                None => Coupling {
                    leader: before,
                    factor,
                    offset,
                },
                // k (k' q + c') + c
                Some(next) => Coupling {
                    leader: next.leader,
                    factor: factor.clone() * next.factor,
                    offset: factor * next.offset + offset,
                },
            });
        }
        // A joint that leads may come behind those that follow it.
        if self.below(2) == 0 {
            robot.rows.reverse();
            for coupling in robot.rows.iter_mut().filter_map(|row| row.follows.as_mut()) {
                coupling.leader = count - 1 - coupling.leader;
            }
        }
        robot
    }

    fn decimal_row(&mut self, i: usize) -> Row {
        let joint_type = match self.below(4) {
            0 => JointType::Prismatic,
            _ => JointType::Revolute,
        };
        Row {
            a: self.decimal(3),
            alpha: self.angle_of_numbers(),
            d: self.decimal(3),
            theta: self.angle_of_numbers(),
            mass: self.positive_number(),
            com: [(); 3].map(|()| self.decimal(3)),
            inertia: [(); 6].map(|()| self.decimal(4)),
            motor_inertia: self.decimal(1),
            gear_ratio: self.decimal(1),
            ..Row::new(format!("joint{i}"), joint_type)
        }
    }

    fn angle_of_numbers(&mut self) -> Value {
        let quarter = Value::Pi * Value::Rational(Rational::ONE / Rational::from(2));
        match self.below(3) {
            0 => self.decimal(3),
            _ => quarter * Value::integer(self.below(4) as i64 - 1),
        }
    }

    /// A number between -2 and 2 of so many decimals.
    fn decimal(&mut self, decimals: u32) -> Value {
        let scale = 10_u64.pow(decimals);
        let numerator = self.below(4 * scale + 1) as i64 - 2 * scale as i64;
        Value::Rational(Rational::from_parts(numerator.into(), scale.into()))
    }

    /// An arm on a base that is placed in the world, with a tool; one of the two at least.
    pub fn mounted_robot(&mut self) -> Robot {
        let robot = self.robot();
        self.mounted(robot)
    }

    /// As [`Tables::mounted_robot`], some of its joints locked.
    pub fn mounted_and_locked_robot(&mut self) -> Robot {
        let robot = self.locked_robot();
        self.mounted(robot)
    }

    fn mounted(&mut self, mut robot: Robot) -> Robot {
        self.fields = robot.fields.len();
        let choice = self.below(4);
        robot.base = (choice != 0).then(|| Base::Standing(self.placement()));
        robot.tool = (choice != 1).then(|| Tool {
            placement: self.placement(),
            body: Body {
                mass: match self.bodies {
                    Bodies::Any => self.cell(),
                    Bodies::Physical => self.positive(),
                },
                com: [(); 3].map(|()| self.cell()),
                inertia: match self.bodies {
                    Bodies::Any => [(); 6].map(|()| self.cell()),
                    Bodies::Physical => self.tensor(),
                },
            },
        });
        robot.fields = (0..self.fields).map(|i| format!("p{i}")).collect();
        robot
    }

    /// A robot of any kind whose joints stand on links above them, or on the base, some of them at a place of their
    /// own; with frames, some of which have bodies.
    pub fn tree(&mut self) -> Robot {
        let draw = match self.below(4) {
            0 => Tables::mounted_robot,
            1 => Tables::locked_robot,
            2 => Tables::coupled_robot,
            _ => Tables::robot,
        };
        let robot = draw(self);
        self.branched(robot)
    }

    /// The robot on a base that moves, which has a body of its own.
    pub fn on_moving_base(&mut self, mut robot: Robot) -> Robot {
        self.fields = robot.fields.len();
        robot.base = Some(Base::Floating(self.body()));
        robot.fields = (0..self.fields).map(|i| format!("p{i}")).collect();
        robot
    }

    fn body(&mut self) -> Body {
        match self.bodies {
            Bodies::Any => Body {
                mass: self.cell(),
                com: [(); 3].map(|()| self.cell()),
                inertia: [(); 6].map(|()| self.cell()),
            },
            Bodies::Physical => Body {
                mass: self.positive(),
                com: [(); 3].map(|()| self.cell()),
                inertia: self.tensor(),
            },
        }
    }

    /// As [`Tables::tree`], with all cells that a table may have: followers beside joints that are locked, springs and
    /// friction of every kind, base and tool.
    pub fn tree_with_all_cells(&mut self) -> Robot {
        let robot = self.coupled_robot();
        let robot = self.mounted(robot);
        self.branched(robot)
    }

    /// The robot as a tree with frames. Where there is no tip, there is no tool.
    fn branched(&mut self, mut robot: Robot) -> Robot {
        self.fields = robot.fields.len();
        let count = robot.rows.len();
        for (i, row) in robot.rows.iter_mut().enumerate() {
            row.on = match self.below(i as u64 + 2) as usize {
                0 => Carrier::Base,
                above if above <= i => Carrier::Row(above - 1),
                _ => Carrier::Above,
            };
            row.at = (0..self.below(3)).map(|_| self.placement()).collect();
        }
        if robot.tip_row().is_none() {
            robot.tool = None;
        }
        robot.frames = (1..=self.below(3))
            .map(|number| self.frame(number, count))
            .collect();
        robot.fields = (0..self.fields).map(|i| format!("p{i}")).collect();
        robot
    }

    fn frame(&mut self, number: u64, rows: usize) -> Frame {
        let body = self.body();
        Frame {
            name: format!("frame_{number}"),
            on: (self.below(rows as u64 + 1) as usize).checked_sub(1),
            places: (0..1 + self.below(2)).map(|_| self.placement()).collect(),
            body: (self.below(4) > 0).then_some(body),
        }
    }

    fn placement(&mut self) -> Placement {
        Placement {
            xyz: [(); 3].map(|()| self.cell()),
            rpy: [(); 3].map(|()| self.angle()),
        }
    }

    /// An arm with springs at some of its joints, and friction of every kind.
    pub fn robot_with_joint_forces(&mut self) -> Robot {
        let mut robot = self.robot();
        self.fields = robot.fields.len();
        for row in &mut robot.rows {
            if self.below(3) > 0 {
                row.spring = Some(Spring {
                    stiffness: self.positive(),
                    rest: self.cell(),
                });
            }
            if self.below(3) > 0 {
                row.coulomb = [(); 2].map(|()| self.positive());
            }
            if self.below(3) > 0 {
                let [positive, negative] = row.coulomb.clone();
                row.stribeck = Some(Stribeck {
                    // No less than that of either direction, where fields are positive.
                    friction: positive + negative + self.positive(),
                    velocity: self.positive_number() + self.positive(),
                });
            }
        }
        robot.fields = (0..self.fields).map(|i| format!("p{i}")).collect();
        robot
    }

    /// The next arm, of one to four joints.
    pub fn robot(&mut self) -> Robot {
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
            frames: Vec::new(),
            neglected: None,
            bounds: Default::default(),
            base: None,
            tool: None,
        }
    }
}
