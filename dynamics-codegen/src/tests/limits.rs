//! Every limit of [`crate::limits`]: what exceeds it is one clear error, what meets it is a model, both
//! within seconds and in bounded memory.

use dynamics_symbolic::derive::derive_together;

use super::*;
use crate::limits::*;

/// Seconds on a processor for a call that is refused, in a build without optimisation.
const SOON: f64 = 5.0;

/// For a call that is derived and proven; the engine alone is optimised in this workspace.
const IN_SECONDS: f64 = 30.0;

/// Seconds that messages say for as many operations as a call may have.
const AS_SAID: f64 = (MOST_OPERATIONS / OPERATIONS_IN_A_SECOND) as f64;

/// Bytes of the heap at any one time.
const MOST_BYTES: u64 = 800_000_000;

/// Joints of the longest arm with the default set.
const LONGEST: usize = 125;

/// Functions in all tuples of one call, times the number of joints.
const PARTS: usize = 256;

/// The messages about a call, which must come soon.
fn refusal(source: &str) -> Vec<String> {
    let (items, _) = expansion(source, SOON);
    errors(&items)
}

/// The messages about a call, of which nothing is derived.
fn messages_of(source: &str) -> Vec<String> {
    read(source.parse().expect("the source lexes")).1
}

/// The error messages in an expansion.
fn errors(items: &str) -> Vec<String> {
    let error = ":: core :: compile_error ! { \"";
    let ends_at = |text: &str| text.find("\" }").unwrap_or(text.len());
    let mut parts = items.split(error);
    parts.next();
    parts.map(|text| text[..ends_at(text)].to_owned()).collect()
}

/// The items of a call, and the most bytes on the heap.
fn expansion(source: &str, limit: f64) -> (String, u64) {
    let tokens: TokenStream = source.parse().expect("the source lexes");
    let mut items = String::new();
    let start = measuring::thread_seconds();
    let memory = allocation_counter::measure(|| {
        items = crate::generate_by(tokens, &derive_together).to_string();
    });
    let time = measuring::thread_seconds() - start;
    let start = &source[..source.len().min(60)];
    assert!(time < limit, "{start}: {time} s");
    assert!(
        memory.bytes_max < MOST_BYTES,
        "{start}: {}",
        memory.bytes_max
    );
    let name = std::thread::current().name().map(str::to_owned);
    println!("{time:8.2} s {:9} bytes  {name:?}", memory.bytes_max);
    (items, memory.bytes_max)
}

fn rows(number: usize, cells: &str) -> String {
    let row = |i| format!("joint{i}: revolute {{ {cells} }}");
    let rows: Vec<String> = (0..number).map(row).collect();
    rows.join(",")
}

/// A call with these `let`s or fields in front of one row.
fn with_head(head: &str, cells: &str) -> String {
    format!(
        "struct Arm {head} convention: standard, gravity: [0, 0, -9.81], \
         joints: [joint: revolute {{ {cells} }}]"
    )
}

#[test]
fn a_thousand_rows() {
    let message = "`default` of 1000 joints has about 18,925,000 operations, which take about 2365 s to derive: one call has at \
                   most 400,000. Request fewer functions, lock joints or leave them out, or evaluate the table numerically \
                   by `NewtonEuler`";
    assert_eq!(
        refusal(&with_rows(&rows(1_000, "a: 1, mass: 1"))),
        [message]
    );
}

#[test]
fn a_thousand_rows_of_which_one_is_locked() {
    let call = with_rows(&rows(1_000, "a: 1, mass: 1"));
    let messages = refusal(&format!(
        "{call} lock: [joint1 = 0.5], couple: [joint2 = joint3]"
    ));
    assert_eq!(messages.len(), 1, "{messages:?}");
    assert!(messages[0].starts_with("`default` of 999 joints has about "));
}

#[test]
fn a_thousand_rows_with_one_name() {
    let rows = rows(1_000, "").replace("joint1", "joint");
    assert_eq!(refusal(&with_rows(&rows)).len(), MOST_ERRORS);
}

