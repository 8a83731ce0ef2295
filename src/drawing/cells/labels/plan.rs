//! Plans the sides of names over a whole motion.
//!
//! A name that only avoids what lies in its way would change sides whenever a bar turns past it.
//! The plan therefore looks ahead: at steps along the motion it draws everything else, and finds
//! what a name would hide there on each side of its point. A name then has one side for the whole
//! motion, or a second one over one part of it. So it changes sides at most twice per cycle.
//! Between two limits the motion runs there and back, and the name changes once each way. On its
//! side a name moves by a few cells where it would touch something. Its seat at each step is
//! planned, too, so that names do not displace each other. Where its side has no free seat, a name
//! is left out, long enough that it does not blink.

use super::{
    Align, LabelPlace, Labels, MAX_ROW, ON_BAR, PlacedName, SEATS, TOUCHING, cell_of, names,
    origin, points,
};
use crate::drawing::cells::raster::Raster;
use crate::drawing::cells::render::{Glyphs, render_bare};
use crate::drawing::figure::{Figure, Role};
use crate::drawing::view::WorldView;

/// Maximum number of names that are planned, and of shapes of a figure. Beyond them the plan would
/// take longer than a frame may.
const MAX_NAMES: usize = 40;
const MAX_SHAPES: usize = 600;

/// Cost of a step without the name: more than any seat costs.
const HIDDEN: i32 = 600;
/// Cost of a step on a side without a seat.
const NO_SEAT: i32 = 2 * HIDDEN;
/// Minimum number of steps over which a name is shown, and number of steps before and after those
/// without a seat over which it is left out.
const MIN_SHOWN: usize = 8;
const GAP_MARGIN: usize = 3;
/// Cost of a move on a side.
const MOVE: i32 = 40;
/// Cost of a change of sides.
const CHANGE: i32 = 300;
/// Cost of another seat than the one that is shown when the plan begins.
const OTHER_THAN_SHOWN: i32 = 400;
/// Cost that the planned seat saves: almost as much as the selected name touching something costs.
const PLANNED: i32 = TOUCHING - 50;
/// Number of times that each name is planned, with the other names in place.
const ROUNDS: usize = 3;

/// A side of a point, or no place at all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::drawing) enum Side {
    /// On this side: to the left, in the middle or to the right, and above, beside or below.
    At(i8, i8),
    Hidden,
}

/// All sides; the last one is no place.
const SIDES: [Side; 9] = [
    Side::At(1, -1),
    Side::At(-1, -1),
    Side::At(1, 0),
    Side::At(-1, 0),
    Side::At(0, -1),
    Side::At(1, 1),
    Side::At(-1, 1),
    Side::At(0, 1),
    Side::Hidden,
];

/// The position in `SIDES` of the side of each seat.
const SEAT_SIDES: [usize; SEATS.len()] = {
    let mut sides = [0; SEATS.len()];
    let mut seat = 0;
    while seat < SEATS.len() {
        let right = match SEATS[seat].align {
            Align::Start => 1,
            Align::Middle => 0,
            Align::End => -1,
        };
        let below = SEATS[seat].row.signum();
        while !matches!(SIDES[sides[seat]], Side::At(x, y) if x == right && y as i32 == below) {
            sides[seat] += 1;
        }
        seat += 1;
    }
    sides
};

impl Side {
    /// Returns the side of a place.
    #[cfg(test)]
    pub(super) fn of(place: LabelPlace) -> Side {
        match place {
            LabelPlace::Seat(seat) => Side::of_seat(seat),
            LabelPlace::New | LabelPlace::Hidden => Side::Hidden,
        }
    }

    fn of_seat(seat: usize) -> Side {
        SIDES[SEAT_SIDES[seat]]
    }
}

