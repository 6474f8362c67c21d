//! The values of all functions at one state.

mod labels;
mod tables;

use std::fmt::Write as _;

use dynamics_evaluation::RuntimeRobot;
use dynamics_symbolic::Request;
use dynamics_symbolic::emit::quantities;
use dynamics_symbolic::function::Argument;

use crate::arguments::Evaluate;
use crate::failure::Failure;
use crate::load::{arm, read_on_any_base, requests};
use crate::state::State;
use dynamics_export::poses::poses;
use labels::Labels;
use tables::{Tables, state_table};

/// The text of `evaluate`.
pub(crate) fn run(given: &Evaluate) -> Result<String, Failure> {
    let model = read_on_any_base(&given.robot)?;
    let state = State::new(&model.robot, [&given.at, &given.pose, &given.torque])?;
    let mut robot = model.robot.clone();
    let mut asked = poses(&mut robot);
    for request in requests(&model)? {
        if asked.iter().all(|other| other.name() != request.name()) {
            asked.push(request);
        }
    }
    let (known, left_out): (Vec<_>, Vec<_>) = asked.into_iter().partition(is_known);
    let arm = arm(&given.robot.file.path, &robot, &known)?;
    let labels = Labels::new(&robot);
    let tables = Tables {
        labels: &labels,
        digits: given.digits,
    };
    let mut text = state_table(&robot, &state, &tables);
    let mut failed = Vec::new();
    for request in &known {
        let section = section(&arm, request, &state, &tables);
        text.push_str(&section.unwrap_or_else(|reason| {
            failed.push(format!("`{}`: {reason}", request.name()));
            String::new()
        }));
    }
    text.push_str(&left_out_sentence(&left_out));
    if failed.is_empty() {
        Ok(text)
    } else {
        Err(Failure::after(text, failed.join("\n")))
    }
}

/// Whether the command line has all arguments of a function.
fn is_known(request: &Request) -> bool {
    request.arguments().into_iter().all(|argument| {
        matches!(
            argument,
            Argument::Base
                | Argument::Position
                | Argument::Velocity
                | Argument::Acceleration
                | Argument::Force
        )
    })
}

/// The sentence about functions of which the command line has not all arguments.
fn left_out_sentence(left_out: &[Request]) -> String {
    if left_out.is_empty() {
        return String::new();
    }
    let named = left_out.iter().map(|request| {
        let arguments = request.arguments().into_iter().map(Argument::name);
        let arguments: Vec<_> = arguments.collect();
        format!("{}({})", request.name(), arguments.join(", "))
    });
    let named: Vec<_> = named.collect();
    format!(
        "\nleft out, because no option has all of their arguments: {}\n",
        named.join(", ")
    )
}

/// A function, its quantity and its value.
fn section(
    arm: &RuntimeRobot,
    request: &Request,
    state: &State,
    tables: &Tables,
) -> Result<String, String> {
    let name = request.name();
    let base = state.base.map(|pose| <[f64; 12]>::from(pose.entries()));
    let arguments = arm.arguments(name).map_err(|error| error.to_string())?;
    let arguments = arguments.map(|(argument, _)| match argument {
        "base" => base.as_ref().map_or(&[][..], |entries| &entries[..]),
        "q" => &state.q,
        "qd" => &state.qd,
        "qdd" => &state.qdd,
        _ => &state.tau,
    });
    let arguments: Vec<_> = arguments.collect();
    let value = arm.evaluate(name, &arguments);
    let value = value.map_err(|error| error.to_string())?;
    let mut text = format!("\n{name}\n");
    for line in quantities(arm.robot(), request) {
        let _ = writeln!(text, "{}", format!("   {line}").trim_end());
    }
    for line in tables.request_lines(arm.robot(), request, &value) {
        let _ = writeln!(text, "{}", format!("    {line}").trim_end());
    }
    Ok(text)
}
