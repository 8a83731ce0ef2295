//! Positions: the loop equations in components and projected, and each group's solution by the formula of
//! its form, with every figure on the way.

use super::equations::{Axis, Heading, Member, Piece, in_figures, in_symbols, known};
use super::figures::{Figures, Sum, factor};
use super::opening::sum_text;
use super::page::{Context, Page};
use super::polygon::{Loop, Term};
use super::sides::{Shape, Side, Turns};
use super::stages::{Form, Stage};
use crate::solver::Order;
use crate::{Vec2, angle};

/// The equations of every loop.
pub(super) fn equations(context: &Context<'_>, page: &mut Page) {
    if context.polygon.loops.is_empty() {
        return;
    }
    page.document.part("Loop equations");
    for stage in context.stages {
        for &number in &stage.loops {
            let of = &context.polygon.loops[number];
            loop_heading(context, page, number, of);
            let members = context.members(of, stage);
            for axis in [Axis::X, Axis::Y] {
                let pieces = pieces(&members, &axis, context.figures);
                page.document.equation([in_symbols(&pieces), "0".into()]);
            }
            for axis in [Axis::X, Axis::Y] {
                let pieces = pieces(&members, &axis, context.figures);
                let figures = in_figures(&pieces, context.figures);
                page.document.equation([figures, "0".into()]);
            }
            projected(context, page, stage, &members);
        }
    }
}

pub(super) fn loop_heading(context: &Context<'_>, page: &mut Page, number: usize, of: &Loop) {
    let sum = sum_text(context, of);
    if context.polygon.loops.len() > 1 {
        page.document
            .section(format!("Loop {}: {sum} = 0", number + 1));
    }
}

fn pieces(members: &[Member<'_>], axis: &Axis, figures: Figures) -> Vec<Piece> {
    let of = |member: &Member<'_>| member.pieces(Order::Position, axis, figures);
    members.iter().flat_map(of).collect()
}

/// The equations multiplied by unit vectors that remove a side each.
fn projected(context: &Context<'_>, page: &mut Page, stage: &Stage, members: &[Member<'_>]) {
    let removed: Vec<Term> = match &stage.form {
        Form::Triangle(a, b) => [a, b].into_iter().filter_map(|arm| single(arm)).collect(),
        Form::Quadratic(_, slide) => vec![*slide],
        Form::Guides(a, b) => vec![*a, *b],
        Form::Swing(..) | Form::Sum(_) | Form::Nothing | Form::System => Vec::new(),
    };
    for term in removed {
        let own = context.member(term, stage);
        let axis = Axis::Across(Heading::of(&own));
        let pieces = pieces(members, &axis, context.figures);
        page.document.text(format!(
            "Multiplied by n({}), at right angles to {}, which removes {}:",
            own.side.theta(),
            own.side.name,
            own.side.name
        ));
        let figures = in_figures(&pieces, context.figures);
        page.document.equation([in_symbols(&pieces), "0".into()]);
        page.document.equation([figures, "0".into()]);
    }
}

fn single(arm: &[Term]) -> Option<Term> {
    match *arm {
        [term] => Some(term),
        _ => None,
    }
}

/// The solution of every group, in the plan's order.
pub(super) fn solutions(context: &Context<'_>, page: &mut Page) {
    page.document.part("Positions, group by group");
    for stage in context.stages {
        match stage.group {
            Some(number) => {
                let text = context.group_text(number);
                page.document.section(text);
            }
            None => {
                let side = stage
                    .loops
                    .iter()
                    .filter_map(|&l| context.polygon.loops[l].terms.first());
                let names: Vec<&str> = side
                    .map(|t| context.polygon.sides[t.side].name.as_str())
                    .collect();
                page.document
                    .section(format!("The vector {}", names.join(", ")));
            }
        }
        solve(context, page, stage);
    }
}

