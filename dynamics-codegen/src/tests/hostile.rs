//! Input that no person writes: an error or a model, soon, and no overflow of the stack.

use super::*;

#[test]
fn deep_nesting() {
    let parentheses = format!("a: {}1{}", "(".repeat(101), ")".repeat(101));
    let signs = |number| format!("a: {}1", "-".repeat(number));
    for cells in [parentheses, signs(101), signs(20_000)] {
        assert_eq!(
            message(&with_cells(&cells)),
            "nested more than 100 deep: name parts of it by `let`"
        );
    }
    let shallow = format!("a: {}1{}", "(".repeat(90), ")".repeat(90));
    model(&with_cells(&shallow));
}

#[test]
fn long_values() {
    let ones = vec!["1"; 20_000].join(" + ");
    let message = message(&with_cells(&format!("a: {ones}")));
    assert_eq!(
        message,
        "a value has at most 500 terms: name parts of it by `let`"
    );
}

#[test]
fn lets_that_double() {
    let mut lets = "struct Arm { x: f64 } let x0 = x + 1;".to_owned();
    for i in 1..60 {
        lets += &format!("let x{i} = x{0} * x{0};", i - 1);
    }
    let rest = "convention: standard, gravity: [0, 0, 0], joints: [j: revolute { a: x59 }]";
    let message = message(&format!("{lets} {rest}"));
    assert_eq!(message, "more than 500 terms, the `let`s in it written out");
}

#[test]
fn numbers_that_square() {
    let digits = "1.".to_owned() + &"0123456789".repeat(9);
    let mut lets = format!("struct Arm; let x0 = {digits};");
    for i in 1..60 {
        lets += &format!("let x{i} = x{0} * x{0} / 1.5;", i - 1);
    }
    let rest = "convention: standard, gravity: [0, 0, 0], joints: [j: revolute { a: x59 }]";
    let message = message(&format!("{lets} {rest}"));
    assert_eq!(
        message,
        "the exact value of this is a fraction of more than 1,200 digits: write a decimal number"
    );
}

const TOO_LONG: &str =
    "the exact value of this is a fraction of more than 1,200 digits: write a decimal number";

fn coupled(lets: &str, laws: &str) -> String {
    let rows = "a: revolute { mass: 1 }, b: revolute { mass: 1 }, c: revolute { mass: 1 }, d: revolute { mass: 1 }";
    format!(
        "struct Arm; {lets} convention: standard, gravity: [0, 0, -9.81], joints: [{rows}], couple: [{laws}],"
    )
}

/// The factors of a law, and those of joints that follow each other.
#[test]
fn factors_that_multiply() {
    let lets = format!("let x = 1.{};", "0123456789".repeat(9));
    let law = format!("b = {} a", "x * ".repeat(400));
    assert_eq!(message(&coupled(&lets, &law)), TOO_LONG);
    let cube = format!("{} x", "x * ".repeat(4));
    let chain = format!("b = {cube} * a, c = {cube} * b, d = {cube} * c");
    assert_eq!(messages(&coupled(&lets, &chain)), [TOO_LONG; 2]);
    model(&coupled(&lets, &format!("b = {cube} * a, c = b + 1")));
}

/// Joints of a file that stand still beside the arm, and follow each other.
#[cfg(feature = "files")]
#[test]
fn factors_that_multiply_beside_the_arm() {
    use crate::description::Name;
    use crate::files::{Format, Request, table};
    use crate::place::Place;
    use dynamics_symbolic::robot::Value;

    let joint = |k: usize| {
        let digits = "0123456789".repeat(9);
        let next = k + 1;
        format!(
            "<link name='l{k}'/><joint name='j{k}' type='revolute'><parent link='base'/><child link='l{k}'/>\
             <axis xyz='0 0 1'/><mimic joint='j{next}' multiplier='1.{digits}'/></joint>"
        )
    };
    let joints: String = (0..100).map(joint).collect();
    let last = "<link name='l100'/><joint name='j100' type='revolute'><parent link='base'/><child link='l100'/></joint>";
    let text = format!("<robot name='arm'><link name='base'/>{joints}{last}</robot>");
    let name = |word: &str| Name::new(word, Place::File { line: 1, column: 1 });
    let request = Request {
        chain: Some(vec![name("base"), name("l0")]),
        lock: vec![(name("j100"), Some(Value::integer(1)))],
        ..Request::default()
    };
    let errors = table("arm", &text, Format::Urdf, &request).unwrap_err();
    assert!(!errors.is_empty());
    for error in errors {
        assert!(error.message.starts_with(TOO_LONG), "{}", error.message);
    }
}

/// Names of a file that would fill a page, and overflow the widths of columns.
#[cfg(feature = "files")]
#[test]
fn names_of_a_urdf_file_without_end() {
    use crate::files::{Format, Request, table};

    let name = "n".repeat(100_000);
    let start = "n".repeat(40);
    let text = format!(
        "<robot name='arm'><link name='base'/><link name='{name}'/><joint name='{name}' type='revolute'>\
         <parent link='base'/><child link='{name}'/></joint></robot>"
    );
    let errors = table("arm", &text, Format::Urdf, &Request::default()).unwrap_err();
    for error in &errors[..2] {
        let message = format!("a name has at most 200 letters: `{start}...` has 100000");
        assert_eq!(error.message, message);
    }
}

