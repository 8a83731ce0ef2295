//! All actions of the workbench in one table. Keys, help overlay, hints of the status line and the
//! manual's list of keys are derived from it.

use crate::tui::commands::key::Key;
use crate::tui::commands::view::View;
use crate::wording::{Wording, Words};

/// An action, bound to keys.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Action {
    /// Plays or pauses.
    Play,
    /// Moves one step back.
    StepBack,
    /// Moves one step forward.
    StepForward,
    /// Decreases the step.
    SmallerStep,
    /// Increases the step.
    LargerStep,
    /// Decreases the playback speed.
    Slower,
    /// Increases the playback speed.
    Faster,
    /// Reverses the playback.
    Reverse,
    /// Prompts for a driver coordinate.
    GoTo,
    /// Moves the driver to the scene's start position.
    Opening,
    /// Selects the next input for the step keys.
    NextInput,
    /// Lists the assemblies.
    Assemblies,
    /// Saves the scene to its file.
    Save,
    /// Saves the scene to another file.
    SaveAs,
    /// Reads the file again.
    Reload,
    /// Chooses a preset or a file.
    Open,
    /// Compares with another scene, or with the original version.
    Compare,
    /// Undoes an edit.
    Undo,
    /// Redoes an edit.
    Redo,
    /// Searches for a row.
    Search,
    /// Copies to the clipboard of the user's terminal.
    Copy,
    /// Writes values to a CSV file.
    Csv,
    /// Writes the screen to a text file.
    Picture,
    /// Shows the drawing as a pixel image.
    Still,
    /// Writes the drawing or the plot to an SVG file.
    Svg,
    /// Writes a report on the scene's current state.
    Report,
    /// Opens the next preset.
    NextPreset,
    /// Opens the previous preset.
    PreviousPreset,
    /// Switches to the next set of glyphs.
    Glyphs,
    /// Switches to the next number of colours.
    Colours,
    /// Captures or releases the mouse.
    Mouse,
    /// Switches to the next language.
    Language,
    /// Shows the next view.
    NextView,
    /// Shows the previous view.
    PreviousView,
    /// Shows this view.
    Look(View),
    /// Moves up a line.
    LineUp,
    /// Moves down a line.
    LineDown,
    /// Moves up a screen.
    PageUp,
    /// Moves down a screen.
    PageDown,
    /// Moves up half a screen.
    HalfUp,
    /// Moves down half a screen.
    HalfDown,
    /// Moves to the first line.
    Top,
    /// Moves to the last line.
    End,
    /// Moves to the previous part: a heading, the values of another table, or those of another
    /// element.
    PreviousPart,
    /// Moves to the next part.
    NextPart,
    /// Selects the next pane.
    NextPane,
    /// Maximizes the pane or restores all panes.
    Alone,
    /// Moves the split between the panes to the left.
    SplitLeft,
    /// Moves the split between the panes to the right.
    SplitRight,
    /// Switches to the next layout.
    NextLayout,
    /// An action of the motion view.
    Motion(MotionAction),
    /// An action of the tables view.
    Tables(TablesAction),
    /// An action of the plots view.
    Plots(PlotsAction),
    /// Selects the next method to watch, in the accuracy view.
    Method,
    /// Prompts for the watched method's initial guess.
    Guess,
    /// Shows all effects of tolerances on a value, in the lengths view.
    Tolerance,
    /// An action of the scene view.
    Scene(SceneAction),
    /// Shows or hides the keys.
    Help,
    /// Lists all commands.
    Palette,
    /// Starts the tour.
    Tour,
    /// Goes one level back.
    Back,
    /// Redraws the whole screen.
    Redraw,
    /// Suspends the process and returns to the shell.
    Suspend,
    /// Quits.
    Quit,
    /// Quits from any mode.
    Leave,
}

impl Action {
    /// Shows the motion view, from which all other views are reached.
    pub(crate) const MOTION: Action = Action::Look(View::Motion);
}

