//! Where a frame is to be.

use dynamics_runtime::internal::{Float as _, is_homogeneous, is_rotation, quaternion};
use nalgebra::{Matrix3, Matrix4, Vector3};

/// Where a frame is to be: its position, its rotation, both, or one of its directions.
///
/// Weights say what counts more where not all can be reached. Whether a target is reached is a matter of the tolerances
/// alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    pub(super) position: Option<Vector3<f64>>,
    pub(super) turn: Turn,
    /// Whether it was given as a homogeneous transform that is one.
    is_transform: bool,
    pub(super) position_weight: f64,
    pub(super) rotation_weight: f64,
}

/// The demand on a frame's rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Turn {
    /// Nothing.
    Any,
    /// The frame's axes are the columns.
    Full(Matrix3<f64>),
    /// A unit vector in the frame has a direction in the world, another unit vector.
    Pointing {
        axis: Vector3<f64>,
        direction: Vector3<f64>,
    },
}

impl Target {
    const fn new(position: Option<Vector3<f64>>, turn: Turn) -> Self {
        Target {
            position,
            turn,
            is_transform: true,
            position_weight: 1.0,
            rotation_weight: 1.0,
        }
    }

    /// A position, m, and a rotation: a homogeneous transform, as `forward_kinematics` gives it, whose last row is 0, 0, 0, 1.
    pub fn pose(pose: &Matrix4<f64>) -> Self {
        let rotation = pose.fixed_view::<3, 3>(0, 0).into_owned();
        Target {
            is_transform: is_homogeneous(pose),
            ..Target::new(Some(origin(pose)), Turn::Full(rotation))
        }
    }

    /// A position alone, m; the rotation is free.
    pub fn position(position: Vector3<f64>) -> Self {
        Target::new(Some(position), Turn::Any)
    }

    /// A rotation alone, whose columns are the frame's axes in the world; the position is free.
    pub fn rotation(rotation: Matrix3<f64>) -> Self {
        Target::new(None, Turn::Full(rotation))
    }

    /// A direction alone: `axis`, a vector in the frame, is to point along `direction`, a vector in the world. The frame may
    /// turn about it. Lengths do not count.
    pub fn pointing(axis: Vector3<f64>, direction: Vector3<f64>) -> Self {
        let [axis, direction] = [axis, direction].map(|vector| vector / vector.norm());
        Target::new(None, Turn::Pointing { axis, direction })
    }

    /// The same, at a position, m.
    pub fn at(mut self, position: Vector3<f64>) -> Self {
        self.position = Some(position);
        self
    }

    /// How much errors count: those of the position, as shares of the arm's length, and those of the rotation, in radians.
    /// Both are 1 at first.
    pub fn weights(mut self, position: f64, rotation: f64) -> Self {
        (self.position_weight, self.rotation_weight) = (position, rotation);
        self
    }

    /// Whether it can be requested: its numbers are finite, its weights above zero, and its rotation and its matrix are ones.
    pub(super) fn is_possible(&self) -> bool {
        let is_weight = |weight: f64| weight > 0.0 && weight.is_finite();
        let position = self.position.unwrap_or_default();
        let is_turn = match &self.turn {
            Turn::Any => true,
            Turn::Full(rotation) => is_rotation(rotation),
            Turn::Pointing { axis, direction } => {
                [axis, direction].map(|x| x.norm().is_finite()) == [true; 2]
            }
        };
        is_turn
            && self.is_transform
            && position.iter().all(|x| x.is_finite())
            && is_weight(self.position_weight)
            && is_weight(self.rotation_weight)
    }

    /// The difference to the target at a pose of the frame.
    #[inline(always)]
    pub(super) fn error(&self, pose: &Matrix4<f64>) -> Missing {
        let position = self.position.map(|target| target - origin(pose));
        let rotation = pose.fixed_view::<3, 3>(0, 0);
        let (rotation, about) = match &self.turn {
            Turn::Any => (None, None),
            Turn::Full(target) => (Some(between(&(target * rotation.transpose()))), None),
            Turn::Pointing { axis, direction } => {
                let axis = rotation * axis;
                (Some(swing(&axis, direction)), Some(axis))
            }
        };
        Missing {
            position,
            rotation,
            about,
        }
    }
}

impl From<&Matrix4<f64>> for Target {
    fn from(pose: &Matrix4<f64>) -> Self {
        Target::pose(pose)
    }
}

/// The difference between a pose and a target.
#[derive(Clone, Copy, Debug)]
pub(super) struct Missing {
    /// m; `None` where the target has no position.
    pub(super) position: Option<Vector3<f64>>,
    /// 2 sin(angle / 2) along the axis of the turn that is missing, in the world.
    pub(super) rotation: Option<Vector3<f64>>,
    /// The direction about which the frame may turn.
    pub(super) about: Option<Vector3<f64>>,
}

/// The length of a vector, also where its square is beyond the numbers.
pub(super) fn length(vector: &Vector3<f64>) -> f64 {
    let length = vector.norm();
    if length.is_finite() {
        return length;
    }
    let most = vector.amax();
    (vector / most).norm() * most
}

/// The origin of a frame.
fn origin(pose: &Matrix4<f64>) -> Vector3<f64> {
    pose.fixed_view::<3, 1>(0, 3).into_owned()
}

/// 2 sin(angle / 2) along the axis of a rotation: twice the vector of its unit quaternion. Its square, 3 - tr R, is smooth
/// everywhere, and near the identity it is the rotation vector.
#[inline(always)]
fn between(r: &Matrix3<f64>) -> Vector3<f64> {
    // 4 cos^2(angle / 2)
    let cosine = 1.0 + r.trace();
    if cosine > 1e-6 {
        // 2 sin(angle) along the axis.
        let sines = [r.m32 - r.m23, r.m13 - r.m31, r.m21 - r.m12];
        return Vector3::from(sines) / cosine.root();
    }
    let [_, x, y, z] = quaternion::of(r);
    Vector3::new(x, y, z) * 2.0
}

/// 2 sin(angle / 2) along the axis of the shortest turn of one unit vector into another.
#[inline(always)]
fn swing(from: &Vector3<f64>, to: &Vector3<f64>) -> Vector3<f64> {
    // 2 cos^2(angle / 2)
    let cosine = 1.0 + from.dot(to);
    if cosine > 1e-9 {
        return from.cross(to) * (2.0 / cosine).root();
    }
    // Any axis at a right angle.
    let mut away = Vector3::zeros();
    away[from.iamin()] = 1.0;
    from.cross(&away).normalize() * 2.0
}