fn solve(context: &Context<'_>, page: &mut Page, stage: &Stage) {
    let Some(solution) = Solution::new(context, stage) else {
        return without_loop(context, page, stage);
    };
    let is_found = context.has_positions() || solution.is_known();
    if !is_found && !matches!(stage.form, Form::Nothing) {
        page.document
            .text("Not without the positions of the groups before it.");
        return;
    }
    match &stage.form {
        Form::Nothing => repeated(page),
        Form::Triangle(a, b) => solution.triangle(page, a, b),
        Form::Quadratic(arm, slide) => solution.quadratic(page, arm, *slide),
        Form::Swing(arm, slide) => solution.swing(page, arm, *slide),
        Form::Guides(a, b) => solution.guides(page, *a, *b),
        Form::Sum(term) => solution.sum(page, *term),
        Form::System => super::coupled::position(context, page, stage),
    }
}

/// A group whose loop seeks nothing.
fn repeated(page: &mut Page) {
    page.document
        .text("Its loop repeats others: nothing is sought in it.");
}

/// The driver's group, and whatever follows without a loop.
fn without_loop(context: &Context<'_>, page: &mut Page, stage: &Stage) {
    if matches!(stage.form, Form::System) {
        return super::coupled::position(context, page, stage);
    }
    let Some(group) = stage
        .group
        .and_then(|number| context.solver.plan().groups.get(number))
    else {
        return;
    };
    let mut rows = Vec::new();
    if context.has_positions() {
        for &point in &group.points {
            let Some(name) = context.scene.point_name(point) else {
                continue;
            };
            let at = context.state.position(point);
            let size = at.norm();
            let figure = |v: f64| context.figures.beside(v, size);
            rows.push([name.to_owned(), figure(at.x), figure(at.y)]);
        }
    }
    if stage.loops.is_empty() && rows.is_empty() {
        page.document.text("Nothing is sought.");
    } else if stage.loops.is_empty() {
        page.document.text("The driver places:");
    } else {
        repeated(page);
    }
    if !rows.is_empty() {
        let unit = context.figures.unit;
        page.document.table(
            ["point", &format!("x [{unit}]"), &format!("y [{unit}]")],
            rows,
        );
    }
}

/// A loop about to be solved: what is known in it, added up.
struct Solution<'a> {
    context: &'a Context<'a>,
    stage: &'a Stage,
    of: &'a Loop,
    members: Vec<Member<'a>>,
    figures: Figures,
    /// The sum of the known sides.
    known: Vec2,
}

impl<'a> Solution<'a> {
    fn new(context: &'a Context<'a>, stage: &'a Stage) -> Option<Self> {
        let (&[number], false) = (&stage.loops[..], matches!(stage.form, Form::Nothing)) else {
            return None;
        };
        let of = &context.polygon.loops[number];
        let members = context.members(of, stage);
        let sum = |axis: &Axis| {
            let of = |m: &Member<'_>| m.pieces(Order::Position, axis, context.figures);
            known(&members.iter().flat_map(of).collect::<Vec<_>>())
        };
        let known = Vec2::new(sum(&Axis::X), sum(&Axis::Y));
        Some(Solution {
            context,
            stage,
            of,
            figures: context.figures,
            known,
            members,
        })
    }

    /// Whether everything but what the group seeks is given, so that it can be tried without an assembly.
    fn is_known(&self) -> bool {
        let own = |term: &Term| match &self.stage.form {
            Form::Triangle(a, b) => a.contains(term) || b.contains(term),
            Form::Quadratic(arm, slide) => arm.contains(term) || term == slide,
            Form::Nothing | Form::Swing(..) | Form::Guides(..) | Form::Sum(_) | Form::System => {
                false
            }
        };
        let tries = matches!(self.stage.form, Form::Triangle(..) | Form::Quadratic(..));
        let mut pairs = self.of.terms.iter().zip(&self.members);
        tries && pairs.all(|(term, member)| own(term) || member.sought == [false, false])
    }

