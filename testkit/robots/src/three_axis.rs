//! Arms of three axes, one for each way of placing a hand; the numbers are ours.

every_function! {
    /// An anthropomorphic arm: waist, shoulder and elbow, with motors, gears and friction.
    pub struct Elbow3r;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute {
            d: 0.4, alpha: PI/2,
            mass: 5, com: [0.01, -0.12, 0.02],
            inertia: { xx: 0.06, yy: 0.03, zz: 0.055, xy: 0.001, yz: -0.002, xz: 0.0015 },
            motor: { inertia: 0.0002, gear_ratio: 100 },
            friction: { viscous: 0.6, coulomb: 0.9 },
        },
        shoulder: revolute {
            a: 0.45,
            mass: 7.5, com: [-0.21, 0.015, 0.06],
            inertia: { xx: 0.05, yy: 0.21, zz: 0.22, xy: -0.004, yz: 0.003, xz: 0.006 },
            motor: { inertia: 0.0002, gear_ratio: 120 },
            friction: { viscous: 0.8, coulomb: 1.1 },
        },
        elbow: revolute {
            a: 0.38,
            mass: 3.2, com: [-0.17, -0.01, 0.015],
            inertia: { xx: 0.009, yy: 0.045, zz: 0.048, xy: 0.0012, yz: -0.0008, xz: 0.0009 },
            motor: { inertia: 0.0001, gear_ratio: 80 },
            friction: { viscous: 0.4, coulomb: 0.5 },
        },
    ],
}

every_function! {
    /// A Cartesian gantry: its mass matrix is diagonal and constant.
    pub struct GantryPpp;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        lift: prismatic {
            alpha: -PI/2,
            mass: 12, com: [0.1, 0.05, 0.2],
            inertia: { xx: 0.5, yy: 0.6, zz: 0.4, xy: 0.02, yz: 0.01, xz: 0.03 },
            friction: { viscous: 5, coulomb: 8 },
        },
        bridge: prismatic {
            d: 0.1, theta: -PI/2, alpha: -PI/2,
            mass: 7, com: [-0.05, 0.1, 0.02],
            inertia: { xx: 0.2, yy: 0.25, zz: 0.15, xy: 0.01, yz: -0.01, xz: 0.02 },
            friction: { viscous: 4, coulomb: 6 },
        },
        trolley: prismatic {
            d: 0.2,
            mass: 3, com: [0.02, -0.03, -0.1],
            inertia: { xx: 0.05, yy: 0.05, zz: 0.02, xy: 0.001, yz: 0.002, xz: 0.003 },
            friction: { viscous: 3, coulomb: 4 },
        },
    ],
}

every_function! {
    /// A cylindrical arm: a turning column, a lift and a telescope.
    pub struct CylindricalRpp;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        column: revolute {
            d: 0.35,
            mass: 8, com: [0.02, 0.01, -0.1],
            inertia: { xx: 0.12, yy: 0.13, zz: 0.05, xy: 0.004, yz: 0.002, xz: -0.003 },
        },
        lift: prismatic {
            d: 0.2, alpha: -PI/2,
            mass: 5, com: [0.03, -0.02, 0.04],
            inertia: { xx: 0.06, yy: 0.03, zz: 0.055, xy: 0.002, yz: -0.001, xz: 0.003 },
        },
        arm: prismatic {
            d: 0.3,
            mass: 2.5, com: [0.01, 0.02, -0.15],
            inertia: { xx: 0.03, yy: 0.031, zz: 0.004, xy: 0.0005, yz: 0.0007, xz: -0.0006 },
        },
    ],
}

every_function! {
    /// A wrist whose three axes meet.
    pub struct SphericalWrist;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        roll: revolute {
            d: 0.43, alpha: -PI/2,
            mass: 1.6, com: [0.002, 0.1, -0.004],
            inertia: { xx: 0.012, yy: 0.003, zz: 0.0115, xy: 0.0001, yz: -0.0002, xz: 0.0003 },
        },
        pitch: revolute {
            alpha: PI/2,
            mass: 0.9, com: [0.001, -0.01, 0.02],
            inertia: { xx: 0.0021, yy: 0.002, zz: 0.0011, xy: 5e-5, yz: 7e-5, xz: -4e-5 },
        },
        yaw: revolute {
            d: 0.1,
            mass: 0.45, com: [0.003, -0.002, -0.03],
            inertia: { xx: 0.0009, yy: 0.00095, zz: 0.0005, xy: 2e-5, yz: 3e-5, xz: -1e-5 },
        },
    ],
}
