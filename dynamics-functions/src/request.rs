//! Requests, each with one name: a function, or several whose values one method returns together.

use super::{Argument, Freedoms, Function, Sizes};
use core::ops::Range;

/// A name without the `r#` of a raw identifier.
pub fn plain(name: &str) -> &str {
    name.strip_prefix("r#").unwrap_or(name)
}

/// One method of the generated model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Request {
    /// The method's name, the `r#` of a raw identifier included.
    identifier: String,
    parts: Vec<Part>,
    is_tuple: bool,
    /// Whether the base of the robot moves.
    base_moves: bool,
}

/// A function whose values a method returns, by themselves or in a tuple.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Part {
    /// The function.
    pub function: Function,
    /// The frame that it is about, by its place among the robot's `frames`; `None` for the tip, and for a function that
    /// is about no frame.
    pub frame: Option<usize>,
}

impl Part {
    /// Whether the letter of the function's values means these alone in a tuple of such parts: no other one is the same
    /// function of another frame.
    pub fn has_letter_in(self, parts: &[Part]) -> bool {
        let same = |other: &&Part| other.function == self.function;
        parts.iter().filter(same).count() == 1
    }
}

impl From<Function> for Part {
    fn from(function: Function) -> Self {
        let frame = None;
        Part { function, frame }
    }
}

impl From<Function> for Request {
    fn from(function: Function) -> Self {
        Request {
            identifier: function.name().to_owned(),
            parts: vec![function.into()],
            is_tuple: false,
            base_moves: false,
        }
    }
}

impl Request {
    /// A function of a frame, which has this place among the robot's `frames`, and this name. The function's row must say
    /// `of_tip`. The method is `function_frame`.
    pub fn of_frame(function: Function, frame: usize, name: &str) -> Request {
        let frame = Some(frame);
        Request {
            identifier: function.name_of_frame(name),
            parts: vec![Part { function, frame }],
            is_tuple: false,
            base_moves: false,
        }
    }

    /// A method of this name, the `r#` of a raw identifier included, that returns the values of some functions as a tuple:
    /// two at least, all different, each of which [can be fused](Function::can_be_fused).
    pub fn fused<P: Into<Part>>(
        identifier: impl Into<String>,
        parts: impl IntoIterator<Item = P>,
    ) -> Request {
        Request {
            identifier: identifier.into(),
            parts: parts.into_iter().map(Into::into).collect(),
            is_tuple: true,
            base_moves: false,
        }
    }

    /// The same of a robot whose base moves: a function that reads where the base stands takes that first.
    pub fn on_moving_base(mut self) -> Request {
        self.base_moves = true;
        self
    }

    /// The name of the generated method, without the `r#` of a raw identifier.
    pub fn name(&self) -> &str {
        plain(&self.identifier)
    }

    /// The name of the generated method, the `r#` of a raw identifier included.
    pub fn identifier(&self) -> &str {
        &self.identifier
    }

    /// The name of the results, where they are handed in: of accelerations and torques that of the argument
    /// which they are elsewhere.
    pub fn result(&self) -> &str {
        match self.function() {
            Some(Function::InverseDynamics) => Argument::Force.name(),
            Some(Function::ForwardDynamics | Function::ForwardDynamicsAba) => {
                Argument::Acceleration.name()
            }
            _ => self.name(),
        }
    }

    /// The function, if the method is a function by its own name: neither of a frame nor one of several.
    pub fn function(&self) -> Option<Function> {
        match self.parts[..] {
            [
                Part {
                    function,
                    frame: None,
                },
            ] if !self.is_tuple => Some(function),
            _ => None,
        }
    }

    /// Whether the method returns a tuple of the values of its parts.
    pub fn is_tuple(&self) -> bool {
        self.is_tuple
    }

    /// The functions whose values are returned, in the order of the tuple.
    pub fn parts(&self) -> &[Part] {
        &self.parts
    }

    /// The functions of the parts, without their frames.
    pub fn functions(&self) -> impl Iterator<Item = Function> {
        self.parts.iter().map(|part| part.function)
    }

