//! The symbols of a robot's equations on a graph.

use crate::exact::Rational;
use crate::expr::{Direction, Expr, Graph, Level};
use crate::function::Argument;
use crate::robot::{Coupling, Interpretation, JointType, Robot, Row, Symbol, Value};

/// The variables of one joint.
#[derive(Clone, Copy, Debug)]
pub struct JointSymbols<'g> {
    /// Sine and cosine of the position (revolute joints); of a follower, of the position less its offset.
    pub sin_cos: (Expr<'g>, Expr<'g>),
    /// Position; the cell where the joint is locked, with no velocity, acceleration or force. A follower's
    /// position, velocity and acceleration are those of the joint it follows times the factor, and no
    /// force is applied to it.
    pub q: Expr<'g>,
    /// Velocity.
    pub qd: Expr<'g>,
    /// Acceleration.
    pub qdd: Expr<'g>,
    /// Force or torque.
    pub tau: Expr<'g>,
    /// Sign of the velocity.
    pub sign: Expr<'g>,
    /// exp(-(qd/v)^2), of joints whose friction falls with the velocity.
    pub stribeck: Option<Expr<'g>>,
}

/// The symbols of a robot on a graph.
pub struct Symbols<'g> {
    graph: &'g Graph,
    meanings: Vec<Symbol>,
    pi: Expr<'g>,
    fields: Vec<Expr<'g>>,
    angles: Vec<(Value, Expr<'g>, Expr<'g>)>,
    joints: Vec<JointSymbols<'g>>,
    /// What each row follows.
    follows: Vec<Option<Follows<'g>>>,
    entries: Vec<((Argument, usize), Expr<'g>)>,
}

type Circle<'g> = (Expr<'g>, Expr<'g>);

/// What a row follows.
struct Follows<'g> {
    /// The row of the joint that leads.
    leader: usize,
    factor: Expr<'g>,
    offset: Value,
    /// Whether the row has a mount: its offset is then a turn of its own among the places of the mount.
    is_mounted: bool,
}

/// Whole factors up to this one have no sine of their own: that of a multiple of an angle is a polynomial
/// in sine and cosine of the angle, four products and two sums for each step, and what it cancels with is
/// found.
const LARGEST_MULTIPLE: i64 = 3;

impl<'g> Symbols<'g> {
    /// Makes the symbols of a robot.
    pub fn new(graph: &'g Graph, robot: &Robot) -> Self {
        let mut meanings = vec![Symbol::Pi];
        let pi = graph.symbol(Level::Constant);
        let fields = (0..robot.fields.len())
            .map(|i| {
                meanings.push(Symbol::Field(i));
                graph.symbol(Level::Parameter)
            })
            .collect();
        let mut symbols = Symbols {
            graph,
            meanings,
            pi,
            fields,
            angles: Vec::new(),
            joints: Vec::with_capacity(robot.rows.len()),
            follows: Vec::with_capacity(robot.rows.len()),
            entries: Vec::new(),
        };
        let mut moving = 0..;
        for row in &robot.rows {
            let joint = match (&row.locked, &row.follows) {
                (Some(position), _) => symbols.locked_joint(row.joint_type, position),
                (None, None) => symbols.moving_joint(moving.next().unwrap_or_default(), row),
                // Filled in below: the joint that leads may come later.
                (None, Some(_)) => symbols.locked_joint(row.joint_type, &Value::zero()),
            };
            symbols.joints.push(joint);
            symbols.follows.push(None);
        }
        symbols.couple(robot);
        symbols
    }

    /// The variables of the joints that follow others, from those of the joints that lead.
    fn couple(&mut self, robot: &Robot) {
        let rows = robot.rows.iter().enumerate();
        let followers = rows.filter_map(|(i, row)| Some((i, row, row.follows.as_ref()?)));
        for (index, (i, row, coupling)) in (robot.dof()..).zip(followers) {
            let factor = self.value(&coupling.factor);
            self.joints[i] = self.following_joint(robot, index, row, coupling, factor);
            self.follows[i] = Some(Follows {
                leader: coupling.leader,
                factor,
                offset: coupling.offset.clone(),
                is_mounted: row.mount.is_some(),
            });
        }
    }

