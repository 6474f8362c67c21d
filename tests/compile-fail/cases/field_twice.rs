use robot_dynamics::robot_dynamics;

robot_dynamics! {
    pub struct Arm { m: f64, m: f64, PI: f64 }
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { mass: m }],
}

fn main() {}
