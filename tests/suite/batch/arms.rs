//! Arms beside the industrial ones.

use robot_dynamics::robot_dynamics;

robot_dynamics! {
    /// Joints of both kinds, friction, and fields in every kind of cell.
    pub(crate) struct Fields { mass: f64, length: f64, twist: f64, coulomb: f64, g: f64 }

    convention: modified,
    gravity: [0, g, -g],
    joints: [
        slider: prismatic { alpha: twist, mass: 2, friction: { viscous: 0.5, coulomb: coulomb } },
        swing: revolute {
            a: length, alpha: PI/2, theta: 0.25, mass: mass, com: [0.1, length, -0.2],
            inertia: cuboid(0.3, 0.2, 0.4), friction: { viscous: 0.1, coulomb: 0.7 },
        },
    ],
}

pub(crate) const FIELDS: Fields = Fields {
    mass: 1.25,
    length: 0.4,
    twist: -0.6,
    coulomb: 0.3,
    g: 9.81,
};

robot_dynamics! {
    /// A point mass on a strut of two bars without mass: stretched, it has no inertia along itself.
    pub(crate) struct Strut;

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 1 },
        elbow: revolute { a: 1, mass: 1 },
    ],
}
