//! The texts of the tour: five screens that explain krank's display and its keys. They are shown
//! below the panes; the keys of the motion and of the views keep working.

use crate::files::directories;
use crate::page;
use crate::tui::app::View;
use crate::tui::commands::action::Action;
use crate::tui::commands::keymap::Keymap;
use crate::wording::words;
use std::fs::{self, File};
use std::path::PathBuf;

/// Number of screens.
pub(crate) const SCREENS: usize = 5;

/// Name of the file that records that the tour was shown.
const MARK: &str = "tour-shown";

/// A page of the tour: a screen, or a part of one on a small terminal. Both are counted from 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct TourPage {
    pub(crate) screen: usize,
    pub(crate) part: usize,
}

/// A screen of the tour.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct TourScreen {
    pub(crate) title: &'static str,
    /// Text to be wrapped; a line feed begins a paragraph.
    pub(crate) text: String,
}

/// Returns a screen by its index, with the user's keys.
pub(crate) fn screen(number: usize, keymap: &Keymap) -> TourScreen {
    use Action as A;
    let look = |view| keymap.key_label(A::Look(view));
    let key = |action| keymap.key_label(action);
    let (title, text) = match number {
        0 => (
            words().tour_of_the_screen(),
            words().tour_of_the_screen_text().to_owned(),
        ),
        1 => {
            let keys = [
                A::StepForward,
                A::StepBack,
                A::Play,
                A::SmallerStep,
                A::LargerStep,
                A::Slower,
                A::Faster,
                A::Reverse,
                A::GoTo,
                A::Opening,
            ];
            let text = words().tour_of_the_crank_text(&keys.map(key));
            (words().tour_of_the_crank(), text)
        }
        2 => (
            words().tour_of_figures(),
            words().tour_of_figures_text(
                &[
                    View::Motion,
                    View::Tables,
                    View::Plots,
                    View::Accuracy,
                    View::Forces,
                    View::Working,
                    View::Motor,
                    View::Lengths,
                    View::Polygons,
                ]
                .map(look),
            ),
        ),
        3 => (
            words().tour_of_editing(),
            words().tour_of_editing_text(
                &key(A::Open),
                &key(A::NextPreset),
                &look(View::Scene),
                &key(A::Undo),
                &key(A::Save),
            ),
        ),
        _ => (
            words().tour_of_help(),
            words().tour_of_help_text(
                &key(A::Help),
                &key(A::Search),
                &key(A::Back),
                &key(A::Quit),
                &key(A::Tour),
            ),
        ),
    };
    TourScreen { title, text }
}

/// Returns `true` if an action works during the tour.
pub(crate) fn allows(action: Action) -> bool {
    use Action as A;
    matches!(
        action,
        A::StepBack
            | A::StepForward
            | A::SmallerStep
            | A::LargerStep
            | A::Slower
            | A::Faster
            | A::Reverse
            | A::Opening
            | A::Glyphs
            | A::Colours
            | A::Look(_)
    )
}

/// Wraps text at words; a line feed begins a new line.
pub(crate) fn wrapped(text: &str, width: usize) -> Vec<String> {
    let paragraphs = text.split('\n');
    paragraphs
        .flat_map(|paragraph| page::wrapped(paragraph, width))
        .collect()
}

/// Returns `true` at the first start and records it. Returns `false` if it cannot be recorded,
/// because a tour at every start would be a nuisance.
pub(crate) fn is_first_start(env: impl Fn(&str) -> Option<PathBuf>) -> bool {
    let Some(folder) = directories::folder_of("XDG_STATE_HOME", ".local/state", env) else {
        return false;
    };
    fs::create_dir_all(&folder).is_ok() && File::create_new(folder.join(MARK)).is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tui::commands::key::Key;

    #[test]
    fn screens_fit_smallest_terminal_in_two_parts() {
        for number in 0..SCREENS {
            let screen = screen(number, &Keymap::default());
            let lines = wrapped(&screen.text, 38);
            assert!(lines.len() <= 8, "{number}: {lines:#?}");
            assert!(lines.iter().all(|line| line.len() <= 38 && line.is_ascii()));
            assert!(screen.title.len() <= 20, "the border cuts it");
        }
    }

    /// The tour names the key of every view.
    #[test]
    fn tour_names_every_view() {
        let text: Vec<String> = (0..SCREENS)
            .map(|number| screen(number, &Keymap::default()).text)
            .collect();
        let text = text.join(" ");
        for view in View::ALL {
            let key = Keymap::default().key_label(Action::Look(view));
            let words: Vec<&str> = text.split([' ', '\n']).collect();
            assert!(words.contains(&&*key), "{key}: {text}");
        }
    }

    #[test]
    fn tour_shows_configured_keys() {
        let mut keymap = Keymap::default();
        keymap.set(Action::StepForward, vec![Key::Function(7)]);
        keymap.set(Action::GoTo, Vec::new());
        let text = screen(1, &keymap).text;
        assert!(text.starts_with("F7 and , step"), "{text}");
        assert!(text.contains("(no key) goes to a typed value"), "{text}");
    }

    #[test]
    fn first_start_is_detected_once() {
        let folder = std::env::temp_dir().join(format!("krank-first-{}", std::process::id()));
        let state = |name: &str| (name == "XDG_STATE_HOME").then(|| folder.clone());
        assert!(is_first_start(state));
        assert!(!is_first_start(state));
        // Nothing can be stored: no home directory, or a file in place of the folder.
        assert!(!is_first_start(|_| None));
        let file = folder.join("krank").join(MARK);
        assert!(!is_first_start(move |_| Some(file.clone())));
        fs::remove_dir_all(folder).unwrap();
    }
}
