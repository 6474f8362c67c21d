use robot_dynamics::robot_dynamics;

robot_dynamics! {
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: 1, masss: 2 }],
}

fn main() {}
