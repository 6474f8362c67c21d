//! Units that are powers of two change no digit: lengths times 2^a, masses times 2^b, and what is made of them.
//!
//! Every cell with a unit is a field here. A program that compared a quantity with an absolute number, or added
//! two of different units, would not scale.

use dynamics_symbolic::Function;
use dynamics_symbolic::derive::derive;
use dynamics_symbolic::exact::SplitMix64;
use dynamics_symbolic::robot::{
    Base, Body, JointType, Placement, Robot, Spring, Stribeck, Symbol, Tool, Value,
};
use interpreter::At;

/// Powers of length and mass.
type Unit = (i32, i32);

const NONE: Unit = (0, 0);
const LENGTH: Unit = (1, 0);
const MASS: Unit = (0, 1);
const FORCE: Unit = (1, 1);
const INERTIA: Unit = (2, 1);

/// An arm whose cells are fields, with their values and units.
struct Arm {
    robot: Robot,
    fields: Vec<(f64, Unit)>,
}

impl Arm {
    fn new(mut robot: Robot) -> Self {
        let mut fields = Vec::new();
        let mut field = |cell: &mut Value, unit: Unit| {
            if !cell.is_zero() {
                fields.push((cell.to_f64(&[]), unit));
                *cell = Value::field(fields.len() - 1);
            }
        };
        robot.gravity.iter_mut().for_each(|g| field(g, LENGTH));
        for row in &mut robot.rows {
            let is_revolute = row.joint_type == JointType::Revolute;
            let (inertia, force) = match is_revolute {
                true => (INERTIA, INERTIA),
                false => (MASS, FORCE),
            };
            field(&mut row.a, LENGTH);
            field(&mut row.d, LENGTH);
            field(&mut row.mass, MASS);
            row.com.iter_mut().for_each(|c| field(c, LENGTH));
            row.inertia.iter_mut().for_each(|j| field(j, INERTIA));
            field(&mut row.motor_inertia, inertia);
            field(&mut row.viscous, inertia);
            // One value is one field, in both directions.
            let [positive, negative] = &mut row.coulomb;
            field(positive, force);
            negative.clone_from(positive);
            let mut stribeck = Stribeck {
                friction: arms::decimal(30.0),
                velocity: arms::decimal(0.05),
            };
            field(&mut stribeck.friction, force);
            row.stribeck = Some(stribeck);
            let motion = match is_revolute {
                true => NONE,
                false => LENGTH,
            };
            let mut spring = Spring {
                stiffness: arms::decimal(3.7),
                rest: arms::decimal(0.3),
            };
            field(&mut spring.stiffness, inertia);
            field(&mut spring.rest, motion);
            row.spring = Some(spring);
            if let Some(stribeck) = &mut row.stribeck {
                field(&mut stribeck.velocity, motion);
            }
        }
        let placed = |placement: &mut Placement, field: &mut dyn FnMut(&mut Value, Unit)| {
            placement.xyz.iter_mut().for_each(|x| field(x, LENGTH));
        };
        if let Some(Base::Standing(base)) = &mut robot.base {
            placed(base, &mut field);
        }
        if let Some(tool) = &mut robot.tool {
            placed(&mut tool.placement, &mut field);
            field(&mut tool.body.mass, MASS);
            tool.body.com.iter_mut().for_each(|c| field(c, LENGTH));
            let inertia = tool.body.inertia.iter_mut();
            inertia.for_each(|j| field(j, INERTIA));
        }
        robot.fields = (0..fields.len()).map(|i| format!("p{i}")).collect();
        Arm { robot, fields }
    }

    /// The unit of what a joint moves by.
    fn motion(&self, joint: usize) -> Unit {
        match self.robot.rows[joint].joint_type {
            JointType::Revolute => NONE,
            JointType::Prismatic => LENGTH,
        }
    }

    /// The unit of what moves a joint.
    fn force(&self, joint: usize) -> Unit {
        let (length, mass) = self.motion(joint);
        (2 - length, mass + 1)
    }

