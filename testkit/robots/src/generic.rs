//! Arms in which nothing is zero, so that no simplification can hide a wrong term.

every_function! {
    /// One revolute joint, every cell non-zero.
    pub struct GenericChain1;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        joint1: revolute {
            d: 0.1, theta: 0.25, a: 0.17, alpha: -0.1,
            mass: 1.8, com: [0.09, -0.06, 0.08],
            inertia: { xx: 0.014, yy: 0.018, zz: 0.014, xy: -0.001, yz: -0.0008, xz: -0.0006 },
        },
    ],
}

every_function! {
    /// Two revolute joints, every cell non-zero.
    pub struct GenericChain2;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        joint1: revolute {
            d: 0.1, theta: 0.25, a: 0.17, alpha: -0.1,
            mass: 1.8, com: [0.09, -0.06, 0.08],
            inertia: { xx: 0.014, yy: 0.018, zz: 0.014, xy: -0.001, yz: -0.0008, xz: -0.0006 },
        },
        joint2: revolute {
            d: -0.15, theta: 0.3, a: 0.13, alpha: 1,
            mass: 3.1, com: [0.08, 0.04, -0.07],
            inertia: { xx: 0.013, yy: 0.014, zz: 0.015, xy: 0.0015, yz: -0.0004, xz: 0.0009 },
        },
    ],
}

every_function! {
    /// Three revolute joints, every cell non-zero.
    pub struct GenericChain3;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        joint1: revolute {
            d: 0.1, theta: 0.25, a: 0.17, alpha: -0.1,
            mass: 1.8, com: [0.09, -0.06, 0.08],
            inertia: { xx: 0.014, yy: 0.018, zz: 0.014, xy: -0.001, yz: -0.0008, xz: -0.0006 },
        },
        joint2: revolute {
            d: -0.15, theta: 0.3, a: 0.13, alpha: 1,
            mass: 3.1, com: [0.08, 0.04, -0.07],
            inertia: { xx: 0.013, yy: 0.014, zz: 0.015, xy: 0.0015, yz: -0.0004, xz: 0.0009 },
        },
        joint3: revolute {
            d: 0.07, theta: -0.1, a: 0.2, alpha: -0.4,
            mass: 1.3, com: [-0.07, 0.02, 0.06],
            inertia: { xx: 0.014, yy: 0.017, zz: 0.011, xy: -0.0005, yz: 0.0008, xz: -0.0012 },
        },
    ],
}

every_function! {
    /// Four revolute joints, every cell non-zero.
    pub struct GenericChain4;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        joint1: revolute {
            d: 0.1, theta: 0.25, a: 0.17, alpha: -0.1,
            mass: 1.8, com: [0.09, -0.06, 0.08],
            inertia: { xx: 0.014, yy: 0.018, zz: 0.014, xy: -0.001, yz: -0.0008, xz: -0.0006 },
        },
        joint2: revolute {
            d: -0.15, theta: 0.3, a: 0.13, alpha: 1,
            mass: 3.1, com: [0.08, 0.04, -0.07],
            inertia: { xx: 0.013, yy: 0.014, zz: 0.015, xy: 0.0015, yz: -0.0004, xz: 0.0009 },
        },
        joint3: revolute {
            d: 0.07, theta: -0.1, a: 0.2, alpha: -0.4,
            mass: 1.3, com: [-0.07, 0.02, 0.06],
            inertia: { xx: 0.014, yy: 0.017, zz: 0.011, xy: -0.0005, yz: 0.0008, xz: -0.0012 },
        },
        joint4: revolute {
            d: -0.12, theta: 0.2, a: 0.16, alpha: 0.7,
            mass: 2.6, com: [0.06, -0.07, -0.05],
            inertia: { xx: 0.013, yy: 0.013, zz: 0.012, xy: 0.001, yz: -0.0004, xz: -0.0003 },
        },
    ],
}

