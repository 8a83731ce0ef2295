//! Reads addresses of PMKS+ with the parameters `j`, `l`, `f` and `s`.

use super::ImportError;
use super::address;
use super::drawing::{Drawing, DrawnLaw, DrawnLoad, DrawnMass, DrawnPart, direction, number};
use super::joints::{JointKind, Joints, ReadJoint};
use crate::scene::Unit;
use crate::wording::words;

/// The acceleration of fall, in m/s^2.
const GRAVITY: [f64; 2] = [0.0, -9.81];

/// Reads the parameters of an address.
pub(super) fn read_pmks_plus(parameters: &[(String, String)]) -> Result<Drawing, ImportError> {
    let value = |name: &str| address::value(parameters, name).unwrap_or_default();
    let mut joints = Joints::default();
    for (name, text) in parameters {
        if !["j", "l", "f", "s"].contains(&name.as_str()) && !text.is_empty() {
            let place = format!("`{name}`");
            joints
                .drawing
                .remark(&place, words().import_unknown_parameter());
        }
    }
    let mut points = Vec::new();
    for (number_of_row, row) in rows(value("j")) {
        let place = words().import_joint_row(number_of_row, "j");
        match joint(&row, &place) {
            Some((mut joint, is_fixed)) => {
                for (name, cell) in unread_cells(&row) {
                    let text = words().import_unread_cell(name, &cell);
                    joints.drawing.remark(&place, &text);
                }
                if is_fixed {
                    joint.links.insert(0, "ground".to_owned());
                }
                let name = joint.name.clone().unwrap_or_default();
                // A slider is a point of one of its two links only.
                let point = joints.add(&joint).filter(|_| joint.kind == JointKind::Pin);
                points.push((name, point));
            }
            None => joints.drawing.remark(&place, words().import_not_a_joint()),
        }
    }
    if points.is_empty() {
        return Err(ImportError::new(words().import_no_joints()));
    }
    for (number_of_row, row) in rows(value("l")) {
        let place = words().import_link_row(number_of_row);
        link(&mut joints, &points, &row, &place);
    }
    for (number_of_row, row) in rows(value("f")) {
        let place = words().import_force_row(number_of_row);
        if force(&mut joints, &row).is_none() {
            joints.drawing.remark(&place, words().import_not_a_force());
        }
    }
    let settings: Vec<&str> = value("s").split(',').map(str::trim).collect();
    let law = settings_of(&mut joints.drawing, &settings);
    joints
        .finish(&law, false)
        .ok_or_else(ImportError::too_large)
}

/// Returns the flags and the angle of a joint's row that are none, with their names.
fn unread_cells(row: &[String]) -> Vec<(&'static str, String)> {
    let rest = trimmed_row(row.get(6..).unwrap_or_default());
    let mut unread = Vec::new();
    if let Some(fixed) = row.get(5).filter(|cell| flag(cell).is_none()) {
        unread.push(("ground", fixed.clone()));
    }
    if let [angle, others @ ..] = rest {
        if number(angle).is_none() && !is_absent(angle) {
            unread.push(("angle", angle.clone()));
        }
        if let Some(input) = others.last().filter(|cell| flag(cell).is_none()) {
            unread.push(("input", input.clone()));
        }
    }
    unread
}

/// Returns `true` for a cell without a value.
fn is_absent(cell: &str) -> bool {
    cell.is_empty() || cell.eq_ignore_ascii_case("null")
}

/// Returns a row without the empty cells at its end: some addresses have a comma at the end of each
/// joint.
fn trimmed_row(row: &[String]) -> &[String] {
    let end = row.iter().rposition(|cell| !cell.is_empty());
    &row[..end.map_or(0, |last| last + 1)]
}

/// Returns `true` if a value contains a joint.
pub(super) fn has_joints(text: &str) -> bool {
    rows(text).any(|(_, row)| joint(&row, "").is_some())
}

/// Returns the rows of a parameter with their numbers, split at commas.
fn rows(text: &str) -> impl Iterator<Item = (usize, Vec<String>)> {
    let rows = text.lines().map(str::trim).filter(|row| !row.is_empty());
    rows.enumerate().map(|(number, row)| {
        let parts = row.split(',').map(|part| part.trim().to_owned());
        (number + 1, parts.collect())
    })
}

fn is_true(text: &str) -> bool {
    flag(text) == Some(true)
}

/// Reads a flag; `None` for any other text.
fn flag(text: &str) -> Option<bool> {
    match text {
        "t" | "true" | "T" => Some(true),
        "f" | "false" | "F" => Some(false),
        _ => None,
    }
}

/// Reads a joint, and whether it is fixed in the frame: name, x, y, links, type, ground, angle, ..,
/// input.
fn joint(row: &[String], place: &str) -> Option<(ReadJoint, bool)> {
    let [name, x, y, links, kind, is_fixed, rest @ ..] = row else {
        return None;
    };
    let rest = trimmed_row(rest);
    let kind = JointKind::parse(kind)?;
    let at = [number(x)?, number(y)?];
    // The angle is in radians; joints without one have `Null`.
    let angle = rest.first().and_then(|angle| number(angle)).unwrap_or(0.0);
    let links = links.split('|').filter(|link| !link.is_empty());
    let joint = ReadJoint {
        name: Some(name.clone()),
        links: links.map(str::to_owned).collect(),
        kind,
        at,
        angle: angle.to_degrees(),
        is_input: rest.len() > 1 && rest.last().is_some_and(|input| is_true(input)),
        place: place.to_owned(),
    };
    Some((joint, is_true(is_fixed)))
}

