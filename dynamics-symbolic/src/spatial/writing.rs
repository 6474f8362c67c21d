//! The ways to write the equations of one link: its acceleration and its force are the same in all of them, the number
//! of operations is not.
//!
//! The axis of a joint. A joint's axis is fixed in both of its links, so that its second derivative, U times the axis,
//! is one vector, whatever the joint does. In the axes of the link that is the third column of its own U, of which
//! x z + yd and y z - xd are the first two entries. If it is turned in place of wd, then wd takes a subtraction an entry
//! and no products, and the third entry, -(x^2 + y^2), is known from the link before. It is a column of U there as well
//! if the joint's axis is along a coordinate axis of the frame before.
//!
//! Laminae. A revolute joint does not tell how mass is spread along its axis: the link may have all of it in the plane
//! z = 0. Then J_zz = J_xx + J_yy (the perpendicular-axis theorem), and two components of J wd + w x (J w) take one
//! product in place of two: J_xx xd + (J_zz - J_yy) y z = J_xx (xd + y z).

use super::{Acceleration, Body, Force, Joint};
use crate::linear::{Ring, Symmetric3, Vector3};
use core::ops::Neg;

/// How the equations of a link are written.
#[derive(Clone, Copy, Debug)]
pub struct Writing {
    /// The axis of the frame before about which the link turns, if U times that axis is turned in place of wd.
    pub along: Option<Along>,
    /// How the link's mass is spread.
    pub spread: Spread,
}

/// How the mass of a link is spread.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spread {
    /// Anyhow.
    Body,
    /// J_zz is J_xx + J_yy.
    Lamina,
    /// As a lamina that turns in the link's frame, so that J_xx and J_yy are variable.
    TurningLamina,
}

/// A coordinate axis of a frame, in one of its two senses.
#[derive(Clone, Copy, Debug)]
pub struct Along {
    /// The number of the axis.
    pub axis: usize,
    /// Whether against it.
    pub is_opposite: bool,
}

impl Along {
    /// A quantity that belongs to the frame's axis, for the sense of this one.
    pub fn signed<T: Neg<Output = T>>(self, x: T) -> T {
        if self.is_opposite { -x } else { x }
    }
}

impl Writing {
    /// As a body whose angular acceleration is turned.
    pub const PLAIN: Writing = Writing {
        along: None,
        spread: Spread::Body,
    };

    /// The acceleration of the link that the joint carries and moves, on one that is accelerated so.
    pub fn accelerate<R: Ring>(
        self,
        before: &Acceleration<R>,
        joint: &Joint<R>,
        [qd, qdd]: [R; 2],
    ) -> Acceleration<R> {
        let Some(along) = self.along else {
            return before.enter(joint, qd, qdd);
        };
        let u = before.u();
        let a = joint.enter(before.a + u.apply(joint.position()));
        let column = joint.enter(along.signed(u.column(along.axis)));
        let w = joint.enter(before.w).plus_z(qd);
        Acceleration::of_column(column, w, along.signed(before.wd[along.axis]) + qdd, a)
    }

    /// The force that the link's body needs to be accelerated so.
    pub fn force<R: Ring>(self, acceleration: &Acceleration<R>, body: &Body<R>) -> Force<R> {
        let j = &body.inertia;
        let moments = match self.spread {
            Spread::Body => return acceleration.force(body),
            Spread::Lamina => acceleration.moments_of_lamina(j),
            Spread::TurningLamina => acceleration.moments_of_turning_lamina(j),
        };
        let squares = match self.along {
            Some(_) => acceleration.squares_by_u(),
            None => acceleration.squares(),
        };
        acceleration.force_by(body, moments, squares)
    }
}

impl<R: Ring> Acceleration<R> {
    /// The acceleration with this third column of U.
    pub fn of_column(column: Vector3<R>, w: Vector3<R>, zd: R, a: Vector3<R>) -> Self {
        let [x, y, z] = w.0;
        let wd = Vector3::new(y * z - column[1], column[0] - x * z, zd);
        Acceleration { w, wd, a }
    }

    /// [`Acceleration::squares`] where U_zz is known: two of them are differences of entries of U, so that no y^2 is
    /// computed.
    fn squares_by_u(&self) -> [R; 3] {
        let ([x, _, z], u) = (self.w.0, self.u().0);
        [u[1][1] - u[2][2], z * z - x * x, u[0][0] - u[1][1]]
    }

    fn moments_of_lamina(&self, j: &Symmetric3<R>) -> Vector3<R> {
        let ([x, y, z], [xd, yd, zd]) = (self.w.0, self.wd.0);
        let n_z = j.zz * zd + (j.yy - j.xx) * (x * y);
        Vector3::new(j.xx * (xd + y * z), j.yy * (yd - x * z), n_z)
    }

    /// Without the difference of J_xx and J_yy, which are variable.
    fn moments_of_turning_lamina(&self, j: &Symmetric3<R>) -> Vector3<R> {
        let ([x, y, z], [xd, yd, zd]) = (self.w.0, self.wd.0);
        let n_z = j.xx * (zd - x * y) + j.yy * (zd + x * y);
        Vector3::new(j.xx * (xd + y * z), j.yy * (yd - x * z), n_z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spatial::{Axis, AxisMotion, Turn, Turns};

    const LINK: Acceleration<i64> = Acceleration {
        w: Vector3([2, -3, 5]),
        wd: Vector3([7, 11, -13]),
        a: Vector3([-17, 19, 23]),
    };

    #[test]
    fn a_lamina_takes_the_force_of_a_body() {
        let mut inertia = Symmetric3::of_point(Vector3([31, -37, 0]), Vector3([2, 5, 0]));
        (inertia.xz, inertia.yz) = (61, -67);
        assert_eq!(inertia.zz, inertia.xx + inertia.yy);
        let body = Body {
            mass: 29,
            moment: Vector3([31, -37, 41]),
            inertia,
        };
        for spread in [Spread::Body, Spread::Lamina, Spread::TurningLamina] {
            for along in [None, Some(ALONG)] {
                let writing = Writing { along, spread };
                assert_eq!(writing.force(&LINK, &body), LINK.force(&body));
            }
        }
    }

    /// -y
    const ALONG: Along = Along {
        axis: 1,
        is_opposite: true,
    };

    #[test]
    fn an_axis_is_accelerated_alike_in_both_links() {
        let joint = Joint {
            zero: 0,
            axis_motion: AxisMotion::Turns,
            before: Turn { s: 0, c: 1 },
            twist: Turns(vec![(Axis::X, Turn { s: 1, c: 0 })]),
            turn: Turn { s: -1, c: 0 },
            offset: Vector3([3, 1, -4]),
            slide: 0,
        };
        assert_eq!(joint.leave(Vector3([0, 0, 1])), Vector3([0, -1, 0]));
        let writing = Writing {
            along: Some(ALONG),
            ..Writing::PLAIN
        };
        let by_column = writing.accelerate(&LINK, &joint, [6, 7]);
        let plain = LINK.enter(&joint, 6, 7);
        assert_eq!(by_column.w, plain.w);
        assert_eq!(by_column.wd, plain.wd);
        assert_eq!(by_column.a, plain.a);
    }
}
