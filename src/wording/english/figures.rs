//! Figures: why some are not shown.

use super::English;

catalogue! {
    /// Figures by name.
    trait Figures for English {
        forces_disagree(at: &str, residual: &str, missed: &str, most: &str) =
            "the forces at {at} are withheld: {residual} is {missed}, and rounding explains no more \
             than {most}; two ways to find them disagree, which is a fault of krank and not of the \
             scene: please report it";
        forces_too_large(at: &str) =
            "the forces at {at} are withheld: some are too large for a number; choose ordinary \
             speeds, masses and loads";
        figure_too_large(figure: &str, at: &str) =
            "{figure} at {at} is too large for a number; choose ordinary lengths and speeds";
    }
}