    fn member(&self, term: Term) -> Member<'_> {
        self.context.member(term, self.stage)
    }

    /// The known sides along an axis, in symbols and as figures.
    fn known_text(&self, axis: &Axis) -> [String; 2] {
        let of = |m: &Member<'_>| m.pieces(Order::Position, axis, self.figures);
        let pieces: Vec<Piece> = self.members.iter().flat_map(of).collect();
        let known: Vec<Piece> = pieces.into_iter().filter(|p| p.unknown.is_none()).collect();
        [in_symbols(&known), in_figures(&known, self.figures)]
    }

    /// The components of what the sought sides must add up to, m = -(known sides), line by line.
    fn write_components(&self, page: &mut Page, names: [&str; 2]) -> Vec2 {
        let m = -self.known;
        let size = self
            .members
            .iter()
            .fold(0.0_f64, |most, m| most.max(m.reading.r.abs()));
        for (axis, name, value) in [(Axis::X, names[0], m.x), (Axis::Y, names[1], m.y)] {
            let [symbols, figures] = self.known_text(&axis);
            let found = self.figures.beside(value, size);
            page.document.equation([
                name.to_owned(),
                format!("-({symbols})"),
                format!("-({figures})"),
                format!("{found} {}", self.figures.unit),
            ]);
        }
        m
    }

    /// The length of an arm and how far its direction lies ahead of the angle that is named after it.
    fn arm(&self, arm: &[Term]) -> Arm<'a> {
        match single(arm) {
            Some(term) => {
                let member = self.member(term);
                Arm {
                    side: self.context.polygon.sides.get(term.side),
                    length: member.side.name.clone(),
                    value: member.reading.r,
                    given: !member.side.stretches(),
                    theta: member.side.theta(),
                    ahead: if term.reversed {
                        angle::TURN / 2.0
                    } else {
                        0.0
                    },
                    solved: member.reading.theta,
                }
            }
            None => self.composed(arm),
        }
    }

    /// Several sides that turn together, as one.
    fn composed(&self, arm: &[Term]) -> Arm<'a> {
        let members: Vec<Member<'_>> = arm.iter().map(|&term| self.member(term)).collect();
        let sum = members.iter().fold(Vec2::ZERO, |sum, m| {
            let r = m.reading.vector();
            sum + if m.reversed { -r } else { r }
        });
        let link = members.iter().find_map(|m| m.side.turns_with());
        let own = link.map_or(0.0, |link| self.context.state.angle(link));
        let mut text = Sum::default();
        members
            .iter()
            .for_each(|m| text.push(m.reversed, &m.side.name));
        let name = link.map_or("", |link| self.context.scene.link_name(link));
        Arm {
            side: None,
            length: format!("|{}|", text.text()),
            value: sum.norm(),
            given: false,
            theta: super::symbols::theta(name),
            ahead: angle::wrapped(angle::degrees(sum) - own),
            solved: own,
        }
    }

    /// Where the two arms of a dyad begin, meet and end.
    fn joints(&self, first: &[Term], second: &[Term]) -> [&str; 3] {
        let ends = |term: &Term| self.context.polygon.ends(*term);
        let name = |end: Option<&'a str>| end.unwrap_or("");
        let p = first.first().map(|t| self.context.polygon.ends(*t).0);
        let x = first.last().map(|t| self.context.polygon.ends(*t).1);
        let q = second.last().map(|t| ends(t).1);
        [name(p), name(x), q.unwrap_or("")]
    }

    /// The arms in the order in which the loop goes along them.
    fn in_order<'t>(&self, a: &'t [Term], b: &'t [Term]) -> [Vec<Term>; 2] {
        let count = self.of.terms.len();
        let is_arm = |term: &Term| a.contains(term) || b.contains(term);
        let begins = (0..count).find(|&i| {
            let before = (i + count - 1) % count;
            is_arm(&self.of.terms[i]) && !is_arm(&self.of.terms[before])
        });
        let at = begins.unwrap_or(0);
        let rotated: Vec<Term> = (0..count)
            .map(|i| self.of.terms[(at + i) % count])
            .collect();
        let of = |arm: &[Term]| {
            rotated
                .iter()
                .copied()
                .filter(|t| arm.contains(t))
                .collect()
        };
        if rotated.first().is_some_and(|t| a.contains(t)) {
            [of(a), of(b)]
        } else {
            [of(b), of(a)]
        }
    }

    // ---- two angles

    /// The cosine theorem in the triangle of both arms and m, as in the lecture.
    fn triangle(&self, page: &mut Page, a: &[Term], b: &[Term]) {
        let f = self.figures;
        let [first, second] = self.in_order(a, b);
        let [p, x, q] = self.joints(&first, &second);
        let (one, two) = (self.arm(&first), self.arm(&second));
        page.document.text(format!(
            "With m from {p} to {q}, and {x} where the two arms meet:"
        ));
        let m = self.write_components(page, ["mx", "my"]);
        let (size, b, c) = (m.norm(), one.value, two.value);
        page.document.equation([
            "m".to_owned(),
            "sqrt(mx^2 + my^2)".into(),
            format!("{} {}", f.number(size), f.unit),
        ]);
        if !self.context.has_positions() {
            return reach(page, f, size, [&one, &two]);
        }
        if size <= MEETING * b.max(c) {
            return self.coincident(page, [p, q], [&one, &two]);
        }
        let alpha = (-m.y).atan2(m.x).to_degrees();
        page.document
            .equation(["α".to_owned(), "atan2(-my, mx)".into(), degrees(f, alpha)]);
        let corner = |near: &Arm<'_>, far: &Arm<'_>| {
            let cosine = (size * size + near.value * near.value - far.value * far.value)
                / (2.0 * size * near.value);
            // At a dead point rounding may carry it beyond 1.
            cosine.clamp(-1.0, 1.0).acos().to_degrees()
        };
        let (beta, gamma) = (corner(&one, &two), corner(&two, &one));
        for (name, near, far, value) in [("β", &one, &two, beta), ("γ", &two, &one, gamma)] {
            let [n, o] = [near, far].map(|arm| arm.figure(f));
            let m = f.number(size);
            page.document.equation([
                name.to_owned(),
                format!(
                    "acos((m^2 + {0}^2 - {1}^2)/(2 m {0}))",
                    near.length, far.length
                ),
                format!("acos(({m}^2 + {n}^2 - {o}^2)/(2·{m}·{n}))"),
                degrees(f, value),
            ]);
        }
        let left = m.cross(one.direction()) >= 0.0;
        let side = if left { "left" } else { "right" };
        page.document.text(format!(
            "{x} lies on the {side} of {p} → {q}, by the assembly:"
        ));
        let sign = if left { 1.0 } else { -1.0 };
        // What the cosine loses near a stretched dyad: its rounding over the sine.
        let loss = |corner: f64| {
            1.0 + (b.max(c).max(size) / b.min(c).min(size))
                / corner.to_radians().sin().abs().max(1e-8)
        };
        self.write_angle(page, &one, [-alpha, sign * beta], ["-α", "β"], loss(beta));
        self.write_angle(
            page,
            &two,
            [-alpha, -sign * gamma],
            ["-α", "γ"],
            loss(gamma),
        );
    }

    /// Where the pivots of a dyad lie on each other no triangle tells its angles.
    fn coincident(&self, page: &mut Page, [p, q]: [&str; 2], arms: [&Arm<'_>; 2]) {
        page.document.text(format!(
            "{p} and {q} lie on each other: there is no triangle, and the angles are the limits along the motion:"
        ));
        for arm in arms {
            page.document
                .equation([arm.theta.clone(), turn(self.figures, arm.solved)]);
        }
    }

    /// `theta = -alpha + beta + 180 = ...`.
    fn write_angle(
        &self,
        page: &mut Page,
        arm: &Arm<'_>,
        parts: [f64; 2],
        names: [&str; 2],
        loss: f64,
    ) {
        let f = self.figures;
        let ahead = -arm.ahead;
        let (mut symbols, mut numbers) = (Sum::default(), Sum::default());
        for (value, name) in parts.into_iter().zip(names) {
            let name = name.trim_start_matches('-');
            // The first part is minus the symbol, the second goes by its sign.
            let negative = if name == "α" { true } else { value < 0.0 };
            symbols.push(negative, name);
            numbers.push_figure(&f.number(value));
        }
        if arm.ahead != 0.0 {
            symbols.push_figure(&f.angle(ahead));
            numbers.push_figure(&f.angle(ahead));
        }
        let worked = parts[0] + parts[1] + ahead;
        page.agree_angle(&arm.theta, worked, arm.solved, loss);
        page.document.equation([
            arm.theta.clone(),
            symbols.text(),
            numbers.text(),
            turn(f, worked),
        ]);
        if let Some(side) = arm.side {
            self.write_link_angle(page, side, worked, loss);
        }
    }

    /// The angle of the link with which a side turns, where it is not the side's own.
    fn write_link_angle(&self, page: &mut Page, side: &Side, theta: f64, loss: f64) {
        let (Turns::With(link, ahead), f) = (side.turns, self.figures) else {
            return;
        };
        if side.shape == Shape::Link(link) {
            return;
        }
        let symbol = super::symbols::theta(self.context.scene.link_name(link));
        let worked = theta - ahead;
        page.agree_angle(&symbol, worked, self.context.state.angle(link), loss);
        page.document.equation([
            symbol,
            format!("{} - {}", side.theta(), f.direction(ahead)),
            turn(f, worked),
        ]);
    }

    // ---- an angle and a position

    /// |known + r u|^2 = arm^2: a quadratic in r.
    fn quadratic(&self, page: &mut Page, arm: &[Term], slide: Term) {
        let f = self.figures;
        let arm = self.arm(arm);
        let member = self.member(slide);
        let (name, theta) = (member.side.name.clone(), member.side.theta());
        let sign = if slide.reversed { -1.0 } else { 1.0 };
        page.document.text(format!(
            "With K the sum of the known sides, {} = |K {} {name} u|, u at {theta}: a quadratic in {name}.",
            arm.length,
            if slide.reversed { "-" } else { "+" }
        ));
        let k = self.known;
        let size = k.norm().max(arm.value);
        for (axis, label, value) in [(Axis::X, "Kx", k.x), (Axis::Y, "Ky", k.y)] {
            let [symbols, figures] = self.known_text(&axis);
            let found = f.beside(value, size);
            let mut sides = vec![label.to_owned(), symbols, figures];
            // A single term is a figure already.
            sides.retain(|side| *side != found);
            sides.push(format!("{found} {}", f.unit));
            page.document.equation(sides);
        }
        let u = member.reading.u;
        let half = sign * k.dot(u);
        let rest = k.norm2() - arm.value * arm.value;
        let direction = f.direction(member.reading.theta);
        page.document
            .equation([format!("{name}^2 + 2 p {name} + q"), "0".into()]);
        let sum = [
            format!("Kx cos({theta}) + Ky sin({theta})"),
            format!(
                "{}·cos({direction}) + {}·sin({direction})",
                factor(&f.beside(k.x, size)),
                factor(&f.beside(k.y, size))
            ),
        ];
        let [symbols, numbers] = sum.map(|sum| match slide.reversed {
            true => format!("-({sum})"),
            false => sum,
        });
        page.document
            .equation(["p".to_owned(), symbols, numbers, f.beside(half, size)]);
        page.document.equation([
            "q".to_owned(),
            format!("Kx^2 + Ky^2 - {}^2", arm.length),
            f.beside(rest, size * size),
        ]);
        let under = half * half - rest;
        if !self.context.has_positions() {
            return no_root(page, f, under, &arm);
        }
        let root = under.max(0.0).sqrt();
        let roots = [-half + root, -half - root];
        let [plus, less] = roots.map(|r| f.beside(r, size));
        page.document.equation([
            name.clone(),
            "-p +- sqrt(p^2 - q)".into(),
            format!("{} +- {}", f.beside(-half, size), f.beside(root, size)),
            format!("{plus} or {less} {}", f.unit),
        ]);
        let solved = member.reading.r;
        let near = |r: f64| (r - solved).abs();
        let chosen = if near(roots[0]) <= near(roots[1]) {
            0
        } else {
            1
        };
        let worked = roots[chosen];
        let loss = size * (1.0 + size / root.max(1e-8 * size));
        page.agree(&name, worked, solved, loss);
        page.document.text("By the assembly:");
        page.document.equation([
            name.clone(),
            format!("{} {}", f.beside(worked, size), f.unit),
        ]);
        // What closes the loop is the arm.
        let left = -(k + u * (sign * worked));
        self.write_direction(
            page,
            &arm,
            left,
            &format!("K {} {name} u", if slide.reversed { "-" } else { "+" }),
            size,
            1.0 + size / root.max(1e-8 * size),
        );
    }

    /// `theta = atan2(y, x) = ...` of an arm that is minus another vector.
    fn write_direction(
        &self,
        page: &mut Page,
        arm: &Arm<'_>,
        along: Vec2,
        what: &str,
        size: f64,
        loss: f64,
    ) {
        let f = self.figures;
        let worked = along.angle().to_degrees() - arm.ahead;
        page.agree_angle(&arm.theta, worked, arm.solved, loss);
        let text = format!(
            "atan2({}, {})",
            f.beside(along.y, size),
            f.beside(along.x, size)
        );
        let mut numbers = Sum::default();
        numbers.push(false, &text);
        if arm.ahead != 0.0 {
            numbers.push_figure(&f.angle(-arm.ahead));
        }
        page.document.equation([
            arm.theta.clone(),
            format!(
                "angle of -({what}){}",
                if arm.ahead == 0.0 {
                    String::new()
                } else {
                    format!(" - {}", f.angle(arm.ahead))
                }
            ),
            numbers.text(),
            turn(f, worked),
        ]);
        if let Some(side) = arm.side {
            self.write_link_angle(page, side, worked, loss);
        }
    }

    /// The sides that turn with the guide, among them the one along it, must be minus the known ones.
    fn swing(&self, page: &mut Page, arm: &[Term], slide: Term) {
        let f = self.figures;
        let member = self.member(slide);
        let (name, u) = (member.side.name.clone(), member.reading.u);
        let m = self.write_components(page, ["mx", "my"]);
        let size = m.norm();
        page.document.equation([
            "m".to_owned(),
            "sqrt(mx^2 + my^2)".into(),
            format!("{} {}", f.number(size), f.unit),
        ]);
        // The other sides of the arm, along the guide's vector and across it: they never change.
        let others = arm.iter().filter(|t| **t != slide).map(|&t| self.member(t));
        let rest = others.fold(Vec2::ZERO, |sum, o| {
            let r = o.reading.vector();
            sum + if o.reversed { -r } else { r }
        });
        let sign = if slide.reversed { -1.0 } else { 1.0 };
        let (t0, e) = (u.dot(rest), u.cross(rest));
        let has_rest = rest.norm() > 1e-12 * size.max(member.reading.r.abs());
        let (t0, e) = if has_rest { (t0, e) } else { (0.0, 0.0) };
        let square = (size - e.abs()) * (size + e.abs());
        let w = square
            .max(0.0)
            .sqrt()
            .copysign(t0 + sign * member.reading.r);
        let worked = sign * (w - t0);
        let loss = 1.0 + size / w.abs().max(1e-8 * size);
        page.agree(&name, worked, member.reading.r, size * loss);
        let plus = if w < 0.0 { "-" } else { "" };
        if has_rest {
            page.document.text(format!(
                "The other sides that turn with it lie {} along {name} and {} to its left.",
                f.beside(t0, size),
                f.beside(e, size)
            ));
            page.document.equation([
                "w".to_owned(),
                format!("{plus}sqrt(m^2 - e^2)"),
                format!(
                    "{plus}sqrt({}^2 - {}^2)",
                    f.number(size),
                    factor(&f.beside(e, size))
                ),
                f.beside(w, size),
            ]);
            page.document.equation([
                name.clone(),
                format!(
                    "{}(w - {})",
                    if slide.reversed { "-" } else { "" },
                    factor(&f.beside(t0, size))
                ),
                format!("{} {}", f.beside(worked, size), f.unit),
            ]);
        } else {
            let minus = if sign * w < 0.0 { "-" } else { "" };
            page.document.equation([
                name.clone(),
                format!("{minus}m"),
                format!("{} {}", f.beside(worked, size), f.unit),
            ]);
        }
        let ahead = e.atan2(w).to_degrees();
        let angle_of_m = m.angle().to_degrees();
        let theta = member.side.theta();
        let value = angle_of_m - ahead;
        page.agree_angle(&theta, value, member.reading.theta, loss);
        let atan = format!("atan2({}, {})", f.beside(m.y, size), f.beside(m.x, size));
        let second = if has_rest || ahead != 0.0 {
            let e = f.beside(e, size);
            format!("{atan} - atan2({e}, {})", f.beside(w, size))
        } else {
            atan
        };
        page.document.equation([theta, second, turn(f, value)]);
        self.write_link_angle(page, member.side, value, loss);
    }

    // ---- two positions

    /// Each removed by the normal of its guide.
    fn guides(&self, page: &mut Page, a: Term, b: Term) {
        let f = self.figures;
        let size = self.known.norm().max(self.member(a).reading.r.abs());
        for (own, other) in [(a, b), (b, a)] {
            let (own, other) = (self.member(own), self.member(other));
            let axis = Axis::Across(Heading::of(&other));
            let pieces = pieces(&self.members, &axis, f);
            let sum = known(&pieces);
            let factor_of = other.reading.u.cross(own.reading.u);
            let factor_of = if own.reversed { -factor_of } else { factor_of };
            let worked = -sum / factor_of;
            page.agree(
                &own.side.name,
                worked,
                own.reading.r,
                size / factor_of.abs(),
            );
            let divisor = factor(&f.beside(factor_of, 1.0));
            page.document.equation([
                own.side.name.clone(),
                format!("-{}/{divisor}", factor(&f.beside(sum, size))),
                format!("{} {}", f.beside(worked, size), f.unit),
            ]);
        }
    }

    /// A vector that closes its loop alone.
    fn sum(&self, page: &mut Page, term: Term) {
        let f = self.figures;
        let member = self.member(term);
        let m = self.write_components(page, ["mx", "my"]);
        let size = m.norm();
        let name = member.side.name.clone();
        page.agree(&name, size, member.reading.r, self.longest());
        page.document.equation([
            name,
            "sqrt(mx^2 + my^2)".into(),
            format!("{} {}", f.number(size), f.unit),
        ]);
        let worked = m.angle().to_degrees();
        let theta = member.side.theta();
        page.agree_angle(&theta, worked, member.reading.theta, self.longest() / size);
        page.document
            .equation([theta, "atan2(my, mx)".into(), turn(f, worked)]);
    }

    fn longest(&self) -> f64 {
        self.members
            .iter()
            .fold(0.0, |most, m| most.max(m.reading.r.abs()))
    }
}

