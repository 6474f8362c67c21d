//! Robots with branches: values that others have printed, and what the proof refuses.

use dynamics_symbolic::Function;
use dynamics_symbolic::derive::derive_plain;
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::program::{Operand, Program};
use dynamics_symbolic::prove::{Assignment, Cause, Definition, Number, prove};
use dynamics_symbolic::robot::{
    Body, Carrier, Convention, Coupling, Frame, Interpretation, JointType, Mount, Placement, Robot,
    Row, Symbol, Value,
};
use expect_test::expect_file;
use interpreter::At;

pub(crate) fn ratio(a: i64, b: u64) -> Value {
    Value::Rational(Rational::from_parts_signed(a.into(), b.into()))
}

pub(crate) fn vector(halves: [i64; 3]) -> [Value; 3] {
    halves.map(|x| ratio(x, 2))
}

pub(crate) fn at(xyz: [Value; 3]) -> Vec<Placement> {
    let rpy = vector([0; 3]);
    vec![Placement { xyz, rpy }]
}

/// The Y of three joints of KDL's `treeinvdyntest.cpp`, by its fields m, I, L and g: two links on the first one, at L and
/// at 2 L along its x axis.
pub(crate) fn y_tree(convention: Convention) -> Robot {
    let [m, inertia, length, g] = [0, 1, 2, 3].map(Value::field);
    let zero = Value::zero;
    let along = |x: Value| [x, zero(), zero()];
    let link = |com: Value| Row {
        mass: m.clone(),
        com: along(com),
        inertia: [zero(), zero(), inertia.clone(), zero(), zero(), zero()],
        ..Row::new("link", JointType::Revolute)
    };
    let half = length.clone() * ratio(1, 2);
    let twice = length.clone() + length.clone();
    let (first, on_first, places) = match convention {
        Convention::Modified => (length.clone(), twice.clone(), at(vector([0; 3]))),
        // The link frame is at the end of the link, where the second one begins.
        Convention::Standard => (zero(), zero(), at(along(length.clone()))),
    };
    let mut rows = vec![link(first), link(half.clone()), link(half)];
    match convention {
        Convention::Modified => (rows[1].a, rows[2].a) = (length.clone(), on_first),
        Convention::Standard => rows[0].a = length.clone(),
    }
    rows[2].on = Carrier::Row(0);
    rows[2].at = places;
    Robot {
        name: "Y".to_owned(),
        fields: ["m", "I", "L", "g"].map(str::to_owned).to_vec(),
        convention,
        gravity: [zero(), -g, zero()],
        rows,
        frames: Vec::new(),
        neglected: None,
        bounds: Default::default(),
        base: None,
        tool: None,
    }
}

/// tau as KDL's test has it, at a point of the field.
fn torques_of_y(point: &mut Assignment) -> Vec<Number> {
    let [m, inertia, length, g] = [0, 1, 2, 3].map(|field| point.field(field));
    let mut number = |a: i64, b: u64| {
        let x = Rational::from_parts_signed(a.into(), b.into());
        Interpretation::rational(point, &x)
    };
    let [half, quarter, two] = [(1, 2), (1, 4), (2, 1)].map(|(a, b)| number(a, b));
    let [three, four, long] = [(3, 1), (4, 1), (13, 2)].map(|(a, b)| number(a, b));
    let [first, second, third] = [0, 1, 2].map(|i| point.joints()[i]);
    let [(s1, c1), (s2, c2), (s3, c3)] = [first, second, third].map(|joint| joint.sin_cos);
    let [v1, v2, v3] = [first, second, third].map(|joint| joint.qd);
    let [a1, a2, a3] = [first, second, third].map(|joint| joint.qdd);
    let (c12, c13) = (c1 * c2 - s1 * s2, c1 * c3 - s1 * s3);
    let mll = m * length * length;
    let end = inertia + quarter * mll;
    let weight = m * g * length;
    vec![
        (three * inertia + long * mll + mll * c2 + two * mll * c3) * a1
            + (end + half * mll * c2) * a2
            + (end + mll * c3) * a3
            - half * mll * s2 * v2 * v2
            - mll * s3 * v3 * v3
            - mll * s2 * v1 * v2
            - two * mll * s3 * v1 * v3
            + weight * (four * c1 + half * c12 + half * c13),
        (end + half * mll * c2) * a1 + end * a2 + half * mll * s2 * v1 * v1 + half * weight * c12,
        (end + mll * c3) * a1 + end * a3 + mll * s3 * v1 * v1 + half * weight * c13,
    ]
}

