//! Tables there and back, and what is wrong in them.

use nalgebra::{Dyn, Vector2};
use tables::CRAIG_ARM;

use super::super::trajectory::SizedTrajectory;
use super::CsvMistake;
use crate::Trajectory;

fn trajectory() -> Trajectory<2> {
    let values = [
        1.0 / 3.0,
        -0.0,
        f64::MIN_POSITIVE / 3.0,
        1.7e308,
        f64::INFINITY,
    ];
    let list = |shift: f64| values.map(|x| Vector2::new(x, x - shift)).to_vec();
    Trajectory {
        t: values.to_vec(),
        q: list(0.1),
        qd: list(0.2),
        qdd: list(0.3),
        tau: list(0.4),
        ..Trajectory::default()
    }
}

fn written(trajectory: &Trajectory<2>) -> String {
    let mut text = Vec::new();
    trajectory.write_csv(&CRAIG_ARM, &mut text).unwrap();
    String::from_utf8(text).unwrap()
}

/// Digits beyond the largest number are a mistake, where an infinity may stand too.
#[test]
fn digits_that_overflow_are_no_infinity() {
    let text = written(&trajectory());
    let overflowing = text.replace("\ninf,inf,", "\ninf,1e999,");
    assert_ne!(text, overflowing);
    let error = Trajectory::<2>::read_csv(overflowing.as_bytes());
    let mistake = error.map_err(|error| error.mistake);
    assert_eq!(mistake, Err(CsvMistake::Number("1e999".to_owned())));
}

#[test]
fn what_is_written_is_read_to_the_last_bit() {
    let (original, text) = (trajectory(), written(&trajectory()));
    let header = text.lines().next().unwrap();
    let first = "t [s],q.shoulder [rad],q.elbow [rad],qd.shoulder [rad/s],qd.elbow [rad/s],";
    assert!(header.starts_with(first), "{header}");
    assert!(header.ends_with("tau.elbow [N m],kinetic energy [J],potential energy [J]"));
    assert_eq!(
        Trajectory::<2>::read_csv(text.as_bytes()),
        Ok(original.clone())
    );
    // As other programs write it.
    let other = format!(
        "\u{feff}{}\r\n\r\n",
        text.replace('\n', "\r\n").replace(',', " , ")
    );
    assert_eq!(Trajectory::<2>::read_csv(other.as_bytes()), Ok(original));
    let nan = Trajectory {
        tau: vec![Vector2::repeat(f64::NAN); 5],
        ..trajectory()
    };
    let read = Trajectory::<2>::read_csv(written(&nan).as_bytes()).unwrap();
    assert!(read.tau.iter().all(|tau| tau[0].is_nan()));
}

#[test]
fn positions_and_velocities_alone_are_a_trajectory() {
    let text = "t,q.a,q.b,qd.a,qd.b\n0,1,2,3,4\n";
    let read = Trajectory::<2>::read_csv(text.as_bytes()).unwrap();
    assert_eq!(
        (read.q[0], read.qd[0]),
        (Vector2::new(1.0, 2.0), Vector2::new(3.0, 4.0))
    );
    assert!(read.qdd.is_empty() && read.tau.is_empty());
    let without = Trajectory {
        qdd: vec![],
        tau: vec![],
        ..trajectory()
    };
    let read = Trajectory::<2>::read_csv(written(&without).as_bytes());
    assert_eq!(read, Ok(without));
}

/// Points that were read have no velocities, nor has a motion that a program made.
#[test]
fn positions_alone_are_written() {
    let without = Trajectory {
        qd: vec![],
        ..trajectory()
    };
    let text = written(&without);
    let header = text.lines().next().unwrap();
    let places = "t [s],q.shoulder [rad],q.elbow [rad]";
    assert!(
        header.starts_with(&format!("{places},qdd.shoulder")),
        "{header}"
    );
    assert!(header.ends_with("tau.elbow [N m]"), "{header}");
    let alone = Trajectory {
        qdd: vec![],
        tau: vec![],
        ..without
    };
    let text = written(&alone);
    assert!(
        text.starts_with(&format!("{places}\n0.3333333333333333,")),
        "{text}"
    );
    assert_eq!(text.lines().count(), 6);
    // A velocity that is missing is missing at all times.
    let mut short = trajectory();
    short.qd.pop();
    (short.qdd, short.tau) = (vec![], vec![]);
    assert_eq!(written(&short), text);
    let read = |joints: &[&str], text: &str| {
        SizedTrajectory::<Dyn>::read_points(joints, false, text.as_bytes()).unwrap()
    };
    let points = read(&["shoulder", "elbow"], "0,1,2\n1,3,4\n");
    let arm = CRAIG_ARM;
    let motion = Trajectory::<2> {
        t: points.t,
        q: points.q.iter().map(|q| Vector2::new(q[0], q[1])).collect(),
        ..Trajectory::default()
    };
    let mut text = Vec::new();
    motion.write_csv(&arm, &mut text).unwrap();
    let text = String::from_utf8(text).unwrap();
    assert_eq!(text, format!("{places}\n0,1,2\n1,3,4\n"));
    assert_eq!(motion.energy_drift(&arm), 0.0);
}