/// The default set of the longest arm, and of one in which 40 joints follow others.
#[test]
#[ignore = "takes seconds: .ci/run runs it"]
fn as_many_joints_as_are_allowed() {
    let cells = "a: 0.1, alpha: 0.5, d: 0.2, theta: 0.3, mass: 1, com: [0.1, 0.2, 0.3], \
                 inertia: { xx: 2, yy: 2, zz: 2, xy: 0.1, yz: 0.1, xz: 0.1 }, \
                 spring: { stiffness: 20, rest: 0.1 }, \
                 friction: { \
                     viscous: 0.3, coulomb: { positive: 0.2, negative: 0.1 }, \
                     stribeck: { static: 0.5, velocity: 0.05 }, \
                 }";
    let call = with_rows(&rows(LONGEST, cells));
    let (items, _) = expansion(&call, AS_SAID);
    assert_eq!(errors(&items), [""; 0]);
    assert_eq!(refusal(&with_rows(&rows(LONGEST + 1, cells))).len(), 1);
    let followers: Vec<_> = (0..40)
        .map(|i| format!("joint{} = 2 * joint{}", 2 * i + 1, 2 * i))
        .collect();
    let call = with_rows(&rows(110, cells));
    let (items, _) = expansion(
        &format!("{call} couple: [{}]", followers.join(", ")),
        AS_SAID,
    );
    assert_eq!(errors(&items), [""; 0]);
}

/// A humanoid with the functions that identification, control and optimisation need, in one call.
#[test]
#[ignore = "takes seconds: .ci/run runs it"]
fn a_humanoid_with_long_functions() {
    let cells = "a: 0.1, alpha: 0.5, d: 0.2, theta: 0.3, mass: 1, com: [0.1, 0.2, 0.3], \
                 inertia: { xx: 2, yy: 2, zz: 2, xy: 0.1, yz: 0.1, xz: 0.1 }";
    let asked = "functions: [default, coriolis_matrix, regressor, inverse_dynamics_derivatives]";
    let (items, _) = expansion(
        &format!("{} {asked}", with_rows(&rows(38, cells))),
        IN_SECONDS,
    );
    assert_eq!(errors(&items), [""; 0]);
}

#[test]
fn functions_that_would_be_too_long() {
    let call = with_rows(&rows(130, "a: 1, mass: 1"));
    let asked = "functions: [coriolis_matrix, mass_matrix, regressor]";
    let remedy = "one call has at most 400,000. Request fewer functions, lock joints or leave them out, or evaluate the table \
                  numerically by `NewtonEuler`";
    assert_eq!(
        refusal(&format!("{call} {asked}")),
        [
            format!(
                "`coriolis_matrix` of 130 joints has about 811,000 operations, which take about 101 s to derive: {remedy}"
            ),
            format!(
                "`regressor` of 130 joints has about 676,000 operations, which take about 84 s to derive: {remedy}"
            ),
        ]
    );
}

/// A call for functions whose values are as many as the cube of the joints.
fn with_cubic_functions(joints: usize) -> String {
    let cells = "a: 0.1, alpha: 0.5, d: 0.2, theta: 0.3, mass: 1, com: [0.1, 0.2, 0.3], \
                 inertia: { xx: 2, yy: 2, zz: 2, xy: 0.1, yz: 0.1, xz: 0.1 }";
    let asked = "functions: [inverse_dynamics_second_derivatives, coriolis_matrix]";
    format!("{} {asked}", with_rows(&rows(joints, cells)))
}

#[test]
fn a_cubic_function_of_too_many_joints() {
    let message = "`inverse_dynamics_second_derivatives` of 24 joints has about 456,000 operations";
    assert!(refusal(&with_cubic_functions(24))[0].starts_with(message));
}