#[test]
fn the_definition_of_a_tree_is_kdls_formula() {
    for convention in [Convention::Modified, Convention::Standard] {
        let robot = y_tree(convention);
        let point = &mut Assignment::new(&robot, 11);
        let definition = Definition::new(point, &robot);
        let expected = Some(torques_of_y(point));
        let found = definition.expected(Function::InverseDynamics, &[]);
        assert_eq!(found, expected, "{convention:?}");
    }
}

/// The tree of five joints of RBDL's `CalcDynamicSimpleTree3D`: axes z, y, x, y, x, unit masses and tensors.
pub(crate) fn tree_of_five() -> Robot {
    let quarter = || Value::Pi * ratio(1, 2);
    let (x, y, z) = (
        [Value::zero(), quarter()],
        [quarter(), quarter()],
        [0, 0].map(Value::integer),
    );
    // Carrier, place on it and centre of mass in halves of a metre, axis.
    let joints = [
        (Carrier::Above, [0, 0, 0], [2, 0, 0], z),
        (Carrier::Above, [2, 0, 0], [0, 2, 0], y.clone()),
        (Carrier::Above, [0, 2, 0], [0, 0, 2], x.clone()),
        (Carrier::Row(0), [-1, 0, 0], [0, 2, 0], y),
        (Carrier::Above, [0, -1, 0], [0, 0, 2], x),
    ];
    let row = |(on, place, com, axis)| Row {
        on,
        at: at(vector(place)),
        mass: Value::integer(1),
        com: vector(com),
        inertia: [1, 1, 1, 0, 0, 0].map(Value::integer),
        mount: Some(Mount { axis, tip: None }),
        ..Row::new("joint", JointType::Revolute)
    };
    Robot {
        name: "TreeOfFive".to_owned(),
        fields: Vec::new(),
        gravity: [Value::zero(), ratio(-981, 100), Value::zero()],
        rows: joints.map(row).to_vec(),
        ..y_tree(Convention::Modified)
    }
}

#[test]
fn accelerations_of_a_tree_are_rbdls() {
    let robot = tree_of_five();
    let program = derive_plain(&robot, Function::ForwardDynamics);
    let printed = [
        -1.603_190_661_478_60,
        -0.534_396_887_159_533,
        4.103_404_669_260_70,
        0.267_198_443_579_767,
        5.305_797_665_369_65,
    ];
    // All positions, velocities and forces are zero.
    let rest = |symbol: &Symbol| f64::from(matches!(symbol, Symbol::Cosine(_)));
    let found = program.evaluate(&mut At(rest));
    for (found, printed) in found.iter().zip(printed) {
        assert!((found - printed).abs() < 1e-13, "{found} {printed}");
    }
    assert_eq!(prove(&robot, Function::ForwardDynamics, &program), Ok(()));
}

/// Joints of which neither carries the other have no inertia in common, and do not accelerate each other.
#[test]
fn entries_between_branches_are_the_constant_zero() {
    let mut robot = tree_of_five();
    robot.rows[3].on = Carrier::Base;
    let n = robot.rows.len();
    for (function, matrices) in [
        (Function::MassMatrix, 1),
        (Function::InverseDynamicsDerivatives, 2),
        (Function::ForwardDynamicsDerivatives, 3),
    ] {
        let program = derive_plain(&robot, function);
        let point = &mut Assignment::new(&robot, 3);
        let values = program.evaluate(point);
        for matrix in values[..matrices * n * n].chunks(n * n) {
            for (i, j) in (0..3).flat_map(|i| [(i, 3), (i, 4), (3, i), (4, i)]) {
                assert_eq!(
                    matrix[n * i + j],
                    Some(Number::ZERO),
                    "{function:?} {i} {j}"
                );
            }
        }
        arms::assert_zeros_are_constants(&robot, function, &program);
        assert_eq!(prove(&robot, function, &program), Ok(()));
    }
}

