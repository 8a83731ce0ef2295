//! Reads the driver.

use crate::angle::TURN;
use crate::document::{Diagnostic, WrittenValue};
use crate::nearest::did_you_mean;
use crate::scene::elements::limits::{self, DraftEnds};
use crate::scene::elements::link::DraftLink;
use crate::scene::inputs::timed_motion::{self, MotionFrame};
use crate::scene::numbers::rate::{self, Degree, Rate, RateError, RateKind};
use crate::scene::numbers::reader::{ByteSpan, Name, Reader};
use crate::scene::table::KeyTable;
use crate::scene::{Unit, keys};
use crate::wording::words;
use crate::{Double, Mechanism, MotionLaw};
use toml::de::DeValue;

#[derive(Debug)]
pub(crate) struct DraftDriver<'t> {
    /// The link or slide named by the key `link` or `slide`.
    pub(crate) input: DraftInput<'t>,
    /// The link that carries the motor of a driven link; `None` if the ground carries it.
    pub(crate) from: Option<Name<'t>>,
    pub(crate) start: f64,
    /// The range of the coordinate.
    pub(crate) range: Option<DraftEnds>,
    pub(crate) speed: f64,
    pub(crate) acceleration: f64,
    /// Whether the speed or the acceleration was converted from another unit.
    pub(crate) is_converted: bool,
    /// The given speed and acceleration as double-doubles, if both are known.
    pub(crate) typed_rates: Option<[Double; 2]>,
    /// The motion over time.
    pub(crate) motion: Option<MotionLaw>,
}

#[derive(Debug)]
pub(crate) enum DraftInput<'t> {
    Link(Name<'t>),
    Slide(Name<'t>),
}

impl<'t> DraftDriver<'t> {
    /// Returns the name of the driven link or slide.
    pub(crate) fn driven(&self) -> &Name<'t> {
        let (DraftInput::Link(driven) | DraftInput::Slide(driven)) = &self.input;
        driven
    }

    /// Returns the name of the driven link; `None` if a slide is driven.
    pub(crate) fn driven_link(&self) -> Option<&Name<'t>> {
        match &self.input {
            DraftInput::Link(driven) => Some(driven),
            DraftInput::Slide(_) => None,
        }
    }
}

/// The speed if the file has none: one unit of the coordinate per second, so that velocities equal
/// the kinematic coefficients.
const UNIT_SPEED: f64 = 1.0;

/// The keys of one kind of driver.
pub(crate) struct DriverForm {
    /// The key that names the driven element.
    pub(crate) driven: &'static str,
    /// The key of the coordinate.
    coordinate: &'static str,
    /// The key of the other kind's coordinate.
    other: &'static str,
    /// The key of the motor's effort.
    pub(crate) effort: &'static str,
    example: &'static str,
}

pub(crate) const TURNED: DriverForm = DriverForm {
    driven: "link",
    coordinate: "angle",
    other: "position",
    effort: "torque",
    example: r#"link = "r2", angle = 60, speed = "15 rad/s""#,
};

pub(crate) const PUSHED: DriverForm = DriverForm {
    driven: "slide",
    coordinate: "position",
    other: "angle",
    effort: "force",
    example: r#"slide = "r4", position = 120, speed = "50 mm/s""#,
};

/// Returns the key of the driver's coordinate.
pub fn coordinate_key(mechanism: &Mechanism) -> &'static str {
    let form = match mechanism.driver().input {
        crate::Input::Turn(_) => TURNED,
        crate::Input::Push(_) => PUSHED,
    };
    form.coordinate
}

