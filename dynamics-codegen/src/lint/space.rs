//! Points in doubles: how large a link is does not need more.

/// A point or a direction, m.
pub(super) type Point = [f64; 3];

pub(super) fn norm([x, y, z]: Point) -> f64 {
    x.hypot(y).hypot(z)
}

/// A point of a frame at `xyz`, which is turned by roll, pitch and yaw about the fixed axes x, y and z.
pub(super) fn placed(xyz: Point, [roll, pitch, yaw]: Point, [x, y, z]: Point) -> Point {
    let turned = |angle: f64, a: f64, b: f64| {
        let (sin, cos) = angle.sin_cos();
        (a * cos - b * sin, a * sin + b * cos)
    };
    let (y, z) = turned(roll, y, z);
    let (z, x) = turned(pitch, z, x);
    let (x, y) = turned(yaw, x, y);
    [xyz[0] + x, xyz[1] + y, xyz[2] + z]
}

/// The box around some points, along the axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    low: Point,
    high: Point,
}

impl Bounds {
    /// None of no points.
    pub(super) fn of(points: &[Point]) -> Option<Bounds> {
        let extreme = |pick: fn(f64, f64) -> f64| {
            let points = points.iter().copied();
            points.reduce(|a, b| core::array::from_fn(|i| pick(a[i], b[i])))
        };
        Some(Bounds {
            low: extreme(f64::min)?,
            high: extreme(f64::max)?,
        })
    }

    /// Half of its diagonal: no point of it is further from the middle.
    pub(super) fn radius(&self) -> f64 {
        norm(core::array::from_fn(|i| self.high[i] - self.low[i])) / 2.0
    }

    /// How far a point is outside of it.
    pub(super) fn distance(&self, point: Point) -> f64 {
        let nearest: Point = core::array::from_fn(|i| point[i].max(self.low[i]).min(self.high[i]));
        norm(core::array::from_fn(|i| point[i] - nearest[i]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_turned_about_fixed_axes() {
        let quarter = core::f64::consts::FRAC_PI_2;
        let at = |rpy| placed([10.0, 0.0, 0.0], rpy, [1.0, 2.0, 3.0]).map(f64::round);
        assert_eq!(at([0.0; 3]), [11.0, 2.0, 3.0]);
        assert_eq!(at([quarter, 0.0, 0.0]), [11.0, -3.0, 2.0]);
        assert_eq!(at([0.0, quarter, 0.0]), [13.0, 2.0, -1.0]);
        assert_eq!(at([quarter, 0.0, quarter]), [13.0, 1.0, 2.0]);
    }

    #[test]
    fn a_box_has_a_radius_and_an_outside() {
        let bounds = Bounds::of(&[[0.0; 3], [3.0, 0.0, 4.0]]).expect("points");
        assert_eq!(bounds.radius(), 2.5);
        assert_eq!(bounds.distance([1.0, 0.0, 2.0]), 0.0);
        assert_eq!(bounds.distance([6.0, 4.0, 4.0]), 5.0);
        assert!(Bounds::of(&[]).is_none());
    }
}
