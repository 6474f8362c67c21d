//! Joints anywhere in space, as rows of a table.
//!
//! Robot files place a joint in the link frame before it by any rotation and offset, and let it turn about
//! any axis. Between two axes z and z' whose frames differ by quarter turns there are rows that say the
//! same exactly: the frame of a row may turn about its own axis and slide along it, so that its x axis is
//! along the common normal of the two. A rotation that is no quarter turn is an axis of its own here, of a
//! joint that is locked: all angles stay as they were written.

use super::{Angle, JointType, Placement, Row, Value};
use crate::exact::Rational;

/// Where a joint is and how the link frame lies behind it, for rows that were not written as such.
///
/// With the link frame L' of the row before it that has one, or the base frame, the link frame is
/// L' `places` S Rz(q) S^-1 (Tz(q) for a prismatic joint), S = Rz(azimuth) Ry(polar): the joint turns about
/// the direction of those angles in the last of the places.
#[derive(Clone, Debug, PartialEq)]
pub struct Mount<C = Value> {
    /// The joint's frame in the link frame before, each place in the one before it.
    pub places: Vec<Placement<C>>,
    /// Azimuth and polar angle of the joint's axis, rad.
    pub axis: [C; 2],
    /// The link frame in the frame that the row's cells describe, each place in the one before it.
    pub frame: Vec<Placement<C>>,
}

/// The rows of a modified table for rows whose cells a, alpha, d and theta are zero and that have mounts,
/// with locked rows without mass and without name between them where one row does not suffice. The tip is
/// in the last of the places behind the last link frame: another such row.
pub fn mounted(rows: Vec<Row>, tip: Vec<Placement>) -> Vec<Row> {
    let mut chain = Chain::default();
    let mut places = Vec::with_capacity(rows.len());
    for row in rows {
        match row.mount.clone() {
            Some(mount) => chain.push(row, &mount),
            None => chain.rows.push(row),
        }
        places.push(chain.rows.len() - 1);
    }
    for coupling in chain.rows.iter_mut().filter_map(|row| row.follows.as_mut()) {
        coupling.leader = places[coupling.leader];
    }
    if !tip.is_empty() {
        let last = chain.rows.last().and_then(|row| row.mount.as_ref());
        let frame = last.map(|mount| mount.frame.clone()).unwrap_or_default();
        chain.rows.push(Row {
            mount: Some(Mount {
                frame: [frame, tip.clone()].concat(),
                places: tip,
                axis: [Value::zero(), Value::zero()],
            }),
            ..fixed()
        });
    }
    chain.rows
}

/// The rotation about an axis by a multiple of a quarter turn, as a matrix.
type Quarters = [[i8; 3]; 3];

const NONE: Quarters = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

/// A frame in another one, its axes along those of the other.
#[derive(Clone)]
struct Aligned {
    rotation: Quarters,
    origin: [Value; 3],
}

/// The rows so far, and the frame that was reached in the frame of the last of them.
struct Chain {
    rows: Vec<Row>,
    reached: Aligned,
    /// The last row whose mount has a link frame.
    last_link: Option<usize>,
    /// The axis of the joint that was reached, from which a next joint turns back first.
    axis_before: Option<[Value; 2]>,
}

impl Default for Chain {
    fn default() -> Self {
        Chain {
            rows: Vec::new(),
            reached: Aligned::identity(),
            last_link: None,
            axis_before: None,
        }
    }
}

impl Aligned {
    fn identity() -> Self {
        Aligned {
            rotation: NONE,
            origin: [0; 3].map(Value::integer),
        }
    }

    /// A vector of this frame in the outer one.
    fn leave(&self, v: &[Value; 3]) -> [Value; 3] {
        self.rotation.map(|row| {
            let terms = row.iter().zip(v).filter(|(sign, _)| **sign != 0);
            let terms = terms.map(|(sign, x)| if *sign < 0 { -x.clone() } else { x.clone() });
            terms.fold(Value::zero(), |sum, x| sum + x)
        })
    }

    fn moved(&mut self, by: &[Value; 3]) {
        let by = self.leave(by);
        for (x, by) in self.origin.iter_mut().zip(by) {
            *x = x.clone() + by;
        }
    }

    fn turned(&mut self, by: &Quarters) {
        self.rotation = product(&self.rotation, by);
    }
}

fn product(a: &Quarters, b: &Quarters) -> Quarters {
    let entry = |i: usize, j: usize| (0..3).map(|k| a[i][k] * b[k][j]).sum();
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)))
}

