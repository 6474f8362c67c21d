use robot_dynamics::robot_dynamics;

macro_rules! pendulum {
    ($name:ident, $mass:expr, $length:expr) => {
        robot_dynamics! {
            pub struct $name;
            convention: standard,
            gravity: [0, -9.81, 0],
            joints: [pivot: revolute { a: $length, mass: $mass }],
        }
    };
}

pendulum!(Heavy, 3 * 4, 1.0);
pendulum!(Lost, 1, lenght);
pendulum!(Called, f64::sqrt(2.0), 1.0);

macro_rules! pendulum {
    ($name:ident, $(#[$attribute:meta])*) => {
        robot_dynamics! {
            pub struct $name {
                $(#[$attribute])*
                m: f64,
            }
            convention: standard,
            gravity: [0, -9.81, 0],
            joints: [pivot: revolute { a: 1, mass: m }],
        }
    };
}

pendulum!(Plain, #[cfg(windows)]);
pendulum!(Conditional, #[cfg_attr(all(), cfg(windows))]);

fn main() {}
