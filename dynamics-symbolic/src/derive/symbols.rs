//! The symbols of an arm's equations on a graph.

use super::rows::constant_turn;
use crate::exact::Rational;
use crate::expr::{Direction, Expr, Graph, Level};
use crate::function::Argument;
use crate::mechanism::{BaseRate, Joint, Law, Mechanism};
use crate::robot::{Angle, Coupling, Interpretation, PoseOfBase, Symbol, Value};
use crate::spatial::{AxisMotion, Turn};

/// The variables of one joint.
#[derive(Clone, Copy, Debug)]
pub struct JointSymbols<'g> {
    /// Sine and cosine of the position (revolute joints); of a follower, of the position less its offset.
    pub sin_cos: (Expr<'g>, Expr<'g>),
    /// Position; the constant one if the joint stands still, with no velocity, acceleration or force. A follower's
    /// position, velocity and acceleration are those of the joint it follows times the factor, and no
    /// force is applied to it.
    pub q: Expr<'g>,
    /// How far the joint moves for each unit of the free joint by which it moves: 1 for that one itself, 0 for a joint
    /// that stands still.
    pub factor: Expr<'g>,
    /// Velocity.
    pub qd: Expr<'g>,
    /// Acceleration: the rate of the velocity, and what the motion of the base adds.
    pub qdd: Expr<'g>,
    /// The rate of the velocity.
    pub rate: Expr<'g>,
    /// The acceleration that the motion of a base adds to its joints, D u: see `mechanism::base`.
    pub added: Expr<'g>,
    /// Force or torque.
    pub tau: Expr<'g>,
    /// Sign of the velocity.
    pub sign: Expr<'g>,
    /// exp(-(qd/v)^2), of joints whose friction falls with the velocity.
    pub stribeck: Option<Expr<'g>>,
}

/// The symbols of an arm on a graph.
#[derive(Clone)]
pub struct Symbols<'g> {
    graph: &'g Graph,
    arm: &'g Mechanism,
    meanings: Vec<Symbol>,
    pi: Expr<'g>,
    fields: Vec<Expr<'g>>,
    angles: Vec<(Value, Expr<'g>, Expr<'g>)>,
    joints: Vec<JointSymbols<'g>>,
    entries: Vec<((Argument, usize), Expr<'g>)>,
    /// Rotation by rows and position of a base that moves.
    base: Option<PoseOfBase<Expr<'g>>>,
}

type Circle<'g> = (Expr<'g>, Expr<'g>);

/// Whole factors up to this one have no sine of their own: that of a multiple of an angle is a polynomial
/// in sine and cosine of the angle, four products and two sums for each step, and what it cancels with is
/// found.
const LARGEST_MULTIPLE: i64 = 3;

impl<'g> Symbols<'g> {
    /// Makes the symbols of an arm.
    pub fn new(graph: &'g Graph, arm: &'g Mechanism) -> Self {
        let mut meanings = vec![Symbol::Pi];
        let pi = graph.symbol(Level::Constant);
        let fields = (0..arm.fields)
            .map(|i| {
                meanings.push(Symbol::Field(i));
                graph.symbol(Level::Parameter)
            })
            .collect();
        let mut symbols = Symbols {
            graph,
            arm,
            meanings,
            pi,
            fields,
            angles: Vec::new(),
            joints: Vec::with_capacity(arm.joints.len()),
            entries: Vec::new(),
            base: None,
        };
        for joint in &arm.joints {
            let variables = match &joint.law {
                Law::Free { number } => symbols.free_joint(*number, joint),
                Law::Base { number } => symbols.joint_of_base(*number),
                Law::Standing { at } => symbols.standing_joint(joint.axis_motion, at),
                // Filled in below: the joint that leads may come later.
                Law::Following { .. } => symbols.standing_joint(joint.axis_motion, &Value::zero()),
            };
            symbols.joints.push(variables);
        }
        for (i, joint) in arm.joints.iter().enumerate() {
            if let Law::Following { number, coupling } = &joint.law {
                symbols.joints[i] = symbols.following_joint(joint, *number, coupling);
            }
        }
        if arm.freedoms().has_base() {
            symbols.add_motion_of_base();
            symbols.base = Some(symbols.new_pose(Argument::Base));
        }
        symbols
    }

