//! The symbols of a formula: the lecture's theta3 for the angle of r3.

/// How unit vectors are called.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum WorkingNotation {
    /// u along an angle, and n at right angles to it.
    #[default]
    Krank,
    /// The same as the lecture writes them: μ and ν.
    Lecture,
}

impl WorkingNotation {
    /// The unit vector along an angle.
    pub(in crate::report) fn along(self, theta: &str) -> String {
        match self {
            WorkingNotation::Krank => format!("u({theta})"),
            WorkingNotation::Lecture => format!("μ({theta})"),
        }
    }

    /// The unit vector at right angles to it, to its left.
    pub(in crate::report) fn across(self, theta: &str) -> String {
        match self {
            WorkingNotation::Krank => format!("n({theta})"),
            WorkingNotation::Lecture => format!("ν({theta})"),
        }
    }
}

/// The symbol of a vector's angle.
pub(super) fn theta(name: &str) -> String {
    symbol('θ', name)
}

/// The symbol of an angular velocity.
pub(super) fn omega(name: &str) -> String {
    symbol('ω', name)
}

/// The symbol of an angular acceleration.
pub(super) fn alpha(name: &str) -> String {
    symbol('α', name)
}

/// The rate of a length.
pub(super) fn rate(name: &str) -> String {
    format!("d{name}/dt")
}

/// The rate of that rate.
pub(super) fn accel(name: &str) -> String {
    format!("d2{name}/dt2")
}

/// A figure of a point: aB, but `a_r3.com`.
pub(super) fn of_point(figure: &str, name: &str) -> String {
    if name.len() <= 2 {
        format!("{figure}{name}")
    } else {
        format!("{figure}_{name}")
    }
}

/// `r3` has the symbol with 3, any other name stands behind a bar.
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
    fn a_numbered_vector_has_the_lectures_symbols() {
        assert_eq!(theta("r3"), "θ3");
        assert_eq!(omega("r12"), "ω12");
        assert_eq!(alpha("ram"), "α_ram");
        assert_eq!(theta("r"), "θ_r");
        assert_eq!(theta("r3b"), "θ_r3b");
        assert_eq!(of_point("a", "B"), "aB");
        assert_eq!(of_point("a", "r3.com"), "a_r3.com");
    }
}
