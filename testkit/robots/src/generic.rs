//! Arms in which nothing is zero, so that no simplification can hide a wrong term.

/// Chains each of which has the rows of those before it and some more, with the functions that a macro names, some by a
/// feature alone.
macro_rules! generic_chains {
    ([$($row:tt)*]) => {};
    (
        [$($row:tt)*]
        $(#[$documentation:meta])* $name:ident, $functions:ident $(, feature $feature:literal)?: [$($more:tt)*]
        $($rest:tt)*
    ) => {
        $(#[cfg(feature = $feature)])?
        $functions! {
            $(#[$documentation])*
            pub struct $name;

            convention: standard,
            gravity: [0, 0, -9.81],
            joints: [$($row)* $($more)*],
        }

        generic_chains! { [$($row)* $($more)*] $($rest)* }
    };
}

generic_chains! {
    []
    /// One revolute joint, every cell non-zero.
    GenericChain1, every_function: [
        joint1: revolute {
            d: 0.1, theta: 0.25, a: 0.17, alpha: -0.1,
            mass: 1.8, com: [0.09, -0.06, 0.08],
            inertia: { xx: 0.014, yy: 0.018, zz: 0.014, xy: -0.001, yz: -0.0008, xz: -0.0006 },
        },
    ]
    /// Two revolute joints, every cell non-zero.
    GenericChain2, every_function: [
        joint2: revolute {
            d: -0.15, theta: 0.3, a: 0.13, alpha: 1,
            mass: 3.1, com: [0.08, 0.04, -0.07],
            inertia: { xx: 0.013, yy: 0.014, zz: 0.015, xy: 0.0015, yz: -0.0004, xz: 0.0009 },
        },
    ]
    /// Three revolute joints, every cell non-zero.
    GenericChain3, every_function: [
        joint3: revolute {
            d: 0.07, theta: -0.1, a: 0.2, alpha: -0.4,
            mass: 1.3, com: [-0.07, 0.02, 0.06],
            inertia: { xx: 0.014, yy: 0.017, zz: 0.011, xy: -0.0005, yz: 0.0008, xz: -0.0012 },
        },
    ]
    /// Four revolute joints, every cell non-zero.
    GenericChain4, every_function: [
        joint4: revolute {
            d: -0.12, theta: 0.2, a: 0.16, alpha: 0.7,
            mass: 2.6, com: [0.06, -0.07, -0.05],
            inertia: { xx: 0.013, yy: 0.013, zz: 0.012, xy: 0.001, yz: -0.0004, xz: -0.0003 },
        },
    ]
    /// Six revolute joints, every cell non-zero.
    GenericChain6, every_function_of_a_long_arm: [
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
    ]
    /// Seven revolute joints, every cell non-zero.
    GenericChain7, every_function_of_a_long_arm: [
        joint7: revolute {
            d: 0.14, theta: -0.3, a: 0.15, alpha: -1,
            mass: 3.4, com: [0.03, 0.01, 0.02],
            inertia: { xx: 0.012, yy: 0.014, zz: 0.016, xy: -0.001, yz: -0.0008, xz: -0.0012 },
        },
    ]
    /// Ten revolute joints, every cell non-zero.
    GenericChain10, every_function_of_a_long_arm, feature "long_arms": [
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
    ]
    /// Twelve revolute joints, every cell non-zero.
    GenericChain12, every_function_of_a_long_arm, feature "long_arms": [
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
    ]
}

/// RPRRPR with motors, gears, friction and oblique gravity, its rows read by a convention.
macro_rules! generic_mixed {
    ($(#[$documentation:meta])* $name:ident, $convention:ident) => {
        every_function_of_a_long_arm! {
            $(#[$documentation])*
            pub struct $name;

            convention: $convention,
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
    };
}

generic_mixed! {
    /// RPRRPR with motors, gears, friction and oblique gravity.
    GenericMixed6, standard
}

generic_mixed! {
    /// The same rows read as modified ones: another arm, without reference values.
    GenericMixed6Modified, modified
}
