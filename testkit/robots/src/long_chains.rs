//! Ten and twelve revolute joints, every cell non-zero.

every_function! {
    /// Ten revolute joints, every cell non-zero.
    pub struct GenericChain10;

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
        joint8: revolute {
            d: -0.06, theta: 0.25, a: 0.11, alpha: 0.1,
            mass: 1.6, com: [0.02, -0.06, -0.01],
            inertia: { xx: 0.013, yy: 0.017, zz: 0.012, xy: 0.0015, yz: -0.0004, xz: 0.0003 },
        },
        joint9: revolute {
            d: 0.11, theta: 0.3, a: 0.18, alpha: 1.2,
            mass: 2.9, com: [-0.01, -0.04, 0.08],
            inertia: { xx: 0.012, yy: 0.013, zz: 0.013, xy: -0.0005, yz: 0.0008, xz: -0.0006 },
        },
        joint10: revolute {
            d: -0.16, theta: -0.1, a: 0.14, alpha: -0.2,
            mass: 1.1, com: [0.09, 0.02, -0.07],
            inertia: { xx: 0.013, yy: 0.016, zz: 0.009, xy: 0.001, yz: -0.0004, xz: -0.0009 },
        },
    ],
}

every_function! {
    /// Twelve revolute joints, every cell non-zero.
    pub struct GenericChain12;

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
        joint8: revolute {
            d: -0.06, theta: 0.25, a: 0.11, alpha: 0.1,
            mass: 1.6, com: [0.02, -0.06, -0.01],
            inertia: { xx: 0.013, yy: 0.017, zz: 0.012, xy: 0.0015, yz: -0.0004, xz: 0.0003 },
        },
        joint9: revolute {
            d: 0.11, theta: 0.3, a: 0.18, alpha: 1.2,
            mass: 2.9, com: [-0.01, -0.04, 0.08],
            inertia: { xx: 0.012, yy: 0.013, zz: 0.013, xy: -0.0005, yz: 0.0008, xz: -0.0006 },
        },
        joint10: revolute {
            d: -0.16, theta: -0.1, a: 0.14, alpha: -0.2,
            mass: 1.1, com: [0.09, 0.02, -0.07],
            inertia: { xx: 0.013, yy: 0.016, zz: 0.009, xy: 0.001, yz: -0.0004, xz: -0.0009 },
        },
        joint11: revolute {
            d: 0.08, theta: 0.2, a: 0.1, alpha: 0.9,
            mass: 2.4, com: [0.08, 0.07, 0.06],
            inertia: { xx: 0.012, yy: 0.012, zz: 0.01, xy: -0.0015, yz: -0.0008, xz: 0.0012 },
        },
        joint12: revolute {
            d: -0.13, theta: -0.2, a: 0.17, alpha: -0.5,
            mass: 0.6, com: [-0.07, -0.05, -0.05],
            inertia: { xx: 0.018, yy: 0.015, zz: 0.011, xy: 0.0005, yz: 0.0004, xz: -0.0003 },
        },
    ],
}
