//! Reasons why a mechanism cannot be solved, and fixes.

use super::{English, counted};

catalogue! {
    /// Errors of a mechanism, in terms of its scene.
    trait FaultsWords for English {
        // Names of parts.
        a_link(name: &str) = "link {name}";
        slide_named(name: &str) = "slide `{name}`";
        the_driver = "the driver";
        origin_of(link: &str) = "the origin of {link}";
        either(places: &[String]) = { places.join(" or ") };
        together(parts: &[String]) = { parts.join(" and ") };

        // Mobility.
        mobility_of_none(inputs: usize) = "the mobility is 0, not {inputs}: nothing can move";
        mobility_of_few(mobility: usize, inputs: usize) =
            "the mobility is {mobility}, not {inputs}: there are more inputs than degrees of freedom";
        mobility_elsewhere(inputs: usize) =
            "the mobility is {inputs}, but the driver cannot move, and other links move without it";
        mobility_of_many(mobility: usize, inputs: usize) =
            "the mobility is {mobility}, not {inputs}: the driver does not determine every link";
        driven_here = "driven here";
        floats(link: &str) = "{link} is not fully constrained";
        links_that_float(links: &str) = "links that are not fully constrained: {links}";
        constraints_repeat(count: usize) = {
            counted(
                count,
                "constraint is redundant",
                "constraints are redundant",
            )
        };
        among(what: &str, parts: &str) = "{what}, among {parts}";
        mobility_unclear =
            "this is not certain: a change of the dimensions by rounding alone would constrain what seems free";
        take_out_a_part = "remove a link or a joint that blocks the motion";
        named_nowhere_else = "used only here";
        is_this_the_same = "the same point?";
        give_it_one_name(point: &str, other: &str) =
            "if {point} and {other} are the same point, use one name";
        turn_a_guide = "parallel guides do not constrain motion along them: change the `angle` of one";
        constraints_missing(count: usize) = {
            let missing = counted(count, "constraint is", "constraints are");
            format!(
                "{missing} missing: connect a free link to another by a common point, or add a slide"
            )
        };
        or_further_inputs(more: usize) =
            "or drive {more} more of them at a ratio of the driver: `[inputs]`, `NAME = {{ ratio = 1 }}`";
        are_dimensions_equal =
            "a redundant constraint may be the missing one: check whether its dimensions should be equal";

        // Constraints that do not fit.
        over_constrained(part: &str, misfit: &str) =
            "over-constrained: with {part} nothing can move; it misses the others by {misfit}";
        holds_what_is_held = "repeats other constraints, but with other values";
        found_at(coordinate: &str) = "found with the driver at {coordinate}";
        the_others_are(parts: &str) = "the others are {parts}";
        correct_its_dimensions = "correct its dimensions to agree with the others, or remove it";
        accept_few_digits(lines: &str) =
            "or accept the rounding of the drawing:\n\
             {lines}";
        frame_does_not_fit(link: &str, misfit: &str, tail: &str, head: &str) =
            "over-constrained: link {link} does not fit between the ground points `{tail}` and `{head}`, by \
             {misfit}";
        cannot_move = "cannot move";
        are_apart(tail: &str, head: &str, distance: &str) = "`{tail}` and `{head}` are {distance} apart";
        frame_needs_no_link(vector: &str) =
            "or remove it: the frame needs no link; to show it in the tables, move it to [vectors]: {vector}";
        frame_fits_with(length: &str) = "it fits with `length = {length}`";

        // No assembly, or more than one.
        cannot_close(point: &str, gap: &str) =
            "the mechanism cannot be assembled at the start: {point} is out of reach by {gap}";
        cannot_be_placed(point: &str) = "{point} cannot be placed";
        has_to_reach_it(link: &str) = "{link} must reach it";
        has_to_meet_it(link: &str) = "{link} must meet it";
        driver_stands_at(coordinate: &str) = "the driver is at {coordinate}";
        change_a_length =
            "change a length or a ground point by this amount, or open the scene at another position of the \
             driver";
        start_is_vague(point: &str, places: &str, unit: &str) =
            "the start fits more than one assembly: {point} can be at {places} {unit}";
        where_is(point: &str) = "where is {point}?";
        start_is_between(point: &str, place: &str) = "[start] has {point} at {place}, equally near to both";
        give_one_position(lines: &[String]) = {
            format!("give a rough position, one of:\n[start]\n{}", lines.join("   # or\n"))
        };
        open_as_well(points: &[String]) = { format!("; open as well: {}", points.join(", ")) };
        one_of_lines(lines: &[String]) = { lines.join("   # or ") };
        give_a_position_each(lines: &str) =
            "give a rough position of each; the first choices belong together, and so on:\n\
             [start]\n\
             {lines}";
        opens_at_change_point(group: &str) =
            "the scene opens at a change point: the two assemblies of {group} meet there and both continue";
        which_way = "the continuation is not determined";
        choose_the_side(one: &str, other: &str) = "choose the assembly after it with {one} or {other}";
        open_at_another(coordinate: &str) = "or open the scene at another `{coordinate}` of the driver";
        opens_beyond_stop(limit: &str, value: &str, low: &str, high: &str) =
            "the scene opens beyond a stop: {limit} is {value}, but must be between {low} and {high}";
        opens_beyond_table(table: &str, value: &str, low: &str, high: &str) =
            "the scene opens outside the table of {table}: the driver is at {value}, but the table covers {low} \
             to {high}";
        not_in_the_table = "the driver is outside this table";
        open_within_table(coordinate: &str) =
            "choose a `{coordinate}` of the driver within the table, or extend the table";
        held_by_stops(one: &str, other: &str) =
            "the scene opens at two stops, and nothing can move: the stops of {one} and {other}";
        no_way_down = "the driver cannot go back";
        no_way_up = "the driver cannot go forward";
        is_passed_at_opening = "exceeded where the scene opens";
        open_between_stops(coordinate: &str) =
            "open the scene at another `{coordinate}` of the driver, choose another assembly, or move the stop";
        names_no_choice(group: &str) = "{group} is not a group with a choice of assemblies";
        has_one_assembly(group: &str) = "{group} has only one assembly here";
        has_assemblies(group: &str, count: usize) =
            "{group} has {count} assemblies here: choose a number from 1 to {count}";
        picked_here = "chosen here";
        no_assembly_near(points: &str, gap: &str) =
            "no assembly was found near the start: {points} miss their places by at least {gap}";
        solved_together = "solved together";
        with_this = "with this";
        at_this_position = "at this position of the driver";
        bring_start_nearer = "move the positions in [start] closer to an assembly, or check the lengths";
        give_positions(lines: &str) = "give rough positions, or check the lengths:\n[start]\n{lines}";

        // Singular positions.
        opens_singular(parts: &str) =
            "the scene opens at a change point or a dead point: {parts} do not determine a position there";
        never_determine(parts: &str) = "{parts} do not determine a position, wherever the driver is";
        leave_a_motion_free = "together these allow a free motion";
        open_elsewhere_in_motion = "open the scene at another `angle` or `position` of the driver";
        join_in_another_way = "no dimension can fix this: connect these parts differently";

        // Prefixes of the parts of a message.
        level_error = "error";
        level_warning = "warning";
        level_note = "note";
        level_help = "help";
    }
}
