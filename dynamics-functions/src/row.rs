//! The properties of a function: the columns of the table.

use super::{Argument, Function, Shape};

/// A row of the table of functions.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// The name of the generated method.
    pub name: &'static str,
    /// Its arguments after `&self`, in order.
    pub arguments: &'static [Argument],
    /// The arrangement of its values.
    pub shape: Shape,
    /// Whether it solves with M, and returns an error where M is singular.
    pub refuses: bool,
    /// The description with the unit and other names: the first line of the documentation. `{frame}` stands for the frame
    /// to which poses refer, `{tip}` for the frame whose pose it is: the base frame and the last link
    /// frame, unless the table has a base and a tool.
    pub description: &'static str,
    /// The unit of its values, of joints that turn and of joints that slide, if all have the same.
    pub unit: Option<[&'static str; 2]>,
    /// The letter of its values in the formulas of small arms, where these are shown.
    pub symbol: Option<&'static str>,
    /// Whether it is generated without being requested.
    pub set: Set,
    /// The trait of the runtime for this function alone, if it has one: functions that can also be evaluated with
    /// given sines, and Taylor series. All others implement the runtime's trait `Function`.
    pub provided: Option<&'static str>,
    /// Another form, besides the recursion that is made for this function.
    pub second: Option<Second>,
    /// How the gauge is chosen (see `derive::gauge`).
    pub search: Search,
    /// How many operations it has.
    pub growth: Growth,
    /// How it depends on masses.
    pub masses: Masses,
    /// Whether it is about the tip.
    pub of_tip: bool,
    /// The other factor, if only the product of both functions can be compared with Newton-Euler.
    pub compared_with: Option<Function>,
    /// Whether the values on a base that moves depend on where that stands: they do not if everything turns with it.
    pub reads_base: bool,
}

/// The tables for which a function is generated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Set {
    /// In the default set.
    Default,
    /// In the default set of a table with friction.
    WithFriction,
    /// Only if it is requested by name.
    ByName,
}

/// How a function is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// By the recursion that is made for it; forward dynamics by factoring the mass matrix.
    Recursive,
    /// From other quantities: M qdd + V + G, the contraction of the Christoffel
    /// symbols, inverse dynamics at rest, or a regressor from partial velocities.
    Assembled,
    /// Forward dynamics by articulated bodies, without the mass matrix.
    Articulated,
    /// Gravity from the forces of which the columns of the mass matrix are made, and Coriolis forces from its
    /// composite bodies: short beside the mass matrix, which needs these anyway.
    Columns,
}

/// How a function depends on masses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Masses {
    /// Not at all: on the geometry, on springs and on friction alone.
    Unread,
    /// By the centre of mass of the complete arm: it divides by the arm's mass, and `neglect` does not change it.
    Center,
    /// By masses and tensors, so that `neglect` changes it.
    Inertia,
}

/// A second form, which may be shorter than the recursion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Second {
    /// The form.
    pub form: Form,
    /// The largest number of joints for which it is tried. Assembled motions grow with a higher power
    /// of the number of joints: they are shorter for up to three.
    pub up_to: usize,
    /// How the two are compared.
    pub trial: Trial,
}

/// How two forms of a function are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trial {
    /// By their shortest programs.
    Whole,
    /// By their shortest programs, unless one is longer by over a tenth before any search: their lengths grow
    /// differently with the number of joints.
    Promising,
    /// By their programs before these are simplified, because simplifying both would take too long.
    Unsimplified,
}

/// How the gauge of a function is chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Search {
    /// By counting the operations of the function.
    Own,
    /// By counting those of another function's recursion, the only part of this one that depends on the gauge.
    By(Function),
    /// Not at all: the function depends on the table alone.
    None,
    /// For accuracy: every link keeps its own parameters, and nothing is simplified.
    Accuracy,
}

/// How many operations a function has of a chain of n joints whose rows are full, as measured at 10 to 64 of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Growth {
    /// So many times n.
    Linear(usize),
    /// So many times its square.
    Square(usize),
    /// So many times its cube.
    Cube(usize),
}

impl Growth {
    /// Operations with so many joints, about.
    pub const fn operations(self, joints: usize) -> usize {
        match self {
            Growth::Linear(each) => each.saturating_mul(joints),
            Growth::Square(each) => each.saturating_mul(joints.saturating_pow(2)),
            Growth::Cube(each) => each.saturating_mul(joints.saturating_pow(3)),
        }
    }
}
