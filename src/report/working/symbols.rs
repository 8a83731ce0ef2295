//! The symbols in formulas: the lecture's theta3 for the angle of r3.

/// The notation of unit vectors.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum WorkingNotation {
    /// u along an angle, and n perpendicular to it.
    #[default]
    Krank,
    /// μ and ν, as in the lecture.
    Lecture,
}

impl WorkingNotation {
    /// Returns the symbol of the unit vector along an angle.
    pub(in crate::report) fn along(self, theta: &str) -> String {
        match self {
            WorkingNotation::Krank => format!("u({theta})"),
            WorkingNotation::Lecture => format!("μ({theta})"),
        }
    }

    /// Returns the symbol of the unit vector perpendicular to it, to its left.
    pub(in crate::report) fn across(self, theta: &str) -> String {
        match self {
            WorkingNotation::Krank => format!("n({theta})"),
            WorkingNotation::Lecture => format!("ν({theta})"),
        }
    }
}

/// Returns the symbol of a vector's angle.
pub(super) fn theta(name: &str) -> String {
    symbol('θ', name)
}

/// Returns the symbol of an angular velocity.
pub(super) fn omega(name: &str) -> String {
    symbol('ω', name)
}

/// Returns the symbol of an angular acceleration.
pub(super) fn alpha(name: &str) -> String {
    symbol('α', name)
}

/// Returns the symbol of the rate of a length.
pub(super) fn rate(name: &str) -> String {
    format!("d{name}/dt")
}

/// Returns the symbol of the second derivative of a length.
pub(super) fn accel(name: &str) -> String {
    format!("d2{name}/dt2")
}

/// Returns the symbol of a point's value: aB, but `a_r3.com`.
pub(in crate::report) fn of_point(figure: &str, name: &str) -> String {
    if name.len() <= 2 {
        format!("{figure}{name}")
    } else {
        format!("{figure}_{name}")
    }
}

/// Returns the symbol with the number for a name such as `r3`; any other name follows an
/// underscore.
fn symbol(letter: char, name: &str) -> String {
    match name.strip_prefix('r') {
        Some(number) if !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit()) => {
            format!("{letter}{number}")
        }
        _ => format!("{letter}_{name}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbered_vectors_have_symbols_of_lectures() {
        assert_eq!(theta("r3"), "θ3");
        assert_eq!(omega("r12"), "ω12");
        assert_eq!(alpha("ram"), "α_ram");
        assert_eq!(theta("r"), "θ_r");
        assert_eq!(theta("r3b"), "θ_r3b");
        assert_eq!(of_point("a", "B"), "aB");
        assert_eq!(of_point("a", "r3.com"), "a_r3.com");
    }
}
