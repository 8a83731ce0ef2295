//! Writes the construction with compass and ruler, step by step, and the values read from it.

use super::super::context::{Context, Draft};
use super::super::equations::LoopSide;
use super::super::loops::group_unknowns::{ProblemForm, Stage};
use super::super::loops::polygon::{Loop, Term};
use super::super::loops::solution::Solution;
use super::drawing_scale::{DrawingSheet, read_off};
use super::{groups_with_unknowns, heading};
use crate::page::Symbol;
use crate::wording::words;
use crate::{Vec2, angle};

/// Writes the steps of a drawing on one sheet.
pub(super) fn construct(context: &Context<'_>, draft: &mut Draft) {
    if !context.has_positions() {
        draft.text(words().no_assembly_to_draw());
        return;
    }
    let sheet = DrawingSheet::of(context);
    draft.text(words().scale_of_sheet(&sheet.scale()));
    let drawing = Construction { context, sheet };
    drawing.given(draft);
    for stage in groups_with_unknowns(context) {
        draft.section(heading(context, stage));
        match Solution::new(context, stage) {
            Some(solution) => drawing.group(draft, stage, &solution),
            None => draft.text(words().not_by_compass(stage.unknowns.len())),
        }
    }
}

/// Maximum sine of the angle between lines that count as tangent.
const TANGENT_TOLERANCE: f64 = 1e-6;

struct Construction<'a> {
    context: &'a Context<'a>,
    sheet: DrawingSheet,
}

/// The two possible positions of a point on two lines.
struct TwoIntersections<'a> {
    name: &'a str,
    assembly: Vec2,
    other: Vec2,
    /// The sine of the angle between the lines.
    sine: f64,
}

/// A value read from the drawing: symbol, value, unit and uncertainty.
type Reading<'a> = (Symbol, f64, &'a str, f64);

