//! The motion that a page shows at first.

use super::literal::{array, number, option};

/// Where the motions of a page begin and end. The page has its own in place of what is left out.
#[derive(Clone, Debug)]
pub struct Start {
    /// Positions of the joints at the start, rad or m.
    pub from: Option<Vec<f64>>,
    /// Positions at the end of the prescribed motion.
    pub to: Option<Vec<f64>>,
    /// Velocities at the start of free motion, six of a base that moves first.
    pub velocity: Option<Vec<f64>>,
    /// Where a base that moves is: position, m, then roll, pitch and yaw, rad.
    pub pose: Option<[f64; 6]>,
    /// The time of the motions, s.
    pub duration: f64,
}

impl Default for Start {
    fn default() -> Start {
        Start {
            from: None,
            to: None,
            velocity: None,
            pose: None,
            duration: 3.0,
        }
    }
}

impl Start {
    /// The entries of the page's script.
    pub(super) fn entries(&self) -> [(&'static str, String); 5] {
        let numbers = |values: &[f64]| array(values.iter().copied().map(number));
        let list = |values: &Option<Vec<f64>>| option(values.as_deref().map(numbers));
        [
            ("from", list(&self.from)),
            ("to", list(&self.to)),
            ("velocity", list(&self.velocity)),
            ("pose", option(self.pose.as_ref().map(|pose| numbers(pose)))),
            ("duration", number(self.duration)),
        ]
    }
}
