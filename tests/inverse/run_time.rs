//! Closed forms of robots at run time: the same numbers, bit for bit.

use robot_dynamics::closed_form::NoSolution;
use robot_dynamics::evaluation::{ClosedForm, ReadOptions, RuntimeRobot};
use robot_dynamics::nalgebra::Matrix4;

use crate::arms::*;
use crate::{Inverse, Random};

/// Rows of a call as a table in TOML.
pub(crate) fn table(rows: &str) -> String {
    let row = |row: &str| {
        let (head, cells) = row.split_once('{')?;
        let (name, joint_type) = head.split_once(':')?;
        let name = name.trim_start_matches([',', ' ', '\n']);
        let cells = cells.split(',').filter_map(|cell| cell.split_once(':'));
        let cells = cells.map(|(word, value)| format!(", {} = \"{}\"", word.trim(), value.trim()));
        let cells: String = cells.collect();
        Some(format!(
            "    {{ name = \"{}\", type = \"{}\"{cells} }},\n",
            name.trim(),
            joint_type.trim()
        ))
    };
    let rows: String = rows.split('}').filter_map(row).collect();
    format!("convention = \"standard\"\ngravity = [0, 0, -9.81]\njoint = [\n{rows}]\n")
}

fn closed_form(rows: &str) -> ClosedForm {
    let options = ReadOptions::new().functions(["forward_kinematics"]);
    let robot = RuntimeRobot::from_toml(&table(rows), &options).expect("a table");
    robot.closed_form(None).expect("a closed form")
}

/// 2,000 poses of six arms.
#[test]
fn robots_at_run_time_have_the_same_solutions() {
    fn check<const N: usize, A: Inverse<N>>(arm: &A, rows: &str) {
        let form = closed_form(rows);
        let mut random = Random(19);
        for _ in 0..2_000 {
            let q = random.joints();
            let (pose, elbow) = (arm.pose(&q), 3.0 * random.next());
            let expected = arm.solutions(&pose, elbow);
            let found = form.solutions(&pose, Some(elbow)).expect("a pose in reach");
            assert_eq!(found.len(), expected.len(), "{}", A::NAME);
            for (found, expected) in found.iter().zip(&expected) {
                assert_eq!(found.q, expected.q.as_slice(), "{}", A::NAME);
                assert_eq!(found.is_singular, expected.is_singular);
                assert_eq!(found.branch, expected.branch);
            }
        }
    }
    check(&Puma560, Puma560::ROWS);
    check(&Ur5e, Ur5e::ROWS);
    check(&Stanford, Stanford::ROWS);
    check(&Iiwa14, Iiwa14::ROWS);
    check(&Scara, Scara::ROWS);
    check(&So100, So100::ROWS);
}

/// Angles of an elbow, poses that leave joints free, and poses without a solution.
#[test]
fn robots_at_run_time_have_the_same_edges() {
    let form = closed_form(Iiwa14::ROWS);
    let mut random = Random(23);
    for _ in 0..200 {
        let q = random.joints::<7>();
        let elbow = form.elbow_angle(q.as_slice()).expect("seven positions");
        assert_eq!(elbow, Some(Iiwa14.elbow_angle(&q)));
    }
    assert!(form.elbow_angle(&[0.0; 6]).is_err());
    let puma = closed_form(Puma560::ROWS);
    assert_eq!(puma.elbow_angle(&[0.0; 6]), Ok(None));
    assert_eq!(
        puma.solutions(&Matrix4::zeros(), None),
        Err(NoSolution::NotAPose)
    );
    let ur = closed_form(Ur5e::ROWS);
    let mut q = [0.3, -0.9, 0.7, 0.4, 0.0, 0.2];
    for wrist in [0.0, 1e-9, -1e-12, 3e-8] {
        q[4] = wrist;
        let pose = Ur5e.forward_kinematics(&q.into());
        let expected = Ur5e.inverse_kinematics(&pose);
        let found = ur.solutions(&pose, None).expect("a pose in reach");
        let rows = found.iter().map(|one| one.q.clone());
        assert!(
            rows.eq(expected.iter().map(|one| one.q.as_slice().to_vec())),
            "{wrist}"
        );
    }
}
