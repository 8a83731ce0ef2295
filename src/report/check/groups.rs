//! Facts on the groups in solution order, and on their possible assemblies where the scene opens.

use super::{CheckedScene, Fact};
use crate::assembly::pick_text;
use crate::report::text::number::concise;
use crate::solver::{Assemblies, AssemblyChoice, Choice, Group, GroupId, GroupKind};
use crate::wording::words;
use serde_json::{Map, Value, json};

/// Significant digits of coordinates, as for start positions.
const DIGITS: usize = 6;
/// Coordinates below this fraction of the largest one are rounding errors of zero.
const NOUGHT: f64 = 1e-13;
/// Maximum number of groups whose assemblies are listed.
const MAX_GROUPS: usize = 64;

impl CheckedScene<'_> {
    pub(super) fn groups(&self) -> Fact {
        let groups = self.solver.plan().groups.iter().zip(1..);
        let items = groups.map(|(group, number): (_, usize)| {
            let points = group.points.iter();
            let points = points.filter_map(|&point| self.scene.point_name(point));
            let coupled = match group.kind {
                GroupKind::Driver => "driver",
                _ => "coupled",
            };
            let value = json!({
                "kind": group.kind.class().unwrap_or(coupled),
                "point": group.point.and_then(|point| self.scene.point_name(point)),
                "unknowns": group.kind.unknowns(),
                "links": self.link_names(group.links.iter().copied()),
                "points": points.collect::<Vec<_>>(),
            });
            (value, [format!("{number}. {}", self.group_text(group))])
        });
        Fact::each(words().fact_groups(), "groups", items)
    }

    fn group_text(&self, group: &Group) -> String {
        let at = group.point.and_then(|point| self.scene.point_name(point));
        let (what, how) = match (group.kind.class(), group.kind.unknowns()) {
            (Some(class), _) => {
                let dyad = match at {
                    Some(point) => words().dyad_at(class, point),
                    None => words().dyad(class),
                };
                (dyad, words().closed_form())
            }
            (None, Some(unknowns)) => {
                let coupled = match at {
                    Some(point) => words().coupled_group_at(point, unknowns),
                    None => words().coupled_group(unknowns),
                };
                (coupled, words().by_newton())
            }
            (None, None) => return words().group_of_driver(&self.driven()),
        };
        match self.link_names(group.links.iter().copied()).as_slice() {
            [] => words().group_of_nothing(&what, how),
            [link] => words().group_of_link(&what, link, how),
            links => words().group_of_links(&what, &links.join(", "), how),
        }
    }

    /// Returns the groups with several assemblies.
    fn with_choices(&self) -> impl Iterator<Item = (GroupId, &Group)> {
        let groups = self.solver.plan().numbered();
        groups.filter(|(_, group)| group.has_choices())
    }

    pub(super) fn choices(&self) -> Fact {
        let start = self.solver.mechanism().driver().start;
        let listed = self.with_choices().take(MAX_GROUPS);
        let listed = listed.map(|(id, group)| (group, self.solver.choices(start, id)));
        let groups: Vec<(&Group, Vec<Choice>)> = listed.collect();
        let all = groups.iter();
        let places = all.flat_map(|(group, all)| all.iter().filter_map(|one| place(group, one)));
        let largest = places.flatten().map(f64::abs).fold(0.0, f64::max);
        let items = groups.iter().map(|(group, choices)| {
            let name = self.scene.group_name(group);
            let texts = choices
                .iter()
                .map(|choice| choice_text(group, choice, largest));
            let text = format!("{name}: {}", texts.collect::<Vec<_>>().join(", "));
            let list = choices.iter().map(|choice| choice_json(group, choice));
            (
                json!({"group": name, "list": list.collect::<Vec<_>>()}),
                [text],
            )
        });
        let unlisted = self.with_choices().count() - groups.len();
        let more = (unlisted > 0).then(|| words().those_of_more(unlisted));
        Fact::each(words().fact_choices(), "choices", items).lines(more)
    }

    /// Returns the fact on the assemblies of the whole mechanism.
    pub(super) fn assemblies(&self) -> Fact {
        let all = (self.solver).assemblies(self.solver.mechanism().driver().start);
        let named = |&(group, pick): &(GroupId, AssemblyChoice)| {
            let name = self.scene.group_name(self.solver.plan().group(group)?);
            Some((name, pick_text(pick)))
        };
        let list = all.list.iter();
        let list = list.map(|picks| picks.iter().filter_map(named).collect());
        let list: Vec<Vec<(&str, String)>> = list.collect();
        let object = |picks: &Vec<(&str, String)>| {
            let pairs = picks.iter();
            let pairs = pairs.map(|(group, pick)| ((*group).to_owned(), pick.as_str().into()));
            Value::Object(pairs.collect::<Map<_, _>>())
        };
        let objects: Vec<Value> = list.iter().map(object).collect();
        let value = json!({"complete": all.is_complete, "current": all.current, "list": objects});
        // The assemblies of a single group are its choices.
        let text = (self.with_choices().nth(1)).map(|_| assemblies_text(&all, &list));
        let fact = Fact::new(words().fact_assemblies());
        fact.lines(text).value("assemblies", value)
    }
}

/// Formats the whole assemblies as arguments of `--assembly`.
fn assemblies_text(all: &Assemblies, list: &[Vec<(&str, String)>]) -> String {
    if !all.is_complete {
        return words().more_than(list.len());
    }
    let texts = list.iter().enumerate().map(|(number, picks)| {
        let picks: Vec<String> = picks.iter().map(|(g, p)| format!("{g}={p}")).collect();
        match all.current == Some(number) {
            true => words().chosen_now(&picks.join(",")),
            false => picks.join(","),
        }
    });
    format!("{}: {}", list.len(), texts.collect::<Vec<_>>().join("; "))
}

/// Returns the position of the point after which the group is named.
fn place(group: &Group, choice: &Choice) -> Option<[f64; 2]> {
    let point = group.point.filter(|_| group.kind != GroupKind::Rpr)?;
    let at = choice.state.position(point)?;
    Some([at.x + 0.0, at.y + 0.0])
}

/// Returns the direction in deg of the link after which the group is named.
fn direction(group: &Group, choice: &Choice) -> Option<f64> {
    let arm = group
        .links
        .first()
        .filter(|_| group.kind == GroupKind::Rpr)?;
    choice.state.angle(*arm)
}

fn choice_json(group: &Group, choice: &Choice) -> Value {
    json!({
        "choice": pick_text(choice.pick),
        "current": choice.is_current,
        "closes": choice.closes,
        "at": place(group, choice),
        "angle": direction(group, choice),
    })
}

fn choice_text(group: &Group, choice: &Choice, largest: f64) -> String {
    let figure = |v: f64| match v.abs() <= NOUGHT * largest {
        true => "0".into(),
        false => concise(v, DIGITS),
    };
    let pick = pick_text(choice.pick);
    let text = match (place(group, choice), direction(group, choice)) {
        (Some([x, y]), _) => words().at_place(&pick, &figure(x), &figure(y)),
        (None, Some(angle)) => words().at_degrees(&pick, &concise(angle, DIGITS)),
        (None, None) => pick,
    };
    match (choice.is_current, choice.closes) {
        (true, _) => words().chosen_now(&text),
        (false, true) => text,
        (false, false) => words().rest_open(&text),
    }
}