/// The programs of a tree are refused for every tree in which one row has another parent or place, and the other way
/// round.
#[test]
fn a_program_of_another_tree_is_refused() {
    let tree = tree_of_five();
    let functions = [
        Function::InverseDynamics,
        Function::MassMatrix,
        Function::LinkPoses,
    ];
    let programs = |robot: &Robot| functions.map(|function| derive_plain(robot, function));
    let own = programs(&tree);
    let mut others = Vec::new();
    for i in 1..5 {
        let mut moved = tree.clone();
        moved.rows[i].at[0].xyz[0] = ratio(7, 5);
        others.push(moved);
        let carriers = (0..i).map(Carrier::Row).chain([Carrier::Base]);
        for carrier in carriers {
            let mut other = tree.clone();
            other.rows[i].on = carrier;
            if other.parent(i) != tree.parent(i) {
                others.push(other);
            }
        }
    }
    assert_eq!(others.len(), 14);
    for other in others {
        let of_other = programs(&other);
        for (k, function) in functions.into_iter().enumerate() {
            assert_eq!(prove(&tree, function, &own[k]), Ok(()));
            assert_eq!(prove(&other, function, &of_other[k]), Ok(()));
            for (robot, program) in [(&tree, &of_other[k]), (&other, &own[k])] {
                let refusal = prove(robot, function, program).map_err(|failure| failure.cause);
                assert!(matches!(refusal, Err(Cause::Output(_))), "{refusal:?}");
            }
        }
    }
}

fn loaded(on: Option<usize>, mass: i64) -> Frame {
    Frame {
        name: "hand".to_owned(),
        on,
        places: at(vector([1, 2, 3])),
        body: Some(Body {
            mass: Value::integer(mass),
            com: vector([1, 0, 0]),
            inertia: [3, 2, 2, 1, 0, 0].map(Value::integer),
        }),
    }
}

/// The body of a frame is a part of the link that carries it, and none of another link. On the base it counts nowhere.
#[test]
fn bodies_of_frames_are_parts_of_their_links() {
    let of = |frames: Vec<Frame>| Robot {
        frames,
        ..tree_of_five()
    };
    let robot = of(vec![loaded(Some(4), 2)]);
    let others = [
        of(Vec::new()),
        of(vec![loaded(Some(4), 3)]),
        of(vec![loaded(Some(2), 2)]),
        of(vec![loaded(None, 2)]),
    ];
    let functions = [
        Function::InverseDynamics,
        Function::KineticEnergy,
        Function::BaseParameters,
        Function::CenterOfMass,
    ];
    for function in functions {
        let program = derive_plain(&robot, function);
        assert_eq!(prove(&robot, function, &program), Ok(()));
        for other in &others {
            assert!(prove(other, function, &program).is_err(), "{function:?}");
        }
        let without = derive_plain(&others[0], function);
        assert_eq!(prove(&others[3], function, &without), Ok(()));
    }
}

/// The functions of the tip, which are also those of frames.
pub(crate) fn of_tip() -> impl Iterator<Item = Function> {
    Function::ALL.into_iter().filter(|f| f.row().of_tip)
}

/// Nothing is proven of a tip that is not there.
#[test]
fn a_tree_of_two_tips_has_no_tip() {
    let tree = tree_of_five();
    assert_eq!(tree.tip_row(), None);
    let refused = of_tip().map(|function| {
        let program = derive_plain(&tree, function);
        prove(&tree, function, &program).map_err(|failure| failure.cause)
    });
    assert_eq!(refused.collect::<Vec<_>>(), [Err(Cause::Undefined); 7]);
}

/// A robot twice on one base, the second one moved along the base by `xyz`.
fn twice(robot: &Robot, xyz: [Value; 3]) -> Robot {
    let mut both = robot.clone();
    let count = robot.rows.len();
    for (i, row) in robot.rows.iter().enumerate() {
        let mut row = row.clone();
        row.on = robot
            .parent(i)
            .map_or(Carrier::Base, |parent| Carrier::Row(count + parent));
        if robot.parent(i).is_none() {
            row.at = [at(xyz.clone()), row.at].concat();
        }
        both.rows.push(row);
    }
    both
}

