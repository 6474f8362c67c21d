//! The functions that a table names, and whether they read masses.

use dynamics_symbolic::Function;

use crate::description::{Asked, Masses, Table, Wanted};

/// Every function that is named, parts of tuples too.
pub(super) fn named(asked: &[Asked]) -> impl Iterator<Item = &Wanted> + Clone {
    asked.iter().flat_map(|asked| match asked {
        Asked::Default(_) | Asked::Unreadable => &[],
        Asked::One(wanted) => core::slice::from_ref(wanted),
        Asked::Fused(_, parts) => &parts[..],
    })
}

/// Whether a function that a table requests, or that is needed besides, reads masses. The default set does.
pub(crate) fn read_masses(table: &Table) -> bool {
    let asked = table.functions().map(Option::unwrap_or_default);
    let is_default = |asked: &Asked| matches!(asked, Asked::Default(_));
    let has_default = asked.is_none_or(|asked| asked.iter().any(is_default));
    let named = named(asked.unwrap_or_default()).map(|wanted| wanted.function);
    let mut functions = named.chain(table.needed.iter().copied());
    table.masses != Masses::Never && (has_default || functions.any(Function::reads_masses))
}