#[test]
#[ignore = "takes seconds: .ci/run runs it"]
fn a_cubic_function_of_as_many_joints_as_are_allowed() {
    let call = with_cubic_functions(18);
    let (items, _) = expansion(&call, IN_SECONDS);
    assert!(errors(&items).is_empty());
}

#[test]
fn functions_that_would_be_too_long_together() {
    let asked = "functions: [regressor, mass_matrix, coriolis_matrix, inverse_dynamics_derivatives, coriolis_coefficients]";
    let call = |joints| format!("{} {asked}", with_rows(&rows(joints, "a: 1, mass: 1")));
    assert_eq!(
        refusal(&call(38)),
        [
            "`coriolis_coefficients` besides `regressor`, `mass_matrix`, `coriolis_matrix` and `inverse_dynamics_derivatives` \
             makes about 488,000 operations with 38 joints, which take about 61 s to derive: one call has at most 400,000. \
             Request it in a call of its own, for a second struct with this table"
        ]
    );
    assert_eq!(messages_of(&call(34)), [""; 0]);
}

/// As many tuples of three functions as an arm of so many joints may have.
fn with_tuples(joints: usize, more: usize) -> String {
    let cells = "a: 0.1, alpha: 0.5, d: 0.2, mass: 1, com: [0.1, 0.2, 0.3]";
    let tuple = |i| format!("tuple{i} = (mass_matrix, coriolis_vector, gravity_vector)");
    let tuples: Vec<String> = (0..PARTS / joints / 3 + more).map(tuple).collect();
    let functions = format!("functions: [{}]", tuples.join(", "));
    format!("{} {functions}", with_rows(&rows(joints, cells)))
}

#[test]
fn more_parts_of_tuples_than_are_allowed() {
    assert_eq!(messages_of(&with_tuples(7, 0)), [""; 0]);
    let messages = refusal(&with_tuples(7, 6));
    assert!(
        messages[0].starts_with("`tuple15` besides `tuple0`, "),
        "{messages:?}"
    );
}

/// `cargo test -p dynamics-codegen --lib limits:: -- --ignored`
#[test]
#[ignore = "takes half a minute: .ci/run runs it"]
fn as_many_parts_of_tuples_as_are_allowed() {
    for joints in [2, 7] {
        let (items, _) = expansion(&with_tuples(joints, 0), IN_SECONDS);
        assert_eq!(errors(&items), [""; 0]);
    }
}

/// A function that solves with M at so many frames.
fn with_functions_of_frames(count: usize) -> String {
    let frames: Vec<String> = (0..count)
        .map(|i| format!("f{i}: {{ on: joint63 }}"))
        .collect();
    let asked: Vec<String> = (0..count)
        .map(|i| format!("operational_inertia_inverse(f{i})"))
        .collect();
    let (frames, asked) = (frames.join(", "), asked.join(", "));
    let cells = "a: 0.1, alpha: 0.5, d: 0.2, mass: 1, com: [0.1, 0.2, 0.3]";
    format!(
        "{} frames: {{ {frames} }}, functions: [{asked}]",
        with_rows(&rows(64, cells))
    )
}

#[test]
fn too_many_functions_of_frames() {
    let messages = refusal(&with_functions_of_frames(3));
    let start = "`operational_inertia_inverse(f2)` besides `operational_inertia_inverse(f0)` and \
                 `operational_inertia_inverse(f1)` makes about 552,000 operations with 64 joints";
    assert!(messages[0].starts_with(start), "{messages:?}");
}

#[test]
#[ignore = "takes seconds: .ci/run runs it"]
fn the_longest_function_of_a_frame() {
    let (items, _) = expansion(&with_functions_of_frames(1), IN_SECONDS);
    assert_eq!(errors(&items), [""; 0]);
}

#[test]
fn tokens_without_end() {
    let message = format!("more than {MOST_TOKENS} words, numbers and signs in one call");
    let many = with_rows(&rows(20_000, "a: 1, mass: 1"));
    assert_eq!(refusal(&many), [message]);
}

