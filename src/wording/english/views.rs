//! What the views are, and what is above and beside what they show.

use super::English;
use std::fmt::Display;

catalogue! {
    /// The views.
    trait ViewsWords for English {
        screen_too_small(width: u16, height: u16) = "krank needs {width} x {height}";

        // The line of tabs, and panes.
        short_accuracy = "error";
        means_nothing_here(key: &dyn Display, help: &str) = "{key} means nothing here; {help} tells the keys";
        nothing_acts_in_short = "nothing acts here: no loads, no springs, no masses";
        layout_is(name: &str) = "layout: {name}";
        no_other_pane = "there is no other pane";
        no_split_here = "there is no split to move";
        more_is_shown(width: u16, height: u16) = "{width} x {height} show more";

        drawing_with_live_tables = "The drawing, with live tables";
        tables_all = "All tables";
        in_the_tables = "In the tables";
        plotted_over_the_motion = "Figures over the motion";
        in_the_plots = "In the plots";
        accuracy_of_methods = "Speed against error";
        in_the_accuracy_view = "In the accuracy view";
        forces_everywhere = "What the driver must do, and what joints and guides bear";
        in_the_forces_view = "In the forces view";
        what_the_scene_gives = "What the scene gives";
        in_the_scene_view = "In the scene view";
        working_line_by_line = "The working, line by line";
        in_the_working = "In the working";
        motor_over_a_cycle = "The motor over a cycle";
        in_the_motor_view = "In the motor view";
        lengths_and_figures = "What each length does";
        in_the_lengths_view = "In the lengths view";

        // Tables.
        found = "found";
        only_here = "only here";
        difference_of(title: &str) = "{title}, difference";

        // Accuracy.
        measuring(percent: &str) = "measuring {percent} %";
        stopped_at(percent: &dyn Display) = "stopped at {percent} %";
        all_measured = "all measured";

        // Forces.
        effort_without_bound(effort: &str) = "{effort}: no bound";
        nothing_acts_at_all =
            "Nothing acts on this linkage: the scene has no loads, no springs and no masses.";
        gravity_without_mass =
            "Nothing acts on this linkage: the scene has gravity, but no link has a mass.";
        how_forces_come =
            "Give a link its mass and com, or add [[loads]] or [[springs]] to the file: then this \
             view shows what the driver must do and what every joint bears.";
        table_of_guides = "guide";
        least_norm = "least norm";
        force_on = "force on";
        ground = "ground";
        ground_by_all = "ground by all";
        direction_of_force = "dir f";
        table_of_checks = "check";
        off_by = "off by";

        // What takes too long.
        too_many_lengths = "too many lengths: krank table --sensitivity tells what they do";
        too_many_links = "too many links to follow here: krank explain writes all of it";
        the_curve = "the curve";
    }
}