every_function! {
    /// Six revolute joints, every cell non-zero.
    pub struct GenericChain6;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        joint1: revolute {
            d: 0.1, theta: 0.25, a: 0.17, alpha: -0.1,
            mass: 1.8, com: [0.09, -0.06, 0.08],
            inertia: { xx: 0.014, yy: 0.018, zz: 0.014, xy: -0.001, yz: -0.0008, xz: -0.0006 },
        },
        joint2: revolute {
            d: -0.15, theta: 0.3, a: 0.13, alpha: 1,
            mass: 3.1, com: [0.08, 0.04, -0.07],
            inertia: { xx: 0.013, yy: 0.014, zz: 0.015, xy: 0.0015, yz: -0.0004, xz: 0.0009 },
        },
        joint3: revolute {
            d: 0.07, theta: -0.1, a: 0.2, alpha: -0.4,
            mass: 1.3, com: [-0.07, 0.02, 0.06],
            inertia: { xx: 0.014, yy: 0.017, zz: 0.011, xy: -0.0005, yz: 0.0008, xz: -0.0012 },
        },
        joint4: revolute {
            d: -0.12, theta: 0.2, a: 0.16, alpha: 0.7,
            mass: 2.6, com: [0.06, -0.07, -0.05],
            inertia: { xx: 0.013, yy: 0.013, zz: 0.012, xy: 0.001, yz: -0.0004, xz: -0.0003 },
        },
        joint5: revolute {
            d: 0.17, theta: -0.2, a: 0.12, alpha: -0.7,
            mass: 0.8, com: [0.05, -0.05, 0.04],
            inertia: { xx: 0.014, yy: 0.016, zz: 0.008, xy: -0.0015, yz: -0.0008, xz: 0.0006 },
        },
        joint6: revolute {
            d: -0.09, theta: 0.1, a: 0.19, alpha: 0.4,
            mass: 2.1, com: [-0.04, 0.03, -0.03],
            inertia: { xx: 0.013, yy: 0.012, zz: 0.009, xy: 0.0005, yz: 0.0004, xz: -0.0009 },
        },
    ],
}

every_function! {
    /// Seven revolute joints, every cell non-zero.
    pub struct GenericChain7;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        joint1: revolute {
            d: 0.1, theta: 0.25, a: 0.17, alpha: -0.1,
            mass: 1.8, com: [0.09, -0.06, 0.08],
            inertia: { xx: 0.014, yy: 0.018, zz: 0.014, xy: -0.001, yz: -0.0008, xz: -0.0006 },
        },
        joint2: revolute {
            d: -0.15, theta: 0.3, a: 0.13, alpha: 1,
            mass: 3.1, com: [0.08, 0.04, -0.07],
            inertia: { xx: 0.013, yy: 0.014, zz: 0.015, xy: 0.0015, yz: -0.0004, xz: 0.0009 },
        },
        joint3: revolute {
            d: 0.07, theta: -0.1, a: 0.2, alpha: -0.4,
            mass: 1.3, com: [-0.07, 0.02, 0.06],
            inertia: { xx: 0.014, yy: 0.017, zz: 0.011, xy: -0.0005, yz: 0.0008, xz: -0.0012 },
        },
        joint4: revolute {
            d: -0.12, theta: 0.2, a: 0.16, alpha: 0.7,
            mass: 2.6, com: [0.06, -0.07, -0.05],
            inertia: { xx: 0.013, yy: 0.013, zz: 0.012, xy: 0.001, yz: -0.0004, xz: -0.0003 },
        },
        joint5: revolute {
            d: 0.17, theta: -0.2, a: 0.12, alpha: -0.7,
            mass: 0.8, com: [0.05, -0.05, 0.04],
            inertia: { xx: 0.014, yy: 0.016, zz: 0.008, xy: -0.0015, yz: -0.0008, xz: 0.0006 },
        },
        joint6: revolute {
            d: -0.09, theta: 0.1, a: 0.19, alpha: 0.4,
            mass: 2.1, com: [-0.04, 0.03, -0.03],
            inertia: { xx: 0.013, yy: 0.012, zz: 0.009, xy: 0.0005, yz: 0.0004, xz: -0.0009 },
        },
        joint7: revolute {
            d: 0.14, theta: -0.3, a: 0.15, alpha: -1,
            mass: 3.4, com: [0.03, 0.01, 0.02],
            inertia: { xx: 0.012, yy: 0.014, zz: 0.016, xy: -0.001, yz: -0.0008, xz: -0.0012 },
        },
    ],
}

