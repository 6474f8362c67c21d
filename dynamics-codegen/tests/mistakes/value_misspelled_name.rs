robot_dynamics! {
    pub struct Arm { mass1: f64, length: f64 }
    let half = length / 2;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [joint: revolute { a: lenght, alpha: pi, mass: mass2, com: [hlaf, self.length, 0] }],
}
