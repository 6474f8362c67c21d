//! The names of the entries of arguments and values: those of joints are counted, those of a base that moves have axes.

use crate::function::{Argument, Freedoms, Function, Sizes};

/// The axes of what a base that moves has six of: linear, then angular.
const AXES: [&str; 3] = ["x", "y", "z"];

/// An entry of an argument: as text, and as a letter with dots above it and a subscript.
pub(super) struct Letter {
    /// `qd2`.
    pub(super) text: String,
    /// `q`
    pub(super) base: &'static str,
    /// How many derivatives by time.
    pub(super) dots: usize,
    /// `2`
    pub(super) subscript: String,
}

impl Letter {
    /// The name of an entry. Positions are those of the joints; velocities, accelerations and forces begin with those of a
    /// base that moves.
    pub(super) fn new(freedoms: Freedoms, argument: Argument, index: usize) -> Self {
        match argument {
            Argument::Base | Argument::Pose => of_pose(index),
            Argument::Position | Argument::Wrench | Argument::Order => counted(argument, index),
            _ if index < freedoms.base => of_base(argument, index),
            _ => counted(argument, index - freedoms.base),
        }
    }
}

/// Whether an entry of an argument of some function is called like that.
pub(super) fn is_entry(freedoms: Freedoms, name: &str) -> bool {
    let sizes = Sizes {
        freedoms,
        parameters: 0,
    };
    let of_base = freedoms.has_base().then_some(&Argument::Base);
    let arguments = Function::ALL
        .iter()
        .flat_map(|function| function.arguments());
    let mut entries = arguments.chain(of_base).flat_map(|argument| {
        let count = argument.shape().map_or(0, |shape| shape.entries(sizes));
        (0..count).map(|index| Letter::new(freedoms, *argument, index).text)
    });
    entries.any(|entry| entry == name)
}

/// An entry that has a number, from 1.
fn counted(argument: Argument, index: usize) -> Letter {
    let (base, dots, reference) = match argument {
        Argument::Velocity => ("q", 1, ""),
        Argument::Acceleration => ("q", 2, ""),
        Argument::ReferenceVelocity => ("q", 1, "r,"),
        Argument::ReferenceAcceleration => ("q", 2, "r,"),
        Argument::Jerk => ("q", 3, ""),
        Argument::Snap => ("q", 4, ""),
        Argument::Wrench => ("w", 0, ""),
        _ => (argument.name(), 0, ""),
    };
    Letter {
        text: format!("{}{}", argument.name(), index + 1),
        base,
        dots,
        subscript: format!("{reference}{}", index + 1),
    }
}

/// Where the base stands: its rotation by rows, `r11` to `r33`, then its position, `x`, `y`, `z`.
fn of_pose(index: usize) -> Letter {
    let (base, subscript) = match index {
        0..9 => ("r", format!("{}{}", index / 3 + 1, index % 3 + 1)),
        _ => (AXES[(index - 9) % 3], String::new()),
    };
    Letter {
        text: format!("{base}{subscript}"),
        base,
        dots: 0,
        subscript,
    }
}

/// One of the six numbers of the base: `vx`, `wz` of velocities, `vxd` of accelerations, `fx`, `nz` of forces.
fn of_base(argument: Argument, index: usize) -> Letter {
    let axis = AXES[index % 3];
    let (letters, dots, ending, reference) = match argument {
        Argument::Force => (["f", "n"], 0, "", ""),
        Argument::Velocity => (["v", "w"], 0, "", ""),
        Argument::ReferenceVelocity => (["v", "w"], 0, "_r", "r,"),
        Argument::ReferenceAcceleration => (["v", "w"], 1, "d_r", "r,"),
        _ => (["v", "w"], 1, "d", ""),
    };
    let base = letters[index / 3];
    Letter {
        text: format!("{base}{axis}{ending}"),
        base,
        dots,
        subscript: format!("{reference}{axis}"),
    }
}

/// The indices of a value: `12` for the first row and the second column, `1,12` where a number has two digits.
pub(super) fn digits(indices: &[usize]) -> String {
    let separator = if indices.iter().any(|index| *index > 9) {
        ","
    } else {
        ""
    };
    let digits: Vec<String> = indices.iter().map(usize::to_string).collect();
    digits.join(separator)
}
