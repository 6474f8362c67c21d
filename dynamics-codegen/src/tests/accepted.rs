//! Calls that are accepted, and what they mean.

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{Convention, JointType, Value};
use dynamics_symbolic::{Function, Request};

use super::*;

/// The exact value of the cell `a`.
fn a(value: &str) -> Rational {
    let model = model(&with_cells(&format!("a: {value}")));
    let value = model.robot.rows[0].a.as_rational().cloned();
    value.expect("a rational number")
}

fn rational(text: &str) -> Rational {
    text.parse().unwrap()
}

const TWO_LINK: &str = "
    /// Two links.
    #[derive(Clone)]
    pub struct TwoLink { m1: f64, pub l1: f64, g: f64, }
    convention: modified,
    gravity: [0, -g, 0],
    let half = l1 / 2;
    joints: [
        /// The first joint.
        shoulder: revolute { mass: m1, com: [half, 0, 0], },
        r#type: prismatic {},
    ],
    functions: [mass_matrix, jacobian,],
    tests: true,
";

#[test]
fn a_whole_call() {
    let model = model(TWO_LINK);
    assert_eq!(model.robot.name, "TwoLink");
    assert_eq!(model.robot.fields, ["m1", "l1", "g"]);
    assert_eq!(model.robot.convention, Convention::Modified);
    assert_eq!(model.robot.gravity[1], -Value::field(2));
    let [shoulder, second] = model.robot.rows.as_slice() else {
        panic!("two rows");
    };
    assert_eq!(shoulder.name, "shoulder");
    assert_eq!(shoulder.joint_type, JointType::Revolute);
    assert_eq!(shoulder.mass, Value::field(0));
    let half = Value::field(1).checked_div(Value::integer(2)).unwrap();
    assert_eq!(shoulder.com[0], half);
    assert_eq!(second.name, "type");
    assert_eq!(second.joint_type, JointType::Prismatic);
    assert!(second.mass.is_zero());
    let requests: Vec<Request> = model.requests.iter().map(|(r, _)| r.clone()).collect();
    assert_eq!(
        requests,
        [Function::MassMatrix, Function::Jacobian].map(Request::from)
    );
    assert!(model.tests);
}

#[test]
fn arithmetic_is_exact() {
    for (value, exact) in [
        ("0.1 + 0.2", "3/10"),
        ("1 - 2 - 3", "-4"),
        ("2 * 3 + 4 * 5", "26"),
        ("2 * (3 + 4) * 5", "70"),
        ("8 / 4 / 2", "1"),
        ("-2 * -3", "6"),
        ("- -1", "1"),
        ("1 / 3 * 3", "1"),
        ("1e-3 * 1_000", "1"),
        ("0.0254 * 12f64", "381/1250"),
    ] {
        assert_eq!(a(value), rational(exact), "{value}");
    }
}

#[test]
fn degrees_are_exact_fractions_of_pi() {
    let model = model(&with_cells("alpha: deg(90), theta: deg(-180)"));
    let half = Value::Rational(rational("1/2"));
    assert_eq!(model.robot.rows[0].alpha, half * Value::Pi);
    assert_eq!(
        model.robot.rows[0].alpha.to_f64(&[]),
        core::f64::consts::FRAC_PI_2
    );
    assert_eq!(
        model.robot.rows[0].theta.to_f64(&[]),
        -core::f64::consts::PI
    );
}

/// Exactly where they are rational; else they are rounded once, with what is computed from them.
#[test]
fn functions_of_numbers() {
    for (value, exact) in [
        ("sqrt(9/4)", "3/2"),
        ("sqrt(0.3*0.3 + 0.4*0.4)", "1/2"),
        ("sin(PI/2) + cos(PI)", "0"),
        ("2 * sin(PI/6)", "1"),
        ("cos(deg(120))", "-1/2"),
        ("3 * cos(deg(60) + deg(30))", "0"),
    ] {
        assert_eq!(a(value), rational(exact), "{value}");
    }
    for (value, nearest) in [
        ("sqrt(2)", core::f64::consts::SQRT_2),
        ("sqrt(2)/2", core::f64::consts::FRAC_1_SQRT_2),
        ("sqrt(2) * sqrt(2)", 2.0),
        ("cos(PI/4)", core::f64::consts::FRAC_1_SQRT_2),
        ("sin(1)", 0.841_470_984_807_896_5),
        ("sin(0.3)*sin(0.3) + cos(0.3)*cos(0.3)", 1.0),
        // Digits that cancel in doubles: 1 - cos(1e-4) = 4.99999999583333334722222e-9
        ("1 - cos(1e-4)", 4.999_999_995_833_333e-9),
    ] {
        assert_eq!(a(value).to_f64().value(), nearest, "{value}");
    }
}

#[test]
fn solids_use_the_mass_of_the_row() {
    let model = model(&with_cells("mass: 3, inertia: rod(2)"));
    let inertia = &model.robot.rows[0].inertia;
    assert_eq!(inertia[0], Value::zero());
    assert_eq!(inertia[1], Value::integer(1));
    assert_eq!(inertia[2], Value::integer(1));
}

