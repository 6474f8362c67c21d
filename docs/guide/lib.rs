//! The arm that several chapters of the guide are about, expanded once, and the chapters: `cargo test -p guide` compiles
//! and runs their code.
#![forbid(unsafe_code)]

use robot_dynamics::robot_dynamics;

robot_dynamics! {
    /// An elbow arm that carries `load` at its tool: the table of the chapter *Tool and load*.
    pub struct Arm {
        /// The mass of what is carried, kg.
        pub load: f64,
    }

    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute { d: 0.4, mass: 8, com: [0, 0.02, -0.1], inertia: cylinder(0.1, 0.4) },
        shoulder: revolute {
            alpha: PI/2, mass: 5, com: [0.22, 0, 0.05], inertia: rod(0.45),
            motor: { inertia: 1e-4, gear_ratio: 100 },
        },
        elbow: revolute {
            a: 0.45, mass: 2, com: [0.18, 0, 0], inertia: rod(0.4),
            motor: { inertia: 1e-4, gear_ratio: 80 },
        },
    ],
    tool: { xyz: [0.4, 0, 0], mass: load, com: [0, 0, 0.05], inertia: sphere(0.04) },
    functions: [
        default, forward_kinematics, jacobian, regressor, base_parameters,
        control_terms = (mass_matrix, coriolis_vector, gravity_vector),
        hand_terms = (forward_kinematics, jacobian, gravity_vector),
    ],
}

/// Each chapter, read by rustdoc where it looks for tests, and nowhere else.
macro_rules! chapters {
    ($($name:ident)*) => {$(
        #[cfg(doctest)]
        #[doc = include_str!(concat!("src/", stringify!($name), ".md"))]
        mod $name {}
    )*};
}

chapters! {
    about five_minutes own_urdf conventions urdf trees moving_base tool_and_load closed_forms reaching control identification embedded
    many_states integration scene rounding generated_code languages limits other_tools
}
