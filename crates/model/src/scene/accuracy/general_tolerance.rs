//! General tolerances of ISO 2768-1: the permissible deviation of a length without a tolerance of
//! its own on the drawing.

/// A tolerance class of ISO 2768-1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum GeneralTolerance {
    Fine,
    Medium,
    Coarse,
    VeryCoarse,
}

/// The designation of a class without its letter.
const STANDARD: &str = "ISO 2768-";
/// Minimum size in the standard, in mm.
const MIN_VALUE: f64 = 0.5;
/// Permissible deviations in mm: the maximum size of each row, and the values for f, m, c and v; 0
/// marks a missing value.
const DEVIATIONS: [(f64, [f64; 4]); 8] = [
    (3.0, [0.05, 0.1, 0.2, 0.0]),
    (6.0, [0.05, 0.1, 0.3, 0.5]),
    (30.0, [0.1, 0.2, 0.5, 1.0]),
    (120.0, [0.15, 0.3, 0.8, 1.5]),
    (400.0, [0.2, 0.5, 1.2, 2.5]),
    (1000.0, [0.3, 0.8, 2.0, 4.0]),
    (2000.0, [0.5, 1.2, 3.0, 6.0]),
    (4000.0, [0.0, 2.0, 4.0, 8.0]),
];
/// Maximum relative rounding error of a size converted to mm.
const ROUNDING: f64 = 1e-12;

impl GeneralTolerance {
    const ALL: [GeneralTolerance; 4] = [
        GeneralTolerance::Fine,
        GeneralTolerance::Medium,
        GeneralTolerance::Coarse,
        GeneralTolerance::VeryCoarse,
    ];

    /// Returns the designation on drawings, such as `ISO 2768-m`.
    pub(crate) fn designation(self) -> String {
        let letter = ['f', 'm', 'c', 'v'][self as usize];
        format!("{STANDARD}{letter}")
    }

    /// Returns the designations of all classes.
    pub(crate) fn designations() -> [String; 4] {
        Self::ALL.map(Self::designation)
    }

    pub(crate) fn designated(text: &str) -> Option<GeneralTolerance> {
        let mut all = Self::ALL.into_iter();
        all.find(|class| class.designation() == text)
    }

    /// Returns the permissible deviation for a size, both in mm; `None` outside the standard's
    /// range.
    pub(crate) fn deviation(self, size: f64) -> Option<f64> {
        let minimum = size * (1.0 - ROUNDING);
        if size * (1.0 + ROUNDING) < MIN_VALUE {
            return None;
        }
        let (_, all) = DEVIATIONS.iter().find(|(maximum, _)| minimum <= *maximum)?;
        Some(all[self as usize]).filter(|deviation| *deviation > 0.0)
    }

    /// Returns the range of sizes that have a deviation in this class, in mm.
    pub(crate) fn sizes(self) -> GeneralSizes {
        let mut sizes = GeneralSizes {
            least: MIN_VALUE,
            is_above: false,
            greatest: MIN_VALUE,
        };
        for (maximum, all) in DEVIATIONS {
            match all[self as usize] > 0.0 {
                true => sizes.greatest = maximum,
                false if sizes.greatest == MIN_VALUE => {
                    (sizes.least, sizes.is_above) = (maximum, true);
                }
                false => {}
            }
        }
        sizes
    }
}

/// The range of sizes of a class, in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct GeneralSizes {
    pub(crate) least: f64,
    /// Whether the range excludes `least` itself.
    pub(crate) is_above: bool,
    /// The maximum size, included in the range.
    pub(crate) greatest: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of table 1 of the standard, on both sides of its steps.
    #[test]
    fn deviations_match_iso_2768() {
        use GeneralTolerance::{Coarse, Fine, Medium, VeryCoarse};
        for (class, size, deviation) in [
            (Fine, 0.5, Some(0.05)),
            (Fine, 6.0, Some(0.05)),
            (Fine, 6.01, Some(0.1)),
            (Fine, 2000.0, Some(0.5)),
            (Fine, 2001.0, None),
            (Medium, 0.4, None),
            (Medium, 30.0, Some(0.2)),
            (Medium, 100.0, Some(0.3)),
            (Medium, 120.0, Some(0.3)),
            (Medium, 250.0, Some(0.5)),
            (Medium, 401.0, Some(0.8)),
            (Medium, 4000.0, Some(2.0)),
            (Medium, 4001.0, None),
            (Coarse, 3.0, Some(0.2)),
            (Coarse, 300.0, Some(1.2)),
            (VeryCoarse, 3.0, None),
            (VeryCoarse, 3.5, Some(0.5)),
            (VeryCoarse, 4000.0, Some(8.0)),
        ] {
            assert_eq!(class.deviation(size), deviation, "{class:?} {size}");
        }
        let sizes = |class: GeneralTolerance| {
            let found = class.sizes();
            (found.least, found.is_above, found.greatest)
        };
        assert_eq!(sizes(Fine), (0.5, false, 2000.0));
        assert_eq!(sizes(VeryCoarse), (3.0, true, 4000.0));
        assert_eq!(GeneralTolerance::designated("ISO 2768-c"), Some(Coarse));
        assert_eq!(GeneralTolerance::designated("ISO 2768-mK"), None);
    }
}
