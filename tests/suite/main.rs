//! What holds for every robot of `tests/data/robots`.

#[path = "../support/data.rs"]
mod data;
#[path = "../support/decimal.rs"]
mod decimal;
#[path = "../support/double_double.rs"]
mod double_double;
#[path = "../support/dual.rs"]
mod dual;
#[path = "../support/random.rs"]
mod random;
#[path = "../robots/mod.rs"]
mod robots;

mod accuracy;
mod aristo;
mod dry_friction;
mod free_fall;
mod identities;
mod reference;
mod table;
