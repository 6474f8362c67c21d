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
        level: revolute { mass: 1 },
        wheel: revolute { mass: 1 },
        rack: prismatic { mass: 1 },
        hand: revolute { mass: 1, spring: { stiffness: 2, rest: 90 } },
        roller: revolute { mass: 1, spring: { stiffness: 2, rest: -12 * PI } },
    ],
    tool: { rpy: [0, 0, -1.5708] },
    couple: [level = -shoulder - 1.5708, wheel = 90 * shoulder + 45, rack = shoulder / 90 + 45],
    lock: [wrist = 1.5708, slide = 1.5708],
}
