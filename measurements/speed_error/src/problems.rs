//! The arms of the integrators' problems.

use robot_dynamics::robot_dynamics;

robot_dynamics! {
    /// The PUMA 560 with its motors and without friction.
    pub(crate) struct FreePuma;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute {
            d: 0.67183, alpha: PI/2,
            inertia: { yy: 0.35 },
            allow: [unphysical_inertia],
            motor: { inertia: 0.0002, gear_ratio: -62.6111 },
        },
        shoulder: revolute {
            a: 0.4318,
            mass: 17.4, com: [-0.3638, 0.006, 0.2275],
            inertia: { xx: 0.13, yy: 0.524, zz: 0.539 },
            motor: { inertia: 0.0002, gear_ratio: 107.815 },
        },
        elbow: revolute {
            d: 0.15005, a: 0.0203, alpha: -PI/2,
            mass: 4.8, com: [-0.0203, -0.0141, 0.07],
            inertia: { xx: 0.066, yy: 0.086, zz: 0.0125 },
            allow: [unphysical_inertia],
            motor: { inertia: 0.0002, gear_ratio: -53.7063 },
        },
        forearm: revolute {
            d: 0.4318, alpha: PI/2,
            mass: 0.82, com: [0, 0.019, 0],
            inertia: { xx: 0.0018, yy: 0.0013, zz: 0.0018 },
            motor: { inertia: 3.3e-5, gear_ratio: 76.0364 },
        },
        wrist: revolute {
            alpha: -PI/2,
            mass: 0.34,
            inertia: { xx: 0.0003, yy: 0.0004, zz: 0.0003 },
            motor: { inertia: 3.3e-5, gear_ratio: 71.923 },
        },
        flange: revolute {
            mass: 0.09, com: [0, 0, 0.032],
            inertia: { xx: 0.00015, yy: 0.00015, zz: 4e-5 },
            motor: { inertia: 3.3e-5, gear_ratio: 76.686 },
        },
    ],
    functions: [
        mass_matrix, inverse_dynamics, forward_dynamics, kinetic_energy, potential_energy,
        taylor_series,
    ],
}

robot_dynamics! {
    /// A rod of 12 kg in a joint of 10^4 N m s, and a wrist of 10^-6 kg m^2 in a joint of
    /// 10^-2 N m s: rates of 2,500 and 10,000 per second beside a motion of seconds.
    pub(crate) struct StiffArm;

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute {
            a: 1, mass: 12, com: [-0.5, 0, 0], inertia: rod(1),
            friction: { viscous: 10000 },
        },
        wrist: revolute {
            mass: 1e-3, com: [0.01, 0, 0],
            inertia: { xx: 1e-6, yy: 1e-6, zz: 1e-6 },
            friction: { viscous: 0.01 },
        },
    ],
    functions: [
        mass_matrix, inverse_dynamics, forward_dynamics, kinetic_energy, potential_energy,
        taylor_series,
    ],
}

robot_dynamics! {
    /// A slender rod that swings about its end; 0 is where it hangs.
    pub(crate) struct OneLink;

    convention: standard,
    gravity: [9.81, 0, 0],
    joints: [
        pivot: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) },
    ],
    functions: [
        mass_matrix, inverse_dynamics, forward_dynamics, kinetic_energy, potential_energy,
        taylor_series,
    ],
}

robot_dynamics! {
    /// Two slender rods, angles from the horizontal (Saha).
    pub(crate) struct TwoLinks;

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 2, mass: 3, com: [-1, 0, 0], inertia: rod(2) },
        elbow: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) },
    ],
    functions: [
        mass_matrix, inverse_dynamics, forward_dynamics, kinetic_energy, potential_energy,
        taylor_series,
    ],
}
