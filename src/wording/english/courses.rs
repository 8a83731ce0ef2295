//! The driver's motion over time.

use super::English;

catalogue! {
    /// What is wrong with a motion over time, and what is said of one.
    trait CoursesWords for English {
        a_list_of_steps = "a list of steps";
        no_steps = "no steps";
        step_of_motion(number: usize) = "step {number} of the motion";
        motion_does_not_close(start: f64, end: f64) =
            "the motion begins at {start} and ends at {end}: it cannot begin anew there";
        ends_elsewhere = "ends elsewhere than it begins";
        motion_of_link_closes =
            "let its last step end at the driver's `angle`, or whole turns from there: it repeats";
        motion_of_slide_closes = "let its last step end at the driver's `position`: it repeats";
        step_leaves_range(number: usize, to: f64, low: f64, high: f64) =
            "step {number} of the motion goes to {to}, and the driver stops at {low} and {high}";
        beyond_a_stop = "beyond a stop";
        the_stops = "the stops";
        step_has_one_of(of: &str, one: &str, other: &str) =
            "{of} must have either a `{one}` or a `{other}`";
        how_does_it_move = "how does it move?";
        no_law_of_motion(of: &str, name: &str) = "{of}: {name} is no law of motion";
        unknown_law = "unknown law";
        known_laws(list: &str) = "known laws: {list}";
        step_has_no_key(of: &str, key: &str) = "{of}: this kind of step has no `{key}`";
        not_for_this_step = "not for this step";
        keys_of_step(list: &str) = "it has {list}";
        at_most_a_half = "above 0 and at most 0.5";
        time_and_coordinate = "[time, coordinate]";
        times_must_grow(what: &str, first: &str, second: &str) =
            "{what}: the times must grow from knot to knot, but {second} follows {first}";
        driver_and_input = "[driver's coordinate, own coordinate]";
        places_must_grow(what: &str, first: &str, second: &str) =
            "{what}: the driver's coordinates must grow from knot to knot, but {second} follows {first}";
        table_beside(of: &str, key: &str) = "{of} has a table `over` and `{key}`";
        says_the_same_otherwise = "says otherwise how it follows";
        the_table = "the table";
        table_does_not_close(of: &str, first: f64, last: f64) =
            "{of}: the table spans whole turns of the driver, but begins at {first} and ends at {last}: the next turn cannot go on from there";
        table_of_link_closes = "let the last value be the first, or whole turns from it: the table repeats";
        table_of_slide_closes = "let the last value be the first: the table repeats";
        or_table_is_shorter = "or let it end where the motion ends, or give the driver a `range`";
        table_of_one_knot(what: &str) = "{what} has one knot: nothing moves";
        table_begins_elsewhere(of: &str, literal: &str) =
            "{of}: the first knot must be {literal}, where the step before it ends";
        the_first_knot_is(literal: &str) = "must begin with {literal}";
        table_goes_on = "times count from the step's beginning, coordinates are the driver's own";
        motion_beside(key: &str) = "the driver has a `motion` and a `{key}`";
        the_motion_says = "the motion says that already";
        leave_out_beside_motion(key: &str) =
            "leave `{key}` out; a constant speed is a step: {{ law = \"constant\", to = 360, time = 2 }}";

        // Figures over time.
        moment_of_motion = "The time in s from where the scene opens: the driver is where its motion over time has it, \
             as fast and as much accelerated";
        rows_over_time = "Rows over time: --from, --to and --step are in s from where the scene opens, and the \
             driver moves as the scene says";
        rates_by_coordinate(unit: &str) =
            "rates are those of a driver at 1 {unit}; those of its motion over time: --time";

        // The motor.
        over_a_period(seconds: &str) = "over a period of {seconds} s of the motion over time";
        at_a_time(value: &str, seconds: &str, place: &str) = "{value} at {seconds} s, {place}";
        part_between(least: &str, most: &str, rms: &str) = "{least} to {most}, RMS {rms}";
        only_at_one_speed(option: &str) =
            "`{option}` belongs to a cycle at one speed; this scene has a motion over time";
        motion_passes_stop(at: &str, unit: &str, time: &str, name: &str) =
            "the motion over time goes on past the stop of {name}: {at} {unit}, at {time} s";
        motion_passes_table(at: &str, unit: &str, time: &str, name: &str) =
            "the motion over time goes on past the end of the table of {name}: {at} {unit}, at {time} s";
        motion_passes_end(at: &str, unit: &str, time: &str) =
            "the motion over time goes on past {at} {unit}, at {time} s, where the mechanism cannot go on";
        no_torque_on_the_way(at: f64, unit: &str) =
            "the motion over time leads to {at} {unit}, where the mechanism cannot be or stands at a dead point";
    }
}