    /// The unit of an output.
    fn unit(&self, function: Function, output: usize) -> Unit {
        let n = self.robot.rows.len();
        let inertia = |i: usize, j: usize| (self.force(i).0 - self.motion(j).0, 1);
        match function {
            Function::MassMatrix => inertia(output / n, output % n),
            Function::KineticEnergy | Function::PotentialEnergy => INERTIA,
            Function::ForwardDynamics if output < n => self.motion(output),
            Function::ForwardDynamics => inertia(output % n, output % n),
            _ => self.force(output),
        }
    }
}

fn power((length, mass): Unit, (a, b): (i32, i32)) -> f64 {
    2_f64.powi(length * a + mass * b)
}

/// Doubles, in units of 2^a and 2^b: the same state at the same seed.
fn doubles(arm: &Arm, scale: (i32, i32)) -> At<impl FnMut(&Symbol) -> f64> {
    let mut random = SplitMix64::new(1);
    let mut number = move |unit: Unit| {
        let unscaled = (random.next_u64() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0;
        unscaled * power(unit, scale)
    };
    At(move |symbol: &Symbol| match symbol {
        Symbol::Pi => std::f64::consts::PI,
        Symbol::Field(i) => arm.fields[*i].0 * power(arm.fields[*i].1, scale),
        Symbol::AngleSine(angle) => angle.to_f64(&[]).sin(),
        Symbol::AngleCosine(angle) => angle.to_f64(&[]).cos(),
        Symbol::Sine(_) | Symbol::Cosine(_) | Symbol::Stribeck(_) => number(NONE),
        Symbol::Position(i) | Symbol::Velocity(i) | Symbol::Acceleration(i) => {
            number(arm.motion(*i))
        }
        Symbol::Force(i) => number(arm.force(*i)),
        Symbol::VelocitySign(_) => 1.0,
        Symbol::Entry(..) => unreachable!("no function with other arguments is scaled"),
    })
}

const FUNCTIONS: [Function; 8] = [
    Function::MassMatrix,
    Function::CoriolisVector,
    Function::GravityVector,
    Function::SpringVector,
    Function::InverseDynamics,
    Function::ForwardDynamics,
    Function::KineticEnergy,
    Function::PotentialEnergy,
];

const SCALES: [(i32, i32); 5] = [(-10, -20), (30, 40), (-60, -60), (100, 100), (7, 17)];

/// Arms of up to four joints, and the PUMA 560.
/// The arm on a base that is placed in the world, with a tool.
fn mounted(mut robot: Robot) -> Robot {
    let placement = |xyz: [f64; 3], rpy: [f64; 3]| Placement {
        xyz: xyz.map(arms::decimal),
        rpy: rpy.map(arms::decimal),
    };
    robot.base = Some(Base::Standing(placement(
        [0.3, -0.4, 0.9],
        [0.2, -0.7, 1.3],
    )));
    robot.tool = Some(Tool {
        placement: placement([0.1, 0.02, 0.15], [0.9, 0.0, -0.3]),
        body: Body {
            mass: arms::decimal(1.7),
            com: [0.01, -0.03, 0.07].map(arms::decimal),
            inertia: [0.02, 0.03, 0.025, 0.001, -0.002, 0.003].map(arms::decimal),
        },
    });
    robot
}

#[test]
fn units_that_are_powers_of_two_change_no_digit() {
    let plain = arms::NAMES.map(arms::robot);
    let placed = ["scara", "stanford"].map(|name| mounted(arms::robot(name)));
    for robot in plain.into_iter().chain(placed) {
        let arm = Arm::new(robot);
        let name = &arm.robot.name;
        let is_mounted = arm.robot.base.is_some();
        if arm.robot.rows.len() > 4 && name != "puma560" && !is_mounted {
            continue;
        }
        for function in FUNCTIONS {
            let program = derive(&arm.robot, function);
            let at = |scale| program.evaluate(&mut doubles(&arm, scale));
            let expected = at((0, 0));
            for scale in SCALES {
                for (output, (x, y)) in at(scale).iter().zip(&expected).enumerate() {
                    let scaled = y * power(arm.unit(function, output), scale);
                    assert_eq!(
                        x.to_bits(),
                        scaled.to_bits(),
                        "output {output} of {} of {name} at {scale:?}: {x} and {scaled}",
                        function.name()
                    );
                }
            }
        }
    }
}
