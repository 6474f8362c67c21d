//! The command as it is called: what it writes, and its exit status.

mod c;
mod calls;
mod closed_forms;
mod command;
mod convert;
mod evaluate;
mod fields;
mod formulas;
mod help;
mod lint;
mod long_arms;
mod moving_base;
mod named_file;
mod notes;
mod reach;
mod refusals;
mod rust;
mod trees;
mod urdf;
