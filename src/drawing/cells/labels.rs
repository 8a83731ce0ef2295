//! Places names next to their points, clear of everything else.

mod plan;

use super::raster::{CharCell, Raster};
use super::symbol::cell_of;
use crate::Vec2;
use crate::drawing::figure::{Figure, Role, Shape};
use crate::drawing::view::WorldView;
use plan::LabelPlan;
#[cfg(test)]
pub(in crate::drawing) use plan::Side;

/// The places of a figure's labels in the last frame; keep it from frame to frame.
///
/// Without a plan, a label moves when its place becomes clearly worse than another one. With a plan
/// for the whole motion, see [`Labels::plan`], it changes sides at most twice per cycle.
#[derive(Clone, Debug, Default)]
pub struct Labels {
    places: Vec<LabelPlace>,
    /// The size of the window in which they were placed.
    size: (u16, u16),
    plan: Option<LabelPlan>,
}

/// The result of placing a label.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum LabelPlace {
    /// Not placed yet.
    New,
    /// Left out for lack of space.
    Hidden,
    /// Placed on the seat with this index in `SEATS`.
    Seat(usize),
}

/// A place for a label, relative to its point.
struct LabelSeat {
    /// Offset from the point's cell to the label's near end, or its middle for `Align::Middle`.
    col: i32,
    row: i32,
    align: Align,
    /// The seat's own cost, without the cost of the cells that a label hides.
    cost: i32,
}

enum Align {
    /// The label begins here.
    Start,
    /// The label is centred here.
    Middle,
    /// The label ends here.
    End,
}

const fn seat(col: i32, row: i32, align: Align, cost: i32) -> LabelSeat {
    LabelSeat {
        col,
        row,
        align,
        cost,
    }
}

/// Number of seats next to a point or one column farther. The seats after them are for names only:
/// a name is recognized by its point, and must not cover a bar.
const NEAR: usize = 14;

/// The seats: above right first, as readers look there first; then the sides, then below; the outer
/// ring if the inner one is full.
const SEATS: [LabelSeat; 40] = [
    seat(1, -1, Align::Start, 0),
    seat(-1, -1, Align::End, 1),
    seat(2, 0, Align::Start, 1),
    seat(-2, 0, Align::End, 2),
    seat(0, -1, Align::Middle, 2),
    seat(1, 1, Align::Start, 2),
    seat(-1, 1, Align::End, 2),
    seat(0, 1, Align::Middle, 3),
    seat(3, -1, Align::Start, 5),
    seat(-3, -1, Align::End, 5),
    seat(3, 1, Align::Start, 6),
    seat(-3, 1, Align::End, 6),
    seat(3, 0, Align::Start, 5),
    seat(-3, 0, Align::End, 5),
    seat(1, -2, Align::Start, 6),
    seat(-1, -2, Align::End, 7),
    seat(0, -2, Align::Middle, 6),
    seat(1, 2, Align::Start, 7),
    seat(-1, 2, Align::End, 7),
    seat(0, 2, Align::Middle, 7),
    seat(5, 0, Align::Start, 8),
    seat(-5, 0, Align::End, 8),
    seat(2, -1, Align::Start, 2),
    seat(-2, -1, Align::End, 3),
    seat(2, 1, Align::Start, 4),
    seat(-2, 1, Align::End, 4),
    seat(2, -2, Align::Start, 7),
    seat(-2, -2, Align::End, 8),
    seat(2, 2, Align::Start, 8),
    seat(-2, 2, Align::End, 8),
    seat(4, 0, Align::Start, 7),
    seat(-4, 0, Align::End, 7),
    seat(4, -1, Align::Start, 7),
    seat(-4, -1, Align::End, 7),
    seat(4, 1, Align::Start, 8),
    seat(-4, 1, Align::End, 8),
    seat(3, -2, Align::Start, 9),
    seat(-3, -2, Align::End, 9),
    seat(3, 2, Align::Start, 9),
    seat(-3, 2, Align::End, 9),
];

