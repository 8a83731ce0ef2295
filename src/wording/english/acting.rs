//! What a scene says of loads, springs, the motor and repeated constraints, where it cannot be so.

use super::English;

catalogue! {
    /// Faults of what acts on the parts of a scene.
    trait ActingWords for English {
        // What they are called.
        the_load = "the load";
        the_spring = "the spring";
        the_motor = "the motor";
        a_load = "a load";
        a_spring = "a spring";
        figure_called(name: &str) = "figure {name}";
        scene_too_large(most: usize) =
            "the file is too large: a scene may have at most {most} bytes (1 MiB)";

        example_of_list(list: &str, one: &str, other: &str) = "{list} with {one} and {other}";

        // Loads.
        must_be_list_of_tables(key: &str) = "`{key}` must be a list of tables";
        load_has_both(one: &str, other: &str) = "the load has both a `{one}` and a `{other}`";
        one_load = "one load";
        a_second_load = "a second load";
        each_a_load_of_its_own = "give each a [[loads]] of its own";
        load_has_no_target(size: &str, on: &str) = "the load has a `{size}` but no `{on}`";
        acts_on_what(size: &str) = "what does the {size} act on?";
        kinds_of_loads =
            "a load is a force at a point, a torque on a link, or a press on a slide";
        over_without_size = "the load has an `over` but neither a `force` nor a `torque`";
        factors_of_what = "factors of what?";
        over_scales =
            "`over` scales a force or a torque: give its size, and 1 where it acts in full";
        load_has_no_size = "the load has neither a `force`, nor a `torque`, nor a `press`";
        no_load_here = "nothing acts here";
        kind_has_no_key(kind: &str, key: &str) = "the load: a {kind} has no `{key}`";
        not_for_kind(kind: &str) = "not for a {kind}";
        no_frame_to_turn_with =
            "a torque and a press have no direction that could turn with a link";
        press_is_given_over_way =
            "what a press does is given over its way: press = [[12, 0], [0, 350e3]]";
        only_press_has_end = "only a press works at an end of a stroke";
        one_load_acts_on_one =
            "one load acts on one thing: give each a [[loads]] of its own";
        keeps_direction_without_frame = "a force that keeps its direction needs no `frame`";

        // A press.
        least_or_greatest(name: &str) =
            "`end` of the load must be `least` or `greatest`, not {name}";
        is_no_end_of_stroke = "no end of a stroke";
        which_ends_there_are =
            "the press works where the position along the guide is least, or greatest";
        press_on_moving_guide(slide: &str, link: &str) =
            "the press on slide {slide}: its guide is on the moving link {link}";
        press_acts_on_this = "the press acts on this";
        press_needs_the_frame =
            "a press works against the frame: name a slide with on = \"ground\"";
        springs_act_between =
            "what acts between two links is a spring: [[springs]]";
        press_without_end(slide: &str) =
            "the press on slide {slide} has no `end`, and the guide is horizontal";
        at_which_end = "at which end does it work?";
        no_lower_end = "neither end of this guide is the lower one";
        least_is_where =
            "end = \"least\" is where the position along the guide is least, counted from `through`";
        greatest_is_where = "end = \"greatest\" is where it is greatest";

        // Knots.
        coordinate_and_factor = "[coordinate, factor]";
        distance_and_force = "[distance, force]";
        knot_in(number: usize, what: &str) = "knot {number} in {what}";
        a_list_of_knots(form: &str) = "a list of knots {form}";
        must_be_but_is_empty(what: &str, wanted: &str) = "{what} must be {wanted}, but is empty";
        no_knots = "no knots";
        factor_never_changes(what: &str) = "{what} has one knot: the factor never changes";
        two_knots_are_needed = "at least two knots are needed";
        put_factor_into_size = "put a constant factor into the force or the torque itself";
        negative_distance(what: &str, literal: &str) =
            "{what}: a distance must not be negative, but is {literal}";
        distances_from_end =
            "distances are counted from the end of the stroke: 0 is the end itself";
        negative_press(what: &str, literal: &str) =
            "{what}: a force must not be negative, but is {literal}";
        press_is_against_motion =
            "the force of a press is against its motion; what helps it is a `force`";
        knots_must_grow(what: &str, first: &str, second: &str) =
            "{what}: the coordinates must grow from knot to knot, but {second} follows {first}";
        does_not_grow = "does not grow";
        order_growing_knots =
            "put the knots in order; a jump is two knots at one coordinate";
        knots_must_fall(what: &str, first: &str, second: &str) =
            "{what}: the coordinates must fall from knot to knot, but {second} follows {first}";
        does_not_fall = "does not fall";
        order_falling_knots =
            "put the knots in order; a jump is two knots at one coordinate";
        the_knot_before = "the knot before";
        three_knots_at_one_place(what: &str, at: &str) = "{what}: three knots lie at {at}";
        a_third_knot_there = "a third knot there";
        a_jump_has_two_knots =
            "a jump has two knots: the value before it, and the value from there on";
        length_and_force = "[length, force]";
        negative_length(what: &str, literal: &str) =
            "{what}: a length must not be negative, but is {literal}";
        lengths_of_gas_spring =
            "the force of a gas spring is given over the distance of its ends: force = [[200, 900], [300, 700]]";

        // Springs.
        spring_lacks_end(key: &str) = "the spring has no `{key}`";
        springs_have_two_ends = "a spring acts between two points";
        spring_has_no_size = "the spring has neither a `stiffness` nor a `damping`";
        does_nothing = "it does nothing";
        give_spring_a_size =
            "give it one: stiffness = 1200 is in N/m, damping = 5 in N s/m";
        give_torsion_spring_a_size =
            "give it one: stiffness = 12 is in N m/rad, damping = 0.5 in N m s/rad";
        spring_kind_has_no_key(kind: &str, key: &str) = "the spring: a {kind} has no `{key}`";
        a_plain_spring = "spring between points";
        a_gas_spring = "gas spring";
        a_torsion_spring = "torsion spring";
        rule_of_springs =
            "a spring pulls with preload + stiffness * (distance - length) + damping * rate";
        rule_of_gas_springs =
            "a gas spring pushes with the `force` that is given over its length; `damping` is all that may be added";
        rule_of_torsion_springs =
            "a torsion spring turns `link` against `to`, or against the ground: stiffness, angle, preload, damping";
        name_two_links = "name two different links";
        spring_to_itself(from: &str) = "the spring runs from {from} to itself";
        end_is_beginning = "its end is its beginning";
        begins_here = "begins here";
        name_two_points = "name two different points";
        spring_on_one_body(body: &str) = "the spring has both its ends on {body}";
        length_never_changes = "its length never changes";
        springs_join_bodies =
            "a spring acts between points of two bodies that move against each other";

        // The motor.
        motor_of_slide_has_no(key: &str) = "the motor has no `{key}` where a slide is driven";
        motor_of_link_has_no(key: &str) = "the motor has no `{key}` where a link is driven";
        does_not_fit_driver = "does not fit the driver";
        slide_has_force = "a slide is driven by a force: force = 2000 (N)";
        link_has_torque = "a link is driven by a torque: torque = 20 (N m)";
        slide_has_no_shaft = "a slide is driven without a shaft: leave it out";
        leave_unknown_out(key: &str) =
            "leave `{key}` out where it is not known; what the motor gives has no sign";
        rest_of_motor_given_twice = "the motor has `rest`, and `tolerance` as well, which is its old name";
        is_old_name_of_rest = "the old name of `rest`";
        leave_old_name_of_rest_out = "leave `tolerance` out";
        peak_of_motor_too_small(rated: &str) = "`peak` of the motor is less than its `{rated}`";
        is_too_small = "too small";
        peak_is_for_short =
            "the peak is what it gives for a short while, at least as much as without end";
        fluctuation_of_motor_too_large = "`fluctuation` of the motor must be at most 1";
        fluctuation_of_motor_impossible =
            "`fluctuation` of the motor is impossible above 2: there the driver stands still once a cycle";
        what_fluctuation_is = "it is (greatest - least) / mean of the speed: 0.02 is 2 %";
        speed_of_motor_not_positive = "`speed` of the motor must be positive";

        // Constraints that repeat others.
        misfit_too_large(unit: &str, most: f64, literal: &str) =
            "`misfit` of [redundant] ({unit}) must be at most a hundredth of the longest length, \
             {most} here, not {literal}";
        misfit_is_for_digits =
            "it is for the digits that a drawing leaves out, not for parts that do not fit";
    }
}
