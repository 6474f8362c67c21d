//! The rules of each library. Their sources are cited above, in the documentation of `layouts`.

mod sealed {
    pub trait Sealed {}
}

/// A library with a layout of its own. It is sealed: the libraries are those of [`layouts`](crate::layouts).
pub trait Library: sealed::Sealed {
    /// Whether the angular velocity comes before the linear one.
    #[doc(hidden)]
    const ANGULAR_FIRST: bool;
    /// Whether the linear velocity is in the axes of the world.
    #[doc(hidden)]
    const LINEAR_IN_WORLD: bool;
    /// Whether the angular velocity is in the axes of the world.
    #[doc(hidden)]
    const ANGULAR_IN_WORLD: bool;
    /// Where x, y, z of the base begin in q.
    #[doc(hidden)]
    const ORIGIN: usize;
    /// Where the joints begin in q.
    #[doc(hidden)]
    const FIRST_JOINT: usize;

    /// Where w, x, y, z of the quaternion are in the q of a robot with so many joints.
    #[doc(hidden)]
    fn quaternion(joints: usize) -> [usize; 4];
}

macro_rules! libraries {
    ($($(#[$about:meta])* $name:ident {
        angular_first: $angular_first:literal, in_world: [$linear:literal, $angular:literal],
        origin: $origin:literal, joints: $first:literal, quaternion: |$n:ident| $quaternion:expr,
    })*) => {$(
        $(#[$about])*
        #[derive(Debug)]
        pub enum $name {}

        impl sealed::Sealed for $name {}

        impl Library for $name {
            const ANGULAR_FIRST: bool = $angular_first;
            const LINEAR_IN_WORLD: bool = $linear;
            const ANGULAR_IN_WORLD: bool = $angular;
            const ORIGIN: usize = $origin;
            const FIRST_JOINT: usize = $first;

            fn quaternion($n: usize) -> [usize; 4] {
                $quaternion
            }
        }
    )*};
}

libraries! {
    /// q = x y z, quaternion x y z w, joints; v = linear, angular in the axes of the base.
    PinocchioRules {
        angular_first: false, in_world: [false, false],
        origin: 0, joints: 7, quaternion: |_n| [6, 3, 4, 5],
    }

    /// qpos = x y z, quaternion w x y z, joints; qvel = linear in the world, angular in the axes of the body.
    MuJoCoRules {
        angular_first: false, in_world: [true, false],
        origin: 0, joints: 7, quaternion: |_n| [3, 4, 5, 6],
    }

    /// q = quaternion w x y z, x y z, joints; v = angular, linear in the world.
    DrakeRules {
        angular_first: true, in_world: [true, true],
        origin: 4, joints: 7, quaternion: |_n| [0, 1, 2, 3],
    }

    /// q = x y z, quaternion x y z, joints, quaternion w; qdot = linear in the world, angular in the axes of the body.
    RbdlRules {
        angular_first: false, in_world: [true, false],
        origin: 0, joints: 6, quaternion: |n| [n + 6, 3, 4, 5],
    }
}
