//! The page of an arm as a file.

use std::io::Write as _;

use dynamics_export::page::{FUNCTIONS, Page, Start, shown_poses};
use dynamics_symbolic::Request;
use dynamics_symbolic::robot::Robot;

use crate::arguments;
use crate::beside::fields;
use crate::failure::Failure;
use crate::load::{programs, read_with_fields, read_with_links};
use crate::state::{base, positions, roll_pitch_yaw, vector};

/// The page.
pub(crate) fn run(given: &arguments::Page) -> Result<String, Failure> {
    let file = &given.robot.file;
    let mut robot = read_with_fields(&given.robot, FUNCTIONS.to_vec())?.robot;
    let poses = shown_poses(&mut robot);
    let start = start(given, &robot)?;
    // The values that the fields have at first are judged as those of a file without fields.
    read_with_links(&given.robot, false)?;
    let requests = FUNCTIONS.map(Request::from).into_iter();
    let requests: Vec<_> = requests.chain(poses.iter().cloned()).collect();
    let programs = programs(&file.path, &robot, &requests)?;
    let page = Page::new(&robot, &programs, &poses, &fields(&file.field)?, &start);
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
fn start(given: &arguments::Page, robot: &Robot) -> Result<Start, Failure> {
    let positions_of = |name: &str, numbers: &[f64]| {
        let is_given = !numbers.is_empty();
        is_given
            .then(|| positions(numbers, name, robot))
            .transpose()
    };
    let freedoms = robot.freedoms();
    let is_fast = !given.velocity.is_empty();
    let freedoms_of_each = [freedoms.base, freedoms.joints];
    let velocity = is_fast.then(|| vector(&given.velocity, "velocity", freedoms_of_each));
    if !freedoms.has_base() {
        base(robot, &given.pose)?;
    }
    Ok(Start {
        from: positions_of("from", &given.from)?,
        to: positions_of("to", &given.to)?,
        velocity: velocity.transpose()?,
        pose: roll_pitch_yaw(&given.pose)?,
        duration: given.duration,
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
