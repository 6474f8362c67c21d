//! The cost of a generated function.

use core::fmt::{self, Write as _};

/// The operations of one generated function, as they stand in its straight-line program.
///
/// Sines and cosines are counted apart from the arithmetic: a pair of them costs as much as many
/// products. Subtractions count as additions, changes of sign as nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Operations {
    /// Products of two numbers.
    pub multiplications: u32,
    /// Sums and differences.
    pub additions: u32,
    /// Quotients.
    pub divisions: u32,
    /// Pairs of a sine and a cosine of one angle.
    pub sin_cos: u32,
    /// Exponentials.
    pub exponentials: u32,
}

impl Operations {
    /// Multiplications, additions and divisions together.
    pub const fn total(&self) -> u32 {
        self.multiplications + self.additions + self.divisions
    }
}

impl fmt::Display for Operations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut line = Line::default();
        write!(
            line,
            "{} mul, {} add, {} div, {} sin_cos",
            self.multiplications, self.additions, self.divisions, self.sin_cos
        )?;
        if self.exponentials > 0 {
            write!(line, ", {} exp", self.exponentials)?;
        }
        f.pad(line.text())
    }
}

/// Room for the longest line: five numbers of ten digits and the words. Padding needs to know how
/// long it is, and there may be no allocator.
#[derive(Default)]
struct Line {
    bytes: [[u8; 16]; 6],
    length: usize,
}

impl Line {
    fn text(&self) -> &str {
        let written = &self.bytes.as_flattened()[..self.length];
        core::str::from_utf8(written).unwrap_or_default()
    }
}

impl fmt::Write for Line {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        let end = self.length + text.len();
        let room = self.bytes.as_flattened_mut().get_mut(self.length..end);
        room.ok_or(fmt::Error)?.copy_from_slice(text.as_bytes());
        self.length = end;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::Operations;

    const COUNTED: Operations = Operations {
        multiplications: 183,
        additions: 145,
        divisions: 2,
        sin_cos: 6,
        exponentials: 0,
    };

    #[test]
    fn total_leaves_sines_apart() {
        assert_eq!(COUNTED.total(), 330);
    }

    #[test]
    fn display_honours_a_width() {
        assert_eq!(COUNTED.to_string(), "183 mul, 145 add, 2 div, 6 sin_cos");
        assert_eq!(format!("{COUNTED:>40}").len(), 40);
        let most = u32::MAX;
        let longest = Operations {
            multiplications: most,
            additions: most,
            divisions: most,
            sin_cos: most,
            exponentials: most,
        };
        let line = format!("{most} mul, {most} add, {most} div, {most} sin_cos, {most} exp");
        assert_eq!(longest.to_string(), line);
    }
}
