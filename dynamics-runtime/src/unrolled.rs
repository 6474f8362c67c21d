//! Loops over arrays of lanes.

/// A loop over an array whose first rounds are unrolled, whatever the compiler thinks of it: so the
/// numbers stay in registers. The rounds are those of a base that moves and twelve joints.
macro_rules! for_each_index {
    ($length:ident, $i:ident => $do:expr) => {
        for_each_index!($length, $i => $do; 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17);
        for $i in 18..$length {
            $do;
        }
    };
    ($length:ident, $i:ident => $do:expr; $($index:literal)*) => {
        $(if $index < $length {
            let $i = $index;
            $do;
        })*
    };
}
pub(crate) use for_each_index;
