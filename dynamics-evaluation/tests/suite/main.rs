//! Robots at run time beside generated ones and beside Newton-Euler.

mod arrays;
mod batches;
mod casadi;
mod data_files;
mod generated;
mod identified;
mod kinds;
mod languages;
mod python_values;
mod reach;
mod refusals;
mod sizes;
mod warnings;
