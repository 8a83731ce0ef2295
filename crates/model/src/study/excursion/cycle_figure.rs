//! Names of cycle figures, the properties of quantities over the motion.
//!
//! The name of a column is followed by a property: `C.x.stroke`, `swing.ratio`,
//! `r4.angle.greatest.at`, `C.x@60`. The mechanism as a whole has `range`, `transmission` and
//! `condition`.

use crate::expression::DirectionCut;
use crate::nearest::nearest;
use crate::quantity::{Catalogue, Quantity, QuantitySource, Subject, demand, rate_unit};
use crate::scene::with_point;
use crate::wording::words;
use thiserror::Error;

/// A property of a quantity over the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum FigureProperty {
    Stroke,
    Minimum,
    Maximum,
    MinimumAt,
    MaximumAt,
    Turns,
    Ratio,
    Dwell,
    Fastest,
    FastestAt,
    Hardest,
    HardestAt,
    /// The value at a coordinate of the driver.
    At(f64),
}

/// A property of the driver's range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum RangeEnd {
    Width,
    Low,
    High,
}

/// The source of a cycle figure.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum CycleFigureSource {
    Of(Quantity, FigureProperty),
    Range(RangeEnd),
    /// The transmission angle of one group, named by a part that it places, or the worst of all.
    Transmission(Option<Subject>),
    Condition(Option<Subject>),
}

/// A figure of the whole motion, or of one place of it, by its name.
#[derive(Clone, Debug, PartialEq)]
pub struct CycleFigure {
    name: String,
    unit: String,
    pub(super) source: CycleFigureSource,
}

/// The error for a name that is not a cycle figure.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("{}", words().no_cycle_figure(name, &self.fix()))]
pub struct UnknownCycleFigure {
    /// The unknown name.
    pub name: String,
    /// The most similar valid name.
    pub nearest: Option<String>,
    /// `true` if the column exists and the message should list the properties.
    pub properties: bool,
}

const PROPERTIES: [(&str, FigureProperty); 13] = [
    ("least.at", FigureProperty::MinimumAt),
    ("greatest.at", FigureProperty::MaximumAt),
    ("fastest.at", FigureProperty::FastestAt),
    ("hardest.at", FigureProperty::HardestAt),
    ("stroke", FigureProperty::Stroke),
    ("swing", FigureProperty::Stroke),
    ("least", FigureProperty::Minimum),
    ("greatest", FigureProperty::Maximum),
    ("turns", FigureProperty::Turns),
    ("ratio", FigureProperty::Ratio),
    ("dwell", FigureProperty::Dwell),
    ("fastest", FigureProperty::Fastest),
    ("hardest", FigureProperty::Hardest),
];

impl CycleFigure {
    /// The names of values that do not belong to a column.
    pub const MOTION_FIGURES: [&str; 5] = [
        "range",
        "range.low",
        "range.high",
        "transmission",
        "condition",
    ];

    /// Returns the properties that follow the name of a column and a dot.
    #[must_use]
    pub fn properties() -> [&'static str; 13] {
        PROPERTIES.map(|(word, _)| word)
    }

    /// Parses a cycle figure: `C.x.stroke`, `transmission.C`, `range.low`, `C.x@60`.
    ///
    /// # Errors
    /// Returns an error if the name is unknown; the error holds the most similar one.
    pub fn parse(text: &str, catalogue: &Catalogue) -> Result<CycleFigure, UnknownCycleFigure> {
        let name = text.trim();
        // A name has a decimal point, as in all other columns.
        let marked = name.rsplit_once('@').filter(|(_, at)| at.contains(','));
        let pointed = marked.and_then(|(column, at)| Some(format!("{column}@{}", with_point(at)?)));
        let name = pointed.as_deref().unwrap_or(name);
        let (source, unit) = motion_figure(name, catalogue)
            .or_else(|| at_place(name, catalogue))
            .or_else(|| of_column(name, catalogue))
            .ok_or_else(|| UnknownCycleFigure::of(name, catalogue))?;
        Ok(CycleFigure {
            name: name.to_owned(),
            unit,
            source,
        })
    }

    /// Returns the name as it was written.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns `true` if a formula derives the column from others.
    pub(crate) fn is_derived(&self) -> bool {
        let is_made = |of: &Quantity| matches!(of.source, QuantitySource::Derived(_));
        matches!(&self.source, CycleFigureSource::Of(of, _) if is_made(of))
    }

    /// Returns the figure's column, if it has one.
    pub(crate) fn column(&self) -> Option<&Quantity> {
        match &self.source {
            CycleFigureSource::Of(of, _) => Some(of),
            _ => None,
        }
    }

    /// Returns `true` if the column depends on loads.
    pub(crate) fn is_of_forces(&self) -> bool {
        self.column().is_some_and(|of| demand([of]).0.forces)
    }

    /// Returns `true` for a direction, a sum of directions, or a place in a turn: these are equal
    /// modulo full turns.
    pub(crate) fn is_round(&self) -> bool {
        self.is_periodic_value() || self.is_place() && self.unit == "deg"
    }

