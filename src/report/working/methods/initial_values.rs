//! Initial values of a method: guesses given by the name of a vector, or by default the scene's
//! rough start positions.

use super::super::context::Context;
use super::super::loops::group_unknowns::LoopUnknown;
use super::super::loops::sides::{Side, SideShape, Turns};
use super::PositionMethod;
use super::problem::kind;
use crate::expression::plain_unit;
use crate::nearest::did_you_mean;
use crate::scene::{Unit, entries_with_numbers, with_point};
use crate::solver::{Order, Workspace};
use crate::study::UnknownKind;
use crate::wording::words;
use crate::{Body, LinkId, PointId, Vec2, angle};
use std::fmt;
use std::str::FromStr;

/// A guess for a vector: `r3=20`, `r4=120mm` or `r3=0..90`.
#[derive(Clone, Debug, PartialEq)]
pub struct Guess {
    /// The name of the vector.
    name: String,
    /// The value, twice, or the ends of an interval.
    between: [f64; 2],
    unit: Option<GuessUnit>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum GuessUnit {
    Degrees,
    Radians,
    Length(Unit),
}

/// Maximum absolute value of a guess. A double of this size leaves few decimals for an angle.
const MAX_DISTANCE: f64 = 1e12;

/// The error of a guess that cannot be parsed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GuessError;

impl fmt::Display for GuessError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(words().guess_is_written())
    }
}

impl std::error::Error for GuessError {}

impl Guess {
    /// Parses guesses typed in one line, separated by commas: `r3=20, r4=280`.
    ///
    /// # Errors
    /// Returns an error if one of them cannot be parsed.
    pub fn listed(text: &str) -> Result<Vec<Guess>, GuessError> {
        let all = entries_with_numbers(text);
        let all = all.iter().map(|guess| guess.trim());
        all.filter(|guess| !guess.is_empty())
            .map(str::parse)
            .collect()
    }
}

impl FromStr for Guess {
    type Err = GuessError;

    fn from_str(text: &str) -> Result<Guess, GuessError> {
        let (name, value) = text.split_once('=').ok_or(GuessError)?;
        let (name, value) = (name.trim(), value.trim());
        let number = value.trim_end_matches(|c: char| c.is_alphabetic() || c == '°');
        let unit = match plain_unit(&value[number.len()..]).as_ref() {
            "" => None,
            "deg" => Some(GuessUnit::Degrees),
            "rad" => Some(GuessUnit::Radians),
            symbol => {
                let unit = Unit::ALL.into_iter().find(|unit| unit.symbol() == symbol);
                Some(GuessUnit::Length(unit.ok_or(GuessError)?))
            }
        };
        let read = |text: &str| match with_point(text).map(|text| text.parse::<f64>()) {
            Some(Ok(value)) if value.is_finite() => Ok(value),
            _ => Err(GuessError),
        };
        let between = match number.split_once("..") {
            Some((from, to)) => [read(from)?, read(to)?],
            None => [read(number)?; 2],
        };
        let is_far = between.iter().any(|value| value.abs() > MAX_DISTANCE);
        if name.is_empty() || is_far {
            return Err(GuessError);
        }
        let name = name.to_owned();
        Ok(Guess {
            name,
            between,
            unit,
        })
    }
}

/// The guesses for a scene.
pub(super) struct Guesses {
    /// The given values: in degrees of the link, or in the scene's unit.
    given_values: Vec<(LoopUnknown, [f64; 2])>,
    /// The state at the opening of the scene.
    opening: Workspace,
}

impl Guesses {
    /// Resolves guesses for a scene.
    ///
    /// # Errors
    /// Returns a message for an unknown name, a vector without an unknown, a missing or unsuitable
    /// unit, or an interval for a method that starts at a single value.
    pub(super) fn new(
        context: &Context<'_>,
        method: PositionMethod,
        guesses: &[Guess],
    ) -> Result<Guesses, String> {
        if let (Some(guess), false) = (guesses.first(), method.takes_guess()) {
            return Err(words().needs_no_guess(&guess.name));
        }
        let mut opening = context.solver.state();
        let start = context.scene.mechanism.driver().start;
        let _ = context.solver.solve(start, Order::Position, &mut opening);
        let mut text: Vec<(LoopUnknown, [f64; 2])> = Vec::new();
        for guess in guesses {
            let found = resolve_guess(context, guess)?;
            if text.iter().any(|(unknown, _)| *unknown == found.0) {
                return Err(words().guessed_twice(&guess.name));
            }
            if method == PositionMethod::Newton && guess.between[0] != guess.between[1] {
                return Err(words().guess_is_one_value(&guess.name));
            }
            text.push(found);
        }
        Ok(Guesses {
            given_values: text,
            opening,
        })
    }

