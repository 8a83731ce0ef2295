//! Assemblies by name: finds the groups of named choices, and writes the start of an assembly.

use crate::nearest::did_you_mean;
use crate::scene::{Precision, Scene};
use crate::solver::{AssemblyChoice, Condition, Group, GroupKind, Order, Plan, Solver, State};
use crate::wording::words;
use crate::{ElementId, Input, PointId, Slider, Vec2};
use std::fmt;
use std::str::FromStr;

/// A named choice of an assembly, such as `C=-`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AssemblyRequest {
    /// The group's name.
    pub group: String,
    /// The choice.
    pub pick: AssemblyChoice,
}

/// The error for an invalid choice of an assembly.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum AssemblyError {
    /// The text does not have the right form.
    #[error("{}", words().how_wishes_are_written())]
    Form,
    /// There is no group of this name.
    #[error("{}", words().no_group_with_choice(name, fix))]
    Unknown {
        /// The name in the text.
        name: String,
        /// The probable name, or all names.
        fix: String,
    },
    /// The choice is a number for a dyad, or a sign for a coupled group.
    #[error("{}", words().chosen_by(name, options))]
    Kind {
        /// The group.
        name: String,
        /// The valid choices.
        options: String,
    },
    /// The group occurs twice.
    #[error("{}", words().group_given_twice(name))]
    Twice {
        /// The group.
        name: String,
    },
}

impl FromStr for AssemblyRequest {
    type Err = AssemblyError;

    fn from_str(text: &str) -> Result<AssemblyRequest, AssemblyError> {
        let (group, pick) = text.split_once('=').ok_or(AssemblyError::Form)?;
        let pick = match pick.trim() {
            "+" => AssemblyChoice::Plus,
            "-" => AssemblyChoice::Minus,
            number => match number.parse() {
                Ok(n) if n > 0 => AssemblyChoice::Number(n),
                _ => return Err(AssemblyError::Form),
            },
        };
        let group = group.trim().to_owned();
        if group.is_empty() {
            return Err(AssemblyError::Form);
        }
        Ok(AssemblyRequest { group, pick })
    }
}

impl fmt::Display for AssemblyRequest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}={}", self.group, pick_text(self.pick))
    }
}

/// Formats a choice: `+`, `-` or a number.
#[must_use]
pub fn pick_text(choice: AssemblyChoice) -> String {
    match choice {
        AssemblyChoice::Plus => "+".to_owned(),
        AssemblyChoice::Minus => "-".to_owned(),
        AssemblyChoice::Number(n) => n.to_string(),
    }
}

/// Maximum number of group names in a message.
const MAX_LISTED: usize = 12;

impl Scene {
    /// Returns the name of a group of the plan: that of its point, or that of a link if the point
    /// has none.
    #[must_use]
    pub fn group_name(&self, group: &Group) -> &str {
        let link = || group.links.first().map_or("", |&l| self.link_name(l));
        match group.name() {
            Some(ElementId::Point(point)) => self.name_or_slider(point).unwrap_or_else(link),
            Some(ElementId::Link(link)) => self.link_name(link),
            Some(ElementId::Slide(_) | ElementId::Driver) | None => link(),
        }
    }

    /// Returns a point's name, or that of the sliding link whose hidden origin it is.
    fn name_or_slider(&self, point: PointId) -> Option<&str> {
        let slides = self.mechanism.slides().iter();
        let mut slid = slides.filter_map(|slide| match slide.slider {
            Slider::Link { link, origin, .. } if origin == point => Some(self.link_name(link)),
            Slider::Link { .. } | Slider::Pin(_) => None,
        });
        self.point_name(point).or_else(|| slid.next())
    }

    /// Resolves named choices to elements of the plan.
    ///
    /// # Errors
    /// Returns an error for the first choice that does not fit any group, independent of the
    /// lengths.
    pub fn picks(
        &self,
        plan: &Plan,
        requests: &[AssemblyRequest],
    ) -> Result<Vec<(ElementId, AssemblyChoice)>, AssemblyError> {
        let groups = || plan.groups.iter().filter(|g| g.has_choices());
        let mut choices: Vec<(ElementId, AssemblyChoice)> = Vec::new();
        for request in requests {
            let name = request.group.clone();
            let Some(group) = groups().find(|g| self.group_name(g) == request.group) else {
                let names: Vec<&str> = groups().map(|g| self.group_name(g)).collect();
                let fix = did_you_mean(&name, names.iter().copied());
                let fix = fix.unwrap_or_else(|| listed(&names));
                return Err(AssemblyError::Unknown { name, fix });
            };
            if !suits(request.pick, group) {
                let options = options(&name, group);
                return Err(AssemblyError::Kind { name, options });
            }
            let Some(element) = group.name() else {
                continue;
            };
            if choices.iter().any(|(other, _)| *other == element) {
                return Err(AssemblyError::Twice { name });
            }
            choices.push((element, request.pick));
        }
        Ok(choices)
    }

    /// Returns the scene's text with the `[start]` of the assembly that this solver follows. The
    /// driver's start is kept, or becomes `at` if the motion does not reach it or if it does not
    /// determine the assembly.
    ///
    /// The result has been parsed, opened and compared with that assembly, and all links keep their
    /// dimensions to the last digit. The text stays as it is if only that keeps the dimensions of
    /// links as drawn. Returns `None` if every attempt failed.
    #[must_use]
    pub fn with_start_of(&self, solver: &Solver, at: f64) -> Option<String> {
        let opening = self.mechanism.driver().start;
        [
            (opening, Precision::Rough),
            (opening, Precision::Exact),
            (at, Precision::Rough),
            (at, Precision::Exact),
        ]
        .into_iter()
        .find_map(|(at, precision)| self.started(solver, at, precision))
        .or_else(|| self.opens_alike(solver, at).then(|| self.text().to_owned()))
    }

