//! Names of joints in errors.

use core::fmt;

/// A joint, counted from 0, and its name if that is known. It is shown as `joint 2 (elbow)`, counted from 1.
pub struct JointName<'n>(pub usize, pub Option<&'n str>);

impl fmt::Display for JointName<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "joint {}", self.0 + 1)?;
        match self.1 {
            Some(name) => write!(f, " ({name})"),
            None => Ok(()),
        }
    }
}
