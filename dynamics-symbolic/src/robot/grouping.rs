//! Which inertial parameters of an arm its forces can tell apart.

use super::Parameter;

/// The inertial parameters that the forces can tell apart, link by link.
#[derive(Clone, Debug)]
pub struct Grouping {
    /// The links from the base outwards.
    pub links: Vec<LinkGrouping>,
}

/// The parameters that one link keeps.
#[derive(Clone, Debug)]
pub struct LinkGrouping {
    /// The link in whose axes the first moments are written, counted from 0: this one, or the last
    /// revolute one before a prismatic joint, where that one's axis is along none of this link's own.
    /// Its axis may be the only direction of rotation: the first moment along it then moves.
    pub axes: usize,
    /// The parameters that are kept, in order.
    pub kept: Vec<Parameter>,
    /// The parameters that are not kept, but also add to one that is.
    pub ties: Vec<Tie>,
    /// Where the joint's axis is that of the joint before.
    pub coincides: Option<Sense>,
}

/// One axis beside another on the same line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    /// They point the same way.
    Same,
    /// They point opposite ways.
    Opposite,
}

/// A parameter whose effect is that of another one, times a coefficient, beside what moves inwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tie {
    /// The parameter that is not kept.
    pub dropped: Parameter,
    /// The one that stands for it.
    pub kept: Parameter,
    /// The coefficient, its sign apart.
    pub coefficient: Coefficient,
    /// Whether the coefficient is negative.
    pub negative: bool,
}

/// The size of a coefficient.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coefficient {
    /// 1
    One,
    /// How far the link's origin is along the axis from where that meets the axis before.
    Height,
}

impl Grouping {
    /// How many base parameters there are.
    pub fn count(&self) -> usize {
        self.links.iter().map(|link| link.kept.len()).sum()
    }
}
