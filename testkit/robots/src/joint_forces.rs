//! Arms with more at their joints than viscous and Coulomb friction.

every_function! {
    /// A lift on a spring, and two links behind it, the first of which a spring pulls back.
    pub struct SprungArm;

    convention: modified,
    gravity: [0.4, -1.1, -9.7],
    joints: [
        lift: prismatic {
            mass: 3, com: [0.05, -0.02, 0.1],
            inertia: { xx: 0.03, yy: 0.02, zz: 0.025, xy: 0.001, yz: -0.002, xz: 0.0015 },
            spring: { stiffness: 200, rest: 0.1 },
            friction: { viscous: 2.5, coulomb: 1.5 },
        },
        turn: revolute {
            a: 0.3, alpha: 0.4, d: 0.1, theta: -0.2,
            mass: 1.4, com: [0.12, 0.03, -0.04],
            inertia: { xx: 0.011, yy: 0.016, zz: 0.013, xy: -0.001, yz: 0.0005, xz: 0.0007 },
            motor: { inertia: 0.0002, gear_ratio: 40 },
            spring: { stiffness: 5.5, rest: -0.2 },
        },
        elbow: revolute {
            a: 0.25, alpha: -1.1,
            mass: 0.8, com: [0.1, -0.02, 0.03],
            inertia: { xx: 0.004, yy: 0.006, zz: 0.005, xy: 0.0003, yz: 0.0002, xz: -0.0004 },
            friction: { viscous: 0.1, coulomb: 0.05 },
        },
    ],
}