/// Reads a link: name, R or P, mass, moment of inertia, centre of mass, joints. Joints that name
/// the link come first; a joint that only the link names is added to it.
fn link(joints: &mut Joints, points: &[(String, Option<usize>)], row: &[String], place: &str) {
    let Some(name) = row.first() else {
        return;
    };
    let Some(part) = joints.known(name) else {
        joints
            .drawing
            .remark(place, &words().import_link_without_joints(name));
        return;
    };
    let own = row
        .get(6)
        .map(|names| names.split('|'))
        .into_iter()
        .flatten();
    let mut is_shifted = false;
    for joint in own.filter(|joint| !joint.is_empty()) {
        let Some((_, point)) = points.iter().find(|(name, _)| name == joint) else {
            is_shifted |= number(joint).is_some();
            joints
                .drawing
                .remark(place, &words().import_unknown_joint(joint));
            continue;
        };
        if let Some(point) = *point {
            joints.drawing.attach(point, part);
        }
    }
    let masses: Vec<&String> = row.iter().skip(2).take(4).collect();
    let values: Vec<Option<f64>> = masses.iter().map(|text| number(text)).collect();
    let is_read = |(text, value): (&&String, &Option<f64>)| value.is_some() || is_absent(text);
    let mut is_read = masses.iter().zip(&values).all(is_read) && !is_shifted;
    if let [Some(mass), inertia, Some(x), Some(y)] = values[..]
        && is_read
    {
        let inertia = inertia.unwrap_or(0.0);
        is_read = mass >= 0.0 && inertia >= 0.0;
        if let (DrawnPart::Link(link), true) = (part, is_read && mass > 0.0) {
            joints.drawing.links[link].mass = Some(DrawnMass {
                centre: [x, y],
                mass,
                inertia,
            });
        }
    }
    let is_without_centre =
        matches!(values[..], [Some(mass), _, None, _] | [Some(mass), _, _, None] if mass != 0.0);
    if !is_read || is_without_centre {
        joints.drawing.remark(place, words().import_not_a_mass());
    }
}

/// Reads a force: name, link, start, end, whether it keeps its direction, whether it points away
/// from the link, size.
fn force(joints: &mut Joints, row: &[String]) -> Option<()> {
    let [
        name,
        link,
        from_x,
        from_y,
        to_x,
        to_y,
        is_global,
        is_outward,
        size,
    ] = trimmed_row(row)
    else {
        return None;
    };
    let DrawnPart::Link(link) = joints.known(link)? else {
        return None;
    };
    let from = [number(from_x)?, number(from_y)?];
    let to = [number(to_x)?, number(to_y)?];
    let sign = if flag(is_outward)? { 1.0 } else { -1.0 };
    let is_global = flag(is_global)?;
    let size = sign * number(size)?;
    let way = [to[0] - from[0], to[1] - from[1]];
    let length = way[0].hypot(way[1]);
    if !(length > 0.0) || !direction(way).is_finite() {
        return None;
    }
    let point = joints.drawing.point(Some(name.clone()), from);
    joints.drawing.attach(point, DrawnPart::Link(link));
    joints.drawing.loads.push(DrawnLoad {
        point,
        force: way.map(|part| size * part / length),
        turns_with: (!is_global).then_some(link),
    });
    Some(())
}

/// Reads the settings: speed in rpm, whether it is clockwise, gravity, unit. Returns the law of the
/// inputs.
fn settings_of(drawing: &mut Drawing, settings: &[&str]) -> DrawnLaw {
    let cell = |i: usize| settings.get(i).copied().unwrap_or_default();
    let [speed, is_clockwise, has_gravity, unit] = [0, 1, 2, 3].map(cell);
    let mut unread = |name: &str, cell: &str| {
        if !is_absent(cell) {
            let text = words().import_unread_cell(name, cell);
            drawing.remark("`s`", &text);
        }
    };
    let rpm = number(speed);
    if rpm.is_none() {
        unread("speed", speed);
    }
    for (name, cell) in [("clockwise", is_clockwise), ("gravity", has_gravity)] {
        if flag(cell).is_none() {
            unread(name, cell);
        }
    }
    drawing.unit = Unit::ALL.into_iter().find(|known| known.symbol() == unit);
    if drawing.unit.is_none() && !is_absent(unit) {
        let text = words().import_unknown_unit(unit);
        drawing.remark("`s`", &text);
    }
    if is_true(has_gravity) {
        drawing.gravity = Some(GRAVITY);
    }
    match rpm {
        Some(speed) if speed != 0.0 => {
            let sign = if is_true(is_clockwise) { -1.0 } else { 1.0 };
            DrawnLaw::Speed(sign * speed, "rpm")
        }
        _ => DrawnLaw::Unknown,
    }
}
