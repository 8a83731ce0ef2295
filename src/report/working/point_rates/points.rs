//! Writes velocities and accelerations of joints, centres of mass and further points: by tangential
//! and normal components about a pivot or another joint of the link, or along a guide.

use super::point_parts::{PointParts, about};
use crate::page::{Formula, Symbol};
use crate::report::working::context::{Context, Draft};
use crate::report::working::expression::{Expression, Function};
use crate::report::working::loops::sides::Turns;
use crate::report::working::loops::solution::angle_sum;
use crate::report::working::symbols::{self, of_point, part_of_point};
use crate::solver::{Order, Sliding};
use crate::wording::words;
use crate::{Body, LinkId, Mechanism, PointId, SlideId, Vec2, angle};

/// The reference of a point's motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum PointBasis {
    /// A link, and another point of it.
    Link(LinkId, PointId),
    /// A guide.
    Guide(SlideId),
}

/// Writes the motion of every moving point.
pub(crate) fn points(context: &Context<'_>, draft: &mut Draft) {
    draft.part(words().points_part());
    let mechanism = &context.scene.mechanism;
    let moving = mechanism
        .point_ids()
        .filter(|&p| mechanism.point(p).ground.is_none());
    let places = places(context);
    let seats: Vec<(PointId, PointBasis)> = moving
        .filter_map(|point| Some((point, seat(mechanism, &places, point)?)))
        .collect();
    if !context.has_rates() {
        draft.text(words().rates_of_points_missing());
        return;
    }
    for (point, seat) in seats {
        let Some(name) = context.scene.point_name(point) else {
            continue;
        };
        match seat {
            PointBasis::Link(link, base) => on_link(context, draft, (point, name), link, base),
            PointBasis::Guide(slide) => on_guide(context, draft, (point, name), slide),
        }
    }
}

/// Returns the reference of a point: preferably a ground pivot, then a guide on the ground, then a
/// joint placed earlier.
pub(crate) fn seat(mechanism: &Mechanism, places: &[usize], point: PointId) -> Option<PointBasis> {
    let links = &mechanism.point(point).links;
    let pivot = links.iter().find_map(|&link| {
        let mut members = mechanism.link(link).members.iter();
        let pivot = members.find(|m| mechanism.point(m.point).ground.is_some())?;
        Some(PointBasis::Link(link, pivot.point))
    });
    let slides = || {
        mechanism
            .slide_ids()
            .filter(|&s| mechanism.slide(s).slider.point() == point)
    };
    let on_ground = slides().find(|&s| mechanism.slide(s).on == Body::Ground);
    let ridden = || {
        let base = |link| {
            Some(PointBasis::Link(
                link,
                earliest(mechanism, places, link, point)?,
            ))
        };
        links.iter().find_map(|&link| base(link))
    };
    pivot
        .or(on_ground.map(PointBasis::Guide))
        .or_else(ridden)
        .or_else(|| slides().next().map(PointBasis::Guide))
}

/// Returns the first placed point of a link, if it precedes this one.
pub(crate) fn earliest(
    mechanism: &Mechanism,
    places: &[usize],
    link: LinkId,
    point: PointId,
) -> Option<PointId> {
    let members = mechanism.link(link).members.iter().map(|m| m.point);
    let first = members.min_by_key(|member| places[member.index()])?;
    (places[first.index()] < places[point.index()]).then_some(first)
}

/// Returns the rank of every point in the solution order: ground points first, then in the order of
/// the groups.
pub(crate) fn places(context: &Context<'_>) -> Vec<usize> {
    let mut places = vec![0; context.scene.mechanism.points().len()];
    let groups = context.solver.plan().groups.iter();
    for (index, point) in groups.flat_map(|group| &group.points).enumerate() {
        places[point.index()] = index + 1;
    }
    places
}

/// Writes a velocity or acceleration of a point by its components.
struct VectorFormatter<'a> {
    context: &'a Context<'a>,
    /// The symbol: `v` or `a`.
    figure: &'static str,
    /// The unit.
    unit: String,
    /// The maximum magnitude of the added vectors, which determines the rounding errors.
    size: f64,
}

