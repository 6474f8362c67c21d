//! Decimals of angles that are near multiples of a quarter turn, or are taken as such.

/// Nothing is told of smaller differences, rad: two programs that agree differ by as much of their torques.
const LEAST: f64 = 1e-14;

/// Angles that differ so much from a quarter turn may be meant as one, rad.
pub(crate) const NEARLY: f64 = 1e-2;

/// How many decimals were taken as multiples of a quarter turn, and the one that was furthest from its multiple.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rounded {
    count: usize,
    radians: f64,
    apart: f64,
}

impl Rounded {
    /// Counts a decimal that is so far from its multiple.
    pub(crate) fn add(&mut self, radians: f64, apart: f64) {
        if apart < LEAST {
            return;
        }
        self.count += 1;
        if apart > self.apart {
            (self.radians, self.apart) = (radians, apart);
        }
    }

    /// The note, of which `remedy` is the last sentence; none where nothing was rounded.
    pub(crate) fn note(&self, remedy: &str) -> Option<String> {
        let Rounded {
            count,
            radians,
            apart,
        } = self;
        let angles = match count {
            0 => return None,
            1 => format!("One angle, {radians:?}, is taken as the multiple"),
            _ => format!("{count} angles, such as {radians:?}, are taken as the multiples"),
        };
        Some(format!(
            " {angles} of a quarter turn that the digits are {apart:.0e} rad from at most. A program that takes the digits \
             gets torques that differ by about as much of their size. {remedy}"
        ))
    }
}
