//! The documentation of the generated methods.

use crate::formula::{Format, Formulas, MOST_JOINTS, MOST_TERMS, Shown, Structure, TooLong};
use crate::function::{Argument, Function, Part, Request, Shape, spans};
use crate::program::{Operand, Output, Program, Proven};
use crate::robot::{JointType, Robot};

/// The lines of a method's documentation.
pub(super) fn documentation(
    robot: &Robot,
    request: &Request,
    proven: &Proven,
    formulas: Option<&Formulas>,
    notes: &[String],
) -> Vec<String> {
    let notes = notes.iter().flat_map(|note| [note.clone(), String::new()]);
    let mut lines = facts(robot, request, &proven.program, notes.collect());
    lines.extend(match formulas {
        Some(formulas) => short_formula_lines(formulas),
        None => formulas_elsewhere(robot, request),
    });
    lines.push(String::new());
    if request.refuses() {
        lines.push(errors(&unresisted(robot, request, proven)));
        lines.push(String::new());
    }
    lines.push(
        " Never panics, never allocates; what depends on an input that is not finite is not finite."
            .to_owned(),
    );
    lines
}

/// The quantities, the units of the arguments, the base parameters, some notes, the operations, and the structure of
/// the values: the lines that stand above formulas and errors in every language.
pub fn facts(
    robot: &Robot,
    request: &Request,
    program: &Program,
    notes: Vec<String>,
) -> Vec<String> {
    let mut lines = quantities(robot, request);
    lines.push(String::new());
    if !request.arguments().is_empty() {
        lines.extend([units(robot, request), String::new()]);
    }
    if request.is_about_base_parameters() {
        lines.extend(super::parameters::lines(robot));
    }
    lines.extend(notes);
    let each = match request.function().map(Function::shape) {
        Some(Shape::Series) => {
            " of the equations of motion at each order, inner sums of products apart"
        }
        _ => "",
    };
    lines.push(format!(" Operations{each}: {}.", program.operations()));
    lines.extend(structures(robot, request, program));
    lines
}

/// The description of the function, in the names of this arm's frames.
fn description(robot: &Robot, Part { function, frame }: Part) -> String {
    let world = robot.base.as_ref().map_or("base frame", |_| "world");
    let text = function.row().description.replace("{frame}", world);
    let tool = robot.tool.as_ref();
    let tip = tool.map_or("last link frame", |_| "tool frame");
    at_frame(robot, frame, &text).replace("{tip}", tip)
}

/// A text about the tip as one about a named frame, if there is one.
fn at_frame(robot: &Robot, frame: Option<usize>, text: &str) -> String {
    let Some(named) = frame.and_then(|frame| robot.frames.get(frame)) else {
        return text.to_owned();
    };
    let named = format!("frame `{}`", named.name);
    let text = text.replace("{tip}", &named);
    text.replace("the tip", &format!("the {named}"))
}

/// The quantity that is returned with its unit, or each quantity of a tuple, in order: lines behind a space each.
pub fn quantities(robot: &Robot, request: &Request) -> Vec<String> {
    let parts = request.parts().iter();
    let descriptions = parts.map(|part| description(robot, *part));
    if !request.is_tuple() {
        return descriptions.map(|text| format!(" {text}")).collect();
    }
    let parts = request.parts().iter();
    let names = parts.map(|part| format!("`{}`", robot.name_of(*part)));
    let quoted = names.collect::<Vec<_>>().join(", ");
    let title = [
        format!(" ({quoted}) at one state, as one program."),
        String::new(),
    ];
    let numbered = descriptions.enumerate();
    let parts = numbered.map(|(number, text)| format!(" - `{number}`: {text}"));
    title.into_iter().chain(parts).collect()
}

/// When a function that solves with M fails.
fn errors(unresisted: &[&str]) -> String {
    match unresisted {
        [] => " # Errors\n\n `SingularMassMatrix` where M(q) is not positive definite to working precision, or not \
               finite: it names the joint whose pivot failed."
            .to_owned(),
        names => format!(
            " # Errors\n\n `SingularMassMatrix`, at every state of this arm: nothing resists `{}`. It takes a link with \
             inertia about the joint's axis, or a motor.",
            names.join("` and `")
        ),
    }
}

/// The joints whose pivot is the constant 0, whatever the state.
pub fn unresisted<'r>(
    robot: &'r Robot,
    request: &Request,
    Proven { program, constants }: &Proven,
) -> Vec<&'r str> {
    let n = robot.dof();
    let spans = spans(request.parts(), robot.freedoms(), program.outputs.len());
    let mut parts = request.parts().iter().zip(spans);
    // All parts with pivots have the same. A series has the pivots of the runtime's factorisation.
    let Some((_, span)) = parts.find(|(part, _)| part.function.has_pivots()) else {
        return Vec::new();
    };
    let pivots = &program.outputs[span.end - 2 * n..span.end - n];
    let is_zero = |pivot: &Output| match pivot.operand {
        Operand::Constant(id) => constants[id.index()] == 0.0,
        _ => false,
    };
    let joints = robot.joints().zip(&pivots[robot.freedoms().base..]);
    let unresisted = joints.filter(|(_, pivot)| is_zero(pivot));
    unresisted.map(|(row, _)| row.name.as_str()).collect()
}

