//! Requests, each with one name: a function, or several whose values one method returns together.

use super::{Argument, Function, Sizes};
use core::ops::Range;

/// One method of the generated model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Request {
    /// A function.
    One(Function),
    /// Several functions, as one program.
    Fused(Fused),
}

/// Functions whose values one method returns as a tuple.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fused {
    /// The method's name, the `r#` of a raw identifier included.
    pub name: String,
    /// The functions in the order of the tuple: two at least, all different, each of which
    /// [can be fused](Function::can_be_fused).
    pub parts: Vec<Function>,
}

impl From<Function> for Request {
    fn from(function: Function) -> Self {
        Request::One(function)
    }
}

impl Request {
    /// The name of the generated method, without the `r#` of a raw identifier.
    pub fn name(&self) -> &str {
        match self {
            Request::One(function) => function.name(),
            Request::Fused(fused) => {
                let name = fused.name.as_str();
                name.strip_prefix("r#").unwrap_or(name)
            }
        }
    }

    /// The name of the results, where they are handed in: of accelerations and torques that of the argument
    /// which they are elsewhere.
    pub fn result(&self) -> &str {
        match self {
            Request::One(Function::InverseDynamics) => Argument::Force.name(),
            Request::One(Function::ForwardDynamics | Function::ForwardDynamicsAba) => {
                Argument::Acceleration.name()
            }
            request => request.name(),
        }
    }

    /// The function, where it is one.
    pub fn function(&self) -> Option<Function> {
        match self {
            Request::One(function) => Some(*function),
            Request::Fused(_) => None,
        }
    }

    /// The functions whose values are returned.
    pub fn parts(&self) -> &[Function] {
        match self {
            Request::One(function) => core::slice::from_ref(function),
            Request::Fused(fused) => &fused.parts,
        }
    }

    /// The arguments of the generated method after `&self`: those of the parts, in the order of [`Argument`].
    pub fn arguments(&self) -> Vec<Argument> {
        if let Request::One(function) = self {
            return function.arguments().to_vec();
        }
        let parts = self.parts().iter();
        let mut arguments: Vec<_> = parts.flat_map(|part| part.arguments()).copied().collect();
        arguments.sort();
        arguments.dedup();
        arguments
    }

    /// Whether one of the parts solves with M, and refuses where M is singular.
    pub fn refuses(&self) -> bool {
        self.parts().iter().any(|part| part.row().refuses)
    }

    /// Whether a part is about the base inertial parameters.
    pub fn is_about_base_parameters(&self) -> bool {
        let mut parts = self.parts().iter();
        parts.any(|part| part.is_about_base_parameters())
    }
}

/// The sizes in the shapes of functions, of so many joints and with so many outputs in one program.
pub fn sizes_of(parts: &[Function], joints: usize, outputs: usize) -> Sizes {
    let count = |sizes| parts.iter().map(|part| part.outputs(sizes)).sum();
    Sizes::with_count(joints, outputs, count)
}

/// The outputs of each of some functions among those of one program, in which one function stands after the other.
pub fn spans(parts: &[Function], joints: usize, outputs: usize) -> Vec<Range<usize>> {
    let sizes = sizes_of(parts, joints, outputs);
    let mut start = 0;
    let span = |part: &Function| {
        let end = start + part.outputs(sizes);
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
        Request::Fused(Fused {
            name: "together".to_owned(),
            parts: parts.to_vec(),
        })
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
        ];
        assert_eq!(spans(&parts, 2, 12), [0..4, 4..10, 10..12]);
        let parts = [Function::KineticEnergy, Function::Regressor];
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
