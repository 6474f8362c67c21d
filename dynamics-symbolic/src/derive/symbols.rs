//! The symbols of a robot's equations on a graph.

use crate::exact::Rational;
use crate::expr::{Direction, Expr, Graph, Level};
use crate::function::Argument;
use crate::robot::{Interpretation, JointType, Robot, Row, Symbol, Value};

/// The variables of one joint.
#[derive(Clone, Copy, Debug)]
pub struct JointSymbols<'g> {
    /// Sine and cosine of the position (revolute joints).
    pub sin_cos: (Expr<'g>, Expr<'g>),
    /// Position; the cell where the joint is locked, with no velocity, acceleration or force.
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
    entries: Vec<((Argument, usize), Expr<'g>)>,
}

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
            entries: Vec::new(),
        };
        let mut moving = 0..;
        for row in &robot.rows {
            let joint = match &row.locked {
                Some(position) => symbols.locked_joint(row.joint_type, position),
                None => symbols.moving_joint(moving.next().unwrap_or_default(), row),
            };
            symbols.joints.push(joint);
        }
        symbols
    }

    /// The variables of joint i of those that move.
    fn moving_joint(&mut self, i: usize, row: &Row) -> JointSymbols<'g> {
        let (s, c) = self.graph.circle(Level::Variable);
        self.meanings.extend([Symbol::Sine(i), Symbol::Cosine(i)]);
        let mut variable = |meaning| {
            self.meanings.push(meaning);
            self.graph.symbol(Level::Variable)
        };
        JointSymbols {
            sin_cos: (s, c),
            q: variable(Symbol::Position(i)),
            qd: variable(Symbol::Velocity(i)),
            qdd: variable(Symbol::Acceleration(i)),
            tau: variable(Symbol::Force(i)),
            sign: variable(Symbol::VelocitySign(i)),
            stribeck: row
                .stribeck
                .is_some()
                .then(|| variable(Symbol::Stribeck(i))),
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

    /// Such an argument with an entry for the joint of every row, zero where the joint is locked.
    pub fn entries(&mut self, argument: Argument, robot: &Robot) -> Vec<Expr<'g>> {
        let mut moving = 0..;
        let mut entries = Vec::with_capacity(robot.rows.len());
        for row in &robot.rows {
            entries.push(match row.locked {
                Some(_) => self.graph.zero(),
                None => self.entry(argument, moving.next().unwrap_or_default()),
            });
        }
        entries
    }

    /// A direction in which, besides, the position of row i's joint changes at a rate: s' = c q',
    /// c' = -s q'. A joint that is locked does not move.
    pub fn along_position(
        &self,
        direction: Direction<'g>,
        i: usize,
        rate: Expr<'g>,
    ) -> Direction<'g> {
        let joint = self.joint(i);
        if joint.qd.is_zero() {
            return direction;
        }
        let (s, c) = joint.sin_cos;
        direction
            .with(s, c * rate)
            .with(c, -(s * rate))
            .with(joint.q, rate)
    }

    /// Sine and cosine of q_i + theta (revolute) or of theta (prismatic). The
    /// constant rotates the sine and cosine of q: added to q it would cost
    /// digits where q is large.
    pub fn joint_sin_cos(
        &mut self,
        i: usize,
        joint_type: JointType,
        theta: &Value,
    ) -> (Expr<'g>, Expr<'g>) {
        let (st, ct) = self.sin_cos(theta);
        match joint_type {
            JointType::Prismatic => (st, ct),
            JointType::Revolute => {
                let (s, c) = self.joints[i].sin_cos;
                (s * ct + c * st, c * ct - s * st)
            }
        }
    }
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
