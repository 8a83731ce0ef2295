//! The assemblies of every group where the driver stands: what there is to choose from.

use crate::ElementId;
use crate::assembly::pick_text;
use crate::drawing::Reach;
use crate::scene::Scene;
use crate::solver::{Choice, GroupId, Solver, State};
use crate::wording::words;

/// Digits of places in the list: a tenth of what a person reads off a drawing.
const DIGITS: f64 = 4.0;
/// Groups in the list, at the most.
const MOST_GROUPS: usize = 64;

/// An assembly of one group.
#[derive(Debug)]
pub(crate) struct AssemblyRow {
    /// The group in the plan, and what it is called.
    pub(crate) group: GroupId,
    pub(crate) name: String,
    /// Where it would be, in words.
    pub(crate) place: String,
    pub(crate) choice: Choice,
}

impl AssemblyRow {
    /// `C=-`, as the command line has it.
    pub(crate) fn wish(&self) -> String {
        format!("{}={}", self.name, pick_text(self.choice.pick))
    }
}

/// The list of assemblies.
#[derive(Debug)]
pub(crate) struct AssemblyList {
    rows: Vec<AssemblyRow>,
    reach: Reach,
}

impl AssemblyList {
    /// Searches for them; `None` where there is nothing to choose.
    pub(crate) fn new(
        scene: &Scene,
        solver: &Solver,
        at: f64,
        reach: &Reach,
    ) -> Option<AssemblyList> {
        let groups = solver.plan().numbered();
        let groups = groups.filter(|(_, g)| g.has_choices()).take(MOST_GROUPS);
        let mut rows = Vec::new();
        for (number, group) in groups {
            for choice in solver.choices(at, number) {
                let place = match group.name() {
                    Some(ElementId::Point(point)) => {
                        let p = choice.state.known().position(point);
                        let decimals = decimals(reach);
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
        let reach = reach.with(scene, others.map(|row| &row.choice.state));
        (!rows.is_empty()).then_some(AssemblyList { rows, reach })
    }

    pub(crate) fn rows(&self) -> &[AssemblyRow] {
        &self.rows
    }

    /// The space that the linkage needs with all its ghosts.
    pub(crate) fn reach(&self) -> &Reach {
        &self.reach
    }

    /// Where to begin: at the first assembly that is not the present one, and could be.
    pub(crate) fn first(&self) -> usize {
        let other = |row: &AssemblyRow| !row.choice.is_current && row.choice.closes;
        self.rows.iter().position(other).unwrap_or(0)
    }

    /// What is shown beside the linkage: the assembly under the cursor, or where that is the present
    /// one, all others of its group.
    pub(crate) fn ghosts(&self, cursor: usize) -> impl Iterator<Item = &State> {
        let chosen = self.rows.get(cursor);
        let at_present = chosen.is_none_or(|row| row.choice.is_current);
        let rows = self.rows.iter().enumerate();
        let shown = rows.filter(move |(i, row)| {
            let same = chosen.is_some_and(|c| c.group == row.group);
            let meant = *i == cursor || (at_present && same);
            meant && row.choice.closes && !row.choice.is_current
        });
        shown.map(|(_, row)| &row.choice.state)
    }
}

/// A figure with so many decimals; one that does not fit the screen that way takes an exponent.
fn figure(value: f64, decimals: usize) -> String {
    if value.abs() < 1e9 {
        let text = format!("{value:.decimals$}");
        // What rounds to nothing has no sign.
        let is_zero = text.bytes().all(|b| matches!(b, b'-' | b'0' | b'.'));
        let unsigned = text.strip_prefix('-').filter(|_| is_zero);
        unsigned.unwrap_or(&text).to_owned()
    } else {
        format!("{value:.3e}")
    }
}

/// As many decimals as show four digits of the largest places.
fn decimals(reach: &Reach) -> usize {
    let bounds = reach.bounds();
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