#[test]
fn solids_lie_along_an_axis() {
    let diagonal = |inertia: &str| {
        let model = model(&with_cells(&format!("mass: 12, inertia: {inertia}")));
        [0, 1, 2].map(|i| model.robot.rows[0].inertia[i].to_f64(&[]))
    };
    assert_eq!(diagonal("rod(1, axis = z)"), [1.0, 1.0, 0.0]);
    assert_eq!(diagonal("rod(1, axis = x)"), diagonal("rod(1)"));
    assert_eq!(diagonal("cylinder(1, 2, axis = y,)"), [7.0, 6.0, 7.0]);
    assert_eq!(
        diagonal("cylinder(1, 2, axis = z)"),
        diagonal("cylinder(1, 2)")
    );
}

/// The parallel-axis theorem, exactly, on numbers and on symbols: a rod of length l about its end.
#[test]
fn a_tensor_about_the_origin_is_moved_to_the_center_of_mass() {
    let table = |inertia: &str| {
        let call = with_cells(&format!("mass: m, com: [l/2, 0.1, -0.2], {inertia}"));
        model(&call.replace("Arm;", "Arm { m: f64, l: f64 }")).robot
    };
    let at_origin = table(
        "inertia_at_origin: {
            xx: m*0.05, yy: m*l*l/3 + m*0.04, zz: m*l*l/3 + m*0.01,
            xy: -m*l*0.05, xz: m*l*0.1, yz: m*0.02,
        }",
    );
    let about_com = table("inertia: rod(l)");
    let mut difference = at_origin.rows[0]
        .inertia
        .iter()
        .zip(&about_com.rows[0].inertia);
    let fields = [3.0, 0.7];
    assert!(difference.all(|(a, b)| (a.to_f64(&fields) - b.to_f64(&fields)).abs() < 1e-15));
    let exact = model(&with_cells(
        "mass: 3, com: [0.1, 0.2, 0.3],
         inertia_at_origin: { xx: 0.4, yy: 0.31, zz: 0.16, xy: -0.06, xz: -0.09, yz: -0.18 }",
    ));
    let entries = exact.robot.rows[0]
        .inertia
        .each_ref()
        .map(|entry| entry.as_rational().cloned());
    let expected = ["1/100", "1/100", "1/100", "0", "0", "0"].map(|text| Some(rational(text)));
    assert_eq!(entries, expected);
}

#[test]
fn tensors_that_some_body_has() {
    for tensor in [
        // A lamina, a slender rod, a point: the limits.
        "xx: 1, yy: 2, zz: 3",
        "xx: 0, yy: 0.08333333333333333, zz: 0.08333333333333333",
        "xx: 0, yy: 0, zz: 0",
        // A lamina in doubles: 0.1 + 0.2 is not 0.3 there.
        "xx: 0.1, yy: 0.2, zz: 0.30000000000000004",
        // A slender rod along the diagonal of the x and y axes, and along all three.
        "xx: 1, yy: 1, zz: 2, xy: -1",
        "xx: 2, yy: 2, zz: 2, xy: -1, yz: -1, xz: -1",
        "xx: 0.70337, yy: 0.70661, zz: 0.009117, xy: -0.000139, yz: 0.019169, xz: 0.006772",
        // The moment about one axis, all that matters of a planar link.
        "zz: 0.35",
        "",
    ] {
        model(&with_cells(&format!("mass: 1, inertia: {{ {tensor} }}")));
    }
}

#[test]
fn tensors_beyond_the_limits_where_the_row_allows_them() {
    let cells = "mass: 4.8, inertia: { xx: 0.066, yy: 0.086, zz: 0.0125 }";
    model(&with_cells(&format!(
        "{cells}, allow: [unphysical_inertia]"
    )));
    model(&with_cells("mass: 1, allow: [unphysical_inertia]"));
}

#[test]
fn friction_vector_is_in_the_default_set_where_a_row_has_friction() {
    let has_friction = |cells: &str| {
        let requests = model(&with_cells(cells)).requests;
        let friction = Request::from(Function::FrictionVector);
        requests.iter().any(|(request, _)| *request == friction)
    };
    assert!(has_friction("mass: 1, friction: { viscous: 0.1 }"));
    assert!(!has_friction("mass: 1, friction: { viscous: 0 }"));
    assert!(!has_friction("mass: 1"));
}

const MOUNTED: &str = "
    struct Mounted { tilt: f64, load: f64 }
    convention: modified,
    gravity: [0, 0, -9.81],
    let height = 0.8;
    base: { xyz: [0, 0, height], rpy: [0, tilt, PI / 2] },
    joints: [joint: revolute { mass: 1 }],
    tool: {
        rpy: [0, 0, deg(45)], mass: load, com: [0, 0, 0.05], inertia: sphere(1 / 2),
        allow: [unphysical_inertia],
    },
";

