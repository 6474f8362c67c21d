//! Python: a module for numpy, and for all that computes as numpy does, or with symbols.

use crate::arguments::{argument_names, argument_sizes};
use crate::arrangement::Arrangement;
use crate::body::{Body, number};
use crate::comments::{lines as documentation, title_lines};
use crate::names::{free_name, snake_case};
use crate::syntax::{PIVOTS_OF_BASE, Syntax, indented, with_pivots_of_base};
use dynamics_symbolic::emit::shown;
use dynamics_symbolic::function::{Argument, Request, plain};
use dynamics_symbolic::program::Proven;
use dynamics_symbolic::robot::Robot;

const PYTHON: Syntax = Syntax {
    declare: |name, value| format!("{name} = {value}"),
    entry: |argument, i| format!("{argument}[{i}]"),
    number,
    is_single: false,
    times: " * ",
    over: " / ",
    field: |field| format!("arm.{}", free_name(field, WORDS)),
    sine: "xp.sin",
    cosine: "xp.cos",
    of_angles: None,
    fused: None,
    exponential: "xp.exp",
    sign: "xp.sign",
    test_pivot: |joint, pivot, diagonal| {
        format!("zero = zero + _of_pivot(xp, {joint}, {pivot}, {diagonal})")
    },
    own_functions: &[
        ("_entries(", ARRAY),
        ("_entries_of_pose(", ARRAY),
        ("_vector(", ARRAY),
        ("_matrix(", ARRAY),
        ("_entries(", ENTRIES),
        ("_entries_of_pose(", ENTRIES_OF_POSE),
        ("_vector(", VECTOR),
        ("_matrix(", VECTOR),
        ("_matrix(", MATRIX),
        ("_of_pivot(", OF_PIVOT),
    ],
};

const ARRANGEMENT: Arrangement = Arrangement {
    number: |entry| format!("{entry} + zero"),
    vector: |entries| format!("_vector(xp, [{}], zero)", entries.join(", ")),
    matrix: |rows| {
        let rows = rows.iter().map(|row| format!("[{}]", row.join(", ")));
        let rows: Vec<_> = rows.collect();
        format!("_matrix(xp, [{}], zero)", rows.join(", "))
    },
    list: |values| format!("[{}]", values.join(", ")),
};

/// Words that no function and no field may be named.
const WORDS: &str = "
False None True and as assert async await break class continue def del elif else except finally for
from global if import in is lambda nonlocal not or pass raise return try while with yield xp zero numpy
";

const ARRAY: &str = "

