//! Arms of each class that has a closed form, by their geometry alone.

use robot_dynamics::robot_dynamics;

macro_rules! arm {
    ($(#[$meaning:meta])* $name:ident, [$($rows:tt)*] $($more:tt)*) => {
        robot_dynamics! {
            $(#[$meaning])*
            pub(crate) struct $name;

            convention: standard,
            gravity: [0, 0, -9.81],
            joints: [$($rows)*],
            $($more)*
            functions: [forward_kinematics, link_poses, jacobian, inverse_kinematics],
        }

        impl $name {
            /// The rows, as they are written.
            #[allow(dead_code, reason = "measurements read no text")]
            pub(crate) const ROWS: &str = stringify!($($rows)*);
        }
    };
}

arm! {
    /// Spherical wrist, axes 2 and 3 parallel.
    Puma560, [
        q1: revolute { d: 0.67183, alpha: PI/2 },
        q2: revolute { a: 0.4318 },
        q3: revolute { a: 0.0203, d: 0.15005, alpha: -PI/2 },
        q4: revolute { d: 0.4318, alpha: PI/2 },
        q5: revolute { alpha: -PI/2 },
        q6: revolute {},
    ]
}

arm! {
    /// Three parallel axes.
    Ur5, [
        q1: revolute { d: 0.089159, alpha: PI/2 },
        q2: revolute { a: -0.425 },
        q3: revolute { a: -0.39225 },
        q4: revolute { d: 0.10915, alpha: PI/2 },
        q5: revolute { d: 0.09465, alpha: -PI/2 },
        q6: revolute { d: 0.0823 },
    ]
}

arm! {
    /// Spherical wrist behind a joint that slides.
    Stanford, [
        q1: revolute { d: 0.412, alpha: -PI/2 },
        q2: revolute { d: 0.154, alpha: PI/2 },
        q3: prismatic { a: 0.0203, theta: -PI/2 },
        q4: revolute { alpha: -PI/2 },
        q5: revolute { alpha: PI/2 },
        q6: revolute {},
    ]
}

arm! {
    /// A shoulder of three axes that meet, a base and a tool.
    Shoulder, [
        q1: revolute { alpha: PI/2 },
        q2: revolute { alpha: -PI/2 },
        q3: revolute { d: 0.4, a: 0.1, alpha: PI/2 },
        q4: revolute { a: 0.35 },
        q5: revolute { a: 0.1, alpha: PI/2 },
        q6: revolute { d: 0.2 },
    ]
    base: { xyz: [0.1, -0.2, 0.3], rpy: [0.3, deg(-20), 0.7] },
    tool: { xyz: [0.05, 0.02, 0.1], rpy: [0.1, 0.2, deg(35)] },
}

arm! {
    /// A wrist of three rolls, whose axes are inclined by 60 degrees, on a turning base with a step: a1 is not 0.
    ThreeRolls, [
        q1: revolute { d: 0.5, a: 0.15, alpha: deg(-90), theta: 0.3 },
        q2: revolute { a: 0.6 },
        q3: revolute { a: 0.1, alpha: deg(-90) },
        q4: revolute { d: 0.7, alpha: deg(60) },
        q5: revolute { alpha: deg(-60) },
        q6: revolute { d: 0.12 },
    ]
}

arm! {
    /// A gantry with a spherical wrist.
    GantryWithWrist, [
        q1: prismatic { alpha: -PI/2 },
        q2: prismatic { d: 0.1, theta: -PI/2, alpha: -PI/2 },
        q3: prismatic { d: 0.2 },
        q4: revolute { alpha: PI/2 },
        q5: revolute { alpha: -PI/2 },
        q6: revolute { d: 0.1 },
    ]
}

arm! {
    /// Seven joints with a spherical shoulder and a spherical wrist, a step at the elbow and a tool.
    SevenJoints, [
        q1: revolute { d: 0.36, alpha: -PI/2 },
        q2: revolute { alpha: PI/2 },
        q3: revolute { d: 0.42, a: 0.05, alpha: PI/2 },
        q4: revolute { a: -0.05, alpha: -PI/2 },
        q5: revolute { d: 0.4, alpha: -PI/2 },
        q6: revolute { alpha: PI/2 },
        q7: revolute { d: 0.126 },
    ]
    tool: { xyz: [0.02, 0, 0.1], rpy: [0.1, 0.2, deg(35)] },
}

arm! {
    /// KUKA LBR iiwa 14.
    Iiwa14, [
        q1: revolute { d: 0.36, alpha: -PI/2 },
        q2: revolute { alpha: PI/2 },
        q3: revolute { d: 0.42, alpha: PI/2 },
        q4: revolute { alpha: -PI/2 },
        q5: revolute { d: 0.4, alpha: -PI/2 },
        q6: revolute { alpha: PI/2 },
        q7: revolute { d: 0.126 },
    ]
}

arm! {
    /// The same with both halves equally long: folded, its wrist is in its shoulder.
    EqualHalves, [
        q1: revolute { d: 0.36, alpha: -PI/2 },
        q2: revolute { alpha: PI/2 },
        q3: revolute { d: 0.4, alpha: PI/2 },
        q4: revolute { alpha: -PI/2 },
        q5: revolute { d: 0.4, alpha: -PI/2 },
        q6: revolute { alpha: PI/2 },
        q7: revolute { d: 0.126 },
    ]
}

arm! {
    /// Four parallel axes.
    Scara, [
        q1: revolute { d: 0.387, a: 0.325 },
        q2: revolute { a: 0.275, alpha: PI },
        q3: prismatic {},
        q4: revolute {},
    ]
}

arm! {
    /// Three joints that reach a position.
    Elbow3r, [
        q1: revolute { d: 0.4, alpha: PI/2 },
        q2: revolute { a: 0.45 },
        q3: revolute { a: 0.38 },
    ]
}

arm! {
    /// A waist and three parallel axes: ROBOTIS OpenMANIPULATOR-X.
    OpenManipulator, [
        q1: revolute { d: 0.077, a: 0.012, alpha: PI/2 },
        q2: revolute { a: 0.1302, theta: 1.3854 },
        q3: revolute { a: 0.124, theta: -1.3854 },
        q4: revolute { a: 0.126 },
    ]
}

arm! {
    /// A waist, three parallel axes and a roll, about as an SO-100, with a step beside the waist.
    So100, [
        q1: revolute { d: 0.0542, a: 0.0304, alpha: -PI/2 },
        q2: revolute { a: 0.1126, d: 0.01 },
        q3: revolute { a: 0.1349, theta: 0.2 },
        q4: revolute { alpha: PI/2, theta: PI/2 },
        q5: revolute { d: 0.1 },
    ]
}

arm! {
    /// The same with a tool beside the axis of its roll, on a base that stands inclined.
    BesideRoll, [
        q1: revolute { d: 0.0542, a: 0.0304, alpha: -PI/2 },
        q2: revolute { a: 0.1126, d: 0.01 },
        q3: revolute { a: 0.1349, theta: 0.2 },
        q4: revolute { alpha: PI/2, theta: PI/2 },
        q5: revolute { d: 0.1 },
    ]
    base: { xyz: [0.1, -0.2, 0.3], rpy: [0.3, deg(-20), 0.7] },
    tool: { xyz: [0.03, -0.01, 0.05], rpy: [0.1, 0.2, deg(35)] },
}

arm! {
    /// A plane arm, which reaches a position and an angle.
    RrrPlanar, [
        q1: revolute { a: 0.5 },
        q2: revolute { a: 0.4 },
        q3: revolute { a: 0.25 },
    ]
}

arm! {
    /// A turn, a lift and a reach.
    Cylindrical, [
        q1: revolute { d: 0.35 },
        q2: prismatic { d: 0.2, alpha: -PI/2 },
        q3: prismatic { d: 0.3 },
    ]
}

arm! {
    /// Two joints in a plane, of which a part of all positions is reached.
    TwoLink, [
        q1: revolute { a: 0.5 },
        q2: revolute { a: 0.4 },
    ]
}

/// An arm of Universal Robots by its five lengths and the step at the shoulder.
macro_rules! universal {
    ($(#[$meaning:meta])* $name:ident, $d1:literal, $a2:literal, $a3:literal, $d4:literal, $d5:literal, $d6:literal) => {
        arm! {
            $(#[$meaning])*
            $name, [
                q1: revolute { d: $d1, alpha: PI/2 },
                q2: revolute { a: -$a2 },
                q3: revolute { a: -$a3 },
                q4: revolute { d: $d4, alpha: PI/2 },
                q5: revolute { d: $d5, alpha: -PI/2 },
                q6: revolute { d: $d6 },
            ]
        }
    };
}

universal! {
    /// Universal Robots UR3e.
    Ur3e, 0.15185, 0.24355, 0.2132, 0.13105, 0.08535, 0.0921
}

universal! {
    /// Universal Robots UR5e.
    Ur5e, 0.1625, 0.425, 0.3922, 0.1333, 0.0997, 0.0996
}

universal! {
    /// Universal Robots UR10e.
    Ur10e, 0.1807, 0.6127, 0.57155, 0.17415, 0.11985, 0.11655
}

universal! {
    /// One whose arm is above its first axis: with the wrist there, too, the first joint may turn.
    NoStep, 0.2, 0.4, 0.35, 0.0, 0.1, 0.08
}

arm! {
    /// KUKA KR 6 R900: a spherical wrist, a step behind the first axis.
    Kr6, [
        q1: revolute { d: 0.4, a: 0.025, alpha: -PI/2 },
        q2: revolute { a: 0.455 },
        q3: revolute { a: 0.035, alpha: -PI/2 },
        q4: revolute { d: 0.42, alpha: PI/2 },
        q5: revolute { alpha: -PI/2 },
        q6: revolute { d: 0.08 },
    ]
}

arm! {
    /// A spherical shoulder in front of two parallel axes, whose wrist can come near it.
    Reversed, [
        q1: revolute { d: 0.25, alpha: PI/2 },
        q2: revolute { alpha: PI/2 },
        q3: revolute { d: 0.3, alpha: -PI/2 },
        q4: revolute { a: -0.3, d: -0.2 },
        q5: revolute { a: -0.5, d: 0.4, alpha: PI/2 },
        q6: revolute { d: 0.1 },
    ]
    tool: { xyz: [0.6, -0.2, 0], rpy: [0, 0, 0] },
}

arm! {
    /// Two links of the same length: folded, the tip is on the first axis.
    EqualLinks, [
        q1: revolute { a: 0.5 },
        q2: revolute { a: 0.5 },
    ]
}

arm! {
    /// A spherical wrist, the first two axes meet.
    Upright, [
        q1: revolute { d: 0.4, alpha: PI/2 },
        q2: revolute { a: 0.4 },
        q3: revolute { alpha: PI/2 },
        q4: revolute { d: 0.35, alpha: -PI/2 },
        q5: revolute { alpha: PI/2 },
        q6: revolute { d: 0.08 },
    ]
}

arm! {
    /// A wrist that inclines the hand by 60 degrees at least.
    Inclined, [
        q1: revolute { a: -0.3 },
        q2: revolute { d: -0.4, alpha: PI/2 },
        q3: revolute { a: 0.3, d: 0.2, alpha: -PI/2 },
        q4: revolute { alpha: deg(60) },
        q5: revolute { alpha: deg(60) },
        q6: revolute { d: 0.3 },
    ]
}

arm! {
    /// Three parallel axes at the base: the fourth joint follows from a height, the fifth from a direction.
    ParallelBase, [
        q1: revolute { a: 0.3, d: 0.3 },
        q2: revolute { a: 0.3, d: 0.2 },
        q3: revolute { a: 0.3, d: -0.2, alpha: -PI/2 },
        q4: revolute { d: 0.2, alpha: -PI/2 },
        q5: revolute { d: -0.4, alpha: PI/2 },
        q6: revolute { alpha: PI/2 },
    ]
}

robot_dynamics! {
    /// A spherical wrist whose axes are inclined by a field, on a base that is tilted by another one.
    pub(crate) struct Fitted { pub(crate) reach: f64, pub(crate) skew: f64, pub(crate) tilt: f64 }

    convention: standard,
    gravity: [0, 0, -9.81],
    base: { xyz: [0.1, 0, 0.4], rpy: [tilt, 0, 0.2] },
    joints: [
        q1: revolute { alpha: PI/2 },
        q2: revolute { a: reach, theta: tilt },
        q3: revolute { a: 0.05, d: 0.1, alpha: -PI/2 },
        q4: revolute { d: 0.5 + reach, alpha: PI/2 + skew },
        q5: revolute { alpha: -PI/2 - skew },
        q6: revolute { d: 0.1, theta: skew },
    ],
    functions: [forward_kinematics, inverse_kinematics],
}

/// Hands each arm to the macro `$then`: its name, its number of joints, and whether it reads the rotation of a pose.
macro_rules! for_each_arm {
    ($then:ident) => {
        $then! {
            Puma560: 6, true; Ur5: 6, true; Stanford: 6, true; Shoulder: 6, true; ThreeRolls: 6, true;
            GantryWithWrist: 6, true; SevenJoints: 7, true; Iiwa14: 7, true; EqualHalves: 7, true; Scara: 4, true; OpenManipulator: 4, true;
            So100: 5, true; BesideRoll: 5, true; Elbow3r: 3, false;
            RrrPlanar: 3, true; Cylindrical: 3, false; TwoLink: 2, false;
        }
    };
}
pub(crate) use for_each_arm;

/// More arms of these classes, whose times and random poses are like theirs.
#[allow(unused_macros, reason = "measurements take one of each class")]
macro_rules! for_more_arms {
    ($then:ident) => {
        $then! {
            Ur3e: 6, true; Ur5e: 6, true; Ur10e: 6, true; NoStep: 6, true; Kr6: 6, true; Reversed: 6, true;
            EqualLinks: 2, false; Upright: 6, true; Inclined: 6, true; ParallelBase: 6, true;
        }
    };
}
#[allow(unused_imports, reason = "as above")]
pub(crate) use for_more_arms;
