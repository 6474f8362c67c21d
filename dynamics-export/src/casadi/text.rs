//! The text of the file around its functions.

use super::{FIELDS, File, ZEROS};
use crate::c::WORDS;
use crate::comments::{comment, title_lines};
use crate::names::free_name;
use crate::syntax::indented;

const TOP: &str = "
#ifndef ROBOT_DYNAMICS_DEVICE
#define ROBOT_DYNAMICS_DEVICE
#endif

#ifndef CASADI_SYMBOL_EXPORT
#if defined(_WIN32) || defined(__CYGWIN__)
#define CASADI_SYMBOL_EXPORT __declspec(dllexport)
#else
#define CASADI_SYMBOL_EXPORT
#endif
#endif
";

/// Programs of derivatives may have more values than are given, as those by displacements of a base.
const UNUSED: &str = "
#ifdef __GNUC__
#pragma GCC diagnostic ignored \"-Wunused-variable\"
#endif
";

const UNKNOWN: &str = "
#include <math.h>

/** Derivatives that are not known. */
static void robot_dynamics_unknown(double *values, long long int count)
{
    long long int i;
    for (i = 0; i < count; ++i) values[i] = NAN;
}
";

impl File<'_> {
    /// The whole file with these functions.
    pub(super) fn text(&self, functions: &str) -> String {
        let own = self.precision.functions(functions);
        let unknown = if functions.contains("robot_dynamics_unknown(") {
            UNKNOWN
        } else {
            ""
        };
        let zeros = if functions.contains(ZEROS) {
            format!(
                "\n/* What is read where an input is not there. */\nstatic const double {ZEROS}[{}] = {{0}};\n",
                self.longest
            )
        } else {
            String::new()
        };
        let members = self
            .robot
            .fields
            .iter()
            .map(|field| format!("double {};", free_name(field, WORDS)));
        let members: Vec<_> = members.collect();
        let fields = match &members[..] {
            [] => String::new(),
            members => format!(
                "\ntypedef struct {{\n{}}} robot_dynamics_fields;\n",
                indented(members, 4)
            ),
        };
        format!(
            "{}{TOP}{UNUSED}{own}{unknown}{fields}{zeros}\n\
             /* Patterns of entries: rows, columns, and 1 if all are there; else where each column starts, and the rows. */\n{}\n\
             #ifdef __cplusplus\nextern \"C\" {{\n#endif\n{functions}\n#ifdef __cplusplus\n}}\n#endif\n",
            self.title(),
            self.patterns.text(),
        )
    }

    fn title(&self) -> String {
        let conventions = [
            "For `casadi.external`. Each function is proven equal to the textbook Lagrangian. SI units, radians.",
            "Entries that are zero always are no part of an output. Derivatives `jac_..`, `jac_jac_..` and `adj1_..` are exact.",
        ];
        let mut lines = title_lines(self.robot, conventions).to_vec();
        if !self.robot.fields.is_empty() {
            let names: Vec<_> = self
                .robot
                .fields
                .iter()
                .map(|field| free_name(field, WORDS))
                .collect();
            lines.push(String::new());
            lines.push(format!(
                "The input `{FIELDS}` has the symbolic parameters, in this order: {}.",
                names.join(", ")
            ));
            lines.push("Derivatives by them are not known: they are NaN.".to_owned());
        }
        if self.robot.freedoms().has_base() {
            lines.push(String::new());
            lines.push(
                "Derivatives by `base` are those by its twelve numbers, each on its own: the rotation by rows, then the position."
                    .to_owned(),
            );
        }
        comment(&lines)
    }
}
