//! Robots with branches: a gripper, two arms, a hand, a torso, legs.

use crate::{decimal, generic_chain, robot};
use dynamics_symbolic::robot::{
    Base, Body, Carrier, Convention, Frame, JointType, Placement, Robot, Row, Value,
};

/// The names of all robots that [`tree`] makes.
pub const TREES: [&str; 7] = [
    "panda_with_fingers",
    "two_pandas",
    "hyq",
    "four_fingers",
    "torso",
    "forked_chain",
    "humanoid",
];

/// A robot with branches.
///
/// # Panics
///
/// Where there is none of that name.
pub fn tree(name: &str) -> Robot {
    let tree = match name {
        "panda_with_fingers" => panda_with_fingers(),
        "two_pandas" => two_pandas(),
        "hyq" => hyq(),
        "four_fingers" => four_fingers(),
        "torso" => torso(),
        "forked_chain" => forked_chain(),
        "humanoid" => humanoid(),
        other => panic!("no tree is named {other}"),
    };
    Robot {
        name: name.to_owned(),
        ..tree
    }
}

/// The names of the robots of [`floating`].
pub const FLOATING: [&str; 4] = ["free_body", "hyq", "torso", "humanoid"];

/// A robot with a base that moves: a rigid body, or one of the trees on a trunk.
///
/// # Panics
///
/// Where there is none of that name.
pub fn floating(name: &str) -> Robot {
    // The trunk of HyQ.
    let trunk = Body {
        mass: decimal(60.96),
        com: [0.056, 0.0215, 0.00358].map(decimal),
        inertia: [
            1.5725937, 8.5015928, 9.1954911, 0.028375, -0.004462, -0.203139,
        ]
        .map(decimal),
    };
    let robot = match name {
        "free_body" => bare(),
        name => tree(name),
    };
    Robot {
        name: name.to_owned(),
        base: Some(Base::Floating(trunk)),
        ..robot
    }
}

/// A robot without rows, gravity down.
fn bare() -> Robot {
    Robot {
        rows: Vec::new(),
        ..without_friction("panda")
    }
}

fn without_friction(name: &str) -> Robot {
    let mut robot = robot(name);
    for row in &mut robot.rows {
        row.viscous = Value::zero();
        row.coulomb = [(); 2].map(|()| Value::zero());
    }
    robot
}

fn quarter(turns: i64) -> Value {
    let half = Value::integer(2);
    Value::Pi
        * Value::integer(turns)
            .checked_div(half)
            .expect("two is not zero")
}

/// T(xyz), then a roll and a yaw by quarter turns.
fn at(xyz: [f64; 3], [roll, yaw]: [i64; 2]) -> Vec<Placement> {
    let rpy = [quarter(roll), Value::zero(), quarter(yaw)];
    let xyz = xyz.map(decimal);
    vec![Placement { xyz, rpy }]
}

/// A link of a mass, a centre of mass and a tensor.
fn link(joint_type: JointType, mass: f64, com: [f64; 3], inertia: [f64; 6]) -> Row {
    Row {
        mass: decimal(mass),
        com: com.map(decimal),
        inertia: inertia.map(decimal),
        ..Row::new("joint", joint_type)
    }
}

/// A robot with the rows of another one, whose base is fixed to a row at a place, or to the base.
fn with(mut robot: Robot, other: &Robot, row: Option<usize>, places: &[Placement]) -> Robot {
    let count = robot.rows.len();
    for (i, row_of_other) in other.rows.iter().enumerate() {
        let carrier = other.parent(i).map(|parent| count + parent);
        let mut added = row_of_other.clone();
        added.name = format!("joint{}", count + i + 1);
        if carrier.is_none() {
            added.at = [places.to_vec(), added.at].concat();
        }
        added.on = carrier.or(row).map_or(Carrier::Base, Carrier::Row);
        robot.rows.push(added);
    }
    robot
}

/// The Panda with its hand as a body on link 7, and two fingers that slide apart, as in the file of the Panda that
/// Pinocchio's examples have.
fn panda_with_fingers() -> Robot {
    let mut panda = without_friction("panda");
    let eighth = quarter(1)
        .checked_div(Value::integer(-2))
        .expect("two is not zero");
    let hand = vec![Placement {
        xyz: [0.0, 0.0, 0.107].map(decimal),
        rpy: [Value::zero(), Value::zero(), eighth],
    }];
    panda.frames.push(Frame {
        name: "hand".to_owned(),
        on: Some(6),
        places: hand.clone(),
        body: Some(Body {
            mass: decimal(0.73),
            com: [-0.01, 0.0, 0.03].map(decimal),
            inertia: [0.001, 0.0025, 0.0017, 0.0, 0.0, 0.0].map(decimal),
        }),
    });
    let finger = Robot {
        rows: vec![link(
            JointType::Prismatic,
            0.015,
            [0.0; 3],
            [2.375e-6, 7.5e-7, 2.375e-6, 0.0, 0.0, 0.0],
        )],
        ..bare()
    };
    [1, -1].into_iter().fold(panda, |robot, side| {
        // The z axis is along the y axis of the hand, or against it.
        let along = at([0.0, 0.0, 0.0584], [-side, 0]);
        with(robot, &finger, Some(6), &[hand.clone(), along].concat())
    })
}

