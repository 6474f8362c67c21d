robot_dynamics! {
    pub struct Arm { g: f64 }
    let m = 1;
    let m = 2;
    let g = 9.81;
    let PI = 3;
    let w: f64 = 3;
    let v = ;
    convention: standard,
    gravity: [0, 0, -g],
    joints: [joint: revolute { mass: m + w + v, a: late }],
    let late = 3;
}
