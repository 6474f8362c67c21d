//! Arms with joints that follow others.

every_function! {
    /// A hand of two fingers, which move against each other, on a short arm. A hook between them turns with the
    /// fingers, by a rack: its angle is none of a joint's.
    pub struct GripperArm;

    convention: modified,
    gravity: [0.4, -1.1, -9.7],
    base: { xyz: [0.1, -0.2, 0.6], rpy: [0.2, -0.1, 0.4] },
    joints: [
        lift: prismatic {
            mass: 3, com: [0.05, -0.02, 0.1],
            inertia: { xx: 0.03, yy: 0.02, zz: 0.025, xy: 0.001, yz: -0.002, xz: 0.0015 },
            spring: { stiffness: 200, rest: 0.125 },
            friction: { viscous: 2.5, coulomb: { positive: 1.5, negative: 1.2 } },
        },
        turn: revolute {
            a: 0.3, alpha: 0.4, d: 0.1, theta: -0.2,
            mass: 1.4, com: [0.12, 0.03, -0.04],
            inertia: { xx: 0.011, yy: 0.016, zz: 0.013, xy: -0.001, yz: 0.0005, xz: 0.0007 },
            motor: { inertia: 0.0002, gear_ratio: 40 },
        },
        finger_1: prismatic {
            a: 0.2, alpha: PI/2, theta: 0.1,
            mass: 0.2, com: [0.05, 0.01, 0.02], inertia: { xx: 0.0004, yy: 0.0006, zz: 0.0005, xz: 0.0001 },
            motor: { inertia: 1e-6, gear_ratio: 400 },
            friction: { viscous: 3, coulomb: { positive: 0.3, negative: 0.2 } },
        },
        finger_2: prismatic {
            d: 0.03, mass: 0.15, com: [0.05, -0.01, -0.02], inertia: { xx: 0.0003, yy: 0.0005, zz: 0.0004, yz: 0.0001 },
            motor: { inertia: 1e-6, gear_ratio: 300 },
            spring: { stiffness: 50, rest: 0.0625 },
            friction: { viscous: 2, coulomb: 0.25 },
        },
        hook: revolute {
            a: 0.04, alpha: 0.3, mass: 0.1, com: [0.02, 0.005, 0.01], inertia: { xx: 2e-5, yy: 6e-5, zz: 5e-5 },
            friction: { viscous: 0.001, coulomb: 0.0005 },
        },
    ],
    couple: [finger_2 = -finger_1 + 0.0625, hook = 12.5 * finger_1 - 0.3],
}

/// The table of [`Palletiser`] without its couplings, handed to the macro `$then` between what stands in front of it
/// and behind it.
#[macro_export]
macro_rules! palletiser_table {
    ($then:ident { $($head:tt)* } { $($tail:tt)* }) => {
        $then! {
            $($head)*

            convention: standard,
            gravity: [0, 0, -9.81],
            joints: [
                waist: revolute {
                    d: 0.8, a: 0.1, alpha: PI/2, mass: 20, com: [0.02, -0.1, 0.03],
                    inertia: { xx: 0.8, yy: 0.9, zz: 0.7 },
                    friction: { viscous: 2, coulomb: 1 },
                },
                upper: revolute {
                    a: 0.7, mass: 12, com: [-0.3, 0.01, 0.05], inertia: { xx: 0.1, yy: 0.6, zz: 0.65, xy: 0.02 },
                    motor: { inertia: 1e-4, gear_ratio: 100 }, friction: { viscous: 3, coulomb: 2 },
                },
                level: revolute {
                    theta: -PI/2, a: 0.1, mass: 2, com: [-0.05, 0.01, 0.02], inertia: { xx: 0.01, yy: 0.02, zz: 0.02 },
                    friction: { viscous: 0.4, coulomb: { positive: 0.2, negative: 0.3 } },
                },
                fore: revolute {
                    a: 0.6, mass: 8, com: [-0.25, 0.02, -0.03], inertia: { xx: 0.05, yy: 0.3, zz: 0.32 },
                    friction: { viscous: 2, coulomb: 1.5 }, spring: { stiffness: 30, rest: -0.5 },
                },
                hand: revolute {
                    alpha: -PI/2, theta: 0.1, a: 0.08, mass: 4, com: [0.02, 0.01, -0.1],
                    inertia: { xx: 0.04, yy: 0.03, zz: 0.02 },
                    motor: { inertia: 2e-5, gear_ratio: 30 }, spring: { stiffness: 20, rest: 0.25 },
                },
            ],
            $($tail)*
        }
    };
}

palletiser_table! {
    every_function {
        /// A palletiser: parallelograms keep the elbow's frame and the hand level, whatever upper arm and forearm do.
        pub struct Palletiser;
    } {
        couple: [level = -upper + PI/2, hand = -fore - 0.25],
    }
}
