//! The standard inertial parameters of a link.

/// One of the ten inertial parameters of a link, or the reflected inertia of its motor. T and U are
/// linear in them.
///
/// They belong to the frame *on the joint's own axis*, after the factors Rz(theta) Tz(d) of the row:
/// with `modified` rows that is the link frame, with `standard` rows the link frame before
/// Tx(a) Rx(alpha).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Parameter {
    /// Entry xx of the inertia tensor about the frame's origin, kg m^2.
    Jxx,
    /// Entry xy.
    Jxy,
    /// Entry xz.
    Jxz,
    /// Entry yy.
    Jyy,
    /// Entry yz.
    Jyz,
    /// Entry zz.
    Jzz,
    /// First moment m c along x, kg m.
    Hx,
    /// First moment along y.
    Hy,
    /// First moment along z.
    Hz,
    /// Mass, kg.
    Mass,
    /// gear_ratio^2 times the motor's inertia, kg m^2 or kg.
    Motor,
}

impl Parameter {
    /// All, in the order in which base parameters are chosen: where two parameters of a link have
    /// the same effect, the first one stands for both.
    pub const ALL: [Parameter; 11] = [
        Parameter::Jxx,
        Parameter::Jxy,
        Parameter::Jxz,
        Parameter::Jyy,
        Parameter::Jyz,
        Parameter::Jzz,
        Parameter::Hx,
        Parameter::Hy,
        Parameter::Hz,
        Parameter::Mass,
        Parameter::Motor,
    ];

    /// The parameters of a link, with that of a motor or without.
    pub fn of_link(has_motor: bool) -> &'static [Parameter] {
        &Self::ALL[..if has_motor { 11 } else { 10 }]
    }

    /// The place in [`Parameter::ALL`].
    pub fn index(self) -> usize {
        self as usize
    }

    /// The name for link `i`, counted from 1: `J2xx`, `h2x`, `m2`, `I2`.
    pub fn name(self, i: usize) -> String {
        let (letter, entry) = match self {
            Parameter::Jxx => ("J", "xx"),
            Parameter::Jxy => ("J", "xy"),
            Parameter::Jxz => ("J", "xz"),
            Parameter::Jyy => ("J", "yy"),
            Parameter::Jyz => ("J", "yz"),
            Parameter::Jzz => ("J", "zz"),
            Parameter::Hx => ("h", "x"),
            Parameter::Hy => ("h", "y"),
            Parameter::Hz => ("h", "z"),
            Parameter::Mass => ("m", ""),
            Parameter::Motor => ("I", ""),
        };
        format!("{letter}{i}{entry}")
    }
}
