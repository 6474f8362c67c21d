//! Frames on the axes of joints, chosen so that the steps between them are short.
//!
//! A frame whose z axis is on a joint's axis may turn about that axis and slide along it. A step of a table, along x and
//! about x, is short already. Any other step is made so here, exactly: turns by quarters are taken out of a path, so
//! that they cost nothing, and the joints at its two ends take what is about and along their axes. A turn by another
//! angle stays as it was written.

use super::{Joint, Tree};
use crate::exact::Rational;
use crate::robot::{Angle, Placement, Value};

/// Where a joint is, from the aligned frame of the joint that carries its link: `before` Rz(turn) Tz(d).
#[derive(Clone, Debug)]
pub(crate) struct Aligned {
    pub(crate) before: Vec<Placement>,
    /// The constant angle about the axis, as the sum of these.
    pub(crate) turn: Vec<Value>,
    /// The constant step along the axis.
    pub(crate) d: Value,
    /// The joint's own frame in the aligned one: each placement slides along z or turns about z.
    pub(crate) own: Vec<Placement>,
}

impl Aligned {
    /// Aligns the frames of all joints. A joint that carries several is aligned with the first of them.
    pub(super) fn align(joints: &mut [Joint], tree: &Tree) {
        let mut carries = vec![false; joints.len()];
        for i in 0..joints.len() {
            let parent = tree.parent(i);
            let own = parent.map_or(&[][..], |parent| &joints[parent].aligned.own);
            if !own.is_empty() || !is_screw(&joints[i].before) {
                let mut path = Path::new(&[own, &joints[i].before].concat());
                if let Some(parent) = parent.filter(|&parent| !carries[parent]) {
                    let (slide, turns) = path.take_first();
                    joints[parent].aligned.moved(slide, turns);
                }
                let (before, slide, turns) = path.without_last();
                let aligned = &mut joints[i].aligned;
                aligned.before = before;
                aligned.d = aligned.d.clone() + slide;
                aligned.turn.extend(turns);
            }
            if let Some(parent) = parent {
                carries[parent] = true;
            }
        }
    }

    /// Slides the frame along its axis and turns it about that.
    fn moved(&mut self, slide: Value, turns: Vec<Value>) {
        if !slide.is_zero() {
            self.own.push(along_z(-slide.clone(), Value::zero()));
            self.d = self.d.clone() + slide;
        }
        let back = turns
            .iter()
            .map(|turn| along_z(Value::zero(), -turn.clone()));
        self.own.extend(back);
        self.turn.extend(turns);
    }
}

/// Whether a step is one of a table: along x, and about x.
fn is_screw(step: &[Placement]) -> bool {
    let is_about_x = |placement: &Placement| {
        let [[_, y, z], [_, pitch, yaw]] = [&placement.xyz, &placement.rpy];
        [y, z, pitch, yaw].into_iter().all(Value::is_zero)
    };
    step.len() <= 1 && step.iter().all(is_about_x)
}

/// Tz(slide) Rz(turn)
fn along_z(slide: Value, turn: Value) -> Placement {
    Placement {
        xyz: [Value::zero(), Value::zero(), slide],
        rpy: [Value::zero(), Value::zero(), turn],
    }
}

/// A rotation by quarter turns, as a matrix.
type Quarters = [[i8; 3]; 3];

/// A frame in another one: T(xyz) R(turn) for each of the steps, then T(`origin`) and the rotation `quarters`.
struct Path {
    steps: Vec<Step>,
    origin: [Value; 3],
    quarters: Quarters,
}

/// A step, and a turn about a coordinate axis that is less than a quarter turn.
struct Step {
    xyz: [Value; 3],
    axis: usize,
    angle: Value,
}

impl Path {
    /// T(xyz) Rz(yaw) Ry(pitch) Rx(roll) for each of the placements.
    fn new(placements: &[Placement]) -> Self {
        let mut path = Path {
            steps: Vec::new(),
            origin: [0; 3].map(Value::integer),
            quarters: about(0, 0),
        };
        for placement in placements {
            for (x, y) in path
                .origin
                .iter_mut()
                .zip(rotated(&path.quarters, &placement.xyz))
            {
                *x = x.clone() + y;
            }
            for axis in [2, 1, 0] {
                path.turn(axis, &placement.rpy[axis]);
            }
        }
        path
    }

    /// Q R(angle) about an axis is R(+-angle) Q about the one that Q turns it to. An angle that is no whole number of
    /// quarter turns stays whole, so that it is read as it was written.
    fn turn(&mut self, axis: usize, by: &Value) {
        let read = Angle::new(by);
        if read.rest.is_none() {
            self.quarters = product(&self.quarters, &about(axis, read.quarter_turns));
            return;
        }
        let (axis, angle) = signed(&self.quarters, axis, by.clone());
        let xyz = core::mem::replace(&mut self.origin, [0; 3].map(Value::integer));
        self.steps.push(Step { xyz, axis, angle });
    }

