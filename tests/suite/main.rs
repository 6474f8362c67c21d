//! What holds for every robot of `tests/data/robots`.

#[path = "../support/data.rs"]
mod data;
#[path = "../support/decimal.rs"]
mod decimal;
#[path = "../support/dual.rs"]
mod dual;
#[path = "../support/random.rs"]
mod random;
#[path = "../robots/mod.rs"]
mod robots;
#[path = "../robots/fields.rs"]
mod robots_of_fields;
#[path = "../support/exact.rs"]
mod table_in_31_digits;

mod accuracy;
mod aristo;
mod dry_friction;
mod dual_numbers;
mod exact;
mod free_fall;
mod identities;
mod reference;
mod table;
mod taylor;
