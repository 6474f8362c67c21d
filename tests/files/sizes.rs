//! Generated robots of more followers and frames than are built into a table.

use robot_dynamics::{check_against_rnea, robot_dynamics};

/// A hand of these fingers, which all follow its grip, with a body in each of these frames.
macro_rules! hand {
    ($($finger:ident)*; $($frame:ident)*) => {
        robot_dynamics! {
            struct Hand { size: f64 }

            convention: modified,
            gravity: [0, 0, -9.81],
            joints: [
                wrist: revolute { mass: 1, com: [0.01, 0.02, 0.05], inertia: sphere(0.05) },
                grip: revolute { a: 0.1, alpha: 0.4, mass: 0.3, com: [0.02, 0.01, 0], inertia: sphere(0.02) },
                $($finger: revolute {
                    on: wrist, at: { xyz: [size, 0.02, 0], rpy: [0.3, 0, 0] },
                    mass: 0.1, com: [0.02, 0.01, 0], inertia: sphere(0.01),
                },)*
            ],
            couple: [$($finger = 0.5 * grip + 0.1),*],
            frames: { $($frame: { on: grip, xyz: [0, size, 0.1], mass: 0.01 }),* },
            functions: [default, jacobian(last), center_of_mass],
        }
    };
}

hand! {
    f0 f1 f2 f3 f4 f5 f6 f7 f8;
    p0 p1 p2 p3 p4 p5 p6 p7 p8 p9 p10 p11 p12 p13 p14 p15 p16 last
}

#[test]
fn fingers_and_frames_without_number() {
    let hand = Hand { size: 0.1 };
    let table = hand.table();
    assert_eq!((table.followers.len(), table.frames.len()), (9, 18));
    check_against_rnea(&hand).assert_ok();
}
