//! Fragments of another macro, such as `$x:expr`: each is one operand, wherever a value may stand.
//!
//! The compiler hands a fragment on in a group without delimiters. These tests make such groups
//! themselves; `tests/fragments.rs` of the root package goes through `macro_rules!`.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

use super::*;

/// Every place where a value may stand.
const PLACES: [&str; 35] = [
    "a: value",
    "alpha: value",
    "d: value",
    "theta: value",
    "mass: value",
    "a: (value)",
    "a: 7 + (1 * (value) * 2)",
    "theta: deg(value)",
    "com: [value, 0, 0]",
    "com: [0, value, 0]",
    "com: [0, 0, value]",
    "inertia: { xx: value, yy: 1e6, zz: 1e6 }",
    "inertia: { xx: 1e6, yy: value, zz: 1e6 }",
    "inertia: { xx: 1e6, yy: 1e6, zz: value }",
    "inertia: { xx: 1e6, yy: 1e6, zz: 1e6, xy: value }",
    "inertia: { xx: 1e6, yy: 1e6, zz: 1e6, yz: value }",
    "inertia: { xx: 1e6, yy: 1e6, zz: 1e6, xz: value }",
    "mass: 1, inertia: cuboid(value, 1, 1)",
    "mass: 1, inertia: cuboid(1, value, 1)",
    "mass: 1, inertia: cuboid(1, 1, value)",
    "mass: 1, inertia: cylinder(value, 1)",
    "mass: 1, inertia: cylinder(1, value)",
    "mass: 1, inertia: rod(value)",
    "mass: 1, inertia: sphere(value)",
    "motor: { inertia: value, gear_ratio: 1 }",
    "motor: { inertia: 1, gear_ratio: value }",
    "friction: { viscous: value }",
    "friction: { coulomb: value }",
    "limits: [value - 100, 100 * PI]",
    "limits: [-100 * PI, value]",
    "a: one + value",
    "a: 1e3, d: one",
    "at: { xyz: [value, 0, 0] }",
    "at: { rpy: [0, value, 0] }",
    "on: base, at: { xyz: [1, 0, value] }",
];

/// Every place outside of the rows.
const ENTRIES: [&str; 12] = [
    "gravity: [value, 0, 0]",
    "gravity: [0, value, 0]",
    "gravity: [0, 0, value]",
    "let two = value;",
    "lock: [second = value]",
    "neglect: value / 100",
    "neglect: value%",
    "base: floating { mass: value, inertia: sphere(1) }",
    "base: floating { mass: 9, com: [0, value, 0], inertia: sphere(value) }",
    "base: floating { mass: 9, inertia: { xx: 1e6, yy: 1e6, zz: 1e6, xz: value } }",
    "frames: { hand: { on: second, xyz: [0, value, 0], mass: 1 } }",
    "frames: { hand: { on: base, rpy: [value, 0, 0], mass: value } }",
];

/// Expressions that may stand around an operand.
const FORMS: [&str; 14] = [
    "operand",
    "operand * 2",
    "2 * operand",
    "operand / 2",
    "12 / operand",
    "operand - 1",
    "12 - operand",
    "12 + operand",
    "-operand",
    "2 * -operand + 20",
    "operand * operand",
    "12 - operand - operand",
    "(operand * 2)",
    "3 * (2 * operand - 1)",
];

/// Operands that mean something else without their parentheses, and some that do not.
const OPERANDS: [&str; 9] = [
    "1 + 2",
    "1 - 2 + 3",
    "5 - 2 - 2",
    "1 / 2",
    "-3",
    "(1) + 2",
    "3",
    "one",
    "deg(30) + 1",
];

/// The tokens with others in place of a word, at every depth.
fn replaced(tokens: TokenStream, word: &str, by: &TokenStream) -> TokenStream {
    tokens
        .into_iter()
        .flat_map(|token| match token {
            TokenTree::Ident(ident) if ident == word => by.clone(),
            TokenTree::Group(group) => {
                let inside = replaced(group.stream(), word, by);
                TokenTree::from(Group::new(group.delimiter(), inside)).into()
            }
            token => token.into(),
        })
        .collect()
}

fn tokens(source: &str) -> TokenStream {
    source.parse().expect("the source lexes")
}

fn grouped(delimiter: Delimiter, tokens: &TokenStream) -> TokenStream {
    TokenTree::from(Group::new(delimiter, tokens.clone())).into()
}

/// The meaning of a call, and the messages about it.
fn meaning(call: TokenStream) -> (Option<String>, Vec<String>) {
    let (model, messages) = read(call);
    let shown = |model: Model| format!("{:?} {:?}", model.robot, model.neglect.map(|(s, _)| s));
    (model.map(shown), messages)
}

