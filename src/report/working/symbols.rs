//! The symbols in formulas: the lecture's theta3 for the angle of r3.

use crate::page::{Formula, Symbol};
use crate::report::tables::index;
use crate::solver::Order;

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
    /// Returns the unit vector along an angle.
    pub(in crate::report) fn along(self, theta: impl Into<Formula>) -> Formula {
        Formula::from(&self.names()[0]).then(theta.into().in_brackets())
    }

    /// Returns the unit vector perpendicular to it, to its left.
    pub(in crate::report) fn across(self, theta: impl Into<Formula>) -> Formula {
        Formula::from(&self.names()[1]).then(theta.into().in_brackets())
    }

    /// Returns the symbols of both unit vectors.
    pub(super) fn names(self) -> [Symbol; 2] {
        let names = match self {
            WorkingNotation::Krank => ["u", "n"],
            WorkingNotation::Lecture => ["μ", "ν"],
        };
        names.map(Symbol::named)
    }
}

/// Returns the symbol of a vector's angle.
pub(super) fn theta(name: &str) -> Symbol {
    symbol("θ", name)
}

/// Returns the symbol of an angular velocity.
pub(super) fn omega(name: &str) -> Symbol {
    symbol("ω", name)
}

/// Returns the symbol of an angular acceleration.
pub(super) fn alpha(name: &str) -> Symbol {
    symbol("α", name)
}

/// Returns the symbol of a vector's angle, or of its rate of an order.
pub(super) fn angle(name: &str, order: Order) -> Symbol {
    symbol(["θ", "ω", "α"][index(order)], name)
}

/// Returns the symbol of a length, or of its rate of an order.
pub(super) fn length(name: &str, order: Order) -> Symbol {
    Symbol::named(name).derivative(index(order))
}

/// Returns the symbol of a point's value, or of its component: aB, aBt, but `a_r3.com`.
pub(in crate::report) fn of_point(letter: &str, name: &str) -> Symbol {
    match name.len() {
        ..=2 => Symbol::indexed(letter, name),
        _ => Symbol::separate(letter, name),
    }
}

/// Returns the symbol of a component of a point's value: `aBt`, but `a_r3.com_t`.
pub(super) fn part_of_point(letter: &str, name: &str, part: &str) -> Symbol {
    match name.len() {
        ..=2 => Symbol::indexed(letter, format!("{name}{part}")),
        _ => Symbol::separate(letter, format!("{name}_{part}")),
    }
}

/// Returns the symbol with the number for a name such as `r3`; any other name follows an
/// underscore.
fn symbol(letter: &str, name: &str) -> Symbol {
    match name.strip_prefix('r') {
        Some(number) if !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit()) => {
            Symbol::indexed(letter, number)
        }
        _ => Symbol::separate(letter, name),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbered_vectors_have_symbols_of_lectures() {
        assert_eq!(theta("r3").to_string(), "θ3");
        assert_eq!(omega("r12").to_string(), "ω12");
        assert_eq!(alpha("ram").to_string(), "α_ram");
        assert_eq!(theta("r").to_string(), "θ_r");
        assert_eq!(theta("r3b").to_string(), "θ_r3b");
        assert_eq!(of_point("a", "B").to_string(), "aB");
        assert_eq!(of_point("a", "r3.com").to_string(), "a_r3.com");
    }
}
