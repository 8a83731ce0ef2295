//! Everything that can be asked of the workbench, in one table: the keys, the help overlay, the hints of
//! the last line and the list of keys in the manual all come from it.

use crate::tui::commands::key::Key;
use crate::tui::commands::view::View;

/// What a key asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Action {
    /// Play, or pause.
    Play,
    /// One step back.
    StepBack,
    /// One step on.
    StepForward,
    /// A smaller step.
    SmallerStep,
    /// A larger step.
    LargerStep,
    /// Play more slowly.
    Slower,
    /// Play faster.
    Faster,
    /// Play the other way.
    Reverse,
    /// Type an angle to go to.
    GoTo,
    /// Back to where the scene opens.
    Opening,
    /// List the assemblies.
    Assemblies,
    /// Write the scene to its file.
    Save,
    /// Write the scene to another file.
    SaveAs,
    /// Read the file again.
    Reload,
    /// Choose a preset or a file.
    Open,
    /// Beside another scene, or beside what was opened.
    Compare,
    /// Take an edit back.
    Undo,
    /// Make it again.
    Redo,
    /// Find a row.
    Search,
    /// Copy to the clipboard of the person's own terminal.
    Copy,
    /// Write figures to a CSV file.
    Csv,
    /// Write the screen to a text file.
    Picture,
    /// Write the drawing or the plot to an SVG file.
    Svg,
    /// The next preset.
    NextPreset,
    /// The preset before.
    PreviousPreset,
    /// The next set of glyphs.
    Glyphs,
    /// The next number of colours.
    Colours,
    /// The next view.
    NextView,
    /// This view.
    Look(View),
    /// A line up.
    LineUp,
    /// A line down.
    LineDown,
    /// A screen up.
    PageUp,
    /// A screen down.
    PageDown,
    /// Of the motion view alone.
    Motion(MotionAction),
    /// Of the tables alone.
    Tables(TablesAction),
    /// Of the plots alone.
    Plots(PlotsAction),
    /// Of the scene view alone.
    Scene(SceneAction),
    /// Show or hide the keys.
    Help,
    /// The tour.
    Tour,
    /// One level back.
    Back,
    /// Draw everything again.
    Redraw,
    /// Stop, and give the shell its terminal.
    Suspend,
    /// Leave.
    Quit,
    /// Leave, from anywhere.
    Leave,
}

impl Action {
    /// The motion view, from which one leaves for all others.
    pub(crate) const MOTION: Action = Action::Look(View::Motion);
}

/// What the motion view alone can do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MotionAction {
    /// Names: of points, of links too, none.
    Names,
    /// Arrows of velocity.
    Velocities,
    /// Arrows of acceleration.
    Accelerations,
    /// Traces of points over the motion.
    Traces,
    /// The linkage elsewhere in its motion.
    Ghosts,
    /// Centres of mass.
    Centres,
    /// Guides and supports.
    Guides,
    /// Larger.
    ZoomIn,
    /// Smaller.
    ZoomOut,
    /// The whole motion again.
    Fit,
    /// The window goes left.
    PanLeft,
    /// The window goes down.
    PanDown,
    /// The window goes up.
    PanUp,
    /// The window goes right.
    PanRight,
}

/// What the tables alone can do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TablesAction {
    /// Choose the row, for the motion view.
    Choose,
    /// The figure to the left.
    Left,
    /// The figure to the right.
    Right,
}

/// What the plots alone can do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PlotsAction {
    /// Choose what is plotted.
    Choose,
    /// The next quantity along x.
    Abscissa,
    /// Mark the extrema.
    Extrema,
}

/// What the scene view alone can do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SceneAction {
    /// Type another value.
    Edit,
    /// A little less.
    NudgeDown,
    /// A little more.
    NudgeUp,
    /// Nudge by less.
    FinerNudge,
    /// Nudge by more.
    CoarserNudge,
}

/// Where a key has its meaning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// In every view.
    Everywhere,
    /// In this one.
    In(View),
}

/// A row of the table.
#[derive(Debug)]
pub(crate) struct Entry {
    pub(crate) place: Place,
    pub(crate) action: Action,
    /// One or two words, for the hints of the last line.
    pub(crate) name: &'static str,
    /// One line.
    pub(crate) help: &'static str,
    pub(crate) keys: &'static [Key],
}

const fn entry(
    action: Action,
    name: &'static str,
    help: &'static str,
    keys: &'static [Key],
) -> Entry {
    Entry {
        place: Place::Everywhere,
        action,
        name,
        help,
        keys,
    }
}

/// The same entry, in one view alone.
const fn within(view: View, entry: Entry) -> Entry {
    Entry {
        place: Place::In(view),
        ..entry
    }
}

/// Rows that belong together.
#[derive(Debug)]
pub(crate) struct Section {
    pub(crate) title: &'static str,
    pub(crate) entries: &'static [Entry],
}

