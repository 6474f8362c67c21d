//! What the struct's documentation says of joints that are locked and of terms that are neglected.

use dynamics_symbolic::robot::Neglected;

use crate::validate::Model;

/// The lines; none where there is nothing to say.
pub(super) fn lines(model: &Model) -> Vec<String> {
    let mut lines = locked(model);
    if let Some(neglected) = &model.robot.neglected {
        lines.extend(self::neglected(neglected));
    }
    lines
}

fn locked(model: &Model) -> Vec<String> {
    let locked = model.robot.rows.iter().filter_map(|row| {
        let position = row.locked.as_ref()?;
        let position = match position.is_number() {
            true => position.to_f64(&[]).to_string(),
            false => "a position made of fields".to_owned(),
        };
        Some(format!(" - `{}` at {position}", row.name))
    });
    let locked: Vec<String> = locked.collect();
    match locked.is_empty() {
        true => Vec::new(),
        false => section(
            " Joints that are locked, and are none of this arm's:",
            locked,
        ),
    }
}

fn neglected(neglected: &Neglected) -> Vec<String> {
    let percent = dynamics_symbolic::percent(neglected.share);
    let name = |&(row, parameter): &(usize, dynamics_symbolic::robot::Parameter)| {
        format!("`{}`", parameter.name(row + 1))
    };
    let names: Vec<String> = neglected.columns.iter().map(name).collect();
    let text = match names.is_empty() {
        true => format!(
            " Nothing is neglected: every base inertial parameter makes {percent} % or more of the largest value of a function."
        ),
        false => format!(
            " Abbreviated: of the Lagrangian, the base inertial parameters that make less than {percent} % of the \
             largest value of M, V and G each are neglected, and all functions are derived from what is left: {}. \
             `table()` is the complete table.",
            names.join(", ")
        ),
    };
    section(&text, Vec::new())
}

/// A paragraph and its list.
fn section(text: &str, list: Vec<String>) -> Vec<String> {
    let mut lines = vec![String::new(), text.to_owned()];
    if !list.is_empty() {
        lines.push(String::new());
    }
    lines.extend(list);
    lines
}
