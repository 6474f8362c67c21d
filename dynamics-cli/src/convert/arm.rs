//! An arm in space with all joints at zero: what a file describes, apart from its frames.

use dynamics_codegen::geometry::{Mass, Transform, Vector, dot, number, tidy};
use dynamics_symbolic::exact::{Rational, square_root};
use dynamics_symbolic::robot::{Convention, JointType, Placement, Robot, Row, Value};

use super::parameters;

/// An arm whose joints have axes in space, and whose bodies are given in the frames of its joints.
pub(super) struct Arm<'r> {
    pub(super) robot: &'r Robot,
    /// Acceleration of gravity in the axes of the world.
    pub(super) gravity: Vector,
    /// From the base outwards; joints that are locked are parts of the links before them.
    pub(super) joints: Vec<Joint<'r>>,
    /// The tip's frame in the world.
    pub(super) tip: Transform,
}

/// A joint that moves, and the link behind it.
pub(super) struct Joint<'r> {
    /// Its row, whose geometry and body are not read.
    pub(super) row: &'r Row,
    /// A frame in the world whose z axis is that of the joint.
    pub(super) frame: Transform,
    /// The link in that frame.
    pub(super) body: Mass,
}

impl Joint<'_> {
    pub(super) fn slides(&self) -> bool {
        self.row.joint_type == JointType::Prismatic
    }
}

impl Arm<'_> {
    /// The arm of a robot without fields; of one with fields there is none.
    pub(super) fn new(robot: &Robot) -> Option<Arm<'_>> {
        let mut frame = match &robot.base {
            Some(base) => placed(base)?,
            None => Transform::identity(),
        };
        let mut joints: Vec<Joint> = Vec::new();
        // The tip behind the last row.
        let mut last = frame.clone();
        for (i, row) in robot.rows.iter().enumerate() {
            let [mount, link_frame, tip] = robot.mounted(i);
            let before = behind(&frame, &mount)?;
            frame = before.then(&step(robot.convention, row)?).tidy();
            let link = behind(&frame, &link_frame)?;
            last = behind(&link, &tip)?;
            if row.locked.is_none() {
                let axis = match robot.convention {
                    Convention::Standard => before,
                    Convention::Modified => frame.clone(),
                };
                joints.push(Joint {
                    row,
                    frame: axis,
                    body: Mass::none(),
                });
            }
            // Links before the first joint stand still.
            if let Some(joint) = joints.last_mut() {
                let link = joint.frame.inverse().then(&link);
                joint
                    .body
                    .add(&body(&row.mass, &row.com, &row.inertia, &link)?);
            }
        }
        let tip = match &robot.tool {
            Some(tool) => last.then(&placed(&tool.placement)?).tidy(),
            None => last,
        };
        let gravity = numbers(&robot.gravity)?;
        Some(Arm {
            robot,
            gravity,
            joints,
            tip,
        })
    }

    /// A length that no distance in the arm exceeds by much.
    pub(super) fn size(&self) -> Rational {
        let frames = self.joints.iter().map(|joint| &joint.frame);
        let mut before = [Rational::ZERO; 3];
        let mut size = Rational::ZERO;
        for frame in frames.chain([&self.tip]) {
            size += length(&between(&before, &frame.origin));
            before = frame.origin.clone();
        }
        size
    }
}

/// The way from one point to another.
pub(super) fn between(from: &Vector, to: &Vector) -> Vector {
    [0, 1, 2].map(|k| tidy(&to[k] - &from[k]))
}

/// The length of a vector.
pub(super) fn length(v: &Vector) -> Rational {
    let square = dot(v, v);
    square_root(&tidy(square)).unwrap_or(Rational::ZERO)
}

/// A body of a link frame, in the frame in which `link` places that one.
fn body(mass: &Value, com: &[Value; 3], inertia: &[Value; 6], link: &Transform) -> Option<Mass> {
    let center = Transform {
        origin: numbers(com)?,
        ..Transform::identity()
    };
    let frame = link.then(&center).tidy();
    Some(Mass::new(&number(mass)?, &numbers(inertia)?, &frame))
}

fn numbers<const N: usize>(values: &[Value; N]) -> Option<[Rational; N]> {
    let numbers: Option<Vec<_>> = values.iter().map(number).collect();
    numbers?.try_into().ok()
}

fn placed(place: &Placement) -> Option<Transform> {
    Transform::new(&numbers(&place.xyz)?, &place.rpy)
}

/// The last of some frames behind another one, each placed in the one before it.
fn behind(frame: &Transform, placements: &[Placement]) -> Option<Transform> {
    let mut placements = placements.iter();
    placements.try_fold(frame.clone(), |frame, placement| {
        Some(frame.then(&placed(placement)?).tidy())
    })
}

/// A frame behind a row in the one before it: the joint at zero, or where it is locked.
fn step(convention: Convention, row: &Row) -> Option<Transform> {
    let (mut angle, mut offset) = (Value::zero(), number(&row.d)?);
    match (&row.locked, row.joint_type) {
        (None, _) => {}
        (Some(position), JointType::Revolute) => angle = position.clone(),
        (Some(position), JointType::Prismatic) => offset += number(position)?,
    }
    let angles = [row.alpha.clone(), row.theta.clone()];
    let step = parameters::step(convention, [&number(&row.a)?, &offset], angles)?;
    let locked = Transform::new(&[Rational::ZERO; 3], &[Value::zero(), Value::zero(), angle])?;
    Some(match convention {
        Convention::Standard => locked.then(&step),
        Convention::Modified => step.then(&locked),
    })
}
