//! Draws the free-body diagram of a link.

use super::figure::{Figure, Role, Shape};
use super::motion::extents::Extents;
use super::motion::force_arrows::rounded;
use super::outline::{self, Corner};
use super::roles::{link_roles, roles};
use crate::scene::Scene;
use crate::solver::State;
use crate::{LinkId, Vec2};

/// A force or a couple on a link.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeForce {
    /// The name, one word.
    pub name: String,
    /// The point of application; `None` for a couple.
    pub at: Option<Vec2>,
    /// The force in N, in the ground's frame.
    pub force: Vec2,
    /// The couple in N m, counter-clockwise.
    pub couple: f64,
}

impl FreeForce {
    /// Returns the label: `B 127 N`, `r4 35.1 N, 2.10 N m`.
    ///
    /// Sizes of parts too small to be drawn are left out.
    fn label_text(&self, [pushes, is_rotary]: [bool; 2]) -> String {
        let sizes = [
            (pushes, self.force.norm(), "N"),
            (is_rotary, self.couple.abs(), "N m"),
        ];
        let sizes = sizes.into_iter().filter(|(is_drawn, ..)| *is_drawn);
        let sizes: Vec<String> = sizes
            .map(|(_, size, unit)| format!("{} {unit}", rounded(size)))
            .collect();
        format!("{} {}", self.name, sizes.join(", "))
    }
}

/// Length of the longest arrow, as a fraction of the link's size.
const MAX_LEN: f64 = 0.55;
/// Minimum length of an arrow, as a fraction of the longest. A shorter arrow would be hidden under
/// the mark of its point.
const MIN_LEN: f64 = 0.2;
/// The fraction of the largest force or moment below which a value is not drawn: rounding error, or
/// too short to be visible.
const MIN_VISIBLE_FORCE: f64 = 1e-3;

/// Returns the figure of a link with the forces on it, and its extents. The longest arrow is about
/// half as long as the link. Returns `None` without an assembly, and if no force acts.
#[must_use]
pub fn free_body(
    scene: &Scene,
    state: &State,
    link: LinkId,
    forces: &[FreeForce],
) -> Option<(Figure, Extents)> {
    let mechanism = &scene.mechanism;
    let roles = roles(mechanism);
    let given = mechanism.link(link);
    let mut figure = Figure::new();
    let mut positions = Vec::new();
    let mut corners = Vec::new();
    for member in &given.members {
        let at = state.position(member.point)?;
        positions.push(at);
        if given.com != Some(member.point) {
            let block = roles[member.point.index()] == Role::Slider;
            corners.push(Corner { at, block });
        }
    }
    let role = link_roles(mechanism)[link.index()];
    outline::draw(&mut figure, &corners, role, role.of_plate());
    for (member, &at) in given.members.iter().zip(&positions) {
        let role = match given.com == Some(member.point) {
            true => Role::CentreOfMass,
            false => Role::Joint,
        };
        figure.add(Shape::Mark { at, role });
    }
    arrows(&mut figure, &mut positions, forces)?;
    let name = scene.link_name(link).to_owned();
    let at = middle(&corners)?;
    let role = link_roles(mechanism)[link.index()].of_name();
    figure.add(Shape::Label {
        at,
        text: name,
        role,
    });
    let extents = Extents::of_places(&positions, &[]);
    Some((figure, extents))
}

/// Adds an arrow for every force and every couple; appends the outer ends of the arrows to
/// `positions`. Returns `None` if all forces are zero or if one is not finite.
fn arrows(figure: &mut Figure, positions: &mut Vec<Vec2>, forces: &[FreeForce]) -> Option<()> {
    let middle = positions.iter().fold(Vec2::ZERO, |sum, &at| sum + at) / positions.len() as f64;
    let size = positions
        .iter()
        .map(|&at| (at - middle).norm())
        .fold(0.0, f64::max);
    // A link of one point has no length of its own.
    let size = if size > 0.0 { 2.0 * size } else { 1.0 };
    let largest = |of: fn(&FreeForce) -> f64| forces.iter().map(of).fold(0.0, f64::max);
    let (maximum, most_couple) = (largest(|f| f.force.norm()), largest(|f| f.couple.abs()));
    if !(maximum.is_finite() && most_couple.is_finite() && maximum + most_couple > 0.0) {
        return None;
    }
    let role = Role::Force;
    for one in forces {
        let at = one.at.unwrap_or(middle);
        let mut outer = at;
        if one.force.norm() > MIN_VISIBLE_FORCE * maximum {
            let share = (one.force.norm() / maximum).max(MIN_LEN);
            let arrow = one.force * (MAX_LEN * size * share / one.force.norm());
            // A force that pushes into the link ends at its point, and one that pulls begins there,
            // so that neither covers the link.
            let pushes = arrow.dot(middle - at) > 0.0;
            outer = if pushes { at - arrow } else { at + arrow };
            let (from, to) = if pushes { (outer, at) } else { (at, outer) };
            let cut = false;
            figure.add(Shape::Arrow {
                from,
                to,
                role,
                cut,
            });
            positions.push(outer);
        }
        let is_rotary = one.couple.abs() > MIN_VISIBLE_FORCE * most_couple;
        if is_rotary {
            let is_left = one.couple > 0.0;
            figure.add(Shape::Moment { at, is_left });
        }
        if is_rotary || outer != at {
            let text = one.label_text([outer != at, is_rotary]);
            let at = outer;
            figure.add(Shape::Label { at, text, role });
        }
    }
    Some(())
}

fn middle(corners: &[Corner]) -> Option<Vec2> {
    let sum = corners
        .iter()
        .fold(Vec2::ZERO, |sum, corner| sum + corner.at);
    (!corners.is_empty()).then(|| sum / corners.len() as f64)
}
