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
    }
}
