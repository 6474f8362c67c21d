//! The functions that can be generated for a robot: one row of one table for each.
//!
//! A function is described by its [`Row`]. Its outputs and their definition are formulas, and stand where these are
//! derived and proven, in one exhaustive match each.

#![forbid(unsafe_code)]

mod argument;
mod batch;
mod items;
mod request;
mod row;
mod shape;
mod table;

pub use argument::Argument;
pub use batch::{Batch, batch_methods};
pub use items::{function_names, runtime_methods};
pub use request::{Part, Request, plain, sizes_of, spans};
pub use row::{Form, Growth, Masses, Row, Search, Second, Set, Trial};
pub use shape::{Freedoms, Shape, Size, Sizes};
pub use table::Function;

/// The word by which inverse kinematics in closed form are requested, and the name of the method. They are no row
/// of the table: their values are as many as there are solutions.
pub const INVERSE_KINEMATICS: &str = "inverse_kinematics";

/// The name of the method of inverse kinematics for a frame of this name, or for the tip.
pub fn inverse_method(frame: Option<&str>) -> String {
    match frame {
        Some(frame) => format!("{INVERSE_KINEMATICS}_{}", frame_in_methods(frame)),
        None => INVERSE_KINEMATICS.to_owned(),
    }
}

/// The methods about the elbow of seven joints: its angle, and its ranges within limits.
pub const ELBOW_METHODS: [&str; 2] = ["elbow_angle", "elbow_ranges"];

/// The name of one of these methods, for a frame of this name or for the tip.
pub fn elbow_method(name: &str, frame: Option<&str>) -> String {
    inverse_method(frame).replacen(INVERSE_KINEMATICS, name, 1)
}

/// The name of a frame in the names of methods: in lower case, with `_` for every character but a-z and 0-9.
pub fn frame_in_methods(frame: &str) -> String {
    let letter = |letter: char| match letter.to_ascii_lowercase() {
        letter @ ('a'..='z' | '0'..='9') => letter,
        _ => '_',
    };
    frame.chars().map(letter).collect()
}

impl Function {
    /// The name of the generated method.
    pub fn name(self) -> &'static str {
        self.row().name
    }

    /// The name of the method for a frame of this name: `jacobian_left_hand`.
    pub fn name_of_frame(self, frame: &str) -> String {
        format!("{}_{}", self.name(), frame_in_methods(frame))
    }

    /// The arguments of the generated method after `&self`, in order, on a base that stands.
    pub fn arguments(self) -> &'static [Argument] {
        self.row().arguments
    }

    /// Whether the method of a robot on a base that moves reads where the base stands.
    pub fn reads_base(self) -> bool {
        self.row().reads_base
    }

    /// The arrangement of the values.
    pub fn shape(self) -> &'static Shape {
        &self.row().shape
    }

    /// The name of the runtime's trait for the function, where there is one.
    pub fn trait_name(self) -> Option<&'static str> {
        self.row().provided
    }

    /// The function of that name.
    pub fn from_name(name: &str) -> Option<Function> {
        Function::ALL.into_iter().find(|f| f.name() == name)
    }

    /// The set that is generated where a table names no functions.
    pub fn default_set(has_friction: bool) -> Vec<Function> {
        let belongs = |function: &Function| match function.row().set {
            Set::Default => true,
            Set::WithFriction => has_friction,
            Set::ByName => false,
        };
        Function::ALL.into_iter().filter(belongs).collect()
    }

    /// The forms that may be the shortest for so many joints.
    pub fn forms(self, dof: usize) -> Vec<Form> {
        let second = self.row().second.filter(|second| dof <= second.up_to);
        let forms = [Some(Form::Recursive), second.map(|second| second.form)];
        forms.into_iter().flatten().collect()
    }

    /// Whether the values are those of the base inertial parameters, or belong to them one by one.
    pub fn is_about_base_parameters(self) -> bool {
        self.shape().has_parameters()
    }

    /// The sizes in the shape, of so many joints and with so many outputs that are values.
    pub fn sizes(self, freedoms: impl Into<Freedoms>, entries: usize) -> Sizes {
        Sizes::with_count(freedoms.into(), entries, |sizes| {
            self.shape().entries(sizes)
        })
    }

    /// Whether it divides by the mass of the arm.
    pub fn divides_by_mass(self) -> bool {
        self.row().masses == Masses::Center
    }

    /// Whether it depends on masses or tensors.
    pub fn reads_masses(self) -> bool {
        self.row().masses != Masses::Unread
    }

    /// How many outputs of a program are values. Pivots and the diagonal of M may follow.
    pub fn entries(self, freedoms: impl Into<Freedoms>, outputs: usize) -> usize {
        self.shape().entries(self.sizes(freedoms, outputs))
    }

    /// How many outputs a program has: the values, and the pivots and the diagonal of M where these follow.
    pub fn outputs(self, sizes: Sizes) -> usize {
        let pivots = usize::from(self.has_pivots()) * 2 * sizes.freedoms.all();
        self.shape().entries(sizes) + pivots
    }

    /// Whether its program can be shared with other functions: it is not if it is written over series,
    /// or as no search may change it.
    pub fn can_be_fused(self) -> bool {
        *self.shape() != Shape::Series && self.row().search != Search::Accuracy
    }

    /// Whether pivots and the diagonal of M follow the values: what is solved for fails by them.
    pub fn has_pivots(self) -> bool {
        self.row().refuses && *self.shape() != Shape::Series
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_different_and_found() {
        for function in Function::ALL {
            assert_eq!(Function::from_name(function.name()), Some(function));
        }
        assert_eq!(Function::from_name("mass"), None);
    }

    #[test]
    fn friction_is_in_the_default_set_where_there_is_some() {
        let (without, with) = (Function::default_set(false), Function::default_set(true));
        assert_eq!((without.len(), with.len()), (7, 8));
        assert!(with.contains(&Function::FrictionVector));
    }

    /// A function that fails by pivots has as many of them as joints, behind its values.
    #[test]
    fn values_are_counted() {
        let count = |function: Function, outputs| function.entries(3, outputs);
        assert_eq!(count(Function::ForwardDynamics, 9), 3);
        assert_eq!(count(Function::ForwardDynamicsDerivatives, 33), 27);
        assert_eq!(count(Function::CoriolisCoefficients, 9), 9);
        assert_eq!(count(Function::Regressor, 12), 12);
        assert_eq!(Function::Regressor.sizes(3, 12).parameters, 4);
        assert_eq!(Function::BaseParameters.sizes(3, 4).parameters, 4);
        assert!(Function::ForwardDynamics.has_pivots());
        assert!(!Function::TaylorSeries.has_pivots());
    }
}
