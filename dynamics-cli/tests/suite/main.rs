//! The command as it is called: what it writes, and its exit status.

mod calls;
mod command;
mod convert;
mod help;
mod refusals;
mod rust;
mod urdf;
