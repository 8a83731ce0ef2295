//! Errors in single parts of a scene: links, slides, points, vectors.

use super::English;
use std::fmt::LowerExp;

catalogue! {
    /// Errors in single parts of a scene.
    trait PartsWords for English {
        // Names of parts.
        link_called(name: &str) = "link {name}";
        slide_called(name: &str) = "slide {name}";
        vector_called(name: &str) = "vector {name}";
        the_ground_as_body = "the ground";
        point_in(of: &str) = "{of}: point";
        ground_point = "ground point";
        mark = "mark";
        start_of = "start of";
        tail_of(what: &str) = "the tail of {what}";
        head_of(what: &str) = "the head of {what}";
        the_scene_itself = "the scene";
        body_called(name: &str) = "{name}";
        condition_called(word: &str) = "{word}";
        translated_scene_text(text: &str) = "{text}";
        add_for_example(text: &str) = "add, for example:\n{text}";

        // The scene.
        no_unit_of_length(name: &str) = "{name} is not a unit of length";
        unknown_unit = "unknown unit";
        known_units(names: &str) = "known units: {names}";
        no_links = "the scene has no links: nothing moves";
        links_above_most(count: usize, most: usize) =
            "the scene has {count} links; at most {most} are allowed";
        are_too_many_links = "too many links";
        no_driver = "the scene has no driver: nothing turns";
        none_is_driven = "none of these is driven";

        // Links.
        link_has_no_points(of: &str) = "{of} has no points";
        needs_ends_or_points = "a link needs two ends, or `points`";
        or_single_joint(example: &str) = "or, for a link with a single joint: {example}";
        of_has(of: &str, what: &str) = "{of} has {what}";
        ends_without_length = "`from` and `to` but no `length`";
        only_from = "`from` but no `to`";
        only_to = "`to` but no `from`";
        length_without_ends = "a `length` but no `from` and `to`";
        ends_and_length = "`from`, `to` and `length` belong together";
        points_alone(example: &str) =
            "a link without two natural ends is given by `points` alone: {example}";
        at_least_smallest = "at least 1e-300";
        too_small_to_compute = "too small to compute with";
        positive = "positive";
        no_direction = "a link without length has no direction";
        give_joints_one_name = "two joints at one place need no link between them: give them one name";
        is_not_positive = "not positive";
        length_is_distance =
            "a length is a distance; the direction of a link is from `from` to `to`";
        no_place_of_its_own = "a point at distance 0 coincides with its reference point";
        leave_point_out = "remove it and use its reference point; at the origin of the link, write [0, 0]";
        turn_angle_by_half = "a length is a distance: write it without the sign, and turn the angle by 180";
        pinned_to_itself(link: &str, point: &str) =
            "link {link} is pinned to itself: {point} is both its ends";
        joins_two_points = "a link joins two different points";
        names_point_twice(link: &str, point: &str) = "link {link} names the point {point} twice";
        ends_are_points = "its ends are [0, 0] and [length, 0] already; `points` are further points";
        again_here = "again here";
        once_here = "once here";
        out_of_proportion(link: &str, length: &dyn LowerExp, longest: &dyn LowerExp) =
            "link {link} is out of proportion: {length:e} long, while the longest length of the scene is \
             {longest:e}";
        less_than_part = "less than 1e-75 of the longest";
        look_for_mistyped = "products of both do not fit a double; look for a mistyped coordinate, `com` or length";
        mass_without_centre(link: &str) = "link {link} has a mass but no centre of mass";
        inertia_without_centre(link: &str) = "link {link} has an inertia but no centre of mass";
        about_which_point = "about which point?";
        give_centre_at_middle(x: f64) =
            "give the centre in the link's frame; at mid-length: com = [{x}, 0]";
        give_centre = "give the centre in the link's frame: com = [20, 10], for example";

        // Places by length and angle.
        or_by_length_and_angle(example: &str) = "or by length and angle: {example}";
        seen_from_itself(what: &str) = "{what} is measured from itself";
        seen_in_a_circle = "leads back to it";
        begin_with_an_end =
            "begin with an end of the link, or with a point that has coordinates: from = \"A\"";
        name_another_point_of(body: &str) =
            "name another point of {body}, or leave `from` out: the origin of its frame";

        or_by_two_distances(example: &str) = "or by two distances: {example}";
        a_pair_of_names = "[first, second] of points";
        a_pair_of_distances = "[first, second] of distances";
        left_or_right = "`left` or `right`";
        which_side_is_left = "seen from the first point of `from` to the second; without `side` it is the left one";
        distances_do_not_meet(what: &str, apart: &str) =
            "{what}: the two distances do not meet: their points are {apart} apart";
        no_such_triangle = "no triangle has these sides";
        sides_of_a_triangle = "each side of a triangle is at most the sum of the other two; look for a mistyped length";

        // Links as drawn.
        drawn_link_has_key(of: &str, key: &str) =
            "{of}: `{key}` does not apply to a link with a list of `points`";
        drawn_driver_has_angle(link: &str) = "[driver]: `angle` does not apply to {link}, a link as drawn";
        drawing_has_angle = "the coordinates of its points determine the angle";
        open_as_drawn = "remove it; change the coordinates, or use `--at` for another position";
        ends_are_first_two = "the first two points of the list are its ends";
        further_points_are_a_table(example: &str) =
            "remove it, or write further points as a table: {example}";
        drawn_link_needs_two(of: &str) = "{of}: a list of `points` needs at least two";
        drawn_point_has_no_place(of: &str, name: &str) = "{of}: point {name} has no coordinates";
        neither_ground_nor_start = "neither in [ground] nor in [start]";
        add_drawn_place(name: &str) =
            "the list takes the link's shape from these: add {name} = [x, y], as drawn, to [start]";
        drawn_at_one_place(of: &str, from: &str, to: &str) = "{of}: {from} and {to} have the same coordinates";
        begin_with_two_places = "begin the list with two points at different places";
        name_each_point_once = "name each point once";

        // Copies.
        copy_called(name: &str) = "copy {name}";
        a_list_of_elements = "a list of links, slides or points";
        copy_of_nothing(of: &str) = "{of}: the list `of` is empty";
        no_element_called(what: &str, name: &str) = "{what}: there is no link, slide or point {name}";
        no_such_element = "no such element";
        whole_number_up_to(most: usize) = "a whole number from 1 to {most}";
        x_or_y = "`x` or `y`";
        mirrors_at_axis = "`x` mirrors at the x axis, so that y changes its sign, and `y` at the y axis";
        turn_the_mirror_image = "for another axis, add `turn`: twice the angle between the axes";
        a_ground_point_or_pair = "a ground point or `[x, y]`";
        about_nothing(of: &str) = "{of}: `about` needs `mirror` or `turn`";
        neither_turns_nor_mirrors = "nothing is mirrored or turned";
        copy_in_place(of: &str) = "{of} lies on the original";
        is_where_original_is = "the same place";
        place_the_copy = "give it `mirror`, `turn`, `move`, `phase` or `join`";
        joins_no_point(of: &str, name: &str) = "{of}: `join` replaces {name}, which is no point of the group";
        not_in_the_group = "not a point of the group";
        phase_turns_nothing(of: &str) = "{of}: `phase` has no effect";
        no_point_on_another_link = "no other link has a point of the group";
        phase_is_for_cranks =
            "`phase` turns the points of the group that are also on other links, such as a crank; \
             `turn` turns the whole copy";
        phase_at_origin(of: &str, point: &str) = "{of}: `phase` cannot turn {point}";
        turns_about_the_origin = "it is the origin of its other link";
        begin_crank_at_pivot = "let that link begin at its pivot: from = \"A\"";
        name_of_copy_is_taken(of: &str, original: &str, name: &str) =
            "{of}: the copy of {original} would be {name}, a name in use";
        choose_another_suffix = "choose another key in [copies]: its copies are named after it";
        too_many_copies(of: &str, most: usize) = "{of}: more than {most} copies in all";
        too_many_copied(of: &str, most: usize) = "{of}: more than {most} copied elements in all";
        copy_is_too_far(of: &str) = "{of} has coordinates that are too large to compute with";

        // Slides.
        of_has_no(of: &str, key: &str) = "{of} has no `{key}`";
        is_missing(key: &str) = "`{key}` is missing";
        pin_or_link =
            "a pin in a slot has `point = \"C\"`, a link that slides without turning `link = \"r6\"`";
        pin_has_no_turn(of: &str) = "{of}: a pin in a slot has no `turn`";
        for_slide_of_link = "only for a slide of a link";
        slide_the_link =
            "a pin may turn in its slot; to keep a link from turning, slide the link: link = \"...\"";
        has_point_and_link(of: &str) = "{of} has both `point` and `link`";
        one_of_them_slides = "one of them slides";
        has_no_point_nor_link(of: &str) = "{of} has neither `point` nor `link`";
        nothing_slides_here = "nothing slides here";
        guide_in_the_frame = "a guide in the frame is on = \"ground\"";
        must_be_point_of(what: &str, body: &str, name: &str) =
            "{what} must be a point of {body}; {name} is not";
        no_point_of(body: &str) = "not a point of {body}";
        name_point_of(body: &str) =
            "name a point of {body}, or give coordinates in its frame: through = [0, 0]";
        cannot_slide_on_itself(body: &str) = "{body} cannot slide on itself";
        origin_is_fixed(link: &str, body: &str) =
            "link {link} cannot slide on {body}: its origin is fixed there";
        carried_by(point: &str, body: &str) = "{point} cannot slide on {body}, which carries it";
        nothing_slides_on(body: &str) = "nothing slides on {body}";
        this_slides = "this slides";
        guide_is_fixed_to = "the guide is fixed to this";
        guide_and_slider_differ = "a guide and what slides along it belong to different bodies";

        // Driven parts.
        driven_link_is_given = "a driven link is given by `link` and `angle`";
        driven_slide_is_given = "a driven slide is given by `slide` and `position`";
        pinned_to_ground_twice(name: &str) =
            "the driven link {name} cannot turn: it is pinned to the ground twice";
        the_driven_link = "the driven link";
        one_pin = "one pin";
        another_pin = "another";
        turns_about_one_point = "the driven link, mostly the crank, turns about one point of the ground";
        slide_has_its_guide(of: &str) = "{of}: a slide is driven along its guide, so `from` does not apply";
        not_of_a_slide = "only for a driven link";
        seat_is_for_links =
            "remove it, or name a link instead of the slide: `from` is the link that carries the motor";
        turns_from_itself(name: &str) = "{name} cannot be driven relative to itself";
        seat_is_another_link =
            "`from` names another link, which carries the motor; without it the link is driven relative to the \
             ground";
        no_pivot(name: &str) = "the driven link {name} has no ground point to turn about";
        not_joined_to_ground = "not joined to the ground";
        none_in_ground = "none of its points is in [ground]";
        put_into_ground = "put one of its points into [ground]: A = [0, 0]";
        or_name_its_seat(link: &str) = "or name the link that carries its motor: from = \"{link}\"";
        links_with_ground_point(names: &str) = "links with a ground point: {names}";

        input_called(name: &str) = "input {name}";
        input_is_the_driver(name: &str) = "input {name}: the driver drives {name} already";
        driven_again = "driven again";
        the_driver_itself = "the driver";
        inputs_follow_the_driver = "list the other driven links and slides in [inputs]; each follows the driver";

        // Stops.
        limit_called(name: &str) = "limit {name}";
        low_end_of(what: &str) = "the lower end of {what}";
        high_end_of(what: &str) = "the upper end of {what}";
        ends_must_rise(what: &str, literal: &str) =
            "{what} must have its lower end first, not {literal}";
        lower_end_first = "[low, high]";
        nothing_moves_between = "nothing can move between two equal ends";
        ends_the_other_way(ends: &str) = "write {ends}";
        or_angle_of_link(example: &str) = "the angle of a link relative to another: {example}";
        limit_of_nothing(name: &str) = "limit {name}: there is no link or slide of this name";
        neither_link_nor_slide = "neither a link nor a slide";
        angle_to_itself(what: &str, link: &str) = "{what}: {link} is measured from itself";
        always_zero = "always 0 deg";
        limit_of_a_turn(what: &str) = "{what}: the ends of an angle must be less than 360 deg apart";
        is_too_wide = "too wide";
        driver_has_range =
            "remove the limit of what may turn further; a driver may have a `range` of several turns";
        range_of_too_many_turns(what: &str, most: f64) = "{what} must be less than {most} deg wide";
        leave_range_out = "remove `range`: a driver that turns freely needs none";

        // Points and vectors.
        start_of_ground_point(name: &str) = "[start]: {name} is a point of the ground";
        does_not_move = "does not move";
        fixed_here = "fixed here";
        start_is_for_moving = "[start] is for moving points: remove the line";
        runs_to_itself(what: &str, from: &str) = "{what} runs from {from} to itself";
        head_is_tail = "its head is its tail";
        name_tail_and_head = "name two different points: [tail, head]";
        a_pair_of_points = "[tail, head] of points";
        a_list_of_points = "a list of points";
        has_no_centre(what: &str, link: &str) = "{what}: link {link} has no centre of mass";
        no_such_point = "no such point";
        has_no_com = "has no `com`";
        give_the_link_one = "give the link one, in its own frame: com = [50, 0]";
        was_moving_meant(near: &str, name: &str) = "`{near}` is a moving point; did you mean {name}?";
        take_out_or_use = "remove it, or let a link begin or end there";
        belongs_to_nothing(name: &str) = "ground point {name} is not used";
        nothing_names_it = "no link, slide or vector names it";
    }
}
