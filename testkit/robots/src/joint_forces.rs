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
            friction: { viscous: 2.5, coulomb: { positive: 1.5, negative: 1.2 } },
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

robot_dynamics::robot_dynamics! {
    /// Two joints whose static friction falls to Coulomb's, which differs by direction. It has every
    /// function but the Taylor series.
    pub struct StickyArm;

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute {
            a: 0.4, mass: 2, com: [-0.2, 0.01, 0],
            inertia: { xx: 0.01, yy: 0.03, zz: 0.035, xy: 0.002 },
            friction: {
                viscous: 0.3,
                coulomb: { positive: 0.7, negative: 0.5 },
                stribeck: { static: 1.1, velocity: 1.5 },
            },
        },
        elbow: revolute {
            a: 0.3, mass: 1.2, com: [-0.15, 0, 0.02], inertia: cuboid(0.3, 0.05, 0.06),
            spring: { stiffness: 2.5 },
            friction: { coulomb: 0.2, stribeck: { static: 0.35, velocity: 0.8 } },
        },
    ],
    functions: [
        mass_matrix, coriolis_vector, gravity_vector, friction_vector, spring_vector,
        inverse_dynamics, forward_dynamics, kinetic_energy, potential_energy, bias_force,
        coriolis_matrix, coriolis_coefficients, centrifugal_coefficients, forward_kinematics,
        link_poses, jacobian, inverse_dynamics_derivatives, forward_dynamics_derivatives, regressor,
        base_parameters, forward_dynamics_aba, inverse_dynamics_second_derivatives,
    ],
}