fn two_pandas() -> Robot {
    let one = without_friction("panda");
    with(one.clone(), &one, None, &at([1.0, 0.0, 0.0], [0, 0]))
}

/// The four legs of HyQ on a trunk that stands, as in the file of Pinocchio's examples.
fn hyq() -> Robot {
    let legs = [[1, 1], [1, -1], [-1, 1], [-1, -1]];
    legs.into_iter().fold(bare(), |robot, [front, left]| {
        let hip = Placement {
            xyz: [0.3735 * f64::from(front), 0.207 * f64::from(left), 0.0].map(decimal),
            rpy: [Value::zero(), quarter(1), quarter(1 + i64::from(left))],
        };
        with(robot, &leg(f64::from(front), f64::from(left)), None, &[hip])
    })
}

fn leg(front: f64, left: f64) -> Robot {
    use JointType::Revolute;
    let diagonal = front * left;
    let hip = link(
        Revolute,
        2.93,
        [0.04263, 0.0, 0.16931 * diagonal],
        [
            0.05071,
            0.05486,
            0.00571,
            -4e-5 * diagonal,
            -5e-5,
            -0.00159 * diagonal,
        ],
    );
    let upper = Row {
        a: decimal(0.08),
        alpha: quarter(if left > 0.0 { 1 } else { -1 }),
        ..link(
            Revolute,
            2.638,
            [0.15074, -0.02625 * front, 0.0],
            [
                0.00368,
                0.02719,
                0.02811,
                -0.00302 * front,
                2e-5,
                1e-4 * front,
            ],
        )
    };
    let lower = Row {
        a: decimal(0.35),
        ..link(
            Revolute,
            0.881,
            [0.1254, 4e-5 * front, -1e-4 * front],
            [0.00047, 0.01256, 0.01233, 6e-5 * front, 0.0, -1e-5 * front],
        )
    };
    Robot {
        rows: vec![hip, upper, lower],
        ..bare()
    }
}

/// Four equal fingers of four joints on a palm that two joints turn.
fn four_fingers() -> Robot {
    use JointType::Revolute;
    let turned = |a: f64, turns: i64, row: Row| Row {
        a: decimal(a),
        alpha: quarter(turns),
        ..row
    };
    let slender = |length: f64, mass: f64| {
        let moment = mass * length * length / 12.0;
        let thousandths = |x: f64| (x * 1e9).round() / 1e9;
        let across = thousandths(moment + 1e-6);
        link(
            Revolute,
            mass,
            [length / 2.0, 0.001, 0.0],
            [1e-6, across, across, 0.0, 0.0, 0.0],
        )
    };
    let finger = Robot {
        rows: vec![
            slender(0.02, 0.03),
            turned(0.0, 1, slender(0.05, 0.06)),
            turned(0.05, 0, slender(0.04, 0.04)),
            turned(0.04, 0, slender(0.03, 0.02)),
        ],
        ..bare()
    };
    let palm = [0.0009, 0.0011, 0.0005, 0.0, 0.0001, 0.0];
    let wrist = Robot {
        rows: vec![
            link(Revolute, 0.2, [0.0, 0.01, 0.02], palm),
            turned(
                0.0,
                1,
                link(Revolute, 0.6, [0.04, 0.002, 0.001], palm.map(|x| 2.0 * x)),
            ),
        ],
        ..bare()
    };
    let places = [-0.04, -0.015, 0.01, 0.035];
    places.into_iter().fold(wrist, |robot, z| {
        with(robot, &finger, Some(1), &at([0.09, 0.005, z], [0, 0]))
    })
}

/// A lift and a waist with an arm on either side.
fn torso() -> Robot {
    let trunk = Robot {
        rows: vec![
            link(JointType::Prismatic, 20.0, [0.0, 0.0, 0.2], [0.0; 6]),
            link(
                JointType::Revolute,
                9.0,
                [0.02, 0.0, 0.2],
                [0.2, 0.15, 0.1, 0.0, 0.0, 0.01],
            ),
        ],
        ..bare()
    };
    let arm = without_friction("panda");
    let left = with(trunk, &arm, Some(1), &at([0.05, 0.2, 0.4], [-1, 0]));
    with(left, &arm, Some(1), &at([0.05, -0.2, 0.4], [1, 0]))
}

/// The generic chain of seven joints, the last three of which stand on its second link.
fn forked_chain() -> Robot {
    let mut chain = generic_chain(7);
    chain.rows[4].on = Carrier::Row(1);
    chain
}

/// Thirty joints: two legs of six, a waist of two, a neck of two and two arms of seven, all of generic links.
fn humanoid() -> Robot {
    let part = |from: usize, count: usize| Robot {
        rows: generic_chain(from + count).rows.split_off(from),
        convention: Convention::Standard,
        ..bare()
    };
    let legs = with(part(0, 6), &part(0, 6), None, &at([0.0, -0.2, 0.0], [0, 0]));
    let trunk = with(legs, &part(2, 2), None, &at([0.0, 0.0, 0.3], [0, 0]));
    let neck = with(trunk, &part(5, 2), Some(13), &at([0.0, 0.0, 0.5], [0, 0]));
    [0.3, -0.3].into_iter().fold(neck, |robot, y| {
        with(robot, &part(1, 7), Some(13), &at([0.0, y, 0.4], [1, 0]))
    })
}