/// Returns the best place of a name on the side of its planned seat: this seat if it is free.
pub(super) fn best_place(raster: &Raster, name: &PlacedName, planned: Option<usize>) -> LabelPlace {
    let (col, row) = name.point;
    let Some(planned) = planned.filter(|_| raster.cell(col, row).is_some()) else {
        return LabelPlace::Hidden;
    };
    let seats = (0..SEATS.len()).filter(|seat| SEAT_SIDES[*seat] == SEAT_SIDES[planned]);
    let priced = seats.filter_map(|seat| {
        let gain = i32::from(planned == seat) * PLANNED;
        Some((name.cost(raster, seat)? - gain, seat))
    });
    let best = priced.min();
    best.map_or(LabelPlace::Hidden, |(_, seat)| LabelPlace::Seat(seat))
}

/// The places of names along the motion.
#[derive(Clone, Debug)]
pub(super) struct LabelPlan {
    view: WorldView,
    /// The share of the motion before the current place, from 0 to 1.
    share: f64,
    /// The seat of each name at each step; `None` where it is left out.
    names: Vec<Vec<Option<usize>>>,
}

/// A side for the whole motion, and another one from a step up to a later one, or beyond the end and
/// up to an earlier one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct PlannedSides {
    main: Side,
    other: Side,
    from: usize,
    to: usize,
}

impl PlannedSides {
    const HIDDEN: PlannedSides = PlannedSides {
        main: Side::Hidden,
        other: Side::Hidden,
        from: 0,
        to: 0,
    };

    fn side(&self, step: usize) -> Side {
        let is_other = if self.from <= self.to {
            (self.from..self.to).contains(&step)
        } else {
            !(self.to..self.from).contains(&step)
        };
        if is_other { self.other } else { self.main }
    }
}

impl Labels {
    /// Plans the sides of the names over the whole motion in a fixed window. `share` of the motion
    /// lies before its current place, where names keep their places if possible, and `figures` are
    /// those of even steps along the motion. Without a share and figures, or for very many names,
    /// there is no plan.
    pub fn plan(
        &mut self,
        is_closed: bool,
        share: Option<f64>,
        view: &WorldView,
        glyphs: Glyphs,
        figures: impl Iterator<Item = Figure>,
    ) {
        let share = share.unwrap_or(0.0);
        let names = self.planned_names(is_closed, share, view, glyphs, figures);
        self.plan = Some(LabelPlan {
            view: *view,
            share,
            names,
        });
    }

    /// Returns the plan of each name; empty if there are too many.
    fn planned_names(
        &self,
        is_closed: bool,
        share: f64,
        view: &WorldView,
        glyphs: Glyphs,
        figures: impl Iterator<Item = Figure>,
    ) -> Vec<Vec<Option<usize>>> {
        let mut figures = figures.peekable();
        let Some(first) = figures.peek() else {
            return Vec::new();
        };
        let count = own_names(first).count();
        if count == 0 || count > MAX_NAMES || first.shapes().len() > MAX_SHAPES {
            return Vec::new();
        }
        let mut raster = Raster::new();
        let mut names = vec![SeatCosts::default(); count];
        for figure in figures {
            render_bare(&figure, view, glyphs, &mut raster);
            let points = points(&figure, view);
            let mut known = own_names(&figure).map(|(at, text, role)| {
                PlacedName::new(cell_of(view.cell(at)), text, role, &points)
            });
            for name in &mut names {
                name.add(known.next(), &raster);
            }
        }
        let start = step_of(share, names[0].names.len());
        for (name, place) in names.iter_mut().zip(&self.places) {
            if let LabelPlace::Seat(shown) = *place {
                name.prefer(shown, start);
            }
        }
        let planning = Planning { closed: is_closed };
        let mut planned = vec![vec![None; names[0].names.len()]; count];
        for _ in 0..ROUNDS {
            for (name, costs) in names.iter().enumerate() {
                planned[name].fill(None);
                let taken = |step: usize| {
                    let others = names.iter().zip(&planned);
                    others.filter_map(move |(other, seats)| {
                        Some(span(other.names[step].as_ref()?, seats[step]?))
                    })
                };
                let sides = planning.best(&costs.with_others(taken));
                let mut seats = costs.seats(&sides, taken);
                avoid_blinking(&mut seats, is_closed);
                planned[name] = seats;
            }
        }
        planned
    }

