//! The tour of the first start.

use super::English;

catalogue! {
    /// The screens of the tour: titles, and texts with the configured keys.
    trait TourWords for English {
        tour_title(page: usize, pages: usize, title: &str) = "Tour {page}/{pages}: {title}";
        tour_keys(next: &str) = "Enter {next}  Left back  Esc end";

        tour_of_the_screen = "What krank shows";
        tour_of_the_screen_text =
            "The crank drives the linkage. The drawing is to scale; the tables show position, velocity and \
             acceleration of each part. * marks computed values.\nThe last line shows the crank angle and the most \
             useful keys.";
        tour_of_the_crank = "Moving the crank";
        tour_of_the_crank_text(keys: &[String; 10]) = {
            let [step, step_back, play, smaller, larger, slower, faster, reverse, go_to, opening] =
                keys;
            format!(
                "{step} and {step_back} step: try it now. {play} plays, once the tour is over.\n{smaller} and \
                 {larger} change the step, {slower} and {faster} the speed, {reverse} the direction. {go_to} goes \
                 to a typed value, {opening} to the opening."
            )
        };
        tour_of_figures = "Tables, plots, trust";
        tour_of_figures_text(views: &[String; 9]) = {
            let [motion, tables, plots, accuracy, forces, working, motor, lengths, polygons] = views;
            format!(
                "{tables} tables, {plots} plots, {forces} forces, {working} the working, {motor} the motor, \
                 {polygons} polygons, {motion} motion.\nMost values have a proved bound; digits beyond it are dim or \
                 dots. - means no value. {accuracy} compares methods, {lengths} shows the effect of each length."
            )
        };
        tour_of_editing = "Editing and saving";
        tour_of_editing_text(open: &str, next: &str, scene: &str, undo: &str, save: &str) =
            "{open} opens a preset or a file; {next} shows the next preset.\n{scene} lists every number of the \
             scene for editing, and the linkage follows. {undo} undoes an edit. Nothing is written before you \
             press {save}.";
        tour_of_help = "Getting help";
        tour_of_help_text(help: &str, search: &str, back: &str, quit: &str, tour: &str) =
            "{help} lists the keys of the view, then all others; {search} searches them. {back} goes one level \
             back, {quit} quits.\n{tour} shows this tour again. Without a terminal: krank --help, krank man.";
    }
}
