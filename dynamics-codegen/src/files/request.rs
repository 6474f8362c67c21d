//! Kinds of files, and the request of a call to one.

use std::path::Path;

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::Value;

use crate::description::{Allow, Name, Place};

/// A kind of file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// A table in the macro's words: `[[joint]]`, `a = 0.3`, `inertia = { yy = 0.35 }`.
    Toml,
    /// A table as it is published: `joints` with the cells `a`, `alpha`, `d`, `theta`, `mass`, `com`, `inertia`
    /// (xx, yy, zz, xy, yz, xz), `motor_inertia`, `gear_ratio`, `viscous`, `coulomb`. Where the file names its
    /// `source`, tensors that no body can have are taken as they are.
    Json,
    /// The Unified Robot Description Format: the tree of links, or the part of it that a [`Request`] names.
    Urdf,
}

impl Format {
    /// The format that the end of the name tells.
    pub fn of(path: &Path) -> Option<Format> {
        match path.extension()?.to_str()?.to_lowercase().as_str() {
            "toml" => Some(Format::Toml),
            "json" => Some(Format::Json),
            "urdf" => Some(Format::Urdf),
            _ => None,
        }
    }
}

/// A base that moves: the first link of a file is its body.
#[derive(Clone, Debug, Default)]
pub struct MovingBase {
    /// Where a body is written beside the file, which is a mistake.
    pub body: Option<Place>,
    /// Oddities that are accepted of the link.
    pub allow: Allow,
}

/// A request to a URDF file.
#[derive(Clone, Debug, Default)]
pub struct Request {
    /// The link at which the robot begins, and the tips to which its joints lead; without tips all that the link carries.
    /// The whole tree of the file, if it is left out.
    pub chain: Option<Vec<Name>>,
    /// Joints that are left out, with all that hangs on them. `rest`, where no joint has that name, is all joints
    /// beside the way to the tips that are not named, here and in `lock`.
    pub ignore: Vec<Name>,
    /// Joints that stand still, and where, or `rest`; no position is one that is not known here.
    pub lock: Vec<(Name, Option<Value>)>,
    /// Whether the base moves.
    pub base: Option<MovingBase>,
    /// How near an angle is to a multiple of a quarter turn that it is taken for, rad, and which share of an axis is zero.
    pub round_angles: Option<Rational>,
    /// Whether tensors that no body can have are accepted.
    pub unphysical_inertia: bool,
    /// Whether movable links without `<inertial>` are taken as massless.
    pub no_inertia: bool,
    /// Whether a file may say nothing of any inertia.
    pub may_be_geometry: bool,
    /// Whether angles of many turns are accepted, which are meant in degrees elsewhere.
    pub odd_angle: bool,
    /// Links whose bodies stand by themselves, on their frames.
    pub links: Vec<Name>,
    /// Joints for which more is accepted: angles of their placement, and tensors of what they carry.
    pub allow: Vec<(Name, Allow)>,
}

#[cfg(feature = "files")]
impl Request {
    /// The allowances of a joint, or of the base.
    pub(super) fn allowed(&self, joint: Option<&str>) -> Allow {
        let whole = Allow {
            unphysical_inertia: self.unphysical_inertia,
            odd_angle: self.odd_angle,
            ..Allow::default()
        };
        let Some(joint) = joint else {
            let own = self
                .base
                .as_ref()
                .map_or(Allow::default(), |base| base.allow);
            return whole.or(own);
        };
        let own = self.allow.iter().filter(|(name, _)| name.plain() == joint);
        own.fold(whole, |allowed, (_, allow)| allowed.or(*allow))
    }
}