impl Construction<'_> {
    /// Writes the points known at the start: those of the ground, and those placed by the driver.
    fn given(&self, draft: &mut Draft) {
        let mechanism = &self.context.scene.mechanism;
        let driver = self.context.solver.plan().groups.first();
        let ground = mechanism
            .point_ids()
            .filter(|&p| mechanism.point(p).ground.is_some());
        let driven = driver
            .into_iter()
            .flat_map(|group| group.points.iter().copied());
        let rows = ground.chain(driven).filter_map(|point| {
            // A centre of mass is not used in the drawing.
            let name = self.context.scene.point_name(point)?;
            if name.contains('.') {
                return None;
            }
            Some(self.place(name, self.context.state.position(point), String::new()))
        });
        let rows: Vec<[String; 6]> = rows.collect();
        draft.text(words().points_to_begin_with());
        self.places(draft, rows);
    }

    fn place(&self, name: &str, at: Vec2, which: String) -> [String; 6] {
        let f = self.context.figures;
        let size = at.norm();
        let [x, y] = [at.x, at.y].map(|v| f.format_or_zero(v, size));
        let [on_x, on_y] = [at.x, at.y].map(|v| self.sheet.length(v));
        [name.to_owned(), x, y, on_x, on_y, which]
    }

    fn places(&self, draft: &mut Draft, rows: Vec<[String; 6]>) {
        let unit = self.context.figures.unit;
        let [x, y] = ["x", "y"].map(|axis| format!("{axis} [{unit}]"));
        let [on_x, on_y] = ["x", "y"].map(|axis| words().on_paper(axis));
        let point = words().point();
        if rows.iter().all(|row| row[5].is_empty()) {
            let rows = rows.into_iter().map(|[a, b, c, d, e, _]| [a, b, c, d, e]);
            draft.table([point, &x, &y, &on_x, &on_y], rows.collect());
        } else {
            draft.table([point, &x, &y, &on_x, &on_y, words().which_it_is()], rows);
        }
    }

    fn group(&self, draft: &mut Draft, stage: &Stage, solution: &Solution<'_>) {
        match &stage.form {
            ProblemForm::Triangle(a, b) => self.two_circles(draft, solution, a, b),
            ProblemForm::Quadratic(arm, slide) => {
                self.circle_and_line(draft, solution, arm, *slide);
            }
            ProblemForm::Swing(arm, slide) => self.along_a_pin(draft, solution, arm, *slide),
            ProblemForm::Guides(a, b) => self.two_lines(draft, solution, *a, *b),
            ProblemForm::Nothing | ProblemForm::Sum(_) | ProblemForm::System => {
                draft.text(words().not_by_compass(stage.unknowns.len()));
            }
        }
    }

    /// Formats a length, in reality and on paper: `300 mm (60.0 mm)`.
    fn both(&self, length: f64) -> String {
        let f = self.context.figures;
        words().also_on_paper(&f.number(length), f.unit, &self.sheet.length(length))
    }

    /// Writes the intersection of two circles, each about the far end of an arm.
    fn two_circles(&self, draft: &mut Draft, solution: &Solution<'_>, a: &[Term], b: &[Term]) {
        let [first, second] = solution.in_order(a, b);
        let [p, x, q] = solution.joints(&first, &second);
        let (one, two) = (solution.arm(&first), solution.arm(&second));
        let Some([from, at]) = self.ends(solution.of, &first) else {
            return;
        };
        let m = -solution.known;
        for (centre, arm) in [(p, &one), (q, &two)] {
            let radius = self.both(arm.value);
            draft.text(words().draw_a_circle(centre, &arm.length, &radius));
        }
        let (along, across) = (
            (at - from).dot(m) / m.norm2(),
            (at - from).cross(m) / m.norm2(),
        );
        let mirrored = from + m * along + Vec2::new(-m.y, m.x) * across;
        let crossing = TwoIntersections {
            name: x,
            assembly: at,
            other: mirrored,
            sine: one.direction().cross(two.direction()),
        };
        let blur = self.cross(draft, &crossing);
        let turned = |arm: f64| (blur / arm).to_degrees();
        let [theta, other] = [&one, &two].map(|arm| arm.theta.clone());
        self.read(
            draft,
            [
                (theta, angle::wrapped(one.solved), "deg", turned(one.value)),
                (other, angle::wrapped(two.solved), "deg", turned(two.value)),
            ],
        );
    }

    /// Writes the intersection of a circle of the arm's radius with a line along the guide.
    fn circle_and_line(
        &self,
        draft: &mut Draft,
        solution: &Solution<'_>,
        arm: &[Term],
        slide: Term,
    ) {
        let [first, second] = solution.in_order(arm, &[slide]);
        let [p, x, q] = solution.joints(&first, &second);
        let is_arm_first = first != [slide];
        let own = solution.arm(arm);
        let member = solution.member(slide);
        let Some([from, at]) = self.ends(solution.of, &first) else {
            return;
        };
        let (pivot, through) = if is_arm_first { (p, q) } else { (q, p) };
        // Along the loop, the arm leads to the joint or away from it.
        let rod = own.direction() * own.value;
        let centre = if is_arm_first { from } else { at + rod };
        let theta = member.side.theta();
        let direction = self.context.figures.direction(member.reading.theta);
        draft.text(words().draw_a_line(through, &theta, &direction));
        let radius = self.both(own.value);
        draft.text(words().draw_a_circle(pivot, &own.length, &radius));
        let u = member.reading.u;
        let foot = at + u * u.dot(centre - at);
        let crossing = TwoIntersections {
            name: x,
            assembly: at,
            other: foot * 2.0 - at,
            sine: u.dot(own.direction()),
        };
        let blur = self.cross(draft, &crossing);
        let (name, unit) = (member.side.name.as_str().into(), self.context.figures.unit);
        let turned = (blur / own.value).to_degrees();
        self.read(
            draft,
            [
                (name, member.reading.r, unit, blur),
                (own.theta, angle::wrapped(own.solved), "deg", turned),
            ],
        );
    }

    /// Writes a line through a pin, or at a distance from it, for a link that rotates and slides.
    fn along_a_pin(&self, draft: &mut Draft, solution: &Solution<'_>, arm: &[Term], slide: Term) {
        let [own, _] = solution.in_order(arm, &[]);
        let Some((first, last)) = own.first().zip(own.last()) else {
            return;
        };
        let (p, q) = (
            self.context.polygon.ends(*first).0,
            self.context.polygon.ends(*last).1,
        );
        let member = solution.member(slide);
        let m = solution.known.norm();
        let [t, e] = solution.side_components(arm, slide, m);
        if e == 0.0 {
            draft.text(words().draw_through(p, q));
        } else {
            draft.text(words().draw_a_tangent(p, q, &self.both(e.abs())));
        }
        if t != 0.0 {
            let name = &member.side.name;
            draft.text(words().leave_out_beyond(name, &self.both(t.abs())));
        }
        let blur = self.sheet.blur(1.0);
        let (name, unit) = (member.side.name.as_str().into(), self.context.figures.unit);
        let theta = member.side.theta();
        self.read(
            draft,
            [
                (name, member.reading.r, unit, blur),
                (theta, member.reading.theta, "deg", (blur / m).to_degrees()),
            ],
        );
    }

    /// Writes the intersection of two lines along guides.
    fn two_lines(&self, draft: &mut Draft, solution: &Solution<'_>, a: Term, b: Term) {
        let [first, second] = solution.in_order(&[a], &[b]);
        let [p, x, q] = solution.joints(&first, &second);
        let sides = [a, b].map(|term| solution.member(term));
        let is_a_first = first == [a];
        let ends = if is_a_first { [p, q] } else { [q, p] };
        for (through, side) in ends.into_iter().zip(&sides) {
            let direction = self.context.figures.direction(side.reading.theta);
            draft.text(words().draw_a_line(through, &side.side.theta(), &direction));
        }
        let sine = sides[0].reading.u.cross(sides[1].reading.u);
        let blur = self.sheet.blur(sine);
        draft.text(words().lines_meet_in(x));
        let unit = self.context.figures.unit;
        let reading = |side: &LoopSide<'_>| side.reading.r;
        let name = |side: &LoopSide<'_>| Symbol::named(&side.side.name);
        self.read(
            draft,
            [
                (name(&sides[0]), reading(&sides[0]), unit, blur),
                (name(&sides[1]), reading(&sides[1]), unit, blur),
            ],
        );
    }

    /// Writes the intersections of two lines, and returns their uncertainty on the sheet.
    fn cross(&self, draft: &mut Draft, of: &TwoIntersections<'_>) -> f64 {
        let blur = self.sheet.blur(of.sine);
        if of.sine.abs() <= TANGENT_TOLERANCE {
            draft.text(words().they_touch_in(of.name));
            self.places(draft, vec![self.place(of.name, of.assembly, String::new())]);
            return f64::INFINITY;
        }
        draft.text(words().they_meet_in_two());
        let rows = vec![
            self.place(of.name, of.assembly, words().the_assembly().into()),
            self.place(
                &format!("{}'", of.name),
                of.other,
                words().the_other().into(),
            ),
        ];
        self.places(draft, rows);
        let degrees = of.sine.abs().min(1.0).asin().to_degrees();
        let [degrees, _] = read_off(degrees, 0.5);
        let [_, off] = read_off(0.0, blur);
        let (name, unit) = (of.name, self.context.figures.unit);
        draft.text(words().they_cross_at(&degrees, name, &off, unit));
        blur
    }

    /// Writes the unknowns, exact and as read from the drawing.
    fn read(&self, draft: &mut Draft, readings: [Reading<'_>; 2]) {
        draft.text(words().read_off_sheet());
        let f = self.context.figures;
        let rows = readings.into_iter().map(|(symbol, value, unit, blur)| {
            let exact = match unit {
                "deg" => f.direction(value),
                _ => f.number(value),
            };
            let [read, off] = read_off(value, blur);
            [symbol.to_string(), unit.to_owned(), read, off, exact]
        });
        let head = [
            words().sought_here(),
            "",
            words().as_read(),
            "+-",
            words().as_solved(),
        ];
        draft.table(head, rows.collect());
    }

    /// Returns the start and the end of an arm of a loop.
    fn ends(&self, of: &Loop, arm: &[Term]) -> Option<[Vec2; 2]> {
        let positions = self.nodes(of)?;
        let count = of.terms.len();
        let place = |term: &Term| of.terms.iter().position(|t| t == term);
        let start = positions[place(arm.first()?)?];
        let end = positions[(place(arm.last()?)? + 1) % count];
        Some([start, end])
    }

    /// Returns the start of each term of a loop, computed from a named point along the vectors;
    /// `None` without a named point.
    fn nodes(&self, of: &Loop) -> Option<Vec<Vec2>> {
        let (scene, count) = (self.context.scene, of.terms.len());
        let point = |term: &Term| {
            let name = self.context.polygon.ends(*term).0;
            let mut points = scene.mechanism.point_ids();
            points.find(|&point| scene.point_name(point) == Some(name))
        };
        let (first, point) = of
            .terms
            .iter()
            .enumerate()
            .find_map(|(i, term)| Some((i, point(term)?)))?;
        let mut at = self.context.state.position(point);
        let mut positions = vec![Vec2::ZERO; count];
        for step in 0..count {
            let index = (first + step) % count;
            positions[index] = at;
            let term = of.terms[index];
            let vector = self.context.readings[term.side].vector();
            at += if term.reversed { -vector } else { vector };
        }
        Some(positions)
    }
}
