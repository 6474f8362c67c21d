//! Errors of computed values against exact ones.

use robot_dynamics::DoubleDouble;

/// An entry that is below this share of its scale at every state is identically zero: the exact
/// values carry rounding errors of 31 digits.
const ZERO: f64 = 1e-26;

/// The errors of a function over all states.
#[derive(Clone, Debug, Default)]
pub(crate) struct Errors {
    /// The largest error over the natural magnitude; infinite where a value is no number.
    pub(crate) largest: f64,
    /// The state at which it is.
    pub(crate) at: usize,
    /// The root of the mean of the squares.
    pub(crate) rms: f64,
    /// The largest relative error of a single entry, in bits: how many of the last of 53 bits are
    /// wrong.
    pub(crate) worst_bits: f64,
    /// The median of that over all entries and states.
    pub(crate) median_bits: f64,
    /// Values of entries that are identically zero.
    pub(crate) zeros: usize,
    /// The number of such values that are not 0.0.
    pub(crate) broken_zeros: usize,
}

/// The values of one state: computed, exact, and the errors that are relative to a scale.
pub(crate) struct AtState {
    pub(crate) computed: Vec<DoubleDouble>,
    pub(crate) exact: Vec<DoubleDouble>,
    /// The values that are judged beside the scale: the errors themselves, or values that follow from them.
    pub(crate) judged: Vec<f64>,
    pub(crate) scale: f64,
}

impl Errors {
    pub(crate) fn of(states: &[AtState]) -> Self {
        let mut errors = Errors::default();
        let judged = states.iter().enumerate().flat_map(|(at, state)| {
            let over = |error: f64| match error {
                0.0 => 0.0,
                error if error.is_nan() => f64::INFINITY,
                error => error.abs() / state.scale,
            };
            state.judged.iter().map(move |&error| (at, over(error)))
        });
        let (mut squares, mut count) = (0.0, 0);
        for (at, error) in judged {
            if error > errors.largest {
                (errors.largest, errors.at) = (error, at);
            }
            squares += error * error;
            count += 1;
        }
        errors.rms = (squares / f64::from(count)).sqrt();
        errors.entries(states);
        errors
    }

    fn entries(&mut self, states: &[AtState]) {
        let mut bits = Vec::new();
        for entry in 0..states[0].exact.len() {
            let vanishes = |state: &AtState| state.exact[entry].high().abs() <= ZERO * state.scale;
            if states.iter().all(vanishes) {
                let broken = |state: &&AtState| state.computed[entry].high() != 0.0;
                self.zeros += states.len();
                self.broken_zeros += states.iter().filter(broken).count();
                continue;
            }
            bits.extend(states.iter().filter(|state| !vanishes(state)).map(|state| {
                let error = (state.computed[entry] - state.exact[entry]).high().abs();
                wrong_bits(error / state.exact[entry].high().abs())
            }));
        }
        bits.sort_by(f64::total_cmp);
        self.worst_bits = bits.last().copied().unwrap_or(0.0);
        self.median_bits = bits.get(bits.len() / 2).copied().unwrap_or(0.0);
    }
}

/// How many of the last of 53 bits a relative error reaches.
fn wrong_bits(relative: f64) -> f64 {
    match relative {
        error if error.is_nan() => 53.0,
        error => (error / (f64::EPSILON / 2.0)).log2().clamp(0.0, 53.0),
    }
}
