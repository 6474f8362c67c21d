//! The page of an arm as a file.

use std::io::Write as _;

use clap::ArgMatches;
use dynamics_cli::page::{FUNCTIONS, Page, Start, shown_poses};
use dynamics_symbolic::Request;
use dynamics_symbolic::robot::Robot;

use crate::beside::fields;
use crate::failure::Failure;
use crate::load::{file_of, programs, read_with_fields, read_with_links};
use crate::state::{positions, refuse_pose, roll_pitch_yaw, vector};

/// The page.
pub(crate) fn run(given: &ArgMatches) -> Result<String, Failure> {
    let path = file_of(given);
    let mut robot = read_with_fields(path, given, FUNCTIONS.to_vec())?.robot;
    let poses = shown_poses(&mut robot);
    let start = start(given, &robot)?;
    // The values that the fields have at first are judged as those of a file without fields.
    read_with_links(path, given, 0)?;
    let requests = FUNCTIONS.map(Request::from).into_iter();
    let requests: Vec<_> = requests.chain(poses.iter().cloned()).collect();
    let programs = programs(path, &robot, &requests)?;
    let page = Page::new(&robot, &programs, &poses, &fields(given)?, &start);
    if let Some(remark) = remark(page.html.len(), page.equations, robot.freedoms().joints) {
        let _ = writeln!(std::io::stderr(), "{remark}");
    }
    Ok(page.html)
}

/// Bytes up to which a page opens at once on a phone.
const LARGE: usize = 1_000_000;

/// The remark on a page of so many bytes, of which the equations of so many joints take a part.
fn remark(bytes: usize, equations: usize, joints: usize) -> Option<String> {
    let megabytes = |bytes: usize| bytes as f64 / 1e6;
    (bytes > LARGE).then(|| {
        format!(
            "the page has {:.2} MB, {:.2} of them the equations of {joints} joints: it takes a moment to open; \
             joints that stand still are left out of them by `--lock`",
            megabytes(bytes),
            megabytes(equations)
        )
    })
}

/// The motion of the command line.
fn start(given: &ArgMatches, robot: &Robot) -> Result<Start, Failure> {
    let positions_of = |name: &str| {
        let is_given = given.contains_id(name);
        is_given.then(|| positions(given, name, robot)).transpose()
    };
    let freedoms = robot.freedoms();
    let velocity = given
        .contains_id("velocity")
        .then(|| vector(given, "velocity", [freedoms.base, freedoms.joints]));
    if !freedoms.has_base() {
        refuse_pose(given)?;
    }
    let start = Start {
        from: positions_of("from")?,
        to: positions_of("to")?,
        velocity: velocity.transpose()?,
        pose: roll_pitch_yaw(given)?,
        ..Start::default()
    };
    let duration = given.get_one::<f64>("duration").copied();
    Ok(Start {
        duration: duration.unwrap_or(start.duration),
        ..start
    })
}

#[cfg(test)]
mod tests {
    use super::remark;

    #[test]
    fn large_pages_are_remarked_on() {
        assert_eq!(remark(990_000, 280_000, 12), None);
        let remark = remark(1_234_000, 524_000, 16).unwrap_or_default();
        assert!(
            remark.starts_with("the page has 1.23 MB, 0.52 of them the equations of 16 joints"),
            "{remark}"
        );
    }
}
