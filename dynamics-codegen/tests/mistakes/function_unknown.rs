robot_dynamics! {
    pub struct Arm;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: 1 }],
    functions: [mass_matrx, lagrangian, operational_space_inertia, inverse_dynamics],
}

robot_dynamics! {
    pub struct Dog;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [hip: revolute { mass: 1 }],
    frames: { FL_foot: { on: hip } },
    functions: [
        jacobian_FL_foot, Jacobian_fl_foot, forward_kinematics_FL_foot, Mass_Matrix, massmatrix, gravityVector,
        MassMatrix, forwardKinematics(FL_foot), jacobian(fl_foot),
    ],
}
