//! Joints that creep in steps of fixed length.
//!
//! A force that jumps at rest, such as dry friction by its sign, drives a joint back to rest from both sides. Steps of fixed
//! length jump across rest, and the joint keeps a velocity of the order of step times acceleration where it should stand. It
//! creeps if its velocity changed its sign there, stayed that small for some steps, and is still driven back.

use dynamics_runtime::Size;

use super::motion::Motion;
use super::recorder::Recorder;

/// The joints that are watched.
pub(super) struct Creep<D: Size> {
    /// Time and velocities at the end of the step before.
    before: Option<(f64, D::Vector)>,
    joints: D::Each<Watch>,
}

/// A joint that passed rest, and the steps since then.
#[derive(Clone, Copy, Debug, Default)]
struct Watch {
    /// The greatest speed of a joint that creeps; 0 if it does not.
    slow: f64,
    /// The steps until it is asked again.
    wait: u32,
}

/// A joint creeps if it is slow for so many steps.
const STEPS: u32 = 16;

impl<D: Size> Creep<D> {
    pub(super) fn new(size: D) -> Self {
        Creep {
            before: None,
            joints: size.each(|_| Watch::default()),
        }
    }

    /// Notes the joints that creep, after a step to where the recorder is.
    pub(super) fn after_step(&mut self, motion: &Motion<D>, recorder: &mut Recorder<D>) {
        let (t, qd) = (recorder.t, recorder.phase.qd.clone());
        let Some((since, before)) = self.before.replace((t, qd.clone())) else {
            return;
        };
        for i in motion.joints() {
            let watch = &mut self.joints[i];
            watch.wait = watch.wait.saturating_sub(1);
            if qd[i].abs() > watch.slow {
                watch.slow = 0.0;
            }
            let turns = watch.slow == 0.0 && before[i] * qd[i] < 0.0;
            if watch.wait > 0 || !(turns || watch.slow > 0.0) {
                continue;
            }
            let slow = motion.near_rest(t, &recorder.phase, i, t - since);
            if watch.slow > 0.0 && slow.is_some() {
                recorder.creeping.extend([i]);
            }
            watch.slow = slow.unwrap_or(0.0);
            watch.wait = STEPS;
        }
    }
}