fn counts(robot: &Robot, function: Function) -> [u32; 3] {
    let count = crate::derive(robot, function).operations();
    [count.multiplications, count.additions, count.divisions]
}

/// Entries of M that couple the two arms are zero and cost nothing, and each arm is searched as if it stood alone.
#[test]
fn two_arms_on_one_base_are_twice_one_arm() {
    let functions = [
        Function::MassMatrix,
        Function::CoriolisVector,
        Function::GravityVector,
        Function::InverseDynamics,
        Function::ForwardDynamics,
        Function::InverseDynamicsDerivatives,
        Function::Regressor,
    ];
    for (name, functions) in [("puma560", &functions[..]), ("panda", &functions[..5])] {
        let one = crate::without_friction(name);
        let two = twice(&one, vector([2, 0, 0]));
        for &function in functions {
            let [mul, add, div] = counts(&one, function).map(|alone| 2 * alone);
            let both = counts(&two, function);
            // The search takes the first of equally short ways to write a sum, which leads one PUMA to one more
            // multiplication.
            let is_led_astray = name == "puma560" && function == Function::InverseDynamics;
            let expected = [mul + u32::from(is_led_astray), add, div];
            assert_eq!(both, expected, "{name} {function:?}");
        }
        // One addition joins the energies, of which a common factor may be taken out.
        for function in [Function::KineticEnergy, Function::PotentialEnergy] {
            let total = |robot: &Robot| counts(robot, function).iter().sum::<u32>();
            assert!(total(&two) <= 2 * total(&one) + 1, "{name} {function:?}");
        }
    }
}

/// A follower on the other arm makes one mechanism of both.
#[test]
fn arms_that_are_coupled_are_no_longer_apart() {
    let one = crate::without_friction("elbow_3r");
    let mut two = twice(&one, vector([2, 0, 0]));
    two.rows[5].follows = Some(Coupling {
        leader: 2,
        factor: Value::integer(-1),
        offset: Value::zero(),
    });
    for function in [Function::MassMatrix, Function::ForwardDynamics] {
        let program = crate::derive(&two, function);
        assert_eq!(prove(&two, function, &program), Ok(()));
    }
    // The leader feels both arms. The two other joints of the one do not feel those of the other.
    assert_eq!(upper_entries_of_m(&two), 15 - 4);
}

/// How many entries of M on its diagonal and above it are not zero.
fn upper_entries_of_m(robot: &Robot) -> usize {
    let program = crate::derive(robot, Function::MassMatrix);
    let values = program.evaluate(&mut Assignment::new(robot, 5));
    let n = robot.dof();
    let upper = (0..n).flat_map(|i| (i..n).map(move |j| (i, j)));
    let entries = upper.filter(|(i, j)| values[n * i + j] != Some(Number::ZERO));
    entries.count()
}

/// The legs of HyQ on a trunk that stands feel nothing of each other, and every leg takes what one leg takes.
#[test]
fn legs_on_a_fixed_trunk_are_apart() {
    let robot = arms::tree("hyq");
    assert_eq!(upper_entries_of_m(&robot), 24);
    let mut leg = robot.clone();
    leg.rows.truncate(3);
    for function in [
        Function::MassMatrix,
        Function::InverseDynamics,
        Function::ForwardDynamics,
        Function::InverseDynamicsDerivatives,
    ] {
        let expected = counts(&leg, function).map(|alone| 4 * alone);
        assert_eq!(counts(&robot, function), expected, "{function:?}");
    }
}

/// The operations of the robots with branches.
#[test]
fn snapshot_of_trees() {
    let mut table = String::from(
        "robot               function                        mul    add   div  total\n",
    );
    for name in arms::TREES {
        let robot = arms::tree(name);
        for function in Function::default_set(false) {
            let [mul, add, div] = counts(&robot, function);
            let total = mul + add + div;
            let function = function.name();
            table += &format!("{name:19} {function:28} {mul:6} {add:6} {div:5} {total:6}\n");
        }
    }
    expect_file!["../golden/trees.txt"].assert_eq(&table);
}

