//! Steps of a motion by its Taylor series.

mod first_root;
mod numbers;
mod step_size;
mod stepper;

pub(crate) use first_root::Polynomial;
pub(crate) use step_size::{FEWEST_ORDERS, order};
pub(crate) use stepper::{Refusal, SeriesStepper, Steady};
