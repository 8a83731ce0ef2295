//! Plots of values over the motion.

use super::English;

catalogue! {
    /// Plots and their lists.
    trait PlotsWords for English {
        over(name: &str) = "over {name}";
        extremum(value: &str, place: &str) = "{value} at {place}";
        over_time = "over time: 0 s is where the scene opens";
        extrema_marked = "maxima and minima are marked";
        extrema_not_marked = "maxima and minima are not marked";
        band_drawn = "tolerance bands are shown";
        band_not_drawn = "tolerance bands are hidden";
        nothing_plotted = "nothing is plotted yet";
        nothing_plotted_to_write = "there is no plot to write";
        no_value_anywhere(names: &str) = "no value anywhere in this motion: {names}";
        no_value_anywhere_because(names: &str, why: &str) =
            "no value anywhere in this motion: {names}; {why}";
        put_something_else_along_x = "choose another x axis";
        plot_what = "plot what?";
        the_whole_cycle = "cycle";
        no_figure_has_that = "no column matches";
        measured_of(figure: &str) = "{figure} measured";
    }
}
