//! The PUMA 560 and the Panda, whole and with pieces left out.

use robot_dynamics::robot_dynamics;

/// The PUMA 560 of the Robotics Toolbox. Pieces that are multiplied by 0 are left out: gravity,
/// friction, motors. The entries behind are the table's own.
macro_rules! puma {
    (
        $(#[$documentation:meta])* $name:ident, gravity: $g:literal, friction: $f:literal,
        motors: $m:literal, $($entries:tt)*
    ) => {
        robot_dynamics! {
            $(#[$documentation])*
            pub struct $name;

            let g = $g;
            let f = $f;
            let m = $m;
            convention: standard,
            gravity: [0, 0, -9.81 * g],
            joints: [
                waist: revolute {
                    d: 0.67183, alpha: PI/2,
                    inertia: { yy: 0.35 },
                    allow: [unphysical_inertia],
                    motor: { inertia: 0.0002 * m, gear_ratio: -62.6111 },
                    friction: { viscous: 5.80182176795 * f, coulomb: 25.9836065 * f },
                },
                shoulder: revolute {
                    a: 0.4318,
                    mass: 17.4, com: [-0.3638, 0.006, 0.2275],
                    inertia: { xx: 0.13, yy: 0.524, zz: 0.539 },
                    motor: { inertia: 0.0002 * m, gear_ratio: 107.815 },
                    friction: { viscous: 9.49686864183 * f, coulomb: 10.6197775 * f },
                },
                elbow: revolute {
                    d: 0.15005, a: 0.0203, alpha: -PI/2,
                    mass: 4.8, com: [-0.0203, -0.0141, 0.07],
                    inertia: { xx: 0.066, yy: 0.086, zz: 0.0125 },
                    allow: [unphysical_inertia],
                    motor: { inertia: 0.0002 * m, gear_ratio: -53.7063 },
                    friction: { viscous: 3.98042599037 * f, coulomb: 6.36419655 * f },
                },
                wrist_roll: revolute {
                    d: 0.4318, alpha: PI/2,
                    mass: 0.82, com: [0, 0.019, 0],
                    inertia: { xx: 0.0018, yy: 0.0013, zz: 0.0018 },
                    motor: { inertia: 3.3e-5 * m, gear_ratio: 76.0364 },
                    friction: { viscous: 0.411645229697 * f, coulomb: 1.06831142 * f },
                },
                wrist_pitch: revolute {
                    alpha: -PI/2,
                    mass: 0.34,
                    inertia: { xx: 0.0003, yy: 0.0004, zz: 0.0003 },
                    motor: { inertia: 3.3e-5 * m, gear_ratio: 71.923 },
                    friction: { viscous: 0.427283020935 * f, coulomb: 0.85444524 * f },
                },
                flange: revolute {
                    mass: 0.09, com: [0, 0, 0.032],
                    inertia: { xx: 0.00015, yy: 0.00015, zz: 4e-5 },
                    motor: { inertia: 3.3e-5 * m, gear_ratio: 76.686 },
                    friction: { viscous: 0.215823253273 * f, coulomb: 0.55443978 * f },
                },
            ],
            functions: [
                mass_matrix, coriolis_vector, gravity_vector, friction_vector, inverse_dynamics,
                forward_dynamics, forward_dynamics_aba, kinetic_energy, potential_energy,
            ],
            $($entries)*
        }
    };
}

/// The Panda as Gaz and others (2019) identified it, its products of inertia times a factor.
macro_rules! panda {
    ($(#[$documentation:meta])* $name:ident, products: $p:literal, $($entries:tt)*) => {
        robot_dynamics! {
            $(#[$documentation])*
            pub struct $name;

            let p = $p;
            convention: modified,
            gravity: [0, 0, -9.81],
            joints: [
                joint1: revolute {
                    d: 0.333,
                    mass: 4.970684, com: [0.003875, 0.002081, -0.04762],
                    inertia: {
                        xx: 0.70337, yy: 0.70661, zz: 0.009117,
                        xy: -0.000139 * p, yz: 0.019169 * p, xz: 0.006772 * p,
                    },
                },
                joint2: revolute {
                    alpha: -PI/2,
                    mass: 0.646926, com: [-0.003141, -0.02872, 0.003495],
                    inertia: {
                        xx: 0.007962, yy: 0.02811, zz: 0.025995,
                        xy: -0.003925 * p, yz: 0.000704 * p, xz: 0.010254 * p,
                    },
                },
                joint3: revolute {
                    alpha: PI/2, d: 0.316,
                    mass: 3.228604, com: [0.027518, 0.039252, -0.066502],
                    inertia: {
                        xx: 0.037242, yy: 0.036155, zz: 0.01083,
                        xy: -0.004761 * p, yz: -0.012805 * p, xz: -0.011396 * p,
                    },
                },
                joint4: revolute {
                    a: 0.0825, alpha: PI/2,
                    mass: 3.587895, com: [-0.05317, 0.104419, 0.027454],
                    inertia: {
                        xx: 0.025853, yy: 0.019552, zz: 0.028323,
                        xy: 0.007796 * p, yz: 0.008641 * p, xz: -0.001332 * p,
                    },
                },
                joint5: revolute {
                    a: -0.0825, alpha: -PI/2, d: 0.384,
                    mass: 1.225946, com: [-0.011953, 0.041065, -0.038437],
                    inertia: {
                        xx: 0.035549, yy: 0.029474, zz: 0.008627,
                        xy: -0.002117 * p, yz: 0.000229 * p, xz: -0.004037 * p,
                    },
                },
                joint6: revolute {
                    alpha: PI/2,
                    mass: 1.666555, com: [0.060149, -0.014117, -0.010517],
                    inertia: {
                        xx: 0.001964, yy: 0.004354, zz: 0.005433,
                        xy: 0.000109 * p, yz: 0.000341 * p, xz: -0.001158 * p,
                    },
                },
                joint7: revolute {
                    a: 0.088, alpha: PI/2, d: 0.107,
                    mass: 0.735522, com: [0.010517, -0.004252, -0.045403],
                    inertia: {
                        xx: 0.012516, yy: 0.010027, zz: 0.004815,
                        xy: -0.000428 * p, yz: -0.000741 * p, xz: -0.001196 * p,
                    },
                },
            ],
            functions: [
                mass_matrix, coriolis_vector, gravity_vector, inverse_dynamics, forward_dynamics,
            ],
            $($entries)*
        }
    };
}

puma! {
    /// Everything.
    Puma, gravity: 1, friction: 1, motors: 1,
}

puma! {
    /// The three joints of the wrist stand still.
    PumaWithoutWrist, gravity: 1, friction: 1, motors: 1,
    lock: [wrist_roll = 0, wrist_pitch = 0, flange = 0],
}

puma! {
    /// Abbreviated at a thousandth.
    PumaAtTenthPercent, gravity: 1, friction: 1, motors: 1, neglect: 0.1%,
}

puma! {
    /// Abbreviated at a hundredth.
    PumaAtOnePercent, gravity: 1, friction: 1, motors: 1, neglect: 1%,
}

puma! {
    /// Abbreviated at a twentieth.
    PumaAtFivePercent, gravity: 1, friction: 1, motors: 1, neglect: 5%,
}

puma! {
    /// In free space.
    PumaWithoutGravity, gravity: 0, friction: 1, motors: 1,
}

puma! {
    /// On ideal bearings.
    PumaWithoutFriction, gravity: 1, friction: 0, motors: 1,
}

puma! {
    /// Rotors without inertia.
    PumaWithoutMotors, gravity: 1, friction: 1, motors: 0,
}

panda! {
    /// Everything.
    Panda, products: 1,
}

panda! {
    /// Links whose axes of inertia are those of their frames.
    PandaWithoutProducts, products: 0,
}

panda! {
    /// Abbreviated at a hundredth.
    PandaAtOnePercent, products: 1, neglect: 1%,
}
