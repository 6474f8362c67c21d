//! Thirty axes with debug information: rustc crashes on functions of about 2,900 `let`s there
//! (rust-lang/rust#93908), which the generated functions avoid.
//!
//! This file is compiled in the profile of the tests, which is the dev profile with debug
//! information unless `cargo test --release` is asked for.

use robot_dynamics::{check::Check, robot_dynamics};

robot_dynamics! {
    /// Thirty revolute joints, every cell non-zero.
    struct Chain;

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
        joint13: revolute {
            d: 0.05, theta: 0.1, a: 0.13, alpha: 0.6,
            mass: 1.9, com: [0.06, -0.03, 0.04],
            inertia: { xx: 0.012, yy: 0.017, zz: 0.013, xy: -0.001, yz: -0.0008, xz: -0.0006 },
        },
        joint14: revolute {
            d: -0.1, theta: -0.3, a: 0.2, alpha: -0.8,
            mass: 3.2, com: [0.05, 0.01, -0.03],
            inertia: { xx: 0.011, yy: 0.013, zz: 0.014, xy: 0.0015, yz: -0.0004, xz: 0.0009 },
        },
        joint15: revolute {
            d: 0.15, theta: 0.25, a: 0.16, alpha: 0.3,
            mass: 1.4, com: [-0.04, 0.06, 0.02],
            inertia: { xx: 0.012, yy: 0.016, zz: 0.01, xy: -0.0005, yz: 0.0008, xz: -0.0012 },
        },
        joint16: revolute {
            d: -0.07, theta: 0.3, a: 0.12, alpha: -1.1,
            mass: 2.7, com: [0.03, -0.04, -0.01],
            inertia: { xx: 0.011, yy: 0.012, zz: 0.011, xy: 0.001, yz: -0.0004, xz: -0.0003 },
        },
        joint17: revolute {
            d: 0.12, theta: -0.1, a: 0.19, alpha: 0,
            mass: 0.9, com: [0.02, -0.02, 0.08],
            inertia: { xx: 0.017, yy: 0.015, zz: 0.012, xy: -0.0015, yz: -0.0008, xz: 0.0006 },
        },
        joint18: revolute {
            d: -0.17, theta: 0.2, a: 0.15, alpha: 1.1,
            mass: 2.2, com: [-0.01, 0.07, -0.07],
            inertia: { xx: 0.011, yy: 0.011, zz: 0.008, xy: 0.0005, yz: 0.0004, xz: -0.0009 },
        },
        joint19: revolute {
            d: 0.09, theta: -0.2, a: 0.11, alpha: -0.3,
            mass: 3.5, com: [0.09, 0.05, 0.06],
            inertia: { xx: 0.017, yy: 0.02, zz: 0.015, xy: -0.001, yz: -0.0008, xz: -0.0012 },
        },
        joint20: revolute {
            d: -0.14, theta: 0.1, a: 0.18, alpha: 0.8,
            mass: 1.7, com: [0.08, -0.03, -0.05],
            inertia: { xx: 0.011, yy: 0.016, zz: 0.011, xy: 0.0015, yz: -0.0004, xz: 0.0003 },
        },
        joint21: revolute {
            d: 0.06, theta: -0.3, a: 0.14, alpha: -0.6,
            mass: 3, com: [-0.07, -0.01, 0.04],
            inertia: { xx: 0.01, yy: 0.012, zz: 0.012, xy: -0.0005, yz: 0.0008, xz: -0.0006 },
        },
        joint22: revolute {
            d: -0.11, theta: 0.25, a: 0.1, alpha: 0.5,
            mass: 1.2, com: [0.06, 0.06, -0.03],
            inertia: { xx: 0.016, yy: 0.015, zz: 0.013, xy: 0.001, yz: -0.0004, xz: -0.0009 },
        },
        joint23: revolute {
            d: 0.16, theta: 0.3, a: 0.17, alpha: -0.9,
            mass: 2.5, com: [0.05, 0.04, 0.02],
            inertia: { xx: 0.01, yy: 0.011, zz: 0.009, xy: -0.0015, yz: -0.0008, xz: 0.0012 },
        },
        joint24: revolute {
            d: -0.08, theta: -0.1, a: 0.13, alpha: 0.2,
            mass: 0.7, com: [-0.04, -0.02, -0.01],
            inertia: { xx: 0.016, yy: 0.014, zz: 0.01, xy: 0.0005, yz: 0.0004, xz: -0.0003 },
        },
        joint25: revolute {
            d: 0.13, theta: 0.2, a: 0.2, alpha: -1.2,
            mass: 2, com: [0.03, -0.07, 0.08],
            inertia: { xx: 0.01, yy: 0.016, zz: 0.012, xy: -0.001, yz: -0.0008, xz: -0.0006 },
        },
        joint26: revolute {
            d: -0.05, theta: -0.2, a: 0.16, alpha: -0.1,
            mass: 3.3, com: [0.02, 0.05, -0.07],
            inertia: { xx: 0.016, yy: 0.019, zz: 0.013, xy: 0.0015, yz: -0.0004, xz: 0.0009 },
        },
        joint27: revolute {
            d: 0.1, theta: 0.1, a: 0.12, alpha: 1,
            mass: 1.5, com: [-0.01, 0.03, 0.06],
            inertia: { xx: 0.015, yy: 0.015, zz: 0.014, xy: -0.0005, yz: 0.0008, xz: -0.0012 },
        },
        joint28: revolute {
            d: -0.15, theta: -0.3, a: 0.19, alpha: -0.4,
            mass: 2.8, com: [0.09, -0.01, -0.05],
            inertia: { xx: 0.009, yy: 0.011, zz: 0.01, xy: 0.001, yz: -0.0004, xz: -0.0003 },
        },
        joint29: revolute {
            d: 0.07, theta: 0.25, a: 0.15, alpha: 0.7,
            mass: 1, com: [0.08, -0.06, 0.04],
            inertia: { xx: 0.015, yy: 0.014, zz: 0.011, xy: -0.0015, yz: -0.0008, xz: 0.0006 },
        },
        joint30: revolute {
            d: -0.12, theta: 0.3, a: 0.11, alpha: -0.7,
            mass: 2.3, com: [-0.07, 0.04, -0.03],
            inertia: { xx: 0.009, yy: 0.01, zz: 0.007, xy: 0.0005, yz: 0.0004, xz: -0.0009 },
        },
    ],
}

#[test]
fn thirty_axes_with_debug_information_agree_with_recursive_newton_euler() {
    assert_eq!(Chain::DOF, 30);
    Check::new().samples(10).run(&Chain).assert_ok();
}
