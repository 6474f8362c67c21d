//! The program in single precision. A linker of the machine begins it at `main`, that of a controller at `_start`.
#![no_std]
#![no_main]

/// Begins.
#[cfg_attr(target_os = "none", unsafe(export_name = "_start"))]
#[cfg_attr(not(target_os = "none"), unsafe(no_mangle))]
pub extern "C" fn main() -> i32 {
    without_panics::singles();
    0
}
