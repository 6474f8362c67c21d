//! The entries that have no line on the scoreboard: which test runs them, or why none does.

/// The place where an entry is treated.
pub(crate) enum Place {
    /// The file and the name of the test that runs it.
    Test(&'static str, &'static str),
    /// Why it does not concern the project.
    NotOurs(&'static str),
}

use Place::{NotOurs, Test};

/// Every entry that is not on the scoreboard.
#[rustfmt::skip]
pub(crate) const ELSEWHERE: [(&str, Place); 8] = [
    ("HC10", NotOurs(
        "the potential energy is -sum m g.c by contract, zero at the base's origin: no 1 - cos q is formed",
    )),
    ("HC19", Test("dynamics-codegen/src/tests/hard_cases.rs", "tensors_and_masses_of_hard_case_19")),
    ("HC20", Test("dynamics-codegen/src/tests/hard_cases.rs", "the_published_tensor_of_hard_case_20")),
    ("HC36", Test(
        "tests/suite/identities/single_precision.rs",
        "single_precision_agrees_with_double_precision",
    )),
    ("HC42", Test("dynamics-symbolic/tests/suite/chains.rs", "thirty_axes_expand")),
    ("HC43", Test("dynamics-symbolic/tests/suite/emission.rs", "long_programs_declare_their_names_in_groups")),
    ("HC44", Test("dynamics-codegen/src/tests/hard_cases.rs", "literals_of_hard_case_44")),
    ("HC45", NotOurs(
        "a Scalar makes its constants from doubles, by contract: a decimal that is rounded twice is at most 1e-9 \
         units in the last place of an f32 further off than one that is rounded once",
    )),
];