#[test]
fn lets_without_end() {
    let lets = |n: usize| -> String { (0..n).map(|i| format!("let x{i} = 1;")).collect() };
    let too_many_tokens = format!("more than {MOST_TOKENS} words, numbers and signs in one call");
    let head = format!("; {}", lets(100_000));
    assert_eq!(refusal(&with_head(&head, "a: x0")), [too_many_tokens]);
    // 19,999 `let`s and a cell are as many terms as there may be.
    let head = format!("; {}", lets(MOST_TERMS_IN_ALL - 6));
    assert_eq!(refusal(&with_head(&head, "mass: x0")), [""; 0]);
}

#[test]
fn lets_that_repeat_long_values() {
    let sum = vec!["x"; MOST_TERMS].join(" + ");
    let copies: String = (0..9_000)
        .map(|i| format!("let y{i} = 1 / (y - 1);"))
        .collect();
    let head = format!("{{ x: f64 }} let y = {sum}; {copies}");
    let messages = refusal(&with_head(&head, "a: y"));
    assert!(
        messages[0].contains("more than 500 terms"),
        "{}",
        messages[0]
    );
    let copies: String = (0..10_000).map(|i| format!("let y{i} = y;")).collect();
    let head = format!("{{ x: f64 }} let y = {sum}; {copies}");
    let messages = refusal(&with_head(&head, "a: 1"));
    assert!(
        messages.concat().contains("20000 terms in all"),
        "{messages:#?}"
    );
}

#[test]
fn names_without_end() {
    let name = "n".repeat(100_000);
    let start = "n".repeat(40);
    let message = format!("a name has at most 200 letters: `{start}...` has 100000");
    for call in [
        format!("struct {name}; {}", &with_cells("")[11..]),
        with_head(&format!("{{ {name}: f64 }}"), &format!("a: {name}")),
        with_head(&format!("; let {name} = 1;"), &format!("a: {name}")),
        with_rows(&format!("{name}: revolute {{}}")),
        with_cells(&format!("{name}: 1")),
        with_cells(&format!("a: {name}")),
    ] {
        assert_eq!(refusal(&call), [message.as_str()]);
    }
    let fitting = "n".repeat(MOST_LETTERS);
    let call = with_head(
        &format!("{{ {fitting}: f64 }}"),
        &format!("mass: {fitting}"),
    );
    assert_eq!(refusal(&call), [""; 0]);
}

#[test]
fn delimiters_without_end() {
    let nested = |depth: usize, open: &str, close: &str| {
        format!("{}{}", open.repeat(depth), close.repeat(depth))
    };
    for (open, close, what) in [
        ("(", ")", "parentheses"),
        ("[", "]", "brackets"),
        ("{", "}", "braces"),
    ] {
        let message = format!("{what} nested more than {DEEPEST_DELIMITERS} deep");
        let deep = nested(10_000, open, close);
        for call in [
            with_cells(&format!("a: {deep}")),
            with_cells(&format!("inertia: {deep}")),
            with_head(&format!("{{ m: {deep} }}"), "mass: m"),
            format!("#[doc {deep}] {}", with_cells("")),
            format!("@[{deep}] {}", with_cells("")),
        ] {
            assert_eq!(refusal(&call), [message.as_str()]);
        }
    }
    let conditions = nested(10_000, "cfg_attr(unix, ", ")");
    assert_eq!(
        refusal(&format!("#[{conditions}] {}", with_cells(""))).len(),
        1
    );
}

#[test]
fn the_struct_is_there_after_a_table_that_cannot_be_read() {
    let deep = format!("a: {}1{}", "(".repeat(10_000), ")".repeat(10_000));
    let (items, _) = expansion(&with_cells(&deep), SOON);
    assert_eq!(errors(&items).len(), 1);
    assert!(items.contains("struct Arm") && items.contains("fn jacobian"));
    // A struct that cannot be read is not repaired.
    let (items, _) = expansion(&with_head(&format!("{{ m: {} }}", &deep[3..]), ""), SOON);
    assert_eq!(errors(&items).len(), 1);
    assert!(!items.contains("struct Arm"));
}