    /// The variables of a follower, which has symbols of that index.
    fn following_joint(
        &mut self,
        robot: &Robot,
        index: usize,
        row: &Row,
        coupling: &Coupling,
        factor: Expr<'g>,
    ) -> JointSymbols<'g> {
        let leader = self.joints[coupling.leader];
        let sin_cos = match (row.joint_type, robot.rows[coupling.leader].joint_type) {
            (JointType::Prismatic, _) => (self.graph.zero(), self.graph.one()),
            (JointType::Revolute, JointType::Revolute) => {
                let known = whole(&coupling.factor).map(|n| multiple(leader.sin_cos, n));
                known.unwrap_or_else(|| self.circle_of(index))
            }
            (JointType::Revolute, JointType::Prismatic) => self.circle_of(index),
        };
        let sign = match coupling.sign() {
            Some(1) => leader.sign,
            Some(_) => -leader.sign,
            None => self.variable(Symbol::VelocitySign(index)),
        };
        let stribeck = row.stribeck.as_ref();
        JointSymbols {
            sin_cos,
            q: factor * leader.q + self.value(&coupling.offset),
            qd: factor * leader.qd,
            qdd: factor * leader.qdd,
            tau: self.graph.zero(),
            sign,
            stribeck: stribeck.map(|_| self.variable(Symbol::Stribeck(index))),
        }
    }

    /// Sine and cosine of the angle of that index, as symbols.
    fn circle_of(&mut self, index: usize) -> (Expr<'g>, Expr<'g>) {
        let meanings = [Symbol::Sine(index), Symbol::Cosine(index)];
        self.meanings.extend(meanings);
        self.graph.circle(Level::Variable)
    }

    fn variable(&mut self, meaning: Symbol) -> Expr<'g> {
        self.meanings.push(meaning);
        self.graph.symbol(Level::Variable)
    }

    /// The variables of joint i of those that move.
    fn moving_joint(&mut self, i: usize, row: &Row) -> JointSymbols<'g> {
        JointSymbols {
            sin_cos: self.circle_of(i),
            q: self.variable(Symbol::Position(i)),
            qd: self.variable(Symbol::Velocity(i)),
            qdd: self.variable(Symbol::Acceleration(i)),
            tau: self.variable(Symbol::Force(i)),
            sign: self.variable(Symbol::VelocitySign(i)),
            stribeck: row
                .stribeck
                .is_some()
                .then(|| self.variable(Symbol::Stribeck(i))),
        }
    }

    /// A joint that is locked: everything about it is constant.
    fn locked_joint(&mut self, joint_type: JointType, position: &Value) -> JointSymbols<'g> {
        let zero = self.graph.zero();
        let angle = match joint_type {
            JointType::Revolute => position,
            JointType::Prismatic => &Value::zero(),
        };
        JointSymbols {
            sin_cos: self.sin_cos(angle),
            q: self.value(position),
            qd: zero,
            qdd: zero,
            tau: zero,
            sign: zero,
            stribeck: None,
        }
    }

    /// The graph.
    pub fn graph(&self) -> &'g Graph {
        self.graph
    }

    /// What each symbol of the graph stands for, in the order of the graph's symbols.
    pub fn meanings(&self) -> &[Symbol] {
        &self.meanings
    }

    /// The variables of the joint of row i.
    pub fn joint(&self, i: usize) -> &JointSymbols<'g> {
        &self.joints[i]
    }

    /// One variable of the joint of every row.
    pub fn all(&self, variable: impl Fn(&JointSymbols<'g>) -> Expr<'g>) -> Vec<Expr<'g>> {
        self.joints.iter().map(variable).collect()
    }

    /// An entry of another argument than q, qd, qdd and tau: a symbol from the first time on that it is
    /// asked for.
    pub fn entry(&mut self, argument: Argument, index: usize) -> Expr<'g> {
        let key = (argument, index);
        if let Some((_, known)) = self.entries.iter().find(|(known, _)| *known == key) {
            return *known;
        }
        self.meanings.push(Symbol::Entry(argument, index));
        let symbol = self.graph.symbol(Level::Variable);
        self.entries.push((key, symbol));
        symbol
    }

    /// Such an argument with an entry for the joint of every row, zero where the joint is locked; that of a
    /// follower is its leader's times the factor.
    pub fn entries(&mut self, argument: Argument, robot: &Robot) -> Vec<Expr<'g>> {
        let of_joints: Vec<_> = (0..robot.dof()).map(|i| self.entry(argument, i)).collect();
        self.of_rows(robot, &of_joints)
    }

    /// For the joint of every row, of what is given for the joints that move by themselves: the same times
    /// the factor of a follower, zero where a joint is locked.
    pub fn of_rows(&self, robot: &Robot, of_joints: &[Expr<'g>]) -> Vec<Expr<'g>> {
        let of_row = |i: usize| match &self.follows[i] {
            Some(follows) => follows.factor * of_joints[robot.joint_of(follows.leader)],
            None if robot.rows[i].locked.is_some() => self.graph.zero(),
            None => of_joints[robot.joint_of(i)],
        };
        (0..robot.rows.len()).map(of_row).collect()
    }

    /// The leader's row of a follower, and its factor.
    pub fn followed(&self, i: usize) -> Option<(usize, Expr<'g>)> {
        let follows = self.follows[i].as_ref()?;
        Some((follows.leader, follows.factor))
    }

    /// A direction in which, besides, the position of row i's joint changes at a rate: s' = c q',
    /// c' = -s q'. A joint that is locked does not move, and one that follows another moves with that one.
    pub fn along_position(
        &self,
        direction: Direction<'g>,
        i: usize,
        rate: Expr<'g>,
    ) -> Direction<'g> {
        let joint = self.joint(i);
        if joint.qd.is_zero() || self.follows[i].is_some() {
            return direction;
        }
        let direction = turning(direction, joint.sin_cos, rate).with(joint.q, rate);
        // Where a follower has a sine of its own, that changes too: rates of anything else than symbols
        // are never asked for.
        let follows = self.follows.iter().zip(&self.joints);
        let followers = follows.filter_map(|(follows, joint)| Some((follows.as_ref()?, joint)));
        let own = followers.filter(|(follows, _)| follows.leader == i);
        own.fold(direction, |direction, (follows, joint)| {
            turning(direction, joint.sin_cos, follows.factor * rate)
        })
    }

    /// Sine and cosine of q_i + theta (revolute) or of theta (prismatic). The
    /// constant, a follower's offset with it, rotates the sine and cosine of q: added to q it would cost
    /// digits where q is large.
    pub fn joint_sin_cos(
        &mut self,
        i: usize,
        joint_type: JointType,
        theta: &Value,
    ) -> (Expr<'g>, Expr<'g>) {
        let constant = self.constant_sin_cos(i, joint_type, theta);
        match joint_type {
            JointType::Prismatic => constant,
            JointType::Revolute => turned(self.joints[i].sin_cos, constant),
        }
    }

    /// Of the angle of row i what is constant: theta, and the offset of an angle that follows another.
    pub fn constant_sin_cos(
        &mut self,
        i: usize,
        joint_type: JointType,
        theta: &Value,
    ) -> (Expr<'g>, Expr<'g>) {
        let follows = self.follows[i].as_ref();
        let offset = follows.map(|follows| (follows.offset.clone(), follows.is_mounted));
        match (joint_type, offset) {
            (JointType::Prismatic, _) | (_, None) => self.sin_cos(theta),
            (_, Some((offset, false))) => self.sin_cos(&(theta.clone() + offset)),
            (_, Some((offset, true))) => turned(self.sin_cos(theta), self.sin_cos(&offset)),
        }
    }
}