/// Reads the section; `key` is the place of its name. A link as drawn opens in its direction.
///
/// It has no `angle`: `[start]` is the drawing at its own angle, and the assembly nearest to it at
/// another angle can be the other one.
pub(crate) fn driver<'v>(
    reader: &mut Reader<'_>,
    unit: Unit,
    links: &[DraftLink<'_>],
    key: &ByteSpan,
    value: &'v WrittenValue<'v>,
) -> Option<DraftDriver<'v>> {
    let example = format!("{{ {} }}", TURNED.example);
    let names = ["[driver]", words().the_driver()];
    let mut table = reader.open(names, keys::DRIVER, &example, value)?;
    let (form, kind) = match (table.has("link"), table.has("slide")) {
        (true, false) => (TURNED, RateKind::Turn),
        (false, true) => (PUSHED, RateKind::Push(unit)),
        (false, false) => {
            neither(reader, &table, key);
            return None;
        }
        (true, true) => {
            let fault = Diagnostic::new(words().driver_has_both());
            reader.report(both_forms(fault.at(key.clone(), words().one_is_driven())));
            return None;
        }
    };
    table.kind = form.driven;
    let table = &table;
    let name = reader.text_of(table, form.driven);
    // The check of the keys reports a `from` of a driven slide.
    let given_seat = table.get("from").filter(|_| kind == RateKind::Turn);
    let from = seat(reader, words().the_driver(), kind, given_seat);
    let range = range(reader, kind, table);
    let drawn = || drawn_angle(links, name.as_ref()?, from.as_ref(), range.as_ref());
    let start = match table.key(form.other) {
        Some(other) if !table.has(form.coordinate) => {
            other_coordinate(reader, other, &form);
            None
        }
        None if kind == RateKind::Turn && drawn().is_some() => {
            reader.only_known(table);
            if let Some(angle) = table.key(form.coordinate) {
                let driven = name.as_ref().map_or(form.driven, |name| name.text);
                reader.report(
                    Diagnostic::new(words().drawn_driver_has_angle(driven))
                        .at(angle.span, words().drawing_has_angle())
                        .help(words().open_as_drawn()),
                );
            }
            drawn()
        }
        _ => start(reader, table, &form, key),
    };
    let speed = rate(reader, table, "speed", kind, Degree::Speed);
    let acceleration = rate(reader, table, "acceleration", kind, Degree::Acceleration);
    let motion = motion(reader, table, start, kind, range.as_ref());
    let name = name?;
    if given_seat.is_some() && from.is_none() {
        return None;
    }
    let rates = [speed, acceleration];
    let typed = |rate: Option<Rate>, default: f64| match rate {
        Some(rate) => rate.typed,
        None => Some(Double::exactly(default)),
    };
    let typed_rates = typed(speed, UNIT_SPEED).zip(typed(acceleration, 0.0));
    let typed_rates = typed_rates.filter(|_| motion.is_none());
    let [speed, acceleration] = rates.map(|rate| rate.map(|rate| rate.value));
    Some(DraftDriver {
        input: match kind {
            RateKind::Turn => DraftInput::Link(name),
            RateKind::Push(_) => DraftInput::Slide(name),
        },
        from,
        start: start.unwrap_or(0.0),
        range,
        speed: speed.unwrap_or(UNIT_SPEED),
        acceleration: acceleration.unwrap_or(0.0),
        is_converted: rates.into_iter().flatten().any(|rate| rate.is_converted)
            // The speeds of a motion law are per degree.
            || motion.is_some(),
        typed_rates: typed_rates.map(<[Double; 2]>::from),
        motion,
    })
}

/// Returns the opening angle of a link as drawn, relative to the link that carries its motor, and
/// within the range of the driver.
fn drawn_angle(
    links: &[DraftLink<'_>],
    name: &Name<'_>,
    from: Option<&Name<'_>>,
    range: Option<&DraftEnds>,
) -> Option<f64> {
    let direction = |name: &Name<'_>| {
        let mut links = links.iter();
        links.find(|link| link.name.text == name.text)?.direction
    };
    let seat = match from.filter(|from| from.text != "ground") {
        Some(from) => direction(from)?,
        None => 0.0,
    };
    let lowest = range.map_or(0.0, |range| range.low);
    Some(lowest + (direction(name)? - seat - lowest).rem_euclid(TURN))
}

/// Reads the link that carries the motor of an input. Reports a driven slide that has one: its
/// guide takes that role.
pub(crate) fn seat<'v>(
    reader: &mut Reader<'_>,
    of: &str,
    kind: RateKind,
    given: Option<&'v WrittenValue<'v>>,
) -> Option<Name<'v>> {
    let given = given?;
    let from = reader.string(&words().key_of("from", of), given)?;
    match kind {
        RateKind::Turn => Some(from),
        RateKind::Push(_) => {
            reader.report(
                Diagnostic::new(words().slide_has_its_guide(of))
                    .at(from.span.clone(), words().not_of_a_slide())
                    .help(words().seat_is_for_links()),
            );
            None
        }
    }
}

/// Reads the motion over time. Reports a speed or an acceleration given together with it.
fn motion(
    reader: &mut Reader<'_>,
    table: &KeyTable<'_>,
    start: Option<f64>,
    kind: RateKind,
    range: Option<&DraftEnds>,
) -> Option<MotionLaw> {
    let given = table.get("motion")?;
    for key in ["speed", "acceleration"] {
        if let Some(nearby) = table.key(key) {
            timed_motion::report_redundant_key(reader, key, &nearby.span);
        }
    }
    let frame = MotionFrame {
        start: start?,
        is_rotary: kind == RateKind::Turn,
        range,
    };
    let what = table.what(reader, "motion");
    timed_motion::read(reader, &frame, &what, given)
}

