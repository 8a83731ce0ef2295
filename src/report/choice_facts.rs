//! Lists the possible assemblies of each group and of the whole where the scene opens.

use super::number::concise;
use crate::assembly::pick_text;
use crate::scene::Scene;
use crate::solver::{Choice, Group, GroupId, GroupKind, Pick, Solver};
use crate::wording::words;
use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::{Map, Value, json};

/// Significant digits of coordinates, as for start positions.
const DIGITS: usize = 6;
/// Coordinates below this fraction of the largest one are rounding errors of zero.
const NOUGHT: f64 = 1e-13;
/// Maximum number of groups whose assemblies are listed.
const MAX_GROUPS: usize = 64;

/// One assembly of a group.
#[derive(Clone, Debug, serde::Serialize)]
pub struct ChoiceFacts {
    /// The argument of `--assembly`: `+`, `-` or a number.
    pub choice: String,
    /// Whether it is the current assembly.
    pub current: bool,
    /// Whether all other groups can be closed with it.
    pub closes: bool,
    /// The position of the point after which the group is named, `[x, y]` in the scene's unit.
    pub at: Option<[f64; 2]>,
    /// The direction in deg of the link after which the group is named.
    pub angle: Option<f64>,
}

/// The assemblies of a group.
#[derive(Clone, Debug, serde::Serialize)]
pub struct GroupChoices {
    /// The point or link after which the group is named.
    pub group: String,
    /// Its assemblies where the scene opens.
    pub list: Vec<ChoiceFacts>,
}

/// All possible assemblies where the scene opens.
#[derive(Clone, Debug)]
pub struct ChoiceList {
    /// The assemblies of each group.
    pub groups: Vec<GroupChoices>,
    /// The number of groups not listed, because there are too many.
    pub unlisted: usize,
    /// Assemblies of the whole mechanism: for each the names of groups with their choices.
    pub assemblies: Vec<Vec<(String, String)>>,
    /// The index of the current one.
    pub current: Option<usize>,
    /// Whether the list was not truncated. Even then the search may have missed assemblies of
    /// coupled groups.
    pub complete: bool,
}

impl ChoiceList {
    /// Computes the possible assemblies.
    pub(super) fn new(scene: &Scene, solver: &Solver) -> Self {
        let plan = solver.plan();
        let start = solver.mechanism().driver().start;
        let having: Vec<_> = plan.numbered().filter(|(_, g)| g.has_choices()).collect();
        let listed = having.iter().take(MAX_GROUPS);
        let groups = listed.map(|&(number, group)| GroupChoices {
            group: scene.group_name(group).to_owned(),
            list: solver
                .choices(start, number)
                .iter()
                .map(|choice| facts(group, choice))
                .collect(),
        });
        let groups = groups.collect();
        let all = solver.assemblies(start);
        let named = |&(group, pick): &(GroupId, Pick)| {
            let name = scene.group_name(plan.group(group)?);
            Some((name.to_owned(), pick_text(pick)))
        };
        let whole = |picks: &Vec<_>| picks.iter().filter_map(named).collect();
        ChoiceList {
            groups,
            unlisted: having.len().saturating_sub(MAX_GROUPS),
            assemblies: all.list.iter().map(whole).collect(),
            current: all.current,
            complete: all.is_complete,
        }
    }

    /// Formats the choices of the groups, one line each.
    pub(super) fn group_lines(&self) -> Vec<String> {
        let largest = self.largest();
        let lines = self.groups.iter().map(|group| {
            let list = group.list.iter();
            let list: Vec<String> = list.map(|choice| choice_text(choice, largest)).collect();
            format!("{}: {}", group.group, list.join(", "))
        });
        let more = (self.unlisted > 0).then(|| words().those_of_more(self.unlisted));
        lines.chain(more).collect()
    }

    /// Returns the maximum absolute coordinate of all choices.
    fn largest(&self) -> f64 {
        let choices = self.groups.iter().flat_map(|group| &group.list);
        let places = choices.filter_map(|choice| choice.at).flatten();
        places.map(f64::abs).fold(0.0, f64::max)
    }

    /// Formats the whole assemblies as arguments of `--assembly`; `None` if they add nothing to the
    /// groups.
    pub(super) fn whole_text(&self) -> Option<String> {
        if self.groups.len() < 2 {
            return None;
        }
        let count = self.assemblies.len();
        if !self.complete {
            return Some(words().more_than(count));
        }
        let texts = self.assemblies.iter().enumerate().map(|(i, picks)| {
            let picks: Vec<String> = picks.iter().map(|(g, p)| format!("{g}={p}")).collect();
            match self.current == Some(i) {
                true => words().chosen_now(&picks.join(",")),
                false => picks.join(","),
            }
        });
        let texts: Vec<String> = texts.collect();
        Some(format!("{count}: {}", texts.join("; ")))
    }

    /// Returns the whole assemblies as JSON.
    fn whole_json(&self) -> Value {
        let object = |picks: &Vec<(String, String)>| {
            let pairs = picks.iter();
            let pairs = pairs.map(|(g, p)| (g.clone(), Value::from(p.as_str())));
            Value::Object(pairs.collect::<Map<_, _>>())
        };
        let list: Vec<Value> = self.assemblies.iter().map(object).collect();
        json!({ "complete": self.complete, "current": self.current, "list": list })
    }
}

/// Serialized as two keys: `choices` and `assemblies`.
impl Serialize for ChoiceList {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let mut map = to.serialize_map(Some(2))?;
        map.serialize_entry("choices", &self.groups)?;
        map.serialize_entry("assemblies", &self.whole_json())?;
        map.end()
    }
}

fn facts(group: &Group, choice: &Choice) -> ChoiceFacts {
    let arm = group.links.first().filter(|_| group.kind == GroupKind::Rpr);
    let at = group.point.filter(|_| arm.is_none());
    let at = at.and_then(|point| choice.state.position(point));
    ChoiceFacts {
        choice: pick_text(choice.pick),
        current: choice.is_current,
        closes: choice.closes,
        at: at.map(|p| [p.x + 0.0, p.y + 0.0]),
        angle: arm.and_then(|&link| choice.state.angle(link)),
    }
}

fn choice_text(facts: &ChoiceFacts, largest: f64) -> String {
    let figure = |v: f64| match v.abs() <= NOUGHT * largest {
        true => "0".into(),
        false => concise(v, DIGITS),
    };
    let choice = match (facts.at, facts.angle) {
        (Some([x, y]), _) => words().at_place(&facts.choice, &figure(x), &figure(y)),
        (None, Some(angle)) => words().at_degrees(&facts.choice, &concise(angle, DIGITS)),
        (None, None) => facts.choice.clone(),
    };
    match (facts.current, facts.closes) {
        (true, _) => words().chosen_now(&choice),
        (false, true) => choice,
        (false, false) => words().rest_open(&choice),
    }
}