def _array(xp, x):
    \"\"\"An array of what may be a list. One of torch stays as it is, and so do its gradients.\"\"\"
    return x if hasattr(x, \"requires_grad\") else xp.asarray(x)
";

const ENTRIES: &str = "

def _entries(xp, x, count):
    \"\"\"The entries of a vector: those along the last axis of an array.\"\"\"
    if not hasattr(xp, \"stack\"):
        return [x[i] for i in range(count)]
    x = _array(xp, x)
    if x.shape[-1:] != (count,):
        raise ValueError(f\"expected {count} entries along the last axis, found the shape {tuple(x.shape)}\")
    return [x[..., i] for i in range(count)]
";

const ENTRIES_OF_POSE: &str = "

def _entries_of_pose(xp, x):
    \"\"\"The rotation by rows, then the position, of homogeneous matrices of 4 by 4.\"\"\"
    places = [(i, j) for i in range(3) for j in range(3)] + [(i, 3) for i in range(3)]
    if not hasattr(xp, \"stack\"):
        return [x[i, j] for i, j in places]
    x = _array(xp, x)
    if tuple(x.shape[-2:]) != (4, 4):
        raise ValueError(f\"expected matrices of 4 by 4 along the last axes, found the shape {tuple(x.shape)}\")
    return [x[..., i, j] for i, j in places]
";

const VECTOR: &str = "

def _vector(xp, entries, zero):
    \"\"\"A vector of its entries: the last axis of an array.\"\"\"
    if hasattr(xp, \"stack\"):
        arrays = [_array(xp, entry + zero) for entry in entries]
        return xp.stack(arrays, -1) if arrays else xp.zeros((0,))
    return xp.vertcat(*entries) if hasattr(xp, \"vertcat\") else xp.Matrix(entries)
";

const MATRIX: &str = "

def _matrix(xp, rows, zero):
    \"\"\"A matrix of its rows: the last two axes of an array.\"\"\"
    if hasattr(xp, \"stack\"):
        return xp.stack([_vector(xp, row, zero) for row in rows], -2)
    if hasattr(xp, \"vertcat\"):
        return xp.vertcat(*[xp.horzcat(*row) for row in rows])
    return xp.Matrix(rows)
";

const OF_PIVOT: &str = "

class SingularMassMatrix(ArithmeticError):
    \"\"\"M(q) is not positive definite to working precision, or not finite: the pivot of a joint failed.\"\"\"

    def __init__(self, joint):
        super().__init__(f\"the mass matrix is not positive definite at joint {joint + 1} {JOINT_NAMES[joint]!r}\")
        self.joint = joint


def _of_pivot(xp, joint, pivot, diagonal):
    \"\"\"-0 where a pivot of M is greater than the rounding errors of its diagonal entry, else not a number.\"\"\"
    if not hasattr(xp, \"stack\"):
        return -0.0
    rounding = diagonal * 2.220446049250313e-16 * 8
    good = (pivot - rounding > 0) & (pivot + rounding > 0)
    if xp is numpy and not numpy.all(good):
        raise SingularMassMatrix(joint)
    return xp.where(xp.asarray(good), -0.0, float(\"nan\"))
";

const REFUSAL: &str = "Raises `SingularMassMatrix` if M(q) is not positive definite to working precision or not finite, at one \
                       state of several. Other arrays than numpy's have NaN there; symbols are not tested.";

/// The functions of a robot as a module of Python, each with its program.
///
/// Their last argument `xp` is the namespace of arrays: numpy, where nothing is said, jax.numpy, torch, casadi or sympy.
pub fn python_module(robot: &Robot, functions: &[(Request, Proven)]) -> String {
    let of = |(request, proven): &(Request, Proven)| function(robot, request, proven);
    let bodies: String = functions.iter().map(of).collect();
    let title = title_lines(
        robot,
        [
            "Each function is proven equal to the textbook Lagrangian. SI units, radians; the last axis of an array has the",
            "entries of a vector, the last two those of a matrix, and the axes before it are broadcast as numpy does.",
        ],
    );
    let joints = robot.joints().map(|row| string(&row.name));
    let fields = robot.fields.iter().map(|field| string(plain(field)));
    let fields = if robot.fields.is_empty() {
        String::new()
    } else {
        format!(
            "# The symbolic parameters: attributes of the first argument, `arm`, of every function.\n\
             FIELD_NAMES = [{}]\n",
            fields.collect::<Vec<_>>().join(", ")
        )
    };
    // Within a text in double quotes.
    let of_base = PIVOTS_OF_BASE.replace('"', "'");
    let all = format!("([{of_base}] + JOINT_NAMES)");
    format!(
        "{}\nimport numpy\n\n# Degrees of freedom, and the names of the joints that move, from the base outwards.\n\
         DOF = {}\nJOINT_NAMES = [{}]\n{fields}{}{bodies}",
        docstring(&title, 0),
        robot.dof(),
        joints.collect::<Vec<_>>().join(", "),
        with_pivots_of_base(robot, PYTHON.called(&bodies), &all)
    )
}

fn function(robot: &Robot, request: &Request, proven: &Proven) -> String {
    let body = Body::new(robot, proven, &PYTHON);
    let sizes = proven.sizes(request, robot.freedoms());
    let values = ARRANGEMENT.values(request, sizes, &body.values(request));
    let returned = match (request.is_tuple(), values.join(", ")) {
        (true, values) => format!("({values},)"),
        (false, value) => value,
    };
    let mut reads = Vec::new();
    let mut zeros = Vec::new();
    for (argument, entries) in argument_sizes(request, sizes) {
        let name = argument.name();
        if entries == 0 {
            // Positions of no joints: what has no entries has axes before them.
            reads.push(format!(
                "zero_{name} = -xp.zeros(xp.asarray({name}).shape[:-1]) if hasattr(xp, \"stack\") else -0.0"
            ));
        }
        reads.push(match argument {
            Argument::Base => format!("{name} = _entries_of_pose(xp, {name})"),
            _ => format!("{name} = _entries(xp, {name}, {entries})"),
        });
        zeros.push(match entries {
            0 => format!("zero_{name}"),
            _ => format!("-xp.zeros_like({name}[0])"),
        });
    }
    // -0 changes no number, not even -0: added to entries it gives all of them the axes before the last.
    let zeros = if zeros.is_empty() {
        "-0.0".to_owned()
    } else {
        let zeros = zeros.join(" + ").replace("+ -", "- ");
        format!("{zeros} if hasattr(xp, \"stack\") else -0.0")
    };
    reads.push(format!("zero = {zeros}"));
    reads.extend(body.statements(request));
    reads.push(format!("return {returned}"));
    let arguments = argument_names(robot, request).into_iter();
    let arguments: Vec<_> = arguments.chain(["xp=numpy"]).collect();
    format!(
        "\n\ndef {}({}):\n{}{}",
        free_name(request.name(), WORDS),
        arguments.join(", "),
        docstring(&documentation(robot, request, proven, REFUSAL), 4),
        indented(&reads, 4)
    )
}

/// The name of a robot's module: no word of Python, which no statement imports.
pub fn python_module_name(robot: &Robot) -> String {
    free_name(&snake_case(&robot.name), WORDS)
}

/// A string literal. Letters that do not show themselves are written by their numbers.
fn string(text: &str) -> String {
    let letters = text.chars().map(|letter| match letter {
        '"' | '\\' => format!("\\{letter}"),
        ' '..='~' => letter.to_string(),
        _ if letter.is_alphanumeric() => letter.to_string(),
        _ => format!("\\U{:08x}", u32::from(letter)),
    });
    format!("\"{}\"", letters.collect::<String>())
}

/// Lines as a string of documentation behind so many spaces.
fn docstring(lines: &[String], spaces: usize) -> String {
    let escaped = lines.iter().map(|line| shown(line).replace('\\', "\\\\"));
    let mut lines: Vec<String> = escaped
        .map(|line| line.replace("\"\"\"", "\\\"\\\"\\\""))
        .collect();
    if let Some(first) = lines.first_mut() {
        first.insert_str(0, "\"\"\"");
    }
    lines.push("\"\"\"".to_owned());
    let text = indented(&lines, spaces);
    text.lines()
        .map(|line| format!("{}\n", line.trim_end()))
        .collect()
}