#[test]
fn errors_without_end() {
    let wrong = |n: usize, item: &str| -> String { (0..n).map(|_| item).collect() };
    let lets: String = (0..2_000).map(|i| format!("let name{i} = 1;")).collect();
    for call in [
        with_cells(&wrong(30_000, "b: 1,")),
        with_cells(&wrong(30_000, "a = 1;")),
        with_head(&format!("; {}", wrong(15_000, "const X: f64 = 1;")), ""),
        with_head(&format!("; {}", wrong(15_000, "static X = 1,")), ""),
        with_head(&format!("; {}", wrong(50_000, "#")), ""),
        with_head(&format!("; {lets} {}", wrong(20_000, "let y = nome;")), ""),
        with_head(&format!("{{ {} }}", wrong(30_000, "x,")), ""),
        with_head(&format!("{{ x: {} }}", wrong(80_000, "f64 ")), ""),
        with_head(&format!("{{ x: {} }}", wrong(40_000, "Vec<")), ""),
        with_rows(&wrong(20_000, "joint,")),
        format!(
            "{} functions: [{}]",
            with_cells(""),
            wrong(40_000, "jacobean,")
        ),
    ] {
        let messages = refusal(&call);
        assert!(
            (1..=MOST_ERRORS).contains(&messages.len()),
            "{}",
            messages.len()
        );
        if messages.len() == MOST_ERRORS {
            assert!(messages.concat().contains("(more errors than are shown)"));
        }
        assert!(messages.iter().all(|message| message.len() < 1_000));
    }
}

#[test]
fn thousands_of_fields() {
    let fields = |n: usize| -> String { (0..n).map(|i| format!("x{i}: f64,")).collect() };
    let unused = with_head(&format!("{{ {} }}", fields(5_000)), "mass: 1");
    assert_eq!(refusal(&unused).len(), MOST_ERRORS);
    // 3,000 fields, each in one cell.
    let sum = |first: usize| -> String {
        let terms: Vec<String> = (first..first + 300).map(|i| format!("x{i}")).collect();
        terms.join(" + ")
    };
    let cells = format!(
        "a: {}, d: {}, theta: {}, alpha: {}, mass: {}, com: [{}, {}, {}], inertia: {{ xx: {}, yz: {} }}",
        sum(0),
        sum(300),
        sum(600),
        sum(900),
        sum(1200),
        sum(1500),
        sum(1800),
        sum(2100),
        sum(2400),
        sum(2700)
    );
    let row = |name: &str| format!("{name}: revolute {{ {cells} }}");
    let call = format!(
        "struct Arm {{ {} }} convention: standard, gravity: [0, 0, -9.81], joints: [{}, {}, {}]",
        fields(3_000),
        row("one"),
        row("two"),
        row("three")
    );
    let (items, _) = expansion(&call, IN_SECONDS);
    assert!(errors(&items).is_empty());
}

#[test]
fn numbers_without_end() {
    let digits = |n: usize| "7".repeat(n);
    for (cell, message) in [
        (digits(10_000), "more than 100 digits"),
        (format!("0.{}", digits(10_000)), "more than 100 digits"),
        (
            "1e99999999".to_owned(),
            "this number is larger than the largest `f64`",
        ),
        (
            "1e-99999999".to_owned(),
            "this number is smaller than the smallest `f64`, but not zero",
        ),
        (
            format!("1e{}", digits(10_000)),
            "this number is larger than the largest `f64`",
        ),
        (
            "1e300 * 1e300".to_owned(),
            "this value is larger than the largest `f64`",
        ),
    ] {
        assert_eq!(refusal(&with_cells(&format!("a: {cell}"))), [message]);
    }
    let factors: Vec<String> = (1..=40).map(|i| format!("{i}{}", digits(90))).collect();
    let product = format!("1 / {}", factors.join(" / "));
    let message =
        "the exact value of this is a fraction of more than 1,200 digits: write a decimal number";
    assert_eq!(refusal(&with_cells(&format!("a: {product}"))), [message]);
}

