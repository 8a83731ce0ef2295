//! The driver's motion over time.

use super::English;

catalogue! {
    /// Errors and descriptions of a motion over time.
    trait CoursesWords for English {
        a_list_of_steps = "a list of steps";
        no_steps = "no steps";
        step_of_motion(number: usize) = "step {number} of the motion";
        motion_does_not_close(start: f64, end: f64) =
            "the motion starts at {start} and ends at {end}, so it cannot repeat";
        ends_elsewhere = "does not end where it starts";
        motion_of_link_closes =
            "end the last step at the driver's `angle`, or whole turns from it, so that the motion repeats";
        motion_of_slide_closes = "end the last step at the driver's `position`, so that the motion repeats";
        step_leaves_range(number: usize, to: f64, low: f64, high: f64) =
            "step {number} of the motion ends at {to}, but the stops of the driver are at {low} and {high}";
        beyond_a_stop = "beyond a stop";
        the_stops = "the stops";
        step_has_one_of(of: &str, one: &str, other: &str) =
            "{of} must have exactly one of `{one}` and `{other}`";
        how_does_it_move = "the law of motion is missing";
        no_law_of_motion(of: &str, name: &str) = "{of}: {name} is not a law of motion";
        unknown_law = "unknown law";
        known_laws(list: &str) = "known laws: {list}";
        step_has_no_key(of: &str, key: &str) = "{of}: this kind of step cannot have `{key}`";
        not_for_this_step = "not valid for this step";
        keys_of_step(list: &str) = "its keys: {list}";
        at_most_a_half = "above 0 and at most 0.5";
        time_and_coordinate = "[time, coordinate]";
        times_must_grow(what: &str, first: &str, second: &str) =
            "{what}: the times must increase from knot to knot, but {second} follows {first}";
        driver_and_input = "[driver's coordinate, own coordinate]";
        places_must_grow(what: &str, first: &str, second: &str) =
            "{what}: the driver's coordinates must increase from knot to knot, but {second} follows {first}";
        input_has_two_laws(of: &str, one: &str, other: &str) = "{of} has both `{one}` and `{other}`: keep one of them";
        says_the_same_otherwise = "a second rule for the same input";
        one_law = "the first rule";
        table_does_not_close(of: &str, first: f64, last: f64) =
            "{of}: the table covers whole turns of the driver, but starts at {first} and ends at {last}, so it \
             cannot repeat";
        table_of_link_closes =
            "make the last value equal to the first, or whole turns from it: the table repeats";
        table_of_slide_closes = "make the last value equal to the first: the table repeats";
        or_table_is_shorter = "or end the table where the motion ends, or give the driver a `range`";
        table_of_one_knot(what: &str) = "{what} has only one knot: nothing moves";
        table_begins_elsewhere(of: &str, literal: &str) =
            "{of}: the first knot must be {literal}, the end of the previous step";
        the_first_knot_is(literal: &str) = "must start with {literal}";
        table_goes_on = "times are measured from the start of the step; coordinates are those of the driver";
        motion_beside(key: &str) = "the driver has both `motion` and `{key}`";
        the_motion_says = "`motion` already determines this";
        leave_out_beside_motion(key: &str) =
            "remove `{key}`; write a constant speed as a step: {{ law = \"constant\", to = 360, time = 2 }}";

        // Values over time.
        moment_of_motion =
            "Time in s since the scene opens: position, speed and acceleration of the driver follow from its \
             motion over time";
        rows_over_time =
            "Rows over time: --from, --to and --step are in s since the scene opens, and the driver follows its \
             motion";
        rates_by_coordinate(unit: &str) =
            "rates are for a driver at 1 {unit}; use --time for those of its motion over time";

        // The motor.
        over_a_period(seconds: &str) = "over one period of the motion, {seconds} s";
        at_a_time(value: &str, seconds: &str, place: &str) = "{value} at {seconds} s, {place}";
        part_between(least: &str, most: &str, rms: &str) = "{least} to {most}, RMS {rms}";
        only_at_one_speed(option: &str) =
            "`{option}` needs a cycle at constant speed, but this scene has a motion over time";
        motion_passes_stop(at: &str, unit: &str, time: &str, name: &str) =
            "the motion over time passes the stop of {name}: {at} {unit}, at {time} s";
        motion_passes_table(at: &str, unit: &str, time: &str, name: &str) =
            "the motion over time passes the end of the table of {name}: {at} {unit}, at {time} s";
        motion_passes_end(at: &str, unit: &str, time: &str) =
            "the motion over time passes the end of the range, {at} {unit}, at {time} s";
        no_torque_on_the_way(at: f64, unit: &str) =
            "the motion over time reaches {at} {unit}, where the mechanism cannot be assembled or is at a dead \
             point";
    }
}