    /// Returns the given values of an unknown, if any: in degrees of the link, or in the scene's
    /// unit.
    pub(super) fn given_values(&self, unknown: LoopUnknown) -> Option<[f64; 2]> {
        let text = self.given_values.iter().find(|(of, _)| *of == unknown);
        text.map(|(_, between)| *between)
    }

    /// Returns the initial value: the given one, or one as read from a sketch. In degrees, or in
    /// the scene's unit.
    pub(super) fn one(&self, context: &Context<'_>, unknown: LoopUnknown) -> f64 {
        if let Some([value, _]) = self.given_values(unknown) {
            return value;
        }
        match unknown {
            LoopUnknown::Angle(link) => (self.rough_angle(context, link) / 10.0).round() * 10.0,
            LoopUnknown::Travel(slide) => {
                let step = 10.0_f64.powf(context.longest.log10().floor()) / 2.0;
                let travel = self.opening.known().travel(slide).position;
                (travel / step).round() * step
            }
            LoopUnknown::Length(_) | LoopUnknown::Direction(_) => f64::NAN,
        }
    }

    /// Returns the direction of a link between two of its points, from their rough positions in the
    /// scene.
    fn rough_angle(&self, context: &Context<'_>, link: LinkId) -> f64 {
        let of = context.scene.mechanism.link(link);
        let members = &of.members;
        let distance = |a: PointId, b: PointId| {
            let local = of.local(b)? - of.local(a)?;
            (local.norm() > 0.0).then_some((a, b, local))
        };
        let own = of.ends.and_then(|(from, to)| distance(from, to));
        let pair = own.or_else(|| {
            let first = members.first()?.point;
            members
                .iter()
                .find_map(|member| distance(first, member.point))
        });
        let value = pair.and_then(|(a, b, local)| {
            let between = self.rough(context, b) - self.rough(context, a);
            let far = between.norm() > 0.1 * local.norm();
            far.then(|| angle::degrees(between) - angle::degrees(local))
        });
        let exact = || self.opening.known().angle(link);
        angle::wrapped(value.filter(|t| t.is_finite()).unwrap_or_else(exact))
    }

    fn rough(&self, context: &Context<'_>, point: PointId) -> Vec2 {
        let start = context.scene.mechanism.start().iter();
        let text = start
            .filter(|(of, _)| *of == point)
            .map(|&(_, at)| at)
            .next();
        text.unwrap_or_else(|| self.opening.known().position(point))
    }
}

/// Returns the unknowns of the named vector or link, each with the angle between the vector and the
/// link; `None` for an unknown name.
fn unknowns_of(context: &Context<'_>, name: &str) -> Option<Vec<(LoopUnknown, f64)>> {
    let is_sought = |unknown: &(LoopUnknown, f64)| {
        let mut stages = context.stages.iter().filter(|stage| stage.group.is_some());
        stages.any(|stage| stage.unknowns.contains(&unknown.0))
    };
    let turning = |turns: Turns| match turns {
        Turns::With(link, ahead) => Some((LoopUnknown::Angle(link), ahead)),
        Turns::Never | Turns::Freely => None,
    };
    let of_side = |side: &Side| {
        let travel = match side.shape {
            SideShape::Slide(slide) => Some((LoopUnknown::Travel(slide), 0.0)),
            SideShape::Link(_) | SideShape::Rigid(..) | SideShape::Free(..) => None,
        };
        [turning(side.turns), travel]
    };
    let of_link = |link: LinkId| {
        [
            turning(context.polygon.locks.turns(Body::Link(link), 0.0)),
            None,
        ]
    };
    let side = context.polygon.sides.iter().find(|side| side.name == name);
    let mut links = context.scene.mechanism.link_ids();
    let found = side.map(of_side).or_else(|| {
        let link = links.find(|&link| context.scene.link_name(link) == name);
        link.map(of_link)
    })?;
    Some(found.into_iter().flatten().filter(is_sought).collect())
}

