//! Draws the centre and circle point curves of four poses, the dyad under the cursor, and the
//! linkage made from two dyads.

use super::super::show_figure;
use super::curve_cursor::CurveWalk;
use super::list::CandidateList;
use super::{in_lines, print_facts};
use crate::Vec2;
use crate::drawing::{Extents, Figure, Role, Shape};
use crate::synthesis::{PinConstraint, PosedDyad};
use crate::tui::app::App;
use crate::tui::appearance::theme::ScreenPart;
use crate::wording::words;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

/// Half the size of the window, as a multiple of the poses' size. The window must be limited
/// because the curves extend to infinity.
const NEAR: f64 = 1.5;
/// Half the length of a slide's guide, as a multiple of the poses' size.
const GUIDE: f64 = 0.5;

pub(super) fn render(
    app: &App,
    list: &CandidateList,
    walk: &CurveWalk,
    area: Rect,
    buffer: &mut Buffer,
) {
    let area = Rect {
        x: area.x + 1,
        width: area.width.saturating_sub(2),
        ..area
    };
    let facts = facts(app, list, walk, area.width.into());
    let picture = print_facts(&facts, area, buffer);
    let figure = figure(list, walk);
    show_figure(app, &figure, &extents(list, walk), picture, buffer);
}

/// Returns the extents of the poses with a margin, including the picked dyad and the one under the
/// cursor.
fn extents(list: &CandidateList, walk: &CurveWalk) -> Extents {
    let (middle, size) = list.middle_and_size();
    let corner = Vec2::new(1.0, 1.0).scaled(NEAR * size);
    let dyads = list.walked().into_iter().chain(walk.picked());
    let mut positions = vec![middle - corner, middle + corner];
    positions.extend(dyads.flat_map(ends));
    Extents::of_places(&positions, &[])
}

/// Yields the dyad's pin, and its pivot if it has one.
fn ends(dyad: &PosedDyad) -> impl Iterator<Item = Vec2> {
    std::iter::once(dyad.pin).chain(dyad.held.pivot())
}

/// Draws the linkage of the two dyads if there is one, or else the dyads themselves, and the
/// curves.
fn figure(list: &CandidateList, walk: &CurveWalk) -> Figure {
    let mut figure = match list.shown() {
        Some(shown) => shown.figure(),
        None => {
            let (_, size) = list.middle_and_size();
            let mut figure = Figure::new();
            for (at, number) in list.posed_origins().into_iter().zip(1..) {
                let text = format!("T{number}");
                figure.add(Shape::Mark {
                    at,
                    role: Role::Rider,
                });
                figure.add(Shape::Label {
                    at,
                    text,
                    role: Role::Label,
                });
            }
            if let Some(picked) = walk.picked() {
                add_dyad(&mut figure, picked, Role::Link(0), size);
            }
            if let Some(walked) = list.walked() {
                add_dyad(&mut figure, walked, Role::Lit, size);
            }
            figure
        }
    };
    for course in list.curves() {
        let course = course.clone();
        let role = Role::Trace;
        figure.add(Shape::Trace { course, role });
    }
    figure
}

fn add_dyad(figure: &mut Figure, dyad: &PosedDyad, role: Role, size: f64) {
    match dyad.held {
        PinConstraint::Rocker(pivot) => {
            let (from, to) = (pivot, dyad.pin);
            figure.add(Shape::Line { from, to, role });
            figure.add(Shape::Support { at: pivot });
            figure.add(Shape::Mark {
                at: pivot,
                role: Role::GroundPin,
            });
        }
        PinConstraint::Slide(angle) => {
            let along = crate::angle::unit(angle);
            let half = along.scaled(GUIDE * size);
            let (from, to) = (dyad.pin - half, dyad.pin + half);
            figure.add(Shape::Guide {
                from,
                to,
                role: Role::Guide,
            });
            figure.add(Shape::Block {
                at: dyad.pin,
                along,
            });
        }
    }
    figure.add(Shape::Mark {
        at: dyad.pin,
        role: Role::Joint,
    });
}

fn facts(
    app: &App,
    list: &CandidateList,
    walk: &CurveWalk,
    width: usize,
) -> Vec<(String, ScreenPart)> {
    use ScreenPart::{Quiet, Text, Warning};
    let place = list.walked_place();
    let place = place
        .map(|[(dyad, dyads), (curve, curves)]| words().dyads_walked(dyad, dyads, curve, curves));
    let described = |dyad: Option<&PosedDyad>| dyad.and_then(|dyad| list.describe_dyad(dyad));
    let mut facts = vec![
        (place.unwrap_or_default(), Quiet),
        (described(list.walked()).unwrap_or_default(), Text),
    ];
    facts.push(match described(walk.picked()) {
        Some(picked) => (words().dyad_picked(&picked), Text),
        None => (words().pick_the_second().to_owned(), Quiet),
    });
    match list.chosen() {
        Some((_, row)) => {
            let transmission = words().transmission_on_the_way(&row.transmission);
            let is_good = row.reasons.is_empty();
            let figures = match is_good {
                true => format!("{}; {transmission}; {}", row.lengths, row.turns),
                false => row.lengths.clone(),
            };
            facts.push((figures, Text));
            facts.push((row.reasons.clone(), Warning));
            if !row.unmet.is_empty() {
                let missing = format!("{}: {}", words().head_lacks(), row.unmet);
                facts.push((missing, Warning));
            }
        }
        None if walk.picked().is_some() => {
            facts.push((words().dyads_make_nothing().to_owned(), Warning));
        }
        None => facts.push((words().dotted_curves().to_owned(), Quiet)),
    }
    let facts = facts.into_iter();
    in_lines(
        app,
        facts.map(|(text, part)| (text, part, usize::MAX)),
        width,
    )
}
