//! Search keywords of commands: words that users try and that a command's name and help lack.

use super::action::{Action, PlotsAction, SceneAction};
use super::view::View;
use crate::wording::{Wording, Words, words};

type W = dyn Words;

const KEYWORDS: [(Action, Wording); 9] = [
    (Action::Open, W::open_is_sought_by),
    (Action::Assemblies, W::assemblies_are_sought_by),
    (Action::Undo, W::undo_is_sought_by),
    (Action::Look(View::Scene), W::scene_is_sought_by),
    (Action::Look(View::Lengths), W::lengths_are_sought_by),
    (Action::Look(View::Motor), W::motor_is_sought_by),
    (
        Action::Plots(PlotsAction::Choose),
        W::choosing_plots_is_sought_by,
    ),
    (
        Action::Scene(SceneAction::Gather),
        W::gathering_is_sought_by,
    ),
    (Action::Scene(SceneAction::Goal), W::goal_is_sought_by),
];

/// Returns the keywords of an action, separated by blanks; empty for most actions.
pub(crate) fn keywords(action: Action) -> &'static str {
    let found = KEYWORDS.iter().find(|(of, _)| *of == action);
    found.map_or("", |(_, wording)| wording(words()))
}
