//! What tolerances do.

use super::English;

catalogue! {
    /// Tolerances: what is off, what comes of it, and where nothing can be said.
    trait TolerancesWords for English {
        no_tolerances =
            "every length of the scene is exact: say how far one may be off with tolerance, or \
             how loose a pin is with clearance";
        or_say_tolerance = "or here: --tolerance 0.1";
        redundant_jams =
            "the mechanism has more constraints than it needs: with a length that is off it jams, \
             and no figure can be told";
        no_tolerances_of_forces =
            "tolerances are told of figures of motion, not of forces: leave these out";

        // What comes of them.
        within_tolerances = "within tolerances";
        label_worst_case = "worst case";
        range_and_off(low: &str, high: &str, below: &str, above: &str) =
            "{low} to {high} ({below}, {above})";
        worst_by_corners = "every corner of the tolerances solved";
        worst_enclosed = "enclosed: no machine is outside; the worst may be further inside";
        worst_reached(low: &str, high: &str, below: &str, above: &str) =
            "reached for certain: {low} to {high} ({below}, {above})";
        worst_searched =
            "estimated: it goes both ways along a length, so that it was searched for inside the \
             tolerances too; not proved";
        worst_at_edge =
            "estimated: searched up to where the figure ceases to exist; not proved";
        worst_unbounded =
            "it grows beyond all bounds towards an edge of assembly within the tolerances";
        no_worst_case(why: &str) = "none: {why}";
        worst_at_least(low: &str, below: &str) = "at least {low} ({below})";
        worst_above(why: &str) = "greatest: none: {why}";
        worst_at_most(high: &str, above: &str) = "at most {high} ({above})";
        worst_below(why: &str) = "least: none: {why}";
        worst_beside_unbounded = "the other end is estimated: searched along the edge; not proved";
        worst_by_derivatives =
            "estimated: solved where the derivatives point to; not proved";
        worst_sampled =
            "estimated: a sample goes further than what was solved; not proved";
        worst_does_not_close = "of the machines that close; not every one does";
        label_root_sum_square = "root sum square";
        no_first_order = "none: no derivatives exist here";
        label_most_samples = "99.73 % of samples";
        spread_of_samples(low: &str, high: &str) = "{low} to {high}";
        mean_and_deviation(mean: &str, deviation: &str) =
            "mean {mean}, standard deviation {deviation}";
        label_contributions = "from";
        head_tolerance = "tolerance";
        head_per_unit = "per unit";
        head_off_by = "off by";
        head_share = "share";
        label_samples = "samples";
        how_samples_are_made(count: u32, spread: &str, seed: u64) =
            "{count} machines, lengths spread {spread}, seed {seed}";
        spread_normally = "normally (the tolerance is three standard deviations)";
        spread_evenly = "evenly";
        samples_all_close = "all close here";
        part_of_samples_open(part: &str) = "{part} do not close here";
        samples_keep_class = "all keep the class of their first loop";
        part_of_samples_changed(part: &str) = "{part} change the class of their first loop";
        rows_estimated(some: u64, rows: u64) =
            "in {some} of {rows} rows a worst case is estimated, not proved: how each was found \
             stands in worst.by";
        rows_that_may_not_close(some: u64, rows: u64) =
            "in {some} of {rows} rows not every machine within its tolerances closes; worst cases \
             are of those that do";

        no_figure_in_line = "no figure stands in this line: find one with /";

        // What a scene says of them.
        tolerance_of_point(name: &str) = "tolerance of {name}";
        clearance_of_pin(name: &str) = "clearance of {name}";
        no_general_tolerance(what: &str, text: &str) =
            "{what} must be a number or a class of ISO 2768-1, which {text} is not";
        unknown_general_tolerance = "unknown class";
        known_general_tolerances(list: &str) = "the classes: {list}";
        nought_is_exact = "it goes to both sides; 0 is exact";
        frame_has_no_tolerance(name: &str) =
            "link {name} is the frame, and has no tolerance of its own";
        is_of_the_frame = "of the frame";
        give_ground_points_tolerances = "give its ground points theirs in [tolerances]";
        guide_has_no_tolerance(of: &str) =
            "{of} runs through a point by its name: it has no coordinates that could be off";
        nothing_to_be_off = "nothing can be off";
        give_point_of_guide_tolerance = "give that point its own in [tolerances]";
        point_has_no_coordinates(what: &str) =
            "{what}: only links end there, and it has no coordinates of its own";
        give_link_a_tolerance = "give the link whose length ends there a `tolerance`";
        tolerance_beyond_length(what: &str, length: f64, literal: &str) =
            "the tolerance of {what} must be less than the length, {length}, but is {literal}";
        no_deviation_of_size(class: &str, what: &str, size: f64, sizes: &str) =
            "{class} has nothing for {what}, {size} mm: it speaks of {sizes} mm";
        sizes_from_to(low: f64, high: f64) = "{low} to {high}";
        sizes_over_to(low: f64, high: f64) = "over {low} up to {high}";
        of_this_length = "of this length";
        by_this_class = "by this class";
        give_it_its_own_tolerance = "give it a tolerance of its own";
        clearance_beyond_length(what: &str, of: &str, length: f64, literal: &str) =
            "{what} must be less than the {of} beside it, {length}, but is {literal}";
        give_it_its_own_clearance = "give the pin a clearance of its own in [clearances]";
        is_no_pin(what: &str) = "{what}: the point joins nothing";
        joins_nothing = "no pin";
        pins_join = "a pin joins two links, or a link and the ground or a slot";
        over_the_whole_motion = "over the whole motion";
        whole_has_no_place =
            "figures of the whole motion have no place: leave --at, --from, --to and --step out";
        beside_whole_say_where(name: &str) =
            "{name} stands beside figures of the whole motion: say where with --at, or {name}@60";
    }
}