#[test]
fn mistakes_say_where_they_are() {
    let header = "t,q.a,q.b,qd.a,qd.b";
    let found = |text: &str| Trajectory::<2>::read_csv(text.as_bytes()).unwrap_err();
    let expected = |symbol: &str| CsvMistake::Header {
        expected: symbol.into(),
    };
    let cells = |found: usize| CsvMistake::Cells { found, expected: 5 };
    for (text, line, column, mistake) in [
        ("".into(), 1, 1, expected("t")),
        ("x,y".into(), 1, 1, expected("t")),
        ("t,q.a,qd.a".into(), 1, 3, expected("q")),
        ("t,q.a,q.b,q.c,qd.a,qd.b,qd.c".into(), 1, 4, expected("qd")),
        (
            format!("{header}\n0,1,2,3,4\n0,1,x,3,4"),
            3,
            3,
            CsvMistake::Number("x".into()),
        ),
        (
            format!("{header}\r\n\r\n0,1,2,3,4\r\n\"0\", 1,x,3,4"),
            4,
            3,
            CsvMistake::Number("x".into()),
        ),
        (
            format!("{header}\n0,1,2,3,"),
            2,
            5,
            CsvMistake::Number(String::new()),
        ),
        (format!("{header}\n0,1,2,3"), 2, 5, cells(4)),
        (format!("{header}\n0,1,2,3,4,5"), 2, 6, cells(6)),
        (
            format!("{header}\n0;1;2;3;4"),
            2,
            1,
            CsvMistake::Number("0;1;2;3;4".into()),
        ),
    ] {
        let error = found(&text);
        let place = (error.line, error.column);
        assert_eq!((place, error.mistake), ((line, column), mistake), "{text}");
    }
    assert_eq!(
        found("0").to_string(),
        "line 1, column 1: a column `t` was expected"
    );
}

#[test]
fn points_have_a_header_or_none() {
    let read =
        |text: &str| SizedTrajectory::<Dyn>::read_points(&["a", "b,c"], false, text.as_bytes());
    for header in [
        "",
        "t,a,\"b,c\"\n",
        "time,q_a,x\n",
        "t [s],q.a [rad],\"q.b,c [m]\"\n",
    ] {
        let points = read(&format!("{header}0,1,2\n \n1,3,4\n")).unwrap();
        assert_eq!((points.len(), points.q[1][1], points.qd.len()), (2, 4.0, 0));
    }
    let points = read("t,q.a,q.b,qd.a,qd.b,energy\n0,1,2,3,4,no\n1,1,2,5,6,x\n").unwrap();
    assert_eq!((points.qd[1][1], points.qdd.len()), (6.0, 0));
    for (text, place, letter, message) in [
        (
            "0,1\n",
            (1, 1),
            1,
            "found 2 numbers, expected 3 separated by commas",
        ),
        ("\"0\",\"1\",fast\n", (1, 3), 9, "`fast`: expected a number"),
        ("0,1,2\n1,inf,2\n", (2, 2), 3, "`inf`: expected a number"),
        (
            "0,1,2\r\n\r\n0,1,2\n",
            (3, 1),
            1,
            "times must grow from row to row",
        ),
        (
            "t,a,b\n0,1,2\n",
            (1, 1),
            1,
            "expected two rows of numbers or more",
        ),
        ("t,q_a,q_b,qd_a\n", (1, 5), 15, "a column `qd` was expected"),
        (
            "t,q_a\n0,1\n",
            (1, 1),
            1,
            "found 2 numbers, expected 3 separated by commas",
        ),
        (
            "t;q_a;q_b\n0;1;2\n",
            (1, 1),
            1,
            "found 1 number, expected 3 separated by commas",
        ),
        (
            "t,x,y\n0,\"1,5\",2\n",
            (2, 2),
            3,
            "`1,5`: expected a number with a decimal point",
        ),
        (
            "t,x,y\n0;1;2\n",
            (2, 1),
            1,
            "`0;1;2`: expected a number, and commas between numbers",
        ),
        (
            "t [ms],x,y\n0,1,2\n",
            (1, 1),
            1,
            "a column in `ms`: expected one in s",
        ),
        (
            "t [s],q.a [rad],q.b [deg]\n0,1,2\n",
            (1, 3),
            17,
            "a column in `deg`: expected one in rad, or m",
        ),
    ] {
        let error = read(text).unwrap_err();
        let found = ((error.line, error.column), error.letter);
        assert_eq!(found, (place, letter), "{text}");
        assert_eq!(error.mistake.to_string(), message, "{text}");
    }
    let error = read("t,q.\u{e4},\"q.a [m]\"\n").unwrap_err();
    assert_eq!((error.line, error.column, error.letter), (1, 3, 7));
    let expected = "line 1, column 3: a column of `a`, expected one of `b,c`: columns are in the order of the joints";
    assert_eq!(error.to_string(), expected);
}
