robot_dynamics! {
    pub struct Torso;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute { on: bsae, mass: 9 },
        left_shoulder: revolute { on: wiast, mass: 2 },
        left_elbow: revolute { on: left_elbow, mass: 1 },
        right_shoulder: revolute { on: right_elbow, mass: 2 },
        right_elbow: revolute { on: hand, mass: 1 },
        neck: revolute { on: tail, mass: 1 },
        head: revolute { on: 3, mass: 1 },
        hat: revolute { on: left_elbow + 1, mass: 1 },
        brim: revolute { on: , mass: 1 },
        plume: revolute { on: { joint: hat }, mass: 1 },
    ],
    frames: { hand: { on: right_elbow, mass: 1 } },
}

// Mistakes that follow from a row that cannot be read are not reported.
robot_dynamics! {
    pub struct Torso;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        : revolute { mass: 9 },
        left_shoulder: revolute { on: waist, mass: 2 },
    ],
}

robot_dynamics! {
    pub struct Torso;
    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        base: revolute { mass: 9 },
        left_shoulder: revolute { on: base, mass: 2 },
    ],
}