/// The arguments with their units.
fn units(robot: &Robot, request: &Request) -> String {
    let meanings = meanings(robot, request);
    let unit =
        |(argument, meaning): &(Argument, String)| format!("`{}`: {meaning}", argument.name());
    let units: Vec<_> = meanings.iter().map(unit).collect();
    format!(" {}.", units.join("; "))
}

/// The meaning of each argument with its unit, but of those that the description of the function tells.
pub fn meanings(robot: &Robot, request: &Request) -> Vec<(Argument, String)> {
    let is = |joint_type| robot.joints().all(|row| row.joint_type == joint_type);
    let (position, force) = match (is(JointType::Revolute), is(JointType::Prismatic)) {
        (true, _) => ("rad", "N m"),
        (_, true) => ("m", "N"),
        _ => ("rad or m", "N m or N"),
    };
    let unit = |argument: &Argument| {
        let meaning = if robot.freedoms().has_base() {
            argument.meaning_on_moving_base(position, force)?
        } else {
            argument.meaning(position, force)?
        };
        // A tuple may be about one wrench on several frames.
        let is_pushed = |part: &&Part| part.function.arguments().contains(&Argument::Wrench);
        let mut pushed = request.parts().iter().filter(is_pushed);
        let frame = pushed.next().and_then(|part| part.frame);
        let meaning = if pushed.all(|part| part.frame == frame) {
            at_frame(robot, frame, &meaning)
        } else {
            meaning.replace("the tip", "each frame")
        };
        Some((*argument, meaning))
    };
    request.arguments().iter().filter_map(unit).collect()
}

/// The values that are zero or constant, and the variables that the others depend on.
fn structures(robot: &Robot, request: &Request, program: &Program) -> Vec<String> {
    let parts = request.parts();
    let spans = spans(parts, robot.freedoms(), program.outputs.len());
    let structure = |(part, span): (&Part, _)| {
        let sentence = Structure::new(robot, part.function, program, span)?.sentence();
        let line = if part.has_letter_in(parts) {
            format!(" {sentence}")
        } else {
            format!(" `{}`: {sentence}", robot.name_of(*part))
        };
        Some([String::new(), line])
    };
    let structures = parts.iter().zip(spans).filter_map(structure);
    structures.flatten().collect()
}

/// The place of the formulas of a longer arm, whose values have names.
fn formulas_elsewhere(robot: &Robot, request: &Request) -> Vec<String> {
    let has_symbol = |function: Function| function.row().symbol.is_some();
    let is_longer = robot.dof() > MOST_JOINTS && robot.followers().next().is_none();
    if !(is_longer && request.functions().any(has_symbol)) {
        return Vec::new();
    }
    let elsewhere = "`robot-dynamics show`, with `--format text`";
    let line = if robot.freedoms().has_base() {
        format!(" Formulas: {elsewhere}.")
    } else {
        format!(" Formulas of arms of more than {MOST_JOINTS} joints: {elsewhere}.")
    };
    vec![String::new(), line]
}

/// The formulas that are short enough to read at a method.
pub fn short_formula_lines(formulas: &Formulas) -> Vec<String> {
    let mut line = |name: &str, too_long: TooLong| Some(format!(" {name}: {too_long}"));
    formula_lines(formulas, MOST_TERMS, &mut line)
}

/// The formulas of at most so many terms, each behind the name of its value, and what the names of sines in
/// them mean; `longer` gives the line of a value that has more, if there is one.
pub fn formula_lines(
    formulas: &Formulas,
    most_terms: usize,
    longer: &mut dyn FnMut(&str, TooLong) -> Option<String>,
) -> Vec<String> {
    let shown = formulas.shown(Format::Text, most_terms);
    let line = |shown: &Shown| match &shown.formula {
        Ok(formula) => Some(format!(" {} = {formula}", shown.name)),
        Err(too_long) => longer(&shown.name, *too_long),
    };
    let formula_lines: Vec<_> = shown.iter().filter_map(line).collect();
    if formula_lines.is_empty() {
        return Vec::new();
    }
    let mut lines = vec![String::new(), " ```text".to_owned()];
    lines.extend(formula_lines);
    let legend = formulas.legend(most_terms);
    if !legend.is_empty() {
        lines.push(format!(" with {}", legend.join(", ")));
    }
    lines.push(" ```".to_owned());
    lines
}
