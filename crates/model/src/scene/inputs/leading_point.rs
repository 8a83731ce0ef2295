//! Reads the point that inputs follow, with its motion over time.

use crate::document::{Diagnostic, WrittenValue};
use crate::nearest::did_you_mean;
use crate::scene::inputs::input;
use crate::scene::keys;
use crate::scene::numbers::rate::{Degree, RateKind};
use crate::scene::numbers::reader::{ByteSpan, Name, Reader};
use crate::scene::resolve::Resolver;
use crate::scene::table::KeyTable;
use crate::wording::words;
use crate::{CoordinateAxis, Input, Mechanism, PointCircle, PointId, PointLead, PointPath};

const LEAD: &str = "P = { over = [[0, 120, 60], [2, 90, 90]] }";
const ROWS: &str = "over = [[0, 120, 60], [2, 90, 90]]";
const CIRCLE: &str = r#"centre = [0, 190], radius = 20, speed = "60 deg/s""#;
/// The number of coordinates of a point.
const COORDINATES: usize = 2;

/// A point that leads, with its motion over time (`[lead]`). Inputs follow it.
#[derive(Clone, Debug, PartialEq)]
pub struct LeadingPoint {
    /// The point.
    pub point: PointId,
    /// The inputs that follow, by their index: see [`Mechanism::inputs`].
    pub inputs: Vec<usize>,
    /// The motion of the point.
    pub path: PointPath,
}

impl LeadingPoint {
    /// Returns the coordinates that lead, x and y, with the inputs that follow.
    #[must_use]
    pub fn lead(&self) -> PointLead {
        let axes = [CoordinateAxis::X, CoordinateAxis::Y];
        PointLead {
            coordinates: axes.map(|axis| (self.point, axis)).to_vec(),
            inputs: self.inputs.clone(),
        }
    }
}

/// The leading point with names to resolve.
#[derive(Debug)]
pub(crate) struct DraftLead<'t> {
    name: Name<'t>,
    /// The inputs that follow; `None` for all.
    inputs: Option<NamedInputs<'t>>,
    path: PointPath,
}

/// A list of the names of inputs.
#[derive(Debug)]
struct NamedInputs<'t> {
    names: Vec<Name<'t>>,
    span: ByteSpan,
}

/// Reads the section.
pub(crate) fn read<'v>(
    reader: &mut Reader<'_>,
    value: &'v WrittenValue<'v>,
) -> Option<DraftLead<'v>> {
    let mut entries: Vec<(Name<'v>, &WrittenValue<'v>)> =
        reader.entries("[lead]", LEAD, value).collect();
    if let [(first, _), (second, _), ..] = &entries[..] {
        reader.report(
            Diagnostic::new(words().two_points_lead(&first.to_string(), &second.to_string()))
                .at(second.span.clone(), words().second_leading_point())
                .and(first.span.clone(), words().first_leading_point()),
        );
        return None;
    }
    let (name, value) = entries.pop()?;
    let of = words().leading_point(&name.to_string());
    let table = &mut reader.open([&of, &of], keys::LEAD, LEAD, value)?;
    let path = path(reader, table);
    let inputs = match table.get("inputs") {
        None => None,
        Some(value) => Some(following(reader, &table.what(reader, "inputs"), value)?),
    };
    Some(DraftLead {
        inputs,
        path: path?,
        name,
    })
}

/// Reads the motion of the point: rows, or a circle.
fn path(reader: &mut Reader<'_>, table: &mut KeyTable<'_>) -> Option<PointPath> {
    table.kind = match (table.has("over"), table.has("centre")) {
        (true, false) => "over",
        (false, true) => "centre",
        (has_rows, _) => {
            reader.only_known(table);
            let is_misspelt = ["over", "centre"]
                .iter()
                .any(|key| table.is_probable_misspelling(key));
            // A misspelt key was already reported.
            if has_rows {
                reader.report(
                    Diagnostic::new(words().input_has_two_laws(&table.of, "over", "centre"))
                        .at(table.span.clone(), words().says_the_same_otherwise()),
                );
            } else if !is_misspelt {
                reader.report(
                    Diagnostic::new(words().step_has_one_of(&table.of, "over", "centre"))
                        .at(table.span.clone(), words().how_does_point_move())
                        .help(words().for_example(ROWS))
                        .help(words().for_example(CIRCLE)),
                );
            }
            return None;
        }
    };
    reader.only_known(table);
    match table.get("over") {
        Some(over) => through(reader, &table.what(reader, "over"), over),
        None => circle(reader, table),
    }
}

/// Reads rows of time, x and y.
fn through(reader: &mut Reader<'_>, what: &str, value: &WrittenValue<'_>) -> Option<PointPath> {
    let wanted = words().a_list_of_rows("[t, x, y]");
    let items = reader.list(what, &wanted, ROWS, value)?;
    let mut rows: Vec<([f64; 3], ByteSpan)> = Vec::with_capacity(items.len());
    for (i, item) in items.iter().enumerate() {
        let what = words().row_in(i + 1, what);
        let [time, x, y] = three(reader, &what, item)?;
        let at = time.span();
        let mut number = |value| reader.number(&what, value);
        rows.push(([number(time)?, number(x)?, number(y)?], at));
    }
    if let [_] | [] = &rows[..] {
        reader.report(
            Diagnostic::new(words().path_of_few_rows(what))
                .at(value.span(), words().two_rows_are_needed())
                .help(words().for_example(ROWS)),
        );
        return None;
    }
    let grows = |pair: &[([f64; 3], ByteSpan)]| pair[0].0[0] < pair[1].0[0];
    if let Some([before, after]) = rows.windows(2).find(|pair| !grows(pair)) {
        let [first, second] = [before, after].map(|(_, at)| reader.literal(at));
        reader.report(
            Diagnostic::new(words().row_times_must_grow(what, &first, &second))
                .at(after.1.clone(), words().does_not_grow())
                .and(before.1.clone(), words().the_row_before()),
        );
        return None;
    }
    let rows: Vec<[f64; 3]> = rows.into_iter().map(|(row, _)| row).collect();
    let path = PointPath::through(&rows);
    if path.is_none() {
        reader.report(
            Diagnostic::new(words().path_is_too_fast(what))
                .at(value.span(), words().times_too_close()),
        );
    }
    path
}