    /// A number that is found on the way from a pose to the joints, in that place behind the entries of the pose.
    pub(crate) fn behind_target(&mut self, place: usize) -> Expr<'g> {
        self.entry(Argument::Pose, place)
    }

    /// The pose of a frame that is to be reached: symbols of a rotation by rows, and of a position.
    pub(crate) fn target(&mut self) -> PoseOfBase<Expr<'g>> {
        self.new_pose(Argument::Pose)
    }

    /// Adds the accelerations of the base's joints that come from the motion of the base itself.
    fn add_motion_of_base(&mut self) {
        let u = core::array::from_fn(|k| self.joints[k].qd);
        let added = self.base_rate().times(u);
        for (joint, added) in self.joints.iter_mut().zip(added) {
            joint.added = added;
            joint.qdd = joint.rate + added;
        }
    }

    /// D of the velocity of a base that moves.
    pub(crate) fn base_rate(&self) -> BaseRate<Expr<'g>> {
        BaseRate([3, 4, 5].map(|k| self.joints[k].qd))
    }

    fn new_pose(&mut self, argument: Argument) -> PoseOfBase<Expr<'g>> {
        let rotation = self.graph.rotation(Level::Variable);
        let meanings = (0..9).map(|k| Symbol::Entry(argument, k));
        self.meanings.extend(meanings);
        let position = [9, 10, 11].map(|k| self.variable(Symbol::Entry(argument, k)));
        (rotation, position)
    }

    /// The accelerations of all joints if the velocities are constant: those that the motion of the base adds.
    pub(crate) fn still(&self) -> Vec<Expr<'g>> {
        self.all(|joint| joint.added)
    }

    /// The variables of a joint that follows another one, with symbols of that number.
    fn following_joint(
        &mut self,
        joint: &Joint,
        number: usize,
        coupling: &Coupling,
    ) -> JointSymbols<'g> {
        let factor = self.value(&coupling.factor);
        let leader = self.joints[coupling.leader];
        let sin_cos = match (
            joint.axis_motion,
            self.arm.joints[coupling.leader].axis_motion,
        ) {
            (AxisMotion::Slides, _) => (self.graph.zero(), self.graph.one()),
            (AxisMotion::Turns, AxisMotion::Turns) => {
                let known = whole(&coupling.factor).map(|n| multiple(leader.sin_cos, n));
                known.unwrap_or_else(|| self.circle_of(number))
            }
            (AxisMotion::Turns, AxisMotion::Slides) => self.circle_of(number),
        };
        let sign = match coupling.sign() {
            Some(1) => leader.sign,
            Some(_) => -leader.sign,
            None => self.variable(Symbol::VelocitySign(number)),
        };
        let stribeck = joint.forces.stribeck.as_ref();
        JointSymbols {
            sin_cos,
            q: factor * leader.q + self.value(&coupling.offset),
            factor,
            qd: factor * leader.qd,
            qdd: factor * leader.qdd,
            rate: factor * leader.qdd,
            added: self.graph.zero(),
            tau: self.graph.zero(),
            sign,
            stribeck: stribeck.map(|_| self.variable(Symbol::Stribeck(number))),
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

    /// The variables of a joint that moves by itself, of that number among those that do.
    fn free_joint(&mut self, number: usize, joint: &Joint) -> JointSymbols<'g> {
        let stribeck = joint.forces.stribeck.as_ref();
        let sin_cos = self.circle_of(number);
        let q = self.variable(Symbol::Position(number));
        let qd = self.variable(Symbol::Velocity(number));
        let rate = self.variable(Symbol::Acceleration(number));
        JointSymbols {
            sin_cos,
            q,
            factor: self.graph.one(),
            qd,
            qdd: rate,
            rate,
            added: self.graph.zero(),
            tau: self.variable(Symbol::Force(number)),
            sign: self.variable(Symbol::VelocitySign(number)),
            stribeck: stribeck.map(|_| self.variable(Symbol::Stribeck(number))),
        }
    }

    /// The joint of that number among those of a base that moves: it stands at zero.
    fn joint_of_base(&mut self, number: usize) -> JointSymbols<'g> {
        let rate = self.variable(Symbol::Acceleration(number));
        JointSymbols {
            factor: self.graph.one(),
            qd: self.variable(Symbol::Velocity(number)),
            qdd: rate,
            rate,
            tau: self.variable(Symbol::Force(number)),
            ..self.standing_joint(AxisMotion::Slides, &Value::zero())
        }
    }

    /// A joint that stands still: everything about it is constant.
    fn standing_joint(&mut self, axis_motion: AxisMotion, at: &Value) -> JointSymbols<'g> {
        let zero = self.graph.zero();
        let angle = match axis_motion {
            AxisMotion::Turns => at,
            AxisMotion::Slides => &Value::zero(),
        };
        JointSymbols {
            sin_cos: self.sin_cos(angle),
            q: self.value(at),
            factor: zero,
            qd: zero,
            qdd: zero,
            rate: zero,
            added: zero,
            tau: zero,
            sign: zero,
            stribeck: None,
        }
    }

    /// The graph.
    pub fn graph(&self) -> &'g Graph {
        self.graph
    }

    /// The arm.
    pub(crate) fn arm(&self) -> &'g Mechanism {
        self.arm
    }

    /// The meaning of each symbol of the graph, in the order of the graph's symbols.
    pub fn meanings(&self) -> &[Symbol] {
        &self.meanings
    }

    /// The variables of joint i.
    pub fn joint(&self, i: usize) -> &JointSymbols<'g> {
        &self.joints[i]
    }

    /// One variable of every joint.
    pub fn all(&self, variable: impl Fn(&JointSymbols<'g>) -> Expr<'g>) -> Vec<Expr<'g>> {
        self.joints.iter().map(variable).collect()
    }

    /// An entry of another argument than q, qd, qdd and tau: a symbol from the first time on that it is
    /// requested.
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

    /// An argument as in [`Symbols::entry`] for every joint, as [`Symbols::of_all`] has it.
    pub fn entries(&mut self, argument: Argument) -> Vec<Expr<'g>> {
        let of_free: Vec<_> = (0..self.arm.dof())
            .map(|i| self.entry(argument, i))
            .collect();
        self.of_all(&of_free)
    }

    /// For every joint, of what is given for the free joints: the same times the factor of a follower, zero where
    /// a joint stands still.
    pub fn of_all(&self, of_free: &[Expr<'g>]) -> Vec<Expr<'g>> {
        let of_joint = |(i, joint): (usize, &JointSymbols<'g>)| match self.arm.moved_by(i) {
            Some((number, _)) => joint.factor * of_free[number],
            None => self.graph.zero(),
        };
        self.joints.iter().enumerate().map(of_joint).collect()
    }

    /// A direction in which, besides, the position of joint i changes at a rate: s' = c q', c' = -s q'. A joint that
    /// stands still does not move, and one that follows another moves with that one.
    pub fn along_position(
        &self,
        direction: Direction<'g>,
        i: usize,
        rate: Expr<'g>,
    ) -> Direction<'g> {
        let Law::Free { number } = self.arm.joints[i].law else {
            return direction;
        };
        let joint = self.joints[i];
        let direction = turning(direction, joint.sin_cos, rate).with(joint.q, rate);
        // Where a follower has a sine of its own, that changes too: rates of anything else than symbols
        // are never requested.
        let leader = |i: usize| self.arm.moved_by(i).map(|(leader, _)| leader);
        let own = self.arm.following().filter(|&i| leader(i) == Some(number));
        own.fold(direction, |direction, i| {
            let follower = &self.joints[i];
            turning(direction, follower.sin_cos, follower.factor * rate)
        })
    }

    /// The constant turn about the axis of joint i.
    pub(crate) fn constant_turn(&mut self, i: usize) -> Turn<Expr<'g>> {
        constant_turn(self, &self.arm.joints[i].aligned.turn)
    }

    /// Sine and cosine of the turn about the axis of joint i, q_i and the constant turn (revolute) or the latter
    /// (prismatic). The constant rotates the sine and cosine of q: added to q it would cost digits where q is large.
    pub(crate) fn turn(&mut self, i: usize) -> Turn<Expr<'g>> {
        let constant = self.constant_turn(i);
        match self.arm.joints[i].axis_motion {
            AxisMotion::Slides => constant,
            AxisMotion::Turns => turned(self.joints[i].sin_cos, (constant.s, constant.c)).into(),
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

    fn pose_of_base(&mut self) -> Option<PoseOfBase<Expr<'g>>> {
        self.base
    }

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
        let mut known = self.angles.iter();
        if let Some((_, s, c)) = known.find(|(known, ..)| Angle::are_opposite(known, angle)) {
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
