//! The energies of a unit of each base parameter.

use super::super::assignment::Number;
use super::pose::Pose;
use super::twist::{polar, twist};
use super::{Definition, Vector};

impl Definition {
    /// T of a unit of each base parameter, then U = -m g.p - g.R h with p from the origin of frame 0;
    /// `None` where the table's forces are not those of its parameters.
    pub(super) fn energy_regressors(&self) -> Option<Vector> {
        let kept = self.kept_parameters()?;
        let frames = self.joint_frames(&self.moving(&self.q, &self.qd));
        let places = self.joint_frames(&self.q);
        let (mut kinetic, mut potential) = (Vector::new(), Vector::new());
        for (link, frame) in frames.iter().enumerate() {
            let twist = twist(frame);
            let energies = polar(twist, twist).map(|twice| self.half * twice).to_vec();
            let axis = self.axes.iter().find(|axis| axis.row == link);
            let speed = axis.map_or(Number::ZERO, |axis| axis.speed(&self.qd));
            let of_motor = self.half * speed * speed;
            kinetic.extend(self.in_moment_axes(link, energies, of_motor));
            let weights = self.weights(&places[link]);
            potential.extend(self.in_moment_axes(link, weights, Number::ZERO));
        }
        let pick = |of_all: &Vector| -> Vector { kept.iter().map(|&k| of_all[k]).collect() };
        Some([pick(&kinetic), pick(&potential)].concat())
    }

    fn weights(&self, frame: &Pose<Number>) -> Vector {
        let mut weights = vec![Number::ZERO; 10];
        for k in 0..3 {
            weights[6 + k] = -self.gravity.dot(frame.rotation.column(k));
        }
        let origin = match &self.base {
            Some(base) => frame.origin - base.pose::<Number>().origin,
            None => frame.origin,
        };
        weights[9] = -self.gravity.dot(origin);
        weights
    }
}
