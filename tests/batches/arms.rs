//! Small arms: one with every function, two with some.

use robot_dynamics::robot_dynamics;

/// The robot of a table with the functions of a list.
macro_rules! robot_with {
    ({ $($table:tt)* } $($name:ident $arguments:tt)*) => {
        robot_dynamics! { $($table)* functions: [$($name),*], }
    };
}

each_function! { robot_with {
    /// A lift and a swing with fields in every kind of cell.
    pub(crate) struct Crane { mass: f64, length: f64, twist: f64, coulomb: f64, g: f64, tilt: f64, reach: f64 }

    convention: modified,
    gravity: [0, g, -g],
    base: { xyz: [0.1, 0, 0.8], rpy: [0, tilt, 0.3] },
    joints: [
        slider: prismatic {
            alpha: twist, mass: 2, friction: { viscous: 0.5, coulomb: coulomb }, spring: { stiffness: 20, rest: 0.1 },
        },
        swing: revolute {
            a: length, alpha: PI/2, theta: 0.25, mass: mass, com: [0.1, length, -0.2],
            inertia: cuboid(0.3, 0.2, 0.4), friction: { viscous: 0.1, coulomb: 0.7 },
        },
    ],
    tool: { xyz: [0.1, 0, reach], rpy: [0, 0, 0.2], mass: mass / 4, com: [0, 0, 0.05] },
} }

pub(crate) const CRANE: Crane = Crane {
    mass: 1.25,
    length: 0.4,
    twist: -0.6,
    coulomb: 0.3,
    g: 9.81,
    tilt: 0.1,
    reach: 0.2,
};

impl Crane {
    /// One of many.
    pub(crate) fn numbered(i: usize) -> Crane {
        let x = i as f64 / 50.0;
        Crane {
            mass: 1.25 + x,
            length: 0.4 + 0.3 * x,
            twist: -0.6 - x,
            coulomb: 0.3 * x,
            g: 9.81 - x,
            tilt: 0.1 + x,
            reach: 0.2 + x * x,
        }
    }
}

robot_dynamics! {
    /// Three axes, none parallel, with a motor.
    pub(crate) struct Wrist;

    convention: standard,
    gravity: [0.3, 0, -9.81],
    joints: [
        yaw: revolute {
            d: 0.3, alpha: PI/2, mass: 2, com: [0, -0.1, 0.02], inertia: cylinder(0.1, 0.3),
            motor: { inertia: 1e-4, gear_ratio: 40 }, friction: { viscous: 0.3, coulomb: 1.5 },
        },
        pitch: revolute { a: 0.25, alpha: 0.7, mass: 1.5, com: [-0.1, 0.02, 0.05], inertia: cuboid(0.3, 0.1, 0.1) },
        roll: revolute { a: 0.1, mass: 1, com: [-0.05, 0.02, 0.1], inertia: cylinder(0.05, 0.2) },
    ],
    functions: [
        friction_vector, inverse_dynamics_derivatives, forward_dynamics_derivatives, link_poses,
        control_terms = (mass_matrix, coriolis_vector, kinetic_energy),
        motion = (forward_dynamics, forward_kinematics),
    ],
}

robot_dynamics! {
    /// A point mass on a strut of two bars without mass: stretched, it has no inertia along itself.
    pub(crate) struct Strut;

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 1 },
        elbow: revolute { a: 1, mass: 1 },
    ],
    functions: [
        forward_dynamics, forward_dynamics_derivatives, forward_dynamics_aba, operational_inertia_inverse,
        taylor_series,
    ],
}