/// Number of seats that are tried first without a plan.
const USUAL: usize = 22;
/// Largest distance of a seat from its point in rows, and in columns.
const MAX_ROW: i32 = 2;
const MAX_COL: i32 = 5;

/// Cost per character that hides part of the ground, of a guide or of a plate: as much as any free
/// seat.
const OVER_GROUND: i32 = 9;
/// Cost of the selected name directly before or after a bar, a mark or an arrow. Other names never
/// touch one.
const TOUCHING: i32 = 200;
/// Cost per character of the selected name that hides part of a bar or an arrow.
const ON_BAR: i32 = 500;
/// Maximum cost if the names together are longer than the lines: only names in free space help
/// then.
const MAX_COST_CROWDED: i32 = 3;
/// Cost of a name that is nearer to another point than to its own.
const AMBIGUOUS: i32 = 12;
/// Ratio of the squares of both distances from which a reader would assign a name to the other point.
const MISLEADING: f64 = 2.3;
/// Minimum gain in cost for which a label moves.
const INERTIA: i32 = 6;

impl Labels {
    /// Draws the labels of a figure over a raster that holds everything else.
    pub(in crate::drawing) fn place(
        &mut self,
        figure: &Figure,
        view: &WorldView,
        raster: &mut Raster,
    ) {
        let size = (raster.cols(), raster.rows());
        if std::mem::replace(&mut self.size, size) != size {
            self.places.clear();
        }
        let labels = names(figure);
        // Sizes of forces are placed last and never displace a name.
        let own = labels.clone().filter(|(_, _, role)| *role != Role::Force);
        let length: usize = own.map(|(_, text, _)| text.len()).sum();
        let is_line = |cell: &&CharCell| cell.role.is_body();
        let lines = raster.lines().flatten().filter(is_line).count();
        let is_crowded = length > lines;
        let points = points(figure, view);
        let mut count = 0;
        for (at, text, role) in labels {
            let name = PlacedName::new(cell_of(view.cell(at)), text, role, &points);
            if count == self.places.len() {
                self.places.push(LabelPlace::New);
            }
            let limit = match is_crowded && !name.is_selected {
                true => MAX_COST_CROWDED,
                false => i32::MAX,
            };
            let place = match self.planned(count, view) {
                Some(seat) => {
                    let place = plan::best_place(raster, &name, seat);
                    if seat.is_some() && place == LabelPlace::Hidden {
                        self.leave_out(count);
                    }
                    place
                }
                None => {
                    let last = self.places[count];
                    best_place(raster, &name, last, limit)
                }
            };
            self.places[count] = place;
            count += 1;
            if let LabelPlace::Seat(seat) = place {
                let (col, row) = origin(&SEATS[seat], name.point, name.width);
                write(raster, col, row, text, role);
            }
        }
        self.places.truncate(count);
    }
}

impl Labels {
    /// Returns the placed names of a figure, their points, and the column and row offsets of their
    /// first characters from the point's cell.
    pub(in crate::drawing) fn placed_names<'f>(
        &self,
        figure: &'f Figure,
        view: &WorldView,
    ) -> impl Iterator<Item = (&'f str, Vec2, i32, i32)> {
        let placed = names(figure).zip(&self.places);
        placed.filter_map(move |((at, text, _), place)| match *place {
            LabelPlace::Seat(seat) => {
                let point = cell_of(view.cell(at));
                let (col, row) = origin(&SEATS[seat], point, width(text));
                Some((text, at, col - point.0, row - point.1))
            }
            LabelPlace::New | LabelPlace::Hidden => None,
        })
    }
}

/// Returns the labels of a figure: their points, texts and roles.
fn names(figure: &Figure) -> impl Iterator<Item = (Vec2, &str, Role)> + Clone {
    figure.shapes().iter().filter_map(|shape| match shape {
        Shape::Label { at, text, role } => Some((*at, text.as_str(), *role)),
        _ => None,
    })
}