impl VectorFormatter<'_> {
    /// Creates the formatter of a velocity, or of an acceleration for order 2. `size` is the
    /// maximum magnitude of vectors that are no velocities or accelerations of points.
    fn new<'a>(context: &'a Context<'a>, order: usize, size: f64) -> VectorFormatter<'a> {
        VectorFormatter {
            context,
            figure: ["v", "a"][order - 1],
            unit: context.figures.length_unit(order),
            size: size.max(context.fastest[order - 1]),
        }
    }

    /// Formats a vector with its symbol, by magnitude and direction.
    fn polar(&self, symbol: impl Into<Formula>, v: Vec2) -> [Formula; 2] {
        [symbol.into(), self.format_vector(v.norm(), v)]
    }

    /// Formats a vector with this magnitude, in the direction of another.
    fn format_vector(&self, size: f64, along: Vec2) -> Formula {
        let f = self.context.figures;
        let length = f.format_or_zero(size, self.size);
        let is_zero = length == "0";
        let length = Formula::measured(length, &self.unit);
        match is_zero {
            true => length,
            false => at_degrees(length, f.direction(angle::degrees(along))),
        }
    }

    /// Writes a component by its magnitude:
    /// `aCt = alpha4 r = 95.5036*250 = 23875.9 mm/s^2 at 200.753 deg`.
    fn part(&self, draft: &mut Draft, symbol: Symbol, size: &Expression, value: Vec2) {
        let computed = draft.worked(symbol.clone(), size, |size| self.format_vector(size, value));
        draft.agree(symbol, computed, value.norm(), self.size);
    }

    /// Writes x and y as sums of the components:
    /// `vCx = 587.462*cos(299.379) + 1500*cos(150) = -1010.83`.
    fn components(&self, draft: &mut Draft, name: &str, parts: &[Vec2]) {
        let f = self.context.figures;
        for (axis, function) in [("x", Function::Cos), ("y", Function::Sin)] {
            let terms = parts.iter().filter_map(|part| {
                let length = f.format_or_zero(part.norm(), self.size);
                let direction = angle::degrees(*part);
                let at = Expression::figure(f.direction(direction), direction);
                let along = Expression::of(function, [at]);
                (length != "0").then(|| Expression::figure(length, part.norm()) * along)
            });
            let figure = |value| Formula::measured(f.format_or_zero(value, self.size), &self.unit);
            let symbol = part_of_point(self.figure, name, axis);
            draft.write_numbers(symbol, &Expression::sum(terms), figure);
        }
    }

    /// Writes the magnitude from two perpendicular lengths: tangential and normal, or x and y.
    fn write_magnitude(&self, draft: &mut Draft, name: &str, sum: Vec2, parts: [f64; 2]) {
        let f = self.context.figures;
        let [x, y] = parts.map(|v| Expression::figure(f.format_or_zero(v, self.size), v));
        let size = (x.squared() + y.squared()).sqrt();
        let symbol = of_point(self.figure, name);
        draft.write_numbers(symbol, &size, |size| self.format_vector(size, sum));
    }

    /// Records the difference between a sum of components and the solver's vector.
    fn agree(&self, draft: &mut Draft, name: &str, computed: Vec2, solved: Vec2) {
        let symbol = of_point(self.figure, name);
        draft.agree(symbol, (computed - solved).norm(), 0.0, self.size);
    }
}

/// A point on a link, relative to another point of it.
struct LinkPoint<'a> {
    context: &'a Context<'a>,
    point: PointId,
    name: &'a str,
    base_name: &'a str,
    link: LinkId,
    link_name: &'a str,
    /// The vector from the base to the point, in the ground's frame.
    e: Vec2,
    /// The given length of the vector.
    r: f64,
    /// Whether the base is a ground point.
    is_pivot: bool,
    parts: PointParts,
}

fn on_link(
    context: &Context<'_>,
    draft: &mut Draft,
    (point, name): (PointId, &str),
    link: LinkId,
    base: PointId,
) {
    let mechanism = &context.scene.mechanism;
    let both = arm(mechanism, link, base, point).zip(about(context, link, base, point));
    let Some((arm, parts)) = both else {
        return;
    };
    let on = LinkPoint {
        context,
        point,
        name,
        base_name: context.scene.point_name(base).unwrap_or(words().a_point()),
        link,
        link_name: context.scene.link_name(link),
        e: arm.turned(context.state.direction(link)),
        r: arm.norm(),
        is_pivot: mechanism.point(base).ground.is_some(),
        parts,
    };
    let LinkPoint {
        link_name,
        base_name,
        ..
    } = on;
    draft.section(words().point_on_about(name, link_name, base_name));
    if on.r == 0.0 {
        draft.text(words().lies_on(base_name));
    } else if context.polygon.locks.turns(Body::Link(link), 0.0) == Turns::Never {
        draft.text(words().does_not_turn(link_name, base_name));
    } else {
        on.arm(draft);
        on.velocity(draft);
        on.acceleration(draft);
    }
}

