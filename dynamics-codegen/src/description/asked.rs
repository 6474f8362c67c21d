//! The functions that are requested.

use std::fmt;

use dynamics_symbolic::Function;
use dynamics_symbolic::function::{INVERSE_KINEMATICS, inverse_method};

use super::value::Name;
use crate::place::Place;
use crate::words::shortened;

/// One entry of `functions`.
#[derive(Clone, Debug)]
pub enum Asked {
    /// `default`: the default set.
    Default(Place),
    /// `jacobian`, or `jacobian(left_hand)`
    One(Wanted),
    /// `control_terms = (mass_matrix, gravity_vector)`
    Fused(Name, Vec<Wanted>),
    /// An entry that could not be read: the error has been reported.
    Unreadable,
}

/// A function that is requested by its name.
#[derive(Clone, Debug)]
pub struct Wanted {
    /// The function, or the one that is inverted.
    pub function: Function,
    /// Whether it is `inverse_kinematics`, the inverse of `forward_kinematics`.
    pub is_inverse: bool,
    /// The frame that it is about; none for the tip, and for a function that is about no frame.
    pub frame: Option<Name>,
    /// Where it is written.
    pub place: Place,
}

impl Wanted {
    /// The word by which it is requested.
    pub fn name(&self) -> &'static str {
        if self.is_inverse {
            INVERSE_KINEMATICS
        } else {
            self.function.name()
        }
    }

    /// The name of its method.
    pub(crate) fn method(&self) -> String {
        let frame = self.frame.as_ref().map(Name::plain);
        match frame {
            frame if self.is_inverse => inverse_method(frame),
            Some(frame) => self.function.name_of_frame(frame),
            None => self.function.name().to_owned(),
        }
    }
}

impl fmt::Display for Wanted {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let name = self.name();
        match &self.frame {
            None => f.write_str(name),
            Some(frame) => write!(f, "{name}({})", shortened(frame.plain())),
        }
    }
}
