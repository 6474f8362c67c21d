//! A robot in space with all joints at zero: what a file describes, apart from its frames.

use dynamics_codegen::geometry::{Mass, Transform, Vector, dot, number, tidy};
use dynamics_symbolic::exact::{Rational, square_root};
use dynamics_symbolic::robot::{Convention, JointType, Placement, Robot, Row, Value};

use super::parameters;

/// A robot whose joints have axes in space, and whose bodies are given in the frames of its joints.
pub(super) struct Arm<'r> {
    pub(super) robot: &'r Robot,
    /// Acceleration of gravity in the axes of the world.
    pub(super) gravity: Vector,
    /// The body of a base that moves, in the axes of the world, which are its own: with the links that are locked to it.
    pub(super) base: Option<Mass>,
    /// In the order of their rows; joints that are locked are parts of the links before them.
    pub(super) joints: Vec<Joint<'r>>,
    /// The tip, if there is one.
    pub(super) tip: Option<Place>,
    /// The frames of the robot, in their order.
    pub(super) frames: Vec<Place>,
}

/// A joint that moves, and the link behind it.
pub(super) struct Joint<'r> {
    /// Its row, whose geometry and body are not read.
    pub(super) row: &'r Row,
    /// The joint that carries it; none on the base.
    pub(super) parent: Option<usize>,
    /// A frame in the world whose z axis is that of the joint.
    pub(super) frame: Transform,
    /// The link in that frame.
    pub(super) body: Mass,
}

/// A place that moves with a joint.
pub(super) struct Place {
    /// The joint; none of a place on the base.
    pub(super) on: Option<usize>,
    /// Its frame in the world.
    pub(super) frame: Transform,
}

impl Joint<'_> {
    pub(super) fn slides(&self) -> bool {
        self.row.joint_type == JointType::Prismatic
    }
}

impl Arm<'_> {
    /// The arm of a robot without fields; of one with fields there is none.
    pub(super) fn new(robot: &Robot) -> Option<Arm<'_>> {
        let base = match robot.placement() {
            Some(base) => placed(base)?,
            None => Transform::identity(),
        };
        let mut floating = match robot.floating() {
            Some(of) => Some(body(&of.mass, &of.com, &of.inertia, &base)?),
            None => None,
        };
        let mut joints: Vec<Joint> = Vec::new();
        // The frames behind all rows, and those of their links.
        let (mut frames, mut links): (Vec<Transform>, Vec<Place>) = Default::default();
        for (i, row) in robot.rows.iter().enumerate() {
            let [mount, link_frame] = robot.mounted(i);
            let parent = robot.parent(i);
            let before = behind(parent.map_or(&base, |parent| &frames[parent]), &mount)?;
            let frame = before.then(&step(robot.convention, row)?).tidy();
            let link = behind(&frame, &link_frame)?;
            let mut on = parent.and_then(|parent| links[parent].on);
            if row.locked.is_none() {
                let axis = match robot.convention {
                    Convention::Standard => before,
                    Convention::Modified => frame.clone(),
                };
                joints.push(Joint {
                    row,
                    parent: on,
                    frame: axis,
                    body: Mass::none(),
                });
                on = Some(joints.len() - 1);
            }
            let carrier = on.map(|on| &mut joints[on]);
            let place = carrier
                .as_ref()
                .map(|joint| joint.frame.inverse().then(&link));
            let of_link = body(
                &row.mass,
                &row.com,
                &row.inertia,
                place.as_ref().unwrap_or(&link),
            )?;
            // Links before the first joint are parts of a base that moves.
            if let Some(carrier) = carrier.map(|joint| &mut joint.body).or(floating.as_mut()) {
                carrier.add(&of_link);
            }
            frames.push(frame);
            links.push(Place { on, frame: link });
        }
        let place = |row: Option<usize>, places: &[Placement]| {
            let link = row.map(|row| &links[row]);
            let frame = behind(link.map_or(&base, |link| &link.frame), places)?;
            let on = link.and_then(|link| link.on);
            Some(Place { on, frame })
        };
        let tip = robot.tip_row().map(|row| {
            let mut tip = robot.rows[row].tip().unwrap_or_default().to_vec();
            tip.extend(robot.tool.as_ref().map(|tool| tool.placement.clone()));
            place(Some(row), &tip)
        });
        let named = robot.frames.iter();
        let named = named.map(|frame| place(frame.on, &frame.places));
        Some(Arm {
            robot,
            gravity: numbers(&robot.gravity)?,
            tip: tip.map_or(Some(None), |tip| tip.map(Some))?,
            base: floating,
            frames: named.collect::<Option<_>>()?,
            joints,
        })
    }

    /// A length that no distance in the arm exceeds by much.
    pub(super) fn size(&self) -> Rational {
        let joints = self.joints.iter().map(|joint| (joint.parent, &joint.frame));
        let tip = self.tip.iter().map(|tip| (tip.on, &tip.frame));
        let mut size = Rational::ZERO;
        for (parent, frame) in joints.chain(tip) {
            let from = parent.map_or([Rational::ZERO; 3], |parent| {
                self.joints[parent].frame.origin.clone()
            });
            size += length(&between(&from, &frame.origin));
        }
        size
    }

    /// The joints that a joint carries; those on the base of none.
    pub(super) fn children(&self, parent: Option<usize>) -> impl Iterator<Item = usize> {
        let joints = 0..self.joints.len();
        joints.filter(move |joint| self.joints[*joint].parent == parent)
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