/// A chain that is cut into a tree has no longer equations of motion.
#[test]
fn a_tree_is_no_longer_than_the_chain_it_was_cut_from() {
    let chain = arms::generic_chain(6);
    let whole = crate::derive(&chain, Function::InverseDynamics).operations();
    for (row, on) in [
        (3, Carrier::Row(0)),
        (4, Carrier::Row(1)),
        (3, Carrier::Base),
    ] {
        let mut tree = chain.clone();
        tree.rows[row].on = on;
        let cut = crate::derive(&tree, Function::InverseDynamics).operations();
        assert!(cut.total() <= whole.total());
    }
}

/// How many operations read the fields of the robot alone.
fn operations_on_fields(program: &Program) -> usize {
    let is_constant = |known: &[bool], operand: &Operand| match *operand {
        Operand::Constant(_) => true,
        Operand::Input(i) => matches!(program.inputs[i as usize], Symbol::Field(_)),
        Operand::Result(i) => known[i as usize],
    };
    let instructions = program.instructions.iter();
    let known = instructions.fold(Vec::new(), |mut known, instruction| {
        let operands = instruction.operands();
        known.push(operands.iter().all(|operand| is_constant(&known, operand)));
        known
    });
    known.into_iter().filter(|is_known| *is_known).count()
}

/// A finger of three joints by its fields, so many times on a waist that turns, at places on both sides of it.
fn waist_with_fingers(count: i64) -> Robot {
    let field = |i: usize| Value::field(i);
    let names = [
        "m1", "m2", "m3", "x1", "x2", "x3", "y2", "i1", "i2", "i3", "l1", "l2",
    ];
    let link = |k: usize| Row {
        mass: field(k),
        com: [
            field(3 + k),
            if k == 1 { field(6) } else { Value::zero() },
            Value::zero(),
        ],
        inertia: [
            field(7 + k),
            field(7 + k),
            field(7 + k),
            Value::zero(),
            Value::zero(),
            Value::zero(),
        ],
        ..Row::new("finger", JointType::Revolute)
    };
    let quarter = || Value::Pi * ratio(1, 2);
    let mut rows = vec![Row {
        mass: Value::integer(9),
        com: vector([1, 0, 1]),
        inertia: [3, 2, 2, 0, 0, 0].map(Value::integer),
        ..Row::new("waist", JointType::Revolute)
    }];
    for side in 0..count {
        let first = rows.len();
        for k in 0..3 {
            rows.push(link(k));
        }
        rows[first].on = Carrier::Row(0);
        rows[first].at = at(vector([1, 1 - 2 * side, 2]));
        rows[first].alpha = quarter();
        rows[first + 1].a = field(10);
        rows[first + 1].alpha = quarter();
        rows[first + 2].a = field(11);
    }
    Robot {
        name: "Waist".to_owned(),
        fields: names.map(str::to_owned).to_vec(),
        gravity: vector([0, 0, -20]),
        rows,
        ..y_tree(Convention::Modified)
    }
}

/// A second hand takes the constants of the first one.
#[test]
fn equal_hands_have_the_same_constants() {
    let hands = [1, 2].map(waist_with_fingers);
    for function in Function::default_set(false) {
        let [one, two] = hands.each_ref().map(|robot| crate::derive(robot, function));
        let constants = [&one, &two].map(|program| operations_on_fields(program));
        // Gravity may act on both hands together, whose masses are then added.
        assert!(
            constants[1] <= constants[0] + 5,
            "{function:?} {constants:?}"
        );
    }
    let [one, two] = hands.map(|robot| counts(&robot, Function::BaseParameters));
    assert_eq!(one, two);
}

/// Two fingers that slide by themselves add a seventh to the forces of the arm that carries them.
#[test]
fn two_free_fingers_take_little() {
    let arm = crate::without_friction("panda");
    let hand = arms::tree("panda_with_fingers");
    assert_eq!(hand.dof(), arm.dof() + 2);
    for (function, most) in [
        (Function::InverseDynamics, 1.15),
        (Function::CoriolisVector, 1.151),
    ] {
        let [arm, hand] = [&arm, &hand].map(|robot| counts(robot, function).iter().sum::<u32>());
        assert!(
            f64::from(hand) <= most * f64::from(arm),
            "{function:?} {hand} {arm}"
        );
    }
}