/// Writes a name, with a blank before and after it on hatching.
fn write(raster: &mut Raster, col: i32, row: i32, text: &str, role: Role) {
    let mut end = col;
    for glyph in text.chars() {
        raster.set_cell(end, row, glyph, role);
        end += 1;
    }
    for nearby in [col - 1, end] {
        if raster
            .cell(nearby, row)
            .is_some_and(|c| c.role == Role::Ground)
        {
            raster.set_cell(nearby, row, CharCell::EMPTY.glyph, Role::Empty);
        }
    }
}

/// Returns the cells of all points that have a mark or a name, from left to right, each once.
fn points(figure: &Figure, view: &WorldView) -> Vec<(i32, i32)> {
    let points = figure.shapes().iter().filter_map(|shape| match shape {
        Shape::Mark { at, .. } => Some(*at),
        Shape::Label {
            at,
            role: Role::Label,
            ..
        } => Some(*at),
        _ => None,
    });
    let mut cells: Vec<(i32, i32)> = points.map(|at| cell_of(view.cell(at))).collect();
    cells.sort_unstable();
    cells.dedup();
    cells
}

/// A name to place, with its point.
struct PlacedName {
    point: (i32, i32),
    width: i32,
    is_selected: bool,
    /// The cells of other points near this one, to which a reader might assign the name.
    others: Vec<(i32, i32)>,
}

impl PlacedName {
    /// Creates the name of the point in a cell, among the cells of all points from left to right.
    fn new(point: (i32, i32), text: &str, role: Role, points: &[(i32, i32)]) -> PlacedName {
        let width = width(text);
        let reach = width + 2 * MAX_COL;
        let [first, last] = [point.0 - reach, point.0 + reach + 1];
        let [first, last] = [first, last].map(|col| points.partition_point(|p| p.0 < col));
        let is_near = |other: &&(i32, i32)| {
            let (cols, rows) = ((other.0 - point.0).abs(), (other.1 - point.1).abs());
            // Points in adjacent cells of a row coincide, such as a pin and its block.
            let coincide = cols <= 1 && rows == 0;
            rows <= 2 * MAX_ROW && !coincide
        };
        // Names of links stand next to bars, and the selected name is always shown.
        let others = match role {
            Role::Label => points[first..last]
                .iter()
                .filter(is_near)
                .copied()
                .collect(),
            _ => Vec::new(),
        };
        PlacedName {
            point,
            width,
            is_selected: role == Role::Lit,
            others,
        }
    }

    /// Returns the cost of a seat; `None` if the name cannot be there, or would be clearly nearer to
    /// another point than to its own.
    fn cost(&self, raster: &Raster, seat: usize) -> Option<i32> {
        let (col, row) = origin(&SEATS[seat], self.point, self.width);
        // Squares of distances in columns; a row is as high as two columns.
        let distance = |point: &(i32, i32)| {
            let cols = (col - point.0).max(point.0 - (col + self.width - 1)).max(0);
            let rows = 2 * (row - point.1);
            cols * cols + rows * rows
        };
        let own = distance(&self.point);
        let ambiguity = match self.others.iter().map(distance).min() {
            Some(other) if MISLEADING * f64::from(other) < f64::from(own) => return None,
            Some(other) if other < own => AMBIGUOUS,
            _ => 0,
        };
        let cover = cover(raster, col, row, self.width, self.is_selected)?;
        Some(cover + SEATS[seat].cost + ambiguity)
    }
}