#[test]
fn a_base_and_a_tool() {
    let robot = model(MOUNTED).robot;
    let number = |text: &str| Value::Rational(rational(text));
    let base = robot.placement().expect("a base");
    assert_eq!(base.xyz[2], number("4/5"));
    assert_eq!(base.rpy[1], Value::field(0));
    assert_eq!(base.rpy[2].to_f64(&[]), core::f64::consts::FRAC_PI_2);
    let tool = robot.tool.expect("a tool");
    assert!(tool.placement.xyz.iter().all(Value::is_zero));
    assert_eq!(tool.placement.rpy[2], number("1/4") * Value::Pi);
    assert_eq!(tool.body.mass, Value::field(1));
    assert_eq!(tool.body.com[2], number("1/20"));
    assert_eq!(tool.body.inertia[0], Value::field(1) * number("1/10"));
}

#[test]
fn entries_of_base_and_tool_may_be_left_out() {
    let call = |entries: &str| format!("{} {entries}", with_cells("mass: 1"));
    let robot = model(&call("base: {}, tool: {},")).robot;
    let base = robot.placement().expect("a base");
    assert!(base.xyz.iter().chain(&base.rpy).all(Value::is_zero));
    assert!(!robot.tool.expect("a tool").has_body());
    let plain = model(&with_cells("mass: 1")).robot;
    assert!(plain.base.is_none() && plain.tool.is_none());
}

/// Published data break the inequality for tools as they do for links.
#[test]
fn a_tool_of_an_unphysical_tensor_where_it_is_allowed() {
    let tool = "tool: { mass: 1, inertia: { xx: 0.066, yy: 0.086, zz: 0.0125 }, allow: [unphysical_inertia] }";
    model(&format!("{} {tool}", with_cells("mass: 1")));
}

/// The default set and more, and tuples whose parts need not be generated on their own.
#[test]
fn functions_are_fused_by_name() {
    let requests = |functions: &str, cells: &str| {
        let call = format!("{} functions: [{functions}]", with_cells(cells));
        let requests = model(&call).requests.into_iter();
        requests.map(|(request, _)| request).collect::<Vec<_>>()
    };
    let found = requests(
        "default, jacobian, control_terms = (mass_matrix, gravity_vector,), r#type = (regressor, base_parameters)",
        "mass: 1",
    );
    let (default, more) = found.split_at(7);
    assert_eq!(
        default,
        Function::default_set(false)
            .into_iter()
            .map(Request::from)
            .collect::<Vec<_>>()
    );
    assert_eq!(more[0], Request::from(Function::Jacobian));
    assert_eq!(more[1].name(), "control_terms");
    assert_eq!(
        more[1].functions().collect::<Vec<_>>(),
        [Function::MassMatrix, Function::GravityVector]
    );
    assert_eq!(more[2].name(), "type");
    assert_eq!(found.len(), 10);
    // A function is requested once, whether the default set has it or not.
    for cells in ["mass: 1", "mass: 1, friction: { viscous: 1 }"] {
        let found = requests("mass_matrix, default, friction_vector", cells);
        for named in [Function::FrictionVector, Function::MassMatrix].map(Request::from) {
            let times = found.iter().filter(|request| **request == named).count();
            assert_eq!(times, 1, "{named:?}");
        }
    }
}

/// Limits the wrong way round are none where that is allowed.
#[test]
fn odd_limits_are_none() {
    let call = |allow: &str| {
        format!(
            "struct Arm; convention: standard, gravity: [0, 0, 0],
             joints: [joint: revolute {{ mass: 1, com: [1, 0, 0], limits: [1, -1] }}], allow: [{allow}]"
        )
    };
    assert!(message(&call("odd_mass")).contains("below the upper one"));
    assert_eq!(model(&call("odd_limits")).robot.rows[0].limits, None);
}

/// A joint that moves no mass is noted where a function solves with M, unless its motor has inertia.
#[test]
fn joints_that_move_no_mass_are_noted() {
    let notes = |last: &str, entries: &str| {
        let call = format!(
            "struct Arm; convention: standard, gravity: [0, 0, 0], joints: [
                first: revolute {{ mass: 1, com: [1, 0, 0] }}, second: revolute {{}}, third: revolute {{ {last} }},
            ], {entries} allow: [no_inertia]"
        );
        model(&call).notes
    };
    let both = notes("", "");
    assert_eq!(both.len(), 1);
    assert!(
        both[0].starts_with(" No mass moves with `second` and `third`: M is singular")
            && both[0].contains("`forward_dynamics` returns an error"),
        "{both:?}"
    );
    assert!(notes("motor: { inertia: 1, gear_ratio: 1 }", "")[0].contains("with `second`: M"));
    for (last, entries) in [
        ("mass: 1", ""),
        ("", "tool: { mass: 1 },"),
        ("", "couple: [second = first],"),
        ("", "lock: [second = 0, third = 0],"),
        ("", "functions: [mass_matrix, jacobian],"),
    ] {
        assert_eq!(notes(last, entries), [""; 0], "{last} {entries}");
    }
}
