//! Writes the instant centres: their lines, their coordinates, and the velocities that follow from
//! them.

use super::centres::{
    CentreBasis, CentreLine, CentrePlace, LinkCentre, centres, coordinate, named, symbol,
};
use crate::page::Formula;
use crate::report::working::context::{Context, Draft};
use crate::report::working::expression::{Expression, Function};
use crate::report::working::figures::Figures;
use crate::report::working::symbols::{self, of_point, part_of_point};
use crate::wording::words;
use crate::{LinkId, PointId, Vec2, angle};

/// Writes the centre of every link: the construction of those that need one, then a table.
pub(crate) fn instant_centres(context: &Context<'_>, draft: &mut Draft) {
    let centres = centres(context);
    if centres.is_empty() {
        return;
    }
    draft.part(words().instant_centres());
    draft.text(words().instant_centre_is());
    let joints = joints(context);
    if !joints.is_empty() {
        draft.text(words().common_centres(&joints.join("; ")));
    }
    let mechanism = &context.scene.mechanism;
    let mut pivots = vec![None; mechanism.links().len()];
    for centre in &centres {
        if let CentreBasis::Pivot(pivot) = centre.basis {
            pivots[centre.link.index()] = Some(pivot);
        }
    }
    for centre in &centres {
        let text = CentreDescription {
            context,
            centre,
            figures: figures(context, centre),
            pivots: &pivots,
        };
        text.write(draft);
    }
    table(context, draft, &centres);
}

/// Lists every joint of two moving links, as in `r2, r3: B`.
fn joints(context: &Context<'_>) -> Vec<String> {
    let mechanism = &context.scene.mechanism;
    let points = mechanism.point_ids().filter_map(|point| {
        let links = &mechanism.point(point).links;
        let name = context.scene.point_name(point)?;
        let names: Vec<&str> = links.iter().map(|&l| context.scene.link_name(l)).collect();
        let is_joint = links.len() > 1 && mechanism.point(point).ground.is_none();
        is_joint.then(|| format!("{}: {name}", names.join(", ")))
    });
    points.collect()
}

/// Returns the figures with as many digits as are left after the division by an angular velocity:
/// near infinity there are few.
fn figures(context: &Context<'_>, centre: &LinkCentre) -> Figures {
    let left = (-centre.loss.log10()).floor().clamp(1.0, 17.0) as usize;
    Figures {
        digits: context.figures.digits.min(left),
        ..context.figures
    }
}

/// Writes the table of all centres.
fn table(context: &Context<'_>, draft: &mut Draft, centres: &[LinkCentre]) {
    let size = context.longest;
    let rows = centres.iter().map(|centre| {
        let f = figures(context, centre);
        let [x, y] = match centre.place {
            CentrePlace::At(at) => [f.format_or_zero(at.x, size), f.format_or_zero(at.y, size)],
            CentrePlace::Far(u) => {
                let at = context.figures.direction(angle::degrees(u));
                [words().at_infinity().to_owned(), format!("{at} deg")]
            }
            CentrePlace::Rest => ["-".to_owned(), "-".to_owned()],
        };
        [symbol(context, centre.link).to_string(), x, y]
    });
    let unit = context.figures.unit;
    let (x, y) = (format!("x [{unit}]"), format!("y [{unit}]"));
    draft.table([words().instant_centre(), &x, &y], rows.collect());
}

/// Returns the magnitude of a formula, between bars.
fn size_of(of: Formula) -> Formula {
    of.between(['|', '|'])
}

struct CentreDescription<'a> {
    context: &'a Context<'a>,
    centre: &'a LinkCentre,
    figures: Figures,
    /// The pivot on the ground of every link that has one.
    pivots: &'a [Option<PointId>],
}

