//! Joints anywhere in space and on any link, by the proof of functions: it multiplies the placements as they were written.

use dynamics_symbolic::Function;
use dynamics_symbolic::derive::derive_plain;
use dynamics_symbolic::exact::{Rational, SplitMix64};
use dynamics_symbolic::prove::prove;
use dynamics_symbolic::robot::{
    Carrier, Convention, Coupling, JointType, Mount, Placement, Robot, Row, Value,
};

const JOINTS: usize = 4;

struct Random {
    random: SplitMix64,
    /// How many of ten angles are no quarter turns.
    slanted: u64,
}

impl Random {
    fn below(&mut self, n: u64) -> u64 {
        self.random.next_u64() % n
    }

    /// A decimal, often zero.
    fn length(&mut self) -> Value {
        match self.below(3) {
            0 => Value::zero(),
            _ => self.decimal(),
        }
    }

    fn decimal(&mut self) -> Value {
        let thousandths = self.below(2_000) as i64 - 1_000;
        Value::Rational(Rational::from_parts_signed(
            thousandths.into(),
            1_000_u16.into(),
        ))
    }

    fn angle(&mut self) -> Value {
        match self.below(10) < self.slanted {
            // Tiny angles are angles of their own.
            true if self.below(4) == 0 => {
                let tiny = Rational::from_parts_signed(self.below(9).into(), 10_u64.pow(17).into());
                Value::Rational(tiny)
            }
            true => self.decimal(),
            false => {
                let quarters = self.below(4) as i64 - 1;
                let half = Rational::from_parts_signed(quarters.into(), 2_u8.into());
                Value::Pi * Value::Rational(half)
            }
        }
    }

    fn place(&mut self) -> Placement {
        Placement {
            xyz: [(); 3].map(|()| self.length()),
            rpy: [(); 3].map(|()| self.angle()),
        }
    }

    fn row(&mut self, index: usize) -> Row {
        let places = 1 + self.below(2);
        let joint_type = match self.below(4) {
            0 => JointType::Prismatic,
            _ => JointType::Revolute,
        };
        Row {
            mass: self.decimal(),
            com: [(); 3].map(|()| self.length()),
            inertia: [(); 6].map(|()| self.decimal()),
            locked: (self.below(6) == 0).then(|| self.decimal()),
            at: (0..places).map(|_| self.place()).collect(),
            mount: Some(Mount {
                axis: [self.angle(), self.angle()],
                tip: None,
            }),
            ..Row::new(format!("joint{index}"), joint_type)
        }
    }

    /// Joints on any link above them, or on the base.
    fn branch(&mut self, rows: &mut [Row]) {
        for (i, row) in rows.iter_mut().enumerate() {
            row.on = match self.below(i as u64 + 1) as usize {
                0 => Carrier::Base,
                above => Carrier::Row(above - 1),
            };
        }
    }

    /// Joints that follow one of the others, on both sides of it.
    fn couple(&mut self, rows: &mut [Row]) {
        let leader = self.below(JOINTS as u64) as usize;
        rows[leader].locked = None;
        for i in (0..JOINTS).filter(|&i| i != leader) {
            if rows[i].locked.is_none() && self.below(2) == 0 {
                let factor = match self.below(3) {
                    0 => Value::integer(-1),
                    1 => Value::integer(2),
                    _ => self.decimal() + Value::integer(3),
                };
                rows[i].follows = Some(Coupling {
                    leader,
                    factor,
                    offset: self.angle(),
                });
            }
        }
    }

    fn robot(&mut self) -> Robot {
        let mut rows: Vec<Row> = (0..JOINTS).map(|i| self.row(i)).collect();
        if self.below(2) == 0 {
            self.branch(&mut rows);
        }
        if self.below(2) == 0 {
            self.couple(&mut rows);
        }
        // The tip may be on any link, whatever else that carries.
        let last = self.below(JOINTS as u64) as usize;
        if let Some(mount) = &mut rows[last].mount
            && self.below(2) == 1
        {
            mount.tip = Some(vec![self.place(), self.place()]);
        }
        Robot {
            name: "Mounted".to_owned(),
            fields: Vec::new(),
            convention: Convention::Modified,
            gravity: [(); 3].map(|()| self.decimal()),
            rows,
            frames: Vec::new(),
            neglected: None,
            bounds: Default::default(),
            base: None,
            tool: None,
        }
    }
}

#[test]
fn functions_of_mounted_joints_are_proven() {
    let functions = [
        Function::InverseDynamics,
        Function::MassMatrix,
        Function::PotentialEnergy,
        Function::LinkPoses,
        Function::ForwardKinematics,
        Function::Jacobian,
        Function::LinkJacobians,
        Function::ToolAcceleration,
        Function::WrenchTorques,
        Function::CenterOfMass,
        Function::Regressor,
        Function::BaseParameters,
    ];
    for seed in 0..32 {
        let random = SplitMix64::new(seed);
        let slanted = [0, 0, 2, 6][seed as usize % 4];
        let robot = Random { random, slanted }.robot();
        let has_tip = robot.tip_row().is_some();
        for function in functions.into_iter().filter(|f| has_tip || !f.row().of_tip) {
            let program = derive_plain(&robot, function);
            prove(&robot, function, &program).unwrap_or_else(|failure| {
                panic!("seed {seed}: {failure}");
            });
        }
    }
}