    /// Slides the first frame along its axis and turns it about that, as far as the path gets shorter. If two axes are
    /// parallel, only the last one takes a slide.
    fn take_first(&mut self) -> (Value, Vec<Value>) {
        let mut turns = Vec::new();
        let is_along = |xyz: &[Value; 3]| xyz[0].is_zero() && xyz[1].is_zero();
        while self
            .steps
            .first()
            .is_some_and(|step| step.axis == 2 && is_along(&step.xyz))
        {
            let Step { xyz, angle, .. } = self.steps.remove(0);
            turns.push(angle);
            let next = self.first_origin();
            next[2] = next[2].clone() + xyz[2].clone();
        }
        if self.steps.is_empty() {
            let [across, _, along] = self.quarters.map(|row| row[2]);
            if along != 0 {
                return (Value::zero(), turns);
            }
            if across != 0 {
                let back = about(2, 3);
                self.origin = rotated(&back, &self.origin);
                self.quarters = product(&back, &self.quarters);
                turns.push(angle(1));
            }
        }
        let slide = core::mem::replace(&mut self.first_origin()[2], Value::zero());
        (slide, turns)
    }

    fn first_origin(&mut self) -> &mut [Value; 3] {
        let first = self.steps.first_mut().map(|step| &mut step.xyz);
        first.unwrap_or(&mut self.origin)
    }

    /// The placements that are left after the last frame has slid along its axis and turned about it, and how it did.
    fn without_last(mut self) -> (Vec<Placement>, Value, Vec<Value>) {
        let (mut slide, mut turns) = (Value::zero(), Vec::new());
        loop {
            let (axis, _) = signed(&self.quarters, 2, Value::zero());
            let along = core::mem::replace(&mut self.origin[axis], Value::zero());
            slide = slide + signed(&self.quarters, 2, along).1;
            let is_here = self.origin.iter().all(Value::is_zero);
            let Some(step) = self.steps.pop_if(|step| is_here && step.axis == axis) else {
                break;
            };
            turns.push(signed(&self.quarters, 2, step.angle).1);
            self.origin = step.xyz;
        }
        let mut counts = (0..32).map(|n| [n / 16, n / 4 % 4, n % 4]);
        let rotation = |[yaw, roll, turn]: &[u8; 3]| {
            product(
                &product(&about(2, *yaw), &about(0, *roll)),
                &about(2, *turn),
            )
        };
        let found = counts.find(|counts| rotation(counts) == self.quarters);
        let [yaw, roll, turn] = found.expect("axes along those of the frame are reached so");
        turns.extend((turn != 0).then(|| angle(turn)));
        let steps = self.steps.into_iter().map(|Step { xyz, axis, angle }| {
            let mut rpy = [0; 3].map(Value::integer);
            rpy[axis] = angle;
            Placement { xyz, rpy }
        });
        let last = Placement {
            xyz: self.origin,
            rpy: [angle(roll), Value::zero(), angle(yaw)],
        };
        (steps.chain([last]).collect(), slide, turns)
    }
}

/// The index of the axis to which a rotation turns an axis, and a quantity along or about it with its sign there.
fn signed(rotation: &Quarters, axis: usize, quantity: Value) -> (usize, Value) {
    let column = rotation.map(|row| row[axis]);
    let index = column.iter().position(|x| *x != 0).expect("a unit vector");
    let quantity = if column[index] < 0 {
        -quantity
    } else {
        quantity
    };
    (index, quantity)
}

fn rotated(rotation: &Quarters, v: &[Value; 3]) -> [Value; 3] {
    let mut rotated = [0; 3].map(Value::integer);
    for (axis, x) in v.iter().enumerate() {
        let (index, x) = signed(rotation, axis, x.clone());
        rotated[index] = x;
    }
    rotated
}

fn product(a: &Quarters, b: &Quarters) -> Quarters {
    let entry = |i: usize, j: usize| (0..3).map(|k| a[i][k] * b[k][j]).sum();
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)))
}

/// So many quarter turns about the axis of that index.
fn about(axis: usize, count: u8) -> Quarters {
    let (s, c) = [(0, 1), (1, 0), (0, -1), (-1, 0)][usize::from(count % 4)];
    match axis {
        0 => [[1, 0, 0], [0, c, -s], [0, s, c]],
        1 => [[c, 0, s], [0, 1, 0], [-s, 0, c]],
        _ => [[c, -s, 0], [s, c, 0], [0, 0, 1]],
    }
}

/// The angle of so many quarter turns.
fn angle(count: u8) -> Value {
    let signed = [0, 1, 2, -1][usize::from(count % 4)];
    let half = Rational::from_parts_signed(signed.into(), 2_u8.into());
    Value::Pi * Value::Rational(half)
}
