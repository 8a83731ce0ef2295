//! Lists the assemblies of every group at the driver's coordinate.

use crate::ElementId;
use crate::assembly::pick_text;
use crate::drawing::Extents;
use crate::report::fixed;
use crate::solver::{Choice, GroupId, State};
use crate::tui::commands::list::List;
use crate::tui::player::open_scene::OpenScene;
use crate::wording::words;

/// Significant digits of coordinates in the list: a tenth of the reading accuracy of a drawing.
const DIGITS: f64 = 4.0;
/// Maximum number of groups in the list.
const MAX_GROUPS: usize = 64;

/// An assembly of one group.
#[derive(Debug)]
pub(crate) struct AssemblyRow {
    /// The group's id in the plan, and its name.
    pub(crate) group: GroupId,
    pub(crate) name: String,
    /// The position of the group's point or the angle of its link in this assembly, as text.
    pub(crate) place: String,
    pub(crate) choice: Choice,
}

impl AssemblyRow {
    /// Formats the choice as on the command line: `C=-`.
    pub(crate) fn option_text(&self) -> String {
        format!("{}={}", self.name, pick_text(self.choice.pick))
    }
}

/// The assemblies of all groups.
#[derive(Debug)]
pub(crate) struct AssemblyList {
    pub(crate) list: List<AssemblyRow>,
    /// The extents of the linkage with all its ghosts.
    pub(crate) reach: Extents,
}

impl AssemblyList {
    /// Computes the assemblies of all groups at the driver's coordinate; `None` if no group has a
    /// choice. The cursor is on the first one that closes and is not the current one.
    pub(crate) fn new(open_scene: &OpenScene) -> Option<AssemblyList> {
        let (scene, solver) = (open_scene.scene(), open_scene.solver());
        let (at, extents) = (open_scene.at(), open_scene.extents());
        let groups = solver.plan().numbered();
        let groups = groups.filter(|(_, g)| g.has_choices()).take(MAX_GROUPS);
        let mut rows = Vec::new();
        for (number, group) in groups {
            for choice in solver.choices(at, number) {
                let place = match group.name() {
                    Some(ElementId::Point(point)) => {
                        let p = choice.state.known().position(point);
                        let decimals = decimals(extents);
                        let [x, y] = [p.x, p.y].map(|v| figure(v, decimals));
                        format!("({x}, {y})")
                    }
                    Some(ElementId::Link(link)) => {
                        words().degrees(&figure(choice.state.known().angle(link), 2))
                    }
                    Some(ElementId::Slide(_) | ElementId::Driver) | None => String::new(),
                };
                let name = scene.group_name(group).to_owned();
                rows.push(AssemblyRow {
                    group: number,
                    name,
                    place,
                    choice,
                });
            }
        }
        let others = rows.iter().filter(|row| row.choice.closes);
        let extents = extents.with(scene, others.map(|row| &row.choice.state));
        let mut list = List::new(rows);
        list.go_to(|row| !row.choice.is_current && row.choice.closes);
        list.chosen()?;
        Some(AssemblyList {
            list,
            reach: extents,
        })
    }

    /// Returns the states to draw as ghosts: the assembly under the cursor, or all others of its
    /// group if that is the current one.
    pub(crate) fn ghosts(&self) -> impl Iterator<Item = &State> {
        let (chosen, cursor) = (self.list.chosen(), self.list.cursor());
        let at_present = chosen.is_none_or(|row| row.choice.is_current);
        let rows = self.list.listed().enumerate();
        let shown = rows.filter(move |(i, row)| {
            let same = chosen.is_some_and(|c| c.group == row.group);
            let intended = *i == cursor || (at_present && same);
            intended && row.choice.closes && !row.choice.is_current
        });
        shown.map(|(_, row)| &row.choice.state)
    }
}

/// Formats a number with `decimals` decimals, or in exponential notation if it is too wide.
fn figure(value: f64, decimals: usize) -> String {
    if value.abs() < 1e9 {
        fixed(value, decimals)
    } else {
        format!("{value:.3e}")
    }
}

/// Returns the number of decimals that shows four digits of the largest coordinates.
fn decimals(extents: &Extents) -> usize {
    let bounds = extents.bounds();
    let largest = bounds.low.norm().max(bounds.high.norm());
    let digits = largest.log10().floor() + 1.0;
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "between 0 and 9"
    )]
    let decimals = (DIGITS - digits).clamp(0.0, 9.0) as usize;
    decimals
}
