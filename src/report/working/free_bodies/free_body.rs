//! Writes the free body of a link: the forces on it, and its three equations of motion with
//! numbers.

use super::forces::point_name;
use crate::page::{Formula, Symbol};
use crate::report::working::context::{Context, Draft};
use crate::report::working::expression::{Expression, Function};
use crate::report::working::reactions::body::{BalanceKind, table};
use crate::solver::LoadAction;
use crate::wording::words;
use crate::{Body, Input, LinkId, Mechanism, PointId, SlideId, Slider, Vec2};

/// A force on a link, or a couple.
pub(crate) struct BodyForce {
    pub name: String,
    pub force: Vec2,
    /// The point of application; `None` for a couple.
    pub(crate) at: Option<Vec2>,
    /// The couple in N m.
    pub(crate) couple: f64,
    /// The joint that transmits it; `None` for a load.
    pub(crate) joint: Option<BodyJoint>,
}

impl BodyForce {
    /// Creates a load that acts at a point.
    pub(crate) fn load(name: impl Into<String>, force: Vec2, at: Option<Vec2>) -> BodyForce {
        BodyForce {
            name: name.into(),
            force,
            at,
            couple: 0.0,
            joint: None,
        }
    }
}

/// The joint that transmits a force to a link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BodyJoint {
    /// A pin.
    Pin(PointId),
    /// A guide; the force acts on its slider or on its carrier.
    Guide(SlideId),
    /// The driver.
    Driver,
}

/// Returns all forces on a link, without inertia; `None` if one is indeterminate.
pub(crate) fn on_link(
    context: &Context<'_>,
    id: LinkId,
    acted: &[LoadAction],
) -> Option<Vec<BodyForce>> {
    let about = context.scene.mechanism.link(id).members.first()?.point;
    let body = FreeBody {
        context,
        id,
        acted,
        about,
    };
    body.rows()
}

/// Writes the forces on a link, and its three equations with numbers. Returns `false` if a force is
/// indeterminate.
pub(crate) fn free_body(
    context: &Context<'_>,
    draft: &mut Draft,
    id: LinkId,
    acted: &[LoadAction],
) -> bool {
    let link = context.scene.mechanism.link(id);
    let name = context.scene.link_name(id);
    // Moments are about the centre of mass, or else about the first point of the link.
    let first = link.members.first().map(|member| member.point);
    let Some(about) = link.com.or(first) else {
        return true;
    };
    let body = FreeBody {
        context,
        id,
        acted,
        about,
    };
    let Some(rows) = body.rows() else {
        return false;
    };
    draft.section(words().link_part(name));
    let [_, reach] = body.sizes(&rows);
    let moment = format!("{} [N m]", words().moment());
    let contributions = (body.moments(), reach, moment.as_str());
    table(
        context,
        draft,
        words().on_it().into(),
        rows.iter(),
        contributions,
    );
    let point = point_name(context, about);
    draft.text(match body.acceleration() {
        Some(_) => words().motion_about_accelerated(point),
        None => words().motion_about(point),
    });
    body.equations(draft, &rows);
    true
}

/// An equation of motion with its numbers.
struct EquationOfMotion {
    values: Vec<f64>,
    /// The maximum absolute value of a term.
    size: f64,
    /// The right-hand side.
    motion: Expression,
    unit: &'static str,
}

/// A link, and the data for its forces.
struct FreeBody<'a> {
    context: &'a Context<'a>,
    id: LinkId,
    acted: &'a [LoadAction],
    /// The reference point of moments.
    about: PointId,
}

