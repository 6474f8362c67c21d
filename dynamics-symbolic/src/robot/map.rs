//! Tables with other cells: rounded, written as text, or only looked at.

use super::{
    Base, Body, Carrier, Coupling, Frame, JointType, Mount, Placement, Row, Spring, Stribeck, Tool,
    Value,
};

/// The kind of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// An angle by which a frame is turned: its quarter turns are exact.
    Angle,
    /// Another quantity.
    Number,
}

use Quantity::{Angle, Number};

/// Writes what is the same for each cell that every row has, in the order in which tables are written. In brackets are
/// cells of several values.
macro_rules! cells {
    ($($name:ident: $quantity:tt),*) => {
        impl Row {
            /// How many cells every row has. A program that writes out each of them asserts the number: the compiler then
            /// names it when there is another cell.
            pub const CELLS: usize = [$(stringify!($name)),*].len();

            /// A row of zeros: a link without mass in the place of the one before it.
            pub fn new(name: impl Into<String>, joint_type: JointType) -> Self {
                Row {
                    name: name.into(),
                    joint_type,
                    on: Carrier::Above,
                    at: Vec::new(),
                    $($name: cells!(@zero $quantity),)*
                    stribeck: None,
                    spring: None,
                    limits: None,
                    torque_limit: None,
                    velocity_limit: None,
                    locked: None,
                    mount: None,
                    follows: None,
                }
            }
        }

        impl<C> Row<C> {
            /// The row with a cell of another kind for each of its own.
            pub fn map<D>(&self, cell: &mut impl FnMut(&C, Quantity) -> D) -> Row<D> {
                let position = match self.joint_type {
                    JointType::Revolute => Angle,
                    JointType::Prismatic => Number,
                };
                Row {
                    name: self.name.clone(),
                    joint_type: self.joint_type,
                    on: self.on,
                    at: self.at.iter().map(|place| place.map(cell)).collect(),
                    $($name: cells!(@map cell, self.$name, $quantity),)*
                    stribeck: self.stribeck.as_ref().map(|of| Stribeck {
                        friction: cell(&of.friction, Number),
                        velocity: cell(&of.velocity, Number),
                    }),
                    spring: self.spring.as_ref().map(|of| Spring {
                        stiffness: cell(&of.stiffness, Number),
                        rest: cell(&of.rest, Number),
                    }),
                    limits: self.limits.as_ref().map(|of| cells!(@map cell, of, [Number])),
                    torque_limit: self.torque_limit.as_ref().map(|of| cell(of, Number)),
                    velocity_limit: self.velocity_limit.as_ref().map(|of| cell(of, Number)),
                    locked: self.locked.as_ref().map(|of| cell(of, position)),
                    mount: self.mount.as_ref().map(|of| of.map(cell)),
                    follows: self.follows.as_ref().map(|of| Coupling {
                        leader: of.leader,
                        factor: cell(&of.factor, Number),
                        offset: cell(&of.offset, position),
                    }),
                }
            }

            /// The names of the cells that every row has, and their values: one, or several of a vector or a tensor.
            pub fn cells(&self) -> impl Iterator<Item = (&'static str, &[C])> {
                [$((stringify!($name), cells!(@slice self.$name, $quantity))),*].into_iter()
            }
        }
    };
    (@zero [$quantity:ident]) => { core::array::from_fn(|_| Value::zero()) };
    (@zero $quantity:ident) => { Value::zero() };
    (@map $cell:ident, $values:expr, [$quantity:ident]) => {
        $values.each_ref().map(|value| $cell(value, $quantity))
    };
    (@map $cell:ident, $value:expr, $quantity:ident) => { $cell(&$value, $quantity) };
    (@slice $values:expr, [$quantity:ident]) => { &$values[..] };
    (@slice $value:expr, $quantity:ident) => { core::slice::from_ref(&$value) };
}

cells! {
    a: Number, alpha: Angle, d: Number, theta: Angle, mass: Number, com: [Number], inertia: [Number],
    motor_inertia: Number, gear_ratio: Number, viscous: Number, coulomb: [Number]
}

impl<C> Mount<C> {
    fn map<D>(&self, cell: &mut impl FnMut(&C, Quantity) -> D) -> Mount<D> {
        Mount {
            axis: self.axis.each_ref().map(|angle| cell(angle, Angle)),
            tip: self
                .tip
                .as_ref()
                .map(|tip| tip.iter().map(|place| place.map(cell)).collect()),
        }
    }
}

impl<C> Placement<C> {
    /// The place with a cell of another kind for each of its own.
    pub fn map<D>(&self, cell: &mut impl FnMut(&C, Quantity) -> D) -> Placement<D> {
        Placement {
            xyz: self.xyz.each_ref().map(|x| cell(x, Number)),
            rpy: self.rpy.each_ref().map(|angle| cell(angle, Angle)),
        }
    }
}

impl<C> Tool<C> {
    /// The tool with a cell of another kind for each of its own.
    pub fn map<D>(&self, cell: &mut impl FnMut(&C, Quantity) -> D) -> Tool<D> {
        Tool {
            placement: self.placement.map(cell),
            body: self.body.map(cell),
        }
    }
}

impl<C> Body<C> {
    /// The body with a cell of another kind for each of its own.
    pub fn map<D>(&self, cell: &mut impl FnMut(&C, Quantity) -> D) -> Body<D> {
        Body {
            mass: cell(&self.mass, Number),
            com: self.com.each_ref().map(|x| cell(x, Number)),
            inertia: self.inertia.each_ref().map(|x| cell(x, Number)),
        }
    }
}

impl<C> Base<C> {
    /// The base with a cell of another kind for each of its own.
    pub fn map<D>(&self, cell: &mut impl FnMut(&C, Quantity) -> D) -> Base<D> {
        match self {
            Base::Standing(placement) => Base::Standing(placement.map(cell)),
            Base::Floating(body) => Base::Floating(body.map(cell)),
        }
    }
}

impl<C> Frame<C> {
    /// The frame with a cell of another kind for each of its own.
    pub fn map<D>(&self, cell: &mut impl FnMut(&C, Quantity) -> D) -> Frame<D> {
        Frame {
            name: self.name.clone(),
            on: self.on,
            places: self.places.iter().map(|place| place.map(cell)).collect(),
            body: self.body.as_ref().map(|body| body.map(cell)),
        }
    }
}