/// A distance of pivots below this part of the arms is none.
const MEETING: f64 = 1e-12;

/// One arm of a dyad.
struct Arm<'a> {
    /// The side, if it is one alone.
    side: Option<&'a Side>,
    /// The symbol of its length.
    length: String,
    value: f64,
    given: bool,
    /// The angle that is sought.
    theta: String,
    /// How far the arm's direction, along the loop, lies ahead of that angle, in degrees.
    ahead: f64,
    /// The solver's angle.
    solved: f64,
}

impl Arm<'_> {
    fn figure(&self, figures: Figures) -> String {
        if self.given {
            figures.given(self.value)
        } else {
            figures.number(self.value)
        }
    }

    /// Its direction along the loop, in the solver's state.
    fn direction(&self) -> Vec2 {
        angle::unit(self.solved + self.ahead)
    }
}

fn degrees(figures: Figures, value: f64) -> String {
    format!("{} deg", figures.number(value))
}

/// An angle as it comes out, and from 0 to below 360 where that differs.
fn turn(figures: Figures, value: f64) -> String {
    let half = angle::TURN / 2.0;
    let signed = angle::wrapped(value + half) - half;
    let direction = figures.direction(value);
    if signed < 0.0 {
        format!("{} deg = {direction} deg", figures.angle(signed))
    } else {
        format!("{direction} deg")
    }
}

/// Why two arms do not meet, or that they would.
fn reach(page: &mut Page, figures: Figures, size: f64, [one, two]: [&Arm<'_>; 2]) {
    let (sum, difference) = (one.value + two.value, (one.value - two.value).abs());
    let text = if size > sum {
        format!(
            "m is longer than {} + {} = {} {}: the arms do not reach each other.",
            one.length,
            two.length,
            figures.number(sum),
            figures.unit
        )
    } else if size < difference {
        format!(
            "m is shorter than |{} - {}| = {} {}: the arms cannot close the triangle.",
            one.length,
            two.length,
            figures.number(difference),
            figures.unit
        )
    } else {
        "This triangle would close, but the motion that starts at the scene's assembly does not come here.".into()
    };
    page.document.text(text);
}

/// Why a quadratic has no root, or that it would have.
fn no_root(page: &mut Page, figures: Figures, under: f64, arm: &Arm<'_>) {
    page.document
        .equation(["p^2 - q".to_owned(), figures.number(under)]);
    let text = if under < 0.0 {
        format!("It is negative: {} does not reach the guide.", arm.length)
    } else {
        "It would close, but the motion that starts at the scene's assembly does not come here."
            .into()
    };
    page.document.text(text);
}
