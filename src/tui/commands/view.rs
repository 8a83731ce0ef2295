//! The names of the views; their contents are defined in `tui::views`.

use crate::wording::{Wording, Words, words};

/// A view of the workbench.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum View {
    /// The drawing, with live tables.
    #[default]
    Motion,
    /// All tables.
    Tables,
    /// Quantities over the motion.
    Plots,
    /// Speed against error.
    Accuracy,
    /// Forces.
    Forces,
    /// The values of the scene.
    Scene,
    /// The sensitivities of the results to the given lengths.
    Lengths,
    /// The derivation of the results.
    Working,
    /// The motor's duty over a cycle.
    Motor,
    /// The position, velocity and acceleration polygon of each loop.
    Polygons,
}

impl View {
    /// All views, in the order of their keys.
    pub(crate) const ALL: [View; 10] = [
        View::Motion,
        View::Tables,
        View::Plots,
        View::Accuracy,
        View::Forces,
        View::Scene,
        View::Working,
        View::Motor,
        View::Lengths,
        View::Polygons,
    ];

    fn row(self) -> &'static ViewRow {
        let row = ROWS.iter().find(|row| row.view == self);
        row.unwrap_or(&ROWS[0])
    }

    /// Returns the one-word name in the status line and on the command line.
    pub(crate) fn name(self) -> &'static str {
        self.row().name
    }

    /// Returns the description in the help of the command line.
    pub(crate) fn about(self) -> &'static str {
        (self.row().about)(words())
    }

    /// Returns the title above the view's own keys in the help.
    pub(crate) fn help_title(self) -> &'static str {
        (self.row().help_title)(words())
    }
}

/// The names of a view.
struct ViewRow {
    view: View,
    name: &'static str,
    about: Wording,
    help_title: Wording,
}

const fn row(view: View, name: &'static str, about: Wording, help_title: Wording) -> ViewRow {
    ViewRow {
        view,
        name,
        about,
        help_title,
    }
}

// Each row is one line.
#[rustfmt::skip]
static ROWS: [ViewRow; View::ALL.len()] = {
    type W = dyn Words;
    [
        row(View::Motion, "motion", W::drawing_with_live_tables, W::what_the_motion_view_shows),
        row(View::Tables, "tables", W::tables_all, W::in_the_tables),
        row(View::Plots, "plots", W::plotted_over_the_motion, W::in_the_plots),
        row(View::Accuracy, "accuracy", W::accuracy_of_methods, W::in_the_accuracy_view),
        row(View::Forces, "forces", W::forces_everywhere, W::in_the_forces_view),
        row(View::Scene, "scene", W::what_the_scene_gives, W::in_the_scene_view),
        row(View::Working, "working", W::working_line_by_line, W::in_the_working),
        row(View::Motor, "motor", W::motor_over_a_cycle, W::in_the_motor_view),
        row(View::Lengths, "lengths", W::lengths_and_figures, W::in_the_lengths_view),
        row(View::Polygons, "polygons", W::polygons_of_each_loop, W::in_the_polygons_view),
    ]
};
