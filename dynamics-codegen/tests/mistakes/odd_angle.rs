robot_dynamics! {
    pub struct Arm;
    let twist = 90;
    let tilt = deg(PI/4);
    convention: modified,
    gravity: [0, 0, -9.81],
    base: { rpy: [0, 3.1416, 0] },
    joints: [
        waist: revolute { alpha: 1.5708, theta: 57, mass: 1 },
        shoulder: revolute { alpha: twist, theta: deg(1.5708), mass: 1 },
        elbow: revolute { alpha: -4.712, theta: deg(-400), mass: 1, allow: [odd_angle] },
        wrist: revolute { mass: 1 },
        slide: prismatic { theta: 1.57, mass: 1 },
    ],
    tool: { rpy: [0, 0, -1.5708] },
    lock: [wrist = 1.5708, slide = 1.5708],
}
