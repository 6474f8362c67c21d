//! JavaScript: an ES module.

use super::body::{Body, PivotTest, number};
use super::comments::{comment, lines};
use super::{Language, free_name, plain};
use crate::function::{Request, Shape, Size, Sizes, sizes_of};
use crate::program::Proven;
use crate::robot::Robot;
use core::fmt::Write as _;

const JAVASCRIPT: Language = Language {
    declaration: "const",
    field: |field| format!("arm.{field}"),
    sine: "Math.sin",
    cosine: "Math.cos",
    exponential: "Math.exp",
    sign: "sign",
};

/// Words that no function may be named.
const WORDS: [&str; 49] = [
    "arguments",
    "await",
    "break",
    "case",
    "catch",
    "class",
    "const",
    "continue",
    "debugger",
    "default",
    "delete",
    "do",
    "else",
    "enum",
    "eval",
    "export",
    "extends",
    "false",
    "finally",
    "for",
    "function",
    "if",
    "implements",
    "import",
    "in",
    "instanceof",
    "interface",
    "let",
    "new",
    "null",
    "package",
    "private",
    "protected",
    "public",
    "return",
    "static",
    "super",
    "switch",
    "this",
    "throw",
    "true",
    "try",
    "typeof",
    "var",
    "void",
    "while",
    "with",
    "yield",
    "sign",
];

const SIGN: &str = "
/** The sign, 0 of zero; NaN of NaN. */
function sign(x) {
  return x > 0 ? 1 : x < 0 ? -1 : x === 0 ? 0 : x;
}
";

const IS_PIVOT: &str = "
/** M(q) is not positive definite to working precision, or not finite: the pivot of a joint failed. */
export class SingularMassMatrix extends Error {
  /** @param {number} joint the joint, counted from 0 */
  constructor(joint) {
    super(`the mass matrix is not positive definite at joint ${joint + 1} \\`${JOINT_NAMES[joint]}\\``);
    this.name = \"SingularMassMatrix\";
    this.joint = joint;
  }
}

/** Whether a pivot of M is greater than the rounding errors of its diagonal entry. */
function assertPivot(joint, pivot, diagonal) {
  const rounding = diagonal * 2.220446049250313e-16 * 8;
  if (!(pivot - rounding > 0 && pivot + rounding > 0)) throw new SingularMassMatrix(joint);
}
";

const REFUSAL: &str = "Throws `SingularMassMatrix` where M(q) is not positive definite to working precision or not finite.";

/// The functions of a robot as an ES module, each with its program. Vectors are arrays, matrices arrays
/// of rows, tuples arrays of their values.
pub fn javascript_module(robot: &Robot, functions: &[(Request, Proven)]) -> String {
    let mut bodies = String::new();
    for (request, proven) in functions {
        bodies.push_str(&function(robot, request, proven));
    }
    let mut text = comment(&[
        format!("Equations of motion of `{}`, written by robot-dynamics.", robot.name),
        String::new(),
        "Each function is proven equal to the textbook Lagrangian. SI units, radians; vectors are arrays,"
            .to_owned(),
        "matrices arrays of rows. What depends on an input that is not finite is not finite.".to_owned(),
    ]);
    let names = |names: Vec<String>| format!("[{}]", names.join(", "));
    let joints = robot.joints().map(|row| format!("{:?}", row.name));
    let _ = write!(
        text,
        "\n/** Number of joints that move. */\nexport const DOF = {};\n\n\
         /** Names of the joints that move, from the base outwards. */\nexport const JOINT_NAMES = {};\n",
        robot.dof(),
        names(joints.collect())
    );
    if !robot.fields.is_empty() {
        let fields = robot
            .fields
            .iter()
            .map(|field| format!("{:?}", plain(field)));
        let _ = write!(
            text,
            "\n/** The symbolic parameters: properties of the first argument, `arm`, of every function. */\n\
             export const FIELD_NAMES = {};\n",
            names(fields.collect())
        );
    }
    for (helper, called) in [(SIGN, " sign("), (IS_PIVOT, "assertPivot(")] {
        if bodies.contains(called) {
            text.push_str(helper);
        }
    }
    text.push_str(&bodies);
    text
}

fn function(robot: &Robot, request: &Request, proven: &Proven) -> String {
    let body = Body::new(robot, proven, &JAVASCRIPT);
    let fields = (!robot.fields.is_empty()).then_some("arm");
    let arguments = request.arguments();
    let names = arguments.iter().map(|argument| argument.name());
    let parameters: Vec<_> = fields.into_iter().chain(names).collect();
    let mut text = format!(
        "\n{}export function {}({}) {{\n",
        comment(&lines(robot, request, proven, REFUSAL)),
        free_name(request.name(), &WORDS),
        parameters.join(", ")
    );
    let mut line = |statement: &str| {
        let _ = writeln!(text, "  {statement}");
    };
    body.statements()
        .iter()
        .for_each(|statement| line(statement));
    for PivotTest {
        joint,
        pivot,
        diagonal,
    } in body.pivot_tests(request)
    {
        line(&format!("assertPivot({joint}, {pivot}, {diagonal});"));
    }
    let sizes = sizes_of(request.parts(), robot.dof(), proven.program.outputs.len());
    let values = body.values(request);
    let parts = request.parts().iter().zip(&values);
    let parts: Vec<_> = parts
        .map(|(part, values)| value(part.shape(), sizes, &mut values.iter()))
        .collect();
    match request {
        Request::One(_) => line(&format!("return {};", parts[0])),
        Request::Fused(_) => line(&format!("return [{}];", parts.join(", "))),
    }
    text.push_str("}\n");
    text
}

/// Values in their arrangement.
fn value<'v>(shape: &Shape, sizes: Sizes, values: &mut impl Iterator<Item = &'v String>) -> String {
    let mut entry = || values.next().cloned().unwrap_or_else(|| number(0.0));
    let array = |entries: Vec<String>| format!("[{}]", entries.join(", "));
    match shape {
        Shape::Number => entry(),
        Shape::Matrix(rows, Size::One) => array((0..rows.of(sizes)).map(|_| entry()).collect()),
        Shape::Matrix(rows, columns) => {
            let (rows, columns) = (rows.of(sizes), columns.of(sizes));
            let row = |_| array((0..columns).map(|_| entry()).collect());
            array((0..rows).map(row).collect())
        }
        Shape::Each(one) => array(
            (0..sizes.joints)
                .map(|_| value(one, sizes, values))
                .collect(),
        ),
        Shape::Tuple(parts) => array(
            parts
                .iter()
                .map(|part| value(part, sizes, values))
                .collect(),
        ),
        // Never written: it is no program over numbers.
        Shape::Series => array(Vec::new()),
    }
}
