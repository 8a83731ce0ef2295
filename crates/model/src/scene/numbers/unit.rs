//! Units of length.

/// The unit of every length of a scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Unit {
    /// Millimetres.
    #[default]
    Millimetre,
    /// Centimetres.
    Centimetre,
    /// Metres.
    Metre,
    /// Inches.
    Inch,
}

impl Unit {
    /// All units, in their order in messages.
    pub const ALL: [Unit; 4] = [Unit::Millimetre, Unit::Centimetre, Unit::Metre, Unit::Inch];

    /// Returns the symbol used in scene files and column headers.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Unit::Millimetre => "mm",
            Unit::Centimetre => "cm",
            Unit::Metre => "m",
            Unit::Inch => "in",
        }
    }

    /// Returns the size of this unit in `unit`: the factor that converts a length to `unit`.
    #[must_use]
    pub fn in_units_of(self, unit: Unit) -> f64 {
        self.tenths_of_mm() / unit.tenths_of_mm()
    }

    /// Returns the size in metres.
    #[must_use]
    pub fn metres(self) -> f64 {
        self.in_units_of(Unit::Metre)
    }

    /// Returns the size in tenths of a millimetre: whole numbers, so that a conversion rounds only
    /// once per operation.
    pub fn tenths_of_mm(self) -> f64 {
        self.whole_tenths_of_mm().into()
    }

    /// Returns the size in tenths of a millimetre as an integer.
    pub(crate) fn whole_tenths_of_mm(self) -> u32 {
        match self {
            Unit::Millimetre => 10,
            Unit::Centimetre => 100,
            Unit::Metre => 10_000,
            Unit::Inch => 254,
        }
    }
}
