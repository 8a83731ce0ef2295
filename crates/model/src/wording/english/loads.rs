//! Errors of the loads, springs, motor and redundant constraints of a scene.

use super::English;

catalogue! {
    /// Errors of loads, springs, the motor and redundant constraints.
    trait ActingWords for English {
        // Names.
        the_load = "the load";
        the_spring = "the spring";
        the_motor = "the motor";
        a_load = "a load";
        a_spring = "a spring";
        figure_called(name: &str) = "value {name}";
        scene_too_large(most: usize) =
            "the file is too large: a scene may have at most {most} bytes (1 MiB)";

        example_of_list(list: &str, one: &str, other: &str) = "{list} with {one} and {other}";

        // Loads.
        must_be_list_of_tables(key: &str) = "`{key}` must be a list of tables";
        load_has_both(one: &str, other: &str) = "the load has both a `{one}` and a `{other}`";
        one_load = "one load";
        a_second_load = "a second load";
        each_a_load_of_its_own = "put each into its own [[loads]]";
        load_has_no_target(size: &str, on: &str) = "the load has a `{size}` but no `{on}`";
        acts_on_what(size: &str) = "where is the {size} applied?";
        kinds_of_loads =
            "a load is a force at a point, a torque on a link, or a press on a slide";
        over_without_size = "the load has an `over` but neither a `force` nor a `torque`";
        factors_of_what = "nothing to scale";
        over_scales = "`over` scales a `force` or a `torque`: give its full value there, and factors here";
        load_has_no_size = "the load has neither a `force`, nor a `torque`, nor a `press`";
        no_load_here = "this load is empty";
        kind_has_no_key(kind: &str, key: &str) = "a {kind} cannot have `{key}`";
        not_for_kind(kind: &str) = "not valid for a {kind}";
        no_frame_to_turn_with = "`frame` is valid only for a force: a torque and a press have no direction";
        press_is_given_over_way =
            "a press needs a table of force over distance: press = [[12, 0], [0, 350e3]]";
        only_press_has_end = "`end` is valid only for a press";
        one_load_acts_on_one = "a load has one target: put each target into its own [[loads]]";
        keeps_direction_without_frame = "leave out `frame` for a force of constant direction";

        // A press.
        least_or_greatest(name: &str) =
            "`end` of the load must be `least` or `greatest`, not {name}";
        is_no_end_of_stroke = "not an end of the stroke";
        which_ends_there_are =
            "`least` and `greatest` are the minimum and maximum of the position along the guide";
        press_on_moving_guide(slide: &str, link: &str) =
            "the press acts on slide {slide}, whose guide is on the moving link {link}";
        press_acts_on_this = "the target of the press";
        press_needs_the_frame = "a press acts against the frame: name a slide with on = \"ground\"";
        springs_act_between = "for a force between two links use a spring: [[springs]]";
        press_without_end(slide: &str) =
            "the press on slide {slide} has no `end`, and its guide is horizontal";
        at_which_end = "`end` is missing";
        no_lower_end = "neither end of this guide is lower than the other";
        least_is_where =
            "end = \"least\" is the minimum of the position along the guide, measured from `through`";
        greatest_is_where = "end = \"greatest\" is the maximum";

        // Knots.
        coordinate_and_factor = "[coordinate, factor]";
        distance_and_force = "[distance, force]";
        knot_in(number: usize, what: &str) = "knot {number} in {what}";
        a_list_of_knots(form: &str) = "a list of knots {form}";
        must_be_but_is_empty(what: &str, wanted: &str) = "{what} must be {wanted}, but it is empty";
        no_knots = "no knots";
        factor_never_changes(what: &str) = "{what} has only one knot: the factor never changes";
        two_knots_are_needed = "give at least two knots";
        put_factor_into_size = "multiply the force or the torque by a constant factor directly";
        negative_distance(what: &str, literal: &str) =
            "{what}: a distance must not be negative, but it is {literal}";
        distances_from_end = "distances are measured from the end of the stroke: 0 is the end itself";
        negative_press(what: &str, literal: &str) =
            "{what}: a force must not be negative, but it is {literal}";
        press_is_against_motion =
            "a press always acts against the motion; for a force along the motion use `force`";
        knots_must_grow(what: &str, first: &str, second: &str) =
            "{what}: the coordinates must increase from knot to knot, but {second} follows {first}";
        does_not_grow = "not increasing";
        order_growing_knots = "put the knots in order; write a jump as two knots at one coordinate";
        knots_must_fall(what: &str, first: &str, second: &str) =
            "{what}: the coordinates must decrease from knot to knot, but {second} follows {first}";
        does_not_fall = "not decreasing";
        order_falling_knots = "put the knots in order; write a jump as two knots at one coordinate";
        the_knot_before = "the previous knot";
        three_knots_at_one_place(what: &str, at: &str) = "{what}: three knots have the coordinate {at}";
        a_third_knot_there = "the third knot";
        a_jump_has_two_knots = "give a jump two knots: the value before it and the value after it";
        length_and_force = "[length, force]";
        negative_length(what: &str, literal: &str) =
            "{what}: a length must not be negative, but it is {literal}";
        lengths_of_gas_spring =
            "give the force of a gas spring over its length: force = [[200, 900], [300, 700]]";

        // Springs.
        spring_lacks_end(key: &str) = "the spring has no `{key}`";
        springs_have_two_ends = "a spring acts between two points";
        spring_has_no_size = "the spring has neither a `stiffness` nor a `damping`";
        does_nothing = "no effect";
        give_spring_a_size = "give one of them, such as stiffness = 1200 (N/m) or damping = 5 (N s/m)";
        give_torsion_spring_a_size =
            "give one of them, such as stiffness = 12 (N m/rad) or damping = 0.5 (N m s/rad)";
        spring_kind_has_no_key(kind: &str, key: &str) = "a {kind} cannot have `{key}`";
        a_plain_spring = "spring between points";
        a_gas_spring = "gas spring";
        a_torsion_spring = "torsion spring";
        rule_of_springs =
            "a spring pulls with the force preload + stiffness * (distance - length) + damping * rate";
        rule_of_gas_springs =
            "a gas spring pushes with `force`, given over its length; the only other key is `damping`";
        rule_of_torsion_springs =
            "a torsion spring acts between `link` and `to`, or the ground; keys: stiffness, angle, preload, \
             damping";
        name_two_links = "name two different links";
        spring_to_itself(from: &str) = "both ends of the spring are {from}";
        end_is_beginning = "the same as the start";
        begins_here = "the start";
        name_two_points = "name two different points";
        spring_on_one_body(body: &str) = "both ends of the spring are on {body}";
        length_never_changes = "its length never changes";
        springs_join_bodies = "connect points of two bodies that move relative to each other";

        // The motor.
        motor_of_slide_has_no(key: &str) = "the motor cannot have `{key}`: the driver is a slide";
        motor_of_link_has_no(key: &str) = "the motor cannot have `{key}`: the driver is a link";
        does_not_fit_driver = "does not fit the driver";
        slide_has_force = "give a force for a driven slide: force = 2000 (N)";
        link_has_torque = "give a torque for a driven link: torque = 20 (N m)";
        slide_has_no_shaft = "a driven slide has no shaft: remove this key";
        leave_unknown_out(key: &str) = "give `{key}` without a sign, or remove it if it is unknown";
        rest_of_motor_given_twice = "the motor has both `rest` and `tolerance`, its old name";
        is_old_name_of_rest = "the old name of `rest`";
        leave_old_name_of_rest_out = "remove `tolerance`";
        peak_of_motor_too_small(rated: &str) = "`peak` of the motor is less than its `{rated}`";
        is_too_small = "too small";
        peak_is_for_short = "the peak is allowed for a short time; it is at least the continuous value";
        fluctuation_of_motor_too_large = "`fluctuation` of the motor must be at most 1";
        fluctuation_of_motor_impossible =
            "`fluctuation` of the motor cannot be above 2: at 2 the driver stops once per cycle";
        what_fluctuation_is = "it is (maximum - minimum) / mean of the speed: 0.02 is 2 %";
        speed_of_motor_not_positive = "`speed` of the motor must be positive";

        // Redundant constraints.
        misfit_too_large(unit: &str, most: f64, literal: &str) =
            "`misfit` of [redundant] ({unit}) must be at most 1 % of the longest length, here {most}, but it is \
             {literal}";
        misfit_is_for_digits = "use it for dimensions rounded in a drawing, not for parts that do not fit";
    }
}
