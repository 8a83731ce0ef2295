//! What the views are, and what is above and beside what they show.

use super::English;

catalogue! {
    /// The views.
    trait Views for English {
        screen_too_small(width: u16, height: u16) = "krank needs {width} x {height} characters";

        drawing_with_live_tables = "The drawing, with live tables";
        in_the_plots = "In the plots";
        plotted_over_the_motion = "Figures over the motion";
        what_the_scene_gives = "What the scene gives";
        in_the_scene_view = "In the scene view";
    }
}