impl FreeBody<'_> {
    /// Returns the sum of moments about the reference point.
    fn moments(&self) -> BalanceKind {
        BalanceKind::About(self.context.state.position(self.about))
    }

    /// Returns the maximum force, and the maximum moment of a force at its arm, or of a couple.
    fn sizes(&self, rows: &[BodyForce]) -> [f64; 2] {
        let metres = self.mechanism().metres();
        let centre = self.context.state.position(self.about);
        rows.iter().fold([0.0_f64; 2], |[force, moment], row| {
            let size = row.force.norm();
            let reach = row.at.map_or(0.0, |at| (at - centre).norm()) * metres;
            let own = (reach * size).max(row.couple.abs());
            [force.max(size), moment.max(own)]
        })
    }

    /// Returns the acceleration of the centre of mass in m/s^2; `None` for a link without mass, or
    /// if the acceleration is zero.
    fn acceleration(&self) -> Option<Vec2> {
        let a = self.context.state.acceleration(self.about) * self.mechanism().metres();
        (self.mechanism().link(self.id).mass > 0.0 && a.norm() > 0.0).then_some(a)
    }

    /// Writes the sums of forces and moments, equal to the link's inertia terms.
    fn equations(&self, draft: &mut Draft, rows: &[BodyForce]) {
        let (f, state) = (self.context.figures, self.context.state);
        let link = self.mechanism().link(self.id);
        let a = state.acceleration(self.about) * self.mechanism().metres();
        let [largest, reach] = self.sizes(rows);
        // The acceleration that the largest force alone would cause; smaller components may be
        // rounding errors.
        let size_of_a = match link.mass > 0.0 {
            true => a.norm().max(largest / link.mass),
            false => a.norm(),
        };
        if let Some(a) = self.acceleration() {
            let (length, direction) = (a.norm(), crate::angle::degrees(a));
            for (axis, function) in [("x", Function::Cos), ("y", Function::Sin)] {
                let at = Expression::figure(f.direction(direction), direction);
                let along =
                    Expression::figure(f.number(length), length) * Expression::of(function, [at]);
                draft.write_numbers(Symbol::indexed("a", axis), &along, |v| {
                    Formula::measured(f.format_or_zero(v, size_of_a), "m/s^2")
                });
            }
        }
        let force = |axis: &str, a_axis: f64, values: Vec<f64>| EquationOfMotion {
            values,
            size: largest,
            motion: f.as_given("m", link.mass)
                * f.rounded(Symbol::indexed("a", axis), a_axis, size_of_a),
            unit: "N",
        };
        let alpha = state.alpha(self.id);
        let turning = EquationOfMotion {
            values: rows
                .iter()
                .map(|row| self.moments().of(self.context, row))
                .collect(),
            size: reach,
            motion: f.as_given("I", link.inertia) * f.computed("α", alpha),
            unit: "N m",
        };
        let x = force("x", a.x, rows.iter().map(|row| row.force.x).collect());
        let y = force("y", a.y, rows.iter().map(|row| row.force.y).collect());
        for balance in [x, y, turning] {
            self.write(draft, balance);
        }
    }

    /// Writes `12.5 - 3.2 = m ax = 2*4.65 = 9.3 N`; without mass the sum is 0.
    fn write(&self, draft: &mut Draft, balance: EquationOfMotion) {
        let f = self.context.figures;
        let (size, value) = (balance.size, balance.motion.value());
        let sum = f.sum(balance.values.iter().copied(), size).numbers();
        let name = self.context.scene.link_name(self.id);
        let symbols = balance.motion.symbols();
        let symbol = words().symbols_of(&symbols, name);
        let computed = balance.values.iter().sum();
        draft.agree(&symbol, computed, value, size.max(value.abs()));
        let right = Formula::measured(f.format_or_zero(value, size), balance.unit);
        let link = self.mechanism().link(self.id);
        if link.mass > 0.0 || link.inertia > 0.0 {
            let sides = [sum, symbols, balance.motion.numbers(), right];
            draft.equation(sides);
        } else {
            draft.equation([sum, right]);
        }
    }

    /// Returns all forces on the link; `None` if one is indeterminate.
    fn rows(&self) -> Option<Vec<BodyForce>> {
        let mut rows = Vec::new();
        self.members(&mut rows)?;
        self.slides(&mut rows)?;
        self.couples(&mut rows);
        Some(rows)
    }

    fn mechanism(&self) -> &Mechanism {
        &self.context.scene.mechanism
    }

    /// Adds forces of pins, loads, and the weight; returns `None` if one is indeterminate.
    fn members(&self, rows: &mut Vec<BodyForce>) -> Option<()> {
        let (context, state) = (self.context, self.context.state);
        let mechanism = self.mechanism();
        let link = mechanism.link(self.id);
        for member in &link.members {
            let point = member.point;
            let label = point_name(context, point);
            let at = Some(state.position(point));
            if is_joint(mechanism, point) {
                let force = state.joint_force(self.id, point)?;
                let name = pin_name(context, self.id, point);
                rows.push(BodyForce {
                    joint: Some(BodyJoint::Pin(point)),
                    ..BodyForce::load(name, force, at)
                });
                continue;
            }
            for (_, force) in self
                .acted
                .iter()
                .filter(|a| a.on.is_none())
                .flat_map(|a| &a.forces)
                .filter(|(p, _)| *p == point)
            {
                let name = words().acts_at(words().column_load(), label);
                rows.push(BodyForce::load(name, *force, at));
            }
        }
        for acted in self.acted.iter().filter(|a| a.on == Some(self.id)) {
            for &(point, force) in &acted.forces {
                let at = Some(state.position(point));
                rows.push(BodyForce::load(words().kind_press(), force, at));
            }
        }
        let weight = mechanism.gravity() * link.mass;
        if let (Some(com), true) = (link.com, weight != Vec2::ZERO) {
            let at = Some(state.position(com));
            rows.push(BodyForce::load(words().weight(), weight, at));
        }
        Some(())
    }

    /// Adds the forces of its own guides, and of the guides that it carries; returns `None` if one
    /// is indeterminate.
    fn slides(&self, rows: &mut Vec<BodyForce>) -> Option<()> {
        let mechanism = self.mechanism();
        for slide in mechanism.slide_ids() {
            let given = mechanism.slide(slide);
            let slides = matches!(given.slider, Slider::Link { link, .. } if link == self.id);
            let carries = given.on == Body::Link(self.id);
            if slides {
                rows.push(guided(self.context, slide, 1.0)?);
            }
            if carries {
                rows.push(guided(self.context, slide, -1.0)?);
            }
        }
        Some(())
    }

    /// Adds torques, including the driver's.
    fn couples(&self, rows: &mut Vec<BodyForce>) {
        let couples = self.acted.iter().flat_map(|a| &a.couples);
        let own = couples.filter(|(link, _)| *link == self.id);
        let mut add = |name: &str, couple: f64, joint: Option<BodyJoint>| {
            rows.push(BodyForce {
                couple,
                joint,
                ..BodyForce::load(name, Vec2::ZERO, None)
            });
        };
        own.for_each(|(_, couple)| add(words().torque(), *couple, None));
        for (input, sign) in self.mechanism().torques_on(self.id) {
            if let Some(torque) = self.context.state.effort(input) {
                add(words().driver(), torque * sign, Some(BodyJoint::Driver));
            }
        }
    }
}