/// Editors of Windows write it at the start of a file.
#[cfg(feature = "files")]
#[test]
fn a_byte_order_mark_says_nothing() {
    use crate::files::{Format, Request, table};

    let text = |mark: &str| {
        format!(
            r#"{mark}{{"convention": "modified", "gravity": [0, 0, 9], "joint": [{{"name": "a", "type": "revolute", "mass": 1}}]}}"#
        )
    };
    for mark in ["", "\u{feff}"] {
        let table = table("arm", &text(mark), Format::Json, &Request::default());
        assert!(table.is_ok(), "{mark:?}");
    }
}

/// Whether a divisor is zero is judged modulo a prime, of which a multiple is no zero.
#[test]
fn divisors_that_look_like_zero() {
    let prime = (1_u64 << 61) - 1;
    let cells = |divisor: &str| with_cells(&format!("a: 1 / ({divisor}), mass: 1"));
    for divisor in [&format!("PI * {prime}"), "PI * 3 - PI * 3.0000001"] {
        model(&cells(divisor));
    }
    assert_eq!(message(&cells("PI * 3 - PI * 3.0")), "division by zero");
}

/// Every prefix and every call with one token missing is read to its end: there is
/// an error or there is a model.
#[test]
fn tokens_left_out() {
    let source = "@[::path] #[doc = \"x\"] pub(crate) struct Arm { pub m: f64, l: f64 }
        let half = l / 2; convention: standard, gravity: [0, 0, -9.81],
        joints: [one: revolute { a: l, alpha: deg(90), mass: m, com: [half, 0, 0],
            inertia: { xx: 1, yy: 1, zz: 1 }, motor: { inertia: 1, gear_ratio: 2 },
            friction: { viscous: 1, coulomb: 2 }, allow: [unphysical_inertia] },
            two: prismatic { mass: 1, inertia: cuboid(1, 2, 3) }],
        functions: [mass_matrix, jacobian], tests: false";
    let tokens: TokenStream = source.parse().unwrap();
    let variants = without_one(&tokens).into_iter().chain(prefixes(&tokens));
    for variant in variants {
        let shown = variant.to_string();
        let (model, messages) = read(variant);
        assert_eq!(model.is_none(), !messages.is_empty(), "{shown}");
        assert!(messages.len() <= 4, "{shown}: {messages:#?}");
    }
}

fn prefixes(tokens: &TokenStream) -> Vec<TokenStream> {
    let all: Vec<_> = tokens.clone().into_iter().collect();
    (0..all.len())
        .map(|end| all[..end].iter().cloned().collect())
        .collect()
}

/// The tokens with one left out, at every depth.
fn without_one(tokens: &TokenStream) -> Vec<TokenStream> {
    let all: Vec<_> = tokens.clone().into_iter().collect();
    let mut variants = Vec::new();
    for (i, token) in all.iter().enumerate() {
        let with = |replacement: Option<proc_macro2::TokenTree>| -> TokenStream {
            let (before, after) = (&all[..i], &all[i + 1..]);
            let tokens = before.iter().cloned().chain(replacement);
            tokens.chain(after.iter().cloned()).collect()
        };
        variants.push(with(None));
        if let proc_macro2::TokenTree::Group(group) = token {
            for inside in without_one(&group.stream()) {
                let group = proc_macro2::Group::new(group.delimiter(), inside);
                variants.push(with(Some(group.into())));
            }
        }
    }
    variants
}

/// Found by the fuzzer: a type ends at `;`, which was never taken.
#[test]
fn tuple_fields_end_at_semicolons() {
    for fields in ["f64;", ";", "f64; 6, 1f", ";;,;"] {
        let call = with_cells("").replace("struct Arm;", &format!("struct Arm({fields})"));
        assert!(!messages(&call).is_empty(), "{fields}");
    }
}

/// A file that never ends, or never begins, is not read by a compiler: a device behind a link, a pipe, a folder, a
/// long file.
#[cfg(all(unix, feature = "files"))]
#[test]
fn what_is_no_file_is_not_read() {
    let folder = std::env::temp_dir().join(format!("no_files_{}", std::process::id()));
    std::fs::create_dir_all(folder.join("folder.toml")).expect("a folder");
    std::os::unix::fs::symlink("/dev/zero", folder.join("zero.toml")).expect("a link");
    let pipe = std::process::Command::new("mkfifo")
        .arg(folder.join("pipe.urdf"))
        .status();
    assert!(pipe.expect("a program").success());
    let long = std::fs::File::create(folder.join("long.json")).expect("a file");
    long.set_len(1 << 40).expect("a file without blocks");
    let told = |name: &str| {
        let path = folder.join(name);
        message(&format!("struct Arm; file: \"{}\"", path.display()))
    };
    let [zero, pipe, long, folder_named] =
        ["zero.toml", "pipe.urdf", "long.json", "folder.toml"].map(told);
    std::fs::remove_dir_all(&folder).expect("the folder");
    for (message, reason) in [
        (zero, "a pipe or a device"),
        (pipe, "a pipe or a device"),
        (long, "longer than 4000000 bytes"),
        (folder_named, "a folder"),
    ] {
        assert!(
            message.starts_with("cannot read `") && message.contains(reason),
            "{message}"
        );
    }
}