/// Returns the vector from one point of a link to another, in the link's frame.
pub(super) fn arm(mechanism: &Mechanism, link: LinkId, from: PointId, to: PointId) -> Option<Vec2> {
    let link = mechanism.link(link);
    Some(link.local(to)? - link.local(from)?)
}

impl LinkPoint<'_> {
    fn arm(&self, draft: &mut Draft) {
        let f = self.context.figures;
        let direction = f.direction(angle::degrees(self.e));
        let length = Formula::measured(f.given(self.r), f.unit);
        draft.equation(["r".into(), at_degrees(length, direction)]);
    }

    /// Formats the magnitude of a rate as a factor. The driver's rates have no more digits than
    /// given; rounding errors of vectors of this size become 0.
    fn rate(&self, value: f64, size: f64) -> String {
        let f = self.context.figures;
        match self.context.scene.mechanism.is_crank(self.link) {
            true => f.given(value.abs()),
            false => f.format_or_zero(value.abs(), size / self.r),
        }
    }

    /// Returns the length of the arm.
    fn length(&self) -> Expression {
        self.context.figures.as_given("r", self.r)
    }

    /// Writes v = v of the base + omega k x e.
    fn velocity(&self, draft: &mut Draft) {
        let state = self.context.state;
        let w = state.omega(self.link);
        let (turning, base) = (self.parts.velocity, self.parts.base[0]);
        let formatter = VectorFormatter::new(self.context, 1, turning.norm());
        let rate = size_of(symbols::omega(self.link_name), w);
        let rate = Expression::known(rate, self.rate(w, formatter.size), w.abs());
        let size = rate * self.length();
        let sum = base + turning;
        formatter.agree(draft, self.name, sum, state.velocity(self.point));
        if self.is_pivot {
            return formatter.part(draft, of_point("v", self.name), &size, turning);
        }
        formatter.part(draft, part_of_point("v", self.name, "t"), &size, turning);
        draft.equation(formatter.polar(of_point("v", self.base_name), base));
        formatter.components(draft, self.name, &[turning, base]);
        formatter.write_magnitude(draft, self.name, sum, [sum.x, sum.y]);
    }

    /// Writes a = a of the base + alpha k x e - omega^2 e.
    fn acceleration(&self, draft: &mut Draft) {
        let state = self.context.state;
        let (w, alpha) = (state.omega(self.link), state.alpha(self.link));
        let PointParts {
            tangential,
            normal,
            base: [_, base],
            ..
        } = self.parts;
        let parts = tangential.norm().max(normal.norm());
        let formatter = VectorFormatter::new(self.context, 2, parts);
        let rate = size_of(symbols::alpha(self.link_name), alpha);
        let rate = Expression::known(rate, self.rate(alpha, formatter.size), alpha.abs());
        let size = rate * self.length();
        formatter.part(draft, part_of_point("a", self.name, "t"), &size, tangential);
        let rate = symbols::omega(self.link_name);
        let rate = Expression::known(rate, self.rate(w, 0.0), w.abs());
        let size = rate.squared() * self.length();
        formatter.part(draft, part_of_point("a", self.name, "n"), &size, normal);
        let sum = base + tangential + normal;
        formatter.agree(draft, self.name, sum, state.acceleration(self.point));
        if self.is_pivot {
            let parts = [tangential.norm(), normal.norm()];
            formatter.write_magnitude(draft, self.name, sum, parts);
            return self.between(draft, parts, formatter.size);
        }
        draft.equation(formatter.polar(of_point("a", self.base_name), base));
        formatter.components(draft, self.name, &[tangential, normal, base]);
        formatter.write_magnitude(draft, self.name, sum, [sum.x, sum.y]);
    }

    /// Writes the angle between an acceleration about a pivot and its normal component.
    fn between(&self, draft: &mut Draft, [t, n]: [f64; 2], size: f64) {
        if !(t > NOUGHT * size && n > 0.0) {
            return;
        }
        let f = self.context.figures;
        let parts = [t, n].map(|v| Expression::figure(f.number(v), v));
        let [above, below] = parts;
        let quotient = Expression::of(Function::Atan, [above / below]);
        draft.write_numbers("β", &quotient, |beta| {
            let arguments = [
                Formula::number(&f.number(beta)),
                of_point("a", self.name).into(),
            ];
            Formula::message(|[beta, a]| words().between_normal_part(beta, a), arguments)
        });
        self.direction(draft, (t / n).atan().to_degrees(), size);
    }

    /// Writes the direction of an acceleration, relative to its normal component:
    /// `theta_aC = theta4 - beta`.
    fn direction(&self, draft: &mut Draft, beta: f64, size: f64) {
        let (f, state) = (self.context.figures, self.context.state);
        let own = state.angle(self.link);
        let ahead = angle::wrapped(angle::degrees(-self.e) - own);
        let theta = symbols::theta(self.link_name);
        let mut sum = f.directed(theta, own);
        let by = f.direction(ahead);
        if by != "0" {
            sum = sum + Expression::figure(by, ahead);
        }
        // For a counter-clockwise angular acceleration, the tangential component trails the normal
        // one by a right angle.
        let is_behind = state.alpha(self.link) > 0.0;
        let beta = f.computed("β", beta).minus_if(is_behind);
        let symbol = symbols::theta(&of_point("a", self.name).to_string());
        let computed = draft.worked(symbol.clone(), &(sum + beta), |computed| {
            angle_sum(f, computed)
        });
        let a = state.acceleration(self.point);
        draft.agree_angle(symbol, computed, angle::degrees(a), 1.0 + size / a.norm());
    }
}

