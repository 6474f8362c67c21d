//! What there is to say of a function.

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
    /// Whether it solves with M, and refuses where M is singular.
    pub refuses: bool,
    /// What it is, with its unit and other names: the first line of the documentation. `{frame}` and
    /// `{tip}` stand for the frames that poses are told in and about: the base frame and the last link
    /// frame, where the table says nothing else.
    pub description: &'static str,
    /// The letter of its values in the formulas of small arms, where these are shown.
    pub symbol: Option<&'static str>,
    /// Whether it is generated without being asked for.
    pub set: Set,
    /// The runtime's trait of its own whose methods hold its program: functions that are also evaluated
    /// with sines that are known, and Taylor series. All others are implementations of `Function`.
    pub provided: Option<&'static str>,
    /// Another way of writing it beside the recursion that is made for it.
    pub second: Option<Second>,
    /// How the gauge is chosen in which it is written.
    pub search: Search,
    /// How its length grows with the number of joints.
    pub growth: Growth,
    /// Whether it depends on masses and tensors: what is neglected changes it.
    pub reads_inertia: bool,
    /// The other factor, where only a product can be compared with Newton-Euler.
    pub compared_with: Option<Function>,
}

/// Where a function is generated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Set {
    /// For every table that asks for no functions by name.
    Default,
    /// For those of them where a row has friction.
    WithFriction,
    /// Where it is asked for.
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
    /// Gravity from the forces that the columns of the mass matrix are made of, and Coriolis forces from its
    /// composite bodies: short where these are computed in any case.
    Columns,
}

/// A second form, which may be shorter than the recursion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Second {
    /// The form.
    pub form: Form,
    /// The largest number of joints for which it may be. Assembled motions grow with a higher power
    /// of the number of joints: they win for up to three.
    pub up_to: usize,
    /// How the two are compared.
    pub trial: Trial,
}

/// How two forms of a function are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trial {
    /// By their shortest programs.
    Whole,
    /// So too, unless one is longer by over a tenth before any search: they differ by the number of
    /// joints, the more the longer the arm.
    Promising,
    /// Before they are simplified, for that takes long.
    Unsimplified,
}

/// How the gauge of a function is chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Search {
    /// By the operations of the function.
    Own,
    /// By those of another function's recursion, which is all of it that depends on the gauge.
    By(Function),
    /// Not at all: it depends on the table alone.
    None,
    /// For accuracy: every link's own parameters, and nothing is simplified.
    Accuracy,
}

/// How the length of a function, or the time to derive it, grows with the number of joints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Growth {
    /// With its square at most.
    Moderate,
    /// Faster.
    Steep,
    /// With its cube, and so do its values.
    Cubic,
}