every_function! {
    /// RPRRPR with motors, gears, friction and oblique gravity.
    pub struct GenericMixed6;

    convention: standard,
    gravity: [1.2, -3.4, -9.1],
    joints: [
        joint1: revolute {
            d: 0.1, theta: 0.25, a: 0.17, alpha: -0.1,
            mass: 1.8, com: [0.09, -0.06, 0.08],
            inertia: { xx: 0.014, yy: 0.018, zz: 0.014, xy: -0.001, yz: -0.0008, xz: -0.0006 },
            motor: { inertia: 0.0002, gear_ratio: 30 },
            friction: { viscous: 0.2, coulomb: 0.1 },
        },
        joint2: prismatic {
            d: -0.15, theta: 0.3, a: 0.13, alpha: 1,
            mass: 3.1, com: [0.08, 0.04, -0.07],
            inertia: { xx: 0.013, yy: 0.014, zz: 0.015, xy: 0.0015, yz: -0.0004, xz: 0.0009 },
            motor: { inertia: 0.0003, gear_ratio: 40 },
            friction: { viscous: 0.3, coulomb: 0.15 },
        },
        joint3: revolute {
            d: 0.07, theta: -0.1, a: 0.2, alpha: -0.4,
            mass: 1.3, com: [-0.07, 0.02, 0.06],
            inertia: { xx: 0.014, yy: 0.017, zz: 0.011, xy: -0.0005, yz: 0.0008, xz: -0.0012 },
            motor: { inertia: 0.0001, gear_ratio: 50 },
            friction: { viscous: 0.4, coulomb: 0.2 },
        },
        joint4: revolute {
            d: -0.12, theta: 0.2, a: 0.16, alpha: 0.7,
            mass: 2.6, com: [0.06, -0.07, -0.05],
            inertia: { xx: 0.013, yy: 0.013, zz: 0.012, xy: 0.001, yz: -0.0004, xz: -0.0003 },
            motor: { inertia: 0.0002, gear_ratio: 60 },
            friction: { viscous: 0.1, coulomb: 0.25 },
        },
        joint5: prismatic {
            d: 0.17, theta: -0.2, a: 0.12, alpha: -0.7,
            mass: 0.8, com: [0.05, -0.05, 0.04],
            inertia: { xx: 0.014, yy: 0.016, zz: 0.008, xy: -0.0015, yz: -0.0008, xz: 0.0006 },
            motor: { inertia: 0.0003, gear_ratio: 20 },
            friction: { viscous: 0.2, coulomb: 0.3 },
        },
        joint6: revolute {
            d: -0.09, theta: 0.1, a: 0.19, alpha: 0.4,
            mass: 2.1, com: [-0.04, 0.03, -0.03],
            inertia: { xx: 0.013, yy: 0.012, zz: 0.009, xy: 0.0005, yz: 0.0004, xz: -0.0009 },
            motor: { inertia: 0.0001, gear_ratio: 30 },
            friction: { viscous: 0.3, coulomb: 0.05 },
        },
    ],
}

every_function! {
    /// The same rows read as modified ones: another arm, without reference values.
    pub struct GenericMixed6Modified;

    convention: modified,
    gravity: [1.2, -3.4, -9.1],
    joints: [
        joint1: revolute {
            d: 0.1, theta: 0.25, a: 0.17, alpha: -0.1,
            mass: 1.8, com: [0.09, -0.06, 0.08],
            inertia: { xx: 0.014, yy: 0.018, zz: 0.014, xy: -0.001, yz: -0.0008, xz: -0.0006 },
            motor: { inertia: 0.0002, gear_ratio: 30 },
            friction: { viscous: 0.2, coulomb: 0.1 },
        },
        joint2: prismatic {
            d: -0.15, theta: 0.3, a: 0.13, alpha: 1,
            mass: 3.1, com: [0.08, 0.04, -0.07],
            inertia: { xx: 0.013, yy: 0.014, zz: 0.015, xy: 0.0015, yz: -0.0004, xz: 0.0009 },
            motor: { inertia: 0.0003, gear_ratio: 40 },
            friction: { viscous: 0.3, coulomb: 0.15 },
        },
        joint3: revolute {
            d: 0.07, theta: -0.1, a: 0.2, alpha: -0.4,
            mass: 1.3, com: [-0.07, 0.02, 0.06],
            inertia: { xx: 0.014, yy: 0.017, zz: 0.011, xy: -0.0005, yz: 0.0008, xz: -0.0012 },
            motor: { inertia: 0.0001, gear_ratio: 50 },
            friction: { viscous: 0.4, coulomb: 0.2 },
        },
        joint4: revolute {
            d: -0.12, theta: 0.2, a: 0.16, alpha: 0.7,
            mass: 2.6, com: [0.06, -0.07, -0.05],
            inertia: { xx: 0.013, yy: 0.013, zz: 0.012, xy: 0.001, yz: -0.0004, xz: -0.0003 },
            motor: { inertia: 0.0002, gear_ratio: 60 },
            friction: { viscous: 0.1, coulomb: 0.25 },
        },
        joint5: prismatic {
            d: 0.17, theta: -0.2, a: 0.12, alpha: -0.7,
            mass: 0.8, com: [0.05, -0.05, 0.04],
            inertia: { xx: 0.014, yy: 0.016, zz: 0.008, xy: -0.0015, yz: -0.0008, xz: 0.0006 },
            motor: { inertia: 0.0003, gear_ratio: 20 },
            friction: { viscous: 0.2, coulomb: 0.3 },
        },
        joint6: revolute {
            d: -0.09, theta: 0.1, a: 0.19, alpha: 0.4,
            mass: 2.1, com: [-0.04, 0.03, -0.03],
            inertia: { xx: 0.013, yy: 0.012, zz: 0.009, xy: 0.0005, yz: 0.0004, xz: -0.0009 },
            motor: { inertia: 0.0001, gear_ratio: 30 },
            friction: { viscous: 0.3, coulomb: 0.05 },
        },
    ],
}