/// An action of the motion view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum MotionAction {
    /// Switches between names of points, of points and links, and no names.
    Names,
    /// Toggles velocity arrows.
    Velocities,
    /// Toggles acceleration arrows.
    Accelerations,
    /// Toggles loads and the reactions of joints and guides.
    Forces,
    /// Toggles the traces of points over the motion.
    Traces,
    /// Toggles ghosts of the linkage at other positions of its motion.
    Ghosts,
    /// Toggles centres of mass.
    Centres,
    /// Toggles guides and supports.
    Guides,
    /// Zooms in.
    ZoomIn,
    /// Zooms out.
    ZoomOut,
    /// Restores the default window, or shows the whole motion.
    Fit,
    /// Fits the window to the linkage's current pose.
    FitPose,
    /// Keeps a point in the middle of the window.
    Follow,
    /// Pans the window to the left.
    PanLeft,
    /// Pans the window down.
    PanDown,
    /// Pans the window up.
    PanUp,
    /// Pans the window to the right.
    PanRight,
}

/// An action of the tables view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TablesAction {
    /// Selects the row's points for the motion view.
    Choose,
    /// Moves the cursor to the value at the left.
    Left,
    /// Moves the cursor to the value at the right.
    Right,
}

/// An action of the plots view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PlotsAction {
    /// Selects the plotted quantities.
    Choose,
    /// Switches to the next quantity on the x axis.
    Abscissa,
    /// Toggles the marks of extrema.
    Extrema,
    /// Toggles the tolerance bands.
    Band,
}

/// An action of the scene view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SceneAction {
    /// Prompts for a value.
    Edit,
    /// Decreases the value by a step.
    NudgeDown,
    /// Increases the value by a step.
    NudgeUp,
    /// Decreases the step.
    FinerNudge,
    /// Increases the step.
    CoarserNudge,
    /// Starts staging edits, or applies the staged edits.
    Gather,
    Goal,
}

/// The context in which a key is bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum KeyContext {
    /// Every view.
    Everywhere,
    /// Every view except the motion view. Its keys override those of [`KeyContext::Everywhere`], so
    /// that the arrow keys do not move the crank.
    Lists,
    /// Only the given view.
    In(View),
}

/// A row of the table.
#[derive(Debug)]
pub(crate) struct ActionRow {
    pub(crate) place: KeyContext,
    pub(crate) action: Action,
    /// The name in the configuration, which is stable.
    pub(crate) name: &'static str,
    /// One or two words for the hints of the status line.
    pub(crate) hint: Wording,
    /// One line for the help.
    pub(crate) help: Wording,
    pub(crate) keys: &'static [Key],
}

const fn entry(
    action: Action,
    name: &'static str,
    hint: Wording,
    help: Wording,
    keys: &'static [Key],
) -> ActionRow {
    ActionRow {
        place: KeyContext::Everywhere,
        action,
        name,
        hint,
        help,
        keys,
    }
}

/// Returns the entry with the context of lists.
const fn listed_in(entry: ActionRow) -> ActionRow {
    ActionRow {
        place: KeyContext::Lists,
        ..entry
    }
}

/// Returns the entry with the context of one view.
const fn within(view: View, entry: ActionRow) -> ActionRow {
    ActionRow {
        place: KeyContext::In(view),
        ..entry
    }
}

/// Related rows.
#[derive(Debug)]
pub(crate) struct ActionSection {
    pub(crate) title: Wording,
    pub(crate) entries: &'static [ActionRow],
}