/// Sine and cosine of the sum of two angles.
fn turned<'g>((s, c): Circle<'g>, (sk, ck): Circle<'g>) -> Circle<'g> {
    (s * ck + c * sk, c * ck - s * sk)
}

/// A direction in which, besides, a point of the circle turns at a rate.
fn turning<'g>(
    direction: Direction<'g>,
    (s, c): (Expr<'g>, Expr<'g>),
    rate: Expr<'g>,
) -> Direction<'g> {
    direction.with(s, c * rate).with(c, -(s * rate))
}

/// The factor, where it is a whole number of which no sine is needed.
fn whole(factor: &Value) -> Option<i64> {
    let factor = factor.as_rational()?;
    let mut multiples = (-LARGEST_MULTIPLE..=LARGEST_MULTIPLE).filter(|n| *n != 0);
    multiples.find(|n| Rational::from(*n) == *factor)
}

/// Sine and cosine of n times an angle, n not zero.
fn multiple<'g>((s, c): (Expr<'g>, Expr<'g>), n: i64) -> (Expr<'g>, Expr<'g>) {
    let (sn, cn) = (1..n.abs()).fold((s, c), |of_less, _| turned(of_less, (s, c)));
    if n < 0 { (-sn, cn) } else { (sn, cn) }
}

impl<'g> Interpretation for Symbols<'g> {
    type Number = Expr<'g>;

    fn rational(&mut self, x: &Rational) -> Expr<'g> {
        self.graph.rational(x)
    }

    fn pi(&mut self) -> Expr<'g> {
        self.pi
    }

    fn field(&mut self, index: usize) -> Expr<'g> {
        self.fields[index]
    }

    fn quotient(&mut self, a: Expr<'g>, b: Expr<'g>) -> Expr<'g> {
        a / b
    }

    fn circle(&mut self, angle: &Value) -> (Expr<'g>, Expr<'g>) {
        if let Some((_, s, c)) = self.angles.iter().find(|(known, ..)| known == angle) {
            return (*s, *c);
        }
        let opposite = -angle.clone();
        if let Some((_, s, c)) = self.angles.iter().find(|(known, ..)| *known == opposite) {
            return (-*s, *c);
        }
        let level = if angle.is_number() {
            Level::Constant
        } else {
            Level::Parameter
        };
        let (s, c) = self.graph.circle(level);
        self.meanings.extend([
            Symbol::AngleSine(angle.clone()),
            Symbol::AngleCosine(angle.clone()),
        ]);
        self.angles.push((angle.clone(), s, c));
        (s, c)
    }
}
