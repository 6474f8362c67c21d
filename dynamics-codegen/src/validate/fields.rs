//! Fields that no value uses.

use super::scope::Scope;
use crate::description::Table;
use crate::diagnose::Diagnostics;
use crate::mistake;

/// Reports the fields that no value uses. Where there are errors, the value that uses
/// one may be unreadable: then only a field that the table never names is reported.
pub(super) fn report_unused(table: &Table, scope: &Scope, diagnostics: &Diagnostics) {
    let is_good = diagnostics.is_empty();
    for (index, name) in table.fields.iter().enumerate() {
        let word = name.plain();
        let is_named = !is_good && table.mentions.contains(word);
        if !scope.is_used(index) && !is_named {
            diagnostics.error(name, mistake::structure::unused_field(word));
        }
    }
}
