//! Functions of frames: what the proof takes and refuses, what they cost, and their text.

use dynamics_symbolic::Function;
use dynamics_symbolic::derive::{derive, derive_plain, derive_together};
use dynamics_symbolic::function::{Part, Request};
use dynamics_symbolic::program::Program;
use dynamics_symbolic::prove::{Assignment, Cause, Number, prove, prove_together};
use dynamics_symbolic::robot::{Base, Coupling, Frame, Placement, Robot, Value};
use expect_test::expect_file;

use crate::damage::refused;
use crate::emission::text;
use crate::trees::{at, of_tip, ratio, tree_of_five, vector};

fn of_frame(function: Function, frame: usize) -> Part {
    let frame = Some(frame);
    Part { function, frame }
}

/// The robot with frames on a row in the middle, on the last row, and on the base.
fn with_frames(robot: Robot) -> Robot {
    let last = robot.rows.len() - 1;
    let frame = |on: Option<usize>, x: i64| Frame {
        name: format!("at {x}"),
        on,
        places: vec![Placement {
            xyz: vector([x, 2, 3]),
            rpy: [Value::integer(1), ratio(1, 2), Value::Pi * ratio(1, 2)],
        }],
        body: None,
    };
    let frames = [(Some(2), 1), (Some(last), 2), (None, 3)].map(|(on, x)| frame(on, x));
    Robot {
        frames: frames.to_vec(),
        base: at(vector([1, 0, 0])).pop().map(Base::Standing),
        ..robot
    }
}

/// The tree of five joints, the third of which is locked and the last of which follows one of another branch.
fn tree_of_three() -> Robot {
    let mut tree = tree_of_five();
    tree.rows[2].locked = Some(ratio(1, 3));
    tree.rows[4].follows = Some(Coupling {
        leader: 1,
        factor: Value::integer(-2),
        offset: ratio(1, 5),
    });
    Robot {
        name: "TreeOfThree".to_owned(),
        ..tree
    }
}

/// Functions of three frames of trees, of arms of both conventions and of one from a file, and together with M. A
/// program of another frame, or of the tip, is refused.
#[test]
fn functions_of_frames_are_proven() {
    let arms = ["stanford", "scara", arms::MOUNTED].map(arms::robot);
    let trees = [tree_of_five(), tree_of_three()];
    for robot in arms.into_iter().chain(trees) {
        let robot = with_frames(robot);
        for function in of_tip() {
            let parts = [0, 1, 2].map(|frame| of_frame(function, frame));
            let programs = parts.map(|part| derive_plain(&robot, part));
            for (part, program) in parts.iter().zip(&programs) {
                arms::assert_zeros_are_constants(&robot, *part, program);
                for other in parts {
                    let proof = prove(&robot, other, program).map_err(|failure| failure.cause);
                    let is_right = matches!(proof, Ok(())) == (*part == other);
                    assert!(is_right, "{} {part:?} {other:?}", robot.name);
                }
                assert!(prove(&robot, function, program).is_err());
            }
        }
        let parts = [
            Function::MassMatrix.into(),
            of_frame(Function::Jacobian, 0),
            of_frame(Function::Jacobian, 1),
            of_frame(Function::WrenchTorques, 0),
            of_frame(Function::WrenchTorques, 1),
        ];
        let program = derive_together(&robot, &parts);
        assert_eq!(prove_together(&robot, &parts, &program), Ok(()));
        let mut exchanged = parts;
        exchanged.swap(1, 2);
        assert!(prove_together(&robot, &exchanged, &program).is_err());
    }
}

/// A program is refused for every robot whose frame is on another link, or at another place, and the other way round.
#[test]
fn a_frame_somewhere_else_is_refused() {
    for robot in [tree_of_five(), tree_of_three()].map(with_frames) {
        let changed = |change: &dyn Fn(&mut Frame)| {
            let mut other = robot.clone();
            change(&mut other.frames[1]);
            other
        };
        let others = [
            changed(&|frame| frame.on = Some(3)),
            changed(&|frame| frame.on = Some(2)),
            changed(&|frame| frame.on = None),
            changed(&|frame| frame.places[0].xyz[2] = ratio(1501, 1000)),
            changed(&|frame| frame.places.push(frame.places[0].clone())),
        ];
        for part in of_tip().map(|function| of_frame(function, 1)) {
            let own = derive_plain(&robot, part);
            for other in &others {
                let of_other = derive_plain(other, part);
                assert_eq!(prove(other, part, &of_other), Ok(()));
                for (robot, program) in [(&robot, &of_other), (other, &own)] {
                    let refusal = prove(robot, part, program).map_err(|failure| failure.cause);
                    assert!(matches!(refusal, Err(Cause::Output(_))), "{part:?}");
                }
            }
        }
        // Its axes alone matter where these are told.
        let turned = changed(&|frame| frame.places[0].rpy[0] = Value::integer(2));
        for function in of_tip() {
            let program = derive_plain(&turned, of_frame(function, 1));
            let proof = prove(&robot, of_frame(function, 1), &program);
            assert_eq!(proof.is_err(), function == Function::ForwardKinematics);
        }
    }
}

#[test]
fn every_damage_to_functions_of_frames_is_found() {
    let robot = with_frames(tree_of_three());
    let parts = of_tip().map(|function| of_frame(function, 1));
    let refused = parts.map(|part| refused(&robot, part, &derive(&robot, part)));
    let count: usize = refused.sum();
    assert!(count > 300, "only {count} damages were made");
}

/// A frame on the base is a constant. For a frame on a row only the joints that carry it take operations, and the
/// columns of the others are the constant zero.
#[test]
fn joints_that_do_not_carry_a_frame_cost_nothing() {
    let tree = with_frames(tree_of_five());
    let arm = Robot {
        rows: tree.rows[..3].to_vec(),
        ..tree.clone()
    };
    let count = |program: &Program| {
        let operations = program.operations();
        (operations.total(), operations.sin_cos)
    };
    for function in of_tip().filter(|f| *f != Function::OperationalInertiaInverse) {
        let [on_row, on_base] = [0, 2].map(|frame| derive(&tree, of_frame(function, frame)));
        let of_arm = derive(&arm, of_frame(function, 0));
        assert_eq!(count(&on_row), count(&of_arm), "{function:?}");
        assert_eq!(count(&on_base), (0, 0), "{function:?}");
    }
    for function in [Function::Jacobian, Function::JacobianRate] {
        let part = of_frame(function, 0);
        let program = derive(&tree, part);
        arms::assert_zeros_are_constants(&tree, part, &program);
        let values = program.evaluate(&mut Assignment::new(&tree, 5));
        for row in values.chunks(5) {
            assert_eq!(row[3..], [Some(Number::ZERO); 2], "{function:?}");
        }
    }
}

#[test]
fn functions_of_frames_have_text() {
    let of_jacobian = |frame| of_frame(Function::Jacobian, frame);
    let parts = [Function::MassMatrix.into(), of_jacobian(0), of_jacobian(1)];
    let requests = [
        Request::of_frame(Function::ForwardKinematics, 1, "Right tip"),
        Request::of_frame(Function::Jacobian, 0, "Left tip"),
        Request::of_frame(Function::WrenchTorques, 1, "Right tip"),
        Request::fused("pinch", parts),
    ];
    expect_file!["../golden/fingers.rs"].assert_eq(&text(&arms::fingers(), &requests));
}