/// All actions with their keys by topic, in the order of the help.
// Each row is one line.
#[rustfmt::skip]
pub(crate) static SECTIONS: [ActionSection; 8] = {
    use Action as A;
    use Key::{Char, Ctrl, Function};
    use MotionAction as M;
    use PlotsAction as P;
    use SceneAction as S;
    use TablesAction as T;
    use View::{Accuracy, Lengths, Motion, Plots, Scene, Tables};
    type W = dyn Words;
    [
        ActionSection { title: W::the_motion, entries: &[
        entry(A::Play, "play", W::play, W::play_or_pause, &[Char(' ')]),
        entry(A::StepBack, "step-back", W::step_back, W::one_step_back, &[Char(','), Key::Left, Char('h')]),
        entry(A::StepForward, "step", W::step, W::one_step_on, &[Char('.'), Key::Right, Char('l')]),
        entry(A::SmallerStep, "smaller", W::smaller, W::a_smaller_step, &[Char('[')]),
        entry(A::LargerStep, "larger", W::larger, W::a_larger_step, &[Char(']')]),
        entry(A::Slower, "slower", W::slower, W::play_more_slowly, &[Char('-')]),
        entry(A::Faster, "faster", W::faster, W::play_faster, &[Char('+'), Char('=')]),
        entry(A::Reverse, "reverse", W::reverse, W::play_the_other_way, &[Char('r')]),
        entry(A::GoTo, "go-to", W::go_to, W::type_where_to_go, &[Char('g')]),
        entry(A::Opening, "opening", W::opening, W::where_the_scene_opens, &[Key::Home]),
        entry(A::NextInput, "input", W::input, W::the_next_input, &[Char('U')]),
        entry(A::Assemblies, "assemblies", W::assemblies, W::other_assemblies, &[Char('a')]),
        ] },
        ActionSection { title: W::the_views, entries: &[
        entry(A::NextView, "view", W::view, W::the_next_view, &[Key::Tab]),
        entry(A::PreviousView, "previous-view", W::previous_view, W::the_view_before, &[Key::BackTab]),
        entry(A::Look(View::Motion), "motion", W::motion, W::motion_and_live_tables, &[Char('1')]),
        entry(A::Look(View::Tables), "tables", W::tables, W::all_tables, &[Char('2')]),
        entry(A::Look(View::Plots), "plots", W::plots, W::figures_over_the_motion, &[Char('3')]),
        entry(A::Look(View::Accuracy), "accuracy", W::accuracy, W::speed_against_error, &[Char('4')]),
        entry(A::Look(View::Forces), "forces", W::forces, W::forces, &[Char('5')]),
        entry(A::Look(View::Scene), "scene", W::scene, W::edit_the_scene, &[Char('6')]),
        entry(A::Look(View::Working), "working", W::working, W::the_working_shown, &[Char('7')]),
        entry(A::Look(View::Motor), "motor", W::motor, W::the_motor_over_a_cycle, &[Char('8')]),
        entry(A::Look(View::Lengths), "lengths", W::lengths, W::what_each_length_does, &[Char('9'), Char('e')]),
        entry(A::Look(View::Polygons), "polygons", W::polygons, W::vectors_of_each_loop, &[Char('0')]),
        ] },
        ActionSection { title: W::the_panes, entries: &[
        entry(A::NextPane, "pane", W::pane, W::the_next_pane, &[Char(';')]),
        entry(A::Alone, "alone", W::alone, W::the_pane_alone_or_not, &[Char('O')]),
        entry(A::SplitLeft, "split-left", W::split_left, W::the_split_to_the_left, &[Char('(')]),
        entry(A::SplitRight, "split-right", W::split_right, W::the_split_to_the_right, &[Char(')')]),
        entry(A::NextLayout, "layout", W::layout, W::the_next_layout, &[Char('|')]),
        ] },
        ActionSection { title: W::what_the_motion_view_shows, entries: &[
        within(Motion, entry(A::Motion(M::Names), "names", W::names, W::names_of_points_links, &[Char('i')])),
        within(Motion, entry(A::Motion(M::Velocities), "velocities", W::velocities, W::arrows_of_velocity, &[Char('v')])),
        within(Motion, entry(A::Motion(M::Accelerations), "accelerations", W::accelerations, W::arrows_of_acceleration, &[Char('A')])),
        within(Motion, entry(A::Motion(M::Forces), "force-arrows", W::force_arrows, W::loads_and_forces, &[Char('N')])),
        within(Motion, entry(A::Motion(M::Traces), "traces", W::traces, W::traces_of_points, &[Char('T')])),
        within(Motion, entry(A::Motion(M::Ghosts), "ghosts", W::ghosts, W::other_positions, &[Char('G')])),
        within(Motion, entry(A::Motion(M::Centres), "centres", W::centres, W::centres_of_mass, &[Char('c')])),
        within(Motion, entry(A::Motion(M::Guides), "guides", W::guides, W::guides_and_supports, &[Char('d')])),
        within(Motion, entry(A::Motion(M::ZoomIn), "zoom-in", W::zoom_in, W::zoom_in, &[Char('z')])),
        within(Motion, entry(A::Motion(M::ZoomOut), "zoom-out", W::zoom_out, W::zoom_out, &[Char('Z')])),
        within(Motion, entry(A::Motion(M::Fit), "fit", W::fit, W::the_whole_motion_again, &[Char('f')])),
        within(Motion, entry(A::Motion(M::FitPose), "fit-pose", W::fit_pose, W::the_linkage_as_it_stands, &[Char('F')])),
        within(Motion, entry(A::Motion(M::Follow), "follow", W::follow, W::stay_with_a_point, &[Char('s')])),
        within(Motion, entry(A::Motion(M::PanLeft), "pan-left", W::pan_left, W::move_the_window_left, &[Char('H')])),
        within(Motion, entry(A::Motion(M::PanDown), "pan-down", W::pan_down, W::move_it_down, &[Char('J')])),
        within(Motion, entry(A::Motion(M::PanUp), "pan-up", W::pan_up, W::move_it_up, &[Char('K')])),
        within(Motion, entry(A::Motion(M::PanRight), "pan-right", W::pan_right, W::move_it_right, &[Char('L')])),
        ] },
        ActionSection { title: W::lists, entries: &[
        entry(A::LineUp, "up", W::up, W::up_a_line, &[Key::Up, Char('k')]),
        entry(A::LineDown, "scroll", W::scroll, W::down_a_line, &[Key::Down, Char('j')]),
        entry(A::PageUp, "page-up", W::page_up, W::up_a_screen, &[Key::PageUp, Ctrl('b')]),
        entry(A::PageDown, "page-down", W::page_down, W::down_a_screen, &[Key::PageDown, Ctrl('f')]),
        listed_in(entry(A::HalfUp, "half-up", W::half_up, W::half_a_screen_up, &[Ctrl('u')])),
        listed_in(entry(A::HalfDown, "half-down", W::half_down, W::half_a_screen_down, &[Ctrl('d')])),
        listed_in(entry(A::Top, "top", W::first_line, W::the_first_line, &[Key::Home])),
        listed_in(entry(A::End, "end", W::last_line, W::the_last_line, &[Key::End, Char('G')])),
        listed_in(entry(A::NextPart, "next-part", W::next_part, W::to_the_next_part, &[Char('J')])),
        listed_in(entry(A::PreviousPart, "previous-part", W::previous_part, W::to_the_part_before, &[Char('K')])),
        entry(A::Search, "search", W::search, W::find_by_name, &[Char('/')]),
        within(Tables, entry(A::Tables(T::Choose), "choose", W::choose, W::show_it_in_the_motion, &[Char('x')])),
        listed_in(entry(A::Tables(T::Left), "left", W::left, W::the_figure_to_the_left, &[Key::Left, Char('h'), Char('H')])),
        listed_in(entry(A::Tables(T::Right), "right", W::right, W::the_figure_to_the_right, &[Key::Right, Char('l'), Char('L')])),
        within(Plots, entry(A::Plots(P::Choose), "choose-plots", W::choose_plots, W::choose_what_is_plotted, &[Char('x'), Key::Enter])),
        within(Plots, entry(A::Plots(P::Abscissa), "abscissa", W::abscissa, W::what_stands_along_x, &[Char('X')])),
        within(Plots, entry(A::Plots(P::Extrema), "extrema", W::extrema, W::mark_the_extrema, &[Char('m')])),
        within(Plots, entry(A::Plots(P::Band), "band", W::band, W::draw_the_band, &[Char('b')])),
        within(Accuracy, entry(A::Method, "method", W::method, W::watch_a_method, &[Char('m')])),
        within(Accuracy, entry(A::Guess, "guess", W::guess, W::type_where_it_begins, &[Key::Enter, Char('x')])),
        within(Lengths, entry(A::Tolerance, "tolerance", W::tolerance, W::what_tolerances_do_to_it, &[Key::Enter])),
        ] },
        ActionSection { title: W::the_scene, entries: &[
        within(Scene, entry(A::Scene(S::Edit), "edit", W::edit, W::type_another_value, &[Key::Enter])),
        within(Scene, entry(A::Scene(S::NudgeDown), "nudge-down", W::nudge_down, W::a_little_less, &[Char('<')])),
        within(Scene, entry(A::Scene(S::NudgeUp), "nudge-up", W::nudge_up, W::a_little_more, &[Char('>')])),
        within(Scene, entry(A::Scene(S::FinerNudge), "finer", W::finer, W::nudge_by_less, &[Char('{')])),
        within(Scene, entry(A::Scene(S::CoarserNudge), "coarser", W::coarser, W::nudge_by_more, &[Char('}')])),
        within(Scene, entry(A::Scene(S::Goal), "goal", W::goal, W::find_values_for_a_goal, &[Char('@')])),
        within(Scene, entry(A::Scene(S::Gather), "gather", W::gather, W::gather_edits, &[Char('b')])),
        entry(A::Undo, "undo", W::undo, W::take_an_edit_back, &[Char('u')]),
        entry(A::Redo, "redo", W::redo, W::make_it_again, &[Ctrl('r')]),
        entry(A::Save, "save", W::save, W::write_to_the_file, &[Char('w')]),
        entry(A::SaveAs, "save-as", W::save_as, W::write_to_another_file, &[Char('W')]),
        entry(A::Reload, "reload", W::reload, W::read_the_file_again, &[Char('R')]),
        entry(A::Open, "open", W::open, W::open_a_preset_or_file, &[Char('o')]),
        entry(A::NextPreset, "next", W::next, W::the_next_preset, &[Char('n')]),
        entry(A::PreviousPreset, "previous", W::previous, W::the_preset_before, &[Char('p')]),
        entry(A::Compare, "compare", W::compare, W::beside_another_scene, &[Char('D')]),
        ] },
        ActionSection { title: W::taking_things_out, entries: &[
        entry(A::Copy, "copy", W::copy, W::copy_to_the_clipboard, &[Char('y')]),
        entry(A::Csv, "csv", W::csv, W::write_a_csv_file, &[Char('Y')]),
        entry(A::Picture, "picture", W::picture, W::write_the_screen, &[Char('P')]),
        entry(A::Still, "still", W::still, W::the_drawing_in_pixels, &[Char('V')]),
        entry(A::Svg, "svg", W::svg, W::write_an_svg_file, &[Char('S')]),
        entry(A::Report, "report", W::report, W::write_a_report, &[Char('E')]),
        ] },
        ActionSection { title: W::the_program, entries: &[
        entry(A::Glyphs, "glyphs", W::glyphs, W::ascii_lines_braille, &[Char('t')]),
        entry(A::Colours, "colours", W::colours, W::how_many_colours, &[Char('C')]),
        entry(A::Mouse, "mouse", W::mouse, W::take_the_mouse_or_not, &[Char('M')]),
        entry(A::Language, "language", W::language, W::turkish_or_english, &[Char('B')]),
        entry(A::Help, "help", W::help, W::show_or_hide_this_help, &[Char('?'), Function(1)]),
        entry(A::Palette, "commands", W::commands, W::all_commands, &[Char(':')]),
        entry(A::Tour, "tour", W::tour, W::the_tour, &[Char('I'), Function(2)]),
        entry(A::Back, "back", W::back, W::one_level_back, &[Key::Escape]),
        entry(A::Redraw, "redraw", W::redraw, W::draw_everything_again, &[Ctrl('l')]),
        entry(A::Suspend, "suspend", W::suspend, W::stop_and_fg_goes_on, &[Ctrl('z')]),
        entry(A::Quit, "quit", W::quit, W::leave, &[Char('q')]),
        entry(A::Leave, "leave", W::leave, W::leave_from_anywhere, &[Ctrl('c')]),
        ] },
    ]
};