impl CentreDescription<'_> {
    fn link_name(&self) -> &str {
        self.context.scene.link_name(self.centre.link)
    }

    fn point_name(&self, point: PointId) -> &str {
        self.context.scene.point_name(point).unwrap_or_default()
    }

    fn write(&self, draft: &mut Draft) {
        // For a link about a pivot, the part on points has everything.
        if matches!(self.centre.basis, CentreBasis::Pivot(_)) {
            return;
        }
        let name = symbol(self.context, self.centre.link).to_string();
        draft.section(words().centre_of_link(&name, self.link_name()));
        match (self.centre.place, &self.centre.basis) {
            (CentrePlace::Rest, _) => draft.text(words().link_is_at_rest(self.link_name())),
            (CentrePlace::Far(u), basis) => self.far(draft, u, basis),
            (CentrePlace::At(at), CentreBasis::Lines(lines)) => self.crossing(draft, at, lines),
            (CentrePlace::At(at), CentreBasis::Velocity(base)) => self.moved(draft, at, *base),
            (CentrePlace::At(_), CentreBasis::Pivot(_) | CentreBasis::Guided) => {}
        }
    }

    /// Writes a centre at infinity: all points of the link have the same velocity.
    fn far(&self, draft: &mut Draft, u: Vec2, basis: &CentreBasis) {
        let name = self.link_name();
        let direction = self.context.figures.direction(angle::degrees(u));
        let is_guided = *basis == CentreBasis::Guided;
        draft.text(match is_guided {
            true => words().centre_of_guided(name, &direction),
            false => words().centre_far(name, &direction),
        });
        if !is_guided {
            return;
        }
        // The other named points move as the first one does.
        let state = self.context.state;
        let mut points = named(self.context, self.centre.link);
        let Some(first) = points.next() else { return };
        let v = state.velocity(first);
        for point in points {
            let other = state.velocity(point);
            let symbol = of_point("v", self.point_name(point));
            draft.agree(symbol, (v - other).norm(), 0.0, self.context.fastest[0]);
        }
    }

    /// Describes a line, as in `the line through A and B`.
    fn line(&self, line: &CentreLine) -> String {
        let joint = self.point_name(line.joint);
        match line.through {
            Some((link, _)) => words().line_through(&self.centre_name(link), joint),
            None => words().line_across(joint),
        }
    }

    /// Returns the pivot's name, or the centre's symbol.
    fn centre_name(&self, link: LinkId) -> String {
        match self.pivots[link.index()] {
            Some(pivot) => self.point_name(pivot).to_owned(),
            None => symbol(self.context, link).to_string(),
        }
    }

    /// Returns a coordinate of a joint.
    fn coordinate(&self, axis: &str, point: PointId) -> Expression {
        let at = self.context.state.position(point);
        let value = if axis == "x" { at.x } else { at.y };
        let figure = self
            .context
            .figures
            .format_or_zero(value, self.context.longest);
        Expression::known(coordinate(self.context, axis, point), figure, value)
    }

    /// Writes the intersection of two lines, and the angular velocity that follows.
    fn crossing(&self, draft: &mut Draft, solved: Vec2, lines: &[CentreLine; 2]) {
        let (f, context) = (self.figures, self.context);
        let name = symbol(context, self.centre.link).to_string();
        let [one, other] = lines.each_ref().map(|line| self.line(line));
        draft.text(words().on_two_lines(&name, &one, &other));
        self.write_uncertainty(draft);
        let [p, q] = lines.map(|line| line.joint);
        let [beta, gamma] = [("β", &lines[0]), ("γ", &lines[1])].map(|(symbol, line)| {
            let figure = context.figures.direction(line.degrees());
            let degrees = Formula::measured(&figure, "deg");
            draft.equation([symbol.into(), degrees]);
            Expression::known(symbol, figure, line.degrees())
        });
        let of = |function, angle: &Expression| Expression::of(function, [angle.clone()]);
        let distance = |axis| self.coordinate(axis, q) - self.coordinate(axis, p);
        let above =
            distance("x") * of(Function::Sin, &gamma) - distance("y") * of(Function::Cos, &gamma);
        let t = above / of(Function::Sin, &(gamma.clone() - beta.clone()));
        let size = self.context.longest;
        let t = draft.worked("t", &t, |t| f.length_or_zero(t, size));
        let known = || f.rounded("t", t, size);
        let at = [("x", Function::Cos), ("y", Function::Sin)].map(|(axis, function)| {
            let sum = self.coordinate(axis, p) + known() * of(function, &beta);
            draft.worked(axis, &sum, |v| f.length_or_zero(v, size))
        });
        let sine = lines[0].u.cross(lines[1].u).abs();
        let loss = 1.0 / sine + self.centre.loss / f64::EPSILON;
        let far = size + t.abs();
        let computed = Vec2::new(at[0], at[1]);
        // The solver's centre follows from the velocity of the joint.
        let w = context.state.omega(self.centre.link);
        let by_velocity = context.state.position(p) + context.state.velocity(p).perp() / w;
        draft.agree(&name, (computed - by_velocity).norm(), 0.0, far * loss);
        self.turning(draft, p, (t, far * loss));
        self.speeds(draft, solved, far * loss, p);
    }

    /// Writes |ω| = v/t.
    fn turning(&self, draft: &mut Draft, joint: PointId, (t, loss): (f64, f64)) {
        let (f, state) = (self.figures, self.context.state);
        let (v, w) = (state.velocity(joint).norm(), state.omega(self.centre.link));
        let speed = of_point("v", self.point_name(joint));
        let figure = self
            .context
            .figures
            .format_or_zero(v, self.context.fastest[0]);
        let quotient =
            Expression::known(speed, figure, v) / f.computed(size_of("t".into()), t.abs());
        let symbol = size_of(symbols::omega(self.link_name()).into());
        let rate = |w| Formula::measured(f.number(w), "rad/s");
        let computed = draft.worked(symbol.clone(), &quotient, rate);
        let size = w.abs() * loss / t.abs() + self.context.fastest[0] / t.abs();
        draft.agree(symbol, computed, w.abs(), size);
    }

    /// Writes the centre from the velocity of one point, if no two lines are known.
    fn moved(&self, draft: &mut Draft, at: Vec2, base: PointId) {
        let (f, context) = (self.figures, self.context);
        let (name, point) = (symbol(context, self.centre.link), self.point_name(base));
        let omega = symbols::omega(self.link_name());
        draft.text(words().centre_by_velocity(&name, point, &omega));
        self.write_uncertainty(draft);
        let (v, w) = (
            context.state.velocity(base),
            context.state.omega(self.centre.link),
        );
        let w = context.figures.computed(omega, w);
        let part = |axis: &str, value: f64| {
            let figure = context.figures.format_or_zero(value, context.fastest[0]);
            Expression::known(part_of_point("v", point, axis), figure, value)
        };
        let x = self.coordinate("x", base) - part("y", v.y) / w.clone();
        let y = self.coordinate("y", base) + part("x", v.x) / w;
        let size = self.context.longest;
        for (symbol, sum) in [("x", x), ("y", y)] {
            draft.worked(symbol, &sum, |v| f.length_or_zero(v, size));
        }
        let far = size + (at - context.state.position(base)).norm();
        let loss = 1.0 + self.centre.loss / f64::EPSILON;
        self.speeds(draft, at, far * loss, base);
    }

    fn write_uncertainty(&self, draft: &mut Draft) {
        if self.figures.digits < self.context.figures.digits {
            let digits = self.figures.digits;
            draft.text(words().centre_is_blurred(self.link_name(), digits));
        }
    }

    /// Writes the velocities of the link's other points from their distances to the centre.
    fn speeds(&self, draft: &mut Draft, at: Vec2, loss: f64, text: PointId) {
        let (f, state) = (self.figures, self.context.state);
        let w = state.omega(self.centre.link);
        let name = symbol(self.context, self.centre.link);
        let unit = f.length_unit(1);
        let size = self.context.longest;
        for point in named(self.context, self.centre.link).filter(|&point| point != text) {
            let point_name = self.point_name(point);
            let distance = (state.position(point) - at).norm();
            let omega = size_of(symbols::omega(self.link_name()).into());
            let between = Expression::symbol(point_name) - Expression::symbol(name.clone());
            let arm = f.rounded(size_of(between.symbols()), distance, size);
            let turning = f.computed(omega, w.abs());
            let v = state.velocity(point);
            let fast = self.context.fastest[0];
            let symbol = of_point("v", point_name);
            let speed = |v| Formula::measured(f.format_or_zero(v, fast), &unit);
            let computed = draft.worked(symbol.clone(), &(turning * arm), speed);
            draft.agree(symbol, computed, v.norm(), w.abs() * loss + fast);
        }
    }
}
