//! What is taken out of the workbench: copied, or written to a file.

use super::English;
use std::fmt::Display;

catalogue! {
    /// Things that are copied or written.
    trait ExportsWords for English {
        no_clipboard = "this terminal has no clipboard";
        nothing_to_copy = "nothing to copy here; the tables have all";
        no_value_to_copy = "there is no value to copy";
        sent_to_clipboard(bytes: usize) = "sent to the terminal's clipboard: {bytes} B";
        too_much_to_copy(bytes: usize) = "too much to copy, {bytes} B";
        use_instead(why: &str, key: &dyn Display) = "{why}: use {key}";
        no_figures_to_write = "no figures can be written here";
        no_drawing_here = "there is no drawing in this view";
        still_shown(bytes: usize) = "in pixels, {bytes} B; any key takes it away";
        still_takes(bytes: usize, seconds: f64, key: &dyn Display) =
            "a picture of {bytes} B takes {seconds:.0} s on this line; {key} again sends it";
        the_figures = "the figures";
        the_working = "the working";
        the_screen = "the screen";
        the_drawing = "the drawing";
        the_plot = "the plot";

        // Scripts.
        about_script(title: &str, driver: &str, unit: &str) =
            "{title}: where its points lie, worked out again, each group in turn.\n\
             Places are complex numbers x + i y in {unit}, directions have the size 1; q is {driver}.\n\
             A side is 1 or -1: which of its two assemblies a group has.";
        script_turn = "The direction at so many degrees from x.";
        script_circles = "Where circles about P and Q meet: on the left of the line from P to Q, or on its right.";
        script_circle_line = "Where a circle about P meets the line through Z along t: ahead of the foot of P, or behind.";
        script_lines = "Where two lines meet.";
        script_swing = "The direction of a guide that passes its pivot at an offset and leads to what is seen from there.";
        script_side = "The side at q, where it changes over on the way.";
        script_follow = "The coordinate of an input by its table: a cubic between each two knots, with the second derivatives there.";
        script_newton = "Unknowns for which a misfit vanishes: Newton's method from a seed, by central differences.";
        script_given = "What the scene gives.";
        script_positions = "The points at q.";
        script_table = "A row for each q.";
        script_group(links: &str) = "{links}";
    }
}