/// Returns all rows of the table.
pub(crate) fn entries() -> impl Iterator<Item = &'static ActionRow> {
    SECTIONS.iter().flat_map(|section| section.entries)
}

/// Returns the row of an action.
pub(crate) fn entry_of(action: Action) -> &'static ActionRow {
    entries()
        .find(|entry| entry.action == action)
        .unwrap_or(&SECTIONS[0].entries[0])
}

impl KeyContext {
    /// Returns `true` if its keys are bound in this view.
    pub(crate) fn covers(self, view: View) -> bool {
        match self {
            KeyContext::Everywhere => true,
            KeyContext::Lists => view != View::Motion,
            KeyContext::In(only) => only == view,
        }
    }

    /// Returns `true` if the two contexts share a view.
    pub(crate) fn meets(self, other: KeyContext) -> bool {
        View::ALL
            .iter()
            .any(|&view| self.covers(view) && other.covers(view))
    }
}

/// Formats keys for the user, such as `, Left h`.
pub(crate) fn listed(keys: &[Key]) -> String {
    let keys: Vec<String> = keys.iter().map(Key::to_string).collect();
    keys.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wording::{Language, words};

    #[test]
    fn actions_are_listed_once_and_have_keys() {
        let mut seen = Vec::new();
        for entry in entries() {
            assert!(!seen.contains(&entry.action), "{}", entry.name);
            seen.push(entry.action);
            assert!(!entry.keys.is_empty(), "{}", entry.name);
        }
    }

    #[test]
    fn help_lines_fit_smallest_screen() {
        for entry in entries() {
            let keys = listed(entry.keys);
            assert!(keys.len() <= 12, "{keys}");
            for language in Language::ALL {
                language.speak();
                let help = (entry.help)(words());
                assert!(help.chars().count() <= 23, "{help}");
            }
        }
    }
}
