//! The views: titles, headings and remarks.

use super::English;
use std::fmt::Display;

catalogue! {
    /// The views.
    trait ViewsWords for English {
        screen_too_small(width: u16, height: u16) = "krank needs {width} x {height}";

        // The line of tabs, and panes.
        short_accuracy = "error";
        means_nothing_here(key: &dyn Display, help: &str) = "{key} does nothing here; {help} lists the keys";
        nothing_acts_in_short = "no forces here: no loads, springs or masses";
        layout_is(name: &str) = "layout: {name}";
        no_other_pane = "there is no other pane";
        no_split_here = "there is no split to move";
        more_is_shown(width: u16, height: u16) = "{width} x {height} shows more";

        drawing_with_live_tables = "The drawing, with live tables";
        tables_all = "All tables";
        in_the_tables = "In the tables";
        plotted_over_the_motion = "Values over the motion";
        in_the_plots = "In the plots";
        accuracy_of_methods = "Speed against error";
        in_the_accuracy_view = "In the accuracy view";
        forces_everywhere = "Driver torque or force, joint and guide forces";
        in_the_forces_view = "In the forces view";
        what_the_scene_gives = "Values of the scene";
        in_the_scene_view = "In the scene view";
        working_line_by_line = "The working, line by line";
        in_the_working = "In the working";
        motor_over_a_cycle = "The motor over a cycle";
        in_the_motor_view = "In the motor view";
        lengths_and_figures = "Effect of each length";
        in_the_lengths_view = "In the lengths view";
        polygons_of_each_loop = "Position, velocity and acceleration polygon of each loop";
        in_the_polygons_view = "In the polygons view";

        // Polygons.
        position_polygon = "position";
        velocity_polygon = "velocity";
        acceleration_polygon = "acceleration";
        polygon_in_loop(order: &str, number: usize) = "{order}, loop {number}";

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
        nothing_acts_at_all = "No forces act on this linkage: the scene has no loads, springs or masses.";
        gravity_without_mass = "No forces act on this linkage: the scene has gravity, but no link has a mass.";
        how_forces_come =
            "Give a link its mass and com, or add [[loads]] or [[springs]] to the file. This view then shows the \
             driver's torque or force and the force at every joint.";
        table_of_guides = "guide";
        least_norm = "least norm";
        force_on = "force on";
        ground = "ground";
        ground_by_all = "ground by all";
        direction_of_force = "dir f";
        table_of_checks = "check";
        off_by = "off by";

        // Limits.
        too_many_lengths = "too many lengths: use krank table --sensitivity";
        too_many_links = "too many links to show here: use krank explain";
        the_curve = "the curve";
    }
}
