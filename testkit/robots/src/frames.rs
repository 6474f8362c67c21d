//! Arms on a mounting that is placed in the world, with tools.

every_function! {
    /// A lift and an arm on a mounting that tilts, a load at its end: fields in base and tool.
    pub struct TiltingCell {
        /// Pitch of the mounting, rad.
        pub tilt: f64,
        /// Yaw of the mounting, and pitch of the tool, rad.
        pub turn: f64,
        /// Mass at the end, kg.
        pub load: f64,
        /// How far the tool frame is from the last link frame, m.
        pub reach: f64,
    }

    convention: standard,
    gravity: [0.3, 0, -9.81],
    base: { xyz: [0.5, -0.2, 0.8], rpy: [-PI/2, tilt, turn] },
    joints: [
        lift: prismatic {
            a: 0.12, alpha: -PI/2, d: 0.25, theta: 0.2,
            mass: 4, com: [0.06, -0.12, 0.05],
            inertia: { xx: 0.06, yy: 0.07, zz: 0.09, xy: 0.01 },
            motor: { inertia: 0.001, gear_ratio: 30 },
            friction: { viscous: 0.4, coulomb: 0.2 },
        },
        shoulder: revolute {
            a: 0.5, alpha: 0.4,
            mass: 3, com: [-0.25, 0.03, 0.06],
            inertia: { xx: 0.03, yy: 0.12, zz: 0.13, yz: 0.01 },
            friction: { viscous: 0.3 },
        },
        elbow: revolute {
            a: 0.35, alpha: PI/2,
            mass: 1.5, com: [-0.18, 0, 0.03],
            inertia: { xx: 0.01, yy: 0.04, zz: 0.045, xz: -0.003 },
        },
        roll: revolute {
            d: 0.15, alpha: 0.7, a: 0.05,
            mass: 0.5, com: [0, 0.02, 0.03],
            inertia: { xx: 0.002, yy: 0.0021, zz: 0.0012 },
        },
    ],
    tool: {
        xyz: [0.06, -0.03, reach], rpy: [PI/2, turn, 0.3],
        mass: load, com: [0.03, 0.01, 0.07],
        inertia: { xx: load / 32, yy: load / 40, zz: load / 30, xy: -load / 200 },
    },
}

/// The values of the fields at which the tests examine this arm as every other one: a constant with the struct's own name,
/// because a struct without fields is a value by its name.
#[allow(non_upper_case_globals, reason = "the name of the struct")]
pub const TiltingCell: TiltingCell = TiltingCell {
    tilt: 0.3,
    turn: -0.7,
    load: 1.25,
    reach: 0.16,
};