fn range(reader: &mut Reader<'_>, kind: RateKind, table: &KeyTable<'_>) -> Option<DraftEnds> {
    let what = table.what(reader, "range");
    let range = limits::range(reader, &what, table.get("range")?);
    if let (Some(range), RateKind::Turn) = (&range, kind) {
        limits::check_turns(reader, &what, range);
    }
    range
}

/// Reports a driver without a link or slide, unless a misspelt key explains it.
fn neither(reader: &mut Reader<'_>, table: &KeyTable<'_>, key: &ByteSpan) {
    reader.only_known(table);
    if !table.is_probable_misspelling("link") && !table.is_probable_misspelling("slide") {
        let fault = Diagnostic::new(words().driver_has_neither());
        reader.report(both_forms(
            fault.at(key.clone(), words().nothing_is_driven()),
        ));
    }
}

fn both_forms(fault: Diagnostic) -> Diagnostic {
    fault
        .help(words().how_a_link_is_driven(TURNED.example))
        .help(words().how_a_slide_is_driven(PUSHED.example))
}

/// Reports a coordinate of the other kind of driver.
fn other_coordinate(reader: &mut Reader<'_>, other: Name<'_>, form: &DriverForm) {
    let (driven, coordinate) = (form.driven, form.coordinate);
    reader.report(
        Diagnostic::new(words().driver_has_other(driven, other.text, coordinate))
            .at(other.span, words().coordinate_is_meant(coordinate))
            .help(words().for_example(&format!("{coordinate} = 60"))),
    );
}

/// Reads the coordinate at which the scene opens.
fn start(
    reader: &mut Reader<'_>,
    table: &KeyTable<'_>,
    form: &DriverForm,
    key: &ByteSpan,
) -> Option<f64> {
    let coordinate = form.coordinate;
    reader.only_known(table);
    // A misspelt key was already reported; do not report the missing key as well.
    if !table.has(coordinate) && !table.is_probable_misspelling(coordinate) {
        let label = words().coordinate_is_missing(coordinate);
        reader.report(
            Diagnostic::new(words().driver_lacks(coordinate))
                .at(key.clone(), label)
                .help(words().for_example(&format!("{coordinate} = 60"))),
        );
    }
    reader.number_of(table, coordinate)
}

/// Reads a speed or an acceleration; returns `None` if it is missing or invalid.
pub(crate) fn rate(
    reader: &mut Reader<'_>,
    table: &KeyTable<'_>,
    key: &str,
    kind: RateKind,
    degree: Degree,
) -> Option<Rate> {
    let value = table.get(key)?;
    let (of, span) = (&*table.of, value.span());
    let literal = reader.literal(&span);
    let plain = literal.trim_matches(['`', '"', '\'', ' ']);
    let misfit = match value.get_ref() {
        DeValue::String(text) => match rate::parse(text, kind, degree) {
            Ok(rate) => return Some(rate),
            Err(misfit) => match rate::formula(text, kind, degree) {
                Some((formula, unit)) => {
                    let what = words().key_of(key, of);
                    let result = reader.worked_out(&what, formula, &span)?;
                    if let Some(dimension) = result.dimension {
                        let found = dimension.symbol(reader.named.length.0);
                        let message = words().rate_of_units(key, of, formula, &found);
                        let fault = Diagnostic::new(message).at(span, "");
                        reader.report(fault.help(words().rate_brings_its_unit(formula, unit)));
                        return None;
                    }
                    let rate = rate::of(result.value.twice(), unit, kind);
                    if rate.value.is_finite() {
                        return Some(rate);
                    }
                    RateError::NotFinite
                }
                None => misfit,
            },
        },
        DeValue::Integer(_) | DeValue::Float(_) => RateError::NoUnit,
        _ => RateError::NoNumber,
    };
    let units = rate::units(kind, degree);
    let (message, help) = match misfit {
        RateError::NoNumber => (
            words().rate_is_no_number(key, of, plain),
            Some(words().for_example(&format!("{key} = \"15 {}\"", units[0]))),
        ),
        RateError::NoUnit => (
            words().rate_has_no_unit(key, of, plain),
            Some(words().for_example(&format!("{key} = \"{plain} {}\"", units[0]))),
        ),
        RateError::Unit(unit) => (
            words().rate_has_other_unit(key, of, plain),
            did_you_mean(unit, units.iter().copied()),
        ),
        RateError::TwoMarks => (
            words().rate_has_two_marks(key, of, plain),
            Some(words().digits_without_groups().to_owned()),
        ),
        RateError::NotFinite => (words().rate_is_too_large(key, of, plain), None),
    };
    reader.report(
        Diagnostic::new(message)
            .at(span, words().expected_a_rate())
            .maybe_help(help)
            .help(words().possible_units(&format!("`{}`", units.join("`, `")))),
    );
    None
}