/// All actions with their keys, by what they are for, in the order in which the help shows them.
// One row, one line.
#[rustfmt::skip]
pub(crate) static SECTIONS: [Section; 7] = {
    use Action as A;
    use Key::{Char, Ctrl, Function};
    use MotionAction as M;
    use PlotsAction as P;
    use SceneAction as S;
    use TablesAction as T;
    use View::{Motion, Plots, Scene, Tables};
    [
        Section { title: "The motion", entries: &[
        entry(A::Play, "play", "play or pause", &[Char(' ')]),
        entry(A::StepBack, "step back", "one step back", &[Char(','), Key::Left, Char('h')]),
        entry(A::StepForward, "step", "one step on", &[Char('.'), Key::Right, Char('l')]),
        entry(A::SmallerStep, "smaller", "a smaller step", &[Char('[')]),
        entry(A::LargerStep, "larger", "a larger step", &[Char(']')]),
        entry(A::Slower, "slower", "play more slowly", &[Char('-')]),
        entry(A::Faster, "faster", "play faster", &[Char('+'), Char('=')]),
        entry(A::Reverse, "reverse", "play the other way", &[Char('r')]),
        entry(A::GoTo, "go to", "type where to go", &[Char('g')]),
        entry(A::Opening, "opening", "where the scene opens", &[Key::Home]),
        entry(A::Assemblies, "assemblies", "other assemblies", &[Char('a')]),
        ] },
        Section { title: "The views", entries: &[
        entry(A::NextView, "view", "the next view", &[Key::Tab]),
        entry(A::Look(View::Motion), "motion", "motion and live tables", &[Char('1')]),
        entry(A::Look(View::Tables), "tables", "all tables", &[Char('2')]),
        entry(A::Look(View::Plots), "plots", "figures over the motion", &[Char('3')]),
        entry(A::Look(View::Accuracy), "accuracy", "speed against error", &[Char('4')]),
        entry(A::Look(View::Forces), "forces", "forces", &[Char('5')]),
        entry(A::Look(View::Scene), "scene", "edit the scene", &[Char('6')]),
        entry(A::Look(View::Working), "working", "the working shown", &[Char('7')]),
        entry(A::Look(View::Motor), "motor", "the motor over a cycle", &[Char('8')]),
        entry(A::Look(View::Lengths), "lengths", "what each length does", &[Char('e')]),
        ] },
        Section { title: "What the motion view shows", entries: &[
        within(Motion, entry(A::Motion(M::Names), "names", "names of points, links", &[Char('i')])),
        within(Motion, entry(A::Motion(M::Velocities), "velocities", "arrows of velocity", &[Char('v')])),
        within(Motion, entry(A::Motion(M::Accelerations), "accelerations", "arrows of acceleration", &[Char('A')])),
        within(Motion, entry(A::Motion(M::Traces), "traces", "traces of points", &[Char('T')])),
        within(Motion, entry(A::Motion(M::Ghosts), "ghosts", "other positions", &[Char('G')])),
        within(Motion, entry(A::Motion(M::Centres), "centres", "centres of mass", &[Char('c')])),
        within(Motion, entry(A::Motion(M::Guides), "guides", "guides and supports", &[Char('d')])),
        within(Motion, entry(A::Motion(M::ZoomIn), "zoom in", "zoom in", &[Char('z')])),
        within(Motion, entry(A::Motion(M::ZoomOut), "zoom out", "zoom out", &[Char('Z')])),
        within(Motion, entry(A::Motion(M::Fit), "fit", "the whole motion again", &[Char('f')])),
        within(Motion, entry(A::Motion(M::PanLeft), "pan left", "move the window left", &[Char('H')])),
        within(Motion, entry(A::Motion(M::PanDown), "pan down", "move it down", &[Char('J')])),
        within(Motion, entry(A::Motion(M::PanUp), "pan up", "move it up", &[Char('K')])),
        within(Motion, entry(A::Motion(M::PanRight), "pan right", "move it right", &[Char('L')])),
        ] },
        Section { title: "Lists", entries: &[
        entry(A::LineUp, "up", "up a line", &[Key::Up, Char('k')]),
        entry(A::LineDown, "scroll", "down a line", &[Key::Down, Char('j')]),
        entry(A::PageUp, "page up", "up a screen", &[Key::PageUp]),
        entry(A::PageDown, "page down", "down a screen", &[Key::PageDown]),
        entry(A::Search, "search", "find by name", &[Char('/')]),
        within(Tables, entry(A::Tables(T::Choose), "choose", "show it in the motion", &[Char('x')])),
        within(Tables, entry(A::Tables(T::Left), "left", "the figure to the left", &[Char('H')])),
        within(Tables, entry(A::Tables(T::Right), "right", "the figure to the right", &[Char('L')])),
        within(Plots, entry(A::Plots(P::Choose), "choose plots", "choose what is plotted", &[Char('x'), Key::Enter])),
        within(Plots, entry(A::Plots(P::Abscissa), "abscissa", "what stands along x", &[Char('X')])),
        within(Plots, entry(A::Plots(P::Extrema), "extrema", "mark the extrema", &[Char('m')])),
        ] },
        Section { title: "The scene", entries: &[
        within(Scene, entry(A::Scene(S::Edit), "edit", "type another value", &[Key::Enter])),
        within(Scene, entry(A::Scene(S::NudgeDown), "nudge down", "a little less", &[Char('<')])),
        within(Scene, entry(A::Scene(S::NudgeUp), "nudge up", "a little more", &[Char('>')])),
        within(Scene, entry(A::Scene(S::FinerNudge), "finer", "nudge by less", &[Char('{')])),
        within(Scene, entry(A::Scene(S::CoarserNudge), "coarser", "nudge by more", &[Char('}')])),
        entry(A::Undo, "undo", "take an edit back", &[Char('u')]),
        entry(A::Redo, "redo", "make it again", &[Ctrl('r')]),
        entry(A::Save, "save", "write to the file", &[Char('w')]),
        entry(A::SaveAs, "save as", "write to another file", &[Char('W')]),
        entry(A::Reload, "reload", "read the file again", &[Char('R')]),
        entry(A::Open, "open", "open a preset or file", &[Char('o')]),
        entry(A::NextPreset, "next", "the next preset", &[Char('n')]),
        entry(A::PreviousPreset, "previous", "the preset before", &[Char('p')]),
        entry(A::Compare, "compare", "beside another scene", &[Char('D')]),
        ] },
        Section { title: "Taking things out", entries: &[
        entry(A::Copy, "copy", "copy to the clipboard", &[Char('y')]),
        entry(A::Csv, "csv", "write a CSV file", &[Char('Y')]),
        entry(A::Picture, "picture", "write the screen", &[Char('P')]),
        entry(A::Svg, "svg", "write an SVG file", &[Char('S')]),
        ] },
        Section { title: "The program", entries: &[
        entry(A::Glyphs, "glyphs", "ASCII, lines, Braille", &[Char('t')]),
        entry(A::Colours, "colours", "how many colours", &[Char('C')]),
        entry(A::Help, "help", "show or hide this help", &[Char('?'), Function(1)]),
        entry(A::Tour, "tour", "the tour", &[Char('I'), Function(2)]),
        entry(A::Back, "back", "one level back", &[Key::Escape]),
        entry(A::Redraw, "redraw", "draw everything again", &[Ctrl('l')]),
        entry(A::Suspend, "suspend", "stop; fg goes on", &[Ctrl('z')]),
        entry(A::Quit, "quit", "leave", &[Char('q')]),
        entry(A::Leave, "leave", "leave from anywhere", &[Ctrl('c')]),
        ] },
    ]
};

