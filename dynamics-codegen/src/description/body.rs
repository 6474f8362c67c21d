//! Bodies, and the frames in which they are.

use dynamics_symbolic::robot;

use super::allow::Allow;
use super::value::{Expr, Given, Name, Part, Vector};
use crate::place::Place;

/// `{ xyz: [x, y, z], rpy: [roll, pitch, yaw] }`
#[derive(Debug, Default)]
pub struct Placement {
    /// The frame's origin, m.
    pub xyz: Given<Vector>,
    /// Its angles, rad.
    pub rpy: Given<Vector>,
}

/// The base of a robot.
#[derive(Debug)]
pub enum Base {
    /// `{ xyz, rpy }`: it stands there.
    Standing(Placement),
    /// `floating { mass, com, inertia }`: it moves with this body. The place is that of the word.
    Floating(Place, Body),
}

/// `{ xyz, rpy, mass, com, inertia }`
#[derive(Debug, Default)]
pub struct Tool {
    /// Its frame in the last link's.
    pub placement: Placement,
    /// The body that is fixed to it.
    pub body: Body,
}

/// The link that carries a joint or a frame.
#[derive(Clone, Debug)]
pub enum Link {
    /// As it is written: the row of that joint, or `base`.
    Named(Name),
    /// The link of the row of this index, or the base: a file knows which.
    Row(Option<usize>),
}

/// `left_hand: { on: left_elbow, xyz, rpy, mass, com, inertia }`
#[derive(Debug, Default)]
pub struct Frame {
    /// The frame's name; none if it could not be read.
    pub name: Option<Name>,
    /// The link that carries it.
    pub on: Given<Link>,
    /// The frame in that link frame.
    pub placement: Placement,
    /// Where a file has the frame in that link frame, before `placement`: each place in the one before it.
    pub places: Vec<robot::Placement>,
    /// The body that is fixed to it.
    pub body: Body,
    /// Whether it is a link of a file, which no function has to name.
    pub is_link: bool,
}

impl Frame {
    /// The frame's name; empty if it could not be read.
    pub(crate) fn word(&self) -> &str {
        self.name.as_ref().map_or("", Name::plain)
    }
}

/// The body of a link, of the tool or of a frame.
#[derive(Debug, Default)]
pub struct Body {
    /// Its mass, kg.
    pub mass: Given<Expr>,
    /// Its centre of mass in the frame of the link or tool, m.
    pub com: Given<Vector>,
    /// Its inertia about the centre of mass.
    pub inertia: Given<Inertia>,
    /// The same about the frame's origin, in place of `inertia`.
    pub inertia_at_origin: Given<Tensor>,
    /// Odd values that are accepted, there and in the rest of the row.
    pub allow: Given<Allow>,
}

impl Body {
    /// Whether anything of it is written.
    pub(crate) fn is_written(&self) -> bool {
        let has_tensor = !self.inertia.is_absent() || !self.inertia_at_origin.is_absent();
        has_tensor || !self.mass.is_absent() || !self.com.is_absent()
    }

    /// Makes a mass and a centre of mass that were left out unreadable.
    pub(crate) fn doubt(&mut self) {
        self.mass.doubt();
        self.com.doubt();
    }

    /// Where the first of its cells is, as far as they could be read; `allow` is none of them.
    #[cfg(feature = "files")]
    pub(crate) fn place(&self) -> Option<Place> {
        let com = self.com.value().and_then(|com| com.iter().flatten().next());
        let inertia = self.inertia.value().map(|inertia| match inertia {
            Inertia::Tensor(tensor) => tensor.place,
            Inertia::Solid(place, ..) => *place,
        });
        let at_origin = self.inertia_at_origin.value().map(|tensor| tensor.place);
        let mass = self.mass.value().map(|mass| mass.place);
        let com = com.map(|x| x.place);
        mass.or(com).or(inertia).or(at_origin)
    }
}

impl Base {
    /// The body of a base that moves, and where that is said.
    pub fn floating(&self) -> Option<(Place, &Body)> {
        match self {
            Base::Standing(_) => None,
            Base::Floating(place, body) => Some((*place, body)),
        }
    }
}

/// The entries xx, yy, zz, xy, yz, xz of a tensor.
pub type Tensor = Box<Part<6>>;

/// The value of the cell `inertia`.
#[derive(Debug)]
pub enum Inertia {
    /// `{ xx, yy, zz, xy, yz, xz }`
    Tensor(Tensor),
    /// `cuboid(x, y, z)` and the like, and where it stands.
    Solid(Place, Solid, Vec<Option<Expr>>),
}

/// A homogeneous solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Solid {
    /// Edges x, y, z.
    Cuboid,
    /// Radius and length, along that axis.
    Cylinder(Axis),
    /// Length, along that axis; slender.
    Rod(Axis),
    /// Radius.
    Sphere,
}

/// An axis of a link's frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Axis {
    /// x
    X,
    /// y
    Y,
    /// z
    Z,
}