    /// Drops the plan. Names then move only if their places become clearly worse.
    pub fn drop_plan(&mut self) {
        self.plan = None;
    }

    /// Returns `true` if the names are planned.
    #[must_use]
    pub fn is_planned(&self) -> bool {
        self.plan.is_some()
    }

    /// Sets the share of the motion at which the plan is read.
    pub fn go(&mut self, share: Option<f64>) {
        if let (Some(plan), Some(share)) = (&mut self.plan, share) {
            plan.share = share;
        }
    }

    /// Plans to leave a name out around the current step, because it has no place between two steps.
    pub(super) fn leave_out(&mut self, name: usize) {
        let Some(plan) = &mut self.plan else { return };
        if let Some(seats) = plan.names.get_mut(name) {
            let step = step_of(plan.share, seats.len());
            let last = (step + GAP_MARGIN + 1).min(seats.len());
            seats[step.saturating_sub(GAP_MARGIN)..last].fill(None);
        }
    }

    /// Returns the planned seat of a name, which may be none; `None` without a plan for this window.
    pub(super) fn planned(&self, name: usize, view: &WorldView) -> Option<Option<usize>> {
        let plan = self.plan.as_ref().filter(|plan| plan.view == *view)?;
        let seats = plan.names.get(name)?;
        Some(
            seats
                .get(step_of(plan.share, seats.len()))
                .copied()
                .flatten(),
        )
    }
}

/// Widens the gaps without a seat by `GAP_MARGIN`, and joins those with fewer steps than
/// `MIN_SHOWN` between them, so that the name does not blink.
fn avoid_blinking(seats: &mut [Option<usize>], is_closed: bool) {
    let gaps: Vec<bool> = seats.iter().map(Option::is_none).collect();
    let wide = spread(&gaps, MIN_SHOWN / 2 + GAP_MARGIN, is_closed);
    let shown: Vec<bool> = wide.iter().map(|is_gap| !is_gap).collect();
    let shown = spread(&shown, MIN_SHOWN / 2, is_closed);
    for (seat, _) in seats.iter_mut().zip(shown).filter(|(_, shown)| !shown) {
        *seat = None;
    }
}

/// Returns, for each step, whether one of those up to `by` steps before or after it is marked.
fn spread(marked: &[bool], by: usize, is_closed: bool) -> Vec<bool> {
    let count = marked.len();
    let is_near = |step: usize| {
        let near = (step..=step + 2 * by).map(|at| at + count);
        let mut near = near.filter_map(|at| match at.checked_sub(by)? {
            at if is_closed => Some(marked[at % count]),
            at => marked.get(at.checked_sub(count)?).copied(),
        });
        near.any(|is_marked| is_marked)
    };
    (0..count).map(is_near).collect()
}

/// Returns the names of a figure without the sizes of forces, which are placed last in each frame.
fn own_names(figure: &Figure) -> impl Iterator<Item = (crate::Vec2, &str, Role)> {
    names(figure).filter(|(_, _, role)| *role != Role::Force)
}

/// Returns the step, of this many, at a share of the motion.
fn step_of(share: f64, count: usize) -> usize {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "the share is between 0 and 1"
    )]
    let step = (share * count as f64) as usize;
    step.min(count.saturating_sub(1))
}

/// The place of a name at a step: its point's cell and its number of characters.
#[derive(Clone, Copy, Debug)]
struct NameAt {
    point: (i32, i32),
    width: i32,
}

/// A part of a row: the row, the first column, and the column after the last one.
type Span = (i32, i32, i32);

/// The costs of a name's seats at each step.
#[derive(Clone, Debug, Default)]
struct SeatCosts {
    /// The name at each step; `None` if it is outside the window.
    names: Vec<Option<NameAt>>,
    /// The cost of each seat at each step; `None` if the name cannot be there.
    costs: Vec<[Option<i32>; SEATS.len()]>,
}