/// Returns the force of a guide on its slider for sign 1, or the reaction for -1; `None` if it is
/// indeterminate.
pub(crate) fn guided(context: &Context<'_>, slide: SlideId, sign: f64) -> Option<BodyForce> {
    let (state, mechanism) = (context.state, &context.scene.mechanism);
    let given = mechanism.slide(slide);
    let t = state.travel(slide).guide;
    let mut force = t.perp() * state.normal(slide)?;
    if mechanism.is_pushed(slide) {
        force += t * state.effort(Input::Push(slide))?;
    }
    let couple = match given.slider {
        Slider::Pin(_) => 0.0,
        Slider::Link { .. } => state.moment(slide)?,
    };
    let name = context.scene.slide_name(slide);
    let name = match sign > 0.0 {
        true => words().guide_of(name),
        false => words().slider_of(name),
    };
    let at = Some(state.position(given.slider.point()));
    Some(BodyForce {
        couple: couple * sign,
        joint: Some(BodyJoint::Guide(slide)),
        ..BodyForce::load(name, force * sign, at)
    })
}

/// Returns the name of the force on a link at a pin. It includes the other body if there is only
/// one and the pin has no load.
pub(crate) fn pin_name(context: &Context<'_>, link: LinkId, point: PointId) -> String {
    let by = context.scene.mechanism.partner(link, point);
    let (name, at) = (context.scene.link_name(link), point_name(context, point));
    match by {
        Some(Body::Link(other)) => words().pin_by(name, at, context.scene.link_name(other)),
        Some(Body::Ground) => words().pin_by_ground(name, at),
        None => words().acts_at(name, at),
    }
}

/// Returns `true` if the point joins the link to something else.
pub(crate) fn is_joint(mechanism: &Mechanism, id: PointId) -> bool {
    let point = mechanism.point(id);
    let slides = mechanism
        .slides()
        .iter()
        .filter(|s| s.slider.point() == id)
        .count();
    point.links.len() + usize::from(point.ground.is_some()) + slides >= 2
}

/// Returns the maximum moment (N m) of a force on any link, or for a driven slide the maximum force
/// (N). The driver's effort may be a small difference of such values.
pub(crate) fn largest(context: &Context<'_>, acted: &[LoadAction]) -> f64 {
    let mechanism = &context.scene.mechanism;
    let sizes = mechanism.link_ids().filter_map(|id| {
        let link = mechanism.link(id);
        let about = link.members.first()?.point;
        let body = FreeBody {
            context,
            id,
            acted,
            about,
        };
        let [force, moment] = body.sizes(&body.rows()?);
        Some(match mechanism.driver().input {
            Input::Turn(_) => moment,
            Input::Push(_) => force,
        })
    });
    sizes.fold(0.0, f64::max)
}
