//! JavaScript: an ES module.

use crate::arguments::argument_names;
use crate::arrangement::Arrangement;
use crate::body::{Body, number};
use crate::comments::{comment, lines as documentation, title};
use crate::names::free_name;
use crate::syntax::{PIVOTS_OF_BASE, Syntax, indented, with_pivots_of_base};
use dynamics_symbolic::function::{Request, plain};
use dynamics_symbolic::program::Proven;
use dynamics_symbolic::robot::Robot;

pub(crate) const JAVASCRIPT: Syntax = Syntax {
    declare: |name, value| format!("const {name} = {value};"),
    entry: |argument, i| format!("{argument}[{i}]"),
    number,
    is_single: false,
    times: " * ",
    over: " / ",
    field: |field| format!("arm.{field}"),
    sine: "Math.sin",
    cosine: "Math.cos",
    of_angles: None,
    fused: None,
    exponential: "Math.exp",
    sign: "sign",
    test_pivot: |joint, pivot, diagonal| format!("assertPivot({joint}, {pivot}, {diagonal});"),
    own_functions: &[(" sign(", SIGN), ("assertPivot(", IS_PIVOT)],
};

const ARRANGEMENT: Arrangement = Arrangement {
    number: |entry| entry,
    vector: |entries| array(entries.iter().cloned()),
    matrix: |rows| array(rows.iter().map(|row| array(row.iter().cloned()))),
    list: |values| array(values.iter().cloned()),
};

/// Words that no function may be named.
const WORDS: &str = "
arguments await break case catch class const continue debugger default delete do else enum eval
export extends false finally for function if implements import in instanceof interface let new null
package private protected public return static super switch this throw true try typeof var void
while with yield sign
";

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
    let functions = functions.iter();
    let bodies: String = functions
        .map(|(request, proven)| function(robot, request, proven))
        .collect();
    let title = title(
        robot,
        [
            "Each function is proven equal to the textbook Lagrangian. SI units, radians; vectors are arrays,",
            "matrices arrays of rows. A value that depends on an input that is not finite is not finite.",
        ],
    );
    let joints = robot.joints().map(|row| format!("{:?}", row.name));
    let quoted = |field: &String| format!("{:?}", plain(field));
    let fields = if robot.fields.is_empty() {
        String::new()
    } else {
        format!(
            "\n/** The symbolic parameters: properties of the first argument, `arm`, of every function. */\n\
             export const FIELD_NAMES = {};\n",
            array(robot.fields.iter().map(quoted))
        )
    };
    let counted = match robot.freedoms().has_base() {
        true => "Degrees of freedom: six of the base, then the joints that move.",
        false => "Number of joints that move.",
    };
    let all = format!("[{PIVOTS_OF_BASE}, ...JOINT_NAMES]");
    format!(
        "{title}\n/** {counted} */\nexport const DOF = {};\n\n\
         /** Names of the joints that move, from the base outwards. */\nexport const JOINT_NAMES = {};\n\
         {fields}{}{bodies}",
        robot.dof(),
        array(joints),
        with_pivots_of_base(robot, JAVASCRIPT.called(&bodies), &all)
    )
}

fn array(entries: impl Iterator<Item = String>) -> String {
    format!("[{}]", entries.collect::<Vec<_>>().join(", "))
}

fn function(robot: &Robot, request: &Request, proven: &Proven) -> String {
    let body = Body::new(robot, proven, &JAVASCRIPT);
    let sizes = proven.sizes(request, robot.freedoms());
    let values = ARRANGEMENT.values(request, sizes, &body.values(request));
    let returned = if request.is_tuple() {
        array(values.into_iter())
    } else {
        values.concat()
    };
    let mut lines = body.statements(request);
    lines.push(format!("return {returned};"));
    format!(
        "\n{}export function {}({}) {{\n{}}}\n",
        comment(&documentation(robot, request, proven, REFUSAL)),
        free_name(request.name(), WORDS),
        argument_names(robot, request).join(", "),
        indented(&lines, 2)
    )
}
