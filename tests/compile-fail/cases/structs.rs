//! An item that is no struct, structs that no robot can have, and fields that cannot be.

use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Generic<T> { m: T }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: m }],
}

robot_dynamics! {
    pub Wordless;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: 1 }],
}

robot_dynamics! {
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: 1, masss: 2 }],
}

robot_dynamics! {
    pub struct Tuple(f64, f64);
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: 1 }],
}

robot_dynamics! {
    pub struct Twice { m: f64, m: f64, PI: f64 }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: m }],
}

fn main() {
    {
        let arm = Generic { m: 1.0 };
        let _ = arm.mass_matrix(&robot_dynamics::nalgebra::SVector::<f64, 1>::zeros());
    }
    {
        let q = robot_dynamics::nalgebra::SVector::<f64, 1>::zeros();
        let _ = Wordless.mass_matrix(&q);
    }
    {
        let arm = Tuple(1.0, 2.0);
        let _ = arm.mass_matrix(&robot_dynamics::nalgebra::SVector::<f64, 1>::zeros());
    }
}
