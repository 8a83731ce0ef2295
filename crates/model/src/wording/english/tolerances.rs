//! Effects of tolerances.

use super::English;

catalogue! {
    /// Tolerances, their effects, and where no result exists.
    trait TolerancesWords for English {
        no_tolerances =
            "every length of the scene is exact: give a `tolerance` for lengths, or a `clearance` for pins";
        or_say_tolerance = "or here: --tolerance 0.1";
        redundant_jams =
            "the mechanism is overconstrained: any error of a length jams it, so no value can be computed";
        no_tolerances_of_forces = "tolerances apply to values of motion, not to forces: remove these";

        // Effects.
        within_tolerances = "within tolerances";
        label_worst_case = "worst case";
        range_and_off(low: &str, high: &str, below: &str, above: &str) =
            "{low} to {high} ({below}, {above})";
        worst_by_corners = "all corners of the tolerances solved";
        worst_enclosed = "enclosed: no machine is outside; the true worst case may be smaller";
        worst_reached(low: &str, high: &str, below: &str, above: &str) =
            "proved to be reached: {low} to {high} ({below}, {above})";
        worst_searched =
            "estimated: not monotonic in a length, so the inside of the tolerances was searched too; not proved";
        worst_at_edge = "estimated: searched up to where the value ceases to exist; not proved";
        worst_unbounded = "it grows without bound towards an edge of assembly within the tolerances";
        no_worst_case(why: &str) = "none: {why}";
        worst_at_least(low: &str, below: &str) = "at least {low} ({below})";
        worst_above(why: &str) = "maximum: none: {why}";
        worst_at_most(high: &str, above: &str) = "at most {high} ({above})";
        worst_below(why: &str) = "minimum: none: {why}";
        worst_beside_unbounded = "the other end is estimated: searched along the edge; not proved";
        worst_by_derivatives = "estimated: solved at the corner that the derivatives indicate; not proved";
        worst_sampled = "estimated: a sample exceeds the solved values; not proved";
        worst_does_not_close = "for the machines that close; not all of them do";
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
            "{count} machines, lengths distributed {spread}, seed {seed}";
        spread_normally = "normally (the tolerance is three standard deviations)";
        spread_evenly = "uniformly";
        samples_all_close = "all close here";
        part_of_samples_open(part: &str) = "{part} do not close here";
        samples_keep_class = "all keep the class of their first loop";
        part_of_samples_changed(part: &str) = "{part} change the class of their first loop";
        rows_estimated(some: u64, rows: u64) =
            "in {some} of {rows} rows a worst case is estimated, not proved: see the column worst.by";
        rows_that_may_not_close(some: u64, rows: u64) =
            "in {some} of {rows} rows not every machine within its tolerances closes; worst cases cover those that \
             do";

        no_figure_in_line = "this line has no value: find one with /";

        // Tolerances in a scene.
        tolerance_of_point(name: &str) = "tolerance of {name}";
        clearance_of_pin(name: &str) = "clearance of {name}";
        no_general_tolerance(what: &str, text: &str) =
            "{what} must be a number or a class of ISO 2768-1, not {text}";
        unknown_general_tolerance = "unknown class";
        known_general_tolerances(list: &str) = "the classes: {list}";
        nought_is_exact = "it applies to both sides; 0 is exact";
        frame_has_no_tolerance(name: &str) =
            "link {name} is the frame, and has no tolerance of its own";
        is_of_the_frame = "of the frame";
        give_ground_points_tolerances = "set the tolerances of its ground points in [tolerances]";
        guide_has_no_tolerance(of: &str) =
            "{of} runs through a named point: it has no coordinates that could deviate";
        nothing_to_be_off = "nothing can deviate";
        give_point_of_guide_tolerance = "set the tolerance of that point in [tolerances]";
        point_has_no_coordinates(what: &str) =
            "{what}: only links end there, and it has no coordinates of its own";
        give_link_a_tolerance = "give the link whose length ends there a `tolerance`";
        tolerance_beyond_length(what: &str, length: f64, literal: &str) =
            "the tolerance of {what} must be less than the length, {length}, but is {literal}";
        no_deviation_of_size(class: &str, what: &str, size: f64, sizes: &str) =
            "{class} has no value for {what}, {size} mm: it covers {sizes} mm";
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
        whole_has_no_place = "values of the whole motion have no coordinate: remove --at, --from, --to and --step";
        beside_whole_say_where(name: &str) =
            "{name} is listed with values of the whole motion: give its coordinate with --at, or as {name}@60";
    }
}