fn best_place(raster: &Raster, name: &PlacedName, last: LabelPlace, limit: i32) -> LabelPlace {
    if raster.cell(name.point.0, name.point.1).is_none() {
        return LabelPlace::Hidden;
    }
    // A hidden label returns only when there is clearly space for it, so that it does not flicker.
    let limit = if last == LabelPlace::Hidden {
        (limit - INERTIA).max(0)
    } else {
        limit
    };
    let priced = |seat: usize| {
        let inertia = i32::from(last == LabelPlace::Seat(seat)) * INERTIA;
        let cost = name.cost(raster, seat)? - inertia;
        (cost <= limit).then_some((cost, seat))
    };
    let usual = (0..USUAL).filter_map(priced).min();
    let best = usual.or_else(|| (USUAL..SEATS.len()).filter_map(priced).min());
    best.map_or(LabelPlace::Hidden, |(_, seat)| LabelPlace::Seat(seat))
}

/// Returns the first cells of all places next to a cell where a text hides nothing, best place
/// first.
pub(in crate::drawing) fn free_places(
    raster: &Raster,
    point: (i32, i32),
    text: &str,
) -> Vec<(i32, i32)> {
    let width = width(text);
    let free = |seat: &&LabelSeat| {
        let (col, row) = origin(seat, point, width);
        cover(raster, col, row, width, false) == Some(0)
    };
    let mut seats: Vec<&LabelSeat> = SEATS[..NEAR].iter().filter(free).collect();
    seats.sort_by_key(|seat| seat.cost);
    let origins = seats.iter().map(|seat| origin(seat, point, width));
    origins.collect()
}

/// Returns the number of characters, limited to the maximum number of columns of a raster.
fn width(text: &str) -> i32 {
    text.chars().count().min(usize::from(u16::MAX)) as i32
}

/// Returns the cell of the first character of a label of this width.
fn origin(seat: &LabelSeat, point: (i32, i32), width: i32) -> (i32, i32) {
    let back = match seat.align {
        Align::Start => 0,
        Align::Middle => width / 2,
        Align::End => width - 1,
    };
    (point.0 + seat.col - back, point.1 + seat.row)
}

/// Returns the cost of the cells that a label hides at a place. Returns `None` if it cannot be there:
/// outside the raster, on a mark or another name, or touching a bar or an arrow. The selected name
/// may touch both.
fn cover(raster: &Raster, col: i32, row: i32, width: i32, is_selected: bool) -> Option<i32> {
    let if_selected = |cost| is_selected.then_some(cost);
    let end = col + width;
    let mut sum = 0;
    for c in col..end {
        sum += match raster.cell(c, row)?.role {
            // Free, so that names do not move when ghosts and traces appear or disappear.
            Role::Empty | Role::Ghost | Role::Echo | Role::Trace | Role::Trail => 0,
            Role::Ground | Role::Guide | Role::Plate(_) | Role::DriverPlate => OVER_GROUND,
            Role::Spring | Role::Velocity | Role::Acceleration => if_selected(ON_BAR)?,
            role if role.is_body() => if_selected(ON_BAR)?,
            // Marks and other names. A size over part of another force would be read as the size
            // of both.
            _ => return None,
        };
    }
    for c in [col - 1, end] {
        let role = raster.cell(c, row).map_or(Role::Empty, |cell| cell.role);
        sum += match role {
            Role::Empty => 0,
            role if role.is_behind() && role != Role::Spring => 0,
            role if role.is_body() || role.is_mark() => if_selected(TOUCHING)?,
            Role::Spring | Role::Velocity | Role::Acceleration | Role::Force => {
                if_selected(TOUCHING)?
            }
            // `B` next to `C` would read as one name.
            _ => return None,
        };
    }
    Some(sum)
}

#[cfg(test)]
impl Labels {
    /// Returns the side of each label.
    pub(in crate::drawing) fn sides(&self) -> impl Iterator<Item = Side> {
        self.places.iter().map(|place| Side::of(*place))
    }

    /// Returns the number of labels left out.
    pub(in crate::drawing) fn hidden(&self) -> usize {
        self.places
            .iter()
            .filter(|&&p| p == LabelPlace::Hidden)
            .count()
    }