    /// The arguments of the generated method after `&self`: of one function its own, of several those of all parts in the
    /// order of [`Argument`].
    pub fn arguments(&self) -> Vec<Argument> {
        let of_function = |function: Function| {
            let base = (self.base_moves && function.reads_base()).then_some(Argument::Base);
            base.into_iter().chain(function.arguments().iter().copied())
        };
        let mut arguments: Vec<_> = self.functions().flat_map(of_function).collect();
        if self.is_tuple {
            arguments.sort();
            arguments.dedup();
        }
        arguments
    }

    /// Whether one of the parts solves with M, and refuses where M is singular.
    pub fn refuses(&self) -> bool {
        self.functions().any(|function| function.row().refuses)
    }

    /// Whether a part is about the base inertial parameters.
    pub fn is_about_base_parameters(&self) -> bool {
        self.functions().any(Function::is_about_base_parameters)
    }
}

/// The sizes in the shapes of functions, of so many joints and with so many outputs in one program.
pub fn sizes_of(parts: &[Part], freedoms: impl Into<Freedoms>, outputs: usize) -> Sizes {
    let count = |sizes| parts.iter().map(|part| part.function.outputs(sizes)).sum();
    Sizes::with_count(freedoms.into(), outputs, count)
}

/// The outputs of each of some functions among those of one program, in which one function stands after the other.
pub fn spans(parts: &[Part], freedoms: impl Into<Freedoms>, outputs: usize) -> Vec<Range<usize>> {
    let sizes = sizes_of(parts, freedoms, outputs);
    let mut start = 0;
    let span = |part: &Part| {
        let end = start + part.function.outputs(sizes);
        let span = start..end;
        start = end;
        span
    };
    parts.iter().map(span).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fused(parts: &[Function]) -> Request {
        Request::fused("together", parts.iter().copied())
    }

    #[test]
    fn a_method_of_a_frame_has_its_name_in_lower_case() {
        let of_frame = |name: &str| Request::of_frame(Function::Jacobian, 2, name);
        for (frame, method) in [
            ("left_hand", "jacobian_left_hand"),
            ("Left-Hand 2", "jacobian_left_hand_2"),
            ("Bügel", "jacobian_b_gel"),
        ] {
            assert_eq!(of_frame(frame).name(), method);
        }
        let request = of_frame("tip");
        assert_eq!((request.function(), request.is_tuple()), (None, false));
        assert_eq!(request.parts()[0].frame, Some(2));
        assert_eq!(request.arguments(), [Argument::Position]);
        let request = Request::from(Function::Jacobian);
        assert_eq!(request.function(), Some(Function::Jacobian));
    }

    #[test]
    fn arguments_are_those_of_all_parts_in_one_order() {
        use Argument::{Acceleration, Force, Position, Velocity};
        let request = fused(&[Function::ForwardDynamics, Function::FrictionVector]);
        assert_eq!(request.arguments(), [Position, Velocity, Force]);
        assert!(request.refuses());
        let request = fused(&[Function::FrictionVector, Function::InverseDynamics]);
        assert_eq!(request.arguments(), [Position, Velocity, Acceleration]);
        assert!(!request.refuses());
        let request = fused(&[Function::ForwardDynamics, Function::InverseDynamics]);
        assert_eq!(
            request.arguments(),
            [Position, Velocity, Acceleration, Force]
        );
    }

    /// Pivots and the diagonal of M stand behind the values of the part that is solved for.
    #[test]
    fn outputs_stand_one_part_after_the_other() {
        let parts = [
            Function::MassMatrix,
            Function::ForwardDynamics,
            Function::GravityVector,
        ]
        .map(Part::from);
        assert_eq!(spans(&parts, 2, 12), [0..4, 4..10, 10..12]);
        let parts = [Function::KineticEnergy, Function::Regressor].map(Part::from);
        assert_eq!(spans(&parts, 2, 11), [0..1, 1..11]);
        assert_eq!(sizes_of(&parts, 2, 11).parameters, 5);
    }

    #[test]
    fn what_is_written_over_series_or_for_accuracy_stands_alone() {
        let apart = Function::ALL.into_iter().filter(|f| !f.can_be_fused());
        let apart: Vec<_> = apart.collect();
        assert_eq!(
            apart,
            [Function::ForwardDynamicsAba, Function::TaylorSeries]
        );
    }
}