/// All rows of the table.
pub(crate) fn entries() -> impl Iterator<Item = &'static Entry> {
    SECTIONS.iter().flat_map(|section| section.entries)
}

/// The row of an action.
pub(crate) fn entry_of(action: Action) -> &'static Entry {
    entries()
        .find(|entry| entry.action == action)
        .unwrap_or(&SECTIONS[0].entries[0])
}

impl Place {
    /// Whether its keys have their meaning in this view.
    pub(crate) fn covers(self, view: View) -> bool {
        match self {
            Place::Everywhere => true,
            Place::In(only) => only == view,
        }
    }

    /// Whether there is a view where both have their meaning.
    pub(crate) fn meets(self, other: Place) -> bool {
        View::ALL
            .iter()
            .any(|&view| self.covers(view) && other.covers(view))
    }
}

/// Keys as people read them: `, Left h`.
pub(crate) fn listed(keys: &[Key]) -> String {
    let keys: Vec<String> = keys.iter().map(Key::to_string).collect();
    keys.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn no_action_is_missing_and_none_stands_twice() {
        let mut seen = Vec::new();
        for entry in entries() {
            assert!(!seen.contains(&entry.action), "{}", entry.name);
            seen.push(entry.action);
            assert!(!entry.keys.is_empty(), "{}", entry.name);
        }
    }

    #[test]
    fn names_tell_the_actions_apart() {
        let names: HashSet<&str> = entries().map(|entry| entry.name).collect();
        assert_eq!(names.len(), entries().count());
    }

    #[test]
    fn a_help_line_fits_the_smallest_screen() {
        for entry in entries() {
            let keys = listed(entry.keys);
            assert!(keys.len() <= 12, "{keys}");
            assert!(
                entry.help.is_ascii() && entry.help.len() <= 23,
                "{}",
                entry.help
            );
        }
    }
}