/// Fractions of many digits in every cell: each is small enough, all together are not.
#[test]
fn digits_of_all_cells() {
    let mut seed = 0_u64;
    let mut fraction = |digits: usize| {
        let mut literal = String::new();
        while literal.len() < digits {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            literal += &(seed >> 33).to_string();
        }
        format!("1.{}", &literal[..digits])
    };
    let mut value = || {
        let parts: Vec<String> = (0..6)
            .map(|_| format!("{} / {}", fraction(98), fraction(98)))
            .collect();
        format!("({} / 1000)", parts[0..1].join(" * "))
    };
    let mut row = |name: &str| {
        let v: Vec<String> = (0..7).map(|_| value()).collect();
        format!(
            "{name}: revolute {{ a: {}, alpha: 1, d: {}, theta: 1, mass: {}, com: [{}, {}, {}], \
             inertia: sphere({}) }}",
            v[0], v[1], v[2], v[3], v[4], v[5], v[6]
        )
    };
    let six: Vec<String> = ["a", "b", "c", "d", "e", "f"]
        .iter()
        .map(|name| row(name))
        .collect();
    let (items, _) = expansion(&with_rows(&six.join(",")), IN_SECONDS);
    assert_eq!(errors(&items), [""; 0]);
    let many: Vec<String> = (0..60).map(|i| row(&format!("joint{i}"))).collect();
    let message = "the exact fractions of this table have more than 75,000 digits in all: write decimal numbers";
    assert_eq!(refusal(&with_rows(&many.join(","))), [message]);
}

/// A value of 500 terms in every cell, with pi, so that no number can be made of it early.
#[test]
fn constants_that_cannot_be_folded() {
    let product = |sign: &str| -> String {
        let factors: Vec<String> = (1..=90).map(|i| format!("(PI {sign} {i})")).collect();
        format!("{} / 1e120", factors.join(" * "))
    };
    let (plus, minus) = (product("+"), product("-"));
    let cells = format!(
        "a: {plus}, alpha: {plus}, d: {minus}, theta: {minus}, mass: 1 + ({plus}) / 1e20, \
         com: [1 / ({plus} + 1), {minus}, {plus}]"
    );
    let row = |name: &str| format!("{name}: revolute {{ {cells} }}");
    let call = with_rows(&format!("{}, {}, {}", row("one"), row("two"), row("three")));
    let (items, _) = expansion(&call, IN_SECONDS);
    assert_eq!(errors(&items), [""; 0]);
}

#[test]
fn divisors_that_are_zero() {
    let zeros = [
        "x - x",
        "(x + 1) * (x - 1) - x * x + 1",
        "PI - PI",
        "1 - 1",
        "deg(180) - PI",
        "0 * x",
        "1 / x - 1 / x",
    ];
    for zero in zeros {
        let head = format!("{{ x: f64 }} let y = x * ({zero});");
        for divisor in [format!("({zero})"), "y".to_owned()] {
            let call = with_head(&head, &format!("a: 1 / {divisor}, mass: x"));
            assert_eq!(refusal(&call), ["division by zero"], "{divisor}");
        }
    }
}

#[test]
fn tables_without_content() {
    for call in [
        "",
        ";",
        "struct",
        "struct Arm",
        "struct Arm;",
        "@",
        "@[]",
        "{}",
        "#",
        "#[doc]",
        "joints: []",
        "struct Arm(;)",
    ] {
        assert!(!refusal(call).is_empty(), "{call}");
    }
    let empty = "struct Arm; convention: standard, gravity: [0, 0, 0], joints: []";
    assert_eq!(
        refusal(empty),
        ["no joints: a robot has at least one, or a base that moves, `base: floating`"]
    );
}