/// Returns the unknown meant by a guess, and its values: in degrees of the link, or in the scene's
/// unit.
fn resolve_guess(context: &Context<'_>, guess: &Guess) -> Result<(LoopUnknown, [f64; 2]), String> {
    let Some(found) = unknowns_of(context, &guess.name) else {
        let fix = did_you_mean(&guess.name, vectors(context));
        let fix = fix.unwrap_or_else(|| words().sought_are(&unknown_names(context)));
        return Err(words().guess_of_nothing(&guess.name, &fix));
    };
    let fits = |(unknown, _): &(LoopUnknown, f64)| match guess.unit {
        None => true,
        Some(GuessUnit::Length(_)) => kind(*unknown) == UnknownKind::Length,
        Some(GuessUnit::Degrees | GuessUnit::Radians) => kind(*unknown) == UnknownKind::Angle,
    };
    let fitting: Vec<_> = found.iter().copied().filter(fits).collect();
    let unit = context.figures.unit;
    let (unknown, ahead) = match (&fitting[..], found.is_empty()) {
        (_, true) => return Err(words().not_sought(&guess.name, &unknown_names(context))),
        ([], false) => {
            let is_angle = found.iter().any(|(u, _)| kind(*u) == UnknownKind::Angle);
            let unit = if is_angle { "deg" } else { unit };
            return Err(words().other_unit(&guess.name, unit));
        }
        ([one], _) => *one,
        (_, false) => return Err(words().unit_missing(&guess.name, unit)),
    };
    let value = |value: f64| match guess.unit {
        Some(GuessUnit::Radians) => value.to_degrees() - ahead,
        Some(GuessUnit::Length(of)) => value * of.in_units_of(context.scene.unit),
        Some(GuessUnit::Degrees) | None => value - ahead,
    };
    Ok((unknown, guess.between.map(value)))
}

/// Returns the names of all vectors.
fn vectors<'a>(context: &'a Context<'_>) -> impl Iterator<Item = &'a str> {
    context.polygon.sides.iter().map(|side| side.name.as_str())
}

/// Lists the names of the vectors with an unknown.
fn unknown_names(context: &Context<'_>) -> String {
    let is_sought = |name: &&str| unknowns_of(context, name).is_some_and(|found| !found.is_empty());
    let names: Vec<&str> = vectors(context).filter(is_sought).collect();
    names.join(", ")
}

/// Formats values of unknowns: `θ3 = 30 deg, θ4 = 290 deg`.
pub(super) fn format_unknowns(context: &Context<'_>, values: &[(LoopUnknown, f64)]) -> String {
    let f = context.figures;
    let one = |&(unknown, value): &(LoopUnknown, f64)| {
        let unit = f.unit_of(kind(unknown));
        format!(
            "{} = {} {unit}",
            context.symbol(unknown, Order::Position),
            f.angle(value)
        )
    };
    values.iter().map(one).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn guess_is_a_name_with_value_or_interval() {
        let of = |text: &str| text.parse::<Guess>();
        let guess = of("r3=20").unwrap();
        assert_eq!(
            (guess.name.as_str(), guess.between, guess.unit),
            ("r3", [20.0; 2], None)
        );
        let guess = of("r3 = -0.5rad").unwrap();
        assert_eq!(
            (guess.between, guess.unit),
            ([-0.5; 2], Some(GuessUnit::Radians))
        );
        let guess = of("r4=1e2..2.5e2mm").unwrap();
        assert_eq!(guess.between, [100.0, 250.0]);
        assert_eq!(guess.unit, Some(GuessUnit::Length(Unit::Millimetre)));
        for wrong in [
            "",
            "r3",
            "=20",
            "r3=",
            "r3=x",
            "r3=20furlong",
            "r3=nan",
            "r3=1..",
            "r3=inf",
        ] {
            assert_eq!(of(wrong), Err(GuessError), "{wrong}");
        }
    }
}