/// Components below this fraction of the largest one are rounding errors.
const NOUGHT: f64 = 1e-15;

/// Returns the symbol of a rate's magnitude, with bars if the rate is negative.
fn size_of(symbol: Symbol, rate: f64) -> Formula {
    let symbol = Formula::from(symbol);
    if rate < 0.0 {
        symbol.between(['|', '|'])
    } else {
        symbol
    }
}

/// Formats a length with its direction in degrees.
fn at_degrees(length: Formula, direction: String) -> Formula {
    let arguments = [length, Formula::number(&direction)];
    Formula::message(
        |[length, degrees]| words().at_degrees(length, degrees),
        arguments,
    )
}

/// Writes the motion of a slider: along its guide, and for a moving guide also that of the guide.
fn on_guide(
    context: &Context<'_>,
    draft: &mut Draft,
    (point, name): (PointId, &str),
    slide: SlideId,
) {
    let state = context.state;
    let slide_name = context.scene.slide_name(slide);
    let on = context.scene.mechanism.slide(slide).on;
    let body = match on {
        Body::Ground => words().the_ground(),
        Body::Link(link) => context.scene.link_name(link),
    };
    draft.section(words().along_guide_of(name, slide_name, body));
    let Sliding {
        guide: t,
        rate,
        accel,
        omega,
        ..
    } = state.travel(slide);
    let (v, a) = (state.velocity(point), state.acceleration(point));
    let (along, second) = (t * rate, t * accel);
    let rate_name = size_of(symbols::length(slide_name, Order::Velocity), rate);
    let accel_name = size_of(symbols::length(slide_name, Order::Acceleration), accel);
    if on == Body::Ground {
        for (formatter, symbol, value, solved) in [
            (VectorFormatter::new(context, 1, 0.0), rate_name, along, v),
            (VectorFormatter::new(context, 2, 0.0), accel_name, second, a),
        ] {
            formatter.agree(draft, name, value, solved);
            let [whole, text] = formatter.polar(of_point(formatter.figure, name), value);
            draft.equation([whole, symbol, text]);
        }
        return;
    }
    // The remaining motion is that of the guide's point under the pin.
    let coriolis = t.perp() * (2.0 * omega * rate);
    let (guide_v, guide_a) = (v - along, a - second - coriolis);
    let under = |letter: &str| {
        let message = |[symbol, body, point]: [&str; 3]| words().of_under(symbol, body, point);
        Formula::message(message, [letter, body, name].map(Formula::from))
    };
    let of_v = VectorFormatter::new(context, 1, 0.0);
    for line in [
        of_v.polar(under("v"), guide_v),
        of_v.polar(rate_name.clone(), along),
        of_v.polar(of_point("v", name), guide_v + along),
    ] {
        draft.equation(line);
    }
    let of_a = VectorFormatter::new(context, 2, coriolis.norm());
    let turning = size_of(symbols::omega(body), omega);
    let f = context.figures;
    let size = Expression::Number(2.0)
        * f.computed(turning, omega.abs())
        * f.computed(rate_name, rate.abs());
    draft.equation(of_a.polar(under("a"), guide_a));
    let coriolis_of = Formula::from(part_of_point("a", name, "c"));
    let symbol = coriolis_of
        .blank()
        .then(Formula::words("Coriolis").in_brackets());
    draft.worked(symbol, &size, |size| of_a.format_vector(size, coriolis));
    for line in [
        of_a.polar(accel_name, second),
        of_a.polar(of_point("a", name), guide_a + coriolis + second),
    ] {
        draft.equation(line);
    }
}