/// A call with that value of `value` in an entry, or in a cell, of a table that is right.
fn calls(value: &TokenStream) -> Vec<TokenStream> {
    let table = |cells: &str, entry: &str| {
        let gravity = match entry.starts_with("gravity") {
            true => "",
            false => "gravity: [0, 0, -9.81],",
        };
        tokens(&format!(
            "struct Arm; let one = 1; convention: standard, {gravity} {entry} joints: [
                first: revolute {{ {cells} }},
                second: revolute {{ mass: 1, com: [1, 0, 0] }},
            ], functions: [mass_matrix], allow: [no_inertia, odd_angle, odd_com, odd_gravity, odd_mass]"
        ))
    };
    let in_rows = PLACES.iter().map(|cells| table(cells, ""));
    let in_entries = ENTRIES.iter().map(|entry| match entry.ends_with(';') {
        true => table("a: two * 3", entry),
        false => table("mass: 1", &format!("{entry},")),
    });
    let calls = in_rows.chain(in_entries);
    calls.map(|call| replaced(call, "value", value)).collect()
}

/// Compares the meaning of an operand that is a fragment, handed on by a second macro too, with that of
/// the operand in parentheses, in all of the calls. Returns how many of these are tables.
fn compare(operand: &str, form: &str, calls: impl Fn(&TokenStream) -> Vec<TokenStream>) -> usize {
    let calls = |delimiters: &[Delimiter]| {
        let operand = delimiters
            .iter()
            .fold(tokens(operand), |operand, delimiter| {
                grouped(*delimiter, &operand)
            });
        let value = replaced(tokens(form), "operand", &operand);
        let meanings = calls(&value).into_iter().map(meaning);
        meanings.collect::<Vec<_>>()
    };
    let written_out = calls(&[Delimiter::Parenthesis]);
    let fragment = calls(&[Delimiter::None]);
    let handed_on = calls(&[Delimiter::None, Delimiter::None]);
    assert_eq!(fragment, written_out, "{operand} in {form}");
    assert_eq!(handed_on, written_out, "{operand} in {form}, handed on");
    written_out
        .iter()
        .filter(|(model, _)| model.is_some())
        .count()
}

#[test]
fn a_fragment_is_one_operand_wherever_a_value_may_stand() {
    let places = PLACES.len() + ENTRIES.len();
    let good: usize = FORMS.iter().map(|form| compare("1 + 2", form, calls)).sum();
    // The others are values that no table may have there, such as negative masses.
    assert!(good > FORMS.len() * places * 3 / 4, "{good}");
}

#[test]
fn every_operand_is_one_where_it_is_a_fragment() {
    let call = |value: &TokenStream| {
        let cells = with_cells("a: value, theta: deg(value), allow: [odd_angle]")
            .replace("Arm;", "Arm; let one = 1;");
        vec![replaced(tokens(&cells), "value", value)]
    };
    for operand in OPERANDS {
        for form in FORMS {
            assert_eq!(compare(operand, form, call), 1, "{operand} in {form}");
        }
    }
}

/// A list, a tensor or a solid that is a fragment as a whole, and with fragments in it.
#[test]
fn fragments_of_more_than_a_value() {
    for (cell, whole) in [
        ("mass: 1, com: whole", "[1, 2, 3]"),
        ("mass: 1, inertia: whole", "{ xx: 1, yy: 1, zz: 1 }"),
        ("mass: 1, inertia: whole", "cuboid(1, 2, 3)"),
        ("mass: 1, inertia: whole(2)", "rod"),
        ("limits: whole", "[-1, 1]"),
        ("motor: whole", "{ inertia: 1, gear_ratio: 2 }"),
        ("allow: whole", "[unphysical_inertia]"),
    ] {
        let call = |by| meaning(replaced(tokens(&with_cells(cell)), "whole", &by));
        let fragment = grouped(Delimiter::None, &tokens(whole));
        let expected = call(tokens(whole));
        assert!(expected.0.is_some(), "{cell}: {:?}", expected.1);
        assert_eq!(call(fragment.clone()), expected, "{cell}");
        assert_eq!(call(grouped(Delimiter::None, &fragment)), expected);
    }
}

/// A sign or parentheses at the start of a fragment belong to what is in it.
#[test]
fn a_fragment_continues_no_value() {
    for (value, fragment) in [
        ("1 operand", "-1"),
        ("one operand", "-1"),
        ("operand operand", "-1"),
        ("deg operand", "(30) + 60"),
        ("one operand", "(1) + 2"),
        ("2 * operand", "*one"),
        ("[operand]", "1"),
    ] {
        let fragment = grouped(Delimiter::None, &tokens(fragment));
        let value = replaced(tokens(value), "operand", &fragment);
        let cells = with_cells("a: value").replace("Arm;", "Arm; let one = 1;");
        let (model, messages) = meaning(replaced(tokens(&cells), "value", &value));
        assert_eq!((model, messages.len()), (None, 1), "{value}: {messages:?}");
    }
}

/// The empty group that `$visibility:vis` leaves where it matches nothing.
#[test]
fn an_empty_fragment_is_nothing() {
    let call = tokens("nothing struct Arm { nothing x: f64 } convention: nothing standard,
        gravity: [0, nothing 0, 0], joints: [nothing joint: revolute { a: nothing 2 * nothing x, mass: 1 nothing }] nothing");
    let nothing = grouped(Delimiter::None, &TokenStream::new());
    let without = meaning(replaced(call.clone(), "nothing", &TokenStream::new()));
    assert!(without.0.is_some(), "{:?}", without.1);
    assert_eq!(meaning(replaced(call, "nothing", &nothing)), without);
}
