//! Arms of so many joints, of which the compiler must know the number.

/// The value of an expression for arms of `$dof` joints, whose number `$n` stands for.
macro_rules! with_joints {
    ($dof:expr, $n:ident => $value:expr) => {
        with_joints!(@ $dof, $n => $value; 1 2 3 4 5 6 7 8)
    };
    (@ $dof:expr, $n:ident => $value:expr; $($joints:literal)*) => {
        match $dof {
            $($joints => {
                const $n: usize = $joints;
                $value
            })*
            dof => Err($crate::failure::Failure::after(
                String::new(),
                format!("{dof} joints move: expected 8 at most, lock others by --lock JOINT=POSITION"),
            )),
        }
    };
}
pub(crate) use with_joints;