/// So many quarter turns about the axis of that index.
fn quarter_turns(axis: usize, count: u8) -> Quarters {
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

/// How many quarter turns about z a rotation about z is.
fn count_about_z(rotation: &Quarters) -> u8 {
    match (rotation[0][0], rotation[1][0]) {
        (1, _) => 0,
        (_, 1) => 1,
        (-1, _) => 2,
        _ => 3,
    }
}

impl Chain {
    /// Adds a joint and the link behind it.
    fn push(&mut self, row: Row, mount: &Mount) {
        if let Some([azimuth, polar]) = self.axis_before.take() {
            self.turn(1, &-polar);
            self.turn(2, &-azimuth);
        }
        for place in &mount.places {
            self.place(place);
        }
        let [azimuth, polar] = &mount.axis;
        self.turn(2, azimuth);
        self.turn(1, polar);
        self.axis(row, None);
        let row = self.rows.len() - 1;
        self.last_link = Some(row);
        let back = [
            rotation([Value::zero(), -polar.clone(), Value::zero()]),
            rotation([Value::zero(), Value::zero(), -azimuth.clone()]),
        ];
        let is_turn = |place: &Placement| place.rpy.iter().any(|angle| !angle.is_zero());
        if let Some(mount) = &mut self.rows[row].mount {
            mount.frame = back.into_iter().filter(is_turn).collect();
        }
        self.axis_before = Some(mount.axis.clone());
    }

    /// T(xyz) Rz(yaw) Ry(pitch) Rx(roll)
    fn place(&mut self, place: &Placement) {
        self.reached.moved(&place.xyz);
        for axis in [2, 1, 0] {
            self.turn(axis, &place.rpy[axis]);
        }
    }

    /// A turn about the axis of that index: what is more than quarter turns is a locked joint.
    fn turn(&mut self, axis: usize, by: &Value) {
        let by = Angle::new(by);
        self.reached.turned(&quarter_turns(axis, by.quarter_turns));
        let Some(rest) = by.rest else {
            return;
        };
        // The quarter turn from z to the axis, and the way back.
        let (about, count) = [(1, 1), (0, 3), (2, 0)][axis];
        self.reached.turned(&quarter_turns(about, count));
        self.axis(fixed(), Some(rest));
        self.reached.turned(&quarter_turns(about, 4 - count));
    }

    /// A joint about z of the frame that is reached, from which the next frames are reached. One that is
    /// locked turns by an angle.
    fn axis(&mut self, mut row: Row, locked: Option<Value>) {
        let [x, y, z] = self.reached.origin.clone();
        let across = self.reached.rotation.map(|row| row[2]);
        let is_on_axis = x.is_zero() && y.is_zero() && across == [0, 0, 1];
        let turned = count_about_z(&self.reached.rotation);
        if is_on_axis && !self.rows.is_empty() {
            let taken = match &locked {
                Some(_) => self.adjust(turned, locked.as_ref(), &z),
                None => self.take_place(&mut row, turned, &z),
            };
            if taken {
                if locked.is_none() {
                    self.rows.push(row);
                }
                self.reached = Aligned::identity();
                return;
            }
        }
        let (alpha, a, rotation, d) = match across[2] {
            0 => self.perpendicular(),
            _ => self.parallel(),
        };
        row.alpha = angle(alpha);
        row.a = a;
        row.d = d;
        let turned = count_about_z(&rotation);
        let theta = sum(&locked.clone().unwrap_or(Value::zero()), turned, None);
        self.reached = Aligned::identity();
        row.theta = theta.unwrap_or_else(|| {
            // The turns about one axis may come in any order: the quarter turns are left for what follows.
            self.reached.turned(&quarter_turns(2, turned));
            locked.unwrap_or(Value::zero())
        });
        self.rows.push(row);
    }

    /// Gives a joint on the axis of a place that stands still that one's cells, where it can take its angle.
    fn take_place(&mut self, row: &mut Row, turned: u8, slide: &Value) -> bool {
        let place = self.rows.last().filter(|row| row.is_place());
        let theta = place.and_then(|place| sum(&place.theta, turned, None));
        let (Some(theta), Some(place)) = (theta, place.cloned()) else {
            return false;
        };
        self.rows.pop();
        row.alpha = place.alpha;
        row.a = place.a;
        row.d = place.d + slide.clone();
        row.theta = theta;
        true
    }

    /// Alpha, a, the rotation that is left, and d, for an axis across z: the common normal is along
    /// z x z', and both axes meet it where the frames are put.
    fn perpendicular(&mut self) -> (u8, Value, Quarters, Value) {
        let across = self.reached.rotation.map(|row| row[2]);
        // The turn of the last frame about its z, after which the other axis is along its y.
        let turn = u8::from(across[0] != 0);
        let slide = self.reached.origin[2].clone();
        self.move_last(turn, slide);
        let back = quarter_turns(2, 4 - turn);
        let unturned = Aligned {
            rotation: back,
            origin: [0; 3].map(Value::integer),
        };
        let [a, y, _] = unturned.leave(&self.reached.origin);
        let rotation = product(&back, &self.reached.rotation);
        // Rx(alpha) takes z to -y by a quarter turn.
        let (alpha, d) = match rotation[1][2] {
            -1 => (1, -y),
            _ => (3, y),
        };
        (
            alpha,
            a,
            product(&quarter_turns(0, 4 - alpha), &rotation),
            d,
        )
    }

    /// The same for an axis along z or against it.
    fn parallel(&mut self) -> (u8, Value, Quarters, Value) {
        let [x, y, z] = self.reached.origin.clone();
        let (turn, a) = match (x.is_zero(), y.is_zero()) {
            (_, true) => (0, x),
            (true, false) => (1, y),
            // Along x first, to an axis that stands still, then along y.
            (false, false) => {
                let mut corner = fixed();
                corner.a = x;
                self.rows.push(corner);
                (1, y)
            }
        };
        self.move_last(turn, Value::zero());
        let rotation = product(&quarter_turns(2, 4 - turn), &self.reached.rotation);
        let (alpha, d) = match rotation[2][2] {
            1 => (0, z),
            _ => (2, -z),
        };
        (
            alpha,
            a,
            product(&quarter_turns(0, 4 - alpha), &rotation),
            d,
        )
    }

    /// The last frame turned about its axis by quarter turns, and slid along it; what was placed in it stays
    /// where it is. The base frame does neither, nor a frame whose angle does not take the turns: a row that
    /// stands still does it for them.
    fn move_last(&mut self, turned: u8, slide: Value) {
        if turned == 0 && slide.is_zero() {
            return;
        }
        if self.rows.is_empty() || !self.adjust(turned, None, &slide) {
            let mut place = fixed();
            place.theta = angle(turned);
            place.d = slide;
            self.rows.push(place);
        }
    }

    /// Turns the last frame by quarter turns and an angle, and slides it, where its own angle can take that.
    fn adjust(&mut self, turned: u8, by: Option<&Value>, slide: &Value) -> bool {
        let Some(last) = self.rows.len().checked_sub(1) else {
            return false;
        };
        let row = &mut self.rows[last];
        let (Some(theta), Some(turn)) =
            (sum(&row.theta, turned, by), sum(&Value::zero(), turned, by))
        else {
            return false;
        };
        row.theta = theta;
        row.d = row.d.clone() + slide.clone();
        let of_link = row.mount.as_mut().filter(|_| self.last_link == Some(last));
        if let Some(mount) = of_link {
            let mut back = rotation([Value::zero(), Value::zero(), -turn]);
            back.xyz[2] = -slide.clone();
            mount.frame.insert(0, back);
        }
        true
    }
}

/// An angle beside quarter turns and another angle, where the sum says as much: the sine of a sum of two
/// angles, each written as a number, is no number that the proof knows, and a tiny angle beside quarter turns
/// counts as rounding.
fn sum(angle: &Value, turned: u8, by: Option<&Value>) -> Option<Value> {
    let by = by.cloned().unwrap_or(Value::zero());
    let parts = [Angle::new(angle), Angle::new(&by)];
    let rest = match parts.each_ref().map(|part| part.rest.clone()) {
        [Some(a), Some(b)] => {
            let rest = a + b;
            if !rest.is_zero() {
                return None;
            }
            None
        }
        [a, b] => a.or(b),
    };
    let quarter_turns = (parts[0].quarter_turns + parts[1].quarter_turns + turned) % 4;
    let sum = self::angle(quarter_turns) + rest.clone().unwrap_or(Value::zero());
    let expected = Angle {
        quarter_turns,
        rest,
    };
    (Angle::new(&sum) == expected).then_some(sum)
}

fn rotation(rpy: [Value; 3]) -> Placement {
    Placement {
        xyz: [0; 3].map(Value::integer),
        rpy,
    }
}

/// A row that stands still: a place between two axes, with no body.
fn fixed() -> Row {
    Row {
        locked: Some(Value::zero()),
        ..Row::new("", JointType::Revolute)
    }
}