    /// Returns `true` for a direction or a sum of directions.
    pub(super) fn is_periodic_value(&self) -> bool {
        let CycleFigureSource::Of(of, property) = &self.source else {
            return false;
        };
        let is_value = matches!(
            property,
            FigureProperty::At(_) | FigureProperty::Minimum | FigureProperty::Maximum
        );
        is_value && of.cut() == DirectionCut::ByTurns
    }

    /// Returns `true` for a coordinate of the driver at which a property is reached.
    pub(super) fn is_place(&self) -> bool {
        let CycleFigureSource::Of(_, property) = &self.source else {
            return false;
        };
        matches!(
            property,
            FigureProperty::MinimumAt
                | FigureProperty::MaximumAt
                | FigureProperty::FastestAt
                | FigureProperty::HardestAt
        )
    }

    /// Returns the unit; empty for a plain number.
    #[must_use]
    pub fn unit(&self) -> &str {
        &self.unit
    }
}

impl FigureProperty {
    fn unit(self, of: &Quantity, driver: &str) -> String {
        match self {
            FigureProperty::Stroke
            | FigureProperty::Minimum
            | FigureProperty::Maximum
            | FigureProperty::At(_) => of.unit.clone(),
            FigureProperty::MinimumAt
            | FigureProperty::MaximumAt
            | FigureProperty::FastestAt
            | FigureProperty::HardestAt
            | FigureProperty::Dwell => driver.to_owned(),
            FigureProperty::Turns | FigureProperty::Ratio => String::new(),
            FigureProperty::Fastest => rate_unit(&of.unit),
            FigureProperty::Hardest => rate_unit(&rate_unit(&of.unit)),
        }
    }
}

/// Parses a figure of the mechanism as a whole.
fn motion_figure(name: &str, catalogue: &Catalogue) -> Option<(CycleFigureSource, String)> {
    let driver = catalogue.driver().unit.clone();
    let group = |name: &str| {
        let found = ["x", "angle"].map(|aspect| catalogue.find(&format!("{name}.{aspect}")));
        found
            .into_iter()
            .flatten()
            .find_map(|quantity| quantity.subject())
    };
    Some(match name {
        "range" => (CycleFigureSource::Range(RangeEnd::Width), driver),
        "range.low" => (CycleFigureSource::Range(RangeEnd::Low), driver),
        "range.high" => (CycleFigureSource::Range(RangeEnd::High), driver),
        "transmission" => (CycleFigureSource::Transmission(None), "deg".into()),
        "condition" => (CycleFigureSource::Condition(None), String::new()),
        _ => match name.split_once('.')? {
            ("transmission", of) => (
                CycleFigureSource::Transmission(Some(group(of)?)),
                "deg".into(),
            ),
            ("condition", of) => (
                CycleFigureSource::Condition(Some(group(of)?)),
                String::new(),
            ),
            _ => return None,
        },
    })
}

/// Parses a column at a coordinate of the driver.
fn at_place(name: &str, catalogue: &Catalogue) -> Option<(CycleFigureSource, String)> {
    let (column, at) = name.rsplit_once('@')?;
    let at = at.trim().parse::<f64>().ok().filter(|at| at.is_finite())?;
    let of = catalogue.find(column.trim())?;
    let unit = of.unit.clone();
    Some((CycleFigureSource::Of(of, FigureProperty::At(at)), unit))
}

/// Parses a property of a column over the motion.
fn of_column(name: &str, catalogue: &Catalogue) -> Option<(CycleFigureSource, String)> {
    let (column, property) = parted(name)?;
    let of = catalogue.find(column)?;
    let unit = property.unit(&of, &catalogue.driver().unit);
    Some((CycleFigureSource::Of(of, property), unit))
}

/// Splits a name into the column and its property.
fn parted(name: &str) -> Option<(&str, FigureProperty)> {
    PROPERTIES.into_iter().find_map(|(word, property)| {
        let column = name.strip_suffix(word)?.strip_suffix('.')?;
        Some((column, property))
    })
}

impl UnknownCycleFigure {
    fn of(name: &str, catalogue: &Catalogue) -> UnknownCycleFigure {
        let unlisted = catalogue.unlisted();
        let columns = || catalogue.all().iter().chain(&unlisted);
        let (before, after) = name.rsplit_once('.').unwrap_or((name, ""));
        let knows = |column: &str| catalogue.find(column).is_some();
        let near = match parted(name) {
            // The property is known, and the column is not.
            Some((column, _)) => nearest(column, columns().map(|q| q.name.as_str()))
                .map(|near| name.replacen(column, near, 1)),
            None if knows(before) => {
                nearest(after, CycleFigure::properties()).map(|word| format!("{before}.{word}"))
            }
            None => nearest(name, CycleFigure::MOTION_FIGURES).map(str::to_owned),
        };
        UnknownCycleFigure {
            name: name.to_owned(),
            properties: near.is_none() && (knows(name) || knows(before)),
            nearest: near,
        }
    }

    fn fix(&self) -> String {
        match &self.nearest {
            Some(near) => words().or_meant(&words().did_you_mean(near)),
            None if self.properties => {
                let properties = CycleFigure::properties().join(", ");
                words().column_can_be_asked(&properties)
            }
            None => String::new(),
        }
    }
}
