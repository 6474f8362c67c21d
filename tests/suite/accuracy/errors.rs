//! The largest error of each function of a robot.

use robots::Arm;

use super::states;

/// The largest relative error, in units of the number of joints.
const BOUND: f64 = 4e-15;

/// The largest errors of a robot's functions.
pub(super) struct Errors {
    robot: &'static str,
    joints: usize,
    functions: Vec<Worst>,
}

/// The largest error of a function, and the state where it occurs.
struct Worst {
    function: &'static str,
    error: f64,
    state: String,
}

impl Errors {
    pub(super) fn of<const N: usize, const P: usize, R: Arm<N, P>>(robot: &R) -> Self {
        let mut errors = Errors {
            robot: R::FILE,
            joints: N,
            functions: Vec::new(),
        };
        for (state, quantities) in states(robot) {
            for quantity in quantities {
                errors.record(quantity.function, quantity.error(), &state);
            }
        }
        errors
    }

    fn record(&mut self, function: &'static str, error: f64, state: &str) {
        let known = self.functions.iter().position(|w| w.function == function);
        let index = known.unwrap_or(self.functions.len());
        if known.is_none() {
            self.functions.push(Worst {
                function,
                error: 0.0,
                state: String::new(),
            });
        }
        let worst = &mut self.functions[index];
        if error > worst.error {
            worst.error = error;
            worst.state = state.to_owned();
        }
    }

    /// The names of the functions, as a header of [`Errors::line`].
    pub(super) fn header(&self) -> String {
        let names = self.functions.iter().map(|w| format!(" {:>7}", w.function));
        format!("{:26}{}", "error / (1e-15 N)", names.collect::<String>())
    }

    /// The errors in units of 1e-15 N.
    pub(super) fn line(&self) -> String {
        let unit = 1e-15 * self.joints as f64;
        let errors = self
            .functions
            .iter()
            .map(|w| format!(" {:7.3}", w.error / unit));
        format!("{:26}{}", self.robot, errors.collect::<String>())
    }

    pub(super) fn beyond_the_bound(&self) -> impl Iterator<Item = String> {
        let bound = BOUND * self.joints as f64;
        (self.functions.iter())
            .filter(move |w| w.error > bound)
            .map(|w| {
                format!(
                    "{} {}: {:e} at {}",
                    self.robot, w.function, w.error, w.state
                )
            })
    }
}