    pub(in crate::drawing) fn len(&self) -> usize {
        self.places.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::{Extents, Glyphs, render, render_into};
    use proptest::prelude::*;

    const MARKS: [Role; 3] = [Role::Joint, Role::GroundPin, Role::Slider];

    fn mark(at: Vec2) -> Shape {
        let role = Role::Joint;
        Shape::Mark { at, role }
    }

    fn label(at: Vec2, text: &str) -> Shape {
        let (text, role) = (text.to_owned(), Role::Label);
        Shape::Label { at, text, role }
    }

    fn view() -> WorldView {
        let corners = [Vec2::ZERO, Vec2::new(30.0, 10.0)];
        WorldView::fit(&Extents::of_places(&corners, &[]), 40, 12, 2.0)
    }

    fn count(raster: &Raster, role: Role) -> usize {
        let cells = raster.lines().flatten();
        cells.filter(|cell| cell.role == role).count()
    }

    proptest! {
        #[test]
        fn labels_hide_no_joint_and_no_other_label(
            points in prop::collection::vec((0.0..30.0, 0.0..10.0), 1..20),
        ) {
            let mut figure = Figure::new();
            let positions: Vec<_> = points.iter().map(|&(x, y)| Vec2::new(x, y)).collect();
            positions.iter().for_each(|&at| figure.add(mark(at)));
            let plain = render(&figure, &view(), Glyphs::Ascii);
            let mut named = 0;
            for &at in &positions {
                let before = count(&render(&figure, &view(), Glyphs::Ascii), Role::Label);
                figure.add(label(at, "Q7"));
                let raster = render(&figure, &view(), Glyphs::Ascii);
                let added = count(&raster, Role::Label) - before;
                prop_assert!(added == 0 || added == 2, "a name is whole or absent");
                named += added;
                for role in MARKS {
                    prop_assert_eq!(count(&raster, role), count(&plain, role));
                }
            }
            prop_assert!(named >= 2, "the first finds a place");
        }
    }

    #[test]
    fn label_is_placed_off_its_line() {
        let mut figure = Figure::new();
        let (from, to, role) = (Vec2::new(15.0, 5.0), Vec2::new(30.0, 10.0), Role::Link(0));
        figure.add(Shape::Line { from, to, role });
        figure.add(mark(from));
        let plain = count(&render(&figure, &view(), Glyphs::Ascii), Role::Link(0));
        figure.add(label(from, "name"));
        let raster = render(&figure, &view(), Glyphs::Ascii);
        assert_eq!(count(&raster, Role::Link(0)), plain);
        assert_eq!(count(&raster, Role::Label), 4);
    }

    /// Regression: a label changed sides in every frame while a line turned through its place.
    #[test]
    fn label_keeps_its_side_without_clear_gain() {
        let (from, role) = (Vec2::new(15.0, 5.0), Role::Link(0));
        let seats = |labels: &mut Labels| {
            let mut seats = Vec::new();
            let mut raster = Raster::new();
            for k in 0..200 {
                let swing = 60.0 + 8.0 * f64::from(k).sin();
                let to = from + crate::angle::unit(swing) * 9.0;
                let mut figure = Figure::new();
                figure.add(Shape::Line { from, to, role });
                figure.add(mark(from));
                figure.add(label(from, "P"));
                render_into(&figure, &view(), Glyphs::Ascii, labels, &mut raster);
                seats.push(labels.places[0]);
            }
            seats
        };
        let kept = seats(&mut Labels::default());
        assert!(kept.windows(2).filter(|w| w[0] != w[1]).count() <= 1);
    }

    #[test]
    fn label_that_fits_nowhere_is_left_out() {
        let mut figure = Figure::new();
        figure.add(label(Vec2::new(15.0, 5.0), &"n".repeat(100)));
        assert_eq!(
            count(&render(&figure, &view(), Glyphs::Ascii), Role::Label),
            0
        );
    }
}
