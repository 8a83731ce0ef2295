//! Why a mechanism cannot be solved, and what would mend it.

use super::{English, counted};

catalogue! {
    /// Faults of a mechanism, in the words of its scene.
    trait FaultsWords for English {
        // What parts are called.
        a_link(name: &str) = "link {name}";
        slide_named(name: &str) = "slide `{name}`";
        the_driver = "the driver";
        origin_of(link: &str) = "the origin of {link}";
        either(places: &[String]) = { places.join(" or ") };
        together(parts: &[String]) = { parts.join(" and ") };

        // Mobility.
        mobility_of_none(inputs: usize) = "the mobility is 0, not {inputs}: nothing can move";
        mobility_of_few(mobility: usize, inputs: usize) =
            "the mobility is {mobility}, not {inputs}: there are more inputs than can move";
        mobility_elsewhere(inputs: usize) =
            "the mobility is {inputs}, but the driver is held, and other links move without it";
        mobility_of_many(mobility: usize, inputs: usize) =
            "the mobility is {mobility}, not {inputs}: the driver does not determine every link";
        driven_here = "driven here";
        floats(link: &str) = "{link} floats";
        links_that_float(links: &str) = "links that float: {links}";
        constraints_repeat(count: usize) = {
            counted(
                count,
                "constraint repeats others and holds nothing",
                "constraints repeat others and hold nothing",
            )
        };
        among(what: &str, parts: &str) = "{what}, among {parts}";
        mobility_unclear =
            "this cannot be told for certain: dimensions that differ by rounding alone would hold \
             what seems free";
        take_out_a_part = "take out a link or a joint: one that holds what should move";
        named_nowhere_else = "named nowhere else";
        is_this_the_same = "is this the same?";
        give_it_one_name(point: &str, other: &str) =
            "if {point} and {other} are the same point, give it one name";
        turn_a_guide = "guides that are parallel hold nothing along them: turn one by its `angle`";
        constraints_missing(count: usize) = {
            let missing = counted(count, "constraint is", "constraints are");
            format!(
                "{missing} missing: join a floating link to another by a common point, or add a slide"
            )
        };
        or_further_inputs(more: usize) =
            "or let {more} of them be driven too, at a ratio of the driver: `[inputs]`, `NAME = {{ ratio = 1 }}`";
        are_dimensions_equal =
            "what repeats others may be what is missing elsewhere: are its dimensions meant to be \
             equal?";

        // Constraints that do not fit.
        over_constrained(part: &str, misfit: &str) =
            "over-constrained: with {part} nothing can move, it does not fit the others by {misfit}";
        holds_what_is_held = "holds what others hold already, but not equally";
        found_at(coordinate: &str) = "found with the driver at {coordinate}";
        the_others_are(parts: &str) = "the others are {parts}";
        correct_its_dimensions =
            "correct its dimensions so that they agree with the others, or take it out";
        accept_few_digits(lines: &str) = "or accept what a drawing of few digits leaves:\n{lines}";
        frame_does_not_fit(link: &str, misfit: &str, tail: &str, head: &str) =
            "over-constrained: link {link} does not fit by {misfit} between the ground points \
             `{tail}` and `{head}`";
        cannot_move = "cannot move";
        are_apart(tail: &str, head: &str, distance: &str) = "`{tail}` and `{head}` are {distance} apart";
        frame_needs_no_link(vector: &str) =
            "or without it: the frame needs no link; to see it in the tables, move it to [vectors]: {vector}";
        frame_fits_with(length: &str) = "it fits with `length = {length}`";

        // No assembly, or no one in particular.
        cannot_close(point: &str, gap: &str) =
            "the linkage cannot close at the start: {point} is out of reach by {gap}";
        cannot_be_placed(point: &str) = "{point} cannot be placed";
        has_to_reach_it(link: &str) = "{link} has to reach it";
        has_to_meet_it(link: &str) = "{link} has to meet it";
        driver_stands_at(coordinate: &str) = "the driver stands at {coordinate}";
        change_a_length =
            "change a length or a ground point by that much, or open the scene at another position \
             of the driver";
        start_is_vague(point: &str, places: &str, unit: &str) =
            "the start does not say which assembly is meant: {point} can be at {places} {unit}";
        where_is(point: &str) = "where is {point}?";
        start_is_between(point: &str, place: &str) =
            "[start] has {point} at {place}, which is as near to one as to the other";
        give_one_position(lines: &[String]) = {
            format!("give a rough position, one of:\n[start]\n{}", lines.join("   # or\n"))
        };
        open_as_well(points: &[String]) = { format!("; open as well: {}", points.join(", ")) };
        one_of_lines(lines: &[String]) = { lines.join("   # or ") };
        give_a_position_each(lines: &str) =
            "give a rough position of each; what stands first goes with what stands first above it:\n\
             [start]\n{lines}";
        opens_at_change_point(group: &str) =
            "the scene opens at a change point, where the two assemblies of {group} meet and both \
             lead on";
        which_way = "which way does it go on?";
        choose_the_side(one: &str, other: &str) = "choose the side beyond it by {one} or {other}";
        open_at_another(coordinate: &str) =
            "or open the scene elsewhere, at another `{coordinate}` of the driver";
        opens_beyond_stop(limit: &str, value: &str, low: &str, high: &str) =
            "the scene opens beyond a stop: {limit} is at {value}, and must stay between {low} and {high}";
        opens_beyond_table(table: &str, value: &str, low: &str, high: &str) =
            "the scene opens where the table of {table} says nothing: the driver is at {value}, and the table goes from {low} to {high}";
        not_in_the_table = "the driver is outside this table";
        open_within_table(coordinate: &str) =
            "let the driver's `{coordinate}` lie in the table, or let the table go so far";
        held_by_stops(one: &str, other: &str) =
            "the scene opens at two stops, and nothing can move: those of {one} and {other}";
        no_way_down = "the driver cannot go back";
        no_way_up = "the driver cannot go on";
        is_passed_at_opening = "passed where the scene opens";
        open_between_stops(coordinate: &str) =
            "open the scene at another `{coordinate}` of the driver, choose another assembly, or move the stop";
        names_no_choice(group: &str) =
            "{group} names no group that could be assembled in another way";
        has_one_assembly(group: &str) = "{group} has one assembly alone here";
        has_assemblies(group: &str, count: usize) =
            "{group} has {count} assemblies here, numbered from 1 to {count}";
        picked_here = "picked here";
        no_assembly_near(points: &str, gap: &str) =
            "no assembly was found near the start: {points} miss their places by at least {gap}";
        solved_together = "solved together";
        with_this = "with this";
        at_this_position = "at this position of the driver";
        bring_start_nearer =
            "bring the positions in [start] nearer to an assembly, or check the lengths";
        give_positions(lines: &str) = "give rough positions, or check the lengths:\n[start]\n{lines}";

        // Singular places.
        opens_singular(parts: &str) =
            "the scene opens where {parts} determine no position: at a change point or a dead point";
        never_determine(parts: &str) =
            "{parts} never determine a position, wherever the driver stands";
        leave_a_motion_free = "these together leave a motion free";
        open_elsewhere_in_motion =
            "open the scene elsewhere, at another `angle` or `position` of the driver";
        join_in_another_way = "no dimension mends this: join these parts in another way";

        // What stands before each part of a message.
        level_error = "error";
        level_warning = "warning";
        level_note = "note";
        level_help = "help";
    }
}