/// Reads a row of exactly three values.
fn three<'v>(
    reader: &mut Reader<'_>,
    what: &str,
    value: &'v WrittenValue<'v>,
) -> Option<[&'v WrittenValue<'v>; 3]> {
    let items = reader.list(what, &words().a_row("[t, x, y]"), ROWS, value)?;
    if let [time, x, y] = items {
        return Some([time, x, y]);
    }
    reader.report(
        Diagnostic::new(words().must_be_a_row(what, "[t, x, y]", items.len()))
            .at(value.span(), words().expected_three(items.len()))
            .help(words().for_example(ROWS)),
    );
    None
}

/// Reads a circle at constant speed.
fn circle(reader: &mut Reader<'_>, table: &KeyTable<'_>) -> Option<PointPath> {
    for key in ["radius", "speed"] {
        reader.require(table, key, &table.span, CIRCLE);
    }
    let centre = reader.pair_of(table, "centre");
    let radius = reader.number_of(table, "radius");
    let angle = reader.number_or(table, "angle", 0.0);
    let speed = input::rate(reader, table, "speed", RateKind::Turn, Degree::Speed);
    if let (Some(rate), Some(value)) = (&speed, table.get("speed"))
        && rate.value == 0.0
    {
        reader.report(
            Diagnostic::new(words().circle_stands(&table.what(reader, "speed")))
                .at(value.span(), words().must_not_be_zero()),
        );
        return None;
    }
    Some(PointPath::Circle(PointCircle {
        centre: centre?,
        radius: radius?,
        angle: angle?,
        speed: speed?.value,
    }))
}

/// Reads the names of the inputs that follow.
fn following<'v>(
    reader: &mut Reader<'_>,
    what: &str,
    value: &'v WrittenValue<'v>,
) -> Option<NamedInputs<'v>> {
    let example = r#"inputs = ["r2", "r5"]"#;
    let items = reader.list(what, words().a_list_of_inputs(), example, value)?;
    let names = items.iter().map(|item| reader.string(what, item));
    let names: Option<Vec<Name<'v>>> = names.collect();
    Some(NamedInputs {
        names: names?,
        span: value.span(),
    })
}

impl<'t> Resolver<'_, '_, 't> {
    /// Resolves the leading point and the inputs that follow it, once the mechanism is built.
    pub(crate) fn leading_point(&mut self, mechanism: &Mechanism) -> Option<LeadingPoint> {
        let DraftLead { name, inputs, path } = self.draft.lead.as_ref()?;
        let point = self.point("[lead]", name)?;
        if let Some(ground) = self.ground.get(name.text) {
            self.reader.report(
                Diagnostic::new(words().ground_point_leads(&name.to_string()))
                    .at(name.span.clone(), words().does_not_move())
                    .and(ground.name.span.clone(), words().fixed_here()),
            );
            return None;
        }
        let known = mechanism.inputs().map(|input| match input {
            Input::Turn(link) => self.draft.links[link.index()].name.text,
            Input::Push(slide) => self.built_slides[slide.index()].name.text,
        });
        let known: Vec<&str> = known.collect();
        let following = match inputs {
            None => (0..known.len()).collect(),
            Some(inputs) => numbers(self.reader, &inputs.names, &known)?,
        };
        if following.len() != COORDINATES {
            let of = words().leading_point(&name.to_string());
            let span = inputs.as_ref().map_or(&name.span, |inputs| &inputs.span);
            let help = match known.len() {
                0 | 1 => words().add_a_second_input().to_owned(),
                _ => words().name_two_inputs(&known.join(", ")),
            };
            self.reader.report(
                Diagnostic::new(words().lead_needs_two_inputs(&of, following.len()))
                    .at(span.clone(), words().two_inputs_follow())
                    .help(help),
            );
            return None;
        }
        Some(LeadingPoint {
            point,
            inputs: following,
            path: path.clone(),
        })
    }
}

/// Returns the indices of inputs by their names; `None` for a reported fault.
fn numbers(reader: &mut Reader<'_>, names: &[Name<'_>], known: &[&str]) -> Option<Vec<usize>> {
    let mut numbers = Vec::with_capacity(names.len());
    for name in names {
        let index = known.iter().position(|input| *input == name.text);
        let message = match index {
            Some(index) if !numbers.contains(&index) => {
                numbers.push(index);
                continue;
            }
            Some(_) => words().given_twice(&name.to_string()),
            None => {
                let meant = did_you_mean(name.text, known.iter().copied());
                words().no_input_named(name.text, &known.join(", "), meant.as_deref())
            }
        };
        reader.report(Diagnostic::new(message).at(name.span.clone(), ""));
        return None;
    }
    Some(numbers)
}
