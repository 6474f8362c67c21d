//! Names of joints in errors.

/// A joint by its number, counted from 1, and its name if that is known: `joint 2 (elbow)`.
pub(crate) fn joint_name(joint: usize, names: &[String]) -> String {
    match names.get(joint) {
        Some(name) => format!("joint {} ({name})", joint + 1),
        None => format!("joint {}", joint + 1),
    }
}
