//! Integration by steps of equal length.

use super::Cause;
use super::trajectory::Recorder;
use crate::integrate::Phase;

/// Makes steps of up to `longest` to the end of the recorder's plan.
pub(super) fn fixed_step<const N: usize>(
    recorder: &mut Recorder<N>,
    longest: f64,
    step: impl Fn(f64, &Phase<N>, f64) -> Result<Phase<N>, Cause>,
) -> Result<(), Cause> {
    let per_sample = steps_per_interval(recorder.interval(), longest);
    let h = recorder.interval() / per_sample as f64;
    recorder.sample();
    while let Some(end) = recorder.next_sample() {
        let start = recorder.t;
        for i in 0..per_sample {
            let phase = step(recorder.t, &recorder.phase, h)?;
            if let Some(joint) = phase.first_non_finite() {
                return Err(Cause::NonFiniteState { joint });
            }
            // Not a sum of steps, whose roundings add up.
            let t = start + (i + 1) as f64 * h;
            recorder.reach(t, phase);
        }
        recorder.reach(end, recorder.phase);
        recorder.sample();
    }
    Ok(())
}

/// The least number of steps up to `longest` in an interval. A quotient that is whole but for its
/// rounding is whole.
fn steps_per_interval(interval: f64, longest: f64) -> u64 {
    let quotient = interval / longest;
    let whole = quotient.round();
    let steps = if (quotient - whole).abs() <= 1e-9 * whole {
        whole
    } else {
        quotient.ceil()
    };
    steps.max(1.0) as u64
}

#[cfg(test)]
mod tests {
    use super::steps_per_interval;

    #[test]
    fn whole_numbers_of_steps_survive_rounding() {
        assert_eq!(steps_per_interval(0.2, 1e-3), 200);
        assert_eq!(steps_per_interval(0.3, 0.1), 3);
        assert_eq!(steps_per_interval(10.0 / 3.0, 1e-4), 33_334);
        assert_eq!(steps_per_interval(0.1, 0.3), 1);
        assert_eq!(steps_per_interval(1.0, 0.3), 4);
    }
}