/// The cost of each side at a step.
type SideCosts = [i32; SIDES.len()];

impl SeatCosts {
    /// Adds a step.
    fn add(&mut self, name: Option<PlacedName>, raster: &Raster) {
        let name = name.filter(|name| raster.cell(name.point.0, name.point.1).is_some());
        let mut costs = [None; SEATS.len()];
        if let Some(name) = &name {
            for (seat, cost) in costs.iter_mut().enumerate() {
                *cost = name.cost(raster, seat).map(|cost| cost.min(ON_BAR));
            }
        }
        self.costs.push(costs);
        self.names.push(name.map(|name| NameAt {
            point: name.point,
            width: name.width,
        }));
    }

    /// Makes other seats than this one more expensive at a step.
    fn prefer(&mut self, shown: usize, step: usize) {
        let costs = self.costs[step].iter_mut().enumerate();
        let others = costs.filter(|(seat, _)| *seat != shown);
        others
            .filter_map(|(_, cost)| cost.as_mut())
            .for_each(|cost| *cost += OTHER_THAN_SHOWN);
    }

    /// Returns the best seat of the name at each step of its plan, with these names at each step in
    /// place. A name moves on its side only if that saves more than a move costs.
    fn seats<S: Iterator<Item = Span>>(
        &self,
        plan: &PlannedSides,
        taken: impl Fn(usize) -> S,
    ) -> Vec<Option<usize>> {
        // The minimum cost up to a step with the name on each seat; the seats before, and whether
        // the name can be there.
        let mut sums = [0; SEATS.len()];
        let mut others: Vec<Span> = Vec::new();
        let before = self.names.iter().enumerate().map(|(step, name)| {
            others.clear();
            others.extend(taken(step));
            let side = plan.side(step);
            let best = position_of_min(&sums);
            let moved = sums[best] + MOVE;
            let mut before = [(best, false); SEATS.len()];
            for (seat, (sum, before)) in sums.iter_mut().zip(&mut before).enumerate() {
                if *sum <= moved {
                    before.0 = seat;
                }
                let cost = self.costs[step][seat].filter(|_| Side::of_seat(seat) == side);
                let is_free = |name| !others.iter().any(|other| touch(span(name, seat), *other));
                let cost = cost.filter(|_| name.as_ref().is_some_and(is_free));
                before.1 = cost.is_some();
                *sum = moved.min(*sum) + cost.unwrap_or(NO_SEAT);
            }
            before
        });
        let before: Vec<[(usize, bool); SEATS.len()]> = before.collect();
        let mut seat = position_of_min(&sums);
        let mut seats = vec![None; before.len()];
        for (place, before) in seats.iter_mut().zip(&before).rev() {
            let (last, is_possible) = before[seat];
            *place = is_possible.then_some(seat);
            seat = last;
        }
        seats
    }

    /// Returns the costs of each side over the motion, with these names at each step in place. A
    /// side is blocked already at the steps next to those at which it is, because frames lie between
    /// steps.
    fn with_others<S: Iterator<Item = Span>>(&self, taken: impl Fn(usize) -> S) -> Vec<SideCosts> {
        let mut others: Vec<Span> = Vec::new();
        let sides = (0..self.costs.len()).map(|step| {
            let Some(name) = &self.names[step] else {
                return [0; SIDES.len()];
            };
            let mut sides = [NO_SEAT; SIDES.len()];
            sides[SIDES.len() - 1] = HIDDEN;
            others.clear();
            others.extend(taken(step).filter(|other| (other.0 - name.point.1).abs() <= MAX_ROW));
            for (seat, cost) in self.costs[step].iter().enumerate() {
                let Some(cost) = cost else { continue };
                let own = span(name, seat);
                let is_taken = others.iter().any(|other| touch(own, *other));
                if !is_taken {
                    let side = &mut sides[SEAT_SIDES[seat]];
                    *side = (*cost).min(*side);
                }
            }
            sides
        });
        let sides: Vec<SideCosts> = sides.collect();
        let count = sides.len();
        let wide = (0..count).map(|step| {
            let near = [(step + count - 1) % count, (step + 1) % count];
            let mut wide = sides[step];
            for (side, cost) in wide[..SIDES.len() - 1].iter_mut().enumerate() {
                for near in near.iter().map(|at| sides[*at][side]) {
                    if near >= TOUCHING {
                        *cost = (*cost).max(near);
                    }
                }
            }
            wide
        });
        wide.collect()
    }
}

