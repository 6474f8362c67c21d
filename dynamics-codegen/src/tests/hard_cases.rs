//! The entries of `tests/data/hard_cases.json` that concern what a table may say.

use super::{messages, model, with_cells};

/// HC19: tensors and masses that no body can have are refused, those that miss a limit by roundings are not.
#[test]
fn tensors_and_masses_of_hard_case_19() {
    for refused in [
        "mass: 1, inertia: { xx: 10, yy: 10, zz: 30 }",
        "mass: 1, inertia: { xx: 4, yy: 4, zz: 4, xy: 2.1 }",
        "mass: 1, inertia: { xx: 2, yy: 2, zz: 2, xy: -0.8, yz: -0.8 }",
        "mass: -1",
        "mass: NaN",
        "mass: 1, inertia: { xx: NaN, yy: 1, zz: 1 }",
    ] {
        assert!(!messages(&with_cells(refused)).is_empty(), "{refused}");
    }
    for accepted in [
        "mass: 1, inertia: { xx: 1, yy: 1, zz: 2 }",
        "mass: 1, inertia: { xx: 20, yy: 20, zz: -1e-15 }",
        "mass: 1, inertia: { xx: 0, yy: 0.083333333333, zz: 0.083333333334 }",
    ] {
        model(&with_cells(accepted));
    }
}

/// HC20: the published PUMA 560 is accepted where its rows allow it, and the message of the row that does not
/// says how.
#[test]
fn the_published_tensor_of_hard_case_20() {
    let link_3 = "mass: 4.8, inertia: { xx: 0.066, yy: 0.086, zz: 0.0125 }";
    let refused = messages(&with_cells(link_3)).concat();
    assert!(refused.contains("allow: [unphysical_inertia]"), "{refused}");
    model(&with_cells(&format!(
        "{link_3}, allow: [unphysical_inertia]"
    )));
}

/// HC44: what no double holds, or no decimal says, is refused with the reason.
#[test]
fn literals_of_hard_case_44() {
    for (literal, reason) in [
        ("1e400", "larger than the largest"),
        ("1e-400", "smaller than the smallest"),
        ("NaN", "`NaN`"),
        ("inf", "`inf`"),
        ("0x10", "decimal"),
        ("1e5f32", "f32"),
    ] {
        let message = messages(&with_cells(&format!("d: {literal}"))).concat();
        assert!(message.contains(reason), "{literal}: {message}");
    }
    model(&with_cells("d: -1.5e-300"));
}
