//! Texts of the clipboard, of exported files and of scripts.

use super::English;
use std::fmt::Display;

catalogue! {
    /// Copied text, exported files and scripts.
    trait ExportsWords for English {
        no_clipboard = "this terminal has no clipboard";
        nothing_to_copy = "nothing to copy here: see the tables";
        no_value_to_copy = "no value to copy";
        sent_to_clipboard(bytes: usize) = "sent to the terminal's clipboard: {bytes} B";
        too_much_to_copy(bytes: usize) = "too much to copy, {bytes} B";
        use_instead(why: &str, key: &dyn Display) = "{why}: use {key}";
        no_figures_to_write = "nothing to write here";
        no_drawing_here = "this view has no drawing";
        still_shown(bytes: usize) = "in pixels, {bytes} B; any key closes it";
        still_takes(bytes: usize, seconds: f64, key: &dyn Display) =
            "a picture of {bytes} B takes {seconds:.0} s on this line; press {key} again";
        the_figures = "the values";
        the_working = "the working";
        the_screen = "the screen";
        the_drawing = "the drawing";
        the_plot = "the plot";

        // Scripts.
        about_script(title: &str, driver: &str, unit: &str) =
            "{title}: positions of its points, computed group by group.\n\
             Points are complex numbers x + i y in {unit}, directions are unit vectors; q is {driver}.\n\
             A side is 1 or -1: which of its two assemblies a group has.";
        script_turn = "Unit vector at an angle in degrees from the x axis.";
        script_circles =
            "Intersection of the circles around P and Q: left of the line from P to Q, or right.";
        script_circle_line =
            "Intersection of a circle around P with the line through Z along t: after the foot of P, or before.";
        script_lines = "Intersection of two lines.";
        script_swing =
            "Direction of a guide that passes its pivot at an offset and goes through a point seen from the \
             pivot.";
        script_side = "The side at q; it changes at some positions.";
        script_follow =
            "Coordinate of an input by its table: cubic splines with the second derivatives at the knots.";
        script_newton =
            "Unknowns for which a residual is zero: Newton's method from a seed, with central differences.";
        script_given = "Given values of the scene.";
        script_positions = "Positions of the points at q.";
        script_table = "One row for each q.";
        script_group(links: &str) = "{links}";
    }
}