fn position_of_min(sums: &[i32; SEATS.len()]) -> usize {
    (0..SEATS.len()).min_by_key(|seat| sums[*seat]).unwrap_or(0)
}

/// Returns `true` if two names overlap or follow each other without a blank: `B` next to `C` would
/// read as one name.
fn touch(one: Span, other: Span) -> bool {
    one.0 == other.0 && one.1 <= other.2 && other.1 <= one.2
}

/// Returns the cells that a name takes on a seat.
fn span(name: &NameAt, seat: usize) -> Span {
    let (col, row) = origin(&SEATS[seat], name.point, name.width);
    (row, col, col + name.width)
}

/// The search for the best places of a name.
struct Planning {
    closed: bool,
}

impl Planning {
    /// Returns the best sides of a name.
    fn best(&self, costs: &[SideCosts]) -> PlannedSides {
        let hidden = PlannedSides::HIDDEN;
        let mut best = (i32::MAX, hidden);
        let mut offer = |cost: i32, name: PlannedSides| {
            if cost < best.0 {
                best = (cost, name);
            }
        };
        for (main, &side) in SIDES.iter().enumerate() {
            let total = costs.iter().map(|costs| costs[main]).sum::<i32>();
            offer(
                total,
                PlannedSides {
                    main: side,
                    other: side,
                    ..hidden
                },
            );
            for (other, &second) in SIDES.iter().enumerate().filter(|(other, _)| *other != main) {
                let gain = |step: usize| costs[step][other] - costs[step][main];
                let (gained, from, to) = self.best_part(costs.len(), gain);
                let changes = if self.closed { 2 } else { 1 };
                let name = PlannedSides {
                    main: side,
                    other: second,
                    from,
                    to,
                };
                offer(total + gained + changes * CHANGE, name);
            }
        }
        best.1
    }

    /// Returns the part of the motion with the smallest sum of `gain`, and the sum: from a step up
    /// to another one. In a closed motion the part may go on beyond the end; in another one it lies
    /// at the beginning or at the end.
    fn best_part(&self, count: usize, gain: impl Fn(usize) -> i32) -> (i32, usize, usize) {
        // The part with the smallest sum that ends here, and the one with the largest sum.
        let (mut low, mut high) = ((0, 0), (0, 0));
        let (mut minimum, mut maximum) = ((0, 0, 0), (0, 0, 0));
        let mut sum = 0;
        for step in 0..count {
            let gain = gain(step);
            sum += gain;
            if !self.closed {
                if sum < minimum.0 {
                    minimum = (sum, 0, step + 1);
                }
                if sum > maximum.0 {
                    maximum = (sum, 0, step + 1);
                }
                continue;
            }
            low = if low.0 < 0 {
                (low.0 + gain, low.1)
            } else {
                (gain, step)
            };
            high = if high.0 > 0 {
                (high.0 + gain, high.1)
            } else {
                (gain, step)
            };
            if low.0 < minimum.0 {
                minimum = (low.0, low.1, step + 1);
            }
            if high.0 > maximum.0 {
                maximum = (high.0, high.1, step + 1);
            }
        }
        // All but the part with the largest sum.
        let rest = (sum - maximum.0, maximum.2, maximum.1);
        if rest.0 < minimum.0 {
            let (sum, from, to) = rest;
            if self.closed {
                (sum, from % count, to)
            } else {
                (sum, from, count)
            }
        } else {
            minimum
        }
    }
}