    /// Returns `true` if this text opens in the assembly that `solver` follows.
    fn opens_alike(&self, solver: &Solver, at: f64) -> bool {
        let Ok(own) = Solver::new(&self.mechanism) else {
            return false;
        };
        let (mut followed, mut found) = (solver.state(), own.state());
        solver.solve(at, Order::Position, &mut followed) == Condition::Ok
            && own.solve(at, Order::Position, &mut found) == Condition::Ok
            && self.agree(&followed, &found)
    }

    /// Returns the scene with another input as its driver: it moves alone, and all others are held
    /// where they are while the present driver is at `at`. The scene opens there, in the assembly
    /// that `solver` follows.
    ///
    /// Returns `None` if `input` is none of the inputs, or if `solver` has no state at `at`.
    #[must_use]
    pub fn led_by(&self, solver: &Solver, input: Input, at: f64) -> Option<Scene> {
        let mut state = solver.state();
        if solver.solve(at, Order::Position, &mut state) == Condition::NoAssembly {
            return None;
        }
        let points = self.mechanism.point_ids();
        let moving = points.filter(|&point| self.mechanism.point(point).ground.is_none());
        let start = moving.filter_map(|point| Some((point, state.position(point)?)));
        self.led_from(start.collect(), input, at)
    }

    /// Returns the text with the `[start]` at one coordinate, checked likewise.
    fn started(&self, solver: &Solver, at: f64, precision: Precision) -> Option<String> {
        let mut state = solver.state();
        if solver.solve(at, Order::Position, &mut state) != Condition::Ok {
            return None;
        }
        let opening = (at != self.mechanism.driver().start).then_some(at);
        let start = self.telling(solver.plan(), &state);
        let text = self.rewritten(&start, opening, precision)?;
        let scene = Scene::parse(&text, self.origin()).ok()?;
        // The dimensions of links as drawn follow from `[start]`.
        let mut links = scene.mechanism.links().iter().zip(self.mechanism.links());
        if links.any(|(new, old)| new.members != old.members) {
            return None;
        }
        scene.opens_alike(solver, at).then_some(text)
    }

    /// Returns the points that distinguish assemblies, and those that `[start]` names already.
    fn telling(&self, plan: &Plan, state: &State) -> Vec<(PointId, Vec2)> {
        let mut points: Vec<PointId> = self.mechanism.start().iter().map(|s| s.0).collect();
        for group in plan.groups.iter().filter(|g| g.has_choices()) {
            let named = |p: &PointId| self.point_name(*p).is_some();
            let placed = group.points.iter().copied().filter(named);
            // A centre of mass is used only if the group has no other named point.
            let (centres, joints): (Vec<_>, Vec<_>) = placed.partition(|&p| self.is_com(p));
            let count = match group.kind {
                GroupKind::Coupled { .. } => usize::MAX,
                _ => 1,
            };
            let placed = if joints.is_empty() { centres } else { joints };
            for point in placed.into_iter().take(count) {
                if !points.contains(&point) {
                    points.push(point);
                }
            }
        }
        points
            .into_iter()
            .filter_map(|p| Some((p, state.position(p)?)))
            .collect()
    }

    fn is_com(&self, point: PointId) -> bool {
        let mut links = self.mechanism.links().iter();
        links.any(|link| link.com == Some(point))
    }

    /// Returns `true` if two states are equal up to rounding errors.
    pub fn agree(&self, one: &State, other: &State) -> bool {
        let (one, other) = (one.known(), other.known());
        let points = || self.mechanism.point_ids();
        let largest = points().map(|p| one.position(p).norm()).fold(0.0, f64::max);
        points()
            .all(|p| (one.position(p) - other.position(p)).norm() <= EQUALITY_TOLERANCE * largest)
    }
}

/// The distance of points below which two states are equal, relative to the largest coordinate. It
/// is far above a coupled group's rounding errors, and far below the difference of two visibly
/// different assemblies.
const EQUALITY_TOLERANCE: f64 = 1e-9;

fn suits(choice: AssemblyChoice, group: &Group) -> bool {
    match (choice, group.kind) {
        (AssemblyChoice::Number(_), GroupKind::Coupled { .. }) => true,
        (AssemblyChoice::Plus | AssemblyChoice::Minus, kind) => {
            !matches!(kind, GroupKind::Coupled { .. })
        }
        (AssemblyChoice::Number(_), _) => false,
    }
}

fn options(name: &str, group: &Group) -> String {
    match group.kind {
        GroupKind::Coupled { .. } => words().chosen_by_number(name),
        _ => words().chosen_by_sign(name),
    }
}

fn listed(names: &[&str]) -> String {
    let shown: Vec<String> = names
        .iter()
        .take(MAX_LISTED)
        .map(|n| format!("`{n}`"))
        .collect();
    let more = names.len() - shown.len();
    match (&shown[..], more) {
        ([], _) => words().no_group_in_scene().to_owned(),
        ([one], 0) => words().the_only_group(one),
        (_, 0) => words().there_are(&shown.join(", ")),
        _ => words().there_are_and_more(&shown.join(", "), more),
    }
}

#[cfg(test)]
mod tests;
