//! MATLAB, which Octave runs too: a file for each function, over columns of states.

use crate::arguments::{argument_names, argument_sizes};
use crate::arrangement::Arrangement;
use crate::body::{Body, number};
use crate::comments::lines as documentation;
use crate::names::free_name;
use crate::syntax::{Syntax, indented};
use dynamics_symbolic::emit::shown;
use dynamics_symbolic::function::{Argument, Request};
use dynamics_symbolic::program::Proven;
use dynamics_symbolic::robot::Robot;

const MATLAB: Syntax = Syntax {
    declare: |name, value| format!("{name} = {value};"),
    entry: |argument, i| format!("{argument}({}, :)", i + 1),
    number,
    is_single: false,
    times: " .* ",
    over: " ./ ",
    field: |field| format!("arm.{}", free_name(field, WORDS)),
    sine: "sin",
    cosine: "cos",
    of_angles: None,
    fused: None,
    exponential: "exp",
    sign: "sign",
    test_pivot: |joint, pivot, diagonal| format!("test_pivot({}, {pivot}, {diagonal});", joint + 1),
    own_functions: &[
        ("check_rows(", CHECK_ROWS),
        ("entries_of_pose(", ENTRIES_OF_POSE),
        ("test_pivot(", TEST_PIVOT),
    ],
};

const ARRANGEMENT: Arrangement = Arrangement {
    number: |entry| format!("{entry} + zero"),
    vector: |entries| column(entries.iter()),
    matrix: |rows| {
        let (count, width) = (rows.len(), rows.first().map_or(0, Vec::len));
        let by_columns = (0..width).flat_map(|j| rows.iter().map(move |row| &row[j]));
        match count * width {
            0 => format!("zeros({count}, {width})"),
            _ => format!("reshape({}, {count}, {width}, [])", column(by_columns)),
        }
    },
    list: |values| format!("{{{}}}", values.join(", ")),
};

fn column<'a>(entries: impl Iterator<Item = &'a String>) -> String {
    let entries = entries.map(|entry| format!("{entry} + zero"));
    format!("[{}]", entries.collect::<Vec<_>>().join("; "))
}

/// Words that no function and no field may be named.
const WORDS: &str = "
arguments break case catch classdef continue do else elseif end end_try_catch end_unwind_protect endfor
endfunction endif endswitch endwhile enumeration events for function global if methods otherwise parfor
persistent properties return spmd switch try until unwind_protect unwind_protect_cleanup while
";

const CHECK_ROWS: &str = "
function check_rows(name, x, rows)
    if size(x, 1) ~= rows
        error('robot_dynamics:size', '%s: expected %d rows, found %d', name, rows, size(x, 1));
    end
end
";

const ENTRIES_OF_POSE: &str = "
function rows = entries_of_pose(pose)
    % Columns of the rotation by rows, then the position; also of homogeneous matrices of 4 by 4.
    if size(pose, 1) ~= 4 || size(pose, 2) ~= 4
        check_rows('base', pose, 12);
        rows = pose;
        return
    end
    rotation = permute(pose(1:3, 1:3, :), [2 1 3]);
    rows = [reshape(rotation, 9, []); reshape(pose(1:3, 4, :), 3, [])];
end
";

const TEST_PIVOT: &str = "
function test_pivot(joint, pivot, diagonal)
    % Whether a pivot of M is greater than the rounding errors of its diagonal entry, at all states.
    rounding = diagonal * (8 * eps);
    if ~all(pivot - rounding > 0 & pivot + rounding > 0)
        error('robot_dynamics:SingularMassMatrix', 'the mass matrix is not positive definite at joint %d', joint);
    end
end
";

const REFUSAL: &str = "Fails with `robot_dynamics:SingularMassMatrix` if M(q) is not positive definite to working precision or not \
                       finite, at one state of several.";

/// The name of the value of a function that has one.
const VALUE: &str = "value";

/// The functions of a robot as files of MATLAB: the name and the text of each.
pub fn matlab_files(robot: &Robot, functions: &[(Request, Proven)]) -> Vec<(String, String)> {
    let functions = functions.iter();
    functions
        .map(|(request, proven)| {
            let name = free_name(request.name(), WORDS);
            let text = file(robot, request, proven, &name);
            (format!("{name}.m"), text)
        })
        .collect()
}

fn file(robot: &Robot, request: &Request, proven: &Proven, name: &str) -> String {
    let body = Body::new(robot, proven, &MATLAB);
    let sizes = proven.sizes(request, robot.freedoms());
    let values = ARRANGEMENT.values(request, sizes, &body.values(request));
    let names = if request.is_tuple() {
        let parts = request.parts().iter();
        parts
            .map(|part| free_name(&robot.name_of(*part), WORDS))
            .collect()
    } else {
        vec![VALUE.to_owned()]
    };
    let mut lines = Vec::new();
    // -0 changes no number, not even -0: added to entries it gives all of them a column for each state.
    let mut zeros = vec!["-0".to_owned()];
    for (argument, entries) in argument_sizes(request, sizes) {
        let name = argument.name();
        lines.push(match argument {
            Argument::Base => format!("{name} = entries_of_pose({name});"),
            _ => format!("check_rows('{name}', {name}, {entries});"),
        });
        zeros.push(format!("zeros(1, size({name}, 2))"));
    }
    lines.push(format!("zero = {};", zeros.join(" - ")));
    lines.extend(body.statements(request));
    let results = names.iter().zip(&values);
    lines.extend(results.map(|(name, value)| format!("{name} = {value};")));
    let text = indented(&lines, 4);
    let arguments = argument_names(robot, request).join(", ");
    let results = match &names[..] {
        [name] => name.clone(),
        names => format!("[{}]", names.join(", ")),
    };
    format!(
        "function {results} = {name}({arguments})\n{}{text}end\n{}",
        help(robot, request, proven, name),
        MATLAB.called(&text)
    )
}

/// The lines about the argument that has the symbolic parameters, if there are some.
fn of_fields(robot: &Robot) -> Vec<String> {
    let names = robot.fields.iter().map(|field| free_name(field, WORDS));
    let names: Vec<_> = names.collect();
    match names.is_empty() {
        true => Vec::new(),
        false => vec![
            String::new(),
            format!(
                "`arm`: a struct of the symbolic parameters {}.",
                names.join(", ")
            ),
        ],
    }
}

/// The lines about where the base stands, if that is an argument.
fn of_base(request: &Request) -> Vec<String> {
    match request.arguments().contains(&Argument::Base) {
        false => Vec::new(),
        true => vec![
            String::new(),
            "`base`: columns of twelve numbers, the rotation by rows and then the position; or pages of 4 by 4."
                .to_owned(),
        ],
    }
}

/// The text that `help` prints.
fn help(robot: &Robot, request: &Request, proven: &Proven, name: &str) -> String {
    let conventions = [
        String::new(),
        format!("A function of `{}`, written by robot-dynamics.", robot.name),
        "Proven equal to the textbook Lagrangian. SI units, radians; a column is a state, a page of a matrix too."
            .to_owned(),
    ];
    let lines = documentation(robot, request, proven, REFUSAL).into_iter();
    let mut text = format!("%{}\n", name.to_uppercase());
    for line in lines
        .chain(of_base(request))
        .chain(of_fields(robot))
        .chain(conventions)
    {
        // A line break would end the comment.
        let line = shown(&line).replace('\n', " ");
        text.push_str(format!("%   {line}").trim_end());
        text.push('\n');
    }
    text
}
