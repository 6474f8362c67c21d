robot_dynamics! {
    struct Motors;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        turn: revolute { motor: { inertia: 1e-4, gear_ratio: 50 } },
        slide: prismatic { motor: { inertia: 1e-4, gear_ratio: 50 } },
    ],
    functions: [mass_matrix, center_of_mass_jacobian],
}
